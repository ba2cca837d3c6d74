/*
 * skirt.c: the half of a skirt by its word; the straight skirts are drawn here.
 *
 * Each skirt draws its panels on the cutting table with the top edge labelled "waist", sews them to one another and
 * places them round the hips. Under a bodice the top edge is sewn to its waist. Formulas: man page mus_design(3).
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "block/block_skirt.h"
#include "closure/closure.h"
#include "style/waist_edge.h"

#define SKIRT_HEM_ALLOWANCE (4.0 * MUS__CM) /* [m] turned up at the hem of a straight skirt; dressmaking practice */


/* figures of the skirt block: under a bodice its waist has the length of the bodice's and its darts lie below them */
static mus__skirt_def skirt_block(const mus__half *half, double flare)
{
    const double *m = half->measures.v, level = mus__lower_level(half);
    const double front = mus__lower_net(half, true, level, 0.5 * MUS__CM);
    const double back = mus__lower_net(half, false, level, 0.5 * MUS__CM);
    mus__skirt_def def;
    memset(&def, 0, sizeof def);
    def.waist = 2.0 * (front + back);
    def.shift = 0.5 * (front - back) - 0.5 * MUS__CM;
    def.hip = fmax(m[MUS_MEASURE_HIP], 0.98 * m[MUS_MEASURE_WAIST]);
    def.depth = m[MUS_MEASURE_WAIST_TO_HIP] + level;
    def.hip_ease = half->hip_ease;
    def.length = mus__skirt_length(half);
    def.flare = flare;
    def.rise = 1.2 * MUS__CM * (def.depth / m[MUS_MEASURE_WAIST_TO_HIP]);
    def.darts = true;
    if (mus__lower_has_top(half)) {
        def.dart_at[0] = mus__lower_snap(half, true, 0.45 * front, 0.2 * front);
        def.dart_at[1] = mus__lower_snap(half, false, 0.45 * back, 0.2 * back);
    }
    return def;
}


/* parts of the waist between the darts, from the centre outwards */
static void skirt_waist_parts(const mus__skirt_half *block, mus__chain *part)
{
    double s0 = 0.0;
    for (int32_t d = 0; d <= block->ndart; d++) {
        const double s1 = d < block->ndart ? block->dart_s[d][0] : block->waist_length + block->dart_width;
        double cubic[8];
        mus__cubic_part(block->waist, s0, s1, cubic);
        if (d > 0) memcpy(cubic, block->dart[d - 1] + 4, 2 * sizeof *cubic);
        if (d < block->ndart) memcpy(cubic + 6, block->dart[d], 2 * sizeof *cubic);
        mus__chain_cubic(&part[d], cubic);
        if (d < block->ndart) s0 = block->dart_s[d][1];
    }
}


/* the side from hem to waist */
static void skirt_side_add(mus__outline *outline, const mus__skirt_half *block)
{
    mus__chain chain, low;
    mus__chain_cubic(&chain, block->side_high);
    mus__chain_cubic(&low, block->side_low);
    mus__chain_append(&chain, &low);
    mus__chain_reverse(&chain);
    mus__outline_add(outline, "side", "side", MUS__SEAM_ALLOWANCE, &chain);
}


/* notch of the side seam at the hip level; the outline runs up the side of a front */
static void skirt_side_notch(mus__half *half, int32_t panel, const mus__skirt_half *block)
{
    mus__board_notch_add(&half->board, mus__board_find(&half->board, panel, "side"),
                         block->side_length - block->side_high_length, MUS_NOTCH_SINGLE);
}


/* hem, side, waist with its darts, centre down to the slit (0: none), which makes it a seam; a back is cut in two
 * halves unless it is `whole` */
static int32_t skirt_panel_draw(mus__half *half, const mus__skirt_half *block, bool front, double slit, bool whole)
{
    mus__outline outline;
    mus__chain chain, part[MUS__DARTS + 1];
    const double *top = block->waist, *bottom = block->hem, open[2] = {0.0, bottom[1] + slit};
    mus__outline_begin(&outline);
    mus__chain_cubic(&chain, block->hem);
    mus__outline_add(&outline, "hem", "hem", SKIRT_HEM_ALLOWANCE, &chain);
    skirt_side_add(&outline, block);
    skirt_waist_parts(block, part);
    mus__lower_top(&outline, block->ndart, block->dart, part);
    mus__outline_line(&outline, "centre", "centre", MUS__SEAM_ALLOWANCE, top, slit > 0.0 ? open : bottom);
    if (slit > 0.0) mus__outline_line(&outline, "slit", "hem", MUS__SEAM_ALLOWANCE, open, bottom);

    const int32_t panel = mus__outline_panel(half, &outline, front ? "skirt_front" : "skirt_back", "skirt", !front);
    mus__half_centre(half, panel, "centre", (front || whole) && slit == 0.0 ? MUS__CENTRE_FOLD : MUS__CENTRE_SEAM);
    mus__half_centre(half, panel, "slit", MUS__CENTRE_OPEN);
    if (slit > 0.0) {
        const int32_t centre = mus__board_find(&half->board, panel, "centre");
        const double *start = mus__board_start(&half->board, centre), *end = mus__board_end(&half->board, centre);
        const bool ends = start != NULL && end != NULL && end[1] < start[1];
        mus__board_notch_add(&half->board, centre, ends ? half->board.side[centre].length : 0.0, MUS_NOTCH_TRIPLE);
    }
    mus__half_darts(half, panel);
    if (front) skirt_side_notch(half, panel, block);
    return panel;
}


