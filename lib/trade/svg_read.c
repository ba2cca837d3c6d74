/*
 * svg_read.c: an SVG of drawn panels as a pattern; the convention is written down in muslin_pattern(5).
 *
 * A group of class "panel" is a panel: its paths are told apart by their class (edge, outline, grain, mark, notch; one
 * without a class is the outline where it is closed, else a mark). A closed path outside of such groups is a panel by
 * itself. A path of class "seam" sews two edges: those that data-a and data-b name, else those nearest to its ends.
 * Lengths are millimetres by the root's width and viewBox; transforms are followed. svg_path.c reads the path data,
 * svg_panel.c makes the panels.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <expat.h>

#include "trade/dxf_file.h"
#include "trade/svg_panel.h"
#include "trade/svg_read.h"

#define GROUPS_DEEPEST 64     /* groups in one another; chosen: bounds the stack of transforms */
#define SVG_PANELS 10000      /* most panels; as of other files */
#define SVG_ITEMS 5000        /* most paths of a panel, and seams; chosen: bounds the time to seconds */
#define CSS_PIXEL (25.4 / 96) /* [mm] a unit without a size of the page */
#define SEAM_NEAR 0.01        /* [m] the end of a drawn seam is this near to its edge; chosen: a line drawn by eye */

typedef struct svg_seam {
    int64_t line;
    double ends[4]; /* [m] on the sheet, y up */
    char a[MUS__SVG_NAME], b[MUS__SVG_NAME];
    mus_seam_def def;
} svg_seam;

/* a panel that was made: where it lies, what it is cut with */
typedef struct svg_made {
    int32_t panel;
    int64_t line;
    double origin[2], cut[MUS_MATERIAL_COUNT];
    char mirror_of[MUS__SVG_NAME];
} svg_made;

typedef struct svg_name {
    char id[MUS__SVG_NAME];
    int32_t edge;
} svg_name;

typedef struct svg_reader {
    const mus__source *source;
    mus_pattern *pattern;
    XML_Parser parser;
    mus_status status;
    int32_t depth, panel_depth; /* of the element; of the group of the panel, 0 outside */
    double m[GROUPS_DEEPEST + 1][6];
    mus__svg_panel panel;
    char *word; /* of the panel */
    int32_t nseam, seam_room, nmade, made_room, nname, name_room;
    svg_seam *seams;
    svg_made *made;
    svg_name *names;
} svg_reader;


bool mus__svg_begins(const char *text)
{
    const char *at = text;
    for (;;) {
        at += strspn(at, " \t\r\n");
        if (strncmp(at, "<svg", 4) == 0 || strncmp(at, "<!DOCTYPE svg", 13) == 0) return true;
        const bool comment = strncmp(at, "<!--", 4) == 0;
        if (!comment && strncmp(at, "<?", 2) != 0) return false;
        at = strstr(at, comment ? "-->" : ">");
        if (at == NULL) return false;
        at += comment ? 3 : 1;
    }
}


/* ---- attributes ---- */

static int64_t line_of(const svg_reader *r)
{
    return (int64_t)XML_GetCurrentLineNumber(r->parser);
}


static void reader_fail(svg_reader *r, mus_status status)
{
    if (r->status == MUS_OK) r->status = status;
    XML_StopParser(r->parser, XML_FALSE);
}


/* value of an attribute, NULL without it */
static const char *attribute(const XML_Char **attributes, const char *name)
{
    for (int32_t i = 0; attributes[i] != NULL; i += 2)
        if (strcmp(attributes[i], name) == 0) return attributes[i + 1];
    return NULL;
}


static bool has_class(const XML_Char **attributes, const char *name)
{
    const char *list = attribute(attributes, "class");
    const size_t n = strlen(name);
    for (const char *at = list != NULL ? list : ""; *at != '\0';) {
        at += strspn(at, " \t\r\n");
        const size_t length = strcspn(at, " \t\r\n");
        if (length == n && memcmp(at, name, n) == 0) return true;
        at += length;
    }
    return false;
}


