/*
 * pocket.c: patch pockets: where they go on the half, and on the whole garment the pieces themselves.
 *
 * A patch is a third sheet on the garment: at three of its sides three sheets meet (board_patch.c). On the half it is
 * a line, 13 x 15 cm, below the hip line behind, on the thigh of a skirt's front. Once the garment is whole, each such
 * line gets its piece; the line stays as the mark on paper of where it is laid. It changes no opening and no handle
 * (drafting.md section 8).
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "design/lower.h"


/* centre (x, y) of the pocket's top, half its width, its height; a back is drawn at x < 0 */
static void pocket_mark(mus__half *half, const char *name, double x, double y)
{
    const int32_t panel = mus__board_find_panel(&half->board, name);
    if (half->board.status != MUS_OK || panel == MUS_NONE) return;
    const double scale = mus__lower_scale(half), w = 6.5 * MUS__CM * scale, h = 15.0 * MUS__CM * scale;
    const double xy[10] = {x - w, y, x - w, y - h, x + w, y - h, x + w, y, x - w, y};
    mus__board_mark_add(&half->board, panel, "pocket", 5, xy);
}


void mus__pocket_attach(mus__half *half)
{
    if (half->style.option[MUS__AXIS_POCKET] != MUS__POCKET_PATCH) return;
    const double *m = half->measures.v, scale = mus__lower_scale(half), hip = m[MUS_MEASURE_HIP];
    const double low = -0.55 * m[MUS_MEASURE_WAIST_TO_HIP];
    switch (half->style.option[MUS__AXIS_GARMENT]) {
    case MUS__GARMENT_TROUSERS:
    case MUS__GARMENT_JUMPSUIT: pocket_mark(half, "leg_back", -0.13 * hip, low); break;
    case MUS__GARMENT_SKIRT:
    case MUS__GARMENT_DRESS: pocket_mark(half, "skirt_front", 0.13 * hip, low); break;
    case MUS__GARMENT_TOP: pocket_mark(half, "front", 0.11 * m[MUS_MEASURE_BUST], 0.26 * scale); break;
    default: break;
    }
}


/* the piece of mark i; the second on a panel, or on its mirror image, is that of the right */
static void pocket_piece(mus__board *board, int32_t i, int32_t *left)
{
    const int32_t panel = board->mark[i].panel;
    const char *name = *left == MUS_NONE ? "pocket_left" : "pocket_right";
    const int32_t made = mus__board_patch(board, panel, 4, board->mark[i].xy, name);
    if (made == MUS_NONE) return;
    if (*left == MUS_NONE) {
        *left = made;
        return;
    }
    board->panel[made].mirror_of = *left;
    board->panel[*left].cut_count += board->panel[made].cut_count;
}


void mus__pocket_finish(mus__half *half)
{
    mus__board *board = &half->board;
    int32_t left = MUS_NONE;
    const int32_t nmark = board->nmark;
    for (int32_t i = 0; i < nmark && board->status == MUS_OK; i++) {
        const mus__board_mark *mark = &board->mark[i];
        if (mark->panel != MUS_NONE && mark->n == 5 && strcmp(mark->name, "pocket") == 0) pocket_piece(board, i, &left);
    }
}
