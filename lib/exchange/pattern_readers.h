/*
 * pattern_readers.h: the readers of the forms of a pattern file. Each fills an empty pattern.
 */
#ifndef MUS_EXCHANGE_PATTERN_READERS_H
#define MUS_EXCHANGE_PATTERN_READERS_H

#include "exchange/json_path.h"

/* most panels of a file; chosen: no garment has more, and it bounds the memory that a small file can ask for */
#define MUS__FILE_PANELS_MAX 10000

/* the words of MUS_CLOSURE_*, in their order */
#define MUS__JSON_CLOSURES "none", "zip", "buttons", "ties"

mus_status mus__pattern_read_json(const mus__json_at *root, mus_pattern *pattern);
mus_status mus__pattern_read_garmentcode(const mus__json_at *root, mus_pattern *pattern);
mus_status mus__pattern_read_freesewing(const mus__json_at *root, mus_pattern *pattern);

#endif
