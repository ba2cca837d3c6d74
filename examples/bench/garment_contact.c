/*
 * garment_contact.c: times contact a node of a worn garment in a step, and a tree of boxes for the same nodes.
 *
 * A T-shirt W40 is settled on its body and led into a walk. Its nodes, with their positions and velocities at that
 * moment, are then stepped without springs, at the garment's own step, once on a body at rest and once while it walks
 * on. The time of contact is that of these steps less that of the same steps without a body; it includes the placing of
 * the parts, the choice of the parts to query, distances and response. The tree is built over the drawn surface of
 * about 20,000 triangles in the same pose. It is queried for the closest point to each node after each of the steps:
 * from its root, and from the triangle that was nearest after the step before, since contact has a cache too. The tree
 * does not move with the body; refitting it in each step would cost it more.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "triangle_tree.h"

#define WORN_REPEATS 7
#define WORN_STEPS 40
#define WORN_RATE 60.0     /* frames a second */
#define WORN_EASE 45       /* frames of the change from the rest pose into the walk */
#define WORN_SPACING 0.010 /* [m] spacing of the T-shirt */
#define WORN_GAP 0.02      /* [m] distance of the arms from the sides */

/* a garment on a body, and the present frame of its movement */
typedef struct worn {
    mus_body *body;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_move *move;
    mus_pose now, next; /* poses at the beginning and the end of the frame */
    double step;
    double *place, *velocity; /* (nodes x 3) at the beginning of the frame [m], [m/s] */
} worn;


