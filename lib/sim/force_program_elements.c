/*
 * force_program_elements.c: springs, hinges, seam pairs, attachments and tacks of a force program, with the seams open
 * or welded.
 */
#include <math.h>
#include <stdlib.h>

#include "base/sort.h"
#include "sim/bend_slider.h"
#include "sim/force_program_parts.h"

/* [N/m2] stiffness of an attachment per metre of edge; chosen so that a garment of 1 kg on 1 m of waistband sinks 0.5
 * mm */
#define ATTACH_STIFFNESS 2e4
/* [N/m] largest force of an attachment per metre of edge: the weight of 10 kg, more than any garment pulls with */
#define ATTACH_FORCE_MAX 100.0
/* factor on the stiffness of an elastic while its seams are open; chosen so that the seams that it ends in can close */
#define OPEN_ELASTIC_SHARE 0.05


mus_status mus__program_springs_create(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    program->spring_capacity = cloth->nspring + program->tack_capacity;
    program->spring = mus__new(context, program->spring_capacity, sizeof *program->spring);
    program->spring_dashpot = mus__new(context, program->spring_capacity, sizeof *program->spring_dashpot);
    if (program->spring == NULL || program->spring_dashpot == NULL)
        return mus__fail_memory(context, "the elements of a drape");
    return MUS_OK;
}


mus_status mus__program_elements_create(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    program->hinge_capacity = cloth->nhinge + 3 * cloth->nseam_hinge; /* three while a seam is open */
    program->hinge = mus__new(context, program->hinge_capacity, sizeof *program->hinge);
    program->pair = mus__new(context, cloth->npair, sizeof *program->pair);
    program->attachment = mus__new(context, cloth->nhold, sizeof *program->attachment);
    if (program->hinge == NULL || program->pair == NULL || program->attachment == NULL)
        return mus__fail_memory(context, "the elements of a drape");
    return mus__program_springs_create(context, cloth, program);
}


/* the upper one of the layers of two nodes */
static int32_t upper_layer(const mus_cloth *cloth, int32_t a, int32_t b)
{
    const int32_t p = mus__cloth_layer(cloth, a), q = mus__cloth_layer(cloth, b);
    return p > q ? p : q;
}


/* nonzero when the seams of a layer are open */
static int32_t is_open(const mus__program *program, const int32_t *rep, int32_t layer)
{
    return rep == NULL || (program->open_from > 0 && layer >= program->open_from);
}


/* nonzero when a layer waits */
static int32_t waits(const mus__program *program, int32_t layer)
{
    return program->wait_from > 0 && layer >= program->wait_from;
}


/* append a hinge with its nodes replaced by rep. One that welding folded onto itself (two of its nodes are one) is left
 * out; of a bend, whose middle is two of its nodes, welding touches none */
static void append_hinge(mus__program *program, const mus__hinge *hinge, const int32_t *rep)
{
    mus__hinge own = *hinge;
    if (own.k == 0.0) return;
    if (rep != NULL && own.node[0] != own.node[1]) {
        int32_t *i = own.node;
        for (int32_t k = 0; k < 4; k++) i[k] = rep[i[k]];
        if (i[0] == i[1] || i[2] == i[3] || i[0] == i[2] || i[0] == i[3] || i[1] == i[2] || i[1] == i[3]) return;
    }
    program->hinge[program->nhinge++] = own;
}


/* append the hinges across seams; across one that is open those that turn its sides, unless a layer of it waits */
static void add_seam_hinges(mus__program *program, const mus_cloth *cloth, const int32_t *rep)
{
    for (int32_t h = 0; h < cloth->nseam_hinge; h++) {
        const mus__hinge *turn = cloth->seam_turn + 3 * (ptrdiff_t)h;
        const int32_t layer = upper_layer(cloth, turn->node[0], turn->node[1]);
        if (!is_open(program, rep, layer)) append_hinge(program, &cloth->seam_hinge[h], rep);
        for (int32_t i = 0; i < 3 && is_open(program, rep, layer) && !waits(program, layer); i++)
            append_hinge(program, &turn[i], rep);
    }
}


static int attachment_by_node(const void *a, const void *b)
{
    const mus__attachment *p = a, *q = b;
    if (p->node != q->node) return p->node < q->node ? -1 : 1;
    if (p->level != q->level) return p->level < q->level ? -1 : 1;
    return p->below < q->below ? -1 : p->below > q->below;
}


