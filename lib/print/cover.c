/*
 * cover.c: title, instructions, test squares, list of pieces and page map of a tiled sheet: as a legend on free places
 * of its pages, between the pieces or inside one, or, when there are none, on a page of its own before the others.
 */
#include <stdio.h>
#include <string.h>

#include "drawing/lettering.h"
#include "print/page.h"
#include "print/phrase.h"

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
#define LEGEND_NAME 0.024    /* [m] corner of a page that holds its name */
#define LEGEND_LINES 24      /* most lines of the instructions */
#define LEGEND_STEP_TEXT 1024 /* [bytes] of a step; chosen: letters of three bytes in the longest, twice over */

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


#define LEGEND_TEXT 512 /* [bytes] of a line; chosen: letters of three bytes on the widest line, twice over */

/* instructions broken into lines of `width` [m]: returns their number, 0 when they are too many */
static int32_t legend_lines(const mus_sheet *sheet, double width, char (*lines)[LEGEND_TEXT])
{
    int32_t n = 0;
    for (int32_t i = 0; i < cover_step_count(sheet); i++) {
        char step[LEGEND_STEP_TEXT];
        cover_step(sheet, i, step);
        for (const char *at = step; *at != '\0';) {
            const size_t fits = mus__lettering_line(sheet->lettering, at, LEGEND_LETTER, width);
            if (n == LEGEND_LINES || fits == 0 || fits >= LEGEND_TEXT) return 0;
            memcpy(lines[n], at, fits);
            lines[n++][fits] = '\0';
            at += fits + (at[fits] == ' ');
        }
    }
    return n;
}


/* the line below the title: wearer, pages and scale */
static void cover_facts(const mus_sheet *sheet, char *out, size_t size)
{
    char facts[256], person[128];
    mus__phrase phrase = mus__phrase_in(sheet->language);
    mus__phrase_number(&phrase, 1, sheet->columns);
    mus__phrase_number(&phrase, 2, sheet->rows);
    mus__phrase_count(&phrase, sheet->cover ? "facts.cover" : "facts", sheet->ntile, facts, sizeof facts);
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


/* page map: pages, silhouettes and names, scaled to fit the box */
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
        mus__page_text(out, MUS__PEN_FAINT, name, x + s * 0.5 * (box[0] + box[2]),
                  low + s * 0.5 * (box[1] + box[3]) - 0.5 * letter, letter, 0.5);
    }
}


/* what the list says of a piece: its name and how it is cut */
static void cover_piece(const mus_sheet *sheet, int32_t index, char *out, size_t size)
{
    char name[128], cut[192];
    mus__phrase phrase = mus__phrase_in(sheet->language);
    mus__sheet_piece_words(sheet, index, name, sheet->language == MUS_LANGUAGE_ENGLISH ? 41 : sizeof name);
    mus__piece_cut_text(&sheet->pieces[index], sheet->language, cut, sizeof cut);
    if (cut[0] >= 'A' && cut[0] <= 'Z') cut[0] = (char)(cut[0] - 'A' + 'a'); /* after a colon */
    mus__phrase_text(&phrase, 0, name);
    mus__phrase_text(&phrase, 1, cut);
    mus__phrase_write(&phrase, "list.colon", out, size);
}


/* one line of text for each piece, down to the height `low` */
static void cover_pieces(const mus_sheet *sheet, mus__drawing *out, double left, double right, double y, double low)
{
    const int32_t n = sheet->npiece / sheet->nsize;
    const bool from_right = mus_language_is_right_to_left(sheet->language) != 0;
    for (int32_t i = 0; i < n && y > low; i++, y -= 0.0055) {
        char text[256];
        bool last = y - 0.0055 <= low && i + 1 < n;
        snprintf(text, sizeof text, "%d", i + 1);
        if (!last)
            mus__page_text(out, MUS__PEN_TEXT, text, from_right ? right - 0.005 : left + 0.005, y, 0.0025,
                           from_right ? 0.0 : 1.0);
        mus__phrase phrase = mus__phrase_in(sheet->language);
        mus__phrase_number(&phrase, 0, n - i);
        if (last) mus__phrase_write(&phrase, "paper.more", text, sizeof text);
        else cover_piece(sheet, i * sheet->nsize, text, sizeof text);
        mus__page_line(out, MUS__PEN_TEXT, text, left + 0.0075, right - 0.0075, y, 0.0025);
        if (last) return;
    }
}


