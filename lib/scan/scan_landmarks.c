/*
 * scan_landmarks.c: crotch, neck, feet and arms of a person.
 *
 * The crotch is the highest level at which a section has two legs. The axis of an arm goes through the centroids of a
 * section of the upper arm and one of the forearm, square to it; it is found in three rounds from a guess. Up the arm
 * along that axis the section stays small until the plane meets the torso. Beside a horizontal arm it meets the torso
 * gradually; there no section may be 2.6 times as high as the lowest one of the arm. The armpit is the lowest point of
 * the last section that belongs to the arm alone. The wall, a plane through the armpit half way between vertical and
 * square to the arm, separates arm and torso:
 *
 *          head                n = unit(x + axis): the wall's normal, outwards
 *       ___|  |___  /
 *      /  |      \ / wall
 *     /   | torso \\
 *             armpit^ \ arm
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "geom/vec.h"
#include "scan/scan_internal.h"

/* [m] step along an arm, for a stature of 1.7 m; chosen: the armpit is found to within half of it */
#define FIND_STEP 0.004
/* a horizontal arm ends where its section is this many times as high as its lowest one; chosen: a smaller value cuts
 * off the upper arm, a larger one takes in the chest */
#define FIND_TALL 2.6
/* largest distance of an arm's skin from its axis, in parts of the stature (13 cm); chosen: a larger section is not
 * of an arm */
#define FIND_SPREAD 0.075


/* whether two loops are side by side; thighs that touch may overlap by less than 0.3 of the narrower one */
static bool find_beside(const mus__loop *a, const mus__loop *b)
{
    const double lap = fmin(a->box[1], b->box[1]) - fmax(a->box[0], b->box[0]);
    return b->area >= 0.4 * a->area && lap < 0.3 * fmin(a->box[1] - a->box[0], b->box[1] - b->box[0]);
}


/* whether the section at height y [m] has two legs, in *two; the loops of the legs in *left and *right */
static mus_status find_legs(mus__slicer *upright, double y, bool *two, mus__loop *left, mus__loop *right)
{
    *two = false;
    mus_status status = mus__slice(upright, y, "the legs");
    const mus__section *section = &upright->section;
    for (int32_t j = 1; j < section->loops && status == MUS_OK; j++) {
        const mus__loop *first = &section->loop[0], *other = &section->loop[j];
        if (!find_beside(first, other)) continue;
        *two = true;
        *left = first->centre[0] > other->centre[0] ? *first : *other;
        *right = first->centre[0] > other->centre[0] ? *other : *first;
        break;
    }
    return status;
}


/* height of the crotch, by bisection, and X of the plane between the legs */
static mus_status find_crotch(mus__slicer *upright, mus__scan_found *out)
{
    const double h = out->stature;
    mus__loop left, right;
    double low = 0.0, high = 0.62 * h;
    bool two = false;
    for (; !two && high > 0.10 * h; high = two ? high : low) {
        low = high - 0.005 * h;
        mus_status status = find_legs(upright, low, &two, &left, &right);
        if (status != MUS_OK) return status;
    }
    if (!two) return mus__fail(upright->context, MUS_ERR_BODY, "mesh: no two legs are found below %.2f m", 0.62 * h);

    while (high - low > 1e-4 * h) {
        const double middle = 0.5 * (low + high);
        mus_status status = find_legs(upright, middle, &two, &left, &right);
        if (status != MUS_OK) return status;
        *(two ? &low : &high) = middle;
    }
    out->crotch = 0.5 * (low + high);
    mus_status status = find_legs(upright, low - 0.003 * h, &two, &left, &right);
    out->middle = two ? 0.5 * (left.box[0] + right.box[1]) : 0.0;
    return status;
}


