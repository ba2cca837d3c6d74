/* fitmap.h: how a garment fits, as colours on it with a legend, and in the report. */
#ifndef MUSLIN_FITMAP_H
#define MUSLIN_FITMAP_H

#include "json.h"
#include "scene.h"

/* Colours of a map and what they mean. */
typedef struct fit_map {
    double *colours; /* (nodes x 3) linear, by malloc */
    int32_t which;   /* strain, pressure, ease */
    char title[24];
    double low, high; /* of the scale, in the unit of the title */
} fit_map;

/* Is it strain, pressure or ease? Returns an exit code. */
int fit_map_check(const scene *s, const char *name);
/* Colours of the cloth by one of them. Returns an exit code. */
int fit_map_make(const scene *s, const char *name, const mus_fit *fit, fit_map *out);
void fit_map_free(fit_map *map);
/* the scale, with numbers, into the right edge of a picture (rows from the top, 4 bytes a pixel) */
void fit_map_legend(const fit_map *map, int32_t width, int32_t height, unsigned char *rgba);

/* "fit": levels, and the most and the mean of strain, pressure and gap */
void fit_write(const mus_fit *fit, json *j);

#endif
