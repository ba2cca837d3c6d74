/*
 * digit_cover.c: hands and feet as cloth meets them: mittens over their fingers and toes.
 *
 * Digits are drawn beyond the fields of hand and foot, a thumb by 3 cm. Contact knows a hand or foot as one field,
 * whose rings are widened here to the convex hull of the limb's section and of all its digits at that height. Beyond
 * the last ring the field is a cap; digits there are taken at the ring where the cap begins, as far out as an ellipse
 * through them is there. Along the limb the surface rises by 45 degrees at most, where a thumb begins and ends.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "contact/offset_surface.h"
#include "geom/polygon.h"

/* of the way from the last ring to the pole, where the longest digit ends; chosen: an ellipse through it is 1/0.6 as
 * wide at the ring */
#define COVER_CAP 0.8
#define COVER_POINTS (MUS__FIELD_MOST + 3 * MUS__DIGITS_VERTICES) /* of a section: a digit has three edges a vertex */

/* memory of a cover: digits in the coordinates of the limb (s, a, b); the section of a ring, its hull, scratch */
typedef struct cover {
    double digit[3 * MUS__DIGITS_VERTICES], point[2 * COVER_POINTS];
    int32_t hull[COVER_POINTS], scratch[COVER_POINTS], count;
} cover;


/* a point of the section, from its centre */
static void cover_add(cover *c, double a, double b)
{
    c->point[2 * c->count] = a, c->point[2 * c->count + 1] = b;
    c->count++;
}


/* adds where the edge between two vertices of a digit goes through height s */
static void cover_edge(cover *c, int32_t from, int32_t to, double s, const double *centre)
{
    const double *p = c->digit + 3 * (ptrdiff_t)from, *q = c->digit + 3 * (ptrdiff_t)to;
    if ((p[0] < s) == (q[0] < s)) return;
    const double t = (s - p[0]) / (q[0] - p[0]);
    cover_add(c, p[1] + t * (q[1] - p[1]) - centre[0], p[2] + t * (q[2] - p[2]) - centre[1]);
}


/* adds the section of one digit, whose vertices begin at `first` (fingers_toes.c), at height s */
static void cover_digit(cover *c, int32_t first, double s, const double *centre)
{
    const int32_t round = MUS__DIGIT_ROUND, last = first + 1 + MUS__DIGIT_RINGS * round;
    for (int32_t k = 0; k < round; k++) {
        cover_edge(c, first, first + 1 + k, s, centre);
        cover_edge(c, last - round + k, last, s, centre);
        for (int32_t i = 0; i < MUS__DIGIT_RINGS; i++) {
            const int32_t at = first + 1 + i * round + k;
            cover_edge(c, at, first + 1 + i * round + (k + 1) % round, s, centre);
            if (i + 1 < MUS__DIGIT_RINGS) cover_edge(c, at, at + round, s, centre);
        }
    }
}


/* adds the digits beyond the last ring, as wide as the cap's ellipse through them is there */
static void cover_cap(cover *c, double last, double pole, const double *centre)
{
    for (int32_t i = 0; i < MUS__DIGITS_VERTICES; i++) {
        const double *p = c->digit + 3 * (ptrdiff_t)i, up = (p[0] - last) / (pole - last);
        const double wide = up > 0.0 && up < 1.0 ? 1.0 / sqrt(1.0 - up * up) : 1.0;
        if (up > 0.0) cover_add(c, wide * (p[1] - centre[0]), wide * (p[2] - centre[1]));
    }
}


/* raises radii (n), in directions `turn` (n x 2), to the hull of the section and of the contour that they describe */
static void cover_raise(cover *c, int32_t n, const double *turn, double *radius)
{
    for (int32_t j = 0; j < n; j++) cover_add(c, radius[j] * turn[2 * j], radius[j] * turn[2 * j + 1]);
    const int32_t sides = mus__polygon_hull(c->count, c->point, c->hull, c->scratch);
    for (int32_t j = 0; j < n; j++)
        for (int32_t i = 0; i < sides; i++) {
            const double *p = c->point + 2 * (ptrdiff_t)c->hull[i],
                         *q = c->point + 2 * (ptrdiff_t)c->hull[(i + 1) % sides];
            const double *u = turn + 2 * (ptrdiff_t)j;
            if (p[0] * u[1] - p[1] * u[0] < 0.0 || u[0] * q[1] - u[1] * q[0] <= 0.0) continue;
            const double across = u[0] * (q[1] - p[1]) - u[1] * (q[0] - p[0]);
            if (across > 0.0) radius[j] = fmax(radius[j], (p[0] * q[1] - p[1] * q[0]) / across);
        }
}


