/*
 * pinch_kernel.h: a node held between surfaces at rest that face each other, a part of response_kernel.h.
 *
 * A pinched node is not put elsewhere. Springs hold against a displacement with any force, and give back as speed what
 * they were stretched by (measured: a sheet between two rollers gained 30 J in 20 ms). A pull of bounded size takes the
 * node out instead; its work is at most that pull times the way.
 */

/* [m] a node deeper by this than its path took it was inside before; chosen */
#define MUS__PINCH_DEEP 1e-5
/* [m] a node no further than this from where all surfaces allow it is put there; chosen */
#define MUS__PINCH_NEAR 3e-5
#define MUS__PINCH_SPEED 0.2 /* of the speed of `push`: a pinched node is drawn out no faster; chosen */


/* nonzero when surfaces at rest hold the node at x between them, deeper than its path took it */
static int32_t MUS__NAME(pinched)(const MUS__NAME(contact) * list, int32_t count, const MUS__REAL *x)
{
    int32_t deep = 0, facing = 0;
    for (int32_t i = 0; i < count; i++) {
        MUS__REAL way[3];
        for (int32_t d = 0; d < 3; d++) {
            if (list[i].velocity[d] != 0) return 0;
            way[d] = x[d] - list[i].from[d];
        }
        const MUS__REAL into = -MUS__NAME(dot)(way, list[i].normal);
        deep += list[i].overlap - (into > 0 ? into : 0) > (MUS__REAL)MUS__PINCH_DEEP;
        for (int32_t k = 0; k < i; k++)
            facing |= MUS__NAME(dot)(list[i].normal, list[k].normal) < (MUS__REAL)MUS__PINCH_FACING;
    }
    return deep > 1 || (deep > 0 && facing);
}


/* draws a pinched node with velocity v (3) out along `move`, of length `far`, for `time` [s] */
static void MUS__NAME(pinch_release)(const mus__contact_rule *rule, MUS__REAL time, const MUS__REAL *move,
                                     MUS__REAL far, MUS__REAL *v)
{
    if (!(far > 0) || !(time > 0)) return;
    const MUS__REAL left = (MUS__REAL)MUS__PINCH_SPEED * (MUS__REAL)rule->push / time - MUS__NAME(dot)(v, move) / far;
    const MUS__REAL pull = (MUS__REAL)rule->pull * time, more = pull < left ? pull : left;
    for (int32_t d = 0; d < 3 && more > 0; d++) v[d] += more * move[d] / far;
}
