/*
 * garmentcode_write.c: a pattern as a GarmentCode specification (JSON).
 *
 * There an edge is one line, arc or Bezier, and a stitch joins two whole edges. So each edge is written as its pieces,
 * and both edges of a seam are cut where either of them has a joint, at equal relative arc lengths: they get equally
 * many parts, which are stitched one by one. Units are centimetres and degrees.
 *
 * Not held: lines inside panels, a second seam of an edge (layers of a pleat), ease, closures, notches, marks, grain,
 * allowances, quantities, bent placements, layers.
 * Source: Korosteleva and Sorkine-Hornung, GarmentCode: Programming Parametric Sewing Patterns, 2023.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "exchange/file_read.h"
#include "file/sink.h"
#include "trade/dxf_file.h"

#define GCW_CHORDS 256   /* chords that measure a piece; chosen: a break is right within 1e-6 of its length */
#define GCW_JOINT 5e-4   /* [m] joints of both edges of a seam this near are one; chosen: the tolerance of a seam */
#define GCW_ROUND 1e-9   /* [m] a part whose ends are this near is a loop, which the form has not */

/* one part of an edge: a line, a Bezier or an arc */
typedef struct gcw_part {
    int32_t kind; /* MUS_PIECE_* */
    double p[8];  /* start, control points, end [m], in the direction of the outline */
} gcw_part;

typedef struct gcw_writer {
    mus__sink *sink;
    const mus_pattern *pattern;
    mus__source source;  /* of the messages and of memory; it has no text */
    int32_t *first;      /* (edges) number of the first part of each edge in its panel, MUS_NONE outside outlines */
    int32_t *count;      /* (edges) number of its parts */
    int32_t *direction;  /* (edges) of the outline */
    double *breaks;      /* (nbreak) relative arc lengths at which the edge at hand is cut, ascending */
    int32_t nbreak, break_room;
    gcw_part *parts;     /* (npart) of the panel at hand */
    int32_t npart, part_room;
} gcw_writer;

static const int32_t gcw_controls[] = {0, 1, 2, 1}; /* of MUS_PIECE_* */


/* ---- pieces ---- */

/* the arc through s, m, e: centre c (2), angle of s and sweep [rad] */
static bool arc_circle(const double *p, double *c, double *from, double *sweep)
{
    double ax = p[2] - p[0], ay = p[3] - p[1], bx = p[4] - p[0], by = p[5] - p[1];
    double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cross = ax * by - ay * bx;
    if (fabs(cross) <= 1e-12 * (aa + bb)) return false;
    c[0] = p[0] + 0.5 * (by * aa - ay * bb) / cross;
    c[1] = p[1] + 0.5 * (ax * bb - bx * aa) / cross;
    *from = mus__atan2(p[1] - c[1], p[0] - c[0]);
    *sweep = mus__atan2(p[5] - c[1], p[4] - c[0]) - *from;
    const double turn = 360.0 * MUS__DEGREE;
    if (cross > 0.0 && *sweep <= 0.0) *sweep += turn;
    if (cross < 0.0 && *sweep >= 0.0) *sweep -= turn;
    return true;
}


/* the point of a piece at parameter t */
static void piece_at(int32_t kind, const double *p, double t, double *out)
{
    double q[8], c[2], from, sweep;
    const int32_t n = gcw_controls[kind] + 2;
    if (kind == MUS_PIECE_ARC && arc_circle(p, c, &from, &sweep)) {
        const double r = mus__hypot(p[0] - c[0], p[1] - c[1]), a = from + t * sweep;
        out[0] = c[0] + r * mus__cos(a);
        out[1] = c[1] + r * mus__sin(a);
        return;
    }
    memcpy(q, p, 2 * (size_t)n * sizeof *q);
    if (kind == MUS_PIECE_ARC) memcpy(q + 2, p + 4, 2 * sizeof *q); /* a straight one */
    for (int32_t k = (kind == MUS_PIECE_ARC ? 2 : n) - 1; k > 0; k--)
        for (int32_t i = 0; i < 2 * k; i++) q[i] += t * (q[i + 2] - q[i]);
    memcpy(out, q, 2 * sizeof *q);
}


