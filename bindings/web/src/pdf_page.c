/*
 * pdf_page.c: a small PDF writer behind the calls of cairo.h: each page is one uncompressed stream of path operators
 * (ISO 32000-1, 8.5). Objects: 1 catalogue, 2 list of pages, 3 information, 4 the font, then a page and its stream in
 * turn. Text is invisible (text rendering mode 3): it lies over the strokes of its letters for readers that search and
 * copy. Its font is Courier, which every reader has, drawn out to the width that the strokes have.
 */
#include <cairo.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NUMBER 24   /* bytes of a number at most */
#define COURIER 0.6 /* width of each letter of Courier over its height (Adobe Core 14 font metrics) */
#define FIRST 5     /* number of the object that is the first page */

struct cairo_font {
    cairo_user_scaled_font_render_glyph_func_t glyph;
    cairo_user_scaled_font_unicode_to_glyph_func_t glyph_of;
};

struct cairo_surface {
    cairo_write_func_t write;
    void *closure;
    cairo_status_t status;
    double width, height;                    /* of the page [points] */
    char *stream;                            /* operators of the page */
    size_t length, room;
    size_t at;                               /* bytes written */
    size_t *offset;                          /* of the objects from FIRST on: page, stream, page ... */
    int pages;
    double point[2];                         /* where the path goes on, or a text begins */
    int moved;                               /* the page does not have that point yet */
    struct cairo_font font;
    double size;                             /* of the font [points] */
    char meta[CAIRO_PDF_METADATA_COUNT][200];
};


static void out(cairo_surface_t *s, const char *data, size_t length)
{
    if (s->status == CAIRO_STATUS_SUCCESS)
        s->status = s->write(s->closure, (const unsigned char *)data, (unsigned int)length);
    s->at += length;
}


static void outf(cairo_surface_t *s, const char *format, ...)
{
    char text[600];
    va_list list;
    va_start(list, format);
    const int length = vsnprintf(text, sizeof text, format, list);
    va_end(list);
    out(s, text, (size_t)length);
}


/* Appends numbers with four decimals, and an operator, to the page. */
static void op(cairo_surface_t *s, const char *name, int count, const double *number)
{
    const size_t most = (size_t)count * NUMBER + strlen(name) + 2;
    if (s->length + most > s->room) {
        char *more = realloc(s->stream, 2 * (s->room + most));
        if (more == NULL) {
            s->status = CAIRO_STATUS_NO_MEMORY;
            return;
        }
        s->stream = more;
        s->room = 2 * (s->room + most);
    }
    for (int i = 0; i < count; i++) {
        char *text = s->stream + s->length;
        size_t length = (size_t)snprintf(text, NUMBER, "%.4f", number[i]);
        while (text[length - 1] == '0') length--;
        if (text[length - 1] == '.') length--;
        text[length++] = ' ';
        s->length += length;
    }
    s->length += (size_t)sprintf(s->stream + s->length, "%s\n", name);
}

#define OP(s, name, ...) \
    op((s), (name), (int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double)), (double[]){__VA_ARGS__})


cairo_surface_t *cairo_pdf_surface_create_for_stream(cairo_write_func_t write, void *closure, double width,
                                                     double height)
{
    static struct cairo_surface none = {.status = CAIRO_STATUS_NO_MEMORY};
    cairo_surface_t *s = calloc(1, sizeof *s);
    if (s == NULL) return &none;
    s->write = write, s->closure = closure, s->width = width, s->height = height;
    out(s, "%PDF-1.5\n%\xe2\xe3\xcf\xd3\n", 15);
    return s;
}


/* The code point at a place of a UTF-8 text; moves the place to the character's last byte. */
static unsigned long code_point(const unsigned char **at)
{
    unsigned long code = **at;
    int more = code >= 0xf0 ? 3 : code >= 0xe0 ? 2 : code >= 0xc0 ? 1 : 0;
    if (more > 0) code &= 0x3fU >> more;
    for (; more > 0 && (*at)[1] != '\0'; more--) code = code << 6 | (*++*at & 0x3f);
    return code;
}


/* Keeps a text as a PDF string: UTF-16 in hexadecimal digits. */
void cairo_pdf_surface_set_metadata(cairo_surface_t *s, cairo_pdf_metadata_t what, const char *text)
{
    char *to = s->meta[what], *end = to + sizeof s->meta[what] - 14;
    to += sprintf(to, "<FEFF");
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0' && to < end; c++) {
        unsigned long code = code_point(&c);
        if (code > 0xffff) to += sprintf(to, "%04lX", 0xd7c0 + (code >> 10)), code = 0xdc00 + (code & 0x3ff);
        to += sprintf(to, "%04lX", code);
    }
    strcpy(to, ">");
}


