/*
 * force_program_parts.h: what the files of the force program share among themselves.
 */
#ifndef MUS_SIM_FORCE_PROGRAM_PARTS_H
#define MUS_SIM_FORCE_PROGRAM_PARTS_H

#include "sim/force_program.h"

/* ---- force_program_elements.c ---- */

/* memory of springs: those of the cloth and room for tack_capacity tacks */
mus_status mus__program_springs_create(mus_context *context, const mus_cloth *cloth, mus__program *program);
/* memory of springs, hinges, pairs and attachments */
mus_status mus__program_elements_create(mus_context *context, const mus_cloth *cloth, mus__program *program);
/* springs, hinges, pairs and attachments with their nodes replaced by rep (nnode); NULL: all seams are open */
void mus__program_elements(const mus_cloth *cloth, const int32_t *rep, mus__program *program);
/* springs and tacks alone */
void mus__program_springs(const mus_cloth *cloth, const int32_t *rep, mus__program *program);

/* ---- force_program_irregular.c ---- */

/* memory of the irregular part; of its half springs alone, by spring_capacity */
mus_status mus__program_irregular_create(mus_context *context, const mus_cloth *cloth, mus__program *program);
mus_status mus__program_half_springs_create(mus_context *context, mus__program *program);
/* the items that act between lattice nodes and that no weld will change */
void mus__program_irregular_lattice(const mus_cloth *cloth, mus__program *program);
/* all items that are in no packet, and the ends of the pairs */
void mus__program_irregular(const mus_cloth *cloth, mus__program *program);

/* ---- force_program_stencil.c ---- */

/* packets and chunks of the lattice rows; packets take in what they can of the lattice items above */
mus_status mus__program_stencil(mus_context *context, const mus_cloth *cloth, mus__program *program);
/* slot of a neighbour in the packet of a lattice node: below MUS__NEAR_SLOTS_MAX a near slot, from there on a far one;
 * MUS_NONE when there is no such slot */
int32_t mus__program_stencil_slot(const mus__program *program, int32_t node, int32_t other);

/* ---- force_program_lanes.c ---- */

/* memory of the SELL form; fill it from the irregular part; free it */
mus_status mus__program_sell_create(mus_context *context, const mus_cloth *cloth, mus__program *program);
void mus__program_sell(mus__program *program);
void mus__program_sell_clear(mus_context *context, mus__program *program);

#endif
