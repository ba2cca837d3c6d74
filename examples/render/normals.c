/*
 * normals.c: smooth normals for meshes that come without.
 *
 * The normal of a vertex is the sum of its triangles' normals weighted by their angle at it, and vertices that lie at
 * the same place share one, so that a seam between panels does not show. Places are found by sorting. Source:
 * Thuermer and Wuethrich, Computing Vertex Normals from Polygonal Facets, 1998.
 */
#include "render_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct normal_place {
    double p[3];
    int32_t vertex;
} normal_place;


static int normal_place_compare(const void *a, const void *b)
{
    const normal_place *x = a, *y = b;

    for (int k = 0; k < 3; k++)
        if (x->p[k] != y->p[k]) return x->p[k] < y->p[k] ? -1 : 1;
    return x->vertex < y->vertex ? -1 : x->vertex > y->vertex;
}


/* add a triangle's normal to its corners; angle = atan2(|u x v|, u . v) */
static void normal_triangle(const double *positions, const int32_t *t, double *normals)
{
    for (int k = 0; k < 3; k++) {
        const double *a = positions + 3 * (ptrdiff_t)t[k], *b = positions + 3 * (ptrdiff_t)t[(k + 1) % 3];
        const double *c = positions + 3 * (ptrdiff_t)t[(k + 2) % 3];
        double u[3], v[3], n[3], angle;

        for (int i = 0; i < 3; i++) {
            u[i] = b[i] - a[i];
            v[i] = c[i] - a[i];
        }
        render_cross(n, u, v);
        angle = atan2(sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
        render_normalise(n);
        for (int i = 0; i < 3; i++) normals[3 * (ptrdiff_t)t[k] + i] += angle * n[i];
    }
}


int render_normals(int32_t vertex_count, const double *positions, int32_t triangle_count, const int32_t *triangles,
                   double *normals)
{
    normal_place *places = malloc((size_t)vertex_count * sizeof *places);

    if (!places) return -1;
    memset(normals, 0, 3 * (size_t)vertex_count * sizeof *normals);
    for (int32_t i = 0; i < triangle_count; i++) normal_triangle(positions, triangles + 3 * (ptrdiff_t)i, normals);

    /* + 0.0 turns -0 into 0: both are one place */
    for (int32_t i = 0; i < vertex_count; i++) {
        for (int k = 0; k < 3; k++) places[i].p[k] = positions[3 * (ptrdiff_t)i + k] + 0.0;
        places[i].vertex = i;
    }
    qsort(places, (size_t)vertex_count, sizeof *places, normal_place_compare);

    /* one normal for each run of equal places */
    for (int32_t i = 0, j; i < vertex_count; i = j) {
        double sum[3] = {0, 0, 0};
        for (j = i; j < vertex_count && !memcmp(places[j].p, places[i].p, sizeof places[i].p); j++)
            for (int k = 0; k < 3; k++) sum[k] += normals[3 * (ptrdiff_t)places[j].vertex + k];
        render_normalise(sum);
        for (int32_t m = i; m < j; m++) memcpy(normals + 3 * (ptrdiff_t)places[m].vertex, sum, sizeof sum);
    }
    free(places);
    return 0;
}
