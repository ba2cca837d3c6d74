/*
 * piece_outline.c: a panel of the pattern as a piece of paper, turned so that the grain runs up and the right side of
 * the cloth lies up. Its sew line consists of lines and cubics, its cut line of polygons.
 *
 * Lines and cubics are kept, a quadratic is raised to the cubic that equals it, an arc becomes cubics of at most 22.5
 * degrees (error 7e-8 of the radius). Only the cut line and the silhouettes use chords, within 0.01 mm of the curve.
 *
 * A panel whose outline runs clockwise in its plane shows its wrong side there; it is mirrored, so that all pieces lie
 * right side up and all outlines run counter-clockwise.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/elementary.h"
#include "drawing/phrase.h"
#include "print/piece.h"

/* [m] largest distance of a chord from its cubic; chosen: far below the width of a line */
#define STRAIGHT 0.268 /* tangent of 15 degrees, the largest turn where an outline goes straight on; by eye */
#define CHORD_TOLERANCE 1e-5
#define ARC_STEP (MUS__PRINT_PI / 8.0) /* [rad] longest arc of one cubic; error 2/27 (step/4)^6 of the radius */
#define CHORDS_MAX 4096                      /* most chords of one cubic; chosen: bounds the memory */


void mus__cubic_at(const double *p, double t, double *out)
{
    double s = 1.0 - t, a = s * s * s, b = 3.0 * s * s * t, c = 3.0 * s * t * t, d = t * t * t;
    for (int32_t k = 0; k < 2; k++) out[k] = a * p[k] + b * p[2 + k] + c * p[4 + k] + d * p[6 + k];
}


/* the error of n equal chords is at most 3/4 of the larger second difference, over n^2 */
int32_t mus__cubic_chords(const double *p, double tolerance)
{
    double ax = p[0] - 2.0 * p[2] + p[4], ay = p[1] - 2.0 * p[3] + p[5];
    double bx = p[2] - 2.0 * p[4] + p[6], by = p[3] - 2.0 * p[5] + p[7];
    double a = ax * ax + ay * ay, b = bx * bx + by * by;
    double n = ceil(sqrt(0.75 * sqrt(a > b ? a : b) / tolerance));
    return n < 1.0 ? 1 : n > CHORDS_MAX ? CHORDS_MAX : (int32_t)n;
}


void mus__piece_point(const mus__piece *piece, const double *xy, double *out)
{
    double x = xy[0], y = xy[1];
    out[0] = piece->turn[0] * x + piece->turn[1] * y + piece->shift[0];
    out[1] = piece->turn[2] * x + piece->turn[3] * y + piece->shift[1];
}


void mus__piece_free(mus_context *context, mus__piece *piece)
{
    mus__print_free(context, piece->sides);
    mus__print_free(context, piece->spans);
    mus__print_free(context, piece->flat);
    mus__print_free(context, piece->flat_side);
    mus__print_free(context, piece->cut.start);
    mus__print_free(context, piece->cut.xy);
    mus__print_free(context, piece->darts);
    memset(piece, 0, sizeof *piece);
}


void mus__piece_move(mus__piece *piece, double x, double y)
{
    const double by[2] = {x, y};
    piece->axis += by[piece->across];
    for (int32_t k = 0; k < 2; k++) {
        piece->shift[k] += by[k];
        piece->box[k] += by[k];
        piece->box[2 + k] += by[k];
        for (int32_t i = 0; i < piece->nspan; i++)
            for (int32_t j = 0; j < 4; j++) piece->spans[i].p[2 * j + k] += by[k];
        for (int32_t i = 0; i < piece->nflat; i++) piece->flat[2 * i + k] += by[k];
        for (int32_t i = 0; i < piece->cut.n; i++) piece->cut.xy[2 * i + k] += by[k];
        for (int32_t i = 0; i < 4 * piece->ndart; i++) piece->darts[2 * i + k] += by[k];
    }
}


