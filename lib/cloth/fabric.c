/*
 * fabric.c: from the moduli of a fabric to spring constants.
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
 * A strip that is pulled along its warp contracts by C12 / C11_weft of its strain. Where the fabric contracts more than
 * by G / C11_weft, the diagonals' share, each cell has an element of C12 - G besides (lib/sim/contraction.h).
 *
 * Values that a lattice of central springs cannot have are clamped: k to at least FABRIC_LEAST_STRETCH of C11 (a fabric
 * that shears harder than it stretches), alpha and beta to at least 0 (a bias far from the mean of warp and weft), C12
 * to what leaves a cell stable. A cloth whose values are clamped logs a warning.
 */
#include <math.h>
#include <string.h>

#include "cloth/cloth_internal.h"
#include "cloth/fabric.h"

/* least stiffness of a line spring, over C11 b / a. Chosen: a fabric with more shear than stretch has line springs */
#define FABRIC_LEAST_STRETCH 0.1
/* least shear of a triangle of the strip, over its least stretch: without shear, border nodes could move freely */
#define FABRIC_LEAST_SHEAR 1e-3
/* largest coupling of a cell, over the root of the product of its two line springs; from 1 on it would collapse.
 * Chosen: far above every woven fabric */
#define FABRIC_MOST_COUPLING 0.9


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
    out->couple = fmin(fmax(fabric->contraction * fabric->stretch[1] - fabric->shear, 0.0),
                       FABRIC_MOST_COUPLING * sqrt(out->k[0] * out->k[1]));
}


void mus__fabric_note(mus_context *context, const mus_fabric *fabric, const double *cell)
{
    static const char *const name[2] = {"warp", "weft"};
    const double *bend = fabric->bend, beta = (4.0 * bend[2] - bend[0] - bend[1]) / 3.0;
    for (int k = 0; k < 2; k++) {
        double a = cell[1 - k], b = cell[k], line = fabric->stretch[k] * (b / a);
        if (line - fabric->shear * (a / b) < FABRIC_LEAST_STRETCH * line)
            mus__log(context, MUS_LOG_WARNING, "fabric shear %g N/m is too near to %s stretch %g N/m: %s",
                     fabric->shear, name[k], fabric->stretch[k], "springs make it stiffer along it");
        if (bend[k] < 0.5 * beta * ((a * a) / (b * b)))
            mus__log(context, MUS_LOG_WARNING, "fabric bias bend %g N m is too far above %s bend %g N m: %s", bend[2],
                     name[k], bend[k], "stencils make it stiffer along it");
    }
    if (beta < 0.0)
        mus__log(context, MUS_LOG_WARNING, "fabric bias bend %g N m is below a quarter of warp and weft, %g N m: %s",
                 bend[2], 0.25 * (bend[0] + bend[1]), "stencils bend with that");
    mus__fabric_lattice lattice;
    mus__fabric_on_cell(fabric, cell, &lattice);
    const double own = (lattice.couple + fabric->shear) / fabric->stretch[1];
    if (fabric->contraction > 0.0 && fabs(own - fabric->contraction) > 1e-9)
        mus__log(context, MUS_LOG_WARNING, "fabric contraction %g is %s: the cloth contracts by %g",
                 fabric->contraction,
                 own > fabric->contraction ? "less than its shear gives" : "more than its stretch allows", own);
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
    out->cross = out->couple = 0.0;
}


void mus__fabric_couple(mus_cloth *cloth, const double *cell, const mus__fabric_lattice *constant)
{
    cloth->couple = constant->couple;
    cloth->couple_share = constant->couple > 0.0 ? constant->couple / sqrt(constant->k[0] * constant->k[1]) : 0.0;
    memcpy(cloth->cell_side, cell, sizeof cloth->cell_side);
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


double mus__rigidity_of_length(double weight, double length)
{
    return MUS__GRAVITY * weight * length * length * length;
}


/* the quartic through warp, weft and bias; what the lattice's stencils give for the same direction */
double mus__fabric_bend(const mus_fabric *fabric, double x, double y)
{
    double xx = x * x, yy = y * y, warp = fabric->bend[0], weft = fabric->bend[1], bias = fabric->bend[2];
    return fmax(0.0, yy * yy * warp + xx * xx * weft + xx * yy * (4.0 * bias - warp - weft));
}


/*
 * Friction between threads as KES-FB2 measures it: moment over curvature is a loop of two lines of slope B, 2HB apart.
 * Each bending element of stiffness k gets a slider of stiffness r k in parallel, which slips at the element's own
 * curvature K (Jenkin's element). With all of them slipping on a cylinder, elements along its curve, across it and on
 * both diagonals give r K (alpha cos^2 + alpha' sin^2 + beta), so the moment HB asks for
 *
 *     r = HB / (K (alpha + beta)),   alpha the mean of warp and weft.
 *
 * An element then has k (1 + r) while it sticks, of which r / (1 + r) ends at the slider.
 */
double mus__fabric_slide(mus_fabric *fabric)
{
    const double *bend = fabric->bend, beta = fmax(0.0, (4.0 * bend[2] - bend[0] - bend[1]) / 3.0);
    const double alpha = 0.5 * (fmax(0.0, bend[0] - 0.5 * beta) + fmax(0.0, bend[1] - 0.5 * beta));
    if (!(fabric->bend_hysteresis > 0.0) || !(alpha + beta > 0.0)) return 0.0;
    const double ratio = 0.5 * fabric->bend_hysteresis / (MUS__SLIDE_CURVATURE * (alpha + beta));
    for (int k = 0; k < 3; k++) fabric->bend[k] *= 1.0 + ratio;
    return ratio / (1.0 + ratio);
}
