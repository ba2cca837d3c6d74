/*
 * world.h: the objects, options and room for results that the calls of every_call.h use: two small patterns sewn to
 * each other before the belly of a coarse body, cut, draped, on a sheet and in a catalogue.
 */
#ifndef MUS_TESTS_WORLD_H
#define MUS_TESTS_WORLD_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"
#include "muslin/arrange.h"
#include "muslin/catalogue.h"
#include "muslin/design.h"
#include "muslin/dress.h"
#include "muslin/edit.h"
#include "muslin/exchange.h"
#include "muslin/fit.h"
#include "muslin/integrate.h"
#include "muslin/layout.h"
#include "muslin/manifold.h"
#include "muslin/pose.h"
#include "muslin/print.h"
#include "muslin/scan.h"
#include "muslin/topology.h"

/* sides of panel 0, a square of 0.4 m; those of panel 1 are 4 to 7, and seam 0 joins TOP and 4 */
enum { BOTTOM, RIGHT, TOP, LEFT };

#define ROOM 64
#define SIDE 0.4 /* [m] of both panels */

typedef struct objects {
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_fit *fit;
    mus_sheet *sheet;
    mus_layout *layout;
    mus_catalogue *catalogue;
    mus_move *move;
    mus_manifold *manifold;
    mus_mesh *mesh;
    mus_faults *faults;
    mus_cut_line *cut_line;
} objects;

/* what calls read and write; zero where nothing else is said */
typedef struct world {
    mus_context *context, *second;
    objects have, made;
    char path[1024], base[1024]; /* a file that calls read or write, and that of the catalogue */
    char *text;                  /* bytes of that file */
    size_t text_size;
    char *bytes; /* that a call makes */
    size_t size;
    int32_t leg, second_leg, left, right; /* edges of a pattern with darts */
    int32_t row;                          /* of the catalogue */
    /* results: numbers are compared, what is borrowed is not */
    double real[4096];
    float single[16];
    int32_t whole[2 * ROOM], more;
    int64_t count;
    uint64_t hash[2];
    char line[1024];
    const char *name;
    const int32_t *index;
    const double *xy;
    /* options and structs that a call fills */
    mus_context_def context_def;
    mus_body_def body_def;
    mus_limb limb;
    mus_cloth_def cloth_def;
    mus_bare bare;
    mus_drape_def drape_def;
    mus_dress_def dress_def;
    mus_pose pose;
    mus_cut_def cut_def;
    mus_edge_def edge_def;
    mus_seam_def seam_def;
    mus_placement placement;
    mus_pattern_dxf dxf;
    mus_pattern_val val;
    mus_fabric fabric;
    mus_mesh_view view;
    mus_mesh_motion motion;
    mus_mesh_file file;
    mus_integrate_def motion_law;
    mus_manifold_def manifold_def;
    mus_layout_def layout_def;
    mus_layout_item layout_item;
    mus_sheet_dxf rul;
    mus_scan_def scan_def;
    mus_reason reason;
    mus_estimate estimate;
    mus_drape_report report;
    mus_seam_walk walk;
    mus_fit_spread spread;
    mus_fit_level level;
    mus_worn worn;
    mus_sheet_piece piece;
    mus_layout_piece laid;
    mus_sheet_line stroke;
    mus_topology topology;
    mus_homology homology;
} world;

#define GOOD_OF(w, call) ck_assert_msg((call) == MUS_OK, "%s: %s", #call, mus_context_error((w)->context))
#define GOOD(call) GOOD_OF(w, call)


/* ---- the world ---- */

/* the hook of a second context, whose memory is that of the first */
static void *borrowed(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)old_size;
    return mus_context_alloc(user, block, new_size);
}


static void square(world *w, mus_pattern *pattern, const char *name, double height)
{
    static const char *const sides[] = {"bottom", "right", "top", "left"};
    const double corner[4][2] = {{0, 0}, {SIDE, 0}, {SIDE, SIDE}, {0, SIDE}};
    const int32_t along[4] = {1, 1, 1, 1};
    int32_t panel, point[4], edge[4];
    GOOD(mus_pattern_add_panel(pattern, name, &panel));
    for (int i = 0; i < 4; i++) GOOD(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]));
    for (int i = 0; i < 4; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.name = sides[i], def.start = point[i], def.end = point[(i + 1) % 4];
        GOOD(mus_pattern_add_edge(pattern, &def, &edge[i]));
    }
    GOOD(mus_pattern_set_outline(pattern, panel, 4, edge, along));
    scene_move(pattern, panel, -0.5 * SIDE, height, 0.25);
}


