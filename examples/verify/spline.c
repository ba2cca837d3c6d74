/*
 * spline.c: natural and periodic cubic splines (cases N1-N3).
 *
 * A movement runs every number of its poses on such a spline, so the place of a root is any function of time that we
 * want sampled; the contours of a limb run on the same splines along its axis.
 */
#include <math.h>
#include <stdio.h>

#include "command/args.h"
#include "verify.h"

#define PI 3.14159265358979323846
#define KEYS_MOST 200
#define PROBES 32 /* in each interval */

typedef double (*curve)(double t);


static double hump(double t)
{
    return exp(sin(t));
}


/* a movement whose root is at x = y[i] at time t[i] */
static mus_status spline_make(verify *v, int32_t n, const double *t, const double *y, double period, mus_move **out)
{
    mus_pose poses[KEYS_MOST];
    for (int32_t i = 0; i < n; i++) {
        mus_pose_init(&poses[i], sizeof poses[i]);
        poses[i].place[0] = y[i];
    }
    return mus_move_create(v->context, n, t, poses, period, out);
}


static double spline_at(const mus_move *move, double t)
{
    mus_pose pose;
    return mus_move_at(move, t, &pose) == MUS_OK ? pose.place[0] : NAN;
}


/* ---- N1: order ---- */

/* largest error of the spline through n intervals of f on low .. high, over the part `from` .. `to` of it */
static double spline_error(verify *v, curve f, double low, double high, int32_t n, int periodic, double from,
                           double to)
{
    double t[KEYS_MOST], y[KEYS_MOST], most = 0.0;
    mus_move *move = NULL;
    const int32_t keys = periodic ? n : n + 1;
    for (int32_t i = 0; i < keys; i++) t[i] = low + (high - low) * i / n, y[i] = f(t[i]);
    if (spline_make(v, keys, t, y, periodic ? high - low : 0.0, &move) != MUS_OK) return NAN;
    for (int32_t i = 0; i <= n * PROBES; i++) {
        const double part = (double)i / (n * PROBES), x = low + (high - low) * part;
        if (part >= from && part <= to) most = fmax(most, fabs(spline_at(move, x) - f(x)));
    }
    mus_move_destroy(move);
    return most;
}


