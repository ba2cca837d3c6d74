/*
 * test_contact_manifold.c: cloth between two surfaces (armpit, crotch, touching thighs): never trapped, never thrown,
 * never deeper than half of what the two overlap.
 */
#include <math.h>
#include <string.h>

#include "drape/worn.h"
#include "muslin/muslin.h"

Suite *mus_suite_contact_manifold(void);

#define WEDGE_RADIUS 0.06

typedef struct wedge {
    mus_context *context;
    mus_body *body;
    mus_cloth *cloth;
    mus_drape *drape;
} wedge;


/* two rollers along z side by side, their skins `gap` apart at the nearest (below 0: they overlap), and one node of 1 g
 * at (x, y) */
static wedge wedge_start(double gap, double x, double y, int32_t precision, double friction)
{
    wedge w = {.context = support_context()};
    double rows[2][12];
    mus_limb limb[2];
    for (int l = 0; l < 2; l++) {
        for (int i = 0; i < 2; i++) {
            const double row[6] = {i - 0.5, 0.0, 0.0, WEDGE_RADIUS, WEDGE_RADIUS, 2.0};
            memcpy(rows[l] + 6 * i, row, sizeof row);
        }
        mus_limb_init(&limb[l], sizeof limb[l]);
        limb[l].origin[0] = (l ? 1.0 : -1.0) * (WEDGE_RADIUS + 0.5 * gap);
        limb[l].axis[1] = 0.0, limb[l].axis[2] = 1.0;
        limb[l].pole[0] = -0.6, limb[l].pole[1] = 0.6;
        limb[l].contours = 2, limb[l].contour = rows[l];
    }
    ck_assert_int_eq(mus_body_create_limbs(w.context, 2, limb, NULL, &w.body), MUS_OK);

    const double place[3] = {x, y, 0.0}, mass = 1e-3;
    mus_bare bare;
    mus_drape_def def;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 1, bare.place = place, bare.mass = &mass;
    ck_assert_int_eq(mus_cloth_create_bare(w.context, &bare, &w.cloth), MUS_OK);
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.gravity[1] = 0.0;
    def.drag = 0.0;
    def.friction = friction;
    ck_assert_int_eq(mus_drape_create(w.context, w.cloth, w.body, &def, &w.drape), MUS_OK);
    return w;
}


static void wedge_end(wedge *w)
{
    mus_drape_destroy(w->drape);
    mus_cloth_destroy(w->cloth);
    mus_body_destroy(w->body);
    support_context_end(w->context);
}


/* distances of the node to both skins, the lesser first */
static void wedge_distances(const wedge *w, double gap, double *out)
{
    const double *x = mus_drape_positions(w->drape), centre = WEDGE_RADIUS + 0.5 * gap;
    const double a = hypot(x[0] - centre, x[1]) - WEDGE_RADIUS, b = hypot(x[0] + centre, x[1]) - WEDGE_RADIUS;
    out[0] = fmin(a, b), out[1] = fmax(a, b);
}


/* wherever it starts between two rollers that touch, nearly touch or overlap, with and without friction: it comes out,
 * drawn between both and put out of one at 1 m/s, at 1.6 m/s at most, never gets deeper, and rests clear of both */
START_TEST(what_starts_between_two_rollers_comes_out_slowly)
{
    static const double gaps[] = {0.003, 0.001, 0.0, -0.01, -0.04};
    static const double places[][2] = {{0.0, 0.01}, {0.004, 0.006}, {-0.01, 0.02}, {0.002, -0.012}};
    const double gap = gaps[_i % 5], h = 2e-4;
    for (int k = 0; k < 8; k++) {
        const double *at = places[k % 4];
        wedge w = wedge_start(gap, at[0], at[1], k / 4 ? 64 : 32, _i / 5 ? 0.6 : 0.0);
        double last[3], distance[2], deepest;
        memcpy(last, mus_drape_positions(w.drape), sizeof last);
        wedge_distances(&w, gap, distance);
        deepest = fmin(distance[0], 0.002);
        for (int step = 0; step < 2000; step++) {
            ck_assert_int_eq(mus_drape_step(w.drape, 1, h), MUS_OK);
            const double *x = mus_drape_positions(w.drape);
            wedge_distances(&w, gap, distance);
            ck_assert_double_le(hypot(x[0] - last[0], x[1] - last[1]), 1.6 * h);
            ck_assert_double_ge(distance[0], deepest - 1e-5);
            deepest = fmax(deepest, fmin(distance[0], 0.002));
            memcpy(last, x, sizeof last);
        }
        ck_assert_msg(distance[0] >= 0.002 - 2e-6, "gap %g, from %g, %g: at %g, %g, %g m off", gap, at[0], at[1],
                      last[0], last[1], distance[0]);
        ck_assert_double_eq_tol(last[2], 0.0, 1e-9);
        wedge_end(&w);
    }
}
END_TEST


