/*
 * manifold_kernel.h: a node that touches several surfaces at once, as a template on the floating type.
 *
 * Define MUS__REAL and MUS__NAME(name) as for field_kernel.h, then include. Surfaces are half spaces here: outward
 * normal n and `target`, what the node is to be lifted along it (for places), or loses of its speed into it (for
 * velocities).
 *
 * Of one surface the target is granted. Of two with normals n, m and wishes l >= k that one alone does not grant, the
 * move is a (n - m) + b (n + m):
 *
 *   a = (l - k) / |n - m|^2    makes what is left of both alike: between two opposing surfaces that is the middle
 *   b = (l + k) / |n + m|^2    grants both, out of the wedge along its bisector; |b (n + m)| is held below `most`,
 * since the way out of a sharp wedge is long, and there is none between parallel surfaces
 *
 * The two are the one with the largest target, and the one that is worst off after it. What others still miss, beyond
 * what is left of these two, is granted along their normals. So a node is never deeper in one of two surfaces than in
 * the other, the same node always gets the same answer, and the order of surfaces does not count.
 */

/* a surface that a node touches */
typedef struct MUS__NAME(contact) {
    MUS__REAL overlap; /* how far it is nearer than the clearance */
    MUS__REAL friction;
    MUS__REAL normal[3];
    MUS__REAL speed[3]; /* of the surface at the node */
    MUS__REAL from[3];  /* where the node was before the step, carried along with the surface */
} MUS__NAME(contact);


static inline MUS__REAL MUS__NAME(dot)(const MUS__REAL *a, const MUS__REAL *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}


/* the two of the head of this file: move = multiplier[0] n + multiplier[1] m. Returns what is left of both wishes */
static inline MUS__REAL MUS__NAME(manifold_solve_two)(MUS__REAL cosine, MUS__REAL l, MUS__REAL k, MUS__REAL most,
                                                      MUS__REAL *multiplier)
{
    const MUS__REAL apart2 = 2 - 2 * cosine, along2 = 2 + 2 * cosine;
    multiplier[0] = l, multiplier[1] = 0;
    if (k <= cosine * l || apart2 <= 0) return 0;
    const MUS__REAL even = (l - k) / apart2, length = (MUS__REAL)MUS__NAME(sqrt)(along2 > 0 ? along2 : 0);
    MUS__REAL slide = 0;
    if (length > (MUS__REAL)1e-3) slide = (l + k) / length < most ? (l + k) / along2 : most / length;
    multiplier[0] = slide + even, multiplier[1] = slide - even;
    return (l + k) / 2 - slide * along2 / 2;
}


/* move (3) and multiplier (count), the part of it along each normal, for the wishes (count) of surfaces */
static inline void MUS__NAME(manifold_solve)(const MUS__NAME(contact) * list, int32_t count, const MUS__REAL *target,
                                             MUS__REAL most, MUS__REAL *move, MUS__REAL *multiplier)
{
    int32_t first = 0, second = -1;
    MUS__REAL worst = 0, two[2], left = 0;
    for (int32_t i = 0; i < count; i++) {
        multiplier[i] = 0;
        if (target[i] > target[first]) first = i;
    }
    for (int32_t d = 0; d < 3; d++) move[d] = 0;
    if (!(target[first] > 0)) return;
    const MUS__REAL *n = list[first].normal;
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL missed = target[i] - target[first] * MUS__NAME(dot)(n, list[i].normal);
        if (i == first || missed <= worst) continue;
        worst = missed;
        second = i;
    }
    multiplier[first] = target[first];
    if (second >= 0) {
        const MUS__REAL cosine = MUS__NAME(dot)(n, list[second].normal);
        left = MUS__NAME(manifold_solve_two)(cosine, target[first], target[second], most, two);
        multiplier[first] = two[0], multiplier[second] = two[1];
    }
    for (int32_t d = 0; d < 3; d++)
        move[d] = multiplier[first] * n[d] + (second >= 0 ? multiplier[second] * list[second].normal[d] : 0);
    for (int32_t i = 0; i < count; i++) {
        if (i == first || i == second) continue;
        const MUS__REAL missed = target[i] - left - MUS__NAME(dot)(move, list[i].normal);
        if (missed <= 0) continue;
        multiplier[i] = missed;
        for (int32_t d = 0; d < 3; d++) move[d] += missed * list[i].normal[d];
    }
}
