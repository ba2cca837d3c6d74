/*
 * svg_panel.c: the paths of one panel of an SVG as a panel of a pattern: edges, outline, grain, marks, notches.
 *
 * A panel is drawn as edges, each a path that starts where the one before it ends, or as one closed path, whose edges
 * begin at corners of more than 30 degrees. The right side of the cloth is seen, unless the order of the edges is
 * given.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "trade/dxf_file.h"
#include "trade/svg_panel.h"

#define CORNER 0.5236     /* [rad] 30 degrees: a sharper bend of a closed path begins an edge; as of a DXF */
#define JOINED 5e-4       /* [m] ends this near are one point; chosen: as a hand with a snapping pen leaves them */
#define JOINED_GIVEN 1e-6 /* [m] the same where the order of the edges is given; chosen: digits of the file */
#define NEAREST_CHORDS 64 /* chords of a curve, of which the nearest place is taken */

typedef struct panel_work {
    const mus__source *source;
    mus__svg_panel *panel;
    mus_pattern *pattern;
    int32_t index;
    double joined; /* [m] */
    int32_t nedge, edge_room, direction_room, npoint, point_room;
    int32_t *edges, *directions; /* (nedge) in the order of the file */
    int32_t *points;             /* (npoint) of the panel */
} panel_work;


static const int32_t svg_controls[] = {0, 1, 2, 1}; /* of MUS_PIECE_* */


void mus__svg_panel_clear(mus_context *context, mus__svg_panel *panel)
{
    for (int32_t i = 0; i < panel->n; i++) mus__svg_path_free(context, &panel->items[i].path);
    mus_context_alloc(context, panel->items, 0);
    memset(panel, 0, sizeof *panel);
}


static mus_status item_wrap(const panel_work *w, const mus__svg_item *item, mus_status status)
{
    return status == MUS_OK ? MUS_OK : mus__source_wrap(w->source, item->line, status);
}


/* ---- edges ---- */

/* the point of the panel at p, a new one unless there is one within `joined` */
static mus_status point_at(panel_work *w, const mus__svg_item *item, const double *p, int32_t *out)
{
    for (int32_t i = w->npoint - 1; i >= 0; i--) {
        double q[2];
        mus_status status = mus_pattern_point(w->pattern, w->points[i], NULL, q);
        if (status != MUS_OK) return status;
        if (fabs(q[0] - p[0]) > w->joined || fabs(q[1] - p[1]) > w->joined) continue;
        *out = w->points[i];
        return MUS_OK;
    }
    mus_status status =
        mus__source_reserve(w->source, &w->points, &w->point_room, (int64_t)w->npoint + 1, sizeof *w->points);
    if (status == MUS_OK) status = item_wrap(w, item, mus_pattern_add_point(w->pattern, w->index, p[0], p[1], out));
    if (status == MUS_OK) w->points[w->npoint++] = *out;
    return status;
}


/* an edge of `npiece` pieces from point `first` of the item's path */
static mus_status edge_add(panel_work *w, mus__svg_item *item, const int32_t *kinds, int32_t npiece, const double *xy,
                           int32_t nxy)
{
    mus_edge_def def;
    mus_edge_def_init(&def, sizeof def);
    def.name = item->name[0] != '\0' ? item->name : NULL;
    def.npiece = npiece;
    def.kinds = kinds;
    def.nxy = nxy - 2;
    def.xy = xy + 2;
    mus_status status = point_at(w, item, xy, &def.start);
    if (status == MUS_OK) status = point_at(w, item, xy + 2 * nxy - 2, &def.end);
    if (status == MUS_OK)
        status = mus__source_reserve(w->source, &w->edges, &w->edge_room, (int64_t)w->nedge + 1, sizeof *w->edges);
    if (status == MUS_OK) status = item_wrap(w, item, mus_pattern_add_edge(w->pattern, &def, &item->made));
    if (status == MUS_OK && item->label[0] != '\0')
        status = item_wrap(w, item, mus_pattern_set_edge_label(w->pattern, item->made, item->label));
    if (status == MUS_OK && item->allowance == item->allowance)
        status = item_wrap(w, item, mus_pattern_set_edge_allowance(w->pattern, item->made, item->allowance));
    if (status == MUS_OK) w->edges[w->nedge++] = item->made;
    return status;
}


