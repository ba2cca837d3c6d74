/*
 * hem_rib.c: the rib at the hem of a top: a strip in front and one behind, sewn together at the sides.
 *
 *        centre  ------ hem ------  side      the rib is as long as MUS__RIB_PART of the hem, which is stretched to it;
 *               |      rib       |            front and back have their centre on the fold, or the front opens as the
 *                ================             body above it does
 *
 * It is turned in along its lower edge: the allowance there is the inner layer. The body is shorter by its height, less
 * what falls over it. Method: as the ribs of cuffs and legs (cuff.c, trousers.c).
 */
#include <string.h>

#include "closure/closure.h"
#include "style/bodice.h"


static bool rib_asked(const mus__half *half)
{
    return mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP) &&
           mus__style_is(half, MUS__AXIS_HEM, MUS__HEM_RIBBED);
}


double mus__hem_rib_above(const mus__half *half, double scale)
{
    return rib_asked(half) ? scale * (MUS__RIB_HEIGHT - MUS__RIB_BLOUSE) : 0.0;
}


/* the centre of a rib as that of the body: a fold, or a front that buttons, with a button in its middle */
static void rib_centre(mus__half *half, int32_t panel, bool opens)
{
    mus__board *board = &half->board;
    const int32_t side = mus__board_find(board, panel, "centre");
    if (board->status != MUS_OK || side == MUS_NONE) return;
    board->side[side].centre = opens ? MUS__CENTRE_SEAM : MUS__CENTRE_FOLD;
    board->side[side].attr.allowance = opens ? 2.0 * MUS__BUTTON_STAND + 1.0 * MUS__CM : 0.0;
    if (!opens) return;
    mus__closure_button(board, side, 0.0, "button");
    mus__closure_fold(board, side, MUS__BUTTON_STAND);
}


/* the rib of the front or back, sewn to its hem: lower edge, side up, upper edge, centre down */
static int32_t rib_draw(mus__half *half, const mus__top *top, bool front)
{
    mus__board *board = &half->board;
    int32_t sides[MUS__TOP_RUN], upper;
    const int32_t n = mus__half_boundary(half, front ? "front" : "back", "hem", sides, MUS__TOP_RUN);
    if (board->status != MUS_OK || n < 1 || n > MUS__TOP_RUN) return MUS_NONE;
    double length = 0.0;
    for (int32_t i = 0; i < n; i++) length += MUS__RIB_PART * board->side[sides[i]].length;
    const double height = MUS__RIB_HEIGHT * top->scale;
    const double a[2] = {0.0, -height}, b[2] = {length, -height}, c[2] = {length, 0.0}, d[2] = {0.0, 0.0};
    mus__outline outline;
    mus__outline_begin(&outline);
    mus__outline_line(&outline, "low", "hem", height + MUS__SEAM_ALLOWANCE, a, b);
    mus__outline_line(&outline, "end", "side", MUS__SEAM_ALLOWANCE, b, c);
    mus__outline_line(&outline, "top", "rib", MUS__SEAM_ALLOWANCE, c, d);
    mus__outline_line(&outline, "centre", "centre", MUS__SEAM_ALLOWANCE, d, a);
    const int32_t panel = mus__outline_panel(half, &outline, front ? "front_rib" : "back_rib", "rib", !front);
    mus__half_cut(half, panel, 0, MUS_MATERIAL_RIB, 1);
    mus__half_band_grain(half, panel);
    rib_centre(half, panel, front && mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_FRONT));
    mus__closure_fold(board, mus__board_find(board, panel, "low"), 0.0);
    mus__panel_place_torso(half, panel, front, half->bodice.front.under[0] + top->hip_out,
                           half->waist_level + top->hem);
    for (int32_t i = 0; i < n && board->status == MUS_OK; i++) {
        char name[MUS__NAME_BYTES];
        memcpy(name, board->side[sides[i]].name, sizeof name);
        board->side[sides[i]].attr.allowance = MUS__SEAM_ALLOWANCE;
        mus__board_rename(board, sides[i], name, "rib");
    }
    upper = mus__board_find(board, panel, "top");
    if (board->status == MUS_OK) mus__board_sew(board, n, sides, 1, &upper);
    return panel;
}


void mus__hem_rib_attach(mus__half *half, const mus__top *top)
{
    if (half->board.status != MUS_OK || !rib_asked(half)) return;
    const int32_t front = rib_draw(half, top, true), back = rib_draw(half, top, false);
    if (front != MUS_NONE && back != MUS_NONE) mus__half_sew(half, front, "end", back, "end", 0.0);
}
