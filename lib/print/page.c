/*
 * page.c: everything on the pages except the pieces: test squares, the frame of a tile with its marks, the cover.
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

#include "print/page.h"

#define DIAMOND 0.004 /* [m] half the width of a diamond; chosen: large enough to lay halves on each other by eye */
/* [m] least width right of the squares, for text and page map; chosen: the shortest lines of text fit */
#define COVER_COLUMN 0.048
#define COVER_HEIGHT 0.255 /* [m] least height that the cover needs; chosen: fits Letter and A4 with a margin of 1 cm */


static void page_text(mus__drawing *out, mus__pen pen, const char *text, double x, double y, double height,
                      double align)
{
    const mus__text_style style = {height, 1.0, 0.0, align};
    mus__draw_path(out, MUS_NONE, MUS__LAYER_LABEL, pen);
    mus__draw_text(out, text, x, y, &style);
}


/* ---- test squares ---- */

static void page_square(mus__drawing *out, double x, double y, double size, const char *name, const char *hint)
{
    mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_SQUARE);
    mus__draw_rectangle(out, x, y, size, size);
    page_text(out, MUS__PEN_TEXT, name, x + 0.5 * size, y + 0.5 * size + 0.003, 0.006, 0.5);
    page_text(out, MUS__PEN_TEXT, hint, x + 0.5 * size, y + 0.5 * size - 0.007, 0.003, 0.5);
}


void mus__squares_draw(mus__drawing *out, double x, double y, bool beside)
{
    double top = beside ? y : y + MUS__INCH_4 + MUS__SQUARE_GAP, right = beside ? x + 0.1 + MUS__SQUARE_GAP : x;
    page_square(out, x, top, 0.1, "100 mm", "measure: print at 100 %, scale 1:1");
    page_square(out, right, y, MUS__INCH_4, "4 inch", "measure: print at 100 %, scale 1:1");
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
        page_text(out, MUS__PEN_FAINT, name, x - 0.002, my + 0.008, 0.0035, 1.0);
    }
    if (page_neighbour(sheet, tile, 0, 1, name, sizeof name)) {
        mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_JOIN);
        mus__draw_move(out, box[0], y);
        mus__draw_line(out, box[2], y);
        page_diamond(out, mx, y, DIAMOND, DIAMOND, over, DIAMOND);
        page_text(out, MUS__PEN_FAINT, name, mx + 0.008, y + 0.003, 0.0035, 0.0);
    }
    if (page_neighbour(sheet, tile, -1, 0, name, sizeof name)) {
        page_diamond(out, box[0], my, 0.0, DIAMOND, DIAMOND, DIAMOND);
        page_text(out, MUS__PEN_FAINT, name, box[0] + 0.002, my + 0.008, 0.0035, 0.0);
    }
    if (page_neighbour(sheet, tile, 0, -1, name, sizeof name)) {
        page_diamond(out, mx, box[3], DIAMOND, DIAMOND, DIAMOND, 0.0);
        page_text(out, MUS__PEN_FAINT, name, mx + 0.008, box[3] - 0.0065, 0.0035, 0.0);
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
    char text[256], name[16];
    mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_FRAME);
    mus__draw_rectangle(out, box[0], box[1], box[2] - box[0], box[3] - box[1]);
    if (!sheet->tiled) return;

    page_ruler(out, box);
    page_joins(sheet, &sheet->tiles[tile], out, box);
    mus__tile_name(&sheet->tiles[tile], name, sizeof name);
    page_text(out, MUS__PEN_FAINT, name, box[0] + 0.006, box[3] - 0.015, 0.009, 0.0);
    snprintf(text, sizeof text, "%.80s  page %d of %d  scale 1:1", sheet->title, tile + 2, sheet->ntile + 1);
    page_text(out, MUS__PEN_FAINT, text, box[0] + 0.006, box[3] - 0.020, 0.0022, 0.0);
}


/* ---- the cover ---- */

void mus__cover_size(const mus_sheet *sheet, double *out)
{
    /* the paper of the pages, or A4 for A0 and rolls, which a copy shop prints */
    int32_t paper = sheet->def.paper;
    mus__paper_size(paper == MUS_PAPER_A0 || paper == MUS_PAPER_ROLL ? MUS_PAPER_A4 : paper, out);
}


mus_status mus__cover_check(const mus_sheet *sheet)
{
    double size[2], width = MUS__INCH_4 + MUS__SQUARE_GAP + COVER_COLUMN;
    mus__cover_size(sheet, size);
    double x = 0.5 * (size[0] - width), y = 0.5 * (size[1] - COVER_HEIGHT), most = x < y ? x : y;
    if (sheet->def.margin <= most) return MUS_OK;
    char margin[32], limit[32];
    mus__print_millimetres(margin, sizeof margin, sheet->def.margin);
    mus__print_millimetres(limit, sizeof limit, most);
    return mus__file_fail(sheet->context, MUS_ERR_ARG,
                          "margin %s mm leaves no room for the test squares of the first page; at most %s mm", margin,
                          limit);
}


