/*
 * coarse.c: the same cloth cut coarser, for a drape that wants to find its shape quickly (coarse to fine).
 *
 * Each cut is twice as coarse as the one before. The last of a pattern is at 40 mm: coarser than that a sleeve has no
 * round shape. A pattern that cannot be meshed so coarsely just has no coarser cut, nor has one with pleats, which
 * would have no layers there.
 */
#include "cloth/mesh.h"

#define COARSEST 0.04
#define NEXT_TO_COARSEST 0.0282 /* [m]: COARSEST over the square root of 2; below it a cut of twice the spacing fits */
#define GRID_COARSEST 0.15      /* [m] */
#define FEWEST_NODES 400        /* a garment of fewer is quick as it is */
#define FEWEST_GRID_NODES 200   /* and a grid */


mus_status mus__cloth_coarsen(mus_context *context, const mus_pattern *pattern, const mus_cloth_def *def,
                              mus_cloth *cloth)
{
    if (cloth->npleat > 0) return MUS_OK;
    if (def->coarser == 0 || cloth->spacing > NEXT_TO_COARSEST || cloth->nnode < FEWEST_NODES) return MUS_OK;
    mus_cloth_def coarse = *def;
    coarse.spacing = 2.0 * cloth->spacing > NEXT_TO_COARSEST ? COARSEST : 2.0 * cloth->spacing;
    const mus_status status = mus_cloth_create(context, pattern, &coarse, &cloth->coarse);
    return status == MUS_ERR_MEMORY ? status : MUS_OK;
}


/* nodes of a direction at twice the cell; a single line of cells stays one */
static int32_t half_as_many(int32_t nodes)
{
    return nodes < 3 ? nodes : (nodes + 1) / 2;
}


mus_status mus__grid_coarsen(mus_context *context, int32_t rows, int32_t columns, const double *cell,
                             const mus_cloth_def *def, mus_cloth *cloth)
{
    if (def->coarser == 0 || rows < 2 || columns < 2 || cloth->nnode < FEWEST_GRID_NODES) return MUS_OK;
    const int32_t r = half_as_many(rows), c = half_as_many(columns);
    const double wide[2] = {cell[0] * (columns - 1) / (c - 1), cell[1] * (rows - 1) / (r - 1)};
    if (wide[0] > GRID_COARSEST || wide[1] > GRID_COARSEST) return MUS_OK;
    return mus_cloth_create_grid(context, r, c, wide, def, &cloth->coarse);
}
