/*
 * bend.c: bending of a cloth against the elastica and its relatives (cases B1-B7).
 *
 * A strip that is clamped level is half of a symmetric one held along its middle: the stencil at the clamp then bends
 * to both sides and counts double for each, which is what a clamp asks (error of order a^2, not a). Where gravity runs
 * along the strip there is no such mirror; bare nodes have the double stencil themselves.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/args.h"
#include "rest.h"

#define WEIGHT 0.15   /* [kg/m2] */
#define RIGIDITY 1e-5 /* [N m] */
#define ROD 120       /* nodes of a rod at most */

/* bending length (B / w)^(1/3) of the fabric of the cases [m] */
static double bending_length(void)
{
    return cbrt(RIGIDITY / (WEIGHT * REST_GRAVITY));
}


/* ---- B1, B2, B6: strips clamped level ---- */

/* tip of a strip of n cells and length L beside its clamp: x forward, y down; one line of nodes, mirrored */
static mus_status cantilever(verify *v, int32_t n, double length, double stretch, int32_t bending, int32_t precision,
                             double *tip)
{
    const double cell[2] = {length / n, 0.01};
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    rest_fabric(&fabric, WEIGHT, stretch, 0.0, RIGIDITY);
    def.bending = bending;
    def.coarser = 0;
    tip[0] = tip[1] = NAN;
    mus_status status = mus_cloth_create_grid(v->context, 1, 2 * n + 1, cell, &def, &cloth);
    if (status == MUS_OK)
        status = rest_hang(v, cloth, precision, 2.0 * 1.9 * sqrt(REST_GRAVITY / length), REST_GRAVITY, &drape);
    if (status == MUS_OK) status = mus_drape_pin(drape, n, 1);
    if (status == MUS_OK) status = rest_settle(v, drape, precision == 32 ? 0.0 : 1e-6, precision == 32 ? 2.0 : 8.0);
    if (status == MUS_OK) {
        const double *x = mus_drape_positions(drape) + 6 * n;
        tip[0] = (x[0] - length) / length, tip[1] = -x[1] / length;
    }
    mus_drape_destroy(drape);
    return status;
}


static void cantilevers(verify *v)
{
    static const struct {
        double gamma, x, y;
    } exact[] = {{1.0, 0.991246, 0.123471}, {10.0, 0.656354, 0.700200}, {100.0, 0.159223, 0.937524}};
    static const int32_t cells[] = {10, 20, 40, 80};
    static const double tolerance[] = {0.02, 0.006, 0.0015, 0.0005};
    char text[120];
    for (int g = 0; g < 3; g++) {
        /* the tightest bend is at the clamp, and tighter where more hangs from it */
        const double length = bending_length() * cbrt(exact[g].gamma), more = exact[g].gamma > 10.0 ? 16.0 : 1.0;
        double tip[4][2];
        mus_status status = MUS_OK;
        for (int i = g == 2 ? 1 : 0; i < 4 && status == MUS_OK; i++) {
            status = cantilever(v, cells[i], length, 10000.0, MUS_BEND_PLATE, 64, tip[i]);
            snprintf(text, sizeof text, "cantilever, w L^3/B = %g, %d cells, tip X/L", exact[g].gamma, (int)cells[i]);
            rest_row(v, status, "B1", text, exact[g].x, tip[i][0], tolerance[i] * more);
            snprintf(text, sizeof text, "cantilever, w L^3/B = %g, %d cells, tip Y/L", exact[g].gamma, (int)cells[i]);
            rest_row(v, status, "B1", text, exact[g].y, tip[i][1], tolerance[i] * more);
        }
        double single[2];
        mus_status other = cantilever(v, 20, length, 1000.0, MUS_BEND_PLATE, 32, single);
        snprintf(text, sizeof text, "the same in float, 20 cells, tip Y/L");
        rest_row(v, other, "B1", text, exact[g].y, single[1], tolerance[1] * more);
        if (status != MUS_OK) continue;
        const double order = log2((tip[1][1] - tip[2][1]) / (tip[2][1] - tip[3][1]));
        snprintf(text, sizeof text, "cantilever, w L^3/B = %g, order of 20, 40, 80 cells", exact[g].gamma);
        verify_add(v, "B1", text, 2.0, order, 0.1);
    }
}


