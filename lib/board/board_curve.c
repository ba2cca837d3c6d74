/*
 * board_curve.c: chains of pieces (lines, arcs, Beziers) on the cutting table: measured, reversed, moved, split,
 * joined.
 *
 * One block holds the points (nxy x 2) and behind them the kinds (npiece). Points are kept to the bit as they were
 * given, and a piece is divided exactly (de Casteljau; an arc by equal angle), so length and area stay.
 */
#include <math.h>
#include <string.h>

#include "board/board_curve.h"
#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"

/* [m] a place within this of a joint of pieces is the joint: lengths are right to 1e-12 */
#define CHAIN_JOINT 1e-10
/* largest distance of the joint of two lines from their common chord, over its length, when they are one straight line:
 * rounding */
#define CHAIN_STRAIGHT 1e-13


/* allocate a chain without contents; false when the board fails */
static bool chain_room(mus__board *board, int32_t npiece, int32_t nxy, mus__board_chain *out)
{
    *out = (mus__board_chain){0};
    if (board->status != MUS_OK) return false;
    double *block = mus__room(board->context, 2 * (int64_t)nxy + (npiece + 1) / 2, sizeof *block);
    if (block == NULL) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a side");
        return false;
    }
    out->npiece = npiece;
    out->nxy = nxy;
    out->xy = block;
    out->kinds = (int32_t *)(void *)(block + 2 * (size_t)nxy);
    return true;
}


void mus__board_chain_make(mus__board *board, int32_t npiece, const int32_t *kinds, int32_t nxy, const double *xy,
                           mus__board_chain *out)
{
    *out = (mus__board_chain){0};
    if (board->status != MUS_OK) return;
    int64_t need = 1;
    for (int32_t i = 0; i < npiece; i++) {
        const int32_t points = mus__curve_points(kinds[i]);
        if (points == 0) {
            mus__board_fail(board, MUS_ERR_ARG, "side: piece %d is of kind %d, kinds are 0 to 3", (int)i,
                            (int)kinds[i]);
            return;
        }
        need += points - 1;
    }
    if (npiece < 1 || need != nxy) {
        mus__board_fail(board, MUS_ERR_ARG, "side: %d points given, its %d pieces take %lld", (int)nxy, (int)npiece,
                        (long long)need);
        return;
    }
    board->status = mus__check_near(board->context, nxy, 2, xy, "side: point");
    if (board->status != MUS_OK) return;
    if (!chain_room(board, npiece, nxy, out)) return;
    memcpy(out->xy, xy, 2 * (size_t)nxy * sizeof *xy);
    memcpy(out->kinds, kinds, (size_t)npiece * sizeof *kinds);
}


double mus__board_chain_length(const mus__board_chain *chain)
{
    const double *p = chain->xy;
    double length = 0.0;
    for (int32_t i = 0; i < chain->npiece; i++) {
        length += mus__curve_length(chain->kinds[i], p);
        p += 2 * (mus__curve_points(chain->kinds[i]) - 1);
    }
    return length;
}


/* index of the piece that holds arc length s; *p gets its points, *at the arc length from its start. A piece that ends
 * within CHAIN_JOINT of s does not hold it, except the last */
static int32_t chain_piece(const mus__board_chain *chain, double s, const double **p, double *at)
{
    *p = chain->xy;
    for (int32_t i = 0;; i++) {
        /* the last piece takes the remaining arc length */
        *at = s;
        if (i + 1 == chain->npiece) return i;
        const double own = mus__curve_length(chain->kinds[i], *p);
        if (s < own - CHAIN_JOINT) return i;
        s -= own;
        *p += 2 * (mus__curve_points(chain->kinds[i]) - 1);
    }
}


/* unit tangent at t; where the derivative is 0 (a control point on its end), the direction of a short chord there */
static void chain_tangent(int32_t kind, const double *p, double t, double *out)
{
    mus__curve_tangent(kind, p, t, out);
    double norm = mus__hypot(out[0], out[1]);
    if (!(norm > 1e-12)) {
        double a[2], b[2];
        mus__curve_at(kind, p, fmax(0.0, t - 1e-4), a);
        mus__curve_at(kind, p, fmin(1.0, t + 1e-4), b);
        out[0] = b[0] - a[0], out[1] = b[1] - a[1];
        norm = mus__hypot(out[0], out[1]);
    }
    if (norm > 0.0) out[0] /= norm, out[1] /= norm;
}


void mus__board_chain_at(const mus__board_chain *chain, double length, double s, double *xy, double *tangent)
{
    const double *p;
    double at;
    const bool end = s >= length;
    const int32_t piece = chain_piece(chain, s, &p, &at), kind = chain->kinds[piece];
    const double t = end ? 1.0 : mus__curve_param(kind, p, at);
    if (xy != NULL && end)
        memcpy(xy, chain->xy + 2 * ((size_t)chain->nxy - 1), 2 * sizeof *xy);
    else if (xy != NULL && t == 0.0)
        memcpy(xy, p, 2 * sizeof *xy);
    else if (xy != NULL)
        mus__curve_at(kind, p, t, xy);
    if (tangent != NULL) chain_tangent(kind, p, t, tangent);
}


