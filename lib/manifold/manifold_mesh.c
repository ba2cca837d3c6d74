/*
 * manifold_mesh.c: the triangles of the lattice's surface: one or two in each tetrahedron with points on both sides.
 *
 * The unit of a point with even coordinates is the cube from it to the next such points; the odd point is its middle.
 *
 * A vertex is a crossing of an edge. The crossings about a point that was moved onto the surface are one vertex, that
 * which drew it; triangles that have it twice are left out.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "manifold/manifold_internal.h"

#define MESH_SIDE 3    /* lattice units of a cell, and their neighbours */
#define MESH_CORNERS 11 /* points of the tetrahedra of a unit */
#define MESH_SHAPES 12  /* tetrahedra of a unit */

/* points of a cell and of the units beyond it: of even and of odd kind */
typedef struct mesh_cell {
    int32_t point[2][MESH_SIDE][MESH_SIDE][MESH_SIDE]; /* by k, j, i */
    uint8_t label[2][MESH_SIDE][MESH_SIDE][MESH_SIDE];
} mesh_cell;

/* a tetrahedron of a unit: its corners among the points of the unit, also as the bits of a mask, and the directions
 * from one corner to another */
typedef struct mesh_shape {
    int8_t corner[4], way[4][4];
    uint32_t mask;
} mesh_shape;

/* the points of a unit's tetrahedra: the middle, the next middles along the three axes, and the corners of the unit but
 * the first; the kind, and the place along each axis */
static const int8_t mesh_point[MESH_CORNERS][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1},
                                                   {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 1, 1, 0}, {0, 0, 0, 1},
                                                   {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 1, 1, 1}};

typedef struct mesh_work {
    const mus__bcc *lattice;
    mus__step window[2][MESH_SIDE][MESH_SIDE][MESH_SIDE];
    mesh_shape shape[MESH_SHAPES];
    int32_t *first;    /* (cells + 1) first triangle of each cell */
    int32_t *triangle; /* (triangles x 3), NULL: they are counted */
} mesh_work;

/* a tetrahedron's corner: a point, its label, and its index in the shape */
typedef struct mesh_corner {
    int32_t point, index;
    uint8_t label;
} mesh_corner;


