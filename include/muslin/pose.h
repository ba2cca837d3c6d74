/*
 * muslin/pose.h: how a body stands: the angles of its joints, and movements.
 *
 * A pose gives three angles to each joint, in the anatomical sense and against the standing body with hanging arms.
 * A body is made in its rest pose, which is that but for the arms, held off by the tape's arm angle. Posing carries the
 * parts of the body rigidly; girths stay what they were made.
 *
 * Units: radian, metre. Flexion is about the axis from side to side, abduction about the one from back to front,
 * rotation about the bone; a joint turns about its bone first, then abducts, then flexes.
 */
#ifndef MUSLIN_POSE_H
#define MUSLIN_POSE_H

#include "muslin/base.h"
#include "muslin/body.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which of the three angles of a joint. */
#define MUS_POSE_FLEXION 0
#define MUS_POSE_ABDUCTION 1
#define MUS_POSE_ROTATION 2

/** Angles of all joints, all 0: standing, arms hanging, palms to the thighs. */
typedef struct mus_pose {
    size_t size;
    double place[3];                  /* of the root, off where the body was made [m], default 0 */
    double angle[MUS_JOINT_COUNT][3]; /* flexion, abduction, rotation [rad], default 0 */
} mus_pose;

MUS_API void mus_pose_init(mus_pose *pose, size_t size);

/** Name of a joint ("elbow_left"), or NULL outside 0 .. MUS_JOINT_COUNT-1. Static text. */
MUS_API const char *mus_joint_name(int32_t joint);

/** How far a joint goes about an axis (MUS_POSE_FLEXION ...) [rad]. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_joint_limits(int32_t joint, int32_t axis, double *low, double *high);

/** Whether all angles are within the limits of their joints. Errors: MUS_ERR_ARG (also: a number that is not finite);
 * MUS_ERR_VERSION; MUS_ERR_BODY (the message names joint, angle and limits). */
MUS_API mus_status mus_pose_check(mus_context *context, const mus_pose *pose);

/** Named poses: number, and name ("sit"), NULL outside the range. Static text. */
MUS_API int32_t mus_pose_count(void);
MUS_API const char *mus_pose_name(int32_t pose);

/** A pose by its name; its place is 0. mus_body_clear_arms and mus_body_ground fit it to a body.
 * Errors: MUS_ERR_ARG (unknown name). */
MUS_API mus_status mus_pose_named(mus_context *context, const char *name, mus_pose *out);

/**
 * Make a posed copy of a body.
 *
 * Its surface, landmarks, contour points and depth are those of the pose; asked and made measures and the volume stay
 * those of the rest pose. A pose is always that of the body as made: posing a posed body does not add up.
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_BODY (an angle beyond the limits of its joint, or an
 *          angle of a limb that a scan has not)
 * Cost:    as mus_body_create
 */
MUS_API mus_status mus_body_pose(const mus_body *body, const mus_pose *pose, mus_body **out);

/** The pose that a body was made in: that of its tape's arm angle, or of a scan's arms. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_body_rest_pose(const mus_body *body, mus_pose *pose);

/** The pose that a body stands in. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_body_stance(const mus_body *body, mus_pose *pose);

/** Put a pose's place so high that the lowest point of the body stands on the floor. Errors: as mus_body_pose. */
MUS_API mus_status mus_body_ground(const mus_body *body, mus_pose *pose);

/** Abduct the arms of a pose a degree at a time, at most 60, until they are `gap` [m] (0 to 0.04) off the rest of the
 * body from below the armpit to the finger tips; arms that are stay as they are. Errors: as mus_body_pose. */
MUS_API mus_status mus_body_clear_arms(const mus_body *body, mus_pose *pose, double gap);

/** A movement: poses at times, and cubic splines between them. */
typedef struct mus_move mus_move;

/**
 * Make a movement.
 *
 * Shapes:  times (keys) [s], ascending; poses (keys)
 * period:  0 for a movement that ends (natural splines, which hold the first and the last pose outside their times), or
 *          the time [s] after which the first key comes again (periodic splines; at least 3 keys)
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_BODY (a pose beyond the limits of a joint)
 */
MUS_API mus_status mus_move_create(mus_context *context, int32_t keys, const double *times, const mus_pose *poses,
                                   double period, mus_move **out);
MUS_API void mus_move_destroy(mus_move *move);

/** Named movements: number, and name ("walk"), NULL outside the range. Static text. */
MUS_API int32_t mus_move_count(void);
MUS_API const char *mus_move_name(int32_t move);

/** Make a named movement for a body of that stature [m], with the legs of the mean person. Errors: MUS_ERR_ARG (also:
 * an unknown name), MUS_ERR_MEMORY. */
MUS_API mus_status mus_move_named(mus_context *context, const char *name, double stature, mus_move **out);

/** Make a named movement fitted to a body: at its keys and half way between, the feet are on the floor and the arms
 * `gap` [m] (0 to 0.04) off its sides. Errors: as mus_body_pose; MUS_ERR_ARG (unknown name, a body of given limbs).
 * Cost: some 40 ms. */
MUS_API mus_status mus_body_move(const mus_body *body, const char *name, double gap, mus_move **out);

/** The period [s], 0 for a movement that ends; and the time from its first to its last key, or the period. NaN for
 * NULL. */
MUS_API double mus_move_period(const mus_move *move);
MUS_API double mus_move_duration(const mus_move *move);

/** The pose at a time [s]. An angle that its spline carries past a limit of its joint is at the limit.
 * Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_move_at(const mus_move *move, double t, mus_pose *pose);

#ifdef __cplusplus
}
#endif

#endif
