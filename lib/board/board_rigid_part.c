/*
 * board_rigid_part.c: a part of a panel, on one side of a line through it, is turned and shifted as one rigid piece.
 *
 * Rotating a dart and spreading a slash move a run of sides, and the marks that lie in the part. The part that a mark
 * lies in is found by polygons: the outlines of the parts with 64 chords to each curved piece. The lengths of moved
 * sides stay to the bit.
 *
 * The line of the cut is tested before any side moves: it must lie inside the panel, because otherwise it divides no
 * part from another.
 */
#include <math.h>
#include <string.h>

#include "board/board_rigid_part.h"
#include "geom/curve.h"
#include "geom/polygon.h"
#include "geom/vec.h"

/* chords of a curved piece: the sagitta is 0.02 mm on the roundest armhole */
#define PART_CHORDS 64
/* [m] at both ends of a cut that may run along the outline, whose chords are a little off */
#define PART_NEAR 5e-4
/* [m] a cut whose middle is within this of the outline runs along it */
#define PART_ALONG 1e-5


double mus__board_area(const mus__board *board, int32_t panel)
{
    double area = 0.0;
    int32_t first = board->panel[panel].first, side = first;
    do {
        const mus__board_chain *chain = &board->side[side].chain;
        const double *p = chain->xy;
        for (int32_t i = 0; i < chain->npiece; i++) {
            area += mus__curve_area(chain->kinds[i], p);
            p += 2 * (mus__curve_points(chain->kinds[i]) - 1);
        }
        side = board->side[side].next;
    } while (side != first);
    return area;
}


/* x' = o + shift + R (x - o), so that the point o goes to o + shift to the bit */
static void part_turn_points(const mus__board_motion *motion, int32_t n, double *xy)
{
    const double *o = motion->centre, c = motion->cosine, s = motion->sine;
    for (int32_t i = 0; i < n; i++) {
        double x = xy[2 * (size_t)i] - o[0], y = xy[2 * (size_t)i + 1] - o[1];
        xy[2 * (size_t)i] = o[0] + motion->shift[0] + (c * x - s * y);
        xy[2 * (size_t)i + 1] = o[1] + motion->shift[1] + (s * x + c * y);
    }
}


static void board_chain_turn(mus__board_chain *chain, const mus__board_motion *motion)
{
    part_turn_points(motion, chain->nxy, chain->xy);
}


void mus__board_part_turn(mus__board *board, int32_t first, int32_t last, const mus__board_motion *motion)
{
    if (board->status != MUS_OK) return;
    for (int32_t side = first;; side = board->side[side].next) {
        board_chain_turn(&board->side[side].chain, motion);
        if (side == last) return;
    }
}


static void board_part_add(mus__board *board, mus__board_part *part, const mus__board_chain *chain)
{
    int64_t need = (int64_t)part->n + (int64_t)PART_CHORDS * chain->npiece;
    mus_status status = board->status;
    if (status == MUS_OK) status = mus__reserve(board->context, &part->xy, &part->room, 2 * need, sizeof *part->xy);
    if (status != MUS_OK) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for the outline of a part");
        return;
    }

    /* all points but the last, which is the first of the next chain */
    const double *p = chain->xy;
    for (int32_t i = 0; i < chain->npiece; i++) {
        int32_t kind = chain->kinds[i], n = kind == MUS__LINE ? 1 : PART_CHORDS;
        for (int32_t j = 0; j < n; j++) mus__curve_at(kind, p, (double)j / n, part->xy + 2 * (size_t)part->n++);
        p += 2 * (mus__curve_points(kind) - 1);
    }
}


void mus__board_part_run(mus__board *board, mus__board_part *part, int32_t first, int32_t last)
{
    for (int32_t side = first; board->status == MUS_OK; side = board->side[side].next) {
        board_part_add(board, part, &board->side[side].chain);
        if (side == last) return;
    }
}


