/*
 * quotient.c: the pattern with its seams glued: classes of edges and points, sheets at each class, sides of panels.
 *
 * A seam makes two edges one class, with a sign (geom/union_find.c), and makes their ends two classes of points
 * (Metaaphanon and Kanongchaiyos 2005, eq. 19 and 20). An edge that a word passes twice (the bridge to a hole) is two
 * sheets of one class by itself.
 *
 * Sides: two panels that meet at an edge have the same side out when their words run against each other there. This
 * relation 2-colours the panels, or contradicts itself: then the garment is one-sided. A panel that is sewn to a line
 * inside another may lie on it either way; it is taken to have its right side out.
 */
#include "geom/union_find.h"
#include "topology/quotient.h"


int32_t mus__quotient_next(const mus__quotient *q, int32_t k, int32_t step)
{
    int32_t first = q->first[q->panel[k]], end = q->first[q->panel[k] + 1];
    if (step > 0) return k + 1 < end ? k + 1 : first;
    return k > first ? k - 1 : end - 1;
}


bool mus__quotient_same_side(const mus__quotient *q, int32_t j, int32_t k)
{
    return q->turn[j] * q->sign[q->edge[j]] != q->turn[k] * q->sign[q->edge[k]];
}


/* one block for all arrays */
static mus_status quotient_block(const mus_pattern *pattern, int32_t nword, mus__quotient *q)
{
    int64_t npanel = pattern->npanel, nedge = pattern->nedge, npoint = pattern->npoint;
    int64_t nlink = npoint > nword ? npoint : nword;
    nlink = nlink > npanel ? nlink : npanel;
    int64_t total = npanel + 1 + 3 * (int64_t)nword + 6 * nedge + npoint + 2 * nlink;
    q->block = mus__new(pattern->context, total, sizeof *q->block);
    if (q->block == NULL) return mus__fail_memory(pattern->context, "the topology of a pattern");

    q->nword = nword;
    q->first = q->block;
    q->edge = q->first + npanel + 1;
    q->turn = q->edge + nword;
    q->panel = q->turn + nword;
    q->place = q->panel + nword;
    q->root = q->place + nedge;
    q->sign = q->root + nedge;
    q->sheets = q->sign + nedge;
    q->sheet = q->sheets + nedge;
    q->point = q->sheet + 2 * nedge;
    q->link = q->point + npoint;
    q->bias = q->link + nlink;
    return MUS_OK;
}


/* the words of all panels one after another */
static void quotient_words(const mus_pattern *pattern, mus__quotient *q)
{
    int32_t k = 0;
    for (int32_t i = 0; i < pattern->nedge; i++) q->place[i] = MUS_NONE;
    for (int32_t i = 0; i < pattern->npanel; i++) {
        const mus__panel *panel = &pattern->panel[i];
        q->first[i] = k;
        for (int32_t j = 0; j < panel->noutline; j++, k++) {
            q->edge[k] = panel->outline[j];
            q->turn[k] = panel->outline[panel->noutline + j];
            q->panel[k] = i;
            if (q->place[q->edge[k]] == MUS_NONE) q->place[q->edge[k]] = k;
        }
    }
    q->first[pattern->npanel] = k;
}


/* seams join edges and their ends */
static void quotient_glue(const mus_pattern *pattern, int32_t nseam, mus__quotient *q)
{
    mus__union_start(pattern->nedge, q->root, q->sign);
    mus__union_start(pattern->npoint, q->point, q->bias);
    for (int32_t i = 0; i < nseam; i++) {
        const mus_seam_def *seam = &pattern->seam[i];
        const mus__edge *a = &pattern->edge[seam->edge_a], *b = &pattern->edge[seam->edge_b];
        bool direct = seam->direction == MUS_SEAM_DIRECT;
        if (!mus__union_join(q->root, q->sign, seam->edge_a, seam->edge_b, direct ? 1 : -1)) q->folded = true;
        mus__union_join(q->point, q->bias, a->start, direct ? b->start : b->end, 1);
        mus__union_join(q->point, q->bias, a->end, direct ? b->end : b->start, 1);
    }
    for (int32_t i = 0; i < pattern->nedge; i++) mus__union_find(q->root, q->sign, i);
    for (int32_t i = 0; i < pattern->npoint; i++) mus__union_find(q->point, q->bias, i);
}


