/*
 * skeleton.h: heights and joints of a body, from a completed tape alone. The body stands on it, and the designs place
 * their panels by it. Index 0 is the left side (X > 0), 1 the right.
 */
#ifndef MUS_LIMB_SKELETON_H
#define MUS_LIMB_SKELETON_H

#include "muslin/tape.h"

typedef struct mus__skeleton {
    /* heights above the floor [m], descending */
    double crown, brow, jaw, nape, neck_side, shoulder, armpit, bust, underbust, waist, high_hip, hip, crotch, knee,
        ankle;
    double neck_side_x;    /* half breadth of the neck where it meets the shoulder line */
    double shoulder_end;   /* half breadth over the shoulder points, where the tape of the shoulder ends */
    double shoulder_x;     /* half breadth over the edges of the shoulder bones */
    double shoulder_z;     /* Z of the contour centre at the shoulder points */
    double torso_z;        /* Z of the contour centre at the bust */
    double joint[2][3];    /* shoulder joints */
    double arm_axis[2][3]; /* unit, from the joint to the wrist */
    double arm_before;     /* from the level of the shoulder bone's edge to the joint along the axis */
    double elbow;          /* joint to elbow along the axis */
    double arm_length;     /* joint to wrist along the axis */
    double leg_x;          /* X of the leg axis at the crotch */
} mus__skeleton;

/* `tape` must be complete */
void mus__skeleton_make(const mus_tape *tape, mus__skeleton *out);

#endif
