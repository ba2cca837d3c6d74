/*
 * page.c: the test squares, and the frame of a tile with its marks.
 *
 * Putting tiles together: the left and the upper margin of a page are cut off along the frame; the page is laid on its
 * left and upper neighbours so that its frame lies on their dashed line. A diamond stands on the middle of each shared
 * edge, whole on the page below and halved by the frame on the page above, so that the halves meet the whole:
 *
 *     +------------:--+        A1 with the dashed line where A2's frame comes to lie,
 *     |  A1        :A2|        the overlap right of it
 *     |           <:> |
 *     +............:..+
 */
#include <stdio.h>
#include <string.h>

#include "drawing/phrase.h"
#include "print/page.h"

#define DIAMOND 0.004 /* [m] half the width of a diamond; chosen: large enough to lay halves on each other by eye */


void mus__page_text(mus__drawing *out, mus__pen pen, const char *text, double x, double y, double height,
                    double align)
{
    const mus__text_style style = {height, 1.0, 0.0, align};
    mus__draw_path(out, MUS_NONE, MUS__LAYER_LABEL, pen);
    mus__draw_text(out, text, x, y, &style);
}


void mus__page_line(mus__drawing *out, mus__pen pen, const char *text, double left, double right, double y,
                    double height)
{
    const bool from_right = mus_language_is_right_to_left(out->language) != 0;
    mus__page_text(out, pen, text, from_right ? right : left, y, height, from_right ? 1.0 : 0.0);
}


/* ---- test squares ---- */

void mus__squares_draw(mus__drawing *out, double x, double y)
{
    const double gap = 0.5 * (MUS__SQUARES - 0.1), middle = x + 0.5 * MUS__SQUARES;
    mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_SQUARE);
    mus__draw_rectangle(out, x, y, MUS__SQUARES, MUS__SQUARES);
    mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_SQUARE);
    mus__draw_rectangle(out, x + gap, y + gap, 0.1, 0.1);
    mus__page_text(out, MUS__PEN_TEXT, mus_language_text(out->language, "paper.inner"), middle, y + 0.056, 0.005, 0.5);
    mus__page_text(out, MUS__PEN_TEXT, mus_language_text(out->language, "paper.outer"), middle, y + 0.046, 0.005, 0.5);
    mus__page_text(out, MUS__PEN_TEXT, mus_language_text(out->language, "paper.measure"), middle, y + 0.038, 0.003,
                   0.5);
}


/* ---- a tile ---- */

void mus__tile_name(const mus__tile *tile, char *out, size_t size)
{
    /* rows: A .. Z, then AA, AB .. */
    char letters[8];
    int32_t at = 7, row = tile->row;
    letters[at] = '\0';
    for (; at > 0 && row >= 0; row = row / 26 - 1) letters[--at] = (char)('A' + row % 26);
    snprintf(out, size, "%s%d", letters + at, tile->column + 1);
}


static void page_diamond(mus__drawing *out, double x, double y, double left, double right, double down, double up)
{
    mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_INK);
    mus__draw_move(out, x - left, y);
    mus__draw_line(out, x, y - down);
    mus__draw_line(out, x + right, y);
    mus__draw_line(out, x, y + up);
    mus__draw_close(out);
}


/* name of the page on the other side of an edge of a tile; false when there is none */
static bool page_neighbour(const mus_sheet *sheet, const mus__tile *tile, int32_t right, int32_t down, char *name,
                           size_t size)
{
    int32_t other = mus__tile_find(sheet, tile->column + right, tile->row + down);
    if (other == MUS_NONE) return false;
    char own[16];
    mus__tile_name(&sheet->tiles[other], own, sizeof own);
    snprintf(name, size, right > 0 ? "%s >" : right < 0 ? "< %s" : down > 0 ? "v %s" : "^ %s", own);
    return true;
}


