/*
 * panel_place.h: where panels of the half start round the body (those of the other half are mirrored by the doubling).
 */
#ifndef MUS_PANEL_PLACE_H
#define MUS_PANEL_PLACE_H

#include "half/half.h"

void mus__panel_place_torso(mus__half *half, int32_t panel, bool front, double width, double height);
void mus__panel_place_hips(mus__half *half, int32_t panel, bool front, double width, double height);
void mus__panel_place_arm(mus__half *half, int32_t panel, double crown_x, double crown_y, double width);
/* rolled about an upright axis at the height of neck or waist: a band or collar, x = 0 at centre front or back */
void mus__panel_place_ring(mus__half *half, int32_t panel, bool front, double girth, double height);

/* face azimuth `around` from the front to the left, the top leaned in by `tilt`, bent by `bend` */
void mus__lower_place(mus__half *half, int32_t panel, double around, double tilt, const double *origin, double bend);
/* half a ring round the waist */
void mus__lower_place_waist(mus__half *half, int32_t panel, bool front, double girth, double height);
/* before or behind the left leg: the crease (from the centre line) over it, the fork `inner` from the crease; `girth`
 * of front and back on the crotch line; `away` the least distance before or behind the body's middle plane */
void mus__lower_place_leg(mus__half *half, int32_t panel, bool front, double crease, double inner, double girth,
                          double away);

#endif