/* direction of a chord from point a of the path to point b; false for a chord of no length */
static bool chord_turn(const double *xy, int32_t a, int32_t b, double *out)
{
    out[0] = xy[2 * b] - xy[2 * a];
    out[1] = xy[2 * b + 1] - xy[2 * a + 1];
    return fabs(out[0]) + fabs(out[1]) > 1e-9;
}


/* true where the path bends by more than 30 degrees at point `at`, which follows point `before` and precedes `after` */
static bool is_corner(const double *xy, int32_t before, int32_t at, int32_t after)
{
    double u[2], v[2];
    if (!chord_turn(xy, before, at, u) || !chord_turn(xy, at, after, v)) return true;
    return fabs(mus__atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])) > CORNER;
}


/* a closed path as edges between its corners; the path's own start begins an edge too */
static mus_status outline_split(panel_work *w, mus__svg_item *item)
{
    const mus__svg_path *path = &item->path;
    mus_status status = MUS_OK;
    if (!path->closed)
        return mus__source_fail(w->source, item->line, MUS_ERR_FORMAT,
                                "panel %s: the outline is open; expected a closed path", w->panel->name);
    for (int32_t k = 0, at = 0, piece = 0, start = 0; k < path->npiece && status == MUS_OK; k++) {
        at += svg_controls[path->kinds[k]] + 1;
        const bool last = k + 1 == path->npiece;
        /* of an arc the middle point stands for its direction, which is right within 30 degrees up to a third turn */
        if (!last && !is_corner(path->xy, at - 1, at, at + 1)) continue;
        status = edge_add(w, item, path->kinds + piece, k + 1 - piece, path->xy + 2 * (size_t)start, at - start + 1);
        start = at;
        piece = k + 1;
    }
    return status;
}


static mus_status panel_edges(panel_work *w)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < w->panel->n && status == MUS_OK; i++) {
        mus__svg_item *item = &w->panel->items[i];
        item->made = MUS_NONE;
        if (item->kind == MUS__SVG_EDGE && item->path.npiece > 0)
            status = edge_add(w, item, item->path.kinds, item->path.npiece, item->path.xy, item->path.nxy);
        else if (item->kind == MUS__SVG_OUTLINE)
            status = outline_split(w, item);
    }
    if (status == MUS_OK && w->nedge == 0)
        status =
            mus__source_fail(w->source, w->panel->line, MUS_ERR_FORMAT,
                             "panel %s: no outline; expected a closed path or paths of class edge", w->panel->name);
    return status;
}


/* ---- outline ---- */

static mus_status word_fail(const panel_work *w, const char *at)
{
    return mus__source_fail(w->source, w->panel->line, MUS_ERR_FORMAT,
                            "panel %s: data-outline: expected numbers of its edges from 1, got \"%.20s\"",
                            w->panel->name, at);
}


/* the order that the file gives: "1 2 -3"; *n is how many numbers there are */
static mus_status word_read(panel_work *w, int32_t **edges, int32_t **directions, int32_t *n)
{
    int32_t edge_room = 0, direction_room = 0;
    *n = 0;
    for (const char *at = w->panel->word; *at != '\0';) {
        char *end;
        const long k = strtol(at, &end, 10);
        if (end == at) {
            if (strspn(at, " ,\t\r\n") == strlen(at)) break;
            return word_fail(w, at);
        }
        if (k == 0 || labs(k) > w->nedge) return word_fail(w, at);
        mus_status status = mus__source_reserve(w->source, edges, &edge_room, (int64_t)*n + 1, sizeof **edges);
        if (status == MUS_OK)
            status = mus__source_reserve(w->source, directions, &direction_room, (int64_t)*n + 1, sizeof **directions);
        if (status != MUS_OK) return status;
        (*edges)[*n] = w->edges[labs(k) - 1];
        (*directions)[(*n)++] = k > 0 ? 1 : -1;
        at = end;
    }
    return MUS_OK;
}


