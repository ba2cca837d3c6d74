/*
 * muslin/fit.h: how a draped garment fits: ease a level, strain along warp and weft, pressure on the skin, gap to it.
 *
 * Taken of a drape as it stands and kept: what the drape does later does not change it. Levels are planes across a limb
 * of the body (neck, bust, waist, hip; biceps, thigh, knee of either side), as the body stands now. Ease is that of the
 * cloth as cut: the length of cloth that the level cuts, unstrained, less the girth of the body.
 */
#ifndef MUSLIN_FIT_H
#define MUSLIN_FIT_H

#include "muslin/base.h"
#include "muslin/body.h"
#include "muslin/drape.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mus_fit mus_fit;

/**
 * Look at how a garment fits.
 *
 * `body` is that of the drape (as made or posed: its girths alone are asked), NULL: there are no levels.
 * Errors:  MUS_ERR_ARG, MUS_ERR_MEMORY
 * Cost:    some microseconds a node
 */
MUS_API mus_status mus_fit_create(const mus_drape *drape, const mus_body *body, mus_fit **out);
MUS_API void mus_fit_destroy(mus_fit *fit);

/** Nodes of the cloth: how long the arrays below are. */
MUS_API int32_t mus_fit_node_count(const mus_fit *fit);

/**
 * At each node, borrowed until the fit is destroyed:
 *
 * warp, weft: engineering strain along them, mean of the triangles round the node; below 0: pressed together
 * pressure:   on the skin [Pa], 0 off it: membrane tension over curvature, as the normal part of what the springs of
 *             stretch and shear pull at the node, over its area
 * gap:        to the body [m], NaN where no part of it is near
 */
MUS_API const double *mus_fit_warp(const mus_fit *fit);
MUS_API const double *mus_fit_weft(const mus_fit *fit);
MUS_API const double *mus_fit_pressure(const mus_fit *fit);
MUS_API const double *mus_fit_gap(const mus_fit *fit);

/** A level that the garment goes round. */
typedef struct mus_fit_level {
    size_t size;
    int32_t level;  /* MUS_HOLD_*, its name by mus_hold_name() */
    int32_t right;  /* of a limb: 0 the left, 1 the right; of the torso MUS_NONE */
    double body;    /* girth of the body [m] */
    double garment; /* length of cloth round it, unstrained [m]; of layers the mean */
    double worn;    /* the same as it lies [m] */
    double ease;    /* garment less body [m] */
    double gap;     /* mean distance to the body [m] */
} mus_fit_level;

MUS_API void mus_fit_level_init(mus_fit_level *level, size_t size);

/** Levels, from the neck down: number, and one of them. Errors: MUS_ERR_ARG, MUS_ERR_VERSION. */
MUS_API int32_t mus_fit_level_count(const mus_fit *fit);
MUS_API mus_status mus_fit_level_get(const mus_fit *fit, int32_t index, mus_fit_level *out);

#ifdef __cplusplus
}
#endif

#endif
