/*
 * sample_patterns.h: patterns for the tests of print, made through the public functions: a T-shirt-like set of pieces
 * with curves of every kind, allowances, notches and marks; a single polygon. Sizes are those of a medium shirt;
 * nothing here is drafted from a tape. Functions stand in this header because the programs that use them are built
 * apart.
 */
#ifndef MUS_TESTS_SAMPLE_PATTERNS_H
#define MUS_TESTS_SAMPLE_PATTERNS_H

#include <math.h>
#include <stdbool.h>

#include "muslin/pattern.h"

/* an edge to the next point: kind, control points; label, allowance (NAN: the sheet's) */
typedef struct sample_step {
    double x, y;   /* where it starts */
    int32_t kind;
    double c[4];   /* control points */
    const char *label;
    double allowance;
} sample_step;


/* panel with an outline of single-piece edges; first edge index to *first, true when all went well */
static inline bool sample_add_piece(mus_pattern *pattern, const char *name, int32_t n, const sample_step *steps,
                                    int32_t *panel, int32_t *first)
{
    int32_t points[16], edges[16], directions[16];
    static const int32_t controls[] = {0, 1, 2, 1};
    bool good = n <= 16 && mus_pattern_add_panel(pattern, name, panel) == MUS_OK;
    for (int32_t i = 0; i < n && good; i++)
        good = mus_pattern_add_point(pattern, *panel, steps[i].x, steps[i].y, &points[i]) == MUS_OK;
    for (int32_t i = 0; i < n && good; i++) {
        directions[i] = 1;
        good = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = steps[i].label,
                                                             .start = points[i], .end = points[(i + 1) % n],
                                                             .npiece = 1, .kinds = &steps[i].kind,
                                                             .nxy = controls[steps[i].kind], .xy = steps[i].c},
                                    &edges[i]) == MUS_OK;
        if (good && steps[i].label != NULL)
            good = mus_pattern_set_edge_label(pattern, edges[i], steps[i].label) == MUS_OK;
        if (good) good = mus_pattern_set_edge_allowance(pattern, edges[i], steps[i].allowance) == MUS_OK;
    }
    if (good) *first = edges[0];
    return good && mus_pattern_set_outline(pattern, *panel, n, edges, directions) == MUS_OK;
}


/* front or back: hem, side, armhole, shoulder, neck, shoulder, armhole, side; `drop` is the depth of the neck */
static inline bool sample_add_body(mus_pattern *pattern, const char *name, double drop, int32_t notch)
{
    const double w = 0.26, a = 0.47, s = 0.66, u = 0.22, n = 0.085, t = 0.70;
    const sample_step steps[] = {
        {-w, 0, MUS_PIECE_LINE, {0}, "hem", 0.025},
        {w, 0, MUS_PIECE_LINE, {0}, NULL, NAN},
        {w, a, MUS_PIECE_CUBIC, {u - 0.02, a + 0.01, u - 0.035, a + 0.1}, "armhole_left", NAN},
        {u - 0.01, s, MUS_PIECE_LINE, {0}, NULL, NAN},
        {n, t, MUS_PIECE_CUBIC, {n - 0.02, t - drop, -n + 0.02, t - drop}, "neck", 0.007},
        {-n, t, MUS_PIECE_LINE, {0}, NULL, NAN},
        {-u + 0.01, s, MUS_PIECE_CUBIC, {-u + 0.035, a + 0.1, -u + 0.02, a + 0.01}, "armhole_right", NAN},
        {-w, a, MUS_PIECE_LINE, {0}, NULL, NAN},
    };
    const double middle[4] = {0, 0.02, 0, t - drop - 0.01};
    int32_t panel, first, id;
    return sample_add_piece(pattern, name, 8, steps, &panel, &first) &&
           mus_pattern_add_notch(pattern, first + 2, 0.09, notch, &id) == MUS_OK &&
           mus_pattern_add_notch(pattern, first + 6, 0.12, notch, &id) == MUS_OK &&
           mus_pattern_add_notch(pattern, first, w, MUS_NOTCH_TRIPLE, &id) == MUS_OK &&
           mus_pattern_add_mark(pattern, panel, "centre", 2, middle, &id) == MUS_OK &&
           mus_pattern_set_cut(pattern, panel, 1, MUS_NONE) == MUS_OK;
}


