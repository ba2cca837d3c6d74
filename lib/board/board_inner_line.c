/*
 * board_inner_line.c: lines inside a panel on the cutting table, and where a cut from their corner opens the ring.
 *
 * A line inside a panel hangs from a corner v of the cut line as a hair: out over sides o1 .. ok and back over bk ..
 * b1, each b the bridge twin of its o. The cloth is whole there. A cut from the cut line to a hair would cut one side
 * of the hair only and open the panel along it, so it is refused. A cut, or another hair, that leaves v runs between
 * two hairs or beside them; its direction tells where:
 *
 *                          before            the word:  before, hair 1, hair 2, after
 *                    ------------> v
 *                     hair 1 .'   /|         a cut between the hairs opens the ring before hair 2
 *                           '    / v  after
 *                          hair 2
 */

#include "base/elementary.h"
#include "board/board_rigid_part.h"
#include "geom/vec.h"

#define INNER_SAME 1e-9 /* [rad] directions within this are one; the angle round the tip of a hair is 2 pi */


/* the other side of the bridge that a side is in, or MUS_NONE */
static int32_t inner_twin(const mus__board *board, int32_t side)
{
    for (int32_t i = 0; i < board->nseam; i++) {
        const mus__board_seam *seam = &board->seam[i];
        if (seam->bridge && seam->a == side) return seam->b;
        if (seam->bridge && seam->b == side) return seam->a;
    }
    return MUS_NONE;
}


/* does a walk from `first` to `last` pass a side? */
static bool inner_passes(const mus__board *board, int32_t first, int32_t last, int32_t side)
{
    for (int32_t i = first; i != side; i = board->side[i].next)
        if (i == last) return false;
    return true;
}


/* is the walk from `out` to `back` a hair: is each side between them in a bridge whose other side is between them
 * too? */
static bool inner_hair(const mus__board *board, int32_t out, int32_t back)
{
    for (int32_t i = board->side[out].next; i != back; i = board->side[i].next) {
        const int32_t twin = inner_twin(board, i);
        if (i == out || twin == MUS_NONE || !inner_passes(board, out, back, twin)) return false;
    }
    return true;
}


/* is `side` part of a hair? With `corner`: is its start a corner of a hair, other than the root? */
static bool inner_has(const mus__board *board, int32_t side, bool corner)
{
    const int32_t panel = board->side[side].panel;
    for (int32_t i = 0; i < board->nseam; i++) {
        const mus__board_seam *seam = &board->seam[i];
        if (!seam->bridge || seam->a == MUS_NONE) continue;
        if (board->side[seam->a].panel != panel || board->side[seam->b].panel != panel) continue;
        for (int32_t k = 0; k < 2; k++) {
            const int32_t out = k == 0 ? seam->a : seam->b, back = k == 0 ? seam->b : seam->a;
            if (inner_hair(board, out, back) && inner_passes(board, corner ? board->side[out].next : out, back, side))
                return true;
        }
    }
    return false;
}


void mus__board_rim_side(mus__board *board, int32_t side, const char *what)
{
    if (!mus__board_has_side(board, side) || !inner_has(board, side, false)) return;
    mus__board_fail(board, MUS_ERR_ARG, "%s on panel %s: side %s is a line inside it, not of its rim", what,
                    board->panel[board->side[side].panel].name, board->side[side].name);
}


/* angle [rad] from u to v, from `least` to 2 pi + least, counter-clockwise when turn is 1 */
static double inner_angle(const double *u, const double *v, double turn, double least)
{
    const double angle = mus__atan2(turn * (u[0] * v[1] - u[1] * v[0]), u[0] * v[0] + u[1] * v[1]);
    return angle >= least ? angle : angle + 2.0 * MUS_PI;
}


/* does the direction from the start of a side to a point lie between that side and the side before it? */
static bool inner_between(const mus__board *board, int32_t side, const double *towards, double turn)
{
    const double *v = mus__board_start(board, side), way[2] = {towards[0] - v[0], towards[1] - v[1]};
    const int32_t before = board->side[side].prev;
    double in[2], out[2];
    mus__board_at(board, before, board->side[before].length, NULL, in);
    mus__board_at(board, side, 0.0, NULL, out);
    in[0] = -in[0], in[1] = -in[1];
    return inner_angle(in, way, turn, -INNER_SAME) <= inner_angle(in, out, turn, INNER_SAME) + INNER_SAME;
}


int32_t mus__board_corner(const mus__board *board, int32_t side, const double *towards)
{
    /* clockwise where the word runs counter-clockwise: the panel is on its left */
    const double turn = mus__board_area(board, board->side[side].panel) < 0.0 ? 1.0 : -1.0;
    const double *v = mus__board_start(board, side);
    const int32_t knot = board->side[side].knot;
    int32_t at = side;
    do {
        const double *start = mus__board_start(board, at);
        const bool same = knot != MUS_NONE && board->side[at].knot == knot && start[0] == v[0] && start[1] == v[1];
        if ((at == side || same) && inner_between(board, at, towards, turn)) return at;
        at = board->side[at].next;
    } while (at != side);
    return side;
}


int32_t mus__board_rim_corner(mus__board *board, int32_t side, const double *towards, const char *what)
{
    if (!mus__board_has_side(board, side)) return MUS_NONE;
    const int32_t at = mus__board_corner(board, side, towards);
    if (!inner_has(board, at, true)) return at;
    mus__board_rim_side(board, at, what);
    return MUS_NONE;
}
