/*
 * muslin/pose.h: poses (the angles of a body's joints) and movements (poses over time).
 *
 * A pose gives three angles to each joint (MUS_JOINT_* of muslin/body.h). They are anatomical angles against a person
 * who stands with hanging arms. A body is made in its rest pose: that stance, but with the arms abducted by the tape's
 * arm angle. Posing moves the parts of the body rigidly and keeps their girths.
 *
 * Flexion turns about the axis from side to side, abduction about the axis from back to front, rotation about the bone.
 * A joint rotates first, then abducts, then flexes.
 *
 * Chest and thighs stand as the angles of root, lumbar and hip joints say. The pelvis between them takes its part of
 * the flexion: where the hips have more than 5/8 of the sum of hips (their mean) and lumbar spine, as in sitting, it
 * tilts backwards about the hip joints until they have that part, and carries the lower end of the lumbar spine along.
 *
 * Units:   radian, metre, second
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

/* The feet that stand in a pose, as a sum. */
#define MUS_FOOT_LEFT 1
#define MUS_FOOT_RIGHT 2

/** A pose: the angles of all joints. All angles 0: standing, arms hanging, palms to the thighs. */
typedef struct mus_pose {
    size_t size;
    double place[3];                  /* of the root from where the body was made [m], within 1e3, default 0 */
    double angle[MUS_JOINT_COUNT][3]; /* flexion, abduction, rotation [rad], default 0 */
} mus_pose;

/** Set all angles and the place of a pose to 0; `size` is sizeof(mus_pose). */
MUS_API void mus_pose_init(mus_pose *pose, size_t size);

/** Name of a joint ("elbow_left"); NULL for an index outside 0 to MUS_JOINT_COUNT - 1. Static text. */
MUS_API const char *mus_joint_name(int32_t joint);

/** Least and greatest angle of a joint about an axis (MUS_POSE_FLEXION ...) [rad]. Errors: MUS_ERR_ARG.
 * Source: American Academy of Orthopaedic Surgeons, Joint Motion, 1965 (normal ranges). */
MUS_API mus_status mus_joint_limits(int32_t joint, int32_t axis, double *low, double *high);

/** Check that all angles of a pose are within the limits of their joints. Errors: MUS_ERR_ARG (also a number that is
 * not finite), MUS_ERR_VERSION, MUS_ERR_BODY (an angle beyond a limit; the message names joint, angle and limits). */
MUS_API mus_status mus_pose_check(mus_context *context, const mus_pose *pose);

/** Number of named poses. */
MUS_API int32_t mus_pose_count(void);

/** Name of a named pose ("sit"); NULL for an index outside 0 to mus_pose_count() - 1. Static text. */
MUS_API const char *mus_pose_name(int32_t pose);

/** Get a named pose, with the place 0. mus_body_clear_arms() and mus_body_stand() fit it to a body.
 * Errors: MUS_ERR_ARG (unknown name). */
MUS_API mus_status mus_pose_named(mus_context *context, const char *name, mus_pose *out);

/** Feet that stand in a named pose: a sum of MUS_FOOT_LEFT and MUS_FOOT_RIGHT. 0: none (a person who kneels), or the
 * name is unknown or NULL. */
MUS_API int32_t mus_pose_feet(const char *name);

/**
 * Make a posed copy of a body.
 *
 * Skin, landmarks, contour points and depth of the copy are those of the pose; asked and made measures and the volume
 * are those of the rest pose. A pose is always taken from the body as made, so posing a posed body does not add up.
 *
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_BODY (an angle beyond the limits of its joint, or the
 *          angle of a limb that a scan does not have). *out is then NULL
 * Cost:    as mus_body_create()
 */
MUS_API mus_status mus_body_pose(const mus_body *body, const mus_pose *pose, mus_body **out);

/** Get the pose that a body was made in: the arms at the tape's arm angle, or as in the scan. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_body_rest_pose(const mus_body *body, mus_pose *pose);

/** Get the pose that a body stands in: that of mus_body_pose(), or the rest pose. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_body_stance(const mus_body *body, mus_pose *pose);

/** Change the height of a pose's place so that the lowest point of the body is on the floor (Y = 0).
 * Errors: as mus_body_pose(). Cost: 1 ms. */
