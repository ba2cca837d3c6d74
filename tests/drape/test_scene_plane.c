/*
 * test_scene_plane.c: planes beside the body: cloth lies on them, none passes, what sticks is carried, out of reach
 * they are as if they were not there.
 */
#include <math.h>
#include <string.h>

#include "muslin/muslin.h"
#include "support.h"

Suite *mus_suite_scene_plane(void);

enum { SIDE = 10, NODES = SIDE * SIDE };

typedef struct ground {
    mus_context *context;
    mus_cloth *cloth;
    mus_drape_def def;
    mus_drape *drape;
} ground;


/* a grid of cells of 2 cm, or one node of mass 1 */
static ground ground_start(int grid)
{
    ground g = {.context = support_context()};
    const double cells[2] = {0.02, 0.02}, place[3] = {0}, mass = 1.0;
    mus_cloth_def cut;
    mus_bare bare;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 1, bare.place = place, bare.mass = &mass;
    if (grid)
        ck_assert_int_eq(mus_cloth_create_grid(g.context, SIDE, SIDE, cells, &cut, &g.cloth), MUS_OK);
    else
        ck_assert_int_eq(mus_cloth_create_bare(g.context, &bare, &g.cloth), MUS_OK);
    mus_drape_def_init(&g.def, sizeof g.def);
    g.def.precision = 64;
    g.def.drag = 0.0;
    g.def.friction = 0.3;
    return g;
}


static void ground_drape(ground *g)
{
    mus_drape_destroy(g->drape);
    ck_assert_int_eq(mus_drape_create(g->context, g->cloth, NULL, &g->def, &g->drape), MUS_OK);
}


static void ground_end(ground *g)
{
    mus_drape_destroy(g->drape);
    mus_cloth_destroy(g->cloth);
    support_context_end(g->context);
}


/* the grid level at `height`, moving */
static void ground_place(ground *g, double height, double vx, double vy)
{
    double x[3 * NODES], v[3 * NODES];
    for (int i = 0; i < NODES; i++) {
        x[3 * i] = 0.02 * (i % SIDE), x[3 * i + 1] = height, x[3 * i + 2] = 0.02 * (i / SIDE);
        v[3 * i] = vx, v[3 * i + 1] = vy, v[3 * i + 2] = 0.0;
    }
    ck_assert_int_eq(mus_drape_set_state(g->drape, x, v), MUS_OK);
}


static mus_plane ground_plane(double x, double y, double nx, double ny)
{
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    plane.point[0] = x, plane.point[1] = y;
    plane.normal[0] = nx, plane.normal[1] = ny;
    return plane;
}


static void ground_add(ground *g, const mus_plane *plane)
{
    const mus_status status = mus_drape_add_plane(g->drape, plane, NULL);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(g->context));
}


static mus_drape_report ground_report(const ground *g)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(g->drape, &report), MUS_OK);
    return report;
}


/* a plane 10 m below is no plane: the same bytes, and no question asked */
START_TEST(a_plane_out_of_reach_changes_no_byte)
{
    ground g = ground_start(1);
    uint64_t hash[2];
    g.def.precision = _i % 2 ? 64 : 32;
    g.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    for (int with = 0; with < 2; with++) {
        const mus_plane far = ground_plane(0.0, -10.0, 0.2, 1.0);
        ground_drape(&g);
        if (with) ground_add(&g, &far);
        ground_place(&g, 0.5, 1.0, -2.0);
        ck_assert_int_eq(mus_drape_pin(g.drape, 0, 1), MUS_OK);
        ck_assert_int_eq(mus_drape_step(g.drape, 300, 0.5 * mus_drape_step_bound(g.drape)), MUS_OK);
        hash[with] = mus_drape_hash(g.drape);
        ck_assert_int_eq((int)ground_report(&g).contact_queries, 0);
        ck_assert_int_eq(strstr(mus_drape_skipped(g.drape), "contact") == NULL, with);
    }
    ck_assert_uint_eq(hash[0], hash[1]);
    ground_end(&g);
}
END_TEST


/* at 100 m/s in steps of 1 to 10 ms, down on the ground and slantwise on a disc: it stays on top, at the place where it
 * hit when all friction holds it */
