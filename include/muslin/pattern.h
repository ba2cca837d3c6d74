/*
 * muslin/pattern.h: a sewing pattern as a cell complex.
 *
 * Points are 0-cells, edges 1-cells (each a chain of lines, arcs, quadratic and cubic Beziers: a new edge starts only
 * where a seam or an opening starts), panels 2-cells. A panel's attaching map is the cyclic word of its oriented
 * edges; the right side of the cloth is the side from which that word runs counter-clockwise. A seam makes two edges
 * equivalent; the quotient's topology tells what was sewn. A line inside a panel is an edge that its word passes once
 * each way: nothing is cut there, and what is sewn to it is a third sheet (a patch pocket; muslin/edit.h lays one).
 * Source: Metaaphanon and Kanongchaiyos 2005, section 5, eq. 13 to 20.
 *
 * Units: metre, in the plane of each panel (x right, y up; y is the warp unless the grain says otherwise).
 * Indices are int32_t, count from 0, and are stable: nothing is ever removed from a pattern by the calls below. The
 * edits of muslin/edit.h cut, join and remove: after one of them indices and borrowed pointers are new, names stay.
 */
#ifndef MUSLIN_PATTERN_H
#define MUSLIN_PATTERN_H

#include "muslin/base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mus_pattern mus_pattern;

/* Pieces of an edge, and how many control points stand between the ends of each: line 0, quadratic 1, cubic 2,
 * arc 1 (the point half way along the arc). */
#define MUS_PIECE_LINE 0
#define MUS_PIECE_QUADRATIC 1
#define MUS_PIECE_CUBIC 2
#define MUS_PIECE_ARC 3

/* How the sides of a seam run. REVERSED: the start of a meets the end of b, right sides out (two panels that are both
 * drawn counter-clockwise). DIRECT: start meets start (a piece laid face to face, or a twist). */
#define MUS_SEAM_REVERSED 0
#define MUS_SEAM_DIRECT 1

MUS_API mus_status mus_pattern_create(mus_context *context, const char *name, mus_pattern **out);
MUS_API mus_status mus_pattern_copy(const mus_pattern *pattern, mus_pattern **out);
MUS_API void mus_pattern_destroy(mus_pattern *pattern);

/** The context that the pattern was made from. */
MUS_API mus_context *mus_pattern_context(const mus_pattern *pattern);

/** Name of the pattern (never NULL), and setting it. Names anywhere in a pattern are UTF-8 of at most 127 bytes. */
MUS_API const char *mus_pattern_name(const mus_pattern *pattern);
MUS_API mus_status mus_pattern_set_name(mus_pattern *pattern, const char *name);

/* ---- edit: cells ---- */

/** Add a panel without outline. Errors: MUS_ERR_ARG (name NULL, empty or taken), MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_add_panel(mus_pattern *pattern, const char *name, int32_t *out);

/** Add a point to the plane of a panel. Errors: MUS_ERR_ARG (panel unknown, x or y beyond 1e6 m), MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_add_point(mus_pattern *pattern, int32_t panel, double x, double y, int32_t *out);

/** An edge to be added: a chain of pieces between two points of one panel. */
typedef struct mus_edge_def {
    size_t size;
    const char *name;     /* within its panel ("hem", "shoulder_left"), default NULL: none */
    int32_t start;        /* a point */
    int32_t end;          /* another point of the panel, or the same for a loop */
    int32_t npiece;       /* pieces of the chain; 0 (default): one straight line */
    int32_t nxy;          /* points in xy, default 0 */
    const int32_t *kinds; /* (npiece) of MUS_PIECE_* */
    const double *xy;     /* (nxy x 2) the control points and inner joints of the chain in order [m], without the first
                           * and last point: for each piece its control points, then, but for the last piece, its end
                           * (so a line has none, a cubic 2, a line then a cubic 1 + 2) */
} mus_edge_def;

