/*
 * cover.c: what the first page of a tiled sheet tells: title, wearer or sizes, test squares, how to print and join the
 * pages, the caller's notes, the list of pieces, and a map of the pages with the numbers of the pieces.
 *
 * A sheet of many pages has a page of its own for them, before the others. One of few has them on free places of its
 * pages, between the pieces or inside one: the page with the title is the first then. Without such places it has a page
 * of its own too.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/utf8.h"
#include "drawing/lettering.h"
#include "drawing/phrase.h"
#include "print/page.h"

/* [m] least width right of the squares, for text and page map; chosen: the shortest lines of text fit */
#define COVER_COLUMN 0.048
#define COVER_HEIGHT 0.205 /* [m] least height that the cover needs; chosen: squares, title and instructions fit */
#define COVER_GAP 0.006   /* [m] distance of the squares from the page map; chosen: a ruler can be laid on them */
#define LEGEND_STEP 0.008 /* [m] distance of the places that are tried for the legend; chosen: finer ones seldom help */
#define LEGEND_GAP 0.003  /* [m] distance of the legend from the cut lines; chosen: twice the height of its letters */
#define LEGEND_LETTER 0.0025 /* [m] height of its capitals; chosen: the smallest that is read at arm's length */
#define LEGEND_PITCH 0.0042  /* [m] from line to line */
#define LEGEND_HEAD 0.019    /* [m] height of title and facts above the instructions */
#define LEGEND_MAP 0.034     /* [m] height of the page map below them; chosen: names of pages are read in it */
#define MAP_LATTICE 9        /* points tried in each direction for a number on the map; chosen: narrow arcs hold one */
#define LEGEND_LINES 64      /* most lines of text; chosen: twice those of the richest legend in the longest language */
#define EMPTY_NAMES 192      /* [bytes] of the names of places without a page; chosen: three lines, then "..." */
#define LEGEND_STEP_TEXT 1024 /* [bytes] of a step; chosen: letters of three bytes in the longest, twice over */

/* pages of pieces from which on the cover is a page of its own: chosen, so that it adds a tenth to them at most, and a
 * small garment takes the pages that its pieces take */
#define COVER_FROM 10

/* how to print and join the pages, what the lines are, and the buttonholes of a sheet that has some */
static const char *const cover_steps[] = {"paper.step.1", "paper.step.2", "paper.step.3", "paper.step.4",
                                          "paper.step.5"};


static int32_t cover_step_count(const mus_sheet *sheet)
{
    const int32_t all = (int32_t)(sizeof cover_steps / sizeof cover_steps[0]);
    return sheet->buttonholes ? all : all - 1;
}


static void cover_step(const mus_sheet *sheet, int32_t step, char *out)
{
    mus__phrase phrase = mus__phrase_in(sheet->language);
    mus__phrase_text(&phrase, 0,
                     mus_language_text(sheet->language, sheet->nsize > 1 ? "paper.cut_sizes" : "paper.cut"));
    mus__phrase_write(&phrase, cover_steps[step], out, LEGEND_STEP_TEXT);
}


/* write which places of the grid have no page, as they have no line; false when all have one */
static bool cover_empty(const mus_sheet *sheet, char *out)
{
    char names[EMPTY_NAMES] = "", name[16];
    size_t at = 0;
    for (int32_t i = 0; i < sheet->columns * sheet->rows; i++) {
        const mus__tile tile = {i % sheet->columns, i / sheet->columns};
        if (mus__tile_find(sheet, tile.column, tile.row) != MUS_NONE) continue;
        mus__tile_name(&tile, name, sizeof name);
        const bool room = at + 2 * sizeof name < sizeof names;
        at += (size_t)snprintf(names + at, sizeof names - at, "%s%s",
                               at > 0 ? mus_language_text(sheet->language, "list.comma") : "", room ? name : "...");
        if (!room) break;
    }
    mus__phrase phrase = mus__phrase_in(sheet->language);
    mus__phrase_text(&phrase, 0, names);
    mus__phrase_write(&phrase, "paper.empty", out, LEGEND_STEP_TEXT);
    return at > 0;
}


