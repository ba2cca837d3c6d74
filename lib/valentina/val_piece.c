/*
 * val_piece.c: the pieces of a drawing as panels: outline, allowance, grain, notches, lines inside, number of copies.
 *
 * The nodes of a piece are points and curves, in order. A curve between two points that lie on it is cut there; what
 * does not touch is joined by a straight line. A piece that is left out of the layout, or was united with another, is
 * not read. Not read either: allowances that change along an edge (its first one is taken), own forms of corners,
 * labels, folds ("onFold"), and lines of an own seam allowance.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "valentina/val_draw.h"

#define PIECE_TOUCH 0.05 /* [mm] a point this near lies on a curve. Chosen: the chords of Valentina stray as far */
#define PIECE_NODES 5000 /* most nodes of a piece; chosen: those of real patterns have 80 */
#define PIECE_CHORDS 16  /* of a cubic in a line inside a piece */

/* an edge of the outline, counted as the piece draws it */
typedef struct piece_edge {
    mus__val_curve curve;
    double allowance; /* [mm] */
    int32_t notch;    /* slits at its start, 0: none */
} piece_edge;

typedef struct piece {
    mus__val_job *job;
    int32_t element;
    int32_t panel;
    bool sewn;      /* it has an allowance */
    double width;   /* [mm] of it */
    int32_t n, room;
    piece_edge *edges; /* (n) */
    double first[2], last[2];
    bool begun;
    double after;   /* allowance [mm] of the edge to come, NaN: that of the piece */
    int32_t notch;  /* slits at the start of the edge to come */
} piece;


static bool piece_flag(const mus__val_xml *xml, int32_t e, const char *name, bool other)
{
    const char *text = mus__val_attribute(xml, e, name);
    return text == NULL ? other : strcmp(text, "1") == 0 || strcmp(text, "true") == 0;
}


/* the object that an id of a node stands for; NULL without one */
static const mus__val_object *piece_object(const mus__val_job *job, const char *text)
{
    long id = text != NULL ? strtol(text, NULL, 10) : -1;
    for (int32_t hop = 0; hop < 8 && id >= 0 && id < job->nobject; hop++) {
        if (job->objects[id].kind != MUS__VAL_NOTHING) return &job->objects[id];
        id = job->links[id];
    }
    return NULL;
}


static double piece_gap(const double *a, const double *b)
{
    return mus__hypot(b[0] - a[0], b[1] - a[1]);
}


/* true for a cubic that is a straight line with its controls at the thirds */
static bool piece_straight(const mus__val_curve *c)
{
    if (c->n != 1) return false;
    for (int32_t i = 1; i < 3; i++)
        for (int32_t k = 0; k < 2; k++) {
            const double wanted = c->cubic[k] + i / 3.0 * (c->cubic[6 + k] - c->cubic[k]);
            if (fabs(c->cubic[2 * i + k] - wanted) > PIECE_TOUCH) return false;
        }
    return true;
}


/* add an edge that takes over the curve */
static mus_status piece_add(piece *p, mus__val_curve *curve)
{
    mus_status status =
        mus__source_reserve(p->job->source, &p->edges, &p->room, (int64_t)p->n + 1, sizeof *p->edges);
    if (status != MUS_OK) return status;
    p->edges[p->n++] = (piece_edge){*curve, isnan(p->after) ? p->width : p->after, p->notch};
    *curve = (mus__val_curve){0};
    p->after = NAN;
    p->notch = 0;
    return MUS_OK;
}


static mus_status piece_line(piece *p, const double *to)
{
    double c[8];
    for (int32_t i = 0; i < 4; i++)
        for (int32_t k = 0; k < 2; k++) c[2 * i + k] = p->last[k] + i / 3.0 * (to[k] - p->last[k]);
    mus__val_curve line = {0};
    mus_status status = mus__val_curve_add(p->job->source, &line, c);
    if (status == MUS_OK) status = piece_add(p, &line);
    mus_context_alloc(p->job->source->context, line.cubic, 0);
    return status;
}


/* take back the last edge when the outline returns on it: a slit without width, which Valentina leaves out too */
static bool piece_slit(piece *p, const double *to)
{
    piece_edge *edge = p->n > 1 ? &p->edges[p->n - 1] : NULL;
    if (edge == NULL || !piece_straight(&edge->curve) || piece_gap(edge->curve.cubic, to) > PIECE_TOUCH) return false;
    mus_context_alloc(p->job->source->context, edge->curve.cubic, 0);
    p->n--;
    return true;
}


