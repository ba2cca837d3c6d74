/*
 * pattern_json_write.c: write a pattern as muslin's own JSON, one cell on each line.
 *
 * All cells stand in flat lists in the order of their indices. The reader adds them in the same order, so every index
 * means the same cell again. Numbers have as many digits as the double needs to be read back exactly (at most 17).
 * Optional members with their default value (names, labels, allowances) are left out. Form: muslin_pattern(5).
 */
#include "exchange/file_read.h"
#include "exchange/pattern_readers.h"
#include "file/sink.h"


/* [a, b, ...] */
static void put_numbers(mus__sink *sink, int32_t n, const double *values)
{
    for (int32_t i = 0; i < n; i++) {
        mus__sink_print(sink, i == 0 ? "[" : ", ");
        mus__sink_number(sink, values[i]);
    }
    mus__sink_print(sink, "]");
}


/* , "key": "text" unless it is empty */
static void put_text(mus__sink *sink, const char *key, const char *text)
{
    if (text == NULL || text[0] == '\0') return;
    mus__sink_print(sink, ", \"%s\": ", key);
    mus__sink_quote(sink, text);
}


/* start a list of cells */
static void put_list(mus__sink *sink, const char *key)
{
    mus__sink_print(sink, ",\n \"%s\": [", key);
}


/* write the sides that a panel is on, unless they are left to its name */
static void put_sides(mus__sink *sink, const mus_pattern *pattern, int32_t panel)
{
    static const char *const names[] = {"front", "back", "left", "right"};
    int32_t given;
    const int32_t sides = mus_pattern_panel_sides(pattern, panel, &given);
    if (!given) return;
    mus__sink_print(sink, ", \"sides\": [");
    for (int32_t i = 0, n = 0; i < 4; i++)
        if ((sides & MUS_SIDE_FRONT << i) != 0) mus__sink_print(sink, "%s\"%s\"", n++ > 0 ? ", " : "", names[i]);
    mus__sink_print(sink, "]");
}


/* write the pieces of materials beside the main cloth, where there are any */
static mus_status put_materials(mus__sink *sink, const mus_pattern *pattern, int32_t panel)
{
    mus_status status = MUS_OK;
    int32_t n = 0;
    for (int32_t i = MUS_MATERIAL_MAIN + 1; i < MUS_MATERIAL_COUNT && status == MUS_OK; i++) {
        int32_t count;
        status = mus_pattern_material(pattern, panel, i, &count, NULL);
        if (status != MUS_OK || count == 0) continue;
        mus__sink_print(sink, "%s\"%s\": %d", n++ == 0 ? ", \"materials\": {" : ", ", mus_material_name(i), (int)count);
    }
    if (n > 0) mus__sink_print(sink, "}");
    return status;
}


static void put_item(mus__sink *sink, int32_t index)
{
    mus__sink_print(sink, index == 0 ? "\n  " : ",\n  ");
}


static mus_status put_panel(mus__sink *sink, const mus_pattern *pattern, int32_t panel)
{
    double grain[2];
    int32_t count, mirror_of, n;
    const int32_t *edges, *directions;
    mus_placement placement;
    mus_placement_init(&placement, sizeof placement);
    mus_status status = mus_pattern_grain(pattern, panel, grain);
    if (status == MUS_OK) status = mus_pattern_cut(pattern, panel, &count, &mirror_of);
    if (status == MUS_OK) status = mus_pattern_placement(pattern, panel, &placement);
    if (status == MUS_OK) status = mus_pattern_outline(pattern, panel, &n, &edges, &directions);
    if (status != MUS_OK) return status;

    mus__sink_print(sink, "{\"name\": ");
    mus__sink_quote(sink, mus_pattern_panel_name(pattern, panel));
    put_text(sink, "label", mus_pattern_panel_label(pattern, panel));
    put_sides(sink, pattern, panel);
    mus__sink_print(sink, ", \"grain\": ");
    put_numbers(sink, 2, grain);
    mus__sink_print(sink, ", \"cut\": %d", (int)count);
    status = put_materials(sink, pattern, panel);
    if (mirror_of >= 0) mus__sink_print(sink, ", \"mirror_of\": %d", (int)mirror_of);
    if (mus_pattern_layer(pattern, panel) > 0)
        mus__sink_print(sink, ", \"layer\": %d", (int)mus_pattern_layer(pattern, panel));
    mus__sink_print(sink, ",\n   \"placement\": {\"origin\": ");
    put_numbers(sink, 3, placement.origin);
    mus__sink_print(sink, ", \"rotation\": ");
    put_numbers(sink, 9, placement.rotation);
    mus__sink_print(sink, ", \"bend\": ");
    mus__sink_number(sink, placement.bend);
    mus__sink_print(sink, ", \"bend_x\": ");
    mus__sink_number(sink, placement.bend_x);
    if (placement.fold != 0.0) {
        mus__sink_print(sink, ", \"fold\": ");
        mus__sink_number(sink, placement.fold);
    }
    mus__sink_print(sink, "},\n   \"outline\": [");
    for (int32_t i = 0; i < n; i++)
        mus__sink_print(sink, "%s[%d, %d]", i == 0 ? "" : ", ", (int)edges[i], (int)directions[i]);
    mus__sink_print(sink, "]}");
    return status;
}


