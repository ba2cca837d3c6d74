/*
 * svg.c: the sheet as SVG at true scale: width and height in millimetres, one unit is one millimetre.
 *
 * Each piece is a group with the name of its panel. It contains the groups NAME.cut, .seam, .notches, .grain, .marks
 * and .label, so that a plotter or an editor can pick lines by name; the group "scale" has the test squares. The text
 * is written here and not by cairo, which would drop the names. Numbers are printed from integers, so that no locale
 * can put a comma into them.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "file/sink.h"
#include "paperfile/pdf_layers.h"
#include "print/page.h"

#define SVG_GAP 0.005 /* [m] distance of the sheet from the test squares below it; chosen: they touch no piece */

static const char *const layer_names[MUS__LAYER_COUNT] = {"cut", "seam", "notches", "grain", "marks", "label"};


void mus__svg_text(mus__sink *bytes, const char *text)
{
    while (*text != '\0') {
        const char *from = text;
        uint32_t code = mus__text_character(&text);
        bool control = code < 0x20 || code == 0x7f, beyond = code >= 0xfffd && code < 0x10000;
        bool surrogate = code >= 0xd800 && code < 0xe000;
        if (code == '<') mus__sink_print(bytes, "&lt;");
        else if (code == '>') mus__sink_print(bytes, "&gt;");
        else if (code == '&') mus__sink_print(bytes, "&amp;");
        else if (control || surrogate || beyond) mus__sink_print(bytes, "?");
        else mus__sink_add(bytes, from, (size_t)(text - from));
    }
}


/* [bytes] of an identifier: a name of 127, a sign before it, a number and a size of 33 behind it */
#define SVG_NAME 192


/* turn a name into an identifier: ASCII letters, digits, "-" and "." stay, all else becomes "_"; it starts with a
 * letter or "_" */
static void svg_clean(const char *name, char *out)
{
    size_t at = 0;
    bool first = (*name >= 'a' && *name <= 'z') || (*name >= 'A' && *name <= 'Z');
    if (!first) out[at++] = '_';
    for (; *name != '\0' && at < SVG_NAME - 16; name++) {
        char c = *name;
        bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
        out[at++] = good ? c : '_';
    }
    out[at] = '\0';
}


/* identifier of a piece: its name, its number when an earlier piece or the scale has the same, and its size */
static void svg_identifier(const mus_sheet *sheet, int32_t index, char *out)
{
    const int32_t first = index - index % sheet->nsize;
    svg_clean(sheet->names[index], out);
    bool taken = strcmp(out, "scale") == 0;
    for (int32_t i = 0; i < first && !taken; i += sheet->nsize) {
        char other[SVG_NAME];
        svg_clean(sheet->names[i], other);
        taken = strcmp(other, out) == 0;
    }
    if (taken) snprintf(out + strlen(out), 16, "_%d", first / sheet->nsize + 1);
    if (sheet->nsize == 1) return;
    out += strlen(out);
    *out++ = '.';
    svg_clean(sheet->sizes[index % sheet->nsize], out);
}


static void svg_path(mus__sink *bytes, const mus_sheet *sheet, const mus__drawing *drawing, const mus__path *path)
{
    const double top = sheet->extent[1];
    const mus__pen_style *style = &mus__pen_styles[path->pen];
    const double *xy = drawing->xy + path->at;
    int grey = (int)lround(style->grey * 255.0);
    mus__sink_print(bytes, "<path d=\"");
    for (int32_t i = 0; i < path->nop; i++) {
        unsigned char op = drawing->ops[path->op + i];
        int32_t n = op == 'c' ? 3 : op == 'z' ? 0 : 1;
        mus__sink_print(bytes, "%c", op == 'z' ? 'Z' : op - 'a' + 'A');
        for (int32_t k = 0; k < n; k++) {
            if (k > 0) mus__sink_add(bytes, " ", 1);
            mus__print_number(bytes, xy[2 * k]);
            mus__sink_add(bytes, ",", 1);
            mus__print_number(bytes, top - xy[2 * k + 1]);
        }
        xy += 2 * n;
    }
    if (style->width == 0.0) {
        mus__sink_print(bytes, "\" fill=\"#%02x%02x%02x\"/>\n", grey, grey, grey);
        return;
    }
    mus__sink_print(bytes, "\" fill=\"none\" stroke=\"#%02x%02x%02x\" stroke-width=\"", grey, grey, grey);
    mus__print_number(bytes, style->width);
    const double *dash = style->dash;
    int32_t dashes = 2;
    if (sheet->nsize > 1 && path->layer == MUS__LAYER_CUT) {
        dash = mus__size_dashes(path->piece % sheet->nsize);
        dashes = 4;
    }
    for (int32_t i = 0; i < dashes && dash[i] > 0.0; i++) {
        mus__sink_print(bytes, i == 0 ? "\" stroke-dasharray=\"" : ",");
        mus__print_number(bytes, dash[i]);
    }
    mus__sink_print(bytes, "\" stroke-linejoin=\"round\"%s/>\n",
                    path->layer == MUS__LAYER_LABEL ? " stroke-linecap=\"round\"" : "");
}


