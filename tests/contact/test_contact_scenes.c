/*
 * test_contact_scenes.c: cloth that meets a body, in extreme cases and in what must not matter:
 * threads, a body that does not move, sweeping where nothing is fast.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/muslin.h"
#include "support.h"

Suite *mus_suite_contact_scenes(void);

#define MEETING_MOST (24 * 24)

typedef struct meeting {
    mus_context *context;
    mus_body *body;
    mus_cloth *cloth;
    mus_drape_def def;
    mus_drape *drape;
    int32_t n, nodes; /* a grid of n x n; n = 1: one node of mass 1 */
} meeting;


/* a roller of radius 0.1 along x, its axis tilted up towards +x by `tilt` */
static void meeting_roller(meeting *m, double tilt)
{
    const double rows[12] = {-0.5, 0.0, 0.0, 0.1, 0.1, 2.0, 0.5, 0.0, 0.0, 0.1, 0.1, 2.0};
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    limb.axis[0] = cos(tilt), limb.axis[1] = sin(tilt);
    limb.side[0] = 0.0, limb.side[2] = 1.0;
    limb.pole[0] = -0.6, limb.pole[1] = 0.6;
    limb.contours = 2, limb.contour = rows;
    ck_assert_int_eq(mus_body_create_limbs(m->context, 1, &limb, NULL, &m->body), MUS_OK);
}


static meeting meeting_start(int32_t n, double cell, double tilt)
{
    meeting m = {.context = support_context(), .n = n, .nodes = n * n};
    const double cells[2] = {cell, cell}, place[3] = {0}, mass = 1.0;
    mus_cloth_def cut;
    mus_bare bare;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 1, bare.place = place, bare.mass = &mass;
    if (n > 1)
        ck_assert_int_eq(mus_cloth_create_grid(m.context, n, n, cells, &cut, &m.cloth), MUS_OK);
    else
        ck_assert_int_eq(mus_cloth_create_bare(m.context, &bare, &m.cloth), MUS_OK);
    meeting_roller(&m, tilt);
    mus_drape_def_init(&m.def, sizeof m.def);
    m.def.precision = 64;
    m.def.drag = 0.0;
    return m;
}


/* the grid level (turned by `tilt`), its middle at `height` over the axis, moving at `speed` along y */
static void meeting_place(meeting *m, double cell, double tilt, double height, double speed)
{
    double x[3 * MEETING_MOST], v[3 * MEETING_MOST] = {0};
    mus_drape_destroy(m->drape);
    ck_assert_int_eq(mus_drape_create(m->context, m->cloth, m->body, &m->def, &m->drape), MUS_OK);
    for (int32_t i = 0; i < m->nodes; i++) {
        const double a = cell * (i % m->n - 0.5 * (m->n - 1)), b = cell * (i / m->n - 0.5 * (m->n - 1));
        x[3 * i] = a * cos(tilt) - height * sin(tilt);
        x[3 * i + 1] = a * sin(tilt) + height * cos(tilt);
        x[3 * i + 2] = b;
        v[3 * i + 1] = speed;
    }
    ck_assert_int_eq(mus_drape_set_state(m->drape, x, v), MUS_OK);
}


static void meeting_end(meeting *m)
{
    mus_drape_destroy(m->drape);
    mus_cloth_destroy(m->cloth);
    mus_body_destroy(m->body);
    support_context_end(m->context);
}


static mus_drape_report meeting_report(const meeting *m)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(m->drape, &report), MUS_OK);
    return report;
}


static void meeting_run(meeting *m, double seconds)
{
    const double h = 0.9 * mus_drape_step_bound(m->drape);
    const double step = h < 1e-3 ? h : 1e-3;
    const mus_status status = mus_drape_step(m->drape, (int32_t)ceil(seconds / step), step);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(m->context));
}


/* contact acts by impulses: the bound with a body is the bound without, it holds when cloth lands, and a step above
 * it is refused */
