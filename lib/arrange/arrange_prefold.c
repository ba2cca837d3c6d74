/*
 * arrange_prefold.c: folds panels that fan out wide before they are sewn with self-contact.
 *
 * Half a circle skirt that starts flat stands up to the waist on both sides: its seams would be drawn shut across the
 * arms, and cloth that lies on a hand stays there. Folded as it will hang, its sides go down below the arms. Every
 * curve on the unit sphere as long as the fan's angle makes a cone of the fan without strain, with straight rays; here
 *
 *     a(s) = A (s - 1/2),   b(s) = B (1 - cos(2 pi n s)) / 2,   0 <= s <= 1,
 *
 * with a the angle in the plane of the panel and b the angle out of it, on the right side. B is such that the length is
 * right. The apex is the point where the two sides meet, the straight seams that hold the panel between them. The hem
 * is free: a front with its sleeves is wide between its shoulder seams too, and is no fan.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "base/elementary.h"
#include "geom/vec.h"

#define PANEL_FAN_WIDE 1.9      /* [rad] wider fans are folded; this and all below: chosen */
#define PANEL_FAN_TO 1.75       /* [rad] from side to side after folding, at most */
#define PANEL_FAN_FOLD 0.8      /* [rad] of the fan to a fold */
#define PANEL_FAN_FLAT 0.98     /* length of the mean normal: that of a flat panel is 1 */
#define PANEL_FAN_SIDE 0.1      /* [m] shortest side */
#define PANEL_FAN_STRAIGHT 0.99 /* of a side: its chord over its arc length */
#define PANEL_FAN_MEET 0.1      /* of the longest side: how far the sides may miss the apex */
#define PANEL_FAN_BESIDE 0.15   /* [rad] how far nodes may be beyond the sides */
#define PANEL_FAN_LONG 0.5      /* of the distance from apex to hem: the sides are longer; a band is no fan */
#define PANEL_FAN_SEWN 0.5      /* of the sides, from their inner ends: other seams are nearer to the apex */
#define PANEL_FAN_SEAMS 32      /* seams of a panel that are looked at */
#define PANEL_FAN_STEPS 512     /* steps of the curve's arc length */

/* a seam of a panel to another panel: its ends on the panel, and its arc length */
typedef struct fan_side {
    int32_t seam;
    double from[3], to[3], way;
} fan_side;

typedef struct fan_shape {
    double apex[3], middle[3], aside[3], out[3]; /* frame: middle and aside in the plane */
    double half;                                 /* angle from the middle to a side */
    double to;                                   /* angle from side to side after folding */
    double length;                               /* of both sides [m] */
} fan_shape;


static double fan_apart(const double *a, const double *b)
{
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return mus__norm3(d);
}


/* straight seams of panel p to other panels; returns their number */
static int32_t fan_sides(const mus__placed_cloth *placed, int32_t p, fan_side *side)
{
    const mus_cloth *cloth = placed->cloth;
    int32_t count = 0, kept = 0;
    for (int32_t i = 0; i < cloth->npair; i++) {
        const int32_t a = cloth->pair[2 * (int64_t)i], b = cloth->pair[2 * (int64_t)i + 1];
        const bool first = cloth->node_panel[a] == p;
        if (cloth->node_panel[a] == cloth->node_panel[b] || !(first || cloth->node_panel[b] == p)) continue;
        const double *x = placed->x + 3 * (int64_t)(first ? a : b);
        if (count == 0 || side[count - 1].seam != cloth->pair_seam[i]) {
            if (count == PANEL_FAN_SEAMS) break;
            side[count].seam = cloth->pair_seam[i], side[count].way = 0.0;
            memcpy(side[count].from, x, sizeof side->from);
            memcpy(side[count].to, x, sizeof side->to);
            count++;
            continue;
        }
        side[count - 1].way += fan_apart(side[count - 1].to, x);
        memcpy(side[count - 1].to, x, sizeof side->to);
    }
    for (int32_t i = 0; i < count; i++)
        if (side[i].way >= PANEL_FAN_SIDE && fan_apart(side[i].from, side[i].to) >= PANEL_FAN_STRAIGHT * side[i].way)
            side[kept++] = side[i];
    return kept;
}


/* angle [rad] of a point from the middle of the fan; *far gets its distance from the apex [m] */
static double fan_angle(const fan_shape *fan, const double *x, double *far)
{
    const double d[3] = {x[0] - fan->apex[0], x[1] - fan->apex[1], x[2] - fan->apex[2]};
    const double along = mus__dot3(d, fan->middle), aside = mus__dot3(d, fan->aside);
    *far = sqrt(along * along + aside * aside);
    return mus__atan2(aside, along);
}