/* copies an attribute, cut to the pattern's limit at a whole character; "" without it */
static void copy_text(const XML_Char **attributes, const char *name, char *out)
{
    const char *value = attribute(attributes, name);
    snprintf(out, MUS__SVG_NAME, "%s", value != NULL ? value : "");
    size_t n = strlen(out);
    if (value != NULL && strlen(value) > n)
        while (n > 0 && ((unsigned char)value[n] & 0xC0) == 0x80) n--;
    out[n] = '\0';
}


static void copy_name(const XML_Char **attributes, char *out)
{
    static const char *const names[] = {"data-name", "inkscape:label", "id"};
    out[0] = '\0';
    for (size_t i = 0; i < sizeof names / sizeof *names && out[0] == '\0'; i++) copy_text(attributes, names[i], out);
}


/* number of an attribute times a unit; `none` without it. A fault fails the reader */
static double number_of(svg_reader *r, const XML_Char **attributes, const char *name, double unit, double none)
{
    const char *value = attribute(attributes, name);
    if (value == NULL) return none;
    const size_t n = mus__number_span(value);
    const double x = n > 0 ? strtod(value, NULL) : 0.0;
    if (n > 0 && value[n] == '\0' && fabs(x) < 1e9) return unit * x;
    reader_fail(r, mus__source_fail(r->source, line_of(r), MUS_ERR_FORMAT, "%s: expected a number, got \"%.30s\"", name,
                                    value));
    return none;
}


/* ---- elements ---- */

/* millimetres of the root's unit: width by the width of the viewBox */
static void read_root(svg_reader *r, const XML_Char **attributes)
{
    static const struct {
        const char *name;
        double mm;
    } units[] = {{"mm", 1.0},      {"cm", 10.0},      {"in", 25.4},   {"pt", 25.4 / 72},
                 {"pc", 25.4 / 6}, {"px", CSS_PIXEL}, {"", CSS_PIXEL}};
    const char *width = attribute(attributes, "width"), *box = attribute(attributes, "viewBox");
    double scale = CSS_PIXEL, view[4] = {0.0, 0.0, 0.0, 0.0};
    if (width != NULL && box != NULL && strchr(width, '%') == NULL) {
        const size_t n = mus__number_span(width);
        const char *at = box;
        size_t u = 0;
        while (u < sizeof units / sizeof *units && strcmp(width + n, units[u].name) != 0) u++;
        for (int32_t i = 0; i < 4; i++) {
            at += strspn(at, " ,\t\r\n");
            view[i] = mus__number_span(at) > 0 ? strtod(at, NULL) : NAN;
            at += mus__number_span(at);
        }
        scale = n > 0 && u < sizeof units / sizeof *units ? strtod(width, NULL) * units[u].mm / view[2] : NAN;
        if (!(scale > 1e-9 && scale < 1e9)) {
            reader_fail(r, mus__source_fail(r->source, line_of(r), MUS_ERR_FORMAT,
                                            "svg: expected a width in mm, cm, in, pt, pc or px and a viewBox of four "
                                            "numbers"));
            return;
        }
    }
    const double root[6] = {1e-3 * scale, 0.0, 0.0, -1e-3 * scale, 0.0, 0.0};
    memcpy(r->m[r->depth], root, sizeof root);
    const char *name = attribute(attributes, "data-name");
    if (name == NULL) return;
    const mus_status status = mus_pattern_set_name(r->pattern, name);
    if (status != MUS_OK) reader_fail(r, mus__source_wrap(r->source, line_of(r), status));
}


