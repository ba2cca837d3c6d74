/*
 * test_body_length.c: lengths along the made skin: shoulder, arm and elbow are the tape's within 2 mm for all table
 * sizes, random tapes and people of the survey; the middle lines are those of the plain surface by an independent hull;
 * what a body was made without has no length, and a sheet whose arm and elbow quarrel is refused.
 */
#include "people.h"
#include "study/people/ansur.h"

#define POINTS 2048
#define RANDOM_TAPES (SUPPORT_SLOW ? 10 : 60)
#define EACH (SUPPORT_SLOW ? 499 : 101) /* people of the survey */


static const int32_t followed[] = {MUS_MEASURE_SHOULDER, MUS_MEASURE_ARM, MUS_MEASURE_ELBOW};


static void check_followed(const mus_body *body, const char *who)
{
    for (size_t i = 0; i < sizeof followed / sizeof *followed; i++) {
        const double asked = mus_body_asked(body, followed[i]), made = mus_body_made(body, followed[i]);
        ck_assert_msg(fabs(made - asked) < 2e-3, "%s: %s asked %.4f, made %.4f", who, mus_measure_name(followed[i]),
                      asked, made);
    }
}


/* a body without the details of the skin (plain) */
static mus_body *plain_body(mus_context *context, const mus_tape *tape, const char *who)
{
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    mus_body *body = NULL;
    ck_assert_msg(mus_body_create(context, tape, &def, &body) == MUS_OK, "%s: %s", who, mus_context_error(context));
    return body;
}


START_TEST(shoulder_arm_and_elbow_of_all_sizes_are_the_tapes)
{
    mus_context *context = support_context();
    for (int32_t i = 0; i < mus_tape_size_count(); i++) {
        const char *size = mus_tape_size_name(i);
        mus_tape *tape = people_size(context, size);
        mus_body *body = plain_body(context, tape, size);
        check_followed(body, size);
        const double slope = mus_body_made(body, MUS_MEASURE_SHOULDER_SLOPE);
        ck_assert_double_eq_tol(slope, mus_body_asked(body, MUS_MEASURE_SHOULDER_SLOPE), 0.025);

        /* the others are there and of the right size; breasts are women's */
        ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_BACK_WAIST),
                                mus_body_asked(body, MUS_MEASURE_BACK_WAIST), 0.012);
        ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_CROTCH_LENGTH),
                                mus_body_asked(body, MUS_MEASURE_CROTCH_LENGTH), 0.09);
        ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_ACROSS_FRONT),
                                mus_body_asked(body, MUS_MEASURE_ACROSS_FRONT), 0.05);
        ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_ACROSS_BACK),
                                mus_body_asked(body, MUS_MEASURE_ACROSS_BACK), 0.08);
        ck_assert_int_eq(isnan(mus_body_made(body, MUS_MEASURE_BUST_SPAN)), size[0] != 'W');
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


