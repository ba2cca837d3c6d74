/*
 * cut_only.h: what the files of the panels that are cut and sewn but not draped share.
 *
 * cut_only.c chooses the panels by the words of a style. cut_only_facing.c traces facings and the fly from the edges of
 * the drafted panels, cut_only_collar.c under-collars, cut_only_pocket.c front pockets; cut_only_strip.c draws
 * rectangles, cut_only_shape.c panels of chords. lib/design calls mus__cut_only_make() at the end of a draft.
 */
#ifndef MUS_CUT_ONLY_H
#define MUS_CUT_ONLY_H

#include "half/half_garment.h"


/* panels under work; the first failure stays in `status`, and calls after it do nothing */
typedef struct mus__cut_only {
    const mus_pattern *pattern; /* the drafted garment */
    mus_pattern *made;
    double scale; /* factor of lengths that are given in centimetres */
    mus_status status;
} mus__cut_only;

/* a rectangle: lengths along its sew line [m] */
typedef struct mus__cut_strip {
    const char *name, *label;
    double length, width;
    double seam;      /* allowance of its lower long edge [m]; 0: that of a seam */
    double turned;    /* allowance of its upper long edge, the inner layer of a folded strip; 0: that of a seam */
    bool halved;      /* folded along its middle, where no allowance is turned */
    bool lengthwise;  /* grain along the length, else across */
    int32_t material; /* MUS_MATERIAL_* */
    int32_t count;
    int32_t interfacing; /* pieces of interfacing too */
    int32_t nnotch;  /* notches of its lower edge, as parts of its length */
    double notch[3];
} mus__cut_strip;

#define MUS__CUT_POINTS 512 /* most points of a shape; chosen: chords of 4 mm on 2 m */
#define MUS__CUT_EDGES 32   /* most edges of a shape; chosen: those of a collar with joints at every seam */

typedef struct mus__cut_shape_side {
    const char *name, *label;
    double allowance; /* [m] */
    int32_t last;     /* point at its end */
} mus__cut_shape_side;

/* a panel of chords, counter-clockwise: its points, and the edges that end at some of them, the last at the first */
typedef struct mus__cut_shape {
    const char *label;
    double grain[2];
    bool full; /* it had no room for a point or an edge */
    int32_t nxy, nedge;
    double xy[MUS__CUT_POINTS][2];
    mus__cut_shape_side edge[MUS__CUT_EDGES];
} mus__cut_shape;

/* Gives a drafted pattern the panels that are cut and sewn but not draped; `scale` is mus__measures_scale() of the
 * wearer. Errors: MUS_ERR_MEMORY */
mus_status mus__cut_only_make(const mus__style *style, double scale, mus_pattern *pattern);

void mus__cut_strip_add(mus__cut_only *job, const mus__cut_strip *strip);

/* Begins a shape at a point; goes to the next point; makes the points since the last edge an edge. Names and labels
 * live as long as the shape. */
void mus__cut_shape_begin(mus__cut_shape *shape, const char *label, double x, double y);
void mus__cut_shape_to(mus__cut_shape *shape, double x, double y);
void mus__cut_shape_edge(mus__cut_shape *shape, const char *name, const char *label, double allowance);
/* Adds a shape as a panel that is cut `count` times of a material; returns it. */
int32_t mus__cut_shape_add(mus__cut_only *job, const mus__cut_shape *shape, const char *name, int32_t material,
                           int32_t count);
/* Adds a shape as NAME_left and its mirror image as NAME_right, each cut `count` times. */
void mus__cut_shape_pair(mus__cut_only *job, const mus__cut_shape *shape, const char *name, int32_t material,
                         int32_t count);

/* Draws the piece of a kangaroo pocket as it is marked; of a front that opens a mirrored pair. */
void mus__cut_kangaroo(mus__cut_only *job);
/* Draws the front pockets of trousers: bags and facings, and the line of the opening on the front legs of `pattern`. */
void mus__cut_front_pocket(mus__cut_only *job, mus_pattern *pattern);
/* Draws an under-collar for each collar with an outer edge; half of its pieces are then cut of that. */
void mus__cut_under_collars(mus__cut_only *job, mus_pattern *pattern);

/* Traces a facing of MUS__FACING along each run of edges with `label` of each panel that is no collar or hood, darts
 * closed; `ending` is added to the panel's name. */
void mus__cut_facings(mus__cut_only *job, const char *label, const char *ending);
/* Traces a fly facing of `width` [m] along the edge "zip" of the left front leg. */
void mus__cut_fly(mus__cut_only *job, double width);

#endif
