/*
 * pattern_internal.h: what the files of lib/pattern share, and the rooms above that read a pattern's cells.
 */
#ifndef MUS_PATTERN_INTERNAL_H
#define MUS_PATTERN_INTERNAL_H

#include "pattern/pattern_data.h"

#define MUS__FACING 0.05 /* [m] width of a facing, as it is cut and as it stiffens cloth (Aldrich 2008: 5 to 6 cm) */

/* ---- pattern.c ---- */

/* is `index` below `count`? Errors: MUS_ERR_ARG with "`what` 7 is unknown, the pattern has 4" */
mus_status mus__pattern_known(const mus_pattern *pattern, const char *what, int32_t index, int32_t count);
/* copy a name into `out` (MUS__NAME_BYTES); NULL reads as "". Errors: MUS_ERR_ARG (too long, not UTF-8) */
mus_status mus__pattern_take_name(const mus_pattern *pattern, const char *what, const char *name, char *out);
/* bring the table of panels by name up to date, where the pattern has many. Errors: MUS_ERR_MEMORY */
mus_status mus__pattern_name_panels(mus_pattern *pattern);
/* every call that changes a pattern ends with this: edits that were undone cannot be redone any more */
void mus__pattern_edited(mus_pattern *pattern);
/* copy the struct `own` to `out`, a caller's struct whose size field must be own_size. Errors: MUS_ERR_VERSION */
mus_status mus__pattern_give(const mus_pattern *pattern, void *out, const void *own, size_t own_size, const char *name);
/* "front.side", or "front.edge_12" for an edge without a name, into out (2 x MUS__NAME_BYTES) */
void mus__pattern_edge_title(const mus_pattern *pattern, int32_t edge, char *out);

/* the block of an edge with npiece pieces and nxy points, zeroed; NULL without memory */
double *mus__edge_block(mus_context *context, int32_t npiece, int32_t nxy);
/* set edge->run and edge->kinds to their places in the block edge->xy */
void mus__edge_views(mus__edge *edge);

/* destroy the patterns that undo left for redo */
void mus__history_forget_undone(mus_pattern *pattern);
/* destroy the whole history of a pattern */
void mus__history_end(mus_pattern *pattern);

/* ---- edge_attributes.c ---- */

/* no label, allowance left to the sheet, no hold, no elastic */
void mus__edge_attributes_init(mus__edge_attributes *attr);
/* are two the same in every attribute? */
bool mus__edge_attributes_equal(const mus__edge_attributes *a, const mus__edge_attributes *b);

/* ---- panel_attributes.c ---- */

/* no label, sides as the name tells, cut once, layer 0, warp along y, flat at the origin */
void mus__panel_attributes_init(mus__panel_attributes *attr);
/* the sides MUS_SIDE_* that the words of a panel's name tell */
int32_t mus__sides_named(const char *name);

/* Errors: MUS_ERR_ARG (layer outside 0 to MUS_LAYERS_MOST - 1) */
mus_status mus__layer_check(const mus_pattern *pattern, int32_t layer);

/* ---- outline_crossing.c ---- */

/* does the outline of a panel cross or touch itself? When *crosses, *a and *b are the two edges, the lower index first.
 * Errors: MUS_ERR_MEMORY, MUS_ERR_LIMIT (more than 2^31 chords) */
mus_status mus__panel_crosses(const mus_pattern *pattern, int32_t panel, bool *crosses, int32_t *a, int32_t *b);

#endif
