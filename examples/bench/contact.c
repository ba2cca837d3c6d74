/*
 * contact.c: times contact a node, for surfaces with different numbers of triangles, and a tree of boxes over the
 * triangles at the same points in the same run.
 *
 * Points lie within 4 mm of the skin of a body W40, as those of cloth do: in the order of the surface's triangles, as
 * nodes of a cloth are, and in random order, where the processor's caches do not help. Contact is timed as a drape does
 * it: steps of nodes without springs round the body, less the same steps without a body, in float. The clearance makes
 * each node touch, so that each is queried and answered in every step. (garment_contact.c times a garment.)
 * mus_body_depth() is timed too, in double; it queries every part of the body for every point. The tree is built over a
 * surface of about 20,000 triangles; outside the body its distances are compared with depths.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "triangle_tree.h"

#define POINTS 20000
#define REPEATS 9
#define STEPS 20
#define STEP 1e-4 /* [s] */
#define OFF_LEAST -0.001 /* [m] */
#define OFF_MOST 0.004

static const struct {
    const char *name;
    int32_t samples;
    double ring_spacing;
    bool tree, scattered;
} surfaces[] = {
    {"contact_5k_triangles", 16, 0.1, false, false},
    {"contact_500k_triangles", 256, 0.0055, false, false},
    {"contact_20k_triangles", 48, 0.05, true, false},
    {"contact_20k_scattered", 48, 0.05, true, true},
};

/* the figures of one surface */
typedef struct asked {
    const char *name;
    int32_t triangles;
    int64_t queries, visits;  /* in one pass over the nodes: queries of a part; triangles visited by the tree */
    double node_ns, depth_ns; /* time of a node in the contact pass; of a point in mus_body_depth() [ns] */
    double tree_ns;           /* time of a point in the tree [ns] */
    double median, worst;     /* difference of the tree's distance from the depth, outside the body [m] */
} asked;


static double random_part(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*state >> 11) * 0x1p-53;
}


/* Makes points off the skin of a body, triangle by triangle; points inside another limb are left out. */
static mus_status make_points(const mus_body *body, double *points)
{
    uint64_t random = 4;
    const int32_t n = mus_body_triangle_count(body);
    const double *x = mus_body_vertices(body), *normal = mus_body_normals(body);
    mus_status status = MUS_OK;
    for (int32_t k = 0, tries = 0; k < POINTS && status == MUS_OK; tries++) {
        const int32_t t = (int32_t)((double)k / POINTS * n + tries) % n;
        const int32_t *corner = mus_body_triangles(body) + 3 * (ptrdiff_t)t;
        const double a = random_part(&random), c = a * random_part(&random), off = random_part(&random);
        const double share[3] = {1.0 - a, a - c, c}, out = OFF_LEAST + (OFF_MOST - OFF_LEAST) * off;
        double depth, p[3] = {0.0};
        for (int i = 0; i < 9; i++) {
            const ptrdiff_t at = 3 * (ptrdiff_t)corner[i / 3] + i % 3;
            p[i % 3] += share[i / 3] * (x[at] + out * normal[at]);
        }
        status = mus_body_depth(body, 1, p, &depth, NULL);
        if (fabs(depth + out) > 1e-3) continue;
        memcpy(points + 3 * (ptrdiff_t)k, p, sizeof p);
        k++, tries = 0;
    }
    return status;
}


/* Puts the points in random order. */
static void scatter(double *points)
{
    uint64_t random = 9;
    for (int32_t k = POINTS - 1; k > 0; k--) {
        const ptrdiff_t other = (ptrdiff_t)(random_part(&random) * (k + 1));
        for (int d = 0; d < 3; d++) {
            const double keep = points[3 * (ptrdiff_t)k + d];
            points[3 * (ptrdiff_t)k + d] = points[3 * other + d];
            points[3 * other + d] = keep;
        }
    }
}


/* Measures the least CPU time [s] of STEPS steps of nodes at the points, with a body or without (NULL), and the number
 * of queries in a step. */
static mus_status time_steps(bench *b, const mus_body *body, const double *points, double *seconds, int64_t *queries)
{
    mus_bare bare;
    mus_drape_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_drape_report report;
    double *mass = malloc(POINTS * sizeof *mass);
    if (mass == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < POINTS; i++) mass[i] = 1e-5;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = POINTS, bare.place = points, bare.mass = mass;
    mus_drape_def_init(&def, sizeof def);
    def.clearance = OFF_MOST; /* each node touches */
    mus_drape_report_init(&report, sizeof report);
    mus_status status = mus_cloth_create_bare(b->context, &bare, &cloth);
    if (status == MUS_OK) status = mus_drape_create(b->context, cloth, body, &def, &drape);
    *seconds = INFINITY, *queries = 0;
    for (int r = 0; r < REPEATS && status == MUS_OK; r++) {
        status = mus_drape_set_state(drape, points, NULL);
        if (status == MUS_OK) status = mus_drape_step(drape, 1, STEP);
        const double start = bench_cpu();
        if (status == MUS_OK) status = mus_drape_step(drape, STEPS, STEP);
        *seconds = fmin(*seconds, bench_cpu() - start);
    }
    if (status == MUS_OK) status = mus_drape_report_get(drape, &report);
    *queries = report.contact_queries / (REPEATS * (STEPS + 1));
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    free(mass);
    return status;
}


