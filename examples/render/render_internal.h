/*
 * render_internal.h: the renderer's data, shared by its own files only.
 *
 * scene.c fills the parts, occlusion.c their ambient occlusion, draw.c the targets; matrix.c has the arithmetic.
 * Matrices are column-major as OpenGL takes them: element (row, column) is m[4 * column + row].
 */
#ifndef RENDER_INTERNAL_H
#define RENDER_INTERNAL_H

#include "gl.h"

/* a vertex as it lies in the buffer */
typedef struct render_vertex {
    float position[3];
    float normal[3];
    float texcoord[2]; /* [m] */
    float colour[3];   /* linear */
    float open[2];     /* share of the surroundings that light comes from: right side, wrong side */
    float thread[2];   /* place in the map of seams and stitches, 0..1 */
} render_vertex;

/* a mesh as it lies in OpenGL */
typedef struct render_part {
    int32_t kind;       /* RENDER_BODY, RENDER_CLOTH or RENDER_FLOOR */
    int32_t vertex_count;
    int32_t index_count;
    int32_t has_texcoords;
    int32_t closed;     /* nonzero: encloses a volume, triangles wind outwards */
    GLuint array;
    GLuint vertices;
    GLuint indices;
    GLuint print;       /* texture, 0 if none */
    float repeats[2];   /* repeats of the print per metre */
    GLuint thread;      /* map of seams and stitches, 0 if none */
    float texel;        /* side of its texel [m] */
    render_vertex *v;   /* (vertex_count), kept: light is fitted round it */
    int32_t *triangles; /* (index_count) */
} render_part;

#define RENDER_FLOOR 2

/* Locations of the uniforms of one program; -1 where it has none. X(name): u.name is uniform u_name. */
#define RENDER_UNIFORM_LIST(X) \
    X(view)                    \
    X(light)                   \
    X(eye)                     \
    X(key)                     \
    X(fill)                    \
    X(rim)                     \
    X(kind)                    \
    X(woven)                   \
    X(printed)                 \
    X(repeats)                 \
    X(print)                   \
    X(shadow)                  \
    X(spread)                  \
    X(middle)                  \
    X(joined)                  \
    X(size)                    \
    X(picture)                 \
    X(sewn)                    \
    X(thread)                  \
    X(stitch_texel)

typedef struct render_program {
    GLuint id;
#define RENDER_UNIFORM_MEMBER(name) GLint name;
    RENDER_UNIFORM_LIST(RENDER_UNIFORM_MEMBER)
#undef RENDER_UNIFORM_MEMBER
} render_program;

/* a picture being drawn: multisampled, then resolved, then in bytes */
typedef struct render_target {
    int32_t width;
    int32_t height;
    GLuint many;        /* framebuffer of samples */
    GLuint many_colour;
    GLuint many_depth;
    GLuint one;         /* resolved, linear */
    GLuint one_colour;  /* texture */
    GLuint bytes;       /* sRGB bytes with dither */
    GLuint bytes_colour;
} render_target;

struct render {
    render_egl *egl;
    render_gl gl;
    char device[128];
    int32_t samples;
    render_program depth_program;  /* positions only */
    render_program back_program;   /* background */
    render_program floor_program;  /* shadow on the floor */
    render_program body_program;   /* body and cloth */
    render_program finish_program; /* linear to bytes */
    GLuint empty_array;            /* for triangles that the shader makes up */
    GLuint compare;                /* sampler: depth comparison, bilinear */

    int32_t part_count;
    render_part *parts;            /* (part_count), the floor last */
    double low[3];                 /* bounds without the floor [m] */
    double high[3];
    double centre[3];
    double focus[3];               /* middle of the cloth; the centre in a film and without cloth [m] */
    double radius;                 /* largest distance from the upright axis through the centre [m] */
};

/* matrix.c */
void render_matrix_multiply(float *out, const float *a, const float *b);
void render_matrix_look(float *out, const double *eye, const double *forward, const double *up);
void render_matrix_perspective(float *out, double tangent_x, double tangent_y, double near, double far);
void render_matrix_box(float *out, const double *low, const double *high);
void render_cross(double *out, const double *a, const double *b);
void render_normalise(double *v);

/* shader.c */
int render_programs_build(render *r, render_error *error);
void render_programs_free(render *r);

/* scene.c */
void render_scene_free(render *r);

/* thread.c: the map of the lines of a mesh, to the part's texture and its vertices. Distances are drawn up to the range
 * [m]: wider than a pixel of a whole person */
#define RENDER_THREAD_RANGE 0.008
int render_thread_make(render *r, const render_mesh *m, render_part *part, render_error *error);

/* occlusion.c: fills `open` of all parts */
int render_occlusion(render *r, render_error *error);

/* light.c: depth maps of light that shines along -towards; the matrix takes the world to the cube -1..1 of the map */
typedef struct render_light {
    GLuint map;       /* depth texture */
    float matrix[16];
    double spread[3]; /* width, height and depth of the cube in the world [m] */
} render_light;

void render_light_matrix(const render *r, const double *towards, float *matrix, double *spread);
void render_light_draw(render *r, const float *matrix);
int render_depth_target(render *r, int32_t width, int32_t height, GLuint *frame, GLuint *map, render_error *error);
int render_light_map(render *r, const double *towards, int32_t size, render_light *light, render_error *error);

/* draw.c */
void render_part_draw(render *r, const render_part *part);

#endif
