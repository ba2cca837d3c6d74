/*
 * main.c: runs every suite. The list of suites (suites.h) is made by the Makefile from the names of the test files:
 * tests/geom/test_curve.c exports mus_suite_curve().
 *
 * Each test runs in its own process; CK_RUN_SUITE=curve runs one suite, CK_FORK=no keeps all in one process for a
 * debugger, CK_VERBOSITY=verbose names each test. MUSLIN_SHARD=1/4 takes every fourth suite, from the second on: so a
 * slow build of the tests can run on several cores. The exit code is 0 only when every test passed.
 */
#include <stdio.h>
#include <stdlib.h>

#include <check.h>

#include "suites.h"

#define DECLARE(name) Suite *mus_suite_##name(void);
SUITES(DECLARE)


int main(void)
{
    int shard = 0, shards = 1, number = 0;
    const char *text = getenv("MUSLIN_SHARD");
    if (text != NULL && (sscanf(text, "%d/%d", &shard, &shards) != 2 || shards < 1)) {
        fprintf(stderr, "MUSLIN_SHARD is %s, expected one like 0/2\n", text);
        return EXIT_FAILURE;
    }

    SRunner *runner = srunner_create(NULL);
#define ADD(name) \
    if (number++ % shards == shard) srunner_add_suite(runner, mus_suite_##name());
    SUITES(ADD)
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
