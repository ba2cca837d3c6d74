/*
 * stroke_font.h: letters as strokes, and texts.
 */
#ifndef MUS_DRAWING_STROKE_FONT_H
#define MUS_DRAWING_STROKE_FONT_H

#include "drawing/drawing.h"

typedef struct mus__text_style {
    double height; /* of a capital [m] */
    double cosine; /* direction of the line of text: a unit vector */
    double sine;
    double align; /* 0: x is the left end, 0.5 the middle, 1 the right end */
} mus__text_style;

/* read the next character of UTF-8 text and advance *text; 0 at its end, U+FFFD for a wrong byte */
uint32_t mus__text_character(const char **text);
/* have the strokes all letters of a text, if only as their base letters? */
bool mus__text_has_strokes(const char *text);
/* bytes of a text that fit on a line of the width, with capitals of the height, broken at a blank; at least one
 * word */
size_t mus__text_line(const char *text, double height, double width);
/* width of UTF-8 text whose capitals have the height 1 */
double mus__text_width(const char *text);
/* advance of a character whose capitals have the height 1 */
double mus__text_advance(uint32_t code);
/* add text as strokes to the path that was begun last; its base line begins at (x, y) */
void mus__stroke_text(mus__drawing *drawing, const char *text, double x, double y, const mus__text_style *style);

/* ---- text.c ---- */

/* add text to the path that was begun last, as strokes, or set in a font where the drawing has one for it; its base
 * line goes through (x, y) */
void mus__draw_text(mus__drawing *drawing, const char *text, double x, double y, const mus__text_style *style);

#endif
