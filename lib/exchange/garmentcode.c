/*
 * garmentcode.c: read a GarmentCode specification (*_specification.json) as a pattern.
 *
 * A panel of a specification is a loop of vertices and edges with a translation and a rotation; a stitch joins two
 * edges. The direction of a loop is kept: its right-hand normal after placement is the right side of the cloth. The
 * edges of a stitch differ in length on purpose (gathers, ease), so the ease of a seam is the difference in the file.
 *
 * Curves, for an edge from a to b with e = b - a and perp = e turned a quarter to the left:
 *     Bezier control point (cx, cy):  a + cx e + cy perp
 *     circle (radius, large, right):  half way along the arc = a + e/2 + h (left or right normal)
 *                                     h = r -+ sqrt(r^2 - |e|^2/4), - for the short way, + for the long way round
 * Placement: X = R (x, y, 0) + translation, R = Rx Ry Rz of the angles in degrees.
 *
 * Names of panels are words with '_' between them ("sl_left_cuff_f"). The reader takes labels and sides of panels from
 * them, for a file labels a collar "body", and tells no sides.
 * Source: Korosteleva and Sorkine-Hornung, GarmentCode: Programming Parametric Sewing Patterns, 2023, and its files.
 */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/elementary.h"
#include "exchange/file_read.h"
#include "exchange/json_path.h"
#include "exchange/pattern_readers.h"

#define GC_COUNT_MAX 100000 /* most vertices of a panel, and stitches; chosen: far above any garment */
#define GC_CHORD_SLACK 1e-6 /* a chord may exceed the diameter by this ratio; chosen: a half circle in few digits */

/* data of a panel that stitches need */
struct gc_panel {
    int32_t first_edge;
    int32_t edge_count;
};

struct gc_reader {
    mus_pattern *pattern;
    double metre; /* length of one unit of the file [m] */
    struct gc_panel *panels;
};


/* R = Rx Ry Rz, row-major; multiples of a right angle are exact */
static void gc_rotation(const double *degrees, double *r)
{
    double c[3], s[3];
    for (int32_t i = 0; i < 3; i++) {
        double turns = degrees[i] / 90.0;
        bool right = turns == floor(turns);
        double quarter = fmod(fmod(turns, 4.0) + 4.0, 4.0);
        c[i] = !right ? mus__cos(degrees[i] * MUS__DEGREE) : quarter == 0.0 ? 1.0 : quarter == 2.0 ? -1.0 : 0.0;
        s[i] = !right ? mus__sin(degrees[i] * MUS__DEGREE) : quarter == 1.0 ? 1.0 : quarter == 3.0 ? -1.0 : 0.0;
    }
    const double rows[9] = {
        c[1] * c[2],
        -c[1] * s[2],
        s[1],
        c[0] * s[2] + s[0] * s[1] * c[2],
        c[0] * c[2] - s[0] * s[1] * s[2],
        -s[0] * c[1],
        s[0] * s[2] - c[0] * s[1] * c[2],
        s[0] * c[2] + c[0] * s[1] * s[2],
        c[0] * c[1],
    };
    memcpy(r, rows, sizeof rows);
}


static mus_status gc_placement(const struct gc_reader *reader, const mus__json_at *at, int32_t panel)
{
    double translation[3], degrees[3];
    mus__json_at where = mus__json_member(at, "translation"), turn = mus__json_member(at, "rotation");
    mus_status status = mus__json_numbers(&where, 3, translation);
    if (status == MUS_OK) status = mus__json_numbers(&turn, 3, degrees);
    if (status != MUS_OK) return status;

    mus_placement placement;
    mus_placement_init(&placement, sizeof placement);
    for (int32_t i = 0; i < 3; i++) placement.origin[i] = translation[i] * reader->metre;
    gc_rotation(degrees, placement.rotation);
    status = mus_pattern_set_placement(reader->pattern, panel, &placement);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(at, status);
}


/* read `count` control points, relative to the edge from a to b, to xy [m] */
static mus_status gc_bezier(const mus__json_at *params, size_t count, const double *a, const double *b, double *xy)
{
    size_t n;
    mus_status status = mus__json_array(params, count, count, &n);
    double ex = b[0] - a[0], ey = b[1] - a[1];
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        double c[2];
        mus__json_at point = mus__json_element(params, i);
        status = mus__json_numbers(&point, 2, c);
        if (status != MUS_OK) break;
        xy[2 * i] = a[0] + c[0] * ex - c[1] * ey;
        xy[2 * i + 1] = a[1] + c[0] * ey + c[1] * ex;
    }
    return status;
}


