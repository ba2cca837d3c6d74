/*
 * skin_fillet.c: where two limbs meet, the radius fields of both carry a smooth union (a fillet).
 *
 * With depths d1 and d2 of a point in two limbs, positive inside, the smooth union is
 *
 *     D = max(d1, d2) + k/4 (1 - |d1 - d2|/k)^2   where |d1 - d2| < k,  else max(d1, d2)
 *     k = reach * sqrt(sin^2(angle between the normals) - 2 |d1 - d2|/(1.8 reach))
 *
 * It adds material in creases only. Two parallel surfaces have k = 0, and so have two that face each other. Where one
 * surface leaves the other along a curve of radius r (a cap within its limb, the seat over a thigh) sin^2 = 2 |d1 -
 * d2|/r, so that curves with r > 1.8 reach have k = 0 too: they are no crease.
 *
 * An entry of a field is the radius at which the ray from the contour's centre leaves D > 0. A ray that runs into the
 * other limb ends where d2 - d1 = 0.3 k, a little beyond the middle of the fillet: from there on the field of the other
 * limb carries it, whose rays meet it less steeply. So the union of all fields has the whole fillet, and contact, which
 * asks each field alone, needs to know nothing of it. The depth in the entry's own limb is that of the tangent plane at
 * the entry, which is what its field tells along the ray.
 *
 * Rings far from all other limbs are skipped, by boxes of rings against boxes of parts. A posed body carries the fields
 * of the rest pose, with their fillets.
 *
 * Source: the union is the quadratic polynomial of Quilez, Smooth Minimum, 2013; the width that depends on the angle of
 * the gradients follows Gourmel and others, A Gradient-Based Implicit Blend, 2013.
 */
#include <math.h>
#include <string.h>

#include "body/body_make.h"
#include "geom/vec.h"
#include "limb/radius_field_double.h"

/* radius from which on a curve between two surfaces is no crease, in reaches (45 mm for 25): about the radius of an
 * arm, whose cap lies within the next part of the limb */
#define FILLET_ROUND 1.8

/* a field carries the fillet up to d2 - d1 = this part of k; chosen: at the middle the two fields overlap by some mm */
#define FILLET_OVER 0.3

/* reach of the fillet between torso and leg, in parts of the others'. Chosen: legs leave the torso along its surface */
#define FILLET_LEG 0.4

/* distance up to which the normals of two surfaces are blended, in parts of the reach (8 mm of 25); chosen */
#define FILLET_EVEN 0.3

/* |d1 - d2| from which on k is smaller, in reaches: the root of x^2 + 2 x / FILLET_ROUND = 1 */
#define FILLET_OUT 0.588

/* largest Newton step, in reaches: a longer one could cross a narrow gap between the limbs */
#define FILLET_STRIDE 0.2

/* Newton steps at most, and the distance from the union at which they end [m] */
#define FILLET_STEPS 16
#define FILLET_NEAR 5e-5

/* a ray ends where the union falls along it by less than this: its surface is then steeper than 75 degrees, and the
 * field of the other limb carries it */
#define FILLET_SLOPE 0.26

/* an entry whose own surface falls along its ray by less than FILLET_STEEP does not grow, and one from FILLET_FLAT on
 * grows as far as the union. Chosen: the ridge of the shoulder, which falls by 15 to 30 degrees, keeps its length */
#define FILLET_STEEP 0.45
#define FILLET_FLAT 0.65

/* [m] an entry that grows by less is as it was: a hundredth of what a drawing shows */
#define FILLET_LEAST 1e-5

/* cosine of the angle up to which a normal is that of the limb alone: four degrees, which shading does not show */
#define FILLET_TURN 0.998

/* an entry further than this from all other limbs, in reaches, stands for the next ones too; chosen: more
 * than the length of four steps */
#define FILLET_FAR 3.0
#define FILLET_SKIP 2

/* most entries whose normals are kept: a body of a tape has some 10,000 */
#define FILLET_CREASES 40000

/* [m] each ring of a field with an entry that grows by more is drawn: below it, the distance of drawn rings cannot show
 * half a millimetre */
#define FILLET_FINE 3e-4

