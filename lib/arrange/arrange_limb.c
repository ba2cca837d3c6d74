/*
 * arrange_limb.c: puts each ring round its limb: the height, and the azimuth.
 *
 * One ring of each component is hung first: on the shoulders, or where the pattern attaches it, or from the waist down.
 * After it comes, again and again, the ring that is sewn longest to rings that have their place. Of 72 azimuths it
 * takes the one at which its edges are nearest to their partners, and moves along the limb by the mean of the distance
 * left. The sides of panels count as much as a small distance: they tell the front of a skirt that is alike all
 * round, and do not outweigh seams. Edges that both point up are those of shoulders, which face each other from front
 * and back.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "arrange/arrange_internal.h"
#include "base/elementary.h"
#include "geom/vec.h"
#include "muslin/topology.h"

/* All numbers below are chosen; the table of `make wear` (garments that come on) shows what they change. */

#define AROUND_WAYS 72         /* azimuths that are tried */
#define AROUND_FINE 1e-6       /* [rad] the azimuth is found to this: a symmetric garment starts symmetric to 1 um */
#define AROUND_ON_SIDE 0.02    /* [m2] cost of a side against an azimuth, in squared distances of edges */
#define AROUND_SHOULDER 0.02   /* [m2] cost of shoulder edges on the same side of the body */
#define AROUND_RADIUS 0.32     /* [m] largest radius of a ring of the trunk */
#define AROUND_WAIST_PART 0.92 /* of the waist girth: the smallest opening of a skirt */
#define AROUND_SLOPE                                                                                                   \
    0.15 /* [m] the middle of a shoulder seam is no lower below the top; that of a cape no lower than twice this */
#define AROUND_WIDE 2.0 /* of its distance from the axis: half a sheet that is wider starts flat, clear of the arms */
#define AROUND_APART_LEGS 0.01 /* [m] from a leg's panel to the middle plane */
#define AROUND_FORK 0.05       /* [m] largest distance by which a leg is moved out */
#define AROUND_OVER 0.4        /* of the width of a leg's panel: a part over the middle that is narrower is its fork */
#define AROUND_SIDE 0.5        /* cosine: panels that face more to the side make a round ring, not a front and a back */
#define AROUND_ROOM 0.012      /* [m] added to the radius of a sleeve */
#define AROUND_LAYER 0.03      /* [m] between components that lie over one another */
#define AROUND_BEND 0.375      /* of the girth: the radius with which a front of the torso is rolled */

enum { AROUND_NECK, AROUND_ARMPIT, AROUND_WAIST, AROUND_HIP, AROUND_CROTCH };


/* takes heights and thickness of the body. Errors: MUS_ERR_BODY */
static mus_status around_body(mus__arrangement *arrangement)
{
    static const int32_t levels[] = {MUS__LEVEL_NECK, MUS__LEVEL_ARMPIT, MUS__LEVEL_WAIST, MUS__LEVEL_HIP,
                                     MUS__LEVEL_CROTCH};
    for (int32_t i = 0; i < 5; i++) {
        const mus__body_level *level = arrangement->body->level[levels[i]];
        if (!level->there)
            return mus__fail(arrangement->context, MUS_ERR_BODY,
                             "place: the body has no level %s; one made of a tape has", mus_hold_name(levels[i]));
        arrangement->level[i] = level->point[1];
    }
    const double waist = mus_body_made(arrangement->body, MUS_MEASURE_WAIST);
    const double hip = mus_body_made(arrangement->body, MUS_MEASURE_HIP),
                 bust = mus_body_made(arrangement->body, MUS_MEASURE_BUST);
    arrangement->off = 0.155 * fmax(bust, fmax(waist, hip)) + 0.045;
    arrangement->belly = fmax(waist, hip) / (2.0 * MUS_PI) + 0.06;
    return MUS_OK;
}


static void around_upright(const mus__arrangement *arrangement, mus__arranged_ring *ring, int32_t level)
{
    const mus__body_level *at = arrangement->body->level[level];
    memset(ring->axis, 0, sizeof ring->axis);
    ring->axis[2] = at->point[2];
    for (int32_t d = 0; d < 3; d++) ring->up[d] = d == 1, ring->front[d] = d == 2, ring->right[d] = d == 0;
}


