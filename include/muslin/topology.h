/*
 * muslin/topology.h: what a pattern is as a surface once its seams are glued: Euler characteristic, openings, homology,
 * canonical form; and what is wrong with it.
 *
 * A seam makes two edges one, and their ends: the quotient of the cells of muslin/pattern.h by all seams. Counts of the
 * quotient tell a sleeve that is left off, a piece that is cut mirrored, a seam with a twist. The checks are declared
 * here, not in pattern.h, because most of them are questions about the quotient.
 * Source: Metaaphanon and Kanongchaiyos 2005, section 5; Hatcher, Algebraic Topology, 2002, sections 0 and 2.
 */
#ifndef MUSLIN_TOPOLOGY_H
#define MUSLIN_TOPOLOGY_H

#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- topology of the quotient ---- */

/** The sewn pattern as a surface. */
typedef struct mus_topology {
    size_t size;
    int32_t vertices;   /* classes of points */
    int32_t edges;      /* classes of edges */
    int32_t faces;      /* panels */
    int32_t euler;      /* V - E + F */
    int32_t components; /* sets of panels that hang together by seams */
    int32_t loops;      /* boundary loops: the openings; MUS_NONE when an edge class has more than two sheets */
    int32_t orientable; /* 1 when the garment has an inside and an outside, else 0 */
    int32_t manifold;   /* 1 when no edge class has more than two sheets and no outline pinches at a point */
    int32_t genus;      /* of a connected orientable manifold with boundary, else MUS_NONE */
} mus_topology;

/** Write the size; every other field is 0, genus MUS_NONE. */
MUS_API void mus_topology_init(mus_topology *topology, size_t size);

/** Topology of the quotient by all seams; out->size is set by mus_topology_init(). Errors: MUS_ERR_ARG,
 * MUS_ERR_VERSION, MUS_ERR_PATTERN (a panel without outline), MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_topology(const mus_pattern *pattern, mus_topology *out);

/**
 * The edges of boundary loop `loop` in order, and the length of the loop [m].
 *
 * Shapes:  edges (capacity), NULL to count only; *count is how many there are; length may be NULL
 * Errors:  MUS_ERR_ARG (no such loop), MUS_ERR_PATTERN (a panel without outline, more than two sheets at an edge),
 *          MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_loop(const mus_pattern *pattern, int32_t loop, int32_t *edges, int32_t capacity,
                                    int32_t *count, double *length);

/** Label of a boundary loop: of the labels of its edges the one with the greatest length along the loop, "" without
 * any. Borrowed until the next edit. Errors: as mus_pattern_loop(). */
MUS_API mus_status mus_pattern_loop_label(const mus_pattern *pattern, int32_t loop, const char **label);

/** Homology over the integers of a pattern, as cut or sewn. */
typedef struct mus_homology {
    size_t size;
    int32_t cells[3]; /* vertices, edges, faces */
    int32_t rank[2];  /* of the boundary operators: of edges, of faces */
    int32_t betti[3]; /* components, independent cycles, closed bags */
    int32_t euler;    /* cells[0] - cells[1] + cells[2] = betti[0] - betti[1] + betti[2] */
    int32_t torsion;  /* number of torsion coefficients of the first homology group */
} mus_homology;

/** Write the size; every other field is 0. */
MUS_API void mus_homology_init(mus_homology *homology, size_t size);

/**
 * Homology by Smith normal form of the boundary operators.
 *
 * `sewn` 0 takes the panels as cut, 1 with all seams. Any number of sheets may meet at an edge. An edge sewn to itself
 * end over end counts as half an edge with a vertex at its middle.
 * Shapes:  torsion (capacity) gets the torsion coefficients above 1, each dividing the next; NULL to count only
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_PATTERN (a panel without outline), MUS_ERR_LIMIT (a number beyond
 *          2^31), MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_homology(const mus_pattern *pattern, int32_t sewn, mus_homology *out, int32_t *torsion,
                                        int32_t capacity);

/**
 * The boundary operator from cells of `dimension` 1 or 2 to cells of one dimension less, as triples row, column, value.
 *
 * Cells are classes of points, classes of edges and panels. A class counts when an outline passes a member of it;
 * classes stand in the order of their lowest member. The boundary of an edge is its end less its start; the boundary of
 * a panel is its word.
 * Shapes:  triples (capacity x 3), may be NULL; *count is how many there are
 * Errors:  MUS_ERR_ARG, MUS_ERR_PATTERN (a panel without outline), MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_boundary(const mus_pattern *pattern, int32_t sewn, int32_t dimension, int32_t *triples,
                                        int32_t capacity, int32_t *count);

/* ---- canonical form ---- */