/* the front of a skirt that wraps, below a bodice that does: it goes on beyond the centre, with the hem of its mirror
 * image, as far as the bodice above it, and ends in an edge straight down */
static int32_t skirt_wrap_front(mus__half *half, const mus__skirt_half *block)
{
    mus__outline outline;
    mus__chain chain, hem, part[MUS__DARTS + 1];
    double lap[8], end[2];
    const double length = mus__wrap_lap(mus__lower_net(half, true, 0.0, 0.0));

    /* the waist as long as that above it, and the hem below it, both on the other side of the centre */
    memcpy(lap, block->waist, sizeof lap);
    for (int32_t i = 0; i < 20; i++) {
        const double grow = length / mus__cubic_length(lap);
        for (int32_t k = 0; k < 4; k++) lap[2 * k] *= grow;
    }
    for (int32_t i = 0; i < 4; i++) lap[2 * i] = -lap[2 * i];
    mus__chain_cubic(&hem, block->hem);
    mus__chain_cut(&hem, -lap[6], &chain);
    mus__chain_mirror(&chain);
    memcpy(end, chain.xy, sizeof end);
    mus__chain_append(&chain, &hem);

    mus__outline_begin(&outline);
    mus__outline_add(&outline, "hem", "hem", SKIRT_HEM_ALLOWANCE, &chain);
    skirt_side_add(&outline, block);
    skirt_waist_parts(block, part);
    mus__lower_top(&outline, block->ndart, block->dart, part);
    mus__chain_cubic(&chain, lap);
    mus__outline_add(&outline, "lap", "lap", MUS__SEAM_ALLOWANCE, &chain);
    mus__outline_line(&outline, "edge", "hem", MUS__SEAM_ALLOWANCE, lap + 6, end);
    const int32_t panel = mus__outline_panel(half, &outline, "skirt_front", "skirt", false);
    mus__half_darts(half, panel);
    skirt_side_notch(half, panel, block);
    return panel;
}


/* draws and sews front and back; slit (2): heights of their slits above the hem; returns the panel of the front */
static int32_t skirt_straight_draw(mus__half *half, const mus__skirt_def *def, const double *slit, bool whole)
{
    mus__skirt block;
    const mus_status status = mus__skirt_draft(half->context, def, &block);
    mus__half_failed(half, status);
    if (status != MUS_OK) return MUS_NONE;
    const int32_t front = mus__wraps(half) ? skirt_wrap_front(half, &block.front)
                                           : skirt_panel_draw(half, &block.front, true, slit[0], whole);
    const int32_t back = skirt_panel_draw(half, &block.back, false, slit[1], whole);
    mus__half_sew(half, front, "side", back, "side", 0.0);
    const double width = fmax(block.front.hem_width, block.front.hip) + fmax(block.back.hem_width, block.back.hip);
    const double height = half->waist_level + mus__lower_level(half);
    mus__panel_place_hips(half, front, true, width, height);
    mus__panel_place_hips(half, back, false, width, height);
    return front;
}


/* straight; pencil: the hem is 2.5 cm narrower, a half; a_line: it is wider by 0.18 of the length below the hip, a
 * half. A narrow hem that reaches the knee has a slit at the centre back */
static void skirt_straight(mus__half *half)
{
    const int32_t kind = half->style.option[MUS__AXIS_SKIRT];
    mus__skirt_def def = skirt_block(half, 0.0);
    const double below = fmax(0.0, def.length - def.depth), scale = mus__lower_scale(half);
    double slit[2] = {0.0, 0.0};
    if (kind == MUS__SKIRT_A_LINE) def.flare = 0.18 * below;
    else if (below > 0.12 * half->measures.v[MUS_MEASURE_STATURE]) slit[1] = fmax(18.0 * MUS__CM * scale, 0.4 * below);
    if (kind == MUS__SKIRT_PENCIL) def.flare = -fmin(2.5 * MUS__CM * scale, 0.06 * below);
    skirt_straight_draw(half, &def, slit, false);
}


/* the skirt block itself, front and back whole, without an opening: 0.36 of the stature long, 4 cm of ease on the hip.
 * It hangs on the waist by being tighter than the hip: where that is hardly wider, it has no ease there. plain: A-line
 * without darts; its top edge is wider than the waist by 0.15 of the difference of hip and waist and rests above the
 * hip, so it is at most 0.95 of the hip; the hem is 0.10 of the length wider than the hip, a half */
