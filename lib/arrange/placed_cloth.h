/*
 * placed_cloth.h: a cloth with the places of its nodes: what the checks and changes of an arrangement look at.
 *
 * It borrows all of its members. A drape makes one of its own arrays (mus__drape_placed), a test of an array and a
 * cloth.
 */
#ifndef MUS_ARRANGE_PLACED_CLOTH_H
#define MUS_ARRANGE_PLACED_CLOTH_H

#include "cloth/cloth_internal.h"
#include "contact/contact.h"

typedef struct mus__placed_cloth {
    mus_context *context;
    const mus_cloth *cloth;
    const mus__collider *collider; /* the body, where it stands now; NULL without one */
    const int32_t *rep;            /* (nnode) representative of each node; itself when not welded */
    double *x;                     /* (nnode x 3) [m] */
    double gravity[3];             /* [m/s2] */
    int32_t layered;               /* nonzero: layers of panels are sewn one after the other */
} mus__placed_cloth;

/* mean of the normals of a panel's triangles, by area, out (3): of length 1 for a flat panel, shorter for a rolled one
 */
void mus__placed_facing(const mus__placed_cloth *placed, int32_t panel, double *out);
/* mean place of a panel's nodes, out (3) [m] */
void mus__placed_middle(const mus__placed_cloth *placed, int32_t panel, double *out);
/* smooth unit normals of the nodes, out (nnode x 3), right side out, averaged over welded seams */
void mus__placed_normals(const mus__placed_cloth *placed, double *out);
/* pairs of triangles that cross, exactly: *count of them, and the first `most` of them to pairs (most x 2). Nodes that
 * a seam joins count as one. Errors: MUS_ERR_MEMORY */
mus_status mus__placed_crossings(const mus__placed_cloth *placed, int32_t most, int32_t *pairs, int64_t *count);

#endif
