/* test_barycentric_transfer.c: where the nodes of one cut lie in another, and shapes carried from cut to cut. */
#include <math.h>
#include <stdlib.h>

#include "drape/drape_state.h"
#include "scenes.h"


/* an affine map of the flat, which linear weights must reproduce */
static void affine(const double *rest, double *out)
{
    out[0] = 0.3 + 1.2 * rest[0] - 0.4 * rest[1];
    out[1] = -0.1 + 0.2 * rest[0] + 0.7 * rest[1];
    out[2] = 2.0 - 0.5 * rest[0] + 0.9 * rest[1];
}


/* a square is covered by its triangles, so that no node lies outside */
START_TEST(affine_shapes_pass_between_cuts_exactly)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.4);
    const double spacing[2] = {0.011, 0.037};
    mus_cloth *cloth[2];
    for (int i = 0; i < 2; i++) cloth[i] = scene_cut(context, pattern, spacing[i], 0.0);
    const mus_cloth *from = cloth[_i], *to = cloth[1 - _i];
    double *shape = malloc(3 * (size_t)from->nnode * sizeof *shape), *got = malloc(3 * (size_t)to->nnode * sizeof *got);
    for (int32_t i = 0; i < from->nnode; i++) affine(from->rest + 2 * i, shape + 3 * i);
    mus__transfer transfer;
    ck_assert_int_eq(mus__transfer_build(context, from, to, &transfer), MUS_OK);
    mus__transfer_apply(&transfer, shape, got);
    for (int32_t i = 0; i < to->nnode; i++) {
        double expect[3], sum = 0.0;
        affine(to->rest + 2 * i, expect);
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(got[3 * i + k], expect[k], 1e-6);
            ck_assert(transfer.weight[3 * i + k] >= 0.0f);
            sum += (double)transfer.weight[3 * i + k];
        }
        ck_assert_double_eq_tol(sum, 1.0, 1e-6);
    }
    mus__transfer_clear(context, &transfer);
    free(shape);
    free(got);
    for (int i = 0; i < 2; i++) mus_cloth_destroy(cloth[i]);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* the slow plain form: the nearest point over all triangles of the panel */
START_TEST(located_triangle_is_the_nearest_of_all)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_pattern *pattern;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern), MUS_OK);
    mus_cloth *from = scene_cut(context, pattern, 0.04, 0.0), *to = scene_cut(context, pattern, 0.025, 0.0);
    mus__transfer transfer;
    ck_assert_int_eq(mus__transfer_build(context, from, to, &transfer), MUS_OK);
    for (int32_t i = 0; i < to->nnode; i += 7) {
        const mus__panel_mesh *panel = &from->panel[to->node_panel[i]];
        double got[2] = {0, 0}, best = INFINITY;
        for (int k = 0; k < 3; k++)
            for (int d = 0; d < 2; d++)
                got[d] += (double)transfer.weight[3 * i + k] * from->rest[2 * transfer.node[3 * i + k] + d];

        /* no node and no middle of an edge of any triangle is nearer than what was found */
        for (int32_t t = panel->first_triangle; t < panel->first_triangle + panel->triangle_count; t++)
            for (int k = 0; k < 3; k++) {
                const double *a = from->rest + 2 * from->triangle[3 * t + k];
                const double *b = from->rest + 2 * from->triangle[3 * t + (k + 1) % 3];
                for (int e = 0; e <= 8; e++) {
                    const double x = a[0] + (b[0] - a[0]) * e / 8 - to->rest[2 * i];
                    const double y = a[1] + (b[1] - a[1]) * e / 8 - to->rest[2 * i + 1];
                    best = fmin(best, sqrt(x * x + y * y));
                }
            }
        ck_assert_double_le(hypot(got[0] - to->rest[2 * i], got[1] - to->rest[2 * i + 1]), best + 1e-6);
    }
    mus__transfer_clear(context, &transfer);
    mus_cloth_destroy(from);
    mus_cloth_destroy(to);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* a drape that starts where another lies is where that one is, and welded when that one is */
START_TEST(warm_start_of_the_same_cloth_moves_nothing)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.1);
    mus_drape *old = scene_drape(context, cloth, 32, 1), *new = scene_drape(context, cloth, 64, 1);
    ck_assert_int_eq(mus_drape_sew(old, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_warm(new, old), MUS_OK);
    const double *a = mus_drape_positions(old), *b = mus_drape_positions(new);
    for (int32_t i = 0; i < 3 * mus_drape_node_count(old); i++) ck_assert_double_eq_tol(a[i], b[i], 1e-7);
    ck_assert(new->welded);

    /* another number of panels is refused, and the drape stays */
    mus_pattern *square = scene_square(context, 0.2);
    mus_cloth *other = scene_cut(context, square, 0.02, 0.1);
    mus_drape *third = scene_drape(context, other, 64, 1);
    const uint64_t hash = mus_drape_hash(new);
    ck_assert_int_eq(mus_drape_warm(new, third), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_warm(new, NULL), MUS_ERR_ARG);
    ck_assert(mus_drape_hash(new) == hash);
    mus_drape_destroy(old);
    mus_drape_destroy(new);
    mus_drape_destroy(third);
    mus_cloth_destroy(cloth);
    mus_cloth_destroy(other);
    mus_pattern_destroy(pattern);
    mus_pattern_destroy(square);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_barycentric_transfer(void)
{
    Suite *suite = suite_create("barycentric_transfer");
    TCase *tests = tcase_create("transfer");
    tcase_add_loop_test(tests, affine_shapes_pass_between_cuts_exactly, 0, 2);
    tcase_add_test(tests, located_triangle_is_the_nearest_of_all);
    tcase_add_test(tests, warm_start_of_the_same_cloth_moves_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
