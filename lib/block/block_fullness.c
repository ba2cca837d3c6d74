/*
 * block_fullness.c: the sleeve block with fullness added by slashing and spreading: bell and bishop (a fan that opens
 * from the cap to the hem), puff (parallel slashes), leg of mutton (a fan from the elbow to the cap); and the cap
 * alone.
 *
 * A fan is the limit of many slashes from the hem, hinged on the cap: the strip below the cap point at x is rotated by
 * psi(x) = delta x / width. The cap is integrated again from its tangents, each rotated by psi of its point, so its
 * length stays the same. A strip of length L lengthens the hem by psi' L.
 *
 * Puff and leg of mutton keep the cap from the underarm to the pitch points, which is sewn without gathers. A higher
 * and wider curve from pitch to pitch replaces the rest; it is gathered into the armhole.
 */
#include <math.h>
#include <string.h>

#include "block/block_fullness.h"
#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"

#define FAN_STEPS 48 /* intervals of the integration along half a cap; even, for Simpson's rule */


static void cut_cubic(mus__chain *chain, const double *cubic, double s0, double s1)
{
    double part[8];
    mus__cubic_part(cubic, s0, s1, part);
    mus__chain_cubic(chain, part);
}


static void fullness_move(mus__chain *chain, double dx, double dy)
{
    for (int32_t i = 0; i < chain->nxy; i++) chain->xy[2 * i] += dx, chain->xy[2 * i + 1] += dy;
}


static void cut_turn(mus__chain *chain, const double *centre, double angle)
{
    const double c = mus__cos(angle), s = mus__sin(angle);
    for (int32_t i = 0; i < chain->nxy; i++) {
        const double x = chain->xy[2 * i] - centre[0], y = chain->xy[2 * i + 1] - centre[1];
        chain->xy[2 * i] = centre[0] + c * x - s * y, chain->xy[2 * i + 1] = centre[1] + s * x + c * y;
    }
}


static const double *cut_end(const mus__chain *chain)
{
    return chain->xy + 2 * (chain->nxy - 1);
}


/* Splits the cap of the block at the pitch points and the crown into the four parts of `out`. */
static void cut_cap(const mus__sleeve *block, double front, double back, mus__sleeve_cut *out)
{
    mus__chain *cap = out->cap;
    cut_cubic(&cap[MUS__CAP_BACK_LOW], block->cap_back, block->back_length - back, block->back_length);
    cut_cubic(&cap[MUS__CAP_BACK_HIGH], block->cap_back, 0.0, block->back_length - back);
    cut_cubic(&cap[MUS__CAP_FRONT_HIGH], block->cap_front, front, block->front_length);
    cut_cubic(&cap[MUS__CAP_FRONT_LOW], block->cap_front, 0.0, front);
    for (int32_t i = 0; i < MUS__CAP_PARTS; i++) mus__chain_reverse(&cap[i]);
    memcpy(out->crown, block->cap_back, sizeof out->crown);
    out->width = block->width;
}


void mus__sleeve_plain(const mus__sleeve *block, double front, double back, mus__sleeve_cut *out)
{
    const double low = block->height - block->length, hem = 0.5 * block->hem;
    const double front_hem[2] = {-hem, low}, back_hem[2] = {hem, low};
    cut_cap(block, front, back, out);
    mus__chain_line(&out->hem, front_hem, back_hem);
    mus__chain_line(&out->under_back, back_hem, out->cap[MUS__CAP_BACK_LOW].xy);
    mus__chain_line(&out->under_front, cut_end(&out->cap[MUS__CAP_FRONT_LOW]), front_hem);
}


/* ---- fan ---- */

typedef struct fan_half {
    double width, delta;
    double length;
    double s[FAN_STEPS + 1], xy[FAN_STEPS + 1][2], tangent[FAN_STEPS + 1][2]; /* half of the cap after spreading */
} fan_half;


