/*
 * query_batch_kernel.h: many nodes asked of a part at once, a part of contact_kernel.h.
 *
 * The query of field_kernel.h for places in a row, without a branch, so that it is made for as many nodes at once as
 * the vector unit is wide; the same operations in the same order, so the same bits. What is in a cap, beyond the first
 * or the last ring, is asked in a row of its own.
 */

#define MUS__CHUNK 256   /* nodes */
#define MUS__BATCH_MIN 2 /* less are asked one by one */
#define MUS__QUERY_CAP 2 /* state of a node that is in a cap: 0 is not near, 1 near */

/* an answer for a node; next: of the same node's, by part ascending; 0 ends */
typedef struct MUS__NAME(query_result) {
    MUS__REAL depth, normal[3];
    int32_t part, next;
} MUS__NAME(query_result);

typedef struct MUS__NAME(query_batch) {
    MUS__REAL place[3 * MUS__CHUNK];
    MUS__REAL found[4 * MUS__CHUNK]; /* depth, normal */
    int32_t state[MUS__CHUNK];
    uint8_t who[MUS__PARTS_MAX][MUS__CHUNK];    /* nodes in the box of each part */
    int32_t head[MUS__CHUNK], most[MUS__CHUNK]; /* of each node: its first answer, how many it has */
    int32_t answers;
    MUS__NAME(query_result) answer[1 + MUS__CHUNK * MUS__MANIFOLD_MAX];
} MUS__NAME(query_batch);


/* depth and normal (4 planes of MUS__CHUNK) of `count` places (3 planes) in a field, and their state. A place beyond the
 * first or the last ring gets a number that nothing reads */
MUS_CLONES
static void MUS__NAME(query_batch_between)(const MUS__NAME(field) * field, int32_t count, MUS__REAL margin,
                                           const MUS__REAL *restrict place, MUS__REAL *restrict found,
                                           int32_t *restrict state)
{
    const MUS__NAME(field) f = *field;
    const MUS__REAL pole0 = f.pole[0], pole1 = f.pole[1];
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL p[3] = {place[i], place[MUS__CHUNK + i], place[2 * MUS__CHUNK + i]};
        MUS__REAL local[3], normal[3];
        MUS__NAME(field_place) at;
        MUS__NAME(field_local)(&f, p, local);
        const MUS__REAL u = local[0] * f.ds_inverse, before = pole0 - local[0], after = local[0] - pole1;
        const MUS__REAL beyond = local[0] > 0 ? after : before;
        const int32_t inside = (u >= 0) & (u < f.ring_last);

        /* the product is finite, for the place is in the part's box */
        MUS__NAME(field_between)(&f, u * (MUS__REAL)inside, local[1], local[2], margin, &at);
        found[i] = MUS__NAME(field_depth_between)(&f, &at, normal);
        for (int32_t d = 0; d < 3; d++) found[(d + 1) * MUS__CHUNK + i] = normal[d];
        const int32_t near = at.rho2 <= at.reach * at.reach, cap = (beyond <= margin) * MUS__QUERY_CAP;
        state[i] = cap + inside * (near - cap);
    }
}


/* the same of places in the caps of a field, which are not far beyond its first or its last ring */
MUS_CLONES
static void MUS__NAME(query_batch_caps)(const MUS__NAME(field) * field, int32_t count, MUS__REAL margin,
                                        const MUS__REAL *restrict place, MUS__REAL *restrict found,
                                        int32_t *restrict state)
{
    const MUS__NAME(field) f = *field;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL p[3] = {place[i], place[MUS__CHUNK + i], place[2 * MUS__CHUNK + i]};
        MUS__REAL local[3], normal[3];
        MUS__NAME(field_place) at;
        MUS__NAME(field_local)(&f, p, local);
        const int32_t end = local[0] > 0;
        MUS__NAME(field_at_cap)(&f, end, local[1], local[2], margin, &at);
        found[i] = MUS__NAME(field_depth_in_cap)(&f, &at, end, local[0], normal);
        for (int32_t d = 0; d < 3; d++) found[(d + 1) * MUS__CHUNK + i] = normal[d];
        state[i] = at.rho2 <= at.reach * at.reach;
    }
}


/* what part l answered to `m` nodes of a block, who (m): those that are near keep it, of others the part is taken out
 * of `in`; nodes that are left stay at the front of who. Their number */
static int32_t MUS__NAME(query_batch_keep)(int32_t l, int32_t m, uint8_t *who, uint64_t *in,
                                           MUS__NAME(query_batch) * batch, int64_t *queries)
{
    int32_t left = 0;
    for (int32_t k = 0; k < m; k++) {
        const int32_t i = who[k];
        if (batch->state[k] == MUS__QUERY_CAP) {
            who[left++] = (uint8_t)i;
            continue;
        }
        (*queries)++;
        if (batch->state[k] == 0) in[i] &= ~((uint64_t)1 << l);
        if (batch->state[k] == 0 || batch->most[i] == MUS__MANIFOLD_MAX) continue;
        MUS__NAME(query_result) *answer = &batch->answer[batch->answers];
        answer->depth = batch->found[k];
        for (int32_t d = 0; d < 3; d++) answer->normal[d] = batch->found[(d + 1) * MUS__CHUNK + k];
        answer->part = l;
        answer->next = batch->head[i];
        batch->head[i] = batch->answers++;
        batch->most[i]++;
    }
    return left;
}


/* the nodes of a block asked of the parts whose boxes they are in, `in` (count) a bit each; bits of parts that are not
 * near are taken out, of those that are the answers are kept. x planes from the block's first node on */
static void MUS__NAME(query_batch_chunk)(const mus__collider *collider, MUS__REAL margin, int64_t n, int32_t count,
                                         const MUS__REAL *x, uint64_t *in, MUS__NAME(query_batch) * batch,
                                         int64_t *queries)
{
    int32_t members[MUS__PARTS_MAX];
    for (int32_t l = 0; l < collider->nparts; l++) members[l] = 0;
    for (int32_t i = 0; i < count; i++) {
        batch->head[i] = batch->most[i] = 0;
        for (uint64_t bits = in[i]; bits != 0; bits &= bits - 1) {
            const int32_t l = mus__lowest_bit(bits);
            batch->who[l][members[l]++] = (uint8_t)i;
        }
    }
    batch->answers = 1;

    /* the last part first: the lists then begin with the first. A few nodes are not worth a row */
    for (int32_t l = collider->nparts - 1; l >= 0; l--) {
        const int32_t m = members[l];
        uint8_t *who = batch->who[l];
        if (m < MUS__BATCH_MIN) continue;
        for (int64_t d = 0; d < 3; d++)
            for (int32_t k = 0; k < m; k++) batch->place[d * MUS__CHUNK + k] = x[d * n + who[k]];
        MUS__NAME(query_batch_between)
        (&collider->MUS__PART_FIELDS[l], m, margin, batch->place, batch->found, batch->state);
        const int32_t left = MUS__NAME(query_batch_keep)(l, m, who, in, batch, queries);
        if (left == 0) continue;
        for (int64_t d = 0; d < 3; d++)
            for (int32_t k = 0; k < left; k++) batch->place[d * MUS__CHUNK + k] = x[d * n + who[k]];
        MUS__NAME(query_batch_caps)
        (&collider->MUS__PART_FIELDS[l], left, margin, batch->place, batch->found, batch->state);
        MUS__NAME(query_batch_keep)(l, left, who, in, batch, queries);
    }
}
