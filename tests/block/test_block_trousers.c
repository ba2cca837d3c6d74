/*
 * test_block_trousers.c: the trousers block against the golden numbers of an independent drafting script,
 * and its laws: equal seams, exact waists, equal dart legs, the same for legs that are cut above the hem.
 */
#include <string.h>

#include "block/drafts.h"
#include "block/block_trousers.h"

/* output of the script, lines "trousers:", cm; ease 2 on the waist, 4 on the hip, 1 on the rise */
static const struct {
    const char *size;
    double inseam, outseam, crotch_front, crotch_back, dart_front, dart_back, drop, side, thigh, knee, hem;
} golden[] = {
    {"W34", 78.30, 104.45, 27.72, 34.95, 2.95, 2.32, 0.58, 0.20, 61.5, 39.7, 35.7},
    {"W40", 76.62, 104.47, 29.81, 37.86, 2.70, 1.80, 0.74, 0.05, 68.0, 43.0, 39.0},
    {"W52", 72.67, 104.61, 34.83, 44.91, 1.95, 0.00, 1.22, -0.36, 83.6, 50.9, 46.9},
    {"M46", 78.88, 104.91, 27.97, 35.56, 1.57, 0.00, 0.61, 0.00, 64.8, 42.4, 38.4},
    {"M50", 81.38, 108.63, 29.43, 37.57, 1.45, 0.00, 0.70, -0.05, 69.3, 44.6, 40.6},
    {"M60", 83.02, 113.69, 33.51, 43.23, 0.89, 0.00, 1.00, -0.34, 82.0, 50.9, 46.9},
    {"C56", 13.77, 29.77, 16.50, 20.24, 0.00, 0.00, 0.38, 0.16, 30.6, 26.2, 22.5},
    {"C104", 41.38, 62.19, 21.74, 26.59, 0.00, 0.00, 0.33, 0.18, 41.0, 31.7, 27.7},
    {"C152", 69.08, 94.75, 27.20, 33.80, 1.76, 0.00, 0.46, 0.11, 56.3, 39.8, 35.8},
};


static mus__trousers_def trousers_of(const mus__measures *measures)
{
    const double *m = measures->v;
    const double knee = fmax(m[MUS_MEASURE_KNEE] + 6.0 * CM, m[MUS_MEASURE_CALF] + 4.0 * CM);
    mus__trousers_def def = {.waist = m[MUS_MEASURE_WAIST],
                             .hip = m[MUS_MEASURE_HIP],
                             .hip_ease = 4.0 * CM,
                             .net = {0.25 * (m[MUS_MEASURE_WAIST] + 2.0 * CM) - 0.5 * CM,
                                     0.25 * (m[MUS_MEASURE_WAIST] + 2.0 * CM) + 0.5 * CM},
                             .rise = m[MUS_MEASURE_RISE] + 1.0 * CM,
                             .inleg = m[MUS_MEASURE_INLEG] - 2.0 * CM,
                             .thigh = m[MUS_MEASURE_THIGH] + 3.0 * CM,
                             .end = 1.0,
                             .darts = true};
    mus__trousers_widths(&def, knee, fmax(knee - 4.0 * CM, 1.55 * m[MUS_MEASURE_ANKLE]));
    return def;
}


