/*
 * manifold_mesh.c: the triangles of the lattice's surface: one or two in each tetrahedron with points on both sides.
 *
 * A vertex is a crossing of an edge. The crossings about a point that was moved onto the surface are one vertex, that
 * which drew it; triangles that have it twice are left out.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "manifold/manifold_internal.h"

#define MESH_SIDE (MUS__BLOCK + 1) /* cells of a block, and their neighbours */

/* points of a block and of the layer beyond it: of even and of odd kind */
typedef struct mesh_block {
    int32_t point[2][MESH_SIDE][MESH_SIDE][MESH_SIDE]; /* by k, j, i */
    uint8_t label[2][MESH_SIDE][MESH_SIDE][MESH_SIDE];
} mesh_block;

typedef struct mesh_work {
    const mus__bcc *lattice;
    int32_t *first;    /* (blocks + 1) first triangle of each block */
    int32_t *triangle; /* (triangles x 3), NULL: they are counted */
} mesh_work;

/* a tetrahedron's corner: a point, its label, and its place in doubled coordinates of the block */
typedef struct mesh_corner {
    int32_t point;
    uint8_t label;
    int32_t at[3];
} mesh_corner;


/* read the points of a block and of the layer beyond it; false: they all lie on one side */
static bool mesh_read(const mus__bcc *lattice, int32_t block, mesh_block *out)
{
    if (mus__bcc_plain(lattice, block)) return false;
    for (int32_t k = 0; k < MESH_SIDE; k++)
        for (int32_t j = 0; j < MESH_SIDE; j++)
            for (int32_t i = 0; i < MESH_SIDE; i++)
                for (int32_t odd = 0; odd < 2; odd++) {
                    const int32_t a = i < MUS__BLOCK ? i : MUS__BLOCK - 1, b = j < MUS__BLOCK ? j : MUS__BLOCK - 1;
                    const int32_t c = k < MUS__BLOCK ? k : MUS__BLOCK - 1;
                    int32_t point = block * MUS__BLOCK_POINTS + odd * MUS__BLOCK_CELLS +
                                    (c * MUS__BLOCK + b) * MUS__BLOCK + a;
                    if (i > a && point != MUS_NONE) point = mus__bcc_next(lattice, point, 0);
                    if (j > b && point != MUS_NONE) point = mus__bcc_next(lattice, point, 1);
                    if (k > c && point != MUS_NONE) point = mus__bcc_next(lattice, point, 2);
                    out->point[odd][k][j][i] = point;
                    out->label[odd][k][j][i] = point == MUS_NONE ? 0 : lattice->label[point];
                }
    return true;
}


/* the vertex between a corner inside and one outside */
static int32_t mesh_vertex(const mus__bcc *lattice, const mesh_corner *in, const mesh_corner *out)
{
    if ((in->label & MUS__POINT_ON) != 0) return mus__bcc_crossing(lattice, in->point, in->label >> 4);
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        const int8_t *step = mus__bcc_step[d];
        if (step[0] == out->at[0] - in->at[0] && step[1] == out->at[1] - in->at[1] && step[2] == out->at[2] - in->at[2])
            return mus__bcc_crossing(lattice, in->point, d);
    }
    return MUS_NONE;
}


/* append a triangle unless two of its vertices are the same; returns the number of triangles then */
static int32_t mesh_add(int32_t *to, int32_t count, int32_t a, int32_t b, int32_t c)
{
    if (a == b || b == c || c == a) return count;
    if (to != NULL) to[3 * (ptrdiff_t)count] = a, to[3 * (ptrdiff_t)count + 1] = b, to[3 * (ptrdiff_t)count + 2] = c;
    return count + 1;
}


/* squared distance of two crossings */
static double mesh_distance(const mus__bcc *lattice, int32_t a, int32_t b)
{
    const double *p = lattice->crossing + 3 * (ptrdiff_t)a, *q = lattice->crossing + 3 * (ptrdiff_t)b;
    const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    return mus__dot3(d, d);
}


