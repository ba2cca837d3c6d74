/*
 * closed.c: see closed.h. Bound of the double: Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997, section 3.
 */
#include "closed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define UNIT 1e12        /* steps of a metre */
#define BOUND 7.8e-16    /* of the permanent, for an orientation in double */
#define NONE (-1)

__extension__ typedef __int128 wide;

/* scratch of a check */
typedef struct check {
    const ruler_mesh *mesh;
    int64_t *x;          /* (vertices x 3) in steps */
    int32_t *from;       /* (vertices + 1) first of the corners at each vertex, from which directed edges go out */
    int32_t *corner;     /* (3 triangles) those corners */
    int32_t *piece;      /* (vertices) parent of each in its piece */
    int32_t *fan;        /* (vertices) fans of triangles about each */
    char *seen;          /* (3 triangles) corners that were visited */
    int64_t *box;        /* (triangles x 6) low and high corner of each triangle's box */
    int32_t *low, *first, *list; /* cell of each triangle's low corner (triangles x 3); grid */
    int32_t grid[3];
    int64_t base[3], cell;
} check;


static int32_t corner_vertex(const check *c, int32_t corner)
{
    return c->mesh->triangle[corner];
}


static int32_t corner_next(int32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}


/* the first corner whose directed edge goes from a to b, NONE: there is none */
static int32_t edge_find(const check *c, int32_t a, int32_t b)
{
    for (int32_t i = c->from[a]; i < c->from[a + 1]; i++)
        if (corner_vertex(c, corner_next(c->corner[i])) == b) return c->corner[i];
    return NONE;
}


/* sort the corners by their vertices */
static void check_corners(check *c)
{
    const int32_t corners = 3 * c->mesh->triangles, vertices = c->mesh->vertices;
    memset(c->from, 0, sizeof *c->from * ((size_t)vertices + 1));
    for (int32_t k = 0; k < corners; k++) c->from[corner_vertex(c, k) + 1]++;
    for (int32_t v = 0; v < vertices; v++) c->from[v + 1] += c->from[v];
    for (int32_t k = 0; k < corners; k++) c->corner[c->from[corner_vertex(c, k)]++] = k;
    for (int32_t v = vertices; v > 0; v--) c->from[v] = c->from[v - 1];
    c->from[0] = 0;
}


static int32_t root(int32_t *parent, int32_t v)
{
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}


/* edges, fans and pieces */
static void check_edges(check *c, closed_report *out)
{
    const int32_t corners = 3 * c->mesh->triangles, vertices = c->mesh->vertices;
    check_corners(c);
    for (int32_t i = 0; i < vertices; i++) c->piece[i] = i;
    for (int32_t k = 0; k < corners; k++) {
        const int32_t a = corner_vertex(c, k), b = corner_vertex(c, corner_next(k));
        out->open += edge_find(c, a, b) != k;
        out->open += edge_find(c, b, a) == NONE;
        const int32_t p = root(c->piece, a), q = root(c->piece, b);
        c->piece[p > q ? p : q] = p < q ? p : q;
    }
    for (int32_t i = 0; i < vertices; i++) out->pieces += c->piece[i] == i;
    out->euler = vertices - c->mesh->triangles / 2;
    if (out->open > 0 || c->mesh->triangles % 2 != 0) return;

    /* the triangles about a vertex, one after the other: the edge to it of this one is the edge from it of the next */
    for (int32_t k = 0; k < corners; k++) {
        if (c->seen[k]) continue;
        c->fan[corner_vertex(c, k)]++;
        for (int32_t j = k; !c->seen[j];) {
            c->seen[j] = 1;
            const int32_t before = corner_next(corner_next(j));
            j = edge_find(c, corner_vertex(c, j), corner_vertex(c, before));
        }
    }
    for (int32_t i = 0; i < vertices; i++) out->pinched += c->fan[i] != 1;
}


