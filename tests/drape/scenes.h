/* scenes.h: small patterns and cloths for the drape's tests, by the public API. */
#ifndef MUS_TESTS_SCENES_H
#define MUS_TESTS_SCENES_H

#include "muslin/muslin.h"
#include "support.h"

/* add a rectangle w x h with its lower left corner at (x, y); edge (4) gets bottom, right, top, left */
static inline int32_t scene_rectangle(mus_pattern *pattern, const char *name, double x, double y, double w, double h,
                                      int32_t *edge)
{
    const double corner[4][2] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    const int32_t line = MUS_PIECE_LINE, forward[4] = {1, 1, 1, 1};
    int32_t panel, point[4];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]), MUS_OK);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(
            mus_pattern_add_edge(pattern, NULL, point[i], point[(i + 1) % 4], 1, &line, 0, NULL, &edge[i]), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edge, forward), MUS_OK);
    return panel;
}


static inline void scene_sew(mus_pattern *pattern, int32_t a, int32_t b, double ease)
{
    mus_seam_def seam;
    int32_t index;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = a;
    seam.edge_b = b;
    seam.ease = ease;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, &index), MUS_OK);
}


static inline void scene_move(mus_pattern *pattern, int32_t panel, double x, double y, double z)
{
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    place.origin[0] = x, place.origin[1] = y, place.origin[2] = z;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
}


/* two strips 0.3 m wide, one above the other with a gap of 0.1 m, sewn along the edges that face each other; the upper
 * edge is `ratio` times as long */
static inline mus_pattern *scene_strips(mus_context *context, double ratio)
{
    mus_pattern *pattern;
    int32_t low[4], high[4];
    ck_assert_int_eq(mus_pattern_create(context, "strips", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "low", 0, 0, 0.3, 0.1, low), 0, 1, 0);
    scene_move(pattern, scene_rectangle(pattern, "high", 0, 0, 0.3 * ratio, 0.1, high), 0, 1.2, 0);
    scene_sew(pattern, low[2], high[0], 0.3 * ratio - 0.3);
    return pattern;
}


static inline mus_pattern *scene_square(mus_context *context, double side)
{
    mus_pattern *pattern;
    int32_t edge[4];
    ck_assert_int_eq(mus_pattern_create(context, "square", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "square", 0, 0, side, side, edge), 0, 1, 0);
    return pattern;
}


static inline mus_cloth *scene_cut(mus_context *context, const mus_pattern *pattern, double spacing, double damping)
{
    mus_cloth_def cut;
    mus_cloth *cloth;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = spacing;
    cut.fabric.damping = damping;
    ck_assert_int_eq(mus_cloth_create(context, pattern, &cut, &cloth), MUS_OK);
    return cloth;
}


static inline mus_drape *scene_drape(mus_context *context, const mus_cloth *cloth, int32_t precision, int32_t threads)
{
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.threads = threads;
    def.drag = 0.0;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    return drape;
}

#endif
