/*
 * plane.c: cloth and points on planes: incline, stop, belt, shaken table, turntable, weight (cases F1, F2,
 * F5, F6, V1, C2).
 *
 * All in double without drag; clearance 0 but for cloths. Thresholds of sticking are halved in from 10 % below to 10 %
 * above until what slips and what does not lie together.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "command/args.h"
#include "limbs.h"

#define DEGREE (PI / 180.0)
#define HALVINGS 12


/* a point of mass 1 at `place`, moving, over one plane; no body */
static mus_status plane_point(verify *v, const mus_plane *plane, double gravity, const double *place,
                              const double *velocity, mus_drape **out)
{
    mus_status status = limb_meet_point(v, NULL, MU, gravity, place, velocity, out);
    return status == MUS_OK ? mus_drape_add_plane(*out, plane, NULL) : status;
}


/* ---- F1: a block of cloth on an incline ---- */

/* how far the block has slid in `seconds` */
static mus_status incline(verify *v, double angle, double seconds, double *out)
{
    enum { SIDE = 8 };
    const double up[2] = {sin(angle), cos(angle)}, cell = 0.04, off = 0.002;
    double state[3 * SIDE * SIDE];
    mus_drape *drape = NULL;
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    plane.normal[0] = up[0], plane.normal[1] = up[1];
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        const double along = cell * (i % SIDE);
        state[3 * i] = off * up[0] + along * up[1];
        state[3 * i + 1] = off * up[1] - along * up[0];
        state[3 * i + 2] = cell * (i / SIDE);
    }
    mus_status status = limb_meet_sheet(v, NULL, SIDE, cell, 0.0, 0.0, &drape);
    if (status == MUS_OK) status = mus_drape_add_plane(drape, &plane, NULL);
    if (status == MUS_OK) status = mus_drape_set_state(drape, state, NULL);
    *out = 0.0;
    if (status == MUS_OK) {
        const double steps = ceil(seconds / fmin(1e-3, 0.9 * mus_drape_step_bound(drape)));
        status = mus_drape_step(drape, (int32_t)steps, seconds / steps);
    }
    for (int32_t i = 0; i < SIDE * SIDE && status == MUS_OK; i++) {
        double move2 = 0.0;
        for (int d = 0; d < 3; d++) move2 += pow(mus_drape_positions(drape)[3 * i + d] - state[3 * i + d], 2.0);
        *out = fmax(*out, sqrt(move2));
    }
    mus_drape_destroy(drape);
    return status;
}


static void inclines(verify *v)
{
    static const double slides[] = {16.8, 30.0};
    double way = 0.0;
    char text[80];
    mus_status status = incline(v, 16.6 * DEGREE, 10.0, &way);
    limb_row(v, status, "F1", "cloth on an incline of 16.6 degrees: slid in 10 s [m]", 0.0, way, 1e-6);
    for (int i = 0; i < 2; i++) {
        const double angle = slides[i] * DEGREE, exact = GRAVITY * (sin(angle) - MU * cos(angle));
        status = incline(v, angle, 1.0, &way);
        snprintf(text, sizeof text, "cloth on an incline of %g degrees: acceleration [m/s2]", slides[i]);
        limb_row(v, status, "F1", text, exact, 2.0 * way, 1e-3);
    }
}


/* ---- F2: a point stops ---- */

static void stops(verify *v)
{
    static const double start[3] = {0.0, 0.0, 0.0}, speed[3] = {5.0, 0.0, 0.0};
    const double far = 25.0 / (2.0 * MU * GRAVITY), late = 5.0 / (MU * GRAVITY);
    for (double h = 1e-2; h > 5e-5; h *= 0.1) {
        mus_drape *drape = NULL;
        double stopped = 0.0, way = 0.0;
        char text[80];
        mus_status status = plane_point(v, NULL, GRAVITY, start, speed, &drape);
        while (status == MUS_OK && mus_drape_velocities(drape)[0] > 0.0 && stopped < 3.0) {
            status = mus_drape_step(drape, 1, h);
            stopped = mus_drape_time(drape);
        }
        if (status == MUS_OK) way = mus_drape_positions(drape)[0];
        snprintf(text, sizeof text, "5 m/s on the ground, steps of %g s: stops after [m]", h);
        limb_row(v, status, "F2", text, far, way, h / late);
        snprintf(text, sizeof text, "5 m/s on the ground, steps of %g s: stops at [s]", h);
        limb_row(v, status, "F2", text, late, stopped, 1.01 * h / late);
        mus_drape_destroy(drape);
    }
}


