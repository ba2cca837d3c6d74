/*
 * bench.c: muslin bench: speed as node evaluations a CPU second, beside the plain edge-list form of the same springs.
 *
 * The edge-list form stands here, written out: one list of springs and stencils with both ends' indices, scattered to
 * both ends, in the same precision, same flags. The ratio of the two is taken in one run.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>

#include "commands.h"
#include "json.h"
#include "scene.h"

#define REPEATS 5
#define SIDE 1.0       /* of the square of cloth [m] */
#define SPACING 0.01
#define STEPS 40


static double cpu_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


/* one square panel */
static mus_status square(mus_context *context, mus_pattern **out)
{
    static const double corner[4][2] = {{0, 0}, {SIDE, 0}, {SIDE, SIDE}, {0, SIDE}};
    int32_t panel, point[4], edge[4], forward[4] = {1, 1, 1, 1};
    const int32_t line = MUS_PIECE_LINE;
    mus_status status = mus_pattern_create(context, "square", out);
    if (status == MUS_OK) status = mus_pattern_add_panel(*out, "square", &panel);
    for (int32_t i = 0; i < 4 && status == MUS_OK; i++)
        status = mus_pattern_add_point(*out, panel, corner[i][0], corner[i][1], &point[i]);
    for (int32_t i = 0; i < 4 && status == MUS_OK; i++)
        status = mus_pattern_add_edge(*out, NULL, point[i], point[(i + 1) % 4], 1, &line, 0, NULL, &edge[i]);
    if (status == MUS_OK) status = mus_pattern_set_outline(*out, panel, 4, edge, forward);
    return status;
}


/* ---- the plain form: a square lattice of n x n nodes, springs as an edge list ---- */

typedef struct edge_list {
    int32_t n, edges, stencils;
    int32_t *edge;    /* (edges x 2) */
    int32_t *stencil; /* (stencils x 3) */
    float *k, *rest;  /* (edges) */
    float *x, *f;     /* (n x 3) */
} edge_list;


static void edge_list_free(edge_list *l)
{
    free(l->edge);
    free(l->stencil);
    free(l->k);
    free(l->rest);
    free(l->x);
    free(l->f);
}


static void add_edge(edge_list *l, int32_t a, int32_t b, float k, float rest)
{
    l->edge[2 * l->edges] = a;
    l->edge[2 * l->edges + 1] = b;
    l->k[l->edges] = k;
    l->rest[l->edges++] = rest;
}


static void add_stencil(edge_list *l, int32_t a, int32_t step)
{
    for (int32_t i = 0; i < 3; i++) l->stencil[3 * l->stencils + i] = a + i * step;
    l->stencils++;
}


static int edge_list_make(edge_list *l, int32_t side)
{
    memset(l, 0, sizeof *l);
    l->n = side * side;
    const size_t n = (size_t)l->n;
    l->edge = malloc(n * 8 * sizeof *l->edge);
    l->stencil = malloc(n * 12 * sizeof *l->stencil);
    l->k = malloc(n * 4 * sizeof *l->k);
    l->rest = malloc(n * 4 * sizeof *l->rest);
    l->x = malloc(n * 3 * sizeof *l->x);
    l->f = malloc(n * 3 * sizeof *l->f);
    if (!l->edge || !l->stencil || !l->k || !l->rest || !l->x || !l->f) return -1;
    const float a = (float)SPACING;
    for (int32_t r = 0; r < side; r++)
        for (int32_t c = 0; c < side; c++) {
            const int32_t i = r * side + c;
            const int right = c + 1 < side, up = r + 1 < side;
            l->x[3 * i] = a * (float)c, l->x[3 * i + 1] = a * (float)r, l->x[3 * i + 2] = 0.0f;
            if (right) add_edge(l, i, i + 1, 500.0f, a);
            if (up) add_edge(l, i, i + side, 500.0f, a);
            if (right && up) add_edge(l, i, i + side + 1, 40.0f, a * sqrtf(2.0f));
            if (right && up) add_edge(l, i + 1, i + side, 40.0f, a * sqrtf(2.0f));
            if (c + 2 < side) add_stencil(l, i, 1);
            if (r + 2 < side) add_stencil(l, i, side);
            if (c + 2 < side && r + 2 < side) add_stencil(l, i, side + 1);
            if (c >= 2 && r + 2 < side) add_stencil(l, i, side - 1);
        }
    return 0;
}


static void edge_list_force(edge_list *l)
{
    float *f = l->f;
    const float *x = l->x;
    memset(f, 0, (size_t)l->n * 3 * sizeof *f);
    for (int32_t e = 0; e < l->edges; e++) {
        const int32_t a = 3 * l->edge[2 * e], b = 3 * l->edge[2 * e + 1];
        const float dx = x[b] - x[a], dy = x[b + 1] - x[a + 1], dz = x[b + 2] - x[a + 2];
        const float s = l->k[e] - l->k[e] * l->rest[e] / sqrtf(dx * dx + dy * dy + dz * dz + 1e-20f);
        f[a] += s * dx, f[a + 1] += s * dy, f[a + 2] += s * dz;
        f[b] -= s * dx, f[b + 1] -= s * dy, f[b + 2] -= s * dz;
    }
    for (int32_t e = 0; e < l->stencils; e++) {
        const int32_t a = 3 * l->stencil[3 * e], b = 3 * l->stencil[3 * e + 1], c = 3 * l->stencil[3 * e + 2];
        for (int32_t d = 0; d < 3; d++) {
            const float bend = 0.1f * (x[a + d] - 2.0f * x[b + d] + x[c + d]);
            f[a + d] -= bend, f[b + d] += 2.0f * bend, f[c + d] -= bend;
        }
    }
}


