/*
 * test_block_bodice.c: the bodice block against the golden numbers of an independent drafting script, and its laws:
 * girths on the bust line, the waist and the neck, side seams that match, darts with equal legs.
 */
#include <string.h>

#include "block/drafts.h"

/* output of the script, lines "bodice:"; cm, degrees, cm2 */
static const struct {
    const char *size;
    double underarm, arm_front, arm_back, neck_front, neck_depth, neck_back, side, shoulder, front_waist, theta, drop;
    double dart;
    int32_t back_darts;
    double waist_front, waist_back, area_front, area_back;
} golden[] = {
    {"W34", 21.64, 20.92, 19.26, 10.44, 7.31, 7.35, 21.69, 11.90, 46.26, 12.00, 2.98, 2.92, 1, 17.50, 16.50, 774, 755},
    {"W40", 20.80, 22.88, 21.61, 10.98, 7.73, 7.66, 20.86, 12.38, 47.18, 12.00, 3.36, 2.92, 1, 20.50, 19.50, 878, 846},
    {"W52", 18.7, 29.88, 28.54, 12.32, 8.79, 8.42, 18.76, 13.58, 49.54, 12.00, 4.31, 2.92, 1, 28.00, 27.00, 1104, 1051},
    {"M46", 20.32, 24.39, 23.01, 11.98, 8.53, 8.23, 20.32, 14.86, 45.34, 0.00, 0.00, 0.00, 0, 26.50, 25.50, 947, 987},
    {"M50", 21.28, 25.79, 24.35, 12.60, 9.01, 8.58, 21.28, 15.41, 47.22, 0.00, 0.00, 0.00, 0, 28.50, 27.50, 1050, 1095},
    {"M60", 21.91, 29.44, 27.89, 14.05, 10.16, 9.4, 21.91, 16.32, 50.15, 0.00, 0.00, 0.00, 0, 33.50, 32.50, 1269, 1327},
    {"C56", 2.88, 13.41, 12.37, 6.56, 4.20, 5.15, 2.88, 5.48, 15.93, 0.00, 0.00, 0.00, 0, 12.72, 11.72, 137, 150},
    {"C104", 9.18, 16.88, 15.99, 8.26, 5.56, 6.12, 9.18, 8.56, 25.99, 0.00, 0.00, 0.00, 0, 16.74, 15.74, 328, 342},
    {"C152", 15.15, 22.28, 21.32, 9.95, 6.90, 7.08, 15.15, 11.63, 37.38, 0.00, 0.00, 0.00, 0, 22.64, 21.64, 650, 674},
};

#define GOLDENS ((int)(sizeof golden / sizeof golden[0]))


START_TEST(lengths_are_the_golden_numbers)
{
    mus_context *context = support_context();
    const char *size = golden[_i].size;
    const mus__bodice bodice = drafts_bodice(context, size);
    const mus__bodice_half *front = &bodice.front, *back = &bodice.back;
    const struct {
        const char *name;
        double value, expected;
    } list[] = {
        {"underarm", bodice.underarm, golden[_i].underarm},
        {"front armhole", front->arm_length, golden[_i].arm_front},
        {"back armhole", back->arm_length, golden[_i].arm_back},
        {"front neck", front->neck_length, golden[_i].neck_front},
        {"neck depth", bodice.neck_depth, golden[_i].neck_depth},
        {"back neck", back->neck_length, golden[_i].neck_back},
        {"front side", front->side_length, golden[_i].side},
        {"back side", back->side_length, golden[_i].side},
        {"front shoulder", front->shoulder_length, golden[_i].shoulder},
        {"back shoulder", back->shoulder_length, golden[_i].shoulder},
        {"front waist length", bodice.front_waist, golden[_i].front_waist},
        {"bust dart drop", bodice.dart_drop, golden[_i].drop},
        {"waist dart", bodice.dart_width, golden[_i].dart},
        {"front waist", front->waist_length, golden[_i].waist_front},
        {"back waist", back->waist_length, golden[_i].waist_back},
    };
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++)
        CK_GOLDEN(size, list[i].name, list[i].value, CM, list[i].expected, GOLDEN);
    CK_GOLDEN(size, "bust dart angle", front->theta, MUS__DEGREE, golden[_i].theta, 0.05);
    ck_assert_int_eq(back->ndart, golden[_i].back_darts);
    ck_assert_int_eq(front->ndart, golden[_i].dart > 0.0 ? 1 : 0);
    support_context_end(context);
}
END_TEST