/* lengths, slope and arm angle of a table size, varied as much as those of people */
START_TEST(random_tapes_are_followed)
{
    mus_context *context = support_context();
    uint64_t seed = 31;
    for (int i = 0; i < RANDOM_TAPES; i++) {
        const char *size = mus_tape_size_name((int32_t)support_uniform(&seed, 0.0, mus_tape_size_count() - 1e-6));
        mus_tape *tape = people_size(context, size);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
        const double arm = support_uniform(&seed, 0.9, 1.1) * mus_tape_value(tape, MUS_MEASURE_ARM);
        const struct {
            int32_t measure;
            double value;
        } row[] = {
            {MUS_MEASURE_ARM, arm},
            {MUS_MEASURE_ELBOW, support_uniform(&seed, 0.53, 0.63) * arm},
            {MUS_MEASURE_SHOULDER,
             support_uniform(&seed, 0.85, 1.15) * mus_tape_value(tape, MUS_MEASURE_SHOULDER)},
            {MUS_MEASURE_SHOULDER_SLOPE, support_uniform(&seed, 14.0, 28.0) * (3.14159265358979323846 / 180.0)},
            {MUS_MEASURE_ARM_ANGLE, support_uniform(&seed, 30.0, 75.0) * (3.14159265358979323846 / 180.0)},
            {MUS_MEASURE_UPPER_ARM,
             support_uniform(&seed, 0.9, 1.15) * mus_tape_value(tape, MUS_MEASURE_UPPER_ARM)},
        };
        for (size_t k = 0; k < sizeof row / sizeof *row; k++)
            ck_assert_int_eq(mus_tape_set(tape, row[k].measure, row[k].value, MUS_SOURCE_GIVEN), MUS_OK);
        mus_body *body = plain_body(context, tape, size);
        check_followed(body, size);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


/* shoulder and arm as the survey measured them: acromion to radiale and on to stylion, and 5 % for the bend */
START_TEST(people_of_the_survey_have_their_arms_and_shoulders)
{
    char path[512];
    ansur table;
    if (support_data("anthropometry/ansur2_garment_cm.csv", path, sizeof path) == NULL) return;
    ck_assert(ansur_open(&table, path));
    mus_context *context = support_context();
    for (int row = 0; row < table.rows; row += EACH) {
        mus_tape *tape = ansur_tape(context, &table, row);
        ck_assert_msg(tape != NULL, "%s", mus_context_error(context));
        const double upper = 0.01 * ansur_value(&table, row, "acromion_radiale_len");
        const double straight = upper + 0.01 * ansur_value(&table, row, "radiale_stylion_len");
        const double shoulder = 0.01 * ansur_value(&table, row, "shoulder_len");
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_ARM, 1.05 * straight, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_ELBOW, upper + 0.05 * straight, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_SHOULDER, shoulder, MUS_SOURCE_GIVEN), MUS_OK);
        mus_body *body = plain_body(context, tape, ansur_name(&table, row));
        check_followed(body, ansur_name(&table, row));
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    ansur_close(&table);
    support_context_end(context);
}
END_TEST


/* ---- the middle lines, by gift wrapping ---- */

/* on which side of the line from p to q a point lies */
static double turned(const double *p, const double *q, const double *r)
{
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}


/* perimeter of the hull of n points, less the way from the last to the first, which is an edge of it */
static double wrapped(int n, double (*xy)[2])
{
    int start = 0;
    for (int i = 1; i < n; i++)
        if (xy[i][0] < xy[start][0]) start = i;
    double sum = 0.0;
    int at = start;
    for (int step = 0; step <= n; step++) {
        int next = at == 0 ? 1 : 0;
        for (int i = 0; i < n; i++)
            if (i != at && turned(xy[at], xy[next], xy[i]) < 0.0) next = i;
        sum += hypot(xy[next][0] - xy[at][0], xy[next][1] - xy[at][1]);
        at = next;
        if (at == start) break;
    }
    return sum - hypot(xy[n - 1][0] - xy[0][0], xy[n - 1][1] - xy[0][1]);
}


/* place in the middle plane at a height of the torso, before (1) or behind (-1) */
static void middle_at(const mus_body *body, const int32_t *range, double height, double before, double *out)
{
    out[0] = out[1] = NAN;
    for (int32_t v = range[0]; v < range[0] + range[1]; v++) {
        const double *x = mus_body_vertices(body) + 3 * (ptrdiff_t)v;
        if (fabs(x[0]) > 1e-9 || fabs(x[1] - height) > 1e-9 || before * x[2] < 0.0) continue;
        out[0] = x[2], out[1] = x[1];
    }
}


START_TEST(middle_lines_are_those_of_the_surface)
{
    static const char *const sizes[] = {"W40", "M50", "C116"};
    mus_context *context = support_context();
    for (int i = 0; i < 3; i++) {
        mus_tape *tape = people_size(context, sizes[i]);
        mus_body *body = plain_body(context, tape, sizes[i]);
        const double high = mus_body_made(body, MUS_MEASURE_WAIST_HEIGHT);
        const double top = mus_body_made(body, MUS_MEASURE_NAPE_HEIGHT);
        int32_t range[4], under = 0, behind = 0;
        double waist[2], nape[2];
        double(*crotch)[2] = calloc(POINTS, sizeof *crotch), (*back)[2] = calloc(POINTS, sizeof *back);
        ck_assert(crotch != NULL && back != NULL);
        ck_assert_int_eq(mus_body_limb_range(body, 0, range), MUS_OK);
        middle_at(body, range, high, 1.0, crotch[under++]);
        middle_at(body, range, high, -1.0, waist);
        middle_at(body, range, top, -1.0, nape);
        memcpy(back[behind++], waist, sizeof waist);

        /* vertices below the waist; vertices behind the line from waist to nape */
        for (int32_t v = range[0]; v < range[0] + range[1] && under < POINTS - 1; v++) {
            const double *x = mus_body_vertices(body) + 3 * (ptrdiff_t)v, at[2] = {x[2], x[1]};
            if (fabs(x[0]) > 1e-9) continue;
            if (x[1] < high - 1e-9) memcpy(crotch[under++], at, sizeof at);
            const bool between = x[1] > high && x[1] < top - 1e-9;
            if (between && turned(waist, nape, at) > 0.0) memcpy(back[behind++], at, sizeof at);
        }
        memcpy(crotch[under++], waist, sizeof waist);
        memcpy(back[behind++], nape, sizeof nape);
        ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_CROTCH_LENGTH), wrapped(under, crotch), 1e-9);
        ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_BACK_WAIST), wrapped(behind, back), 1e-9);
        free(crotch);
        free(back);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(what_is_not_there_has_no_length)
{
    static const struct {
        int32_t without;
        bool arm, across;
    } row[] = {{MUS_WITHOUT_ARM_LEFT, true, true},
               {MUS_WITHOUT_ARM_LEFT | MUS_WITHOUT_FOREARM_RIGHT, false, true},
               {MUS_WITHOUT_ARM_LEFT | MUS_WITHOUT_ARM_RIGHT, false, false},
               {MUS_WITHOUT_HAND_LEFT | MUS_WITHOUT_HAND_RIGHT, true, true},
               {MUS_WITHOUT_FOREARM_LEFT | MUS_WITHOUT_FOREARM_RIGHT, false, true}};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_body_def def;
        mus_body_def_init(&def, sizeof def);
        def.without = row[i].without;
        mus_body *body = people_body(context, "W40", &def);
        ck_assert_int_eq(isnan(mus_body_made(body, MUS_MEASURE_ARM)), !row[i].arm);
        ck_assert_int_eq(isnan(mus_body_made(body, MUS_MEASURE_ELBOW)), !row[i].arm);
        ck_assert_int_eq(isnan(mus_body_made(body, MUS_MEASURE_ACROSS_BACK)), !row[i].across);
        ck_assert(!isnan(mus_body_made(body, MUS_MEASURE_SHOULDER)));
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


START_TEST(an_elbow_off_the_arm_is_refused_by_both)
{
    mus_context *context = support_context();
    for (int i = 0; i < 2; i++) {
        mus_tape *tape = people_size(context, "W40");
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_ARM, 0.60, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_ELBOW, i == 0 ? 0.43 : 0.26, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_ERR_TAPE);
        ck_assert_msg(strstr(mus_context_error(context), i == 0 ? "elbow of 43.0 cm is too large against arm of 60.0 cm"
                                                                : "elbow of 26.0 cm is too small") != NULL,
                      "%s", mus_context_error(context));
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_body_length(void);
Suite *mus_suite_body_length(void)
{
    Suite *suite = suite_create("body_length");
    TCase *tests = tcase_create("body_length");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, shoulder_arm_and_elbow_of_all_sizes_are_the_tapes);
    tcase_add_test(tests, random_tapes_are_followed);
    tcase_add_test(tests, people_of_the_survey_have_their_arms_and_shoulders);
    tcase_add_test(tests, middle_lines_are_those_of_the_surface);
    tcase_add_test(tests, what_is_not_there_has_no_length);
    tcase_add_test(tests, an_elbow_off_the_arm_is_refused_by_both);
    suite_add_tcase(suite, tests);
    return suite;
}
