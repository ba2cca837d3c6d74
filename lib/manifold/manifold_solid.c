/*
 * manifold_solid.c: the solids whose union is a body: the radius fields of its parts, and its fingers and toes.
 *
 * A body that is drawn with fingers and toes has shorter palms and balls of the feet, from which they grow. A digit is
 * read from its rings in the skin: elliptic cross-sections, whose squared half axes are linear between two rings, which
 * closes the tip round. Two digits beside each other have a web, so that the gap that is left between them is wider
 * than the lattice's spacing: the smooth union
 *
 *     max(d1, d2) + k/4 (1 - |d1 - d2|/k)^2
 *
 * of their depths fills gaps up to k/2 (Quilez, Smooth Minimum, 2013).
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "manifold/manifold_solid.h"

/* [m] step along a limb at which the part that is drawn shorter is measured; any small length will do, since it is a
 * constant share */
#define SOLID_STEP 1e-3


/* make the box of a solid hold x (3) */
static void solid_hold(mus__solid *solid, const double *x)
{
    for (int i = 0; i < 3; i++) {
        solid->low[i] = fmin(solid->low[i], x[i]);
        solid->high[i] = fmax(solid->high[i], x[i]);
    }
}


static mus__solid *solid_new(mus__solids *out)
{
    mus__solid *solid = &out->solid[out->count++];
    memset(solid, 0, sizeof *solid);
    for (int i = 0; i < 3; i++) solid->low[i] = INFINITY, solid->high[i] = -INFINITY;
    return solid;
}


/* the solid of a part, its box from the entries of its field */
static void solid_of_field(const mus_body *body, int32_t part, mus__solids *out)
{
    const mus__field *field = &body->field[part];
    const int32_t l = body->rig.part[part].limb, n = field->nangle;
    double turn[2 * MUS__FIELD_MOST];
    mus__solid *solid = solid_new(out);
    mus__field_turns(n, turn);
    solid->field = field;
    solid->keep = 1.0, solid->from = field->pole[1];

    /* the part that is drawn shorter ends at the pole: its share, and where it begins */
    const double end = mus__relief_short(body, l, body->limb[l].pole[1]);
    const double before = mus__relief_short(body, l, body->limb[l].pole[1] - SOLID_STEP);
    if (end > before) {
        solid->keep = 1.0 - (end - before) / SOLID_STEP;
        solid->from = body->limb[l].pole[1] - end / (1.0 - solid->keep);
    }
    for (int32_t j = -1; j <= field->nring; j++) {
        const int32_t ring = j < 0 ? 0 : j < field->nring ? j : field->nring - 1;
        const double s = j < 0 ? field->pole[0] : j < field->nring ? field->s0 + j * field->ds : field->pole[1];
        const double *centre = field->centre + 2 * (ptrdiff_t)ring, *radius = field->radius + (ptrdiff_t)ring * n;
        for (int32_t k = 0; k < n; k++) {
            const double r = j == ring ? radius[k] : 0.0;
            const double a = centre[0] + r * turn[2 * k], b = centre[1] + r * turn[2 * k + 1];
            double x[3];
            for (int i = 0; i < 3; i++)
                x[i] = field->origin[i] + s * field->axis[i] + a * field->side[i] + b * field->front[i];
            solid_hold(solid, x);
        }
    }
}


