/*
 * muslin/pattern.h: a sewing pattern as a cell complex.
 *
 * Points are 0-cells. Edges are 1-cells: each is a chain of lines, arcs, quadratic and cubic Beziers, and a new edge
 * starts only where a seam or an opening starts. Panels are 2-cells: a panel's attaching map is the cyclic word of its
 * oriented edges, and the right side of the cloth is the side from which that word runs counter-clockwise. A seam makes
 * two edges equivalent. A line inside a panel is an edge that its word passes once each way: nothing is cut there, and
 * another panel that is sewn to it is a third sheet (a patch pocket; muslin/edit.h lays one).
 * Source: Metaaphanon and Kanongchaiyos 2005, section 5, eq. 13 to 20.
 *
 * Units: metre, in the plane of each panel (x right, y up; y is the warp unless the grain says otherwise).
 * Indices are int32_t, count from 0, and are stable: the calls below remove nothing. The edits of muslin/edit.h cut,
 * join and remove: after one of them indices and borrowed pointers are new, names stay. muslin/topology.h tells what
 * the sewn pattern is as a surface, and checks it.
 */
#ifndef MUSLIN_PATTERN_H
#define MUSLIN_PATTERN_H

#include "muslin/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A pattern. One context, and all objects made from it, on one thread at a time. */
typedef struct mus_pattern mus_pattern;

/* Kinds of pieces of an edge. Control points between the ends of a piece: line 0, quadratic 1, cubic 2, arc 1 (the
 * point half way along the arc). */
#define MUS_PIECE_LINE 0
#define MUS_PIECE_QUADRATIC 1
#define MUS_PIECE_CUBIC 2
#define MUS_PIECE_ARC 3

/* How the two edges of a seam run. REVERSED: the start of a meets the end of b, right sides out (two panels that are
 * both drawn counter-clockwise). DIRECT: start meets start (a piece laid face to face, or a twist). */
#define MUS_SEAM_REVERSED 0
#define MUS_SEAM_DIRECT 1

/**
 * Make an empty pattern. `name` is UTF-8 of at most 127 bytes; NULL reads as "".
 *
 * Errors:  MUS_ERR_ARG (context or out NULL, a name that is too long or not UTF-8), MUS_ERR_MEMORY; *out is NULL then
 * Memory:  *out is the caller's: mus_pattern_destroy()
 */
MUS_API mus_status mus_pattern_create(mus_context *context, const char *name, mus_pattern **out);

/**
 * Make a copy that is equal to the bit and shares nothing with the pattern. The history of edits is not copied.
 *
 * Errors:  MUS_ERR_ARG (pattern or out NULL), MUS_ERR_MEMORY; *out is NULL then
 * Memory:  *out is the caller's: mus_pattern_destroy(); some 100 kB for a dress
 */
MUS_API mus_status mus_pattern_copy(const mus_pattern *pattern, mus_pattern **out);

/** Free a pattern and its history; NULL is accepted. */
MUS_API void mus_pattern_destroy(mus_pattern *pattern);

/** The context that the pattern was made from; NULL for NULL. */
MUS_API mus_context *mus_pattern_context(const mus_pattern *pattern);

/** Name of the pattern, "" for NULL; borrowed until the next edit. */
MUS_API const char *mus_pattern_name(const mus_pattern *pattern);

/** Set the name of the pattern. Names anywhere in a pattern are UTF-8 of at most 127 bytes. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_set_name(mus_pattern *pattern, const char *name);

/* ---- edit: cells ---- */

/** Add a panel without outline; *out (may be NULL) is its index. Errors: MUS_ERR_ARG (name NULL, empty or taken),
 * MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_add_panel(mus_pattern *pattern, const char *name, int32_t *out);

/** Add a point (x, y) [m] to the plane of a panel; *out (may be NULL) is its index. Errors: MUS_ERR_ARG (panel unknown,
 * x or y beyond 1e7 m), MUS_ERR_MEMORY. */
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
 * Errors:  MUS_ERR_ARG (unknown points, points of two panels, a wrong count of xy points, one not within 1e7 m, an arc
 *          whose middle point is nearer to one end, an edge of length 0); MUS_ERR_VERSION; MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_add_edge(mus_pattern *pattern, const mus_edge_def *def, int32_t *out);

