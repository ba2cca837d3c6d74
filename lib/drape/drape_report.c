/*
 * drape_report.c: the report of a drape: counters, gaps, depth, strain, energy, hash, normals, forces.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "drape/residual.h"
#include "drape/weld.h"
#include "geom/vec.h"
#include "sim/force_reference.h"


void mus_drape_report_init(mus_drape_report *report, size_t size)
{
    mus_drape_report own = {0};
    mus__def_init(report, size, &own, sizeof own);
}


/* depth of the deepest node below the skin [m]; 0 if none is */
static double deepest(const mus_drape *drape)
{
    double most = 0.0;
    if (drape->scene.collider == NULL) return most;
    for (int32_t i = 0; i < drape->n; i++) {
        const double depth = mus__collider_depth(drape->scene.collider, drape->x + 3 * (int64_t)i, 0.0, NULL);
        if (depth > most) most = depth;
    }
    return most;
}


mus_status mus_drape_depth(const mus_drape *drape, int32_t n, const double *points, double *depth, double *normal)
{
    const double far = 0.04; /* [m] */
    if (drape == NULL) return MUS_ERR_ARG;
    if (n < 0 || points == NULL || depth == NULL)
        return mus__fail(drape->context, MUS_ERR_ARG, "drape: depth of %d points, %s", (int)n,
                         points == NULL  ? "points are NULL"
                         : depth == NULL ? "depth is NULL"
                                         : "expected 0 or more");
    for (int64_t i = 0; i < 3 * (int64_t)n; i++)
        if (!isfinite(points[i]))
            return mus__fail(drape->context, MUS_ERR_ARG, "drape: point %d is not finite", (int)(i / 3));
    for (int32_t i = 0; i < n; i++) {
        double out[3] = {0.0, 0.0, 0.0};
        depth[i] = drape->scene.collider == NULL
                       ? -1e30
                       : mus__collider_depth(drape->scene.collider, points + 3 * (int64_t)i, far, out);
        if (normal != NULL) memcpy(normal + 3 * (int64_t)i, out, sizeof out);
    }
    return MUS_OK;
}


/* number of seams whose pairs are all within the collision distance */
static int32_t closed_seams(const mus_drape *drape)
{
    const mus_cloth *cloth = drape->cloth;
    int32_t closed = cloth->nseam, last = MUS_NONE;
    for (int32_t p = 0; p < cloth->npair; p++) {
        const double *a = drape->x + 3 * (int64_t)cloth->pair[2 * p],
                     *b = drape->x + 3 * (int64_t)cloth->pair[2 * p + 1];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        if (mus__norm3(d) <= drape->def.collision_distance || cloth->pair_seam[p] == last) continue;
        closed--;
        last = cloth->pair_seam[p];
    }
    return closed;
}


mus_status mus_drape_report_get(const mus_drape *drape, mus_drape_report *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL || out->size != sizeof *out)
        return mus__fail(drape->context, MUS_ERR_VERSION, "drape report: size unknown; use mus_drape_report_init");
    const mus_cloth *cloth = drape->cloth;
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    report.nodes = drape->n;
    report.springs = mus_cloth_spring_count(cloth);
    report.seams = cloth->nseam;
    report.seams_closed = closed_seams(drape);
    report.welded = drape->welded;
    report.settled = drape->relax.settled;
    report.max_seam_gap = mus__weld_gap(drape, &report.worst_seam);
    report.max_penetration = deepest(drape);
    report.max_strain = mus__program_strain(&drape->program, drape->x);
    report.residual = isnan(drape->relax.residual) ? mus__residual(drape, drape->x) : drape->relax.residual;

    report.energy = mus__program_force(&drape->program, drape->n, drape->x, NULL);
    for (int32_t i = 0; i < drape->n; i++) {
        const double *x = drape->x + 3 * (int64_t)i, *v = drape->v + 3 * (int64_t)i;
        const double speed2 = mus__dot3(v, v);
        report.energy += drape->mass[i] * (0.5 * speed2 - mus__dot3(drape->def.gravity, x));
        if (speed2 > report.max_speed * report.max_speed) report.max_speed = sqrt(speed2);
    }
    report.step = drape->clock.dt;
    report.step_bound = mus_drape_step_bound(drape);
    report.steps = drape->counters.steps;
    report.spring_evaluations = drape->counters.spring_evaluations;
    report.contact_queries = drape->counters.contact_queries;
    for (int32_t part = 0; part < 64; part++) {
        report.contact_queries += drape->sim.part_tally[part].queries;
        for (int32_t d = 0; d < 3; d++) report.contact_impulse[d] += drape->sim.part_tally[part].impulse[d];
    }
    report.sew_time = drape->counters.sew_time;
    report.settle_time = drape->counters.settle_time;
    report.step_parts = drape->stepping.parts;
    report.rest_distance = drape->relax.rest_distance;
    mus__drape_self_report(drape, &report);
    *out = report;
    return MUS_OK;
}


uint64_t mus_drape_hash(const mus_drape *drape)
{
    if (drape == NULL) return 0;
    uint64_t hash = MUS_HASH_START;
    const double time = mus_drape_time(drape);
    const double *arrays[] = {drape->x, drape->v, &time};
    const int64_t counts[] = {3 * (int64_t)drape->n, 3 * (int64_t)drape->n, 1};
    for (int32_t a = 0; a < 3; a++)
        for (int64_t i = 0; i < counts[a]; i++) {
            /* little-endian bytes on any machine; -0 and 0 hash alike */
            const double value = arrays[a][i] + 0.0;
            uint64_t bits;
            unsigned char bytes[8];
            memcpy(&bits, &value, sizeof bits);
            for (int32_t k = 0; k < 8; k++) bytes[k] = (unsigned char)(bits >> (8 * k));
            hash = mus__hash(hash, bytes, sizeof bytes);
        }
    return hash;
}


mus_status mus_drape_gaps(const mus_drape *drape, double *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: out is NULL");
    const mus_cloth *cloth = drape->cloth;
    for (int32_t p = 0; p < cloth->npair; p++) {
        const double *a = drape->x + 3 * (int64_t)cloth->pair[2 * p],
                     *b = drape->x + 3 * (int64_t)cloth->pair[2 * p + 1];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        out[p] = mus__norm3(d);
    }
    return MUS_OK;
}


mus_status mus_drape_forces(const mus_drape *drape, double *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: out is NULL");
    mus__program_force(&drape->program, drape->n, drape->x, out);
    for (int32_t i = 0; i < drape->n; i++)
        for (int32_t d = 0; d < 3; d++) out[3 * (int64_t)i + d] += drape->mass[i] * drape->def.gravity[d];
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->rep[i] != i) memcpy(out + 3 * (int64_t)i, out + 3 * (int64_t)drape->rep[i], 3 * sizeof *out);
    return MUS_OK;
}


mus_status mus_drape_normals(const mus_drape *drape, double *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: out is NULL");
    const mus__placed_cloth placed = mus__drape_placed(drape);
    mus__placed_normals(&placed, out);
    return MUS_OK;
}
