/*
 * cloth.c: springs, shear and membrane of a cloth against the moduli of its fabric (cases M1-M8).
 *
 * Patches are energies of a drape without gravity whose nodes are set to a uniform strain; the mean over +e and -e has
 * no cubic part. Frequencies come from the phase of a mode after a quarter of its period.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/args.h"
#include "rest.h"

#define SMALL 1e-5 /* strain of a patch: rounding and curvature of the law are both near 1e-10 there */
#define LINKS 200  /* most springs of a chain */


/* a drape of a grid in the fabric */
static mus_status grid(verify *v, int32_t rows, int32_t columns, double x, double y, const mus_fabric *fabric,
                       double drag, double gravity, mus_drape **out)
{
    const double cell[2] = {x, y};
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_cloth_def_init(&def, sizeof def);
    def.fabric = fabric;
    def.coarser = 0;
    *out = NULL;
    const mus_status status = mus_cloth_create_grid(v->context, rows, columns, cell, &def, &cloth);
    return status == MUS_OK ? rest_hang(v, cloth, 64, drag, gravity, out) : status;
}


/* ---- M1 ---- */

/* sag of a strip of length 1 that hangs from its last row; float feels a hundred times the gravity, for its digits */
static mus_status hang_strip(verify *v, int32_t cells, int32_t columns, int32_t precision, double *sag)
{
    const double cell[2] = {0.01, 1.0 / cells}, gravity = REST_GRAVITY * (precision == 32 ? 100.0 : 1.0);
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    rest_fabric(&fabric, 0.15, 1000.0, 0.0, 0.0);
    def.coarser = 0;
    mus_status status = mus_cloth_create_grid(v->context, cells + 1, columns, cell, &def, &cloth);
    if (status == MUS_OK) status = rest_hang(v, cloth, precision, 250.0, gravity, &drape);
    for (int32_t c = 0; c < columns && status == MUS_OK; c++) status = mus_drape_pin(drape, cells * columns + c, 1);
    if (status == MUS_OK) status = rest_settle(v, drape, precision == 32 ? 0.0 : 1e-11, precision == 32 ? 0.5 : 3.0);
    if (status == MUS_OK) *sag = -mus_drape_positions(drape)[1];
    mus_drape_destroy(drape);
    return status;
}


static void strips(verify *v)
{
    static const int32_t cells[] = {4, 16, 64}, columns[] = {1, 2, 5};
    for (int i = 0; i < 3; i++) {
        char text[120];
        double sag = NAN;
        mus_status status = hang_strip(v, cells[i], columns[i], 64, &sag);
        snprintf(text, sizeof text, "hanging strip of %d x %d nodes, sag [m]", (int)cells[i] + 1, (int)columns[i]);
        rest_row(v, status, "M1", text, 0.15 * REST_GRAVITY / 2000.0, sag, 1e-9);
        status = hang_strip(v, cells[i], columns[i], 32, &sag);
        snprintf(text, sizeof text, "the same in float, gravity x 100, sag [m]");
        rest_row(v, status, "M1", text, 15.0 * REST_GRAVITY / 2000.0, sag, 1e-5);
    }
}


/* ---- M2, M3: patches ---- */

/* energy over area and e^2 / 2 of x -> (1 + e strain) x, both signs; strain: xx, yy, xy, yx */
static mus_status patch(mus_drape *drape, const double *rest, double area, const double *strain, double *modulus)
{
    const int32_t n = mus_drape_node_count(drape);
    double *x = calloc(3 * (size_t)n, sizeof *x), sum = 0.0;
    if (x == NULL) return MUS_ERR_MEMORY;
    mus_status status = MUS_OK;
    for (int side = -1; side <= 1 && status == MUS_OK; side += 2) {
        for (int32_t i = 0; i < n; i++) {
            const double a = rest[3 * i], b = rest[3 * i + 1], e = side * SMALL;
            x[3 * i] = a + e * (strain[0] * a + strain[2] * b);
            x[3 * i + 1] = b + e * (strain[3] * a + strain[1] * b);
            x[3 * i + 2] = rest[3 * i + 2];
        }
        status = mus_drape_set_state(drape, x, NULL);
        sum += rest_energy(drape);
    }
    free(x);
    *modulus = sum / (area * SMALL * SMALL);
    return status;
}


