/*
 * waist_edge.h: what the files of the lower body share: girths of the body at a level, the waist as a run over panels.
 *
 * Levels are heights above the natural waist (below it negative). Formulas: man page mus_design(3).
 */
#ifndef MUS_WAIST_EDGE_H
#define MUS_WAIST_EDGE_H

#include "half/half_placement.h"
#include "half/panel_outline.h"
#include "style/style_parts.h"

#define MUS__WAIST_SIDES 32 /* half-edges of one waist */

/* Adds the top edge to an outline, from the side to the centre: edges w1.. labelled "waist" and the dart legs d1..
 * between them. dart (n x 6): inner mouth, point, outer mouth; part (n + 1): the waist between the darts; both from the
 * centre outwards. */
void mus__lower_top(mus__outline *outline, int32_t n, const double (*dart)[6], const mus__chain *part);

/* Girth of the body at a level between underbust and hip [m]. */
double mus__lower_girth(const mus__half *half, double level);
/* Level of the top edge of the skirt or trousers without their band: the waist, lower by a low rise or a shaped
 * band. */
double mus__lower_level(const mus__half *half);
/* Whether the skirt or trousers are sewn to the waist of a bodice. */
bool mus__lower_has_top(const mus__half *half);
/* Sewn length of the front or back half of the top edge at a level: a quarter of girth and ease, `more` added in front
 * and taken off behind [m]. Under a bodice: the length of its waist. */
double mus__lower_net(const mus__half *half, bool front, double level, double more);
/* Ease on the waist of skirt or trousers [m]: half->waist_ease; without a bodice at most 0.1 of hip less waist, so that
 * the garment hangs on the hips. */
double mus__lower_waist_ease(const mus__half *half);

/* Half of the least girth of a waist without an opening, that is pulled on over the hip [m]. */
double mus__lower_pulled(const mus__half *half);

/* Writes the half-edges labelled "waist" of panels first..last - 1 in the order of the boundary loop. Returns how many,
 * at most MUS__WAIST_SIDES. */
int32_t mus__lower_waist(const mus__half *half, int32_t first, int32_t last, int32_t *sides);
/* Arc length from the centre of the joint of the bodice's waist nearest to s (darts closed), if one lies within
 * `reach`; else s. */
double mus__lower_snap(const mus__half *half, bool front, double s, double reach);
/* Sews the waist of the panels from `first` on to the waist of the bodice, if there is one. */
void mus__lower_waist_sew(mus__half *half, int32_t first);

/* ---- skirts: each draws its panels on the board of the half and sews all but their waist ---- */

double mus__skirt_length(const mus__half *half);
void mus__skirt_gores(mus__half *half);
void mus__skirt_round(mus__half *half);
void mus__skirt_gathered(mus__half *half);

#endif
