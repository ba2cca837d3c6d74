/*
 * collar.c: standing collars, drafted to the neckline on the cutting table: mandarin, shirt (a stand and the leaf that
 * falls over it) and turtleneck. mus__collar_attach() is where a collar word is looked up: a new collar is added there.
 *
 * The bottom edge has the length of half the neckline, centre back to centre front, over all its panels. The collar is
 * cut on the fold behind, or in front when the garment opens behind. Its other ends are free, except those of the
 * turtleneck, which are sewn to a ring. The free edge of the collar is then the neck opening, with the label "neck".
 * Stand and leaf are cut twice, an outer and an inner layer, and once of interfacing. A turtleneck is cut once, of rib
 * when the garment is a knit, and turned in along its free edge: the allowance there is the inner layer.
 */
#include <math.h>
#include <string.h>

#include "closure/closure.h"
#include "style/collar.h"


/* height of the lower edge of a collar above the floor [m]: between the nape and the pit of the neck */
static double collar_height(const mus__half *half)
{
    return half->skeleton.neck_side;
}


/* height above the floor of the highest place of the panels at the neckline where they are placed [m] */
static double collar_over(const mus__half *half, const mus__boundary *loop)
{
    double y[2] = {INFINITY, -INFINITY};
    for (int32_t k = 0; k < loop->n; k++)
        mus__panel_heights(&half->board, half->board.side[loop->side[k]].panel, y);
    return y[1];
}


/* places a ring round the neck outside the panels that it is sewn to */
static double collar_girth(const mus__half *half, const mus__neck *neck)
{
    return fmax(2.0 * neck->length, half->measures.v[MUS_MEASURE_NECK]) + 4.0 * MUS__CM;
}


/* Four sides: bottom (centre back or front to the other end, x >= 0), its free end, top, centre. With `front` the
 * centre is that of the front and the drawing the wearer's left as it is; else it is mirrored. sides: bottom, end, top,
 * centre */
static int32_t collar_band(mus__half *half, const char *name, const mus__chain *bottom, const mus__chain *top,
                           bool front, int32_t *sides)
{
    mus__board *board = &half->board;
    mus__chain low = *bottom, high = *top, end, centre;
    if (!front) {
        mus__chain_mirror(&low);
        mus__chain_mirror(&high);
    }
    mus__chain_reverse(&high);
    const double *start = low.xy, *stop = low.xy + 2 * (low.nxy - 1);
    const double *high_start = high.xy, *high_stop = high.xy + 2 * (high.nxy - 1);
    mus__chain_line(front ? &end : &centre, stop, high_start);
    mus__chain_line(front ? &centre : &end, high_stop, start);
    const int32_t panel = mus__board_panel_add(board, name, "collar");
    sides[0] = mus__chain_side(board, panel, "bottom", NULL, MUS__COLLAR_SEAM, &low);
    if (front) sides[1] = mus__chain_side(board, panel, "cb", "neck", MUS__COLLAR_SEAM, &end);
    else sides[3] = mus__chain_side(board, panel, "cb", "centre", MUS__COLLAR_SEAM, &centre);
    sides[2] = mus__chain_side(board, panel, "top", "neck", MUS__COLLAR_SEAM, &high);
    if (front) sides[3] = mus__chain_side(board, panel, "cf", "centre", MUS__COLLAR_SEAM, &centre);
    else sides[1] = mus__chain_side(board, panel, "end", "neck", MUS__COLLAR_SEAM, &end);
    mus__board_panel_close(board, panel);
    if (board->status == MUS_OK) board->side[sides[3]].centre = MUS__CENTRE_FOLD;
    mus__half_cut(half, panel, 2, MUS_MATERIAL_INTERFACING, 1);
    mus__half_band_grain(half, panel);
    return panel;
}


/* a stand of `height` on the neckline, which starts `above` it; sides as those of a band */
static int32_t collar_stand(mus__half *half, mus__neck *neck, double height, double above, mus__stand *stand,
                            int32_t *sides)
{
    mus__board *board = &half->board;
    const double k = mus__measures_scale(&half->measures);
    const mus__stand_def def = {.length = neck->length, .height = height, .rise = 1.5 * k * MUS__CM};
    if (board->status != MUS_OK) return MUS_NONE;
    board->status = mus__stand_draft(half->context, &def, stand);
    if (board->status != MUS_OK) return MUS_NONE;
    mus__chain bottom, top;
    mus__chain_cubic(&bottom, stand->bottom);
    mus__chain_cubic(&top, stand->top);
    const int32_t panel = collar_band(half, "collar", &bottom, &top, neck->back_open, sides);
    mus__board_sew(board, 1, sides, neck->loop.n, neck->loop.side);
    mus__panel_place_ring(half, panel, neck->back_open, collar_girth(half, neck), collar_height(half) + above);
    return panel;
}


/* stand and leaf; the leaf starts turned down outside the stand, both so high that the panels at the neckline, which
 * are drawn back over the shoulders as these are sewn, pass below the points of the leaf */
