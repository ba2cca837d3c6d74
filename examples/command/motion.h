/* motion.h: a dressed body brought into a pose, or led through a movement frame by frame. */
#ifndef MUSLIN_MOTION_H
#define MUSLIN_MOTION_H

#include "picture.h"

#define MOTION_RATE 60 /* frames a second */

/* The options of a motion, NULL when not given; and its results. */
typedef struct motion {
    const char *pose, *move;
    const char *frames; /* folder for the pictures */
    double count;       /* number of frames of a movement */

    int32_t made;       /* frames made */
    int64_t steps;      /* steps of all frames */
    int32_t step_parts; /* largest number of parts into which a step was divided */
    double max_depth;   /* largest depth of a node below the skin in any frame [m] */
    double max_jump;    /* longest way of a node between two frames [m] */
    double slid;        /* movement of the cloth's middle along the trunk, > 0 upwards [m] */
    double seconds;     /* wall time of the steps [s] */
} motion;

/* The objects of a motion; the drape is settled on the rest body. */
typedef struct dressed {
    const scene *s;
    const look *l;
    const mus_body *body; /* in its rest pose */
    const mus_body *thin; /* the same with a coarse surface, for the animated file; NULL: body */
    const mus_cloth *cloth;
    mus_drape *drape;
} dressed;

/* Checks the names of pose and movement, and the options against each other. Returns an exit code. */
int motion_check(const scene *s, const motion *m);

/* Moves the body from its present pose into the named one, in 1.5 s of cloth time. */
mus_status motion_into(const dressed *d, motion *m, const char *pose);

/* Whether a file of `files` (MESH_FORMS) that holds a motion is asked for. */
bool motion_filed(const char *const *files);

/* Leads the body through the movement and writes those of `files` (MESH_FORMS) that hold it, of a cloth of `fabric`.
 * Returns an exit code; *status is that of the last step. */
int motion_lead(const dressed *d, motion *m, const char *fabric, const char *const *files, mus_status *status);

#endif
