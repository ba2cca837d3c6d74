/*
 * mesh_file.c: the calls that write meshes: check what the caller gave, divide it into parts, call the writer of the
 * form (obj_write.c, glb_write.c, usda_write.c, ply_write.c), and give its bytes to the file or the caller.
 */
#include <string.h>

#include "exchange/file_read.h"
#include "meshfile/mesh_check.h"
#include "meshfile/mesh_file.h"


void mus_mesh_file_init(mus_mesh_file *file, size_t size)
{
    if (file == NULL || size < sizeof file->size) return;
    memset(file, 0, size);
    file->size = size;
}


static mus_status file_check(mus_context *context, const mus_mesh_file *file, const char *what)
{
    if (file == NULL) return mus__file_fail(context, MUS_ERR_ARG, "%s: file is NULL", what);
    if (file->size != sizeof *file)
        return mus__file_fail(context, MUS_ERR_VERSION, "%s: size %zu, this library knows %zu; use mus_mesh_file_init",
                              what, file->size, sizeof *file);
    if (file->form < MUS_MESH_OBJ || file->form > MUS_MESH_PC2)
        return mus__file_fail(context, MUS_ERR_ARG, "%s: form %d, expected MUS_MESH_OBJ to MUS_MESH_PC2", what,
                              (int)file->form);
    mus_status status = mus__mesh_check(context, file->count, file->meshes);
    if (status == MUS_OK && (file->keys != 0 || file->times != NULL || file->motion != NULL))
        status = mus__mesh_check_motion(context, file->count, file->meshes, file->keys, file->times, file->motion);
    if (status != MUS_OK || file->form != MUS_MESH_PC2) return status;
    if (file->count != 1 || file->keys < 1 || file->motion[0].positions == NULL)
        return mus__file_fail(context, MUS_ERR_ARG,
                              "%s: a point cache has one mesh that moves; there are %d meshes and %d keys", what,
                              (int)file->count, (int)file->keys);
    return MUS_OK;
}


/* write the materials of the OBJ `path` beside it; `name` (bytes) gets the name of their file without folders */
static mus_status file_materials(const mus__mesh_set *set, const char *path, char *name, size_t bytes)
{
    const char *base = strrchr(path, '/') != NULL ? strrchr(path, '/') + 1 : path;
    const size_t n = strlen(path), end = n > 4 && strcmp(path + n - 4, ".obj") == 0 ? n - 4 : n;
    const size_t folders = (size_t)(base - path);
    mus_status status = MUS_ERR_MEMORY;
    mus__sink place, materials;
    mus__sink_init(&place, set->context);
    mus__sink_init(&materials, set->context);
    mus__sink_print(&place, "%.*s.mtl%c", (int)end, path, '\0');
    if (place.status == MUS_OK) {
        strncpy(name, place.bytes + folders, bytes - 1);
        name[bytes - 1] = '\0';
        mus__mtl_put(&materials, set);
        status = mus__sink_give(&materials, &(mus__target){place.bytes, NULL, NULL});
    }
    mus__sink_free(&materials);
    mus__sink_free(&place);
    return status;
}


/* true when a mesh has a material with a name, or panels */
static bool file_has_materials(const mus__mesh_set *set)
{
    for (int32_t i = 0; i < set->n; i++)
        if (set->mesh[i].material != NULL || set->mesh[i].cloth != NULL) return true;
    return false;
}


static mus_status file_put(mus__sink *sink, const mus__mesh_set *set, int32_t form, const char *path)
{
    char library[256];
    mus_status status = MUS_OK;
    const bool beside = form == MUS_MESH_OBJ && path != NULL && strcmp(path, "-") != 0 && file_has_materials(set);
    if (beside) status = file_materials(set, path, library, sizeof library);
    if (status != MUS_OK) return status;
    switch (form) {
    case MUS_MESH_OBJ: mus__obj_put(sink, set, beside ? library : NULL); break;
    case MUS_MESH_GLB: return mus__glb_put(sink, set);
    case MUS_MESH_USDA: mus__usda_put(sink, set); break;
    case MUS_MESH_PLY: mus__ply_put(sink, set); break;
    default: mus__pc2_put(sink, set); break;
    }
    return sink->status;
}