static mus_status piece_go(piece *p, const double *to)
{
    mus_status status = MUS_OK;
    if (!p->begun) memcpy(p->first, to, sizeof p->first);
    else if (piece_gap(p->last, to) <= PIECE_TOUCH) return MUS_OK;
    else if (!piece_slit(p, to)) status = piece_line(p, to);
    p->begun = true;
    memcpy(p->last, to, sizeof p->last);
    return status;
}


/* the place of the point before (step -1) or after (1) the node `at`; false when a curve stands there */
static bool piece_beside(const piece *p, const int32_t *nodes, int32_t n, int32_t at, int32_t step, double *out)
{
    const int32_t node = nodes[(at + step + n) % n];
    const mus__val_object *o = piece_object(p->job, mus__val_attribute(&p->job->xml, node, "idObject"));
    if (o == NULL || o->kind != MUS__VAL_POINT) return false;
    memcpy(out, o->xy, sizeof o->xy);
    return true;
}


static mus_status piece_curve(piece *p, const int32_t *nodes, int32_t n, int32_t at, const mus__val_object *object)
{
    const mus__source *source = p->job->source;
    const bool reverse = piece_flag(&p->job->xml, nodes[at], "reverse", false);
    mus__val_curve curve = {0}, part = {0};
    mus_status status = mus__val_curve_part(source, &object->curve, 0.0, object->curve.n, &curve);
    double beside[2], away, from = 0.0, to = curve.n;
    if (status == MUS_OK && reverse) mus__val_curve_reverse(&curve);
    if (status == MUS_OK && piece_beside(p, nodes, n, at, -1, beside)) {
        const double t = mus__val_curve_nearest(&curve, beside, &away);
        if (away < PIECE_TOUCH) from = t;
    }
    if (status == MUS_OK && piece_beside(p, nodes, n, at, 1, beside)) {
        const double t = mus__val_curve_nearest(&curve, beside, &away);
        if (away < PIECE_TOUCH && t > from + 1e-6) to = t;
    }
    if (to <= from + 1e-6) from = 0.0, to = curve.n; /* the points stand the other way round */
    if (status == MUS_OK) status = mus__val_curve_part(source, &curve, from, to, &part);
    if (status == MUS_OK && part.n > 0) {
        status = piece_go(p, part.cubic);
        memcpy(part.cubic, p->last, sizeof p->last);
        const double end[2] = {part.cubic[8 * (ptrdiff_t)part.n - 2], part.cubic[8 * (ptrdiff_t)part.n - 1]};
        if (status == MUS_OK) status = piece_add(p, &part);
        memcpy(p->last, end, sizeof p->last);
    }
    mus_context_alloc(source->context, curve.cubic, 0);
    mus_context_alloc(source->context, part.cubic, 0);
    return status;
}


/* an allowance that a node has of its own [mm]; NaN without one */
static double piece_own(piece *p, int32_t node, const char *name, mus_status *status)
{
    const char *text = mus__val_attribute(&p->job->xml, node, name);
    if (text == NULL || text[0] == '\0' || text[0] == '-') return NAN;
    return mus__val_length(p->job, node, name, status);
}


static mus_status piece_node(piece *p, const int32_t *nodes, int32_t n, int32_t at)
{
    const mus__val_xml *xml = &p->job->xml;
    const mus__val_object *o = piece_object(p->job, mus__val_attribute(xml, nodes[at], "idObject"));
    mus_status status = MUS_OK;
    if (o == NULL)
        return mus__source_fail(p->job->source, xml->elements[nodes[at]].line, MUS_ERR_FORMAT,
                                "a node of a piece has no object");
    double end[2] = {o->xy[0], o->xy[1]};
    if (o->kind == MUS__VAL_CURVE) mus__val_curve_at(&o->curve, o->curve.n, end);
    if (!(fabs(end[0]) < 1e7 && fabs(end[1]) < 1e7))
        return mus__source_fail(p->job->source, xml->elements[nodes[at]].line, MUS_ERR_PATTERN,
                                "a node of a piece has no place; %.300s", p->job->missing);
    if (o->kind == MUS__VAL_CURVE) return piece_curve(p, nodes, n, at, o);
    const int32_t before = p->n;
    const double own = piece_own(p, nodes[at], "before", &status);
    if (status == MUS_OK) status = piece_go(p, o->xy);
    if (p->n > before && !isnan(own) && p->edges[p->n - 1].allowance == p->width) p->edges[p->n - 1].allowance = own;
    p->after = piece_own(p, nodes[at], "after", &status);
    const char *line = mus__val_attribute(xml, nodes[at], "passmarkLine");
    p->notch = !piece_flag(xml, nodes[at], "passmark", false) ? 0
               : line != NULL && strcmp(line, "two") == 0     ? 2
               : line != NULL && strcmp(line, "three") == 0   ? 3
                                                              : 1;
    return status;
}