/* the part of a piece between parameters a and b */
static void piece_part(int32_t kind, const double *p, double a, double b, gcw_part *out)
{
    const int32_t n = gcw_controls[kind] + 2;
    double q[8];
    out->kind = kind;
    if (kind == MUS_PIECE_ARC) {
        piece_at(kind, p, a, out->p);
        piece_at(kind, p, 0.5 * (a + b), out->p + 2);
        piece_at(kind, p, b, out->p + 4);
        return;
    }
    /* de Casteljau: keep the start up to b, then the end from a / b on */
    memcpy(q, p, 2 * (size_t)n * sizeof *q);
    memcpy(out->p, p, 2 * (size_t)n * sizeof *q);
    for (int32_t k = 1; k < n; k++) {
        for (int32_t i = 0; i < 2 * (n - k); i++) q[i] += b * (q[i + 2] - q[i]);
        memcpy(out->p + 2 * k, q, 2 * sizeof *q);
    }
    memcpy(q, out->p, 2 * (size_t)n * sizeof *q);
    for (int32_t k = 1; k < n; k++)
        for (int32_t i = 0; i < 2 * (n - k); i++) q[i] += a / b * (q[i + 2] - q[i]);
    memcpy(out->p, q, 2 * (size_t)n * sizeof *q);
}


/* parameter of a piece at the relative arc length s */
static double piece_parameter(int32_t kind, const double *p, double s)
{
    double length[GCW_CHORDS + 1] = {0.0}, last[2], at[2];
    memcpy(last, p, sizeof last);
    for (int32_t i = 1; i <= GCW_CHORDS; i++) {
        piece_at(kind, p, (double)i / GCW_CHORDS, at);
        length[i] = length[i - 1] + mus__hypot(at[0] - last[0], at[1] - last[1]);
        memcpy(last, at, sizeof last);
    }
    int32_t i = 0;
    while (i + 1 < GCW_CHORDS && length[i + 1] < s * length[GCW_CHORDS]) i++;
    const double step = length[i + 1] - length[i];
    return (i + (step > 0.0 ? (s * length[GCW_CHORDS] - length[i]) / step : 0.0)) / GCW_CHORDS;
}


static double piece_length(int32_t kind, const double *p)
{
    double length = 0.0, last[2], at[2];
    memcpy(last, p, sizeof last);
    for (int32_t i = 1; i <= GCW_CHORDS; i++) {
        piece_at(kind, p, (double)i / GCW_CHORDS, at);
        length += mus__hypot(at[0] - last[0], at[1] - last[1]);
        memcpy(last, at, sizeof last);
    }
    return length;
}


/* ---- breaks ---- */

static mus_status break_add(gcw_writer *w, double t)
{
    mus_status status = mus__source_reserve(&w->source, &w->breaks, &w->break_room, (int64_t)w->nbreak + 1,
                                           sizeof *w->breaks);
    if (status != MUS_OK) return status;
    int32_t i = w->nbreak++;
    for (; i > 0 && w->breaks[i - 1] > t; i--) w->breaks[i] = w->breaks[i - 1];
    w->breaks[i] = t;
    return MUS_OK;
}


/* add the joints of an edge as relative arc lengths, of the edge that runs the other way when `back`; those within
 * `near` of the first `known` breaks are the same joints */
static mus_status breaks_of(gcw_writer *w, int32_t edge, bool back, double near)
{
    int32_t n;
    const int32_t *kinds;
    const double *xy, *p;
    mus_status status = mus_pattern_edge_pieces(w->pattern, edge, &n, &kinds, NULL, &xy);
    double whole = 0.0, s = 0.0;
    p = xy;
    for (int32_t i = 0; i < n && status == MUS_OK; p += 2 * (gcw_controls[kinds[i]] + 1), i++)
        whole += piece_length(kinds[i], p);
    p = xy;
    for (int32_t i = 0; i + 1 < n && status == MUS_OK; p += 2 * (gcw_controls[kinds[i]] + 1), i++) {
        s += piece_length(kinds[i], p);
        const double t = back ? 1.0 - s / whole : s / whole;
        bool known = false;
        for (int32_t k = 0; k < w->nbreak; k++) known = known || fabs(w->breaks[k] - t) < near;
        if (!known || near == 0.0) status = break_add(w, t);
    }
    return status;
}


