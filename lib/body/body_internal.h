/*
 * body_internal.h: the insides of a body: contours on limbs, the sampled stack between them, the surface, the fields.
 *
 * A limb has a right-handed frame (side, front, axis): point = origin + a*side + b*front + s*axis. The torso's and the
 * legs' is (X, -Z, Y), which is the frame of the founding paper: angles run from +X. Contours ascend in s; each is a
 * star-shaped closed curve about its centre (ca, cb), given by a radius for every angle.
 */
#ifndef MUS_BODY_BODY_INTERNAL_H
#define MUS_BODY_BODY_INTERNAL_H

#include "base/base_internal.h"
#include "body/bones.h"
#include "body/field.h"
#include "body/rig.h"
#include "body/skeleton.h"
#include "muslin/body.h"

#define MUS_LIMB_CONTOURS 128
#define MUS_LIMB_NAME_BYTES 32
#define MUS_BODY_ANGLES 128     /* steps of the diamond angle in contact fields */
#define MUS_BODY_SAMPLES 512 /* most samples round a contour */

typedef struct mus__contour {
    const char *name;
    int32_t girth;        /* measure that is its girth, or MUS_NONE */
    int32_t height;       /* measure that sets its place, or MUS_NONE */
    bool hard;            /* the girth was given: the contour may not be left out */
    bool flat;            /* narrowest or widest of its neighbours: the slope is held monotone, so 0, here */
    bool fine;            /* rings stand twice as close above it */
    double target;        /* girth to be fitted to [m], 0: a and b stand as they are */
    double s;             /* place on the axis */
    double ca, cb;        /* centre in the contour's plane */
    double a, b, n;       /* half breadth along side, half depth along front, superellipse exponent */
    double bump[2];       /* height of the pair of bumps towards the front, and towards the back */
    double bump_angle[2]; /* angle of the bumps off the front (off the back) */
    double wall;          /* plane a = wall that the contour does not pass, on the side wall_side */
    double wall_side;     /* +1: a >= wall, -1: a <= -wall, 0: no wall */
    int32_t corners;      /* of an outline in place of the superellipse, 0: none */
    const double *corner; /* (corners x 3) angle -pi..pi ascending, a and b off the centre; in mus_body.outline */
    double host[7];       /* the shape of another contour of this plane in place of its own: centre a and b, half
                             breadth, half depth, exponent, bump and angle of the back; host[2] = 0: its own */
    int32_t ring;         /* its ring in the surface */
} mus__contour;

typedef struct mus__limb {
    const char *name;
    char own_name[MUS_LIMB_NAME_BYTES]; /* `name` of a given limb */
    double origin[3], side[3], front[3], axis[3];
    int32_t count;
    mus__contour contour[MUS_LIMB_CONTOURS];
    bool limited[MUS_LIMB_CONTOURS]; /* slopes held monotone here: the natural spline would overshoot */
    double pole[2];                  /* s of the closing points below and above */
    int32_t end[2];                  /* measures that set them, or MUS_NONE */
    double wall, wall_side;          /* as the contours', for all in-between contours too */
    bool gone;                       /* the body was made without it: no part, no surface; contours for the joints */
    int32_t cuts;                    /* joints within it that it is cut at: parts but one */
    int32_t joint;                   /* that a limb added to a body of a tape moves with */
    int32_t first_vertex, vertices, first_triangle, triangles, first_ring, rings;
} mus__limb;

