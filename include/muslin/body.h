/*
 * muslin/body.h: a body made of stacks of closed contours that fit the tape.
 *
 * A body is a set of limbs; each limb is a stack of contours on a straight axis. Contours are superellipses whose
 * girth is the tape's; between them runs a natural cubic spline; the surface is triangulated from the samples. The
 * made surface is measured again and the figures are returned beside the asked ones. Source: Metaaphanon and
 * Kanongchaiyos, Real-time Cloth Simulation for Garment CAD, 2005, eq. 6 to 11 and section 3.
 */
#ifndef MUSLIN_BODY_H
#define MUSLIN_BODY_H

#include "muslin/base.h"
#include "muslin/tape.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mus_body mus_body;

/*
 * The joints, parents before children. X(NAME, "name").
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

/** A limb given by its contours on a straight axis: superellipses |a/A|^n + |b/B|^n = 1, or outlines. */
typedef struct mus_limb {
    size_t size;
    const char *name;      /* copied, cut at 31 bytes; default "limb" */
    double origin[3];      /* where s is 0 [m], default 0 */
    double axis[3];        /* the way s grows, of any length, default (0, 1, 0) */
    double side[3];        /* the way a grows; what is along the axis is taken off; default (1, 0, 0) */
    double pole[2];        /* s of the points that close it below and above its contours [m] */
    int32_t contours;      /* 2 to 128 */
    const double *contour; /* (contours x 6) s ascending, centre a, centre b, half breadth A, half depth B [m],
                              exponent n 1..16 (2: an ellipse); b = axis x side */
    int32_t corners;       /* 0: superellipses; 3 to 1024: each contour is a polygon of that many corners, */
    const double *outline; /* (contours x corners x 2) a, b [m], from side towards b, seen from the centre at angles
                              that ascend all round (star-shaped); A, B and n are then not read */
    int32_t joint;         /* of one added to a body of a tape: it moves with this MUS_JOINT_*, default 0 (the root) */
} mus_limb;

/* What a body of a tape can be made without (mus_body_def.without, added up): a limb or what is beyond a joint. */
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
    int32_t samples;      /* samples round each contour of the surface, default 96, 16..512, multiple of 4 */
    double ring_spacing;  /* between rings of the surface along a limb [m], default 0.01, 0.001..0.1 */
    int32_t ellipse;      /* nonzero: true ellipses (paper eq. 6) in place of superellipses, default 0 */
    int32_t without;      /* MUS_WITHOUT_* of a body of a tape, default 0: a whole one */
    int32_t limbs;        /* added to a body of a tape, 0 to 48, default 0: */
    const mus_limb *limb; /* (limbs) a prosthesis, a belly, a hump; copied. They count in contact, surface and volume,
                             not in the measures */
    int32_t plain;        /* nonzero: the surface is that of the contours alone, without fillets where limbs meet, face,
                             fingers and toes: half the time, for what draws nothing; measures and contact stay */

    /* Posture of a body of a tape, in metres, default 0: upright. Girths and heights stay the tape's. */
    double stoop;        /* the nape comes so far forwards, the upper back rounds; negative: erect. -0.02 to 0.04 of the
                            stature */
    double head_forward; /* the head before the neck's base; -0.01 to 0.03 of the stature */
    double sway;         /* a hollow back: the waist before chest and hip; negative: flat. -0.015 to 0.03 of it */
} mus_body_def;

MUS_API void mus_body_def_init(mus_body_def *def, size_t size);

/**
 * Make a body.
 *
 * `tape` is completed on a copy when it is not complete yet, and not kept. `def` may be NULL.
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_TAPE (contradictory measures);
 *          MUS_ERR_BODY (contours that cross; the message names the two measures)
 * Cost:    a few milliseconds
 */
MUS_API mus_status mus_body_create(mus_context *context, const mus_tape *tape, const mus_body_def *def, mus_body **out);

MUS_API void mus_limb_init(mus_limb *limb, size_t size);

/**
 * Make a body of given limbs: a form, a dummy, a single limb.
 *
 * Shapes:  limb (limbs), 1 to 64; all is copied. `def` may be NULL.
 * Such a body has no measures and no landmarks. An end closes by a quarter of an ellipse from the last contour to its
 * pole.
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_BODY (contours that do not ascend, poles within, an
 *          outline that is not star-shaped about its centre: limb, contour and angle are named)
 */
MUS_API mus_status mus_body_create_limbs(mus_context *context, int32_t limbs, const mus_limb *limb,
                                         const mus_body_def *def, mus_body **out);

