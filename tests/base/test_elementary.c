/*
 * test_elementary.c: the own sine to logarithm are within 1 ulp of exact values, give the same bits from every
 * compiler, and treat infinities, NaN and zeros as C11 says. Errors over millions of arguments: `make elementary`.
 */
#include "support.h"

#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "muslin/base.h"

/* one argument, or two */
typedef struct function {
    const char *name;
    double (*one)(double);
    double (*two)(double, double);
} function;

static const function functions[] = {
    {"sin", mus__sin, NULL},     {"cos", mus__cos, NULL}, {"tan", mus__tan, NULL}, {"asin", mus__asin, NULL},
    {"acos", mus__acos, NULL},   {"exp", mus__exp, NULL}, {"ln", mus__ln, NULL},   {"atan2", NULL, mus__atan2},
    {"hypot", NULL, mus__hypot}, {"pow", NULL, mus__pow},
};

/* a value as the double next to it, and the rest */
static const struct row {
    const char *name;
    double x, y, exact, rest;
} rows[] = {
#include "elementary_table.h"
};


static const function *find(const char *name)
{
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++)
        if (strcmp(functions[i].name, name) == 0) return &functions[i];
    ck_abort_msg("%s is no function of the table", name);
    return NULL;
}


START_TEST(within_an_ulp_of_exact_values)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct row *row = &rows[i];
        const function *f = find(row->name);
        const double got = f->one ? f->one(row->x) : f->two(row->x, row->y);
        const double ulp = nextafter(fabs(row->exact), INFINITY) - fabs(row->exact);
        ck_assert_msg(fabs((got - row->exact) - row->rest) < ulp, "%s(%a, %a) is %a, not %a", row->name, row->x, row->y,
                      got, row->exact);
    }
}
END_TEST


/* FNV-1a over the bits of all functions at 20,000 arguments from 2^-60 to 2^19, made of integers */
START_TEST(the_bits_are_those_of_every_compiler)
{
    uint64_t digest = UINT64_C(0xcbf29ce484222325), state = 25;
    for (int i = 0; i < 20000; i++) {
        double argument[2];
        for (int k = 0; k < 2; k++) {
            state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
            argument[k] = ldexp((double)(int64_t)(state >> 11) - 0x1p52, (int)(state % 79) - 112);
        }
        const function *f = &functions[i % 10];
        const double x = f->two || f->one == mus__exp || f->one == mus__ln ? fabs(argument[0]) : argument[0];
        const double inside = f->one == mus__asin || f->one == mus__acos ? fmod(x, 1.0) : x;
        const double got = f->one ? f->one(inside) : f->two(x, argument[1]);
        uint64_t bits;
        memcpy(&bits, &got, sizeof bits);
        if (got != got) bits = 0; /* the sign of a NaN is no promise */
        for (int b = 0; b < 64; b += 8) digest = (digest ^ (bits >> b & 255)) * UINT64_C(0x100000001b3);
    }
    ck_assert_msg(digest == UINT64_C(0xe0889523a7138cc0), "the digest is %016llx", (unsigned long long)digest);
}
END_TEST


static void same(double got, double wanted)
{
    ck_assert_msg((got != got && wanted != wanted) || (got == wanted && !signbit(got) == !signbit(wanted)),
                  "%a, not %a", got, wanted);
}


START_TEST(special_values_are_those_of_c11)
{
    const double pi = 0x1.921fb54442d18p+1, big = INFINITY;
    same(mus__sin(-0.0), -0.0);
    same(mus__tan(-0.0), -0.0);
    same(mus__cos(0.0), 1.0);
    same(mus__sin(big), NAN);
    same(mus__tan(-big), NAN);
    same(mus__asin(-0.0), -0.0);
    same(mus__asin(-1.0), -pi / 2.0);
    same(mus__asin(1.0 + 0x1p-52), NAN);
    same(mus__acos(1.0), 0.0);
    same(mus__acos(-1.0), pi);
    same(mus__acos(NAN), NAN);
    same(mus__atan2(0.0, -0.0), pi);
    same(mus__atan2(-0.0, 1.0), -0.0);
    same(mus__atan2(-0.0, -1.0), -pi);
    same(mus__atan2(-1.0, 0.0), -pi / 2.0);
    same(mus__atan2(big, -big), 0.75 * pi);
    same(mus__atan2(1.0, -big), pi);
    same(mus__atan2(5e-324, 1e308), 0.0);
    same(mus__exp(-big), 0.0);
    same(mus__exp(710.0), big);
    same(mus__exp(0.0), 1.0);
    same(mus__ln(0.0), -big);
    same(mus__ln(-1.0), NAN);
    same(mus__ln(1.0), 0.0);
    same(mus__ln(big), big);
    same(mus__hypot(-big, NAN), big);
    same(mus__hypot(3e300, 4e300), 5e300);
    same(mus__hypot(-0.0, 0.0), 0.0);
    same(mus__pow(NAN, 0.0), 1.0);
    same(mus__pow(1.0, NAN), 1.0);
    same(mus__pow(-2.0, 3.0), -8.0);
    same(mus__pow(-2.0, 0.5), NAN);
    same(mus__pow(-0.0, -3.0), -big);
    same(mus__pow(-big, 2.0), big);
    same(mus__pow(0.5, big), 0.0);
    same(mus__pow(10.0, 400.0), big);
    same(mus__pow(-10.0, -401.0), -0.0);
}
END_TEST


Suite *mus_suite_elementary(void);
Suite *mus_suite_elementary(void)
{
    Suite *suite = suite_create("elementary");
    TCase *tcase = tcase_create("elementary");
    tcase_add_test(tcase, within_an_ulp_of_exact_values);
    tcase_add_test(tcase, the_bits_are_those_of_every_compiler);
    tcase_add_test(tcase, special_values_are_those_of_c11);
    suite_add_tcase(suite, tcase);
    return suite;
}
