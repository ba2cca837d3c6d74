/*
 * board_spread.c: fullness and length: slash and spread, lengthen and shorten, draw a side again.
 *
 * A slash P-Q of length L opens by w0 at P and w1 at Q. The part to the right of P-Q (the word runs counter-clockwise)
 * is turned clockwise about P by d, 2 sin(d / 2) = (w1 - w0) / L, and P goes to P'' at distance w0, square to the
 * middle of the two legs. This is the rotation about the point where the legs meet, written so that parallel legs (w0 =
 * w1, a shift) are no special case. The gap is a trapezoid with two legs of length L: the area grows by
 *
 *     L cos(d / 2) (w0 + w1) / 2 .
 *
 * Each slashed side stays one side: its first part, a line across the gap, its second part. All other sides move
 * rigidly.
 */
#include <math.h>
#include <string.h>

#include "board/board_spread.h"
#include "base/elementary.h"
#include "board/board_rigid_part.h"
#include "geom/curve.h"
#include "geom/vec.h"

/* [m] an opening narrower than this is a hinge; chosen: above rounding */
#define SPREAD_HINGE 1e-9
/* [m] a slash within this of an end of a side leaves the side whole; chosen: above rounding */
#define SPREAD_END 1e-6

/* a place of the outline that opens: before the side `after`, which may be a part of another for a while */
typedef struct spread_joint {
    int32_t after, owner; /* owner: the side that the line across the gap becomes part of */
    bool divided;
} spread_joint;


/* does the ring open at a corner, for a slash towards a point, beside the side that the gap becomes part of? */
static bool spread_corner(mus__board *board, const spread_joint *joint, const double *towards)
{
    const int32_t after = mus__board_rim_corner(board, joint->after, towards, "slash");
    if (after == joint->after || board->status != MUS_OK) return board->status == MUS_OK;
    const mus__board_side *owner = &board->side[joint->owner];
    mus__board_fail(board, MUS_ERR_ARG, "slash on panel %s: a line inside it lies between the slash and side %s",
                    board->panel[owner->panel].name, owner->name);
    return false;
}


/* open the ring at arc length s of a side, for a slash from there towards a point. Its seam stays with the first part,
 * so the side it is sewn to stays whole */
static bool spread_divide(mus__board *board, int32_t side, double s, const double *towards, spread_joint *out)
{
    if (board->status != MUS_OK) return false;
    const mus__board_side *own = &board->side[side];
    *out = (spread_joint){side, side, false};
    if (s <= SPREAD_END) return spread_corner(board, out, towards);
    *out = (spread_joint){own->next, side, false};
    if (s >= own->length - SPREAD_END) return spread_corner(board, out, towards);
    mus__board_rim_side(board, side, "slash");

    mus__board_chain before, after;
    mus__board_chain_split(board, &own->chain, own->length, s, &before, &after);
    if (board->status != MUS_OK) return false;
    int32_t tail = mus__board_side_new(board, own->panel, &after);
    if (tail == MUS_NONE) {
        mus__free(board->context, before.xy);
        return false;
    }
    int32_t next = board->side[side].next;
    mus__free(board->context, board->side[side].chain.xy);
    board->side[side].chain = before;
    board->side[side].length = mus__board_chain_length(&before);
    mus__board_follow(board, side, tail);
    mus__board_follow(board, tail, next);
    for (int32_t i = 0; i < board->nnotch; i++) {
        mus__board_notch *notch = &board->notch[i];
        if (notch->side == side && notch->s > s) notch->side = tail, notch->s -= s;
    }
    *out = (spread_joint){tail, side, true};
    return true;
}


/* `own` becomes a then b, b spent; *own may be a */
static void spread_join(mus__board *board, mus__board_chain *own, const mus__board_chain *a, const mus__board_chain *b)
{
    mus__board_chain joined;
    mus__board_chain_join(board, a, b, &joined);
    if (board->status != MUS_OK) return;
    mus__free(board->context, own->xy);
    *own = joined;
}


static void spread_shift_notches(mus__board *board, int32_t from, int32_t to, double by)
{
    for (int32_t i = 0; i < board->nnotch; i++) {
        if (board->notch[i].side != from) continue;
        board->notch[i].side = to;
        board->notch[i].s += by;
    }
}


/* a line across the gap of a joint, and the second part back to the first */
static void spread_close(mus__board *board, const spread_joint *joint)
{
    if (board->status != MUS_OK) return;
    const int32_t kind = MUS_PIECE_LINE, after = joint->after, before = board->side[after].prev;
    const double *p = mus__board_end(board, before), *q = mus__board_start(board, after);
    const double xy[4] = {p[0], p[1], q[0], q[1]};
    double gap = mus__dist2(p, q);
    mus__board_side *a = &board->side[before], *b = &board->side[after];
    mus__board_chain line = {0};
    if (gap > SPREAD_HINGE) mus__board_chain_make(board, 1, &kind, 2, xy, &line);

    if (line.xy != NULL && joint->owner == after) {
        spread_join(board, &b->chain, &line, &b->chain);
        spread_shift_notches(board, after, after, gap);
        b->length += gap;
    } else if (line.xy != NULL) {
        spread_join(board, &a->chain, &a->chain, &line);
        a->length += gap;
    }
    mus__free(board->context, line.xy);
    if (board->status != MUS_OK) return;
    if (!joint->divided) {
        mus__board_follow(board, before, after);
        return;
    }
    spread_shift_notches(board, after, before, a->length);
    spread_join(board, &a->chain, &a->chain, &b->chain);
    a->length += b->length;
    a->next = b->next;
    board->side[b->next].prev = before;
    mus__board_side_remove(board, after);
}


