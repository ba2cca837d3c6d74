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

/* share by which a bound of a squared radius is widened: far above the rounding of its sums */
#define SOLID_ROUNDING 1e-9


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
    mus__field_prepare(field, &solid->query);
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

        /* within a cross-section, and up to half way to the next one */
        for (int32_t k = j > 0 ? j - 1 : 0; k <= (j < last ? j + 1 : last); k++) {
            const double *beside = station[k].centre, off[3] = {beside[0] - s->centre[0], beside[1] - s->centre[1],
                                                                beside[2] - s->centre[2]};
            const double wide = fmax(station[k].square, s->square), tall = fmax(fmax(station[k].flat, s->flat), 1.0);
            out->reach = fmax(out->reach, sqrt(wide) * tall + 0.5 * mus__norm3(off));
        }
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
    const mus__body_field *f = &solid->query;
    double normal[3], y[3] = {x[0], x[1], x[2]};
    if (solid->keep < 1.0) {
        const double off[3] = {x[0] - f->origin[0], x[1] - f->origin[1], x[2] - f->origin[2]};
        const double above = fmax(mus__dot3(off, f->axis) - solid->from, 0.0), more = above / solid->keep - above;
        for (int k = 0; k < 3; k++) y[k] = x[k] + more * f->axis[k];
    }
    return mus__field_depth_of(f, y, normal);
}


/* part of a field's table */
typedef struct solid_range {
    int32_t ring[2], entry[2]; /* the first and the last one; entries count round the contour, from -nangle on */
} solid_range;


/* entries of the directions from the centre to the rectangle low (2) to high (2): all, where it holds the centre */
static void solid_entries(const mus__field *field, const double *low, const double *high, solid_range *out)
{
    double least = 0.0, most = 0.0, first = 0.0;
    out->entry[0] = 0, out->entry[1] = field->nangle - 1;
    if (low[0] <= 0.0 && high[0] >= 0.0 && low[1] <= 0.0 && high[1] >= 0.0) return;
    for (int32_t m = 0; m < 4; m++) {
        const double a = m % 2 != 0 ? high[0] : low[0], b = m / 2 != 0 ? high[1] : low[1];
        const double part = fabs(b) / (fabs(a) + fabs(b));
        double q = b >= 0.0 ? (a >= 0.0 ? part : 2.0 - part) : (a < 0.0 ? 2.0 + part : 4.0 - part);
        if (m == 0) least = most = first = q;
        if (q - first > 2.0) q -= 4.0; /* the rectangle is seen under less than half a turn */
        if (q - first < -2.0) q += 4.0;
        least = fmin(least, q), most = fmax(most, q);
    }
    out->entry[0] = (int32_t)floor(0.25 * least * field->nangle);
    out->entry[1] = (int32_t)ceil(0.25 * most * field->nangle);
}


/* least and largest radius of a range of a table */
static void solid_radii(const mus__field *field, const solid_range *range, double *least, double *most)
{
    const int32_t n = field->nangle;
    *least = INFINITY, *most = 0.0;
    for (int32_t j = range->ring[0]; j <= range->ring[1]; j++) {
        const double *radius = field->radius + (ptrdiff_t)j * n;
        for (int32_t k = range->entry[0]; k <= range->entry[1]; k++) {
            const double r = radius[k < 0 ? k + n : k >= n ? k - n : k];
            *least = r < *least ? r : *least;
            *most = r > *most ? r : *most;
        }
    }
}


/* bounds: the square of the radius is interpolated, so it lies between that of the entries about a point. Beyond the
 * rings it is at most that of the last one; where the middle of the cap's ellipse lies beyond that too, times the part
 * by which the ellipse is wider there */
