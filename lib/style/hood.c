/*
 * hood.c: the hood: a left and a right half sewn together from the nape over the head, their neck edges to the
 * neckline, the face edge open. It starts as half a drum round the head each, the seam behind. It is lined.
 */
#include <math.h>

#include "geom/vec.h"
#include "style/collar.h"


void mus__hood_attach(mus__half *half, mus__neck *neck)
{
    mus__board *board = &half->board;
    const double head = half->measures.v[MUS_MEASURE_HEAD];
    const mus__hood_def def = {.length = neck->length, .head = head};
    mus__hood hood;
    if (board->status != MUS_OK) return;
    board->status = mus__hood_draft(half->context, &def, &hood);
    if (board->status != MUS_OK) return;

    /* the block has its face at x = 0; here the seam behind is */
    const double back = hood.width + 0.7 * MUS__CM;
    mus__chain sides[3];
    mus__chain_cubic(&sides[0], hood.neck);
    mus__chain_cubic(&sides[1], hood.crown);
    mus__chain_add_line(&sides[1], hood.crown + 6, hood.top);
    mus__chain_line(&sides[2], hood.top, hood.neck);
    for (int32_t i = 0; i < 3; i++)
        for (int32_t p = 0; p < sides[i].nxy; p++) sides[i].xy[2 * p] -= back;

    const int32_t panel = mus__board_panel_add(board, "hood", "hood");
    const int32_t edge = mus__chain_side(board, panel, "neck", NULL, MUS__SEAM_ALLOWANCE, &sides[0]);
    const int32_t crown = mus__chain_side(board, panel, "crown", "centre", MUS__SEAM_ALLOWANCE, &sides[1]);
    mus__chain_side(board, panel, "face", "neck", MUS__SEAM_ALLOWANCE, &sides[2]);
    mus__board_panel_close(board, panel);
    if (board->status != MUS_OK) return;
    board->side[crown].centre = MUS__CENTRE_SEAM;
    mus__half_cut(half, panel, 1, MUS_MATERIAL_LINING, 1);
    mus__board_notch_add(board, edge, neck->length - neck->shoulder, MUS_NOTCH_SINGLE);
    mus__board_sew(board, 1, &edge, neck->loop.n, neck->loop.side);

    /* the drum goes 2.3 of the 3.14 half turn, with the head in it */
    const double radius = fmax(head / (2.0 * MUS_PI) + 3.0 * MUS__CM, hood.width / 2.3);
    mus__panel_place_ring(half, panel, false, 2.0 * MUS_PI * radius, half->skeleton.neck_side);
}