/* least CPU seconds of one evaluation of the edge list */
static double time_edge_list(edge_list *l)
{
    double best = INFINITY;
    for (int32_t r = 0; r < REPEATS; r++) {
        const double start = cpu_seconds();
        for (int32_t i = 0; i < STEPS; i++) edge_list_force(l);
        best = fmin(best, (cpu_seconds() - start) / STEPS);
    }
    return best;
}


/* ---- the library's form ---- */

typedef struct row {
    const char *name;
    int32_t precision, threads, nodes;
    double seconds; /* CPU, of one force evaluation of a step's four */
} row;


/* least CPU seconds of one of the four evaluations of an RK4 step of `drape` */
static mus_status time_rk4(mus_drape *drape, double *out)
{
    const double h = 0.9 * mus_drape_step_bound(drape);
    mus_status status = mus_drape_step(drape, STEPS, h);
    *out = INFINITY;
    for (int32_t r = 0; r < REPEATS && status == MUS_OK; r++) {
        const double start = cpu_seconds();
        status = mus_drape_step(drape, STEPS, h);
        *out = fmin(*out, (cpu_seconds() - start) / (4.0 * STEPS));
    }
    return status;
}


/* one case: pattern in cloth, round a body or not */
static mus_status run_case(scene *s, const mus_pattern *pattern, const mus_body *body, row *r)
{
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = SPACING;
    cut.fabric.damping = 0.0;
    mus_drape_def_init(&def, sizeof def);
    def.precision = r->precision;
    def.threads = r->threads;
    mus_status status = mus_cloth_create(s->context, pattern, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(s->context, cloth, body, &def, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    if (status == MUS_OK) status = time_rk4(drape, &r->seconds);
    r->nodes = mus_cloth_node_count(cloth);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return status;
}


static void write_row(const row *r, double edge_seconds_a_node, bool as_json, json *j)
{
    const double rate = r->nodes / r->seconds, ratio = edge_seconds_a_node * rate;
    if (!as_json) {
        printf("%-22s %2d bit  %d thread%s %8d nodes %8.2f M node evaluations/CPU s  %5.2f x edge list\n", r->name,
               (int)r->precision, (int)r->threads, r->threads == 1 ? " " : "s", (int)r->nodes, 1e-6 * rate, ratio);
        return;
    }
    json_open(j, NULL, '{');
    json_text(j, "case", r->name);
    json_int(j, "precision", r->precision);
    json_int(j, "threads", r->threads);
    json_int(j, "nodes", r->nodes);
    json_number(j, "node_evaluations_per_cpu_s", rate);
    json_number(j, "ratio_to_edge_list", ratio);
    json_close(j, '}');
}


static int run_all(scene *s, bool as_json, json *j)
{
    mus_pattern *sheet = NULL, *tshirt = NULL;
    mus_body *body = NULL;
    edge_list plain;
    if (edge_list_make(&plain, 100) != 0) return complain(EXIT_FAILED, "bench", "no memory");
    const double edge_seconds = time_edge_list(&plain) / plain.n;
    mus_status status = square(s->context, &sheet);
    if (status == MUS_OK) status = mus_tape_create(s->context, &s->tape);
    if (status == MUS_OK) status = mus_tape_set_size(s->tape, "W40");
    if (status == MUS_OK) status = mus_body_create(s->context, s->tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(s->context, mus_design_find("tshirt"), s->tape, NULL, &tshirt);

    const struct {
        const char *name;
        const mus_pattern *pattern;
        const mus_body *body;
        int32_t precision, threads;
    } cases[] = {
        {"lattice_rk4", sheet, NULL, 32, 1},         {"lattice_rk4", sheet, NULL, 64, 1},
        {"lattice_rk4_contact", sheet, body, 32, 1}, {"lattice_rk4_contact", sheet, body, 64, 1},
        {"tshirt_rk4", tshirt, body, 32, 1},         {"tshirt_rk4", tshirt, body, 64, 1},
        {"tshirt_rk4", tshirt, body, 32, 2},
    };
    for (size_t c = 0; c < sizeof cases / sizeof cases[0] && status == MUS_OK; c++) {
        row r = {cases[c].name, cases[c].precision, cases[c].threads, 0, 0.0};
        status = run_case(s, cases[c].pattern, cases[c].body, &r);
        if (status == MUS_OK) write_row(&r, edge_seconds, as_json, j);
    }
    edge_list_free(&plain);
    mus_pattern_destroy(sheet);
    mus_pattern_destroy(tshirt);
    mus_body_destroy(body);
    return status == MUS_OK ? EXIT_DONE : scene_fail(s, status);
}


int command_bench(int argc, char **argv)
{
    bool as_json = false;
    const option options[] = {{"--json", OPTION_STDOUT, &as_json, 0, 0, "as JSON"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("bench", "Speed table: node evaluations a CPU second.", options, argc, argv)) return EXIT_INPUT;

    scene s;
    json j = {0};
    struct utsname machine;
    int code = scene_open(&s, "bench");
    json_open(&j, NULL, '{');
    json_text(&j, "machine", uname(&machine) == 0 ? machine.machine : "unknown");
    json_open(&j, "rows", '[');
    if (code == EXIT_DONE) code = run_all(&s, as_json, &j);
    json_close(&j, ']');
    json_close(&j, '}');
    if (code == EXIT_DONE && as_json && !json_write(&j, "bench", "-")) code = EXIT_FAILED;
    json_free(&j);
    scene_close(&s);
    return code;
}
