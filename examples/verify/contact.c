/*
 * contact.c: friction and impulses on limbs: capstans, a point that slides off, one collision (cases F3,
 * F4, F7, F8).
 *
 * Clearance is 0: nodes lie on the skin itself. A capstan is a chain of nodes without weight round half of a convex
 * limb, kept tight by soft springs; tensions grow alike at every turn, and the ratio of the two is halved in until the
 * chain slips.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command/args.h"
#include "limbs.h"


/* ---- F8: impulses ---- */

static void impulses(verify *v)
{
    const double place[3] = {0.1, 0.0, 0.0}, velocity[3] = {-2.0, 0.0, 5.0};
    mus_body *body = NULL;
    mus_drape *drape = NULL;
    double got[3] = {0};
    mus_status status = limb_make_roller(v, 0.1, 0.1, 2.0, &body);
    if (status == MUS_OK) status = limb_meet_point(v, body, MU, 0.0, place, velocity, &drape);
    if (status == MUS_OK) status = mus_drape_step(drape, 1, 1e-9);
    if (status == MUS_OK) memcpy(got, mus_drape_velocities(drape), sizeof got);
    limb_row(v, status, "F8", "normal velocity after -2 m/s, 0.3 of friction [m/s]", 0.0, got[0], 1e-14);
    limb_row(v, status, "F8", "sliding velocity after 5 m/s [m/s]", 4.4, got[2], 1e-14);
    mus_drape_destroy(drape);
    mus_body_destroy(body);
}


/* ---- F7: a point slides off a smooth roller and off a smooth sphere ---- */

/* angle off the top at which a node at (x, y) last moved along the skin of 0.2 m about the origin, before it was a
 * millimetre off it */
static mus_status leaves_at(mus_drape *drape, double h, double *out)
{
    const double *x = mus_drape_positions(drape), *w = mus_drape_velocities(drape);
    *out = 0.0;
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < 100000 && status == MUS_OK; k++) {
        status = mus_drape_step(drape, 1, h);
        const double r = sqrt(x[0] * x[0] + x[1] * x[1]), up = (x[0] * w[0] + x[1] * w[1]) / r;
        if (r > 0.201) break;
        if (up <= 1e-7) *out = atan2(fabs(x[0]), x[1]);
    }
    return status;
}


static void slides_off(verify *v)
{
    const double start = 0.1 * PI / 180.0, place[3] = {0.2 * sin(start), 0.2 * cos(start), 0.0};
    for (int sphere = 0; sphere < 2; sphere++) {
        mus_body *body = NULL;
        mus_drape *drape = NULL;
        double angle = 0.0;
        mus_status status =
            sphere ? limb_make_sphere(v, 0.2, MOST_CONTOURS, &body) : limb_make_roller(v, 0.2, 0.2, 2.0, &body);
        if (status == MUS_OK) status = limb_meet_point(v, body, 0.0, GRAVITY, place, NULL, &drape);
        if (status == MUS_OK) status = leaves_at(drape, 5e-5, &angle);
        limb_row(v, status, "F7",
                 sphere ? "smooth sphere left, degrees off its pole" : "smooth roller left, degrees off the top",
                 acos(2.0 / 3.0) * 180.0 / PI, angle * 180.0 / PI, 0.2 / 48.19);
        mus_drape_destroy(drape);
        mus_body_destroy(body);
    }
}


/* ---- F3, F4: a chain round a convex limb on the verge of slipping ---- */

#define CAPSTAN_MOST 64
#define CAPSTAN_PULL 10.0 /* the lesser tension [N] */
#define CAPSTAN_SOFT 10.0 /* of the springs that keep both tensions [N/m] */
#define CAPSTAN_HARD 2e5  /* of the chain */
#define CAPSTAN_MASS 0.01 /* of a node [kg] */

typedef struct capstan {
    int32_t n;
    double point[3 * CAPSTAN_MOST]; /* where the chain lies */
    double way[2][3];               /* unit: to where its first and its last node are pulled */
    const mus_body *body;
} capstan;


/* turn of the chain at point i */
static double turn_at(const capstan *c, int32_t i)
{
    double a[3], b[3], na = 0.0, nb = 0.0, dot = 0.0;
    for (int d = 0; d < 3; d++) {
        a[d] = i > 0 ? c->point[3 * i + d] - c->point[3 * i - 3 + d] : -c->way[0][d];
        b[d] = i + 1 < c->n ? c->point[3 * i + 3 + d] - c->point[3 * i + d] : c->way[1][d];
        na += a[d] * a[d], nb += b[d] * b[d], dot += a[d] * b[d];
    }
    return acos(fmin(dot / sqrt(na * nb), 1.0));
}


/* the verge as Coulomb has it: each node lets T grow by (1 + mu tan(turn/2)) / (1 - mu tan(turn/2)) */
static double capstan_exact(const capstan *c)
{
    double ratio = 1.0;
    for (int32_t i = 0; i < c->n; i++) {
        const double t = MU * tan(0.5 * turn_at(c, i));
        ratio *= (1.0 + t) / (1.0 - t);
    }
    return ratio;
}


