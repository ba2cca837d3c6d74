/*
 * drape.c: whole pieces: crumpled and turned; cut finer and finer, a strip that hangs and the drape disc
 * (cases M9, M10, B8).
 *
 * The drape coefficient is that of BS 5058 and ISO 9073-9: a disc of 30 cm on a support of 18 cm, the part of the ring
 * that the shadow of the draped cloth still covers.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/args.h"
#include "rest.h"

#define DISC 0.15 /* radii [m] */
#define SUPPORT 0.09
#define RAYS 3600
#define DISC_WEIGHT 0.15 /* of the plain fabrics [kg/m2] */


/* ---- M9 ---- */

static double noise(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*state >> 11) * 0x1p-52 - 1.0;
}


/* out = turned by the unit quaternion q */
static void turn(const double *q, const double *in, double *out)
{
    const double t[3] = {2.0 * (q[2] * in[2] - q[3] * in[1]), 2.0 * (q[3] * in[0] - q[1] * in[2]),
                         2.0 * (q[1] * in[1] - q[2] * in[0])};
    out[0] = in[0] + q[0] * t[0] + q[2] * t[2] - q[3] * t[1];
    out[1] = in[1] + q[0] * t[1] + q[3] * t[0] - q[1] * t[2];
    out[2] = in[2] + q[0] * t[2] + q[1] * t[1] - q[2] * t[0];
}


/* energy and, by a short step, the forces of a crumpled panel and of it turned */
static void turned(verify *v)
{
    static const double corner[] = {0, 0, 0.1, 0, 0.08, 0.09, 0.01, 0.08};
    enum { MOST = 400 };
    double x[3 * MOST], y[3 * MOST], f[3 * MOST], worst[2] = {0.0, 0.0}, size = 0.0;
    uint64_t state = 7;
    mus_fabric fabric;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    rest_fabric(&fabric, 0.15, 900.0, 60.0, 1e-5);
    mus_status status = rest_panel(v, 4, corner, 0.1, 1.0, 0.01, &fabric, &cloth);
    if (status == MUS_OK) status = rest_hang(v, cloth, 64, 0.0, 0.0, &drape);
    const int32_t n = status == MUS_OK ? mus_drape_node_count(drape) : 0;
    if (n > MOST) status = MUS_ERR_LIMIT;
    for (int32_t i = 0; i < 3 * n && status == MUS_OK; i++)
        x[i] = mus_drape_positions(drape)[i] + 0.004 * noise(&state);
    const double h = 1e-7;
    double energy = 1.0;
    for (int k = 0; k <= 100 && status == MUS_OK; k++) {
        double q[4] = {1.0, 0.0, 0.0, 0.0}, long2 = 0.0;
        for (int d = 0; d < 4 && k > 0; d++) q[d] = noise(&state);
        for (int d = 0; d < 4; d++) long2 += q[d] * q[d];
        for (int d = 0; d < 4; d++) q[d] /= sqrt(long2);
        for (int32_t i = 0; i < n; i++) turn(q, x + 3 * i, y + 3 * i);
        status = mus_drape_set_state(drape, y, NULL);
        if (k == 0) energy = rest_energy(drape);
        worst[0] = fmax(worst[0], fabs(rest_energy(drape) / energy - 1.0));
        if (status == MUS_OK) status = mus_drape_step(drape, 1, h);
        for (int32_t i = 0; i < n; i++) {
            const double *now = mus_drape_velocities(drape) + 3 * i;
            double want[3];
            if (k == 0) memcpy(f + 3 * i, now, sizeof want);
            turn(q, f + 3 * i, want);
            for (int d = 0; d < 3; d++) {
                size = fmax(size, fabs(want[d]));
                worst[1] = fmax(worst[1], fabs(now[d] - want[d]) / size);
            }
        }
    }
    rest_row(v, status, "M9", "crumpled panel turned 100 times, relative change of its energy", 0.0, worst[0], 1e-12);
    rest_row(v, status, "M9", "crumpled panel turned 100 times, relative change of a force", 0.0, worst[1], 1e-11);
    mus_drape_destroy(drape);
}


/* ---- M10: a strip that hangs ---- */

