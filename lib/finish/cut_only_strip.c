/*
 * cut_only_strip.c: rectangles that are cut and not draped: bands of rib, pockets, belt loops, elastic.
 */
#include "finish/cut_only.h"


/* marks the line that a strip is folded along: its upper edge, or its middle, whose middle third is left to the label.
 * Each half has a mark of its own, so that the half that is printed on the fold of the cloth has its word */
static void strip_fold(mus__cut_only *job, const mus__cut_strip *strip, int32_t panel)
{
    const double x = 0.5 * strip->length, y = strip->halved ? 0.5 * strip->width : strip->width;
    const double within = strip->halved ? x / 3.0 : 0.0;
    if (!strip->halved && !(strip->turned > 0.0)) return;
    for (int32_t i = 0; i < 2 && job->status == MUS_OK; i++) {
        const double sign = i == 0 ? -1.0 : 1.0, half[4] = {sign * x, y, within > 0.0 ? sign * within : 0.0, y};
        job->status = mus_pattern_add_mark(job->made, panel, "fold", 2, half, NULL);
    }
}


void mus__cut_strip_add(mus__cut_only *job, const mus__cut_strip *strip)
{
    static const char *const names[4] = {"low", "end", "top", "end"};
    static const int32_t along[4] = {1, 1, 1, 1};
    const double x = 0.5 * strip->length, xy[4][2] = {{-x, 0.0}, {x, 0.0}, {x, strip->width}, {-x, strip->width}};
    const bool cloth = strip->material != MUS_MATERIAL_ELASTIC && strip->material != MUS_MATERIAL_INTERFACING;
    const double seam = cloth ? MUS__SEAM_ALLOWANCE : 0.0; /* elastic and what is fused are sewn to nothing */
    const double widths[4] = {strip->seam > 0.0 ? strip->seam : seam, seam, strip->turned > 0.0 ? strip->turned : seam,
                              seam};
    int32_t panel = MUS_NONE, point[4], edge[4];
    if (job->status != MUS_OK || !(strip->length > 0.0)) return;
    job->status = mus_pattern_add_panel(job->made, strip->name, &panel);
    for (int32_t i = 0; i < 4 && job->status == MUS_OK; i++)
        job->status = mus_pattern_add_point(job->made, panel, xy[i][0], xy[i][1], &point[i]);
    for (int32_t i = 0; i < 4 && job->status == MUS_OK; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.name = names[i], def.start = point[i], def.end = point[(i + 1) % 4];
        job->status = mus_pattern_add_edge(job->made, &def, &edge[i]);
        if (job->status == MUS_OK) job->status = mus_pattern_set_edge_label(job->made, edge[i], names[i]);
        if (job->status == MUS_OK) job->status = mus_pattern_set_edge_allowance(job->made, edge[i], widths[i]);
    }
    if (job->status == MUS_OK) job->status = mus_pattern_set_outline(job->made, panel, 4, edge, along);
    if (job->status == MUS_OK) job->status = mus_pattern_set_panel_label(job->made, panel, strip->label);
    if (job->status == MUS_OK && strip->lengthwise) job->status = mus_pattern_set_grain(job->made, panel, 1.0, 0.0);
    if (job->status == MUS_OK) job->status = mus_pattern_set_cut(job->made, panel, 0, MUS_NONE);
    if (job->status == MUS_OK)
        job->status = mus_pattern_set_material(job->made, panel, strip->material, strip->count);
    for (int32_t i = 0; i < strip->nnotch && job->status == MUS_OK; i++)
        job->status = mus_pattern_add_notch(job->made, edge[0], strip->notch[i] * strip->length, MUS_NOTCH_SINGLE,
                                            NULL);
    strip_fold(job, strip, panel);
    if (job->status == MUS_OK && strip->interfacing > 0)
        job->status = mus_pattern_set_material(job->made, panel, MUS_MATERIAL_INTERFACING, strip->interfacing);
}