/* compute the point half way along a circular arc from a to b */
static mus_status gc_circle(const struct gc_reader *reader, const mus__json_at *params, const double *a,
                            const double *b, double *xy)
{
    double given[3];
    mus_status status = mus__json_numbers(params, 3, given);
    if (status != MUS_OK) return status;
    double r = given[0] * reader->metre;
    bool large = given[1] != 0.0, right = given[2] != 0.0;
    double ex = b[0] - a[0], ey = b[1] - a[1], chord = mus__hypot(ex, ey);
    if (!(r > 0.0) || chord > 2.0 * r * (1.0 + GC_CHORD_SLACK))
        return mus__json_fail(params, MUS_ERR_FORMAT, "a circle of radius %g m cannot span an edge of %g m", r, chord);

    /* long way: h = r + sqrt(r^2 - c^2/4); short way: (c^2/4) / h, which loses no digits in a flat arc */
    double quarter = 0.25 * chord * chord;
    double h = r + sqrt(fmax(0.0, r * r - quarter));
    if (!large) h = quarter / h;
    double side = (right ? -h : h) / chord;
    xy[0] = 0.5 * (a[0] + b[0]) - side * ey;
    xy[1] = 0.5 * (a[1] + b[1]) + side * ex;
    return MUS_OK;
}


/* read kind and control points of an edge; without curvature it is a line */
static mus_status gc_curve(const struct gc_reader *reader, const mus__json_at *edge, const double *a, const double *b,
                           int32_t *kind, double *xy)
{
    *kind = MUS_PIECE_LINE;
    mus__json_at curve = mus__json_member(edge, "curvature");
    if (curve.json == NULL) return MUS_OK;

    /* old files have only the control point of a quadratic */
    *kind = MUS_PIECE_QUADRATIC;
    if (json_is_array(curve.json)) {
        json_t *one = json_pack("[O]", curve.json);
        if (one == NULL) return mus__json_fail(&curve, MUS_ERR_MEMORY, "no memory for a curve");
        mus__json_at wrapped = {curve.source, edge, "curvature", 0, one};
        mus_status status = gc_bezier(&wrapped, 1, a, b, xy);
        json_decref(one);
        return status;
    }

    const char *type;
    mus_status status = mus__json_expect(&curve, JSON_OBJECT);
    if (status != MUS_OK) return status;
    mus__json_at member = mus__json_member(&curve, "type"), params = mus__json_member(&curve, "params");
    status = mus__json_text(&member, &type);
    if (status != MUS_OK) return status;
    if (strcmp(type, "quadratic") == 0) return gc_bezier(&params, 1, a, b, xy);
    *kind = MUS_PIECE_CUBIC;
    if (strcmp(type, "cubic") == 0) return gc_bezier(&params, 2, a, b, xy);
    *kind = MUS_PIECE_ARC;
    if (strcmp(type, "circle") == 0) return gc_circle(reader, &params, a, b, xy);
    return mus__json_fail(&member, MUS_ERR_FORMAT, "expected quadratic, cubic or circle, got \"%.40s\"", type);
}


/* labels of edges that are attached to the body, the level, and the distance below it that the edge may not exceed. A
 * strapless top ends 3 cm below the armpit; chosen: higher up it would be pinched between arm and torso */
static const struct {
    const char *label;
    int32_t level;
    double below; /* [m] */
} gc_holds[] = {{"lower_interface", MUS_HOLD_WAIST, 0.0}, {"strapless_top", MUS_HOLD_ARMPIT, 0.03}};


