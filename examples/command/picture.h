/* picture.h: a dressed body as a picture and as meshes to write. */
#ifndef MUSLIN_PICTURE_H
#define MUSLIN_PICTURE_H

#include "fitmap.h"
#include "render/render.h"
#include "scene.h"
#include "stitches.h"

/* The options of a picture; NULL when not given. */
typedef struct look {
    const char *texture, *pixels;
    texts colours; /* of the garments, from the skin out; later ones take those of the fabric and the palette */
    const char *fabric; /* name of the cloth, which has a colour of its own; NULL: the palette's */
    texts views;
    double repeat; /* width of one repeat of the texture [m] */
    const fit_map *map; /* colours of the cloth, with a legend; NULL: none */
} look;

/* default colours of garments, linear RGB, used in turn */
#define PALETTE 8
extern const double palette[PALETTE][3];

/* Checks the options, and that the texture can be read, before the long work. Returns an exit code. */
int look_check(const scene *s, const look *l);

/* Meshes of body and garment, made once for picture and files. A mesh without vertices is not drawn. */
typedef struct garment {
    double *normals; /* (nodes x 3) */
    mus_mesh_view view[2]; /* body, garment */
    stitches sewn;         /* of the pattern of the scene */
    const int32_t *panels; /* (nodes) of the garment, borrowed */
    double *colours;       /* (nodes x 3) of garments over one another; NULL: one colour */
} garment;

/* Makes the views of body (may be NULL) and cloth in their present state. Returns an exit code. */
int garment_make(const scene *s, const look *l, const mus_body *body, const mus_cloth *cloth, const mus_drape *drape,
                 garment *out);
void garment_free(garment *g);

#define MESH_FORMS (MUS_MESH_PC2 + 1)

/* The motion of body and garment at all keys, for the files that hold one. */
typedef struct garment_motion {
    int32_t keys;
    const double *times;     /* (keys) [s] */
    mus_mesh_motion move[2]; /* body, garment */
} garment_motion;

/* Writes the mesh files that are asked for: files (MESH_FORMS) by form, NULL for none. With `moves` those that hold a
 * motion, without it the others. `fabric` names the cloth. */
mus_status garment_write(const scene *s, const garment *g, const mus_cloth *cloth, const char *fabric,
                         const garment_motion *moves, const char *const *files);

/* Draws and writes a PNG. Returns an exit code. */
int picture_write(const scene *s, const look *l, const garment *g, const char *path);

/* Draws one turn round what stands there: `count` pictures folder/frame_0001.png and on, each turned on by 360 degrees
 * over `count`. They begin with the views of `l`, or with the front. Returns an exit code. */
int picture_turn(const scene *s, const look *l, const garment *g, int32_t count, const char *folder);

/* A renderer that is kept open for many pictures by one camera. */
typedef struct film {
    const scene *s;
    const look *l;
    const double *box; /* (6) box that the camera shows [m]; NULL: each picture its own */
    render *r;
    render_image print;
} film;

/* Opens a renderer. Returns an exit code; it must be closed whatever that is. */
int film_open(film *f, const scene *s, const look *l, const double *box);
int film_shoot(film *f, const garment *g, const char *path);
/* Draws one view of the front, a little from the wearer's left, into `rgba` (height x width x 4). */
int film_tile(film *f, const garment *g, int32_t width, int32_t height, unsigned char *rgba);
void film_close(film *f);

#endif