/* mean place (3) [m] of the placed edges that a ring is sewn to; returns their weight, 0 without any */
static double around_partners(const mus__arrangement *arrangement, int32_t t, double *mean)
{
    double weight = 0.0;
    memset(mean, 0, 3 * sizeof *mean);
    for (int32_t i = 0; i < arrangement->nseam; i++) {
        const mus__arranged_seam *seam = &arrangement->seam[i];
        const int32_t a = arrangement->edge[seam->a].panel, b = arrangement->edge[seam->b].panel;
        const int32_t ta = arrangement->panel[a].ring, tb = arrangement->panel[b].ring;
        if ((ta == t) == (tb == t) || !arrangement->ring[ta == t ? tb : ta].set) continue;
        const mus__arranged_edge *other = &arrangement->edge[ta == t ? seam->b : seam->a];
        for (int32_t k = 0; k < MUS__ARRANGE_DOTS; k++) {
            double x[3];
            mus__arrange_point(&arrangement->panel[other->panel], other->dot[2 * k], other->dot[2 * k + 1], x);
            for (int32_t d = 0; d < 3; d++) mean[d] += seam->length * x[d];
        }
        weight += MUS__ARRANGE_DOTS * seam->length;
    }
    for (int32_t d = 0; d < 3 && weight > 0.0; d++) mean[d] /= weight;
    return weight;
}


/* the frame of a ring round the arm on that side */
static void around_arm(const mus__arrangement *arrangement, mus__arranged_ring *ring, bool right)
{
    const mus__body_level *biceps = &arrangement->body->level[MUS__LEVEL_BICEPS][right];
    around_upright(arrangement, ring, MUS__LEVEL_BUST);
    ring->body = 0.06;
    if (!biceps->there) return;
    mus_body_landmark(arrangement->body, right ? MUS_LANDMARK_SHOULDER_RIGHT : MUS_LANDMARK_SHOULDER_LEFT, ring->axis);
    memcpy(ring->up, biceps->up, sizeof ring->up);

    /* levels are those of the rest pose; a posed arm points from the wrist to the shoulder */
    double wrist[3];
    const int32_t hand = right ? MUS_LANDMARK_WRIST_RIGHT : MUS_LANDMARK_WRIST_LEFT;
    if (arrangement->body->frame != NULL && mus_body_landmark(arrangement->body, hand, wrist) == MUS_OK) {
        for (int32_t d = 0; d < 3; d++) ring->up[d] = ring->axis[d] - wrist[d];
        mus__unit3(ring->up);
    }
    const double along = mus__dot3(ring->front, ring->up);
    for (int32_t d = 0; d < 3; d++) ring->front[d] -= along * ring->up[d];
    mus__unit3(ring->front);
    mus__cross3(ring->up, ring->front, ring->right);
    ring->body = mus_body_made(arrangement->body, MUS_MEASURE_UPPER_ARM) / (2.0 * MUS_PI);
}


/* sets axis, frame and radii of a ring by its limb */
static void around_site(const mus__arrangement *arrangement, int32_t t)
{
    mus__arranged_ring *ring = &arrangement->ring[t];
    double mean[3];
    const double weight = around_partners(arrangement, t, mean);
    const double trunk = 2.0 * MUS_PI * (arrangement->belly - 0.06);
    if (ring->limb == MUS__ARRANGE_ARM) {
        int32_t says = 0;
        for (int32_t p = 0; p < arrangement->npanel; p++)
            if (arrangement->panel[p].ring == t) says |= arrangement->panel[p].says;
        around_arm(arrangement, ring, weight > 0.0 ? mean[0] < 0.0 : (says & MUS__ARRANGE_RIGHT) != 0);
    } else if (ring->limb == MUS__ARRANGE_NECK) {
        around_upright(arrangement, ring, MUS__LEVEL_NECK);
        ring->body = mus_body_made(arrangement->body, MUS_MEASURE_NECK) / (2.0 * MUS_PI);
    } else {
        around_upright(arrangement, ring, ring->hangs ? MUS__LEVEL_BUST : MUS__LEVEL_HIP);
        ring->body = arrangement->belly - 0.06;
        if (weight > 0.0 && ring->closed && ring->girth < 0.75 * trunk && fabs(mean[0]) > 0.04) {
            ring->axis[0] = mean[0];
            ring->body = mus_body_made(arrangement->body, MUS_MEASURE_THIGH) / (2.0 * MUS_PI);
        }
    }
    if (!ring->closed) ring->girth = fmax(ring->girth, 2.0 * MUS_PI * ring->body);
    ring->radius = fmax(ring->girth / (2.0 * MUS_PI), ring->body) + AROUND_ROOM + AROUND_LAYER * ring->layer;
}


