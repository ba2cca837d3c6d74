/*
 * sheet_layout.c: the layout of the pieces: the place of each on the sheet, the grid of pages, and the pages that are
 * empty.
 *
 *      A1 | A2 | A3      A page prints a window, its paper less the margins. Windows are one step apart; a step is
 *      ---+----+---      the window less the overlap, so the sheet is columns x step + overlap wide. Rows count from
 *      B1 | B2 | B3      the top. Pages that have no line of their own are left out.
 *
 * When everything fits on one page with the test squares, there is no grid and no cover. Otherwise both ways round of
 * the paper, several widths of the sheet and several orders of the pieces are tried, and the layout with the fewest
 * pages is taken, of several the one with the shortest long side, which finds room on a table. The sizes of a piece (a
 * nest) lie on each other and are placed as one.
 */
#include <math.h>
#include <string.h>

#include "print/outline_pack.h"
#include "print/page.h"

#define PIECE_GAP 0.004 /* [m] distance of two cut lines; chosen: scissors pass between two pieces */
/* [m] distance of cut lines from the edge of the printed window: twice their width, so that they are drawn whole */
#define SHEET_BORDER 0.001
/* widths of the sheet tried beyond the least, in columns; chosen: more seldom save a page */
#define MORE_COLUMNS 10
/* orders of the pieces: sorted ones, tried for each width, and steps from each of them, tried for each width whose
 * sorted ones took at most a page more than the best; chosen: twice as many seldom save a page */
#define SORTED 3
#define STEPS 6
#define WAYS 8            /* ways round of a shape: mirrored or not in two directions, and turned by a quarter or not */
#define CLIMBED_PAGES 100 /* pages of a sheet whose orders are changed by steps; chosen: nobody tapes more */
/* [m] widths of the slabs of the packer, for the first search and for the last; the fine one costs three times as much
 * and loses less than 2 mm beside an upright line */
#define SLAB_COARSE 0.005
#define SLAB_FINE 0.002
#define TILES_MAX 10000      /* most tiles of a sheet; chosen: a square of about 25 m on A4 */


/* ---- the search ---- */

/* a layout of the sheet: where each nest lies, and the pages that it fills */
typedef struct layout {
    double page[2];
    int32_t columns, rows, ntile;
    bool squares;       /* the test squares are packed too */
    bool cover;         /* title and test squares find no place on the pages */
    double used;        /* height that the pieces take [m] */
    double reach;       /* longer side of the sheet [m] */
    double offset[2];   /* of the pieces from the left and from the top of the sheet, within what is free [m] */
    mus__place *places; /* (nnest + 1) the last is that of the test squares, when they are packed */
} layout;

/* what the search needs: the pieces as shapes, and room */
typedef struct search {
    int32_t n;         /* nests */
    double *runs;      /* boxes of runs of sides, of all pieces (mus__piece_runs) */
    int32_t *run;      /* (pieces) first box of each piece */
    double *box;       /* (n + 1) x 4 low x, low y, high x, high y of all sizes of a nest [m] */
    mus__shape *shapes; /* (n + 1) */
    mus__shape *lying;  /* (n) the same, turned by a quarter, on a sheet of halves */
    int32_t *order;    /* (n + 1) in which the shapes are packed */
    int32_t *kept;     /* (n + 1) x 2 a kept order, and the way round that each shape is tried in first */
    mus__strip strip;
    int32_t tile_room;
    int32_t *pages;                     /* (TILES_MAX) for the count of pages while shapes are packed */
    bool by_page;                       /* shapes are packed where they take fewest pages */
    int32_t least[2][MORE_COLUMNS + 1]; /* pages of the best layout of each width, upright and landscape; 0: none */
    mus_status status;
    layout now, best;
} search;


