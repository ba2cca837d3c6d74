/*
 * arrange_check.c: finds and names a bad start before the run: panels inside the body, seams whose sides lie the wrong
 * way round, panels that begin turned round or in one another's place. arrange_check_layers.c finds the rest.
 *
 * For a panel in the wrong place: the rigid motion that brings its seam nodes nearest to their partners, while the
 * other panels stay. Its unit quaternion is the eigenvector to the largest eigenvalue of a symmetric 4 x 4 matrix,
 * found by powers of the matrix. Source: Horn, Closed-form solution of absolute orientation using unit quaternions, J.
 * Opt. Soc. Am. A 4 (1987).
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "arrange/failure_reason.h"
#include "geom/vec.h"

#define CHECK_INSIDE_DEEP 0.02 /* [m] depth of a node that is inside the body and does not merely touch it */
#define CHECK_INSIDE_PART 0.25 /* of a panel's nodes: fewer are pushed out while sewing */
#define CHECK_INSIDE_AREA 0.01 /* [m2] of a panel inside: a smaller part is pushed out too */
#define CHECK_CROSSWISE                                                                                                \
    0.5                  /* of the distance of its sides: a seam that is nearer with one side turned round is twisted */
#define CHECK_LEAST 0.05 /* [m] shorter seams are not checked */
#define CHECK_STAY 0.02  /* weight of staying: without it a panel could turn about a single straight seam */
#define CHECK_POWERS 400 /* of the matrix: enough for a ratio of eigenvalues of 0.95 */
#define CHECK_FAR 0.12   /* [m] mean distance to its partners from which on a panel may be misplaced */
#define CHECK_BETTER 0.5 /* of that distance: a misplaced panel has less left at its best place */
#define CHECK_ROUND -0.8 /* cosine of the rotation of a panel that is turned round */
#define CHECK_FLAT 0.1   /* squared length of the mean normal of a flat panel, at least; a rolled panel has less */
#define CHECK_AGAINST -0.3 /* dot product of two mean normals that face apart */
#define CHECK_PLACE 0.5    /* of the motion of its middle: how near it comes to the place of the other panel */


/* where a panel would lie best among those that it is sewn to */
typedef struct panel_fit {
    double length;         /* of its seams to other panels [m]; 0 without any, and all else is 0 then */
    double now, best;      /* mean distance of its seam nodes to their partners, as it lies and at best [m] */
    double turned;         /* cosine of the angle of the rotation to the best place */
    double from[3], to[3]; /* its middle, as it lies and at best [m] */
    double facing[3];      /* mean of its normals at best */
} panel_fit;


/* ---- where a panel would lie best ---- */

/* nodes of pair p that belong to `panel` and to another one; false when it is no such pair */
static bool check_pair(const mus_cloth *cloth, int32_t p, int32_t panel, int32_t except, int32_t *own, int32_t *other)
{
    const int32_t a = cloth->pair[2 * p], b = cloth->pair[2 * p + 1];
    const int32_t pa = cloth->node_panel[a], pb = cloth->node_panel[b];
    if ((pa == panel) == (pb == panel) || pa == except || pb == except) return false;
    *own = pa == panel ? a : b, *other = pa == panel ? b : a;
    return true;
}


/* adds a pair of points x and y of weight w to the sums: weight, means, products */
static void check_sum(double w, const double *x, const double *y, double *sum)
{
    sum[0] += w;
    for (int32_t i = 0; i < 3; i++) {
        sum[1 + i] += w * x[i], sum[4 + i] += w * y[i];
        for (int32_t k = 0; k < 3; k++) sum[7 + 3 * i + k] += w * x[i] * y[k];
    }
}


