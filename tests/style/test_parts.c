/*
 * test_parts.c: sleeves and collars on the tops that the words make: every sleeve with every collar that goes
 * with it, on five sizes, with the shapes that cut the armhole or the neckline in turn; and no memory for any of it.
 */
#include <stdio.h>

#include "muslin/topology.h"
#include "style/halves.h"

static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};
#define SIZES ((int)(sizeof sizes / sizeof sizes[0]))
#define SLEEVES 12
#define COLLARS 8

/* options that are tried in turn until the rules allow one with sleeve and collar */
static const char *const rest[] = {
    "shape=princess_armhole closure=front", "shape=boxy cloth=knit yoke=yoke closure=front",
    "shape=princess_shoulder closure=back", "shape=side_waist closure=back ease=slim",
    "shape=empire neck=v closure=front", "shape=neck_gathers neck=scoop closure=back",
    "shape=boxy cloth=knit ease=loose", "shape=side_waist neck=v closure=front cloth=knit",
    "shape=boxy neck=jewel closure=front",
};
#define REST ((int)(sizeof rest / sizeof rest[0]))


/* gathers are what a bust dart is let out to, which women's blocks alone have */
static bool fits(mus_context *context, const char *words, int size, mus__style *style)
{
    return mus__style_read(context, words, style) == MUS_OK && (size < 3 || strstr(words, "gathers") == NULL);
}


/* a dolman's underarm has no place under the short bodice of an empire on large sizes: that is said */
static bool refused(mus_context *context, mus_status status)
{
    return status == MUS_ERR_DESIGN && strstr(mus_context_error(context), "dolman") != NULL;
}


START_TEST(every_sleeve_with_every_collar)
{
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, sizes[_i]);
    int drafted = 0, dolmans = 0, turn = 0;
    for (int32_t sleeve = 0; sleeve < SLEEVES; sleeve++) {
        for (int32_t collar = 0; collar < COLLARS; collar++, turn++) {
            mus_pattern *pattern = NULL;
            char words[200];
            int tries = 0;
            mus__style style;
            do {
                snprintf(words, sizeof words, "top sleeve=%s collar=%s %s", mus__style_word(MUS__AXIS_SLEEVE, sleeve),
                         mus__style_word(MUS__AXIS_COLLAR, collar), rest[(turn + tries) % REST]);
            } while (!fits(context, words, _i, &style) && ++tries < REST);
            ck_assert_msg(tries < REST, "%s: %s", words, mus_context_error(context));
            const mus_status status = mus__style_draft(context, "parts", &style, tape, NULL, &pattern);
            ck_assert_msg(status == MUS_OK || refused(context, status), "%s: %s: %s", sizes[_i], words,
                          mus_context_error(context));
            drafted += status == MUS_OK, dolmans += status != MUS_OK;

            /* hem, neck and two arms, no handle */
            mus_topology t;
            mus_topology_init(&t, sizeof t);
            if (pattern == NULL) continue;
            ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
            ck_assert_msg(t.euler == -2 && t.loops == 4 && t.genus == 0, "%s: %s: %d %d", sizes[_i], words,
                          (int)t.euler, (int)t.loops);
            mus_pattern_destroy(pattern);
        }
    }
    ck_assert_int_eq(drafted + dolmans, SLEEVES * COLLARS);
    ck_assert_int_le(dolmans, 3);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* styles that pass through every file of sleeves and collars */
static const char *const hungry[] = {
    "top sleeve=long collar=shirt closure=front cuff=cuff", "top sleeve=puff collar=peter_pan closure=back",
    "top sleeve=raglan collar=turtleneck cloth=knit",       "top sleeve=dolman collar=hood closure=front cuff=rib",
};
#define HUNGRY ((int)(sizeof hungry / sizeof hungry[0]))


START_TEST(no_memory_is_said_and_leaves_nothing)
{
    for (int64_t n = 0;; n += 7) {
        mus_context *context = support_context();
        mus_tape *tape = drafts_tape(context, "W40");
        mus_pattern *pattern = NULL;
        support_fail_after(n, false);
        const mus_status status = mus_design_draft_words(context, hungry[_i], tape, NULL, &pattern);
        support_fail_never();
        mus_pattern_destroy(pattern);
        mus_tape_destroy(tape);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_ptr_null(pattern);
    }
}
END_TEST


Suite *mus_suite_parts(void)
{
    Suite *suite = suite_create("parts");
    TCase *tcase = tcase_create("parts");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, every_sleeve_with_every_collar, 0, SIZES);
    tcase_add_loop_test(tcase, no_memory_is_said_and_leaves_nothing, 0, HUNGRY);
    suite_add_tcase(suite, tcase);
    return suite;
}