static void search_free(const mus_sheet *sheet, search *s)
{
    mus_context *context = sheet->context;
    for (int32_t i = 0; i <= s->n && s->shapes != NULL; i++) mus__shape_free(context, &s->shapes[i]);
    for (int32_t i = 0; i < s->n && s->lying != NULL; i++) mus__shape_free(context, &s->lying[i]);
    mus__strip_free(context, &s->strip);
    mus__print_free(context, s->runs);
    mus__print_free(context, s->run);
    mus__print_free(context, s->box);
    mus__print_free(context, s->shapes);
    mus__print_free(context, s->lying);
    mus__print_free(context, s->order);
    mus__print_free(context, s->kept);
    mus__print_free(context, s->pages);
    mus__print_free(context, s->now.places);
    mus__print_free(context, s->best.places);
}


/* the shape of all sizes of a nest */
static mus_status search_shape(const mus_sheet *sheet, search *s, int32_t nest, double slab)
{
    const mus__piece *pieces = sheet->pieces + nest * sheet->nsize;
    const mus__loops *loops[MUS__SIZES_MOST];
    double *box = s->box + 4 * nest;
    memcpy(box, pieces->box, sizeof pieces->box);
    for (int32_t k = 0; k < sheet->nsize; k++) {
        loops[k] = &pieces[k].cut;
        for (int32_t d = 0; d < 2; d++) {
            box[d] = fmin(box[d], pieces[k].box[d]);
            box[2 + d] = fmax(box[2 + d], pieces[k].box[2 + d]);
        }
    }
    mus_status status = mus__shape_make(sheet->context, sheet->nsize, loops, box, PIECE_GAP, slab, &s->shapes[nest]);
    if (status == MUS_OK && sheet->def.fold) {
        status = mus__shape_make_lying(sheet->context, sheet->nsize, loops, box, PIECE_GAP, slab, &s->lying[nest]);
        s->shapes[nest].lying = &s->lying[nest];
    }
    s->shapes[nest].turns = sheet->def.fold != 0;
    s->shapes[nest].flips = pieces->fold;
    return status;
}


/* make the shapes of all nests and of the test squares, in slabs of the given width, and the strip for them */
static mus_status search_shapes(const mus_sheet *sheet, search *s, double slab)
{
    const int32_t n = s->n;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i <= n; i++) mus__shape_free(sheet->context, &s->shapes[i]);
    for (int32_t i = 0; i < n; i++) mus__shape_free(sheet->context, &s->lying[i]);
    mus__strip_free(sheet->context, &s->strip);
    for (int32_t i = 0; i < n && status == MUS_OK; i++) status = search_shape(sheet, s, i, slab);

    /* the test squares, as a piece of their own */
    double squares[8] = {0.0, 0.0, MUS__SQUARES, 0.0, MUS__SQUARES, MUS__SQUARES, 0.0, MUS__SQUARES};
    int32_t start[2] = {0, 4};
    const mus__loops square = {1, 4, start, squares}, *loops[1] = {&square};
    s->box[4 * n + 2] = s->box[4 * n + 3] = MUS__SQUARES;
    if (status == MUS_OK)
        status = mus__shape_make(sheet->context, 1, loops, s->box + 4 * n, PIECE_GAP, slab, &s->shapes[n]);

    double widest = 0.0, paper[2];
    mus__paper_size(sheet->def.paper, paper);
    for (int32_t i = 0; i < n; i++) widest = fmax(widest, mus__shape_narrow(&s->shapes[i]));
    widest += (MORE_COLUMNS + 2) * fmax(paper[0], sheet->def.paper == MUS_PAPER_ROLL ? 0.0 : paper[1]);
    return status == MUS_OK ? mus__strip_make(sheet->context, n + 1, s->shapes, widest, &s->strip) : status;
}


