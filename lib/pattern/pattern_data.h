/*
 * pattern_data.h: the data of a pattern and its invariants.
 *
 * Cells stand in growing arrays, index = name of the cell for good: nothing is removed. What has no fixed size (the
 * chain of an edge, the word of a panel, the points of a mark) is a block of its own, so that views handed out stay
 * put while other cells are added. Texts are inside their cell.
 *
 * Invariants: coordinates are within MUS__FARTHEST; every outline is a closed word of edges of its own panel; every
 * edge is longer than 0; all numbers are finite (but for the allowance that is NaN: left to the sheet); every index
 * points at something.
 */
#ifndef MUS_PATTERN_DATA_H
#define MUS_PATTERN_DATA_H

#include "base/base_internal.h"
#include "muslin/pattern.h"

#define MUS__NAME_BYTES 128 /* names are 127 bytes and their end */
#define MUS__CUT_MOST 1000  /* most pieces of a panel of one material; chosen: more are an error of the file */

/* what is said of a panel, here and on the cutting table (lib/board): copied as one */
typedef struct mus__panel_attributes {
    char label[MUS__NAME_BYTES];
    int32_t cut[MUS_MATERIAL_COUNT]; /* pieces of each material, with those of mirror images */
    int32_t layer;
    int32_t sides;   /* MUS_SIDE_* together; MUS_NONE: those that the name tells */
    double grain[2]; /* unit vector along the warp */
    mus_placement placement;
} mus__panel_attributes;

/* what is said of an edge, here and of a side on the cutting table: copied as one */
typedef struct mus__edge_attributes {
    char label[MUS__NAME_BYTES];
    double allowance;        /* [m]; NaN: left to the sheet */
    int32_t hold;            /* MUS_HOLD_*: the level of the body that the edge is attached to */
    double below;            /* [m] how far below that level it may slide */
    double ratio, stiffness; /* of an elastic: rest length over the edge's; [N], 0 without an elastic */
} mus__edge_attributes;

typedef struct mus__panel {
    char name[MUS__NAME_BYTES];
    int32_t noutline, mirror_of;
    int32_t *outline; /* (noutline) edges, then (noutline) directions +1, -1; NULL without an outline */
    mus__panel_attributes attr;
} mus__panel;

typedef struct mus__point {
    double xy[2];
    int32_t panel;
} mus__point;

typedef struct mus__edge {
    char name[MUS__NAME_BYTES];
    int32_t panel, start, end;
    int32_t seam, nseam; /* the first seam that it is in or MUS_NONE, and how many there are */
    int32_t npiece, nxy; /* nxy counts both ends */
    mus__edge_attributes attr;
    double *xy;     /* (nxy x 2), the block that holds the next two as well */
    double *run;    /* (npiece + 1) arc length at the start of each piece; the last is the edge's length */
    int32_t *kinds; /* (npiece) */
} mus__edge;

typedef struct mus__notch {
    double s;
    int32_t edge, kind;
} mus__notch;

typedef struct mus__mark {
    char name[MUS__NAME_BYTES];
    int32_t panel, n;
    double *xy; /* (n x 2) */
} mus__mark;

/* an opening that the sewn garment is to have */
typedef struct mus__opening {
    char label[MUS__NAME_BYTES];
} mus__opening;

/* what a pattern was before its last edits, and after those that were undone: patterns without a history of their own.
 * The last of each list is next */
typedef struct mus__history {
    int32_t depth, ndone, nundone;
    mus_pattern **done, **undone; /* (depth) each, one block */
} mus__history;

struct mus_pattern {
    mus_context *context;
    char name[MUS__NAME_BYTES];
    int32_t npanel, npoint, nedge, nseam, nnotch, nmark;
    int32_t panel_room, point_room, edge_room, seam_room, notch_room, mark_room;
    int32_t nopening, opening_room;
    mus__panel *panel;     /* (npanel) */
    mus__point *point;     /* (npoint) */
    mus__edge *edge;       /* (nedge) */
    mus_seam_def *seam;    /* (nseam) */
    mus__notch *notch;     /* (nnotch) */
    mus__mark *mark;       /* (nmark) */
    mus__opening *opening; /* (nopening) */
    /* panels by name, of a pattern of many: an open hash table of the first nnamed panels, MUS_NONE where it is free */
    int32_t *named;
    int32_t nnamed, named_room;
    mus_pattern *cut_only; /* panels that are cut and not draped, a pattern without such panels; NULL: none */
    mus__history *history; /* what it was before edits, NULL unless it is kept */
};

#endif
