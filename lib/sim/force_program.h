/*
 * force_program.h: the force program: what a force evaluation of a cloth does, worked out once.
 *
 * A program holds the elements of a cloth twice: in plain form (force_program_elements.h), for reports, energies and
 * bounds; and packed for the kernels (force_program_kernel_data.h). It is made at create, and made again in place,
 * without taking memory, when seams are welded or opened and when a tack comes or goes.
 *
 * Files, in the order of use: force_program.c (rows of the lattice, build), force_program_elements.c (springs, hinges,
 * pairs, attachments, tacks), force_program_irregular.c (the irregular part, node by node), force_program_stencil.c
 * (lattice rows as packets), force_program_lanes.c (the irregular part as SELL-C-sigma), force_reference.c and
 * step_bound.c (readers of the plain form), sim.c with its kernels (stepping).
 */
#ifndef MUS_SIM_FORCE_PROGRAM_H
#define MUS_SIM_FORCE_PROGRAM_H

#include "sim/force_program_elements.h"
#include "sim/force_program_kernel_data.h"

typedef struct mus__program {
    /* plain form */
    int32_t nrow, nhalf_run, nhalf_bend;
    mus__program_row *row;
    mus__half_run *half_run;
    mus__half_bend *half_bend;
    int32_t *packet_of; /* (nnode) packet of a node in a row, 0 while there are no packets; MUS_NONE: in no row */

    int32_t nspring, nhinge, npair;
    mus__spring *spring;
    double *spring_dashpot; /* (nspring) [N s/m]: those of the cloth, then those of tacks */
    mus__hinge *hinge;
    mus__seam_pair *pair;

    int32_t nclamp;
    int64_t clamp_capacity;
    mus__hinge *clamp; /* (clamp_capacity) the elements at clamps once more, ascending by node[0], where they act */

    int32_t nslider, slider_capacity;
    mus__slider *slider; /* (slider_capacity) of lattice stencils, then of hinges; NULL without friction of bending */

    int32_t ncell_run;
    const mus__cell_run *cell_run; /* (ncell_run) the cloth's: cells that couple warp and weft (contraction.h) */
    mus__cell_run *cell;           /* the parts of them at the nodes of each chunk, chunk by chunk */
    double couple, couple_share, cell_side[2]; /* as in mus_cloth */

    int32_t ntack, tack_capacity;
    mus__tack *tack; /* (tack_capacity) numbers below ntack may be in use; NULL before the first tack */

    int32_t nattachment;
    mus__attachment *attachment;               /* (nattachment) ascending by node */
    mus__level_plane level[MUS_HOLD_COUNT][2]; /* left, right; both entries of a level of the torso are the same */

    /* packed form; constants (void *) are float or double by `real` */
    size_t real;       /* bytes of a number */
    int32_t near, far; /* slots of every packet: near 4, 8 or 12, far 0, 4 or 8; (4, 8) does not occur */
    int32_t npacket, nshape, ntable, nchunk;
    mus__packet *packet;      /* (npacket) */
    mus__packet_shape *shape; /* (nshape) */
    void *table; /* (ntable x slots x lanes): kk, krest of near (times mus__program_rest_factor), w of far, then with
                  * dashpots c of near */
    mus__chunk *chunk; /* (nchunk) ascending; every node is in one */
    mus__sell sell;
    mus__pair_end *pair_end; /* (2 npair) ascending by node */

    /* the irregular part node by node, of which packets and SELL are made */
    int32_t nirregular;
    int32_t *irregular_node; /* (nirregular) ascending: nodes that have irregular items */
    int32_t *half_start;     /* (nnode + 1) */
    int32_t *half_other;     /* (half_start[nnode]) */
    void *half_constant;     /* (half_start[nnode] x 3) kk, krest, c */
    int32_t *linear_start;   /* (nnode + 1) */
    int32_t *linear_other;   /* (linear_start[nnode]) */
    void *linear_weight;     /* (linear_start[nnode]) */

    int32_t spring_capacity, hinge_capacity, shape_capacity, table_capacity;
    int64_t spring_evaluations; /* springs of one force evaluation, each counted once */
    int32_t dashpots;           /* nonzero: some dashpot constant is not 0 */
    int32_t open_from; /* seams of panels from this layer on are open, the others are welded; 0: all are welded */
    int32_t wait_from; /* panels from this layer on wait: their seams do not pull; 0: none waits */
    double seam_pull;  /* tension of the pairs now [N per m of seam] */
} mus__program;

/* make the program of a cloth with open seams, for numbers of `real` bytes; the irregular part is left to the first
 * mus__program_weld. Frees nothing on failure: the caller calls mus__program_clear. Errors: MUS_ERR_MEMORY,
 * MUS_ERR_LIMIT (a lattice node with more than 20 neighbours) */
mus_status mus__program_build(mus_context *context, const mus_cloth *cloth, size_t real, mus__program *program);
void mus__program_clear(mus_context *context, mus__program *program);
/* make room for `need` tacks and keep those that there are. Errors: MUS_ERR_MEMORY, MUS_ERR_LIMIT; the program is as it
 * was */
mus_status mus__program_tack_room(mus_context *context, const mus_cloth *cloth, int32_t need, mus__program *program);
/* take over a changed list of tacks; `rep` as in the last mus__program_weld */
void mus__program_tacks_changed(const mus_cloth *cloth, const int32_t *rep, mus__program *program);
/* open the seams (rep NULL), or weld them: rep (nnode) is the representative of each node. Panels from
 * program->open_from on stay open. Takes no memory */
void mus__program_weld(const mus_cloth *cloth, const int32_t *rep, mus__program *program);

#endif