static inline bool sample_add_sleeve(mus_pattern *pattern)
{
    const sample_step steps[] = {
        {-0.16, -0.14, MUS_PIECE_LINE, {0}, "hem", 0.025},
        {0.16, -0.14, MUS_PIECE_LINE, {0}, NULL, NAN},
        {0.19, 0, MUS_PIECE_CUBIC, {0.12, 0.01, 0.08, 0.12}, NULL, NAN},
        {0, 0.125, MUS_PIECE_QUADRATIC, {-0.09, 0.125}, NULL, NAN},
        {-0.11, 0.06, MUS_PIECE_ARC, {-0.1464, 0.0252}, NULL, NAN},
        {-0.19, 0, MUS_PIECE_LINE, {0}, NULL, NAN},
    };
    static const char *const names[] = {"sleeve_left", "sleeve_right"};
    int32_t panels[2], first, id;
    for (int32_t i = 0; i < 2; i++) {
        if (!sample_add_piece(pattern, names[i], 6, steps, &panels[i], &first)) return false;
        if (mus_pattern_add_notch(pattern, first + 2, 0.06, MUS_NOTCH_SINGLE, &id) != MUS_OK) return false;
        if (mus_pattern_add_notch(pattern, first + 4, 0.03, MUS_NOTCH_DOUBLE, &id) != MUS_OK) return false;
    }
    return mus_pattern_set_cut(pattern, panels[0], 2, MUS_NONE) == MUS_OK &&
           mus_pattern_set_cut(pattern, panels[1], 0, panels[0]) == MUS_OK;
}


/* a long narrow piece, its grain along its length */
static inline bool sample_add_rib(mus_pattern *pattern)
{
    const sample_step steps[] = {
        {0, 0, MUS_PIECE_LINE, {0}, NULL, NAN},
        {0.42, 0, MUS_PIECE_LINE, {0}, NULL, NAN},
        {0.42, 0.05, MUS_PIECE_LINE, {0}, NULL, NAN},
        {0, 0.05, MUS_PIECE_LINE, {0}, NULL, NAN},
    };
    const double drill[2] = {0.21, 0.025};
    int32_t panel, first, id;
    return sample_add_piece(pattern, "neck_rib", 4, steps, &panel, &first) &&
           mus_pattern_set_grain(pattern, panel, 1, 0) == MUS_OK &&
           mus_pattern_add_mark(pattern, panel, "fold", 1, drill, &id) == MUS_OK;
}


/* front, back, sleeve (its mirror image beside it), neck rib; NULL when anything failed */
static inline mus_pattern *sample_shirt(mus_context *context)
{
    mus_pattern *pattern;
    if (mus_pattern_create(context, "Shirt für Åsa", &pattern) != MUS_OK) return NULL;
    if (sample_add_body(pattern, "front", 0.11, MUS_NOTCH_SINGLE) &&
        sample_add_body(pattern, "back", 0.03, MUS_NOTCH_DOUBLE) && sample_add_sleeve(pattern) &&
        sample_add_rib(pattern))
        return pattern;
    mus_pattern_destroy(pattern);
    return NULL;
}


/* one panel "piece" with a polygon as outline, one edge a side; NULL when anything failed */
static inline mus_pattern *sample_polygon(mus_context *context, int32_t n, const double *xy)
{
    mus_pattern *pattern;
    int32_t panel, point, first = 0, last = 0, edges[256], directions[256];
    if (n > 256 || mus_pattern_create(context, "polygon", &pattern) != MUS_OK) return NULL;
    bool good = mus_pattern_add_panel(pattern, "piece", &panel) == MUS_OK;
    for (int32_t i = 0; i < n && good; i++) {
        good = mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &point) == MUS_OK;
        if (i == 0) first = point;
        directions[i] = 1;
        last = point;
    }
    for (int32_t i = 0; i < n && good; i++)
        good = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = first + i,
                                                             .end = first + i < last ? first + i + 1 : first},
                                    &edges[i]) == MUS_OK;
    if (good && mus_pattern_set_outline(pattern, panel, n, edges, directions) == MUS_OK) return pattern;
    mus_pattern_destroy(pattern);
    return NULL;
}

#endif
