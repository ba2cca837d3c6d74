/*
 * test_refused_cloth.c: numbers that are not finite, and masses that are none, at every door of fabric, cloth and
 * drape: refused by name, and the state is as it was, to the bit.
 */
#include <stdlib.h>

#include "drape/scenes.h"
#include "refused.h"

Suite *mus_suite_refused_cloth(void);


static mus_status try_cloth(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth;
    const mus_status status = mus_cloth_create(context, pattern, def, &cloth);
    ck_assert_int_eq(status == MUS_OK, cloth != NULL);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    return status;
}


static mus_status try_fabric(mus_context *context, const void *fabric, void *user)
{
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = 0.02;
    def.fabric = fabric;
    return try_cloth(context, &def, user);
}


START_TEST(a_cloth_def_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_cloth_def, spacing, 1, false, "spacing"),
    };
    static const refused_field fabric_fields[] = {
        REFUSED(mus_fabric, weight, 1, false, "weight"),       REFUSED(mus_fabric, stretch, 2, false, "stretch"),
        REFUSED(mus_fabric, shear, 1, false, "shear"),         REFUSED(mus_fabric, bend, 3, false, "bend"),
        REFUSED(mus_fabric, damping, 1, false, "damping"),     REFUSED(mus_fabric, friction, 1, false, "friction"),
        REFUSED(mus_fabric, thickness, 1, false, "thickness"),
        REFUSED(mus_fabric, bend_hysteresis, 1, false, "bend hysteresis"),
        REFUSED(mus_fabric, contraction, 1, false, "contraction"),
    };
    mus_fabric jersey;
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = 0.02;
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_cloth, NULL);
    mus_fabric_init(&jersey, sizeof jersey);
    refused_fields(fabric_fields, sizeof fabric_fields / sizeof *fabric_fields, &jersey, sizeof jersey, try_fabric,
                   NULL);
}
END_TEST


/* one value at a time */
START_TEST(a_value_that_is_not_finite_is_refused_by_mus_fabric_set)
{
    mus_context *context = support_context();
    mus_fabric fabric, before;
    mus_fabric_init(&fabric, sizeof fabric);
    before = fabric;
    for (int32_t value = 0; value < mus_fabric_value_count(); value++)
        for (int v = 0; v < 3; v++) {
            ck_assert_int_eq(mus_fabric_set(context, &fabric, value, refused_values[v]), MUS_ERR_ARG);
            ck_assert_int_eq(memcmp(&fabric, &before, sizeof fabric), 0);
        }
    support_context_end(context);
}
END_TEST


/* a fabric that weighs nothing, less than nothing or a denormal has no mass to move */
START_TEST(a_fabric_without_weight_is_refused)
{
    mus_context *context = support_context();
    const double none[] = {0.0, -0.0, -0.15, 1e-310, 1e-200};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        mus_cloth_def def;
        mus_cloth_def_init(&def, sizeof def);
        mus_fabric cloth_fabric;
        mus_fabric_init(&cloth_fabric, sizeof cloth_fabric);
        def.fabric = &cloth_fabric;
        cloth_fabric.weight = none[i];
        ck_assert_int_eq(try_cloth(context, &def, NULL), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "weight"));
    }
    support_context_end(context);
}
END_TEST


static mus_status try_drape(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape;
    const mus_status status = mus_drape_create(context, cloth, NULL, def, &drape);
    ck_assert_int_eq(status == MUS_OK, drape != NULL);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    return status;
}


