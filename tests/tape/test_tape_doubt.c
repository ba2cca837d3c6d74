/*
 * test_tape_doubt.c: the prediction of a measure is the exact regression of the table on the other given measures;
 * slips are named; tapes of charts, of pregnant women and of large people give no warning; the survey's figures hold.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/slips/slips.h"
#include "support.h"
#include "tape/tape_internal.h"
#include "tape/tape_people.h"

#define FAR 4.5 /* the bound of tape_doubt.c for a value that no slip explains [standard deviations] */


static mus_tape *tape_of(mus_context *context, int32_t sex, double stature, double bust, double waist, double hip)
{
    const double cm[] = {stature, bust, waist, hip};
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_sex(tape, sex), MUS_OK);
    for (int32_t m = 0; m < 4; m++)
        if (cm[m] > 0) ck_assert_int_eq(mus_tape_set(tape, m, 0.01 * cm[m], MUS_SOURCE_GIVEN), MUS_OK);
    return tape;
}


/* solve a x = b by elimination with pivots; n at most MUS__PEOPLE_MEASURES */
static void solve(int n, double (*a)[MUS__PEOPLE_MEASURES], double *b)
{
    for (int k = 0; k < n; k++) {
        int p = k;
        for (int i = k; i < n; i++)
            if (fabs(a[i][k]) > fabs(a[p][k])) p = i;
        for (int j = 0; j < n; j++) {
            const double swap = a[k][j];
            a[k][j] = a[p][j], a[p][j] = swap;
        }
        const double swap = b[k];
        b[k] = b[p], b[p] = swap;
        for (int i = 0; i < n; i++) {
            const double f = i == k ? 0.0 : a[i][k] / a[k][k];
            for (int j = 0; j < n; j++) a[i][j] -= f * a[k][j];
            b[i] -= f * b[k];
        }
    }
    for (int k = 0; k < n; k++) b[k] /= a[k][k];
}


static double covariance(const struct mus__people *people, int i, int j)
{
    const int high = i > j ? i : j, low = i > j ? j : i;
    const double correlation = i == j ? 1.0 : 0.001 * people->correlation[high * (high - 1) / 2 + low];
    return 1e-4 * correlation * people->deviation[i] * people->deviation[j];
}


/* regression of row `of` on the n rows `on` with residuals r: the predicted residual, and its standard deviation */
static double regress(const struct mus__people *people, int of, int n, const int *on, const double *r,
                      double *deviation)
{
    double a[MUS__PEOPLE_MEASURES][MUS__PEOPLE_MEASURES], weight[MUS__PEOPLE_MEASURES], predicted = 0.0;
    *deviation = covariance(people, of, of);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) a[i][j] = covariance(people, on[i], on[j]);
        weight[i] = covariance(people, of, on[i]);
    }
    solve(n, a, weight);
    for (int i = 0; i < n; i++) {
        predicted += weight[i] * r[i];
        *deviation -= weight[i] * covariance(people, of, on[i]);
    }
    *deviation = sqrt(*deviation);
    return predicted;
}


START_TEST(a_prediction_is_the_regression_on_the_others)
{
    mus_context *context = support_context();
    uint64_t seed = 3;
    int doubted = 0;
    for (int trial = 0; trial < 400; trial++) {
        const int sex = trial % 2;
        const struct mus__people *people = &mus__people[sex];
        mus_tape *tape;
        int on[MUS__PEOPLE_MEASURES], n = 0;
        double r[MUS__PEOPLE_MEASURES], deviation;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        mus_tape_set_sex(tape, sex ? MUS_SEX_MALE : MUS_SEX_FEMALE);
        const int of = (int)(support_random(&seed) % MUS__PEOPLE_MEASURES);
        for (int i = 0; i < MUS__PEOPLE_MEASURES; i++) {
            if (i == of || (i > 5 && support_random(&seed) % 2)) continue;
            on[n] = i;
            r[n] = 0.3 * support_uniform(&seed, -1, 1) * 0.01 * people->deviation[i];
            mus_tape_set(tape, mus__people_measure[i], 0.01 * people->mean[i] * exp(r[n]), MUS_SOURCE_GIVEN);
            n++;
        }

        /* just within and just beyond the bound, at values that no ruler shows, so that no digits are swapped */
        const double predicted = regress(people, of, n, on, r, &deviation);
        for (int beyond = 0; beyond < 2; beyond++) {
            const double z = (beyond ? 1.0001 : 0.9999) * FAR * (support_random(&seed) % 2 ? 1 : -1);
            const double value = 0.01 * people->mean[of] * exp(predicted + z * deviation);
            mus__doubt doubts[MUS_MEASURE_COUNT + 1];
            mus_tape_set(tape, mus__people_measure[of], value, MUS_SOURCE_GIVEN);
            const int32_t count = mus__tape_doubts(tape, doubts);
            if (count == 0 || doubts[0].measure != mus__people_measure[of]) {
                /* another measure may gain more by a slip that explains it: stature and nape height go together */
                ck_assert(!beyond || count > 0 || mus__people_measure[of] == MUS_MEASURE_WAIST);
                continue;
            }
            ck_assert_msg(beyond || doubts[0].cause != NULL, "%d doubted within", of);
            ck_assert_double_eq_tol(log(100 * doubts[0].expected / people->mean[of]), predicted, 1e-9);
            doubted++;
        }
        mus_tape_destroy(tape);
    }
    ck_assert_int_gt(doubted, 250);
    support_context_end(context);
}
END_TEST