/* the seam that an edge is written in: its first one that is not laid, when it is that of both edges */
static int32_t edge_stitch(const mus_pattern *pattern, int32_t edge, mus_seam_def *seam)
{
    const int32_t found = mus_pattern_edge_seam(pattern, edge);
    mus_seam_def_init(seam, sizeof *seam);
    if (found == MUS_NONE || mus_pattern_seam(pattern, found, seam) != MUS_OK || seam->laid) return MUS_NONE;
    const int32_t other = seam->edge_a == edge ? seam->edge_b : seam->edge_a;
    return mus_pattern_edge_seam(pattern, other) == found ? found : MUS_NONE;
}


/* where an edge is cut: at its own joints and at those of the edge that it is sewn to */
static mus_status edge_breaks(gcw_writer *w, int32_t edge)
{
    mus_seam_def seam;
    w->nbreak = 0;
    mus_status status = breaks_of(w, edge, false, 0.0);
    if (status != MUS_OK || edge_stitch(w->pattern, edge, &seam) == MUS_NONE) return status;
    const int32_t other = seam.edge_a == edge ? seam.edge_b : seam.edge_a;
    const double a = mus_pattern_edge_length(w->pattern, edge), b = mus_pattern_edge_length(w->pattern, other);
    return breaks_of(w, other, seam.direction == MUS_SEAM_REVERSED, GCW_JOINT / (a < b ? a : b));
}


/* ---- parts ---- */

static mus_status part_add(gcw_writer *w, const gcw_part *part)
{
    mus_status status = mus__source_reserve(&w->source, &w->parts, &w->part_room, (int64_t)w->npart + 1,
                                           sizeof *w->parts);
    if (status == MUS_OK) w->parts[w->npart++] = *part;
    return status;
}


/* add the parts of one piece that covers from .. to of the edge [relative arc length] */
static mus_status piece_parts(gcw_writer *w, int32_t kind, const double *p, double from, double to)
{
    double last = 0.0;
    mus_status status = MUS_OK;
    gcw_part part;
    for (int32_t i = 0; i < w->nbreak && status == MUS_OK; i++) {
        if (w->breaks[i] <= from + 1e-9 || w->breaks[i] >= to - 1e-9) continue;
        const double t = piece_parameter(kind, p, (w->breaks[i] - from) / (to - from));
        piece_part(kind, p, last, t, &part);
        status = part_add(w, &part);
        last = t;
    }
    piece_part(kind, p, last, 1.0, &part);
    return status == MUS_OK ? part_add(w, &part) : status;
}


/* turn the parts from `first` on round: the outline runs against the edge */
static void parts_reverse(gcw_writer *w, int32_t first)
{
    for (int32_t i = first, j = w->npart - 1; i < j; i++, j--) {
        const gcw_part swap = w->parts[i];
        w->parts[i] = w->parts[j];
        w->parts[j] = swap;
    }
    for (int32_t i = first; i < w->npart; i++) {
        double *p = w->parts[i].p, q[8];
        const int32_t n = gcw_controls[w->parts[i].kind] + 2;
        memcpy(q, p, sizeof q);
        for (int32_t k = 0; k < n; k++) memcpy(p + 2 * k, q + 2 * (n - 1 - k), 2 * sizeof *p);
    }
}


