/*
 * pattern_json_read.c: read a pattern from muslin's own JSON.
 *
 * The lists hold cells in the order of their indices. Each cell is added by the public calls, so a file gets the same
 * checks as a pattern made by a program, and their messages get the place in the file in front. Counts are the lengths
 * of the arrays in the file: no number in a file sizes an allocation. Form: muslin_pattern(5).
 */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "exchange/json_path.h"
#include "exchange/pattern_readers.h"

/* longest array; chosen: its length times 3 still fits in an int32_t */
#define JSON_COUNT_MAX ((size_t)INT32_MAX / 4)

/* reader of one element of a list of the document */
typedef mus_status (*json_cell_fn)(const mus__json_at *at, mus_pattern *pattern);


/* read an optional text; a missing one is "" */
static mus_status read_name(const mus__json_at *at, const char *key, const char **out)
{
    *out = "";
    mus__json_at text = mus__json_member(at, key);
    return text.json != NULL ? mus__json_text(&text, out) : MUS_OK;
}


/* read the index of a cell, 0 .. count - 1 */
static mus_status read_index(const mus__json_at *at, const char *key, int32_t count, int32_t *out)
{
    mus__json_at index = mus__json_member(at, key);
    if (count == 0)
        return mus__json_fail(&index, MUS_ERR_FORMAT, "points at a cell, but the file has none of its kind");
    return mus__json_integer(&index, 0, count - 1, out);
}


static mus_status read_list(const mus__json_at *root, const char *key, json_cell_fn cell, mus_pattern *pattern)
{
    size_t count;
    mus__json_at list = mus__json_member(root, key);
    mus_status status = mus__json_array(&list, 0, JSON_COUNT_MAX, &count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        mus__json_at at = mus__json_element(&list, i);
        status = mus__json_expect(&at, JSON_OBJECT);
        if (status == MUS_OK) status = cell(&at, pattern);
    }
    return status;
}


/* read the sides that a panel is on; without the member its name tells them */
static mus_status read_sides(const mus__json_at *at, mus_pattern *pattern, int32_t panel)
{
    static const char *const names[] = {"front", "back", "left", "right"};
    mus__json_at list = mus__json_member(at, "sides");
    if (list.json == NULL) return MUS_OK;
    size_t count = 0;
    int32_t sides = 0;
    mus_status status = mus__json_array(&list, 0, 4, &count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        const char *text;
        int32_t k = 0;
        mus__json_at one = mus__json_element(&list, i);
        status = mus__json_text(&one, &text);
        while (status == MUS_OK && k < 4 && strcmp(text, names[k]) != 0) k++;
        if (status == MUS_OK && k == 4)
            status = mus__json_fail(&one, MUS_ERR_FORMAT, "expected front, back, left or right, got \"%.40s\"", text);
        sides |= MUS_SIDE_FRONT << k;
    }
    if (status != MUS_OK) return status;
    status = mus_pattern_set_panel_sides(pattern, panel, sides);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(&list, status);
}


static mus_status read_panel(const mus__json_at *at, mus_pattern *pattern)
{
    if (at->index >= MUS__FILE_PANELS_MAX)
        return mus__json_fail(at, MUS_ERR_LIMIT, "the limit is %d panels", MUS__FILE_PANELS_MAX);
    const char *name, *label;
    int32_t panel;
    double grain[2];
    mus__json_at member = mus__json_member(at, "name");
    mus_status status = mus__json_text(&member, &name);
    if (status == MUS_OK) status = read_name(at, "label", &label);
    if (status != MUS_OK) return status;

    status = mus_pattern_add_panel(pattern, name, &panel);
    if (status == MUS_OK) status = mus_pattern_set_panel_label(pattern, panel, label);
    if (status != MUS_OK) return mus__json_wrap(at, status);
    status = read_sides(at, pattern, panel);
    if (status != MUS_OK) return status;

    member = mus__json_member(at, "grain");
    status = mus__json_numbers(&member, 2, grain);
    if (status != MUS_OK) return status;
    status = mus_pattern_set_grain(pattern, panel, grain[0], grain[1]);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(&member, status);
}


