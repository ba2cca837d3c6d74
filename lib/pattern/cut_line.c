/*
 * cut_line.c: the line that is cut on the table: the outline of a panel with its darts folded shut and its hems turned
 * up, moved out by the allowance of each edge.
 *
 * The outline is read as a ring of straight sides, within 0.01 mm of its curves. Two neighbouring edges that are sewn
 * to each other are the legs of a dart; the ring runs straight across its mouth, which cut_darts.c then caps. Pairs may
 * be nested: legs of several edges, and a dart inside the panel (a fish-eye) at the end of a bridge, which vanishes
 * with the bridge, so that nothing is cut there. Legs with an allowance of their own are a seam: they are cut open.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "pattern/cut_ring.h"
#include "pattern/polygon_offset.h"

#define CUT_CHORD 1e-5      /* [m] largest distance of a chord from its curve; chosen: far below the width of a line */
#define CUT_CHORDS_MAX 4096 /* most chords of one curve; chosen: bounds the memory */
#define CUT_ALLOWANCE_MOST 0.2 /* [m] widest default allowance; chosen: wider is a slip of unit */

struct mus_cut_line {
    mus_context *context;
    mus__cut_loops loops; /* in the plane of the panel [m] */
    int32_t ndart;
    mus__cut_dart *darts; /* (ndart) */
};

/* the outline that is read */
typedef struct rim_read {
    const mus_pattern *pattern;
    const mus__panel *panel;
    double allowance;
    int32_t n;              /* edges of the rim */
    int32_t *edge, *turn;   /* (n) */
    int32_t *mate;          /* (n) the position of the edge that it is closed with, or MUS_NONE */
    int32_t *stack;         /* (n) */
    mus_cut_line *line;
} rim_read;


/* ---- the legs of darts ---- */

static void rim_end(const rim_read *read, int32_t i, bool last, double *out)
{
    const mus__edge *edge = &read->pattern->edge[read->edge[i]];
    memcpy(out, read->pattern->point[(read->turn[i] > 0) == last ? edge->end : edge->start].xy, 2 * sizeof *out);
}


/* are the edges at positions i and j, which follow each other, closed: one edge there and back, or legs of a dart? */
static bool rim_closes(const rim_read *read, int32_t i, int32_t j)
{
    const mus_pattern *pattern = read->pattern;
    if (read->edge[i] == read->edge[j]) return read->turn[i] != read->turn[j];
    const mus__edge *a = &pattern->edge[read->edge[i]], *b = &pattern->edge[read->edge[j]];
    if (a->nseam != 1 || b->nseam != 1 || a->seam != b->seam) return false;
    const mus_seam_def *seam = &pattern->seam[a->seam];
    const bool reversed = seam->direction == MUS_SEAM_REVERSED;
    if (seam->laid || seam->closure != MUS_CLOSURE_NONE || reversed != (read->turn[i] == read->turn[j])) return false;
    return !(a->attr.allowance > 0.0) && !(b->attr.allowance > 0.0);
}


/* pair the edges that close, from the inside out. Pairs never run over the start of the word: the word is turned first
 * so that it begins with an edge that is left; false when none is left */
static bool rim_pair(rim_read *read)
{
    for (int32_t round = 0; round < 2; round++) {
        int32_t top = 0, low = 0;
        for (int32_t i = 0; i < read->n; i++) {
            read->mate[i] = MUS_NONE;
            if (top > 0 && rim_closes(read, read->stack[top - 1], i)) {
                read->mate[i] = read->stack[--top];
                read->mate[read->mate[i]] = i;
            } else {
                read->stack[top++] = i;
            }
        }
        while (top - low >= 2 && rim_closes(read, read->stack[top - 1], read->stack[low])) low++, top--;
        if (top - low < 1) return false;
        const int32_t first = read->stack[low];
        if (round > 0 || first == 0) return true;
        for (int32_t pass = 0; pass < 2; pass++) {
            int32_t *list = pass == 0 ? read->edge : read->turn;
            memcpy(read->stack, list, (size_t)read->n * sizeof *list);
            for (int32_t i = 0; i < read->n; i++) list[i] = read->stack[(first + i) % read->n];
        }
    }
    return true;
}


/* the sides of the body that the ends of a mouth are on: true when its second end is the one that a dart is pressed
 * to: down where the mouth runs up and down, else to the middle of the body */
