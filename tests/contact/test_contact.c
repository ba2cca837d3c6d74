/*
 * test_contact.c: nodes against radius fields of known shapes: cylinder and sphere; the impulses of a collision.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/contact_template.h"
#include "geom/vec.h"
#include "muslin/tape.h"
#include "support.h"

Suite *mus_suite_contact(void);

/* limbs round the Y axis: a cylinder of radius 0.1 from -0.39 to 0.39, and a sphere of radius 0.2 of 64 contours */
static mus_body *contact_body(mus_context *context, int sphere)
{
    double rows[6 * 64];
    mus_limb limb;
    mus_body *body;
    mus_limb_init(&limb, sizeof limb);
    limb.contours = sphere ? 64 : 2;
    limb.contour = rows;
    for (int i = 0; i < limb.contours; i++) {
        const double turn = MUS_PI * (i + 0.5) / 64, s = sphere ? -0.2 * cos(turn) : 0.39 * (2 * i - 1);
        const double r = sphere ? 0.2 * sin(turn) : 0.1, row[6] = {s, 0.0, 0.0, r, r, 2.0};
        memcpy(rows + 6 * i, row, sizeof row);
    }
    limb.pole[0] = sphere ? -0.2 : -0.4, limb.pole[1] = sphere ? 0.2 : 0.4;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    return body;
}


static mus__collider *make_collider(mus_context *context, int sphere)
{
    static const double origin[3] = {0.25, -0.5, 1.0};
    mus_body *body = contact_body(context, sphere);
    mus__collider *collider;
    ck_assert_int_eq(mus__collider_create(context, body, origin, 0.0, &collider), MUS_OK);
    mus_body_destroy(body);
    return collider;
}


START_TEST(depth_in_a_cylinder_is_the_distance_to_its_wall)
{
    mus_context *context = support_context();
    mus__collider *collider = make_collider(context, 0);
    uint64_t random = 1;
    for (int i = 0; i < 2000; i++) {
        const double r = support_uniform(&random, 0.06, 0.115), turn = support_uniform(&random, 0.0, 6.283);
        const double p[3] = {r * cos(turn), support_uniform(&random, -0.3, 0.3), r * sin(turn)};
        double normal[3];
        ck_assert_double_eq_tol(mus__collider_depth(collider, p, 0.05, normal), 0.1 - r, 1e-7);
        ck_assert_double_eq_tol(normal[0], cos(turn), 1e-6);
        ck_assert_double_eq_tol(normal[2], sin(turn), 1e-6);
    }
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


/* to first order: at points within 3 mm of a sphere of 0.2 m, away from its poles */
START_TEST(depth_near_a_sphere_is_the_distance_to_first_order)
{
    mus_context *context = support_context();
    mus__collider *collider = make_collider(context, 1);
    uint64_t random = 2;
    for (int i = 0; i < 2000; i++) {
        double d[3] = {support_uniform(&random, -1, 1), support_uniform(&random, -0.6, 0.6),
                       support_uniform(&random, -1, 1)};
        const double l = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), off = support_uniform(&random, -3e-3, 3e-3);
        if (l < 0.2 || fabs(d[1]) > 0.8 * l) continue;
        const double p[3] = {d[0] / l * (0.2 + off), d[1] / l * (0.2 + off), d[2] / l * (0.2 + off)};
        double normal[3];
        ck_assert_double_eq_tol(mus__collider_depth(collider, p, 0.05, normal), -off, 8e-5);
        ck_assert_double_ge((normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2]) / l, 0.999);
    }
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


/* one node at (r, 0, 0) of the body frame with velocity v; state relative to the collider's origin */
static void touch(double r, double clearance, double friction, double push, double *x, double *v)
{
    mus_context *context = support_context();
    mus__collider *collider = make_collider(context, 0);
    const double mobile[1] = {1.0};
    const mus__contact_rule rule = {.clearance = clearance, .friction = friction, .push = push};
    mus__contact_tally tally = {0};
    mus__distance_cache rest[1] = {{0, 0}};
    x[0] = r - collider->origin[0], x[1] = -collider->origin[1], x[2] = -collider->origin[2];
    const double before[3] = {x[0], x[1], x[2]};
    mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){1, 0, 1, mobile, before, x, v, NULL}, 0, rest, &tally);
    ck_assert_int_eq((int)tally.queries, 1);
    x[0] += collider->origin[0];
    mus__collider_destroy(collider);
    support_context_end(context);
}