static mus_status read_placement(const mus__json_at *at, mus_pattern *pattern, int32_t panel)
{
    mus_placement placement;
    mus_placement_init(&placement, sizeof placement);
    mus__json_at where = mus__json_member(at, "placement");
    if (where.json == NULL) return MUS_OK;
    mus_status status = mus__json_expect(&where, JSON_OBJECT);
    mus__json_at member = mus__json_member(&where, "origin");
    if (status == MUS_OK) status = mus__json_numbers(&member, 3, placement.origin);
    member = mus__json_member(&where, "rotation");
    if (status == MUS_OK) status = mus__json_numbers(&member, 9, placement.rotation);
    member = mus__json_member(&where, "bend");
    if (status == MUS_OK) status = mus__json_number(&member, &placement.bend);
    member = mus__json_member(&where, "bend_x");
    if (status == MUS_OK) status = mus__json_number(&member, &placement.bend_x);
    member = mus__json_member(&where, "fold");
    if (status == MUS_OK && member.json != NULL) status = mus__json_number(&member, &placement.fold);
    if (status != MUS_OK) return status;
    status = mus_pattern_set_placement(pattern, panel, &placement);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(&where, status);
}


/* read the outline of a panel, after its edges */
static mus_status read_outline(const mus__json_at *at, mus_pattern *pattern, int32_t panel)
{
    size_t count;
    mus__json_at outline = mus__json_member(at, "outline");
    mus_status status = mus__json_array(&outline, 0, JSON_COUNT_MAX, &count);
    if (status != MUS_OK || count == 0) return status;

    mus_context *context = at->source->context;
    int32_t *words = mus_context_alloc(context, NULL, 2 * count * sizeof *words);
    if (words == NULL) return mus__json_fail(&outline, MUS_ERR_MEMORY, "no memory for %zu edges", count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        size_t two;
        mus__json_at pair = mus__json_element(&outline, i);
        status = mus__json_array(&pair, 2, 2, &two);
        if (status != MUS_OK) break;
        mus__json_at edge = mus__json_element(&pair, 0), direction = mus__json_element(&pair, 1);
        status = mus__json_integer(&edge, 0, mus_pattern_edge_count(pattern) - 1, &words[i]);
        if (status == MUS_OK) status = mus__json_integer(&direction, -1, 1, &words[count + i]);
    }
    if (status == MUS_OK) {
        status = mus_pattern_set_outline(pattern, panel, (int32_t)count, words, words + count);
        if (status != MUS_OK) status = mus__json_wrap(&outline, status);
    }
    mus_context_alloc(context, words, 0);
    return status;
}


/* read the pieces of materials beside the main cloth: {"interfacing": 1}; optional */
static mus_status read_materials(const mus__json_at *at, mus_pattern *pattern, int32_t panel)
{
    mus__json_at materials = mus__json_member(at, "materials");
    if (materials.json == NULL) return MUS_OK;
    mus_status status = mus__json_expect(&materials, JSON_OBJECT);
    for (int32_t i = MUS_MATERIAL_MAIN + 1; i < MUS_MATERIAL_COUNT && status == MUS_OK; i++) {
        int32_t count;
        mus__json_at member = mus__json_member(&materials, mus_material_name(i));
        if (member.json == NULL) continue;
        status = mus__json_integer(&member, 0, INT32_MAX, &count);
        if (status != MUS_OK) return status;
        status = mus_pattern_set_material(pattern, panel, i, count);
        if (status != MUS_OK) status = mus__json_wrap(&member, status);
    }
    return status;
}


