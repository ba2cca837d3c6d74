/*
 * ask_kernel.h: many nodes asked of a part at once, a part of contact_kernel.h.
 *
 * The query of field_kernel.h for places in a row, without a branch, so that it is made for as many nodes at once as
 * the vector unit is wide; the same operations in the same order, so the same bits. What is in a cap, beyond the first
 * or the last ring, is asked in a row of its own.
 */

#define ASK_BLOCK 256 /* nodes */
#define ASK_FEW 2     /* less are asked one by one */
#define ASK_TINY ((MUS_REAL)1e-15)
#define ASK_LATER 2 /* state of a node that is in a cap: 0 is not near, 1 near */

/* an answer for a node; next: of the same node's, by part ascending; 0 ends */
typedef struct MUS_FIELD(answer) {
    MUS_REAL depth, normal[3];
    int32_t part, next;
} MUS_FIELD(answer);

typedef struct MUS_FIELD(asking) {
    MUS_REAL place[3 * ASK_BLOCK];
    MUS_REAL found[4 * ASK_BLOCK]; /* depth, normal */
    int32_t state[ASK_BLOCK];
    uint8_t who[MUS_LIMBS_MOST][ASK_BLOCK];   /* nodes in the box of each part */
    int32_t head[ASK_BLOCK], most[ASK_BLOCK]; /* of each node: its first answer, how many it has */
    int32_t answers;
    MUS_FIELD(answer) answer[1 + ASK_BLOCK * MEET_MOST];
} MUS_FIELD(asking);


/* depth and normal (4 planes of ASK_BLOCK) of `count` places (3 planes) in a field, and their state */
MUS_CLONES
static void MUS_FIELD(ask_many)(const MUS_FIELD(field) * f, int32_t count, MUS_REAL margin,
                                const MUS_REAL *restrict place, MUS_REAL *restrict found, int32_t *restrict state)
{
    const MUS_REAL o0 = f->origin[0], o1 = f->origin[1], o2 = f->origin[2];
    const MUS_REAL x0 = f->axis[0], x1 = f->axis[1], x2 = f->axis[2];
    const MUS_REAL y0 = f->side[0], y1 = f->side[1], y2 = f->side[2];
    const MUS_REAL z0 = f->front[0], z1 = f->front[1], z2 = f->front[2];
    const MUS_REAL s0 = f->s0, ds_inverse = f->ds_inverse, ring_last = f->ring_last, angle_scale = f->angle_scale;
    const MUS_REAL *restrict centre = f->centre, *restrict table = f->radius, *restrict largest = f->largest;
    const MUS_REAL pole0 = f->pole[0], pole1 = f->pole[1];
    const int32_t n = f->nangle;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL rx = place[i] - o0, ry = place[ASK_BLOCK + i] - o1, rz = place[2 * ASK_BLOCK + i] - o2;
        const MUS_REAL s = rx * x0 + ry * x1 + rz * x2 - s0;
        const MUS_REAL a = rx * y0 + ry * y1 + rz * y2, b = rx * z0 + ry * z1 + rz * z2;
        const MUS_REAL whole = s * ds_inverse, before = pole0 - s, after = s - pole1;
        const MUS_REAL beyond = s > 0 ? after : before;
        const int32_t inside = (whole >= 0) & (whole < ring_last);
        const MUS_REAL u = whole * (MUS_REAL)inside; /* in a box: finite */
        const int32_t k = (int32_t)u;
        const MUS_REAL t = u - (MUS_REAL)k;

        const MUS_REAL c0 = centre[2 * k], c1 = centre[2 * k + 1];
        const MUS_REAL dca = centre[2 * k + 2] - c0, dcb = centre[2 * k + 3] - c1;
        const MUS_REAL ua = a - (c0 + t * dca), ub = b - (c1 + t * dcb);
        const MUS_REAL rho2 = ua * ua + ub * ub, reach = largest[k] + 4 * margin;

        const MUS_REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
        const MUS_REAL inverse = 1 / (absa + absb + ASK_TINY);
        const int32_t left = ua < 0, back = ub < 0, quarter = 3 * back + left - 2 * (back & left);
        const MUS_REAL part = left != back ? absa : absb, q = (MUS_REAL)quarter + part * inverse;
        const MUS_REAL step = q * angle_scale;
        const int32_t whole_j = (int32_t)step, j = whole_j >= n ? n - 1 : whole_j, j1 = j + 1 == n ? 0 : j + 1;
        const MUS_REAL w = step - (MUS_REAL)j;
        const MUS_REAL p00 = table[k * n + j], p01 = table[k * n + j1];
        const MUS_REAL p10 = table[k * n + n + j], p11 = table[k * n + n + j1];
        const MUS_REAL s00 = p00 * p00, s01 = p01 * p01, s10 = p10 * p10, s11 = p11 * p11;
        const MUS_REAL low = s00 + w * (s01 - s00), high = s10 + w * (s11 - s10);
        const MUS_REAL radius = (MUS_REAL)MUS_FIELD(sqrt)(low + t * (high - low)), half = (MUS_REAL)0.5 / radius;
        const MUS_REAL slope_s = (high - low) * ds_inverse * half;
        const MUS_REAL slope_q = ((1 - t) * (s01 - s00) + t * (s11 - s10)) * angle_scale * half;

        const MUS_REAL rho = (MUS_REAL)MUS_FIELD(sqrt)(rho2) + ASK_TINY;
        const MUS_REAL turn = slope_q * inverse * inverse, out = 1 / rho;
        const MUS_REAL ga = ua * out + turn * ub, gb = ub * out - turn * ua;
        const MUS_REAL gs = -slope_s - (ga * dca + gb * dcb) * ds_inverse;
        const MUS_REAL g = 1 / (MUS_REAL)MUS_FIELD(sqrt)(ga * ga + gb * gb + gs * gs + (MUS_REAL)1e-30);
        found[i] = (radius - rho) * g;
        found[ASK_BLOCK + i] = g * (ga * y0 + gb * z0 + gs * x0);
        found[2 * ASK_BLOCK + i] = g * (ga * y1 + gb * z1 + gs * x1);
        found[3 * ASK_BLOCK + i] = g * (ga * y2 + gb * z2 + gs * x2);
        const int32_t near = rho2 <= reach * reach;
        const int32_t cap = (beyond <= margin) * ASK_LATER;
        state[i] = cap + inside * (near - cap);
    }
}


