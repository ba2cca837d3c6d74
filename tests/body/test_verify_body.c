/*
 * test_verify_body.c: the cases of `muslin verify` on contours and solids as claims: their source is
 * included, and each row is an assertion.
 */
#include <math.h>
#include <string.h>

/* names of its own: another test has taken in other cases of the command */
#define verify_wants verify_body_wants
#define verify_add verify_body_add
#define verify_broken verify_body_broken
#include "verify/body.c"
#include "support.h"

Suite *mus_suite_verify_body(void);

static const char *verify_body_id;
static int verify_body_rows;


bool verify_wants(verify *v, const char *id)
{
    (void)v;
    return strcmp(id, verify_body_id) == 0;
}


void verify_add(verify *v, const char *id, const char *quantity, double exact, double got, double tolerance)
{
    (void)v;
    const double error = exact != 0.0 ? fabs((got - exact) / exact) : fabs(got);
    verify_body_rows++;
    ck_assert_msg(error <= tolerance, "%s %s: %.12g, expected %.12g: off by %g, %g allowed", id, quantity, got, exact,
                  error, tolerance);
}


void verify_broken(verify *v, const char *id, const char *quantity, mus_status status)
{
    ck_abort_msg("%s %s: %s (%s)", id, quantity, mus_status_name(status), mus_context_error(v->context));
}


static const struct {
    const char *id;
    int rows;
} verify_body_cases[] = {{"K1", 6}, {"K2", 2}, {"K3", 11}, {"K4", 36}};


START_TEST(each_case_on_contours_has_its_exact_answer)
{
    verify v = {.context = support_context()};
    verify_body_id = verify_body_cases[_i].id;
    verify_body_rows = 0;
    ck_assert_int_eq(verify_body(&v), EXIT_DONE);
    ck_assert_int_eq(verify_body_rows, verify_body_cases[_i].rows);
    support_context_end(v.context);
}
END_TEST


Suite *mus_suite_verify_body(void)
{
    Suite *suite = suite_create("verify_body");
    TCase *tests = tcase_create("verify_body");
    tcase_set_timeout(tests, 60);
    const int cases = (int)(sizeof verify_body_cases / sizeof *verify_body_cases);
    tcase_add_loop_test(tests, each_case_on_contours_has_its_exact_answer, 0, cases);
    suite_add_tcase(suite, tests);
    return suite;
}
