/*
 * friction_kernel.h: friction of a node on a surface, a part of contact_kernel.h.
 */

/* how a node came here */
typedef struct MUS__NAME(path) {
    const MUS__REAL *from; /* (3) where it was */
    MUS__REAL time;        /* how long it moved */
    MUS__REAL slip;        /* the part of that for which friction's impulse would have acted */
} MUS__NAME(path);


/* friction: what a normal impulse `inward` takes of the velocity v, and of the way x - from along the skin; one that
 * sticks, as far off the skin as it was, is put back to the last bit */
static inline void MUS__NAME(friction)(MUS__REAL friction, const MUS__NAME(path) * path, MUS__REAL inward,
                                       const MUS__REAL *normal, MUS__REAL *x, MUS__REAL *v)
{
    MUS__REAL t[3], way[3], along = 0;
    for (int32_t i = 0; i < 3; i++) {
        t[i] = v[i] + inward * normal[i];
        way[i] = x[i] - path->from[i];
        along += way[i] * normal[i];
    }
    for (int32_t i = 0; i < 3; i++) way[i] -= along * normal[i];
    const MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    const MUS__REAL length = (MUS__REAL)MUS__NAME(sqrt)(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    const MUS__REAL loss = friction * inward, back = path->slip > 0 ? loss * path->slip : 0;
    const MUS__REAL keep = speed > loss ? (speed - loss) / speed : 0, part = length > back ? back / length : 1;
    const MUS__REAL off = along < 0 ? -along : along;
    const int32_t held = part == 1 && off <= (MUS__REAL)MUS__STICK_BAND;
    for (int32_t i = 0; i < 3; i++) {
        v[i] = keep * t[i];
        x[i] = held ? path->from[i] : x[i] - part * way[i];
    }
}

/* friction of one of several surfaces: its part of the normal impulse, `inward`, takes of the velocity along it and of
 * the way along it. Nonzero when it took all of the way */
static int32_t MUS__NAME(friction_of_one)(const MUS__NAME(contact) * m, MUS__REAL inward, MUS__REAL slip, MUS__REAL *x,
                                          MUS__REAL *v)
{
    MUS__REAL t[3], way[3];
    for (int32_t d = 0; d < 3; d++) t[d] = v[d] - m->speed[d], way[d] = x[d] - m->from[d];
    const MUS__REAL out = MUS__NAME(dot)(t, m->normal), along = MUS__NAME(dot)(way, m->normal);
    for (int32_t d = 0; d < 3; d++) t[d] -= out * m->normal[d], way[d] -= along * m->normal[d];
    const MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(t, t));
    const MUS__REAL length = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(way, way));
    const MUS__REAL loss = m->friction * inward, back = slip > 0 ? loss * slip : 0;
    const MUS__REAL keep = speed > loss ? (speed - loss) / speed : 0, part = length > back ? back / length : 1;
    for (int32_t d = 0; d < 3; d++) v[d] -= (1 - keep) * t[d], x[d] -= part * way[d];
    return part == 1;
}
