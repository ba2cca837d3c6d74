/*
 * triangulate.c: constrained Delaunay triangulation by insertion and flips.
 *
 *   1. Each point is inserted into a triangulation that starts with one outer triangle: walk to the triangle that
 *      contains the point, split it (1 into 3, or on an edge 2 into 4), and flip edges until every circumcircle is
 *      empty (Lawson 1977).
 *   2. Each side of the polygon that is not an edge becomes one by flipping the edges that cross it. The new edges are
 *      flipped again where they are not Delaunay; sides are never flipped (Sloan 1993).
 *   3. Triangles that can be reached from the outer triangle without crossing a side are removed.
 *
 * Points are inserted in rounds of about four times as many points each, and along a Hilbert curve within a round.
 * Walks are short then, and so are the sequences of flips, other than with sorted rows (Amenta, Choi and Rote 2003).
 * All decisions are signs of exact predicates, and edges with four points on a circle are not flipped, so that the
 * flips end on lattices too.
 *
 * Triangle t has corners v[3t .. 3t+2], counter-clockwise; across[3t+k] is the triangle beyond the edge opposite to
 * corner k, which runs from corner k+1 to corner k+2. Three vertices n, n+1, n+2 span the outer triangle.
 * Source: Sloan, A fast algorithm for generating constrained Delaunay triangulations, Computers & Structures 47, 1993.
 */
#include <math.h>
#include <string.h>

#include "geom/predicate.h"
#include "geom/triangulate.h"

/* most points: the index of a corner of more would overflow 32 bits */
#define TRIANGULATE_MOST (1 << 28)
/* distance of the outer triangle, in extents of the points; chosen: a nearer one needs more flips to recover sides */
#define TRIANGULATE_FAR 32.0
/* rounds of insertion; each has four times the points of the one before, the first has the rest */
#define TRIANGULATE_ROUNDS 8

typedef struct tri_mesh {
    mus_context *context;
    int32_t n, count, last;            /* points; triangles; triangle at which the next walk starts */
    double *xy;                        /* (n + 3) x 2 */
    int32_t *v, *across;               /* (triangles x 3) */
    unsigned char *fixed;              /* (triangles x 3): 1 when the edge opposite to this corner is a side */
    int32_t *of;                       /* (n + 3): one triangle at each vertex */
    int32_t *order;                    /* (n): points in the order of insertion */
    int32_t *stack, nstack, cap_stack; /* edges to test for the empty circle, as pairs of vertices */
    int32_t *queue, nqueue, cap_queue; /* edges that cross the side being recovered, as pairs of vertices */
} tri_mesh;


static int32_t tri_turn(int32_t k)
{
    return k == 2 ? 0 : k + 1;
}


static const double *tri_point(const tri_mesh *mesh, int32_t i)
{
    return mesh->xy + 2 * (ptrdiff_t)i;
}


static int32_t tri_corner(const tri_mesh *mesh, int32_t t, int32_t vertex)
{
    const int32_t *v = mesh->v + 3 * (ptrdiff_t)t;
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
}


static double tri_side(const tri_mesh *mesh, int32_t a, int32_t b, int32_t c)
{
    return mus__orient2d(tri_point(mesh, a), tri_point(mesh, b), tri_point(mesh, c));
}


/* Writes triangle t: its corners and the neighbours opposite to them. */
static void tri_write(tri_mesh *mesh, int32_t t, int32_t a, int32_t b, int32_t c, const int32_t *beyond,
                      const unsigned char *fixed)
{
    int32_t *v = mesh->v + 3 * (ptrdiff_t)t;
    v[0] = a, v[1] = b, v[2] = c;
    for (int32_t k = 0; k < 3; k++) {
        mesh->across[3 * t + k] = beyond[k];
        mesh->fixed[3 * t + k] = fixed[k];
        mesh->of[v[k]] = t;
    }
}


/* Replaces neighbour `old` of triangle t by `now`. */
static void tri_relink(tri_mesh *mesh, int32_t t, int32_t old, int32_t now)
{
    if (t == MUS_NONE) return;
    for (int32_t k = 0; k < 3; k++)
        if (mesh->across[3 * t + k] == old) {
            mesh->across[3 * t + k] = now;
            return;
        }
}


