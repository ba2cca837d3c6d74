/*
 * lettering_pango.c: letters by Pango: it finds the fonts, shapes the text and orders its directions.
 *
 * The fonts are those of the machine (fontconfig), so that widths, and with them the places of texts, depend on it.
 * Text is laid out at one size without hinting and scaled, so that a text has the same form at every size. The objects
 * of Pango take their memory for themselves; where there is none left, GLib ends the process.
 */
#include "drawing/lettering.h"

#ifndef MUS_STROKES_ONLY

#include <pango/pangocairo.h>
#include <string.h>

#include "base/utf8.h"
#include "muslin/language.h"

#define LETTER_SIZE 1000.0 /* [points] size at which text is laid out; chosen: Pango rounds to 1/1024 point */
/* height of a capital over the size of the font; the mean of DejaVu Sans (0.729) and Noto Sans (0.714) */
#define LETTER_CAPITAL 0.72

#define LETTER_GLYPHS 512 /* most glyphs of a part of a line whose marks are joined; longer ones are shown plain */

struct mus__lettering {
    mus_context *context;
    bool all; /* all texts are set in a font, not only those that the strokes cannot write */
    PangoFontMap *fonts;
    PangoContext *pango;
    cairo_t *scratch; /* where outlines are made */
};


mus_status mus__lettering_make(mus_context *context, int32_t language, mus__lettering **out)
{
    mus__lettering *l = *out = mus__print_new(context, 1, sizeof *l);
    if (l == NULL) return mus__print_memory(context, "the letters of a sheet");
    const bool right_to_left = mus_language_is_right_to_left(language) != 0;
    cairo_surface_t *surface = cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, NULL);
    cairo_font_options_t *plain = cairo_font_options_create();
    l->context = context;
    l->all = language != MUS_LANGUAGE_ENGLISH;
    l->scratch = cairo_create(surface);
    cairo_surface_destroy(surface);
    l->fonts = pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT);
    if (l->fonts == NULL) l->fonts = pango_cairo_font_map_new();
    pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(l->fonts), 72.0);
    l->pango = pango_font_map_create_context(l->fonts);
    cairo_font_options_set_hint_style(plain, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(plain, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(l->pango, plain);
    cairo_font_options_destroy(plain);
    pango_context_set_round_glyph_positions(l->pango, FALSE);
    pango_context_set_language(l->pango, pango_language_from_string(mus_language_tag(language)));
    pango_context_set_base_dir(l->pango, right_to_left ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR);
    return MUS_OK;
}


void mus__lettering_free(mus__lettering *l)
{
    if (l == NULL) return;
    if (l->pango != NULL) g_object_unref(l->pango);
    if (l->fonts != NULL) g_object_unref(l->fonts);
    if (l->scratch != NULL) cairo_destroy(l->scratch);
    mus__print_free(l->context, l);
}


bool mus__lettering_sets(const mus__lettering *l, const char *text)
{
    return l != NULL && text[0] != '\0' && (l->all || !mus__text_has_strokes(text));
}


/* the text laid out at `size` [points], on one line unless it is broken */
static PangoLayout *lettering_layout(const mus__lettering *l, const char *text, double size, bool bold)
{
    PangoLayout *layout = pango_layout_new(l->pango);
    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family_static(font, "sans-serif");
    pango_font_description_set_weight(font, bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_font_description_set_absolute_size(font, size * PANGO_SCALE);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    pango_layout_set_single_paragraph_mode(layout, TRUE);
    pango_layout_set_text(layout, text, (int)mus__utf8_span(text)); /* a letter that was cut is left out */
    return layout;
}


double mus__lettering_width(const mus__lettering *l, const char *text, bool bold)
{
    if (!mus__lettering_sets(l, text)) return mus__text_width(text);
    PangoRectangle box;
    PangoLayout *layout = lettering_layout(l, text, LETTER_SIZE, bold);
    pango_layout_line_get_extents(pango_layout_get_line_readonly(layout, 0), NULL, &box);
    g_object_unref(layout);
    return box.width / (PANGO_SCALE * LETTER_SIZE * LETTER_CAPITAL);
}


size_t mus__lettering_line(const mus__lettering *l, const char *text, double height, double width)
{
    if (!mus__lettering_sets(l, text)) return mus__text_line(text, height, width);
    const double wide = width / height * PANGO_SCALE * LETTER_SIZE * LETTER_CAPITAL;
    PangoLayout *layout = lettering_layout(l, text, LETTER_SIZE, false);
    pango_layout_set_width(layout, wide < 1e9 ? (int)wide : (int)1e9);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    const PangoLayoutLine *line = pango_layout_get_line_readonly(layout, 0);
    size_t n = (size_t)line->length;
    g_object_unref(layout);
    while (n > 1 && text[n - 1] == ' ') n--;
    return n > 0 ? n : strlen(text);
}


void mus__lettering_outline(const mus__lettering *l, mus__drawing *drawing, const char *text, double x, double y,
                            const mus__text_style *style, bool bold)
{
    PangoLayout *layout = lettering_layout(l, text, LETTER_SIZE, bold);
    const double unit = style->height / (LETTER_SIZE * LETTER_CAPITAL);
    cairo_new_path(l->scratch);
    cairo_move_to(l->scratch, 0.0, 0.0);
    pango_cairo_layout_line_path(l->scratch, pango_layout_get_line_readonly(layout, 0));
    cairo_path_t *path = cairo_copy_path(l->scratch);
    for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
        const cairo_path_data_t *step = &path->data[i];
        double p[6] = {0.0};
        for (int32_t k = 0; k + 1 < step->header.length; k++) {
            const double u = step[k + 1].point.x * unit, v = -step[k + 1].point.y * unit;
            p[2 * k] = x + u * style->cosine - v * style->sine;
            p[2 * k + 1] = y + u * style->sine + v * style->cosine;
        }
        /* a move that nothing follows, such as the last one, is left out */
        const int next = i + step->header.length;
        const bool drawn = next < path->num_data && path->data[next].header.type != CAIRO_PATH_MOVE_TO;
        if (step->header.type == CAIRO_PATH_MOVE_TO && drawn) mus__draw_move(drawing, p[0], p[1]);
        else if (step->header.type == CAIRO_PATH_LINE_TO) mus__draw_line(drawing, p[0], p[1]);
        else if (step->header.type == CAIRO_PATH_CURVE_TO) mus__draw_curve(drawing, p);
        else if (step->header.type == CAIRO_PATH_CLOSE_PATH) mus__draw_close(drawing);
    }
    cairo_path_destroy(path);
    cairo_new_path(l->scratch);
    g_object_unref(layout);
}


/* ---- text in a PDF ---- */

/* can a part of a line be shown with marks joined to their letters: from left to right, with all glyphs of the font? */
static bool show_marks(const PangoGlyphItem *run)
{
    bool marks = false, known = run->item->analysis.level % 2 == 0 && run->glyphs->num_glyphs <= LETTER_GLYPHS;
    for (int i = 0; i < run->glyphs->num_glyphs && known; i++) {
        const PangoGlyph glyph = run->glyphs->glyphs[i].glyph;
        known = glyph != PANGO_GLYPH_EMPTY && (glyph & PANGO_GLYPH_UNKNOWN_FLAG) == 0;
        marks = marks || (i > 0 && run->glyphs->glyphs[i].geometry.width == 0);
    }
    return marks && known;
}


/* show a part of a line in which a letter and the marks above and below it are one cluster: readers get the cluster's
 * text as it is written, where they would sort single glyphs by their places and tear Thai vowels and tones apart */
static void show_joined(cairo_t *cairo, const char *text, const PangoGlyphItem *run, const double *xy)
{
    const PangoGlyphString *given = run->glyphs;
    const int n = given->num_glyphs;
    cairo_glyph_t glyphs[LETTER_GLYPHS];
    cairo_text_cluster_t clusters[LETTER_GLYPHS];
    int count = 0, begun = 0;
    double x = xy[0];
    for (int i = 0; i < n; i++) {
        const PangoGlyphGeometry *place = &given->glyphs[i].geometry;
        const double scale = 1.0 / PANGO_SCALE;
        const double left = x + scale * place->x_offset, base = xy[1] + scale * place->y_offset;
        glyphs[i] = (cairo_glyph_t){given->glyphs[i].glyph, left, base};
        x += scale * place->width;
        /* a cluster begins at a glyph that moves on and belongs to other bytes than the one before it */
        const bool begins = i == 0 || (place->width != 0 && given->log_clusters[i] != given->log_clusters[i - 1]);
        if (begins) {
            if (count > 0) clusters[count - 1].num_bytes = given->log_clusters[i] - begun;
            begun = i > 0 ? given->log_clusters[i] : 0;
            clusters[count++] = (cairo_text_cluster_t){0, 0};
        }
        clusters[count - 1].num_glyphs++;
    }
    if (count > 0) clusters[count - 1].num_bytes = run->item->length - begun;
    cairo_set_scaled_font(cairo, pango_cairo_font_get_scaled_font(PANGO_CAIRO_FONT(run->item->analysis.font)));
    cairo_show_text_glyphs(cairo, text + run->item->offset, run->item->length, glyphs, n, clusters, count, 0);
}


void mus__lettering_show(const mus__lettering *l, cairo_t *cairo, const char *text, const double *xy, double height,
                         const mus__text_style *style, bool bold)
{
    PangoLayout *layout = lettering_layout(l, text, height / LETTER_CAPITAL, bold);
    const cairo_matrix_t turn = {style->cosine, -style->sine, style->sine, style->cosine, xy[0], xy[1]};
    cairo_save(cairo);
    cairo_transform(cairo, &turn);
    double place[2] = {0.0, 0.0};
    for (const GSList *at = pango_layout_get_line_readonly(layout, 0)->runs; at != NULL; at = at->next) {
        PangoGlyphItem *run = at->data;
        cairo_move_to(cairo, place[0], place[1]);
        if (show_marks(run)) show_joined(cairo, pango_layout_get_text(layout), run, place);
        else pango_cairo_show_glyph_item(cairo, pango_layout_get_text(layout), run);
        place[0] += (double)pango_glyph_string_get_width(run->glyphs) / PANGO_SCALE;
    }
    cairo_restore(cairo);
    cairo_new_path(cairo);
    g_object_unref(layout);
}

#endif