/** Write the defaults: no name, start and end MUS_NONE, a straight line. */
MUS_API void mus_edge_def_init(mus_edge_def *def, size_t size);

/**
 * Add an edge to the panel of its two points. *out (may be NULL) is its index.
 *
 * Errors:  MUS_ERR_ARG (unknown points, points of two panels, a wrong count of xy points, one not within 1e6 m, an arc
 *          whose middle point is nearer to one end, an edge of length 0); MUS_ERR_VERSION; MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_add_edge(mus_pattern *pattern, const mus_edge_def *def, int32_t *out);

/**
 * Give a panel its attaching map: `n` edges in order, direction[i] +1 along or -1 against the edge.
 *
 * Errors: MUS_ERR_ARG (an edge of another panel, or one that does not start where the one before ended; the first
 *         follows the last: an outline is always closed)
 */
MUS_API mus_status mus_pattern_set_outline(mus_pattern *pattern, int32_t panel, int32_t n, const int32_t *edges,
                                           const int32_t *directions);

/** Label of an edge: the opening or role that the edge plays ("hem", "neck", "cuff", "left_armhole"), "" for none. */
MUS_API mus_status mus_pattern_set_edge_label(mus_pattern *pattern, int32_t edge, const char *label);

/** Seam allowance of an edge [m]; NaN (the default) leaves it to the sheet. Errors: MUS_ERR_ARG (< 0, > 0.2). */
MUS_API mus_status mus_pattern_set_edge_allowance(mus_pattern *pattern, int32_t edge, double allowance);

/* Where on the body an edge is held up: girths of the torso, then of the arm or leg that the edge starts round. */
#define MUS_HOLD_NONE 0
#define MUS_HOLD_NECK 1   /* a collar, the strap of a halter */
#define MUS_HOLD_ARMPIT 2 /* a strapless top */
#define MUS_HOLD_BUST 3
#define MUS_HOLD_WAIST 4 /* a waistband */
#define MUS_HOLD_HIP 5
#define MUS_HOLD_CROTCH 6
#define MUS_HOLD_BICEPS 7
#define MUS_HOLD_WRIST 8
#define MUS_HOLD_THIGH 9
#define MUS_HOLD_KNEE 10
#define MUS_HOLD_ANKLE 11
#define MUS_HOLD_COUNT 12

/** Name of a hold ("waist"), NULL outside the range; and the hold of a name, MUS_NONE without. */
MUS_API const char *mus_hold_name(int32_t level);
MUS_API int32_t mus_hold_find(const char *name);

/**
 * An edge that does not slide down: a drape keeps it from going more than `below` under the level on its body.
 *
 * The edge moves freely along the skin and up. MUS_HOLD_NONE (the default) lets go. A body that has not the level (one
 * of given limbs) holds nothing. hold_label: all edges with that label; `count` (may be NULL) gets how many there are.
 * Units:   below [m], -1 to 1
 * Errors:  MUS_ERR_ARG
 */
MUS_API mus_status mus_pattern_set_edge_hold(mus_pattern *pattern, int32_t edge, int32_t level, double below);
MUS_API mus_status mus_pattern_hold_label(mus_pattern *pattern, const char *label, int32_t level, double below,
                                          int32_t *count);

/**
 * An elastic along an edge (a casing, a rib): `ratio` times as long as the edge at rest, `stiffness` [N] the force that
 * would stretch it to double length. Stiffness 0 (the default): none.
 *
 * A soft rib has 20 N, an elastic 2 cm wide 60 N, a waistband that hardly stretches 1000 N.
 * Errors:  MUS_ERR_ARG (ratio outside 0.1 to 1, stiffness outside 0 to 1e6)
 */
MUS_API mus_status mus_pattern_set_edge_elastic(mus_pattern *pattern, int32_t edge, double ratio, double stiffness);

/* What closes a seam that can be opened: nothing (it is sewn), a zip, buttons. */
#define MUS_CLOSURE_NONE 0
#define MUS_CLOSURE_ZIP 1
#define MUS_CLOSURE_BUTTONS 2