/* the unit quaternion q (4) of the best rotation of these sums */
static void check_rotation(const double *sum, double *q)
{
    double s[3][3], n[4][4], shift = 0.0;
    for (int32_t i = 0; i < 3; i++)
        for (int32_t k = 0; k < 3; k++) s[i][k] = sum[7 + 3 * i + k] - sum[1 + i] * sum[4 + k] / sum[0];
    n[0][0] = s[0][0] + s[1][1] + s[2][2];
    n[1][1] = s[0][0] - s[1][1] - s[2][2];
    n[2][2] = s[1][1] - s[0][0] - s[2][2];
    n[3][3] = s[2][2] - s[0][0] - s[1][1];
    n[0][1] = n[1][0] = s[1][2] - s[2][1];
    n[0][2] = n[2][0] = s[2][0] - s[0][2];
    n[0][3] = n[3][0] = s[0][1] - s[1][0];
    n[1][2] = n[2][1] = s[0][1] + s[1][0];
    n[1][3] = n[3][1] = s[2][0] + s[0][2];
    n[2][3] = n[3][2] = s[1][2] + s[2][1];
    for (int32_t i = 0; i < 4; i++)
        for (int32_t k = 0; k < 4; k++) shift = fmax(shift, fabs(n[i][k]));
    q[0] = 1.0, q[1] = 0.1, q[2] = 0.07, q[3] = 0.03;
    for (int32_t turn = 0; turn < CHECK_POWERS; turn++) {
        double next[4], length = 0.0;
        for (int32_t i = 0; i < 4; i++) {
            next[i] = 2.0 * shift * q[i];
            for (int32_t k = 0; k < 4; k++) next[i] += n[i][k] * q[k];
            length += next[i] * next[i];
        }
        if (!(length > 0.0)) break;
        for (int32_t i = 0; i < 4; i++) q[i] = next[i] / sqrt(length);
    }
}


/* rotates a vector: d + 2 w (v x d) + 2 v x (v x d), q = (w, v) */
static void check_turn(const double *q, const double *d, double *out)
{
    double t[3], u[3];
    mus__cross3(q + 1, d, t);
    mus__cross3(q + 1, t, u);
    for (int32_t i = 0; i < 3; i++) out[i] = d[i] + 2.0 * (q[0] * t[i] + u[i]);
}


static void check_move(const double *sum, const double *q, const double *x, double *out)
{
    double d[3];
    for (int32_t i = 0; i < 3; i++) d[i] = x[i] - sum[1 + i] / sum[0];
    check_turn(q, d, out);
    for (int32_t i = 0; i < 3; i++) out[i] += sum[4 + i] / sum[0];
}


/* the best place of one panel, seams to panel `except` (MUS_NONE: none) left out */
static void check_fit(const mus__placed_cloth *placed, int32_t panel, int32_t except, panel_fit *out)
{
    const mus_cloth *cloth = placed->cloth;
    const mus__panel_mesh *mesh = &cloth->panel[panel];
    double sum[16] = {0.0}, q[4];
    int32_t own, other;
    memset(out, 0, sizeof *out);
    for (int32_t p = 0; p < cloth->npair; p++) {
        if (!check_pair(cloth, p, panel, except, &own, &other)) continue;
        const double *x = placed->x + 3 * (int64_t)own, *y = placed->x + 3 * (int64_t)other;
        const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
        check_sum(cloth->pair_length[p], x, y, sum);
        out->now += cloth->pair_length[p] * mus__norm3(d);
    }
    out->length = sum[0];
    if (!(out->length > 0.0)) return;
    const double stay = CHECK_STAY * out->length / mesh->border_count;
    for (int32_t i = 0; i < mesh->border_count; i++) {
        const double *x = placed->x + 3 * (int64_t)cloth->border[mesh->first_border + i];
        check_sum(stay, x, x, sum);
    }
    check_rotation(sum, q);
    for (int32_t p = 0; p < cloth->npair; p++) {
        double x[3];
        if (!check_pair(cloth, p, panel, except, &own, &other)) continue;
        const double *y = placed->x + 3 * (int64_t)other;
        check_move(sum, q, placed->x + 3 * (int64_t)own, x);
        const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
        out->best += cloth->pair_length[p] * mus__norm3(d);
    }
    out->now /= out->length, out->best /= out->length;
    out->turned = 2.0 * q[0] * q[0] - 1.0;
    mus__placed_middle(placed, panel, out->from);
    check_move(sum, q, out->from, out->to);
    double facing[3];
    mus__placed_facing(placed, panel, facing);
    check_turn(q, facing, out->facing);
}


