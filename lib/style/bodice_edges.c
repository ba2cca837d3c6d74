/*
 * bodice_edges.c: the edges of a front or back below the armhole: the side from the hem to the underarm with the bust
 * dart open, the lower edge with its waist darts.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "style/bodice.h"


void mus__top_turn(const double *p, const double *o, double a, double *out)
{
    const double c = mus__cos(a), s = mus__sin(a), x = p[0] - o[0], y = p[1] - o[1];
    out[0] = o[0] + c * x - s * y;
    out[1] = o[1] + s * x + c * y;
}


void mus__top_under(const mus__half *half, const mus__top *top, bool front, double *closed, double *turned)
{
    const mus__bodice *bodice = &half->bodice;
    const mus__bodice_half *block = front ? &bodice->front : &bodice->back;
    const double corner[2] = {block->side[0] + bodice->side_in, bodice->underarm};
    const double waist[2] = {corner[0] - top->side_in, 0.0}, part = top->low / mus__dist2(corner, waist);
    for (int i = 0; i < 2; i++) closed[i] = corner[i] + part * (waist[i] - corner[i]);
    if (front && block->theta > 0.0)
        mus__top_turn(closed, block->bust, block->theta, turned);
    else
        memcpy(turned, closed, 2 * sizeof *turned);
}


/* the side from the hem up to the waist, or where the straight part begins; `under` closed underarm. Fills the chain
 * without its last line and gives the line's start */
static bool torso_side_low(const mus__half *half, const mus__top *top, const double *under, mus__chain *chain,
                         double *start)
{
    const double waist[2] = {under[0] - top->side_in, 0.0};
    if (mus__style_is(half, MUS__AXIS_SHAPE, MUS__SHAPE_BOXY)) {
        start[0] = under[0] + top->hip_out, start[1] = top->hem;
        return false;
    }
    if (top->hem >= 0.0) {
        start[0] = waist[0] + (under[0] - waist[0]) * top->hem / under[1], start[1] = top->hem;
        return false;
    }

    /* waist to hip: [W, W + (0.45 out, 0.30 hip), (out, 0.55 hip), (out, hip)], as far as the hem */
    const double hip[2] = {waist[0] + top->hip_out, top->hip};
    double cubic[8], lower[8], rest[8];
    mus__cubic_set(cubic, waist, waist[0] + 0.45 * top->hip_out, 0.30 * top->hip, hip[0], 0.55 * top->hip, hip);
    if (top->hem <= top->hip - 1e-3) {
        const double end[2] = {hip[0], top->hem};
        mus__chain curve;
        mus__chain_line(chain, end, hip);
        mus__chain_cubic(&curve, cubic);
        mus__chain_reverse(&curve);
        mus__chain_append(chain, &curve);
    } else {
        double lo = 0.0, hi = 1.0;
        for (int i = 0; i < 50; i++) {
            const double t = 0.5 * (lo + hi), u = 1.0 - t;
            const double high = u * (u * cubic[1] + 3.0 * t * cubic[3]) + 3.0 * t * t * cubic[5];
            const double y = u * high + t * t * t * cubic[7];
            if (y > top->hem) lo = t;
            else hi = t;
        }
        mus__curve_split(MUS__CUBIC, cubic, lo, lower, rest);
        mus__chain_cubic(chain, lower);
        mus__chain_reverse(chain);
    }
    memcpy(start, waist, sizeof waist);
    return true;
}


/* side edges from the hem to the underarm; in front with the bust dart open about the bust point. Gives the start of
 * the hem's end and the underarm */
