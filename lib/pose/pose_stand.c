/*
 * pose_stand.c: a pose on the floor: the lowest point of a body, and legs bent so that both feet stand.
 *
 * mus_body_ground() takes the lowest point of the radius fields, carried by the frames of their parts, without a posed
 * copy. A foot stands with the lowest vertex of its published skin, which has a heel and toes that the field lacks; the
 * vertices of a foot are those near its field, and move with its part.
 *
 * The root gets the mean height of the feet that stand; then each leg moves its ankle straight up or down until the
 * foot is on the floor. The leg turns in its own plane: the distance from hip to ankle gives the knee by the law of
 * cosines, the direction gives the hip, and the ankle keeps the inclination of the foot. A secant iteration on the way
 * of the ankle takes up what abduction and the limit of the ankle leave. Where a leg cannot reach, the height of the
 * root is halved towards the foot that it is too short or too long for.
 */
#include "pose/pose_stand.h"

#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "pose/pose_frame.h"

#define STAND_NEAR 1e-5  /* [m] a foot this near the floor stands; chosen: the bits of flat feet are kept */
#define STAND_SKIN 0.01  /* [m] vertices of a foot are this near its field; chosen: toes and heel are within 4 mm */
#define STAND_SECANTS 30 /* most iterations of a leg; four are usual */
#define STAND_HEIGHTS 12 /* most heights of the root that are tried; chosen: the last two differ by 1/2000 */
#define STAND_TURNS 8    /* iterations of the knee on the sideways part of the leg, which it hardly changes */

/* a foot of a body: the part of the rig, MUS_NONE: the body lacks it; and the skin's vertices in the rest pose */
typedef struct stand_foot {
    int32_t part, count;
    double *point; /* (count x 3) [m] */
} stand_foot;

/* one leg of a body in a pose; vectors along the root's axes [m] */
typedef struct stand_leg {
    int32_t right;
    double thigh[3], shank[3]; /* from hip to knee and from knee to ankle, in the rest pose */
    double twist[9];           /* abduction and rotation of the hip */
    double ankle[2], up[2];    /* upward and forward: the way from hip to ankle in the pose, and the vertical */
} stand_leg;


/* frames (parts) of the parts of a body in a pose. Errors: those of mus_pose_check() and mus__pose_locals() */
static mus_status stand_frames(const mus_body *body, const mus_pose *pose, mus__frame *out)
{
    mus__joint_local local[MUS_JOINT_COUNT];
    mus_status status = mus_pose_check(body->context, pose);
    if (status == MUS_OK) status = mus__pose_locals(body->context, &body->rig, pose, local);
    if (status == MUS_OK) mus__pose_frames(&body->rig, local, out);
    return status;
}


mus_status mus__pose_fields(const mus_body *body, const mus_pose *pose, mus__field *out)
{
    mus__frame frame[MUS__PARTS_MOST];
    mus_status status = stand_frames(body, pose, frame);
    for (int32_t p = 0; p < body->nfield && status == MUS_OK; p++) {
        const mus__limb *limb = &body->limb[body->rig.part[p].limb];
        out[p] = body->field[p];
        mus__part_carry(limb, &frame[p], &out[p]);
    }
    return status;
}


void mus__field_point(const mus__field *field, double a, double b, double s, double *out)
{
    for (int i = 0; i < 3; i++)
        out[i] = field->origin[i] + a * field->side[i] + b * field->front[i] + s * field->axis[i];
}


/* height of the lowest point of a field's rings and poles [m] */
static double stand_lowest_field(const mus__field *field, const double *turn)
{
    double lowest = INFINITY, x[3];
    for (int32_t j = 0; j < field->nring; j++) {
        const double *c = field->centre + 2 * (ptrdiff_t)j, *r = field->radius + (ptrdiff_t)j * field->nangle;
        mus__field_point(field, c[0], c[1], field->s0 + j * field->ds, x);
        for (int32_t k = 0; k < field->nangle; k++)
            lowest = fmin(lowest, x[1] + r[k] * (turn[2 * k] * field->side[1] + turn[2 * k + 1] * field->front[1]));
    }
    for (int end = 0; end < 2; end++) {
        const double *c = field->centre + 2 * (ptrdiff_t)(end == 0 ? 0 : field->nring - 1);
        mus__field_point(field, c[0], c[1], field->pole[end], x);
        lowest = fmin(lowest, x[1]);
    }
    return lowest;
}