/* reverse n points, in place */
static void piece_reverse(int32_t n, double *xy)
{
    for (int32_t i = 0, k = n - 1; i < k; i++, k--) {
        double held[2];
        memcpy(held, xy + 2 * i, sizeof held);
        memcpy(xy + 2 * i, xy + 2 * k, sizeof held);
        memcpy(xy + 2 * k, held, sizeof held);
    }
}


/* let all lines run the other way */
static void piece_turn_round(mus__piece *piece)
{
    for (int32_t i = 0, k = piece->nspan - 1; i < k; i++, k--) {
        const mus__span held = piece->spans[i];
        piece->spans[i] = piece->spans[k];
        piece->spans[k] = held;
    }
    for (int32_t i = 0; i < piece->nspan; i++) piece_reverse(4, piece->spans[i].p);
    for (int32_t i = 0; i < piece->nside; i++) piece->sides[i].direction *= -1;
    for (int32_t l = 0; l < piece->cut.nloop; l++)
        piece_reverse(piece->cut.start[l + 1] - piece->cut.start[l], piece->cut.xy + 2 * piece->cut.start[l]);
    /* point i is the old point n - 1 - i, so the chord from it is the old chord n - 2 - i */
    piece_reverse(piece->nflat, piece->flat);
    for (int32_t i = 0, k = piece->nflat - 2; i < k; i++, k--) {
        const int32_t held = piece->flat_side[i];
        piece->flat_side[i] = piece->flat_side[k];
        piece->flat_side[k] = held;
    }
}


void mus__piece_flip(mus__piece *piece, bool x, bool y)
{
    const double sign[2] = {x ? -1.0 : 1.0, y ? -1.0 : 1.0}, old[4] = {piece->box[0], piece->box[1], piece->box[2],
                                                                     piece->box[3]};
    for (int32_t k = 0; k < 2; k++) {
        for (int32_t i = 0; i < 4 * piece->nspan; i++) piece->spans[i / 4].p[2 * (i % 4) + k] *= sign[k];
        for (int32_t i = 0; i < piece->nflat; i++) piece->flat[2 * i + k] *= sign[k];
        for (int32_t i = 0; i < piece->cut.n; i++) piece->cut.xy[2 * i + k] *= sign[k];
        for (int32_t i = 0; i < 4 * piece->ndart; i++) piece->darts[2 * i + k] *= sign[k];
        for (int32_t i = 0; i < 2; i++) piece->turn[2 * k + i] *= sign[k];
        piece->shift[k] *= sign[k];
        piece->box[k] = sign[k] < 0.0 ? -old[2 + k] : old[k];
        piece->box[2 + k] = sign[k] < 0.0 ? -old[k] : old[2 + k];
    }
    piece->axis *= sign[piece->across];
    piece->inward *= sign[piece->across];
    if (x != y) piece_turn_round(piece);
}


double mus__piece_inward(const mus__piece *piece, const double *p)
{
    return piece->inward * (p[piece->across] - piece->axis);
}


bool mus__piece_straight(const mus__piece *piece, int32_t i)
{
    const double *a = piece->flat + 2 * (i % piece->nflat), *b = piece->flat + 2 * ((i + 1) % piece->nflat);
    const double *c = piece->flat + 2 * ((i + 2) % piece->nflat);
    const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];
    const double along = ux * vx + uy * vy;
    return along > 0.0 && fabs(ux * vy - uy * vx) < STRAIGHT * along;
}


void mus__box_quarter(const double *box, double *out)
{
    const double turned[4] = {-box[3], box[0], -box[1], box[2]};
    memcpy(out, turned, sizeof turned);
}


/* turn n points (n x 2) by a quarter: (x, y) goes to (-y, x) */
static void piece_quarter(int32_t n, double *xy)
{
    for (int32_t i = 0; i < n; i++) {
        const double x = xy[2 * i];
        xy[2 * i] = -xy[2 * i + 1];
        xy[2 * i + 1] = x;
    }
}


