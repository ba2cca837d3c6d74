/*
 * elementary.c: the functions of lib/base/elementary.h against MPFR, and their time beside that of the C library.
 *
 *     elementary [COUNT]
 *
 * For each function and range: the worst error in ulp over COUNT random arguments (200,000), with the argument. Then
 * nanoseconds a call, own and C library's. Exit 1 when an error is 1 ulp or more: within 2^-1022 of 0 the last step
 * rounds twice, and the results there are left out.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <math.h>
#include <mpfr.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "base/elementary.h"

static uint64_t state = UINT64_C(88172645463325252);
static int failed;
static mpfr_t left, right, exact;


/* uniform in [0, 1) (Marsaglia, Xorshift RNGs, 2003) */
static double uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}


/* of either sign; its exponent is uniform in [low, high) */
static double any(double low, double high)
{
    const double size = ldexp(1.0 + uniform(), (int)floor(low + (high - low) * uniform()));
    return uniform() < 0.5 ? -size : size;
}


/* |got - exact| in ulp of the exact value; 0 for a result that is no normal number on both sides */
static double error_of(double got)
{
    const double wanted = mpfr_get_d(exact, MPFR_RNDN);
    int exponent;
    if (!isnormal(wanted)) return isfinite(wanted) || wanted == got || (isnan(wanted) && isnan(got)) ? 0.0 : INFINITY;
    if (!isfinite(got)) return INFINITY;
    frexp(wanted, &exponent);
    mpfr_sub_d(exact, exact, got, MPFR_RNDN);
    mpfr_mul_2si(exact, exact, 53 - exponent, MPFR_RNDN); /* first: half an ulp of 2^-1022 is no double */
    return fabs(mpfr_get_d(exact, MPFR_RNDN));
}


static void report(const char *name, double low, double high, double worst, double x, double y)
{
    printf("%-6s 2^%-6g .. 2^%-5g worst error %.4f ulp at %a %a\n", name, low, high, worst, x, y);
    failed |= !(worst < 1.0);
}


typedef double one(double);
typedef double two(double, double);
typedef int one_exact(mpfr_t, const mpfr_t, mpfr_rnd_t);
typedef int two_exact(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t);


static void check_one(const char *name, int count, one *own, one_exact *f, double low, double high)
{
    double worst = 0.0, at = 0.0;
    for (int i = 0; i < count; i++) {
        const double x = own == mus__ln ? fabs(any(low, high)) : any(low, high);
        mpfr_set_d(left, x, MPFR_RNDN);
        f(exact, left, MPFR_RNDN);
        const double error = error_of(own(x));
        if (error > worst) worst = error, at = x;
    }
    report(name, low, high, worst, at, 0.0);
}


static void check_two(const char *name, int count, two *own, two_exact *f, double low, double high)
{
    double worst = 0.0, at[2] = {0.0, 0.0};
    for (int i = 0; i < count; i++) {
        double x = any(low, high), y = any(low, high);
        if (own == mus__pow) {
            x = fabs(x);
            y = 1480.0 * (uniform() - 0.5) / fabs(log(x)); /* results over the range of a double */
        }
        mpfr_set_d(left, x, MPFR_RNDN);
        mpfr_set_d(right, y, MPFR_RNDN);
        f(exact, left, right, MPFR_RNDN);
        const double error = error_of(own(x, y));
        if (error > worst) worst = error, at[0] = x, at[1] = y;
    }
    report(name, low, high, worst, at[0], at[1]);
}


static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


/* nanoseconds a call over 1000 arguments in [low, high) */
static double time_of(one *f, two *g, double low, double high)
{
    static double x[1001];
    volatile double sum = 0.0;
    for (int i = 0; i <= 1000; i++) x[i] = low + (high - low) * uniform();
    const double start = seconds();
    for (int k = 0; k < 1000; k++)
        for (int i = 0; i < 1000; i++) sum += f ? f(x[i]) : g(x[i], x[i + 1]);
    return 1e3 * (seconds() - start);
}


static void show_time(const char *name, one *own, one *theirs, two *own2, two *theirs2, double low, double high)
{
    const double mine = time_of(own, own2, low, high), other = time_of(theirs, theirs2, low, high);
    printf("%-6s %5.1f ns, C library %5.1f ns\n", name, mine, other);
}


int main(int argc, char **argv)
{
    const int n = argc > 1 ? atoi(argv[1]) : 200000;
    mpfr_init2(left, 53);
    mpfr_init2(right, 53);
    mpfr_init2(exact, 200);
    static const double turn[][2] = {{-60, 0}, {0, 5}, {5, 19}};
    for (int i = 0; i < 3; i++) {
        check_one("sin", n, mus__sin, mpfr_sin, turn[i][0], turn[i][1]);
        check_one("cos", n, mus__cos, mpfr_cos, turn[i][0], turn[i][1]);
        check_one("tan", n, mus__tan, mpfr_tan, turn[i][0], turn[i][1]);
    }
    static const double unit[][2] = {{-1000, -9}, {-9, -1}, {-1, 0}};
    for (int i = 0; i < 3; i++) {
        check_one("asin", n, mus__asin, mpfr_asin, unit[i][0], unit[i][1]);
        check_one("acos", n, mus__acos, mpfr_acos, unit[i][0], unit[i][1]);
    }
    static const double power[][2] = {{-1000, -5}, {-5, 3}, {3, 10}};
    for (int i = 0; i < 3; i++) check_one("exp", n, mus__exp, mpfr_exp, power[i][0], power[i][1]);
    static const double log_of[][2] = {{-1, 1}, {-20, 20}, {-1074, 1023}};
    for (int i = 0; i < 3; i++) check_one("ln", n, mus__ln, mpfr_log, log_of[i][0], log_of[i][1]);
    static const double plane[][2] = {{-3, 3}, {-40, 40}, {-1070, 1020}, {980, 1020}};
    for (int i = 0; i < 4; i++) {
        check_two("atan2", n, mus__atan2, mpfr_atan2, plane[i][0], plane[i][1]);
        check_two("hypot", n, mus__hypot, mpfr_hypot, plane[i][0], plane[i][1]);
    }
    static const double base[][2] = {{-1, 1}, {-5, 5}, {-1000, 1000}};
    for (int i = 0; i < 3; i++) check_two("pow", n, mus__pow, mpfr_pow, base[i][0], base[i][1]);

    show_time("sin", mus__sin, sin, NULL, NULL, -3.0, 3.0);
    show_time("cos", mus__cos, cos, NULL, NULL, -3.0, 3.0);
    show_time("tan", mus__tan, tan, NULL, NULL, -1.0, 1.0);
    show_time("asin", mus__asin, asin, NULL, NULL, -1.0, 1.0);
    show_time("acos", mus__acos, acos, NULL, NULL, -1.0, 1.0);
    show_time("exp", mus__exp, exp, NULL, NULL, -5.0, 5.0);
    show_time("ln", mus__ln, log, NULL, NULL, 0.1, 10.0);
    show_time("atan2", NULL, NULL, mus__atan2, atan2, -1.0, 1.0);
    show_time("hypot", NULL, NULL, mus__hypot, hypot, -1.0, 1.0);
    show_time("pow", NULL, NULL, mus__pow, pow, 0.1, 5.0);
    puts(failed ? "an error is 1 ulp or more" : "all errors are below 1 ulp");
    return failed;
}
