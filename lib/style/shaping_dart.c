/*
 * shaping_dart.c: steps that the shapes share: finding a half-edge of front or back by name, rotating the bust dart
 * about its point, and redrawing an edge smooth after a dart was released from it.
 */
#include <math.h>
#include <string.h>

#include "board/board_spread.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "style/bodice.h"


int32_t mus__shaping_side(const mus__half *half, const mus__top *top, int32_t which, const char *name)
{
    const bool alone = mus__top_hem(half);
    return mus__board_find(&half->board, top->panel[which], strcmp(name, "low") == 0 ? alone ? "hem" : "waist" : name);
}


int32_t mus__shaping_turn(mus__half *half, mus__top *top, int32_t target, double s, double fraction, int32_t keep)
{
    mus__board *board = &half->board;
    const int32_t leg = mus__board_find(board, top->panel[MUS__TOP_FRONT], "bd1");
    if (leg == MUS_NONE) return MUS_NONE;
    return mus__board_dart_rotate(board, leg, target, s, keep, fraction);
}


/* merges the half-edges of the same label that follow `side` into it */
static void shaping_whole(mus__board *board, int32_t side)
{
    if (side == MUS_NONE) return;
    while (board->status == MUS_OK &&
           strcmp(board->side[board->side[side].next].attr.label, board->side[side].attr.label) == 0)
        mus__board_merge(board, side);
}


void mus__shaping_smooth(mus__board *board, int32_t side)
{
    double start[2], end[2], along[2][2];
    shaping_whole(board, side);
    if (board->status != MUS_OK || side == MUS_NONE) return;
    const double length = board->side[side].length;
    mus__board_at(board, side, 0.0, start, along[0]);
    mus__board_at(board, side, length, end, along[1]);
    const double reach = 0.36 * length;
    const double xy[8] = {start[0], start[1], start[0] + reach * along[0][0], start[1] + reach * along[0][1],
                          end[0] - reach * along[1][0], end[1] - reach * along[1][1], end[0], end[1]};
    const int32_t kind = MUS__CUBIC;
    mus__board_redraw(board, side, 1, &kind, 4, xy);
}


/* an armhole of a curve, the line across a mouth and a curve: the curves meet in the middle of the line with one
 * tangent, their handles as long as they were */
void mus__shaping_smooth_arm(mus__board *board, int32_t side)
{
    shaping_whole(board, side);
    if (board->status != MUS_OK || side == MUS_NONE) return;
    const mus__board_chain *chain = &board->side[side].chain;
    if (chain->npiece != 3 || chain->kinds[0] != MUS__CUBIC || chain->kinds[1] != MUS__LINE ||
        chain->kinds[2] != MUS__CUBIC)
        return;
    const double *a = chain->xy, *b = chain->xy + 8;
    double xy[14], along[2], norm = 0.0;
    const double before = mus__dist2(a + 4, a + 6), after = mus__dist2(b, b + 2);
    memcpy(xy, a, 4 * sizeof *xy);
    memcpy(xy + 10, b + 4, 4 * sizeof *xy);
    for (int i = 0; i < 2; i++) {
        along[i] = (a[6 + i] - a[4 + i]) / before + (b[2 + i] - b[i]) / after;
        norm += along[i] * along[i];
    }
    for (int i = 0; i < 2; i++) {
        const double middle = 0.5 * (a[6 + i] + b[i]), unit = along[i] / sqrt(norm);
        xy[4 + i] = middle - before * unit;
        xy[6 + i] = middle;
        xy[8 + i] = middle + after * unit;
    }
    const int32_t kinds[2] = {MUS__CUBIC, MUS__CUBIC};
    mus__board_redraw(board, side, 2, kinds, 7, xy);
}