/* digits from the body's coordinates into those of the limb; returns the largest s */
static double cover_place(const mus__limb *limb, double s0, cover *c)
{
    double most = 0.0;
    for (int32_t i = 0; i < MUS__DIGITS_VERTICES; i++) {
        double *p = c->digit + 3 * (ptrdiff_t)i, local[3] = {-s0, 0.0, 0.0};
        for (int32_t d = 0; d < 3; d++) {
            const double r = p[d] - limb->origin[d];
            local[0] += r * limb->axis[d], local[1] += r * limb->side[d], local[2] += r * limb->front[d];
        }
        memcpy(p, local, sizeof local);
        most = fmax(most, local[0]);
    }
    return most;
}


/* beside a raised radius (`from`: before) the next ring's is at least that less their distance */
static void cover_slopes(const double *from, mus__field *field)
{
    const int64_t n = field->nangle, all = field->nring * n;
    double *radius = field->radius;
    for (int64_t j = n; j < all; j++)
        if (radius[j - n] > from[j - n]) radius[j] = fmax(radius[j], radius[j - n] - field->ds);
    for (int64_t j = all - n - 1; j >= 0; j--)
        if (radius[j + n] > from[j + n]) radius[j] = fmax(radius[j], radius[j + n] - field->ds);
}


/* free ends of a hand: its own axis from the first ring to the pole, and each finger from root to tip */
static void cover_ends(const cover *c, double pole, const double *centre, int32_t nring, mus__offset_part *to)
{
    const double *low = centre, *high = centre + 2 * (ptrdiff_t)(nring - 1);
    const double own[6] = {0.0, low[0], low[1], pole, high[0], high[1]};
    memcpy(to->end_axis[0], own, sizeof own);
    for (int32_t d = 0; d < MUS__DIGITS; d++) {
        const double *root = c->digit + 3 * (ptrdiff_t)d * MUS__DIGIT_VERTICES;
        memcpy(to->end_axis[1 + d], root, 3 * sizeof *root);
        memcpy(to->end_axis[1 + d] + 3, root + 3 * (ptrdiff_t)(MUS__DIGIT_VERTICES - 1), 3 * sizeof *root);
    }
    to->ends = 1 + MUS__DIGITS;
}


/* the field widened over its digits, which *c has in the coordinates of the limb up to s = `most` */
static void cover_field(cover *c, double most, const double *turn, double *radius, mus__field *field)
{
    const double *from = field->radius, last = field->ds * (field->nring - 1);
    const double pole = fmax(field->pole[1] - field->s0, last + fmax(most - last, 0.0) / COVER_CAP);
    memcpy(radius, from, (size_t)field->nring * (size_t)field->nangle * sizeof *radius);
    field->radius = radius;
    field->pole[1] = pole + field->s0;
    for (int32_t k = 0; k < field->nring; k++) {
        const double *centre = field->centre + 2 * (ptrdiff_t)k;
        c->count = 0;
        for (int32_t d = 0; d < MUS__DIGITS; d++) cover_digit(c, d * MUS__DIGIT_VERTICES, k * field->ds, centre);
        if (k == field->nring - 1) cover_cap(c, last, pole, centre);
        if (c->count > 0) cover_raise(c, field->nangle, turn, radius + (ptrdiff_t)k * field->nangle);
    }
    cover_slopes(from, field);
    for (int32_t k = 0; k < field->nring; k++) {
        const double *centre = field->centre + 2 * (ptrdiff_t)k,
                     aside = sqrt(centre[0] * centre[0] + centre[1] * centre[1]);
        for (int32_t j = 0; j < field->nangle; j++)
            field->reach = fmax(field->reach, radius[(ptrdiff_t)k * field->nangle + j] + aside);
    }
}


mus_status mus__digit_cover(const mus_body *body, int32_t part, double *radius, mus__field *field, mus__offset_part *to)
{
    const int32_t l = body->rig.part[part].limb;
    to->foot = body->measured && l >= MUS__LIMB_FOOT_LEFT && l <= MUS__LIMB_FOOT_RIGHT;
    if (body->digit_vertices == 0 || l < MUS__LIMB_ARM_LEFT) return MUS_OK;
    cover *c = mus__new(body->context, 1, sizeof *c);
    double *turn = mus__new(body->context, 2 * (int64_t)field->nangle, sizeof *turn);
    if (c != NULL && turn != NULL && body->digits_of != NULL && body->digits_of(body, part, c->digit)) {
        for (int32_t j = 0; j < field->nangle; j++) {
            const double length = mus__diamond_point(j, field->nangle, &turn[2 * j], &turn[2 * j + 1]);
            turn[2 * j] /= length, turn[2 * j + 1] /= length;
        }
        cover_field(c, cover_place(&body->limb[l], field->s0, c), turn, radius, field);
        if (!to->foot) cover_ends(c, field->pole[1] - field->s0, field->centre, field->nring, to);
        to->digits = true;
    }
    const mus_status status = c != NULL && turn != NULL ? MUS_OK : MUS_ERR_MEMORY;
    mus__free(body->context, c);
    mus__free(body->context, turn);
    return status == MUS_OK ? MUS_OK : mus__fail_memory(body->context, "mittens of a collider");
}
