/*
 * half_garment.h: the half garment under drafting, which the parts of lib/style work on.
 *
 * A garment is drafted as its left half on a cutting table (board.h): blocks are drawn, the words work on them by
 * separating and rotating, and at the end the half is doubled.
 *
 * Frame of every panel of the half: the blocks' (x from the centre line outwards, y up), as seen from outside: "front"
 * is the wearer's left front with x >= 0 to the side; "back" is the left back, so its x is mirrored: x <= 0 to the
 * side; "sleeve" is the left one, front at x < 0. Outlines run counter-clockwise.
 *
 * Half-edges are found by label, since shaping cuts panels apart: a run of half-edges of one label, in order, is where
 * the next part is sewn on (mus__board_run(), mus__board_sew()):
 *   "neck"     front: from the shoulder to the centre; back: from the centre to the shoulder
 *   "armhole"  front: from the underarm to the shoulder; back: from the shoulder to the underarm
 *   "shoulder", "side", "waist" (where a skirt, trousers or a band is sewn on), "hem", "cuff", "centre" (cf, cb)
 * A label stays on a half-edge that is sewn later; openings are declared by mus__board_opening_add() from the openings
 * that the garment should have (neck, cuffs or armholes, waist, hem or hems).
 *
 * A panel that is cut off "front" is called "front_...", one cut off "back" "back_...", and a run may go over several
 * panels: mus__half_boundary() follows the boundary loop of the cloth sewn so far. A closure is drawn done up: a front
 * that buttons, a back or side that zips is a seam (MUS__CENTRE_SEAM), with its extension as allowance, buttons and the
 * zip's end as marks.
 * Openings of a top: neck, two armholes (or cuffs), hem or waist; neck=halter: neck, one "armhole" that runs round both
 * arms and the back, hem or waist; neck=strapless: neck, hem or waist.
 */
#ifndef MUS_HALF_HALF_GARMENT_H
#define MUS_HALF_HALF_GARMENT_H

#include "block/block_bodice.h"
#include "board/board_cut.h"
#include "board/board_dart.h"
#include "board/board_seam.h"
#include "half/style_axes.h"
#include "limb/skeleton.h"
#include "muslin/design.h"

/* allowances of dressmaking practice [m]: a seam that is pressed open; a hem that is turned twice */
#define MUS__SEAM_ALLOWANCE 0.010
#define MUS__HEM_ALLOWANCE 0.025
#define MUS__BUTTON_STAND (1.75 * MUS__CM) /* [m] a front laps over its centre by; the diameter of a button */
#define MUS__UNDERLAP (3.5 * MUS__CM) /* [m] of a band, and the shield below it; chosen: practice has 3 to 4 cm */
#define MUS__ZIP (18.0 * MUS__CM) /* [m] length of a zip at the waist: the hips pass it; of dressmaking practice */
/* length of a rib as part of the edge that it is sewn to; chosen: between the 0.85 and 0.9 of cutting practice */
#define MUS__RIB_PART 0.87
#define MUS__RIB_HEIGHT (6.0 * MUS__CM) /* [m] of the rib of a leg or a hem; chosen: the trade has 5 to 8 */
#define MUS__RIB_BLOUSE (2.0 * MUS__CM) /* [m] of what is above a rib falls over it; chosen */

typedef struct mus__half {
    mus_context *context;
    mus__measures measures;
    mus__skeleton skeleton;
    mus_draft_def def; /* options of the caller; NaN: not given */
    mus__style style;
    mus__board board;
    mus__bodice bodice;             /* of a garment with a top */
    double bust_ease;               /* ease on the bust girth [m], by the words or as given by the caller */
    double waist_ease, hip_ease;    /* ease on waist and hip [m], one for a top and the skirt sewn to it.
                                       mus__top_draft() sets waist_ease to that of the waist as drawn */
    double neck_gathers;            /* length of the front neck before gathering less after [m]; 0: no gathers */
    double waist_level;             /* height above the floor of y = 0 of the torso panels [m] */
} mus__half;

/* whether the style of the half has `option` on `axis` */
bool mus__style_is(const mus__half *half, int32_t axis, int32_t option);
/* Factor for lengths in centimetres below the waist: min(1, waist to hip / 20 cm). */
double mus__lower_scale(const mus__half *half);
/* Sets the status of the board to that of a block that failed; its message is in the context. */
void mus__half_failed(mus__half *half, mus_status status);

/* Sets how a half-edge on the centre line is doubled (MUS__CENTRE_*). */
void mus__half_centre(mus__half *half, int32_t panel, const char *name, int32_t centre);
/* Sews half-edge `a` to `b` by name, right sides out; ease: intended length of b less that of a [m]. */
void mus__half_sew(mus__half *half, int32_t panel_a, const char *a, int32_t panel_b, const char *b, double ease);
/* Sews the legs of the darts "d1" "d2" and "d3" "d4" of a panel. */
void mus__half_darts(mus__half *half, int32_t panel);

/* Sets how many pieces of a panel of the half are cut: of the main cloth, of interfacing, lining or rib (material
 * MUS_MATERIAL_*). Doubling the half doubles both where the panel gets a mirror image. */
void mus__half_cut(mus__half *half, int32_t panel, int32_t main, int32_t material, int32_t count);
/* sets the grain of a band that is drawn along x, once it is known what it is cut of: along the band, which then does
 * not give; across it in a knit or a rib, which stretches most across its grain, round the body */
void mus__half_band_grain(mus__half *half, int32_t panel);

/* Adds a half-edge at the end of the last one of the panel; returns it. label NULL: none. */
int32_t mus__chain_side(mus__board *board, int32_t panel, const char *name, const char *label, double allowance,
                        const mus__chain *chain);

#endif
