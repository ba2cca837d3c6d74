/*
 * frame.h: rigid motions: a frame turns a point and then moves it.
 *
 * Quaternions are (w, x, y, z) with w the cosine of half the angle; matrices are 3 x 3, row by row. Outputs may be one
 * of the inputs, but not those of mus__matrix_product().
 */
#ifndef MUS_BODY_FRAME_H
#define MUS_BODY_FRAME_H

/* x = turn * rest + place, turn row by row */
typedef struct mus__frame {
    double turn[9], place[3];
} mus__frame;

/* out = a b: the rotation b, then the rotation a */
void mus__quaternion_product(const double *a, const double *b, double *out);
/* the opposite rotation */
void mus__quaternion_conjugate(const double *a, double *out);
/* scale q (4) to length 1 */
void mus__quaternion_normalise(double *q);
/* the matrix (9) of a unit quaternion */
void mus__quaternion_matrix(const double *q, double *out);
/* the unit quaternion of a rotation matrix m (9) */
void mus__quaternion_of(const double *m, double *q);
/* out (9) = a b */
void mus__matrix_product(const double *a, const double *b, double *out);

/* out (3) = turn x. Inline, as the two below: contact needs them, and links no code of a body */
static inline void mus__matrix_point(const double *turn, const double *x, double *out)
{
    double y[3];
    for (int i = 0; i < 3; i++) y[i] = turn[3 * i] * x[0] + turn[3 * i + 1] * x[1] + turn[3 * i + 2] * x[2];
    for (int i = 0; i < 3; i++) out[i] = y[i];
}


/* out (3) = turn * x + place for a point */
static inline void mus__frame_point(const mus__frame *frame, const double *x, double *out)
{
    mus__matrix_point(frame->turn, x, out);
    for (int i = 0; i < 3; i++) out[i] += frame->place[i];
}


/* out (3) = turn * x for a direction */
static inline void mus__frame_turn(const mus__frame *frame, const double *x, double *out)
{
    mus__matrix_point(frame->turn, x, out);
}

/* the opposite motion of a point: out (3) = transpose of turn * (x - place) */
void mus__frame_back(const mus__frame *frame, const double *x, double *out);
/* the opposite rotation of a direction: out (3) = transpose of turn * x */
void mus__frame_turn_back(const mus__frame *frame, const double *x, double *out);

#endif
