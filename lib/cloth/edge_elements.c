/*
 * edge_elements.c: elements of a cloth along the edges of its pattern: gathers, elastics, attachments.
 *
 * Gathers. Where a seam's sides differ in length on purpose (ease), the gathering thread makes the longer side as long
 * as the shorter, in folds finer than the lattice. So the springs along the longer side get the rest length of the
 * shorter one, and their stiffness is multiplied by the ratio of lengths, which is the mean number of layers there. Of
 * the springs from the seam inwards, the component along the seam is shortened too. The cloth behind keeps its rest
 * length and folds.
 *
 * Elastics. An elastic is a chain of springs along its edge whose rest length is `ratio` times that of the edge. The
 * cloth of a casing is folded along it and has no stiffness until it is drawn flat; then the rows behind resist. So the
 * springs of the cloth along the edge, and along the edges sewn to it, have stiffness 0.
 *
 * Attachments. Each node of an attached edge gets its level and the length of edge [m] that it stands for.
 */
#include <math.h>

#include "cloth/mesh.h"

/* factors on rest length and stiffness of the border side that starts at an index of cloth->border */
typedef struct held_side {
    double rest, stiff;
} held_side;


/* Returns the index in cloth->border of the side between steps k and k + 1 of an edge. */
static int32_t held_place(const mus__mesh *mesh, int32_t edge, int32_t k)
{
    const mus__edge_nodes *nodes = &mesh->edge[edge];
    return nodes->start + (nodes->direction > 0 ? k : nodes->count - 1 - k);
}


/* Sets the factors of all border sides of an edge. A line inside a panel keeps its length, since the cloth on both
 * sides of it does. */
static void held_factor(const mus__mesh *mesh, held_side *side, int32_t edge, double rest, double stiff)
{
    if (mesh->edge[edge].inner != MUS_NONE) return;
    for (int32_t k = 0; k < mesh->edge[edge].count; k++) {
        held_side *own = &side[held_place(mesh, edge, k)];
        own->rest *= rest, own->stiff *= stiff;
    }
}


/* Sets the factors of the sides that are gathered or drawn in by an elastic. Returns whether there is any. */
static bool held_sides(const mus__mesh *mesh, held_side *side)
{
    bool any = false;
    for (int32_t s = 0; s < mus_pattern_seam_count(mesh->pattern); s++) {
        mus_seam_def seam;
        double stiffness[2];
        mus_seam_def_init(&seam, sizeof seam);
        if (mus_pattern_seam(mesh->pattern, s, &seam) != MUS_OK || seam.open) continue;
        const int32_t longer = seam.ease > 0.0 ? seam.edge_b : seam.edge_a;
        const double length = mus_pattern_edge_length(mesh->pattern, longer), left = length - fabs(seam.ease);
        if (seam.ease != 0.0 && left > 0.0) held_factor(mesh, side, longer, left / length, length / left), any = true;
        mus_pattern_edge_elastic(mesh->pattern, seam.edge_a, NULL, &stiffness[0]);
        mus_pattern_edge_elastic(mesh->pattern, seam.edge_b, NULL, &stiffness[1]);
        if (stiffness[0] > 0.0) held_factor(mesh, side, seam.edge_b, 1.0, 0.0), any = true;
        if (stiffness[1] > 0.0) held_factor(mesh, side, seam.edge_a, 1.0, 0.0), any = true;
    }
    for (int32_t e = 0; e < mus_pattern_edge_count(mesh->pattern); e++) {
        double stiffness;
        mus_pattern_edge_elastic(mesh->pattern, e, NULL, &stiffness);
        if (stiffness > 0.0 && mesh->edge[e].panel != MUS_NONE) held_factor(mesh, side, e, 1.0, 0.0), any = true;
    }
    return any;
}


/* Returns the index in cloth->border of the side along which a spring runs; MUS_NONE for a spring inside the panel. */
static int32_t held_border(const mus_cloth *cloth, const mus__spring *spring)
{
    const mus__panel_mesh *panel = &cloth->panel[cloth->node_panel[spring->a]];
    const int32_t low = spring->a < spring->b ? spring->a : spring->b, high = spring->a + spring->b - low;
    const int32_t first = panel->first_node + panel->lattice_count, last = first + panel->border_count - 1;
    if (low < first || high > last) return MUS_NONE;
    if (high == low + 1) return panel->first_border + low - first;
    return low == first && high == last ? panel->first_border + high - first : MUS_NONE;
}


/*
 * Returns the rest length [m] of a spring from a border node to an inner node. The component of their difference d
 * along the border's unit tangent t is multiplied by f, the mean factor of the two sides at the border node: rest^2 =
 * |d|^2 - (1 - f^2) (d . t)^2.
 */
