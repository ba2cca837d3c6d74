/*
 * muslin/edit.h: a drawn pattern changed as on the cutting table: darts moved, panels cut apart, fullness added, points
 * moved, seams trued; with undo and redo.
 *
 * An edit reads the pattern, works on a copy and replaces the pattern only when it succeeds: after a failure the
 * pattern is as it was, and the context has a sentence that names item, value and limit. Seams, notches, marks, grain,
 * labels and openings are kept. A seam that is divided is divided on both sides. An edge that becomes longer adds the
 * difference to the ease of its seam where the edit says so.
 *
 * Indices of panels, points, edges, seams, notches and marks, and borrowed pointers, hold until the next call of this
 * header. Names stay: find cells by name, or by the index that the call gives back. Every panel must have its outline,
 * and every edge must be in an outline. A panel that is changed is no longer the mirror image of another.
 *
 * A place on an outline is an edge and the arc length s [m] from the start of the edge. A dart is two edges of one
 * panel, one after the other, that are sewn to each other; `leg` may be either edge. The point of a dart is where they
 * meet. Every call may also fail with MUS_ERR_PATTERN (an outline is missing) and MUS_ERR_MEMORY.
 */
#ifndef MUSLIN_EDIT_H
#define MUSLIN_EDIT_H

#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- history ---- */

/** Keep the state of the pattern before each of the last `depth` edits; 0 (as after create) keeps none. A change of
 * `depth` clears the history. A copy of a pattern has no history. Errors: MUS_ERR_ARG (outside 0 to 1000),
 * MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_keep_history(mus_pattern *pattern, int32_t depth);

/** Undo the last edit, and with it the calls of pattern.h since. Every byte of the pattern is as before that edit.
 * Errors: MUS_ERR_ARG (nothing to undo). */
MUS_API mus_status mus_pattern_undo(mus_pattern *pattern);

/** Redo the edit that was undone last. An edit, and a call of pattern.h that changes the pattern, clear the edits to
 * redo.
 * Errors: MUS_ERR_ARG (nothing to redo). */
MUS_API mus_status mus_pattern_redo(mus_pattern *pattern);

/** How many edits can be undone. */
MUS_API int32_t mus_pattern_undo_count(const mus_pattern *pattern);

/** How many edits can be redone. */
MUS_API int32_t mus_pattern_redo_count(const mus_pattern *pattern);

/* ---- darts ---- */

/** Measure a dart: the angle between its legs [rad], the width of its mouth [m], and its depth, the longer leg [m]. Any
 * out may be NULL; all are NaN after a failure. Errors: MUS_ERR_ARG (not the leg of a dart). */
MUS_API mus_status mus_pattern_dart(const mus_pattern *pattern, int32_t leg, double *angle, double *width,
                                    double *depth);

/**
 * Add a dart to an edge: its mouth is `width` [m] wide along the edge about arc length s, its point is at point (2)
 * [m].
 *
 * Legs of different length are trued: both ends of the mouth move to their mean distance from the point. A seam of the
 * edge closes over the mouth. *leg (may be NULL) is a leg of the dart.
 * Errors: MUS_ERR_ARG (a line inside the panel, a mouth beyond the edge, a leg that leaves the panel)
 */
MUS_API mus_status mus_pattern_add_dart(mus_pattern *pattern, int32_t edge, double s, double width, const double *point,
                                        int32_t *leg);

/**
 * Rotate a dart about its point to another place of the outline.
 *
 * The panel is cut from the point to place `s` of edge `target`. The part that does not hold edge `keep` is turned
 * about the point, so that `fraction` (above 0, at most 1) of the angle closes at the old mouth and opens at the
 * target. Area, the lengths of all other edges, the sum of the angles and the sewn topology stay. When the dart closes
 * whole, the edges beside its mouth become one if they were one before (equal attributes and stem of name, no corner).
 * When the target is the mouth of a dart with the same point, the two become one dart. *out (may be NULL) is a leg of
 * the dart at the target, named after the target with "_d1".
 * Errors: MUS_ERR_ARG (a target of another panel, inside the panel or on the dart itself, a fraction out of range, legs
 *         that differ by more than 2 mm, a cut that leaves the panel)
 */
MUS_API mus_status mus_pattern_rotate_dart(mus_pattern *pattern, int32_t leg, int32_t target, double s, int32_t keep,
                                           double fraction, int32_t *out);

/**
 * Split a dart into n: each takes its fraction of the angle to its target. The rest of the angle stays where it is.
 *
 * Shapes:  targets, s, fractions (n), n is 1 to 64; out (n, may be NULL) gets a leg of each dart, in the order given
 * Errors:  as mus_pattern_rotate_dart(); MUS_ERR_ARG (fractions whose sum is above 1)
 */
