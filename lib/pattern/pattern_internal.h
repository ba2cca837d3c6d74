/*
 * pattern_internal.h: the data of a pattern, its invariants, and what the files of this folder share.
 *
 * Cells stand in growing arrays, index = name of the cell for good: nothing is removed. What has no fixed size (the
 * chain of an edge, the word of a panel, the points of a mark) is a block of its own, so that views handed out stay
 * put while other cells are added. Texts are inside their cell.
 *
 * Invariants: every outline is a closed word of edges of its own panel; every edge is longer than 0; all numbers are
 * finite (but for the allowance that is NaN: left to the sheet); every index points at something.
 */
#ifndef MUS_PATTERN_INTERNAL_H
#define MUS_PATTERN_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/pattern.h"

#define MUS__NAME_BYTES 128  /* names are 127 bytes and their end */
#define MUS__FAULT_BYTES 640 /* four names and a sentence round them */

typedef struct mus__panel {
    char name[MUS__NAME_BYTES], label[MUS__NAME_BYTES];
    int32_t noutline, cut_count, mirror_of;
    int32_t *outline; /* (noutline) edges, then (noutline) directions +1, -1; NULL without an outline */
    double grain[2];  /* unit vector along the warp */
    mus_placement placement;
} mus__panel;

typedef struct mus__point {
    double xy[2];
    int32_t panel;
} mus__point;

typedef struct mus__edge {
    char name[MUS__NAME_BYTES], label[MUS__NAME_BYTES];
    int32_t panel, start, end;
    int32_t seam, nseam; /* the first seam that it is in or MUS_NONE, and how many there are */
    int32_t npiece, nxy; /* nxy counts both ends */
    double allowance;
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

typedef struct mus__fault {
    int32_t kind, panel, edge, seam;
    char text[MUS__FAULT_BYTES];
} mus__fault;

struct mus_pattern {
    mus_context *context;
    char name[MUS__NAME_BYTES];
    int32_t npanel, npoint, nedge, nseam, nnotch, nmark, nfault;
    int32_t panel_room, point_room, edge_room, seam_room, notch_room, mark_room;
    mus__panel *panel;  /* (npanel) */
    mus__point *point;  /* (npoint) */
    mus__edge *edge;    /* (nedge) */
    mus_seam_def *seam; /* (nseam) */
    mus__notch *notch;  /* (nnotch) */
    mus__mark *mark;    /* (nmark) */
    mus__fault *fault;  /* (nfault) of the last check; dropped by every edit */
};

/* ---- pattern.c ---- */

/* MUS_OK, or MUS_ERR_ARG with "`what` 7 is unknown, the pattern has 4" */
mus_status mus__pattern_known(const mus_pattern *pattern, const char *what, int32_t index, int32_t count);
/* copy a name into `out` (MUS__NAME_BYTES); NULL reads as "". Errors: MUS_ERR_ARG (too long, not UTF-8) */
mus_status mus__pattern_take_name(const mus_pattern *pattern, const char *what, const char *name, char *out);
/* every edit calls this: the faults of the last check are no longer true */
void mus__pattern_edited(mus_pattern *pattern);
/* copy `own` to a caller's struct of any released size, keeping the caller's size field */
mus_status mus__pattern_give(const mus_pattern *pattern, void *out, const void *own, size_t own_size, const char *name);
/* "front.side", or "front.edge_12" for an edge without a name; out (2 x MUS__NAME_BYTES) */
void mus__pattern_edge_title(const mus_pattern *pattern, int32_t edge, char *out);

/* ---- cells.c ---- */

/* the block of an edge with npiece pieces and nxy points, and the pointers of `edge` into it (edge->xy set) */
double *mus__edge_block(mus_context *context, int32_t npiece, int32_t nxy);
void mus__edge_views(mus__edge *edge);

#endif