static void skirt_block_alone(mus__half *half)
{
    static const double slit[2] = {0.0, 0.0};
    const double *m = half->measures.v, waist = m[MUS_MEASURE_WAIST], hip = m[MUS_MEASURE_HIP];
    const bool plain = mus__style_is(half, MUS__AXIS_SKIRT, MUS__SKIRT_PLAIN);
    mus__skirt_def def;
    memset(&def, 0, sizeof def);
    def.waist = waist;
    def.hip = hip;
    def.depth = m[MUS_MEASURE_WAIST_TO_HIP];
    def.waist_ease = plain ? fmin(0.15 * (hip - waist), 0.95 * hip - waist)
                           : fmin(2.0 * MUS__CM, 0.1 * fmax(0.0, hip - waist));
    def.hip_ease = isnan(half->def.ease) ? 4.0 * MUS__CM : half->def.ease;
    def.length = isnan(half->def.length) ? 0.36 * m[MUS_MEASURE_STATURE] : half->def.length;
    def.rise = 1.2 * MUS__CM;
    def.flare = plain ? 0.10 * def.length : 0.0;
    def.darts = !plain;
    skirt_straight_draw(half, &def, slit, true);
}


/* the part of the left front that laps over the right one, below the end of the centre seam: a sector about that
 * end, so that it does not hang below the hem; shorter at its edge for a high-low hem. It is cut once */
static void skirt_lap(mus__half *half, int32_t front, double top, double bottom, double width)
{
    const double height = top - bottom, angle = fmin(width / height, 0.6);
    const double reach = height * (half->style.option[MUS__AXIS_LENGTH] == MUS__LENGTH_HI_LOW ? 0.7 : 1.0);
    const double a[2] = {0.0, bottom}, b[2] = {0.0, top},
                 c[2] = {-reach * mus__sin(angle), top - reach * mus__cos(angle)};
    const double handle = angle / 3.0;
    double low[8];
    mus__chain chain;
    mus__outline outline;
    mus__outline_begin(&outline);
    mus__cubic_set(low, c, c[0] + handle * reach * mus__cos(angle), c[1] - handle * reach * mus__sin(angle),
                   -handle * height, bottom, a);
    mus__chain_cubic(&chain, low);
    mus__outline_add(&outline, "hem", "hem", MUS__SEAM_ALLOWANCE, &chain);
    mus__outline_line(&outline, "join", "centre", MUS__SEAM_ALLOWANCE, a, b);
    mus__outline_line(&outline, "edge", "hem", MUS__SEAM_ALLOWANCE, b, c);
    const int32_t lap = mus__outline_panel(half, &outline, "skirt_lap", "skirt", false);
    if (half->board.status != MUS_OK) return;
    half->board.panel[lap].single = 1;
    mus__half_sew(half, front, "slit", lap, "join", 0.0);

    /* placed as the front and 2 cm before it */
    half->board.panel[lap].attr.placement = half->board.panel[front].attr.placement;
    half->board.panel[lap].attr.placement.origin[2] += 0.02;
    half->board.panel[lap].attr.placement.bend += 0.02;
}


/* a wrap skirt: the fronts are sewn together at the centre half way to the hip; below, the left one laps over the
 * right */
static void skirt_wrap(mus__half *half)
{
    mus__skirt_def def = skirt_block(half, 0.0);
    const double below = fmax(0.0, def.length - def.depth);
    const double slit[2] = {def.length - 0.5 * def.depth, 0.0};
    def.flare = 0.10 * below;
    const int32_t front = skirt_straight_draw(half, &def, slit, false);
    if (half->board.status != MUS_OK || mus__wraps(half)) return;
    skirt_lap(half, front, slit[0] - def.length, -def.length, 0.16 * (def.waist + def.hip));
}


void mus__skirt_attach(mus__half *half)
{
    const int32_t first = half->board.npanel;
    if (half->board.status != MUS_OK) return;
    switch (half->style.option[MUS__AXIS_SKIRT]) {
    case MUS__SKIRT_GORED4:
    case MUS__SKIRT_GORED6:
    case MUS__SKIRT_GORED8:
    case MUS__SKIRT_GODET:
    case MUS__SKIRT_TRUMPET: mus__skirt_gores(half); break;
    case MUS__SKIRT_QUARTER:
    case MUS__SKIRT_HALF:
    case MUS__SKIRT_THREE_QUARTER:
    case MUS__SKIRT_FULL: mus__skirt_round(half); break;
    case MUS__SKIRT_GATHERED:
    case MUS__SKIRT_KNIFE:
    case MUS__SKIRT_BOX:
    case MUS__SKIRT_TIERED: mus__skirt_gathered(half); break;
    case MUS__SKIRT_WRAP: skirt_wrap(half); break;
    case MUS__SKIRT_BLOCK:
    case MUS__SKIRT_PLAIN: skirt_block_alone(half); break;
    default: skirt_straight(half); break;
    }
    mus__lower_waist_sew(half, first);
    if (mus__wraps(half))
        mus__half_sew(half, mus__board_find_panel(&half->board, "front"), "lap",
                      mus__board_find_panel(&half->board, "skirt_front"), "lap", 0.0);
}
