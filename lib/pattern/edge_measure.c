/*
 * edge_measure.c: measures of edges and panels [m, m2]: length of an edge, point at an arc length, polyline with a
 * given number of points; area and perimeter of a panel.
 *
 * Lengths are computed once, when an edge is added: run[i] is the arc length at the start of piece i. The point at arc
 * length s lies on the piece found by binary search in run, at the parameter whose arc length is s - run[i].
 */
#include <math.h>
#include <string.h>

#include "geom/curve.h"
#include "pattern/pattern_internal.h"


double mus_pattern_edge_length(const mus_pattern *pattern, int32_t edge)
{
    if (pattern == NULL || edge < 0 || edge >= pattern->nedge) return (double)NAN;
    return pattern->edge[edge].run[pattern->edge[edge].npiece];
}


/* Returns the index of the first point of a piece in edge->xy. */
static int32_t measure_offset(const mus__edge *edge, int32_t piece)
{
    int32_t at = 0;
    for (int32_t i = 0; i < piece; i++) at += mus__curve_points(edge->kinds[i]) - 1;
    return at;
}


/* Writes the point of an edge at relative arc length t (0 to 1); at 0 and 1 it is the end point, bit for bit. */
static void measure_at(const mus__edge *edge, double t, double *out)
{
    if (t == 0.0 || t == 1.0) {
        memcpy(out, t == 0.0 ? edge->xy : edge->xy + 2 * ((size_t)edge->nxy - 1), 2 * sizeof *out);
        return;
    }

    /* the last piece that starts at or before s */
    double s = t * edge->run[edge->npiece];
    int32_t low = 0, high = edge->npiece;
    while (high - low > 1) {
        int32_t middle = low + (high - low) / 2;
        if (edge->run[middle] <= s)
            low = middle;
        else
            high = middle;
    }
    const double *p = edge->xy + 2 * (size_t)measure_offset(edge, low);
    int32_t kind = edge->kinds[low];
    mus__curve_at(kind, p, mus__curve_param(kind, p, s - edge->run[low]), out);
}


mus_status mus_pattern_edge_at(const mus_pattern *pattern, int32_t edge, int32_t n, const double *t, double *out)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;
    if (n < 0 || (n > 0 && (t == NULL || out == NULL)))
        return mus__fail(context, MUS_ERR_ARG, "edge %d: %d points asked, or an array is NULL", (int)edge, (int)n);
    for (int32_t i = 0; i < n; i++) {
        if (!(t[i] >= 0.0 && t[i] <= 1.0))
            return mus__fail(context, MUS_ERR_ARG, "edge %d: relative arc length %g is outside 0 to 1", (int)edge,
                             t[i]);
    }
    for (int32_t i = 0; i < n; i++) measure_at(&pattern->edge[edge], t[i], out + 2 * (size_t)i);
    return MUS_OK;
}


mus_status mus_pattern_edge_polyline(const mus_pattern *pattern, int32_t edge, int32_t chords, double *xy,
                                     int32_t capacity, int32_t *count)
{
    if (count != NULL) *count = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    mus_status status = mus__pattern_known(pattern, "edge", edge, pattern->nedge);
    if (status != MUS_OK) return status;
    if (chords < 1 || (xy != NULL && capacity < 0))
        return mus__fail(context, MUS_ERR_ARG, "edge %d: %d chords, room for %d points", (int)edge, (int)chords,
                         (int)capacity);

    const mus__edge *own = &pattern->edge[edge];
    int64_t need = 1;
    for (int32_t i = 0; i < own->npiece; i++) need += own->kinds[i] == MUS_PIECE_LINE ? 1 : chords;
    if (need > INT32_MAX)
        return mus__fail(context, MUS_ERR_LIMIT, "edge %d: %lld points are more than 2^31", (int)edge, (long long)need);
    if (count != NULL) *count = (int32_t)need;
    if (xy == NULL) return MUS_OK;

    /* the ends of pieces are copied bit for bit, the points between them are computed */
    const double *p = own->xy;
    int32_t at = 0;
    for (int32_t i = 0; i < own->npiece && at < capacity; i++) {
        int32_t kind = own->kinds[i], n = kind == MUS_PIECE_LINE ? 1 : chords;
        for (int32_t j = 0; j < n && at < capacity; j++, at++) {
            double *out = xy + 2 * (size_t)at;
            if (j == 0)
                memcpy(out, p, 2 * sizeof *out);
            else
                mus__curve_at(kind, p, (double)j / n, out);
        }
        p += 2 * (mus__curve_points(kind) - 1);
    }
    if (at < capacity && at < need) memcpy(xy + 2 * (size_t)at, p, 2 * sizeof *p);
    return MUS_OK;
}


/* A = 1/2 sum over the edges of the outline of +-integral (x dy - y dx), in closed form for each piece */
double mus_pattern_panel_area(const mus_pattern *pattern, int32_t panel)
{
    if (pattern == NULL || panel < 0 || panel >= pattern->npanel) return (double)NAN;
    const mus__panel *own = &pattern->panel[panel];
    if (own->noutline == 0) return (double)NAN;

    double area = 0.0;
    for (int32_t i = 0; i < own->noutline; i++) {
        const mus__edge *edge = &pattern->edge[own->outline[i]];
        const double *p = edge->xy;
        double part = 0.0;
        for (int32_t j = 0; j < edge->npiece; j++) {
            part += mus__curve_area(edge->kinds[j], p);
            p += 2 * (mus__curve_points(edge->kinds[j]) - 1);
        }
        area += own->outline[own->noutline + i] > 0 ? part : -part;
    }
    return fabs(area);
}


double mus_pattern_panel_perimeter(const mus_pattern *pattern, int32_t panel)
{
    if (pattern == NULL || panel < 0 || panel >= pattern->npanel) return (double)NAN;
    const mus__panel *own = &pattern->panel[panel];
    if (own->noutline == 0) return (double)NAN;

    double length = 0.0;
    const int32_t n = own->noutline;
    for (int32_t i = 0; i < n; i++) {
        bool both = false;
        for (int32_t j = 0; j < n && !both; j++)
            both = own->outline[i] == own->outline[j] && own->outline[n + i] != own->outline[n + j];
        if (!both) length += mus_pattern_edge_length(pattern, own->outline[i]);
    }
    return length;
}
