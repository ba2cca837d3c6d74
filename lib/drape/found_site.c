/*
 * found_site.c: each tube round its limb: at which height, and which way round.
 *
 * One tube of each piece is hung first: on the shoulders, or where the pattern holds it, or from the waist down. From
 * there on the tube that is sewn longest to what has its place comes next: of 72 ways round the one whose edges come
 * nearest to their partners, moved along the limb by the mean of what is left. Words in names count as much as a small
 * distance does: they say which is the front of a skirt that is alike all round, and do not outweigh seams. Edges that
 * both point up are those of shoulders: they face each other from front and back.
 */
#include <math.h>
#include <string.h>

#include "body/body_level.h"
#include "drape/found.h"
#include "geom/vec.h"
#include "muslin/topology.h"

#define SITE_WAYS 72
#define SITE_WORD 0.02      /* [m2]: what a word against a way is worth */
#define SITE_SHOULDER 0.02  /* [m2] */
#define SITE_UP 0.5         /* edges whose way out is so far up belong to a shoulder */
#define SITE_RADIUS 0.32    /* [m] no tube of the trunk starts wider */
#define SITE_WAIST_PART 0.92 /* of the waist: no skirt has a smaller opening */
#define SITE_SLOPE 0.15     /* [m]: the middle of a shoulder is not lower below the top, of a cape's not twice that */
#define SITE_WIDE 2.0       /* of its distance: half a sheet so wide starts flat, clear of the arms */
#define SITE_APART_LEGS 0.01 /* [m] off the middle */
#define SITE_FORK 0.05      /* [m] that a leg starts farther out at most */
#define SITE_OVER 0.4       /* of a leg's panel: what reaches over the middle is its fork */
#define SITE_SIDE 0.5       /* cosine: panels that face more to the side than this make a ring */
#define SITE_ROOM 0.012     /* [m] that a sleeve starts wider than it is */
#define SITE_LAYER 0.03     /* [m] between pieces that lie over one another */
#define SITE_BEND 0.375     /* of the girth: how a front of the torso is rolled */

enum { SITE_NECK, SITE_ARMPIT, SITE_WAIST, SITE_HIP, SITE_CROTCH };


/* the body's own measures: heights, and how thick it is */
static mus_status site_body(mus__found *found)
{
    static const int32_t levels[] = {MUS__LEVEL_NECK, MUS__LEVEL_ARMPIT, MUS__LEVEL_WAIST, MUS__LEVEL_HIP,
                                     MUS__LEVEL_CROTCH};
    for (int32_t i = 0; i < 5; i++) {
        mus__body_level level;
        mus__body_level_find(found->body, levels[i], 0, &level);
        if (!level.there)
            return mus__fail(found->context, MUS_ERR_BODY, "place: the body has no level %s; one made of a tape has",
                             mus_hold_name(levels[i]));
        found->level[i] = level.point[1];
    }
    const double waist = mus_body_made(found->body, MUS_MEASURE_WAIST);
    const double hip = mus_body_made(found->body, MUS_MEASURE_HIP), bust = mus_body_made(found->body, MUS_MEASURE_BUST);
    found->off = 0.155 * fmax(bust, fmax(waist, hip)) + 0.045;
    found->belly = fmax(waist, hip) / (2.0 * MUS_PI) + 0.06;
    return MUS_OK;
}


static void site_upright(const mus__found *found, found_tube *tube, int32_t level)
{
    mus__body_level at;
    mus__body_level_find(found->body, level, 0, &at);
    memset(tube->axis, 0, sizeof tube->axis);
    tube->axis[2] = at.point[2];
    for (int32_t d = 0; d < 3; d++) tube->up[d] = d == 1, tube->front[d] = d == 2, tube->right[d] = d == 0;
}


