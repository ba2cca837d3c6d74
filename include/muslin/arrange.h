/*
 * muslin/arrange.h: where the panels of a pattern are before they are sewn, and what is wrong with an arrangement.
 *
 * mus_arrange_pattern() finds a placement of all panels round a body and writes it into the pattern. mus_drape_place()
 * then puts the nodes of a cloth there, and mus_drape_start() checks the arrangement. A fault is told as a mus_reason,
 * the struct in which mus_drape_reason() tells how a run of sewing or settling ended.
 */
#ifndef MUSLIN_ARRANGE_H
#define MUSLIN_ARRANGE_H

#include "muslin/base.h"
#include "muslin/body.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Find where the panels of a pattern start round a body, and write it as their placement.
 *
 * Partner edges then face each other, right sides point away from the body, and no panel is in the body. Panels that
 * lie side by side make rings, which go round the trunk, the neck or an arm: the panel's label tells which
 * (mus_pattern_set_panel_label()). Seams decide the azimuth, and the sides of panels (mus_pattern_set_panel_sides())
 * where seams do not. The body is taken as it was made.
 * Errors:  MUS_ERR_ARG; MUS_ERR_BODY (a body that was not made of a tape); MUS_ERR_PATTERN (a panel without outline);
 *          MUS_ERR_MEMORY; the pattern is as it was
 * Cost:    a few milliseconds
 */
MUS_API mus_status mus_arrange_pattern(mus_pattern *pattern, const mus_body *body);

/* Why a garment is on, or is not: the whole list of kinds. */
#define MUS_REASON_NONE 0 /* nothing was asked yet */
#define MUS_REASON_SETTLED 1
#define MUS_REASON_TWISTED_SEAM 2  /* seam: it makes the garment one-sided */
#define MUS_REASON_PANEL_CROSSES 3 /* panel: its outline crosses itself */
#define MUS_REASON_SEAM_OPEN 4     /* seam, place, value: its gap [m] */
#define MUS_REASON_START_TANGLED 5 /* panel or seam: it begins inside the body, twisted, or with its sides exchanged   \
                                    */
#define MUS_REASON_SLID_OFF 6      /* panel that was uppermost, value: when [s] */
#define MUS_REASON_TANGLED 7       /* count: crossings of cloth with cloth */
#define MUS_REASON_NOT_SETTLED 8   /* panel, node and place that are farthest from rest, value: the residual */
#define MUS_REASON_UNSTABLE 9      /* the motion diverged */
#define MUS_REASON_BAD_INPUT 10    /* any other fault of what was given */
#define MUS_REASON_STOPPED 11      /* the caller's progress function stopped the run */
#define MUS_REASON_NOT_WORN 12     /* panel, node, place: sewn, but mus_fit_worn() objects; value: its kind */
#define MUS_REASON_COUNT 13

/** A reason with its place. */
typedef struct mus_reason {
    size_t size;
    int32_t kind;    /* MUS_REASON_* */
    int32_t panel;   /* or MUS_NONE */
    int32_t seam;    /* or MUS_NONE */
    int32_t node;    /* of the cloth, or MUS_NONE */
    int32_t count;   /* of a tangle */
    double value;    /* see the list */
    double place[3]; /* [m], 0 without a place */
    char text[256];  /* one sentence, UTF-8; names are cut where it is full */
} mus_reason;

/** Write an empty reason: kind MUS_REASON_NONE, no panel, seam or node. `size` is sizeof(mus_reason). */
MUS_API void mus_reason_init(mus_reason *reason, size_t size);

/** A kind in words ("slid off"); NULL outside the list. */
MUS_API const char *mus_reason_name(int32_t kind);

/**
 * Check a pattern, and give its first fault as a reason: kind MUS_REASON_NONE when a cloth can be cut of it.
 *
 * The pattern does not change.
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_reason(const mus_pattern *pattern, mus_reason *out);

#ifdef __cplusplus
}
#endif

#endif
