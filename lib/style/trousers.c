/*
 * trousers.c: the left leg of trousers by its words: widths of the leg, where it is cut, its rib.
 *
 *   straight  knee + 6 or calf + 4, hem 4 cm narrower      wide     as wide as on the crotch line all the way down
 *   tapered   knee + 3, hem as the foot allows             culotte  wider still below
 *   bootcut   hem 5 cm wider than the knee                 jogger   hem gathered into a rib
 *   flare     hem 15 cm wider                              harem    crotch 10 cm lower, gathered into a rib
 *   yoke      no dart in front, the darts of the back closed into a yoke: jeans
 *   leggings  close trousers of a knit: hip, thigh, knee and ankle narrower than the body, no ease in the rise
 *
 * Front and back are sewn at inseam and outseam; the crotch sides are centre seams, which the doubling sews. Under a
 * bodice the waist is sewn to its waist, the rise 3 cm longer, since shoulder and crotch are then tied to each other.
 * Formulas: man page mus_design(3).
 */
#include <math.h>
#include <string.h>

#include "block/block_trousers.h"
#include "geom/vec.h"
#include "style/waist_edge.h"


bool mus__trousers_close(const mus__half *half)
{
    return mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TROUSERS) &&
           mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_KNIT) && mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_SLIM);
}


/* garment girths of knee and hem of legs that follow the leg; what the crotch line has for those that hang from it */
static void trousers_leg(const mus__half *half, mus__trousers_def *def)
{
    const double *m = half->measures.v, scale = mus__lower_scale(half);
    const double knee = fmax(m[MUS_MEASURE_KNEE] + 6.0 * MUS__CM, m[MUS_MEASURE_CALF] + 4.0 * MUS__CM);
    const double hem = fmax(knee - 4.0 * MUS__CM, 1.55 * m[MUS_MEASURE_ANKLE]);
    const double hip = fmax(def->hip, 0.97 * def->waist);
    const double front = (hip + def->hip_ease) / 4.0 - 1.0 * MUS__CM + hip / 20.0;
    const double back = (hip + def->hip_ease) / 4.0 + 2.0 * MUS__CM + hip / 10.0;
    mus__trousers_widths(def, knee, hem);
    switch (half->style.option[MUS__AXIS_LEG]) {
    case MUS__LEG_TAPERED:
        mus__trousers_widths(def, fmax(m[MUS_MEASURE_KNEE] + 3.0 * MUS__CM, m[MUS_MEASURE_CALF] + 3.0 * MUS__CM),
                             1.5 * m[MUS_MEASURE_ANKLE]);
        break;
    case MUS__LEG_BOOTCUT: mus__trousers_widths(def, knee - 1.0 * MUS__CM, knee + 4.0 * scale * MUS__CM); break;
    case MUS__LEG_FLARE:
        mus__trousers_widths(def, knee - 2.0 * MUS__CM, fmax(hem + 4.0 * MUS__CM, knee + 13.0 * scale * MUS__CM));
        break;
    case MUS__LEG_WIDE:
        def->knee[0] = def->hem[0] = 0.95 * front;
        def->knee[1] = def->hem[1] = 0.95 * back;
        break;
    case MUS__LEG_CULOTTE:
        def->knee[0] = 1.04 * front, def->hem[0] = 1.12 * front;
        def->knee[1] = 1.04 * back, def->hem[1] = 1.12 * back;
        break;
    case MUS__LEG_JOGGER: mus__trousers_widths(def, knee + 2.0 * scale * MUS__CM, hem); break;
    case MUS__LEG_HAREM: mus__trousers_widths(def, 0.72 * (front + back), 0.55 * (front + back)); break;
    default: break;
    }
    if (!mus__trousers_close(half)) return;
    const bool follows = half->style.option[MUS__AXIS_LEG] == MUS__LEG_TAPERED;
    mus__trousers_widths(def, MUS__CLOSE_GIRTH * fmax(m[MUS_MEASURE_KNEE], m[MUS_MEASURE_CALF]),
                         follows ? MUS__CLOSE_GIRTH * m[MUS_MEASURE_ANKLE] : def->hem[0] + def->hem[1]);
}


