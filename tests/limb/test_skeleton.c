/*
 * test_skeleton.c: heights and joints from the tape. The golden fractions are means of ANSUR II and of the GarmentCode
 * bodies, which the skeleton does not use where the tape has a measure.
 */
#include "body/people.h"
#include "limb/skeleton.h"


static void skeleton_of(mus_context *context, const char *size, mus__skeleton *out)
{
    mus_tape *tape = people_size(context, size);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    mus__skeleton_make(tape, out);
    mus_tape_destroy(tape);
}


START_TEST(heights_descend_for_every_size)
{
    mus_context *context = support_context();
    for (int32_t i = 0; i < mus_tape_size_count(); i++) {
        mus__skeleton k;
        skeleton_of(context, mus_tape_size_name(i), &k);
        const double height[] = {k.crown,     k.brow,  k.jaw,      k.nape, k.neck_side, k.shoulder, k.armpit, k.bust,
                                 k.underbust, k.waist, k.high_hip, k.hip,  k.crotch,    k.knee,     k.ankle,  0.0};
        for (size_t j = 0; j + 1 < sizeof height / sizeof *height; j++)
            ck_assert_msg(height[j] - height[j + 1] > 0.006 * k.crown, "%s: height %zu %g, next %g",
                          mus_tape_size_name(i), j, height[j], height[j + 1]);
    }
    support_context_end(context);
}
END_TEST


START_TEST(adults_have_the_fractions_of_the_survey)
{
    mus_context *context = support_context();
    static const struct {
        const char *size;
        double nape, acromion, armpit, biacromial, arm;
    } row[] = {{"W40", 0.857, 0.820, 0.761, 0.224, 0.320}, {"M50", 0.864, 0.820, 0.757, 0.237, 0.324}};
    for (int i = 0; i < 2; i++) {
        mus__skeleton k;
        skeleton_of(context, row[i].size, &k);
        ck_assert_double_eq_tol(k.nape / k.crown, row[i].nape, 0.012);
        ck_assert_double_eq_tol(k.shoulder / k.crown, row[i].acromion, 0.012);
        ck_assert_double_eq_tol(k.armpit / k.crown, row[i].armpit, 0.012);
        ck_assert_double_eq_tol(2.0 * k.shoulder_x / k.crown, row[i].biacromial, 0.012);
        ck_assert_double_eq_tol(k.arm_length / k.crown, row[i].arm, 0.015);
    }
    support_context_end(context);
}
END_TEST


START_TEST(the_shoulder_line_is_the_tapes)
{
    mus_context *context = support_context();
    mus_tape *tape = people_size(context, "M50");
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_SHOULDER_SLOPE, 0.2, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_SHOULDER, 0.15, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    mus__skeleton k;
    mus__skeleton_make(tape, &k);
    ck_assert_double_eq_tol(k.neck_side - k.shoulder, 0.15 * sin(0.2), 1e-12);
    ck_assert_double_eq_tol(k.shoulder_x - k.neck_side_x, 0.15 * cos(0.2), 1e-12);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(sides_are_mirrored_and_arms_are_unit)
{
    mus_context *context = support_context();
    mus__skeleton k;
    skeleton_of(context, "C104", &k);
    ck_assert(k.joint[0][0] > 0.0 && k.joint[0][0] == -k.joint[1][0]);
    ck_assert(k.arm_axis[0][0] > 0.0 && k.arm_axis[0][0] == -k.arm_axis[1][0]);
    double length = 0.0;
    for (int i = 0; i < 3; i++) length += k.arm_axis[0][i] * k.arm_axis[0][i];
    ck_assert_double_eq_tol(length, 1.0, 1e-14);
    ck_assert(k.joint[0][1] == k.joint[1][1] && k.joint[0][1] < k.shoulder && k.joint[0][0] < k.shoulder_x);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_skeleton(void);
Suite *mus_suite_skeleton(void)
{
    Suite *suite = suite_create("skeleton");
    TCase *tests = tcase_create("skeleton");
    tcase_add_test(tests, heights_descend_for_every_size);
    tcase_add_test(tests, adults_have_the_fractions_of_the_survey);
    tcase_add_test(tests, the_shoulder_line_is_the_tapes);
    tcase_add_test(tests, sides_are_mirrored_and_arms_are_unit);
    suite_add_tcase(suite, tests);
    return suite;
}
