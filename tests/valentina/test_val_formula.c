/*
 * test_val_formula.c: formulas of Valentina against values worked out by hand, and texts that are none.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "valentina/val_file.h"

static bool lookup(const void *user, const char *name, size_t length, double *out)
{
    (void)user;
    if (length == 5 && memcmp(name, "#wide", 5) == 0) *out = 7.5;
    else if (length == 8 && memcmp(name, "hip_circ", 8) == 0) *out = 98.0;
    else if (length == 4 && memcmp(name, "\xd0\x90_3", 4) == 0) *out = 2.0;
    else return false;
    return true;
}


START_TEST(formulas_have_their_values)
{
    static const struct {
        const char *text;
        double value;
    } rows[] = {{"1+2*3", 7.0}, {" (1 + 2) * 3 ", 9.0}, {"-2^2", -4.0}, {"2^-1", 0.5}, {"10/4-1", 1.5},
                {"hip_circ/4 + 1.27", 25.77}, {"#wide*2", 15.0}, {"\xd0\x90_3*3", 6.0}, {"--3", 3.0},
                {"1<2 && 3>=3", 1.0}, {"1==2 || 0", 0.0}, {"2>1 ? 5 : 6", 5.0}, {"0 ? 5 : 0 ? 6 : 7", 7.0},
                {"max(1;2,3)", 3.0}, {"min(4;2)", 2.0}, {"sum(1;2;3)", 6.0}, {"avg(1;2;6)", 3.0}, {"abs(-4)", 4.0},
                {"sqrt(16)", 4.0}, {"rint(2.6)", 3.0}, {"sign(-2)", -1.0}, {"sinD(30)", 0.5}, {"atanD(1)", 45.0},
                {"cos(0)", 1.0}, {"log(1000)", 3.0}, {"fmod(7;4)", 3.0}, {"1e1", 10.0}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double value = 0.0;
        const char *at, *wrong = mus__val_evaluate(rows[i].text, lookup, NULL, &value, &at);
        ck_assert_msg(wrong == NULL, "%s: %s %s", rows[i].text, at, wrong);
        ck_assert_double_eq_tol(value, rows[i].value, 1e-12);
    }
}
END_TEST


START_TEST(a_text_that_is_no_formula_is_refused_with_its_place)
{
    static const struct {
        const char *text, *at;
    } rows[] = {{"", ""}, {"1+", ""}, {"(1", ""}, {"1)", ")"}, {"waist*2", "waist*2"}, {"2 3", "3"}, {"1/0", ""},
                {"f(1)", "f(1)"}, {"min()", ""}, {"1 ? 2", ""}, {"sqrt(-1)", ""}, {"#wide(3)", "#wide(3)"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double value = 1.0;
        const char *at, *wrong = mus__val_evaluate(rows[i].text, lookup, NULL, &value, &at);
        ck_assert_msg(wrong != NULL, "%s is %g", rows[i].text, value);
        ck_assert_msg(strcmp(at, rows[i].at) == 0, "%s: at \"%s\"", rows[i].text, at);
        ck_assert_double_eq(value, 0.0);
    }

    /* brackets, signs and powers without end, and a text without end */
    char *deep = malloc(200001);
    for (size_t k = 0; k < 3; k++) {
        memset(deep, "(-1"[k], 60000);
        if (k == 2) for (size_t i = 1; i < 60000; i += 2) deep[i] = '^';
        deep[60000] = '\0';
        double value;
        const char *at;
        ck_assert_ptr_nonnull(mus__val_evaluate(deep, lookup, NULL, &value, &at));
    }
    memset(deep, '1', 200000);
    deep[200000] = '\0';
    double value;
    const char *at;
    ck_assert_ptr_nonnull(mus__val_evaluate(deep, lookup, NULL, &value, &at));
    free(deep);
}
END_TEST


Suite *mus_suite_val_formula(void);

Suite *mus_suite_val_formula(void)
{
    Suite *suite = suite_create("val_formula");
    TCase *tests = tcase_create("val_formula");
    tcase_add_test(tests, formulas_have_their_values);
    tcase_add_test(tests, a_text_that_is_no_formula_is_refused_with_its_place);
    suite_add_tcase(suite, tests);
    return suite;
}
