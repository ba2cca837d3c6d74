/*
 * body.c: contours and solids of bodies against formulas (cases K1-K4).
 *
 * K1 is the error of the founding paper's eq. 6, p = pi (3 (a + b) - sqrt((3a + b)(a + 3b))), on ellipses that the
 * library made: their perimeter is that of a polygon of 200000 corners, right to 4e-11. K2 is its inverse, held against
 * a body of true ellipses: p and q = b/a give a, to eq. 6's own 2e-8 there. K3: the polygon, not the curve, has the
 * tape's girth, and the curve is longer by O(1/N^2). K4: solids.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/args.h"
#include "verify.h"

#define PI 3.14159265358979323846
#define CORNERS 200000 /* of the polygon that stands for a curve */
#define STACKS 128     /* most contours of a solid */


static void row_or_broken(verify *v, mus_status status, const char *id, const char *text, double exact, double got,
                          double tolerance)
{
    if (status == MUS_OK)
        verify_add(v, id, text, exact, got, tolerance);
    else
        verify_broken(v, id, text, status);
}


/* a body of one limb along Y: `n` contours (n x 6), closing at low and high */
static mus_status solid(verify *v, int32_t n, const double *contour, double low, double high, mus_body **out)
{
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    limb.contours = n, limb.contour = contour;
    limb.pole[0] = low, limb.pole[1] = high;
    return mus_body_create_limbs(v->context, 1, &limb, NULL, out);
}


/* half breadth, half depth and perimeter of a contour as the library gives its points */
static mus_status curve(const mus_body *body, int32_t limb, int32_t contour, int32_t n, double *a, double *b, double *p)
{
    double *x = malloc(3 * (size_t)n * sizeof *x);
    if (x == NULL) return MUS_ERR_MEMORY;
    const mus_status status = mus_body_contour_points(body, limb, contour, n, x);
    *p = 0.0;
    for (int32_t k = 0; k < n && status == MUS_OK; k++) {
        const double *q = x + 3 * (ptrdiff_t)k, *r = x + 3 * (ptrdiff_t)((k + 1) % n);
        *p += sqrt((r[0] - q[0]) * (r[0] - q[0]) + (r[1] - q[1]) * (r[1] - q[1]) + (r[2] - q[2]) * (r[2] - q[2]));
    }
    *a = 0.5 * fabs(x[0] - x[3 * (ptrdiff_t)(n / 2)]);
    *b = 0.5 * fabs(x[3 * (ptrdiff_t)(n / 4) + 2] - x[3 * (ptrdiff_t)(3 * n / 4) + 2]);
    free(x);
    return status;
}


/* ---- K1: eq. 6 ---- */

static void perimeters(verify *v)
{
    static const struct {
        double q, error, tolerance;
    } row[] = {{0.7, -6.0e-8, 0.02},  {0.6, -4.9e-7, 0.01}, {0.5, -2.80e-6, 0.01},
               {0.3, -5.42e-5, 0.01}, {0.2, -2.1e-4, 0.03}, {0.1, -8.35e-4, 0.01}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const double q = row[i].q;
        const double contour[12] = {0.0, 0.0, 0.0, 0.3, 0.3 * q, 2.0, 1.0, 0.0, 0.0, 0.3, 0.3 * q, 2.0};
        double a = NAN, b = NAN, p = NAN;
        mus_body *body = NULL;
        mus_status status = solid(v, 2, contour, -0.01, 1.01, &body);
        if (status == MUS_OK) status = curve(body, 0, 0, CORNERS, &a, &b, &p);
        const double sixth = PI * (3.0 * (a + b) - sqrt((3.0 * a + b) * (a + 3.0 * b)));
        char text[120];
        snprintf(text, sizeof text, "ellipse b/a = %.1f: eq. 6 against its perimeter, off by", q);
        row_or_broken(v, status, "K1", text, row[i].error, sixth / p - 1.0, row[i].tolerance);
        mus_body_destroy(body);
    }
}


/* ---- K2, K3: a body of true ellipses ---- */