MUS_API mus_status mus_pattern_split_dart(mus_pattern *pattern, int32_t leg, int32_t n, const int32_t *targets,
                                          const double *s, const double *fractions, int32_t keep, int32_t *out);

/** Close a dart into dart `into` of the same panel, whose point is the same within 1e-6 m; `keep` as in
 * mus_pattern_rotate_dart(). *out (may be NULL) is a leg of the dart that is left. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_merge_darts(mus_pattern *pattern, int32_t leg, int32_t into, int32_t keep, int32_t *out);

/** Move the point of a dart along its bisector, `back` [m] towards its mouth, or away from it when negative. Errors:
 * MUS_ERR_ARG (less than 5 mm of depth left, a leg that leaves the panel). */
MUS_API mus_status mus_pattern_shorten_dart(mus_pattern *pattern, int32_t leg, double back);

/** Release a dart: a straight line closes its mouth, and its cloth is gathered or eased. The ease of a seam over the
 * mouth grows by the width of the mouth; two notches mark it. *out (may be NULL) is the edge that has the mouth now.
 * Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_release_dart(mus_pattern *pattern, int32_t leg, int32_t *out);

/* ---- panels ---- */

/** A line along which a panel is cut in two: from place a to place b of its outline. */
typedef struct mus_cut_def {
    size_t size;
    const char *name;      /* of the new panel */
    const char *seam_name; /* of both new edges */
    int32_t edge_a;        /* place a: arc length s_a [m] of edge_a */
    int32_t edge_b;        /* place b */
    double s_a;
    double s_b;
    int32_t npiece;        /* pieces of the line as in mus_edge_def; 0 (default): straight from a to b */
    int32_t nxy;           /* points in xy, default 0 */
    const int32_t *kinds;  /* (npiece) of MUS_PIECE_* */
    const double *xy;      /* (nxy x 2) [m], without the two ends */
} mus_cut_def;

/** Write the defaults: no names, both edges MUS_NONE, a straight line. */
MUS_API void mus_cut_def_init(mus_cut_def *def, size_t size);

/**
 * Separate a panel along a line from place a to place b of its outline.
 *
 * What the outline passes from a to b becomes the new panel; both new edges are sewn together. *panel and *seam (may be
 * NULL) are the new ones. The sewn topology stays; a face, a seam and two corners are added. A line inside the panel
 * goes with the part that it lies in, from whichever edge a corner is counted.
 * Errors:  MUS_ERR_ARG (places of two panels or on a line inside one, a name that is taken, a line that crosses the
 *          outline), MUS_ERR_VERSION
 */
MUS_API mus_status mus_pattern_separate(mus_pattern *pattern, const mus_cut_def *def, int32_t *panel, int32_t *seam);

/**
 * Make a dart part of a seam that goes on from its point to a place of the outline.
 *
 * The dart is the place a of the cut: edge_a is a leg of it, s_a is not read; b is where the seam ends. When b is the
 * point of another dart, that dart becomes part of the seam too, and no chain is read when both points are one. What
 * the outline passes from the dart to b is the new panel, given back in *panel, and *seam is the seam; both may be
 * NULL.
 * Errors:  as mus_pattern_separate()
 */
MUS_API mus_status mus_pattern_dart_to_seam(mus_pattern *pattern, const mus_cut_def *def, int32_t *panel,
                                            int32_t *seam);

/** Make one panel of the two that a seam joins: the panel of edge_b is moved so that both edges lie on each other, and
 * becomes part of the panel of edge_a, which is *panel (may be NULL). Errors: MUS_ERR_PATTERN (one panel, a twist,
 * edges that differ by more than 1e-6 m). */
MUS_API mus_status mus_pattern_join_panels(mus_pattern *pattern, int32_t seam, int32_t *panel);

/** Add the mirror image of a panel, with its darts, as panel `name`; the panel is cut once more, mirrored. *out (may be
 * NULL) is the image. Errors: MUS_ERR_ARG (a name that is taken). */
MUS_API mus_status mus_pattern_mirror_panel(mus_pattern *pattern, int32_t panel, const char *name, int32_t *out);

/** Unfold a panel that is cut on the fold: the panel and its mirror image in the straight edge `fold` become one panel.
 * Edges of the image have the names of the originals with a last L or R exchanged, or "_r" added. Errors:
 * MUS_ERR_PATTERN (an edge that is sewn or not straight). */
MUS_API mus_status mus_pattern_unfold(mus_pattern *pattern, int32_t fold);

