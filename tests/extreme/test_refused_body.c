/*
 * test_refused_body.c: numbers that are not finite at the doors of tape and body: refused by name,
 * and the object is as it was. NaN unsets a measure: that is its meaning there.
 */
#include "muslin/body.h"
#include "muslin/pose.h"
#include "refused.h"

Suite *mus_suite_refused_body(void);

/* mus_tape_set */


/* each measure of a complete tape */
START_TEST(an_infinite_measure_leaves_the_tape_as_it_was)
{
    mus_context *context = support_context();
    mus_tape *tape, *before;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_tape_copy(tape, &before), MUS_OK);
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++)
        for (int32_t v = 1; v < 3; v++)
            for (int32_t source = MUS_SOURCE_GIVEN; source <= MUS_SOURCE_DERIVED; source++) {
                ck_assert_int_eq(mus_tape_set(tape, m, refused_values[v], source), MUS_ERR_ARG);
                ck_assert_msg(strstr(mus_context_error(context), mus_measure_name(m)) != NULL, "%s",
                              mus_context_error(context));
            }

    /* zero, negative and denormal lengths too */
    const double none[] = {0.0, -0.0, -1.0, 1e-310, 1e300};
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++)
        for (size_t v = 0; v < sizeof none / sizeof *none; v++)
            ck_assert_int_eq(mus_tape_set(tape, m, none[v], MUS_SOURCE_GIVEN), MUS_ERR_TAPE);
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
        const double value[2] = {mus_tape_value(tape, m), mus_tape_value(before, m)};
        ck_assert(value[0] == value[1] || (isnan(value[0]) && isnan(value[1])));
        ck_assert_int_eq(mus_tape_source(tape, m), mus_tape_source(before, m));
    }
    ck_assert_int_ne(mus_tape_is_complete(tape), 0);
    mus_tape_destroy(tape);
    mus_tape_destroy(before);
    support_context_end(context);
}
END_TEST


static mus_status try_body(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_tape *tape;
    mus_body *body;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    const mus_status status = mus_body_create(context, tape, def, &body);
    ck_assert_int_eq(status == MUS_OK, body != NULL);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status;
}


START_TEST(a_body_def_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_body_def, ring_spacing, 1, false, "ring_spacing"),
        REFUSED(mus_body_def, stoop, 1, false, "stoop"),
        REFUSED(mus_body_def, head_forward, 1, false, "head_forward"),
        REFUSED(mus_body_def, sway, 1, false, "sway"),
    };
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = 16;
    def.ring_spacing = 0.05;
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_body, NULL);
}
END_TEST


static mus_status try_limb(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_body *body;
    const mus_status status = mus_body_create_limbs(context, 1, def, NULL, &body);
    ck_assert_int_eq(status == MUS_OK, body != NULL);
    mus_body_destroy(body);
    return status;
}


/* mus_limb.contour: each number of each row */
START_TEST(a_limb_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_limb, origin, 3, false, "origin"),
        REFUSED(mus_limb, axis, 3, false, "axis"),
        REFUSED(mus_limb, side, 3, false, "side"),
        REFUSED(mus_limb, pole, 2, false, "pole"),
    };
    double rows[12] = {0.0, 0.0, 0.0, 0.1, 0.1, 2.0, 0.5, 0.0, 0.0, 0.1, 0.1, 2.0};
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    limb.pole[0] = -0.1, limb.pole[1] = 0.6;
    limb.contours = 2;
    limb.contour = rows;
    refused_fields(fields, sizeof fields / sizeof *fields, &limb, sizeof limb, try_limb, NULL);

    mus_context *context = support_context();
    for (int i = 0; i < 12; i++)
        for (int v = 0; v < 3; v++) {
            const double good = rows[i];
            rows[i] = refused_values[v];
            ck_assert_int_eq(try_limb(context, &limb, NULL), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "contour"));
            rows[i] = good;
        }
    support_context_end(context);
}
END_TEST


/* mus_limb.outline: each number of each corner */
START_TEST(an_outline_that_is_not_finite_is_refused_by_name)
{
    const double rows[12] = {0.0, 0.0, 0.0, NAN, NAN, NAN, 0.5, 0.0, 0.0, NAN, NAN, NAN};
    double outline[12] = {0.1, 0.0, -0.1, 0.1, -0.1, -0.1, 0.1, 0.0, -0.1, 0.1, -0.1, -0.1};
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    limb.pole[0] = -0.1, limb.pole[1] = 0.6;
    limb.contours = 2;
    limb.contour = rows;
    limb.corners = 3;
    limb.outline = outline;
    mus_context *context = support_context();
    ck_assert_int_eq(try_limb(context, &limb, NULL), MUS_OK);
    for (int i = 0; i < 12; i++)
        for (int v = 0; v < 3; v++) {
            const double good = outline[i];
            outline[i] = refused_values[v];
            ck_assert_int_eq(try_limb(context, &limb, NULL), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "contour"));
            outline[i] = good;
        }
    support_context_end(context);
}
END_TEST


