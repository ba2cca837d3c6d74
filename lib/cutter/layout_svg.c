/*
 * layout_svg.c: a layout on cloth as SVG at true scale: one unit is one millimetre.
 *
 * The cloth runs to the right. y of the cloth runs up, that of SVG down. Folded cloth is drawn as it lies, half as
 * wide; what is cut from opened cloth stands behind it, at full width.
 */
#include <math.h>
#include <string.h>

#include "file/sink.h"
#include "muslin/layout.h"
#include "print/page.h"

#define SVG_BORDER 0.04     /* [m] round the cloth, with room for words; chosen */
#define SVG_LETTERS 0.018   /* [m] height of letters */
#define SVG_LETTER_WIDE 0.6 /* width of a letter over its height; that of common typefaces */

typedef struct layout_page {
    mus__sink *bytes;
    double height; /* of the picture [m] */
} layout_page;


/* write a point of the cloth */
static void layout_point(const layout_page *page, const char *before, double x, double y)
{
    mus__sink_print(page->bytes, "%s", before);
    mus__print_number(page->bytes, x + SVG_BORDER);
    mus__sink_print(page->bytes, ",");
    mus__print_number(page->bytes, page->height - SVG_BORDER - y);
}


/* write a number as an attribute */
static void layout_attribute(const layout_page *page, const char *name, double value)
{
    mus__sink_print(page->bytes, " %s=\"", name);
    mus__print_number(page->bytes, value);
    mus__sink_print(page->bytes, "\"");
}


static void layout_line(const layout_page *page, const double *a, const double *b, const char *style)
{
    layout_point(page, "<path d=\"M", a[0], a[1]);
    layout_point(page, "L", b[0], b[1]);
    mus__sink_print(page->bytes, "\" fill=\"none\" stroke=\"#444444\" %s/>\n", style);
}


/* write words with their middle at (x, y) */
static void layout_words(const layout_page *page, const char *text, double x, double y, double height)
{
    mus__sink_print(page->bytes, "<text text-anchor=\"middle\" font-family=\"sans-serif\" fill=\"#222222\"");
    layout_attribute(page, "font-size", height);
    layout_attribute(page, "x", x + SVG_BORDER);
    layout_attribute(page, "y", page->height - SVG_BORDER - y + 0.35 * height);
    mus__sink_print(page->bytes, ">");
    mus__svg_text(page->bytes, text);
    mus__sink_print(page->bytes, "</text>\n");
}


/* the longest part of the line y = `at` that is inside the outline: span (2) [m]; its length, 0 when there is none */
static double layout_chord(const mus_layout_piece *piece, double at, double *span)
{
    double from = -HUGE_VAL, best = 0.0;
    for (;;) {
        double pair[2] = {HUGE_VAL, HUGE_VAL};
        for (int32_t i = 0; i < piece->n; i++) {
            const double *a = piece->xy + 2 * i, *b = piece->xy + 2 * ((i + 1) % piece->n);
            if ((a[1] > at) == (b[1] > at)) continue;
            const double x = a[0] + (b[0] - a[0]) * (at - a[1]) / (b[1] - a[1]);
            if (x <= from) continue;
            if (x < pair[0])
                pair[1] = pair[0], pair[0] = x;
            else if (x < pair[1])
                pair[1] = x;
        }
        if (!(pair[1] < HUGE_VAL)) return best;
        if (pair[1] - pair[0] > best) {
            best = pair[1] - pair[0];
            memcpy(span, pair, sizeof pair);
        }
        from = pair[1];
    }
}


/* how a piece is cut, in words */
static const char *layout_how(const mus_layout_piece *piece)
{
    if (piece->on_fold) return "on the fold";
    if (piece->spare) return "two layers, one to spare";
    if (piece->layers == 2) return "two layers";
    return piece->mirrored ? "turned over" : "";
}


/* find room for a label with letters of the height: the middle of it, out (2); its width, 0 when there is none. It is
 * looked for at heights of the piece, by the chords through the top, the middle and the bottom of the label */
static double layout_room(const mus_layout_piece *piece, const double *box, double height, double *out)
{
    double best = 0.0;
    for (int32_t k = 1; k < 16; k++) {
        const double y = box[0] + (box[1] - box[0]) * k / 16.0;
        double from = -HUGE_VAL, to = HUGE_VAL;
        for (int32_t line = -1; line <= 1; line++) {
            double span[2] = {HUGE_VAL, -HUGE_VAL};
            layout_chord(piece, y + 1.9 * height * line, span);
            from = fmax(from, span[0]);
            to = fmin(to, span[1]);
        }
        if (to - from <= best * 1.02) continue;
        best = to - from;
        out[0] = 0.5 * (from + to);
        out[1] = y;
    }
    return best;
}


