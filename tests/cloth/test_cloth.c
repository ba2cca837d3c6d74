/*
 * test_cloth.c: creating, asking, sharing and failing; the same cloth from the same pattern.
 */
#include "cut.h"


static uint64_t hash_of(const mus_cloth *cloth)
{
    uint64_t hash = MUS_HASH_START;
#define TAKE(array, count) hash = mus__hash(hash, cloth->array, (size_t)(count) * sizeof *cloth->array)
    TAKE(rest, 2 * cloth->nnode);
    TAKE(mass, cloth->nnode);
    TAKE(triangle, 3 * cloth->ntriangle);
    TAKE(run, cloth->nrun);
    TAKE(bend, cloth->nbend);
    TAKE(hinge, cloth->nhinge);
    TAKE(pair, 2 * cloth->npair);
#undef TAKE
    for (int32_t s = 0; s < cloth->nspring; s++) {
        const mus__spring *spring = &cloth->spring[s];
        hash = mus__hash(hash, &spring->k, sizeof spring->k);
        hash = mus__hash(hash, &spring->b, sizeof spring->b);
    }
    return hash;
}


START_TEST(the_same_pattern_makes_the_same_cloth)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context), *copy;
    cut_skirt(pattern);
    CUT(mus_pattern_copy(pattern, &copy));
    mus_cloth *a = cut_cloth(context, pattern, 0.01, NULL), *b = cut_cloth(context, copy, 0.01, NULL);
    mus_cloth *c = cut_cloth(context, pattern, 0.011, NULL);
    ck_assert_uint_eq(hash_of(a), hash_of(b));
    ck_assert_uint_ne(hash_of(a), hash_of(c));
    mus_cloth_destroy(a);
    mus_cloth_destroy(b);
    mus_cloth_destroy(c);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* bending length [m] of the softest direction of a cloth (Peirce 1930) */
static double bending_length(const mus_cloth *cloth)
{
    const double *bend = cloth->fabric.bend, softest = fmin(fmin(bend[0], bend[1]), bend[2]);
    return cbrt(softest / (9.81 * cloth->fabric.weight));
}


/* the cloth itself is as soft as its fabric; what is coarser is as long in bending as two of its cells */
START_TEST(coarser_cuts_are_stiffer_the_coarser_they_are)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    cut_skirt(pattern);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    for (int stiff = 0; stiff < 2; stiff++) {
        if (stiff) fabric.bend[0] = fabric.bend[1] = fabric.bend[2] = 0.5;
        mus_cloth *cloth = cut_cloth(context, pattern, 0.01, &fabric);
        int32_t cuts = 0;
        ck_assert_double_eq(cloth->fabric.bend[0], fabric.bend[0]);
        for (const mus_cloth *coarse = cloth->coarse; coarse != NULL; coarse = coarse->coarse, cuts++) {
            if (stiff)
                ck_assert_double_eq(coarse->fabric.bend[1], 0.5);
            else
                ck_assert_double_eq_tol(bending_length(coarse), 2.0 * coarse->spacing, 1e-12);
        }
        ck_assert_int_eq(cuts, 2);
        mus_cloth_destroy(cloth);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(questions_have_answers)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    cut_skirt(pattern);
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    ck_assert_double_eq(def.spacing, 0.01);
    mus_cloth *cloth = cut_cloth(context, pattern, def.spacing, NULL);
    mus_pattern_destroy(pattern);
    ck_assert_int_eq(mus_cloth_panel_count(cloth), 2);
    ck_assert_double_eq(mus_cloth_spacing(cloth), 0.01);
    ck_assert_int_eq(mus_cloth_pair_count(cloth), cloth->npair);
    double mass = 0.0;
    for (int32_t i = 0; i < mus_cloth_node_count(cloth); i++) {
        mass += mus_cloth_masses(cloth)[i];
        ck_assert_int_le(mus_cloth_node_panels(cloth)[i], 1);
        ck_assert(isfinite(mus_cloth_rest(cloth)[2 * i]));
    }
    ck_assert_double_eq(mass, mus_cloth_mass(cloth));
    ck_assert_int_gt(mus_cloth_spring_count(cloth), 6 * mus_cloth_node_count(cloth));
    ck_assert_ptr_nonnull(mus_cloth_triangles(cloth));
    ck_assert_ptr_nonnull(mus_cloth_pairs(cloth));
    ck_assert_ptr_nonnull(mus_cloth_pair_seams(cloth));

    int32_t range[4], n;
    const int32_t *border;
    ck_assert_int_eq(mus_cloth_panel_range(cloth, 2, range), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "panel 2"));
    ck_assert_int_eq(mus_cloth_panel_range(cloth, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cloth_panel_border(cloth, -1, &n, &border), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cloth_panel_border(cloth, 0, NULL, &border), MUS_ERR_ARG);
    mus_cloth_destroy(cloth);

    /* nothing has nothing */
    ck_assert_int_eq(mus_cloth_node_count(NULL), 0);
    ck_assert_int_eq(mus_cloth_spring_count(NULL), 0);
    ck_assert_ptr_null(mus_cloth_rest(NULL));
    ck_assert_int_eq(mus_cloth_panel_range(NULL, 0, range), MUS_ERR_ARG);
    mus_cloth_destroy(NULL);
    support_context_end(context);
}
END_TEST