static void spline_order(verify *v)
{
    static const struct {
        const char *what;
        curve f;
        double low, high, from, to, order;
        int periodic;
    } row[] = {
        {"order, natural, sin 0..pi (f'' = 0 at the ends)", sin, 0, PI, 0, 1, 4, 0},
        {"order, natural, exp 0..1, all of it", exp, 0, 1, 0, 1, 2, 0},
        {"order, natural, exp 0..1, inner third", exp, 0, 1, 1.0 / 3, 2.0 / 3, 4, 0},
        {"order, natural, cos 0..1, all of it", cos, 0, 1, 0, 1, 2, 0},
        {"order, natural, cos 0..1, inner third", cos, 0, 1, 1.0 / 3, 2.0 / 3, 4, 0},
        {"order, periodic, exp sin 0..2 pi", hump, 0, 2 * PI, 0, 1, 4, 1},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        for (int32_t n = 32; n <= 64; n *= 2) {
            char text[96];
            const double coarse =
                spline_error(v, row[i].f, row[i].low, row[i].high, n, row[i].periodic, row[i].from, row[i].to);
            const double fine =
                spline_error(v, row[i].f, row[i].low, row[i].high, 2 * n, row[i].periodic, row[i].from, row[i].to);
            snprintf(text, sizeof text, "%s, n %d to %d", row[i].what, (int)n, (int)(2 * n));
            verify_add(v, "N1", text, row[i].order, log2(coarse / fine), 0.1 / row[i].order);
        }
}


/* ---- N2: identities ---- */

/* uneven times and values without an order: a generator of Park and Miller 1988 */
static void spline_data(int32_t n, double *t, double *y)
{
    int64_t seed = 20;
    double at = 0.0;
    for (int32_t i = 0; i < n; i++) {
        seed = seed * 48271 % 2147483647;
        at += 2.0 + (double)seed / 2147483647.0;
        t[i] = at;
        seed = seed * 48271 % 2147483647;
        y[i] = 2.0 * (double)seed / 2147483647.0 - 1.0;
    }
}


/* second derivative of the cubic on one side of t: exact from four points a step apart */
static double spline_bend(const mus_move *move, double t, double h)
{
    return (2.0 * spline_at(move, t) - 5.0 * spline_at(move, t + h) + 4.0 * spline_at(move, t + 2.0 * h) -
            spline_at(move, t + 3.0 * h)) / (h * h);
}


static void spline_identities(verify *v)
{
    enum { N = 16 };
    double t[N], y[N], line[N], miss[2] = {0, 0}, jump[2] = {0, 0}, off = 0.0;
    spline_data(N, t, y);
    for (int periodic = 0; periodic < 2; periodic++) {
        mus_move *move = NULL;
        const double period = periodic ? t[N - 1] - t[0] + 2.5 : 0.0;
        const mus_status status = spline_make(v, N, t, y, period, &move);
        if (status != MUS_OK) {
            verify_broken(v, "N2", "spline through random data", status);
            return;
        }
        for (int32_t i = 0; i < N; i++) {
            miss[periodic] = fmax(miss[periodic], fabs(spline_at(move, t[i]) - y[i]));
            if (!periodic && (i == 0 || i == N - 1)) continue;
            const double left = spline_bend(move, t[i], -0.65), right = spline_bend(move, t[i], 0.65);
            jump[periodic] = fmax(jump[periodic], fabs(right - left));
        }
        mus_move_destroy(move);
    }
    for (int32_t i = 0; i < N; i++) line[i] = 0.3 - 0.01 * t[i];
    mus_move *move = NULL;
    if (spline_make(v, N, t, line, 0.0, &move) == MUS_OK)
        for (int32_t i = 0; i <= 1000; i++) {
            const double x = t[0] + (t[N - 1] - t[0]) * i / 1000.0;
            off = fmax(off, fabs(spline_at(move, x) - (0.3 - 0.01 * x)));
        }
    mus_move_destroy(move);
    verify_add(v, "N2", "natural, random data: largest miss of a point [m]", 0.0, miss[0], 1e-13);
    verify_add(v, "N2", "periodic, random data: largest miss of a point [m]", 0.0, miss[1], 1e-13);
    verify_add(v, "N2", "natural, random data: largest jump of the second derivative", 0.0, jump[0], 1e-13);
    verify_add(v, "N2", "periodic, random data: largest jump of the second derivative", 0.0, jump[1], 1e-13);
    verify_add(v, "N2", "natural, a straight line at uneven points: largest error [m]", 0.0, off, 1e-13);
}


/* a cone of five contours at uneven heights, r = 0.2 - 0.1 s */
static void spline_cone(verify *v)
{
    static const double s[] = {0.0, 0.13, 0.2, 0.55, 1.0};
    double rows[30], off = 0.0;
    mus_limb limb;
    mus_body *body = NULL;
    mus_limb_init(&limb, sizeof limb);
    for (int i = 0; i < 5; i++) {
        const double r = 0.2 - 0.1 * s[i], row[6] = {s[i], 0.0, 0.0, r, r, 2.0};
        for (int k = 0; k < 6; k++) rows[6 * i + k] = row[k];
    }
    limb.pole[0] = -0.1, limb.pole[1] = 1.05;
    limb.contours = 5, limb.contour = rows;
    const mus_status status = mus_body_create_limbs(v->context, 1, &limb, NULL, &body);
    if (status != MUS_OK) {
        verify_broken(v, "N2", "a cone", status);
        return;
    }
    const double *x = mus_body_vertices(body);
    for (int32_t i = 0; i < mus_body_vertex_count(body); i++, x += 3)
        if (x[1] >= 0.0 && x[1] <= 1.0)
            off = fmax(off, fabs(sqrt(x[0] * x[0] + x[2] * x[2]) - (0.2 - 0.1 * x[1])));
    /* the surface is read from the table of radii of the limb: 1 um is its own accuracy on a straight side */
    verify_add(v, "N2", "a limb of five contours of a cone: largest error of the radius [m]", 0.0, off, 1e-6);
    mus_body_destroy(body);
}


/* ---- N3: data that is no spline's ---- */

static void spline_refused(verify *v)
{
    static const double equal[] = {0, 1, 1, 2}, unsorted[] = {0, 2, 1, 3}, y[] = {0.5, 1, 2, 3};
    static const double cylinder[] = {0, 0, 0, 0.1, 0.1, 2, 0, 0, 0, 0.1, 0.1, 2};
    mus_move *move = NULL;
    verify_add(v, "N3", "two equal times: status (an error)", MUS_ERR_ARG,
               spline_make(v, 4, equal, y, 0.0, &move), 0.0);
    verify_add(v, "N3", "times that are not sorted: status (an error)", MUS_ERR_ARG,
               spline_make(v, 4, unsorted, y, 0.0, &move), 0.0);
    verify_add(v, "N3", "no point: status (an error)", MUS_ERR_ARG, spline_make(v, 0, equal, y, 0.0, &move), 0.0);
    verify_add(v, "N3", "two points, periodic: status (an error)", MUS_ERR_ARG,
               spline_make(v, 2, equal, y, 3.0, &move), 0.0);

    double off = 0.0;
    if (spline_make(v, 2, equal, y, 0.0, &move) != MUS_OK) off = NAN;
    for (int i = 0; i <= 100; i++) off = fmax(off, fabs(spline_at(move, 0.01 * i) - (0.5 + 0.005 * i)));
    verify_add(v, "N3", "two points: distance from the straight line [m]", 0.0, off, 1e-15);
    mus_move_destroy(move);
    move = NULL;
    off = spline_make(v, 1, equal, y, 0.0, &move) == MUS_OK ? fabs(spline_at(move, 3.0) - 0.5) : NAN;
    verify_add(v, "N3", "one point: distance from the constant [m]", 0.0, off, 0.0);
    mus_move_destroy(move);

    mus_limb limb;
    mus_body *body = NULL;
    mus_limb_init(&limb, sizeof limb);
    limb.pole[0] = -0.1, limb.pole[1] = 0.1;
    limb.contours = 2, limb.contour = cylinder;
    verify_add(v, "N3", "two contours at one height: status (an error)", MUS_ERR_BODY,
               mus_body_create_limbs(v->context, 1, &limb, NULL, &body), 0.0);
    limb.contours = 1;
    verify_add(v, "N3", "a limb of one contour: status (an error)", MUS_ERR_ARG,
               mus_body_create_limbs(v->context, 1, &limb, NULL, &body), 0.0);
}


int verify_spline(verify *v)
{
    if (verify_wants(v, "N1")) spline_order(v);
    if (verify_wants(v, "N2")) {
        spline_identities(v);
        spline_cone(v);
    }
    if (verify_wants(v, "N3")) spline_refused(v);
    return EXIT_DONE;
}