static bool trousers_ribbed(const mus__half *half)
{
    const int32_t leg = half->style.option[MUS__AXIS_LEG];
    return leg == MUS__LEG_JOGGER || leg == MUS__LEG_HAREM;
}


/* whether the back has a yoke; that of a jumpsuit is its bodice's */
static bool trousers_yoked(const mus__half *half)
{
    return mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TROUSERS) &&
           mus__style_is(half, MUS__AXIS_YOKE, MUS__YOKE_YOKE);
}


/* the block for this half */
static mus__trousers_def trousers_block(const mus__half *half)
{
    /* parts of the inleg: full, short, bermuda, capri, ankle */
    static const double end[] = {1.0, 0.16, 0.40, 0.68, 0.91};
    const double *m = half->measures.v, level = mus__lower_level(half), scale = mus__lower_scale(half);
    const int32_t leg = half->style.option[MUS__AXIS_LEG], length = half->style.option[MUS__AXIS_LEG_LENGTH];
    const bool close = mus__trousers_close(half);
    mus__trousers_def def;
    memset(&def, 0, sizeof def);
    def.waist = m[MUS_MEASURE_WAIST];
    def.hip = m[MUS_MEASURE_HIP];
    def.hip_ease = half->hip_ease + (leg == MUS__LEG_HAREM ? 8.0 * scale * MUS__CM : 0.0);
    def.top = level;
    def.net[0] = mus__lower_net(half, true, level, -0.5 * MUS__CM);
    def.net[1] = mus__lower_net(half, false, level, -0.5 * MUS__CM);
    def.darts = true;
    def.yoke = trousers_yoked(half);
    if (!mus__lower_has_top(half) && half->style.option[MUS__AXIS_BAND] == MUS__BAND_ELASTIC) {
        /* drawn up by the elastic, no darts */
        const double hip = fmax(m[MUS_MEASURE_HIP], m[MUS_MEASURE_WAIST]);
        const double wide = close ? 0.25 * MUS__CLOSE_GIRTH * hip : 0.5 * mus__lower_pulled(half);
        def.net[0] = fmax(def.net[0], wide - 0.5 * MUS__CM);
        def.net[1] = fmax(def.net[1], wide + 0.5 * MUS__CM);
        def.darts = false;
    }

    /* crotch and leg */
    const double room = (close ? 0.0 : 1.0 * MUS__CM) + (mus__lower_has_top(half) ? 2.0 * MUS__CM : 0.0);
    def.rise = m[MUS_MEASURE_RISE] + room;
    def.inleg = m[MUS_MEASURE_INLEG] - 2.0 * MUS__CM - fmax(0.0, room - 1.0 * MUS__CM);
    def.thigh = close ? MUS__CLOSE_GIRTH * m[MUS_MEASURE_THIGH] : m[MUS_MEASURE_THIGH] + 3.0 * MUS__CM;
    def.clings = close;
    trousers_leg(half, &def);
    if (leg == MUS__LEG_HAREM) {
        const double drop = 10.0 * scale * MUS__CM;
        def.rise += drop;
        def.inleg -= drop;
    }
    def.end = end[length];
    if (trousers_ribbed(half)) {
        /* the rib goes round the ankle, the leg falls 2 cm over it */
        const double low = (length == MUS__LEG_LENGTH_FULL ? 0.050 : 0.080) * m[MUS_MEASURE_STATURE];
        const double above = low + scale * (MUS__RIB_HEIGHT - MUS__RIB_BLOUSE);
        def.end = fmax(0.2, fmin(1.0, (m[MUS_MEASURE_WAIST_HEIGHT] - def.rise - above) / def.inleg));
    }
    return def;
}


/* parts of the waist line between the darts, from the centre outwards */
static void trousers_waist(const mus__trousers_half *block, mus__chain *part)
{
    if (block->ndart == 0) mus__chain_line(&part[0], block->centre, block->side);
    for (int32_t d = 0; block->ndart > 0 && d <= block->ndart; d++) mus__chain_cubic(&part[d], block->waist[d]);
}


