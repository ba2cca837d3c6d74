/*
 * skirt_gore.c: skirts of gores: four, six or eight, the trumpet, and straight gores with godets in their seams.
 *
 *      w ___ w      Every edge of every gore has one curve, moved sideways: from the waist out by the same t to the
 *       /   \       hip, down, and out to the hem. So all seams match whatever the gores' widths are: under a bodice
 *      (  h  )      the joints lie where its darts or seams are, and the side seams meet. t is the hip
 *      /_____\      less the waist, shared equally among all edges.
 *
 * Six gores have one in front and one behind on the fold; four and eight have centre seams. Gores are placed round
 * the hips with their hems side by side.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "style/waist_edge.h"

#define GORES 4 /* of a half garment at most */

typedef struct gore_plan {
    int32_t n, nfront;     /* gores of the half, and of them in front */
    bool fold;             /* the first and last are cut on the fold */
    double joint[GORES + 1]; /* along the waist from centre front to centre back */
    double intake;         /* hip less waist, an edge */
    double depth, length;  /* top edge to hip, to hem */
    double knee, nip;      /* trumpet: narrowest level, narrower there by; nip 0: none */
    double flare;          /* hem beyond the hip, an edge */
    double rise, hem_rise, tilt; /* waist and hem higher at the edges by; slope of the edge at the hem */
    double godet;          /* length of the godets, 0: none */
    double gap;            /* between gores as they stand */
} gore_plan;

typedef struct gore_waist {
    double rise, target;
} gore_waist;


static void gore_waist_curve(const gore_waist *waist, double x, double *out)
{
    const double middle[2] = {0.0, 0.0}, edge[2] = {x, waist->rise}, slope = 1.6 * waist->rise / x, reach = 0.33 * x;
    mus__cubic_set(out, middle, 0.4 * x, 0.0, x - reach, waist->rise - reach * slope, edge);
}


static double gore_waist_excess(const void *data, double x)
{
    const gore_waist *waist = data;
    double curve[8];
    gore_waist_curve(waist, x, curve);
    return mus__cubic_length(curve) - waist->target;
}


/* where the gores meet along the waist: front and back shared out evenly, or at the bodice's own joints */
static void gore_joints(const mus__half *half, gore_plan *plan)
{
    const double level = mus__lower_level(half);
    const double front = mus__lower_net(half, true, level, 0.0), back = mus__lower_net(half, false, level, 0.0);
    const double part = plan->fold ? 1.0 / 3.0 : 0.5;
    plan->nfront = plan->n / 2;
    plan->joint[0] = 0.0;
    plan->joint[plan->nfront] = front;
    plan->joint[plan->n] = front + back;
    if (plan->n < 4) return;
    plan->joint[1] = mus__lower_snap(half, true, part * front, 0.2 * front);
    plan->joint[3] = front + back - mus__lower_snap(half, false, part * back, 0.2 * back);
}