/** Differences between two patterns that leave the form the same. */
typedef struct mus_form_def {
    size_t size;
    int32_t mirror; /* 1 (default): a pattern and its mirror image have one form; 0: they have two */
    int32_t labels; /* 1 (default): labels of panels and edges belong to the form; 0: they do not */
} mus_form_def;

/** Write the defaults: mirror 1, labels 1. */
MUS_API void mus_form_def_init(mus_form_def *def, size_t size);

/**
 * Canonical form of the sewn complex.
 *
 * Two patterns have the same bytes exactly when one becomes the other by renaming and reordering panels, edges and
 * seams, by beginning words elsewhere, and, with `mirror`, by mirroring the whole. The form holds panels as cyclic
 * words seen from the right side, labels, which edges are one class and which way they run in it. It holds no names,
 * lengths, notches and marks. `def` NULL means the defaults.
 * Shapes:  bytes (capacity), may be NULL; *count is how many there are; hash (2), 128 bits, may be NULL
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_PATTERN (a panel without outline), MUS_ERR_LIMIT (too many alike
 *          sheets at one edge), MUS_ERR_MEMORY
 * Cost:    about 50 us for a T-shirt; in general places of words times places of the rarest colour
 */
MUS_API mus_status mus_pattern_form(const mus_pattern *pattern, const mus_form_def *def, uint8_t *bytes,
                                    size_t capacity, size_t *count, uint64_t *hash);

/* ---- check ---- */

#define MUS_FAULT_OPEN_OUTLINE 1   /* a panel without a closed outline */
#define MUS_FAULT_CROSSING 2       /* an outline that crosses or touches itself */
#define MUS_FAULT_SEAM_LENGTH 3    /* the edges of a seam differ by more than ease and tolerance allow */
#define MUS_FAULT_TWISTED_SEAM 4   /* a seam that leaves the garment without inside and outside */
#define MUS_FAULT_SEWN_TWICE 5     /* an edge in more than one seam, or in more than two that lay pleats */
#define MUS_FAULT_SMALL_PANEL 6    /* a panel with an area below 1 cm2 */
#define MUS_FAULT_LOOSE_EDGE 7     /* an edge of no outline */
/* faults of a pattern that declares its openings */
#define MUS_FAULT_LOOSE_PIECE 8    /* panels that no seam joins to the rest */
#define MUS_FAULT_MIRRORED 9       /* a handle (genus above 0): panels cut mirrored */
#define MUS_FAULT_MISSING_PIECE 10 /* an opening in the place of a declared one: a panel is left off */
#define MUS_FAULT_OPENING 11       /* an opening that is not declared, or that is declared and not there */
#define MUS_FAULT_CLOSED 12        /* a closed bag: nothing can be put in */

/** The faults that a check found: an object of its own, which may outlive the pattern. One context, and all made from
 * it, on one thread at a time. */
typedef struct mus_faults mus_faults;

/**
 * Is a pattern fit to cut and sew? *count gets the number of faults (0: it is), *out the faults.
 *
 * Either may be NULL; without `out` faults are counted only. The pattern stays as it is. A faulty pattern is not an
 * error of the call.
 * Errors:  MUS_ERR_ARG (pattern NULL, count and out both NULL), MUS_ERR_LIMIT, MUS_ERR_MEMORY; *out is NULL then
 * Memory:  *out is the caller's: mus_faults_destroy()
 */
MUS_API mus_status mus_pattern_check(const mus_pattern *pattern, int32_t *count, mus_faults **out);

/** Free the faults of a check; NULL is accepted. */
MUS_API void mus_faults_destroy(mus_faults *faults);

/** How many faults there are, in the order of panels, edges, seams, garment; 0 for NULL. */
MUS_API int32_t mus_faults_count(const mus_faults *faults);

/** One fault: its MUS_FAULT_* kind, and the panel, edge and seam that it is at, MUS_NONE where there is none. Any out
 * may be NULL. Errors: MUS_ERR_ARG (faults NULL, index outside 0 to count - 1). */
MUS_API mus_status mus_faults_item(const mus_faults *faults, int32_t index, int32_t *kind, int32_t *panel,
                                   int32_t *edge, int32_t *seam);

/** The sentence of a fault, which names the cells, the value and the limit; borrowed until the faults are destroyed.
 * NULL outside the range. */
MUS_API const char *mus_faults_text(const mus_faults *faults, int32_t index);

#ifdef __cplusplus
}
#endif

#endif
