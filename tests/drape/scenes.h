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
    const int32_t forward[4] = {1, 1, 1, 1};
    int32_t panel, point[4];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]), MUS_OK);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(
            mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                          .end = point[(i + 1) % 4]}, &edge[i]), MUS_OK);
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
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    cut.spacing = spacing;
    fabric.damping = damping;
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


/* two panels 0.6 m wide and 0.4 m long before and behind, sewn at the sides: wider than the hip of W40;
 * their upper edges are held */
static inline mus_pattern *scene_tube(mus_context *context, double waist, int32_t level, double below)
{
    mus_pattern *pattern;
    int32_t edge[2][4], panel, count;
    ck_assert_int_eq(mus_pattern_create(context, "tube", &pattern), MUS_OK);
    for (int i = 0; i < 2; i++) {
        panel = scene_rectangle(pattern, i == 0 ? "front" : "back", -0.3, -0.4, 0.6, 0.4, edge[i]);
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        place.origin[1] = waist, place.origin[2] = i == 0 ? 0.25 : -0.25;
        if (i == 1) place.rotation[0] = place.rotation[8] = -1.0;
        ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
        ck_assert_int_eq(mus_pattern_set_edge_label(pattern, edge[i][2], "waist"), MUS_OK);
    }
    scene_sew(pattern, edge[0][1], edge[1][3], 0.0);
    scene_sew(pattern, edge[0][3], edge[1][1], 0.0);
    ck_assert_int_eq(mus_pattern_hold_label(pattern, "waist", level, below, &count), MUS_OK);
    ck_assert_int_eq(count, 2);
    return pattern;
}


static inline mus_body *scene_body(mus_context *context)
{
    mus_tape *tape;
    mus_body *body;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, &def, &body), MUS_OK);
    mus_tape_destroy(tape);
    return body;
}

#endif