START_TEST(no_bullet_passes_a_plane)
{
    ground g = ground_start(0);
    g.def.precision = _i % 2 ? 64 : 32;
    g.def.integrator = _i / 2 % 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    g.def.friction = INFINITY;
    g.def.gravity[1] = 0.0;
    for (int disc = 0; disc < 2; disc++)
        for (double h = 1e-3; h < 0.02; h *= 10.0) {
            mus_plane plane = ground_plane(0.0, 0.0, 0.0, 1.0);
            const double place[3] = {0.4, 0.8, 0.0}, velocity[3] = {-40.0, -100.0, 0.0};
            plane.reach = disc ? 0.3 : 0.0;
            ground_drape(&g);
            ground_add(&g, &plane);
            ck_assert_int_eq(mus_drape_set_state(g.drape, place, velocity), MUS_OK);
            ck_assert_int_eq(mus_drape_step(g.drape, 20, h), MUS_OK);
            const double *x = mus_drape_positions(g.drape);
            ck_assert_double_eq_tol(x[1], 0.002, 1e-7);
            ck_assert_double_eq_tol(x[0], 0.4 - 0.4 * 0.798, 2e-5);
        }
    ground_end(&g);
}
END_TEST


/* beside a disc, and under it, nothing is there */
START_TEST(a_disc_ends)
{
    ground g = ground_start(0);
    mus_plane plane = ground_plane(0.0, 0.0, 0.0, 1.0);
    plane.reach = 0.3;
    static const double places[3][2] = {{0.301, 0.1}, {0.2, -0.05}, {-0.299, 0.1}};
    for (int k = 0; k < 3; k++) {
        const double place[3] = {places[k][0], places[k][1], 0.0};
        ground_drape(&g);
        ground_add(&g, &plane);
        ck_assert_int_eq(mus_drape_set_state(g.drape, place, NULL), MUS_OK);
        ck_assert_int_eq(mus_drape_step(g.drape, 300, 1e-3), MUS_OK);
        const double y = mus_drape_positions(g.drape)[1];
        if (k < 2)
            ck_assert_double_eq_tol(y, place[1] - 0.5 * 9.81 * 0.09, 1e-9);
        else
            ck_assert_double_eq_tol(y, 0.002, 1e-9);
    }
    ground_end(&g);
}
END_TEST


/* settled and stepped, in float and double: flat on the ground, nothing below it, carried by its weight */
START_TEST(cloth_comes_to_lie_on_the_ground)
{
    ground g = ground_start(1);
    g.def.precision = _i ? 64 : 32;
    ground_drape(&g);
    ground_add(&g, NULL);
    ground_place(&g, 0.05, 0.0, 0.0);
    const mus_status status = mus_drape_settle(g.drape, NULL, NULL);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(g.context));
    ck_assert_double_le(ground_report(&g).residual, 0.02);
    ck_assert_int_eq(mus_drape_step(g.drape, 500, 0.9 * mus_drape_step_bound(g.drape)), MUS_OK);
    for (int i = 0; i < NODES; i++) ck_assert_double_eq_tol(mus_drape_positions(g.drape)[3 * i + 1], 0.002, 5e-6);
    ck_assert_double_le(ground_report(&g).max_penetration, 0.0);
    ground_end(&g);
}
END_TEST


/* cloth that sticks to an incline does not move, to the last bit */
START_TEST(what_sticks_on_an_incline_does_not_creep)
{
    ground g = ground_start(1);
    const mus_plane plane = ground_plane(0.0, 0.0, sin(0.2), cos(0.2));
    double x[3 * NODES], first[3 * NODES];
    g.def.precision = _i % 2 ? 64 : 32;
    g.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    ground_drape(&g);
    ground_add(&g, &plane);
    for (int i = 0; i < NODES; i++) {
        const double along = 0.02 * (i % SIDE);
        x[3 * i] = 0.002 * sin(0.2) + along * cos(0.2), x[3 * i + 1] = 0.002 * cos(0.2) - along * sin(0.2);
        x[3 * i + 2] = 0.02 * (i / SIDE);
    }
    ck_assert_int_eq(mus_drape_set_state(g.drape, x, NULL), MUS_OK);
    const double h = 0.9 * mus_drape_step_bound(g.drape);
    ck_assert_int_eq(mus_drape_step(g.drape, 2000, h), MUS_OK);
    memcpy(first, mus_drape_positions(g.drape), sizeof first);
    ck_assert_int_eq(mus_drape_step(g.drape, 4000, h), MUS_OK);
    ck_assert_mem_eq(mus_drape_positions(g.drape), first, sizeof first);
    for (int i = 0; i < 3 * NODES; i++) ck_assert_double_eq_tol(first[i], x[i], 2e-6);
    ground_end(&g);
}
END_TEST


