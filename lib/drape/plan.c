/*
 * plan.c: from the runs of a cloth to half springs and half bends, sorted by row; springs, hinges and pairs with the
 * seams open or welded.
 *
 * Half springs cost twice the arithmetic of a form that writes to both ends and save every scatter: threads need no
 * colouring.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drape/plan.h"

/* [N/m2] a garment of a kilogram on a metre of waistband sinks half a millimetre; [N/m] what an edge that starts below
 * its level is lifted with: ten kilograms on a metre, so that no garment drags it down */
#define HELD_STIFF 2e4
#define HELD_MOST 100.0
#define OPEN_ELASTIC 0.05 /* of what an elastic draws with while seams are open: those that it ends in must close */


/* row that holds a lattice node, by bisection */
static int32_t row_of(const mus__plan *plan, int32_t node)
{
    int32_t low = 0, high = plan->nrow - 1;
    while (low < high) {
        const int32_t middle = (low + high + 1) / 2;
        if (plan->row[middle].first <= node) low = middle;
        else high = middle - 1;
    }
    return low;
}


/*
 * Visit the parts of owners o .. o+count-1 that lie in one row each. `emit` counts them (plan arrays NULL) or writes.
 */
typedef struct cut {
    int32_t row, offset, count;
} cut;


static int32_t cut_next(const mus__plan *plan, int32_t owner, int32_t count, int32_t done, cut *out)
{
    if (done >= count) return 0;
    out->row = row_of(plan, owner + done);
    out->offset = done;
    const int32_t room = plan->row[out->row].first + plan->row[out->row].count - (owner + done);
    out->count = count - done < room ? count - done : room;
    return 1;
}