/* two squares before the belly, sewn to each other, with a notch, a mark and a label */
static mus_pattern *two_squares(world *w)
{
    mus_pattern *pattern;
    GOOD(mus_pattern_create(w->context, "two squares", &pattern));
    square(w, pattern, "low", 0.7);
    square(w, pattern, "high", 1.12);
    scene_sew(pattern, TOP, 4, 0.0);
    GOOD(mus_pattern_set_edge_label(pattern, BOTTOM, "hem"));
    GOOD(mus_pattern_add_notch(pattern, RIGHT, 0.1, MUS_NOTCH_SINGLE, NULL));
    GOOD(mus_pattern_add_mark(pattern, 1, "mark", 1, (double[2]){0.2, 0.2}, NULL));
    return pattern;
}


static void fall(void *user, double t, const double *y, double *dy)
{
    (void)user, (void)t;
    dy[0] = y[1], dy[1] = -9.81;
}


static void fall_f32(void *user, double t, const float *y, float *dy)
{
    (void)user, (void)t;
    dy[0] = y[1], dy[1] = -9.81F;
}


static void make_options(world *w)
{
    static const double contour[12] = {-0.3, 0, 0, 0.1, 0.1, 2, 0.3, 0, 0, 0.1, 0.1, 2};
    static const double place[6] = {0, 0, 0, 0.1, 0, 0}, mass[2] = {0.1, 0.1}, length[1] = {0.1}, stiffness[1] = {10};
    static const int32_t spring[2] = {0, 1};
    mus_context_def_init(&w->context_def, sizeof w->context_def);
    w->context_def.alloc = borrowed, w->context_def.alloc_user = w->context;
    mus_body_def_init(&w->body_def, sizeof w->body_def);
    w->body_def.samples = 16, w->body_def.ring_spacing = 0.05;
    mus_limb_init(&w->limb, sizeof w->limb);
    w->limb.contours = 2, w->limb.contour = contour, w->limb.pole[0] = -0.31, w->limb.pole[1] = 0.31;
    mus_cloth_def_init(&w->cloth_def, sizeof w->cloth_def);
    w->cloth_def.spacing = 0.06;
    mus_bare_init(&w->bare, sizeof w->bare);
    w->bare.nodes = 2, w->bare.springs = 1, w->bare.place = place, w->bare.mass = mass;
    w->bare.spring = spring, w->bare.length = length, w->bare.stiffness = stiffness;
    mus_drape_def_init(&w->drape_def, sizeof w->drape_def);
    w->drape_def.self_contact = 1, w->drape_def.threads = 2, w->drape_def.settle_residual = 10.0;
    mus_dress_def_init(&w->dress_def, sizeof w->dress_def);
    w->dress_def.spacing = 0.06, w->dress_def.drape = &w->drape_def;
    mus_cut_def_init(&w->cut_def, sizeof w->cut_def);
    w->cut_def.name = "again", w->cut_def.seam_name = "cut";
    w->cut_def.edge_a = RIGHT, w->cut_def.s_a = 0.2, w->cut_def.edge_b = LEFT, w->cut_def.s_b = 0.2;
    mus_edge_def_init(&w->edge_def, sizeof w->edge_def);
    w->edge_def.start = 0, w->edge_def.end = 2;
    mus_seam_def_init(&w->seam_def, sizeof w->seam_def);
    w->seam_def.edge_a = RIGHT, w->seam_def.edge_b = 5;
    mus_fabric_init(&w->fabric, sizeof w->fabric);
    mus_integrate_def_init(&w->motion_law, sizeof w->motion_law);
    w->motion_law.step = 0.01, w->motion_law.rate = fall, w->motion_law.rate32 = fall_f32;
    mus_manifold_def_init(&w->manifold_def, sizeof w->manifold_def);
    w->manifold_def.spacing = 0.03, w->manifold_def.threads = 2;
    static const double square_of[8] = {0.0, 0.0, 0.3, 0.0, 0.3, 0.3, 0.0, 0.3};
    mus_layout_def_init(&w->layout_def, sizeof w->layout_def);
    w->layout_def.steps = 100000, w->layout_def.runs = 2, w->layout_def.threads = 2;
    mus_layout_item_init(&w->layout_item, sizeof w->layout_item);
    w->layout_item.n = 4, w->layout_item.xy = square_of, w->layout_item.count = 3;
    mus_sheet_dxf_init(&w->rul, sizeof w->rul);
    mus_scan_def_init(&w->scan_def, sizeof w->scan_def);
    w->scan_def.up = MUS_SCAN_Y, w->scan_def.front = MUS_SCAN_Z, w->scan_def.unit = 1.0;
    w->scan_def.spacing = 0.05, w->scan_def.corners = 32, w->scan_def.samples = 16, w->scan_def.ring_spacing = 0.05;
}