MUS_API mus_status mus_body_ground(const mus_body *body, mus_pose *pose);

/**
 * Put the standing feet of a pose on the floor (Y = 0), each with its lowest point.
 *
 * The root gets the height at which the changes of both legs are alike, or the nearest one where both reach. Then hip,
 * knee and ankle of a leg whose foot would float or sink are flexed so that the ankle moves straight up or down. The
 * foot keeps its inclination until the ankle is at its limit. A foot that does not stand is lifted only where it would
 * be below the floor. A foot that the body lacks does not stand; without standing feet the call is mus_body_ground().
 *
 * Errors:  as mus_body_pose(); MUS_ERR_ARG (feet is no such sum); MUS_ERR_BODY also where the limits of hips and knees
 *          keep a foot off the floor. The pose is then left as it was
 * Accuracy: the lowest vertex of mus_body_vertices() is within 0.01 mm of the floor
 * Cost:    about 5 ms on a skin of 60,000 vertices
 */
MUS_API mus_status mus_body_stand(const mus_body *body, int32_t feet, mus_pose *pose);

/**
 * Abduct the arms of a pose until they keep a distance of `gap` from the rest of the body.
 *
 * Raises each arm by steps of one degree, at most 60, or lowers an arm that the pose has above the horizontal, whose
 * way off the head that is, and looks at the arm from below the armpit to the finger tips. An arm that keeps the
 * distance already stays as it is.
 *
 * Units:   gap [m], 0 to 0.04
 * Errors:  as mus_body_pose()
 * Cost:    about 1 ms for each step
 */
MUS_API mus_status mus_body_clear_arms(const mus_body *body, mus_pose *pose, double gap);

/** A movement: poses at times, with cubic splines between them. */
typedef struct mus_move mus_move;

/**
 * Make a movement from poses at times (its keys).
 *
 * Place and angles run each on a cubic spline through the keys. With period 0 the movement ends: the splines are
 * natural, and before the first and after the last key that pose is held. A period is the time after which the first
 * key comes again: the splines are periodic, and at least 3 keys are needed.
 *
 * Shapes:  times (keys), ascending; poses (keys); 1 to 10,000 keys, copied
 * Units:   times, period [s]
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_BODY (a pose beyond the limits of a joint)
 */
MUS_API mus_status mus_move_create(mus_context *context, int32_t keys, const double *times, const mus_pose *poses,
                                   double period, mus_move **out);
/** Free a movement; NULL is accepted. */
MUS_API void mus_move_destroy(mus_move *move);

/** Number of named movements. */
MUS_API int32_t mus_move_count(void);

/** Name of a named movement ("walk"); NULL for an index outside 0 to mus_move_count() - 1. Static text. */
MUS_API const char *mus_move_name(int32_t move);

/** Make a named movement for a person of a stature [m], 0.2 to 3, whose legs have the mean proportions.
 * Errors: MUS_ERR_ARG (also an unknown name), MUS_ERR_MEMORY. */
MUS_API mus_status mus_move_named(mus_context *context, const char *name, double stature, mus_move **out);

/**
 * Make a named movement fitted to a body.
 *
 * At each key and half way between two keys, mus_body_stand() puts the standing feet on the floor and
 * mus_body_clear_arms() keeps the arms `gap` off the sides. A foot stands half way when it stands at both keys.
 *
 * Units:   gap [m], 0 to 0.04
 * Errors:  as mus_body_pose(); MUS_ERR_ARG (unknown name, or a body of given limbs)
 * Cost:    about 100 ms
 */
MUS_API mus_status mus_body_move(const mus_body *body, const char *name, double gap, mus_move **out);

/** Period of a movement [s]; 0 for a movement that ends, NaN for NULL. */
MUS_API double mus_move_period(const mus_move *move);

/** Time from the first to the last key of a movement [s], of a periodic one its period; NaN for NULL. */
MUS_API double mus_move_duration(const mus_move *move);

/** Get the pose of a movement at time `t` [s]. An angle that its spline would carry past a limit of its joint is set to
 * the limit. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_move_at(const mus_move *move, double t, mus_pose *pose);

#ifdef __cplusplus
}
#endif

#endif