static mus_status file_write(mus_context *context, const mus__target *target, const mus_mesh_file *file,
                             const char *what)
{
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK) status = file_check(context, file, what);
    if (status != MUS_OK) return status;
    mus__locale locale;
    status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;

    mus__sink sink;
    mus__mesh_set set;
    mus__sink_init(&sink, context);
    status = mus__mesh_set_make(context, file, &set);
    if (status == MUS_OK) status = file_put(&sink, &set, file->form, target->path);
    if (status == MUS_OK) status = mus__sink_give(&sink, target);
    mus__mesh_set_free(&set);
    mus__sink_free(&sink);
    mus__locale_leave(&locale);
    return status;
}


/* write meshes without cloths; keys is 0 for meshes that stand still */
static mus_status file_plain(mus_context *context, const mus__target *target, const char *what, int32_t form, int32_t n,
                             const mus_mesh_view *meshes)
{
    mus_mesh_file file = {.size = sizeof file, .form = form, .count = n, .meshes = meshes};
    return file_write(context, target, &file, what);
}


mus_status mus_mesh_write(mus_context *context, const char *path, const mus_mesh_file *file)
{
    return file_write(context, &(mus__target){path, NULL, NULL}, file, "mus_mesh_write");
}


mus_status mus_mesh_write_bytes(mus_context *context, const mus_mesh_file *file, char **bytes, size_t *size)
{
    return file_write(context, &(mus__target){NULL, bytes, size}, file, "mus_mesh_write_bytes");
}


mus_status mus_mesh_write_obj(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes)
{
    return file_plain(context, &(mus__target){path, NULL, NULL}, "mus_mesh_write_obj", MUS_MESH_OBJ, n, meshes);
}


mus_status mus_mesh_write_obj_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes,
                                    size_t *size)
{
    return file_plain(context, &(mus__target){NULL, bytes, size}, "mus_mesh_write_obj_bytes", MUS_MESH_OBJ, n, meshes);
}


mus_status mus_mesh_write_glb(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes)
{
    return file_plain(context, &(mus__target){path, NULL, NULL}, "mus_mesh_write_glb", MUS_MESH_GLB, n, meshes);
}


mus_status mus_mesh_write_glb_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes,
                                    size_t *size)
{
    return file_plain(context, &(mus__target){NULL, bytes, size}, "mus_mesh_write_glb_bytes", MUS_MESH_GLB, n, meshes);
}


/* write meshes in motion as glTF; mus__mesh_check_motion() refuses keys below 1 */
static mus_status file_motion(mus_context *context, const mus__target *target, const mus_mesh_file *file,
                              const char *what)
{
    if (context == NULL) return MUS_ERR_ARG;
    if (file->keys < 1 || file->times == NULL || file->motion == NULL) {
        mus_status status = mus__target_check(context, target, what);
        if (status == MUS_OK) status = mus__mesh_check(context, file->count, file->meshes);
        return status == MUS_OK ? mus__mesh_check_motion(context, file->count, file->meshes, file->keys, file->times,
                                                         file->motion) : status;
    }
    return file_write(context, target, file, what);
}


mus_status mus_mesh_write_glb_motion(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes,
                                     int32_t keys, const double *times, const mus_mesh_motion *motion)
{
    const mus_mesh_file file = {.size = sizeof file, .form = MUS_MESH_GLB, .count = n, .keys = keys, .meshes = meshes,
                                .times = times, .motion = motion};
    return file_motion(context, &(mus__target){path, NULL, NULL}, &file, "mus_mesh_write_glb_motion");
}


mus_status mus_mesh_write_glb_motion_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, int32_t keys,
                                           const double *times, const mus_mesh_motion *motion, char **bytes,
                                           size_t *size)
{
    const mus_mesh_file file = {.size = sizeof file, .form = MUS_MESH_GLB, .count = n, .keys = keys, .meshes = meshes,
                                .times = times, .motion = motion};
    return file_motion(context, &(mus__target){NULL, bytes, size}, &file, "mus_mesh_write_glb_motion_bytes");
}
