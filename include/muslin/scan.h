/*
 * muslin/scan.h: a body from a triangle mesh: a scan of a person, an avatar, a dress form.
 *
 * The mesh is cut by planes: torso, head and legs horizontally, each arm square to its own axis, each foot from heel to
 * toe. Each section becomes a star-shaped contour about its centroid; the stacks of contours are a body like any other,
 * with the same contact, and the mesh is not needed any more. The person stands upright with arms spread (A- or T-pose)
 * and legs apart. A mesh without legs is a form; a mesh may also lack arms. Joints are found from the contours, so that
 * a scanned person is posed and moved by muslin/pose.h; a limb that the mesh lacks cannot be turned, and a form not at
 * all.
 *
 * Units:   metre, radian
 */
#ifndef MUSLIN_SCAN_H
#define MUSLIN_SCAN_H

#include "muslin/base.h"
#include "muslin/body.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Axes of a mesh; the negative number is the opposite direction. */
#define MUS_SCAN_FOUND 0
#define MUS_SCAN_X 1
#define MUS_SCAN_Y 2
#define MUS_SCAN_Z 3

/** How a mesh is to be read. */
typedef struct mus_scan_def {
    size_t size;
    int32_t up;          /* axis of the mesh that points up, -3 to 3; MUS_SCAN_FOUND (default): found from the mesh */
    int32_t front;       /* axis that the person faces, -3 to 3; MUS_SCAN_FOUND (default): found from the mesh, and set
                            to an axis of the mesh that is within 6 degrees */
    double unit;         /* length of one unit of the mesh [m], 1e-6 to 1e3; 0 (default): m, cm, mm or inch, found from
                            the height */
    double spacing;      /* distance of contours along a limb [m], 0.002 to 0.05, default 0.01 */
    int32_t corners;     /* corners of each contour, 16 to 1024, default 192 */
    double gap;          /* holes of the mesh up to this width are closed [m], 0 to 1, default 0.06 */
    int32_t samples;     /* as mus_body_def.samples, default 128 */
    double ring_spacing; /* as mus_body_def.ring_spacing [m], default 0.01 */
    int32_t distances;   /* nonzero (default): compute the distances of the report, which take most of the time */
} mus_scan_def;

/** Write the defaults of mus_scan_def; `size` is sizeof(mus_scan_def). */
MUS_API void mus_scan_def_init(mus_scan_def *def, size_t size);

/* Parts of a person for which the report gives distances. */
#define MUS_SCAN_TORSO 0
#define MUS_SCAN_HEAD 1
#define MUS_SCAN_ARMS 2
#define MUS_SCAN_HANDS 3
#define MUS_SCAN_LEGS 4
#define MUS_SCAN_FEET 5
#define MUS_SCAN_PART_COUNT 6

/* Girths that the report gives. */
#define MUS_SCAN_BUST 0
#define MUS_SCAN_WAIST 1
#define MUS_SCAN_HIP 2
#define MUS_SCAN_THIGH 3
#define MUS_SCAN_WRIST 4
#define MUS_SCAN_GIRTH_COUNT 5

/** What was found in a mesh, and how closely the body follows it. NaN stands for what the mesh does not have. */
typedef struct mus_scan_report {
    size_t size;
    double unit;         /* length of one unit of the mesh [m] */
    double frame[9];     /* rows: the body's X (its left), Y (up) and Z (front) in the axes of the mesh */
    double place[3];     /* position in the body = unit * frame * position in the mesh + place [m] */
    double stature;      /* height of the person [m] */
    double crotch;       /* height at which the legs part [m] */
    double armpit[2];    /* heights of the armpits, left and right [m] */
    double arm_angle[2]; /* angles of the arms' axes below the horizontal, left and right [rad] */
    int32_t vertices;    /* vertices of the mesh after equal ones were merged */
    int32_t contours;    /* contours of all limbs */
    int32_t holes;       /* gaps that were closed in sections */
    double widest_hole;  /* width of the widest of them [m] */
    int32_t filled;      /* contours with a hollow of 1 mm or more that no ray from the centre reaches; it was closed */
    double deepest_fill; /* depth of the deepest of them [m] */
    /* MUS_SCAN_BUST ...: girth of the body's contour as a tape lies, and its height (of the wrist: its place on the
       arm's axis) [m]; of the right limb, or of the left one where there is no right one */
    double girth[MUS_SCAN_GIRTH_COUNT];
    double girth_height[MUS_SCAN_GIRTH_COUNT];
    /* MUS_SCAN_TORSO ...: median, 95th percentile and maximum of the distances of the mesh's vertices from the body's
       surface, and of the body's vertices from the mesh [m] */
    double mesh_to_body[MUS_SCAN_PART_COUNT][3];
    double body_to_mesh[MUS_SCAN_PART_COUNT][3];
} mus_scan_report;

/** Prepare a report for mus_body_create_scan(): all 0; `size` is sizeof(mus_scan_report). */
MUS_API void mus_scan_report_init(mus_scan_report *report, size_t size);

/**
 * Make a body from a triangle mesh.
 *
 * The limbs have the names of a body of a tape: torso (with neck and head), arm_left ... foot_right; limbs that the
 * mesh lacks are left out. The lowest point is put on the floor Y = 0, the middle of the pelvis at X = Z = 0. Triangles
 * may wind either way and may share vertices or repeat them. Holes up to def.gap are closed. `def` and `report` may be
 * NULL.
 *
 * Shapes:  vertices (vertex_count x 3), triangles (triangle_count x 3); they are not kept
 * Errors:  MUS_ERR_ARG (a number out of range, an unknown vertex index, a vertex that is not finite), MUS_ERR_VERSION,
 *          MUS_ERR_MEMORY, MUS_ERR_LIMIT (more than 16 million triangles); MUS_ERR_BODY (a wider hole; up, front or
 *          unit cannot be found; no person is found: the message says at which height). *out is then NULL
 * Cost:    about 1 s for 50,000 triangles with distances
 */
MUS_API mus_status mus_body_create_scan(mus_context *context, int32_t vertex_count, const double *vertices,
                                        int32_t triangle_count, const int32_t *triangles, const mus_scan_def *def,
                                        mus_scan_report *report, mus_body **out);

#ifdef __cplusplus
}
#endif

#endif
