/*
 * seam_turns.c: bending across seams while they are open.
 *
 * A band that is drawn to its edge by the pull alone trails behind, and is sewn on folded under or over. So the bending
 * of a seam acts before it is welded too, and turns both sides towards one plane, where the pattern places the panel of
 * one side as going on from that of the other. Else its rigidity is 0.
 *
 *     w2 --- a   b --- w3     e = c2 (w2 - a) + c3 (w3 - b) is 0 where the way from b to its wing goes on from the way
 *                             of the other wing to a, however far apart the two edges are
 *
 * a = (1 - s) a0 + s a1, and b as it: with the hinge's own s, e is 0 in the flat. An element of a force program has
 * four nodes, so the square of e is written as (1 - s) e0^2 + s e1^2 - s (1 - s) (e1 - e0)^2, with e0 from a0 and b0,
 * e1 from a1 and b1.
 */
#include <string.h>

#include "base/elementary.h"
#include "cloth/mesh.h"
#include "geom/vec.h"


/* where a hinge has the foot of its wings on the edge, as a share of it */
static double turn_foot(const mus__hinge *hinge)
{
    return hinge->coef[1] / (hinge->coef[0] + hinge->coef[1]);
}


/* the way from the foot of a hinge on the edge of a side, between its nodes a and b, to the wing of that side, as the
 * panel is placed */
static void turn_way(const mus_cloth *cloth, double foot, int32_t a, int32_t b, int32_t wing, double *out)
{
    const mus_placement *place = &cloth->panel[cloth->node_panel[a]].placement;
    const double *p = cloth->rest + 2 * (ptrdiff_t)a, *q = cloth->rest + 2 * (ptrdiff_t)b;
    const double *w = cloth->rest + 2 * (ptrdiff_t)wing;
    const double from = p[0] + foot * (q[0] - p[0]), x = w[0] - from, y = w[1] - p[1] - foot * (q[1] - p[1]);
    const double angle = place->bend != 0.0 ? (from - place->bend_x) / place->bend : 0.0;
    const double way[3] = {x * mus__cos(angle), y, -x * mus__sin(angle)};
    for (int32_t d = 0; d < 3; d++) out[d] = mus__dot3(place->rotation + 3 * d, way);
}


/* whether the panels of a seam are placed as one goes on from the other: their ways apart by more than a right angle */
static bool turn_goes_on(const mus_cloth *cloth, const mus__hinge *hinge, const int32_t *partner)
{
    double way[2][3];
    turn_way(cloth, turn_foot(hinge), hinge->node[0], hinge->node[1], hinge->node[2], way[0]);
    turn_way(cloth, turn_foot(hinge), partner[0], partner[1], hinge->node[3], way[1]);
    return mus__dot3(way[0], way[1]) < 0.0;
}


/* one of the three squares, with no friction between threads where the sides do not turn against each other */
static void turn_square(const mus__hinge *hinge, const int32_t *node, const double *coef, double share, bool turns,
                        mus__hinge *out)
{
    memcpy(out->node, node, sizeof out->node);
    memcpy(out->coef, coef, sizeof out->coef);
    out->k = node[0] != node[3] && node[1] != node[2] ? share * hinge->k : 0.0;
    out->area = turns ? hinge->area : 0.0;
}


mus_status mus__mesh_turns(mus__mesh *mesh)
{
    mus_cloth *cloth = mesh->cloth;
    cloth->seam_turn = mus__new(mesh->context, 3 * (int64_t)cloth->nseam_hinge, sizeof *cloth->seam_turn);
    if (cloth->seam_turn == NULL) return mus__fail_memory(mesh->context, "the seams of a cloth");
    for (int32_t h = 0; h < cloth->nseam_hinge; h++) {
        const mus__hinge *hinge = &cloth->seam_hinge[h];
        const int32_t *e = hinge->node, *partner = mesh->partner + 2 * (ptrdiff_t)h;
        const double c2 = hinge->coef[2], c3 = hinge->coef[3], s = turn_foot(hinge);
        const double ends[4] = {-c2, -c3, c2, c3}, along[4] = {c2, -c2, c3, -c3};
        const int32_t first[4] = {e[0], partner[0], e[2], e[3]}, last[4] = {e[1], partner[1], e[2], e[3]};
        const int32_t sides[4] = {e[0], e[1], partner[0], partner[1]};
        const double all = e[2] != e[3] && turn_goes_on(cloth, hinge, partner) ? 1.0 : 0.0;
        mus__hinge *turn = cloth->seam_turn + 3 * (ptrdiff_t)h;
        turn_square(hinge, first, ends, all * (1.0 - s), true, &turn[0]);
        turn_square(hinge, last, ends, all * s, true, &turn[1]);
        turn_square(hinge, sides, along, -all * s * (1.0 - s), false, &turn[2]);
    }
    return MUS_OK;
}
