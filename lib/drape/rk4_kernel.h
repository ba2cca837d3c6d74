/* rk4_kernel.h: the body of rk4.c, as a template on the floating type (MUS_REAL, MUS_RHS, MUS_RK4). */

void MUS_RK4(int64_t n, MUS_REAL *restrict y, MUS_REAL h, MUS_RHS rhs, void *user, MUS_REAL *restrict work)
{
    MUS_REAL *restrict stage = work, *restrict sum = work + n, *restrict k = work + 2 * n;
    const MUS_REAL half = h / 2, sixth = h / 6;

    /* k1 */
    rhs(user, y, k);
    for (int64_t i = 0; i < n; i++) sum[i] = k[i], stage[i] = y[i] + half * k[i];
    /* k2 */
    rhs(user, stage, k);
    for (int64_t i = 0; i < n; i++) sum[i] += 2 * k[i], stage[i] = y[i] + half * k[i];
    /* k3 */
    rhs(user, stage, k);
    for (int64_t i = 0; i < n; i++) sum[i] += 2 * k[i], stage[i] = y[i] + h * k[i];
    /* k4 */
    rhs(user, stage, k);
    for (int64_t i = 0; i < n; i++) y[i] += sixth * (sum[i] + k[i]);
}
