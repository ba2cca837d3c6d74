/*
 * piece_notches.c: the notches of a placed piece.
 *
 * A notch stands on the cut line where the normal of the sew line at the notch meets it: one slit for a single notch,
 * two for a double, three for a triple one, whose middle slit is its place. A slit is 5 mm deep, or ends 2 mm before
 * the sew line, whichever is less.
 */
#include <math.h>

#include "print/piece.h"

#define SLIT_DEPTH 0.005  /* [m] deepest slit of a notch; chosen: half the usual seam allowance of 1 cm */
#define SLIT_CLEAR 0.002  /* [m] least gap between slit and sew line; chosen: a slit must not open a seam */
#define SLIT_LEAST 0.0025 /* [m] shortest slit; chosen: a shorter one cannot be found on the cloth */
#define SLIT_APART 0.004  /* [m] distance of the slits of one notch; chosen: they can be told apart by eye */


/* distance [m] from p along n to the cut line, at least `least`; `least` when the ray misses the cut line */
static double notch_reach(const mus__piece *piece, const double *p, const double *n, double least)
{
    double best = -1.0;
    for (int32_t l = 0; l < piece->cut.nloop; l++) {
        int32_t start = piece->cut.start[l], end = piece->cut.start[l + 1];
        for (int32_t i = start; i < end; i++) {
            const double *a = piece->cut.xy + 2 * i, *b = piece->cut.xy + 2 * (i + 1 < end ? i + 1 : start);
            double dx = b[0] - a[0], dy = b[1] - a[1], det = n[0] * dy - n[1] * dx;
            if (det == 0.0) continue;
            double cx = a[0] - p[0], cy = a[1] - p[1];
            double t = (cx * dy - cy * dx) / det, u = (cx * n[1] - cy * n[0]) / det;
            if (u < 0.0 || u > 1.0 || t < least - 1e-4) continue;
            if (best < 0.0 || t < best) best = t;
        }
    }
    return best < 0.0 ? least : best;
}


/* draw one slit at arc length s [m] of a side */
static void notch_slit(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, const mus__side *side,
                       double s, double length)
{
    double t = s / length, near = 1e-4, at[3], xy[6], p[6];
    at[0] = t;
    at[1] = t - near > 0.0 ? t - near : 0.0;
    at[2] = t + near < 1.0 ? t + near : 1.0;
    if (mus_pattern_edge_at(pattern, side->edge, 3, at, xy) != MUS_OK) return;
    for (int32_t i = 0; i < 3; i++) mus__piece_point(piece, xy + 2 * i, p + 2 * i);

    /* the outside lies on the right of the outline's direction */
    double dx = (p[4] - p[2]) * side->direction, dy = (p[5] - p[3]) * side->direction, d = sqrt(dx * dx + dy * dy);
    if (!(d > 0.0) || (piece->fold && mus__piece_inward(piece, p) < -1e-6)) return;
    const double n[2] = {dy / d, -dx / d};
    double reach = notch_reach(piece, p, n, side->width), depth = side->width - SLIT_CLEAR;
    depth = depth > SLIT_DEPTH ? SLIT_DEPTH : depth < SLIT_LEAST ? SLIT_LEAST : depth;
    mus__draw_move(out, p[0] + reach * n[0], p[1] + reach * n[1]);
    mus__draw_line(out, p[0] + (reach - depth) * n[0], p[1] + (reach - depth) * n[1]);
}


/* the side that the outline goes on with beyond the end of a side (behind its beginning, unless `ahead`), where it goes
 * on straight; MUS_NONE at a corner */
static int32_t notch_beyond(const mus__piece *piece, int32_t side, bool ahead)
{
    const int32_t n = piece->nflat;
    for (int32_t i = 0; i < n; i++) {
        const int32_t next = (i + 1) % n, own = ahead ? i : next, other = ahead ? next : i;
        if (piece->flat_side[own] != side || piece->flat_side[other] == side) continue;
        return mus__piece_straight(piece, i) ? piece->flat_side[other] : MUS_NONE;
    }
    return MUS_NONE;
}


/* draw the slit at arc length s [m] of a side, unless `out` is NULL; one before its beginning or past its end stands on
 * the side beyond, at the same distance from the end. false, and nothing is drawn, at a corner */
static bool notch_slit_at(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, int32_t index,
                          double s)
{
    const mus__side *side = &piece->sides[index];
    const double length = mus_pattern_edge_length(pattern, side->edge), over = s < 0.0 ? -s : s - length;
    if (s >= 0.0 && s <= length) {
        if (out != NULL) notch_slit(out, pattern, piece, side, s, length);
        return true;
    }
    const bool ahead = (s > length) == (side->direction > 0);
    const int32_t beyond = notch_beyond(piece, index, ahead);
    if (beyond == MUS_NONE) return false;
    const mus__side *other = &piece->sides[beyond];
    const double whole = mus_pattern_edge_length(pattern, other->edge);
    if (over > whole) return false;
    if (out != NULL)
        notch_slit(out, pattern, piece, other, ahead == (other->direction > 0) ? over : whole - over, whole);
    return true;
}


void mus__notches_draw(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, int32_t index)
{
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern); i++) {
        int32_t edge, kind, side = 0;
        double s;
        if (mus_pattern_notch(pattern, i, &edge, &s, &kind) != MUS_OK) continue;
        while (side < piece->nside && piece->sides[side].edge != edge) side++;
        if (side == piece->nside) continue;

        /* near an end of its edge the notch keeps the distances of its slits, as it does on the edge sewn to it; of
         * three slits the middle one keeps the place, where the outline goes on straight */
        double length = mus_pattern_edge_length(pattern, edge), half = 0.5 * (kind - 1) * SLIT_APART;
        double middle = s < half ? half : s > length - half ? length - half : s;
        if (length < 2.0 * half) middle = 0.5 * length;
        const bool kept = kind == MUS_NOTCH_TRIPLE && notch_slit_at(NULL, pattern, piece, side, s - half) &&
                          notch_slit_at(NULL, pattern, piece, side, s + half);
        if (kept) middle = s;
        mus__draw_path(out, index, MUS__LAYER_NOTCHES, MUS__PEN_NOTCH);
        mus__draw_edge(out, edge);
        for (int32_t k = 0; k < kind; k++) {
            double at = middle - half + k * SLIT_APART;
            if (!kept) at = at < 0.0 ? 0.0 : at > length ? length : at;
            notch_slit_at(out, pattern, piece, side, at);
        }
    }
}
