/*
 * board.h: the cutting table: a pattern laid out as plain records that may be cut, turned, joined and mirrored.
 *
 * A pattern (mus_pattern) never loses a cell; a board does nothing else. It is read from a pattern or begun empty,
 * worked on, and written back as a new pattern. All edits of muslin/edit.h and all designs are sequences of the calls
 * below.
 *
 * A panel is a ring of sides. A side is an edge as its panel's outline walks it: counter-clockwise, the cloth to its
 * left; its end is the start of the next side, bit for bit. (An outline that runs clockwise, as an imported one may, is
 * kept so: then the cloth is to its right.) A seam joins two sides; REVERSED (right sides out) means that the start of
 * a meets the end of b. A dart is two sides one after the other that are sewn together; the vertex between them is its
 * point. Lengths in metre, angles in radian, counter-clockwise positive.
 *
 * Indices of sides, panels and seams stay as they are while the board lives; what is removed has panel == MUS_NONE
 * (a seam: a == MUS_NONE). mus__board_write() leaves those out.
 *
 * Failing: the first call that fails sets board->status (and the error text in the context); every later call does
 * nothing and gives MUS_NONE back, so a recipe reads straight down and asks once at its end. A failed board is thrown
 * away: the pattern that it was read from is as it was.
 */
#ifndef MUS_BOARD_H
#define MUS_BOARD_H

#include "pattern/pattern_internal.h"

/* what becomes of a side on the centre line when the half garment is doubled: nothing special, one piece cut on the
 * fold, two pieces sewn together, two pieces left open (a front that buttons is open) */
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

typedef struct mus__board_side {
    char name[MUS__NAME_BYTES], label[MUS__NAME_BYTES];
    int32_t panel; /* MUS_NONE: removed */
    int32_t prev, next;
    int32_t centre;   /* MUS__CENTRE_*; not kept in a pattern */
    int32_t knot;     /* corners (starts of sides) of one knot and one place are one point of the panel; or MUS_NONE */
    bool backward;    /* the edge of the pattern runs against the outline */
    double allowance; /* NaN: left to the sheet */
    mus__edge_stay stay; /* hold and elastic, as the edge's: kept by reading, splits, doubling and writing */
    mus__board_chain chain;
    double length;
} mus__board_side;

