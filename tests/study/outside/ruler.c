/* ruler.c: see ruler.h. The hull is Andrew's monotone chain (1979). */
#include "ruler.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>


/* ---- the file ---- */

static char *read_text(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) return NULL;
    char *text = NULL;
    const long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (size > 0 && fseek(file, 0, SEEK_SET) == 0) text = malloc((size_t)size + 1);
    if (text != NULL) text[fread(text, 1, (size_t)size, file)] = '\0';
    fclose(file);
    return text;
}


/* a plain decimal with an exponent, faster than strtod and right to the last bit but one */
static double read_number(char **at)
{
    char *p = *at;
    double value = 0.0, scale = 1.0;
    int exponent = 0;
    while (*p == ' ') p++;
    const bool minus = *p == '-';
    if (*p == '-' || *p == '+') p++;
    for (; *p >= '0' && *p <= '9'; p++) value = 10.0 * value + (*p - '0');
    if (*p == '.')
        for (p++; *p >= '0' && *p <= '9'; p++) value = 10.0 * value + (*p - '0'), scale *= 10.0;
    if (*p == 'e' || *p == 'E') exponent = (int)strtol(p + 1, &p, 10);
    *at = p;
    value /= scale;
    if (exponent != 0) value *= pow(10.0, exponent);
    return minus ? -value : value;
}


/* the corners of a line "f a/b/c ..." as a fan; room for `most` triangles. Returns their number */
static int32_t read_face(char *p, int32_t vertices, int32_t *out, int32_t most)
{
    int32_t corner[3], count = 0, made = 0;
    while (*p != '\0' && *p != '\n') {
        while (*p == ' ' || *p == '\r') p++;
        if (*p == '\0' || *p == '\n') break;
        const long k = strtol(p, &p, 10);
        while (*p != ' ' && *p != '\n' && *p != '\r' && *p != '\0') p++;
        corner[count < 2 ? count : 2] = (int32_t)(k < 0 ? vertices + k : k - 1);
        if (++count < 3 || made == most) continue;
        memcpy(out + 3 * (size_t)made++, corner, sizeof corner);
        corner[1] = corner[2];
    }
    return made;
}


bool ruler_read(const char *path, ruler_mesh *out)
{
    *out = (ruler_mesh){0};
    char *text = read_text(path);
    if (text == NULL) return false;
    size_t lines = 1;
    for (const char *p = text; *p != '\0'; p++) lines += *p == '\n';
    out->x = malloc(sizeof *out->x * 3 * lines);
    out->triangle = malloc(sizeof *out->triangle * 6 * lines);
    for (char *p = text; out->x != NULL && out->triangle != NULL && *p != '\0';) {
        char *end = strchr(p, '\n');
        if (p[0] == 'v' && p[1] == ' ') {
            char *at = p + 2;
            for (int i = 0; i < 3; i++) out->x[3 * (size_t)out->vertices + (size_t)i] = read_number(&at);
            out->vertices++;
        } else if (p[0] == 'f' && p[1] == ' ') {
            out->triangles += read_face(p + 2, out->vertices, out->triangle + 3 * (size_t)out->triangles, 2);
        }
        p = end != NULL ? end + 1 : p + strlen(p);
    }
    free(text);
    bool good = out->vertices > 0 && out->triangles > 0;
    for (int32_t i = 0; good && i < 3 * out->triangles; i++)
        good = out->triangle[i] >= 0 && out->triangle[i] < out->vertices;
    if (!good) ruler_free(out);
    return good;
}


void ruler_free(ruler_mesh *mesh)
{
    free(mesh->x);
    free(mesh->triangle);
    *mesh = (ruler_mesh){0};
}


/* ---- cuts ---- */

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}


ruler_plane ruler_plane_at(const double *point, const double *normal, const double *u)
{
    ruler_plane plane;
    const double length = sqrt(dot(normal, normal));
    for (int i = 0; i < 3; i++) plane.point[i] = point[i], plane.normal[i] = normal[i] / length;
    const double along = dot(u, plane.normal);
    for (int i = 0; i < 3; i++) plane.u[i] = u[i] - along * plane.normal[i];
    const double wide = sqrt(dot(plane.u, plane.u));
    for (int i = 0; i < 3; i++) plane.u[i] /= wide;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        plane.v[i] = plane.normal[j] * plane.u[k] - plane.normal[k] * plane.u[j];
    }
    return plane;
}


/* an end of a chord: the mesh's edge that the plane meets */
typedef struct cut_end {
    int64_t edge;
    int32_t place;
} cut_end;


static int by_edge(const void *left, const void *right)
{
    const cut_end *p = left, *q = right;
    if (p->edge != q->edge) return p->edge < q->edge ? -1 : 1;
    return p->place < q->place ? -1 : p->place > q->place;
}


static int32_t root_of(int32_t *parent, int32_t i)
{
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}