typedef struct fillet {
    mus_body *body;
    bool even;                      /* the body is symmetric: its left half is made alone */
    double reach;                   /* width of a fillet along both surfaces of a right-angled crease [m] */
    double low[MUS__PARTS_MOST][3]; /* boxes of the parts, grown by the reach [m] */
    double high[MUS__PARTS_MOST][3];
    mus__body_field query[MUS__PARTS_MOST];
    double *fresh[MUS__PARTS_MOST]; /* (nring x nangle) new radii of a part; NULL: none changed */
    bool *done[MUS__PARTS_MOST];    /* (nring) rings of it that are set */
    int32_t creases, room;
    mus__crease *crease;
    int32_t angles; /* steps of the tables that `turn` is of */
    double turn[2 * MUS__FIELD_MOST];
    double slack[MUS__FIELD_MOST]; /* how far [m] each entry is off where it could grow; see fillet_slack() */
    uint64_t parts;                /* the parts near the ring, a bit each */
    int32_t count;                 /* their number */
    int32_t part[MUS__PARTS_MOST]; /* and their indices, those of one limb one after the other */
} fillet;

/* a ray of an entry: where it leaves its own limb, its direction, the normal there, and their product; then, for the
 * limb that it may grow to, the depth there and its normal */
typedef struct fillet_ray {
    double start[3], way[3], normal[3], slope, depth, other[3];
} fillet_ray;


/* depth [m] and normal of point p in a field, for fillets. Beside a flat cap (the bottom of the torso is ten times as
 * broad as it is high) the first-order distance is much too short, so it is at least the distance to the end contour in
 * its plane */
static double fillet_field(const fillet *at, int32_t q, const double *p, double *normal)
{
    const mus__field *field = &at->body->field[q];
    int32_t near;
    double depth = mus__body_field_query(&at->query[q], p, at->reach, normal, &near), d[3];
    if (near == 0) return -1e30;
    if (depth > 0.0) return depth;
    for (int i = 0; i < 3; i++) d[i] = p[i] - field->origin[i];
    double s = mus__dot3(d, field->axis) - field->s0, length = field->ds * (field->nring - 1);
    if (s >= 0.0 && s <= length) return depth;

    int32_t entry, ring = s < 0.0 ? 0 : field->nring - 1;
    double share, a = mus__dot3(d, field->side) - field->centre[2 * ring];
    double b = mus__dot3(d, field->front) - field->centre[2 * ring + 1], turn[2] = {a, b};
    if (a == 0.0 && b == 0.0) return depth;
    mus__field_steps(field->nangle, 1, turn, &entry, &share);
    double off = sqrt(a * a + b * b) - field->radius[(ptrdiff_t)ring * field->nangle + entry];
    return fmin(depth, -off);
}


/* reach of the fillet between limbs l and m [m] */
static double fillet_reach(const fillet *at, int32_t l, int32_t m)
{
    const bool groin = at->body->measured && (l == MUS__LIMB_TORSO || m == MUS__LIMB_TORSO) &&
                       l + m >= MUS__LIMB_LEG_LEFT && l + m <= MUS__LIMB_LEG_RIGHT;
    return groin ? FILLET_LEG * at->reach : at->reach;
}


/* distance [m] of a point to a box along the axis on which it is farthest out; 0: within */
static double fillet_off_box(const double *low, const double *high, const double *p)
{
    double off = 0.0;
    for (int i = 0; i < 3; i++) {
        const double under = low[i] - p[i], over = p[i] - high[i];
        if (under > off) off = under;
        if (over > off) off = over;
    }
    return off;
}


/* largest depth [m] of point p in the listed parts from number `first` to `end`, and the normal there. *off: the least
 * distance to the boxes of the other parts [m], if p is in none of theirs */
static double fillet_depth(const fillet *at, int32_t first, int32_t end, const double *p, double *normal, double *off)
{
    double most = -1e30, n[3];
    *off = INFINITY;
    for (int32_t i = first; i < end; i++) {
        const int32_t q = at->part[i];
        const double beyond = fillet_off_box(at->low[q], at->high[q], p);
        if (beyond > 0.0) {
            if (beyond < *off) *off = beyond;
            continue;
        }
        const double d = fillet_field(at, q, p, n);
        if (d < -1e29) *off = 0.0;
        if (d > most) most = d, memcpy(normal, n, sizeof n);
    }
    return most;
}


/* how far [m] the ray of an entry goes on to the smooth union with the listed parts from `first` to `end`; normal (3)
 * of the union there */