START_TEST(trousers_are_the_golden_numbers)
{
    mus_context *context = support_context();
    const char *size = golden[_i].size;
    const mus__measures measures = drafts_measures(context, size);
    const mus__trousers_def def = trousers_of(&measures);
    mus__trousers t;
    ck_assert_msg(mus__trousers_draft(context, &def, &t) == MUS_OK, "%s", mus_context_error(context));
    CK_GOLDEN(size, "front inseam", t.front.inseam_length, CM, golden[_i].inseam, GOLDEN);
    CK_GOLDEN(size, "back inseam", t.back.inseam_length, CM, golden[_i].inseam, GOLDEN);
    CK_GOLDEN(size, "front outseam", t.front.outseam_length, CM, golden[_i].outseam, GOLDEN);
    CK_GOLDEN(size, "back outseam", t.back.outseam_length, CM, golden[_i].outseam, GOLDEN);
    CK_GOLDEN(size, "front crotch", t.front.crotch_length, CM, golden[_i].crotch_front, GOLDEN);
    CK_GOLDEN(size, "back crotch", t.back.crotch_length, CM, golden[_i].crotch_back, GOLDEN);
    CK_GOLDEN(size, "front dart", t.front.dart_width, CM, golden[_i].dart_front, GOLDEN);
    CK_GOLDEN(size, "back dart", t.back.dart_width, CM, golden[_i].dart_back, GOLDEN);
    CK_GOLDEN(size, "fork drop", t.back.fork_drop, CM, golden[_i].drop, GOLDEN);
    CK_GOLDEN(size, "back side", t.back.side[1], CM, golden[_i].side, GOLDEN);
    CK_GOLDEN(size, "thigh", t.thigh, CM, golden[_i].thigh, 0.06);
    CK_GOLDEN(size, "knee", def.knee[0] + def.knee[1], CM, golden[_i].knee, 0.06);
    CK_GOLDEN(size, "hem", def.hem[0] + def.hem[1], CM, golden[_i].hem, 0.06);
    support_context_end(context);
}
END_TEST


/* every table size, full and cut, natural and low */
START_TEST(seams_waist_and_darts_agree)
{
    static const double ends[] = {1.0, 0.91, 0.68, 0.40, 0.16};
    mus_context *context = support_context();
    const mus__measures measures = drafts_measures(context, mus_tape_size_name(_i));
    for (int e = 0; e < 10; e++) {
        mus__trousers_def def = trousers_of(&measures);
        mus__trousers t;
        def.end = ends[e / 2];
        if (e % 2 == 1) {
            def.top = -0.3 * measures.v[MUS_MEASURE_WAIST_TO_HIP];
            def.net[0] += 0.3 * 0.25 * (def.hip - def.waist);
            def.net[1] += 0.3 * 0.25 * (def.hip - def.waist);
        }
        ck_assert_msg(mus__trousers_draft(context, &def, &t) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(t.front.inseam_length, t.back.inseam_length, 1e-9);
        ck_assert_double_eq_tol(t.front.outseam_length, t.back.outseam_length, 1e-9);
        ck_assert_double_eq_tol(t.back.waist_length, def.net[1], 1e-9);
        ck_assert_double_eq_tol(t.front.waist_length, def.net[0], t.front.ndart > 0 ? 1e-9 : 0.01 * CM);
        ck_assert_double_ge(t.thigh, def.thigh - 1e-12);
        const mus__trousers_half *halves[2] = {&t.front, &t.back};
        for (int h = 0; h < 2; h++) {
            const double *hem = halves[h]->hem;
            for (int32_t d = 0; d < halves[h]->ndart; d++) {
                const double *p = halves[h]->dart[d];
                ck_assert_double_eq_tol(hypot(p[0] - p[2], p[1] - p[3]), hypot(p[4] - p[2], p[5] - p[3]), 1e-12);
                ck_assert_double_lt(p[3], fmin(p[1], p[5]) - 1.0 * CM);
            }
            ck_assert_double_gt(hem[6], hem[0] + 5.0 * CM);
            ck_assert_double_lt(fabs(hem[7] - hem[1]), 0.25 * (hem[6] - hem[0]));
        }
    }
    support_context_end(context);
}
END_TEST


/* every table size, natural and low: the seam of a yoke is as long on both sides, its side is what the leg lacks, its
 * waist is that of the back; the front has no dart, and its outseam is still that of the back */
START_TEST(a_yoke_is_the_back_with_its_darts_closed)
{
    mus_context *context = support_context();
    const mus__measures measures = drafts_measures(context, mus_tape_size_name(_i));
    for (int low = 0; low < 2; low++) {
        mus__trousers_def def = trousers_of(&measures);
        mus__trousers t;
        def.yoke = true;
        if (low == 1) def.top = -0.3 * measures.v[MUS_MEASURE_WAIST_TO_HIP];
        for (int i = 0; low == 1 && i < 2; i++) def.net[i] += 0.3 * 0.25 * (def.hip - def.waist);
        ck_assert_msg(mus__trousers_draft(context, &def, &t) == MUS_OK, "%s", mus_context_error(context));
        const mus__trousers_yoke *yoke = &t.back.yoke;
        ck_assert_int_eq(t.front.ndart + t.back.ndart, 0);
        ck_assert(yoke->cut && !t.front.yoke.cut);
        ck_assert_double_eq_tol(t.front.outseam_length, t.back.outseam_length, 1e-9);
        ck_assert_double_eq_tol(mus__cubic_length(yoke->waist), def.net[1], 1e-9);
        ck_assert_double_eq_tol(mus__cubic_length(yoke->seam),
                                hypot(yoke->top[2] - yoke->top[0], yoke->top[3] - yoke->top[1]), 1e-9);

        /* its corners meet, and the seam's ends are those of centre and side */
        const double *side = yoke->side.xy, *foot = yoke->side.xy + 2 * (yoke->side.nxy - 1);
        for (int i = 0; i < 2; i++) {
            ck_assert_double_eq_tol(yoke->waist[i], yoke->centre[i], 1e-9);
            ck_assert_double_eq_tol(yoke->waist[6 + i], side[i], 1e-9);
            ck_assert_double_eq_tol(yoke->seam[i], yoke->centre[2 + i], 1e-9);
            ck_assert_double_eq_tol(yoke->seam[6 + i], foot[i], 1e-9);
        }
        if (t.back.dart_width > 0.0) ck_assert_double_gt(mus__cubic_length(yoke->seam), def.net[1]);
    }
    support_context_end(context);
}
END_TEST


START_TEST(trousers_that_cannot_be_are_refused)
{
    mus_context *context = support_context();
    const mus__measures measures = drafts_measures(context, "W40");
    mus__trousers t;
    mus__trousers_def def = trousers_of(&measures);
    def.rise = 5.0 * CM;
    ck_assert_int_eq(mus__trousers_draft(context, &def, &t), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "rise"));
    def = trousers_of(&measures);
    def.inleg = 1.0 * CM;
    ck_assert_int_eq(mus__trousers_draft(context, &def, &t), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "inleg"));
    support_context_end(context);
}
END_TEST