/* azimuth of the middle of a panel [rad] */
static double around_azimuth(const mus__arranged_ring *ring, const mus__arranged_panel *panel)
{
    return ring->phase + 2.0 * MUS_PI * (panel->u + 0.5 * (panel->low[0] + panel->high[0])) / ring->girth;
}


/* the place out (3) [m] and the azimuth of a point of a panel on the round ring */
static void around_round(const mus__arranged_ring *ring, const mus__arranged_panel *panel, const double *dot,
                         double *out, double *angle)
{
    const double a = ring->phase + 2.0 * MUS_PI * (panel->u + dot[0]) / ring->girth, c = mus__cos(a), s = mus__sin(a);
    for (int32_t d = 0; d < 3; d++)
        out[d] = ring->axis[d] + (panel->v + dot[1]) * ring->up[d] +
                 ring->radius * (c * ring->front[d] + s * ring->right[d]);
    *angle = a;
}


/* how much the sides of its panels contradict the azimuth of a ring, 0 to 2 */
static double around_sides(const mus__arrangement *arrangement, int32_t t)
{
    const mus__arranged_ring *ring = &arrangement->ring[t];
    double sum = 0.0, all = 1e-9;
    for (int32_t p = 0; p < arrangement->npanel; p++) {
        const mus__arranged_panel *panel = &arrangement->panel[p];
        if (panel->ring != t) continue;
        const double a = around_azimuth(ring, panel), c = mus__cos(a), s = mus__sin(a);
        if (panel->says & (MUS__ARRANGE_FRONT | MUS__ARRANGE_BACK))
            sum += panel->area * (1.0 - (panel->says & MUS__ARRANGE_FRONT ? c : -c)), all += panel->area;
        if (ring->limb == MUS__ARRANGE_ARM || fabs(ring->axis[0]) > 0.0) continue;
        if (panel->says & (MUS__ARRANGE_LEFT | MUS__ARRANGE_RIGHT))
            sum += panel->area * (1.0 - (panel->says & MUS__ARRANGE_LEFT ? s : -s)), all += panel->area;
    }
    return sum / all;
}


/* cost [m2] of a ring at its azimuth: mean squared distance of its edges from their partners that have a place, with
 * sides and shoulders; *shift gets the mean distance along the limb [m] */