/* whether panel p is sewn to another one beside its two sides only near the apex, no farther off than `most` */
static bool fan_free(const mus__placed_cloth *placed, int32_t p, const fan_shape *fan, const fan_side *one,
                     const fan_side *two, double most)
{
    const mus_cloth *cloth = placed->cloth;
    for (int32_t i = 0; i < cloth->npair; i++) {
        const int32_t *pair = cloth->pair + 2 * (int64_t)i;
        const bool first = cloth->node_panel[pair[0]] == p, second = cloth->node_panel[pair[1]] == p;
        double far;
        if (first == second || cloth->pair_seam[i] == one->seam || cloth->pair_seam[i] == two->seam) continue;
        fan_angle(fan, placed->x + 3 * (int64_t)pair[first ? 0 : 1], &far);
        if (far > most) return false;
    }
    return true;
}


/* the angle from side to side after folding. A fan on one leg, whose inner ends both lie on one side of the middle
 * plane, stays on that side: its sides are sewn to those of another panel, and the other leg would stand between them
 */
static double fan_to(const mus__placed_cloth *placed, int32_t p, const fan_shape *fan, bool beside)
{
    const mus__panel_mesh *mesh = &placed->cloth->panel[p];
    double most = 0.0, far;
    if (!beside) return PANEL_FAN_TO;
    for (int32_t i = mesh->first_node; i < mesh->first_node + mesh->node_count; i++) {
        fan_angle(fan, placed->x + 3 * (int64_t)i, &far);
        most = fmax(most, far);
    }
    return fmin(PANEL_FAN_TO, 2.0 * mus__asin(fmin(fabs(fan->apex[0]) / most, 1.0)));
}


/* the fan between two sides of panel p; false where they do not hold all of it between them, its hem is sewn, or it is
 * not wide */
static bool fan_between(const mus__placed_cloth *placed, int32_t p, const fan_side *one, const fan_side *two,
                        fan_shape *fan)
{
    const mus__panel_mesh *mesh = &placed->cloth->panel[p];
    const double *in[2] = {one->from, two->from}, *out[2] = {one->to, two->to};
    double way[2][3], apart[3], turn[3], least = INFINITY, middle[3], far;

    /* the ends that are nearest to each other are the inner ones */
    for (int32_t k = 0; k < 4; k++) {
        const double *a = k % 2 ? one->to : one->from, *b = k / 2 ? two->to : two->from;
        if (!(fan_apart(a, b) < least)) continue;
        least = fan_apart(a, b);
        in[0] = a, in[1] = b, out[0] = k % 2 ? one->from : one->to, out[1] = k / 2 ? two->from : two->to;
    }
    for (int32_t k = 0; k < 2; k++) {
        for (int32_t d = 0; d < 3; d++) way[k][d] = out[k][d] - in[k][d];
        mus__unit3(way[k]);
    }

    /* both go on by the same length to the apex */
    for (int32_t d = 0; d < 3; d++) apart[d] = in[0][d] - in[1][d], turn[d] = way[0][d] - way[1][d];
    if (!(mus__dot3(turn, turn) > 0.1)) return false;
    const double back = mus__dot3(apart, turn) / mus__dot3(turn, turn);
    double miss2 = 0.0;
    for (int32_t d = 0; d < 3; d++) {
        const double a = in[0][d] - back * way[0][d], b = in[1][d] - back * way[1][d];
        fan->apex[d] = 0.5 * (a + b);
        miss2 += (a - b) * (a - b);
    }
    const double most = PANEL_FAN_MEET * fmax(one->way, two->way);
    if (back < 0.0 || miss2 > most * most) return false;
    if (!(fmin(one->way, two->way) > PANEL_FAN_LONG * (back + fmin(one->way, two->way)))) return false;

    mus__placed_middle(placed, p, middle);
    for (int32_t d = 0; d < 3; d++) fan->middle[d] = middle[d] - fan->apex[d];
    const double off = mus__dot3(fan->middle, fan->out);
    for (int32_t d = 0; d < 3; d++) fan->middle[d] -= off * fan->out[d];
    mus__unit3(fan->middle);
    mus__cross3(fan->out, fan->middle, fan->aside);
    const double left = fan_angle(fan, out[0], &far), right = fan_angle(fan, out[1], &far);
    if (!(left * right < 0.0)) return false;
    fan->half = fmax(fabs(left), fabs(right));
    fan->length = one->way + two->way;
    if (!(2.0 * fan->half > PANEL_FAN_WIDE)) return false;
    if (!fan_free(placed, p, fan, one, two, back + PANEL_FAN_SEWN * fmin(one->way, two->way))) return false;
    /* each node is at least half as far from the apex as the arc, or the chord, between the inner ends */
    const double straight = mus__cos(fan->half), hole = 0.5 * back * (straight > 0.0 ? straight : 1.0);
    for (int32_t i = mesh->first_node; i < mesh->first_node + mesh->node_count; i++) {
        const double beyond = fabs(fan_angle(fan, placed->x + 3 * (int64_t)i, &far)) - fan->half;
        if (far < hole || beyond > PANEL_FAN_BESIDE) return false;
    }
    fan->to = fan_to(placed, p, fan, in[0][0] * in[1][0] > 0.0);
    return true;
}