/* pulled into the wedge by a hundred times its weight it lies where both clearances meet, and stays */
START_TEST(what_is_pulled_into_a_wedge_lies_still_in_it)
{
    static const double down[3] = {0.0, -981.0, 0.0};
    const double gap = _i % 2 ? 0.001 : -0.01;
    wedge w = wedge_start(gap, 0.003, 0.05, _i / 2 % 2 ? 64 : 32, _i / 4 ? 0.4 : 0.0);
    ck_assert_int_eq(mus_drape_set_gravity(w.drape, down), MUS_OK);
    ck_assert_int_eq(mus_drape_step(w.drape, 4000, 1e-4), MUS_OK);
    const double centre = WEDGE_RADIUS + 0.5 * gap, off = WEDGE_RADIUS + 0.002;
    const double height = sqrt(off * off - centre * centre);
    for (int k = 0; k < 50; k++) {
        ck_assert_int_eq(mus_drape_step(w.drape, 7, 1e-4), MUS_OK);
        const double *x = mus_drape_positions(w.drape);
        ck_assert_double_eq_tol(x[0], 0.0, 2e-4);
        ck_assert_double_eq_tol(x[1], height, 2e-4);
    }
    wedge_end(&w);
}
END_TEST


/* drawn into the wedge so hard that its path is followed, between rollers that turn, so that each is followed by
 * itself: out of one is not into the other. (With that left to the next step, it is 16 mm deep.) */
START_TEST(what_is_torn_into_a_wedge_that_turns_stays_out_of_both)
{
    const double gap = _i % 2 ? 0.001 : -0.01, h = 1e-3;
    wedge w = wedge_start(gap, 0.0, 0.05, _i / 2 % 2 ? 64 : 32, 0.3);
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    pose.angle[MUS_JOINT_ROOT][MUS_POSE_ROTATION] = 1e-4;
    ck_assert_int_eq(mus_drape_pose_body(w.drape, &pose, 1.0), MUS_OK);
    for (int step = 0; step < 200; step++) {
        const double v[3] = {20.0 * cos(0.7 * step), -80.0, 0.0};
        double distance[2], place[3];
        memcpy(place, mus_drape_positions(w.drape), sizeof place);
        ck_assert_int_eq(mus_drape_set_state(w.drape, place, v), MUS_OK);
        ck_assert_int_eq(mus_drape_step(w.drape, 1, h), MUS_OK);
        wedge_distances(&w, gap, distance);
        ck_assert_msg(distance[0] > -0.003, "gap %g: %g m off after %d steps", gap, distance[0], step + 1);
    }
    wedge_end(&w);
}
END_TEST


/* a T-shirt whose arms come down to the sides: the cloth of the armpits comes out of them, and rests */
START_TEST(a_tshirt_is_not_trapped_in_the_armpits)
{
    worn w = worn_body("W40");
    mus_cloth_def cut;
    mus_drape_def def;
    mus_drape_report report;
    mus_pose pose;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.03;
    mus_drape_def_init(&def, sizeof def);
    def.integrator = MUS_METHOD_VERLET;
    mus_drape_report_init(&report, sizeof report);
    worn_put_on_design(&w, "tshirt", NULL);
    ck_assert_int_eq(mus_cloth_create(w.context, w.pattern, &cut, &w.cloth), MUS_OK);
    worn_place(&w, &def);
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_pose_named(w.context, "arms_down", &pose), MUS_OK);
    ck_assert_int_eq(mus_drape_pose_body(w.drape, &pose, 0.8), MUS_OK);
    const double until = mus_drape_time(w.drape) + 1.0;
    while (mus_drape_time(w.drape) < until) {
        ck_assert_int_eq(mus_drape_step(w.drape, 16, 0.6 * mus_drape_step_bound(w.drape)), MUS_OK);
        ck_assert_int_eq(mus_drape_report_get(w.drape, &report), MUS_OK);
        ck_assert_double_le(report.max_penetration, 2e-3);
    }
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_report_get(w.drape, &report), MUS_OK);
    ck_assert_double_le(report.max_penetration, 1e-3);
    worn_end(&w);
}
END_TEST


Suite *mus_suite_contact_manifold(void)
{
    Suite *suite = suite_create("contact_manifold");
    TCase *tests = tcase_create("wedge");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, what_starts_between_two_rollers_comes_out_slowly, 0, SUPPORT_SLOW ? 3 : 10);
    tcase_add_loop_test(tests, what_is_pulled_into_a_wedge_lies_still_in_it, 0, SUPPORT_SLOW ? 3 : 8);
    tcase_add_loop_test(tests, what_is_torn_into_a_wedge_that_turns_stays_out_of_both, 0, SUPPORT_SLOW ? 2 : 4);
    tcase_add_test(tests, a_tshirt_is_not_trapped_in_the_armpits);
    suite_add_tcase(suite, tests);
    return suite;
}