/* finds a panel of which a large part begins inside the body */
static void check_inside(const mus__placed_cloth *placed, mus_reason *out)
{
    const mus_cloth *cloth = placed->cloth;
    for (int32_t p = 0; p < cloth->npanel && placed->collider != NULL; p++) {
        const mus__panel_mesh *panel = &cloth->panel[p];
        int32_t inside = 0;
        for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++)
            inside += mus__collider_depth(placed->collider, placed->x + 3 * (int64_t)i, 0.0, NULL) > CHECK_INSIDE_DEEP;
        if (!(inside > CHECK_INSIDE_PART * panel->node_count)) continue;
        if (!(inside * cloth->spacing * cloth->spacing > CHECK_INSIDE_AREA)) continue;
        char text[256];
        snprintf(text, sizeof text, "panel %.100s begins inside the body: %d of its %d nodes",
                 mus_cloth_panel_name(cloth, p), (int)inside, (int)panel->node_count);
        mus__reason_start_tangled(out, p, MUS_NONE, text);
        return;
    }
}


/* finds a seam whose sides lie nearer to each other with one of them turned round: it is sewn the wrong way */
static void check_crosswise(const mus__placed_cloth *placed, mus_reason *out)
{
    const mus_cloth *cloth = placed->cloth;
    for (int32_t first = 0, last; first < cloth->npair; first = last) {
        const int32_t seam = cloth->pair_seam[first];
        double length = 0.0, as_is = 0.0, turned = 0.0;
        for (last = first; last < cloth->npair && cloth->pair_seam[last] == seam; last++)
            length += cloth->pair_length[last];
        if (length < CHECK_LEAST) continue;
        for (int32_t p = first; p < last; p++) {
            const double *a = placed->x + 3 * (int64_t)cloth->pair[2 * p];
            const double *b = placed->x + 3 * (int64_t)cloth->pair[2 * p + 1];
            const double *c = placed->x + 3 * (int64_t)cloth->pair[2 * (first + last - 1 - p) + 1];
            const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, e[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
            as_is += mus__norm3(d), turned += mus__norm3(e);
        }
        if (!(turned < CHECK_CROSSWISE * as_is)) continue;
        char text[256];
        const int32_t a = cloth->node_panel[cloth->pair[2 * first]], b = cloth->node_panel[cloth->pair[2 * first + 1]];
        snprintf(text, sizeof text, "seam %d of %.80s and %.80s begins twisted: its sides lie the wrong way round",
                 (int)seam, mus_cloth_panel_name(cloth, a), mus_cloth_panel_name(cloth, b));
        mus__reason_start_tangled(out, a, seam, text);
        return;
    }
}


static bool check_misplaced(const panel_fit *fit)
{
    return fit->now > CHECK_FAR && fit->best < CHECK_BETTER * fit->now;
}


static double check_apart(const double *a, const double *b)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return mus__norm3(d);
}


/* the distance of two points without its component along the facing of a flat panel: along that, fronts are drawn to
 * their backs */
static double check_aside(const double *a, const double *b, const double *facing)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, flat = mus__dot3(facing, facing);
    const double along = flat > CHECK_FLAT ? mus__dot3(d, facing) * mus__dot3(d, facing) / flat : 0.0;
    return sqrt(fmax(0.0, mus__dot3(d, d) - along));
}


/* whether each of two panels, seams between them left out, would lie best where the other is and face as that does. The
 * best place of a front is near the back that it is sewn to, but the back faces the other way */
static bool check_exchanged(const mus__placed_cloth *placed, int32_t p, int32_t q)
{
    panel_fit a, b;
    double facing[2][3];
    check_fit(placed, p, q, &a);
    if (!check_misplaced(&a)) return false;
    check_fit(placed, q, p, &b);
    mus__placed_facing(placed, p, facing[0]);
    mus__placed_facing(placed, q, facing[1]);
    if (mus__dot3(a.facing, facing[1]) < CHECK_AGAINST || mus__dot3(b.facing, facing[0]) < CHECK_AGAINST) return false;
    return check_misplaced(&b) &&
           check_aside(a.to, b.from, facing[1]) < CHECK_PLACE * check_aside(a.to, a.from, facing[1]) &&
           check_aside(b.to, a.from, facing[0]) < CHECK_PLACE * check_aside(b.to, b.from, facing[0]);
}


