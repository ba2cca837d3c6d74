/*
 * design_list.c: the public list of named designs (names, families, titles, words, groups) and of the axes of words.
 */
#include <string.h>

#include "design/design_table.h"
#include "design/words.h"

/* the tables in the order of their numbers */
static const struct {
    const mus__design_row *row;
    const int32_t *n;
} design_tables[] = {
    {mus__designs_top, &mus__designs_top_count},
    {mus__designs_lower, &mus__designs_lower_count},
    {mus__designs_dress, &mus__designs_dress_count},
};

#define DESIGN_TABLES (sizeof design_tables / sizeof design_tables[0])


static const mus__design_row *design_row(int32_t design)
{
    for (size_t i = 0; i < DESIGN_TABLES && design >= 0; i++) {
        if (design < *design_tables[i].n) return &design_tables[i].row[design];
        design -= *design_tables[i].n;
    }
    return NULL;
}


int32_t mus_design_count(void)
{
    int32_t n = 0;
    for (size_t i = 0; i < DESIGN_TABLES; i++) n += *design_tables[i].n;
    return n;
}


const char *mus_design_name(int32_t design)
{
    const mus__design_row *row = design_row(design);
    return row != NULL ? row->name : NULL;
}


const char *mus_design_family(int32_t design)
{
    const mus__design_row *row = design_row(design);
    return row != NULL ? row->family : NULL;
}


const char *mus_design_title(int32_t design)
{
    const mus__design_row *row = design_row(design);
    return row != NULL ? row->title : NULL;
}


const char *mus_design_words(int32_t design)
{
    const mus__design_row *row = design_row(design);
    return row != NULL ? row->words : NULL;
}


int32_t mus_design_groups(int32_t design)
{
    const mus__design_row *row = design_row(design);
    return row != NULL ? row->groups : 0;
}


int32_t mus_design_find(const char *name)
{
    int32_t first = 0;
    for (size_t i = 0; name != NULL && i < DESIGN_TABLES; first += *design_tables[i++].n)
        for (int32_t r = 0; r < *design_tables[i].n; r++)
            if (strcmp(design_tables[i].row[r].name, name) == 0) return first + r;
    return MUS_NONE;
}


/* ---- axes of words ---- */

int32_t mus_design_axis_count(void)
{
    return MUS__AXIS_COUNT;
}


const char *mus_design_axis_name(int32_t axis)
{
    return mus__style_axis(axis);
}


int32_t mus_design_option_count(int32_t axis)
{
    int32_t n = 0;
    while (mus__style_word(axis, n) != NULL) n++;
    return n;
}


const char *mus_design_option_name(int32_t axis, int32_t option)
{
    return mus__style_word(axis, option);
}


mus_status mus_design_spell(mus_context *context, const char *words, char *text, size_t size)
{
    mus__style style;
    if (context == NULL) return MUS_ERR_ARG;
    if (size > 0 && text != NULL) text[0] = '\0';
    if (words == NULL || text == NULL || size == 0)
        return mus__fail(context, MUS_ERR_ARG, "spell: words or text is NULL, or size is 0");
    const mus_status status = mus__style_read(context, words, &style);
    if (status == MUS_OK) mus__style_spell(&style, text, size);
    return status;
}