static mus_status tri_push(tri_mesh *mesh, int32_t a, int32_t b)
{
    mus_status status =
        mus__reserve(mesh->context, &mesh->stack, &mesh->cap_stack, (int64_t)mesh->nstack + 2, sizeof a);
    if (status != MUS_OK) return status;
    mesh->stack[mesh->nstack++] = a, mesh->stack[mesh->nstack++] = b;
    return MUS_OK;
}


static mus_status tri_enqueue(tri_mesh *mesh, int32_t a, int32_t b)
{
    mus_status status =
        mus__reserve(mesh->context, &mesh->queue, &mesh->cap_queue, (int64_t)mesh->nqueue + 2, sizeof a);
    if (status != MUS_OK) return status;
    mesh->queue[mesh->nqueue++] = a, mesh->queue[mesh->nqueue++] = b;
    return MUS_OK;
}


/* Finds the triangle *t with the edge a b counter-clockwise, and its corner *k opposite to the edge, by turning round
 * vertex a. Returns false when there is none. */
static bool tri_turn_round(const tri_mesh *mesh, int32_t a, int32_t b, int32_t *t, int32_t *k)
{
    int32_t start = mesh->of[a], at = start;
    do {
        int32_t corner = tri_corner(mesh, at, a), next = tri_turn(corner);
        if (mesh->v[3 * at + next] == b) {
            *t = at, *k = tri_turn(next);
            return true;
        }
        at = mesh->across[3 * at + next];
    } while (at != start && at != MUS_NONE);
    return false;
}


/* As tri_turn_round(), for any two vertices. */
static bool tri_find_edge(const tri_mesh *mesh, int32_t a, int32_t b, int32_t *t, int32_t *k)
{
    if (a < mesh->n) return tri_turn_round(mesh, a, b, t, k);

    /* an outer vertex has many triangles, and they do not close round it: turn round the other end, then cross */
    int32_t u, j;
    if (b >= mesh->n || !tri_turn_round(mesh, b, a, &u, &j)) return false;
    *t = mesh->across[3 * u + j];
    *k = 3 - tri_corner(mesh, *t, a) - tri_corner(mesh, *t, b);
    return true;
}


/*
 * Flips the edge opposite to corner k of triangle t; the four points must form a strictly convex quadrilateral.
 *
 *       c              c
 *      /|\            / \
 *     p | q    ->    p---q      t = p b c, u = q c b   ->   t = p b q, u = q c p
 *      \|/            \ /
 *       b              b
 */
static void tri_flip(tri_mesh *mesh, int32_t t, int32_t k)
{
    int32_t u = mesh->across[3 * t + k], k1 = tri_turn(k), k2 = tri_turn(k1);
    int32_t p = mesh->v[3 * t + k], b = mesh->v[3 * t + k1], c = mesh->v[3 * t + k2];
    int32_t j1 = tri_corner(mesh, u, c), j2 = tri_corner(mesh, u, b), j = 3 - j1 - j2, q = mesh->v[3 * u + j];

    int32_t pb = mesh->across[3 * t + k2], cp = mesh->across[3 * t + k1];
    int32_t qc = mesh->across[3 * u + j2], bq = mesh->across[3 * u + j1];
    unsigned char fixed_t[3] = {mesh->fixed[3 * u + j1], 0, mesh->fixed[3 * t + k2]};
    unsigned char fixed_u[3] = {mesh->fixed[3 * t + k1], 0, mesh->fixed[3 * u + j2]};
    tri_relink(mesh, bq, u, t);
    tri_relink(mesh, cp, t, u);
    tri_write(mesh, t, p, b, q, (int32_t[3]){bq, u, pb}, fixed_t);
    tri_write(mesh, u, q, c, p, (int32_t[3]){cp, t, qc}, fixed_u);
}


