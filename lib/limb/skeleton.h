/*
 * skeleton.h: heights and joints of a person, from a completed tape alone.
 *
 * Limbs are made from it, and drafting blocks and panels are placed by it. Index 0 is the left side (X > 0), 1 the
 * right.
 */
#ifndef MUS_LIMB_SKELETON_H
#define MUS_LIMB_SKELETON_H

#include "muslin/tape.h"

typedef struct mus__skeleton {
    /* heights above the floor [m], descending */
    double crown, brow, jaw, nape, neck_side, shoulder, armpit, bust, underbust, waist, high_hip, hip, crotch, knee,
        ankle;
    double neck_side_x;    /* half breadth of the neck at the side neck points, where the shoulder line begins [m] */
    double shoulder_end;   /* half breadth at the shoulder points, where the measure `shoulder` ends [m] */
    double shoulder_x;     /* half breadth at the acromia (edges of the shoulder bones) [m] */
    double shoulder_z;     /* Z of the contour's centre at the shoulder points [m] */
    double torso_z;        /* Z of the contour's centre at the bust [m] */
    double joint[2][3];    /* shoulder joints [m] */
    double arm_axis[2][3]; /* unit, from the joint to the wrist */
    double arm_before;     /* distance along the arm's axis from the height of the acromion to the joint [m] */
    double elbow;          /* distance along the axis from the joint to the elbow [m] */
    double arm_length;     /* distance along the axis from the joint to the wrist [m] */
    double leg_x;          /* X of the leg's axis at the crotch [m] */
} mus__skeleton;

/* compute the skeleton of a completed tape */
void mus__skeleton_make(const mus_tape *tape, mus__skeleton *out);

#endif
