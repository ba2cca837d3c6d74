/*
 * manifold_lattice.c: the lattice near a body: blocks, the depth of its points, and points of the surface on its edges.
 */
#include <math.h>
#include <string.h>

#include "manifold/manifold_internal.h"

/* share of the spacing by which the lattice is shifted up and forwards: planes of points then do not lie in the floor,
 * on which the soles are flat; chosen. The body's middle plane is one of the lattice, so that legs that nearly touch
 * are parted */
#define BCC_UP 0.37
#define BCC_FORWARD 0.29

/* [m] a point that is less deep is outside: rounding does not decide where a plane of points lies in a flat wall, as
 * that between the legs */
#define BCC_FLAT 1e-6

/* a crossing that is nearer to an end of its edge than this share of it is moved to there, so that two of them are two
 * points: 4 micrometres at the default spacing; chosen */
#define BCC_APART 1e-3

/* most active blocks: 2^30 points */
#define BCC_BLOCKS (INT32_C(1) << 20)

/* the search for a point of the surface on an edge ends at a depth of [m], or after so many steps */
#define BCC_CLOSE 1e-9
#define BCC_STEPS 60

const int8_t mus__bcc_step[MUS__LINKS][3] = {
    {2, 0, 0},  {0, 2, 0},  {0, 0, 2},  {1, -1, -1}, {1, 1, -1},  {1, -1, 1},  {1, 1, 1},
    {-2, 0, 0}, {0, -2, 0}, {0, 0, -2}, {-1, 1, 1},  {-1, -1, 1}, {-1, 1, -1}, {-1, -1, -1}};


int32_t mus__bcc_beyond(const mus__bcc *lattice, uint32_t block, int32_t odd, int32_t i, int32_t j, int32_t k)
{
    const int32_t *at = lattice->place + 3 * (ptrdiff_t)block, *grid = lattice->grid, n = MUS__BLOCK;
    const int32_t a = at[0] + (i >= n) - (i < 0), b = at[1] + (j >= n) - (j < 0), c = at[2] + (k >= n) - (k < 0);
    if (a < 0 || b < 0 || c < 0 || a >= grid[0] || b >= grid[1] || c >= grid[2]) return MUS_NONE;
    const int32_t next = lattice->table[((ptrdiff_t)c * grid[1] + b) * grid[0] + a];
    const int32_t cell = ((k & (n - 1)) * n + (j & (n - 1))) * n + (i & (n - 1));
    return next == MUS_NONE ? MUS_NONE : next * MUS__BLOCK_POINTS + odd * MUS__BLOCK_CELLS + cell;
}


int32_t mus__bcc_crossing(const mus__bcc *lattice, int32_t point, int32_t d)
{
    if (d >= MUS__OWNED) point = mus__bcc_next(lattice, point, d), d -= MUS__OWNED;
    int32_t before = 0;
    for (uint32_t mask = lattice->crossed[point] & ((1u << d) - 1); mask != 0; mask &= mask - 1) before++;
    return lattice->block_first[point / MUS__BLOCK_POINTS] + lattice->slot[point] + before;
}


bool mus__bcc_plain(const mus__bcc *lattice, int32_t block)
{
    const int32_t *at = lattice->place + 3 * (ptrdiff_t)block, *grid = lattice->grid;
    if (lattice->kind[block] > 1) return false;
    for (int32_t k = at[2] - 1; k <= at[2] + 1; k++)
        for (int32_t j = at[1] - 1; j <= at[1] + 1; j++)
            for (int32_t i = at[0] - 1; i <= at[0] + 1; i++) {
                int32_t next = MUS_NONE;
                if (i >= 0 && j >= 0 && k >= 0 && i < grid[0] && j < grid[1] && k < grid[2])
                    next = lattice->table[((ptrdiff_t)k * grid[1] + j) * grid[0] + i];
                if ((next == MUS_NONE ? 0 : lattice->kind[next]) != lattice->kind[block]) return false;
            }
    return true;
}


/* whether a block, widened by two spacings, touches a solid */
static bool bcc_touches(const mus__bcc *lattice, const int32_t *place, const mus__solid *solid)
{
    const double half = (0.5 * MUS__BLOCK + 2.0) * lattice->spacing;
    double middle[3];
    for (int i = 0; i < 3; i++) {
        middle[i] = lattice->origin[i] + (place[i] + 0.5) * MUS__BLOCK * lattice->spacing;
        if (solid->low[i] > middle[i] + half || solid->high[i] < middle[i] - half) return false;
    }
    return mus__solid_near(solid, middle, sqrt(3.0) * half);
}