/* write the segments of an edge: kind, control points, and the end of each but the last */
static void put_pieces(mus__sink *sink, int32_t npiece, const int32_t *kinds, const double *xy)
{
    static const char *const names[] = {"line", "quadratic", "cubic", "arc"};
    static const int32_t controls[] = {0, 1, 2, 1};
    const double *at = xy + 2;
    mus__sink_print(sink, ", \"pieces\": [");
    for (int32_t i = 0; i < npiece; i++) {
        int32_t n = controls[kinds[i]];
        mus__sink_print(sink, "%s{\"kind\": \"%s\"", i == 0 ? "" : ", ", names[kinds[i]]);
        for (int32_t j = 0; j < n; j++) {
            mus__sink_print(sink, j == 0 ? ", \"controls\": [" : ", ");
            put_numbers(sink, 2, at + 2 * j);
        }
        if (n > 0) mus__sink_print(sink, "]");
        if (i + 1 < npiece) {
            mus__sink_print(sink, ", \"end\": ");
            put_numbers(sink, 2, at + 2 * n);
        }
        mus__sink_print(sink, "}");
        at += 2 * (n + 1);
    }
    mus__sink_print(sink, "]");
}


/* write attachment and elastic of an edge, where it has them */
static mus_status put_stay(mus__sink *sink, const mus_pattern *pattern, int32_t edge)
{
    int32_t level;
    double below, ratio, stiffness;
    mus_status status = mus_pattern_edge_hold(pattern, edge, &level, &below);
    if (status == MUS_OK) status = mus_pattern_edge_elastic(pattern, edge, &ratio, &stiffness);
    if (status == MUS_OK && level != MUS_HOLD_NONE) {
        mus__sink_print(sink, ", \"hold\": {\"at\": \"%s\", \"below\": ", mus_hold_name(level));
        mus__sink_number(sink, below);
        mus__sink_print(sink, "}");
    }
    if (status == MUS_OK && stiffness > 0.0) {
        mus__sink_print(sink, ", \"elastic\": {\"ratio\": ");
        mus__sink_number(sink, ratio);
        mus__sink_print(sink, ", \"stiffness\": ");
        mus__sink_number(sink, stiffness);
        mus__sink_print(sink, "}");
    }
    return status;
}


static mus_status put_edge(mus__sink *sink, const mus_pattern *pattern, int32_t edge)
{
    int32_t start, end, npiece, nxy;
    const int32_t *kinds;
    const double *xy;
    mus_status status = mus_pattern_edge_ends(pattern, edge, &start, &end);
    if (status == MUS_OK) status = mus_pattern_edge_pieces(pattern, edge, &npiece, &kinds, &nxy, &xy);
    if (status != MUS_OK) return status;

    mus__sink_print(sink, "{\"start\": %d, \"end\": %d", (int)start, (int)end);
    put_text(sink, "name", mus_pattern_edge_name(pattern, edge));
    put_text(sink, "label", mus_pattern_edge_label(pattern, edge));
    double allowance = mus_pattern_edge_allowance(pattern, edge);
    if (allowance == allowance) {
        mus__sink_print(sink, ", \"allowance\": ");
        mus__sink_number(sink, allowance);
    }
    status = put_stay(sink, pattern, edge);
    put_pieces(sink, npiece, kinds, xy);
    mus__sink_print(sink, "}");
    return status;
}


static mus_status put_cells(mus__sink *sink, const mus_pattern *pattern)
{
    mus_status status = MUS_OK;
    put_list(sink, "panels");
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern) && status == MUS_OK; i++) {
        put_item(sink, i);
        status = put_panel(sink, pattern, i);
    }
    mus__sink_print(sink, "]");

    put_list(sink, "points");
    for (int32_t i = 0; i < mus_pattern_point_count(pattern) && status == MUS_OK; i++) {
        int32_t panel = 0;
        double xy[2] = {0.0, 0.0};
        status = mus_pattern_point(pattern, i, &panel, xy);
        put_item(sink, i);
        mus__sink_print(sink, "{\"panel\": %d, \"at\": ", (int)panel);
        put_numbers(sink, 2, xy);
        mus__sink_print(sink, "}");
    }
    mus__sink_print(sink, "]");

    put_list(sink, "edges");
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern) && status == MUS_OK; i++) {
        put_item(sink, i);
        status = put_edge(sink, pattern, i);
    }
    mus__sink_print(sink, "]");
    return status;
}