/* the standard's board: the chord slopes 41.5 degrees when the overhang is twice the bending length */
static void board(verify *v)
{
    double tip[2];
    const mus_status status = cantilever(v, 40, 2.00035 * bending_length(), 1000.0, MUS_BEND_PLATE, 64, tip);
    rest_row(v, status, "B2", "overhang of 2.00035 bending lengths, slope of its chord [degrees]", 41.5,
             atan2(tip[1], tip[0]) * 180.0 / REST_PI, 0.005);
}


/* springs over one node, fitted at 30 /m: limper with every refinement */
static void paper_cantilevers(verify *v)
{
    static const int32_t cells[] = {10, 20, 40};
    static const double least[] = {0.3, 0.5, 0.7};
    for (int i = 0; i < (v->all ? 3 : 2); i++) {
        char text[80];
        double tip[2];
        const mus_status status =
            cantilever(v, cells[i], bending_length() * cbrt(10.0), 1000.0, MUS_BEND_PAPER, 64, tip);
        snprintf(text, sizeof text, "the paper's springs: cantilever of %d cells, tip X/L", (int)cells[i]);
        if (status == MUS_OK)
            verify_add_negative(v, "B6", text, 0.656354, tip[0], least[i]);
        else
            verify_broken(v, "B6", text, status);
    }
}


/* ---- B3, B4: rods of bare nodes ---- */

/* a rod of n cells along (x, y), clamped at its foot by a held node below and a double stencil there */
static mus_status rod(verify *v, int32_t n, double length, double dx, double dy, double stretch, double drag,
                      double gravity, mus_drape **out)
{
    const double a = length / n;
    double place[3 * ROD] = {0}, mass[ROD], lengths[ROD], stiffness[ROD], bends[ROD];
    int32_t spring[2 * ROD], bend[3 * ROD];
    const int32_t pin[2] = {0, 1};

    /* nodes 0 and 1 are held, node 1 is the foot, node n + 1 the tip with half a mass */
    for (int32_t i = 0; i < n + 2; i++) {
        place[3 * i] = a * (i - 1) * dx, place[3 * i + 1] = a * (i - 1) * dy;
        mass[i] = WEIGHT * a * (i == n + 1 ? 0.5 : 1.0);
    }
    for (int32_t i = 0; i <= n; i++) {
        spring[2 * i] = i, spring[2 * i + 1] = i + 1;
        lengths[i] = a, stiffness[i] = stretch / a;
        if (i == n) break;
        for (int k = 0; k < 3; k++) bend[3 * i + k] = i + k;
        bends[i] = RIGIDITY / (a * a * a) * (i == 0 ? 2.0 : 1.0);
    }
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = n + 2, bare.place = place, bare.mass = mass;
    bare.springs = n + 1, bare.spring = spring, bare.length = lengths, bare.stiffness = stiffness;
    bare.bends = n, bare.bend = bend, bare.bend_stiffness = bends;
    bare.pins = 2, bare.pin = pin;
    *out = NULL;
    const mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    return status == MUS_OK ? rest_hang(v, cloth, 64, drag, gravity, out) : status;
}


/* does a standing strip fall? tip's slope after 4 s, over that of the start: 1 when it grew past 3 times */
static void greenhill(verify *v)
{
    static const double part[] = {0.97, 1.03};
    const int32_t n = 30;
    for (int i = 0; i < 2; i++) {
        char text[80];
        const double length = part[i] * 1.98635 * bending_length();
        mus_drape *drape = NULL;
        double x[3 * ROD] = {0}, grown = NAN;
        mus_status status = rod(v, n, length, 0.0, 1.0, 200.0, 1.0, REST_GRAVITY, &drape);
        for (int32_t k = 0; k < n + 2 && status == MUS_OK; k++) {
            const double s = fmax(0.0, (k - 1.0) / n);
            x[3 * k] = 1e-4 * length * s * s, x[3 * k + 1] = mus_drape_positions(drape)[3 * k + 1];
        }
        if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
        const double h = status == MUS_OK ? 0.95 * mus_drape_step_bound(drape) : 1.0;
        if (status == MUS_OK) status = mus_drape_step(drape, (int32_t)(4.0 / h), h);
        if (status == MUS_OK) grown = fabs(mus_drape_positions(drape)[3 * (n + 1)]) / (1e-4 * length);
        snprintf(text, sizeof text, "standing strip of %g of Greenhill's length: falls (1) or not (0)", part[i]);
        rest_row(v, status, "B3", text, i, grown > 3.0 ? 1.0 : 0.0, 0.0);
        mus_drape_destroy(drape);
    }
}


