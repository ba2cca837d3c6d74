/*
 * drape_parts.h: the parts of a drape that sewing and settling (lib/dress) write, and that the drape owns and frees.
 */
#ifndef MUS_DRAPE_DRAPE_PARTS_H
#define MUS_DRAPE_DRAPE_PARTS_H

#include "base/base_internal.h"

/* how far nodes stay off the skin so that the triangles between them do (dress/chord_lift.c); NULL before it is used */
typedef struct mus__chord_lift_data {
    float *lift;    /* (n) beyond the clearance [m] */
    double *gap;    /* (n) scratch: off the skin [m] */
    double *lack;   /* (n) scratch: what the samples that the node bears lack to be clear [m] */
    double *around; /* (n) scratch: what all samples round it lack */
    double *normal; /* (n x 3) scratch: of the skin at the node */
} mus__chord_lift_data;

/* memory of sewing: one block, NULL before the first sew that needs it */
typedef struct mus__sewing {
    double *start_x;    /* (n x 3) where the first try began */
    double *unwelded_x; /* (n x 3) before a weld that may be taken back */
    double *outward;    /* (n x 3) unit at each node: out of its panel, away from its triangles */
    double *tube_gap;   /* (panels) largest gap of an open seam of a panel with itself [m] */
} mus__sewing;

/* a component of the garment: panels that hang together by seams. One record a panel; that of the lowest panel counts
 */
typedef struct mus__component {
    int32_t root;     /* lowest panel of the component */
    int32_t panel;    /* panel of its uppermost node at the start */
    double top;       /* height of that node along the torso [m]; -infinity: held up by attachments */
    double foot;      /* height of its lowest node as the pattern places it [m] */
    double high, low; /* heights of its uppermost and lowest node, as of the last look [m] */
} mus__component;

typedef struct mus__relaxation {
    double *mean;   /* (n x 3) mean place of the last steps; head of a block of arrays, NULL before the first use */
    double *before; /* (n x 3) mean place at the check before */
    double *went;   /* (n x 3) move of the mean place from the check before that to it [m] */
    double *left;   /* (n x 3) force left at the check before [N] */
    double *moving; /* (n x 3) force that moved each node in the mean of the last steps [N] */
    double *inertia;           /* (n x 6) inertia tensors of the last steps: xx, yy, zz, xy, yz, zx [kg] */
    double *bending;           /* (n) scratch: stiffness that is equal in all directions [N/m] */
    void *tensor;              /* (7 n) inverse tensors and masses, in the sim's precision (sim.h) */
    double rate2;              /* largest rate that a step of relaxation bears, squared [1/s2] */
    double raised;             /* factor on the inertia of all nodes that this takes, at least 1 */
    double *force;             /* (n x 3) force left at each node by the last residual [N] */
    mus__component *component; /* (npanel), NULL before the first settle round a body */
    double residual; /* rms of force left over weight at the end of the last settle; NaN: the cloth was moved since */
    double rest_distance; /* how far the farthest node is still expected to go, as of the last check [m] */
    int32_t settled;      /* nonzero: the last settle came to rest */
    int32_t goes;         /* nonzero: at the last check the cloth went on in the direction in which it came */
    int32_t far;          /* nonzero: not near rest, so that a settle begins on the coarse cut */
} mus__relaxation;

#endif