/* C11 along weft, C22 along warp, C12, G of a drape that lies flat at rest */
static mus_status moduli(mus_drape *drape, double area, double *c)
{
    static const double weft[4] = {1, 0, 0, 0}, warp[4] = {0, 1, 0, 0}, both[4] = {1, 1, 0, 0};
    static const double shear[4] = {0, 0, 0.5, 0.5};
    const int32_t n = mus_drape_node_count(drape);
    double *rest = malloc(3 * (size_t)n * sizeof *rest), all = 0.0;
    if (rest == NULL) return MUS_ERR_MEMORY;
    memcpy(rest, mus_drape_positions(drape), 3 * (size_t)n * sizeof *rest);
    mus_status status = patch(drape, rest, area, weft, &c[0]);
    if (status == MUS_OK) status = patch(drape, rest, area, warp, &c[1]);
    if (status == MUS_OK) status = patch(drape, rest, area, both, &all);
    if (status == MUS_OK) status = patch(drape, rest, area, shear, &c[3]);
    c[2] = 0.5 * (all - c[0] - c[1]);
    free(rest);
    return status;
}


static void square_patches(verify *v)
{
    static const double ratio[] = {0.0, 0.05, 0.5};
    for (int i = 0; i < 3; i++) {
        char text[120];
        double c[4] = {NAN, NAN, NAN, NAN};
        const double shear = ratio[i] * 1000.0, c11 = 1000.0 + shear;
        mus_fabric fabric;
        mus_drape *drape = NULL;
        rest_fabric(&fabric, 0.15, c11, shear, 1e-5);
        mus_status status = grid(v, 9, 13, 0.01, 0.01, &fabric, 0.0, 0.0, &drape);
        if (status == MUS_OK) status = moduli(drape, 0.08 * 0.12, c);
        snprintf(text, sizeof text, "grid, shear/stretch = %g, C11 [N/m]", ratio[i]);
        rest_row(v, status, "M2", text, c11, c[0], 1e-10);
        snprintf(text, sizeof text, "grid, shear/stretch = %g, Poisson's ratio C12/C11", ratio[i]);
        if (ratio[i] > 0.0) rest_row(v, status, "M2", text, shear / c11, c[2] / c[0], 1e-10);
        snprintf(text, sizeof text, "grid, shear/stretch = %g, modulus C11 (1 - nu^2) [N/m]", ratio[i]);
        rest_row(v, status, "M2", text, c11 - shear * shear / c11, c[0] - c[2] * c[2] / c[0], 1e-10);
        snprintf(text, sizeof text, "grid, shear/stretch = %g, G [N/m]", ratio[i]);
        if (ratio[i] > 0.0) rest_row(v, status, "M3", text, shear, c[3], 1e-10);
        mus_drape_destroy(drape);
    }
}


static void oblong_patch(verify *v)
{
    double c[4] = {NAN, NAN, NAN, NAN};
    mus_fabric fabric;
    mus_drape *drape = NULL;
    rest_fabric(&fabric, 0.15, 900.0, 40.0, 1e-5);
    fabric.stretch[1] = 500.0;
    mus_status status = grid(v, 7, 10, 0.012, 0.007, &fabric, 0.0, 0.0, &drape);
    if (status == MUS_OK) status = moduli(drape, 9 * 0.012 * 6 * 0.007, c);
    rest_row(v, status, "M2", "grid of 12 x 7 mm cells, C11 of the warp [N/m]", 900.0, c[1], 1e-10);
    rest_row(v, status, "M2", "grid of 12 x 7 mm cells, C11 of the weft [N/m]", 500.0, c[0], 1e-10);
    rest_row(v, status, "M3", "grid of 12 x 7 mm cells, G [N/m]", 40.0, c[3], 1e-10);
    mus_drape_destroy(drape);
}