/* mode of a clamped-free beam of length 1 */
static double beam_mode(double beta, double s)
{
    const double ratio = (cosh(beta) + cos(beta)) / (sinh(beta) + sin(beta));
    return cosh(beta * s) - cos(beta * s) - ratio * (sinh(beta * s) - sin(beta * s));
}


/* frequency of a mode of a strip of length 0.1 without gravity, from the phase after a quarter of its period */
static mus_status vibration(verify *v, int32_t n, double beta, double *exact, double *got)
{
    const double length = 0.1, omega = beta * beta / (length * length) * sqrt(RIGIDITY / WEIGHT);
    double x[3 * ROD] = {0}, phase[2] = {0.0, 0.0};
    mus_drape *drape = NULL;
    mus_status status = rod(v, n, length, 1.0, 0.0, 100.0, 0.0, 0.0, &drape);
    for (int32_t k = 0; k < n + 2 && status == MUS_OK; k++) {
        x[3 * k] = mus_drape_positions(drape)[3 * k];
        x[3 * k + 1] = k < 2 ? 0.0 : 1e-6 * beam_mode(beta, (k - 1.0) / n);
    }
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    const double quarter = 0.5 * REST_PI / omega;
    const double steps = status == MUS_OK ? ceil(quarter / (0.9 * mus_drape_step_bound(drape))) : 1.0;
    if (status == MUS_OK) status = mus_drape_step(drape, (int32_t)steps, quarter / steps);
    for (int32_t k = 2; k < n + 2 && status == MUS_OK; k++) {
        const double weight = k == n + 1 ? 0.5 : 1.0;
        phase[0] += weight * x[3 * k + 1] * mus_drape_positions(drape)[3 * k + 1];
        phase[1] -= weight * x[3 * k + 1] * mus_drape_velocities(drape)[3 * k + 1] / omega;
    }
    *exact = omega / (2.0 * REST_PI);
    *got = *exact * atan2(phase[1], phase[0]) / (0.5 * REST_PI);
    mus_drape_destroy(drape);
    return status;
}


static void vibrations(verify *v)
{
    static const double beta[] = {1.875104068711961, 4.694091132974175, 7.854757438237613};
    for (int i = 0; i < 3; i++) {
        char text[80];
        double exact = NAN, got = NAN;
        const mus_status status = vibration(v, 40, beta[i], &exact, &got);
        snprintf(text, sizeof text, "clamped strip of 40 cells without gravity, frequency %d [Hz]", i + 1);
        rest_row(v, status, "B4", text, exact, got, i == 0 ? 0.005 : 0.01);
    }
}


/* ---- B5, B7: energies of given shapes ---- */

/* energy of a grid rolled to curvature k round the axis at `angle` to the weft, nodes at equal arc length */
static mus_status rolled(verify *v, int32_t rows, int32_t columns, double cell, const mus_fabric *fabric, double k,
                         double angle, double *energy)
{
    const double cells[2] = {cell, cell}, c = cos(angle), s = sin(angle);
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def_init(&def, sizeof def);
    def.fabric = fabric;
    def.coarser = 0;
    *energy = NAN;
    double *x = calloc(3 * (size_t)rows * (size_t)columns, sizeof *x);
    mus_status status =
        x == NULL ? MUS_ERR_MEMORY : mus_cloth_create_grid(v->context, rows, columns, cells, &def, &cloth);
    if (status == MUS_OK) status = rest_hang(v, cloth, 64, 0.0, 0.0, &drape);
    for (int32_t i = 0; i < rows * columns && status == MUS_OK; i++) {
        const double u = cell * (i % columns), w = cell * (i / columns), t = u * c + w * s, z = w * c - u * s;
        const double along = sin(k * t) / k;
        x[3 * i] = along * c - z * s, x[3 * i + 1] = along * s + z * c, x[3 * i + 2] = (1.0 - cos(k * t)) / k;
    }
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    if (status == MUS_OK) *energy = rest_energy(drape);
    free(x);
    mus_drape_destroy(drape);
    return status;
}


