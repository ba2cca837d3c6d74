/*
 * dxf_ring.c: the lines of a layer as one closed outline; where its edges begin; the mirror line; grading.
 *
 * The outline of a piece is one closed polyline (Valentina, CLO), a chain of open polylines, one an edge (Gerber,
 * muslin's sew line), or a heap of lines. Open ones are joined end to nearest end.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "trade/dxf_ring.h"
#include "base/elementary.h"

#define RING_JOIN 5e-4   /* [m] ends of lines this near are one point, without a nearer end; chosen: 50 last digits */
#define RING_SAME 1e-6   /* [m] points this near are one point: a hundredth of the last digit that files have */
#define RING_TOUCH 5e-5  /* [m] a turn point or a mirror line this near to a vertex is on it; chosen: RING_JOIN / 10 */
#define RING_POINTS 5000 /* most points of an outline; chosen: bounds the time of a file, which grows with n^2 */
#define RING_CHAINS 5000 /* most lines of one layer of a piece; chosen: as RING_POINTS */
#define CORNER_COSINE 0.86602540378443865 /* of 30 degrees (AAMA: a turn point is a corner) */


void mus__ring_free(mus_context *context, mus__ring *ring)
{
    mus_context_alloc(context, ring->points, 0);
    memset(ring, 0, sizeof *ring);
}


static double ring_apart(const double *a, const double *b)
{
    return mus__hypot(a[0] - b[0], a[1] - b[1]);
}


/* ---- joining ---- */

static mus_status ring_add(const mus__dxf_file *file, mus__ring *ring, const double *p, bool turn, int64_t line)
{
    const double xy[2] = {p[0] * file->unit, p[1] * file->unit};
    if (ring->n > 0 && ring_apart(ring->points[ring->n - 1].xy, xy) < RING_SAME) {
        ring->points[ring->n - 1].turn |= turn;
        return MUS_OK;
    }
    if (ring->n == RING_POINTS)
        return mus__source_fail(file->source, line, MUS_ERR_LIMIT, "an outline of more than %d points", RING_POINTS);
    mus_status status = mus__source_reserve(file->source, &ring->points, &ring->room, (int64_t)ring->n + 1,
                                           sizeof *ring->points);
    if (status == MUS_OK) ring->points[ring->n++] = (mus__ring_point){{xy[0], xy[1]}, {xy[0], xy[1]}, turn};
    return status;
}


/* add all points of an entity, from its last one when `back`; the join to an earlier one is no second point */
static mus_status ring_append(const mus__dxf_file *file, mus__ring *ring, const mus__dxf_entity *entity, bool back)
{
    const bool edge = entity->kind == MUS__DXF_POLYLINE && !entity->closed;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < entity->n && status == MUS_OK; i++) {
        const double *p = file->xy + 2 * (size_t)(entity->first + (back ? entity->n - 1 - i : i));
        const double at[2] = {p[0] * file->unit, p[1] * file->unit};
        const bool end = edge && (i == 0 || i == entity->n - 1);
        if (i == 0 && ring->n > 0 && ring_apart(ring->points[ring->n - 1].xy, at) < RING_JOIN)
            ring->points[ring->n - 1].turn |= end;
        else status = ring_add(file, ring, p, end, entity->line);
    }
    return status;
}


/* the unused entity with an end nearest to p; *gap gets the distance [m] */
static int32_t ring_next(const mus__dxf_file *file, const int32_t *list, int32_t n, const double *p, bool *back,
                         double *gap)
{
    int32_t best = MUS_NONE;
    *gap = HUGE_VAL;
    for (int32_t i = 0; i < n; i++) {
        if (list[i] == MUS_NONE) continue;
        const mus__dxf_entity *entity = &file->entities[list[i]];
        for (int32_t end = 0; end < 2; end++) {
            const double *q = file->xy + 2 * (size_t)(entity->first + (end ? entity->n - 1 : 0));
            const double at[2] = {q[0] * file->unit, q[1] * file->unit}, d = ring_apart(p, at);
            if (d >= *gap) continue;
            *gap = d;
            *back = end == 1;
            best = i;
        }
    }
    return best;
}