/* mean place of what the tube is sewn to and has its place; weight 0 without */
static double site_partners(const mus__found *found, int32_t t, double *mean)
{
    double weight = 0.0;
    memset(mean, 0, 3 * sizeof *mean);
    for (int32_t i = 0; i < found->nseam; i++) {
        const found_seam *seam = &found->seam[i];
        const int32_t a = found->edge[seam->a].panel, b = found->edge[seam->b].panel;
        const int32_t ta = found->panel[a].tube, tb = found->panel[b].tube;
        if ((ta == t) == (tb == t) || !found->tube[ta == t ? tb : ta].set) continue;
        const found_edge *other = &found->edge[ta == t ? seam->b : seam->a];
        for (int32_t k = 0; k < FOUND_DOTS; k++) {
            double x[3];
            mus__found_place(&found->panel[other->panel], other->dot[2 * k], other->dot[2 * k + 1], x);
            for (int32_t d = 0; d < 3; d++) mean[d] += seam->length * x[d];
        }
        weight += FOUND_DOTS * seam->length;
    }
    for (int32_t d = 0; d < 3 && weight > 0.0; d++) mean[d] /= weight;
    return weight;
}


/* the arm on that side */
static void site_arm(const mus__found *found, found_tube *tube, bool right)
{
    mus__body_level biceps;
    mus__body_level_find(found->body, MUS__LEVEL_BICEPS, right, &biceps);
    site_upright(found, tube, MUS__LEVEL_BUST);
    tube->body = 0.06;
    if (!biceps.there) return;
    mus_body_landmark(found->body, right ? MUS_LANDMARK_SHOULDER_RIGHT : MUS_LANDMARK_SHOULDER_LEFT, tube->axis);
    memcpy(tube->up, biceps.up, sizeof tube->up);
    const double along = mus__dot3(tube->front, tube->up);
    for (int32_t d = 0; d < 3; d++) tube->front[d] -= along * tube->up[d];
    mus__unit3(tube->front);
    mus__cross3(tube->up, tube->front, tube->right);
    tube->body = mus_body_made(found->body, MUS_MEASURE_UPPER_ARM) / (2.0 * MUS_PI);
}


/* what the tube goes round: axis, frame, radii */
static void site_site(const mus__found *found, int32_t t)
{
    found_tube *tube = &found->tube[t];
    double mean[3];
    const double weight = site_partners(found, t, mean);
    const double trunk = 2.0 * MUS_PI * (found->belly - 0.06);
    if (tube->site == FOUND_ARM) {
        int32_t says = 0;
        for (int32_t p = 0; p < found->npanel; p++)
            if (found->panel[p].tube == t) says |= found->panel[p].says;
        site_arm(found, tube, weight > 0.0 ? mean[0] < 0.0 : (says & FOUND_RIGHT) != 0);
    } else if (tube->site == FOUND_NECK) {
        site_upright(found, tube, MUS__LEVEL_NECK);
        tube->body = mus_body_made(found->body, MUS_MEASURE_NECK) / (2.0 * MUS_PI);
    } else {
        site_upright(found, tube, tube->hangs ? MUS__LEVEL_BUST : MUS__LEVEL_HIP);
        tube->body = found->belly - 0.06;
        if (weight > 0.0 && tube->ring && tube->girth < 0.75 * trunk && fabs(mean[0]) > 0.04) {
            tube->axis[0] = mean[0];
            tube->body = mus_body_made(found->body, MUS_MEASURE_THIGH) / (2.0 * MUS_PI);
        }
    }
    if (!tube->ring) tube->girth = fmax(tube->girth, 2.0 * MUS_PI * tube->body);
    tube->radius = fmax(tube->girth / (2.0 * MUS_PI), tube->body) + SITE_ROOM + SITE_LAYER * tube->layer;
}


/* azimuth of a panel's middle */
static double site_azimuth(const found_tube *tube, const found_panel *panel)
{
    return tube->phase + 2.0 * MUS_PI * (panel->u + 0.5 * (panel->low[0] + panel->high[0])) / tube->girth;
}


