/* mesh.h: a body from a mesh: the option --mesh and those that say how to read it. */
#ifndef MUSLIN_MESH_H
#define MUSLIN_MESH_H

#include "json.h"
#include "scene.h"
#include "stance.h"
#include "surface.h"

/* Texts of the options, NULL when not given. */
typedef struct mesh_source {
    const char *file, *up, *front;
    double unit; /* of the mesh [m]; 0: it is found from the mesh */
} mesh_source;

#define SOURCE_MESH(m)                                                                                  \
    {"--mesh", OPTION_TEXT, &(m).file, 0, 0, "FILE  an OBJ, a scan or an avatar, as the body"},         \
        {"--up", OPTION_TEXT, &(m).up, 0, 0, "AXIS  upward axis of the mesh: x, y, z, -x ... (found)"}, \
        {"--front", OPTION_TEXT, &(m).front, 0, 0, "AXIS  forward axis of the mesh (found)"},           \
    {                                                                                                   \
        "--unit", OPTION_NUMBER, &(m).unit, 1e-6, 1e3, "M  unit of the mesh in metres (found)"          \
    }

/* Reads the mesh and makes a body of it. `report` may be NULL. Returns an exit code. */
int mesh_body(scene *s, const mesh_source *from, mus_scan_report *report, mus_body **out);

/* muslin body --mesh: prints the report of the scan, for people or as JSON, and writes the surface in its present pose
 * to the files. */
int mesh_command(const mesh_source *from, const stance *how, const surface_files *files, bool as_json);

#endif
