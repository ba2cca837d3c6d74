/*
 * polygon_offset.c: offset a closed polygon outwards, each side by its own width: the sew line becomes the cut line.
 *
 * Called once for each piece, with 10^2 to 10^4 points. Two steps:
 *
 * 1. A raw closed path: the sides moved out along their normals, joined at the corners. A corner that turns outwards
 *    gets a mitre (limit 2.5), or is cut off at one width beyond a sharp point; a corner that turns inwards is trimmed
 *    where the moved sides meet, or, when they are too short for that, joined through the corner itself. A wide
 *    allowance beside a narrow one that cannot be mitred ends square to its seam. Sides that are given are part of the
 *    cut line already (the ends of a hem): the moved side before them is joined straight to their second point.
 *
 *        A ----- M        A, B: ends of the moved sides, M: the mitre, V: the corner
 *        |       |        A = V + w1 n1, B = V + w2 n2, M = A + a d1 = B - b d2 with, t the turn from d1 to d2,
 *     d1 ^       B        a = (w2 - w1 cos t) / sin t,  b = (w1 - w2 cos t) / sin t
 *        |       |
 *        V -->-- '
 *
 *    The raw path is then the sum, as chains, of the polygon and of small pieces (strip of each side, wedge of each
 *    corner) that all run counter-clockwise. So its winding number is nowhere negative, and it is positive exactly on
 *    the union of these pieces: the cloth to cut.
 * 2. Loops: the path is split at its crossings into simple closed curves (at each crossing both strands swap, as in
 *    Seifert's construction). These curves separate areas of different winding numbers. Those between 0 and 1 are kept:
 *    the outer one is the cut line, those that run clockwise are holes.
 *
 * The points are first moved by up to 10 nm, each by an amount that depends on its index only. Then no two sides lie on
 * one line and no corner lies on a side, so that plain crossing tests in double are enough.
 * Source of the winding argument: Wein, Exact and approximate construction of offset polygons, 2007, section 3.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "pattern/polygon_offset.h"

#define MITRE_LIMIT 2.5  /* longest mitre over the wider allowance; a longer one is cut off. Chosen */
#define JITTER 1e-8      /* [m] largest move of a point; chosen: far above rounding (1e-15), far below 0.1 mm */
#define LOOP_AREA 1e-5   /* [m2] least area of a hole that is kept; chosen: a tenth of a cm2, less is of no use */

typedef struct raw_path {
    mus_context *context;
    mus_status status;
    int32_t n;
    int32_t room;
    double *xy;
} raw_path;

/* a strand of the raw path starts at a corner or at a crossing */
typedef struct strand {
    int32_t side;
    int32_t partner; /* strand that starts at the same crossing on the other side, or MUS_NONE */
    double t;        /* start of the strand along the side, 0..1 */
} strand;


static void raw_add(raw_path *raw, double x, double y)
{
    if (raw->status != MUS_OK) return;
    const double *last = raw->n > 0 ? raw->xy + 2 * (ptrdiff_t)(raw->n - 1) : NULL;
    if (last != NULL && fabs(last[0] - x) + fabs(last[1] - y) < JITTER) return; /* the jitter would make a loop of it */
    raw->status = mus__reserve(raw->context, &raw->xy, &raw->room, 2 * (int64_t)raw->n + 2, sizeof *raw->xy);
    if (raw->status != MUS_OK) return;
    raw->xy[2 * raw->n] = x;
    raw->xy[2 * raw->n + 1] = y;
    raw->n++;
}


/* the corner V between two sides: their directions, normals, widths and lengths */
typedef struct corner {
    double v[2], d1[2], d2[2], w1, w2, l1, l2, sine, cosine;
} corner;


/* add the point V + along d + out n, with n the right-hand normal of d */
static void corner_point(raw_path *raw, const corner *c, const double *d, double along, double out)
{
    raw_add(raw, c->v[0] + along * d[0] + out * d[1], c->v[1] + along * d[1] - out * d[0]);
}


