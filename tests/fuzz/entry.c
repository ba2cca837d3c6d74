/*
 * entry.c: the door of libFuzzer to the target FUZZ_TARGET (-DFUZZ_TARGET=fuzz_pattern). An input may take SECONDS_MOST
 * of the processor's time; libFuzzer's own bound counts the clock on the wall, which runs on while other programs have
 * the processor.
 */
#ifdef FUZZ_TARGET
#include <time.h>

#include "fuzz.h"

/* s of CPU time: a person at a command would have given up */
#define SECONDS_MOST 10

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const clock_t start = clock();
    FUZZ_TARGET(bytes, size);
    fuzz_must((clock() - start) / CLOCKS_PER_SEC < SECONDS_MOST, "an input takes less than 10 s");
    return 0;
}
#else
typedef int fuzz_entry_is_empty; /* in the plain build the targets are called by test_fuzz.c */
#endif