static bool dart_presses_second(const rim_read *read, const double (*mouth)[2])
{
    const mus_placement *at = &read->panel->attr.placement;
    double end[2][3];
    for (int32_t i = 0; i < 2; i++) {
        const double u = mouth[i][0], angle = at->bend != 0.0 ? (u - at->bend_x) / at->bend : 0.0;
        const double p[3] = {at->bend != 0.0 ? at->bend_x + at->bend * mus__sin(angle) : u, mouth[i][1],
                             at->bend != 0.0 ? at->bend * (mus__cos(angle) - 1.0) : 0.0};
        for (int32_t r = 0; r < 3; r++)
            end[i][r] = at->origin[r] + at->rotation[3 * r] * p[0] + at->rotation[3 * r + 1] * p[1] +
                        at->rotation[3 * r + 2] * p[2];
    }
    const double x = end[1][0] - end[0][0], y = end[1][1] - end[0][1], z = end[1][2] - end[0][2];
    if (y * y > x * x + z * z) return y < 0.0;
    return fabs(end[1][0]) < fabs(end[0][0]) - MUS__CUT_SAME;
}


/* read the dart between positions `first` and `last`; false when its mouth is closed or at least a right angle wide */
static bool dart_from_rim(const rim_read *read, int32_t first, int32_t last, mus__cut_dart *dart)
{
    memset(dart, 0, sizeof *dart);
    int32_t inner = first;
    while (inner + 1 < read->mate[inner] && read->mate[inner + 1] == read->mate[inner] - 1 &&
           read->edge[inner + 1] != read->edge[read->mate[inner + 1]])
        inner++;
    dart->first = first, dart->last = last;
    rim_end(read, first, false, dart->mouth[0]);
    rim_end(read, last, true, dart->mouth[1]);
    rim_end(read, inner, true, dart->point);
    double u[2], v[2];
    for (int32_t d = 0; d < 2; d++) {
        u[d] = dart->mouth[0][d] - dart->point[d];
        v[d] = dart->mouth[1][d] - dart->point[d];
    }
    dart->onto_second = dart_presses_second(read, (const double (*)[2])dart->mouth);
    return fabs(u[0] - v[0]) + fabs(u[1] - v[1]) > MUS__CUT_SAME && u[0] * v[0] + u[1] * v[1] > 0.0;
}


/* ---- the ring ---- */

/* number of chords that keep within CUT_CHORD of a curve. A chord of a Bezier is off by at most an eighth of the second
 * derivative over the square of their number, one of an arc by an eighth of its length times its angle */