/* join the open entities of the list to a ring */
static mus_status ring_join(const mus__dxf_file *file, int32_t *list, int32_t n, mus__ring *ring)
{
    const mus__dxf_entity *first = &file->entities[list[0]];
    mus_status status = ring_append(file, ring, first, false);
    list[0] = MUS_NONE;
    for (int32_t left = n - 1; status == MUS_OK; left--) {
        double gap, closing = ring_apart(ring->points[0].xy, ring->points[ring->n - 1].xy);
        bool back = false;
        int32_t next = left > 0 ? ring_next(file, list, n, ring->points[ring->n - 1].xy, &back, &gap) : MUS_NONE;
        if (ring->n > 2 && closing < RING_JOIN && (next == MUS_NONE || closing <= gap)) break;
        if (next == MUS_NONE || gap >= RING_JOIN)
            return mus__source_fail(file->source, first->line, MUS_ERR_FORMAT,
                                    "the outline on layer %d is open by %.2f mm; expected lines that close",
                                    (int)first->layer, 1e3 * (next == MUS_NONE || closing < gap ? closing : gap));
        status = ring_append(file, ring, &file->entities[list[next]], back);
        list[next] = MUS_NONE;
    }
    return status;
}


/* the last point goes when it is the first: within `near` [m], and then those that are the same point */
static void ring_close(mus__ring *ring, double near)
{
    for (; ring->n > 1 && ring_apart(ring->points[0].xy, ring->points[ring->n - 1].xy) < near; near = RING_SAME) {
        ring->points[0].turn |= ring->points[ring->n - 1].turn;
        ring->n--;
    }
    if (ring->n < 3) ring->n = 0;
}


mus_status mus__ring_make(const mus__dxf_file *file, const mus__dxf_block *block, int32_t layer, int32_t only,
                          mus__ring *ring)
{
    int32_t n = 0, closed = MUS_NONE, *list;
    ring->n = 0;
    list = mus_context_alloc(file->source->context, NULL, RING_CHAINS * sizeof *list);
    if (list == NULL) return mus__source_fail(file->source, block->line, MUS_ERR_MEMORY, "no memory for an outline");
    mus_status status = MUS_OK;
    for (int32_t i = block->first; i < block->first + block->n && status == MUS_OK; i++) {
        const mus__dxf_entity *entity = &file->entities[i];
        const bool line = entity->kind == MUS__DXF_LINE || entity->kind == MUS__DXF_POLYLINE;
        if (!line || entity->n < 2 || (only == MUS_NONE ? entity->layer != layer : i != only)) continue;
        if (closed == MUS_NONE && entity->closed) closed = i;
        if (n == RING_CHAINS)
            status = mus__source_fail(file->source, entity->line, MUS_ERR_LIMIT, "more than %d lines on layer %d",
                                      RING_CHAINS, (int)layer);
        else if (!entity->closed) list[n++] = i;
    }
    if (status == MUS_OK && closed != MUS_NONE) status = ring_append(file, ring, &file->entities[closed], false);
    else if (status == MUS_OK && n > 0) status = ring_join(file, list, n, ring);
    mus_context_alloc(file->source->context, list, 0);
    if (status == MUS_OK) ring_close(ring, closed != MUS_NONE ? RING_SAME : RING_JOIN);
    return status;
}


/* ---- places ---- */

void mus__ring_box(const mus__ring *ring, double *box)
{
    for (int32_t i = 0; i < ring->n; i++) {
        for (int32_t k = 0; k < 2; k++) {
            const double x = ring->points[i].xy[k];
            if (i == 0 || x < box[k]) box[k] = x;
            if (i == 0 || x > box[2 + k]) box[2 + k] = x;
        }
    }
}


double mus__ring_nearest(const mus__ring *ring, const double *p, int32_t *at, double *part)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < ring->n; i++) {
        const double *a = ring->points[i].xy, *b = ring->points[(i + 1) % ring->n].xy;
        double dx = b[0] - a[0], dy = b[1] - a[1], dd = dx * dx + dy * dy;
        double t = dd > 0.0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / dd : 0.0;
        t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
        const double q[2] = {a[0] + t * dx, a[1] + t * dy}, d = ring_apart(p, q);
        if (d >= best) continue;
        best = d;
        *at = i;
        *part = t;
    }
    return best;
}