/* the level of the smallest section of the neck, and the top of the feet, if they are longer than the ankles */
static mus_status find_ends(mus__slicer *upright, mus__scan_found *out)
{
    const double h = out->stature;
    const mus__section *section = &upright->section;
    double least = INFINITY, deep[2] = {0.0, 0.0};
    mus_status status = MUS_OK;
    out->neck = 0.86 * h;
    for (int k = 0; k < 40 && status == MUS_OK; k++) {
        const double y = (0.76 + 0.004 * k) * h;
        status = mus__slice(upright, y, "the neck");
        if (section->loops > 0 && section->loop[0].area < least) least = section->loop[0].area, out->neck = y;
    }
    for (int k = 0; k < 2 && status == MUS_OK && out->legs; k++) {
        status = mus__slice(upright, (k == 0 ? 0.015 : 0.075) * h, "the feet");
        if (section->loops > 0) deep[k] = section->loop[0].box[3] - section->loop[0].box[2];
    }
    out->foot = deep[0] > 1.3 * deep[1] ? 0.045 * h : 0.0;
    return status;
}


/* centroid (2) of a group; returns the largest distance of its points from there */
static double find_spread(const mus__section *section, int32_t group, double *centre)
{
    double area = 0.0, most = 0.0;
    centre[0] = centre[1] = 0.0;
    for (int32_t j = 0; j < section->loops; j++) {
        const mus__loop *loop = &section->loop[j];
        if (loop->group != group) continue;
        area += loop->area;
        for (int i = 0; i < 2; i++) centre[i] += loop->area * loop->centre[i];
    }
    centre[0] /= area, centre[1] /= area;
    for (int32_t j = 0; j < section->loops; j++) {
        const mus__loop *loop = &section->loop[j];
        for (int32_t k = 0; k < loop->count && loop->group == group; k++)
            most = fmax(most, mus__dist2(centre, section->xy + 2 * (ptrdiff_t)(loop->first + k)));
    }
    return most;
}


/* a slicer along the arm; its front points backwards, as that of an arm of a body of a tape */
static mus_status find_slicer(const mus__scan_mesh *mesh, mus__scan_arm *arm, double gap, mus__slicer *out)
{
    double front[3];
    for (int i = 0; i < 3; i++) front[i] = (i == 2 ? -1.0 : 0.0) + arm->axis[2] * arm->axis[i];
    mus__unit3(front);
    mus__cross3(front, arm->axis, arm->across);
    return mus__slicer_make(mesh, arm->origin, arm->axis, arm->across, gap, out);
}


/* s of the finger tips: of the farthest vertex within 2 spread of the axis */
static double find_tip(const mus__slicer *along, double spread)
{
    double tip = 0.0;
    for (int32_t v = 0; v < along->mesh->vertices; v++) {
        const double *sab = along->sab + 3 * (ptrdiff_t)v;
        if (sab[1] * sab[1] + sab[2] * sab[2] <= 4.0 * spread * spread) tip = fmax(tip, sab[0]);
    }
    return tip;
}


/* the axis through the centroids of two sections, near 0.38 and 0.74 of the arm's length. Errors: MUS_ERR_BODY */
static mus_status find_axis(const mus__scan_mesh *mesh, double h, mus__scan_arm *arm)
{
    mus_status status = MUS_OK;
    for (int round = 0; round < 3 && status == MUS_OK; round++) {
        mus__slicer along;
        double point[2][3], shoulder[3];
        int32_t found = 0;
        memcpy(shoulder, arm->origin, sizeof shoulder);
        status = find_slicer(mesh, arm, 1e30, &along);
        if (status != MUS_OK) return status;
        const double tip = find_tip(&along, FIND_SPREAD * h);
        for (int k = 0; k < 2 && status == MUS_OK; k++)
            for (double part = k == 0 ? 0.38 : 0.74; part < (k == 0 ? 0.6 : 0.85); part += 0.03) {
                double centre[2];
                status = mus__slice(&along, part * tip, "an arm");
                const int32_t group = mus__section_near(&along.section, 2.0 * FIND_SPREAD * h);
                if (status != MUS_OK) break;
                if (group < 0 || find_spread(&along.section, group, centre) > FIND_SPREAD * h) continue;
                for (int i = 0; i < 3; i++)
                    point[k][i] = arm->origin[i] + part * tip * arm->axis[i] + centre[0] * along.side[i] +
                                  centre[1] * along.front[i];
                found++;
                break;
            }
        mus__slicer_free(&along);
        if (found < 2 && status == MUS_OK)
            return mus__fail(mesh->context, MUS_ERR_BODY,
                             "mesh: the %s arm cannot be followed: it is bent, or no arm is spread there",
                             arm->side > 0.0 ? "left" : "right");
        if (status != MUS_OK) return status;

        double back = 0.0;
        for (int i = 0; i < 3; i++) arm->axis[i] = point[1][i] - point[0][i];
        mus__unit3(arm->axis);
        for (int i = 0; i < 3; i++) back += (shoulder[i] - point[0][i]) * arm->axis[i];
        for (int i = 0; i < 3; i++) arm->origin[i] = point[0][i] + back * arm->axis[i];
    }
    return status;
}