START_TEST(a_body_does_not_lower_the_step_bound)
{
    meeting m = meeting_start(12, 0.02, 0.0);
    meeting_place(&m, 0.02, 0.0, 0.11, 0.0);
    mus_drape *free_cloth;
    ck_assert_int_eq(mus_drape_create(m.context, m.cloth, NULL, &m.def, &free_cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_set_state(free_cloth, mus_drape_positions(m.drape), NULL), MUS_OK);
    const double bound = mus_drape_step_bound(m.drape);
    ck_assert_double_eq(bound, mus_drape_step_bound(free_cloth));
    mus_drape_destroy(free_cloth);
    ck_assert_int_eq(mus_drape_step(m.drape, 1, 1.01 * bound), MUS_ERR_STEP);

    double highest = meeting_report(&m).energy;
    for (int k = 0; k < 40; k++) {
        ck_assert_int_eq(mus_drape_step(m.drape, 50, 0.95 * mus_drape_step_bound(m.drape)), MUS_OK);
        const mus_drape_report report = meeting_report(&m);
        ck_assert_double_le(report.energy, 1.001 * highest);
        ck_assert_double_le(report.max_penetration, 0.0);
        highest = report.energy;
    }
    meeting_end(&m);
}
END_TEST


/* at 100 m/s: no node goes through, none moves into the skin afterwards, energy never grows */
START_TEST(cloth_hits_a_body_at_a_hundred_metres_a_second)
{
    meeting m = meeting_start(16, 0.02, 0.0);
    m.def.precision = _i ? 64 : 32;
    m.def.gravity[1] = 0.0;
    meeting_place(&m, 0.02, 0.0, 0.15, -100.0);
    double before = meeting_report(&m).energy;
    for (int k = 0; k < 200; k++) {
        ck_assert_int_eq(mus_drape_step(m.drape, 1, 0.9 * mus_drape_step_bound(m.drape)), MUS_OK);
        const mus_drape_report report = meeting_report(&m);
        const double *x = mus_drape_positions(m.drape), *v = mus_drape_velocities(m.drape);
        ck_assert_double_le(report.max_penetration, 0.0);
        ck_assert_msg(report.energy <= 1.001 * before, "step %d: %g J after %g", k, report.energy, before);
        before = report.energy;
        for (int32_t i = 0; i < m.nodes; i++) {
            const double *p = x + 3 * i, r = sqrt(p[1] * p[1] + p[2] * p[2]);
            if (r > 0.102 + 2e-8 || fabs(p[0]) > 0.5) continue;
            ck_assert_double_ge((p[1] * v[3 * i + 1] + p[2] * v[3 * i + 2]) / r, -0.05);
        }
    }
    meeting_end(&m);
}
END_TEST


/* one node at 100 m/s and a step of 10 ms: it stops at the near side */
START_TEST(a_bullet_stops_at_the_near_side)
{
    meeting m = meeting_start(1, 0.0, 0.0);
    m.def.precision = _i % 2 ? 64 : 32;
    m.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    m.def.gravity[1] = 0.0;
    meeting_place(&m, 0.0, 0.0, 0.5, -100.0);
    ck_assert_int_eq(mus_drape_step(m.drape, 3, 0.01), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(m.drape)[1], 0.102, 3e-6);
    ck_assert_double_eq_tol(mus_drape_velocities(m.drape)[1], 0.0, 1e-6);
    meeting_end(&m);
}
END_TEST


/* a node that grows fast on the way is swept when it comes, also where contact goes by planes */
START_TEST(a_node_in_free_fall_stops_at_the_near_side)
{
    meeting m = meeting_start(1, 0.0, 0.0);
    m.def.precision = _i % 2 ? 64 : 32;
    m.def.integrator = _i / 2 % 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    m.def.contact_ball = _i / 4 ? 2.5e-4 : 0.0;
    m.def.gravity[1] = -1000.0;
    meeting_place(&m, 0.0, 0.0, 5.0, 0.0);
    ck_assert_int_eq(mus_drape_step(m.drape, 30, 0.01), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(m.drape)[1], 0.102, 3e-6);
    meeting_end(&m);
}
END_TEST


/* a body at 10 m/s, and one that moves a metre in a step, takes the cloth along on its front */
START_TEST(nothing_is_left_behind_a_body_that_rushes_on)
{
    static const double speeds[] = {10.0, 100.0, 1000.0};
    for (int k = 0; k < 3; k++) {
        meeting m = meeting_start(12, 0.02, 0.0);
        const double velocity[3] = {0.0, speeds[k], 0.0};
        m.def.integrator = _i ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
        meeting_place(&m, 0.02, 0.0, 0.25, 0.0);
        ck_assert_int_eq(mus_drape_move_body(m.drape, velocity), MUS_OK);
        const double bound = 0.9 * mus_drape_step_bound(m.drape), h = fmin(bound, 1e-3);
        const int32_t steps = (int32_t)ceil(0.6 / (speeds[k] * h)) + 1;
        const mus_status status = mus_drape_step(m.drape, steps, h);
        ck_assert_msg(status == MUS_OK, "%g m/s: %s", speeds[k], mus_context_error(m.context));
        ck_assert_double_le(meeting_report(&m).max_penetration, 0.0);
        const double axis = speeds[k] * steps * h;
        for (int32_t i = 0; i < m.nodes; i++) {
            const double *x = mus_drape_positions(m.drape) + 3 * i;
            if (fabs(x[2]) < 0.08) ck_assert_msg(x[1] > axis, "%g m/s: node %d is behind", speeds[k], (int)i);
        }
        meeting_end(&m);
    }
}
END_TEST


/* where the body was put stays when it stops, and placing brings it back */
START_TEST(a_body_stays_where_it_stops)
{
    meeting m = meeting_start(1, 0.0, 0.0);
    m.def.gravity[1] = 0.0;
    meeting_place(&m, 0.0, 0.0, 3.0, 0.0);
    const double velocity[3] = {0.0, 2.0, 0.0}, none[3] = {0.0, 0.0, 0.0}, inside[3] = {0.0, 2.05, 0.0};
    ck_assert_int_eq(mus_drape_move_body(m.drape, velocity), MUS_OK);
    ck_assert_int_eq(mus_drape_step(m.drape, 10, 0.05), MUS_OK);
    ck_assert_int_eq(mus_drape_step(m.drape, 50, 0.01), MUS_OK);
    ck_assert_int_eq(mus_drape_move_body(m.drape, none), MUS_OK);
    ck_assert_int_eq(mus_drape_step(m.drape, 7, 0.125), MUS_OK);
    ck_assert_int_eq(mus_drape_set_state(m.drape, inside, NULL), MUS_OK);
    ck_assert_double_eq_tol(meeting_report(&m).max_penetration, 0.05, 1e-9);
    ck_assert_int_eq(mus_drape_place(m.drape), MUS_OK);
    ck_assert_int_eq(mus_drape_set_state(m.drape, inside, NULL), MUS_OK);
    ck_assert_double_eq(meeting_report(&m).max_penetration, 0.0);
    meeting_end(&m);
}
END_TEST


/* cloth that starts just in the body comes out below 1 m/s: no burst. From deep inside it must stretch over the roller
 * to come out, and snaps when it slips over: at the speeds of such elastic energies, some metres a second */
START_TEST(cloth_that_starts_inside_comes_out_slowly)
{
    static const double heights[] = {0.099, 0.05, 0.03};
    meeting m = meeting_start(8, 0.02, 0.0);
    m.def.precision = _i % 2 ? 64 : 32;
    m.def.gravity[1] = 0.0;
    m.def.integrator = _i / 6 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    meeting_place(&m, 0.02, 0.0, heights[_i / 2 % 3], 0.0);
    double fastest = 0.0, deepest = 0.0, elastic = 0.0;
    for (int k = 0; k < 200; k++) {
        meeting_run(&m, 0.002);
        const mus_drape_report report = meeting_report(&m);
        fastest = fmax(fastest, report.max_speed);
        elastic = fmax(elastic, report.energy);
        deepest = report.max_penetration;
    }
    ck_assert_double_le(deepest, 1e-6);
    ck_assert_msg(fastest < (_i / 2 % 3 == 0 ? 1.0 : 10.0), "%g m/s, %g J", fastest, elastic);
    meeting_end(&m);
}
END_TEST


/* a cloth on both sides of the axis is torn apart by no burst either */
START_TEST(a_swallowed_cloth_stays_calm)
{
    meeting m = meeting_start(8, 0.02, 0.0);
    m.def.gravity[1] = 0.0;
    meeting_place(&m, 0.02, 0.0, 0.0, 0.0);
    double fastest = 0.0;
    for (int k = 0; k < 200; k++) {
        meeting_run(&m, 0.002);
        fastest = fmax(fastest, meeting_report(&m).max_speed);
    }
    ck_assert_msg(fastest < 20.0, "%g m/s", fastest);
    meeting_end(&m);
}
END_TEST


/* on a slope of 30 degrees a point slides as friction says, and from 0.58 on not at all */
START_TEST(friction_from_none_to_infinite)
{
    static const double friction[] = {0.0, 0.3, 0.57, 0.6, 1.0, 10.0, INFINITY};
    const double tilt = acos(-1.0) / 6.0;
    for (int k = 0; k < 7; k++) {
        meeting m = meeting_start(1, 0.0, tilt);
        m.def.friction = friction[k];
        m.def.integrator = _i ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
        meeting_place(&m, 0.0, tilt, 0.102, 0.0);
        const double start[3] = {mus_drape_positions(m.drape)[0], mus_drape_positions(m.drape)[1], 0.0};
        ck_assert_int_eq(mus_drape_step(m.drape, 2000, 1e-4), MUS_OK);
        const double *x = mus_drape_positions(m.drape);
        const double pull = sin(tilt) - friction[k] * cos(tilt), down = 9.81 * (pull > 0.0 ? pull : 0.0);
        const double gone = hypot(x[0] - start[0], x[1] - start[1]);
        ck_assert_msg(fabs(gone - 0.5 * down * 0.04) < (down > 0.0 ? 1e-4 : 1e-9), "friction %g: %g m, expected %g",
                      friction[k], gone, 0.5 * down * 0.04);
        meeting_end(&m);
    }
}
END_TEST


/* cloth at rest on a slope does not creep */
START_TEST(what_sticks_on_a_slope_does_not_creep)
{
    const double tilt = 0.3;
    meeting m = meeting_start(8, 0.02, tilt);
    m.def.precision = _i % 2 ? 64 : 32;
    m.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    m.def.friction = 0.6;
    m.def.drag = 5.0;
    meeting_place(&m, 0.02, tilt, 0.103, 0.0);
    meeting_run(&m, 5.0);
    double rest[3 * MEETING_MOST], worst = 0.0;
    memcpy(rest, mus_drape_positions(m.drape), 3 * (size_t)m.nodes * sizeof *rest);
    meeting_run(&m, 10.0);
    for (int32_t i = 0; i < 3 * m.nodes; i++) worst = fmax(worst, fabs(mus_drape_positions(m.drape)[i] - rest[i]));
    ck_assert_msg(worst < 1e-9, "%g m in 10 s", worst);
    meeting_end(&m);
}
END_TEST


/* a body that was told to glide at no speed, and one that was told nothing: the same bytes */
START_TEST(no_glide_is_no_change)
{
    uint64_t hash[2];
    for (int k = 0; k < 2; k++) {
        meeting m = meeting_start(12, 0.02, 0.0);
        const double none[3] = {0.0, -0.0, 0.0};
        m.def.precision = _i % 2 ? 64 : 32;
        m.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
        meeting_place(&m, 0.02, 0.0, 0.11, -1.0);
        if (k) ck_assert_int_eq(mus_drape_move_body(m.drape, none), MUS_OK);
        ck_assert_int_eq(mus_drape_step(m.drape, 300, 0.9 * mus_drape_step_bound(m.drape)), MUS_OK);
        ck_assert_int_gt((int)meeting_report(&m).contact_queries, 0);
        hash[k] = mus_drape_hash(m.drape);
        meeting_end(&m);
    }
    ck_assert_uint_eq(hash[0], hash[1]);
}
END_TEST


/* I12 with all that contact can do: fast nodes, a body that glides */
START_TEST(threads_do_not_matter_to_fast_nodes)
{
    uint64_t hash[3];
    double impulse[3];
    for (int k = 0; k < 3; k++) {
        meeting m = meeting_start(24, 0.01, 0.0);
        const double velocity[3] = {1.0, 60.0, 0.5};
        m.def.precision = _i % 2 ? 64 : 32;
        m.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
        m.def.threads = 1 + k;
        meeting_place(&m, 0.01, 0.0, 0.2, -60.0);
        ck_assert_int_eq(mus_drape_move_body(m.drape, velocity), MUS_OK);
        ck_assert_int_eq(mus_drape_step(m.drape, 150, 0.5 * mus_drape_step_bound(m.drape)), MUS_OK);
        hash[k] = mus_drape_hash(m.drape);
        impulse[k] = meeting_report(&m).contact_impulse[1];
        meeting_end(&m);
    }
    ck_assert_uint_eq(hash[0], hash[1]);
    ck_assert_uint_eq(hash[0], hash[2]);
    ck_assert_double_gt(impulse[0], 0.0);
    ck_assert_double_eq_tol(impulse[0], impulse[2], 1e-9 * impulse[0]);
}
END_TEST


Suite *mus_suite_contact_scenes(void)
{
    Suite *suite = suite_create("contact_scenes");
    TCase *tests = tcase_create("meeting");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, a_body_does_not_lower_the_step_bound);
    tcase_add_loop_test(tests, cloth_hits_a_body_at_a_hundred_metres_a_second, 0, 2);
    tcase_add_loop_test(tests, a_bullet_stops_at_the_near_side, 0, 4);
    tcase_add_loop_test(tests, a_node_in_free_fall_stops_at_the_near_side, 0, 8);
    tcase_add_loop_test(tests, nothing_is_left_behind_a_body_that_rushes_on, 0, 2);
    tcase_add_test(tests, a_body_stays_where_it_stops);
    tcase_add_loop_test(tests, cloth_that_starts_inside_comes_out_slowly, 0, 12);
    tcase_add_test(tests, a_swallowed_cloth_stays_calm);
    tcase_add_loop_test(tests, friction_from_none_to_infinite, 0, 2);
    tcase_add_loop_test(tests, what_sticks_on_a_slope_does_not_creep, 0, SUPPORT_SLOW ? 1 : 4);
    tcase_add_loop_test(tests, no_glide_is_no_change, 0, 4);
    tcase_add_loop_test(tests, threads_do_not_matter_to_fast_nodes, 0, 4);
    suite_add_tcase(suite, tests);
    return suite;
}
