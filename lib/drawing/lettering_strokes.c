/*
 * lettering_strokes.c: letters for a build without Pango: all of them are strokes. Letters that the strokes do not have
 * become their base letters or question marks; a language that is written in such letters is refused.
 */
#include "drawing/lettering.h"

#ifdef MUS_STROKES_ONLY

#include "muslin/language.h"




mus_status mus__lettering_make(mus_context *context, int32_t language, mus__lettering **out)
{
    *out = NULL;
    if (mus__text_has_strokes(mus_language_name(language))) return MUS_OK;
    return mus__file_fail(context, MUS_ERR_ARG, "sheet: language \"%s\" needs fonts, and this library was built "
                          "without Pango", mus_language_tag(language));
}


void mus__lettering_free(mus__lettering *lettering)
{
    (void)lettering;
}


bool mus__lettering_sets(const mus__lettering *lettering, const char *text)
{
    (void)lettering;
    (void)text;
    return false;
}


double mus__lettering_width(const mus__lettering *lettering, const char *text, bool bold)
{
    (void)lettering;
    (void)bold;
    return mus__text_width(text);
}


size_t mus__lettering_line(const mus__lettering *lettering, const char *text, double height, double width)
{
    (void)lettering;
    return mus__text_line(text, height, width);
}


void mus__lettering_outline(const mus__lettering *lettering, mus__drawing *drawing, const char *text, double x,
                            double y, const mus__text_style *style, bool bold)
{
    (void)lettering, (void)drawing, (void)text, (void)x, (void)y, (void)style, (void)bold;
}


void mus__lettering_show(const mus__lettering *lettering, cairo_t *cairo, const char *text, const double *xy,
                         double height, const mus__text_style *style, bool bold)
{
    (void)lettering, (void)cairo, (void)text, (void)xy, (void)height, (void)style, (void)bold;
}

#endif