static void begin_panel(svg_reader *r, const XML_Char **attributes)
{
    mus__svg_panel *panel = &r->panel;
    const char *word = attribute(attributes, "data-outline");
    r->panel_depth = r->depth;
    panel->line = line_of(r);
    copy_name(attributes, panel->name);
    if (panel->name[0] == '\0') snprintf(panel->name, sizeof panel->name, "panel %d", (int)r->nmade + 1);
    copy_text(attributes, "data-label", panel->label);
    copy_text(attributes, "data-mirror-of", panel->mirror_of);
    panel->cut[MUS_MATERIAL_MAIN] = number_of(r, attributes, "data-cut", 1.0, 1.0);
    for (int32_t i = MUS_MATERIAL_MAIN + 1; i < MUS_MATERIAL_COUNT; i++) {
        char key[32];
        snprintf(key, sizeof key, "data-%s", mus_material_name(i));
        panel->cut[i] = number_of(r, attributes, key, 1.0, 0.0);
    }
    panel->layer = number_of(r, attributes, "data-layer", 1.0, 0.0);
    panel->origin[0] = r->m[r->depth][4];
    panel->origin[1] = r->m[r->depth][5];
    if (word == NULL) return;
    r->word = mus_context_alloc(r->source->context, NULL, strlen(word) + 1);
    if (r->word == NULL) {
        reader_fail(r, mus__source_fail(r->source, panel->line, MUS_ERR_MEMORY, "no memory for a panel"));
        return;
    }
    memcpy(r->word, word, strlen(word) + 1);
    panel->word = r->word;
}


static mus_status keep_panel(svg_reader *r)
{
    int32_t index;
    if (r->nmade >= SVG_PANELS)
        return mus__source_fail(r->source, r->panel.line, MUS_ERR_LIMIT, "more than %d panels", SVG_PANELS);
    mus_status status = mus__svg_panel_add(r->source, &r->panel, r->pattern, &index);
    if (status == MUS_OK)
        status = mus__source_reserve(r->source, &r->made, &r->made_room, (int64_t)r->nmade + 1, sizeof *r->made);
    if (status != MUS_OK) return status;
    svg_made *made = &r->made[r->nmade++];
    made->panel = index;
    made->line = r->panel.line;
    memcpy(made->cut, r->panel.cut, sizeof made->cut);
    memcpy(made->origin, r->panel.origin, sizeof made->origin);
    memcpy(made->mirror_of, r->panel.mirror_of, sizeof made->mirror_of);
    for (int32_t i = 0; i < r->panel.n && status == MUS_OK; i++) {
        const mus__svg_item *item = &r->panel.items[i];
        if (item->made == MUS_NONE || item->id[0] == '\0') continue;
        status = mus__source_reserve(r->source, &r->names, &r->name_room, (int64_t)r->nname + 1, sizeof *r->names);
        if (status != MUS_OK) return status;
        memcpy(r->names[r->nname].id, item->id, sizeof item->id);
        r->names[r->nname++].edge = item->made;
    }
    return status;
}


static void end_panel(svg_reader *r)
{
    const mus_status status = r->status == MUS_OK ? keep_panel(r) : MUS_OK;
    mus__svg_panel_clear(r->source->context, &r->panel);
    mus_context_alloc(r->source->context, r->word, 0);
    r->word = NULL;
    r->panel_depth = 0;
    if (status != MUS_OK) reader_fail(r, status);
}


/* kind of a path by its class; MUS_NONE for one of another class */
static int32_t kind_of(const XML_Char **attributes, bool closed)
{
    static const char *const classes[] = {"edge", "outline", "grain", "mark", "notch"};
    for (int32_t i = 0; i < 5; i++)
        if (has_class(attributes, classes[i])) return i;
    if (attribute(attributes, "class") != NULL) return MUS_NONE;
    return closed ? MUS__SVG_OUTLINE : MUS__SVG_MARK;
}


