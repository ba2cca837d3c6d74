/*
 * svg_write.c: a pattern as an SVG that drawing programs edit and svg_read.c reads back; see muslin_pattern(5).
 *
 * A panel is a group of class "panel", which Inkscape shows as a layer; an edge is a path with its lines, arcs and
 * Beziers as they are; a seam is a thin line between the middles of its edges. Lengths are millimetres, y downwards.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "exchange/file_read.h"
#include "file/sink.h"
#include "muslin/exchange.h"

#define SVG_GAP 30.0   /* [mm] between panels; chosen: room for a name */
#define SVG_NOTCH 4.0  /* [mm] length of the line of a notch */
#define SVG_SIDES 16   /* straight sides of an edge, to place a name; chosen: as many as a curve needs to the eye */
#define SVG_CROSSINGS 64 /* most crossings of an outline at one height; chosen: a pleated skirt has 30 */
#define SVG_ROW 3000.0 /* [mm] a row of panels is begun anew beyond this width; chosen: a table */

typedef struct svg_writer {
    mus__sink *sink;
    const mus_pattern *pattern;
    double *origins; /* (panels x 2) [mm] on the sheet, y down */
    double *reach;   /* (panels x 2) [m] lowest and highest y of each panel, in its plane */
    double width, height;
} svg_writer;


static void put_escaped(mus__sink *sink, const char *text)
{
    for (const char *at = text; *at != '\0'; at++) {
        if (*at == '&')
            mus__sink_print(sink, "&amp;");
        else if (*at == '<')
            mus__sink_print(sink, "&lt;");
        else if (*at == '"')
            mus__sink_print(sink, "&quot;");
        else if ((unsigned char)*at < 32)
            mus__sink_print(sink, "&#%d;", *at == '\t' || *at == '\n' ? *at : 32);
        else
            mus__sink_add(sink, at, 1);
    }
}


static void put_text(mus__sink *sink, const char *key, const char *value)
{
    if (value == NULL || value[0] == '\0') return;
    mus__sink_print(sink, " %s=\"", key);
    put_escaped(sink, value);
    mus__sink_print(sink, "\"");
}


/* a point of the panel's plane [m], in millimetres, y down */
static void put_point(mus__sink *sink, const double *p)
{
    mus__sink_print(sink, "%.7f,%.7f", 1e3 * p[0], p[1] != 0.0 ? -1e3 * p[1] : 0.0);
}


/* the arc from p through p + 2 to p + 4: radius, the long way round, the side of the turn */
static void put_arc(mus__sink *sink, const double *p)
{
    const double ax = p[2] - p[0], ay = p[3] - p[1], bx = p[4] - p[0], by = p[5] - p[1];
    const double cross = ax * by - ay * bx, chord = sqrt(bx * bx + by * by), cx = p[4] - p[2], cy = p[5] - p[3];
    const double radius = 0.5 * sqrt(ax * ax + ay * ay) * chord * sqrt(cx * cx + cy * cy) / fabs(cross);
    const double sagitta = fabs(cross) / chord;
    /* y is turned over: an arc to the left of its chord has its middle to the right */
    mus__sink_print(sink, " A%.9f,%.9f 0 %d %d ", 1e3 * radius, 1e3 * radius, sagitta > radius, cross < 0.0);
    put_point(sink, p + 4);
}


static void put_edge_data(mus__sink *sink, const mus_pattern *pattern, int32_t edge)
{
    int32_t npiece = 0, nxy = 0;
    const int32_t *kinds;
    const double *xy;
    if (mus_pattern_edge_pieces(pattern, edge, &npiece, &kinds, &nxy, &xy) != MUS_OK) return;
    mus__sink_print(sink, " d=\"M");
    put_point(sink, xy);
    for (int32_t i = 0; i < npiece; i++) {
        const int32_t kind = kinds[i], points = kind == MUS_PIECE_LINE ? 1 : kind == MUS_PIECE_CUBIC ? 3 : 2;
        if (kind == MUS_PIECE_ARC) {
            put_arc(sink, xy);
        } else {
            mus__sink_print(sink, kind == MUS_PIECE_LINE ? " L" : kind == MUS_PIECE_CUBIC ? " C" : " Q");
            for (int32_t k = 1; k <= points; k++) {
                if (k > 1) mus__sink_print(sink, " ");
                put_point(sink, xy + 2 * k);
            }
        }
        xy += 2 * points;
    }
    mus__sink_print(sink, "\"");
}


/* ---- panels ---- */

