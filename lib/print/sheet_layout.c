/*
 * sheet_layout.c: the layout of the pieces: the place of each on the sheet, the grid of pages, and the pages that are
 * empty.
 *
 *      A1 | A2 | A3      A page prints a window, its paper less the margins. Windows are one step apart; a step is
 *      ---+----+---      the window less the overlap, so the sheet is columns x step + overlap wide. Rows count from
 *      B1 | B2 | B3      the top. Pages that have no line of their own are left out.
 *
 * When everything fits on one page with the test squares, there is no grid and no cover. Otherwise both ways round of
 * the paper and several widths of the sheet are tried, and the one with the fewest pages is taken.
 */
#include <math.h>
#include <string.h>

#include "file/pack.h"
#include "print/page.h"

#define PIECE_GAP 0.006      /* [m] distance of the boxes of two cut lines; chosen: scissors pass between two pieces */
/* [m] distance of cut lines from the edge of the printed window; chosen: a nearer line may be clipped */
#define SHEET_BORDER 0.003
/* widths of the sheet tried beyond the least, in columns; chosen: more seldom save a page */
#define MORE_COLUMNS 10
#define TILES_MAX 10000      /* most tiles of a sheet; chosen: a square of about 25 m on A4 */

/* clip the segment to the box (Liang and Barsky 1984); true when a part of it is left */
bool mus__segment_meets(const double *a, const double *b, const double *box)
{
    double from = 0.0, to = 1.0;
    for (int32_t k = 0; k < 2; k++) {
        double d = b[k] - a[k];
        if (d == 0.0) {
            if (a[k] < box[k] || a[k] > box[2 + k]) return false;
            continue;
        }
        double t = (box[k] - a[k]) / d, u = (box[2 + k] - a[k]) / d;
        from = fmax(from, t < u ? t : u);
        to = fmin(to, t < u ? u : t);
    }
    return from <= to;
}


bool mus__piece_meets(const mus__piece *piece, const double *box)
{
    if (box[0] > piece->box[2] || box[2] < piece->box[0] || box[1] > piece->box[3] || box[3] < piece->box[1])
        return false;

    double mx = 0.5 * (box[0] + box[2]), my = 0.5 * (box[1] + box[3]);
    bool inside = false;
    for (int32_t l = 0; l < piece->cut.nloop; l++) {
        int32_t start = piece->cut.start[l], end = piece->cut.start[l + 1];
        for (int32_t i = start; i < end; i++) {
            const double *a = piece->cut.xy + 2 * i, *b = piece->cut.xy + 2 * (i + 1 < end ? i + 1 : start);
            if (mus__segment_meets(a, b, box)) return true;
            if ((a[1] > my) != (b[1] > my) && mx < a[0] + (b[0] - a[0]) * (my - a[1]) / (b[1] - a[1])) inside = !inside;
        }
    }
    return inside;
}


void mus__tile_window(const mus_sheet *sheet, const mus__tile *tile, double *box)
{
    double margin = sheet->def.margin, overlap = sheet->def.overlap;
    double width = sheet->page[0] - 2.0 * margin, height = sheet->page[1] - 2.0 * margin;
    box[0] = tile->column * (width - overlap);
    box[3] = sheet->extent[1] - tile->row * (height - overlap);
    box[2] = box[0] + width;
    box[1] = box[3] - height;
}


int32_t mus__tile_find(const mus_sheet *sheet, int32_t column, int32_t row)
{
    for (int32_t i = 0; i < sheet->ntile; i++)
        if (sheet->tiles[i].column == column && sheet->tiles[i].row == row) return i;
    return MUS_NONE;
}


/* ---- the search ---- */

/* a layout of the sheet, with the arrays that the search needs */
typedef struct layout {
    double page[2];
    int32_t columns, rows, ntile;
    double *at;      /* (npiece + 1) x 2 low corners from the packer [m]; the last is that of the test squares */
    double *best_at; /* low corners of the best layout so far */
    double *size;    /* (npiece + 1) x 2 widths and heights [m] */
    double *sky;
    int32_t *work;
    mus__tile *tiles; /* tiles of the best layout so far */
    int32_t room;
} layout;


static void layout_free(mus_context *context, layout *l)
{
    mus__print_free(context, l->at);
    mus__print_free(context, l->best_at);
    mus__print_free(context, l->size);
    mus__print_free(context, l->sky);
    mus__print_free(context, l->work);
    mus__print_free(context, l->tiles);
}


