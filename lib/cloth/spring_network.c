/*
 * spring_network.c: a cloth of bare nodes, springs, bends and pins, all the caller's own.
 *
 * `muslin verify` builds chains, pendulums and rods of it. No element is in a run: springs have a dashpot each; a bend
 * is a hinge with its middle node at both ends of the edge, coefficient -1 each, which is the same sum a - 2 b + c and
 * the same bound on stiffness.
 */
#include "cloth/cloth_internal.h"

/* counts at most: the force program counts elements in 32 bits */
#define BARE_MOST_SPRINGS (1 << 28)
#define BARE_MOST_BENDS (1 << 26)
/* [kg] least mass; [kg], [N/m], [N s/m] largest mass and stiffness: 1 / mass and k / mass stay normal floats */
#define BARE_LEAST_MASS 1e-15
#define BARE_MOST 1e15


void mus_bare_init(mus_bare *bare, size_t size)
{
    mus_bare own = {0};
    mus__def_init(bare, size, &own, sizeof own);
}


/* one count against its limit, and its arrays */
static mus_status bare_count(mus_context *context, const char *name, int32_t count, int32_t most, bool arrays)
{
    if (count < 0) return mus__fail(context, MUS_ERR_ARG, "bare: %s is %d, expected 0 or more", name, (int)count);
    if (count > most)
        return mus__fail(context, MUS_ERR_LIMIT, "bare: %d %s are more than %d", (int)count, name, (int)most);
    if (count > 0 && !arrays) return mus__fail(context, MUS_ERR_ARG, "bare: an array of %s is NULL", name);
    return MUS_OK;
}


/* n numbers (NULL: none) in low .. high */
static mus_status bare_numbers(mus_context *context, const char *name, const double *value, int64_t n, double low,
                               double high)
{
    for (int64_t i = 0; value != NULL && i < n; i++)
        if (!(value[i] >= low && value[i] <= high))
            return mus__fail(context, MUS_ERR_ARG, "bare: %s[%lld] is %g, expected %g to %g", name, (long long)i,
                             value[i], low, high);
    return MUS_OK;
}


/* n elements of `width` nodes each, all within the cloth and within an element all different */
static mus_status bare_nodes(mus_context *context, const char *name, const int32_t *node, int32_t n, int32_t width,
                             int32_t nodes)
{
    for (int64_t i = 0; i < (int64_t)n * width; i++) {
        if (node[i] < 0 || node[i] >= nodes)
            return mus__fail(context, MUS_ERR_ARG, "bare: %s %lld names node %d, expected 0 to %d", name,
                             (long long)(i / width), (int)node[i], (int)nodes - 1);
        for (int64_t j = i - i % width; j < i; j++)
            if (node[j] == node[i])
                return mus__fail(context, MUS_ERR_ARG, "bare: %s %lld names node %d twice", name,
                                 (long long)(i / width), (int)node[i]);
    }
    return MUS_OK;
}


static mus_status bare_check(mus_context *context, const mus_bare *bare)
{
    mus_status status = bare_count(context, "nodes", bare->nodes, MUS__CLOTH_NODES_LIMIT, bare->place && bare->mass);
    if (status == MUS_OK)
        status = bare_count(context, "springs", bare->springs, BARE_MOST_SPRINGS,
                            bare->spring && bare->length && bare->stiffness);
    if (status == MUS_OK)
        status = bare_count(context, "bends", bare->bends, BARE_MOST_BENDS, bare->bend && bare->bend_stiffness);
    if (status == MUS_OK) status = bare_count(context, "pins", bare->pins, MUS__CLOTH_NODES_LIMIT, bare->pin != NULL);
    if (status == MUS_OK) status = bare_nodes(context, "spring", bare->spring, bare->springs, 2, bare->nodes);
    if (status == MUS_OK) status = bare_nodes(context, "bend", bare->bend, bare->bends, 3, bare->nodes);
    if (status == MUS_OK) status = bare_nodes(context, "pin", bare->pin, bare->pins, 1, bare->nodes);
    if (status == MUS_OK)
        status = bare_numbers(context, "place", bare->place, 3 * (int64_t)bare->nodes, -MUS__FARTHEST, MUS__FARTHEST);
    if (status == MUS_OK) status = bare_numbers(context, "mass", bare->mass, bare->nodes, 0.0, BARE_MOST);
    if (status == MUS_OK) status = bare_numbers(context, "length", bare->length, bare->springs, 0.0, MUS__FARTHEST);
    if (status == MUS_OK) status = bare_numbers(context, "stiffness", bare->stiffness, bare->springs, 0.0, BARE_MOST);
    if (status == MUS_OK) status = bare_numbers(context, "dashpot", bare->dashpot, bare->springs, 0.0, BARE_MOST);
    if (status == MUS_OK)
        status = bare_numbers(context, "bend_stiffness", bare->bend_stiffness, bare->bends, 0.0, BARE_MOST);
    return status;
}