/* F8: v_n = -2, v_t = 5, mu = 0.3 gives 0 and 4.4 */
START_TEST(impulses_stop_the_normal_and_brake_the_tangent)
{
    double x[3], v[3] = {-2.0, 5.0, 0.0};
    touch(0.0995, 0.0, 0.3, 1.0, x, v);
    ck_assert_double_eq_tol(v[0], 0.0, 1e-14);
    ck_assert_double_eq_tol(v[1], 4.4, 1e-14);
    ck_assert_double_eq_tol(v[2], 0.0, 1e-14);
    ck_assert_double_eq_tol(x[0], 0.1, 1e-9);
}
END_TEST


START_TEST(strong_friction_stops_and_no_friction_slides)
{
    double x[3], v[3] = {-2.0, 0.5, 0.0};
    touch(0.0995, 0.0, 0.3, 1.0, x, v);
    ck_assert_double_eq_tol(v[1], 0.0, 1e-14);
    double w[3] = {-2.0, 0.5, 0.0};
    touch(0.0995, 0.0, 0.0, 1.0, x, w);
    ck_assert_double_eq_tol(w[1], 0.5, 1e-14);
}
END_TEST


START_TEST(a_node_that_leaves_keeps_its_velocity)
{
    double x[3], v[3] = {1.0, 5.0, 0.25};
    touch(0.0995, 0.0, 0.3, 1.0, x, v);
    ck_assert_double_eq(v[0], 1.0);
    ck_assert_double_eq(v[1], 5.0);
    ck_assert_double_eq(v[2], 0.25);
}
END_TEST


START_TEST(a_swallowed_node_leaves_at_bounded_speed)
{
    double x[3], v[3] = {0.0, 0.0, 0.0};
    touch(0.06, 0.002, 0.3, 0.001, x, v);
    ck_assert_double_eq_tol(x[0], 0.061, 1e-12);
}
END_TEST


START_TEST(float_and_double_respond_alike)
{
    mus_context *context = support_context();
    mus__collider *collider = make_collider(context, 1);
    const mus__contact_rule rule = {.clearance = 0.002, .friction = 0.4, .push = 0.01};
    uint64_t random = 3;
    double x[300], v[300], mobile[100];
    float xf[300], vf[300], mobilef[100];
    mus__contact_tally tally = {0};
    mus__distance_cache rest[100] = {{0, 0}};
    for (int i = 0; i < 300; i++) {
        x[i] = support_uniform(&random, -0.2, 0.2) - collider->origin[i / 100];
        v[i] = support_uniform(&random, -1.0, 1.0);
        xf[i] = (float)x[i], vf[i] = (float)v[i];
        mobile[i % 100] = mobilef[i % 100] = 1;
    }
    mus__contact_tally tallyf = {0};
    double before[300];
    float beforef[300];
    memcpy(before, x, sizeof before), memcpy(beforef, xf, sizeof beforef);
    mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){100, 0, 100, mobile, before, x, v, NULL}, 0, rest,
                          &tally);
    memset(rest, 0, sizeof rest);
    mus__contact_pass_f32(collider, &rule, &(mus__contact_nodes){100, 0, 100, mobilef, beforef, xf, vf, NULL}, 0, rest,
                          &tallyf);
    ck_assert_int_eq((int)tally.queries, (int)tallyf.queries);
    for (int i = 0; i < 300; i++) {
        ck_assert_double_eq_tol(x[i], (double)xf[i], 2e-5);
        ck_assert_double_eq_tol(v[i], (double)vf[i], 2e-3);
    }
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