/* a place for each panel: rows from left to right */
static mus_status place_panels(svg_writer *w)
{
    double x = SVG_GAP, y = SVG_GAP, row = 0.0;
    for (int32_t p = 0; p < mus_pattern_panel_count(w->pattern); p++) {
        double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
        const int32_t *edges;
        int32_t n = 0;
        mus_status status = mus_pattern_outline(w->pattern, p, &n, &edges, NULL);
        for (int32_t i = 0; i < n && status == MUS_OK; i++) {
            const double *xy;
            int32_t nxy = 0;
            status = mus_pattern_edge_pieces(w->pattern, edges[i], NULL, NULL, &nxy, &xy);
            for (int32_t k = 0; k < 2 * nxy; k++) {
                low[k % 2] = fmin(low[k % 2], 1e3 * xy[k]);
                high[k % 2] = fmax(high[k % 2], 1e3 * xy[k]);
            }
        }
        if (status != MUS_OK) return status;
        if (n == 0) low[0] = low[1] = high[0] = high[1] = 0.0;
        if (x > SVG_GAP && x + high[0] - low[0] > SVG_ROW) {
            x = SVG_GAP;
            y += row + SVG_GAP;
            row = 0.0;
        }
        w->origins[2 * p] = x - low[0];
        w->origins[2 * p + 1] = y + high[1];
        w->reach[2 * p] = 1e-3 * low[1];
        w->reach[2 * p + 1] = 1e-3 * high[1];
        x += high[0] - low[0] + SVG_GAP;
        row = fmax(row, high[1] - low[1]);
        w->width = fmax(w->width, x);
    }
    w->height = y + row + SVG_GAP;
    return MUS_OK;
}


static void put_edges(svg_writer *w, int32_t panel)
{
    for (int32_t e = 0; e < mus_pattern_edge_count(w->pattern); e++) {
        if (mus_pattern_edge_panel(w->pattern, e) != panel) continue;
        const double allowance = mus_pattern_edge_allowance(w->pattern, e);
        mus__sink_print(w->sink, "<path class=\"edge\" id=\"e%d\"", (int)e);
        put_text(w->sink, "data-name", mus_pattern_edge_name(w->pattern, e));
        put_text(w->sink, "data-label", mus_pattern_edge_label(w->pattern, e));
        if (allowance == allowance) mus__sink_print(w->sink, " data-allowance=\"%.7f\"", 1e3 * allowance);
        put_edge_data(w->sink, w->pattern, e);
        mus__sink_print(w->sink, "/>\n");
    }
}


/* the order of the outline in numbers of the panel's edges, from 1 */
static mus_status put_word(svg_writer *w, int32_t panel)
{
    const int32_t *edges, *directions;
    int32_t n = 0;
    mus_status status = mus_pattern_outline(w->pattern, panel, &n, &edges, &directions);
    mus__sink_print(w->sink, " data-outline=\"");
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        int32_t number = 1;
        for (int32_t e = 0; e < edges[i]; e++) number += mus_pattern_edge_panel(w->pattern, e) == panel;
        mus__sink_print(w->sink, "%s%d", i > 0 ? " " : "", (int)(directions[i] > 0 ? number : -number));
    }
    mus__sink_print(w->sink, "\"");
    return status;
}


static int by_place(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}


/* the places (SVG_CROSSINGS) [m] where the outline crosses the height y [m], from left to right; their number */
static int32_t cross_outline(const mus_pattern *pattern, int32_t n, const int32_t *edges, double y, double *out)
{
    int32_t count = 0;
    for (int32_t i = 0; i < n; i++) {
        double last[2] = {0.0, 0.0}, p[2];
        for (int32_t k = 0; k <= SVG_SIDES; k++) {
            const double t = (double)k / SVG_SIDES;
            if (mus_pattern_edge_at(pattern, edges[i], 1, &t, p) != MUS_OK) return 0;
            if (k > 0 && count < SVG_CROSSINGS && (last[1] < y) != (p[1] < y))
                out[count++] = last[0] + (p[0] - last[0]) * (y - last[1]) / (p[1] - last[1]);
            memcpy(last, p, sizeof last);
        }
    }
    mus__sort(out, (size_t)count, sizeof *out, by_place);
    return count;
}


/* a place (2) [m] inside a panel, in its plane: the middle of its widest part at half its height */
static mus_status find_place(const svg_writer *w, int32_t panel, double *out)
{
    const int32_t *edges;
    int32_t n = 0;
    const double y = 0.5 * (w->reach[2 * panel] + w->reach[2 * panel + 1]);
    double cross[SVG_CROSSINGS] = {0.0}, widest = -1.0;
    mus_status status = mus_pattern_outline(w->pattern, panel, &n, &edges, NULL);
    const int32_t count = status == MUS_OK ? cross_outline(w->pattern, n, edges, y, cross) : 0;
    out[0] = 0.0, out[1] = y;
    for (int32_t i = 0; i + 1 < count; i += 2) {
        if (cross[i + 1] - cross[i] <= widest) continue;
        widest = cross[i + 1] - cross[i];
        out[0] = 0.5 * (cross[i] + cross[i + 1]);
    }
    return status;
}