static void make_structs(world *w)
{
    mus_pose_init(&w->pose, sizeof w->pose);
    mus_placement_init(&w->placement, sizeof w->placement);
    mus_pattern_dxf_init(&w->dxf, sizeof w->dxf);
    mus_pattern_val_init(&w->val, sizeof w->val);
    mus_reason_init(&w->reason, sizeof w->reason);
    mus_estimate_init(&w->estimate, sizeof w->estimate);
    mus_drape_report_init(&w->report, sizeof w->report);
    mus_seam_walk_init(&w->walk, sizeof w->walk);
    mus_fit_spread_init(&w->spread, sizeof w->spread);
    mus_fit_level_init(&w->level, sizeof w->level);
    mus_worn_init(&w->worn, sizeof w->worn);
    mus_sheet_piece_init(&w->piece, sizeof w->piece);
    mus_layout_piece_init(&w->laid, sizeof w->laid);
    mus_sheet_line_init(&w->stroke, sizeof w->stroke);
    mus_topology_init(&w->topology, sizeof w->topology);
    mus_homology_init(&w->homology, sizeof w->homology);
}


/* meshes of the cloth, standing still and in motion */
static void make_views(world *w)
{
    static const double start[1] = {0.0};
    mus_mesh_view_init(&w->view, sizeof w->view);
    w->view.name = "cloth", w->view.positions = mus_drape_positions(w->have.drape);
    w->view.vertex_count = mus_cloth_node_count(w->have.cloth), w->view.triangles = mus_cloth_triangles(w->have.cloth);
    w->view.triangle_count = mus_cloth_triangle_count(w->have.cloth);
    mus_mesh_motion_init(&w->motion, sizeof w->motion);
    w->motion.positions = w->view.positions;
    mus_mesh_file_init(&w->file, sizeof w->file);
    w->file.form = MUS_MESH_GLB, w->file.count = 1, w->file.meshes = &w->view;
    w->file.cloths = (const mus_cloth *const *)&w->have.cloth;
    w->file.keys = 1, w->file.times = start, w->file.motion = &w->motion;
}


static void make_world(world *w)
{
    int32_t count;
    memset(w, 0, sizeof *w);
    w->context = support_context();
    support_scratch("again.file", w->path, sizeof w->path);
    support_scratch("again.db", w->base, sizeof w->base);
    remove(w->path), remove(w->base);
    make_options(w);
    make_structs(w);
    GOOD(mus_tape_create(w->context, &w->have.tape));
    GOOD(mus_tape_set_size(w->have.tape, "W40"));
    GOOD(mus_body_create(w->context, w->have.tape, &w->body_def, &w->have.body));
    w->have.pattern = two_squares(w);
    GOOD(mus_cloth_create(w->context, w->have.pattern, &w->cloth_def, &w->have.cloth));
    GOOD(mus_drape_create(w->context, w->have.cloth, w->have.body, &w->drape_def, &w->have.drape));
    GOOD(mus_drape_place(w->have.drape));
    GOOD(mus_fit_create(w->have.drape, w->have.body, &w->have.fit));
    GOOD(mus_sheet_create(w->context, w->have.pattern, NULL, &w->have.sheet));
    GOOD(mus_layout_create(w->context, w->have.pattern, &w->layout_def, &w->have.layout));
    GOOD(mus_catalogue_open(w->context, w->base, MUS_CATALOGUE_WRITE, &w->have.catalogue));
    GOOD(mus_catalogue_add(w->have.catalogue, w->have.pattern, "first", &w->row));
    GOOD(mus_move_named(w->context, "walk", 1.7, &w->have.move));
    GOOD(mus_pattern_check(w->have.pattern, &count, &w->have.faults));
    GOOD(mus_pattern_cut_line(w->have.pattern, 0, 0.01, &w->have.cut_line));
    GOOD(mus_pattern_keep_history(w->have.pattern, 10));
    make_views(w);
}


static void destroy(objects *o)
{
    mus_cut_line_destroy(o->cut_line);
    mus_faults_destroy(o->faults);
    mus_mesh_destroy(o->mesh);
    mus_manifold_destroy(o->manifold);
    mus_move_destroy(o->move);
    mus_catalogue_destroy(o->catalogue);
    mus_sheet_destroy(o->sheet);
    mus_layout_destroy(o->layout);
    mus_fit_destroy(o->fit);
    mus_drape_destroy(o->drape);
    mus_cloth_destroy(o->cloth);
    mus_pattern_destroy(o->pattern);
    mus_body_destroy(o->body);
    mus_tape_destroy(o->tape);
}


static void end_world(world *w)
{
    const int64_t asked = support_allocations();
    support_fail_after(0, true);
    destroy(&w->made);
    destroy(&w->have);
    mus_context_destroy(w->second);
    mus_context_alloc(w->context, w->bytes, 0);
    support_fail_never();
    ck_assert_msg(support_allocations() == asked, "an object asks for memory when it is destroyed");
    support_context_end(w->context);
    free(w->text);
    remove(w->path), remove(w->base);
}

#endif
