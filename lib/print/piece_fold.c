/*
 * piece_fold.c: a symmetric piece as its half, for the fold of the cloth.
 *
 * A piece is symmetric when its sew line, cut line, notches and marks are their own mirror images in the upright line
 * through its middle, which is parallel to the grain, and edges that come to lie on each other are both sewn, or free
 * with the same label. So a band whose grain runs along it is no half: its free edge would lie on the one it is sewn
 * by. The half right of that line is kept: polygons are clipped, lines and cubics are split where they cross it.
 */
#include <math.h>
#include <string.h>

#include "print/piece.h"

#define FOLD_NEAR 5e-5  /* [m] two lines this near are one; chosen: a tenth of the width of a cut line */
#define FOLD_NOTCH 1e-3 /* [m] two notches this near are mirror images; chosen: below what is cut by hand */
#define FOLD_HALVINGS 50 /* halvings to find where a cubic crosses; chosen: below rounding */


/* distance [m] of a point from a line of n points, closed or not */
static double fold_distance(const double *p, int32_t n, const double *xy, bool closed)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < (closed || n == 1 ? n : n - 1); i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n);
        const double dx = b[0] - a[0], dy = b[1] - a[1], d = dx * dx + dy * dy;
        double t = d > 0.0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / d : 0.0;
        t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
        const double x = p[0] - a[0] - t * dx, y = p[1] - a[1] - t * dy;
        best = fmin(best, sqrt(x * x + y * y));
    }
    return best;
}


/* is a closed line its own mirror image in x = axis? */
static bool fold_mirrors(int32_t n, const double *xy, double axis)
{
    for (int32_t i = 0; i < n; i++) {
        const double p[2] = {2.0 * axis - xy[2 * i], xy[2 * i + 1]};
        if (fold_distance(p, n, xy, true) > FOLD_NEAR) return false;
    }
    return true;
}


/* are two edges alike: both sewn, or free with the same label? */
static bool fold_alike(const mus_pattern *pattern, int32_t a, int32_t b)
{
    const bool sewn = mus_pattern_edge_seam(pattern, a) != MUS_NONE;
    if (sewn != (mus_pattern_edge_seam(pattern, b) != MUS_NONE)) return false;
    return sewn || strcmp(mus_pattern_edge_label(pattern, a), mus_pattern_edge_label(pattern, b)) == 0;
}


/* are edges that come to lie on each other alike? Asked at the middle of each chord, of the chord that its image lies
 * on; at a corner either one will do */
static bool fold_edges_mirror(const mus_pattern *pattern, const mus__piece *piece, double axis)
{
    for (int32_t i = 0; i < piece->nflat; i++) {
        const double *a = piece->flat + 2 * i, *b = piece->flat + 2 * ((i + 1) % piece->nflat);
        const double p[2] = {2.0 * axis - 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
        const int32_t edge = piece->sides[piece->flat_side[i]].edge;
        bool found = false;
        for (int32_t k = 0; k < piece->nflat && !found; k++) {
            double line[4];
            memcpy(line, piece->flat + 2 * k, 2 * sizeof *line);
            memcpy(line + 2, piece->flat + 2 * ((k + 1) % piece->nflat), 2 * sizeof *line);
            found = fold_distance(p, 2, line, false) < FOLD_NOTCH &&
                    fold_alike(pattern, edge, piece->sides[piece->flat_side[k]].edge);
        }
        if (!found) return false;
    }
    return true;
}


/* the place of a notch on the sheet; false when it is not on the piece */
static bool fold_notch(const mus_pattern *pattern, const mus__piece *piece, int32_t notch, int32_t *kind, double *out)
{
    int32_t edge, side = 0;
    double s, xy[2];
    if (mus_pattern_notch(pattern, notch, &edge, &s, kind) != MUS_OK) return false;
    while (side < piece->nside && piece->sides[side].edge != edge) side++;
    if (side == piece->nside) return false;
    const double t = fmin(1.0, s / mus_pattern_edge_length(pattern, edge));
    if (mus_pattern_edge_at(pattern, edge, 1, &t, xy) != MUS_OK) return false;
    mus__piece_point(piece, xy, out);
    return true;
}


static bool fold_notches_mirror(const mus_pattern *pattern, const mus__piece *piece, double axis)
{
    const int32_t n = mus_pattern_notch_count(pattern);
    for (int32_t i = 0; i < n; i++) {
        int32_t kind, other;
        double p[2], q[2];
        if (!fold_notch(pattern, piece, i, &kind, p)) continue;
        bool found = false;
        for (int32_t j = 0; j < n && !found; j++)
            found = fold_notch(pattern, piece, j, &other, q) && other == kind &&
                    fabs(2.0 * axis - p[0] - q[0]) + fabs(p[1] - q[1]) < FOLD_NOTCH;
        if (!found) return false;
    }
    return true;
}


/* does a mark of the piece pass the point p of the sheet? */
static bool fold_marked(const mus_pattern *pattern, const mus__piece *piece, const double *p)
{
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        int32_t panel, n;
        const double *xy;
        if (mus_pattern_mark(pattern, i, &panel, NULL, &n, &xy) != MUS_OK || panel != piece->panel) continue;
        for (int32_t k = 0; k < n; k++) {
            double line[4];
            mus__piece_point(piece, xy + 2 * k, line);
            mus__piece_point(piece, xy + 2 * (k + 1 < n ? k + 1 : k), line + 2);
            if (fold_distance(p, 2, line, false) < FOLD_NOTCH) return true;
        }
    }
    return false;
}


