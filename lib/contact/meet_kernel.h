/*
 * meet_kernel.h: a node that touches several surfaces at once, as a template on the floating type.
 *
 * Define MUS_REAL and MUS_FIELD(name) as for field_kernel.h, then include. Surfaces are half spaces here: outward
 * normal n and `wish`, what the node is to be lifted along it (for places), or loses of its speed into it (for
 * velocities).
 *
 * Of one surface the wish is granted. Of two with normals n, m and wishes l >= k that one alone does not grant, the
 * move is a (n - m) + b (n + m):
 *
 *   a = (l - k) / |n - m|^2    makes what is left of both alike: between two opposing surfaces that is the middle
 *   b = (l + k) / |n + m|^2    grants both, out of the wedge along its bisector; |b (n + m)| is held below `most`,
 * since the way out of a sharp wedge is long, and there is none between parallel surfaces
 *
 * The two are the one with the largest wish, and the one that is worst off after it. What others still miss, beyond
 * what is left of these two, is granted along their normals. So a node is never deeper in one of two surfaces than in
 * the other, the same node always gets the same answer, and the order of surfaces does not count.
 */

/* a surface that a node touches */
typedef struct MUS_FIELD(meeting) {
    MUS_REAL lift; /* how far it is nearer than the clearance */
    MUS_REAL friction;
    MUS_REAL normal[3];
    MUS_REAL speed[3]; /* of the surface at the node */
    MUS_REAL from[3];  /* where the node was before the step, carried along with the surface */
} MUS_FIELD(meeting);


static inline MUS_REAL MUS_FIELD(dot)(const MUS_REAL *a, const MUS_REAL *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}


/* the two of the head of this file: move = share[0] n + share[1] m. Returns what is left of both wishes */
static inline MUS_REAL MUS_FIELD(out_of_two)(MUS_REAL cosine, MUS_REAL l, MUS_REAL k, MUS_REAL most, MUS_REAL *share)
{
    const MUS_REAL apart2 = 2 - 2 * cosine, along2 = 2 + 2 * cosine;
    share[0] = l, share[1] = 0;
    if (k <= cosine * l || apart2 <= 0) return 0;
    const MUS_REAL even = (l - k) / apart2, length = (MUS_REAL)MUS_FIELD(sqrt)(along2 > 0 ? along2 : 0);
    MUS_REAL slide = 0;
    if (length > (MUS_REAL)1e-3) slide = (l + k) / length < most ? (l + k) / along2 : most / length;
    share[0] = slide + even, share[1] = slide - even;
    return (l + k) / 2 - slide * along2 / 2;
}


/* move (3) and share (count), the part of it along each normal, for the wishes (count) of surfaces */
static inline void MUS_FIELD(out_of_all)(const MUS_FIELD(meeting) * list, int32_t count, const MUS_REAL *wish,
                                         MUS_REAL most, MUS_REAL *move, MUS_REAL *share)
{
    int32_t first = 0, second = -1;
    MUS_REAL worst = 0, two[2], left = 0;
    for (int32_t i = 0; i < count; i++) {
        share[i] = 0;
        if (wish[i] > wish[first]) first = i;
    }
    for (int32_t d = 0; d < 3; d++) move[d] = 0;
    if (!(wish[first] > 0)) return;
    const MUS_REAL *n = list[first].normal;
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL missed = wish[i] - wish[first] * MUS_FIELD(dot)(n, list[i].normal);
        if (i == first || missed <= worst) continue;
        worst = missed;
        second = i;
    }
    share[first] = wish[first];
    if (second >= 0) {
        const MUS_REAL cosine = MUS_FIELD(dot)(n, list[second].normal);
        left = MUS_FIELD(out_of_two)(cosine, wish[first], wish[second], most, two);
        share[first] = two[0], share[second] = two[1];
    }
    for (int32_t d = 0; d < 3; d++)
        move[d] = share[first] * n[d] + (second >= 0 ? share[second] * list[second].normal[d] : 0);
    for (int32_t i = 0; i < count; i++) {
        if (i == first || i == second) continue;
        const MUS_REAL missed = wish[i] - left - MUS_FIELD(dot)(move, list[i].normal);
        if (missed <= 0) continue;
        share[i] = missed;
        for (int32_t d = 0; d < 3; d++) move[d] += missed * list[i].normal[d];
    }
}
