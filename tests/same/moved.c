/*
 * moved.c: rows "moved/...": bodies that go into poses and walk while cloth is stepped on them; and a garment put on
 * once more: placed again, cut finer, or on another body.
 *
 * A scene is placed and sewn first, as in steps.c.
 */
#include "scene.h"

/* the depth of a lattice of points in what the cloth collides with */
static void depths(same_run *run, const same_dressed *d)
{
    double points[3 * 512], depth[512], normal[3 * 512];
    for (int i = 0; i < 512; i++) {
        points[3 * i] = 0.08 * (i % 8 - 3.5);
        points[3 * i + 1] = 0.05 + 0.2 * (i / 8 % 8);
        points[3 * i + 2] = 0.06 * (i / 64 - 3.5);
    }
    same_status(run, mus_drape_depth(d->drape, 512, points, depth, normal));
    same_reals(run, depth, 512);
    same_reals(run, normal, 3 * 512);
}


/* ---- poses and movements ---- */

/* on the way to a named pose in 0.3 s, at rest in it, and what the drape says of it */
static void pose_named(same_run *run, const same_dressed *d, const char *name)
{
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    same_must(run, mus_pose_named(run->context, name, &pose), name);
    same_must(run, mus_body_clear_arms(d->body, &pose, 0.02), name);
    same_must(run, mus_body_stand(d->body, mus_pose_feet(name), &pose), name);
    same_must(run, mus_drape_pose_body(d->drape, &pose, 0.3), name);
    same_step_seconds(run, d, 0.3);
    if (same_status(run, mus_drape_body_pose(d->drape, &pose)))
        same_reals(run, &pose.angle[0][0], 3 * MUS_JOINT_COUNT);
    depths(run, d);
}


static void sit(same_run *run, const same_dressed *d)
{
    pose_named(run, d, "sit");
}


static void squat(same_run *run, const same_dressed *d)
{
    pose_named(run, d, "squat");
}


static void raise_arms(same_run *run, const same_dressed *d)
{
    pose_named(run, d, "arms_raised");
    same_status(run, mus_drape_settle(d->drape, NULL, NULL));
}


static void twist(same_run *run, const same_dressed *d)
{
    pose_named(run, d, "twist");
}


/* a quarter of a second of a walk, pose after pose */
static void walk(same_run *run, const same_dressed *d)
{
    mus_move *move = NULL;
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    same_must(run, mus_body_move(d->body, "walk", 0.02, &move), "mus_body_move");
    for (int i = 0; i < 15; i++) {
        same_must(run, mus_move_at(move, i / 60.0, &pose), "mus_move_at");
        same_must(run, mus_drape_pose_body(d->drape, &pose, 1.0 / 60.0), "mus_drape_pose_body");
        same_step_seconds(run, d, 1.0 / 60.0);
    }
    mus_move_destroy(move);
}


/* ---- the same garment once more ---- */

/* a finer cut of the same pattern begins where the first one hangs */
static void refit(same_run *run, const same_dressed *d)
{
    const same_scene finer = {NULL, NULL, NULL, 25, 0, "cotton"};
    same_dressed again = *d;
    same_status(run, mus_drape_settle(d->drape, NULL, NULL));
    same_cut_out(run, &finer, &again);
    same_status(run, mus_drape_warm(again.drape, d->drape));
    same_drape(run, again.drape, again.cloth);
    same_status(run, mus_drape_settle(again.drape, NULL, NULL));
    same_drape(run, again.drape, again.cloth);
}


/* the same on the body of another size */
static void refit_body(same_run *run, const same_dressed *d)
{
    const same_scene other = {NULL, NULL, NULL, 30, 0, NULL};
    same_dressed again = *d;
    same_status(run, mus_drape_settle(d->drape, NULL, NULL));
    again.body = same_body(run, same_size(run, "W42"));
    same_cut_out(run, &other, &again);
    same_status(run, mus_drape_warm(again.drape, d->drape));
    same_status(run, mus_drape_settle(again.drape, NULL, NULL));
    same_drape(run, again.drape, again.cloth);
}


/* placed and sewn again: the second run is the first */
static void again(same_run *run, const same_dressed *d)
{
    same_step_seconds(run, d, 0.02);
    same_must(run, mus_drape_place(d->drape), "mus_drape_place");
    same_wear(run, d);
}


static const same_stepped rows[] = {
    {"walk-ball-double", {NULL, "tshirt", "W40", 30, SCENE_BALL | SCENE_DOUBLE | SCENE_VERLET, NULL}, walk},
    {"depths", {NULL, "skirt", "W40", 40, 0, NULL}, depths},
    {"pose-sit", {NULL, "skirt", "W40", 40, 0, NULL}, sit},
    {"pose-squat", {NULL, "straight_trousers", "W40", 50, SCENE_VERLET, NULL}, squat},
    {"pose-arms-raised", {NULL, "tshirt", "W40", 40, 0, NULL}, raise_arms},
    {"pose-arms-raised-self", {NULL, "tshirt", "W40", 40, SCENE_SELF | SCENE_VERLET, NULL}, raise_arms},
    {"pose-twist", {NULL, "tshirt", "M50", 40, SCENE_DOUBLE, NULL}, twist},
    {"walk", {NULL, "skirt", "W40", 40, 0, NULL}, walk},
    {"walk-self", {NULL, "tshirt", "M50", 40, SCENE_SELF | SCENE_VERLET, NULL}, walk},
    {"refit", {NULL, "tshirt", "W40", 40, 0, NULL}, refit},
    {"refit-body", {NULL, "skirt", "W40", 40, SCENE_DOUBLE, NULL}, refit_body},
    {"again", {NULL, "tshirt", "W40", 40, SCENE_SELF, NULL}, again},
};


void same_moved(same_list *list)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        same_add(list, same_make_stepped, "moved/%s", rows[i].name)->what = &rows[i];
}