/* moduli of a cut panel whose border fits no lattice: a heptagon, warp 20 degrees off */
static mus_status heptagon(verify *v, double spacing, double stretch, double shear, double *c)
{
    double corner[14];
    const double tilt = 20.0 * REST_PI / 180.0, area = 3.5 * 0.01 * sin(2.0 * REST_PI / 7.0);
    for (int k = 0; k < 7; k++) {
        corner[2 * k] = 0.1 * cos(2.0 * REST_PI * k / 7.0 + tilt);
        corner[2 * k + 1] = 0.1 * sin(2.0 * REST_PI * k / 7.0 + tilt);
    }
    mus_fabric fabric;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    rest_fabric(&fabric, 0.15, stretch, shear, 1e-5);
    mus_status status = rest_panel(v, 7, corner, 0.0, 1.0, spacing, &fabric, &cloth);
    if (status == MUS_OK) status = rest_hang(v, cloth, 64, 0.0, 0.0, &drape);
    if (status == MUS_OK) status = moduli(drape, area, c);
    mus_drape_destroy(drape);
    return status;
}


static void panel_patches(verify *v)
{
    static const double spacing[] = {0.01, 0.005};
    char text[120];
    double c[4] = {NAN, NAN, NAN, NAN};
    static const char *const name[] = {"C11 of the weft", "C11 of the warp", NULL, "G"};
    for (int i = 0; i < 2; i++) {
        const mus_status status = heptagon(v, spacing[i], 300.0, 75.0, c);
        for (int k = 0; k < 4; k++) {
            if (name[k] == NULL) continue;
            snprintf(text, sizeof text, "cut heptagon at %g mm, %s [N/m]", 1e3 * spacing[i], name[k]);
            rest_row(v, status, k < 3 ? "M2" : "M3", text, k < 3 ? 300.0 : 75.0, c[k], k < 3 ? 0.03 : 0.07);
        }
    }

    /* springs along slanting edges are no woven cloth: too soft along the threads or too stiff in shear */
    const mus_status status = heptagon(v, 0.01, 5000.0, 40.0, c);
    if (status == MUS_OK) {
        verify_add_negative(v, "M2", "cut heptagon of woven cloth at 10 mm, C11 of the weft [N/m]", 5000.0, c[0], 0.1);
        verify_add_negative(v, "M3", "cut heptagon of woven cloth at 10 mm, G [N/m]", 40.0, c[3], 0.1);
    } else {
        verify_broken(v, "M2", "cut heptagon of woven cloth", status);
    }
}


/* a shear frame: lines turn and keep their length, diagonals carry all */
static void shear_frame(verify *v, double x, double y)
{
    char text[120];
    const int32_t rows = 5, columns = 6;
    const double angle = 8.0 * REST_PI / 180.0, shear = 40.0, kd = shear * (x * x + y * y) / (2.0 * x * y);
    mus_fabric fabric;
    mus_drape *drape = NULL;
    rest_fabric(&fabric, 0.15, 900.0, shear, 0.0);
    mus_status status = grid(v, rows, columns, x, y, &fabric, 0.0, 0.0, &drape);
    double at[3 * 30] = {0};
    for (int32_t i = 0; i < 30; i++) {
        const double a = i % columns * x, b = i / columns * y;
        at[3 * i] = a + b * sin(angle), at[3 * i + 1] = b * cos(angle);
    }
    if (status == MUS_OK) status = mus_drape_set_state(drape, at, NULL);
    const double rest = sqrt(x * x + y * y), more = sqrt(x * x + y * y + 2.0 * x * y * sin(angle)) - rest;
    const double less = sqrt(x * x + y * y - 2.0 * x * y * sin(angle)) - rest;
    snprintf(text, sizeof text, "shear frame of %g x %g mm cells at 8 degrees, energy [J]", 1e3 * x, 1e3 * y);
    rest_row(v, status, "M3", text, 0.5 * kd * (more * more + less * less) * (rows - 1) * (columns - 1),
             rest_energy(drape), 1e-9);
    mus_drape_destroy(drape);
}


