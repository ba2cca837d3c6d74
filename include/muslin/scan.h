/*
 * muslin/scan.h: a body from a triangle mesh: a scan of a person, an avatar, a dress form.
 *
 * The mesh is cut by planes: across the torso, the legs and the head horizontally, along the arms square to their own
 * axis, along the feet from heel to toe. Each section becomes a star-shaped contour about its centroid, and the stacks
 * of contours are a body like any other, with the same contact; no triangle is asked afterwards. A person stands
 * upright, arms spread (A- or T-pose), legs apart; what has no legs is a form, and what has no arms is one without.
 * Joints are found from the limbs' contours: a person is posed and moved by the calls of pose.h; limbs that the mesh
 * lacks cannot be turned, and a form not at all.
 */
#ifndef MUSLIN_SCAN_H
#define MUSLIN_SCAN_H

#include "muslin/base.h"
#include "muslin/body.h"

#ifdef __cplusplus
extern "C" {
#endif

/* axes of a mesh; negative: against it */
#define MUS_SCAN_FOUND 0
#define MUS_SCAN_X 1
#define MUS_SCAN_Y 2
#define MUS_SCAN_Z 3

/** How a mesh is to be read. */
typedef struct mus_scan_def {
    size_t size;
    int32_t up;          /* axis of the mesh that points up, -3 to 3; 0 (default): found */
    int32_t front;       /* axis that a person faces, -3 to 3; 0 (default): found, to 6 degrees the axis it is near */
    double unit;         /* one unit of the mesh [m], 1e-6 to 1e3; 0 (default): m, cm, mm or inch by the height */
    double spacing;      /* between contours [m], default 0.01, 0.002 to 0.05 */
    int32_t corners;     /* of each contour, default 192, 16 to 1024 */
    double gap;          /* holes of the mesh are closed up to this width [m], default 0.06, 0 to 1 */
    int32_t samples;     /* round each contour of the surface, as in mus_body_def, default 96 */
    double ring_spacing; /* between rings of the surface, as in mus_body_def [m], default 0.01 */
    int32_t distances;   /* nonzero (default): the report tells distances; they take most of the time */
} mus_scan_def;

MUS_API void mus_scan_def_init(mus_scan_def *def, size_t size);

/* parts of a person whose distances are told apart */
#define MUS_SCAN_TORSO 0
#define MUS_SCAN_HEAD 1
#define MUS_SCAN_ARMS 2
#define MUS_SCAN_HANDS 3
#define MUS_SCAN_LEGS 4
#define MUS_SCAN_FEET 5
#define MUS_SCAN_PART_COUNT 6

/* girths that are found on the body */
#define MUS_SCAN_BUST 0
#define MUS_SCAN_WAIST 1
#define MUS_SCAN_HIP 2
#define MUS_SCAN_THIGH 3
#define MUS_SCAN_WRIST 4
#define MUS_SCAN_GIRTH_COUNT 5

/** What was found in a mesh, and how well the body follows it. Lengths in metres; NaN: there is no such thing. */
typedef struct mus_scan_report {
    size_t size;
    double unit;         /* one unit of the mesh [m] */
    double frame[9];     /* rows: the body's X (its left), Y (up), Z (front) in the axes of the mesh */
    double place[3];     /* x in the body = unit * frame * x in the mesh + place */
    double stature;      /* height */
    double crotch;       /* height where the legs part */
    double armpit[2];    /* heights, left and right */
    double arm_angle[2]; /* of the arms' axes below the horizontal [rad] */
    int32_t vertices;    /* of the mesh once equal places are one */
    int32_t contours;    /* of all limbs */
    int32_t holes;       /* gaps closed in sections, */
    double widest_hole;  /* and the widest of them */
    int32_t filled;      /* contours with a hollow that no ray from the centre sees, closed; 1 mm and deeper */
    double deepest_fill; /* the deepest of them */
    /* MUS_SCAN_BUST...: of the body's contours as a tape lies, and their heights (wrist: along the arm's axis); of the
       right limb, or of the left where there is no right one */
    double girth[MUS_SCAN_GIRTH_COUNT];
    double girth_height[MUS_SCAN_GIRTH_COUNT];
    /* MUS_SCAN_TORSO...: median, 95 of 100, most; of the mesh's vertices from the body's surface, and of the body's
       bare vertices from the mesh */
    double mesh_to_body[MUS_SCAN_PART_COUNT][3];
    double body_to_mesh[MUS_SCAN_PART_COUNT][3];
} mus_scan_report;

MUS_API void mus_scan_report_init(mus_scan_report *report, size_t size);

/**
 * Make a body from a triangle mesh.
 *
 * Limbs have the names of a measured body's: torso (with neck and head), arm_left, ..., foot_right; those that the mesh
 * has not are left out. The floor is Y = 0, the middle of the pelvis X = Z = 0. Triangles may wind either way, share
 * vertices or repeat them; holes up to def.gap are closed.
 *
 * Shapes:  vertices (vertex_count x 3), triangles (triangle_count x 3); not kept. `def` and `report` may be NULL.
 * Errors:  MUS_ERR_ARG (a number out of range, an index, a vertex that is not finite), MUS_ERR_VERSION, MUS_ERR_MEMORY,
 *          MUS_ERR_LIMIT (above 16 million triangles); MUS_ERR_BODY (a wider hole; up, front or unit cannot be told; no
 *          person is seen: one sentence says where)
 * Cost:    about a second for 50 thousand triangles with a report
 */
MUS_API mus_status mus_body_create_scan(mus_context *context, int32_t vertex_count, const double *vertices,
                                        int32_t triangle_count, const int32_t *triangles, const mus_scan_def *def,
                                        mus_scan_report *report, mus_body **out);

#ifdef __cplusplus
}
#endif

#endif
