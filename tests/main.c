/*
 * main.c: runs every suite. The list of suites (suites.h) is made by the Makefile from the names of the test files:
 * tests/geom/test_curve.c exports mus_suite_curve().
 *
 * Each test runs in its own process; CK_RUN_SUITE=curve runs one suite, CK_FORK=no keeps all in one process for a
 * debugger, CK_VERBOSITY=verbose names each test. The exit code is 0 only when every test passed.
 */
#include <stdlib.h>

#include <check.h>

#include "suites.h"

#define DECLARE(name) Suite *mus_suite_##name(void);
SUITES(DECLARE)


int main(void)
{
    SRunner *runner = srunner_create(NULL);
#define ADD(name) srunner_add_suite(runner, mus_suite_##name());
    SUITES(ADD)
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
