/*
 * muslin/fit.h: how a draped garment fits: ease at levels of the body, strain along warp and weft, pressure on the
 * skin, gap to it.
 *
 * A fit is taken of a drape at one time and kept: later changes of the drape do not change it. Levels are planes across
 * a limb of the body (neck, bust, waist, hip; biceps, thigh, knee of either side), as the body stands at that time.
 * Ease is that of the cloth as cut: the unstrained length of cloth that the level plane cuts, less the girth of the
 * body.
 */
#ifndef MUSLIN_FIT_H
#define MUSLIN_FIT_H

#include "muslin/base.h"
#include "muslin/body.h"
#include "muslin/drape.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mus_fit mus_fit;

/**
 * Take the fit of a drape as it stands.
 *
 * `body` is that of the drape (as made or posed; only its girths are read). NULL: the fit has no levels.
 * Errors:  MUS_ERR_ARG, MUS_ERR_MEMORY
 * Cost:    some microseconds a node
 */
MUS_API mus_status mus_fit_create(const mus_drape *drape, const mus_body *body, mus_fit **out);
/** Destroy a fit; NULL is accepted. */
MUS_API void mus_fit_destroy(mus_fit *fit);

/** Number of nodes of the cloth: the length of the arrays below. */
MUS_API int32_t mus_fit_node_count(const mus_fit *fit);

/** Engineering strain along the warp at each node (node_count): the mean of the triangles round the node; below 0:
 * pressed together. Borrowed until the fit is destroyed. */
MUS_API const double *mus_fit_warp(const mus_fit *fit);

/** Engineering strain along the weft at each node, as mus_fit_warp(). */
MUS_API const double *mus_fit_weft(const mus_fit *fit);

/** Pressure on the skin at each node (node_count) [Pa], 0 off it: the membrane tension over the radius of curvature, as
 * the normal component of the force of stretch and shear springs at the node, over its area. Borrowed likewise. */
MUS_API const double *mus_fit_pressure(const mus_fit *fit);

/** Distance to the body at each node (node_count) [m], NaN farther than 0.3 m. Borrowed likewise. */
MUS_API const double *mus_fit_gap(const mus_fit *fit);

/** Area of the cloth that belongs to each node, in the flat (node_count) [m2]: a third of its triangles. Borrowed
 * likewise. */
MUS_API const double *mus_fit_area(const mus_fit *fit);

/* quantities of a fit */
#define MUS_FIT_STRAIN 0   /* the greater of the strains along warp and weft */
#define MUS_FIT_WARP 1     /* strain along the warp */
#define MUS_FIT_WEFT 2     /* strain along the weft */
#define MUS_FIT_PRESSURE 3 /* [Pa]; cloth off the skin counts with 0 */
#define MUS_FIT_GAP 4      /* [m]; cloth farther than 0.3 m is left out */

/** How a quantity is spread over the cloth, by area: half of the area has at most p50, 95 % of it at most p95. Least
 * and largest are those of one node: they move apart with each finer mesh, and tell where to look, not how
 * much. */
typedef struct mus_fit_spread {
    size_t size;
    double p50;     /* of the quantity, in its unit */
    double p95;
    double p99;
    double mean;    /* by area */
    double least;
    double largest;
    int32_t node;   /* that has the largest */
    double area;    /* of the cloth that counts, in the flat [m2] */
} mus_fit_spread;

/** Zero `spread` and write its size. */
MUS_API void mus_fit_spread_init(mus_fit_spread *spread, size_t size);

/** The spread of a quantity (MUS_FIT_*); NaN and node MUS_NONE where no cloth counts. Errors: MUS_ERR_ARG (no such
 * quantity, or NULL), MUS_ERR_VERSION, MUS_ERR_MEMORY. Cost: a sort of the nodes */
MUS_API mus_status mus_fit_spread_get(const mus_fit *fit, int32_t quantity, mus_fit_spread *out);

/** A level of the body that the garment goes round. */
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

/** Zero `level` and write its size. */
MUS_API void mus_fit_level_init(mus_fit_level *level, size_t size);

/** Number of levels of the body that the garment goes round. */
MUS_API int32_t mus_fit_level_count(const mus_fit *fit);

/** Level `index`, counted from the neck down. Errors: MUS_ERR_ARG (no such level), MUS_ERR_VERSION */
MUS_API mus_status mus_fit_level_get(const mus_fit *fit, int32_t index, mus_fit_level *out);

/* ---- worn or not ---- */