/* Flips the edges on the stack, and those that flips add to it, until all are Delaunay. Sides are not flipped. */
static mus_status tri_legalise(tri_mesh *mesh)
{
    while (mesh->nstack > 0) {
        int32_t b = mesh->stack[--mesh->nstack], a = mesh->stack[--mesh->nstack], t, k;
        if (!tri_find_edge(mesh, a, b, &t, &k) || mesh->fixed[3 * t + k]) continue;
        int32_t u = mesh->across[3 * t + k];
        if (u == MUS_NONE) continue;

        int32_t p = mesh->v[3 * t + k], q = mesh->v[3 * u + 3 - tri_corner(mesh, u, a) - tri_corner(mesh, u, b)];
        if (mus__incircle(tri_point(mesh, p), tri_point(mesh, a), tri_point(mesh, b), tri_point(mesh, q)) <= 0.0)
            continue;
        tri_flip(mesh, t, k);
        const int32_t rim[4][2] = {{p, a}, {a, q}, {q, b}, {b, p}};
        for (int32_t i = 0; i < 4; i++) {
            mus_status status = tri_push(mesh, rim[i][0], rim[i][1]);
            if (status != MUS_OK) return status;
        }
    }
    return MUS_OK;
}


/* Walks to the triangle that contains point i. *edge is the corner opposite to the edge on which the point lies, or
 * MUS_NONE. */
static mus_status tri_locate(tri_mesh *mesh, int32_t i, int32_t *triangle, int32_t *edge)
{
    const double *p = tri_point(mesh, i);
    int32_t t = mesh->last;
    for (;;) {
        int32_t on = MUS_NONE, zeros = 0, next = MUS_NONE, corner = 0;
        for (int32_t k = 0; k < 3 && next == MUS_NONE; k++) {
            int32_t a = mesh->v[3 * t + tri_turn(k)], b = mesh->v[3 * t + tri_turn(tri_turn(k))];
            double side = mus__orient2d(tri_point(mesh, a), tri_point(mesh, b), p);
            if (side < 0.0) next = mesh->across[3 * t + k];
            if (side == 0.0) on = k, corner += k, zeros++;
        }
        if (next != MUS_NONE) {
            t = next;
            continue;
        }

        /* on two edges: the point is their common corner */
        if (zeros > 1)
            return mus__fail(mesh->context, MUS_ERR_MESH, "points %d and %d are the same (%.9g, %.9g)",
                             (int)mesh->v[3 * t + 3 - corner], (int)i, p[0], p[1]);
        *triangle = t, *edge = on;
        return MUS_OK;
    }
}


/* Inserts point i inside triangle t: three triangles in place of one. */
static void tri_split_inside(tri_mesh *mesh, int32_t i, int32_t t)
{
    static const unsigned char none[3] = {0, 0, 0};
    int32_t a = mesh->v[3 * t], b = mesh->v[3 * t + 1], c = mesh->v[3 * t + 2];
    int32_t bc = mesh->across[3 * t], ca = mesh->across[3 * t + 1], ab = mesh->across[3 * t + 2];
    int32_t u = mesh->count++, w = mesh->count++;
    tri_write(mesh, t, i, a, b, (int32_t[3]){ab, u, w}, none);
    tri_write(mesh, u, i, b, c, (int32_t[3]){bc, w, t}, none);
    tri_write(mesh, w, i, c, a, (int32_t[3]){ca, t, u}, none);
    tri_relink(mesh, bc, t, u);
    tri_relink(mesh, ca, t, w);
}


/* Inserts point i on the edge b c of triangles t = a b c and u = d c b: four triangles in place of two. */
static void tri_split_edge(tri_mesh *mesh, int32_t i, int32_t t, int32_t k)
{
    static const unsigned char none[3] = {0, 0, 0};
    int32_t k1 = tri_turn(k), k2 = tri_turn(k1), u = mesh->across[3 * t + k];
    int32_t a = mesh->v[3 * t + k], b = mesh->v[3 * t + k1], c = mesh->v[3 * t + k2];
    int32_t j1 = tri_corner(mesh, u, c), j2 = tri_corner(mesh, u, b), d = mesh->v[3 * u + 3 - j1 - j2];
    int32_t ab = mesh->across[3 * t + k2], ca = mesh->across[3 * t + k1];
    int32_t dc = mesh->across[3 * u + j2], bd = mesh->across[3 * u + j1];
    int32_t t2 = mesh->count++, u2 = mesh->count++;
    tri_write(mesh, t, i, a, b, (int32_t[3]){ab, u2, t2}, none);
    tri_write(mesh, t2, i, c, a, (int32_t[3]){ca, t, u}, none);
    tri_write(mesh, u, i, d, c, (int32_t[3]){dc, t2, u2}, none);
    tri_write(mesh, u2, i, b, d, (int32_t[3]){bd, u, t}, none);
    tri_relink(mesh, ca, t, t2);
    tri_relink(mesh, bd, u, u2);
}


