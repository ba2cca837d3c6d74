/*
 * pose_fit.c: arms fitted to a body, and movements fitted to it, feet (pose_stand.c) and arms.
 *
 * The arms query the radius fields of the body, carried by the frames of their parts, without a posed copy. An arm is
 * abducted by steps of a degree, or adducted where it is raised above the horizontal, until all of it below the armpit
 * keeps its distance. The named poses have arms that are far enough off the sides for most people.
 */
#include <math.h>

#include "body/body_internal.h"
#include "geom/vec.h"
#include "pose/pose_stand.h"
#include "pose/pose_table.h"

#define FIT_STEP (MUS_PI / 180.0) /* [rad] step of an arm's abduction */
#define FIT_STEPS 60              /* most steps */
/* part of the arm's length below the armpit from which on it is checked; chosen: nearer the arm cannot leave the
 * side */
#define FIT_ARMPIT 0.40
/* [m] distance of the rings that are checked; chosen: a wider one could miss the nearest place by some mm */
#define FIT_RING 0.012
#define FIT_ANGLES 16 /* so many directions of a ring are checked; chosen: as FIT_RING */


/* largest depth [m] of the points of an arm below the armpit in the parts of other limbs */
static double fit_arm_depth(const mus_body *body, const mus__field *field, int32_t right)
{
    const mus__bones *bones = &body->bones;
    const int32_t arm = bones->limb[MUS__LIMB_ARM_LEFT + right];
    const double armpit = bones->shoulder[right] + FIT_ARMPIT * (bones->wrist[right] - bones->shoulder[right]);
    double deepest = -1e30, x[3], normal[3], turn[2 * MUS__FIELD_MOST];
    for (int32_t p = 0; p < body->nfield; p++) {
        const mus__field *own = &field[p];
        if (body->rig.part[p].limb != arm) continue;
        const int32_t step = (int32_t)fmax(1.0, FIT_RING / own->ds), skip = own->nangle / FIT_ANGLES;
        mus__field_turns(own->nangle, turn);
        for (int32_t j = 0; j < own->nring; j += step) {
            const double s = own->s0 + j * own->ds, *c = own->centre + 2 * (ptrdiff_t)j;
            if (s < armpit || (j >= own->fine[0] && j <= own->fine[1])) continue; /* a fillet touches the side */
            for (int32_t k = 0; k < own->nangle; k += skip) {
                const double r = own->radius[(ptrdiff_t)j * own->nangle + k];
                mus__field_point(own, c[0] + r * turn[2 * k], c[1] + r * turn[2 * k + 1], s, x);
                for (int32_t q = 0; q < body->nfield; q++)
                    if (body->rig.part[q].limb != arm) deepest = fmax(deepest, mus__field_depth(&field[q], x, normal));
            }
        }
    }
    return deepest;
}


mus_status mus_body_clear_arms(const mus_body *body, mus_pose *pose, double gap)
{
    if (body == NULL) return MUS_ERR_ARG;
    if (!(gap >= 0.0 && gap <= 0.04))
        return mus__fail(body->context, MUS_ERR_ARG, "gap %g m is outside 0 to 0.04 m", gap);
    mus__field field[MUS__PARTS_MOST];
    mus_status status = mus__pose_fields(body, pose, field);
    if (status != MUS_OK || !body->jointed) return status;

    for (int32_t right = 0; right < 2; right++) {
        if (body->bones.limb[MUS__LIMB_ARM_LEFT + right] == MUS_NONE) continue;
        double *lift = &pose->angle[MUS_JOINT_SHOULDER_LEFT + right][MUS_POSE_ABDUCTION], low, high;
        mus_joint_limits(MUS_JOINT_SHOULDER_LEFT + right, MUS_POSE_ABDUCTION, &low, &high);
        const double way = *lift > 0.5 * MUS_PI ? -FIT_STEP : FIT_STEP; /* a raised arm goes down, off the head */
        for (int32_t step = 0; step < FIT_STEPS && *lift + way <= high && *lift + way >= low; step++) {
            if (fit_arm_depth(body, field, right) <= -gap) break;
            *lift += way;
            mus__pose_fields(body, pose, field);
        }
    }
    return MUS_OK;
}


mus_status mus_body_move(const mus_body *body, const char *name, double gap, mus_move **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (body == NULL) return MUS_ERR_ARG;
    if (!body->jointed)
        return mus__fail(body->context, MUS_ERR_ARG,
                         "a body of given limbs has no joints: named movements need a body of a tape or a scan");
    int32_t move = mus__move_find(name);
    if (move == MUS_NONE)
        return mus__fail(body->context, MUS_ERR_ARG, "no movement is called \"%.60s\"", name != NULL ? name : "");

    /* the movement for the body's stature, with a key added half way between two */
    double times[2 * MUS__MOVE_KEYS], rough[MUS__MOVE_KEYS + 1], period;
    mus_pose poses[2 * MUS__MOVE_KEYS];
    mus_move *of_mean = NULL;
    const int32_t given = mus__move_keys(move, body->skeleton.crown, rough, poses, &period);
    mus_status status = mus_move_create(body->context, given, rough, poses, period, &of_mean);
    rough[given] = rough[0] + period;
    const int32_t keys = period > 0.0 ? 2 * given : 2 * given - 1;
    for (int32_t i = 0; i < keys && status == MUS_OK; i++) {
        times[i] = i % 2 == 0 ? rough[i / 2] : 0.5 * (rough[i / 2] + rough[i / 2 + 1]);
        status = mus_move_at(of_mean, times[i], &poses[i]);

        /* each key fitted to the body; a foot stands half way when it stands at both keys */
        if (status == MUS_OK) status = mus_body_clear_arms(body, &poses[i], gap);
        const int32_t next = (i + 1) / 2 % given, feet = mus__move_feet(move, i / 2) & mus__move_feet(move, next);
        if (status == MUS_OK) status = mus_body_stand(body, feet, &poses[i]);
    }
    mus_move_destroy(of_mean);
    return status == MUS_OK ? mus_move_create(body->context, keys, times, poses, period, out) : status;
}