/* twice the area within the chords of the edges in their order [m2]; negative where they run clockwise */
static double word_area(const panel_work *w)
{
    double area = 0.0;
    for (int32_t i = 0; i < w->nedge; i++) {
        const double *xy;
        int32_t n;
        if (mus_pattern_edge_pieces(w->pattern, w->edges[i], NULL, NULL, &n, &xy) != MUS_OK) return 0.0;
        for (int32_t k = 0; k + 1 < n; k++)
            area += w->directions[i] * (xy[2 * k] * xy[2 * k + 3] - xy[2 * k + 2] * xy[2 * k + 1]);
    }
    return area;
}


/* each edge follows the one before it, in the order of the file; an edge drawn the other way counts -1 */
static mus_status word_chain(panel_work *w)
{
    mus_status status =
        mus__source_reserve(w->source, &w->directions, &w->direction_room, w->nedge, sizeof *w->directions);
    int32_t pen = MUS_NONE;
    for (int32_t i = 0; i < w->nedge && status == MUS_OK; i++) {
        int32_t a, b, c = MUS_NONE, d = MUS_NONE;
        status = mus_pattern_edge_ends(w->pattern, w->edges[i], &a, &b);
        if (status == MUS_OK && i == 0 && w->nedge > 1) status = mus_pattern_edge_ends(w->pattern, w->edges[1], &c, &d);
        const bool against = i == 0 ? (a == c || a == d) && b != c && b != d : a != pen;
        w->directions[i] = against ? -1 : 1;
        if (i > 0 && pen != a && pen != b)
            return mus__source_fail(w->source, w->panel->line, MUS_ERR_FORMAT,
                                    "panel %s: edge %d does not start where edge %d ends; expected ends within 0.5 mm",
                                    w->panel->name, (int)i + 1, (int)i);
        pen = against ? a : b;
    }
    if (status != MUS_OK || word_area(w) >= 0.0) return status;
    for (int32_t i = 0, k = w->nedge - 1; i <= k; i++, k--) {
        const int32_t edge = w->edges[i], direction = w->directions[i];
        w->edges[i] = w->edges[k];
        w->directions[i] = -w->directions[k];
        w->edges[k] = edge;
        w->directions[k] = -direction;
    }
    return MUS_OK;
}


static mus_status panel_outline(panel_work *w)
{
    int32_t *edges = NULL, *directions = NULL, n = 0;
    mus_status status = MUS_OK;
    if (w->panel->word == NULL) {
        status = word_chain(w);
        if (status == MUS_OK) status = mus_pattern_set_outline(w->pattern, w->index, w->nedge, w->edges, w->directions);
    } else {
        status = word_read(w, &edges, &directions, &n);
        if (status == MUS_OK) status = mus_pattern_set_outline(w->pattern, w->index, n, edges, directions);
    }
    mus_context_alloc(w->source->context, edges, 0);
    mus_context_alloc(w->source->context, directions, 0);
    return status == MUS_OK ? MUS_OK : mus__source_wrap(w->source, w->panel->line, status);
}


/* ---- what is inside ---- */

mus_status mus__svg_nearest(const mus__source *source, const mus_pattern *pattern, int32_t edge, const double *p,
                            double *s, double *distance)
{
    int32_t n = 0;
    mus_status status = mus_pattern_edge_polyline(pattern, edge, NEAREST_CHORDS, NULL, 0, &n);
    double *xy = status == MUS_OK ? mus_context_alloc(source->context, NULL, 2 * sizeof *xy * (size_t)n) : NULL;
    if (status == MUS_OK && xy == NULL) status = mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for an edge");
    if (status == MUS_OK) status = mus_pattern_edge_polyline(pattern, edge, NEAREST_CHORDS, xy, n, &n);
    double along = 0.0;
    *s = 0.0;
    *distance = HUGE_VAL;
    for (int32_t i = 0; i + 1 < n && status == MUS_OK; i++) {
        const double *a = xy + 2 * i, d[2] = {a[2] - a[0], a[3] - a[1]}, dd = d[0] * d[0] + d[1] * d[1];
        const double t = dd > 0.0 ? fmin(1.0, fmax(0.0, ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / dd)) : 0.0;
        const double x = a[0] + t * d[0] - p[0], y = a[1] + t * d[1] - p[1], off = sqrt(x * x + y * y);
        if (off < *distance) {
            *distance = off;
            *s = along + t * sqrt(dd);
        }
        along += sqrt(dd);
    }
    const double length = status == MUS_OK ? mus_pattern_edge_length(pattern, edge) : 0.0;
    if (along > 0.0) *s = fmin(length, *s * length / along);
    mus_context_alloc(source->context, xy, 0);
    return status;
}


