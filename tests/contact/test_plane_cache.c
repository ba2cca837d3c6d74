/* test_plane_cache.c: contact by remembered planes against contact that asks the limbs at every call. */
#include <math.h>
#include <string.h>

#include "contact/plane_cache.h"
#include "support.h"

Suite *mus_suite_plane_cache(void);

enum { NODES = 300, CALLS = 400 };


/* two upright cylinders of radius 0.06 that stand a millimetre apart with the cloth's clearance: nodes meet both */
static mus__collider *two_legs(mus_context *context)
{
    static const double origin[3] = {0.1, 0.2, -0.3};
    double rows[2][2][6];
    mus_limb limb[2];
    mus_body *body;
    mus__collider *collider;
    for (int l = 0; l < 2; l++) {
        for (int i = 0; i < 2; i++) {
            const double row[6] = {0.4 * (2 * i - 1), l ? 0.125 : 0.0, 0.0, 0.06, 0.06, 2.0};
            memcpy(rows[l][i], row, sizeof row);
        }
        mus_limb_init(&limb[l], sizeof limb[l]);
        limb[l].contours = 2;
        limb[l].contour = rows[l][0];
        limb[l].pole[0] = -0.41, limb[l].pole[1] = 0.41;
    }
    ck_assert_int_eq(mus_body_create_limbs(context, 2, limb, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus__collider_create(context, body, origin, 0.002, &collider), MUS_OK);
    mus_body_destroy(body);
    return collider;
}


/* nodes pressed on the legs and pushed about in steps of a few micrometres: call by call, from the same state, both
 * passes leave the same within a micrometre, and planes ask far fewer times */
START_TEST(planes_do_what_asking_every_time_does)
{
    mus_context *context = support_context();
    mus__collider *collider = two_legs(context);
    const double h = 2e-4;
    const double friction = _i == 1 ? 0.0 : _i == 2 ? INFINITY : 0.6;
    const mus__contact_rule rule = {.clearance = 0.002,
                                    .friction = friction,
                                    .push = 1e-3,
                                    .slip = h,
                                    .step = h,
                                    .cache_radius = MUS__CACHE_RADIUS};
    static double x[3 * NODES], v[3 * NODES], p[3 * NODES], before[3 * NODES], w[3 * NODES];
    static double near[8 * NODES], inverse[NODES];
    mus__distance_cache rest[NODES] = {{0, 0}};
    mus__contact_tally asked = {0}, kept = {0};
    uint64_t random = 11;
    int differ = 0;
    for (int i = 0; i < NODES; i++) {
        const double turn = support_uniform(&random, 0, 6.283), r = support_uniform(&random, 0.062, 0.066);
        const double c = i % 2 ? 0.125 : 0.0;
        x[i] = c + r * cos(turn) - collider->origin[0];
        x[NODES + i] = support_uniform(&random, -0.3, 0.3) - collider->origin[1];
        x[2 * NODES + i] = r * sin(turn) - collider->origin[2];
        inverse[i] = i % 17 == 0 ? 0.0 : 1000.0;
        near[7 * NODES + i] = -1.0;
    }
    for (int call = 0; call < CALLS; call++) {
        memcpy(before, x, sizeof before);
        for (int i = 0; i < 3 * NODES; i++) {
            v[i] += inverse[i % NODES] > 0.0 ? support_uniform(&random, -0.01, 0.01) : 0.0;
            v[i] *= 0.98;
            x[i] += h * v[i];
        }
        memcpy(p, x, sizeof p), memcpy(w, v, sizeof w);
        memset(rest, 0, sizeof rest);
        mus__contact_pass_f64(collider, &rule, &(mus__contact_nodes){NODES, 0, NODES, inverse, before, p, w, NULL}, 0,
                              rest, &asked);
        mus__plane_cache_pass_f64(collider, &rule, &(mus__contact_nodes){NODES, 0, NODES, inverse, NULL, x, v, NULL},
                                  near, &kept);
        for (int i = 0; i < 3 * NODES; i++) {
            ck_assert_double_eq_tol(x[i], p[i], 3e-6);
            ck_assert_double_eq_tol(v[i], w[i], 0.05);
            differ += fabs(v[i] - w[i]) > 1e-3;
        }
    }
    /* at the very edge of touching one pass may see a touch that the other does not */
    ck_assert_int_lt(differ, 3 * NODES * CALLS / 200);
    ck_assert_int_lt((int)(20 * kept.queries), (int)asked.queries);
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


/* a deep node moves out by `push`, and by the share `deep` of its depth beyond 1 mm; with `deep` 0 by `push` only */
START_TEST(what_is_deep_comes_out_faster)
{
    mus_context *context = support_context();
    mus__collider *collider = two_legs(context);
    const double h = 2e-4, push = 2e-5, clearance = 0.002, deep = _i ? 100.0 : 0.0;
    const mus__contact_rule rule = {
        .clearance = clearance, .push = push, .deep = deep, .slip = h, .step = h, .cache_radius = MUS__CACHE_RADIUS};
    mus__contact_tally tally = {0};
    for (int call = 0; call < 12; call++) {
        double x[3] = {0.063 - 0.001 * call, 0.01, 0.0}, v[3] = {0.0}, near[8] = {0}, inverse = 1000.0, after[3];
        near[7] = -1.0;
        const double depth = mus__collider_depth(collider, x, 0.0, NULL), lift = depth + clearance;
        for (int d = 0; d < 3; d++) x[d] -= collider->origin[d];
        mus__plane_cache_pass_f64(collider, &rule, &(mus__contact_nodes){1, 0, 1, &inverse, NULL, x, v, NULL}, near,
                                  &tally);
        for (int d = 0; d < 3; d++) after[d] = x[d] + collider->origin[d];
        const double most = push + deep * h * fmax(lift - MUS__CACHE_DEEP, 0.0), out = fmin(fmax(lift, 0.0), most);
        ck_assert_double_eq_tol(depth - mus__collider_depth(collider, after, 0.0, NULL), out, 1e-9 + 1e-3 * out);
    }
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


/* far nodes fall on the leg at 3 m/s and none gets below the skin by more than one step's way */
START_TEST(nothing_falls_through_a_ball)
{
    mus_context *context = support_context();
    mus__collider *collider = two_legs(context);
    const double h = 1e-4;
    const mus__contact_rule rule = {
        .clearance = 0.002, .friction = 0.6, .push = 1e-3, .slip = h, .step = h, .cache_radius = MUS__CACHE_RADIUS};
    float x[3], v[3], near[8], inverse[1] = {1000.0f};
    mus__contact_tally tally = {0};
    uint64_t random = 5;
    for (int run = 0; run < 50; run++) {
        const double turn = support_uniform(&random, 1.2, 5.1), r = support_uniform(&random, 0.07, 0.3);
        x[0] = (float)(r * cos(turn) - collider->origin[0]), x[1] = (float)-collider->origin[1];
        x[2] = (float)(r * sin(turn) - collider->origin[2]);
        v[0] = (float)(-3.0 * cos(turn)), v[1] = 0.5f, v[2] = (float)(-3.0 * sin(turn));
        near[7] = -1.0f;
        for (int i = 0; i < 1200; i++) {
            for (int d = 0; d < 3; d++) x[d] += (float)h * v[d];
            mus__plane_cache_pass_f32(collider, &rule, &(mus__contact_nodes){1, 0, 1, inverse, NULL, x, v, NULL}, near,
                                      &tally);
            const double p[3] = {(double)x[0] + collider->origin[0], (double)x[1] + collider->origin[1],
                                 (double)x[2] + collider->origin[2]};
            ck_assert_double_le(mus__collider_depth(collider, p, 0.05, NULL), -0.002 + 3.2 * h);
        }
    }
    mus__collider_destroy(collider);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_plane_cache(void)
{
    Suite *suite = suite_create("plane_cache");
    TCase *tests = tcase_create("near");
    tcase_add_loop_test(tests, planes_do_what_asking_every_time_does, 0, 3);
    tcase_add_test(tests, nothing_falls_through_a_ball);
    tcase_add_loop_test(tests, what_is_deep_comes_out_faster, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