bool mus__ring_meet(const mus__ring *ring, const double *p, const double *d, const double *range, int32_t *at,
                    double *part)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < ring->n; i++) {
        const double *a = ring->points[i].xy, *b = ring->points[(i + 1) % ring->n].xy;
        double ex = b[0] - a[0], ey = b[1] - a[1], det = d[0] * ey - d[1] * ex;
        if (det == 0.0) continue;
        double ax = a[0] - p[0], ay = a[1] - p[1], t = (ax * ey - ay * ex) / det, u = (ax * d[1] - ay * d[0]) / det;
        if (u < 0.0 || u > 1.0 || t < -range[0] || t > range[1] || fabs(t) >= best) continue;
        best = fabs(t);
        *at = i;
        *part = u;
    }
    return best < HUGE_VAL;
}


double mus__ring_away(const mus__ring *ring, int32_t at, double part, const double *p)
{
    const double *a = ring->points[at].xy, *b = ring->points[(at + 1) % ring->n].xy;
    const double q[2] = {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])};
    return ring_apart(p, q);
}


bool mus__ring_corner(const mus__ring *ring, const double *p, const double *d, double ahead, int32_t *at, double *part)
{
    const int32_t n = ring->n;
    double nearest = ahead + RING_TOUCH;
    bool found = false;
    for (int32_t i = 0; i < n; i++) {
        const int32_t before = (i + n - 1) % n;
        const double *a = ring->points[before].xy, *c = ring->points[i].xy, *b = ring->points[(i + 1) % n].xy;
        const double x = c[0] - p[0], y = c[1] - p[1], t = x * d[0] + y * d[1];
        if (!ring->points[i].turn || fabs(x * d[1] - y * d[0]) > RING_TOUCH || t < 0.0 || t >= nearest) continue;
        const double in = fabs((c[0] - a[0]) * d[0] + (c[1] - a[1]) * d[1]) / ring_apart(a, c);
        const double out = fabs((b[0] - c[0]) * d[0] + (b[1] - c[1]) * d[1]) / ring_apart(c, b);
        nearest = t;
        found = true;
        *at = in < out ? before : i;
        *part = in < out ? 1.0 : 0.0;
    }
    return found;
}


bool mus__ring_inside(const mus__ring *ring, const double *p)
{
    bool inside = false;
    for (int32_t i = 0; i < ring->n; i++) {
        const double *a = ring->points[i].xy, *b = ring->points[(i + 1) % ring->n].xy;
        if ((a[1] > p[1]) == (b[1] > p[1])) continue;
        if (p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])) inside = !inside;
    }
    return inside;
}


void mus__ring_orient(mus__ring *ring)
{
    double area = 0.0;
    for (int32_t i = 1; i + 1 < ring->n; i++) {
        const double *o = ring->points[0].moved, *a = ring->points[i].moved, *b = ring->points[i + 1].moved;
        area += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }
    for (int32_t i = 0, j = ring->n - 1; i < j && area < 0.0; i++, j--) {
        const mus__ring_point swap = ring->points[i];
        ring->points[i] = ring->points[j];
        ring->points[j] = swap;
    }
}


/* ---- edges ---- */

/* true when the ring bends by more than 30 degrees at point i, or a stretch of no length is there */
static bool ring_corner(const mus__ring *ring, int32_t i)
{
    const double *a = ring->points[(i + ring->n - 1) % ring->n].xy, *p = ring->points[i].xy;
    const double *c = ring->points[(i + 1) % ring->n].xy;
    double ux = p[0] - a[0], uy = p[1] - a[1], vx = c[0] - p[0], vy = c[1] - p[1];
    return ux * vx + uy * vy < CORNER_COSINE * sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
}