static mus_status search_make(const mus_sheet *sheet, search *s)
{
    const int64_t n = s->n = sheet->npiece / sheet->nsize;
    int32_t runs = 0;
    for (int32_t i = 0; i < sheet->npiece; i++) runs += mus__piece_runs(&sheet->pieces[i], NULL);
    s->runs = mus__print_new(sheet->context, runs, 4 * sizeof *s->runs);
    s->run = mus__print_new(sheet->context, sheet->npiece, sizeof *s->run);
    s->box = mus__print_new(sheet->context, n + 1, 4 * sizeof *s->box);
    s->shapes = mus__print_new(sheet->context, n + 1, sizeof *s->shapes);
    s->lying = mus__print_new(sheet->context, n, sizeof *s->lying);
    s->order = mus__print_new(sheet->context, n + 1, sizeof *s->order);
    s->kept = mus__print_new(sheet->context, n + 1, 2 * sizeof *s->kept);
    s->pages = mus__print_new(sheet->context, TILES_MAX, sizeof *s->pages);
    s->now.places = mus__print_new(sheet->context, n + 1, sizeof *s->now.places);
    s->best.places = mus__print_new(sheet->context, n + 1, sizeof *s->best.places);
    if (s->runs == NULL || s->run == NULL || s->box == NULL || s->shapes == NULL || s->lying == NULL ||
        s->order == NULL || s->kept == NULL || s->pages == NULL || s->now.places == NULL || s->best.places == NULL)
        return mus__print_memory(sheet->context, "the layout of a sheet");
    for (int32_t i = 0, at = 0; i < sheet->npiece; i++) {
        s->run[i] = at;
        at += mus__piece_runs(&sheet->pieces[i], s->runs + 4 * at);
    }
    return search_shapes(sheet, s, SLAB_COARSE);
}


/* ---- orders ---- */

/* is shape a to be packed before b? By height, by area of the box, or by width */
static bool order_before(const mus__shape *a, const mus__shape *b, int32_t by)
{
    const double first = by == 0 ? a->height : by == 1 ? a->height * a->width : a->width;
    const double second = by == 0 ? b->height : by == 1 ? b->height * b->width : b->width;
    return first > second || (first == second && a->width > b->width);
}


/* sort the n shapes that are packed, in one of SORTED ways (insertion sort: a pattern has few pieces) */
static void search_sort(search *s, int32_t n, int32_t by)
{
    for (int32_t i = 0; i < n; i++) {
        int32_t j = i;
        s->shapes[i].first = 0;
        for (; j > 0 && order_before(&s->shapes[i], &s->shapes[s->order[j - 1]], by); j--)
            s->order[j] = s->order[j - 1];
        s->order[j] = i;
    }
}


/* the next number of the generator of Numerical Recipes, 1992, section 7.1, below n */
static int32_t search_draw(uint32_t *seed, int32_t n)
{
    *seed = 1664525u * *seed + 1013904223u;
    return (int32_t)((*seed >> 8) % (uint32_t)n);
}


/* change the order by one step: a shape changes its place with another, and gets a drawn way round to be tried first */
static void search_step(search *s, int32_t n, uint32_t *seed)
{
    const int32_t i = search_draw(seed, n), k = search_draw(seed, n), held = s->order[i];
    s->order[i] = s->order[k];
    s->order[k] = held;
    s->shapes[held].first = search_draw(seed, WAYS);
}


/* keep the order and the ways round, or take back those that were kept */
static void search_keep(search *s, bool back)
{
    for (int32_t i = 0; i <= s->n; i++) {
        int32_t *kept = s->kept + 2 * i;
        if (back)
            s->order[i] = kept[0], s->shapes[i].first = kept[1];
        else
            kept[0] = s->order[i], kept[1] = s->shapes[i].first;
    }
}


/* ---- one layout ---- */

static double sheet_step(const mus_sheet *sheet, const layout *l, int32_t axis)
{
    return l->page[axis] - 2.0 * sheet->def.margin - sheet->def.overlap;
}


/* pack the first n shapes on a strip of `columns` pages: sets places and rows (on a roll also the page's height). False
 * when a piece is too wide */
