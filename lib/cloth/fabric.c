/*
 * fabric.c: named fabrics, and from their moduli to spring constants.
 *
 * A square lattice of spacing a with springs k along its lines and k_d along both diagonals of each cell is the
 * membrane C11 = k + k_d, C12 = G = k_d. Second differences with alpha / a^2 along its lines and beta / (4 a^2) along
 * its diagonals bend with
 *
 *     beta = (4 B_bias - B_warp - B_weft) / 3,   alpha = B - beta / 2   along warp, weft.
 *
 * A cell of a along a line and b across it takes (the same, where a = b)
 *
 *     k_d = G (a^2 + b^2) / (2 a b),            k = C11 b / a - G a / b,
 *     bias stencils  beta / (4 a b),            along the line  (B - beta a^2 / (2 b^2)) b / a^3.
 *
 * What a lattice of central springs cannot be is clamped: k to at least FABRIC_LEAST_STRETCH of C11 (a fabric that
 * shears harder than it stretches), alpha and beta to at least 0 (a bias far from the mean of warp and weft).
 *
 * Units of the sources: stretch from KES-FB1 is C11 = 490.33 N/m / EMT (the secant at 500 gf/cm, a 5 cm long and 20 cm
 * wide piece cannot narrow); shear 1 gf/(cm deg) = 56.188 N/m; bending 1 gf cm^2/cm = 9.80665e-5 N m.
 * "assumed" in a source text marks what nobody measured for us: it stands for the class of fabric.
 */
#include <math.h>
#include <string.h>

#include "cloth/fabric.h"

#define FABRIC_LEAST_STRETCH 0.1
/* shear that a triangle of the strip has at least, of its stretch: without any, border nodes would hang on nothing */
#define FABRIC_LEAST_SHEAR 1e-3

typedef struct fabric_row {
    const char *name, *source;
    double weight, stretch[2], shear, bend[3], damping, friction, thickness;
} fabric_row;

#define FABRIC_COMMON " Bending is taken as isotropic, damping 0.1 is assumed."

/* clang-format off */
static const fabric_row fabric_table[] = {
    {"jersey",
     "Single jersey, assumed throughout as a light T-shirt knit: 0.16 kg/m2, C11 300 and 200 N/m at small strain, "
     "G 40 N/m (0.7 gf/(cm deg)), B 5e-6 N m, thickness 0.6 mm; friction 0.6: mean of cotton on chest 0.90 "
     "and forearm 0.31 (static, Temel 2022)." FABRIC_COMMON,
     0.16, {300.0, 200.0}, 40.0, {5e-6, 5e-6, 5e-6}, 0.1, 0.6, 0.6e-3},
    {"cotton",
     "Plain woven cotton: weight and thickness Penava 2014; C11 from EMT 2.29 % of a control cotton (Polymers "
     "17(15):2013, Materials 11(12):2466); B of broadcloth, Matsudaira et al. 2015 (J. Textile Eng. 61(6)); friction "
     "0.6: mean of chest 0.90 and forearm 0.31 (static, Temel 2022); G 60 N/m assumed." FABRIC_COMMON,
     0.1503, {21412.0, 21412.0}, 60.0, {11.57e-6, 11.57e-6, 11.57e-6}, 0.1, 0.6, 0.318e-3},
    {"denim",
     "Denim A of J. Textiles 2016, 4614168, table 5: thickness, B, G, and C11 from EMT 5.5 %, both ways the same; its "
     "weight column cannot be right, 0.40 kg/m2 (12 oz/yd2) and friction 0.45 are assumed." FABRIC_COMMON,
     0.40, {8915.0, 8915.0}, 122.0, {16.9e-6, 16.9e-6, 16.9e-6}, 0.1, 0.45, 1.07e-3},
    {"wool",
     "Wool suiting: weight and thickness Penava 2014; B of wool tropical, Matsudaira et al. 2015; G and C11 from the "
     "middle of the good band for men's suiting (Fan, Yu and Hunter, table 1.12: G 28-37 N/m, EM 4.3-5.1 % warp, "
     "7.5-18 % weft); friction 0.4 assumed." FABRIC_COMMON,
     0.2348, {10433.0, 3846.0}, 32.5, {6.57e-6, 6.57e-6, 6.57e-6}, 0.1, 0.4, 0.568e-3},
    {"silk",
     "Light plain silk, all assumed, so chosen that its bending length is 1.5 cm, as published drape coefficients of "
     "20-40 % ask: 0.065 kg/m2, C11 5000 N/m, G 15 N/m, B 2e-6 N m, thickness 0.15 mm, friction 0.25." FABRIC_COMMON,
     0.065, {5000.0, 5000.0}, 15.0, {2e-6, 2e-6, 2e-6}, 0.1, 0.25, 0.15e-3},
    {"polyester",
     "Woven polyester: weight and thickness Penava 2014; B of faille, Matsudaira et al. 2015; C11 8000 N/m, G 30 N/m "
     "and friction 0.3 assumed." FABRIC_COMMON,
     0.1646, {8000.0, 8000.0}, 30.0, {1.86e-6, 1.86e-6, 1.86e-6}, 0.1, 0.3, 0.252e-3},
};
/* clang-format on */