static mus_status edge_parts(gcw_writer *w, int32_t edge, int32_t direction)
{
    int32_t n;
    const int32_t *kinds;
    const double *xy, *p;
    mus_status status = edge_breaks(w, edge);
    if (status == MUS_OK) status = mus_pattern_edge_pieces(w->pattern, edge, &n, &kinds, NULL, &xy);
    if (status != MUS_OK) return status;
    double whole = 0.0, s = 0.0;
    p = xy;
    for (int32_t i = 0; i < n; p += 2 * (gcw_controls[kinds[i]] + 1), i++) whole += piece_length(kinds[i], p);
    p = xy;
    w->first[edge] = w->npart;
    w->direction[edge] = direction;
    for (int32_t i = 0; i < n && status == MUS_OK; p += 2 * (gcw_controls[kinds[i]] + 1), i++) {
        const double length = piece_length(kinds[i], p);
        status = piece_parts(w, kinds[i], p, s / whole, (s + length) / whole);
        s += length;
    }
    w->count[edge] = w->npart - w->first[edge];
    if (direction < 0) parts_reverse(w, w->first[edge]);
    return status;
}


/* ---- JSON ---- */

static void put_pair(const gcw_writer *w, double x, double y)
{
    mus__sink_print(w->sink, "[");
    mus__sink_number(w->sink, x);
    mus__sink_print(w->sink, ", ");
    mus__sink_number(w->sink, y);
    mus__sink_print(w->sink, "]");
}


/* control points relative to the edge: x along it, y to its left, in lengths of the edge */
static void put_curvature(const gcw_writer *w, const gcw_part *part)
{
    const double *p = part->p;
    const int32_t n = gcw_controls[part->kind];
    const double ex = p[2 * n + 2] - p[0], ey = p[2 * n + 3] - p[1], ee = ex * ex + ey * ey;
    double c[2], from, sweep;
    if (part->kind == MUS_PIECE_LINE) return;
    if (part->kind == MUS_PIECE_ARC) {
        if (!arc_circle(p, c, &from, &sweep)) return;
        const double radius = mus__hypot(p[0] - c[0], p[1] - c[1]);
        mus__sink_print(w->sink, ", \"curvature\": {\"type\": \"circle\", \"params\": [");
        mus__sink_number(w->sink, 100.0 * radius);
        mus__sink_print(w->sink, ", %d, %d]}", fabs(sweep) > 180.0 * MUS__DEGREE, sweep > 0.0);
        return;
    }
    mus__sink_print(w->sink, ", \"curvature\": {\"type\": \"%s\", \"params\": [", n == 1 ? "quadratic" : "cubic");
    for (int32_t i = 1; i <= n; i++) {
        const double dx = p[2 * i] - p[0], dy = p[2 * i + 1] - p[1];
        if (i > 1) mus__sink_print(w->sink, ", ");
        put_pair(w, (dx * ex + dy * ey) / ee, (dy * ex - dx * ey) / ee);
    }
    mus__sink_print(w->sink, "]}");
}


/* where the panel is: the matrix as turns about x, then y, then z of the panel [degrees], the origin [cm] */
static void put_place(const gcw_writer *w, int32_t panel)
{
    mus_placement at;
    mus_placement_init(&at, sizeof at);
    mus_pattern_placement(w->pattern, panel, &at);
    const double *r = at.rotation;
    double angles[3] = {0.0, mus__asin(r[2] < -1.0 ? -1.0 : r[2] > 1.0 ? 1.0 : r[2]), 0.0};
    if (fabs(r[2]) < 1.0 - 1e-12) {
        angles[0] = mus__atan2(-r[5], r[8]);
        angles[2] = mus__atan2(-r[1], r[0]);
    } else {
        angles[0] = mus__atan2(r[7], r[4]);
    }
    mus__sink_print(w->sink, "\"translation\": [");
    for (int32_t i = 0; i < 3; i++) {
        if (i > 0) mus__sink_print(w->sink, ", ");
        mus__sink_number(w->sink, 100.0 * at.origin[i]);
    }
    mus__sink_print(w->sink, "], \"rotation\": [");
    for (int32_t i = 0; i < 3; i++) {
        if (i > 0) mus__sink_print(w->sink, ", ");
        mus__sink_number(w->sink, angles[i] / MUS__DEGREE);
    }
    mus__sink_print(w->sink, "]");
}