#define LEGEND_TEXT 512 /* [bytes] of a line; chosen: letters of three bytes on the widest line, twice over */

/* lines of text, how wide they are at most [m], and how many */
typedef struct cover_lines {
    const mus_sheet *sheet;
    double width;
    int32_t n, most; /* n is MUS_NONE when they were more than `most` */
    char text[LEGEND_LINES][LEGEND_TEXT];
} cover_lines;


/* break a text into lines of the width and add them; each line of the text begins a new one, also an empty one */
static void cover_break(cover_lines *lines, const char *text)
{
    char own[LEGEND_STEP_TEXT];
    for (const char *from = text; *from != '\0' && lines->n != MUS_NONE;) {
        const size_t all = strcspn(from, "\n");
        snprintf(own, sizeof own, "%.*s", all < sizeof own ? (int)all : (int)sizeof own - 1, from);
        own[mus__utf8_span(own)] = '\0';
        from += all + (from[all] == '\n');
        const char *at = own;
        do {
            const size_t fits =
                *at == '\0' ? 0 : mus__lettering_line(lines->sheet->lettering, at, LEGEND_LETTER, lines->width);
            if (lines->n == lines->most || (*at != '\0' && fits == 0) || fits >= LEGEND_TEXT) {
                lines->n = MUS_NONE;
                return;
            }
            memcpy(lines->text[lines->n], at, fits);
            lines->text[lines->n++][fits] = '\0';
            at += fits + (at[fits] == ' ');
        } while (*at != '\0');
    }
}


/* add the list of the pieces: a line for each, with its number, its name and how it is cut, as far as there is room */
static void cover_pieces(cover_lines *lines)
{
    const mus_sheet *sheet = lines->sheet;
    const int32_t count = sheet->npiece / sheet->nsize;
    const bool english = sheet->language == MUS_LANGUAGE_ENGLISH;
    if (lines->n == MUS_NONE || lines->n + 4 > lines->most) return;
    cover_break(lines, "\n");
    cover_break(lines, mus_language_text(sheet->language, "head.pieces"));
    for (int32_t i = 0; i < count && lines->n != MUS_NONE; i++) {
        char text[LEGEND_TEXT], name[128], cut[192];
        mus__phrase phrase = mus__phrase_in(sheet->language);
        /* a piece takes two lines at most, and what is left out takes one */
        if (lines->n + 3 > lines->most && i + 1 < count) {
            mus__phrase_number(&phrase, 0, count - i);
            mus__phrase_write(&phrase, "paper.more", text, sizeof text);
            cover_break(lines, text);
            return;
        }
        mus__sheet_piece_words(sheet, i * sheet->nsize, name, english ? 41 : sizeof name);
        mus__piece_cut_text(&sheet->pieces[i * sheet->nsize], sheet->language, cut, sizeof cut);
        if (cut[0] >= 'A' && cut[0] <= 'Z') cut[0] = (char)(cut[0] - 'A' + 'a'); /* after a colon */
        mus__phrase_text(&phrase, 0, name);
        mus__phrase_text(&phrase, 1, cut);
        const int n = snprintf(text, sizeof text, "%d. ", (int)i + 1);
        mus__phrase_write(&phrase, "list.colon", text + n, sizeof text - (size_t)n);
        cover_break(lines, text);
    }
}


/* write at most `most` lines of `width` [m]: how to print, and, in full, the caller's notes and the list of pieces */
static void cover_text(const mus_sheet *sheet, double width, int32_t most, bool full, cover_lines *lines)
{
    lines->sheet = sheet;
    lines->width = width;
    lines->n = 0;
    lines->most = most < LEGEND_LINES ? most : LEGEND_LINES;
    char step[LEGEND_STEP_TEXT];
    for (int32_t i = 0; i < cover_step_count(sheet); i++) {
        cover_step(sheet, i, step);
        cover_break(lines, step);
    }
    if (cover_empty(sheet, step)) cover_break(lines, step);
    if (full && sheet->notes != NULL) {
        cover_break(lines, "\n");
        cover_break(lines, sheet->notes);
    }
    if (full) cover_pieces(lines);
}


