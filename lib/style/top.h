/*
 * top.h: what the files of a top share: a front or back half as a list of edges in the block's frame, and the steps
 * from the blocks to the sewn body of the garment.
 *
 * top.c drafts the blocks and draws them; neckline.c draws what lies between the underarm and the centre; shaping.c
 * moves the darts and cuts the panels apart; closure.c says what becomes of the centre lines; yoke.c cuts the yoke.
 */
#ifndef MUS_TOP_H
#define MUS_TOP_H

#include "half/boundary.h"
#include "half/panel_outline.h"
#include "half/panel_place.h"
#include "style/parts.h"

#define MUS__TOP_SEAM (1.0 * MUS__CM)
#define MUS__TOP_NECK_SEAM (0.7 * MUS__CM)
#define MUS__TOP_HEM (2.5 * MUS__CM)

#define MUS__TOP_RUN 32 /* sides of one run */

/* figures of a top that its steps share */
typedef struct mus__top {
    double scale;    /* of lengths in the recipes: 1, less on a small body */
    double hem;      /* y of the lower edge */
    double side_in;  /* side seam taken in at the waist */
    double hip_out;  /* at the hip level wider than at the waist by; of a boxy top straight down to the hem */
    double hip;      /* y of the hip level */
    double low;      /* underarm lower along the side seam by */
    bool darts;      /* there is shaping at the waist */
    bool waist_darts[2]; /* and its darts are drawn, not worked out of the panel later */
    bool meet;           /* the front's ends in the bust point */
    double point_back;   /* the bust dart is drawn to so far before the bust point */
    mus__chain neck[2], arm[2]; /* front, back: side neck to centre; underarm to shoulder point */
    bool shoulder[2];           /* has a shoulder edge; else neck follows the underarm, and arm is empty */
    const char *neck_label[2];         /* label of the neck edge */
    int32_t panel[2];           /* front, back */
} mus__top;

#define MUS__TOP_FRONT 0
#define MUS__TOP_BACK 1

/* the underarm, lower along the side by top->low: with the bust dart closed, and as it lies in the drawing */
void mus__top_under(const mus__half *half, const mus__top *top, bool front, double *closed, double *turned);
/* side edges from the hem to the underarm; in front with the bust dart open about the bust point */
void mus__top_side(const mus__half *half, const mus__top *top, bool front, mus__outline *outline);
/* the lower edge from the centre to `end` at the side, with the waist darts of the block: w1, wd1, wd2, w2, ... */
void mus__top_low(const mus__half *half, const mus__top *top, int32_t which, const double *end, mus__outline *outline);
/* whether the lower edge is a hem; else it is a waist line, labelled "waist": of a dress, a jumpsuit, a block */
bool mus__top_hem(const mus__half *half);
/* half a waist dart (inner mouth, point, outer mouth) from the lower edge to its point, on the side `turn` (-1 towards
 * the centre) of its upright axis */
void mus__top_dart_leg(const mus__top *top, const double *dart, double turn, mus__chain *out);
/* neckline.c: move side necks and centres of the blocks, fill neck, arm and shoulder of `top` */
void mus__neckline_draw(mus__half *half, mus__top *top);
/* neckline.c: the strap of a halter, sewn to the front */
void mus__neckline_strap(mus__half *half);
/* neckline.c: what keeps a strapless top up */
void mus__neckline_hold(mus__half *half);
/* turn p about o by angle a */
void mus__top_turn(const double *p, const double *o, double a, double *out);

/* ---- shaping.c ---- */

/* which darts are drawn for the shape to begin with */
void mus__shaping_plan(const mus__half *half, mus__top *top);
/* darts and cuts, on the panels as drawn */
void mus__shaping_work(mus__half *half, mus__top *top);
/* shaping_dart.c: rotate `fraction` of the bust dart ("bd1") about its point to arc length s of half-edge `target`; the
 * part with half-edge `keep` stays. Returns the leg of the dart that opens, MUS_NONE without a bust dart */
int32_t mus__shaping_turn(mus__half *half, mus__top *top, int32_t target, double s, double fraction, int32_t keep);
/* a side of the front or back panel by name, "low" for the lower edge */
int32_t mus__shaping_side(const mus__half *half, const mus__top *top, int32_t which, const char *name);
/* a side and those of its label after it drawn again as one cubic with the end tangents */
void mus__shaping_smooth(mus__board *board, int32_t side);
/* the same for an armhole of a curve, the line across a mouth and a curve: both curves are kept */
void mus__shaping_smooth_arm(mus__board *board, int32_t side);

/* ---- shaping_cut.c ---- */

void mus__shaping_princess(mus__half *half, mus__top *top, bool armhole);
void mus__shaping_empire(mus__half *half, mus__top *top);
/* yoke.c: the upper back and 2 cm of the front's shoulder in one piece */
void mus__shaping_yoke(mus__half *half, mus__top *top);

/* ---- shaping_gather.c ---- */

void mus__shaping_neck_gathers(mus__half *half, mus__top *top);
void mus__shaping_centre_gathers(mus__half *half, mus__top *top);

/* closure.c: centre sides and marks */
void mus__closure_set(mus__half *half);

#endif
