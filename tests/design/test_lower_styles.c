/*
 * test_lower_styles.c: skirts and trousers by words: every kind, length, band and rise that the rules allow drafts on
 * five sizes as a garment without a fault: outlines simple, seams as long as each other or as their gathers mean, one
 * waist and the hems open. Topologies are those of drafting.md section 8; circles have the radii and areas of
 * drafting_golden.txt.
 */
#include <stdio.h>
#include <string.h>

#include "design/drafts.h"
#include "design/style.h"

static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};

#define SIZES ((int)(sizeof sizes / sizeof sizes[0]))




/* all kinds of `kind`, lengths, bands and rises of a garment: how many drafts */
static int lower_all(mus_context *context, const char *size, int32_t garment, int32_t kind, int32_t length)
{
    mus_tape *tape = drafts_tape(context, size);
    int count = 0;
    for (int32_t k = 0; mus__style_word(kind, k) != NULL; k++)
        for (int32_t i = 0; i < 5 * 4 * 3; i++) {
            mus__style style;
            memset(&style, 0, sizeof style);
            style.option[MUS__AXIS_GARMENT] = garment;
            style.option[kind] = k;
            style.option[length] = i / 12;
            style.option[MUS__AXIS_BAND] = i / 3 % 4;
            style.option[MUS__AXIS_RISE] = i % 3;
            if (i / 3 % 4 != MUS__BAND_ELASTIC) style.option[MUS__AXIS_CLOSURE] = MUS__CLOSURE_SIDE;
            if (mus__style_check(context, &style) != MUS_OK) continue;
            char words[256];
            mus_pattern *pattern;
            mus__style_spell(&style, words, sizeof words);
            const mus_status status = mus__style_draft(context, words, &style, tape, NULL, &pattern);
            ck_assert_msg(status == MUS_OK, "%s of %s: %s", words, size, mus_context_error(context));
            mus_pattern_destroy(pattern);
            count++;
        }
    mus_tape_destroy(tape);
    return count;
}


START_TEST(every_skirt_drafts)
{
    mus_context *context = support_context();
    ck_assert_int_eq(lower_all(context, sizes[_i], MUS__GARMENT_SKIRT, MUS__AXIS_SKIRT, MUS__AXIS_LENGTH), 3 * 234);
    support_context_end(context);
}
END_TEST


START_TEST(every_leg_drafts)
{
    mus_context *context = support_context();
    ck_assert_int_eq(lower_all(context, sizes[_i], MUS__GARMENT_TROUSERS, MUS__AXIS_LEG, MUS__AXIS_LEG_LENGTH),
                     3 * 95);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_lower_styles(void)
{
    Suite *suite = suite_create("lower_styles");
    TCase *tcase = tcase_create("lower_styles");
    tcase_set_timeout(tcase, 120);
    tcase_add_loop_test(tcase, every_skirt_drafts, 0, SIZES);
    tcase_add_loop_test(tcase, every_leg_drafts, 0, SIZES);
    suite_add_tcase(suite, tcase);
    return suite;
}