static mus_status gc_edge(const struct gc_reader *reader, const mus__json_at *at, int32_t first_point, int32_t points,
                          int32_t *out)
{
    mus_status status = mus__json_expect(at, JSON_OBJECT);
    if (status != MUS_OK) return status;
    size_t two;
    int32_t end[2], kind, edge;
    mus__json_at ends = mus__json_member(at, "endpoints");
    status = mus__json_array(&ends, 2, 2, &two);
    for (size_t i = 0; i < 2 && status == MUS_OK; i++) {
        mus__json_at one = mus__json_element(&ends, i);
        status = mus__json_integer(&one, 0, points - 1, &end[i]);
    }
    if (status != MUS_OK) return status;

    /* the curve [m]; its ends are in metres already */
    double a[2], b[2], xy[4];
    static const int32_t controls[] = {0, 1, 2, 1};
    mus_pattern_point(reader->pattern, first_point + end[0], NULL, a);
    mus_pattern_point(reader->pattern, first_point + end[1], NULL, b);
    if (end[0] == end[1] || (a[0] == b[0] && a[1] == b[1]))
        return mus__json_fail(at, MUS_ERR_FORMAT, "an edge between two points at one place");
    status = gc_curve(reader, at, a, b, &kind, xy);
    if (status != MUS_OK) return status;
    status = mus_pattern_add_edge(reader->pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                   .start = first_point + end[0],
                                                                   .end = first_point + end[1], .npiece = 1,
                                                                   .kinds = &kind, .nxy = controls[kind],
                                                                   .xy = controls[kind] > 0 ? xy : NULL}, &edge);
    if (status != MUS_OK) return mus__json_wrap(at, status);
    *out = edge;

    const char *text;
    mus__json_at label = mus__json_member(at, "label");
    if (label.json == NULL) return MUS_OK;
    status = mus__json_text(&label, &text);
    if (status != MUS_OK) return status;
    status = mus_pattern_set_edge_label(reader->pattern, edge, text);
    for (size_t i = 0; i < sizeof gc_holds / sizeof *gc_holds && status == MUS_OK; i++)
        if (strcmp(text, gc_holds[i].label) == 0)
            status = mus_pattern_set_edge_hold(reader->pattern, edge, gc_holds[i].level, gc_holds[i].below);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(&label, status);
}


/* read the loop of a panel: vertices, edges, outline */
static mus_status gc_loop(struct gc_reader *reader, const mus__json_at *at, int32_t panel)
{
    size_t nvertex, nedge;
    mus__json_at vertices = mus__json_member(at, "vertices"), edges = mus__json_member(at, "edges");
    mus_status status = mus__json_array(&vertices, 1, GC_COUNT_MAX, &nvertex);
    if (status == MUS_OK) status = mus__json_array(&edges, 1, GC_COUNT_MAX, &nedge);
    int32_t first = mus_pattern_point_count(reader->pattern);
    for (size_t i = 0; i < nvertex && status == MUS_OK; i++) {
        double xy[2];
        mus__json_at vertex = mus__json_element(&vertices, i);
        status = mus__json_numbers(&vertex, 2, xy);
        if (status != MUS_OK) break;
        status = mus_pattern_add_point(reader->pattern, panel, xy[0] * reader->metre, xy[1] * reader->metre, NULL);
        if (status != MUS_OK) status = mus__json_wrap(&vertex, status);
    }
    if (status != MUS_OK) return status;

    mus_context *context = at->source->context;
    int32_t *words = mus_context_alloc(context, NULL, 2 * nedge * sizeof *words);
    if (words == NULL) return mus__json_fail(&edges, MUS_ERR_MEMORY, "no memory for %zu edges", nedge);
    reader->panels[panel].first_edge = mus_pattern_edge_count(reader->pattern);
    reader->panels[panel].edge_count = (int32_t)nedge;
    for (size_t i = 0; i < nedge && status == MUS_OK; i++) {
        mus__json_at edge = mus__json_element(&edges, i);
        status = gc_edge(reader, &edge, first, (int32_t)nvertex, &words[i]);
        words[nedge + i] = 1;
    }
    if (status == MUS_OK) {
        status = mus_pattern_set_outline(reader->pattern, panel, (int32_t)nedge, words, words + nedge);
        if (status != MUS_OK) status = mus__json_wrap(&edges, status);
    }
    mus_context_alloc(context, words, 0);
    return status;
}


/* words in the names of panels: the label and the side that each tells. Of several labels the first in this list holds:
 * a cuff is on a leg where the name has "pant" */
