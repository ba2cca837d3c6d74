/*
 * test_edges.c: edges that nothing holds lie at rest as the pattern has them: points of strapless tops stand, bands at
 * a hem hang below the cloth that blouses over them.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drape/worn.h"
#include "muslin/dress.h"
#include "muslin/exchange.h"

Suite *mus_suite_edges(void);

/* a specification, a panel of it, and the heights in the flat between which its nodes are looked at [m] */
typedef struct edge_row {
    const char *spec, *body, *panel;
    double low, high;
} edge_row;

static const edge_row rows[] = {{"d11_007_m_smpl_average_A40", "m_smpl_average_A40", "left_btorso", 0.34, 1.0},
                                {"d11_007_m_smpl_average_A40", "m_smpl_average_A40", "right_ftorso", 0.28, 1.0},
                                {"d11_005_mean_female", "mean_female", "wb_front", -1.0, 1.0},
                                {"d11_012_mean_all", "mean_all", "wb_back", -1.0, 1.0}};
enum { ROWS = sizeof rows / sizeof *rows };


/* slope of the height at rest over that in the flat, by least squares: 1 hangs straight, below 0 is turned over */
static double edge_slope(const mus_cloth *cloth, const mus_drape *drape, const edge_row *row)
{
    const double *flat = mus_cloth_rest(cloth), *x = mus_drape_positions(drape);
    double n = 0.0, sy = 0.0, sh = 0.0, syy = 0.0, syh = 0.0;
    for (int32_t p = 0; p < mus_cloth_panel_count(cloth); p++) {
        int32_t range[4];
        ck_assert_int_eq(mus_cloth_panel_range(cloth, p, range), MUS_OK);
        if (strcmp(mus_cloth_panel_name(cloth, p), row->panel) != 0) continue;
        for (int32_t i = range[0]; i < range[0] + range[1]; i++) {
            const double y = flat[2 * (int64_t)i + 1], height = x[3 * (int64_t)i + 1];
            if (y < row->low || y > row->high) continue;
            n += 1.0, sy += y, sh += height, syy += y * y, syh += y * height;
        }
    }
    ck_assert_double_ge(n, 12.0);
    return (n * syh - sy * sh) / (n * syy - sy * sy);
}


START_TEST(free_edges_lie_as_the_pattern_has_them)
{
    const edge_row *row = &rows[_i];
    char relative[128], spec[1024], tape[1024];
    snprintf(relative, sizeof relative, "garmentcode/specs/%s_specification.json", row->spec);
    if (support_data(relative, spec, sizeof spec) == NULL) return;
    snprintf(relative, sizeof relative, "garmentcode/bodies/%s.yaml", row->body);
    if (support_data(relative, tape, sizeof tape) == NULL) return;
    mus_context *context = support_context();
    mus_tape *measures;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.015, def.self_contact = 1;
    ck_assert_int_eq(mus_tape_read(context, tape, NULL, &measures), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(measures), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, measures, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus_pattern_read(context, spec, &pattern), MUS_OK);
    const mus_status status = mus_dress(context, pattern, body, &def, NULL, NULL, &cloth, &drape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    const double slope = edge_slope(cloth, drape, row);
    ck_assert_msg(slope > 0.7, "%s: %g", row->panel, slope);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(measures);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_edges(void)
{
    Suite *suite = suite_create("edges");
    TCase *tests = tcase_create("edges");
    tcase_set_timeout(tests, 120.0);
    tcase_add_loop_test(tests, free_edges_lie_as_the_pattern_has_them, 0, SUPPORT_SLOW ? 1 : ROWS);
    suite_add_tcase(suite, tests);
    return suite;
}
