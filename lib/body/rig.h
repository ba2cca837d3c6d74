/*
 * rig.h: the rigid parts of a body and the joints between them.
 *
 * Joints cut a limb's stack into parts: the torso into pelvis, chest and head, an arm into upper arm, forearm and hand,
 * a leg into shank and thigh; a foot is one part. A part moves with one joint. Each part has one radius field, in the
 * order of the parts; the parts of a limb are consecutive, with s ascending. The rig is made once, with the body.
 *
 * The rig knows the rest pose and no other pose: lib/pose computes the frames of the parts from it.
 */
#ifndef MUS_BODY_RIG_H
#define MUS_BODY_RIG_H

#include "body/frame.h"
#include "limb/radius_field.h"
#include "muslin/body.h"

#define MUS__PARTS_MOST 64 /* most parts of a body: 15 of a tape and 48 limbs added, or 64 given limbs */

/* index of the first two angles of a joint, as MUS_POSE_* of muslin/pose.h */
enum { MUS__FLEXION, MUS__ABDUCTION };

typedef struct mus__rig {
    int32_t parts;
    mus__part part[MUS__PARTS_MOST];
    int32_t parent[MUS_JOINT_COUNT];  /* the joint that carries it, before it in the list; of the root MUS_NONE */
    double pivot[MUS_JOINT_COUNT][3]; /* in the rest pose [m] */
    double rest[MUS_JOINT_COUNT][3];  /* flexion, abduction, rotation of the rest pose [rad] */
    double parent_stand[MUS_JOINT_COUNT][4]; /* quaternion of the parent, from the anatomical pose to the rest pose */
    bool missing[MUS_JOINT_COUNT];    /* a scan lacks the limb: the joint cannot be turned */
    double scapula;                   /* rise of a shoulder joint while the arm rises from 30 to 170 degrees [m] */
} mus__rig;

/* the rig of a body whose limbs are made; a body without joints has one part for each limb */
void mus__rig_make(const mus_body *body, mus__rig *out);
/* the middle (3) of a limb at s in the rest pose, linear between its contours [m] */
void mus__rig_middle(const mus__limb *limb, double s, double *out);

/* quaternion (4) of a joint turned by flexion, abduction and rotation `angle` (3) [rad] from the anatomical pose */
void mus__joint_turn(int32_t joint, const double *angle, double *out);
/* set origin and directions of a part's field to those of its limb carried by a frame; the tables are not changed */
void mus__part_carry(const mus__limb *limb, const mus__frame *frame, mus__field *field);
/* frame of the ring at s of a limb: that of its part, near a joint a blend of two parts */
void mus__rig_ring(const mus__rig *rig, const mus__frame *frames, int32_t limb, double s, mus__frame *out);

#endif
