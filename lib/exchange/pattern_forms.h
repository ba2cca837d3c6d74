/*
 * pattern_forms.h: the forms of a pattern file. Each reader fills an empty pattern.
 */
#ifndef MUS_EXCHANGE_PATTERN_FORMS_H
#define MUS_EXCHANGE_PATTERN_FORMS_H

#include "exchange/json_at.h"

/* no garment has more; a panel is found by its name, one after the other, so the limit bounds the time of reading */
#define MUS__FILE_PANELS_MAX 10000

mus_status mus__pattern_read_json(const mus__json_at *root, mus_pattern *pattern);
mus_status mus__pattern_read_garmentcode(const mus__json_at *root, mus_pattern *pattern);
mus_status mus__pattern_read_freesewing(const mus__json_at *root, mus_pattern *pattern);

#endif
