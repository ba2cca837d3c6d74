/*
 * piece_marks.c: the lines of a placed piece: cut line, sew line, grain line, marks.
 *
 * The sew line is one path for each edge, so that every edge can be measured on the paper.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "muslin/language.h"
#include "drawing/lettering.h"
#include "print/sheet.h"

#define GRAIN_CHORDS 25    /* lines tried for the grain line; chosen: with more the line is a little longer */
#define FOLD_WORDS 0.022 /* [m] half the length of a bracket at least; chosen: its words fit between its arrows */
#define ARROW 0.006      /* [m] length of an arrow head; chosen: visible at arm's length */
/* [m] distance from the mark to the base line of its name; chosen: capitals do not touch the mark */
#define CAPTION_CLEAR 0.004
#define CAPTION_SAME 1e-6 /* [m] a point this near to a line lies on it; chosen: above rounding */
#define DRILL 0.003      /* [m] half the width of the cross of a drill point; chosen: seen at arm's length */


static void marks_spans(mus__drawing *out, const mus__piece *piece, int32_t first, int32_t last)
{
    mus__draw_move(out, piece->spans[first].p[0], piece->spans[first].p[1]);
    for (int32_t i = first; i <= last; i++) {
        const mus__span *span = &piece->spans[i];
        if (span->line) mus__draw_line(out, span->p[6], span->p[7]);
        else mus__draw_curve(out, span->p + 2);
    }
}


static bool marks_on_fold(const mus__piece *piece, const double *p)
{
    return fabs(p[piece->across] - piece->axis) < 1e-9;
}


/* draw the cut line of a half without the fold line: from its one end round to the other */
static void marks_half(mus__drawing *out, const mus__piece *piece)
{
    const int32_t n = piece->cut.n;
    int32_t first = 0;
    double longest = -1.0;
    for (int32_t i = 0; i < n; i++) {
        const double *p = piece->cut.xy + 2 * i, *q = piece->cut.xy + 2 * ((i + 1) % n);
        const double length = fabs(q[1 - piece->across] - p[1 - piece->across]);
        /* a corner on the fold line is there twice: the longest part on it is the fold line */
        if (!marks_on_fold(piece, p) || !marks_on_fold(piece, q) || length <= longest) continue;
        longest = length;
        first = (i + 1) % n;
    }
    for (int32_t i = 0; i < n; i++) {
        const double *p = piece->cut.xy + 2 * ((first + i) % n);
        if (i == 0) mus__draw_move(out, p[0], p[1]);
        else mus__draw_line(out, p[0], p[1]);
    }
}


static void marks_cut(mus__drawing *out, const mus__piece *piece, int32_t index)
{
    double widest = 0.0;
    for (int32_t i = 0; i < piece->nside; i++) widest = piece->sides[i].width > widest ? piece->sides[i].width : widest;

    /* without any allowance and dart the cut line is the sew line with its curves */
    mus__draw_path(out, index, MUS__LAYER_CUT, MUS__PEN_CUT);
    if (widest == 0.0 && piece->ndart == 0 && !piece->fold) {
        marks_spans(out, piece, 0, piece->nspan - 1);
        mus__draw_close(out);
        return;
    }
    if (piece->fold) {
        marks_half(out, piece);
        return;
    }
    for (int32_t i = 0; i < piece->cut.nloop; i++) {
        for (int32_t k = piece->cut.start[i]; k < piece->cut.start[i + 1]; k++) {
            const double *p = piece->cut.xy + 2 * k;
            if (k == piece->cut.start[i]) mus__draw_move(out, p[0], p[1]);
            else mus__draw_line(out, p[0], p[1]);
        }
        mus__draw_close(out);
    }
}