static void gore_plan_make(const mus__half *half, gore_plan *plan)
{
    const int32_t kind = half->style.option[MUS__AXIS_SKIRT];
    const double *m = half->measures.v, level = mus__lower_level(half), scale = mus__lower_scale(half);
    memset(plan, 0, sizeof *plan);
    plan->fold = kind == MUS__SKIRT_GORED6 || kind == MUS__SKIRT_TRUMPET;
    plan->n = kind == MUS__SKIRT_GORED4 || kind == MUS__SKIRT_GODET ? 2 : 4;
    gore_joints(half, plan);

    /* edges of the half: two a gore, but none at a fold */
    const double hip = fmax(m[MUS_MEASURE_HIP], 0.98 * m[MUS_MEASURE_WAIST]) + half->hip_ease;
    const int32_t edges = 2 * plan->n - (plan->fold ? 2 : 0);
    plan->intake = (0.5 * hip - plan->joint[plan->n]) / edges;
    plan->depth = m[MUS_MEASURE_WAIST_TO_HIP] + level;
    plan->length = mus__skirt_length(half);
    const double below = plan->length - plan->depth;
    plan->flare = below * (kind == MUS__SKIRT_GORED4 ? 0.15 : kind == MUS__SKIRT_GORED8 ? 0.10 : 0.12);
    if (kind == MUS__SKIRT_TRUMPET) {
        plan->knee = fmax(0.62 * plan->length, plan->depth + 0.3 * below);
        plan->nip = 0.7 * MUS__CM * scale;
        plan->flare = 0.40 * (plan->length - plan->knee);
    }
    if (kind == MUS__SKIRT_GODET) {
        plan->flare = 0.0;
        plan->godet = fmin(0.45 * plan->length, 0.8 * below);
        plan->gap = 2.0 * plan->godet * mus__sin(MUS_PI / 7.0);
    }

    /* the mean gore's waist and hem are square to its edges; the hem rises by 0.6 of a cone's */
    const double width = plan->joint[plan->n] / edges, run = plan->nip > 0.0 ? plan->length - plan->knee : below;
    plan->rise = 0.5 * width * mus__tan(0.6 * mus__atan2(fmax(plan->intake, 0.0), plan->depth));
    plan->tilt = mus__atan2(plan->flare, run);
    plan->hem_rise = 0.6 * (width + plan->intake + plan->flare) * mus__tan(0.5 * plan->tilt);
}


/* the edge of a gore whose half width at the waist edge is x, from the waist down to level `end` (the hem's, or that of
 * the godet) */
static void gore_edge(const gore_plan *plan, double x, mus__chain *out)
{
    const double hip = x + plan->intake, r = plan->rise, d = plan->depth;
    const double top[2] = {x, r}, at_hip[2] = {hip, -d};
    out->npiece = 0;
    mus__chain_add_cubic(out, top, x + 0.45 * plan->intake, r - 0.30 * d, hip, -0.55 * d, at_hip);

    /* trumpet: in to the knee */
    double from[2] = {hip, -d};
    if (plan->nip > 0.0) {
        const double knee[2] = {hip - plan->nip, -plan->knee}, run = plan->knee - d;
        mus__chain_add_cubic(out, from, from[0], from[1] - 0.35 * run, knee[0], knee[1] + 0.35 * run, knee);
        memcpy(from, knee, sizeof from);
    }
    const double run = plan->length + from[1], up = 0.4 * (run - plan->hem_rise);
    const double hem[2] = {from[0] + plan->flare, -plan->length + plan->hem_rise};
    mus__chain_add_cubic(out, from, from[0], from[1] - 0.25 * run, hem[0] - up * mus__tan(plan->tilt), hem[1] + up,
                         hem);
}


/* split an edge that runs down where the godet begins: `low` from there on */
static void gore_edge_split(const gore_plan *plan, const mus__chain *edge, mus__chain *high, mus__chain *low)
{
    mus__chain back = *edge;
    mus__chain_cut(edge, mus__chain_length(edge) - plan->godet, high);
    mus__chain_reverse(&back);
    mus__chain_cut(&back, plan->godet, low);
    mus__chain_reverse(low);
    memcpy(low->xy, high->xy + 2 * (high->nxy - 1), 2 * sizeof *low->xy);
}


/* one edge to the outline: the outer one up, the inner one down; with a godet in two sides */
static void gore_edge_add(const gore_plan *plan, mus__outline *outline, const mus__chain *edge, bool outer)
{
    mus__chain high = *edge, low;
    const char *name = outer ? "out" : "in", *name_low = outer ? "out_low" : "in_low";
    if (plan->godet > 0.0) gore_edge_split(plan, edge, &high, &low);
    if (!outer) {
        mus__outline_add(outline, name, "side", MUS__SEAM_ALLOWANCE, &high);
        if (plan->godet > 0.0) mus__outline_add(outline, name_low, "side", MUS__SEAM_ALLOWANCE, &low);
        return;
    }
    mus__chain_reverse(&high);
    if (plan->godet > 0.0) {
        mus__chain_reverse(&low);
        mus__outline_add(outline, name_low, "side", MUS__SEAM_ALLOWANCE, &low);
    }
    mus__outline_add(outline, name, "side", MUS__SEAM_ALLOWANCE, &high);
}


