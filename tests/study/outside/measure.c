/*
 * measure.c: see measure.h. A tape is laid in the plane of a contour: round the loop about the middle plane for the
 * torso, with the legs below the waist; round the nearest loop for arms and legs.
 */
#include "measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"

enum { TORSO, ARM = 1, LEG = 3, FOOT = 5 }; /* limbs of a body of a tape; each but the torso has a right one after it */

#define GIRTH 1e-3
#define HEIGHT 2e-3

const outside_row outside_rows[OUTSIDE_ROWS] = {
    {MUS_MEASURE_BUST, 'g', "bust", TORSO, GIRTH, false},
    {MUS_MEASURE_WAIST, 'g', "waist", TORSO, GIRTH, false},
    {MUS_MEASURE_HIP, 'g', "hip", TORSO, GIRTH, false},
    {MUS_MEASURE_UNDERBUST, 'g', "underbust", TORSO, GIRTH, false},
    {MUS_MEASURE_HIGH_BUST, 'g', "high_bust", TORSO, GIRTH, false},
    {MUS_MEASURE_HIGH_HIP, 'g', "high_hip", TORSO, GIRTH, false},
    {MUS_MEASURE_NECK, 'g', "neck", TORSO, GIRTH, false},
    {MUS_MEASURE_HEAD, 'g', "brow", TORSO, GIRTH, false},
    {MUS_MEASURE_UPPER_ARM, 'l', "upper_arm", ARM, GIRTH, false},
    {MUS_MEASURE_WRIST, 'l', "wrist", ARM, GIRTH, false},
    {MUS_MEASURE_HAND, 'l', "hand", ARM, GIRTH, false},
    {MUS_MEASURE_THIGH, 'l', "thigh", LEG, GIRTH, false},
    {MUS_MEASURE_KNEE, 'l', "knee", LEG, GIRTH, false},
    {MUS_MEASURE_CALF, 'l', "calf", LEG, GIRTH, false},
    {MUS_MEASURE_ANKLE, 'l', "ankle", LEG, GIRTH, false},
    {MUS_MEASURE_STATURE, 'h', NULL, TORSO, HEIGHT, false},
    {MUS_MEASURE_INLEG, 'h', NULL, TORSO, HEIGHT, false},
    {MUS_MEASURE_FOOT, 'h', NULL, FOOT, HEIGHT, true},
    {MUS_MEASURE_ACROSS_BACK, 's', "armpit", TORSO, HEIGHT, true},
    {MUS_MEASURE_ACROSS_FRONT, 's', "armpit", TORSO, INFINITY, false},
    {MUS_MEASURE_BUST_SPAN, 's', "bust", TORSO, HEIGHT, true},
    {MUS_MEASURE_CROTCH_LENGTH, 's', "waist", TORSO, INFINITY, false},
    {MUS_MEASURE_SHOULDER, 's', "neck", TORSO, HEIGHT, false},
    {MUS_MEASURE_SHOULDER_SLOPE, 's', "neck", TORSO, INFINITY, false},
};

static const double across[3] = {1.0, 0.0, 0.0}, up[3] = {0.0, 1.0, 0.0}, forward[3] = {0.0, 0.0, 1.0};