static int by_size(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return p < q ? -1 : p > q;
}


/* Times the tree over a body's surface at the points, and compares its distances with their depths; work (POINTS). */
static mus_status time_tree(const mus_body *body, const double *points, const double *depth, double *work, asked *out)
{
    tree t;
    if (!tree_make(mus_body_vertices(body), mus_body_triangle_count(body), mus_body_triangles(body), &t))
        return MUS_ERR_MEMORY;
    double seconds = INFINITY;
    for (int r = 0; r < REPEATS; r++) {
        t.visits = 0;
        const double start = bench_cpu();
        for (int32_t i = 0; i < POINTS; i++) work[i] = tree_distance(&t, points + 3 * (ptrdiff_t)i);
        seconds = fmin(seconds, bench_cpu() - start);
    }
    out->tree_ns = 1e9 * seconds / POINTS;
    out->visits = t.visits;
    int32_t outside = 0;
    for (int32_t i = 0; i < POINTS; i++)
        if (depth[i] < 0.0) work[outside++] = fabs(work[i] + depth[i]);
    qsort(work, (size_t)outside, sizeof *work, by_size);
    out->median = work[outside / 2];
    out->worst = work[outside - 1];
    tree_free(&t);
    return MUS_OK;
}


static void write_asked(bench *b, const asked *a)
{
    if (b->as_json) {
        json_open(&b->j, NULL, '{');
        json_text(&b->j, "case", a->name);
        json_int(&b->j, "precision", 32);
        json_int(&b->j, "threads", 1);
        json_int(&b->j, "nodes", POINTS);
        json_int(&b->j, "triangles", a->triangles);
        json_int(&b->j, "queries", a->queries);
        json_number(&b->j, "ns_per_node", a->node_ns);
        json_number(&b->j, "ns_per_depth", a->depth_ns);
        if (a->visits > 0) {
            json_int(&b->j, "tree_triangles_asked", a->visits);
            json_number(&b->j, "ns_per_tree_query", a->tree_ns);
            json_number(&b->j, "ratio_to_tree", a->tree_ns / a->node_ns);
            json_number(&b->j, "tree_median_off_m", a->median);
            json_number(&b->j, "tree_worst_off_m", a->worst);
        }
        json_close(&b->j, '}');
        return;
    }
    printf("%-22s 32 bit 1 thread  %8d nodes %7.2f ns a node  %.2f queries a node  %7.1f ns a depth  %d triangles",
           a->name, POINTS, a->node_ns, (double)a->queries / POINTS, a->depth_ns, (int)a->triangles);
    if (a->visits > 0)
        printf("  tree %.0f ns, %.1f triangles a point: %.1f x contact; %.2f mm off contact, %.2f at most", a->tree_ns,
               (double)a->visits / POINTS, a->tree_ns / a->node_ns, 1e3 * a->median, 1e3 * a->worst);
    printf("\n");
    fflush(stdout);
}


static mus_status ask_surface(bench *b, const mus_tape *tape, size_t s, double *points, double *depth, double *work)
{
    asked a = {.name = surfaces[s].name};
    mus_body_def def;
    mus_body *body = NULL;
    double with = 0.0, alone = 0.0, seconds = INFINITY;
    int64_t none;
    mus_body_def_init(&def, sizeof def);
    def.samples = surfaces[s].samples;
    def.ring_spacing = surfaces[s].ring_spacing;
    mus_status status = mus_body_create(b->context, tape, &def, &body);
    if (surfaces[s].scattered) scatter(points);
    for (int r = 0; r < REPEATS && status == MUS_OK; r++) {
        const double start = bench_cpu();
        status = mus_body_depth(body, POINTS, points, depth, NULL);
        seconds = fmin(seconds, bench_cpu() - start);
    }
    if (status == MUS_OK) status = time_steps(b, NULL, points, &alone, &none);
    if (status == MUS_OK) status = time_steps(b, body, points, &with, &a.queries);
    a.triangles = mus_body_triangle_count(body);
    a.node_ns = 1e9 * (with - alone) / (STEPS * POINTS);
    a.depth_ns = 1e9 * seconds / POINTS;
    if (status == MUS_OK && surfaces[s].tree) status = time_tree(body, points, depth, work, &a);
    if (status == MUS_OK) write_asked(b, &a);
    mus_body_destroy(body);
    return status;
}


mus_status bench_contact(bench *b)
{
    double *points = malloc(5 * POINTS * sizeof *points), *depth = points + 3 * POINTS, *work = depth + POINTS;
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_status status = points != NULL ? mus_tape_create(b->context, &tape) : MUS_ERR_MEMORY;
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(b->context, tape, NULL, &body);
    if (status == MUS_OK) status = make_points(body, points);
    mus_body_destroy(body);
    for (size_t s = 0; s < sizeof surfaces / sizeof surfaces[0] && status == MUS_OK; s++)
        status = ask_surface(b, tape, s, points, depth, work);
    mus_tape_destroy(tape);
    free(points);
    return status;
}
