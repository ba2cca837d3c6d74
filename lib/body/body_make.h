/*
 * body_make.h: the steps of making a body, in their order.
 */
#ifndef MUS_BODY_BODY_MAKE_H
#define MUS_BODY_BODY_MAKE_H

#include "body/body_internal.h"
#include "limb/stack.h"

/* ---- body_make.c: options, limbs, surface, fields, for whoever gave the contours ---- */

mus_status mus__body_read_def(mus_context *context, const mus_body_def *def, mus_body_def *own);
/* room for `count` limbs, empty */
mus_status mus__body_limbs(mus_body *body, int32_t count);
/* stacks of all limbs to the surface; turn (def.samples x 2) */
mus_status mus__body_surface_of(mus_body *body, const double *turn);
/* the rig, and the contact fields of all its parts, rings about `spacing` apart */
mus_status mus__body_fields(mus_body *body, double spacing);

/* ---- body_posture.c: how a person holds back and head ---- */

bool mus__posture_none(const mus_body_def *def);
mus_status mus__posture_check(mus_context *context, const mus_body_def *def, double stature);
/* shoulder joints, and where shoulders and bust stand */
void mus__posture_bones(const mus_body_def *def, mus__skeleton *bone);
/* the fitted contours of the torso */
void mus__posture_torso(const mus_body_def *def, const mus__skeleton *bone, mus__limb *torso);

/* ---- body_follow.c ---- */

/* the fitted contours of the torso follow the bust span and the crotch length that a sheet gives */
mus_status mus__body_follow(mus_body *body, const mus_tape *tape, const double *turn, double *xy, int32_t *work);
/* X of the foremost place by the parabola through three: (x, how far ahead) each */
double mus__span_side(const double *before, const double *at, const double *after);

/* ---- body_without.c, body_given.c, body_outline.c: limbs left out, and limbs given by the caller ---- */

/* cut the fitted limbs to what body->def.without leaves */
void mus__body_without(mus_body *body);
/* read a given limb, the l-th of a list, and its outlines' places */
mus_status mus__body_given_limb(mus_context *context, int32_t l, const mus_limb *from, mus__limb *to);
/* read the outlines of given limbs, which stand in the body from limb `first` on, into body->outline, after their
 * centres; refuses what is not star-shaped */
mus_status mus__body_outlines(mus_body *body, int32_t first, int32_t limbs, const mus_limb *limb);

/* ---- body_surface.c, ring_mesh.c ---- */

/* triangulate all limbs; stack (limb_count) sampled at def.samples equal angles */
mus_status mus__body_surface(mus_body *body, const mus__stack *stack);
/* normals (rings n + 2 x 3) of an end point, rings of n and an end point, from ring `from` on */
void mus__ring_normals(const double *x, int32_t n, int32_t rings, int32_t from, double *normals);
/* triangles (2 rings n x 3) of the same, the first end point being `vertex` */
void mus__ring_triangles(int32_t vertex, int32_t rings, int32_t n, int32_t *out);

/* ---- body_measure.c, body_length.c ---- */

/* fill body->made from the vertices */
mus_status mus__body_remeasure(mus_body *body);
/* the lengths in body->made: along the skin; needs the fields */
mus_status mus__body_lengths(mus_body *body);

/* ---- skin.c, digit.c, seat.c, shape.c: the published skin ---- */

/* the skin from the surface of the limbs; needs the fields */
mus_status mus__body_skin(mus_body *body);
/* fingers and toes: how much they are, and their vertices, normals and triangles after those of the limbs */
void mus__digit_counts(const mus_body *body, int32_t *vertices, int32_t *triangles);
void mus__digit_make(mus_body *body);
/* the cleft of the seat, in the finished skin */
void mus__skin_seat(mus_body *body);
/* face, palms and feet: vertices of the skin and their normals */
void mus__skin_shape(mus_body *body);

#endif
