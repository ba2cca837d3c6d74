/*
 * friction_kernel.h: Coulomb friction, decided here for every contact: a template taken in by contact_template.h.
 *
 * A contact that gives a node the normal impulse N (per mass [m/s]) takes from its sliding velocity t at most mu N:
 *
 *   |t| <= mu N: the node sticks, t' = 0;   else it slides, t' = t (1 - mu N / |t|)
 *
 * The step that led to the contact moved the node along the surface with the velocity that it had before the impulse.
 * So friction takes back `slip` [s] times mu N of that way too, and no more than all of it: what sticks does not creep,
 * in float not even by rounding. All is relative to the surface: places to where it has carried the node from,
 * velocities to its own at the node.
 *
 * Used by response_kernel.h (one surface, also in a batch; and each surface of a manifold), plane_cache_kernel.h and
 * self_response_kernel.h, and by the residual of lib/drape, where the same cone bounds a force.
 */


/* share of a sliding velocity (or force) of size `size` that is kept when at most `bound` can be taken */
static MUS_INLINE MUS__REAL MUS__NAME(friction_keep)(MUS__REAL size, MUS__REAL bound)
{
    const MUS__REAL by = size > bound ? size : 1, kept = (size - bound) / by; /* both sides: no branch in a batch */
    return size > bound ? kept : 0;
}


/* share of it that is taken: 1 - friction_keep() but for rounding */
static MUS_INLINE MUS__REAL MUS__NAME(friction_take)(MUS__REAL size, MUS__REAL bound)
{
    const MUS__REAL by = size > bound ? size : 1, taken = bound / by;
    return size > bound ? taken : 1;
}


/* what friction makes of a node's sliding */
typedef struct MUS__NAME(sliding) {
    MUS__REAL t[3], keep;          /* sliding velocity; share that is kept */
    MUS__REAL way[3], take, along; /* way along the surface; share that is taken back; way along the normal */
} MUS__NAME(sliding);


/* out: sliding of a node at x with velocity v, which was at `from` before the step (all relative to the surface), under
 * a normal impulse `impulse` */
static MUS_INLINE void MUS__NAME(friction)(MUS__REAL coefficient, MUS__REAL impulse, MUS__REAL slip,
                                           const MUS__REAL *normal, const MUS__REAL *from, const MUS__REAL *x,
                                           const MUS__REAL *v, MUS__NAME(sliding) * out)
{
    MUS__REAL *t = out->t, *way = out->way;
    for (int32_t d = 0; d < 3; d++) way[d] = x[d] - from[d];
    const MUS__REAL vn = MUS__NAME(dot)(v, normal), along = MUS__NAME(dot)(way, normal);
    for (int32_t d = 0; d < 3; d++) t[d] = v[d] - vn * normal[d], way[d] -= along * normal[d];
    const MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(t, t));
    const MUS__REAL length = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(way, way));
    const MUS__REAL loss = coefficient * impulse, back = slip > 0 ? loss * slip : 0;
    out->keep = MUS__NAME(friction_keep)(speed, loss);
    out->take = MUS__NAME(friction_take)(length, back);
    out->along = along;
}