/* the cross-sections of a digit whose rings of the skin begin at x: an end point, rings, the tip */
static void solid_stations(const double *x, mus__digit *out)
{
    const int32_t n = MUS__DIGIT_ROUND, last = MUS__DIGIT_STATIONS - 1;
    mus__station *station = out->station;
    for (int32_t j = 0; j <= last; j++) {
        const double *ring = x + 3 * (1 + (ptrdiff_t)j * n), *over = ring + 3 * (n / 2);
        const double *front = ring + 3 * (n / 4), *back = ring + 9 * (n / 4);
        mus__station *s = &station[j];
        if (j == last) {
            *s = station[j - 1];
            memcpy(s->centre, ring, sizeof s->centre);
            s->square = 0.0;
            continue;
        }
        for (int i = 0; i < 3; i++) s->centre[i] = 0.5 * (ring[i] + over[i]), s->side[i] = 0.5 * (ring[i] - over[i]);
        s->square = mus__dot3(s->side, s->side);
        mus__unit3(s->side);

        /* the floor flattens one of front and back */
        double u = 0.0, v = 0.0;
        for (int i = 0; i < 3; i++) {
            u += (front[i] - s->centre[i]) * (front[i] - s->centre[i]);
            v += (back[i] - s->centre[i]) * (back[i] - s->centre[i]);
        }
        s->flat = sqrt(fmax(u, v) / s->square);
    }
    for (int32_t j = 0; j <= last; j++) {
        const double *from = station[j > 0 ? j - 1 : 0].centre, *to = station[j < last ? j + 1 : last].centre;
        mus__station *s = &station[j];
        for (int i = 0; i < 3; i++) s->along[i] = to[i] - from[i];
        mus__unit3(s->along);
        mus__cross3(s->along, s->side, s->front);
        mus__unit3(s->front);
    }
}


/* the digits of hand or foot `which` (left hand, right hand, left foot, right foot), whose vertices begin at x */
static void solid_of_digits(const mus_body *body, int32_t which, const double *x, mus__solids *out, int32_t *digits)
{
    const int32_t each = MUS__DIGIT_ROUND * MUS__DIGIT_RINGS + 2;
    for (int32_t d = 0; d < MUS__DIGITS_A_LIMB; d++, x += 3 * (ptrdiff_t)each) {
        mus__digit *digit = &out->digit[(*digits)++];
        mus__solid *solid = solid_new(out);
        memset(digit, 0, sizeof *digit);
        solid->digit = digit;
        solid_stations(x, digit);
        for (int32_t i = 0; i < each; i++) solid_hold(solid, x + 3 * (ptrdiff_t)i);
        digit->toe = which >= 2;
        digit->floor[1] = 1.0;
        for (int32_t p = 0; p < body->rig.parts && body->frame != NULL; p++) {
            if (body->rig.part[p].limb != MUS__LIMB_FOOT_LEFT - 2 + which) continue;
            mus__frame_turn(&body->frame[p], (double[]){0.0, 1.0, 0.0}, digit->floor);
            digit->floor[3] = mus__dot3(digit->floor, body->frame[p].place);
        }
    }
}


void mus__solids_make(const mus_body *body, double web, mus__solids *out)
{
    const int32_t side = MUS__DIGITS_A_LIMB * (MUS__DIGIT_ROUND * MUS__DIGIT_RINGS + 2);
    out->count = 0;
    out->web = web;
    for (int32_t p = 0; p < body->nfield; p++) solid_of_field(body, p, out);
    if (body->digit_vertices == 0) return;
    const double *x = body->vertices + 3 * (ptrdiff_t)body->vertex_count;
    int32_t digits = 0;
    for (int32_t which = 0; which < 4; which++) {
        if (!mus__digit_has(body, which)) continue;
        solid_of_digits(body, which, x, out, &digits);
        x += 3 * (ptrdiff_t)side;
    }
}


/* depth of x (3) in a digit: between two cross-sections, the distance from the ellipse between them; beyond the tip,
 * the distance from it */
