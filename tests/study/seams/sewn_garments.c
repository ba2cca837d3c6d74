/*
 * sewn_garments.c: reads named designs and GarmentCode specifications for `make seams`, and takes their seams away.
 */
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "sewn_garments.h"

#define ONE_JUDGED 5 /* of so many drawings one is judged; chosen: the others are enough to fit */


static void give_up(mus_context *context, const char *what)
{
    fprintf(stderr, "seams: %s: %s\n", what, mus_context_error(context));
    exit(1);
}


static garment *add_garment(garments *to, mus_context *context, mus_pattern *pattern, const char *name)
{
    to->list = realloc(to->list, (size_t)(to->n + 1) * sizeof *to->list);
    if (to->list == NULL) exit(1);
    garment *g = &to->list[to->n++];
    memset(g, 0, sizeof *g);
    snprintf(g->name, sizeof g->name, "%s", name);
    if (mus__seam_read(pattern, &g->facts) != MUS_OK) give_up(context, name);
    g->truth = malloc(sizeof *g->truth * (size_t)(g->facts.n + 1));
    memcpy(g->truth, g->facts.fixed, sizeof *g->truth * (size_t)g->facts.n);
    for (int32_t i = 0; i < g->facts.n; i++) {
        g->facts.fixed[i] = MUS_NONE;
        if (g->truth[i] <= i || !mus__seam_never(&g->facts, i, g->truth[i])) continue;
        fprintf(stderr, "seams: %s has a seam that no garment should have\n", name);
        exit(1);
    }
    g->pattern = pattern;
    return g;
}


/* A garment without some of its parts is one more to fit: that without its sleeves, without what stands at its neck,
 * its upper half, its lower half */
static void add_parts(garments *to, mus_context *context, const mus_pattern *whole, const char *name)
{
    static const int32_t less[][6] = {
        {MUS__SEAM_ROLE_SLEEVE, MUS__SEAM_ROLE_CUFF},
        {MUS__SEAM_ROLE_COLLAR, MUS__SEAM_ROLE_HOOD},
        {MUS__SEAM_ROLE_SKIRT, MUS__SEAM_ROLE_INSERT, MUS__SEAM_ROLE_LEG, MUS__SEAM_ROLE_BAND},
        {MUS__SEAM_ROLE_TORSO, MUS__SEAM_ROLE_SLEEVE, MUS__SEAM_ROLE_CUFF, MUS__SEAM_ROLE_COLLAR, MUS__SEAM_ROLE_HOOD}};
    const mus__seam_facts facts = to->list[to->n - 1].facts;
    for (size_t i = 0; i < sizeof less / sizeof *less; i++) {
        mus_pattern *part = NULL;
        int32_t left = facts.npanel;
        if (mus_pattern_copy(whole, &part) != MUS_OK) give_up(context, name);
        for (int32_t p = facts.npanel - 1; p >= 0; p--)
            for (int32_t k = 0; k < 6 && less[i][k] != MUS__SEAM_ROLE_NONE; k++)
                if (facts.panels[p].role == less[i][k]) {
                    if (mus_pattern_remove_panel(part, p) != MUS_OK) give_up(context, name);
                    left--;
                }
        if (left < 2 || left == facts.npanel) {
            mus_pattern_destroy(part);
            continue;
        }
        add_garment(to, context, part, name)->part = true;
    }
}


static uint32_t hash_text(const char *text)
{
    uint32_t hash = 2166136261u;
    for (; *text != '\0'; text++) hash = (hash ^ (uint32_t)(unsigned char)*text) * 16777619u;
    return hash ^ (hash >> 15);
}


void garments_add_designs(garments *to, mus_context *context, int32_t every)
{
    static const char *const sizes[] = {"W40", "M50", "C116"};
    mus_tape *tapes[3] = {NULL};
    for (int32_t i = 0; i < 3; i++)
        if (mus_tape_create(context, &tapes[i]) != MUS_OK || mus_tape_set_size(tapes[i], sizes[i]) != MUS_OK ||
            mus_tape_complete(tapes[i]) != MUS_OK)
            give_up(context, sizes[i]);
    for (int32_t i = 0; i < mus_design_count(); i += every) {
        const int32_t groups = mus_design_groups(i), tape = groups & 1 ? 0 : groups & 2 ? 1 : 2;
        mus_pattern *pattern = NULL;
        if (mus_design_draft(context, i, tapes[tape], NULL, &pattern) != MUS_OK) {
            fprintf(stderr, "seams: %s is not drafted: %s\n", mus_design_name(i), mus_context_error(context));
            continue;
        }
        garment *g = add_garment(to, context, pattern, mus_design_name(i));
        g->kind = OF_DESIGN;
        const uint32_t half = to->mixed ? (uint32_t)(i / every) : hash_text(mus_design_family(i));
        g->judged = (half % 2 != 0) != to->swap;
    }
    for (int32_t i = 0; i < 3; i++) mus_tape_destroy(tapes[i]);
}


/* the pattern of a file, without the labels of its panels: a DXF of the garment has names alone */
static mus_pattern *read_drawing(mus_context *context, const char *path, const char *name)
{
    mus_pattern *pattern = NULL;
    if (mus_pattern_read(context, path, &pattern) != MUS_OK) give_up(context, name);
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++)
        if (mus_pattern_set_panel_label(pattern, p, "") != MUS_OK) give_up(context, name);
    return pattern;
}


void garments_add_drawings(garments *to, mus_context *context, const char *folder)
{
    char path[1024];
    glob_t found;
    to->drawn = true;
    snprintf(path, sizeof path, "%s/*_specification.json", folder);
    if (glob(path, 0, NULL, &found) != 0) {
        fprintf(stderr, "seams: the folder %s has no file *_specification.json\n", folder);
        exit(1);
    }
    for (size_t i = 0; i < found.gl_pathc; i++) {
        const char *name = strrchr(found.gl_pathv[i], '/') + 1;
        garment *g = add_garment(to, context, read_drawing(context, found.gl_pathv[i], name), name);
        g->kind = OF_DRAWING;
        g->judged = i % ONE_JUDGED == 0;
    }
    globfree(&found);
}


void garments_add_specifications(garments *to, mus_context *context, const char *data, bool parts)
{
    static const char *const folders[] = {"specs", "originals"};
    for (int32_t f = 0; f < 2; f++) {
        char path[1024];
        glob_t found;
        snprintf(path, sizeof path, "%s/garmentcode/%s/*_specification.json", data, folders[f]);
        if (glob(path, 0, NULL, &found) != 0) continue;
        for (size_t i = 0; i < found.gl_pathc; i++) {
            const char *name = strrchr(found.gl_pathv[i], '/') + 1;
            int32_t a = 0, number = 0;
            if (sscanf(name, "d%d_%d", &a, &number) != 2) number = (int32_t)hash_text(name);
            mus_pattern *pattern = read_drawing(context, found.gl_pathv[i], name);
            const bool judged = to->drawn || (number % 2 != 0) != to->swap;
            add_garment(to, context, pattern, name)->judged = judged;
            if (parts && !judged && strstr(name, "mean_all") != NULL) add_parts(to, context, pattern, name);
        }
        globfree(&found);
    }
}
