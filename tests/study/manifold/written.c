/* written.c: see written.h */
#include "written.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "muslin/exchange.h"
#include "study/outside/measure.h"


/* girths of the file beside those of the tape that was given */
static bool measure(const mus_body *body, const char *path, written *out)
{
    double made[OUTSIDE_ROWS];
    if (!outside_measure(body, path, made)) return false;
    for (int i = 0; i < OUTSIDE_ROWS; i++) {
        const outside_row *row = &outside_rows[i];
        const double off = made[i] - mus_body_asked(body, row->measure);
        if (mus_body_source(body, row->measure) != MUS_SOURCE_GIVEN) continue;
        if ((row->kind != 'g' && row->kind != 'l') || isnan(made[i]) || fabs(off) <= fabs(out->girth)) continue;
        out->girth = off;
        snprintf(out->measure, sizeof out->measure, "%s", mus_measure_name(row->measure));
    }
    return true;
}


bool written_manifold(mus_context *context, const mus_body *body, const mus_manifold_def *def, const char *path,
                      bool girths, written *out)
{
    mus_manifold *manifold = NULL;
    ruler_mesh mesh = {0};
    memset(out, 0, sizeof *out);
    const clock_t start = clock();
    if (mus_manifold_create(body, def, &manifold) != MUS_OK) return false;
    out->spent = (double)(clock() - start) / CLOCKS_PER_SEC;
    out->vertices = mus_manifold_vertex_count(manifold), out->triangles = mus_manifold_triangle_count(manifold);
    out->cuts = mus_manifold_cut_count(manifold);
    mus_mesh_view view;
    mus_mesh_view_init(&view, sizeof view);
    view.name = "manifold";
    view.vertex_count = out->vertices, view.triangle_count = out->triangles;
    view.positions = mus_manifold_vertices(manifold), view.triangles = mus_manifold_triangles(manifold);
    bool good = mus_mesh_write_obj(context, path, 1, &view) == MUS_OK && ruler_read(path, &mesh) &&
                closed_check(&mesh, &out->file) && (!girths || measure(body, path, out));
    ruler_free(&mesh);
    mus_manifold_destroy(manifold);
    return good;
}
