/*
 * design_list.h: a row of the list of named designs. The rows stand in design_list_*.c, a file for each kind of
 * garment; adding a design is adding a row there.
 */
#ifndef MUS_DESIGN_LIST_H
#define MUS_DESIGN_LIST_H

#include "design/design_internal.h"

typedef struct mus__design_row {
    const char *name, *family, *title;
    const char *words; /* "" for a recipe of its own */
    int32_t groups;    /* bits of MUS_GROUP_* */
} mus__design_row;

/* a list of them */
typedef struct mus__design_rows {
    const mus__design_row *row;
    int32_t n;
} mus__design_rows;

#endif
