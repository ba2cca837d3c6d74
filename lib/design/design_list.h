/*
 * design_list.h: a row of the list of named designs. The rows stand in design_list_*.c, a file for each kind of
 * garment; adding a design is adding a row there.
 */
#ifndef MUS_DESIGN_LIST_H
#define MUS_DESIGN_LIST_H

#include "muslin/design.h"

typedef struct mus__design_row {
    const char *name, *family, *title;
    const char *words; /* "" for a recipe of its own */
    int32_t groups;    /* bits of MUS_GROUP_* */
} mus__design_row;

extern const mus__design_row mus__designs_top[], mus__designs_knit[], mus__designs_skirt[], mus__designs_trousers[],
    mus__designs_dress[], mus__designs_suit[];
extern const int32_t mus__designs_top_count, mus__designs_knit_count, mus__designs_skirt_count,
    mus__designs_trousers_count, mus__designs_dress_count, mus__designs_suit_count;

#endif
