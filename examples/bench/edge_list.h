/*
 * edge_list.h: the plain reference for the force program, in float and double: the motion of a lattice with one list of
 * springs and one list of bending stencils, each with the indices of its nodes. Forces are added to all nodes of an
 * element, and a step is textbook RK4. muslin is timed against it and tested with it.
 */
#ifndef BENCH_EDGE_LIST_H
#define BENCH_EDGE_LIST_H

#include <stdint.h>

/* constants of a lattice: springs and stencils along columns of nodes (warp), rows (weft) and both diagonals */
typedef struct plain_lattice {
    int32_t rows, columns;
    double cell[2];        /* along weft and warp [m] */
    double k[2];           /* stiffness of springs along warp and weft [N/m]; at the border half of it */
    double shear;          /* stiffness of diagonals [N/m]; 0: none */
    double bend[2], cross; /* stiffness of stencils along warp and weft, along both diagonals [N/m]; 0: none */
    double weight;         /* mass per area [kg/m2] */
    double drag;           /* drag per mass [1/s] */
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
