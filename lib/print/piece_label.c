/*
 * piece_label.c: the label of a piece: its lines of text, and the place where they fit.
 *
 * The label is tried at several sizes, upright and lying (turned by a quarter), at the points of a lattice over the
 * piece. The first size that fits inside the sew line, clear of grain line and marks, is taken, at the place nearest to
 * the middle. A piece too small for any size gets the smallest label in its middle.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/elementary.h"
#include "drawing/lettering.h"
#include "drawing/phrase.h"
#include "drawing/plain_words.h"
#include "print/page.h"

#define LABEL_ALLOWANCES 5 /* most lines about allowances; chosen: all edges of the richest draft have room */
#define LABEL_LINES (7 + LABEL_ALLOWANCES) /* most lines of a label: as many as label_fill adds */
#define LABEL_WIDTHS 8  /* most allowances of a piece that are told apart; chosen: twice those of the richest draft */
#define LABEL_SAME 5e-5 /* [m] allowances this near are one: half of what a label tells */
#define LABEL_NAMED 3   /* edges from which on one allowance is that of the "other edges"; chosen: lines stay short */
#define LABEL_WIDE 0.11 /* [m] from which on allowances go on in a new line; chosen: as wide as a long name */
#define LABEL_BYTES 256  /* [bytes] of a line of a label with its zero byte; longer ones are cut; chosen */
#define LABEL_PITCH 1.75 /* height of a line over that of its capitals; chosen: letters with tails keep clear */
#define LABEL_LATTICE 24 /* points tried in each direction; chosen: more cost time and gain little */
#define LABEL_PAD 0.004  /* [m] distance kept free round the label; chosen: its letters do not touch lines */
/* [m] added to the distance from the middle of a lying label; chosen: larger values prefer upright labels more */
#define LYING 0.05
/* [m] added to the distance of a label that the edge of a page cuts; chosen: larger values avoid such places more */
#define ACROSS 0.15

typedef struct label_line {
    char text[LABEL_BYTES];
    double height; /* of a capital, at full size [m] */
    bool bold;
} label_line;

typedef struct label_block {
    label_line lines[LABEL_LINES];
    int32_t n;
    double width, height; /* at full size [m] */
} label_block;

/* what the label must not touch: segments, and the test squares and the legend, which may lie inside a piece */
typedef struct label_walls {
    int32_t n, room;
    double *xy; /* (n x 4) */
    double box[2][4];
} label_walls;

/* place of the label: its middle [m], scale and direction */
typedef struct label_place {
    double x, y, scale;
    bool lying;
} label_place;


static label_line *label_add(label_block *block, double height, bool bold)
{
    label_line *line = &block->lines[block->n++];
    line->height = height;
    line->bold = bold;
    return line;
}


/* an allowance, and the edges of the piece that have it */
typedef struct label_width {
    double width; /* [m] */
    int32_t n;    /* edges of other words than each other */
    char words[LABEL_NAMED][MUS__PLAIN];
} label_width;


/* is a side without an allowance the leg of a dart, which is folded shut and not cut? */
static bool label_folded(const mus_pattern *pattern, const mus__side *side)
{
    return side->width == 0.0 && mus_pattern_edge_seam(pattern, side->edge) != MUS_NONE;
}


void mus__side_words(const mus_pattern *pattern, const mus__piece *piece, int32_t side, char *out)
{
    char other[MUS__PLAIN];
    mus__plain_edge_words(pattern, piece->sides[side].edge, out);
    for (int32_t k = 0; k < piece->nside; k++) {
        if (fabs(piece->sides[k].width - piece->sides[side].width) <= LABEL_SAME) continue;
        mus__plain_edge_words(pattern, piece->sides[k].edge, other);
        if (strcmp(out, other) != 0) continue;
        mus__plain_edge_name(pattern, piece->sides[side].edge, out);
        return;
    }
}


