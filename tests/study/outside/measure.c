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
#define CREASE 0.009 /* [parts of the stature] nearer to each other two skins may carry a fillet */

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
    {MUS_MEASURE_FOOT, 'h', NULL, FOOT, HEIGHT, false},
    {MUS_MEASURE_ACROSS_BACK, 's', "armpit", TORSO, HEIGHT, true},
    {MUS_MEASURE_ACROSS_FRONT, 's', "armpit", TORSO, INFINITY, false},
    {MUS_MEASURE_BUST_SPAN, 's', "bust", TORSO, HEIGHT, false},
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


/* how deep (u, v) lies within a loop of a cut [m]; negative outside */
static double depth_in(const ruler_cut *cut, int32_t loop, const double *p)
{
    const double off = ruler_off(cut, loop, p[0], p[1]);
    return ruler_within(cut, loop, p[0], p[1]) ? off : -off;
}


/* the loop on a side (1, -1) that begins nearest to the middle plane: the arm of that side; -1: none */
static int32_t arm_loop(const ruler_cut *cut, int32_t torso, double to)
{
    int32_t best = -1;
    for (int32_t l = 0; l < cut->loops; l++) {
        if (l == torso || cut->of[l].points < 3 || cut->of[l].middle[0] * to <= 0.0) continue;
        if (best < 0 || cut->of[l].points > cut->of[best].points) best = l;
    }
    return best;
}


/* the cubic through four places (x, y), at x = at */
static double cubic(const double *x, const double *y, double at)
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        double term = y[i];
        for (int j = 0; j < 4; j++)
            if (j != i) term *= (at - x[j]) / (x[i] - x[j]);
        sum += term;
    }
    return sum;
}


/* a curve by its distance from a middle: places (angle, distance), two before and two behind what a fillet covers */
typedef struct bare {
    double middle[2], angle[4], far[4];
} bare;


/* angle of (u, v) about a middle, from the way (0, -side) on, turning towards u * to > 0 */
static double angle_about(const double *middle, double side, double to, const double *p)
{
    return atan2(to * (p[0] - middle[0]), -side * (p[1] - middle[1]));
}


/* the places of a loop on both sides of where it goes into another loop: of its points that lie `near` [m] or further
 * off the other's, the two last ones outside and the two first ones within, by angle from `from` on. false: it does not
 * go in */
static bool bare_of(const ruler_cut *cut, int32_t loop, int32_t other, double near, double side, double to, double from,
                    bare *out)
{
    double last = -1e30;
    int32_t found = 0;
    while (found < 4) {
        double next = 1e30, place[2] = {0.0, 0.0};
        for (int32_t i = 0; i < cut->points; i++) { /* the next point by angle */
            const double *p = cut->uv + 2 * (size_t)i, angle = angle_about(out->middle, side, to, p);
            if (cut->loop[i] != loop || angle < from || angle <= last || angle >= next) continue;
            next = angle, place[0] = p[0], place[1] = p[1];
        }
        if (next > 1e29) return false;
        last = next;
        const double far = hypot(place[0] - out->middle[0], place[1] - out->middle[1]);
        const double here = depth_in(cut, other, place);
        if (fabs(here) < near || (found < 2 && here > 0.0)) continue;
        const bool apart = found == 0 || (next - out->angle[found - 1]) * far > 0.5 * near;
        if (here < 0.0 && found == 2) {
            if (apart) out->angle[0] = out->angle[1], out->far[0] = out->far[1];
            found = 1;
        } else if (found == 3 && !apart)
            continue;
        out->angle[found] = next, out->far[found++] = far;
    }
    return true;
}


/* where the loops of torso and arm would meet without the fillet between them, `near` [m] wide: (u, v); the place on
 * the torso's bare curve that is on the arm's. false: they do not meet */
