/*
 * scene.c: see scene.h.
 */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the body, and what it wears ---- */

const char *same_body_file(const char *body, const char *ending)
{
    static char path[128];
    snprintf(path, sizeof path, "garmentcode/bodies/%s%s", body, ending);
    return path;
}


mus_body *same_scan(const same_run *run, const char *body, bool distances, mus_scan_report *report)
{
    mus_scan_def def;
    mus_mesh *mesh = NULL;
    mus_body *out = NULL;
    mus_scan_def_init(&def, sizeof def);
    def.distances = distances;
    same_must(run, mus_mesh_read_obj(run->context, same_data(run, same_body_file(body, ".obj")), &mesh), body);
    same_must(run,
              mus_body_create_scan(run->context, mus_mesh_vertex_count(mesh), mus_mesh_vertices(mesh),
                                   mus_mesh_triangle_count(mesh), mus_mesh_triangles(mesh), &def, report, &out),
              "mus_body_create_scan");
    mus_mesh_destroy(mesh);
    return out;
}


/* one garment: a file of the real data, or a draft */
static mus_pattern *one_garment(const same_run *run, const char *garment, const mus_tape *tape)
{
    const char *ending = strrchr(garment, '.');
    mus_pattern *pattern = NULL;
    if (ending == NULL || strcmp(ending, ".json") != 0) return same_draft(run, garment, tape);
    same_must(run, mus_pattern_read(run->context, same_data(run, garment), &pattern), garment);
    return pattern;
}


mus_pattern *same_garment(const same_run *run, const char *garment, const mus_tape *tape)
{
    char text[256];
    mus_pattern *pattern = NULL;
    snprintf(text, sizeof text, "%s", garment);
    int32_t layer = 0;
    for (char *word = strtok(text, "+"); word != NULL; word = strtok(NULL, "+"), layer++) {
        mus_pattern *more = one_garment(run, word, tape);
        if (layer == 0) pattern = more;
        else same_must(run, mus_pattern_join(pattern, more, layer), word);
    }
    return pattern;
}


void same_cut_out(const same_run *run, const same_scene *scene, same_dressed *out)
{
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.001 * scene->spacing;
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    same_must(run, mus_fabric_find(scene->fabric != NULL ? scene->fabric : "jersey", &fabric), "mus_fabric_find");
    cut.fabric = &fabric;
    if (scene->flags & SCENE_PAPER) cut.bending = MUS_BEND_PAPER;
    if (scene->flags & SCENE_ONE_CUT) cut.coarser = 0;
    same_must(run, mus_cloth_create(run->context, out->pattern, &cut, &out->cloth), "mus_cloth_create");

    mus_drape_def_init(&def, sizeof def);
    def.self_contact = (scene->flags & SCENE_SELF) != 0;
    def.precision = scene->flags & SCENE_DOUBLE ? 64 : 32;
    def.threads = scene->flags & SCENE_TWO ? 2 : 1;
    def.sew_once = (scene->flags & SCENE_ONCE) != 0;
    def.integrator = scene->flags & SCENE_VERLET ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    def.contact_ball = scene->flags & SCENE_BALL ? 0.00025 : 0.0;
    same_must(run, mus_drape_create(run->context, out->cloth, out->body, &def, &out->drape), "mus_drape_create");
    same_must(run, mus_drape_place(out->drape), "mus_drape_place");
}


/* a table size begins with a capital letter, the name of a body of the real data does not */
static bool is_size(const char *tape)
{
    return tape[0] >= 'A' && tape[0] <= 'Z';
}


same_dressed same_place(const same_run *run, const same_scene *scene)
{
    same_dressed out = {0};
    out.tape = is_size(scene->tape) ? same_size(run, scene->tape)
                                    : same_tape(run, same_body_file(scene->tape, ".yaml"), NULL, false);
    if (scene->flags & SCENE_SCAN) out.body = same_scan(run, scene->tape, false, NULL);
    else out.body = same_body(run, out.tape);
    out.pattern = same_garment(run, scene->garment, out.tape);
    if (scene->flags & SCENE_OPEN)
        same_must(run, mus_pattern_open_closures(out.pattern, 1, NULL), "mus_pattern_open_closures");
    if (scene->flags & SCENE_FOUND) same_must(run, mus_arrange_pattern(out.pattern, out.body), "mus_arrange_pattern");
    same_cut_out(run, scene, &out);
    return out;
}


bool same_wear(same_run *run, const same_dressed *d)
{
    const bool sewn = same_status(run, mus_drape_sew(d->drape, NULL, NULL));
    return sewn && same_status(run, mus_drape_settle(d->drape, NULL, NULL));
}


/* ---- what a drape says ---- */