/* one gore: `width` half its waist (of one on the fold: what is drawn of it). *at is where it begins round the hips and
 * gets where it ends */
static int32_t gore_draw(mus__half *half, const gore_plan *plan, int32_t index, double width, bool on_fold,
                         double *at)
{
    const bool front = index < plan->nfront;
    const gore_waist target = {plan->rise, width};
    double x, cubic[8];
    if (!mus__solve(gore_waist_excess, &target, 0.5 * width, 1.2 * width + 0.001, &x)) {
        mus__board_fail(&half->board, MUS_ERR_DESIGN, "gore: no waist of %d mm with a rise of %d mm",
                        mus__millimetres(2.0 * width), mus__millimetres(plan->rise));
        return MUS_NONE;
    }
    mus__chain edge, inner, waist, hem;
    gore_edge(plan, x, &edge);
    gore_waist_curve(&target, x, cubic);
    mus__chain_cubic(&waist, cubic);
    mus__chain_reverse(&waist);
    const double *end = edge.xy + 2 * (edge.nxy - 1), middle[2] = {0.0, -plan->length}, reach = 0.3 * end[0];
    mus__cubic_set(cubic, middle, 0.5 * end[0], middle[1], end[0] - reach * mus__cos(plan->tilt),
                   end[1] - reach * mus__sin(plan->tilt), end);
    mus__chain_cubic(&hem, cubic);
    const double half_hem = fmax(end[0], x + plan->intake);
    inner = edge;
    mus__chain_mirror(&inner);
    mus__chain_reverse(&inner);
    const double shift = on_fold ? 0.0 : *at + half_hem;
    if (!on_fold) {
        mus__chain_reverse(&hem);
        mus__chain_unfold(&hem);
        mus__chain_reverse(&hem);
        mus__chain_unfold(&waist);
    }
    mus__chain_shift(&hem, shift);
    mus__chain_shift(&waist, shift);
    mus__chain_shift(&edge, shift);
    mus__chain_shift(&inner, shift);
    *at = shift + half_hem + plan->gap;

    mus__outline outline;
    char name[] = "gore1";
    name[4] = (char)('1' + index);
    mus__outline_begin(&outline);
    mus__outline_add(&outline, "hem", "hem", 3.0 * MUS__CM, &hem);
    gore_edge_add(plan, &outline, &edge, true);
    mus__outline_add(&outline, "waist", "waist", MUS__SEAM_ALLOWANCE, &waist);
    if (on_fold)
        mus__outline_line(&outline, "in", "centre", MUS__SEAM_ALLOWANCE, waist.xy + 2 * (waist.nxy - 1), hem.xy);
    else
        gore_edge_add(plan, &outline, &inner, false);
    return mus__outline_panel(half, &outline, name, "skirt", !front);
}


