/*
 * meshes.c: rows "mesh/...": bodies and cloth as OBJ and binary glTF, still and in motion, whole bytes; and OBJ read.
 */
#include "scene.h"

#include <stdlib.h>

#define KEYS 4

/* body and cloth of a scene that was placed and sewn, as two meshes */
static void views_of(same_run *run, const same_dressed *d, double *normals, mus_mesh_view *view)
{
    same_must(run, mus_drape_normals(d->drape, normals), "mus_drape_normals");
    for (int i = 0; i < 2; i++) mus_mesh_view_init(&view[i], sizeof view[i]);
    view[0].name = "body";
    view[0].vertex_count = mus_body_vertex_count(d->body);
    view[0].triangle_count = mus_body_triangle_count(d->body);
    view[0].positions = mus_body_vertices(d->body);
    view[0].normals = mus_body_normals(d->body);
    view[0].triangles = mus_body_triangles(d->body);
    view[1].name = "cloth";
    view[1].vertex_count = mus_cloth_node_count(d->cloth);
    view[1].triangle_count = mus_cloth_triangle_count(d->cloth);
    view[1].positions = mus_drape_positions(d->drape);
    view[1].normals = normals;
    view[1].texcoords = mus_cloth_rest(d->cloth);
    view[1].triangles = mus_cloth_triangles(d->cloth);
    view[1].two_sided = 1;
}


/* the same meshes with cloth that sinks from key to key */
static void write_motion(same_run *run, const mus_mesh_view *view)
{
    const int32_t numbers = 3 * view[1].vertex_count;
    const double times[KEYS] = {0.0, 0.1, 0.25, 0.4};
    double *positions = malloc(sizeof *positions * KEYS * (size_t)numbers);
    mus_mesh_motion motion[2];
    if (positions == NULL) same_must(run, MUS_ERR_MEMORY, "write_motion");
    for (int i = 0; i < 2; i++) mus_mesh_motion_init(&motion[i], sizeof motion[i]);
    for (int32_t k = 0; k < KEYS; k++)
        for (int32_t i = 0; i < numbers; i++)
            positions[(ptrdiff_t)k * numbers + i] = view[1].positions[i] - (i % 3 == 1 ? 0.01 * k : 0.0);
    motion[1].positions = positions;
    same_must(run, mus_mesh_write_glb_motion(run->context, "motion.glb", 2, view, KEYS, times, motion), "motion.glb");
    same_file(run, "motion.glb");
    free(positions);
}


static void make_written(same_run *run, const void *what, int32_t index)
{
    (void)index;
    const same_scene scene = {NULL, what, "W40", 40, 0, NULL};
    const same_dressed d = same_place(run, &scene);
    mus_mesh_view view[2];
    mus_mesh *mesh = NULL;
    double *normals = malloc(sizeof *normals * 3 * (size_t)mus_cloth_node_count(d.cloth));
    if (normals == NULL) same_must(run, MUS_ERR_MEMORY, "make_written");
    same_status(run, mus_drape_sew(d.drape, NULL, NULL));
    views_of(run, &d, normals, view);
    same_must(run, mus_mesh_write_obj(run->context, "both.obj", 2, view), "both.obj");
    same_file(run, "both.obj");
    same_must(run, mus_mesh_write_glb(run->context, "both.glb", 2, view), "both.glb");
    same_file(run, "both.glb");
    write_motion(run, view);
    same_must(run, mus_mesh_read_obj(run->context, "both.obj", &mesh), "both.obj");
    same_reals(run, mus_mesh_vertices(mesh), 3 * (int64_t)mus_mesh_vertex_count(mesh));
    same_ints(run, mus_mesh_triangles(mesh), 3 * (int64_t)mus_mesh_triangle_count(mesh));
    free(normals);
}


/* an OBJ of the real data */
static void make_read(same_run *run, const void *what, int32_t index)
{
    (void)index;
    mus_mesh *mesh = NULL;
    same_must(run, mus_mesh_read_obj(run->context, same_data(run, same_body_file(what, ".obj")), &mesh), what);
    same_reals(run, mus_mesh_vertices(mesh), 3 * (int64_t)mus_mesh_vertex_count(mesh));
    same_ints(run, mus_mesh_triangles(mesh), 3 * (int64_t)mus_mesh_triangle_count(mesh));
}


void same_meshes(same_list *list)
{
    static const char *const worn[] = {"tshirt", "kilt"}, *const files[] = {"mean_all", "m_smpl_average_A40"};
    for (int i = 0; i < 2; i++) {
        same_add(list, make_written, "mesh/written-%s", worn[i])->what = worn[i];
        same_row *row = same_add(list, make_read, "mesh/read-%s", files[i]);
        row->what = files[i], row->data = true;
    }
}