/* the edge of a notch: the one that it names, else the nearest; *s gets the nearest place unless it is given */
static mus_status notch_edge(const panel_work *w, const mus__svg_item *item, int32_t *edge, double *s)
{
    double best = HUGE_VAL;
    mus_status status = MUS_OK;
    *edge = MUS_NONE;
    for (int32_t i = 0; i < w->panel->n && item->edge[0] != '\0'; i++)
        if (w->panel->items[i].made != MUS_NONE && strcmp(w->panel->items[i].id, item->edge) == 0)
            *edge = w->panel->items[i].made;
    for (int32_t i = 0; i < w->nedge && item->edge[0] == '\0' && status == MUS_OK; i++) {
        double place, distance;
        status = mus__svg_nearest(w->source, w->pattern, w->edges[i], item->path.xy, &place, &distance);
        if (status != MUS_OK || distance >= best) continue;
        best = distance;
        *edge = w->edges[i];
        *s = place;
    }
    return status;
}


static mus_status notch_add(const panel_work *w, const mus__svg_item *item)
{
    int32_t edge;
    double s = item->s;
    mus_status status = notch_edge(w, item, &edge, &s);
    if (status != MUS_OK) return status;
    if (edge == MUS_NONE || s != s)
        return mus__source_fail(w->source, item->line, MUS_ERR_FORMAT,
                                "notch: expected data-edge (the id of an edge of panel %s) with data-s, or neither",
                                w->panel->name);
    s = fmin(s, mus_pattern_edge_length(w->pattern, edge));
    return item_wrap(w, item, mus_pattern_add_notch(w->pattern, edge, s, (int32_t)item->notch, NULL));
}


static mus_status panel_items(panel_work *w)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < w->panel->n && status == MUS_OK; i++) {
        const mus__svg_item *item = &w->panel->items[i];
        const double *xy = item->path.xy;
        const int32_t n = item->path.nxy;
        if (item->kind == MUS__SVG_GRAIN && n > 1)
            status = item_wrap(
                w, item, mus_pattern_set_grain(w->pattern, w->index, xy[2 * n - 2] - xy[0], xy[2 * n - 1] - xy[1]));
        else if (item->kind == MUS__SVG_MARK)
            status = item_wrap(w, item, mus_pattern_add_mark(w->pattern, w->index, item->name, n, xy, NULL));
        else if (item->kind == MUS__SVG_NOTCH)
            status = notch_add(w, item);
    }
    return status;
}


static mus_status panel_head(panel_work *w)
{
    mus__svg_panel *panel = w->panel;
    const size_t length = strlen(panel->name);
    for (int32_t k = 2; mus_pattern_find_panel(w->pattern, panel->name) != MUS_NONE; k++)
        snprintf(panel->name + (length < 116 ? length : 116), 12, " %d", (int)k);
    mus_status status = mus_pattern_add_panel(w->pattern, panel->name, &w->index);
    if (status == MUS_OK && panel->label[0] != '\0')
        status = mus_pattern_set_panel_label(w->pattern, w->index, panel->label);
    if (status == MUS_OK) status = mus_pattern_set_layer(w->pattern, w->index, (int32_t)panel->layer);
    if (status != MUS_OK) return mus__source_wrap(w->source, panel->line, status);
    return MUS_OK;
}


mus_status mus__svg_panel_add(const mus__source *source, mus__svg_panel *panel, mus_pattern *pattern, int32_t *out)
{
    panel_work w = {
        .source = source, .panel = panel, .pattern = pattern, .joined = panel->word != NULL ? JOINED_GIVEN : JOINED};
    mus_status status = panel_head(&w);
    if (status == MUS_OK) status = panel_edges(&w);
    if (status == MUS_OK) status = panel_outline(&w);
    if (status == MUS_OK) status = panel_items(&w);
    mus_context_alloc(source->context, w.edges, 0);
    mus_context_alloc(source->context, w.directions, 0);
    mus_context_alloc(source->context, w.points, 0);
    *out = w.index;
    return status;
}
