/*
 * manifold_lattice.c: the depth of the lattice's points, and the points of the surface on its edges.
 *
 * A crossing is estimated from the depths of its ends first. The edge is searched only if the crossing becomes a
 * vertex: a third of them do, since a point that is moved onto the surface takes the place of all its crossings.
 */
#include <math.h>
#include <string.h>

#include "manifold/manifold_internal.h"

/* [m] a point that is less deep is outside: rounding does not decide where a plane of points lies in a flat wall, as
 * that between the legs */
#define BCC_FLAT 1e-6

/* a crossing that is nearer to an end of its edge than this share of it is moved to there, so that two of them are two
 * points: 4 micrometres at the default spacing; chosen */
#define BCC_APART 1e-3

/* the search for a point of the surface on an edge ends at a depth of [m], or after so many steps */
#define BCC_CLOSE 1e-9
#define BCC_STEPS 60

#define BCC_FAR 1e29 /* a depth beyond it is not known */


int32_t mus__bcc_crossing(const mus__bcc *lattice, int32_t point, int32_t d)
{
    if (d >= MUS__OWNED) point = mus__bcc_next(lattice, point, d), d -= MUS__OWNED;
    int32_t before = 0;
    for (uint32_t mask = lattice->differ[point] & ((1u << d) - 1); mask != 0; mask &= mask - 1) before++;
    return lattice->cell_first[point / MUS__CELL_POINTS] + lattice->slot[point] + before;
}


/* place (3) of a point [m] */
static void bcc_place(const mus__bcc *lattice, int32_t point, double *x)
{
    const int32_t *cell = lattice->corner + 3 * (ptrdiff_t)(point / MUS__CELL_POINTS);
    const double shift = (point & 8) != 0 ? 0.5 : 0.0;
    for (int i = 0; i < 3; i++)
        x[i] = lattice->origin[i] + lattice->spacing * (2 * cell[i] + (point >> i & 1) + shift);
}


/* depth and label of the points of a cell */
static void bcc_fill(mus__bcc *lattice, int32_t cell)
{
    const int32_t *near = lattice->near + lattice->solid_first[cell];
    const int32_t n = lattice->solid_first[cell + 1] - lattice->solid_first[cell], first = cell * MUS__CELL_POINTS;
    double x[3 * MUS__CELL_POINTS], depth[MUS__CELL_POINTS];
    for (int32_t i = 0; i < MUS__CELL_POINTS; i++) bcc_place(lattice, first + i, x + 3 * i);
    mus__solids_depth(lattice->solids, n, near, lattice->spacing, MUS__CELL_POINTS, x, depth);
    for (int32_t i = 0; i < MUS__CELL_POINTS; i++) {
        lattice->depth[first + i] = depth[i] > 0.0 && depth[i] < BCC_FLAT ? 0.0f : (float)depth[i];
        lattice->label[first + i] = lattice->depth[first + i] > 0.0f ? MUS__POINT_IN : 0;
    }
}


static void bcc_fill_cells(void *user, int32_t part, int32_t parts)
{
    mus__bcc *lattice = user;
    const int32_t n = lattice->cells - lattice->filled, end = mus__share(n, part + 1, parts);
    for (int32_t c = mus__share(n, part, parts); c < end; c++) bcc_fill(lattice, lattice->filled + c);
}


mus_status mus__bcc_room(mus__bcc *lattice)
{
    mus_context *context = lattice->context;
    const int64_t points = (int64_t)lattice->cells * MUS__CELL_POINTS;
    mus_status status = mus__reserve(context, &lattice->depth, &lattice->depth_room, points, sizeof *lattice->depth);
    if (status == MUS_OK)
        status = mus__reserve(context, &lattice->label, &lattice->label_room, points, sizeof *lattice->label);
    if (status == MUS_OK)
        status = mus__reserve(context, &lattice->differ, &lattice->differ_room, points, sizeof *lattice->differ);
    return status;
}