/* bending energy of one inner cell over its area and k^2 / 2: what is left of four sizes when borders cancel */
static mus_status inner_rigidity(verify *v, double cell, const mus_fabric *fabric, double k, double angle, double *got)
{
    double e[4] = {NAN, NAN, NAN, NAN};
    mus_status status = MUS_OK;
    for (int i = 0; i < 4 && status == MUS_OK; i++)
        status = rolled(v, 5 + i % 2, 6 + i / 2, cell, fabric, k, angle, &e[i]);
    *got = (e[3] - e[2] - e[1] + e[0]) / (0.5 * k * k * cell * cell);
    return status;
}


/* nodes on a circle at equal arc length: the second difference is short by (k a)^2 / 12, its energy by twice that */
static void rings(verify *v)
{
    static const double turn[] = {0.01, 0.1, 0.5};
    mus_fabric fabric;
    rest_fabric(&fabric, WEIGHT, 1e-3, 0.0, RIGIDITY);
    for (int i = 0; i < 3; i++) {
        char text[80];
        double got = NAN;
        const double cell = 0.01, ka = turn[i], chord = 2.0 * (1.0 - cos(ka)) / (ka * ka);
        const mus_status status = inner_rigidity(v, cell, &fabric, ka / cell, 0.0, &got);
        snprintf(text, sizeof text, "rolled to curvature x cell = %g, energy over B k^2 / 2", ka);
        rest_row(v, status, "B5", text, chord * chord, got / RIGIDITY, 1e-4);
    }
}


/* rigidity along warp, weft and bias as set */
static void directions(verify *v)
{
    static const double bias[] = {0.5, 0.75, 1.0};
    static const char *const name[] = {"weft", "bias", "warp", "22.5 degrees"};
    for (int i = 0; i < 3; i++) {
        mus_fabric fabric;
        rest_fabric(&fabric, WEIGHT, 1e-3, 0.0, RIGIDITY);
        fabric.bend[0] *= 1.2, fabric.bend[1] *= 0.8, fabric.bend[2] *= bias[i];
        for (int d = 0; d < 4; d++) {
            char text[80];
            double got = NAN;
            const double angle = d == 3 ? REST_PI / 8.0 : d * REST_PI / 4.0, c2 = cos(angle) * cos(angle),
                         s2 = 1.0 - c2;
            const double exact = c2 * c2 * fabric.bend[1] + s2 * s2 * fabric.bend[0] +
                                 c2 * s2 * (4.0 * fabric.bend[2] - fabric.bend[0] - fabric.bend[1]);
            const mus_status status = inner_rigidity(v, 0.01, &fabric, 1.0, angle, &got);
            snprintf(text, sizeof text, "bias/mean = %g: rigidity along %s [N m]", bias[i], name[d]);
            rest_row(v, status, "B7", text, exact, got, 0.01);
        }
    }
}


