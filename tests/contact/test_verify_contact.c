/*
 * test_verify_contact.c: the cases of `muslin verify` on limbs and planes as claims (F1-F8, C1-C5,
 * V1-V3): their sources are taken in, and each row asserts.
 */
#include <math.h>
#include <string.h>

#include "verify/collide.c"
#include "verify/contact.c"
#include "verify/contour.c"
#include "verify/curve.c"
#include "verify/limbs.c"
#include "verify/plane.c"
#include "support.h"

Suite *mus_suite_verify_contact(void);

static const char *verify_contact_id;
static int verify_contact_rows;


bool verify_wants(verify *v, const char *id)
{
    (void)v;
    return strcmp(id, verify_contact_id) == 0;
}


void verify_add(verify *v, const char *id, const char *quantity, double exact, double got, double tolerance)
{
    (void)v;
    const double error = exact != 0.0 ? fabs((got - exact) / exact) : fabs(got);
    verify_contact_rows++;
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
} verify_contact_cases[] = {{"F3", 4},  {"F4", 4}, {"F7", 2}, {"F8", 2}, {"C1", 6},
                            {"C3", 12}, {"C5", 1}, {"V2", 2}, {"V3", 4}, {"F1", 3},
                            {"F2", 6},  {"F5", 1}, {"F6", 3}, {"V1", 2}, {"C2", 2}, {"C4", 7}};


START_TEST(each_case_on_limbs_has_its_exact_answer)
{
    verify v = {.context = support_context()};
    verify_contact_id = verify_contact_cases[_i].id;
    verify_contact_rows = 0;
    verify_contact(&v);
    verify_collide(&v);
    verify_plane(&v);
    ck_assert_int_eq(verify_contact_rows, verify_contact_cases[_i].rows);
    support_context_end(v.context);
}
END_TEST


Suite *mus_suite_verify_contact(void)
{
    Suite *suite = suite_create("verify_contact");
    TCase *tests = tcase_create("verify_contact");
    tcase_set_timeout(tests, 120);
    tcase_add_loop_test(tests, each_case_on_limbs_has_its_exact_answer, 0,
                        SUPPORT_SLOW ? 4 : (int)(sizeof verify_contact_cases / sizeof *verify_contact_cases));
    suite_add_tcase(suite, tests);
    return suite;
}
