/*
 * picture.c: draws a dressed body: makes the renderer's scene from the library's arrays.
 */
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PIXELS_WIDE 1800
#define PIXELS_HIGH 1200

/* linear RGB: unbleached linen */
static const double dummy_colour[3] = {0.62, 0.57, 0.51};
const double palette[PALETTE][3] = {{0.13, 0.24, 0.42}, {0.42, 0.12, 0.13}, {0.14, 0.30, 0.20}, {0.50, 0.36, 0.12},
                                    {0.28, 0.16, 0.34}, {0.10, 0.30, 0.36}, {0.46, 0.24, 0.16}, {0.20, 0.21, 0.24}};

/* colours in which a fabric is mostly sold, linear RGB; a fabric that is not here has the first of the palette */
static const struct {
    const char *fabric; /* also the beginning of its name: denim_b */
    double colour[3];
} dyed[] = {{"denim", {0.040, 0.070, 0.145}},     {"shirting", {0.520, 0.620, 0.740}},
            {"tropical", {0.050, 0.055, 0.075}},  {"wool", {0.105, 0.100, 0.100}},
            {"polyester", {0.270, 0.050, 0.080}}, {"satin", {0.520, 0.380, 0.240}},
            {"pc_twill", {0.330, 0.270, 0.160}}};


