/*
 * edge_words.c: the words at the edges of a piece, those by which the instructions name them: "armhole", "cap back".
 *
 * A word runs along its edge, inside the sew line, readable from below or from the right. It is written after all else,
 * at the place nearest to the middle of the edge where the edge is straight and the word keeps clear of every line and
 * every other word; an edge without such a place has no word. Edges of the same words that go on straight, as those of
 * a band, have one word.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "drawing/lettering.h"
#include "drawing/plain_words.h"
#include "print/page.h"

#define EDGE_CLEAR 0.002 /* [m] distance of a word from its sew line; chosen: letters with tails do not touch it */
#define EDGE_STEP 0.0025 /* [m] distance of the places that are tried; chosen: finer ones gain little */
#define EDGE_APART                                                                                                     \
    0.005 /* [m] from other words on its line, more than from lines; chosen: two words do not read as one */
#define EDGE_STRAIGHT 2.5e-4 /* [m] bend of an edge under a word that nobody sees: the width of the sew line */
#define EDGE_UPRIGHT 0.17    /* sine of 10 degrees: words as near to upright all read upwards; chosen by eye */
#define EDGE_BENT 0.001      /* [m] largest bend of an edge under a word; chosen: the word still runs along it */

/* a part of the outline of a piece with the same words: chords from `first` on */
typedef struct edge_run {
    const mus__piece *piece;
    int32_t first, n;
    double length; /* [m] */
} edge_run;

/* a word, and where it stands: the middle of its base line at the origin of the frame */
typedef struct edge_word {
    char text[MUS__PLAIN];
    double half; /* half its width [m] */
    mus__frame frame;
} edge_word;


static const double *edge_point(const mus__piece *piece, int32_t i)
{
    return piece->flat + 2 * (i % piece->nflat);
}


static double edge_chord(const mus__piece *piece, int32_t i)
{
    const double *a = edge_point(piece, i), *b = edge_point(piece, i + 1);
    return mus__hypot(b[0] - a[0], b[1] - a[1]);
}


/* the words of a side: of a sewn one those of the instructions, of a free one those of the label of the piece */
static void edge_plain(const mus_pattern *pattern, const mus__piece *piece, int32_t side, char *out)
{
    if (mus_pattern_edge_seam(pattern, piece->sides[side].edge) != MUS_NONE)
        mus__plain_edge_words(pattern, piece->sides[side].edge, out);
    else
        mus__side_words(pattern, piece, side, out);
}


/* is chord i of the outline the fold line of a half? */
static bool edge_on_fold(const mus__piece *piece, int32_t i)
{
    return piece->fold && fabs(mus__piece_inward(piece, edge_point(piece, i))) < 1e-9 &&
           fabs(mus__piece_inward(piece, edge_point(piece, i + 1))) < 1e-9;
}


/* do chord i and the next one have one word: are they of one edge, or of the same words without a corner between? */
static bool edge_goes_on(const mus_pattern *pattern, const mus__piece *piece, int32_t i)
{
    const int32_t a = piece->flat_side[i % piece->nflat], b = piece->flat_side[(i + 1) % piece->nflat];
    char words[2][MUS__PLAIN];
    if (edge_on_fold(piece, i) || edge_on_fold(piece, i + 1)) return false;
    if (a == b) return true;
    edge_plain(pattern, piece, a, words[0]);
    edge_plain(pattern, piece, b, words[1]);
    return strcmp(words[0], words[1]) == 0 && mus__piece_straight(piece, i);
}


/* the chord from `from` on that begins a run, and the run; false when there is none before the end of the outline. An
 * outline without corners begins anywhere */
static bool edge_next(const mus_pattern *pattern, const mus__piece *piece, int32_t from, edge_run *run)
{
    const int32_t n = piece->nflat;
    *run = (edge_run){.piece = piece, .first = from};
    while (run->first < n && edge_goes_on(pattern, piece, run->first + n - 1)) run->first++;
    if (run->first == n && from == 0) run->first = 0;
    if (run->first >= n) return false;
    do run->length += edge_chord(piece, run->first + run->n++);
    while (run->n < n && edge_goes_on(pattern, piece, run->first + run->n - 1));
    return true;
}


/* the point at arc length s [m] of a run */
static void edge_at(const edge_run *run, double s, double *out)
{
    int32_t i = run->first;
    double chord = edge_chord(run->piece, i);
    for (; s > chord && i + 1 < run->first + run->n; chord = edge_chord(run->piece, i)) {
        s -= chord;
        i++;
    }
    const double *a = edge_point(run->piece, i), *b = edge_point(run->piece, i + 1), t = s / chord;
    for (int32_t k = 0; k < 2; k++) out[k] = a[k] + t * (b[k] - a[k]);
}