/* where the second of two columns begins: after the empty line that makes the longer one shortest; without one that
 * leaves both `rows` lines at most, at the end of the first. *rows gets the lines of the longer one */
static int32_t cover_split(const cover_lines *lines, int32_t *rows)
{
    int32_t split = lines->n < *rows ? lines->n : *rows, least = *rows + 1;
    for (int32_t i = 1; i < lines->n; i++) {
        const int32_t longer = i > lines->n - i - 1 ? i : lines->n - i - 1;
        if (lines->text[i][0] != '\0' || longer >= least) continue;
        least = longer;
        split = i + 1;
    }
    if (least <= *rows) *rows = least;
    return split;
}


/* draw lines `from` to below `to`, the first with its base line at y [m]; after an empty line stands a head */
static void cover_lines_draw(const cover_lines *lines, int32_t from, int32_t to, mus__drawing *out, double left,
                             double right, double y)
{
    for (int32_t i = from; i < to; i++, y -= LEGEND_PITCH) {
        const bool head = i > 0 && lines->text[i - 1][0] == '\0';
        if (lines->text[i][0] != '\0')
            mus__page_line(out, head ? MUS__PEN_TITLE : MUS__PEN_TEXT, lines->text[i], left, right, y, LEGEND_LETTER);
    }
}


/* draw lines in two columns between left and right, at the end that the language begins at first */
static void cover_columns_draw(const cover_lines *lines, int32_t rows, mus__drawing *out, double left, double right,
                               double y)
{
    const bool from_right = mus_language_is_right_to_left(out->language) != 0;
    const double first = from_right ? right - lines->width : left, second = from_right ? left : right - lines->width;
    const int32_t split = cover_split(lines, &rows);
    cover_lines_draw(lines, 0, split < rows ? split : rows, out, first, first + lines->width, y);
    cover_lines_draw(lines, split, lines->n, out, second, second + lines->width, y);
}


/* [m] width of each of two columns on a width */
static double cover_column(double width)
{
    return 0.5 * (width - COVER_GAP);
}


/* the line below the title: wearer or sizes, pages and scale */
static void cover_facts(const mus_sheet *sheet, char *out, size_t size)
{
    char facts[256], person[128];
    mus__phrase phrase = mus__phrase_in(sheet->language);
    mus__phrase_number(&phrase, 1, sheet->columns);
    mus__phrase_number(&phrase, 2, sheet->rows);
    mus__phrase_count(&phrase, sheet->cover ? "facts.cover" : "facts", sheet->ntile, facts, sizeof facts);
    if (sheet->nsize > 1) {
        char sizes[256];
        mus__sheet_sizes(sheet, sizes, sizeof sizes);
        snprintf(out, size, "%s.  %s", sizes, facts);
        return;
    }
    if (sheet->person == NULL) {
        snprintf(out, size, "%s", facts);
        return;
    }
    snprintf(person, sizeof person, "%.100s", sheet->person);
    mus__phrase_text(&phrase, 0, person);
    mus__phrase_text(&phrase, 1, facts);
    mus__phrase_write(&phrase, "facts.person", out, size);
}


/* ---- a page of its own ---- */

bool mus__cover_own(const mus_sheet *sheet)
{
    return sheet->ntile >= COVER_FROM;
}


void mus__cover_size(const mus_sheet *sheet, double *out)
{
    /* the paper of the pages, or A4 for A0 and rolls, which a copy shop prints */
    int32_t paper = sheet->def.paper;
    mus__paper_size(paper == MUS_PAPER_A0 || paper == MUS_PAPER_ROLL ? MUS_PAPER_A4 : paper, out);
}


