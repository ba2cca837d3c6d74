/*
 * parts.h: what the files of sleeves, cuffs and collars share: their blocks as plain geometry, and rims, the edges of
 * the sewn cloth that a sleeve or a collar is drafted to.
 *
 * Blocks are drawn in metre: collars with the centre back at x = 0, the left half towards x > 0.
 */
#ifndef MUS_PARTS_H
#define MUS_PARTS_H

#include "design/style.h"

/* ---- block_collar.c ---- */

typedef struct mus__stand_def {
    double length; /* of the bottom edge, centre back to front */
    double height; /* at the centre back; 0.85 of it in front */
    double rise;   /* of the bottom edge at the front: 0 stands away from the neck, 3 cm close to it */
} mus__stand_def;

/* a collar that stands: mandarin, or what a shirt collar's leaf is sewn to */
typedef struct mus__stand {
    double bottom[8], top[8]; /* centre back to front */
    double bottom_length, top_length;
} mus__stand;

mus_status mus__stand_draft(mus_context *context, const mus__stand_def *def, mus__stand *out);

typedef struct mus__leaf_def {
    double length; /* of the inner edge, centre back to front */
    double fall;   /* depth at the centre back */
    double point;  /* depth at the front, to the point */
    double rise;   /* of the inner edge at the front: < 0 bends against the stand */
} mus__leaf_def;

/* the part of a shirt collar that falls over its stand: inner edge above, y = 0 at the centre back */
typedef struct mus__leaf {
    double inner[8], outer[8]; /* centre back to front */
    double inner_length, outer_length;
} mus__leaf;

mus_status mus__leaf_draft(mus_context *context, const mus__leaf_def *def, mus__leaf *out);

typedef struct mus__hood_def {
    double length; /* of the neck edge, front to centre back */
    double head;   /* girth */
} mus__hood_def;

/* a half hood with its face edge on the line x = 0 or so and its back at x = width */
typedef struct mus__hood {
    double neck[8];  /* front to centre back */
    double crown[8]; /* centre back up and forward */
    double top[2];   /* where the crown, going on straight, meets the face edge */
    double width, height;
    double neck_length, crown_length, face_length;
} mus__hood;

mus_status mus__hood_draft(mus_context *context, const mus__hood_def *def, mus__hood *out);

/* ---- block_fullness.c ---- */

/* what the caps are cut into: from the back underarm round to the front one */
enum { MUS__CAP_BACK_LOW, MUS__CAP_BACK_HIGH, MUS__CAP_FRONT_HIGH, MUS__CAP_FRONT_LOW, MUS__CAP_PARTS };

/* a sleeve as it is cut out: the block, with fullness put in. Counter-clockwise from the front of the hem */
typedef struct mus__sleeve_cut {
    mus__chain hem;                 /* front to back */
    mus__chain under_back;          /* up */
    mus__chain cap[MUS__CAP_PARTS]; /* pitch and crown are the joints */
    mus__chain under_front;         /* down */
    double crown[2], width;         /* where the shoulder meets it; breadth on the biceps line */
} mus__sleeve_cut;

/* cubics through n (2..5) points with unit tangents; ds (n - 1): arc length from each to the next */
void mus__chain_through(mus__chain *chain, int32_t n, const double *xy, const double *tangent, const double *ds);
double mus__chain_length(const mus__chain *chain);

/* as drawn; front, back: arc length of the caps from the underarm to the pitch */
void mus__sleeve_plain(const mus__sleeve *block, double front, double back, mus__sleeve_cut *out);
/* slashed from hem to cap and spread like a fan, the cap keeps its length: hem `hem` long, `drop` longer behind */
void mus__sleeve_fan(const mus__sleeve *block, double front, double back, double hem, double drop,
                     mus__sleeve_cut *out);
/* spread by `spread` from crown to hem, crown raised and hem dropped in between the pitches */
void mus__sleeve_puff(const mus__sleeve *block, double front, double back, double spread, double raise, double drop,
                      mus__sleeve_cut *out);
/* leg of mutton: from the level `elbow` up spread by `spread` at the biceps, crown raised */
void mus__sleeve_gigot(const mus__sleeve *block, double front, double back, double elbow, double spread, double raise,
                       mus__sleeve_cut *out);
