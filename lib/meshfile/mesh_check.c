/*
 * mesh_check.c: the defaults of a mesh view, and its check before a mesh file is written.
 *
 * Both mesh writers use the caller's arrays without a copy, so sizes, numbers and indices are checked once, before.
 */
#include <math.h>
#include <string.h>

#include "file/message.h"
#include "meshfile/mesh_check.h"

#define MESH_LIMIT 1e30 /* [m] largest number of a mesh; chosen: a float can hold it, and no garment comes near it */


void mus_mesh_view_init(mus_mesh_view *view, size_t size)
{
    if (view == NULL || size < sizeof view->size) return;
    mus_mesh_view own = {.size = size, .colour = {0.8, 0.8, 0.8, 1.0}};
    memset(view, 0, size);
    memcpy(view, &own, size < sizeof own ? size : sizeof own);
}


void mus_mesh_motion_init(mus_mesh_motion *motion, size_t size)
{
    if (motion == NULL || size < sizeof motion->size) return;
    memset(motion, 0, size);
    motion->size = size;
}


static mus_status mesh_finite(mus_context *context, int32_t mesh, const char *what, int64_t n, int32_t width,
                              const double *values)
{
    if (values == NULL) return MUS_OK;
    for (size_t i = 0; i < (size_t)n * (size_t)width; i++)
        if (!(fabs(values[i]) < MESH_LIMIT))
            return mus__file_fail(context, MUS_ERR_ARG,
                                  "mesh %d: the %s of vertex %zu is %g, expected a finite number", (int)mesh, what,
                                  i / (size_t)width, values[i]);
    return MUS_OK;
}


static mus_status mesh_check_one(mus_context *context, int32_t i, const mus_mesh_view *view)
{
    if (view->size != sizeof *view)
        return mus__file_fail(context, MUS_ERR_VERSION,
                              "mesh %d: size %zu, this library knows %zu; use mus_mesh_view_init", (int)i,
                              view->size, sizeof *view);
    if (view->vertex_count < 1 || view->triangle_count < 1 || view->positions == NULL || view->triangles == NULL)
        return mus__file_fail(
            context, MUS_ERR_ARG,
            "mesh %d: %d vertices and %d triangles, expected positions and triangles of 1 or more", (int)i,
            (int)view->vertex_count, (int)view->triangle_count);
    for (int32_t k = 0; k < 4; k++)
        if (!(view->colour[k] >= 0.0 && view->colour[k] <= 1.0))
            return mus__file_fail(context, MUS_ERR_ARG, "mesh %d: colour %d is %g, expected 0 to 1", (int)i, (int)k,
                                  view->colour[k]);
    mus_status status = mesh_finite(context, i, "position", view->vertex_count, 3, view->positions);
    if (status == MUS_OK) status = mesh_finite(context, i, "normal", view->vertex_count, 3, view->normals);
    if (status == MUS_OK) status = mesh_finite(context, i, "texture place", view->vertex_count, 2, view->texcoords);
    if (status != MUS_OK) return status;
    for (size_t k = 0; k < 3 * (size_t)view->triangle_count; k++)
        if (view->triangles[k] < 0 || view->triangles[k] >= view->vertex_count)
            return mus__file_fail(context, MUS_ERR_ARG, "mesh %d: triangle %zu has vertex %d of %d", (int)i, k / 3,
                                  (int)view->triangles[k], (int)view->vertex_count);
    return MUS_OK;
}


mus_status mus__mesh_check(mus_context *context, int32_t n, const mus_mesh_view *meshes)
{
    if (n < 1 || meshes == NULL)
        return mus__file_fail(context, MUS_ERR_ARG, "meshes to write: %d, expected 1 or more", (int)n);
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < n && status == MUS_OK; i++) status = mesh_check_one(context, i, &meshes[i]);
    return status;
}


mus_status mus__mesh_check_motion(mus_context *context, int32_t n, const mus_mesh_view *meshes, int32_t keys,
                                  const double *times, const mus_mesh_motion *motion)
{
    if (keys < 1 || keys > MUS__MESH_KEYS || times == NULL || motion == NULL)
        return mus__file_fail(context, MUS_ERR_ARG, "meshes in motion: %d keys, expected 1 to %d, times and motion",
                              (int)keys, MUS__MESH_KEYS);
    for (int32_t k = 0; k < keys; k++)
        if (!(times[k] >= 0.0 && times[k] < 1e6) || (k > 0 && !((float)times[k] > (float)times[k - 1])))
            return mus__file_fail(context, MUS_ERR_ARG,
                                  "meshes in motion: time %d is %g s, expected to ascend from 0 on, below 1e6 s",
                                  (int)k, times[k]);
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        if (motion[i].size != sizeof *motion)
            return mus__file_fail(context, MUS_ERR_VERSION,
                                  "motion %d: size %zu, this library knows %zu; use mus_mesh_motion_init", (int)i,
                                  motion[i].size, sizeof *motion);
        if (motion[i].normals != NULL && (motion[i].positions == NULL || meshes[i].normals == NULL))
            return mus__file_fail(context, MUS_ERR_ARG,
                                  "motion %d: normals without moving positions, or of a mesh without normals",
                                  (int)i);
        const int64_t count = (int64_t)keys * meshes[i].vertex_count;
        status = mesh_finite(context, i, "moved position", count, 3, motion[i].positions);
        if (status == MUS_OK) status = mesh_finite(context, i, "moved normal", count, 3, motion[i].normals);
    }
    return status;
}