/* edges and vertices of the panel at hand; the label of each part is that of its edge */
static void put_loop(const gcw_writer *w, int32_t n, const int32_t *edges)
{
    mus__sink_print(w->sink, ",\n   \"vertices\": [");
    for (int32_t i = 0; i < w->npart; i++) {
        if (i > 0) mus__sink_print(w->sink, ", ");
        put_pair(w, 100.0 * w->parts[i].p[0], 100.0 * w->parts[i].p[1]);
    }
    mus__sink_print(w->sink, "],\n   \"edges\": [");
    for (int32_t i = 0, k = 0; i < w->npart; i++) {
        while (k + 1 < n && w->first[edges[k]] + w->count[edges[k]] <= i) k++;
        const char *label = mus_pattern_edge_label(w->pattern, edges[k]);
        mus__sink_print(w->sink, "%s\n    {\"endpoints\": [%d, %d]", i > 0 ? "," : "", (int)i,
                        (int)((i + 1) % w->npart));
        put_curvature(w, &w->parts[i]);
        if (label[0] != '\0') {
            mus__sink_print(w->sink, ", \"label\": ");
            mus__sink_quote(w->sink, label);
        }
        mus__sink_print(w->sink, "}");
    }
    mus__sink_print(w->sink, "]}");
}


static mus_status put_panel(gcw_writer *w, int32_t panel)
{
    int32_t n = 0;
    mus_status status = mus_pattern_rim(w->pattern, panel, NULL, NULL, 0, &n);
    if (status != MUS_OK || n == 0) return status;
    int32_t *edges = mus_context_alloc(w->source.context, NULL, 2 * (size_t)n * sizeof *edges);
    if (edges == NULL) return mus__source_fail(&w->source, 0, MUS_ERR_MEMORY, "no memory for %d edges", n);
    status = mus_pattern_rim(w->pattern, panel, edges, edges + n, n, &n);
    w->npart = 0;
    for (int32_t i = 0; i < n && status == MUS_OK; i++) status = edge_parts(w, edges[i], edges[n + i]);
    for (int32_t i = 0; i < w->npart && status == MUS_OK; i++) {
        const double *a = w->parts[i].p, *b = w->parts[(i + 1) % w->npart].p;
        if (w->npart < 2 || mus__hypot(b[0] - a[0], b[1] - a[1]) < GCW_ROUND)
            status = mus__source_fail(&w->source, 0, MUS_ERR_UNSUPPORTED,
                                      "panel %.60s: an edge ends where it starts; GarmentCode has no such edge",
                                      mus_pattern_panel_name(w->pattern, panel));
    }
    if (status == MUS_OK) {
        const char *label = mus_pattern_panel_label(w->pattern, panel);
        mus__sink_print(w->sink, panel > 0 ? ",\n  " : "\n  ");
        mus__sink_quote(w->sink, mus_pattern_panel_name(w->pattern, panel));
        mus__sink_print(w->sink, ": {");
        if (label[0] != '\0') {
            mus__sink_print(w->sink, "\"label\": ");
            mus__sink_quote(w->sink, label);
            mus__sink_print(w->sink, ", ");
        }
        put_place(w, panel);
        put_loop(w, n, edges);
    }
    mus_context_alloc(w->source.context, edges, 0);
    return status;
}


/* number in its panel of part k of an edge, k counted along the edge */
static int32_t part_number(const gcw_writer *w, int32_t edge, int32_t k)
{
    return w->first[edge] + (w->direction[edge] > 0 ? k : w->count[edge] - 1 - k);
}