/* the only warning of a tape, or "" */
static const char *said(mus_context *context, mus_tape *tape)
{
    ck_assert_msg(mus_tape_complete(tape) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_le(mus_tape_warning_count(tape), 1);
    return mus_tape_warning_count(tape) ? mus_tape_warning(tape, 0) : "";
}


START_TEST(a_slip_is_named_with_its_value)
{
    static const struct {
        int32_t sex;
        double cm[4];
        const char *start, *end;
    } row[] = {
        {MUS_SEX_FEMALE, {165, 69, 78, 104}, "bust of 69.0 cm does not fit", "digits swapped: 96.0 cm?"},
        {MUS_SEX_FEMALE, {165, 96, 78, 140}, "hip of 140.0 cm does not fit", "digits swapped: 104.0 cm?"},
        {MUS_SEX_FEMALE, {165, 96, 78, 80}, "hip of 80.0 cm does not fit", "which predict 102.5 cm"},
        {MUS_SEX_UNSET, {165, 69, 78, 104}, "bust of 69.0 cm", "96.0 cm?"},
        {MUS_SEX_FEMALE, {165, 37.8, 78, 104}, "bust of 37.8 cm", "inches taken for cm: 96.0 cm?"},
        {MUS_SEX_FEMALE, {165, 96, 78, 52}, "hip of 52.0 cm", "half the girth: 104.0 cm?"},
        {MUS_SEX_FEMALE,
         {65 * 2.54, 38 * 2.54, 13 * 2.54, 41 * 2.54},
         "waist of 33.0 cm",
         "digits of the inches swapped: 78.7 cm?"},
        {MUS_SEX_CHILD, {116, 60.5, 55, 36}, "hip of 36.0 cm", "digits swapped: 63.0 cm?"},
        {MUS_SEX_FEMALE, {68, 92, 76, 100}, "stature of 68.0 cm", "the first digit lost: 168.0 cm?"},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const double *cm = row[i].cm;
        mus_tape *tape = tape_of(context, row[i].sex, cm[0], cm[1], cm[2], cm[3]);
        const bool whole = mus_tape_complete(tape) == MUS_OK;
        const char *text = whole ? said(context, tape) : strchr(mus_context_error(context), '(') + 1;
        ck_assert_msg(strncmp(text, row[i].start, strlen(row[i].start)) == 0 && strstr(text, row[i].end) != NULL, "%s",
                      text);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(slips_in_one_tape_are_all_named)
{
    mus_context *context = support_context();
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_THIGH, 0.26, MUS_SOURCE_GIVEN), MUS_OK);    /* 62 */
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_NECK, 0.53, MUS_SOURCE_GIVEN), MUS_OK);     /* 35 */
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_SHOULDER, 0.21, MUS_SOURCE_GIVEN), MUS_OK); /* 12 */
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    const char *const names[] = {"thigh of 26.0 cm", "neck of 53.0", "shoulder of 21.0 cm"};
    for (int k = 0; k < 3; k++) {
        int found = 0;
        for (int32_t i = 0; i < mus_tape_warning_count(tape); i++)
            found += strstr(mus_tape_warning(tape, i), names[k]) != NULL &&
                     strstr(mus_tape_warning(tape, i), "digits swapped") != NULL;
        ck_assert_msg(found == 1, "%s", names[k]);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(charts_have_no_warning)
{
    mus_context *context = support_context();
    for (int32_t i = 0; i < 2 * mus_tape_size_count(); i++) {
        mus_tape *tape;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_size(tape, mus_tape_size_name(i / 2)), MUS_OK);
        if (i % 2 && mus_tape_sex(tape) != MUS_SEX_CHILD) mus_tape_set_sex(tape, MUS_SEX_UNSET);

        /* the four measures of the size, then the whole row of its chart, as if it had been measured */
        for (int whole = 0; whole < 2; whole++) {
            ck_assert_msg(said(context, tape)[0] == '\0', "%s: %s", mus_tape_name(tape), said(context, tape));
            for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++)
                if (m != MUS_MEASURE_FRONT_WAIST)
                    ck_assert_int_eq(mus_tape_set(tape, m, mus_tape_value(tape, m), MUS_SOURCE_GIVEN), MUS_OK);
        }
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(people_whom_the_survey_lacks_have_no_warning)
{
    static const struct {
        const char *who;
        int32_t sex;
        double cm[4];
    } row[] = {
        {"pregnant", MUS_SEX_FEMALE, {165, 98, 108, 102}},
        {"pregnant, small", MUS_SEX_FEMALE, {160, 100, 112, 104}},
        {"pregnant, tall", MUS_SEX_FEMALE, {170, 95, 104, 100}},
        {"pregnant, twins", MUS_SEX_FEMALE, {168, 104, 122, 108}},
        {"pregnant, no sex given", MUS_SEX_UNSET, {170, 95, 104, 100}},
        {"woman of 200 kg", MUS_SEX_FEMALE, {165, 150, 150, 160}},
        {"man of 200 kg", MUS_SEX_MALE, {180, 155, 165, 150}},
        {"thin woman", MUS_SEX_FEMALE, {175, 76, 58, 84}},
        {"thin man", MUS_SEX_MALE, {180, 82, 68, 84}},
        {"tall man", MUS_SEX_MALE, {205, 105, 90, 105}},
        {"short woman", MUS_SEX_FEMALE, {142, 84, 68, 90}},
        {"heavy child", MUS_SEX_CHILD, {140, 90, 92, 95}},
        {"stature alone", MUS_SEX_CHILD, {140, 0, 0, 0}},
        {"stature and a girth", MUS_SEX_CHILD, {140, 0, 0, 110}},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const double *cm = row[i].cm;
        mus_tape *tape = tape_of(context, row[i].sex, cm[0], cm[1], cm[2], cm[3]);
        ck_assert_msg(said(context, tape)[0] == '\0', "%s: %s", row[i].who, said(context, tape));
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


/* rows of the half that the table was made of (0) and of the other half (1) */
START_TEST(slips_of_the_survey_are_named_and_true_tapes_are_not_warned_of)
{
    char path[512], written[512];
    ansur table;
    if (support_data("anthropometry/ansur2_garment_cm.csv", path, sizeof path) == NULL) return;
    ck_assert(ansur_open(&table, path));
    mus_context *context = support_context();
    for (int half = 0; half < 2; half++) {
        slips_count count = {0};
        slips_tally(context, &table, half, false, &count);
        ck_assert_int_gt(count.slips, 10000);
        ck_assert_msg((double)count.named >= SLIPS_NAMED_LEAST * (double)count.slips, "%ld of %ld named", count.named,
                      count.slips);
        ck_assert_msg((double)count.falsely < SLIPS_FALSE_MOST * (double)count.people, "%ld of %ld falsely warned of",
                      count.falsely, count.people);
    }

    /* the table in the source is the one that the survey gives */
    ck_assert(slips_write_table(&table, support_scratch("people.h", written, sizeof written)));
    char *source = support_slurp("lib/tape/tape_people.h", NULL), *made = support_slurp(written, NULL);
    if (source != NULL) ck_assert_str_eq(source, made);
    free(source);
    free(made);
    ansur_close(&table);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tape_doubt(void);
Suite *mus_suite_tape_doubt(void)
{
    Suite *suite = suite_create("tape_doubt");
    TCase *tests = tcase_create("tape_doubt");
    tcase_add_test(tests, a_prediction_is_the_regression_on_the_others);
    tcase_add_test(tests, a_slip_is_named_with_its_value);
    tcase_add_test(tests, slips_in_one_tape_are_all_named);
    tcase_add_test(tests, charts_have_no_warning);
    tcase_add_test(tests, people_whom_the_survey_lacks_have_no_warning);
    tcase_add_test(tests, slips_of_the_survey_are_named_and_true_tapes_are_not_warned_of);
    suite_add_tcase(suite, tests);
    return suite;
}
