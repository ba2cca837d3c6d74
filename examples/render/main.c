/*
 * main.c: muslin-render, meshes to a picture.
 *
 * Reads a body and garments from OBJ files and draws them into a PNG. Exit status: 0 the picture is written, 1 it
 * could not be drawn or written, 2 the request or a file in it is bad; one line on standard error says what and where.
 */
#include "parse.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GARMENTS_MAX 64
#define VIEWS_MAX 16

static const char usage[] =
    "usage: muslin-render [--body F.obj] [--garment F.obj]... [--colour C]... [--texture F.png]\n"
    "                     [--texture-width MM] [--view YAW,PITCH[,ZOOM]]... [--size WxH] -o OUT.png\n"
    "\n"
    "Draw a body and garments into a PNG, without a screen.\n"
    "\n"
    "  --body F.obj         mesh of the body, metres, Y up, front towards +Z\n"
    "  --garment F.obj      mesh of a garment; texture coordinates are metres in the panel\n"
    "  --colour C           #RRGGBB or a name (white, ecru, navy ...); the nth is of the nth garment,\n"
    "                       the last one also of those after it\n"
    "  --texture F.png      picture printed on all garments\n"
    "  --texture-width MM   width of one repeat of it, 100 if not given\n"
    "  --view Y,P,Z         yaw and pitch in degrees and zoom (1) of a view; may be given more than once,\n"
    "                       views stand side by side; without it: 0,5,1 and 40,8,1\n"
    "                       (a fourth number is the height of the middle of the picture in metres)\n"
    "  --size WxH           of the whole picture in pixels, 1500x1000 if not given\n"
    "  -o OUT.png           the picture; - is standard output\n"
    "  --help               print this\n";

/* what the command line asks for */
typedef struct main_request {
    const char *body;
    const char *garments[GARMENTS_MAX];
    int garment_count;
    double colours[GARMENTS_MAX][3];
    int colour_count;
    const char *texture;
    double texture_width; /* [m] */
    render_camera views[VIEWS_MAX];
    int view_count;
    int32_t width;
    int32_t height;
    const char *output;
} main_request;


/* one option with its value */
static int main_option(main_request *q, const char *name, const char *value, render_error *error)
{
    const char *rest;

    if (!strcmp(name, "--body")) {
        if (q->body) return render_fail(error, "--body is given twice");
        q->body = value;
    } else if (!strcmp(name, "--garment")) {
        if (q->garment_count == GARMENTS_MAX) return render_fail(error, "more than %d garments", GARMENTS_MAX);
        q->garments[q->garment_count++] = value;
    } else if (!strcmp(name, "--colour")) {
        if (q->colour_count == GARMENTS_MAX) return render_fail(error, "more than %d colours", GARMENTS_MAX);
        return render_colour_parse(value, q->colours[q->colour_count++], error);
    } else if (!strcmp(name, "--texture")) {
        q->texture = value;
    } else if (!strcmp(name, "--texture-width")) {
        rest = render_number_parse(value, &q->texture_width);
        if (!rest || *rest || !(q->texture_width >= 1.0 && q->texture_width <= 10000.0))
            return render_fail(error, "--texture-width \"%.40s\": expected 1 to 10000 millimetres", value);
        q->texture_width *= 0.001;
    } else if (!strcmp(name, "--view")) {
        if (q->view_count == VIEWS_MAX) return render_fail(error, "more than %d views", VIEWS_MAX);
        return render_view_parse(value, &q->views[q->view_count++], error);
    } else if (!strcmp(name, "--size")) {
        return render_size_parse(value, &q->width, &q->height, error);
    } else {
        q->output = value;
    }
    return 0;
}


static int main_options(main_request *q, int argc, char **argv, render_error *error)
{
    static const char *const names[] = {"--body", "--garment", "--colour", "--texture", "--texture-width",
                                        "--view", "--size",    "-o"};

    for (int i = 1; i < argc; i += 2) {
        int known = 0;
        for (size_t k = 0; k < sizeof names / sizeof *names; k++) known |= !strcmp(argv[i], names[k]);
        if (!known) return render_fail(error, "unknown option \"%.80s\" (--help lists them)", argv[i]);
        if (i + 1 == argc) return render_fail(error, "%s needs a value (--help)", argv[i]);
        if (main_option(q, argv[i], argv[i + 1], error)) return -1;
    }
    if (!q->output) return render_fail(error, "where to? -o OUT.png is missing (--help)");
    if (!q->body && !q->garment_count) return render_fail(error, "nothing to draw: --body or --garment is missing");
    return 0;
}


