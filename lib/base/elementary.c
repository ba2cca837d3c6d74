/*
 * elementary.c: sine to logarithm from + - * / and the square root alone (elementary.h says why).
 *
 * Each function reduces its argument to a small interval, evaluates a polynomial there, and keeps the leading terms as
 * a pair: two doubles whose sum carries about 100 bits. One rounding of the pair gives the result. The polynomials are
 * minimax (Remez exchange, relative error), computed in 300 bits by tests/study/elementary/coefficients.py, which
 * prints every constant of this file.
 *
 * Sources: Cody and Waite, Software Manual for the Elementary Functions, 1980 (reduction by pi/2 and ln 2 in parts);
 * Tang, Table-Driven Implementation of the Logarithm Function, 1990 (logarithm by (m - c) / (m + c)); Dekker 1971
 * (pairs); Muller, Elementary Functions, 3rd edition, 2016 (all of these with proofs).
 */
#include "base/elementary.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/exact.h"

typedef struct elementary_pair {
    double hi, lo; /* its value is hi + lo; |lo| is a few ulp of hi at most, but in a sine and cosine a tenth of hi */
} elementary_pair;

/* beyond it k pi/2 is no longer exact in parts of 33 bits [rad] */
#define ELEMENTARY_TURNS 1048576.0
/* adding it rounds a double of less than 2^51 to an integer */
#define ELEMENTARY_ROUND 0x1.8p52
/* squares of larger numbers, and the splits of products, could overflow; those of its inverse underflow */
#define ELEMENTARY_LARGE 0x1p400
#define ELEMENTARY_SCALE 0x1p600
/* exp of anything above overflows, and below its negative is 0 */
#define ELEMENTARY_EXP 746.0
/* the angle below which sin x = tan x = x in double [rad] */
#define ELEMENTARY_SMALL 0x1p-30
/* the ratio below which atan(t) = t and hypot(1, t) = 1 in double */
#define ELEMENTARY_TINY 0x1p-70

static const elementary_pair elementary_pi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
static const elementary_pair elementary_right = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};


/* The sum of a pair and two doubles, the second of which is small against the first. */
static elementary_pair elementary_add(elementary_pair a, double hi, double lo)
{
    elementary_pair sum;
    sum.hi = mus__exact_sum(a.hi, hi, &sum.lo);
    sum.lo += a.lo + lo;
    return sum;
}


/* n / d */
static elementary_pair elementary_quotient(elementary_pair n, elementary_pair d)
{
    const double q = n.hi / d.hi;
    double low, high = mus__exact_product(q, d.hi, &low);
    const double rest = (n.hi - high - low) + (n.lo - q * d.lo);
    return (elementary_pair){q, rest / d.hi};
}


/* The square root of a pair above 0. */
static elementary_pair elementary_root(elementary_pair a)
{
    const double root = sqrt(a.hi);
    double low, high = mus__exact_product(root, root, &low);
    return (elementary_pair){root, root > 0.0 ? ((a.hi - high - low) + a.lo) / (2.0 * root) : 0.0};
}