static int solid_field_box(const mus__solid *solid, const double *middle, double half)
{
    const mus__field *field = solid->field;
    const double *way[3] = {field->axis, field->side, field->front};
    const double off[3] = {middle[0] - field->origin[0], middle[1] - field->origin[1], middle[2] - field->origin[2]};
    double low[3], high[3], least, most, wide = 1.0;
    for (int i = 0; i < 3; i++) {
        const double at = mus__dot3(off, way[i]), h = half * (fabs(way[i][0]) + fabs(way[i][1]) + fabs(way[i][2]));
        low[i] = at - h, high[i] = at + h;
    }
    if (low[0] > solid->from) low[0] = solid->from + (low[0] - solid->from) / solid->keep;
    if (high[0] > solid->from) high[0] = solid->from + (high[0] - solid->from) / solid->keep;
    if (high[0] < field->pole[0] || low[0] > field->pole[1]) return MUS__BOX_OUT;

    const int32_t last = field->nring - 1;
    const double first = (low[0] - field->s0) / field->ds, end = (high[0] - field->s0) / field->ds;
    const bool beyond = first < 0.0 || end > last;
    solid_range range = {0};
    range.ring[0] = (int32_t)fmin(fmax(floor(first), 0.0), last);
    range.ring[1] = (int32_t)fmin(fmax(ceil(end), 0.0), last);
    for (int i = 0; i < 2; i++) {
        double from = INFINITY, to = -INFINITY;
        for (int32_t j = range.ring[0]; j <= range.ring[1]; j++) {
            from = fmin(from, field->centre[2 * j + i]);
            to = fmax(to, field->centre[2 * j + i]);
        }
        low[1 + i] -= to, high[1 + i] -= from;
        const double past = i == 0 ? solid->query.middle[0] : last * field->ds - solid->query.middle[1];
        if (beyond && past < 0.0) wide = fmax(wide, 1.0 / solid->query.share[i]);
    }
    double near = 0.0, far = 0.0;
    for (int i = 1; i < 3; i++) {
        const double gap = fmax(fmax(low[i], -high[i]), 0.0), reach = fmax(-low[i], high[i]);
        near += gap * gap, far += reach * reach;
    }
    if (near > wide * field->reach * field->reach) return MUS__BOX_OUT;
    solid_entries(field, low + 1, high + 1, &range);
    solid_radii(field, &range, &least, &most);
    if (near > wide * most * most * (1.0 + SOLID_ROUNDING)) return MUS__BOX_OUT;
    return !beyond && far < least * least * (1.0 - SOLID_ROUNDING) ? MUS__BOX_IN : MUS__BOX_MIXED;
}


/* two digits are joined where both are outside by less than a quarter of the web, and the deeper one changes the other
 * one's depth up to a whole web farther out */
static int solid_digit_box(const mus__solids *solids, const mus__solid *solid, const double *middle, double half)
{
    const mus__digit *digit = solid->digit;
    const double ball = sqrt(3.0) * half;
    double nearest = INFINITY;
    for (int32_t j = 0; j < MUS__DIGIT_STATIONS; j++) {
        const double *centre = digit->station[j].centre;
        const double off[3] = {middle[0] - centre[0], middle[1] - centre[1], middle[2] - centre[2]};
        nearest = fmin(nearest, mus__dot3(off, off));
    }
    nearest = sqrt(nearest) - ball - digit->reach;
    if (nearest > 1.25 * solids->web) return MUS__BOX_OUT;
    return nearest > 0.25 * solids->web ? MUS__BOX_BESIDE : MUS__BOX_MIXED;
}


int mus__solid_box(const mus__solids *solids, int32_t index, const double *middle, double half)
{
    const mus__solid *solid = &solids->solid[index];
    const double more = half + (solid->digit != NULL ? 1.25 * solids->web : 0.0);
    for (int i = 0; i < 3; i++)
        if (solid->low[i] > middle[i] + more || solid->high[i] < middle[i] - more) return MUS__BOX_OUT;
    return solid->digit != NULL ? solid_digit_box(solids, solid, middle, half) : solid_field_box(solid, middle, half);
}


void mus__solids_depth(const mus__solids *solids, int32_t count, const int32_t *list, double enough, int32_t n,
                       const double *x, double *out)
{
    for (int32_t j = 0; j < n; j++) out[j] = -1e30;
    for (int32_t i = 0; i < count; i++) {
        const mus__solid *solid = &solids->solid[list[i]];
        if (solid->digit != NULL) continue;
        for (int32_t j = 0; j < n; j++)
            if (out[j] <= enough) {
                const double depth = solid_field_depth(solid, x + 3 * (ptrdiff_t)j);
                if (depth > out[j]) out[j] = depth;
            }
    }
    if (count == 0 || solids->solid[list[count - 1]].digit == NULL) return;

    /* digits of one hand or foot: the smooth union of the one before and this one */
    for (int32_t j = 0; j < n; j++) {
        double first = -1e30, best = out[j];
        int32_t limb = MUS_NONE, before = MUS_NONE;
        for (int32_t i = 0; i < count && best <= enough; i++) {
            const mus__solid *solid = &solids->solid[list[i]];
            if (solid->digit == NULL) continue;
            const int32_t here = (int32_t)(solid->digit - solids->digit) / MUS__DIGITS_A_LIMB;
            const double depth = solid_digit_depth(solid->digit, x + 3 * (ptrdiff_t)j), apart = fabs(depth - first);
            best = fmax(best, depth);
            if (here == limb && before == list[i] - 1 && apart < solids->web) {
                const double share = 1.0 - apart / solids->web;
                best = fmax(best, fmax(depth, first) + 0.25 * solids->web * share * share);
            }
            limb = here, first = depth, before = list[i];
        }
        out[j] = best;
    }
}
