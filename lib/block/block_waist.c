/*
 * block_waist.c: truing a waist line over its darts.
 *
 * A waist that is drawn with its darts open has a corner of the dart's angle at each mouth when they are closed. So the
 * darts are closed first, each by the turn about its point that takes the outer leg to the inner one. Then the line is
 * one cubic with the tangents that the draft has at the centre and at the side, and handles of a third of the chord,
 * as a circular arc has them. The mouths are where it crosses the legs; its parts are turned back to where the draft
 * has them. Both legs of a dart stay equally long, and a smooth line stays smooth over the closed dart.
 *
 * Source: Aldrich, Metric Pattern Cutting for Women's Wear, 2008 (darts are closed and the waist line is trued).
 */
#include <math.h>
#include <string.h>

#include "block/block_waist.h"
#include "geom/curve.h"
#include "geom/vec.h"

/* a turn and a move of the plane: p -> (c x - s y + t0, s x + c y + t1) */
typedef struct waist_turn {
    double c, s, t[2];
} waist_turn;

/* a curve and a line through `point` with the direction `leg` */
typedef struct waist_crossing {
    const double *curve;
    double point[2], leg[2];
} waist_crossing;


static void turn_point(const waist_turn *turn, const double *p, double *out)
{
    const double x = p[0], y = p[1];
    out[0] = turn->c * x - turn->s * y + turn->t[0];
    out[1] = turn->s * x + turn->c * y + turn->t[1];
}


static waist_turn turn_back(const waist_turn *turn)
{
    waist_turn back = {turn->c, -turn->s, {0.0, 0.0}};
    double t[2];
    turn_point(&back, turn->t, t);
    back.t[0] = -t[0], back.t[1] = -t[1];
    return back;
}


/* the turn that closes a dart, then `before`, which closes those nearer to the centre */
static waist_turn turn_close(const waist_turn *before, const double *dart)
{
    const double *o = dart + 2, ux = dart[4] - o[0], uy = dart[5] - o[1], vx = dart[0] - o[0], vy = dart[1] - o[1];
    const double square = ux * ux + uy * uy;
    waist_turn own = {(ux * vx + uy * vy) / square, (ux * vy - uy * vx) / square, {0.0, 0.0}};
    double at[2];
    turn_point(&own, o, at);
    for (int i = 0; i < 2; i++) own.t[i] = o[i] - at[i];
    waist_turn both = {before->c * own.c - before->s * own.s, before->s * own.c + before->c * own.s, {0.0, 0.0}};
    turn_point(before, own.t, both.t);
    return both;
}


static double waist_beyond(const void *data, double t)
{
    const waist_crossing *crossing = data;
    double p[2];
    mus__curve_at(MUS__CUBIC, crossing->curve, t, p);
    return crossing->leg[1] * (p[0] - crossing->point[0]) - crossing->leg[0] * (p[1] - crossing->point[1]);
}


double mus__waist_true(mus__waist *waist)
{
    const int32_t n = waist->ndart;
    waist_turn close[MUS__DARTS + 1] = {{1.0, 0.0, {0.0, 0.0}}};
    for (int32_t d = 0; d < n; d++) close[d + 1] = turn_close(&close[d], waist->dart[d]);

    /* the line with the darts closed */
    double end[2], along[2], rest[8];
    turn_point(&close[n], waist->end[1], end);
    const waist_turn *last = &close[n];
    along[0] = last->c * waist->along[1][0] - last->s * waist->along[1][1];
    along[1] = last->s * waist->along[1][0] + last->c * waist->along[1][1];
    const double *start = waist->end[0], reach = mus__dist2(start, end) / 3.0;
    mus__cubic_set(rest, start, start[0] + reach * waist->along[0][0], start[1] + reach * waist->along[0][1],
                   end[0] - reach * along[0], end[1] - reach * along[1], end);
    const double length = mus__cubic_length(rest);
    memcpy(waist->closed, rest, sizeof rest);
    const double map[6] = {last->c, -last->s, last->t[0], last->s, last->c, last->t[1]};
    memcpy(waist->close, map, sizeof map);

    /* cut at the legs, and opened again */
    for (int32_t d = 0; d <= n; d++) {
        double part[8];
        memcpy(part, rest, sizeof part);
        if (d < n) {
            waist_crossing crossing = {.curve = rest};
            double mouth[2], t;
            turn_point(&close[d], waist->dart[d] + 2, crossing.point);
            turn_point(&close[d], waist->dart[d], mouth);
            for (int i = 0; i < 2; i++) crossing.leg[i] = mouth[i] - crossing.point[i];
            if (!mus__solve(waist_beyond, &crossing, 0.0, 1.0, &t)) return NAN;
            double right[8];
            mus__curve_split(MUS__CUBIC, rest, t, part, right);
            memcpy(rest, right, sizeof rest);
        }
        const waist_turn open = turn_back(&close[d]);
        for (int32_t k = 0; k < 4; k++) turn_point(&open, part + 2 * k, waist->part[d] + 2 * k);
    }
    for (int32_t d = 0; d < n; d++) {
        memcpy(waist->dart[d], waist->part[d] + 6, 2 * sizeof(double));
        memcpy(waist->dart[d] + 4, waist->part[d + 1], 2 * sizeof(double));
    }
    return length;
}