/* plane of a named contour through its middle; false: the body does not have it */
static bool contour_plane(const mus_body *body, int32_t limb, const char *name, ruler_plane *out)
{
    double p[12], middle[3], normal[3], a[3], b[3];
    for (int32_t c = 0; c < mus_body_contour_count(body, limb); c++) {
        if (strcmp(mus_body_contour_name(body, limb, c), name) != 0) continue;
        if (mus_body_contour_points(body, limb, c, 4, p) != MUS_OK) return false;
        for (int i = 0; i < 3; i++) {
            middle[i] = 0.25 * (p[i] + p[3 + i] + p[6 + i] + p[9 + i]);
            a[i] = p[6 + i] - p[i], b[i] = p[9 + i] - p[3 + i];
        }
        for (int i = 0; i < 3; i++) normal[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        *out = ruler_plane_at(middle, normal, limb == TORSO ? across : a);
        return true;
    }
    return false;
}


/* the girth of a row; of two limbs the one that is further from what was asked */
static double girth(const ruler_mesh *mesh, const mus_body *body, const outside_row *row)
{
    double worst = NAN;
    for (int32_t side = 0; side < (row->kind == 'l' ? 2 : 1); side++) {
        ruler_plane plane;
        ruler_cut cut;
        if (!contour_plane(body, row->limb + side, row->contour, &plane)) continue;
        if (row->kind == 'g') plane.point[0] = 0.0;
        if (!ruler_cut_at(mesh, &plane, &cut)) return NAN;
        if (row->kind == 'l')
            ruler_take_nearest(&cut);
        else
            ruler_take_trunk(&cut, row->measure == MUS_MEASURE_HIP || row->measure == MUS_MEASURE_HIGH_HIP);
        const double tape = ruler_tape(&cut), asked = mus_body_asked(body, row->measure);
        ruler_cut_free(&cut);
        if (isnan(worst) || fabs(tape - asked) > fabs(worst - asked)) worst = tape;
    }
    return worst;
}


/* the loop of a cut about u = 0 with the most points; -1: there is none */
static int32_t trunk_loop(const ruler_cut *cut)
{
    int32_t best = -1;
    for (int32_t l = 0; l < cut->loops; l++)
        if (cut->of[l].taken && (best < 0 || cut->of[l].points > cut->of[best].points)) best = l;
    return best;
}


/* whether a point is within a loop of a cut other than `torso` */
static bool covered(const ruler_cut *cut, int32_t torso, double u, double v)
{
    bool in = false;
    for (int32_t l = 0; l < cut->loops; l++) in |= l != torso && ruler_within(cut, l, u, v);
    return in;
}


/* append to uv (n x 2) what of the chord from p to q no other loop covers: p, and where the chord enters a loop */
static void put_bare(const ruler_cut *cut, int32_t torso, const double *p, const double *q, double *uv, int32_t *n)
{
    if (covered(cut, torso, p[0], p[1])) return;
    uv[2 * *n] = p[0], uv[2 * *n + 1] = p[1];
    *n += 1;
    if (!covered(cut, torso, q[0], q[1])) return;
    double t = 0.0;
    for (double step = 0.5; step > 1e-4; step *= 0.5)
        if (!covered(cut, torso, p[0] + (t + step) * (q[0] - p[0]), p[1] + (t + step) * (q[1] - p[1]))) t += step;
    uv[2 * *n] = p[0] + t * (q[0] - p[0]), uv[2 * *n + 1] = p[1] + t * (q[1] - p[1]);
    *n += 1;
}


/* across_back (side -1) or across_front (1): half way from the armpit to the shoulder, between the places where the
 * loops of the arms meet that of the torso */
static double across_at(const ruler_mesh *mesh, const mus_body *body, double side)
{
    ruler_plane low, high;
    ruler_cut cut;
    if (!contour_plane(body, TORSO, "high_bust", &low) || !contour_plane(body, TORSO, "shoulder", &high)) return NAN;
    const double point[3] = {0.0, 0.5 * (low.point[1] + high.point[1]), 0.0};
    const ruler_plane plane = ruler_plane_at(point, up, across); /* v is -Z */
    if (!ruler_cut_at(mesh, &plane, &cut)) return NAN;
    ruler_take_trunk(&cut, false);
    const int32_t torso = trunk_loop(&cut);
    double *uv = malloc(sizeof *uv * 8 * ((size_t)cut.chords + 2)), length = NAN;
    int32_t n = 0, kept = 1, first = 0, last = 0;
    for (int32_t k = 0; k < cut.chords && torso >= 0 && uv != NULL; k++) {
        const int32_t *c = cut.chord + 2 * (size_t)k;
        if (cut.loop[c[0]] != torso) continue;
        put_bare(&cut, torso, cut.uv + 2 * (size_t)c[0], cut.uv + 2 * (size_t)c[1], uv, &n);
        put_bare(&cut, torso, cut.uv + 2 * (size_t)c[1], cut.uv + 2 * (size_t)c[0], uv, &n);
    }

    /* the points on the side asked for; the tape from the one furthest to the right to the one furthest to the left */
    const double middle = torso >= 0 ? 0.5 * (cut.of[torso].low[1] + cut.of[torso].high[1]) : 0.0;
    for (int32_t i = 0; i < n; i++) {
        if (side * (uv[2 * i + 1] - middle) > 0.0) continue;
        if (first == 0 || uv[2 * i] < uv[2 * first]) first = i;
        if (last == 0 || uv[2 * i] > uv[2 * last]) last = i;
    }
    double *way = malloc(sizeof *way * 2 * ((size_t)n + 2));
    if (way != NULL && first != last) {
        way[0] = uv[2 * first], way[1] = uv[2 * first + 1];
        for (int32_t i = 0; i < n; i++) {
            if (i == first || i == last || side * (uv[2 * i + 1] - middle) > 0.0) continue;
            way[2 * kept] = uv[2 * i], way[2 * kept + 1] = uv[2 * i + 1], kept++;
        }
        way[2 * kept] = uv[2 * last], way[2 * kept + 1] = uv[2 * last + 1];
        length = ruler_string(kept + 1, way, side);
    }
    free(way);
    free(uv);
    ruler_cut_free(&cut);
    return length;
}


/* twice the distance of the foremost point of the left breast from the middle plane */
static double span(const ruler_mesh *mesh, const mus_body *body)
{
    ruler_plane plane;
    ruler_cut cut;
    if (isnan(mus_body_made(body, MUS_MEASURE_BUST_SPAN)) || !contour_plane(body, TORSO, "bust", &plane)) return NAN;
    plane = ruler_plane_at((double[3]){0.0, plane.point[1], 0.0}, up, across);
    if (!ruler_cut_at(mesh, &plane, &cut)) return NAN;
    ruler_take_trunk(&cut, false);
    double best = 1e30, at = NAN;
    for (int32_t i = 0; i < cut.points; i++) {
        const double *p = cut.uv + 2 * (size_t)i;
        if (cut.of[cut.loop[i]].taken && p[0] >= 0.0 && p[1] < best) best = p[1], at = p[0];
    }
    ruler_cut_free(&cut);
    return 2.0 * at;
}


/* inleg, or with `length` the tape in the middle plane from the waist in front under the crotch to the waist behind */
static double crotch(const ruler_mesh *mesh, const mus_body *body, bool length)
{
    ruler_plane waist;
    ruler_cut cut;
    if (!contour_plane(body, TORSO, "waist", &waist)) return NAN;
    const ruler_plane plane = ruler_plane_at((double[3]){0.0, 0.0, 0.0}, across, forward); /* u Z, v up or down */
    const double sense = plane.v[1];
    if (!ruler_cut_at(mesh, &plane, &cut)) return NAN;
    double lowest = 1e30, *uv = malloc(sizeof *uv * 2 * ((size_t)cut.points + 2)), front = -1e30, back = 1e30;
    int32_t n = 1;
    for (int32_t i = 0; i < cut.points && uv != NULL; i++) {
        const double z = cut.uv[2 * (size_t)i], y = sense * cut.uv[2 * (size_t)i + 1];
        lowest = fmin(lowest, y);
        if (y < waist.point[1]) uv[2 * n] = z, uv[2 * n + 1] = y, n++;
        if (fabs(y - waist.point[1]) < 0.01) front = fmax(front, z), back = fmin(back, z);
    }
    double tape = NAN;
    if (uv != NULL && n > 3) {
        uv[0] = front, uv[1] = waist.point[1];
        uv[2 * n] = back, uv[2 * n + 1] = waist.point[1];
        tape = ruler_string(n + 1, uv, -1.0);
    }
    free(uv);
    ruler_cut_free(&cut);
    return length ? tape : lowest;
}


/* the shoulder's ridge over x [m]: (y, z) of the highest point of the cut below `most`; false: none */
static bool ridge(const ruler_mesh *mesh, double x, double most, double *out)
{
    ruler_cut cut;
    const ruler_plane plane = ruler_plane_at((double[3]){x, 0.0, 0.0}, across, forward);
    if (!ruler_cut_at(mesh, &plane, &cut)) return false;
    out[0] = -1e30;
    for (int32_t i = 0; i < cut.points; i++) {
        const double y = plane.v[1] * cut.uv[2 * (size_t)i + 1];
        if (y > out[0] && y <= most) out[0] = y, out[1] = cut.uv[2 * (size_t)i];
    }
    ruler_cut_free(&cut);
    return out[0] > -1e29;
}


/* shoulder_slope: from the side of the neck to the point of the ridge that a tape of the asked shoulder reaches */
static double slope(const ruler_mesh *mesh, const mus_body *body)
{
    ruler_plane plane;
    ruler_cut cut;
    if (!contour_plane(body, TORSO, "neck", &plane)) return NAN;
    plane = ruler_plane_at((double[3]){0.0, plane.point[1], 0.0}, up, across);
    if (!ruler_cut_at(mesh, &plane, &cut)) return NAN;
    ruler_take_trunk(&cut, false);
    const int32_t loop = trunk_loop(&cut);
    const double side = loop >= 0 ? cut.of[loop].high[0] : NAN;
    ruler_cut_free(&cut);
    const double shoulder = mus_body_asked(body, MUS_MEASURE_SHOULDER);
    double gone = 0.0, last[3] = {side, plane.point[1], 0.0}, at[2];
    const int32_t steps = 60;
    const double high = plane.point[1] + 1e-6;
    if (!ridge(mesh, side + 1e-6, high, at)) return NAN;
    last[2] = at[1];
    for (int32_t k = 1; k <= 2 * steps; k++) {
        const double x = side + shoulder * k / steps;
        if (!ridge(mesh, x, high, at)) return NAN;
        const double way = sqrt(pow(x - last[0], 2) + pow(at[0] - last[1], 2) + pow(at[1] - last[2], 2));
        const double t = (shoulder - gone) / way;
        const double down = plane.point[1] - last[1] - t * (at[0] - last[1]), out = last[0] + t * (x - last[0]) - side;
        if (t <= 1.0) return atan2(down, out);
        gone += way;
        last[0] = x, last[1] = at[0], last[2] = at[1];
    }
    return NAN;
}


/* stature and the length of the feet */
static double extent(const ruler_mesh *mesh, int32_t measure, double stature)
{
    double low = 1e30, high = -1e30, top = -1e30;
    for (int32_t i = 0; i < mesh->vertices; i++) {
        const double *x = mesh->x + 3 * (size_t)i;
        top = fmax(top, x[1]);
        if (x[1] < 0.03 * stature) low = fmin(low, x[2]), high = fmax(high, x[2]);
    }
    return measure == MUS_MEASURE_STATURE ? top : high - low;
}


static double measured(const ruler_mesh *mesh, const mus_body *body, const outside_row *row)
{
    switch (row->measure) {
    case MUS_MEASURE_STATURE:
    case MUS_MEASURE_FOOT: return extent(mesh, row->measure, mus_body_asked(body, MUS_MEASURE_STATURE));
    case MUS_MEASURE_INLEG: return crotch(mesh, body, false);
    case MUS_MEASURE_CROTCH_LENGTH: return crotch(mesh, body, true);
    case MUS_MEASURE_ACROSS_BACK: return across_at(mesh, body, -1.0);
    case MUS_MEASURE_ACROSS_FRONT: return across_at(mesh, body, 1.0);
    case MUS_MEASURE_BUST_SPAN: return span(mesh, body);
    case MUS_MEASURE_SHOULDER_SLOPE: return slope(mesh, body);
    default: return row->kind == 'g' || row->kind == 'l' ? girth(mesh, body, row) : NAN;
    }
}


bool outside_measure(const mus_body *body, const char *path, double *made)
{
    ruler_mesh mesh;
    if (!ruler_read(path, &mesh)) return false;
    for (int i = 0; i < OUTSIDE_ROWS; i++) made[i] = measured(&mesh, body, &outside_rows[i]);
    ruler_free(&mesh);
    return true;
}
