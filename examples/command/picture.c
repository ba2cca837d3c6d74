/*
 * picture.c: draws a dressed body: makes the renderer's scene from the library's arrays.
 */
#include "picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PIXELS_WIDE 1800
#define PIXELS_HIGH 1200

/* default colours, linear RGB: body (unbleached linen) and garment (mid blue) */
static const double dummy_colour[3] = {0.62, 0.57, 0.51};
static const double cloth_colour[3] = {0.13, 0.24, 0.42};


int look_check(const scene *s, const look *l)
{
    render_error error;
    double colour[3];
    int32_t width, height;
    render_camera camera;
    if (l->colour != NULL && render_colour_parse(l->colour, colour, &error) != 0)
        return complain(EXIT_INPUT, s->command, "--colour: %s", error.text);
    if (l->pixels != NULL && render_size_parse(l->pixels, &width, &height, &error) != 0)
        return complain(EXIT_INPUT, s->command, "--pixels: %s", error.text);
    for (int32_t i = 0; i < l->views.count; i++)
        if (render_view_parse(l->views.at[i], &camera, &error) != 0)
            return complain(EXIT_INPUT, s->command, "--view: %s", error.text);
    render_image print = {0};
    if (l->texture != NULL && render_png_read(l->texture, &print, &error) != 0)
        return complain(EXIT_INPUT, s->command, "--texture: %s", error.text);
    render_image_free(&print);
    return EXIT_DONE;
}


int garment_make(const scene *s, const look *l, const mus_body *body, const mus_cloth *cloth, const mus_drape *drape,
                 garment *out)
{
    memset(out, 0, sizeof *out);
    const int32_t n = mus_cloth_node_count(cloth);
    out->normals = malloc((size_t)n * 3 * sizeof *out->normals + 1);
    if (out->normals == NULL) return complain(EXIT_FAILED, s->command, "no memory for the garment's normals");
    const mus_status status = mus_drape_normals(drape, out->normals);
    if (status != MUS_OK) return scene_fail(s, status);

    mus_mesh_view *view = &out->view[0];
    mus_mesh_view_init(view, sizeof *view);
    view->name = "body";
    if (body != NULL) {
        view->vertex_count = mus_body_vertex_count(body);
        view->triangle_count = mus_body_triangle_count(body);
        view->positions = mus_body_vertices(body);
        view->normals = mus_body_normals(body);
        view->triangles = mus_body_triangles(body);
    }
    memcpy(view->colour, dummy_colour, sizeof dummy_colour);
    view->colour[3] = 1.0;

    view = &out->view[1];
    mus_mesh_view_init(view, sizeof *view);
    view->name = "garment";
    view->vertex_count = n;
    view->triangle_count = mus_cloth_triangle_count(cloth);
    view->positions = mus_drape_positions(drape);
    view->normals = out->normals;
    view->texcoords = mus_cloth_rest(cloth);
    view->triangles = mus_cloth_triangles(cloth);
    view->two_sided = 1;
    memcpy(view->colour, cloth_colour, sizeof cloth_colour);
    view->colour[3] = 1.0;
    render_error error;
    if (l->colour != NULL && render_colour_parse(l->colour, view->colour, &error) != 0)
        return complain(EXIT_INPUT, s->command, "--colour: %s", error.text);
    return EXIT_DONE;
}


void garment_free(garment *g)
{
    free(g->normals);
    memset(g, 0, sizeof *g);
}


static void mesh_from_view(const mus_mesh_view *view, int32_t kind, render_mesh *mesh)
{
    memset(mesh, 0, sizeof *mesh);
    mesh->kind = kind;
    mesh->vertex_count = view->vertex_count;
    mesh->triangle_count = view->triangle_count;
    mesh->positions = view->positions;
    mesh->normals = view->normals;
    mesh->texcoords = view->texcoords;
    mesh->triangles = view->triangles;
    memcpy(mesh->colour, view->colour, sizeof mesh->colour);
}


/* Loads the scene, draws all views and writes the file. Returns an exit code. */
static int draw(film *f, const render_mesh *meshes, int32_t count, const char *path, render_error *error)
{
    const look *l = f->l;
    int32_t width = PIXELS_WIDE, height = PIXELS_HIGH;
    if (l->pixels != NULL && render_size_parse(l->pixels, &width, &height, error) != 0) return -1;
    render_camera cameras[32];
    memcpy(cameras, render_default_views, sizeof render_default_views);
    int32_t views = RENDER_DEFAULT_VIEW_COUNT;
    if (l->views.count > 0) views = l->views.count;
    for (int32_t i = 0; i < l->views.count; i++)
        if (render_view_parse(l->views.at[i], &cameras[i], error) != 0) return -1;

    const render_scene dressed = {count, meshes, 1, f->box};
    unsigned char *rgba = malloc((size_t)width * (size_t)height * 4);
    int result = -1;
    if (rgba == NULL) {
        strcpy(error->text, "no memory for the picture");
    } else if (render_load(f->r, &dressed, error) == 0 &&
               render_picture(f->r, views, cameras, width, height, rgba, error) == 0) {
        if (l->map != NULL) fit_map_legend(l->map, width, height, rgba);
        result = render_png_write(path, width, height, rgba, error) == 0 ? 0 : -1;
    }
    free(rgba);
    return result;
}


int film_open(film *f, const scene *s, const look *l, const double *box)
{
    memset(f, 0, sizeof *f);
    f->s = s, f->l = l, f->box = box;
    render_error error;
    int result = 0;
    if (l->texture != NULL) result = render_png_read(l->texture, &f->print, &error);
    if (result == 0) result = render_create(&f->r, &error);
    return result == 0 ? EXIT_DONE : complain(EXIT_FAILED, s->command, "%s", error.text);
}


int film_shoot(film *f, const garment *g, const char *path)
{
    render_mesh meshes[2];
    int32_t count = 0;
    if (g->view[0].vertex_count > 0) mesh_from_view(&g->view[0], RENDER_BODY, &meshes[count++]);
    mesh_from_view(&g->view[1], RENDER_CLOTH, &meshes[count++]);
    if (f->l->map != NULL) meshes[count - 1].colours = f->l->map->colours;
    if (f->print.rgba != NULL) {
        meshes[count - 1].print = &f->print;
        meshes[count - 1].print_width = f->l->repeat;
    }
    render_error error;
    if (draw(f, meshes, count, path, &error) == 0) return EXIT_DONE;
    return complain(EXIT_FAILED, f->s->command, "%s", error.text);
}


int film_tile(film *f, const garment *g, int32_t width, int32_t height, unsigned char *rgba)
{
    static const render_camera front = {20.0, 4.0, 1.1, NAN};
    render_mesh meshes[2];
    render_error error;
    int32_t count = 0;
    if (g->view[0].vertex_count > 0) mesh_from_view(&g->view[0], RENDER_BODY, &meshes[count++]);
    mesh_from_view(&g->view[1], RENDER_CLOTH, &meshes[count++]);
    const render_scene dressed = {count, meshes, 1, f->box};
    if (render_load(f->r, &dressed, &error) == 0 && render_draw(f->r, &front, width, height, rgba, &error) == 0)
        return EXIT_DONE;
    return complain(EXIT_FAILED, f->s->command, "%s", error.text);
}


void film_close(film *f)
{
    render_destroy(f->r);
    render_image_free(&f->print);
}


int picture_write(const scene *s, const look *l, const garment *g, const char *path)
{
    film f;
    int code = film_open(&f, s, l, NULL);
    if (code == EXIT_DONE) code = film_shoot(&f, g, path);
    film_close(&f);
    return code;
}
