/*
 * manifold_lattice.h: the lattice that samples the union of a body's solids.
 *
 * The lattice is body-centred cubic: points at (i, j, k) and at (i + 1/2, j + 1/2, k + 1/2) spacings. Coordinates are
 * doubled, so that they are integers: all even, or all odd. A point has 14 neighbours; a tetrahedron has two points of
 * either kind, two long edges (1 spacing) and four short ones (sqrt(3)/2).
 * A cell is a cube of 2 x 2 x 2 points of both kinds. Only cells through which the surface may pass have points of
 * their own, and each of these has a number; the others share cell 0, whose points are all outside, or cell 1, whose
 * points are all inside.
 *
 * Directions d = 0 to 6 are those of the edges that a point owns, d + 7 is opposite to d.
 */
#ifndef MUS_MANIFOLD_MANIFOLD_LATTICE_H
#define MUS_MANIFOLD_MANIFOLD_LATTICE_H

#include "base/thread_pool.h"
#include "manifold/manifold_solid.h"

#define MUS__CELL_POINTS 16 /* of a cell: the bits of their index are the kind, and the place along z, y and x */
#define MUS__LINKS 14       /* neighbours of a point */
#define MUS__OWNED 7        /* edges that a point owns */
#define MUS__LINK_EDGES 36  /* of the sphere that the neighbours of a point span */
#define MUS__LINK_FACES 24

/* cells that stand for many */
enum { MUS__CELL_OUT, MUS__CELL_IN, MUS__CELLS_SHARED };

/* the label of a point */
enum {
    MUS__POINT_IN = 1,     /* within the solid */
    MUS__POINT_ON = 2,     /* moved onto the surface, along the edge `label >> 4` */
    MUS__POINT_SEEN = 4,   /* marks of manifold_grow.c: the point was tried, */
    MUS__POINT_QUEUED = 8, /* waits to be tried, */
    MUS__POINT_GROWN = 16  /* belongs to the solid that is grown */
};

/* what is known of the crossing of an edge */
enum {
    MUS__EDGE_ESTIMATE, /* about where it is */
    MUS__EDGE_FOUND,    /* where it is */
    MUS__EDGE_CUT       /* both ends lie inside, a handle was opened: it is in the middle */
};

/* the point of another cell, or of the same one, that a step leads to */
typedef struct mus__step {
    int32_t cell; /* from the place of the cell in the table */
    int32_t point;
} mus__step;

typedef struct mus__bcc {
    mus_context *context;
    mus__pool *pool;
    const mus__solids *solids;
    double spacing, origin[3]; /* [m] */
    int32_t grid[3];           /* cells along each axis; the outermost ones are outside */
    int32_t *table;            /* (grid) the cell there */
    int32_t cells;             /* shared ones, and those with points of their own */
    int32_t filled;            /* those whose points have depth and label */
    int32_t *place;            /* (cells) where they stand in the table */
    int32_t *corner;           /* (cells x 3) and in the grid */
    int32_t *solid_first;      /* (cells + 1) first entry in `near` */
    int32_t entries;
    int32_t *near;             /* (entries) solids near each cell, ascending */
    float *depth;              /* (cells x MUS__CELL_POINTS) in the union, positive inside [m] */
    uint8_t *label;            /* (cells x MUS__CELL_POINTS) */
    uint16_t *differ;          /* (cells x MUS__CELL_POINTS) bit d: the neighbour d was on the other side before points
                                  were moved */
    uint16_t *inside;          /* (cells x MUS__CELL_POINTS) bit d: the neighbour d is inside now */
    uint16_t *moved;           /* (cells x MUS__CELL_POINTS) bit d: the neighbour d was moved onto the surface */
    uint8_t *slot;             /* (cells x MUS__CELL_POINTS) first crossing of a point, from that of the cell */
    int32_t *cell_first;       /* (cells + 1) first crossing of each cell */
    int32_t place_room, corner_room, first_room, near_room, depth_room, label_room, differ_room, inside_room;
    int32_t crossings;
    double *crossing;          /* (crossings x 3) points of the surface on the edges [m], once they are searched */
    float *part;               /* (crossings) place on the edge, 0 at its owner, 1 at the other end: an estimate until
                                  the edge is searched */
    uint8_t *state;            /* (crossings) MUS__EDGE_* */
    mus__step step[MUS__CELL_POINTS][MUS__LINKS];
    uint16_t touch[MUS__LINKS]; /* bit e of touch[d]: neighbours d and e of a point are neighbours of each other */
    uint16_t edge[MUS__LINK_EDGES], face[MUS__LINK_FACES]; /* the neighbours that these join, a bit each */
    uint8_t linked[1 << (MUS__LINKS - 3)]; /* bit of each set of neighbours: they are connected among themselves */
} mus__bcc;

/* the direction opposite to d */
static inline int32_t mus__bcc_opposite(int32_t d)
{
    return d < MUS__OWNED ? d + MUS__OWNED : d - MUS__OWNED;
}
/* steps to a neighbour in doubled coordinates, in manifold_cell.c */
extern const int8_t mus__bcc_step[MUS__LINKS][3];

/* the neighbour of a point in direction d; the point is not one of a shared cell */
static inline int32_t mus__bcc_next(const mus__bcc *lattice, int32_t point, int32_t d)
{
    const uint32_t p = (uint32_t)point;
    const mus__step *to = &lattice->step[p % MUS__CELL_POINTS][d];
    return lattice->table[lattice->place[p / MUS__CELL_POINTS] + to->cell] * MUS__CELL_POINTS + to->point;
}
/* whether a point belongs to a shared cell */
static inline bool mus__bcc_shared(int32_t point)
{
    return point < MUS__CELLS_SHARED * MUS__CELL_POINTS;
}
/* the point after a step from the cell at a place of the table */
static inline int32_t mus__bcc_point(const mus__bcc *lattice, int32_t place, const mus__step *to)
{
    return lattice->table[place + to->cell] * MUS__CELL_POINTS + to->point;
}
/* whether the neighbours of a mask are connected among themselves; true for none */
static inline bool mus__bcc_connected(const mus__bcc *lattice, uint32_t mask)
{
    return (lattice->linked[mask / 8] >> mask % 8 & 1) != 0;
}
/* whether a point is simple, the bits of whose neighbours inside are `in` */
static inline bool mus__bcc_simple(const mus__bcc *lattice, uint32_t in)
{
    const uint32_t out = ~in & ((1u << MUS__LINKS) - 1);
    return in != 0 && out != 0 && mus__bcc_connected(lattice, in) && mus__bcc_connected(lattice, out);
}
#endif
