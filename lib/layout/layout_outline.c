/*
 * layout_outline.c: the cut lines of a pattern's panels, in the frame of the cloth: grain along x, right side up.
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "layout/layout_internal.h"

#define OUTLINE_SAME 5e-5 /* [m] two cut lines this near are one; that of a half on paper (lib/print/piece_fold.c) */
#define OUTLINE_SAME_NOTCH 1e-3 /* [m] two notches this near are mirror images; as there */


void mus__layout_outline_free(mus_context *context, mus__layout_outline *outline)
{
    mus__free(context, outline->turns);
    mus__layout_polygon_free(context, &outline->cut);
    mus__layout_polygon_free(context, &outline->grown);
    mus__layout_polygon_free(context, &outline->half);
    mus__layout_polygon_free(context, &outline->grown_half);
}


static void outline_turn(const mus__layout_outline *outline, const double *p, double *out)
{
    const double *turn = outline->turn;
    out[0] = turn[0] * p[0] + turn[1] * p[1];
    out[1] = turn[2] * p[0] + turn[3] * p[1];
}


/* the place and kind of a notch in the frame of the cloth; false when it is not on the panel */
static bool outline_notch(const mus_pattern *pattern, int32_t notch, int32_t panel, const mus__layout_outline *outline,
                          double *out, int32_t *kind)
{
    int32_t edge;
    double s, xy[2];
    if (mus_pattern_notch(pattern, notch, &edge, &s, kind) != MUS_OK) return false;
    if (mus_pattern_edge_panel(pattern, edge) != panel) return false;
    const double t = fmin(1.0, s / mus_pattern_edge_length(pattern, edge));
    if (mus_pattern_edge_at(pattern, edge, 1, &t, xy) != MUS_OK) return false;
    outline_turn(outline, xy, out);
    return true;
}


/* has each notch of the panel one of its kind at its mirror image? In the line where coordinate d is `axis` */
static bool outline_notches(const mus_pattern *pattern, int32_t panel, const mus__layout_outline *outline, int32_t d,
                            double axis)
{
    const int32_t n = mus_pattern_notch_count(pattern);
    for (int32_t i = 0; i < n; i++) {
        int32_t kind, other;
        double p[2], q[2];
        bool found = false;
        if (!outline_notch(pattern, i, panel, outline, p, &kind)) continue;
        for (int32_t j = 0; j < n && !found; j++)
            found = outline_notch(pattern, j, panel, outline, q, &other) && other == kind &&
                    fabs(p[1 - d] - q[1 - d]) + fabs(p[d] + q[d] - 2.0 * axis) < OUTLINE_SAME_NOTCH;
        if (!found) return false;
    }
    return true;
}


/* is the panel its own mirror image, cut line and notches, in the line where coordinate d is `axis`? */
static bool outline_mirrors(const mus_pattern *pattern, int32_t panel, const mus__layout_outline *outline, int32_t d,
                            double axis)
{
    const mus__layout_polygon *cut = &outline->cut;
    for (int32_t i = 0; i < cut->n; i++) {
        double p[2] = {cut->xy[2 * i], cut->xy[2 * i + 1]};
        p[d] = 2.0 * axis - p[d];
        if (mus__polygon_distance(cut->n, cut->xy, p) > OUTLINE_SAME) return false;
    }
    return outline_notches(pattern, panel, outline, d, axis);
}


/* set the turn of a panel and its cut line in the frame of the cloth; a panel that is drawn wrong side up is mirrored
 */
static mus_status outline_cut(mus_context *context, const mus_pattern *pattern, int32_t panel, double allowance,
                              mus__layout_outline *outline)
{
    mus_cut_line *line = NULL;
    double grain[2];
    const double *xy;
    int32_t n;
    mus_status status = mus_pattern_cut_line(pattern, panel, allowance, &line);
    if (status == MUS_OK) status = mus_pattern_grain(pattern, panel, grain);
    if (status == MUS_OK) status = mus_cut_line_loop(line, 0, &n, &xy);
    if (status == MUS_OK) status = mus__layout_polygon_make(context, n, &outline->cut);
    if (status == MUS_OK) {
        const double area = mus__polygon_area(n, xy), side = area < 0.0 ? -1.0 : 1.0;
        const double turn[4] = {grain[0], grain[1], -side * grain[1], side * grain[0]};
        memcpy(outline->turn, turn, sizeof turn);
        outline->area = fabs(area);
        /* the loop of a mirrored panel is read backwards, so that it runs counter-clockwise */
        for (int32_t i = 0; i < n; i++)
            outline_turn(outline, xy + 2 * i, outline->cut.xy + 2 * (side > 0.0 ? i : n - 1 - i));
    }
    mus_cut_line_destroy(line);
    return status;
}


/* make the outline of a panel; `offset` is added to its number */
static mus_status outline_panel(const mus_layout *layout, const mus_pattern *pattern, int32_t panel, int32_t offset,
                                mus__layout_outline *outline)
{
    mus_context *context = layout->context;
    outline->panel = offset + panel;
    const char *name = mus_pattern_panel_name(pattern, panel);
    strncpy(outline->name, name != NULL ? name : "", sizeof outline->name - 1);
    mus_status status = outline_cut(context, pattern, panel, layout->def.allowance, outline);
    if (status != MUS_OK) return status;
    mus__layout_polygon *cut = &outline->cut;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (int32_t i = 0; i < 2 * cut->n; i++) {
        low[i % 2] = fmin(low[i % 2], cut->xy[i]);
        high[i % 2] = fmax(high[i % 2], cut->xy[i]);
    }
    outline->axis = 0.5 * (low[1] + high[1]);
    outline->symmetric = outline_mirrors(pattern, panel, outline, 1, outline->axis);
    outline->across = outline_mirrors(pattern, panel, outline, 0, 0.5 * (low[0] + high[0]));
    /* the axis becomes y = 0; mus_layout_piece_get() undoes it */
    for (int32_t i = 0; i < cut->n; i++) cut->xy[2 * i + 1] -= outline->axis;
    return mus__layout_outline_grow(layout, outline);
}


/* make the outlines of all panels of a pattern that are cut of the material */
static mus_status outlines_of(mus_layout *layout, const mus_pattern *pattern, int32_t offset, int32_t *room)
{
    for (int32_t panel = 0; panel < mus_pattern_panel_count(pattern); panel++) {
        int32_t count = 0, mirrored = 0, mirror_of = MUS_NONE;
        mus_status status = mus_pattern_cut(pattern, panel, NULL, &mirror_of);
        if (status == MUS_OK) status = mus_pattern_material(pattern, panel, layout->def.material, &count, &mirrored);
        if (status != MUS_OK) return status;
        if (mirror_of != MUS_NONE || count == 0) continue;
        status = mus__reserve(layout->context, &layout->outlines, room, layout->noutline + 1, sizeof *layout->outlines);
        if (status != MUS_OK) return mus__fail_memory(layout->context, "the outlines of a layout");
        mus__layout_outline *outline = &layout->outlines[layout->noutline++];
        outline->count = count;
        outline->mirrored = mirrored != 0;
        status = outline_panel(layout, pattern, panel, offset, outline);
        if (status != MUS_OK) return status;
    }
    return MUS_OK;
}


mus_status mus__layout_outlines(mus_layout *layout, const mus_pattern *pattern)
{
    int32_t room = 0;
    mus_status status = outlines_of(layout, pattern, 0, &room);
    const mus_pattern *more = mus_pattern_cut_only(pattern);
    if (status == MUS_OK && more != NULL) status = outlines_of(layout, more, mus_pattern_panel_count(pattern), &room);
    return status;
}
