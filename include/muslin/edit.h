/*
 * muslin/edit.h: a drawn pattern changed as on the cutting table: darts moved, panels cut apart, fullness added, points
 * moved, seams trued; with undo and redo.
 *
 * An edit reads the pattern, works on a copy and puts the result in its place only when all went well: after a failure
 * the pattern is as it was, and the context has a sentence that names item, value and limit. Seams, notches, marks,
 * grain, labels and openings go along. A seam that is divided is divided on both sides; an edge that is drawn longer
 * takes what it grew by as ease where the edit says so.
 *
 * Indices of panels, points, edges, seams, notches and marks, and all that was borrowed, hold until the next call of
 * this header; names stay, so find by name, or by what the call gives back. Every panel must have its outline, and
 * every edge must be in one. Panels that were mirror images of one another are so no longer when one of them is
 * changed.
 *
 * A place on an outline is an edge and the arc length s [m] from the start of the edge. A dart is two edges of one
 * panel, one after the other, that are sewn to each other; `leg` may be either. Its point is where they meet.
 */
#ifndef MUSLIN_EDIT_H
#define MUSLIN_EDIT_H

#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- history ---- */

/** Keep what the pattern was before each of the last `depth` edits, 0 (as after create) none. What is kept already is
 * forgotten when `depth` changes. A copy of a pattern has no history. Errors: MUS_ERR_ARG (outside 0 to 1000),
 * MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_keep_history(mus_pattern *pattern, int32_t depth);

/** Go back to before the last edit, with it what calls of pattern.h changed since; forward again. Every byte of the
 * pattern is what it was. A call of pattern.h, and an edit, end what there is to redo. Errors: MUS_ERR_ARG (nothing to
 * undo or redo). */
MUS_API mus_status mus_pattern_undo(mus_pattern *pattern);
MUS_API mus_status mus_pattern_redo(mus_pattern *pattern);

/** How many edits can be undone, and redone. */
MUS_API int32_t mus_pattern_undo_count(const mus_pattern *pattern);
MUS_API int32_t mus_pattern_redo_count(const mus_pattern *pattern);

/* ---- darts ---- */

/** A dart: angle between its legs [rad], width of its mouth [m], and depth, the longer leg [m]. Any out may be NULL.
 * Errors: MUS_ERR_ARG (no leg of a dart). */
MUS_API mus_status mus_pattern_dart(const mus_pattern *pattern, int32_t leg, double *angle, double *width,
                                    double *depth);

/** A dart on an edge: its mouth `width` wide along the edge about s, its point at point (2). Legs that would differ are
 * trued: both ends of the mouth come to the mean distance from the point. A seam of the edge closes over the mouth.
 * Errors: MUS_ERR_ARG (an edge inside the panel, the mouth beyond it, a leg that leaves the panel). `leg` may be NULL.
 */
MUS_API mus_status mus_pattern_add_dart(mus_pattern *pattern, int32_t edge, double s, double width, const double *point,
                                        int32_t *leg);

/**
 * Move a dart: pivot about its point.
 *
 * The panel is cut from the point to place `s` of edge `target`; the part that does not hold edge `keep` is turned
 * about the point so that `fraction` (0 to 1) of the angle closes, and opens at the target. Area, lengths of all else
 * and the sum of the angles stay; the sewn topology too. Closed whole, the edges beside the old mouth become one where
 * they were one (equal label and stem of name, no corner). When the target is the mouth of a dart with the same point,
 * the two become one dart. *out (may be NULL) is a leg of the dart at the target, named target name + "_d1". Errors:
 * MUS_ERR_ARG (target of another panel, inside it or the dart's own, a fraction not in 0 to 1, legs that differ by more
 * than 2 mm, a cut that leaves the panel)
 */
MUS_API mus_status mus_pattern_rotate_dart(mus_pattern *pattern, int32_t leg, int32_t target, double s, int32_t keep,
                                           double fraction, int32_t *out);

/** Split a dart into n: targets, s and fractions (n each) of the angle, together 1 at most; what is left stays where it
 * is. out (n, may be NULL) gets a leg of each, in the order given. Errors: as mus_pattern_rotate_dart(), and fractions
 * that are together more than 1. */
MUS_API mus_status mus_pattern_split_dart(mus_pattern *pattern, int32_t leg, int32_t n, const int32_t *targets,
                                          const double *s, const double *fractions, int32_t keep, int32_t *out);

/** Close a dart into another of the same panel whose point is the same within 1e-6 m. */
MUS_API mus_status mus_pattern_merge_darts(mus_pattern *pattern, int32_t leg, int32_t into, int32_t keep, int32_t *out);