/* ---- M4 ---- */

/* mean of y - rest over the nodes within 5 mm of height y, and of their rest */
static double mean_move(const mus_drape *drape, const double *rest, double y, double *at)
{
    double move = 0.0, count = 0.0;
    *at = 0.0;
    for (int32_t i = 0; i < mus_drape_node_count(drape); i++) {
        if (fabs(rest[2 * i + 1] - y) > 0.005) continue;
        move += mus_drape_positions(drape)[3 * i + 1] - rest[2 * i + 1];
        *at += rest[2 * i + 1];
        count++;
    }
    *at /= count;
    return move / count;
}


/*
 * E45 of a bias strip of length 0.5, cut as a panel: both ends held 0.1 % further apart. The force is that of the
 * energy; the strain is taken in the middle, since the ends, which cannot narrow, are stiffer over a width. The border
 * is a seventh too stiff over a spacing: the lattice ends there in triangles.
 */
static mus_status bias_strip(verify *v, double spacing, double width, double *modulus)
{
    const double length = 0.5, corner[] = {0, 0, width, 0, width, length, 0, length};
    const double strain = 1e-3;
    mus_fabric fabric;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    double *x = NULL, *rest = NULL;
    rest_fabric(&fabric, 0.15, 5000.0, 40.0, 0.0);
    mus_status status = rest_panel(v, 4, corner, 1.0, 1.0, spacing, &fabric, &cloth);
    if (status == MUS_OK) {
        const size_t bytes = 2 * (size_t)mus_cloth_node_count(cloth) * sizeof *rest;
        rest = malloc(bytes);
        if (rest != NULL) memcpy(rest, mus_cloth_rest(cloth), bytes);
        status = rest_hang(v, cloth, 64, 800.0, 0.0, &drape);
    }
    if (status == MUS_OK) {
        const int32_t n = mus_drape_node_count(drape);
        x = malloc(3 * (size_t)n * sizeof *x);
        if (x == NULL || rest == NULL) status = MUS_ERR_MEMORY;
        for (int32_t i = 0; i < n && status == MUS_OK; i++) {
            memcpy(x + 3 * i, mus_drape_positions(drape) + 3 * i, 3 * sizeof *x);
            const bool end = x[3 * i + 1] < 1e-9 || x[3 * i + 1] > length - 1e-9;
            x[3 * i + 1] *= 1.0 + strain;
            if (end) status = mus_drape_pin(drape, i, 1);
        }
    }
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    if (status == MUS_OK) status = rest_settle(v, drape, 1e-8, 1.0);
    if (status == MUS_OK) {
        double low, high;
        const double move = mean_move(drape, rest, 0.3, &high) - mean_move(drape, rest, 0.2, &low);
        *modulus = 2.0 * rest_energy(drape) / (strain * length * width) / (move / (high - low));
    }
    free(x);
    free(rest);
    mus_drape_destroy(drape);
    return status;
}


static void bias_strips(verify *v)
{
    static const double spacing[] = {0.005, 0.0025}, tolerance[] = {0.025, 0.01}, width = 0.08;
    for (int i = 0; i < 2; i++) {
        char text[120];
        double modulus = NAN;
        const mus_status status = bias_strip(v, spacing[i], width, &modulus);
        snprintf(text, sizeof text, "cut bias strip, %g mm wide at %g mm, E45 [N/m]", 1e3 * width, 1e3 * spacing[i]);
        rest_row(v, status, "M4", text, 1.0 / (0.5 / 5040.0 + 0.25 / 40.0), modulus, tolerance[i]);
    }
}


/* ---- M5 ---- */

/* a parallelogram of n x n cells of two equilateral triangles each, border springs half: energy under a strain is that
 * of the area to the last spring. c: C11, C22, C12, G */
