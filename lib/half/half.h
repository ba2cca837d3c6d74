/*
 * half.h: the half garment in the making: what the parts of lib/style work on.
 *
 * A garment is drafted as its left half on a cutting table (board.h): blocks are drawn, the words work on them by
 * separating and rotating, and at the end the half is doubled. Founding paper, section 5.2.
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
#ifndef MUS_HALF_H
#define MUS_HALF_H

#include "block/block_bodice.h"
#include "board/board_cut.h"
#include "board/board_dart.h"
#include "board/board_fullness.h"
#include "board/board_sew.h"
#include "half/style.h"
#include "limb/skeleton.h"
#include "muslin/design.h"

typedef struct mus__half {
    mus_context *context;
    mus__measures measures;
    mus__skeleton skeleton;
    mus_draft_def def; /* the caller's wishes; NaN where there is none */
    mus__style style;
    mus__board board;
    mus__bodice bodice;             /* of a garment with a top */
    double bust_ease;               /* total, of the ease level and the cloth, or the caller's wish for a top */
    double waist_ease, hip_ease;    /* total, one value for top and skirt or trousers, so that they meet. Where a top
                                       has no waist darts, mus__top_draft() sets waist_ease to what it has become */
    double neck_gathers;            /* length that the front neck is gathered to over its own; 0: it is not */
    double waist_level;             /* height above the floor of y = 0 of torso panels [m] */
} mus__half;

/* whether the style of the half has `option` on `axis` */
bool mus__style_is(const mus__half *half, int32_t axis, int32_t option);
/* a block failed, its sentence is in the context: the board has failed too */
void mus__half_failed(mus__half *half, mus_status status);

/* what becomes of a side at the centre line (MUS__CENTRE_*) */
void mus__half_centre(mus__half *half, int32_t panel, const char *name, int32_t centre);
/* sew two sides by name, right sides out; ease = length of b less length of a that is meant */
void mus__half_sew(mus__half *half, int32_t panel_a, const char *a, int32_t panel_b, const char *b, double ease);
/* both legs of the darts "d1" "d2", "d3" "d4" of a panel */
void mus__half_darts(mus__half *half, int32_t panel);

/* a side that starts where the last one of the panel ended */
int32_t mus__chain_side(mus__board *board, int32_t panel, const char *name, const char *label, double allowance,
                        const mus__chain *chain);

#endif
