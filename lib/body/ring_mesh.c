/*
 * ring_mesh.c: triangles and normals of a closed surface of rings: an end point, rings of n vertices, an end point.
 *
 * Vertex 0 is the lower end point, then ring by ring, then the upper end point. Used for the limbs of a body and for
 * its fingers and toes.
 */
#include <math.h>

#include "body/body_make.h"
#include "geom/vec.h"


void mus__ring_triangles(int32_t vertex, int32_t rings, int32_t n, int32_t *out)
{
    int32_t first = vertex + 1, top = first + n * rings, high = first + n * (rings - 1);
    for (int32_t k = 0; k < n; k++, out += 3) {
        out[0] = first - 1, out[1] = first + (k + 1) % n, out[2] = first + k;
    }
    for (int32_t j = 0; j + 1 < rings; j++) {
        int32_t low = first + n * j;
        for (int32_t k = 0; k < n; k++, out += 6) {
            int32_t next = k + 1 < n ? k + 1 : 0;
            out[0] = low + k, out[1] = low + next, out[2] = low + n + k;
            out[3] = low + next, out[4] = low + n + next, out[5] = low + n + k;
        }
    }
    for (int32_t k = 0; k < n; k++, out += 3) {
        out[0] = high + k, out[1] = high + (k + 1) % n, out[2] = top;
    }
}


/* unit normal (3): direction of the vector area of the hexagon q0 .. q5 of a vertex's neighbours, which is the sum of
 * the vector areas of the triangles round the vertex */
static void ring_hexagon(const double *q0, const double *q1, const double *q2, const double *q3, const double *q4,
                            const double *q5, double *out)
{
    /* (q2 - q0) x (q3 - q1) + (q4 - q0) x (q5 - q3); in scalars, which stay in registers */
    const double ux = q2[0] - q0[0], uy = q2[1] - q0[1], uz = q2[2] - q0[2];
    const double vx = q3[0] - q1[0], vy = q3[1] - q1[1], vz = q3[2] - q1[2];
    const double wx = q4[0] - q0[0], wy = q4[1] - q0[1], wz = q4[2] - q0[2];
    const double tx = q5[0] - q3[0], ty = q5[1] - q3[1], tz = q5[2] - q3[2];
    const double x = uy * vz - uz * vy + wy * tz - wz * ty;
    const double y = uz * vx - ux * vz + wz * tx - wx * tz;
    const double z = ux * vy - uy * vx + wx * ty - wy * tx;
    const double square = x * x + y * y + z * z, inverse = square > 0.0 ? 1.0 / sqrt(square) : 0.0;
    out[0] = x * inverse, out[1] = y * inverse, out[2] = z * inverse;
}


/* below the first ring and above the last one the end point stands for all neighbours */
void mus__ring_normals(const double *x, int32_t n, int32_t rings, int32_t from, double *normals)
{
    const ptrdiff_t row = 3 * (ptrdiff_t)n;
    const double *low = x, *high = x + 3 + rings * row;
    for (int32_t j = from; j < rings; j++) {
        const double *p = x + 3 + j * row, *below = j > 0 ? p - row : low, *above = j + 1 < rings ? p + row : high;
        const ptrdiff_t under = j > 0 ? 1 : 0, over = j + 1 < rings ? 1 : 0, end = row - 3;
        double *out = normals + 3 + j * row;
        ring_hexagon(p + 3, above, above + over * end, p + end, below, below + under * 3, out);
        for (ptrdiff_t here = 3; here < end; here += 3)
            ring_hexagon(p + here + 3, above + over * here, above + over * (here - 3), p + here - 3,
                         below + under * here, below + under * (here + 3), out + here);
        ring_hexagon(p, above + over * end, above + over * (end - 3), p + end - 3, below + under * end, below,
                     out + end);
    }

    /* an end point: the vector area of its ring */
    for (int end = 0; end < 2; end++) {
        const double *p = x + 3 + (end == 0 ? 0 : (rings - 1) * row);
        double *out = normals + (end == 0 ? 0 : 3 + rings * row), cross[3];
        out[0] = out[1] = out[2] = 0.0;
        for (int32_t k = 0; k < n; k++) {
            const double *q = p + 3 * (ptrdiff_t)k, *r = p + 3 * (ptrdiff_t)((k + 1) % n);
            const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
            mus__cross3(u, v, cross);
            for (int i = 0; i < 3; i++) out[i] += end == 0 ? -cross[i] : cross[i];
        }
        mus__unit3(out);
    }
}