mus_status mus__quotient_make_cells(const mus_pattern *pattern, bool partial, bool sewn, mus__quotient *out)
{
    *out = (mus__quotient){0};
    int64_t nword = 0;
    for (int32_t i = 0; i < pattern->npanel; i++) {
        if (pattern->panel[i].noutline == 0 && !partial)
            return mus__fail(pattern->context, MUS_ERR_PATTERN, "panel %s has no outline", pattern->panel[i].name);
        nword += pattern->panel[i].noutline;
    }
    if (nword > INT32_MAX)
        return mus__fail(pattern->context, MUS_ERR_LIMIT, "outlines of %lld edges are more than 2^31",
                         (long long)nword);
    mus_status status = quotient_block(pattern, (int32_t)nword, out);
    if (status != MUS_OK) return status;
    quotient_words(pattern, out);
    quotient_glue(pattern, sewn ? pattern->nseam : 0, out);

    /* sheets at each class */
    for (int32_t k = 0; k < out->nword; k++) {
        int32_t class = out->root[out->edge[k]];
        if (out->sheets[class] < 2) out->sheet[2 * (size_t) class + (size_t)out->sheets[class]] = k;
        out->sheets[class]++;
    }
    return MUS_OK;
}


mus_status mus__quotient_make(const mus_pattern *pattern, bool partial, mus__quotient *out)
{
    return mus__quotient_make_cells(pattern, partial, true, out);
}


/* positions of the two edges of a seam; false when one is in no outline. *relation is +1 for the same side out, else
 * -1 */
static bool quotient_seam(const mus__quotient *q, const mus_seam_def *seam, int32_t *j, int32_t *k, int32_t *relation)
{
    *j = q->place[seam->edge_a];
    *k = q->place[seam->edge_b];
    if (*j == MUS_NONE || *k == MUS_NONE) return false;
    *relation = -q->turn[*j] * q->turn[*k] * (seam->direction == MUS_SEAM_DIRECT ? 1 : -1);
    /* what lies on other cloth, a patch or an end that is tied, has the same side out as that */
    if (seam->closure == MUS_CLOSURE_TIES || mus__edge_inner(q, seam->edge_a) || mus__edge_inner(q, seam->edge_b))
        *relation = 1;
    return true;
}


int32_t mus__quotient_sides(const mus_pattern *pattern, mus__quotient *q, int32_t *twisted, int32_t *bridge)
{
    int32_t count = 0, j, k, relation;
    *bridge = MUS_NONE;
    mus__union_start(pattern->npanel, q->link, q->bias);

    /* seams with the same side out first, so that the others are found to contradict */
    for (int32_t pass = 1; pass >= -1; pass -= 2) {
        for (int32_t i = 0; i < pattern->nseam; i++) {
            if (!quotient_seam(q, &pattern->seam[i], &j, &k, &relation) || relation != pass) continue;
            if (mus__union_join(q->link, q->bias, q->panel[j], q->panel[k], relation)) continue;
            if (twisted != NULL) twisted[i] = 1;
            count++;
        }
    }

    /* an edge passed twice by one word */
    for (k = 0; k < q->nword; k++) {
        j = q->place[q->edge[k]];
        if (j == k || q->turn[j] != q->turn[k]) continue;
        if (*bridge == MUS_NONE) *bridge = q->edge[k];
        count++;
    }
    for (int32_t i = 0; i < pattern->npanel; i++) mus__union_find(q->link, q->bias, i);
    return count;
}


bool mus__edge_inner(const mus__quotient *q, int32_t edge)
{
    const int32_t first = q->place[edge];
    if (first == MUS_NONE) return false;
    for (int32_t k = first + 1; k < q->nword && q->panel[k] == q->panel[first]; k++)
        if (q->edge[k] == edge) return q->turn[k] != q->turn[first];
    return false;
}
