/*
 * measures.h: the measures of one person as an array, as every block reads them.
 */
#ifndef MUS_MEASURES_H
#define MUS_MEASURES_H

#include <stdbool.h>
#include <stdint.h>

#include "base/base_internal.h"
#include "muslin/tape.h"

#define MUS__CM 0.01                       /* [m] */
#define MUS__DEGREE 0.017453292519943295   /* [rad] */

typedef struct mus__measures {
    double v[MUS_MEASURE_COUNT]; /* [m] or [rad], all set; by MUS_MEASURE_* */
    int32_t sex;                 /* MUS_SEX_* */
    bool front_waist_given;      /* the front waist length was measured, so it decides the dart angle */
} mus__measures;

/* Copies all measures of a complete tape. */
void mus__measures_read(const mus_tape *tape, mus__measures *out);
/* Factor k of eases that are given in centimetres: min(1, bust / 80 cm), so that small bodies have less. */
double mus__measures_scale(const mus__measures *measures);
/* x [m] rounded to whole millimetres, for messages; limited to 100 km. */
int mus__millimetres(double x);

#endif