enum { FABRIC_COUNT = sizeof fabric_table / sizeof *fabric_table };


static void fabric_fill(const fabric_row *row, mus_fabric *out)
{
    out->weight = row->weight;
    memcpy(out->stretch, row->stretch, sizeof out->stretch);
    out->shear = row->shear;
    memcpy(out->bend, row->bend, sizeof out->bend);
    out->damping = row->damping;
    out->friction = row->friction;
    out->thickness = row->thickness;
}


void mus_fabric_init(mus_fabric *fabric, size_t size)
{
    if (fabric == NULL || size < sizeof fabric->size) return;
    mus_fabric own = {.size = size};
    fabric_fill(&fabric_table[0], &own);
    memset(fabric, 0, size);
    memcpy(fabric, &own, size < sizeof own ? size : sizeof own);
}


int32_t mus_fabric_count(void)
{
    return FABRIC_COUNT;
}


const char *mus_fabric_name(int32_t index)
{
    return index >= 0 && index < FABRIC_COUNT ? fabric_table[index].name : NULL;
}


const char *mus_fabric_source(int32_t index)
{
    return index >= 0 && index < FABRIC_COUNT ? fabric_table[index].source : NULL;
}


mus_status mus_fabric_find(const char *name, mus_fabric *out)
{
    if (name == NULL || out == NULL) return MUS_ERR_ARG;
    if (out->size != sizeof *out) return MUS_ERR_VERSION;
    for (int32_t i = 0; i < FABRIC_COUNT; i++)
        if (strcmp(name, fabric_table[i].name) == 0) {
            fabric_fill(&fabric_table[i], out);
            return MUS_OK;
        }
    return MUS_ERR_ARG;
}


mus_status mus__fabric_check(mus_context *context, const mus_fabric *fabric)
{
    if (fabric->size != sizeof *fabric)
        return mus__fail(context, MUS_ERR_VERSION, "fabric: size %zu, this library knows %zu; use mus_fabric_init",
                         fabric->size, sizeof *fabric);

    /* from light gauze to a coated tarpaulin, with room; steel in place of cloth is an error of units */
    const struct {
        const char *name;
        double value, least, most;
    } range[] = {
        {"weight", fabric->weight, 1e-3, 10.0},          {"warp stretch", fabric->stretch[0], 1e-3, 1e7},
        {"weft stretch", fabric->stretch[1], 1e-3, 1e7}, {"shear", fabric->shear, 0.0, 1e7},
        {"warp bend", fabric->bend[0], 0.0, 1.0},        {"weft bend", fabric->bend[1], 0.0, 1.0},
        {"bias bend", fabric->bend[2], 0.0, 1.0},        {"damping", fabric->damping, 0.0, 1.0},
        {"friction", fabric->friction, 0.0, 100.0},      {"thickness", fabric->thickness, 0.0, 0.1},
    };
    for (size_t i = 0; i < sizeof range / sizeof *range; i++)
        if (!(range[i].value >= range[i].least && range[i].value <= range[i].most))
            return mus__fail(context, MUS_ERR_ARG, "fabric %s %g is outside %g to %g", range[i].name, range[i].value,
                             range[i].least, range[i].most);
    return MUS_OK;
}


