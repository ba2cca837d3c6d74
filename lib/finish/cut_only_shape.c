/*
 * cut_only_shape.c: panels of chords that are cut and not draped: a shape, and a shape with its mirror image.
 */
#include <stdio.h>

#include "finish/cut_only.h"


void mus__cut_shape_begin(mus__cut_shape *shape, const char *label, double x, double y)
{
    *shape = (mus__cut_shape){.label = label, .grain = {0.0, 1.0}};
    shape->xy[0][0] = x, shape->xy[0][1] = y;
    shape->nxy = 1;
}


void mus__cut_shape_to(mus__cut_shape *shape, double x, double y)
{
    if (shape->nxy == MUS__CUT_POINTS) shape->full = true;
    if (shape->full) return;
    shape->xy[shape->nxy][0] = x, shape->xy[shape->nxy][1] = y;
    shape->nxy++;
}


void mus__cut_shape_edge(mus__cut_shape *shape, const char *name, const char *label, double allowance)
{
    if (shape->nedge == MUS__CUT_EDGES) shape->full = true;
    if (shape->full) return;
    shape->edge[shape->nedge++] = (mus__cut_shape_side){name, label, allowance, shape->nxy - 1};
}


/* add edge i of the shape between two points of the panel; mirrored it runs backwards */
static int32_t shape_edge(mus__cut_only *job, const mus__cut_shape *shape, int32_t i, bool mirrored, int32_t start,
                          int32_t end)
{
    double xy[MUS__CUT_POINTS][2];
    int32_t kinds[MUS__CUT_POINTS] = {MUS_PIECE_LINE}, made = MUS_NONE;
    const int32_t first = i > 0 ? shape->edge[i - 1].last : 0, last = shape->edge[i].last, n = last - first - 1;
    for (int32_t k = 0; k < n; k++) {
        const double *p = shape->xy[mirrored ? last - 1 - k : first + 1 + k];
        xy[k][0] = mirrored ? -p[0] : p[0], xy[k][1] = p[1];
    }
    mus_edge_def def;
    mus_edge_def_init(&def, sizeof def);
    def.name = shape->edge[i].name, def.start = start, def.end = end;
    def.npiece = n + 1, def.kinds = kinds, def.nxy = n, def.xy = n > 0 ? xy[0] : NULL;
    if (job->status == MUS_OK) job->status = mus_pattern_add_edge(job->made, &def, &made);
    if (job->status == MUS_OK) job->status = mus_pattern_set_edge_allowance(job->made, made, shape->edge[i].allowance);
    if (job->status == MUS_OK) job->status = mus_pattern_set_edge_label(job->made, made, shape->edge[i].label);
    return made;
}


/* add the panel, or its mirror image, without pieces */
static int32_t shape_panel(mus__cut_only *job, const mus__cut_shape *shape, const char *name, bool mirrored)
{
    int32_t panel = MUS_NONE, point[MUS__CUT_EDGES], word[MUS__CUT_EDGES], along[MUS__CUT_EDGES];
    const int32_t n = shape->nedge;
    if (shape->full && job->status == MUS_OK)
        job->status = mus__fail(mus_pattern_context(job->made), MUS_ERR_LIMIT, "piece %s: more than %d points", name,
                                MUS__CUT_POINTS);
    if (job->status == MUS_OK) job->status = mus_pattern_add_panel(job->made, name, &panel);
    for (int32_t i = 0; i < n && job->status == MUS_OK; i++) {
        const double *p = shape->xy[i > 0 ? shape->edge[i - 1].last : 0];
        job->status = mus_pattern_add_point(job->made, panel, mirrored ? -p[0] : p[0], p[1], &point[i]);
    }
    for (int32_t k = 0; k < n && job->status == MUS_OK; k++) {
        const int32_t i = mirrored ? n - 1 - k : k, next = (i + 1) % n;
        along[k] = 1;
        word[k] = shape_edge(job, shape, i, mirrored, point[mirrored ? next : i], point[mirrored ? i : next]);
    }
    if (job->status == MUS_OK) job->status = mus_pattern_set_outline(job->made, panel, n, word, along);
    if (job->status == MUS_OK) job->status = mus_pattern_set_panel_label(job->made, panel, shape->label);
    if (job->status == MUS_OK)
        job->status = mus_pattern_set_grain(job->made, panel, mirrored ? -shape->grain[0] : shape->grain[0],
                                            shape->grain[1]);
    return panel;
}


int32_t mus__cut_shape_add(mus__cut_only *job, const mus__cut_shape *shape, const char *name, int32_t material,
                           int32_t count)
{
    const int32_t panel = shape_panel(job, shape, name, false);
    if (job->status == MUS_OK) job->status = mus_pattern_set_cut(job->made, panel, 0, MUS_NONE);
    if (job->status == MUS_OK) job->status = mus_pattern_set_material(job->made, panel, material, count);
    return job->status == MUS_OK ? panel : MUS_NONE;
}


void mus__cut_shape_pair(mus__cut_only *job, const mus__cut_shape *shape, const char *name, int32_t material,
                         int32_t count)
{
    char both[2][MUS__NAME_BYTES];
    for (int32_t i = 0; i < 2; i++) snprintf(both[i], sizeof both[i], "%s_%s", name, i == 0 ? "left" : "right");
    const int32_t left = mus__cut_shape_add(job, shape, both[0], material, 2 * count);
    const int32_t right = shape_panel(job, shape, both[1], true);
    if (job->status == MUS_OK) job->status = mus_pattern_set_cut(job->made, right, 0, left);
    if (job->status == MUS_OK) job->status = mus_pattern_set_material(job->made, right, material, count);
}