typedef struct mus__board_panel {
    char name[MUS__NAME_BYTES], label[MUS__NAME_BYTES];
    int32_t first; /* a side of it, where its word begins; MUS_NONE: removed */
    int32_t cut_count, mirror_of, layer;
    int32_t single; /* 1: on one half of a garment only, mus__board_double() leaves it alone */
    double grain[2];
    mus_placement placement;
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
    double s;           /* from the start of the side as walked */
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

/* ---- board_pattern.c: to and from a pattern ---- */

/* a panel without outline or an edge of no outline fails the board: both are faults of a pattern */
void mus__board_read(mus__board *board, const mus_pattern *pattern);
/* as a new pattern; board->status says how it went, *out is NULL after a failure */
void mus__board_write(mus__board *board, mus_pattern **out);

/* ---- board.c: drawing, and finding one's way ---- */

void mus__board_begin(mus__board *board, mus_context *context, const char *name);
void mus__board_free(mus__board *board);
/* set the status and the sentence, once; for recipes too */
void mus__board_fail(mus__board *board, mus_status status, const char *format, ...) MUS_PRINTF(3, 4);

int32_t mus__board_panel_add(mus__board *board, const char *name, const char *label);
/* append a side to a panel that is being drawn: it must start where the last one ended (the last ends where the first
 * starts: that is set bit for bit by mus__board_panel_close()). xy (nxy x 2) has both ends */
int32_t mus__board_side_add(mus__board *board, int32_t panel, const char *name, const char *label, int32_t npiece,
                            const int32_t *kinds, int32_t nxy, const double *xy);
void mus__board_panel_close(mus__board *board, int32_t panel);
/* a line, and a cubic (4 x 2) */
int32_t mus__board_line_add(mus__board *board, int32_t panel, const char *name, const char *label, const double *start,
                            const double *end);
int32_t mus__board_cubic_add(mus__board *board, int32_t panel, const char *name, const char *label,
                             const double *cubic);

int32_t mus__board_find_panel(const mus__board *board, const char *name);
/* by name within a panel; MUS_NONE without failing the board */
int32_t mus__board_find(const mus__board *board, int32_t panel, const char *name);
/* the run of sides of one panel that carry `label`, in walking order from the first after one that does not; how many
 * (at most `room` are written). A closed dart between two of them (two sides sewn together) is passed over. */
int32_t mus__board_run(const mus__board *board, int32_t panel, const char *label, int32_t *sides, int32_t room);
const double *mus__board_start(const mus__board *board, int32_t side); /* (2) */
const double *mus__board_end(const mus__board *board, int32_t side);
/* tangent is a unit vector along the walk; it may be NULL */
void mus__board_at(const mus__board *board, int32_t side, double s, double *xy, double *tangent);
/* the seam that a side is in (the first), and the side on the other end of it, or MUS_NONE */
int32_t mus__board_seam_of(const mus__board *board, int32_t side);
int32_t mus__board_partner(const mus__board *board, int32_t side);

int32_t mus__board_notch_add(mus__board *board, int32_t side, double s, int32_t kind);
int32_t mus__board_mark_add(mus__board *board, int32_t panel, const char *name, int32_t n, const double *xy);
void mus__board_opening_add(mus__board *board, const char *label);
void mus__board_rename(mus__board *board, int32_t side, const char *name, const char *label /* NULL: as it is */);

/* is it one that is there? if not, the board fails */
bool mus__board_has_side(mus__board *board, int32_t side);
bool mus__board_has_panel(mus__board *board, int32_t panel);
/* a side of `chain`, which is taken over even when this fails: without name, label, neighbours, seam and notches */
int32_t mus__board_side_new(mus__board *board, int32_t panel, mus__board_chain *chain);
/* `next` comes after `side` in the ring: its start is set to the end of `side`, bit for bit */
void mus__board_follow(mus__board *board, int32_t side, int32_t next);
/* a free name in a panel: `name` without a number at its end, and "_2" or the next number that is free; out
 * (MUS__NAME_BYTES) */
void mus__board_free_name(const mus__board *board, int32_t panel, const char *name, char *out);
/* forget a side: its seams and notches go, its chain too; the ring is the caller's matter */
void mus__board_side_remove(mus__board *board, int32_t side);
/* a panel is about to change its shape: it is no longer the mirror image of another, nor another of it */
void mus__board_part_twins(mus__board *board, int32_t panel);

/* ---- board_chain.c: chains of pieces. Those that make one fail the board without memory, with *out empty ---- */

void mus__board_chain_make(mus__board *board, int32_t npiece, const int32_t *kinds, int32_t nxy, const double *xy,
                           mus__board_chain *out);
double mus__board_chain_length(const mus__board_chain *chain);
/* point at arc length s (of `length`), and the unit tangent along; either may be NULL */
void mus__board_chain_at(const mus__board_chain *chain, double length, double s, double *xy, double *tangent);
void mus__board_chain_reverse(mus__board_chain *chain);
/* x' = m0 x + m1 y + m2, y' = m3 x + m4 y + m5 of every point */
void mus__board_chain_move(mus__board_chain *chain, const double *map);
/* the parts before and after arc length s, 0 < s < length; pieces are divided exactly */
void mus__board_chain_split(mus__board *board, const mus__board_chain *chain, double length, double s,
                            mus__board_chain *before, mus__board_chain *after);
/* a then b; two lines that are one straight line become one */
void mus__board_chain_join(mus__board *board, const mus__board_chain *a, const mus__board_chain *b,
                           mus__board_chain *out);
/* are b's points those of a, read from the other end when `reversed`, bit for bit? */
bool mus__board_chain_same(const mus__board_chain *a, const mus__board_chain *b, bool reversed);

/* ---- board_sew.c ---- */

/* join two sides; ease = length of b - length of a that is meant */
int32_t mus__board_seam_add(mus__board *board, int32_t a, int32_t b, int32_t direction, double ease);
/* a seam is laid, or closed, as another is */
void mus__board_seam_like(mus__board *board, int32_t seam, int32_t other);
/* open the seam of a side */
void mus__board_seam_drop(mus__board *board, int32_t side);
/**
 * Sew a run of sides to another, many to many: `a` (na) from its first to its last as walked, `b` (nb) likewise, right
 * sides out: the start of a[0] meets the end of b[nb - 1]. Both are split where the other has a joint, by relative
 * length along the whole run; the difference of the lengths becomes the ease of the parts in proportion. Joints nearer
 * than 1 mm to one another are taken as the same. Notches stay where they are.
 */
void mus__board_sew(mus__board *board, int32_t na, const int32_t *a, int32_t nb, const int32_t *b);
/**
 * Put a vertex into a side at arc length s: the side keeps its name and its first part, the new one is *name (NULL: the
 * name with "_2", or the next number that is free in the panel). If the side is sewn, its partner is split at the place
 * that is sewn to s, and the seam becomes two. Returns the new side. s within 1e-6 m of an end fails.
 */
int32_t mus__board_split(mus__board *board, int32_t side, double s, const char *name);
/* `side` and the next, unsewn or sewn to two that are one after the other, become one, with the name of `side` */
void mus__board_merge(mus__board *board, int32_t side);
/* would it do so? Asks only, and fails nothing */
bool mus__board_mergeable(const mus__board *board, int32_t side);

/* ---- board_cut.c: panels apart and together ---- */

/**
 * Cut a panel in two along a chain from the start of side `from` to the start of side `to` (xy as in
 * mus__board_side_add(), its ends taken from the board). What is walked from `from` to just before `to` goes to a new
 * panel `name`; the rest stays. The two new sides are called `seam_name` in both panels and are sewn together. Marks go
 * to the panel that they lie in. Returns the new panel.
 */
int32_t mus__board_cut(mus__board *board, int32_t from, int32_t to, int32_t npiece, const int32_t *kinds, int32_t nxy,
                       const double *xy, const char *name, const char *seam_name);
/* undo of a cut: the panels of a seam between two panels become one: the other is moved so that its side lies on this
 * one (they must be congruent within 1e-6 m), its sides taken in, the seam gone. Where sides next to it are sewn to one
 * another and lie on each other too, their seams go as well */
void mus__board_join(mus__board *board, int32_t side);
/* move a whole panel in its plane: turned by `angle` about `centre`, then shifted; grain, marks and notches go along.
 * A flat placement is changed so that the panel stays where it was in space, a bent one so for a shift alone */
void mus__board_turn(mus__board *board, int32_t panel, const double *centre, double angle, const double *shift);
/* the mirror image (x to -x) of a panel as a new one: words run counter-clockwise again; placement mirrored in X */
int32_t mus__board_mirror(mus__board *board, int32_t panel, const char *name);
/* a panel and its mirror image in the straight side `side` become one panel; the side is gone. Sides of the image are
 * named as the originals with "L" and "R" at the end exchanged, or "_r" added; darts are mirrored with their seams */
void mus__board_unfold(mus__board *board, int32_t side);
void mus__board_remove_panel(mus__board *board, int32_t panel);

/**
 * A half garment (the wearer's left) becomes a whole one.
 *
 * Panels with a side CENTRE_FOLD are unfolded in it; every other is mirrored: "front" becomes "front_left" and
 * "front_right" (a panel whose cut is 2 mirrored says so: mirror_of). Seams within the half are repeated on the other;
 * sides of CENTRE_SEAM are sewn to their image, those of CENTRE_OPEN are not. Seams of a whole panel with two halves
 * (a side of the fold panel sewn to a side of a mirrored one) hold on both sides. Openings are as declared.
 */
void mus__board_double(mus__board *board);

/* ---- board_pleat.c ---- */

/* lay n pleats on a side: at arc length s[i] an outer fold, the pleat |depth[i]| deep, under what comes before it along
 * the walk (depth > 0) or after it. The side becomes parts; of what it was sewn to the parts that show take the place.
 * Pleats do not overlap: each takes from s - d to s + 2 d, or from s - 2 d to s + d. In order */
void mus__board_lay(mus__board *board, int32_t side, int32_t n, const double *s, const double *depth);

/* ---- board_patch.c ---- */

/* a piece `name` laid on a panel and sewn to the line through n points (n x 2) inside it, which is drawn into the panel
 * from its nearest corner; between its ends the piece is open. It starts a little outside the panel. Returns its panel
 */
int32_t mus__board_patch(mus__board *board, int32_t panel, int32_t n, const double *xy, const char *name);
/* does a line lie so far inside a panel that a patch can be sewn there? Asks only */
bool mus__board_patch_fits(mus__board *board, int32_t panel, int32_t n, const double *xy);

/* ---- board_inner.c: lines inside a panel, and the rim ---- */

/* fail the board where a side is part of a line inside its panel, which the word passes out and back: nothing is cut
 * from there. The sentence begins with `what` */
void mus__board_rim_side(mus__board *board, int32_t side, const char *what);
/* the corner where `side` starts may be one of several where the word passes that point: the side that starts at the
 * one from which the way goes towards a point */
int32_t mus__board_corner(const mus__board *board, int32_t side, const double *towards);
/* the same for a cut, sentence as above: MUS_NONE where that corner is of a line inside */
int32_t mus__board_rim_corner(mus__board *board, int32_t side, const double *towards, const char *what);

/* ---- board_part.c: parts of a panel that move as rigid pieces ---- */

/* turned about `centre`, then shifted */
typedef struct mus__board_motion {
    double centre[2], cosine, sine, shift[2];
} mus__board_motion;

/* the outline of a part, as chords; begin with zeros, end with mus__board_part_end() */
typedef struct mus__board_part {
    int32_t n, room;
    double *xy; /* (n x 2) */
} mus__board_part;

/* area within the outline of a panel, > 0 when it runs counter-clockwise */
double mus__board_area(const mus__board *board, int32_t panel);
void mus__board_chain_turn(mus__board_chain *chain, const mus__board_motion *motion);
/* the sides first..last as walked; their lengths stay to the bit */
void mus__board_part_turn(mus__board *board, int32_t first, int32_t last, const mus__board_motion *motion);
void mus__board_part_add(mus__board *board, mus__board_part *part, const mus__board_chain *chain);
void mus__board_part_run(mus__board *board, mus__board_part *part, int32_t first, int32_t last);
void mus__board_part_end(mus__board *board, mus__board_part *part);
/* points of marks that lie in `moving` go along; whole marks that do so (most of their points) go to a panel */
void mus__board_part_marks(mus__board *board, int32_t panel, const mus__board_part *moving,
                           const mus__board_part *still, const mus__board_motion *motion);
void mus__board_part_marks_to(mus__board *board, int32_t panel, const mus__board_part *moving,
                              const mus__board_part *still, int32_t to);
/* the line from a to b, which are on the outline or within, must lie in the panel and cross no side: else the board
 * fails, the sentence beginning with `what` */
void mus__board_part_clear(mus__board *board, int32_t panel, const char *what, const double *a, const double *b);
/* the end (or the start) of a side comes to `to`, with the control point next to it; an arc keeps its angle. The
 * neighbour is the caller's matter */
void mus__board_part_move_end(mus__board *board, int32_t side, bool end, const double *to);
/* an arc whose chord becomes `next` keeps its angle: `from`, start to middle point, follows */
void mus__board_arc_follow(const double *chord, double *from, const double *next);
/* a side became longer by `more`: the ease that its seam means follows */
void mus__board_part_ease(mus__board *board, int32_t side, double more);
/* the chain of a side was changed: its length, and notches at the same part of it */
void mus__board_part_changed(mus__board *board, int32_t side);

/* ---- board_dart.c ---- */

/* `leg` of a dart is the side that runs from the mouth to the point; its partner is next. Fails when it is none */
double mus__board_dart_angle(const mus__board *board, int32_t leg);
/**
 * Move a dart: pivot about its point. The panel is cut from the point to `target` at arc length s, and the part that
 * does not hold the side `keep` is turned so that `fraction` (0..1] of the dart's angle is taken up; the same angle
 * opens at the target as a new dart, whose legs are named target name + "_d1", "_d2". A dart taken up whole is gone:
 * its mouth sides are one again when they were one. Returns the leg of the new dart that runs from mouth to point.
 */
int32_t mus__board_dart_rotate(mus__board *board, int32_t leg, int32_t target, double s, int32_t keep, double fraction);
/* a dart on `side` about arc length s: mouth of `width`, point at `point`; returns the leg from the mouth */
int32_t mus__board_dart_add(mus__board *board, int32_t side, double s, double width, const double *point);
/* sewn point `back` nearer to the mouth, along the bisector */
void mus__board_dart_shorten(mus__board *board, int32_t leg, double back);
/* forget the dart: its mouth becomes one side with its neighbours (straight across); the cloth of it is gathered or
 * eased. Returns that side; the seam's ease grows by the width of the mouth */
int32_t mus__board_dart_release(mus__board *board, int32_t leg);
/* go on from the point of a dart to the start of side `to` along a chain: two panels, the dart part of their seam.
 * Returns the new panel (walked from the mouth's outer end to `to`) */
int32_t mus__board_dart_to_seam(mus__board *board, int32_t leg, int32_t to, int32_t npiece, const int32_t *kinds,
                                int32_t nxy, const double *xy, const char *name, const char *seam_name);

/* ---- board_spread.c ---- */

/* slash from side `from` at s0 to side `to` at s1 and spread: the part walked from `from` to `to` is moved so that the
 * slash opens by w0 at `from` and w1 at `to` (0: hinged there); the gap is filled, its ends are parts of those sides,
 * whose eases grow */
void mus__board_spread(mus__board *board, int32_t from, double s0, int32_t to, double s1, double w0, double w1);
/* lengthen (or shorten, amount < 0) across the line through `point` along `direction`: what lies to the left of it
 * moves by `amount` square to it; sides that cross are drawn again between their parts */
void mus__board_lengthen(mus__board *board, int32_t panel, const double *point, const double *direction, double amount);
/* a side drawn again: xy as in mus__board_side_add(), between other ends too: neighbours follow (their nearest control
 * point goes along). Notches keep their relative place */
void mus__board_redraw(mus__board *board, int32_t side, int32_t npiece, const int32_t *kinds, int32_t nxy,
                       const double *xy);

/* ---- board_fair.c ---- */

/* a side drawn again as one smooth line: as few cubics as stay `within` [m] of what it is, its ends and its tangents
 * there kept; what a curved ruler makes of a slashed hem or of a neck whose darts were released. A side without corners
 * stays as it is. Its seam's ease follows its length */
void mus__board_fair(mus__board *board, int32_t side, double within);

#endif
