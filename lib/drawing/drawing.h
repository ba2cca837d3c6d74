/*
 * drawing.h: a drawing (paths, each with a pen and a group), and helpers for memory.
 *
 * Units: metre, x right, y up; the writers turn and scale. Memory and failures go through the public functions of the
 * context, since libmuslin-print is a library apart from libmuslin.
 */
#ifndef MUS_DRAWING_DRAWING_H
#define MUS_DRAWING_DRAWING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "file/sink.h"
#include "muslin/print.h"

#define MUS__PRINT_PI 3.14159265358979323846 /* half a turn [rad], to the last bit of a double */

/* ---- helpers (drawing.c) ---- */
mus_status mus__print_memory(mus_context *context, const char *what);
/* write x [m] as millimetres with at most one decimal, in every locale; returns the number of characters */
int32_t mus__print_millimetres(char *out, size_t size, double x);
/* write x [m] as millimetres with four decimals at most, in every locale */
void mus__print_number(mus__sink *bytes, double x);
/* allocate `count` zeroed elements of `size` bytes; NULL when there is no memory or the product overflows */
void *mus__print_new(mus_context *context, int64_t count, size_t size);
void mus__print_free(mus_context *context, void *block);
/* grow *array (*capacity elements of `size` bytes) to hold `need` elements; after a failure it is unchanged */
mus_status mus__print_reserve(mus_context *context, void *array, int32_t *capacity, int64_t need, size_t size);

/* ---- a drawing ---- */
typedef enum mus__pen {
    MUS__PEN_CUT,    /* cut line: solid 0.5 mm */
    MUS__PEN_SEAM,   /* seam line: dashed 0.25 mm; no other pen has these dashes, so a reader can find seam lines */
    MUS__PEN_NOTCH,  /* slits */
    MUS__PEN_GRAIN,  /* grain line */
    MUS__PEN_MARK,   /* lines inside a piece: dashes more than three times as long, told apart by eye */
    MUS__PEN_TEXT,   /* letters */
    MUS__PEN_SMALL,  /* small letters */
    MUS__PEN_TITLE,  /* large letters */
    MUS__PEN_SQUARE, /* test squares */
    MUS__PEN_DRILL,  /* the point of a dart */
    MUS__PEN_FRAME,  /* edge of a page, page map */
    MUS__PEN_JOIN,   /* dashed line that the frame of the next page is laid on */
    MUS__PEN_FAINT,  /* letters beside the pattern */
    MUS__PEN_INK,    /* filled black */
    MUS__PEN_GREY,   /* filled grey */
    MUS__PEN_LETTER, MUS__PEN_LETTER_FAINT, /* letters of a font, and those beside the pattern: filled */
    MUS__PEN_COUNT
} mus__pen;

typedef struct mus__pen_style {
    double width;   /* [m], 0 for a filled path */
    double dash[2]; /* on, off [m]; 0 for solid */
    double grey;    /* 0 black .. 1 white */
} mus__pen_style;

extern const mus__pen_style mus__pen_styles[MUS__PEN_COUNT];

/* groups of a piece, in the order of drawing */
typedef enum mus__layer {
    MUS__LAYER_CUT,
    MUS__LAYER_SEAM,
    MUS__LAYER_NOTCHES,
    MUS__LAYER_GRAIN,
    MUS__LAYER_MARKS,
    MUS__LAYER_LABEL,
    MUS__LAYER_COUNT
} mus__layer;

typedef struct mus__path {
    int32_t piece; /* piece that the path belongs to, or MUS_NONE */
    mus__layer layer;
    mus__pen pen;
    int32_t edge;  /* edge of the pattern that the path draws or notches, or MUS_NONE */
    int32_t mark;  /* mark of the pattern that the path draws, or MUS_NONE; the path of its name has none */
    int32_t op, nop; /* first in ops, and how many */
    int32_t at;    /* first in xy */
    int32_t text;  /* text whose outline in a font the path is, or MUS_NONE */
    double box[4]; /* low x, low y, high x, high y of its points [m] */
} mus__path;

/* a text, for whoever reads the file as text */
typedef struct mus__text {
    int32_t at, n;               /* its UTF-8 in letters, without a zero byte */
    double x, y, height;         /* left end of the base line; height of a capital [m] */
    double cosine, sine;         /* direction of the base line */
    int32_t path;                /* its outline, of a text that is set in a font; MUS_NONE: strokes */
    bool bold;
} mus__text;

typedef struct mus__drawing {
    mus_context *context;
    mus_status status; /* first failure; later calls do nothing */
    int32_t npath, nop, nxy;
    int32_t path_room, op_room, xy_room;
    mus__path *paths;   /* (npath) */
    unsigned char *ops; /* (nop) 'm' and 'l' take one point, 'c' three, 'z' none */
    double *xy;         /* (nxy) x and y of each point [m] */
    int32_t ntext, text_room, nletter, letter_room;
    mus__text *texts; /* (ntext) */
    char *letters;    /* (nletter) */
    int32_t language;
    const struct mus__lettering *lettering; /* fonts for what is not drawn in strokes, or NULL */
} mus__drawing;

void mus__draw_init(mus__drawing *drawing, mus_context *context);
void mus__draw_free(mus__drawing *drawing);
void mus__draw_path(mus__drawing *drawing, int32_t piece, mus__layer layer, mus__pen pen);
/* set the edge of the path that was begun last */
void mus__draw_edge(mus__drawing *drawing, int32_t edge);
/* set the mark of the path that was begun last */
void mus__draw_mark(mus__drawing *drawing, int32_t mark);
void mus__draw_move(mus__drawing *drawing, double x, double y);
void mus__draw_line(mus__drawing *drawing, double x, double y);
void mus__draw_curve(mus__drawing *drawing, const double *xy); /* cubic: two control points and the end */
void mus__draw_close(mus__drawing *drawing);
void mus__draw_rectangle(mus__drawing *drawing, double x, double y, double width, double height);

#endif