static bool layout_pack(const mus_sheet *sheet, search *s, int32_t n, int32_t columns)
{
    layout *l = &s->now;
    const double margin = sheet->def.margin, overlap = sheet->def.overlap;
    const double width = columns * sheet_step(sheet, l, 0) + overlap - 2.0 * SHEET_BORDER;
    mus__pages pages = {.border = SHEET_BORDER, .columns = columns, .rows = TILES_MAX / columns, .seen = s->pages};
    for (int32_t d = 0; d < 2; d++) pages.step[d] = sheet_step(sheet, l, d);
    if (s->by_page) memset(s->pages, 0, (size_t)TILES_MAX * sizeof *s->pages);
    s->strip.pages = s->by_page ? &pages : NULL;
    l->used = mus__strip_pack(&s->strip, n, s->shapes, s->order, width, PIECE_GAP, l->places);
    s->strip.pages = NULL;
    if (l->used < 0.0) return false;

    const double need = l->used + 2.0 * SHEET_BORDER;
    if (sheet->def.paper == MUS_PAPER_ROLL) l->page[1] = mus__roll_length(need + 2.0 * margin);
    const double rows = ceil((need - overlap) / sheet_step(sheet, l, 1) - 1e-9);
    l->squares = n > s->n;
    l->columns = columns;
    l->rows = rows < 1.0 ? 1 : rows > TILES_MAX ? TILES_MAX : (int32_t)rows;
    l->offset[0] = l->offset[1] = 0.0;
    return true;
}


/* box of nest i as it is turned [m] */
static void search_box(const search *s, const layout *l, int32_t i, double *box)
{
    if (l->places[i].quarter)
        mus__box_quarter(s->box + 4 * i, box);
    else
        memcpy(box, s->box + 4 * i, 4 * sizeof *box);
}


/* low corner of nest i on the sheet: the packer measures from the upper left corner */
static void layout_corner(const mus_sheet *sheet, const search *s, const layout *l, int32_t i, double *out)
{
    double box[4];
    search_box(s, l, i, box);
    const double top = l->rows * sheet_step(sheet, l, 1) + sheet->def.overlap - SHEET_BORDER;
    out[0] = l->places[i].x + l->offset[0] + SHEET_BORDER;
    out[1] = top - l->offset[1] - l->places[i].y - (box[3] - box[1]);
}


/* a layout that is looked at while its pieces still lie as they were made */
typedef struct layout_view {
    const mus_sheet *sheet;
    const search *search;
    const layout *layout;
} layout_view;


/* map a box on the sheet to where nest i was made; false when it is apart from the box of the nest */
static bool layout_into(const layout_view *view, int32_t i, const double *box, double *at)
{
    const mus__place *place = &view->layout->places[i];
    double own[4], corner[2], turned[4];
    search_box(view->search, view->layout, i, own);
    layout_corner(view->sheet, view->search, view->layout, i, corner);
    for (int32_t k = 0; k < 2; k++) {
        const double low = box[k] - corner[k], high = box[2 + k] - corner[k];
        if (high < 0.0 || low > own[2 + k] - own[k]) return false;
        turned[k] = place->flip[k] ? own[2 + k] - high : own[k] + low;
        turned[2 + k] = place->flip[k] ? own[2 + k] - low : own[k] + high;
    }
    /* back by a quarter: (x, y) came from (y, -x) */
    const double back[4] = {turned[1], -turned[2], turned[3], -turned[0]};
    memcpy(at, place->quarter ? back : turned, 4 * sizeof *at);
    return true;
}


/* map a point of nest i as it was made to the sheet, in place */
static void layout_out(const layout_view *view, int32_t i, double *p)
{
    const mus__place *place = &view->layout->places[i];
    double own[4], corner[2];
    search_box(view->search, view->layout, i, own);
    layout_corner(view->sheet, view->search, view->layout, i, corner);
    const double turned[2] = {place->quarter ? -p[1] : p[0], place->quarter ? p[0] : p[1]};
    for (int32_t d = 0; d < 2; d++) p[d] = corner[d] + (place->flip[d] ? own[2 + d] - turned[d] : turned[d] - own[d]);
}


/* true when a piece of the layout meets the box (low x, low y, high x, high y on the sheet [m]); met (2), unless NULL,
 * gets a point where it does */