static void svg_piece(mus__sink *bytes, const mus_sheet *sheet, int32_t index)
{
    char name[SVG_NAME];
    svg_identifier(sheet, index, name);
    mus__sink_print(bytes, "<g id=\"%s\">\n<title>", name);
    mus__svg_text(bytes, sheet->names[index]);
    mus__sink_print(bytes, "</title>\n");
    for (int32_t layer = 0; layer < MUS__LAYER_COUNT; layer++) {
        mus__sink_print(bytes, "<g id=\"%s.%s\">\n", name, layer_names[layer]);
        for (int32_t i = 0; i < sheet->drawing.npath; i++) {
            const mus__path *path = &sheet->drawing.paths[i];
            if (path->piece == index && (int32_t)path->layer == layer && path->nop > 0)
                svg_path(bytes, sheet, &sheet->drawing, path);
        }
        mus__sink_print(bytes, "</g>\n");
    }
    mus__sink_print(bytes, "</g>\n");
}


/* write the test squares: on the sheet, or below it when the PDF has them on the cover */
static mus_status svg_scale(mus__sink *bytes, const mus_sheet *sheet)
{
    mus__drawing drawing;
    mus__sheet_draw_init(sheet, &drawing);
    if (sheet->cover) mus__squares_draw(&drawing, 0.0, -SVG_GAP - MUS__SQUARES);
    else mus__squares_draw(&drawing, sheet->squares[0], sheet->squares[1]);
    mus__sink_print(bytes, "<g id=\"scale\">\n");
    const mus_status status = drawing.status;
    for (int32_t i = 0; status == MUS_OK && i < drawing.npath; i++)
        svg_path(bytes, sheet, &drawing, &drawing.paths[i]);
    mus__sink_print(bytes, "</g>\n");
    mus__draw_free(&drawing);
    return status;
}


static mus_status svg_write(const mus_sheet *sheet, const mus__target *target, const char *what)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(sheet->context, target, what);
    if (status != MUS_OK) return status;
    mus__sink bytes;
    mus__sink_init(&bytes, sheet->context);
    double width = sheet->extent[0], height = sheet->extent[1];
    if (sheet->cover) {
        width = width > MUS__SQUARES + SVG_GAP ? width : MUS__SQUARES + SVG_GAP;
        height += MUS__SQUARES + 2.0 * SVG_GAP;
    }
    mus__sink_print(&bytes, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
    mus__print_number(&bytes, width);
    mus__sink_print(&bytes, "mm\" height=\"");
    mus__print_number(&bytes, height);
    mus__sink_print(&bytes, "mm\" viewBox=\"0 0 ");
    mus__print_number(&bytes, width);
    mus__sink_add(&bytes, " ", 1);
    mus__print_number(&bytes, height);
    mus__sink_print(&bytes, "\">\n<title>");
    mus__svg_text(&bytes, sheet->title);
    mus__sink_print(&bytes, "</title>\n");
    for (int32_t i = 0; i < sheet->npiece; i++) svg_piece(&bytes, sheet, i);
    status = svg_scale(&bytes, sheet);
    mus__sink_print(&bytes, "</svg>\n");
    if (status == MUS_OK) status = bytes.status;
    if (status == MUS_OK) status = mus__sink_give(&bytes, target);
    mus__sink_free(&bytes);
    return status;
}


mus_status mus_sheet_write_svg(const mus_sheet *sheet, const char *path)
{
    return svg_write(sheet, &(mus__target){path, NULL, NULL}, "mus_sheet_write_svg");
}


mus_status mus_sheet_write_svg_bytes(const mus_sheet *sheet, char **bytes, size_t *size)
{
    return svg_write(sheet, &(mus__target){NULL, bytes, size}, "mus_sheet_write_svg_bytes");
}
