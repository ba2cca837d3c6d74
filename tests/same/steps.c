/*
 * steps.c: rows "steps/...": cloth stepped by mus_drape_step round bodies that stand or glide, among planes, with tacks
 * and pins, from another state.
 *
 * A scene is placed and sewn first; then something is done to it and it is stepped. moved.c has bodies in motion.
 */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#define STEPS 40

/* ---- what is done to a scene that was sewn ---- */

/* `steps` steps of nine tenths of the bound */
static void step_on(same_run *run, const same_dressed *d, int32_t steps)
{
    same_status(run, mus_drape_step(d->drape, steps, 0.9 * mus_drape_step_bound(d->drape)));
}


static void just_step(same_run *run, const same_dressed *d)
{
    step_on(run, d, STEPS);
}


static int32_t add_plane(same_run *run, const same_dressed *d, double height, double reach)
{
    int32_t index = MUS_NONE;
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    plane.point[1] = height;
    plane.reach = reach;
    plane.friction = 0.3;
    same_must(run, mus_drape_add_plane(d->drape, &plane, &index), "mus_drape_add_plane");
    return index;
}


static void on_planes(same_run *run, const same_dressed *d)
{
    add_plane(run, d, 0.7, 0.0);
    add_plane(run, d, 0.75, 0.2);
    same_must(run, mus_drape_add_plane(d->drape, NULL, NULL), "the ground");
    same_step_seconds(run, d, 0.1);
}


static void on_moving_planes(same_run *run, const same_dressed *d)
{
    const double up[3] = {0.1, 0.5, 0.0};
    const int32_t table = add_plane(run, d, 0.7, 0.0), turning = add_plane(run, d, 0.72, 0.25);
    same_must(run, mus_drape_move_plane(d->drape, table, up, 0.0), "mus_drape_move_plane");
    same_must(run, mus_drape_move_plane(d->drape, turning, up, 3.0), "mus_drape_move_plane");
    same_step_seconds(run, d, 0.1);
}


static void tacked(same_run *run, const same_dressed *d)
{
    const int32_t n = mus_drape_node_count(d->drape);
    int32_t first = MUS_NONE, second = MUS_NONE;
    same_status(run, mus_drape_tack(d->drape, 0, n / 2, 50.0, &first));
    same_status(run, mus_drape_tack(d->drape, n / 3, n - 1, 200.0, &second));
    step_on(run, d, STEPS);
    same_status(run, mus_drape_untack(d->drape, first));
    step_on(run, d, STEPS);
    same_int(run, 100 * first + second);
}


static void pinned(same_run *run, const same_dressed *d)
{
    const double sideways[3] = {3.0, -9.0, 1.0};
    same_must(run, mus_drape_pin(d->drape, 0, 1), "mus_drape_pin");
    same_must(run, mus_drape_pin(d->drape, 5, 1), "mus_drape_pin");
    same_must(run, mus_drape_set_gravity(d->drape, sideways), "mus_drape_set_gravity");
    step_on(run, d, STEPS);
    same_must(run, mus_drape_pin(d->drape, 5, 0), "mus_drape_pin");
    step_on(run, d, STEPS);
}


static void gliding(same_run *run, const same_dressed *d)
{
    const double velocity[3] = {0.2, 0.0, 0.5};
    same_must(run, mus_drape_move_body(d->drape, velocity), "mus_drape_move_body");
    same_step_seconds(run, d, 0.08);
}


/* Hashes the estimated cost of a run without its seconds, and the state after force evaluations, which is the same. */
static void forecast(same_run *run, const same_dressed *d)
{
    mus_estimate plan;
    mus_estimate_init(&plan, sizeof plan);
    if (same_status(run, mus_drape_estimate(d->drape, 1.0 / 60.0, &plan))) {
        const double values[] = {plan.step, plan.step_bound, plan.node_mass, plan.node_stiffness, plan.bend_share};
        same_reals(run, values, sizeof values / sizeof *values);
        same_int(run, plan.steps_per_frame);
        same_int(run, plan.node);
        same_int(run, plan.node_evaluations);
    }
    same_status(run, mus_drape_evaluate(d->drape, 3));
    same_status(run, mus_drape_step(d->drape, 1, 2.0 * mus_drape_step_bound(d->drape)));
}


/* places moved by a wave and thrown upwards */
static void thrown(same_run *run, const same_dressed *d)
{
    const int32_t n = 3 * mus_drape_node_count(d->drape);
    double *x = malloc(sizeof *x * 2 * (size_t)n);
    if (x == NULL) same_must(run, MUS_ERR_MEMORY, "thrown");
    memcpy(x, mus_drape_positions(d->drape), sizeof *x * (size_t)n);
    for (int32_t i = 0; i < n; i++) {
        x[i] += 0.0001 * (i % 7);
        x[n + i] = i % 3 == 1 ? 0.5 : 0.01 * (i % 5);
    }
    same_status(run, mus_drape_set_state(d->drape, x, x + n));
    step_on(run, d, STEPS);
    free(x);
}


