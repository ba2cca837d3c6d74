/*
 * skin_fillet.c: the published skin: where two limbs meet, the vertices of both move onto a smooth union (a fillet).
 *
 * A vertex x0 with normal n0 represents its own limb by its tangent plane; the depth in the other limbs is that of
 * their radius fields. With depths d, positive inside, the smooth union of two is
 *
 *     D = max(d1, d2) + k/4 (1 - |d1 - d2|/k)^2   where |d1 - d2| < k,  else max(d1, d2)
 *     k = reach * sqrt(sin^2(angle between the normals) - 2 |d1 - d2|/(1.8 reach))
 *
 * It adds material in creases only. Two parallel surfaces have k = 0, and so have two that face each other (thighs side
 * by side), which would otherwise grow together. Where one surface leaves the other along a curve of radius r (a cap
 * within its limb, the seat over a thigh) sin^2 = 2 |d1 - d2|/r, so that curves with r > 1.8 reach have k = 0 too: they
 * are no crease.
 *
 * A vertex moves to D = 0 along the gradient by Newton's method. Vertices of both limbs do so up to a margin beyond the
 * crease, so that the two sheets lie on each other there and no gap opens between their triangles; deeper vertices keep
 * their place. Normals are those of the union, equal on both sheets, so that no seam is visible.
 *
 * Rings far from all other limbs are skipped, by boxes of rings against boxes of parts.
 *
 * Source: the union is the quadratic polynomial of Quilez, Smooth Minimum, 2013; the width that depends on the angle of
 * the gradients follows Gourmel and others, A Gradient-Based Implicit Blend, 2013.
 */
#include <math.h>
#include <string.h>

#include "body/body_make.h"
#include "geom/vec.h"

/* margin beyond the crease up to which both sheets lie on the union, in parts of the reach (5 mm of 25): half the
 * default distance of rings */
#define SKIN_MARGIN 0.2

/* radius from which on a curve between two surfaces is no crease, in reaches (45 mm for 25): about the radius of an
 * arm, whose cap lies within the next part of the limb */
#define SKIN_ROUND 1.8

/* distance up to which the normals of two surfaces are blended, in parts of the reach (4 mm of 25); chosen */
#define SKIN_EVEN 0.16

/* reach of the fillet between torso and leg, in parts of the others', in the rest pose; it grows to 1 until the entries
 * of the rotations of pelvis and thigh differ by SKIN_FOLD. Chosen: legs leave the torso along its surface */
#define SKIN_LEG 0.4
#define SKIN_FOLD 0.4

/* most displacement of a vertex, in parts of the reach (12 mm of 25): deep in a narrow wedge the union is far away */
#define SKIN_MOST 0.5

#define SKIN_SETTLE 3    /* rounds that bring a vertex of a posed scan to its parts */
#define SKIN_LOOSE 0.001 /* [m] depth up to which it may stay outside them */

/* the girth of the thigh is taken so far below the crotch, in parts of the crotch's height (arms_legs.c) */
#define SKIN_THIGH 0.02

/* two surfaces face each other when the cosine of their normals is below this; chosen */
#define SKIN_FACING (-0.5)

/* a joint is bent when an entry of the rotations of its two parts differs by more; chosen: about one degree */
#define SKIN_BENT 0.02

/* most Newton steps: the third one moves less than 0.01 mm; it ends where the depth is below SKIN_NEAR [m] */
#define SKIN_STEPS 3
#define SKIN_NEAR 1e-5

/* the surfaces that a vertex of a limb may be blended with */
typedef struct skin_union {
    const mus_body *body;
    int32_t limb;                   /* the limb of the vertex */
    double reach;                   /* width of a fillet along both surfaces of a right-angled crease [m] */
    double groin[2];                /* reach between torso and leg, left and right, in parts of `reach` */
    double most;                    /* most displacement of a vertex of the ring [m] */
    double low[MUS__PARTS_MOST][3]; /* boxes of the parts, grown by the reach [m] */
    double high[MUS__PARTS_MOST][3];
    int32_t count;                  /* number of parts near the ring */
    int32_t part[MUS__PARTS_MOST];  /* and their indices */
} skin_union;


