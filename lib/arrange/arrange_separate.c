/*
 * arrange_separate.c: moves panels apart that begin in the same place, before they are sewn with self-contact.
 *
 * Patterns made for programs that let cloth pass through cloth have panels that lie over each other in one plane:
 * flounces of two legs, a circle skirt and the sleeves beside it. Two sheets in one place have no order, and no contact
 * can find one. Of two such panels, one below the other, the lower one goes down until it is clear; of two beside each
 * other, each goes half of the way. Seams draw them back, and each comes to lie on the other from one side.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "geom/vec.h"

#define SEPARATE_WITHIN                                                                                                \
    0.6 /* spacings: lattice nodes of two panels that are nearer in their plane lie over each other */
#define SEPARATE_FLAT 0.008 /* [m] out of the plane: a panel farther off lies on the other, which is an order */
#define SEPARATE_STEPS 96   /* moves of one spacing at most */
#define SEPARATE_ROUNDS 6   /* over all pairs of panels */
#define SEPARATE_ASKED 256  /* nodes of a panel that are sampled */

typedef struct separate_panel {
    double normal[3], middle[3], low[3], high[3], way[3]; /* way: how far it is moved */
} separate_panel;


/* takes facing, middle and box of each panel */
static void separate_look(const mus__placed_cloth *placed, separate_panel *panel)
{
    for (int32_t p = 0; p < placed->cloth->npanel; p++) {
        const mus__panel_mesh *mesh = &placed->cloth->panel[p];
        separate_panel *own = &panel[p];
        memset(own, 0, sizeof *own);
        mus__placed_facing(placed, p, own->normal);
        mus__unit3(own->normal);
        mus__placed_middle(placed, p, own->middle);
        for (int32_t d = 0; d < 3; d++) own->low[d] = INFINITY, own->high[d] = -INFINITY;
        for (int32_t i = mesh->first_node; i < mesh->first_node + mesh->lattice_count; i++)
            for (int32_t d = 0; d < 3; d++) {
                const double x = placed->x[3 * (int64_t)i + d];
                own->low[d] = fmin(own->low[d], x), own->high[d] = fmax(own->high[d], x);
            }
    }
}


/* whether panels p and q, moved by their ways and by `more` and `less` besides, lie over each other */
static bool separate_meet(const mus__placed_cloth *placed, const separate_panel *panel, int32_t p, int32_t q,
                          const double *more, const double *less)
{
    const mus_cloth *cloth = placed->cloth;
    const mus__panel_mesh *own = &cloth->panel[p], *other = &cloth->panel[q];
    const double within = SEPARATE_WITHIN * cloth->spacing;
    double shift[3];
    for (int32_t d = 0; d < 3; d++) {
        shift[d] = panel[p].way[d] + more[d] - panel[q].way[d] - less[d];
        if (panel[p].low[d] + shift[d] > panel[q].high[d] + within ||
            panel[q].low[d] > panel[p].high[d] + shift[d] + within)
            return false;
    }
    const int32_t every = own->lattice_count / SEPARATE_ASKED + 1;
    for (int32_t i = own->first_node; i < own->first_node + own->lattice_count; i += every) {
        double x[3];
        for (int32_t d = 0; d < 3; d++) x[d] = placed->x[3 * (int64_t)i + d] + shift[d];
        for (int32_t k = other->first_node; k < other->first_node + other->lattice_count; k++) {
            const double *y = placed->x + 3 * (int64_t)k;
            const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]}, far2 = mus__dot3(d, d);
            if (!(far2 < within * within + SEPARATE_FLAT * SEPARATE_FLAT)) continue;
            const double out = mus__dot3(d, panel[p].normal);
            if (fabs(out) < SEPARATE_FLAT && far2 - out * out < within * within) return true;
        }
    }
    return false;
}


/* moves two panels apart that lie over each other; returns whether they did */
static bool separate_two(const mus__placed_cloth *placed, separate_panel *panel, int32_t p, int32_t q)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const double *up = placed->gravity;
    double along[3], gravity[3] = {up[0], up[1], up[2]};
    if (placed->cloth->panel[p].layer != placed->cloth->panel[q].layer) return false;
    if (!separate_meet(placed, panel, p, q, zero, zero)) return false;

    /* from p to q: down along gravity, the lower one alone; or horizontally, both */
    mus__unit3(gravity);
    for (int32_t d = 0; d < 3; d++)
        along[d] = panel[q].middle[d] + panel[q].way[d] - panel[p].middle[d] - panel[p].way[d];
    const double down = mus__dot3(along, gravity);
    for (int32_t d = 0; d < 3; d++) along[d] -= down * gravity[d];
    const bool below = fabs(down) >= mus__norm3(along);
    double share[2] = {-0.5, 0.5};
    if (below) {
        memcpy(along, gravity, sizeof along);
        share[0] = down > 0.0 ? 0.0 : 1.0, share[1] = 1.0 - share[0];
    }
    mus__unit3(along);
    if (!(mus__norm3(along) > 0.0)) return false;
    for (int32_t k = 1; k <= SEPARATE_STEPS; k++) {
        double more[3], less[3];
        for (int32_t d = 0; d < 3; d++) {
            more[d] = share[0] * k * placed->cloth->spacing * along[d];
            less[d] = share[1] * k * placed->cloth->spacing * along[d];
        }
        if (separate_meet(placed, panel, p, q, more, less)) continue;
        for (int32_t d = 0; d < 3; d++) panel[p].way[d] += more[d], panel[q].way[d] += less[d];
        return true;
    }
    return false;
}


mus_status mus__arrange_separate(const mus__placed_cloth *placed, bool *moved)
{
    const mus_cloth *cloth = placed->cloth;
    separate_panel *panel = mus__new(placed->context, cloth->npanel, sizeof *panel);
    if (panel == NULL) return mus__fail_memory(placed->context, "the check of an arrangement");
    separate_look(placed, panel);
    bool again = true;
    *moved = false;
    for (int32_t k = 0; k < SEPARATE_ROUNDS && again; k++) {
        again = false;
        for (int32_t p = 0; p < cloth->npanel; p++)
            for (int32_t q = p + 1; q < cloth->npanel; q++) again |= separate_two(placed, panel, p, q);
        *moved |= again;
    }
    for (int32_t i = 0; i < placed->cloth->nnode && *moved; i++)
        for (int32_t d = 0; d < 3; d++) placed->x[3 * (int64_t)i + d] += panel[cloth->node_panel[i]].way[d];
    mus__free(placed->context, panel);
    return MUS_OK;
}
