/*
 * lettering.h: the letters of a sheet: strokes of its own (stroke_font.c), or a font of the machine.
 *
 * English is drawn in strokes, so that its paper depends on no font. A text of another language, and a text with
 * letters that the strokes do not have, is set in a font: shaped, from right to left where it is written so. On paper
 * it is real text with its font in the file; other writers get its outlines.
 *
 * Two files hold the same functions, and the build takes one: lettering_pango.c (Pango beside cairo), and
 * lettering_strokes.c (MUS_STROKES_ONLY defined), which has strokes for everything.
 */
#ifndef MUS_DRAWING_LETTERING_H
#define MUS_DRAWING_LETTERING_H

#include <cairo.h>

#include "drawing/stroke_font.h"

typedef struct mus__lettering mus__lettering;

/* make the letters of a language; mus__lettering_free() takes NULL */
mus_status mus__lettering_make(mus_context *context, int32_t language, mus__lettering **out);
void mus__lettering_free(mus__lettering *lettering);
/* is a text set in a font? Not with `lettering` NULL */
bool mus__lettering_sets(const mus__lettering *lettering, const char *text);
/* width of a text whose capitals have the height 1 */
double mus__lettering_width(const mus__lettering *lettering, const char *text, bool bold);
/* bytes of a text that fit on a line of the width, with capitals of the height, without the blank that is broken at; at
 * least one letter */
size_t mus__lettering_line(const mus__lettering *lettering, const char *text, double height, double width);
/* add the outline of a text to the path that was begun last; its base line begins at (x, y) */
void mus__lettering_outline(const mus__lettering *lettering, mus__drawing *drawing, const char *text, double x,
                            double y, const mus__text_style *style, bool bold);
/* show a text as text: its base line begins at (x, y) of the page [points, y down]; capitals are `height` high */
void mus__lettering_show(const mus__lettering *lettering, cairo_t *cairo, const char *text, const double *xy,
                         double height, const mus__text_style *style, bool bold);

#endif