void mus__piece_quarter(mus__piece *piece)
{
    for (int32_t i = 0; i < piece->nspan; i++) piece_quarter(4, piece->spans[i].p);
    piece_quarter(piece->nflat, piece->flat);
    piece_quarter(piece->cut.n, piece->cut.xy);
    piece_quarter(4 * piece->ndart, piece->darts);
    piece_quarter(1, piece->shift);
    const double turn[4] = {-piece->turn[2], -piece->turn[3], piece->turn[0], piece->turn[1]};
    memcpy(piece->turn, turn, sizeof turn);
    mus__box_quarter(piece->box, piece->box);
    piece->grain = 1 - piece->grain;
    if (piece->across == 1) piece->axis *= -1.0, piece->inward *= -1.0;
    piece->across = 1 - piece->across;
}


/* ---- spans from the segments of the pattern's edges, in the panel's plane ---- */

typedef struct span_list {
    mus_context *context;
    mus_status status;
    int32_t n, room;
    mus__span *list;
} span_list;


static void span_add(span_list *spans, const double *p, bool line, int32_t side)
{
    if (spans->status != MUS_OK) return;
    spans->status = mus__print_reserve(spans->context, &spans->list, &spans->room, (int64_t)spans->n + 1,
                                       sizeof *spans->list);
    if (spans->status != MUS_OK) return;
    mus__span *span = &spans->list[spans->n++];
    memcpy(span->p, p, sizeof span->p);
    span->line = line;
    span->side = side;
}


static void span_line(span_list *spans, const double *a, const double *b, int32_t side)
{
    const double p[8] = {a[0], a[1], a[0], a[1], b[0], b[1], b[0], b[1]};
    span_add(spans, p, true, side);
}


/*
 * Arc through s, m, e as cubics. Centre c of the circle with a = m - s, b = e - s:
 * c - s = (b_y |a|^2 - a_y |b|^2, a_x |b|^2 - b_x |a|^2) / (2 a x b); a x b > 0 when the arc runs counter-clockwise.
 * Cubic of an arc of angle f: handles of length 4/3 tan(f/4) r along the tangents.
 */
static void span_arc(span_list *spans, const double *s, const double *m, const double *e, int32_t side)
{
    double ax = m[0] - s[0], ay = m[1] - s[1], bx = e[0] - s[0], by = e[1] - s[1];
    double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cross = ax * by - ay * bx;
    double ux, uy;
    if (bb <= 1e-24 * aa) { /* a whole circle: m is opposite */
        ux = 0.5 * ax;
        uy = 0.5 * ay;
        cross = 1.0;
    } else if (fabs(cross) <= 1e-12 * (aa + bb)) {
        span_line(spans, s, e, side);
        return;
    } else {
        ux = 0.5 * (by * aa - ay * bb) / cross;
        uy = 0.5 * (ax * bb - bx * aa) / cross;
    }
    double cx = s[0] + ux, cy = s[1] + uy, radius = sqrt(ux * ux + uy * uy);
    double from = mus__atan2(-uy, -ux), sweep = mus__atan2(e[1] - cy, e[0] - cx) - from;
    if (cross > 0.0 && sweep <= 0.0) sweep += 2.0 * MUS__PRINT_PI;
    if (cross < 0.0 && sweep >= 0.0) sweep -= 2.0 * MUS__PRINT_PI;

    int32_t n = (int32_t)ceil(fabs(sweep) / ARC_STEP);
    double handle = 4.0 / 3.0 * mus__tan(sweep / n / 4.0), p[8] = {s[0], s[1], 0, 0, 0, 0, 0, 0};
    for (int32_t i = 0; i < n; i++) {
        double f = from + sweep * i / n, g = from + sweep * (i + 1) / n;
        double q[2] = {cx + radius * mus__cos(g), cy + radius * mus__sin(g)};
        if (i == n - 1) memcpy(q, e, sizeof q);
        p[2] = p[0] - handle * radius * mus__sin(f);
        p[3] = p[1] + handle * radius * mus__cos(f);
        p[4] = q[0] + handle * radius * mus__sin(g);
        p[5] = q[1] - handle * radius * mus__cos(g);
        memcpy(p + 6, q, sizeof q);
        span_add(spans, p, false, side);
        memcpy(p, q, sizeof q);
    }
}


