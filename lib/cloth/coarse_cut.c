/*
 * coarse_cut.c: whether a cloth has a coarser cut, from which a drape finds its shape quickly (coarse to fine), and how
 * coarse that is.
 *
 * Each cut has twice the spacing of the one before. The last one of a pattern is at 40 mm. A cloth with pleats has no
 * coarser cut: the layers of a pleat are narrower than its cells.
 *
 * The coarser cut of a pattern is of stiffer cloth. Soft cloth folds within a few of its cells while its seams are
 * drawn together, when no weight straightens it: a waistband rolls up, a hem turns over, and the finer cut keeps what
 * friction and the body then hold. Cloth whose bending length is longer than its cells cannot: it comes to where its
 * pattern lies smoothly round the body, and the finer cuts let the stiffness out step by step (a continuation from
 * stiff to soft).
 */
#include <math.h>

#include "cloth/mesh.h"

/* [m] spacing of the coarsest cut of a pattern. Chosen: with larger cells a sleeve is no longer round */
#define COARSEST 0.04
/* [m] COARSEST / sqrt(2): above it a cut of COARSEST would be less than sqrt(2) times as coarse, and saves nothing */
#define NEXT_TO_COARSEST 0.0282
/* [m] longest side of a cell of a coarser grid. Chosen */
#define GRID_COARSEST 0.15
/* nodes below which a pattern, and a grid, has no coarser cut: it settles as fast without. Chosen */
#define FEWEST_NODES 400
#define FEWEST_GRID_NODES 200
/* bending length of the cloth of a coarser cut over its spacing, at least. Chosen: with 1 hems stay turned up, with 3
 * points of strapless tops stand away from the back and fall over */
#define STIFF_CELLS 2.0


bool mus__cloth_coarser(const mus_cloth *cloth, const mus_cloth_def *def, double *spacing)
{
    if (cloth->npleat > 0) return false;
    if (def->coarser == 0 || cloth->spacing > NEXT_TO_COARSEST || cloth->nnode < FEWEST_NODES) return false;
    *spacing = 2.0 * cloth->spacing > NEXT_TO_COARSEST ? COARSEST : 2.0 * cloth->spacing;
    return true;
}


double mus__cloth_stiffen(double spacing, mus_fabric *fabric)
{
    const double asked = mus__rigidity_of_length(fabric->weight, STIFF_CELLS * spacing), *bend = fabric->bend;
    const double softest = fmin(fmin(bend[0], bend[1]), bend[2]);
    if (softest >= asked) return 1.0;
    for (int k = 0; k < 3; k++) fabric->bend[k] += asked - softest;
    return softest / asked;
}


/* nodes of a direction when cells are twice as long; a single row of cells stays one */
static int32_t half_as_many(int32_t nodes)
{
    return nodes < 3 ? nodes : (nodes + 1) / 2;
}


bool mus__grid_coarser(const mus_cloth *cloth, const mus_cloth_def *def, int32_t *rows, int32_t *columns,
                       const double *cell, double *coarse_cell)
{
    if (def->coarser == 0 || *rows < 2 || *columns < 2 || cloth->nnode < FEWEST_GRID_NODES) return false;
    const int32_t r = half_as_many(*rows), c = half_as_many(*columns);
    coarse_cell[0] = cell[0] * (*columns - 1) / (c - 1), coarse_cell[1] = cell[1] * (*rows - 1) / (r - 1);
    if (coarse_cell[0] > GRID_COARSEST || coarse_cell[1] > GRID_COARSEST) return false;
    *rows = r, *columns = c;
    return true;
}