/* triangles of a tetrahedron whose corners are the right way round; returns the number of triangles then */
static int32_t mesh_tetrahedron(const mus__bcc *lattice, const mesh_corner *corner, int32_t *to, int32_t count)
{
    /* for each set of inside corners an even order that has them first */
    static const int8_t order[16][4] = {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 2, 3}, {2, 0, 1, 3},
                                        {0, 2, 3, 1}, {1, 2, 0, 3}, {0, 1, 2, 3}, {3, 0, 2, 1}, {0, 3, 1, 2},
                                        {1, 3, 2, 0}, {0, 3, 1, 2}, {2, 3, 0, 1}, {0, 2, 3, 1}, {1, 3, 2, 0},
                                        {0, 1, 2, 3}};
    int32_t inside = 0, set = 0;
    for (int32_t i = 0; i < 4; i++)
        if ((corner[i].label & MUS__POINT_IN) != 0) set |= 1 << i, inside++;
    if (inside == 0 || inside == 4) return count;
    const mesh_corner *a = &corner[order[set][0]], *b = &corner[order[set][1]], *c = &corner[order[set][2]],
                      *d = &corner[order[set][3]];
    if (inside == 1)
        return mesh_add(to, count, mesh_vertex(lattice, a, b), mesh_vertex(lattice, a, c), mesh_vertex(lattice, a, d));
    if (inside == 3)
        return mesh_add(to, count, mesh_vertex(lattice, a, d), mesh_vertex(lattice, b, d), mesh_vertex(lattice, c, d));
    const int32_t p = mesh_vertex(lattice, a, c), q = mesh_vertex(lattice, a, d), r = mesh_vertex(lattice, b, d);
    const int32_t s = mesh_vertex(lattice, b, c);
    if (mesh_distance(lattice, p, r) <= mesh_distance(lattice, q, s) || p == q || r == s) {
        count = mesh_add(to, count, p, q, r);
        return mesh_add(to, count, p, r, s);
    }
    count = mesh_add(to, count, p, q, s);
    return mesh_add(to, count, q, r, s);
}


/* whether the points of the tetrahedra about a cell lie on one side */
static bool mesh_skips(const mesh_block *from, const int32_t *cell)
{
    int32_t inside = 0;
    for (int32_t m = 1; m < 8; m++)
        inside += from->label[0][cell[2] + (m >> 2)][cell[1] + (m >> 1 & 1)][cell[0] + (m & 1)] & MUS__POINT_IN;
    for (int32_t m = 0; m < 4; m++)
        inside += from->label[1][cell[2] + (m == 3)][cell[1] + (m == 2)][cell[0] + (m == 1)] & MUS__POINT_IN;
    return inside == 0 || inside == 11;
}


/* triangles of the tetrahedra about the cell (i, j, k): about the three edges from its middle to the next middles */
static int32_t mesh_cell(const mus__bcc *lattice, const mesh_block *from, const int32_t *cell, int32_t *to,
                         int32_t count)
{
    for (int32_t axis = 0; axis < 3; axis++) {
        const int32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        static const int8_t turn[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        mesh_corner middle[2], even[4];
        for (int32_t m = 0; m < 6; m++) {
            mesh_corner *corner = m < 2 ? &middle[m] : &even[m - 2];
            int32_t at[3] = {cell[0], cell[1], cell[2]};
            if (m < 2) at[axis] += m;
            else at[axis]++, at[u] += turn[m - 2][0], at[v] += turn[m - 2][1];
            corner->point = from->point[m < 2][at[2]][at[1]][at[0]];
            corner->label = from->label[m < 2][at[2]][at[1]][at[0]];
            for (int i = 0; i < 3; i++) corner->at[i] = 2 * at[i] + (m < 2);
        }
        for (int32_t m = 0; m < 4; m++) {
            const mesh_corner corner[4] = {middle[0], middle[1], even[m], even[(m + 1) % 4]};
            count = mesh_tetrahedron(lattice, corner, to, count);
        }
    }
    return count;
}


static void mesh_blocks(void *user, int32_t part, int32_t parts)
{
    const mesh_work *work = user;
    const mus__bcc *lattice = work->lattice;
    const int32_t end = mus__share(lattice->blocks, part + 1, parts);
    mesh_block block;
    for (int32_t b = mus__share(lattice->blocks, part, parts); b < end; b++) {
        int32_t count = 0;
        int32_t *to = work->triangle != NULL ? work->triangle + 3 * (ptrdiff_t)work->first[b] : NULL;
        const bool read = mesh_read(lattice, b, &block);
        for (int32_t i = 0; i < MUS__BLOCK_CELLS && read; i++) {
            const int32_t cell[3] = {i % MUS__BLOCK, i / MUS__BLOCK % MUS__BLOCK, i / (MUS__BLOCK * MUS__BLOCK)};
            if (!mesh_skips(&block, cell)) count = mesh_cell(lattice, &block, cell, to, count);
        }
        if (to == NULL) work->first[b] = count;
    }
}


/* the root of a vertex's piece, with its path made shorter */
static int32_t mesh_root(int32_t *parent, int32_t vertex)
{
    while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
}


/* number the crossings that triangles use, and copy them. Errors: MUS_ERR_MEMORY */
static mus_status mesh_vertices(const mus__bcc *lattice, mus_manifold *out, int32_t *number)
{
    const int32_t crossings = lattice->block_first[lattice->blocks];
    for (int32_t i = 0; i < crossings; i++) number[i] = MUS_NONE;
    for (int32_t i = 0; i < 3 * out->triangles; i++) number[out->triangle[i]] = 0;
    for (int32_t i = 0; i < crossings; i++)
        if (number[i] != MUS_NONE) number[i] = out->vertices++, out->cuts += lattice->cut[i];
    for (int32_t i = 0; i < 3 * out->triangles; i++) out->triangle[i] = number[out->triangle[i]];
    out->vertex = mus__room(out->context, 3 * (int64_t)out->vertices, sizeof *out->vertex);
    out->normal = mus__new(out->context, 3 * (int64_t)out->vertices, sizeof *out->normal);
    if (out->vertex == NULL || out->normal == NULL) return mus__fail_memory(out->context, "a manifold");
    for (int32_t i = 0; i < crossings; i++)
        if (number[i] != MUS_NONE)
            memcpy(out->vertex + 3 * (ptrdiff_t)number[i], lattice->crossing + 3 * (ptrdiff_t)i, 3 * sizeof(double));
    return MUS_OK;
}


/* normals and volume */
static void mesh_normals(mus_manifold *out)
{
    double volume = 0.0;
    for (int32_t i = 0; i < out->triangles; i++) {
        const int32_t *t = out->triangle + 3 * (ptrdiff_t)i;
        const double *p = out->vertex + 3 * (ptrdiff_t)t[0], *q = out->vertex + 3 * (ptrdiff_t)t[1];
        const double *r = out->vertex + 3 * (ptrdiff_t)t[2];
        const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
        double area[3];
        mus__cross3(u, v, area);
        volume += mus__dot3(p, area) / 6.0;
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 3; c++) out->normal[3 * (ptrdiff_t)t[k] + c] += area[c];
    }
    for (int32_t i = 0; i < out->vertices; i++) mus__unit3(out->normal + 3 * (ptrdiff_t)i);
    out->volume = volume;
}