/* add the spans of one edge, reversed when the outline runs against it */
static mus_status span_edge(span_list *spans, const mus_pattern *pattern, int32_t edge, int32_t direction, int32_t side)
{
    int32_t npiece, nxy, first = spans->n;
    const int32_t *kinds;
    const double *xy;
    mus_status status = mus_pattern_edge_pieces(pattern, edge, &npiece, &kinds, &nxy, &xy);
    if (status != MUS_OK) return status;

    for (int32_t i = 0; i < npiece; i++) {
        if (kinds[i] == MUS_PIECE_LINE) {
            span_line(spans, xy, xy + 2, side);
            xy += 2;
        } else if (kinds[i] == MUS_PIECE_QUADRATIC) {
            /* the same curve, one degree up: both handles two thirds of the way to the control point */
            const double *a = xy, *q = xy + 2, *b = xy + 4;
            const double p[8] = {a[0], a[1], (a[0] + 2.0 * q[0]) / 3.0, (a[1] + 2.0 * q[1]) / 3.0,
                                 (b[0] + 2.0 * q[0]) / 3.0, (b[1] + 2.0 * q[1]) / 3.0, b[0], b[1]};
            span_add(spans, p, false, side);
            xy += 4;
        } else if (kinds[i] == MUS_PIECE_CUBIC) {
            span_add(spans, xy, false, side);
            xy += 6;
        } else {
            span_arc(spans, xy, xy + 2, xy + 4, side);
            xy += 4;
        }
    }
    if (direction > 0 || spans->status != MUS_OK) return spans->status;
    for (int32_t i = first, j = spans->n - 1; i <= j; i++, j--) {
        mus__span a = spans->list[i], b = spans->list[j];
        for (int32_t k = 0; k < 4; k++) {
            memcpy(spans->list[i].p + 2 * k, b.p + 6 - 2 * k, 2 * sizeof *b.p);
            memcpy(spans->list[j].p + 2 * k, a.p + 6 - 2 * k, 2 * sizeof *a.p);
        }
        spans->list[i].line = b.line;
        spans->list[j].line = a.line;
    }
    return MUS_OK;
}


/* ---- the piece ---- */

/* compute the chords of all spans; points that coincide become one */
static mus_status piece_flatten(mus_context *context, mus__piece *piece)
{
    int32_t room = 0, room_side = 0;
    piece->nflat = 0;
    for (int32_t i = 0; i < piece->nspan; i++) {
        const mus__span *span = &piece->spans[i];
        int32_t n = span->line ? 1 : mus__cubic_chords(span->p, CHORD_TOLERANCE);
        mus_status status = mus__print_reserve(context, &piece->flat, &room, 2 * ((int64_t)piece->nflat + n),
                                               sizeof *piece->flat);
        if (status == MUS_OK)
            status = mus__print_reserve(context, &piece->flat_side, &room_side, (int64_t)piece->nflat + n,
                                        sizeof *piece->flat_side);
        if (status != MUS_OK) return status;
        for (int32_t k = 0; k < n; k++) {
            double p[2];
            mus__cubic_at(span->p, (double)k / n, p);
            const double *last = piece->flat + 2 * (piece->nflat - 1);
            if (piece->nflat > 0 && fabs(p[0] - last[0]) + fabs(p[1] - last[1]) < 1e-9) continue;
            memcpy(piece->flat + 2 * piece->nflat, p, sizeof p);
            piece->flat_side[piece->nflat++] = span->side;
        }
    }
    while (piece->nflat > 1) {
        const double *a = piece->flat, *b = piece->flat + 2 * (piece->nflat - 1);
        if (fabs(a[0] - b[0]) + fabs(a[1] - b[1]) >= 1e-9) break;
        piece->nflat--;
    }
    return MUS_OK;
}


