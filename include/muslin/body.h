/*
 * muslin/body.h: a body made of stacks of closed contours that fit the tape.
 *
 * A body is a set of limbs; each limb is a stack of contours on a straight axis. Contours are superellipses that have
 * the girths of the tape; a natural cubic spline runs between them; the surface is triangulated from samples. The
 * finished surface is measured again, and mus_body_made() tells what it has beside what the tape asked.
 *
 * Units:   metre, radian. Frame: right-handed, X to the person's left, Y up, Z forwards; the floor is Y = 0
 * Source:  Metaaphanon and Kanongchaiyos, Real-time Cloth Simulation for Garment CAD, 2005, eq. 6 to 11 and section 3
 */
#ifndef MUSLIN_BODY_H
#define MUSLIN_BODY_H

#include "muslin/base.h"
#include "muslin/tape.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A body. It does not change once it is made, so drapes may share it. One thread at a time may use it and its
 * context. */
typedef struct mus_body mus_body;

/*
 * The joints, parents before children. X(NAME, "name"). They are turned by a mus_pose of muslin/pose.h.
 *
 * Positive flexion: root, lumbar and neck forwards; shoulder, elbow and hip move the limb forwards; knee backwards;
 * ankle toes up; wrist towards the palm. Positive abduction: root, lumbar and neck towards the left; limbs away from
 * the middle; wrist towards the thumb. Positive rotation: root, lumbar and neck to the left; limbs inwards.
 */
#define MUS_JOINT_LIST(X)                                            \
    X(ROOT, "root")                     /* the pelvis in the world */ \
    X(LUMBAR, "lumbar")                 /* chest on pelvis */         \
    X(NECK, "neck")                     /* head on chest */           \
    X(SHOULDER_LEFT, "shoulder_left")   /* arm on chest */            \
    X(SHOULDER_RIGHT, "shoulder_right")                               \
    X(ELBOW_LEFT, "elbow_left")         /* its rotation is that of the forearm */ \
    X(ELBOW_RIGHT, "elbow_right")                                     \
    X(WRIST_LEFT, "wrist_left")                                       \
    X(WRIST_RIGHT, "wrist_right")                                     \
    X(HIP_LEFT, "hip_left")             /* leg on pelvis */           \
    X(HIP_RIGHT, "hip_right")                                         \
    X(KNEE_LEFT, "knee_left")                                         \
    X(KNEE_RIGHT, "knee_right")                                       \
    X(ANKLE_LEFT, "ankle_left")                                       \
    X(ANKLE_RIGHT, "ankle_right")

#define MUS_JOINT_ENUM(NAME, name) MUS_JOINT_##NAME,
enum { MUS_JOINT_LIST(MUS_JOINT_ENUM) MUS_JOINT_COUNT };
#undef MUS_JOINT_ENUM

/** A limb given by its contours on a straight axis: superellipses |a/A|^n + |b/B|^n = 1, or outlines (polygons). */
typedef struct mus_limb {
    size_t size;
    const char *name;      /* copied, cut after 31 bytes; default "limb" */
    double origin[3];      /* the point of the axis at s = 0 [m], default 0 */
    double axis[3];        /* direction in which s grows, of any length, default (0, 1, 0) */
    double side[3];        /* direction in which a grows, made square to the axis; default (1, 0, 0) */
    double pole[2];        /* s of the points that close the limb below its first and above its last contour [m] */
    int32_t contours;      /* number of contours, 2 to 128 */
    const double *contour; /* (contours x 6) s ascending, centre a, centre b, half breadth A, half depth B [m],
                              exponent n 1 to 16 (2: an ellipse); b grows along axis x side */
    int32_t corners;       /* 0 (default): superellipses; 3 to 1024: each contour is a polygon of so many corners */
    const double *outline; /* (contours x corners x 2) a, b of the corners [m], counter-clockwise from a to b. Seen from
                              the centre their angles ascend once round (star-shaped); A, B and n are then not read */
    int32_t joint;         /* MUS_JOINT_* that moves a limb added to a body of a tape, default MUS_JOINT_ROOT */
} mus_limb;

/* Limbs, or their parts beyond a joint, that a body of a tape is made without: the sum is mus_body_def.without. */
#define MUS_WITHOUT_ARM_LEFT 0x001
#define MUS_WITHOUT_ARM_RIGHT 0x002
#define MUS_WITHOUT_FOREARM_LEFT 0x004 /* from the elbow on */
#define MUS_WITHOUT_FOREARM_RIGHT 0x008
#define MUS_WITHOUT_HAND_LEFT 0x010
#define MUS_WITHOUT_HAND_RIGHT 0x020
#define MUS_WITHOUT_LEG_LEFT 0x040
#define MUS_WITHOUT_LEG_RIGHT 0x080
#define MUS_WITHOUT_SHANK_LEFT 0x100 /* from the knee down */
#define MUS_WITHOUT_SHANK_RIGHT 0x200
#define MUS_WITHOUT_FOOT_LEFT 0x400 /* from the ankle down */
#define MUS_WITHOUT_FOOT_RIGHT 0x800
#define MUS_WITHOUT_ALL 0xfff