static bool crease(const ruler_cut *cut, int32_t torso, double near, double side, double to, double *out)
{
    const int32_t arm = arm_loop(cut, torso, to);
    if (arm < 0) return false;
    const ruler_loop *t = &cut->of[torso], *a = &cut->of[arm];
    bare of_torso = {.middle = {0.0, 0.5 * (t->low[1] + t->high[1])}};
    bare of_arm = {.middle = {0.5 * (a->low[0] + a->high[0]), 0.5 * (a->low[1] + a->high[1])}};
    const double outside = -0.5 * acos(-1.0); /* the arm's side away from the body */
    if (!bare_of(cut, torso, arm, near, side, to, 0.0, &of_torso) ||
        !bare_of(cut, arm, torso, near, side, -to, outside, &of_arm))
        return false;
    double low = of_torso.angle[1], high = of_torso.angle[2];
    for (int step = 0; step < 40; step++) {
        const double angle = 0.5 * (low + high), far = cubic(of_torso.angle, of_torso.far, angle);
        out[0] = to * far * sin(angle), out[1] = of_torso.middle[1] - side * far * cos(angle);
        const double off = hypot(out[0] - of_arm.middle[0], out[1] - of_arm.middle[1]);
        if (off > cubic(of_arm.angle, of_arm.far, angle_about(of_arm.middle, side, -to, out)))
            low = angle;
        else
            high = angle;
    }
    return true;
}


/* across_back (side -1) or across_front (1): half way from the armpit to the shoulder, from arm to arm; ISO 8559-1:2017
 * has it between the points at which the arms leave the back */
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
    const double near = CREASE * mus_body_asked(body, MUS_MEASURE_STATURE);
    double *uv = malloc(sizeof *uv * 2 * ((size_t)cut.points + 2)), length = NAN, end[2];
    int32_t n = 1;
    if (uv != NULL && torso >= 0 && crease(&cut, torso, near, side, -1.0, uv) &&
        crease(&cut, torso, near, side, 1.0, end)) {
        for (int32_t i = 0; i < cut.points; i++) {
            const double *p = cut.uv + 2 * (size_t)i;
            const double limit = p[0] < 0.0 ? uv[1] : end[1];
            if (cut.loop[i] != torso || p[0] <= uv[0] || p[0] >= end[0] || side * (p[1] - limit) > 0.0) continue;
            memcpy(uv + 2 * (size_t)n++, p, 2 * sizeof *p);
        }
        memcpy(uv + 2 * (size_t)n++, end, sizeof end);
        length = ruler_string(n, uv, side);
    }
    free(uv);
    ruler_cut_free(&cut);
    return length;
}


/* twice the distance of the foremost point of the left breast from the middle plane. The cut is a polygon whose sides
 * are a centimetre long: the foremost place is where the slopes of its sides, by a cubic through four of them, are 0 */
static double span(const ruler_mesh *mesh, const mus_body *body)
{
    ruler_plane plane;
    ruler_cut cut;
    if (isnan(mus_body_made(body, MUS_MEASURE_BUST_SPAN)) || !contour_plane(body, TORSO, "bust", &plane)) return NAN;
    plane = ruler_plane_at((double[3]){0.0, plane.point[1], 0.0}, up, across);
    if (!ruler_cut_at(mesh, &plane, &cut)) return NAN;
    ruler_take_trunk(&cut, false);
    const int32_t torso = trunk_loop(&cut);
    double row[5][2], slope[4], middle[4];
    int32_t best = -1;
    for (int32_t i = 0; i < cut.points; i++) {
        const double *p = cut.uv + 2 * (size_t)i;
        if (cut.loop[i] == torso && p[0] >= 0.0 && (best < 0 || p[1] < cut.uv[2 * (size_t)best + 1])) best = i;
    }
    if (best >= 0) memcpy(row[2], cut.uv + 2 * (size_t)best, sizeof row[2]);
    for (int32_t k = 0; k < 4 && best >= 0; k++) { /* two neighbours on each side, in front */
        const int32_t from = k < 2 ? 2 - k : k, to = k < 2 ? 1 - k : k + 1;
        const double way = k < 2 ? -1.0 : 1.0;
        row[to][0] = way * 1e30, row[to][1] = 0.0;
        for (int32_t i = 0; i < cut.points; i++) {
            const double *p = cut.uv + 2 * (size_t)i;
            const bool next = way * (p[0] - row[from][0]) > 1e-3 && way * (p[0] - row[to][0]) < 0.0;
            if (cut.loop[i] == torso && p[1] < 0.0 && next) memcpy(row[to], p, sizeof row[to]);
        }
    }
    ruler_cut_free(&cut);
    if (best < 0) return NAN;
    for (int k = 0; k < 4; k++) {
        slope[k] = (row[k + 1][1] - row[k][1]) / (row[k + 1][0] - row[k][0]);
        middle[k] = 0.5 * (row[k + 1][0] + row[k][0]);
    }
    return 2.0 * cubic(slope, middle, 0.0);
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