MUS_API void mus_body_destroy(mus_body *body);

/** Limbs: number, and name ("torso", "arm_left", "leg_right", ...), NULL outside the range. A body of a tape has seven,
 * then those added; one that it was made without has no contours, vertices and triangles. */
MUS_API int32_t mus_body_limb_count(const mus_body *body);
MUS_API const char *mus_body_limb_name(const mus_body *body, int32_t limb);

/**
 * Measures: what the tape asked, and what the made surface has, by the tape's own index.
 *
 * asked: the completed tape's value. made: re-measured on the surface: the girth as a tape lies (the hull of the
 * section), the height, the length of a tape along the skin (mus_body(3) says from where to where). NaN for what is not
 * measured (front waist, bust depth, scye depth, the arms' angle), and for what a body was made without.
 */
MUS_API double mus_body_asked(const mus_body *body, int32_t measure);
MUS_API double mus_body_made(const mus_body *body, int32_t measure);

/** MUS_SOURCE_* that the completed tape had for a measure. */
MUS_API int32_t mus_body_source(const mus_body *body, int32_t measure);

/** Volume of the union of the limbs [m3] as made, in the rest pose: what limbs share at a joint counts once. A
 * millisecond. */
MUS_API double mus_body_volume(const mus_body *body);

/** The surface: vertices (vertex_count x 3) [m], unit normals (vertex_count x 3), triangles (triangle_count x 3).
 * Borrowed until the body is destroyed. Triangles of a limb are contiguous and wind outwards. A body made from a tape
 * has one skin: where limbs meet, the vertices of both lie on a smooth union, up to 12 mm off the limbs in the crease
 * (at 1.68 m); the cleft of the seat goes 18 mm in. */
MUS_API int32_t mus_body_vertex_count(const mus_body *body);
MUS_API int32_t mus_body_triangle_count(const mus_body *body);
MUS_API const double *mus_body_vertices(const mus_body *body);
MUS_API const double *mus_body_normals(const mus_body *body);
MUS_API const int32_t *mus_body_triangles(const mus_body *body);

/** Range of a limb in the surface: `range` (4) gets first vertex, vertex count, first triangle, triangle count. */
MUS_API mus_status mus_body_limb_range(const mus_body *body, int32_t limb, int32_t *range);

/** Contours that define a limb (landmarks before interpolation), bottom up: number, and one of them sampled.
 * contour_points: out (n x 3) gets n samples at equal angles. Errors: MUS_ERR_ARG. */
MUS_API int32_t mus_body_contour_count(const mus_body *body, int32_t limb);
MUS_API const char *mus_body_contour_name(const mus_body *body, int32_t limb, int32_t contour);
MUS_API mus_status mus_body_contour_points(const mus_body *body, int32_t limb, int32_t contour, int32_t n, double *out);

/* Named points of the body. */
#define MUS_LANDMARK_CROWN 0
#define MUS_LANDMARK_NAPE 1
#define MUS_LANDMARK_BUST 2 /* centre of the bust contour */
#define MUS_LANDMARK_WAIST 3
#define MUS_LANDMARK_HIP 4
#define MUS_LANDMARK_CROTCH 5
#define MUS_LANDMARK_SHOULDER_LEFT 6 /* joint */
#define MUS_LANDMARK_SHOULDER_RIGHT 7
#define MUS_LANDMARK_WRIST_LEFT 8
#define MUS_LANDMARK_WRIST_RIGHT 9
#define MUS_LANDMARK_ANKLE_LEFT 10
#define MUS_LANDMARK_ANKLE_RIGHT 11
#define MUS_LANDMARK_COUNT 12

/** Position of a landmark: `out` (3) [m]. Errors: MUS_ERR_ARG (also: a body of given limbs has none, a scan has no nape
 * and none of what it lacks, a body of a tape no wrists and ankles that it was made without). */
MUS_API mus_status mus_body_landmark(const mus_body *body, int32_t landmark, double *out);

/**
 * Depth of points in the body: positive inside, negative outside, the distance to first order near the surface.
 *
 * Shapes:  points (n x 3), depth (n), normal (n x 3) outward or NULL
 * Units:   [m]; depth is -1e30 for a point out of reach of every limb's contour field (then normal is 0)
 * Cost:    O(1) a point and limb: no triangle is asked
 */
MUS_API mus_status mus_body_depth(const mus_body *body, int32_t n, const double *points, double *depth, double *normal);

#ifdef __cplusplus
}
#endif

#endif