/* a node between a ground and a wall that lean towards it lies where both allow it */
START_TEST(a_groove_holds_what_falls_into_it)
{
    ground g = ground_start(0);
    const double lean = 0.6, place[3] = {0.03, 0.3, 0.0};
    const mus_plane left = ground_plane(0.0, 0.0, cos(lean), sin(lean)),
                    right = ground_plane(0.0, 0.0, -cos(lean), sin(lean));
    g.def.precision = _i ? 64 : 32;
    g.def.drag = 2.0;
    ground_drape(&g);
    ground_add(&g, &left);
    ground_add(&g, &right);
    ck_assert_int_eq(mus_drape_set_state(g.drape, place, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(g.drape, 6000, 1e-3), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(g.drape)[0], 0.0, 1e-5);
    ck_assert_double_eq_tol(mus_drape_positions(g.drape)[1], 0.002 / sin(lean), 1e-5);
    ck_assert_double_eq_tol(mus_drape_velocities(g.drape)[1], 0.0, 1e-6);
    ground_end(&g);
}
END_TEST


/* between two plates nearer to each other than two clearances: the middle, at rest, whichever came first */
START_TEST(a_gap_too_narrow_holds_cloth_in_its_middle)
{
    ground g = ground_start(1);
    g.def.precision = _i % 2 ? 64 : 32;
    const mus_plane low = ground_plane(0.0, 0.0, 0.0, 1.0),
                    high = ground_plane(0.0, _i / 4 ? -0.001 : 0.002, 0.0, -1.0);
    const double middle = 0.5 * high.point[1];
    ground_drape(&g);
    ground_add(&g, _i / 2 % 2 ? &low : &high);
    ground_add(&g, _i / 2 % 2 ? &high : &low);
    ground_place(&g, middle + 4e-4, 0.0, 0.0);
    const double h = 0.9 * mus_drape_step_bound(g.drape);
    for (int k = 0; k < 20; k++) {
        ck_assert_int_eq(mus_drape_step(g.drape, 50, h), MUS_OK);
        for (int i = 0; i < NODES; i++) ck_assert_double_eq_tol(mus_drape_positions(g.drape)[3 * i + 1], middle, 2e-7);
        ck_assert_double_le(ground_report(&g).max_speed, 1e-4);
    }
    ground_end(&g);
}
END_TEST


/* two plates that close on a cloth at 1 m/s: it is driven to the middle and never jumps */
START_TEST(plates_that_close_do_not_throw_cloth)
{
    ground g = ground_start(1);
    mus_plane low = ground_plane(0.0, 0.0, 0.0, 1.0), high = ground_plane(0.0, 0.1, 0.0, -1.0);
    low.velocity[1] = 0.5, high.velocity[1] = -0.5;
    ground_drape(&g);
    ground_add(&g, &low);
    ground_add(&g, &high);
    ground_place(&g, 0.03, 0.0, 0.0);
    const double h = 0.5 * mus_drape_step_bound(g.drape);
    while (mus_drape_time(g.drape) < 0.1) {
        ck_assert_int_eq(mus_drape_step(g.drape, 20, h), MUS_OK);
        ck_assert_double_le(ground_report(&g).max_speed, 1.2);
    }
    for (int i = 0; i < NODES; i++) ck_assert_double_eq_tol(mus_drape_positions(g.drape)[3 * i + 1], 0.05, 2e-4);
    ground_end(&g);
}
END_TEST


/* swallowed by 5 cm it leaves at 1 m/s at most */
START_TEST(cloth_below_the_ground_comes_up_slowly)
{
    ground g = ground_start(1);
    ground_drape(&g);
    ground_add(&g, NULL);
    ground_place(&g, -0.05, 0.0, 0.0);
    const double h = 0.9 * mus_drape_step_bound(g.drape);
    double last = -0.05;
    for (int k = 0; k * h < 0.08; k++) {
        ck_assert_int_eq(mus_drape_step(g.drape, 1, h), MUS_OK);
        const double y = mus_drape_positions(g.drape)[1];
        ck_assert_double_le(y - last, 1.01 * h);
        ck_assert_double_le(ground_report(&g).max_speed, 0.1);
        last = y;
    }
    ck_assert_double_eq_tol(last, 0.002, 1e-9);
    ground_end(&g);
}
END_TEST


/* a cloth on a plate that goes anywhere is the cloth on a plate at rest, moved */
START_TEST(a_plane_and_its_cloth_may_move_together)
{
    ground g = ground_start(1);
    static const double speed[3] = {3.0, -2.0, 5.0};
    double v[3 * NODES], at_rest[3 * NODES];
    for (int moves = 0; moves < 2; moves++) {
        mus_plane plane = ground_plane(0.0, 0.0, sin(0.1), cos(0.1));
        memcpy(plane.velocity, speed, moves ? sizeof speed : 0);
        ground_drape(&g);
        ground_add(&g, &plane);
        ground_place(&g, 0.03, 0.0, 0.0);
        for (int i = 0; i < 3 * NODES; i++) v[i] = moves ? speed[i % 3] : 0.0;
        memcpy(at_rest, moves ? at_rest : mus_drape_positions(g.drape), sizeof at_rest);
        double start[3 * NODES];
        memcpy(start, mus_drape_positions(g.drape), sizeof start);
        ck_assert_int_eq(mus_drape_set_state(g.drape, start, v), MUS_OK);
        ck_assert_int_eq(mus_drape_step(g.drape, 1500, 2e-4), MUS_OK);
        if (!moves) memcpy(at_rest, mus_drape_positions(g.drape), sizeof at_rest);
    }
    for (int i = 0; i < 3 * NODES; i++)
        ck_assert_double_eq_tol(mus_drape_positions(g.drape)[i], at_rest[i] + 0.3 * speed[i % 3], 1e-9);
    ground_end(&g);
}
END_TEST


START_TEST(threads_do_not_matter_on_planes)
{
    uint64_t hash[3];
    for (int k = 0; k < 3; k++) {
        ground g = ground_start(1);
        mus_plane plane = ground_plane(0.05, 0.0, 0.1, 1.0);
        plane.spin = 8.0, plane.velocity[1] = 1.0, plane.reach = 0.15;
        g.def.precision = _i % 2 ? 64 : 32;
        g.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
        g.def.threads = 1 + k;
        ground_drape(&g);
        ground_add(&g, &plane);
        ground_place(&g, 0.2, 0.0, -30.0);
        ck_assert_int_eq(mus_drape_step(g.drape, 300, 0.5 * mus_drape_step_bound(g.drape)), MUS_OK);
        hash[k] = mus_drape_hash(g.drape);
        ck_assert_double_gt(ground_report(&g).contact_impulse[1], 0.0);
        ground_end(&g);
    }
    ck_assert_uint_eq(hash[0], hash[1]);
    ck_assert_uint_eq(hash[0], hash[2]);
}
END_TEST


/* place brings a plane back to how it was added; sewing and settling want it at rest */
START_TEST(a_plane_is_put_back_by_place)
{
    ground g = ground_start(1);
    const double up[3] = {0.0, 1.0, 0.0};
    int32_t index = -1;
    ground_drape(&g);
    ck_assert_int_eq(mus_drape_add_plane(g.drape, NULL, &index), MUS_OK);
    ck_assert_int_eq(index, 0);
    ground_place(&g, 0.3, 0.0, 0.0);
    ck_assert_int_eq(mus_drape_move_plane(g.drape, 0, up, 2.0), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(g.drape, NULL, NULL), MUS_ERR_STATE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(g.context), "plane"));
    ck_assert_int_eq(mus_drape_step(g.drape, 1000, 2e-4), MUS_OK);
    ck_assert_double_ge(mus_drape_positions(g.drape)[1], 0.2);
    ck_assert_int_eq(mus_drape_place(g.drape), MUS_OK);
    ground_place(&g, 0.1, 0.0, 0.0);
    ck_assert_int_eq(mus_drape_settle(g.drape, NULL, NULL), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(g.drape)[1], 0.002, 5e-6);
    ground_end(&g);
}
END_TEST


