/*
 * frame.c: rotations as unit quaternions and matrices, and frames that carry points and directions.
 */
#include "body/frame.h"

#include <math.h>
#include <string.h>


void mus__quaternion_product(const double *a, const double *b, double *out)
{
    double q[4] = {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
                   a[0] * b[1] + a[1] * b[0] + (a[2] * b[3] - a[3] * b[2]),
                   a[0] * b[2] + a[2] * b[0] + (a[3] * b[1] - a[1] * b[3]),
                   a[0] * b[3] + a[3] * b[0] + (a[1] * b[2] - a[2] * b[1])};
    memcpy(out, q, sizeof q);
}


void mus__quaternion_conjugate(const double *a, double *out)
{
    out[0] = a[0], out[1] = -a[1], out[2] = -a[2], out[3] = -a[3];
}


void mus__quaternion_normalise(double *q)
{
    double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; i++) q[i] /= length;
}


/* rotation of a unit quaternion, row by row */
void mus__quaternion_matrix(const double *q, double *out)
{
    double w = q[0], x = q[1], y = q[2], z = q[3];
    out[0] = 1.0 - 2.0 * (y * y + z * z), out[1] = 2.0 * (x * y - w * z), out[2] = 2.0 * (x * z + w * y);
    out[3] = 2.0 * (x * y + w * z), out[4] = 1.0 - 2.0 * (x * x + z * z), out[5] = 2.0 * (y * z - w * x);
    out[6] = 2.0 * (x * z - w * y), out[7] = 2.0 * (y * z + w * x), out[8] = 1.0 - 2.0 * (x * x + y * y);
}


/* unit quaternion of a rotation: Shepperd 1978, the largest of the four first */
void mus__quaternion_of(const double *m, double *q)
{
    double trace = m[0] + m[4] + m[8];
    double square[4] = {1.0 + trace, 1.0 + 2.0 * m[0] - trace, 1.0 + 2.0 * m[4] - trace, 1.0 + 2.0 * m[8] - trace};
    int most = 0;
    for (int i = 1; i < 4; i++)
        if (square[i] > square[most]) most = i;

    /* sums and differences of the mirror entries are 4 q_i q_j */
    double wx = m[7] - m[5], wy = m[2] - m[6], wz = m[3] - m[1];
    double xy = m[3] + m[1], xz = m[2] + m[6], yz = m[7] + m[5];
    double row[4][4] = {
        {square[0], wx, wy, wz}, {wx, square[1], xy, xz}, {wy, xy, square[2], yz}, {wz, xz, yz, square[3]}};
    memcpy(q, row[most], sizeof row[most]);
    mus__quaternion_normalise(q);
}


void mus__matrix_product(const double *a, const double *b, double *out)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            out[3 * i + k] = a[3 * i] * b[k] + a[3 * i + 1] * b[3 + k] + a[3 * i + 2] * b[6 + k];
}


void mus__frame_turn_back(const mus__frame *frame, const double *x, double *out)
{
    double y[3];
    for (int i = 0; i < 3; i++)
        y[i] = frame->turn[i] * x[0] + frame->turn[3 + i] * x[1] + frame->turn[6 + i] * x[2];
    memcpy(out, y, sizeof y);
}


void mus__frame_back(const mus__frame *frame, const double *x, double *out)
{
    const double d[3] = {x[0] - frame->place[0], x[1] - frame->place[1], x[2] - frame->place[2]};
    mus__frame_turn_back(frame, d, out);
}
