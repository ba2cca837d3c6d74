/*
 * sheet_words.c: the words of a sheet in its language.
 */
#include <stdio.h>
#include <string.h>

#include "muslin/language.h"
#include "drawing/phrase.h"
#include "print/sheet.h"

#define SIZES_TEXT 256 /* [bytes] of the names of all sizes; longer ones are cut; chosen */


void mus__sheet_draw_init(const mus_sheet *sheet, mus__drawing *drawing)
{
    mus__draw_init(drawing, sheet->context);
    drawing->language = sheet->language;
    drawing->lettering = sheet->lettering;
}


void mus__sheet_piece_words(const mus_sheet *sheet, int32_t index, char *out, size_t size)
{
    char name[128];
    snprintf(name, sizeof name, "%s", sheet->names[index]);
    /* half of the copies of a mirrored piece are for the other side */
    for (char *at = name; sheet->language != MUS_LANGUAGE_ENGLISH && sheet->pieces[index].mirrored && *at != '\0';) {
        const size_t n = strncmp(at, "_left", 5) == 0 ? 5 : strncmp(at, "_right", 6) == 0 ? 6 : 0;
        if (n > 0) memmove(at, at + n, strlen(at + n) + 1);
        else at++;
    }
    mus_language_compose(sheet->language, "panel", name, out, size);
}


void mus__sheet_sizes(const mus_sheet *sheet, char *out, size_t size)
{
    char names[SIZES_TEXT] = "";
    size_t at = 0;
    mus__phrase phrase = mus__phrase_in(sheet->language);
    for (int32_t k = 0; k < sheet->nsize && at < sizeof names; k++)
        at += (size_t)snprintf(names + at, sizeof names - at, "%s%s",
                               k > 0 ? mus_language_text(sheet->language, "list.comma") : "", sheet->sizes[k]);
    mus__phrase_text(&phrase, 0, names);
    mus__phrase_write(&phrase, "paper.sizes", out, size);
}