/* marks on shared edges: dashed line and whole diamond right and below, half diamonds left and above */
static void page_joins(const mus_sheet *sheet, const mus__tile *tile, mus__drawing *out, const double *box)
{
    char name[32];
    double overlap = sheet->def.overlap, over = overlap < DIAMOND ? overlap : DIAMOND;
    double mx = 0.5 * (box[0] + box[2]), my = 0.5 * (box[1] + box[3]), x = box[2] - overlap, y = box[1] + overlap;
    if (page_neighbour(sheet, tile, 1, 0, name, sizeof name)) {
        mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_JOIN);
        mus__draw_move(out, x, box[1]);
        mus__draw_line(out, x, box[3]);
        page_diamond(out, x, my, DIAMOND, over, DIAMOND, DIAMOND);
        mus__page_text(out, MUS__PEN_FAINT, name, x - 0.002, my + 0.008, 0.0035, 1.0);
    }
    if (page_neighbour(sheet, tile, 0, 1, name, sizeof name)) {
        mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_JOIN);
        mus__draw_move(out, box[0], y);
        mus__draw_line(out, box[2], y);
        page_diamond(out, mx, y, DIAMOND, DIAMOND, over, DIAMOND);
        mus__page_text(out, MUS__PEN_FAINT, name, mx + 0.008, y + 0.003, 0.0035, 0.0);
    }
    if (page_neighbour(sheet, tile, -1, 0, name, sizeof name)) {
        page_diamond(out, box[0], my, 0.0, DIAMOND, DIAMOND, DIAMOND);
        mus__page_text(out, MUS__PEN_FAINT, name, box[0] + 0.002, my + 0.008, 0.0035, 0.0);
    }
    if (page_neighbour(sheet, tile, 0, -1, name, sizeof name)) {
        page_diamond(out, mx, box[3], DIAMOND, DIAMOND, DIAMOND, 0.0);
        mus__page_text(out, MUS__PEN_FAINT, name, mx + 0.008, box[3] - 0.0065, 0.0035, 0.0);
    }
}


/* a ruler along the left and the upper edge, one tick for each centimetre */
static void page_ruler(mus__drawing *out, const double *box)
{
    mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_FRAME);
    for (int32_t i = 1; box[0] + 0.01 * i < box[2]; i++) {
        mus__draw_move(out, box[0] + 0.01 * i, box[3]);
        mus__draw_line(out, box[0] + 0.01 * i, box[3] - (i % 5 == 0 ? 0.0025 : 0.0015));
    }
    for (int32_t i = 1; box[3] - 0.01 * i > box[1]; i++) {
        mus__draw_move(out, box[0], box[3] - 0.01 * i);
        mus__draw_line(out, box[0] + (i % 5 == 0 ? 0.0025 : 0.0015), box[3] - 0.01 * i);
    }
}


void mus__tile_draw(const mus_sheet *sheet, int32_t tile, mus__drawing *out)
{
    double margin = sheet->def.margin;
    const double box[4] = {margin, margin, sheet->page[0] - margin, sheet->page[1] - margin};
    char text[256], name[16], title[96];
    mus__phrase phrase = mus__phrase_in(sheet->language);
    mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_FRAME);
    mus__draw_rectangle(out, box[0], box[1], box[2] - box[0], box[3] - box[1]);
    if (!sheet->tiled) return;

    page_ruler(out, box);
    page_joins(sheet, &sheet->tiles[tile], out, box);
    mus__tile_name(&sheet->tiles[tile], name, sizeof name);
    mus__page_text(out, MUS__PEN_FAINT, name, box[0] + 0.006, box[3] - 0.015, 0.009, 0.0);
    snprintf(title, sizeof title, "%.80s", sheet->title);
    mus__phrase_text(&phrase, 0, title);
    mus__phrase_number(&phrase, 1, tile + 1 + sheet->cover);
    mus__phrase_number(&phrase, 2, sheet->ntile + sheet->cover);
    mus__phrase_write(&phrase, "paper.tile", text, sizeof text);
    mus__page_text(out, MUS__PEN_FAINT, text, box[0] + 0.006, box[3] - 0.020, 0.0022, 0.0);
}