/** Options of a body. */
typedef struct mus_body_def {
    size_t size;
    int32_t samples;      /* samples round each contour of the surface, a multiple of 4, 16 to 512, default 128; arms,
                             legs and feet of a tape have half as many, but not fewer than 64 if there are 64 */
    double ring_spacing;  /* largest distance of the surface's rings along a limb [m], 0.001 to 0.1, default 0.015;
                             rings are closer where the surface bends; at most 200 between two contours, so that a
                             longer way between them has rings farther apart */
    int32_t ellipse;      /* nonzero: ellipses in place of superellipses, default 0 */
    int32_t without;      /* sum of MUS_WITHOUT_*, for a body of a tape; default 0: all limbs */
    int32_t limbs;        /* number of limbs added to a body of a tape, 0 to 48, default 0 */
    const mus_limb *limb; /* (limbs) the added limbs: a prosthesis, a belly, a hump; copied. They count in contact,
                             surface and volume, not in the measures */
    int32_t plain;        /* nonzero: no fingers and toes are drawn, hands and feet are closed shapes as cloth touches
                             them; measures and contact are the same. Default 0 */

    /* Posture of a body of a tape, default 0: upright. Girths and heights of the tape are kept. */
    double stoop;        /* distance [m] by which the nape comes forwards while the upper back rounds, -0.02 (erect) to
                            0.04 of the stature */
    double head_forward; /* distance [m] of the head before the base of the neck, -0.01 to 0.03 of the stature */
    double sway;         /* distance [m] of the waist before chest and hip (a hollow back), -0.015 (flat) to 0.03 of the
                            stature */
} mus_body_def;

/** Write the defaults of a body's options; `size` is sizeof(mus_body_def). */
MUS_API void mus_body_def_init(mus_body_def *def, size_t size);

/**
 * Make a body from a tape.
 *
 * A tape that is not complete is completed on a copy. The tape is not kept. `def` may be NULL: the defaults.
 *
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_TAPE (contradictory measures);
 *          MUS_ERR_BODY (two contours cross; the message names their measures). *out is then NULL
 * Memory:  about 6 MB with the defaults, freed by mus_body_destroy()
 * Cost:    about 10 ms; up to four times that with a given crotch_length, for which the torso is fitted again
 * Source:  the paper named above; depth to breadth of the contours: ANSUR II and the mean bodies of GarmentCode
 */
MUS_API mus_status mus_body_create(mus_context *context, const mus_tape *tape, const mus_body_def *def, mus_body **out);

/** Write the defaults of a given limb; `size` is sizeof(mus_limb). */
MUS_API void mus_limb_init(mus_limb *limb, size_t size);

/**
 * Make a body of given limbs: a form, a dummy, a single limb.
 *
 * Such a body has no measures, no landmarks and no joints. Each end of a limb closes by a quarter of an ellipse from
 * the last contour to the pole. `def` may be NULL: the defaults.
 *
 * Shapes:  limb (limbs), 1 to 64; everything is copied
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_BODY (contours that do not ascend, a pole between the
 *          contours, an outline that is not star-shaped: the message names limb, contour and angle). *out is then NULL
 * Cost:    about 5 ms for a limb
 */
MUS_API mus_status mus_body_create_limbs(mus_context *context, int32_t limbs, const mus_limb *limb,
                                         const mus_body_def *def, mus_body **out);

/** Free a body and its arrays; NULL is accepted. */
MUS_API void mus_body_destroy(mus_body *body);

/** Number of limbs: seven of a body of a tape, then the added ones. A limb that the body was made without is counted
 * and has no contours, vertices and triangles. */
MUS_API int32_t mus_body_limb_count(const mus_body *body);

/** Name of a limb ("torso", "arm_left", "leg_right" ...); NULL for an index outside 0 to mus_body_limb_count() - 1.
 * Borrowed until the body is destroyed. */
MUS_API const char *mus_body_limb_name(const mus_body *body, int32_t limb);

/** The value of a measure (MUS_MEASURE_*) in the completed tape [m] or [rad]; NaN for a body without a tape. */
MUS_API double mus_body_asked(const mus_body *body, int32_t measure);