/* the name and, through the same place, the grain: 100 mm, or half the height of a low panel */
static mus_status put_name(svg_writer *w, int32_t panel)
{
    double at[2], grain[2];
    mus_status status = find_place(w, panel, at);
    if (status == MUS_OK) status = mus_pattern_grain(w->pattern, panel, grain);
    if (status != MUS_OK) return status;
    const double half = fmin(0.05, fmax(1e-3, 0.25 * (w->reach[2 * panel + 1] - w->reach[2 * panel])));
    const double from[2] = {at[0] - half * grain[0], at[1] - half * grain[1]};
    const double to[2] = {at[0] + half * grain[0], at[1] + half * grain[1]};
    mus__sink_print(w->sink, "<path class=\"grain\" d=\"M");
    put_point(w->sink, from);
    mus__sink_print(w->sink, " L");
    put_point(w->sink, to);
    mus__sink_print(w->sink, "\"/>\n<text class=\"name\" x=\"%.2f\" y=\"%.2f\">", 1e3 * at[0], 0.0 - 1e3 * at[1]);
    put_escaped(w->sink, mus_pattern_panel_name(w->pattern, panel));
    mus__sink_print(w->sink, "</text>\n");
    return status;
}


static mus_status put_marks(svg_writer *w, int32_t panel)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < mus_pattern_mark_count(w->pattern) && status == MUS_OK; i++) {
        int32_t own, n;
        const char *name;
        const double *xy;
        status = mus_pattern_mark(w->pattern, i, &own, &name, &n, &xy);
        if (status != MUS_OK || own != panel) continue;
        mus__sink_print(w->sink, "<path class=\"mark\"");
        put_text(w->sink, "data-name", name);
        mus__sink_print(w->sink, " d=\"");
        for (int32_t k = 0; k < n; k++) {
            mus__sink_print(w->sink, k == 0 ? "M" : " L");
            put_point(w->sink, xy + 2 * k);
        }
        mus__sink_print(w->sink, "\"/>\n");
    }
    return status;
}


static mus_status put_notches(svg_writer *w, int32_t panel)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < mus_pattern_notch_count(w->pattern) && status == MUS_OK; i++) {
        int32_t edge, kind;
        double s, p[2];
        status = mus_pattern_notch(w->pattern, i, &edge, &s, &kind);
        if (status != MUS_OK || mus_pattern_edge_panel(w->pattern, edge) != panel) continue;
        const double length = mus_pattern_edge_length(w->pattern, edge), t = fmin(1.0, fmax(0.0, s / length));
        status = mus_pattern_edge_at(w->pattern, edge, 1, &t, p);
        mus__sink_print(w->sink, "<path class=\"notch\" data-edge=\"e%d\" data-s=\"%.7f\" data-kind=\"%d\" d=\"M",
                        (int)edge, 1e3 * s, (int)kind);
        put_point(w->sink, p);
        mus__sink_print(w->sink, " l0,%g\"/>\n", SVG_NOTCH);
    }
    return status;
}


static mus_status put_panel(svg_writer *w, int32_t panel)
{
    const char *name = mus_pattern_panel_name(w->pattern, panel);
    int32_t count = 0, mirror_of = MUS_NONE;
    mus_status status = mus_pattern_cut(w->pattern, panel, &count, &mirror_of);
    mus__sink_print(w->sink, "<g class=\"panel\" id=\"p%d\" inkscape:groupmode=\"layer\"", (int)panel);
    put_text(w->sink, "inkscape:label", name);
    put_text(w->sink, "data-name", name);
    put_text(w->sink, "data-label", mus_pattern_panel_label(w->pattern, panel));
    mus__sink_print(w->sink, " data-cut=\"%d\" data-layer=\"%d\"", (int)count,
                    (int)mus_pattern_layer(w->pattern, panel));
    for (int32_t i = MUS_MATERIAL_MAIN + 1; i < MUS_MATERIAL_COUNT && status == MUS_OK; i++) {
        status = mus_pattern_material(w->pattern, panel, i, &count, NULL);
        if (count > 0) mus__sink_print(w->sink, " data-%s=\"%d\"", mus_material_name(i), (int)count);
    }
    if (mirror_of != MUS_NONE) put_text(w->sink, "data-mirror-of", mus_pattern_panel_name(w->pattern, mirror_of));
    if (status == MUS_OK) status = put_word(w, panel);
    mus__sink_print(w->sink, " transform=\"translate(%.3f,%.3f)\">\n", w->origins[2 * panel],
                    w->origins[2 * panel + 1]);
    put_edges(w, panel);
    if (status == MUS_OK) status = put_name(w, panel);
    if (status == MUS_OK) status = put_marks(w, panel);
    if (status == MUS_OK) status = put_notches(w, panel);
    mus__sink_print(w->sink, "</g>\n");
    return status;
}


