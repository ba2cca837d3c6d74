/*
 * body_make.h: the steps of making a body, in their order.
 */
#ifndef MUS_BODY_BODY_MAKE_H
#define MUS_BODY_BODY_MAKE_H

#include "body/body_internal.h"
#include "limb/contour_stack.h"

/* ---- body_make.c: options, limbs, surface, fields, for whoever gave the contours ---- */

/* read and check the options of a body. Errors: MUS_ERR_ARG, MUS_ERR_VERSION */
mus_status mus__body_read_def(mus_context *context, const mus_body_def *def, mus_body_def *own);
/* allocate `count` empty limbs. Errors: MUS_ERR_MEMORY */
mus_status mus__body_limbs(mus_body *body, int32_t count);
/* the rig, and the radius fields of all its parts with rings about `spacing` [m] apart; the right limbs of a symmetric
 * body get their radii by mus__body_mirror(). Errors: MUS_ERR_MEMORY */
mus_status mus__body_fields(mus_body *body, double spacing);

/* directions of the rings of limb l in the surface: mus_body_def.samples, for thin limbs of a tape half as many */
int32_t mus__body_samples(const mus_body *body, int32_t l);
/* steps of the diamond angle of the fields of limb l: its samples, but no fewer than a table needs */
int32_t mus__body_angles(const mus_body *body, int32_t l);

/* cubic step: 0 for t <= 0, 1 for t >= 1 */
double mus__cubic_step(double t);

/* ---- body_level.c ---- */

/* the levels of a body made from a tape, from its skeleton, limbs and rig, into body->level */
void mus__body_find_levels(mus_body *body);

/* ---- body_posture.c ---- */

/* whether the options ask for the upright posture */
bool mus__posture_none(const mus_body_def *def);
/* check the posture against its ranges for a stature [m]. Errors: MUS_ERR_ARG */
mus_status mus__posture_check(mus_context *context, const mus_body_def *def, double stature);
/* move shoulder joints, shoulders and bust of the skeleton forwards or backwards */
void mus__posture_bones(const mus_body_def *def, mus__skeleton *bone);
/* move the fitted contours of the torso */
void mus__posture_torso(const mus_body_def *def, const mus__skeleton *bone, mus__limb *torso);

/* ---- body_fit_lengths.c ---- */

/* change the fitted contours of the torso so that bust span and crotch length are the tape's, where it gives them;
 * `more` [m] is added to the crotch length, for what the finished surface lacks. Scratch as mus__contour_fit(). Errors:
 * MUS_ERR_MEMORY */
mus_status mus__body_follow(mus_body *body, const mus_tape *tape, double more, const double *turn, double *xy,
                            int32_t *work);

/* ---- limbs_left_out.c, body_from_limbs.c, body_outline.c: limbs left out, and limbs given by the caller ---- */

/* mark or cut the fitted limbs that body->def.without names */
void mus__body_without(mus_body *body);
/* read a given limb, number l of its list, without the corners of outlines. Errors: MUS_ERR_ARG, MUS_ERR_VERSION,
 * MUS_ERR_BODY */
mus_status mus__body_given_limb(mus_context *context, int32_t l, const mus_limb *from, mus__limb *to);
/* read the outlines of given limbs, which are limbs `first` ... of the body, into body->outline, relative to the
 * centres of their contours. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY, MUS_ERR_BODY (an outline that is not star-shaped) */
mus_status mus__body_outlines(mus_body *body, int32_t first, int32_t limbs, const mus_limb *limb);

/* ---- body_surface.c, ring_mesh.c ---- */

/* section of limb l at s: centre (2) and radii (n) in the directions that mus__field_steps() placed in the tables */
void mus__body_section(const mus_body *body, int32_t l, double s, int32_t n, const int32_t *entry, const double *share,
                       double *centre, double *radius);
/* free fields, fillets and surface, to make them again */
void mus__body_release(mus_body *body);
/* rings, vertices, normals and triangles of all limbs, from the fields. Errors: MUS_ERR_MEMORY */
mus_status mus__body_surface(mus_body *body);
/* normals (rings n + 2 x 3) of the closed surface of an end point, rings of n vertices, and an end point, from ring
 * `from` on */
void mus__ring_normals(const double *x, int32_t n, int32_t rings, int32_t from, double *normals);
/* triangles (2 rings n x 3) of such a surface whose first end point has the index `vertex` */
void mus__ring_triangles(int32_t vertex, int32_t rings, int32_t n, int32_t *out);

/* ---- body_measure.c, body_length.c ---- */

/* girths and heights in body->made, from the vertices. Errors: MUS_ERR_MEMORY */
mus_status mus__body_remeasure(mus_body *body);
/* lengths in body->made, along the surface; needs the fields. Errors: MUS_ERR_MEMORY */
mus_status mus__body_lengths(mus_body *body);

/* ---- give.c: girths kept by the finished surface ---- */

/* scale the rings of limb l about its contour i, and the contour, by 1 + more; turn: the directions of its fields */
void mus__give_scale(mus_body *body, int32_t l, int32_t i, double more, const double *turn);
/* girth [m] of a tape round n points at the radii (n) in the directions `turn` (n x 2). Scratch: xy (2n), work (2n) */
double mus__give_tape(int32_t n, const double *turn, const double *radius, double *xy, int32_t *work);
/* scale the rings about all contours with a girth until the surface has it. Errors: MUS_ERR_MEMORY */
mus_status mus__body_give(mus_body *body);
/* whether the tape of a girth lies over the legs too, which stand out of the torso there */
bool mus__girth_has_legs(int32_t girth);

/* ---- skin_posed.c ---- */

/* vertices of a posed body near bent joints, on the parts */
void mus__body_skin(mus_body *body);

/* ---- skin_fillet.c, relief.c, fingers_toes.c: shapes added to the limbs. Fillets and details are written into the
 * fields; with def.plain there are no details and no fingers and toes ---- */

/* fillets of a width `reach` [m] where limbs meet, in the fields; 0: none. Errors: MUS_ERR_MEMORY */
mus_status mus__body_fillets(mus_body *body, double reach);
/* depth [m] of the cleft of the seat in the middle plane, at height y and Z = z [m] */
double mus__relief_cleft(const mus_body *body, double y, double z);
/* face, arch of the feet and cleft of the seat, in the fields. Errors: MUS_ERR_MEMORY */
mus_status mus__body_relief(mus_body *body);
/* how far [m] the ring at s of limb l is drawn below its place on the axis: hands and feet end where fingers and toes
 * begin */
double mus__relief_short(const mus_body *body, int32_t l, double s);
/* number of vertices and triangles of fingers and toes */
void mus__digit_counts(const mus_body *body, int32_t *vertices, int32_t *triangles);
/* write vertices, normals and triangles of fingers and toes after those of the limbs */
void mus__digit_make(mus_body *body);

#endif
