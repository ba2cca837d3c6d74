/*
 * svg_path.h: the data of an SVG path as a chain of pieces of a pattern's edge; transforms.
 */
#ifndef MUS_TRADE_SVG_PATH_H
#define MUS_TRADE_SVG_PATH_H

#include <stdbool.h>

#include "exchange/file_read.h"

typedef struct mus__svg_path {
    int32_t npiece, nxy, piece_room, xy_room;
    int32_t *kinds; /* (npiece) MUS_PIECE_* */
    double *xy;     /* (nxy x 2) the start, then for each piece its control points and its end */
    bool closed;    /* by Z, or by an end at the start */
} mus__svg_path;

/* reads path data, each point transformed by the matrix m (a b c d e f of SVG). `line` stands in messages. Errors:
 * MUS_ERR_FORMAT, MUS_ERR_UNSUPPORTED (a second subpath, an elliptical arc), MUS_ERR_LIMIT, MUS_ERR_MEMORY */
mus_status mus__svg_path_read(const mus__source *source, int64_t line, const char *d, const double *m,
                              mus__svg_path *out);
void mus__svg_path_free(mus_context *context, mus__svg_path *path);
/* m = m * transform. Errors: MUS_ERR_FORMAT */
mus_status mus__svg_transform(const mus__source *source, int64_t line, const char *text, double *m);
/* out = m * p */
void mus__svg_apply(const double *m, const double *p, double *out);

#endif
