/* test_pose_stand.c: feet on the floor: lowest vertex of each standing foot on the published skin of a posed body */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "body/people.h"
#include "geom/vec.h"
#include "muslin/pose.h"

Suite *mus_suite_pose_stand(void);

#define DEGREE (MUS_PI / 180.0)
#define BOTH (MUS_FOOT_LEFT | MUS_FOOT_RIGHT)
#define ANKLE 0.04 /* height of a foot's vertices in the rest pose at most, in parts of the stature */


/* height [m] of the lowest vertex of a foot in a pose: of the vertices that are low in the rest pose on its side */
static double lowest(const mus_body *body, const mus_pose *pose, int32_t right)
{
    mus_body *copy = NULL;
    ck_assert_int_eq(mus_body_pose(body, pose, &copy), MUS_OK);
    const double *rest = mus_body_vertices(body), *x = mus_body_vertices(copy);
    double y = INFINITY;
    for (int32_t v = 0; v < 3 * mus_body_vertex_count(body); v += 3)
        if (rest[v + 1] < ANKLE * body->skeleton.crown && (rest[v] < 0.0) == (right != 0)) y = fmin(y, x[v + 1]);
    mus_body_destroy(copy);
    return y;
}


START_TEST(standing_feet_are_on_the_floor_in_named_poses)
{
    static const char *const sizes[] = {"W36", "M58", "C116"}, *const poses[] = {"lunge", "step", "squat", "knee_up"};
    mus_context *context = support_context();
    for (int i = 0; i < 3; i++) {
        const mus_body_def def = {.size = sizeof def, .samples = 32, .ring_spacing = 0.02};
        mus_body *body = people_body(context, sizes[i], &def);
        for (int q = 0; q < 4; q++) {
            mus_pose pose, named;
            ck_assert_int_eq(mus_pose_named(context, poses[q], &pose), MUS_OK);
            named = pose;
            ck_assert_int_eq(mus_body_stand(body, mus_pose_feet(poses[q]), &pose), MUS_OK);
            ck_assert_int_eq(mus_pose_check(context, &pose), MUS_OK);
            for (int32_t f = 0; f < 2; f++) {
                if ((mus_pose_feet(poses[q]) & MUS_FOOT_LEFT << f) == 0) continue;
                const double y = lowest(body, &pose, f);
                ck_assert_msg(fabs(y) < 1e-4, "%s %s: foot %d at %.2f mm", sizes[i], poses[q], (int)f, 1e3 * y);
            }

            /* the legs alone bend, and a leg that needs not, does not */
            const bool bends = q < 2;
            ck_assert_int_eq(memcmp(&named.angle, &pose.angle, sizeof pose.angle) != 0, bends);
            ck_assert_int_eq(memcmp(named.angle, pose.angle, MUS_JOINT_HIP_LEFT * sizeof *pose.angle), 0);

            /* the front foot of a lunge stays flat */
            if (q > 0) continue;
            const double(*a)[3] = pose.angle;
            const double tilt = a[MUS_JOINT_KNEE_LEFT][0] - a[MUS_JOINT_HIP_LEFT][0] - a[MUS_JOINT_ANKLE_LEFT][0];
            ck_assert_double_eq_tol(tilt, 0.0, 1e-9);
        }
        mus_body_destroy(body);
    }
    ck_assert_int_eq(mus_pose_feet("kneel"), 0);
    ck_assert_int_eq(mus_pose_feet("knee_up"), MUS_FOOT_RIGHT);
    ck_assert_int_eq(mus_pose_feet("sit"), BOTH);
    ck_assert_int_eq(mus_pose_feet("fly"), 0);
    ck_assert_int_eq(mus_pose_feet(NULL), 0);
    support_context_end(context);
}
END_TEST


