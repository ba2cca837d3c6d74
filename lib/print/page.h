/*
 * page.h: sizes of paper, and everything on the pages except the pieces.
 */
#ifndef MUS_PRINT_PAGE_H
#define MUS_PRINT_PAGE_H

#include "print/sheet.h"

#define MUS__SQUARES 0.1016 /* [m] side of the test square of 4 inches; that of 100 mm lies in its middle */

/* width and height of a paper held upright */
void mus__paper_size(int32_t paper, double *out);
/* MUS_ERR_ARG when margins and overlap leave too little of the paper */
mus_status mus__paper_check(const mus_sheet *sheet);
/* length [m] of the page of a roll that holds `length` [m]: whole points, between the shortest and the longest page */
double mus__roll_length(double length);

/* write a text: left end (align 0), middle (0.5) or right end (1) of its base line at (x, y), capitals `height` high */
void mus__page_text(mus__drawing *out, mus__pen pen, const char *text, double x, double y, double height, double align);
/* write a text on a line from `left` to `right`, at the end that the language of the drawing begins at */
void mus__page_line(mus__drawing *out, mus__pen pen, const char *text, double left, double right, double y,
                    double height);

/* ---- pages without their pieces (page.c, cover.c), in coordinates of the page ---- */

/* draw the test squares, 100 mm inside 4 inches, with their low corner at (x, y) */
void mus__squares_draw(mus__drawing *out, double x, double y);
/* name of a tile by row and column, such as "B3" */
void mus__tile_name(const mus__tile *tile, char *out, size_t size);
/* draw the frame of a tile, its marks and the names of its neighbours */
void mus__tile_draw(const mus_sheet *sheet, int32_t tile, mus__drawing *out);
/* has a tiled sheet so many pages that its cover is a page of its own? */
bool mus__cover_own(const mus_sheet *sheet);
/* MUS_ERR_ARG when the margins leave too little paper for the cover, the first page of a tiled sheet */
mus_status mus__cover_check(const mus_sheet *sheet);
void mus__cover_size(const mus_sheet *sheet, double *out);
void mus__cover_draw(const mus_sheet *sheet, mus__drawing *out);
/* the pieces of a sheet, seen by who looks for a free box */
typedef struct mus__ground {
    bool (*taken)(const void *user, const double *box,
                  double *at);                         /* does a piece meet it? at (2) gets a point where */
    bool (*held)(const void *user, const double *box); /* does it lie inside a piece, clear of lines? */
    const void *user;
} mus__ground;

/* find places on the pages of a tiled sheet of few pages for the test squares (at `corner`, unless NULL) and for title
 * and instructions, between the pieces, else inside one: sets squares, legend, and cover (false when both are found) */
void mus__legend_place(mus_sheet *sheet, const mus__ground *ground, const double *corner);
/* find a place that holds notes and list of pieces too, which sets `full`, and make the page of the legend the first */
void mus__legend_fill(mus_sheet *sheet, const mus__ground *ground);
/* draw title and instructions on the sheet, at `legend` */
void mus__legend_draw(const mus_sheet *sheet, mus__drawing *out);

/* write the text of an SVG element: markup characters escaped, characters that XML or UTF-8 do not allow as '?' */
void mus__svg_text(mus__sink *bytes, const char *text);

#endif
