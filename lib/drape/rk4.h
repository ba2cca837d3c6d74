/*
 * rk4.h: classical Runge-Kutta of order 4 on one flat state, in float and double. Knows nothing of cloth.
 *
 *   k1 = f(y)            k2 = f(y + h/2 k1)      k3 = f(y + h/2 k2)      k4 = f(y + h k3)
 *   y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4)
 *
 * Source: Metaaphanon and Kanongchaiyos 2005, eq. 5; Hairer, Norsett, Wanner, Solving ODEs I, 1993, II.1.
 */
#ifndef MUS_DRAPE_RK4_H
#define MUS_DRAPE_RK4_H

#include <stdint.h>

/* dy (n) = f(y) */
typedef void (*mus__rhs_f32)(void *user, const float *y, float *dy);
typedef void (*mus__rhs_f64)(void *user, const double *y, double *dy);

/* advance y (n) by h in place; work (3n) */
void mus__rk4_f32(int64_t n, float *y, float h, mus__rhs_f32 rhs, void *user, float *work);
void mus__rk4_f64(int64_t n, double *y, double h, mus__rhs_f64 rhs, void *user, double *work);

#endif
