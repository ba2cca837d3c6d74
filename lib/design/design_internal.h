/*
 * design_internal.h: what the files of lib/design share: the measures as an array, the drafted blocks as plain
 * geometry, chains of curves, the piece that turns a drawing into a panel.
 *
 * Frame of a block: x from the centre line outwards to the side seam, y up, y = 0 on the waist line (sleeve: on the
 * biceps line); lengths in metre, angles in radian. A drawn front half is the wearer's left, a drawn back half the
 * wearer's right, a drawn sleeve the left one with its front at x < 0; the other side is the mirror image.
 * A cubic is 8 numbers: start, two handles, end.
 */
#ifndef MUS_DESIGN_INTERNAL_H
#define MUS_DESIGN_INTERNAL_H

#include <stdbool.h>
#include <stdint.h>

#include "base/base_internal.h"
#include "limb/skeleton.h"
#include "muslin/design.h"

#define MUS__CM 0.01
#define MUS__DEGREE 0.017453292519943295

/* ---- measures ---- */

typedef struct mus__measures {
    double v[MUS_MEASURE_COUNT]; /* [m] or [rad], all set */
    int32_t sex;                 /* MUS_SEX_* */
    bool front_waist_given;      /* a measured front waist length wins over the dart angle */
} mus__measures;

/* `tape` must be complete */
void mus__measures_read(const mus_tape *tape, mus__measures *out);
/* ease of a small body: 1 from a bust of 80 cm on, below in proportion */
double mus__measures_scale(const mus__measures *measures);
/* whole millimetres, for messages */
int mus__millimetres(double x);

/* ---- curves ---- */

void mus__cubic_set(double *out, const double *start, double ax, double ay, double bx, double by, const double *end);
double mus__cubic_length(const double *cubic);
/* the part of a cubic between arc lengths s0 < s1 */
void mus__cubic_part(const double *cubic, double s0, double s1, double *out);
/* root of f between lo and hi; false when f has the same sign at both */
bool mus__solve(double (*f)(const void *data, double x), const void *data, double lo, double hi, double *root);

#define MUS__CHAIN_PIECES 4

/* lines, arcs and cubics end to end: one edge of a panel */
typedef struct mus__chain {
    int32_t npiece;
    int32_t kinds[MUS__CHAIN_PIECES];
    int32_t nxy;
    double xy[2 * (3 * MUS__CHAIN_PIECES + 1)]; /* (nxy x 2), both ends included */
} mus__chain;

void mus__chain_line(mus__chain *chain, const double *start, const double *end);
void mus__chain_cubic(mus__chain *chain, const double *cubic);
void mus__chain_arc(mus__chain *chain, const double *start, const double *middle, const double *end);
/* `chain` then `next`, which starts where `chain` ends */
void mus__chain_append(mus__chain *chain, const mus__chain *next);
void mus__chain_reverse(mus__chain *chain);
/* x to -x, and reversed: the same edge of the other half, walked counter-clockwise */
void mus__chain_mirror(mus__chain *chain);
/* a chain that ends on the centre line, and after it its mirror image */
void mus__chain_unfold(mus__chain *chain);

/* ---- blocks ---- */

typedef struct mus__bodice_def {
    double bust_ease;  /* total, on the girth */
    double waist_ease; /* total */
    double scye_ease;  /* armhole deeper than the scye depth by */
    double balance;    /* front half wider than the back half by */
    double neck_ease;  /* total */
    bool darts;
} mus__bodice_def;

#define MUS__DARTS 2

/* a front or back half of a bodice */
typedef struct mus__bodice_half {
    double slope;    /* of the shoulder line below the horizontal */
    double hold[2];  /* neck handles: at the centre as part of its width, at the shoulder as part of its depth */
    double centre[2], snp[2], tip[2], pitch[2], under[2], side[2]; /* neck at the centre, side neck, shoulder point,
                                                                      arm pitch, underarm, waist at the side */
    double neck[8];     /* centre to snp */
    double arm_high[8]; /* tip to pitch */
    double arm_low[8];  /* pitch to under */
    double theta;       /* bust dart angle, 0 without */
    double bust[2];     /* bust point: where the darts turn */
    double mouth[4];    /* ends of the bust dart on the side seam: upper, lower */
    double apex[2];     /* sewn point of the bust dart */
    int32_t ndart;      /* waist darts */
    double dart[MUS__DARTS][6]; /* inner mouth, sewn point, outer mouth; from the centre outwards */
    double neck_length, shoulder_length, arm_length, arm_low_length;
    double side_length;  /* dart closed */
    double waist_length; /* darts closed */
} mus__bodice_half;

typedef struct mus__bodice {
    mus__bodice_half front, back;
    double underarm;    /* y */
    double dart_width;  /* waist dart of one half */
    double side_in;     /* side seam taken in at the waist */
    double dart_drop;   /* what the bust dart makes the front longer by */
    double front_waist; /* front waist length of the draft */
    double neck_depth;  /* front, from the side neck */
} mus__bodice;

mus_status mus__bodice_draft(mus_context *context, const mus__measures *measures, const mus__bodice_def *def,
                             mus__bodice *out);
/* the house values: woven, darted for women */
void mus__bodice_def_init(mus__bodice_def *def, const mus__measures *measures);
/* redraw a neckline: side neck `along` the shoulder, centre `drop` lower */
void mus__bodice_lower_neck(mus__bodice_half *half, double along, double drop);

typedef struct mus__sleeve_def {
    double front, back; /* length of the two cap halves */
    double width;       /* on the biceps line */
    double length;      /* crown to hem */
    double hem;         /* width at the hem */
} mus__sleeve_def;