/* shape of the triangles, and the volume */
static void check_shapes(const check *c, closed_report *out)
{
    out->height = out->angle = INFINITY;
    for (int32_t t = 0; t < c->mesh->triangles; t++) {
        const double *p[3];
        double n[3], length[3], square = 0.0;
        for (int k = 0; k < 3; k++) p[k] = c->mesh->x + 3 * (size_t)corner_vertex(c, 3 * t + k);
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            n[i] = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
            length[i] = sqrt(pow(p[j][0] - p[i][0], 2) + pow(p[j][1] - p[i][1], 2) + pow(p[j][2] - p[i][2], 2));
            square += n[i] * n[i];
        }
        const double area = sqrt(square), most = fmax(length[0], fmax(length[1], length[2]));
        const double least = fmin(length[0], fmin(length[1], length[2]));
        out->volume += (p[0][0] * n[0] + p[0][1] * n[1] + p[0][2] * n[2]) / 6.0;
        out->flat += !(area > 0.0);
        out->height = fmin(out->height, area / most);

        /* the least angle lies between the two longer edges */
        const double other = length[0] + length[1] + length[2] - most - least;
        out->angle = fmin(out->angle, asin(fmin(area / (most * other), 1.0)) * 180.0 / acos(-1.0));
    }
}


/* sign of the volume of the tetrahedron a, b, c, d */
static int orient(const int64_t *a, const int64_t *b, const int64_t *c, const int64_t *d)
{
    double u[3], v[3], w[3];
    for (int i = 0; i < 3; i++)
        u[i] = (double)(b[i] - a[i]), v[i] = (double)(c[i] - a[i]), w[i] = (double)(d[i] - a[i]);
    double sum = 0.0, most = 0.0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += u[i] * (v[j] * w[k] - v[k] * w[j]);
        most += fabs(u[i]) * (fabs(v[j] * w[k]) + fabs(v[k] * w[j]));
    }
    if (fabs(sum) > BOUND * most) return sum > 0.0 ? 1 : -1;
    wide exact = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        exact += (wide)(b[i] - a[i]) * ((wide)(c[j] - a[j]) * (d[k] - a[k]) - (wide)(c[k] - a[k]) * (d[j] - a[j]));
    }
    return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}


/* whether the segment p q meets the triangle a b c; one within its plane does not count */
static bool meets(const int64_t *p, const int64_t *q, const int64_t *const *t)
{
    const int low = orient(t[0], t[1], t[2], p), high = orient(t[0], t[1], t[2], q);
    if (low * high > 0 || (low == 0 && high == 0)) return false;
    const int a = orient(p, q, t[0], t[1]), b = orient(p, q, t[1], t[2]), c = orient(p, q, t[2], t[0]);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}


/* whether two triangles that share an edge lie on each other: all in one plane, on one side of the edge */
static bool folded(const int64_t *a, const int64_t *b, const int64_t *p, const int64_t *q)
{
    if (orient(a, b, p, q) != 0) return false;
    double u[3], v[3], w[3], product = 0.0;
    for (int i = 0; i < 3; i++)
        u[i] = (double)(b[i] - a[i]), v[i] = (double)(p[i] - a[i]), w[i] = (double)(q[i] - a[i]);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        product += (u[j] * v[k] - u[k] * v[j]) * (u[j] * w[k] - u[k] * w[j]);
    }
    return product > 0.0;
}