/* the tetrahedra about the three edges from the middle of a unit to the next middles, and the window */
static void mesh_shapes(mesh_work *work)
{
    for (int32_t s = 0; s < MESH_SHAPES; s++) {
        static const int8_t turn[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
        const int32_t axis = s / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
        mesh_shape *shape = &work->shape[s];
        for (int32_t c = 0; c < 4; c++) {
            int32_t at[3] = {0};
            at[axis] = c != 0;
            if (c >= 2) at[u] = turn[s % 4 + c - 2][0], at[v] = turn[s % 4 + c - 2][1];
            shape->corner[c] = (int8_t)(c == 0 ? 0 : c == 1 ? 1 + axis : 3 + at[0] + 2 * at[1] + 4 * at[2]);
            shape->mask |= 1u << shape->corner[c];
        }
        for (int32_t c = 0; c < 16; c++)
            for (int32_t d = 0; d < MUS__LINKS; d++) {
                const int8_t *p = mesh_point[shape->corner[c / 4]], *q = mesh_point[shape->corner[c % 4]];
                bool same = true;
                for (int i = 0; i < 3; i++)
                    same = same && mus__bcc_step[d][i] == 2 * (q[1 + i] - p[1 + i]) + q[0] - p[0];
                if (same) shape->way[c / 4][c % 4] = (int8_t)d;
            }
    }
    for (int32_t p = 0; p < 2 * MESH_SIDE * MESH_SIDE * MESH_SIDE; p++) {
        const int32_t i = p % 3, j = p / 3 % 3, k = p / 9 % 3, odd = p / 27;
        const int32_t at[3] = {2 * i + odd, 2 * j + odd, 2 * k + odd};
        work->window[odd][k][j][i] = mus__bcc_at(work->lattice, at);
    }
}


/* whether an edge of a point has one end inside */
static bool mesh_mixed(const mus__bcc *lattice, int32_t point)
{
    const uint32_t every = (1u << MUS__LINKS) - 1;
    return lattice->inside[point] != ((lattice->label[point] & MUS__POINT_IN) != 0 ? every : 0);
}


/* read the points of a cell and of the units beyond it; false: no edge of its points crosses the surface */
static bool mesh_read(const mesh_work *work, int32_t cell, mesh_cell *out)
{
    const mus__bcc *lattice = work->lattice;
    const mus__step *window = &work->window[0][0][0][0];
    int32_t *point = &out->point[0][0][0][0];
    uint8_t *label = &out->label[0][0][0][0];
    bool any = false;
    for (int32_t i = 0; i < MUS__CELL_POINTS && !any; i++) any = mesh_mixed(lattice, cell * MUS__CELL_POINTS + i);
    for (int32_t i = 0; i < 2 * MESH_SIDE * MESH_SIDE * MESH_SIDE && any; i++) {
        point[i] = mus__bcc_point(lattice, lattice->place[cell], &window[i]);
        label[i] = lattice->label[point[i]];
    }
    return any;
}


/* the vertex between a corner inside and one outside */
static int32_t mesh_vertex(const mus__bcc *lattice, const mesh_shape *shape, const mesh_corner *in,
                           const mesh_corner *out)
{
    const bool on = (in->label & MUS__POINT_ON) != 0;
    return mus__bcc_crossing(lattice, in->point, on ? in->label >> 4 : shape->way[in->index][out->index]);
}


/* append a triangle unless two of its vertices are the same; returns the number of triangles then */
static int32_t mesh_add(int32_t *to, int32_t count, int32_t a, int32_t b, int32_t c)
{
    if (a == b || b == c || c == a) return count;
    to[3 * (ptrdiff_t)count] = a, to[3 * (ptrdiff_t)count + 1] = b, to[3 * (ptrdiff_t)count + 2] = c;
    return count + 1;
}


/* squared distance of two crossings */
static double mesh_distance(const mus__bcc *lattice, int32_t a, int32_t b)
{
    const double *p = lattice->crossing + 3 * (ptrdiff_t)a, *q = lattice->crossing + 3 * (ptrdiff_t)b;
    const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    return mus__dot3(d, d);
}


/* triangles of a tetrahedron through which the surface passes, and whose corners are the right way round; returns the
 * number of triangles then. Moved points have a vertex each, so the labels alone tell how many there are */
static int32_t mesh_tetrahedron(const mus__bcc *lattice, const mesh_shape *shape, const mesh_corner *corner,
                                int32_t *to, int32_t count)
{
    /* for each set of inside corners an even order that has them first */
    static const int8_t order[16][4] = {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 2, 3}, {2, 0, 1, 3},
                                        {0, 2, 3, 1}, {1, 2, 0, 3}, {0, 1, 2, 3}, {3, 0, 2, 1}, {0, 3, 1, 2},
                                        {1, 3, 2, 0}, {0, 3, 1, 2}, {2, 3, 0, 1}, {0, 2, 3, 1}, {1, 3, 2, 0},
                                        {0, 1, 2, 3}};
    int32_t inside = 0, set = 0;
    for (int32_t i = 0; i < 4; i++)
        if ((corner[i].label & MUS__POINT_IN) != 0) set |= 1 << i, inside++;
    const mesh_corner *a = &corner[order[set][0]], *b = &corner[order[set][1]], *c = &corner[order[set][2]],
                      *d = &corner[order[set][3]];
    if (to == NULL) return count + (inside != 2 || ((a->label | b->label) & MUS__POINT_ON) != 0 ? 1 : 2);
    if (inside == 1)
        return mesh_add(to, count, mesh_vertex(lattice, shape, a, b), mesh_vertex(lattice, shape, a, c),
                        mesh_vertex(lattice, shape, a, d));
    if (inside == 3)
        return mesh_add(to, count, mesh_vertex(lattice, shape, a, d), mesh_vertex(lattice, shape, b, d),
                        mesh_vertex(lattice, shape, c, d));
    const int32_t p = mesh_vertex(lattice, shape, a, c), q = mesh_vertex(lattice, shape, a, d);
    const int32_t r = mesh_vertex(lattice, shape, b, d), s = mesh_vertex(lattice, shape, b, c);
    if (mesh_distance(lattice, p, r) <= mesh_distance(lattice, q, s) || p == q || r == s) {
        count = mesh_add(to, count, p, q, r);
        return mesh_add(to, count, p, r, s);
    }
    count = mesh_add(to, count, p, q, s);
    return mesh_add(to, count, q, r, s);
}


/* triangles of the tetrahedra about the unit at (i, j, k) = at (3) of a cell; returns the number of triangles then */
static int32_t mesh_unit(const mesh_work *work, const mesh_cell *from, const int32_t *at, int32_t *to, int32_t count)
{
    mesh_corner unit[MESH_CORNERS];
    uint32_t in = 0, on = 0;
    for (int32_t c = 0; c < MESH_CORNERS; c++) {
        const int8_t *off = mesh_point[c];
        const int32_t i = at[0] + off[1], j = at[1] + off[2], k = at[2] + off[3];
        unit[c].point = from->point[off[0]][k][j][i];
        unit[c].label = from->label[off[0]][k][j][i];
        in |= (uint32_t)(unit[c].label & MUS__POINT_IN) << c;
        on |= (uint32_t)((unit[c].label & MUS__POINT_ON) != 0) << c;
    }
    for (int32_t s = 0; s < MESH_SHAPES; s++) {
        const mesh_shape *shape = &work->shape[s];
        const uint32_t inside = in & shape->mask, moved = on & shape->mask;

        /* with one or two corners inside, all of them moved, the surface has shrunk to a point or a line */
        if (inside == 0 || inside == shape->mask) continue;
        const uint32_t less = inside & (inside - 1);
        if (inside == moved && (less & (less - 1)) == 0) continue;
        mesh_corner corner[4];
        for (int32_t c = 0; c < 4; c++) {
            corner[c] = unit[shape->corner[c]];
            corner[c].index = c;
        }
        count = mesh_tetrahedron(work->lattice, shape, corner, to, count);
    }
    return count;
}


