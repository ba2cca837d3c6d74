/*
 * collide.c: collisions and bodies that glide: bullets, the sphere of contours, a body out of reach, a scene in
 * motion, a body pushed up under a cloth (cases C1, C3, C5, V2, V3; C4 is in contour.c).
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command/args.h"
#include "limbs.h"


/* ---- C1: bullets ---- */

/* one step from where a straight path meets the roller part of the way on: with all friction the node stays where it
 * hit, so that its place tells the time */
static mus_status bullet(verify *v, const mus_body *body, double speed, double h, double part, double off, bool glide,
                         double *late, double *deep)
{
    const double r = 0.06, exact = part * h, chord = sqrt(r * r - off * off);
    const double place[3] = {chord + exact * speed, off, 0.0}, velocity[3] = {glide ? 0.0 : -speed, 0.0, 0.0};
    const double other[3] = {glide ? speed : 0.0, 0.0, 0.0};
    mus_drape *drape = NULL;
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_status status = limb_meet_point(v, body, INFINITY, 0.0, place, velocity, &drape);
    if (status == MUS_OK) status = mus_drape_move_body(drape, other);
    if (status == MUS_OK) status = mus_drape_step(drape, 1, h);
    if (status == MUS_OK) status = mus_drape_report_get(drape, &report);

    /* in the body's frame it stays at `chord`, and was there when it had gone from its start to it */
    const double stayed = status == MUS_OK ? mus_drape_positions(drape)[0] - (glide ? speed * h : 0.0) : 0.0;
    *late = (place[0] - stayed) / speed - exact;
    *deep = report.max_penetration;
    mus_drape_destroy(drape);
    return status;
}


static void bullets(verify *v)
{
    static const double speeds[] = {1.0, 3.0, 10.0, 30.0, 100.0}, steps[] = {1e-4, 1e-3, 1e-2};
    static const double parts[] = {0.02, 0.3, 0.7, 0.999}, offs[] = {0.0, 0.02, 0.05, 0.059};
    for (int glide = 0; glide < 2; glide++) {
        mus_body *body = NULL;
        double worst[3] = {0.0}, late, deep; /* time where swept, time elsewhere over the step, depth */
        mus_status status = limb_make_roller(v, 0.06, 0.06, 2.0, &body);
        for (int c = 0; c < 5 * 3 * 4 * 4 && status == MUS_OK; c++) {
            const double speed = speeds[c % 5], h = steps[c / 5 % 3];
            status = bullet(v, body, speed, h, parts[c / 15 % 4], offs[c / 60], glide, &late, &deep);
            if (speed * h > 0.031)
                worst[0] = fmax(worst[0], fabs(late));
            else
                worst[1] = fmax(worst[1], fabs(late) / h);
            worst[2] = fmax(worst[2], deep);
        }
        limb_row(v, status, "C1",
                 glide ? "roller at 1-100 m/s, steps to 1 m: hit too late [s]"
                       : "bullets at 1-100 m/s, steps to 1 m: hit too late [s]",
                 0.0, worst[0], 1e-9);
        limb_row(v, status, "C1", "the same, steps shorter than the limb is thick: part of the step", 0.0, worst[1],
                 1.0);
        limb_row(v, status, "C1", "deepest of all [m]", 0.0, worst[2], 1e-9);
        mus_body_destroy(body);
    }
}


/* ---- C3: a sphere of contours ---- */

/* errors at points of a true sphere of radius r: depth, angle of the normal up to 0.9 r from the middle, the same
 * beyond, where a natural spline ends, and both at the poles themselves */