/* a pelvis that drops to a side, knees apart; a posed body gives the same pose; a foot that does not stand is lifted */
START_TEST(a_users_pose_stands)
{
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 32, .ring_spacing = 0.02};
    mus_body *body = people_body(context, "W46", &def), *copy = NULL;
    mus_pose pose, again, low;
    mus_pose_init(&pose, sizeof pose);
    pose.angle[MUS_JOINT_ROOT][MUS_POSE_ABDUCTION] = 8.0 * DEGREE;
    pose.angle[MUS_JOINT_ROOT][MUS_POSE_ROTATION] = 20.0 * DEGREE;
    pose.angle[MUS_JOINT_HIP_LEFT][MUS_POSE_FLEXION] = 35.0 * DEGREE;
    pose.angle[MUS_JOINT_HIP_LEFT][MUS_POSE_ABDUCTION] = 12.0 * DEGREE;
    pose.angle[MUS_JOINT_HIP_LEFT][MUS_POSE_ROTATION] = -15.0 * DEGREE;
    pose.angle[MUS_JOINT_KNEE_LEFT][MUS_POSE_FLEXION] = 60.0 * DEGREE;
    pose.angle[MUS_JOINT_KNEE_RIGHT][MUS_POSE_FLEXION] = 5.0 * DEGREE;
    again = low = pose;
    ck_assert_int_eq(mus_body_stand(body, BOTH, &pose), MUS_OK);
    for (int32_t f = 0; f < 2; f++) ck_assert_double_lt(fabs(lowest(body, &pose, f)), 1e-4);

    ck_assert_int_eq(mus_body_pose(body, &pose, &copy), MUS_OK);
    ck_assert_int_eq(mus_body_stand(copy, BOTH, &again), MUS_OK);
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        ck_assert_double_eq_tol(again.angle[j][0], pose.angle[j][0], 1e-4);
    mus_body_destroy(copy);

    ck_assert_int_eq(mus_body_stand(body, MUS_FOOT_LEFT, &low), MUS_OK);
    ck_assert_double_lt(fabs(lowest(body, &low, 0)), 1e-4);
    ck_assert_double_lt(fabs(lowest(body, &low, 1)), 1e-4);
    ck_assert_double_gt(low.angle[MUS_JOINT_KNEE_RIGHT][0], 20.0 * DEGREE);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(feet_that_cannot_stand_are_refused_and_change_nothing)
{
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.1};
    mus_body *body = people_body(context, "W40", &def);
    mus_pose pose, was, ground;

    /* one leg stretched forwards at 90 degrees: no knee brings that foot down */
    mus_pose_init(&pose, sizeof pose);
    pose.angle[MUS_JOINT_HIP_LEFT][MUS_POSE_FLEXION] = 90.0 * DEGREE;
    was = pose;
    ck_assert_int_eq(mus_body_stand(body, BOTH, &pose), MUS_ERR_BODY);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "do not reach the floor together"));
    ck_assert_int_eq(memcmp(&was, &pose, sizeof pose), 0);
    ck_assert_int_eq(mus_body_stand(body, 4, &pose), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_stand(body, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_stand(NULL, BOTH, &pose), MUS_ERR_ARG);
    pose.angle[MUS_JOINT_KNEE_LEFT][MUS_POSE_FLEXION] = -1.0;
    ck_assert_int_eq(mus_body_stand(body, BOTH, &pose), MUS_ERR_BODY);

    /* without feet it is the lowest point of the body */
    pose = ground = was;
    ck_assert_int_eq(mus_body_stand(body, 0, &pose), MUS_OK);
    ck_assert_int_eq(mus_body_ground(body, &ground), MUS_OK);
    ck_assert_int_eq(memcmp(&ground, &pose, sizeof pose), 0);

    const size_t bytes = mus_context_bytes(context);
    support_fail_after(0, false);
    ck_assert_int_eq(mus_body_stand(body, BOTH, &pose), MUS_ERR_MEMORY);
    support_fail_never();
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_pose_stand(void)
{
    Suite *suite = suite_create("pose_stand");
    TCase *tests = tcase_create("pose_stand");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, standing_feet_are_on_the_floor_in_named_poses);
    tcase_add_test(tests, a_users_pose_stands);
    tcase_add_test(tests, feet_that_cannot_stand_are_refused_and_change_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
