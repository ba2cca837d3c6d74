/*
 * board_dart_rotate.c: a dart rotated (pivoted) about its point.
 *
 * O is the point of the dart, A1 and A2 the ends of its mouth, Q a place on another side. The panel is cut from O to Q,
 * and one of the two parts is turned about O by a fraction of the dart's angle t. The mouth closes by that angle and
 * the same angle opens at Q: |OQ'| = |OQ''|, the new mouth is 2 |OQ| sin(t / 2) wide. The turn is rigid, so area,
 * lengths and the sum of the angles at O stay, and so does the quotient:
 *
 *          Q                       Q' Q''
 *      ____|____               ____| /____
 *     |    |    |             |    |/     |
 *     |    O    |     ->      |    O      |
 *     |   / \   |             |    |      |
 *     |__/   \__|             |____|_____.
 *       A1    A2                 A1=A2
 *
 * When Q is the mouth of a dart with the same point, the panel is cut there already and the two become one.
 */
#include <math.h>

#include "base/elementary.h"
#include "board/board_cut.h"
#include "board/board_dart.h"
#include "board/board_rigid_part.h"
#include "board/board_seam.h"
#include "geom/vec.h"

/* [m] largest difference of the legs of a dart that can be closed; chosen: what a cutter trues by eye */
#define DART_LEGS 2e-3


/* the two parts of the panel: sides p0..p1 from the dart's second leg on, r0..r1 up to its first */
typedef struct dart_cut {
    int32_t p0, p1, r0, r1;
    int32_t other; /* leg of the dart at Q that has the same point, or MUS_NONE */
} dart_cut;


static bool dart_same_point(const mus__board *board, int32_t leg, const mus__dart *dart)
{
    return leg != dart->leg && mus__board_dart_is(board, leg) &&
           mus__dist2(mus__board_end(board, leg), dart->point) <= MUS__DART_SAME;
}


/* divide the ring at arc length s of `target`; false when the board fails */
static bool dart_cut_at(mus__board *board, const mus__dart *dart, int32_t target, double s, dart_cut *cut)
{
    const mus__board_side *side = &board->side[target];
    double length = side->length;
    int32_t before = side->prev, after = side->next;
    bool at_start = s <= MUS__DART_SAME, at_end = s >= length - MUS__DART_SAME;
    cut->p0 = dart->back, cut->r1 = dart->leg, cut->other = MUS_NONE;

    /* a dart cannot be moved to its own mouth */
    if ((at_end && after == dart->leg) || (at_start && before == dart->back)) {
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: %g m along side %s is its own mouth",
                        board->side[dart->leg].name, board->panel[dart->panel].name, s, side->name);
        return false;
    }
    if (at_end && dart_same_point(board, after, dart)) cut->other = after;
    if (at_start && dart_same_point(board, board->side[before].prev, dart)) cut->other = board->side[before].prev;
    if (cut->other != MUS_NONE) {
        cut->p1 = cut->other, cut->r0 = board->side[cut->other].next;
        return true;
    }

    double q[2];
    mus__board_at(board, target, s, q, NULL);
    mus__board_part_clear(board, dart->panel, "dart", dart->point, q);
    if (board->status != MUS_OK) return false;
    if (!at_start && !at_end) {
        mus__board_rim_side(board, target, "dart");
        cut->p1 = target;
        cut->r0 = mus__board_split(board, target, s, NULL);
    } else {
        cut->r0 = mus__board_rim_corner(board, at_start ? target : after, dart->point, "dart");
        cut->p1 = cut->r0 != MUS_NONE ? board->side[cut->r0].prev : MUS_NONE;
    }
    return board->status == MUS_OK;
}


static bool dart_run_has(const mus__board *board, int32_t first, int32_t last, int32_t side)
{
    for (int32_t i = first;; i = board->side[i].next) {
        if (i == side) return true;
        if (i == last) return false;
    }
}


/* turn one part, so that the dart closes by `fraction`; `still` says that the first part stays. A dart that closes
 * whole is turned by the quotient of its legs as complex numbers, whose angle is exact; legs of two lengths meet half
 * way */