static mus_status put_seams(svg_writer *w)
{
    mus_status status = MUS_OK;
    mus__sink_print(w->sink, "<g id=\"seams\" inkscape:groupmode=\"layer\" inkscape:label=\"seams\">\n");
    for (int32_t i = 0; i < mus_pattern_seam_count(w->pattern) && status == MUS_OK; i++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        status = mus_pattern_seam(w->pattern, i, &def);
        const int32_t ends[2] = {def.edge_a, def.edge_b};
        mus__sink_print(w->sink, "<path class=\"seam\" data-a=\"e%d\" data-b=\"e%d\"", (int)ends[0], (int)ends[1]);
        if (def.direction == MUS_SEAM_DIRECT) mus__sink_print(w->sink, " data-direction=\"direct\"");
        mus__sink_print(w->sink, " data-ease=\"%.7f\" data-tolerance=\"%.7f\"", 1e3 * def.ease, 1e3 * def.tolerance);
        if (def.laid) mus__sink_print(w->sink, " data-laid=\"1\"");
        if (def.closure != 0)
            mus__sink_print(w->sink, " data-closure=\"%d\" data-open=\"%d\" data-buttons=\"%d\"", (int)def.closure,
                            def.open != 0, (int)def.buttons);
        for (int32_t k = 0; k < 2 && status == MUS_OK; k++) {
            const double half = 0.5, *origin = w->origins + 2 * mus_pattern_edge_panel(w->pattern, ends[k]);
            double p[2];
            status = mus_pattern_edge_at(w->pattern, ends[k], 1, &half, p);
            mus__sink_print(w->sink, "%s%.2f,%.2f", k == 0 ? " d=\"M" : " L", origin[0] + 1e3 * p[0],
                            origin[1] - 1e3 * p[1]);
        }
        mus__sink_print(w->sink, "\"/>\n");
    }
    mus__sink_print(w->sink, "</g>\n");
    return status;
}


static mus_status put_document(svg_writer *w)
{
    mus_status status = place_panels(w);
    mus__sink_print(w->sink,
                    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
                    "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"%.3fmm\" "
                    "height=\"%.3fmm\" viewBox=\"0 0 %.3f %.3f\"",
                    w->width, w->height, w->width, w->height);
    put_text(w->sink, "data-name", mus_pattern_name(w->pattern));
    mus__sink_print(w->sink,
                    ">\n<style>path{fill:none;stroke:#000;stroke-width:0.5} .seam{stroke:#c33;stroke-width:0.2} "
                    ".grain,.mark{stroke:#36c} .name{font:12px sans-serif;text-anchor:middle}</style>\n");
    for (int32_t p = 0; p < mus_pattern_panel_count(w->pattern) && status == MUS_OK; p++) status = put_panel(w, p);
    if (status == MUS_OK) status = put_seams(w);
    mus__sink_print(w->sink, "</svg>\n");
    return status;
}


static mus_status svg_write(const mus_pattern *pattern, const mus__target *target, const char *what)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    mus__locale locale;
    mus__sink sink;
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK) status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;
    mus__sink_init(&sink, context);
    svg_writer w = {.sink = &sink, .pattern = pattern};
    const size_t npanel = (size_t)mus_pattern_panel_count(pattern) + 1;
    w.origins = mus_context_alloc(context, NULL, 4 * npanel * sizeof *w.origins);
    w.reach = w.origins != NULL ? w.origins + 2 * npanel : NULL;
    status = w.origins != NULL ? put_document(&w) : mus__file_fail(context, MUS_ERR_MEMORY, "no memory for a drawing");
    if (status == MUS_OK) status = mus__sink_give(&sink, target);
    mus_context_alloc(context, w.origins, 0);
    mus__sink_free(&sink);
    mus__locale_leave(&locale);
    return status;
}


mus_status mus_pattern_write_svg(const mus_pattern *pattern, const char *path)
{
    return svg_write(pattern, &(mus__target){path, NULL, NULL}, "mus_pattern_write_svg");
}


mus_status mus_pattern_write_svg_bytes(const mus_pattern *pattern, char **bytes, size_t *size)
{
    return svg_write(pattern, &(mus__target){NULL, bytes, size}, "mus_pattern_write_svg_bytes");
}
