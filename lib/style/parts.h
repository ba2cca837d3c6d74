/*
 * parts.h: the parts of a half garment, in the order in which a design calls them. Each part reads the words of the
 * style on its own axes, draws its panels on the board of the half and sews them to the panels that are there.
 */
#ifndef MUS_PARTS_H
#define MUS_PARTS_H

#include "half/half.h"

/* top.c, neckline.c, shaping.c: the body of a top, dress or jumpsuit: panels "front", "back" (and what shaping cuts
 * off them), sewn at shoulder and side, darts sewn, placed round the torso; without sleeve and collar. Down to the hem
 * (top) or the waist line with label "waist" (dress, jumpsuit) */
void mus__top_draft(mus__half *half);

/* the band that holds the gathers of a neck, when it has any: after the sleeves, of which raglan ones share the neck */
void mus__neck_band_attach(mus__half *half);

/* cape.c: front and back of a cape with their neck runs, sewn on the shoulders; without collar */
void mus__cape_draft(mus__half *half);

/* what concerns one side of the whole garment alone, after mus__board_double(): the end of a side zip */
void mus__closure_finish(mus__half *half);

/* sleeve.c: from the armhole runs of the half: the sleeve of its style drafted to their lengths, sewn in,
 * underarm sewn, placed round the arm, with its cuff; raglan and dolman recut front and back */
void mus__sleeve_attach(mus__half *half);

/* collar.c: from the neck runs: collar, hood or rib band sewn to them */
void mus__collar_attach(mus__half *half);

/* skirt.c: the half of a skirt (front and back, or its gores or sectors) with its top edge labelled "waist"; of a
 * dress, sewn to the waist runs of the bodice that is on the board */
void mus__skirt_attach(mus__half *half);

/* trousers.c: the left leg: front and back, inseam, outseam, crotch sides CENTRE_SEAM; of a jumpsuit, sewn to the
 * waist runs of the bodice */
void mus__trousers_attach(mus__half *half);

/* band.c: waistband or facing on the waist runs of a skirt or trousers; cuffs; patch pockets */
void mus__band_attach(mus__half *half);
void mus__pocket_attach(mus__half *half);
/* the pockets themselves, on the whole garment, after mus__board_double() */
void mus__pocket_finish(mus__half *half);

#endif