/** Options of a seam. */
typedef struct mus_seam_def {
    size_t size;
    int32_t edge_a;
    int32_t edge_b;
    int32_t direction; /* MUS_SEAM_REVERSED (default) or MUS_SEAM_DIRECT */
    double ease;       /* length of b less length of a that the design means [m], default 0 */
    double tolerance;  /* what the check allows beyond ease [m], default 0.0005 */
    int32_t laid;      /* nonzero: layers of a pleat, a on b. An edge may be in two such seams beside one other */
    int32_t closure;   /* MUS_CLOSURE_*, default MUS_CLOSURE_NONE */
    int32_t open;      /* nonzero: a closure that is left open: a cloth does not join it; default 0 */
    int32_t buttons;   /* of MUS_CLOSURE_BUTTONS: done up at so many points alone, evenly from half a gap from both
                        * ends; 0 (default): along its whole length, as where it laps over; at most 1000 */
} mus_seam_def;

MUS_API void mus_seam_def_init(mus_seam_def *def, size_t size);

/** Sew two edges (of one panel or two). The topology is that of the garment done up. Errors: MUS_ERR_ARG (unknown edge,
 * an edge with itself, not finite, open or buttons of what is no closure). */
MUS_API mus_status mus_pattern_add_seam(mus_pattern *pattern, const mus_seam_def *def, int32_t *out);

/** Leave all closures open (nonzero), or do them up (0); `count` (may be NULL) gets how many there are. */
MUS_API mus_status mus_pattern_open_closures(mus_pattern *pattern, int32_t open, int32_t *count);

/* ---- edit: marks and making up ---- */

#define MUS_NOTCH_SINGLE 1
#define MUS_NOTCH_DOUBLE 2
#define MUS_NOTCH_TRIPLE 3

/** A notch on an edge at arc length s [m] from its start. Errors: MUS_ERR_ARG (s more than 1e-9 outside the edge). */
MUS_API mus_status mus_pattern_add_notch(mus_pattern *pattern, int32_t edge, double s, int32_t kind, int32_t *out);

/** An interior line or mark of a panel: n points (n x 2), with a name ("centre front"). n = 1 is a drill point. */
MUS_API mus_status mus_pattern_add_mark(mus_pattern *pattern, int32_t panel, const char *name, int32_t n,
                                        const double *xy, int32_t *out);

/** Direction of the warp in the plane of a panel, default (0, 1). Errors: MUS_ERR_ARG (zero or not finite). */
MUS_API mus_status mus_pattern_set_grain(mus_pattern *pattern, int32_t panel, double x, double y);

/** How a panel is cut: `count` pieces in all; `mirror_of` the panel whose mirror image it is, or MUS_NONE. Panels that
 * mirror another are not printed: the printed one says "cut 2 mirrored". */
MUS_API mus_status mus_pattern_set_cut(mus_pattern *pattern, int32_t panel, int32_t count, int32_t mirror_of);

/** Label of a panel ("body", "arm", "leg", free text). */
MUS_API mus_status mus_pattern_set_panel_label(mus_pattern *pattern, int32_t panel, const char *label);

/** Declare an opening that the sewn garment is to have, by the label of its rim ("neck"; twice for two cuffs). A
 * pattern that declares any is checked as a garment: see mus_pattern_check(). Errors: MUS_ERR_ARG (an empty label). */
MUS_API mus_status mus_pattern_add_opening(mus_pattern *pattern, const char *label);

/**
 * Where a panel starts before sewing.
 *
 * A point (x, y) of the panel goes to  origin + rotation * p,  with  p = (x, y, 0)  when bend is 0, else the panel is
 * rolled round an axis parallel to its y at distance |bend| behind (bend > 0) or before (bend < 0) its plane:
 * u = x - bend_x,  p = (bend_x + bend sin(u/bend), y, bend (cos(u/bend) - 1)).
 * rotation is row-major: its columns are the images of the panel's x, y and normal.
 */