static const struct {
    const char *word, *label;
    int32_t side;
} gc_words[] = {{"collar", "collar", 0},
                {"hood", "hood", 0},
                {"neck", "neck", 0},
                {"sleeve", "arm", 0},
                {"sl", "arm", 0},
                {"pant", "leg", 0},
                {"cuff", "arm", 0},
                {"ftorso", "body", MUS_SIDE_FRONT},
                {"btorso", "body", MUS_SIDE_BACK},
                {"front", NULL, MUS_SIDE_FRONT},
                {"f", NULL, MUS_SIDE_FRONT},
                {"back", NULL, MUS_SIDE_BACK},
                {"b", NULL, MUS_SIDE_BACK},
                {"left", NULL, MUS_SIDE_LEFT},
                {"l", NULL, MUS_SIDE_LEFT},
                {"right", NULL, MUS_SIDE_RIGHT},
                {"r", NULL, MUS_SIDE_RIGHT}};


static bool gc_has_word(const char *name, const char *word)
{
    const size_t n = strlen(word);
    for (const char *at = name; at != NULL; at = strchr(at, '_')) {
        if (*at == '_') at++;
        if (strncmp(at, word, n) == 0 && (at[n] == '_' || at[n] == '\0')) return true;
    }
    return false;
}


/* set label and sides of a panel. The label of the file holds, unless it is the general "body" */
static mus_status gc_label(const struct gc_reader *reader, const mus__json_at *at, int32_t panel)
{
    const char *text = "", *told = NULL;
    int32_t sides = 0;
    mus__json_at label = mus__json_member(at, "label");
    mus_status status = label.json != NULL ? mus__json_text(&label, &text) : MUS_OK;
    if (status != MUS_OK) return status;
    for (size_t i = 0; i < sizeof gc_words / sizeof *gc_words; i++) {
        if (!gc_has_word(at->key, gc_words[i].word)) continue;
        sides |= gc_words[i].side;
        if (told == NULL) told = gc_words[i].label;
    }
    if (told != NULL && (text[0] == '\0' || strcmp(text, "body") == 0)) text = told;
    status = mus_pattern_set_panel_label(reader->pattern, panel, text);
    if (status != MUS_OK) return mus__json_wrap(&label, status);
    status = mus_pattern_set_panel_sides(reader->pattern, panel, sides);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(at, status);
}


static mus_status gc_panel(struct gc_reader *reader, const mus__json_at *at)
{
    mus_status status = mus__json_expect(at, JSON_OBJECT);
    if (status != MUS_OK) return status;
    int32_t panel;
    status = mus_pattern_add_panel(reader->pattern, at->key, &panel);
    if (status != MUS_OK) return mus__json_wrap(at, status);
    status = gc_label(reader, at, panel);
    if (status == MUS_OK) status = gc_placement(reader, at, panel);
    return status == MUS_OK ? gc_loop(reader, at, panel) : status;
}


/* read one side of a stitch, panel and edge, as an edge of the pattern */
static mus_status gc_side(const struct gc_reader *reader, const mus__json_at *at, int32_t *edge)
{
    mus_status status = mus__json_expect(at, JSON_OBJECT);
    if (status != MUS_OK) return status;
    const char *name;
    int32_t index;
    mus__json_at where = mus__json_member(at, "panel"), which = mus__json_member(at, "edge");
    status = mus__json_text(&where, &name);
    if (status != MUS_OK) return status;
    int32_t panel = mus_pattern_find_panel(reader->pattern, name);
    if (panel < 0) return mus__json_fail(&where, MUS_ERR_FORMAT, "expected the name of a panel, got \"%.80s\"", name);
    status = mus__json_integer(&which, 0, reader->panels[panel].edge_count - 1, &index);
    if (status == MUS_OK) *edge = reader->panels[panel].first_edge + index;
    return status;
}


static mus_status gc_stitch(const struct gc_reader *reader, const mus__json_at *at)
{
    size_t count;
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    mus_status status = mus__json_array(at, 2, 3, &count);
    if (status != MUS_OK) return status;
    mus__json_at a = mus__json_element(at, 0), b = mus__json_element(at, 1);
    status = gc_side(reader, &a, &seam.edge_a);
    if (status == MUS_OK) status = gc_side(reader, &b, &seam.edge_b);
    if (status != MUS_OK) return status;

    /* a stitch may have one word: right side to wrong side, start to start */
    if (count == 3) {
        const char *word;
        mus__json_at third = mus__json_element(at, 2);
        status = mus__json_text(&third, &word);
        if (status != MUS_OK) return status;
        if (strcmp(word, "right_wrong") != 0)
            return mus__json_fail(&third, MUS_ERR_FORMAT, "expected \"right_wrong\", got \"%.40s\"", word);
        seam.direction = MUS_SEAM_DIRECT;
    }
    seam.ease =
        mus_pattern_edge_length(reader->pattern, seam.edge_b) - mus_pattern_edge_length(reader->pattern, seam.edge_a);
    status = mus_pattern_add_seam(reader->pattern, &seam, NULL);

    /* an edge that is sewn hangs from what it is sewn to: held at a level, the top above it would fall over it */
    if (status == MUS_OK) status = mus_pattern_set_edge_hold(reader->pattern, seam.edge_a, MUS_HOLD_NONE, 0.0);
    if (status == MUS_OK) status = mus_pattern_set_edge_hold(reader->pattern, seam.edge_b, MUS_HOLD_NONE, 0.0);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(at, status);
}


