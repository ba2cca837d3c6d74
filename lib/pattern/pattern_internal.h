/*
 * pattern_internal.h: the data of a pattern, its invariants, and what the files of this folder share.
 *
 * Cells stand in growing arrays, index = name of the cell for good: nothing is removed. What has no fixed size (the
 * chain of an edge, the word of a panel, the points of a mark) is a block of its own, so that views handed out stay
 * put while other cells are added. Texts are inside their cell.
 *
 * Invariants: coordinates are within MUS__FARTHEST; every outline is a closed word of edges of its own panel; every
 * edge is longer than 0; all numbers are finite (but for the allowance that is NaN: left to the sheet); every index
 * points at something.
 */
#ifndef MUS_PATTERN_INTERNAL_H
#define MUS_PATTERN_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/pattern.h"

#define MUS__NAME_BYTES 128 /* names are 127 bytes and their end */
/* coordinates beyond this [m] are a slip of unit or a broken file; inside it no length or area overflows */
#define MUS__FARTHEST 1e6
#define MUS__FAULT_BYTES 768 /* five names and a sentence round them */

typedef struct mus__panel {
    char name[MUS__NAME_BYTES], label[MUS__NAME_BYTES];
    int32_t noutline, cut_count, mirror_of, layer;
    int32_t *outline; /* (noutline) edges, then (noutline) directions +1, -1; NULL without an outline */
    double grain[2];  /* unit vector along the warp */
    mus_placement placement;
} mus__panel;

typedef struct mus__point {
    double xy[2];
    int32_t panel;
} mus__point;

/* what keeps an edge up: a hold on the body and how far below it, an elastic (stiffness 0: none) */
typedef struct mus__edge_stay {
    int32_t hold; /* MUS_HOLD_* */
    double below, ratio, stiffness;
} mus__edge_stay;