/* the point in (u, v) at which the edge from vertex i to j meets the plane */
static void meet(const ruler_mesh *mesh, const ruler_plane *plane, const double *height, int64_t i, int64_t j,
                 double *uv)
{
    const double t = height[i] / (height[i] - height[j]), *p = mesh->x + 3 * i, *q = mesh->x + 3 * j;
    double d[3];
    for (int k = 0; k < 3; k++) d[k] = p[k] + t * (q[k] - p[k]) - plane->point[k];
    uv[0] = dot(d, plane->u), uv[1] = dot(d, plane->v);
}


/* the ends of all chords, two a triangle, in the order of the triangles; returns their number */
static int32_t cut_ends(const ruler_mesh *mesh, const double *height, cut_end *end)
{
    int32_t count = 0;
    for (int32_t t = 0; t < mesh->triangles; t++) {
        const int32_t *c = mesh->triangle + 3 * (size_t)t;
        const int up = (height[c[0]] >= 0.0) + (height[c[1]] >= 0.0) + (height[c[2]] >= 0.0);
        if (up == 0 || up == 3) continue;
        for (int k = 0; k < 3; k++) {
            const int64_t i = c[k], j = c[(k + 1) % 3];
            if ((height[i] >= 0.0) == (height[j] >= 0.0)) continue;
            end[count] = (cut_end){i < j ? i * mesh->vertices + j : j * mesh->vertices + i, count};
            count++;
        }
    }
    return count;
}


/* number the loops, and fill their boxes and middles; parent (points) is a forest of points */
static void number_loops(ruler_cut *cut, int32_t *parent)
{
    for (int32_t i = 0; i < cut->points; i++) cut->loop[i] = -1;
    for (int32_t i = 0; i < cut->points; i++) {
        const int32_t root = root_of(parent, i);
        if (cut->loop[root] < 0) {
            cut->loop[root] = cut->loops;
            cut->of[cut->loops++] = (ruler_loop){.low = {1e30, 1e30}, .high = {-1e30, -1e30}};
        }
        cut->loop[i] = cut->loop[root];
        ruler_loop *loop = &cut->of[cut->loop[i]];
        loop->points++;
        for (int k = 0; k < 2; k++) {
            const double at = cut->uv[2 * (size_t)i + (size_t)k];
            loop->low[k] = fmin(loop->low[k], at), loop->high[k] = fmax(loop->high[k], at);
            loop->middle[k] += at;
        }
    }
    for (int32_t l = 0; l < cut->loops; l++)
        for (int k = 0; k < 2; k++) cut->of[l].middle[k] /= cut->of[l].points;
}


/* points, chords and loops from the ends of the chords */
static void join_ends(const ruler_mesh *mesh, const ruler_plane *plane, const double *height, int32_t ends,
                      cut_end *end, int32_t *parent, ruler_cut *out)
{
    qsort(end, (size_t)ends, sizeof *end, by_edge);
    for (int32_t k = 0; k < ends; k++) {
        if (k == 0 || end[k].edge != end[k - 1].edge) {
            meet(mesh, plane, height, end[k].edge / mesh->vertices, end[k].edge % mesh->vertices,
                 out->uv + 2 * (size_t)out->points++);
        }
        out->chord[end[k].place] = out->points - 1;
    }
    out->chords = ends / 2;
    for (int32_t i = 0; i < out->points; i++) parent[i] = i;
    for (int32_t k = 0; k < ends; k += 2)
        parent[root_of(parent, out->chord[k])] = root_of(parent, out->chord[k + 1]);
    number_loops(out, parent);
}


bool ruler_cut_at(const ruler_mesh *mesh, const ruler_plane *plane, ruler_cut *out)
{
    *out = (ruler_cut){0};
    double *height = malloc(sizeof *height * (size_t)mesh->vertices);
    cut_end *end = malloc(sizeof *end * 2 * (size_t)mesh->triangles);
    int32_t ends = 0, *parent = NULL;
    if (height != NULL && end != NULL) {
        const double start = dot(plane->point, plane->normal);
        for (int32_t i = 0; i < mesh->vertices; i++) height[i] = dot(mesh->x + 3 * (size_t)i, plane->normal) - start;
        ends = cut_ends(mesh, height, end);
    }
    const size_t room = (size_t)ends + 1;
    parent = malloc(sizeof *parent * room);
    out->uv = malloc(sizeof *out->uv * 2 * room);
    out->loop = malloc(sizeof *out->loop * room);
    out->chord = malloc(sizeof *out->chord * room);
    out->of = malloc(sizeof *out->of * room);
    const bool good = height && end && parent && out->uv && out->loop && out->chord && out->of;
    if (good) join_ends(mesh, plane, height, ends, end, parent, out);
    free(height);
    free(end);
    free(parent);
    if (!good) ruler_cut_free(out);
    return good;
}


void ruler_cut_free(ruler_cut *cut)
{
    free(cut->uv);
    free(cut->loop);
    free(cut->chord);
    free(cut->of);
    *cut = (ruler_cut){0};
}


/* ---- tapes ---- */

void ruler_take_trunk(ruler_cut *cut, bool inner)
{
    double low = 0.0, high = 0.0;
    for (int32_t l = 0; l < cut->loops; l++) {
        ruler_loop *loop = &cut->of[l];
        loop->taken = loop->points > 2 && loop->low[0] < 0.0 && loop->high[0] > 0.0;
        if (loop->taken) low = fmin(low, loop->low[0]), high = fmax(high, loop->high[0]);
    }
    for (int32_t l = 0; l < cut->loops && inner; l++)
        cut->of[l].taken |= cut->of[l].middle[0] > low && cut->of[l].middle[0] < high;
}


