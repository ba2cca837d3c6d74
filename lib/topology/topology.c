/*
 * topology.c: the sewn pattern as a surface: V, E, F, Euler characteristic, components, openings, orientation, genus.
 *
 * The room, in the order of use:
 *   quotient.c  the pattern with its seams glued
 *   topology.c  counts and boundary loops
 *   smith_normal_form.c, homology.c  homology over the integers
 *   canonical_form_data.c, canonical_form.c  canonical form
 *   faults.c, check_pattern.c, check_garment.c  the faults of a pattern, as an object
 * Callers: cloth and print (checks), the drafting rooms (checks), arrange (openings), the catalogue (canonical form).
 *
 * Cells are counted by class: V - E + F. A boundary edge is a class with one sheet. A boundary loop is walked along the
 * word of a panel. Where the next edge is sewn, the walk turns round the point: it crosses to the other sheet and goes
 * on along that panel's word (against it when the seam flips the side), until it meets an edge with one sheet.
 *
 *         panel A    |  panel B          walk  a1 -> (seam) -> b1:  both are boundary edges of one opening
 *      ---- a1 ----> * ---- b1 ---->
 *
 * genus = (2 - loops - euler) / 2 for one orientable component. Source: Hatcher, Algebraic Topology, 2002, sections 0
 * and 2.2; Metaaphanon and Kanongchaiyos 2005, section 5.1.
 */
#include "geom/union_find.h"
#include "topology/quotient.h"


void mus_topology_init(mus_topology *topology, size_t size)
{
    mus_topology own = {.genus = MUS_NONE};
    mus__def_init(topology, size, &own, sizeof own);
}


/* true when no edge has more than two sheets; otherwise *edge is one that has, or MUS_NONE for an edge glued to
 * itself */
static bool topology_two_sheets(const mus_pattern *pattern, const mus__quotient *q, int32_t *edge)
{
    *edge = MUS_NONE;
    for (int32_t i = 0; i < pattern->nedge && *edge == MUS_NONE; i++) {
        if (q->sheets[i] > 2) *edge = i;
    }
    return *edge == MUS_NONE && !q->folded;
}


/* the boundary position after boundary position k, walking with *step along or against the words */
static int32_t topology_rim_next(const mus__quotient *q, int32_t k, int32_t *step)
{
    k = mus__quotient_next(q, k, *step);
    for (int32_t class = q->root[q->edge[k]]; q->sheets[class] == 2; class = q->root[q->edge[k]]) {
        const int32_t *sheet = q->sheet + 2 * (size_t) class;
        int32_t other = sheet[0] == k ? sheet[1] : sheet[0];
        if (!mus__quotient_same_side(q, other, k)) *step = -*step;
        k = mus__quotient_next(q, other, *step);
    }
    return k;
}


/* number of boundary loops, in the order of the lowest position of each; with at most two sheets an edge. q->link marks
 * walked positions. *start gets the first position of loop `wanted` when there is one */
static int32_t topology_rims(mus__quotient *q, int32_t wanted, int32_t *start)
{
    int32_t count = 0;
    for (int32_t k = 0; k < q->nword; k++) q->link[k] = 0;
    for (int32_t k = 0; k < q->nword; k++) {
        if (q->link[k] != 0 || q->sheets[q->root[q->edge[k]]] != 1) continue;
        if (count == wanted) *start = k;
        count++;
        int32_t at = k, step = 1;
        do {
            q->link[at] = 1;
            at = topology_rim_next(q, at, &step);
        } while (at != k);
    }
    return count;
}


/* number of classes of corners (corner k is where position k starts) when only sheets are glued. A point with two such
 * classes is a pinch. With at most two sheets an edge */
static int32_t topology_corners(mus__quotient *q, int32_t nedge)
{
    mus__union_start(q->nword, q->link, q->bias);
    for (int32_t class = 0; class < nedge; class ++) {
        if (q->sheets[class] != 2) continue;
        int32_t j = q->sheet[2 * (size_t) class], k = q->sheet[2 * (size_t) class + 1];
        int32_t j_end = mus__quotient_next(q, j, 1), k_end = mus__quotient_next(q, k, 1);
        bool same = mus__quotient_same_side(q, j, k);
        mus__union_join(q->link, q->bias, j, same ? k_end : k, 1);
        mus__union_join(q->link, q->bias, j_end, same ? k : k_end, 1);
    }
    int32_t count = 0;
    for (int32_t k = 0; k < q->nword; k++) count += q->link[k] == k;
    return count;
}