static void untangled(same_run *run, const same_dressed *d)
{
    int64_t left = -1;
    thrown(run, d);
    same_status(run, mus_drape_untangle(d->drape, &left));
    same_int(run, left);
}


static const same_stepped rows[] = {
    {"rk4-float", {NULL, "skirt", "W40", 30, 0, NULL}, just_step},
    {"rk4-double", {NULL, "skirt", "W40", 30, SCENE_DOUBLE, NULL}, just_step},
    {"verlet-float", {NULL, "skirt", "W40", 30, SCENE_VERLET, NULL}, just_step},
    {"verlet-double", {NULL, "skirt", "W40", 30, SCENE_VERLET | SCENE_DOUBLE, NULL}, just_step},
    {"self-rk4", {NULL, "tshirt", "W40", 30, SCENE_SELF, NULL}, just_step},
    {"self-verlet-double", {NULL, "tshirt", "W40", 30, SCENE_SELF | SCENE_VERLET | SCENE_DOUBLE, NULL}, just_step},
    {"paper-springs", {NULL, "tshirt", "W40", 30, SCENE_PAPER, NULL}, just_step},
    {"ball", {NULL, "tshirt", "W40", 30, SCENE_BALL, NULL}, just_step},
    {"planes-float", {NULL, "skirt", "W40", 30, 0, NULL}, on_planes},
    {"planes-double", {NULL, "skirt", "W40", 30, SCENE_DOUBLE | SCENE_VERLET, NULL}, on_planes},
    {"moving-planes", {NULL, "skirt", "W40", 30, 0, NULL}, on_moving_planes},
    {"moving-planes-self", {NULL, "skirt", "W40", 30, SCENE_SELF | SCENE_DOUBLE, NULL}, on_moving_planes},
    {"tacks-float", {NULL, "tshirt", "W40", 30, 0, NULL}, tacked},
    {"tacks-double", {NULL, "tshirt", "W40", 30, SCENE_DOUBLE, NULL}, tacked},
    {"tacks-self", {NULL, "tshirt", "W40", 30, SCENE_SELF | SCENE_VERLET, NULL}, tacked},
    {"pins", {NULL, "tshirt", "W40", 30, 0, NULL}, pinned},
    {"glide", {NULL, "tshirt", "W40", 30, 0, NULL}, gliding},
    {"glide-double-verlet", {NULL, "skirt", "W40", 30, SCENE_DOUBLE | SCENE_VERLET, NULL}, gliding},
    {"forecast-rk4", {NULL, "jeans", "W40", 40, 0, "denim"}, forecast},
    {"forecast-verlet", {NULL, "tshirt", "W40", 30, SCENE_VERLET | SCENE_DOUBLE, NULL}, forecast},
    {"thrown", {NULL, "skirt", "W40", 30, 0, NULL}, thrown},
    {"thrown-self", {NULL, "skirt", "W40", 30, SCENE_SELF, NULL}, thrown},
    {"untangled", {NULL, "half_skirt_knee", "W40", 40, SCENE_SELF, NULL}, untangled},
};


/* one and two threads: the row fails where their states differ */
static void make_threads(same_run *run, const void *what, int32_t index)
{
    (void)index;
    same_stepped row = *(const same_stepped *)what;
    const same_dressed one = same_stepped_scene(run, &row);
    row.scene.flags |= SCENE_TWO;
    const same_dressed two = same_stepped_scene(run, &row);
    if (mus_drape_hash(one.drape) != mus_drape_hash(two.drape))
        same_must(run, MUS_ERR_STATE, "two threads give another state than one");
    same_drape(run, one.drape, one.cloth);
}


void same_steps(same_list *list)
{
    static const same_stepped threads[] = {
        {"threads-float", {NULL, "tshirt", "W40", 20, 0, NULL}, just_step},
        {"threads-self", {NULL, "skirt", "W40", 25, SCENE_SELF | SCENE_DOUBLE, NULL}, thrown},
        {"threads-glide", {NULL, "tshirt", "W40", 30, SCENE_VERLET, NULL}, gliding},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        same_add(list, same_make_stepped, "steps/%s", rows[i].name)->what = &rows[i];
    for (size_t i = 0; i < sizeof threads / sizeof *threads; i++)
        same_add(list, make_threads, "steps/%s", threads[i].name)->what = &threads[i];
}
