/*
 * scan_slice.c: sections of a mesh by planes square to an axis, as closed polygons.
 *
 * A vertex is above the plane or below (on it counts as above), so that a plane cuts two edges of a triangle or none,
 * and a section is a chain of segments from edge to edge; on a closed mesh every chain closes. Triangles are sorted
 * into bins along the axis, so that a plane looks at one bin. A cut edge gives the same point from both of its
 * triangles, to the last bit.
 *
 * Where a mesh has a hole, chains stay open. The longest chain first, the end of a chain is joined to the nearest end
 * that is left, its own beginning included, over at most `gap`. Loops inside another one (mouth, eyes) are left out;
 * loops that overlap (limbs that are closed meshes of their own) get one group.
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "geom/vec.h"
#include "scan/scan_internal.h"

/* intervals along the axis; chosen: with fewer a plane looks at more triangles, results are the same */
#define SLICE_BINS 512
/* least area of a loop, in parts of the square of the mesh's size; chosen: a smaller one is rounding */
#define SLICE_LEAST 1e-8
#define SLICE_DEBRIS 4.0 /* an open chain shorter than this many gaps is left out; chosen: as debris of a scan */


/* sort the triangles into the bins that they overlap: count, then list */
static mus_status slice_bins(mus__slicer *slicer)
{
    const mus__scan_mesh *mesh = slicer->mesh;
    slicer->scale = SLICE_BINS / fmax(slicer->high - slicer->low, 1e-30);
    slicer->start = mus__new(slicer->context, SLICE_BINS + 2, sizeof *slicer->start);
    if (slicer->start == NULL) return mus__fail_memory(slicer->context, "the sections of a mesh");
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t t = 0; t < mesh->triangles; t++) {
            const int32_t *v = mesh->triangle + 3 * (ptrdiff_t)t;
            double low = INFINITY, high = -INFINITY;
            for (int c = 0; c < 3; c++) {
                low = fmin(low, slicer->sab[3 * (ptrdiff_t)v[c]]);
                high = fmax(high, slicer->sab[3 * (ptrdiff_t)v[c]]);
            }
            const int32_t first = (int32_t)((low - slicer->low) * slicer->scale);
            const int32_t last = (int32_t)fmin((high - slicer->low) * slicer->scale, SLICE_BINS - 1.0);
            for (int32_t b = first < SLICE_BINS ? first : SLICE_BINS - 1; b <= last; b++) {
                if (pass == 0)
                    slicer->start[b + 2]++;
                else
                    slicer->list[slicer->start[b + 1]++] = t;
            }
        }
        if (pass == 1) break;
        for (int32_t b = 1; b <= SLICE_BINS; b++) slicer->start[b + 1] += slicer->start[b];
        slicer->list = mus__new(slicer->context, slicer->start[SLICE_BINS + 1], sizeof *slicer->list);
        if (slicer->list == NULL) return mus__fail_memory(slicer->context, "the sections of a mesh");
    }
    return MUS_OK;
}


mus_status mus__slicer_make(const mus__scan_mesh *mesh, const double *origin, const double *axis, const double *side,
                            double gap, mus__slicer *out)
{
    memset(out, 0, sizeof *out);
    out->context = mesh->context;
    out->mesh = mesh;
    out->gap = gap;
    memcpy(out->origin, origin, sizeof out->origin);
    memcpy(out->axis, axis, sizeof out->axis);
    memcpy(out->side, side, sizeof out->side);
    mus__cross3(out->axis, out->side, out->front);
    out->sab = mus__new(mesh->context, 3 * (int64_t)mesh->vertices, sizeof *out->sab);
    out->slot = mus__new(mesh->context, 2 * (int64_t)mesh->edges, sizeof *out->slot);
    if (out->sab == NULL || out->slot == NULL) {
        mus__slicer_free(out);
        return mus__fail_memory(mesh->context, "the sections of a mesh");
    }

    out->low = INFINITY, out->high = -INFINITY;
    for (int32_t v = 0; v < mesh->vertices; v++) {
        double d[3], *sab = out->sab + 3 * (ptrdiff_t)v;
        for (int i = 0; i < 3; i++) d[i] = mesh->x[3 * (ptrdiff_t)v + i] - origin[i];
        sab[0] = mus__dot3(d, out->axis), sab[1] = mus__dot3(d, out->side), sab[2] = mus__dot3(d, out->front);
        out->low = fmin(out->low, sab[0]), out->high = fmax(out->high, sab[0]);
    }
    for (int64_t i = 0; i < 2 * (int64_t)mesh->edges; i++) out->slot[i] = -1;
    mus_status status = slice_bins(out);
    if (status != MUS_OK) mus__slicer_free(out);
    return status;
}