/* the part of the cap above `level` times its height: hem a hollow line; front, back get the arc length of the caps
 * that is left off below it. No underarm; caps are not cut at the pitch (their low parts are empty) */
void mus__sleeve_short_cap(const mus__sleeve *block, double level, double *front, double *back, mus__sleeve_cut *out);

/* ---- rim.c ---- */

#define MUS__RIM_SIDES 48

/* Open sides of the sewn half one after the other (mus__half_rim()) as one line. Panels are laid flat beside one
 * another, each seam that is passed closed at the rim: point p of the panel of side i lies at  R(turn[i]) p + shift[i],
 * the first panel as it is. */
typedef struct mus__rim {
    int32_t n;
    int32_t side[MUS__RIM_SIDES];
    int32_t over[MUS__RIM_SIDES]; /* the sewn side that was passed to come to this one, MUS_NONE: a plain corner */
    double s[MUS__RIM_SIDES + 1]; /* arc length where each starts, and of the whole */
    double turn[MUS__RIM_SIDES], shift[MUS__RIM_SIDES][2];
} mus__rim;

/* fails when there is no open side with `label`, or there are too many */
void mus__rim_read(mus__half *half, const char *label, mus__rim *out);
/* put a joint at arc length s, unless there is one within 1 mm: number of the side that starts there */
int32_t mus__rim_split(mus__board *board, mus__rim *rim, double s);
/* number of the first side that is come to over a seam with `label`, or MUS_NONE */
int32_t mus__rim_over(const mus__board *board, const mus__rim *rim, const char *label);
/* number of the side that starts nearest to `part` of the whole length, within `off` of it, or MUS_NONE */
int32_t mus__rim_near(const mus__rim *rim, double part, double off);
/* arc length of the first notch of `kind` on sides first..last - 1; NaN: there is none */
double mus__rim_notch(const mus__board *board, const mus__rim *rim, int32_t first, int32_t last, int32_t kind);
/* at arc length s, laid flat; tangent is a unit vector */
void mus__rim_at(const mus__board *board, const mus__rim *rim, double s, double *xy, double *tangent);

/* a side that starts where the last one of the panel ended */
int32_t mus__chain_side(mus__board *board, int32_t panel, const char *name, const char *label, double allowance,
                        const mus__chain *chain);

/* ---- sleeve_style.c ---- */

/* what the style and the armhole ask of a sleeve */
typedef struct mus__sleeve_plan {
    mus__rim arm;               /* the armhole, from the front underarm round */
    int32_t shoulder;           /* number of its first side behind */
    double front, back;         /* its lengths before and behind */
    double front_low, back_low; /* underarm to pitch */
    double ease;                /* of the cap, as a part of it */
    double reach;               /* how far down the arm it goes, from the biceps line 0 to the wrist 1 */
    double cuff_length, cuff_depth; /* 0: none */
    mus__sleeve block;              /* without its cuff */
} mus__sleeve_plan;

void mus__sleeve_plan_read(mus__half *half, mus__sleeve_plan *out);

/* ---- sleeve_raglan.c, sleeve_dolman.c: sleeves that take part of the front and back along ---- */

void mus__sleeve_raglan(mus__half *half, mus__sleeve_plan *plan);
void mus__sleeve_dolman(mus__half *half, mus__sleeve_plan *plan);

/* ---- cuff_style.c ---- */

/* a band of `length` sewn to the cuff edge of the half, `down` below the crown along the arm */
void mus__cuff_attach(mus__half *half, double length, double depth, double down);

/* ---- collar_style.c ---- */

/* what a collar is drafted to */
typedef struct mus__neck {
    mus__rim rim;      /* the neckline, centre back to centre front */
    double length;     /* of the half */
    double shoulder;   /* arc length where the shoulder seam meets it */
    bool front_open, back_open; /* the garment opens there */
} mus__neck;

/* collars that lie: Peter Pan, sailor, shawl */
void mus__collar_flat(mus__half *half, mus__neck *neck);
/* two pieces with a seam over the head */
void mus__hood_attach(mus__half *half, mus__neck *neck);

#endif