/**
 * The value of a measure (MUS_MEASURE_*) on the finished surface [m] or [rad].
 *
 * A girth is that of a tape round the section, which spans hollows (the convex hull). A height is that of the contour's
 * ring. A length is that of a tape along the skin; mus_body(3) tells its ends. NaN for front_waist, bust_depth,
 * scye_depth and arm_angle, which are not measured, and for limbs that the body was made without.
 */
MUS_API double mus_body_made(const mus_body *body, int32_t measure);

/** Source (MUS_SOURCE_*) of a measure in the completed tape. */
MUS_API int32_t mus_body_source(const mus_body *body, int32_t measure);

/** Volume of the union of the limbs in the rest pose [m3]; a region that two limbs share counts once. Cost: 3 ms. */
MUS_API double mus_body_volume(const mus_body *body);

/** Number of vertices of the skin, fingers and toes included. */
MUS_API int32_t mus_body_vertex_count(const mus_body *body);

/** Number of triangles of the skin, fingers and toes included. */
MUS_API int32_t mus_body_triangle_count(const mus_body *body);

/**
 * Vertices of the skin (vertex_count x 3) [m], borrowed until the body is destroyed.
 *
 * Each limb is a closed shell. On a body made from a tape two limbs that meet have a smooth union (a fillet, up to 12
 * mm off the limbs in the crease at a stature of 1.68 m), and the cleft of the seat is 18 mm deep. The skin is what
 * cloth touches, but between fingers and toes: to cloth a hand is a mitten over its fingers, a foot a sock over its
 * toes. mus_body_made() measures it.
 */
MUS_API const double *mus_body_vertices(const mus_body *body);

/** Outward unit normals at the vertices of the skin (vertex_count x 3), borrowed until the body is destroyed. */
MUS_API const double *mus_body_normals(const mus_body *body);

/** Triangles of the skin (triangle_count x 3) as vertex indices, limb by limb, winding outwards; borrowed until the
 * body is destroyed. */
MUS_API const int32_t *mus_body_triangles(const mus_body *body);

/** Range of a limb in the skin: `range` (4) gets first vertex, vertex count, first triangle and triangle count.
 * Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_body_limb_range(const mus_body *body, int32_t limb, int32_t *range);

/** Number of contours that define a limb, in the order of its axis; 0 for a limb that the body was made without. */
MUS_API int32_t mus_body_contour_count(const mus_body *body, int32_t limb);

/** Name of a contour ("waist"); NULL for an index outside the limb's contours. Static text. */
MUS_API const char *mus_body_contour_name(const mus_body *body, int32_t limb, int32_t contour);

/** Sample a contour where the body stands: `out` (n x 3) gets n points at equal angles about its centre [m], n at least
 * 3. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_body_contour_points(const mus_body *body, int32_t limb, int32_t contour, int32_t n, double *out);

/* Landmarks: named points of the body. Crown, nape and crotch lie on the skin, shoulders are joints, the others are the
 * centres of the contours of their names. */
#define MUS_LANDMARK_CROWN 0
#define MUS_LANDMARK_NAPE 1
#define MUS_LANDMARK_BUST 2
#define MUS_LANDMARK_WAIST 3
#define MUS_LANDMARK_HIP 4
#define MUS_LANDMARK_CROTCH 5
#define MUS_LANDMARK_SHOULDER_LEFT 6
#define MUS_LANDMARK_SHOULDER_RIGHT 7
#define MUS_LANDMARK_WRIST_LEFT 8
#define MUS_LANDMARK_WRIST_RIGHT 9
#define MUS_LANDMARK_ANKLE_LEFT 10
#define MUS_LANDMARK_ANKLE_RIGHT 11
#define MUS_LANDMARK_COUNT 12

/**
 * Position of a landmark (MUS_LANDMARK_*) where the body stands: `out` (3) [m].
 *
 * Errors:  MUS_ERR_ARG, also for a landmark that the body does not have: a body of given limbs has none, a scan has no
 *          nape and no landmark of a limb that it lacks, a body of a tape no wrist and ankle that it was made without
 */
MUS_API mus_status mus_body_landmark(const mus_body *body, int32_t landmark, double *out);

/**
 * Depth of points in the body: positive inside, negative outside; near the surface the distance to first order.
 *
 * Shapes:  points (n x 3), depth (n), normal (n x 3) outward, or NULL
 * Units:   [m]; a point more than 5 cm outside every limb has the depth -1e30 and the normal 0
 * Errors:  MUS_ERR_ARG
 * Cost:    constant for a point and a part of the body: the query reads a table of radii and no triangle
 */
MUS_API mus_status mus_body_depth(const mus_body *body, int32_t n, const double *points, double *depth, double *normal);

#ifdef __cplusplus
}
#endif

#endif
