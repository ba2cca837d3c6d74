/*
 * outline_crossing.c: does the outline of a panel cross or touch itself?
 *
 * Curves become 40 chords. Segments are sorted by their left end and each is tried against those that start before it
 * ends (a sweep along x); the test is by exact signs (predicate.h). Segments that share a corner are neighbours and
 * may meet there. A corner is a place of the word, not a point of the plane: where the word passes one point twice
 * it touches itself, unless it came along a bridge (an edge passed twice, as to a hole), which makes both one corner.
 */
#include <math.h>

#include "geom/curve.h"
#include "geom/predicate.h"
#include "geom/union_find.h"
#include "pattern/pattern_internal.h"

/* chords of a curved piece: the sagitta of a chord of a quarter circle is r / 5200, below 1 mm for any garment */
#define CROSSING_CHORDS 40

typedef struct crossing_segment {
    double a[2], b[2];
    int32_t corner_a, corner_b, edge;
} crossing_segment;


/* a segment in the order of the sweep, by its left end */
typedef struct crossing_place {
    double left;
    int32_t segment;
} crossing_place;


static double crossing_left(const crossing_segment *s)
{
    return s->a[0] < s->b[0] ? s->a[0] : s->b[0];
}


static double crossing_right(const crossing_segment *s)
{
    return s->a[0] < s->b[0] ? s->b[0] : s->a[0];
}


/* by left end, then by index of the chord: a strict order, whatever the sort does */
static bool crossing_before(const crossing_segment *s, const crossing_place *x, const crossing_place *y)
{
    if (x->left != y->left) return x->left < y->left;
    const crossing_segment *p = &s[x->segment], *q = &s[y->segment];
    return p->corner_b != q->corner_b ? p->corner_b < q->corner_b : p->corner_a < q->corner_a;
}


/* end of the ascending run that begins at `from` */
static int32_t crossing_run(const crossing_segment *s, const crossing_place *place, int32_t from, int32_t n)
{
    int32_t end = from + 1;
    while (end < n && !crossing_before(s, &place[end], &place[end - 1])) end++;
    return end;
}


/* reverse the descending runs: where an outline comes back, all its chords are one such run */
static void crossing_turn(const crossing_segment *s, crossing_place *place, int32_t n)
{
    for (int32_t from = 0, end; from < n; from = end) {
        end = from + 1;
        while (end < n && crossing_before(s, &place[end], &place[end - 1])) end++;
        for (int32_t i = from, j = end - 1; i < j; i++, j--) {
            const crossing_place swap = place[i];
            place[i] = place[j];
            place[j] = swap;
        }
    }
}


/* natural merge sort, n log(runs): an outline goes to and fro in x a few times only. spare (n); where the sorted
 * places are, one of the two */
static crossing_place *crossing_sort(const crossing_segment *s, crossing_place *place, crossing_place *spare, int32_t n)
{
    crossing_turn(s, place, n);
    while (n > 0 && crossing_run(s, place, 0, n) < n) {
        for (int32_t from = 0, at = 0; from < n; from = at) {
            const int32_t half = crossing_run(s, place, from, n);
            const int32_t end = half < n ? crossing_run(s, place, half, n) : n;
            for (int32_t i = from, j = half; at < end; at++)
                spare[at] =
                    j >= end || (i < half && !crossing_before(s, &place[j], &place[i])) ? place[i++] : place[j++];
        }
        crossing_place *swap = place;
        place = spare;
        spare = swap;
    }
    return place;
}


/* do two segments whose boxes overlap in x meet? */
static bool crossing_meet(const crossing_segment *s, const crossing_segment *t)
{
    if (fmax(s->a[1], s->b[1]) < fmin(t->a[1], t->b[1]) || fmax(t->a[1], t->b[1]) < fmin(s->a[1], s->b[1]))
        return false;
    double d1 = mus__orient2d(s->a, s->b, t->a), d2 = mus__orient2d(s->a, s->b, t->b);
    if ((d1 > 0.0 && d2 > 0.0) || (d1 < 0.0 && d2 < 0.0)) return false;
    double d3 = mus__orient2d(t->a, t->b, s->a), d4 = mus__orient2d(t->a, t->b, s->b);
    return !((d3 > 0.0 && d4 > 0.0) || (d3 < 0.0 && d4 < 0.0));
}


