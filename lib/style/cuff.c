/*
 * cuff.c: cuffs and ribs: a straight band whose ends are sewn together at the underarm, its long edge sewn to the
 * end of the sleeve. The sleeve is gathered to the cuff; a rib is stretched to the sleeve. Each is cut once and turned
 * in along its free edge: the allowance there is the inner layer. A cuff has interfacing.
 */
#include <string.h>

#include "style/sleeve.h"

#define CUFF_SIDES 8


/* open sides of the sleeve's end round the arm, from the underarm: behind an underarm edge is the first */
static int32_t cuff_rim(const mus__half *half, int32_t *sides)
{
    const mus__board *board = &half->board;
    int32_t n = 0, at = MUS_NONE;
    for (int32_t i = 0; i < board->nside && at == MUS_NONE; i++) {
        const mus__board_side *side = &board->side[i];
        if (side->panel == MUS_NONE || strcmp(side->attr.label, "cuff") != 0) continue;
        if (mus__board_partner(board, i) == MUS_NONE && strncmp(board->side[side->prev].name, "under", 5) == 0) at = i;
    }
    while (at != MUS_NONE && n < CUFF_SIDES && (n == 0 || at != sides[0])) {
        sides[n++] = at;
        at = board->side[at].next;
        for (int32_t i = 0; i < board->nside && mus__board_partner(board, at) != MUS_NONE; i++)
            at = board->side[mus__board_partner(board, at)].next;
    }
    return n;
}


void mus__cuff_attach(mus__half *half, double length, double depth, double down)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK) return;
    int32_t sides[CUFF_SIDES];
    const int32_t n = cuff_rim(half, sides);
    if (n < 1 || n == CUFF_SIDES) {
        mus__board_fail(board, MUS_ERR_DESIGN, "cuff: %d sides at the end of the sleeve, 1 to %d can be sewn to",
                        (int)n, CUFF_SIDES - 1);
        return;
    }

    /* the band, front at x < 0, its grain along the length */
    const double x = 0.5 * length;
    const double corner[4][2] = {{-x, -depth}, {x, -depth}, {x, 0.0}, {-x, 0.0}};
    static const char *const names[4] = {"edge", "endB", "top", "endF"};
    int32_t side[4];
    const int32_t panel = mus__board_panel_add(board, "cuff", "arm");
    for (int32_t i = 0; i < 4; i++) {
        mus__chain line;
        mus__chain_line(&line, corner[i], corner[(i + 1) % 4]);
        side[i] = mus__chain_side(board, panel, names[i], i == 0 ? "cuff" : NULL, MUS__SEAM_ALLOWANCE, &line);
    }
    mus__board_panel_close(board, panel);
    if (board->status != MUS_OK) return;
    board->panel[panel].attr.grain[0] = 1.0, board->panel[panel].attr.grain[1] = 0.0;
    board->side[side[0]].attr.allowance = depth + MUS__SEAM_ALLOWANCE;
    const bool rib = mus__style_is(half, MUS__AXIS_CUFF, MUS__CUFF_RIB);
    mus__half_cut(half, panel, rib ? 0 : 1, rib ? MUS_MATERIAL_RIB : MUS_MATERIAL_INTERFACING, 1);
    mus__board_seam_add(board, side[3], side[1], MUS_SEAM_REVERSED, 0.0);
    mus__board_sew(board, 1, &side[2], n, sides);
    mus__panel_place_arm(half, panel, 0.0, down, length);
}