mus_status mus__bcc_sample(mus__bcc *lattice)
{
    mus_status status = mus__bcc_room(lattice);
    if (status != MUS_OK) return status;
    for (int32_t i = 0; i < MUS__CELL_POINTS && lattice->filled == 0; i++) {
        const int32_t in = MUS__CELL_IN * MUS__CELL_POINTS + i, out = MUS__CELL_OUT * MUS__CELL_POINTS + i;
        lattice->label[out] = 0, lattice->depth[out] = -1e30f;
        lattice->label[in] = MUS__POINT_IN, lattice->depth[in] = 1e30f;
    }
    if (lattice->filled == 0) lattice->filled = MUS__CELLS_SHARED;
    mus__pool_run(lattice->pool, bcc_fill_cells, lattice);
    lattice->filled = lattice->cells;
    return MUS_OK;
}


void mus__bcc_compare(mus__bcc *lattice, int32_t from)
{
    for (int32_t point = from * MUS__CELL_POINTS; point < lattice->cells * MUS__CELL_POINTS; point++) {
        const uint32_t in = lattice->label[point] & MUS__POINT_IN;
        uint32_t mask = 0;
        for (int32_t d = 0; d < MUS__LINKS; d++)
            mask |= ((lattice->label[mus__bcc_next(lattice, point, d)] & MUS__POINT_IN) ^ in) << d;
        lattice->differ[point] = (uint16_t)mask;
    }
}


void mus__bcc_flip(mus__bcc *lattice, int32_t point)
{
    lattice->label[point] ^= MUS__POINT_IN;
    lattice->differ[point] ^= (1u << MUS__LINKS) - 1;
    for (int32_t d = 0; d < MUS__LINKS; d++)
        lattice->differ[mus__bcc_next(lattice, point, d)] ^= (uint16_t)(1u << mus__bcc_opposite(d));
}


mus_status mus__bcc_beside(mus__bcc *lattice, int32_t from)
{
    mus_status status = MUS_OK;
    for (int32_t point = from * MUS__CELL_POINTS; point < lattice->cells * MUS__CELL_POINTS; point++)
        for (int32_t d = 0; d < MUS__LINKS && lattice->differ[point] != 0; d++) {
            if ((lattice->differ[point] >> d & 1) == 0) continue;
            const int32_t next = mus__bcc_next(lattice, point, d);
            if (!mus__bcc_shared(next)) continue;
            const uint8_t label = lattice->label[next];
            const int32_t place = lattice->place[point / MUS__CELL_POINTS], cell = lattice->cells;
            status = mus__bcc_open(lattice, place + lattice->step[point % MUS__CELL_POINTS][d].cell, true);
            if (status == MUS_OK) status = mus__bcc_sample(lattice);
            if (status != MUS_OK) return status;
            memset(lattice->label + (ptrdiff_t)cell * MUS__CELL_POINTS, label, MUS__CELL_POINTS);
            mus__bcc_compare(lattice, cell);
        }
    return status;
}


/* the solids near either end of an edge, ascending, in `list` (MUS__SOLIDS_MOST); returns their number */
static int32_t bcc_near(const mus__bcc *lattice, int32_t from, int32_t to, int32_t *list)
{
    const int32_t cell[2] = {from / MUS__CELL_POINTS, to / MUS__CELL_POINTS};
    const int32_t *one = lattice->near + lattice->solid_first[cell[0]], *two = lattice->near;
    const int32_t *one_end = lattice->near + lattice->solid_first[cell[0] + 1], *two_end = two;
    int32_t n = 0;
    if (cell[1] != cell[0]) two += lattice->solid_first[cell[1]], two_end += lattice->solid_first[cell[1] + 1];
    while (one < one_end || two < two_end) {
        const int32_t a = one < one_end ? *one : INT32_MAX, b = two < two_end ? *two : INT32_MAX;
        one += a <= b, two += b <= a;
        list[n++] = a < b ? a : b;
    }
    return n;
}