START_TEST(a_large_thigh_widens_the_fork)
{
    mus_context *context = support_context();
    const mus__measures measures = drafts_measures(context, "W40");
    mus__trousers t, wider;
    mus__trousers_def def = trousers_of(&measures);
    ck_assert_int_eq(mus__trousers_draft(context, &def, &t), MUS_OK);
    def.thigh = t.thigh + 3.0 * CM;
    ck_assert_int_eq(mus__trousers_draft(context, &def, &wider), MUS_OK);
    ck_assert_double_eq_tol(wider.thigh, t.thigh + 3.0 * CM, 1e-12);
    ck_assert_double_eq_tol(wider.front.fork - t.front.fork, 0.9 * CM, 1e-12);
    ck_assert_double_eq_tol(wider.back.fork - t.back.fork, 2.1 * CM, 1e-12);
    ck_assert_double_eq_tol(wider.front.inseam_length, wider.back.inseam_length, 1e-9);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_block_trousers(void)
{
    Suite *suite = suite_create("block_trousers");
    TCase *tcase = tcase_create("block_trousers");
    tcase_add_loop_test(tcase, trousers_are_the_golden_numbers, 0, (int)(sizeof golden / sizeof golden[0]));
    tcase_add_loop_test(tcase, seams_waist_and_darts_agree, 0, 28);
    tcase_add_loop_test(tcase, a_yoke_is_the_back_with_its_darts_closed, 0, 28);
    tcase_add_test(tcase, trousers_that_cannot_be_are_refused);
    tcase_add_test(tcase, a_large_thigh_widens_the_fork);
    suite_add_tcase(suite, tcase);
    return suite;
}