static bool layout_meets(const void *user, const double *box, double *met)
{
    const layout_view *view = user;
    const mus_sheet *sheet = view->sheet;
    for (int32_t i = 0; i < view->search->n; i++) {
        double at[4];
        if (!layout_into(view, i, box, at)) continue;
        for (int32_t k = 0; k < sheet->nsize; k++) {
            const int32_t piece = i * sheet->nsize + k;
            const double *runs = view->search->runs + 4 * view->search->run[piece];
            if (!mus__piece_meets(&sheet->pieces[piece], runs, at, met)) continue;
            if (met != NULL) layout_out(view, i, met);
            return true;
        }
    }
    return false;
}


/* true when the sew line of a piece of the layout, in all its sizes, runs round the box */
static bool layout_holds(const void *user, const double *box)
{
    const layout_view *view = user;
    const int32_t nsize = view->sheet->nsize;
    for (int32_t i = 0; i < view->search->n; i++) {
        double at[4];
        int32_t k = 0;
        if (!layout_into(view, i, box, at)) continue;
        while (k < nsize && mus__piece_holds(&view->sheet->pieces[i * nsize + k], at)) k++;
        if (k == nsize) return true;
    }
    return false;
}


/* set the pages of the sheet to those that the layout fills, or to the first of them when they are more than `most` */
static mus_status layout_pages(mus_sheet *sheet, search *s, layout *l, int32_t most)
{
    const layout_view view = {sheet, s, l};
    const mus_status status = mus__print_reserve(sheet->context, &sheet->tiles, &s->tile_room,
                                                 (int64_t)l->columns * l->rows, sizeof *sheet->tiles);
    if (status != MUS_OK) return status;
    memcpy(sheet->page, l->page, sizeof sheet->page);
    sheet->columns = l->columns;
    sheet->rows = l->rows;
    sheet->extent[0] = l->columns * sheet_step(sheet, l, 0) + sheet->def.overlap;
    sheet->extent[1] = l->rows * sheet_step(sheet, l, 1) + sheet->def.overlap;
    sheet->ntile = 0;
    for (int32_t row = 0; row < l->rows; row++) {
        for (int32_t column = 0; column < l->columns; column++) {
            const mus__tile tile = {column, row};
            double box[4];
            mus__tile_window(sheet, &tile, box);
            if (layout_meets(&view, box, NULL)) sheet->tiles[sheet->ntile++] = tile;
            if (sheet->ntile > most) return MUS_OK;
        }
    }
    /* a last row may hold nothing but the border; places are measured from the top */
    l->rows = sheet->rows = sheet->ntile > 0 ? sheet->tiles[sheet->ntile - 1].row + 1 : 1;
    sheet->extent[1] = l->rows * sheet_step(sheet, l, 1) + sheet->def.overlap;
    return MUS_OK;
}


/* is a layout of `pages` pages better than the best: fewer pages, or as many on a sheet whose long side is shorter, or
 * that leaves more of its last row? */
static bool layout_before(const layout *l, const layout *best, int32_t pages)
{
    const int32_t most = best->ntile + best->cover;
    if (pages != most) return pages < most;
    return l->reach != best->reach ? l->reach < best->reach : l->used < best->used;
}


/* count the pages of the layout, with a cover if it needs one, and keep it when it is better */
static void layout_compare(mus_sheet *sheet, search *s)
{
    layout *l = &s->now, *best = &s->best;
    const int32_t most = best->ntile + best->cover;
    /* layout_move() and layout_search() ask no more of a layout than that it has this many more */
    if (s->status == MUS_OK) s->status = layout_pages(sheet, s, l, best->ntile > 0 ? most + 2 : TILES_MAX);
    if (s->status != MUS_OK) return;
    l->ntile = sheet->ntile;
    l->cover = sheet->tiled && mus__cover_own(sheet);
    l->reach = fmax(sheet->extent[0], sheet->extent[1]);
    if (best->ntile > 0 && !layout_before(l, best, l->ntile + l->cover)) return;
    if (sheet->tiled && !l->cover) {
        const layout_view view = {sheet, s, l};
        double corner[2];
        if (l->squares) layout_corner(sheet, s, l, s->n, corner);
        const mus__ground ground = {layout_meets, layout_holds, &view};
        mus__legend_place(sheet, &ground, l->squares ? corner : NULL);
        l->cover = sheet->cover;
    }
    if (best->ntile > 0 && !layout_before(l, best, l->ntile + l->cover)) return;
    mus__place *places = best->places;
    *best = *l;
    best->places = places;
    memcpy(places, l->places, ((size_t)s->n + 1) * sizeof *places);
}


