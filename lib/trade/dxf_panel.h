/*
 * dxf_panel.h: a block of a DXF as a panel of the pattern.
 */
#ifndef MUS__TRADE_DXF_PANEL_H
#define MUS__TRADE_DXF_PANEL_H

#include "trade/dxf_ring.h"

/* one reading: the file, the rules and the size that is wanted of them, the pattern that is filled */
typedef struct mus__dxf_job {
    const mus__dxf_file *file;
    const mus__rul *rules; /* NULL: the size is that of the blocks */
    int32_t size;          /* of the rules */
    mus_pattern *pattern;
    int32_t npiece;        /* pieces that were read */
} mus__dxf_job;

/* a block that has an outline */
bool mus__dxf_is_piece(const mus__dxf_file *file, const mus__dxf_block *block);
/* add the panel of a block, and its mirror image when the piece is cut in pairs */
mus_status mus__dxf_panel(mus__dxf_job *job, const mus__dxf_block *block);

/* ---- names (dxf_name.c) ---- */

/* the text "Piece Name" of a block, else its name, else the text of layer 15, else "piece_3" */
void mus__dxf_panel_name(const mus__dxf_job *job, const mus__dxf_block *block, char *out, size_t capacity);
/* the name of a piece's mirror image: the other side's, where the name has a side ("sleeve_left") */
void mus__dxf_name_mirror(char *name, size_t capacity);
/* the text "KEY: value" of a piece: of its block, else of the piece's block in another size; length -1 without one */
mus__dxf_slice mus__dxf_piece_value(const mus__dxf_file *file, const mus__dxf_block *block, const char *key);
/* "Quantity: 1,1": copies as drawn, copies turned over; "1,0" and "1" are one */
void mus__dxf_quantity(const mus__dxf_file *file, const mus__dxf_block *block, int32_t *right, int32_t *left);

#endif
