/*
 * start.c: a bad start is found before the run, and named: panels inside the body, seams whose sides lie the wrong way
 * round, panels that begin turned round or in one another's place; and what start_layer.c finds.
 *
 * For a panel in the wrong place: the rigid motion that brings its seam nodes nearest to their partners, while the
 * others stay (Horn, Closed-form solution of absolute orientation using unit quaternions, 1987; its quaternion is the
 * eigenvector to the largest eigenvalue of a symmetric 4 x 4 matrix, here by powers of it).
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drape/drape_internal.h"
#include "drape/start.h"
#include "geom/vec.h"

#define START_INSIDE_DEEP 0.02  /* [m]: a node so far inside the body does not merely touch it */
#define START_INSIDE_PART 0.25  /* of a panel's nodes: less is pushed out while sewing */
#define START_INSIDE_AREA 0.01  /* [m2]: and smaller pieces are */
#define START_CROSSWISE 0.5     /* a seam whose ends are this much nearer the other way round lies twisted */
#define START_LEAST 0.05        /* [m]: shorter seams may lie as they like */
#define START_STAY 0.02         /* weight of staying where it is: a single straight seam is an axis to turn about */
#define START_POWERS 400
#define START_FAR 0.12          /* [m] mean distance: a panel that is nearer to its partners is well placed */
#define START_BETTER 0.5        /* of it: what a motion must leave at most to be worth a word */
#define START_ROUND -0.8        /* cosine: that motion turns it round */
#define START_FLAT 0.1          /* square of a facing: that of a roll is less */
#define START_AGAINST -0.3      /* of facings: those of a roll are short */
#define START_PLACE 0.5         /* of the way that its middle goes: so near it comes to where the other panel is */


/* ---- where a panel would lie best ---- */

/* nodes of pair p that belong to `panel` and to another one; false when it is no such pair */
static bool start_pair(const mus_cloth *cloth, int32_t p, int32_t panel, int32_t except, int32_t *own, int32_t *other)
{
    const int32_t a = cloth->pair[2 * p], b = cloth->pair[2 * p + 1];
    const int32_t pa = cloth->node_panel[a], pb = cloth->node_panel[b];
    if ((pa == panel) == (pb == panel) || pa == except || pb == except) return false;
    *own = pa == panel ? a : b, *other = pa == panel ? b : a;
    return true;
}


/* add weight w of x going to y to the sums: weight, means, products */
static void start_sum(double w, const double *x, const double *y, double *sum)
{
    sum[0] += w;
    for (int32_t i = 0; i < 3; i++) {
        sum[1 + i] += w * x[i], sum[4 + i] += w * y[i];
        for (int32_t k = 0; k < 3; k++) sum[7 + 3 * i + k] += w * x[i] * y[k];
    }
}


