/*
 * test_sleeve.c: every sleeve on a half shirt drawn by hand: the whole garment has no fault, the topology of a T-shirt
 * (Euler characteristic -2, four openings, no handle), and sewn edges of equal length but for their ease.
 */
#include <stdio.h>

#include "muslin/topology.h"
#include "style/half_shirt.h"

static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};
#define SIZES (int)(sizeof sizes / sizeof sizes[0])
#define SLEEVES 12


static mus__style style_of(int32_t sleeve, int32_t cloth, int32_t cuff)
{
    mus__style style;
    memset(&style, 0, sizeof style);
    style.option[MUS__AXIS_SLEEVE] = sleeve;
    style.option[MUS__AXIS_CLOTH] = cloth;
    style.option[MUS__AXIS_CUFF] = cuff;
    style.option[MUS__AXIS_SHAPE] = MUS__SHAPE_BOXY * (cloth == MUS__CLOTH_KNIT);
    return style;
}


/* Doubles the finished half, writes it as a pattern and checks that it has no fault. */
static mus_pattern *whole(mus__half *half, const char *what)
{
    mus_pattern *pattern;
    mus__board_double(&half->board);
    mus__board_opening_add(&half->board, "hem");
    mus__board_opening_add(&half->board, "neck");
    mus__board_write(&half->board, &pattern);
    ck_assert_msg(half->board.status == MUS_OK, "%s: %s", what, mus_context_error(half->context));
    int32_t faults;
    const char *text = "";
    mus_faults *found;
    ck_assert_int_eq(mus_pattern_check(pattern, &faults, &found), MUS_OK);
    if (faults > 0) text = mus_faults_text(found, 0);
    ck_assert_msg(faults == 0, "%s: %d faults: %s", what, (int)faults, text);
    mus_faults_destroy(found);
    return pattern;
}


START_TEST(every_sleeve_is_a_clean_shirt)
{
    mus_context *context = support_context();
    for (int32_t sleeve = 0; sleeve < SLEEVES; sleeve++) {
        for (int32_t k = 0; k < 4; k++) {
            mus__half half;
            static const int32_t cuffs[4] = {MUS__CUFF_NONE, MUS__CUFF_NONE, MUS__CUFF_CUFF, MUS__CUFF_RIB};
            const mus__style style = style_of(sleeve, k % 2, cuffs[k]);
            const char *word = mus__style_word(MUS__AXIS_SLEEVE, sleeve);
            char what[80];
            snprintf(what, sizeof what, "%s sleeve %s %d", sizes[_i], word, (int)k);
            half_shirt(context, sizes[_i], &style, 0.0, &half);
            mus__sleeve_attach(&half);
            ck_assert_msg(half.board.status == MUS_OK, "%s: %s", what, mus_context_error(context));
            mus_pattern *pattern = whole(&half, what);
            mus_topology t;
            mus_topology_init(&t, sizeof t);
            ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
            ck_assert_msg(t.euler == -2 && t.loops == 4 && t.genus == 0 && t.components == 1, "%s: %d %d %d %d", what,
                          (int)t.euler, (int)t.loops, (int)t.genus, (int)t.components);
            mus_pattern_destroy(pattern);
            mus__board_free(&half.board);
        }
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_sleeve(void)
{
    Suite *suite = suite_create("sleeve");
    TCase *tcase = tcase_create("sleeve");
    tcase_add_loop_test(tcase, every_sleeve_is_a_clean_shirt, 0, SIZES);
    suite_add_tcase(suite, tcase);
    return suite;
}
