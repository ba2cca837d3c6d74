/*
 * measures.c: the measures of a completed tape as an array.
 */
#include "block/measures.h"

#include <math.h>


void mus__measures_read(const mus_tape *tape, mus__measures *out)
{
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) out->v[m] = mus_tape_value(tape, m);
    out->sex = mus_tape_sex(tape);
    out->front_waist_given = mus_tape_source(tape, MUS_MEASURE_FRONT_WAIST) == MUS_SOURCE_GIVEN;
}


double mus__measures_scale(const mus__measures *measures)
{
    return fmin(1.0, measures->v[MUS_MEASURE_BUST] / 0.80);
}


int mus__millimetres(double x)
{
    return (int)lround(1000.0 * fmax(-1e5, fmin(1e5, x)));
}