/* a node that can move must have a mass; `pinned` (nodes) is scratch */
static mus_status bare_masses(mus_context *context, const mus_bare *bare, unsigned char *pinned)
{
    for (int32_t i = 0; i < bare->pins; i++) pinned[bare->pin[i]] = 1;
    for (int32_t i = 0; i < bare->nodes; i++)
        if (!(bare->mass[i] >= BARE_LEAST_MASS) && !(pinned[i] && bare->mass[i] == 0.0))
            return mus__fail(context, MUS_ERR_ARG, "bare: mass[%d] is %g kg, expected %g to %g (or 0 at a pin)", (int)i,
                             bare->mass[i], BARE_LEAST_MASS, BARE_MOST);
    return MUS_OK;
}


static bool bare_take(mus_cloth *cloth, const mus_bare *bare)
{
    mus_context *context = cloth->context;
    cloth->nnode = bare->nodes;
    cloth->nspring = bare->springs;
    cloth->nhinge = bare->bends;
    cloth->npin = bare->pins;
    cloth->rest = mus__new(context, 2 * (int64_t)bare->nodes, sizeof *cloth->rest);
    cloth->place = mus__new(context, 3 * (int64_t)bare->nodes, sizeof *cloth->place);
    cloth->mass = mus__new(context, bare->nodes, sizeof *cloth->mass);
    cloth->node_panel = mus__new(context, bare->nodes, sizeof *cloth->node_panel);
    cloth->spring = mus__new(context, bare->springs, sizeof *cloth->spring);
    cloth->dashpot = mus__new(context, bare->springs, sizeof *cloth->dashpot);
    cloth->hinge = mus__new(context, bare->bends, sizeof *cloth->hinge);
    cloth->pin = mus__new(context, bare->pins, sizeof *cloth->pin);
    return cloth->rest != NULL && cloth->place != NULL && cloth->mass != NULL && cloth->node_panel != NULL &&
           cloth->spring != NULL && cloth->dashpot != NULL && cloth->hinge != NULL && cloth->pin != NULL;
}


static void bare_fill(mus_cloth *cloth, const mus_bare *bare)
{
    for (int64_t i = 0; i < bare->nodes; i++) {
        for (int k = 0; k < 3; k++) cloth->place[3 * i + k] = bare->place[3 * i + k];
        cloth->rest[2 * i] = bare->place[3 * i], cloth->rest[2 * i + 1] = bare->place[3 * i + 1];
        cloth->mass[i] = bare->mass[i];
        cloth->mass_total += bare->mass[i];
        cloth->node_panel[i] = MUS_NONE;
    }
    for (int64_t s = 0; s < bare->springs; s++) {
        cloth->spring[s] = (mus__spring){bare->spring[2 * s], bare->spring[2 * s + 1], MUS__SPRING_BORDER,
                                         bare->stiffness[s], bare->length[s]};
        cloth->dashpot[s] = bare->dashpot != NULL ? bare->dashpot[s] : 0.0;
    }
    for (int64_t b = 0; b < bare->bends; b++) {
        const int32_t *i = bare->bend + 3 * b;
        cloth->hinge[b] = (mus__hinge){
            .node = {i[1], i[1], i[0], i[2]}, .coef = {-1.0, -1.0, 1.0, 1.0}, .k = bare->bend_stiffness[b]};
    }
    for (int32_t i = 0; i < bare->pins; i++) cloth->pin[i] = bare->pin[i];
}


mus_status mus_cloth_create_bare(mus_context *context, const mus_bare *bare, mus_cloth **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (bare == NULL || out == NULL)
        return mus__fail(context, MUS_ERR_ARG, "cloth: %s is NULL", bare == NULL ? "bare" : "out");
    mus_bare own;
    mus_bare_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, sizeof own, bare, "mus_bare");
    if (status == MUS_OK) status = bare_check(context, &own);
    if (status != MUS_OK) return status;

    unsigned char *pinned = mus__new(context, own.nodes, 1);
    if (pinned == NULL) return mus__fail_memory(context, "bare nodes");
    status = bare_masses(context, &own, pinned);
    mus__free(context, pinned);
    if (status != MUS_OK) return status;

    mus_cloth *cloth = mus__cloth_new(context);
    if (cloth == NULL || !bare_take(cloth, &own)) {
        mus_cloth_destroy(cloth);
        return mus__fail_memory(context, "bare nodes");
    }
    cloth->fabric.size = sizeof cloth->fabric;
    bare_fill(cloth, &own);
    *out = cloth;
    return MUS_OK;
}