/* the grid of blocks about all solids. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY */
static mus_status bcc_grid(mus__bcc *lattice)
{
    const double wide = MUS__BLOCK * lattice->spacing;
    const double shift[3] = {0.0, BCC_UP * lattice->spacing, BCC_FORWARD * lattice->spacing};
    double cells = 1.0;
    for (int i = 0; i < 3; i++) {
        double low = INFINITY, high = -INFINITY;
        for (int32_t s = 0; s < lattice->solids->count; s++) {
            low = fmin(low, lattice->solids->solid[s].low[i]);
            high = fmax(high, lattice->solids->solid[s].high[i]);
        }
        const double first = floor((low - shift[i] - 3.0 * lattice->spacing) / wide);
        const double last = ceil((high - shift[i] + 3.0 * lattice->spacing) / wide);
        if (!(last - first >= 1.0 && last - first < 1e6))
            return mus__fail(lattice->context, MUS_ERR_ARG, "a manifold of %g m with a spacing of %g m is too large",
                             high - low, lattice->spacing);
        cells *= last - first;
        lattice->origin[i] = first * wide + shift[i];
        lattice->grid[i] = (int32_t)(last - first);
    }
    if (cells > 1e9)
        return mus__fail(lattice->context, MUS_ERR_ARG, "spacing %g m is too small for this body: %.0f blocks",
                         lattice->spacing, cells);
    lattice->table = mus__room(lattice->context, (int64_t)cells, sizeof *lattice->table);
    return lattice->table != NULL ? MUS_OK : mus__fail_memory(lattice->context, "the lattice of a manifold");
}


/* find the active blocks and their solids: with `place` NULL they are counted only. Returns the entries of `near` */
static int64_t bcc_active(mus__bcc *lattice)
{
    int64_t entries = 0;
    int32_t blocks = 0;
    for (int32_t k = 0; k < lattice->grid[2]; k++)
        for (int32_t j = 0; j < lattice->grid[1]; j++)
            for (int32_t i = 0; i < lattice->grid[0]; i++) {
                const int32_t place[3] = {i, j, k};
                const int64_t before = entries;
                for (int32_t s = 0; s < lattice->solids->count; s++) {
                    if (!bcc_touches(lattice, place, &lattice->solids->solid[s])) continue;
                    if (lattice->near != NULL) lattice->near[entries] = s;
                    entries++;
                }
                int32_t *to = &lattice->table[((ptrdiff_t)k * lattice->grid[1] + j) * lattice->grid[0] + i];
                *to = entries > before ? blocks : MUS_NONE;
                if (entries == before) continue;
                if (lattice->place != NULL) {
                    memcpy(lattice->place + 3 * (ptrdiff_t)blocks, place, sizeof place);
                    lattice->solid_first[blocks] = (int32_t)before;
                    lattice->solid_first[blocks + 1] = (int32_t)entries;
                }
                blocks++;
            }
    lattice->blocks = blocks;
    return entries;
}


/* arrays of the active blocks. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
static mus_status bcc_blocks(mus__bcc *lattice)
{
    const int64_t entries = bcc_active(lattice), points = (int64_t)lattice->blocks * MUS__BLOCK_POINTS;
    mus_context *context = lattice->context;
    if (lattice->blocks > BCC_BLOCKS || entries > INT32_MAX)
        return mus__fail(context, MUS_ERR_ARG, "spacing %g m is too small for this body: more than %d blocks",
                         lattice->spacing, (int)BCC_BLOCKS);
    lattice->place = mus__room(context, 3 * (int64_t)lattice->blocks, sizeof *lattice->place);
    lattice->solid_first = mus__new(context, (int64_t)lattice->blocks + 1, sizeof *lattice->solid_first);
    lattice->block_first = mus__new(context, (int64_t)lattice->blocks + 1, sizeof *lattice->block_first);
    lattice->near = mus__room(context, entries, sizeof *lattice->near);
    lattice->kind = mus__new(context, lattice->blocks, sizeof *lattice->kind);
    lattice->depth = mus__room(context, points, sizeof *lattice->depth);
    lattice->label = mus__room(context, points, sizeof *lattice->label);
    lattice->crossed = mus__new(context, points, sizeof *lattice->crossed);
    lattice->slot = mus__new(context, points, sizeof *lattice->slot);
    if (!lattice->place || !lattice->solid_first || !lattice->block_first || !lattice->near || !lattice->kind ||
        !lattice->depth || !lattice->label || !lattice->crossed || !lattice->slot)
        return mus__fail_memory(context, "the lattice of a manifold");
    bcc_active(lattice);
    return MUS_OK;
}


/* place (3) of a point [m] */
static void bcc_point(const mus__bcc *lattice, int32_t point, double *x)
{
    const int32_t n = MUS__BLOCK, at[3] = {point % n, point / n % n, point / (n * n) % n};
    const int32_t *block = lattice->place + 3 * (ptrdiff_t)(point / MUS__BLOCK_POINTS);
    const double shift = point / MUS__BLOCK_CELLS % 2 != 0 ? 0.5 : 0.0;
    for (int i = 0; i < 3; i++) x[i] = lattice->origin[i] + lattice->spacing * (n * block[i] + at[i] + shift);
}


