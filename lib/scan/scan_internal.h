/*
 * scan_internal.h: the insides of reading a mesh as a body: the welded mesh, its sections, frames, and what is found.
 *
 * Order of work: weld (scan_mesh.c), find up, front, unit and bring the mesh into the body's frame (scan_frame.c), find
 * crotch, armpits and the axes of the arms (scan_find.c), cut each limb into outlines (scan_limb.c), make a body of
 * given limbs, measure it and its distance from the mesh (scan_measure.c, scan_distance.c).
 */
#ifndef MUS_SCAN_SCAN_INTERNAL_H
#define MUS_SCAN_SCAN_INTERNAL_H

#include "base/base_internal.h"
#include "body/bones.h"
#include "muslin/scan.h"

#define MUS__SCAN_LEVEL 0.35   /* sine of arms that are level: 20 degrees down */
#define MUS__SCAN_LIMBS 7      /* torso, arms, legs, feet */
#define MUS__SCAN_CONTOURS 128 /* most of a limb: what mus_body_create_limbs takes */

/* ---- scan_mesh.c ---- */

/* vertices of equal place are one, triangles without area are gone, edges are numbered */
typedef struct mus__scan_mesh {
    mus_context *context;
    int32_t vertices, triangles, edges;
    double *x;         /* (vertices x 3) */
    int32_t *triangle; /* (triangles x 3) */
    int32_t *edge;     /* (triangles x 3) edge k joins corners k and k + 1 */
} mus__scan_mesh;

mus_status mus__scan_weld(mus_context *context, int32_t nv, const double *x, int32_t nt, const int32_t *triangle,
                          mus__scan_mesh *out);
void mus__scan_mesh_free(mus__scan_mesh *mesh);

/* ---- scan_slice.c: sections of a mesh by parallel planes ---- */

/* a closed polygon of a section, counter-clockwise; while a section is made: a chain of segments */
typedef struct mus__loop {
    int32_t first, count;           /* points in the section's xy */
    double area, centre[2], box[4]; /* box: least and most of both coordinates */
    int32_t group;                  /* loops that overlap have one number: limbs that are shells of their own */
    bool open;
} mus__loop;

/* what a plane cuts of a triangle: from edge to edge */
typedef struct mus__segment {
    int32_t edge[2];
    bool walked;
    double xy[4];
} mus__segment;

typedef struct mus__section {
    double *xy; /* (points x 2) in (side, front) */
    int32_t points, room;
    mus__loop *loop; /* outermost loops, the largest first */
    int32_t loops, loop_room;
} mus__section;

/* planes square to an axis: point = origin + a side + b front + s axis */
typedef struct mus__slicer {
    mus_context *context;
    const mus__scan_mesh *mesh;
    double origin[3], side[3], front[3], axis[3];
    double low, high; /* s of the mesh */
    double gap;       /* holes are closed up to this width */
    double *sab;      /* (vertices x 3) */
    int32_t bins;
    double scale;          /* bins a metre */
    int32_t *start, *list; /* triangles of each bin: list[start[i]] ... */
    int32_t *slot;         /* (edges x 2) segments that end on an edge, -1: none */
    mus__segment *segment;
    int32_t segments, segment_room;
    mus__section section; /* of the last cut */
    int32_t holes;        /* gaps closed since make */
    double widest;
} mus__slicer;

mus_status mus__slicer_make(const mus__scan_mesh *mesh, const double *origin, const double *axis, const double *side,
                            double gap, mus__slicer *out);
void mus__slicer_free(mus__slicer *slicer);
/* the section at s into slicer->section; `what` names it in a message */
mus_status mus__slice(mus__slicer *slicer, double s, const char *what);

/* ---- scan_outline.c: polygons ---- */