/* page map: pages, silhouettes and piece numbers, scaled to fit the box */
static void cover_map(const mus_sheet *sheet, mus__drawing *out, double x, double y, double width, double height)
{
    double sx = width / sheet->extent[0], sy = height / sheet->extent[1], s = sx < sy ? sx : sy;
    double low = y + height - s * sheet->extent[1], letter = 0.12 * s * sheet->page[0];
    letter = letter > 0.003 ? 0.003 : letter;
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const mus__loops *cut = &sheet->pieces[i].cut;
        mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_GREY);
        for (int32_t l = 0; l < cut->nloop; l++) {
            double last[2] = {0, 0};
            for (int32_t k = cut->start[l]; k < cut->start[l + 1]; k++) {
                /* points nearer to each other than 0.1 mm on the map become one */
                const double p[2] = {x + s * cut->xy[2 * k], low + s * cut->xy[2 * k + 1]};
                double dx = p[0] - last[0], dy = p[1] - last[1];
                if (k > cut->start[l] && dx * dx + dy * dy < 1e-8) continue;
                if (k == cut->start[l]) mus__draw_move(out, p[0], p[1]);
                else mus__draw_line(out, p[0], p[1]);
                memcpy(last, p, sizeof last);
            }
            mus__draw_close(out);
        }
    }
    for (int32_t i = 0; i < sheet->ntile; i++) {
        char name[16];
        double box[4];
        mus__tile_window(sheet, &sheet->tiles[i], box);
        mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_FRAME);
        mus__draw_rectangle(out, x + s * box[0], low + s * box[1], s * (box[2] - box[0]), s * (box[3] - box[1]));
        mus__tile_name(&sheet->tiles[i], name, sizeof name);
        page_text(out, MUS__PEN_FAINT, name, x + s * 0.5 * (box[0] + box[2]),
                  low + s * 0.5 * (box[1] + box[3]) - 0.5 * letter, letter, 0.5);
    }
}


/* one line of text for each piece, down to the height `low` */
static void cover_pieces(const mus_sheet *sheet, mus__drawing *out, double x, double y, double low)
{
    for (int32_t i = 0; i < sheet->npiece && y > low; i++, y -= 0.0055) {
        const mus__piece *piece = &sheet->pieces[i];
        char text[256];
        bool last = y - 0.0055 <= low && i + 1 < sheet->npiece;
        snprintf(text, sizeof text, "%d", i + 1);
        if (!last) page_text(out, MUS__PEN_TEXT, text, x + 0.005, y, 0.0025, 1.0);
        if (last) snprintf(text, sizeof text, "and %d more", sheet->npiece - i);
        else {
            char cut[64];
            mus__piece_cut_text(piece, cut, sizeof cut);
            snprintf(text, sizeof text, "%.40s: c%s", sheet->names[i], cut + 1);
        }
        for (char *c = text; *c != '\0'; c++) *c = *c == '_' ? ' ' : *c;
        page_text(out, MUS__PEN_TEXT, text, x + 0.0075, y, 0.0025, 0.0);
        if (last) return;
    }
}


void mus__cover_draw(const mus_sheet *sheet, mus__drawing *out)
{
    static const char *const steps[] = {
        "Print at 100 %, never \"fit to page\", and measure both squares before cutting.",
        "Cut off the left and upper margins along the frame; lay each page on its neighbours so that the",
        "frame lies on their dashed line and the diamonds are whole.",
        "Solid line: cut. Dashed line: sew. Double arrow: grain. Short strokes on the cut line: notches."};
    double size[2], margin = sheet->def.margin;
    mus__cover_size(sheet, size);
    double left = margin, right = size[0] - margin, y = size[1] - margin;
    char text[256];

    /* title, as large as fits */
    double letter = 0.008, width = mus__text_width(sheet->title);
    if (letter * width > right - left) letter = (right - left) / width;
    page_text(out, MUS__PEN_TITLE, sheet->title, left, y -= letter + 0.001, letter, 0.0);
    snprintf(text, sizeof text, "%s%.100s%s%d page%s after this one, %d x %d, scale 1:1",
             sheet->person != NULL ? "For " : "", sheet->person != NULL ? sheet->person : "",
             sheet->person != NULL ? ".  " : "", sheet->ntile, sheet->ntile == 1 ? "" : "s", sheet->columns,
             sheet->rows);
    double small = 0.003, span = mus__text_width(text);
    if (small * span > right - left) small = (right - left) / span;
    page_text(out, MUS__PEN_TEXT, text, left, y -= 0.007, small, 0.0);

    /* test squares on the left, list and page map on the right, instructions below */
    double squares[2];
    mus__squares_size(false, squares);
    double top = y - 0.005, low = top - squares[1];
    double column = left + squares[0] + MUS__SQUARE_GAP, space = right - column;
    double list = 0.0055 * sheet->npiece;
    if (list > 0.4 * squares[1]) list = 0.4 * squares[1];
    mus__squares_draw(out, left, low, false);
    cover_pieces(sheet, out, column, top - 0.0025, top - list);
    cover_map(sheet, out, column, low, space, squares[1] - list - 0.004);
    letter = 0.0025;
    for (int32_t i = 0; i < 4; i++)
        if (letter * mus__text_width(steps[i]) > right - left) letter = (right - left) / mus__text_width(steps[i]);
    for (int32_t i = 0; i < 4; i++)
        page_text(out, MUS__PEN_TEXT, steps[i], left, low - 0.007 - 0.005 * i, letter, 0.0);
}