/* a file as a mesh of the scene; the arrays stay with `obj` */
static int main_mesh(const char *path, int kind, const double *colour, render_obj *obj, render_mesh *mesh,
                     render_error *error)
{
    if (render_obj_read(path, obj, error)) return -1;
    mesh->kind = kind;
    mesh->vertex_count = obj->vertex_count;
    mesh->triangle_count = obj->triangle_count;
    mesh->positions = obj->positions;
    mesh->normals = obj->normals;
    mesh->texcoords = obj->texcoords;
    mesh->triangles = obj->triangles;
    memcpy(mesh->colour, colour, sizeof mesh->colour);
    return 0;
}


/* all files of the request: objs and meshes have one entry a file, *count of them */
static int main_meshes(const main_request *q, const render_image *print, render_obj *objs, render_mesh *meshes,
                       int *count, render_error *error)
{
    static const double skin[3] = RENDER_SKIN, plain[3] = {0.80, 0.74, 0.62};

    if (q->body) {
        if (main_mesh(q->body, RENDER_BODY, skin, &objs[0], &meshes[0], error)) return -1;
        *count = 1;
    }
    for (int i = 0; i < q->garment_count; i++, (*count)++) {
        int colour = i < q->colour_count ? i : q->colour_count - 1;
        render_mesh *mesh = &meshes[*count];
        if (main_mesh(q->garments[i], RENDER_CLOTH, colour < 0 ? plain : q->colours[colour], &objs[*count], mesh,
                      error))
            return -1;
        if (q->texture && !mesh->texcoords)
            return render_fail(error, "%s: --texture needs texture coordinates at every corner", q->garments[i]);
        mesh->print = q->texture ? print : NULL;
        mesh->print_width = q->texture_width;
    }
    return 0;
}


/* 0 or 1 */
static int main_draw(const main_request *q, const render_scene *scene, render_error *error)
{
    unsigned char *rgba = malloc(4 * (size_t)q->width * (size_t)q->height);
    const render_camera *views = q->view_count ? q->views : render_default_views;
    int view_count = q->view_count ? q->view_count : RENDER_DEFAULT_VIEW_COUNT;
    render *r = NULL;
    int bad = 1;

    if (!rgba) render_fail(error, "out of memory for %d x %d pixels", (int)q->width, (int)q->height);
    else
        bad = render_create(&r, error) || render_load(r, scene, error) ||
              render_picture(r, view_count, views, q->width, q->height, rgba, error) ||
              render_png_write(q->output, q->width, q->height, rgba, error);
    render_destroy(r);
    free(rgba);
    return bad;
}


int main(int argc, char **argv)
{
    main_request q = {.texture_width = 0.1, .width = 1500, .height = 1000};
    render_obj objs[GARMENTS_MAX + 1] = {0};
    render_mesh meshes[GARMENTS_MAX + 1] = {0};
    render_scene scene = {.meshes = meshes, .floor = 1};
    render_image print = {0};
    render_error error = {""};
    int count = 0, rc = 2;

    for (int i = 1; i < argc; i++)
        if (!strcmp(argv[i], "--help")) {
            fputs(usage, stdout);
            return fflush(stdout) ? 1 : 0;
        }
    if (!main_options(&q, argc, argv, &error) && (!q.texture || !render_png_read(q.texture, &print, &error)) &&
        !main_meshes(&q, &print, objs, meshes, &count, &error)) {
        scene.mesh_count = count;
        rc = main_draw(&q, &scene, &error) ? 1 : 0;
    }

    for (int i = 0; i <= GARMENTS_MAX; i++) render_obj_free(&objs[i]);
    render_image_free(&print);
    if (rc) fprintf(stderr, "muslin-render: %s\n", error.text);
    return rc;
}