/* lay a word along the edge with its middle at arc length s [m]; false where the edge bends by more than `bend` [m] */
static bool edge_lay(const edge_run *run, double s, double bend, edge_word *word)
{
    double a[2], b[2], from = 0.0, in = 0.0, out = 0.0;
    edge_at(run, s - word->half, a);
    edge_at(run, s + word->half, b);
    const double d = mus__hypot(b[0] - a[0], b[1] - a[1]), u[2] = {(b[0] - a[0]) / d, (b[1] - a[1]) / d};
    if (!(d > word->half)) return false;
    for (int32_t i = run->first; i < run->first + run->n; from += edge_chord(run->piece, i++)) {
        if (from < s - word->half || from > s + word->half) continue;
        const double *p = edge_point(run->piece, i), inward = u[0] * (p[1] - a[1]) - u[1] * (p[0] - a[0]);
        in = fmax(in, inward);
        out = fmin(out, inward);
    }
    if (in - out > bend) return false;

    /* the inside lies on the left of the outline; there the letters have their feet, or, of a word that runs against
     * the outline, their heads */
    const bool back = u[0] < -EDGE_UPRIGHT || (u[0] < EDGE_UPRIGHT && u[1] < 0.0);
    const double away = in + EDGE_CLEAR + (back ? MUS__CAPTION_HEIGHT : 0.0), sign = back ? -1.0 : 1.0;
    word->frame =
        (mus__frame){0.5 * (a[0] + b[0]) - away * u[1], 0.5 * (a[1] + b[1]) + away * u[0], {sign * u[0], sign * u[1]}};
    return true;
}


/* compute the box on the sheet of what must be free round a word, and `more` [m] before and behind it */
static void edge_box(const edge_word *word, double more, double *box)
{
    const double *u = word->frame.u;
    double wall[4];
    mus__words_wall(word->half + more, wall);
    for (int32_t i = 0; i < 4; i++) {
        const double along = wall[i % 2 * 2], up = wall[1 + i / 2 * 2];
        const double p[2] = {word->frame.x + along * u[0] - up * u[1], word->frame.y + along * u[1] + up * u[0]};
        for (int32_t k = 0; k < 2; k++) {
            box[k] = i == 0 ? p[k] : fmin(box[k], p[k]);
            box[2 + k] = i == 0 ? p[k] : fmax(box[2 + k], p[k]);
        }
    }
}


static bool boxes_meet(const double *a, const double *b)
{
    return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}


/* does a line of the outline of a piece, or of its cut line, pass through the word? */
static bool edge_outlines(const mus__piece *piece, const edge_word *word)
{
    double wall[4];
    mus__words_wall(word->half, wall);
    for (int32_t i = 0; i < piece->nflat; i++)
        if (mus__frame_meets(&word->frame, edge_point(piece, i), edge_point(piece, i + 1), wall)) return true;
    for (int32_t l = 0; l < piece->cut.nloop; l++) {
        const int32_t start = piece->cut.start[l], end = piece->cut.start[l + 1];
        for (int32_t i = start; i < end; i++)
            if (mus__frame_meets(&word->frame, piece->cut.xy + 2 * i, piece->cut.xy + 2 * (i + 1 < end ? i + 1 : start),
                                 wall))
                return true;
    }
    return false;
}


/* does a word keep clear of the outlines of all sizes, of what is drawn, and of the boxes of label, squares, legend? */
static bool edge_clear(const mus_sheet *sheet, int32_t index, double boxes[3][4], const edge_word *word)
{
    const mus__drawing *drawing = &sheet->drawing;
    const int32_t first = index - index % sheet->nsize;
    double wall[4], box[4];
    mus__words_wall(word->half + EDGE_APART, wall);
    edge_box(word, EDGE_APART, box);
    for (int32_t i = 0; i < 3; i++)
        if (boxes_meet(box, boxes[i])) return false;
    for (int32_t k = first; k < first + sheet->nsize; k++)
        if (edge_outlines(&sheet->pieces[k], word)) return false;
    for (int32_t i = 0; i < drawing->npath; i++) {
        const mus__path *path = &drawing->paths[i];
        if (path->layer == MUS__LAYER_CUT || path->layer == MUS__LAYER_SEAM) continue;
        if (boxes_meet(box, path->box) && mus__path_meets(drawing, path, &word->frame, wall)) return false;
    }
    return true;
}