/* the same for places in the caps of a field, which are not far beyond its first or its last ring: query_cap() */
MUS_CLONES
static void MUS_FIELD(ask_caps)(const MUS_FIELD(field) * f, int32_t count, MUS_REAL margin,
                                const MUS_REAL *restrict place, MUS_REAL *restrict found, int32_t *restrict state)
{
    const MUS_REAL o0 = f->origin[0], o1 = f->origin[1], o2 = f->origin[2], s0 = f->s0, angle_scale = f->angle_scale;
    const MUS_REAL x0 = f->axis[0], x1 = f->axis[1], x2 = f->axis[2];
    const MUS_REAL y0 = f->side[0], y1 = f->side[1], y2 = f->side[2];
    const MUS_REAL z0 = f->front[0], z1 = f->front[1], z2 = f->front[2];
    const MUS_REAL *restrict centre = f->centre, *restrict table = f->radius, *restrict largest = f->largest;
    const MUS_REAL middle0 = f->middle[0], middle1 = f->middle[1], share0 = f->share[0], share1 = f->share[1];
    const MUS_REAL over0 = f->axis_inverse[0], over1 = f->axis_inverse[1];
    const int32_t n = f->nangle, top = f->nring - 1;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL rx = place[i] - o0, ry = place[ASK_BLOCK + i] - o1, rz = place[2 * ASK_BLOCK + i] - o2;
        const MUS_REAL s = rx * x0 + ry * x1 + rz * x2 - s0;
        const MUS_REAL a = rx * y0 + ry * y1 + rz * y2, b = rx * z0 + ry * z1 + rz * z2;
        const int32_t end = s > 0, k = end * top;
        const MUS_REAL middle = end ? middle1 : middle0, share = end ? share1 : share0, over = end ? over1 : over0;
        const MUS_REAL ua = a - centre[2 * k], ub = b - centre[2 * k + 1];
        const MUS_REAL rho2 = ua * ua + ub * ub, reach = largest[k] + margin;

        const MUS_REAL absa = ua < 0 ? -ua : ua, absb = ub < 0 ? -ub : ub;
        const MUS_REAL inverse = 1 / (absa + absb + ASK_TINY);
        const int32_t left = ua < 0, back = ub < 0, quarter = 3 * back + left - 2 * (back & left);
        const MUS_REAL part = left != back ? absa : absb, q = (MUS_REAL)quarter + part * inverse;
        const MUS_REAL step = q * angle_scale;
        const int32_t whole_j = (int32_t)step, j = whole_j >= n ? n - 1 : whole_j, j1 = j + 1 == n ? 0 : j + 1;
        const MUS_REAL w = step - (MUS_REAL)j, r0 = table[k * n + j], r1 = table[k * n + j1];
        const MUS_REAL radius = r0 + w * (r1 - r0), slope_q = (r1 - r0) * angle_scale;

        const MUS_REAL u = (s - middle) * over, round = share / (radius * radius);
        const MUS_REAL level = (MUS_REAL)MUS_FIELD(sqrt)(round * rho2 + u * u) + ASK_TINY, scale = round / level;
        const MUS_REAL turn = rho2 * slope_q * inverse * inverse / radius;
        const MUS_REAL ga = scale * (ua + turn * ub), gb = scale * (ub - turn * ua), gs = u * over / level;
        const MUS_REAL g = 1 / (MUS_REAL)MUS_FIELD(sqrt)(ga * ga + gb * gb + gs * gs + (MUS_REAL)1e-30);
        found[i] = (1 - level) * g;
        found[ASK_BLOCK + i] = g * (ga * y0 + gb * z0 + gs * x0);
        found[2 * ASK_BLOCK + i] = g * (ga * y1 + gb * z1 + gs * x1);
        found[3 * ASK_BLOCK + i] = g * (ga * y2 + gb * z2 + gs * x2);
        state[i] = rho2 <= reach * reach;
    }
}


