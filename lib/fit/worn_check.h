/*
 * worn_check.h: parts of the certificate mus_fit_worn() (worn.c), for runs that ask about these alone.
 */
#ifndef MUS_FIT_WORN_CHECK_H
#define MUS_FIT_WORN_CHECK_H

#include "muslin/fit.h"

/* beside the openings and limbs through the cloth, which are always looked at; a sum */
#define MUS__WORN_HANGS 1 /* shoulders, heights, tightness: of a garment at rest */
#define MUS__WORN_SKIN 2  /* triangles through the skin, which take most of the time */

/* mus_fit_worn() with these checks alone: without MUS__WORN_SKIN, MUS_WORN_THROUGH is a limb through the cloth.
 * The fields through... of mus_worn are 0 without it */
mus_status mus__fit_worn(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body, int32_t parts,
                         mus_worn *out);

#endif