/* signed area of the polygon of chords [m2] */
static double piece_area(const mus__piece *piece)
{
    double area = 0.0;
    const double *o = piece->flat;
    for (int32_t i = 1; i + 1 < piece->nflat; i++) {
        const double *a = o + 2 * i, *b = o + 2 * i + 2;
        area += 0.5 * ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]));
    }
    return area;
}


/* turn the grain up, and mirror a piece whose outline runs clockwise; spans and chords follow */
static mus_status piece_turn(const mus_pattern *pattern, mus__piece *piece)
{
    double grain[2];
    mus_status status = mus_pattern_grain(pattern, piece->panel, grain);
    if (status != MUS_OK) return status;
    double flip = piece_area(piece) < 0.0 ? -1.0 : 1.0, length = sqrt(grain[0] * grain[0] + grain[1] * grain[1]);
    double gx = flip * grain[0] / length, gy = grain[1] / length;
    const double turn[4] = {gy * flip, -gx, gx * flip, gy};
    memcpy(piece->turn, turn, sizeof turn);

    for (int32_t i = 0; i < piece->nspan; i++)
        for (int32_t k = 0; k < 4; k++) mus__piece_point(piece, piece->spans[i].p + 2 * k, piece->spans[i].p + 2 * k);
    for (int32_t i = 0; i < piece->nflat; i++) mus__piece_point(piece, piece->flat + 2 * i, piece->flat + 2 * i);
    return MUS_OK;
}


/* copy the loops and darts of a cut line to the sheet */
static mus_status piece_take_cut(mus_context *context, const mus_cut_line *line, mus__piece *piece)
{
    mus__loops *cut = &piece->cut;
    const int32_t nloop = mus_cut_line_loop_count(line);
    int32_t n = 0, count;
    const double *xy;
    for (int32_t i = 0; i < nloop; i++)
        if (mus_cut_line_loop(line, i, &count, NULL) == MUS_OK) n += count;
    piece->ndart = mus_cut_line_dart_count(line);
    cut->start = mus__print_new(context, (int64_t)nloop + 1, sizeof *cut->start);
    cut->xy = mus__print_new(context, n, 2 * sizeof *cut->xy);
    piece->darts = mus__print_new(context, (int64_t)piece->ndart + 1, 8 * sizeof *piece->darts);
    if (cut->start == NULL || cut->xy == NULL || piece->darts == NULL) return mus__print_memory(context, "a cut line");

    for (int32_t i = 0; i < nloop; i++) {
        mus_cut_line_loop(line, i, &count, &xy);
        for (int32_t k = 0; k < count; k++)
            mus__piece_point(piece, xy + 2 * k, cut->xy + 2 * cut->n++);
        cut->start[++cut->nloop] = cut->n;
    }
    for (int32_t i = 0; i < piece->ndart; i++) {
        double *dart = piece->darts + 8 * i;
        mus_cut_line_dart(line, i, dart);
        for (int32_t k = 0; k < 4; k++) mus__piece_point(piece, dart + 2 * k, dart + 2 * k);
    }
    return MUS_OK;
}


static mus_status piece_cut(mus_context *context, const mus_pattern *pattern, double allowance, mus__piece *piece)
{
    mus_cut_line *line;
    mus_status status = mus_pattern_cut_line(pattern, piece->panel, allowance, &line);
    if (status != MUS_OK) return mus__file_fail(context, status, "%s", mus_context_error(mus_pattern_context(pattern)));
    status = piece_take_cut(context, line, piece);
    mus_cut_line_destroy(line);
    return status;
}