static double solid_digit_depth(const mus__digit *digit, const double *x)
{
    double best = -1e30, before = -1.0;
    for (int32_t j = 0; j < MUS__DIGIT_STATIONS; j++) {
        const mus__station *s = &digit->station[j], *r = &digit->station[j > 0 ? j - 1 : 0];
        const double off[3] = {x[0] - s->centre[0], x[1] - s->centre[1], x[2] - s->centre[2]};
        const double here = mus__dot3(off, s->along);
        if (before >= 0.0 && here < 0.0) {
            const double t = before / (before - here);
            double a = 0.0, b = 0.0;
            for (int i = 0; i < 3; i++) {
                const double from = x[i] - (r->centre[i] + t * (s->centre[i] - r->centre[i]));
                a += from * (r->side[i] + t * (s->side[i] - r->side[i]));
                b += from * (r->front[i] + t * (s->front[i] - r->front[i]));
            }
            b /= r->flat + t * (s->flat - r->flat);
            best = fmax(best, sqrt(r->square + t * (s->square - r->square)) - sqrt(a * a + b * b));
        }
        if (here >= 0.0 && j == MUS__DIGIT_STATIONS - 1) best = fmax(best, -mus__norm3(off));
        before = here;
    }
    return digit->toe ? fmin(best, mus__dot3(x, digit->floor) - digit->floor[3]) : best;
}


/* depth of x in a radius field, of which a part may be drawn shorter */
static double solid_field_depth(const mus__solid *solid, const double *x)
{
    const mus__field *field = solid->field;
    double normal[3], off[3], y[3];
    if (solid->keep >= 1.0) return mus__field_depth(field, x, normal);
    for (int k = 0; k < 3; k++) off[k] = x[k] - field->origin[k];
    const double above = fmax(mus__dot3(off, field->axis) - solid->from, 0.0), more = above / solid->keep - above;
    for (int k = 0; k < 3; k++) y[k] = x[k] + more * field->axis[k];
    return mus__field_depth(field, y, normal);
}


/* bounds: the box; for a field the largest radius of the rings that the ball reaches along the axis */
bool mus__solid_near(const mus__solid *solid, const double *x, double r)
{
    const mus__field *field = solid->field;
    for (int i = 0; i < 3; i++)
        if (x[i] + r < solid->low[i] || x[i] - r > solid->high[i]) return false;
    if (field == NULL || solid->keep < 1.0) return true;
    double off[3];
    for (int i = 0; i < 3; i++) off[i] = x[i] - field->origin[i];
    const double s = mus__dot3(off, field->axis), a = mus__dot3(off, field->side), b = mus__dot3(off, field->front);
    if (s + r < field->pole[0] || s - r > field->pole[1]) return false;
    const double last = field->nring - 2.0, low = floor((s - r - field->s0) / field->ds);
    const double high = floor((s + r - field->s0) / field->ds);
    for (int32_t j = (int32_t)fmin(fmax(low, 0.0), last); j <= (int32_t)fmin(fmax(high, 0.0), last); j++) {
        const double *c = field->centre + 2 * (ptrdiff_t)j, most = field->largest[j] + r;
        for (int k = 0; k < 4; k += 2)
            if ((a - c[k]) * (a - c[k]) + (b - c[k + 1]) * (b - c[k + 1]) <= most * most) return true;
    }
    return false;
}


double mus__solids_depth(const mus__solids *solids, int32_t n, const int32_t *list, const double *x, double enough)
{
    double best = -1e30, first = -1e30;
    int32_t limb = MUS_NONE;
    for (int32_t i = 0; i < n && best <= enough; i++) {
        const mus__solid *solid = &solids->solid[list[i]];
        if (solid->digit == NULL) {
            best = fmax(best, solid_field_depth(solid, x));
            continue;
        }

        /* digits of one hand or foot: the smooth union of the one before and this one */
        const int32_t here = (int32_t)(solid->digit - solids->digit) / MUS__DIGITS_A_LIMB;
        const double depth = solid_digit_depth(solid->digit, x), apart = fabs(depth - first);
        best = fmax(best, depth);
        if (here == limb && apart < solids->web) {
            const double share = 1.0 - apart / solids->web;
            best = fmax(best, fmax(depth, first) + 0.25 * solids->web * share * share);
        }
        limb = here, first = depth;
    }
    return best;
}