mus_status mus_body_ground(const mus_body *body, mus_pose *pose)
{
    if (body == NULL) return MUS_ERR_ARG;
    mus__field field[MUS__PARTS_MOST];
    mus_status status = mus__pose_fields(body, pose, field);
    if (status != MUS_OK) return status;

    double turn[2 * MUS__FIELD_MOST], lowest = INFINITY;
    for (int32_t p = 0; p < body->nfield; p++) {
        mus__field_turns(field[p].nangle, turn);
        lowest = fmin(lowest, stand_lowest_field(&field[p], turn));
    }
    pose->place[1] -= lowest;
    return MUS_OK;
}


/* ---- feet ---- */

/* whether a point (3) is within STAND_SKIN of a field */
static bool stand_is_near(const mus__field *field, const double *x)
{
    double way[3], normal[3];
    for (int i = 0; i < 3; i++) way[i] = x[i] - field->origin[i];
    const double s = mus__dot3(way, field->axis), reach = field->reach + STAND_SKIN;
    if (s < field->pole[0] - STAND_SKIN || s > field->pole[1] + STAND_SKIN) return false;
    if (mus__dot3(way, way) - s * s > reach * reach) return false;
    return mus__field_depth(field, x, normal) > -STAND_SKIN;
}


/* the foot of a side, whose points the caller frees. Errors: MUS_ERR_MEMORY */
static mus_status stand_foot_of(const mus_body *body, int32_t right, stand_foot *out)
{
    *out = (stand_foot){MUS_NONE, 0, NULL};
    for (int32_t p = 0; p < body->rig.parts && body->jointed; p++)
        if (body->rig.part[p].joint == MUS_JOINT_ANKLE_LEFT + right && out->part == MUS_NONE) out->part = p;
    if (out->part == MUS_NONE || body->rig.missing[MUS_JOINT_HIP_LEFT + right]) return MUS_OK;

    const double *x = mus_body_vertices(body);
    const int32_t n = mus_body_vertex_count(body);
    out->point = mus__new(body->context, 3 * (int64_t)n, sizeof(double));
    if (out->point == NULL) return mus__fail_memory(body->context, "the vertices of a foot");
    for (int32_t v = 0; v < n; v++, x += 3) {
        if (!stand_is_near(&body->field[out->part], x)) continue;
        double *to = out->point + 3 * (ptrdiff_t)out->count++;
        if (body->frame != NULL)
            mus__frame_back(&body->frame[out->part], x, to);
        else
            memcpy(to, x, 3 * sizeof *to);
    }
    return MUS_OK;
}


/* height of the lowest vertex of a foot in a pose of its body [m]; infinity for a foot that the body lacks */
static double stand_lowest(const mus_body *body, const stand_foot *foot, const mus_pose *pose)
{
    mus__frame frame[MUS__PARTS_MOST];
    double lowest = INFINITY;
    if (foot->count == 0 || stand_frames(body, pose, frame) != MUS_OK) return lowest;
    const double *up = frame[foot->part].turn + 3;
    for (int32_t i = 0; i < foot->count; i++) lowest = fmin(lowest, mus__dot3(up, foot->point + 3 * (ptrdiff_t)i));
    return lowest + frame[foot->part].place[1];
}


/* ---- legs ---- */

/* the way (3) from hip to ankle with the knee flexed by `knee` and the hip not flexed */
static void stand_reach(const stand_leg *leg, double knee, double *out)
{
    const double c = mus__cos(knee), s = mus__sin(knee), *t = leg->thigh, *b = leg->shank;
    const double way[3] = {t[0] + b[0], t[1] + c * b[1] - s * b[2], t[2] + s * b[1] + c * b[2]};
    mus__matrix_point(leg->twist, way, out);
}