/* a corner that turns outwards: mitred, cut off, or square */
static void corner_outer(raw_path *raw, const corner *c)
{
    double a = (c->w2 - c->w1 * c->cosine) / c->sine;
    double b = (c->w1 - c->w2 * c->cosine) / c->sine;
    double wide = c->w1 > c->w2 ? c->w1 : c->w2;

    /* the wide strip ends square, and the narrow one runs into its end */
    if (a < 0.0) {
        corner_point(raw, c, c->d1, 0.0, c->w1);
        corner_point(raw, c, c->d1, 0.0, c->w2 / c->cosine);
        corner_point(raw, c, c->d2, 0.0, c->w2);
        return;
    }
    if (b < 0.0) {
        corner_point(raw, c, c->d1, 0.0, c->w1);
        corner_point(raw, c, c->d2, 0.0, c->w1 / c->cosine);
        corner_point(raw, c, c->d2, 0.0, c->w2);
        return;
    }
    double reach = sqrt(a * a + c->w1 * c->w1);
    if (reach <= MITRE_LIMIT * wide) {
        corner_point(raw, c, c->d1, a, c->w1);
        return;
    }
    /* cut off square to the line from the corner to the mitre, one width away: the share of that line which is kept
     * shortens a and b alike, since A and B project to cut_a and cut_b on it */
    double cut_a = c->w1 * c->w1 / reach, cut_b = c->w2 * c->w2 / reach;
    corner_point(raw, c, c->d1, a * (wide - cut_a) / (reach - cut_a), c->w1);
    corner_point(raw, c, c->d2, -b * (wide - cut_b) / (reach - cut_b), c->w2);
}


/* a corner that turns inwards: trimmed where the moved sides meet if both are long enough, else through V */
static void corner_inner(raw_path *raw, const corner *c)
{
    double a = (c->w2 - c->w1 * c->cosine) / c->sine;
    double b = (c->w1 - c->w2 * c->cosine) / c->sine;
    if (a <= 0.0 && b <= 0.0 && -a < 0.5 * c->l1 && -b < 0.5 * c->l2) {
        corner_point(raw, c, c->d1, a, c->w1);
        return;
    }
    corner_point(raw, c, c->d1, 0.0, c->w1);
    if (c->w1 > 0.0 && c->w2 > 0.0) corner_point(raw, c, c->d1, 0.0, 0.0);
    corner_point(raw, c, c->d2, 0.0, c->w2);
}


static void raw_corner(raw_path *raw, const corner *c, bool given_one, bool given_two)
{
    if (given_one || given_two) corner_point(raw, c, given_two ? c->d1 : c->d2, 0.0, given_two ? c->w1 : c->w2);
    else if (c->sine > 1e-9) corner_outer(raw, c);
    else if (c->sine < -1e-9) corner_inner(raw, c);
    else {
        /* straight on, or straight back */
        corner_point(raw, c, c->d1, 0.0, c->w1);
        if (c->w1 != c->w2 || c->cosine < 0.0) corner_point(raw, c, c->d2, 0.0, c->w2);
    }
}


/* a number in -1..1 that depends on the index only (a multiplicative hash) */
static double offset_jitter(uint32_t index)
{
    uint32_t h = (index + 1U) * UINT32_C(2654435761);
    h ^= h >> 15;
    h *= UINT32_C(2246822519);
    h ^= h >> 13;
    return (double)h / 2147483648.0 - 1.0;
}


