/*
 * cairo.h: the part of cairo's interface that lib/paperfile/pdf.c uses, for a module without cairo. pdf_page.c writes the
 * PDF: pages of paths, uncompressed, and invisible text. Points, y down, as in cairo.
 */
#ifndef MUSLIN_WEB_CAIRO_H
#define MUSLIN_WEB_CAIRO_H

typedef struct cairo_surface cairo_surface_t;
typedef struct cairo_surface cairo_t; /* a surface has one drawing, and is its own */
typedef struct cairo_font cairo_font_face_t;
typedef struct cairo_font cairo_scaled_font_t; /* a face has one size, the drawing's */
typedef enum { CAIRO_STATUS_SUCCESS, CAIRO_STATUS_NO_MEMORY, CAIRO_STATUS_WRITE_ERROR } cairo_status_t;
typedef enum { CAIRO_LINE_CAP_BUTT, CAIRO_LINE_CAP_ROUND } cairo_line_cap_t;
typedef enum { CAIRO_LINE_JOIN_MITER, CAIRO_LINE_JOIN_ROUND } cairo_line_join_t;
typedef enum {
    CAIRO_PDF_METADATA_TITLE,
    CAIRO_PDF_METADATA_CREATOR,
    CAIRO_PDF_METADATA_CREATE_DATE,
    CAIRO_PDF_METADATA_COUNT
} cairo_pdf_metadata_t;
typedef struct {
    double x_bearing, y_bearing, width, height, x_advance, y_advance;
} cairo_text_extents_t;
typedef cairo_status_t (*cairo_write_func_t)(void *closure, const unsigned char *data, unsigned int length);
typedef cairo_status_t (*cairo_user_scaled_font_render_glyph_func_t)(cairo_scaled_font_t *font, unsigned long glyph,
                                                                     cairo_t *cairo, cairo_text_extents_t *extents);
typedef cairo_status_t (*cairo_user_scaled_font_unicode_to_glyph_func_t)(cairo_scaled_font_t *font,
                                                                         unsigned long code, unsigned long *glyph);

cairo_surface_t *cairo_pdf_surface_create_for_stream(cairo_write_func_t write, void *closure, double width,
                                                     double height);
void cairo_pdf_surface_set_metadata(cairo_surface_t *surface, cairo_pdf_metadata_t what, const char *text);
typedef enum { CAIRO_PDF_VERSION_1_4 } cairo_pdf_version_t;
void cairo_pdf_surface_restrict_to_version(cairo_surface_t *surface, cairo_pdf_version_t version);
void cairo_pdf_surface_set_size(cairo_surface_t *surface, double width, double height);
cairo_status_t cairo_surface_status(cairo_surface_t *surface);
void cairo_surface_finish(cairo_surface_t *surface);
void cairo_surface_destroy(cairo_surface_t *surface);

cairo_t *cairo_create(cairo_surface_t *surface);
void cairo_destroy(cairo_t *cairo);
cairo_status_t cairo_status(cairo_t *cairo);
const char *cairo_status_to_string(cairo_status_t status);
void cairo_show_page(cairo_t *cairo);
void cairo_save(cairo_t *cairo);
void cairo_restore(cairo_t *cairo);
void cairo_clip(cairo_t *cairo);
void cairo_fill(cairo_t *cairo);
void cairo_stroke(cairo_t *cairo);
void cairo_new_path(cairo_t *cairo);
void cairo_move_to(cairo_t *cairo, double x, double y);
void cairo_line_to(cairo_t *cairo, double x, double y);
void cairo_curve_to(cairo_t *cairo, double x1, double y1, double x2, double y2, double x3, double y3);
void cairo_close_path(cairo_t *cairo);
void cairo_rectangle(cairo_t *cairo, double x, double y, double width, double height);
void cairo_set_source_rgb(cairo_t *cairo, double red, double green, double blue);
void cairo_set_dash(cairo_t *cairo, const double *dashes, int count, double offset);
void cairo_set_line_width(cairo_t *cairo, double width);
void cairo_set_line_cap(cairo_t *cairo, cairo_line_cap_t cap);
void cairo_set_line_join(cairo_t *cairo, cairo_line_join_t join);

/* A font whose glyphs draw nothing: the first function tells how wide they are. */
cairo_font_face_t *cairo_user_font_face_create(void);
void cairo_user_font_face_set_render_glyph_func(cairo_font_face_t *face,
                                                cairo_user_scaled_font_render_glyph_func_t glyph);
void cairo_user_font_face_set_unicode_to_glyph_func(cairo_font_face_t *face,
                                                    cairo_user_scaled_font_unicode_to_glyph_func_t glyph_of);
void cairo_font_face_destroy(cairo_font_face_t *face);
void cairo_set_font_face(cairo_t *cairo, cairo_font_face_t *face);
void cairo_set_font_size(cairo_t *cairo, double size);
void cairo_show_text(cairo_t *cairo, const char *text);

#endif
