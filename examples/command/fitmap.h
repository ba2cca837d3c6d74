/* fitmap.h: the fit of a garment as colours with a legend, and as members of the report. */
#ifndef MUSLIN_FITMAP_H
#define MUSLIN_FITMAP_H

#include "json.h"
#include "scene.h"

/* The colours of a map, and its scale. */
typedef struct fit_map {
    double *colours; /* (nodes x 3) linear RGB, by malloc() */
    int32_t which;   /* index of the map: strain, pressure, ease */
    char title[24];
    double low, high; /* of the scale, in the unit of the title */
    double part[3];   /* what 50, 95 and 99 % of the area have at most, in that unit */
} fit_map;

/* Checks that `name` is strain, pressure or ease. Returns an exit code. */
int fit_map_check(const scene *s, const char *name);
/* Makes the colours of the cloth by one map. Returns an exit code. */
int fit_map_make(const scene *s, const char *name, const mus_fit *fit, fit_map *out);
void fit_map_free(fit_map *map);
/* Draws the scale with its numbers and the percentiles at the right edge of a picture (rows from the top, 4 bytes a
 * pixel). */
void fit_map_legend(const fit_map *map, int32_t width, int32_t height, unsigned char *rgba);

/* Writes the member "fit" (levels, and the spread of strain, pressure and gap), and "strain" and "pressure_pa". */
void fit_write(const mus_fit *fit, json *j);

#endif