/* compare the layout as it was packed, and moved by what is free to the right and at the bottom; returns the fewest
 * pages of these and `least` */
static int32_t layout_move(mus_sheet *sheet, search *s, int32_t least)
{
    layout *l = &s->now;
    double right = 0.0, free[2];
    for (int32_t i = 0; i < s->n; i++) {
        double box[4];
        search_box(s, l, i, box);
        right = fmax(right, l->places[i].x + box[2] - box[0]);
    }
    free[0] = l->columns * sheet_step(sheet, l, 0) + sheet->def.overlap - 2.0 * SHEET_BORDER - right;
    free[1] = l->rows * sheet_step(sheet, l, 1) + sheet->def.overlap - 2.0 * SHEET_BORDER - l->used;
    const int32_t rows = l->rows;
    for (int32_t k = 0; k < 4; k++) {
        l->rows = rows;
        for (int32_t d = 0; d < 2; d++) l->offset[d] = (k >> d & 1) != 0 ? fmax(0.0, free[d]) : 0.0;
        layout_compare(sheet, s);
        least = l->ntile + l->cover < least ? l->ntile + l->cover : least;
        /* moving saves a page or two at most */
        if (l->ntile > s->best.ntile + 2) break;
    }
    return least;
}


/* pack the shapes in their order on one width of the sheet and compare; returns the fewest pages, 0 when a piece is too
 * wide or there are too many pages */
static int32_t layout_try(mus_sheet *sheet, search *s, int32_t n, int32_t columns)
{
    layout *l = &s->now;
    if (!layout_pack(sheet, s, n, columns) || (int64_t)l->columns * l->rows > TILES_MAX) return 0;
    return layout_move(sheet, s, TILES_MAX);
}


/* try the sorted orders of one width of the sheet: nearest to the top, without the test squares and with them, and on
 * fewest pages; returns the fewest pages, 0 when a piece is too wide or there are too many pages */
static int32_t layout_orders(mus_sheet *sheet, search *s, int32_t columns)
{
    int32_t least = TILES_MAX;
    for (int32_t try = 0; try < 3 * SORTED; try++) {
        const int32_t n = s->n + (try % 3 == 1 ? 1 : 0);
        s->by_page = try % 3 == 2;
        search_sort(s, n, try / 3);
        const int32_t pages = layout_try(sheet, s, n, columns);
        if (pages == 0) return 0;
        least = pages < least ? pages : least;
    }
    return least;
}


/* climb from each sorted order of one width of the sheet, by pages or by height: of steps that are drawn, those that
 * take no more pages, and on as many no more height, are kept */
static void layout_climb(mus_sheet *sheet, search *s, int32_t columns, bool by_page)
{
    uint32_t seed = 1;
    s->by_page = by_page;
    for (int32_t by = 0; by < SORTED; by++) {
        search_sort(s, s->n, by);
        int32_t least = layout_try(sheet, s, s->n, columns);
        double used = s->now.used;
        if (least == 0) return;
        search_keep(s, false);
        for (int32_t step = 0; step < STEPS; step++) {
            search_step(s, s->n, &seed);
            const int32_t pages = layout_try(sheet, s, s->n, columns);
            const bool kept = pages > 0 && (pages < least || (pages == least && s->now.used <= used));
            if (kept) least = pages, used = s->now.used;
            search_keep(s, !kept);
        }
    }
}


/* try the widths of the sheet, from the least on, with the paper upright or landscape: all widths with the sorted
 * orders, or, fine, climb from them on the best ones */