/* ---- F5, F6: a shaken table, a turntable ---- */

/* largest distance between a point and where a table that goes A sin(turn t) has carried it */
static mus_status shake_table(verify *v, double amplitude, double *out)
{
    const double turn = 10.0, h = 5e-5, start[3] = {0.0}, speed[3] = {amplitude * turn, 0.0, 0.0};
    mus_drape *drape = NULL;
    mus_status status = plane_point(v, NULL, GRAVITY, start, speed, &drape);
    *out = 0.0;
    for (int k = 0; k < 16000 && status == MUS_OK; k++) {
        const double at[2] = {amplitude * sin(turn * h * k), amplitude * sin(turn * h * (k + 1))};
        const double velocity[3] = {(at[1] - at[0]) / h, 0.0, 0.0};
        status = mus_drape_move_plane(drape, 0, velocity, 0.0);
        if (status == MUS_OK) status = mus_drape_step(drape, 1, h);
        if (status == MUS_OK) *out = fmax(*out, fabs(mus_drape_positions(drape)[0] - at[1]));
    }
    mus_drape_destroy(drape);
    return status;
}


/* how far a point at radius r of a turntable has gone from its axis in 1 s */
static mus_status turn_table(verify *v, double r, double *out)
{
    const double turn = 5.0, h = 2e-4, start[3] = {r, 0.0, 0.0}, speed[3] = {0.0, 0.0, -r * turn};
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    plane.spin = turn;
    mus_drape *drape = NULL;
    mus_status status = plane_point(v, &plane, GRAVITY, start, speed, &drape);
    if (status == MUS_OK) status = mus_drape_step(drape, (int32_t)lround(1.0 / h), h);
    *out = 0.0;
    if (status == MUS_OK) *out = hypot(mus_drape_positions(drape)[0], mus_drape_positions(drape)[2]) - r;
    mus_drape_destroy(drape);
    return status;
}


/* where a table begins to let a point slip by more than `still` */
static void verge(verify *v, const char *id, const char *text, mus_status (*slip)(verify *, double, double *),
                  double exact, double still)
{
    double low = 0.9 * exact, high = 1.1 * exact, way;
    mus_status status = MUS_OK;
    for (int k = 0; k < HALVINGS && status == MUS_OK; k++) {
        const double middle = 0.5 * (low + high);
        status = slip(v, middle, &way);
        if (way > still)
            high = middle;
        else
            low = middle;
    }
    limb_row(v, status, id, text, exact, 0.5 * (low + high), 0.02);
}


static void turned_round(verify *v)
{
    const double r = 0.1, h = 1e-3;
    double way = 0.0;
    mus_status status = turn_table(v, r, &way);
    limb_row(v, status, "F6", "what sticks 100 mm from the axis of a turntable is off in 1 s by [m]", 0.0, way, 1e-9);
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    plane.spin = 5.0;
    plane.friction = INFINITY;
    mus_drape *drape = NULL;
    const double start[3] = {r, 0.0, 0.0};
    if (status == MUS_OK) status = plane_point(v, &plane, GRAVITY, start, NULL, &drape);
    if (status == MUS_OK) status = mus_drape_step(drape, 1000, h);
    double off = 0.0;
    if (status == MUS_OK)
        off = hypot(mus_drape_positions(drape)[0] - r * cos(5.0), mus_drape_positions(drape)[2] + r * sin(5.0));
    limb_row(v, status, "F6", "all friction: carried round by 5 rad, off by [m]", 0.0, off, 1e-9);
    mus_drape_destroy(drape);
}


/* ---- V1: cloth dropped on a belt ---- */

