/*
 * skin.h: the skin of a body: what is drawn. The rings of the limbs (mus_body.vertices) are what measures and contact
 * know; the skin starts from them and is one surface where limbs meet.
 */
#ifndef MUS_BODY_SKIN_H
#define MUS_BODY_SKIN_H

#include "body/body_internal.h"

/* what a place of the surface may meet */
typedef struct mus__skin_union {
    const mus_body *body;
    int32_t limb;                 /* the limb whose surface it is */
    double reach;                 /* width of a fillet along both surfaces of a right-angled crease [m] */
    double groin[2];              /* of the fillets between torso and legs, left and right, in parts of the reach */
    double most;                  /* no vertex of the ring moves further [m] */
    double low[MUS_PARTS_MOST][3]; /* boxes of the parts, grown by the reach */
    double high[MUS_PARTS_MOST][3];
    int32_t count;                /* parts that may be near */
    int32_t part[MUS_PARTS_MOST];
} mus__skin_union;

/* move a vertex onto the union and turn its normal; false: it is not near another part and stays */
bool mus__skin_move(const mus__skin_union *at, double *x, double *normal);

#endif