/* the leg of a side in a pose */
static void stand_leg_of(const mus_body *body, const mus_pose *pose, int32_t right, stand_leg *out)
{
    const double *hip = pose->angle[MUS_JOINT_HIP_LEFT + right], (*pivot)[3] = body->rig.pivot;
    double q[4], root[9], way[3];
    out->right = right;
    for (int i = 0; i < 3; i++) {
        out->thigh[i] = pivot[MUS_JOINT_KNEE_LEFT + right][i] - pivot[MUS_JOINT_HIP_LEFT + right][i];
        out->shank[i] = pivot[MUS_JOINT_ANKLE_LEFT + right][i] - pivot[MUS_JOINT_KNEE_LEFT + right][i];
    }
    mus__joint_turn(MUS_JOINT_HIP_LEFT + right, (double[3]){0.0, hip[MUS_POSE_ABDUCTION], hip[MUS_POSE_ROTATION]}, q);
    mus__quaternion_matrix(q, out->twist);
    mus__joint_turn(MUS_JOINT_ROOT, pose->angle[MUS_JOINT_ROOT], q);
    mus__quaternion_matrix(q, root);
    out->up[0] = root[4], out->up[1] = root[5];

    stand_reach(out, pose->angle[MUS_JOINT_KNEE_LEFT + right][MUS_POSE_FLEXION], way);
    const double c = mus__cos(hip[MUS_POSE_FLEXION]), s = mus__sin(hip[MUS_POSE_FLEXION]);
    out->ankle[0] = c * way[1] + s * way[2], out->ankle[1] = c * way[2] - s * way[1];
}


/* whether a flexion is within the limits of its joint, beyond which rounding is cut off */
static bool stand_limit(int32_t joint, double *flexion)
{
    double low, high;
    mus_joint_limits(joint, MUS_POSE_FLEXION, &low, &high);
    const bool within = *flexion >= low - 1e-9 && *flexion <= high + 1e-9;
    *flexion = fmin(fmax(*flexion, low), high);
    return within;
}


/* flex hip, knee and ankle of a leg of `pose` in `out` so that the ankle is `rise` [m] higher; false: beyond a limit of
 * hip or knee. An ankle at its limit changes the inclination of the foot */
static bool stand_bend(const stand_leg *leg, const mus_pose *pose, double rise, mus_pose *out)
{
    const double *t = leg->thigh, *b = leg->shank;
    const double up = leg->ankle[0] + rise * leg->up[0], front = leg->ankle[1] + rise * leg->up[1];
    const int32_t joint[3] = {MUS_JOINT_HIP_LEFT + leg->right, MUS_JOINT_KNEE_LEFT + leg->right,
                              MUS_JOINT_ANKLE_LEFT + leg->right};
    double was[3], now[3], way[3];
    for (int i = 0; i < 3; i++) was[i] = pose->angle[joint[i]][MUS_POSE_FLEXION];

    /* |thigh + shank|^2 = one + 2 most cos(knee - straight) */
    const double one = mus__dot3(t, t) + mus__dot3(b, b) + 2.0 * t[0] * b[0];
    const double p = t[1] * b[1] + t[2] * b[2], q = t[2] * b[1] - t[1] * b[2], most = sqrt(p * p + q * q);
    bool reaches = true;
    stand_reach(leg, was[1], way);
    for (int i = 0; i < STAND_TURNS; i++) {
        const double bend = (up * up + front * front + way[0] * way[0] - one) / (2.0 * most);
        reaches = bend >= -1.0 && bend <= 1.0;
        now[1] = mus__atan2(q, p) + mus__acos(fmin(fmax(bend, -1.0), 1.0));
        stand_reach(leg, now[1], way);
    }
    now[0] = mus__atan2(way[2], way[1]) - mus__atan2(front, up);
    if (now[0] > MUS_PI) now[0] -= 2.0 * MUS_PI;
    if (now[0] < -MUS_PI) now[0] += 2.0 * MUS_PI;
    now[2] = was[2] + (now[1] - was[1]) - (now[0] - was[0]);
    reaches = stand_limit(joint[0], &now[0]) && reaches;
    reaches = stand_limit(joint[1], &now[1]) && reaches;
    stand_limit(joint[2], &now[2]);
    for (int i = 0; i < 3; i++) out->angle[joint[i]][MUS_POSE_FLEXION] = now[i];
    return reaches;
}