/**
 * Give a panel its attaching map: `n` edges in order, direction[i] +1 along or -1 against the edge.
 *
 * An outline is always closed: the first edge follows the last.
 * Shapes:  edges, directions (n)
 * Errors:  MUS_ERR_ARG (an edge of another panel, an edge that does not start where the edge before it ended),
 *          MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_set_outline(mus_pattern *pattern, int32_t panel, int32_t n, const int32_t *edges,
                                           const int32_t *directions);

/** Set the label of an edge: the opening or the role that it plays ("hem", "neck", "cuff", "left_armhole"), "" for
 * none.
 * Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_set_edge_label(mus_pattern *pattern, int32_t edge, const char *label);

/** Set the seam allowance of an edge [m]; NaN (the default) leaves it to the sheet. Errors: MUS_ERR_ARG (< 0, >
 * 0.2). */
MUS_API mus_status mus_pattern_set_edge_allowance(mus_pattern *pattern, int32_t edge, double allowance);

/* Levels of the body that an edge can be attached to: those of the torso, then those of the arm or leg that the edge
 * starts round. */
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

/** Name of a level MUS_HOLD_* ("waist"); NULL outside the range. */
MUS_API const char *mus_hold_name(int32_t level);

/** The level MUS_HOLD_* of a name; MUS_NONE without one. */
MUS_API int32_t mus_hold_find(const char *name);

/**
 * Attach an edge to a level of the body: a drape keeps the edge from sliding more than `below` under the level.
 *
 * The attachment is one-sided: the edge moves freely along the skin and up. MUS_HOLD_NONE (the default) takes it away.
 * What holds itself up is made firm: in a cloth of plate bending, an attached edge that is in no seam and has no
 * elastic gets a facing 5 cm wide that bends as cloth which stands over that width by itself.
 * A body without the level (a body of given limbs) holds nothing.
 * Units:   below [m], -1 to 1
 * Errors:  MUS_ERR_ARG
 */
MUS_API mus_status mus_pattern_set_edge_hold(mus_pattern *pattern, int32_t edge, int32_t level, double below);

/** Attach all edges with a label to a level, as mus_pattern_set_edge_hold() does one. *count (may be NULL) is how many
 * edges there are. Errors: MUS_ERR_ARG (an empty label, and as there). */
MUS_API mus_status mus_pattern_hold_label(mus_pattern *pattern, const char *label, int32_t level, double below,
                                          int32_t *count);

/**
 * Put an elastic along an edge (a casing, a rib). Its length at rest is `ratio` times that of the edge; `stiffness` is
 * the force that would stretch it to double length. Stiffness 0 (the default) takes it away.
 *
 * A soft rib has 20 N, an elastic 2 cm wide 60 N, a waistband that hardly stretches 1000 N.
 * Units:   stiffness [N]
 * Errors:  MUS_ERR_ARG (ratio outside 0.1 to 1, stiffness outside 0 to 1e6)
 */
MUS_API mus_status mus_pattern_set_edge_elastic(mus_pattern *pattern, int32_t edge, double ratio, double stiffness);

/* Closures of a seam: none (it is sewn), a zip, buttons, ties (an end of a front that wraps is held there by a tie; it
 * lies on the seam, laid). */
#define MUS_CLOSURE_NONE 0
#define MUS_CLOSURE_ZIP 1
#define MUS_CLOSURE_BUTTONS 2
#define MUS_CLOSURE_TIES 3

/** Options of a seam. */
typedef struct mus_seam_def {
    size_t size;
    int32_t edge_a;
    int32_t edge_b;
    int32_t direction; /* MUS_SEAM_REVERSED (default) or MUS_SEAM_DIRECT */
    double ease;       /* length of b less length of a that the design intends [m], default 0 */
    double tolerance;  /* difference beyond the ease that the check allows [m], default 0.0005 */
    int32_t laid;      /* nonzero: layers of a pleat, a on b. An edge may be in two such seams beside another seam */
    int32_t closure;   /* MUS_CLOSURE_*, default MUS_CLOSURE_NONE */
    int32_t open;      /* nonzero: a closure that is left open: a cloth does not join it; default 0 */
    int32_t buttons;   /* of MUS_CLOSURE_BUTTONS: number of points that alone are joined, spread evenly, half a gap from
                        * both ends; 0 (default): the whole length, as where a front laps over; at most 1000 */
} mus_seam_def;