static void collar_shirt(mus__half *half, mus__neck *neck)
{
    mus__board *board = &half->board;
    const double k = mus__measures_scale(&half->measures), height = 3.0 * k * MUS__CM;
    const double fall = height + 1.2 * k * MUS__CM, point = 7.0 * k * MUS__CM;
    const double above = fmax(fall, collar_over(half, &neck->loop) + point - height - collar_height(half));
    mus__stand stand;
    mus__leaf leaf;
    int32_t sides[4], leaf_sides[4];
    collar_stand(half, neck, height, above, &stand, sides);
    if (board->status != MUS_OK) return;

    /* the ends of the stand lap over the centre front as the fronts do */
    mus__closure_fasten(board, sides[1]);
    mus__closure_lap(board, sides[1], MUS__BUTTON_STAND, "stand end");
    const mus__leaf_def def = {.length = stand.top_length, .fall = fall,
                               .point = point, .rise = -1.0 * k * MUS__CM};
    board->status = mus__leaf_draft(half->context, &def, &leaf);
    if (board->status != MUS_OK) return;

    /* drawn as it goes on upwards from the stand: half a turn of the block, mirrored as all that has its fold behind */
    mus__chain inner, outer;
    mus__chain_cubic(&inner, leaf.inner);
    mus__chain_cubic(&outer, leaf.outer);
    for (int32_t i = 0; i < inner.nxy; i++) inner.xy[2 * i + 1] *= -1.0;
    for (int32_t i = 0; i < outer.nxy; i++) outer.xy[2 * i + 1] *= -1.0;
    const int32_t panel = collar_band(half, "collar_leaf", &inner, &outer, neck->back_open, leaf_sides);
    mus__board_sew(board, 1, leaf_sides, 1, &sides[2]);
    mus__panel_place_ring(half, panel, neck->back_open, collar_girth(half, neck) + 6.0 * MUS__CM,
                          collar_height(half) + above + height);
    if (board->status != MUS_OK) return;

    board->panel[panel].attr.layer = MUS__COLLAR_LIES;
    /* about its inner edge: y and the right side the other way */
    mus_placement *place = &board->panel[panel].attr.placement;
    for (int32_t i = 0; i < 3; i++) place->rotation[3 * i + 1] *= -1.0, place->rotation[3 * i + 2] *= -1.0;
    place->bend *= -1.0;
}


static void collar_turtleneck(mus__half *half, mus__neck *neck)
{
    mus__board *board = &half->board;
    const double k = mus__measures_scale(&half->measures), x = MUS__RIB_PART * neck->length;
    const double corner[4][2] = {{0.0, 0.0}, {x, 0.0}, {0.0, 7.5 * k * MUS__CM}, {x, 7.5 * k * MUS__CM}};
    mus__chain bottom, top;
    int32_t sides[4];
    mus__chain_line(&bottom, corner[0], corner[1]);
    mus__chain_line(&top, corner[2], corner[3]);

    /* on the fold in front and sewn behind, or the other way round where the front opens */
    const int32_t panel = collar_band(half, "collar", &bottom, &top, !neck->front_open, sides);
    if (board->status != MUS_OK) return;
    board->side[sides[1]].centre = MUS__CENTRE_SEAM;
    board->side[sides[2]].attr.allowance = corner[2][1] + MUS__COLLAR_SEAM;
    mus__closure_fold(board, sides[2], 0.0);
    const bool knit = mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_KNIT);
    mus__half_cut(half, panel, 1, MUS_MATERIAL_INTERFACING, 0);
    if (knit) mus__half_cut(half, panel, 0, MUS_MATERIAL_RIB, 1);
    mus__board_rename(board, sides[1], board->side[sides[1]].name, "centre");
    mus__board_sew(board, 1, sides, neck->loop.n, neck->loop.side);
    mus__panel_place_ring(half, panel, !neck->front_open, 2.0 * x + 3.0 * MUS__CM, collar_height(half));
}


/* whether the garment opens at the centre line that half-edge `side` ends or begins at */
static bool collar_opens(const mus__half *half, int32_t side, int32_t closure)
{
    const int32_t centre = half->board.side[side].centre;
    return centre == MUS__CENTRE_OPEN ||
           (centre == MUS__CENTRE_SEAM && half->style.option[MUS__AXIS_CLOSURE] == closure);
}


void mus__collar_attach(mus__half *half)
{
    mus__board *board = &half->board;
    const int32_t style = half->style.option[MUS__AXIS_COLLAR];
    const double k = mus__measures_scale(&half->measures);
    if (!mus__wraps(half)) mus__board_opening_add(board, "neck"); /* one with its edges and the hem */
    if (board->status != MUS_OK || style == MUS__COLLAR_NONE) return;
    mus__neck neck;
    mus__stand stand;
    int32_t sides[4];
    memset(&neck, 0, sizeof neck);
    mus__boundary_read(half, "neck", &neck.loop);
    if (board->status != MUS_OK) return;
    const mus__boundary *loop = &neck.loop;
    int32_t shoulder = mus__boundary_over(board, loop, "shoulder");
    if (shoulder == MUS_NONE) shoulder = mus__boundary_near(loop, 0.38, 0.15);
    neck.length = loop->s[loop->n];
    neck.shoulder = shoulder != MUS_NONE ? loop->s[shoulder] : 0.38 * neck.length;
    neck.back_open = collar_opens(half, board->side[loop->side[0]].prev, MUS__CLOSURE_BACK);
    neck.front_open = collar_opens(half, board->side[loop->side[loop->n - 1]].next, MUS__CLOSURE_FRONT);
    switch (style) {
    case MUS__COLLAR_MANDARIN: collar_stand(half, &neck, 3.5 * k * MUS__CM, 0.0, &stand, sides); break;
    case MUS__COLLAR_SHIRT: collar_shirt(half, &neck); break;
    case MUS__COLLAR_TURTLENECK: collar_turtleneck(half, &neck); break;
    case MUS__COLLAR_HOOD: mus__hood_attach(half, &neck); break;
    default: mus__collar_flat(half, &neck);
    }
}