/* write name, how it is cut, and an arrow along the grain */
static void layout_label(const layout_page *page, const mus_layout_piece *piece)
{
    double box[2] = {HUGE_VAL, -HUGE_VAL}, middle[2] = {0.0, 0.0}, height = SVG_LETTERS, room = 0.0, letters;
    for (int32_t i = 0; i < piece->n; i++) {
        box[0] = fmin(box[0], piece->xy[2 * i + 1]);
        box[1] = fmax(box[1], piece->xy[2 * i + 1]);
    }
    const char *how = layout_how(piece);
    letters = SVG_LETTER_WIDE * fmax((double)strlen(piece->name), 0.8 * (double)strlen(how)) + 1.0;
    for (int32_t k = 0; k < 12; k++, height *= 0.8) {
        room = layout_room(piece, box, height, middle);
        if (room > letters * height) break;
    }
    if (!(room > 0.0)) return;
    layout_words(page, piece->name, middle[0], middle[1] + 1.1 * height, height);
    if (*how != '\0') layout_words(page, how, middle[0], middle[1] - 0.1 * height, 0.8 * height);
    /* the arrow points to the upper end of the piece as it is drawn, which half a turn reverses */
    const double arrow = fmin(6.0 * height, 0.6 * room), side = piece->turned ? -1.0 : 1.0, head = 0.12 * arrow;
    const double y = middle[1] - 1.4 * height;
    const double a[2] = {middle[0] - 0.5 * side * arrow, y}, b[2] = {middle[0] + 0.5 * side * arrow, y};
    layout_line(page, a, b, "stroke-width=\"0.5\"");
    for (int32_t k = -1; k <= 1; k += 2) {
        const double c[2] = {b[0] - side * head, y + 0.5 * k * head};
        layout_line(page, c, b, "stroke-width=\"0.5\"");
    }
}


static void layout_piece(const layout_page *page, const mus_layout_piece *piece)
{
    mus__sink_print(page->bytes, "<g>\n<title>");
    mus__svg_text(page->bytes, piece->name);
    mus__sink_print(page->bytes, "</title>\n");
    for (int32_t i = 0; i < piece->n; i++)
        layout_point(page, i == 0 ? "<path d=\"M" : "L", piece->xy[2 * i], piece->xy[2 * i + 1]);
    mus__sink_print(page->bytes,
                    "Z\" fill=\"%s\" stroke=\"#000000\" stroke-width=\"0.6\" stroke-linejoin=\"round\"/>\n",
                    piece->on_fold                          ? "#d8e4f2"
                    : piece->mirrored && piece->layers == 1 ? "#e4dcee"
                                                            : "#e2efda");
    layout_label(page, piece);
    mus__sink_print(page->bytes, "</g>\n");
}


/* draw cloth from x `from` to `to`, `width` wide, its lower edge named `edge` */
static void layout_cloth(const layout_page *page, double from, double to, double width, const char *edge)
{
    layout_point(page, "<path d=\"M", from, 0.0);
    layout_point(page, "L", to, 0.0);
    layout_point(page, "L", to, width);
    layout_point(page, "L", from, width);
    mus__sink_print(page->bytes, "Z\" fill=\"#faf7f0\" stroke=\"#888888\" stroke-width=\"1\"/>\n");
    layout_words(page, edge, 0.5 * (from + to), -0.6 * SVG_LETTERS, 0.7 * SVG_LETTERS);
    layout_words(page, *edge == 'f' ? "selvedges" : "selvedge", 0.5 * (from + to), width + 0.6 * SVG_LETTERS,
                 0.7 * SVG_LETTERS);
}


/* draw the cloth, folded and open, and its decimetres */
static void layout_ground(const layout_page *page, const mus_layout *layout)
{
    const double length = mus_layout_length(layout), folded = mus_layout_folded(layout);
    const double width = mus_layout_width(layout);
    if (folded > 0.0) layout_cloth(page, 0.0, folded, 0.5 * width, "fold");
    if (length > folded) layout_cloth(page, folded, length, width, "selvedge");
    for (int32_t k = 0; 0.1 * k <= length && k < 10000; k++) {
        const double a[2] = {0.1 * k, 0.0}, b[2] = {0.1 * k, k % 10 == 0 ? -0.3 * SVG_LETTERS : -0.15 * SVG_LETTERS};
        layout_line(page, a, b, "stroke-width=\"0.6\"");
    }
}


static mus_status layout_write(const mus_layout *layout, const mus__target *target, const char *what)
{
    if (layout == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_layout_context(layout);
    mus_status status = mus__target_check(context, target, what);
    if (status != MUS_OK) return status;
    mus__sink bytes;
    mus__sink_init(&bytes, context);
    const double length = mus_layout_length(layout), folded = mus_layout_folded(layout);
    const double across = mus_layout_width(layout) * (length > folded ? 1.0 : 0.5);
    const layout_page page = {&bytes, across + 2.0 * SVG_BORDER};
    mus__sink_print(&bytes, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
    mus__print_number(&bytes, length + 2.0 * SVG_BORDER);
    mus__sink_print(&bytes, "mm\" height=\"");
    mus__print_number(&bytes, page.height);
    mus__sink_print(&bytes, "mm\" viewBox=\"0 0 ");
    mus__print_number(&bytes, length + 2.0 * SVG_BORDER);
    mus__sink_print(&bytes, " ");
    mus__print_number(&bytes, page.height);
    mus__sink_print(&bytes, "\">\n<title>");
    mus__print_number(&bytes, length);
    mus__sink_print(&bytes, " mm of cloth</title>\n");
    layout_ground(&page, layout);
    for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) {
        mus_layout_piece piece;
        mus_layout_piece_init(&piece, sizeof piece);
        if (mus_layout_piece_get(layout, i, &piece) == MUS_OK) layout_piece(&page, &piece);
    }
    mus__sink_print(&bytes, "</svg>\n");
    status = mus__sink_give(&bytes, target);
    mus__sink_free(&bytes);
    return status;
}


mus_status mus_layout_write_svg(const mus_layout *layout, const char *path)
{
    return layout_write(layout, &(mus__target){path, NULL, NULL}, "mus_layout_write_svg");
}


mus_status mus_layout_write_svg_bytes(const mus_layout *layout, char **bytes, size_t *size)
{
    return layout_write(layout, &(mus__target){NULL, bytes, size}, "mus_layout_write_svg_bytes");
}