/** Move the point of a dart `back` [m] towards its mouth (away from it when negative) along the bisector. */
MUS_API mus_status mus_pattern_shorten_dart(mus_pattern *pattern, int32_t leg, double back);

/** Forget a dart: its mouth is closed by a straight line and its cloth is gathered or eased: a seam over it grows in
 * ease by the width of the mouth, two notches say where. *out (may be NULL) is the edge that has the mouth now. */
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
 * point of another dart, that dart becomes part of the seam too, and no chain is read when both points are one. What the
 * outline passes from the dart to b is the new panel, given back in *panel, and *seam is the seam; both may be NULL.
 * Errors:  as mus_pattern_separate()
 */
MUS_API mus_status mus_pattern_dart_to_seam(mus_pattern *pattern, const mus_cut_def *def, int32_t *panel,
                                            int32_t *seam);

/** Make one panel of the two that a seam joins: that of edge_b is moved so that the edges lie on each other, and is
 * taken in. Errors: MUS_ERR_PATTERN (one panel, a twist, edges that differ by more than 1e-6 m). */
MUS_API mus_status mus_pattern_join_panels(mus_pattern *pattern, int32_t seam, int32_t *panel);

/** The mirror image of a panel as a new one, with its darts; the panel is cut once more, mirrored. */
MUS_API mus_status mus_pattern_mirror_panel(mus_pattern *pattern, int32_t panel, const char *name, int32_t *out);

/** A panel cut on the fold, opened: with its mirror image in the straight edge `fold` it is one panel. Edges of the
 * image have the names of the others with a last L or R exchanged, or "_r" added. */
MUS_API mus_status mus_pattern_unfold(mus_pattern *pattern, int32_t fold);

/** A facing of a free edge: a panel `name` as the mirror image of the strip `width` [m] wide along the edge, its ends
 * those of the edges beside it, sewn to the edge. Its inner edge has the label of the edge, whose place as a rim it
 * takes. Errors: MUS_ERR_ARG (a sewn edge, edges beside it shorter than the width, a bend too sharp for it). */
MUS_API mus_status mus_pattern_add_facing(mus_pattern *pattern, int32_t edge, double width, const char *name,
                                          int32_t *panel);

/**
 * A patch, as a patch pocket is: a panel `name` sewn onto the right side of a panel along the line through n points
 * (xy, n x 2, 3 or more) inside it, and open between the ends of the line (edge "mouth").
 *
 * The line becomes n - 1 edges "NAME_line", "NAME_line_2" .. that the outline passes once each way, over a bridge from
 * a corner: nothing is cut, mus_pattern_rim() is as before, and three sheets meet there. A mark NAME shows on paper
 * where the patch lies. The patch is drawn as it lies and starts 6 mm outside the panel.
 * Errors:  MUS_ERR_ARG (a point not 2 mm inside the panel, a line that crosses itself or encloses less than 1 cm2, a
 *          name that is taken)
 */
MUS_API mus_status mus_pattern_add_patch(mus_pattern *pattern, int32_t panel, const char *name, int32_t n,
                                         const double *xy, int32_t *out);

/** Take a panel away, with its seams, notches and marks; and open a seam. */
MUS_API mus_status mus_pattern_remove_panel(mus_pattern *pattern, int32_t panel);
MUS_API mus_status mus_pattern_remove_seam(mus_pattern *pattern, int32_t seam);

/* ---- fullness and length ---- */

/**
 * Slash from place a to place b and spread: what the outline passes from a to b moves as a rigid piece, so that the
 * slash opens by w_a at a and w_b at b [m]: equal is parallel (gathers), 0 is a hinge (flare). The gaps become part of
 * the two edges, whose seams grow in ease by them. Errors: MUS_ERR_ARG (negative, both 0, or of a difference beyond the
 * slash; a slash that leaves the panel or ends at a line inside it, as a patch is sewn to: the cloth hangs together
 * there; a line that hangs from the corner between the slash and the edge given)
 */
MUS_API mus_status mus_pattern_spread(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b,
                                      double w_a, double w_b);

/** Flare: n (1 to 64) even slashes from edge `hem` to edge `hinge`, hinged there, which open the hem by `amount` in
 * all; the hem is made fair afterwards. What is before the first slash along the hem stays. */
MUS_API mus_status mus_pattern_flare(mus_pattern *pattern, int32_t hem, int32_t hinge, int32_t n, double amount);

/** A pleat from place a to place b, `depth_a` and `depth_b` deep [m]: spread by twice that, with marks "pleat" where it
 * is laid, "fold" between them, and notches where it meets the edges. */
MUS_API mus_status mus_pattern_pleat(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b,
                                     double depth_a, double depth_b);