static mus_status triangles(verify *v, int32_t n, double k, double *c)
{
    enum { MOST = 8 };
    const double side = 0.01;
    double place[3 * MOST * MOST], mass[MOST * MOST], length[3 * MOST * MOST], stiffness[3 * MOST * MOST];
    int32_t spring[6 * MOST * MOST], count = 0;
    for (int32_t r = 0; r <= n; r++)
        for (int32_t q = 0; q <= n; q++) {
            const int32_t i = r * (n + 1) + q;
            const bool ends[3] = {q < n, r<n, q> 0 && r < n};
            const int32_t to[3] = {i + 1, i + n + 1, i + n};
            const bool border[3] = {r == 0 || r == n, q == 0 || q == n, false};
            place[3 * i] = side * (q + 0.5 * r), place[3 * i + 1] = side * sqrt(0.75) * r, place[3 * i + 2] = 0.0;
            mass[i] = 1e-3;
            for (int s = 0; s < 3; s++) {
                if (!ends[s]) continue;
                spring[2 * count] = i, spring[2 * count + 1] = to[s];
                length[count] = side, stiffness[count++] = border[s] ? 0.5 * k : k;
            }
        }
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = (n + 1) * (n + 1), bare.place = place, bare.mass = mass;
    bare.springs = count, bare.spring = spring, bare.length = length, bare.stiffness = stiffness;
    mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    if (status == MUS_OK) status = rest_hang(v, cloth, 64, 0.0, 0.0, &drape);
    if (status == MUS_OK) status = moduli(drape, n * n * side * side * sqrt(0.75), c);
    mus_drape_destroy(drape);
    return status;
}


static void equilateral(verify *v)
{
    const double k = 100.0;
    double c[4] = {NAN, NAN, NAN, NAN};
    const mus_status status = triangles(v, 7, k, c);
    rest_row(v, status, "M5", "equilateral triangles, modulus 2 k / sqrt(3) [N/m]", 2.0 * k / sqrt(3.0),
             c[0] - c[2] * c[2] / c[0], 1e-10);
    rest_row(v, status, "M5", "equilateral triangles, Poisson's ratio", 1.0 / 3.0, c[2] / c[0], 1e-10);
    rest_row(v, status, "M5", "equilateral triangles, G = sqrt(3) / 4 k [N/m]", sqrt(3.0) / 4.0 * k, c[3], 1e-10);
}


/* ---- M6 ---- */

/* frequency of mode p, q of a square membrane of n x n cells, 1 m and 0.15 kg/m2 as it is stretched, under 10 N/m */
static mus_status membrane(verify *v, int32_t n, int32_t p, int32_t q, double *exact, double *got)
{
    const double side = 1.0, tension = 10.0, strain = 0.01, cell = side / n / (1.0 + strain);
    const double mass = 0.15 * side * side / n / n, sp = sin(p * REST_PI / (2.0 * n)),
                 sq = sin(q * REST_PI / (2.0 * n));
    const double omega = sqrt(4.0 * tension / mass * (sp * sp + sq * sq));
    const int32_t nodes = (n + 1) * (n + 1);
    mus_fabric fabric;
    mus_drape *drape = NULL;
    double *x = calloc(3 * (size_t)nodes, sizeof *x), phase[2] = {0.0, 0.0};
    rest_fabric(&fabric, mass / (cell * cell), tension * (1.0 + strain) / strain, 0.0, 0.0);
    mus_status status = x == NULL ? MUS_ERR_MEMORY : grid(v, n + 1, n + 1, cell, cell, &fabric, 0.0, 0.0, &drape);
    for (int32_t i = 0; i < nodes && status == MUS_OK; i++) {
        const int32_t r = i / (n + 1), c = i % (n + 1);
        x[3 * i] = c * side / n, x[3 * i + 1] = r * side / n;
        x[3 * i + 2] = 1e-6 * sin(p * REST_PI * r / n) * sin(q * REST_PI * c / n);
        if (r == 0 || r == n || c == 0 || c == n) status = mus_drape_pin(drape, i, 1);
    }
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    const int32_t steps = 20000;
    if (status == MUS_OK) status = mus_drape_step(drape, steps, 0.5 * REST_PI / omega / steps);
    for (int32_t i = 0; i < nodes && status == MUS_OK; i++) {
        phase[0] += x[3 * i + 2] * mus_drape_positions(drape)[3 * i + 2];
        phase[1] -= x[3 * i + 2] * mus_drape_velocities(drape)[3 * i + 2] / omega;
    }
    *exact = omega / (2.0 * REST_PI);
    *got = *exact * atan2(phase[1], phase[0]) / (0.5 * REST_PI);
    free(x);
    mus_drape_destroy(drape);
    return status;
}