static bool layout_new(const mus_sheet *sheet, layout *l)
{
    int64_t n = (int64_t)sheet->npiece + 1;
    l->at = mus__print_new(sheet->context, n, 2 * sizeof *l->at);
    l->best_at = mus__print_new(sheet->context, n, 2 * sizeof *l->at);
    l->size = mus__print_new(sheet->context, n, 2 * sizeof *l->size);
    l->sky = mus__print_new(sheet->context, 2 * n + 2, 3 * sizeof *l->sky);
    l->work = mus__print_new(sheet->context, n, sizeof *l->work);
    if (l->at == NULL || l->best_at == NULL || l->size == NULL || l->sky == NULL || l->work == NULL) return false;
    for (int32_t i = 0; i < sheet->npiece; i++) {
        l->size[2 * i] = sheet->pieces[i].box[2];
        l->size[2 * i + 1] = sheet->pieces[i].box[3];
    }
    return true;
}


/* pack a strip of `columns` pages: sets at and rows (on a roll also the page's height). False: a piece is too wide */
static bool layout_pack(const mus_sheet *sheet, layout *l, int32_t nbox, int32_t columns)
{
    double margin = sheet->def.margin, overlap = sheet->def.overlap;
    double width = columns * (l->page[0] - 2.0 * margin - overlap) + overlap - 2.0 * SHEET_BORDER;
    double used = mus__pack(nbox, l->size, width, PIECE_GAP, l->at, l->work, l->sky);
    if (used < 0.0) return false;

    double need = used + 2.0 * SHEET_BORDER;
    if (sheet->def.paper == MUS_PAPER_ROLL)
        l->page[1] = mus__roll_length(need + 2.0 * margin);
    double step = l->page[1] - 2.0 * margin - overlap, rows = ceil((need - overlap) / step - 1e-9);
    l->columns = columns;
    l->rows = rows < 1.0 ? 1 : rows > TILES_MAX ? TILES_MAX : (int32_t)rows;
    return true;
}


/* low corner of box i on the sheet: the packer fills upwards from (0, 0), the sheet from its top */
static void layout_corner(const mus_sheet *sheet, const layout *l, const double *at, int32_t i, double *out)
{
    double margin = sheet->def.margin, overlap = sheet->def.overlap;
    double top = l->rows * (l->page[1] - 2.0 * margin - overlap) + overlap - SHEET_BORDER;
    out[0] = at[2 * i] + SHEET_BORDER;
    out[1] = top - at[2 * i + 1] - l->size[2 * i + 1];
}


/* true when a piece meets a page; the pieces still have their low corners at the origin */
static bool layout_filled(const mus_sheet *sheet, const layout *l, int32_t column, int32_t row)
{
    double margin = sheet->def.margin, overlap = sheet->def.overlap, corner[2];
    double width = l->page[0] - 2.0 * margin, height = l->page[1] - 2.0 * margin;
    double left = column * (width - overlap), top = l->rows * (height - overlap) + overlap - row * (height - overlap);
    for (int32_t i = 0; i < sheet->npiece; i++) {
        layout_corner(sheet, l, l->at, i, corner);
        const double box[4] = {left - corner[0], top - height - corner[1], left + width - corner[0], top - corner[1]};
        if (mus__piece_meets(&sheet->pieces[i], box)) return true;
    }
    return false;
}


/* count the pages of the layout `l` that are not empty, and keep it in `best` when they are fewer */
static mus_status layout_compare(mus_sheet *sheet, layout *l, layout *best)
{
    mus_status status = mus__print_reserve(sheet->context, &l->tiles, &l->room, (int64_t)l->columns * l->rows,
                                           sizeof *l->tiles);
    if (status != MUS_OK) return status;
    l->ntile = 0;
    for (int32_t row = 0; row < l->rows; row++)
        for (int32_t column = 0; column < l->columns; column++)
            if (layout_filled(sheet, l, column, row)) l->tiles[l->ntile++] = (mus__tile){column, row};
    if (best->ntile > 0 && best->ntile <= l->ntile) return MUS_OK;

    status = mus__print_reserve(sheet->context, &sheet->tiles, &best->room, l->ntile, sizeof *sheet->tiles);
    if (status != MUS_OK) return status;
    memcpy(sheet->tiles, l->tiles, (size_t)l->ntile * sizeof *l->tiles);
    memcpy(l->best_at, l->at, 2 * (size_t)sheet->npiece * sizeof *l->at);
    memcpy(best->page, l->page, sizeof best->page);
    best->columns = l->columns;
    best->rows = l->rows;
    best->ntile = l->ntile;
    return MUS_OK;
}