/* the yoke of the back: seam, side up, waist, centre down */
static int32_t trousers_yoke_draw(mus__half *half, const mus__trousers_yoke *yoke)
{
    mus__outline outline;
    mus__chain chain;
    mus__outline_begin(&outline);
    mus__chain_cubic(&chain, yoke->seam);
    mus__outline_add(&outline, "yoke", "", MUS__SEAM_ALLOWANCE, &chain);
    chain = yoke->side;
    mus__chain_reverse(&chain);
    mus__outline_add(&outline, "outseam", "side", MUS__SEAM_ALLOWANCE, &chain);
    mus__chain_cubic(&chain, yoke->waist);
    mus__lower_top(&outline, 0, NULL, &chain);
    mus__outline_line(&outline, "centre", "centre", MUS__SEAM_ALLOWANCE, yoke->centre, yoke->centre + 2);
    const int32_t panel = mus__outline_panel(half, &outline, "back_yoke", "leg", true);
    mus__half_centre(half, panel, "centre", MUS__CENTRE_SEAM);
    return panel;
}


/* the top of a leg: its waist, or the seam of its yoke, whose side it ends at */
static void trousers_top(mus__outline *outline, const mus__trousers_half *block)
{
    mus__chain part[MUS__DARTS + 1];
    if (block->yoke.cut) {
        mus__outline_line(outline, "yoke", "", MUS__SEAM_ALLOWANCE, block->yoke.top + 2, block->yoke.top);
        return;
    }
    trousers_waist(block, part);
    mus__lower_top(outline, block->ndart, block->dart, part);
}


/* hem, outseam up, waist, centre and crotch down, inseam down */
static int32_t trousers_draw(mus__half *half, const mus__trousers_half *block, bool front)
{
    mus__outline outline;
    mus__chain chain, crotch;
    mus__outline_begin(&outline);
    mus__chain_cubic(&chain, block->hem);
    mus__outline_add(&outline, "hem", "hem", 4.0 * MUS__CM, &chain);
    chain = block->outseam;
    mus__chain_reverse(&chain);
    if (block->yoke.cut)
        mus__chain_cut(&chain, mus__chain_length(&chain) - mus__chain_length(&block->yoke.side), &chain);
    mus__outline_add(&outline, "outseam", "side", MUS__SEAM_ALLOWANCE, &chain);
    trousers_top(&outline, block);
    mus__chain_line(&chain, block->yoke.cut ? block->yoke.top : block->centre, block->centre + 2);
    mus__chain_cubic(&crotch, block->crotch);
    mus__chain_append(&chain, &crotch);
    mus__outline_add(&outline, "crotch", "centre", MUS__SEAM_ALLOWANCE, &chain);
    mus__outline_add(&outline, "inseam", "inseam", MUS__SEAM_ALLOWANCE, &block->inseam);
    const int32_t panel = mus__outline_panel(half, &outline, front ? "leg_front" : "leg_back", "leg", !front);
    mus__half_centre(half, panel, "crotch", MUS__CENTRE_SEAM);
    mus__half_darts(half, panel);

    /* knee notches of the seams, on the front; arc lengths are from the hem */
    if (!front) return panel;
    const int32_t in = mus__board_find(&half->board, panel, "inseam");
    const int32_t out = mus__board_find(&half->board, panel, "outseam");
    if (block->knee_in > 1.0 * MUS__CM)
        mus__board_notch_add(&half->board, in, block->inseam_length - block->knee_in, MUS_NOTCH_SINGLE);
    if (block->knee_out > 1.0 * MUS__CM)
        mus__board_notch_add(&half->board, out, block->knee_out, MUS_NOTCH_SINGLE);
    return panel;
}


/* the rib: round the ankle, closed at the inseam, the leg gathered into it; turned in along its hem, whose allowance is
 * the inner layer */