/* mus_drape_def.friction, mus_drape_def.self_friction: NaN is the fabric's, infinity sticks */
START_TEST(a_drape_def_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_drape_def, gravity, 3, false, "gravity"),
        REFUSED(mus_drape_def, collision_distance, 1, false, "collision_distance"),
        REFUSED(mus_drape_def, clearance, 1, false, "clearance"),
        REFUSED(mus_drape_def, drag, 1, false, "drag"),
        REFUSED(mus_drape_def, contact_ball, 1, false, "contact_ball"),
        REFUSED(mus_drape_def, thickness, 1, false, "thickness"),
        REFUSED(mus_drape_def, seam_pull, 1, false, "seam_pull"),
        REFUSED(mus_drape_def, sew_seconds, 1, false, "sew_seconds"),
        REFUSED(mus_drape_def, settle_seconds, 1, false, "settle_seconds"),
        REFUSED(mus_drape_def, settle_residual, 1, false, "settle_residual"),
        REFUSED(mus_drape_def, progress_seconds, 1, false, "progress_seconds"),
        REFUSED(mus_drape_def, contact_ball, 1, false, "contact_ball"),
    };
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_drape, NULL);

    mus_context *context = support_context();
    def.friction = -INFINITY;
    ck_assert_int_eq(try_drape(context, &def, NULL), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "friction"));
    def.friction = INFINITY;
    ck_assert_int_eq(try_drape(context, &def, NULL), MUS_OK);
    def.self_friction = -INFINITY;
    ck_assert_int_eq(try_drape(context, &def, NULL), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "self_friction"));
    def.self_friction = INFINITY;
    ck_assert_int_eq(try_drape(context, &def, NULL), MUS_OK);
    support_context_end(context);
}
END_TEST


/* a plane added to a drape of one panel */
static mus_status try_plane(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape), MUS_OK);
    const mus_status status = mus_drape_add_plane(drape, def, NULL);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    return status;
}