/* the nodes of a piece or path, without those that are left out: their elements. Returns their number */
static int32_t piece_nodes(const mus__val_xml *xml, int32_t element, int32_t *nodes)
{
    int32_t list = mus__val_child(xml, element, "nodes", MUS_NONE), n = 0;
    if (list == MUS_NONE) list = element;
    for (int32_t e = mus__val_child(xml, list, "node", MUS_NONE); e != MUS_NONE && n < PIECE_NODES;
         e = mus__val_child(xml, list, "node", e))
        if (!piece_flag(xml, e, "excluded", false)) nodes[n++] = e;
    return n;
}


/* all edges of the outline, closed */
static mus_status piece_outline(piece *p)
{
    int32_t nodes[PIECE_NODES];
    const int32_t n = piece_nodes(&p->job->xml, p->element, nodes);
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < n && status == MUS_OK; i++) status = piece_node(p, nodes, n, i);
    if (status != MUS_OK || !p->begun) return status;
    if (piece_gap(p->last, p->first) > PIECE_TOUCH) status = piece_line(p, p->first);
    if (status == MUS_OK && p->n > 0) { /* the ends of the last edge and the first are one point */
        mus__val_curve *last = &p->edges[p->n - 1].curve;
        memcpy(last->cubic + 8 * (ptrdiff_t)last->n - 2, p->first, sizeof p->first);
    }
    return status;
}


/* twice the area inside the outline [mm2], > 0 counter-clockwise */
static double piece_area(const piece *p)
{
    double area = 0.0;
    for (int32_t i = 0; i < p->n; i++) {
        const mus__val_curve *c = &p->edges[i].curve;
        double a[2], b[2];
        mus__val_curve_at(c, 0.0, a);
        for (int32_t k = 1; k <= PIECE_CHORDS * c->n; k++, memcpy(a, b, sizeof a)) {
            mus__val_curve_at(c, (double)k / PIECE_CHORDS, b);
            area += a[0] * b[1] - a[1] * b[0];
        }
    }
    return area;
}


/* add edge i, from point to point of the pattern */
static mus_status piece_edge_add(piece *p, int32_t i, const int32_t *points, int32_t *edge)
{
    const mus__val_curve *c = &p->edges[i].curve;
    mus_context *context = p->job->source->context;
    mus_edge_def def;
    mus_edge_def_init(&def, sizeof def);
    def.start = points[i], def.end = points[(i + 1) % p->n];
    if (piece_straight(c)) return mus_pattern_add_edge(p->job->pattern, &def, edge);
    double *xy = mus_context_alloc(context, NULL, 8 * (size_t)c->n * sizeof *xy);
    int32_t *kinds = mus_context_alloc(context, NULL, (size_t)c->n * sizeof *kinds);
    mus_status status = xy == NULL || kinds == NULL ? MUS_ERR_MEMORY : MUS_OK;
    if (status == MUS_OK) {
        def.npiece = c->n, def.nxy = 3 * c->n - 1, def.kinds = kinds, def.xy = xy;
        for (int32_t k = 0; k < c->n; k++) kinds[k] = MUS_PIECE_CUBIC;
        for (ptrdiff_t k = 0; k < c->n; k++) memcpy(xy + 6 * k, c->cubic + 8 * k + 2, 6 * sizeof *xy);
        for (int32_t k = 0; k < 6 * c->n; k++) xy[k] *= 0.001;
        status = mus_pattern_add_edge(p->job->pattern, &def, edge);
    }
    mus_context_alloc(context, xy, 0);
    mus_context_alloc(context, kinds, 0);
    return status;
}