static void bcc_sample(void *user, int32_t part, int32_t parts)
{
    mus__bcc *lattice = user;
    const int32_t end = mus__share(lattice->blocks, part + 1, parts);
    for (int32_t b = mus__share(lattice->blocks, part, parts); b < end; b++) {
        const int32_t *near = lattice->near + lattice->solid_first[b];
        const int32_t n = lattice->solid_first[b + 1] - lattice->solid_first[b];
        int32_t inside = 0;
        for (int32_t i = 0; i < MUS__BLOCK_POINTS; i++) {
            const int32_t point = b * MUS__BLOCK_POINTS + i;
            double x[3];
            bcc_point(lattice, point, x);
            const double depth = mus__solids_depth(lattice->solids, n, near, x, lattice->spacing);
            lattice->depth[point] = depth > 0.0 && depth < BCC_FLAT ? 0.0f : (float)depth;
            lattice->label[point] = lattice->depth[point] > 0.0f ? MUS__POINT_IN : 0;
            inside += lattice->label[point];
        }
        lattice->kind[b] = inside == 0 ? 0 : inside == MUS__BLOCK_POINTS ? 1 : 2;
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
    for (int32_t d = 0; d < MUS__LINKS; d++)
        for (int32_t e = 0; e < MUS__LINKS; e++) {
            const int8_t *p = mus__bcc_step[d], *q = mus__bcc_step[e];
            const int32_t x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2], square = x * x + y * y + z * z;
            const bool is_long = square == 4 && (x == 0) + (y == 0) + (z == 0) == 2;
            if (square == 3 || is_long) out->touch[d] |= (uint16_t)(1u << e);
        }
    mus_status status = bcc_grid(out);
    if (status == MUS_OK) status = bcc_blocks(out);
    if (status == MUS_OK) mus__pool_run(pool, bcc_sample, out);
    return status;
}


void mus__bcc_free(mus__bcc *lattice)
{
    mus_context *context = lattice->context;
    mus__free(context, lattice->table);
    mus__free(context, lattice->place);
    mus__free(context, lattice->solid_first);
    mus__free(context, lattice->near);
    mus__free(context, lattice->depth);
    mus__free(context, lattice->label);
    mus__free(context, lattice->kind);
    mus__free(context, lattice->crossed);
    mus__free(context, lattice->slot);
    mus__free(context, lattice->block_first);
    mus__free(context, lattice->crossing);
    mus__free(context, lattice->cut);
    mus__free(context, lattice->part);
}


/* the place of the surface on the edge from x along `way` (3), 0 to 1, between an end inside at depth f0 and one
 * outside at f1, or the other way round; by false position (Illinois) */