/* Integrates half of the cap (`cubic`, crown to underarm) with each tangent rotated by delta x / width [rad]. */
static void fan_cap(const double *cubic, double width, double delta, fan_half *out)
{
    out->width = width, out->delta = delta;
    out->length = mus__cubic_length(cubic);
    memcpy(out->xy[0], cubic, sizeof out->xy[0]);
    double d[3][2], speed = 0.0;
    for (int32_t i = 0; i <= FAN_STEPS; i++) {
        /* derivatives by t at the last point, at the middle of the interval and at this point */
        for (int32_t k = i == 0 ? 2 : 0; k < 3; k++) {
            const double t = ((double)i - 0.5 * (double)(2 - k)) / FAN_STEPS;
            double at[2], along[2];
            mus__curve_at(MUS__CUBIC, cubic, t, at);
            mus__curve_tangent(MUS__CUBIC, cubic, t, along);
            const double psi = delta * at[0] / width;
            d[k][0] = mus__cos(psi) * along[0] - mus__sin(psi) * along[1],
            d[k][1] = mus__sin(psi) * along[0] + mus__cos(psi) * along[1];
            speed = mus__hypot(along[0], along[1]);
        }
        out->tangent[i][0] = d[2][0] / speed, out->tangent[i][1] = d[2][1] / speed;
        out->s[i] = mus__curve_length_to(MUS__CUBIC, cubic, (double)i / FAN_STEPS);
        if (i == 0) continue;
        for (int32_t k = 0; k < 2; k++)
            out->xy[i][k] = out->xy[i - 1][k] + (d[0][k] + 4.0 * d[1][k] + d[2][k]) / (6.0 * FAN_STEPS);
    }
}


/* Point and unit tangent at arc length s [m] from the crown, by a Hermite cubic between two integrated points. */
static void fan_at(const fan_half *half, double s, double *xy, double *tangent)
{
    int32_t i = 0;
    while (i + 2 <= FAN_STEPS && half->s[i + 1] < s) i++;
    mus__chain piece;
    const double ds = half->s[i + 1] - half->s[i];
    mus__chain_through(&piece, 2, half->xy[i], half->tangent[i], &ds);
    const double t = fmin(fmax((s - half->s[i]) / ds, 0.0), 1.0);
    mus__curve_at(MUS__CUBIC, piece.xy, t, xy);
    mus__curve_tangent(MUS__CUBIC, piece.xy, t, tangent);
    const double length = mus__hypot(tangent[0], tangent[1]);
    tangent[0] /= length, tangent[1] /= length;
}


/* Writes the part of half a cap between arc lengths s0 < s1 [m] from the crown as `n` cubics. */
static void fan_chain(const fan_half *half, double s0, double s1, int32_t n, mus__chain *out)
{
    double xy[2 * (MUS__CHAIN_PIECES + 1)], tangent[2 * (MUS__CHAIN_PIECES + 1)], ds[MUS__CHAIN_PIECES];
    for (int32_t i = 0; i <= n; i++) {
        fan_at(half, s0 + (s1 - s0) * i / n, xy + 2 * i, tangent + 2 * i);
        if (i < n) ds[i] = (s1 - s0) / n;
    }
    mus__chain_through(out, n + 1, xy, tangent, ds);
}


/* Returns the mean length of the strips [m]: the area between cap and hem over the width. */
static double fan_mean(const mus__sleeve *block)
{
    double area = 0.0;
    for (int32_t k = 0; k < 2; k++) {
        const double *cubic = k == 0 ? block->cap_front : block->cap_back;
        for (int32_t i = 0; i < FAN_STEPS; i++) {
            double at[2], along[2];
            mus__curve_at(MUS__CUBIC, cubic, (i + 0.5) / FAN_STEPS, at);
            mus__curve_tangent(MUS__CUBIC, cubic, (i + 0.5) / FAN_STEPS, along);
            area += at[1] * along[0] / FAN_STEPS;
        }
    }
    return area / block->width + block->length - block->height;
}


/* Writes the hem point below the cap point at parameter t of `cubic`, after spreading. The hem of the back is lowered
 * by drop sin^2(2 pi x / width) [m]. */
static void fan_hem(const mus__sleeve *block, const fan_half *half, const double *cubic, double t, double drop,
                    double *out)
{
    double at[2], cap[2], tangent[2];
    mus__curve_at(MUS__CUBIC, cubic, t, at);
    fan_at(half, mus__curve_length_to(MUS__CUBIC, cubic, t), cap, tangent);
    const double psi = half->delta * at[0] / half->width;
    const double wave = at[0] > 0.0 ? mus__sin(2.0 * MUS_PI * at[0] / half->width) : 0.0;
    const double v[2] = {at[0] * (block->hem / block->width - 1.0),
                         block->height - block->length - at[1] - drop * wave * wave};
    out[0] = cap[0] + mus__cos(psi) * v[0] - mus__sin(psi) * v[1];
    out[1] = cap[1] + mus__sin(psi) * v[0] + mus__cos(psi) * v[1];
}


