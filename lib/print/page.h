/*
 * page.h: paper, and what stands on the pages beside the pieces.
 */
#ifndef MUS_PRINT_PAGE_H
#define MUS_PRINT_PAGE_H

#include "print/sheet.h"

#define MUS__INCH_4 0.1016     /* [m] side of the test square of 4 inches */
#define MUS__SQUARE_GAP 0.006 /* [m] between the two test squares; chosen */

/* width and height of a paper held upright */
void mus__paper_size(int32_t paper, double *out);
/* refuse paper that its margins and overlap use up */
mus_status mus__paper_check(const mus_sheet *sheet);
/* [m] length of the page of a roll that holds `length`: whole points, within what PDF allows */
double mus__roll_length(double length);

/* ---- what stands on pages beside the pieces (page.c), in the page's own coordinates ---- */

/* 100 mm and 4 inch square, side by side or one above the other, low corner at (x, y) */
void mus__squares_size(bool beside, double *out);
void mus__squares_draw(mus__drawing *out, double x, double y, bool beside);
/* "B3" */
void mus__tile_name(const mus__tile *tile, char *out, size_t size);
/* frame, marks and names of a tile */
void mus__tile_draw(const mus_sheet *sheet, int32_t tile, mus__drawing *out);
/* the first page of a tiled sheet: title, test squares, page map. Refused when the margins leave too little for it */
mus_status mus__cover_check(const mus_sheet *sheet);
void mus__cover_size(const mus_sheet *sheet, double *out);
void mus__cover_draw(const mus_sheet *sheet, mus__drawing *out);

#endif