/** Write the defaults: both edges 0, REVERSED, no ease, a tolerance of 0.5 mm, sewn. */
MUS_API void mus_seam_def_init(mus_seam_def *def, size_t size);

/** Sew two edges, of one panel or of two; *out (may be NULL) is the index of the seam. Closures count as done up in the
 * topology. Errors: MUS_ERR_ARG (unknown edge, an edge with itself, a number that is not finite, `open` or `buttons`
 * without a closure), MUS_ERR_VERSION, MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_add_seam(mus_pattern *pattern, const mus_seam_def *def, int32_t *out);

/** Leave all closures open (`open` nonzero), or do them up (0); *count (may be NULL) is how many there are. */
MUS_API mus_status mus_pattern_open_closures(mus_pattern *pattern, int32_t open, int32_t *count);

/* ---- edit: marks and making up ---- */

#define MUS_NOTCH_SINGLE 1
#define MUS_NOTCH_DOUBLE 2
#define MUS_NOTCH_TRIPLE 3

/** Put a notch MUS_NOTCH_* on an edge at arc length s [m] from its start; *out (may be NULL) is its index. Errors:
 * MUS_ERR_ARG (s more than 1e-9 outside the edge, an unknown kind), MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_add_notch(mus_pattern *pattern, int32_t edge, double s, int32_t kind, int32_t *out);

/**
 * Draw a mark inside a panel: a line through n points, or a drill point when n is 1. *out (may be NULL) is its index.
 *
 * Shapes:  xy (n x 2) [m]
 * `name` says what it is ("centre front").
 * Errors:  MUS_ERR_ARG (no point, a point beyond 1e7 m), MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_add_mark(mus_pattern *pattern, int32_t panel, const char *name, int32_t n,
                                        const double *xy, int32_t *out);

/** Set the direction of the warp in the plane of a panel, default (0, 1); kept as a unit vector. Errors: MUS_ERR_ARG
 * (zero or not finite). */
MUS_API mus_status mus_pattern_set_grain(mus_pattern *pattern, int32_t panel, double x, double y);

/** Set how a panel is cut: `count` pieces in all (0 to 1000); `mirror_of` is the panel whose mirror image it is, or
 * MUS_NONE. A mirror image is not printed: the printed panel says "cut 2 mirrored". Errors: MUS_ERR_ARG (also an image
 * of itself or of another image). */
MUS_API mus_status mus_pattern_set_cut(mus_pattern *pattern, int32_t panel, int32_t count, int32_t mirror_of);

/* Materials that a panel is cut of. */
#define MUS_MATERIAL_MAIN 0        /* the cloth of the garment; its pieces are those of mus_pattern_set_cut() */
#define MUS_MATERIAL_LINING 1      /* lining or pocketing */
#define MUS_MATERIAL_INTERFACING 2 /* fused or sewn to the wrong side of a piece */
#define MUS_MATERIAL_RIB 3         /* ribbed knit */
#define MUS_MATERIAL_ELASTIC 4     /* elastic tape */
#define MUS_MATERIAL_COUNT 5

/** Name of a material MUS_MATERIAL_* ("interfacing"); NULL outside the range. */
MUS_API const char *mus_material_name(int32_t material);

/** The material MUS_MATERIAL_* of a name; MUS_NONE without one. */
MUS_API int32_t mus_material_find(const char *name);

/** Set how many pieces of a panel are cut of a material, in all, with those of its mirror image (0 to 1000). A panel
 * starts with one of the main cloth. The number is written on the paper; a drape does not read it. Errors: MUS_ERR_ARG.
 */
MUS_API mus_status mus_pattern_set_material(mus_pattern *pattern, int32_t panel, int32_t material, int32_t count);