static void membranes(verify *v)
{
    static const int32_t table[3][3] = {{10, 1, 1}, {20, 1, 1}, {10, 2, 3}};
    for (int i = 0; i < 3; i++) {
        char text[120];
        double exact = NAN, got = NAN;
        const int32_t *row = table[i];
        const mus_status status = membrane(v, row[0], row[1], row[2], &exact, &got);
        snprintf(text, sizeof text, "square membrane of %d cells, frequency %d%d [Hz]", (int)row[0], (int)row[1],
                 (int)row[2]);
        rest_row(v, status, "M6", text, exact, got, 1e-6);
    }
}


/* ---- M7, M8: chains ---- */

/* LINKS springs (or fewer) of bare nodes along `place` (n + 1, x 3), rest lengths of `link`; the ends carry half */
static mus_status chain(verify *v, int32_t n, const double *place, double link, double stiffness, double mass,
                        bool both, double drag, mus_drape **out)
{
    double masses[LINKS + 1], lengths[LINKS], k[LINKS];
    int32_t spring[2 * LINKS];
    const int32_t pin[2] = {0, n};
    for (int32_t i = 0; i <= n; i++) masses[i] = i == 0 || i == n ? 0.5 * mass : mass;
    for (int32_t i = 0; i < n; i++) {
        spring[2 * i] = i, spring[2 * i + 1] = i + 1;
        lengths[i] = link, k[i] = stiffness;
    }
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = n + 1, bare.place = place, bare.mass = masses;
    bare.springs = n, bare.spring = spring, bare.length = lengths, bare.stiffness = k;
    bare.pins = both ? 2 : 1, bare.pin = pin;
    *out = NULL;
    const mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    return status == MUS_OK ? rest_hang(v, cloth, 64, drag, REST_GRAVITY, out) : status;
}


/* span 1, length 1.2, w = 1 N/m: the catenary of parameter 0.469542 m */
static void catenary(verify *v)
{
    enum { N = 50 };
    const double length = 1.2, link = length / N, stiffness = 1e5 / link, mass = link / REST_GRAVITY;
    double place[3 * (N + 1)] = {0}, sag = NAN, mid = NAN, end = NAN;
    mus_drape *drape = NULL;
    for (int32_t i = 0; i <= N; i++) {
        const double s = length * i / N - 0.5 * length, a = 0.469542;
        place[3 * i] = i == 0 ? 0.0 : i == N ? 1.0 : 0.5 + a * asinh(s / a);
        place[3 * i + 1] = sqrt(a * a + s * s) - sqrt(a * a + 0.25 * length * length);
    }
    mus_status status = chain(v, N, place, link, stiffness, mass, true, 8.0, &drape);
    if (status == MUS_OK) status = rest_settle(v, drape, 1e-8, 20.0);
    if (status == MUS_OK) {
        /* tension at a node that hangs between two: of the first spring, with the half weight beyond it */
        const double *x = mus_drape_positions(drape), *a = x + 3 * (N / 2), *b = a + 3;
        sag = -a[1];
        mid = stiffness * (hypot(b[0] - a[0], b[1] - a[1]) - link) * (b[0] - a[0]) / hypot(b[0] - a[0], b[1] - a[1]);
        const double l = hypot(x[3], x[4]), pull = stiffness * (l - link);
        end = hypot(pull * x[3] / l, pull * -x[4] / l + 0.5 * mass * REST_GRAVITY);
    }
    rest_row(v, status, "M7", "catenary of span 1, length 1.2 m, sag [m]", 0.292344, sag, 1e-3);
    rest_row(v, status, "M7", "catenary of 1 N/m, tension in the middle [N]", 0.469542, mid, 1e-3);
    rest_row(v, status, "M7", "catenary of 1 N/m, tension at the end [N]", 0.761886, end, 1e-3);
    mus_drape_destroy(drape);
}