int look_check(const scene *s, const look *l)
{
    render_error error;
    double colour[3];
    int32_t width, height;
    render_camera camera;
    for (int32_t i = 0; i < l->colours.count; i++)
        if (render_colour_parse(l->colours.at[i], colour, &error) != 0)
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


/* The colour of garment `index`, from inside to outside: asked for, else of the fabric for the first, else of the
 * palette. */
static void index_colour(const look *l, int32_t index, double *out)
{
    render_error error;
    memcpy(out, palette[index % PALETTE], sizeof palette[0]);
    for (size_t i = 0; index == 0 && l->fabric != NULL && i < sizeof dyed / sizeof dyed[0]; i++)
        if (strncmp(l->fabric, dyed[i].fabric, strlen(dyed[i].fabric)) == 0)
            memcpy(out, dyed[i].colour, sizeof palette[0]);
    if (index < l->colours.count) render_colour_parse(l->colours.at[index], out, &error);
}


/* The garment of each panel, numbered from inside to outside: what is sewn together is one garment, and has the place
 * of its innermost panel. A collar lies a layer above the coat that it is sewn to. Returns the number of the outermost.
 */
static int32_t garment_numbers(const mus_pattern *pattern, int32_t panels, int32_t *number)
{
    int32_t rank[MUS_LAYERS_MOST] = {0}, most = 0;
    for (int32_t p = 0; p < panels; p++) number[p] = mus_pattern_layer(pattern, p);
    for (bool more = true; more;) {
        more = false;
        for (int32_t k = 0; k < mus_pattern_seam_count(pattern); k++) {
            mus_seam_def seam;
            mus_seam_def_init(&seam, sizeof seam);
            if (mus_pattern_seam(pattern, k, &seam) != MUS_OK) continue;
            int32_t *a = &number[mus_pattern_edge_panel(pattern, seam.edge_a)];
            int32_t *b = &number[mus_pattern_edge_panel(pattern, seam.edge_b)];
            more = more || *a != *b;
            *a = *b = *a < *b ? *a : *b;
        }
    }
    for (int32_t p = 0; p < panels; p++) rank[number[p]] = 1;
    for (int32_t i = 0, next = 0; i < MUS_LAYERS_MOST; i++)
        if (rank[i] != 0) most = next, rank[i] = next++;
    for (int32_t p = 0; p < panels; p++) number[p] = rank[number[p]];
    return most;
}


/* Colours of the nodes where garments are worn over one another. Returns an exit code. */
static int garment_colours(const scene *s, const look *l, garment *g)
{
    const int32_t n = g->view[1].vertex_count, panels = s->pattern != NULL ? mus_pattern_panel_count(s->pattern) : 0;
    double colour[MUS_LAYERS_MOST][3];
    index_colour(l, 0, g->view[1].colour);
    int32_t *number = malloc((size_t)panels * sizeof *number + 1);
    const int32_t most = number != NULL ? garment_numbers(s->pattern, panels, number) : 0;
    if (most > 0) g->colours = malloc((size_t)n * 3 * sizeof *g->colours + 1);
    for (int32_t i = 0; i <= most; i++) index_colour(l, i, colour[i]);
    for (int32_t i = 0; i < n && g->colours != NULL; i++)
        memcpy(g->colours + 3 * (ptrdiff_t)i, colour[g->panels[i] < panels ? number[g->panels[i]] : 0],
               sizeof colour[0]);
    const bool lacks = number == NULL || (most > 0 && g->colours == NULL);
    free(number);
    return lacks ? complain(EXIT_FAILED, s->command, "no memory for the garments' colours") : EXIT_DONE;
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
    out->panels = mus_cloth_node_panels(cloth);
    if (s->pattern != NULL && !stitches_make(s->pattern, cloth, view->positions, out->normals, &out->sewn))
        return complain(EXIT_FAILED, s->command, "no memory for the garment's seams");
    view->colour[3] = 1.0;
    return garment_colours(s, l, out);
}


void garment_free(garment *g)
{
    free(g->normals);
    free(g->colours);
    stitches_free(&g->sewn);
    memset(g, 0, sizeof *g);
}


/* Copies the name of a fabric: a name of the table, or that of a file without folders and ending. */
static void fabric_base(const char *fabric, char *out, size_t bytes)
{
    const char *base = fabric != NULL ? fabric : "jersey";
    if (strrchr(base, '/') != NULL) base = strrchr(base, '/') + 1;
    snprintf(out, bytes, "%.*s", (int)strcspn(base, "."), base);
}


mus_status garment_write(const scene *s, const garment *g, const mus_cloth *cloth, const char *fabric,
                         const garment_motion *moves, const char *const *files)
{
    char name[128];
    fabric_base(fabric, name, sizeof name);
    const mus_cloth *const cloths[2] = {NULL, cloth};
    const char *const materials[2] = {"skin", name};
    mus_status status = MUS_OK;
    for (int32_t form = 0; form < MESH_FORMS && status == MUS_OK; form++) {
        const bool moving = form == MUS_MESH_GLB || form == MUS_MESH_USDA || form == MUS_MESH_PC2;
        if (files[form] == NULL || (moves != NULL && !moving) || (moves == NULL && form == MUS_MESH_PC2)) continue;
        const int32_t first = g->view[0].vertex_count == 0 || form == MUS_MESH_PC2;
        mus_mesh_file file;
        mus_mesh_file_init(&file, sizeof file);
        file.form = form;
        file.count = 2 - first;
        file.meshes = g->view + first, file.cloths = cloths + first, file.materials = materials + first;
        if (moves != NULL) file.keys = moves->keys, file.times = moves->times, file.motion = moves->move + first;
        status = mus_mesh_write(s->context, files[form], &file);
    }
    return status;
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


/* Draws all views, turned by `turn` degrees, and writes the file. Returns 0, or -1 with the error. */
static int draw(film *f, const render_camera *view, int32_t views, double turn, const char *path, render_error *error)
{
    const look *l = f->l;
    int32_t width = PIXELS_WIDE, height = PIXELS_HIGH;
    if (l->pixels != NULL && render_size_parse(l->pixels, &width, &height, error) != 0) return -1;
    render_camera cameras[32];
    for (int32_t i = 0; i < views; i++) cameras[i] = view[i], cameras[i].yaw += turn;
    unsigned char *rgba = malloc((size_t)width * (size_t)height * 4);
    int result = -1;
    if (rgba == NULL) {
        strcpy(error->text, "no memory for the picture");
    } else if (render_picture(f->r, views, cameras, width, height, rgba, error) == 0) {
        if (l->map != NULL) fit_map_legend(l->map, width, height, rgba);
        result = render_png_write(path, width, height, rgba, error) == 0 ? 0 : -1;
    }
    free(rgba);
    return result;
}


/* The views of the options to `out` (32), or the default ones. Returns their number, or -1 with the error. */
static int32_t views_of(const look *l, render_camera *out, render_error *error)
{
    memcpy(out, render_default_views, sizeof render_default_views);
    for (int32_t i = 0; i < l->views.count; i++)
        if (render_view_parse(l->views.at[i], &out[i], error) != 0) return -1;
    return l->views.count > 0 ? l->views.count : RENDER_DEFAULT_VIEW_COUNT;
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


/* Loads the meshes of body, garment and buttons, those that have vertices; a map is drawn without seams.
 * Returns 0, or -1 with the error. */
static int load(film *f, const garment *g, render_error *error)
{
    render_mesh meshes[3];
    int32_t count = 0;
    if (g->view[0].vertex_count > 0) mesh_from_view(&g->view[0], RENDER_BODY, &meshes[count++]);
    if (g->view[1].vertex_count > 0) {
        mesh_from_view(&g->view[1], RENDER_CLOTH, &meshes[count]);
        meshes[count].colours = f->l->map != NULL ? f->l->map->colours : g->colours;
        if (f->l->map == NULL && g->sewn.count > 0) {
            meshes[count].panels = g->panels;
            meshes[count].line_count = g->sewn.count, meshes[count].lines = g->sewn.lines;
        }
        if (f->print.rgba != NULL) meshes[count].print = &f->print, meshes[count].print_width = f->l->repeat;
        count++;
    }
    if (f->l->map == NULL && g->sewn.buttons.vertex_count > 0) meshes[count++] = g->sewn.buttons;
    const render_scene dressed = {count, meshes, 1, f->box};
    return render_load(f->r, &dressed, error);
}


int film_shoot(film *f, const garment *g, const char *path)
{
    render_error error;
    render_camera views[32];
    const int32_t n = views_of(f->l, views, &error);
    if (n > 0 && load(f, g, &error) == 0 && draw(f, views, n, 0.0, path, &error) == 0) return EXIT_DONE;
    return complain(EXIT_FAILED, f->s->command, "%s", error.text);
}


int film_tile(film *f, const garment *g, int32_t width, int32_t height, unsigned char *rgba)
{
    static const render_camera front = {20.0, 4.0, 1.1, NAN};
    render_error error;
    if (load(f, g, &error) == 0 && render_draw(f->r, &front, width, height, rgba, &error) == 0) return EXIT_DONE;
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


int picture_turn(const scene *s, const look *l, const garment *g, int32_t count, const char *folder)
{
    film f;
    render_error error;
    render_camera views[32];
    char path[4096];
    int code = film_open(&f, s, l, NULL);
    const int32_t asked = views_of(l, views, &error), n = l->views.count > 0 ? asked : 1;
    if (code == EXIT_DONE && (asked < 0 || load(&f, g, &error) != 0))
        code = complain(EXIT_FAILED, s->command, "%s", error.text);
    for (int32_t k = 0; k < count && code == EXIT_DONE; k++) {
        snprintf(path, sizeof path, "%s/frame_%04d.png", folder, (int)k + 1);
        if (draw(&f, views, n, 360.0 * k / count, path, &error) != 0)
            code = complain(EXIT_FAILED, s->command, "%s", error.text);
    }
    film_close(&f);
    return code;
}