/* the unit quaternion of the best rotation of such sums */
static void start_rotation(const double *sum, double *q)
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
    for (int32_t turn = 0; turn < START_POWERS; turn++) {
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


/* d + 2 w (v x d) + 2 v x (v x d), q = (w, v) */
static void start_turn(const double *q, const double *d, double *out)
{
    double t[3], u[3];
    mus__cross3(q + 1, d, t);
    mus__cross3(q + 1, t, u);
    for (int32_t i = 0; i < 3; i++) out[i] = d[i] + 2.0 * (q[0] * t[i] + u[i]);
}


static void start_move(const double *sum, const double *q, const double *x, double *out)
{
    double d[3];
    for (int32_t i = 0; i < 3; i++) d[i] = x[i] - sum[1 + i] / sum[0];
    start_turn(q, d, out);
    for (int32_t i = 0; i < 3; i++) out[i] += sum[4 + i] / sum[0];
}


void mus__start_facing(const mus_drape *drape, int32_t panel, double *out)
{
    const mus__panel_mesh *mesh = &drape->cloth->panel[panel];
    double area = 0.0;
    memset(out, 0, 3 * sizeof *out);
    for (int32_t t = mesh->first_triangle; t < mesh->first_triangle + mesh->triangle_count; t++) {
        const int32_t *v = drape->cloth->triangle + 3 * (int64_t)t;
        const double *a = drape->x + 3 * (int64_t)v[0], *b = drape->x + 3 * (int64_t)v[1];
        const double *c = drape->x + 3 * (int64_t)v[2];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, e[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        double normal[3];
        mus__cross3(d, e, normal);
        for (int32_t i = 0; i < 3; i++) out[i] += normal[i];
        area += mus__norm3(normal);
    }
    for (int32_t i = 0; i < 3 && area > 0.0; i++) out[i] /= area;
}


void mus__start_middle(const mus_drape *drape, int32_t panel, double *out)
{
    const mus__panel_mesh *mesh = &drape->cloth->panel[panel];
    memset(out, 0, 3 * sizeof *out);
    for (int32_t i = mesh->first_node; i < mesh->first_node + mesh->node_count; i++)
        for (int32_t d = 0; d < 3; d++) out[d] += drape->x[3 * (int64_t)i + d] / mesh->node_count;
}


void mus__start_fit(const mus_drape *drape, int32_t panel, int32_t except, mus__start *out)
{
    const mus_cloth *cloth = drape->cloth;
    const mus__panel_mesh *mesh = &cloth->panel[panel];
    double sum[16] = {0.0}, q[4];
    int32_t own, other;
    memset(out, 0, sizeof *out);
    for (int32_t p = 0; p < cloth->npair; p++) {
        if (!start_pair(cloth, p, panel, except, &own, &other)) continue;
        const double *x = drape->x + 3 * (int64_t)own, *y = drape->x + 3 * (int64_t)other;
        const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
        start_sum(cloth->pair_length[p], x, y, sum);
        out->now += cloth->pair_length[p] * mus__norm3(d);
    }
    out->length = sum[0];
    if (!(out->length > 0.0)) return;
    const double stay = START_STAY * out->length / mesh->border_count;
    for (int32_t i = 0; i < mesh->border_count; i++) {
        const double *x = drape->x + 3 * (int64_t)cloth->border[mesh->first_border + i];
        start_sum(stay, x, x, sum);
    }
    start_rotation(sum, q);
    for (int32_t p = 0; p < cloth->npair; p++) {
        double x[3];
        if (!start_pair(cloth, p, panel, except, &own, &other)) continue;
        const double *y = drape->x + 3 * (int64_t)other;
        start_move(sum, q, drape->x + 3 * (int64_t)own, x);
        const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
        out->best += cloth->pair_length[p] * mus__norm3(d);
    }
    out->now /= out->length, out->best /= out->length;
    out->turned = 2.0 * q[0] * q[0] - 1.0;
    mus__start_middle(drape, panel, out->from);
    start_move(sum, q, out->from, out->to);
    double facing[3];
    mus__start_facing(drape, panel, facing);
    start_turn(q, facing, out->facing);
}


/* ---- what is odd ---- */

void mus__start_tangled(mus_reason *out, int32_t panel, int32_t seam, const char *text)
{
    mus__reason_write(out, MUS_REASON_START_TANGLED, text);
    out->panel = panel, out->seam = seam;
}


/* a panel much of which begins inside the body */
static void start_inside(const mus_drape *drape, mus_reason *out)
{
    const mus_cloth *cloth = drape->cloth;
    for (int32_t p = 0; p < cloth->npanel && drape->collider != NULL; p++) {
        const mus__panel_mesh *panel = &cloth->panel[p];
        int32_t inside = 0;
        for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++)
            inside += mus__collider_depth(drape->collider, drape->x + 3 * (int64_t)i, 0.0, NULL) > START_INSIDE_DEEP;
        if (!(inside > START_INSIDE_PART * panel->node_count)) continue;
        if (!(inside * cloth->spacing * cloth->spacing > START_INSIDE_AREA)) continue;
        char text[256];
        snprintf(text, sizeof text, "panel %.100s begins inside the body: %d of its %d nodes",
                 mus_cloth_panel_name(cloth, p), (int)inside, (int)panel->node_count);
        mus__start_tangled(out, p, MUS_NONE, text);
        return;
    }
}


/* a seam that would lie much better with one side turned round: sewn the wrong way */
static void start_crosswise(const mus_drape *drape, mus_reason *out)
{
    const mus_cloth *cloth = drape->cloth;
    for (int32_t first = 0, last; first < cloth->npair; first = last) {
        const int32_t seam = cloth->pair_seam[first];
        double length = 0.0, as_is = 0.0, turned = 0.0;
        for (last = first; last < cloth->npair && cloth->pair_seam[last] == seam; last++)
            length += cloth->pair_length[last];
        if (length < START_LEAST) continue;
        for (int32_t p = first; p < last; p++) {
            const double *a = drape->x + 3 * (int64_t)cloth->pair[2 * p];
            const double *b = drape->x + 3 * (int64_t)cloth->pair[2 * p + 1];
            const double *c = drape->x + 3 * (int64_t)cloth->pair[2 * (first + last - 1 - p) + 1];
            const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, e[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
            as_is += mus__norm3(d), turned += mus__norm3(e);
        }
        if (!(turned < START_CROSSWISE * as_is)) continue;
        char text[256];
        const int32_t a = cloth->node_panel[cloth->pair[2 * first]], b = cloth->node_panel[cloth->pair[2 * first + 1]];
        snprintf(text, sizeof text, "seam %d of %.80s and %.80s begins twisted: its sides lie the wrong way round",
                 (int)seam, mus_cloth_panel_name(cloth, a), mus_cloth_panel_name(cloth, b));
        mus__start_tangled(out, a, seam, text);
        return;
    }
}


static bool start_misplaced(const mus__start *fit)
{
    return fit->now > START_FAR && fit->best < START_BETTER * fit->now;
}


static double start_apart(const double *a, const double *b)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return mus__norm3(d);
}


/* the same without what is along the facing of a flat panel: fronts are drawn to their backs that way, no farther */
static double start_aside(const double *a, const double *b, const double *facing)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, flat = mus__dot3(facing, facing);
    const double along = flat > START_FLAT ? mus__dot3(d, facing) * mus__dot3(d, facing) / flat : 0.0;
    return sqrt(fmax(0.0, mus__dot3(d, d) - along));
}


