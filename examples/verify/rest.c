/*
 * rest.c: cloth comes to rest by itself: velocity Verlet against a drag that is near critical for its slowest
 * motion, until nothing moves. Plain on purpose: the cases that use it judge the cloth, not mus_drape_settle().
 */
#include "rest.h"

#include <math.h>
#include <stdio.h>

#define CHECK_STEPS 256


void rest_fabric(mus_fabric *fabric, double weight, double stretch, double shear, double bend)
{
    mus_fabric_init(fabric, sizeof *fabric);
    fabric->weight = weight;
    fabric->stretch[0] = fabric->stretch[1] = stretch;
    fabric->shear = shear;
    fabric->bend[0] = fabric->bend[1] = fabric->bend[2] = bend;
    fabric->damping = 0.0;
}


mus_status rest_panel(verify *v, int32_t n, const double *corners, double gx, double gy, double spacing,
                      const mus_fabric *fabric, mus_cloth **out)
{
    int32_t panel = 0, points[16], edges[16], forward[16];
    mus_pattern *pattern = NULL;
    mus_cloth_def def;
    mus_status status = mus_pattern_create(v->context, "piece", &pattern);
    if (status == MUS_OK) status = mus_pattern_add_panel(pattern, "piece", &panel);
    for (int32_t i = 0; i < n && status == MUS_OK; i++)
        status = mus_pattern_add_point(pattern, panel, corners[2 * i], corners[2 * i + 1], &points[i]);
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        status = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = points[i],
                                                               .end = points[(i + 1) % n]}, &edges[i]);
        forward[i] = 1;
    }
    if (status == MUS_OK) status = mus_pattern_set_outline(pattern, panel, n, edges, forward);
    if (status == MUS_OK) status = mus_pattern_set_grain(pattern, panel, gx, gy);
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = spacing;
    def.fabric = fabric;
    def.coarser = 0;
    if (status == MUS_OK) status = mus_cloth_create(v->context, pattern, &def, out);
    mus_pattern_destroy(pattern);
    return status;
}


mus_status rest_hang(verify *v, mus_cloth *cloth, int32_t precision, double drag, double gravity, mus_drape **out)
{
    mus_drape_def def;
    *out = NULL;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.integrator = MUS_METHOD_VERLET;
    def.drag = drag;
    def.gravity[1] = -gravity;
    const mus_status status = cloth != NULL ? mus_drape_create(v->context, cloth, NULL, &def, out) : MUS_ERR_ARG;
    mus_cloth_destroy(cloth);
    return status;
}


mus_status rest_settle(verify *v, mus_drape *drape, double speed, double seconds)
{
    double most = INFINITY;
    const int32_t n = 3 * mus_drape_node_count(drape);
    for (double t = 0.0; t < seconds && most > speed;) {
        /* the bound follows the pose */
        const double h = 0.9 * mus_drape_step_bound(drape);
        const mus_status status = mus_drape_step(drape, CHECK_STEPS, h);
        if (status != MUS_OK) return status;
        t += CHECK_STEPS * h;
        most = 0.0;
        for (int32_t i = 0; i < n; i++) most = fmax(most, fabs(mus_drape_velocities(drape)[i]));
    }
    if (most <= speed || speed == 0.0) return MUS_OK;
    char text[80];
    snprintf(text, sizeof text, "not at rest after %g s: a node moves at %g m/s", seconds, most);
    return mus_context_fail(v->context, MUS_ERR_UNSETTLED, text);
}


double rest_energy(const mus_drape *drape)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    return mus_drape_report_get(drape, &report) == MUS_OK ? report.energy : NAN;
}


void rest_row(verify *v, mus_status status, const char *id, const char *text, double exact, double got,
              double tolerance)
{
    if (status == MUS_OK)
        verify_add(v, id, text, exact, got, tolerance);
    else
        verify_broken(v, id, text, status);
}
