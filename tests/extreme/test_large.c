/*
 * test_large.c: cloths of 90,000 nodes, more than 16 bits count: memory by formula, building and stepping in proportion
 * to the nodes, by counts and not by the clock.
 *
 * MUSLIN_LARGE=1000 in the environment (`make check-large`) makes it a million nodes and eight million springs.
 */
#include "bare.h"
#include "drape/scenes.h"

Suite *mus_suite_large(void);

static const double weightless[3] = {0.0, 0.0, 0.0};


/* nodes of a side of the large sheet */
static int32_t large_side(void)
{
    const char *text = getenv("MUSLIN_LARGE");
    const int32_t side = text != NULL ? (int32_t)strtol(text, NULL, 10) : 300;
    ck_assert_msg(side >= 260 && side <= 4096, "MUSLIN_LARGE is %s, expected 260 to 4096", text != NULL ? text : "");
    return side;
}


/* bytes that a drape of a side x side sheet holds beside the cloth */
static double drape_bytes(int32_t side, int32_t precision, bool dashpots, uint64_t *allocations)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    if (!dashpots) fabric.damping = 0.0;
    mus_cloth *cloth = extreme_grid(context, side, side, 0.01, &fabric);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    const size_t before = mus_context_bytes(context);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    const size_t after = mus_context_bytes(context);
    if (allocations != NULL) *allocations = mus_context_allocations(context);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
    return (double)(after - before);
}


/* by the formula of mus_drape(3), n (29 r + 166) + 1080 rows + 6500 r, with dashpots n (32 r + 174), to 5 %;
 * test_bytes.c holds it to 1 % on smaller sheets */
START_TEST(memory_of_many_nodes_is_predicted)
{
    const int32_t precision = _i & 1 ? 64 : 32, side = large_side();
    const bool dashpots = _i & 2;
    const double nodes = (double)side * side, number = precision / 8;
    const double formula =
        nodes * ((dashpots ? 32.0 : 29.0) * number + (dashpots ? 174.0 : 166.0)) + 1080.0 * side + 6500.0 * number;
    const double bytes = drape_bytes(side, precision, dashpots, NULL);
    ck_assert_msg(fabs(bytes / formula - 1.0) < 0.05, "%.2f bytes a node, %.2f by the formula", bytes / nodes,
                  formula / nodes);
}
END_TEST


/* as many allocations for 90,000 nodes as for 900, and bytes in proportion: nothing is searched for or grown */
START_TEST(a_sheet_is_built_in_as_many_pieces_whatever_its_size)
{
    uint64_t small, large;
    const double few = drape_bytes(150, 32, true, &small), many = drape_bytes(300, 32, true, &large);
    ck_assert_double_eq_tol(many / few, 4.0, 0.1);

    /* coarser cuts of the cloth add their own, one set for each halving */
    ck_assert_uint_le(large, small + 12);
}
END_TEST


/* the same of a cut pattern: four times the nodes are made in hardly more allocations (arrays double as they grow)
 * and in four times the bytes */
START_TEST(a_pattern_is_cut_in_proportion_to_its_nodes)
{
    double bytes[2], nodes[2];
    int64_t asked[2];
    for (int k = 0; k < 2; k++) {
        mus_context *context = support_context();
        mus_pattern *pattern = scene_square(context, 0.5);
        const size_t before = mus_context_bytes(context);
        asked[k] = support_allocations();
        mus_cloth *cloth = scene_cut(context, pattern, k ? 0.004 : 0.008, 0.02);
        asked[k] = support_allocations() - asked[k];
        bytes[k] = (double)(mus_context_bytes(context) - before);
        nodes[k] = mus_cloth_node_count(cloth);
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
    ck_assert_double_eq_tol(nodes[1] / nodes[0], 4.0, 0.2);
    ck_assert_double_le(bytes[1] / bytes[0], 1.3 * nodes[1] / nodes[0]);
    ck_assert_int_le(asked[1], 2 * asked[0]);
}
END_TEST


/* indices do not wrap: in a sheet stretched by 1 % both ways, inner nodes feel no force however far along they
 * are, every row but the border's neighbours feels what the middle row feels, and so do they after a step */
START_TEST(the_last_node_is_joined_as_the_first)
{
    const int32_t side = large_side(), n = side * side;
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.damping = 0.0;
    mus_drape *drape = extreme_drape(context, extreme_grid(context, side, side, 0.01, &fabric), 64, weightless);
    const int64_t springs = 2 * (int64_t)side * (side - 1) + 2 * (int64_t)(side - 1) * (side - 1) +
                            2 * (int64_t)side * (side - 2) + 2 * (int64_t)(side - 2) * (side - 2);
    ck_assert_int_eq(extreme_report(drape).springs, springs);
    double *x = malloc(3 * (size_t)n * sizeof *x), *f = malloc(3 * (size_t)n * sizeof *f);
    for (int32_t i = 0; i < n; i++)
        x[3 * i] = 0.0101 * (i % side), x[3 * i + 1] = 0.0101 * (i / side), x[3 * i + 2] = 0.0;
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_forces(drape, f), MUS_OK);
    const double *middle = f + 3 * (int64_t)(side / 2) * side, pull = middle[0];
    ck_assert_double_gt(pull, 1e-3);
    for (int32_t r = 2; r < side - 2; r++)
        for (int32_t c = 0; c < side; c++) {
            const double *at = f + 3 * ((int64_t)r * side + c);
            for (int d = 0; d < 3; d++) ck_assert_double_eq_tol(at[d], middle[3 * c + d], 1e-7 * pull);
            if (c > 2 && c < side - 3) ck_assert_double_eq_tol(at[0], 0.0, 1e-7 * pull);
        }

    /* the kernel says the same as the plain form; evaluations are counted by the spring */
    ck_assert_int_eq(mus_drape_step(drape, 2, 1e-6), MUS_OK);
    ck_assert_int_eq(extreme_report(drape).spring_evaluations, 8 * springs);
    const double *v = mus_drape_velocities(drape), *row = v + 3 * (int64_t)(side / 2) * side;
    for (int32_t r = 3; r < side - 3; r++)
        for (int32_t c = 0; c < side; c++)
            ck_assert_double_eq_tol(v[3 * ((int64_t)r * side + c)], row[3 * c], 1e-7 * fabs(row[0]));
    free(x);
    free(f);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_large(void)
{
    Suite *suite = suite_create("large");
    TCase *tests = tcase_create("large");
    tcase_set_timeout(tests, 300);
    tcase_add_loop_test(tests, memory_of_many_nodes_is_predicted, 0, 4);
    tcase_add_test(tests, a_sheet_is_built_in_as_many_pieces_whatever_its_size);
    tcase_add_test(tests, a_pattern_is_cut_in_proportion_to_its_nodes);
    tcase_add_test(tests, the_last_node_is_joined_as_the_first);
    suite_add_tcase(suite, tests);
    return suite;
}
