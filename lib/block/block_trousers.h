/*
 * block_trousers.h: the trousers block, front and back of one leg.
 *
 * Frame: x from the centre line to the side, the fork at x < 0, y = 0 at the natural waist; lengths in metre.
 */
#ifndef MUS_BLOCK_TROUSERS_H
#define MUS_BLOCK_TROUSERS_H

#include "block/block_waist.h"

typedef struct mus__trousers_def {
    double waist, hip, hip_ease; /* girths of the body at the top edge and at the hip; total ease on the hip */
    double net[2];               /* sewn length of the top edge, front and back half */
    double top;                  /* level of the top edge at centre front */
    double rise;                 /* crotch line below the natural waist, its ease included */
    double inleg;                /* crotch line to hem */
    double thigh;                /* girth that the crotch line has at least */
    bool clings;                 /* it has just that girth, as far as a third of the usual forks allows */
    double knee[2], hem[2];      /* widths of front and back, across */
    double end;                  /* where the leg ends, as a part of inleg: 1 at the hem */
    bool darts;
    bool yoke; /* no dart in front; the back's are closed into a yoke */
} mus__trousers_def;

/* the yoke of a back, its darts closed: from the top edge to the seam that joins it to the leg. Its centre lies where
 * that of the leg does */
typedef struct mus__trousers_yoke {
    bool cut;
    double centre[4]; /* top edge to the seam: two points */
    double waist[8];  /* centre to side */
    mus__chain side;  /* top edge to the seam */
    double seam[8];   /* centre to side, as long as `top` */
    double top[4];    /* the seam on the leg: two points, centre to side */
} mus__trousers_yoke;

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
    double waist[MUS__DARTS + 1][8]; /* the top edge between its darts, fair when they are closed; none without darts */
    mus__trousers_yoke yoke;         /* cut off a back: centre, outseam and waist are still those of both together */
    double dart_width;   /* the darts together on the straight waist line, before it is trued */
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

/* Sets the widths for girths `knee` and `hem` of the leg [m]: the back is 2 cm wider than the front. */
void mus__trousers_widths(mus__trousers_def *def, double knee, double hem);
mus_status mus__trousers_draft(mus_context *context, const mus__trousers_def *def, mus__trousers *out);

#endif
