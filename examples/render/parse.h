/*
 * parse.h: numbers as text, without a locale; the rest of parse.c is in render.h.
 */
#ifndef RENDER_PARSE_H
#define RENDER_PARSE_H

#include "gl.h"

/** Read a decimal number; returns what follows it, NULL if there is none or it is not finite. */
const char *render_number_parse(const char *text, double *out);

#endif
