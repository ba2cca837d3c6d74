/*
 * test_people.c: a sample of ANSUR II, every 20th person (152 of 3034): all build, every asked girth and height is the
 * tape's, by the library's figures and by slicing the triangles; volumes are the weights. All of them: `make people`.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/body.h"
#include "study/people/ansur.h"
#include "study/people/slice.h"
#include "support.h"

#define EACH 20


/* the girth of a contour of a limb, from the triangles */
static double cut_at(const mus_body *body, int limb, const char *contour)
{
    for (int c = 0; c < mus_body_contour_count(body, limb); c++) {
        double points[9];
        slice section;
        if (strcmp(mus_body_contour_name(body, limb, c), contour) != 0) continue;
        ck_assert_int_eq(mus_body_contour_points(body, limb, c, 3, points), MUS_OK);
        ck_assert(strcmp(contour, "hip") == 0 ? slice_trunk(body, points[1] + 1e-9, &section)
                                               : slice_limb(body, limb, points[1] + 1e-9, &section));
        return section.girth;
    }
    ck_abort_msg("no contour %s", contour);
    return NAN;
}


static void check_person(const mus_body *body, const char *who)
{
    static const struct {
        int measure, limb;
        const char *contour;
    } cut[] = {{MUS_MEASURE_BUST, 0, "bust"},   {MUS_MEASURE_WAIST, 0, "waist"}, {MUS_MEASURE_HIP, 0, "hip"},
               {MUS_MEASURE_THIGH, 3, "thigh"}, {MUS_MEASURE_CALF, 4, "calf"},   {MUS_MEASURE_ANKLE, 3, "ankle"}};
    for (int i = 0; i < ANSUR_MEASURES; i++) {
        const int32_t m = ansur_measures[i].measure;
        const double asked = mus_body_asked(body, m), made = mus_body_made(body, m);
        ck_assert_msg(fabs(made - asked) < (ansur_measures[i].height ? 0.002 : 0.001), "%s: %s asked %.4f, made %.4f",
                      who, mus_measure_name(m), asked, made);
    }
    for (size_t i = 0; i < sizeof cut / sizeof *cut; i++) {
        const double asked = mus_body_asked(body, cut[i].measure), made = cut_at(body, cut[i].limb, cut[i].contour);
        ck_assert_msg(fabs(made - asked) < 0.001, "%s: %s asked %.4f, cut %.4f", who, mus_measure_name(cut[i].measure),
                      asked, made);
    }
}


static int by_size(const void *left, const void *right)
{
    const double x = *(const double *)left, y = *(const double *)right;
    return x < y ? -1 : x > y;
}


START_TEST(people_of_the_survey_are_their_tapes_and_their_weights)
{
    char path[512];
    ansur table;
    if (support_data("anthropometry/ansur2_garment_cm.csv", path, sizeof path) == NULL) return;
    ck_assert(ansur_open(&table, path));
    ck_assert_int_eq(table.rows, 3034);
    mus_context *context = support_context();
    double off[3034 / EACH + 1];
    int count = 0;
    for (int row = 0; row < table.rows; row += EACH) {
        mus_tape *tape = ansur_tape(context, &table, row);
        mus_body *body = NULL;
        ck_assert_msg(tape != NULL, "%s", mus_context_error(context));
        ck_assert_msg(mus_body_create(context, tape, NULL, &body) == MUS_OK, "%s: %s", ansur_name(&table, row),
                      mus_context_error(context));
        check_person(body, ansur_name(&table, row));
        off[count++] = fabs(mus_body_volume(body) / ansur_volume(&table, row) - 1.0);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    qsort(off, (size_t)count, sizeof *off, by_size);
    ck_assert_msg(off[count / 2] < 0.03, "median %g", off[count / 2]);
    ck_assert_msg(off[95 * count / 100] < 0.08, "95 %%: %g", off[95 * count / 100]);
    ansur_close(&table);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_people(void);
Suite *mus_suite_people(void)
{
    Suite *suite = suite_create("people");
    TCase *tests = tcase_create("people");
    tcase_set_timeout(tests, 120);
    if (!SUPPORT_SLOW) tcase_add_test(tests, people_of_the_survey_are_their_tapes_and_their_weights);
    suite_add_tcase(suite, tests);
    return suite;
}
