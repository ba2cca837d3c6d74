/*
 * recipe.h: the five designs that have a recipe of their own: a draft in the making, the piece that turns a drawing
 * into a panel.
 */
#ifndef MUS_RECIPE_H
#define MUS_RECIPE_H

#include "block/block_bodice.h"
#include "block/block_sleeve.h"
#include "block/block_skirt.h"
#include "limb/skeleton.h"
#include "muslin/design.h"

/* one draft in the making. After a failure `status` stays and every later call does nothing */
typedef struct mus__draft {
    mus_context *context;
    mus__measures measures;
    mus__skeleton skeleton;
    mus_draft_def def;
    mus_pattern *pattern;
    mus_status status;
} mus__draft;

#define MUS__PIECE_EDGES 24
#define MUS__EDGE_NAME_BYTES 16

typedef struct mus__piece_edge {
    char name[MUS__EDGE_NAME_BYTES];
    const char *label;
    double allowance;
    mus__chain chain; /* as drawn */
    int32_t edge;     /* in the pattern */
} mus__piece_edge;

typedef struct mus__piece {
    mus__draft *draft;
    int32_t panel;
    bool mirror;
    int32_t n;
    mus__piece_edge edges[MUS__PIECE_EDGES];
} mus__piece;

void mus__piece_begin(mus__piece *piece, mus__draft *draft);
/* next edge, counter-clockwise */
void mus__piece_edge_add(mus__piece *piece, const char *name, const char *label, double allowance,
                         const mus__chain *chain);
/* edges first..last again in reverse as mirror images, 'L' at the end of their names turned to 'R' and back */
void mus__piece_unfold(mus__piece *piece, int32_t first, int32_t last);
/* turn the drawing, or its mirror image, into a panel with outline, grain along y, cut 1 */
void mus__piece_panel(mus__piece *piece, const char *name, const char *label, bool mirror);
/* index of an edge in the pattern, MUS_NONE if there is none */
int32_t mus__piece_edge_find(const mus__piece *piece, const char *name);
/* at arc length s from the start of the edge as drawn */
void mus__piece_notch(mus__piece *piece, const char *edge, double s, int32_t kind);
void mus__piece_mark(mus__piece *piece, const char *name, const double *start, const double *end);
/* sew a.edge_a to b.edge_b, right sides out */
void mus__piece_seam(const mus__piece *a, const char *edge_a, const mus__piece *b, const char *edge_b, double ease);
/* `piece` is cut twice, and `twin` is its mirror image */
void mus__piece_pair(const mus__piece *piece, const mus__piece *twin);

/* ---- round the body ---- */

/* front or back of the torso, bent so that its sides pass before or behind the arms; `width` half width of the panel,
 * y = 0 of the panel at `height` above the floor */
void mus__place_torso(mus__piece *piece, bool front, double width, double height);
/* sleeve rolled round arm `side` (0 left, 1 right), crown at the shoulder point */
void mus__place_arm(mus__piece *piece, const mus__sleeve *sleeve, int32_t side);
/* front or back of a skirt bent round the hips; `width` widest half front and half back together */
void mus__place_hips(mus__piece *piece, bool front, double width, double height);

/* ---- the designs ---- */

void mus__draft_bodice(mus__draft *draft);
void mus__draft_tshirt(mus__draft *draft);
void mus__draft_sleeveless(mus__draft *draft);
void mus__draft_skirt(mus__draft *draft);
void mus__draft_skirt_plain(mus__draft *draft);

#endif
