/* motion.h: a dressed body brought into a pose, or led through a movement frame by frame. */
#ifndef MUSLIN_MOTION_H
#define MUSLIN_MOTION_H

#include "picture.h"

#define MOTION_RATE 60 /* frames a second */

/* What is asked: texts of options, NULL when not given; and what came of it. */
typedef struct motion {
    const char *pose, *move;
    const char *frames; /* folder of the pictures */
    double count;       /* of frames of a movement */

    int32_t made;       /* frames that were made */
    int64_t steps;      /* of all frames */
    int32_t step_parts; /* a step was divided in at most */
    double max_depth;   /* deepest node below the skin in any frame [m] */
    double max_jump;    /* farthest way of a node between two frames [m] */
    double slid;        /* how far the middle of the cloth has moved along the body, up positive [m] */
    double seconds;     /* CPU-bound wall time of the steps */
} motion;

/* What is led: the drape is settled on the rest body. */
typedef struct dressed {
    const scene *s;
    const look *l;
    const mus_body *body; /* at rest */
    const mus_body *thin; /* the same with a coarse surface, for the animated file; NULL: body */
    const mus_cloth *cloth;
    mus_drape *drape;
} dressed;

/* Names that are known, options that go together. Returns an exit code. */
int motion_check(const scene *s, const motion *m);

/* Bring the body from how it stands into the pose, in a second and a half of cloth time. */
mus_status motion_into(const dressed *d, motion *m, const char *pose);

/* Lead the body through the movement. `glb` gets the animated file, NULL: none. Returns an exit code; *status what a
 * step said. */
int motion_lead(const dressed *d, motion *m, const char *glb, mus_status *status);

#endif
