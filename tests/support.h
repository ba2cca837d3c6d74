/*
 * support.h: what the C tests share: a context whose allocator counts and can be told to fail, and the real data.
 *
 * Each test runs in its own process (check's fork mode), so the counters start at zero in each.
 *
 * The usual loop over failing allocations:
 *
 *     for (int64_t n = 0;; n++) {
 *         mus_context *context = support_context();
 *         support_fail_after(n, false);
 *         mus_status status = thing_create(context, &thing);
 *         support_fail_never();
 *         thing_destroy(thing);
 *         support_context_end(context);          fails the test when bytes are left
 *         if (status == MUS_OK) break;
 *         ck_assert_int_eq(status, MUS_ERR_MEMORY);
 *     }
 */
#ifndef MUS_TESTS_SUPPORT_H
#define MUS_TESTS_SUPPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <check.h>

#include "muslin/base.h"

/* check writes a note to a file for each assertion that holds, to say where a crash came after. Here millions hold, and
 * a debugger says it better: without the notes the tests under the sanitizers take 80 s in place of 700 */
#define _mark_point(file, line) ((void)0)

/* a context on the counting allocator; log lines are kept for support_log() */
mus_context *support_context(void);

/* under the sanitizers a test takes ten times as long: long ones that differ in numbers alone run a part of them */
#ifdef __SANITIZE_ADDRESS__
#define SUPPORT_SLOW 1
#else
#define SUPPORT_SLOW 0
#endif

/* destroy a context; fails the test when objects of it still hold bytes, or a block was not given back */
void support_context_end(mus_context *context);

/* let `n` allocations pass, then fail the next one (`forever`: all that follow) */
void support_fail_after(int64_t n, bool forever);
void support_fail_never(void);

/* allocations asked of the hook since the process started, those refused, and bytes out now */
int64_t support_allocations(void);
int64_t support_refused(void);
size_t support_live_bytes(void);

/* the last line that a context of support_context() logged, "" if none */
const char *support_log(void);

/* path of a file of the real data ("garmentcode/index.json") in the folder that MUSLIN_DATA names (default
 * ../shared/data). Without that file: prints a line that the test is skipped, and returns NULL */
const char *support_data(const char *relative, char *buffer, size_t size);

/* a file name in a fresh scratch folder that is gone when the test has passed, and stays to be looked at when it has
 * not; `buffer` is returned */
const char *support_scratch(const char *name, char *buffer, size_t size);

/* whole contents of a file with a zero byte after them (the caller frees), NULL if it cannot be read */
char *support_slurp(const char *path, size_t *size);

/* write bytes to a file; fails the test when it cannot */
void support_spill(const char *path, const void *bytes, size_t size);

/* random numbers that are the same in every run: 64 bits, and a double in low .. high */
uint64_t support_random(uint64_t *state);
double support_uniform(uint64_t *state, double low, double high);

#endif