/* many nodes are asked of a part at once: each gets what it gets alone, to the last bit */
START_TEST(a_node_among_many_gets_what_it_gets_alone)
{
    mus_context *context = support_context();
    mus__collider *collider = make_collider(context, _i);
    const mus__contact_rule rule = {.clearance = 0.002, .friction = 0.4, .push = 0.01, .slip = 1e-3, .step = 1e-3};
    enum { N = 700 };
    static double x[3 * N], v[3 * N], before[3 * N], one_x[3 * N], one_v[3 * N], mobile[N];
    static float xf[3 * N], vf[3 * N], beforef[3 * N], onef_x[3 * N], onef_v[3 * N], mobilef[N];
    static mus__distance_cache rest[N];
    mus__contact_tally many = {0}, alone = {0};
    uint64_t random = 12;
    for (int i = 0; i < 3 * N; i++) {
        x[i] = support_uniform(&random, i / N == 1 ? -0.45 : -0.21, i / N == 1 ? 0.45 : 0.21) - collider->origin[i / N];
        v[i] = support_uniform(&random, -1.0, 1.0);
        before[i] = x[i] - 1e-3 * v[i];
        xf[i] = (float)x[i], vf[i] = (float)v[i], beforef[i] = (float)before[i];
        mobile[i % N] = mobilef[i % N] = 1;
    }
    memcpy(one_x, x, sizeof x), memcpy(one_v, v, sizeof v);
    memcpy(onef_x, xf, sizeof xf), memcpy(onef_v, vf, sizeof vf);
    mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){N, 0, N, mobile, before, x, v, NULL}, 0, rest, &many);
    memset(rest, 0, sizeof rest);
    mus__contact_pass_f32(collider, &rule, &(mus__contact_nodes){N, 0, N, mobilef, beforef, xf, vf, NULL}, 0, rest,
                          &many);
    memset(rest, 0, sizeof rest);
    for (int i = 0; i < N; i++) {
        mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){N, i, i + 1, mobile, before, one_x, one_v, NULL},
                              0, rest, &alone);
        memset(rest, 0, sizeof rest);
        mus__contact_pass_f32(collider, &rule,
                              &(mus__contact_nodes){N, i, i + 1, mobilef, beforef, onef_x, onef_v, NULL}, 0, rest,
                              &alone);
    }
    ck_assert_int_eq((int)many.queries, (int)alone.queries);
    ck_assert_int_ge((int)many.queries, 200);
    ck_assert_mem_eq(x, one_x, sizeof x);
    ck_assert_mem_eq(v, one_v, sizeof v);
    ck_assert_mem_eq(xf, onef_x, sizeof xf);
    ck_assert_mem_eq(vf, onef_v, sizeof vf);
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


START_TEST(out_of_reach_costs_no_query_and_changes_nothing)
{
    mus_context *context = support_context();
    mus__collider *collider = make_collider(context, 1);
    const mus__contact_rule rule = {.clearance = 0.002, .friction = 0.4, .push = 0.01};
    const double mobile[1] = {1.0};
    mus__distance_cache rest[1] = {{0, 0}};
    mus__contact_tally tally = {0};
    double x[3] = {10.0, 0.0, 0.0}, v[3] = {-100.0, 0.0, 0.0};
    const double before[3] = {10.0, 0.0, 0.0};
    mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){1, 0, 1, mobile, before, x, v, NULL}, 0, rest, &tally);
    ck_assert_int_eq((int)tally.queries, 0);
    ck_assert_double_eq(x[0], 10.0);
    ck_assert_double_eq(v[0], -100.0);
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


/* a node that flies in at the limit never gets through, though it sits out most calls */
START_TEST(sitting_out_lets_nothing_through)
{
    mus_context *context = support_context();
    mus__collider *collider = make_collider(context, 0);
    const double step = 5e-4, mobile[1] = {1.0};
    const mus__contact_rule rule = {.clearance = 0.002, .push = 1.0, .travel = step, .step = step};
    uint64_t random = 4;
    mus__contact_tally tally = {0};
    int64_t calls = 0;
    for (int k = 0; k < 200; k++) {
        const double turn = support_uniform(&random, 0.0, 6.283), off = support_uniform(&random, -0.08, 0.08);
        const double d[2] = {cos(turn), sin(turn)};
        mus__distance_cache rest[1] = {{0, 0}};
        double x[3] = {0.3 * d[0] - off * d[1] - collider->origin[0], -collider->origin[1],
                       0.3 * d[1] + off * d[0] - collider->origin[2]};
        double v[3] = {-d[0], 0.0, -d[1]};
        for (int i = 0; i < 500; i++, calls++) {
            const double before[3] = {x[0], x[1], x[2]};
            for (int c = 0; c < 3; c++) x[c] += step * v[c];
            mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){1, 0, 1, mobile, before, x, v, NULL}, 0, rest,
                                  &tally);
            const double p[3] = {x[0] + collider->origin[0], x[1] + collider->origin[1], x[2] + collider->origin[2]};
            ck_assert_double_le(mus__collider_depth(collider, p, 0.05, NULL), -0.002 + 1.5 * step);
        }
    }
    ck_assert_int_lt((int)tally.queries, (int)(0.8 * (double)calls));
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