static double around_cost(const mus__arrangement *arrangement, int32_t t, double *shift)
{
    const mus__arranged_ring *ring = &arrangement->ring[t];
    double weight = 0.0, square = 0.0, first = 0.0, second = 0.0, shoulder = 0.0, seams = 0.0;
    for (int32_t i = 0; i < arrangement->nseam; i++) {
        const mus__arranged_seam *seam = &arrangement->seam[i];
        const mus__arranged_edge *a = &arrangement->edge[seam->a], *b = &arrangement->edge[seam->b];
        const mus__arranged_panel *pa = &arrangement->panel[a->panel], *pb = &arrangement->panel[b->panel];
        const bool in_a = pa->ring == t, in_b = pb->ring == t;
        if (!in_a && !in_b) continue;
        const bool fans = pa->ring != pb->ring && pa->fan && pb->fan;
        const bool level =
            fans || (a->panel != b->panel && a->outward[1] > MUS__EDGE_UP && b->outward[1] > MUS__EDGE_UP);
        for (int32_t k = 0; k < MUS__ARRANGE_DOTS; k++) {
            const int32_t m = mus__arrange_partner(arrangement, seam, k);
            double x[3], y[3], angle = 0.0, other = 0.0;
            if (in_a)
                around_round(ring, pa, a->dot + 2 * k, x, &angle);
            else
                mus__arrange_point(pa, a->dot[2 * k], a->dot[2 * k + 1], x),
                    angle = mus__atan2(x[0], x[2] - ring->axis[2]);
            if (in_b)
                around_round(ring, pb, b->dot + 2 * m, y, &other);
            else
                mus__arrange_point(pb, b->dot[2 * m], b->dot[2 * m + 1], y),
                    other = mus__atan2(y[0], y[2] - ring->axis[2]);
            if (level && ring->limb == MUS__ARRANGE_TRUNK) shoulder += seam->length * (1.0 + mus__cos(angle + other));
            if (level) seams += seam->length;
            if (fans || (in_a && in_b) || !arrangement->ring[in_a ? pb->ring : pa->ring].set) continue;
            const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
            const double along = (in_a ? 1.0 : -1.0) * mus__dot3(d, ring->up);
            weight += seam->length, square += seam->length * mus__dot3(d, d);
            first += seam->length * along, second += seam->length * along * along;
        }
    }
    *shift = weight > 0.0 ? first / weight : 0.0;
    const double apart = weight > 0.0 ? square / weight - *shift * *shift : 0.0;
    return apart + AROUND_ON_SIDE * around_sides(arrangement, t) +
           (seams > 0.0 ? AROUND_SHOULDER * shoulder / seams : 0.0);
}


/* finds the best azimuth of a ring: among AROUND_WAYS, then finer by halves */
static void around_turn(mus__arrangement *arrangement, int32_t t)
{
    mus__arranged_ring *ring = &arrangement->ring[t];
    double best = 1e30, phase = 0.0, shift;
    for (int32_t i = 0; i < AROUND_WAYS; i++) {
        ring->phase = 2.0 * MUS_PI * i / AROUND_WAYS;
        const double cost = around_cost(arrangement, t, &shift);
        if (cost < best - 1e-12) best = cost, phase = ring->phase;
    }
    for (double step = MUS_PI / AROUND_WAYS; step > AROUND_FINE; step *= 0.5)
        for (int32_t side = -1; side <= 1; side += 2) {
            ring->phase = phase + side * step;
            const double cost = around_cost(arrangement, t, &shift);
            if (cost < best - 1e-12) best = cost, phase = ring->phase;
        }
    ring->phase = phase;
    around_cost(arrangement, t, &ring->shift);
}


/* radius [m] with which a panel of half width `half`, `off` before the axis, is rolled so that its sides stay on this
 * side of the axis */
static double around_bend(double off, double half)
{
    double low = fmax(off, 2.0 * half / MUS_PI), high = 100.0;
    if (low * (1.0 - mus__cos(half / low)) <= off - 0.005) return low;
    for (int32_t i = 0; i < 60; i++) {
        const double r = 0.5 * (low + high);
        if (r * (1.0 - mus__cos(half / r)) <= off - 0.005)
            high = r;
        else
            low = r;
    }
    return high;
}


