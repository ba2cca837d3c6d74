/*
 * fit_internal.h: the data of a fit.
 */
#ifndef MUS_DRAPE_FIT_INTERNAL_H
#define MUS_DRAPE_FIT_INTERNAL_H

#include "drape/drape_state.h"
#include "drape/residual.h"
#include "muslin/fit.h"

#define MUS__FIT_LEVELS 10

struct mus_fit {
    mus_context *context;
    int32_t n, nlevel;
    double *warp; /* (n) and the next four, one block */
    double *weft, *pressure, *gap, *area;
    mus_fit_level level[MUS__FIT_LEVELS];
};

/* strains and areas at the nodes: fit.warp, weft, area, zeroed before (fit.c) */
void mus__fit_strains(mus_fit *fit, const mus_drape *drape);

/* the levels that the garment goes round; needs gap (fit_girths.c) */
mus_status mus__fit_levels(mus_fit *fit, const mus_drape *drape, const mus_body *body);

#endif