/* a path of a panel, which begins and ends here when the path lies outside of groups of panels */
static mus_status read_item(svg_reader *r, const XML_Char **attributes, const char *d, const double *m)
{
    mus__svg_path path = {0};
    const bool alone = r->panel_depth == 0;
    double own[6];
    memcpy(own, m, sizeof own);
    own[4] -= alone ? 0.0 : r->panel.origin[0];
    own[5] -= alone ? 0.0 : r->panel.origin[1];
    mus_status status = mus__svg_path_read(r->source, line_of(r), d, own, &path);
    const int32_t kind = status == MUS_OK ? kind_of(attributes, path.closed && path.npiece > 0) : MUS_NONE;
    if (status != MUS_OK || kind == MUS_NONE || path.nxy == 0 || (alone && kind != MUS__SVG_OUTLINE)) {
        mus__svg_path_free(r->source->context, &path);
        return status;
    }
    if (alone) begin_panel(r, attributes);
    if (alone) r->panel.origin[0] = r->panel.origin[1] = 0.0;
    if (r->panel.n >= SVG_ITEMS)
        status = mus__source_fail(r->source, line_of(r), MUS_ERR_LIMIT, "more than %d paths in a panel", SVG_ITEMS);
    if (status == MUS_OK)
        status = mus__source_reserve(r->source, &r->panel.items, &r->panel.room, (int64_t)r->panel.n + 1,
                                    sizeof *r->panel.items);
    if (status != MUS_OK) {
        mus__svg_path_free(r->source->context, &path);
        return status;
    }
    mus__svg_item *item = &r->panel.items[r->panel.n++];
    item->kind = kind;
    item->line = line_of(r);
    item->path = path;
    item->made = MUS_NONE;
    copy_text(attributes, "id", item->id);
    copy_text(attributes, "data-name", item->name);
    copy_text(attributes, "data-label", item->label);
    copy_text(attributes, "data-edge", item->edge);
    item->s = number_of(r, attributes, "data-s", 1e-3, NAN);
    item->notch = number_of(r, attributes, "data-kind", 1.0, 1.0);
    item->allowance = number_of(r, attributes, "data-allowance", 1e-3, NAN);
    if (alone) end_panel(r);
    return MUS_OK;
}


static mus_status read_seam(svg_reader *r, const XML_Char **attributes, const char *d, const double *m)
{
    mus__svg_path path = {0};
    mus_status status = mus__svg_path_read(r->source, line_of(r), d, m, &path);
    if (status == MUS_OK && r->nseam >= SVG_ITEMS)
        status = mus__source_fail(r->source, line_of(r), MUS_ERR_LIMIT, "more than %d seams", SVG_ITEMS);
    if (status == MUS_OK)
        status = mus__source_reserve(r->source, &r->seams, &r->seam_room, (int64_t)r->nseam + 1, sizeof *r->seams);
    if (status == MUS_OK && path.nxy > 0) {
        svg_seam *seam = &r->seams[r->nseam++];
        const char *direction = attribute(attributes, "data-direction");
        seam->line = line_of(r);
        memcpy(seam->ends, path.xy, 2 * sizeof(double));
        memcpy(seam->ends + 2, path.xy + 2 * path.nxy - 2, 2 * sizeof(double));
        copy_text(attributes, "data-a", seam->a);
        copy_text(attributes, "data-b", seam->b);
        mus_seam_def_init(&seam->def, sizeof seam->def);
        if (direction != NULL && strcmp(direction, "direct") == 0) seam->def.direction = MUS_SEAM_DIRECT;
        seam->def.ease = number_of(r, attributes, "data-ease", 1e-3, NAN);
        seam->def.tolerance = number_of(r, attributes, "data-tolerance", 1e-3, seam->def.tolerance);
        seam->def.laid = number_of(r, attributes, "data-laid", 1.0, 0.0) > 0.0;
        seam->def.closure = (int32_t)number_of(r, attributes, "data-closure", 1.0, 0.0);
        seam->def.open = number_of(r, attributes, "data-open", 1.0, 0.0) > 0.0;
        seam->def.buttons = (int32_t)number_of(r, attributes, "data-buttons", 1.0, 0.0);
    }
    mus__svg_path_free(r->source->context, &path);
    return status;
}