static bool fold_marks_mirror(const mus_pattern *pattern, const mus__piece *piece, double axis)
{
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        int32_t panel, n;
        const double *xy;
        if (mus_pattern_mark(pattern, i, &panel, NULL, &n, &xy) != MUS_OK || panel != piece->panel) continue;
        for (int32_t k = 0; k < n; k++) {
            double p[2];
            mus__piece_point(piece, xy + 2 * k, p);
            p[0] = 2.0 * axis - p[0];
            if (!fold_marked(pattern, piece, p)) return false;
        }
    }
    return true;
}


/* clip a closed line to x >= axis, in place; side (n) goes along or is NULL. Returns the number of points, at most
 * 2 n; the caller gives room */
static int32_t fold_clip(int32_t n, const double *xy, const int32_t *side, double axis, double *out, int32_t *out_side)
{
    int32_t count = 0;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n);
        const bool in = a[0] >= axis, next = b[0] >= axis;
        if (in) {
            memcpy(out + 2 * count, a, 2 * sizeof *a);
            if (side != NULL) out_side[count] = side[i];
            count++;
        }
        if (in == next) continue;
        out[2 * count] = axis;
        out[2 * count + 1] = a[1] + (b[1] - a[1]) * (axis - a[0]) / (b[0] - a[0]);
        if (side != NULL) out_side[count] = side[i];
        count++;
    }
    return count;
}


/* split a cubic (four points) at t: the part before or behind */
static void fold_part(double *p, double t, bool behind)
{
    double q[4][2];
    for (int32_t k = 0; k < 4; k++) memcpy(q[behind ? 3 - k : k], p + 2 * k, sizeof *q);
    const double s = behind ? 1.0 - t : t;
    for (int32_t round = 1; round < 4; round++)
        for (int32_t k = 3; k >= round; k--)
            for (int32_t d = 0; d < 2; d++) q[k][d] = q[k - 1][d] + s * (q[k][d] - q[k - 1][d]);
    for (int32_t k = 0; k < 4; k++) memcpy(p + 2 * (behind ? 3 - k : k), q[k], sizeof *q);
}


/* keep the part of each line and cubic of the sew line that lies right of the axis */
static void fold_spans(mus__piece *piece, double axis)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < piece->nspan; i++) {
        mus__span span = piece->spans[i];
        const bool from = span.p[0] >= axis - 1e-9, to = span.p[6] >= axis - 1e-9;
        if (!from && !to) continue;
        if (from != to) {
            double low = 0.0, high = 1.0, at[2] = {0.0, 0.0};
            for (int32_t k = 0; k < FOLD_HALVINGS; k++) {
                const double t = 0.5 * (low + high);
                if (span.line) at[0] = span.p[0] + t * (span.p[6] - span.p[0]);
                else mus__cubic_at(span.p, t, at);
                if ((at[0] >= axis) == from) low = t;
                else high = t;
            }
            if (span.line) {
                double *end = span.p + (from ? 6 : 0);
                end[1] = span.p[1] + low * (span.p[7] - span.p[1]);
                end[0] = axis;
                memcpy(span.p + 2, span.p, 2 * sizeof *span.p);
                memcpy(span.p + 4, span.p + 6, 2 * sizeof *span.p);
            } else {
                fold_part(span.p, low, to);
                span.p[from ? 6 : 0] = axis;
            }
        }
        if (fabs(span.p[0] - axis) < 1e-9 && fabs(span.p[6] - axis) < 1e-9) continue;
        piece->spans[kept++] = span;
    }
    piece->nspan = kept;
}


/* the half of the sew line and the cut line */
static mus_status fold_lines(mus_context *context, mus__piece *piece, double axis)
{
    mus__loops *cut = &piece->cut;
    double *flat = mus__print_new(context, 4 * (int64_t)piece->nflat, sizeof *flat);
    int32_t *side = mus__print_new(context, 2 * (int64_t)piece->nflat, sizeof *side);
    double *xy = mus__print_new(context, 4 * (int64_t)cut->n, sizeof *xy);
    if (flat == NULL || side == NULL || xy == NULL) {
        mus__print_free(context, flat);
        mus__print_free(context, side);
        mus__print_free(context, xy);
        return mus__print_memory(context, "a half piece");
    }
    piece->nflat = fold_clip(piece->nflat, piece->flat, piece->flat_side, axis, flat, side);
    cut->n = fold_clip(cut->n, cut->xy, NULL, axis, xy, NULL);
    cut->start[1] = cut->n;
    mus__print_free(context, piece->flat);
    mus__print_free(context, piece->flat_side);
    mus__print_free(context, cut->xy);
    piece->flat = flat, piece->flat_side = side, cut->xy = xy;
    fold_spans(piece, axis);
    return MUS_OK;
}


mus_status mus__piece_fold(mus_context *context, const mus_pattern *pattern, mus__piece *piece)
{
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (int32_t i = 0; i < piece->nflat; i++) {
        left = fmin(left, piece->flat[2 * i]);
        right = fmax(right, piece->flat[2 * i]);
    }
    const double axis = 0.5 * (left + right);
    if (piece->cut.nloop != 1 || !fold_mirrors(piece->nflat, piece->flat, axis) ||
        !fold_mirrors(piece->cut.n, piece->cut.xy, axis) || !fold_notches_mirror(pattern, piece, axis) ||
        !fold_marks_mirror(pattern, piece, axis) || !fold_edges_mirror(pattern, piece, axis))
        return MUS_OK;
    piece->fold = true;
    piece->axis = axis;
    const mus_status status = fold_lines(context, piece, axis);
    if (status == MUS_OK) mus__piece_box(piece);
    return status;
}
