/*
 * test_likeness.c: of the GarmentCode specifications, each looked for among the others: the same design on another body
 * comes first; and a variant of one is exact exactly when its form says so. make catalogue-bench says it of 100,000.
 */
#include "catalogue/variants.h"
#include "muslin/catalogue.h"
#include "muslin/topology.h"
#include "support.h"


START_TEST(the_same_design_on_another_body_comes_first)
{
    char path[1024];
    static variant_set set;
    if (support_data("garmentcode/specs", path, sizeof path) == NULL) return;
    mus_context *context = support_context();
    ck_assert_int_ge(variants_read(context, path, &set), 130);
    mus_catalogue *catalogue;
    int32_t id[VARIANTS_MOST], first = 0, siblings = 0;
    ck_assert_int_eq(
        mus_catalogue_open(context, support_scratch("a.db", path, sizeof path), MUS_CATALOGUE_WRITE, &catalogue),
        MUS_OK);
    ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_OK);
    for (int32_t i = 0; i < set.count; i++)
        ck_assert_int_eq(mus_catalogue_add(catalogue, set.pattern[i], set.name[i], &id[i]), MUS_OK);
    for (int32_t i = 0; i < set.count; i++) {
        int32_t found[2], exact[2], n, others = 0;
        for (int32_t k = 0; k < set.count; k++) others += k != i && strcmp(set.design[k], set.design[i]) == 0;
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, set.pattern[i], 2, found, NULL, exact, &n), MUS_OK);
        ck_assert(n == 2 && found[0] == id[i] && exact[0]);
        siblings += others > 0;
        for (int32_t k = 0; k < set.count && others > 0; k++)
            first += id[k] == found[1] && strcmp(set.design[k], set.design[i]) == 0;
    }
    printf("catalogue: of %d specifications with a sibling, %d have it first\n", (int)siblings, (int)first);
    ck_assert_int_eq(siblings, 134);
    ck_assert_int_ge(100 * first, 95 * siblings);
    mus_catalogue_destroy(catalogue);
    variants_free(&set);
    support_context_end(context);
}
END_TEST


START_TEST(variants_are_exact_when_their_forms_are_equal_and_near_when_not)
{
    char path[1024];
    static variant_set set;
    if (support_data("garmentcode/specs", path, sizeof path) == NULL) return;
    mus_context *context = support_context();
    variants_read(context, path, &set);
    mus_catalogue *catalogue;
    int32_t id[VARIANTS_MOST], near = 0, made = 0;
    uint64_t state = 88172645463325252u;
    ck_assert_int_eq(
        mus_catalogue_open(context, support_scratch("a.db", path, sizeof path), MUS_CATALOGUE_WRITE, &catalogue),
        MUS_OK);
    ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_OK);
    for (int32_t i = 0; i < set.count; i++)
        ck_assert_int_eq(mus_catalogue_add(catalogue, set.pattern[i], set.name[i], &id[i]), MUS_OK);
    for (int32_t sample = 0; sample < 300; sample++) {
        int32_t i = sample % set.count, found[VARIANTS_MOST], exact[VARIANTS_MOST], n, same, count = 0;
        size_t size[2];
        uint64_t hash[2][2];
        variant_edit edit = variant_any_edit(set.pattern[i], &state);
        for (int32_t k = 0; k < 2; k++) edit.stretch[k] = 1.0 + 0.1 * (edit.stretch[k] - 1.0);
        mus_pattern *variant = variant_make(context, set.pattern[i], &edit);
        if (variant == NULL) continue;
        made++;
        ck_assert_int_eq(mus_pattern_form(set.pattern[i], NULL, NULL, 0, &size[0], hash[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_form(variant, NULL, NULL, 0, &size[1], hash[1]), MUS_OK);
        same = memcmp(hash[0], hash[1], sizeof hash[0]) == 0;
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, variant, set.count, found, NULL, exact, &n), MUS_OK);
        for (int32_t k = 0; k < n; k++) {
            count += exact[k];
            if (found[k] == id[i]) ck_assert_int_eq(exact[k], same);
            if (k < 3) near += found[k] == id[i];
        }
        ck_assert_int_eq(mus_catalogue_exact(catalogue, variant, NULL, 0, &n), MUS_OK);
        ck_assert_int_eq(n, count);
        mus_pattern_destroy(variant);
    }
    ck_assert_int_gt(made, 290);
    ck_assert_int_gt(10 * near, 9 * made);
    mus_catalogue_destroy(catalogue);
    variants_free(&set);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_likeness(void);


Suite *mus_suite_likeness(void)
{
    Suite *suite = suite_create("likeness");
    TCase *tcase = tcase_create("likeness");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, the_same_design_on_another_body_comes_first);
    tcase_add_test(tcase, variants_are_exact_when_their_forms_are_equal_and_near_when_not);
    suite_add_tcase(suite, tcase);
    return suite;
}