static void trousers_rib(mus__half *half, const mus__trousers *block, int32_t front, int32_t back)
{
    mus__board *board = &half->board;
    const double *m = half->measures.v, scale = mus__lower_scale(half), height = MUS__RIB_HEIGHT * scale;
    const double w = 0.5 * (m[MUS_MEASURE_ANKLE] + 3.0 * scale * MUS__CM), top = block->front.hem[7];
    const double bottom = top - height;
    const double a[2] = {-w, bottom}, b[2] = {w, bottom}, c[2] = {w, top}, d[2] = {-w, top};
    mus__outline outline;
    mus__outline_begin(&outline);
    mus__outline_line(&outline, "hem", "hem", height + MUS__SEAM_ALLOWANCE, a, b);
    mus__outline_line(&outline, "end_back", "inseam", MUS__SEAM_ALLOWANCE, b, c);
    mus__outline_line(&outline, "top", "cuff", MUS__SEAM_ALLOWANCE, c, d);
    mus__outline_line(&outline, "end_front", "inseam", MUS__SEAM_ALLOWANCE, d, a);
    const int32_t rib = mus__outline_panel(half, &outline, "leg_rib", "rib", false);
    mus__half_sew(half, rib, "end_back", rib, "end_front", 0.0);
    mus__half_cut(half, rib, 0, MUS_MATERIAL_RIB, 1);
    const int32_t hems[2] = {mus__board_find(board, front, "hem"), mus__board_find(board, back, "hem")};
    const int32_t tops[1] = {mus__board_find(board, rib, "top")};
    if (board->status != MUS_OK) return;
    mus__board_rename(board, hems[0], "hem", "cuff");
    mus__board_rename(board, hems[1], "hem", "cuff");
    for (int32_t i = 0; i < 2; i++) board->side[hems[i]].attr.allowance = MUS__SEAM_ALLOWANCE;
    mus__board_sew(board, 2, hems, 1, tops);

    /* rolled about the leg with room for the heel, its middle at the outside */
    const double radius = w / MUS_PI + 0.03;
    const double origin[3] = {0.065 * m[MUS_MEASURE_STATURE] + radius, half->waist_level + MUS__RIB_BLOUSE * scale,
                              -0.025 * m[MUS_MEASURE_STATURE]};
    mus__lower_place(half, rib, 0.5 * MUS_PI, 0.0, origin, radius);
}


/* sews the outseam, and the yoke (MUS_NONE: none) to the back */
static void trousers_outseam(mus__half *half, int32_t front, int32_t back, int32_t yoke)
{
    mus__board *board = &half->board;
    if (yoke == MUS_NONE) {
        mus__half_sew(half, front, "outseam", back, "outseam", 0.0);
        return;
    }
    mus__half_sew(half, back, "yoke", yoke, "yoke", 0.0);
    const int32_t out[1] = {mus__board_find(board, front, "outseam")};
    const int32_t behind[2] = {mus__board_find(board, yoke, "outseam"), mus__board_find(board, back, "outseam")};
    if (board->status == MUS_OK) mus__board_sew(board, 1, out, 2, behind);
}


void mus__trousers_attach(mus__half *half)
{
    const int32_t first = half->board.npanel;
    if (half->board.status != MUS_OK) return;
    const mus__trousers_def def = trousers_block(half);
    mus__trousers block;
    const mus_status status = mus__trousers_draft(half->context, &def, &block);
    mus__half_failed(half, status);
    if (status != MUS_OK) return;
    const int32_t front = trousers_draw(half, &block.front, true), back = trousers_draw(half, &block.back, false);
    const int32_t yoke = block.back.yoke.cut ? trousers_yoke_draw(half, &block.back.yoke) : MUS_NONE;
    trousers_outseam(half, front, back, yoke);
    mus__half_sew(half, front, "inseam", back, "inseam", 0.0);

    /* a hem that goes round the whole foot starts before the toes */
    const double *m = half->measures.v, foot = m[MUS_MEASURE_FOOT];
    const double toes = def.hem[0] + def.hem[1] > 2.2 * foot ? 0.115 * m[MUS_MEASURE_STATURE] + 0.04 : 0.0;
    mus__lower_place_leg(half, front, true, block.front.crease, block.front.crease + block.front.fork, block.thigh,
                         toes);
    for (int32_t i = 0; i < (yoke == MUS_NONE ? 1 : 2); i++)
        mus__lower_place_leg(half, i == 0 ? back : yoke, false, block.back.crease, block.back.crease + block.back.fork,
                             block.thigh, 0.0);
    if (trousers_ribbed(half)) trousers_rib(half, &block, front, back);
    mus__lower_waist_sew(half, first);
}