void mus__slicer_free(mus__slicer *slicer)
{
    mus_context *context = slicer->context;
    mus__free(context, slicer->sab);
    mus__free(context, slicer->start);
    mus__free(context, slicer->list);
    mus__free(context, slicer->slot);
    mus__free(context, slicer->segment);
    mus__section_free(context, &slicer->section);
    memset(slicer, 0, sizeof *slicer);
}


/* the point (2) in which the plane at s cuts the edge between vertices v and w; the same for (w, v) */
static void slice_point(const mus__slicer *slicer, double s, int32_t v, int32_t w, double *out)
{
    const double *p = slicer->sab + 3 * (ptrdiff_t)(v < w ? v : w), *q = slicer->sab + 3 * (ptrdiff_t)(v < w ? w : v);
    const double t = (s - p[0]) / (q[0] - p[0]);
    out[0] = p[1] + t * (q[1] - p[1]), out[1] = p[2] + t * (q[2] - p[2]);
}


/* the segments in which the plane at s cuts the triangles of its bin, with the edges that they end on */
static mus_status slice_segments(mus__slicer *slicer, double s)
{
    const mus__scan_mesh *mesh = slicer->mesh;
    const int32_t bin = (int32_t)fmin(fmax((s - slicer->low) * slicer->scale, 0.0), SLICE_BINS - 1.0);
    slicer->segments = 0;
    mus_status status = mus__reserve(slicer->context, &slicer->segment, &slicer->segment_room,
                                     slicer->start[bin + 1] - slicer->start[bin], sizeof *slicer->segment);
    for (int32_t k = slicer->start[bin]; k < slicer->start[bin + 1] && status == MUS_OK; k++) {
        const int32_t t = slicer->list[k], *v = mesh->triangle + 3 * (ptrdiff_t)t;
        mus__segment *segment = &slicer->segment[slicer->segments];
        bool above[3];
        int ends = 0;
        for (int c = 0; c < 3; c++) above[c] = slicer->sab[3 * (ptrdiff_t)v[c]] >= s;
        for (int c = 0; c < 3; c++) {
            if (above[c] == above[(c + 1) % 3]) continue;
            slice_point(slicer, s, v[c], v[(c + 1) % 3], segment->xy + 2 * ends);
            segment->edge[ends++] = mesh->edge[3 * (ptrdiff_t)t + c];
        }
        if (ends != 2) continue;
        segment->walked = false;
        for (int i = 0; i < 2; i++) {
            int32_t *slot = slicer->slot + 2 * (ptrdiff_t)segment->edge[i];
            if (slot[0] < 0)
                slot[0] = slicer->segments;
            else if (slot[1] < 0)
                slot[1] = slicer->segments;
        }
        slicer->segments++;
    }
    return status;
}


/* the segment that continues another one at an end, -1: none */
static int32_t slice_next(const mus__slicer *slicer, int32_t segment, int end)
{
    const int32_t *slot = slicer->slot + 2 * (ptrdiff_t)slicer->segment[segment].edge[end];
    return slot[0] == segment ? slot[1] : slot[1] == segment ? slot[0] : -1;
}


/* append a point to the last loop */
static mus_status slice_add_point(mus__slicer *slicer, const double *xy)
{
    mus__section *section = &slicer->section;
    const int64_t need = section->points + (int64_t)1;
    mus_status status = mus__reserve(slicer->context, &section->xy, &section->room, need, 2 * sizeof *section->xy);
    if (status != MUS_OK) return status;
    memcpy(section->xy + 2 * (ptrdiff_t)section->points++, xy, 2 * sizeof *xy);
    section->loop[section->loops - 1].count++;
    return MUS_OK;
}


/* begin a loop */
static mus_status slice_add_loop(mus__slicer *slicer)
{
    mus__section *section = &slicer->section;
    mus_status status = mus__reserve(slicer->context, &section->loop, &section->loop_room, section->loops + (int64_t)1,
                                     sizeof *section->loop);
    if (status == MUS_OK) section->loop[section->loops++] = (mus__loop){.first = section->points};
    return status;
}