/* places a panel of a ring that has a front and a back */
static void around_half(const mus__arrangement *arrangement, const mus__arranged_ring *ring, mus__arranged_panel *panel)
{
    const bool front = mus__cos(around_azimuth(ring, panel)) >= 0.0;
    const double middle = 0.5 * (panel->low[0] + panel->high[0]);

    /* the line that stands at the middle of the front, or of the back */
    double line = ((front ? 0.0 : MUS_PI) - ring->phase) * ring->girth / (2.0 * MUS_PI) - panel->u;
    line -= floor((line - middle) / ring->girth + 0.5) * ring->girth;
    const double half = fmax(fabs(panel->low[0] - line), fabs(panel->high[0] - line));
    double off = ring->radius;
    if (ring->limb == MUS__ARRANGE_TRUNK && ring->axis[0] == 0.0)
        off = ring->hangs ? arrangement->off
              : ring->fork || ring->fan
                  ? arrangement->belly
                  : fmin(fmax(arrangement->belly, ring->wide / (2.0 * MUS_PI) + 0.01), AROUND_RADIUS);
    off += AROUND_LAYER * ring->layer;
    panel->line = line;
    panel->bend = ring->hangs && ring->closed ? AROUND_BEND * ring->girth : around_bend(off, half);
    if (!ring->closed && !ring->hangs && half > AROUND_WIDE * off) panel->bend = 0.0;
    for (int32_t d = 0; d < 3; d++) {
        panel->out[d] = (front ? 1.0 : -1.0) * ring->front[d];
        panel->along[d] = (front ? 1.0 : -1.0) * ring->right[d];
        panel->up[d] = ring->up[d];
        panel->at[d] = ring->axis[d] + (panel->v + ring->shift) * ring->up[d] + off * panel->out[d];
    }

    /* panels round one leg stay on its side; of panels round both legs, each fork stays on the side of its leg */
    const double reach = panel->bend > 0.0 ? panel->bend * mus__sin(fmin(half / panel->bend, 0.5 * MUS_PI)) : half;
    if (ring->axis[0] != 0.0 && reach + AROUND_APART_LEGS > fabs(ring->axis[0]))
        panel->at[0] += copysign(reach + AROUND_APART_LEGS, ring->axis[0]) - ring->axis[0];
    const double width = panel->high[0] - panel->low[0];
    const double over = middle > line ? line - panel->low[0] : panel->high[0] - line;
    if (!ring->fork || !(over > 0.0 && over < AROUND_OVER * width)) return;
    for (int32_t d = 0; d < 3; d++) panel->at[d] += copysign(fmin(over, AROUND_FORK), middle - line) * panel->along[d];
}


/* places a panel on a round ring, rolled if its own y runs along the limb */
static void around_ring(const mus__arranged_ring *ring, mus__arranged_panel *panel)
{
    const double a = around_azimuth(ring, panel), c = mus__cos(a), s = mus__sin(a);
    panel->line = 0.5 * (panel->low[0] + panel->high[0]);
    panel->bend = panel->turn[1] == 0.0 ? ring->radius : 0.0;
    for (int32_t d = 0; d < 3; d++) {
        panel->out[d] = c * ring->front[d] + s * ring->right[d];
        panel->along[d] = c * ring->right[d] - s * ring->front[d];
        panel->up[d] = ring->up[d];
        panel->at[d] = ring->axis[d] + (panel->v + ring->shift) * ring->up[d] + ring->radius * panel->out[d];
    }
}


/* places the panels of a ring */
static void around_set(mus__arrangement *arrangement, int32_t t)
{
    mus__arranged_ring *ring = &arrangement->ring[t];
    ring->halves = ring->limb == MUS__ARRANGE_TRUNK;
    for (int32_t p = 0; p < arrangement->npanel; p++)
        if (arrangement->panel[p].ring == t && !ring->hangs &&
            fabs(mus__cos(around_azimuth(ring, &arrangement->panel[p]))) < AROUND_SIDE)
            ring->halves = 0;
    if (ring->limb == MUS__ARRANGE_TRUNK && !ring->halves && ring->axis[0] == 0.0)
        ring->radius = fmin(fmax(arrangement->belly, ring->wide / (2.0 * MUS_PI) + 0.01), AROUND_RADIUS) +
                       AROUND_LAYER * ring->layer;
    for (int32_t p = 0; p < arrangement->npanel; p++) {
        mus__arranged_panel *panel = &arrangement->panel[p];
        if (panel->ring != t) continue;
        if (ring->halves)
            around_half(arrangement, ring, panel);
        else
            around_ring(ring, panel);
    }
    ring->set = 1;
}


/* height [m] of the highest point of a ring; *aside gets its distance from the middle plane [m] */
static double around_top(const mus__arrangement *arrangement, int32_t t, double *aside)
{
    double top = -1e30;
    for (int32_t p = 0; p < arrangement->npanel; p++) {
        const mus__arranged_panel *panel = &arrangement->panel[p];
        for (int32_t i = 0; i < panel->nedge && panel->ring == t; i++)
            for (int32_t k = 0; k < MUS__ARRANGE_DOTS; k++) {
                const double *dot = arrangement->edge[panel->edge[i]].dot + 2 * k;
                if (!(panel->v + dot[1] > top)) continue;
                double x[3];
                mus__arrange_point(panel, dot[0], dot[1], x);
                top = panel->v + dot[1], *aside = fabs(x[0]);
            }
    }
    return top;
}


