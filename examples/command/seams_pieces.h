/* seams_pieces.h: what a drawing without words does not tell of its pieces: which are on the fold, which are a pair. */
#ifndef MUSLIN_SEAMS_PIECES_H
#define MUSLIN_SEAMS_PIECES_H

#include "args.h"
#include "muslin/pattern.h"

/*
 * Does what the options --split ("EDGE:MM,MM ...") and --piece ("NAME[=NEW] [leave|fold|fold:EDGE|pair] [LABEL]") say,
 * in this order. Numbers of edges and names of panels are those of the file. Prints one line when a text is wrong or
 * the library refuses.
 */
mus_status seams_pieces(mus_pattern *pattern, const texts *splits, const texts *pieces);

#endif
