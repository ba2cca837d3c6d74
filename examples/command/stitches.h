/* stitches.h: what sewing leaves to see on a garment: seams, stitches, finished edges, buttons. */
#ifndef MUSLIN_STITCHES_H
#define MUSLIN_STITCHES_H

#include "muslin/muslin.h"
#include "render/render.h"

typedef struct stitches {
    int32_t count;       /* of lines */
    render_line *lines;  /* (count) in the planes of the panels */
    int32_t point_count;
    double *points;      /* (point_count x 2) those of the lines */
    render_mesh buttons; /* all of them; without any it has no vertices */
    double *button_places;
    int32_t *button_triangles;
} stitches;

/* Finds the lines and buttons of a pattern on its cloth: nodes at `positions` (nodes x 3), with their `normals`. A
 * pattern whose panels are not those of the cloth has none. Returns false without memory;
 * stitches_free() either way. */
bool stitches_make(const mus_pattern *pattern, const mus_cloth *cloth, const double *positions, const double *normals,
                   stitches *out);
void stitches_free(stitches *s);

#endif
