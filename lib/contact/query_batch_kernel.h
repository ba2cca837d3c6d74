/*
 * query_batch_kernel.h: many nodes asked of a part at once, a part of contact_kernel.h.
 *
 * The query of field_kernel.h for places in a row, without a branch, so that it is made for as many nodes at once as
 * the vector unit is wide; the same operations in the same order, so the same bits. What is in a cap, beyond the first
 * or the last ring, is asked in a row of its own.
 */

#define MUS__CHUNK 256   /* nodes */
#define MUS__BATCH_MIN 2 /* less are asked one by one */
#define MUS__BATCH_TINY ((MUS__REAL)1e-15)
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


/* depth and normal (4 planes of MUS__CHUNK) of `count` places (3 planes) in a field, and their state */
MUS_CLONES
static void MUS__NAME(query_batch_rings)(const MUS__NAME(field) * f, int32_t count, MUS__REAL margin,
                                         const MUS__REAL *restrict place, MUS__REAL *restrict found,
                                         int32_t *restrict state)
{
    const MUS__REAL o0 = f->origin[0], o1 = f->origin[1], o2 = f->origin[2];
    const MUS__REAL x0 = f->axis[0], x1 = f->axis[1], x2 = f->axis[2];
    const MUS__REAL y0 = f->side[0], y1 = f->side[1], y2 = f->side[2];
    const MUS__REAL z0 = f->front[0], z1 = f->front[1], z2 = f->front[2];
    const MUS__REAL s0 = f->s0, ds_inverse = f->ds_inverse, ring_last = f->ring_last, angle_scale = f->angle_scale;
    const MUS__REAL *restrict centre = f->centre, *restrict table = f->radius, *restrict largest = f->largest;
    const MUS__REAL pole0 = f->pole[0], pole1 = f->pole[1];
    const int32_t n = f->nangle;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL rx = place[i] - o0, ry = place[MUS__CHUNK + i] - o1, rz = place[2 * MUS__CHUNK + i] - o2;
        const MUS__REAL s = rx * x0 + ry * x1 + rz * x2 - s0;
        const MUS__REAL a = rx * y0 + ry * y1 + rz * y2, b = rx * z0 + ry * z1 + rz * z2;
        const MUS__REAL whole = s * ds_inverse, before = pole0 - s, after = s - pole1;
        const MUS__REAL beyond = s > 0 ? after : before;
        const int32_t inside = (whole >= 0) & (whole < ring_last);
        const MUS__REAL u = whole * (MUS__REAL)inside; /* in a box: finite */
        const int32_t k = (int32_t)u;
        const MUS__REAL t = u - (MUS__REAL)k;

        const MUS__REAL c0 = centre[2 * k], c1 = centre[2 * k + 1];
        const MUS__REAL dca = centre[2 * k + 2] - c0, dcb = centre[2 * k + 3] - c1;
        const MUS__REAL ua = a - (c0 + t * dca), ub = b - (c1 + t * dcb);
        const MUS__REAL rho2 = ua * ua + ub * ub, reach = largest[k] + 4 * margin;

        const MUS__REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
        const MUS__REAL inverse = 1 / (absa + absb + MUS__BATCH_TINY);
        const int32_t left = ua < 0, back = ub < 0, quarter = 3 * back + left - 2 * (back & left);
        const MUS__REAL part = left != back ? absa : absb, q = (MUS__REAL)quarter + part * inverse;
        const MUS__REAL step = q * angle_scale;
        const int32_t whole_j = (int32_t)step, j = whole_j >= n ? n - 1 : whole_j, j1 = j + 1 == n ? 0 : j + 1;
        const MUS__REAL w = step - (MUS__REAL)j;
        const MUS__REAL p00 = table[k * n + j], p01 = table[k * n + j1];
        const MUS__REAL p10 = table[k * n + n + j], p11 = table[k * n + n + j1];
        const MUS__REAL s00 = p00 * p00, s01 = p01 * p01, s10 = p10 * p10, s11 = p11 * p11;
        const MUS__REAL low = s00 + w * (s01 - s00), high = s10 + w * (s11 - s10);
        const MUS__REAL radius = (MUS__REAL)MUS__NAME(sqrt)(low + t * (high - low)), half = (MUS__REAL)0.5 / radius;
        const MUS__REAL slope_s = (high - low) * ds_inverse * half;
        const MUS__REAL slope_q = ((1 - t) * (s01 - s00) + t * (s11 - s10)) * angle_scale * half;

        const MUS__REAL rho = (MUS__REAL)MUS__NAME(sqrt)(rho2) + MUS__BATCH_TINY;
        const MUS__REAL turn = slope_q * inverse * inverse, out = 1 / rho;
        const MUS__REAL ga = ua * out + turn * ub, gb = ub * out - turn * ua;
        const MUS__REAL gs = -slope_s - (ga * dca + gb * dcb) * ds_inverse;
        const MUS__REAL g = 1 / (MUS__REAL)MUS__NAME(sqrt)(ga * ga + gb * gb + gs * gs + (MUS__REAL)1e-30);
        found[i] = (radius - rho) * g;
        found[MUS__CHUNK + i] = g * (ga * y0 + gb * z0 + gs * x0);
        found[2 * MUS__CHUNK + i] = g * (ga * y1 + gb * z1 + gs * x1);
        found[3 * MUS__CHUNK + i] = g * (ga * y2 + gb * z2 + gs * x2);
        const int32_t near = rho2 <= reach * reach;
        const int32_t cap = (beyond <= margin) * MUS__QUERY_CAP;
        state[i] = cap + inside * (near - cap);
    }
}


