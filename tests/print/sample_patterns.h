/*
 * sample_patterns.h: patterns for the tests of print, made through the public functions: a T-shirt-like set of pieces
 * with curves of every kind, allowances, notches, marks; a single polygon; long and tiny ones.
 */
#ifndef MUS_TESTS_SAMPLE_PATTERNS_H
#define MUS_TESTS_SAMPLE_PATTERNS_H

#include <stdbool.h>

#include "muslin/pattern.h"

/* front, back, sleeve (a mirrored one beside it), neck rib; NULL when anything failed */
mus_pattern *sample_shirt(mus_context *context);

/* one panel "piece" with a polygon as outline, one edge a side; NULL when anything failed */
mus_pattern *sample_polygon(mus_context *context, int32_t n, const double *xy);

#endif