static mus_status tri_insert(tri_mesh *mesh, int32_t i)
{
    int32_t t = 0, edge = MUS_NONE;
    mus_status status = tri_locate(mesh, i, &t, &edge);
    if (status != MUS_OK) return status;

    /* the edges round the new triangles are the first to test */
    int32_t rim[4], nrim = 0;
    if (edge == MUS_NONE) {
        for (int32_t k = 0; k < 3; k++) rim[nrim++] = mesh->v[3 * t + k];
        tri_split_inside(mesh, i, t);
    } else {
        int32_t u = mesh->across[3 * t + edge], k1 = tri_turn(edge);
        int32_t b = mesh->v[3 * t + k1], c = mesh->v[3 * t + tri_turn(k1)];
        rim[nrim++] = mesh->v[3 * t + edge], rim[nrim++] = b;
        rim[nrim++] = mesh->v[3 * u + 3 - tri_corner(mesh, u, b) - tri_corner(mesh, u, c)], rim[nrim++] = c;
        tri_split_edge(mesh, i, t, edge);
    }
    for (int32_t k = 0; k < nrim && status == MUS_OK; k++) status = tri_push(mesh, rim[k], rim[(k + 1) % nrim]);
    if (status == MUS_OK) status = tri_legalise(mesh);
    mesh->last = mesh->of[i];
    return status;
}


/*
 * Collects in the queue the edges that cross side a b, from a to b. The queue is empty when a b is an edge.
 * Errors: a point on the side; another side that crosses it.
 */
static mus_status tri_collect(tri_mesh *mesh, int32_t a, int32_t b)
{
    int32_t t, k;
    mesh->nqueue = 0;
    if (tri_find_edge(mesh, a, b, &t, &k)) return MUS_OK;

    /* the triangle at a that the side crosses: right end r and left end l of its edge opposite to a */
    int32_t start = mesh->of[a], r, l;
    for (t = start;;) {
        k = tri_corner(mesh, t, a);
        r = mesh->v[3 * t + tri_turn(k)], l = mesh->v[3 * t + tri_turn(tri_turn(k))];
        double at_r = tri_side(mesh, a, b, r), at_l = tri_side(mesh, a, b, l);
        if (at_r == 0.0 && tri_side(mesh, a, l, b) < 0.0) goto touch;
        if (at_r < 0.0 && at_l > 0.0) break;
        t = mesh->across[3 * t + tri_turn(k)];
        if (t == start || t == MUS_NONE)
            return mus__fail(mesh->context, MUS_ERR_MESH, "side %d-%d leads nowhere", (int)a, (int)b);
    }

    /* cross that edge, and so on until b */
    for (;;) {
        if (mesh->fixed[3 * t + k])
            return mus__fail(mesh->context, MUS_ERR_MESH, "side %d-%d crosses side %d-%d", (int)a, (int)b, (int)r,
                             (int)l);
        mus_status status = tri_enqueue(mesh, r, l);
        if (status != MUS_OK) return status;
        t = mesh->across[3 * t + k];
        int32_t next = mesh->v[3 * t + 3 - tri_corner(mesh, t, r) - tri_corner(mesh, t, l)];
        if (next == b) return MUS_OK;
        double side = tri_side(mesh, a, b, next);
        if (side == 0.0) {
            r = next;
            goto touch;
        }
        k = tri_corner(mesh, t, side < 0.0 ? r : l);
        if (side < 0.0)
            r = next;
        else
            l = next;
    }

touch:
    return mus__fail(mesh->context, MUS_ERR_MESH, "point %d lies on side %d-%d", (int)r, (int)a, (int)b);
}