/* counts the half runs and half bends of each row (pass 0), or writes them behind the rows' cursors (pass 1) */
static void spread_runs(const mus_cloth *cloth, mus__plan *plan, int32_t write)
{
    for (int32_t r = 0; r < cloth->nrun; r++) {
        const mus__spring_run *run = &cloth->run[r];
        const double mass = cloth->mass[run->a];
        const double dashpot = 2.0 * cloth->fabric.damping * sqrt(0.5 * run->k * mass);
        for (int32_t side = 0; side < 2; side++) {
            const int32_t owner = side ? run->b : run->a, other = side ? run->a : run->b;
            cut part;
            for (int32_t done = 0; cut_next(plan, owner, run->count, done, &part); done += part.count) {
                mus__plan_row *row = &plan->row[part.row];
                if (write)
                    plan->half_run[row->run + row->nrun] = (mus__half_run){
                        owner + part.offset, other + part.offset, part.count, run->k, run->rest, dashpot};
                row->nrun++;
            }
        }
    }
    for (int32_t r = 0; r < cloth->nbend; r++) {
        const mus__bend_run *bend = &cloth->bend[r];
        const int32_t owners[3] = {bend->a, bend->b, bend->c};
        for (int32_t side = 0; side < 3; side++) {
            cut part;
            for (int32_t done = 0; cut_next(plan, owners[side], bend->count, done, &part); done += part.count) {
                mus__plan_row *row = &plan->row[part.row];
                const int32_t at = part.offset;
                if (write)
                    plan->half_bend[row->bend + row->nbend] =
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


static mus_status build_rows(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    plan->nrow = cloth->nrow;
    plan->row = mus__new(context, cloth->nrow, sizeof *plan->row);
    plan->lattice = mus__new(context, cloth->nnode, sizeof *plan->lattice);
    if (plan->row == NULL || plan->lattice == NULL) return mus__fail_memory(context, "the rows of a drape");
    for (int32_t r = 0; r < cloth->nrow; r++) {
        plan->row[r].first = cloth->row[r].first;
        plan->row[r].count = cloth->row[r].count;
        memset(plan->lattice + plan->row[r].first, 1, (size_t)plan->row[r].count);
    }
    spread_runs(cloth, plan, 0);

    for (int32_t r = 0; r < plan->nrow; r++) {
        mus__plan_row *row = &plan->row[r];
        row->run = plan->nhalf_run;
        row->bend = plan->nhalf_bend;
        plan->nhalf_run += row->nrun;
        plan->nhalf_bend += row->nbend;
        row->nrun = row->nbend = 0;
    }
    plan->half_run = mus__new(context, plan->nhalf_run, sizeof *plan->half_run);
    plan->half_bend = mus__new(context, plan->nhalf_bend, sizeof *plan->half_bend);
    if (plan->half_run == NULL || plan->half_bend == NULL) return mus__fail_memory(context, "the runs of a drape");
    spread_runs(cloth, plan, 1);
    return MUS_OK;
}


/* ---- springs, hinges and pairs ---- */

mus_status mus__plan_springs_new(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    plan->spring_capacity = cloth->nspring + plan->tack_capacity;
    plan->spring = mus__new(context, plan->spring_capacity, sizeof *plan->spring);
    plan->spring_dashpot = mus__new(context, plan->spring_capacity, sizeof *plan->spring_dashpot);
    if (plan->spring == NULL || plan->spring_dashpot == NULL)
        return mus__fail_memory(context, "the elements of a drape");
    return MUS_OK;
}


static mus_status build_elements(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    plan->hinge_capacity = cloth->nhinge + cloth->nseam_hinge;
    plan->hinge = mus__new(context, plan->hinge_capacity, sizeof *plan->hinge);
    plan->pair = mus__new(context, cloth->npair, sizeof *plan->pair);
    plan->held = mus__new(context, cloth->nhold, sizeof *plan->held);
    if (plan->hinge == NULL || plan->pair == NULL || plan->held == NULL)
        return mus__fail_memory(context, "the elements of a drape");
    return mus__plan_springs_new(context, cloth, plan);
}


/* append hinges with their nodes renamed; a hinge that welding folded onto itself (two nodes the same) is left out */
/* nonzero when the seams of a node's panel are open */
static int32_t is_open(const mus_cloth *cloth, const int32_t *rep, const mus__plan *plan, int32_t node)
{
    return rep == NULL || (plan->open_from > 0 && mus__cloth_layer(cloth, node) >= plan->open_from);
}


/* hinges within panels, or those across seams that are closed */
static void add_hinges(mus__plan *plan, const mus_cloth *cloth, int32_t across, const int32_t *rep)
{
    const mus__hinge *hinges = across ? cloth->seam_hinge : cloth->hinge;
    const int32_t n = across ? cloth->nseam_hinge : cloth->nhinge;
    for (int32_t h = 0; h < n; h++) {
        mus__hinge hinge = hinges[h];
        if (across && is_open(cloth, rep, plan, hinge.node[0])) continue;
        if (rep != NULL) {
            int32_t *i = hinge.node;
            for (int32_t k = 0; k < 4; k++) i[k] = rep[i[k]];
            if (i[0] == i[1] || i[2] == i[3] || i[0] == i[2] || i[0] == i[3] || i[1] == i[2] || i[1] == i[3]) continue;
        }
        plan->hinge[plan->nhinge++] = hinge;
    }
}


static int held_by_node(const void *a, const void *b)
{
    const mus__held *p = a, *q = b;
    if (p->node != q->node) return p->node < q->node ? -1 : 1;
    if (p->level != q->level) return p->level < q->level ? -1 : 1;
    return p->below < q->below ? -1 : p->below > q->below;
}


/* held nodes whose level the body has, renamed and in order */
static void fill_held(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan)
{
    plan->nheld = 0;
    for (int32_t i = 0; i < cloth->nhold; i++) {
        const mus__hold *hold = &cloth->hold[i];
        if (!plan->level[hold->level][hold->right].there) continue;
        plan->held[plan->nheld++] =
            (mus__held){rep != NULL ? rep[hold->node] : hold->node, hold->level, hold->right, hold->below,
                        HELD_STIFF * hold->length, HELD_MOST * hold->length, 1.0};
    }
    qsort(plan->held, (size_t)plan->nheld, sizeof *plan->held, held_by_node);
}


/* nonzero when any of two nodes is of a layer that waits */
static int32_t waits(const mus_cloth *cloth, const mus__plan *plan, int32_t a, int32_t b)
{
    return plan->wait_from > 0 &&
           (mus__cloth_layer(cloth, a) >= plan->wait_from || mus__cloth_layer(cloth, b) >= plan->wait_from);
}


/* [N s/m] of a spring of k between nodes of the cloth: the fabric's ratio at its own frequency */
static double fabric_dashpot(const mus_cloth *cloth, int32_t a, int32_t b, double k)
{
    const double mass = 0.5 * (cloth->mass[a] + cloth->mass[b]);
    return 2.0 * cloth->fabric.damping * sqrt(0.5 * k * mass);
}


/* springs with their nodes renamed: those of the cloth, then tacks, so that what tacks do not touch keeps its order */
static void fill_springs(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan)
{
    plan->nspring = 0;
    for (int32_t s = 0; s < cloth->nspring; s++) {
        mus__spring spring = cloth->spring[s];
        const int32_t a = spring.a, b = spring.b;
        if (rep != NULL) spring.a = rep[spring.a], spring.b = rep[spring.b];
        if (spring.a == spring.b) continue;
        if (spring.kind == MUS__SPRING_ELASTIC && cloth->npair > 0 && is_open(cloth, rep, plan, spring.a))
            spring.k *= OPEN_ELASTIC;
        plan->spring_dashpot[plan->nspring] =
            cloth->dashpot != NULL ? cloth->dashpot[s] : fabric_dashpot(cloth, a, b, spring.k);
        plan->spring[plan->nspring++] = spring;
    }
    for (int32_t t = 0; t < plan->ntack; t++) {
        const mus__tack *tack = &plan->tack[t];
        if (tack->a == MUS_NONE || !(tack->k > 0.0) || waits(cloth, plan, tack->a, tack->b)) continue;
        const mus__spring spring = {rep != NULL ? rep[tack->a] : tack->a, rep != NULL ? rep[tack->b] : tack->b,
                                    MUS__SPRING_TACK, tack->k, 0.0};
        if (spring.a == spring.b) continue;
        plan->spring_dashpot[plan->nspring] =
            cloth->dashpot != NULL ? 0.0 : fabric_dashpot(cloth, tack->a, tack->b, tack->k);
        plan->spring[plan->nspring++] = spring;
    }
}


/* springs counted once: half runs make two of each, half bends three */
static void count_springs(const mus_cloth *cloth, mus__plan *plan)
{
    plan->spring_evaluations = plan->nspring + plan->nhinge + plan->npair;
    for (int32_t r = 0; r < cloth->nrun; r++) plan->spring_evaluations += cloth->run[r].count;
    for (int32_t r = 0; r < cloth->nbend; r++) plan->spring_evaluations += cloth->bend[r].count;
}


/* springs and hinges with their nodes renamed, and the pairs of open seams */
static void fill_elements(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan)
{
    plan->nhinge = plan->npair = 0;
    fill_springs(cloth, rep, plan);
    fill_held(cloth, rep, plan);
    add_hinges(plan, cloth, 0, rep);
    add_hinges(plan, cloth, 1, rep);

    /* pairs of seams that are open and do not wait */
    for (int32_t p = 0; p < cloth->npair; p++) {
        const int32_t a = cloth->pair[2 * p], b = cloth->pair[2 * p + 1];
        if ((!is_open(cloth, rep, plan, a) && !is_open(cloth, rep, plan, b)) || waits(cloth, plan, a, b)) continue;
        plan->pair[plan->npair++] =
            (mus__pair){.a = a, .b = b, .seam = cloth->pair_seam[p], .length = cloth->pair_length[p], .share = 1.0};
    }
    count_springs(cloth, plan);
}


void mus__plan_tacked(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan)
{
    fill_springs(cloth, rep, plan);
    count_springs(cloth, plan);
    mus__plan_gather(cloth, plan);
}


void mus__plan_weld(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan)
{
    fill_elements(cloth, rep, plan);
    mus__plan_gather(cloth, plan);
}


mus_status mus__plan_build(mus_context *context, const mus_cloth *cloth, size_t real, mus__plan *plan)
{
    memset(plan, 0, sizeof *plan);
    plan->real = real;
    plan->dashpots = cloth->fabric.damping > 0.0;
    for (int32_t s = 0; cloth->dashpot != NULL && s < cloth->nspring; s++)
        if (cloth->dashpot[s] > 0.0) plan->dashpots = 1;
    mus_status status = build_rows(context, cloth, plan);
    if (status == MUS_OK) status = build_elements(context, cloth, plan);
    if (status == MUS_OK) status = mus__plan_gather_new(context, cloth, plan);
    if (status != MUS_OK) return status;
    fill_elements(cloth, NULL, plan);
    mus__plan_gather_lattice(cloth, plan);
    status = mus__plan_blocks(context, cloth, plan);
    if (status == MUS_OK) status = mus__plan_lists_new(context, cloth, plan);
    if (status == MUS_OK) mus__plan_gather(cloth, plan);
    return status;
}


void mus__plan_clear(mus_context *context, mus__plan *plan)
{
    void *blocks[] = {
        plan->row,          plan->half_run,     plan->half_bend,     plan->spring,     plan->spring_dashpot,
        plan->hinge,        plan->pair,         plan->block,         plan->shape,      plan->table,
        plan->chunk,        plan->gather_node,  plan->half_start,    plan->half_other, plan->half_constant,
        plan->linear_start, plan->linear_other, plan->linear_weight, plan->pair_end,   plan->lattice,
        plan->held,         plan->tack};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
    mus__plan_lists_clear(context, plan);
    memset(plan, 0, sizeof *plan);
}
