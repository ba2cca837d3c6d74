/*
 * test_block_collar.c: stand, leaf and hood against the golden numbers of an independent drafting script,
 * and their law: the edge that is sewn to the neck is as long as the neck, whatever the neck.
 */
#include <math.h>
#include <string.h>

#include "block/drafts.h"
#include "block/block_collar.h"

/* output of the script, lines "stand:" and "leaf", cm: a stand 3.5 high that rises 1.5, on half the neckline; a leaf
 * 4.5 deep with a point of 7 on the stand's top; a hood of the head's girth on half the neckline */
static const struct {
    const char *size;
    double bottom, top, x, inner, outer, width, height, neck, face, crown;
} golden[] = {
    {"W34", 17.80, 17.33, 17.71, 17.33, 18.78, 24.97, 35.68, 17.80, 37.19, 54.98},
    {"W40", 18.64, 18.19, 18.56, 18.19, 19.63, 25.22, 35.99, 18.64, 37.50, 55.32},
    {"W52", 20.74, 20.34, 20.66, 20.34, 21.75, 25.82, 36.73, 20.74, 38.24, 56.18},
    {"M46", 20.21, 19.80, 20.14, 19.80, 21.22, 25.11, 35.86, 20.21, 37.37, 54.79},
    {"M50", 21.17, 20.78, 21.10, 20.78, 22.19, 25.56, 36.41, 21.17, 37.93, 55.58},
    {"M60", 23.45, 23.10, 23.39, 23.10, 24.49, 26.59, 37.69, 23.45, 39.20, 57.43},
    {"C56", 11.71, 11.00, 11.58, 11.00, 12.56, 16.25, 24.87, 11.71, 26.39, 37.76},
    {"C104", 14.37, 13.80, 14.27, 13.80, 15.29, 22.40, 32.50, 14.37, 34.01, 50.36},
    {"C152", 17.04, 16.55, 16.95, 16.55, 18.00, 24.50, 35.10, 17.04, 36.61, 54.17},
};


START_TEST(collars_are_the_golden_numbers)
{
    mus_context *context = support_context();
    const char *size = golden[_i].size;
    const mus__measures measures = drafts_measures(context, size);
    const mus__bodice bodice = drafts_bodice(context, size);
    const double neck = bodice.front.neck_length + bodice.back.neck_length;
    mus__stand stand;
    const mus__stand_def stand_def = {.length = neck, .height = 3.5 * CM, .rise = 1.5 * CM};
    ck_assert_int_eq(mus__stand_draft(context, &stand_def, &stand), MUS_OK);
    CK_GOLDEN(size, "stand bottom", mus__cubic_length(stand.bottom), CM, golden[_i].bottom, GOLDEN);
    CK_GOLDEN(size, "stand top", stand.top_length, CM, golden[_i].top, GOLDEN);
    CK_GOLDEN(size, "stand end", stand.bottom[6], CM, golden[_i].x, GOLDEN);

    mus__leaf leaf;
    const mus__leaf_def leaf_def = {
        .length = stand.top_length, .fall = 4.5 * CM, .point = 7.0 * CM, .rise = -1.0 * CM};
    ck_assert_int_eq(mus__leaf_draft(context, &leaf_def, &leaf), MUS_OK);
    CK_GOLDEN(size, "leaf inner", mus__cubic_length(leaf.inner), CM, golden[_i].inner, GOLDEN);
    CK_GOLDEN(size, "leaf outer", mus__cubic_length(leaf.outer), CM, golden[_i].outer, GOLDEN);

    mus__hood hood;
    const mus__hood_def hood_def = {.length = neck, .head = measures.v[MUS_MEASURE_HEAD]};
    ck_assert_int_eq(mus__hood_draft(context, &hood_def, &hood), MUS_OK);
    CK_GOLDEN(size, "hood width", hood.width, CM, golden[_i].width, GOLDEN);
    CK_GOLDEN(size, "hood height", hood.height, CM, golden[_i].height, GOLDEN);
    CK_GOLDEN(size, "hood neck", mus__cubic_length(hood.neck), CM, golden[_i].neck, GOLDEN);
    CK_GOLDEN(size, "hood face", hypot(hood.top[0] - hood.neck[0], hood.top[1] - hood.neck[1]), CM,
              golden[_i].face, GOLDEN);
    CK_GOLDEN(size, "hood crown", mus__cubic_length(hood.crown) + hood.crown[6] - hood.top[0], CM,
              golden[_i].crown, GOLDEN);
    support_context_end(context);
}
END_TEST


START_TEST(neck_edges_are_as_long_as_the_neck)
{
    mus_context *context = support_context();
    uint64_t state = 31;
    for (int i = 0; i < 300; i++) {
        const double neck = support_uniform(&state, 0.10, 0.45), rise = support_uniform(&state, 0.0, 0.03);
        mus__stand stand;
        const mus__stand_def stand_def = {
            .length = neck, .height = support_uniform(&state, 0.02, 0.06), .rise = rise};
        ck_assert_msg(mus__stand_draft(context, &stand_def, &stand) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(mus__cubic_length(stand.bottom), neck, 1e-9);
        ck_assert_double_le(stand.top_length, neck + 1e-4); /* it leans to the neck */

        mus__leaf leaf;
        const mus__leaf_def leaf_def = {.length = neck, .fall = 0.045, .point = 0.07, .rise = -0.5 * rise};
        ck_assert_msg(mus__leaf_draft(context, &leaf_def, &leaf) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(mus__cubic_length(leaf.inner), neck, 1e-9);
        ck_assert_double_gt(mus__cubic_length(leaf.outer), neck); /* it rolls over the stand */

        mus__hood hood;
        const mus__hood_def hood_def = {.length = neck, .head = support_uniform(&state, 0.35, 0.65)};
        ck_assert_msg(mus__hood_draft(context, &hood_def, &hood) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(mus__cubic_length(hood.neck), neck, 1e-9);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_neck_too_short_is_refused)
{
    mus_context *context = support_context();
    mus__stand stand;
    mus__leaf leaf;
    mus__hood hood;
    ck_assert_int_eq(mus__stand_draft(context, &(mus__stand_def){0.01, 0.03, 0.03}, &stand), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "collar stand"));
    ck_assert_int_eq(mus__leaf_draft(context, &(mus__leaf_def){0.01, 0.04, 0.07, -0.03}, &leaf), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "collar leaf"));
    ck_assert_int_eq(mus__hood_draft(context, &(mus__hood_def){0.01, 0.5}, &hood), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "hood"));
    support_context_end(context);
}
END_TEST


Suite *mus_suite_block_collar(void)
{
    Suite *suite = suite_create("block_collar");
    TCase *tcase = tcase_create("block_collar");
    tcase_add_loop_test(tcase, collars_are_the_golden_numbers, 0, (int)(sizeof golden / sizeof golden[0]));
    tcase_add_test(tcase, neck_edges_are_as_long_as_the_neck);
    tcase_add_test(tcase, a_neck_too_short_is_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
