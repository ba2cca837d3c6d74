/*
 * lower_place.c: where panels of the lower body start: bent to half a ring round the waist, before and behind one leg,
 * or leaned out like a part of a cone. Round the hips: panel_place.c.
 *
 * A front faces +Z and its x runs to the wearer's left; a back faces -Z and its x runs to the right, so that the left
 * back, drawn at x < 0, is on the left. Everything starts outside the body; a leg's pieces so far to the side that the
 * fork does not reach over to the other leg.
 */
#include <math.h>

#include "design/lower.h"
#include "geom/vec.h"


/* face azimuth `around` from the front to the left, leaned back from the vertical by `tilt` at its top */
void mus__lower_place(mus__half *half, int32_t panel, double around, double tilt, const double *origin, double bend)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK || !mus__board_has_panel(board, panel)) return;
    const double out[3] = {sin(around), 0.0, cos(around)}, along[3] = {cos(around), 0.0, -sin(around)};
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    for (int i = 0; i < 3; i++) {
        const double up = i == 1 ? 1.0 : 0.0;
        place.rotation[3 * i] = along[i];
        place.rotation[3 * i + 1] = up * cos(tilt) - out[i] * sin(tilt);
        place.rotation[3 * i + 2] = out[i] * cos(tilt) + up * sin(tilt);
        place.origin[i] = origin[i];
    }
    place.bend = bend;
    board->panel[panel].placement = place;
}


void mus__lower_place_waist(mus__half *half, int32_t panel, bool front, double girth, double height)
{
    const double radius = girth / (2.0 * MUS_PI) + 0.03;
    const double origin[3] = {0.0, height, 0.01 * half->skeleton.crown + (front ? radius : -radius)};
    mus__lower_place(half, panel, front ? 0.0 : MUS_PI, 0.0, origin, radius);
}


void mus__lower_place_leg(mus__half *half, int32_t panel, bool front, double crease, double inner, double girth,
                          double away)
{
    /* depth of a torso is below 0.14 of its girth; the roll has 3 cm of room */
    const double *m = half->measures.v, radius = girth / (2.0 * MUS_PI) + 0.03;
    const double off = fmax(away, 0.14 * fmax(m[MUS_MEASURE_WAIST], m[MUS_MEASURE_HIP]) + 0.03);
    const double reach = radius * sin(fmin(inner / radius, 0.5 * MUS_PI)) + 0.004;
    const double x = fmax(half->skeleton.leg_x, reach);

    /* the crease lies over x, so the panel's x = 0 does not: the roll keeps the line of the crease in place */
    const double turn = front ? 1.0 : -1.0;
    const double origin[3] = {x - crease, half->waist_level, -0.005 * half->skeleton.crown + turn * off};
    mus__lower_place(half, panel, front ? 0.0 : MUS_PI, 0.0, origin, radius);
    if (half->board.status == MUS_OK) half->board.panel[panel].placement.bend_x = turn * crease;
}
