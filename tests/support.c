/*
 * support.c: the counting allocator, the data folder, scratch files and a generator, as support.h says.
 *
 * The allocator puts a guard word on either side of each block, checks the sizes that it is told against the sizes
 * that it gave, and counts; a wrong old size or a written guard ends the test at once.
 */
#define _XOPEN_SOURCE 700 /* mkdtemp, P_tmpdir */
#include "support.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define GUARD UINT64_C(0x6d75736c696e2121)
#define HEAD 32 /* size, guard, and room to keep the block aligned for any type */

static struct {
    int64_t asked, refused, until; /* until: allocations to let pass; < 0 no limit */
    bool forever;
    size_t live;
    char log[512];
    char scratch[256];
} state = {.until = -1};


static void check_block(const unsigned char *head, size_t size)
{
    uint64_t word[2];
    memcpy(word, head, sizeof word);
    ck_assert_msg(word[0] == size, "the hook was told a block of %zu bytes, it gave %" PRIu64, size, word[0]);
    ck_assert_msg(word[1] == GUARD, "bytes before a block of %zu were written", size);
    memcpy(word, head + HEAD + size, sizeof word[0]);
    ck_assert_msg(word[0] == GUARD, "bytes behind a block of %zu were written", size);
}


static bool refuse(void)
{
    state.asked++;
    if (state.until < 0) return false;
    if (state.until > 0) {
        state.until--;
        return false;
    }
    if (!state.forever) state.until = -1;
    state.refused++;
    return true;
}


static void *counting_alloc(void *user, void *ptr, size_t old_size, size_t new_size)
{
    (void)user;
    unsigned char *old = ptr != NULL ? (unsigned char *)ptr - HEAD : NULL;
    if (old != NULL) check_block(old, old_size);

    unsigned char *head = NULL;
    if (new_size > 0) {
        if (refuse()) return NULL;
        head = malloc(new_size + HEAD + sizeof(uint64_t));
        ck_assert_ptr_nonnull(head);
        const uint64_t word[2] = {new_size, GUARD};
        memcpy(head, word, sizeof word);
        memset(head + HEAD, 0xa5, new_size);
        memcpy(head + HEAD + new_size, &word[1], sizeof word[1]);
        state.live += new_size;
        if (old != NULL) memcpy(head + HEAD, ptr, old_size < new_size ? old_size : new_size);
    }
    if (old != NULL) {
        state.live -= old_size;
        memset(old, 0x5a, old_size + HEAD + sizeof(uint64_t));
        free(old);
    }
    return head != NULL ? head + HEAD : NULL;
}


static void keep_log(void *user, int32_t level, const char *text)
{
    (void)user;
    (void)level;
    snprintf(state.log, sizeof state.log, "%s", text);
}


mus_context *support_context(void)
{
    mus_context_def def;
    mus_context_def_init(&def, sizeof def);
    def.alloc = counting_alloc;
    def.log = keep_log;

    mus_context *context = NULL;
    ck_assert_int_eq(mus_context_create(&def, &context), MUS_OK);
    return context;
}


void support_context_end(mus_context *context)
{
    ck_assert_msg(mus_context_bytes(context) == 0, "%zu bytes are left in the context", mus_context_bytes(context));
    size_t before = state.live;
    mus_context_destroy(context);
    ck_assert_msg(context == NULL || state.live < before, "the context gave nothing back");
}


void support_fail_after(int64_t n, bool forever)
{
    state.until = n;
    state.forever = forever;
}


void support_fail_never(void)
{
    state.until = -1;
    state.forever = false;
}


int64_t support_allocations(void)
{
    return state.asked;
}


int64_t support_refused(void)
{
    return state.refused;
}


size_t support_live_bytes(void)
{
    return state.live;
}


const char *support_log(void)
{
    return state.log;
}


const char *support_data(const char *relative, char *buffer, size_t size)
{
    const char *folder = getenv("MUSLIN_DATA");
    if (folder == NULL || folder[0] == '\0') folder = "../shared/data";
    int n = snprintf(buffer, size, "%s/%s", folder, relative);
    ck_assert_int_lt(n, (int)size);
    if (access(buffer, R_OK) == 0) return buffer;
    printf("skipped: no %s (set MUSLIN_DATA)\n", buffer);
    fflush(stdout);
    return NULL;
}


static void scratch_remove(void)
{
    char command[300];
    snprintf(command, sizeof command, "rm -rf '%s'", state.scratch);
    if (system(command) != 0) fprintf(stderr, "%s is left\n", state.scratch);
}


const char *support_scratch(const char *name, char *buffer, size_t size)
{
    if (state.scratch[0] == '\0') {
        const char *base = getenv("TMPDIR");
        snprintf(state.scratch, sizeof state.scratch, "%s/muslin-test-XXXXXX", base != NULL ? base : P_tmpdir);
        ck_assert_ptr_nonnull(mkdtemp(state.scratch));
        atexit(scratch_remove);
    }
    int n = snprintf(buffer, size, "%s/%s", state.scratch, name);
    ck_assert_int_lt(n, (int)size);
    return buffer;
}


char *support_slurp(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) return NULL;
    fseek(file, 0, SEEK_END);
    long length = ftell(file);
    rewind(file);
    char *bytes = length >= 0 ? malloc((size_t)length + 1) : NULL;
    if (bytes != NULL) {
        size_t got = fread(bytes, 1, (size_t)length, file);
        bytes[got] = '\0';
        if (size != NULL) *size = got;
    }
    fclose(file);
    return bytes;
}


void support_spill(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    ck_assert_msg(file != NULL, "%s cannot be written", path);
    ck_assert_uint_eq(fwrite(bytes, 1, size, file), size);
    ck_assert_int_eq(fclose(file), 0);
}


uint64_t support_random(uint64_t *seed)
{
    /* splitmix64: Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014 */
    uint64_t z = *seed += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}


double support_uniform(uint64_t *seed, double low, double high)
{
    return low + (high - low) * (double)(support_random(seed) >> 11) * 0x1p-53;
}
