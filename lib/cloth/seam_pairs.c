/*
 * seam_pairs.c: partners along seams, and the hinges that bend across a sewn edge.
 *
 * Step k along edge a meets step n - k along edge b when the seam runs reversed, step k when direct. The hinge of an
 * interval has the border triangle of each side as its wings, in the shape that both have when the two intervals are
 * brought to their mean length; it acts once the pairs are welded and b's nodes are a's; before that, what
 * seam_turns.c makes of it does.
 *
 * A patch is sewn to a line inside a panel, and lies on the cloth beside it: it goes on from the cloth on the far side
 * of the line, so its hinge has its wing there, and is flat when the patch lies flat. Layers of a pleat fold where they
 * are laid: no hinge holds them flat. A closure that is left open has no pairs; one done up with buttons has one each.
 * A tie is as narrow as a hand and draws a whole front round the body: it pulls as a longer seam does.
 */
#include <math.h>

#include "base/elementary.h"
#include "cloth/mesh.h"
#include "geom/vec.h"

/* [m] of seam that a tie pulls as; chosen: it draws a whole edge tight, from the shoulder to the waist */
#define PAIRS_TIE 0.3


/* step of edge b that meets step k of edge a */
static int32_t pairs_partner(const mus__mesh *mesh, const mus_seam_def *seam, int32_t k)
{
    return seam->direction == MUS_SEAM_DIRECT ? k : mesh->edge[seam->edge_a].count - k;
}


static mus_status pairs_reserve(mus__mesh *mesh, int64_t more)
{
    mus_cloth *cloth = mesh->cloth;
    mus_context *context = mesh->context;
    const int64_t pairs = cloth->npair + more, hinges = cloth->nseam_hinge + more;
    mus_status status = mus__reserve(context, &cloth->pair, &mesh->cap_pair, pairs, 2 * sizeof *cloth->pair);
    if (status == MUS_OK)
        status = mus__reserve(context, &cloth->pair_seam, &mesh->cap_pair_seam, pairs, sizeof *cloth->pair_seam);
    if (status == MUS_OK)
        status = mus__reserve(context, &cloth->pair_length, &mesh->cap_pair_length, pairs, sizeof *cloth->pair_length);
    if (status == MUS_OK)
        status = mus__reserve(context, &cloth->seam_hinge, &mesh->cap_seam_hinge, hinges, sizeof *cloth->seam_hinge);
    if (status == MUS_OK)
        status = mus__reserve(context, &mesh->partner, &mesh->cap_partner, hinges, 2 * sizeof *mesh->partner);
    return status;
}


/* the side of a line (0 left, 1 right) away from the patch that `edge` is an edge of: the triangles of the patch pass
 * the edge as its outline does, and those of the line on the side where the patch lies pass it the same way */
static int32_t pairs_beyond(const mus__mesh *mesh, const mus_seam_def *seam, int32_t edge)
{
    return mesh->edge[edge].direction * (seam->direction == MUS_SEAM_DIRECT ? 1 : -1) > 0 ? 1 : 0;
}


/* the corner behind interval k .. k + 1 of an edge, and the shape of its triangle: length, foot from step k, height;
 * of a line, the one on `side` */
static int32_t pairs_wing(const mus__mesh *mesh, int32_t edge, int32_t k, int32_t side, double *shape)
{
    const mus__edge_nodes *nodes = &mesh->edge[edge];
    int32_t a = mus__mesh_edge_node(mesh, edge, k), b = mus__mesh_edge_node(mesh, edge, k + 1);
    const int32_t corner = nodes->inner != MUS_NONE
                               ? mesh->inner_wing[2 * ((ptrdiff_t)nodes->inner + k) + side]
                               : mesh->wing[nodes->start + (nodes->direction > 0 ? k : nodes->count - 1 - k)];
    const double *rest = mesh->cloth->rest;
    const double *p = rest + 2 * (ptrdiff_t)a, *q = rest + 2 * (ptrdiff_t)b, *r = rest + 2 * (ptrdiff_t)corner;
    double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1];
    shape[0] = mus__hypot(ux, uy);
    shape[1] = (ux * vx + uy * vy) / shape[0];
    shape[2] = fabs(ux * vy - uy * vx) / shape[0];
    return corner;
}