/**
 * Give a pattern the panels that are cut and sewn but not draped: facings, a neckband, pocket bags, elastic.
 *
 * `panels` is a pattern of its own and is copied; NULL takes them away. A sheet prints them after the panels of the
 * pattern. They follow a copy, a file of mus_pattern_write() and mus_pattern_join(); an edit of the pattern leaves them
 * as they are, and a pattern that is graded has none.
 * Errors:  MUS_ERR_ARG (pattern NULL, `panels` is the pattern itself), MUS_ERR_MEMORY; the pattern is as it was then
 */
MUS_API mus_status mus_pattern_set_cut_only(mus_pattern *pattern, const mus_pattern *panels);

/** Give a panel another name. Its words tell the sides of the panel until they are set (mus_pattern_set_panel_sides()),
 * and its part of the garment when seams are proposed. Errors: MUS_ERR_ARG (a name that is empty, too long, not UTF-8,
 * or that of another panel). */
MUS_API mus_status mus_pattern_set_panel_name(mus_pattern *pattern, int32_t panel, const char *name);

/** Set the label of a panel: its part in the garment ("body", "arm", "leg", "collar", free text). mus_arrange_pattern()
 * puts an "arm" round an arm, a "neck", "collar" or "hood" round the neck, and all else round the trunk. Errors:
 * MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_set_panel_label(mus_pattern *pattern, int32_t panel, const char *label);

/* sides of the wearer; a panel is on none, on one, or on two that are not opposite (the front, left) */
#define MUS_SIDE_FRONT 1
#define MUS_SIDE_BACK 2
#define MUS_SIDE_LEFT 4
#define MUS_SIDE_RIGHT 8

/** Set the sides of the wearer that a panel is on: the sum of its MUS_SIDE_*, 0 for none; opposite sides cancel. Until
 * they are set, the words front, back, left and right in the panel's name tell them. Errors: MUS_ERR_ARG (below 0 or
 * above 15). */
MUS_API mus_status mus_pattern_set_panel_sides(mus_pattern *pattern, int32_t panel, int32_t sides);

/** Declare an opening that the sewn garment is to have, by the label of its boundary loop ("neck"; twice for two
 * cuffs). A pattern that declares any is checked as a garment: see mus_pattern_check(). Errors: MUS_ERR_ARG (an empty
 * label), MUS_ERR_MEMORY. */
MUS_API mus_status mus_pattern_add_opening(mus_pattern *pattern, const char *label);

/**
 * Where a panel is before sewing.
 *
 * A point (x, y) of the panel goes to  origin + rotation * p.  p = (x, y, 0)  when bend is 0. Otherwise the panel is
 * rolled round an axis parallel to its y, at distance |bend| behind (bend > 0) or before (bend < 0) its plane:
 * u = x - bend_x,  p = (bend_x + bend sin(u/bend), y, bend (cos(u/bend) - 1)).
 * rotation is row-major: its columns are the images of the panel's x, y and normal.
 */
typedef struct mus_placement {
    size_t size;
    double origin[3];   /* [m] */
    double rotation[9]; /* orthonormal, determinant +1; default identity */
    double bend;        /* radius [m], 0 flat (default) */
    double bend_x;      /* the line x = bend_x keeps its place, default 0 */
    double fold;        /* of a panel with pleats: each starts folded to this part of its depth, 0 (default: flat) to
                         * 1; the panel's middle keeps its place */
} mus_placement;

/** Write the defaults: flat at the origin, no rotation. */
MUS_API void mus_placement_init(mus_placement *placement, size_t size);

/** Set where a panel is before sewing. Errors: MUS_ERR_ARG (a number that is not finite, an origin or bend_x beyond
 * 1e7 m, a matrix that is off a rotation by more than 1e-6 or mirrors, a bend of less than 1 mm), MUS_ERR_VERSION. */
MUS_API mus_status mus_pattern_set_placement(mus_pattern *pattern, int32_t panel, const mus_placement *placement);

/** Where a panel is before sewing; out->size is set by mus_placement_init(). Errors: MUS_ERR_ARG, MUS_ERR_VERSION. */
MUS_API mus_status mus_pattern_placement(const mus_pattern *pattern, int32_t panel, mus_placement *out);