/* mus_drape_add_plane, mus_drape_move_plane */
START_TEST(a_plane_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_plane, point, 3, false, "point"),       REFUSED(mus_plane, normal, 3, false, "normal"),
        REFUSED(mus_plane, velocity, 3, false, "velocity"), REFUSED(mus_plane, spin, 1, false, "spin"),
        REFUSED(mus_plane, reach, 1, false, "reach"),
    };
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    refused_fields(fields, sizeof fields / sizeof *fields, &plane, sizeof plane, try_plane, NULL);

    mus_context *context = support_context();
    const double frictions[] = {NAN, -INFINITY, INFINITY}; /* mus_plane.friction */
    for (int k = 0; k < 3; k++) {
        plane.friction = frictions[k];
        ck_assert_int_eq(try_plane(context, &plane, NULL), k < 2 ? MUS_ERR_ARG : MUS_OK);
        if (k < 2) ck_assert_ptr_nonnull(strstr(mus_context_error(context), "friction"));
    }
    plane.normal[1] = 0.0;
    ck_assert_int_eq(try_plane(context, &plane, NULL), MUS_ERR_ARG);
    plane.size = 4;
    ck_assert_int_eq(try_plane(context, &plane, NULL), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_drape_add_plane(NULL, NULL, NULL), MUS_ERR_ARG);

    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape;
    const double slow[3] = {0.0, 1.0, 0.0};
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_move_plane(drape, 0, slow, 0.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_add_plane(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_move_plane(drape, 0, slow, 0.0), MUS_OK);
    ck_assert_int_eq(mus_drape_move_plane(drape, 1, slow, 0.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_move_plane(drape, 0, NULL, 0.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_move_plane(NULL, 0, slow, 0.0), MUS_ERR_ARG);
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e4};
    for (size_t v = 0; v < sizeof bad / sizeof *bad; v++) {
        const double velocity[3] = {0.0, bad[v], 0.0};
        ck_assert_int_eq(mus_drape_move_plane(drape, 0, velocity, 0.0), MUS_ERR_ARG);
        ck_assert_int_eq(mus_drape_move_plane(drape, 0, slow, bad[v]), MUS_ERR_ARG);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* mus_drape_move_body */
START_TEST(a_body_glides_at_no_speed_that_is_not_finite)
{
    mus_context *context = support_context();
    const double rows[12] = {0.0, 0.0, 0.0, 0.1, 0.1, 2.0, 0.5, 0.0, 0.0, 0.1, 0.1, 2.0};
    mus_limb limb;
    mus_body *body;
    mus_drape *drape, *bare;
    mus_limb_init(&limb, sizeof limb);
    limb.pole[0] = -0.1, limb.pole[1] = 0.6;
    limb.contours = 2;
    limb.contour = rows;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    ck_assert_int_eq(mus_drape_create(context, cloth, body, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &bare), MUS_OK);
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e4};
    for (size_t v = 0; v < sizeof bad / sizeof *bad; v++)
        for (int32_t d = 0; d < 3; d++) {
            double velocity[3] = {0.0, 0.0, 0.0};
            velocity[d] = bad[v];
            ck_assert_int_eq(mus_drape_move_body(drape, velocity), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "velocity"));
        }
    const double slow[3] = {0.0, 1.0, 0.0};
    ck_assert_int_eq(mus_drape_move_body(drape, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_move_body(NULL, slow), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_move_body(bare, slow), MUS_ERR_STATE);

    /* mus_drape_pose_body: the pose itself is refused as by mus_body_pose */
    mus_pose pose, told;
    mus_pose_init(&pose, sizeof pose);
    const double durations[] = {NAN, INFINITY, -INFINITY, -1.0, 1e7};
    for (size_t v = 0; v < sizeof durations / sizeof *durations; v++)
        ck_assert_int_eq(mus_drape_pose_body(drape, &pose, durations[v]), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "duration"));
    ck_assert_int_eq(mus_drape_pose_body(drape, NULL, 1.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_pose_body(NULL, &pose, 1.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_pose_body(bare, &pose, 1.0), MUS_ERR_STATE);
    ck_assert_int_eq(mus_drape_body_pose(bare, &told), MUS_ERR_STATE);
    ck_assert_int_eq(mus_drape_body_pose(drape, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_body_pose(NULL, &told), MUS_ERR_ARG);
    pose.angle[MUS_JOINT_ELBOW_LEFT][0] = NAN;
    ck_assert_int_eq(mus_drape_pose_body(drape, &pose, 1.0), MUS_ERR_ARG);
    pose.angle[MUS_JOINT_ELBOW_LEFT][0] = 4.0;
    ck_assert_int_eq(mus_drape_pose_body(drape, &pose, 1.0), MUS_ERR_BODY);
    pose.size = 1;
    ck_assert_int_eq(mus_drape_pose_body(drape, &pose, 1.0), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL) == MUS_ERR_STATE, 0);
    ck_assert_int_eq(mus_drape_move_body(drape, slow), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_ERR_STATE);
    mus_drape_destroy(drape);
    mus_drape_destroy(bare);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* the moving state: first and last node, each coordinate; then a step that is no number */
/* mus_drape_set_state mus_drape_step */
START_TEST(a_state_or_step_that_is_not_finite_leaves_the_drape_as_it_was)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.02);
    mus_drape *drape = scene_drape(context, cloth, _i ? 64 : 32, 1);
    const double h = 0.5 * mus_drape_step_bound(drape);
    ck_assert_int_eq(mus_drape_step(drape, 10, h), MUS_OK);
    const uint64_t before = mus_drape_hash(drape);
    const double time = mus_drape_time(drape), bound = mus_drape_step_bound(drape);
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x), *v = calloc(3 * (size_t)n, sizeof *v);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    for (int32_t value = 0; value < 3; value++)
        for (int32_t k = 0; k < 6; k++) {
            const int32_t at = k < 3 ? k : 3 * n - 6 + k;
            const double was = x[at];
            x[at] = refused_values[value];
            ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "node"));
            x[at] = was;
            v[at] = refused_values[value];
            ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_ERR_ARG);
            v[at] = 0.0;
        }
    for (int32_t value = 0; value < 3; value++)
        ck_assert_int_eq(mus_drape_step(drape, 1, refused_values[value]), MUS_ERR_ARG);
    ck_assert_uint_eq(mus_drape_hash(drape), before);
    ck_assert_double_eq(mus_drape_time(drape), time);
    ck_assert_double_eq(mus_drape_step_bound(drape), bound);
    ck_assert_int_eq(mus_drape_step(drape, 1, h), MUS_OK);
    free(x);
    free(v);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* mus_drape_set_gravity mus_drape_estimate mus_drape_tack */