START_TEST(a_retained_cloth_lives_until_its_last_owner_goes)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    cut_rectangle(pattern, "sheet", 0.1, 0.1, NULL);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL), *shared = mus__cloth_retain(cloth);
    mus_pattern_destroy(pattern);
    ck_assert_ptr_eq(cloth, shared);
    mus_cloth_destroy(cloth);
    ck_assert_int_eq(mus_cloth_node_count(shared), 81 + 40);
    mus_cloth_destroy(shared);
    support_context_end(context);
}
END_TEST


/* create fails with this status, the output is NULL, and the sentence has the word */
static void check_refused(mus_context *context, const mus_pattern *pattern, const mus_cloth_def *def, mus_status want,
                          const char *word)
{
    size_t bytes = mus_context_bytes(context);
    mus_cloth *cloth = (mus_cloth *)&bytes;
    ck_assert_int_eq(mus_cloth_create(context, pattern, def, &cloth), want);
    ck_assert_ptr_null(cloth);
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    ck_assert_msg(strstr(mus_context_error(context), word) != NULL, "%s", mus_context_error(context));
}


START_TEST(what_cannot_be_cut_is_refused_by_name)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    check_refused(context, NULL, &def, MUS_ERR_ARG, "pattern");
    check_refused(context, pattern, &def, MUS_ERR_PATTERN, "no panel");
    cut_rectangle(pattern, "sheet", 0.1, 0.1, NULL);

    const double spacing[] = {0.0, -1.0, 0.0009, 0.11, (double)NAN, (double)INFINITY};
    for (int k = 0; k < 6; k++) {
        def.spacing = spacing[k];
        check_refused(context, pattern, &def, MUS_ERR_ARG, "spacing");
    }
    def.spacing = 0.01;
    fabric.weight = 0.0;
    check_refused(context, pattern, &def, MUS_ERR_ARG, "weight 0");
    mus_cloth_def_init(&def, sizeof def);
    def.size = 4;
    check_refused(context, pattern, &def, MUS_ERR_VERSION, "mus_cloth_def");
    mus_cloth_def_init(&def, sizeof def);
    def.fabric = &fabric;
    fabric.size = 4;
    check_refused(context, pattern, &def, MUS_ERR_VERSION, "mus_fabric");

    /* too many nodes, and an outline that crosses itself */
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = 0.001;
    cut_rectangle(pattern, "field", 6.0, 6.0, NULL);
    check_refused(context, pattern, &def, MUS_ERR_LIMIT, "nodes at a spacing of 0.001 m, at most 1048576 (nodes_most)");
    def.spacing = 0.01;
    const double bow[] = {0, 0, 0.2, 0.2, 0.2, 0, 0, 0.3};
    cut_panel(pattern, "bow", 4, bow, NULL);
    check_refused(context, pattern, &def, MUS_ERR_PATTERN, "bow");
    mus_pattern_destroy(pattern);
    ck_assert_int_eq(mus_cloth_create(NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cloth_create(context, NULL, NULL, NULL), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(more_nodes_than_allowed_are_refused_before_memory_is_taken)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_cloth_def def;
    mus_cloth *cloth;
    mus_cloth_def_init(&def, sizeof def);
    ck_assert_int_eq(mus_pattern_create(context, "field", &pattern), MUS_OK);
    cut_rectangle(pattern, "field", 40.0, 40.0, NULL);
    const int64_t asked = support_allocations();
    check_refused(context, pattern, &def, MUS_ERR_LIMIT,
                  "the pattern takes about 1.6008e+07 nodes at a spacing of 0.01 m, at most 1048576 (nodes_most); a "
                  "spacing of 0.0402 m takes fewer");
    ck_assert_int_lt(support_allocations() - asked, 100);
    mus_pattern_destroy(pattern);

    /* the forecast of a square is the number itself; one node less is refused, by the forecast or while it is cut */
    ck_assert_int_eq(mus_pattern_create(context, "square", &pattern), MUS_OK);
    cut_rectangle(pattern, "square", 0.5, 0.5, NULL);
    def.nodes_most = 51 * 51;
    ck_assert_int_eq(mus_cloth_create(context, pattern, &def, &cloth), MUS_OK);
    const int32_t nodes = mus_cloth_node_count(cloth);
    ck_assert_int_le(nodes, def.nodes_most);
    mus_cloth_destroy(cloth);
    def.nodes_most = nodes - 1;
    check_refused(context, pattern, &def, MUS_ERR_LIMIT, "(nodes_most)");

    /* the spacing of the sentence is allowed; where none is, the sentence has none */
    def.nodes_most = 500;
    check_refused(context, pattern, &def, MUS_ERR_LIMIT, "; a spacing of ");
    def.spacing = strtod(strstr(mus_context_error(context), "; a spacing of ") + strlen("; a spacing of "), NULL);
    ck_assert_double_le(def.spacing, 0.026);
    ck_assert_int_eq(mus_cloth_create(context, pattern, &def, &cloth), MUS_OK);
    mus_cloth_destroy(cloth);
    def.nodes_most = 3;
    check_refused(context, pattern, &def, MUS_ERR_LIMIT, "at most 3 (nodes_most)");
    ck_assert_ptr_null(strstr(mus_context_error(context), "takes fewer"));
    for (int32_t k = 0; k < 3; k++) {
        def.nodes_most = k == 0 ? 0 : k == 1 ? -1 : (1 << 24) + 1;
        check_refused(context, pattern, &def, MUS_ERR_ARG, "expected 1 to 16777216");
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(failing_memory_leaves_nothing_behind)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = cut_begin(context);
        int32_t edges[5];
        cut_sleeve(pattern, edges);
        mus_cloth *cloth;
        mus_cloth_def def;
        mus_cloth_def_init(&def, sizeof def);
        def.spacing = 0.03;
        support_fail_after(n, false);
        mus_status status = mus_cloth_create(context, pattern, &def, &cloth);
        support_fail_never();
        ck_assert_int_eq(status == MUS_OK, cloth != NULL);
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_cloth(void);
Suite *mus_suite_cloth(void)
{
    Suite *suite = suite_create("cloth");
    TCase *tests = tcase_create("cloth");
    tcase_set_timeout(tests, 30.0);
    tcase_add_test(tests, the_same_pattern_makes_the_same_cloth);
    tcase_add_test(tests, coarser_cuts_are_stiffer_the_coarser_they_are);
    tcase_add_test(tests, questions_have_answers);
    tcase_add_test(tests, a_retained_cloth_lives_until_its_last_owner_goes);
    tcase_add_test(tests, what_cannot_be_cut_is_refused_by_name);
    tcase_add_test(tests, more_nodes_than_allowed_are_refused_before_memory_is_taken);
    tcase_add_test(tests, failing_memory_leaves_nothing_behind);
    suite_add_tcase(suite, tests);
    return suite;
}