/* a place of a panel on the round tube */
static void site_round(const found_tube *tube, const found_panel *panel, const double *dot, double *out, double *angle)
{
    const double a = tube->phase + 2.0 * MUS_PI * (panel->u + dot[0]) / tube->girth, c = cos(a), s = sin(a);
    for (int32_t d = 0; d < 3; d++)
        out[d] = tube->axis[d] + (panel->v + dot[1]) * tube->up[d] +
                 tube->radius * (c * tube->front[d] + s * tube->right[d]);
    *angle = a;
}


/* what words say against this way round, 0 to 2 */
static double site_words(const mus__found *found, int32_t t)
{
    const found_tube *tube = &found->tube[t];
    double sum = 0.0, all = 1e-9;
    for (int32_t p = 0; p < found->npanel; p++) {
        const found_panel *panel = &found->panel[p];
        if (panel->tube != t) continue;
        const double a = site_azimuth(tube, panel), c = cos(a), s = sin(a);
        if (panel->says & (FOUND_FRONT | FOUND_BACK))
            sum += panel->area * (1.0 - (panel->says & FOUND_FRONT ? c : -c)), all += panel->area;
        if (tube->site == FOUND_ARM || fabs(tube->axis[0]) > 0.0) continue;
        if (panel->says & (FOUND_LEFT | FOUND_RIGHT))
            sum += panel->area * (1.0 - (panel->says & FOUND_LEFT ? s : -s)), all += panel->area;
    }
    return sum / all;
}


/* how far the tube's edges are from their partners that have a place, on the way round that it has [m2]; shift: along
 * the limb, of the mean */
static double site_cost(const mus__found *found, int32_t t, double *shift)
{
    const found_tube *tube = &found->tube[t];
    double weight = 0.0, square = 0.0, first = 0.0, second = 0.0, shoulder = 0.0, seams = 0.0;
    for (int32_t i = 0; i < found->nseam; i++) {
        const found_seam *seam = &found->seam[i];
        const found_edge *a = &found->edge[seam->a], *b = &found->edge[seam->b];
        const found_panel *pa = &found->panel[a->panel], *pb = &found->panel[b->panel];
        const bool in_a = pa->tube == t, in_b = pb->tube == t;
        if (!in_a && !in_b) continue;
        const bool fans = pa->tube != pb->tube && pa->fan && pb->fan;
        const bool level = fans || (a->panel != b->panel && a->outward[1] > SITE_UP && b->outward[1] > SITE_UP);
        for (int32_t k = 0; k < FOUND_DOTS; k++) {
            const int32_t m = mus__found_partner(found, seam, k);
            double x[3], y[3], angle = 0.0, other = 0.0;
            if (in_a) site_round(tube, pa, a->dot + 2 * k, x, &angle);
            else mus__found_place(pa, a->dot[2 * k], a->dot[2 * k + 1], x), angle = atan2(x[0], x[2] - tube->axis[2]);
            if (in_b) site_round(tube, pb, b->dot + 2 * m, y, &other);
            else mus__found_place(pb, b->dot[2 * m], b->dot[2 * m + 1], y), other = atan2(y[0], y[2] - tube->axis[2]);
            if (level && tube->site == FOUND_TRUNK) shoulder += seam->length * (1.0 + cos(angle + other));
            if (level) seams += seam->length;
            if (fans || (in_a && in_b) || !found->tube[in_a ? pb->tube : pa->tube].set) continue;
            const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
            const double along = (in_a ? 1.0 : -1.0) * mus__dot3(d, tube->up);
            weight += seam->length, square += seam->length * mus__dot3(d, d);
            first += seam->length * along, second += seam->length * along * along;
        }
    }
    *shift = weight > 0.0 ? first / weight : 0.0;
    const double apart = weight > 0.0 ? square / weight - *shift * *shift : 0.0;
    return apart + SITE_WORD * site_words(found, t) + (seams > 0.0 ? SITE_SHOULDER * shoulder / seams : 0.0);
}


