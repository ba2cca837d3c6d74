/*
 * manifold_cell.c: the cells of the lattice through which the surface of the solids may pass.
 *
 * The grid is read in blocks of 4 x 4 x 4 cells, each of which is halved until every solid's bounds say that it is
 * inside, or outside of all solids (mus__solid_box(), which is exact), or it is one cell. Two thirds of the points of a
 * body are deep inside, and are never asked.
 */
#include <math.h>
#include <string.h>

#include "manifold/manifold_internal.h"

/* share of the spacing by which the lattice is shifted up and forwards: planes of points then do not lie in the floor,
 * on which the soles are flat; chosen. The body's middle plane is one of the lattice, so that legs that nearly touch
 * are parted */
#define CELL_UP 0.37
#define CELL_FORWARD 0.29

#define CELL_BLOCK 4 /* cells along a block of the grid */

/* spacings about the solids: three cells, since those beside the surface get points too, and those beside them are
 * asked */
#define CELL_PAD 7.0

/* most cells of the grid, and most with points of their own: indices of their crossings stay below 2^31 */
#define CELL_TABLE 5e8
#define CELL_OWN (INT32_C(1) << 24)

const int8_t mus__bcc_step[MUS__LINKS][3] = {
    {2, 0, 0},  {0, 2, 0},  {0, 0, 2},  {1, -1, -1}, {1, 1, -1},  {1, -1, 1},  {1, 1, 1},
    {-2, 0, 0}, {0, -2, 0}, {0, 0, -2}, {-1, 1, 1},  {-1, -1, 1}, {-1, 1, -1}, {-1, -1, -1}};


/* the grid of cells about all solids. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY */
static mus_status cell_grid(mus__bcc *lattice)
{
    const double wide = 2.0 * CELL_BLOCK * lattice->spacing;
    const double shift[3] = {0.0, CELL_UP * lattice->spacing, CELL_FORWARD * lattice->spacing};
    double cells = 1.0;
    for (int i = 0; i < 3; i++) {
        double low = INFINITY, high = -INFINITY;
        for (int32_t s = 0; s < lattice->solids->count; s++) {
            low = fmin(low, lattice->solids->solid[s].low[i]);
            high = fmax(high, lattice->solids->solid[s].high[i]);
        }
        const double first = floor((low - shift[i] - CELL_PAD * lattice->spacing) / wide);
        const double last = ceil((high - shift[i] + CELL_PAD * lattice->spacing) / wide);
        if (!(last - first >= 1.0 && last - first < 1e6))
            return mus__fail(lattice->context, MUS_ERR_ARG, "a manifold of %g m with a spacing of %g m is too large",
                             high - low, lattice->spacing);
        cells *= CELL_BLOCK * (last - first);
        lattice->origin[i] = first * wide + shift[i];
        lattice->grid[i] = CELL_BLOCK * (int32_t)(last - first);
    }
    if (cells > CELL_TABLE)
        return mus__fail(lattice->context, MUS_ERR_ARG, "spacing %g m is too small for this body: %.0f cells",
                         lattice->spacing, cells);
    lattice->table = mus__room(lattice->context, (int64_t)cells, sizeof *lattice->table);
    return lattice->table != NULL ? MUS_OK : mus__fail_memory(lattice->context, "the lattice of a manifold");
}


/* give points of its own to the cell at a place of the table, with the n solids in the list. Errors: MUS_ERR_MEMORY,
 * MUS_ERR_ARG */
static mus_status cell_add(mus__bcc *lattice, int32_t place, int32_t n, const int32_t *list)
{
    mus_context *context = lattice->context;
    if (lattice->cells >= CELL_OWN)
        return mus__fail(context, MUS_ERR_ARG, "spacing %g m is too small for this body: more than %d cells",
                         lattice->spacing, (int)CELL_OWN);
    mus_status status = mus__reserve(context, &lattice->place, &lattice->place_room, (int64_t)lattice->cells + 1,
                                     sizeof *lattice->place);
    if (status == MUS_OK)
        status = mus__reserve(context, &lattice->solid_first, &lattice->first_room, (int64_t)lattice->cells + 2,
                              sizeof *lattice->solid_first);
    if (status == MUS_OK)
        status = mus__reserve(context, &lattice->near, &lattice->near_room, (int64_t)lattice->entries + n,
                              sizeof *lattice->near);
    if (status == MUS_OK)
        status = mus__reserve(context, &lattice->corner, &lattice->corner_room, 3 * ((int64_t)lattice->cells + 1),
                              sizeof *lattice->corner);
    if (status != MUS_OK) return status;
    int32_t *corner = lattice->corner + 3 * (ptrdiff_t)lattice->cells;
    corner[0] = place % lattice->grid[0];
    corner[1] = place / lattice->grid[0] % lattice->grid[1];
    corner[2] = place / lattice->grid[0] / lattice->grid[1];
    if (n > 0) memcpy(lattice->near + lattice->entries, list, (size_t)n * sizeof *list);
    lattice->entries += n;
    lattice->table[place] = lattice->cells;
    lattice->place[lattice->cells++] = place;
    lattice->solid_first[lattice->cells] = lattice->entries;
    return MUS_OK;
}