static void mesh_cells(void *user, int32_t part, int32_t parts)
{
    const mesh_work *work = user;
    const mus__bcc *lattice = work->lattice;
    const int32_t end = mus__share(lattice->cells, part + 1, parts);
    mesh_cell window;
    for (int32_t c = mus__share(lattice->cells, part, parts); c < end; c++) {
        int32_t count = 0;
        int32_t *to = work->triangle != NULL ? work->triangle + 3 * (ptrdiff_t)work->first[c] : NULL;
        const bool read = c >= MUS__CELLS_SHARED && mesh_read(work, c, &window);
        for (int32_t i = 0; i < MUS__CELL_POINTS / 2 && read; i++) {
            const int32_t at[3] = {i & 1, i >> 1 & 1, i >> 2};
            if (mesh_mixed(lattice, window.point[1][at[2]][at[1]][at[0]]))
                count = mesh_unit(work, &window, at, to, count);
        }
        if (to == NULL) work->first[c] = count;
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
    const int32_t crossings = lattice->crossings;
    for (int32_t i = 0; i < crossings; i++) number[i] = MUS_NONE;
    for (int32_t i = 0; i < 3 * out->triangles; i++) number[out->triangle[i]] = 0;
    for (int32_t i = 0; i < crossings; i++)
        if (number[i] != MUS_NONE) number[i] = out->vertices++, out->cuts += lattice->state[i] == MUS__EDGE_CUT;
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


/* give points to shared cells beside a point that came inside when it was moved: tetrahedra of theirs have three moved
 * corners. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
static mus_status mesh_open_beside(mus__bcc *lattice)
{
    const int32_t end = lattice->cells * MUS__CELL_POINTS;
    mus_status status = MUS_OK;
    for (int32_t point = MUS__CELLS_SHARED * MUS__CELL_POINTS; point < end; point++) {
        if ((lattice->label[point] & MUS__POINT_ON) == 0) continue;
        for (int32_t d = 0; d < MUS__LINKS && status == MUS_OK; d++) {
            const int32_t next = mus__bcc_next(lattice, point, d);
            if (next / MUS__CELL_POINTS != MUS__CELL_OUT) continue;
            const int32_t place = lattice->place[point / MUS__CELL_POINTS];
            status = mus__bcc_open(lattice, place + lattice->step[point % MUS__CELL_POINTS][d].cell, false);
        }
    }
    if (status == MUS_OK) status = mus__bcc_room(lattice);
    const int64_t points = (int64_t)lattice->cells * MUS__CELL_POINTS;
    if (status == MUS_OK)
        status = mus__reserve(lattice->context, &lattice->inside, &lattice->inside_room, points,
                              sizeof *lattice->inside);
    for (int32_t point = end; point < points && status == MUS_OK; point++) {
        uint32_t in = 0;
        for (int32_t d = 0; d < MUS__LINKS; d++)
            in |= (uint32_t)(lattice->label[mus__bcc_next(lattice, point, d)] & MUS__POINT_IN) << d;
        lattice->inside[point] = (uint16_t)in;
    }
    return status;
}


mus_status mus__bcc_mesh(mus__bcc *lattice, mus_manifold *out, int32_t *euler)
{
    mus_context *context = lattice->context;
    mesh_work work = {.lattice = lattice};
    int32_t *number = NULL;
    mus_status status = mesh_open_beside(lattice);
    if (status != MUS_OK) return status;
    work.first = mus__new(context, (int64_t)lattice->cells + 1, sizeof *work.first);
    number = mus__room(context, lattice->crossings, sizeof *number);
    if (work.first == NULL || number == NULL) {
        status = mus__fail_memory(context, "a manifold");
        goto end;
    }
    mesh_shapes(&work);
    mus__pool_run(lattice->pool, mesh_cells, &work);
    for (int32_t c = 0; c <= lattice->cells; c++) {
        const int32_t count = c < lattice->cells ? work.first[c] : 0;
        work.first[c] = out->triangles;
        out->triangles += count;
    }
    out->triangle = work.triangle = mus__room(context, 3 * (int64_t)out->triangles, sizeof *work.triangle);
    if (out->triangle == NULL) {
        status = mus__fail_memory(context, "a manifold");
        goto end;
    }
    mus__pool_run(lattice->pool, mesh_cells, &work);
    status = mesh_vertices(lattice, out, number);
    if (status != MUS_OK) goto end;
    mesh_normals(out);
    mesh_pieces(out, number, euler);

end:
    mus__free(context, work.first);
    mus__free(context, number);
    return status;
}
