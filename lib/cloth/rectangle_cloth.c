/*
 * rectangle_cloth.c: mus_cloth_create_grid(): a rectangle of cloth as one lattice, without a pattern. Experiments and
 * verification use it.
 *
 * All springs are in runs, row by row. The mass of a node is its share times that of a whole cell:
 *
 *     1/4--1/2--1/4     share = (share of its column) x (share of its row): 1/2 at both ends of a line of nodes, 1
 *      |    |    |      between. A direction with a single node stands for one whole cell, share 1.
 *     1/2-- 1 --1/2
 *      |    |    |      A spring along a line is multiplied by the share across the line, a bending stencil by that of
 *     1/4--1/2--1/4     its middle node; diagonals lie inside one cell and have factor 1.
 *
 * A single line of nodes has no diagonals; its springs carry all of C11.
 */
#include <math.h>

#include "cloth/mesh.h"

/* [m] shortest and longest side of a cell; chosen: far below a thread, far above a garment. A wrong unit is refused */
#define GRID_LEAST_CELL 1e-6
#define GRID_MOST_CELL 10.0

typedef struct grid {
    mus_cloth *cloth;
    int32_t rows, columns;
    const double *cell;
    mus__fabric_lattice constant;
} grid;


/* Returns the share of line i of n parallel ones: 1/2 for the outer two, else 1. */
static double grid_share(int32_t i, int32_t n)
{
    return n > 1 && (i == 0 || i == n - 1) ? 0.5 : 1.0;
}


/* Returns the number of cells along a direction with n nodes; 1 for a single node. */
static double grid_cells(int32_t n)
{
    return n > 1 ? n - 1 : 1;
}


static void grid_spring(grid *g, int32_t a, int32_t b, int32_t count, int32_t kind, double k, double rest)
{
    if (count > 0 && k > 0.0) g->cloth->run[g->cloth->nrun++] = (mus__spring_run){a, b, count, kind, k, rest};
}


static void grid_bend(grid *g, int32_t middle, int32_t step, int32_t count, double k)
{
    if (count > 0 && k > 0.0)
        g->cloth->bend[g->cloth->nbend++] = (mus__bend_run){middle - step, middle, middle + step, count, k};
}


/* Adds the springs that start in row r: along it, to the next row, and both diagonals. */
static void grid_springs(grid *g, int32_t r)
{
    const int32_t n = g->columns, first = r * n;
    const double *k = g->constant.k, x = g->cell[0], y = g->cell[1];
    grid_spring(g, first, first + 1, n - 1, MUS__SPRING_WEFT, k[1] * grid_share(r, g->rows), x);
    if (r + 1 == g->rows) return;
    grid_spring(g, first, first + n, 1, MUS__SPRING_WARP, k[0] * grid_share(0, n), y);
    grid_spring(g, first + 1, first + 1 + n, n - 2, MUS__SPRING_WARP, k[0], y);
    if (n > 1) grid_spring(g, first + n - 1, first + 2 * n - 1, 1, MUS__SPRING_WARP, k[0] * 0.5, y);
    const double diagonal = sqrt(x * x + y * y);
    grid_spring(g, first, first + n + 1, n - 1, MUS__SPRING_SHEAR, g->constant.shear, diagonal);
    grid_spring(g, first + 1, first + n, n - 1, MUS__SPRING_SHEAR, g->constant.shear, diagonal);
}


/* Adds the cells between row r and the next. */
static void grid_cells_of(grid *g, int32_t r)
{
    if (g->cloth->couple > 0.0 && r + 1 < g->rows)
        g->cloth->cell[g->cloth->ncell++] = (mus__cell_run){r * g->columns, (r + 1) * g->columns, g->columns - 1};
}


/* Adds bending springs over one node (Metaaphanon and Kanongchaiyos 2005), in place of stencils, centred in row r. */
static void grid_skips(grid *g, int32_t r)
{
    const int32_t n = g->columns, first = r * n, kind = MUS__SPRING_SKIP;
    const double *skip = g->constant.skip, x = 2.0 * g->cell[0], y = 2.0 * g->cell[1];
    grid_spring(g, first, first + 2, n - 2, kind, skip[1] * grid_share(r, g->rows), x);
    if (r == 0 || r + 1 == g->rows) return;
    grid_spring(g, first - n, first + n, 1, kind, skip[0] * grid_share(0, n), y);
    grid_spring(g, first + 1 - n, first + 1 + n, n - 2, kind, skip[0], y);
    if (n > 1) grid_spring(g, first - 1, first + 2 * n - 1, 1, kind, skip[0] * 0.5, y);
}