/* the motion of the part: turned about P by -d, and shifted so that P comes to P'' */
static void spread_motion(const double *p, const double *q, double w0, double w1, double turn, mus__board_motion *out)
{
    double length = mus__dist2(p, q), u[2] = {(q[0] - p[0]) / length, (q[1] - p[1]) / length};
    double half = 0.5 * (w1 - w0) / length, c = sqrt(1.0 - half * half); /* sine and cosine of d / 2 */
    double n[2] = {turn * u[1], -turn * u[0]};                           /* to the side that moves */
    out->centre[0] = p[0], out->centre[1] = p[1];
    out->cosine = 1.0 - 2.0 * half * half, out->sine = -turn * 2.0 * half * c;
    out->shift[0] = w0 * (c * n[0] + turn * half * n[1]);
    out->shift[1] = w0 * (c * n[1] - turn * half * n[0]);
}


/* can a slash be opened by these widths? The board fails when it cannot */
static bool spread_check(mus__board *board, int32_t from, double s0, int32_t to, double s1, double w0, double w1)
{
    if (!mus__board_has_side(board, from) || !mus__board_has_side(board, to)) return false;
    const mus__board_side *a = &board->side[from], *b = &board->side[to];
    const char *name = board->panel[a->panel].name;
    if (a->panel != b->panel)
        mus__board_fail(board, MUS_ERR_ARG, "slash: side %s is of panel %s, side %s of another", a->name, name,
                        b->name);
    else if (!(s0 >= -SPREAD_END && s0 <= a->length + SPREAD_END))
        mus__board_fail(board, MUS_ERR_ARG, "slash on panel %s: %g m is outside side %s, which is %g m long", name, s0,
                        a->name, a->length);
    else if (!(s1 >= -SPREAD_END && s1 <= b->length + SPREAD_END))
        mus__board_fail(board, MUS_ERR_ARG, "slash on panel %s: %g m is outside side %s, which is %g m long", name, s1,
                        b->name, b->length);
    else if (!(w0 >= 0.0 && w1 >= 0.0 && w0 + w1 > 0.0 && w0 + w1 <= MUS__FARTHEST))
        mus__board_fail(board, MUS_ERR_ARG,
                        "slash on panel %s: it opens by %g m and %g m, at least one must be above 0", name, w0, w1);
    return board->status == MUS_OK;
}


void mus__board_spread(mus__board *board, int32_t from, double s0, int32_t to, double s1, double w0, double w1)
{
    if (!spread_check(board, from, s0, to, s1, w0, w1)) return;
    const int32_t panel = board->side[from].panel;
    const double grown[2] = {board->side[from].length, board->side[to].length};
    double p[2], q[2], turn = mus__board_area(board, panel) < 0.0 ? -1.0 : 1.0;
    mus__board_at(board, from, fmax(s0, 0.0), p, NULL);
    mus__board_at(board, to, fmax(s1, 0.0), q, NULL);
    mus__board_part_clear(board, panel, "slash", p, q);
    if (board->status != MUS_OK) return;
    if (!(fabs(w1 - w0) < mus__dist2(p, q))) {
        mus__board_fail(board, MUS_ERR_ARG,
                        "slash on panel %s: openings of %g m and %g m need a slash longer than %g m",
                        board->panel[panel].name, w0, w1, mus__dist2(p, q));
        return;
    }

    /* open the ring at both places; of two on one side the later first, so that the first part keeps its arc lengths */
    spread_joint at_from, at_to;
    bool late = from == to && s1 > s0;
    bool open = late ? spread_divide(board, to, s1, p, &at_to) && spread_divide(board, from, s0, q, &at_from)
                     : spread_divide(board, from, s0, q, &at_from) && spread_divide(board, to, s1, p, &at_to);
    if (!open) return;

    mus__board_motion motion;
    mus__board_part moving = {0}, still = {0};
    int32_t first = at_from.after, last = board->side[at_to.after].prev;
    mus__board_part_twins(board, panel);
    spread_motion(p, q, w0, w1, turn, &motion);
    mus__board_part_run(board, &moving, first, last);
    mus__board_part_run(board, &still, at_to.after, board->side[first].prev);
    mus__board_part_marks(board, panel, &moving, &still, &motion);
    mus__board_part_turn(board, first, last, &motion);
    mus__board_part_end(board, &moving);
    mus__board_part_end(board, &still);

    /* close it again, along one side the earlier place first */
    bool backward = from == to && !late;
    spread_close(board, backward ? &at_to : &at_from);
    spread_close(board, backward ? &at_from : &at_to);
    if (board->status != MUS_OK) return;
    mus__board_part_ease(board, from, board->side[from].length - grown[0]);
    if (to != from) mus__board_part_ease(board, to, board->side[to].length - grown[1]);
}


