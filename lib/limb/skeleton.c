/*
 * skeleton.c: heights and joints of a person from a completed tape.
 *
 * The heights of waist, crotch, hip, nape and bust are the tape's. The others follow from them: the shoulders lie below
 * the nape by the tape's shoulder length and slope, the armpit by the scye depth; head and legs are fractions of the
 * stature (means of ANSUR II and of the GarmentCode mean bodies).
 */
#include "limb/skeleton.h"

#include <math.h>
#include <string.h>

#include "base/base_internal.h"
#include "base/elementary.h"
#include "geom/vec.h"


/* women's or men's number, the mean for an unset sex; children take the women's */
static double skeleton_mix(int32_t sex, double female, double male)
{
    return sex == MUS_SEX_MALE ? male : sex == MUS_SEX_UNSET ? 0.5 * (female + male) : female;
}


/* distance from the shoulder point to the acromion, in parts of the stature: gives the shoulder breadths of ANSUR II */
static double skeleton_wide(int32_t sex)
{
    return sex == MUS_SEX_CHILD ? 0.0 : skeleton_mix(sex, 0.007, 0.0);
}


static void skeleton_head(const mus_tape *tape, mus__skeleton *out)
{
    double h = out->crown;
    bool child = mus_tape_sex(tape) == MUS_SEX_CHILD;

    /* brow and jaw in parts of the stature: of a child up to 128 cm 0.93 and 0.86, of an adult 0.95 and 0.89 */
    double grown = child ? fmin(fmax((h - 1.28) / 0.36, 0.0), 1.0) : 1.0;
    out->brow = (0.930 + 0.020 * grown) * h;
    out->jaw = (0.860 + 0.030 * grown) * h;

    /* a high nape raises the jaw, and with it the brow, within the head */
    out->jaw = fmax(out->jaw, out->nape + 0.022 * h);
    out->brow = fmax(out->brow, fmin(out->jaw + 0.03 * h, 0.985 * h));
}


static void skeleton_trunk(const mus_tape *tape, mus__skeleton *out)
{
    double h = out->crown;
    double sh = mus_tape_value(tape, MUS_MEASURE_SHOULDER), slope = mus_tape_value(tape, MUS_MEASURE_SHOULDER_SLOPE);

    out->nape = mus_tape_value(tape, MUS_MEASURE_NAPE_HEIGHT);
    out->bust = mus_tape_value(tape, MUS_MEASURE_BUST_HEIGHT);
    out->waist = mus_tape_value(tape, MUS_MEASURE_WAIST_HEIGHT);
    out->hip = out->waist - mus_tape_value(tape, MUS_MEASURE_WAIST_TO_HIP);
    out->crotch = mus_tape_value(tape, MUS_MEASURE_INLEG);
    out->high_hip = 0.5 * (out->waist + out->hip);
    out->underbust = out->bust - 0.39 * (out->bust - out->waist);

    /* the shoulder line begins at the neck 0.0165 H below the nape and falls by the tape's slope to the shoulder point;
     * the acromion lies further out and lower, since the shoulder is round */
    const double wide = skeleton_wide(mus_tape_sex(tape)) * h;
    out->neck_side = out->nape - 0.0165 * h;
    out->shoulder = out->neck_side - sh * mus__sin(slope) - 0.75 * wide;
    out->neck_side_x = mus_tape_value(tape, MUS_MEASURE_NECK) / (2.0 * MUS_PI);
    out->shoulder_end = out->neck_side_x + sh * mus__cos(slope);
    out->shoulder_x = out->shoulder_end + wide;
    out->shoulder_z = skeleton_mix(mus_tape_sex(tape), -0.0125, -0.014) * h;
    out->torso_z = skeleton_mix(mus_tape_sex(tape), 0.005, 0.0) * h;

    /* the armpit: 0.9 of the scye depth below the nape, since the tape hangs lower; between bust and shoulder */
    double armpit = out->nape - 0.9 * mus_tape_value(tape, MUS_MEASURE_SCYE_DEPTH);
    armpit = fmin(armpit, out->shoulder - 0.03 * h);
    out->armpit = fmax(armpit, out->bust + 0.12 * (out->nape - out->waist));
}


static void skeleton_limbs(const mus_tape *tape, mus__skeleton *out)
{
    double h = out->crown;
    double down = mus_tape_value(tape, MUS_MEASURE_ARM_ANGLE);

    /* the ball of the shoulder touches the shoulder line from below, inside its end */
    double ball = mus_tape_value(tape, MUS_MEASURE_UPPER_ARM) / (2.0 * MUS_PI) * 1.10;
    double x = out->shoulder_x - 0.33 * ball, y = out->shoulder - 0.78 * ball;

    for (int i = 0; i < 2; i++) {
        double side = i == 0 ? 1.0 : -1.0;
        double joint[3] = {side * x, y, out->shoulder_z}, axis[3] = {side * mus__cos(down), -mus__sin(down), 0.06};
        mus__unit3(axis);
        out->arm_before = (x - out->shoulder_x) * side * axis[0] + (y - out->shoulder) * axis[1];
        memcpy(out->joint[i], joint, sizeof joint);
        memcpy(out->arm_axis[i], axis, sizeof axis);
    }

    /* the tape of the bent arm is 5 % longer than the straight arm from acromion to wrist, all of it above the tip of
     * the elbow. It runs over the ball (arc `over`) and down the outer side, which approaches the axis by `slant` */
    const double arm = mus_tape_value(tape, MUS_MEASURE_ARM), over = ball * mus__asin(out->arm_before / ball);
    const double straight = arm / 1.05 - over, slant = ball - mus_tape_value(tape, MUS_MEASURE_WRIST) / (2.0 * MUS_PI);
    out->arm_length = sqrt(fmax(straight * straight - slant * slant, 0.0));
    out->elbow = mus_tape_value(tape, MUS_MEASURE_ELBOW) - arm * (0.05 / 1.05) - over;
    out->leg_x = 0.050 * h;
    out->knee = out->crotch * 0.60;
    out->ankle = out->crotch * 0.17;
}


void mus__skeleton_make(const mus_tape *tape, mus__skeleton *out)
{
    memset(out, 0, sizeof *out);
    out->crown = mus_tape_value(tape, MUS_MEASURE_STATURE);
    skeleton_trunk(tape, out);
    skeleton_head(tape, out);
    skeleton_limbs(tape, out);
}