/* Adds the bending stencils centred in row r: along it, across it, and along both diagonals. */
static void grid_bends(grid *g, int32_t r)
{
    const int32_t n = g->columns, first = r * n;
    const double *bend = g->constant.bend, cross = g->constant.cross;
    grid_bend(g, first + 1, 1, n - 2, bend[1] * grid_share(r, g->rows));
    if (r == 0 || r + 1 == g->rows) return;
    grid_bend(g, first, n, 1, bend[0] * grid_share(0, n));
    grid_bend(g, first + 1, n, n - 2, bend[0]);
    if (n > 1) grid_bend(g, first + n - 1, n, 1, bend[0] * 0.5);
    grid_bend(g, first + 1, n + 1, n - 2, cross);
    grid_bend(g, first + 1, n - 1, n - 2, cross);
}


/* Writes two counter-clockwise triangles a cell, diagonals in a checkerboard. */
static void grid_triangles(const grid *g)
{
    int32_t *out = g->cloth->triangle;
    for (int32_t r = 0; r + 1 < g->rows; r++)
        for (int32_t c = 0; c + 1 < g->columns; c++) {
            const int32_t a = r * g->columns + c, b = a + 1, d = a + g->columns, e = d + 1;
            const bool rising = (r + c) % 2 == 0;
            const int32_t corner[6] = {a, b, rising ? e : d, rising ? a : b, e, d};
            for (int k = 0; k < 6; k++) *out++ = corner[k];
        }
}


/* Writes the border nodes counter-clockwise from node 0; of a single line, its nodes in order. */
static void grid_border(const grid *g)
{
    mus_cloth *cloth = g->cloth;
    const int32_t n = g->columns, last = cloth->nnode - 1;
    int32_t *out = cloth->border;
    if (n == 1 || g->rows == 1) {
        for (int32_t i = 0; i <= last; i++) out[i] = i;
        return;
    }
    for (int32_t c = 0; c < n - 1; c++) *out++ = c;
    for (int32_t r = 0; r < g->rows - 1; r++) *out++ = r * n + n - 1;
    for (int32_t c = 0; c < n - 1; c++) *out++ = last - c;
    for (int32_t r = g->rows - 1; r > 0; r--) *out++ = r * n;
}


/* Writes rest places, masses and rows of the nodes, and the only panel. */
static void grid_nodes(const grid *g)
{
    mus_cloth *cloth = g->cloth;
    const double unit = cloth->fabric.weight * g->cell[0] * g->cell[1];
    for (int32_t r = 0; r < g->rows; r++) {
        cloth->row[r] = (mus__row){r * g->columns, g->columns};
        for (int32_t c = 0; c < g->columns; c++) {
            const int64_t i = (int64_t)r * g->columns + c;
            cloth->rest[2 * i] = c * g->cell[0];
            cloth->rest[2 * i + 1] = r * g->cell[1];
            cloth->mass[i] = unit * grid_share(r, g->rows) * grid_share(c, g->columns);
        }
    }
    cloth->mass_total = unit * grid_cells(g->rows) * grid_cells(g->columns);
    mus_placement_init(&cloth->panel[0].placement, sizeof cloth->panel[0].placement);
    cloth->panel[0].node_count = cloth->panel[0].lattice_count = cloth->nnode;
    cloth->panel[0].triangle_count = cloth->ntriangle;
    cloth->panel[0].border_count = cloth->nborder;
}


/* Allocates the arrays; returns false when there is no memory. */
static bool grid_take(const grid *g)
{
    mus_cloth *cloth = g->cloth;
    mus_context *context = cloth->context;
    const int64_t rows = g->rows, columns = g->columns, n = rows * columns;
    cloth->npanel = 1;
    cloth->nnode = (int32_t)n;
    cloth->nrow = g->rows;
    cloth->ntriangle = (int32_t)(2 * (rows - 1) * (columns - 1));
    cloth->nborder = (int32_t)(rows == 1 || columns == 1 ? n : 2 * (rows + columns) - 4);
    cloth->panel = mus__new(context, 1, sizeof *cloth->panel);
    cloth->rest = mus__new(context, 2 * n, sizeof *cloth->rest);
    cloth->mass = mus__new(context, n, sizeof *cloth->mass);
    cloth->node_panel = mus__new(context, n, sizeof *cloth->node_panel);
    cloth->triangle = mus__new(context, 3 * (int64_t)cloth->ntriangle, sizeof *cloth->triangle);
    cloth->border = mus__new(context, cloth->nborder, sizeof *cloth->border);
    cloth->row = mus__new(context, rows, sizeof *cloth->row);
    cloth->run = mus__new(context, 10 * rows, sizeof *cloth->run);
    cloth->bend = mus__new(context, 6 * rows, sizeof *cloth->bend);
    cloth->cell = mus__new(context, rows, sizeof *cloth->cell);
    return cloth->panel != NULL && cloth->rest != NULL && cloth->mass != NULL && cloth->node_panel != NULL &&
           cloth->triangle != NULL && cloth->border != NULL && cloth->row != NULL && cloth->run != NULL &&
           cloth->bend != NULL && cloth->cell != NULL;
}


