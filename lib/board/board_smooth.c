/*
 * board_smooth.c: a side with corners drawn again as one smooth line.
 *
 * Slashes and released darts leave a side of parts that meet at angles. A cutter lays a curved ruler along them: one
 * cubic with the side's own tangents at both ends,
 *
 *     q(t) = B0(t) P + B1(t) (P + a u) + B2(t) (Q - b v) + B3(t) Q,
 *
 * where a and b make the sum of squared distances from places along the side the least. The places' parameters are by
 * arc length first, then moved to the foot of each place by Newton's method, and a and b found again. When a place is
 * left further off than allowed the line is divided in its middle, with the direction that the side has there over an
 * eighth of it, and both halves are tried.
 * Source: Schneider, An algorithm for automatically fitting digitized curves, Graphics Gems, 1990.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "board/board_rigid_part.h"
#include "board/board_smooth.h"
#include "board/board_spread.h"
#include "geom/curve.h"
#include "geom/vec.h"

#define FAIR_PLACES 129 /* places along a side: every 4 mm of an armhole */
#define FAIR_STEPS 12   /* iterations of parameters and handles; chosen: more change no digit that is printed */
/* halvings of a side: at most 32 cubics; chosen: bounds an array; more would follow the corners that are to go */
#define FAIR_DEPTH 5
/* sine of the least angle between two pieces that is a corner: half a degree, below what an eye sees */
#define FAIR_CORNER 0.0087

typedef struct fair_line {
    double place[FAIR_PLACES][2], t[FAIR_PLACES];
    double within;
    int32_t npiece, nxy;
    int32_t kinds[1 << FAIR_DEPTH];
    double xy[2 * (3 * (1 << FAIR_DEPTH) + 1)];
} fair_line;


/* has the side a corner between two of its pieces? */
static bool fair_cornered(const mus__board_chain *chain)
{
    const double *p = chain->xy;
    for (int32_t i = 0; i + 1 < chain->npiece; i++) {
        const double *q = p + 2 * (mus__curve_points(chain->kinds[i]) - 1);
        double u[2], v[2];
        mus__curve_tangent(chain->kinds[i], p, 1.0, u);
        mus__curve_tangent(chain->kinds[i + 1], q, 0.0, v);
        const double cross = u[0] * v[1] - u[1] * v[0], dot = u[0] * v[0] + u[1] * v[1];
        if (!(dot > 0.0) || fabs(cross) > FAIR_CORNER * dot) return true;
        p = q;
    }
    return false;
}


/* handles a, b of the cubic between two places with tangents u, v: the 2 x 2 system of least squares, or a third of the
 * chord where the system is singular or gives a negative handle */
static void fair_handles(const fair_line *line, int32_t a, int32_t b, const double *u, const double *v, double *cubic)
{
    const double *p = line->place[a], *q = line->place[b];
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0;
    for (int32_t i = a; i <= b; i++) {
        const double t = line->t[i], s = 1.0 - t, b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t;
        const double b0 = s * s * s + b1, b3 = t * t * t + b2;
        const double f[2] = {b1 * u[0], b1 * u[1]}, g[2] = {-b2 * v[0], -b2 * v[1]};
        const double r[2] = {line->place[i][0] - b0 * p[0] - b3 * q[0], line->place[i][1] - b0 * p[1] - b3 * q[1]};
        c00 += f[0] * f[0] + f[1] * f[1], c01 += f[0] * g[0] + f[1] * g[1], c11 += g[0] * g[0] + g[1] * g[1];
        x0 += f[0] * r[0] + f[1] * r[1], x1 += g[0] * r[0] + g[1] * r[1];
    }
    const double chord = mus__dist2(p, q), det = c00 * c11 - c01 * c01;
    double first = det > 0.0 ? (x0 * c11 - x1 * c01) / det : 0.0, last = det > 0.0 ? (c00 * x1 - c01 * x0) / det : 0.0;
    if (!(first > 0.05 * chord && first < 2.0 * chord)) first = chord / 3.0;
    if (!(last > 0.05 * chord && last < 2.0 * chord)) last = chord / 3.0;
    for (int k = 0; k < 2; k++) {
        cubic[k] = p[k], cubic[2 + k] = p[k] + first * u[k];
        cubic[4 + k] = q[k] - last * v[k], cubic[6 + k] = q[k];
    }
}