/* the best way round: of SITE_WAYS, then finer by halves */
static void site_turn(mus__found *found, int32_t t)
{
    found_tube *tube = &found->tube[t];
    double best = 1e30, phase = 0.0, shift;
    for (int32_t i = 0; i < SITE_WAYS; i++) {
        tube->phase = 2.0 * MUS_PI * i / SITE_WAYS;
        const double cost = site_cost(found, t, &shift);
        if (cost < best - 1e-12) best = cost, phase = tube->phase;
    }
    for (double step = MUS_PI / SITE_WAYS; step > 1e-3; step *= 0.5)
        for (int32_t side = -1; side <= 1; side += 2) {
            tube->phase = phase + side * step;
            const double cost = site_cost(found, t, &shift);
            if (cost < best - 1e-12) best = cost, phase = tube->phase;
        }
    tube->phase = phase;
    site_cost(found, t, &tube->shift);
}


/* radius at which half a width goes round and its sides stay this side of the middle */
static double site_bend(double off, double half)
{
    double low = fmax(off, 2.0 * half / MUS_PI), high = 100.0;
    if (low * (1.0 - cos(half / low)) <= off - 0.005) return low;
    for (int32_t i = 0; i < 60; i++) {
        const double r = 0.5 * (low + high);
        if (r * (1.0 - cos(half / r)) <= off - 0.005) high = r;
        else low = r;
    }
    return high;
}


/* a panel of a tube with a front and a back */
static void site_half(const mus__found *found, const found_tube *tube, found_panel *panel)
{
    const bool front = cos(site_azimuth(tube, panel)) >= 0.0;
    const double middle = 0.5 * (panel->low[0] + panel->high[0]);

    /* the line that stands at the middle of the front, or of the back */
    double line = ((front ? 0.0 : MUS_PI) - tube->phase) * tube->girth / (2.0 * MUS_PI) - panel->u;
    line -= floor((line - middle) / tube->girth + 0.5) * tube->girth;
    const double half = fmax(fabs(panel->low[0] - line), fabs(panel->high[0] - line));
    double off = tube->radius;
    if (tube->site == FOUND_TRUNK && tube->axis[0] == 0.0)
        off = tube->hangs ? found->off
              : tube->fork || tube->fan ? found->belly
                           : fmin(fmax(found->belly, tube->wide / (2.0 * MUS_PI) + 0.01), SITE_RADIUS);
    off += SITE_LAYER * tube->layer;
    panel->line = line;
    panel->bend = tube->hangs && tube->ring ? SITE_BEND * tube->girth : site_bend(off, half);
    if (!tube->ring && !tube->hangs && half > SITE_WIDE * off) panel->bend = 0.0;
    for (int32_t d = 0; d < 3; d++) {
        panel->out[d] = (front ? 1.0 : -1.0) * tube->front[d];
        panel->along[d] = (front ? 1.0 : -1.0) * tube->right[d];
        panel->up[d] = tube->up[d];
        panel->at[d] = tube->axis[d] + (panel->v + tube->shift) * tube->up[d] + off * panel->out[d];
    }

    /* what is round one leg stays on its side, and of the panels round both each leg's fork does */
    const double reach = panel->bend > 0.0 ? panel->bend * sin(fmin(half / panel->bend, 0.5 * MUS_PI)) : half;
    if (tube->axis[0] != 0.0 && reach + SITE_APART_LEGS > fabs(tube->axis[0]))
        panel->at[0] += copysign(reach + SITE_APART_LEGS, tube->axis[0]) - tube->axis[0];
    const double width = panel->high[0] - panel->low[0];
    const double over = middle > line ? line - panel->low[0] : panel->high[0] - line;
    if (!tube->fork || !(over > 0.0 && over < SITE_OVER * width)) return;
    for (int32_t d = 0; d < 3; d++) panel->at[d] += copysign(fmin(over, SITE_FORK), middle - line) * panel->along[d];
}


/* a panel of a ring: on the round tube, rolled if its own y runs along the limb */
static void site_ring(const found_tube *tube, found_panel *panel)
{
    const double a = site_azimuth(tube, panel), c = cos(a), s = sin(a);
    panel->line = 0.5 * (panel->low[0] + panel->high[0]);
    panel->bend = panel->turn[1] == 0.0 ? tube->radius : 0.0;
    for (int32_t d = 0; d < 3; d++) {
        panel->out[d] = c * tube->front[d] + s * tube->right[d];
        panel->along[d] = c * tube->right[d] - s * tube->front[d];
        panel->up[d] = tube->up[d];
        panel->at[d] = tube->axis[d] + (panel->v + tube->shift) * tube->up[d] + tube->radius * panel->out[d];
    }
}


