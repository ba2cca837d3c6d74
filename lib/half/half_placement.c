/*
 * half_placement.c: start positions of the panels of a half garment round the body.
 *
 * Panels start outside the body with their right sides out. Torso panels stand off by the depth of the body, bent so
 * that their sides pass before and behind the arms. Hip panels are bent to half a ring each. Sleeves are rolled about
 * the arm, collars and bands about an upright axis. Only the wearer's left half is placed; doubling mirrors it. The x
 * axis of a back panel points to the wearer's right, so its left half has x <= 0.
 */
#include <math.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "half/half_placement.h"


/* sets the placement; x, y, normal: images of the axes of the panel, the columns of its rotation */
static void panel_place_set(mus__half *half, int32_t panel, const double *x, const double *y, const double *normal,
                      const double *origin, double bend, double bend_x)
{
    if (half->board.status != MUS_OK || panel == MUS_NONE) return;
    mus_placement *place = &half->board.panel[panel].attr.placement;
    mus_placement_init(place, sizeof *place);
    for (int i = 0; i < 3; i++) {
        place->rotation[3 * i] = x[i];
        place->rotation[3 * i + 1] = y[i];
        place->rotation[3 * i + 2] = normal[i];
        place->origin[i] = origin[i];
    }
    place->bend = bend;
    place->bend_x = bend_x;
}


/* front faces +Z; back faces -Z with its x to the wearer's right. The line x = bend_x stands at X = `at` */
static void panel_place_upright(mus__half *half, int32_t panel, bool front, double at, double y, double z, double bend,
                          double bend_x)
{
    const double turn = front ? 1.0 : -1.0;
    const double ex[3] = {turn, 0.0, 0.0}, ey[3] = {0.0, 1.0, 0.0}, en[3] = {0.0, 0.0, turn};
    const double origin[3] = {at - turn * bend_x, y, z};
    panel_place_set(half, panel, ex, ey, en, origin, bend, bend_x);
}


/* distance of torso panels from the axis of the torso [m]: its depth is below 0.15 of its largest girth */
static double panel_place_off(const mus__half *half)
{
    const double *m = half->measures.v;
    return 0.155 * fmax(m[MUS_MEASURE_BUST], fmax(m[MUS_MEASURE_WAIST], m[MUS_MEASURE_HIP])) + 0.045;
}


void mus__panel_place_torso(mus__half *half, int32_t panel, bool front, double width, double height)
{
    /* a bend of 1.5 half widths brings the sides back by a third of the half width */
    const double off = panel_place_off(half), z = half->skeleton.torso_z + (front ? off : -off);
    panel_place_upright(half, panel, front, 0.0, height, z, 1.5 * width, 0.0);
}


void mus__panel_place_hips(mus__half *half, int32_t panel, bool front, double width, double height)
{
    /* half a ring each: round the hips with room, or as wide as the widest level asks */
    const double *m = half->measures.v;
    const double girth = fmax(m[MUS_MEASURE_WAIST], m[MUS_MEASURE_HIP]);
    const double radius = fmax(girth / (2.0 * MUS_PI) + 0.06, width / MUS_PI + 0.01);
    const double z = -0.005 * half->skeleton.crown + (front ? radius : -radius);
    panel_place_upright(half, panel, front, 0.0, height, z, radius, 0.0);
}


void mus__panel_place_arm(mus__half *half, int32_t panel, double crown_x, double crown_y, double width)
{
    /* y of the panel runs up the left arm, its normal points up and out: x is then to the back */
    const double *axis = half->skeleton.arm_axis[0], *joint = half->skeleton.joint[0];
    double ex[3], ey[3] = {-axis[0], -axis[1], -axis[2]}, en[3], forward[3] = {0.0, 0.0, -1.0};
    mus__cross3(forward, ey, en);
    mus__unit3(en);
    mus__cross3(ey, en, ex);

    /* the roll is 1 cm wider than the sleeve; the crown lies 1.5 cm below the joint along the arm */
    const double radius = width / (2.0 * MUS_PI) + 0.012, down = crown_y + 0.015;
    double origin[3];
    for (int i = 0; i < 3; i++) origin[i] = joint[i] + down * axis[i] + radius * en[i] - crown_x * ex[i];
    panel_place_set(half, panel, ex, ey, en, origin, radius, crown_x);
}


void mus__panel_place_ring(mus__half *half, int32_t panel, bool front, double girth, double height)
{
    /* about the neck above the armpits, else about the middle of the torso */
    const mus__skeleton *skeleton = &half->skeleton;
    const double radius = girth / (2.0 * MUS_PI) + 0.02, axis = height > skeleton->armpit ? skeleton->shoulder_z
                                                                                          : skeleton->torso_z;
    panel_place_upright(half, panel, front, 0.0, height, axis + (front ? radius : -radius), radius, 0.0);
}


void mus__panel_heights(const mus__board *board, int32_t panel, double *y)
{
    const mus_placement *place = &board->panel[panel].attr.placement;
    for (int32_t i = 0; i < board->nside; i++) {
        const mus__board_chain *chain = &board->side[i].chain;
        if (board->side[i].panel != panel) continue;
        for (int32_t k = 0; k < chain->nxy; k++) {
            double x = chain->xy[2 * k], z = 0.0;
            if (place->bend != 0.0) {
                const double angle = (x - place->bend_x) / place->bend;
                x = place->bend_x + place->bend * mus__sin(angle);
                z = place->bend * (mus__cos(angle) - 1.0);
            }
            const double high = place->origin[1] + place->rotation[3] * x +
                                place->rotation[4] * chain->xy[2 * k + 1] + place->rotation[5] * z;
            y[0] = fmin(y[0], high), y[1] = fmax(y[1], high);
        }
    }
}


/* face azimuth `around` from the front to the left, leaned back from the vertical by `tilt` at its top */
void mus__lower_place(mus__half *half, int32_t panel, double around, double tilt, const double *origin, double bend)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK || !mus__board_has_panel(board, panel)) return;
    const double out[3] = {mus__sin(around), 0.0, mus__cos(around)},
                 along[3] = {mus__cos(around), 0.0, -mus__sin(around)};
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    for (int i = 0; i < 3; i++) {
        const double up = i == 1 ? 1.0 : 0.0;
        place.rotation[3 * i] = along[i];
        place.rotation[3 * i + 1] = up * mus__cos(tilt) - out[i] * mus__sin(tilt);
        place.rotation[3 * i + 2] = out[i] * mus__cos(tilt) + up * mus__sin(tilt);
        place.origin[i] = origin[i];
    }
    place.bend = bend;
    board->panel[panel].attr.placement = place;
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
    const double reach = radius * mus__sin(fmin(inner / radius, 0.5 * MUS_PI)) + 0.004;
    const double x = fmax(half->skeleton.leg_x, reach);

    /* the crease lies over x, so the panel's x = 0 does not: the roll keeps the line of the crease in place */
    const double turn = front ? 1.0 : -1.0;
    const double origin[3] = {x - crease, half->waist_level, -0.005 * half->skeleton.crown + turn * off};
    mus__lower_place(half, panel, front ? 0.0 : MUS_PI, 0.0, origin, radius);
    if (half->board.status == MUS_OK) half->board.panel[panel].attr.placement.bend_x = turn * crease;
}
