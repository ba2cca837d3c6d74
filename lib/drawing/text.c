/*
 * text.c: the texts of a drawing: in strokes, or set in a font where the drawing has one for them; kept for readers.
 */
#include <string.h>

#include "drawing/lettering.h"


/* keep a text for readers; its left end is at (x, y) */
static void text_keep(mus__drawing *drawing, const char *text, double x, double y, const mus__text_style *style)
{
    const size_t n = strlen(text);
    if (drawing->status != MUS_OK || n == 0 || n > INT32_MAX / 2) return;
    drawing->status = mus__print_reserve(drawing->context, &drawing->texts, &drawing->text_room,
                                         (int64_t)drawing->ntext + 1, sizeof *drawing->texts);
    if (drawing->status == MUS_OK)
        drawing->status = mus__print_reserve(drawing->context, &drawing->letters, &drawing->letter_room,
                                             (int64_t)drawing->nletter + (int64_t)n, 1);
    if (drawing->status != MUS_OK) return;
    memcpy(drawing->letters + drawing->nletter, text, n);
    drawing->texts[drawing->ntext++] =
        (mus__text){drawing->nletter, (int32_t)n, x, y, style->height, style->cosine, style->sine, MUS_NONE, false};
    drawing->nletter += (int32_t)n;
}


/* set a text in a font: the path becomes its outline */
static void text_set(mus__drawing *drawing, const char *text, double x, double y, const mus__text_style *style)
{
    const int32_t before = drawing->ntext;
    const mus__pen pen = drawing->npath > 0 ? drawing->paths[drawing->npath - 1].pen : MUS__PEN_TEXT;
    const bool bold = pen == MUS__PEN_TITLE;
    const double back = style->align * style->height * mus__lettering_width(drawing->lettering, text, bold);
    const double left[2] = {x - back * style->cosine, y - back * style->sine};
    text_keep(drawing, text, left[0], left[1], style);
    if (drawing->status != MUS_OK || drawing->ntext == before) return;
    mus__path *path = &drawing->paths[drawing->npath - 1];
    path->pen = pen == MUS__PEN_FAINT ? MUS__PEN_LETTER_FAINT : MUS__PEN_LETTER;
    path->text = before;
    drawing->texts[before].path = drawing->npath - 1;
    drawing->texts[before].bold = bold;
    mus__lettering_outline(drawing->lettering, drawing, text, left[0], left[1], style, bold);
}


void mus__draw_text(mus__drawing *drawing, const char *text, double x, double y, const mus__text_style *style)
{
    if (mus__lettering_sets(drawing->lettering, text)) {
        text_set(drawing, text, x, y, style);
        return;
    }
    const double back = style->align * style->height * mus__text_width(text);
    const double left[2] = {x - back * style->cosine, y - back * style->sine};
    text_keep(drawing, text, left[0], left[1], style);
    mus__stroke_text(drawing, text, left[0], left[1], style);
}