/* Makes side a b an edge by flips. */
static mus_status tri_recover(tri_mesh *mesh, int32_t a, int32_t b)
{
    mus_status status = tri_collect(mesh, a, b);

    /* flip crossing edges; one whose quadrilateral is not convex, or that still crosses, goes back to the queue */
    int64_t patience = 16 + (int64_t)mesh->nqueue * mesh->nqueue * 4;
    for (int32_t head = 0; status == MUS_OK && head < mesh->nqueue; head += 2) {
        int32_t r = mesh->queue[head], l = mesh->queue[head + 1], t, k;
        if (patience-- == 0 || !tri_find_edge(mesh, r, l, &t, &k))
            return mus__fail(mesh->context, MUS_ERR_MESH, "side %d-%d cannot be made an edge", (int)a, (int)b);
        int32_t u = mesh->across[3 * t + k];
        int32_t p = mesh->v[3 * t + k], q = mesh->v[3 * u + 3 - tri_corner(mesh, u, r) - tri_corner(mesh, u, l)];
        if (!(tri_side(mesh, p, r, q) > 0.0 && tri_side(mesh, q, l, p) > 0.0)) {
            status = tri_enqueue(mesh, r, l);
            continue;
        }
        tri_flip(mesh, t, k);
        double at_p = tri_side(mesh, a, b, p), at_q = tri_side(mesh, a, b, q);
        if ((at_p < 0.0 && at_q > 0.0) || (at_p > 0.0 && at_q < 0.0))
            status = tri_enqueue(mesh, p, q);
        else
            status = tri_push(mesh, p, q);
    }
    if (status != MUS_OK) return status;

    /* mark the side in both of its triangles, then make the other new edges Delaunay */
    int32_t t, k;
    if (tri_find_edge(mesh, a, b, &t, &k)) mesh->fixed[3 * t + k] = 1;
    if (tri_find_edge(mesh, b, a, &t, &k)) mesh->fixed[3 * t + k] = 1;
    return tri_legalise(mesh);
}


/* Returns the index along the Hilbert curve of cell (x, y) in a grid of `side` x `side` cells, a power of 2. */
static int32_t tri_hilbert(int32_t x, int32_t y, int32_t side)
{
    int32_t place = 0;
    for (int32_t half = side / 2; half > 0; half /= 2) {
        int32_t right = (x & half) != 0, up = (y & half) != 0;
        place += half * half * ((3 * right) ^ up);
        if (up) continue;

        /* the curve is transposed in the lower quarters */
        if (right) x = side - 1 - x, y = side - 1 - y;
        int32_t swap = x;
        x = y, y = swap;
    }
    return place;
}


/* Returns the index along the curve of a point's cell, in the box that starts at `low`, with `scale` cells a metre. */
static int32_t tri_cell(const double *p, const double *low, double scale, int32_t side)
{
    int32_t x = (int32_t)((p[0] - low[0]) * scale), y = (int32_t)((p[1] - low[1]) * scale);
    return tri_hilbert(x < side ? x : side - 1, y < side ? y : side - 1, side);
}


/* Returns the round in which point i is inserted, counted back from the last one, 0. A round has about a quarter of the
 * points of the one after it. */
static int32_t tri_round(int32_t i)
{
    uint32_t mixed = (uint32_t)i * UINT32_C(2654435769);
    mixed = (mixed ^ (mixed >> 15)) * UINT32_C(2246822519);
    mixed ^= mixed >> 13;
    int32_t count = 0;
    while (count < TRIANGULATE_ROUNDS - 1 && (mixed >> (2 * count) & 3) == 0) count++;
    return count;
}