/* a question, not a setter: a point that is nowhere is out of reach of every limb, and no memory is touched */
/* mus_body_depth */
START_TEST(the_depth_of_a_point_that_is_not_finite_is_out_of_reach)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *body;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    const double far[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e18, -1e18};
    for (size_t v = 0; v < sizeof far / sizeof *far; v++)
        for (int32_t mask = 1; mask < 8; mask++) {
            double point[3] = {0.0, 1.1, 0.0}, depth = 0.0, normal[3];
            for (int32_t d = 0; d < 3; d++)
                if (mask >> d & 1) point[d] = far[v];
            ck_assert_int_eq(mus_body_depth(body, 1, point, &depth, normal), MUS_OK);
            ck_assert_msg(depth < 0.0, "a point at %g, %g, %g is %g m deep", point[0], point[1], point[2], depth);
            for (int32_t d = 0; d < 3; d++)
                ck_assert_msg(isfinite(normal[d]), "%g, %g, %g", point[0], point[1], point[2]);
        }
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


static mus_status try_pose(mus_context *context, const void *def, void *user)
{
    (void)user;
    return mus_pose_check(context, def);
}


START_TEST(a_pose_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {REFUSED(mus_pose, place, 3, false, "mus_pose.place"),
                                           REFUSED(mus_pose, angle, 3 * MUS_JOINT_COUNT, false, "mus_pose.angle")};
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    refused_fields(fields, 2, &pose, sizeof pose, try_pose, NULL);
}
END_TEST


/* mus_move_create, mus_move_named, mus_move_at */
START_TEST(times_of_a_movement_that_are_not_finite_are_refused)
{
    mus_context *context = support_context();
    mus_move *move = NULL;
    mus_pose pose[3], out;
    for (int i = 0; i < 3; i++) mus_pose_init(&pose[i], sizeof pose[i]);
    for (int v = 0; v < 3; v++) {
        const double times[] = {0.0, refused_values[v], 2.0}, good[] = {0.0, 1.0, 2.0};
        ck_assert_int_eq(mus_move_create(context, 3, times, pose, 0.0, &move), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "time 1"));
        ck_assert_int_eq(mus_move_create(context, 3, good, pose, refused_values[v], &move), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "period"));
        ck_assert_int_eq(mus_move_named(context, "walk", refused_values[v], &move), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "stature"));
        ck_assert_ptr_null(move);
        ck_assert_int_eq(mus_move_create(context, 3, good, pose, 3.0, &move), MUS_OK);
        ck_assert_int_eq(mus_move_at(move, refused_values[v], &out), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "time"));
        mus_move_destroy(move);
        move = NULL;
    }
    support_context_end(context);
}
END_TEST


/* mus_body_clear_arms, mus_body_move */
START_TEST(a_gap_that_is_not_finite_is_refused)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *body;
    mus_pose pose, before;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus_body_rest_pose(body, &pose), MUS_OK);
    before = pose;
    for (int v = 0; v < 3; v++) {
        mus_move *move = NULL;
        ck_assert_int_eq(mus_body_clear_arms(body, &pose, refused_values[v]), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "gap"));
        ck_assert_int_eq(mus_body_move(body, "walk", refused_values[v], &move), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "gap"));
        ck_assert_ptr_null(move);
    }
    ck_assert_int_eq(memcmp(&pose, &before, sizeof pose), 0);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_body(void)
{
    Suite *suite = suite_create("refused_body");
    TCase *tests = tcase_create("refused_body");
    tcase_add_test(tests, an_infinite_measure_leaves_the_tape_as_it_was);
    tcase_add_test(tests, a_body_def_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, a_limb_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, an_outline_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, times_of_a_movement_that_are_not_finite_are_refused);
    tcase_add_test(tests, a_gap_that_is_not_finite_is_refused);
    tcase_add_test(tests, a_pose_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, the_depth_of_a_point_that_is_not_finite_is_out_of_reach);
    suite_add_tcase(suite, tests);
    return suite;
}
