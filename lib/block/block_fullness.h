/*
 * block_fullness.h: the outline of a sleeve made from the sleeve block: plain, or with fullness added by slashing and
 * spreading.
 */
#ifndef MUS_BLOCK_FULLNESS_H
#define MUS_BLOCK_FULLNESS_H

#include "block/block_sleeve.h"

/* the four parts of a cap, from the back underarm round to the front underarm */
enum { MUS__CAP_BACK_LOW, MUS__CAP_BACK_HIGH, MUS__CAP_FRONT_HIGH, MUS__CAP_FRONT_LOW, MUS__CAP_PARTS };

/* outline of a sleeve, counter-clockwise from the front of the hem; lengths in metre */
typedef struct mus__sleeve_cut {
    mus__chain hem;                 /* front to back */
    mus__chain under_back;          /* up */
    mus__chain cap[MUS__CAP_PARTS]; /* split at the pitch points and the crown */
    mus__chain under_front;         /* down */
    double crown[2], width;         /* point that the shoulder seam meets; breadth on the biceps line */
} mus__sleeve_cut;

/* The block without fullness. front, back: arc length of the cap from the underarm to the pitch [m], here and below. */
void mus__sleeve_plain(const mus__sleeve *block, double front, double back, mus__sleeve_cut *out);
/* Slashes the block from the hem to the cap and spreads it like a fan until the hem is `hem` long; the cap keeps its
 * length, the back of the hem is lowered by `drop` [m]. */
void mus__sleeve_fan(const mus__sleeve *block, double front, double back, double hem, double drop,
                     mus__sleeve_cut *out);
/* Spreads the block by `spread` from crown to hem, raises the crown by `raise` and lowers the hem by `drop` [m]. */
void mus__sleeve_puff(const mus__sleeve *block, double front, double back, double spread, double raise, double drop,
                      mus__sleeve_cut *out);
/* Leg of mutton: spreads the block above y = `elbow` by `spread` on the biceps line and raises the crown by `raise`
 * [m]. */
void mus__sleeve_gigot(const mus__sleeve *block, double front, double back, double elbow, double spread, double raise,
                       mus__sleeve_cut *out);
/* The cap alone: the part above `level` times its height, with a hollow hem and no underarm; the low parts of the cap
 * are empty. *front, *back get the arc length of the cap below that height [m]. */
void mus__sleeve_short_cap(const mus__sleeve *block, double level, double *front, double *back, mus__sleeve_cut *out);

#endif