START_TEST(gravity_frame_or_tack_that_is_not_finite_leaves_the_drape_as_it_was)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.02);
    mus_drape *drape[2] = {scene_drape(context, cloth, 64, 1), scene_drape(context, cloth, 64, 1)};
    for (int32_t value = 0; value < 3; value++) {
        for (int32_t d = 0; d < 3; d++) {
            double gravity[3] = {0.0, -1.0, 0.0};
            gravity[d] = refused_values[value];
            ck_assert_int_eq(mus_drape_set_gravity(drape[0], gravity), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "gravity"));
        }
        mus_estimate forecast;
        mus_estimate_init(&forecast, sizeof forecast);
        ck_assert_int_eq(mus_drape_estimate(drape[0], refused_values[value], &forecast), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "frame"));
        ck_assert_int_eq(mus_drape_tack(drape[0], 0, 9, refused_values[value], NULL), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "stiffness of a tack"));
    }

    /* it goes on as one that was never asked */
    for (int k = 0; k < 2; k++)
        ck_assert_int_eq(mus_drape_step(drape[k], 50, 0.5 * mus_drape_step_bound(drape[k])), MUS_OK);
    ck_assert_uint_eq(mus_drape_hash(drape[0]), mus_drape_hash(drape[1]));
    for (int k = 0; k < 2; k++) mus_drape_destroy(drape[k]);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* mus_drape_depth */
START_TEST(the_depth_of_a_point_that_is_not_finite_is_refused)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape), MUS_OK);
    const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 9; k++) {
        double points[6] = {0.0, 1.0, 0.0, 0.0, 1.0, 0.0}, depth[2] = {7.0, 7.0};
        points[3 + k % 3] = bad[k / 3];
        ck_assert_int_eq(mus_drape_depth(drape, 2, points, depth, NULL), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "point 1"));
        ck_assert(depth[0] == 7.0 && depth[1] == 7.0);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* positions beyond the range of a float once led the search of pairs out of its memory */
START_TEST(places_beyond_the_limit_are_refused_at_each_door)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape;
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1, def.precision = 64;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    const int32_t n = 3 * mus_drape_node_count(drape);
    double *x = malloc((size_t)n * sizeof *x);
    memcpy(x, mus_drape_positions(drape), (size_t)n * sizeof *x);
    x[1] = 1e154;
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "drape: node 0: y is 1e+154 m, expected -1e+07 to 1e+07 m");
    ck_assert_int_eq(mus_drape_step(drape, 1, 1e-5), MUS_OK);

    mus_placement place;
    mus_placement_init(&place, sizeof place);
    place.origin[2] = -1e160;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, 0, &place), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "origin: z is -1e+160 m, expected -1e+07 to 1e+07 m"));
    place.origin[2] = 0.0, place.bend_x = 1e8;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, 0, &place), MUS_ERR_ARG);
    free(x);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_cloth(void)
{
    Suite *suite = suite_create("refused_cloth");
    TCase *tests = tcase_create("refused_cloth");
    tcase_add_test(tests, a_cloth_def_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, a_value_that_is_not_finite_is_refused_by_mus_fabric_set);
    tcase_add_test(tests, a_fabric_without_weight_is_refused);
    tcase_add_test(tests, a_drape_def_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, a_plane_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, the_depth_of_a_point_that_is_not_finite_is_refused);
    tcase_add_test(tests, a_body_glides_at_no_speed_that_is_not_finite);
    tcase_add_loop_test(tests, a_state_or_step_that_is_not_finite_leaves_the_drape_as_it_was, 0, 2);
    tcase_add_test(tests, places_beyond_the_limit_are_refused_at_each_door);
    tcase_add_test(tests, gravity_frame_or_tack_that_is_not_finite_leaves_the_drape_as_it_was);
    suite_add_tcase(suite, tests);
    return suite;
}