static double fillet_grow(const fillet *at, double reach, int32_t first, int32_t end, const fillet_ray *ray,
                          double *normal)
{
    double t = 0.0, last = 0.0, short_of = 0.0, before = 1.0;
    for (int step = 0; step < FILLET_STEPS; step++) {
        double p[3], n[3] = {ray->other[0], ray->other[1], ray->other[2]}, off;
        for (int i = 0; i < 3; i++) p[i] = ray->start[i] + t * ray->way[i];
        const double own = -t * ray->slope, d = step == 0 ? ray->depth : fillet_depth(at, first, end, p, n, &off);
        if (d < -reach) return t;
        const double cosine = mus__dot3(ray->normal, n), apart = fabs(own - d);
        const double square = 1.0 - cosine * cosine - 2.0 * apart / (FILLET_ROUND * reach);
        const double k = square > 0.0 ? reach * sqrt(square) : 0.0, over = d - own - FILLET_OVER * k;
        const double h = apart < k ? 1.0 - apart / k : 0.0, depth = fmax(own, d) + 0.25 * k * h * h;
        const double even = fmax(1.0 - apart / (FILLET_EVEN * at->reach), 0.0), low = 0.5 * fmax(h, even * even);
        const double other = d > own ? 1.0 - 0.5 * h : 0.5 * h, seen = d > own ? 1.0 - low : low;
        const double slope = ray->slope + other * (mus__dot3(n, ray->way) - ray->slope);
        for (int i = 0; i < 3; i++) normal[i] = ray->normal[i] + seen * (n[i] - ray->normal[i]);
        if (step == 0 && square <= 0.0) return 0.0;
        if (over >= 0.0) return step == 0 ? 0.0 : last + (t - last) * short_of / (short_of + over);
        if (fabs(depth) < FILLET_NEAR) return t;
        if (slope < FILLET_SLOPE)
            return step == 0 ? 0.0 : last + (t - last) * (before - FILLET_SLOPE) / (before - slope);
        last = t, short_of = -over, before = slope;
        t = fmax(t + fmin(depth / slope, FILLET_STRIDE * reach), 0.0);
    }
    return t;
}


/* the growth of an entry of part q whose ray begins at ray->start: the largest of those to each near limb; normal (3)
 * of the union there, and the entry's own in ray->normal. *far: no limb is near. 0: none, and *turned is false. *slack:
 * the distance [m] to where it could grow */
static double fillet_entry(const fillet *at, int32_t q, fillet_ray *ray, double *normal, bool *far, bool *turned,
                           double *slack)
{
    const mus__part *part = at->body->rig.part;
    double most = -1.0, off;
    *far = true, *turned = false, *slack = INFINITY;
    for (int32_t first = 0, end = 0; first < at->count; first = end) {
        const int32_t other = part[at->part[first]].limb;
        while (end < at->count && part[at->part[end]].limb == other) end++;
        ray->depth = fillet_depth(at, first, end, ray->start, ray->other, &off);
        *far = *far && ray->depth < -FILLET_FAR * at->reach;
        const double reach = fillet_reach(at, part[q].limb, other), out = fabs(ray->depth);
        const double most_out = fmax(FILLET_OUT * reach, FILLET_EVEN * at->reach);
        *slack = fmin(*slack, fmax(fmin(out - most_out, off), 0.0));
        if (out > most_out) continue;
        if (most < 0.0) {
            int32_t near;
            mus__body_field_query(&at->query[q], ray->start, at->reach, ray->normal, &near);
            ray->slope = mus__dot3(ray->normal, ray->way);
            if (ray->slope < FILLET_STEEP) return 0.0;
        }
        double n[3] = {ray->normal[0], ray->normal[1], ray->normal[2]};
        const double grown = fillet_grow(at, reach, first, end, ray, n);
        if (grown >= most) most = grown, memcpy(normal, n, sizeof n), *turned = true;
    }
    return fmax(most, 0.0) * mus__cubic_step((ray->slope - FILLET_STEEP) / (FILLET_FLAT - FILLET_STEEP));
}


/* point (3) of a field at (a, b, s) */
static void fillet_point(const mus__field *field, double a, double b, double s, double *out)
{
    for (int i = 0; i < 3; i++)
        out[i] = field->origin[i] + a * field->side[i] + b * field->front[i] + s * field->axis[i];
}


