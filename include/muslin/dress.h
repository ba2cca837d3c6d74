/*
 * muslin/dress.h: from a pattern and a body to a garment at rest, in one call.
 *
 * mus_dress() finds where the panels start, cuts the cloth, sews it and settles it. A garment that does not come on
 * from one start is tried again from another one, as `muslin dress` does; the report lists the starts that were tried.
 * The same steps one by one: mus_cloth_create(), mus_drape_create(), mus_drape_place(), mus_drape_sew(),
 * mus_drape_settle().
 */
#ifndef MUSLIN_DRESS_H
#define MUSLIN_DRESS_H

#include "muslin/base.h"
#include "muslin/body.h"
#include "muslin/cloth.h"
#include "muslin/drape.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which starts mus_dress() tries: both (the pattern's own first, where it has one), or one of the two alone. */
#define MUS_DRESS_PLACE_BOTH 0
#define MUS_DRESS_PLACE_PATTERN 1 /* the placement that the pattern holds */
#define MUS_DRESS_PLACE_FOUND 2   /* the placement that the library finds round the body */

/* A start of the report that none can ask for: found round the body with its arms horizontal, which come down once the
 * garment is sewn. */
#define MUS_DRESS_PLACE_RAISED 3

/** Options of mus_dress(). Pointers are read during the call and not kept. */
typedef struct mus_dress_def {
    size_t size;
    double spacing;             /* of the lattice [m], default 0.01, 0.001..0.1 */
    const mus_fabric *fabric;   /* NULL (default): "jersey" */
    int32_t self_contact;       /* nonzero: cloth meets cloth; 0 (default). Layers worn over each other need it */
    int32_t precision;          /* of the state, 32 or 64 bits; 0 (default): as the cloth asks (mus_drape_def) */
    int32_t threads;            /* 1 (default) .. 64; the result does not depend on it */
    double friction;            /* on skin; NaN (default): the fabric's */
    const mus_drape_def *drape; /* NULL (default); else all options of the drape: the four above are not read */
    int32_t place;              /* MUS_DRESS_PLACE_*, default both */
    int32_t retry;              /* nonzero (default): after a failure from the pattern's start the found one is tried;
                                 * 0: one start alone */
    int32_t open_closures;      /* nonzero: zips and buttons are left open; 0 (default): closed */
    mus_progress_fn progress;   /* of sewing and settling, NULL (default): none. Nonzero stops the run */
    void *progress_user;        /* handed to progress */
    double progress_seconds;    /* wall time between two calls of progress at least [s], default 0.1. Not read with
                                 * `drape` */
    int32_t nodes_most;         /* of the cloth, as in mus_cloth_def: default MUS_CLOTH_NODES, 1..2^24 */
    double seconds_most;        /* wall time that sewing and settling may take, all starts together [s]; 0 (default):
                                 * no limit. Looked at when progress would be called */
} mus_dress_def;

/** Zero `def`, write the defaults and its size. `size` is sizeof(mus_dress_def) of the caller. */
MUS_API void mus_dress_def_init(mus_dress_def *def, size_t size);

/* Capacity of the lists of starts in the report. Today at most 6 starts are tried. */
#define MUS_DRESS_STARTS_MOST 8

/** What mus_dress() did. */
typedef struct mus_dress_report {
    size_t size;
    int32_t found;                                /* nonzero: the garment started from the found placement */
    int32_t starts;                               /* number of starts that were tried */
    int32_t kept;                                 /* the start that is returned, MUS_NONE when none was tried */
    int32_t start_place[MUS_DRESS_STARTS_MOST];   /* of each start: MUS_DRESS_PLACE_PATTERN, _FOUND or _RAISED */
    int32_t start_patient[MUS_DRESS_STARTS_MOST]; /* nonzero: all ways of sewing were tried; 0: the first one alone */
    int32_t start_end[MUS_DRESS_STARTS_MOST];     /* MUS_REASON_*: how it ended */
    double start_seconds[MUS_DRESS_STARTS_MOST];  /* wall time from cutting the cloth to its end [s] */
    double place_seconds;                         /* wall time of finding placements [s] */
    double cut_seconds;                           /* wall time of cutting the cloth, all starts together [s] */
    double sew_seconds;                           /* wall time of sewing, all starts together [s] */
    double settle_seconds;                        /* wall time of settling, all starts together [s] */
} mus_dress_report;

/** Zero `report` and write its size. */
MUS_API void mus_dress_report_init(mus_dress_report *report, size_t size);

/**
 * Dress a body in a pattern: place, cut, sew and settle, from up to three placements, each tried up to twice. The body
 * stands on a floor, plane 0 of the drape: at the height 0, or at the lowest point of a skin that reaches below it.
 *
 * The pattern's own placement comes first when it has one, else the one of mus_arrange_pattern(). A start fails when
 * mus_drape_start() finds a fault in it, a seam stays open, cloth crosses cloth, the garment slides off, finds no rest
 * or is not worn (mus_fit_worn(); cloth through the skin fails no start, but a limb through the cloth does). Then, with
 * MUS_DRESS_PLACE_BOTH and `retry`, two more have their turn: the found placement and, where cloth lies beside an arm,
 * the one found round the body with horizontal arms, which are taken back once the garment is sewn. Because sewing with
 * patience is slow, and settling too, each placement is first sewn in one way only, and not settled when a limb is not
 * in its opening then or goes through the cloth, or cloth crosses cloth. Where none succeeds so, starts with crossings
 * are settled all the same, the fewest first and while they have fewer than another has at rest; and where none got
 * through settling, those with an open seam are sewn in all ways. A hood so deep that its face edge would hang before
 * the hairline is drawn back over the crown, and held at the hairline while the garment is let down. A start whose
 * settle ends with its forces balanced while the cloth still drifts is settled once more, for it is on its way. The
 * first success ends the search; when none succeeds, the result is the one that got farthest: not at rest, tangled
 * (with the fewest crossings), not worn, slid off, a seam open, in this order.
 *
 * `body` may be NULL: empty space, and the pattern's own placement alone. `def` may be NULL. `report`, `reason` and
 * `cloth` may be NULL. *drape and *cloth are the caller's to destroy. They are given after a failure too, as far as the
 * garment got, and are NULL only when nothing could be cut or there was no memory. `reason` gets the same as
 * mus_drape_reason(), or the fault of the start or of the pattern.
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION; MUS_ERR_PATTERN, MUS_ERR_MESH, MUS_ERR_LIMIT (as mus_cloth_create);
 *          MUS_ERR_BODY (a placement must be found, round a body not made of a tape); MUS_ERR_SEW (a bad start,
 *          or a seam stays open); MUS_ERR_UNSETTLED (no rest; not worn at rest; or an opening is far too small for its
 *          limb, which is told before anything is sewn); MUS_ERR_TANGLED (at rest, but
 *          cloth crosses cloth); MUS_ERR_DIVERGED; MUS_ERR_STOPPED (by `progress`, or seconds_most are over);
 *          MUS_ERR_MEMORY
 * Memory:  at most three cloths and three drapes at one time
 * Cost:    a T-shirt at 0.01 m takes about a second, with self_contact some seconds
 */
MUS_API mus_status mus_dress(mus_context *context, const mus_pattern *pattern, const mus_body *body,
                             const mus_dress_def *def, mus_dress_report *report, mus_reason *reason, mus_cloth **cloth,
                             mus_drape **drape);

#ifdef __cplusplus
}
#endif

#endif