/* contact by remembered planes forgets them when a plane is added or has moved */
START_TEST(what_nodes_remember_is_forgotten_when_a_plane_moves)
{
    ground g = ground_start(1);
    const double up[3] = {0.0, 0.5, 0.0}, none[3] = {0.0, 0.0, 0.0};
    g.def.contact_ball = 0.001;
    ground_drape(&g);
    ground_add(&g, NULL);
    ground_place(&g, 0.0025, 0.0, 0.0);
    const double h = 2e-4;
    ck_assert_int_eq(mus_drape_step(g.drape, 500, h), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(g.drape)[1], 0.002, 1e-6);
    ck_assert_int_eq(mus_drape_move_plane(g.drape, 0, up, 0.0), MUS_OK);
    ck_assert_int_eq(mus_drape_step(g.drape, 100, h), MUS_OK);
    ck_assert_int_eq(mus_drape_move_plane(g.drape, 0, none, 0.0), MUS_OK);
    ck_assert_int_eq(mus_drape_step(g.drape, 1500, h), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(g.drape)[1], 0.012, 1e-6);
    ground_end(&g);
}
END_TEST


START_TEST(adding_a_plane_fails_clean)
{
    for (int64_t n = 0;; n++) {
        ground g = ground_start(1);
        g.def.contact_ball = 2e-4;
        ground_drape(&g);
        const uint64_t hash = mus_drape_hash(g.drape);
        support_fail_after(n, false);
        const mus_status status = mus_drape_add_plane(g.drape, NULL, NULL);
        support_fail_never();
        ck_assert(status == MUS_OK || status == MUS_ERR_MEMORY);
        ck_assert_uint_eq(mus_drape_hash(g.drape), hash);
        ck_assert_int_eq(mus_drape_step(g.drape, 1, 1e-5), MUS_OK);
        ck_assert_int_eq(mus_drape_add_plane(g.drape, NULL, NULL), MUS_OK);
        ground_end(&g);
        if (status == MUS_OK) break;
    }
    ground g = ground_start(0);
    ground_drape(&g);
    for (int k = 0; k < 32; k++) ck_assert_int_eq(mus_drape_add_plane(g.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_add_plane(g.drape, NULL, NULL), MUS_ERR_LIMIT);
    ground_end(&g);
}
END_TEST


/* the query of contact: over an incline its height and normal, far from it nothing */
START_TEST(depth_is_the_height_over_the_plane)
{
    ground g = ground_start(0);
    ground_drape(&g);
    const mus_plane plane = ground_plane(0.1, 0.2, 0.6, 0.8);
    double depth[4], normal[12];
    const double up = 0.01, down = -0.02;
    const double points[12] = {0.1 + 0.6 * up,
                               0.2 + 0.8 * up,
                               0.5,
                               0.1 + 0.6 * down,
                               0.2 + 0.8 * down,
                               0.0,
                               0.1 + 0.8,
                               0.2 - 0.6,
                               7.0,
                               0.7,
                               1.0,
                               0.0};
    ck_assert_int_eq(mus_drape_depth(g.drape, 4, points, depth, normal), MUS_OK);
    for (int i = 0; i < 4; i++) ck_assert(depth[i] == -1e30 && normal[3 * i + 1] == 0.0);
    ck_assert_int_eq(mus_drape_add_plane(g.drape, &plane, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_depth(g.drape, 4, points, depth, normal), MUS_OK);
    const double exact[3] = {-up, -down, 0.0};
    for (int i = 0; i < 3; i++) {
        ck_assert_double_eq_tol(depth[i], exact[i], 1e-15);
        ck_assert(normal[3 * i] == 0.6 && normal[3 * i + 1] == 0.8 && normal[3 * i + 2] == 0.0);
    }
    ck_assert(depth[3] == -1e30);
    ck_assert_int_eq(mus_drape_depth(g.drape, 0, points, depth, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_depth(g.drape, -1, points, depth, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_depth(g.drape, 1, NULL, depth, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_depth(NULL, 1, points, depth, NULL), MUS_ERR_ARG);
    const double bad[3] = {0.0, NAN, 0.0};
    ck_assert_int_eq(mus_drape_depth(g.drape, 1, bad, depth, NULL), MUS_ERR_ARG);
    ground_end(&g);
}
END_TEST


Suite *mus_suite_scene_plane(void)
{
    Suite *suite = suite_create("scene_plane");
    TCase *tests = tcase_create("scene_plane");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, a_plane_out_of_reach_changes_no_byte, 0, 4);
    tcase_add_loop_test(tests, no_bullet_passes_a_plane, 0, 4);
    tcase_add_test(tests, a_disc_ends);
    tcase_add_loop_test(tests, cloth_comes_to_lie_on_the_ground, 0, 2);
    tcase_add_loop_test(tests, what_sticks_on_an_incline_does_not_creep, 0, 4);
    tcase_add_loop_test(tests, a_groove_holds_what_falls_into_it, 0, 2);
    tcase_add_loop_test(tests, a_gap_too_narrow_holds_cloth_in_its_middle, 0, 8);
    tcase_add_test(tests, plates_that_close_do_not_throw_cloth);
    tcase_add_test(tests, cloth_below_the_ground_comes_up_slowly);
    tcase_add_test(tests, a_plane_and_its_cloth_may_move_together);
    tcase_add_loop_test(tests, threads_do_not_matter_on_planes, 0, 4);
    tcase_add_test(tests, a_plane_is_put_back_by_place);
    tcase_add_test(tests, what_nodes_remember_is_forgotten_when_a_plane_moves);
    tcase_add_test(tests, adding_a_plane_fails_clean);
    tcase_add_test(tests, depth_is_the_height_over_the_plane);
    suite_add_tcase(suite, tests);
    return suite;
}