static void belt(verify *v)
{
    enum { SIDE = 8 };
    const double speed = 1.0, h = 2e-4, late = speed / (MU * GRAVITY), far = 0.5 * speed * late;
    double reached = 0.0, behind = 0.0;
    mus_drape *drape = NULL;
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    plane.velocity[0] = speed;
    mus_status status = limb_meet_sheet(v, NULL, SIDE, 0.04, 0.002, 0.0, &drape);
    if (status == MUS_OK) status = mus_drape_add_plane(drape, &plane, NULL);
    const double from = status == MUS_OK ? mus_drape_positions(drape)[0] : 0.0;
    for (int k = 0; k < 2500 && status == MUS_OK; k++) {
        status = mus_drape_step(drape, 1, h);
        if (reached == 0.0 && mus_drape_velocities(drape)[0] >= speed * (1.0 - 1e-9)) reached = mus_drape_time(drape);
    }
    if (status == MUS_OK) behind = speed * mus_drape_time(drape) - (mus_drape_positions(drape)[0] - from);
    limb_row(v, status, "V1", "cloth dropped on a belt of 1 m/s: reaches its speed after [s]", late, reached, h / late);
    limb_row(v, status, "V1", "cloth dropped on a belt of 1 m/s: slipped [m]", far, behind, h / late);
    mus_drape_destroy(drape);
}


/* ---- C2: what cloth at rest weighs ---- */

static mus_status weigh(verify *v, const mus_body *body, double height, double calm, double *out)
{
    enum { SIDE = 21 };
    const double cell = 0.025, cells[2] = {cell, cell};
    mus_drape_def def;
    mus_cloth_def cut;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_drape_report before, after;
    double *state = calloc(3 * SIDE * SIDE, sizeof *state);
    if (state == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        state[3 * i] = cell * (i % SIDE - 0.5 * (SIDE - 1));
        state[3 * i + 1] = height;
        state[3 * i + 2] = cell * (i / SIDE - 0.5 * (SIDE - 1));
    }
    mus_drape_report_init(&before, sizeof before);
    mus_drape_report_init(&after, sizeof after);
    mus_drape_def_init(&def, sizeof def);
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    fabric.weight = 0.15;
    fabric.damping = 0.1;
    def.precision = 64;
    def.drag = 0.0;
    def.settle_residual = 1e-4;
    mus_status status = mus_cloth_create_grid(v->context, SIDE, SIDE, cells, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(v->context, cloth, body, &def, &drape);
    if (status == MUS_OK && body == NULL) status = mus_drape_add_plane(drape, NULL, NULL);
    if (status == MUS_OK) status = mus_drape_set_state(drape, state, NULL);

    /* let it come to rest, then take what carries it for half a second */
    if (status == MUS_OK) status = mus_drape_settle(drape, NULL, NULL);
    const double h = status == MUS_OK ? 0.7 * mus_drape_step_bound(drape) : 0.0;
    if (status == MUS_OK) status = mus_drape_step(drape, (int32_t)ceil(calm / h), h);
    if (status == MUS_OK) status = mus_drape_report_get(drape, &before);
    const double since = mus_drape_time(drape);
    if (status == MUS_OK) status = mus_drape_step(drape, (int32_t)ceil(0.5 / h), h);
    if (status == MUS_OK) status = mus_drape_report_get(drape, &after);
    if (status == MUS_OK)
        *out = (after.contact_impulse[1] - before.contact_impulse[1]) / (mus_drape_time(drape) - since) /
               (GRAVITY * mus_cloth_mass(cloth));
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    free(state);
    return status;
}


static void weights(verify *v)
{
    double got = 0.0;
    mus_body *body = NULL;
    mus_status status = weigh(v, NULL, 0.002, 0.1, &got);
    limb_row(v, status, "C2", "cloth at rest on a plane: what it is carried by over its weight", 1.0, got, 1e-6);
    status = limb_make_sphere(v, 0.15, 48, &body);
    if (status == MUS_OK) status = weigh(v, body, 0.1525, 8.0, &got);
    limb_row(v, status, "C2", "cloth at rest on a sphere: what it is carried by over its weight", 1.0, got, 1e-6);
    mus_body_destroy(body);
}


int verify_plane(verify *v)
{
    if (verify_wants(v, "F1")) inclines(v);
    if (verify_wants(v, "F2")) stops(v);
    if (verify_wants(v, "F5"))
        verge(v, "F5", "amplitude from which a table shaken at 10 rad/s lets go [m]", shake_table, MU * GRAVITY / 100.0,
              2e-5);
    if (verify_wants(v, "F6")) {
        verge(v, "F6", "radius from which a turntable of 5 rad/s lets go [m]", turn_table, MU * GRAVITY / 25.0, 1e-3);
        turned_round(v);
    }
    if (verify_wants(v, "V1")) belt(v);
    if (verify_wants(v, "C2")) weights(v);
    return EXIT_DONE;
}