void mus__sleeve_fan(const mus__sleeve *block, double front, double back, double hem, double drop,
                     mus__sleeve_cut *out)
{
    /* length of the hem = that of the block + delta times the mean strip length */
    const double delta = (hem - block->hem) / fan_mean(block);
    double outward[2][8];
    fan_half half[2]; /* front, back */
    for (int32_t i = 0; i < 4; i++)
        for (int32_t k = 0; k < 2; k++) outward[0][2 * i + k] = block->cap_front[2 * (3 - i) + k];
    memcpy(outward[1], block->cap_back, sizeof outward[1]);
    for (int32_t k = 0; k < 2; k++) fan_cap(outward[k], block->width, delta, &half[k]);

    fan_chain(&half[1], half[1].length - back, half[1].length, 4, &out->cap[MUS__CAP_BACK_LOW]);
    fan_chain(&half[1], 0.0, half[1].length - back, 4, &out->cap[MUS__CAP_BACK_HIGH]);
    fan_chain(&half[0], 0.0, half[0].length - front, 4, &out->cap[MUS__CAP_FRONT_HIGH]);
    fan_chain(&half[0], half[0].length - front, half[0].length, 4, &out->cap[MUS__CAP_FRONT_LOW]);
    mus__chain_reverse(&out->cap[MUS__CAP_BACK_LOW]);
    mus__chain_reverse(&out->cap[MUS__CAP_BACK_HIGH]);
    memcpy(out->crown, block->cap_back, sizeof out->crown);
    out->width = block->width;

    /* hem: points at equal steps from the front underarm over the crown to the back one, tangents by differences */
    double xy[10], tangent[10], ds[4];
    for (int32_t i = 0; i <= 4; i++) {
        const int32_t k = i < 2 ? 0 : 1;
        const double t = k == 0 ? 1.0 - 0.5 * i : 0.5 * (i - 2), h = 1e-3, turn = k == 0 ? -1.0 : 1.0;
        const double t0 = fmax(0.0, t - h), t1 = fmin(1.0, t + h);
        double a[2], b[2];
        fan_hem(block, &half[k], outward[k], t, drop, xy + 2 * i);
        fan_hem(block, &half[k], outward[k], t0, drop, a);
        fan_hem(block, &half[k], outward[k], t1, drop, b);
        const double length = mus__dist2(a, b);
        tangent[2 * i] = turn * (b[0] - a[0]) / length, tangent[2 * i + 1] = turn * (b[1] - a[1]) / length;
    }
    for (int32_t i = 0; i < 4; i++) {
        /* length of an arc over its chord: turn / (2 sin(turn / 2)) */
        const double c = tangent[2 * i] * tangent[2 * i + 2] + tangent[2 * i + 1] * tangent[2 * i + 3];
        const double turn = mus__acos(fmax(-1.0, fmin(1.0, c)));
        ds[i] = mus__dist2(xy + 2 * i, xy + 2 * i + 2) * (turn > 1e-4 ? 0.5 * turn / mus__sin(0.5 * turn) : 1.0);
    }
    mus__chain_through(&out->hem, 5, xy, tangent, ds);
    mus__chain_line(&out->under_back, cut_end(&out->hem), out->cap[MUS__CAP_BACK_LOW].xy);
    mus__chain_line(&out->under_front, cut_end(&out->cap[MUS__CAP_FRONT_LOW]), out->hem.xy);
}


/* ---- puff and leg of mutton ---- */

/* Draws the two upper parts of the cap again, from pitch to pitch over the crown `top` (2); at the pitch points they
 * continue the tangents of the lower parts. */
static void cut_crown(mus__sleeve_cut *out, const double *top)
{
    const mus__chain *back = &out->cap[MUS__CAP_BACK_LOW], *front = &out->cap[MUS__CAP_FRONT_LOW];
    const double *b = cut_end(back), *f = front->xy, *before = b - 2, *after = f + 2;
    const double hold[2] = {0.42 * mus__dist2(b, top) / mus__dist2(before, b),
                            0.42 * mus__dist2(f, top) / mus__dist2(f, after)};
    double cubic[8];
    mus__cubic_set(cubic, b, b[0] + hold[0] * (b[0] - before[0]), b[1] + hold[0] * (b[1] - before[1]),
                   top[0] + 0.5 * (b[0] - top[0]), top[1], top);
    mus__chain_cubic(&out->cap[MUS__CAP_BACK_HIGH], cubic);
    mus__cubic_set(cubic, top, top[0] + 0.5 * (f[0] - top[0]), top[1], f[0] + hold[1] * (f[0] - after[0]),
                   f[1] + hold[1] * (f[1] - after[1]), f);
    mus__chain_cubic(&out->cap[MUS__CAP_FRONT_HIGH], cubic);
    memcpy(out->crown, top, sizeof out->crown);
}