/* read the members of panels that refer to edges and to other panels */
static mus_status read_making(const mus__json_at *root, mus_pattern *pattern)
{
    mus_status status = MUS_OK;
    mus__json_at panels = mus__json_member(root, "panels");
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern) && status == MUS_OK; i++) {
        int32_t cut, mirror_of = MUS_NONE;
        mus__json_at at = mus__json_element(&panels, (size_t)i);
        mus__json_at member = mus__json_member(&at, "cut");
        status = mus__json_integer(&member, 0, INT32_MAX, &cut);
        if (status == MUS_OK && json_object_get(at.json, "mirror_of") != NULL)
            status = read_index(&at, "mirror_of", mus_pattern_panel_count(pattern), &mirror_of);
        if (status == MUS_OK) {
            status = mus_pattern_set_cut(pattern, i, cut, mirror_of);
            if (status != MUS_OK) status = mus__json_wrap(&at, status);
        }
        if (status == MUS_OK) status = read_materials(&at, pattern, i);
        member = mus__json_member(&at, "layer");
        int32_t layer = 0;
        if (status == MUS_OK && member.json != NULL)
            status = mus__json_integer(&member, 0, MUS_LAYERS_MOST - 1, &layer);
        if (status == MUS_OK) status = mus_pattern_set_layer(pattern, i, layer);
        if (status == MUS_OK) status = read_placement(&at, pattern, i);
        if (status == MUS_OK) status = read_outline(&at, pattern, i);
    }
    return status;
}


static mus_status read_point(const mus__json_at *at, mus_pattern *pattern)
{
    int32_t panel, point;
    double xy[2];
    mus__json_at member = mus__json_member(at, "at");
    mus_status status = read_index(at, "panel", mus_pattern_panel_count(pattern), &panel);
    if (status == MUS_OK) status = mus__json_numbers(&member, 2, xy);
    if (status != MUS_OK) return status;
    status = mus_pattern_add_point(pattern, panel, xy[0], xy[1], &point);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(at, status);
}


/* the segments of an edge, in the arrays that mus_pattern_add_edge takes */
struct json_chain {
    int32_t *kinds; /* (npiece) */
    double *xy;     /* (at most 3 npiece x 2) two control points and an end for each segment [m] */
    int32_t nxy;
};


/* append a point [x, y] */
static mus_status chain_point(struct json_chain *chain, const mus__json_at *at)
{
    mus_status status = mus__json_numbers(at, 2, chain->xy + 2 * chain->nxy);
    if (status == MUS_OK) chain->nxy++;
    return status;
}


static mus_status chain_piece(struct json_chain *chain, const mus__json_at *at, int32_t index, bool last)
{
    static const struct {
        const char *name;
        int32_t kind;
        size_t controls;
    } kinds[] = {{"line", MUS_PIECE_LINE, 0},
                 {"quadratic", MUS_PIECE_QUADRATIC, 1},
                 {"cubic", MUS_PIECE_CUBIC, 2},
                 {"arc", MUS_PIECE_ARC, 1}};
    const char *name;
    mus_status status = mus__json_expect(at, JSON_OBJECT);
    if (status != MUS_OK) return status;
    mus__json_at member = mus__json_member(at, "kind");
    status = mus__json_text(&member, &name);
    if (status != MUS_OK) return status;
    size_t k = 0;
    while (k < 4 && strcmp(name, kinds[k].name) != 0) k++;
    if (k == 4)
        return mus__json_fail(&member, MUS_ERR_FORMAT, "expected line, quadratic, cubic or arc, got \"%.40s\"", name);
    chain->kinds[index] = kinds[k].kind;

    /* its control points, and its end, which the last segment leaves out */
    size_t count = 0;
    mus__json_at controls = mus__json_member(at, "controls");
    if (kinds[k].controls > 0 || controls.json != NULL)
        status = mus__json_array(&controls, kinds[k].controls, kinds[k].controls, &count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        mus__json_at control = mus__json_element(&controls, i);
        status = chain_point(chain, &control);
    }
    mus__json_at end = mus__json_member(at, "end");
    if (last && end.json != NULL)
        return mus__json_fail(&end, MUS_ERR_FORMAT, "the last piece ends where its edge ends, expected nothing here");
    if (status == MUS_OK && !last) status = chain_point(chain, &end);
    return status;
}