struct mus_body {
    mus_context *context;
    mus_body_def def;
    mus__skeleton skeleton;
    double asked[MUS_MEASURE_COUNT], made[MUS_MEASURE_COUNT];
    int32_t source[MUS_MEASURE_COUNT];
    bool measured;   /* made from a tape: it has landmarks and measures */
    bool scanned;    /* made from a mesh: what it has not cannot be posed */
    bool jointed;    /* of a tape or a scan: it has bones, and can be posed */
    mus__bones bones;
    mus__limb *limb; /* (limb_count) */
    int32_t limb_count;
    double *outline; /* corners of all contours that are outlines, NULL: none */
    int32_t vertex_count, triangle_count;
    double *vertices;   /* (vertex_count x 3) of the rings: what measures and contact know */
    double *normals;    /* (vertex_count x 3) */
    int32_t *triangles; /* (triangle_count x 3) */
    double *ring;         /* (rings of all limbs) s of each */
    double fillet;        /* width of the skin's fillets where limbs meet [m], 0: limbs stay as they are */
    double *skin;         /* (vertex_count + digit_vertices x 3) of the picture: limbs grown together where they meet */
    double *skin_normals; /* (vertex_count + digit_vertices x 3) */
    int32_t digit_vertices, digit_triangles; /* fingers and toes, of the picture alone; after all limbs */
    mus__rig rig;
    mus__frame *frame; /* (parts) of a posed body, NULL: in the rest pose */
    mus_pose pose;     /* of a posed body */
    mus__field *field; /* (nfield), one a part, in the order of the rig's parts */
    int32_t nfield;
};

/* a limb sampled at n directions: radii and slopes at its contours, ready for the in-between contours */
typedef struct mus__stack {
    const mus__limb *limb;
    int32_t n;
    const double *turn; /* (n x 2) cos, sin of the directions */
    double *radius;     /* (count x n) */
    double *slope;      /* (count x n) d radius / d s */
    double *centre;     /* (count x 2) */
    double *drift;      /* (count x 2) d centre / d s */
    double cap[2][2];   /* of the closing caps below and above: s of the ellipse's middle, half axis */
    double *work;       /* (count + 3 n): of the slopes, then 3 n of who asks rings */
} mus__stack;

/* ---- body_contour.c ---- */

/* half breadth of a superellipse of that girth: exact for n = 2 (paper eq. 6), an estimate to 1 % up to n = 3 */
double mus__contour_half_breadth(double girth, double ratio, double n);
/* depth to breadth of a thigh of that girth which is to be no broader than half the hip of half breadth `hip` */
double mus__contour_thigh_ratio(double girth, double hip);
/* radius of a contour in the direction (cos, sin) */
double mus__contour_radius(const mus__contour *contour, double cosine, double sine);
/* radii in n directions that are symmetric about both axes, n a multiple of 4 and at most MUS_BODY_SAMPLES */
void mus__contour_radii(const mus__contour *contour, int32_t n, const double *turn, double *radius);
/* girth of the contour sampled at n equal angles, as a tape lies; xy (2n), work (2n) */
double mus__contour_tape(const mus__contour *contour, int32_t n, const double *turn, double *xy, int32_t *work);
/* scale a contour until that girth is `girth` */
void mus__contour_fit(mus__contour *contour, double girth, int32_t n, const double *turn, double *xy, int32_t *work);

/* ---- body_posture.c: how a person holds back and head ---- */

bool mus__posture_none(const mus_body_def *def);
mus_status mus__posture_check(mus_context *context, const mus_body_def *def, double stature);
/* shoulder joints, and where shoulders and bust stand */
void mus__posture_bones(const mus_body_def *def, mus__skeleton *bone);
/* the fitted contours of the torso */
void mus__posture_torso(const mus_body_def *def, const mus__skeleton *bone, mus__limb *torso);

/* ---- body_without.c, body_given.c: what is left out of a body of a tape, and what is added ---- */

/* cut the fitted limbs to what body->def.without leaves */
void mus__body_without(mus_body *body);
/* read a given limb, the l-th of a list, and its outlines' places */
mus_status mus__body_given_limb(mus_context *context, int32_t l, const mus_limb *from, mus__limb *to);

/* ---- body_outline.c: contours given by their corners ---- */

/* radius of an outline in the direction (cos, sin): along the ray to the chord between two corners */
double mus__outline_radius(const mus__contour *contour, double cosine, double sine);
/* read the outlines of given limbs, which stand in the body from limb `first` on, into body->outline, after their
 * centres; refuses what is not star-shaped */
mus_status mus__body_outlines(mus_body *body, int32_t first, int32_t limbs, const mus_limb *limb);

/* ---- body_torso.c, body_limbs.c: the contours of each limb from the tape; shapes only, not yet fitted ---- */