static void marks_seam(mus__drawing *out, const mus__piece *piece, int32_t index)
{
    for (int32_t i = 0, end; i < piece->nspan; i = end) {
        for (end = i + 1; end < piece->nspan && piece->spans[end].side == piece->spans[i].side;) end++;
        mus__draw_path(out, index, MUS__LAYER_SEAM, MUS__PEN_SEAM);
        mus__draw_edge(out, piece->sides[piece->spans[i].side].edge);
        marks_spans(out, piece, i, end - 1);
    }
}


/* compute the longest part, low to high, of the line along the grain at `at` across it that lies inside the sew line */
static double marks_chord(const mus__piece *piece, double at, double *low, double *high)
{
    const int32_t g = piece->grain, c = 1 - g;
    double best = 0.0;
    for (int32_t i = 0; i < piece->nflat; i++) {
        const double *a = piece->flat + 2 * i, *b = piece->flat + 2 * ((i + 1) % piece->nflat);
        /* the inside lies above a chord that runs to the right, and right of one that runs down */
        if (g == 1 ? !(a[0] <= at && b[0] > at) : !(b[1] <= at && a[1] > at)) continue;
        double from = a[g] + (b[g] - a[g]) * (at - a[c]) / (b[c] - a[c]), to = HUGE_VAL;
        for (int32_t k = 0; k < piece->nflat; k++) {
            const double *p = piece->flat + 2 * k, *q = piece->flat + 2 * ((k + 1) % piece->nflat);
            if (g == 1 ? !(q[0] <= at && p[0] > at) : !(p[1] <= at && q[1] > at)) continue;
            double y = p[g] + (q[g] - p[g]) * (at - p[c]) / (q[c] - p[c]);
            if (y > from && y < to) to = y;
        }
        if (to < HUGE_VAL && to - from > best) {
            best = to - from;
            *low = from;
            *high = to;
        }
    }
    return best;
}


/* draw an arrow head at p along the coordinate `along`, up or down it */
static void marks_arrow(mus__drawing *out, const double *p, int32_t along, double up, double size)
{
    double wing[2][2];
    for (int32_t i = 0; i < 2; i++) {
        wing[i][along] = p[along] - up * size;
        wing[i][1 - along] = p[1 - along] + (i == 0 ? -0.25 : 0.25) * size;
    }
    mus__draw_move(out, p[0], p[1]);
    mus__draw_line(out, wing[0][0], wing[0][1]);
    mus__draw_line(out, wing[1][0], wing[1][1]);
    mus__draw_close(out);
}


/* draw the grain line, a double arrow: two thirds of the longest line along the grain inside the piece, at 0.3 of the
 * piece's width if the line there is long enough */
static void marks_grain(mus__drawing *out, const mus__piece *piece, int32_t index, double *grain)
{
    const int32_t g = piece->grain, c = 1 - g;
    double left = piece->flat[c], right = left, most = 0.0;
    double lengths[GRAIN_CHORDS], low[GRAIN_CHORDS], high[GRAIN_CHORDS];
    for (int32_t i = 1; i < piece->nflat; i++) {
        left = fmin(left, piece->flat[2 * i + c]);
        right = fmax(right, piece->flat[2 * i + c]);
    }
    for (int32_t i = 0; i < GRAIN_CHORDS; i++) {
        lengths[i] = marks_chord(piece, left + (right - left) * (i + 0.5) / GRAIN_CHORDS, &low[i], &high[i]);
        most = lengths[i] > most ? lengths[i] : most;
    }
    int32_t best = 0;
    double nearest = HUGE_VAL;
    for (int32_t i = 0; i < GRAIN_CHORDS; i++) {
        double away = fabs((i + 0.5) / GRAIN_CHORDS - 0.3);
        if (lengths[i] < 0.75 * most || away >= nearest) continue;
        best = i;
        nearest = away;
    }
    double half = lengths[best] / 3.0, middle = 0.5 * (low[best] + high[best]);
    double size = half > 2.0 * ARROW ? ARROW : 0.5 * half;
    grain[c] = grain[2 + c] = left + (right - left) * (best + 0.5) / GRAIN_CHORDS;
    grain[g] = middle - half;
    grain[2 + g] = middle + half;
    double shaft[2] = {grain[0], grain[1]}, tip[2] = {grain[2], grain[3]};
    shaft[g] += 0.5 * size;
    tip[g] -= 0.5 * size;
    mus__draw_path(out, index, MUS__LAYER_GRAIN, MUS__PEN_GRAIN);
    mus__draw_move(out, shaft[0], shaft[1]);
    mus__draw_line(out, tip[0], tip[1]);
    mus__draw_path(out, index, MUS__LAYER_GRAIN, MUS__PEN_INK);
    marks_arrow(out, grain + 2, g, 1.0, size);
    marks_arrow(out, grain, g, -1.0, size);
}