static int32_t ring_chords(int32_t kind, const double *p)
{
    double bend = 0.0;
    for (int32_t k = 0; k < (kind == MUS_PIECE_CUBIC ? 2 : kind == MUS_PIECE_QUADRATIC ? 1 : 0); k++) {
        const double *q = p + 2 * k, x = q[0] - 2.0 * q[2] + q[4], y = q[1] - 2.0 * q[3] + q[5];
        bend = fmax(bend, (kind == MUS_PIECE_CUBIC ? 0.75 : 0.25) * sqrt(x * x + y * y));
    }
    if (kind == MUS_PIECE_ARC) {
        double u[2], v[2];
        mus__curve_tangent(kind, p, 0.0, u);
        mus__curve_tangent(kind, p, 0.25, v);
        const double angle = 4.0 * fabs(mus__atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
        bend = 0.125 * angle * mus__curve_length(kind, p);
    }
    const double n = ceil(sqrt(bend / CUT_CHORD));
    return n < 1.0 ? 1 : n > CUT_CHORDS_MAX ? CUT_CHORDS_MAX : (int32_t)n;
}


static void ring_point(mus__cut_ring *ring, mus__cut_corner *corner, const double *xy)
{
    memcpy(corner->xy, xy, sizeof corner->xy);
    if (ring->n > 0) {
        const mus__cut_corner *last = &ring->list[ring->n - 1];
        if (fabs(last->xy[0] - xy[0]) + fabs(last->xy[1] - xy[1]) < MUS__CUT_SAME) {
            ring->list[ring->n - 1] = *corner;
            return;
        }
    }
    mus__cut_add(ring, corner);
}


/* add the chords of the edge at position i, without its end */
static void ring_edge(const rim_read *read, int32_t i, mus__cut_ring *ring)
{
    const mus__edge *edge = &read->pattern->edge[read->edge[i]];
    const double own = edge->attr.allowance;
    const bool hem = strstr(edge->attr.label, "hem") != NULL || strstr(edge->name, "hem") != NULL;
    const bool laps = edge->nseam == 1 && read->pattern->seam[edge->seam].closure == MUS_CLOSURE_BUTTONS;
    mus__cut_corner corner = {.width = own >= 0.0 ? own : read->allowance, .dart = MUS_NONE, .hem = hem, .laps = laps};
    const double *p = read->turn[i] > 0 ? edge->xy : edge->xy + 2 * (edge->nxy - 1);
    for (int32_t k = 0; k < edge->npiece; k++) {
        const int32_t piece = read->turn[i] > 0 ? k : edge->npiece - 1 - k, kind = edge->kinds[piece];
        const int32_t step = 2 * (mus__curve_points(kind) - 1);
        if (read->turn[i] < 0) p -= step;
        const int32_t n = ring_chords(kind, p);
        for (int32_t c = 0; c < n; c++) {
            double xy[2];
            mus__curve_at(kind, p, read->turn[i] > 0 ? (double)c / n : 1.0 - (double)c / n, xy);
            ring_point(ring, &corner, xy);
        }
        if (read->turn[i] > 0) p += step;
    }
}


/* the outline with a straight side across the mouth of each dart */
static void ring_read(rim_read *read, mus__cut_ring *ring)
{
    const bool paired = rim_pair(read);
    for (int32_t i = 0; i < read->n && ring->status == MUS_OK; i++) {
        const int32_t last = paired ? read->mate[i] : MUS_NONE;
        mus__cut_dart *dart = &read->line->darts[read->line->ndart];
        if (last == MUS_NONE) {
            ring_edge(read, i, ring);
        } else if (read->edge[i] == read->edge[last]) {
            i = last; /* a bridge, and all that hangs on it */
        } else if (dart_from_rim(read, i, last, dart)) {
            const int32_t before = (i + read->n - 1) % read->n;
            const double own = read->pattern->edge[read->edge[before]].attr.allowance;
            mus__cut_corner corner = {.width = own >= 0.0 ? own : read->allowance, .dart = read->line->ndart++};
            ring_point(ring, &corner, dart->mouth[0]);
            i = last;
        } else if (mus__dist2(dart->mouth[0], dart->mouth[1]) < MUS__CUT_SAME) {
            i = last; /* a slit that is sewn shut */
        } else {
            for (int32_t k = i; k <= last; k++) read->mate[k] = MUS_NONE;
            i--;
        }
    }
    while (ring->n > 1) {
        const double *a = ring->list[0].xy, *b = ring->list[ring->n - 1].xy;
        if (fabs(a[0] - b[0]) + fabs(a[1] - b[1]) >= MUS__CUT_SAME) break;
        ring->n--;
    }
}


/* mirror the ring and its darts in the y axis */
static void ring_flip(mus__cut_ring *ring, mus_cut_line *line)
{
    for (int32_t i = 0; i < ring->n; i++) ring->list[i].xy[0] = -ring->list[i].xy[0];
    for (int32_t i = 0; i < line->ndart; i++) {
        mus__cut_dart *dart = &line->darts[i];
        dart->mouth[0][0] = -dart->mouth[0][0], dart->mouth[1][0] = -dart->mouth[1][0];
        dart->point[0] = -dart->point[0], dart->peak[0] = -dart->peak[0];
    }
}


static double ring_area(const mus__cut_ring *ring)
{
    double area = 0.0;
    for (int32_t i = 0; i < ring->n; i++) {
        const double *o = ring->list[0].xy, *a = ring->list[i].xy, *b = ring->list[(i + 1) % ring->n].xy;
        area += 0.5 * ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]));
    }
    return area;
}


/* move the ring out by its allowances: the loops of the line */
static mus_status ring_offset(const mus__cut_ring *ring, mus__cut_loops *out)
{
    mus_context *context = ring->context;
    double *xy = mus__new(context, ring->n, 2 * sizeof *xy), *width = mus__new(context, ring->n, sizeof *width);
    unsigned char *given = mus__new(context, ring->n, 1);
    mus_status status = MUS_OK;
    if (xy == NULL || width == NULL || given == NULL) status = mus__fail_memory(context, "the cut line of a panel");
    for (int32_t i = 0; i < ring->n && status == MUS_OK; i++) {
        memcpy(xy + 2 * i, ring->list[i].xy, 2 * sizeof *xy);
        width[i] = ring->list[i].width;
        given[i] = ring->list[i].given;
    }
    if (status == MUS_OK) status = mus__offset(context, ring->n, xy, width, given, out);
    mus__free(context, xy);
    mus__free(context, width);
    mus__free(context, given);
    return status;
}