/* the widest-sided fan that panel p is; false when it is none */
static bool fan_find(const mus__placed_cloth *placed, int32_t p, fan_shape *fan)
{
    fan_side side[PANEL_FAN_SEAMS];
    fan_shape own;
    bool there = false;
    if (placed->cloth->panel[p].triangle_count == 0) return false;
    mus__placed_facing(placed, p, own.out);
    if (!(mus__norm3(own.out) > PANEL_FAN_FLAT)) return false;
    mus__unit3(own.out);
    const int32_t count = fan_sides(placed, p, side);
    for (int32_t i = 0; i < count; i++)
        for (int32_t k = i + 1; k < count; k++) {
            if (!fan_between(placed, p, &side[i], &side[k], &own) || (there && own.length <= fan->length)) continue;
            *fan = own;
            there = true;
        }
    return there;
}


/* arc length of the curve of n folds of height `fold` at equal steps of s, `to` wide: way (PANEL_FAN_STEPS + 1);
 * returns its end */
static double fan_curve(int32_t n, double to, double fold, double *way)
{
    const double step = 1.0 / PANEL_FAN_STEPS;
    way[0] = 0.0;
    for (int32_t i = 0; i < PANEL_FAN_STEPS; i++) {
        const double s = 2.0 * MUS_PI * n * (i + 0.5) * step;
        const double out = 0.5 * fold * (1.0 - mus__cos(s)), rise = MUS_PI * n * fold * mus__sin(s),
                     turn = to * mus__cos(out);
        way[i + 1] = way[i] + step * sqrt(turn * turn + rise * rise);
    }
    return way[PANEL_FAN_STEPS];
}


/* the nodes of a fan onto its cone */
static void fan_fold(const mus__placed_cloth *placed, int32_t p, const fan_shape *fan)
{
    const mus__panel_mesh *mesh = &placed->cloth->panel[p];
    const int32_t n = (int32_t)ceil(2.0 * fan->half / PANEL_FAN_FOLD);
    double way[PANEL_FAN_STEPS + 1], low = 0.0, high = 1.5;
    for (int32_t i = 0; i < 50; i++) {
        const double fold = 0.5 * (low + high);
        if (fan_curve(n, fan->to, fold, way) < 2.0 * fan->half)
            low = fold;
        else
            high = fold;
    }
    const double all = fan_curve(n, fan->to, low, way);
    for (int32_t i = mesh->first_node; i < mesh->first_node + mesh->node_count; i++) {
        double *x = placed->x + 3 * (int64_t)i, far;
        const double angle = fan_angle(fan, x, &far);
        const double want = all * fmin(fmax(0.5 + 0.5 * angle / fan->half, 0.0), 1.0);
        int32_t k = 0;
        while (k < PANEL_FAN_STEPS - 1 && way[k + 1] < want) k++;
        const double s = (k + (want - way[k]) / (way[k + 1] - way[k])) / PANEL_FAN_STEPS;
        const double a = fan->to * (s - 0.5), b = 0.5 * low * (1.0 - mus__cos(2.0 * MUS_PI * n * s));
        for (int32_t d = 0; d < 3; d++)
            x[d] = fan->apex[d] + far * (mus__cos(b) * (mus__cos(a) * fan->middle[d] + mus__sin(a) * fan->aside[d]) +
                                         mus__sin(b) * fan->out[d]);
    }
}


bool mus__arrange_fans(const mus__placed_cloth *placed)
{
    bool moved = false;
    for (int32_t p = 0; p < placed->cloth->npanel; p++) {
        fan_shape fan;
        if (!fan_find(placed, p, &fan)) continue;
        fan_fold(placed, p, &fan);
        moved = true;
    }
    return moved;
}