typedef struct mus_placement {
    size_t size;
    double origin[3];   /* [m] */
    double rotation[9]; /* orthonormal, determinant +1; default identity */
    double bend;        /* radius [m], 0 flat (default) */
    double bend_x;      /* the line x = bend_x keeps its place, default 0 */
    double fold;        /* of a panel with pleats: it starts folded at each, to this part of its depth, 0 (default:
                         * flat) to 1; the panel's middle keeps its place */
} mus_placement;

MUS_API void mus_placement_init(mus_placement *placement, size_t size);
MUS_API mus_status mus_pattern_set_placement(mus_pattern *pattern, int32_t panel, const mus_placement *placement);
MUS_API mus_status mus_pattern_placement(const mus_pattern *pattern, int32_t panel, mus_placement *out);

/* ---- edit: garments over one another ---- */

#define MUS_LAYERS_MOST 16

/** Layer of a panel: 0 (the default) next to the skin, each next one worn over it. A drape with self_contact sews and
 * drapes layer after layer, from inside to outside. Errors: MUS_ERR_ARG (layer outside 0 to 15). */
MUS_API mus_status mus_pattern_set_layer(mus_pattern *pattern, int32_t panel, int32_t layer);

/** Layer of a panel, MUS_NONE for one that is unknown. */
MUS_API int32_t mus_pattern_layer(const mus_pattern *pattern, int32_t panel);

/**
 * Another garment over a pattern: all cells of `other` are added to it, its panels in `layer`.
 *
 * Indices of the pattern stay; those of `other` go on behind them. A panel whose name is taken gets that of its pattern
 * before it. Openings that the pattern declared are forgotten: garments over one another are no one garment.
 * Errors: MUS_ERR_ARG (other NULL, layer outside 0 to 15), MUS_ERR_MEMORY; the pattern is then as it was.
 */
MUS_API mus_status mus_pattern_join(mus_pattern *pattern, const mus_pattern *other, int32_t layer);

/* ---- query ---- */

MUS_API int32_t mus_pattern_panel_count(const mus_pattern *pattern);
MUS_API int32_t mus_pattern_point_count(const mus_pattern *pattern);
MUS_API int32_t mus_pattern_edge_count(const mus_pattern *pattern);
MUS_API int32_t mus_pattern_seam_count(const mus_pattern *pattern);
MUS_API int32_t mus_pattern_notch_count(const mus_pattern *pattern);
MUS_API int32_t mus_pattern_mark_count(const mus_pattern *pattern);
MUS_API int32_t mus_pattern_opening_count(const mus_pattern *pattern);

/** Label of a declared opening; NULL outside the range. */
MUS_API const char *mus_pattern_opening(const mus_pattern *pattern, int32_t opening);

/** Find by name: MUS_NONE if there is none. */
MUS_API int32_t mus_pattern_find_panel(const mus_pattern *pattern, const char *name);
MUS_API int32_t mus_pattern_find_edge(const mus_pattern *pattern, int32_t panel, const char *name);

/** A panel: name, label (NULL outside the range), its outline (borrowed until the next edit; any out may be NULL),
 * grain (2), cut count and mirror_of. */
MUS_API const char *mus_pattern_panel_name(const mus_pattern *pattern, int32_t panel);
MUS_API const char *mus_pattern_panel_label(const mus_pattern *pattern, int32_t panel);
MUS_API mus_status mus_pattern_outline(const mus_pattern *pattern, int32_t panel, int32_t *n, const int32_t **edges,
                                       const int32_t **directions);