void cairo_pdf_surface_restrict_to_version(cairo_surface_t *s, cairo_pdf_version_t version)
{
    /* all that is written here is version 1.4 */
    (void)s;
    (void)version;
}


void cairo_pdf_surface_set_size(cairo_surface_t *s, double width, double height)
{
    s->width = width, s->height = height;
}


cairo_status_t cairo_surface_status(cairo_surface_t *s) { return s->status; }


void cairo_show_page(cairo_t *s)
{
    size_t *more = realloc(s->offset, (size_t)(2 * s->pages + 2) * sizeof *more);
    if (more == NULL) {
        s->status = CAIRO_STATUS_NO_MEMORY;
        return;
    }
    s->offset = more;
    char turn[80];
    const int turned = snprintf(turn, sizeof turn, "1 0 0 -1 0 %.4f cm\n", s->height); /* y up, as PDF has it */
    const int page = FIRST + 2 * s->pages;
    s->offset[2 * s->pages] = s->at;
    outf(s, "%d 0 obj\n<< /Type /Page /Parent 2 0 R /MediaBox [0 0 %.4f %.4f] /Contents %d 0 R "
         "/Resources << /Font << /F 4 0 R >> >> >>\nendobj\n", page, s->width, s->height, page + 1);
    s->offset[2 * s->pages + 1] = s->at;
    outf(s, "%d 0 obj\n<< /Length %zu >>\nstream\n", page + 1, s->length + (size_t)turned);
    out(s, turn, (size_t)turned);
    if (s->length > 0) out(s, s->stream, s->length);
    outf(s, "\nendstream\nendobj\n");
    s->length = 0;
    s->pages++;
}


void cairo_surface_finish(cairo_surface_t *s)
{
    const size_t catalogue = s->at;
    outf(s, "1 0 obj\n<< /Type /Catalog /Pages 2 0 R >>\nendobj\n");
    const size_t list = s->at;
    outf(s, "2 0 obj\n<< /Type /Pages /Count %d /Kids [", s->pages);
    for (int i = 0; i < s->pages; i++) outf(s, "%d 0 R ", FIRST + 2 * i);
    outf(s, "] >>\nendobj\n");
    const size_t information = s->at;
    outf(s, "3 0 obj\n<< /Title %s /Creator %s >>\nendobj\n", s->meta[CAIRO_PDF_METADATA_TITLE],
         s->meta[CAIRO_PDF_METADATA_CREATOR]);
    const size_t font = s->at;
    outf(s, "4 0 obj\n<< /Type /Font /Subtype /Type1 /BaseFont /Courier /Encoding /WinAnsiEncoding >>\nendobj\n");
    const size_t table = s->at;
    const int objects = FIRST + 2 * s->pages;
    outf(s, "xref\n0 %d\n0000000000 65535 f \n%010zu 00000 n \n%010zu 00000 n \n%010zu 00000 n \n"
         "%010zu 00000 n \n", objects, catalogue, list, information, font);
    for (int i = 0; i < 2 * s->pages; i++) outf(s, "%010zu 00000 n \n", s->offset[i]);
    outf(s, "trailer\n<< /Size %d /Root 1 0 R /Info 3 0 R >>\nstartxref\n%zu\n%%%%EOF\n", objects, table);
}


void cairo_surface_destroy(cairo_surface_t *s)
{
    if (s->write == NULL) return;
    free(s->stream);
    free(s->offset);
    free(s);
}


/* ---- drawing ---- */

cairo_t *cairo_create(cairo_surface_t *s) { return s; }
void cairo_destroy(cairo_t *s) { (void)s; }
cairo_status_t cairo_status(cairo_t *s) { return s->status; }
const char *cairo_status_to_string(cairo_status_t status) { return status == CAIRO_STATUS_NO_MEMORY ? "memory" : ""; }