/* make a chain that begins with segment k, at its end `from` */
static mus_status slice_walk(mus__slicer *slicer, int32_t k, int from)
{
    mus_status status = slice_add_loop(slicer);
    while (status == MUS_OK) {
        mus__segment *segment = &slicer->segment[k];
        segment->walked = true;
        status = slice_add_point(slicer, segment->xy + 2 * from);
        const int32_t next = slice_next(slicer, k, 1 - from);
        if (next >= 0 && !slicer->segment[next].walked) {
            from = slicer->segment[next].edge[0] == segment->edge[1 - from] ? 0 : 1;
            k = next;
            continue;
        }
        if (next < 0 && status == MUS_OK) {
            status = slice_add_point(slicer, segment->xy + 2 * (1 - from));
            slicer->section.loop[slicer->section.loops - 1].open = true;
        }
        break;
    }
    return status;
}


/* make all chains: the open ones from their ends, then the closed ones */
static mus_status slice_chains(mus__slicer *slicer)
{
    mus_status status = MUS_OK;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = 0; k < slicer->segments && status == MUS_OK; k++) {
            if (slicer->segment[k].walked) continue;
            const bool low = slice_next(slicer, k, 0) < 0, high = slice_next(slicer, k, 1) < 0;
            if (pass == 1 || low || high) status = slice_walk(slicer, k, pass == 1 || low ? 0 : 1);
        }
    for (int32_t k = 0; k < slicer->segments; k++)
        for (int i = 0; i < 2; i++) {
            int32_t *slot = slicer->slot + 2 * (ptrdiff_t)slicer->segment[k].edge[i];
            slot[0] = slot[1] = -1;
        }
    return status;
}


/* point k of a loop */
static const double *slice_at(const mus__section *section, int32_t loop, int32_t k)
{
    return section->xy + 2 * (ptrdiff_t)(section->loop[loop].first + k);
}


/* length of a chain */
static double slice_length(const mus__section *section, int32_t loop)
{
    double length = 0.0;
    for (int32_t k = 0; k + 1 < section->loop[loop].count; k++)
        length += mus__dist2(slice_at(section, loop, k), slice_at(section, loop, k + 1));
    return length;
}


/* the open chain with an end nearer to a point than *best, -1: none; *back: that end is its last point */
static int32_t slice_nearest(const mus__section *section, int32_t chains, const double *from, double *best, bool *back)
{
    int32_t found = -1;
    for (int32_t j = 0; j < chains; j++) {
        if (!section->loop[j].open) continue;
        for (int end = 0; end < 2; end++) {
            const double d = mus__dist2(from, slice_at(section, j, end == 0 ? 0 : section->loop[j].count - 1));
            if (!(d < *best)) continue;
            *best = d, found = j, *back = end == 1;
        }
    }
    return found;
}


/* append chain j, backwards if `back`, to the last loop, and remove it */
static mus_status slice_append(mus__slicer *slicer, int32_t j, bool back)
{
    mus__section *section = &slicer->section;
    mus_status status = MUS_OK;
    const int32_t n = section->loop[j].count;
    for (int32_t k = 0; k < n && status == MUS_OK; k++) {
        const double xy[2] = {slice_at(section, j, back ? n - 1 - k : k)[0],
                              slice_at(section, j, back ? n - 1 - k : k)[1]};
        status = slice_add_point(slicer, xy);
    }
    section->loop[j].open = false, section->loop[j].count = 0;
    return status;
}


/* join the open chains to loops, the longest first. Errors: MUS_ERR_BODY (a hole wider than the gap) */
static mus_status slice_join(mus__slicer *slicer, double s, const char *what)
{
    mus__section *section = &slicer->section;
    const int32_t chains = section->loops;
    for (;;) {
        int32_t longest = -1;
        for (int32_t j = 0; j < chains; j++) {
            if (!section->loop[j].open) continue;
            section->loop[j].area = slice_length(section, j);
            if (longest < 0 || section->loop[j].area > section->loop[longest].area) longest = j;
        }
        if (longest < 0) return MUS_OK;

        double widest = 0.0;
        int32_t j = longest, gaps = 0;
        bool back = false;
        mus_status status = slice_add_loop(slicer);
        const int32_t own = section->loops - 1;
        while (j >= 0) {
            if (status == MUS_OK) status = slice_append(slicer, j, back);
            if (status != MUS_OK) return status;
            const double *tail = slice_at(section, own, section->loop[own].count - 1);
            double gap = mus__dist2(tail, slice_at(section, own, 0));
            j = slice_nearest(section, chains, tail, &gap, &back);
            widest = fmax(widest, gap);
            gaps++;
        }
        if (widest <= slicer->gap) {
            slicer->holes += gaps;
            slicer->widest = fmax(slicer->widest, widest);
        } else if (slice_length(section, own) <= SLICE_DEBRIS * slicer->gap) {
            section->loop[own].count = 0;
        } else {
            return mus__fail(slicer->context, MUS_ERR_BODY,
                             "mesh: the section of %s at %.3f m has a hole of %.3f m; holes are closed up to %.3f m",
                             what, s, widest, slicer->gap);
        }
    }
}