static void digest_report(same_run *run, const mus_drape *drape)
{
    mus_drape_report r;
    mus_drape_report_init(&r, sizeof r);
    same_must(run, mus_drape_report_get(drape, &r), "mus_drape_report_get");
    const int32_t counts[] = {r.nodes,   r.springs,    r.seams,        r.seams_closed, r.welded, r.worst_seam,
                              r.settled, r.step_parts, r.self_contacts};
    const double values[] = {r.max_seam_gap, r.max_penetration, r.max_strain, r.residual, r.max_speed,   r.energy,
                             r.step,         r.step_bound,      r.sew_time,   r.settle_time, r.rest_distance};
    same_ints(run, counts, sizeof counts / sizeof *counts);
    same_reals(run, values, sizeof values / sizeof *values);
    same_reals(run, r.contact_impulse, 3);
    same_int(run, r.steps);
    same_int(run, r.spring_evaluations);
    same_int(run, r.contact_queries);
    same_int(run, r.self_queries);
}


static void digest_reason(same_run *run, const mus_reason *why)
{
    const int32_t parts[] = {why->kind, why->panel, why->seam, why->node, why->count};
    same_ints(run, parts, sizeof parts / sizeof *parts);
    same_real(run, why->value);
    same_reals(run, why->place, 3);
}


static void digest_reasons(same_run *run, const mus_drape *drape)
{
    mus_reason why;
    mus_reason_init(&why, sizeof why);
    if (same_status(run, mus_drape_reason(drape, &why))) digest_reason(run, &why);
    mus_reason_init(&why, sizeof why);
    if (same_status(run, mus_drape_start(drape, &why))) digest_reason(run, &why);
}


void same_drape(same_run *run, const mus_drape *drape, const mus_cloth *cloth)
{
    const int64_t nodes = mus_drape_node_count(drape), pairs = mus_cloth_pair_count(cloth);
    double *values = calloc((size_t)(3 * nodes + pairs + 1), sizeof *values);
    int64_t crossings = 0;
    if (values == NULL) same_must(run, MUS_ERR_MEMORY, "same_drape");
    same_int(run, (int64_t)mus_drape_hash(drape));
    same_reals(run, mus_drape_positions(drape), 3 * nodes);
    same_reals(run, mus_drape_velocities(drape), 3 * nodes);
    same_real(run, mus_drape_time(drape));
    same_real(run, mus_drape_step_bound(drape));
    digest_report(run, drape);
    digest_reasons(run, drape);
    if (same_status(run, mus_drape_forces(drape, values))) same_reals(run, values, 3 * nodes);
    if (same_status(run, mus_drape_normals(drape, values))) same_reals(run, values, 3 * nodes);
    if (same_status(run, mus_drape_gaps(drape, values))) same_reals(run, values, pairs);
    if (same_status(run, mus_drape_crossings(drape, 0, NULL, &crossings))) same_int(run, crossings);
    free(values);
}


void same_fit(same_run *run, const same_dressed *d)
{
    mus_fit *fit = NULL;
    mus_fit_level level;
    same_must(run, mus_fit_create(d->drape, d->body, &fit), "mus_fit_create");
    const int32_t nodes = mus_fit_node_count(fit);
    same_reals(run, mus_fit_warp(fit), nodes);
    same_reals(run, mus_fit_weft(fit), nodes);
    same_reals(run, mus_fit_pressure(fit), nodes);
    same_reals(run, mus_fit_gap(fit), nodes);
    for (int32_t i = 0; i < mus_fit_level_count(fit); i++) {
        mus_fit_level_init(&level, sizeof level);
        same_must(run, mus_fit_level_get(fit, i, &level), "mus_fit_level_get");
        const double values[] = {level.body, level.garment, level.worn, level.ease, level.gap};
        same_int(run, level.level);
        same_int(run, level.right);
        same_reals(run, values, sizeof values / sizeof *values);
    }
    mus_fit_destroy(fit);
}


/* ---- scenes that are stepped ---- */

same_dressed same_stepped_scene(same_run *run, const same_stepped *row)
{
    const same_dressed d = same_place(run, &row->scene);
    same_status(run, mus_drape_sew(d.drape, NULL, NULL));
    row->act(run, &d);
    return d;
}


void same_make_stepped(same_run *run, const void *what, int32_t index)
{
    (void)index;
    const same_dressed d = same_stepped_scene(run, what);
    same_drape(run, d.drape, d.cloth);
}


void same_step_seconds(same_run *run, const same_dressed *d, double seconds)
{
    const int32_t steps = (int32_t)ceil(seconds / (0.9 * mus_drape_step_bound(d->drape)));
    same_status(run, mus_drape_step(d->drape, steps, seconds / steps));
}
