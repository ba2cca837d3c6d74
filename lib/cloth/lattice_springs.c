/*
 * lattice_springs.c: springs, bending stencils and couplings of full cells, collected into runs.
 *
 * A spring along a lattice line is added here when both of its cells are full. Beside one full cell it belongs to the
 * strip (border_springs.c), with half of its stiffness from the cell. Each full cell has both diagonals. The stiffness
 * of a stencil is multiplied by the share of the four cells round its middle node that are full: a lattice line at the
 * edge of the full cells bends with half the stiffness, and the hinges of the strip add the rest:
 *
 *      o---o---o      lines:      k (full cells round the middle) / 4, if both of its springs touch a full cell
 *      | 3 | 2 |      diagonals:  the same, if both cells on the diagonal are full
 *      o---*---o
 *      | 0 | 1 |      Runs follow the numbering of nodes: as long as the next spring is (a + 1, b + 1) with the same
 *      o---o---o      stiffness, it lengthens the run.
 */
#include <math.h>

#include "cloth/mesh.h"


static mus_status run_spring(mus__mesh *mesh, int32_t a, int32_t b, int32_t kind, double k, double rest)
{
    mus_cloth *cloth = mesh->cloth;
    mus__spring_run *last = cloth->nrun > 0 ? &cloth->run[cloth->nrun - 1] : NULL;
    if (last != NULL && last->kind == kind && last->k == k && last->a + last->count == a &&
        last->b + last->count == b) {
        last->count++;
        return MUS_OK;
    }
    mus_status status =
        mus__reserve(mesh->context, &cloth->run, &mesh->cap_run, (int64_t)cloth->nrun + 1, sizeof *last);
    if (status == MUS_OK) cloth->run[cloth->nrun++] = (mus__spring_run){a, b, 1, kind, k, rest};
    return status;
}


static mus_status run_bend(mus__mesh *mesh, int32_t a, int32_t b, int32_t c, double k)
{
    mus_cloth *cloth = mesh->cloth;
    mus__bend_run *last = cloth->nbend > 0 ? &cloth->bend[cloth->nbend - 1] : NULL;
    if (last != NULL && last->k == k && last->a + last->count == a && last->b + last->count == b &&
        last->c + last->count == c) {
        last->count++;
        return MUS_OK;
    }
    mus_status status =
        mus__reserve(mesh->context, &cloth->bend, &mesh->cap_bend, (int64_t)cloth->nbend + 1, sizeof *last);
    if (status == MUS_OK) cloth->bend[cloth->nbend++] = (mus__bend_run){a, b, c, 1, k};
    return status;
}


/* Adds the springs of one kind over the whole lattice. */
static mus_status run_springs(mus__mesh *mesh, const mus__lattice *lattice, int32_t first, int32_t kind)
{
    const int64_t columns = lattice->columns, places = columns * lattice->rows;
    const int64_t step = kind == MUS__SPRING_WARP ? columns : 1, beside = kind == MUS__SPRING_WARP ? 1 : columns;
    const double k = mesh->constant.k[kind];
    mus_status status = MUS_OK;
    for (int64_t p = columns; status == MUS_OK && p < places; p++)
        if (lattice->full[p] && lattice->full[p - beside])
            status =
                run_spring(mesh, first + lattice->node[p], first + lattice->node[p + step], kind, k, lattice->spacing);
    return status;
}


/* Adds the diagonals of one direction: rising from (0, 0) to (1, 1), or falling from (1, 0) to (0, 1). */
static mus_status run_diagonals(mus__mesh *mesh, const mus__lattice *lattice, int32_t first, bool rising)
{
    const int64_t columns = lattice->columns, places = columns * lattice->rows;
    const double rest = lattice->spacing * sqrt(2.0);
    mus_status status = MUS_OK;
    for (int64_t p = columns; status == MUS_OK && p < places; p++) {
        if (!lattice->full[p]) continue;
        const int32_t *node = lattice->node + p;
        status =
            run_spring(mesh, first + (rising ? node[0] : node[1]), first + (rising ? node[columns + 1] : node[columns]),
                       MUS__SPRING_SHEAR, mesh->constant.shear, rest);
    }
    return status;
}


