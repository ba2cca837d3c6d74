/* test_pose_frame.c: frames of parts: the rest pose is the identity, frames are rotations, blends meet their ends. */
#include <math.h>

#include "body/body_internal.h"
#include "body/people.h"
#include "geom/vec.h"
#include "pose/pose_frame.h"

Suite *mus_suite_pose_frame(void);


START_TEST(the_rest_pose_is_the_identity)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M50", NULL);
    mus_pose pose;
    mus__joint_local local[MUS_JOINT_COUNT];
    mus__frame frame[MUS__PARTS_MOST];
    ck_assert_int_eq(mus_body_rest_pose(body, &pose), MUS_OK);
    ck_assert_int_eq(mus_pose_check(context, &pose), MUS_OK);
    ck_assert_int_eq(mus__pose_locals(context, &body->rig, &pose, local), MUS_OK);
    mus__pose_frames(&body->rig, local, frame);
    for (int32_t p = 0; p < body->rig.parts; p++)
        for (int i = 0; i < 9; i++) {
            ck_assert_double_eq_tol(frame[p].turn[i], i % 4 == 0 ? 1.0 : 0.0, 1e-15);
            ck_assert_double_eq_tol(frame[p].place[i % 3], 0.0, 1e-15);
        }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* turn^T turn = 1 and det = 1 */
static void check_rotation(const mus__frame *frame)
{
    const double *m = frame->turn;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(m[i] * m[k] + m[3 + i] * m[3 + k] + m[6 + i] * m[6 + k], i == k ? 1.0 : 0.0, 1e-14);
    double cross[3];
    mus__cross3(m, m + 3, cross);
    ck_assert_double_eq_tol(mus__dot3(cross, m + 6), 1.0, 1e-14);
}


static void random_locals(mus_context *context, const mus__rig *rig, uint64_t *seed, mus__joint_local *out)
{
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    for (int i = 0; i < 3; i++) pose.place[i] = support_uniform(seed, -1.0, 1.0);
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        for (int32_t k = 0; k < 3; k++) {
            double low, high;
            ck_assert_int_eq(mus_joint_limits(j, k, &low, &high), MUS_OK);
            pose.angle[j][k] = support_uniform(seed, low, high);
        }
    ck_assert_int_eq(mus__pose_locals(context, rig, &pose, out), MUS_OK);
}


/* frames and rings are rotations; two parts meet at their joint; a blend is a rotation too and meets its ends */
START_TEST(frames_are_rotations_that_meet_at_the_joints)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    const mus__rig *rig = &body->rig;
    uint64_t seed = 31;
    for (int round = 0; round < 300; round++) {
        mus__joint_local a[MUS_JOINT_COUNT], b[MUS_JOINT_COUNT], c[MUS_JOINT_COUNT];
        mus__frame frame[MUS__PARTS_MOST], ring;
        random_locals(context, rig, &seed, a);
        random_locals(context, rig, &seed, b);
        mus__pose_blend(a, b, support_uniform(&seed, 0.0, 1.0), c);
        mus__pose_frames(rig, round % 2 ? a : c, frame);
        for (int32_t p = 0; p < rig->parts; p++) {
            check_rotation(&frame[p]);
            for (int32_t q = 0; q < rig->parts; q++) {
                if (rig->parent[rig->part[p].joint] != rig->part[q].joint) continue;
                if (rig->part[p].limb != rig->part[q].limb) continue;
                double x[3], y[3];
                mus__frame_point(&frame[p], rig->pivot[rig->part[p].joint], x);
                mus__frame_point(&frame[q], rig->pivot[rig->part[p].joint], y);
                for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(x[i], y[i], 1e-14);
            }
        }
        for (int32_t l = 0; l < body->limb_count; l++)
            for (int k = 0; k <= 40; k++) {
                const double low = body->limb[l].pole[0], high = body->limb[l].pole[1];
                mus__rig_ring(rig, frame, l, low + (high - low) * k / 40.0, &ring);
                check_rotation(&ring);
            }

        /* t = 0 and 1 */
        mus__pose_blend(a, b, 0.0, c);
        for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
            for (int i = 0; i < 4; i++) {
                ck_assert_double_eq_tol(c[j].quaternion[i], a[j].quaternion[i], 1e-15);
                ck_assert_double_eq_tol(c[j].shift[i % 3], a[j].shift[i % 3], 1e-15);
            }
        mus__frame end[MUS__PARTS_MOST];
        mus__pose_blend(a, b, 1.0, c);
        mus__pose_frames(rig, c, frame);
        mus__pose_frames(rig, b, end);
        for (int32_t p = 0; p < rig->parts; p++)
            for (int i = 0; i < 9; i++) {
                ck_assert_double_eq_tol(frame[p].turn[i], end[p].turn[i], 1e-14);
                ck_assert_double_eq_tol(frame[p].place[i % 3], end[p].place[i % 3], 1e-14);
            }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_pose_frame(void)
{
    Suite *suite = suite_create("pose_frame");
    TCase *tests = tcase_create("pose_frame");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, the_rest_pose_is_the_identity);
    tcase_add_test(tests, frames_are_rotations_that_meet_at_the_joints);
    suite_add_tcase(suite, tests);
    return suite;
}
