/*
 * edge_facing.c: the stiffness of a facing along edges that hold themselves up on the body.
 *
 * The upper edge of a strapless top and the waist of a skirt without a band are sewn to nothing, and still stay up.
 * They are made firm for it, by a facing with interfacing or by bones, else the cloth above the level that it holds on
 * to falls over: a free edge with an attachment and no elastic gets a facing. It is as stiff as interfaced to stand by
 * itself over its own width w: its rigidity is weight * g * w^3, of bending length w (Peirce 1930), where the cloth has
 * not that much already.
 *
 *       o---o---o     Within w of the edge, each bending stencil of the lattice and each hinge of the border is as many
 *      /| f | f |\    times as stiff as that rigidity is over the cloth's. Stencils have their stiffness in runs, so
 *     o-o---o---o-o   what they gain is a stencil of its own (f). A hinge of a narrow triangle gains no more than an
 *     | |   |   | |   inner node of the lattice does: float cannot hold more, and the triangle is as good as rigid.
 */
#include <math.h>

#include "cloth/mesh.h"
#include "geom/vec.h"
#include "pattern/pattern_internal.h"


/* does the edge hold itself up: attached, sewn to nothing, without an elastic? */
static bool faced_edge(const mus__mesh *mesh, int32_t edge)
{
    int32_t level;
    double stiffness;
    if (mesh->edge[edge].panel == MUS_NONE || mesh->edge[edge].inner != MUS_NONE) return false;
    mus_pattern_edge_hold(mesh->pattern, edge, &level, NULL);
    mus_pattern_edge_elastic(mesh->pattern, edge, NULL, &stiffness);
    if (level == MUS_HOLD_NONE || stiffness > 0.0) return false;
    return mus_pattern_edge_seam(mesh->pattern, edge) == MUS_NONE;
}


/* marks the nodes of the panel within the width of a facing from an edge, in the flat */
static void faced_nodes(const mus__mesh *mesh, int32_t edge, unsigned char *faced)
{
    const mus_cloth *cloth = mesh->cloth;
    const mus__panel_mesh *panel = &cloth->panel[mesh->edge[edge].panel];
    for (int32_t k = 0; k < mesh->edge[edge].count; k++) {
        const double *p = cloth->rest + 2 * (ptrdiff_t)mus__mesh_edge_node(mesh, edge, k);
        const double *q = cloth->rest + 2 * (ptrdiff_t)mus__mesh_edge_node(mesh, edge, k + 1);
        const double ux = q[0] - p[0], uy = q[1] - p[1], length2 = ux * ux + uy * uy;
        for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++) {
            const double *x = cloth->rest + 2 * (ptrdiff_t)i;
            const double at = fmin(fmax(((x[0] - p[0]) * ux + (x[1] - p[1]) * uy) / length2, 0.0), 1.0);
            const double dx = x[0] - p[0] - at * ux, dy = x[1] - p[1] - at * uy;
            if (dx * dx + dy * dy < MUS__FACING * MUS__FACING) faced[i] = 1;
        }
    }
}


/* the stencils of a run whose middle is faced: `gain` times their stiffness more */
static mus_status faced_stencils(mus__mesh *mesh, const mus__bend_run *run, const unsigned char *faced, double gain)
{
    mus_cloth *cloth = mesh->cloth;
    const double side = mus__dist2(cloth->rest + 2 * (ptrdiff_t)run->a, cloth->rest + 2 * (ptrdiff_t)run->b);
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < run->count && status == MUS_OK; i++) {
        if (!faced[run->b + i]) continue;
        status = mus__reserve(mesh->context, &cloth->hinge, &mesh->cap_hinge, (int64_t)cloth->nhinge + 1,
                              sizeof *cloth->hinge);
        if (status == MUS_OK)
            cloth->hinge[cloth->nhinge++] = (mus__hinge){.node = {run->b + i, run->b + i, run->a + i, run->c + i},
                                                         .coef = {-1.0, -1.0, 1.0, 1.0},
                                                         .k = gain * run->k,
                                                         .area = side * side};
    }
    return status;
}


/* the hinges that lie in a facing, `gain` times their stiffness more, `most` [N/m] at a node */
static void faced_hinges(mus__hinge *hinge, int32_t count, const unsigned char *faced, double gain, double most)
{
    for (int32_t h = 0; h < count; h++) {
        double sum = 0.0, largest = 0.0;
        bool inside = true;
        for (int32_t k = 0; k < 4; k++) {
            inside = inside && faced[hinge[h].node[k]];
            sum += fabs(hinge[h].coef[k]);
            largest = fmax(largest, fabs(hinge[h].coef[k]));
        }
        if (inside) hinge[h].k += fmin(gain * hinge[h].k, most / (sum * largest));
    }
}


mus_status mus__mesh_facings(mus__mesh *mesh)
{
    mus_cloth *cloth = mesh->cloth;
    const double *bend = cloth->fabric.bend, softest = fmin(fmin(bend[0], bend[1]), bend[2]);
    const double asked = mus__rigidity_of_length(cloth->fabric.weight, MUS__FACING);
    if (!(softest > 0.0 && softest < asked) || mesh->paper > 0.0) return MUS_OK;
    unsigned char *faced = mus__new(mesh->context, cloth->nnode, sizeof *faced);
    if (faced == NULL) return mus__fail_memory(mesh->context, "the facings of a cloth");
    for (int32_t e = 0; e < mus_pattern_edge_count(mesh->pattern); e++)
        if (faced_edge(mesh, e)) faced_nodes(mesh, e, faced);

    const double gain = asked / softest - 1.0;
    /* of an inner node in its stencils along one line: its own and those of its neighbours (border_springs.c) */
    const double most = gain * 16.0 * fmax(mesh->constant.bend[0], mesh->constant.bend[1]);
    faced_hinges(cloth->hinge, cloth->nhinge, faced, gain, most);
    faced_hinges(cloth->seam_hinge, cloth->nseam_hinge, faced, gain, most);
    mus_status status = MUS_OK;
    for (int32_t r = 0; r < cloth->nbend && status == MUS_OK; r++)
        status = faced_stencils(mesh, &cloth->bend[r], faced, gain);
    mus__free(mesh->context, faced);
    return status;
}
