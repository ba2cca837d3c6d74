/*
 * fabric.h: from a measured fabric to the constants of springs and bending stencils.
 */
#ifndef MUS_CLOTH_FABRIC_H
#define MUS_CLOTH_FABRIC_H

#include <stddef.h>

#include "base/base_internal.h"
#include "muslin/cloth.h"

/* size of a mus_fabric before bend_hysteresis was appended, which is 0 in it */
#define MUS__FABRIC_FIRST offsetof(mus_fabric, bend_hysteresis)

/* [m/s2] standard gravity, rounded: of the default drape, of weights where a drape has none, of bending lengths */
#define MUS__GRAVITY 9.81

/* [1/m] curvature at which the slider of a bending element slips, all of them at twice of it. Chosen: well below 50 /m,
 * from where KES-FB2 reads B and 2HB; a larger value makes the cloth softer near flat. tests/study/fabric/slider.py
 * compiles with others */
#ifndef MUS__SLIDE_CURVATURE
#define MUS__SLIDE_CURVATURE 5.0
#endif

/* constants of a lattice: springs along warp (0) and weft (1), diagonals, stencils likewise */
typedef struct mus__fabric_lattice {
    double k[2], shear;    /* [N/m] */
    double bend[2], cross; /* of |x_a - 2 x_b + x_c|^2 / 2 along warp, weft, both diagonals [N/m] */
    double skip[2];        /* the paper's springs over one node, in place of bend and cross [N/m] */
    double couple;         /* C12 of a cell beyond that of its diagonals, 0: none [N/m] */
} mus__fabric_lattice;

/* of cells cell[0] along the weft by cell[1] along the warp; and of square ones */
void mus__fabric_on_cell(const mus_fabric *fabric, const double *cell, mus__fabric_lattice *out);
/* one warning for each value that such a lattice cannot have and clamps */
void mus__fabric_note(mus_context *context, const mus_fabric *fabric, const double *cell);
/* [N m] of a bending length [m], which is the third root of rigidity over weight (Peirce 1930); weight [kg/m2] */
double mus__rigidity_of_length(double weight, double length);
/* turn the constants of a cell to the paper's bending, which stands for the fabric's at `curvature` */
void mus__fabric_on_paper(const mus_fabric *fabric, const double *cell, double curvature, mus__fabric_lattice *out);
/* write what the cells of a cloth couple, and their sides, to its members couple, couple_share and cell_side */
void mus__fabric_couple(mus_cloth *cloth, const double *cell, const mus__fabric_lattice *constant);
void mus__fabric_on_lattice(const mus_fabric *fabric, double spacing, mus__fabric_lattice *out);
/* stiffness of an edge spring in a triangle, k = this * area / length^2; (x, y) is its unit vector along weft, warp */
double mus__fabric_stretch(const mus_fabric *fabric, double x, double y);
/*
 * Add the friction of bending to a fabric's rigidities (fabric.c): bend becomes what resists while no thread slips.
 * Returns the part of each bending element's stiffness that goes through its slider, 0 without friction.
 */
double mus__fabric_slide(mus_fabric *fabric);
/* rigidity against bending that curves along the unit vector (x, y) */
double mus__fabric_bend(const mus_fabric *fabric, double x, double y);

#endif
