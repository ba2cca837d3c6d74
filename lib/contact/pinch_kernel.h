/*
 * pinch_kernel.h: a node that surfaces which stand still hold between them: a part of contact_kernel.h, with its macros
 * and its meetings.
 */

#define MUS__PINCH_FACING -0.5 /* cosine of normals of surfaces that stand against each other */
#define MUS__PINCH_DEEP 1e-5   /* [m]: so much deeper than its path took it a node was inside before */
#define MUS__PINCH_NEAR 3e-5   /* [m]: no farther than this from where all surfaces allow it, it is put there and held \
                                */
#define MUS__PINCH_SPEED 0.2   /* of that of `push` */


/* nonzero when surfaces that stand still hold the node between them, deeper than its path took it */
static int32_t MUS__NAME(pinched)(const MUS__NAME(contact) * list, int32_t count, const MUS__REAL *x)
{
    int32_t deep = 0, facing = 0;
    for (int32_t i = 0; i < count; i++) {
        MUS__REAL way[3];
        for (int32_t d = 0; d < 3; d++) {
            if (list[i].speed[d] != 0) return 0;
            way[d] = x[d] - list[i].from[d];
        }
        const MUS__REAL into = -MUS__NAME(dot)(way, list[i].normal);
        deep += list[i].overlap - (into > 0 ? into : 0) > (MUS__REAL)MUS__PINCH_DEEP;
        for (int32_t k = 0; k < i; k++)
            facing |= MUS__NAME(dot)(list[i].normal, list[k].normal) < (MUS__REAL)MUS__PINCH_FACING;
    }
    return deep > 1 || (deep > 0 && facing);
}


/*
 * What is pinched is not put elsewhere: springs hold against that with any force, and what they are stretched by they
 * give back as speed (a sheet between two rollers got 30 J in 20 ms). A pull of bounded size takes it out along `move`,
 * up to a part of the speed of `push`, and friction does not hold it there; it works no more than that times the way.
 */
static void MUS__NAME(pinch_release)(const mus__contact_rule *rule, MUS__REAL time, const MUS__REAL *move,
                                     MUS__REAL far, MUS__REAL *v)
{
    if (!(far > 0) || !(time > 0)) return;
    const MUS__REAL left = (MUS__REAL)MUS__PINCH_SPEED * (MUS__REAL)rule->push / time - MUS__NAME(dot)(v, move) / far;
    const MUS__REAL pull = (MUS__REAL)rule->pull * time, more = pull < left ? pull : left;
    for (int32_t d = 0; d < 3 && more > 0; d++) v[d] += more * move[d] / far;
}
