/*
 * layers.c: times self-contact: the T-shirt W40 at 15 mm, with self-contact and without it.
 *
 * The two are stepped in turns, one frame of 20 ms each, so that other work of the machine slows both down alike; the
 * figure is the median over the frames of the ratio of CPU times. Fall: after sewing, onto the shoulders. Walk: then
 * the body begins to walk. Rest: settled. All steps have the same length.
 */
#include <math.h>
#include <stdlib.h>

#include "bench.h"

#define FRAME 0.02 /* [s] */
#define FALL 15    /* frames */
#define EASE 25
#define WALK 50
#define REST 10
#define SPACING 0.015
#define STATURE 1.68 /* [m] stature for which the walk is made */
#define SAFETY 0.8 /* step over the step bound at rest; below 1, since the bound falls while cloth is shaken */

/* the drape without self-contact and the one with it */
typedef struct layers_pair {
    mus_drape *drape[2];
    double ratio[EASE + WALK], cpu[2];
    int32_t count, steps;
} layers_pair;


static int layers_ascending(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}


/* Steps one frame of both drapes. */
static mus_status layers_frame(layers_pair *p)
{
    mus_status status = MUS_OK;
    double took[2] = {0.0, 0.0};
    const double bound = fmin(mus_drape_step_bound(p->drape[0]), mus_drape_step_bound(p->drape[1]));
    const int32_t steps = (int32_t)ceil(FRAME / (SAFETY * bound));
    for (int32_t i = 0; i < 2 && status == MUS_OK; i++) {
        const int32_t k = (i + p->count) % 2;
        const double start = bench_cpu();
        status = mus_drape_step(p->drape[k], steps, FRAME / steps);
        took[k] = bench_cpu() - start;
        p->cpu[k] += took[k];
    }
    p->ratio[p->count++] = took[1] / took[0];
    p->steps += steps;
    return status;
}


static void layers_write(bench *b, const char *name, layers_pair *p, const mus_cloth *cloth)
{
    for (int32_t k = 0; k < 2; k++) {
        bench_row row = bench_row_start(k == 0 ? name : "  with layers", 32, 1);
        row.nodes = mus_cloth_node_count(cloth);
        row.springs = mus_cloth_spring_count(cloth);
        row.cpu_s = row.wall_s = p->cpu[k];
        row.evaluations = p->steps;
        row.step = FRAME * p->count / p->steps;
        row.cpu_frame_ms = 1e3 * p->cpu[k] / p->count;
        if (k == 1) {
            qsort(p->ratio, (size_t)p->count, sizeof p->ratio[0], layers_ascending);
            row.over_off = p->ratio[p->count / 2];
        }
        bench_row_write(b, &row);
    }
    p->count = p->steps = 0;
    p->cpu[0] = p->cpu[1] = 0.0;
}


/* Moves both bodies into a pose within one frame. */
static mus_status layers_pose(layers_pair *p, const mus_pose *pose)
{
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < 2 && status == MUS_OK; k++) status = mus_drape_pose_body(p->drape[k], pose, FRAME);
    return status;
}


/* Moves from the rest pose into the first pose of the movement, then through the movement. */
static mus_status layers_walk(bench *b, layers_pair *p)
{
    mus_move *move = NULL;
    mus_pose first, from, now;
    mus_pose_init(&first, sizeof first);
    mus_pose_init(&from, sizeof from);
    mus_status status = mus_move_named(b->context, "walk", STATURE, &move);
    if (status == MUS_OK) status = mus_drape_body_pose(p->drape[0], &from);
    if (status == MUS_OK) status = mus_move_at(move, 0.0, &first);
    now = first;
    for (int32_t f = 0; f < EASE + WALK && status == MUS_OK; f++) {
        const double u = fmin((f + 1.0) / EASE, 1.0), w = u * u * (3.0 - 2.0 * u);
        if (f >= EASE) status = mus_move_at(move, FRAME * (f - EASE + 1), &now);
        for (int i = 0; i < 3 && f < EASE; i++) {
            now.place[i] = from.place[i] + w * (first.place[i] - from.place[i]);
            for (int j = 0; j < MUS_JOINT_COUNT; j++)
                now.angle[j][i] = from.angle[j][i] + w * (first.angle[j][i] - from.angle[j][i]);
        }
        if (status == MUS_OK) status = layers_pose(p, &now);
        if (status == MUS_OK) status = layers_frame(p);
    }
    mus_move_destroy(move);
    return status;
}


static mus_status layers_start(bench *b, const mus_cloth *cloth, const mus_body *body, int32_t method, layers_pair *p)
{
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < 2 && status == MUS_OK; k++) {
        mus_drape_def def;
        mus_drape_def_init(&def, sizeof def);
        def.integrator = method;
        def.self_contact = k;
        status = mus_drape_create(b->context, cloth, body, &def, &p->drape[k]);
        if (status == MUS_OK) status = mus_drape_place(p->drape[k]);
        if (status == MUS_OK) status = mus_drape_sew(p->drape[k], NULL, NULL);
    }
    return status;
}


static mus_status layers_run(bench *b, const mus_cloth *cloth, const mus_body *body, int32_t method)
{
    static const char *const names[2][3] = {{"fall_rk4", "walk_rk4", "rest_rk4"},
                                            {"fall_verlet", "walk_verlet", "rest_verlet"}};
    const char *const *name = names[method == MUS_METHOD_VERLET];
    layers_pair p = {{NULL, NULL}, {0.0}, {0.0, 0.0}, 0, 0};
    mus_status status = layers_start(b, cloth, body, method, &p);
    for (int32_t f = 0; f < FALL && status == MUS_OK; f++) status = layers_frame(&p);
    if (status == MUS_OK) layers_write(b, name[0], &p, cloth);
    if (status == MUS_OK) status = layers_walk(b, &p);
    if (status == MUS_OK) layers_write(b, name[1], &p, cloth);
    for (int32_t k = 0; k < 2 && status == MUS_OK; k++) {
        status = mus_drape_place(p.drape[k]);
        if (status == MUS_OK) status = mus_drape_sew(p.drape[k], NULL, NULL);
        if (status == MUS_OK) status = mus_drape_settle(p.drape[k], NULL, NULL);
        if (status == MUS_ERR_UNSETTLED) status = MUS_OK;
    }
    for (int32_t f = 0; f < REST && status == MUS_OK; f++) status = layers_frame(&p);
    if (status == MUS_OK) layers_write(b, name[2], &p, cloth);
    mus_drape_destroy(p.drape[0]);
    mus_drape_destroy(p.drape[1]);
    return status;
}


mus_status bench_layers(bench *b)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *tshirt = NULL;
    mus_cloth *cloth = NULL;
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = SPACING;
    mus_status status = mus_tape_create(b->context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(b->context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(b->context, mus_design_find("tshirt"), tape, NULL, &tshirt);
    if (status == MUS_OK) status = mus_cloth_create(b->context, tshirt, &cut, &cloth);
    if (status == MUS_OK) status = layers_run(b, cloth, body, MUS_METHOD_RK4);
    if (status == MUS_OK) status = layers_run(b, cloth, body, MUS_METHOD_VERLET);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(tshirt);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    return status;
}