/* sag of the lower edge of a cut panel of 0.1 x 0.5 m that hangs from its upper edge */
static mus_status hang_panel(verify *v, double spacing, double *sag)
{
    static const double corner[] = {0, 0, 0.1, 0, 0.1, 0.5, 0, 0.5};
    mus_fabric fabric;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    double count = 0.0;
    rest_fabric(&fabric, 0.15, 300.0, 40.0, 5e-6);
    mus_status status = rest_panel(v, 4, corner, 0.0, 1.0, spacing, &fabric, &cloth);
    if (status == MUS_OK) status = rest_hang(v, cloth, 64, 60.0, REST_GRAVITY, &drape);
    const int32_t n = status == MUS_OK ? mus_drape_node_count(drape) : 0;
    *sag = 0.0;
    for (int32_t i = 0; i < n && status == MUS_OK; i++)
        if (mus_drape_positions(drape)[3 * i + 1] > 0.5 - 1e-9) status = mus_drape_pin(drape, i, 1);
    if (status == MUS_OK) status = rest_settle(v, drape, 1e-6, 2.0);
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        if (mus_drape_positions(drape)[3 * i + 1] > 0.001) continue;
        *sag -= mus_drape_positions(drape)[3 * i + 1];
        count++;
    }
    *sag /= count;
    mus_drape_destroy(drape);
    return status;
}


static void hung_panels(verify *v)
{
    static const double spacing[] = {0.01, 0.005, 0.0025};
    const int last = 3;
    double sag[3] = {NAN, NAN, NAN};
    mus_status status = MUS_OK;
    for (int i = 0; i < last && status == MUS_OK; i++) status = hang_panel(v, spacing[i], &sag[i]);
    for (int i = 0; i + 1 < last; i++) {
        char text[120];
        snprintf(text, sizeof text, "cut strip 0.1 x 0.5 m that hangs, sag at %g mm, as at %g mm [m]", 1e3 * spacing[i],
                 1e3 * spacing[i + 1]);
        rest_row(v, status, "M10", text, sag[i + 1], sag[i], 0.01);
    }
}


/* ---- B8, M10: a disc of 30 cm on a support of 18 cm ---- */

/* a half circle of the radius about the middle from `start` to `end`, through (0, over radius) */
static mus_status half_circle(mus_pattern *pattern, double radius, const int32_t *ends, double over, int32_t *edge)
{
    const int32_t arc = MUS_PIECE_ARC;
    const double through[2] = {0.0, over * radius};
    return mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = ends[0], .end = ends[1],
                                                         .npiece = 1, .kinds = &arc, .nxy = 1, .xy = through}, edge);
}


/* a panel of the disc: both half circles of the support (half < 0), or a half ring round it. edge: of the support its
 * two half circles; of a ring its inner half circle, then the cuts at the start and at the end of it */
static mus_status disc_panel(mus_pattern *pattern, int half, int32_t *edge)
{
    static const int32_t forward[2] = {1, 1}, round[4] = {1, 1, -1, -1};
    const double level[9] = {1, 0, 0, 0, 0, 1, 0, -1, 0}, side = half == 1 ? -1.0 : 1.0;
    int32_t panel = 0, inner[2], outer[2], rim = 0;
    mus_placement place;
    mus_status status = mus_pattern_add_panel(pattern, half < 0 ? "support" : half == 0 ? "ring 1" : "ring 2", &panel);
    for (int k = 0; k < 2 && status == MUS_OK; k++) {
        const double x = k == 0 ? side : -side;
        status = mus_pattern_add_point(pattern, panel, x * SUPPORT, 0.0, &inner[k]);
        if (status == MUS_OK && half >= 0) status = mus_pattern_add_point(pattern, panel, x * DISC, 0.0, &outer[k]);
    }
    if (status == MUS_OK) status = half_circle(pattern, SUPPORT, inner, side, &edge[0]);
    if (status == MUS_OK && half < 0)
        status = half_circle(pattern, SUPPORT, (const int32_t[]){inner[1], inner[0]}, -1.0, &edge[1]);
    if (status == MUS_OK && half >= 0) status = half_circle(pattern, DISC, outer, side, &rim);
    for (int k = 0; k < 2 && half >= 0 && status == MUS_OK; k++)
        status = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = inner[k],
                                                               .end = outer[k]}, &edge[1 + k]);
    const int32_t ring[4] = {edge[1], rim, half < 0 ? 0 : edge[2], edge[0]};
    if (status == MUS_OK)
        status = mus_pattern_set_outline(pattern, panel, half < 0 ? 2 : 4, half < 0 ? edge : ring,
                                         half < 0 ? forward : round);
    mus_placement_init(&place, sizeof place);
    memcpy(place.rotation, level, sizeof level);
    return status == MUS_OK ? mus_pattern_set_placement(pattern, panel, &place) : status;
}