/* blend depth d with normal n into (depth, gradient); the gradient is outward and not of unit length */
static void skin_merge(double reach, double d, const double *n, double *depth, double *gradient)
{
    double length = mus__norm3(gradient), cosine = mus__dot3(gradient, n) / (length > 0.0 ? length : 1.0);
    double before = *depth, apart = fabs(before - d);
    double square = 1.0 - cosine * cosine - 2.0 * apart / (SKIN_ROUND * reach);
    double k = square > 0.0 ? reach * sqrt(square) : 0.0;

    double h = apart < k ? 1.0 - apart / k : 0.0;
    *depth = fmax(*depth, d) + 0.25 * k * h * h;

    /* weight of the shallower one: h/2; without a fillet the gradient is blended over the width SKIN_EVEN */
    double even = SKIN_EVEN * reach, soft = apart < even ? 1.0 - apart / even : 0.0, low = 0.5 * fmax(h, soft * soft);
    double fresh = d > before ? 1.0 - low : low;
    for (int i = 0; i < 3; i++) gradient[i] += fresh * (n[i] - gradient[i]);
}


/* depth [m] and normal of point p in a field, for fillets. Beside a flat cap (the bottom of the torso is ten times as
 * broad as it is high) the first-order distance is much too short, so it is at least the distance to the end contour in
 * its plane */
static double skin_field(const mus__field *field, const double *p, double *normal)
{
    double depth = mus__field_depth(field, p, normal), d[3];
    if (!(depth > -1e29) || depth > 0.0) return depth;
    for (int i = 0; i < 3; i++) d[i] = p[i] - field->origin[i];
    double s = mus__dot3(d, field->axis) - field->s0, length = field->ds * (field->nring - 1);
    if (s >= 0.0 && s <= length) return depth;

    /* radius of the end contour towards p, by the diamond angle of radius_field.h */
    int32_t ring = s < 0.0 ? 0 : field->nring - 1, n = field->nangle;
    double a = mus__dot3(d, field->side) - field->centre[2 * ring];
    double b = mus__dot3(d, field->front) - field->centre[2 * ring + 1];
    double share = fabs(b) / (fabs(a) + fabs(b) + 1e-15);
    double turn = b >= 0.0 ? (a >= 0.0 ? share : 2.0 - share) : (a < 0.0 ? 2.0 + share : 4.0 - share);
    int32_t k = (int32_t)(0.25 * turn * n) % n;
    double off = sqrt(a * a + b * b) - field->radius[(ptrdiff_t)ring * n + k];
    return fmin(depth, -off);
}


/* reach of the fillet with limb `other` [m] */
static double skin_reach(const skin_union *at, int32_t other)
{
    const bool groin = at->body->measured && (at->limb == MUS__LIMB_TORSO || other == MUS__LIMB_TORSO) &&
                       at->limb + other >= MUS__LIMB_LEG_LEFT && at->limb + other <= MUS__LIMB_LEG_RIGHT;
    return groin ? at->groin[at->limb + other - MUS__LIMB_LEG_LEFT] * at->reach : at->reach;
}


/* depth [m] and outward gradient of the union at point p, for the vertex with the tangent plane (x0, n0). *other:
 * largest depth in the other parts; 1e30 between two surfaces that face each other */
static double skin_depth(const skin_union *at, const double *p, const double *x0, const double *n0,
                         double *gradient, double *other)
{
    double depth = 0.0, normal[3], last[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 3; i++) {
        depth -= n0[i] * (p[i] - x0[i]);
        gradient[i] = n0[i];
    }
    *other = -1e30;
    for (int32_t k = 0; k < at->count; k++) {
        const int32_t q = at->part[k];
        const double *low = at->low[q], *high = at->high[q];
        if (p[0] < low[0] || p[0] > high[0] || p[1] < low[1] || p[1] > high[1] || p[2] < low[2] || p[2] > high[2])
            continue;
        double d = skin_field(&at->body->field[q], p, normal);
        if (d < -at->reach) continue;
        if (mus__dot3(last, normal) < SKIN_FACING) {
            *other = 1e30;
            return 0.0;
        }
        if (d > *other) *other = d;
        memcpy(last, normal, sizeof last);
        skin_merge(skin_reach(at, at->body->rig.part[q].limb), d, normal, &depth, gradient);
    }
    return depth;
}


