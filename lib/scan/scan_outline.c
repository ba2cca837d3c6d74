/*
 * scan_outline.c: polygons of sections: centroid, cut by half planes, hull, and the star-shaped outline of a section.
 *
 * The outline has its corners at equal angles from the centroid; each is the farthest intersection of its ray with the
 * loops of the section, so that overlapping loops give their union. A side from p to q meets the rays d between the
 * angles of its ends at
 *
 *     r = (p x q) / (d x (q - p))
 *
 * so that one walk round the loops serves all rays. A ray that meets more than one side of a single loop crosses a
 * hollow that no star-shaped contour can follow; the hollow is closed and its depth reported.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/polygon.h"
#include "geom/vec.h"
#include "scan/scan_internal.h"

/* [m] least distance of a corner from the centre; chosen: a nearer one makes directions uncertain */
#define STAR_LEAST 5e-4
#define STAR_ROUNDS 3   /* rounds from the centroid of the largest loop to that of the union */


void mus__section_free(mus_context *context, mus__section *section)
{
    mus__free(context, section->xy);
    mus__free(context, section->loop);
    memset(section, 0, sizeof *section);
}


/* sums are taken relative to the first point, so that a polygon far from the origin keeps its digits */
double mus__polygon_centre(int32_t n, const double *xy, double *centre)
{
    double area = 0.0, a = 0.0, b = 0.0;
    for (int32_t k = 1; k + 1 < n; k++) {
        const double p[2] = {xy[2 * k] - xy[0], xy[2 * k + 1] - xy[1]};
        const double q[2] = {xy[2 * k + 2] - xy[0], xy[2 * k + 3] - xy[1]};
        const double cross = p[0] * q[1] - p[1] * q[0];
        area += cross;
        a += cross * (p[0] + q[0]), b += cross * (p[1] + q[1]);
    }
    centre[0] = centre[1] = 0.0;
    if (area == 0.0) return 0.0;
    centre[0] = xy[0] + a / (3.0 * area), centre[1] = xy[1] + b / (3.0 * area);
    return 0.5 * area;
}


/* cut a polygon (n x 2) by the half plane a p0 + b p1 >= p2 into out (2n x 2); returns the number of points. Sutherland
 * and Hodgman, Reentrant Polygon Clipping, 1974 */
static int32_t outline_clip(int32_t n, const double *xy, const double *plane, double *out)
{
    int32_t kept = 0;
    for (int32_t k = 0; k < n; k++) {
        const double *p = xy + 2 * (ptrdiff_t)k, *q = xy + 2 * (ptrdiff_t)((k + 1) % n);
        const double f = p[0] * plane[0] + p[1] * plane[1] - plane[2];
        const double g = q[0] * plane[0] + q[1] * plane[1] - plane[2];
        if (f >= 0.0) {
            memcpy(out + 2 * (ptrdiff_t)kept, p, 2 * sizeof *p);
            kept++;
        }
        if ((f >= 0.0) == (g >= 0.0)) continue;
        const double t = f / (f - g);
        out[2 * kept] = p[0] + t * (q[0] - p[0]), out[2 * kept + 1] = p[1] + t * (q[1] - p[1]);
        kept++;
    }
    return kept;
}


mus_status mus__section_take(mus_context *context, const mus__section *from, int32_t group, int32_t planes,
                             const double *plane, mus__section *out)
{
    out->points = out->loops = 0;
    for (int32_t j = 0; j < from->loops; j++) {
        mus__loop loop = from->loop[j];
        if (group >= 0 && loop.group != group) continue;

        /* a cut goes to the space behind the points and back; it at most doubles the number of points */
        int64_t most = loop.count;
        for (int32_t p = 0; p < planes; p++) most *= 2;
        mus_status status = mus__reserve(context, &out->xy, &out->room, out->points + 2 * most, 2 * sizeof *out->xy);
        if (status == MUS_OK)
            status = mus__reserve(context, &out->loop, &out->loop_room, out->loops + (int64_t)1, sizeof *out->loop);
        if (status != MUS_OK) return status;
        double *xy = out->xy + 2 * (ptrdiff_t)out->points, *spare = xy + 2 * most;
        memcpy(xy, from->xy + 2 * (ptrdiff_t)loop.first, 2 * (size_t)loop.count * sizeof *xy);
        for (int32_t p = 0; p < planes && loop.count > 0; p++) {
            loop.count = outline_clip(loop.count, xy, plane + 3 * (ptrdiff_t)p, spare);
            memcpy(xy, spare, 2 * (size_t)loop.count * sizeof *xy);
        }
        loop.first = out->points;
        loop.area = loop.count < 3 ? 0.0 : mus__polygon_centre(loop.count, xy, loop.centre);
        if (!(loop.area > STAR_LEAST * STAR_LEAST)) continue;
        out->points += loop.count;
        int32_t at = out->loops++;
        for (; at > 0 && out->loop[at - 1].area < loop.area; at--) out->loop[at] = out->loop[at - 1];
        out->loop[at] = loop;
    }
    return MUS_OK;
}