/* rigidity across interval k of an edge, in the fabric's frame */
static double pairs_rigidity(const mus__mesh *mesh, int32_t edge, int32_t k)
{
    double grain[2] = {0.0, 1.0};
    mus_pattern_grain(mesh->pattern, mesh->edge[edge].panel, grain);
    const double *p = mesh->cloth->rest + 2 * (ptrdiff_t)mus__mesh_edge_node(mesh, edge, k);
    const double *q = mesh->cloth->rest + 2 * (ptrdiff_t)mus__mesh_edge_node(mesh, edge, k + 1);
    double x = q[0] - p[0], y = q[1] - p[1], size = mus__hypot(x, y) * mus__hypot(grain[0], grain[1]);

    /* along the edge: warp by the dot product, weft by the cross product; across it they change places */
    double warp = (x * grain[0] + y * grain[1]) / size, weft = (x * grain[1] - y * grain[0]) / size;
    return mus__fabric_bend(&mesh->cloth->fabric, warp, weft);
}


/*
 * The bending energy of a seam's hinge under a uniform curvature of one of its panels, for calibrate_bending.c: edge
 * nodes and the panel's own wing lie as in the panel, the other wing where the hinge is flat (sum c_i x_i = 0).
 */
static void pairs_curvature(mus__mesh *mesh, int32_t edge, const int32_t *node, const mus__hinge *hinge, int own)
{
    const int other = 5 - own;
    const int32_t panel = mesh->edge[edge].panel;
    double axis[2] = {0.0, 1.0}, xy[8], part[4];
    mus_pattern_grain(mesh->pattern, panel, axis);
    const double size = mus__hypot(axis[0], axis[1]);
    axis[0] /= size, axis[1] /= size;
    for (int d = 0; d < 2; d++) {
        const double *rest = mesh->cloth->rest + d;
        xy[d] = rest[2 * (ptrdiff_t)node[0]], xy[2 + d] = rest[2 * (ptrdiff_t)node[1]];
        xy[2 * own + d] = rest[2 * (ptrdiff_t)hinge->node[own]];
        xy[2 * other + d] =
            -(hinge->coef[0] * xy[d] + hinge->coef[1] * xy[2 + d] + hinge->coef[own] * xy[2 * own + d]) /
            hinge->coef[other];
    }
    mus__mesh_curvature(axis, 4, hinge->coef, xy, part);
    for (int d = 0; d < 4; d++) mesh->seam_bend[4 * (ptrdiff_t)panel + d] += hinge->k * part[d];
}


/* hinge over interval k of the seam */
static void pairs_hinge(mus__mesh *mesh, const mus_seam_def *seam, int32_t k)
{
    mus_cloth *cloth = mesh->cloth;
    int32_t partner = pairs_partner(mesh, seam, k), low = seam->direction == MUS_SEAM_DIRECT ? partner : partner - 1;
    const bool line_a = mesh->edge[seam->edge_a].inner != MUS_NONE, line_b = mesh->edge[seam->edge_b].inner != MUS_NONE;
    if (line_a && line_b) return;
    double own[3], other[3];
    int32_t node[4] = {mus__mesh_edge_node(mesh, seam->edge_a, k), mus__mesh_edge_node(mesh, seam->edge_a, k + 1)};
    node[2] = pairs_wing(mesh, seam->edge_a, k, pairs_beyond(mesh, seam, seam->edge_b), own);
    node[3] = pairs_wing(mesh, seam->edge_b, low, pairs_beyond(mesh, seam, seam->edge_a), other);

    /* feet from the same end, at the mean length */
    double length = 0.5 * (own[0] + other[0]);
    double along = seam->direction == MUS_SEAM_DIRECT ? other[1] / other[0] : 1.0 - other[1] / other[0];
    const double foot[2] = {own[1] / own[0] * length, along * length}, height[2] = {own[2], other[2]};
    double rigidity = 0.5 * (pairs_rigidity(mesh, seam->edge_a, k) + pairs_rigidity(mesh, seam->edge_b, low));
    mus__hinge *hinge = &cloth->seam_hinge[cloth->nseam_hinge];
    if (!mus__mesh_hinge(mesh, node, length, foot, height, rigidity, hinge)) return;

    /* the same two ends of the interval, as nodes of b */
    const int32_t partners[2] = {mus__mesh_edge_node(mesh, seam->edge_b, partner),
                                 mus__mesh_edge_node(mesh, seam->edge_b, pairs_partner(mesh, seam, k + 1))};
    for (int32_t i = 0; i < 2; i++) mesh->partner[2 * (ptrdiff_t)cloth->nseam_hinge + i] = partners[i];
    cloth->nseam_hinge++;

    /* the hinge of a patch is not part of its panel's calibration */
    if (line_a || line_b) return;
    pairs_curvature(mesh, seam->edge_a, node, hinge, 2);
    pairs_curvature(mesh, seam->edge_b, partners, hinge, 3);
}