void mus__body_torso(const mus_tape *tape, const mus__skeleton *skeleton, mus__limb *limb);
void mus__body_arm(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, mus__limb *limb);
/* hip: the fitted contour of the torso that the legs grow out of */
void mus__body_leg(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, const mus__contour *hip,
                   mus__limb *limb);
void mus__body_foot(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, mus__limb *limb);

/* ---- body_stack.c ---- */

/* contours in order and far enough apart: soft ones in the way are left out, two hard ones are MUS_ERR_BODY */
mus_status mus__limb_check(mus_context *context, mus__limb *limb, double gap);
mus_status mus__stack_make(mus_context *context, const mus__limb *limb, int32_t n, const double *turn, mus__stack *out);
void mus__stack_free(mus_context *context, mus__stack *stack);
/* mark the contours of a limb where the natural spline overshoots, then take the stack's slopes anew */
void mus__stack_limit(mus__stack *stack, mus__limb *limb);
/* the in-between contour at s: centre (2), radius (n) */
void mus__stack_ring(const mus__stack *stack, double s, double *centre, double *radius);

/* ---- body.c, body_make.c: what bodies from a tape and bodies of given limbs share ---- */

mus_status mus__body_read_def(mus_context *context, const mus_body_def *def, mus_body_def *own);
/* room for `count` limbs, empty */
mus_status mus__body_limbs(mus_body *body, int32_t count);
/* n directions (n x 2) at equal angles, exact at the quarters; n a multiple of 4 */
void mus__body_turns(int32_t n, double *turn);
/* stacks of all limbs to the surface; turn (def.samples x 2) */
mus_status mus__body_surface_of(mus_body *body, const double *turn);
/* the rig, and the contact fields of all its parts, rings about `spacing` apart */
mus_status mus__body_fields(mus_body *body, double spacing);

/* ---- rig.c ---- */

/* the middle of a limb at s, linear between its contours, as it was made */
void mus__rig_middle(const mus__limb *limb, double s, double *out);

/* ---- body_surface.c, body_measure.c ---- */

/* normals (rings n + 2 x 3) of an end point, rings of n and an end point, from ring `from` on */
void mus__surface_normals(const double *x, int32_t n, int32_t rings, int32_t from, double *normals);
/* triangles (2 rings n x 3) of the same, the first end point being `vertex` */
void mus__surface_triangles(int32_t vertex, int32_t rings, int32_t n, int32_t *out);
/* triangulate all limbs; stack (limb_count) sampled at def.samples equal angles */
mus_status mus__body_surface(mus_body *body, const mus__stack *stack);
/* fill body->made from the vertices */
mus_status mus__body_remeasure(mus_body *body);

/* ---- body_follow.c ---- */

/* the fitted contours of the torso follow the bust span and the crotch length that a sheet gives */
mus_status mus__body_follow(mus_body *body, const mus_tape *tape, const double *turn, double *xy, int32_t *work);
/* X of the foremost place by the parabola through three: (x, how far ahead) each */
double mus__span_side(const double *before, const double *at, const double *after);

/* ---- body_length.c ---- */

/* the lengths in body->made: along the skin; needs the fields */
mus_status mus__body_lengths(mus_body *body);

/* ---- skin.c ---- */

/* the skin from the surface of the limbs; needs the fields */
mus_status mus__body_skin(mus_body *body);
/* fingers and toes: how much they are, and their vertices, normals and triangles after those of the limbs */
void mus__digit_counts(const mus_body *body, int32_t *vertices, int32_t *triangles);
void mus__digit_make(mus_body *body);
/* ---- seat.c ---- */

/* the cleft of the seat, in the finished skin */
void mus__skin_seat(mus_body *body);

/* ---- shape.c ---- */

/* face, palms and feet: vertices of the skin and their normals */
void mus__skin_shape(mus_body *body);

/* ---- field.c ---- */

/* directions (n x 2) of n equal steps of the diamond angle */
void mus__field_turns(int32_t n, double *turn);
/* sample a part of a stack at those directions into a field, rings about `spacing` apart */
mus_status mus__field_make(mus_context *context, const mus__stack *stack, const mus__part *part, double spacing,
                           mus__field *out);
void mus__field_free(mus_context *context, mus__field *field);

#endif