void mus__board_part_end(mus__board *board, mus__board_part *part)
{
    mus__free(board->context, part->xy);
    *part = (mus__board_part){0};
}


/* does p lie in the moving part? A point on the line between the parts does not */
static bool part_has(const mus__board_part *moving, const mus__board_part *still, const double *p)
{
    bool in = mus__polygon_winding(moving->n, moving->xy, p) != 0;
    bool out = mus__polygon_winding(still->n, still->xy, p) != 0;
    double near = mus__polygon_distance(moving->n, moving->xy, p);
    double far = mus__polygon_distance(still->n, still->xy, p);
    if (in != out) return in && !(far < 1e-9);
    return near < far - 1e-9;
}


void mus__board_part_marks(mus__board *board, int32_t panel, const mus__board_part *moving,
                           const mus__board_part *still, const mus__board_motion *motion)
{
    if (board->status != MUS_OK) return;
    for (int32_t i = 0; i < board->nmark; i++) {
        mus__board_mark *mark = &board->mark[i];
        if (mark->panel != panel) continue;
        for (int32_t j = 0; j < mark->n; j++) {
            double *p = mark->xy + 2 * (size_t)j;
            if (part_has(moving, still, p)) part_turn_points(motion, 1, p);
        }
    }
}


void mus__board_part_marks_to(mus__board *board, int32_t panel, const mus__board_part *moving,
                              const mus__board_part *still, int32_t to)
{
    if (board->status != MUS_OK) return;
    for (int32_t i = 0; i < board->nmark; i++) {
        mus__board_mark *mark = &board->mark[i];
        if (mark->panel != panel) continue;
        int32_t in = 0;
        for (int32_t j = 0; j < mark->n; j++) in += part_has(moving, still, mark->xy + 2 * (size_t)j) ? 1 : 0;
        if (2 * in > mark->n) mark->panel = to;
    }
}


/* does the segment p-q cross a-b properly? */
static bool part_segments_cross(const double *p, const double *q, const double *a, const double *b)
{
#define LEFT(u, v, w) (((v)[0] - (u)[0]) * ((w)[1] - (u)[1]) - ((v)[1] - (u)[1]) * ((w)[0] - (u)[0]))
    return (LEFT(p, q, a) > 0.0) != (LEFT(p, q, b) > 0.0) && (LEFT(a, b, p) > 0.0) != (LEFT(a, b, q) > 0.0);
#undef LEFT
}


/* a side of the panel that the segment p-q crosses, or MUS_NONE */
static int32_t part_crossed(mus__board *board, int32_t panel, const double *p, const double *q)
{
    int32_t first = board->panel[panel].first, side = first, found = MUS_NONE;
    mus__board_part part = {0};
    do {
        part.n = 0;
        board_part_add(board, &part, &board->side[side].chain);
        if (board->status != MUS_OK) break;
        const double *end = mus__board_end(board, side);
        for (int32_t i = 0; i < part.n && found == MUS_NONE; i++) {
            const double *a = part.xy + 2 * (size_t)i, *b = i + 1 < part.n ? a + 2 : end;
            if (part_segments_cross(p, q, a, b)) found = side;
        }
        side = board->side[side].next;
    } while (side != first && found == MUS_NONE);
    mus__board_part_end(board, &part);
    return found;
}


