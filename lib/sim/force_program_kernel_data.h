/*
 * force_program_kernel_data.h: a force program as the kernels read it.
 *
 * Every node is written by one place only and in a fixed order, so that any split over threads gives the same bits.
 *
 *   packet:  16 neighbouring lattice nodes, one to a lane, whose neighbours stand at the same index differences (its
 *            shape). A neighbour that a lane does not have is a zero in its table, so rows may differ in length and no
 *            lane needs a branch.
 *
 *               F . F . F      near (N): f += (kk - krest / l) (x[N] - x),  kk = k + w  of spring and bending
 *               . N N N .      far  (F): f += w (x[F] - x)
 *               F N o N F      A bending stencil k |a - 2 b + c|^2 / 2 is linear and its weights sum to 0, so the
 *               . N N N .      bending of a node is a sum of w times differences. The springs need the near ones
 *               F . F . F      anyway.
 *
 *   SELL:    the irregular part (strips, borders, hinges, tacks) as SELL-C-sigma: rows of items, one row a node, sorted
 *            by length inside a chunk, cut in slices of 16 rows and padded to the longest row of the slice.
 *            Source: Kreutzer, Hager, Wellein, Fehske, Bishop, A unified sparse matrix data format for efficient
 *            general sparse matrix-vector multiplication, SIAM J. Sci. Comput. 36 (2014).
 *   pair:    either end of a seam pair
 *   chunk:   some hundred consecutive nodes with their packets, slices, pair ends and attachments: the unit of work of
 *            a thread. Its forces stay in the thread's scratch until the step has used them.
 */
#ifndef MUS_SIM_FORCE_PROGRAM_KERNEL_DATA_H
#define MUS_SIM_FORCE_PROGRAM_KERNEL_DATA_H

#include <stdint.h>

#define MUS__LANES 16          /* nodes of a packet: one vector of 16 floats (AVX-512), two of 8 doubles */
#define MUS__SLOTS 8           /* near neighbours, and far neighbours, of a packet at most */
#define MUS__NEAR_SLOTS_MAX 12 /* near neighbours with the paper's bending springs, which skip one node */
#define MUS__CHUNK_NODES                                                                                               \
    512 /* nodes of a chunk at most: forces and one stage of RK4 stay in a first cache of 32 kB                        \
         */

/* index differences to the neighbours of a packet's nodes, ascending; 0 past the last */
typedef struct mus__packet_shape {
    int32_t near[MUS__NEAR_SLOTS_MAX], far[MUS__SLOTS];
} mus__packet_shape;

typedef struct mus__packet {
    int32_t first, shape, table; /* node; indices of its shape and of its table */
} mus__packet;

typedef struct mus__chunk {
    int32_t first, count;
    int32_t packet, npacket;         /* 0: no node of the chunk is on the lattice */
    int32_t slice, nslice;           /* in mus__sell.slice */
    int32_t end, nend;               /* in mus__program.pair_end */
    int32_t attachment, nattachment; /* in mus__program.attachment */
    int32_t clamp, nclamp;           /* in mus__program.clamp */
    int32_t cell, ncell;             /* in mus__program.cell */
} mus__chunk;

/* part `part` of a node's items, at most 8 of each kind */
typedef struct mus__sell_row {
    int32_t node, part;
    int32_t nhalf, nlinear;
} mus__sell_row;

/* items of one lane of a slice */
typedef struct mus__sell_slice {
    int32_t half, nhalf, linear, nlinear;
} mus__sell_slice;

/* the irregular part, slice by slice, lane by lane; padded with zeros */
typedef struct mus__sell {
    int32_t nslice;
    mus__sell_slice *slice; /* (nslice) */
    int32_t *node;          /* (nslice x lanes) */
    int32_t *half_other;    /* (half x lanes) the node at the other end of a half spring */
    void *half_constant;    /* (half x 2, with dashpots 3, x lanes) kk, krest (times mus__program_rest_factor), c */
    int32_t *linear_other;  /* (linear x lanes) */
    void *linear_weight;    /* (linear x lanes) */
    mus__sell_row *entry;   /* scratch: the rows of one chunk */
} mus__sell;

/* one end of seam pair `pair` */
typedef struct mus__pair_end {
    int32_t node, other, pair;
} mus__pair_end;

#endif
