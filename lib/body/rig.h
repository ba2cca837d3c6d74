/*
 * rig.h: the rigid parts of a body and the joints between them.
 *
 * A limb's stack is cut at the joints into parts: the torso into pelvis, chest and head, an arm into upper arm, forearm
 * and hand, a leg into shank and thigh; a foot is its own. A part moves with one joint. Contact fields are one a part,
 * in the order of the parts; the parts of a limb follow each other with s ascending. Made once with the body.
 *
 * The rig knows the rest pose and nothing of other poses: lib/pose computes the frames of the parts from it.
 */
#ifndef MUS_BODY_RIG_H
#define MUS_BODY_RIG_H

#include "body/frame.h"
#include "limb/field.h"
#include "muslin/body.h"

#define MUS__PARTS_MOST 64 /* most parts of a body: 15 of a tape and 48 limbs added, or 64 given limbs */

/* index of the first two angles of a joint, as MUS_POSE_* of muslin/pose.h */
enum { MUS__FLEXION, MUS__ABDUCTION };

typedef struct mus__rig {
    int32_t parts;
    mus__part part[MUS__PARTS_MOST];
    int32_t parent[MUS_JOINT_COUNT];   /* comes before its children; of the root MUS_NONE */
    double pivot[MUS_JOINT_COUNT][3];  /* in the rest pose [m] */
    double rest[MUS_JOINT_COUNT][3];   /* angles of the rest pose [rad] */
    double parent_stand[MUS_JOINT_COUNT][4]; /* the parent's rotation from the anatomical pose to the rest pose */
    bool missing[MUS_JOINT_COUNT];     /* of a scan without that limb: its angles are 0 */
    double scapula;                    /* how far a shoulder joint goes while the arm rises to 170 degrees [m] */
} mus__rig;

/* the rig of a body whose limbs are made; one part a limb when it has no skeleton */
void mus__rig_make(const mus_body *body, mus__rig *out);
/* the middle of a limb at s, linear between its contours, as it was made */
void mus__rig_middle(const mus__limb *limb, double s, double *out);
const mus__rig *mus__body_rig(const mus_body *body);
/* where its parts stand (parts), NULL in the rest pose */
const mus__frame *mus__body_frames(const mus_body *body);

/* rotation (4) of a joint by its flexion, abduction and rotation `angle` (3), from the anatomical pose */
void mus__joint_turn(int32_t joint, const double *angle, double *out);
/* put a field where the frame of its part carries the limb; the tables stay */
void mus__part_carry(const mus__limb *limb, const mus__frame *frame, mus__field *field);
/* frame of the ring of the skin at s of a limb: near a joint a blend of its two parts */
void mus__rig_ring(const mus__rig *rig, const mus__frame *frames, int32_t limb, double s, mus__frame *out);

#endif
