/*
 * pdf.c: the sheet as PDF by cairo: the cover when there is one, then each page that is not empty.
 *
 * Coordinates are converted to those of the page (1/72 inch, y down) before cairo gets them, and cairo has no scale of
 * its own: it rounds paths to multiples of 1/256 point (1.4 um). A path that touches a page is drawn whole and clipped
 * to the printed window, so that lengths can be measured on any page. Letters are strokes; for search, copy and
 * reading aloud each text lies over its strokes a second time, in a font made here whose glyphs are empty and as wide
 * as the strokes. No font of the machine is used and the date is fixed, so that the same sheet gives the same bytes.
 */
#include <cairo-pdf.h>
#include <cairo.h>
#include <math.h>
#include <string.h>

#include "file/sink.h"
#include "paperfile/pdf_layers.h"
#include "drawing/lettering.h"
#include "print/page.h"

#define POINTS (72.0 / 0.0254)               /* [points/m] PostScript points in a metre */
#define PDF_DATE "1970-01-01T00:00:00Z"      /* date in the file; without it cairo writes the time of day */

#define PDF_TURN                                                                                                       \
    0.01              /* sine of half a degree: readers take text that is turned by more apart, but for quarter turns  \
                       */
#define PDF_TEXT 1023 /* [bytes] longest text that can be searched for; chosen: four times a line of a label */

/* the page that is drawn: x of the sheet at its left edge, y at its upper edge [m] */
typedef struct pdf_page {
    cairo_t *cairo;
    double left, top;
    const mus_sheet *sheet;
} pdf_page;


static cairo_status_t pdf_collect(void *closure, const unsigned char *data, unsigned int length)
{
    mus__sink *bytes = closure;
    mus__sink_add(bytes, data, length);
    return bytes->status == MUS_OK ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}


static void pdf_path(const pdf_page *page, const mus__drawing *drawing, const mus__path *path)
{
    const double *xy = drawing->xy + path->at;
    double p[6];
    cairo_new_path(page->cairo);
    for (int32_t i = 0; i < path->nop; i++) {
        unsigned char op = drawing->ops[path->op + i];
        int32_t n = op == 'c' ? 3 : op == 'z' ? 0 : 1;
        for (int32_t k = 0; k < n; k++) {
            p[2 * k] = (xy[2 * k] - page->left) * POINTS;
            p[2 * k + 1] = (page->top - xy[2 * k + 1]) * POINTS;
        }
        if (op == 'm') cairo_move_to(page->cairo, p[0], p[1]);
        else if (op == 'l') cairo_line_to(page->cairo, p[0], p[1]);
        else if (op == 'c') cairo_curve_to(page->cairo, p[0], p[1], p[2], p[3], p[4], p[5]);
        else cairo_close_path(page->cairo);
        xy += 2 * n;
    }
}


/* is a text set in a font and shown as text? One that is too long, or slants, comes as its outline */
static bool pdf_shown(const mus__text *text)
{
    return text->path != MUS_NONE && text->n <= PDF_TEXT && fmin(fabs(text->cosine), fabs(text->sine)) < PDF_TURN;
}


