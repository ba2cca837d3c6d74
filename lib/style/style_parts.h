/*
 * style_parts.h: the parts of a half garment, in the order in which a design calls them. Each part reads the words of
 * the style on its own axes, draws its panels on the board of the half and sews them to the panels that are there.
 */
#ifndef MUS_STYLE_PARTS_H
#define MUS_STYLE_PARTS_H

#include "half/half_garment.h"

/* bodice.c: the body of a top, dress or jumpsuit without sleeves and collar: panels "front" and "back" (and the panels
 * that shaping cuts off them), darts, shoulders and sides sewn, placed round the torso. It ends at the hem, or at a
 * waist line with label "waist" */
void mus__top_draft(mus__half *half);

/* shaping_gather.c: the band that a gathered neck is sewn to; after the sleeves, since raglan sleeves share the neck */
void mus__neck_band_attach(mus__half *half);

/* cape.c: front and back of a cape with their neck runs, sewn on the shoulders; without collar */
void mus__cape_draft(mus__half *half);

/* sleeve.c: the sleeve with its cuff, drafted to the lengths of the armhole, sewn in and placed round the arm; raglan
 * and dolman sleeves recut front and back */
void mus__sleeve_attach(mus__half *half);

/* collar.c: the collar, hood or rib on the neckline */
void mus__collar_attach(mus__half *half);

/* skirt.c: the half of a skirt (front and back, or its gores or sectors) with its top edge labelled "waist"; that of a
 * dress is sewn to the waist of the bodice */
void mus__skirt_attach(mus__half *half);

/* trousers.c: the left leg: front and back, sewn at inseam and outseam, crotch edges MUS__CENTRE_SEAM; that of a
 * jumpsuit is sewn to the waist of the bodice */
void mus__trousers_attach(mus__half *half);
/* whether they are leggings: close trousers of a knit, which stretches all round the leg */
bool mus__trousers_close(const mus__half *half);

/* girths of leggings over those of the body; chosen: jersey clings there and still goes on */
#define MUS__CLOSE_GIRTH 0.92

/* waistband.c: waistband or facing of a skirt or trousers */
void mus__band_attach(mus__half *half);

#endif
