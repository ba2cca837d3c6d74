/*
 * variants.h: the GarmentCode specifications of the real data as patterns with the names of their designs, and patterns
 * made of others by one edit: stretched, a seam dropped, added or turned end for end, a panel turned over.
 */
#ifndef MUS_TESTS_VARIANTS_H
#define MUS_TESTS_VARIANTS_H

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/pattern.h"

#define VARIANTS_MOST 200

typedef struct variant_set {
    int32_t count;
    mus_pattern *pattern[VARIANTS_MOST];
    char name[VARIANTS_MOST][128], design[VARIANTS_MOST][16]; /* "d11_003_mean_all", "d11_003" */
} variant_set;


static inline int variant_by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}


/* all specifications of a folder, in the order of their names; returns how many could be read */
static inline int32_t variants_read(mus_context *context, const char *folder, variant_set *set)
{
    static char file[VARIANTS_MOST][256];
    DIR *dir = opendir(folder);
    int32_t n = 0;
    if (dir == NULL) return 0;
    for (struct dirent *entry; (entry = readdir(dir)) != NULL && n < VARIANTS_MOST;)
        if (strstr(entry->d_name, "_specification.json") != NULL)
            snprintf(file[n++], sizeof file[0], "%s", entry->d_name);
    closedir(dir);
    qsort(file, (size_t)n, sizeof file[0], variant_by_name);
    for (int32_t i = 0; i < n && set->count < VARIANTS_MOST; i++) {
        char path[1024];
        snprintf(path, sizeof path, "%.700s/%.255s", folder, file[i]);
        if (mus_pattern_read(context, path, &set->pattern[set->count]) != MUS_OK) continue;
        snprintf(set->name[set->count], sizeof set->name[0], "%.*s", (int)strcspn(file[i], "."), file[i]);
        snprintf(set->design[set->count], sizeof set->design[0], "%.7s", file[i]);
        set->count++;
    }
    return set->count;
}


static inline void variants_free(variant_set *set)
{
    for (int32_t i = 0; i < set->count; i++) mus_pattern_destroy(set->pattern[i]);
    set->count = 0;
}


/* one edit */
typedef struct variant_edit {
    double stretch[2];          /* of x and y */
    int32_t drop, flip, turned; /* seam, seam, panel, or MUS_NONE */
    int32_t join[2];            /* edges to be sewn, or MUS_NONE */
} variant_edit;


static inline uint64_t variant_random(uint64_t *state)
{
    *state ^= *state << 13, *state ^= *state >> 7, *state ^= *state << 17;
    return *state;
}


static inline variant_edit variant_any_edit(const mus_pattern *p, uint64_t *state)
{
    variant_edit e = {{1.0, 1.0}, MUS_NONE, MUS_NONE, MUS_NONE, {MUS_NONE, MUS_NONE}};
    int32_t what = (int32_t)(variant_random(state) % 5), nseam = mus_pattern_seam_count(p);
    for (int32_t i = 0; i < 2; i++) e.stretch[i] = 0.8 + 0.4 * (double)(variant_random(state) % 1000) / 1000.0;
    if (what == 0 && nseam > 0) e.drop = (int32_t)(variant_random(state) % (uint64_t)nseam);
    if (what == 1 && nseam > 0) e.flip = (int32_t)(variant_random(state) % (uint64_t)nseam);
    if (what == 2) e.turned = (int32_t)(variant_random(state) % (uint64_t)mus_pattern_panel_count(p));
    if (what == 3) {
        int32_t a = (int32_t)(variant_random(state) % (uint64_t)mus_pattern_edge_count(p));
        int32_t b = (int32_t)(variant_random(state) % (uint64_t)mus_pattern_edge_count(p));
        if (a != b) e.join[0] = a, e.join[1] = b;
    }
    return e;
}


static inline mus_status variant_panels(const mus_pattern *p, const variant_edit *e, mus_pattern *out)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < mus_pattern_panel_count(p) && status == MUS_OK; i++)
        status = mus_pattern_add_panel(out, mus_pattern_panel_name(p, i), NULL);
    for (int32_t i = 0; i < mus_pattern_point_count(p) && status == MUS_OK; i++) {
        int32_t panel = 0;
        double xy[2] = {0.0, 0.0};
        mus_pattern_point(p, i, &panel, xy);
        status = mus_pattern_add_point(out, panel, xy[0] * e->stretch[0], xy[1] * e->stretch[1], NULL);
    }
    for (int32_t i = 0; i < mus_pattern_edge_count(p) && status == MUS_OK; i++) {
        int32_t start, end, npiece, nxy, line[64];
        const int32_t *kinds;
        const double *xy;
        double inner[256];
        mus_pattern_edge_ends(p, i, &start, &end);
        mus_pattern_edge_pieces(p, i, &npiece, &kinds, &nxy, &xy);
        if (nxy > 120 || npiece > 64) return MUS_ERR_LIMIT;

        /* arcs do not stay arcs when they are stretched: quadratic through the same control is as good here */
        for (int32_t k = 0; k < npiece; k++) line[k] = kinds[k] == MUS_PIECE_ARC ? MUS_PIECE_QUADRATIC : kinds[k];
        for (int32_t k = 0; k < 2 * (nxy - 2); k++) inner[k] = xy[2 + k] * e->stretch[k % 2];
        status = mus_pattern_add_edge(out, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                           .name = mus_pattern_edge_name(p, i), .start = start,
                                                           .end = end, .npiece = npiece, .kinds = line,
                                                           .nxy = nxy - 2, .xy = inner}, NULL);
        if (status == MUS_OK) status = mus_pattern_set_edge_label(out, i, mus_pattern_edge_label(p, i));
    }
    return status;
}


/* a new pattern; NULL when the edit is none that can be made */
static inline mus_pattern *variant_make(mus_context *context, const mus_pattern *p, const variant_edit *e)
{
    mus_pattern *out;
    if (mus_pattern_create(context, mus_pattern_name(p), &out) != MUS_OK) return NULL;
    mus_status status = variant_panels(p, e, out);
    for (int32_t i = 0; i < mus_pattern_panel_count(p) && status == MUS_OK; i++) {
        int32_t n, word[2][200];
        const int32_t *edges, *directions;
        mus_pattern_outline(p, i, &n, &edges, &directions);
        if (n > 200) status = MUS_ERR_LIMIT;
        for (int32_t k = 0; k < n && status == MUS_OK; k++) {
            int32_t from = i == e->turned ? n - 1 - k : k;
            word[0][k] = edges[from], word[1][k] = i == e->turned ? -directions[from] : directions[from];
        }
        if (status == MUS_OK) status = mus_pattern_set_outline(out, i, n, word[0], word[1]);
        if (status == MUS_OK) status = mus_pattern_set_panel_label(out, i, mus_pattern_panel_label(p, i));
    }
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    for (int32_t i = 0; i < mus_pattern_seam_count(p) && status == MUS_OK; i++) {
        if (i == e->drop) continue;
        mus_pattern_seam(p, i, &seam);
        if (i == e->flip) seam.direction = 1 - seam.direction;
        status = mus_pattern_add_seam(out, &seam, NULL);
    }
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = e->join[0], seam.edge_b = e->join[1];
    if (status == MUS_OK && e->join[0] != MUS_NONE) status = mus_pattern_add_seam(out, &seam, NULL);
    if (status == MUS_OK) return out;
    mus_pattern_destroy(out);
    return NULL;
}

#endif