static void layout_search(mus_sheet *sheet, search *s, int32_t landscape, bool fine)
{
    double paper[2], widest = 0.0;
    layout *l = &s->now;
    mus__paper_size(sheet->def.paper, paper);
    l->page[0] = paper[landscape];
    l->page[1] = paper[1 - landscape];
    for (int32_t i = 0; i < s->n; i++) widest = fmax(widest, mus__shape_narrow(&s->shapes[i]));
    double narrow = ceil((widest + 2.0 * SHEET_BORDER - sheet->def.overlap) / sheet_step(sheet, l, 0) - 1e-9);
    narrow = narrow < 1.0 ? 1.0 : fmin(narrow, TILES_MAX);
    const int32_t most = s->best.ntile + s->best.cover + 1;
    for (int32_t k = 0; k <= MORE_COLUMNS; k++) {
        int32_t *least = &s->least[landscape][k];
        if (!fine)
            *least = layout_orders(sheet, s, (int32_t)narrow + k);
        else if (*least > 0 && *least <= most)
            layout_climb(sheet, s, (int32_t)narrow + k, false);
        if (fine && *least > 0 && *least < most) layout_climb(sheet, s, (int32_t)narrow + k, true);
        if (!fine && *least > 0 && l->rows == 1) break;
    }
}


/* try one page with all pieces and the test squares; false when they do not fit */
static bool layout_single(mus_sheet *sheet, search *s, bool landscape)
{
    double paper[2];
    layout *l = &s->now;
    mus__paper_size(sheet->def.paper, paper);
    l->page[0] = paper[landscape ? 1 : 0];
    l->page[1] = paper[landscape ? 0 : 1];
    search_sort(s, s->n + 1, 0);
    if (!layout_pack(sheet, s, s->n + 1, 1) || l->rows > 1) return false;
    s->best.ntile = 0;
    layout_compare(sheet, s);
    return true;
}


static mus_status layout_find(mus_sheet *sheet, search *s)
{
    const int32_t ways = sheet->def.paper == MUS_PAPER_ROLL ? 1 : 2;
    for (int32_t way = 0; way < ways; way++)
        if (layout_single(sheet, s, way == 1)) return s->status;
    sheet->tiled = true;
    for (int32_t way = 0; way < ways; way++) layout_search(sheet, s, way, false);
    if (s->status == MUS_OK && s->best.ntile > 0 && s->best.ntile <= CLIMBED_PAGES) {
        s->status = search_shapes(sheet, s, SLAB_FINE);
        for (int32_t way = 0; way < ways && s->status == MUS_OK; way++) layout_search(sheet, s, way, true);
    }
    if (s->status != MUS_OK || s->best.ntile > 0) return s->status;
    return mus__file_fail(sheet->context, MUS_ERR_LIMIT, "pattern %.100s: more than %d pages", sheet->title, TILES_MAX);
}


/* take the best layout over: pages, and the places of all pieces and of the test squares */
static mus_status layout_take(mus_sheet *sheet, search *s)
{
    layout *l = &s->best;
    const mus_status status = layout_pages(sheet, s, l, TILES_MAX);
    if (status != MUS_OK) return status;
    sheet->packed = l->squares;
    if (l->squares) layout_corner(sheet, s, l, s->n, sheet->squares);
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const int32_t nest = i / sheet->nsize;
        double box[4], corner[2];
        search_box(s, l, nest, box);
        layout_corner(sheet, s, l, nest, corner);
        const bool *flip = l->places[nest].flip;
        if (l->places[nest].quarter) mus__piece_quarter(&sheet->pieces[i]);
        mus__piece_flip(&sheet->pieces[i], flip[0], flip[1]);
        mus__piece_move(&sheet->pieces[i], corner[0] + (flip[0] ? box[2] : -box[0]),
                        corner[1] + (flip[1] ? box[3] : -box[1]));
    }
    return MUS_OK;
}


mus_status mus__sheet_layout(mus_sheet *sheet)
{
    search s;
    memset(&s, 0, sizeof s);
    mus_status status = search_make(sheet, &s);
    if (status == MUS_OK) status = layout_find(sheet, &s);
    if (status == MUS_OK) status = layout_take(sheet, &s);
    search_free(sheet, &s);
    return status;
}
