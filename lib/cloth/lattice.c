/*
 * lattice.c: the square lattice inside a panel: which lattice points become nodes, and which cells are full.
 *
 * A lattice point becomes a node when it lies inside the border and at least LATTICE_CLEAR spacings from it, and from
 * the lines inside the panel. A cell is full when its four corners are nodes. No dart point lies in a full cell,
 * because no point of a cell is further than sqrt(1/2) spacings from a corner. The region between border and full cells
 * is the strip, which mesh.c triangulates.
 *
 *      border  ____________________
 *             / \/ \/ \/ \/ \/ \/ /     strip
 *            /__o__o__o__o__o__o_/
 *            \ /|  |  |  |  |  |/       full cells
 *             o-o--o--o--o--o--o
 *
 * Points inside are found by parity: each border side flips all points of a row beyond its crossing. The work is
 * O(lattice points + border sides), without sorting.
 */
#include <math.h>

#include "cloth/lattice.h"
#include "base/elementary.h"

/* [spacings] least distance of a lattice node from the border; must exceed sqrt(1/2). A smaller value gives slivers in
 * the strip, a larger one long triangles. Measured on skirt, sleeve, dart, slit and straps at 4, 10 and 15 mm: with
 * 0.5 / 0.6 / 0.75 / 0.9 the least angle is 23 / 26 / 26 / 26 degrees, and the stable step is 1.5 / 1.44 / 1.32 / 1.18
 * times smaller than that of the lattice alone; at 0.9 narrow panels get no lattice nodes */
#define LATTICE_CLEAR 0.75
/* most lattice points of a panel: they take 640 MB. Only a panel far larger than its spacing, or a long thin one on the
 * bias, reaches it */
#define LATTICE_MOST (INT64_C(1) << 27)


/* Converts a point [m] to lattice units: (column, row) from the origin. */
static void lattice_units(const mus__lattice *lattice, const double *point, double *out)
{
    double x = point[0] - lattice->origin[0], y = point[1] - lattice->origin[1];
    out[0] = (x * lattice->weft[0] + y * lattice->weft[1]) / lattice->spacing;
    out[1] = (x * lattice->warp[0] + y * lattice->warp[1]) / lattice->spacing;
}


/*
 * Returns the offset of the lattice from the middle of an extent of 2 `half` spacings: 0 or 0.5 spacings, whichever
 * leaves a margin nearer to one spacing at the border. With either, a symmetric panel has a symmetric lattice.
 */
static double lattice_phase(double half)
{
    double best = 0.0, miss = INFINITY;
    for (int k = 0; k < 2; k++) {
        double phase = 0.5 * k, rim = half - phase - floor(half - phase - LATTICE_CLEAR);
        if (fabs(rim - 1.0) < miss) best = phase, miss = fabs(rim - 1.0);
    }
    return best;
}


/* Computes axes, origin and size of the lattice from the bounding box of the border along the axes. */
static mus_status lattice_frame(mus_context *context, int32_t n, const double *xy, mus__lattice *lattice)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, at[2], size[2];
    for (int32_t i = 0; i < n; i++) {
        lattice_units(lattice, xy + 2 * (ptrdiff_t)i, at);
        for (int k = 0; k < 2; k++) low[k] = fmin(low[k], at[k]), high[k] = fmax(high[k], at[k]);
    }

    /* the first lattice point lies at least one spacing outside the box */
    double start[2];
    for (int k = 0; k < 2; k++) {
        double half = 0.5 * (high[k] - low[k]), phase = lattice_phase(half), steps = ceil(half - phase) + 1.0;
        start[k] = 0.5 * (low[k] + high[k]) - phase - steps;
        size[k] = 2.0 * (steps + phase) + 1.0;
    }
    if (!(size[0] * size[1] < (double)LATTICE_MOST))
        return mus__fail(context, MUS_ERR_LIMIT,
                         "%g x %g lattice places are more than 2^27: the spacing is too small", size[0], size[1]);
    lattice->columns = (int32_t)size[0], lattice->rows = (int32_t)size[1];
    for (int k = 0; k < 2; k++)
        lattice->origin[k] += lattice->spacing * (start[0] * lattice->weft[k] + start[1] * lattice->warp[k]);
    return MUS_OK;
}


/* Flips the parity of all points beyond the crossing, in each row that the border side a b crosses. */
static void lattice_flip(mus__lattice *lattice, const double *a, const double *b)
{
    const double *lower = a[1] <= b[1] ? a : b, *upper = a[1] <= b[1] ? b : a;
    for (int32_t j = (int32_t)ceil(lower[1]); j < upper[1]; j++) {
        double t = (j - lower[1]) / (upper[1] - lower[1]);
        int32_t i = (int32_t)ceil(lower[0] + t * (upper[0] - lower[0]));
        lattice->full[(int64_t)j * lattice->columns + i] ^= 1;
    }
}


