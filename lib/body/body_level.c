/*
 * body_level.c: levels of a body: on the torso from the heights of the skeleton, on arms and legs from their contours.
 */
#include <string.h>

#include "body/body_make.h"


/* height [m] of a level of the torso; -1 for a level of arms or legs */
static double level_height(const mus__skeleton *bone, int32_t level)
{
    switch (level) {
    case MUS__LEVEL_NECK: return bone->neck_side;
    case MUS__LEVEL_ARMPIT: return bone->armpit;
    case MUS__LEVEL_BUST: return bone->bust;
    case MUS__LEVEL_WAIST: return bone->waist;
    case MUS__LEVEL_HIP: return bone->hip;
    case MUS__LEVEL_CROTCH: return bone->crotch;
    default: return -1.0;
    }
}


/* name of the contour at a level of arms or legs; "" for the torso */
static const char *level_contour(int32_t level)
{
    switch (level) {
    case MUS__LEVEL_BICEPS: return "upper_arm";
    case MUS__LEVEL_WRIST: return "wrist";
    case MUS__LEVEL_THIGH: return "thigh";
    case MUS__LEVEL_KNEE: return "knee";
    case MUS__LEVEL_ANKLE: return "ankle";
    default: return "";
    }
}


/* the part of a limb that contains s; MUS_NONE: the limb has no part */
static int32_t level_part(const mus__rig *rig, int32_t limb, double s)
{
    int32_t found = MUS_NONE;
    for (int32_t p = 0; p < rig->parts; p++) {
        if (rig->part[p].limb != limb) continue;
        if (found == MUS_NONE || s >= rig->part[p].end[0]) found = p;
    }
    return found;
}


/* find a level; of a level on arms or legs `right` selects the left (0) or the right limb (1) */
static void level_find(const mus_body *body, int32_t level, int32_t right, mus__body_level *out)
{
    const int32_t arm = level == MUS__LEVEL_BICEPS || level == MUS__LEVEL_WRIST;
    const double height = level_height(&body->skeleton, level);
    const int32_t l = height > 0.0 ? MUS__LIMB_TORSO : (arm ? MUS__LIMB_ARM_LEFT : MUS__LIMB_LEG_LEFT) + right;
    const mus__limb *limb = &body->limb[l];
    if (limb->gone) return;
    double s = height, a = 0.0, b = 0.0;
    out->there = height > 0.0;
    for (int32_t i = 0; i < limb->count; i++) {
        const mus__contour *c = &limb->contour[i];
        if (strcmp(c->name, level_contour(level)) != 0) continue;
        out->there = 1, s = c->s, a = c->ca, b = c->cb;
    }
    out->limb = l;
    out->part = level_part(&body->rig, l, s);
    if (out->part == MUS_NONE) out->there = 0;

    /* the axis of an arm points away from the shoulder, those of torso and legs point up */
    for (int i = 0; i < 3; i++) {
        out->point[i] = limb->origin[i] + a * limb->side[i] + b * limb->front[i] + s * limb->axis[i];
        out->side[i] = limb->side[i];
        out->up[i] = arm ? -limb->axis[i] : limb->axis[i];
    }
}


void mus__body_find_levels(mus_body *body)
{
    for (int32_t level = MUS__LEVEL_NECK; level < MUS__LEVEL_COUNT; level++)
        for (int32_t right = 0; right < 2; right++) level_find(body, level, right, &body->level[level][right]);
}
