/*
 * skin.c: one skin over all limbs: where two limbs meet, the vertices of both move onto a smooth union.
 *
 * A vertex x0 with normal n0 stands for its own limb by its tangent plane; the other limbs are asked by their contact
 * fields. With depths d positive inside, the smooth union of two is
 *
 *     D = max(d1, d2) + k/4 (1 - |d1 - d2|/k)^2   where |d1 - d2| < k,  else max(d1, d2)
 *     k = reach * sqrt(sin^2(angle between the normals) - 2 |d1 - d2|/(1.8 reach))
 *
 * which adds material in a crease only. Two surfaces that run along each other have k = 0, and so have two that face
 * each other (thighs side by side), which would else grow together. Where one parts from the other in a curve (a cap
 * within its limb, the seat over a thigh) there is no crease: with radius r of the curve the angle is sin^2 = 2 |d1 -
 * d2|/r, so that curves of r > 1.8 reach have k = 0 as well. A
 * vertex moves to D = 0 along the gradient by Newton's rule. Vertices of both limbs do so up to `margin` beyond the
 * crease, so that the two sheets lie on each other there and no notch opens between their triangles; deeper ones go
 * back to where they were. Normals are those of the union: the two sheets have the same and no seam shows.
 *
 * Rings far from all other limbs are not touched: boxes of rings against boxes of limbs, then of vertices.
 * Source: the union is the quadratic polynomial of Quilez, Smooth Minimum, 2013; a width that follows the angle of the
 * gradients is from Gourmel and others, A Gradient-Based Implicit Blend, 2013.
 */
#include <math.h>
#include <string.h>

#include "body/body_make.h"
#include "geom/vec.h"

/* how deep both sheets lie on the union, in parts of a fillet: 5 mm of 25, about half a ring's distance */
#define SKIN_MARGIN 0.2

/* a surface that parts from another in a curve of more than so many reaches is no crease: 45 mm of 25, about the radius
 * of an arm, whose cap lies within the next part of the limb */
#define SKIN_ROUND 1.8

/* normals of two surfaces that lie within so much of a reach of each other are evened out, 4 mm of 25 */
#define SKIN_EVEN 0.16

/* fillet between torso and leg, in parts of the others; whole where the hip is bent so much that an entry of the
 * rotation is SKIN_FOLD */
#define SKIN_LEG 0.4
#define SKIN_FOLD 0.4

/* no vertex moves further than so much of a reach, 12 mm of 25: deep in a narrow wedge the union is far */
#define SKIN_MOST 0.5

#define SKIN_SETTLE 3    /* rounds in which a place comes to the skin */
#define SKIN_LOOSE 0.001  /* and how far off it may stay [m] */

/* the thigh is measured so far below the crotch, in parts of its height */
#define SKIN_THIGH 0.02

/* cosine of the normals of two surfaces that face each other */
#define SKIN_FACING (-0.5)

/* a joint is bent when an entry of the rotation between its parts is larger */
#define SKIN_BENT 0.02

/* Newton steps: the third moves less than 0.01 mm; what is nearer than this [m] is there */
#define SKIN_STEPS 3
#define SKIN_NEAR 1e-5

/* what a place of the surface may meet */
typedef struct skin_union {
    const mus_body *body;
    int32_t limb;                 /* the limb whose surface it is */
    double reach;                 /* width of a fillet along both surfaces of a right-angled crease [m] */
    double groin[2];              /* of the fillets between torso and legs, left and right, in parts of the reach */
    double most;                  /* no vertex of the ring moves further [m] */
    double low[MUS__PARTS_MOST][3]; /* boxes of the parts, grown by the reach */
    double high[MUS__PARTS_MOST][3];
    int32_t count;                /* parts that may be near */
    int32_t part[MUS__PARTS_MOST];
} skin_union;


/* merge depth d with normal n into (depth, gradient) so far; the gradient is outward and not of unit length */
static void skin_merge(double reach, double d, const double *n, double *depth, double *gradient)
{
    double length = mus__norm3(gradient), cosine = mus__dot3(gradient, n) / (length > 0.0 ? length : 1.0);
    double before = *depth, apart = fabs(before - d);
    double square = 1.0 - cosine * cosine - 2.0 * apart / (SKIN_ROUND * reach);
    double k = square > 0.0 ? reach * sqrt(square) : 0.0;

    double h = apart < k ? 1.0 - apart / k : 0.0;
    *depth = fmax(*depth, d) + 0.25 * k * h * h;

    /* weight of the shallower one: h/2; the gradient turns over a width of its own where there is no fillet */
    double even = SKIN_EVEN * reach, soft = apart < even ? 1.0 - apart / even : 0.0, low = 0.5 * fmax(h, soft * soft);
    double fresh = d > before ? 1.0 - low : low;
    for (int i = 0; i < 3; i++) gradient[i] += fresh * (n[i] - gradient[i]);
}


/* the depth of a field that a fillet goes by. Beside a flat cap (the bottom of the torso is ten times as broad as it is
 * high) the first-order distance is much too short; it is no less than the way to the end contour in its plane */
