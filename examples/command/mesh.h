/* mesh.h: a body from a mesh, for the subcommands that take one: --mesh and how to read it. */
#ifndef MUSLIN_MESH_H
#define MUSLIN_MESH_H

#include "json.h"
#include "scene.h"
#include "stance.h"

/* Texts of the options, NULL when not given. */
typedef struct mesh_source {
    const char *file, *up, *front;
    double unit; /* 0: found */
} mesh_source;

#define SOURCE_MESH(m)                                                                                                 \
    {"--mesh", OPTION_TEXT, &(m).file, 0, 0, "FILE  the body is this OBJ: a scan or an avatar"},                       \
        {"--up", OPTION_TEXT, &(m).up, 0, 0, "AXIS  of the mesh that points up: x, y, z, -x ... (found)"},             \
        {"--front", OPTION_TEXT, &(m).front, 0, 0, "AXIS  that the mesh faces (found)"},                               \
    {                                                                                                                  \
        "--unit", OPTION_NUMBER, &(m).unit, 1e-6, 1e3, "M  one unit of the mesh in metres (found)"                     \
    }

/* Read the mesh and make a body of it. `report` may be NULL. Returns an exit code. */
int mesh_body(scene *s, const mesh_source *from, mus_scan_report *report, mus_body **out);

/* muslin body --mesh: what was found, for people or as JSON, and the surface, as it stands, to `obj` unless NULL. */
int mesh_command(const mesh_source *from, const stance *how, const char *obj, bool as_json);

#endif