/* the name of a mark in a language */
static const char *caption_name(int32_t language, const char *name)
{
    char key[64];
    snprintf(key, sizeof key, "mark.%s", name);
    const char *text = language != MUS_LANGUAGE_ENGLISH ? mus_language_text(language, key) : NULL;
    return text != NULL ? text : name;
}


/* does a point lie on a line of n points, of at least one segment? */
static bool caption_on(const double *p, int32_t n, const double *xy)
{
    for (int32_t k = 0; k + 1 < n; k++) {
        const double *a = xy + 2 * k, dx = a[2] - a[0], dy = a[3] - a[1], d = dx * dx + dy * dy;
        const double x = p[0] - a[0], y = p[1] - a[1], along = x * dx + y * dy, across = x * dy - y * dx;
        if (d > 0.0 && along >= 0.0 && along <= d && fabs(across) <= CAPTION_SAME * sqrt(d)) return true;
    }
    return false;
}


/* write the names of the marks that have the caption of a mark: its own, and those of the points on a line; false for
 * such a point itself */
static bool caption_names(const mus_pattern *pattern, int32_t language, int32_t mark, char *out)
{
    int32_t panel, n, own;
    const char *name;
    const double *xy;
    if (mus_pattern_mark(pattern, mark, &own, &name, &n, &xy) != MUS_OK) return false;
    size_t at = (size_t)snprintf(out, MUS__CAPTION, "%s", caption_name(language, name));
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        int32_t points;
        const double *other;
        if (mus_pattern_mark(pattern, i, &panel, &name, &points, &other) != MUS_OK || panel != own) continue;
        if (n == 1 && caption_on(xy, points, other)) return false;
        if (points != 1 || at >= MUS__CAPTION || !caption_on(other, n, xy)) continue;
        at += (size_t)snprintf(out + at, MUS__CAPTION - at, "%s%s", mus_language_text(language, "list.comma"),
                               caption_name(language, name));
    }
    return true;
}


/* a caption: half as wide [m], its middle at the origin of a frame, its base line along it */
typedef struct caption_box {
    const mus__piece *piece;
    double half;
    mus__frame frame;
} caption_box;


/* does a segment of the sheet meet the box? */
static bool caption_meets(const caption_box *box, const double *a, const double *b)
{
    double wall[4];
    mus__words_wall(box->half, wall);
    return mus__frame_meets(&box->frame, a, b, wall);
}


