/*
 * yoke.c: a shirt yoke: the upper back and a strip of the front over the shoulder in one piece.
 *
 * The back is cut horizontally at a quarter of its armhole below the shoulder point, the front along the shoulder, 2 cm
 * below it. The two parts cut off are joined at the shoulder, which is no seam any more. Method: FreeSewing 4 (simon).
 */
#include <math.h>
#include <string.h>

#include "board/board_spread.h"
#include "geom/curve.h"
#include "style/bodice.h"

#define YOKE_FRONT (2.0 * MUS__CM) /* [m] the yoke of a shirt comes to the front over the shoulder by; of practice */
#define YOKE_PLEAT (2.0 * MUS__CM) /* of a half */


/* cut along a straight line between the starts of two sides; the panel that is cut off */
static int32_t yoke_cut(mus__board *board, int32_t from, int32_t to, const char *name, const char *seam)
{
    if (board->status != MUS_OK) return MUS_NONE;
    const double *a = mus__board_start(board, from), *b = mus__board_start(board, to);
    const double xy[4] = {a[0], a[1], b[0], b[1]};
    const int32_t kind = MUS__LINE;
    return mus__board_cut(board, from, to, &(mus__board_path){1, &kind, 2, xy}, name, seam);
}


/* the back of a top without waist darts is 4 cm wider below the yoke, which its upper edge is gathered to */
static void yoke_pleat(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const int32_t seam = mus__board_find(board, top->panel[MUS__TOP_BACK], "yoke");
    const int32_t low = mus__shaping_side(half, top, MUS__TOP_BACK, "low");
    const bool alone = mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP);
    if (board->status != MUS_OK || top->waist_darts[MUS__TOP_BACK] || !alone || seam == MUS_NONE || low == MUS_NONE)
        return;
    const double near = 0.15 * board->side[seam].length, wide = YOKE_PLEAT * top->scale;
    mus__board_spread(board, seam, near, low, board->side[low].length - near, wide, wide);
}


void mus__shaping_yoke(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const int32_t cb = mus__shaping_side(half, top, MUS__TOP_BACK, "cb");
    const int32_t arm = mus__shaping_side(half, top, MUS__TOP_BACK, "arm");
    int32_t front_arm = mus__shaping_side(half, top, MUS__TOP_FRONT, "arm");
    if (front_arm == MUS_NONE) front_arm = mus__shaping_side(half, top, MUS__TOP_FRONT, "arm_2");
    const int32_t neck = mus__shaping_side(half, top, MUS__TOP_FRONT, "neck");
    if (board->status != MUS_OK || cb == MUS_NONE || arm == MUS_NONE || front_arm == MUS_NONE || neck == MUS_NONE)
        return;

    /* back: level, 2 cm below the neck at least. The armhole is walked down, the centre up */
    const double cm = top->scale * MUS__CM, *nape = mus__board_end(board, cb);
    const double least = nape[1] - 2.0 * cm;
    double s = 0.25 * board->side[arm].length, at[2];
    for (int i = 0; i < 20; i++) {
        mus__board_at(board, arm, s, at, NULL);
        if (at[1] <= least) break;
        s += 0.02 * board->side[arm].length;
    }
    const int32_t to = mus__board_split(board, arm, s, NULL);
    const int32_t from = mus__board_split(board, cb, board->side[cb].length - (nape[1] - at[1]), NULL);
    /* two layers, the seam allowances between them */
    mus__half_cut(half, yoke_cut(board, from, to, "back_yoke", "yoke"), 2, MUS_MATERIAL_INTERFACING, 0);
    yoke_pleat(half, top);

    /* front: along the shoulder */
    const double down = fmin(YOKE_FRONT * top->scale, 0.3 * board->side[neck].length);
    const int32_t high = mus__board_split(board, front_arm, board->side[front_arm].length - down, NULL);
    const int32_t low = mus__board_split(board, neck, down, NULL);
    const int32_t strip = yoke_cut(board, high, low, "front_yoke", "yoke_front");

    /* one piece over the shoulder */
    int32_t front_sh, back_sh;
    front_sh = mus__board_find(board, strip, "sh");
    const int32_t back = mus__board_find_panel(board, "back_yoke");
    back_sh = mus__board_find(board, back, "sh");
    if (board->status != MUS_OK || front_sh == MUS_NONE || back_sh == MUS_NONE) return;
    mus__board_seam_add(board, front_sh, back_sh, MUS_SEAM_REVERSED, 0.0);
    mus__board_join(board, back_sh);
}