START_TEST(panels_have_the_golden_areas)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "bodice", golden[_i].size);
    static const char *const panels[2][2] = {{"front_left", "front_right"}, {"back_left", "back_right"}};
    for (int part = 0; part < 2; part++)
        for (int side = 0; side < 2; side++)
            CK_GOLDEN(golden[_i].size, panels[part][side],
                      mus_pattern_panel_area(pattern, mus_pattern_find_panel(pattern, panels[part][side])), CM * CM,
                      part == 0 ? golden[_i].area_front : golden[_i].area_back, 1.0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a draft with neck_ease a, bust ease b and waist ease w: waist F + B = (W + w)/2 when darted, else no dart at all;
 * bust line F + B = (B + b)/2; front neck + back neck = (neck + a)/2; sides, shoulders and dart legs alike */
START_TEST(girths_are_the_tape_and_ease)
{
    mus_context *context = support_context();
    const char *size = mus_tape_size_name(_i);
    const mus__measures measures = drafts_measures(context, size);
    const double *m = measures.v;
    mus__bodice_def def;
    mus__bodice bodice;
    mus__bodice_def_init(&def, &measures);
    for (int darts = 0; darts < 2; darts++) {
        def.darts = darts == 1;
        if (darts && measures.sex != MUS_SEX_FEMALE) continue;
        ck_assert_int_eq(mus__bodice_draft(context, &measures, &def, &bodice), MUS_OK);
        const mus__bodice_half *front = &bodice.front, *back = &bodice.back;
        const double bust = (m[MUS_MEASURE_BUST] + def.bust_ease) / 2.0;
        const double waist = darts ? (m[MUS_MEASURE_WAIST] + def.waist_ease) / 2.0 : bust;
        ck_assert_double_eq_tol(front->waist_length + back->waist_length, waist, 1e-9);
        ck_assert_double_eq_tol(2.0 * (front->neck_length + back->neck_length), m[MUS_MEASURE_NECK] + def.neck_ease,
                                1e-9);
        ck_assert_double_eq_tol(front->side_length, back->side_length, 1e-12);
        ck_assert_double_eq_tol(front->shoulder_length, m[MUS_MEASURE_SHOULDER], 1e-12);
        ck_assert_double_eq_tol(back->shoulder_length, m[MUS_MEASURE_SHOULDER], 1e-12);

        /* the underarm of the front with its bust dart closed lies as far out as bust and back say */
        const double c = cos(front->theta), s = sin(front->theta);
        const double dx = front->under[0] - front->bust[0], dy = front->under[1] - front->bust[1];
        ck_assert_double_eq_tol(front->bust[0] + c * dx + s * dy + back->under[0], bust, 1e-9);
        ck_assert_double_eq_tol(front->bust[1] - s * dx + c * dy, bodice.underarm, 1e-9);
    }
    support_context_end(context);
}
END_TEST


static double dart_leg_difference(const double *mouth, const double *point, const double *other)
{
    return fabs(hypot(mouth[0] - point[0], mouth[1] - point[1]) - hypot(other[0] - point[0], other[1] - point[1]));
}


START_TEST(dart_legs_are_equal)
{
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, mus_tape_size_name(_i));
    const mus__bodice_half *halves[2] = {&bodice.front, &bodice.back};
    for (int h = 0; h < 2; h++)
        for (int32_t d = 0; d < halves[h]->ndart; d++) {
            const double *dart = halves[h]->dart[d];
            ck_assert_double_le(dart_leg_difference(dart, dart + 2, dart + 4), 1e-12);
        }
    if (bodice.front.theta > 0.0)
        ck_assert_double_le(dart_leg_difference(bodice.front.mouth, bodice.front.apex, bodice.front.mouth + 2), 1e-12);
    support_context_end(context);
}
END_TEST


/* both cubics of an armhole meet upright at the pitch; neck and shoulder, shoulder and armhole stand square in the
 * drafts of the back, and of the front, so the sewn edges run on without a corner */
