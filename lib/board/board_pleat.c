/*
 * board_pleat.c: pleats laid on the cutting table.
 *
 * A pleat of depth d has its outer fold at s: the side runs to the fold, back under itself for d, and on:
 *
 *          s-d        s                    over    ------------->  q0
 *      -----|----q0---|                    under        <-------|  q1
 *               |--q1-|--                               |------->  q2, and on
 *               |--q2---|-- ..
 *
 * Three parts of the side, each d long, lie on one another: q1 is sewn to q0 and q2 to q1, as the legs of a dart are,
 * and q0 takes the place of the side in its seam. Four sheets meet there, and the seam is shorter than the side by 2 d.
 * A pleat under the part after it is the same walked the other way round.
 */
#include <math.h>

#include "board/board_pleat.h"
#include "board/board_rigid_part.h"
#include "board/board_seam.h"

#define PLEAT_MOST 256
#define PLEAT_NEAR 1e-6 /* [m] folds within this are one; chosen: above rounding */


/* arc lengths at which the side is split, ascending: four to a pleat, equal ones once. Returns their number, 0 when the
 * board fails */
static int32_t pleat_places(mus__board *board, int32_t side, int32_t n, const double *s, const double *depth,
                            double *place)
{
    const mus__board_side *own = &board->side[side];
    int32_t count = 0;
    double last = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double d = fabs(depth[i]), from = depth[i] > 0.0 ? s[i] - d : s[i] - 2.0 * d;
        if (!(d > 10.0 * PLEAT_NEAR) || !(from >= last - PLEAT_NEAR) || !(from + 3.0 * d <= own->length + PLEAT_NEAR)) {
            mus__board_fail(board, MUS_ERR_ARG,
                            "pleat %d on side %s: it takes from %g m to %g m, of %g m to %g m that are free", (int)i,
                            own->name, from, from + 3.0 * d, last, own->length);
            return 0;
        }
        for (int32_t k = 0; k < 4; k++) {
            const double at = from + k * d;
            if (at > PLEAT_NEAR && at < own->length - PLEAT_NEAR && (count == 0 || at > place[count - 1] + PLEAT_NEAR))
                place[count++] = at;
        }
        last = from + 3.0 * d;
    }
    return count;
}


/* the part that begins at arc length `at` of the original side */
static int32_t pleat_part(const mus__board *board, int32_t side, int32_t count, double at)
{
    double begin = 0.0;
    for (int32_t i = 0; i < count && fabs(begin - at) > 2.0 * PLEAT_NEAR; i++) {
        begin += board->side[side].length;
        side = board->side[side].next;
    }
    return side;
}


/* sew layer `under` to layer `over`, with the fold between them */
static void pleat_fold(mus__board *board, int32_t over, int32_t under)
{
    const int32_t seam = mus__board_seam_add(board, over, under, MUS_SEAM_REVERSED, 0.0);
    if (seam != MUS_NONE) board->seam[seam].laid = 1;
}


/* does a part lie under another? */
static bool pleat_hidden(const int32_t *hidden, int32_t n, int32_t side)
{
    for (int32_t i = 0; i < n; i++)
        if (hidden[i] == side) return true;
    return false;
}


void mus__board_lay(mus__board *board, int32_t side, int32_t n, const double *s, const double *depth)
{
    double place[4 * PLEAT_MOST];
    int32_t hidden[2 * PLEAT_MOST], show[2 * PLEAT_MOST + 1], nshow = 0;
    if (!mus__board_has_side(board, side)) return;
    if (n < 1 || n > PLEAT_MOST)
        mus__board_fail(board, MUS_ERR_ARG, "%d pleats on side %s are outside 1 to %d", (int)n, board->side[side].name,
                        PLEAT_MOST);
    mus__board_rim_side(board, side, "pleat");
    const int32_t seam = mus__board_seam_of(board, side), partner = mus__board_partner(board, side);
    if (board->status == MUS_OK && seam != MUS_NONE && board->seam[seam].direction != MUS_SEAM_REVERSED)
        mus__board_fail(board, MUS_ERR_ARG, "pleats on side %s: it is sewn face to face", board->side[side].name);
    const int32_t count = board->status == MUS_OK ? pleat_places(board, side, n, s, depth, place) : 0;
    if (board->status != MUS_OK) return;

    /* from the last place back, so that arc lengths from the start stay true */
    if (seam != MUS_NONE) mus__board_seam_drop(board, side);
    for (int32_t i = count - 1; i >= 0; i--) mus__board_split(board, side, place[i], NULL);
    for (int32_t i = 0; i < n && board->status == MUS_OK; i++) {
        const double d = fabs(depth[i]), from = depth[i] > 0.0 ? s[i] - d : s[i] - 2.0 * d;
        const int32_t first = pleat_part(board, side, count, from), second = board->side[first].next;
        const int32_t third = board->side[second].next, over = depth[i] > 0.0 ? first : third;
        hidden[2 * i] = second, hidden[2 * i + 1] = depth[i] > 0.0 ? third : first;
        pleat_fold(board, over, second);
        pleat_fold(board, second, hidden[2 * i + 1]);
        mus__board_notch_add(board, over, depth[i] > 0.0 ? board->side[over].length : 0.0, MUS_NOTCH_SINGLE);
        mus__board_notch_add(board, hidden[2 * i + 1], depth[i] > 0.0 ? board->side[third].length : 0.0,
                             MUS_NOTCH_SINGLE);
    }
    if (partner == MUS_NONE || board->status != MUS_OK) return;
    for (int32_t i = 0, part = side; i <= count; i++, part = board->side[part].next)
        if (!pleat_hidden(hidden, 2 * n, part)) show[nshow++] = part;
    mus__board_sew(board, nshow, show, 1, &partner);
}