static void XMLCALL svg_start(void *user, const XML_Char *name, const XML_Char **attributes)
{
    svg_reader *r = user;
    const char *own = strncmp(name, "svg:", 4) == 0 ? name + 4 : name;
    const char *transform = attribute(attributes, "transform");
    if (++r->depth > GROUPS_DEEPEST) {
        reader_fail(r,
                    mus__source_fail(r->source, line_of(r), MUS_ERR_LIMIT, "groups more than %d deep", GROUPS_DEEPEST));
        return;
    }
    if (r->depth == 1) {
        read_root(r, attributes);
        return;
    }
    memcpy(r->m[r->depth], r->m[r->depth - 1], sizeof r->m[0]);
    mus_status status = MUS_OK;
    if (transform != NULL) status = mus__svg_transform(r->source, line_of(r), transform, r->m[r->depth]);
    if (status != MUS_OK) {
        reader_fail(r, status);
        return;
    }
    const bool polygon = strcmp(own, "polygon") == 0, path = strcmp(own, "path") == 0;
    if (strcmp(own, "g") == 0 && r->panel_depth == 0 && has_class(attributes, "panel")) begin_panel(r, attributes);
    if (!polygon && !path && strcmp(own, "polyline") != 0) return;
    const char *d = attribute(attributes, path ? "d" : "points");
    char *closed = NULL;
    if (d == NULL) return;
    if (polygon) { /* its points are path data; Z closes it */
        closed = mus_context_alloc(r->source->context, NULL, strlen(d) + 2);
        if (closed != NULL)
            snprintf(closed, strlen(d) + 2, "%sZ", d);
        else
            status = mus__source_fail(r->source, line_of(r), MUS_ERR_MEMORY, "no memory for a polygon");
        d = closed;
    }
    if (status == MUS_OK)
        status = has_class(attributes, "seam") ? read_seam(r, attributes, d, r->m[r->depth])
                                               : read_item(r, attributes, d, r->m[r->depth]);
    mus_context_alloc(r->source->context, closed, 0);
    if (status != MUS_OK) reader_fail(r, status);
}


static void XMLCALL svg_end(void *user, const XML_Char *name)
{
    svg_reader *r = user;
    (void)name;
    if (r->panel_depth == r->depth) end_panel(r);
    r->depth--;
}


/* declared entities could grow without bound */
static void XMLCALL svg_doctype(void *user, const XML_Char *name, const XML_Char *system, const XML_Char *public,
                                int internal)
{
    svg_reader *r = user;
    (void)name, (void)system, (void)public;
    if (internal)
        reader_fail(r, mus__source_fail(r->source, line_of(r), MUS_ERR_UNSUPPORTED,
                                        "a document type with declarations; expected none (save it as plain SVG)"));
}


/* ---- after the last element ---- */

static mus_status nearest_edge(const svg_reader *r, const double *p, int32_t *out)
{
    double best = SEAM_NEAR;
    *out = MUS_NONE;
    for (int32_t e = 0; e < mus_pattern_edge_count(r->pattern); e++) {
        const int32_t panel = mus_pattern_edge_panel(r->pattern, e);
        int32_t i = 0;
        while (i < r->nmade && r->made[i].panel != panel) i++;
        if (i == r->nmade) continue;
        const double own[2] = {p[0] - r->made[i].origin[0], p[1] - r->made[i].origin[1]};
        double s, distance;
        mus_status status = mus__svg_nearest(r->source, r->pattern, e, own, &s, &distance);
        if (status != MUS_OK) return status;
        if (distance >= best) continue;
        best = distance;
        *out = e;
    }
    return MUS_OK;
}


static mus_status seam_edge(const svg_reader *r, const svg_seam *seam, const char *id, const double *p, int32_t *out)
{
    *out = MUS_NONE;
    if (id[0] == '\0') {
        mus_status status = nearest_edge(r, p, out);
        if (status != MUS_OK || *out != MUS_NONE) return status;
        return mus__source_fail(r->source, seam->line, MUS_ERR_FORMAT,
                                "seam: an end is on no edge; expected both ends within 10 mm of an edge, or data-a and "
                                "data-b");
    }
    for (int32_t i = 0; i < r->nname && *out == MUS_NONE; i++)
        if (strcmp(r->names[i].id, id) == 0) *out = r->names[i].edge;
    if (*out != MUS_NONE) return MUS_OK;
    return mus__source_fail(r->source, seam->line, MUS_ERR_FORMAT, "seam: expected the id of an edge, got \"%.40s\"",
                            id);
}