/* try the widths of the sheet, from the least on, with the paper upright or landscape */
static mus_status layout_search(mus_sheet *sheet, layout *l, bool landscape, layout *best)
{
    double paper[2];
    mus__paper_size(sheet->def.paper, paper);
    l->page[0] = paper[landscape ? 1 : 0];
    l->page[1] = paper[landscape ? 0 : 1];
    double step = l->page[0] - 2.0 * sheet->def.margin - sheet->def.overlap, widest = 0.0;
    for (int32_t i = 0; i < sheet->npiece; i++) widest = fmax(widest, l->size[2 * i]);
    double least = ceil((widest + 2.0 * SHEET_BORDER - sheet->def.overlap) / step - 1e-9);
    if (least > TILES_MAX) least = TILES_MAX;

    mus_status status = MUS_OK;
    for (int32_t k = least < 1.0 ? 1 : (int32_t)least, last = k + MORE_COLUMNS; k <= last && status == MUS_OK; k++) {
        if (!layout_pack(sheet, l, sheet->npiece, k)) continue;
        if ((int64_t)l->columns * l->rows > TILES_MAX) continue;
        status = layout_compare(sheet, l, best);
        if (l->rows == 1) break;
    }
    return status;
}


/* try one page with all pieces and the test squares; false when they do not fit */
static bool layout_single(mus_sheet *sheet, layout *l, bool landscape)
{
    double paper[2];
    mus__paper_size(sheet->def.paper, paper);
    int32_t n = sheet->npiece;
    bool beside = paper[landscape ? 1 : 0] - 2.0 * sheet->def.margin >= 0.3;
    mus__squares_size(beside, l->size + 2 * n);
    l->page[0] = paper[landscape ? 1 : 0];
    l->page[1] = paper[landscape ? 0 : 1];
    if (!layout_pack(sheet, l, n + 1, 1) || l->rows > 1) return false;

    sheet->squares_beside = beside;
    layout_corner(sheet, l, l->at, n, sheet->squares);
    memcpy(l->best_at, l->at, 2 * (size_t)n * sizeof *l->at);
    return true;
}


static mus_status layout_find(mus_sheet *sheet, layout *l, layout *best)
{
    int32_t ways = sheet->def.paper == MUS_PAPER_ROLL ? 1 : 2;
    for (int32_t way = 0; way < ways; way++) {
        if (!layout_single(sheet, l, way == 1)) continue;
        sheet->tiles = mus__print_new(sheet->context, 1, sizeof *sheet->tiles);
        if (sheet->tiles == NULL) return mus__print_memory(sheet->context, "a page");
        memcpy(best->page, l->page, sizeof best->page);
        best->columns = best->rows = best->ntile = 1;
        return MUS_OK;
    }
    sheet->tiled = true;
    mus_status status = MUS_OK;
    for (int32_t way = 0; way < ways && status == MUS_OK; way++) status = layout_search(sheet, l, way == 1, best);
    if (status == MUS_OK && best->ntile == 0)
        status = mus__file_fail(sheet->context, MUS_ERR_LIMIT, "pattern %.100s: more than %d pages", sheet->title,
                                TILES_MAX);
    return status;
}


mus_status mus__sheet_layout(mus_sheet *sheet)
{
    layout l = {.room = 0}, best = {.room = 0};
    mus_status status = MUS_OK;
    if (!layout_new(sheet, &l)) status = mus__print_memory(sheet->context, "the layout of a sheet");
    if (status == MUS_OK) status = layout_find(sheet, &l, &best);
    if (status == MUS_OK) {
        double margin = sheet->def.margin, overlap = sheet->def.overlap, corner[2];
        memcpy(sheet->page, best.page, sizeof sheet->page);
        sheet->columns = best.columns;
        sheet->rows = best.rows;
        sheet->ntile = best.ntile;
        sheet->extent[0] = best.columns * (best.page[0] - 2.0 * margin - overlap) + overlap;
        sheet->extent[1] = best.rows * (best.page[1] - 2.0 * margin - overlap) + overlap;
        best.size = l.size;
        for (int32_t i = 0; i < sheet->npiece; i++) {
            layout_corner(sheet, &best, l.best_at, i, corner);
            mus__piece_move(&sheet->pieces[i], corner[0], corner[1]);
        }
    }
    layout_free(sheet->context, &l);
    return status;
}