/* Computes the order of insertion: by rounds, each along the Hilbert curve (counting sort over cells). */
static mus_status tri_sort(tri_mesh *mesh, const double *low, double extent)
{
    int32_t side = 1;
    while (4 * (int64_t)side * side < mesh->n) side *= 2;
    int64_t cells = (int64_t)side * side;
    int32_t *first = mus__new(mesh->context, cells + 1, sizeof *first);
    int32_t *sorted = mus__new(mesh->context, mesh->n, sizeof *sorted);
    if (first != NULL && sorted != NULL) {
        double scale = side / extent;
        for (int32_t i = 0; i < mesh->n; i++) first[tri_cell(tri_point(mesh, i), low, scale, side) + 1]++;
        for (int64_t c = 0; c < cells; c++) first[c + 1] += first[c];
        for (int32_t i = 0; i < mesh->n; i++) sorted[first[tri_cell(tri_point(mesh, i), low, scale, side)]++] = i;
        int32_t count = 0;
        for (int32_t turn = TRIANGULATE_ROUNDS; turn-- > 0;)
            for (int32_t i = 0; i < mesh->n; i++)
                if (tri_round(sorted[i]) == turn) mesh->order[count++] = sorted[i];
    }
    bool done = first != NULL && sorted != NULL;
    mus__free(mesh->context, first);
    mus__free(mesh->context, sorted);
    return done ? MUS_OK : mus__fail_memory(mesh->context, "the order of points");
}


/* Computes the order of insertion and makes the outer triangle. */
static mus_status tri_start(tri_mesh *mesh)
{
    double low[2] = {mesh->xy[0], mesh->xy[1]}, high[2] = {mesh->xy[0], mesh->xy[1]};
    for (int32_t i = 0; i < mesh->n; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], tri_point(mesh, i)[k]);
            high[k] = fmax(high[k], tri_point(mesh, i)[k]);
        }
    double extent = fmax(high[0] - low[0], high[1] - low[1]);
    if (!(extent > 0.0)) return mus__fail(mesh->context, MUS_ERR_MESH, "points 0 and 1 are the same");
    mus_status status = tri_sort(mesh, low, extent);
    if (status != MUS_OK) return status;

    static const unsigned char none[3] = {0, 0, 0};
    double far = TRIANGULATE_FAR * extent, x = 0.5 * (low[0] + high[0]), y = 0.5 * (low[1] + high[1]);
    const double outer[6] = {x - 2.0 * far, y - far, x + 2.0 * far, y - far, x, y + 2.0 * far};
    memcpy(mesh->xy + 2 * (ptrdiff_t)mesh->n, outer, sizeof outer);
    mesh->count = 1;
    tri_write(mesh, 0, mesh->n, mesh->n + 1, mesh->n + 2, (int32_t[3]){MUS_NONE, MUS_NONE, MUS_NONE}, none);
    return MUS_OK;
}


static mus_status tri_reserve(tri_mesh *mesh, mus_context *context, int32_t n, const double *xy)
{
    int64_t most = 2 * (int64_t)n + 1;
    mesh->context = context, mesh->n = n;
    mesh->xy = mus__new(context, 2 * ((int64_t)n + 3), sizeof *mesh->xy);
    mesh->v = mus__new(context, 3 * most, sizeof *mesh->v);
    mesh->across = mus__new(context, 3 * most, sizeof *mesh->across);
    mesh->fixed = mus__new(context, 3 * most, sizeof *mesh->fixed);
    mesh->of = mus__new(context, (int64_t)n + 3, sizeof *mesh->of);
    mesh->order = mus__new(context, n, sizeof *mesh->order);
    if (mesh->xy == NULL || mesh->v == NULL || mesh->across == NULL || mesh->fixed == NULL || mesh->of == NULL ||
        mesh->order == NULL)
        return mus__fail_memory(context, "a triangulation");
    memcpy(mesh->xy, xy, 2 * (size_t)n * sizeof *xy);
    return MUS_OK;
}


static void tri_free(tri_mesh *mesh)
{
    void *blocks[] = {mesh->xy, mesh->v, mesh->across, mesh->fixed, mesh->of, mesh->order, mesh->stack, mesh->queue};
    for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++) mus__free(mesh->context, blocks[i]);
}


