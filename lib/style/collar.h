/*
 * collar.h: what the files of collars and hoods share.
 */
#ifndef MUS_COLLAR_H
#define MUS_COLLAR_H

#include "block/block_collar.h"
#include "half/boundary.h"
#include "half/panel_place.h"
#include "style/parts.h"

/* what a collar is drafted to */
typedef struct mus__neck {
    mus__boundary loop;      /* the neckline, centre back to centre front */
    double length;     /* of the half */
    double shoulder;   /* arc length where the shoulder seam meets it */
    bool front_open, back_open; /* the garment opens there */
} mus__neck;

/* collars that lie: Peter Pan, sailor, shawl */
void mus__collar_flat(mus__half *half, mus__neck *neck);
/* two pieces with a seam over the head */
void mus__hood_attach(mus__half *half, mus__neck *neck);

#endif