/* list the allowances of a piece in the order of the outline; returns their number */
static int32_t label_widths(const mus_sheet *sheet, const mus_pattern *pattern, const mus__piece *piece,
                            label_width *widths)
{
    int32_t n = 0;
    for (int32_t i = 0; i < piece->nside; i++) {
        int32_t k = 0, w = 0;
        char plain[MUS__PLAIN], words[MUS__PLAIN];
        if (label_folded(pattern, &piece->sides[i])) continue;
        while (k < n && fabs(widths[k].width - piece->sides[i].width) > LABEL_SAME) k++;
        if (k == LABEL_WIDTHS) continue;
        if (k == n) widths[n++] = (label_width){.width = piece->sides[i].width};
        mus__side_words(pattern, piece, i, plain);
        mus__plain_words_in(sheet->language, "edge", plain, words);
        while (w < widths[k].n && w < LABEL_NAMED && strcmp(widths[k].words[w], words) != 0) w++;
        if (w < widths[k].n) continue;
        if (w < LABEL_NAMED) memcpy(widths[k].words[w], words, sizeof words);
        widths[k].n++;
    }
    return n;
}


/* write "hem 25 mm", "hem, side 10 mm", "other edges 10 mm", or "no allowance: inner" */
static void label_edges(const mus_sheet *sheet, const label_width *width, bool others, char *out, size_t size)
{
    char words[LABEL_BYTES] = "", number[32];
    size_t at = 0;
    mus__phrase phrase = mus__phrase_in(sheet->language);
    for (int32_t i = 0; i < width->n && i < LABEL_NAMED && at < sizeof words && !others; i++)
        at += (size_t)snprintf(words + at, sizeof words - at, "%s%s",
                               i > 0 ? mus_language_text(sheet->language, "list.comma") : "", width->words[i]);
    mus__print_millimetres(number, sizeof number, width->width);
    mus__phrase_text(&phrase, 0, others ? mus_language_text(sheet->language, "paper.other_edges") : words);
    mus__phrase_text(&phrase, 1, number);
    mus__phrase_write(&phrase, width->width > 0.0 ? "paper.edge" : "paper.none_at", out, size);
}


/* add the lines about allowances: one for all edges, or each with the edges that have it, of which the one of most
 * edges comes last, as that of all others */
static void label_allowance(const mus_sheet *sheet, const mus_pattern *pattern, const mus__piece *piece,
                            label_block *block)
{
    label_width widths[LABEL_WIDTHS];
    const int32_t n = label_widths(sheet, pattern, piece, widths);
    const char *semicolon = mus_language_text(sheet->language, "list.semicolon");
    const int32_t lines = block->n;
    int32_t most = 0;
    char text[LABEL_BYTES], first[LABEL_BYTES];
    mus__phrase phrase = mus__phrase_in(sheet->language);
    label_line *line = label_add(block, 0.0035, false);
    if (n <= 1) {
        mus__print_millimetres(text, sizeof text, n > 0 ? widths[0].width : 0.0);
        mus__phrase_text(&phrase, 0, text);
        mus__phrase_write(&phrase, n == 0 || widths[0].width == 0.0 ? "paper.no_allowance" : "paper.allowance",
                          line->text, LABEL_BYTES);
        return;
    }
    for (int32_t k = 1; k < n; k++)
        if (widths[k].n > widths[most].n) most = k;
    for (int32_t k = 0; k < n; k++) {
        const int32_t own = k + 1 == n ? most : k < most ? k : k + 1;
        label_edges(sheet, &widths[own], own == most && widths[own].n >= LABEL_NAMED, text, sizeof text);
        if (k == 0) {
            memcpy(first, text, sizeof first);
            mus__phrase_text(&phrase, 0, first);
            mus__phrase_write(&phrase, "paper.allowance_at", line->text, LABEL_BYTES);
            continue;
        }
        const size_t at = strlen(line->text);
        const double width = line->height * (mus__lettering_width(sheet->lettering, line->text, false) +
                                             mus__lettering_width(sheet->lettering, text, false));
        if (width > LABEL_WIDE && block->n < lines + LABEL_ALLOWANCES) {
            /* the mark between the items ends the line, without its blank */
            const int mark = (int)strlen(semicolon) - (semicolon[strlen(semicolon) - 1] == ' ');
            snprintf(line->text + at, LABEL_BYTES - at, "%.*s", mark, semicolon);
            line = label_add(block, line->height, false);
            snprintf(line->text, LABEL_BYTES, "%s", text);
        } else {
            snprintf(line->text + at, LABEL_BYTES - at, "%s%s", semicolon, text);
        }
    }
}


