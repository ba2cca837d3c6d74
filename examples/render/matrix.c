/*
 * matrix.c: the few matrices and vectors of the renderer.
 *
 * Column-major 4 x 4 in float as OpenGL takes them, computed in double. Right-handed; the camera looks along -z.
 */
#include "render_internal.h"

#include <math.h>
#include <string.h>


void render_cross(double *out, const double *a, const double *b)
{
    double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];

    out[0] = x;
    out[1] = y;
    out[2] = z;
}


/* a zero vector stays zero */
void render_normalise(double *v)
{
    double l = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    for (int k = 0; k < 3 && l > 0; k++) v[k] /= l;
}


/* out = a b; out may not be a or b */
void render_matrix_multiply(float *out, const float *a, const float *b)
{
    for (int c = 0; c < 4; c++)
        for (int r = 0; r < 4; r++) {
            double sum = 0;
            for (int k = 0; k < 4; k++) sum += (double)a[4 * k + r] * (double)b[4 * c + k];
            out[4 * c + r] = (float)sum;
        }
}


/* world to the frame of an eye that looks along `forward` (unit); `up` is any direction not along it */
void render_matrix_look(float *out, const double *eye, const double *forward, const double *up)
{
    double axis[3][3];

    render_cross(axis[0], forward, up);
    render_normalise(axis[0]);
    render_cross(axis[1], axis[0], forward);
    for (int k = 0; k < 3; k++) axis[2][k] = -forward[k];

    memset(out, 0, 16 * sizeof *out);
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) out[4 * c + r] = (float)axis[r][c];
        out[12 + r] = (float)-(axis[r][0] * eye[0] + axis[r][1] * eye[1] + axis[r][2] * eye[2]);
    }
    out[15] = 1.0f;
}


/* tangents are of half the angle of view */
void render_matrix_perspective(float *out, double tangent_x, double tangent_y, double near, double far)
{
    memset(out, 0, 16 * sizeof *out);
    out[0] = (float)(1.0 / tangent_x);
    out[5] = (float)(1.0 / tangent_y);
    out[10] = (float)(-(far + near) / (far - near));
    out[11] = -1.0f;
    out[14] = (float)(-2.0 * far * near / (far - near));
}


/* a box of eye space to the cube -1..1; the eye looks along -z, so high[2] is near */
void render_matrix_box(float *out, const double *low, const double *high)
{
    memset(out, 0, 16 * sizeof *out);
    for (int k = 0; k < 3; k++) {
        double sign = k == 2 ? -1.0 : 1.0, size = high[k] - low[k];
        out[5 * k] = (float)(sign * 2.0 / size);
        out[12 + k] = (float)(-sign * (high[k] + low[k]) / size);
    }
    out[15] = 1.0f;
}