/* does the box keep clear of cut line, sew line, darts and marks? */
static bool caption_clear(const mus_pattern *pattern, const caption_box *box)
{
    const mus__piece *piece = box->piece;
    for (int32_t i = 0; i < piece->nflat; i++)
        if (caption_meets(box, piece->flat + 2 * i, piece->flat + 2 * ((i + 1) % piece->nflat))) return false;
    for (int32_t l = 0; l < piece->cut.nloop; l++)
        for (int32_t k = piece->cut.start[l], end = piece->cut.start[l + 1]; k < end; k++)
            if (caption_meets(box, piece->cut.xy + 2 * k,
                              piece->cut.xy + 2 * (k + 1 < end ? k + 1 : piece->cut.start[l])))
                return false;
    for (int32_t i = 0; i < piece->ndart; i++)
        if (caption_meets(box, piece->darts + 8 * i + 2, piece->darts + 8 * i + 6)) return false;
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        int32_t panel, n;
        const double *xy;
        double a[2], b[2];
        if (mus_pattern_mark(pattern, i, &panel, NULL, &n, &xy) != MUS_OK || panel != piece->panel) continue;
        for (int32_t k = 0; k + 1 < n; k++) {
            mus__piece_point(piece, xy + 2 * k, a);
            mus__piece_point(piece, xy + 2 * k + 2, b);
            if (caption_meets(box, a, b)) return false;
        }
    }
    return true;
}


/* move a caption that lines run through along its mark of the length d [m], in steps of the height of its letters, on
 * the one or the other side of it, no farther than past its end: to the nearest place that is clear; without one it
 * stays */
static void caption_move(const mus_pattern *pattern, const mus__piece *piece, const mus__lettering *lettering, double d,
                         mus__caption *out)
{
    const double c = out->style.cosine, s = out->style.sine, half = 0.5 * MUS__CAPTION_HEIGHT;
    const double wide = half * mus__lettering_width(lettering, out->text, false);
    const double most = 0.5 * d + wide + CAPTION_CLEAR;
    for (int32_t i = 0; MUS__CAPTION_HEIGHT * (i / 4) <= most; i++) {
        const double along = (i % 2 == 0 ? 1.0 : -1.0) * MUS__CAPTION_HEIGHT * (i / 4);
        const double across = i % 4 < 2 ? 0.0 : -(2.0 * CAPTION_CLEAR + MUS__CAPTION_HEIGHT);
        const mus__frame frame = {out->x + along * c - across * s, out->y + along * s + across * c, {c, s}};
        const caption_box box = {piece, wide, frame};
        if (!caption_clear(pattern, &box)) continue;
        out->x = frame.x;
        out->y = frame.y;
        return;
    }
}


/* the text runs along the mark from its first to its last point, readable from below or from the right */
bool mus__mark_caption(const mus_pattern *pattern, const mus__piece *piece, const mus__lettering *lettering,
                       int32_t language, int32_t mark, mus__caption *out)
{
    int32_t panel, n;
    const double *xy;
    double a[2], b[2];
    if (mus_pattern_mark(pattern, mark, &panel, NULL, &n, &xy) != MUS_OK || panel != piece->panel || n < 1 ||
        !caption_names(pattern, language, mark, out->text))
        return false;
    mus__piece_point(piece, xy, a);
    mus__piece_point(piece, xy + 2 * (n - 1), b);
    double dx = b[0] - a[0], dy = b[1] - a[1], d = sqrt(dx * dx + dy * dy);
    out->style = (mus__text_style){MUS__CAPTION_HEIGHT, 1.0, 0.0, 0.5};
    if (d > 0.0) {
        double sign = dx < -1e-9 || (dx < 1e-9 && dy < 0.0) ? -1.0 : 1.0;
        out->style.cosine = sign * dx / d;
        out->style.sine = sign * dy / d;
    }
    out->x = 0.5 * (a[0] + b[0]) - CAPTION_CLEAR * out->style.sine;
    out->y = 0.5 * (a[1] + b[1]) + CAPTION_CLEAR * out->style.cosine;
    const double at[2] = {out->x, out->y};
    if (piece->fold && !(mus__piece_inward(piece, at) > 0.0)) return false;
    caption_move(pattern, piece, lettering, d, out);
    return true;
}


