/*
 * homology.h: homology over the integers of a small cell complex, by Smith normal form.
 */
#ifndef MUS_TOPOLOGY_HOMOLOGY_H
#define MUS_TOPOLOGY_HOMOLOGY_H

#include "base/base_internal.h"
#include "muslin/topology.h"

/* Smith normal form of the matrix whose entries are triples (n x 3) row, column, value (equal places are summed):
 * *rank, and factor (as many as the matrix has columns) gets `rank` invariant factors, each dividing the next. Errors:
 * MUS_ERR_LIMIT (an entry on the way beyond 2^31), MUS_ERR_MEMORY */
mus_status mus__smith(mus_context *context, int32_t rows, int32_t n, const int32_t *entry, int32_t *rank,
                      int32_t *factor);

/* homology of the complex with cells (3) of each dimension whose boundary operators d1 and d2 are triples, n (2) of
 * them. torsion (capacity) may be NULL. Errors: as mus__smith() */
mus_status mus__homology(mus_context *context, const int32_t *cells, const int32_t *n, int32_t *const *triple,
                         mus_homology *out, int32_t *torsion, int32_t capacity);

#endif