/* the place of the surface on the edge between two points, 0 at the first one, which lies at x (3); `step` is the
 * edge's direction. By false position (Illinois) */
static double bcc_root(const mus__bcc *lattice, int32_t point, int32_t next, const double *x, const int8_t *step)
{
    int32_t near[MUS__SOLIDS_MOST];
    const int32_t n = bcc_near(lattice, point, next, near);
    const double scale = 0.5 * lattice->spacing;
    double f0 = (double)lattice->depth[point], f1 = (double)lattice->depth[next], low = 0.0, high = 1.0, t = 0.5;
    int side = 0;
    for (int i = 0; i < BCC_STEPS && high - low > 1e-9; i++) {
        const bool far = fabs(f0) > BCC_FAR || fabs(f1) > BCC_FAR;
        t = far ? 0.5 * (low + high) : (low * f1 - high * f0) / (f1 - f0);
        if (!(t > low && t < high)) t = 0.5 * (low + high);
        const double at[3] = {x[0] + t * scale * step[0], x[1] + t * scale * step[1], x[2] + t * scale * step[2]};
        double f;
        mus__solids_depth(lattice->solids, n, near, lattice->spacing, 1, at, &f);
        if (fabs(f) < BCC_CLOSE) break;
        if ((f > 0.0) == (f0 > 0.0)) {
            low = t, f0 = f;
            if (side > 0 && !far) f1 *= 0.5;
            side = 1;
        } else {
            high = t, f1 = f;
            if (side < 0 && !far) f0 *= 0.5;
            side = -1;
        }
    }
    return t;
}


void mus__bcc_search(mus__bcc *lattice, int32_t point, int32_t d)
{
    if (d >= MUS__OWNED) point = mus__bcc_next(lattice, point, d), d -= MUS__OWNED;
    const int32_t at = mus__bcc_crossing(lattice, point, d), next = mus__bcc_next(lattice, point, d);
    double x[3], t = (double)lattice->part[at];
    bcc_place(lattice, point, x);
    if (lattice->state[at] == MUS__EDGE_ESTIMATE) {
        t = bcc_root(lattice, point, next, x, mus__bcc_step[d]);
        lattice->state[at] = MUS__EDGE_FOUND;
        lattice->part[at] = (float)t;
    }
    for (int i = 0; i < 3; i++)
        lattice->crossing[3 * (ptrdiff_t)at + i] = x[i] + t * 0.5 * lattice->spacing * mus__bcc_step[d][i];
}


/* estimates of the crossings of a share of the cells */
static void bcc_estimate(void *user, int32_t part, int32_t parts)
{
    mus__bcc *lattice = user;
    const int32_t end = mus__share(lattice->cells, part + 1, parts) * MUS__CELL_POINTS;
    for (int32_t point = mus__share(lattice->cells, part, parts) * MUS__CELL_POINTS; point < end; point++) {
        if (mus__bcc_shared(point)) continue;
        int32_t at = lattice->cell_first[point / MUS__CELL_POINTS] + lattice->slot[point];
        for (int32_t d = 0; d < MUS__OWNED; d++) {
            if ((lattice->differ[point] >> d & 1) == 0) continue;
            const double f0 = (double)lattice->depth[point];
            const double f1 = (double)lattice->depth[mus__bcc_next(lattice, point, d)];
            const bool cut = f0 > 0.0 && f1 > 0.0, far = fabs(f0) > BCC_FAR || fabs(f1) > BCC_FAR;
            lattice->state[at] = cut ? MUS__EDGE_CUT : MUS__EDGE_ESTIMATE;
            lattice->part[at] = cut || far ? 0.5f : (float)(f0 / (f0 - f1));
            if (far && !cut) mus__bcc_search(lattice, point, d);
            at++;
        }
    }
}


/* that of the solid's simplices, twice: each is shared equally among its vertices. A point without a neighbour outside
 * gives 1 - 14/2 + 36/3 - 24/4 = 0 */
