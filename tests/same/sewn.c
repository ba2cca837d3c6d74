/*
 * sewn.c: rows "sewn/...": what a pattern is as a sewn surface: topology, openings, homology, boundary operators,
 * canonical form, faults; "find/...": a catalogue of patterns and what is found in it.
 */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#define TRIPLES 8192
#define FORM 65536

/* ---- the surface ---- */

static void digest_topology(same_run *run, const mus_pattern *pattern)
{
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    if (!same_status(run, mus_pattern_topology(pattern, &t))) return;
    const int32_t parts[] = {t.vertices, t.edges, t.faces, t.euler, t.components, t.loops, t.orientable, t.manifold,
                             t.genus};
    same_ints(run, parts, sizeof parts / sizeof *parts);
    for (int32_t l = 0; l < t.loops; l++) {
        int32_t edges[256], count = 0;
        double length = 0.0;
        const char *label = NULL;
        if (!same_status(run, mus_pattern_loop(pattern, l, edges, 256, &count, &length))) continue;
        same_ints(run, edges, count < 256 ? count : 256);
        same_real(run, length);
        if (same_status(run, mus_pattern_loop_label(pattern, l, &label))) same_text(run, label);
    }
}


static void digest_homology(same_run *run, const mus_pattern *pattern)
{
    int32_t *triples = malloc(sizeof *triples * 3 * TRIPLES), torsion[16], count = 0;
    if (triples == NULL) same_must(run, MUS_ERR_MEMORY, "digest_homology");
    for (int32_t sewn = 0; sewn < 2; sewn++) {
        mus_homology h;
        mus_homology_init(&h, sizeof h);
        if (same_status(run, mus_pattern_homology(pattern, sewn, &h, torsion, 16))) {
            const int32_t parts[] = {h.cells[0], h.cells[1], h.cells[2], h.rank[0],  h.rank[1],
                                     h.betti[0], h.betti[1], h.betti[2], h.euler, h.torsion};
            same_ints(run, parts, sizeof parts / sizeof *parts);
            same_ints(run, torsion, h.torsion);
        }
        for (int32_t dimension = 1; dimension < 3; dimension++)
            if (same_status(run, mus_pattern_boundary(pattern, sewn, dimension, triples, TRIPLES, &count)))
                same_ints(run, triples, 3 * (int64_t)(count < TRIPLES ? count : TRIPLES));
    }
    free(triples);
}


static void digest_form(same_run *run, const mus_pattern *pattern)
{
    static uint8_t bytes[FORM];
    for (int32_t kind = 0; kind < 4; kind++) {
        mus_form_def def;
        size_t count = 0;
        uint64_t hash[2] = {0, 0};
        mus_form_def_init(&def, sizeof def);
        def.mirror = kind & 1, def.labels = kind >> 1;
        if (!same_status(run, mus_pattern_form(pattern, &def, bytes, sizeof bytes, &count, hash))) continue;
        same_int(run, (int64_t)count);
        same_bytes(run, bytes, count < sizeof bytes ? count : sizeof bytes);
        same_int(run, (int64_t)hash[0]);
        same_int(run, (int64_t)hash[1]);
    }
}


/* lengths, areas and polylines, and where its panels are found to start */
static void digest_measures(same_run *run, mus_pattern *pattern, const mus_body *body)
{
    double line[2 * 256];
    int32_t count = 0;
    for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++) {
        same_real(run, mus_pattern_edge_length(pattern, e));
        if (same_status(run, mus_pattern_edge_polyline(pattern, e, 5, line, 256, &count)))
            same_reals(run, line, 2 * (int64_t)(count < 256 ? count : 256));
    }
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
        int32_t edges[256], directions[256];
        same_real(run, mus_pattern_panel_area(pattern, p));
        same_real(run, mus_pattern_panel_perimeter(pattern, p));
        if (same_status(run, mus_pattern_rim(pattern, p, edges, directions, 256, &count))) {
            same_ints(run, edges, count < 256 ? count : 256);
            same_ints(run, directions, count < 256 ? count : 256);
        }
    }
    if (same_status(run, mus_arrange_pattern(pattern, body))) same_pattern(run, pattern);
}


static void make_sewn(same_run *run, const void *what, int32_t index)
{
    (void)index;
    mus_reason why;
    mus_tape *tape = same_size(run, "W40");
    mus_pattern *pattern = same_garment(run, what, tape);
    mus_reason_init(&why, sizeof why);
    digest_topology(run, pattern);
    digest_homology(run, pattern);
    digest_form(run, pattern);
    if (same_status(run, mus_pattern_reason(pattern, &why))) {
        same_int(run, why.kind);
        same_int(run, why.panel);
        same_int(run, why.seam);
    }
    digest_measures(run, pattern, same_body(run, tape));
}


