/*
 * cut_only_collar.c: under-collars: the collar with its outer edge drawn in, so that the seam rolls to the underside.
 *
 * The edges of a collar that are sewn to nothing are its outer edge. The under-collar has them 3 mm further in, less
 * towards the neck, where both layers are as long as each other. A stand below a leaf has hardly an outer edge: both
 * its layers are alike. Source: Fasanella, A tale and tutorial of three collars: 1/8 inch, tapering to zero at the
 * neck.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "geom/vec.h"
#include "finish/cut_only.h"

#define COLLAR_RIM 32     /* most edges of a collar; chosen: four times those of the richest draft */
#define COLLAR_IN 0.003   /* [m] the outer edge is drawn in by */
/* [m] of the outer edge from the neck on, over which it is drawn in, less on a short one; chosen: the edge turns by 5
 * degrees at most, which is sewn as a curve */
#define COLLAR_TAPER 0.05
#define COLLAR_CHORD 0.004 /* [m] chosen: 0.05 mm off an arc of 4 cm radius */

typedef struct collar_rim {
    int32_t n, edge[COLLAR_RIM], direction[COLLAR_RIM], first; /* the walk starts at rim edge `first` */
    bool outer[COLLAR_RIM];
    double run[COLLAR_RIM], at[COLLAR_RIM]; /* of the run of outer edges with each: its length, where the edge begins */
} collar_rim;


/* read the rim of a panel; false for one that needs no under-collar */
static bool collar_read(mus__cut_only *job, int32_t panel, collar_rim *rim)
{
    double outer = 0.0, sewn = 0.0;
    job->status = mus_pattern_rim(job->pattern, panel, rim->edge, rim->direction, COLLAR_RIM, &rim->n);
    if (job->status != MUS_OK || rim->n > COLLAR_RIM) return false;
    rim->first = MUS_NONE;
    for (int32_t i = 0; i < rim->n; i++) {
        const int32_t before = rim->edge[(i + rim->n - 1) % rim->n];
        rim->outer[i] = mus_pattern_edge_seam(job->pattern, rim->edge[i]) == MUS_NONE;
        *(rim->outer[i] ? &outer : &sewn) += mus_pattern_edge_length(job->pattern, rim->edge[i]);
        if (rim->outer[i] && mus_pattern_edge_seam(job->pattern, before) != MUS_NONE) rim->first = i;
    }
    if (rim->first == MUS_NONE || outer < 0.8 * sewn) return false;
    double length = 0.0;
    for (int32_t k = 0; k < rim->n; k++) {
        const int32_t i = (rim->first + k) % rim->n;
        rim->at[i] = rim->outer[i] ? length : 0.0;
        length = rim->outer[i] ? length + mus_pattern_edge_length(job->pattern, rim->edge[i]) : 0.0;
        for (int32_t j = k; j >= 0 && rim->outer[i] && rim->outer[(rim->first + j) % rim->n]; j--)
            rim->run[(rim->first + j) % rim->n] = length;
    }
    return true;
}


/* a point of rim edge i at arc length s, with the unit tangent of the chord about it that stays on the edge */
static void collar_at(mus__cut_only *job, const collar_rim *rim, int32_t i, double s, double *p, double *along)
{
    const double length = mus_pattern_edge_length(job->pattern, rim->edge[i]), near = 1e-4;
    double t[3] = {s / length, fmax(0.0, s - near) / length, fmin(length, s + near) / length}, xy[6] = {0.0};
    for (int32_t k = 0; k < 3; k++) t[k] = fmin(fmax(rim->direction[i] < 0 ? 1.0 - t[k] : t[k], 0.0), 1.0);
    if (job->status == MUS_OK) job->status = mus_pattern_edge_at(job->pattern, rim->edge[i], 3, t, xy);
    const double x = xy[4] - xy[2], y = xy[5] - xy[3], h = fmax(sqrt(x * x + y * y), 1e-12);
    p[0] = xy[0], p[1] = xy[1];
    along[0] = x / h, along[1] = y / h;
}


/* how far the outer edge of rim edge i is drawn in at s [m]: from nothing at the neck to all of it without a corner,
 * since 3 t^2 - 2 t^3 has no slope at either end */
static double collar_in(const collar_rim *rim, int32_t i, double s)
{
    const double on = rim->at[i] + s, taper = fmin(COLLAR_TAPER, 0.5 * rim->run[i]);
    const double t = fmax(0.0, fmin(1.0, fmin(on, rim->run[i] - on) / taper));
    return COLLAR_IN * t * t * (3.0 - 2.0 * t);
}


/* the place of the under-collar's outline at s of rim edge i: drawn in to the left of the walk; at a corner along the
 * line between both edges. Returns how far a corner has moved along both its edges [m]: what is nearer to it than that
 * on either lies beyond the corner of the under-collar */
