/*
 * block_fullness.h: the sleeve block cut out, plain or with fullness put in by slashing and spreading.
 */
#ifndef MUS_BLOCK_FULLNESS_H
#define MUS_BLOCK_FULLNESS_H

#include "block/block_sleeve.h"

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

#endif