mus_status mus__section_hull(mus_context *context, mus__section *section)
{
    int32_t n = 0;
    for (int32_t j = 0; j < section->loops; j++) n += section->loop[j].count;
    if (n == 0) return MUS_OK;
    int32_t *index = mus__new(context, 2 * (int64_t)n, sizeof *index);
    double *all = mus__new(context, 2 * (int64_t)n, sizeof *all);
    mus_status status = MUS_OK;
    if (index == NULL || all == NULL) {
        status = mus__fail_memory(context, "the hull of a section");
    } else {
        n = 0;
        for (int32_t j = 0; j < section->loops; j++) {
            const mus__loop *loop = &section->loop[j];
            const double *xy = section->xy + 2 * (ptrdiff_t)loop->first;
            memcpy(all + 2 * (ptrdiff_t)n, xy, 2 * (size_t)loop->count * sizeof *all);
            n += loop->count;
        }
        const int32_t count = mus__polygon_hull(n, all, index, index + n);
        for (int32_t k = 0; k < count; k++)
            memcpy(section->xy + 2 * (ptrdiff_t)k, all + 2 * (ptrdiff_t)index[k], 2 * sizeof *all);
        section->points = count, section->loops = 1;
        section->loop[0].first = 0, section->loop[0].count = count;
        section->loop[0].area = mus__polygon_centre(count, section->xy, section->loop[0].centre);
    }
    mus__free(context, index);
    mus__free(context, all);
    return status;
}


double mus__loop_distance(const mus__section *section, int32_t loop)
{
    const double axis[2] = {0.0, 0.0}, *xy = section->xy + 2 * (ptrdiff_t)section->loop[loop].first;
    const int32_t n = section->loop[loop].count;
    return mus__polygon_winding(n, xy, axis) != 0 ? 0.0 : mus__polygon_distance(n, xy, axis);
}


int32_t mus__section_near(const mus__section *section, double spread)
{
    int32_t found = -1;
    double best = spread;
    for (int32_t j = 0; j < section->loops; j++) {
        const double distance = mus__loop_distance(section, j);
        if (distance < best) best = distance, found = section->loop[j].group;
    }
    return found;
}


/* update the farthest and nearest intersection (corners) of the rays that meet the side from p to q, relative to the
 * centre */
static void star_side(const double *p, const double *q, int32_t corners, double *farthest, double *nearest)
{
    const double cross = p[0] * q[1] - p[1] * q[0];
    if (cross == 0.0) return;
    const double step = 2.0 * MUS_PI / corners, from = mus__atan2(p[1], p[0]);
    const double turn = mus__atan2(cross, p[0] * q[0] + p[1] * q[1]);

    /* the direction of a side as short as rounding is undetermined: radii are clamped to those of its ends */
    const double zero[2] = {0.0, 0.0}, least = fabs(cross) / fmax(mus__dist2(p, q), 1e-300);
    const double most = fmax(mus__dist2(zero, p), mus__dist2(zero, q));
    const double low = (turn > 0.0 ? from : from + turn) / step, high = (turn > 0.0 ? from + turn : from) / step;
    for (double k = ceil(low - 1e-9); k <= high + 1e-9; k += 1.0) {
        const int32_t i = ((int32_t)k + 2 * corners) % corners;
        const double d[2] = {mus__cos(k * step), mus__sin(k * step)};
        const double r = fmin(fmax(cross / (d[0] * (q[1] - p[1]) - d[1] * (q[0] - p[0])), least), most);
        if (r > farthest[i]) farthest[i] = r;
        if (r < nearest[i]) nearest[i] = r;
    }
}


/* radii of the farthest, then of the nearest intersections of all rays, to out (2 corners); false: a ray meets no
 * side */
static bool star_rays(const mus__section *section, int32_t corners, const double *centre, double *out)
{
    double *farthest = out, *nearest = out + corners;
    for (int32_t k = 0; k < corners; k++) farthest[k] = 0.0, nearest[k] = INFINITY;
    for (int32_t j = 0; j < section->loops; j++) {
        const mus__loop *loop = &section->loop[j];
        const double *xy = section->xy + 2 * (ptrdiff_t)loop->first;
        for (int32_t k = 0; k < loop->count; k++) {
            const double *a = xy + 2 * (ptrdiff_t)k, *b = xy + 2 * (ptrdiff_t)((k + 1) % loop->count);
            const double p[2] = {a[0] - centre[0], a[1] - centre[1]}, q[2] = {b[0] - centre[0], b[1] - centre[1]};
            star_side(p, q, corners, farthest, nearest);
        }
    }
    bool all = true;
    for (int32_t k = 0; k < corners; k++) {
        if (farthest[k] == 0.0) all = false;
        farthest[k] = fmax(farthest[k], STAR_LEAST);
    }
    return all;
}


bool mus__star(const mus__section *section, int32_t corners, double *centre, double *out, double *fill)
{
    *fill = 0.0;
    if (section->loops == 0) return false;
    memcpy(centre, section->loop[0].centre, 2 * sizeof *centre);
    for (int round = 0; round < (section->loops == 1 ? 1 : STAR_ROUNDS); round++) {
        if (!star_rays(section, corners, centre, out)) return false;
        if (section->loops == 1)
            for (int32_t k = 0; k < corners; k++) *fill = fmax(*fill, out[k] - fmin(out[k], out[corners + k]));

        /* radii to corners, the last one first, since they share the array */
        const double about[2] = {centre[0], centre[1]};
        for (int32_t k = corners - 1; k >= 0; k--) {
            const double r = out[k], angle = 2.0 * MUS_PI * k / corners;
            out[2 * (ptrdiff_t)k] = about[0] + r * mus__cos(angle);
            out[2 * (ptrdiff_t)k + 1] = about[1] + r * mus__sin(angle);
        }
        if (round + 1 < STAR_ROUNDS && section->loops > 1) mus__polygon_centre(corners, out, centre);
    }
    return true;
}