/* move a vertex onto the union and set its normal; false: it is not near another part and keeps its place */
static bool skin_move(const skin_union *at, double *x, double *normal)
{
    const double margin = SKIN_MARGIN * at->reach;
    double p[3], gradient[3], other, here;
    memcpy(p, x, sizeof p);
    double depth = skin_depth(at, p, x, normal, gradient, &other);
    if (other <= -at->reach || other >= 3.0 * margin) return false;

    /* the share of the displacement falls to 0 from one to three margins beyond the crease */
    double u = fmin(fmax(0.5 * (other - margin) / margin, 0.0), 1.0), share = 1.0 - u * u * (3.0 - 2.0 * u);
    for (int step = 0; step < SKIN_STEPS && (step == 0 || fabs(depth) > SKIN_NEAR); step++) {
        double square = mus__dot3(gradient, gradient);
        if (square < 0.05) return false;
        for (int i = 0; i < 3; i++) p[i] += depth / square * gradient[i];
        depth = skin_depth(at, p, x, normal, gradient, &here);
        if (here > 1e29) return false;
    }
    mus__unit3(gradient);
    const double way[3] = {p[0] - x[0], p[1] - x[1], p[2] - x[2]};
    const double far = mus__norm3(way), part = far > at->most ? share * at->most / far : share;
    for (int i = 0; i < 3; i++) {
        x[i] += part * way[i];
        normal[i] += share * (gradient[i] - normal[i]);
    }
    mus__unit3(normal);
    return true;
}


/* box of n points */
static void skin_box(const double *x, int32_t n, double *low, double *high)
{
    for (int i = 0; i < 3; i++) low[i] = 1e30, high[i] = -1e30;
    for (int32_t k = 0; k < n; k++, x += 3)
        for (int i = 0; i < 3; i++) {
            if (x[i] < low[i]) low[i] = x[i];
            if (x[i] > high[i]) high[i] = x[i];
        }
}


/* box of the poles of a field and of discs as wide as its rings, grown by `more` [m] */
static void skin_field_box(const mus__field *field, double more, double *low, double *high)
{
    for (int i = 0; i < 3; i++) low[i] = 1e30, high[i] = -1e30;
    for (int32_t j = -1; j <= field->nring; j++) {
        const bool pole = j < 0 || j == field->nring;
        const int32_t ring = j < 0 ? 0 : pole ? field->nring - 1 : j;
        const double *c = field->centre + 2 * (ptrdiff_t)ring;
        const double s = pole ? field->pole[j < 0 ? 0 : 1] : field->s0 + ring * field->ds;
        const double r = pole ? 0.0 : field->largest[ring];
        for (int i = 0; i < 3; i++) {
            const double x = field->origin[i] + c[0] * field->side[i] + c[1] * field->front[i] + s * field->axis[i];
            const double wide = more + r * sqrt(fmax(1.0 - field->axis[i] * field->axis[i], 0.0));
            low[i] = fmin(low[i], x - wide), high[i] = fmax(high[i], x + wide);
        }
    }
}


/* largest difference of the entries of the rotations of parts p and q of a posed body */
static double skin_turned(const mus_body *body, int32_t p, int32_t q)
{
    double most = 0.0;
    for (int i = 0; i < 9; i++) most = fmax(most, fabs(body->frame[p].turn[i] - body->frame[q].turn[i]));
    return most;
}


/* whether the joint between parts p and q of a posed body is bent */
static bool skin_bent(const mus_body *body, int32_t p, int32_t q)
{
    return skin_turned(body, p, q) > SKIN_BENT;
}


/* reaches between torso and legs; the first part of the torso is the pelvis, the last part of a leg the thigh */
static void skin_groins(skin_union *at)
{
    const mus_body *body = at->body;
    for (int32_t r = 0; r < 2; r++) {
        int32_t thigh = MUS_NONE;
        for (int32_t p = 0; p < body->nfield; p++)
            if (body->rig.part[p].limb == MUS__LIMB_LEG_LEFT + r) thigh = p;
        const bool posed = body->measured && body->frame != NULL && thigh != MUS_NONE;
        const double fold = posed ? fmin(skin_turned(body, 0, thigh) / SKIN_FOLD, 1.0) : 0.0;
        at->groin[r] = SKIN_LEG + (1.0 - SKIN_LEG) * fold;
    }
}


/* whether a ring at s is blended with part q of its own limb: never in the rest pose; in a pose with the part beyond a
 * bent joint, and near that joint with both its parts, since the rings there stand between them */
