/*
 * collider.h: the surfaces that cloth meets: the parts of a body and planes.
 *
 * A body is a set of rigid parts; each has a radius field: the radius of its section by height along the part's axis
 * and by direction (limb/radius_field.h). The distance of a node is found by its height, the section there, and the
 * line from the section's centre to the node (Metaaphanon and Kanongchaiyos 2005, section 4.1): a constant cost a part,
 * no triangle is asked. A part keeps the field that it was made with and is moved by a frame, so a moving part costs
 * what one at rest does. How it came to its place in the last step is two affine maps (mus__surface_motion).
 *
 * The files of this folder in the order of use are listed in collider.c.
 */
#ifndef MUS_CONTACT_COLLIDER_H
#define MUS_CONTACT_COLLIDER_H

#include "base/base_internal.h"
#include "body/rig.h"
#include "muslin/body.h"

#define MUS__PARTS_MAX 64        /* parts of a body: a bit each in a 64-bit mask */
#define MUS__PLANES_MAX 32       /* planes of a scene: a bit each in a 32-bit mask */
#define MUS__TOUCHING_MAX 4      /* surfaces that mus__collider_touching() returns; more are left out */
#define MUS__DISC_THICKNESS 0.01 /* [m] a node further below a disc than this is under it; chosen: a table top */
#define MUS__PLANE_ENDLESS 1e15  /* [m] radius of a plane without an edge: beyond every scene */
#define MUS__PLANE_SAFE_TRAVEL 5e-3 /* [m] a node that moves less in a step is not swept; chosen: half of a disc */

/* motion of a surface in the last step, as affine maps of a place in the state's coordinates (3 rows of a matrix, then
 * the constant): displacement of the surface point that was at x before the step, velocity of the one now at x */
typedef struct mus__surface_motion {
    double displacement[12], velocity[12];
} mus__surface_motion;

typedef struct mus__collider_plane {
    double point[3], normal[3]; /* in the body frame; unit */
    double friction;            /* coefficient; below 0: that of the rule */
    double reach;               /* radius of a disc; 0: endless [m] */
    int32_t moving;             /* nonzero: it moved in the last step */
    mus__surface_motion motion;
} mus__collider_plane;

/* a part as it was made, and its extent */
typedef struct mus__collider_part {
    double origin[3], axis[3], side[3], front[3]; /* in the state's coordinates */
    double end[2], reach;                         /* extent along the axis, and across it [m] */
    double safe;      /* a node that moves no further in a step cannot pass through this part [m] */
    double speed_max; /* bound of this part's surface speed relative to the drift [m/s] */
} mus__collider_part;

struct mus__field_f32;
struct mus__field_f64;

enum { MUS__AT_REST, MUS__TRANSLATED, MUS__TURNED }; /* what the body did in the last step */

typedef struct mus__collider {
    mus_context *context;
    int32_t nparts;                 /* parts of the body, a radius field each */
    double offset;                  /* the fields are those of the surface this far off the skin [m] */
    double origin[3];               /* of the state's coordinates in the body frame */
    struct mus__field_f32 *field32; /* (nparts) where the parts are now */
    struct mus__field_f64 *field64; /* (nparts) */
    double *box;                    /* (nparts x 6) low x, y, z, high x, y, z of the offset surface */
    mus__collider_part *part;       /* (nparts) */
    double safe;                    /* a node that moves no further in a step passes through no surface [m] */
    double shift[3];                /* translation of the whole body since it was made [m] */
    double drift[3];                /* velocity of that translation in the last step [m/s] */
    mus__frame *frame;              /* (nparts) frames of the parts now, without the shift */
    int32_t turned;                 /* nonzero: a part is not at the frame that it was made with */
    int32_t moving;                 /* MUS__AT_REST, MUS__TRANSLATED or MUS__TURNED */
    mus__surface_motion *motion;    /* (nparts) when MUS__TURNED; when MUS__TRANSLATED the first is that of all */
    double speed_max;               /* bound of every surface's speed relative to the drift [m/s] */
    double plane_speed_max;         /* the same of the planes alone [m/s] */
    int32_t nplane;
    mus__collider_plane *plane;          /* (MUS__PLANES_MAX), NULL without planes */
    struct mus__offset_surface *surface; /* tables of the fields, shared by the body's colliders; NULL without a body */
} mus__collider;

/* makes the surfaces of `body` (NULL: none) in coordinates relative to `origin` (3), as the state is: float keeps its
 * digits near it. The fields are those of the surface `offset` [m] off the skin, where cloth is to rest; depths that
 * callers get are below the skin */
mus_status mus__collider_create(mus_context *context, const mus_body *body, const double *origin, double offset,
                                mus__collider **out);
void mus__collider_destroy(mus__collider *collider);

/* ---- motion (collider_motion.c) ---- */

/* puts the parts at `frame` (nparts; NULL: as made), all translated by `shift` (3) [m]. They came there from where they
 * were in a step of `h` [s], the translation with velocity `drift` (3) [m/s]; h 0: they are at rest there */
void mus__collider_move(mus__collider *collider, const mus__frame *frame, const double *shift, const double *drift,
                        double h);
/* puts the fields and the box of part l where its frame has it */
void mus__collider_place(mus__collider *collider, int32_t l);
/* adds a plane at rest: MUS_ERR_LIMIT, MUS_ERR_MEMORY */
mus_status mus__collider_add_plane(mus__collider *collider, const double *point, const double *normal, double friction,
                                   double reach);
/* puts plane k at `point` (3). It came there with `velocity` (3) [m/s], turning about its normal by `spin` [rad/s], in
 * a step of `h` [s]; h 0: it is at rest there */
void mus__collider_move_plane(mus__collider *collider, int32_t k, const double *point, const double *velocity,
                              double spin, double h);
/* works out the speed bounds of all surfaces; after all were moved */
void mus__collider_update_speed(mus__collider *collider);

/* ---- queries ---- */

/* largest depth of a point of the world below the surfaces [m], positive inside, and the outward normal there (3, may
 * be NULL); -1e30 when the point is further than `margin` [m] from all */
double mus__collider_depth(const mus__collider *collider, const double *point, double margin, double *normal);
/* the same of the body alone, without planes and discs */
double mus__collider_body_depth(const mus__collider *collider, const double *point, double margin, double *normal);
/* the parts, a bit each, that may be nearer than `margin` [m] to a box of the world, from low (3) to high (3) */
uint64_t mus__collider_parts_near(const mus__collider *collider, const double *low, const double *high, double margin);
/* mus__collider_body_depth() of some parts, a bit each */
double mus__collider_parts_depth(const mus__collider *collider, uint64_t parts, const double *point, double margin,
                                 double *normal);
/* surfaces nearer to a point of the world than `reach` [m]: outward normals (MUS__TOUCHING_MAX x 3) and friction
 * coefficients (MUS__TOUCHING_MAX), below 0 where the rule's holds. Returns their number */
int32_t mus__collider_touching(const mus__collider *collider, const double *point, double reach, double *normals,
                               double *friction);
/* whether a point of the world lies between surfaces that face each other, both nearer than `reach` [m] */
bool mus__collider_pinches(const mus__collider *collider, const double *point, double reach);

#endif