void mus__sleeve_puff(const mus__sleeve *block, double front, double back, double spread, double raise, double drop,
                      mus__sleeve_cut *out)
{
    mus__sleeve_plain(block, front, back, out);
    const double top[2] = {block->crown, block->height + raise}, low = block->height - block->length;
    fullness_move(&out->cap[MUS__CAP_BACK_LOW], 0.5 * spread, 0.0);
    fullness_move(&out->under_back, 0.5 * spread, 0.0);
    fullness_move(&out->cap[MUS__CAP_FRONT_LOW], -0.5 * spread, 0.0);
    fullness_move(&out->under_front, -0.5 * spread, 0.0);
    cut_crown(out, top);
    out->width = block->width + spread;

    /* the middle of the hem is `drop` lower: a cubic with handles 4/3 drop below its ends */
    const double *f = cut_end(&out->under_front), *b = out->under_back.xy, hang = low - 4.0 / 3.0 * drop;
    double hem[8];
    mus__cubic_set(hem, f, f[0] + 0.3 * (b[0] - f[0]), hang, b[0] - 0.3 * (b[0] - f[0]), hang, b);
    mus__chain_cubic(&out->hem, hem);
}


void mus__sleeve_gigot(const mus__sleeve *block, double front, double back, double elbow, double spread, double raise,
                       mus__sleeve_cut *out)
{
    mus__sleeve_plain(block, front, back, out);

    /* the underarm seam is fixed at the elbow; above it the seam is tilted outwards, half the spread at the underarm */
    const double low = block->height - block->length, part = elbow / low;
    const double x = 0.5 * (block->width + part * (block->hem - block->width));
    const double side[2][2] = {{-x, elbow}, {x, elbow}}, angle = 0.5 * spread / -elbow;
    const double top[2] = {block->crown, block->height + raise};
    cut_turn(&out->cap[MUS__CAP_BACK_LOW], side[1], -angle);
    cut_turn(&out->cap[MUS__CAP_FRONT_LOW], side[0], angle);
    cut_crown(out, top);
    out->width = block->width + spread;

    mus__chain_line(&out->under_back, cut_end(&out->hem), side[1]);
    mus__chain_add_line(&out->under_back, side[1], out->cap[MUS__CAP_BACK_LOW].xy);
    mus__chain_line(&out->under_front, cut_end(&out->cap[MUS__CAP_FRONT_LOW]), side[0]);
    mus__chain_add_line(&out->under_front, side[0], out->hem.xy);
}


/* ---- the cap alone ---- */

typedef struct cap_problem {
    const double *cubic;
    double level;
} cap_problem;


static double cap_excess(const void *data, double t)
{
    const cap_problem *problem = data;
    double at[2];
    mus__curve_at(MUS__CUBIC, problem->cubic, t, at);
    return at[1] - problem->level;
}


void mus__sleeve_short_cap(const mus__sleeve *block, double level, double *front, double *back, mus__sleeve_cut *out)
{
    const double y = level * block->height;
    const cap_problem problem[2] = {{block->cap_front, y}, {block->cap_back, y}};
    double t[2] = {0.3, 0.7};
    memset(out, 0, sizeof *out);
    mus__solve(cap_excess, &problem[0], 0.0, 1.0, &t[0]);
    mus__solve(cap_excess, &problem[1], 0.0, 1.0, &t[1]);
    *front = mus__curve_length_to(MUS__CUBIC, block->cap_front, t[0]);
    const double kept = mus__curve_length_to(MUS__CUBIC, block->cap_back, t[1]);
    *back = block->back_length - kept;
    cut_cubic(&out->cap[MUS__CAP_BACK_HIGH], block->cap_back, 0.0, kept);
    cut_cubic(&out->cap[MUS__CAP_FRONT_HIGH], block->cap_front, *front, block->front_length);
    mus__chain_reverse(&out->cap[MUS__CAP_BACK_HIGH]);
    mus__chain_reverse(&out->cap[MUS__CAP_FRONT_HIGH]);
    memcpy(out->crown, block->cap_back, sizeof out->crown);
    out->width = block->width;

    /* the middle of the hem is raised by a tenth of the cap's height */
    const double *f = cut_end(&out->cap[MUS__CAP_FRONT_HIGH]), *b = out->cap[MUS__CAP_BACK_HIGH].xy;
    const double rise = y + 0.13 * block->height;
    double hem[8];
    mus__cubic_set(hem, f, f[0] + 0.33 * (b[0] - f[0]), rise, b[0] - 0.33 * (b[0] - f[0]), rise, b);
    mus__chain_cubic(&out->hem, hem);
}