START_TEST(armholes_and_necks_meet_the_shoulder_square)
{
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, mus_tape_size_name(_i));
    const mus__bodice_half *halves[2] = {&bodice.front, &bodice.back};
    for (int h = 0; h < 2; h++) {
        const mus__bodice_half *half = halves[h];
        const double along[2] = {half->tip[0] - half->snp[0], half->tip[1] - half->snp[1]};
        const double *neck = half->neck, *high = half->arm_high, *low = half->arm_low;
        ck_assert_double_le(fabs(along[0] * (neck[6] - neck[4]) + along[1] * (neck[7] - neck[5])), 1e-12);
        ck_assert_double_le(fabs(along[0] * (high[2] - high[0]) + along[1] * (high[3] - high[1])), 1e-12);
        ck_assert_double_eq_tol(high[4], high[6], 1e-15);
        ck_assert_double_eq_tol(low[2], low[0], 1e-15);
        ck_assert_double_eq_tol(neck[3], neck[1], 1e-15);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_measured_front_waist_sets_the_bust_dart)
{
    mus_context *context = support_context();
    mus__measures measures = drafts_measures(context, "W40");
    mus__bodice_def def;
    mus__bodice bodice;
    mus__bodice_def_init(&def, &measures);
    ck_assert_int_eq(mus__bodice_draft(context, &measures, &def, &bodice), MUS_OK);
    const double drop = bodice.dart_drop, front_waist = bodice.front_waist;

    /* the front waist length of a draft, given as a measure, gives the same draft; 1 cm more opens the dart by 1 cm */
    measures.front_waist_given = true;
    measures.v[MUS_MEASURE_FRONT_WAIST] = front_waist;
    ck_assert_int_eq(mus__bodice_draft(context, &measures, &def, &bodice), MUS_OK);
    ck_assert_double_eq_tol(bodice.dart_drop, drop, 1e-12);
    measures.v[MUS_MEASURE_FRONT_WAIST] = front_waist + 1.0 * CM;
    ck_assert_int_eq(mus__bodice_draft(context, &measures, &def, &bodice), MUS_OK);
    ck_assert_double_eq_tol(bodice.dart_drop, drop + 1.0 * CM, 1e-12);
    ck_assert_double_eq_tol(bodice.front.side_length, bodice.back.side_length, 1e-12);
    support_context_end(context);
}
END_TEST


START_TEST(a_lowered_neck_moves_along_the_shoulder)
{
    mus_context *context = support_context();
    mus__bodice bodice = drafts_bodice(context, "M50");
    mus__bodice_half before = bodice.front, *half = &bodice.front;
    mus__bodice_lower_neck(half, 1.5 * CM, 2.0 * CM);
    ck_assert_double_eq_tol(half->shoulder_length, before.shoulder_length - 1.5 * CM, 1e-12);
    ck_assert_double_eq_tol(half->centre[1], before.centre[1] - 2.0 * CM, 1e-12);
    ck_assert_double_gt(half->neck_length, before.neck_length);
    ck_assert_double_eq(half->tip[0], before.tip[0]);
    support_context_end(context);
}
END_TEST


/* a bodice that cannot be drafted is refused with the names of the measures */
START_TEST(impossible_measures_are_refused_by_name)
{
    static const struct {
        int32_t measure;
        double value;
        const char *names[2];
    } list[] = {
        {MUS_MEASURE_SCYE_DEPTH, 0.45, {"scye_depth", "back_waist"}},
        {MUS_MEASURE_SCYE_DEPTH, 0.02, {"scye_depth", "across_back"}},
        {MUS_MEASURE_BUST_SPAN, 0.50, {"bust_span", "bust"}},
        {MUS_MEASURE_BUST_DEPTH, 0.005, {"bust_span", "bust_depth"}},
        {MUS_MEASURE_WAIST, 0.10, {"bust", "waist"}},
    };
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        mus_context *context = support_context();
        mus__measures measures = drafts_measures(context, "W40");
        mus__bodice_def def;
        mus__bodice bodice;
        mus__bodice_def_init(&def, &measures);
        measures.v[list[i].measure] = list[i].value;
        ck_assert_int_eq(mus__bodice_draft(context, &measures, &def, &bodice), MUS_ERR_DESIGN);
        for (int n = 0; n < 2; n++)
            ck_assert_msg(strstr(mus_context_error(context), list[i].names[n]) != NULL, "case %zu: %s", i,
                          mus_context_error(context));
        support_context_end(context);
    }
}
END_TEST


Suite *mus_suite_block_bodice(void)
{
    Suite *suite = suite_create("block_bodice");
    TCase *tcase = tcase_create("block_bodice");
    tcase_add_loop_test(tcase, lengths_are_the_golden_numbers, 0, GOLDENS);
    tcase_add_loop_test(tcase, panels_have_the_golden_areas, 0, GOLDENS);
    tcase_add_loop_test(tcase, girths_are_the_tape_and_ease, 0, 28);
    tcase_add_loop_test(tcase, dart_legs_are_equal, 0, 28);
    tcase_add_loop_test(tcase, armholes_and_necks_meet_the_shoulder_square, 0, 28);
    tcase_add_test(tcase, a_measured_front_waist_sets_the_bust_dart);
    tcase_add_test(tcase, a_lowered_neck_moves_along_the_shoulder);
    tcase_add_test(tcase, impossible_measures_are_refused_by_name);
    suite_add_tcase(suite, tcase);
    return suite;
}
