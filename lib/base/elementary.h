/*
 * elementary.h: sine to logarithm by a source of our own.
 *
 * IEEE 754 fixes + - * / and the square root, so every machine gives the same bits for them. It does not fix the
 * functions below: each C library rounds them in its own way. The libraries call these alone (tests/guard/own_math.sh),
 * so the same bits come out of every C library, compiler and machine. From <math.h> they take only functions whose
 * result is exact or fixed: fabs, sqrt, floor, ceil, fmin, fmax, fmod, copysign, lround, nearbyint.
 *
 * Arguments and results are those of C11 7.12 (NaN, infinities, signs of zero); errno and the exception flags are not
 * promised. Every function needs rounding to nearest. Errors are below 1 ulp (unit in the last place): measured against
 * MPFR by `make elementary`, which also prints the time of each function beside that of the C library.
 */
#ifndef MUS_BASE_ELEMENTARY_H
#define MUS_BASE_ELEMENTARY_H

#define MUS_PI 3.14159265358979323846 /* half a turn [rad], to the last bit of a double */

/* x [rad]; beyond 2^20 rad x is first reduced by fmod with the double next to 2 pi: the error is then 4e-17 |x| rad */
double mus__sin(double x);
double mus__cos(double x);
double mus__tan(double x);
/* [rad] */
double mus__asin(double x);
double mus__acos(double x);
double mus__atan2(double y, double x);
double mus__exp(double x);
double mus__ln(double x); /* natural logarithm */
double mus__pow(double x, double y);
double mus__hypot(double x, double y);

#endif