static mus_status piece_read_copies(const mus_pattern *pattern, mus__piece *piece)
{
    mus_status status = MUS_OK;
    int32_t mirrored = 0;
    for (int32_t i = 0; i < MUS_MATERIAL_COUNT && status == MUS_OK; i++)
        status = mus_pattern_material(pattern, piece->panel, i, &piece->copies[i], &mirrored);
    piece->mirrored = mirrored != 0;
    return status;
}


/* compute the box of the cut line, and move its low corner to the origin */
void mus__piece_box(mus__piece *piece)
{
    for (int32_t i = 0; i < piece->cut.n; i++) {
        for (int32_t k = 0; k < 2; k++) {
            double x = piece->cut.xy[2 * i + k];
            if (i == 0 || x < piece->box[k]) piece->box[k] = x;
            if (i == 0 || x > piece->box[2 + k]) piece->box[2 + k] = x;
        }
    }
    mus__piece_move(piece, -piece->box[0], -piece->box[1]);
}


int32_t mus__piece_copies(const mus__piece *piece)
{
    int32_t first = 0;
    while (first < MUS_MATERIAL_COUNT - 1 && piece->copies[first] == 0) first++;
    return piece->copies[first];
}


void mus__piece_cut_text(const mus__piece *piece, int32_t language, char *out, size_t size)
{
    char counts[192] = "", material[48];
    size_t at = 0;
    mus__phrase phrase = mus__phrase_in(language);
    for (int32_t i = 0; i < MUS_MATERIAL_COUNT && at + 8 < sizeof counts; i++) {
        if (piece->copies[i] == 0) continue;
        if (at > 0) at += (size_t)snprintf(counts + at, sizeof counts - at, " + ");
        snprintf(material, sizeof material, "material.%s", mus_material_name(i));
        mus__phrase_number(&phrase, 0, piece->copies[i]);
        mus__phrase_text(&phrase, 1, mus_language_text(language, material));
        mus__phrase_write(&phrase, i > 0 ? "count.other" : "count.main", counts + at, sizeof counts - at);
        at += strlen(counts + at);
    }
    mus__phrase_number(&phrase, 0, 0);
    if (at > 0) mus__phrase_text(&phrase, 0, counts);
    mus__phrase_write(&phrase, piece->fold ? "cut.fold" : piece->mirrored ? "cut.mirrored" : "cut.plain", out, size);
}


mus_status mus__piece_make(mus_context *context, const mus_pattern *pattern, int32_t panel, double allowance,
                           mus__piece *piece)
{
    int32_t n = 0, *edges = NULL, *directions;
    span_list spans = {.context = context};
    piece->panel = panel;
    piece->grain = 1;
    piece->inward = 1.0;
    mus_status status = mus_pattern_outline(pattern, panel, &n, NULL, NULL);
    if (status == MUS_OK) {
        piece->sides = mus__print_new(context, n, sizeof *piece->sides);
        edges = mus__print_new(context, 2 * (int64_t)n, sizeof *edges);
        if (piece->sides == NULL || edges == NULL) status = mus__print_memory(context, "the sides of a piece");
    }
    directions = edges != NULL ? edges + n : NULL;
    if (status == MUS_OK) status = mus_pattern_rim(pattern, panel, edges, directions, n, &piece->nside);
    for (int32_t i = 0; i < piece->nside && status == MUS_OK; i++) {
        double own = mus_pattern_edge_allowance(pattern, edges[i]);
        piece->sides[i] = (mus__side){edges[i], directions[i], own >= 0.0 ? own : allowance};
        status = span_edge(&spans, pattern, edges[i], directions[i], i);
    }
    mus__print_free(context, edges);
    piece->spans = spans.list;
    piece->nspan = spans.n;
    if (status == MUS_OK) status = piece_flatten(context, piece);
    if (status == MUS_OK) status = piece_turn(pattern, piece);
    if (status == MUS_OK) status = piece_cut(context, pattern, allowance, piece);
    if (status == MUS_OK) status = piece_read_copies(pattern, piece);
    if (status == MUS_OK) mus__piece_box(piece);
    return status;
}