/* whether two triangles whose boxes meet do so anywhere but in the vertices that they share */
static bool crosses(const check *c, int32_t s, int32_t t)
{
    const int32_t *v = c->mesh->triangle + 3 * (size_t)s, *w = c->mesh->triangle + 3 * (size_t)t;
    const int64_t *p[3], *q[3];
    int shared = 0, at[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        p[i] = c->x + 3 * (size_t)v[i], q[i] = c->x + 3 * (size_t)w[i];
        for (int j = 0; j < 3; j++)
            if (v[i] == w[j]) shared++, at[0] += i, at[1] += j;
    }
    if (shared == 3) return true;
    if (shared == 2) /* the vertices that are not shared: the indices of a triangle sum to 3 */
        return folded(p[(4 - at[0]) % 3], p[(5 - at[0]) % 3], p[3 - at[0]], q[3 - at[1]]);
    for (int i = 0; i < 3; i++) {
        /* with one shared vertex only the edges opposite to it */
        if ((shared == 0 || i == (at[0] + 1) % 3) && meets(p[i], p[(i + 1) % 3], q)) return true;
        if ((shared == 0 || i == (at[1] + 1) % 3) && meets(q[i], q[(i + 1) % 3], p)) return true;
    }
    return false;
}


/* boxes of the triangles */
static void check_boxes(check *c)
{
    for (int32_t t = 0; t < c->mesh->triangles; t++)
        for (int i = 0; i < 3; i++) {
            int64_t least = INT64_MAX, most = INT64_MIN;
            for (int k = 0; k < 3; k++) {
                const int64_t x = c->x[3 * (size_t)corner_vertex(c, 3 * t + k) + (size_t)i];
                least = x < least ? x : least, most = x > most ? x : most;
            }
            c->box[6 * (size_t)t + (size_t)i] = least, c->box[6 * (size_t)t + 3 + (size_t)i] = most;
        }
}


/* cells of a triangle's box: low and one past high */
static void cells(const check *c, int32_t t, int32_t *low, int32_t *high)
{
    const int64_t *box = c->box + 6 * (size_t)t;
    for (int i = 0; i < 3; i++) {
        low[i] = (int32_t)((box[i] - c->base[i]) / c->cell);
        high[i] = (int32_t)((box[3 + i] - c->base[i]) / c->cell) + 1;
    }
}


static size_t cell_at(const check *c, int32_t i, int32_t j, int32_t k)
{
    return ((size_t)k * (size_t)c->grid[1] + (size_t)j) * (size_t)c->grid[0] + (size_t)i;
}


/* triangles by cell: first and list. false: no memory */
static bool check_grid(check *c)
{
    double edges = 0.0;
    const int32_t n = c->mesh->triangles;
    for (int32_t t = 0; t < n; t++) {
        const double *p = c->mesh->x + 3 * (size_t)corner_vertex(c, 3 * t);
        const double *q = c->mesh->x + 3 * (size_t)corner_vertex(c, 3 * t + 1);
        edges += sqrt(pow(p[0] - q[0], 2) + pow(p[1] - q[1], 2) + pow(p[2] - q[2], 2));
    }
    c->cell = (int64_t)(1.5 * UNIT * edges / n) + 1;
    size_t count = 1;
    for (int i = 0; i < 3; i++) {
        int64_t high = INT64_MIN;
        c->base[i] = INT64_MAX;
        for (int32_t v = 0; v < c->mesh->vertices; v++) {
            const int64_t x = c->x[3 * (size_t)v + (size_t)i];
            c->base[i] = x < c->base[i] ? x : c->base[i], high = x > high ? x : high;
        }
        c->grid[i] = (int32_t)((high - c->base[i]) / c->cell) + 1;
        count *= (size_t)c->grid[i];
    }
    c->first = calloc(count + 2, sizeof *c->first);
    c->low = malloc(sizeof *c->low * 3 * (size_t)n);
    for (int pass = 0; pass < 2 && c->first != NULL && c->low != NULL; pass++) {
        for (int32_t t = 0; t < n; t++) {
            int32_t low[3], high[3];
            cells(c, t, low, high);
            memcpy(c->low + 3 * (size_t)t, low, sizeof low);
            for (int32_t k = low[2]; k < high[2]; k++)
                for (int32_t j = low[1]; j < high[1]; j++)
                    for (int32_t i = low[0]; i < high[0]; i++) {
                        const size_t at = cell_at(c, i, j, k) + 1;
                        if (pass == 0) c->first[at + 1]++;
                        else c->list[c->first[at]++] = t;
                    }
        }
        if (pass == 1) break;
        for (size_t i = 0; i <= count; i++) c->first[i + 1] += c->first[i];
        c->list = malloc(sizeof *c->list * ((size_t)c->first[count + 1] + 1));
        if (c->list == NULL) return false;
    }
    return c->first != NULL && c->low != NULL;
}