/* a stitch for each pair of parts. As written, an edge runs with the outline */
static void put_stitches(const gcw_writer *w)
{
    bool any = false;
    mus__sink_print(w->sink, "},\n  \"stitches\": [");
    for (int32_t i = 0; i < mus_pattern_seam_count(w->pattern); i++) {
        mus_seam_def seam, own;
        mus_seam_def_init(&seam, sizeof seam);
        if (mus_pattern_seam(w->pattern, i, &seam) != MUS_OK) continue;
        const int32_t a = seam.edge_a, b = seam.edge_b, n = w->count[a];
        if (edge_stitch(w->pattern, a, &own) != i || w->first[a] == MUS_NONE || w->count[b] != n) continue;
        const bool reversed = seam.direction == MUS_SEAM_REVERSED;
        const bool direct = reversed != (w->direction[a] == w->direction[b]);
        for (int32_t k = 0; k < n; k++) {
            const int32_t parts[2] = {part_number(w, a, k), part_number(w, b, reversed ? n - 1 - k : k)};
            mus__sink_print(w->sink, "%s\n   [", any ? "," : "");
            for (int32_t side = 0; side < 2; side++) {
                const int32_t panel = mus_pattern_edge_panel(w->pattern, side == 0 ? a : b);
                mus__sink_print(w->sink, "%s{\"panel\": ", side > 0 ? ", " : "");
                mus__sink_quote(w->sink, mus_pattern_panel_name(w->pattern, panel));
                mus__sink_print(w->sink, ", \"edge\": %d}", (int)parts[side]);
            }
            mus__sink_print(w->sink, direct ? ", \"right_wrong\"]" : "]");
            any = true;
        }
    }
    mus__sink_print(w->sink, "]");
}


static mus_status gcw_document(gcw_writer *w)
{
    const int32_t n = mus_pattern_edge_count(w->pattern), npanel = mus_pattern_panel_count(w->pattern);
    mus_context *context = w->source.context;
    w->first = mus_context_alloc(context, NULL, (size_t)(n + 1) * sizeof *w->first);
    w->count = mus_context_alloc(context, NULL, (size_t)(n + 1) * sizeof *w->count);
    w->direction = mus_context_alloc(context, NULL, (size_t)(n + 1) * sizeof *w->direction);
    if (w->first == NULL || w->count == NULL || w->direction == NULL)
        return mus__source_fail(&w->source, 0, MUS_ERR_MEMORY, "no memory for %d edges", n);
    for (int32_t i = 0; i < n; i++) w->first[i] = MUS_NONE;
    mus__sink_print(w->sink, "{\"pattern\": {\n \"panels\": {");
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < npanel && status == MUS_OK; i++) status = put_panel(w, i);
    if (status != MUS_OK) return status;
    put_stitches(w);
    mus__sink_print(w->sink, ",\n  \"panel_order\": [");
    for (int32_t i = 0; i < npanel; i++) {
        if (i > 0) mus__sink_print(w->sink, ", ");
        mus__sink_quote(w->sink, mus_pattern_panel_name(w->pattern, i));
    }
    mus__sink_print(w->sink, "]},\n \"parameters\": {}, \"parameter_order\": [],\n \"properties\": "
                             "{\"curvature_coords\": \"relative\", \"normalize_panel_translation\": false, "
                             "\"normalized_edge_loops\": true, \"units_in_meter\": 100}}\n");
    return w->sink->status;
}


static mus_status gcw_write(const mus_pattern *pattern, const mus__target *target, const char *what)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    mus__locale locale;
    mus__sink sink;
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK) status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;
    mus__sink_init(&sink, context);
    gcw_writer w = {.sink = &sink, .pattern = pattern};
    w.source = (mus__source){.context = context, .name = mus_pattern_name(pattern)};
    status = gcw_document(&w);
    if (status == MUS_OK) status = mus__sink_give(&sink, target);
    mus_context_alloc(context, w.first, 0);
    mus_context_alloc(context, w.count, 0);
    mus_context_alloc(context, w.direction, 0);
    mus_context_alloc(context, w.breaks, 0);
    mus_context_alloc(context, w.parts, 0);
    mus__sink_free(&sink);
    mus__locale_leave(&locale);
    return status;
}


mus_status mus_pattern_write_garmentcode(const mus_pattern *pattern, const char *path)
{
    return gcw_write(pattern, &(mus__target){path, NULL, NULL}, "mus_pattern_write_garmentcode");
}


mus_status mus_pattern_write_garmentcode_bytes(const mus_pattern *pattern, char **bytes, size_t *size)
{
    return gcw_write(pattern, &(mus__target){NULL, bytes, size}, "mus_pattern_write_garmentcode_bytes");
}
