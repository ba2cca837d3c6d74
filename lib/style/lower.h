/*
 * lower.h: what the files of the lower body share: the waist as a run over panels, girths of the body at a
 * level.
 *
 * Levels are heights above the natural waist (below it negative). Formulas: man page mus_design(3).
 */
#ifndef MUS_LOWER_H
#define MUS_LOWER_H

#include "half/panel_outline.h"
#include "half/panel_place.h"
#include "style/parts.h"

#define MUS__WAIST_SIDES 32 /* half-edges of one waist */

/* the top edge from the side to the centre, as it is walked: "waist" sides w1.. and between them dart legs d1.., from
 * (n x 6) darts: inner mouth, point, outer mouth, from the centre outwards; the parts (n + 1) from the centre outwards,
 * each drawn from the centre outwards */
void mus__lower_top(mus__outline *outline, int32_t n, const double (*dart)[6], const mus__chain *part);

/* girth of the body at a level between underbust and hip */
double mus__lower_girth(const mus__half *half, double level);
/* top edge of the skirt or trousers, its band not counted: the waist, or below it by the rise and a shaped band */
double mus__lower_level(const mus__half *half);
/* 1 for a waist to hip of 20 cm and more, below in proportion */
double mus__lower_scale(const mus__half *half);
/* whether a bodice is on the board, whose waist is sewn to what is drawn */
bool mus__lower_has_top(const mus__half *half);
/* sewn length of the front or back half of the top edge at a level: a quarter of girth and ease, `more` added in front
 * and taken off behind; under a bodice that of its waist */
double mus__lower_net(const mus__half *half, bool front, double level, double more);
/* ease on the waist of skirt or trousers: half->waist_ease, of a garment that hangs on the waist 0.1 of what the hip is
 * larger at most */
double mus__lower_waist_ease(const mus__half *half);

/* half-edges labelled "waist" one after the other along the boundary loop, passing over seams, of the panels
 * from `first` to before `last`; as walked. How many (at most MUS__WAIST_SIDES) */
int32_t mus__lower_waist(const mus__half *half, int32_t first, int32_t last, int32_t *sides);
/* the joint of the bodice's waist nearest to arc length s (darts closed) of the front or back half from the centre, if
 * one is within `reach`; else s */
double mus__lower_snap(const mus__half *half, bool front, double s, double reach);
/* sew the waist of the panels from `first` on to that of the bodice, when there is one */
void mus__lower_waist_sew(mus__half *half, int32_t first);

/* ---- skirts: each draws its panels on the board of the half and sews them but for the waist ---- */

double mus__skirt_length(const mus__half *half);
void mus__skirt_straight(mus__half *half);
void mus__skirt_wrap(mus__half *half);
void mus__skirt_gores(mus__half *half);
void mus__skirt_round(mus__half *half);
void mus__skirt_gathered(mus__half *half);

#endif
