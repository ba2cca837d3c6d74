/*
 * half_garment.c: small steps that the parts of a half garment share.
 */
#include <math.h>

#include "half/half_garment.h"


bool mus__style_is(const mus__half *half, int32_t axis, int32_t option)
{
    return half->style.option[axis] == option;
}


double mus__lower_scale(const mus__half *half)
{
    return fmin(1.0, half->measures.v[MUS_MEASURE_WAIST_TO_HIP] / 0.20);
}


void mus__half_failed(mus__half *half, mus_status status)
{
    if (half->board.status == MUS_OK) half->board.status = status;
}


void mus__half_centre(mus__half *half, int32_t panel, const char *name, int32_t centre)
{
    const int32_t side = mus__board_find(&half->board, panel, name);
    if (half->board.status == MUS_OK && side != MUS_NONE) half->board.side[side].centre = centre;
}


void mus__half_sew(mus__half *half, int32_t panel_a, const char *a, int32_t panel_b, const char *b, double ease)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK) return;
    mus__board_seam_add(board, mus__board_find(board, panel_a, a), mus__board_find(board, panel_b, b),
                        MUS_SEAM_REVERSED, ease);
}


void mus__half_darts(mus__half *half, int32_t panel)
{
    static const char *const legs[][2] = {{"d1", "d2"}, {"d3", "d4"}};
    for (int i = 0; i < 2; i++)
        if (mus__board_find(&half->board, panel, legs[i][0]) != MUS_NONE)
            mus__half_sew(half, panel, legs[i][0], panel, legs[i][1], 0.0);
}


void mus__half_cut(mus__half *half, int32_t panel, int32_t main, int32_t material, int32_t count)
{
    if (half->board.status != MUS_OK || panel == MUS_NONE) return;
    int32_t *cut = half->board.panel[panel].attr.cut;
    cut[MUS_MATERIAL_MAIN] = main;
    cut[material] = count;
}


void mus__half_band_grain(mus__half *half, int32_t panel)
{
    if (half->board.status != MUS_OK || panel == MUS_NONE) return;
    mus__panel_attributes *attr = &half->board.panel[panel].attr;
    const bool gives = half->style.option[MUS__AXIS_CLOTH] == MUS__CLOTH_KNIT || attr->cut[MUS_MATERIAL_RIB] > 0;
    attr->grain[0] = gives ? 0.0 : 1.0;
    attr->grain[1] = gives ? 1.0 : 0.0;
}


int32_t mus__chain_side(mus__board *board, int32_t panel, const char *name, const char *label, double allowance,
                        const mus__chain *chain)
{
    const int32_t side =
        mus__board_side_add(board, panel, name, label, chain->npiece, chain->kinds, chain->nxy, chain->xy);
    if (side != MUS_NONE) board->side[side].attr.allowance = allowance;
    return side;
}