/* nodes that wander about a walking body: what is put aside for a while would not have touched, to the last bit */
START_TEST(what_is_put_aside_would_not_have_touched)
{
    mus_context *context = support_context();
    const double h = 4e-4;
    mus_tape *tape;
    mus_body *body;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    mus_tape_destroy(tape);
    const double origin[3] = {0.0, 1.0, 0.0};
    mus__collider *collider;
    ck_assert_int_eq(mus__collider_create(context, body, origin, 0.002, &collider), MUS_OK);
    const mus__contact_rule rule = {.clearance = 0.002, .friction = 0.4, .push = 1e-3, .slip = h, .step = h};
    enum { N = 1000 };
    static double x[3 * N], v[3 * N], before[3 * N], all_x[3 * N], all_v[3 * N], mobile[N];
    static mus__distance_cache aside[N], none[N];
    mus__contact_tally kept = {0}, asked = {0};
    uint64_t random = 19;
    memset(aside, 0, sizeof aside);
    for (int i = 0; i < N; i++) {
        mobile[i] = 1000.0;
        x[i] = support_uniform(&random, -0.3, 0.3);
        x[N + i] = support_uniform(&random, -0.6, 0.45);
        x[2 * N + i] = support_uniform(&random, -0.15, 0.15);
    }
    for (int call = 0; call < 600; call++) {
        const double drift[3] = {_i * 0.4 * sin(0.02 * call), 0.0, _i * 0.3 * cos(0.03 * call)};
        const double shift[3] = {collider->shift[0] + h * drift[0], 0.0, collider->shift[2] + h * drift[2]};
        mus__collider_move(collider, NULL, shift, drift, h);
        memcpy(before, x, sizeof before);
        for (int i = 0; i < 3 * N; i++) {
            v[i] = 0.99 * v[i] + support_uniform(&random, -0.1, 0.1);
            x[i] += h * v[i];
        }
        memcpy(all_x, x, sizeof x), memcpy(all_v, v, sizeof v);
        memset(none, 0, sizeof none);
        mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){N, 0, N, mobile, before, x, v, NULL}, 0, aside,
                              &kept);
        mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){N, 0, N, mobile, before, all_x, all_v, NULL}, 0,
                              none, &asked);
        ck_assert_mem_eq(x, all_x, sizeof x);
        ck_assert_mem_eq(v, all_v, sizeof v);
    }
    ck_assert_int_lt(3 * (int)kept.queries, 2 * (int)asked.queries);
    mus__collider_destroy(collider);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_is_a_status)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        static const double origin[3] = {0};
        mus_body *body = contact_body(context, 1);
        mus__collider *collider;
        support_fail_after(n, false);
        const mus_status status = mus__collider_create(context, body, origin, 0.0, &collider);
        support_fail_never();
        mus__collider_destroy(collider);
        mus_body_destroy(body);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_contact(void)
{
    Suite *suite = suite_create("contact");
    TCase *tests = tcase_create("contact");
    tcase_add_test(tests, depth_in_a_cylinder_is_the_distance_to_its_wall);
    tcase_add_test(tests, depth_near_a_sphere_is_the_distance_to_first_order);
    tcase_add_test(tests, impulses_stop_the_normal_and_brake_the_tangent);
    tcase_add_test(tests, strong_friction_stops_and_no_friction_slides);
    tcase_add_test(tests, a_node_that_leaves_keeps_its_velocity);
    tcase_add_test(tests, a_swallowed_node_leaves_at_bounded_speed);
    tcase_add_test(tests, float_and_double_respond_alike);
    tcase_add_loop_test(tests, a_node_among_many_gets_what_it_gets_alone, 0, 2);
    tcase_add_test(tests, out_of_reach_costs_no_query_and_changes_nothing);
    tcase_add_test(tests, sitting_out_lets_nothing_through);
    tcase_add_loop_test(tests, what_is_put_aside_would_not_have_touched, 0, 2);
    tcase_add_test(tests, each_failing_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