/* Bessel's J0 by its series */
static double bessel(double x)
{
    double sum = 1.0, term = 1.0;
    for (int k = 1; k < 60; k++) {
        term *= -0.25 * x * x / ((double)k * k);
        sum += term;
    }
    return sum;
}


/* mode n of a hanging chain of length 1: J0(j sqrt(height)), from the phase after a quarter of its period */
static mus_status swing(verify *v, double root, double *got)
{
    const int32_t n = LINKS;
    const double link = 1.0 / n, mass = 0.15 * link, stiffness = 2e4 / link;
    const double omega = 0.5 * root * sqrt(REST_GRAVITY);
    double place[3 * (LINKS + 1)] = {0}, x[3 * (LINKS + 1)], phase[2] = {0.0, 0.0};
    mus_drape *drape = NULL;

    /* stretched by the weight below: at rest before it swings */
    for (int32_t i = 1; i <= n; i++)
        place[3 * i + 1] = place[3 * i - 2] - link - mass * REST_GRAVITY * (n - i + 0.5) / stiffness;
    mus_status status = chain(v, n, place, link, stiffness, mass, false, 0.0, &drape);
    memcpy(x, place, sizeof x);
    for (int32_t i = 0; i <= n; i++) x[3 * i] = 1e-6 * bessel(root * sqrt((double)(n - i) / n));
    x[0] = 0.0;
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    const double quarter = 0.5 * REST_PI / omega;
    const double steps = status == MUS_OK ? ceil(quarter / (0.9 * mus_drape_step_bound(drape))) : 1.0;
    if (status == MUS_OK) status = mus_drape_step(drape, (int32_t)steps, quarter / steps);
    for (int32_t i = 1; i <= n && status == MUS_OK; i++) {
        const double weight = i == n ? 0.5 : 1.0;
        phase[0] += weight * x[3 * i] * mus_drape_positions(drape)[3 * i];
        phase[1] -= weight * x[3 * i] * mus_drape_velocities(drape)[3 * i] / omega;
    }
    *got = omega * atan2(phase[1], phase[0]) / (0.5 * REST_PI);
    mus_drape_destroy(drape);
    return status;
}


static void swings(verify *v)
{
    static const double root[] = {2.404825557695773, 5.520078110286311, 8.653727912911013};
    for (int i = 0; i < 3; i++) {
        char text[120];
        double got = NAN;
        const mus_status status = swing(v, root[i], &got);
        snprintf(text, sizeof text, "hanging chain of %d links, frequency %d [rad/s]", (int)LINKS, i + 1);
        rest_row(v, status, "M8", text, 0.5 * root[i] * sqrt(REST_GRAVITY), got, 1e-3);
    }
}


int verify_cloth(verify *v)
{
    if (verify_wants(v, "M1")) strips(v);
    const bool stretch = verify_wants(v, "M2"), shear = verify_wants(v, "M3");
    if (stretch || shear) {
        square_patches(v);
        oblong_patch(v);
        panel_patches(v);
    }
    if (shear) {
        shear_frame(v, 0.01, 0.01);
        shear_frame(v, 0.012, 0.007);
    }
    if (verify_wants(v, "M4")) bias_strips(v);
    if (verify_wants(v, "M5")) equilateral(v);
    if (verify_wants(v, "M6")) membranes(v);
    if (verify_wants(v, "M7")) catenary(v);
    if (verify_wants(v, "M8")) swings(v);
    return EXIT_DONE;
}
