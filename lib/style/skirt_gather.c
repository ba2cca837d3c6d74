/*
 * skirt_gather.c: skirts whose top edge is longer than the waist: gathered, in knife or box pleats, in tiers.
 *
 * A front and a back are rectangles, so many times as wide as the waist they are sewn to: gathers 1.8, box pleats 2.4,
 * knife pleats 3. The difference is the ease of the seam above. Pleats are notched along the top edge. Tiers: three
 * strips, the first 1.4 times the waist, each further one 1.5 times the one above. Source: drafting.md section 3.5.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "style/lower.h"

#define RUFFLE_TIERS 3
#define RUFFLE_PLEAT (4.0 * MUS__CM) /* of a pleat that shows */

typedef struct ruffle_strip {
    const char *name;
    double width, top, centre, side; /* levels: of its top edge, of its lower edge at the centre and at the side */
    const char *top_label, *low_label;
} ruffle_strip;


/* hem (level at the centre, sloping to the side), side, top, centre */
static int32_t ruffle_draw(mus__half *half, const ruffle_strip *strip, bool front)
{
    const double w = strip->width, a[2] = {0.0, strip->centre}, b[2] = {w, strip->side}, top[2] = {w, strip->top};
    const double middle[2] = {0.0, strip->top};
    double cubic[8];
    mus__chain hem;
    mus__outline outline;
    const double slope = (front ? 0.5 : -0.5) * MUS_PI * fabs(b[1] - a[1]) / w;
    mus__cubic_set(cubic, a, a[0] + 0.35 * w, a[1], b[0] - 0.35 * w, b[1] + 0.35 * w * slope, b);
    if (strip->centre == strip->side) mus__chain_line(&hem, a, b);
    else mus__chain_cubic(&hem, cubic);
    mus__outline_begin(&outline);
    mus__outline_add(&outline, "hem", strip->low_label, 3.0 * MUS__CM, &hem);
    mus__outline_line(&outline, "side", "side", 1.0 * MUS__CM, b, top);
    mus__outline_line(&outline, "waist", strip->top_label, 1.0 * MUS__CM, top, middle);
    mus__outline_line(&outline, "centre", "centre", 0.0, middle, a);
    const int32_t panel = mus__outline_panel(half, &outline, strip->name, "skirt", !front);
    mus__half_centre(half, panel, "centre", MUS__CENTRE_FOLD);
    return panel;
}


/* notches where the pleats fold: each takes `fold` of cloth beside what shows of it */
static void ruffle_pleats(mus__half *half, int32_t panel, double width, double ratio)
{
    const int32_t side = mus__board_find(&half->board, panel, "waist");
    const int32_t n = (int32_t)lround(width / (ratio * RUFFLE_PLEAT));
    for (int32_t i = 0; i < n; i++) {
        const double from = width * i / n, fold = width / n / ratio;
        mus__board_notch_add(&half->board, side, from + 0.5 * fold, MUS_NOTCH_SINGLE);
        mus__board_notch_add(&half->board, side, from + width / n - 0.5 * fold, MUS_NOTCH_SINGLE);
    }
}


/* front and back of one strip, sewn at the side, round the hips; ratio: what its top is larger than net (2) */
static void ruffle_pair(mus__half *half, const char *const *names, const double *net, double ratio, double top,
                        double length, double fall, const char *low_label, int32_t *panels)
{
    const double level = mus__lower_level(half);
    for (int i = 0; i < 2; i++) {
        const bool front = i == 0;
        const ruffle_strip strip = {.name = names[i],
                                    .width = ratio * net[i],
                                    .top = top,
                                    .centre = top - length + (front ? fall : -fall),
                                    .side = top - length,
                                    .top_label = top == 0.0 ? "waist" : "tier",
                                    .low_label = low_label};
        panels[i] = ruffle_draw(half, &strip, front);
    }
    mus__half_sew(half, panels[0], "side", panels[1], "side", 0.0);
    for (int i = 0; i < 2; i++)
        mus__panel_place_hips(half, panels[i], i == 0, ratio * (net[0] + net[1]), half->waist_level + level);
}


static void ruffle_tiers(mus__half *half, const double *net, double first, double length)
{
    static const char *const names[RUFFLE_TIERS][2] = {
        {"skirt_front", "skirt_back"}, {"tier2_front", "tier2_back"}, {"tier3_front", "tier3_back"}};
    double ratio = first;
    int32_t above[2] = {MUS_NONE, MUS_NONE}, panels[2];
    for (int32_t t = 0; t < RUFFLE_TIERS; t++) {
        ruffle_pair(half, names[t], net, ratio, -t * length / RUFFLE_TIERS, length / RUFFLE_TIERS, 0.0,
                    t + 1 < RUFFLE_TIERS ? "tier" : "hem", panels);
        for (int i = 0; i < 2 && t > 0; i++)
            mus__half_sew(half, above[i], "hem", panels[i], "waist", (ratio - ratio / 1.5) * net[i]);
        memcpy(above, panels, sizeof above);
        ratio *= 1.5;
    }
}


void mus__skirt_gathered(mus__half *half)
{
    static const char *const names[] = {"skirt_front", "skirt_back"};
    const int32_t kind = half->style.option[MUS__AXIS_SKIRT];
    const double level = mus__lower_level(half), length = mus__skirt_length(half), *m = half->measures.v;
    const double net[2] = {mus__lower_net(half, true, level, 0.0), mus__lower_net(half, false, level, 0.0)};
    double ratio = kind == MUS__SKIRT_GATHERED ? 1.8 : kind == MUS__SKIRT_BOX ? 2.4 : 3.0;
    if (kind == MUS__SKIRT_TIERED) ratio = 1.4;

    /* it must clear the hip by 4 cm, as a drawn-up casing must for it to be put on */
    const double hip = 0.5 * (fmax(m[MUS_MEASURE_HIP], m[MUS_MEASURE_WAIST]) + 4.0 * MUS__CM);
    ratio = fmax(ratio, hip / (net[0] + net[1]));
    if (kind == MUS__SKIRT_TIERED) {
        ruffle_tiers(half, net, ratio, length);
        return;
    }
    int32_t panels[2];
    const double fall = half->style.option[MUS__AXIS_LENGTH] == MUS__LENGTH_HI_LOW ? 0.18 * length : 0.0;
    ruffle_pair(half, names, net, ratio, 0.0, length, fall, "hem", panels);
    for (int i = 0; i < 2 && kind != MUS__SKIRT_GATHERED; i++)
        ruffle_pleats(half, panels[i], ratio * net[i], ratio);
}