/* draw all paths that touch the window (low x, low y, high x, high y [m]; NULL: all paths) */
static void pdf_draw(const pdf_page *page, const mus__drawing *drawing, const double *window)
{
    for (int32_t i = 0; i < drawing->npath; i++) {
        const mus__path *path = &drawing->paths[i];
        const mus__pen_style *style = &mus__pen_styles[path->pen];
        double w = 0.5 * style->width, dash[2] = {style->dash[0] * POINTS, style->dash[1] * POINTS};
        const bool shown = path->text != MUS_NONE && pdf_shown(&drawing->texts[path->text]);
        if (path->nop == 0 || shown || mus__path_layered(page->sheet, path)) continue;
        if (window != NULL && (path->box[0] - w > window[2] || path->box[2] + w < window[0] ||
                               path->box[1] - w > window[3] || path->box[3] + w < window[1]))
            continue;
        pdf_path(page, drawing, path);
        cairo_set_source_rgb(page->cairo, style->grey, style->grey, style->grey);
        if (style->width == 0.0) {
            cairo_fill(page->cairo);
            continue;
        }
        cairo_set_dash(page->cairo, dash, dash[0] > 0.0 ? 2 : 0, 0.0);
        cairo_set_line_width(page->cairo, style->width * POINTS);
        /* only letters have round ends; on other lines they would lengthen dashes and ends */
        bool letter = path->layer == MUS__LAYER_LABEL;
        cairo_set_line_cap(page->cairo, letter ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
        cairo_set_line_join(page->cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_stroke(page->cairo);
    }
}


/* ---- text for readers ---- */

static cairo_status_t pdf_glyph(cairo_scaled_font_t *font, unsigned long glyph, cairo_t *cairo,
                                cairo_text_extents_t *extents)
{
    (void)font;
    (void)cairo;
    /* readers leave out glyphs without height */
    extents->x_advance = extents->width = mus__text_advance((uint32_t)glyph);
    extents->y_bearing = -1.0;
    extents->height = 1.0;
    return CAIRO_STATUS_SUCCESS;
}


/* the glyph of a character is its code point */
static cairo_status_t pdf_character(cairo_scaled_font_t *font, unsigned long code, unsigned long *glyph)
{
    (void)font;
    *glyph = code;
    return CAIRO_STATUS_SUCCESS;
}


static cairo_font_face_t *pdf_font(void)
{
    cairo_font_face_t *face = cairo_user_font_face_create();
    cairo_user_font_face_set_render_glyph_func(face, pdf_glyph);
    cairo_user_font_face_set_unicode_to_glyph_func(face, pdf_character);
    return face;
}


/* show a text that is set in a font, on every page that its outline touches */
static void pdf_text(const pdf_page *page, const mus__drawing *drawing, const mus__text *text, const char *letters,
                     const double *window)
{
    const mus__path *path = &drawing->paths[text->path];
    const double xy[2] = {(text->x - page->left) * POINTS, (page->top - text->y) * POINTS};
    const double grey = mus__pen_styles[path->pen].grey;
    const mus__text_style style = {text->height, text->cosine, text->sine, 0.0};
    if (mus__path_layered(page->sheet, path)) return; /* its layer has the outline */
    if (window != NULL && (path->box[0] > window[2] || path->box[2] < window[0] || path->box[1] > window[3] ||
                           path->box[3] < window[1]))
        return;
    cairo_set_source_rgb(page->cairo, grey, grey, grey);
    mus__lettering_show(drawing->lettering, page->cairo, letters, xy, text->height * POINTS, &style, text->bold);
}


/* turn the letters of Hebrew or Arabic round: readers read invisible letters from the left, and turn such words round
 */
static void pdf_from_left(char *letters)
{
    char turned[PDF_TEXT + 1];
    size_t n = strlen(letters), at = n;
    bool right_to_left = false;
    for (const char *next = letters, *from = letters; at > 0; from = next) {
        const uint32_t code = mus__text_character(&next);
        right_to_left = right_to_left || (code >= 0x590 && code < 0x900);
        at -= (size_t)(next - from);
        memcpy(turned + at, from, (size_t)(next - from));
    }
    if (right_to_left) memcpy(letters, turned, n);
}


/* lay the texts that begin in the window (NULL: all) over their lines, invisible, and show those that are set in a font
 * and do not slant. The invisible ones are all level: readers take turned text apart into letters */
static void pdf_texts(const pdf_page *page, const mus__drawing *drawing, const double *window)
{
    for (int32_t i = 0; i < drawing->ntext; i++) {
        const mus__text *text = &drawing->texts[i];
        char letters[PDF_TEXT + 1];
        const bool on = window == NULL || (text->x >= window[0] && text->x <= window[2] && text->y >= window[1] &&
                                           text->y <= window[3]);
        if (text->n > PDF_TEXT) continue;
        memcpy(letters, drawing->letters + text->at, (size_t)text->n);
        letters[text->n] = '\0';
        if (pdf_shown(text)) pdf_text(page, drawing, text, letters, window);
        if (!on || pdf_shown(text)) continue;
        pdf_from_left(letters);
        const double size = text->height * POINTS;
        cairo_set_font_size(page->cairo, size);
        cairo_move_to(page->cairo, (text->x - page->left) * POINTS, (page->top - text->y) * POINTS);
        cairo_show_text(page->cairo, letters);
    }
    cairo_new_path(page->cairo);
}


static mus_status pdf_cover(cairo_surface_t *surface, cairo_t *cairo, const mus_sheet *sheet)
{
    double size[2];
    mus__drawing drawing;
    mus__sheet_draw_init(sheet, &drawing);
    mus__cover_size(sheet, size);
    mus__cover_draw(sheet, &drawing);
    mus_status status = drawing.status;
    if (status == MUS_OK) {
        const pdf_page page = {cairo, 0.0, size[1], sheet};
        cairo_pdf_surface_set_size(surface, size[0] * POINTS, size[1] * POINTS);
        pdf_draw(&page, &drawing, NULL);
        pdf_texts(&page, &drawing, NULL);
        cairo_show_page(cairo);
    }
    mus__draw_free(&drawing);
    return status;
}


static mus_status pdf_tile(cairo_surface_t *surface, cairo_t *cairo, const mus_sheet *sheet, int32_t tile)
{
    double box[4], margin = sheet->def.margin;
    mus__drawing drawing;
    mus__sheet_draw_init(sheet, &drawing);
    mus__tile_draw(sheet, tile, &drawing);
    mus_status status = drawing.status;
    if (status == MUS_OK) {
        mus__tile_window(sheet, &sheet->tiles[tile], box);
        const pdf_page own = {cairo, 0.0, sheet->page[1], sheet};
        const pdf_page page = {cairo, box[0] - margin, box[3] + margin, sheet};
        cairo_pdf_surface_set_size(surface, sheet->page[0] * POINTS, sheet->page[1] * POINTS);

        /* pieces clipped to the window, then frame and marks */
        cairo_save(cairo);
        double width = (box[2] - box[0]) * POINTS, height = (box[3] - box[1]) * POINTS;
        cairo_rectangle(cairo, margin * POINTS, margin * POINTS, width, height);
        cairo_clip(cairo);
        pdf_draw(&page, &sheet->drawing, box);
        pdf_texts(&page, &sheet->drawing, box);
        cairo_restore(cairo);
        pdf_draw(&own, &drawing, NULL);
        pdf_texts(&own, &drawing, NULL);
        cairo_show_page(cairo);
    }
    mus__draw_free(&drawing);
    return status;
}


static mus_status pdf_pages(const mus_sheet *sheet, mus__sink *bytes)
{
    double width = sheet->page[0] * POINTS, height = sheet->page[1] * POINTS;
    cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(pdf_collect, bytes, width, height);
    /* objects in plain text, which layers are added to */
    if (sheet->nsize > 1) cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_4);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, sheet->title);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "muslin");
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, PDF_DATE);
    cairo_t *cairo = cairo_create(surface);
    cairo_font_face_t *face = pdf_font();
    cairo_set_font_face(cairo, face);
    cairo_font_face_destroy(face);

    mus_status status = sheet->cover ? pdf_cover(surface, cairo, sheet) : MUS_OK;
    for (int32_t i = 0; i < sheet->ntile && status == MUS_OK; i++) status = pdf_tile(surface, cairo, sheet, i);

    /* failures of cairo: no memory, or a sink that has failed */
    cairo_status_t trouble = cairo_status(cairo);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    if (trouble == CAIRO_STATUS_SUCCESS) trouble = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (status == MUS_OK) status = bytes->status;
    if (status == MUS_OK && trouble != CAIRO_STATUS_SUCCESS)
        status = mus__file_fail(sheet->context, trouble == CAIRO_STATUS_NO_MEMORY ? MUS_ERR_MEMORY : MUS_ERR_FILE,
                                "cairo: %s", cairo_status_to_string(trouble));
    return status;
}


static mus_status pdf_write(const mus_sheet *sheet, const mus__target *target, const char *what)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(sheet->context, target, what);
    if (status != MUS_OK) return status;
    mus__sink bytes;
    mus__sink_init(&bytes, sheet->context);
    status = pdf_pages(sheet, &bytes);
    if (status == MUS_OK && sheet->nsize > 1) status = mus__pdf_layers_add(sheet, &bytes);
    if (status == MUS_OK) status = mus__sink_give(&bytes, target);
    mus__sink_free(&bytes);
    return status;
}


mus_status mus_sheet_write_pdf(const mus_sheet *sheet, const char *path)
{
    return pdf_write(sheet, &(mus__target){path, NULL, NULL}, "mus_sheet_write_pdf");
}


mus_status mus_sheet_write_pdf_bytes(const mus_sheet *sheet, char **bytes, size_t *size)
{
    return pdf_write(sheet, &(mus__target){NULL, bytes, size}, "mus_sheet_write_pdf_bytes");
}