/* whether each of two panels, what joins them left out, would lie best where the other is, and face as that does: the
 * best place of a front is near the back that it is sewn to, but that faces the other way */
static bool start_exchanged(const mus_drape *drape, int32_t p, int32_t q)
{
    mus__start a, b;
    double facing[2][3];
    mus__start_fit(drape, p, q, &a);
    if (!start_misplaced(&a)) return false;
    mus__start_fit(drape, q, p, &b);
    mus__start_facing(drape, p, facing[0]);
    mus__start_facing(drape, q, facing[1]);
    if (mus__dot3(a.facing, facing[1]) < START_AGAINST || mus__dot3(b.facing, facing[0]) < START_AGAINST) return false;
    return start_misplaced(&b) &&
           start_aside(a.to, b.from, facing[1]) < START_PLACE * start_aside(a.to, a.from, facing[1]) &&
           start_aside(b.to, a.from, facing[0]) < START_PLACE * start_aside(b.to, b.from, facing[0]);
}


/* whether a word in a panel's name contradicts where it lies */
static bool start_belied(const mus_drape *drape, int32_t panel)
{
    static const struct {
        const char *word;
        int32_t axis;
        double sign;
    } words[] = {{"left", 0, 1.0}, {"right", 0, -1.0}, {"front", 2, 1.0}, {"back", 2, -1.0}};
    double middle[3];
    mus__start_middle(drape, panel, middle);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(mus_cloth_panel_name(drape->cloth, panel), words[i].word) != NULL &&
            words[i].sign * middle[words[i].axis] < 0.0)
            return true;
    return false;
}


