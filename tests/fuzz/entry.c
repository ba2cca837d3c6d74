/* entry.c: the door of libFuzzer to the target FUZZ_TARGET (-DFUZZ_TARGET=fuzz_pattern). */
#ifdef FUZZ_TARGET
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    FUZZ_TARGET(bytes, size);
    return 0;
}
#else
typedef int fuzz_entry_is_empty; /* in the plain build the targets are called by test_fuzz.c */
#endif
