/*
 * worn_hood.h: the hood of a garment and the head that it is for (worn_hood.c).
 */
#ifndef MUS_FIT_WORN_HOOD_H
#define MUS_FIT_WORN_HOOD_H

#include "muslin/fit.h"

#define MUS__HOOD_HAND 256 /* nodes that hands take at most; a finer cut than of 1 mm has the first of them */

/* the head: a dome round the centre of its widest contour */
typedef struct mus__head {
    int32_t there;                   /* 0: the body has none */
    double brow[3];                  /* the centre [m] */
    double eyes[3];                  /* below it, between the eyes, inside the head [m] */
    double up[3], front[3], left[3]; /* unit directions of the trunk */
} mus__head;

/* the part of the face edge that hands take */
typedef struct mus__hood_edge {
    mus__head head;
    int32_t count;                /* of its nodes; 0: the garment has no hood */
    int32_t node[MUS__HOOD_HAND]; /* the first is the middle */
    double along[MUS__HOOD_HAND]; /* of each, way along the edge from the middle, to the left [m] */
} mus__hood_edge;

/* the hood as the cloth lies now. Errors: MUS_ERR_MEMORY */
mus_status mus__fit_hood(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body, mus__hood_edge *out);

#endif