/* 2^k for -1022 <= k <= 1023 */
static double elementary_power(int k)
{
    const uint64_t bits = (uint64_t)(k + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}


/* ---- sine, cosine, tangent ---- */

/* x less the nearest multiple of pi/2, within pi/4; *quadrant: that multiple, modulo 4 */
static elementary_pair elementary_reduce(double x, int *quadrant)
{
    static const double part[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
    elementary_pair r = {x, 0.0};
    *quadrant = 0;
    if (fabs(x) <= 0x1.921fb54442d18p-1) return r;
    if (!(fabs(x) < ELEMENTARY_TURNS)) r.hi = fmod(x, 0x1.921fb54442d18p+2); /* NaN for an infinite x */
    if (r.hi != r.hi) return r;
    const double k = (r.hi * 0x1.45f306dc9c883p-1 + ELEMENTARY_ROUND) - ELEMENTARY_ROUND;
    for (int i = 0; i < 4; i++) r = elementary_add(r, -k * part[i], 0.0);
    r.hi = mus__exact_sum(r.hi, r.lo, &r.lo);
    *quadrant = (int)((int64_t)k & 3);
    return r;
}


/* sin r for |r| <= pi/4: r + r^3 P(r^2), error 2^-68 */
static elementary_pair elementary_sin(elementary_pair r)
{
    const double z = r.hi * r.hi;
    const double p =
        -0x1.5555555555555p-3 +
        z * (0x1.111111111110bp-7 +
             z * (-0x1.a01a01a018ae6p-13 +
                  z * (0x1.71de3a5339aacp-19 +
                       z * (-0x1.ae64529891721p-26 + z * (0x1.612092e58d141p-33 - z * 0x1.aaa55e9c27ceap-41)))));
    return (elementary_pair){r.hi, r.hi * z * p + r.lo * (1.0 - 0.5 * z)};
}


/* cos r for |r| <= pi/4: 1 - r^2 / 2 + r^4 P(r^2), error 2^-64 */
static elementary_pair elementary_cos(elementary_pair r)
{
    double low, z = mus__exact_product(r.hi, r.hi, &low);
    const double p = 0x1.555555555554cp-5 +
                     z * (-0x1.6c16c16c15181p-10 +
                          z * (0x1.a01a019cb2165p-16 +
                               z * (-0x1.27e4f80a337e9p-22 + z * (0x1.1ee9ec1874bep-29 - z * 0x1.8faeb5d6f5626p-37))));
    const double w = 1.0 - 0.5 * z;
    low += 2.0 * r.hi * r.lo;
    return (elementary_pair){w, ((1.0 - w) - 0.5 * z) + (z * z * p - 0.5 * low)};
}


double mus__sin(double x)
{
    int quadrant;
    if (fabs(x) < ELEMENTARY_SMALL) return x;
    const elementary_pair r = elementary_reduce(x, &quadrant);
    const elementary_pair s = quadrant & 1 ? elementary_cos(r) : elementary_sin(r);
    return quadrant & 2 ? -(s.hi + s.lo) : s.hi + s.lo;
}


double mus__cos(double x)
{
    int quadrant;
    const elementary_pair r = elementary_reduce(x, &quadrant);
    const elementary_pair s = quadrant & 1 ? elementary_sin(r) : elementary_cos(r);
    return (quadrant + 1) & 2 ? -(s.hi + s.lo) : s.hi + s.lo;
}


double mus__tan(double x)
{
    int quadrant;
    if (fabs(x) < ELEMENTARY_SMALL) return x;
    const elementary_pair r = elementary_reduce(x, &quadrant);
    elementary_pair s = elementary_sin(r), c = elementary_cos(r);
    s.hi = mus__exact_sum(s.hi, s.lo, &s.lo);
    c.hi = mus__exact_sum(c.hi, c.lo, &c.lo);
    const elementary_pair t = quadrant & 1 ? elementary_quotient(c, s) : elementary_quotient(s, c);
    return quadrant & 1 ? -(t.hi + t.lo) : t.hi + t.lo;
}


/* ---- angles ---- */

/* atan(y / x) for 0 <= y <= x: with c = i / 8 next to y / x it is atan c + atan((y - c x) / (x + c y)) */
static elementary_pair elementary_octant(elementary_pair y, elementary_pair x)
{
    static const elementary_pair angle[] = {
        {0.0, 0.0},
        {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
        {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
        {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
        {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
        {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
        {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
        {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
        {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
    };
    const int i = (int)(8.0 * (y.hi / x.hi) + 0.5);
    const double c = 0.125 * i;
    elementary_pair cx, cy;
    cx.hi = mus__exact_product(c, x.hi, &cx.lo);
    cy.hi = mus__exact_product(c, y.hi, &cy.lo);
    const elementary_pair n = elementary_add(y, -cx.hi, -(cx.lo + c * x.lo));
    const elementary_pair u = elementary_quotient(n, elementary_add(x, cy.hi, cy.lo + c * y.lo));
    /* atan u = u + u^3 P(u^2) for |u| <= 1/16, error 2^-62 */
    const double z = u.hi * u.hi;
    const double p = -0x1.5555555555533p-2 +
                     z * (0x1.999999995dae4p-3 +
                          z * (-0x1.2492481706047p-3 + z * (0x1.c7184eff1d533p-4 - z * 0x1.70ac27f1b3991p-4)));
    return elementary_add(angle[i], u.hi, u.lo + u.hi * z * p);
}


/* atan(y / x) for y, x >= 0, not both 0 */
static elementary_pair elementary_quarter(elementary_pair y, elementary_pair x)
{
    if (y.hi <= x.hi) return elementary_octant(y, x);
    const elementary_pair a = elementary_octant(x, y);
    return elementary_add(elementary_right, -a.hi, -a.lo);
}


/* sqrt(1 - x^2) for |x| <= 1 */
static elementary_pair elementary_leg(double x)
{
    double low, high = mus__exact_product(x, x, &low);
    elementary_pair rest = elementary_add((elementary_pair){1.0, 0.0}, -high, -low);
    rest.hi = mus__exact_sum(rest.hi, rest.lo, &rest.lo);
    return elementary_root(rest);
}


double mus__asin(double x)
{
    const double size = fabs(x);
    if (!(size <= 1.0)) return (x - x) / (x - x);
    const elementary_pair a = elementary_quarter((elementary_pair){size, 0.0}, elementary_leg(x));
    return copysign(a.hi + a.lo, x);
}


double mus__acos(double x)
{
    if (!(fabs(x) <= 1.0)) return (x - x) / (x - x);
    elementary_pair a = elementary_quarter(elementary_leg(x), (elementary_pair){fabs(x), 0.0});
    if (x < 0.0) a = elementary_add(elementary_pi, -a.hi, -a.lo);
    return a.hi + a.lo;
}


double mus__atan2(double y, double x)
{
    if (x != x || y != y) return x + y;
    double up = fabs(y), along = fabs(x);
    if (isinf(up) || isinf(along)) {
        const double both = isinf(up) && isinf(along) ? 1.0 : 0.0;
        up = isinf(up) ? 1.0 : both;
        along = isinf(along) ? 1.0 : both;
    }
    const double most = up > along ? up : along;
    elementary_pair a = {0.0, 0.0};
    if (up < ELEMENTARY_TINY * along) {
        a.hi = up / along;
    } else if (along < ELEMENTARY_TINY * up) {
        a = elementary_right;
    } else if (up > 0.0) {
        const double scale = most > ELEMENTARY_LARGE         ? 1.0 / ELEMENTARY_SCALE
                             : most < 1.0 / ELEMENTARY_LARGE ? ELEMENTARY_SCALE
                                                             : 1.0;
        a = elementary_quarter((elementary_pair){up * scale, 0.0}, (elementary_pair){along * scale, 0.0});
    }
    if (signbit(x)) a = elementary_add(elementary_pi, -a.hi, -a.lo);
    return copysign(a.hi + a.lo, y);
}


/* ---- exponential, logarithm, power ---- */

/* exp(a): 2^k exp(r) with |r| <= ln 2 / 2; exp r = 1 + r + r^2 P(r), error 2^-63 */
static double elementary_exp(elementary_pair a)
{
    if (a.hi > ELEMENTARY_EXP) return INFINITY;
    if (a.hi < -ELEMENTARY_EXP) return 0.0;
    if (a.hi != a.hi) return a.hi;
    const double k = (a.hi * 0x1.71547652b82fep+0 + ELEMENTARY_ROUND) - ELEMENTARY_ROUND;
    elementary_pair r;
    r.hi = mus__exact_sum(a.hi - k * 0x1.62e42fefa38p-1, a.lo - k * 0x1.ef35793c7673p-45, &r.lo);
    const double x = r.hi;
    const double p =
        0x1p-1 +
        x * (0x1.555555555555bp-3 +
             x * (0x1.555555555555cp-5 +
                  x * (0x1.111111110eec4p-7 +
                       x * (0x1.6c16c16c13a4dp-10 +
                            x * (0x1.a01a01b2bc7f5p-13 +
                                 x * (0x1.a01a01b342f43p-16 +
                                      x * (0x1.71ddf1b981ff6p-19 +
                                           x * (0x1.27e4c0fc66504p-22 +
                                                x * (0x1.af697ea42d5d4p-26 + x * 0x1.1f9ba83d87d9ap-29)))))))));
    const elementary_pair e = elementary_add((elementary_pair){1.0, 0.0}, x, x * x * p + r.lo * (1.0 + x));
    /* in two steps, so that neither factor leaves the range of a double; the last product rounds alone */
    const int half = (int)k / 2;
    return (e.hi + e.lo) * elementary_power(half) * elementary_power((int)k - half);
}


/* log x for x above 0 and finite: x = 2^e m, and log m = log c + 2 atanh((m - c) / (m + c)) with c = i / 16 next to m
 */
static elementary_pair elementary_log(double x)
{
    static const elementary_pair log_c[] = {
        {-0x1.7fafa3bd8151cp-2, 0x1.219024acd3b77p-58},  {-0x1.269621134db92p-2, -0x1.e0efadd9db02bp-56},
        {-0x1.a93ed3c8ad9e3p-3, -0x1.bcafa9de97203p-57}, {-0x1.1178e8227e47cp-3, 0x1.0e63a5f01c691p-58},
        {-0x1.08598b59e3a07p-4, 0x1.dd7009902bf32p-58},  {0.0, 0.0},
        {0x1.f0a30c01162a6p-5, 0x1.85f325c5bbacdp-59},   {0x1.e27076e2af2e6p-4, -0x1.61578001e0162p-60},
        {0x1.5ff3070a793d4p-3, -0x1.bc60efafc6f6ep-58},  {0x1.c8ff7c79a9a22p-3, -0x1.4f689f8434012p-57},
        {0x1.1675cababa60ep-2, 0x1.ce63eab883717p-61},   {0x1.4618bc21c5ec2p-2, 0x1.f42decdeccf1dp-56},
        {0x1.739d7f6bbd007p-2, -0x1.8c76ceb014b04p-56},
    };
    const int small = x < 0x1p-1022;
    const double whole = small ? x * 0x1p54 : x;
    uint64_t bits;
    memcpy(&bits, &whole, sizeof bits);
    int e = (int)(bits >> 52) - 1023 - (small ? 54 : 0);
    double m;
    bits = (bits & 0xfffffffffffff) | (uint64_t)1023 << 52;
    memcpy(&m, &bits, sizeof m);
    if (m > 0x1.6a09e667f3bcdp+0) {
        m *= 0.5;
        e++;
    }
    const int i = (int)(16.0 * m + 0.5);
    const double c = 0.0625 * i;
    elementary_pair sum;
    sum.hi = mus__exact_sum(m, c, &sum.lo);
    const elementary_pair s = elementary_quotient((elementary_pair){m - c, 0.0}, sum);
    /* atanh s = s + s^3 P(s^2) for |s| <= 1/44, error 2^-78 */
    const double z = s.hi * s.hi;
    const double p =
        0x1.5555555555555p-2 +
        z * (0x1.999999999991cp-3 + z * (0x1.249249257ddd6p-3 + z * (0x1.c71c59b687742p-4 + z * 0x1.74ebe70588a92p-4)));
    elementary_pair l = elementary_add(log_c[i - 11], e * 0x1.62e42fefa38p-1, e * 0x1.ef35793c7673p-45);
    l = elementary_add(l, 2.0 * s.hi, 2.0 * (s.lo + s.hi * z * p));
    l.hi = mus__exact_sum(l.hi, l.lo, &l.lo);
    return l;
}


double mus__exp(double x)
{
    return elementary_exp((elementary_pair){x, 0.0});
}


double mus__ln(double x)
{
    if (x == 0.0) return -INFINITY;
    if (!(x > 0.0)) return (x - x) / (x - x);
    if (isinf(x)) return x;
    const elementary_pair l = elementary_log(x);
    return l.hi + l.lo;
}


double mus__pow(double x, double y)
{
    if (x == 1.0 || y == 0.0) return 1.0;
    if (x != x || y != y) return x + y;
    const double size = fabs(x);
    const int whole = floor(y) == y, odd = whole && fabs(fmod(y, 2.0)) == 1.0;
    const double sign = signbit(x) && odd ? -1.0 : 1.0;
    if (isinf(y)) return size == 1.0 ? 1.0 : (size > 1.0) == (y > 0.0) ? INFINITY : 0.0;
    if (size == 0.0 || isinf(x)) return sign * ((size == 0.0) == (y < 0.0) ? INFINITY : 0.0);
    if (x < 0.0 && !whole) return (x - x) / (x - x);
    if (size == 1.0) return sign;
    const elementary_pair l = elementary_log(size);
    elementary_pair a = {y * l.hi, 0.0};
    if (fabs(a.hi) < ELEMENTARY_EXP) {
        a.hi = mus__exact_product(y, l.hi, &a.lo);
        a.lo += y * l.lo;
    }
    return sign * elementary_exp(a);
}


/* ---- length ---- */

double mus__hypot(double x, double y)
{
    if (isinf(x) || isinf(y)) return INFINITY;
    const double a = fabs(x), b = fabs(y), most = a > b ? a : b, least = a > b ? b : a;
    if (!(least > ELEMENTARY_TINY * most)) return most + least; /* NaN, too */
    const double scale = most > ELEMENTARY_LARGE          ? 1.0 / ELEMENTARY_SCALE
                         : least < 1.0 / ELEMENTARY_LARGE ? ELEMENTARY_SCALE
                                                          : 1.0;
    elementary_pair square, other;
    square.hi = mus__exact_product(most * scale, most * scale, &square.lo);
    other.hi = mus__exact_product(least * scale, least * scale, &other.lo);
    const elementary_pair root = elementary_root(elementary_add(square, other.hi, other.lo));
    return (root.hi + root.lo) / scale;
}