static mus_status put_seams(mus__sink *sink, const mus_pattern *pattern)
{
    static const char *const closures[] = {MUS__JSON_CLOSURES};
    mus_status status = MUS_OK;
    put_list(sink, "seams");
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern) && status == MUS_OK; i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        status = mus_pattern_seam(pattern, i, &seam);
        put_item(sink, i);
        mus__sink_print(sink, "{\"a\": %d, \"b\": %d, \"direction\": \"%s\", \"ease\": ", (int)seam.edge_a,
                        (int)seam.edge_b, seam.direction == MUS_SEAM_DIRECT ? "direct" : "reversed");
        mus__sink_number(sink, seam.ease);
        mus__sink_print(sink, ", \"tolerance\": ");
        mus__sink_number(sink, seam.tolerance);
        if (seam.laid) mus__sink_print(sink, ", \"laid\": 1");
        if (seam.closure != MUS_CLOSURE_NONE) mus__sink_print(sink, ", \"closure\": \"%s\"", closures[seam.closure]);
        if (seam.open) mus__sink_print(sink, ", \"open\": 1");
        if (seam.buttons > 0) mus__sink_print(sink, ", \"buttons\": %d", (int)seam.buttons);
        mus__sink_print(sink, "}");
    }
    mus__sink_print(sink, "]");
    return status;
}


static mus_status put_marks(mus__sink *sink, const mus_pattern *pattern)
{
    mus_status status = MUS_OK;
    put_list(sink, "notches");
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern) && status == MUS_OK; i++) {
        int32_t edge = 0, kind = 0;
        double s = 0.0;
        status = mus_pattern_notch(pattern, i, &edge, &s, &kind);
        put_item(sink, i);
        mus__sink_print(sink, "{\"edge\": %d, \"kind\": %d, \"s\": ", (int)edge, (int)kind);
        mus__sink_number(sink, s);
        mus__sink_print(sink, "}");
    }
    mus__sink_print(sink, "]");

    put_list(sink, "marks");
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern) && status == MUS_OK; i++) {
        int32_t panel = 0, n = 0;
        const char *name = NULL;
        const double *xy = NULL;
        status = mus_pattern_mark(pattern, i, &panel, &name, &n, &xy);
        put_item(sink, i);
        mus__sink_print(sink, "{\"panel\": %d", (int)panel);
        put_text(sink, "name", name);
        mus__sink_print(sink, ", \"points\": [");
        for (int32_t j = 0; j < n && status == MUS_OK; j++) {
            if (j > 0) mus__sink_print(sink, ", ");
            put_numbers(sink, 2, xy + 2 * j);
        }
        mus__sink_print(sink, "]}");
    }
    mus__sink_print(sink, "]");

    if (mus_pattern_opening_count(pattern) > 0) put_list(sink, "openings");
    for (int32_t i = 0; i < mus_pattern_opening_count(pattern); i++) {
        put_item(sink, i);
        mus__sink_print(sink, "{\"label\": ");
        mus__sink_quote(sink, mus_pattern_opening(pattern, i));
        mus__sink_print(sink, "}");
    }
    if (mus_pattern_opening_count(pattern) > 0) mus__sink_print(sink, "]");
    return status;
}


/* write all of a pattern but its name and the panels that are cut and not draped */
static mus_status put_members(mus__sink *sink, const mus_pattern *pattern)
{
    mus_status status = put_cells(sink, pattern);
    if (status == MUS_OK) status = put_seams(sink, pattern);
    return status == MUS_OK ? put_marks(sink, pattern) : status;
}


static mus_status pattern_save(const mus_pattern *pattern, const mus__target *target, const char *what)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    mus_status status = mus__target_check(context, target, what);
    if (status != MUS_OK) return status;
    mus__locale locale;
    status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;

    mus__sink sink;
    mus__sink_init(&sink, context);
    mus__sink_print(&sink, "{\"muslin_pattern\": 1,\n \"unit\": \"m\",\n \"name\": ");
    mus__sink_quote(&sink, mus_pattern_name(pattern));
    status = put_members(&sink, pattern);
    const mus_pattern *cut_only = mus_pattern_cut_only(pattern);
    if (status == MUS_OK && cut_only != NULL) {
        mus__sink_print(&sink, ",\n \"cut_only\": {\"name\": ");
        mus__sink_quote(&sink, mus_pattern_name(cut_only));
        status = put_members(&sink, cut_only);
        mus__sink_print(&sink, "}");
    }
    mus__sink_print(&sink, "\n}\n");
    if (status == MUS_OK) status = mus__sink_give(&sink, target);
    mus__sink_free(&sink);
    mus__locale_leave(&locale);
    return status;
}


mus_status mus_pattern_write(const mus_pattern *pattern, const char *path)
{
    return pattern_save(pattern, &(mus__target){path, NULL, NULL}, "mus_pattern_write");
}


mus_status mus_pattern_write_bytes(const mus_pattern *pattern, char **bytes, size_t *size)
{
    return pattern_save(pattern, &(mus__target){NULL, bytes, size}, "mus_pattern_write_bytes");
}