/* ---- the catalogue ---- */

static const char *const shelf[] = {"tshirt", "sleeveless", "bodice", "skirt", "tee_v", "oxford_shirt",
                                    "sheath", "jeans", "coat", "wrap_dress", "kilt", "half_skirt_knee",
                                    "gored6_skirt_knee", "romper", "leggings", "waistcoat", "cape_mini",
                                    "straight_shorts"};
#define SHELF ((int32_t)(sizeof shelf / sizeof *shelf))

static mus_catalogue *catalogue_of(same_run *run)
{
    static const char *const sizes[] = {"W40", "W46"};
    mus_catalogue *catalogue = NULL;
    same_must(run, mus_catalogue_open(run->context, "shelf.db", MUS_CATALOGUE_WRITE, &catalogue), "shelf.db");
    same_must(run, mus_catalogue_begin(catalogue), "mus_catalogue_begin");
    for (int s = 0; s < 2; s++) {
        mus_tape *tape = same_size(run, sizes[s]);
        for (int32_t i = 0; i < SHELF; i++) {
            char name[64] = "";
            int32_t id = MUS_NONE;
            mus_pattern *pattern = same_draft(run, shelf[i], tape);
            strcat(strcat(strcat(name, shelf[i]), "-"), sizes[s]);
            same_status(run, mus_catalogue_add(catalogue, pattern, name, &id));
            same_int(run, id);
            mus_pattern_destroy(pattern);
        }
    }
    same_must(run, mus_catalogue_commit(catalogue), "mus_catalogue_commit");
    same_int(run, mus_catalogue_count(catalogue));
    return catalogue;
}


/* searches for a garment of another size: the nearest, the same, and those that contain it */
static void make_find(same_run *run, const void *what, int32_t index)
{
    (void)index;
    int32_t ids[2 * SHELF], exact[2 * SHELF], count = 0;
    double distances[2 * SHELF], parts[MUS_DISTANCE_COUNT];
    mus_catalogue *catalogue = catalogue_of(run);
    mus_pattern *like = same_draft(run, what, same_size(run, "W42"));
    if (same_status(run, mus_catalogue_nearest(catalogue, like, 2 * SHELF, ids, distances, exact, &count))) {
        same_ints(run, ids, count);
        same_ints(run, exact, count);
        same_reals(run, distances, count);
    }
    for (int32_t i = 0; i < count && i < 5; i++) {
        same_status(run, mus_catalogue_explain(catalogue, like, ids[i], parts, NULL, 0));
        same_reals(run, parts, MUS_DISTANCE_COUNT);
    }
    if (same_status(run, mus_catalogue_exact(catalogue, like, ids, 2 * SHELF, &count))) same_ints(run, ids, count);
    if (same_status(run, mus_catalogue_containing(catalogue, like, ids, 2 * SHELF, &count)))
        same_ints(run, ids, count);
    mus_catalogue_destroy(catalogue);
}


void same_sewn(same_list *list)
{
    static const char *const more[] = {"hoodie", "boiler_suit", "blouse_peter_pan_short", "ball_gown", "harem_elastic",
                                       "tiered_skirt_mini", "poncho_hood", "tshirt+waistcoat"};
    static const char *const files[] = {"garmentcode/specs/d11_000_mean_all_specification.json",
                                        "garmentcode/specs/d11_030_mean_female_specification.json",
                                        "garmentcode/originals/shirt_mean_specification.json",
                                        "freesewing/aaron_cisMaleAdult40.json"};
    static const char *const like[] = {"tshirt", "skirt", "jeans", "romper", "kilt"};
    for (int32_t i = 0; i < SHELF; i++) same_add(list, make_sewn, "sewn/%s", shelf[i])->what = shelf[i];
    for (size_t i = 0; i < sizeof more / sizeof *more; i++)
        same_add(list, make_sewn, "sewn/%s", more[i])->what = more[i];
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        same_row *row = same_add(list, make_sewn, "sewn/%s", strrchr(files[i], '/') + 1);
        row->what = files[i], row->data = true;
    }
    for (size_t i = 0; i < sizeof like / sizeof *like; i++)
        same_add(list, make_find, "find/%s", like[i])->what = like[i];
}
