/*
 * dxf_read.h: a DXF file as a pattern.
 */
#ifndef MUS__TRADE_DXF_READ_H
#define MUS__TRADE_DXF_READ_H

#include "exchange/file_read.h"

/* fill an empty pattern with the pieces of a DXF in one size. size NULL: the sample size; rules NULL: no grade rules */
mus_status mus__dxf_read(const mus__source *source, const mus__source *rules, const char *size, mus_pattern *pattern);

#endif