/* its panels to where it is */
static void site_set(mus__found *found, int32_t t)
{
    found_tube *tube = &found->tube[t];
    tube->halves = tube->site == FOUND_TRUNK;
    for (int32_t p = 0; p < found->npanel; p++)
        if (found->panel[p].tube == t && !tube->hangs && fabs(cos(site_azimuth(tube, &found->panel[p]))) < SITE_SIDE)
            tube->halves = 0;
    if (tube->site == FOUND_TRUNK && !tube->halves && tube->axis[0] == 0.0)
        tube->radius = fmin(fmax(found->belly, tube->wide / (2.0 * MUS_PI) + 0.01), SITE_RADIUS) +
                       SITE_LAYER * tube->layer;
    for (int32_t p = 0; p < found->npanel; p++) {
        found_panel *panel = &found->panel[p];
        if (panel->tube != t) continue;
        if (tube->halves) site_half(found, tube, panel);
        else site_ring(tube, panel);
    }
    tube->set = 1;
}


/* height of the highest place of a tube, with how far off the middle it is */
static double site_top(const mus__found *found, int32_t t, double *aside)
{
    double top = -1e30;
    for (int32_t p = 0; p < found->npanel; p++) {
        const found_panel *panel = &found->panel[p];
        for (int32_t i = 0; i < panel->nedge && panel->tube == t; i++)
            for (int32_t k = 0; k < FOUND_DOTS; k++) {
                const double *dot = found->edge[panel->edge[i]].dot + 2 * k;
                if (!(panel->v + dot[1] > top)) continue;
                double x[3];
                mus__found_place(panel, dot[0], dot[1], x);
                top = panel->v + dot[1], *aside = fabs(x[0]);
            }
    }
    return top;
}


/* where edges are held: the shift that this asks for, of the edge that is held highest; false without */
static bool site_held(const mus__found *found, int32_t t, double *shift)
{
    double highest = -1e30;
    for (int32_t e = 0; e < found->nedge; e++) {
        const found_edge *edge = &found->edge[e];
        int32_t level;
        double below, mean = 0.0;
        mus__body_level at;
        if (edge->panel == MUS_NONE || found->panel[edge->panel].tube != t) continue;
        if (mus_pattern_edge_hold(found->pattern, e, &level, &below) != MUS_OK || level == MUS_HOLD_NONE) continue;
        mus__body_level_find(found->body, level, 0, &at);
        if (!at.there || !(at.point[1] - below > highest)) continue;
        for (int32_t k = 0; k < FOUND_DOTS; k++) mean += edge->dot[2 * k + 1] / FOUND_DOTS;
        highest = at.point[1] - below;
        *shift = highest - found->panel[edge->panel].v - mean;
    }
    return highest > 0.0;
}


/* the first tube of a piece: turned by words and shoulders, hung by the shoulders, by what is held, or at the waist */
static void site_hang(mus__found *found, int32_t t)
{
    found_tube *tube = &found->tube[t];
    double aside = 0.0;
    site_site(found, t);
    site_turn(found, t);
    site_set(found, t);
    const double top = site_top(found, t, &aside);
    if (tube->hangs) {
        tube->shift = found->level[SITE_NECK] - 0.4 * fmax(0.0, aside - 0.07) - top + SITE_LAYER * tube->layer;
    } else if (!site_held(found, t, &tube->shift)) {
        tube->shift = found->level[SITE_WAIST] - top;
    }
    site_set(found, t);
}