/* the solids of a list that are near the cube of `wide` cells from the corner (3) on; returns their number, and in *box
 * what the cube is: MUS__BOX_OUT, MUS__BOX_IN or MUS__BOX_MIXED */
static int32_t cell_near(const mus__bcc *lattice, const int32_t *corner, int32_t wide, int32_t n, const int32_t *list,
                         int32_t *near, int *box)
{
    double middle[3];
    int32_t found = 0;
    for (int i = 0; i < 3; i++) middle[i] = lattice->origin[i] + (2 * corner[i] + wide) * lattice->spacing;
    *box = MUS__BOX_OUT;
    for (int32_t i = 0; i < n; i++) {
        const int here = mus__solid_box(lattice->solids, list[i], middle, wide * lattice->spacing);
        if (here == MUS__BOX_OUT) continue;
        near[found++] = list[i];
        if (here == MUS__BOX_IN || (here == MUS__BOX_MIXED && *box == MUS__BOX_OUT)) *box = here;
    }
    return found;
}


static int32_t cell_place(const mus__bcc *lattice, const int32_t *at)
{
    return (at[2] * lattice->grid[1] + at[1]) * lattice->grid[0] + at[0];
}


/* write the table for the cube of `wide` cells from the corner (3) on, near the n solids of a list. Errors:
 * MUS_ERR_MEMORY, MUS_ERR_ARG */
static mus_status cell_cube(mus__bcc *lattice, const int32_t *corner, int32_t wide, int32_t n, const int32_t *list)
{
    int32_t near[MUS__SOLIDS_MOST];
    int box;
    const int32_t found = cell_near(lattice, corner, wide, n, list, near, &box);
    if (box == MUS__BOX_MIXED && wide == 1) return cell_add(lattice, cell_place(lattice, corner), found, near);
    if (box == MUS__BOX_MIXED) {
        mus_status status = MUS_OK;
        for (int32_t m = 0; m < 8 && status == MUS_OK; m++) {
            const int32_t half = wide / 2, at[3] = {corner[0] + (m & 1) * half, corner[1] + (m >> 1 & 1) * half,
                                                    corner[2] + (m >> 2) * half};
            status = cell_cube(lattice, at, half, found, near);
        }
        return status;
    }
    for (int32_t k = 0; k < wide; k++)
        for (int32_t j = 0; j < wide; j++)
            for (int32_t i = 0; i < wide; i++) {
                const int32_t at[3] = {corner[0] + i, corner[1] + j, corner[2] + k};
                lattice->table[cell_place(lattice, at)] = box == MUS__BOX_IN ? MUS__CELL_IN : MUS__CELL_OUT;
            }
    return MUS_OK;
}


mus_status mus__bcc_open(mus__bcc *lattice, int32_t place, bool listed)
{
    const int32_t *grid = lattice->grid, at[3] = {place % grid[0], place / grid[0] % grid[1],
                                                  place / grid[0] / grid[1]};
    int32_t all[MUS__SOLIDS_MOST], near[MUS__SOLIDS_MOST], found = 0;
    int box;
    for (int32_t i = 0; i < lattice->solids->count; i++) all[i] = i;
    if (listed) found = cell_near(lattice, at, 1, lattice->solids->count, all, near, &box);
    return cell_add(lattice, place, found, near);
}


/* the tables of a point's neighbours */
static void cell_steps(mus__bcc *lattice)
{
    for (int32_t p = 0; p < MUS__CELL_POINTS; p++)
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int8_t *step = mus__bcc_step[d];
            const int32_t at[3] = {2 * (p & 1) + (p >> 3) + step[0], 2 * (p >> 1 & 1) + (p >> 3) + step[1],
                                   2 * (p >> 2 & 1) + (p >> 3) + step[2]};
            lattice->step[p][d] = mus__bcc_at(lattice, at);
        }
    for (int32_t d = 0; d < MUS__LINKS; d++)
        for (int32_t e = 0; e < MUS__LINKS; e++) {
            const int8_t *p = mus__bcc_step[d], *q = mus__bcc_step[e];
            const int32_t x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2], square = x * x + y * y + z * z;
            const bool is_long = square == 4 && (x == 0) + (y == 0) + (z == 0) == 2;
            if (square == 3 || is_long) lattice->touch[d] |= (uint16_t)(1u << e);
        }
}


