/*
 * rig.h: the rigid parts of a body, the joints between them, and where a pose puts them.
 *
 * A limb's stack is cut at the joints into parts: the torso into pelvis, chest and head, an arm into upper arm, forearm
 * and hand, a leg into shank and thigh; a foot is its own. A part moves with one joint. Contact fields are one a part,
 * in the order of the parts; the parts of a limb follow each other with s ascending. Made once with the body.
 *
 * A pose becomes one mus__local a joint at the door, with sines and cosines; blending two of them and the frames of the
 * parts take only + - * / and sqrt, so a step may ask for them.
 *
 *     turn_j = turn_parent * R(quaternion_j),   x = turn_j (x_rest - pivot_j) + the place of pivot_j + shift_j
 */
#ifndef MUS_BODY_RIG_H
#define MUS_BODY_RIG_H

#include "base/base_internal.h"
#include "muslin/pose.h"

#define MUS_PARTS_MOST 64

/* x = turn * rest + place, turn row by row */
typedef struct mus__frame {
    double turn[9], place[3];
} mus__frame;

/* of one joint, in the directions of the rest pose: the rotation about its pivot (w, x, y, z), and how far the pivot
 * moved with its parent (the scapula; of the root: the place) */
typedef struct mus__local {
    double quaternion[4], shift[3];
} mus__local;

/* a range of a limb's stack */
typedef struct mus__part {
    int32_t limb, joint;
    double end[2];   /* s where it begins and ends: a joint, or the contour that ends the limb */
    double round[2]; /* length of the round cap beyond a joint, 0: the limb ends here with its own cap */
} mus__part;

typedef struct mus__rig {
    int32_t parts;
    mus__part part[MUS_PARTS_MOST];
    int32_t parent[MUS_JOINT_COUNT];   /* comes before its children; of the root MUS_NONE */
    double pivot[MUS_JOINT_COUNT][3];  /* in the rest pose [m] */
    double rest[MUS_JOINT_COUNT][3];   /* angles of the rest pose */
    double parent_stand[MUS_JOINT_COUNT][4]; /* the parent's rotation from the anatomical pose to the rest pose */
    bool missing[MUS_JOINT_COUNT];     /* of a scan without that limb: its angles are 0 */
    double scapula;                    /* how far a shoulder joint goes while the arm rises to 170 degrees [m] */
} mus__rig;

struct mus_body;

/* the rig of a body whose limbs are made; one part a limb when it has no skeleton */
void mus__rig_make(const struct mus_body *body, mus__rig *out);
const mus__rig *mus__body_rig(const struct mus_body *body);
/* where its parts stand (parts), NULL in the rest pose */
const mus__frame *mus__body_frames(const struct mus_body *body);

/* out (MUS_JOINT_COUNT). Errors: MUS_ERR_ARG, MUS_ERR_VERSION; limits are not looked at */
mus_status mus__rig_locals(mus_context *context, const mus__rig *rig, const mus_pose *pose, mus__local *out);
/* t of the way from a to b, joint by joint; out may be a or b */
void mus__rig_blend(const mus__local *a, const mus__local *b, double t, mus__local *out);
/* out (parts) */
void mus__rig_frames(const mus__rig *rig, const mus__local *local, mus__frame *out);
/* frame of the ring of the skin at s of a limb: near a joint a blend of its two parts */
void mus__rig_ring(const mus__rig *rig, const mus__frame *frames, int32_t limb, double s, mus__frame *out);
/* out = turn * x + place, of a direction turn * x alone; out may be x */
void mus__frame_point(const mus__frame *frame, const double *x, double *out);
void mus__frame_turn(const mus__frame *frame, const double *x, double *out);

#endif