/* whether a panel's place is not on a side that the pattern tells of it */
static bool check_belied(const mus__placed_cloth *placed, int32_t panel)
{
    static const struct {
        int32_t side, axis;
        double sign;
    } sides[] = {
        {MUS_SIDE_LEFT, 0, 1.0}, {MUS_SIDE_RIGHT, 0, -1.0}, {MUS_SIDE_FRONT, 2, 1.0}, {MUS_SIDE_BACK, 2, -1.0}};
    double middle[3];
    mus__placed_middle(placed, panel, middle);
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++)
        if ((placed->cloth->panel[panel].sides & sides[i].side) != 0 && sides[i].sign * middle[sides[i].axis] < 0.0)
            return true;
    return false;
}


/* the panel that p has changed places with; MUS_NONE without any */
static int32_t check_other(const mus__placed_cloth *placed, int32_t p, const panel_fit *fit)
{
    for (int32_t q = 0; q < placed->cloth->npanel; q++) {
        double middle[3];
        mus__placed_middle(placed, q, middle);
        if (q == p || !(check_apart(fit->to, middle) < check_apart(fit->to, fit->from))) continue;
        if (check_exchanged(placed, p, q)) return q;
    }
    return MUS_NONE;
}


static void check_name_two(const mus__placed_cloth *placed, int32_t p, int32_t q, mus_reason *out)
{
    char text[256];
    snprintf(text, sizeof text, "panels %.80s and %.80s begin in each other's place",
             mus_cloth_panel_name(placed->cloth, p), mus_cloth_panel_name(placed->cloth, q));
    mus__reason_start_tangled(out, p, MUS_NONE, text);
}


/* prefers the first two panels whose sides contradict their places, if there are two, over the two that were found */
static void check_name_belied(const mus__placed_cloth *placed, mus_reason *out)
{
    int32_t first = MUS_NONE;
    for (int32_t p = 0; p < placed->cloth->npanel; p++) {
        if (!check_belied(placed, p)) continue;
        if (first != MUS_NONE) {
            check_name_two(placed, first, p, out);
            return;
        }
        first = p;
    }
}


/*
 * A panel that is misplaced by a motion to where another is that is misplaced so too, or by one that turns it round.
 * Two sleeves that are exchanged lie as front and back would, seen from behind, so a pair that its sides contradict is
 * preferred.
 */
static void check_places(const mus__placed_cloth *placed, mus_reason *out)
{
    const mus_cloth *cloth = placed->cloth;
    int32_t turned[2], n = 0;
    double far = 0.0;
    for (int32_t p = 0; p < cloth->npanel && cloth->npair > 0; p++) {
        panel_fit fit;
        check_fit(placed, p, MUS_NONE, &fit);
        if (!check_misplaced(&fit)) continue;
        const int32_t q = check_other(placed, p, &fit);
        const bool belied = check_belied(placed, p);
        if (q != MUS_NONE && (belied || out->kind == MUS_REASON_NONE)) check_name_two(placed, p, q, out);
        if (q != MUS_NONE && belied) return;
        if (q == MUS_NONE && fit.turned < CHECK_ROUND && n < 2) turned[n++] = p, far = n == 1 ? fit.now : far;
    }
    if (n == 2 && out->kind == MUS_REASON_NONE) check_name_two(placed, turned[0], turned[1], out);
    if (out->kind != MUS_REASON_NONE) check_name_belied(placed, out);
    if (out->kind != MUS_REASON_NONE || n == 0) return;
    char text[256];
    snprintf(text, sizeof text, "panel %.100s begins turned round, %.0f mm from what it is sewn to",
             mus_cloth_panel_name(cloth, turned[0]), 1e3 * far);
    mus__reason_start_tangled(out, turned[0], MUS_NONE, text);
}


void mus__arrange_check(const mus__placed_cloth *placed, mus_reason *out)
{
    static void (*const looks[])(const mus__placed_cloth *, mus_reason *) = {check_inside, check_crosswise,
                                                                             check_places};
    mus_reason_init(out, sizeof *out);
    for (size_t i = 0; i < sizeof looks / sizeof *looks && out->kind == MUS_REASON_NONE; i++) looks[i](placed, out);
}