static mus_status read_chain(const mus__json_at *at, mus_pattern *pattern, const char *name, int32_t *edge)
{
    size_t count;
    int32_t start, end;
    mus__json_at pieces = mus__json_member(at, "pieces");
    mus_status status = read_index(at, "start", mus_pattern_point_count(pattern), &start);
    if (status == MUS_OK) status = read_index(at, "end", mus_pattern_point_count(pattern), &end);
    if (status == MUS_OK) status = mus__json_array(&pieces, 1, JSON_COUNT_MAX, &count);
    if (status != MUS_OK) return status;

    /* one allocation for both arrays, doubles first */
    mus_context *context = at->source->context;
    double *block = mus_context_alloc(context, NULL, count * (6 * sizeof(double) + sizeof(int32_t)));
    if (block == NULL) return mus__json_fail(&pieces, MUS_ERR_MEMORY, "no memory for %zu pieces", count);
    struct json_chain chain = {.kinds = (int32_t *)(void *)(block + 6 * count), .xy = block};
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        mus__json_at piece = mus__json_element(&pieces, i);
        status = chain_piece(&chain, &piece, (int32_t)i, i + 1 == count);
    }
    if (status == MUS_OK) {
        status = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                               .name = name[0] != '\0' ? name : NULL,
                                                               .start = start, .end = end,
                                                               .npiece = (int32_t)count, .kinds = chain.kinds,
                                                               .nxy = chain.nxy,
                                                               .xy = chain.nxy > 0 ? chain.xy : NULL}, edge);
        if (status != MUS_OK) status = mus__json_wrap(at, status);
    }
    mus_context_alloc(context, block, 0);
    return status;
}


/* attachment {"at": level, "below": m} and elastic {"ratio": r, "stiffness": N} of an edge; both are optional */
static mus_status read_stay(const mus__json_at *at, mus_pattern *pattern, int32_t edge)
{
    mus_status status = MUS_OK;
    double below, ratio, stiffness;
    mus__json_at hold = mus__json_member(at, "hold"), elastic = mus__json_member(at, "elastic"), member;
    if (hold.json != NULL) {
        const char *name = "";
        status = mus__json_expect(&hold, JSON_OBJECT);
        member = mus__json_member(&hold, "at");
        if (status == MUS_OK) status = mus__json_text(&member, &name);
        if (status == MUS_OK && mus_hold_find(name) < 0)
            return mus__json_fail(&member, MUS_ERR_FORMAT, "expected a level (neck, waist ...), got \"%.40s\"", name);
        member = mus__json_member(&hold, "below");
        if (status == MUS_OK) status = mus__json_number(&member, &below);
        if (status != MUS_OK) return status;
        status = mus_pattern_set_edge_hold(pattern, edge, mus_hold_find(name), below);
        if (status != MUS_OK) return mus__json_wrap(&hold, status);
    }
    if (elastic.json == NULL) return MUS_OK;
    status = mus__json_expect(&elastic, JSON_OBJECT);
    member = mus__json_member(&elastic, "ratio");
    if (status == MUS_OK) status = mus__json_number(&member, &ratio);
    member = mus__json_member(&elastic, "stiffness");
    if (status == MUS_OK) status = mus__json_number(&member, &stiffness);
    if (status != MUS_OK) return status;
    status = mus_pattern_set_edge_elastic(pattern, edge, ratio, stiffness);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(&elastic, status);
}


static mus_status read_edge(const mus__json_at *at, mus_pattern *pattern)
{
    const char *name, *label;
    int32_t edge;
    double allowance = NAN;
    mus__json_at member = mus__json_member(at, "allowance");
    mus_status status = read_name(at, "name", &name);
    if (status == MUS_OK) status = read_name(at, "label", &label);
    if (status == MUS_OK && member.json != NULL) status = mus__json_number(&member, &allowance);
    if (status == MUS_OK) status = read_chain(at, pattern, name, &edge);
    if (status != MUS_OK) return status;
    status = mus_pattern_set_edge_label(pattern, edge, label);
    if (status == MUS_OK && member.json != NULL) status = mus_pattern_set_edge_allowance(pattern, edge, allowance);
    return status == MUS_OK ? read_stay(at, pattern, edge) : mus__json_wrap(at, status);
}


