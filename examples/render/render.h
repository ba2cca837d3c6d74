/*
 * render.h: pictures of dressed bodies, without a screen.
 *
 * The renderer opens an EGL display that needs neither X nor a device, draws with OpenGL 3.3 core into a multisampled
 * buffer of its own and hands back bytes. Use: render_create once; render_load with the meshes of a scene (uploads
 * them and computes their ambient occlusion); render_draw or render_picture for each view; render_destroy.
 * A machine that has no usable EGL gets one sentence from render_create; nothing here is linked to EGL or GL.
 *
 * Frame: X to the wearer's left, Y up, Z forward, metres. Colours are linear, 0..1; pictures are 8 bit sRGB.
 * Functions return 0, or -1 and a sentence in `error` (which may not be NULL). The same scene gives the same bytes on
 * the same machine.
 */
#ifndef RENDER_H
#define RENDER_H

#include <stdint.h>

/* Room for one sentence. */
typedef struct render_error {
    char text[512];
} render_error;

/* Pictures: rows from the top, 4 bytes a pixel (red, green, blue, alpha), not padded. */
typedef struct render_image {
    int32_t width;
    int32_t height;
    unsigned char *rgba; /* (height x width x 4), by malloc */
} render_image;

/* What a mesh is made of. Cloth is seen from both sides: the triangles' counter-clockwise side is the right side. */
#define RENDER_BODY 0
#define RENDER_CLOTH 1
#define RENDER_TRIM 3 /* buttons: hard and smooth, on the cloth */

/* linear colour of the mannequin, as an initialiser */
#define RENDER_SKIN {0.620, 0.602, 0.582}

/* What is seen of a line on cloth. */
#define RENDER_LINE_SEAM 0   /* two panels meet: the cloth dips into a groove */
#define RENDER_LINE_STITCH 1 /* stitches, in thread of the cloth's colour */
#define RENDER_LINE_EDGE 2   /* a finished edge: the cloth is folded there, and rounded */

/* A line on the cloth, in the plane of a panel. It is drawn at the distance `offset` from its points, on both sides. */
typedef struct render_line {
    int32_t panel;
    int32_t kind;         /* RENDER_LINE_* */
    int32_t count;        /* of points, 2 or more */
    const double *points; /* (count x 2), as texcoords [m]; closed when the last is the first */
    double offset;        /* [m], 0: on the points */
} render_line;

typedef struct render_mesh {
    int32_t kind; /* RENDER_BODY or RENDER_CLOTH */
    int32_t vertex_count;
    int32_t triangle_count;
    const double *positions;   /* (vertex_count x 3) [m] */
    const double *normals;     /* (vertex_count x 3), unit, or NULL: computed, smooth over vertices at one place */
    const double *texcoords;   /* (vertex_count x 2) place in the panel [m], y along the warp, or NULL: plain cloth */
    const double *colours;     /* (vertex_count x 3) linear, in place of `colour`, or NULL */
    const int32_t *triangles;  /* (triangle_count x 3) */
    double colour[3];          /* linear */
    const render_image *print; /* printed on the cloth and repeated, or NULL */
    double print_width;        /* of one repeat of the print [m]; its height follows from the picture */
    const int32_t *panels;     /* (vertex_count) panel of each vertex, 0 and up; needed by lines. No triangle lies in
                                  two panels */
    int32_t line_count;
    const render_line *lines;  /* (line_count) seams and stitches of a cloth; they need texcoords too */
} render_mesh;

typedef struct render_scene {
    int32_t mesh_count;
    const render_mesh *meshes; /* (mesh_count) */
    int32_t floor;             /* nonzero: a floor under the lowest point, which shows the shadow */
    const double *frame;       /* (6) low and high corner of a box that cameras frame, the floor at its bottom: the
                                  same camera for the frames of a film; NULL: the box round the meshes */
} render_scene;

/* A camera frames the whole scene at zoom 1, at one scale for every yaw. From there on it turns to what is shown: at
 * zoom z > 1 the middle of the picture is the share 1 - 1/z of the way from the middle of the scene to that of the
 * cloth. */
typedef struct render_camera {
    double yaw;    /* [deg] 0 looks at the front; positive goes to the wearer's left */
    double pitch;  /* [deg] positive looks down; -89..89 */
    double zoom;   /* 0.1..100 */
    double height; /* of the point in the middle of the picture [m]; NaN: as above */
} render_camera;

/* Front and three-quarter view. */
#define RENDER_DEFAULT_VIEW_COUNT 2
extern const render_camera render_default_views[RENDER_DEFAULT_VIEW_COUNT];

/* Sides of a picture, in pixels. */
#define RENDER_SIZE_MIN 16
#define RENDER_SIZE_MAX 8192

typedef struct render render;

/** Open a display and a context, build the shaders. Sets EGL_LOG_LEVEL when it is not set: the sentence is ours. */
int render_create(render **out, render_error *error);

/** NULL is accepted. */
void render_destroy(render *r);

/** Name of the device that draws ("llvmpipe ..."). Borrowed. */
const char *render_device(const render *r);

/**
 * Take a scene: checked, uploaded, ambient occlusion computed. It is copied; the one before it is forgotten, also
 * when the call fails.
 */
int render_load(render *r, const render_scene *scene, render_error *error);

/** Draw the loaded scene: `rgba` (height x width x 4). */
int render_draw(render *r, const render_camera *camera, int32_t width, int32_t height, unsigned char *rgba,
                render_error *error);

/** Draw `count` views side by side into one picture, in columns of equal width. */
int render_picture(render *r, int32_t count, const render_camera *cameras, int32_t width, int32_t height,
                   unsigned char *rgba, render_error *error);

/** Write a PNG, the whole file or none (a file beside it is renamed at the end). "-" is standard output. */
int render_png_write(const char *path, int32_t width, int32_t height, const unsigned char *rgba, render_error *error);

/** Read any PNG of at most RENDER_SIZE_MAX a side. */
int render_png_read(const char *path, render_image *out, render_error *error);
void render_image_free(render_image *image);

/* A mesh from a file; arrays by malloc, texcoords and normals NULL unless every corner has them. */
typedef struct render_obj {
    int32_t vertex_count;
    int32_t triangle_count;
    double *positions;
    double *normals;
    double *texcoords;
    int32_t *triangles;
} render_obj;

/** Read v, vt, vn and f of a Wavefront OBJ; polygons become fans. The sentence names file and line. */
int render_obj_read(const char *path, render_obj *out, render_error *error);
void render_obj_free(render_obj *obj);

/** "YAW,PITCH" (zoom 1), "YAW,PITCH,ZOOM" or "YAW,PITCH,ZOOM,HEIGHT"; a decimal point, whatever the locale. */
int render_view_parse(const char *text, render_camera *out, render_error *error);

/** "WxH". */
int render_size_parse(const char *text, int32_t *width, int32_t *height, render_error *error);

/** "#RRGGBB" (sRGB) or a name (white, ecru, navy ...) to linear red, green, blue. */
int render_colour_parse(const char *text, double *colour, render_error *error);

/** Smooth normals (vertex_count x 3) by corner angle, shared by vertices at the same place. -1: no memory. */
int render_normals(int32_t vertex_count, const double *positions, int32_t triangle_count, const int32_t *triangles,
                   double *normals);

#endif