/* corners of the word that a bridge makes one; place (nedge) gets the first position of each edge */
static void crossing_corners(const mus__panel *panel, int32_t *corner, int32_t *sign, int32_t *place)
{
    int32_t n = panel->noutline;
    mus__union_start(n, corner, sign);
    for (int32_t k = 0; k < n; k++) {
        int32_t j = place[panel->outline[k]] - 1;
        if (j < 0) {
            place[panel->outline[k]] = k + 1;
            continue;
        }
        int32_t j_end = j + 1 < n ? j + 1 : 0, k_end = k + 1 < n ? k + 1 : 0;
        bool against = panel->outline[n + j] != panel->outline[n + k];
        mus__union_join(corner, sign, j, against ? k_end : k, 1);
        mus__union_join(corner, sign, j_end, against ? k : k_end, 1);
    }
    for (int32_t k = 0; k < n; k++) mus__union_find(corner, sign, k);
}


/* chords of one edge from corner `first` to corner `last`; inner nodes are corners of their own, from *next on. A
 * chord without length is left out. Returns how many were written. */
static int32_t crossing_flatten(const mus__edge *edge, int32_t index, int32_t first, int32_t last, int32_t *next,
                                crossing_segment *out)
{
    const double *p = edge->xy, *from = edge->xy;
    int32_t count = 0, corner = first;
    for (int32_t i = 0; i < edge->npiece; i++) {
        int32_t kind = edge->kinds[i], n = kind == MUS_PIECE_LINE ? 1 : CROSSING_CHORDS;
        int32_t size = mus__curve_points(kind) - 1;
        for (int32_t j = 1; j <= n; j++) {
            crossing_segment *s = &out[count];
            s->b[0] = p[2 * size], s->b[1] = p[2 * size + 1];
            if (j < n) mus__curve_at(kind, p, (double)j / n, s->b);
            if (s->b[0] == from[0] && s->b[1] == from[1]) continue;
            s->a[0] = from[0], s->a[1] = from[1];
            s->corner_a = corner;
            s->corner_b = corner = (*next)++;
            s->edge = index;
            from = s->b;
            count++;
        }
        p += 2 * size;
    }
    if (count > 0) out[count - 1].corner_b = last;
    return count;
}


mus_status mus__panel_crosses(const mus_pattern *pattern, int32_t panel, bool *crosses, int32_t *a, int32_t *b)
{
    const mus__panel *own = &pattern->panel[panel];
    mus_context *context = pattern->context;
    int32_t n = own->noutline, next = n, count = 0;
    *crosses = false;
    int64_t room = 0;
    for (int32_t k = 0; k < n; k++) room += (int64_t)pattern->edge[own->outline[k]].npiece * CROSSING_CHORDS;
    if (room > INT32_MAX - n) return mus__fail(context, MUS_ERR_LIMIT, "panel %s: its outline is too long", own->name);

    crossing_segment *segment = mus__room(context, room, sizeof *segment);
    crossing_place *order = mus__room(context, 2 * room, sizeof *order);
    int32_t *corner = mus__new(context, 2 * (int64_t)n + pattern->nedge, sizeof *corner);
    mus_status status = MUS_OK;
    if (segment == NULL || order == NULL || corner == NULL) {
        status = mus__fail_memory(context, "the check of an outline");
        goto done;
    }

    /* flatten each edge once, the second side of a bridge is the same line */
    int32_t *place = corner + 2 * (size_t)n;
    crossing_corners(own, corner, corner + n, place);
    for (int32_t k = 0; k < n; k++) {
        int32_t edge = own->outline[k], end = k + 1 < n ? k + 1 : 0;
        if (place[edge] != k + 1) continue;
        bool along = own->outline[n + k] > 0;
        count += crossing_flatten(&pattern->edge[edge], edge, corner[along ? k : end], corner[along ? end : k], &next,
                                  segment + count);
    }

    for (int32_t i = 0; i < count; i++) order[i] = (crossing_place){crossing_left(&segment[i]), i};
    const crossing_place *sorted = crossing_sort(segment, order, order + room, count);
    for (int32_t i = 0; i < count && !*crosses; i++) {
        const crossing_segment *s = &segment[sorted[i].segment];
        for (int32_t j = i + 1; j < count && sorted[j].left <= crossing_right(s); j++) {
            const crossing_segment *t = &segment[sorted[j].segment];
            bool neighbours = s->corner_a == t->corner_a || s->corner_a == t->corner_b || s->corner_b == t->corner_a ||
                              s->corner_b == t->corner_b;
            if (neighbours || !crossing_meet(s, t)) continue;
            *crosses = true;
            *a = s->edge < t->edge ? s->edge : t->edge;
            *b = s->edge < t->edge ? t->edge : s->edge;
            break;
        }
    }
done:
    mus__free(context, segment);
    mus__free(context, order);
    mus__free(context, corner);
    return status;
}