mus__step mus__bcc_at(const mus__bcc *lattice, const int32_t *at)
{
    mus__step out = {0, (at[0] & 1) << 3};
    const int32_t wide[3] = {1, lattice->grid[0], lattice->grid[0] * lattice->grid[1]};
    for (int i = 0; i < 3; i++) {
        const int32_t beyond = (at[i] + 4) / 4 - 1; /* at[i] is -4 at least */
        out.cell += beyond * wide[i];
        out.point |= (at[i] - 4 * beyond) / 2 << i;
    }
    return out;
}


int32_t mus__bcc_link(const mus__bcc *lattice, uint32_t mask, int32_t *edges, int32_t *triangles)
{
    int32_t vertices = 0, pairs = 0, triples = 0;
    for (uint32_t m = mask; m != 0; m &= m - 1) vertices++;
    for (int32_t i = 0; i < MUS__LINK_EDGES; i++) pairs += (mask & lattice->edge[i]) == lattice->edge[i];
    for (int32_t i = 0; i < MUS__LINK_FACES; i++) triples += (mask & lattice->face[i]) == lattice->face[i];
    *edges = pairs, *triangles = triples;
    return vertices;
}


/* edges and triangles between the neighbours of a point, and which sets of neighbours are connected: those that are
 * still without one of theirs, which touches another one */
static void cell_tables(mus__bcc *lattice)
{
    int32_t edges = 0, faces = 0;
    const uint32_t every = (1u << MUS__LINKS) - 1;
    for (int32_t d = 0; d < MUS__LINKS; d++)
        for (int32_t e = 0; e < d; e++) {
            if ((lattice->touch[d] >> e & 1) == 0) continue;
            lattice->edge[edges++] = (uint16_t)(1u << d | 1u << e);
            for (int32_t f = 0; f < e; f++)
                if (((lattice->touch[d] & lattice->touch[e]) >> f & 1) != 0)
                    lattice->face[faces++] = (uint16_t)(1u << d | 1u << e | 1u << f);
        }
    lattice->linked[0] = 1;
    for (uint32_t mask = 1; mask <= every; mask++) {
        bool found = (mask & (mask - 1)) == 0;
        for (int32_t d = 0; d < MUS__LINKS && !found; d++)
            found = (mask >> d & 1) != 0 && (lattice->touch[d] & mask) != 0 &&
                    mus__bcc_connected(lattice, mask & ~(1u << d));
        if (found) lattice->linked[mask / 8] |= (uint8_t)(1u << mask % 8);
    }
}


mus_status mus__bcc_make(mus_context *context, mus__pool *pool, const mus__solids *solids, double spacing,
                         mus__bcc *out)
{
    memset(out, 0, sizeof *out);
    out->context = context;
    out->pool = pool;
    out->solids = solids;
    out->spacing = spacing;
    mus_status status = cell_grid(out);
    if (status != MUS_OK) return status;
    cell_steps(out);
    cell_tables(out);
    int32_t all[MUS__SOLIDS_MOST], at[3];
    for (int32_t i = 0; i < solids->count; i++) all[i] = i;
    for (int32_t i = 0; i < MUS__CELLS_SHARED && status == MUS_OK; i++) status = cell_add(out, 0, 0, NULL);
    for (at[2] = 0; at[2] < out->grid[2]; at[2] += CELL_BLOCK)
        for (at[1] = 0; at[1] < out->grid[1]; at[1] += CELL_BLOCK)
            for (at[0] = 0; at[0] < out->grid[0] && status == MUS_OK; at[0] += CELL_BLOCK)
                status = cell_cube(out, at, CELL_BLOCK, solids->count, all);
    return status;
}


void mus__bcc_free(mus__bcc *lattice)
{
    mus_context *context = lattice->context;
    mus__free(context, lattice->table);
    mus__free(context, lattice->place);
    mus__free(context, lattice->corner);
    mus__free(context, lattice->solid_first);
    mus__free(context, lattice->near);
    mus__free(context, lattice->depth);
    mus__free(context, lattice->label);
    mus__free(context, lattice->differ);
    mus__free(context, lattice->inside);
    mus__free(context, lattice->moved);
    mus__free(context, lattice->slot);
    mus__free(context, lattice->cell_first);
    mus__free(context, lattice->crossing);
    mus__free(context, lattice->state);
    mus__free(context, lattice->part);
}