/* two halves of a heptagon of radius 0.1, cut apart along a line 20 degrees off the weft and sewn where they lie */
static mus_status sewn_halves(verify *v, double spacing, mus_cloth **out)
{
    const int32_t forward[5] = {1, 1, 1, 1, 1},
                  corner[2][5] = {{0, 1, 2, 3, 7}, {0, 7, 4, 5, 6}};
    int32_t seam = 0, joined[2] = {0, 0};
    double xy[16];
    mus_pattern *pattern = NULL;
    mus_cloth_def def;
    mus_seam_def sew;
    for (int k = 0; k < 7; k++) {
        const double angle = 2.0 * REST_PI * k / 7.0 + REST_PI / 9.0;
        xy[2 * k] = 0.1 * cos(angle), xy[2 * k + 1] = 0.1 * sin(angle);
    }
    xy[14] = 0.5 * (xy[6] + xy[8]), xy[15] = 0.5 * (xy[7] + xy[9]);
    mus_status status = mus_pattern_create(v->context, "halves", &pattern);
    for (int half = 0; half < 2; half++) {
        int32_t panel = 0, points[5], edges[5];
        if (status == MUS_OK) status = mus_pattern_add_panel(pattern, half == 0 ? "one" : "other", &panel);
        for (int k = 0; k < 5 && status == MUS_OK; k++) {
            const double *at = xy + 2 * corner[half][k];
            status = mus_pattern_add_point(pattern, panel, at[0], at[1], &points[k]);
        }
        for (int k = 0; k < 5 && status == MUS_OK; k++)
            status = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                   .start = points[k], .end = points[(k + 1) % 5]},
                                          &edges[k]);
        if (status == MUS_OK) status = mus_pattern_set_outline(pattern, panel, 5, edges, forward);
        joined[half] = edges[half == 0 ? 4 : 0];
    }
    mus_seam_def_init(&sew, sizeof sew);
    sew.edge_a = joined[0], sew.edge_b = joined[1];
    if (status == MUS_OK) status = mus_pattern_add_seam(pattern, &sew, &seam);
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    rest_fabric(&fabric, WEIGHT, 300.0, 40.0, RIGIDITY);
    def.spacing = spacing;
    def.coarser = 0;
    if (status == MUS_OK) status = mus_cloth_create(v->context, pattern, &def, out);
    mus_pattern_destroy(pattern);
    return status;
}


/* energy over area and B k^2 / 2 of the sewn halves, rolled along four directions */
static void cut_directions(verify *v, double spacing, double tolerance)
{
    const double area = 3.5 * 0.01 * sin(2.0 * REST_PI / 7.0), k = 0.2;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_status status = sewn_halves(v, spacing, &cloth);
    if (status == MUS_OK) status = rest_hang(v, cloth, 64, 0.0, 0.0, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    if (status == MUS_OK) status = mus_drape_sew(drape, NULL, NULL);
    const int32_t n = status == MUS_OK ? mus_drape_node_count(drape) : 0;
    double *rest = malloc(3 * (size_t)n * sizeof *rest + 1), *x = malloc(3 * (size_t)n * sizeof *x + 1);
    if (rest == NULL || x == NULL) status = MUS_ERR_MEMORY;
    if (status == MUS_OK) memcpy(rest, mus_drape_positions(drape), 3 * (size_t)n * sizeof *rest);
    for (int d = 0; d < 4; d++) {
        char text[120];
        const double angle = d * REST_PI / 4.0, c = cos(angle), s = sin(angle);
        for (int32_t i = 0; i < n && status == MUS_OK; i++) {
            const double t = rest[3 * i] * c + rest[3 * i + 1] * s, w = rest[3 * i + 1] * c - rest[3 * i] * s;
            const double along = sin(k * t) / k;
            x[3 * i] = along * c - w * s, x[3 * i + 1] = along * s + w * c, x[3 * i + 2] = (1.0 - cos(k * t)) / k;
        }
        if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
        snprintf(text, sizeof text, "two cut panels sewn, at %g mm, rigidity along %d degrees [N m]", 1e3 * spacing,
                 45 * d);
        rest_row(v, status, "B7", text, RIGIDITY, rest_energy(drape) / (0.5 * k * k * area), tolerance);
    }
    free(rest);
    free(x);
    mus_drape_destroy(drape);
}


int verify_bend(verify *v)
{
    if (verify_wants(v, "B1")) cantilevers(v);
    if (verify_wants(v, "B2")) board(v);
    if (verify_wants(v, "B3")) greenhill(v);
    if (verify_wants(v, "B4")) vibrations(v);
    if (verify_wants(v, "B5")) rings(v);
    if (verify_wants(v, "B6")) paper_cantilevers(v);
    if (verify_wants(v, "B7")) {
        directions(v);
        cut_directions(v, 0.01, 0.01);
        cut_directions(v, 0.005, 0.01);
        cut_directions(v, 0.0025, 0.01);
    }
    return EXIT_DONE;
}