/* ---- edit: garments over one another ---- */

#define MUS_LAYERS_MOST 16 /* layers are 0 to 15; chosen: more than anyone wears */

/** Set the layer of a panel: 0 (the default) is next to the skin, each next layer is worn over it. A drape with
 * self_contact sews and drapes layer after layer, from inside to outside. A panel that is sewn to one of a layer below
 * starts laid on that one from the seam, as a collar lies on the shoulders. Errors: MUS_ERR_ARG (layer outside 0 to
 * 15). */
MUS_API mus_status mus_pattern_set_layer(mus_pattern *pattern, int32_t panel, int32_t layer);

/** Layer of a panel; MUS_NONE outside the range. */
MUS_API int32_t mus_pattern_layer(const mus_pattern *pattern, int32_t panel);

/**
 * Put another garment over a pattern: all cells of `other` are added to it, its innermost panels in `layer`, what it
 * has in layers above them (a collar that lies on its shoulders) as far above that.
 *
 * Indices of the pattern stay; those of `other` follow behind them. A panel whose name is taken gets the name of its
 * pattern before its own. Openings that the pattern declared are forgotten: garments over one another are not checked
 * as one garment.
 * Errors: MUS_ERR_ARG (other NULL, a layer outside 0 to 15), MUS_ERR_MEMORY; the pattern is then as it was.
 */
MUS_API mus_status mus_pattern_join(mus_pattern *pattern, const mus_pattern *other, int32_t layer);

/* ---- query: counts and names ---- */

/** Number of panels; indices are below it. 0 for NULL. */
MUS_API int32_t mus_pattern_panel_count(const mus_pattern *pattern);
/** Number of points. */
MUS_API int32_t mus_pattern_point_count(const mus_pattern *pattern);
/** Number of edges. */
MUS_API int32_t mus_pattern_edge_count(const mus_pattern *pattern);
/** Number of seams. */
MUS_API int32_t mus_pattern_seam_count(const mus_pattern *pattern);
/** Number of notches. */
MUS_API int32_t mus_pattern_notch_count(const mus_pattern *pattern);
/** Number of marks. */
MUS_API int32_t mus_pattern_mark_count(const mus_pattern *pattern);
/** Number of declared openings. */
MUS_API int32_t mus_pattern_opening_count(const mus_pattern *pattern);

/** Label of a declared opening; NULL outside the range. */
MUS_API const char *mus_pattern_opening(const mus_pattern *pattern, int32_t opening);

/** Panel of a name; MUS_NONE without one. */
MUS_API int32_t mus_pattern_find_panel(const mus_pattern *pattern, const char *name);

/** Edge of a name within a panel; MUS_NONE without one. */
MUS_API int32_t mus_pattern_find_edge(const mus_pattern *pattern, int32_t panel, const char *name);

/* ---- query: panels and points ---- */

/** Name of a panel; NULL outside the range. Borrowed until the next edit. */
MUS_API const char *mus_pattern_panel_name(const mus_pattern *pattern, int32_t panel);

/** Label of a panel, "" without one; NULL outside the range. Borrowed until the next edit. */
MUS_API const char *mus_pattern_panel_label(const mus_pattern *pattern, int32_t panel);

/** Sides of the wearer that a panel is on, the sum of its MUS_SIDE_*; 0 outside the range. *given (may be NULL) is 1
 * when they were set, 0 when the panel's name tells them. */
MUS_API int32_t mus_pattern_panel_sides(const mus_pattern *pattern, int32_t panel, int32_t *given);

/** The outline of a panel: *n edges and their directions, +1 along or -1 against the edge; n is 0 without an outline.
 * Borrowed until the next edit; any out may be NULL. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_outline(const mus_pattern *pattern, int32_t panel, int32_t *n, const int32_t **edges,
                                       const int32_t **directions);

/**
 * The closed line that is cut on the table: the outline of a panel without lines inside it and the bridges to them.
 *
 * An edge followed by the same edge back is taken out of the outline, again and again, until there is none.
 * Shapes:  edges, directions (capacity), either may be NULL; *count is how many there are
 * Errors:  MUS_ERR_ARG, MUS_ERR_PATTERN (a panel without outline), MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_rim(const mus_pattern *pattern, int32_t panel, int32_t *edges, int32_t *directions,
                                   int32_t capacity, int32_t *count);

/** The closed line along which a panel is cut, with its allowances. */
typedef struct mus_cut_line mus_cut_line;