/* Marks the triangles outside the polygon, by flooding from an outer vertex up to the sides. */
static mus_status tri_flood(tri_mesh *mesh, unsigned char *outside)
{
    mesh->nqueue = 0;
    outside[mesh->of[mesh->n]] = 1;
    mus_status status = tri_enqueue(mesh, mesh->of[mesh->n], 0);
    while (status == MUS_OK && mesh->nqueue > 0) {
        int32_t t = mesh->queue[mesh->nqueue -= 2];
        for (int32_t k = 0; k < 3 && status == MUS_OK; k++) {
            int32_t u = mesh->across[3 * t + k];
            if (u == MUS_NONE || mesh->fixed[3 * t + k] || outside[u]) continue;
            outside[u] = 1;
            status = tri_enqueue(mesh, u, 0);
        }
    }
    return status;
}


/* Copies the inner triangles to a new array. A vertex without a triangle lay outside; a number of triangles that
 * Euler's formula does not give means that the polygon is not simple. Both are MUS_ERR_MESH. */
static mus_status tri_harvest(tri_mesh *mesh, int32_t nborder, int32_t **triangles, int32_t *count)
{
    int64_t expected = nborder - 2 + 2 * ((int64_t)mesh->n - nborder), kept = 0;
    int32_t *out = mus__new(mesh->context, 3 * expected, sizeof *out);
    unsigned char *outside = mus__new(mesh->context, mesh->count, 1), *seen = mus__new(mesh->context, mesh->n, 1);
    mus_status status = out != NULL && outside != NULL && seen != NULL ? tri_flood(mesh, outside)
                                                                       : mus__fail_memory(mesh->context, "triangles");
    for (int32_t t = 0; status == MUS_OK && t < mesh->count; t++) {
        if (outside[t]) continue;
        if (kept < expected) memcpy(out + 3 * kept, mesh->v + 3 * (ptrdiff_t)t, 3 * sizeof *out);
        for (int32_t k = 0; k < 3; k++) seen[mesh->v[3 * t + k]] = 1;
        kept++;
    }
    for (int32_t i = 0; status == MUS_OK && i < mesh->n; i++)
        if (!seen[i]) status = mus__fail(mesh->context, MUS_ERR_MESH, "point %d lies outside the polygon", (int)i);
    if (status == MUS_OK && kept != expected)
        status = mus__fail(mesh->context, MUS_ERR_MESH, "%lld triangles where a simple polygon has %lld",
                           (long long)kept, (long long)expected);

    mus__free(mesh->context, outside);
    mus__free(mesh->context, seen);
    if (status == MUS_OK)
        *triangles = out, *count = (int32_t)kept;
    else
        mus__free(mesh->context, out);
    return status;
}


mus_status mus__triangulate(mus_context *context, int32_t n, const double *xy, int32_t nborder, int32_t nside,
                            const int32_t *sides, int32_t **triangles, int32_t *count)
{
    *triangles = NULL, *count = 0;
    if (nborder < 3 || n < nborder || n > TRIANGULATE_MOST)
        return mus__fail(context, MUS_ERR_MESH, "%d points with %d on the border: 3 to 2^28 can be meshed", (int)n,
                         (int)nborder);
    for (int32_t i = 0; i < 2 * n; i++)
        if (!mus__finite(xy[i])) return mus__fail(context, MUS_ERR_MESH, "point %d is not finite", (int)(i / 2));

    tri_mesh mesh = {0};
    mus_status status = tri_reserve(&mesh, context, n, xy);
    if (status == MUS_OK) status = tri_start(&mesh);
    for (int32_t i = 0; status == MUS_OK && i < n; i++) status = tri_insert(&mesh, mesh.order[i]);
    for (int32_t i = 0; status == MUS_OK && i < nborder; i++)
        status = tri_recover(&mesh, i, i + 1 < nborder ? i + 1 : 0);
    for (int32_t i = 0; status == MUS_OK && i < nside; i++) status = tri_recover(&mesh, sides[2 * i], sides[2 * i + 1]);
    if (status == MUS_OK) status = tri_harvest(&mesh, nborder, triangles, count);
    tri_free(&mesh);
    return status;
}
