/*
 * body_internal.h: the struct of a body: its limbs, rig, surface, skin and radius fields.
 *
 * Read by lib/body, lib/pose, lib/contact, lib/arrange and lib/drape. Everything is made once (body_make.h) and does
 * not change afterwards.
 */
#ifndef MUS_BODY_BODY_INTERNAL_H
#define MUS_BODY_BODY_INTERNAL_H

#include "base/base_internal.h"
#include "body/body_level.h"
#include "body/bones.h"
#include "body/rig.h"
#include "limb/radius_field.h"
#include "limb/skeleton.h"
#include "muslin/body.h"

/* the pose that a copy of a body stands in, as mus_pose has it; lib/pose gives it and reads it, lib/body keeps it */
typedef struct mus__stance {
    double place[3];                  /* [m] */
    double angle[MUS_JOINT_COUNT][3]; /* [rad] */
} mus__stance;

/* what another room made of a body and shares among its users (lib/contact); posed copies of the body share it too.
 * Written by calls that have the body as const: the body's context is used by one thread at a time */
typedef struct mus__body_kept {
    int32_t users;               /* bodies */
    void *data;                  /* NULL: nothing */
    void (*destroy)(void *data); /* called when the last body is destroyed, and before another thing takes its place */
} mus__body_kept;

/* the normal of the skin at an entry of a part's field that a fillet changed: that of the smooth union, equal on the
 * surfaces of both limbs */
typedef struct mus__crease {
    int32_t part, ring, entry;
    double normal[3];
} mus__crease;

struct mus_body {
    mus_context *context;
    mus_body_def def;
    mus__skeleton skeleton;
    double asked[MUS_MEASURE_COUNT], made[MUS_MEASURE_COUNT];
    int32_t source[MUS_MEASURE_COUNT];
    bool measured;   /* made from a tape: it has landmarks and measures */
    bool scanned;    /* made from a mesh: limbs that it lacks cannot be posed */
    bool jointed;    /* made from a tape or a mesh: it has bones and can be posed */
    mus__bones bones;
    mus__limb *limb; /* (limb_count) */
    int32_t limb_count;
    double *outline; /* corners of all contours that are outlines, NULL: none */
    int32_t vertex_count, triangle_count;
    double *vertices;     /* (vertex_count + digit_vertices x 3) the skin: on the surface of the fields [m] */
    double *normals;      /* (vertex_count + digit_vertices x 3) */
    int32_t *triangles;   /* (triangle_count + digit_triangles x 3) */
    double *ring;         /* (rings of all limbs) s of each ring [m] */
    int32_t creases;
    mus__crease *crease;  /* (creases) */
    double fillet;        /* width of the fillets where limbs meet [m], 0: none */
    int32_t digit_vertices, digit_triangles; /* fingers and toes, after all limbs */
    /* whether a part carries digits; x (MUS__DIGITS_VERTICES x 3) gets their vertices in the rest pose then. NULL: none
     * do. A pointer, so that contact does not need the rest of this folder */
    bool (*digits_of)(const struct mus_body *body, int32_t part, double *x);
    mus__rig rig;
    mus__body_level level[MUS__LEVEL_COUNT][2]; /* in the rest pose, left and right; none without a tape */
    mus__frame *frame;  /* (parts) frames of a posed body, NULL: it stands in the rest pose */
    mus__stance stance; /* pose of a posed body */
    mus__field *field;  /* (nfield) one for each part of the rig, in that order */
    int32_t nfield;
    mus__body_kept *kept;
};

/* a finger or toe in the skin: an end point, rings of so many vertices, an end point; chosen */
#define MUS__DIGIT_ROUND 12
#define MUS__DIGIT_RINGS 9
#define MUS__DIGIT_VERTICES (MUS__DIGIT_ROUND * MUS__DIGIT_RINGS + 2)
#define MUS__DIGITS 5 /* of a hand or foot */
#define MUS__DIGITS_VERTICES (MUS__DIGITS * MUS__DIGIT_VERTICES)
/* whether the body has a hand or foot; which: left hand, right hand, left foot, right foot */
bool mus__digit_has(const mus_body *body, int32_t which);

/* copy a body with its parts carried by frames (parts), which are those of the pose `stance`. Errors: MUS_ERR_MEMORY */
mus_status mus__body_copy(const mus_body *body, const mus__frame *frame, const mus__stance *stance, mus_body **out);

/* ---- body_mirror.c ---- */

/* whether the body is symmetric: a body of a tape with all limbs, in the rest pose. Its left half is then made alone */
bool mus__body_is_even(const mus_body *body);
/* whether limb l of a tape is a right one, made by mus__body_mirror() in a symmetric body */
bool mus__limb_is_right(int32_t l);
/* the part that mirrors part q of a symmetric body: that of the limb after a left one */
int32_t mus__mirror_part(const mus_body *body, int32_t q);
/* the radii of the right half of the torso of a symmetric body from those of its left one; with `limbs` the radii and
 * contours of its right limbs instead */
void mus__body_mirror(mus_body *body, bool limbs);

#endif
