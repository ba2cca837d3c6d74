/*
 * scan.c: a body from a triangle mesh, as of a scan, measured.
 *
 *     build/examples/scan [SCAN.obj]
 *
 * Without a file the program makes a mesh itself: the surface of a body of women's 40, written as OBJ in centimetres
 * and read again. The library finds unit, upright axis, front, limbs and girths.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "scan: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


/* the surface of a body of size W40, in centimetres, as the file `path` */
static void make_mesh(const char *path)
{
    mus_tape *tape;
    mus_body *body;
    mus_mesh_view view;

    must(mus_tape_create(context, &tape));
    must(mus_tape_set_size(tape, "W40"));
    must(mus_body_create(context, tape, NULL, &body));
    const int32_t n = 3 * mus_body_vertex_count(body);
    double *centimetres = malloc((size_t)n * sizeof *centimetres);
    if (centimetres == NULL) exit(1);
    for (int32_t i = 0; i < n; i++) centimetres[i] = 100.0 * mus_body_vertices(body)[i];
    mus_mesh_view_init(&view, sizeof view);
    view.name = "person";
    view.vertex_count = mus_body_vertex_count(body);
    view.triangle_count = mus_body_triangle_count(body);
    view.positions = centimetres;
    view.triangles = mus_body_triangles(body);
    must(mus_mesh_write_obj(context, path, 1, &view));
    printf("tape: bust %.1f cm, waist %.1f cm, hip %.1f cm\n", 100 * mus_body_made(body, MUS_MEASURE_BUST),
           100 * mus_body_made(body, MUS_MEASURE_WAIST), 100 * mus_body_made(body, MUS_MEASURE_HIP));
    free(centimetres);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
}


int main(int argc, char **argv)
{
    const char *path = argc > 1 ? argv[1] : "scan-of-w40.obj";
    mus_mesh *mesh;
    mus_scan_report report;
    mus_body *body;

    must(mus_context_create(NULL, &context));
    if (argc < 2) make_mesh(path);
    must(mus_mesh_read_obj(context, path, &mesh));

    mus_scan_report_init(&report, sizeof report);
    must(mus_body_create_scan(context, mus_mesh_vertex_count(mesh), mus_mesh_vertices(mesh),
                              mus_mesh_triangle_count(mesh), mus_mesh_triangles(mesh), NULL, &report, &body));
    printf("scan: bust %.1f cm, waist %.1f cm, hip %.1f cm\n", 100 * report.girth[MUS_SCAN_BUST],
           100 * report.girth[MUS_SCAN_WAIST], 100 * report.girth[MUS_SCAN_HIP]);
    printf("one unit of the mesh is %.3f m; stature %.2f m; %d limbs\n", report.unit, report.stature,
           (int)mus_body_limb_count(body));
    printf("half of the torso's vertices lie within %.1f mm of the body\n",
           1e3 * report.mesh_to_body[MUS_SCAN_TORSO][0]);

    mus_body_destroy(body);
    mus_mesh_destroy(mesh);
    mus_context_destroy(context);
    if (argc < 2) remove(path);
    return 0;
}