/* bend a leg of `pose`, whose foot is `off` [m] above the floor, until the foot stands; false: it cannot */
static bool stand_on(const mus_body *body, const stand_foot *foot, int32_t right, double off, mus_pose *pose)
{
    const mus_pose from = *pose;
    stand_leg leg;
    stand_leg_of(body, &from, right, &leg);
    double last = 0.0, rise = -off;
    for (int i = 0; i < STAND_SECANTS; i++) {
        if (!stand_bend(&leg, &from, rise, pose)) return false;
        const double now = stand_lowest(body, foot, pose);
        if (fabs(now) <= STAND_NEAR) return true;
        if (now == off) return false;
        const double next = rise - now * (rise - last) / (now - off);
        last = rise, rise = next, off = now;
    }
    return false;
}


/* put the feet (2), of which those in `feet` stand, on the floor in a pose whose lowest point is there */
static mus_status stand_both(const mus_body *body, const stand_foot *foot, int32_t feet, mus_pose *pose)
{
    double off[2], low = INFINITY, high = -INFINITY;
    for (int32_t f = 0; f < 2; f++) {
        off[f] = stand_lowest(body, &foot[f], pose);
        if ((feet & MUS_FOOT_LEFT << f) != 0) low = fmin(low, off[f]), high = fmax(high, off[f]);
    }
    double floor = high - low > STAND_NEAR ? 0.5 * (low + high) : fabs(low) > STAND_NEAR ? low : 0.0;
    for (int32_t i = 0; i < STAND_HEIGHTS; i++) {
        mus_pose stood = *pose;
        bool is_short = false, is_long = false;
        stood.place[1] -= floor;
        for (int32_t f = 0; f < 2; f++) {
            const double above = off[f] - floor;
            const bool stays = fabs(above) <= STAND_NEAR || ((feet & MUS_FOOT_LEFT << f) == 0 && above > 0.0);
            if (stays || stand_on(body, &foot[f], f, above, &stood)) continue;
            if (above > 0.0) is_short = true;
            else is_long = true;
        }
        if (!is_short && !is_long) {
            *pose = stood;
            return MUS_OK;
        }
        if (is_short == is_long || !(high > low)) break;
        if (is_short) low = floor;
        else high = floor;
        floor = 0.5 * (low + high);
    }
    const double apart = 1e3 * fabs(off[0] - off[1]);
    if (feet != (MUS_FOOT_LEFT | MUS_FOOT_RIGHT))
        return mus__fail(body->context, MUS_ERR_BODY,
                         "the %s foot, which does not stand, stays below the floor: it is %.0f mm below the other in "
                         "the pose, more than the limits of hip and knee allow the leg to bend",
                         feet == MUS_FOOT_LEFT ? "right" : "left", apart);
    return mus__fail(body->context, MUS_ERR_BODY,
                     "the feet do not reach the floor together: one is %.0f mm above the other in the pose, more than "
                     "the limits of hips and knees allow the legs to make up",
                     apart);
}


mus_status mus_body_stand(const mus_body *body, int32_t feet, mus_pose *pose)
{
    if (body == NULL) return MUS_ERR_ARG;
    if ((feet & ~(MUS_FOOT_LEFT | MUS_FOOT_RIGHT)) != 0)
        return mus__fail(body->context, MUS_ERR_ARG, "feet %d is no sum of MUS_FOOT_LEFT and MUS_FOOT_RIGHT",
                         (int)feet);
    stand_foot foot[2] = {{MUS_NONE, 0, NULL}, {MUS_NONE, 0, NULL}};
    mus_pose stood = {0};
    if (pose != NULL) stood = *pose;
    mus_status status = mus_body_ground(body, pose != NULL ? &stood : NULL);
    for (int32_t f = 0; f < 2 && status == MUS_OK && feet != 0; f++) status = stand_foot_of(body, f, &foot[f]);
    for (int32_t f = 0; f < 2; f++)
        if (foot[f].count == 0) feet &= ~(MUS_FOOT_LEFT << f);
    if (status == MUS_OK && feet != 0) status = stand_both(body, foot, feet, &stood);
    for (int32_t f = 0; f < 2; f++) mus__free(body->context, foot[f].point);
    if (status == MUS_OK) *pose = stood;
    return status;
}