static mus_status worn_dress(bench *b, worn *w)
{
    mus_tape *tape = NULL;
    mus_pattern *pattern = NULL;
    mus_body_def surface;
    mus_cloth_def cut;
    mus_body_def_init(&surface, sizeof surface);
    surface.samples = 48, surface.ring_spacing = 0.05;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = WORN_SPACING;
    mus_status status = mus_tape_create(b->context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(b->context, tape, &surface, &w->body);
    if (status == MUS_OK) status = mus_design_draft(b->context, mus_design_find("tshirt"), tape, NULL, &pattern);
    if (status == MUS_OK) status = mus_cloth_create(b->context, pattern, &cut, &w->cloth);
    if (status == MUS_OK) status = mus_drape_create(b->context, w->cloth, w->body, NULL, &w->drape);
    if (status == MUS_OK) status = mus_drape_place(w->drape);
    if (status == MUS_OK) status = mus_drape_sew(w->drape, NULL, NULL);
    if (status == MUS_OK) status = mus_drape_settle(w->drape, NULL, NULL);
    if (status == MUS_OK) status = mus_body_move(w->body, "walk", WORN_GAP, &w->move);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    return status;
}


/* Interpolates all angles between two poses, u from 0 to 1. */
static void worn_between(const mus_pose *from, const mus_pose *to, double u, mus_pose *out)
{
    *out = *from;
    for (int i = 0; i < 3; i++) {
        out->place[i] += u * (to->place[i] - from->place[i]);
        for (int j = 0; j < MUS_JOINT_COUNT; j++) out->angle[j][i] += u * (to->angle[j][i] - from->angle[j][i]);
    }
}


/* Leads the body into the walk, up to the beginning of a frame. */
static mus_status worn_lead(worn *w)
{
    mus_pose from, first, pose;
    mus_pose_init(&from, sizeof from);
    mus_pose_init(&first, sizeof first);
    mus_status status = mus_drape_body_pose(w->drape, &from);
    if (status == MUS_OK) status = mus_move_at(w->move, 0.0, &first);
    for (int32_t k = 1; k <= WORN_EASE && status == MUS_OK; k++) {
        worn_between(&from, &first, (double)k / WORN_EASE, &pose);
        status = mus_drape_pose_body(w->drape, &pose, 1.0 / WORN_RATE);
        const int32_t steps = (int32_t)ceil(1.0 / WORN_RATE / (0.9 * mus_drape_step_bound(w->drape)));
        w->step = 1.0 / WORN_RATE / steps;
        if (status == MUS_OK) status = mus_drape_step(w->drape, steps, w->step);
    }
    w->now = w->next = first;
    return status == MUS_OK ? mus_move_at(w->move, 1.0 / WORN_RATE, &w->next) : status;
}


/* Copies positions and velocities of the garment's nodes; welded nodes once. */
static mus_status worn_keep(worn *w)
{
    const size_t size = 3 * (size_t)mus_cloth_node_count(w->cloth) * sizeof(double);
    w->place = realloc(w->place, size);
    w->velocity = realloc(w->velocity, size);
    if (w->place == NULL || w->velocity == NULL) return MUS_ERR_MEMORY;
    memcpy(w->place, mus_drape_positions(w->drape), size);
    memcpy(w->velocity, mus_drape_velocities(w->drape), size);
    return MUS_OK;
}


/* Makes a drape of the nodes without springs, with the body or without it. */
static mus_status worn_bare(bench *b, const worn *w, bool alone, mus_cloth **cloth, mus_drape **drape)
{
    mus_bare bare;
    const int32_t n = mus_cloth_node_count(w->cloth);
    double *mass = malloc((size_t)n * sizeof *mass);
    if (mass == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < n; i++) mass[i] = 1e-5;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = n, bare.place = w->place, bare.mass = mass;
    mus_status status = mus_cloth_create_bare(b->context, &bare, cloth);
    if (status == MUS_OK) status = mus_drape_create(b->context, *cloth, alone ? NULL : w->body, NULL, drape);
    free(mass);
    return status;
}


/* Puts nodes and body back to the beginning of the frame. */
static mus_status worn_start(const worn *w, mus_drape *drape, bool alone, bool walks)
{
    mus_status status = mus_drape_set_state(drape, w->place, w->velocity);
    if (status == MUS_OK && !alone) status = mus_drape_pose_body(drape, &w->now, 0.0);
    if (status == MUS_OK && !alone && walks) status = mus_drape_pose_body(drape, &w->next, 1.0 / WORN_RATE);
    return status;
}


/* Measures the least CPU time of the steps [s], and the number of queries of a part by a node in them. */
static mus_status worn_time(bench *b, const worn *w, bool alone, bool walks, double *seconds, int64_t *queries)
{
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_drape_report before, after;
    mus_drape_report_init(&before, sizeof before);
    mus_drape_report_init(&after, sizeof after);
    mus_status status = worn_bare(b, w, alone, &cloth, &drape);
    *seconds = INFINITY;
    for (int r = 0; r < WORN_REPEATS && status == MUS_OK; r++) {
        status = worn_start(w, drape, alone, walks);
        if (status == MUS_OK) status = mus_drape_report_get(drape, &before);
        const double start = bench_cpu();
        if (status == MUS_OK) status = mus_drape_step(drape, WORN_STEPS, w->step);
        *seconds = fmin(*seconds, bench_cpu() - start);
        if (status == MUS_OK) status = mus_drape_report_get(drape, &after);
    }
    *queries = after.contact_queries - before.contact_queries;
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return status;
}


/* Writes the positions of the nodes after each step: out (WORN_STEPS x nodes x 3) [m]. */
static mus_status worn_places(bench *b, const worn *w, bool walks, double *out)
{
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    const size_t size = 3 * (size_t)mus_cloth_node_count(w->cloth);
    mus_status status = worn_bare(b, w, false, &cloth, &drape);
    if (status == MUS_OK) status = worn_start(w, drape, false, walks);
    for (int k = 0; k < WORN_STEPS && status == MUS_OK; k++) {
        status = mus_drape_step(drape, 1, w->step);
        if (status == MUS_OK) memcpy(out + (size_t)k * size, mus_drape_positions(drape), size * sizeof *out);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return status;
}


/* Returns the least CPU time [s] of the tree for all positions; `again`: each search starts from the nearest triangle
 * of the step before. */
static double worn_tree(tree *t, int32_t nodes, const double *places, bool again, int32_t *nearest)
{
    double best = INFINITY, sum = 0.0;
    for (int r = 0; r < 3; r++) {
        double seconds = 0.0;
        for (int32_t i = 0; i < nodes; i++) nearest[i] = -1;
        for (int k = 0; k < WORN_STEPS; k++) {
            const double *p = places + 3 * (size_t)nodes * (size_t)k, start = bench_cpu();
            for (int32_t i = 0; i < nodes; i++) {
                if (!again) nearest[i] = -1;
                sum += tree_nearest(t, p + 3 * (size_t)i, &nearest[i]);
            }
            seconds += bench_cpu() - start;
        }
        best = fmin(best, seconds);
    }
    return isfinite(sum) ? best : NAN;
}


static void worn_write(bench *b, const char *name, int32_t nodes, int32_t triangles, int64_t queries, double contact,
                       const double *asked)
{
    const double times = (double)nodes * WORN_STEPS, node = 1e9 * contact / times;
    const double plain = 1e9 * asked[0] / times, again = 1e9 * asked[1] / times;
    if (b->as_json) {
        json_open(&b->j, NULL, '{');
        json_text(&b->j, "case", name);
        json_int(&b->j, "precision", 32);
        json_int(&b->j, "threads", 1);
        json_int(&b->j, "nodes", nodes);
        json_int(&b->j, "steps", WORN_STEPS);
        json_int(&b->j, "triangles", triangles);
        json_int(&b->j, "queries", queries);
        json_number(&b->j, "ns_per_node", node);
        json_number(&b->j, "ns_per_tree_query", plain);
        json_number(&b->j, "ns_per_tree_query_again", again);
        json_number(&b->j, "ratio_to_tree", plain / node);
        json_number(&b->j, "ratio_to_tree_again", again / node);
        json_close(&b->j, '}');
        return;
    }
    printf("%-22s 32 bit 1 thread  %8d nodes %7.2f ns a node and step  %.2f queries a node  %d triangles  tree %.0f "
           "ns, %.0f from the last answer: %.1f and %.1f x contact\n",
           name, (int)nodes, node, (double)queries / times, (int)triangles, plain, again, plain / node, again / node);
    fflush(stdout);
}


static mus_status worn_row(bench *b, const worn *w, const char *name, bool walks)
{
    const int32_t nodes = mus_cloth_node_count(w->cloth);
    double alone = 0.0, with = 0.0, asked[2] = {0.0, 0.0};
    int64_t queries = 0, none = 0;
    mus_body *posed = NULL;
    tree t = {0};
    int32_t *nearest = malloc((size_t)nodes * sizeof *nearest);
    double *places = malloc(3 * (size_t)nodes * WORN_STEPS * sizeof *places);
    mus_status status = nearest != NULL && places != NULL ? MUS_OK : MUS_ERR_MEMORY;
    if (status == MUS_OK) status = worn_time(b, w, true, walks, &alone, &none);
    if (status == MUS_OK) status = worn_time(b, w, false, walks, &with, &queries);
    if (status == MUS_OK) status = worn_places(b, w, walks, places);
    if (status == MUS_OK) status = mus_body_pose(w->body, &w->now, &posed);
    if (status == MUS_OK && !tree_make(mus_body_vertices(posed), mus_body_triangle_count(posed),
                                       mus_body_triangles(posed), &t))
        status = MUS_ERR_MEMORY;
    if (status == MUS_OK) {
        asked[0] = worn_tree(&t, nodes, places, false, nearest);
        asked[1] = worn_tree(&t, nodes, places, true, nearest);
        worn_write(b, name, nodes, mus_body_triangle_count(posed), queries, with - alone, asked);
    }
    tree_free(&t);
    mus_body_destroy(posed);
    free(places);
    free(nearest);
    return status;
}


mus_status bench_worn(bench *b)
{
    worn w = {0};
    mus_pose_init(&w.now, sizeof w.now);
    mus_status status = worn_dress(b, &w);

    /* on the body at rest, in its rest pose */
    if (status == MUS_OK) status = mus_drape_body_pose(w.drape, &w.now);
    w.next = w.now;
    w.step = 0.9 * mus_drape_step_bound(w.drape);
    if (status == MUS_OK) status = worn_keep(&w);
    if (status == MUS_OK) status = worn_row(b, &w, "contact_worn_still", false);

    if (status == MUS_OK) status = worn_lead(&w);
    if (status == MUS_OK) status = worn_keep(&w);
    if (status == MUS_OK) status = worn_row(b, &w, "contact_worn_walk", true);
    free(w.place);
    free(w.velocity);
    mus_move_destroy(w.move);
    mus_drape_destroy(w.drape);
    mus_cloth_destroy(w.cloth);
    mus_body_destroy(w.body);
    return status;
}
