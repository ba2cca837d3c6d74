/* surface.h: the files that `muslin body` writes of a body: its skin, or one closed surface. */
#ifndef MUSLIN_SURFACE_H
#define MUSLIN_SURFACE_H

#include "picture.h"
#include "scene.h"

/* The options. Paths are NULL when not given. */
typedef struct surface_files {
    const char *obj, *glb, *png;
    bool manifold;
    double spacing; /* [mm], 0: the default */
    double turn;    /* number of pictures of one turn, 0: none */
    const char *frames;
    look look;
} surface_files;

#define SURFACE_FILES(f)                                                                                    \
    {"--obj", OPTION_OUTPUT, &(f).obj, 0, 0, "FILE  write the surface as OBJ"},                             \
        {"--glb", OPTION_OUTPUT, &(f).glb, 0, 0, "FILE  write the surface as binary glTF"},                 \
        {"--manifold", OPTION_FLAG, &(f).manifold, 0, 0, "write one closed surface, for print and solids"}, \
        {"--png", OPTION_OUTPUT, &(f).png, 0, 0, "FILE  write a picture"},                                  \
        {"--view", OPTION_LIST, &(f).look.views, 0, 0, "YAW,PITCH[,ZOOM]  a view in degrees; repeatable"},  \
        {"--pixels", OPTION_TEXT, &(f).look.pixels, 0, 0, "WxH  size of the picture"},                      \
        {"--turn", OPTION_WHOLE, &(f).turn, 1, 4096, "N  number of pictures of one turn"},                  \
        {"--frames", OPTION_TEXT, &(f).frames, 0, 0, "DIR  those pictures: DIR/frame_0001.png and on"},     \
    {                                                                                                       \
        "--spacing", OPTION_NUMBER, &(f).spacing, 1, 30, "MM  longest edge of the closed surface (4)"       \
    }

/* Whether the options go together; prints a line when they do not. */
bool surface_check(const surface_files *files);

/* Writes the files of a body where it stands. Returns an exit code. */
int surface_write(scene *s, const surface_files *files, const mus_body *body);

#endif