/* points, edges, allowances, notches and the attaching map; `work` (4 x n) is scratch */
static mus_status piece_build(piece *p, int32_t *work)
{
    mus_pattern *pattern = p->job->pattern;
    const bool turned = piece_area(p) < 0.0;
    int32_t *points = work, *edges = work + p->n, *order = work + 2 * p->n, *signs = work + 3 * p->n;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < p->n && status == MUS_OK; i++) {
        const double *at = p->edges[i].curve.cubic;
        status = mus_pattern_add_point(pattern, p->panel, 0.001 * at[0], 0.001 * at[1], &points[i]);
    }
    for (int32_t i = 0; i < p->n && status == MUS_OK; i++) {
        status = piece_edge_add(p, i, points, &edges[i]);
        if (status == MUS_OK)
            status = mus_pattern_set_edge_allowance(pattern, edges[i], p->sewn ? 0.001 * p->edges[i].allowance : 0.0);
    }
    for (int32_t i = 0; i < p->n && status == MUS_OK; i++) {
        order[i] = edges[turned ? p->n - 1 - i : i];
        signs[i] = turned ? -1 : 1;
    }
    if (status == MUS_OK) status = mus_pattern_set_outline(pattern, p->panel, p->n, order, signs);
    for (int32_t i = 0; i < p->n && status == MUS_OK; i++)
        if (p->edges[i].notch > 0) status = mus_pattern_add_notch(pattern, edges[i], 0.0, p->edges[i].notch, NULL);
    return status;
}


/* a line inside the piece as a mark */
static mus_status piece_path(piece *p, int32_t path)
{
    const mus__val_xml *xml = &p->job->xml;
    const mus__source *source = p->job->source;
    int32_t nodes[PIECE_NODES], count = 0, room = 0;
    const int32_t n = piece_nodes(xml, path, nodes);
    double *xy = NULL;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        const mus__val_object *o = piece_object(p->job, mus__val_attribute(xml, nodes[i], "idObject"));
        if (o == NULL) continue;
        const bool reverse = piece_flag(xml, nodes[i], "reverse", false);
        const int32_t more = o->kind == MUS__VAL_POINT ? 1 : PIECE_CHORDS * o->curve.n + 1;
        status = mus__source_reserve(source, &xy, &room, 2 * ((int64_t)count + more), sizeof *xy);
        for (int32_t k = 0; k < more && status == MUS_OK; k++) {
            double at[2] = {o->xy[0], o->xy[1]};
            const double t = (double)(reverse ? more - 1 - k : k) / PIECE_CHORDS;
            if (o->kind == MUS__VAL_CURVE) mus__val_curve_at(&o->curve, t, at);
            xy[2 * (ptrdiff_t)count] = 0.001 * at[0], xy[2 * (ptrdiff_t)count + 1] = 0.001 * at[1];
            const double *was = xy + 2 * (ptrdiff_t)count - 2;
            if (count == 0 || 1000.0 * piece_gap(was, was + 2) > PIECE_TOUCH) count++;
        }
    }
    const char *name = mus__val_attribute(xml, path, "name");
    char hold[100];
    snprintf(hold, sizeof hold, "%.99s", name != NULL ? name : "");
    mus__text_make_printable(hold);
    if (status == MUS_OK && count > 1)
        status = mus__source_wrap(source, xml->elements[path].line,
                                  mus_pattern_add_mark(p->job->pattern, p->panel, hold, count, xy, NULL));
    mus_context_alloc(source->context, xy, 0);
    return status;
}


/* grain, number of copies, lines inside */
static mus_status piece_details(piece *p)
{
    const mus__val_xml *xml = &p->job->xml;
    mus_status status = MUS_OK;
    const int32_t grain = mus__val_child(xml, p->element, "grainline", MUS_NONE);
    if (grain != MUS_NONE && piece_flag(xml, grain, "visible", true)) {
        double way[2] = {0.0, 0.0};
        const double angle = mus__val_number(p->job, grain, "rotation", &status);
        mus__val_polar(way, 1.0, angle, way);
        if (status == MUS_OK) status = mus_pattern_set_grain(p->job->pattern, p->panel, way[0], way[1]);
    }
    const int32_t data = mus__val_child(xml, p->element, "data", MUS_NONE);
    const int32_t cut = data != MUS_NONE ? mus__val_child(xml, data, "mcp", MUS_NONE) : MUS_NONE;
    const char *copies = cut != MUS_NONE ? mus__val_attribute(xml, cut, "cutNumber")
                         : data != MUS_NONE ? mus__val_attribute(xml, data, "quantity") : NULL;
    const long count = copies != NULL ? strtol(copies, NULL, 10) : 1;
    if (status == MUS_OK && count > 1 && count <= 1000)
        status = mus_pattern_set_cut(p->job->pattern, p->panel, (int32_t)count, MUS_NONE);
    const int32_t paths = mus__val_child(xml, p->element, "iPaths", MUS_NONE);
    for (int32_t r = paths != MUS_NONE ? mus__val_child(xml, paths, "record", MUS_NONE) : MUS_NONE;
         r != MUS_NONE && status == MUS_OK; r = mus__val_child(xml, paths, "record", r)) {
        const char *text = mus__val_attribute(xml, r, "path");
        const long id = text != NULL ? strtol(text, NULL, 10) : -1;
        if (id >= 0 && id < p->job->nobject && p->job->links[id] < MUS_NONE)
            status = piece_path(p, -2 - p->job->links[id]);
    }
    return status;
}


