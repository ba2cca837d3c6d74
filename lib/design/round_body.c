/*
 * round_body.c: where panels start: before and behind the torso, rolled round the arms, bent round the hips.
 *
 * Panels start outside the body and face outwards. Torso panels stand off by the body's depth, with their sides bent
 * towards each other before and behind the arms; a sleeve is a roll about the arm's axis that opens below; skirts are
 * bent to half a ring each.
 */
#include <math.h>
#include <string.h>

#include "design/recipe.h"
#include "geom/vec.h"


/* columns of the rotation: images of the panel's x, y and normal */
static void round_set(mus__piece *piece, const double *x, const double *y, const double *normal, const double *origin,
                      double bend)
{
    mus__draft *draft = piece->draft;
    if (draft->status != MUS_OK) return;
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    for (int i = 0; i < 3; i++) {
        place.rotation[3 * i] = x[i];
        place.rotation[3 * i + 1] = y[i];
        place.rotation[3 * i + 2] = normal[i];
        place.origin[i] = origin[i];
    }
    place.bend = bend;
    draft->status = mus_pattern_set_placement(draft->pattern, piece->panel, &place);
}


/* front faces +Z; back faces -Z with its x to the wearer's right */
static void round_torso(mus__piece *piece, bool front, double z, double y, double bend)
{
    const double turn = front ? 1.0 : -1.0;
    const double ex[3] = {turn, 0.0, 0.0}, ey[3] = {0.0, 1.0, 0.0}, en[3] = {0.0, 0.0, turn};
    const double origin[3] = {0.0, y, z};
    round_set(piece, ex, ey, en, origin, bend);
}


void mus__place_torso(mus__piece *piece, bool front, double width, double height)
{
    /* depth of a torso is below 0.15 of its largest girth; the sides come back by a third of the half width */
    const double *m = piece->draft->measures.v;
    const double girth = fmax(m[MUS_MEASURE_BUST], fmax(m[MUS_MEASURE_WAIST], m[MUS_MEASURE_HIP]));
    const double off = 0.155 * girth + 0.045, z = piece->draft->skeleton.torso_z + (front ? off : -off);
    round_torso(piece, front, z, height, 1.5 * width);
}


void mus__place_arm(mus__piece *piece, const mus__sleeve *sleeve, int32_t side)
{
    /* y of the panel runs up the arm, its normal points up and out: x is then to the back on the left arm */
    const mus__skeleton *skeleton = &piece->draft->skeleton;
    const double *axis = skeleton->arm_axis[side], *joint = skeleton->joint[side];
    double ex[3], ey[3] = {-axis[0], -axis[1], -axis[2]}, en[3], forward[3] = {0.0, 0.0, side == 0 ? -1.0 : 1.0};
    mus__cross3(forward, ey, en);
    mus__unit3(en);
    mus__cross3(ey, en, ex);

    /* the roll is 1 cm wider than the sleeve; the crown lies 1.5 cm below the joint along the arm */
    const double radius = sleeve->width / (2.0 * MUS_PI) + 0.012, down = sleeve->height + 0.015;
    double origin[3];
    for (int i = 0; i < 3; i++) origin[i] = joint[i] + down * axis[i] + radius * en[i];
    round_set(piece, ex, ey, en, origin, radius);
}


void mus__place_hips(mus__piece *piece, bool front, double width, double height)
{
    /* half a ring each: round the hips with room, or as wide as the widest level asks */
    const double *m = piece->draft->measures.v;
    const double girth = fmax(m[MUS_MEASURE_WAIST], m[MUS_MEASURE_HIP]);
    const double radius = fmax(girth / (2.0 * MUS_PI) + 0.06, width / MUS_PI + 0.01);
    const double z = -0.005 * piece->draft->skeleton.crown + (front ? radius : -radius);
    round_torso(piece, front, z, height, radius);
}