mus_status mus__cover_check(const mus_sheet *sheet)
{
    double size[2], width = MUS__SQUARES + COVER_GAP + COVER_COLUMN;
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


/* find a point inside a piece: of a lattice over its box the nearest to the middle */
static void cover_inside(const mus__piece *piece, double *out)
{
    double nearest = HUGE_VAL;
    for (int32_t i = 0; i < MAP_LATTICE * MAP_LATTICE; i++) {
        const double u = (i % MAP_LATTICE + 0.5) / MAP_LATTICE, v = (i / MAP_LATTICE + 0.5) / MAP_LATTICE;
        const double p[2] = {piece->box[0] + u * (piece->box[2] - piece->box[0]),
                             piece->box[1] + v * (piece->box[3] - piece->box[1])};
        const double away = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
        if (away >= nearest || !mus__piece_inside(piece, p[0], p[1])) continue;
        nearest = away;
        memcpy(out, p, sizeof p);
    }
    if (nearest == HUGE_VAL)
        for (int32_t k = 0; k < 2; k++) out[k] = 0.5 * (piece->box[k] + piece->box[2 + k]);
}


/* the silhouettes of the pieces, `s` times their size, the low corner of the sheet at (x, y) */
static void cover_silhouettes(const mus_sheet *sheet, mus__drawing *out, double x, double y, double s)
{
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const mus__loops *cut = &sheet->pieces[i].cut;
        mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_GREY);
        for (int32_t l = 0; l < cut->nloop; l++) {
            double last[2] = {0, 0};
            for (int32_t k = cut->start[l]; k < cut->start[l + 1]; k++) {
                /* points nearer to each other than 0.1 mm on the map become one */
                const double p[2] = {x + s * cut->xy[2 * k], y + s * cut->xy[2 * k + 1]};
                double dx = p[0] - last[0], dy = p[1] - last[1];
                if (k > cut->start[l] && dx * dx + dy * dy < 1e-8) continue;
                if (k == cut->start[l]) mus__draw_move(out, p[0], p[1]);
                else mus__draw_line(out, p[0], p[1]);
                memcpy(last, p, sizeof last);
            }
            mus__draw_close(out);
        }
    }
}


/* page map, scaled to fit the box: silhouettes with the numbers of the pieces, and pages with their names, each in its
 * upper left corner as on the page itself */
static void cover_map(const mus_sheet *sheet, mus__drawing *out, double x, double y, double width, double height)
{
    double sx = width / sheet->extent[0], sy = height / sheet->extent[1], s = sx < sy ? sx : sy;
    double low = y + height - s * sheet->extent[1], letter = 0.12 * s * sheet->page[0];
    letter = letter > 0.003 ? 0.003 : letter;
    cover_silhouettes(sheet, out, x, low, s);
    for (int32_t i = 0; i < sheet->ntile; i++) {
        char name[16];
        double box[4];
        mus__tile_window(sheet, &sheet->tiles[i], box);
        mus__draw_path(out, MUS_NONE, MUS__LAYER_MARKS, MUS__PEN_FRAME);
        mus__draw_rectangle(out, x + s * box[0], low + s * box[1], s * (box[2] - box[0]), s * (box[3] - box[1]));
        mus__tile_name(&sheet->tiles[i], name, sizeof name);
        mus__page_text(out, MUS__PEN_FAINT, name, x + s * box[0] + 0.4 * letter, low + s * box[3] - 1.4 * letter,
                       letter, 0.0);
    }
    for (int32_t i = 0; i < sheet->npiece; i += sheet->nsize) {
        char number[16];
        double at[2];
        cover_inside(&sheet->pieces[i], at);
        snprintf(number, sizeof number, "%d", (int)(i / sheet->nsize) + 1);
        mus__page_text(out, MUS__PEN_TEXT, number, x + s * at[0], low + s * at[1] - 0.5 * letter, letter, 0.5);
    }
}