static void label_fill(const mus_sheet *sheet, const mus_pattern *pattern, int32_t index, label_block *block)
{
    const mus__piece *piece = &sheet->pieces[index];
    mus__phrase phrase = mus__phrase_in(sheet->language);
    memset(block, 0, sizeof *block);

    snprintf(label_add(block, 0.0045, false)->text, LABEL_BYTES, "%.120s", sheet->title);
    mus__sheet_piece_words(sheet, index, label_add(block, 0.008, true)->text, LABEL_BYTES);
    mus__phrase_number(&phrase, 0, index / sheet->nsize + 1);
    mus__phrase_number(&phrase, 1, sheet->npiece / sheet->nsize);
    mus__phrase_write(&phrase, "paper.piece", label_add(block, 0.0045, false)->text, LABEL_BYTES);
    mus__piece_cut_text(piece, sheet->language, label_add(block, 0.0055, true)->text, LABEL_BYTES);
    if (sheet->nsize > 1) mus__sheet_sizes(sheet, label_add(block, 0.0045, false)->text, LABEL_BYTES);
    if (sheet->person != NULL) {
        char person[128];
        snprintf(person, sizeof person, "%.120s", sheet->person);
        mus__phrase_text(&phrase, 0, person);
        mus__phrase_write(&phrase, "paper.person", label_add(block, 0.0045, false)->text, LABEL_BYTES);
    }
    label_allowance(sheet, pattern, piece, block);
    mus__phrase_write(&phrase, "paper.scale", label_add(block, 0.0035, false)->text, LABEL_BYTES);

    for (int32_t i = 0; i < block->n; i++) {
        const label_line *line = &block->lines[i];
        double width = line->height * mus__lettering_width(sheet->lettering, line->text, line->bold);
        block->width = width > block->width ? width : block->width;
        block->height += line->height * (i > 0 ? LABEL_PITCH : 1.0);
    }
}


static mus_status walls_add(mus_context *context, label_walls *walls, const double *a, const double *b)
{
    mus_status status = mus__print_reserve(context, &walls->xy, &walls->room, 4 * (int64_t)walls->n + 4,
                                           sizeof *walls->xy);
    if (status != MUS_OK) return status;
    memcpy(walls->xy + 4 * walls->n, a, 2 * sizeof *a);
    memcpy(walls->xy + 4 * walls->n + 2, b, 2 * sizeof *b);
    walls->n++;
    return MUS_OK;
}


static mus_status walls_build(const mus_sheet *sheet, const mus_pattern *pattern, const mus__piece *piece,
                              const double *grain, label_walls *walls)
{
    double bracket[4] = {piece->box[0], piece->box[1], piece->box[2], piece->box[3]};
    bracket[piece->across] = bracket[2 + piece->across] = piece->axis + piece->inward * MUS__FOLD_BRACKET;
    mus_status status = walls_add(sheet->context, walls, grain, grain + 2);
    if (status == MUS_OK && piece->fold) status = walls_add(sheet->context, walls, bracket, bracket + 2);
    for (int32_t i = 0; i < piece->nflat && status == MUS_OK; i++)
        status = walls_add(sheet->context, walls, piece->flat + 2 * i, piece->flat + 2 * ((i + 1) % piece->nflat));
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern) && status == MUS_OK; i++) {
        int32_t panel, n;
        const char *name;
        const double *xy;
        status = mus_pattern_mark(pattern, i, &panel, &name, &n, &xy);
        if (status != MUS_OK || panel != piece->panel) continue;
        for (int32_t k = 0; k < n && status == MUS_OK; k++) {
            double a[2], b[2];
            mus__piece_point(piece, xy + 2 * k, a);
            mus__piece_point(piece, xy + 2 * (k + 1 < n ? k + 1 : k), b);
            status = walls_add(sheet->context, walls, a, b);
        }
        mus__caption caption;
        if (status != MUS_OK || !mus__mark_caption(pattern, piece, sheet->lettering, sheet->language, i, &caption))
            continue;
        const mus__text_style *style = &caption.style;
        double half = 0.5 * style->height * mus__lettering_width(sheet->lettering, caption.text, false);
        const double from[2] = {caption.x - half * style->cosine, caption.y - half * style->sine};
        const double to[2] = {caption.x + half * style->cosine, caption.y + half * style->sine};
        status = walls_add(sheet->context, walls, from, to);
    }
    return status;
}