/* the panel that p has changed places with: lies best where p is, and p where it is; MUS_NONE without */
static int32_t start_other(const mus_drape *drape, int32_t p, const mus__start *fit)
{
    for (int32_t q = 0; q < drape->cloth->npanel; q++) {
        double middle[3];
        mus__start_middle(drape, q, middle);
        if (q == p || !(start_apart(fit->to, middle) < start_apart(fit->to, fit->from))) continue;
        if (start_exchanged(drape, p, q)) return q;
    }
    return MUS_NONE;
}


static void start_name_two(const mus_drape *drape, int32_t p, int32_t q, mus_reason *out)
{
    char text[256];
    snprintf(text, sizeof text, "panels %.80s and %.80s begin in each other's place",
             mus_cloth_panel_name(drape->cloth, p), mus_cloth_panel_name(drape->cloth, q));
    mus__start_tangled(out, p, MUS_NONE, text);
}


/* two panels that no name contradicts are exchanged: so are the first two that their names contradict, if any */
static void start_name_belied(const mus_drape *drape, mus_reason *out)
{
    int32_t first = MUS_NONE;
    for (int32_t p = 0; p < drape->cloth->npanel; p++) {
        if (!start_belied(drape, p)) continue;
        if (first != MUS_NONE) {
            start_name_two(drape, first, p, out);
            return;
        }
        first = p;
    }
}


/*
 * A panel that is misplaced by a motion to where another is that is misplaced so too, or by one that turns it round.
 * Two sleeves that are exchanged lie as front and back would, seen from behind: what a name contradicts is preferred.
 */
static void start_places(const mus_drape *drape, mus_reason *out)
{
    const mus_cloth *cloth = drape->cloth;
    int32_t turned[2], n = 0;
    double far = 0.0;
    for (int32_t p = 0; p < cloth->npanel && cloth->npair > 0; p++) {
        mus__start fit;
        mus__start_fit(drape, p, MUS_NONE, &fit);
        if (!start_misplaced(&fit)) continue;
        const int32_t q = start_other(drape, p, &fit);
        const bool belied = start_belied(drape, p);
        if (q != MUS_NONE && (belied || out->kind == MUS_REASON_NONE)) start_name_two(drape, p, q, out);
        if (q != MUS_NONE && belied) return;
        if (q == MUS_NONE && fit.turned < START_ROUND && n < 2) turned[n++] = p, far = n == 1 ? fit.now : far;
    }
    if (n == 2 && out->kind == MUS_REASON_NONE) start_name_two(drape, turned[0], turned[1], out);
    if (out->kind != MUS_REASON_NONE) start_name_belied(drape, out);
    if (out->kind != MUS_REASON_NONE || n == 0) return;
    char text[256];
    snprintf(text, sizeof text, "panel %.100s begins turned round, %.0f mm from what it is sewn to",
             mus_cloth_panel_name(cloth, turned[0]), 1e3 * far);
    mus__start_tangled(out, turned[0], MUS_NONE, text);
}


void mus__drape_start(const mus_drape *drape, mus_reason *out)
{
    static void (*const looks[])(const mus_drape *, mus_reason *) = {start_inside, start_crosswise, start_places};
    mus_reason_init(out, sizeof *out);
    for (size_t i = 0; i < sizeof looks / sizeof *looks && out->kind == MUS_REASON_NONE; i++) looks[i](drape, out);
}


mus_status mus_drape_start(const mus_drape *drape, mus_reason *out)
{
    mus_reason own;
    if (drape == NULL) return MUS_ERR_ARG;
    mus__drape_start(drape, &own);
    const mus_status status = own.kind == MUS_REASON_NONE ? mus__start_layers(drape, &own) : MUS_OK;
    return status == MUS_OK ? mus__reason_give(drape->context, &own, out) : status;
}
