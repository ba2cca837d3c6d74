/*
 * surface.c: writes the skin of a body, or its closed surface, as OBJ and glTF.
 */
#include "surface.h"

#include <string.h>

#include "commands.h"


static bool surface_asked(const surface_files *files)
{
    return files->obj != NULL || files->glb != NULL || files->png != NULL || files->turn > 0.0;
}


bool surface_check(const surface_files *files)
{
    if (files->manifold && !surface_asked(files))
        return complain(EXIT_INPUT, "body", "--manifold needs --obj, --glb or a picture") == EXIT_DONE;
    if ((files->turn > 0.0) != (files->frames != NULL))
        return complain(EXIT_INPUT, "body", "--turn N and --frames DIR go together") == EXIT_DONE;
    if (files->spacing > 0.0 && !files->manifold)
        return complain(EXIT_INPUT, "body", "--spacing needs --manifold") == EXIT_DONE;
    return true;
}


/* Draws the picture and those of a turn. Returns an exit code. */
static int surface_draw(const scene *s, const surface_files *files, const mus_mesh_view *view)
{
    static const double skin[3] = RENDER_SKIN;
    garment bare = {.view = {*view}};
    memcpy(bare.view[0].colour, skin, sizeof skin);
    int code = EXIT_DONE;
    if (files->png != NULL) code = picture_write(s, &files->look, &bare, files->png);
    if (code == EXIT_DONE && files->turn > 0.0)
        code = picture_turn(s, &files->look, &bare, (int32_t)files->turn, files->frames);
    return code;
}


int surface_write(scene *s, const surface_files *files, const mus_body *body)
{
    mus_mesh_view view;
    int code = EXIT_DONE;
    mus_manifold *manifold = NULL;
    mus_status status = MUS_OK;
    if (!surface_asked(files)) return EXIT_DONE;
    code = look_check(s, &files->look);
    if (code != EXIT_DONE) return code;
    mus_mesh_view_init(&view, sizeof view);
    view.name = "body";
    view.vertex_count = mus_body_vertex_count(body), view.triangle_count = mus_body_triangle_count(body);
    view.positions = mus_body_vertices(body), view.normals = mus_body_normals(body);
    view.triangles = mus_body_triangles(body);
    if (files->manifold) {
        mus_manifold_def def;
        mus_manifold_def_init(&def, sizeof def);
        if (files->spacing > 0.0) def.spacing = 1e-3 * files->spacing;
        status = mus_manifold_create(body, &def, &manifold);
        if (status != MUS_OK) return scene_fail(s, status);
        view.vertex_count = mus_manifold_vertex_count(manifold);
        view.triangle_count = mus_manifold_triangle_count(manifold);
        view.positions = mus_manifold_vertices(manifold), view.normals = mus_manifold_normals(manifold);
        view.triangles = mus_manifold_triangles(manifold);
    }
    if (files->obj != NULL) status = mus_mesh_write_obj(s->context, files->obj, 1, &view);
    if (status == MUS_OK && files->glb != NULL) status = mus_mesh_write_glb(s->context, files->glb, 1, &view);
    if (status != MUS_OK) code = scene_fail_output(s, status);
    else code = surface_draw(s, files, &view);
    mus_manifold_destroy(manifold);
    return code;
}
