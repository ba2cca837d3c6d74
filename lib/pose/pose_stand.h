/* pose_stand.h: the radius fields of a body in a pose, for what fits a pose to a body (pose_stand.c, pose_fit.c). */
#ifndef MUS_POSE_POSE_STAND_H
#define MUS_POSE_POSE_STAND_H

#include "body/body_internal.h"
#include "muslin/pose.h"

/* the radius fields (parts) of a body in a pose; they borrow the tables of the body's fields. Errors: those of
 * mus_pose_check() and mus__pose_locals() */
mus_status mus__pose_fields(const mus_body *body, const mus_pose *pose, mus__field *out);
/* the point (3) of a field at (a, b, s) */
void mus__field_point(const mus__field *field, double a, double b, double s, double *out);

#endif