void mus__board_chain_reverse(mus__board_chain *chain)
{
    double *xy = chain->xy;
    for (int32_t i = 0, j = chain->nxy - 1; i < j; i++, j--) {
        const double x = xy[2 * i], y = xy[2 * i + 1];
        xy[2 * i] = xy[2 * j], xy[2 * i + 1] = xy[2 * j + 1];
        xy[2 * j] = x, xy[2 * j + 1] = y;
    }
    for (int32_t i = 0, j = chain->npiece - 1; i < j; i++, j--) {
        const int32_t kind = chain->kinds[i];
        chain->kinds[i] = chain->kinds[j];
        chain->kinds[j] = kind;
    }
}


void mus__board_chain_move(mus__board_chain *chain, const double *map)
{
    for (int32_t i = 0; i < chain->nxy; i++) {
        double *p = chain->xy + 2 * (size_t)i;
        const double x = p[0], y = p[1];
        p[0] = map[0] * x + map[1] * y + map[2];
        p[1] = map[3] * x + map[4] * y + map[5];
    }
}


void mus__board_chain_split(mus__board *board, const mus__board_chain *chain, double length, double s,
                            mus__board_chain *before, mus__board_chain *after)
{
    *after = (mus__board_chain){0};
    const double *p;
    double at, left[8], right[8];
    const int32_t piece = chain_piece(chain, fmin(s, length), &p, &at), kind = chain->kinds[piece];
    const int32_t own = mus__curve_points(kind), offset = (int32_t)((p - chain->xy) / 2);

    /* at a joint the piece goes to the second part whole; else it is in both */
    const bool joint = piece > 0 && at <= CHAIN_JOINT;
    const int32_t first = joint ? piece : piece + 1, nfirst = joint ? offset + 1 : offset + own;
    if (!chain_room(board, first, nfirst, before)) return;
    if (!chain_room(board, chain->npiece - piece, chain->nxy - offset, after)) {
        mus__free(board->context, before->xy);
        *before = (mus__board_chain){0};
        return;
    }
    memcpy(before->xy, chain->xy, 2 * (size_t)nfirst * sizeof *p);
    memcpy(before->kinds, chain->kinds, (size_t)first * sizeof *chain->kinds);
    memcpy(after->xy, p, 2 * (size_t)after->nxy * sizeof *p);
    memcpy(after->kinds, chain->kinds + piece, (size_t)after->npiece * sizeof *chain->kinds);
    if (joint) return;
    mus__curve_split(kind, p, mus__curve_param(kind, p, at), left, right);
    memcpy(before->xy + 2 * (size_t)offset, left, 2 * (size_t)own * sizeof *left);
    memcpy(after->xy, right, 2 * (size_t)own * sizeof *right);
}


/* are a -> b -> c one straight line? */
static bool chain_straight(const double *a, const double *b, const double *c)
{
    const double x = c[0] - a[0], y = c[1] - a[1], u = b[0] - a[0], v = b[1] - a[1], square = x * x + y * y;
    const double along = x * u + y * v;
    return along > 0.0 && along < square && fabs(x * v - y * u) <= CHAIN_STRAIGHT * square;
}


void mus__board_chain_join(mus__board *board, const mus__board_chain *a, const mus__board_chain *b,
                           mus__board_chain *out)
{
    const double *end = a->xy + 2 * ((size_t)a->nxy - 1);
    const bool one = a->kinds[a->npiece - 1] == MUS_PIECE_LINE && b->kinds[0] == MUS_PIECE_LINE &&
                     chain_straight(end - 2, end, b->xy + 2);
    const int32_t less = one ? 1 : 0;
    if (!chain_room(board, a->npiece + b->npiece - less, a->nxy + b->nxy - 1 - less, out)) return;

    /* b's first point is a's last; both go when the two lines are one */
    const size_t head = 2 * (size_t)(a->nxy - less), tail = 2 * (size_t)(b->nxy - 1);
    memcpy(out->xy, a->xy, head * sizeof *a->xy);
    memcpy(out->xy + head, b->xy + 2, tail * sizeof *b->xy);
    memcpy(out->kinds, a->kinds, (size_t)a->npiece * sizeof *a->kinds);
    memcpy(out->kinds + a->npiece - less, b->kinds, (size_t)b->npiece * sizeof *b->kinds);
}


bool mus__board_chain_same(const mus__board_chain *a, const mus__board_chain *b, bool reversed)
{
    if (a->nxy != b->nxy || a->npiece != b->npiece) return false;
    for (int32_t i = 0; i < a->npiece; i++)
        if (a->kinds[i] != b->kinds[reversed ? b->npiece - 1 - i : i]) return false;
    for (int32_t i = 0; i < a->nxy; i++) {
        const double *p = a->xy + 2 * (size_t)i, *q = b->xy + 2 * (size_t)(reversed ? b->nxy - 1 - i : i);
        if (p[0] != q[0] || p[1] != q[1]) return false;
    }
    return true;
}
