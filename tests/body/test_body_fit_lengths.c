/*
 * test_body_fit_lengths.c: bust span and crotch length are a sheet's where it names them, girths and heights staying
 * exact: on tapes about the table's, and on the models of FreeSewing, which name both. What cannot be reached is told.
 * A sheet that names neither makes the body that it made before.
 */
#include "muslin/exchange.h"
#include "people.h"

#define FOLLOW_TAPES (SUPPORT_SLOW ? 4 : 24)

Suite *mus_suite_body_fit_lengths(void);


static mus_body *follow_body(mus_context *context, const mus_tape *tape)
{
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    mus_body *body = NULL;
    ck_assert_msg(mus_body_create(context, tape, &def, &body) == MUS_OK, "%s", mus_context_error(context));
    return body;
}


static double follow_off(const mus_body *body, int32_t measure)
{
    return fabs(mus_body_made(body, measure) - mus_body_asked(body, measure));
}


static void check_girths(const mus_body *body)
{
    static const int32_t girths[] = {MUS_MEASURE_BUST,  MUS_MEASURE_WAIST, MUS_MEASURE_HIP, MUS_MEASURE_UNDERBUST,
                                     MUS_MEASURE_THIGH, MUS_MEASURE_NECK,  MUS_MEASURE_INLEG,
                                     MUS_MEASURE_WAIST_HEIGHT};
    for (size_t i = 0; i < sizeof girths / sizeof *girths; i++) ck_assert(follow_off(body, girths[i]) < 1e-4);
}


START_TEST(named_lengths_are_followed)
{
    mus_context *context = support_context();
    uint64_t seed = 12;
    for (int i = 0; i < FOLLOW_TAPES; i++) {
        static const char *const sizes[] = {"W36", "W40", "W48", "M50"};
        const char *size = sizes[i % 4];
        mus_tape *tape = people_size(context, size);
        mus_body *before = follow_body(context, tape), *body;
        double span = mus_body_made(before, MUS_MEASURE_BUST_SPAN);
        double crotch = mus_body_made(before, MUS_MEASURE_CROTCH_LENGTH);
        span *= support_uniform(&seed, 0.9, 1.2), crotch *= support_uniform(&seed, 0.97, 1.025);
        if (size[0] == 'W')
            ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_BUST_SPAN, span, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_CROTCH_LENGTH, crotch, MUS_SOURCE_GIVEN), MUS_OK);
        body = follow_body(context, tape);
        if (size[0] == 'W')
            ck_assert_msg(follow_off(body, MUS_MEASURE_BUST_SPAN) < 1e-3, "%s: span %.4f, made %.4f", size, span,
                          mus_body_made(body, MUS_MEASURE_BUST_SPAN));
        ck_assert_msg(follow_off(body, MUS_MEASURE_CROTCH_LENGTH) < 2e-3, "%s: crotch %.4f, made %.4f", size, crotch,
                      mus_body_made(body, MUS_MEASURE_CROTCH_LENGTH));
        check_girths(body);
        mus_body_destroy(before);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(what_cannot_be_reached_is_the_nearest_and_told)
{
    mus_context *context = support_context();
    mus_tape *tape = people_size(context, "W40");
    mus_body *plain = follow_body(context, tape), *body;
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_BUST_SPAN, 0.24, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_CROTCH_LENGTH, 0.60, MUS_SOURCE_GIVEN), MUS_OK);
    body = follow_body(context, tape);
    ck_assert_double_gt(mus_body_made(body, MUS_MEASURE_BUST_SPAN), 0.17);
    ck_assert_double_lt(mus_body_made(body, MUS_MEASURE_BUST_SPAN), 0.24);
    ck_assert_double_gt(mus_body_made(body, MUS_MEASURE_CROTCH_LENGTH), 0.60);
    ck_assert_double_lt(mus_body_made(body, MUS_MEASURE_CROTCH_LENGTH),
                        mus_body_made(plain, MUS_MEASURE_CROTCH_LENGTH) - 0.02);
    check_girths(body);
    mus_body_destroy(plain);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* crossSeam of the larger models asks for a seat flatter than people's */
START_TEST(the_models_of_freesewing_are_followed)
{
    static const char *const names[] = {"cisFemaleAdult30", "cisFemaleAdult36", "cisFemaleAdult38", "cisFemaleAdult44",
                                        "cisFemaleAdult46", "cisMaleAdult34",   "cisMaleAdult36",   "cisMaleAdult40",
                                        "cisMaleAdult44",   "cisMaleAdult48"};
    mus_context *context = support_context();
    char path[512];
    int close = 0;
    const bool there = support_data("freesewing/models.csv", path, sizeof path) != NULL;
    for (size_t i = 0; i < sizeof names / sizeof *names && there; i++) {
        mus_tape *tape = NULL;
        ck_assert_int_eq(mus_tape_read(context, path, names[i], &tape), MUS_OK);
        mus_body *body = follow_body(context, tape);
        if (names[i][3] == 'F') ck_assert(follow_off(body, MUS_MEASURE_BUST_SPAN) < 1e-3);
        ck_assert_msg(follow_off(body, MUS_MEASURE_CROTCH_LENGTH) < 0.016, "%s: crotch made %.4f", names[i],
                      mus_body_made(body, MUS_MEASURE_CROTCH_LENGTH));
        close += follow_off(body, MUS_MEASURE_CROTCH_LENGTH) < 1e-3;
        check_girths(body);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    if (there) ck_assert_int_ge(close, 6);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_body_fit_lengths(void)
{
    Suite *suite = suite_create("body_fit_lengths");
    TCase *tests = tcase_create("body_follow");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, named_lengths_are_followed);
    tcase_add_test(tests, what_cannot_be_reached_is_the_nearest_and_told);
    tcase_add_test(tests, the_models_of_freesewing_are_followed);
    suite_add_tcase(suite, tests);
    return suite;
}
