/*
 * scan_measure.c: the girths of a scanned body as a tape lies, from its contours.
 *
 * Bust: between waist and armpits, the largest girth of the levels where the chest is at most 4 mm behind its foremost
 * point. Waist: the smallest girth between 0.57 and 0.70 of the stature. Hip: the largest girth between crotch and
 * waist.
 * Thigh: the largest girth at least 1.5 cm (for 1.7 m) below the crotch; nearer to it sections widen into the other
 *        leg,
 * where no tape lies. Wrist: the smallest girth of the forearm. Limbs are the right ones, as people are measured, or
 * the left where there is no right one. Bust, waist and hip of a form without legs are its largest girth above, its
 * smallest girth in, and its largest girth below the middle third.
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "geom/vec.h"
#include "scan/scan_internal.h"

#define MEASURE_SAMPLES 192         /* samples of a contour; 192 equal angles: 0.05 mm on a girth of 1 m */
/* level of the thigh below the crotch, in parts of the stature (1.5 cm at 1.7 m); chosen: nearer to the crotch the
 * sections contain the other leg */
#define MEASURE_THIGH (0.015 / 1.7)
/* top of the chest beside a horizontal arm, in parts of the stature; chosen: a higher one takes in the shoulders */
#define MEASURE_CHEST 0.735
/* fronts that differ by less are equally far forwards, in parts of the stature (4 mm at 1.7 m); chosen: above the noise
 * of a scan */
#define MEASURE_FLAT (0.004 / 1.7)

/* of each contour of a limb: place on the axis, girth, Z of its foremost point [m] */
typedef struct measure_rows {
    int32_t count;
    double s[MUS__SCAN_CONTOURS], tape[MUS__SCAN_CONTOURS], ahead[MUS__SCAN_CONTOURS];
} measure_rows;


/* index of a limb by name; -1: none */
static int32_t measure_limb(const mus_body *body, const char *name)
{
    for (int32_t l = 0; l < mus_body_limb_count(body); l++)
        if (strcmp(mus_body_limb_name(body, l), name) == 0) return l;
    return -1;
}


/* the right limb, or the left one where there is no right one; -1: neither */
static int32_t measure_side(const mus_body *body, const char *right, const char *left)
{
    const int32_t l = measure_limb(body, right);
    return l >= 0 ? l : measure_limb(body, left);
}


/* measure all contours of limb l of the body */
static mus_status measure_contours(const mus_body *body, const mus_limb *limb, int32_t l, measure_rows *out)
{
    double point[3 * MEASURE_SAMPLES], xy[2 * MEASURE_SAMPLES], front[3];
    int32_t work[2 * MEASURE_SAMPLES];
    mus__cross3(limb->axis, limb->side, front);
    out->count = mus_body_contour_count(body, l);
    for (int32_t i = 0; i < out->count; i++) {
        mus_status status = mus_body_contour_points(body, l, i, MEASURE_SAMPLES, point);
        if (status != MUS_OK) return status;
        out->ahead[i] = -INFINITY;
        for (int32_t k = 0; k < MEASURE_SAMPLES; k++) {
            xy[2 * k] = mus__dot3(point + 3 * (ptrdiff_t)k, limb->side);
            xy[2 * k + 1] = mus__dot3(point + 3 * (ptrdiff_t)k, front);
            out->ahead[i] = fmax(out->ahead[i], point[3 * k + 2]);
        }
        out->s[i] = limb->contour[6 * (ptrdiff_t)i];
        out->tape[i] = mus__polygon_tape(MEASURE_SAMPLES, xy, work, work + MEASURE_SAMPLES);
    }
    return MUS_OK;
}


/* the contour between low and high [m] whose value times sign is largest; -1: there is none */
static int32_t measure_most(const measure_rows *rows, const double *value, double sign, double low, double high)
{
    int32_t best = -1;
    for (int32_t i = 0; i < rows->count; i++)
        if (rows->s[i] >= low && rows->s[i] <= high && (best < 0 || sign * value[i] > sign * value[best])) best = i;
    return best;
}


/* the contour between low and high with the largest girth of those whose front is at most `flat` [m] behind the
 * foremost: the front of a flat chest alone does not tell the bust level */
