/*
 * body_posture.c: the posture of back and head: contours of the torso moved forwards and backwards.
 *
 * A contour is translated within its plane, so the girths and heights of the tape do not change. Its shift forwards is
 * the sum of three parts, each an amount of mus_body_def times a function of the height:
 *
 *     stoop          t^2 (5 t - 3) / 2,  t from 0 at the waist to 1 at the nape and above: the shoulder blades move
 *                    backwards by 0.08 of the shift of the nape, and the head moves with the nape
 *     head_forward   u^2 (3 - 2 u),  u from 0 at the base of the neck to 1 at the jaw and above
 *     sway           1 at the waist, down to -0.3 at the hip and below, and to 0 at the armpit, both as v^2 (3 - 2 v)
 *
 * The shoulder joints, and with them the arms, move with the torso at the height of the shoulder points; the roots of
 * the legs move with the hip. The names are those of tailors' posture classes: stooping, erect, head forward, hollow
 * back.
 */
#include <math.h>

#include "body/body_make.h"

/* range of each amount, in parts of the stature; chosen: from an erect back to that of old age */
static const struct {
    const char *name;
    double low, high;
} posture_range[] = {{"stoop", -0.02, 0.04}, {"head_forward", -0.01, 0.03}, {"sway", -0.015, 0.03}};


bool mus__posture_none(const mus_body_def *def)
{
    return def->stoop == 0.0 && def->head_forward == 0.0 && def->sway == 0.0;
}


mus_status mus__posture_check(mus_context *context, const mus_body_def *def, double stature)
{
    const double value[] = {def->stoop, def->head_forward, def->sway};
    for (int i = 0; i < 3; i++) {
        const double low = posture_range[i].low * stature, high = posture_range[i].high * stature;
        if (value[i] >= low && value[i] <= high) continue;
        return mus__fail(context, MUS_ERR_ARG, "%s %g m is outside %.3f to %.3f m, for a stature of %.3f m",
                         posture_range[i].name, value[i], low, high, stature);
    }
    return MUS_OK;
}


/* shift forwards of the centre at height y [m] */
static double posture_shift(const mus_body_def *def, const mus__skeleton *bone, double y)
{
    const double t = fmin(fmax((y - bone->waist) / (bone->nape - bone->waist), 0.0), 1.0);
    const double stoop = 0.5 * t * t * (5.0 * t - 3.0);
    const double head = mus__cubic_step((y - bone->neck_side) / (bone->jaw - bone->neck_side));
    const double sway = y < bone->waist ? 1.0 - 1.3 * mus__cubic_step((bone->waist - y) / (bone->waist - bone->hip))
                                        : 1.0 - mus__cubic_step((y - bone->waist) / (bone->armpit - bone->waist));
    return def->stoop * stoop + def->head_forward * head + def->sway * sway;
}


void mus__posture_bones(const mus_body_def *def, mus__skeleton *bone)
{
    const double shoulder = posture_shift(def, bone, bone->shoulder);
    bone->shoulder_z += shoulder;
    bone->torso_z += posture_shift(def, bone, bone->bust);
    bone->joint[0][2] += shoulder;
    bone->joint[1][2] += shoulder;
}


void mus__posture_torso(const mus_body_def *def, const mus__skeleton *bone, mus__limb *torso)
{
    for (int32_t i = 0; i < torso->count; i++)
        torso->contour[i].cb -= posture_shift(def, bone, torso->contour[i].s); /* front is -Z */
}