static mus_status piece_read(mus__val_job *job, int32_t element)
{
    piece p = {.job = job, .element = element, .after = NAN};
    const mus__val_xml *xml = &job->xml;
    mus_status status = MUS_OK;
    p.sewn = piece_flag(xml, element, "seamAllowance", piece_flag(xml, element, "supplement", false));
    if (p.sewn) p.width = mus__val_length(job, element, "width", &status);
    job->allowance = p.width / job->unit;
    if (status == MUS_OK) status = piece_outline(&p);
    char name[128];
    const char *own = mus__val_attribute(xml, element, "name");
    snprintf(name, sizeof name, "%.99s", own != NULL && own[0] != '\0' ? own : "piece");
    mus__text_make_printable(name);
    mus__panel_name_free(job->pattern, name, sizeof name);
    int32_t *work = NULL;
    if (status == MUS_OK && p.n < 2)
        status = mus__source_fail(job->source, xml->elements[element].line, MUS_ERR_FORMAT,
                                  "piece %.60s: its outline has less than two edges", name);
    if (status == MUS_OK) status = mus_pattern_add_panel(job->pattern, name, &p.panel);
    if (status == MUS_OK) {
        work = mus_context_alloc(job->source->context, NULL, 4 * (size_t)p.n * sizeof *work);
        status = work != NULL ? piece_build(&p, work) : MUS_ERR_MEMORY;
    }
    if (status == MUS_OK) status = piece_details(&p);
    mus_context_alloc(job->source->context, work, 0);
    for (int32_t i = 0; i < p.n; i++) mus_context_alloc(job->source->context, p.edges[i].curve.cubic, 0);
    mus_context_alloc(job->source->context, p.edges, 0);
    return status == MUS_OK ? MUS_OK : mus__source_wrap(job->source, 0, status);
}


mus_status mus__val_pieces(mus__val_job *job, int32_t draw)
{
    const mus__val_xml *xml = &job->xml;
    const int32_t made = mus__val_child(xml, draw, "modeling", MUS_NONE);
    for (int32_t e = made != MUS_NONE ? mus__val_child(xml, made, NULL, MUS_NONE) : MUS_NONE; e != MUS_NONE;
         e = mus__val_child(xml, made, NULL, e)) {
        const char *id = mus__val_attribute(xml, e, "id"), *of = mus__val_attribute(xml, e, "idObject");
        const long at = id != NULL ? strtol(id, NULL, 10) : -1;
        if (at < 0 || at >= job->nobject) continue;
        if (strcmp(xml->elements[e].tag, "path") == 0) job->links[at] = -2 - e;
        else if (of != NULL) job->links[at] = (int32_t)strtol(of, NULL, 10);
    }
    int32_t list = mus__val_child(xml, draw, "details", MUS_NONE);
    if (list == MUS_NONE) list = mus__val_child(xml, draw, "pieces", MUS_NONE);
    mus_status status = MUS_OK;
    for (int32_t e = list != MUS_NONE ? mus__val_child(xml, list, NULL, MUS_NONE) : MUS_NONE;
         e != MUS_NONE && status == MUS_OK; e = mus__val_child(xml, list, NULL, e)) {
        const bool left_out = !piece_flag(xml, e, "inLayout", true) || piece_flag(xml, e, "united", false);
        if ((strcmp(xml->elements[e].tag, "detail") == 0 || strcmp(xml->elements[e].tag, "piece") == 0) && !left_out)
            status = piece_read(job, e);
    }
    return status;
}