/* classes of the points that outlines pass */
static int32_t topology_points(const mus_pattern *pattern, mus__quotient *q)
{
    int32_t count = 0;
    for (int32_t i = 0; i < pattern->npoint; i++) q->link[i] = 0;
    for (int32_t k = 0; k < q->nword; k++) {
        const mus__edge *edge = &pattern->edge[q->edge[k]];
        int32_t class = q->point[q->turn[k] > 0 ? edge->start : edge->end];
        count += q->link[class] == 0;
        q->link[class] = 1;
    }
    return count;
}


/* number of edges sewn to themselves end over end: each is half an edge, whose middle is a point. Overwrites
 * q->sheet */
static int32_t topology_folds(const mus_pattern *pattern, mus__quotient *q)
{
    int32_t count = 0;
    for (int32_t i = 0; i < pattern->nseam && q->folded; i++) {
        const mus_seam_def *seam = &pattern->seam[i];
        int32_t meant = seam->direction == MUS_SEAM_DIRECT ? 1 : -1, root = q->root[seam->edge_a];
        if (q->sheets[root] == 0 || q->sign[seam->edge_a] * q->sign[seam->edge_b] == meant) continue;
        count += q->sheet[2 * (size_t)root] != MUS_NONE;
        q->sheet[2 * (size_t)root] = MUS_NONE;
    }
    return count;
}


/* number of components, which mus__quotient_sides() left in q->link */
static int32_t topology_pieces(const mus_pattern *pattern, const mus__quotient *q)
{
    int32_t count = 0;
    for (int32_t i = 0; i < pattern->npanel; i++) count += q->link[i] == i;
    return count;
}


mus_status mus_pattern_topology(const mus_pattern *pattern, mus_topology *out)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "topology: out is NULL");
    mus__quotient q;
    mus_status status = mus__quotient_make(pattern, false, &q);
    if (status != MUS_OK) return status;

    mus_topology own;
    mus_topology_init(&own, sizeof own);
    int32_t edge, bridge, start;
    own.orientable = mus__quotient_sides(pattern, &q, NULL, &bridge) == 0;
    own.components = topology_pieces(pattern, &q);
    own.vertices = topology_points(pattern, &q);
    for (int32_t i = 0; i < pattern->nedge; i++) own.edges += q.sheets[i] > 0;
    own.vertices += topology_folds(pattern, &q);
    own.faces = pattern->npanel;
    own.euler = own.vertices - own.edges + own.faces;

    /* where three sheets meet, the walk round a point is not unique */
    own.loops = MUS_NONE;
    if (topology_two_sheets(pattern, &q, &edge)) {
        own.manifold = topology_corners(&q, pattern->nedge) == own.vertices;
        own.loops = topology_rims(&q, MUS_NONE, &start);
    }
    if (own.manifold && own.orientable && own.components == 1) own.genus = (2 - own.loops - own.euler) / 2;
    mus__free(pattern->context, q.block);
    return mus__pattern_give(pattern, out, &own, sizeof own, "topology");
}


mus_status mus_pattern_loop(const mus_pattern *pattern, int32_t loop, int32_t *edges, int32_t capacity, int32_t *count,
                            double *length)
{
    if (count != NULL) *count = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (edges != NULL && capacity < 0)
        return mus__fail(context, MUS_ERR_ARG, "loop %d: room for %d edges", (int)loop, (int)capacity);
    mus__quotient q;
    mus_status status = mus__quotient_make(pattern, false, &q);
    if (status != MUS_OK) return status;

    int32_t edge, start = MUS_NONE, rims = 0;
    if (!topology_two_sheets(pattern, &q, &edge)) {
        char title[2 * MUS__NAME_BYTES] = "an edge sewn to itself";
        if (edge != MUS_NONE) mus__pattern_edge_title(pattern, edge, title);
        status = mus__fail(context, MUS_ERR_PATTERN, "loop %d: more than two sheets meet at %s", (int)loop, title);
        goto done;
    }
    rims = topology_rims(&q, loop, &start);
    if (start == MUS_NONE) {
        status = mus__pattern_known(pattern, "loop", loop, rims);
        goto done;
    }

    /* walk it once more, writing what there is room for */
    double total = 0.0;
    int32_t n = 0, at = start, step = 1;
    do {
        if (edges != NULL && n < capacity) edges[n] = q.edge[at];
        total += mus_pattern_edge_length(pattern, q.edge[at]);
        n++;
        at = topology_rim_next(&q, at, &step);
    } while (at != start);
    if (count != NULL) *count = n;
    if (length != NULL) *length = total;
done:
    mus__free(context, q.block);
    return status;
}