/* a godet, apex up: whole, or on the fold for a centre seam */
static int32_t gore_godet(mus__half *half, const gore_plan *plan, const char *name, bool on_fold, bool front, double at)
{
    const double h = plan->godet, angle = MUS_PI / 7.0, top = plan->godet - plan->length;
    const double x = on_fold ? 0.0 : at, apex[2] = {x, top},
                 a[2] = {x - h * mus__sin(angle), top - h * mus__cos(angle)};
    const double b[2] = {x + h * mus__sin(angle), a[1]}, low[2] = {x, top - h};
    const double mid[2] = {x + h * mus__sin(0.5 * angle), top - h * mus__cos(0.5 * angle)};
    mus__chain hem;
    mus__outline outline;
    mus__outline_begin(&outline);
    if (on_fold) mus__chain_arc(&hem, low, mid, b);
    else mus__chain_arc(&hem, a, low, b);
    mus__outline_add(&outline, "hem", "hem", 3.0 * MUS__CM, &hem);
    mus__outline_line(&outline, "out", "side", MUS__SEAM_ALLOWANCE, b, apex);
    if (on_fold) mus__outline_line(&outline, "fold", "centre", 0.0, apex, low);
    else mus__outline_line(&outline, "in", "side", MUS__SEAM_ALLOWANCE, apex, a);
    const int32_t panel = mus__outline_panel(half, &outline, name, "godet", !front);
    mus__half_centre(half, panel, "fold", MUS__CENTRE_FOLD);
    return panel;
}


/* godets: in the side seam between front and back, and on the fold in the centre seams */
static void gore_godets(mus__half *half, const gore_plan *plan, int32_t front, int32_t back, double width)
{
    const double height = half->waist_level + mus__lower_level(half);
    const int32_t side = gore_godet(half, plan, "godet_side", false, true, 0.5 * width);
    const int32_t cf = gore_godet(half, plan, "godet_front", true, true, 0.0);
    const int32_t cb = gore_godet(half, plan, "godet_back", true, false, 0.0);
    mus__half_sew(half, front, "out_low", side, "in", 0.0);
    mus__half_sew(half, side, "out", back, "out_low", 0.0);
    mus__half_sew(half, cf, "out", front, "in_low", 0.0);
    mus__half_sew(half, back, "in_low", cb, "out", 0.0);
    mus__panel_place_hips(half, side, true, width, height);
    mus__panel_place_hips(half, cf, true, width, height);
    mus__panel_place_hips(half, cb, false, width, height);
}


void mus__skirt_gores(mus__half *half)
{
    gore_plan plan;
    int32_t panel[GORES];
    double end[2] = {0.0, 0.0}; /* front and back, from their centre lines to the side */
    gore_plan_make(half, &plan);
    if (plan.length < plan.depth + 2.0 * MUS__CM || plan.joint[1] < 2.0 * MUS__CM) {
        mus__board_fail(&half->board, MUS_ERR_DESIGN, "gores: length %d mm, hip %d mm below the top edge",
                        mus__millimetres(plan.length), mus__millimetres(plan.depth));
        return;
    }

    /* from each centre line to the side */
    end[0] = end[1] = 0.5 * plan.gap;
    for (int32_t i = 0; i < plan.n; i++) {
        const bool front = i < plan.nfront;
        const int32_t k = front ? i : plan.n - 1 - (i - plan.nfront);
        const bool on_fold = plan.fold && (k == 0 || k == plan.n - 1);
        const double width = (on_fold ? 1.0 : 0.5) * (plan.joint[k + 1] - plan.joint[k]);
        panel[k] = gore_draw(half, &plan, k, width, on_fold, &end[front ? 0 : 1]);
        if (half->board.status != MUS_OK) return;
    }

    /* seams between neighbours, then the centre lines */
    for (int32_t k = 0; k + 1 < plan.n; k++) {
        const bool side = k + 1 == plan.nfront, front = k + 1 < plan.nfront;
        mus__half_sew(half, panel[k], front || side ? "out" : "in", panel[k + 1], front ? "in" : "out", 0.0);
    }
    for (int32_t k = 0; k < plan.n; k += plan.n - 1)
        mus__half_centre(half, panel[k], "in", plan.fold ? MUS__CENTRE_FOLD : MUS__CENTRE_SEAM);
    const double width = end[0] + end[1];
    for (int32_t k = 0; k < plan.n; k++)
        mus__panel_place_hips(half, panel[k], k < plan.nfront, width, half->waist_level + mus__lower_level(half));
    if (plan.godet > 0.0) gore_godets(half, &plan, panel[0], panel[plan.n - 1], width);
}
