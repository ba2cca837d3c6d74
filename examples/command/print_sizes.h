/* print_sizes.h: the sizes of muslin print --sizes. */
#ifndef MUSLIN_PRINT_SIZES_H
#define MUSLIN_PRINT_SIZES_H

#include "muslin/print.h"
#include "scene.h"

#define SIZES_MOST 64

/* A pattern in several sizes. */
typedef struct print_sizes {
    int32_t count;
    char names[SIZES_MOST][32];
    const char *name_list[SIZES_MOST]; /* the same names */
    mus_pattern *patterns[SIZES_MOST];
} print_sizes;

/* Drafts the table sizes of a list "W36,W38": without the scene's own size, or, with_own, with it, where the list has
 * it or else before the others. Returns an exit code; print_sizes_free() in every case. */
int print_sizes_draft(scene *s, const source *from, const char *list, bool with_own, print_sizes *out);
void print_sizes_free(print_sizes *sizes);
/* Lays the sizes of a list, and the scene's own, on one sheet, one on the other. Returns an exit code. */
int print_sizes_sheet(scene *s, const source *from, const char *list, const mus_sheet_def *def, mus_sheet **out);

#endif