static bool skin_own(const mus_body *body, int32_t q, double s)
{
    if (body->frame == NULL) return false;
    const mus__part *part = body->rig.part;
    int32_t own = q;
    while (own > 0 && part[own - 1].limb == part[q].limb && s < part[own].end[0]) own--;
    while (own + 1 < body->rig.parts && part[own + 1].limb == part[q].limb && s >= part[own + 1].end[0]) own++;
    if (own != q) return skin_bent(body, own, q);
    for (int32_t low = q > 0 ? q - 1 : 0; low <= q && low + 1 < body->rig.parts; low++) {
        if (part[low].limb != part[q].limb || part[low + 1].limb != part[q].limb) continue;
        bool within = s > part[low].end[1] - part[low + 1].round[0] && s < part[low].end[1] + part[low].round[1];
        if (within && skin_bent(body, low, low + 1)) return true;
    }
    return false;
}


/* most displacement of the vertices of a ring at s [m]; in the rest pose it falls to 0 towards the contour of the
 * thigh, so that the thigh keeps its girth */
static double skin_most(const skin_union *at, double s)
{
    const mus__skeleton *bone = &at->body->skeleton;
    const double most = SKIN_MOST * at->reach;
    if (!at->body->measured || at->body->frame != NULL || s <= bone->knee) return most;
    if (at->limb != MUS__LIMB_LEG_LEFT && at->limb != MUS__LIMB_LEG_RIGHT) return most;
    return fmin(fmax(0.9 * (s - bone->crotch * (1.0 - SKIN_THIGH)), 0.0), most);
}


/* find the parts whose boxes overlap that of a ring at s */
static void skin_parts(skin_union *at, double s, const double *low, const double *high)
{
    at->most = skin_most(at, s);
    at->count = 0;
    for (int32_t q = 0; q < at->body->nfield; q++) {
        bool apart = at->body->rig.part[q].limb == at->limb && !skin_own(at->body, q, s);
        for (int i = 0; i < 3; i++) apart |= low[i] > at->high[q][i] || high[i] < at->low[q][i];
        if (!apart) at->part[at->count++] = q;
    }
}


/* move all vertices of limb l, its end points as rings of one vertex; with `half` the left half of each ring alone */
static void skin_limb(skin_union *at, mus_body *body, int32_t l, bool half)
{
    const mus__limb *limb = &body->limb[l];
    int32_t n = body->def.samples;
    at->limb = l;
    if (limb->gone) return;
    for (int32_t ring = -1; ring <= limb->rings; ring++) {
        bool end = ring < 0 || ring == limb->rings;
        int32_t count = end ? 1 : n;
        ptrdiff_t first = 3 * (limb->first_vertex + (ring < 0 ? 0 : 1 + (ptrdiff_t)ring * n));
        double low[3], high[3];
        skin_box(body->skin + first, count, low, high);
        skin_parts(at, end ? limb->pole[ring < 0 ? 0 : 1] : body->ring[limb->first_ring + ring], low, high);
        if (at->count == 0) continue;
        for (int32_t k = 0; k < count; k++, first += 3)
            if (!half || k <= n / 4 || k >= n - n / 4)
                skin_move(at, body->skin + first, body->skin_normals + first);
    }
}


/* whether the body is symmetric: a body of a tape with all limbs, in the rest pose. Sample k on the left, X > 0,
 * mirrors sample n/2 - k on the right */
static bool skin_is_even(const mus_body *body)
{
    return body->measured && body->frame == NULL && body->def.without == 0 && body->limb_count == MUS__LIMB_COUNT;
}


/* mirror a ring of n vertices */
static void skin_mirror_row(const double *from, int32_t n, double *to)
{
    for (int32_t k = 0; k < n; k++) {
        const double *p = from + 3 * (ptrdiff_t)k;
        double *q = to + 3 * (ptrdiff_t)((n + n / 2 - k) % n);
        q[0] = -p[0], q[1] = p[1], q[2] = p[2];
    }
}