/* the same for places in the caps of a field, which are not far beyond its first or its last ring: query_cap() */
MUS_CLONES
static void MUS__NAME(query_batch_caps)(const MUS__NAME(field) * f, int32_t count, MUS__REAL margin,
                                        const MUS__REAL *restrict place, MUS__REAL *restrict found,
                                        int32_t *restrict state)
{
    const MUS__REAL o0 = f->origin[0], o1 = f->origin[1], o2 = f->origin[2], s0 = f->s0, angle_scale = f->angle_scale;
    const MUS__REAL x0 = f->axis[0], x1 = f->axis[1], x2 = f->axis[2];
    const MUS__REAL y0 = f->side[0], y1 = f->side[1], y2 = f->side[2];
    const MUS__REAL z0 = f->front[0], z1 = f->front[1], z2 = f->front[2];
    const MUS__REAL *restrict centre = f->centre, *restrict table = f->radius, *restrict largest = f->largest;
    const MUS__REAL middle0 = f->middle[0], middle1 = f->middle[1], share0 = f->share[0], share1 = f->share[1];
    const MUS__REAL over0 = f->axis_inverse[0], over1 = f->axis_inverse[1];
    const int32_t n = f->nangle, top = f->nring - 1;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL rx = place[i] - o0, ry = place[MUS__CHUNK + i] - o1, rz = place[2 * MUS__CHUNK + i] - o2;
        const MUS__REAL s = rx * x0 + ry * x1 + rz * x2 - s0;
        const MUS__REAL a = rx * y0 + ry * y1 + rz * y2, b = rx * z0 + ry * z1 + rz * z2;
        const int32_t end = s > 0, k = end * top;
        const MUS__REAL middle = end ? middle1 : middle0, share = end ? share1 : share0, over = end ? over1 : over0;
        const MUS__REAL ua = a - centre[2 * k], ub = b - centre[2 * k + 1];
        const MUS__REAL rho2 = ua * ua + ub * ub, reach = largest[k] + margin;

        const MUS__REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
        const MUS__REAL inverse = 1 / (absa + absb + MUS__BATCH_TINY);
        const int32_t left = ua < 0, back = ub < 0, quarter = 3 * back + left - 2 * (back & left);
        const MUS__REAL part = left != back ? absa : absb, q = (MUS__REAL)quarter + part * inverse;
        const MUS__REAL step = q * angle_scale;
        const int32_t whole_j = (int32_t)step, j = whole_j >= n ? n - 1 : whole_j, j1 = j + 1 == n ? 0 : j + 1;
        const MUS__REAL w = step - (MUS__REAL)j, r0 = table[k * n + j], r1 = table[k * n + j1];
        const MUS__REAL radius = r0 + w * (r1 - r0), slope_q = (r1 - r0) * angle_scale;

        const MUS__REAL u = (s - middle) * over, round = share / (radius * radius);
        const MUS__REAL level = (MUS__REAL)MUS__NAME(sqrt)(round * rho2 + u * u) + MUS__BATCH_TINY,
                        scale = round / level;
        const MUS__REAL turn = rho2 * slope_q * inverse * inverse / radius;
        const MUS__REAL ga = scale * (ua + turn * ub), gb = scale * (ub - turn * ua), gs = u * over / level;
        const MUS__REAL g = 1 / (MUS__REAL)MUS__NAME(sqrt)(ga * ga + gb * gb + gs * gs + (MUS__REAL)1e-30);
        found[i] = (1 - level) * g;
        found[MUS__CHUNK + i] = g * (ga * y0 + gb * z0 + gs * x0);
        found[2 * MUS__CHUNK + i] = g * (ga * y1 + gb * z1 + gs * x1);
        found[3 * MUS__CHUNK + i] = g * (ga * y2 + gb * z2 + gs * x2);
        state[i] = rho2 <= reach * reach;
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
        MUS__NAME(query_batch_rings)
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
