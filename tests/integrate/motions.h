/* motions.h: rate functions with known answers, shared by the tests of the integrators. */
#ifndef MUS_TESTS_MOTIONS_H
#define MUS_TESTS_MOTIONS_H

#include "muslin/integrate.h"

#define GRAVITY 9.81

/* x'' = -omega^2 x - 2 zeta omega x'; y = (x, v) */
typedef struct motion_spring {
    double omega, zeta;
    int64_t evaluations;
} motion_spring;

void motion_spring_rate(void *user, double t, const double *y, double *dy);
void motion_spring_rate32(void *user, double t, const float *y, float *dy);
/* (v^2 + omega^2 x^2) / 2 */
double motion_spring_energy(void *user, double t, const double *y);
double motion_spring_energy32(void *user, double t, const float *y);

/* a mass on a spring that swings: y = (x, y, vx, vy), m = 1, l = 1, hung at the origin; gravity down y */
typedef struct motion_pendulum {
    double k;
} motion_pendulum;

void motion_pendulum_rate(void *user, double t, const double *y, double *dy);
/* kinetic + elastic + potential, 0 at the lowest point of the unstretched rod */
double motion_pendulum_energy(void *user, double t, const double *y);

/* x'' = -g */
void motion_fall_rate(void *user, double t, const double *y, double *dy);

/* `steps` steps of `def` from y, in a context of its own; fails the test on an error */
void motion_run(const mus_integrate_def *def, int64_t n, double *y, int64_t steps);

/* a def with a rate and its user */
mus_integrate_def motion_def(int32_t method, double step, mus_rate_fn rate, void *user);

#endif