/* the pairs of the n triangles of a cell that cross; each pair is asked in one cell, the greater of their low cells.
 * box: scratch (6 n) */
static int32_t check_cell(const check *c, const int32_t *list, int32_t n, const int32_t *cell, int64_t *box)
{
    int32_t count = 0;
    for (int32_t a = 0; a < n; a++) {
        int64_t *own = box + 6 * (size_t)a;
        const int32_t *s = c->low + 3 * (size_t)list[a];
        memcpy(own, c->box + 6 * (size_t)list[a], 6 * sizeof *own);
        for (int32_t b = 0; b < a; b++) {
            const int64_t *other = box + 6 * (size_t)b;
            if (own[0] > other[3] || other[0] > own[3] || own[1] > other[4] || other[1] > own[4] ||
                own[2] > other[5] || other[2] > own[5])
                continue;
            const int32_t *t = c->low + 3 * (size_t)list[b];
            bool here = true;
            for (int i = 0; i < 3; i++) here = here && (s[i] > t[i] ? s[i] : t[i]) == cell[i];
            if (here) count += crosses(c, list[a], list[b]);
        }
    }
    return count;
}


/* false: no memory */
static bool check_crossings(const check *c, closed_report *out)
{
    const size_t count = cell_at(c, 0, 0, c->grid[2]);
    int32_t most = 0;
    for (size_t at = 0; at < count; at++)
        if (c->first[at + 1] - c->first[at] > most) most = c->first[at + 1] - c->first[at];
    int64_t *box = malloc(sizeof *box * 6 * ((size_t)most + 1));
    for (int32_t k = 0; k < c->grid[2] && box != NULL; k++)
        for (int32_t j = 0; j < c->grid[1]; j++)
            for (int32_t i = 0; i < c->grid[0]; i++) {
                const size_t at = cell_at(c, i, j, k);
                const int32_t cell[3] = {i, j, k}, n = c->first[at + 1] - c->first[at];
                out->crossings += check_cell(c, c->list + c->first[at], n, cell, box);
            }
    free(box);
    return box != NULL;
}


bool closed_check(const ruler_mesh *mesh, closed_report *out)
{
    const size_t vertices = (size_t)mesh->vertices, corners = 3 * (size_t)mesh->triangles;
    check c = {.mesh = mesh};
    memset(out, 0, sizeof *out);
    c.x = malloc(sizeof *c.x * 3 * vertices);
    c.from = malloc(sizeof *c.from * (vertices + 1));
    c.corner = malloc(sizeof *c.corner * corners);
    c.box = malloc(sizeof *c.box * 2 * corners);
    c.piece = malloc(sizeof *c.piece * vertices);
    c.fan = calloc(vertices, sizeof *c.fan);
    c.seen = calloc(corners, 1);
    bool good = c.x && c.from && c.corner && c.box && c.piece && c.fan && c.seen;
    for (size_t i = 0; i < 3 * vertices && good; i++) c.x[i] = llround(mesh->x[i] * UNIT);
    if (good) {
        check_boxes(&c);
        check_edges(&c, out);
        check_shapes(&c, out);
        good = check_grid(&c);
    }
    if (good) good = check_crossings(&c, out);
    free(c.x);
    free(c.from);
    free(c.corner);
    free(c.box);
    free(c.piece);
    free(c.fan);
    free(c.seen);
    free(c.low);
    free(c.first);
    free(c.list);
    return good;
}