/* keep the normal of the union at entry k of ring j of part q; without memory the drawing does without it */
static void fillet_keep(fillet *at, int32_t q, int32_t j, int32_t k, const double *normal)
{
    if (at->creases == at->room) return;
    mus__crease *crease = &at->crease[at->creases++];
    *crease = (mus__crease){q, j, k, {normal[0], normal[1], normal[2]}};
}


/* entry k of ring j of part q: its new radius into *out, and with `keep` its normal. Returns its growth [m],
 * FILLET_FINE at least where the normal turns, and -1 far from all other limbs */
static double fillet_at(fillet *at, int32_t q, int32_t j, int32_t k, bool keep, double *out)
{
    const mus__field *field = &at->body->field[q];
    const double *turn = at->turn, *c = field->centre + 2 * (ptrdiff_t)j;
    const double radius = field->radius[(ptrdiff_t)j * field->nangle + k];
    fillet_ray ray = {.slope = 0.0};
    double normal[3] = {0.0, 0.0, 0.0};
    bool far, turned;
    fillet_point(field, c[0] + radius * turn[2 * k], c[1] + radius * turn[2 * k + 1], field->s0 + j * field->ds,
                 ray.start);
    for (int i = 0; i < 3; i++) ray.way[i] = turn[2 * k] * field->side[i] + turn[2 * k + 1] * field->front[i];
    const double more = fillet_entry(at, q, &ray, normal, &far, &turned, &at->slack[k]);
    if (far) return -1.0;
    if (more > FILLET_LEAST) *out = radius + more;
    if (!turned) return more;
    mus__unit3(normal);
    if (mus__dot3(normal, ray.normal) > FILLET_TURN) return more;
    if (keep) fillet_keep(at, q, j, k, normal);
    return fmax(more, FILLET_FINE);
}


/* new radii `out` (nangle) of ring j of part q; with `half` of its left half alone. The odd entries are asked beside
 * even ones that changed. Returns the largest growth [m] */
static double fillet_ring(fillet *at, int32_t q, int32_t j, bool half, bool keep, double *out)
{
    const int32_t n = at->body->field[q].nangle;
    double grew = 0.0;
    bool changed[MUS__FIELD_MOST] = {false};
    for (int32_t odd = 0; odd < 2; odd++)
        for (int32_t k = odd; k < n; k += 2) {
            if (half && k > n / 4 && k < n - n / 4) continue;
            if (at->slack[k] > 0.0) continue;
            if (odd && !changed[k - 1] && !changed[(k + 1) % n]) continue;
            const double more = fillet_at(at, q, j, k, keep, &out[k]);
            changed[k] = more > FILLET_LEAST;
            grew = fmax(grew, more);
            if (more < 0.0 && !odd) k += FILLET_SKIP;
        }
    return grew;
}


/* ---- which rings ---- */

/* box of ring j of a field, a disc as wide as its largest radius */
static void fillet_ring_box(const mus__field *field, int32_t j, double s, double r, double *low, double *high)
{
    const double *c = field->centre + 2 * (ptrdiff_t)j;
    for (int i = 0; i < 3; i++) {
        const double x = field->origin[i] + c[0] * field->side[i] + c[1] * field->front[i] + s * field->axis[i];
        const double wide = r * sqrt(fmax(1.0 - field->axis[i] * field->axis[i], 0.0));
        low[i] = x - wide, high[i] = x + wide;
    }
}


/* box of the rings and poles of a field, grown by `more` [m] */
static void fillet_box(const mus__field *field, double more, double *low, double *high)
{
    for (int i = 0; i < 3; i++) low[i] = 1e30, high[i] = -1e30;
    for (int32_t j = -1; j <= field->nring; j++) {
        const bool pole = j < 0 || j == field->nring;
        const int32_t ring = j < 0 ? 0 : pole ? field->nring - 1 : j;
        double a[3], b[3];
        fillet_ring_box(field, ring, pole ? field->pole[j < 0 ? 0 : 1] : field->s0 + ring * field->ds,
                        pole ? 0.0 : field->largest[ring], a, b);
        for (int i = 0; i < 3; i++) low[i] = fmin(low[i], a[i] - more), high[i] = fmax(high[i], b[i] + more);
    }
}