static mus_status woman(verify *v, int32_t samples, mus_body **out)
{
    mus_tape *tape = NULL;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = samples, def.ellipse = 1;
    mus_status status = mus_tape_create(v->context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(v->context, tape, &def, out);
    mus_tape_destroy(tape);
    return status;
}


static int32_t waist_of(const mus_body *body)
{
    for (int32_t i = 0; i < mus_body_contour_count(body, 0); i++)
        if (strcmp(mus_body_contour_name(body, 0, i), "waist") == 0) return i;
    return 0;
}


static void inverse(verify *v)
{
    double a = NAN, b = NAN, p = NAN, girth = NAN;
    mus_body *body = NULL;
    mus_status status = woman(v, 512, &body);
    if (status == MUS_OK) status = curve(body, 0, waist_of(body), CORNERS, &a, &b, &p);

    /* the ring of 512 has the tape's girth: the curve is longer, and it is the curve that eq. 6 is about */
    if (status == MUS_OK) girth = mus_body_made(body, MUS_MEASURE_WAIST);
    const double q = b / a, half = p / (PI * (3.0 * (1.0 + q) - sqrt((1.0 + 3.0 * q) * (3.0 + q))));
    row_or_broken(v, status, "K2", "waist of true ellipses: half breadth from girth and b/a [m]", half, a, 1e-7);
    row_or_broken(v, status, "K2", "its ring of 512 has the girth of the tape [m]", 0.76, girth, 1e-12);
    mus_body_destroy(body);
}


static void polygons(verify *v)
{
    static const int32_t samples[] = {16, 32, 64, 128, 256, 512};
    double before = NAN;
    for (int i = 0; i < 6; i++) {
        char text[120];
        double a = NAN, b = NAN, p = NAN, made = NAN, polygon = NAN;
        mus_body *body = NULL;
        const int32_t n = samples[i];
        mus_status status = woman(v, n, &body);
        if (status == MUS_OK) {
            made = mus_body_made(body, MUS_MEASURE_WAIST);
            status = curve(body, 0, waist_of(body), n, &a, &b, &polygon);
            if (status == MUS_OK) status = curve(body, 0, waist_of(body), CORNERS, &a, &b, &p);
        }
        snprintf(text, sizeof text, "girth of the waist of %d corners [m]", (int)n);
        row_or_broken(v, status, "K3", text, 0.76, made, 1e-12);
        const double more = p / polygon - 1.0;
        if (i > 0)
            row_or_broken(v, status, "K3", "the curve is longer: by how much more than at half the corners", 0.25,
                          more / before, 0.02);
        before = more;
        mus_body_destroy(body);
    }
}


/* ---- K4: solids ---- */

/* volume under the triangles; *open: area that is left over, *triple: triangles with three corners on one ring */
static double hull_of(const mus_body *body, int32_t samples, double *open, int32_t *triple)
{
    const double *x = mus_body_vertices(body);
    const int32_t *triangle = mus_body_triangles(body);
    double volume = 0.0, area[3] = {0.0, 0.0, 0.0};
    *triple = 0;
    for (int32_t t = 0; t < mus_body_triangle_count(body); t++, triangle += 3) {
        const double *p = x + 3 * (ptrdiff_t)triangle[0], *q = x + 3 * (ptrdiff_t)triangle[1];
        const double *r = x + 3 * (ptrdiff_t)triangle[2];
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            area[i] += 0.5 * ((q[j] - p[j]) * (r[k] - p[k]) - (q[k] - p[k]) * (r[j] - p[j]));
            volume += p[i] * (q[j] * r[k] - q[k] * r[j]) / 6.0;
        }
        int32_t ring[3];
        for (int i = 0; i < 3; i++) ring[i] = (triangle[i] - 1 + samples) / samples;
        *triple += ring[0] == ring[1] && ring[1] == ring[2];
    }
    *open = sqrt(area[0] * area[0] + area[1] * area[1] + area[2] * area[2]);
    return volume;
}


/* contours of a solid of height 1: half breadth along the axis by `shape`: 0 cylinder, 1 frustum, 2 ellipsoid */
static void stack_of(int shape, int32_t n, double *contour)
{
    for (int32_t i = 0; i < n; i++) {
        const double s = shape == 2 ? (i + 0.5) / n : (double)i / (n - 1), u = 2.0 * s - 1.0;
        const double size = shape == 0 ? 1.0 : shape == 1 ? 1.0 - 0.5 * s : sqrt(1.0 - u * u);
        const double row[6] = {s, 0.0, 0.0, 0.30 * size, 0.20 * size, 2.0};
        memcpy(contour + 6 * (ptrdiff_t)i, row, sizeof row);
    }
}


/* area of the polygon of n corners on the unit circle at equal steps of the diamond angle, over that of the circle */
static double diamond(int32_t n)
{
    double area = 0.0;
    for (int32_t k = 0; k < n / 4; k++) {
        const double a = 4.0 * k / n, b = 4.0 * (k + 1) / n;
        area += 2.0 * ((1.0 - a) * b - (1.0 - b) * a) / (hypot(1.0 - a, a) * hypot(1.0 - b, b));
    }
    return area / PI;
}


static void solids(verify *v)
{
    static const char *const names[] = {"cylinder", "frustum", "ellipsoid"};
    static const int32_t counts[] = {8, 32, 128};
    for (int shape = 0; shape < 3; shape++) {
        /* area 0.06 pi; the caps of cylinder and frustum are 1e-5 high */
        const double exact = 0.06 * PI * (shape == 0 ? 1.0 : shape == 1 ? 7.0 / 12.0 : 2.0 / 3.0);
        for (int i = 0; i < 3; i++) {
            char text[120];
            double contour[6 * STACKS], made = NAN, shell = NAN, open = NAN;
            int32_t triple = -1;
            mus_body *body = NULL;
            stack_of(shape, counts[i], contour);
            mus_status status =
                solid(v, counts[i], contour, shape == 2 ? 0.0 : -1e-5, shape == 2 ? 1.0 : 1.0 + 1e-5, &body);
            if (status == MUS_OK) made = mus_body_volume(body), shell = hull_of(body, 128, &open, &triple);
            const double tolerance = 2e-4 + (shape == 2 ? 0.5 / (counts[i] * counts[i]) : 0.0);
            snprintf(text, sizeof text, "%s of %d contours, volume [m3]", names[shape], (int)counts[i]);
            row_or_broken(v, status, "K4", text, exact, made, tolerance);
            snprintf(text, sizeof text, "its triangles, outwards and inscribed in 128 corners, volume [m3]");
            row_or_broken(v, status, "K4", text, exact * diamond(128), shell, 1e-3 + tolerance);
            row_or_broken(v, status, "K4", "area that is left open [m2]", 0.0, open, 1e-12);
            row_or_broken(v, status, "K4", "triangles with three corners on one contour", 0.0, triple, 0.0);
            mus_body_destroy(body);
        }
    }
}


int verify_body(verify *v)
{
    if (verify_wants(v, "K1")) perimeters(v);
    if (verify_wants(v, "K2")) inverse(v);
    if (verify_wants(v, "K3")) polygons(v);
    if (verify_wants(v, "K4")) solids(v);
    return EXIT_DONE;
}