/**
 * Make the cut line of a panel: its rim with the darts folded shut and the hems turned up, moved out by the allowance
 * of each edge. `allowance` is that of edges without their own.
 *
 * A dart is two neighbouring edges that are sewn to each other and have no allowance of their own above 0. It is folded
 * down where its mouth runs up and down the wearer, else to the wearer's middle, and cut along the edge that it lies
 * on, so its mouth is capped. A dart inside the panel is not cut. A hem is an edge with "hem" in its label or name; the
 * ends of its allowance lie on the cut lines of its neighbours when it is turned up. Pleats are part of their edge. An
 * edge that buttons laps by its allowance, whose end has the allowance of the edge beside it.
 * Units:  allowance [m], 0 to 0.2
 * Errors: MUS_ERR_ARG, MUS_ERR_PATTERN (a panel without outline or without area), MUS_ERR_MEMORY; *out is NULL then
 * Memory: *out is the caller's: mus_cut_line_destroy(); it does not refer to the pattern
 * Cost:   curves are chords within 0.01 mm; n log n for n chords
 * Source: Aldrich, Metric Pattern Cutting for Women's Wear, 2008; Wein, Exact and approximate construction of offset
 *         polygons, 2007
 */
MUS_API mus_status mus_pattern_cut_line(const mus_pattern *pattern, int32_t panel, double allowance,
                                        mus_cut_line **out);

/** Free a cut line; NULL is accepted. */
MUS_API void mus_cut_line_destroy(mus_cut_line *line);

/** Number of closed loops: the outer one, then the holes that wide allowances leave in a narrow bay. 0 for NULL. */
MUS_API int32_t mus_cut_line_loop_count(const mus_cut_line *line);

/** A loop of a cut line: xy (*n x 2) in the plane of the panel [m], closed from the last point to the first; the outer
 * one runs as the outline does, a hole against it. Borrowed until the line is destroyed; any out may be NULL. Errors:
 * MUS_ERR_ARG. */
MUS_API mus_status mus_cut_line_loop(const mus_cut_line *line, int32_t loop, int32_t *n, const double **xy);

/** Number of darts that the cut line runs across. 0 for NULL. */
MUS_API int32_t mus_cut_line_dart_count(const mus_cut_line *line);

/** A dart that the cut line runs across: out (4 x 2) gets the first end of its mouth, its point, the second end of its
 * mouth, and the end of the fold between the legs on the capped mouth, without allowance [m]. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_cut_line_dart(const mus_cut_line *line, int32_t dart, double *out);

/** Direction of the warp of a panel: out (2), a unit vector. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_grain(const mus_pattern *pattern, int32_t panel, double *out);

/** How many pieces of a panel are cut, and the panel whose mirror image it is or MUS_NONE. Any out may be NULL. Errors:
 * MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_cut(const mus_pattern *pattern, int32_t panel, int32_t *count, int32_t *mirror_of);

/** How many pieces of a panel are cut of a material; *mirrored is 1 when half of them are cut turned over, because
 * another panel is the mirror image, else 0. Any out may be NULL. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_material(const mus_pattern *pattern, int32_t panel, int32_t material, int32_t *count,
                                        int32_t *mirrored);

/** The panels that are cut and not draped (mus_pattern_set_cut_only()); NULL without any. Borrowed until the pattern is
 * changed or destroyed. */
MUS_API const mus_pattern *mus_pattern_cut_only(const mus_pattern *pattern);

/** Panel and place xy (2) [m] of a point. Any out may be NULL. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_point(const mus_pattern *pattern, int32_t point, int32_t *panel, double *xy);

/* ---- query: edges ---- */

/** Panel of an edge; MUS_NONE outside the range. */
MUS_API int32_t mus_pattern_edge_panel(const mus_pattern *pattern, int32_t edge);

