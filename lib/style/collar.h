/*
 * collar.h: what the files of collars and hoods share.
 */
#ifndef MUS_COLLAR_H
#define MUS_COLLAR_H

#include "block/block_collar.h"
#include "half/boundary_loop.h"
#include "half/half_placement.h"
#include "style/style_parts.h"

#define MUS__COLLAR_SEAM 0.007 /* [m] allowance of a collar: narrow, since it is turned */
#define MUS__COLLAR_LIES 1     /* layer of a collar that lies on the garment: it is put on last */

/* the neckline that a collar is drafted to */
typedef struct mus__neck {
    mus__boundary loop;      /* the neckline, centre back to centre front */
    double length;     /* of the half [m] */
    double shoulder;   /* arc length where the shoulder seam meets it */
    bool front_open, back_open; /* whether the garment opens at the centre */
} mus__neck;

/* Peter Pan, sailor and shawl collars, which lie on the shoulders */
void mus__collar_flat(mus__half *half, mus__neck *neck);
/* the hood: two pieces with a seam over the head */
void mus__hood_attach(mus__half *half, mus__neck *neck);

#endif
