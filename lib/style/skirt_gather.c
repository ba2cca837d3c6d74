/*
 * skirt_gather.c: skirts whose top edge is longer than the waist: gathered, in knife or box pleats, in tiers.
 *
 * Front and back are rectangles, wider than the waist that they are sewn to: gathers 1.8 times, box pleats 2.4, knife
 * pleats 3. The difference is the ease of the seam above. The folds of pleats are marked at the top edge. A tiered
 * skirt has three strips, the first 1.4 times the waist, each further one 1.5 times the one above. Ratios: dressmaking
 * practice.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "style/waist_edge.h"

#define RUFFLE_TIERS 3
#define RUFFLE_PLEAT (4.0 * MUS__CM) /* [m] visible width of a pleat */
#define RUFFLE_MARK (5.0 * MUS__CM)  /* [m] length of the mark of a fold; chosen: the width of a hand's fingers */

typedef struct ruffle_strip {
    const char *name;
    double width, top, centre, side; /* levels: of its top edge, of its lower edge at the centre and at the side */
    const char *top_label, *low_label;
} ruffle_strip;

/* front and back of one strip */
typedef struct ruffle_tier {
    const char *const *names; /* (2) of the panels */
    double ratio;             /* width of its top edge over the waist */
    double top, length;       /* level of its top edge, length at the side [m] */
    double fall;              /* how much longer the back is than the side, the front shorter [m] */
    const char *low_label;    /* of its lower edge */
} ruffle_tier;


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


/* marks both folds of each pleat by a line from the top edge down: they are no notches, since they lie on one another
 * at one place of the waist */
static void ruffle_pleats(mus__half *half, int32_t panel, double width, double ratio)
{
    const int32_t side = mus__board_find(&half->board, panel, "waist");
    const int32_t n = (int32_t)lround(width / (ratio * RUFFLE_PLEAT));
    for (int32_t i = 0; i < n; i++) {
        const double from = width * i / n, fold = width / n / ratio;
        const double at[2] = {from + 0.5 * fold, from + width / n - 0.5 * fold};
        for (int k = 0; k < 2; k++) {
            double line[4], along[2];
            mus__board_at(&half->board, side, at[k], line, along);
            line[2] = line[0] - RUFFLE_MARK * along[1], line[3] = line[1] + RUFFLE_MARK * along[0];
            mus__board_mark_add(&half->board, panel, "pleat", 2, line);
        }
    }
}


/* draws front and back of a strip, sews them at the side and places them round the hips; net (2): sewn lengths of the
 * waist [m]; panels (2) gets them */
static void ruffle_pair(mus__half *half, const double *net, const ruffle_tier *tier, int32_t *panels)
{
    const double ratio = tier->ratio, top = tier->top, length = tier->length, fall = tier->fall;
    const double level = mus__lower_level(half);
    for (int i = 0; i < 2; i++) {
        const bool front = i == 0;
        const ruffle_strip strip = {.name = tier->names[i],
                                    .width = ratio * net[i],
                                    .top = top,
                                    .centre = top - length + (front ? fall : -fall),
                                    .side = top - length,
                                    .top_label = top == 0.0 ? "waist" : "tier",
                                    .low_label = tier->low_label};
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
        const ruffle_tier tier = {.names = names[t],
                                  .ratio = ratio,
                                  .top = -t * length / RUFFLE_TIERS,
                                  .length = length / RUFFLE_TIERS,
                                  .low_label = t + 1 < RUFFLE_TIERS ? "tier" : "hem"};
        ruffle_pair(half, net, &tier, panels);
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
    const double level = mus__lower_level(half), length = mus__skirt_length(half);
    const double net[2] = {mus__lower_net(half, true, level, 0.0), mus__lower_net(half, false, level, 0.0)};
    double ratio = kind == MUS__SKIRT_GATHERED ? 1.8 : kind == MUS__SKIRT_BOX ? 2.4 : 3.0;
    if (kind == MUS__SKIRT_TIERED) ratio = 1.4;

    ratio = fmax(ratio, mus__lower_pulled(half) / (net[0] + net[1]));
    if (kind == MUS__SKIRT_TIERED) {
        ruffle_tiers(half, net, ratio, length);
        return;
    }
    int32_t panels[2];
    const double fall = half->style.option[MUS__AXIS_LENGTH] == MUS__LENGTH_HI_LOW ? 0.18 * length : 0.0;
    const ruffle_tier tier = {.names = names, .ratio = ratio, .length = length, .fall = fall, .low_label = "hem"};
    ruffle_pair(half, net, &tier, panels);
    for (int i = 0; i < 2 && kind != MUS__SKIRT_GATHERED; i++)
        ruffle_pleats(half, panels[i], ratio * net[i], ratio);
}