static double collar_point(mus__cut_only *job, const collar_rim *rim, int32_t i, double s, double *out)
{
    double along[2], other[2], p[2], q[2];
    collar_at(job, rim, i, s, p, along);
    memcpy(out, p, sizeof p);
    if (!rim->outer[i]) return 0.0;
    const int32_t before = (i + rim->n - 1) % rim->n;
    const double by = collar_in(rim, i, s);
    memcpy(other, along, sizeof other);
    if (s == 0.0 && rim->outer[before])
        collar_at(job, rim, before, mus_pattern_edge_length(job->pattern, rim->edge[before]), q, other);
    const double part = by / fmax(1.0 + along[0] * other[0] + along[1] * other[1], 0.2);
    out[0] -= part * (along[1] + other[1]);
    out[1] += part * (along[0] + other[0]);
    return part * fabs(along[0] * other[1] - along[1] * other[0]);
}


/* give the under-collar `made` the notches of the collar */
static void collar_notches(mus__cut_only *job, const collar_rim *rim, int32_t made)
{
    for (int32_t k = 0; k < mus_pattern_notch_count(job->pattern) && job->status == MUS_OK; k++) {
        int32_t edge, kind, i = 0;
        double s;
        job->status = mus_pattern_notch(job->pattern, k, &edge, &s, &kind);
        while (i < rim->n && rim->edge[i] != edge) i++;
        if (job->status != MUS_OK || i == rim->n || rim->outer[i]) continue;
        const double length = mus_pattern_edge_length(job->pattern, edge);
        const int32_t own = mus_pattern_find_edge(job->made, made, mus_pattern_edge_name(job->pattern, edge));
        const double at = (rim->direction[i] < 0 ? length - s : s) / length;
        job->status = mus_pattern_add_notch(job->made, own, at * mus_pattern_edge_length(job->made, own), kind, NULL);
    }
}


static void collar_under(mus__cut_only *job, int32_t panel, const collar_rim *rim, int32_t main, int32_t image)
{
    mus__cut_shape shape;
    double p[2], corner[2], grain[2];
    char name[2 * MUS__NAME_BYTES];
    double from = collar_point(job, rim, rim->first, 0.0, corner), to;
    mus__cut_shape_begin(&shape, "layer", corner[0], corner[1]);
    for (int32_t k = 0; k < rim->n; k++, from = to) {
        const int32_t i = (rim->first + k) % rim->n, edge = rim->edge[i];
        const double length = mus_pattern_edge_length(job->pattern, edge);
        const int32_t n = (int32_t)fmin(ceil(length / COLLAR_CHORD), (double)(MUS__CUT_POINTS / rim->n));
        to = collar_point(job, rim, (i + 1) % rim->n, 0.0, corner);
        for (int32_t j = 1; j < n; j++) {
            const double s = length * j / n;
            if (s <= from || length - s <= to) continue;
            collar_point(job, rim, i, s, p);
            mus__cut_shape_to(&shape, p[0], p[1]);
        }
        mus__cut_shape_to(&shape, corner[0], corner[1]);
        mus__cut_shape_edge(&shape, mus_pattern_edge_name(job->pattern, edge),
                            mus_pattern_edge_label(job->pattern, edge), mus_pattern_edge_allowance(job->pattern, edge));
    }
    if (job->status == MUS_OK) job->status = mus_pattern_grain(job->pattern, panel, grain);
    if (job->status != MUS_OK) return;
    memcpy(shape.grain, grain, sizeof grain);
    snprintf(name, sizeof name, "under_%s", mus_pattern_panel_name(job->pattern, panel));
    const int32_t made = mus__cut_shape_add(job, &shape, name, MUS_MATERIAL_MAIN, main);
    collar_notches(job, rim, made);
    if (image == MUS_NONE || job->status != MUS_OK) return;
    snprintf(name, sizeof name, "under_%s", mus_pattern_panel_name(job->pattern, image));
    job->status = mus_pattern_set_cut(job->made, made, main, mus_pattern_find_panel(job->made, name));
}


void mus__cut_under_collars(mus__cut_only *job, mus_pattern *pattern)
{
    collar_rim rim;
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern) && job->status == MUS_OK; i++) {
        int32_t image = MUS_NONE, main = 0;
        if (strcmp(mus_pattern_panel_label(pattern, i), "collar") != 0) continue;
        job->status = mus_pattern_cut(pattern, i, &main, &image);
        if (job->status != MUS_OK || main < 2 || !collar_read(job, i, &rim)) continue;
        collar_under(job, i, &rim, main / 2, image);
        if (job->status == MUS_OK) job->status = mus_pattern_set_cut(pattern, i, main / 2, image);
    }
}