/* the vertex at p; MUS_NONE when none is within `near` [m] */
static int32_t ring_vertex(const mus__ring *ring, const double *p, double near)
{
    int32_t best = MUS_NONE;
    for (int32_t i = 0; i < ring->n; i++) {
        const double d = ring_apart(ring->points[i].xy, p);
        if (d > near) continue;
        near = d;
        best = i;
    }
    return best;
}


static void entity_place(const mus__dxf_file *file, const mus__dxf_entity *entity, int32_t i, double *out)
{
    for (int32_t k = 0; k < 2; k++) out[k] = file->unit * file->xy[2 * (size_t)(entity->first + i) + (size_t)k];
}


void mus__ring_turns(const mus__dxf_file *file, const mus__dxf_block *block, mus__ring *ring)
{
    bool any = false;
    for (int32_t i = block->first; i < block->first + block->n; i++) {
        double p[2];
        if (file->entities[i].kind != MUS__DXF_POINT || file->entities[i].layer != 2) continue;
        entity_place(file, &file->entities[i], 0, p);
        const int32_t at = ring_vertex(ring, p, RING_TOUCH);
        if (at != MUS_NONE) ring->points[at].turn = true;
    }
    for (int32_t i = 0; i < ring->n && !any; i++) any = ring->points[i].turn;
    if (any) return;
    for (int32_t i = 0; i < ring->n; i++) any |= ring->points[i].turn = ring_corner(ring, i);
    if (!any && ring->n > 0) ring->points[0].turn = true;
}


/* ---- grading ---- */

/* the number of a text "# 12"; MUS_NONE for another text */
static int32_t rule_number(mus__dxf_slice text)
{
    double x;
    if (text.length < 2 || text.at[0] != '#') return MUS_NONE;
    if (!mus__dxf_number((mus__dxf_slice){text.at + 1, text.length - 1}, &x) || x != floor(x)) return MUS_NONE;
    return x < 0.0 || x > 1e6 ? MUS_NONE : (int32_t)x;
}


/* move the points between the graded points `from` and `to` of the ring by both rules, by arc length */
static void grade_between(mus__ring *ring, int32_t from, int32_t to)
{
    const int32_t n = ring->n, count = (to - from + n - 1) % n + 1;
    const mus__ring_point *a = &ring->points[from], *b = &ring->points[to];
    double whole = 0.0, s = 0.0;
    for (int32_t i = 0; i < count; i++)
        whole += ring_apart(ring->points[(from + i) % n].xy, ring->points[(from + i + 1) % n].xy);
    for (int32_t i = 1; i < count; i++) {
        mus__ring_point *p = &ring->points[(from + i) % n];
        s += ring_apart(ring->points[(from + i - 1) % n].xy, p->xy);
        const double t = whole > 0.0 ? s / whole : 0.0;
        for (int32_t k = 0; k < 2; k++)
            p->moved[k] = p->xy[k] + (1.0 - t) * (a->moved[k] - a->xy[k]) + t * (b->moved[k] - b->xy[k]);
    }
}


mus_status mus__ring_grade(const mus__dxf_file *file, const mus__dxf_block *block, const mus__rul *rul, int32_t size,
                           mus__ring *ring)
{
    bool *graded = mus_context_alloc(file->source->context, NULL, (size_t)(ring->n > 0 ? ring->n : 1));
    if (graded == NULL) return mus__source_fail(file->source, block->line, MUS_ERR_MEMORY, "no memory for grading");
    int32_t first = MUS_NONE, last = MUS_NONE;
    mus_status status = MUS_OK;
    memset(graded, 0, (size_t)ring->n);
    for (int32_t i = block->first; i < block->first + block->n && status == MUS_OK; i++) {
        const mus__dxf_entity *entity = &file->entities[i];
        const int32_t number = entity->kind == MUS__DXF_TEXT ? rule_number(entity->text) : MUS_NONE;
        double p[2], move[2];
        if (number == MUS_NONE) continue;
        entity_place(file, entity, 0, p);
        const int32_t at = ring_vertex(ring, p, RING_JOIN);
        if (at == MUS_NONE) continue;
        if (!mus__rul_move(rul, number, size, move))
            status = mus__source_fail(file->source, entity->line, MUS_ERR_FORMAT,
                                      "grade rule %d is not in the file of rules", (int)number);
        graded[at] = true;
        mus__ring_point *point = &ring->points[at];
        for (int32_t k = 0; k < 2 && status == MUS_OK; k++) point->moved[k] = point->xy[k] + move[k];
    }
    for (int32_t i = 0; i < ring->n && status == MUS_OK; i++) {
        if (!graded[i]) continue;
        if (last != MUS_NONE) grade_between(ring, last, i);
        else first = i;
        last = i;
    }
    if (status == MUS_OK && last != MUS_NONE) grade_between(ring, last, first);
    mus_context_alloc(file->source->context, graded, 0);
    return status;
}