/* whether two limbs meet in a fillet: thighs, and arms and legs, touch without one */
static bool fillet_joins(const mus_body *body, int32_t l, int32_t m)
{
    const int32_t foot = MUS__LIMB_FOOT_LEFT - MUS__LIMB_LEG_LEFT, low = l < m ? l : m, high = l < m ? m : l;
    if (!body->measured || high >= MUS__LIMB_COUNT || low == MUS__LIMB_TORSO) return l != m;
    return low >= MUS__LIMB_LEG_LEFT && high == low + foot;
}


/* list the parts whose boxes overlap that of ring j of part q */
static void fillet_parts(fillet *at, int32_t q, int32_t j)
{
    const mus_body *body = at->body;
    const mus__field *field = &body->field[q];
    double low[3], high[3];
    fillet_ring_box(field, j, field->s0 + j * field->ds, field->largest[j], low, high);
    at->count = 0, at->parts = 0;
    for (int32_t o = 0; o < body->nfield; o++) {
        bool apart = (at->even && mus__limb_is_right(body->rig.part[o].limb)) ||
                     !fillet_joins(body, body->rig.part[q].limb, body->rig.part[o].limb);
        for (int i = 0; i < 3; i++) apart |= low[i] > at->high[o][i] || high[i] < at->low[o][i];
        if (!apart) at->part[at->count++] = o, at->parts |= UINT64_C(1) << o;
    }
}


/* entries move from ring j - 1 to ring j of a field: what is left of their slacks. A depth is a distance to first order
 * alone, so a way counts twice. `fresh`: the slacks begin at 0 */
static void fillet_slack(fillet *at, const mus__field *field, int32_t j, bool fresh)
{
    const int32_t n = field->nangle;
    const double *r = field->radius + (ptrdiff_t)j * n, *c = field->centre + 2 * (ptrdiff_t)j;
    const double shift = fresh ? 0.0 : fabs(c[0] - c[-2]) + fabs(c[1] - c[-1]) + field->ds;
    for (int32_t k = 0; k < n; k++) {
        const double left = fresh ? 0.0 : at->slack[k] - 2.0 * (shift + fabs(r[k] - r[k - n]));
        at->slack[k] = left > 0.0 ? left : 0.0;
    }
}


/* take the directions of part q */
static void fillet_turn(fillet *at, int32_t q)
{
    const int32_t n = at->body->field[q].nangle;
    if (at->angles != n) mus__field_turns(n, at->turn);
    at->angles = n;
}


/* new radii of all rings of a part. Errors: MUS_ERR_MEMORY */
static mus_status fillet_part(fillet *at, int32_t q, bool half)
{
    mus__field *field = &at->body->field[q];
    const mus__part *part = &at->body->rig.part[q];
    const size_t row = (size_t)field->nangle;
    fillet_turn(at, q);
    at->parts = 0;
    for (int32_t j = 0; j < field->nring; j++) {
        const double s = field->s0 + j * field->ds;
        if (part->round[0] > 0.0 && s < part->end[0]) continue; /* a round cap lies within the next part */
        if (part->round[1] > 0.0 && s > part->end[1]) continue;
        const uint64_t parts = at->parts;
        fillet_parts(at, q, j);
        fillet_slack(at, field, j, j == 0 || parts != at->parts);
        if (at->count == 0) continue;
        if (at->fresh[q] == NULL) {
            at->fresh[q] = mus__room(at->body->context, (int64_t)field->nring * field->nangle, sizeof(double));
            at->done[q] = mus__new(at->body->context, field->nring, sizeof(bool));
            if (!at->fresh[q] || !at->done[q]) return mus__fail_memory(at->body->context, "the fillets of a body");
        }
        double *out = at->fresh[q] + (size_t)j * row;
        memcpy(out, field->radius + (size_t)j * row, row * sizeof *out);
        at->done[q][j] = true;
        if (fillet_ring(at, q, j, half, true, out) < FILLET_FINE) continue;
        if (j < field->fine[0]) field->fine[0] = j;
        if (j > field->fine[1]) field->fine[1] = j;
    }
    return MUS_OK;
}


/* ---- the body ---- */

/* the girth that fillets add to the contours of the tape is taken off them before: each ring about a contour gives way
 * (give.c). Scratch: xy (2 nangle), work (2 nangle) */
