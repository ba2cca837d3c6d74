/* svg_read.h: an SVG of drawn panels as a pattern. */
#ifndef MUS_TRADE_SVG_READ_H
#define MUS_TRADE_SVG_READ_H

#include <stdbool.h>

#include "exchange/file_read.h"

/* true when the text is XML whose first element is svg */
bool mus__svg_begins(const char *text);
mus_status mus__svg_read(const mus__source *source, mus_pattern *pattern);

#endif