static void raw_build(raw_path *raw, int32_t n, const double *xy, const double *width, const unsigned char *given)
{
    for (int32_t i = 0; i < n && raw->status == MUS_OK; i++) {
        int32_t before = (i + n - 1) % n, after = (i + 1) % n;
        corner c = {.w1 = width[before], .w2 = width[i]};
        for (int32_t k = 0; k < 2; k++) {
            c.v[k] = xy[2 * i + k];
            c.d1[k] = c.v[k] - xy[2 * before + k];
            c.d2[k] = xy[2 * after + k] - c.v[k];
        }
        c.l1 = sqrt(c.d1[0] * c.d1[0] + c.d1[1] * c.d1[1]);
        c.l2 = sqrt(c.d2[0] * c.d2[0] + c.d2[1] * c.d2[1]);
        for (int32_t k = 0; k < 2; k++) {
            c.d1[k] /= c.l1;
            c.d2[k] /= c.l2;
        }
        c.sine = c.d1[0] * c.d2[1] - c.d1[1] * c.d2[0];
        c.cosine = c.d1[0] * c.d2[0] + c.d1[1] * c.d2[1];
        raw_corner(raw, &c, given != NULL && given[before], given != NULL && given[i]);
    }
    for (int32_t i = 0; i < 2 * raw->n; i++) raw->xy[i] += JITTER * offset_jitter((uint32_t)i);
}


/* a side of the raw path, to be sorted by its low x */
typedef struct swept {
    double low, high;
    int32_t side;
} swept;


static int swept_compare(const void *left, const void *right)
{
    const swept *a = left, *b = right;
    if (a->low != b->low) return a->low < b->low ? -1 : 1;
    return a->side < b->side ? -1 : a->side > b->side;
}


/* do sides i and j cross? t along i and u along j, 0..1, of the crossing */
static bool sides_cross(int32_t n, const double *xy, int32_t i, int32_t j, double *t, double *u)
{
    const double *p = xy + 2 * i, *q = xy + 2 * ((i + 1) % n), *r = xy + 2 * j, *s = xy + 2 * ((j + 1) % n);
    if ((p[1] > r[1] && p[1] > s[1] && q[1] > r[1] && q[1] > s[1]) ||
        (p[1] < r[1] && p[1] < s[1] && q[1] < r[1] && q[1] < s[1]))
        return false;

    /* p + t (q - p) = r + u (s - r) */
    double ax = q[0] - p[0], ay = q[1] - p[1], bx = s[0] - r[0], by = s[1] - r[1], cx = r[0] - p[0], cy = r[1] - p[1];
    double det = ax * by - ay * bx;
    if (det == 0.0) return false;
    *t = (cx * by - cy * bx) / det;
    *u = (cx * ay - cy * ax) / det;
    return *t > 0.0 && *t < 1.0 && *u > 0.0 && *u < 1.0;
}


typedef struct strands {
    int32_t n;
    int32_t room;
    strand *list;
} strands;


static mus_status strands_add(mus_context *context, strands *all, int32_t side, double t, int32_t partner)
{
    mus_status status = mus__reserve(context, &all->list, &all->room, (int64_t)all->n + 1, sizeof *all->list);
    if (status == MUS_OK) all->list[all->n++] = (strand){side, partner, t};
    return status;
}


/* find all strands: one from each corner, two from each crossing; partner is an index into this unsorted list */
static mus_status strands_find(mus_context *context, int32_t n, const double *xy, strands *all)
{
    swept *order = mus__new(context, n, sizeof *order);
    if (order == NULL) return mus__fail_memory(context, "the sides of a cut line");
    for (int32_t i = 0; i < n; i++) {
        double a = xy[2 * i], b = xy[2 * ((i + 1) % n)];
        order[i] = (swept){a < b ? a : b, a < b ? b : a, i};
    }
    mus__sort(order, (size_t)n, sizeof *order, swept_compare);

    mus_status status = MUS_OK;
    for (int32_t i = 0; i < n && status == MUS_OK; i++) status = strands_add(context, all, i, 0.0, MUS_NONE);
    for (int32_t k = 0; k < n && status == MUS_OK; k++) {
        for (int32_t m = k + 1; m < n && order[m].low <= order[k].high && status == MUS_OK; m++) {
            int32_t i = order[k].side, j = order[m].side;
            double t, u;
            if ((i + 1) % n == j || (j + 1) % n == i || !sides_cross(n, xy, i, j, &t, &u)) continue;
            status = strands_add(context, all, i, t, all->n + 1);
            if (status == MUS_OK) status = strands_add(context, all, j, u, all->n - 1);
        }
    }
    mus__free(context, order);
    return status;
}


