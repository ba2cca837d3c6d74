/*
 * cuff.c: cuffs and ribs: a straight band whose ends are sewn together at the underarm, its long edge sewn to the
 * end of the sleeve. The sleeve, whose hem is a seam then, is gathered to the
 * cuff; a rib is stretched to the sleeve. Each is cut once and turned
 * in along its free edge: the allowance there is the inner layer. A cuff has interfacing.
 *
 * The cuff of a long sleeve opens: its ends are drawn done up, one of them goes on under the other by 2.5 cm with a
 * button, and above them the sleeve is slit, 10 cm up in the middle of its back half. The slit is a mark: it is drawn
 * closed (Aldrich 2008).
 */
#include <string.h>

#include "closure/closure.h"
#include "style/sleeve.h"

#define CUFF_SIDES 8
#define CUFF_LAP (2.5 * MUS__CM)   /* [m] one end of an open cuff under the other; Aldrich 2008 */
#define CUFF_SLIT (10.0 * MUS__CM) /* [m] length of a slit; Aldrich 2008 */
#define CUFF_SLIT_AT 0.75          /* of the sleeve's end from the front: the middle of the back half */


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


/* marks the slit in the sleeve's end, the half-edges sides (n) from the underarm in front to that behind */
static void cuff_slit(mus__half *half, int32_t n, const int32_t *sides)
{
    mus__board *board = &half->board;
    double length = 0.0, line[4], along[2];
    int32_t i = 0;
    for (int32_t k = 0; k < n; k++) length += board->side[sides[k]].length;
    double s = CUFF_SLIT_AT * length;
    while (i + 1 < n && s > board->side[sides[i]].length) s -= board->side[sides[i++]].length;
    const double slit = CUFF_SLIT * mus__measures_scale(&half->measures);
    mus__board_at(board, sides[i], s, line, along);
    line[2] = line[0] - slit * along[1], line[3] = line[1] + slit * along[0];
    mus__board_mark_add(board, board->side[sides[i]].panel, "slit", 2, line);
}


/* opens a cuff at the seam of its ends: that behind lies under */
static void cuff_opens(mus__half *half, int32_t seam, int32_t over, int32_t under)
{
    mus__board *board = &half->board;
    const double lap = CUFF_LAP * mus__measures_scale(&half->measures);
    if (board->status != MUS_OK) return;
    board->seam[seam].closure = MUS_CLOSURE_BUTTONS;
    mus__closure_lap(board, under, lap, "underlap");
    mus__closure_button(board, under, 0.5 * lap, "button");
    mus__closure_button(board, over, -0.5 * lap, "buttonhole");
}


/* whether the sleeve ends at the wrist */
static bool cuff_long(const mus__half *half)
{
    const int32_t sleeve = half->style.option[MUS__AXIS_SLEEVE];
    return sleeve == MUS__SLEEVE_LONG || sleeve == MUS__SLEEVE_BISHOP || sleeve == MUS__SLEEVE_GIGOT ||
           sleeve == MUS__SLEEVE_RAGLAN;
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

    /* the band, front at x < 0 */
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
    board->side[side[0]].attr.allowance = depth + MUS__SEAM_ALLOWANCE;
    mus__closure_fold(board, side[0], 0.0);
    const bool rib = mus__style_is(half, MUS__AXIS_CUFF, MUS__CUFF_RIB);
    mus__half_cut(half, panel, rib ? 0 : 1, rib ? MUS_MATERIAL_RIB : MUS_MATERIAL_INTERFACING, 1);
    mus__half_band_grain(half, panel);
    const int32_t ends = mus__board_seam_add(board, side[3], side[1], MUS_SEAM_REVERSED, 0.0);
    if (!rib && cuff_long(half)) {
        cuff_slit(half, n, sides);
        cuff_opens(half, ends, side[3], side[1]);
    }
    for (int32_t i = 0; i < n; i++) board->side[sides[i]].attr.allowance = MUS__SEAM_ALLOWANCE;
    mus__board_sew(board, 1, &side[2], n, sides);
    mus__panel_place_arm(half, panel, 0.0, down, length);
}
