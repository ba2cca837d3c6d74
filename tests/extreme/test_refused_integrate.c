/*
 * test_refused_integrate.c: numbers that are not finite at the door of the integrators: each field of
 * the def is named, and so is the number of the state.
 */
#include <stddef.h>

#include <check.h>

#include "extreme/refused.h"
#include "muslin/integrate.h"

Suite *mus_suite_refused_integrate(void);


static void still(void *user, double t, const double *y, double *dy)
{
    (void)user;
    (void)t;
    dy[0] = y[1];
    dy[1] = 0.0;
}


static mus_status try_def(mus_context *context, const void *def, void *user)
{
    double work[8];
    return mus_integrate(context, def, 2, user, 3, work, NULL);
}


START_TEST(no_number_of_a_def_may_be_nan)
{
    static const refused_field fields[] = {
        REFUSED(mus_integrate_def, start, 1, false, "start"),
        REFUSED(mus_integrate_def, step, 1, false, "step"),
        REFUSED(mus_integrate_def, energy_growth, 1, false, "energy_growth"),
        REFUSED(mus_integrate_def, energy_floor, 1, false, "energy_floor"),
    };
    double y[2] = {0.25, 0.0};
    mus_integrate_def def;
    mus_integrate_def_init(&def, sizeof def);
    def.step = 0.5;
    def.rate = still;
    refused_fields(fields, sizeof fields / sizeof fields[0], &def, sizeof def, try_def, y);
    ck_assert(y[0] == 0.25 && y[1] == 0.0);
}
END_TEST


START_TEST(no_number_of_a_state_may_be_nan)
{
    mus_context *context = support_context();
    mus_integrate_def def;
    mus_integrate_def_init(&def, sizeof def);
    def.step = 0.5;
    def.rate = still;
    for (int32_t i = 0; i < 2; i++)
        for (int32_t v = 0; v < 3; v++) {
            double y[2] = {0.25, 0.5}, work[8];
            y[i] = refused_values[v];
            ck_assert_int_eq(mus_integrate(context, &def, 2, y, 3, work, NULL), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), i == 0 ? "y[0]" : "y[1]"));
            ck_assert(y[1 - i] == (i == 0 ? 0.5 : 0.25));
        }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_integrate(void)
{
    Suite *suite = suite_create("refused_integrate");
    TCase *tests = tcase_create("refused_integrate");
    tcase_add_test(tests, no_number_of_a_def_may_be_nan);
    tcase_add_test(tests, no_number_of_a_state_may_be_nan);
    suite_add_tcase(suite, tests);
    return suite;
}