/* Adds the bending stencils along one direction, or the bending springs over one node (Metaaphanon and Kanongchaiyos
 * 2005). `step`: difference of index from the middle to the last node. */
static mus_status run_stencils(mus__mesh *mesh, const mus__lattice *lattice, int32_t first, int64_t step, double k)
{
    const int64_t columns = lattice->columns, places = columns * lattice->rows;
    mus_status status = MUS_OK;
    for (int64_t p = columns + 1; status == MUS_OK && p < places; p++) {
        if (lattice->node[p] == MUS_NONE) continue;

        /* the four cells round the middle node, numbered as in the picture above */
        const unsigned char *full = lattice->full + p;
        const unsigned char cell[4] = {full[-columns - 1], full[-columns], full[0], full[-1]};
        bool whole;
        if (step == 1)
            whole = (cell[0] || cell[3]) && (cell[1] || cell[2]);
        else if (step == columns)
            whole = (cell[0] || cell[1]) && (cell[2] || cell[3]);
        else if (step == columns + 1)
            whole = cell[0] && cell[2];
        else
            whole = cell[1] && cell[3];
        if (!whole) continue;
        const int32_t before = first + lattice->node[p - step], after = first + lattice->node[p + step];
        const double share = 0.25 * k * mus__lattice_around(lattice, p);
        status = mesh->paper > 0.0
                     ? run_spring(mesh, before, after, MUS__SPRING_SKIP, share, 2.0 * lattice->spacing)
                     : run_bend(mesh, before, first + lattice->node[p], after, share);
    }
    return status;
}


/* Adds the full cells, in runs along the weft. */
static mus_status run_cells(mus__mesh *mesh, const mus__lattice *lattice, int32_t first)
{
    mus_cloth *cloth = mesh->cloth;
    const int64_t columns = lattice->columns, places = columns * lattice->rows;
    mus_status status = MUS_OK;
    for (int64_t p = columns; status == MUS_OK && p < places; p++) {
        if (!lattice->full[p]) continue;
        const int32_t a = first + lattice->node[p], b = first + lattice->node[p + columns];
        mus__cell_run *last = cloth->ncell > 0 ? &cloth->cell[cloth->ncell - 1] : NULL;
        if (last != NULL && last->a + last->count == a && last->b + last->count == b) {
            last->count++;
            continue;
        }
        status = mus__reserve(mesh->context, &cloth->cell, &mesh->cap_cell, (int64_t)cloth->ncell + 1, sizeof *last);
        if (status == MUS_OK) cloth->cell[cloth->ncell++] = (mus__cell_run){a, b, 1};
    }
    return status;
}


mus_status mus__mesh_runs(mus__mesh *mesh, const mus__lattice *lattice, int32_t first_node)
{
    const mus__fabric_lattice *constant = &mesh->constant;
    mus_status status = run_springs(mesh, lattice, first_node, MUS__SPRING_WEFT);
    if (status == MUS_OK) status = run_springs(mesh, lattice, first_node, MUS__SPRING_WARP);

    /* springs of stiffness 0 are left out */
    for (int k = 0; k < 2; k++)
        if (status == MUS_OK && constant->shear > 0.0) status = run_diagonals(mesh, lattice, first_node, k == 0);
    if (status == MUS_OK && constant->couple > 0.0) status = run_cells(mesh, lattice, first_node);
    const int64_t step[4] = {lattice->columns, 1, lattice->columns + 1, lattice->columns - 1};
    const double stiff[4] = {constant->bend[0] + constant->skip[0], constant->bend[1] + constant->skip[1],
                             constant->cross, constant->cross};
    for (int k = 0; k < 4; k++)
        if (status == MUS_OK && stiff[k] > 0.0) status = run_stencils(mesh, lattice, first_node, step[k], stiff[k]);
    return status;
}