/* find the place of a word nearest to the middle of its edge: on one page, clear of what is written on the page, where
 * the edge is straight; else where it bends; else anywhere on the pages */
static bool edge_place(const mus_sheet *sheet, int32_t index, const edge_run *run, double boxes[3][4], edge_word *word)
{
    const double most = 0.5 * run->length - word->half - MUS__WORDS_CLEAR;
    for (int32_t round = 0; round < 3; round++) {
        for (int32_t i = 0; EDGE_STEP * (i / 2) <= most; i++) {
            const double along = (i % 2 == 0 ? 1.0 : -1.0) * EDGE_STEP * (i / 2);
            double box[4];
            if (!edge_lay(run, 0.5 * run->length + along, round == 0 ? EDGE_STRAIGHT : EDGE_BENT, word)) continue;
            edge_box(word, 0.0, box);
            if (!(round < 2 ? mus__page_holds(sheet, box, true) : mus__pages_show(sheet, box))) continue;
            if (edge_clear(sheet, index, boxes, word)) return true;
        }
    }
    return false;
}


/* is an edge a leg of a dart: sewn to an edge that it meets? */
static bool edge_is_leg(const mus_pattern *pattern, int32_t edge)
{
    const int32_t seam = mus_pattern_edge_seam(pattern, edge);
    int32_t a[2], b[2];
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    if (seam == MUS_NONE || mus_pattern_seam(pattern, seam, &def) != MUS_OK) return false;
    if (def.laid) return true;
    if (def.closure != MUS_CLOSURE_NONE ||
        mus_pattern_edge_panel(pattern, def.edge_a) != mus_pattern_edge_panel(pattern, def.edge_b))
        return false;
    mus_pattern_edge_ends(pattern, def.edge_a, &a[0], &a[1]);
    mus_pattern_edge_ends(pattern, def.edge_b, &b[0], &b[1]);
    return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}


/* compute what a word of a piece keeps away from as a whole: its label, and test squares and legend inside it */
static void edge_boxes(const mus_sheet *sheet, int32_t index, double boxes[3][4])
{
    memset(boxes, 0, 3 * sizeof *boxes);
    bool first = true;
    for (int32_t i = 0; i < sheet->drawing.npath; i++) {
        const mus__path *path = &sheet->drawing.paths[i];
        if (path->piece != index || path->layer != MUS__LAYER_LABEL || path->nop == 0) continue;
        for (int32_t k = 0; k < 2; k++) {
            boxes[0][k] = first ? path->box[k] : fmin(boxes[0][k], path->box[k]);
            boxes[0][2 + k] = first ? path->box[2 + k] : fmax(boxes[0][2 + k], path->box[2 + k]);
        }
        first = false;
    }
    if (!sheet->tiled || sheet->cover) return;
    for (int32_t k = 0; k < 2; k++) {
        boxes[1][k] = sheet->squares[k];
        boxes[1][2 + k] = sheet->squares[k] + MUS__SQUARES;
    }
    memcpy(boxes[2], sheet->legend, sizeof boxes[2]);
}


void mus__edge_words_draw(mus_sheet *sheet, const mus_pattern *pattern, int32_t index)
{
    const mus__piece *piece = &sheet->pieces[index];
    double boxes[3][4];
    edge_run run;
    edge_boxes(sheet, index, boxes);
    for (int32_t from = 0; edge_next(pattern, piece, from, &run); from = run.first + run.n) {
        const int32_t side = piece->flat_side[run.first], edge = piece->sides[side].edge;
        char plain[MUS__PLAIN];
        edge_word word;
        edge_plain(pattern, piece, side, plain);
        if (strcmp(plain, "edge") == 0 || edge_on_fold(piece, run.first) || edge_is_leg(pattern, edge)) continue;
        mus__plain_words_in(sheet->language, "edge", plain, word.text);
        word.half = 0.5 * MUS__CAPTION_HEIGHT * mus__lettering_width(sheet->lettering, word.text, false);
        if (!edge_place(sheet, index, &run, boxes, &word)) continue;
        const mus__text_style style = {MUS__CAPTION_HEIGHT, word.frame.u[0], word.frame.u[1], 0.5};
        mus__draw_path(&sheet->drawing, index, MUS__LAYER_MARKS, MUS__PEN_TEXT);
        mus__draw_text(&sheet->drawing, word.text, word.frame.x, word.frame.y, &style);
    }
}
