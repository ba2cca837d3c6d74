/*
 * scan_internal.h: what is found in a mesh, and the limbs that are cut from it. Sections stand in scan_section.h.
 */
#ifndef MUS_SCAN_SCAN_INTERNAL_H
#define MUS_SCAN_SCAN_INTERNAL_H

#include "body/bones.h"
#include "muslin/scan.h"
#include "scan/scan_section.h"

#define MUS__SCAN_HORIZONTAL 0.35 /* sine of the angle below which an arm counts as horizontal: 20 degrees; chosen */
#define MUS__SCAN_LIMBS 7         /* torso, arms, legs, feet */
#define MUS__SCAN_CONTOURS 128    /* most contours of a limb: those of mus_body_create_limbs() */

/* ---- scan_frame.c ---- */

/* find up, front, unit and place, write them to the report and move the mesh into the body's frame [m]. *legs: it has
 * legs. Errors: MUS_ERR_BODY (one of them cannot be found), MUS_ERR_ARG, MUS_ERR_MEMORY */
mus_status mus__scan_frame(mus__scan_mesh *mesh, const mus_scan_def *def, mus_scan_report *report, bool *legs);

/* ---- scan_landmarks.c ---- */

/* an arm: its axis from the shoulder outwards, and the plane (wall) that separates it from the torso [m] */
typedef struct mus__scan_arm {
    bool there;                           /* the mesh has it */
    double side;                          /* +1 left, -1 right */
    double origin[3], axis[3], across[3]; /* point at s = 0 near the shoulder; unit axis; direction `side` of the limb
                                             */
    double tip;                           /* s of the finger tips */
    double root;                          /* s at which it leaves the torso */
    double wrist;                         /* s of the narrowest section of the forearm */
    double armpit[3];                     /* lowest point of the section at the root */
    double up[3];                         /* unit, square to the axis in the frontal plane, upwards */
    double wall[4];                       /* unit normal n and offset: n . x >= wall[3] is the side of the arm */
} mus__scan_arm;

typedef struct mus__scan_found {
    double stature, neck; /* heights of the crown and of the narrowest section of the neck [m] */
    bool legs;
    double crotch, middle; /* height of the crotch, and X of the plane between the legs [m] */
    double foot;           /* height of the top of the feet [m], 0: no feet */
    mus__scan_arm arm[2];
} mus__scan_found;

/* find crotch, neck, feet and arms; `upright` cuts horizontally. Errors: MUS_ERR_BODY, MUS_ERR_MEMORY */
mus_status mus__scan_find(const mus__scan_mesh *mesh, mus__slicer *upright, mus__scan_found *out);

/* ---- scan_limb.c ---- */

/* outlines of all limbs, for mus__body_create_jointed(); the arrays `row` and `outline` own their contours */
typedef struct mus__scan_limbs {
    int32_t count;
    mus_limb limb[MUS__SCAN_LIMBS];
    int32_t which[MUS__SCAN_LIMBS]; /* MUS__LIMB_* of body/bones.h */
    double *row[MUS__SCAN_LIMBS], *outline[MUS__SCAN_LIMBS];
    double shoulder[2]; /* s of the shoulder joints along the arms [m] */
    int32_t filled;     /* contours with a hollow that was closed */
    double deepest;     /* depth of the deepest of them [m] */
} mus__scan_limbs;

/* cut all limbs into outlines; holes go into the report. Errors: MUS_ERR_BODY, MUS_ERR_MEMORY */
mus_status mus__scan_cut(const mus__scan_mesh *mesh, const mus_scan_def *def, mus__slicer *upright,
                         const mus__scan_found *found, mus_scan_report *report, mus__scan_limbs *out);
void mus__scan_limbs_free(mus_context *context, mus__scan_limbs *limbs);

/* ---- scan_joint.c ---- */

/* the joints of a person with legs, from the contours of the limbs */
void mus__scan_joints(const mus__scan_found *found, const mus__scan_limbs *limbs, mus__bones *out);

/* ---- scan_measure.c, scan_distance.c ---- */

/* girths and their heights, into the report. Errors: MUS_ERR_MEMORY */
mus_status mus__scan_measure(const mus_body *body, const mus__scan_found *found, const mus__scan_limbs *limbs,
                             mus_scan_report *report);
/* distances between mesh and body, into the report. Errors: MUS_ERR_MEMORY */
mus_status mus__scan_distances(const mus__scan_mesh *mesh, const mus_body *body, const mus__scan_found *found,
                               mus_scan_report *report);

#endif
