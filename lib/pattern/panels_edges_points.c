/*
 * panels_edges_points.c: the cells of a pattern: panels, points, edges, outlines, and reading them back.
 *
 * A new cell is made whole beside the arrays and put in by one assignment, so a failure leaves the pattern as it was.
 * The block of an edge holds, one after another, its points (nxy x 2), the arc length at the start of each piece
 * (npiece + 1) and the kinds of the pieces (npiece). The points are kept to the bit as they were given.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/curve.h"
#include "pattern/pattern_internal.h"

/* largest relative difference of the distances from the middle point of an arc to its ends; chosen: wide enough for
 * files with rounded numbers */
#define ARC_SLACK 1e-6


mus_status mus_pattern_add_panel(mus_pattern *pattern, const char *name, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (name == NULL || name[0] == '\0') return mus__fail(context, MUS_ERR_ARG, "panel: it needs a name");

    mus__panel panel = {.mirror_of = MUS_NONE};
    mus__panel_attributes_init(&panel.attr);
    mus_status status = mus__pattern_take_name(pattern, "panel", name, panel.name);
    if (status != MUS_OK) return status;
    status = mus__pattern_name_panels(pattern);
    if (status != MUS_OK) return status;
    int32_t taken = mus_pattern_find_panel(pattern, panel.name);
    if (taken != MUS_NONE)
        return mus__fail(context, MUS_ERR_ARG, "panel %s: panel %d has this name already", panel.name, (int)taken);

    status = mus__reserve(context, &pattern->panel, &pattern->panel_room, (int64_t)pattern->npanel + 1, sizeof panel);
    if (status != MUS_OK) return status;
    pattern->panel[pattern->npanel] = panel;
    if (out != NULL) *out = pattern->npanel;
    pattern->npanel++;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_set_panel_name(mus_pattern *pattern, int32_t panel, const char *name)
{
    char taken[MUS__NAME_BYTES];
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    if (name == NULL || name[0] == '\0')
        return mus__fail(pattern->context, MUS_ERR_ARG, "panel %s: it needs a name", pattern->panel[panel].name);
    status = mus__pattern_take_name(pattern, "panel", name, taken);
    if (status != MUS_OK) return status;
    const int32_t other = mus_pattern_find_panel(pattern, taken);
    if (other == panel) return MUS_OK;
    if (other != MUS_NONE)
        return mus__fail(pattern->context, MUS_ERR_ARG, "panel %s: panel %d is named %s already",
                         pattern->panel[panel].name, (int)other, taken);
    memcpy(pattern->panel[panel].name, taken, sizeof taken);
    /* the table of names is built anew when the next panel is added */
    for (int32_t i = 0; i < pattern->named_room; i++) pattern->named[i] = MUS_NONE;
    pattern->nnamed = 0;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_add_point(mus_pattern *pattern, int32_t panel, double x, double y, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    mus__point point = {{x, y}, panel};
    status = mus__check_near(pattern->context, 1, 2, point.xy, "point of panel %s", pattern->panel[panel].name);
    if (status != MUS_OK) return status;
    status = mus__reserve(pattern->context, &pattern->point, &pattern->point_room, (int64_t)pattern->npoint + 1,
                          sizeof point);
    if (status != MUS_OK) return status;
    pattern->point[pattern->npoint] = point;
    if (out != NULL) *out = pattern->npoint;
    pattern->npoint++;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


/* is the middle point of each arc equally far from its ends? */
static mus_status cell_arcs_check(const mus_pattern *pattern, const mus__edge *edge)
{
    const double *p = edge->xy;
    for (int32_t i = 0; i < edge->npiece; i++) {
        if (edge->kinds[i] == MUS_PIECE_ARC) {
            double a = mus__hypot(p[2] - p[0], p[3] - p[1]), b = mus__hypot(p[2] - p[4], p[3] - p[5]);
            if (fabs(a - b) > ARC_SLACK * (a + b))
                return mus__fail(pattern->context, MUS_ERR_ARG,
                                 "edge %s: the middle point of arc %d is %g m from one end and %g m from the other",
                                 edge->name, (int)i, a, b);
        }
        p += 2 * (mus__curve_points(edge->kinds[i]) - 1);
    }
    return MUS_OK;
}


/* are the ends, kinds and points of a def those of a chain? */
static mus_status cell_chain_check(const mus_pattern *pattern, const char *name, const mus_edge_def *def)
{
    mus_context *context = pattern->context;
    const int32_t start = def->start, end = def->end, npiece = def->npiece, nxy = def->nxy, *kinds = def->kinds;
    const double *xy = def->xy;
    mus_status status = mus__pattern_known(pattern, "point", start, pattern->npoint);
    if (status == MUS_OK) status = mus__pattern_known(pattern, "point", end, pattern->npoint);
    if (status != MUS_OK) return status;
    if (pattern->point[start].panel != pattern->point[end].panel)
        return mus__fail(context, MUS_ERR_ARG, "edge %s: point %d is in panel %d and point %d in panel %d", name,
                         (int)start, (int)pattern->point[start].panel, (int)end, (int)pattern->point[end].panel);
    if (npiece < 1 || kinds == NULL)
        return mus__fail(context, MUS_ERR_ARG, "edge %s: %d pieces, it needs 1 or more", name, (int)npiece);

    /* each piece has its control points, and an inner joint but for the last */
    int64_t need = (int64_t)npiece - 1;
    for (int32_t i = 0; i < npiece; i++) {
        int32_t points = mus__curve_points(kinds[i]);
        if (points == 0)
            return mus__fail(context, MUS_ERR_ARG, "edge %s: piece %d is of kind %d, kinds are 0 to 3", name, (int)i,
                             (int)kinds[i]);
        need += points - 2;
    }
    if (nxy != need || (nxy > 0 && xy == NULL))
        return mus__fail(context, MUS_ERR_ARG, "edge %s: %d points given, its %d pieces take %lld", name,
                         xy != NULL ? (int)nxy : 0, (int)npiece, (long long)need);
    if (need > INT32_MAX / 4)
        return mus__fail(context, MUS_ERR_LIMIT, "edge %s: %lld points are above the limit", name, (long long)need);
    return mus__check_near(context, nxy, 2, xy, "edge %s: point", name);
}


/* fill the block of an edge: points, kinds, and arc lengths by the closed form or quadrature of each piece */
static void cell_chain_fill(const mus_pattern *pattern, mus__edge *edge, const int32_t *kinds, const double *xy)
{
    size_t inner = (size_t)edge->nxy - 2;
    memcpy(edge->kinds, kinds, (size_t)edge->npiece * sizeof *kinds);
    memcpy(edge->xy, pattern->point[edge->start].xy, 2 * sizeof *xy);
    if (inner > 0) memcpy(edge->xy + 2, xy, 2 * inner * sizeof *xy);
    memcpy(edge->xy + 2 * (inner + 1), pattern->point[edge->end].xy, 2 * sizeof *xy);

    const double *p = edge->xy;
    edge->run[0] = 0.0;
    for (int32_t i = 0; i < edge->npiece; i++) {
        edge->run[i + 1] = edge->run[i] + mus__curve_length(kinds[i], p);
        p += 2 * (mus__curve_points(kinds[i]) - 1);
    }
}


void mus_edge_def_init(mus_edge_def *def, size_t size)
{
    mus_edge_def own = {.start = MUS_NONE, .end = MUS_NONE};
    mus__def_init(def, size, &own, sizeof own);
}


mus_status mus_pattern_add_edge(mus_pattern *pattern, const mus_edge_def *def, int32_t *out)
{
    static const int32_t line = MUS_PIECE_LINE;
    if (out != NULL) *out = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (def == NULL) return mus__fail(context, MUS_ERR_ARG, "edge: its def is NULL");
    mus_edge_def own;
    mus_edge_def_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, sizeof own, def, "edge def");
    if (status != MUS_OK) return status;
    if (own.npiece == 0) own.npiece = 1, own.kinds = &line;

    mus__edge edge = {.start = own.start, .end = own.end, .npiece = own.npiece, .seam = MUS_NONE};
    mus__edge_attributes_init(&edge.attr);
    status = mus__pattern_take_name(pattern, "edge", own.name, edge.name);
    if (status == MUS_OK) status = cell_chain_check(pattern, edge.name, &own);
    if (status != MUS_OK) return status;

    edge.panel = pattern->point[own.start].panel;
    edge.nxy = own.nxy + 2;
    edge.xy = mus__edge_block(context, own.npiece, edge.nxy);
    if (edge.xy == NULL) return mus__fail_memory(context, "an edge");
    mus__edge_views(&edge);
    cell_chain_fill(pattern, &edge, own.kinds, own.xy);

    double length = edge.run[own.npiece];
    status = cell_arcs_check(pattern, &edge);
    if (status == MUS_OK && !(length > 0.0))
        status = mus__fail(context, MUS_ERR_ARG, "edge %s of panel %s: its length is %g m, it must be above 0",
                           edge.name, pattern->panel[edge.panel].name, length);
    if (status == MUS_OK)
        status = mus__reserve(context, &pattern->edge, &pattern->edge_room, (int64_t)pattern->nedge + 1, sizeof edge);
    if (status != MUS_OK) {
        mus__free(context, edge.xy);
        return status;
    }
    pattern->edge[pattern->nedge] = edge;
    if (out != NULL) *out = pattern->nedge;
    pattern->nedge++;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


/* is the word a closed walk over edges of the panel? */
static mus_status cell_word_check(const mus_pattern *pattern, int32_t panel, int32_t n, const int32_t *edges,
                                  const int32_t *directions)
{
    mus_context *context = pattern->context;
    const char *name = pattern->panel[panel].name;
    char title[2 * MUS__NAME_BYTES];
    for (int32_t i = 0; i < n; i++) {
        mus_status status = mus__pattern_known(pattern, "edge", edges[i], pattern->nedge);
        if (status != MUS_OK) return status;
        mus__pattern_edge_title(pattern, edges[i], title);
        if (pattern->edge[edges[i]].panel != panel)
            return mus__fail(context, MUS_ERR_ARG, "outline of panel %s: edge %s is of another panel", name, title);
        if (abs(directions[i]) != 1)
            return mus__fail(context, MUS_ERR_ARG, "outline of panel %s: direction %d of edge %s is neither +1 nor -1",
                             name, (int)directions[i], title);
    }
    for (int32_t i = 0; i < n; i++) {
        int32_t next = i + 1 < n ? i + 1 : 0;
        const mus__edge *a = &pattern->edge[edges[i]], *b = &pattern->edge[edges[next]];
        int32_t end = directions[i] > 0 ? a->end : a->start, start = directions[next] > 0 ? b->start : b->end;
        mus__pattern_edge_title(pattern, edges[next], title);
        if (end != start)
            return mus__fail(context, MUS_ERR_ARG,
                             "outline of panel %s: edge %s starts at point %d, the one before ends at point %d", name,
                             title, (int)start, (int)end);
    }
    return MUS_OK;
}


mus_status mus_pattern_set_outline(mus_pattern *pattern, int32_t panel, int32_t n, const int32_t *edges,
                                   const int32_t *directions)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    if (n < 1 || edges == NULL || directions == NULL)
        return mus__fail(context, MUS_ERR_ARG, "outline of panel %s: %d edges, it needs 1 or more",
                         pattern->panel[panel].name, edges != NULL && directions != NULL ? (int)n : 0);
    status = cell_word_check(pattern, panel, n, edges, directions);
    if (status != MUS_OK) return status;

    /* the old word is freed last: the new one may have been read from it */
    int32_t *outline = mus__new(context, 2 * (int64_t)n, sizeof *outline);
    if (outline == NULL) return mus__fail_memory(context, "an outline");
    memcpy(outline, edges, (size_t)n * sizeof *edges);
    memcpy(outline + n, directions, (size_t)n * sizeof *directions);
    mus__free(context, pattern->panel[panel].outline);
    pattern->panel[panel].outline = outline;
    pattern->panel[panel].noutline = n;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_outline(const mus_pattern *pattern, int32_t panel, int32_t *n, const int32_t **edges,
                               const int32_t **directions)
{
    if (n != NULL) *n = 0;
    if (edges != NULL) *edges = NULL;
    if (directions != NULL) *directions = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;

    const mus__panel *own = &pattern->panel[panel];
    if (n != NULL) *n = own->noutline;
    if (edges != NULL) *edges = own->outline;
    if (directions != NULL && own->outline != NULL) *directions = own->outline + own->noutline;
    return MUS_OK;
}


mus_status mus_pattern_point(const mus_pattern *pattern, int32_t point, int32_t *panel, double *xy)
{
    if (panel != NULL) *panel = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "point", point, pattern->npoint);
    if (status != MUS_OK) return status;
    if (panel != NULL) *panel = pattern->point[point].panel;
    if (xy != NULL) memcpy(xy, pattern->point[point].xy, 2 * sizeof *xy);
    return MUS_OK;
}


int32_t mus_pattern_edge_panel(const mus_pattern *pattern, int32_t edge)
{
    return pattern != NULL && edge >= 0 && edge < pattern->nedge ? pattern->edge[edge].panel : MUS_NONE;
}


mus_status mus_pattern_edge_ends(const mus_pattern *pattern, int32_t edge, int32_t *start, int32_t *end)
{
    if (start != NULL) *start = MUS_NONE;
    if (end != NULL) *end = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;
    if (start != NULL) *start = pattern->edge[edge].start;
    if (end != NULL) *end = pattern->edge[edge].end;
    return MUS_OK;
}


mus_status mus_pattern_edge_pieces(const mus_pattern *pattern, int32_t edge, int32_t *npiece, const int32_t **kinds,
                                   int32_t *nxy, const double **xy)
{
    if (npiece != NULL) *npiece = 0;
    if (kinds != NULL) *kinds = NULL;
    if (nxy != NULL) *nxy = 0;
    if (xy != NULL) *xy = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;

    const mus__edge *own = &pattern->edge[edge];
    if (npiece != NULL) *npiece = own->npiece;
    if (kinds != NULL) *kinds = own->kinds;
    if (nxy != NULL) *nxy = own->nxy;
    if (xy != NULL) *xy = own->xy;
    return MUS_OK;
}
