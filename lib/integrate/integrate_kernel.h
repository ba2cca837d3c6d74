/*
 * integrate_kernel.h: the steps and the guarded run of integrate.c, as a template on the floating type.
 *
 * MUS_REAL, MUS_RATE, MUS_ENERGY are types, MUS_FN(name) names the functions. Work space of a run, n numbers each:
 *
 *   RK4      stage | sum | k | last good state
 *   others   k | last good state
 */

/* y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4) */
static void MUS_FN(rk4)(const mus_integrate_def *def, MUS_RATE rate, int64_t n, MUS_REAL *restrict y, int64_t step,
                        MUS_REAL *restrict work)
{
    MUS_REAL *restrict stage = work, *restrict sum = work + n, *restrict k = work + 2 * n;
    const MUS_REAL h = (MUS_REAL)def->step, half = h / 2, sixth = h / 6;
    const double t = integrate_time(def, (double)step), middle = integrate_time(def, (double)step + 0.5);
    const double end = integrate_time(def, (double)step + 1.0);

    /* k1 = f(t, y) */
    rate(def->user, t, y, k);
    for (int64_t i = 0; i < n; i++) sum[i] = k[i], stage[i] = y[i] + half * k[i];
    /* k2 = f(t + h/2, y + h/2 k1) */
    rate(def->user, middle, stage, k);
    for (int64_t i = 0; i < n; i++) sum[i] += 2 * k[i], stage[i] = y[i] + half * k[i];
    /* k3 = f(t + h/2, y + h/2 k2) */
    rate(def->user, middle, stage, k);
    for (int64_t i = 0; i < n; i++) sum[i] += 2 * k[i], stage[i] = y[i] + h * k[i];
    /* k4 = f(t + h, y + h k3) */
    rate(def->user, end, stage, k);
    for (int64_t i = 0; i < n; i++) y[i] += sixth * (sum[i] + k[i]);
}


/* v += h/2 a;  x += h v;  a = a(t + h, x, v);  v += h/2 a. `k` holds the rate at y before, and after */
static void MUS_FN(verlet)(const mus_integrate_def *def, MUS_RATE rate, int64_t n, MUS_REAL *restrict y, int64_t step,
                           MUS_REAL *restrict k)
{
    const int64_t m = n / 2;
    MUS_REAL *restrict x = y, *restrict v = y + m;
    const MUS_REAL *restrict a = k + m;
    const MUS_REAL h = (MUS_REAL)def->step, half = h / 2;
    for (int64_t i = 0; i < m; i++) v[i] += half * a[i], x[i] += h * v[i];
    rate(def->user, integrate_time(def, (double)step + 1.0), y, k);
    for (int64_t i = 0; i < m; i++) v[i] += half * a[i];
}


/* v += h a(t, x, v);  x += h v */
static void MUS_FN(euler)(const mus_integrate_def *def, MUS_RATE rate, int64_t n, MUS_REAL *restrict y, int64_t step,
                          MUS_REAL *restrict k)
{
    const int64_t m = n / 2;
    MUS_REAL *restrict x = y, *restrict v = y + m;
    const MUS_REAL *restrict a = k + m;
    const MUS_REAL h = (MUS_REAL)def->step;
    rate(def->user, integrate_time(def, (double)step), y, k);
    for (int64_t i = 0; i < m; i++) v[i] += h * a[i], x[i] += h * v[i];
}


/* first number that is not finite, or -1. A sum of products with 0 is 0 unless one of them is not */
static int64_t MUS_FN(first_bad)(const MUS_REAL *y, int64_t n)
{
    MUS_REAL sum = 0;
    for (int64_t i = 0; i < n; i++) sum += y[i] * 0;
    for (int64_t i = 0; i < n && !(sum == 0); i++)
        if (!(y[i] * 0 == 0)) return i;
    return -1;
}


/* is the state at step `k` good? The sentence says what is not */
static mus_status MUS_FN(look)(mus_context *context, const mus_integrate_def *def, MUS_ENERGY energy, int64_t n,
                               const MUS_REAL *y, int64_t k, double limit)
{
    const double t = integrate_time(def, (double)k);
    const int64_t bad = MUS_FN(first_bad)(y, n);
    if (bad >= 0)
        return mus__fail(context, MUS_ERR_DIVERGED, "integrate: y[%lld] is %g at step %lld, time %.9g; step %g",
                         (long long)bad, (double)y[bad], (long long)k, t, def->step);
    if (energy == NULL) return MUS_OK;
    const double now = energy(def->user, t, y);
    if (now <= limit) return MUS_OK;
    return mus__fail(context, MUS_ERR_DIVERGED,
                     "integrate: the energy is %g at step %lld, time %.9g, at most %g is allowed; step %g", now,
                     (long long)k, t, limit, def->step);
}


/* energy that ends a run */
static mus_status MUS_FN(limit)(mus_context *context, const mus_integrate_def *def, MUS_ENERGY energy,
                                const MUS_REAL *y, double *limit)
{
    if (energy == NULL) return MUS_OK;
    const double first = fabs(energy(def->user, def->start, y));
    *limit = def->energy_growth * (first > def->energy_floor ? first : def->energy_floor);
    if (mus__finite(first)) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "integrate: the energy at the start is %g", first);
}


/* the run: blocks of guard_every steps, a look and a copy after each */
static mus_status MUS_FN(run)(mus_context *context, const mus_integrate_def *def, MUS_RATE rate, MUS_ENERGY energy,
                              int64_t n, MUS_REAL *y, int64_t steps, MUS_REAL *work, int64_t *done)
{
    const size_t bytes = (size_t)n * sizeof *y;
    MUS_REAL *good = work + (def->method == MUS_METHOD_RK4 ? 3 * n : n);
    const int64_t bad = MUS_FN(first_bad)(y, n);
    double limit = 0.0;
    if (bad >= 0)
        return mus__fail(context, MUS_ERR_ARG, "integrate: y[%lld] is %g at the start", (long long)bad, (double)y[bad]);
    mus_status status = MUS_FN(limit)(context, def, energy, y, &limit);
    if (status != MUS_OK) return status;
    memcpy(good, y, bytes);
    if (def->method == MUS_METHOD_VERLET) rate(def->user, def->start, y, work);

    for (int64_t k = 0; k < steps;) {
        const int64_t until = steps - k < def->guard_every ? steps : k + def->guard_every;
        if (def->method == MUS_METHOD_RK4)
            for (; k < until; k++) MUS_FN(rk4)(def, rate, n, y, k, work);
        else if (def->method == MUS_METHOD_VERLET)
            for (; k < until; k++) MUS_FN(verlet)(def, rate, n, y, k, work);
        else
            for (; k < until; k++) MUS_FN(euler)(def, rate, n, y, k, work);
        status = MUS_FN(look)(context, def, energy, n, y, k, limit);
        if (status != MUS_OK) {
            memcpy(y, good, bytes);
            return status;
        }
        memcpy(good, y, bytes);
        *done = k;
    }
    return MUS_OK;
}
