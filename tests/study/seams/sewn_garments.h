/*
 * sewn_garments.h: the garments of `make seams`: named designs and GarmentCode specifications with their true seams.
 */
#ifndef MUS_STUDY_SEWN_GARMENTS_H
#define MUS_STUDY_SEWN_GARMENTS_H

#include <stdbool.h>
#include "seam/seam_find.h"

enum { OF_SPECIFICATION, OF_DESIGN, OF_DRAWING, KINDS_OF_GARMENTS };

typedef struct garment {
    char name[128];
    int32_t kind; /* of the above */
    bool judged;
    bool part; /* of another garment: fitted, not counted */
    mus__seam_facts facts;
    int32_t *truth;
    mus_pattern *pattern;
    int32_t *found; /* the sewing that the search found last */
} garment;

typedef struct garments {
    garment *list;
    int32_t n;
    bool swap; /* the halves change places */
    bool mixed; /* of each family of designs some are fitted */
    bool drawn; /* there are drawings to fit: all specifications are judged */
} garments;

/* every N-th named design */
void garments_add_designs(garments *to, mus_context *context, int32_t every);

/* the GarmentCode drawings of a folder, one of five to judge, the others to fit; specifications are then all judged */
void garments_add_drawings(garments *to, mus_context *context, const char *folder);

/* the specifications of a data folder; with `parts` those of the fitted half also without some of their panels */
void garments_add_specifications(garments *to, mus_context *context, const char *data, bool parts);

#endif
