/*
 * contact_manifold_kernel.h: a node that touches several surfaces at once: a template taken in by contact_template.h.
 *
 * A surface is a half space here, with outward normal n and `target`: how far the node is to be moved along n (solving
 * for places), or what it is to lose of its velocity into the surface (solving for velocities).
 *
 * One surface gets its target. Two with normals n, m and targets l >= k that the first alone does not meet get the move
 * a (n - m) + b (n + m):
 *
 *   a = (l - k) / |n - m|^2   makes what is left of both alike: between two opposing surfaces that is the middle
 *   b = (l + k) / |n + m|^2   meets both, out of the wedge along its bisector; |b (n + m)| is held below `limit`,
 *                             since the way out of a sharp wedge is long, and there is none between parallel surfaces
 *
 * The two are the one with the largest target, and the one that misses most after it. What others still miss, beyond
 * what is left of these two, is added along their normals. So a node is never deeper in one of two surfaces than in the
 * other, the same node always gets the same move, and the order of surfaces does not count (an iteration over the
 * surfaces, projected Gauss-Seidel, has neither property).
 */

/* |n + m| below this: the surfaces face each other and there is no way out between them */
#define MUS__WEDGE_MIN 1e-3

/* a contact of a node with a surface */
typedef struct MUS__NAME(contact) {
    MUS__REAL overlap; /* how far the node is inside the clearance [m] */
    MUS__REAL friction;
    MUS__REAL normal[3];
    MUS__REAL velocity[3]; /* of the surface at the node */
    MUS__REAL from[3];     /* place of the node before the step, carried along with the surface */
} MUS__NAME(contact);


static inline MUS__REAL MUS__NAME(dot)(const MUS__REAL *a, const MUS__REAL *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}


/* multipliers (2) of two surfaces: move = multiplier[0] n + multiplier[1] m, with cosine = n . m. Returns what is left
 * of both targets l >= k */
static inline MUS__REAL MUS__NAME(manifold_solve_two)(MUS__REAL cosine, MUS__REAL l, MUS__REAL k, MUS__REAL limit,
                                                      MUS__REAL *multiplier)
{
    const MUS__REAL apart2 = 2 - 2 * cosine, along2 = 2 + 2 * cosine;
    multiplier[0] = l, multiplier[1] = 0;
    if (k <= cosine * l || apart2 <= 0) return 0;
    const MUS__REAL even = (l - k) / apart2, length = (MUS__REAL)MUS__NAME(sqrt)(along2 > 0 ? along2 : 0);
    MUS__REAL slide = 0;
    if (length > (MUS__REAL)MUS__WEDGE_MIN) slide = (l + k) / length < limit ? (l + k) / along2 : limit / length;
    multiplier[0] = slide + even, multiplier[1] = slide - even;
    return (l + k) / 2 - slide * along2 / 2;
}


/* move (3) of a node for the targets (count) of its contacts, and multiplier (count): the part of it along each normal
 */
static inline void MUS__NAME(manifold_solve)(const MUS__NAME(contact) * list, int32_t count, const MUS__REAL *target,
                                             MUS__REAL limit, MUS__REAL *move, MUS__REAL *multiplier)
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
        left = MUS__NAME(manifold_solve_two)(cosine, target[first], target[second], limit, two);
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
