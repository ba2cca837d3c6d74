/*
 * design_list.c: the list of named designs as one: names, families, titles, words, groups; and the axes of words as a
 * program asks for them.
 */
#include <string.h>

#include "design/design_list.h"
#include "design/words.h"

#define ALL (MUS_GROUP_WOMEN | MUS_GROUP_MEN | MUS_GROUP_CHILDREN)

/* these have recipes of their own, design.c lists them in the same order */
static const mus__design_row design_own[] = {
    {"tshirt", "top", "T-shirt", "", ALL},
    {"sleeveless", "top", "Sleeveless top", "", ALL},
    {"bodice", "block", "Bodice block", "", ALL},
    {"skirt", "skirt", "Straight skirt", "", ALL},
    {"skirt_plain", "skirt", "A-line skirt without darts", "", ALL},
};

static const int32_t design_own_count = (int32_t)(sizeof design_own / sizeof design_own[0]);

/* the lists in the order of their numbers */
static const struct {
    const mus__design_row *row;
    const int32_t *n;
} design_lists[] = {
    {design_own, &design_own_count},
    {mus__designs_top, &mus__designs_top_count},
    {mus__designs_knit, &mus__designs_knit_count},
    {mus__designs_skirt, &mus__designs_skirt_count},
    {mus__designs_trousers, &mus__designs_trousers_count},
    {mus__designs_dress, &mus__designs_dress_count},
    {mus__designs_suit, &mus__designs_suit_count},
};

#define DESIGN_LISTS (sizeof design_lists / sizeof design_lists[0])


static const mus__design_row *design_find_row(int32_t design)
{
    for (size_t i = 0; i < DESIGN_LISTS && design >= 0; i++) {
        if (design < *design_lists[i].n) return &design_lists[i].row[design];
        design -= *design_lists[i].n;
    }
    return NULL;
}


int32_t mus_design_count(void)
{
    int32_t n = 0;
    for (size_t i = 0; i < DESIGN_LISTS; i++) n += *design_lists[i].n;
    return n;
}


const char *mus_design_name(int32_t design)
{
    const mus__design_row *row = design_find_row(design);
    return row != NULL ? row->name : NULL;
}


const char *mus_design_family(int32_t design)
{
    const mus__design_row *row = design_find_row(design);
    return row != NULL ? row->family : NULL;
}


const char *mus_design_title(int32_t design)
{
    const mus__design_row *row = design_find_row(design);
    return row != NULL ? row->title : NULL;
}


const char *mus_design_words(int32_t design)
{
    const mus__design_row *row = design_find_row(design);
    return row != NULL ? row->words : NULL;
}


int32_t mus_design_groups(int32_t design)
{
    const mus__design_row *row = design_find_row(design);
    return row != NULL ? row->groups : 0;
}


int32_t mus_design_find(const char *name)
{
    int32_t first = 0;
    for (size_t i = 0; name != NULL && i < DESIGN_LISTS; first += *design_lists[i++].n)
        for (int32_t r = 0; r < *design_lists[i].n; r++)
            if (strcmp(design_lists[i].row[r].name, name) == 0) return first + r;
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