static int32_t measure_bust(const measure_rows *rows, double low, double high, double flat)
{
    const int32_t front = measure_most(rows, rows->ahead, 1.0, low, high);
    int32_t best = front;
    for (int32_t i = 0; i < rows->count && front >= 0; i++)
        if (rows->s[i] >= low && rows->s[i] <= high && rows->ahead[i] >= rows->ahead[front] - flat &&
            rows->tape[i] > rows->tape[best])
            best = i;
    return best;
}


/* girth and height of contour i, into the report */
static void measure_note(mus_scan_report *report, int32_t girth, const measure_rows *rows, int32_t i)
{
    if (i < 0) return;
    report->girth[girth] = rows->tape[i];
    report->girth_height[girth] = rows->s[i];
}


/* the largest girth at `high` [m] or below, into the report; at `high` itself linear between two contours */
static void measure_below(mus_scan_report *report, int32_t girth, const measure_rows *rows, double high)
{
    const int32_t best = measure_most(rows, rows->tape, 1.0, 0.0, high);
    measure_note(report, girth, rows, best);
    for (int32_t i = 0; i + 1 < rows->count; i++) {
        const double *s = rows->s + i, *tape = rows->tape + i;
        if (!(s[0] <= high && high < s[1])) continue;
        const double there = tape[0] + (high - s[0]) / (s[1] - s[0]) * (tape[1] - tape[0]);
        if (best >= 0 && there <= rows->tape[best]) continue;
        report->girth[girth] = there;
        report->girth_height[girth] = high;
    }
}


/* height [m] up to which sections are those of the chest beside an arm. A horizontal arm leaves the torso along its
 * whole flank, with a vertical wall, so that its armpit is lower than the chest */
static double measure_armpit(const mus__scan_arm *arm, double h)
{
    const double armpit = arm->armpit[1];
    return arm->axis[1] > -MUS__SCAN_HORIZONTAL ? fmax(armpit, MEASURE_CHEST * h) : armpit;
}


/* bust, waist and hip, into the report */
static void measure_torso(const measure_rows *rows, const mus__scan_found *found, mus_scan_report *report)
{
    const double h = found->stature;
    if (!found->legs) {
        measure_note(report, MUS_SCAN_BUST, rows, measure_most(rows, rows->tape, 1.0, 0.60 * h, h));
        measure_note(report, MUS_SCAN_WAIST, rows, measure_most(rows, rows->tape, -1.0, 0.33 * h, 0.67 * h));
        measure_note(report, MUS_SCAN_HIP, rows, measure_most(rows, rows->tape, 1.0, 0.0, 0.40 * h));
        return;
    }
    const int32_t waist = measure_most(rows, rows->tape, -1.0, 0.57 * h, 0.70 * h);
    const double level = waist >= 0 ? rows->s[waist] : 0.62 * h;
    double armpit = 0.76 * h;
    for (int i = 0; i < 2; i++)
        if (found->arm[i].there) armpit = fmin(armpit, measure_armpit(&found->arm[i], h));
    measure_note(report, MUS_SCAN_WAIST, rows, waist);
    measure_note(report, MUS_SCAN_BUST, rows, measure_bust(rows, fmax(level, 0.66 * h), armpit, MEASURE_FLAT * h));
    measure_note(report, MUS_SCAN_HIP, rows,
                 measure_most(rows, rows->tape, 1.0, found->crotch + 0.01 * h, found->crotch + 0.13 * h));
}


mus_status mus__scan_measure(const mus_body *body, const mus__scan_found *found, const mus__scan_limbs *limbs,
                             mus_scan_report *report)
{
    measure_rows rows;
    const mus__scan_arm *arm = &found->arm[found->arm[1].there ? 1 : 0];
    for (int32_t l = 0; l < limbs->count; l++) {
        mus_status status = measure_contours(body, &limbs->limb[l], l, &rows);
        if (status != MUS_OK) return status;
        if (l == measure_limb(body, "torso")) measure_torso(&rows, found, report);
        if (l == measure_side(body, "leg_right", "leg_left"))
            measure_below(report, MUS_SCAN_THIGH, &rows, found->crotch - MEASURE_THIGH * found->stature);
        if (l == measure_side(body, "arm_right", "arm_left"))
            measure_note(report, MUS_SCAN_WRIST, &rows,
                         measure_most(&rows, rows.tape, -1.0, arm->wrist - 0.03 * found->stature,
                                      arm->wrist + 0.03 * found->stature));
    }
    return MUS_OK;
}
