/* print_notes.h: what the first page of muslin print tells of the garment. */
#ifndef MUSLIN_PRINT_NOTES_H
#define MUSLIN_PRINT_NOTES_H

#include "muslin/print.h"
#include "scene.h"

/* Writes as lines of text (mus_sheet_def's notes) the measures that the pattern was drafted to, unless it was read from
 * a file, and the cloth and the notions of its instructions. *out is freed by free(), also after a failure; NULL for
 * none. */
mus_status print_notes(const scene *s, const source *from, int32_t language, char **out);

#endif