int32_t mus__bcc_euler(const mus__bcc *lattice)
{
    int64_t sum = 0;
    for (int32_t point = MUS__CELLS_SHARED * MUS__CELL_POINTS; point < lattice->cells * MUS__CELL_POINTS; point++) {
        int32_t edges, triangles;
        if (lattice->differ[point] == 0 || (lattice->label[point] & MUS__POINT_IN) == 0) continue;
        const uint32_t in = ~(uint32_t)lattice->differ[point] & ((1u << MUS__LINKS) - 1);
        const int32_t vertices = mus__bcc_link(lattice, in, &edges, &triangles);
        sum += 12 - 6 * vertices + 4 * edges - 3 * triangles;
    }
    return (int32_t)(sum / 6);
}


mus_status mus__bcc_cross(mus__bcc *lattice)
{
    mus_context *context = lattice->context;
    const int64_t points = (int64_t)lattice->cells * MUS__CELL_POINTS;
    lattice->slot = mus__new(context, points, sizeof *lattice->slot);
    lattice->cell_first = mus__new(context, (int64_t)lattice->cells + 1, sizeof *lattice->cell_first);
    if (!lattice->slot || !lattice->cell_first) return mus__fail_memory(context, "the surface of a manifold");
    int32_t sum = 0;
    for (int32_t c = MUS__CELLS_SHARED; c < lattice->cells; c++) {
        lattice->cell_first[c] = sum;
        for (int32_t point = c * MUS__CELL_POINTS; point < (c + 1) * MUS__CELL_POINTS; point++) {
            lattice->slot[point] = (uint8_t)(sum - lattice->cell_first[c]);
            for (uint32_t m = lattice->differ[point] & ((1u << MUS__OWNED) - 1); m != 0; m &= m - 1) sum++;
        }
    }
    lattice->cell_first[lattice->cells] = lattice->crossings = sum;
    lattice->crossing = mus__room(context, 3 * (int64_t)sum, sizeof *lattice->crossing);
    lattice->state = mus__room(context, sum, sizeof *lattice->state);
    lattice->part = mus__room(context, sum, sizeof *lattice->part);
    if (!lattice->crossing || !lattice->state || !lattice->part)
        return mus__fail_memory(context, "the surface of a manifold");
    mus__pool_run(lattice->pool, bcc_estimate, lattice);
    return MUS_OK;
}


/* move a crossing that is nearly at an end of its edge a little away from it */
static void bcc_part(mus__bcc *lattice, int32_t point, int32_t d, int32_t at)
{
    const double t = (double)lattice->part[at], apart = fmin(fmax(t, BCC_APART), 1.0 - BCC_APART);
    double x[3];
    if (t == apart) return;
    bcc_place(lattice, point, x);
    for (int i = 0; i < 3; i++)
        lattice->crossing[3 * (ptrdiff_t)at + i] = x[i] + apart * 0.5 * lattice->spacing * mus__bcc_step[d][i];
}


/* the vertices on edges of a share of the cells whose ends were not moved */
static void bcc_polish(void *user, int32_t part, int32_t parts)
{
    mus__bcc *lattice = user;
    const int32_t end = mus__share(lattice->cells, part + 1, parts) * MUS__CELL_POINTS;
    for (int32_t point = mus__share(lattice->cells, part, parts) * MUS__CELL_POINTS; point < end; point++) {
        if (mus__bcc_shared(point) || (lattice->label[point] & MUS__POINT_ON) != 0) continue;
        int32_t at = lattice->cell_first[point / MUS__CELL_POINTS] + lattice->slot[point];
        for (int32_t d = 0; d < MUS__OWNED; d++) {
            if ((lattice->differ[point] >> d & 1) == 0) continue;
            if ((lattice->moved[point] >> d & 1) == 0) {
                mus__bcc_search(lattice, point, d);
                bcc_part(lattice, point, d, at);
            }
            at++;
        }
    }
}


void mus__bcc_polish(mus__bcc *lattice)
{
    mus__pool_run(lattice->pool, bcc_polish, lattice);
}
