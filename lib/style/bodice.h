/*
 * bodice.h: what the files of a top share: the figures of its draft and the steps from the blocks to the sewn body.
 *
 * bodice.c drafts the blocks and draws the panels; bodice_edges.c draws side and lower edge, neckline.c armhole,
 * shoulder and neck; shaping*.c rotate the darts and cut the panels apart; yoke.c cuts the yoke; hem_rib.c sews on a
 * rib; lib/closure sets the centre lines.
 */
#ifndef MUS_BODICE_H
#define MUS_BODICE_H

#include "half/boundary_loop.h"
#include "half/half_placement.h"
#include "half/panel_outline.h"
#include "style/style_parts.h"

#define MUS__TOP_NECK_SEAM (0.7 * MUS__CM) /* [m] allowance of a neck edge: narrow, since it is turned or bound */

#define MUS__TOP_RUN 32 /* half-edges of one run */

/* figures of a top [m] */
typedef struct mus__top {
    double scale;    /* factor k of lengths that are given in centimetres (mus__measures_scale()) */
    double hem;      /* y of the lower edge */
    double side_in;  /* side seam taken in at the waist */
    double hip_out;  /* width at the hip less that at the waist, a half; of a boxy top: at the hem */
    double hip;      /* y of the hip level */
    double low;      /* underarm lower along the side seam by */
    bool darts;      /* whether the top has waist darts or seams */
    bool waist_darts[2]; /* whether waist darts are drawn with the front, back */
    bool meet;           /* whether the front's waist dart ends in the bust point, to be merged with the bust dart */
    double point_back;   /* distance of the drawn point of the bust dart from the bust point */
    mus__chain neck[2], arm[2]; /* front, back: side neck to centre; underarm to shoulder point */
    bool shoulder[2];           /* has a shoulder edge; else the neck edge begins at the underarm, arm is empty */
    const char *neck_label[2];         /* label of the neck edge */
    int32_t panel[2];           /* front, back */
} mus__top;

#define MUS__TOP_FRONT 0
#define MUS__TOP_BACK 1

/* Writes the underarm, lower along the side by top->low: with the bust dart closed, and with it open as drawn. */
void mus__top_under(const mus__half *half, const mus__top *top, bool front, double *closed, double *turned);
/* Adds the side edges from the hem to the underarm; in front with the bust dart open. */
void mus__top_side(const mus__half *half, const mus__top *top, bool front, mus__outline *outline);
/* Adds the lower edge from the centre to `end` at the side with the waist darts: w1, wd1, wd2, w2, ... */
void mus__top_low(const mus__half *half, const mus__top *top, int32_t which, const double *end, mus__outline *outline);
/* Whether the lower edge is a hem; the waist line of a dress, a jumpsuit or a block is labelled "waist". */
bool mus__top_hem(const mus__half *half);
/* neckline.c: moves side neck points and centres of the blocks, fills neck, arm and shoulder of `top` */
void mus__neckline_draw(mus__half *half, mus__top *top);
/* neckline.c: the strap of a halter, sewn to the front */
void mus__neckline_strap(mus__half *half);
/* neckline.c: the attachment that keeps a strapless top or the back of a halter up */
void mus__neckline_hold(mus__half *half);
/* Writes p rotated about o by angle a [rad] to `out`. */
void mus__top_turn(const double *p, const double *o, double a, double *out);

/* ---- shaping.c ---- */

/* chooses the darts that are drawn with the panels */
void mus__shaping_plan(const mus__half *half, mus__top *top);
/* moves darts and cuts panels by the shape of the style */
void mus__shaping_work(mus__half *half, mus__top *top);
/* shaping_dart.c: rotate `fraction` of the bust dart ("bd1") about its point to arc length s of half-edge `target`; the
 * part with half-edge `keep` stays. Returns the leg of the dart that opens, MUS_NONE without a bust dart */
int32_t mus__shaping_turn(mus__half *half, mus__top *top, int32_t target, double s, double fraction, int32_t keep);
/* a half-edge of the front or back panel by name, "low" for the lower edge; MUS_NONE: there is none */
int32_t mus__shaping_side(const mus__half *half, const mus__top *top, int32_t which, const char *name);
/* merges a half-edge with those of its label after it and redraws it as one cubic with the end tangents */
void mus__shaping_smooth(mus__board *board, int32_t side);
/* the same for an armhole made of a curve, the line across a mouth and a curve: both curves are kept */
void mus__shaping_smooth_arm(mus__board *board, int32_t side);

/* ---- shaping_cut.c ---- */

void mus__shaping_princess(mus__half *half, mus__top *top, bool armhole);
void mus__shaping_empire(mus__half *half, mus__top *top);
/* hem_rib.c: what the hem of the body lies above that of the garment by, for `scale` of lengths in centimetres [m]; 0
 * without a rib */
double mus__hem_rib_above(const mus__half *half, double scale);
/* sews a rib to the hem of a top, if the style has one */
void mus__hem_rib_attach(mus__half *half, const mus__top *top);
/* yoke.c: joins the upper back and 2 cm of the front's shoulder to one panel */
void mus__shaping_yoke(mus__half *half, mus__top *top);

/* ---- shaping_gather.c ---- */

void mus__shaping_neck_gathers(mus__half *half, mus__top *top);
void mus__shaping_centre_gathers(mus__half *half, mus__top *top);

#endif
