/*
 * pocket.c: pockets: where they go on the half, and on the whole garment the pieces themselves.
 *
 * A patch lies on another panel; at three of its edges three sheets meet (board_patch_panel.c). On the half a pocket is
 * a mark, on the chest, below the hip line behind, on the thigh of the front of a skirt. On the whole garment each mark
 * gets a panel; the mark stays and shows where to sew it. A panel that is too small for the pocket keeps the mark
 * alone. So does the seat of trousers: its cloth is tight, and a panel of the same length on it does not come to rest
 * with self-contact (jeans at 20 mm: residual 0.26). A pocket changes neither openings nor genus.
 *
 * A kangaroo pocket lies on the front of a top across its centre, above the hem or with its lower edge in the seam of a
 * rib. It is a mark, and a piece that is cut (lib/finish): of its six edges two slanted ones are open,
 *
 *        centre --- top        half of it: the upper edge, the opening, the side below it, the lower edge
 *              |      \
 *              |       |
 *               -------
 *
 * A welt or a flap hides a slit into a bag: a mark alone, its rectangle, on the hip of a top, above the seat of
 * trousers, on the front of a skirt. What it is made of is not draped (lib/finish).
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "board/board_patch_panel.h"
#include "pocket/pocket.h"

#define POCKET_STEP (1.0 * MUS__CM) /* [m] a pocket that would leave its panel is moved by steps of this; chosen */
#define POCKET_MOVES 8
#define KANGAROO_PART 0.8              /* of half the hem that it takes at most; chosen: it ends before the side seam */


/* moves the mark by at most POCKET_MOVES steps each way, shortest way first, until it lies within its panel */
static void pocket_within(mus__half *half, int32_t panel, double *xy)
{
    const double step = POCKET_STEP * mus__lower_scale(half), w = xy[4] - xy[0], h = xy[1] - xy[3];
    for (int32_t far = 0; far <= 2 * POCKET_MOVES; far++)
        for (int32_t i = -far; i <= far; i++)
            for (int32_t sign = -1; sign <= 1; sign += 2) {
                const int32_t j = sign * (far - abs(i));
                const double x = xy[0] + i * step, y = xy[1] + j * step;
                if (abs(i) > POCKET_MOVES || abs(j) > POCKET_MOVES) continue;
                double all[16] = {x, y, x, y - 0.5 * h, x, y - h, x + 0.5 * w, y - h,
                                  x + w, y - h, x + w, y - 0.5 * h, x + w, y, x + 0.5 * w, y};
                if (!mus__board_patch_fits(&half->board, panel, 8, all)) continue;
                for (int32_t k = 0; k < 5; k++) xy[2 * k] += i * step, xy[2 * k + 1] += j * step;
                return;
            }
}


typedef struct pocket_kind {
    const char *name;
    double width, height; /* [cm] */
} pocket_kind;


/* a patch of a shirt holds a card, one of jeans a hand, as the trade has them: 11.5 x 13, 14 x 15 cm */
static pocket_kind pocket_of(const mus__half *half)
{
    static const pocket_kind kinds[] = {
        {"", 0.0, 0.0}, {"pocket", 13.0, 15.0}, {"welt", 14.0, 2.0}, {"flap", 15.0, 5.5}, {"", 0.0, 0.0}};
    static const pocket_kind chest = {"pocket", 11.5, 13.0}, seat = {"pocket", 14.0, 15.0};
    const int32_t garment = half->style.option[MUS__AXIS_GARMENT], kind = half->style.option[MUS__AXIS_POCKET];
    if (kind != MUS__POCKET_PATCH || garment == MUS__GARMENT_SKIRT || garment == MUS__GARMENT_DRESS) return kinds[kind];
    return garment == MUS__GARMENT_TOP ? chest : seat;
}


/* marks a pocket; centre (x, y) of its top, a back is drawn at x < 0 */
static void pocket_mark(mus__half *half, const char *name, double x, double y)
{
    const int32_t panel = mus__board_find_panel(&half->board, name);
    if (half->board.status != MUS_OK || panel == MUS_NONE) return;
    const pocket_kind kind = pocket_of(half);
    const double scale = mus__lower_scale(half), w = 0.5 * kind.width * MUS__CM * scale;
    const double h = kind.height * MUS__CM * scale;
    double xy[10] = {x - w, y, x - w, y - h, x + w, y - h, x + w, y, x - w, y};
    pocket_within(half, panel, xy);
    mus__board_mark_add(&half->board, panel, kind.name, 5, xy);
}


/* half a kangaroo pocket from the centre of its upper edge over the opening to the centre of its lower one [cm]; as
 * those of the trade */
static const double kangaroo[5][2] = {{0.0, 21.0}, {12.0, 21.0}, {18.0, 6.0}, {18.0, 0.0}, {0.0, 0.0}};


