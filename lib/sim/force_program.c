/*
 * force_program.c: builds the force program of a cloth: its lattice runs as half springs and half bends, sorted by row.
 *
 * A half spring acts on one end only, so each spring is computed twice. That costs twice the arithmetic of a form that
 * writes to both ends, but every store is to a consecutive address, and threads need no colouring.
 */
#include <math.h>
#include <string.h>

#include "sim/bend_slider.h"
#include "sim/contraction.h"
#include "sim/force_program_parts.h"

#define TACKS_FIRST 16      /* room for tacks that the first one makes; chosen: a button band needs no second block */
#define TACKS_MAX (1 << 24) /* tacks of a drape; keeps counts of half springs within 32 bits */


/* row that holds a lattice node, by bisection */
static int32_t row_of(const mus__program *program, int32_t node)
{
    int32_t low = 0, high = program->nrow - 1;
    while (low < high) {
        const int32_t middle = (low + high + 1) / 2;
        if (program->row[middle].first <= node)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}


/* the part of a run whose owners lie in one row: nodes owner+offset .. owner+offset+count-1 */
typedef struct row_part {
    int32_t row, offset, count;
} row_part;


/* the next part of a run of `count` owners of which `done` have been visited; 0 when there is none left */
static int32_t row_part_next(const mus__program *program, int32_t owner, int32_t count, int32_t done, row_part *out)
{
    if (done >= count) return 0;
    out->row = row_of(program, owner + done);
    out->offset = done;
    const int32_t room = program->row[out->row].first + program->row[out->row].count - (owner + done);
    out->count = count - done < room ? count - done : room;
    return 1;
}


/* counts the half runs and half bends of each row (write 0), or writes them at the cursors of the rows (write 1) */
static void spread_runs(const mus_cloth *cloth, mus__program *program, int32_t write)
{
    for (int32_t r = 0; r < cloth->nrun; r++) {
        const mus__spring_run *run = &cloth->run[r];
        const double mass = cloth->mass[run->a];
        const double dashpot = 2.0 * cloth->fabric.damping * sqrt(0.5 * run->k * mass);
        for (int32_t side = 0; side < 2; side++) {
            const int32_t owner = side ? run->b : run->a, other = side ? run->a : run->b;
            row_part part;
            for (int32_t done = 0; row_part_next(program, owner, run->count, done, &part); done += part.count) {
                mus__program_row *row = &program->row[part.row];
                if (write)
                    program->half_run[row->run + row->nrun] = (mus__half_run){
                        owner + part.offset, other + part.offset, part.count, run->k, run->rest, dashpot};
                row->nrun++;
            }
        }
    }
    for (int32_t r = 0; r < cloth->nbend; r++) {
        const mus__bend_run *bend = &cloth->bend[r];
        const int32_t owners[3] = {bend->a, bend->b, bend->c};
        for (int32_t side = 0; side < 3; side++) {
            row_part part;
            for (int32_t done = 0; row_part_next(program, owners[side], bend->count, done, &part); done += part.count) {
                mus__program_row *row = &program->row[part.row];
                const int32_t at = part.offset;
                if (write)
                    program->half_bend[row->bend + row->nbend] =
                        (mus__half_bend){.o = owners[side] + at,
                                         .a = bend->a + at,
                                         .b = bend->b + at,
                                         .c = bend->c + at,
                                         .count = part.count,
                                         .w = side == 1 ? 2.0 * bend->k : -bend->k};
                row->nbend++;
            }
        }
    }
}


static mus_status build_rows(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    program->nrow = cloth->nrow;
    program->row = mus__new(context, cloth->nrow, sizeof *program->row);
    program->packet_of = mus__new(context, cloth->nnode, sizeof *program->packet_of);
    if (program->row == NULL || program->packet_of == NULL) return mus__fail_memory(context, "the rows of a drape");
    memset(program->packet_of, 0xff, (size_t)cloth->nnode * sizeof *program->packet_of); /* MUS_NONE, which is -1 */
    for (int32_t r = 0; r < cloth->nrow; r++) {
        program->row[r].first = cloth->row[r].first;
        program->row[r].count = cloth->row[r].count;
        memset(program->packet_of + program->row[r].first, 0,
               (size_t)program->row[r].count * sizeof *program->packet_of);
    }
    spread_runs(cloth, program, 0);

    for (int32_t r = 0; r < program->nrow; r++) {
        mus__program_row *row = &program->row[r];
        row->run = program->nhalf_run;
        row->bend = program->nhalf_bend;
        program->nhalf_run += row->nrun;
        program->nhalf_bend += row->nbend;
        row->nrun = row->nbend = 0;
    }
    program->half_run = mus__new(context, program->nhalf_run, sizeof *program->half_run);
    program->half_bend = mus__new(context, program->nhalf_bend, sizeof *program->half_bend);
    if (program->half_run == NULL || program->half_bend == NULL)
        return mus__fail_memory(context, "the runs of a drape");
    spread_runs(cloth, program, 1);
    return MUS_OK;
}


void mus__program_tacks_changed(const mus_cloth *cloth, const int32_t *rep, mus__program *program)
{
    mus__program_springs(cloth, rep, program);
    mus__program_irregular(cloth, program);
}


void mus__program_weld(const mus_cloth *cloth, const int32_t *rep, mus__program *program)
{
    mus__program_elements(cloth, rep, program);
    mus__program_irregular(cloth, program);
}


/* frees the arrays whose capacity depends on the number of springs */
static void tack_room_free(mus_context *context, mus__program *program)
{
    void *blocks[] = {program->tack, program->spring, program->spring_dashpot, program->half_other,
                      program->half_constant};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
    mus__program_sell_clear(context, program);
}


mus_status mus__program_tack_room(mus_context *context, const mus_cloth *cloth, int32_t need, mus__program *program)
{
    if (need <= program->tack_capacity) return MUS_OK;
    if (need > TACKS_MAX)
        return mus__fail(context, MUS_ERR_LIMIT, "drape: %d tacks, at most %d", (int)need, (int)TACKS_MAX);
    mus__program grown = *program;
    grown.tack_capacity = program->tack_capacity > 0 ? program->tack_capacity : TACKS_FIRST;
    while (grown.tack_capacity < need) grown.tack_capacity *= 2;
    grown.spring = NULL, grown.spring_dashpot = NULL;
    grown.half_other = NULL, grown.half_constant = NULL;
    memset(&grown.sell, 0, sizeof grown.sell);
    grown.tack = mus__new(context, grown.tack_capacity, sizeof *grown.tack);
    mus_status status = grown.tack != NULL ? MUS_OK : mus__fail_memory(context, "tacks");
    if (status == MUS_OK) status = mus__program_springs_create(context, cloth, &grown);
    if (status == MUS_OK) status = mus__program_half_springs_create(context, &grown);
    if (status == MUS_OK) status = mus__program_sell_create(context, cloth, &grown);
    if (status != MUS_OK) {
        tack_room_free(context, &grown);
        return status;
    }
    if (program->ntack > 0) memcpy(grown.tack, program->tack, (size_t)program->ntack * sizeof *program->tack);
    tack_room_free(context, program);
    *program = grown;
    return MUS_OK;
}


mus_status mus__program_build(mus_context *context, const mus_cloth *cloth, size_t real, mus__program *program)
{
    memset(program, 0, sizeof *program);
    program->real = real;
    program->dashpots = cloth->fabric.damping > 0.0;
    for (int32_t s = 0; cloth->dashpot != NULL && s < cloth->nspring; s++)
        if (cloth->dashpot[s] > 0.0) program->dashpots = 1;
    mus_status status = build_rows(context, cloth, program);
    if (status == MUS_OK) status = mus__program_elements_create(context, cloth, program);
    if (status == MUS_OK) status = mus__program_irregular_create(context, cloth, program);
    if (status == MUS_OK) status = mus__sliders_create(context, cloth, program);
    if (status != MUS_OK) return status;
    mus__program_elements(cloth, NULL, program);
    mus__program_irregular_lattice(cloth, program);
    status = mus__program_stencil(context, cloth, program);
    if (status == MUS_OK) status = mus__contraction_create(context, cloth, program);
    if (status == MUS_OK) status = mus__program_sell_create(context, cloth, program);
    return status;
}


void mus__program_clear(mus_context *context, mus__program *program)
{
    void *blocks[] = {program->row,          program->half_run,       program->half_bend,
                      program->spring,       program->spring_dashpot, program->hinge,
                      program->pair,         program->packet,         program->shape,
                      program->table,        program->chunk,          program->irregular_node,
                      program->half_start,   program->half_other,     program->half_constant,
                      program->linear_start, program->linear_other,   program->linear_weight,
                      program->pair_end,     program->packet_of,      program->attachment,
                      program->tack,         program->slider,         program->clamp,
                      program->cell};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
    mus__program_sell_clear(context, program);
    memset(program, 0, sizeof *program);
}