void mus__fabric_on_cell(const mus_fabric *fabric, const double *cell, mus__fabric_lattice *out)
{
    double beta = fmax(0.0, (4.0 * fabric->bend[2] - fabric->bend[0] - fabric->bend[1]) / 3.0);
    for (int k = 0; k < 2; k++) {
        /* along the line, across it */
        double a = cell[1 - k], b = cell[k], line = fabric->stretch[k] * (b / a);
        out->k[k] = fmax(line - fabric->shear * (a / b), FABRIC_LEAST_STRETCH * line);
        out->bend[k] = fmax(0.0, fabric->bend[k] - 0.5 * beta * ((a * a) / (b * b))) * (b / a) / (a * a);
    }
    out->shear = fabric->shear * ((cell[0] * cell[0] + cell[1] * cell[1]) / (2.0 * (cell[0] * cell[1])));
    out->cross = beta / (4.0 * (cell[0] * cell[1]));
    out->skip[0] = out->skip[1] = 0.0;
}


/*
 * A spring over the middle of three nodes a apart shortens by a^3 K^2 / 4 at curvature K, so its energy goes with K^4:
 * no rigidity on a flat cloth. Its moment k_b a^5 K^3 / (8 b) is the fabric's B K at one curvature only:
 *
 *     k_b = 8 B b / (a^5 K^2)
 *
 * It stretches too, as 4 k_b a / b of C11: taken from the line's spring as far as that has it.
 */
void mus__fabric_on_paper(const mus_fabric *fabric, const double *cell, double curvature, mus__fabric_lattice *out)
{
    for (int k = 0; k < 2; k++) {
        double a = cell[1 - k], b = cell[k], line = fabric->stretch[k] * (b / a), square = a * a;
        out->skip[k] = 8.0 * fabric->bend[k] * (b / a) / (square * square * curvature * curvature);
        out->k[k] = fmax(out->k[k] - 4.0 * out->skip[k], FABRIC_LEAST_STRETCH * line);
        out->bend[k] = 0.0;
    }
    out->cross = 0.0;
}


void mus__fabric_on_lattice(const mus_fabric *fabric, double spacing, mus__fabric_lattice *out)
{
    const double cell[2] = {spacing, spacing};
    mus__fabric_on_cell(fabric, cell, out);
}


/*
 * 1 / C = y^4 / k_warp + x^4 / k_weft + x^2 y^2 (1 / G - 1 / k_warp - 1 / k_weft): the law of a bias strip, with the
 * constants of the lattice, so that half a lattice cell as a triangle has just the springs of half a cell:
 * C = k along the lines and 4 G on the diagonal.
 */
double mus__fabric_stretch(const mus_fabric *fabric, double x, double y)
{
    mus__fabric_lattice lattice;
    mus__fabric_on_lattice(fabric, 1.0, &lattice);
    double shear = fmax(lattice.shear, FABRIC_LEAST_SHEAR * fmin(lattice.k[0], lattice.k[1]));
    double warp = 1.0 / lattice.k[0], weft = 1.0 / lattice.k[1], xx = x * x, yy = y * y;

    /* the sum never falls below that of the stiffest direction */
    double least = 1.0 / fmax(fmax(lattice.k[0], lattice.k[1]), 4.0 * shear);
    return 1.0 / fmax(least, yy * yy * warp + xx * xx * weft + xx * yy * (1.0 / shear - warp - weft));
}


/* the quartic through warp, weft and bias; what the lattice's stencils give for the same direction */
double mus__fabric_bend(const mus_fabric *fabric, double x, double y)
{
    double xx = x * x, yy = y * y, warp = fabric->bend[0], weft = fabric->bend[1], bias = fabric->bend[2];
    return fmax(0.0, yy * yy * warp + xx * xx * weft + xx * yy * (4.0 * bias - warp - weft));
}