/* area (counter-clockwise > 0) and centroid of a polygon */
double mus__polygon_centre(int32_t n, const double *xy, double *centre);
/* copy the loops of a group (-1: all) to `out`, cut by the half planes a * plane[0] + b * plane[1] >= plane[2] */
mus_status mus__section_take(mus_context *context, const mus__section *from, int32_t group, int32_t planes,
                             const double *plane, mus__section *out);
/* all loops of a section into one, their hull */
mus_status mus__section_hull(mus_context *context, mus__section *section);
/* distance of the slicer's axis from a loop, 0: it goes through */
double mus__loop_distance(const mus__section *section, int32_t loop);
/* the group that the axis goes through, or that is nearest to it within `spread`; -1: none */
int32_t mus__section_near(const mus__section *section, double spread);
void mus__section_free(mus_context *context, mus__section *section);
/*
 * A star-shaped outline (corners x 2) of the union of a section's loops, corners at equal angles about its centroid;
 * false when there is no area, or the centroid is in none of them. What a ray meets last is taken; *fill gets the depth
 * of the deepest hollow of a single loop that is closed so, 0 when none.
 */
bool mus__star(const mus__section *section, int32_t corners, double *centre, double *out, double *fill);

/* ---- scan_frame.c ---- */

/* up, front, unit and place, into the report; the mesh is brought into the body's frame. *legs: it has legs */
mus_status mus__scan_frame(mus__scan_mesh *mesh, const mus_scan_def *def, mus_scan_report *report, bool *legs);

/* ---- scan_find.c ---- */

/* an arm: its axis from the shoulder outwards, and the wall that parts it from the torso */
typedef struct mus__scan_arm {
    bool there;
    double side;                          /* +1 left, -1 right */
    double origin[3], axis[3], across[3]; /* s = 0 at the shoulder; across: the limb's side */
    double tip;                           /* s of the finger tips */
    double root;                          /* s where it leaves the torso */
    double wrist;                         /* s of the narrowest section of the forearm */
    double armpit[3];
    double up[3];   /* square to the axis in the frontal plane, upwards */
    double wall[4]; /* n . x >= wall[3] is the arm's */
} mus__scan_arm;

typedef struct mus__scan_found {
    double stature, neck; /* heights */
    bool legs;
    double crotch, middle; /* height, and x of the plane between the legs */
    double foot;           /* height of the top of the feet, 0: none */
    mus__scan_arm arm[2];
} mus__scan_found;

mus_status mus__scan_find(const mus__scan_mesh *mesh, mus__slicer *upright, mus__scan_found *out);

/* ---- scan_limb.c ---- */

/* outlines of all limbs, ready for mus_body_create_limbs; rows and outlines live in `block` */
typedef struct mus__scan_limbs {
    int32_t count;
    mus_limb limb[MUS__SCAN_LIMBS];
    int32_t which[MUS__SCAN_LIMBS]; /* MUS_LIMB_* of body/bones.h */
    double *row[MUS__SCAN_LIMBS], *outline[MUS__SCAN_LIMBS];
    double shoulder[2]; /* s of the shoulder joints along the arms */
    int32_t filled;
    double deepest;
} mus__scan_limbs;

mus_status mus__scan_cut(const mus__scan_mesh *mesh, const mus_scan_def *def, mus__slicer *upright,
                         const mus__scan_found *found, mus_scan_report *report, mus__scan_limbs *out);
void mus__scan_limbs_free(mus_context *context, mus__scan_limbs *limbs);

/* ---- scan_joint.c ---- */

/* the joints of the limbs of a person with legs */
void mus__scan_joints(const mus__scan_found *found, const mus__scan_limbs *limbs, mus__bones *out);

/* ---- scan_measure.c, scan_distance.c ---- */

mus_status mus__scan_measure(const mus_body *body, const mus__scan_found *found, const mus__scan_limbs *limbs,
                             mus_scan_report *report);
mus_status mus__scan_distances(const mus__scan_mesh *mesh, const mus_body *body, const mus__scan_found *found,
                               mus_scan_report *report);

#endif
