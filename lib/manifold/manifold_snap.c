/*
 * manifold_snap.c: points of the lattice moved onto the surface, for well shaped triangles.
 *
 * A point with a crossing nearer than 0.25 of a long edge or 0.41 of a short one is moved onto that crossing and counts
 * as inside. The tetrahedra stay the right way round (Labelle and Shewchuk, 2007, section 3), so that the surface,
 * which has one piece in each, cannot cross itself. The surface shrinks onto the moved points; it remains a manifold if
 * three conditions hold about each of them: the point is simple or has no neighbour outside; on each edge to another
 * moved point the outside neighbours of both are connected; and of the two points opposite to a triangle of moved
 * points at most one is outside.
 *
 * A point is simple if those of its 14 neighbours that are inside are connected, and so are those that are outside, and
 * there are some of both. To change the label of a simple point does not change the topology of the solid (Bertrand and
 * Malandain, 1994; on this lattice the test is exact).
 */
#include <math.h>
#include <string.h>

#include "manifold/manifold_internal.h"

/* a crossing nearer to a point than this share of a long edge or a short one draws it to the surface; Labelle and
 * Shewchuk, 2007, table 1: the limits up to which no tetrahedron turns over */
#define SNAP_LONG 0.24999
#define SNAP_SHORT 0.41189

/* a crossing is searched where its estimate is below the limit by this factor: depths are distances to first order;
 * chosen */
#define SNAP_SLACK 1.1


/* whether the surface is a manifold about a point that was moved onto it */
static bool snap_good(const mus__bcc *lattice, int32_t point)
{
    const uint32_t in = lattice->inside[point], out = ~in & ((1u << MUS__LINKS) - 1), on = lattice->moved[point];
    if (out == 0) return true;
    if (!mus__bcc_simple(lattice, in)) return false;
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        if ((on >> d & 1) == 0) continue;
        const uint32_t round = lattice->touch[d];
        if ((round & in) == 0 || !mus__bcc_connected(lattice, round & out)) return false;
        for (int32_t e = 0; e < d; e++)
            if ((on & round) >> e & 1 && (round & lattice->touch[e] & in) == 0) return false;
    }
    return true;
}


/* the direction of the nearest crossing that draws a point to it, or would by its estimate; MUS_NONE: there is none */
static int32_t snap_nearest(const mus__bcc *lattice, int32_t point)
{
    int32_t found = MUS_NONE;
    double nearest = 1.0;
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        if ((lattice->differ[point] >> d & 1) == 0 || (lattice->moved[point] >> d & 1) != 0) continue;
        const int32_t at = mus__bcc_crossing(lattice, point, d);
        const double t = d < MUS__OWNED ? (double)lattice->part[at] : 1.0 - (double)lattice->part[at];
        const bool is_long = d % MUS__OWNED < 3;
        const double length = is_long ? t : 0.5 * sqrt(3.0) * t, slack = lattice->state[at] ? 1.0 : SNAP_SLACK;
        if (lattice->state[at] == MUS__EDGE_CUT || t >= slack * (is_long ? SNAP_LONG : SNAP_SHORT)) continue;
        if (length < nearest) nearest = length, found = d;
    }
    return found;
}


/* the same, with the crossing found: those whose estimate is nearer are searched first */
static int32_t snap_draw(mus__bcc *lattice, int32_t point)
{
    for (;;) {
        const int32_t d = snap_nearest(lattice, point);
        if (d == MUS_NONE || lattice->state[mus__bcc_crossing(lattice, point, d)] == MUS__EDGE_FOUND) return d;
        mus__bcc_search(lattice, point, d);
    }
}


/* set or clear the bit of a point in a mask of each of its neighbours */
static void snap_tell(const mus__bcc *lattice, int32_t point, uint16_t *mask, bool set)
{
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        const uint32_t bit = 1u << mus__bcc_opposite(d);
        uint16_t *to = &mask[mus__bcc_next(lattice, point, d)];
        *to = (uint16_t)(set ? *to | bit : *to & ~bit);
    }
}


/* move a point onto the crossing of its edge in direction d, unless the surface would not be a manifold */
static void snap_move(mus__bcc *lattice, int32_t point, int32_t d)
{
    const bool outside = (lattice->label[point] & MUS__POINT_IN) == 0;
    if (outside) snap_tell(lattice, point, lattice->inside, true);
    bool good = snap_good(lattice, point);

    /* a point that comes inside changes the surroundings of its neighbours */
    for (int32_t e = 0; e < MUS__LINKS && good && outside; e++)
        if ((lattice->moved[point] >> e & 1) != 0) {
            const int32_t next = mus__bcc_next(lattice, point, e);
            const uint16_t before = lattice->moved[next];
            lattice->moved[next] |= (uint16_t)(1u << mus__bcc_opposite(e));
            good = snap_good(lattice, next);
            lattice->moved[next] = before;
        }
    if (good) {
        lattice->label[point] = (uint8_t)(MUS__POINT_IN | MUS__POINT_ON | d << 4);
        snap_tell(lattice, point, lattice->moved, true);
    } else if (outside) {
        snap_tell(lattice, point, lattice->inside, false);
    }
}


mus_status mus__bcc_snap(mus__bcc *lattice)
{
    const int64_t points = (int64_t)lattice->cells * MUS__CELL_POINTS;
    mus_status status =
        mus__reserve(lattice->context, &lattice->inside, &lattice->inside_room, points, sizeof *lattice->inside);
    if (status != MUS_OK) return status;
    lattice->moved = mus__new(lattice->context, points, sizeof *lattice->moved);
    if (lattice->moved == NULL) return mus__fail_memory(lattice->context, "the lattice of a manifold");
    for (int32_t i = 0; i < points; i++) {
        const uint32_t differ = lattice->differ[i], every = (1u << MUS__LINKS) - 1;
        lattice->inside[i] = (uint16_t)((lattice->label[i] & MUS__POINT_IN) != 0 ? ~differ & every : differ);
    }

    /* all of one kind first: it takes most of the crossings of the other kind */
    for (int32_t odd = 0; odd < 2; odd++)
        for (int32_t point = MUS__CELLS_SHARED * MUS__CELL_POINTS; point < points; point++) {
            if (lattice->differ[point] == 0 || (point >> 3 & 1) != odd) continue;
            const int32_t d = snap_draw(lattice, point);
            if (d != MUS_NONE) snap_move(lattice, point, d);
        }
    return MUS_OK;
}