typedef struct mus__sleeve {
    double width, height, crown, length, hem; /* crown: x of the crown */
    double cap_front[8];                      /* front underarm to crown */
    double cap_back[8];                       /* crown to back underarm */
    double front_length, back_length, under_length;
} mus__sleeve;

mus_status mus__sleeve_draft(mus_context *context, const mus__sleeve_def *def, mus__sleeve *out);
/* biceps width at which a cap of length `cap` is `ratio` of that length high */
double mus__sleeve_width(double cap, double ratio);

typedef struct mus__skirt_def {
    double waist, hip;  /* girths of the body at the top edge and at the hip */
    double depth;       /* top edge to hip level */
    double waist_ease, hip_ease;
    double length;      /* top edge to hem, at the centre */
    double flare;       /* hem wider than the hip by, a half */
    double rise;        /* top edge higher at the side by */
    double shift;       /* waist of the front wider by, of the back narrower: beyond the block's own 5 mm */
    double dart_at[2];  /* front, back: the first dart so far from the centre, darts closed; 0: the block's own place */
    bool darts;
} mus__skirt_def;

/* a front or back half of a skirt, y = 0 at the centre of its top edge */
typedef struct mus__skirt_half {
    double waist[8];     /* centre to side */
    double side_high[8]; /* waist to hip */
    double side_low[8];  /* hip to hem */
    double hem[8];       /* centre to side */
    double hip, hem_width;
    double dart_width; /* all darts */
    int32_t ndart;
    double dart[MUS__DARTS][6];  /* inner mouth, point, outer mouth; from the centre outwards */
    double dart_s[MUS__DARTS][2]; /* arc lengths of the mouths along `waist` */
    double waist_length; /* darts closed */
    double side_length, side_high_length;
} mus__skirt_half;

typedef struct mus__skirt {
    mus__skirt_half front, back;
} mus__skirt;

mus_status mus__skirt_draft(mus_context *context, const mus__skirt_def *def, mus__skirt *out);

/* ---- from drawing to pattern ---- */

/* one draft in the making. After a failure `status` stays and every later call does nothing */
typedef struct mus__draft {
    mus_context *context;
    mus__measures measures;
    mus__skeleton skeleton;
    mus_draft_def def;
    mus_pattern *pattern;
    mus_status status;
} mus__draft;

#define MUS__PIECE_EDGES 24
#define MUS__EDGE_NAME_BYTES 16

typedef struct mus__piece_edge {
    char name[MUS__EDGE_NAME_BYTES];
    const char *label;
    double allowance;
    mus__chain chain; /* as drawn */
    int32_t edge;     /* in the pattern */
} mus__piece_edge;

typedef struct mus__piece {
    mus__draft *draft;
    int32_t panel;
    bool mirror;
    int32_t n;
    mus__piece_edge edges[MUS__PIECE_EDGES];
} mus__piece;

void mus__piece_begin(mus__piece *piece, mus__draft *draft);
/* next edge, counter-clockwise */
void mus__piece_edge_add(mus__piece *piece, const char *name, const char *label, double allowance,
                         const mus__chain *chain);
/* edges first..last again in reverse as mirror images, 'L' at the end of their names turned to 'R' and back */
void mus__piece_unfold(mus__piece *piece, int32_t first, int32_t last);
/* turn the drawing, or its mirror image, into a panel with outline, grain along y, cut 1 */
void mus__piece_panel(mus__piece *piece, const char *name, const char *label, bool mirror);
/* index of an edge in the pattern, MUS_NONE if there is none */
int32_t mus__piece_edge_find(const mus__piece *piece, const char *name);
/* at arc length s from the start of the edge as drawn */
void mus__piece_notch(mus__piece *piece, const char *edge, double s, int32_t kind);
void mus__piece_mark(mus__piece *piece, const char *name, const double *start, const double *end);
/* sew a.edge_a to b.edge_b, right sides out */
void mus__piece_seam(const mus__piece *a, const char *edge_a, const mus__piece *b, const char *edge_b, double ease);
/* `piece` is cut twice, and `twin` is its mirror image */
void mus__piece_pair(const mus__piece *piece, const mus__piece *twin);

/* ---- round the body ---- */

/* front or back of the torso, bent so that its sides pass before or behind the arms; `width` half width of the panel,
 * y = 0 of the panel at `height` above the floor */
void mus__place_torso(mus__piece *piece, bool front, double width, double height);
/* sleeve rolled round arm `side` (0 left, 1 right), crown at the shoulder point */
void mus__place_arm(mus__piece *piece, const mus__sleeve *sleeve, int32_t side);
/* front or back of a skirt bent round the hips; `width` widest half front and half back together */
void mus__place_hips(mus__piece *piece, bool front, double width, double height);

/* ---- the designs ---- */

/* the caller's wishes; measures and skeleton of a tape, completed on a copy */
mus_status mus__design_read(mus_context *context, const mus_tape *tape, const mus_draft_def *def,
                            mus_draft_def *wishes, mus__measures *measures, mus__skeleton *skeleton);
/* the first fault of a draft is the failure of its recipe */
mus_status mus__design_check(mus_context *context, mus_pattern *pattern);

void mus__draft_bodice(mus__draft *draft);
void mus__draft_tshirt(mus__draft *draft);
void mus__draft_sleeveless(mus__draft *draft);
void mus__draft_skirt(mus__draft *draft);
void mus__draft_skirt_plain(mus__draft *draft);
void mus__draft_circle_skirt(mus__draft *draft);

#endif