/** Points at the start and the end of an edge. Any out may be NULL. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_edge_ends(const mus_pattern *pattern, int32_t edge, int32_t *start, int32_t *end);

/** Name of an edge, "" without one; NULL outside the range. Borrowed until the next edit. */
MUS_API const char *mus_pattern_edge_name(const mus_pattern *pattern, int32_t edge);

/** Label of an edge, "" without one; NULL outside the range. Borrowed until the next edit. */
MUS_API const char *mus_pattern_edge_label(const mus_pattern *pattern, int32_t edge);

/** Seam allowance of an edge [m]; NaN where it is left to the sheet, and outside the range. */
MUS_API double mus_pattern_edge_allowance(const mus_pattern *pattern, int32_t edge);

/** The level MUS_HOLD_* that an edge is attached to, and how far below it the edge may slide [m]. Any out may be NULL.
 * Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_edge_hold(const mus_pattern *pattern, int32_t edge, int32_t *level, double *below);

/** Ratio and stiffness [N] of the elastic along an edge; 1 and 0 without one. Any out may be NULL. Errors:
 * MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_edge_elastic(const mus_pattern *pattern, int32_t edge, double *ratio, double *stiffness);

/** The chain of an edge: kinds (npiece) and all its points with both ends, xy (nxy x 2) [m]. Borrowed until the next
 * edit; any out may be NULL. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_edge_pieces(const mus_pattern *pattern, int32_t edge, int32_t *npiece,
                                           const int32_t **kinds, int32_t *nxy, const double **xy);

/** Length of an edge [m], right to 1e-9: closed form for lines and arcs, Gauss-Legendre quadrature for Beziers. NaN
 * outside the range. */
MUS_API double mus_pattern_edge_length(const mus_pattern *pattern, int32_t edge);

/** Points of an edge at n relative arc lengths t (n), 0 the start to 1 the end: out (n x 2) [m]. Errors: MUS_ERR_ARG (a
 * t outside 0 to 1). */
MUS_API mus_status mus_pattern_edge_at(const mus_pattern *pattern, int32_t edge, int32_t n, const double *t,
                                       double *out);

/**
 * An edge as a polyline: each curved piece as `chords` chords of equal parameter, each line as one chord.
 *
 * Shapes:  xy (capacity x 2) [m], both ends included, NULL to count only; *count is how many points there are
 * Errors:  MUS_ERR_ARG (fewer than 1 chord), MUS_ERR_LIMIT (more than 2^31 points)
 */
MUS_API mus_status mus_pattern_edge_polyline(const mus_pattern *pattern, int32_t edge, int32_t chords, double *xy,
                                             int32_t capacity, int32_t *count);

/** Area enclosed by the outline of a panel [m2], by a closed form, never negative. NaN without an outline. */
MUS_API double mus_pattern_panel_area(const mus_pattern *pattern, int32_t panel);

/** Length of the outline of a panel [m], without edges that it passes both ways. NaN without an outline. */
MUS_API double mus_pattern_panel_perimeter(const mus_pattern *pattern, int32_t panel);

/* ---- query: seams, notches, marks ---- */

/** The def that a seam was made from; out->size is set by mus_seam_def_init(). Errors: MUS_ERR_ARG, MUS_ERR_VERSION. */
MUS_API mus_status mus_pattern_seam(const mus_pattern *pattern, int32_t seam, mus_seam_def *out);

/** The first seam that an edge is in; MUS_NONE without one. */
MUS_API int32_t mus_pattern_edge_seam(const mus_pattern *pattern, int32_t edge);

/** Edge, arc length s from its start [m] and kind of a notch. Any out may be NULL. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_notch(const mus_pattern *pattern, int32_t notch, int32_t *edge, double *s,
                                     int32_t *kind);
/** Panel, name and points xy (n x 2) [m] of a mark. Borrowed until the next edit; any out may be NULL. Errors:
 * MUS_ERR_ARG. */
MUS_API mus_status mus_pattern_mark(const mus_pattern *pattern, int32_t mark, int32_t *panel, const char **name,
                                    int32_t *n, const double **xy);

#ifdef __cplusplus
}
#endif

#endif