/* read the unit, and refuse the variants that this reader does not support */
static mus_status gc_properties(struct gc_reader *reader, const mus__json_at *root)
{
    mus__json_at properties = mus__json_member(root, "properties");
    mus_status status = mus__json_expect(&properties, JSON_OBJECT);
    if (status != MUS_OK) return status;
    double units;
    mus__json_at per_metre = mus__json_member(&properties, "units_in_meter");
    status = mus__json_number(&per_metre, &units);
    if (status != MUS_OK) return status;
    if (!(units >= 1e-3 && units <= 1e6))
        return mus__json_fail(&per_metre, MUS_ERR_FORMAT, "expected 0.001 to 1e6 units in a metre, got %g", units);
    reader->metre = 1.0 / units;

    mus__json_at coords = mus__json_member(&properties, "curvature_coords");
    const char *text = "relative";
    if (coords.json != NULL) status = mus__json_text(&coords, &text);
    if (status == MUS_OK && strcmp(text, "relative") != 0)
        status = mus__json_fail(&coords, MUS_ERR_UNSUPPORTED, "expected \"relative\", got \"%.40s\"", text);
    mus__json_at normal = mus__json_member(&properties, "normalize_panel_translation");
    if (status == MUS_OK && json_is_true(normal.json))
        status = mus__json_fail(&normal, MUS_ERR_UNSUPPORTED, "expected false, got true");
    return status;
}


mus_status mus__pattern_read_garmentcode(const mus__json_at *root, mus_pattern *pattern)
{
    struct gc_reader reader = {.pattern = pattern};
    mus__json_at body = mus__json_member(root, "pattern");
    mus_status status = mus__json_expect(&body, JSON_OBJECT);
    if (status == MUS_OK) status = gc_properties(&reader, root);
    if (status != MUS_OK) return status;

    mus__json_at panels = mus__json_member(&body, "panels"), stitches = mus__json_member(&body, "stitches");
    status = mus__json_expect(&panels, JSON_OBJECT);
    size_t count = json_object_size(panels.json), nstitch = 0;
    if (status == MUS_OK) status = mus__json_array(&stitches, 0, GC_COUNT_MAX, &nstitch);
    if (status == MUS_OK && count == 0) status = mus__json_fail(&panels, MUS_ERR_FORMAT, "expected a panel, got none");
    if (status == MUS_OK && count > MUS__FILE_PANELS_MAX)
        status = mus__json_fail(&panels, MUS_ERR_LIMIT, "%zu panels, the limit is %d", count, MUS__FILE_PANELS_MAX);
    if (status != MUS_OK) return status;
    reader.panels = mus_context_alloc(root->source->context, NULL, count * sizeof *reader.panels);
    if (reader.panels == NULL) return mus__json_fail(&panels, MUS_ERR_MEMORY, "no memory for %zu panels", count);

    /* panels in the order of the file */
    for (void *i = json_object_iter((json_t *)(uintptr_t)panels.json); i != NULL && status == MUS_OK;
         i = json_object_iter_next((json_t *)(uintptr_t)panels.json, i)) {
        mus__json_at panel = mus__json_member(&panels, json_object_iter_key(i));
        status = gc_panel(&reader, &panel);
    }
    for (size_t i = 0; i < nstitch && status == MUS_OK; i++) {
        mus__json_at stitch = mus__json_element(&stitches, i);
        status = gc_stitch(&reader, &stitch);
    }
    mus_context_alloc(root->source->context, reader.panels, 0);
    return status;
}
