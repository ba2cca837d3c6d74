/* fuzz.c: what the fuzz targets share. */
#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"

#define MOST_BYTES ((size_t)256 << 20) /* of one block; a larger one is refused as if memory were out */


void fuzz_must(bool holds, const char *sentence)
{
    if (holds) return;
    fprintf(stderr, "broken promise: %s\n", sentence);
    abort();
}


static uint32_t passes = UINT32_MAX; /* allocations until one fails */
static bool fails_on;                /* and all after it */


void fuzz_fail_after(uint32_t n, bool forever)
{
    passes = n;
    fails_on = forever;
}


void fuzz_fail_never(void)
{
    passes = UINT32_MAX;
    fails_on = false;
}


static void *bounded(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    (void)old_size;
    if (new_size == 0) return free(block), NULL;
    if (passes == 0) {
        if (!fails_on) passes = UINT32_MAX;
        return NULL;
    }
    if (passes != UINT32_MAX) passes--;
    return new_size > MOST_BYTES ? NULL : realloc(block, new_size);
}


mus_context *fuzz_context(void)
{
    mus_context *context;
    mus_context_def def;
    mus_context_def_init(&def, sizeof def);
    def.alloc = bounded;
    fuzz_must(mus_context_create(&def, &context) == MUS_OK, "a context is made");
    return context;
}


void fuzz_context_end(mus_context *context)
{
    fuzz_must(mus_context_bytes(context) == 0, "no object holds memory after its end");
    mus_context_destroy(context);
}


uint32_t fuzz_take(fuzz_input *in, int count)
{
    uint32_t number = 0;
    for (int i = 0; i < count; i++) {
        number = number << 8 | (in->left > 0 ? *in->at : 0);
        if (in->left > 0) in->at++, in->left--;
    }
    return number;
}


int32_t fuzz_below(fuzz_input *in, int32_t n)
{
    const int32_t number = (int32_t)fuzz_take(in, 1);
    if (number == 255) return -1;
    return n > 0 && number < 250 ? number % n : n;
}


double fuzz_real(fuzz_input *in, double low, double high)
{
    static const double odd[] = {NAN, INFINITY, -INFINITY, 1e308, -1e160, 5e-324, -0.0, 1e12};
    const uint32_t number = fuzz_take(in, 2);
    return number >= 65500 ? odd[number % 8] : low + (high - low) * (double)number / 65499.0;
}


void fuzz_spoil(fuzz_input *in, void *def, size_t from, size_t size)
{
    for (uint32_t n = fuzz_take(in, 1) % 4; n > 0; n--) {
        const size_t at = from + 4 * (fuzz_take(in, 1) % ((size - from) / 4));
        const double real = fuzz_real(in, -2.0, 2.0);
        const int32_t whole = (int32_t)fuzz_take(in, 4);
        const bool wide = at % 8 == 0 && at + 8 <= size && fuzz_take(in, 1) % 2;
        memcpy((char *)def + at, wide ? (const void *)&real : (const void *)&whole, wide ? sizeof real : sizeof whole);
    }
}


void fuzz_path(char *template)
{
    const char *folder = getenv("TMPDIR");
    const int length = snprintf(template, FUZZ_PATH, "%s/muslin-fuzz-XXXXXX", folder ? folder : "/tmp");
    fuzz_must(length > 0 && length < FUZZ_PATH, "TMPDIR is shorter than 100 bytes");
}


mus_pattern *fuzz_pattern_of(mus_context *context, const uint8_t *bytes, size_t size)
{
    mus_pattern *pattern;
    const mus_status status = mus_pattern_read_from(context, (const char *)bytes, size, "fuzz", &pattern);
    fuzz_must((status == MUS_OK) == (pattern != NULL), "a pattern is given exactly with MUS_OK");
    fuzz_must(status == MUS_OK || mus_context_error(context)[0] != '\0', "a refusal has a sentence");
    return pattern;
}
