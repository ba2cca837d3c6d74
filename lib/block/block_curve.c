/*
 * block_curve.c: curves that the blocks are drawn with: cubics by their points, parts of a cubic by arc length, chains
 * of curves and their mirror images; and a bracketed root finder.
 *
 * The root finder is the secant method kept inside its bracket, the value of the end that stays is halved (Illinois
 * rule). A draft solves about ten roots, each in about ten evaluations. Source: Dowell and Jarratt, A modified regula
 * falsi method, BIT 11, 1971.
 */
#include <math.h>
#include <string.h>

#include "block/block_curve.h"
#include "base/elementary.h"
#include "geom/curve.h"


void mus__cubic_set(double *out, const double *start, double ax, double ay, double bx, double by, const double *end)
{
    out[0] = start[0], out[1] = start[1];
    out[2] = ax, out[3] = ay;
    out[4] = bx, out[5] = by;
    out[6] = end[0], out[7] = end[1];
}


double mus__cubic_length(const double *cubic)
{
    return mus__curve_length(MUS__CUBIC, cubic);
}


void mus__cubic_part(const double *cubic, double s0, double s1, double *out)
{
    double length = mus__cubic_length(cubic);
    double t0 = s0 <= 0.0 ? 0.0 : mus__curve_param(MUS__CUBIC, cubic, s0);
    double t1 = s1 >= length ? 1.0 : mus__curve_param(MUS__CUBIC, cubic, s1);

    /* keep the part up to t1, then the part from t0 on */
    double head[8], rest[8];
    mus__curve_split(MUS__CUBIC, cubic, t1, head, rest);
    mus__curve_split(MUS__CUBIC, head, t0 / t1, rest, out);
}


bool mus__solve(double (*f)(const void *data, double x), const void *data, double lo, double hi, double *root)
{
    double flo = f(data, lo), fhi = f(data, hi);
    if (!(flo * fhi <= 0.0)) return false;

    /* lengths are metres: 1e-12 of one is far below what a pattern keeps */
    double x = hi, fx = fhi;
    for (int i = 0; i < 100 && fabs(fx) > 1e-12 && fabs(hi - lo) > 1e-14; i++) {
        x = hi - fhi * (hi - lo) / (fhi - flo);
        fx = f(data, x);
        if ((fx > 0.0) != (fhi > 0.0)) {
            lo = hi, flo = fhi;
        } else {
            flo *= 0.5;
        }
        hi = x, fhi = fx;
    }
    *root = x;
    return true;
}


void mus__chain_line(mus__chain *chain, const double *start, const double *end)
{
    chain->npiece = 1;
    chain->kinds[0] = MUS__LINE;
    chain->nxy = 2;
    memcpy(chain->xy, start, 2 * sizeof *start);
    memcpy(chain->xy + 2, end, 2 * sizeof *end);
}


void mus__chain_cubic(mus__chain *chain, const double *cubic)
{
    chain->npiece = 1;
    chain->kinds[0] = MUS__CUBIC;
    chain->nxy = 4;
    memcpy(chain->xy, cubic, 8 * sizeof *cubic);
}


void mus__chain_arc(mus__chain *chain, const double *start, const double *middle, const double *end)
{
    chain->npiece = 1;
    chain->kinds[0] = MUS__ARC;
    chain->nxy = 3;
    memcpy(chain->xy, start, 2 * sizeof *start);
    memcpy(chain->xy + 2, middle, 2 * sizeof *middle);
    memcpy(chain->xy + 4, end, 2 * sizeof *end);
}


void mus__chain_append(mus__chain *chain, const mus__chain *next)
{
    if (chain->npiece == 0) {
        *chain = *next;
        return;
    }
    MUS_ASSERT(chain->npiece + next->npiece <= MUS__CHAIN_PIECES);
    memcpy(chain->kinds + chain->npiece, next->kinds, (size_t)next->npiece * sizeof *next->kinds);
    memcpy(chain->xy + 2 * chain->nxy, next->xy + 2, 2 * (size_t)(next->nxy - 1) * sizeof *next->xy);
    chain->npiece += next->npiece;
    chain->nxy += next->nxy - 1;
}


void mus__chain_add_line(mus__chain *chain, const double *start, const double *end)
{
    mus__chain line;
    mus__chain_line(&line, start, end);
    mus__chain_append(chain, &line);
}


