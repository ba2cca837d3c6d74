/* solids.c: meshes with known answers. */
#include "scan/solids.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/vec.h"
#include "muslin/muslin.h"
#include "support.h"


/* rings (rings x n x 3 vertices) between a lower and an upper point, as triangles */
static void solid_rings(int32_t rings, int32_t n, solid *out)
{
    out->vertices = rings * n + 2;
    out->triangles = 2 * n * rings;
    out->x = calloc(3 * (size_t)out->vertices, sizeof *out->x);
    out->triangle = calloc(3 * (size_t)out->triangles, sizeof *out->triangle);
    ck_assert(out->x != NULL && out->triangle != NULL);
    int32_t *t = out->triangle;
    const int32_t low = rings * n, high = rings * n + 1;
    for (int32_t k = 0; k < n; k++, t += 6) {
        const int32_t next = (k + 1) % n, top = (rings - 1) * n;
        t[0] = low, t[1] = k, t[2] = next;
        t[3] = high, t[4] = top + next, t[5] = top + k;
    }
    for (int32_t r = 0; r + 1 < rings; r++)
        for (int32_t k = 0; k < n; k++, t += 6) {
            const int32_t a = r * n + k, b = r * n + (k + 1) % n;
            t[0] = a, t[1] = a + n, t[2] = b;
            t[3] = b, t[4] = a + n, t[5] = b + n;
        }
}


void solid_ellipsoid(int32_t n, double a, double b, double c, solid *out)
{
    const int32_t rings = n / 2;
    solid_rings(rings, n, out);
    for (int32_t r = 0; r < rings; r++)
        for (int32_t k = 0; k < n; k++) {
            const double up = MUS_PI * (r + 1) / (rings + 1), t = 2.0 * MUS_PI * k / n;
            double *x = out->x + 3 * (ptrdiff_t)(r * n + k);
            x[0] = a * sin(up) * cos(t), x[1] = -b * cos(up), x[2] = c * sin(up) * sin(t);
        }
    out->x[3 * (ptrdiff_t)(rings * n) + 1] = -b;
    out->x[3 * (ptrdiff_t)(rings * n) + 4] = b;
}


void solid_cylinder(int32_t n, double a, double c, double height, solid *out)
{
    solid_rings(2, n, out);
    for (int32_t r = 0; r < 2; r++)
        for (int32_t k = 0; k < n; k++) {
            double *x = out->x + 3 * (ptrdiff_t)(r * n + k);
            x[0] = a * cos(2.0 * MUS_PI * k / n), x[1] = r * height, x[2] = c * sin(2.0 * MUS_PI * k / n);
        }
    out->x[3 * (ptrdiff_t)(2 * n) + 4] = height;
}


void solid_person(const char *size, const char *stance, solid *out)
{
    mus_context *context;
    mus_tape *tape;
    mus_body *body;
    mus_pose pose;
    ck_assert_int_eq(mus_context_create(NULL, &context), MUS_OK);
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, size), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    if (stance != NULL) {
        mus_body *rest = body;
        ck_assert_int_eq(mus_pose_named(context, stance, &pose), MUS_OK);
        ck_assert_int_eq(mus_body_pose(rest, &pose, &body), MUS_OK);
        mus_body_destroy(rest);
    }
    out->vertices = mus_body_vertex_count(body), out->triangles = mus_body_triangle_count(body);
    out->x = calloc(3 * (size_t)out->vertices, sizeof *out->x);
    out->triangle = calloc(3 * (size_t)out->triangles, sizeof *out->triangle);
    ck_assert(out->x != NULL && out->triangle != NULL);
    memcpy(out->x, mus_body_vertices(body), 3 * (size_t)out->vertices * sizeof *out->x);
    memcpy(out->triangle, mus_body_triangles(body), 3 * (size_t)out->triangles * sizeof *out->triangle);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
}


void solid_free(solid *s)
{
    free(s->x);
    free(s->triangle);
}


void solid_move(solid *s, double unit, const double *turn, const double *place)
{
    for (int32_t v = 0; v < s->vertices; v++) {
        double *x = s->x + 3 * (ptrdiff_t)v, to[3];
        for (int i = 0; i < 3; i++) to[i] = unit * mus__dot3(turn + 3 * i, x) + (place != NULL ? place[i] : 0.0);
        memcpy(x, to, sizeof to);
    }
}
