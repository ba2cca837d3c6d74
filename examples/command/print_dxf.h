/* print_dxf.h: DXF and RUL of muslin print, in one size or several. */
#ifndef MUSLIN_PRINT_DXF_H
#define MUSLIN_PRINT_DXF_H

#include "muslin/print.h"
#include "scene.h"

/* What is asked for; texts are NULL when not given. */
typedef struct print_dxf {
    const char *dxf, *rul, *dialect, *sizes;
    bool sew; /* layer 1 is the sew line */
} print_dxf;

/* Returns the dialect MUS_DXF_* of a name, MUS_NONE for another word. */
int32_t print_dxf_dialect(const char *name);
/* Writes the files from the sheet; drafts the other sizes of the list. Returns an exit code. */
int print_dxf_write(scene *s, const source *from, const mus_sheet *sheet, const mus_sheet_def *def,
                    const print_dxf *ask);

#endif