/* the pair of step k, which stands for `length` of the seam. A dart's legs may share their end node */
static void pairs_add(mus__mesh *mesh, const mus_seam_def *seam, int32_t index, int32_t k, double length)
{
    mus_cloth *cloth = mesh->cloth;
    const int32_t a = mus__mesh_edge_node(mesh, seam->edge_a, k);
    const int32_t b = mus__mesh_edge_node(mesh, seam->edge_b, pairs_partner(mesh, seam, k));
    if (a == b) return;
    cloth->pair[2 * (ptrdiff_t)cloth->npair] = a, cloth->pair[2 * (ptrdiff_t)cloth->npair + 1] = b;
    cloth->pair_seam[cloth->npair] = index;
    cloth->pair_length[cloth->npair++] = length;
    mus__panel_mesh *own = &cloth->panel[mesh->edge[seam->edge_a].panel];
    mus__panel_mesh *other = &cloth->panel[mesh->edge[seam->edge_b].panel];
    own->lies = own->lies || own->layer > other->layer;
    other->lies = other->lies || other->layer > own->layer;
}


static mus_status pairs_seam(mus__mesh *mesh, int32_t index)
{
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    mus_status status = mus_pattern_seam(mesh->pattern, index, &seam);
    if (status != MUS_OK) return status;
    int32_t n = mesh->edge[seam.edge_a].count;
    if (mesh->edge[seam.edge_a].panel == MUS_NONE || mesh->edge[seam.edge_b].panel == MUS_NONE)
        return mus__fail(mesh->context, MUS_ERR_MESH, "seam %d: an edge of it is in no outline", (int)index);
    status = pairs_reserve(mesh, (int64_t)n + 1);
    if (status != MUS_OK) return status;

    /* the mean length of the two intervals; half of it at both ends */
    double length = 0.5 * (mus_pattern_edge_length(mesh->pattern, seam.edge_a) +
                           mus_pattern_edge_length(mesh->pattern, seam.edge_b));
    if (seam.closure == MUS_CLOSURE_TIES) length = fmax(length, PAIRS_TIE);
    if (seam.open) return MUS_OK;
    for (int32_t i = 0, last = MUS_NONE; i < seam.buttons; i++) {
        const int32_t k = (int32_t)floor((i + 0.5) / seam.buttons * n + 0.5);
        if (k != last) pairs_add(mesh, &seam, index, k, length / seam.buttons);
        last = k;
    }
    if (seam.buttons > 0) return MUS_OK;
    for (int32_t k = 0; k <= n; k++) pairs_add(mesh, &seam, index, k, (k == 0 || k == n ? 0.5 : 1.0) * length / n);
    for (int32_t k = 0; k < n && !seam.laid; k++) pairs_hinge(mesh, &seam, k);
    return MUS_OK;
}


mus_status mus__mesh_seams(mus__mesh *mesh)
{
    mus_status status = MUS_OK;
    mesh->cloth->nseam = mus_pattern_seam_count(mesh->pattern);
    for (int32_t s = 0; status == MUS_OK && s < mesh->cloth->nseam; s++) status = pairs_seam(mesh, s);
    return status;
}