/* a strand with its index before sorting */
typedef struct ranked {
    strand own;
    int32_t old;
} ranked;


static int ranked_compare(const void *left, const void *right)
{
    const ranked *a = left, *b = right;
    if (a->own.side != b->own.side) return a->own.side < b->own.side ? -1 : 1;
    if (a->own.t != b->own.t) return a->own.t < b->own.t ? -1 : 1;
    return a->old < b->old ? -1 : a->old > b->old;
}


/* sort the strands along the path and renumber the partners */
static mus_status strands_sort(mus_context *context, strands *all)
{
    ranked *order = mus__new(context, all->n, sizeof *order);
    int32_t *place = mus__new(context, all->n, sizeof *place);
    if (order != NULL && place != NULL) {
        for (int32_t i = 0; i < all->n; i++) order[i] = (ranked){all->list[i], i};
        mus__sort(order, (size_t)all->n, sizeof *order, ranked_compare);
        for (int32_t i = 0; i < all->n; i++) place[order[i].old] = i;
        for (int32_t i = 0; i < all->n; i++) {
            all->list[i] = order[i].own;
            if (all->list[i].partner != MUS_NONE) all->list[i].partner = place[all->list[i].partner];
        }
    }
    mus_status status = order == NULL || place == NULL ? mus__fail_memory(context, "crossings of a cut line") : MUS_OK;
    mus__free(context, order);
    mus__free(context, place);
    return status;
}


/* strand after k: at a crossing the loop changes to the partner, at a corner it goes on */
static int32_t strand_next(const strands *all, int32_t k)
{
    int32_t next = (k + 1) % all->n;
    return all->list[next].partner != MUS_NONE ? all->list[next].partner : next;
}


static void strand_point(int32_t n, const double *xy, const strand *s, double *out)
{
    const double *p = xy + 2 * s->side, *q = xy + 2 * ((s->side + 1) % n);
    for (int32_t k = 0; k < 2; k++) out[k] = p[k] + s->t * (q[k] - p[k]);
}


/* winding number of the raw path round a point */
static int32_t raw_winding(int32_t n, const double *xy, const double *p)
{
    int32_t winding = 0;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n);
        if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
        double side = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        if (b[1] > a[1] && side > 0.0) winding++;
        if (b[1] < a[1] && side < 0.0) winding--;
    }
    return winding;
}


/* trace the loop from strand k and mark its strands as seen; out gets its points, or is NULL. Returns twice the area */
static double loop_trace(int32_t n, const double *xy, const strands *all, int32_t k, unsigned char *seen, double *out,
                         int32_t *count)
{
    double area = 0.0, first[2], last[2];
    int32_t at = k, m = 0;
    strand_point(n, xy, &all->list[k], first);
    memcpy(last, first, sizeof last);
    do {
        double p[2];
        strand_point(n, xy, &all->list[at], p);
        seen[at] = 1;
        area += (last[0] - first[0]) * (p[1] - first[1]) - (last[1] - first[1]) * (p[0] - first[0]);
        /* points no farther apart than the jitter become one */
        if (m == 0 || fabs(p[0] - last[0]) + fabs(p[1] - last[1]) > 1e-7) {
            if (out != NULL) memcpy(out + 2 * m, p, sizeof p);
            m++;
        }
        memcpy(last, p, sizeof last);
        at = strand_next(all, at);
    } while (at != k);
    *count = m;
    return area;
}