static double held_strip(const mus_cloth *cloth, const held_side *side, const mus__spring *spring)
{
    const mus__panel_mesh *panel = &cloth->panel[cloth->node_panel[spring->a]];
    const int32_t first = panel->first_node + panel->lattice_count, n = panel->border_count;
    const int32_t node = spring->a >= first ? spring->a : spring->b, other = spring->a + spring->b - node;
    if (node < first || node >= first + n || other >= first) return spring->rest;
    const int32_t at = node - first, before = (at + n - 1) % n, after = (at + 1) % n;
    const double f = 0.5 * (side[panel->first_border + before].rest + side[panel->first_border + at].rest);
    if (f == 1.0) return spring->rest;
    const double *p = cloth->rest + 2 * (ptrdiff_t)node, *q = cloth->rest + 2 * (ptrdiff_t)other;
    const double *a = cloth->rest + 2 * (ptrdiff_t)(first + before), *b = cloth->rest + 2 * (ptrdiff_t)(first + after);
    const double tx = b[0] - a[0], ty = b[1] - a[1], dx = q[0] - p[0], dy = q[1] - p[1];
    const double along2 = (dx * tx + dy * ty) * (dx * tx + dy * ty) / (tx * tx + ty * ty);
    return sqrt(fmax(dx * dx + dy * dy - (1.0 - f * f) * along2, 0.0));
}


static mus_status held_springs(mus__mesh *mesh)
{
    mus_cloth *cloth = mesh->cloth;
    held_side *side = mus__new(mesh->context, cloth->nborder, sizeof *side);
    if (side == NULL) return mus__fail_memory(mesh->context, "the gathers of a cloth");
    for (int32_t i = 0; i < cloth->nborder; i++) side[i] = (held_side){1.0, 1.0};
    const int32_t count = held_sides(mesh, side) ? cloth->nspring : 0;
    for (int32_t s = 0; s < count; s++) {
        mus__spring *spring = &cloth->spring[s];
        const int32_t at = held_border(cloth, spring);
        if (at == MUS_NONE) {
            spring->rest = held_strip(cloth, side, spring);
            continue;
        }
        spring->rest *= side[at].rest;
        spring->k *= side[at].stiff;
    }
    mus__free(mesh->context, side);
    return MUS_OK;
}


/* Adds the springs of an elastic along an edge; the tension of each is `stiffness` [N] times its strain. */
static mus_status held_elastic(mus__mesh *mesh, int32_t edge, double ratio, double stiffness)
{
    mus_cloth *cloth = mesh->cloth;
    const int32_t n = mesh->edge[edge].count;
    const double rest = ratio * mus_pattern_edge_length(mesh->pattern, edge) / n;
    const mus_status status = mus__reserve(mesh->context, &cloth->spring, &mesh->cap_spring,
                                           (int64_t)cloth->nspring + n, sizeof *cloth->spring);
    for (int32_t k = 0; k < n && status == MUS_OK; k++)
        cloth->spring[cloth->nspring++] =
            (mus__spring){mus__mesh_edge_node(mesh, edge, k), mus__mesh_edge_node(mesh, edge, k + 1),
                          MUS__SPRING_ELASTIC, stiffness / rest, rest};
    return status;
}


/* Returns 1 when an edge starts on the wearer's right (X < 0), by its middle node at the unrolled placement. */
static int32_t held_right(const mus__mesh *mesh, int32_t edge)
{
    const mus_cloth *cloth = mesh->cloth;
    const int32_t node = mus__mesh_edge_node(mesh, edge, mesh->edge[edge].count / 2);
    const mus_placement *place = &cloth->panel[cloth->node_panel[node]].placement;
    const double *rest = cloth->rest + 2 * (ptrdiff_t)node;
    return place->origin[0] + place->rotation[0] * rest[0] + place->rotation[1] * rest[1] < 0.0;
}


/* Adds the nodes of an attached edge; each stands for one step of the edge, the two end nodes for half a step. */
static mus_status held_nodes(mus__mesh *mesh, int32_t edge, int32_t level, double below)
{
    mus_cloth *cloth = mesh->cloth;
    const int32_t n = mesh->edge[edge].count, right = held_right(mesh, edge);
    const double step = mus_pattern_edge_length(mesh->pattern, edge) / n;
    const mus_status status = mus__reserve(mesh->context, &cloth->hold, &mesh->cap_hold, (int64_t)cloth->nhold + n + 1,
                                           sizeof *cloth->hold);
    for (int32_t k = 0; k <= n && status == MUS_OK; k++)
        cloth->hold[cloth->nhold++] = (mus__hold){mus__mesh_edge_node(mesh, edge, k), level, right, below,
                                                  k == 0 || k == n ? 0.5 * step : step};
    return status;
}


mus_status mus__mesh_held(mus__mesh *mesh)
{
    mus_status status = held_springs(mesh);
    for (int32_t e = 0; e < mus_pattern_edge_count(mesh->pattern) && status == MUS_OK; e++) {
        int32_t level;
        double below, ratio, stiffness;
        if (mesh->edge[e].panel == MUS_NONE) continue;
        mus_pattern_edge_hold(mesh->pattern, e, &level, &below);
        mus_pattern_edge_elastic(mesh->pattern, e, &ratio, &stiffness);
        if (stiffness > 0.0) status = held_elastic(mesh, e, ratio, stiffness);
        if (status == MUS_OK && level != MUS_HOLD_NONE) status = held_nodes(mesh, e, level, below);
    }
    return status;
}