/* count the pieces; `parent` is scratch. A closed surface has 3 edges for 2 triangles */
static void mesh_pieces(mus_manifold *out, int32_t *parent, int32_t *euler)
{
    for (int32_t i = 0; i < out->vertices; i++) parent[i] = i;
    for (int32_t i = 0; i < out->triangles; i++)
        for (int k = 1; k < 3; k++) {
            const int32_t a = mesh_root(parent, out->triangle[3 * (ptrdiff_t)i]);
            const int32_t b = mesh_root(parent, out->triangle[3 * (ptrdiff_t)i + k]);
            if (a < b) parent[b] = a;
            else parent[a] = b;
        }
    for (int32_t i = 0; i < out->vertices; i++) out->pieces += parent[i] == i;
    *euler = out->vertices - out->triangles / 2;
}


mus_status mus__bcc_mesh(const mus__bcc *lattice, mus_manifold *out, int32_t *euler)
{
    mus_context *context = lattice->context;
    const int32_t crossings = lattice->block_first[lattice->blocks];
    mesh_work work = {.lattice = lattice};
    work.first = mus__new(context, (int64_t)lattice->blocks + 1, sizeof *work.first);
    int32_t *number = mus__room(context, crossings, sizeof *number);
    mus_status status = MUS_OK;
    if (work.first == NULL || number == NULL) {
        status = mus__fail_memory(context, "a manifold");
        goto end;
    }
    mus__pool_run(lattice->pool, mesh_blocks, &work);
    for (int32_t b = 0; b <= lattice->blocks; b++) {
        const int32_t count = b < lattice->blocks ? work.first[b] : 0;
        work.first[b] = out->triangles;
        out->triangles += count;
    }
    out->triangle = work.triangle = mus__room(context, 3 * (int64_t)out->triangles, sizeof *work.triangle);
    if (out->triangle == NULL) {
        status = mus__fail_memory(context, "a manifold");
        goto end;
    }
    mus__pool_run(lattice->pool, mesh_blocks, &work);
    status = mesh_vertices(lattice, out, number);
    if (status != MUS_OK) goto end;
    mesh_normals(out);
    mesh_pieces(out, number, euler);

end:
    mus__free(context, work.first);
    mus__free(context, number);
    return status;
}