/* turn a loop counter-clockwise and compute its area, centroid and box; false: its area is negligible */
static bool slice_measure(mus__slicer *slicer, mus__loop *loop)
{
    const double size = slicer->high - slicer->low;
    double *xy = slicer->section.xy + 2 * (ptrdiff_t)loop->first;
    if (loop->count < 3) return false;
    loop->area = mus__polygon_centre(loop->count, xy, loop->centre);
    if (!(fabs(loop->area) >= SLICE_LEAST * size * size)) return false;
    for (int32_t k = 0, m = loop->count - 1; loop->area < 0.0 && k < m; k++, m--)
        for (int i = 0; i < 2; i++) {
            const double swap = xy[2 * k + i];
            xy[2 * k + i] = xy[2 * m + i], xy[2 * m + i] = swap;
        }
    loop->area = fabs(loop->area);
    loop->box[0] = loop->box[2] = INFINITY, loop->box[1] = loop->box[3] = -INFINITY;
    for (int32_t k = 0; k < loop->count; k++)
        for (int i = 0; i < 2; i++) {
            loop->box[2 * i] = fmin(loop->box[2 * i], xy[2 * k + i]);
            loop->box[2 * i + 1] = fmax(loop->box[2 * i + 1], xy[2 * k + i]);
        }
    return true;
}


/* whether a loop lies inside another one, or with `any` overlaps it */
static bool slice_inside(const mus__section *section, const mus__loop *loop, const mus__loop *outer, bool any)
{
    for (int i = 0; i < 2; i++)
        if (loop->box[2 * i] > outer->box[2 * i + 1] || loop->box[2 * i + 1] < outer->box[2 * i]) return false;
    const double *xy = section->xy + 2 * (ptrdiff_t)loop->first;
    for (int32_t k = 0; k < loop->count; k++) {
        const bool in = mus__polygon_winding(outer->count, section->xy + 2 * (ptrdiff_t)outer->first, xy + 2 * k) != 0;
        if (in == any) return any;
    }
    return !any;
}


/* sort the loops by area, leave out those inside a larger one, and give one group to those that overlap */
static void slice_order(mus__slicer *slicer)
{
    mus__section *section = &slicer->section;
    int32_t kept = 0;
    for (int32_t j = 0; j < section->loops; j++) {
        mus__loop loop = section->loop[j];
        if (!slice_measure(slicer, &loop)) continue;
        int32_t at = kept++;
        for (; at > 0 && section->loop[at - 1].area < loop.area; at--) section->loop[at] = section->loop[at - 1];
        section->loop[at] = loop;
    }

    section->loops = 0;
    for (int32_t j = 0; j < kept; j++) {
        mus__loop loop = section->loop[j];
        bool inside = false;
        for (int32_t i = 0; i < section->loops && !inside; i++)
            inside = slice_inside(section, &loop, &section->loop[i], false);
        if (inside) continue;
        loop.group = section->loops;
        for (int32_t i = 0; i < section->loops; i++) {
            const int32_t other = section->loop[i].group;
            if (other == loop.group) continue;
            if (!slice_inside(section, &loop, &section->loop[i], true) &&
                !slice_inside(section, &section->loop[i], &loop, true))
                continue;
            for (int32_t k = 0; k < section->loops; k++)
                if (section->loop[k].group == loop.group) section->loop[k].group = other;
            loop.group = other;
        }
        section->loop[section->loops++] = loop;
    }
}


mus_status mus__slice(mus__slicer *slicer, double s, const char *what)
{
    slicer->section.points = slicer->section.loops = 0;
    if (!(s >= slicer->low && s <= slicer->high)) return MUS_OK;
    mus_status status = slice_segments(slicer, s);
    if (status == MUS_OK) status = slice_chains(slicer);
    if (status == MUS_OK) status = slice_join(slicer, s, what);
    if (status == MUS_OK) slice_order(slicer);
    else slicer->section.points = slicer->section.loops = 0; /* a section that is half made is none */
    return status;
}