/* *shift gets the shift [m] that puts the edge attached highest at its level; false without attached edges */
static bool around_held(const mus__arrangement *arrangement, int32_t t, double *shift)
{
    double highest = -1e30;
    for (int32_t e = 0; e < arrangement->nedge; e++) {
        const mus__arranged_edge *edge = &arrangement->edge[e];
        int32_t level;
        double below, mean = 0.0;
        if (edge->panel == MUS_NONE || arrangement->panel[edge->panel].ring != t) continue;
        if (mus_pattern_edge_hold(arrangement->pattern, e, &level, &below) != MUS_OK || level == MUS_HOLD_NONE)
            continue;
        const mus__body_level *at = arrangement->body->level[level];
        if (!at->there || !(at->point[1] - below > highest)) continue;
        for (int32_t k = 0; k < MUS__ARRANGE_DOTS; k++) mean += edge->dot[2 * k + 1] / MUS__ARRANGE_DOTS;
        highest = at->point[1] - below;
        *shift = highest - arrangement->panel[edge->panel].v - mean;
    }
    return highest > 0.0;
}


/* places the first ring of a component: turned by sides and shoulders, hung by the shoulders, by attached edges, or at
 * the waist */
static void around_hang(mus__arrangement *arrangement, int32_t t)
{
    mus__arranged_ring *ring = &arrangement->ring[t];
    double aside = 0.0;
    around_site(arrangement, t);
    around_turn(arrangement, t);
    around_set(arrangement, t);
    const double top = around_top(arrangement, t, &aside);
    if (ring->hangs) {
        ring->shift =
            arrangement->level[AROUND_NECK] - 0.4 * fmax(0.0, aside - 0.07) - top + AROUND_LAYER * ring->layer;
    } else if (!around_held(arrangement, t, &ring->shift)) {
        ring->shift = arrangement->level[AROUND_WAIST] - top;
    }
    around_set(arrangement, t);
}


/* *least: length [m] of the shortest opening of the sewn pattern; 0 without any. Errors: MUS_ERR_MEMORY */
static mus_status around_opening(const mus__arrangement *arrangement, double *least)
{
    int32_t edges = 0;
    mus_topology topology;
    *least = 0.0;
    mus_topology_init(&topology, sizeof topology);
    mus_status status = mus_pattern_topology(arrangement->pattern, &topology);
    for (int32_t i = 0; i < topology.loops && status == MUS_OK; i++) {
        double length = 0.0;
        status = mus_pattern_loop(arrangement->pattern, i, NULL, 0, &edges, &length);
        if (status == MUS_OK && (i == 0 || length < *least)) *least = length;
    }
    return status == MUS_ERR_MEMORY ? status : MUS_OK;
}


/* whether another panel of its ring is sewn above a panel, to an edge that points up: a yoke above a leg */
static bool around_covered(const mus__arrangement *arrangement, int32_t panel)
{
    for (int32_t i = 0; i < arrangement->nseam; i++) {
        const mus__arranged_edge *a = &arrangement->edge[arrangement->seam[i].a],
                                 *b = &arrangement->edge[arrangement->seam[i].b];
        const mus__arranged_edge *own = a->panel == panel ? a : b, *other = own == a ? b : a;
        if (own->panel != panel || other->panel == panel) continue;
        if (arrangement->panel[other->panel].ring != arrangement->panel[panel].ring) continue;
        if (own->outward[1] > MUS__EDGE_UP && other->outward[1] < -MUS__EDGE_UP) return true;
    }
    return false;
}


/* whether a ring lies on the shoulders: a sleeve is sewn to it, or two of its edges that both point up are sewn, of
 * panels that nothing is above (else they are those of a crotch below a yoke, which curves up). Where an opening is too
 * small for a waist (`apart`), or with a collar, an edge of another ring counts too if nothing is above */