static mus_status line_build(rim_read *read)
{
    mus_context *context = read->pattern->context;
    mus__cut_ring open = {.context = context}, turned = open, ended = open, shut = open;
    ring_read(read, &open);
    const bool flip = open.status == MUS_OK && ring_area(&open) < 0.0;
    if (flip) ring_flip(&open, read->line);
    mus_status status = open.status;
    if (status == MUS_OK && open.n < 3)
        status = mus__fail(context, MUS_ERR_PATTERN, "panel %s has no area to cut", read->panel->name);
    if (status == MUS_OK) mus__cut_turn_hems(&open, &turned), status = turned.status;
    if (status == MUS_OK) mus__cut_end_laps(&turned, &ended), status = ended.status;
    if (status == MUS_OK) mus__cut_fold_darts(&ended, read->line->darts, &shut), status = shut.status;
    if (status == MUS_OK) status = ring_offset(&shut, &read->line->loops);
    if (status == MUS_OK && flip) {
        ring_flip(&(mus__cut_ring){.n = 0}, read->line);
        for (int32_t i = 0; i < read->line->loops.n; i++) read->line->loops.xy[2 * i] = -read->line->loops.xy[2 * i];
    }
    mus__free(context, open.list);
    mus__free(context, shut.list);
    mus__free(context, turned.list);
    mus__free(context, ended.list);
    return status;
}


mus_status mus_pattern_cut_line(const mus_pattern *pattern, int32_t panel, double allowance, mus_cut_line **out)
{
    if (out != NULL) *out = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (out == NULL) return mus__fail(context, MUS_ERR_ARG, "mus_pattern_cut_line: out is NULL");
    if (!(allowance >= 0.0 && allowance <= CUT_ALLOWANCE_MOST))
        return mus__fail(context, MUS_ERR_ARG, "cut line: an allowance of %g m is outside 0 to %g m", allowance,
                         CUT_ALLOWANCE_MOST);
    int32_t n = 0;
    mus_status status = mus_pattern_rim(pattern, panel, NULL, NULL, 0, &n);
    if (status != MUS_OK) return status;

    rim_read read = {.pattern = pattern, .panel = &pattern->panel[panel], .allowance = allowance, .n = n};
    int32_t *block = mus__new(context, 4 * (int64_t)n, sizeof *block);
    read.line = mus__new(context, 1, sizeof *read.line);
    mus__cut_dart *darts = mus__new(context, (int64_t)n + 1, sizeof *darts);
    if (block == NULL || read.line == NULL || darts == NULL) {
        mus__free(context, block);
        mus__free(context, darts);
        mus__free(context, read.line);
        return mus__fail_memory(context, "the cut line of a panel");
    }
    read.line->context = context;
    read.line->darts = darts;
    read.edge = block, read.turn = block + n, read.mate = block + 2 * n, read.stack = block + 3 * n;
    status = mus_pattern_rim(pattern, panel, read.edge, read.turn, n, &n);
    if (status == MUS_OK) status = line_build(&read);
    mus__free(context, block);
    if (status == MUS_OK) *out = read.line;
    else mus_cut_line_destroy(read.line);
    return status;
}


void mus_cut_line_destroy(mus_cut_line *line)
{
    if (line == NULL) return;
    mus__cut_loops_free(line->context, &line->loops);
    mus__free(line->context, line->darts);
    mus__free(line->context, line);
}


int32_t mus_cut_line_loop_count(const mus_cut_line *line)
{
    return line != NULL ? line->loops.nloop : 0;
}


mus_status mus_cut_line_loop(const mus_cut_line *line, int32_t loop, int32_t *n, const double **xy)
{
    if (n != NULL) *n = 0;
    if (xy != NULL) *xy = NULL;
    if (line == NULL) return MUS_ERR_ARG;
    if (loop < 0 || loop >= line->loops.nloop)
        return mus__fail(line->context, MUS_ERR_ARG, "cut line: loop %d is unknown, it has %d", (int)loop,
                         (int)line->loops.nloop);
    const int32_t start = line->loops.start[loop];
    if (n != NULL) *n = line->loops.start[loop + 1] - start;
    if (xy != NULL) *xy = line->loops.xy + 2 * (size_t)start;
    return MUS_OK;
}


int32_t mus_cut_line_dart_count(const mus_cut_line *line)
{
    return line != NULL ? line->ndart : 0;
}


mus_status mus_cut_line_dart(const mus_cut_line *line, int32_t dart, double *out)
{
    if (line == NULL) return MUS_ERR_ARG;
    if (out == NULL || dart < 0 || dart >= line->ndart)
        return mus__fail(line->context, MUS_ERR_ARG, "cut line: out is NULL, or dart %d is unknown: it has %d",
                         (int)dart, (int)line->ndart);
    const mus__cut_dart *own = &line->darts[dart];
    memcpy(out, own->mouth[0], 2 * sizeof *out);
    memcpy(out + 2, own->point, 2 * sizeof *out);
    memcpy(out + 4, own->mouth[1], 2 * sizeof *out);
    memcpy(out + 6, own->peak, 2 * sizeof *out);
    return MUS_OK;
}