void ruler_take_nearest(ruler_cut *cut)
{
    double least = 1e30;
    int32_t best = -1;
    for (int32_t l = 0; l < cut->loops; l++) {
        const double *m = cut->of[l].middle, off = m[0] * m[0] + m[1] * m[1];
        cut->of[l].taken = false;
        if (cut->of[l].points > 2 && off < least) least = off, best = l;
    }
    if (best >= 0) cut->of[best].taken = true;
}


static int by_place(const void *left, const void *right)
{
    const double *p = left, *q = right;
    if (p[0] != q[0]) return p[0] < q[0] ? -1 : 1;
    return p[1] < q[1] ? -1 : p[1] > q[1];
}


static double turn(const double *o, const double *p, const double *q)
{
    return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}


/* perimeter of the hull of n points, which it sorts; NaN: no memory or no point */
static double hull_of(int32_t n, double *uv)
{
    double *hull = malloc(sizeof *hull * (4 * (size_t)n + 4)), sum = 0.0;
    if (hull == NULL || n < 1) {
        free(hull);
        return NAN;
    }
    qsort(uv, (size_t)n, 2 * sizeof *uv, by_place);
    size_t count = 0;
    for (size_t pass = 0, least = 2; pass < 2; pass++, least = count + 1)
        for (size_t i = 0; i < (size_t)n; i++) {
            const double *p = uv + 2 * (pass == 0 ? i : (size_t)n - 1 - i);
            while (count >= least && turn(hull + 2 * (count - 2), hull + 2 * (count - 1), p) <= 0.0) count--;
            hull[2 * count] = p[0], hull[2 * count + 1] = p[1];
            count++;
        }
    for (size_t i = 0; i + 1 < count; i++)
        sum += hypot(hull[2 * i + 2] - hull[2 * i], hull[2 * i + 3] - hull[2 * i + 1]);
    free(hull);
    return sum;
}


double ruler_tape(const ruler_cut *cut)
{
    double *uv = malloc(sizeof *uv * 2 * ((size_t)cut->points + 1)), sum = NAN;
    int32_t n = 0;
    for (int32_t i = 0; i < cut->points && uv != NULL; i++) {
        if (!cut->of[cut->loop[i]].taken) continue;
        memcpy(uv + 2 * (size_t)n++, cut->uv + 2 * (size_t)i, 2 * sizeof *uv);
    }
    if (n > 2) sum = hull_of(n, uv);
    free(uv);
    return sum;
}


double ruler_string(int32_t n, double *uv, double side)
{
    const double first[2] = {uv[0], uv[1]}, last[2] = {uv[2 * (size_t)n - 2], uv[2 * (size_t)n - 1]};
    int32_t kept = 1;
    for (int32_t i = 1; i + 1 < n; i++) {
        const double p[2] = {uv[2 * (size_t)i], uv[2 * (size_t)i + 1]};
        if (-side * turn(first, last, p) <= 0.0) continue;
        uv[2 * (size_t)kept] = p[0], uv[2 * (size_t)kept + 1] = p[1];
        kept++;
    }
    uv[2 * (size_t)kept] = last[0], uv[2 * (size_t)kept + 1] = last[1];
    const double chord = hypot(last[0] - first[0], last[1] - first[1]);
    return kept == 1 ? chord : hull_of(kept + 1, uv) - chord;
}


bool ruler_within(const ruler_cut *cut, int32_t loop, double u, double v)
{
    bool odd = false;
    for (int32_t k = 0; k < cut->chords; k++) {
        const int32_t i = cut->chord[2 * (size_t)k], j = cut->chord[2 * (size_t)k + 1];
        const double *p = cut->uv + 2 * (size_t)i, *q = cut->uv + 2 * (size_t)j;
        if (cut->loop[i] != loop || (p[1] > v) == (q[1] > v)) continue;
        odd ^= p[0] + (v - p[1]) / (q[1] - p[1]) * (q[0] - p[0]) > u;
    }
    return odd;
}


double ruler_off(const ruler_cut *cut, int32_t loop, double u, double v)
{
    double least = 1e30;
    for (int32_t k = 0; k < cut->chords; k++) {
        const int32_t i = cut->chord[2 * (size_t)k], j = cut->chord[2 * (size_t)k + 1];
        if (cut->loop[i] != loop) continue;
        const double *p = cut->uv + 2 * (size_t)i, *q = cut->uv + 2 * (size_t)j;
        const double d[2] = {q[0] - p[0], q[1] - p[1]}, square = d[0] * d[0] + d[1] * d[1];
        const double t = square > 0.0 ? ((u - p[0]) * d[0] + (v - p[1]) * d[1]) / square : 0.0;
        const double in = fmin(fmax(t, 0.0), 1.0);
        least = fmin(least, hypot(p[0] + in * d[0] - u, p[1] + in * d[1] - v));
    }
    return least;
}
