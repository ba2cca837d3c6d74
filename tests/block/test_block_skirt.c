/*
 * test_block_skirt.c: the straight skirt against the golden numbers of an independent drafting script, and
 * its laws: waist and hip girths, sides that match, darts with equal legs, a hem square to the side.
 */
#include <string.h>

#include "block/drafts.h"

/* output of the script, lines "skirt:", cm; ease 2 on the waist and 4 on the hip, length the larger of 0.36 stature and
 * waist_to_hip + 5 */
static const struct {
    const char *size;
    double side, dart_front, dart_back;
    int32_t ndart_front, ndart_back;
    double hip_front, hip_back;
} golden[] = {
    {"W34", 61.98, 3.85, 3.85, 2, 2, 24.00, 23.00},  {"W40", 61.94, 3.57, 3.57, 2, 2, 26.50, 25.50},
    {"W52", 61.83, 2.75, 2.75, 1, 1, 32.50, 31.50},  {"M46", 62.87, 2.34, 2.34, 1, 1, 25.25, 24.25},
    {"M50", 65.02, 2.20, 2.20, 1, 1, 27.00, 26.00},  {"M60", 67.85, 1.58, 1.58, 1, 1, 31.88, 30.88},
    {"C56", 21.41, 0.00, 0.00, 0, 0, 12.12, 11.12},  {"C104", 38.68, 1.03, 1.03, 1, 1, 16.12, 15.12},
    {"C152", 56.08, 2.54, 2.54, 1, 1, 22.00, 21.00},
};


static mus__skirt_def skirt_of(const mus__measures *measures)
{
    const double *m = measures->v;
    const mus__skirt_def def = {.waist = m[MUS_MEASURE_WAIST],
                                .hip = m[MUS_MEASURE_HIP],
                                .depth = m[MUS_MEASURE_WAIST_TO_HIP],
                                .waist_ease = 2.0 * CM,
                                .hip_ease = 4.0 * CM,
                                .length = fmax(0.36 * m[MUS_MEASURE_STATURE], m[MUS_MEASURE_WAIST_TO_HIP] + 5.0 * CM),
                                .rise = 1.2 * CM,
                                .darts = true};
    return def;
}


START_TEST(skirts_are_the_golden_numbers)
{
    mus_context *context = support_context();
    const char *size = golden[_i].size;
    const mus__measures measures = drafts_measures(context, size);
    const mus__skirt_def def = skirt_of(&measures);
    mus__skirt skirt;
    ck_assert_int_eq(mus__skirt_draft(context, &def, &skirt), MUS_OK);
    CK_GOLDEN(size, "front side", skirt.front.side_length, CM, golden[_i].side, GOLDEN);
    CK_GOLDEN(size, "back side", skirt.back.side_length, CM, golden[_i].side, GOLDEN);
    CK_GOLDEN(size, "front darts", skirt.front.dart_width, CM, golden[_i].dart_front, GOLDEN);
    CK_GOLDEN(size, "back darts", skirt.back.dart_width, CM, golden[_i].dart_back, GOLDEN);
    CK_GOLDEN(size, "front hip", skirt.front.hip, CM, golden[_i].hip_front, GOLDEN);
    CK_GOLDEN(size, "back hip", skirt.back.hip, CM, golden[_i].hip_back, GOLDEN);
    ck_assert_int_eq(skirt.front.ndart, golden[_i].ndart_front);
    ck_assert_int_eq(skirt.back.ndart, golden[_i].ndart_back);
    support_context_end(context);
}
END_TEST


START_TEST(waist_hip_sides_and_darts_agree)
{
    mus_context *context = support_context();
    const mus__measures measures = drafts_measures(context, mus_tape_size_name(_i));
    mus__skirt_def def = skirt_of(&measures);
    mus__skirt skirt;
    for (int darts = 0; darts < 2; darts++) {
        def.darts = darts == 1;
        def.flare = darts == 1 ? 0.0 : 6.0 * CM;
        ck_assert_int_eq(mus__skirt_draft(context, &def, &skirt), MUS_OK);
        const double hip = fmax(def.hip, 0.98 * def.waist) + def.hip_ease;
        ck_assert_double_eq_tol(2.0 * (skirt.front.waist_length + skirt.back.waist_length), def.waist + def.waist_ease,
                                1e-9);
        ck_assert_double_eq_tol(2.0 * (skirt.front.hip + skirt.back.hip), hip, 1e-9);
        ck_assert_double_le(fabs(skirt.front.side_length - skirt.back.side_length), 0.02 * CM);
        const mus__skirt_half *halves[2] = {&skirt.front, &skirt.back};
        for (int h = 0; h < 2; h++) {
            for (int32_t d = 0; d < halves[h]->ndart; d++) {
                const double *p = halves[h]->dart[d];
                ck_assert_double_eq_tol(hypot(p[0] - p[2], p[1] - p[3]), hypot(p[4] - p[2], p[5] - p[3]), 1e-12);
                ck_assert_double_gt(fmin(p[1], p[5]), p[3] + 2.0 * CM * fmin(1.0, def.depth / 0.1));
            }

            /* the hem meets side and centre square, so the sewn hem runs on without a corner */
            const double *side = halves[h]->side_low, *hem = halves[h]->hem;
            ck_assert_double_le(fabs((side[6] - side[4]) * (hem[6] - hem[4]) + (side[7] - side[5]) * (hem[7] - hem[5])),
                                1e-12);
            ck_assert_double_eq_tol(hem[3], hem[1], 1e-15);
        }
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_skirt_that_cannot_be_is_refused)
{
    mus_context *context = support_context();
    const mus__measures measures = drafts_measures(context, "W40");
    mus__skirt skirt;
    mus__skirt_def def = skirt_of(&measures);
    def.length = def.depth + 1.0 * CM;
    ck_assert_int_eq(mus__skirt_draft(context, &def, &skirt), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "waist_to_hip"));
    def = skirt_of(&measures);
    def.hip_ease = -0.95;
    ck_assert_int_eq(mus__skirt_draft(context, &def, &skirt), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "ease"));
    support_context_end(context);
}
END_TEST


Suite *mus_suite_block_skirt(void)
{
    Suite *suite = suite_create("block_skirt");
    TCase *tcase = tcase_create("block_skirt");
    tcase_add_loop_test(tcase, skirts_are_the_golden_numbers, 0, (int)(sizeof golden / sizeof golden[0]));
    tcase_add_loop_test(tcase, waist_hip_sides_and_darts_agree, 0, 28);
    tcase_add_test(tcase, a_skirt_that_cannot_be_is_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