/**
 * Lay n pleats (1 to 256) on an edge: at arc length s[i] an outer fold, |depths[i]| deep, under what comes before it
 * along the edge (depths[i] > 0) or after it: a knife pleat; two that face each other, a box pleat or an inverted one.
 *
 * The edge parts at the folds. The parts that lie under another are sewn to it (seams with `laid`); those that show are
 * sewn, in its place, to what the edge was sewn to, whose seam is so much shorter: 2 |depths[i]| each. Notches stand at
 * both folds. Pleats come in order and lie clear of each other: each takes from s - d to s + 2 d, or from s - 2 d to
 * s + d. A seam keeps as ease what the pleats leave.
 * Errors:  MUS_ERR_ARG (a pleat beyond the edge or on another, an edge that is sewn face to face or inside the panel)
 */
MUS_API mus_status mus_pattern_lay_pleats(mus_pattern *pattern, int32_t edge, int32_t n, const double *s,
                                          const double *depths);

/** Lengthen a panel across the line through point (2) along direction (2): what lies to the left of it moves by
 * `amount` [m] square to it (negative: shorten). Edges that cross are drawn again between their ends: a line stays a
 * line, curves keep their tangents at the ends, arcs their angle; seams take the difference as ease, so true or
 * lengthen the other side too. Errors: MUS_ERR_ARG (no direction, not finite, nothing left of the panel). */
MUS_API mus_status mus_pattern_lengthen(mus_pattern *pattern, int32_t panel, const double *point,
                                        const double *direction, double amount);

/* ---- points and edges ---- */

/** Move a point to (x, y); the curves that end there take their nearest control point along. */
MUS_API mus_status mus_pattern_move_point(mus_pattern *pattern, int32_t point, double x, double y);

/** Move point `index` (1 to nxy - 2) of the chain of an edge, as mus_pattern_edge_pieces() counts them: a control
 * point, the middle of an arc (as far as it stays in its middle), or a joint of pieces, which takes its control points
 * along. */
MUS_API mus_status mus_pattern_move_control(mus_pattern *pattern, int32_t edge, int32_t index, double x, double y);

/** Draw an edge again between its ends: kinds (npiece), xy (nxy x 2) without the ends. Notches keep their part of it.
 */
MUS_API mus_status mus_pattern_redraw_edge(mus_pattern *pattern, int32_t edge, int32_t npiece, const int32_t *kinds,
                                           int32_t nxy, const double *xy);

/** Draw an edge with corners again as one smooth line, as few cubics as stay `within` [m] of it: its ends and tangents
 * there are kept, its seam takes the difference as ease. Errors: MUS_ERR_ARG (within not in 1e-6 to 1). */
MUS_API mus_status mus_pattern_fair_edge(mus_pattern *pattern, int32_t edge, double within);

/** Put a point into an edge at s; what it is sewn to is divided too. The part before it (along the outline) keeps the
 * name, *out (may be NULL) is the other, called `name`, or if that is NULL by the old name with a number. */
MUS_API mus_status mus_pattern_split_edge(mus_pattern *pattern, int32_t edge, double s, const char *name, int32_t *out);

/** Make one edge of `edge` and the next in the outline, both unsewn or sewn to two that follow each other. Errors:
 * MUS_ERR_PATTERN (their seams part). */
MUS_API mus_status mus_pattern_merge_edges(mus_pattern *pattern, int32_t edge, int32_t *out);

/* ---- seams ---- */

/** The two sides of a seam walked along each other. */
typedef struct mus_seam_walk {
    size_t size;
    double length_a; /* [m] */
    double length_b;
    double excess; /* b longer than a by more than the ease: 0 when the seam is true [m] */
    int32_t notches_a;
    int32_t notches_b;
    double notch_off;    /* most that a pair of notches misses each other by, ease spread evenly [m]; NaN: no pairs */
    double corner_start; /* angle of both panels together where a starts [rad]: pi is a smooth line */
    double corner_end;   /* and where it ends */
} mus_seam_walk;

MUS_API void mus_seam_walk_init(mus_seam_walk *walk, size_t size);

/** Walk a seam. Errors: MUS_ERR_ARG, MUS_ERR_PATTERN (an edge in no outline), MUS_ERR_VERSION. */
MUS_API mus_status mus_pattern_walk_seam(const mus_pattern *pattern, int32_t seam, mus_seam_walk *out);

/** True a seam: `edge`, one of its two, gets the length that the other and the ease ask for: its end (at_end 1) or its
 * start (0) moves along its tangent there; the edge beside it follows. Errors: MUS_ERR_ARG (an edge of another seam),
 * MUS_ERR_PATTERN (no place of that end has the length). */
MUS_API mus_status mus_pattern_true_seam(mus_pattern *pattern, int32_t seam, int32_t edge, int32_t at_end);

#ifdef __cplusplus
}
#endif

#endif