/* extent of a group along `up` */
static double find_tall(const mus__slicer *along, int32_t group, const double *up)
{
    const double side = mus__dot3(up, along->side), front = mus__dot3(up, along->front);
    double low = INFINITY, high = -INFINITY;
    for (int32_t j = 0; j < along->section.loops; j++) {
        const mus__loop *loop = &along->section.loop[j];
        for (int32_t k = 0; k < loop->count && loop->group == group; k++) {
            const double *ab = along->section.xy + 2 * (ptrdiff_t)(loop->first + k), at = side * ab[0] + front * ab[1];
            low = fmin(low, at), high = fmax(high, at);
        }
    }
    return high - low;
}


/* the sections of an arm so far, on the way up to the shoulder */
typedef struct find_way {
    double spread, last; /* most distance of points from the centroid, and that of the last section [m] */
    double tall;         /* least height of a section so far [m] */
    bool horizontal;     /* the arm is horizontal: its end is found by the height */
} find_way;


/* whether the section at s belongs to the arm alone, in *alone */
static mus_status find_alone(mus__slicer *along, const mus__scan_arm *arm, double s, find_way *way, bool *alone)
{
    double centre[2];
    mus_status status = mus__slice(along, s, "an arm");
    const int32_t group = mus__section_near(&along->section, way->spread);
    *alone = false;
    if (status != MUS_OK || group < 0) return status;
    const double now = find_spread(&along->section, group, centre), tall = find_tall(along, group, arm->up);
    *alone = now <= fmin(way->spread, 1.4 * way->last) && !(way->horizontal && tall > FIND_TALL * way->tall);
    if (!*alone) return status;
    way->last = fmax(now, 0.6 * way->last);
    way->tall = fmin(way->tall, tall);
    return status;
}


/* the root of the arm, the armpit, and the wall through it */
static mus_status find_armpit(mus__slicer *along, double h, mus__scan_arm *arm)
{
    const double step = FIND_STEP * h / 1.7, spread = 1.6 * FIND_SPREAD * h;
    double low = 0.0, high = 0.6 * arm->tip;
    bool alone = true;
    mus_status status = MUS_OK;
    arm->up[0] = -arm->axis[1] * arm->side, arm->up[1] = arm->axis[0] * arm->side, arm->up[2] = 0.0;
    mus__unit3(arm->up);
    find_way way = {spread, spread, INFINITY, arm->axis[1] > -MUS__SCAN_HORIZONTAL};
    for (low = high; status == MUS_OK && alone && low > -0.1 * h; low = alone ? low - step : low) {
        status = find_alone(along, arm, low, &way, &alone);
        if (alone) high = low;
    }
    while (high - low > 1e-4 * h && status == MUS_OK) {
        const double middle = 0.5 * (low + high);
        find_way copy = way;
        status = find_alone(along, arm, middle, &copy, &alone);
        *(alone ? &high : &low) = middle;
    }
    if (status == MUS_OK) status = mus__slice(along, high, "an arm");
    if (status != MUS_OK) return status;
    arm->root = high;

    /* the point of that section that is lowest along `up` */
    const int32_t group = mus__section_near(&along->section, spread);
    const double *up = arm->up;
    double least = INFINITY;
    for (int32_t j = 0; j < along->section.loops; j++) {
        const mus__loop *loop = &along->section.loop[j];
        for (int32_t k = 0; k < loop->count && loop->group == group; k++) {
            const double *ab = along->section.xy + 2 * (ptrdiff_t)(loop->first + k);
            double p[3];
            for (int i = 0; i < 3; i++)
                p[i] = arm->origin[i] + high * arm->axis[i] + ab[0] * along->side[i] + ab[1] * along->front[i];
            if (mus__dot3(up, p) < least) least = mus__dot3(up, p), memcpy(arm->armpit, p, sizeof p);
        }
    }
    arm->wall[0] = arm->side + arm->axis[0], arm->wall[1] = arm->axis[1], arm->wall[2] = 0.0;
    mus__unit3(arm->wall);
    arm->wall[3] = mus__dot3(arm->wall, arm->armpit);
    return MUS_OK;
}