/* the chain in balance with tensions that grow alike at every turn from CAPSTAN_PULL to `ratio` times that */
static mus_status capstan_chain(verify *v, const capstan *c, double ratio, mus_drape **out)
{
    double place[3 * (CAPSTAN_MOST + 2)], mass[CAPSTAN_MOST + 2], length[CAPSTAN_MOST + 1], k[CAPSTAN_MOST + 1];
    double dashpot[CAPSTAN_MOST + 1], all = 0.0, turned = 0.0;
    int32_t spring[2 * (CAPSTAN_MOST + 1)];
    const int32_t n = c->n, pin[2] = {0, n + 1};
    for (int32_t i = 0; i < n; i++) all += turn_at(c, i);
    for (int32_t i = 0; i < n + 2; i++) {
        mass[i] = CAPSTAN_MASS;
        const double far = i == 0 ? 1.0 + CAPSTAN_PULL / CAPSTAN_SOFT : 1.0 + ratio * CAPSTAN_PULL / CAPSTAN_SOFT;
        for (int d = 0; d < 3; d++)
            place[3 * i + d] = i == 0       ? c->point[d] + far * c->way[0][d]
                               : i == n + 1 ? c->point[3 * (n - 1) + d] + far * c->way[1][d]
                                            : c->point[3 * (i - 1) + d];
    }
    for (int32_t s = 0; s <= n; s++) {
        const bool soft = s == 0 || s == n;
        double l2 = 0.0;
        for (int d = 0; d < 3; d++) l2 += pow(place[3 * s + 3 + d] - place[3 * s + d], 2.0);
        if (s > 0) turned += turn_at(c, s - 1);
        k[s] = soft ? CAPSTAN_SOFT : CAPSTAN_HARD;
        length[s] = sqrt(l2) - CAPSTAN_PULL * pow(ratio, turned / all) / k[s];
        dashpot[s] = soft ? 0.0 : 0.5 * sqrt(CAPSTAN_HARD * CAPSTAN_MASS);
        spring[2 * s] = s, spring[2 * s + 1] = s + 1;
    }

    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = n + 2, bare.place = place, bare.mass = mass;
    bare.springs = n + 1, bare.spring = spring, bare.length = length, bare.stiffness = k, bare.dashpot = dashpot;
    bare.pins = 2, bare.pin = pin;
    const mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    return status == MUS_OK ? limb_meet(v, cloth, c->body, MU, 0.0, 0.0, out) : status;
}


/* how far the middle of the chain moves in 0.4 s [m] */
static mus_status capstan_slip(verify *v, const capstan *c, double ratio, double *out)
{
    mus_drape *drape = NULL;
    mus_status status = capstan_chain(v, c, ratio, &drape);
    if (status == MUS_OK) {
        const double h = 0.3 * mus_drape_step_bound(drape);
        status = mus_drape_step(drape, (int32_t)ceil(0.4 / h), h);
    }
    double move2 = 0.0;
    for (int d = 0; d < 3 && status == MUS_OK; d++)
        move2 += pow(mus_drape_positions(drape)[3 * (c->n / 2 + 1) + d] - c->point[3 * (c->n / 2) + d], 2.0);
    *out = sqrt(move2);
    mus_drape_destroy(drape);
    return status;
}


/* the ratio of tensions at which the chain begins to slip by a millimetre */
static void capstan_row(verify *v, const char *id, const char *text, const capstan *c, double exact, double tolerance)
{
    const double guess = capstan_exact(c);
    double low = 0.9 * guess, high = 1.1 * guess, slip;
    mus_status status = MUS_OK;
    for (int k = 0; k < 8 && status == MUS_OK; k++) {
        const double middle = 0.5 * (low + high);
        status = capstan_slip(v, c, middle, &slip);
        if (slip > 1e-3)
            high = middle;
        else
            low = middle;
    }
    limb_row(v, status, id, text, exact, 0.5 * (low + high), tolerance);
}


/* n points of a round roller that turn the chain by half a circle, the ends pulled straight down */
static void capstan_round(capstan *c, int32_t n, double r, double apart)
{
    c->n = n;
    for (int32_t i = 0; i < n; i++) {
        const double angle = PI * (i + 0.5) / n;
        c->point[3 * i] = (2 * i < n ? apart : -apart) + r * cos(angle);
        c->point[3 * i + 1] = r * sin(angle);
        c->point[3 * i + 2] = 0.0;
    }
    memset(c->way, 0, sizeof c->way);
    c->way[0][1] = c->way[1][1] = -1.0;
}


/* where the ray from `centre` in the direction (cos, sin) of the plane of u and w leaves the body */
static mus_status leave_body(const mus_body *body, const double *centre, const double *u, const double *w, double turn,
                             double *out)
{
    double low = 0.0, high = 1.0, depth;
    mus_status status = MUS_OK;
    for (int k = 0; k < 44 && status == MUS_OK; k++) {
        const double r = 0.5 * (low + high);
        for (int d = 0; d < 3; d++) out[d] = centre[d] + r * (cos(turn) * u[d] + sin(turn) * w[d]);
        status = mus_body_depth(body, 1, out, &depth, NULL);
        if (depth > 0.0)
            low = r;
        else
            high = r;
    }
    return status;
}