static double lattice_distance(const double *a, const double *b, double x, double y)
{
    double ux = b[0] - a[0], uy = b[1] - a[1], square = ux * ux + uy * uy;
    double t = square > 0.0 ? ((x - a[0]) * ux + (y - a[1]) * uy) / square : 0.0;
    t = fmin(fmax(t, 0.0), 1.0);
    return mus__hypot(x - a[0] - t * ux, y - a[1] - t * uy);
}


/* Removes the points nearer than LATTICE_CLEAR to the side a b. */
static void lattice_clear(mus__lattice *lattice, const double *a, const double *b)
{
    int32_t i0 = (int32_t)ceil(fmin(a[0], b[0]) - LATTICE_CLEAR), i1 = (int32_t)(fmax(a[0], b[0]) + LATTICE_CLEAR);
    int32_t j0 = (int32_t)ceil(fmin(a[1], b[1]) - LATTICE_CLEAR), j1 = (int32_t)(fmax(a[1], b[1]) + LATTICE_CLEAR);
    for (int32_t j = j0; j <= j1; j++)
        for (int32_t i = i0; i <= i1; i++)
            if (lattice_distance(a, b, i, j) < LATTICE_CLEAR)
                lattice->node[(int64_t)j * lattice->columns + i] = MUS_NONE;
}


/* Calls `visit` for each border side, in lattice units. */
static void lattice_sides(mus__lattice *lattice, int32_t n, const double *xy,
                          void (*visit)(mus__lattice *lattice, const double *a, const double *b))
{
    double a[2], b[2];
    lattice_units(lattice, xy + 2 * ((ptrdiff_t)n - 1), a);
    for (int32_t i = 0; i < n; i++) {
        lattice_units(lattice, xy + 2 * (ptrdiff_t)i, b);
        visit(lattice, a, b);
        a[0] = b[0], a[1] = b[1];
    }
}


mus_status mus__lattice_build(mus_context *context, int32_t n, const double *xy, int32_t nside, const int32_t *side,
                              const double *grain, double spacing, mus__lattice *lattice)
{
    double length = mus__hypot(grain[0], grain[1]);
    *lattice = (mus__lattice){.spacing = spacing, .origin = {xy[0], xy[1]}};
    lattice->warp[0] = grain[0] / length, lattice->warp[1] = grain[1] / length;
    lattice->weft[0] = lattice->warp[1], lattice->weft[1] = -lattice->warp[0];
    mus_status status = lattice_frame(context, n, xy, lattice);
    if (status != MUS_OK) return status;

    int64_t places = (int64_t)lattice->columns * lattice->rows;
    lattice->node = mus__new(context, places, sizeof *lattice->node);
    lattice->full = mus__new(context, places, sizeof *lattice->full);
    if (lattice->node == NULL || lattice->full == NULL) return mus__fail_memory(context, "the lattice of a panel");

    /* find the points inside by parity, with `full` as the array of flips; then remove those near the border */
    lattice_sides(lattice, n, xy, lattice_flip);
    for (int64_t p = 0, inside = 0; p < places; p++) {
        inside = p % lattice->columns == 0 ? 0 : inside ^ lattice->full[p];
        lattice->node[p] = inside ? 0 : MUS_NONE;
    }
    lattice_sides(lattice, n, xy, lattice_clear);
    for (int32_t i = 0; i < nside; i++) {
        double a[2], b[2];
        lattice_units(lattice, xy + 2 * (ptrdiff_t)side[2 * (ptrdiff_t)i], a);
        lattice_units(lattice, xy + 2 * (ptrdiff_t)side[2 * (ptrdiff_t)i + 1], b);
        lattice_clear(lattice, a, b);
    }

    /* number the nodes row by row */
    for (int64_t p = 0; p < places; p++)
        if (lattice->node[p] != MUS_NONE) lattice->node[p] = lattice->count++;

    for (int64_t p = 0; p < places; p++) {
        const int32_t *at = lattice->node + p;
        lattice->full[p] = at[0] != MUS_NONE && at[1] != MUS_NONE && at[lattice->columns] != MUS_NONE &&
                           at[lattice->columns + 1] != MUS_NONE;
    }
    return MUS_OK;
}


void mus__lattice_free(mus_context *context, mus__lattice *lattice)
{
    mus__free(context, lattice->node);
    mus__free(context, lattice->full);
    lattice->node = NULL, lattice->full = NULL;
}


void mus__lattice_point(const mus__lattice *lattice, int32_t i, int32_t j, double *out)
{
    for (int k = 0; k < 2; k++)
        out[k] = lattice->origin[k] + lattice->spacing * (i * lattice->weft[k] + j * lattice->warp[k]);
}


int32_t mus__lattice_around(const mus__lattice *lattice, int64_t place)
{
    const unsigned char *full = lattice->full + place;
    return full[0] + full[-1] + full[-lattice->columns] + full[-lattice->columns - 1];
}


bool mus__lattice_covers(const mus__lattice *lattice, const double *point)
{
    double at[2];
    lattice_units(lattice, point, at);
    if (!(at[0] >= 0.0 && at[1] >= 0.0 && at[0] < lattice->columns && at[1] < lattice->rows)) return false;
    return lattice->full[(int64_t)at[1] * lattice->columns + (int64_t)at[0]] != 0;
}
