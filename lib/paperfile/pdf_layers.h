/*
 * pdf_layers.h: the sizes of a sheet as layers of its PDF.
 */
#ifndef MUS_PAPERFILE_PDF_LAYERS_H
#define MUS_PAPERFILE_PDF_LAYERS_H

#include "file/sink.h"
#include "print/sheet.h"

/* add the lines of the sizes to the PDF in `bytes`, which cairo has written without them (as version 1.4), each size in
 * a layer of its own (pdf_layers.c). After a failure the bytes are as they were */
mus_status mus__pdf_layers_add(const mus_sheet *sheet, mus__sink *bytes);
/* is the path drawn in the layer of its size? Grain lines, labels, squares and instructions are not */
bool mus__path_layered(const mus_sheet *sheet, const mus__path *path);
/* dashes of the cut line of a size: on and off in turn (4) [m], 0 from the end of the pattern on */
const double *mus__size_dashes(int32_t size);

#endif