static double bcc_root(const mus__bcc *lattice, int32_t block, const double *x, const double *way, double f0,
                           double f1)
{
    const int32_t *near = lattice->near + lattice->solid_first[block];
    const int32_t n = lattice->solid_first[block + 1] - lattice->solid_first[block];
    double low = 0.0, high = 1.0, t = 0.5;
    int side = 0;
    for (int step = 0; step < BCC_STEPS && high - low > 1e-9; step++) {
        const bool far = f0 < -1e29 || f1 < -1e29;
        t = far ? 0.5 * (low + high) : (low * f1 - high * f0) / (f1 - f0);
        if (!(t > low && t < high)) t = 0.5 * (low + high);
        const double at[3] = {x[0] + t * way[0], x[1] + t * way[1], x[2] + t * way[2]};
        const double f = mus__solids_depth(lattice->solids, n, near, at, lattice->spacing);
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


/* bits of the owned edges of a block's points that cross the surface; block_first gets their number */
static void bcc_mark(void *user, int32_t part, int32_t parts)
{
    mus__bcc *lattice = user;
    const int32_t end = mus__share(lattice->blocks, part + 1, parts);
    for (int32_t b = mus__share(lattice->blocks, part, parts); b < end; b++) {
        int32_t count = 0;
        const bool plain = mus__bcc_plain(lattice, b);
        for (int32_t i = 0; i < MUS__BLOCK_POINTS; i++) {
            const int32_t point = b * MUS__BLOCK_POINTS + i, in = lattice->label[point] & MUS__POINT_IN;
            uint32_t mask = 0;
            lattice->slot[point] = (uint16_t)count;
            for (int32_t d = 0; d < MUS__OWNED && !plain; d++) {
                const int32_t next = mus__bcc_next(lattice, point, d);
                if ((next == MUS_NONE ? 0 : lattice->label[next] & MUS__POINT_IN) != in) mask |= 1u << d, count++;
            }
            lattice->crossed[point] = (uint8_t)mask;
        }
        lattice->block_first[b] = count;
    }
}


static void bcc_find(void *user, int32_t part, int32_t parts)
{
    mus__bcc *lattice = user;
    const int32_t end = mus__share(lattice->blocks, part + 1, parts);
    const int32_t first = mus__share(lattice->blocks, part, parts);
    for (int32_t point = first * MUS__BLOCK_POINTS; point < end * MUS__BLOCK_POINTS; point++) {
        if (lattice->crossed[point] == 0) continue;
        double x[3], way[3];
        bcc_point(lattice, point, x);
        for (int32_t d = 0; d < MUS__OWNED; d++) {
            if ((lattice->crossed[point] >> d & 1) == 0) continue;
            const int32_t next = mus__bcc_next(lattice, point, d), at = mus__bcc_crossing(lattice, point, d);
            const double f0 = (double)lattice->depth[point];
            const double f1 = next == MUS_NONE ? -1e30 : (double)lattice->depth[next];
            for (int i = 0; i < 3; i++) way[i] = 0.5 * lattice->spacing * mus__bcc_step[d][i];
            lattice->cut[at] = f0 > 0.0 && f1 > 0.0;
            const double t = lattice->cut[at] ? 0.5 : bcc_root(lattice, point / MUS__BLOCK_POINTS, x, way, f0, f1);
            lattice->part[at] = (float)t;
            for (int i = 0; i < 3; i++) lattice->crossing[3 * (ptrdiff_t)at + i] = x[i] + t * way[i];
        }
    }
}


mus_status mus__bcc_cross(mus__bcc *lattice)
{
    mus_context *context = lattice->context;
    mus__free(context, lattice->crossing);
    mus__free(context, lattice->cut);
    mus__free(context, lattice->part);
    mus__pool_run(lattice->pool, bcc_mark, lattice);
    int64_t sum = 0;
    for (int32_t b = 0; b <= lattice->blocks; b++) {
        const int32_t count = b < lattice->blocks ? lattice->block_first[b] : 0;
        lattice->block_first[b] = (int32_t)sum;
        sum += count;
    }
    lattice->crossing = mus__room(context, 3 * sum, sizeof *lattice->crossing);
    lattice->cut = mus__room(context, sum, sizeof *lattice->cut);
    lattice->part = mus__room(context, sum, sizeof *lattice->part);
    if (!lattice->crossing || !lattice->cut || !lattice->part || sum > INT32_MAX / 8)
        return mus__fail_memory(context, "the surface of a manifold");
    mus__pool_run(lattice->pool, bcc_find, lattice);
    return MUS_OK;
}


void mus__bcc_part(mus__bcc *lattice)
{
    for (int32_t point = 0; point < lattice->blocks * MUS__BLOCK_POINTS; point++) {
        if (lattice->crossed[point] == 0 || (lattice->label[point] & MUS__POINT_ON) != 0) continue;
        for (int32_t d = 0; d < MUS__OWNED; d++) {
            if ((lattice->crossed[point] >> d & 1) == 0) continue;
            const int32_t next = mus__bcc_next(lattice, point, d), at = mus__bcc_crossing(lattice, point, d);
            const double t = (double)lattice->part[at], apart = fmin(fmax(t, BCC_APART), 1.0 - BCC_APART);
            double x[3];
            if (t == apart || (next != MUS_NONE && (lattice->label[next] & MUS__POINT_ON) != 0)) continue;
            bcc_point(lattice, point, x);
            for (int i = 0; i < 3; i++)
                lattice->crossing[3 * (ptrdiff_t)at + i] = x[i] + apart * 0.5 * lattice->spacing * mus__bcc_step[d][i];
        }
    }
}
