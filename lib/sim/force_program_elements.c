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
    program->hinge_capacity = cloth->nhinge + cloth->nseam_hinge;
    program->hinge = mus__new(context, program->hinge_capacity, sizeof *program->hinge);
    program->pair = mus__new(context, cloth->npair, sizeof *program->pair);
    program->attachment = mus__new(context, cloth->nhold, sizeof *program->attachment);
    if (program->hinge == NULL || program->pair == NULL || program->attachment == NULL)
        return mus__fail_memory(context, "the elements of a drape");
    return mus__program_springs_create(context, cloth, program);
}


/* nonzero when the seams of a node's panel are open */
static int32_t is_open(const mus_cloth *cloth, const int32_t *rep, const mus__program *program, int32_t node)
{
    return rep == NULL || (program->open_from > 0 && mus__cloth_layer(cloth, node) >= program->open_from);
}


/* append the hinges within panels, or those across closed seams, with their nodes replaced by rep. A hinge that welding
 * folded onto itself (two of its nodes are one) is left out */
static void add_hinges(mus__program *program, const mus_cloth *cloth, int32_t across, const int32_t *rep)
{
    const mus__hinge *hinges = across ? cloth->seam_hinge : cloth->hinge;
    const int32_t n = across ? cloth->nseam_hinge : cloth->nhinge;
    for (int32_t h = 0; h < n; h++) {
        mus__hinge hinge = hinges[h];
        if (across && is_open(cloth, rep, program, hinge.node[0])) continue;
        if (rep != NULL) {
            int32_t *i = hinge.node;
            for (int32_t k = 0; k < 4; k++) i[k] = rep[i[k]];
            if (i[0] == i[1] || i[2] == i[3] || i[0] == i[2] || i[0] == i[3] || i[1] == i[2] || i[1] == i[3]) continue;
        }
        program->hinge[program->nhinge++] = hinge;
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


/* nonzero when either node is of a layer that waits */
static int32_t waits(const mus_cloth *cloth, const mus__program *program, int32_t a, int32_t b)
{
    return program->wait_from > 0 &&
           (mus__cloth_layer(cloth, a) >= program->wait_from || mus__cloth_layer(cloth, b) >= program->wait_from);
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
        if (spring.kind == MUS__SPRING_ELASTIC && cloth->npair > 0 && is_open(cloth, rep, program, spring.a))
            spring.k *= OPEN_ELASTIC_SHARE;
        program->spring_dashpot[program->nspring] =
            cloth->dashpot != NULL ? cloth->dashpot[s] : fabric_dashpot(cloth, a, b, spring.k);
        program->spring[program->nspring++] = spring;
    }
    for (int32_t t = 0; t < program->ntack; t++) {
        const mus__tack *tack = &program->tack[t];
        if (tack->a == MUS_NONE || !(tack->k > 0.0) || waits(cloth, program, tack->a, tack->b)) continue;
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
    add_hinges(program, cloth, 0, rep);
    add_hinges(program, cloth, 1, rep);

    /* pairs of seams that are open and do not wait */
    for (int32_t p = 0; p < cloth->npair; p++) {
        const int32_t a = cloth->pair[2 * p], b = cloth->pair[2 * p + 1];
        if ((!is_open(cloth, rep, program, a) && !is_open(cloth, rep, program, b)) || waits(cloth, program, a, b))
            continue;
        program->pair[program->npair++] = (mus__seam_pair){
            .a = a, .b = b, .seam = cloth->pair_seam[p], .length = cloth->pair_length[p], .pull_share = 1.0};
    }
    mus__sliders_fill(cloth, program);
    count_springs(cloth, program);
}