/* draw a segment of a mark, of a half the part on its side of the fold line */
static void marks_segment(mus__drawing *out, const mus__piece *piece, const double *from, const double *to, bool *open)
{
    double a[2] = {from[0], from[1]}, b[2] = {to[0], to[1]};
    if (piece->fold) {
        const bool in = mus__piece_inward(piece, a) >= 0.0, next = mus__piece_inward(piece, b) >= 0.0;
        if (in != next) {
            const int32_t c = piece->across, d = 1 - c;
            double *cut = in ? b : a;
            cut[d] = from[d] + (to[d] - from[d]) * (piece->axis - from[c]) / (to[c] - from[c]);
            cut[c] = piece->axis;
        }
        if (!in) *open = false;
        if (!in && !next) return;
    }
    if (!*open) mus__draw_move(out, a[0], a[1]);
    mus__draw_line(out, b[0], b[1]);
    *open = true;
}


/* a step of a path to a point at `x` across the fold line and `y` along it */
static void marks_fold_step(mus__drawing *out, const mus__piece *piece, bool move, double x, double y)
{
    const double p[2] = {piece->across == 0 ? x : y, piece->across == 0 ? y : x};
    if (move)
        mus__draw_move(out, p[0], p[1]);
    else
        mus__draw_line(out, p[0], p[1]);
}


/* draw the fold line of a half, and a bracket with arrows that point at it */
static void marks_fold(mus__drawing *out, const mus__piece *piece, int32_t index)
{
    const int32_t along = 1 - piece->across;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int32_t i = 0; i < piece->cut.n; i++) {
        if (!marks_on_fold(piece, piece->cut.xy + 2 * i)) continue;
        low = fmin(low, piece->cut.xy[2 * i + along]);
        high = fmax(high, piece->cut.xy[2 * i + along]);
    }
    if (!(high > low)) return;
    const double x = piece->axis, tip = x + piece->inward * ARROW, bracket = x + piece->inward * MUS__FOLD_BRACKET;
    const double third = fmin((high - low) / 3.0, fmax(0.0, 0.5 * (high - low) - FOLD_WORDS));
    mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_MARK);
    marks_fold_step(out, piece, true, x, low);
    marks_fold_step(out, piece, false, x, high);
    if (piece->follower) return;
    mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_SQUARE);
    marks_fold_step(out, piece, true, tip, low + third);
    marks_fold_step(out, piece, false, bracket, low + third);
    marks_fold_step(out, piece, false, bracket, high - third);
    marks_fold_step(out, piece, false, tip, high - third);
    mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_INK);
    for (int32_t i = 0; i < 2; i++) {
        const double y = i == 0 ? low + third : high - third;
        marks_fold_step(out, piece, true, x, y);
        marks_fold_step(out, piece, false, tip, y - 0.25 * ARROW);
        marks_fold_step(out, piece, false, tip, y + 0.25 * ARROW);
        mus__draw_close(out);
    }
    mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_TEXT);
    /* between the fold line and its bracket; beside an upright one the words run upwards */
    const double words = bracket - (piece->inward > 0.0 ? 0.0015 : -0.004), middle = 0.5 * (low + high);
    if (piece->across == 0)
        mus__draw_text(out, mus_language_text(out->language, "paper.fold"), words, middle,
                       &(mus__text_style){MUS__CAPTION_HEIGHT, 0.0, 1.0, 0.5});
    else
        mus__draw_text(out, mus_language_text(out->language, "paper.fold"), middle,
                       bracket - (piece->inward > 0.0 ? 0.004 : -0.0015),
                       &(mus__text_style){MUS__CAPTION_HEIGHT, 1.0, 0.0, 0.5});
}


/* is a line too short for its dashes to show as one line? It is drawn without them: a buttonhole */
static bool marks_short(int32_t n, const double *xy)
{
    const double *dash = mus__pen_styles[MUS__PEN_MARK].dash;
    double length = 0.0;
    for (int32_t k = 0; k + 1 < n; k++) {
        const double dx = xy[2 * k + 2] - xy[2 * k], dy = xy[2 * k + 3] - xy[2 * k + 1];
        length += sqrt(dx * dx + dy * dy);
    }
    return length < 2.0 * dash[0] + dash[1];
}