static void dart_turn(mus__board *board, const mus__dart *dart, const dart_cut *cut, bool still, double fraction)
{
    mus__board_motion motion = {.centre = {dart->point[0], dart->point[1]}};
    double sign = still ? 1.0 : -1.0;
    if (fraction < 1.0) {
        motion.cosine = mus__cos(fraction * dart->angle), motion.sine = sign * mus__sin(fraction * dart->angle);
    } else {
        const double *o = dart->point;
        double u[2] = {dart->a[0] - o[0], dart->a[1] - o[1]}, v[2] = {dart->b[0] - o[0], dart->b[1] - o[1]};
        double dot = u[0] * v[0] + u[1] * v[1], cross = u[0] * v[1] - u[1] * v[0], norm = mus__hypot(dot, cross);
        motion.cosine = dot / norm, motion.sine = sign * cross / norm;
    }

    mus__board_part p = {0}, r = {0};
    mus__board_part_run(board, &p, cut->p0, cut->p1);
    mus__board_part_run(board, &r, cut->r0, cut->r1);
    mus__board_part_marks(board, dart->panel, still ? &r : &p, still ? &p : &r, &motion);
    mus__board_part_turn(board, still ? cut->r0 : cut->p0, still ? cut->r1 : cut->p1, &motion);
    mus__board_part_end(board, &p);
    mus__board_part_end(board, &r);
}


int32_t mus__board_dart_rotate(mus__board *board, int32_t leg, int32_t target, double s, int32_t keep, double fraction)
{
    mus__dart dart;
    dart_cut cut;
    if (!mus__board_dart_read(board, leg, &dart) || !mus__board_has_side(board, target) ||
        !mus__board_has_side(board, keep))
        return MUS_NONE;
    const char *name = board->panel[dart.panel].name, *title = board->side[leg].name;
    double a = mus__dist2(dart.a, dart.point), b = mus__dist2(dart.b, dart.point);
    if (board->side[target].panel != dart.panel || board->side[keep].panel != dart.panel)
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: side %s is of another panel", title, name,
                        board->side[board->side[target].panel != dart.panel ? target : keep].name);
    else if (target == dart.leg || target == dart.back)
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: it cannot be moved to its own leg", title, name);
    else if (!(fraction > 0.0 && fraction <= 1.0))
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: a fraction of %g is outside 0 to 1", title, name,
                        fraction);
    else if (!(s >= -MUS__DART_SAME && s <= board->side[target].length + MUS__DART_SAME))
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: %g m is outside side %s, which is %g m long",
                        title, name, s, board->side[target].name, board->side[target].length);
    else if (!(fabs(a - b) <= DART_LEGS) || !(fmin(a, b) > MUS__DART_SAME))
        mus__board_fail(board, MUS_ERR_ARG,
                        "dart at %s of panel %s: its legs reach %g m and %g m, they may differ by %g m", title, name, a,
                        b, DART_LEGS);
    else if (mus__board_partner(board, board->side[leg].prev) == board->side[dart.back].next)
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: it is the inner part of one that goes on to %s",
                        title, name, board->side[board->side[leg].prev].name);
    if (board->status != MUS_OK || !dart_cut_at(board, &dart, target, s, &cut)) return MUS_NONE;

    bool still = dart_run_has(board, cut.p0, cut.p1, keep);
    mus__board_part_twins(board, dart.panel);
    dart_turn(board, &dart, &cut, still, fraction);

    /* the dart at Q opens, the old mouth closes */
    int32_t made = cut.other;
    if (made != MUS_NONE)
        mus__board_part_move_end(board, made, true, dart.point);
    else
        made =
            mus__board_dart_legs(board, cut.p1, dart.point, board->side[target].name, board->side[leg].attr.allowance);
    if (board->status == MUS_OK && made == cut.other) mus__board_follow(board, made, board->side[made].next);
    if (fraction == 1.0) mus__board_dart_close(board, mus__board_dart_remove(board, &dart));
    return board->status == MUS_OK ? made : MUS_NONE;
}