/**
 * Add the facing of a free edge: panel `name`, the mirror image of the strip `width` [m] wide along the edge, sewn to
 * it.
 *
 * The ends of the strip lie on the edges beside the edge. The inner edge of the facing gets the label of the edge,
 * whose place in the boundary loop it takes. *panel (may be NULL) is the facing.
 * Errors: MUS_ERR_ARG (a sewn edge, edges beside it that are shorter than the width, a bend too sharp for the width)
 */
MUS_API mus_status mus_pattern_add_facing(mus_pattern *pattern, int32_t edge, double width, const char *name,
                                          int32_t *panel);

/**
 * Add a patch, such as a patch pocket: panel `name`, sewn onto the right side of a panel along a line inside it.
 *
 * The patch is open between the ends of the line (edge "mouth"). The line becomes n - 1 edges "NAME_line",
 * "NAME_line_2" .. that the outline passes once each way, over a bridge from a corner: nothing is cut,
 * mus_pattern_rim() is as before, and three sheets meet at the line. A mark NAME shows on paper where the patch lies.
 * The patch is placed 6 mm outside the panel. *out (may be NULL) is the patch.
 * Shapes:  xy (n x 2) [m], n is 3 or more
 * Errors:  MUS_ERR_ARG (a point not 2 mm inside the panel, a line that crosses itself or encloses less than 1 cm2, a
 *          name that is taken)
 */
MUS_API mus_status mus_pattern_add_patch(mus_pattern *pattern, int32_t panel, const char *name, int32_t n,
                                         const double *xy, int32_t *out);

/** Remove a panel with its seams, notches and marks. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_remove_panel(mus_pattern *pattern, int32_t panel);

/** Remove a seam: its edges are free. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_remove_seam(mus_pattern *pattern, int32_t seam);

/* ---- fullness and length ---- */

/**
 * Slash from place a to place b and spread.
 *
 * The part that the outline passes from a to b moves as a rigid piece, so that the slash opens by w_a at a and by w_b
 * at b [m]: equal widths spread it parallel (gathers), a width of 0 hinges it (flare). The gaps become parts of the two
 * edges, and the ease of their seams grows by the gaps.
 * Errors: MUS_ERR_ARG (a negative width, both widths 0, a difference beyond the length of the slash; a slash that
 *          leaves
 *         the panel or ends at a line inside it, where the cloth hangs together; a line that hangs from the corner
 *         between the slash and the given edge)
 */
MUS_API mus_status mus_pattern_spread(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b,
                                      double w_a, double w_b);

/** Flare a panel: n (1 to 64) even slashes from edge `hem` to edge `hinge`, hinged there, open the hem by `amount` [m]
 * together. The hem is made fair afterwards. The part before the first slash along the hem stays. Errors: as
 * mus_pattern_spread(). */
MUS_API mus_status mus_pattern_flare(mus_pattern *pattern, int32_t hem, int32_t hinge, int32_t n, double amount);

/** Add a pleat from place a to place b, `depth_a` and `depth_b` [m] deep: the panel is spread by twice the depth. Marks
 * "pleat" show where it is laid, a mark "fold" lies between them, and notches stand where it meets the edges. Errors:
 * as mus_pattern_spread(). */
MUS_API mus_status mus_pattern_pleat(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b,
                                     double depth_a, double depth_b);

/**
 * Lay n knife pleats (1 to 256) on an edge. Two that face each other make a box pleat or an inverted pleat.
 *
 * Pleat i has an outer fold at arc length s[i] and is |depths[i]| [m] deep. It lies under the part before the fold
 * along the edge when depths[i] > 0, and under the part after it when depths[i] < 0. The edge is split at the folds. A
 * part that lies under another is sewn to it (a seam with `laid`). A part that shows takes the place of the edge in its
 * seam, which becomes shorter by 2 |depths[i]| a pleat; the rest of the difference in length is kept as ease. Notches
 * stand at both folds. Pleats come in order and lie clear of each other: each takes from s - d to s + 2 d, or from s -
 * 2 d to s + d.
 * Shapes:  s, depths (n)
 * Errors:  MUS_ERR_ARG (a pleat beyond the edge or on another, an edge that is sewn face to face or inside the panel)
 */
MUS_API mus_status mus_pattern_lay_pleats(mus_pattern *pattern, int32_t edge, int32_t n, const double *s,
                                          const double *depths);