/* set the right side of a symmetric body from the left one; x: vertices or normals */
static void skin_mirror(mus_body *body, double *x)
{
    const int32_t n = body->def.samples;
    static const int32_t left[] = {MUS__LIMB_ARM_LEFT, MUS__LIMB_LEG_LEFT, MUS__LIMB_FOOT_LEFT};
    for (int i = 0; i < 3; i++) {
        const mus__limb *p = &body->limb[left[i]], *q = p + 1;
        const double *from = x + 3 * (ptrdiff_t)p->first_vertex;
        double *to = x + 3 * (ptrdiff_t)q->first_vertex;
        skin_mirror_row(from, 1, to);
        for (int32_t ring = 0; ring < p->rings; ring++)
            skin_mirror_row(from + 3 * (1 + (ptrdiff_t)ring * n), n, to + 3 * (1 + (ptrdiff_t)ring * n));
        skin_mirror_row(from + 3 * ((ptrdiff_t)p->vertices - 1), 1, to + 3 * ((ptrdiff_t)p->vertices - 1));
    }
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    for (int32_t ring = 0; ring < torso->rings; ring++) {
        double *row = x + 3 * ((ptrdiff_t)torso->first_vertex + 1 + (ptrdiff_t)ring * n);
        for (int32_t k = 1 - n / 4; k < n / 4; k++) {
            const double *p = row + 3 * (ptrdiff_t)((n + k) % n);
            double *q = row + 3 * (ptrdiff_t)(n / 2 - k);
            q[0] = -p[0], q[1] = p[1], q[2] = p[2];
        }
    }
}


/* whether the ring at s of limb l stands between two parts */
static bool skin_blended(const mus_body *body, int32_t l, double s)
{
    for (int32_t p = 0; p + 1 < body->rig.parts; p++) {
        const mus__part *below = &body->rig.part[p], *above = below + 1;
        if (below->limb != l || above->limb != l) continue;
        if (s > below->end[1] - above->round[0] && s < below->end[1] + below->round[1]) return true;
    }
    return false;
}


/* move a point x outside all parts onto the nearest part */
static void skin_settle(const mus_body *body, double *x)
{
    for (int round = 0; round < SKIN_SETTLE; round++) {
        double best = -1e30, at[3] = {0.0, 0.0, 0.0}, normal[3];
        for (int32_t q = 0; q < body->nfield; q++) {
            const double d = mus__field_depth(&body->field[q], x, normal);
            if (d > best) best = d, memcpy(at, normal, sizeof at);
        }
        if (best > -SKIN_LOOSE || best < -1e29) return;
        for (int i = 0; i < 3; i++) x[i] += best * at[i];
    }
}


/* a posed scan: the rings of arms and legs between two parts bulge by centimetres at a bent joint, while contact knows
 * the parts; their vertices are moved onto the parts */
static void skin_scanned(mus_body *body)
{
    for (int32_t l = 0; l < body->limb_count; l++) {
        const mus__limb *limb = &body->limb[l];
        if (l == body->bones.limb[MUS__LIMB_TORSO]) continue;
        for (int32_t ring = 0; ring < limb->rings; ring++) {
            if (!skin_blended(body, l, body->ring[limb->first_ring + ring])) continue;
            double *row = body->skin + 3 * (limb->first_vertex + 1 + (ptrdiff_t)ring * body->def.samples);
            for (int32_t k = 0; k < body->def.samples; k++) skin_settle(body, row + 3 * (ptrdiff_t)k);
        }
        mus__ring_normals(body->skin + 3 * (ptrdiff_t)limb->first_vertex, body->def.samples, limb->rings, 0,
                             body->skin_normals + 3 * (ptrdiff_t)limb->first_vertex);
    }
}


mus_status mus__body_skin(mus_body *body)
{
    if (body->def.plain) return MUS_OK;
    size_t bytes = 3 * (size_t)body->vertex_count * sizeof(double);
    int64_t room = (int64_t)body->vertex_count + body->digit_vertices;
    body->skin = mus__room(body->context, 3 * room, sizeof(double));
    body->skin_normals = mus__room(body->context, 3 * room, sizeof(double));
    if (body->skin == NULL || body->skin_normals == NULL) return mus__fail_memory(body->context, "the skin of a body");
    memcpy(body->skin, body->vertices, bytes);
    memcpy(body->skin_normals, body->normals, bytes);
    if (body->measured) mus__skin_shape(body);
    if (body->digit_vertices > 0) mus__digit_make(body);
    if (body->scanned && body->frame != NULL) skin_scanned(body);
    if (body->fillet == 0.0) return MUS_OK;

    skin_union at = {.body = body, .reach = body->fillet};
    for (int32_t q = 0; q < body->nfield; q++) skin_field_box(&body->field[q], at.reach, at.low[q], at.high[q]);
    skin_groins(&at);
    const bool even = skin_is_even(body);
    for (int32_t l = 0; l < body->limb_count; l += even && l > 0 ? 2 : 1) skin_limb(&at, body, l, even && l == 0);
    if (even) {
        skin_mirror(body, body->skin);
        skin_mirror(body, body->skin_normals);
    }
    if (body->measured) mus__skin_seat(body);
    return MUS_OK;
}