/** What is cut on the table: the outline without lines inside the panel and the bridges to them (an edge and, next in
 * the outline, the same edge back; taken out until there are none). At most `capacity` edges and directions are written
 * (either may be NULL), *count is how many there are. Errors: MUS_ERR_ARG, MUS_ERR_PATTERN (a panel without outline),
 * MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_rim(const mus_pattern *pattern, int32_t panel, int32_t *edges, int32_t *directions,
                                   int32_t capacity, int32_t *count);

MUS_API mus_status mus_pattern_grain(const mus_pattern *pattern, int32_t panel, double *out);
MUS_API mus_status mus_pattern_cut(const mus_pattern *pattern, int32_t panel, int32_t *count, int32_t *mirror_of);

/** A point: its panel and place (2) [m]. */
MUS_API mus_status mus_pattern_point(const mus_pattern *pattern, int32_t point, int32_t *panel, double *xy);

/** An edge: panel, ends, name and label. */
MUS_API int32_t mus_pattern_edge_panel(const mus_pattern *pattern, int32_t edge);
MUS_API mus_status mus_pattern_edge_ends(const mus_pattern *pattern, int32_t edge, int32_t *start, int32_t *end);
MUS_API const char *mus_pattern_edge_name(const mus_pattern *pattern, int32_t edge);
MUS_API const char *mus_pattern_edge_label(const mus_pattern *pattern, int32_t edge);
MUS_API double mus_pattern_edge_allowance(const mus_pattern *pattern, int32_t edge);

/** What keeps an edge up: MUS_HOLD_* and how far below it [m]; ratio and stiffness [N] of its elastic. Any out may be
 * NULL. */
MUS_API mus_status mus_pattern_edge_hold(const mus_pattern *pattern, int32_t edge, int32_t *level, double *below);
MUS_API mus_status mus_pattern_edge_elastic(const mus_pattern *pattern, int32_t edge, double *ratio, double *stiffness);

/** The chain of an edge: kinds (npiece) and all its points with both ends (nxy x 2). Borrowed until the next edit. */
MUS_API mus_status mus_pattern_edge_pieces(const mus_pattern *pattern, int32_t edge, int32_t *npiece,
                                           const int32_t **kinds, int32_t *nxy, const double **xy);

/** Length of an edge [m] to 1e-9 (closed form for lines and arcs, Gauss-Legendre for the rest); NaN if unknown. */
MUS_API double mus_pattern_edge_length(const mus_pattern *pattern, int32_t edge);

/** Points of an edge at `n` relative arc lengths t (0 start .. 1 end): out (n x 2) [m]. */
MUS_API mus_status mus_pattern_edge_at(const mus_pattern *pattern, int32_t edge, int32_t n, const double *t,
                                       double *out);

/** An edge as a polyline: each curved piece as `chords` chords of equal parameter, each line as one. Writes at most
 * `capacity` points (x 2), both ends included; *count is how many there are. xy NULL counts only. */
MUS_API mus_status mus_pattern_edge_polyline(const mus_pattern *pattern, int32_t edge, int32_t chords, double *xy,
                                             int32_t capacity, int32_t *count);

/** Area enclosed by a panel [m2], always >= 0, closed form; and its perimeter [m], of edges that are passed one way
 * only. NaN without an outline. */
MUS_API double mus_pattern_panel_area(const mus_pattern *pattern, int32_t panel);
MUS_API double mus_pattern_panel_perimeter(const mus_pattern *pattern, int32_t panel);

/** A seam's definition (out->size set by the caller through mus_seam_def_init). */
MUS_API mus_status mus_pattern_seam(const mus_pattern *pattern, int32_t seam, mus_seam_def *out);

/** The seam that an edge is in, or MUS_NONE. */
MUS_API int32_t mus_pattern_edge_seam(const mus_pattern *pattern, int32_t edge);

MUS_API mus_status mus_pattern_notch(const mus_pattern *pattern, int32_t notch, int32_t *edge, double *s,
                                     int32_t *kind);
MUS_API mus_status mus_pattern_mark(const mus_pattern *pattern, int32_t mark, int32_t *panel, const char **name,
                                    int32_t *n, const double **xy);

#ifdef __cplusplus
}
#endif

#endif
