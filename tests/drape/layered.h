/* layered.h: several patterns as one cloth, each farther out than the one before. */
#ifndef MUS_TESTS_LAYERED_H
#define MUS_TESTS_LAYERED_H

#include <stdio.h>

#include "muslin/muslin.h"
#include "support.h"

#define LAYERED_MOST 256


/* a panel of `from` with its edges: edge (of from's edges) gets their numbers in `all` */
static inline void layered_panel(mus_pattern *all, const mus_pattern *from, int32_t panel, double out,
                                 const char *layer, int32_t *edge)
{
    char name[96];
    int32_t added, n, point[LAYERED_MOST], outline[LAYERED_MOST];
    const int32_t *edges, *direction;
    for (int32_t i = 0; i < LAYERED_MOST; i++) point[i] = MUS_NONE;
    snprintf(name, sizeof name, "%s_%.60s", layer, mus_pattern_panel_name(from, panel));
    ck_assert_int_eq(mus_pattern_add_panel(all, name, &added), MUS_OK);
    ck_assert_int_eq(mus_pattern_outline(from, panel, &n, &edges, &direction), MUS_OK);
    ck_assert_int_le(n, LAYERED_MOST);
    for (int32_t i = 0; i < n; i++) {
        int32_t end[2], npiece, nxy;
        const int32_t *kinds;
        const double *xy;
        ck_assert_int_eq(mus_pattern_edge_ends(from, edges[i], &end[0], &end[1]), MUS_OK);
        for (int32_t k = 0; k < 2; k++) {
            double at[2];
            int32_t of;
            ck_assert_int_lt(end[k], LAYERED_MOST);
            if (point[end[k]] != MUS_NONE) continue;
            ck_assert_int_eq(mus_pattern_point(from, end[k], &of, at), MUS_OK);
            ck_assert_int_eq(mus_pattern_add_point(all, added, at[0], at[1], &point[end[k]]), MUS_OK);
        }
        ck_assert_int_eq(mus_pattern_edge_pieces(from, edges[i], &npiece, &kinds, &nxy, &xy), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_edge(all, NULL, point[end[0]], point[end[1]], npiece, kinds, nxy - 2,
                                              nxy > 2 ? xy + 2 : NULL, &edge[edges[i]]),
                         MUS_OK);
        outline[i] = edge[edges[i]];
    }
    ck_assert_int_eq(mus_pattern_set_outline(all, added, n, outline, direction), MUS_OK);

    /* along the panel's normal, which points off the body */
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    ck_assert_int_eq(mus_pattern_placement(from, panel, &place), MUS_OK);
    for (int32_t d = 0; d < 3; d++) place.origin[d] += out * place.rotation[3 * d + 2];
    if (place.bend > 0.0) place.bend += out;
    ck_assert_int_eq(mus_pattern_set_placement(all, added, &place), MUS_OK);
}


/* all panels and seams of `from`, `out` farther from the body */
static inline void layered_add(mus_pattern *all, const mus_pattern *from, double out, const char *layer)
{
    int32_t edge[LAYERED_MOST], index;
    ck_assert_int_le(mus_pattern_edge_count(from), LAYERED_MOST);
    for (int32_t p = 0; p < mus_pattern_panel_count(from); p++) layered_panel(all, from, p, out, layer, edge);
    for (int32_t s = 0; s < mus_pattern_seam_count(from); s++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        ck_assert_int_eq(mus_pattern_seam(from, s, &seam), MUS_OK);
        seam.edge_a = edge[seam.edge_a];
        seam.edge_b = edge[seam.edge_b];
        ck_assert_int_eq(mus_pattern_add_seam(all, &seam, &index), MUS_OK);
    }
}

#endif