/* marks it with its lower edge in the seam of a rib, or a seam's width above what a hem turns up */
static void pocket_kangaroo(mus__half *half)
{
    mus__board *board = &half->board;
    const int32_t panel = mus__board_find_panel(board, "front"), cf = mus__board_find(board, panel, "cf");
    if (board->status != MUS_OK || panel == MUS_NONE || cf == MUS_NONE) return;
    const mus__board_side *hem = &board->side[board->side[cf].next];
    const bool ribbed = mus__style_is(half, MUS__AXIS_HEM, MUS__HEM_RIBBED);
    const double cm = mus__measures_scale(&half->measures) * MUS__CM, *top = mus__board_start(board, cf);
    const double *foot = mus__board_end(board, cf), *side = mus__board_end(board, board->side[cf].next);
    const double low = foot[1] + (ribbed ? 0.0 : hem->attr.allowance + MUS__SEAM_ALLOWANCE);
    const double room[2] = {KANGAROO_PART * fabs(side[0] - foot[0]), KANGAROO_PART * (top[1] - low)};
    const double scale = fmin(cm, fmin(room[0] / kangaroo[3][0], room[1] / kangaroo[0][1]));
    double xy[10];
    for (int32_t i = 0; i < 5; i++) {
        xy[2 * i] = foot[0] + scale * kangaroo[i][0];
        xy[2 * i + 1] = low + scale * kangaroo[i][1];
    }
    mus__board_mark_add(board, panel, "kangaroo pocket", 5, xy);
}


void mus__pocket_attach(mus__half *half)
{
    if (half->style.option[MUS__AXIS_POCKET] == MUS__POCKET_NONE) return;
    if (mus__style_is(half, MUS__AXIS_POCKET, MUS__POCKET_KANGAROO)) {
        pocket_kangaroo(half);
        return;
    }
    const bool patch = half->style.option[MUS__AXIS_POCKET] == MUS__POCKET_PATCH;
    const int32_t length = half->style.option[MUS__AXIS_TOP_LENGTH];
    const bool hips = length == MUS__TOP_LENGTH_HIP || length == MUS__TOP_LENGTH_TUNIC;
    const double *m = half->measures.v, scale = mus__lower_scale(half), hip = m[MUS_MEASURE_HIP];
    const double low = (patch ? -0.55 : -0.5) * m[MUS_MEASURE_WAIST_TO_HIP];
    const double top = patch ? 0.26 * scale : hips ? -0.2 * m[MUS_MEASURE_WAIST_TO_HIP] : 0.05 * scale;
    switch (half->style.option[MUS__AXIS_GARMENT]) {
    case MUS__GARMENT_TROUSERS:
    case MUS__GARMENT_JUMPSUIT: pocket_mark(half, "leg_back", (patch ? -0.11 : -0.13) * hip, low); break;
    case MUS__GARMENT_SKIRT:
    case MUS__GARMENT_DRESS: pocket_mark(half, "skirt_front", 0.13 * hip, low); break;
    case MUS__GARMENT_TOP: pocket_mark(half, "front", (patch ? 0.11 : 0.14) * m[MUS_MEASURE_BUST], top); break;
    default: break;
    }
}


/* the piece of mark i; the second on a panel, or on its mirror image, is that of the right */
static void pocket_piece(mus__board *board, int32_t i, int32_t *left)
{
    const int32_t panel = board->mark[i].panel;
    const char *name = *left == MUS_NONE ? "pocket_left" : "pocket_right";
    const int32_t made = mus__board_patch(board, panel, 4, board->mark[i].xy, name);
    const int32_t mouth = made == MUS_NONE ? MUS_NONE : mus__board_find(board, made, "mouth");
    if (mouth == MUS_NONE) return;
    board->side[mouth].attr.allowance = MUS__HEM_ALLOWANCE;
    if (*left == MUS_NONE) {
        *left = made;
        return;
    }
    board->panel[made].mirror_of = *left;
    mus__board_add_cut(board, *left, board->panel[made].attr.cut, 1);
}


void mus__pocket_finish(mus__half *half)
{
    mus__board *board = &half->board;
    int32_t left = MUS_NONE;
    const int32_t garment = half->style.option[MUS__AXIS_GARMENT];
    if (garment == MUS__GARMENT_TROUSERS || garment == MUS__GARMENT_JUMPSUIT) return;
    const int32_t nmark = board->nmark;
    for (int32_t i = 0; i < nmark && board->status == MUS_OK; i++) {
        const mus__board_mark *mark = &board->mark[i];
        if (mark->panel != MUS_NONE && mark->n == 5 && strcmp(mark->name, "pocket") == 0 &&
            mus__board_patch_fits(board, mark->panel, 4, mark->xy))
            pocket_piece(board, i, &left);
    }
}
