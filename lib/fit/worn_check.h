/*
 * worn_check.h: parts of the certificate mus_fit_worn() (worn.c), for runs that ask about these alone.
 */
#ifndef MUS_FIT_WORN_CHECK_H
#define MUS_FIT_WORN_CHECK_H

#include "muslin/fit.h"

/* the checks; a sum */
#define MUS__WORN_OPENINGS 1 /* every limb in its opening, none through the cloth */
#define MUS__WORN_HANGS 2    /* shoulders, heights, tightness: of a garment at rest */
#define MUS__WORN_SKIN 4     /* triangles through the skin, which take most of the time */
#define MUS__WORN_GIRTHS 8   /* openings too small for their limb: of the placement, before anything is sewn */

/* mus_fit_worn() with these checks alone: without MUS__WORN_SKIN, MUS_WORN_THROUGH is a limb through the cloth.
 * The fields through... of mus_worn are 0 without it */
mus_status mus__fit_worn(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body, int32_t parts,
                         mus_worn *out);

#endif