/* ---- mirror line ---- */

/* distance [m] of p from the line through axis */
static double line_off(const double *axis, const double *p)
{
    double dx = axis[2] - axis[0], dy = axis[3] - axis[1], d = mus__hypot(dx, dy);
    return d > 0.0 ? fabs(dx * (p[1] - axis[1]) - dy * (p[0] - axis[0])) / d : HUGE_VAL;
}


void mus__ring_mirror(const double *axis, double *p)
{
    double dx = axis[2] - axis[0], dy = axis[3] - axis[1], dd = dx * dx + dy * dy;
    double off = 2.0 * (dx * (p[1] - axis[1]) - dy * (p[0] - axis[0])) / dd;
    p[0] += off * dy;
    p[1] -= off * dx;
}


/* the side of the ring on the line: true, with the points before and behind the stretch */
static bool fold_side(const mus__ring *ring, const double *axis, int32_t *from, int32_t *to)
{
    const int32_t n = ring->n;
    for (int32_t i = 0; i < n; i++) {
        const int32_t before = (i + n - 1) % n;
        if (line_off(axis, ring->points[i].xy) > RING_TOUCH) continue;
        if (line_off(axis, ring->points[before].xy) <= RING_TOUCH) continue;
        int32_t end = i;
        while (line_off(axis, ring->points[(end + 1) % n].xy) <= RING_TOUCH && (end + 1) % n != i) end = (end + 1) % n;
        if (end == i) continue;
        *from = i;
        *to = end;
        return true;
    }
    return false;
}


mus_status mus__ring_unfold(const mus__dxf_file *file, const mus__dxf_block *block, mus__ring *ring, double *axis,
                            bool *folded)
{
    int32_t from = 0, to = 0;
    *folded = false;
    for (int32_t i = block->first; i < block->first + block->n && !*folded; i++) {
        const mus__dxf_entity *entity = &file->entities[i];
        if (entity->layer != 6 || entity->n < 2 || entity->kind == MUS__DXF_TEXT) continue;
        entity_place(file, entity, 0, axis);
        entity_place(file, entity, entity->n - 1, axis + 2);
        *folded = fold_side(ring, axis, &from, &to);
    }
    if (!*folded) return MUS_OK;

    /* the open half from the end of the fold to its start, then its image back */
    const int32_t n = ring->n, half = (from - to + n) % n + 1;
    mus__ring_point *whole = mus_context_alloc(file->source->context, NULL, 2 * (size_t)half * sizeof *whole);
    if (whole == NULL) return mus__source_fail(file->source, block->line, MUS_ERR_MEMORY, "no memory for an outline");
    const double *a = ring->points[to].moved, *b = ring->points[from].moved, line[4] = {a[0], a[1], b[0], b[1]};
    for (int32_t i = 0; i < half; i++) whole[i] = ring->points[(to + i) % n];
    for (int32_t i = 1; i + 1 < half; i++) {
        mus__ring_point *image = &whole[2 * half - 2 - i];
        *image = whole[i];
        mus__ring_mirror(axis, image->xy);
        mus__ring_mirror(line, image->moved);
    }
    mus_context_alloc(file->source->context, ring->points, 0);
    ring->points = whole;
    ring->n = 2 * half - 2;
    ring->room = 2 * half;
    /* an edge goes on over the fold where the outline is straight there */
    whole[0].turn = ring_corner(ring, 0);
    whole[half - 1].turn = ring_corner(ring, half - 1);
    return MUS_OK;
}