/* read the optional members of a seam */
static mus_status read_joining(const mus__json_at *at, mus_seam_def *seam)
{
    const mus__json_at laid = mus__json_member(at, "laid"), open = mus__json_member(at, "open"),
                      buttons = mus__json_member(at, "buttons"), closure = mus__json_member(at, "closure");
    mus_status status = MUS_OK;
    if (laid.json != NULL) status = mus__json_integer(&laid, 0, 1, &seam->laid);
    if (status == MUS_OK && open.json != NULL) status = mus__json_integer(&open, 0, 1, &seam->open);
    if (status == MUS_OK && buttons.json != NULL) status = mus__json_integer(&buttons, 0, INT32_MAX, &seam->buttons);
    if (status != MUS_OK || closure.json == NULL) return status;
    const char *name;
    status = mus__json_text(&closure, &name);
    if (status != MUS_OK) return status;
    static const char *const closures[] = {MUS__JSON_CLOSURES};
    for (seam->closure = MUS_CLOSURE_TIES; seam->closure > MUS_CLOSURE_NONE; seam->closure--)
        if (strcmp(name, closures[seam->closure]) == 0) return MUS_OK;
    return mus__json_fail(&closure, MUS_ERR_FORMAT, "expected zip, buttons or ties, got \"%.40s\"", name);
}


static mus_status read_seam(const mus__json_at *at, mus_pattern *pattern)
{
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    const char *direction;
    int32_t edges = mus_pattern_edge_count(pattern);
    mus__json_at run = mus__json_member(at, "direction"), ease = mus__json_member(at, "ease"),
                tolerance = mus__json_member(at, "tolerance");
    mus_status status = read_index(at, "a", edges, &seam.edge_a);
    if (status == MUS_OK) status = read_index(at, "b", edges, &seam.edge_b);
    if (status == MUS_OK) status = mus__json_text(&run, &direction);
    if (status == MUS_OK) status = mus__json_number(&ease, &seam.ease);
    if (status == MUS_OK) status = mus__json_number(&tolerance, &seam.tolerance);
    if (status == MUS_OK) status = read_joining(at, &seam);
    if (status != MUS_OK) return status;
    bool direct = strcmp(direction, "direct") == 0;
    if (!direct && strcmp(direction, "reversed") != 0)
        return mus__json_fail(&run, MUS_ERR_FORMAT, "expected reversed or direct, got \"%.40s\"", direction);
    seam.direction = direct ? MUS_SEAM_DIRECT : MUS_SEAM_REVERSED;
    status = mus_pattern_add_seam(pattern, &seam, NULL);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(at, status);
}


static mus_status read_notch(const mus__json_at *at, mus_pattern *pattern)
{
    int32_t edge, kind;
    double s;
    mus__json_at arc = mus__json_member(at, "s"), form = mus__json_member(at, "kind");
    mus_status status = read_index(at, "edge", mus_pattern_edge_count(pattern), &edge);
    if (status == MUS_OK) status = mus__json_integer(&form, MUS_NOTCH_SINGLE, MUS_NOTCH_TRIPLE, &kind);
    if (status == MUS_OK) status = mus__json_number(&arc, &s);
    if (status != MUS_OK) return status;
    status = mus_pattern_add_notch(pattern, edge, s, kind, NULL);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(at, status);
}


