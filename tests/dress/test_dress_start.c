/*
 * test_dress_start.c: a start with raised arms is sewn round them, and settles where the body has its arms; a start
 * that is sewn beside the body waits, with the reason, and is not settled before it is asked to.
 */
#include <string.h>

#include "drape/worn.h"
#include "dress/dress_start.h"

#define SPACING 0.04 /* [m] coarse: the tests ask which way was taken, not how the cloth lies */


static mus__dress call_of(const worn *w)
{
    mus__dress call = {.context = w->context, .body = w->body};
    mus_dress_def_init(&call.def, sizeof call.def);
    mus_drape_def_init(&call.drape, sizeof call.drape);
    mus_dress_report_init(&call.report, sizeof call.report);
    call.def.spacing = SPACING;
    return call;
}


START_TEST(raised_arms_come_down_with_the_garment_on)
{
    worn w = worn_body("W40");
    worn_put_on_design(&w, "knit_jewel_long", NULL);
    mus__dress call = call_of(&w);
    mus__dress_start start = {.index = MUS_NONE};
    mus_pose pose, now;
    double shoulder[3], wrist[3];
    ck_assert_int_eq(mus__dress_raise(w.body, &pose, &start.raised), MUS_OK);
    mus_body_landmark(start.raised, MUS_LANDMARK_SHOULDER_LEFT, shoulder);
    mus_body_landmark(start.raised, MUS_LANDMARK_WRIST_LEFT, wrist);
    ck_assert_double_eq_tol(shoulder[1], wrist[1], 0.1);
    ck_assert_int_eq(mus_arrange_pattern(w.pattern, start.raised), MUS_OK);

    mus__dress_sew(&call, w.pattern, MUS_DRESS_PLACE_RAISED, false, &start);
    ck_assert_msg(start.status == MUS_OK && !start.waits, "%s", start.text);
    mus_pose_init(&now, sizeof now);
    mus_drape_body_pose(start.drape, &now);
    ck_assert_double_eq(now.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_ABDUCTION],
                        pose.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_ABDUCTION]);

    mus__dress_settle(&call, &start);
    ck_assert_msg(start.status == MUS_OK, "%s", start.text);
    mus_body_stance(w.body, &pose);
    mus_drape_body_pose(start.drape, &now);
    ck_assert_double_eq(now.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_ABDUCTION],
                        pose.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_ABDUCTION]);
    ck_assert_int_eq(call.report.starts, 1);
    ck_assert_int_eq(call.report.start_end[0], MUS_REASON_SETTLED);
    mus__dress_start_free(&start);
    worn_end(&w);
}
END_TEST


START_TEST(a_start_beside_the_body_waits)
{
    worn w = worn_body("W40");
    worn_put_on_design(&w, "tshirt", NULL);
    for (int32_t p = 0; p < mus_pattern_panel_count(w.pattern); p++) {
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        mus_pattern_placement(w.pattern, p, &place);
        place.origin[0] += 1.5;
        mus_pattern_set_placement(w.pattern, p, &place);
    }
    mus__dress call = call_of(&w);
    mus__dress_start start = {.index = MUS_NONE};
    mus__dress_sew(&call, w.pattern, MUS_DRESS_PLACE_PATTERN, false, &start);
    ck_assert_int_eq(start.waits, 1);
    ck_assert_int_eq(start.status, MUS_ERR_UNSETTLED);
    ck_assert_int_eq(start.reason.kind, MUS_REASON_NOT_WORN);
    ck_assert_str_eq(mus_context_error(w.context), start.reason.text);
    ck_assert_double_eq(call.report.settle_seconds, 0.0);
    ck_assert_int_eq(call.report.start_end[0], MUS_REASON_NOT_WORN);
    mus__dress_settle(&call, &start);
    ck_assert_int_eq(start.waits, 0);
    ck_assert_int_eq(start.status, MUS_ERR_UNSETTLED);
    ck_assert_double_gt(call.report.settle_seconds, 0.0);
    mus__dress_start_free(&start);
    worn_end(&w);
}
END_TEST


Suite *mus_suite_dress_start(void);


Suite *mus_suite_dress_start(void)
{
    Suite *suite = suite_create("dress_start");
    TCase *tests = tcase_create("dress_start");
    tcase_set_timeout(tests, 60.0);
    tcase_add_test(tests, raised_arms_come_down_with_the_garment_on);
    tcase_add_test(tests, a_start_beside_the_body_waits);
    suite_add_tcase(suite, tests);
    return suite;
}