/* the wrist: the section of the forearm whose hull has the least perimeter */
static mus_status find_wrist(mus__slicer *along, double h, mus__scan_arm *arm)
{
    double least = INFINITY;
    mus_status status = MUS_OK;
    mus__section piece = {0};
    arm->wrist = 0.76 * arm->tip;
    for (double s = 0.62 * arm->tip; s < 0.86 * arm->tip && status == MUS_OK; s += FIND_STEP * h / 1.7) {
        status = mus__slice(along, s, "an arm");
        const int32_t group = mus__section_near(&along->section, FIND_SPREAD * h);
        if (status != MUS_OK || group < 0) continue;
        status = mus__section_take(along->context, &along->section, group, 0, NULL, &piece);
        if (status == MUS_OK) status = mus__section_hull(along->context, &piece);
        if (status != MUS_OK || piece.loops == 0) continue;
        const double tape = mus__polygon_perimeter(piece.loop[0].count, piece.xy);
        if (tape < least) least = tape, arm->wrist = s;
    }
    mus__section_free(along->context, &piece);
    return status;
}


/* find one arm: whether there is one, its axis, tip, root, armpit and wrist */
static mus_status find_arm(const mus__scan_mesh *mesh, mus__slicer *upright, mus__scan_found *out, mus__scan_arm *arm)
{
    const double h = out->stature;
    const mus__section *section = &upright->section;
    const double *tip = NULL;
    for (int32_t v = 0; v < mesh->vertices; v++) {
        const double *x = mesh->x + 3 * (ptrdiff_t)v;
        if (x[1] > 0.3 * h && (tip == NULL || arm->side * x[0] > arm->side * tip[0])) tip = x;
    }
    mus_status status = mus__slice(upright, 0.62 * h, "the waist");
    if (status != MUS_OK || tip == NULL || section->loops == 0) return status;
    const double *box = section->loop[0].box;
    arm->there = arm->side * tip[0] > (arm->side > 0.0 ? box[1] : -box[0]) + 0.08 * h;
    if (!arm->there) return MUS_OK;

    /* guess of the axis: from the shoulder to the outermost vertex */
    status = mus__slice(upright, 0.79 * h, "the chest");
    if (status != MUS_OK) return status;
    const double back = section->loops > 0 ? -section->loop[0].centre[1] : 0.0;
    const double shoulder[3] = {out->middle + 0.10 * h * arm->side, 0.81 * h, back};
    memcpy(arm->origin, shoulder, sizeof shoulder);
    for (int i = 0; i < 3; i++) arm->axis[i] = tip[i] - shoulder[i];
    mus__unit3(arm->axis);
    status = find_axis(mesh, h, arm);
    if (status != MUS_OK) return status;

    mus__slicer along;
    status = find_slicer(mesh, arm, 1e30, &along);
    if (status != MUS_OK) return status;
    arm->tip = find_tip(&along, FIND_SPREAD * h);
    status = find_armpit(&along, h, arm);
    if (status == MUS_OK) status = find_wrist(&along, h, arm);
    mus__slicer_free(&along);
    return status;
}


mus_status mus__scan_find(const mus__scan_mesh *mesh, mus__slicer *upright, mus__scan_found *out)
{
    out->stature = upright->high;
    mus_status status = out->legs ? find_crotch(upright, out) : MUS_OK;
    if (status == MUS_OK) status = find_ends(upright, out);
    for (int i = 0; i < 2 && status == MUS_OK && out->legs; i++) {
        out->arm[i].side = i == 0 ? 1.0 : -1.0;
        status = find_arm(mesh, upright, out, &out->arm[i]);
    }
    return status;
}