/* Computes the spring constants of a cell. A single line has no diagonals and carries all of C11 and of the bending. */
static void grid_constants(grid *g, double paper)
{
    mus_fabric fabric = g->cloth->fabric;
    if (g->rows == 1 || g->columns == 1) {
        fabric.shear = 0.0;
        fabric.bend[2] = 0.0;
    }
    if (!(paper > 0.0)) g->cloth->bend_slide = mus__fabric_slide(&fabric);
    mus__fabric_on_cell(&fabric, g->cell, &g->constant);
    if (paper > 0.0) mus__fabric_on_paper(&fabric, g->cell, paper, &g->constant);
    if (g->rows > 1 && g->columns > 1) mus__fabric_couple(g->cloth, g->cell, &g->constant);
}


static mus_status grid_check(mus_context *context, int32_t rows, int32_t columns, const double *cell)
{
    if (rows < 1 || columns < 1)
        return mus__fail(context, MUS_ERR_ARG, "cloth: %d rows, %d columns, expected 1 or more", (int)rows,
                         (int)columns);
    for (int k = 0; k < 2; k++)
        if (!(cell[k] >= GRID_LEAST_CELL && cell[k] <= GRID_MOST_CELL))
            return mus__fail(context, MUS_ERR_ARG, "cloth: cell %g m along %s is outside %g to %g m", cell[k],
                             k == 0 ? "weft" : "warp", GRID_LEAST_CELL, GRID_MOST_CELL);
    if ((int64_t)rows * columns > MUS__CLOTH_NODES_LIMIT)
        return mus__fail(context, MUS_ERR_LIMIT, "cloth: %d x %d nodes are more than 2^24", (int)rows, (int)columns);
    return MUS_OK;
}


mus_status mus_cloth_create_grid(mus_context *context, int32_t rows, int32_t columns, const double *cell,
                                 const mus_cloth_def *def, mus_cloth **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (cell == NULL || out == NULL)
        return mus__fail(context, MUS_ERR_ARG, "cloth: %s is NULL", cell == NULL ? "cell" : "out");
    mus_cloth_def own;
    mus_fabric fabric;
    mus_status status = mus__cloth_def_read(context, def, NULL, &own, &fabric);
    if (status == MUS_OK) status = grid_check(context, rows, columns, cell);
    if (status != MUS_OK) return status;

    grid g = {.cloth = mus__cloth_new(context), .rows = rows, .columns = columns, .cell = cell};
    if (g.cloth != NULL) {
        g.cloth->fabric = fabric;
        g.cloth->spacing = fmin(cell[0], cell[1]);
    }
    if (g.cloth == NULL || !grid_take(&g)) {
        mus_cloth_destroy(g.cloth);
        return mus__fail_memory(context, "a grid of cloth");
    }
    grid_constants(&g, own.bending == MUS_BEND_PAPER ? own.paper_curvature : 0.0);
    grid_nodes(&g);
    grid_triangles(&g);
    grid_border(&g);
    for (int32_t r = 0; r < rows; r++) {
        grid_springs(&g, r);
        grid_bends(&g, r);
        grid_cells_of(&g, r);
        grid_skips(&g, r);
    }
    double coarse_cell[2];
    int32_t r = rows, c = columns;
    if (mus__grid_coarser(g.cloth, &own, &r, &c, cell, coarse_cell))
        status = mus_cloth_create_grid(context, r, c, coarse_cell, &own, &g.cloth->coarse);

    /* warn once, for the coarsest cut; a single row of nodes cannot be clamped */
    if (status == MUS_OK && g.cloth->coarse == NULL && rows > 1 && columns > 1)
        mus__fabric_note(context, &fabric, cell);
    if (status == MUS_OK) *out = g.cloth;
    else mus_cloth_destroy(g.cloth);
    return status;
}