void cairo_save(cairo_t *s) { op(s, "q", 0, NULL); }
void cairo_restore(cairo_t *s) { op(s, "Q", 0, NULL); }
void cairo_clip(cairo_t *s) { op(s, "W n", 0, NULL); }
void cairo_fill(cairo_t *s) { op(s, "f", 0, NULL); }
void cairo_stroke(cairo_t *s) { op(s, "S", 0, NULL); }
void cairo_new_path(cairo_t *s) { s->moved = 0; }
void cairo_close_path(cairo_t *s) { op(s, "h", 0, NULL); }
void cairo_rectangle(cairo_t *s, double x, double y, double width, double height) { OP(s, "re", x, y, width, height); }
void cairo_set_line_width(cairo_t *s, double width) { OP(s, "w", width); }
void cairo_set_line_cap(cairo_t *s, cairo_line_cap_t cap) { OP(s, "J", (double)cap); }
void cairo_set_line_join(cairo_t *s, cairo_line_join_t join) { OP(s, "j", (double)join); }

void cairo_move_to(cairo_t *s, double x, double y)
{
    s->point[0] = x, s->point[1] = y;
    s->moved = 1;
}


/* Begins the part of the path that the next operator draws. */
static void begin(cairo_t *s)
{
    if (s->moved) OP(s, "m", s->point[0], s->point[1]);
    s->moved = 0;
}


void cairo_line_to(cairo_t *s, double x, double y)
{
    begin(s);
    OP(s, "l", x, y);
}


void cairo_curve_to(cairo_t *s, double x1, double y1, double x2, double y2, double x3, double y3)
{
    begin(s);
    OP(s, "c", x1, y1, x2, y2, x3, y3);
}


void cairo_set_source_rgb(cairo_t *s, double red, double green, double blue)
{
    OP(s, "rg", red, green, blue);
    OP(s, "RG", red, green, blue);
}


void cairo_set_dash(cairo_t *s, const double *dashes, int count, double offset)
{
    (void)offset; /* lib/print has none */
    op(s, "[", 0, NULL);
    if (count > 0) op(s, "", count, dashes);
    op(s, "] 0 d", 0, NULL);
}


/* ---- text ---- */

cairo_font_face_t *cairo_user_font_face_create(void) { return calloc(1, sizeof(cairo_font_face_t)); }
void cairo_font_face_destroy(cairo_font_face_t *face) { free(face); }
void cairo_set_font_size(cairo_t *s, double size) { s->size = size; }


void cairo_user_font_face_set_render_glyph_func(cairo_font_face_t *face,
                                                cairo_user_scaled_font_render_glyph_func_t glyph)
{
    if (face != NULL) face->glyph = glyph;
}


void cairo_user_font_face_set_unicode_to_glyph_func(cairo_font_face_t *face,
                                                    cairo_user_scaled_font_unicode_to_glyph_func_t glyph_of)
{
    if (face != NULL) face->glyph_of = glyph_of;
}


void cairo_set_font_face(cairo_t *s, cairo_font_face_t *face)
{
    if (face != NULL) s->font = *face;
    else s->status = CAIRO_STATUS_NO_MEMORY;
}


/* The byte of a character in WinAnsiEncoding (ISO 32000-1, annex D), a question mark where it has none. */
static int win_ansi(unsigned long code)
{
    static const unsigned short more[][2] = {{0x2013, 0x96}, {0x2014, 0x97}, {0x2019, 0x92}, {0x2026, 0x85},
                                             {0x0152, 0x8c}, {0x0153, 0x9c}, {0x20ac, 0x80}, {0x2212, '-'}};
    for (size_t i = 0; i < sizeof more / sizeof *more; i++)
        if (code == more[i][0]) return more[i][1];
    return code < 0x7f || (code >= 0xa0 && code <= 0xff) ? (int)code : '?';
}


/* Lays a text over the page where the path was moved to; the path is empty after it. */
void cairo_show_text(cairo_t *s, const char *text)
{
    char digits[3];
    double width = 0.0;
    int count = 0;
    if (s->font.glyph == NULL || s->font.glyph_of == NULL) return;
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++, count++) {
        cairo_text_extents_t extents = {0};
        unsigned long glyph = 0;
        s->font.glyph_of(&s->font, code_point(&c), &glyph);
        s->font.glyph(&s->font, glyph, s, &extents);
        width += extents.x_advance;
    }
    s->moved = 0;
    if (count == 0) return;
    op(s, "BT 3 Tr /F", 0, NULL);
    OP(s, "Tf", s->size);
    OP(s, "Tz", 100.0 * width / (COURIER * count));
    OP(s, "Tm", 1.0, 0.0, 0.0, -1.0, s->point[0], s->point[1]); /* the page is upside down */
    op(s, "<", 0, NULL);
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++) {
        snprintf(digits, sizeof digits, "%02X", (unsigned)win_ansi(code_point(&c)));
        op(s, digits, 0, NULL);
    }
    op(s, "> Tj ET", 0, NULL);
}