/* draw the title as large as fits, at most 8 mm high, and the facts below; returns the height below them */
static double cover_title(const mus_sheet *sheet, mus__drawing *out, double left, double right, double y)
{
    char text[LEGEND_TEXT + 32];
    double letter = 0.008, small = 0.003;
    double width = mus__lettering_width(sheet->lettering, sheet->title, true);
    if (letter * width > right - left) letter = (right - left) / width;
    mus__page_line(out, MUS__PEN_TITLE, sheet->title, left, right, y -= letter + 0.001, letter);
    cover_facts(sheet, text, sizeof text);
    width = mus__lettering_width(sheet->lettering, text, false);
    if (small * width > right - left) small = (right - left) / width;
    mus__page_line(out, MUS__PEN_TEXT, text, left, right, y -= 0.007, small);
    return y;
}


void mus__cover_draw(const mus_sheet *sheet, mus__drawing *out)
{
    double size[2], margin = sheet->def.margin;
    mus__cover_size(sheet, size);
    double left = margin, right = size[0] - margin, y = cover_title(sheet, out, left, right, size[1] - margin);

    /* squares on the left and the page map right of them; below, the text in two columns */
    const double top = y - 0.005, low = top - MUS__SQUARES, column = left + MUS__SQUARES + COVER_GAP;
    const double half = cover_column(right - left), first = low - 0.008;
    cover_lines lines;
    mus__squares_draw(out, left, low);
    /* no line of the map is as long as a side of the squares */
    cover_map(sheet, out, column, low + 2.0 * COVER_GAP, right - column, MUS__SQUARES - 2.0 * COVER_GAP);
    const int32_t rows = 1 + (int32_t)((first - margin) / LEGEND_PITCH);
    cover_text(sheet, half, 2 * rows, true, &lines);
    if (lines.n == MUS_NONE) cover_text(sheet, half, 2 * rows, false, &lines);
    if (lines.n != MUS_NONE) cover_columns_draw(&lines, rows, out, left, right, first);
}


/* ---- on free places of the pages ---- */

#define LEGEND_MET 32 /* points of pieces that are remembered; chosen: changes the time alone */

/* what may lie where the legend is wanted: pieces, and one box */
typedef struct legend_taken {
    const mus__ground *ground;
    const double *box;
    double met[LEGEND_MET][2]; /* the last points where pieces were met: neighbouring places hold them too */
    int32_t nmet;
} legend_taken;


/* is a box free: between the pieces, or held by one? */
static bool legend_clear(legend_taken *taken, const double *box, bool held)
{
    const double grown[4] = {box[0] - LEGEND_GAP, box[1] - LEGEND_GAP, box[2] + LEGEND_GAP, box[3] + LEGEND_GAP};
    const double *other = taken->box;
    if (other != NULL && grown[0] < other[2] && grown[2] > other[0] && grown[1] < other[3] && grown[3] > other[1])
        return false;
    if (held) return taken->ground->held(taken->ground->user, grown);
    for (int32_t i = 1; i <= taken->nmet && i <= LEGEND_MET; i++) {
        const double *met = taken->met[(taken->nmet - i) % LEGEND_MET];
        if (grown[0] < met[0] && met[0] < grown[2] && grown[1] < met[1] && met[1] < grown[3]) return false;
    }
    if (!taken->ground->taken(taken->ground->user, grown, taken->met[taken->nmet % LEGEND_MET])) return true;
    taken->nmet++;
    return false;
}


/* find a place of the given width and height, free or held by a piece, on the first page that has one, from its upper
 * left corner on */
static bool legend_find(const mus_sheet *sheet, double width, double height, legend_taken *taken, bool held,
                        double *out)
{
    for (int32_t t = 0; t < sheet->ntile; t++) {
        double window[4];
        mus__tile_window(sheet, &sheet->tiles[t], window);
        for (double y = window[3] - height - LEGEND_GAP; y > window[1] + LEGEND_GAP; y -= LEGEND_STEP) {
            for (double x = window[0] + LEGEND_GAP; x + width + LEGEND_GAP < window[2]; x += LEGEND_STEP) {
                const double box[4] = {x, y, x + width, y + height};
                if (mus__tile_marked(window, box)) continue;
                if (!legend_clear(taken, box, held)) continue;
                memcpy(out, box, sizeof box);
                return true;
            }
        }
    }
    return false;
}