static bool around_hangs(const mus__arrangement *arrangement, int32_t t, bool apart)
{
    bool level = false, below = false, neck = false;
    for (int32_t i = 0; i < arrangement->nseam; i++) {
        const mus__arranged_seam *seam = &arrangement->seam[i];
        const mus__arranged_edge *a = &arrangement->edge[seam->a], *b = &arrangement->edge[seam->b];
        const mus__arranged_panel *p = &arrangement->panel[a->panel], *q = &arrangement->panel[b->panel];
        if (p->ring != t && q->ring != t) continue;
        if (p->limb != q->limb && p->limb + q->limb == MUS__ARRANGE_TRUNK + MUS__ARRANGE_ARM) return true;
        if (p->limb != q->limb && p->limb + q->limb == MUS__ARRANGE_TRUNK + MUS__ARRANGE_NECK) neck = true;
        const bool up = a->outward[1] > MUS__EDGE_UP, other = b->outward[1] > MUS__EDGE_UP;
        if (p != q && up && other) {
            if (p->ring == q->ring && seam->high > -AROUND_SLOPE && !around_covered(arrangement, a->panel) &&
                !around_covered(arrangement, b->panel))
                return true;
            level = level || (p->ring != q->ring && p->limb == q->limb && seam->high > -2.0 * AROUND_SLOPE);
        }
        if (p->limb == q->limb && (p->ring == t ? up && !other : other && !up)) below = true;
    }
    return (apart || neck) && level && !below;
}


/* the ring of a component that is placed first: one that hangs, then the one of the largest girth round the trunk */
static int32_t around_first(const mus__arrangement *arrangement, int32_t piece)
{
    int32_t best = MUS_NONE;
    double most = -1.0;
    for (int32_t t = 0; t < arrangement->nring; t++) {
        const mus__arranged_ring *ring = &arrangement->ring[t];
        if (ring->component != piece || ring->set) continue;
        double worth = ring->girth + (ring->hangs ? 100.0 : 0.0) + (ring->limb == MUS__ARRANGE_TRUNK ? 1000.0 : 0.0),
               shift;
        if (around_held(arrangement, t, &shift)) worth += 50.0;
        if (worth > most) most = worth, best = t;
    }
    return best;
}


/* the ring that is sewn longest to rings that have their place; MUS_NONE without any */
static int32_t around_next(const mus__arrangement *arrangement)
{
    int32_t best = MUS_NONE;
    double most = 0.0;
    for (int32_t t = 0; t < arrangement->nring; t++) {
        double mean[3];
        if (arrangement->ring[t].set) continue;
        const double length = around_partners(arrangement, t, mean);
        if (length > most) most = length, best = t;
    }
    return best;
}


mus_status mus__arrange_limbs(mus__arrangement *arrangement)
{
    double opening = 0.0;
    mus_status status = around_body(arrangement);
    if (status == MUS_OK) status = around_opening(arrangement, &opening);
    if (status != MUS_OK) return status;
    const double waist = mus_body_made(arrangement->body, MUS_MEASURE_WAIST);
    const bool apart = opening < AROUND_WAIST_PART * waist;
    for (int32_t t = 0; t < arrangement->nring; t++)
        arrangement->ring[t].hangs =
            arrangement->ring[t].limb == MUS__ARRANGE_TRUNK && around_hangs(arrangement, t, apart);
    bool told = false;
    for (int32_t p = 0; p < arrangement->npanel; p++) told = told || mus_pattern_layer(arrangement->pattern, p) > 0;
    for (int32_t piece = 0, layer = 0; piece < arrangement->npanel; piece++) {
        int32_t t = around_first(arrangement, piece);
        if (t == MUS_NONE) continue;
        for (int32_t i = 0; i < arrangement->nring; i++)
            if (arrangement->ring[i].component == piece) arrangement->ring[i].layer = layer;
        layer += !told;
        around_hang(arrangement, t);
        while ((t = around_next(arrangement)) != MUS_NONE) {
            around_site(arrangement, t);
            around_turn(arrangement, t);
            around_set(arrangement, t);
        }
    }
    return MUS_OK;
}