/* what part l answered to `m` nodes of a block, who (m): those that are near keep it, of others the part is taken out
 * of `in`; nodes that are left stay at the front of who. Their number */
static int32_t MUS_FIELD(keep_answers)(int32_t l, int32_t m, uint8_t *who, uint64_t *in, MUS_FIELD(asking) * asking,
                                       int64_t *queries)
{
    int32_t left = 0;
    for (int32_t k = 0; k < m; k++) {
        const int32_t i = who[k];
        if (asking->state[k] == ASK_LATER) {
            who[left++] = (uint8_t)i;
            continue;
        }
        (*queries)++;
        if (asking->state[k] == 0) in[i] &= ~((uint64_t)1 << l);
        if (asking->state[k] == 0 || asking->most[i] == MEET_MOST) continue;
        MUS_FIELD(answer) *answer = &asking->answer[asking->answers];
        answer->depth = asking->found[k];
        for (int32_t d = 0; d < 3; d++) answer->normal[d] = asking->found[(d + 1) * ASK_BLOCK + k];
        answer->part = l;
        answer->next = asking->head[i];
        asking->head[i] = asking->answers++;
        asking->most[i]++;
    }
    return left;
}


/* the nodes of a block asked of the parts whose boxes they are in, `in` (count) a bit each; bits of parts that are not
 * near are taken out, of those that are the answers are kept. x planes from the block's first node on */
static void MUS_FIELD(ask_block)(const mus__collider *collider, MUS_REAL margin, int64_t n, int32_t count,
                                 const MUS_REAL *x, uint64_t *in, MUS_FIELD(asking) * asking, int64_t *queries)
{
    int32_t members[MUS_LIMBS_MOST];
    for (int32_t l = 0; l < collider->nlimb; l++) members[l] = 0;
    for (int32_t i = 0; i < count; i++) {
        asking->head[i] = asking->most[i] = 0;
        for (uint64_t bits = in[i]; bits != 0; bits &= bits - 1) {
            const int32_t l = mus__lowest_bit(bits);
            asking->who[l][members[l]++] = (uint8_t)i;
        }
    }
    asking->answers = 1;

    /* the last part first: the lists then begin with the first. A few nodes are not worth a row */
    for (int32_t l = collider->nlimb - 1; l >= 0; l--) {
        const int32_t m = members[l];
        uint8_t *who = asking->who[l];
        if (m < ASK_FEW) continue;
        for (int64_t d = 0; d < 3; d++)
            for (int32_t k = 0; k < m; k++) asking->place[d * ASK_BLOCK + k] = x[d * n + who[k]];
        MUS_FIELD(ask_many)(&collider->MUS_FIELDS[l], m, margin, asking->place, asking->found, asking->state);
        const int32_t left = MUS_FIELD(keep_answers)(l, m, who, in, asking, queries);
        if (left == 0) continue;
        for (int64_t d = 0; d < 3; d++)
            for (int32_t k = 0; k < left; k++) asking->place[d * ASK_BLOCK + k] = x[d * n + who[k]];
        MUS_FIELD(ask_caps)(&collider->MUS_FIELDS[l], left, margin, asking->place, asking->found, asking->state);
        MUS_FIELD(keep_answers)(l, left, who, in, asking, queries);
    }
}