static mus_status add_seams(const svg_reader *r)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < r->nseam && status == MUS_OK; i++) {
        mus_seam_def def = r->seams[i].def;
        status = seam_edge(r, &r->seams[i], r->seams[i].a, r->seams[i].ends, &def.edge_a);
        if (status == MUS_OK) status = seam_edge(r, &r->seams[i], r->seams[i].b, r->seams[i].ends + 2, &def.edge_b);
        if (status != MUS_OK) return status;
        /* a seam that was drawn by hand has the ease of its lengths */
        if (def.ease != def.ease)
            def.ease =
                mus_pattern_edge_length(r->pattern, def.edge_b) - mus_pattern_edge_length(r->pattern, def.edge_a);
        status = mus_pattern_add_seam(r->pattern, &def, NULL);
        if (status != MUS_OK) return mus__source_wrap(r->source, r->seams[i].line, status);
    }
    return status;
}


static mus_status set_cuts(const svg_reader *r)
{
    for (int32_t i = 0; i < r->nmade; i++) {
        const svg_made *made = &r->made[i];
        const bool twin = made->mirror_of[0] != '\0';
        const int32_t of = twin ? mus_pattern_find_panel(r->pattern, made->mirror_of) : MUS_NONE;
        if (twin && of == MUS_NONE)
            return mus__source_fail(r->source, made->line, MUS_ERR_FORMAT,
                                    "data-mirror-of: expected the name of a panel, got \"%.40s\"", made->mirror_of);
        mus_status status = mus_pattern_set_cut(r->pattern, made->panel, (int32_t)made->cut[MUS_MATERIAL_MAIN], of);
        for (int32_t k = MUS_MATERIAL_MAIN + 1; k < MUS_MATERIAL_COUNT && status == MUS_OK; k++)
            status = mus_pattern_set_material(r->pattern, made->panel, k, (int32_t)made->cut[k]);
        if (status != MUS_OK) return mus__source_wrap(r->source, made->line, status);
    }
    return MUS_OK;
}


static mus_status svg_parse(svg_reader *r)
{
    XML_SetUserData(r->parser, r);
    XML_SetElementHandler(r->parser, svg_start, svg_end);
    XML_SetStartDoctypeDeclHandler(r->parser, svg_doctype);
    /* the largest file is far below INT_MAX */
    const enum XML_Status parsed = XML_Parse(r->parser, r->source->text, (int)r->source->size, 1);
    if (r->status != MUS_OK) return r->status;
    if (parsed != XML_STATUS_OK) {
        const enum XML_Error error = XML_GetErrorCode(r->parser);
        return mus__source_fail(r->source, line_of(r), error == XML_ERROR_NO_MEMORY ? MUS_ERR_MEMORY : MUS_ERR_FORMAT,
                                "expected XML: %s", XML_ErrorString(error));
    }
    if (r->nmade > 0) return MUS_OK;
    return mus__source_fail(r->source, 0, MUS_ERR_FORMAT,
                            "no panel; expected groups of class panel, or closed paths (see muslin_pattern(5))");
}


mus_status mus__svg_read(const mus__source *source, mus_pattern *pattern)
{
    svg_reader r = {.source = source, .pattern = pattern, .parser = XML_ParserCreate(NULL)};
    if (r.parser == NULL) return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for the XML reader");
    mus_status status = svg_parse(&r);
    if (status == MUS_OK) status = set_cuts(&r);
    if (status == MUS_OK) status = add_seams(&r);
    XML_ParserFree(r.parser);
    mus__svg_panel_clear(source->context, &r.panel);
    mus_context_alloc(source->context, r.word, 0);
    mus_context_alloc(source->context, r.seams, 0);
    mus_context_alloc(source->context, r.made, 0);
    mus_context_alloc(source->context, r.names, 0);
    return status;
}
