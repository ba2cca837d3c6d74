/*
 * skirt_round.c: circle skirts: a quarter, a half, three quarters and a full circle.
 *
 *          apex        Of a circle's part f the waist is an arc of radius r = waist / (2 pi f), the hem one of r + L.
 *         .`|`.        It is cut in four sectors with seams at the centres and the sides; a sector is drawn about its
 *      r ´  |  `       own middle line, the waist at its lowest point at y = 0. Where the hem falls from front to back
 *       (---0---)      (hi-low), its radius changes with the cosine of the angle from centre front, and it is drawn as
 *   L  /         \     cubics through points and tangents.
 *     (___________)
 *
 * Sectors start as parts of a cone, tilted outwards by asin f, at most by ROUND_TILT. A sector that is then wider than
 * its quarter of the circle is rolled about its middle line until its hem meets that of the next sector.
 * Formulas: man page mus_design(3).
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "style/waist_edge.h"

/* [rad] largest tilt of a sector from the vertical at the start (45 degrees), so that it starts below the hands of arms
 * that hang at 40 degrees */
#define ROUND_TILT 0.785
#define ROUND_HEM_PIECES 2

typedef struct round_plan {
    double part;   /* share of a full circle, 0.25 to 1 */
    double radius; /* of the waist's arc [m] */
    double net[2]; /* waist length of the front and the back sector [m] */
    double length; /* mean length from waist to hem [m] */
    double fall;   /* [m] the centre back is longer than `length` by it, the centre front shorter */
} round_plan;


static double round_part(int32_t kind)
{
    if (kind == MUS__SKIRT_QUARTER) return 0.25;
    if (kind == MUS__SKIRT_HALF) return 0.5;
    return kind == MUS__SKIRT_THREE_QUARTER ? 0.75 : 1.0;
}


/* Writes the hem's radius [m] and its derivative at the angle `way` [rad] from centre front, 0 to pi part. */
static void round_hem_at(const round_plan *plan, double way, double *radius, double *slope)
{
    const double rate = 1.0 / plan->part; /* pi over the angle of the half garment */
    *radius = plan->radius + plan->length - plan->fall * mus__cos(rate * way);
    *slope = rate * plan->fall * mus__sin(rate * way);
}


/* Writes the point at `radius` and `angle` [rad] from the sector's middle line; the apex of the sector is at (0, r). */
static void round_point(const round_plan *plan, double radius, double angle, double *out)
{
    out[0] = radius * mus__sin(angle);
    out[1] = plan->radius - radius * mus__cos(angle);
}


/* Writes the hem of a sector of half angle `angle` [rad], from the centre line to the side: one arc, or
 * ROUND_HEM_PIECES cubics with the exact points and derivatives at their ends. */
static void round_hem(const round_plan *plan, bool front, double angle, mus__chain *out)
{
    const double whole = MUS_PI * plan->part, far = plan->radius + plan->length;
    if (plan->fall == 0.0) {
        double a[2], middle[2], b[2];
        round_point(plan, far, -angle, a);
        round_point(plan, far, 0.0, middle);
        round_point(plan, far, angle, b);
        mus__chain_arc(out, a, middle, b);
        return;
    }
    const double step = 2.0 * angle / ROUND_HEM_PIECES, sign = front ? 1.0 : -1.0;
    out->npiece = 0;
    for (int i = 0; i < ROUND_HEM_PIECES; i++) {
        double p[2][2], d[2][2];
        for (int j = 0; j < 2; j++) {
            const double phi = -angle + (i + j) * step, way = front ? phi + angle : whole - (phi + angle);
            double radius, slope;
            round_hem_at(plan, way, &radius, &slope);
            round_point(plan, radius, phi, p[j]);
            d[j][0] = radius * mus__cos(phi) + sign * slope * mus__sin(phi);
            d[j][1] = radius * mus__sin(phi) - sign * slope * mus__cos(phi);
        }
        mus__chain_add_cubic(out, p[0], p[0][0] + step / 3.0 * d[0][0], p[0][1] + step / 3.0 * d[0][1],
                             p[1][0] - step / 3.0 * d[1][0], p[1][1] - step / 3.0 * d[1][1], p[1]);
    }
}


