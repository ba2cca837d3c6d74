/*
 * edge_list.h: the plain form of a lattice's motion, which muslin is measured against and tested with: one list of
 * springs and one of bending stencils, with the indices of their nodes, scattered to all ends; textbook passes round
 * it. Float and double.
 */
#ifndef BENCH_EDGE_LIST_H
#define BENCH_EDGE_LIST_H

#include <stdint.h>

/* what a lattice is made of: line springs and stencils along columns of nodes (warp) and rows (weft), both diagonals */
typedef struct plain_lattice {
    int32_t rows, columns;
    double cell[2];        /* along weft and warp [m] */
    double k[2];           /* of line springs along warp and weft [N/m]; those of the border have half */
    double shear;          /* of diagonals [N/m]; 0: none */
    double bend[2], cross; /* of stencils along warp and weft, and along both diagonals [N/m]; 0: none */
    double weight;         /* [kg/m2] */
    double drag;           /* [1/s] */
} plain_lattice;

#define PLAIN_REAL float
#define PLAIN(name) plain32_##name
#include "edge_list_types.h"
#undef PLAIN_REAL
#undef PLAIN

#define PLAIN_REAL double
#define PLAIN(name) plain64_##name
#include "edge_list_types.h"
#undef PLAIN_REAL
#undef PLAIN

#endif