/* n points of the section of a body by the plane of u and w, whose outward sides turn evenly by half a circle from u
 * over w to -u; the ends are pulled along -w */
static mus_status capstan_section(const mus_body *body, const double *centre, const double *u, const double *w,
                                  int32_t n, capstan *c)
{
    enum { RAYS = 2880 };
    mus_status status = MUS_OK;
    double farthest[CAPSTAN_MOST];
    c->n = n;
    c->body = body;
    for (int32_t i = 0; i < n; i++) farthest[i] = -1e9;
    for (int d = 0; d < 3; d++) c->way[0][d] = c->way[1][d] = -w[d];
    for (int32_t k = 0; k < RAYS && status == MUS_OK; k++) {
        double p[3], along = 0.0, across = 0.0;
        status = leave_body(body, centre, u, w, 2.0 * PI * k / RAYS, p);
        for (int d = 0; d < 3; d++) along += (p[d] - centre[d]) * u[d], across += (p[d] - centre[d]) * w[d];
        for (int32_t i = 0; i < n; i++) {
            const double side = PI * (i + 0.5) / n, out = along * cos(side) + across * sin(side);
            if (out <= farthest[i]) continue;
            farthest[i] = out;
            memcpy(c->point + 3 * i, p, sizeof p);
        }
    }
    return status;
}


static void capstans_round(verify *v)
{
    static const int32_t counts[] = {8, 16, 32, 64};
    capstan c = {0};
    mus_body *body = NULL;
    mus_status status = limb_make_roller(v, 0.1, 0.1, 2.0, &body);
    if (status != MUS_OK) verify_broken(v, "F3", "capstan", status);
    for (int i = 0; i < 4 && status == MUS_OK; i++) {
        char text[64];
        const int32_t n = counts[i];
        const double t = MU * tan(0.5 * PI / n);
        capstan_round(&c, n, 0.1, 0.0);
        c.body = body;
        snprintf(text, sizeof text, "half round a cylinder, %d nodes: T2/T1 when it slips", (int)n);
        capstan_row(v, "F3", text, &c, pow((1.0 + t) / (1.0 - t), n), 0.01);
    }
    mus_body_destroy(body);
}


static mus_status capstan_waist(verify *v, capstan *c, mus_body **body)
{
    static const double u[3] = {1.0, 0.0, 0.0}, w[3] = {0.0, 0.0, 1.0};
    double waist[3];
    mus_tape *tape = NULL;
    mus_status status = mus_tape_create(v->context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(v->context, tape, NULL, body);
    if (status == MUS_OK) status = mus_body_landmark(*body, MUS_LANDMARK_WAIST, waist);
    if (status == MUS_OK) status = capstan_section(*body, waist, u, w, 32, c);
    mus_tape_destroy(tape);
    return status;
}


static void capstans_convex(verify *v)
{
    static const double zero[3] = {0}, u[3] = {1.0, 0.0, 0.0}, w[3] = {0.0, 1.0, 0.0};
    static const char *const names[4] = {"half round an ellipse 15 x 8 cm", "half round a superellipse of exponent 3",
                                         "half round a stadium of two cylinders", "half round the waist of a body W40"};
    for (int i = 0; i < 4; i++) {
        char text[80];
        double rows[2][12];
        capstan c = {0};
        mus_body *body = NULL;
        const mus_limb pair[2] = {limb_roller(0.1, 0.0, 0.08, 0.08, 2.0, rows[0]),
                                  limb_roller(-0.1, 0.0, 0.08, 0.08, 2.0, rows[1])};
        mus_status status = i == 0   ? limb_make_roller(v, 0.15, 0.08, 2.0, &body)
                            : i == 1 ? limb_make_roller(v, 0.12, 0.09, 3.0, &body)
                            : i == 2 ? mus_body_create_limbs(v->context, 2, pair, NULL, &body)
                                     : capstan_waist(v, &c, &body);
        if (status == MUS_OK && i < 2) status = capstan_section(body, zero, u, w, 32, &c);
        if (i == 2) capstan_round(&c, 64, 0.08, 0.1);
        c.body = body;
        snprintf(text, sizeof text, "%s: T2/T1 when it slips", names[i]);
        if (status == MUS_OK)
            capstan_row(v, "F4", text, &c, exp(MU * PI), 0.02);
        else
            verify_broken(v, "F4", text, status);
        mus_body_destroy(body);
    }
}


int verify_contact(verify *v)
{
    if (verify_wants(v, "F3")) capstans_round(v);
    if (verify_wants(v, "F4")) capstans_convex(v);
    if (verify_wants(v, "F7")) slides_off(v);
    if (verify_wants(v, "F8")) impulses(v);
    return EXIT_DONE;
}