/* Places a sector as a part of a cone whose waist lies off the body. With bend radius b the hem's corner (x, y) lies
 * b sin(x/b) sidewards and off - y sin(tilt) - d cos(tilt) outwards, d = b (1 - cos(x/b)). b is reduced until the first
 * is at most the second: then four sectors fit round the body. */
static void round_place(mus__half *half, const round_plan *plan, int32_t panel, bool front, const double *corner)
{
    const double around = (front ? 0.25 : 0.75) * MUS_PI, tilt = fmin(mus__asin(plan->part), ROUND_TILT);
    const double off = 0.05 + half->measures.v[MUS_MEASURE_WAIST] / (2.0 * MUS_PI);
    const double origin[3] = {off * mus__sin(around), half->waist_level + mus__lower_level(half),
                              off * mus__cos(around)};
    const double x = fabs(corner[0]);
    double bend = 0.0;
    for (int i = 0; i < 40; i++) {
        const double along = bend > 0.0 ? bend * mus__sin(x / bend) : x;
        const double drop = bend > 0.0 ? bend * (1.0 - mus__cos(x / bend)) : 0.0;
        if (along <= off - corner[1] * mus__sin(tilt) - drop * mus__cos(tilt)) break;
        bend = bend > 0.0 ? 0.95 * bend : 2.0 * x;
    }
    mus__lower_place(half, panel, around, tilt, origin, bend);
}


/* Draws and places one sector: hem, side seam upwards, waist, centre seam downwards. Returns its panel. */
static int32_t round_draw(mus__half *half, const round_plan *plan, bool front)
{
    const double angle = 0.5 * plan->net[front ? 0 : 1] / plan->radius;
    double a[2], middle[2], b[2];
    mus__chain hem, waist;
    mus__outline outline;
    mus__outline_begin(&outline);
    round_hem(plan, front, angle, &hem);
    round_point(plan, plan->radius, angle, a);
    round_point(plan, plan->radius, 0.0, middle);
    round_point(plan, plan->radius, -angle, b);
    mus__chain_arc(&waist, a, middle, b);
    mus__outline_add(&outline, "hem", "hem", 1.5 * MUS__CM, &hem);
    mus__outline_line(&outline, "side", "side", 1.0 * MUS__CM, hem.xy + 2 * (hem.nxy - 1), a);
    mus__outline_add(&outline, "waist", "waist", 1.0 * MUS__CM, &waist);
    mus__outline_line(&outline, "centre", "centre", 1.0 * MUS__CM, b, hem.xy);
    const int32_t panel = mus__outline_panel(half, &outline, front ? "skirt_front" : "skirt_back", "skirt", !front);
    mus__half_centre(half, panel, "centre", MUS__CENTRE_SEAM);
    round_place(half, plan, panel, front, hem.xy);
    return panel;
}


void mus__skirt_round(mus__half *half)
{
    const double level = mus__lower_level(half);
    round_plan plan = {.part = round_part(half->style.option[MUS__AXIS_SKIRT])};
    plan.net[0] = mus__lower_net(half, true, level, 0.0);
    plan.net[1] = mus__lower_net(half, false, level, 0.0);
    if (!mus__lower_has_top(half) && half->style.option[MUS__AXIS_BAND] == MUS__BAND_ELASTIC)
        plan.net[0] = plan.net[1] = 0.5 * mus__lower_pulled(half);
    plan.radius = 2.0 * (plan.net[0] + plan.net[1]) / (2.0 * MUS_PI * plan.part);
    plan.length = mus__skirt_length(half);
    if (half->style.option[MUS__AXIS_LENGTH] == MUS__LENGTH_HI_LOW) plan.fall = 0.18 * plan.length;
    const int32_t front = round_draw(half, &plan, true), back = round_draw(half, &plan, false);
    mus__half_sew(half, front, "side", back, "side", 0.0);
}
