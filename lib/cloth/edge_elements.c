/*
 * edge_elements.c: what a pattern says of keeping a garment up, as elements of its cloth: gathered edges, elastics,
 * held nodes.
 *
 * Gathers. A seam whose sides are meant to differ (its ease) takes up the fullness in folds finer than any lattice: the
 * thread makes the longer side as long as the shorter. So the springs along the longer side have the length that they
 * are sewn to, and are the stiffer by as much, for that many layers lie there; of those from the seam to the cloth
 * behind, what runs along the seam is drawn in too. That cloth keeps its own length, and is what stands in folds.
 *
 * Elastics. A chain of springs along the edge, `ratio` times as long at rest. The cloth of a casing lies in folds along
 * it and neither helps nor resists until it is drawn flat, which the rows behind do: springs of the cloth along the
 * edge, and along what is sewn to it, have no stiffness.
 *
 * Holds are nodes with a level and the length of edge that they stand for.
 */
#include <math.h>

#include "cloth/mesh.h"

/* the factor on the rest length of a border side, and on its stiffness; of the side that starts at a place of the
 * border */
typedef struct held_side {
    double rest, stiff;
} held_side;


/* place in cloth->border of the side k .. k + 1 of an edge */
static int32_t held_place(const mus__mesh *mesh, int32_t edge, int32_t k)
{
    const mus__edge_nodes *nodes = &mesh->edge[edge];
    return nodes->start + (nodes->direction > 0 ? k : nodes->count - 1 - k);
}


/* a line inside a panel keeps its length: the cloth on both sides holds it */
static void held_factor(const mus__mesh *mesh, held_side *side, int32_t edge, double rest, double stiff)
{
    if (mesh->edge[edge].inner != MUS_NONE) return;
    for (int32_t k = 0; k < mesh->edge[edge].count; k++) {
        held_side *own = &side[held_place(mesh, edge, k)];
        own->rest *= rest, own->stiff *= stiff;
    }
}


/* which sides gather, which an elastic draws in; returns whether there are any */
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


/* the place in cloth->border of the side that a spring runs along, MUS_NONE inside; border nodes of a panel follow each
 * other */
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
 * The rest length of a spring from a border node to one inside: the fullness is taken up along the edge, so of the way
 * d between the two the part along the border is drawn in by the mean factor f of the sides at the node:
 * rest^2 = |d|^2 - (1 - f^2) (d . t)^2.
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


/* the chain of an elastic: each link draws with `stiffness` times its strain */
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


/* on which side of the body an edge starts: its middle node as its panel is placed, not rolled */
static int32_t held_right(const mus__mesh *mesh, int32_t edge)
{
    const mus_cloth *cloth = mesh->cloth;
    const int32_t node = mus__mesh_edge_node(mesh, edge, mesh->edge[edge].count / 2);
    const mus_placement *place = &cloth->panel[cloth->node_panel[node]].placement;
    const double *rest = cloth->rest + 2 * (ptrdiff_t)node;
    return place->origin[0] + place->rotation[0] * rest[0] + place->rotation[1] * rest[1] < 0.0;
}


/* the nodes of a held edge, half a step at both ends */
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