/* move the parameter of each place towards its foot on the cubic by one Newton step. Returns the greatest distance
 * [m] */
static double fair_feet(fair_line *line, int32_t a, int32_t b, const double *cubic)
{
    double worst = 0.0;
    for (int32_t i = a; i <= b; i++) {
        double q[2], d[2], near[2], h = 1e-4, t = line->t[i];
        mus__curve_at(MUS__CUBIC, cubic, t, q);
        mus__curve_tangent(MUS__CUBIC, cubic, t, d);
        mus__curve_tangent(MUS__CUBIC, cubic, t + h, near);
        const double e[2] = {q[0] - line->place[i][0], q[1] - line->place[i][1]};
        const double dd[2] = {(near[0] - d[0]) / h, (near[1] - d[1]) / h};
        const double slope = d[0] * d[0] + d[1] * d[1] + e[0] * dd[0] + e[1] * dd[1];
        worst = fmax(worst, mus__hypot(e[0], e[1]));
        if (i > a && i < b && slope > 0.0) line->t[i] = fmin(fmax(t - (e[0] * d[0] + e[1] * d[1]) / slope, 0.0), 1.0);
    }
    return worst;
}


static void fair_fit(fair_line *line, int32_t a, int32_t b, const double *u, const double *v, int32_t depth)
{
    double best[8], cubic[8], least = HUGE_VAL;
    for (int32_t i = a; i <= b; i++) line->t[i] = (double)(i - a) / (b - a);
    for (int32_t i = 0; i < FAIR_STEPS; i++) {
        fair_handles(line, a, b, u, v, cubic);
        const double off = fair_feet(line, a, b, cubic);
        if (off < least) memcpy(best, cubic, sizeof best);
        least = fmin(least, off);
    }
    const int32_t middle = (a + b) / 2, reach = (b - a) / 16 > 1 ? (b - a) / 16 : 1;
    if (least <= line->within || depth == 0 || b - a < 4) {
        line->kinds[line->npiece++] = MUS__CUBIC;
        memcpy(line->xy + 2 * (size_t)(line->nxy - 1), best, sizeof best);
        line->nxy += 3;
        return;
    }
    const double *p = line->place[middle - reach], *q = line->place[middle + reach], length = mus__dist2(p, q);
    const double w[2] = {(q[0] - p[0]) / length, (q[1] - p[1]) / length};
    fair_fit(line, a, middle, u, w, depth - 1);
    fair_fit(line, middle, b, w, v, depth - 1);
}


void mus__board_fair(mus__board *board, int32_t side, double within)
{
    if (!mus__board_has_side(board, side)) return;
    const mus__board_side *own = &board->side[side];
    const double before = own->length;
    if (!(within >= 1e-6 && within <= 1.0)) {
        mus__board_fail(board, MUS_ERR_ARG, "fair side %s: within %g m is outside 1e-06 to 1 m", own->name, within);
        return;
    }
    if (!fair_cornered(&own->chain)) return;
    fair_line *line = mus__new(board->context, 1, sizeof *line);
    if (line == NULL) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a side");
        return;
    }
    double u[2], v[2];
    line->within = within, line->nxy = 1;
    for (int32_t i = 0; i < FAIR_PLACES; i++)
        mus__board_at(board, side, before * i / (FAIR_PLACES - 1), line->place[i], i == 0 ? u : v);
    fair_fit(line, 0, FAIR_PLACES - 1, u, v, FAIR_DEPTH);
    mus__board_redraw(board, side, line->npiece, line->kinds, line->nxy, line->xy);
    mus__free(board->context, line);
    if (board->status == MUS_OK) mus__board_part_ease(board, side, board->side[side].length - before);
}
