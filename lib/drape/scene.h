/*
 * scene.h: the body and the planes of a drape as they are now, and their motion.
 *
 * A place is a product, place0 + velocity (t - t0), never a running sum, so that a long motion keeps its place. Contact
 * works relative to the surface that a node touches; nothing else of a drape knows that surfaces move.
 *
 * Files: scene.c (public calls, the scene at a time), scene_body.c (how the body stands), scene_pose.c (movements to
 * another pose), scene_plane.c (planes), scene_attachment.c (level planes that edges are attached to).
 */
#ifndef MUS_DRAPE_SCENE_H
#define MUS_DRAPE_SCENE_H

#include "body/body_level.h"
#include "body/rig.h"
#include "contact/contact.h"
#include "muslin/drape.h"
#include "pose/pose_frame.h"
#include "sim/force_program_elements.h"

/* a plane: where it was at `time`, and how it has moved since */
typedef struct mus__scene_plane {
    mus_plane added; /* as the caller gave it, with a unit normal */
    double from[3], velocity[3], spin, time;
} mus__scene_plane;

/* the pose of the body, and the movement from one pose to another */
typedef struct mus__scene_body {
    mus__rig rig;
    mus_pose made, from, to;
    mus__joint_local as_made[MUS_JOINT_COUNT], start[MUS_JOINT_COUNT], end[MUS_JOINT_COUNT]; /* by scene_pose.c */
    mus__frame frame[MUS__PARTS_MOST];        /* where the parts were last put */
    double time, duration;                    /* when the movement began, how long it takes [s] */
    int32_t posed;                            /* nonzero: not as the limbs were made */
    int32_t came_posed;                       /* nonzero: the body was posed when the drape was made */
    mus__body_level level[MUS__LEVEL_COUNT][2]; /* as made, left and right */
    double neck, shoulder; /* half the breadth over the inner, the outer ends of the shoulder lines [m]; 0: unknown */
    void (*carry)(struct mus__scene_body *stance, double part); /* NULL until the first movement (scene_pose.c) */
} mus__scene_body;

typedef struct mus__scene {
    mus__collider *collider;           /* NULL without a body and planes */
    double friction;                   /* of surfaces without a friction of their own */
    double from[3], velocity[3], time; /* the body as a whole: its shift at `time` [m], its velocity since [m/s] */
    mus__scene_body *body;             /* NULL without a body */
    mus__scene_plane *plane;           /* (MUS__PLANES_MAX) as many are in use as the collider has; NULL without */
    int32_t moving;                    /* nonzero: the collider was last told of a motion */
    int32_t moved;                     /* nonzero: a surface moved since the plane cache was filled */
} mus__scene;

/* whether the body or a plane moves in a step of `h`, `steps` steps from now; whether a plane does; whether the pose
 * changes */
int32_t mus__scene_moves(const mus_drape *drape, int64_t steps, double h);
int32_t mus__scene_plane_moves(const mus_drape *drape);
int32_t mus__scene_body_poses(const mus_drape *drape, int64_t steps, double h);
/* MUS_ERR_STATE when a surface moves; `what` names the call that needs it at rest */
mus_status mus__scene_require_rest(const mus_drape *drape, const char *what);

/* put the body into the scene of a new drape: collider, pose, level planes. Errors: MUS_ERR_MEMORY */
mus_status mus__scene_add_body(mus_drape *drape, const mus_body *body);
/* let the sim meet the collider, with the passes of its precision (scene_contact.c) */
void mus__scene_contact(mus_drape *drape);

/* the pose of the body as it came; the same again after movements */
mus_status mus__scene_body_create(mus_drape *drape, const mus_body *body);
void mus__scene_body_reset(mus_drape *drape);
/* frames of the body's parts `steps` steps of `h` from now, NULL: as made */
const mus__frame *mus__scene_body_frames(mus_drape *drape, int64_t steps, double h);
/* part (0..1) of the movement that is done then */
double mus__scene_body_part(const mus_drape *drape, int64_t steps, double h);
/* the pose now, interpolated angle by angle, without the shift of the body */
void mus__scene_body_pose(const mus_drape *drape, mus_pose *out);

/* put the body and the planes where they are `steps` steps of `h` from now; they came there in a step of `came`, or are
 * at rest there (came 0) */
void mus__scene_update(mus_drape *drape, int64_t steps, double h, double came);
void mus__scene_planes_update(mus_drape *drape, int64_t steps, double h, double came);
/* put the body where it was made and the planes where they were added, with the velocities that these had then */
void mus__scene_reset(mus_drape *drape);
/* once before some steps, the rule of contact being set; and before each step: put the surfaces where they will be at
 * its end, `steps` steps from the clock's time, and decide whether contact sweeps fast nodes */
void mus__scene_before_steps(mus_drape *drape);
void mus__scene_before_step(mus_drape *drape, int64_t steps, double h);

/* put the level planes of the program where they lie now; does nothing without attachments */
void mus__scene_levels_update(mus_drape *drape);
/* where one level plane lies now; out->there 0 without a body that has it */
void mus__scene_level(const mus_drape *drape, int32_t level, int32_t right, mus__level_plane *out);
/* half the breadth over the outer ends of the shoulder lines, and over the inner ends (*neck) [m]; 0 when unknown */
double mus__scene_shoulder(const mus_drape *drape, double *neck);

#endif