static double skin_field(const mus__field *field, const double *p, double *normal)
{
    double depth = mus__field_depth(field, p, normal), d[3];
    if (!(depth > -1e29) || depth > 0.0) return depth;
    for (int i = 0; i < 3; i++) d[i] = p[i] - field->origin[i];
    double s = mus__dot3(d, field->axis) - field->s0, length = field->ds * (field->nring - 1);
    if (s >= 0.0 && s <= length) return depth;

    /* radius of the end contour towards p, by the diamond angle of field.h */
    int32_t ring = s < 0.0 ? 0 : field->nring - 1, n = field->nangle;
    double a = mus__dot3(d, field->side) - field->centre[2 * ring];
    double b = mus__dot3(d, field->front) - field->centre[2 * ring + 1];
    double share = fabs(b) / (fabs(a) + fabs(b) + 1e-15);
    double turn = b >= 0.0 ? (a >= 0.0 ? share : 2.0 - share) : (a < 0.0 ? 2.0 + share : 4.0 - share);
    int32_t k = (int32_t)(0.25 * turn * n) % n;
    double off = sqrt(a * a + b * b) - field->radius[(ptrdiff_t)ring * n + k];
    return fmin(depth, -off);
}


/* reach of a fillet with another limb: legs grow out of the torso along its surface, and what crease there is needs
 * little */
static double skin_reach(const skin_union *at, int32_t other)
{
    const bool groin = at->body->measured && (at->limb == MUS__LIMB_TORSO || other == MUS__LIMB_TORSO) &&
                       at->limb + other >= MUS__LIMB_LEG_LEFT && at->limb + other <= MUS__LIMB_LEG_RIGHT;
    return groin ? at->groin[at->limb + other - MUS__LIMB_LEG_LEFT] * at->reach : at->reach;
}


/* depth and outward gradient of the union at p; own plane (x0, n0). *other: the largest depth in the other parts, 1e30
 * in the slot between two thighs, where there is no way out */
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


/* move a vertex onto the union and turn its normal; false: it is not near another part and stays */
static bool skin_move(const skin_union *at, double *x, double *normal)
{
    const double margin = SKIN_MARGIN * at->reach;
    double p[3], gradient[3], other, here;
    memcpy(p, x, sizeof p);
    double depth = skin_depth(at, p, x, normal, gradient, &other);
    if (other <= -at->reach || other >= 3.0 * margin) return false;

    /* onto the union; beyond the margin less and less of the way */
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


/* box of a field, grown by `more`: of discs as wide as its rings, and its poles */
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


/* how far a part of a posed body is turned against another: the largest difference of their rotations' entries */
static double skin_turned(const mus_body *body, int32_t p, int32_t q)
{
    double most = 0.0;
    for (int i = 0; i < 9; i++) most = fmax(most, fabs(body->frame[p].turn[i] - body->frame[q].turn[i]));
    return most;
}


/* true when a joint of a posed body is bent */
static bool skin_bent(const mus_body *body, int32_t p, int32_t q)
{
    return skin_turned(body, p, q) > SKIN_BENT;
}


/* fillets of the groins: the torso's first part is the pelvis, a leg's last one the thigh */
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


/* whether a ring at s of its own limb may meet part q of that limb: not in the rest pose; in a pose parts beyond a bent
 * joint, and near one both its parts, since there the rings stand between them */
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


/* how far vertices of a ring at s may move: in the rest pose not past the contour of the thigh, which keeps its
 * girth */
static double skin_most(const skin_union *at, double s)
{
    const mus__skeleton *bone = &at->body->skeleton;
    const double most = SKIN_MOST * at->reach;
    if (!at->body->measured || at->body->frame != NULL || s <= bone->knee) return most;
    if (at->limb != MUS__LIMB_LEG_LEFT && at->limb != MUS__LIMB_LEG_RIGHT) return most;
    return fmin(fmax(0.9 * (s - bone->crotch * (1.0 - SKIN_THIGH)), 0.0), most);
}


/* the parts that the box of a ring touches */
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


/* all vertices of a limb: its two end points as rings of one; of the torso the left half alone where that is enough */
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


/* a body of a tape with all its limbs, as made, is the same on both sides: sample k on the left, X > 0, is n/2 - k on
 * the right */
static bool skin_is_even(const mus_body *body)
{
    return body->measured && body->frame == NULL && body->def.without == 0 && body->limb_count == MUS__LIMB_COUNT;
}


static void skin_mirror_row(const double *from, int32_t n, double *to)
{
    for (int32_t k = 0; k < n; k++) {
        const double *p = from + 3 * (ptrdiff_t)k;
        double *q = to + 3 * (ptrdiff_t)((n + n / 2 - k) % n);
        q[0] = -p[0], q[1] = p[1], q[2] = p[2];
    }
}


/* the right side after the left one */
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


/* how far a part's blend of rings with its neighbours reaches to s */
static bool skin_blended(const mus_body *body, int32_t l, double s)
{
    for (int32_t p = 0; p + 1 < body->rig.parts; p++) {
        const mus__part *below = &body->rig.part[p], *above = below + 1;
        if (below->limb != l || above->limb != l) continue;
        if (s > below->end[1] - above->round[0] && s < below->end[1] + below->round[1]) return true;
    }
    return false;
}


/* a place outside all parts, brought to the nearest */
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


/* a posed scan: rings of arms and legs that stand between two parts bulge where a joint is bent, by centimetres, and
 * cloth is held by the parts */
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