/* the attachments whose level the body has, nodes replaced by rep, ascending by node */
static void fill_attachments(const mus_cloth *cloth, const int32_t *rep, mus__program *program)
{
    program->nattachment = 0;
    for (int32_t i = 0; i < cloth->nhold; i++) {
        const mus__hold *hold = &cloth->hold[i];
        if (!program->level[hold->level][hold->right].there) continue;
        program->attachment[program->nattachment++] = (mus__attachment){rep != NULL ? rep[hold->node] : hold->node,
                                                                        hold->level,
                                                                        hold->right,
                                                                        hold->below,
                                                                        ATTACH_STIFFNESS * hold->length,
                                                                        ATTACH_FORCE_MAX * hold->length,
                                                                        1.0};
    }
    mus__sort(program->attachment, (size_t)program->nattachment, sizeof *program->attachment, attachment_by_node);
}


/* dashpot constant [N s/m] of a spring of stiffness k between two nodes: the damping ratio of the fabric at the
 * frequency of the spring and the mean of the two masses */
static double fabric_dashpot(const mus_cloth *cloth, int32_t a, int32_t b, double k)
{
    const double mass = 0.5 * (cloth->mass[a] + cloth->mass[b]);
    return 2.0 * cloth->fabric.damping * sqrt(0.5 * k * mass);
}


/* springs with their nodes replaced by rep: those of the cloth first, then tacks, so that sums without tacks keep their
 * order */
static void fill_springs(const mus_cloth *cloth, const int32_t *rep, mus__program *program)
{
    program->nspring = 0;
    for (int32_t s = 0; s < cloth->nspring; s++) {
        mus__spring spring = cloth->spring[s];
        const int32_t a = spring.a, b = spring.b;
        if (rep != NULL) spring.a = rep[spring.a], spring.b = rep[spring.b];
        if (spring.a == spring.b) continue;
        if (spring.kind == MUS__SPRING_ELASTIC && cloth->npair > 0 &&
            is_open(program, rep, mus__cloth_layer(cloth, spring.a)))
            spring.k *= OPEN_ELASTIC_SHARE;
        program->spring_dashpot[program->nspring] =
            cloth->dashpot != NULL ? cloth->dashpot[s] : fabric_dashpot(cloth, a, b, spring.k);
        program->spring[program->nspring++] = spring;
    }
    for (int32_t t = 0; t < program->ntack; t++) {
        const mus__tack *tack = &program->tack[t];
        if (tack->a == MUS_NONE || !(tack->k > 0.0) || waits(program, upper_layer(cloth, tack->a, tack->b))) continue;
        const mus__spring spring = {rep != NULL ? rep[tack->a] : tack->a, rep != NULL ? rep[tack->b] : tack->b,
                                    MUS__SPRING_TACK, tack->k, 0.0};
        if (spring.a == spring.b) continue;
        program->spring_dashpot[program->nspring] =
            cloth->dashpot != NULL ? 0.0 : fabric_dashpot(cloth, tack->a, tack->b, tack->k);
        program->spring[program->nspring++] = spring;
    }
}


/* counts each spring once; a half run stands for it twice, a half bend three times */
static void count_springs(const mus_cloth *cloth, mus__program *program)
{
    program->spring_evaluations = program->nspring + program->nhinge + program->npair;
    for (int32_t r = 0; r < cloth->nrun; r++) program->spring_evaluations += cloth->run[r].count;
    for (int32_t r = 0; r < cloth->nbend; r++) program->spring_evaluations += cloth->bend[r].count;
}


void mus__program_springs(const mus_cloth *cloth, const int32_t *rep, mus__program *program)
{
    fill_springs(cloth, rep, program);
    count_springs(cloth, program);
}


void mus__program_elements(const mus_cloth *cloth, const int32_t *rep, mus__program *program)
{
    program->nhinge = program->npair = 0;
    fill_springs(cloth, rep, program);
    fill_attachments(cloth, rep, program);
    for (int32_t h = 0; h < cloth->nhinge; h++) append_hinge(program, &cloth->hinge[h], rep);
    add_seam_hinges(program, cloth, rep);

    /* pairs of seams that are open and do not wait */
    for (int32_t p = 0; p < cloth->npair; p++) {
        const int32_t a = cloth->pair[2 * p], b = cloth->pair[2 * p + 1];
        const int32_t layer = upper_layer(cloth, a, b);
        if (!is_open(program, rep, layer) || waits(program, layer)) continue;
        program->pair[program->npair++] = (mus__seam_pair){
            .a = a, .b = b, .seam = cloth->pair_seam[p], .length = cloth->pair_length[p], .pull_share = 1.0};
    }
    mus__sliders_fill(cloth, program);
    count_springs(cloth, program);
}