/* a disc whose mesh fits both circles, flat and level: a panel on the support and two half rings, sewn together */
static mus_status disc_cloth(verify *v, double spacing, const mus_fabric *fabric, mus_cloth **out)
{
    int32_t support[2], ring[2][3];
    mus_pattern *pattern = NULL;
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = spacing;
    def.fabric = fabric;
    def.coarser = 0;
    mus_status status = mus_pattern_create(v->context, "disc", &pattern);
    if (status == MUS_OK) status = disc_panel(pattern, -1, support);
    for (int k = 0; k < 2 && status == MUS_OK; k++) status = disc_panel(pattern, k, ring[k]);
    const int32_t seam[4][2] = {{support[0], ring[0][0]},
                                {support[1], ring[1][0]},
                                {ring[0][1], ring[1][2]},
                                {ring[0][2], ring[1][1]}};
    for (int k = 0; k < 4 && status == MUS_OK; k++) {
        mus_seam_def sewn;
        mus_seam_def_init(&sewn, sizeof sewn);
        sewn.edge_a = seam[k][0], sewn.edge_b = seam[k][1];
        sewn.direction = MUS_SEAM_DIRECT;
        status = mus_pattern_add_seam(pattern, &sewn, NULL);
    }
    if (status == MUS_OK) status = mus_cloth_create(v->context, pattern, &def, out);
    mus_pattern_destroy(pattern);
    return status;
}


/* reach of the shadow along each ray, from one edge of the cloth seen from above */
static void cast(double *reach, const double *p, const double *q)
{
    const double *a = p, *b = q;
    double cross = a[0] * b[2] - a[2] * b[0];
    if (cross < 0.0) a = q, b = p, cross = -cross;
    const double start = atan2(a[2], a[0]), wide = atan2(cross, a[0] * b[0] + a[2] * b[2]);
    const double unit = 2.0 * REST_PI / RAYS;
    for (int32_t k = (int32_t)ceil(start / unit); k <= (int32_t)floor((start + wide) / unit); k++) {
        const double c = cos(k * unit), s = sin(k * unit), along = (b[0] - a[0]) * s - (b[2] - a[2]) * c;
        if (fabs(along) < 1e-15) continue;
        double *own = &reach[(k + RAYS) % RAYS];
        *own = fmax(*own, fabs(cross / along));
    }
}


/* drape coefficient: shadow outside of the support over the ring of the flat cloth [%] */
static double coefficient(const double *x, int32_t triangles, const int32_t *triangle)
{
    double reach[RAYS] = {0}, area = 0.0;
    for (int32_t t = 0; t < triangles; t++)
        for (int k = 0; k < 3; k++) cast(reach, x + 3 * triangle[3 * t + k], x + 3 * triangle[3 * t + (k + 1) % 3]);
    for (int32_t k = 0; k < RAYS; k++) area += 0.5 * reach[k] * reach[k] * 2.0 * REST_PI / RAYS;
    const double support = REST_PI * SUPPORT * SUPPORT;
    return 100.0 * (area - support) / (REST_PI * DISC * DISC - support);
}


/* sew the disc, hold it on the support, and start level but for `lobes` folds of a millimetre */
static mus_status lay_disc(mus_drape *drape, int32_t lobes)
{
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    if (x == NULL) return MUS_ERR_MEMORY;
    mus_status status = mus_drape_place(drape);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    if (status == MUS_OK) status = mus_drape_set_gravity(drape, (const double[]){0.0, 0.0, 0.0});
    if (status == MUS_OK) status = mus_drape_sew(drape, NULL, NULL);
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        const double r = hypot(x[3 * i], x[3 * i + 2]), s = fmax(0.0, (r - SUPPORT) / (DISC - SUPPORT));
        x[3 * i + 1] += 0.001 * s * s * cos(lobes * atan2(x[3 * i + 2], x[3 * i]));
        if (r <= SUPPORT + 1e-6) status = mus_drape_pin(drape, i, 1);
    }
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    free(x);
    return status;
}


/* let the weight come on in quarters, as the plate under the ring goes down: friction of bending stays one-sided */
static mus_status load_disc(mus_drape *drape)
{
    mus_status status = MUS_OK;
    for (int k = 1; k <= 4 && status == MUS_OK; k++) {
        status = mus_drape_set_gravity(drape, (const double[]){0.0, -0.25 * k * REST_GRAVITY, 0.0});
        if (status == MUS_OK) status = mus_drape_settle(drape, NULL, NULL);
    }
    return status;
}