static void marks_inside(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, int32_t index)
{
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        int32_t panel, n;
        const char *name;
        const double *xy;
        if (mus_pattern_mark(pattern, i, &panel, &name, &n, &xy) != MUS_OK || panel != piece->panel || n < 1) continue;

        double first[2], p[2];
        bool open = false;
        mus__piece_point(piece, xy, first);
        if (n == 1 && piece->fold && mus__piece_inward(piece, first) < -1e-9) continue;
        mus__draw_path(out, index, MUS__LAYER_MARKS, marks_short(n, xy) ? MUS__PEN_SQUARE : MUS__PEN_MARK);
        mus__draw_mark(out, i);
        if (n == 1) {
            /* a drill point: a cross */
            mus__draw_move(out, first[0] - DRILL, first[1]);
            mus__draw_line(out, first[0] + DRILL, first[1]);
            mus__draw_move(out, first[0], first[1] - DRILL);
            mus__draw_line(out, first[0], first[1] + DRILL);
        }
        for (int32_t k = 1; k < n; k++, memcpy(first, p, sizeof first)) {
            mus__piece_point(piece, xy + 2 * k, p);
            marks_segment(out, piece, first, p, &open);
        }
        mus__caption caption;
        if (piece->follower || !mus__mark_caption(pattern, piece, out->lettering, out->language, i, &caption)) continue;
        mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_TEXT);
        mus__draw_text(out, caption.text, caption.x, caption.y, &caption.style);
    }
}


/* draw the dart folded at its middle: a drill point at its point, the line that is folded, and the words beside it */
static void marks_dart(mus__drawing *out, const mus__piece *piece, int32_t index, const double *dart)
{
    const double *point = dart + 2, *end = dart + 6, dx = end[0] - point[0], dy = end[1] - point[1];
    const double d = sqrt(dx * dx + dy * dy), middle[2] = {0.5 * (point[0] + end[0]), 0.5 * (point[1] + end[1])};
    if (!(d > 0.0) || (piece->fold && mus__piece_inward(piece, point) < -1e-9)) return;
    mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_DRILL);
    mus__draw_move(out, point[0] - DRILL, point[1]);
    mus__draw_line(out, point[0] + DRILL, point[1]);
    mus__draw_move(out, point[0], point[1] - DRILL);
    mus__draw_line(out, point[0], point[1] + DRILL);
    mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_MARK);
    mus__draw_move(out, point[0], point[1]);
    mus__draw_line(out, end[0], end[1]);
    const char *words = mus_language_text(out->language, "paper.dart");
    if (piece->follower || d < MUS__CAPTION_HEIGHT * mus__lettering_width(out->lettering, words, false) + 4.0 * DRILL)
        return;
    const double sign = dx < -1e-9 || (dx < 1e-9 && dy < 0.0) ? -1.0 : 1.0;
    const mus__text_style style = {MUS__CAPTION_HEIGHT, sign * dx / d, sign * dy / d, 0.5};
    mus__draw_path(out, index, MUS__LAYER_MARKS, MUS__PEN_TEXT);
    mus__draw_text(out, words, middle[0] - MUS__WORDS_CLEAR * style.sine, middle[1] + MUS__WORDS_CLEAR * style.cosine,
                   &style);
}


void mus__marks_draw(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, int32_t index,
                     double *grain)
{
    marks_cut(out, piece, index);
    marks_seam(out, piece, index);
    mus__notches_draw(out, pattern, piece, index);
    if (!piece->follower) marks_grain(out, piece, index, grain);
    marks_inside(out, pattern, piece, index);
    for (int32_t i = 0; i < piece->ndart; i++) marks_dart(out, piece, index, piece->darts + 8 * i);
    if (piece->fold) marks_fold(out, piece, index);
}