void mus__board_part_clear(mus__board *board, int32_t panel, const char *what, const double *a, const double *b)
{
    if (board->status != MUS_OK) return;
    double length = mus__dist2(a, b), near = PART_NEAR / fmax(length, 1e-300);
    const char *name = board->panel[panel].name;
    if (!(length > 4.0 * PART_NEAR)) {
        mus__board_fail(board, MUS_ERR_ARG, "%s on panel %s: the line is %g m long, the limit is %g m", what, name,
                        length, 4.0 * PART_NEAR);
        return;
    }
    double p[2], q[2], middle[2] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    for (int i = 0; i < 2; i++) p[i] = a[i] + near * (b[i] - a[i]), q[i] = b[i] - near * (b[i] - a[i]);

    int32_t crossed = part_crossed(board, panel, p, q);
    if (crossed != MUS_NONE) {
        mus__board_fail(board, MUS_ERR_ARG, "%s on panel %s: the line from (%g, %g) to (%g, %g) crosses side %s", what,
                        name, a[0], a[1], b[0], b[1], board->side[crossed].name);
        return;
    }
    mus__board_part outline = {0};
    mus__board_part_run(board, &outline, board->panel[panel].first, board->side[board->panel[panel].first].prev);
    if (board->status == MUS_OK && (mus__polygon_winding(outline.n, outline.xy, middle) == 0 ||
                                    mus__polygon_distance(outline.n, outline.xy, middle) < PART_ALONG))
        mus__board_fail(board, MUS_ERR_ARG, "%s on panel %s: the line from (%g, %g) to (%g, %g) lies outside the panel",
                        what, name, a[0], a[1], b[0], b[1]);
    mus__board_part_end(board, &outline);
}


/* chord and `from` are of the same similarity: from / chord is one complex number */
void mus__board_arc_follow(const double *chord, double *from, const double *next)
{
    double c2 = chord[0] * chord[0] + chord[1] * chord[1];
    if (!(c2 > 0.0)) return;
    double u = (from[0] * chord[0] + from[1] * chord[1]) / c2, v = (from[1] * chord[0] - from[0] * chord[1]) / c2;
    from[0] = u * next[0] - v * next[1];
    from[1] = u * next[1] + v * next[0];
}


void mus__board_part_move_end(mus__board *board, int32_t side, bool end, const double *to)
{
    if (board->status != MUS_OK) return;
    mus__board_chain *chain = &board->side[side].chain;
    int32_t kind = chain->kinds[end ? chain->npiece - 1 : 0], n = mus__curve_points(kind);
    double *p = end ? chain->xy + 2 * (size_t)(chain->nxy - n) : chain->xy, *moved = end ? p + 2 * (n - 1) : p;
    double *hold = end ? moved - 2 : moved + 2, step[2] = {to[0] - moved[0], to[1] - moved[1]};

    if (kind == MUS__ARC) {
        double chord[2] = {p[4] - p[0], p[5] - p[1]}, from[2] = {p[2] - p[0], p[3] - p[1]};
        memcpy(moved, to, 2 * sizeof *to);
        const double next[2] = {p[4] - p[0], p[5] - p[1]};
        mus__board_arc_follow(chord, from, next);
        p[2] = p[0] + from[0], p[3] = p[1] + from[1];
    } else {
        if (kind == MUS__CUBIC) hold[0] += step[0], hold[1] += step[1];
        if (kind == MUS__QUADRATIC) hold[0] += 0.5 * step[0], hold[1] += 0.5 * step[1];
        memcpy(moved, to, 2 * sizeof *to);
    }
    mus__board_part_changed(board, side);
}


void mus__board_part_changed(mus__board *board, int32_t side)
{
    mus__board_side *own = &board->side[side];
    double before = own->length, after = mus__board_chain_length(&own->chain);
    own->length = after;
    if (!(after > 0.0)) {
        mus__board_fail(board, MUS_ERR_ARG, "side %s of panel %s: its length became %g m, it must be above 0",
                        own->name, board->panel[own->panel].name, after);
        return;
    }

    /* notches keep their relative place */
    for (int32_t i = 0; i < board->nnotch; i++) {
        if (board->notch[i].side == side && before > 0.0)
            board->notch[i].s = fmin(board->notch[i].s * (after / before), after);
    }
}


void mus__board_part_ease(mus__board *board, int32_t side, double more)
{
    int32_t seam = board->status == MUS_OK ? mus__board_seam_of(board, side) : MUS_NONE;
    if (seam != MUS_NONE) board->seam[seam].ease += board->seam[seam].a == side ? -more : more;
}