/* The limbs whose openings a garment has, and the axes that stand for them. */
#define MUS_WORN_NECK 0
#define MUS_WORN_ARM_LEFT 1
#define MUS_WORN_ARM_RIGHT 2
#define MUS_WORN_LEG_LEFT 3
#define MUS_WORN_LEG_RIGHT 4
#define MUS_WORN_LIMBS 5

/* Why a garment is not worn: the whole list of kinds. The checks run in this order. */
#define MUS_WORN_YES 0        /* it is worn */
#define MUS_WORN_UNKNOWN 1    /* the body has no trunk, shoulders and waist to tell by */
#define MUS_WORN_OPENING 2    /* limb, panel: the limb does not go through its opening, or goes through another's */
#define MUS_WORN_INSIDE_OUT 3 /* panel: the wrong side of the cloth is outside */
#define MUS_WORN_SHOULDER 4   /* limb (arm of that side), value: distance past the end of the shoulder [m] */
#define MUS_WORN_HOOD 5       /* panel: a hood is not on the head, or hangs over the eyes */
#define MUS_WORN_LOW 6        /* panel, value: an opening hangs that much lower than its girth allows [m] */
#define MUS_WORN_ROLLED 7     /* panel, value: an opening is that much higher than the pattern puts it [m] */
#define MUS_WORN_TIGHT 8      /* panel, value: strain above 1, of an opening or of the cloth */
#define MUS_WORN_THROUGH 9    /* panel, limb: that limb goes through the cloth; or MUS_NONE, and value: cloth goes
                               * through the body that deep [m], more than 1 mm */
#define MUS_WORN_COUNT 10

/** Is the garment worn, and what goes through the body. */
typedef struct mus_worn {
    size_t size;
    int32_t kind;          /* MUS_WORN_*: the first check that fails, in the order of the list. A body that cannot be
                            * told by is MUS_WORN_UNKNOWN unless cloth goes through it, MUS_WORN_THROUGH */
    int32_t limb;          /* MUS_WORN_NECK and so on, or MUS_NONE */
    int32_t panel;         /* of the pattern, or MUS_NONE */
    int32_t node;          /* of the cloth, or MUS_NONE */
    double value;          /* see the list */
    double place[3];       /* [m], 0 without a place */
    int32_t through;       /* pairs of a triangle of the cloth and one of the skin that cross */
    double through_depth;  /* of the deepest sample of these triangles of the cloth [m] */
    double through_area;   /* of the cloth in the body [m2] */
    double through_place[3]; /* of the deepest sample [m], 0 without any */
    char text[256];        /* one sentence, "" when it is worn or unknown */
} mus_worn;

/** Zero `worn` and write its size; limb, panel and node are MUS_NONE. */
MUS_API void mus_worn_init(mus_worn *worn, size_t size);

/** A kind in words ("a limb is not in its opening"); NULL outside the list. */
MUS_API const char *mus_worn_name(int32_t kind);

/**
 * Is a garment worn by the body as the pattern means it? A certificate by exact signs, from the places alone.
 *
 * Each boundary loop of the sewn cloth has a linking number with the axes of neck, arms and legs, which are closed far
 * outside. In a garment that is worn each limb leaves by one loop, its opening. Labels and sides of the panels tell
 * which one (mus_pattern_set_panel_label(), "arm" and "leg"), else the arrangement. Then heights are compared with
 * those of the arrangement: the neck opening crosses each shoulder where the pattern has one; a waist or strapless top
 * is not lower than the level that carries its girth, or than it is put where none does; a hem is not rolled up. Last,
 * whole triangles are counted: those of the cloth that cross the skin.
 *
 * `pattern` is that of the drape's cloth, `body` that of the drape, as it stands now (mus_body_pose()). Seams count as
 * sewn, so the call may be made before and during sewing too.
 * Units:   [m], [m2]
 * Errors:  MUS_ERR_ARG (NULL, a pattern with another number of panels), MUS_ERR_VERSION, MUS_ERR_MEMORY
 * Memory:  some 200 bytes a triangle of cloth and skin during the call
 * Cost:    about 30 ms with a skin of 120,000 triangles
 * Source:  linking numbers: Rolfsen, Knots and Links, 1976, 5.D; exact signs: Shewchuk, Discrete Comput. Geom. 18, 1997
 */
MUS_API mus_status mus_fit_worn(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body,
                                mus_worn *out);

#ifdef __cplusplus
}
#endif

#endif