static mus_status drape_disc(verify *v, double spacing, const mus_fabric *fabric, int32_t lobes, double *percent)
{
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    int32_t *triangle = NULL, triangles = 0;
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.settle_residual = 0.005;
    mus_status status = disc_cloth(v, spacing, fabric, &cloth);
    if (status == MUS_OK) {
        triangles = mus_cloth_triangle_count(cloth);
        triangle = malloc(3 * (size_t)triangles * sizeof *triangle);
        if (triangle != NULL) memcpy(triangle, mus_cloth_triangles(cloth), 3 * (size_t)triangles * sizeof *triangle);
        status = triangle != NULL ? mus_drape_create(v->context, cloth, NULL, &def, &drape) : MUS_ERR_MEMORY;
    }
    if (status == MUS_OK) status = lay_disc(drape, lobes);
    if (status == MUS_OK) status = load_disc(drape);
    *percent = status == MUS_OK ? coefficient(mus_drape_positions(drape), triangles, triangle) : NAN;
    free(triangle);
    mus_cloth_destroy(cloth);
    mus_drape_destroy(drape);
    return status;
}


/*
 * Plain fabrics of given bending length, finer and finer: the coefficient may move by 3 points. The softer one needs 5
 * mm for its folds; at 10 mm its shapes of 5 to 8 folds, all at rest, lie between 60 and 69 %.
 */
static void discs(verify *v)
{
    static const double length[] = {0.03, 0.03, 0.02}, coarse[] = {0.01, 0.005, 0.005};
    for (int c = 0; c < (v->all ? 3 : 1); c++) {
        char text[120];
        double percent[2] = {NAN, NAN};
        mus_fabric fabric;
        rest_fabric(&fabric, DISC_WEIGHT, 500.0, 40.0, DISC_WEIGHT * REST_GRAVITY * pow(length[c], 3.0));
        mus_status status = MUS_OK;
        for (int i = 0; i < 2 && status == MUS_OK; i++)
            status = drape_disc(v, i == 0 ? coarse[c] : 0.5 * coarse[c], &fabric, 6, &percent[i]);
        snprintf(text, sizeof text, "drape disc, c = %g cm: %.1f %% at %g mm, points off at %g mm", 100.0 * length[c],
                 percent[1], 0.5e3 * coarse[c], 1e3 * coarse[c]);
        rest_row(v, status, "M10", text, 0.0, percent[1] - percent[0], 3.0);
    }
}


/* a plate stays flat; fabrics whose bending (B and 2HB) and drape coefficient the same laboratory measured, within 4
 * points of it. Broadcloth is a known failure: loaded slowly its friction holds it higher, and its weight is assumed */
static void coefficients(verify *v)
{
    double percent = NAN;
    mus_fabric fabric;
    rest_fabric(&fabric, DISC_WEIGHT, 5000.0, 400.0, DISC_WEIGHT * REST_GRAVITY * pow(0.25, 3.0));
    mus_status status = drape_disc(v, 0.01, &fabric, 6, &percent);
    rest_row(v, status, "B8", "drape disc of a plate, coefficient [%]", 100.0, percent, 0.01);
    static const char *const name[] = {"broadcloth", "polyester"};
    static const double measured[] = {82.9, 28.3};
    for (int i = 0; i < (v->all ? 2 : 1); i++) {
        char text[120];
        mus_fabric_init(&fabric, sizeof fabric);
        mus_fabric_find(name[i], &fabric);
        fabric.damping = 0.0;
        status = drape_disc(v, i == 0 ? 0.01 : 0.005, &fabric, 6, &percent);
        snprintf(text, sizeof text, "%s, disc of %d mm loaded slowly, coefficient [%%]", name[i], i == 0 ? 10 : 5);
        if (status == MUS_OK && i == 0)
            verify_add_negative(v, "B8", text, measured[i], percent, 4.0 / measured[i]);
        else
            rest_row(v, status, "B8", text, measured[i], percent, 4.0 / measured[i]);
    }
}


int verify_drape(verify *v)
{
    if (verify_wants(v, "M9")) turned(v);
    if (verify_wants(v, "B8")) coefficients(v);
    if (verify_wants(v, "M10")) {
        hung_panels(v);
        discs(v);
    }
    return EXIT_DONE;
}
