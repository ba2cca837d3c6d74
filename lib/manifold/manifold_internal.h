/*
 * manifold_internal.h: the lattice that samples the union of a body's solids, and the steps to its surface.
 *
 * The lattice is body-centred cubic: points at (i, j, k) and at (i + 1/2, j + 1/2, k + 1/2) spacings, in blocks of 8 x
 * 8 x 8 of both kinds. Coordinates are doubled, so that they are integers: all even, or all odd. A point has 14
 * neighbours; a tetrahedron has two points of either kind, two long edges (1 spacing) and four short ones (sqrt(3)/2).
 *
 * Directions d = 0 to 6 are those of the edges that a point owns, d + 7 is opposite to d.
 */
#ifndef MUS_MANIFOLD_MANIFOLD_INTERNAL_H
#define MUS_MANIFOLD_MANIFOLD_INTERNAL_H

#include "base/thread_pool.h"
#include "manifold/manifold_solid.h"
#include "muslin/manifold.h"

#define MUS__BLOCK 8
#define MUS__BLOCK_CELLS (MUS__BLOCK * MUS__BLOCK * MUS__BLOCK)
#define MUS__BLOCK_POINTS (2 * MUS__BLOCK_CELLS)
#define MUS__LINKS 14 /* neighbours of a point */
#define MUS__OWNED 7  /* edges that a point owns */

/* the label of a point */
enum {
    MUS__POINT_IN = 1,      /* within the solid */
    MUS__POINT_ON = 2,      /* moved onto the surface, along the edge `label >> 4` */
    MUS__POINT_SEEN = 4,    /* marks of manifold_label.c while it grows the solid */
    MUS__POINT_QUEUED = 8
};

typedef struct mus__bcc {
    mus_context *context;
    mus__pool *pool;
    const mus__solids *solids;
    double spacing, origin[3]; /* [m] */
    int32_t grid[3];           /* blocks along each axis */
    int32_t *table;            /* (grid) the active block there, or MUS_NONE */
    int32_t blocks;            /* active blocks: those near a solid */
    int32_t *place;            /* (blocks x 3) place in the grid */
    int32_t *solid_first;      /* (blocks + 1) first entry in `near` */
    int32_t *near;             /* solids whose boxes touch each block */
    float *depth;              /* (blocks x MUS__BLOCK_POINTS) in the union, positive inside [m] */
    uint8_t *label;            /* (blocks x MUS__BLOCK_POINTS) */
    uint8_t *kind;             /* (blocks) 0: all points are outside, 1: all inside, 2: both */
    uint8_t *crossed;          /* (blocks x MUS__BLOCK_POINTS) bit d: the owned edge d crosses the surface */
    uint16_t *slot;            /* (blocks x MUS__BLOCK_POINTS) first crossing of a point, from that of the block */
    int32_t *block_first;      /* (blocks + 1) first crossing of each block */
    double *crossing;          /* (crossings x 3) points of the surface on the edges [m] */
    uint8_t *cut;              /* (crossings) 1: both ends lie inside, a handle was opened */
    float *part;               /* (crossings) place on the edge, 0 at its owner, 1 at the other end */
    uint16_t touch[MUS__LINKS]; /* bit e of touch[d]: neighbours d and e of a point are neighbours of each other */
    uint8_t simple[1 << (MUS__LINKS - 3)]; /* bit of each set of neighbours inside: the point is simple */
} mus__bcc;

/* steps to a neighbour in doubled coordinates */
extern const int8_t mus__bcc_step[MUS__LINKS][3];

/* the neighbour of a point beyond its block, whose cell is (i, j, k) from the corner of the block */
int32_t mus__bcc_beyond(const mus__bcc *lattice, uint32_t block, int32_t odd, int32_t i, int32_t j, int32_t k);
/* the neighbour of a point in direction d; MUS_NONE: in no active block, and outside. The bits of a point's number are
 * its block, its kind, and the cell in the block */
static inline int32_t mus__bcc_next(const mus__bcc *lattice, int32_t point, int32_t d)
{
    const int8_t *step = mus__bcc_step[d];
    const uint32_t p = (uint32_t)point;
    const int32_t odd = (int32_t)(p / MUS__BLOCK_CELLS % 2), n = MUS__BLOCK, other = (odd + step[0]) & 1;
    const int32_t i = (int32_t)(p % MUS__BLOCK) + ((odd + step[0]) >> 1);
    const int32_t j = (int32_t)(p / MUS__BLOCK % MUS__BLOCK) + ((odd + step[1]) >> 1);
    const int32_t k = (int32_t)(p / (MUS__BLOCK * MUS__BLOCK) % MUS__BLOCK) + ((odd + step[2]) >> 1);
    const uint32_t block = p / MUS__BLOCK_POINTS;
    if (((i | j | k) & ~(n - 1)) != 0) return mus__bcc_beyond(lattice, block, other, i, j, k);
    return (int32_t)(block * MUS__BLOCK_POINTS) + other * MUS__BLOCK_CELLS + (k * n + j) * n + i;
}
/* the edge of a point in direction d, as the index of its crossing */
int32_t mus__bcc_crossing(const mus__bcc *lattice, int32_t point, int32_t d);
/* whether the block and all about it lie on one side of the surface */
bool mus__bcc_plain(const mus__bcc *lattice, int32_t block);

/* ---- manifold_lattice.c ---- */

/* blocks near the solids, and the depth and label of their points. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
mus_status mus__bcc_make(mus_context *context, mus__pool *pool, const mus__solids *solids, double spacing,
                             mus__bcc *out);
void mus__bcc_free(mus__bcc *lattice);
/* find the point of the surface on each edge whose ends have different labels. Errors: MUS_ERR_MEMORY */
mus_status mus__bcc_cross(mus__bcc *lattice);
/* move crossings that are nearly at a point of the lattice, and stayed, a little away from it */
void mus__bcc_part(mus__bcc *lattice);

/* ---- manifold_label.c ---- */

/* label as inside the largest part of each piece that is a topological ball. Errors: MUS_ERR_MEMORY */
mus_status mus__bcc_grow(mus__bcc *lattice);
/* move points that are near the surface onto it, where the surface stays a manifold */
void mus__bcc_snap(mus__bcc *lattice);

/* ---- manifold_mesh.c ---- */

struct mus_manifold {
    mus_context *context;
    int32_t vertices, triangles, pieces, cuts;
    double *vertex, *normal; /* (vertices x 3) */
    int32_t *triangle;       /* (triangles x 3) */
    double volume;           /* [m3] */
};

/* vertices, triangles and normals of the lattice's surface; the number of pieces and the sum of their Euler
 * characteristics. Errors: MUS_ERR_MEMORY */
mus_status mus__bcc_mesh(const mus__bcc *lattice, mus_manifold *out, int32_t *euler);

#endif