void mus__top_side(const mus__half *half, const mus__top *top, bool front, mus__outline *outline)
{
    const mus__bodice *bodice = &half->bodice;
    const mus__bodice_half *block = front ? &bodice->front : &bodice->back;
    const double closed[2] = {block->side[0] + bodice->side_in, bodice->underarm};
    double start[2], under[2], turned[2];
    mus__chain chain, line;
    const bool curved = torso_side_low(half, top, closed, &chain, start);
    mus__top_under(half, top, front, under, turned);

    /* without a bust dart one edge */
    if (!front || !(block->theta > 0.0)) {
        mus__chain_line(&line, start, under);
        if (curved) mus__chain_append(&chain, &line);
        mus__outline_add(outline, "side", "side", MUS__SEAM_ALLOWANCE, curved ? &chain : &line);
        return;
    }

    /* the mouth at bust level, 3 cm below the armhole at least */
    const double y = fmax(fmin(block->bust[1], under[1] - 3.0 * top->scale * MUS__CM), start[1] + 0.01);
    const double at = (y - start[1]) / (under[1] - start[1]);
    const double lower[2] = {start[0] + at * (under[0] - start[0]), y};
    double upper[2];
    mus__top_turn(lower, block->bust, block->theta, upper);
    mus__chain_line(&line, start, lower);
    if (curved) mus__chain_append(&chain, &line);
    mus__outline_add(outline, "side1", "side", MUS__SEAM_ALLOWANCE, curved ? &chain : &line);
    const double middle[2] = {0.5 * (lower[0] + upper[0]), 0.5 * (lower[1] + upper[1])};
    const double back = fmin(top->point_back / mus__dist2(middle, block->bust), 0.6);
    double point[2];
    for (int i = 0; i < 2; i++) point[i] = block->bust[i] + back * (middle[i] - block->bust[i]);
    mus__chain_line(&line, lower, point);
    mus__outline_add(outline, "bd1", "", 0.0, &line);
    mus__chain_line(&line, point, upper);
    mus__outline_add(outline, "bd2", "", 0.0, &line);
    mus__chain_line(&line, upper, turned);
    mus__outline_add(outline, "side2", "side", MUS__SEAM_ALLOWANCE, &line);
}


/* as wide as half the dart at the waist, and below the hips 1.5 mm, so that the outline does not touch itself */
static void top_dart_leg(const mus__top *top, const double *dart, double turn, mus__chain *out)
{
    const double x = dart[2], wide = 0.5 * (dart[4] - dart[0]), narrow = fmin(1.5e-3, wide), end = 0.8 * top->hip;
    const double point[2] = {x, dart[3]};
    double xy[4][2];
    int32_t n = 0;
    if (top->hem >= 0.0) {
        xy[n][0] = x + turn * wide * (1.0 - top->hem / dart[3]), xy[n++][1] = top->hem;
    } else {
        if (top->hem < end - 0.01) xy[n][0] = x + turn * narrow, xy[n++][1] = top->hem;
        const double low = fmax(end, top->hem), part = low / end;
        xy[n][0] = x + turn * (wide + part * (narrow - wide)), xy[n++][1] = low;
        xy[n][0] = x + turn * wide, xy[n++][1] = 0.0;
    }
    memcpy(xy[n++], point, sizeof point);
    mus__chain_line(out, xy[0], xy[1]);
    for (int32_t i = 1; i + 1 < n; i++) mus__chain_add_line(out, xy[i], xy[i + 1]);
}


bool mus__top_hem(const mus__half *half)
{
    return mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP) &&
           !mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_BLOCK);
}


/* the lower edge from the centre to the side, with the waist darts of the block: w1, wd1, wd2, w2, ... */
void mus__top_low(const mus__half *half, const mus__top *top, int32_t which, const double *end,
                      mus__outline *outline)
{
    static const char *const edges[] = {"w1", "w2", "w3"}, *const legs[] = {"wd1", "wd2", "wd3", "wd4"};
    const bool alone = mus__top_hem(half);
    const mus__bodice_half *block = which == MUS__TOP_FRONT ? &half->bodice.front : &half->bodice.back;
    const char *label = alone ? "hem" : "waist";
    const double allowance = alone ? MUS__HEM_ALLOWANCE : MUS__SEAM_ALLOWANCE;
    const int32_t ndart = top->waist_darts[which] ? block->ndart : 0;
    const mus__chain *neck = &top->neck[which];
    const double highest = neck->xy[2 * (neck->nxy - 1) + 1] - 3.0 * top->scale * MUS__CM;
    double at[2] = {0.0, top->hem};
    mus__chain chain, left, right;
    for (int32_t d = 0; d < ndart; d++) {
        double dart[6];
        memcpy(dart, block->dart[d], sizeof dart);
        if (which == MUS__TOP_FRONT && top->meet) dart[3] = block->bust[1];
        if (which == MUS__TOP_BACK) dart[3] = fmin(dart[3], highest);
        top_dart_leg(top, dart, -1.0, &left);
        top_dart_leg(top, dart, 1.0, &right);
        mus__chain_line(&chain, at, left.xy);
        mus__outline_add(outline, edges[d], label, allowance, &chain);
        mus__outline_add(outline, legs[2 * d], "", 0.0, &left);
        memcpy(at, right.xy, sizeof at);
        mus__chain_reverse(&right);
        mus__outline_add(outline, legs[2 * d + 1], "", 0.0, &right);
    }
    mus__chain_line(&chain, at, end);
    mus__outline_add(outline, ndart > 0 ? edges[ndart] : label, label, allowance, &chain);
}
