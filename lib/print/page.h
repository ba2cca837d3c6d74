/*
 * page.h: sizes of paper, and everything on the pages except the pieces.
 */
#ifndef MUS_PRINT_PAGE_H
#define MUS_PRINT_PAGE_H

#include "print/sheet.h"

#define MUS__INCH_4 0.1016     /* [m] side of the test square of 4 inches */
#define MUS__SQUARE_GAP 0.006 /* [m] distance of the two test squares; chosen: a ruler can be laid on either */

/* width and height of a paper held upright */
void mus__paper_size(int32_t paper, double *out);
/* MUS_ERR_ARG when margins and overlap leave too little of the paper */
mus_status mus__paper_check(const mus_sheet *sheet);
/* length [m] of the page of a roll that holds `length` [m]: whole points, between the shortest and the longest page */
double mus__roll_length(double length);

/* ---- pages without their pieces (page.c), in coordinates of the page ---- */

/* width and height [m] of both test squares, 100 mm and 4 inches, side by side or one above the other */
void mus__squares_size(bool beside, double *out);
void mus__squares_draw(mus__drawing *out, double x, double y, bool beside);
/* name of a tile by row and column, such as "B3" */
void mus__tile_name(const mus__tile *tile, char *out, size_t size);
/* draw the frame of a tile, its marks and the names of its neighbours */
void mus__tile_draw(const mus_sheet *sheet, int32_t tile, mus__drawing *out);
/* MUS_ERR_ARG when the margins leave too little paper for the cover, the first page of a tiled sheet */
mus_status mus__cover_check(const mus_sheet *sheet);
void mus__cover_size(const mus_sheet *sheet, double *out);
void mus__cover_draw(const mus_sheet *sheet, mus__drawing *out);

#endif
