/*
 * query_batch_kernel.h: the nodes of a chunk asked of the parts in whose boxes they are, a part of contact_kernel.h.
 *
 * The query of limb/radius_field_kernel.h in a loop over nodes that are in one part's box, without a branch, so that it
 * becomes vectors. Nodes in a cap, beyond the first or the last ring, are asked in a loop of their own.
 */

#define MUS__BATCH_MIN 2 /* nodes; fewer are not worth the copies and are asked one by one */
#define MUS__QUERY_CAP 2 /* state of a node that is in a cap; else 0: not near, 1: near */

/* depth and normal of a node below a part; next: another result of the same node, by part ascending; 0 ends */
typedef struct MUS__NAME(query_result) {
    MUS__REAL depth, normal[3];
    int32_t part, next;
} MUS__NAME(query_result);

typedef struct MUS__NAME(query_batch) {
    MUS__REAL place[3 * MUS__CHUNK];
    MUS__REAL found[4 * MUS__CHUNK]; /* depth, normal */
    int32_t state[MUS__CHUNK];
    uint8_t who[MUS__PARTS_MAX][MUS__CHUNK];    /* nodes in the box of each part */
    int32_t head[MUS__CHUNK], many[MUS__CHUNK]; /* of each node: its first result, how many it has */
    int32_t results;
    MUS__NAME(query_result) result[1 + MUS__CHUNK * MUS__MANIFOLD_MAX];
} MUS__NAME(query_batch);


/* depth and normal (4 planes of MUS__CHUNK) of `count` places (3 planes) in a field, and their state. A place beyond
 * the first or the last ring gets a number that nothing reads */
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


/* the results of `m` nodes, who (m), of part l: those that are near keep theirs, from others the part is taken out of
 * the chunk's; nodes in a cap move to the front of who. Returns the number of these */
static int32_t MUS__NAME(query_batch_keep)(const mus__contact_nodes *nodes, MUS__NAME(chunk) * chunk, int32_t l,
                                           int32_t m, uint8_t *who, MUS__NAME(query_batch) * batch, int64_t *queries)
{
    int32_t left = 0;
    for (int32_t k = 0; k < m; k++) {
        const int32_t i = who[k];
        if (batch->state[k] == MUS__QUERY_CAP) {
            who[left++] = (uint8_t)i;
            continue;
        }
        (*queries)++;
        if (batch->state[k] == 0) chunk->parts[i] &= ~((uint64_t)1 << l);
        if (batch->state[k] == 0 || batch->many[i] == MUS__MANIFOLD_MAX) continue;
        MUS__NAME(query_result) *result = &batch->result[batch->results];
        result->depth = batch->found[k] + (MUS__REAL)mus__contact_lift(nodes, chunk->start + i);
        for (int32_t d = 0; d < 3; d++) result->normal[d] = batch->found[(d + 1) * MUS__CHUNK + k];
        result->part = l;
        result->next = batch->head[i];
        batch->head[i] = batch->results++;
        batch->many[i]++;
    }
    return left;
}


/* places of `m` nodes, who (m), of a chunk; x planes (3 x n) from its first node on */
static inline void MUS__NAME(query_batch_gather)(int64_t n, int32_t m, const uint8_t *who, const MUS__REAL *x,
                                                 MUS__NAME(query_batch) * batch)
{
    for (int64_t d = 0; d < 3; d++)
        for (int32_t k = 0; k < m; k++) batch->place[d * MUS__CHUNK + k] = x[d * n + who[k]];
}


/* asks the nodes of a chunk of their parts; parts that are not near are taken out of chunk->parts */
static void MUS__NAME(query_batch_chunk)(const MUS__NAME(pass) * pass, MUS__NAME(chunk) * chunk,
                                         MUS__NAME(query_batch) * batch)
{
    const int64_t n = pass->nodes->n;
    const MUS__REAL *x = (const MUS__REAL *)pass->nodes->x + chunk->start, margin = pass->surfaces.margin;
    int64_t *queries = &pass->tally->queries;
    int32_t members[MUS__PARTS_MAX];
    for (int32_t l = 0; l < pass->collider->nparts; l++) members[l] = 0;
    for (int32_t i = 0; i < chunk->count; i++) {
        batch->head[i] = batch->many[i] = 0;
        for (uint64_t bits = chunk->parts[i]; bits != 0; bits &= bits - 1) {
            const int32_t l = mus__lowest_bit(bits);
            batch->who[l][members[l]++] = (uint8_t)i;
        }
    }
    batch->results = 1;

    /* the last part first: the lists then begin with the first */
    for (int32_t l = pass->collider->nparts - 1; l >= 0; l--) {
        const int32_t m = members[l];
        uint8_t *who = batch->who[l];
        if (m < MUS__BATCH_MIN) continue;
        MUS__NAME(query_batch_gather)(n, m, who, x, batch);
        MUS__NAME(query_batch_between)(&pass->field[l], m, margin, batch->place, batch->found, batch->state);
        const int32_t left = MUS__NAME(query_batch_keep)(pass->nodes, chunk, l, m, who, batch, queries);
        if (left == 0) continue;
        MUS__NAME(query_batch_gather)(n, left, who, x, batch);
        MUS__NAME(query_batch_caps)(&pass->field[l], left, margin, batch->place, batch->found, batch->state);
        MUS__NAME(query_batch_keep)(pass->nodes, chunk, l, left, who, batch, queries);
    }
}
