/*
 * dxf.h: what the DXF and the RUL of a sheet share: the options, the names and the grade rules.
 *
 * Flow: dxf_rules.c checks the options, numbers the grade rules and writes texts; dxf_piece.c writes the block of a
 * piece; dxf.c writes the sections and the RUL file.
 */
#ifndef MUS__PRINT_DXF_H
#define MUS__PRINT_DXF_H

#include "file/sink.h"
#include "print/sheet.h"

#define MUS__DXF_NAME 21 /* [bytes] of a name with its zero byte: readers of the trade take 20 characters */

typedef struct mus__dxf {
    const mus_sheet *sheet; /* of the sample size */
    mus_sheet_dxf def;      /* its texts are never NULL but for the date */
    int32_t nsize;          /* sizes with the sample, which is the first */
    int32_t nrule;
    int32_t npoint;         /* ends of edges of all pieces */
    int32_t *rule_of;       /* (npoint) rule of the point, in the order of pieces and sides; NULL for one size */
    int32_t *rules;         /* (nrule x nsize x 2) displacement from the sample [1e-4 mm] */
    char (*names)[MUS__DXF_NAME]; /* (pieces) */
    mus__sink *bytes;
} mus__dxf;

/* check the options, name the pieces and number the grade rules; the caller frees `dxf`, after a failure too */
mus_status mus__dxf_open(const mus_sheet *sheet, const mus_sheet_dxf *def, mus__dxf *dxf);
void mus__dxf_free(mus__dxf *dxf);
/* sheet and name of size i, 0 for the sample */
const mus_sheet *mus__dxf_sheet(const mus__dxf *dxf, int32_t i);
const char *mus__dxf_size_name(const mus__dxf *dxf, int32_t i);

/* write a group code and its text: characters outside ASCII as \U+XXXX */
void mus__dxf_text(mus__sink *bytes, int32_t code, const char *text);
/* write "KEY: VALUE" as a TEXT entity at (x, y) [m] */
void mus__dxf_label(mus__sink *bytes, int32_t layer, const double *at, const char *key, const char *value);
/* write the block of piece `piece` of size `size` */
void mus__dxf_piece(const mus__dxf *dxf, int32_t piece, int32_t size);

#endif