/**
 * Lengthen a panel across the line through point (2) along direction (2); a negative `amount` [m] shortens it.
 *
 * The part to the left of the line moves by `amount` square to it. Edges that cross the line are drawn again between
 * their ends: a line stays a line, curves keep their tangents at the ends, arcs keep their angle. Seams take the
 * difference as ease, so true the seam or lengthen the other panel too.
 * Errors: MUS_ERR_ARG (no direction, a number that is not finite, a panel that would have no cloth left)
 */
MUS_API mus_status mus_pattern_lengthen(mus_pattern *pattern, int32_t panel, const double *point,
                                        const double *direction, double amount);

/* ---- points and edges ---- */

/** Move a point to (x, y) [m]; curves that end there move their nearest control point along. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_move_point(mus_pattern *pattern, int32_t point, double x, double y);

/** Move point `index` (1 to nxy - 2) of the chain of an edge, as mus_pattern_edge_pieces() counts them, to (x, y) [m].
 * It is a control point, the middle of an arc, which stays on the bisector of its chord, or a joint of two pieces,
 * which moves the control points beside it along. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_move_control(mus_pattern *pattern, int32_t edge, int32_t index, double x, double y);

/** Draw an edge again between its ends: kinds (npiece), xy (nxy x 2) [m] without the ends. Notches keep their relative
 * arc length. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_redraw_edge(mus_pattern *pattern, int32_t edge, int32_t npiece, const int32_t *kinds,
                                           int32_t nxy, const double *xy);

/** Draw an edge with corners again as one smooth line, with the fewest cubics that stay `within` [m] of it. Its ends
 * and the tangents there are kept; its seam takes the difference in length as ease. Errors: MUS_ERR_ARG (within not in
 * 1e-6 to 1). */
MUS_API mus_status mus_pattern_fair_edge(mus_pattern *pattern, int32_t edge, double within);

/** Split an edge at arc length s [m], and the edges that it is sewn to with it. The part that the outline passes first
 * keeps the name; *out (may be NULL) is the other part, called `name`, or the old name with a number when that is NULL.
 * Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_split_edge(mus_pattern *pattern, int32_t edge, double s, const char *name, int32_t *out);

/** Merge `edge` and the next edge of the outline into one, *out (may be NULL). Both are unsewn, or are sewn to two
 * edges that follow each other. Errors: MUS_ERR_PATTERN (their seams part). */
MUS_API mus_status mus_pattern_merge_edges(mus_pattern *pattern, int32_t edge, int32_t *out);

/* ---- seams ---- */

/** Measures of the two edges of a seam walked along each other. */
typedef struct mus_seam_walk {
    size_t size;
    double length_a; /* [m] */
    double length_b;
    double excess; /* length of b less length of a less ease [m]; 0 when the seam is true */
    int32_t notches_a; /* without those at an end, which stand for a joint of the edges that are sewn on there */
    int32_t notches_b;
    double notch_off;    /* greatest distance between the notches of a pair, ease spread evenly [m]; NaN: no pairs */
    double corner_start; /* angle of both panels together at the start of a [rad]; pi is a smooth line */
    double corner_end;   /* the same at the end of a */
} mus_seam_walk;

/** Write the size; every other field is 0. */
MUS_API void mus_seam_walk_init(mus_seam_walk *walk, size_t size);

/** Walk a seam: measure its two edges against each other. out->size is set by mus_seam_walk_init(). Errors:
 * MUS_ERR_ARG, MUS_ERR_PATTERN (an edge in no outline), MUS_ERR_VERSION. */
MUS_API mus_status mus_pattern_walk_seam(const mus_pattern *pattern, int32_t seam, mus_seam_walk *out);

/** True a seam: `edge`, one of its two, gets the length of the other edge plus or less the ease. Its end (at_end 1) or
 * its start (0) moves along the tangent there, and the edge beside it follows. Errors: MUS_ERR_ARG (an edge of another
 * seam), MUS_ERR_PATTERN (no place of that end gives the length). */
MUS_API mus_status mus_pattern_true_seam(mus_pattern *pattern, int32_t seam, int32_t edge, int32_t at_end);

/** Put a notch of `kind` (MUS_NOTCH_*) on the seam of an edge: at arc length s [m] of the edge, and at the same
 * relative arc length on every edge that is sewn to it, directly or through others. mus_pattern_add_notch() puts one on
 * one edge alone. Errors: MUS_ERR_ARG (kind, or s beyond the edge), MUS_ERR_LIMIT (more than 64 edges are sewn to one
 * another there), MUS_ERR_PATTERN (an edge is sewn to itself the other way round). */
MUS_API mus_status mus_pattern_notch_seam(mus_pattern *pattern, int32_t edge, double s, int32_t kind);

#ifdef __cplusplus
}
#endif

#endif