/* ---- lengthen ---- */

/* a chain whose points beyond the line move: ends of pieces by where they are, control points with their end, the
 * middle of an arc so that its angle stays */
static void spread_stretch(mus__board_chain *chain, const double *point, const double *normal, double amount)
{
#define BEYOND(p) (((p)[0] - point[0]) * normal[0] + ((p)[1] - point[1]) * normal[1] > 0.0 ? 1.0 : 0.0)
    const double step[2] = {amount * normal[0], amount * normal[1]};
    double *p = chain->xy, start[2] = {p[0], p[1]};
    for (int32_t i = 0; i < chain->npiece; i++) {
        const int32_t kind = chain->kinds[i], n = mus__curve_points(kind);
        double *end = p + 2 * (n - 1), a = BEYOND(start), b = BEYOND(end);
        double was[2] = {end[0], end[1]}, chord[2] = {end[0] - start[0], end[1] - start[1]};
        for (int k = 0; k < 2; k++) {
            if (i == 0) p[k] += a * step[k];
            if (kind == MUS__CUBIC) p[2 + k] += a * step[k], p[4 + k] += b * step[k];
            if (kind == MUS__QUADRATIC) p[2 + k] += 0.5 * (a + b) * step[k];
            end[k] += b * step[k];
        }
        if (kind == MUS__ARC) {
            double from[2] = {p[2] - start[0], p[3] - start[1]}, next[2] = {end[0] - p[0], end[1] - p[1]};
            mus__board_arc_follow(chord, from, next);
            p[2] = p[0] + from[0], p[3] = p[1] + from[1];
        }
        memcpy(start, was, sizeof start);
        p = end;
    }
#undef BEYOND
}


void mus__board_lengthen(mus__board *board, int32_t panel, const double *point, const double *direction, double amount)
{
    if (!mus__board_has_panel(board, panel)) return;
    double norm = mus__hypot(direction[0], direction[1]);
    if (!mus__near(2, point) || !mus__finite(norm) || !(norm > 0.0) ||
        !mus__near(1, &amount)) {
        mus__board_fail(board, MUS_ERR_ARG, "lengthen panel %s: %g m across a line through (%g, %g) along (%g, %g)",
                        board->panel[panel].name, amount, point[0], point[1], direction[0], direction[1]);
        return;
    }
    const double normal[2] = {-direction[1] / norm, direction[0] / norm};
    double area = mus__board_area(board, panel);
    mus__board_part_twins(board, panel);
    int32_t first = board->panel[panel].first, side = first;
    do {
        double before = board->side[side].length;
        spread_stretch(&board->side[side].chain, point, normal, amount);
        mus__board_part_changed(board, side);
        mus__board_part_ease(board, side, board->side[side].length - before);
        side = board->side[side].next;
    } while (side != first);
    for (int32_t i = 0; i < board->nmark; i++) {
        mus__board_mark *mark = &board->mark[i];
        for (int32_t j = 0; j < mark->n && mark->panel == panel; j++) {
            double *p = mark->xy + 2 * (size_t)j;
            if (!((p[0] - point[0]) * normal[0] + (p[1] - point[1]) * normal[1] > 0.0)) continue;
            for (int k = 0; k < 2; k++) p[k] += amount * normal[k];
        }
    }

    /* a panel that is shortened by more than its length turns over */
    double after = mus__board_area(board, panel);
    if (board->status == MUS_OK && !(after * area > 0.0))
        mus__board_fail(board, MUS_ERR_ARG, "lengthen panel %s: %g m leave nothing of it", board->panel[panel].name,
                        amount);
}


/* ---- a side drawn again ---- */

void mus__board_redraw(mus__board *board, int32_t side, int32_t npiece, const int32_t *kinds, int32_t nxy,
                       const double *xy)
{
    if (!mus__board_has_side(board, side)) return;
    mus__board_chain chain;
    mus__board_chain_make(board, npiece, kinds, nxy, xy, &chain);
    if (board->status != MUS_OK) return;
    mus__board_part_twins(board, board->side[side].panel);
    mus__free(board->context, board->side[side].chain.xy);
    board->side[side].chain = chain;
    mus__board_part_changed(board, side);

    /* move the ends of the neighbours along; a panel of one side has none */
    int32_t prev = board->side[side].prev, next = board->side[side].next;
    const double *start = mus__board_start(board, side), *end = mus__board_end(board, side);
    if (prev == side) {
        if (start[0] != end[0] || start[1] != end[1])
            mus__board_fail(board, MUS_ERR_ARG, "side %s is the whole outline, but does not end where it starts",
                            board->side[side].name);
        return;
    }
    const double *meets = mus__board_end(board, prev);
    if (meets[0] != start[0] || meets[1] != start[1]) mus__board_part_move_end(board, prev, true, start);
    meets = mus__board_start(board, next);
    if (meets[0] != end[0] || meets[1] != end[1]) mus__board_part_move_end(board, next, false, end);
}