static mus_status sphere_errors(const mus_body *body, double r, double *out)
{
    uint64_t random = 7;
    mus_status status = MUS_OK;
    memset(out, 0, 4 * sizeof *out);
    for (int i = 0; i < 4000 && status == MUS_OK; i++) {
        const double y =
            i < 400 ? (i % 2 ? -1.0 : 1.0) * (1.0 - 1e-9 * pow(i / 2, 3.0)) : 2.0 * limb_random(&random) - 1.0;
        const double turn = 2.0 * PI * limb_random(&random), flat = sqrt(1.0 - y * y);
        const double p[3] = {r * flat * cos(turn), r * y, r * flat * sin(turn)};
        double depth, n[3];
        status = mus_body_depth(body, 1, p, &depth, n);
        const double a = n[1] * p[2] - n[2] * p[1], b = n[2] * p[0] - n[0] * p[2], c = n[0] * p[1] - n[1] * p[0];
        const double angle = sqrt(a * a + b * b + c * c) / r;
        double *kind = i < 2 ? &out[3] : fabs(y) < 0.9 ? &out[1] : &out[2];
        out[0] = fmax(out[0], fabs(depth));
        *kind = fmax(*kind, i < 2 ? fmax(fabs(depth), angle) : angle);
    }
    return status;
}


static void spheres(verify *v)
{
    for (int32_t n = 16; n <= 64; n *= 2) {
        mus_body *body = NULL;
        double got[4] = {0.0};
        char text[80];
        mus_status status = limb_make_sphere(v, 0.2, n, &body);
        if (status == MUS_OK) status = sphere_errors(body, 0.2, got);
        snprintf(text, sizeof text, "sphere of %d contours: depth on the skin over its radius", (int)n);
        limb_row(v, status, "C3", text, 0.0, got[0] / 0.2, 1.6 / (n * n));
        snprintf(text, sizeof text, "sphere of %d contours: normal off the radius [rad]", (int)n);
        limb_row(v, status, "C3", text, 0.0, got[1], 25.0 / (n * n));
        snprintf(text, sizeof text, "sphere of %d contours: the same next to its poles", (int)n);
        limb_row(v, status, "C3", text, 0.0, got[2], 1.6 / n);
        snprintf(text, sizeof text, "sphere of %d contours: depth and normal at its poles", (int)n);
        limb_row(v, status, "C3", text, 0.0, got[3], 1e-12);
        mus_body_destroy(body);
    }
}


/* ---- C5: a body out of reach ---- */

static void out_of_reach(verify *v)
{
    uint64_t hash[2] = {0};
    mus_status status = MUS_OK;
    for (int with = 0; with < 2 && status == MUS_OK; with++) {
        double rows[12];
        const mus_limb limb = limb_roller(10.0, 0.0, 0.1, 0.1, 2.0, rows);
        mus_body *body = NULL;
        mus_drape *drape = NULL;
        if (with) status = mus_body_create_limbs(v->context, 1, &limb, NULL, &body);
        if (status == MUS_OK) status = limb_meet_sheet(v, body, 12, 0.02, 1.0, -2.0, &drape);
        if (status == MUS_OK) status = mus_drape_pin(drape, 0, 1);
        if (status == MUS_OK) status = mus_drape_step(drape, 500, 0.9 * mus_drape_step_bound(drape));
        hash[with] = mus_drape_hash(drape);
        mus_drape_destroy(drape);
        mus_body_destroy(body);
    }
    limb_row(v, status, "C5", "a body 10 m away changes bytes of the cloth", 0.0, hash[0] == hash[1] ? 0.0 : 1.0, 0.0);
}


/* ---- V2: a scene that moves is the scene at rest, moved ---- */

static void galileo(verify *v)
{
    static const double up[3] = {0.0, 10.0, 0.0}, slant[3] = {6.0, 8.0, 0.0};
    const double *const speeds[2] = {up, slant};
    enum { N = 12, NODES = N * N };
    for (int way = 0; way < 2; way++) {
        mus_body *body = NULL;
        mus_drape *drape[2] = {NULL, NULL};
        double worst = 0.0;
        mus_status status = limb_make_roller(v, 0.15, 0.15, 2.0, &body);
        for (int moves = 0; moves < 2 && status == MUS_OK; moves++) {
            status = limb_meet_sheet(v, body, N, 0.02, 0.153, 0.0, &drape[moves]);
            if (status != MUS_OK || !moves) continue;
            double velocity[3 * NODES];
            for (int i = 0; i < 3 * NODES; i++) velocity[i] = speeds[way][i % 3];
            status = mus_drape_set_state(drape[1], mus_drape_positions(drape[0]), velocity);
            if (status == MUS_OK) status = mus_drape_move_body(drape[1], speeds[way]);
        }
        for (int part = 0; part < 10 && status == MUS_OK; part++) {
            const double h = 0.1 / ceil(0.1 / (0.9 * mus_drape_step_bound(drape[0])));
            for (int moves = 0; moves < 2 && status == MUS_OK; moves++)
                status = mus_drape_step(drape[moves], (int32_t)lround(0.1 / h), h);
            const double *a = mus_drape_positions(drape[0]), *b = mus_drape_positions(drape[1]);
            for (int i = 0; i < 3 * NODES; i++)
                worst = fmax(worst, fabs(b[i] - a[i] - speeds[way][i % 3] * mus_drape_time(drape[0])));
        }
        limb_row(v, status, "V2",
                 way ? "cloth falls on a roller, all at 10 m/s aslant: off after 1 s [m]"
                     : "cloth falls on a roller, all at 10 m/s upwards: off after 1 s [m]",
                 0.0, worst, 1e-9);
        mus_drape_destroy(drape[0]);
        mus_drape_destroy(drape[1]);
        mus_body_destroy(body);
    }
}