typedef struct mus__edge {
    char name[MUS__NAME_BYTES], label[MUS__NAME_BYTES];
    int32_t panel, start, end;
    int32_t seam, nseam; /* the first seam that it is in or MUS_NONE, and how many there are */
    int32_t npiece, nxy; /* nxy counts both ends */
    double allowance;
    mus__edge_stay stay;
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

typedef struct mus__fault {
    int32_t kind, panel, edge, seam;
    char text[MUS__FAULT_BYTES];
} mus__fault;

/* what a pattern was before its last edits, and after those that were undone: patterns without a history of their own.
 * The last of each list is next */
typedef struct mus__history {
    int32_t depth, ndone, nundone;
    mus_pattern **done, **undone; /* (depth) each, one block */
} mus__history;

struct mus_pattern {
    mus_context *context;
    char name[MUS__NAME_BYTES];
    int32_t npanel, npoint, nedge, nseam, nnotch, nmark, nfault;
    int32_t panel_room, point_room, edge_room, seam_room, notch_room, mark_room;
    int32_t nopening, opening_room;
    mus__panel *panel;     /* (npanel) */
    mus__point *point;     /* (npoint) */
    mus__edge *edge;       /* (nedge) */
    mus_seam_def *seam;    /* (nseam) */
    mus__notch *notch;     /* (nnotch) */
    mus__mark *mark;       /* (nmark) */
    mus__opening *opening; /* (nopening) */
    mus__fault *fault;     /* (nfault) of the last check; dropped by every edit */
    mus__history *history; /* what it was before edits, NULL unless it is kept */
};

/* ---- pattern.c ---- */

/* MUS_OK, or MUS_ERR_ARG with "`what` 7 is unknown, the pattern has 4" */
mus_status mus__pattern_known(const mus_pattern *pattern, const char *what, int32_t index, int32_t count);
/* copy a name into `out` (MUS__NAME_BYTES); NULL reads as "". Errors: MUS_ERR_ARG (too long, not UTF-8) */
mus_status mus__pattern_take_name(const mus_pattern *pattern, const char *what, const char *name, char *out);
/* is a coordinate of a point fit to be kept? (NaN is not) */
bool mus__pattern_near(double x, double y);
/* every edit calls this: the faults of the last check are no longer true */
void mus__pattern_edited(mus_pattern *pattern);
/* copy `own` to a caller's struct of any released size, keeping the caller's size field */
mus_status mus__pattern_give(const mus_pattern *pattern, void *out, const void *own, size_t own_size, const char *name);
/* "front.side", or "front.edge_12" for an edge without a name; out (2 x MUS__NAME_BYTES) */
void mus__pattern_edge_title(const mus_pattern *pattern, int32_t edge, char *out);

/* ---- history.c ---- */

/* nothing can be redone any more */
void mus__history_forget_undone(mus_pattern *pattern);
void mus__history_end(mus_pattern *pattern);

/* ---- cells.c ---- */

/* the block of an edge with npiece pieces and nxy points, and the pointers of `edge` into it (edge->xy set) */
double *mus__edge_block(mus_context *context, int32_t npiece, int32_t nxy);
void mus__edge_views(mus__edge *edge);

/* ---- link.c: union-find with a sign on each link ---- */

/* item i starts alone: parent[i] = i, sign[i] = +1 */
void mus__link_start(int32_t n, int32_t *parent, int32_t *sign);
/* root of i, the smallest of its class; parent[i] is that root and sign[i] relative to it afterwards */
int32_t mus__link_find(int32_t *parent, int32_t *sign, int32_t i);
/* say that i and j are one class and sign[i] sign[j] = relation; false when that contradicts what was said before */
bool mus__link_join(int32_t *parent, int32_t *sign, int32_t i, int32_t j, int32_t relation);

/* ---- quotient.c: the pattern with its seams glued ---- */

/* The words of all panels stand one after another: position k of them is a sheet of cloth that ends at an edge. The
 * arrays are parts of one block. */
typedef struct mus__quotient {
    int32_t nword;
    int32_t *first;  /* (npanel + 1) where the word of each panel starts */
    int32_t *edge;   /* (nword) */
    int32_t *turn;   /* (nword) direction of the word along its edge, +1 or -1 */
    int32_t *panel;  /* (nword) */
    int32_t *place;  /* (nedge) its first position in the words, MUS_NONE for a loose edge */
    int32_t *root;   /* (nedge) class of each edge */
    int32_t *sign;   /* (nedge) +1 the edge runs as the root of its class does, -1 against it */
    int32_t *sheets; /* (nedge) by class: how many positions */
    int32_t *sheet;  /* (nedge x 2) by class: the first two positions */
    int32_t *point;  /* (npoint) class of each point */
    int32_t *link;   /* (the most of npoint, nword, npanel) work, and its signs: */
    int32_t *bias;
    bool folded; /* an edge is glued to itself end over end */
    int32_t *block;
} mus__quotient;

/* glue all seams; free with mus__free(context, out->block). Errors: MUS_ERR_PATTERN (a panel without outline),
 * MUS_ERR_MEMORY; with `partial` panels without outline are left out */
mus_status mus__quotient_make(const mus_pattern *pattern, bool partial, mus__quotient *out);
/* the same, or without `sewn` no seam glued: the panels as cut */
mus_status mus__quotient_make_cells(const mus_pattern *pattern, bool partial, bool sewn, mus__quotient *out);
/* next position in the word of the same panel, along it (step +1) or against it (-1) */
int32_t mus__quotient_next(const mus__quotient *q, int32_t k, int32_t step);
/* do positions j and k of one class leave the same side of both panels outside? */
bool mus__quotient_same_side(const mus__quotient *q, int32_t j, int32_t k);
/* give each panel a side, q->link its piece and q->bias its side: how many seams contradict the others. twisted
 * (nseam, zero, may be NULL) gets 1 for those; *bridge an edge that a panel joins to itself one-sidedly, or MUS_NONE */
int32_t mus__quotient_sides(const mus_pattern *pattern, mus__quotient *q, int32_t *twisted, int32_t *bridge);

/* ---- inner.c ---- */

/* is an edge a line inside its panel: passed once each way? */
bool mus__edge_inner(const mus__quotient *q, int32_t edge);

/* ---- check.c ---- */

/* the faults of a check that is under way; failed once there was no memory for one */
typedef struct mus__fault_list {
    mus__fault *fault;
    int32_t count, room;
    bool failed;
} mus__fault_list;

/* room for one more fault; NULL without memory */
mus__fault *mus__fault_add(mus_context *context, mus__fault_list *list, int32_t kind, int32_t panel, int32_t edge,
                           int32_t seam);
/* a number with `decimals` places behind a full stop, in every locale; out (32) */
const char *mus__fault_number(double value, int32_t decimals, char *out);

/* ---- garment.c ---- */

/* faults of a pattern that declares openings, as a garment; q is spent */
mus_status mus__garment_faults(const mus_pattern *pattern, mus__quotient *q, mus__fault_list *list);

/* ---- smith.c ---- */

/* Smith normal form of the matrix whose entries are triples (n x 3) row, column, value (equal places are summed): its
 * rank, and factor (as many as it has columns) gets `rank` invariant factors, each dividing the next. Errors:
 * MUS_ERR_LIMIT (an entry on the way beyond 2^31), MUS_ERR_MEMORY */
mus_status mus__smith(mus_context *context, int32_t rows, int32_t n, const int32_t *entry, int32_t *rank,
                      int32_t *factor);

/* ---- homology.c ---- */

/* homology of the complex with cells (3) of each dimension and the triples of d1 and d2, n (2) of them */
mus_status mus__homology(mus_context *context, const int32_t *cells, const int32_t *n, int32_t *const *triple,
                         mus_homology *out, int32_t *torsion, int32_t capacity);

/* ---- crossing.c ---- */

/* does the outline of a panel cross or touch itself? *a and *b get the two edges. Errors: MUS_ERR_MEMORY */
mus_status mus__panel_crosses(const mus_pattern *pattern, int32_t panel, bool *crosses, int32_t *a, int32_t *b);

#endif