/* the shortest way round an opening of the sewn pattern [m], 0 without */
static double site_opening(const mus__found *found)
{
    double least = 0.0, length = 0.0;
    int32_t edges = 0;
    mus_topology topology;
    mus_topology_init(&topology, sizeof topology);
    if (mus_pattern_topology(found->pattern, &topology) != MUS_OK) return 0.0;
    for (int32_t i = 0; i < topology.loops; i++)
        if (mus_pattern_loop(found->pattern, i, NULL, 0, &edges, &length) == MUS_OK && (i == 0 || length < least))
            least = length;
    return least;
}


/* whether a tube lies on the shoulders: two of its edges that both point up are sewn, or a sleeve is sewn to it; with
 * `apart`, an opening being too small for a waist, or with a collar, also one of its edges and another tube's, when
 * nothing is above */
static bool site_hangs(const mus__found *found, int32_t t, bool apart)
{
    bool level = false, below = false, neck = false;
    for (int32_t i = 0; i < found->nseam; i++) {
        const found_seam *seam = &found->seam[i];
        const found_edge *a = &found->edge[seam->a], *b = &found->edge[seam->b];
        const found_panel *p = &found->panel[a->panel], *q = &found->panel[b->panel];
        if (p->tube != t && q->tube != t) continue;
        if (p->site != q->site && p->site + q->site == FOUND_TRUNK + FOUND_ARM) return true;
        if (p->site != q->site && p->site + q->site == FOUND_TRUNK + FOUND_NECK) neck = true;
        const bool up = a->outward[1] > SITE_UP, other = b->outward[1] > SITE_UP;
        if (p != q && up && other) {
            if (p->tube == q->tube && seam->high > -SITE_SLOPE) return true;
            level = level || (p->tube != q->tube && p->site == q->site && seam->high > -2.0 * SITE_SLOPE);
        }
        if (p->site == q->site && (p->tube == t ? up && !other : other && !up)) below = true;
    }
    return (apart || neck) && level && !below;
}


/* what comes first in a piece: what hangs, then the longest way round the trunk */
static int32_t site_first(const mus__found *found, int32_t piece)
{
    int32_t best = MUS_NONE;
    double most = -1.0;
    for (int32_t t = 0; t < found->ntube; t++) {
        const found_tube *tube = &found->tube[t];
        if (tube->piece != piece || tube->set) continue;
        double worth = tube->girth + (tube->hangs ? 100.0 : 0.0) + (tube->site == FOUND_TRUNK ? 1000.0 : 0.0), shift;
        if (site_held(found, t, &shift)) worth += 50.0;
        if (worth > most) most = worth, best = t;
    }
    return best;
}


/* the tube that is sewn longest to what has its place; MUS_NONE without */
static int32_t site_next(const mus__found *found)
{
    int32_t best = MUS_NONE;
    double most = 0.0;
    for (int32_t t = 0; t < found->ntube; t++) {
        double mean[3];
        if (found->tube[t].set) continue;
        const double length = site_partners(found, t, mean);
        if (length > most) most = length, best = t;
    }
    return best;
}


mus_status mus__found_sites(mus__found *found)
{
    const mus_status status = site_body(found);
    if (status != MUS_OK) return status;
    const double waist = mus_body_made(found->body, MUS_MEASURE_WAIST);
    const bool apart = site_opening(found) < SITE_WAIST_PART * waist;
    for (int32_t t = 0; t < found->ntube; t++)
        found->tube[t].hangs = found->tube[t].site == FOUND_TRUNK && site_hangs(found, t, apart);
    bool told = false;
    for (int32_t p = 0; p < found->npanel; p++) told = told || mus_pattern_layer(found->pattern, p) > 0;
    for (int32_t piece = 0, layer = 0; piece < found->npanel; piece++) {
        int32_t t = site_first(found, piece);
        if (t == MUS_NONE) continue;
        for (int32_t i = 0; i < found->ntube; i++)
            if (found->tube[i].piece == piece) found->tube[i].layer = layer;
        layer += !told;
        site_hang(found, t);
        while ((t = site_next(found)) != MUS_NONE) {
            site_site(found, t);
            site_turn(found, t);
            site_set(found, t);
        }
    }
    return MUS_OK;
}