static void fillet_give(fillet *at, double *xy, int32_t *work)
{
    mus_body *body = at->body;
    double row[MUS__FIELD_MOST];
    for (int32_t q = 0; q < body->nfield; q++) {
        const mus__part *part = &body->rig.part[q];
        const mus__limb *limb = &body->limb[part->limb];
        const mus__field *field = &body->field[q];
        if (at->even && mus__limb_is_right(part->limb)) continue;
        const bool half = at->even && part->limb == MUS__LIMB_TORSO;
        for (int32_t i = 0; i < limb->count && part->limb < MUS__LIMB_COUNT; i++) {
            const double s = limb->contour[i].s;
            if (limb->contour[i].girth == MUS_NONE || s < part->end[0] || s >= part->end[1]) continue;
            const int32_t j = (int32_t)floor((s - field->s0) / field->ds + 0.5), n = field->nangle;
            fillet_turn(at, q);
            fillet_slack(at, field, j, true);
            const double *radius = field->radius + (ptrdiff_t)j * n;
            fillet_parts(at, q, j);
            if (at->count == 0) continue;
            memcpy(row, radius, (size_t)n * sizeof *row);
            if (fillet_ring(at, q, j, half, false, row) == 0.0) continue;
            for (int32_t k = n / 4 + 1; half && k < n - n / 4; k++) row[k] = row[(n + n / 2 - k) % n];
            const double before = mus__give_tape(n, at->turn, radius, xy, work);
            mus__give_scale(body, part->limb, i, before / mus__give_tape(n, at->turn, row, xy, work) - 1.0, at->turn);
        }
    }
}


/* the normals of the right half, from those of the left one */
static void fillet_mirror_creases(fillet *at)
{
    const int32_t count = at->creases;
    for (int32_t i = 0; i < count && at->creases < at->room; i++) {
        mus__crease *crease = &at->crease[at->creases];
        *crease = at->crease[i];
        const int32_t n = at->body->field[crease->part].nangle, to = (n + n / 2 - crease->entry) % n;
        if (crease->part == mus__mirror_part(at->body, crease->part) && to == crease->entry) continue;
        crease->part = mus__mirror_part(at->body, crease->part);
        crease->entry = to;
        crease->normal[0] = -crease->normal[0];
        at->creases++;
    }
}


/* boxes and queries of all fields */
static void fillet_begin(fillet *at)
{
    for (int32_t q = 0; q < at->body->nfield; q++) {
        const mus__field *field = &at->body->field[q];
        fillet_box(field, at->reach, at->low[q], at->high[q]);
        mus__field_prepare(field, &at->query[q]);
    }
}


mus_status mus__body_fillets(mus_body *body, double reach)
{
    if (reach == 0.0) return MUS_OK;
    fillet *at = mus__new(body->context, 1, sizeof *at);
    double xy[2 * MUS__FIELD_MOST];
    int32_t work[2 * MUS__FIELD_MOST];
    if (at == NULL) return mus__fail_memory(body->context, "the fillets of a body");
    at->body = body, at->reach = reach, at->room = FILLET_CREASES;
    fillet_begin(at);
    const bool even = at->even = mus__body_is_even(body);
    at->crease = mus__room(body->context, at->room, sizeof *at->crease);
    mus_status status = at->crease != NULL ? MUS_OK : mus__fail_memory(body->context, "the fillets of a body");
    if (status == MUS_OK && body->measured) fillet_give(at, xy, work);
    for (int32_t q = 0; q < body->nfield && status == MUS_OK; q++) {
        const int32_t l = body->rig.part[q].limb;
        if (!even || !mus__limb_is_right(l)) status = fillet_part(at, q, even && l == 0);
    }
    for (int32_t q = 0; q < body->nfield; q++) {
        mus__field *field = &body->field[q];
        const size_t row = (size_t)field->nangle;
        for (int32_t j = 0; j < field->nring && status == MUS_OK && at->fresh[q] != NULL; j++)
            if (at->done[q][j])
                memcpy(field->radius + (size_t)j * row, at->fresh[q] + (size_t)j * row, row * sizeof(double));
        mus__free(body->context, at->fresh[q]);
        mus__free(body->context, at->done[q]);
    }
    if (even && status == MUS_OK) fillet_mirror_creases(at);
    body->crease = at->crease, body->creases = at->creases;
    mus__free(body->context, at);
    return status;
}