/* ---- V3: a body pushed up under a cloth ---- */

/* momentum (3) of the cloth of n x n nodes, less what gravity gave in `seconds` */
static void momentum_of(const mus_drape *drape, int32_t nodes, const double *mass, double seconds, double *out)
{
    const double *w = mus_drape_velocities(drape);
    memset(out, 0, 3 * sizeof *out);
    for (int32_t i = 0; i < nodes; i++)
        for (int d = 0; d < 3; d++) out[d] += mass[i] * (w[3 * i + d] + (d == 1 ? GRAVITY * seconds : 0.0));
}


static void pushed_up(verify *v, double speed)
{
    enum { N = 16, NODES = N * N, STEPS = 400 };
    const double velocity[3] = {0.0, speed, 0.0}, cells[2] = {0.02, 0.02};
    mus_body *body = NULL;
    mus_drape *drape = NULL;
    mus_cloth *cloth = NULL;
    mus_cloth_def def;
    mus_drape_report report;
    double deep = 0.0, off = 0.0, given = 0.0, h = 0.0;
    mus_cloth_def_init(&def, sizeof def);
    mus_drape_report_init(&report, sizeof report);
    mus_status status = mus_cloth_create_grid(v->context, N, N, cells, &def, &cloth);
    if (status == MUS_OK) status = limb_make_sphere(v, 0.15, 32, &body);
    if (status == MUS_OK) status = limb_meet_sheet(v, body, N, 0.02, 0.155, 0.0, &drape);
    if (status == MUS_OK) status = mus_drape_move_body(drape, velocity);
    if (status == MUS_OK) h = 0.05 / STEPS, h = fmin(h, 0.9 * mus_drape_step_bound(drape));
    for (int k = 0; k < STEPS && status == MUS_OK; k++) {
        status = mus_drape_step(drape, 1, h);
        if (status == MUS_OK) status = mus_drape_report_get(drape, &report);
        double momentum[3];
        momentum_of(drape, NODES, mus_cloth_masses(cloth), mus_drape_time(drape), momentum);
        deep = fmax(deep, report.max_penetration);
        for (int d = 0; d < 3; d++) off = fmax(off, fabs(report.contact_impulse[d] - momentum[d]));
        given = fmax(given, fabs(report.contact_impulse[1]));
    }
    char text[80];
    snprintf(text, sizeof text, "sphere pushed up at %g m/s: deepest node [m]", speed);
    limb_row(v, status, "V3", text, 0.0, deep, 1e-9);
    snprintf(text, sizeof text, "sphere pushed up at %g m/s: impulse against momentum and weight", speed);
    limb_row(v, status, "V3", text, 0.0, given > 0.0 ? off / given : 1.0, 1e-10);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
}


int verify_collide(verify *v)
{
    if (verify_wants(v, "V2")) galileo(v);
    if (verify_wants(v, "V3")) pushed_up(v, 1.0), pushed_up(v, 10.0);
    if (verify_wants(v, "C1")) bullets(v);
    if (verify_wants(v, "C3")) spheres(v);
    if (verify_wants(v, "C4")) verify_contours(v);
    if (verify_wants(v, "C5")) out_of_reach(v);
    return EXIT_DONE;
}