/* true when the middle of the box is inside the piece and no wall meets the box */
static bool label_fits(const mus__piece *piece, const label_walls *walls, const double *box)
{
    bool inside = mus__piece_inside(piece, 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3]));
    for (int32_t i = 0; i < 2 && inside; i++) {
        const double *wall = walls->box[i];
        inside = box[0] > wall[2] || box[2] < wall[0] || box[1] > wall[3] || box[3] < wall[1];
    }
    for (int32_t i = 0; i < walls->n && inside; i++)
        if (mus__segment_meets(walls->xy + 4 * i, walls->xy + 4 * i + 2, box)) inside = false;
    return inside;
}


/* find the place nearest to the middle of the sew line's box, at the largest size that fits; a lying label, or one that
 * crosses the edge of a page, counts as farther away */
static label_place label_find(const mus_sheet *sheet, const mus__piece *piece, const label_walls *walls,
                              const label_block *block)
{
    static const double scales[] = {1.0, 0.85, 0.7, 0.55, 0.42, 0.3};
    double from[2] = {piece->flat[0], piece->flat[1]}, to[2] = {piece->flat[0], piece->flat[1]};
    for (int32_t i = 0; i < 2 * piece->nflat; i++) {
        from[i % 2] = piece->flat[i] < from[i % 2] ? piece->flat[i] : from[i % 2];
        to[i % 2] = piece->flat[i] > to[i % 2] ? piece->flat[i] : to[i % 2];
    }
    double middle[2] = {0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
    label_place best = {middle[0], middle[1], 0.3, to[1] - from[1] > to[0] - from[0]};
    for (int32_t s = 0; s < (int32_t)(sizeof scales / sizeof scales[0]); s++) {
        double nearest = HUGE_VAL;
        for (int32_t i = 0; i < 2 * LABEL_LATTICE * LABEL_LATTICE; i++) {
            int32_t lying = i % 2, column = i / 2 % LABEL_LATTICE, row = i / 2 / LABEL_LATTICE;
            double x = from[0] + (to[0] - from[0]) * (column + 0.5) / LABEL_LATTICE;
            double y = from[1] + (to[1] - from[1]) * (row + 0.5) / LABEL_LATTICE;
            double w = 0.5 * scales[s] * (lying ? block->height : block->width) + LABEL_PAD * scales[s];
            double h = 0.5 * scales[s] * (lying ? block->width : block->height) + LABEL_PAD * scales[s];
            const double box[4] = {x - w, y - h, x + w, y + h};
            double away = mus__hypot(x - middle[0], y - middle[1]) + (lying ? LYING : 0.0);
            if (away < nearest && !mus__page_holds(sheet, box, false)) away += ACROSS;
            if (away >= nearest || !label_fits(piece, walls, box) || !mus__pages_show(sheet, box)) continue;
            nearest = away;
            best = (label_place){x, y, scales[s], lying};
        }
        if (nearest < HUGE_VAL) break;
    }
    return best;
}


mus_status mus__label_draw(mus_sheet *sheet, const mus_pattern *pattern, int32_t index, const double *grain)
{
    const mus__piece *piece = &sheet->pieces[index];
    label_walls walls = {0};
    if (sheet->tiled && !sheet->cover) {
        const double squares[4] = {sheet->squares[0], sheet->squares[1], sheet->squares[0] + MUS__SQUARES,
                                   sheet->squares[1] + MUS__SQUARES};
        memcpy(walls.box[0], squares, sizeof squares);
        memcpy(walls.box[1], sheet->legend, sizeof sheet->legend);
    }
    label_block block;
    label_fill(sheet, pattern, index, &block);
    mus_status status = walls_build(sheet, pattern, piece, grain, &walls);
    if (status == MUS_OK) {
        label_place place = label_find(sheet, piece, &walls, &block);
        double down = 0.5 * block.height * place.scale;
        for (int32_t i = 0; i < block.n; i++) {
            const label_line *line = &block.lines[i];
            down -= line->height * place.scale * (i > 0 ? LABEL_PITCH : 1.0);
            mus__text_style style = {line->height * place.scale, place.lying ? 0.0 : 1.0, place.lying ? 1.0 : 0.0, 0.5};
            mus__pen pen = style.height < 0.0025 ? MUS__PEN_SMALL : line->bold ? MUS__PEN_TITLE : MUS__PEN_TEXT;
            mus__draw_path(&sheet->drawing, index, MUS__LAYER_LABEL, pen);
            mus__draw_text(&sheet->drawing, line->text, place.x - (place.lying ? down : 0.0),
                           place.y + (place.lying ? 0.0 : down), &style);
        }
    }
    mus__print_free(sheet->context, walls.xy);
    return status;
}