void mus__chain_add_cubic(mus__chain *chain, const double *start, double ax, double ay, double bx, double by,
                          const double *end)
{
    double cubic[8];
    mus__chain piece;
    mus__cubic_set(cubic, start, ax, ay, bx, by, end);
    mus__chain_cubic(&piece, cubic);
    mus__chain_append(chain, &piece);
}


void mus__chain_reverse(mus__chain *chain)
{
    mus__chain from = *chain;
    for (int32_t i = 0; i < from.npiece; i++) chain->kinds[i] = from.kinds[from.npiece - 1 - i];
    for (int32_t i = 0; i < from.nxy; i++)
        memcpy(chain->xy + 2 * i, from.xy + 2 * (from.nxy - 1 - i), 2 * sizeof *from.xy);
}


void mus__chain_mirror(mus__chain *chain)
{
    mus__chain_reverse(chain);
    for (int32_t i = 0; i < chain->nxy; i++) chain->xy[2 * i] = 0.0 - chain->xy[2 * i];
}


void mus__chain_unfold(mus__chain *chain)
{
    mus__chain other = *chain;
    mus__chain_mirror(&other);
    mus__chain_append(chain, &other);
}


double mus__chain_length(const mus__chain *chain)
{
    double length = 0.0;
    const double *p = chain->xy;
    for (int32_t i = 0; i < chain->npiece; i++) {
        length += mus__curve_length(chain->kinds[i], p);
        p += 2 * (mus__curve_points(chain->kinds[i]) - 1);
    }
    return length;
}


void mus__chain_through(mus__chain *chain, int32_t n, const double *xy, const double *tangent, const double *ds)
{
    MUS_ASSERT(n >= 2 && n - 1 <= MUS__CHAIN_PIECES);
    chain->npiece = n - 1;
    chain->nxy = 3 * (n - 1) + 1;
    memcpy(chain->xy, xy, 2 * sizeof *xy);
    for (int32_t i = 0; i + 1 < n; i++) {
        /* handles of a circular arc that turns by `turn`: 4/3 tan(turn/4) / turn of its length */
        const double *t0 = tangent + 2 * i, *t1 = t0 + 2, *p0 = xy + 2 * i, *p1 = p0 + 2;
        const double turn = mus__acos(fmax(-1.0, fmin(1.0, t0[0] * t1[0] + t0[1] * t1[1])));
        const double reach = ds[i] * (turn > 1e-3 ? 4.0 / 3.0 * mus__tan(0.25 * turn) / turn : 1.0 / 3.0);
        double *out = chain->xy + 6 * i + 2;
        chain->kinds[i] = MUS__CUBIC;
        for (int32_t k = 0; k < 2; k++) {
            out[k] = p0[k] + reach * t0[k];
            out[2 + k] = p1[k] - reach * t1[k];
            out[4 + k] = p1[k];
        }
    }
}


void mus__chain_cut(const mus__chain *chain, double s, mus__chain *out)
{
    mus__chain result = {0};
    const double *p = chain->xy;
    for (int32_t i = 0; i < chain->npiece; i++) {
        const int32_t kind = chain->kinds[i], points = mus__curve_points(kind);
        const double length = mus__curve_length(kind, p);
        double left[8], right[8];
        memcpy(left, p, 2 * (size_t)points * sizeof *p);
        if (s < length) mus__curve_split(kind, p, mus__curve_param(kind, p, s), left, right);
        mus__chain piece = {.npiece = 1, .kinds = {kind}, .nxy = points};
        memcpy(piece.xy, left, 2 * (size_t)points * sizeof *left);
        mus__chain_append(&result, &piece);
        if (s <= length) break;
        s -= length;
        p += 2 * (points - 1);
    }
    *out = result;
}


void mus__chain_move(mus__chain *chain, const double *map)
{
    for (int32_t i = 0; i < chain->nxy; i++) {
        double *p = chain->xy + 2 * i;
        const double x = p[0], y = p[1];
        p[0] = map[0] * x + map[1] * y + map[2];
        p[1] = map[3] * x + map[4] * y + map[5];
    }
}


void mus__chain_shift(mus__chain *chain, double dx)
{
    for (int32_t i = 0; i < chain->nxy; i++) chain->xy[2 * i] += dx;
}