/* draw the title as large as fits, at most 8 mm high, and the facts below; returns the height below them */
static double cover_title(const mus_sheet *sheet, mus__drawing *out, double left, double right, double y)
{
    char text[256];
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

    /* squares on the left, the page map right of them, then the instructions and the list of the pieces */
    double top = y - 0.005, low = top - MUS__SQUARES;
    char lines[LEGEND_LINES][LEGEND_TEXT];
    double column = left + MUS__SQUARES + COVER_GAP;
    mus__squares_draw(out, left, low);
    cover_map(sheet, out, column, low, right - column, MUS__SQUARES);
    const int32_t n = legend_lines(sheet, right - left, lines);
    y = low - 0.008;
    for (int32_t i = 0; i < n; i++, y -= LEGEND_PITCH)
        mus__page_line(out, MUS__PEN_TEXT, lines[i], left, right, y, LEGEND_LETTER);
    cover_pieces(sheet, out, left, right, y - 0.004, margin + 0.004);
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


/* does a box lie on the marks of a neighbour, at the middle of an edge of the page? They are as wide as its own name,
 * and half as deep */
static bool legend_on_marks(const double *window, const double *box)
{
    for (int32_t d = 0; d < 2; d++) {
        const double middle = 0.5 * (window[d] + window[2 + d]), deep = 0.5 * LEGEND_NAME;
        if (box[d] > middle + LEGEND_NAME || box[2 + d] < middle - LEGEND_NAME) continue;
        if (box[1 - d] < window[1 - d] + deep || box[3 - d] > window[3 - d] - deep) return true;
    }
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
                /* the upper left corner of a page holds its name */
                if (x < window[0] + LEGEND_NAME && y + height > window[3] - LEGEND_NAME) continue;
                if (legend_on_marks(window, box)) continue;
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


void mus__legend_place(mus_sheet *sheet, const mus__ground *ground, const double *corner)
{
    static const double widths[] = {0.165, 0.13, 0.1, 0.075};
    char lines[LEGEND_LINES][LEGEND_TEXT];
    double box[4];
    legend_taken all = {.ground = ground};
    sheet->cover = true;
    if (corner != NULL) {
        memcpy(box, corner, 2 * sizeof *box);
        for (int32_t k = 0; k < 2; k++) box[2 + k] = box[k] + MUS__SQUARES;
        if (!legend_shown(sheet, box)) return;
    } else if (!legend_find(sheet, MUS__SQUARES, MUS__SQUARES, &all, false, box) &&
               !legend_find(sheet, MUS__SQUARES, MUS__SQUARES, &all, true, box)) {
        return;
    }
    all.box = box;
    const int32_t nwidth = (int32_t)(sizeof widths / sizeof widths[0]);
    for (int32_t i = 0; i < 2 * nwidth && sheet->cover; i++) {
        const double width = widths[i % nwidth];
        const int32_t n = legend_lines(sheet, width, lines);
        if (n == 0) continue;
        sheet->cover =
            !legend_find(sheet, width, LEGEND_HEAD + LEGEND_PITCH * n + LEGEND_MAP, &all, i >= nwidth, sheet->legend);
    }
    memcpy(sheet->squares, box, sizeof sheet->squares);
}


void mus__legend_draw(const mus_sheet *sheet, mus__drawing *out)
{
    char lines[LEGEND_LINES][LEGEND_TEXT];
    const double *box = sheet->legend;
    double y = cover_title(sheet, out, box[0], box[2], box[3]) - 0.002;
    const int32_t n = legend_lines(sheet, box[2] - box[0], lines);
    for (int32_t i = 0; i < n; i++)
        mus__page_line(out, MUS__PEN_TEXT, lines[i], box[0], box[2], y -= LEGEND_PITCH, LEGEND_LETTER);
    cover_map(sheet, out, box[0], box[1], box[2] - box[0], LEGEND_MAP - LEGEND_GAP);
}
