/*
 * lower.h: what the files of the lower body share: sketches that become panels of the half, the waist as a run over
 * panels, girths of the body at a level, the trousers block.
 *
 * Levels are heights above the natural waist (below it negative). A sketch is drawn as the blocks are (x from the
 * centre line to the side); lower_panel turns it, or its mirror image for a back, into a panel. Formulas: man page
 * mus_design(3).
 */
#ifndef MUS_LOWER_H
#define MUS_LOWER_H

#include "design/parts.h"

#define MUS__LOWER_SIDES 16
#define MUS__WAIST_SIDES 32

/* ---- lower.c: sketches ---- */

typedef struct mus__sketch_side {
    char name[16];
    const char *label;
    double allowance;
    mus__chain chain;
} mus__sketch_side;

typedef struct mus__sketch {
    int32_t n;
    mus__sketch_side side[MUS__LOWER_SIDES];
} mus__sketch;

void mus__sketch_begin(mus__sketch *sketch);
/* next side, counter-clockwise as drawn */
void mus__sketch_add(mus__sketch *sketch, const char *name, const char *label, double allowance,
                     const mus__chain *chain);
void mus__sketch_line(mus__sketch *sketch, const char *name, const char *label, double allowance, const double *start,
                      const double *end);
/* the sketch as a panel of the half; `mirror`: its image in x = 0, so that it runs counter-clockwise again */
int32_t mus__sketch_panel(mus__half *half, const mus__sketch *sketch, const char *name, const char *label,
                          bool mirror);
/* what becomes of a side at the centre line (MUS__CENTRE_*) */
void mus__lower_centre(mus__half *half, int32_t panel, const char *name, int32_t centre);
/* sew two sides by name, right sides out; ease = length of b less length of a that is meant */
void mus__lower_sew(mus__half *half, int32_t panel_a, const char *a, int32_t panel_b, const char *b, double ease);
/* both legs of the darts "d1" "d2", "d3" "d4" of a panel */
void mus__lower_darts(mus__half *half, int32_t panel);

/* the top edge from the side to the centre, as it is walked: "waist" sides w1.. and between them dart legs d1.., from
 * (n x 6) darts: inner mouth, point, outer mouth, from the centre outwards; the parts (n + 1) from the centre outwards,
 * each drawn from the centre outwards */
void mus__sketch_top(mus__sketch *sketch, int32_t n, const double (*dart)[6], const mus__chain *part);

/* x of every point more by `dx` */
void mus__chain_shift(mus__chain *chain, double dx);
/* a block failed, its sentence is in the context: the board has failed too */
void mus__lower_failed(mus__half *half, mus_status status);

/* ---- lower.c: the person and the waist ---- */

/* girth of the body at a level between underbust and hip */
double mus__lower_girth(const mus__half *half, double level);
/* top edge of the skirt or trousers, its band not counted: the waist, or below it by the rise and a shaped band */
double mus__lower_level(const mus__half *half);
/* 1 for a waist to hip of 20 cm and more, below in proportion */
double mus__lower_scale(const mus__half *half);
/* whether a bodice is on the board, whose waist is sewn to what is drawn */
bool mus__lower_has_top(const mus__half *half);
/* sewn length of the front or back half of the top edge at a level: a quarter of girth and ease, `more` added in front
 * and taken off behind; under a bodice that of its waist */
double mus__lower_net(const mus__half *half, bool front, double level, double more);
/* ease on the waist of skirt or trousers: half->waist_ease, of a garment that hangs on the waist 0.1 of what the hip is
 * larger at most */
double mus__lower_waist_ease(const mus__half *half);

/* sides labelled "waist" one after the other along the rim of what is on the board, passing over seams, of the panels
 * from `first` to before `last`; as walked. How many (at most MUS__WAIST_SIDES) */
int32_t mus__lower_waist(const mus__half *half, int32_t first, int32_t last, int32_t *sides);
/* the joint of the bodice's waist nearest to arc length s (darts closed) of the front or back half from the centre, if
 * one is within `reach`; else s */
double mus__lower_snap(const mus__half *half, bool front, double s, double reach);
/* sew the waist of the panels from `first` on to that of the bodice, when there is one */
void mus__lower_waist_sew(mus__half *half, int32_t first);

/* ---- lower_place.c ---- */

/* face azimuth `around` from the front to the left, the top leaned in by `tilt`, bent by `bend` */
void mus__lower_place(mus__half *half, int32_t panel, double around, double tilt, const double *origin, double bend);
/* half a ring round the waist */
void mus__lower_place_waist(mus__half *half, int32_t panel, bool front, double girth, double height);
/* before or behind the left leg: the crease (from the centre line) over it, the fork `inner` from the crease; `girth`
 * of front and back on the crotch line; `away` the least distance before or behind the body's middle plane */
void mus__lower_place_leg(mus__half *half, int32_t panel, bool front, double crease, double inner, double girth,
                          double away);

/* ---- block_trousers.c ---- */

typedef struct mus__trousers_def {
    double waist, hip, hip_ease; /* girths of the body at the top edge and at the hip; total ease on the hip */
    double net[2];               /* top edge of front and back, darts sewn */
    double top;                  /* level of the top edge at centre front */
    double rise;                 /* crotch line below the natural waist, its ease included */
    double inleg;                /* crotch line to hem */
    double thigh;                /* girth of the body that the crotch line must clear by 3 cm */
    double knee[2], hem[2];      /* widths of front and back, across */
    double end;                  /* where the leg is cut, as a part of inleg: 1 at the hem */
    bool darts;
} mus__trousers_def;

/* a front or back half: side at x > 0, fork at x < 0, y = 0 at the natural waist */
typedef struct mus__trousers_half {
    double centre[4];    /* top edge to hip line: two points */
    double crotch[8];    /* hip line to fork */
    mus__chain inseam;   /* fork to hem */
    mus__chain outseam;  /* top edge to hem */
    double side[2];      /* top edge at the side */
    double hem[8];       /* inseam to outseam, square to both */
    int32_t ndart;
    double dart[MUS__DARTS][6]; /* inner mouth, point, outer mouth; from the centre outwards */
    double dart_width;
    double crease;       /* x of the leg's middle */
    double fork, hip;    /* widths beyond the centre line and before it on the crotch line */
    double fork_drop;    /* fork below the crotch line */
    double waist_length; /* darts closed */
    double crotch_length, inseam_length, outseam_length;
    double knee_in, knee_out; /* arc length of the knee along both seams, from the hem; 0 when cut above */
} mus__trousers_half;

typedef struct mus__trousers {
    mus__trousers_half front, back;
    double thigh;  /* girth on the crotch line */
    double hip;    /* level of the hip line */
    double crotch; /* level of the crotch line */
} mus__trousers;

/* widths for leg girths `knee` and `hem`: the back 2 cm wider than the front */
void mus__trousers_widths(mus__trousers_def *def, double knee, double hem);
mus_status mus__trousers_draft(mus_context *context, const mus__trousers_def *def, mus__trousers *out);

/* the first `s` of a chain */
void mus__chain_cut(const mus__chain *chain, double s, mus__chain *out);

/* ---- skirts: each draws its panels on the board of the half and sews them but for the waist ---- */

double mus__skirt_length(const mus__half *half);
void mus__skirt_straight(mus__half *half);
void mus__skirt_wrap(mus__half *half);
void mus__skirt_gores(mus__half *half);
void mus__skirt_round(mus__half *half);
void mus__skirt_gathered(mus__half *half);

#endif