/* winding number just right of the loop's longest strand */
static int32_t loop_outside(int32_t n, const double *xy, const strands *all, int32_t k)
{
    double best = -1.0, p[2] = {0, 0};
    int32_t at = k;
    do {
        int32_t next = strand_next(all, at);
        double a[2], b[2];
        strand_point(n, xy, &all->list[at], a);
        strand_point(n, xy, &all->list[next], b);
        double dx = b[0] - a[0], dy = b[1] - a[1], length = sqrt(dx * dx + dy * dy);
        if (length > best) {
            best = length;
            p[0] = 0.5 * (a[0] + b[0]) + 20.0 * JITTER * dy / length;
            p[1] = 0.5 * (a[1] + b[1]) - 20.0 * JITTER * dx / length;
        }
        at = next;
    } while (at != k);
    return raw_winding(n, xy, p);
}


/* keep the loops between winding numbers 0 and 1: the outer loop, then the holes */
static mus_status loops_collect(mus_context *context, const raw_path *raw, const strands *all, mus__cut_loops *out)
{
    unsigned char *seen = mus__new(context, all->n, 1);
    out->xy = mus__new(context, all->n, 2 * sizeof *out->xy);
    out->start = mus__new(context, (int64_t)all->n + 1, sizeof *out->start);
    if (seen == NULL || out->xy == NULL || out->start == NULL) {
        mus__free(context, seen);
        return mus__fail_memory(context, "a cut line");
    }
    /* the outer loop passes the lowest corner; it comes first, then the holes */
    int32_t lowest = 0, count;
    for (int32_t i = 1; i < raw->n; i++)
        if (raw->xy[2 * i + 1] < raw->xy[2 * lowest + 1]) lowest = i;
    for (int32_t k = -1; k < all->n; k++) {
        int32_t from = k;
        if (k < 0)
            for (from = 0; all->list[from].side != lowest || all->list[from].partner != MUS_NONE;) from++;
        if (seen[from]) continue;
        double area = loop_trace(raw->n, raw->xy, all, from, seen, out->xy + 2 * out->n, &count);
        if (k >= 0 && (area > -2.0 * LOOP_AREA || loop_outside(raw->n, raw->xy, all, from) != 0)) continue;
        out->start[out->nloop++] = out->n;
        out->n += count;
    }
    out->start[out->nloop] = out->n;
    mus__free(context, seen);
    return MUS_OK;
}


void mus__cut_loops_free(mus_context *context, mus__cut_loops *loops)
{
    mus__free(context, loops->start);
    mus__free(context, loops->xy);
    memset(loops, 0, sizeof *loops);
}


mus_status mus__offset(mus_context *context, int32_t n, const double *xy, const double *width,
                       const unsigned char *given, mus__cut_loops *out)
{
    raw_path raw = {.context = context};
    strands all = {0, 0, NULL};
    memset(out, 0, sizeof *out);

    double widest = 0.0;
    for (int32_t i = 0; i < n; i++) widest = width[i] > widest ? width[i] : widest;
    mus_status status = MUS_OK;
    if (widest > 0.0) {
        raw_build(&raw, n, xy, width, given);
        status = raw.status;
        if (status == MUS_OK) status = strands_find(context, raw.n, raw.xy, &all);
        if (status == MUS_OK) status = strands_sort(context, &all);
        if (status == MUS_OK) status = loops_collect(context, &raw, &all, out);
    } else {
        /* all widths are 0: the polygon itself, unmoved */
        out->xy = mus__new(context, n, 2 * sizeof *out->xy);
        out->start = mus__new(context, 2, sizeof *out->start);
        if (out->xy == NULL || out->start == NULL) status = mus__fail_memory(context, "a cut line");
        else memcpy(out->xy, xy, 2 * (size_t)n * sizeof *out->xy);
        out->n = n;
        out->nloop = 1;
        if (out->start != NULL) out->start[1] = n;
    }
    mus__free(context, raw.xy);
    mus__free(context, all.list);
    if (status != MUS_OK) mus__cut_loops_free(context, out);
    return status;
}
