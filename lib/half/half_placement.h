/*
 * half_placement.h: start positions of the panels of the half round the body. Doubling mirrors them to the other half.
 */
#ifndef MUS_PANEL_PLACE_H
#define MUS_PANEL_PLACE_H

#include "half/half_garment.h"

/* Bends a front or back before or behind the torso: `width` is half its width, y = 0 at `height` above the floor
 * [m]. */
void mus__panel_place_torso(mus__half *half, int32_t panel, bool front, double width, double height);
/* Bends a front or back to half a ring round the hips; `width`: widest half front and half back together [m]. */
void mus__panel_place_hips(mus__half *half, int32_t panel, bool front, double width, double height);
/* Rolls a sleeve of `width` round the left arm with its crown (crown_x, crown_y) at the shoulder point. */
void mus__panel_place_arm(mus__half *half, int32_t panel, double crown_x, double crown_y, double width);
/* Rolls a band or collar about an upright axis through neck or torso, x = 0 at centre front or back, y = 0 at `height`
 * above the floor; `girth` of the roll [m]. */
void mus__panel_place_ring(mus__half *half, int32_t panel, bool front, double girth, double height);

/* Widens the interval y (2) [m] to the heights of the control points of a panel as it is placed. */
void mus__panel_heights(const mus__board *board, int32_t panel, double *y);

/* Turns a panel to azimuth `around` (from the front to the left), leans its top in by `tilt` [rad] and bends it by
 * radius `bend` [m]. */
void mus__lower_place(mus__half *half, int32_t panel, double around, double tilt, const double *origin, double bend);
/* Bends a front or back to half a ring of `girth` round the waist, y = 0 at `height`. */
void mus__lower_place_waist(mus__half *half, int32_t panel, bool front, double girth, double height);
/* Places a trouser leg before or behind the left leg. crease: x of its crease; inner: from the crease to the fork;
 * girth: of front and back on the crotch line; away: least distance from the middle plane of the body [m]. */
void mus__lower_place_leg(mus__half *half, int32_t panel, bool front, double crease, double inner, double girth,
                          double away);

#endif
