/*
 * board_data.h: the cutting table: a pattern laid out as records that may be cut, turned, joined and mirrored.
 *
 * The structure is that of half-edges (de Berg and others, Computational Geometry, 2008, chapter 2): a panel is a ring
 * of sides, and a side is one edge as its panel's outline walks it: counter-clockwise, the cloth to its left; its end
 * is the start of the next side, bit for bit. (An outline that runs clockwise, as an imported one may, is kept so: then
 * the cloth is to its right.) Two sides that are sewn are joined by a record of their seam; REVERSED (right sides out)
 * means that the start of a meets the end of b. A dart is two sides one after the other that are sewn together; the
 * vertex between them is its point. Lengths in metre, angles in radian, counter-clockwise positive.
 *
 * Indices of sides, panels and seams stay as they are while the board lives; a removed side has panel == MUS_NONE, a
 * removed seam a == MUS_NONE. mus__board_write() leaves both out.
 */
#ifndef MUS_BOARD_DATA_H
#define MUS_BOARD_DATA_H

#include "pattern/pattern_internal.h"

/* the role of a side on the centre line when a half garment is doubled: none, one piece cut on the fold, two pieces
 * sewn together, two pieces left open (a front that buttons is open) */
#define MUS__CENTRE_NONE 0
#define MUS__CENTRE_FOLD 1
#define MUS__CENTRE_SEAM 2
#define MUS__CENTRE_OPEN 3

/* a chain of pieces as edges have them: kinds (npiece), xy (nxy x 2) with both ends */
typedef struct mus__board_chain {
    int32_t npiece, nxy;
    int32_t *kinds;
    double *xy; /* the block that holds kinds too; owned */
} mus__board_chain;

/* a chain whose points the caller owns */
typedef struct mus__board_path {
    int32_t npiece;
    const int32_t *kinds;
    int32_t nxy;
    const double *xy;
} mus__board_path;

typedef struct mus__board_side {
    char name[MUS__NAME_BYTES];
    int32_t panel; /* MUS_NONE: removed */
    int32_t prev, next;
    int32_t centre;   /* MUS__CENTRE_*; not kept in a pattern */
    int32_t knot;     /* corners (starts of sides) of equal knot and place are one point of the panel; or MUS_NONE */
    bool backward;    /* the edge of the pattern runs against the outline */
    mus__edge_attributes attr; /* kept by reading, splits, doubling and writing */
    mus__board_chain chain;
    double length;
} mus__board_side;

typedef struct mus__board_panel {
    char name[MUS__NAME_BYTES];
    int32_t first; /* a side of it, where its word begins; MUS_NONE: removed */
    int32_t mirror_of;
    int32_t single; /* 1: the panel is on one half of the garment only; mus__board_double() does not mirror it */
    mus__panel_attributes attr;
} mus__board_panel;

typedef struct mus__board_seam {
    int32_t a, b;      /* sides; a == MUS_NONE: removed */
    int32_t direction; /* MUS_SEAM_* of the sides as walked */
    double ease, tolerance;
    bool bridge; /* both sides are one edge of the pattern, which its panel's word passes twice */
    int32_t laid, closure, open, buttons; /* as the pattern's */
} mus__board_seam;

typedef struct mus__board_notch {
    int32_t side, kind; /* side == MUS_NONE: removed */
    double s;           /* [m] from the start of the side as walked */
} mus__board_notch;

typedef struct mus__board_mark {
    char name[MUS__NAME_BYTES];
    int32_t panel, n; /* panel == MUS_NONE: removed */
    double *xy;       /* owned */
} mus__board_mark;

typedef struct mus__board {
    mus_context *context;
    mus_status status;
    char name[MUS__NAME_BYTES];
    int32_t npanel, nside, nseam, nnotch, nmark, nopening;
    int32_t panel_room, side_room, seam_room, notch_room, mark_room, opening_room;
    int32_t nknot;
    mus__board_panel *panel;
    mus__board_side *side;
    mus__board_seam *seam;
    mus__board_notch *notch;
    mus__board_mark *mark;
    mus__opening *opening;
} mus__board;

#endif