static mus_status read_mark(const mus__json_at *at, mus_pattern *pattern)
{
    const char *name;
    int32_t panel;
    size_t count;
    mus__json_at points = mus__json_member(at, "points");
    mus_status status = read_index(at, "panel", mus_pattern_panel_count(pattern), &panel);
    if (status == MUS_OK) status = read_name(at, "name", &name);
    if (status == MUS_OK) status = mus__json_array(&points, 1, JSON_COUNT_MAX, &count);
    if (status != MUS_OK) return status;

    mus_context *context = at->source->context;
    double *xy = mus_context_alloc(context, NULL, 2 * count * sizeof *xy);
    if (xy == NULL) return mus__json_fail(&points, MUS_ERR_MEMORY, "no memory for %zu points", count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        mus__json_at point = mus__json_element(&points, i);
        status = mus__json_numbers(&point, 2, xy + 2 * i);
    }
    if (status == MUS_OK) {
        status = mus_pattern_add_mark(pattern, panel, name, (int32_t)count, xy, NULL);
        if (status != MUS_OK) status = mus__json_wrap(at, status);
    }
    mus_context_alloc(context, xy, 0);
    return status;
}


static mus_status read_opening(const mus__json_at *at, mus_pattern *pattern)
{
    const char *label;
    mus__json_at text = mus__json_member(at, "label");
    mus_status status = mus__json_text(&text, &label);
    if (status != MUS_OK) return status;
    status = mus_pattern_add_opening(pattern, label);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(at, status);
}


/* cells first, then the members that refer to them */
static mus_status read_members(const mus__json_at *root, mus_pattern *pattern)
{
    mus_status status = read_list(root, "panels", read_panel, pattern);
    if (status == MUS_OK) status = read_list(root, "points", read_point, pattern);
    if (status == MUS_OK) status = read_list(root, "edges", read_edge, pattern);
    if (status == MUS_OK) status = read_making(root, pattern);
    if (status == MUS_OK) status = read_list(root, "seams", read_seam, pattern);
    if (status == MUS_OK) status = read_list(root, "notches", read_notch, pattern);
    if (status == MUS_OK) status = read_list(root, "marks", read_mark, pattern);
    if (status == MUS_OK && mus__json_member(root, "openings").json != NULL)
        status = read_list(root, "openings", read_opening, pattern);
    return status;
}


/* read the panels that are cut and not draped: an object with the members of a pattern; optional */
static mus_status read_cut_only(const mus__json_at *root, mus_pattern *pattern)
{
    const mus__json_at own = mus__json_member(root, "cut_only");
    if (own.json == NULL) return MUS_OK;
    const char *name;
    mus_pattern *panels;
    const mus__json_at title = mus__json_member(&own, "name");
    mus_status status = mus__json_expect(&own, JSON_OBJECT);
    if (status == MUS_OK) status = mus__json_text(&title, &name);
    if (status != MUS_OK) return status;
    status = mus_pattern_create(mus_pattern_context(pattern), name, &panels);
    if (status != MUS_OK) return mus__json_wrap(&title, status);
    status = read_members(&own, panels);
    if (status == MUS_OK) {
        status = mus_pattern_set_cut_only(pattern, panels);
        if (status != MUS_OK) status = mus__json_wrap(&own, status);
    }
    mus_pattern_destroy(panels);
    return status;
}


mus_status mus__pattern_read_json(const mus__json_at *root, mus_pattern *pattern)
{
    /* the head: format, unit, name */
    int32_t version;
    const char *unit, *name;
    mus__json_at form = mus__json_member(root, "muslin_pattern"), measure = mus__json_member(root, "unit"),
                title = mus__json_member(root, "name");
    mus_status status = mus__json_integer(&form, 1, 1, &version);
    if (status == MUS_OK) status = mus__json_text(&measure, &unit);
    if (status == MUS_OK && strcmp(unit, "m") != 0)
        status = mus__json_fail(&measure, MUS_ERR_FORMAT, "expected \"m\", got \"%.40s\"", unit);
    if (status == MUS_OK) status = mus__json_text(&title, &name);
    if (status != MUS_OK) return status;
    status = mus_pattern_set_name(pattern, name);
    if (status != MUS_OK) return mus__json_wrap(&title, status);
    status = read_members(root, pattern);
    return status == MUS_OK ? read_cut_only(root, pattern) : status;
}