/* does one page show the whole box? */
static bool legend_shown(const mus_sheet *sheet, const double *box)
{
    for (int32_t t = 0; t < sheet->ntile; t++) {
        double window[4];
        mus__tile_window(sheet, &sheet->tiles[t], window);
        if (box[0] > window[0] && box[1] > window[1] && box[2] < window[2] && box[3] < window[3]) return true;
    }
    return false;
}


/* find a place for title and text, with notes and pieces or without, among what is taken; true when there is one */
static bool legend_text_place(mus_sheet *sheet, legend_taken *taken, bool full)
{
    static const double widths[] = {0.165, 0.13, 0.1, 0.075};
    const int32_t nwidth = (int32_t)(sizeof widths / sizeof widths[0]);
    cover_lines lines;
    for (int32_t i = 0; i < 2 * nwidth; i++) {
        const double width = widths[i % nwidth];
        double box[4];
        cover_text(sheet, full ? cover_column(width) : width, LEGEND_LINES, full, &lines);
        int32_t rows = lines.n;
        if (full && rows != MUS_NONE) cover_split(&lines, &rows);
        const double height = LEGEND_HEAD + LEGEND_PITCH * rows + LEGEND_MAP;
        if (lines.n == MUS_NONE || !legend_find(sheet, width, height, taken, i >= nwidth, box)) continue;
        memcpy(sheet->legend, box, sizeof box);
        return true;
    }
    return false;
}


void mus__legend_place(mus_sheet *sheet, const mus__ground *ground, const double *corner)
{
    double box[4];
    legend_taken all = {.ground = ground};
    sheet->cover = true;
    sheet->full = false;
    if (mus__cover_own(sheet)) return;
    if (corner != NULL) {
        memcpy(box, corner, 2 * sizeof *box);
        for (int32_t k = 0; k < 2; k++) box[2 + k] = box[k] + MUS__SQUARES;
        if (!legend_shown(sheet, box)) return;
    } else if (!legend_find(sheet, MUS__SQUARES, MUS__SQUARES, &all, false, box) &&
               !legend_find(sheet, MUS__SQUARES, MUS__SQUARES, &all, true, box)) {
        return;
    }
    all.box = box;
    sheet->cover = !legend_text_place(sheet, &all, false);
    memcpy(sheet->squares, box, sizeof sheet->squares);
}


void mus__legend_fill(mus_sheet *sheet, const mus__ground *ground)
{
    const double *at = sheet->squares, box[4] = {at[0], at[1], at[0] + MUS__SQUARES, at[1] + MUS__SQUARES};
    legend_taken all = {.ground = ground, .box = box};
    if (sheet->cover) return;
    sheet->full = legend_text_place(sheet, &all, true);
    for (int32_t t = 1; t < sheet->ntile; t++) {
        const mus__tile tile = sheet->tiles[t];
        double window[4];
        mus__tile_window(sheet, &tile, window);
        const double *low = sheet->legend;
        if (low[0] <= window[0] || low[0] >= window[2] || low[1] <= window[1] || low[1] >= window[3]) continue;
        memmove(sheet->tiles + 1, sheet->tiles, (size_t)t * sizeof tile);
        sheet->tiles[0] = tile;
        return;
    }
}


void mus__legend_draw(const mus_sheet *sheet, mus__drawing *out)
{
    cover_lines lines;
    const double *box = sheet->legend;
    double y = cover_title(sheet, out, box[0], box[2], box[3]) - 0.002;
    const double width = box[2] - box[0];
    cover_text(sheet, sheet->full ? cover_column(width) : width, LEGEND_LINES, sheet->full, &lines);
    if (sheet->full)
        cover_columns_draw(&lines, lines.n, out, box[0], box[2], y - LEGEND_PITCH);
    else
        cover_lines_draw(&lines, 0, lines.n, out, box[0], box[2], y - LEGEND_PITCH);
    cover_map(sheet, out, box[0], box[1], box[2] - box[0], LEGEND_MAP - LEGEND_GAP);
}
