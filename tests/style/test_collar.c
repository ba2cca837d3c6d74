/*
 * test_collar.c: every collar on a half shirt drawn by hand, with the sleeves that change its neckline: the whole
 * garment has no fault, the neck edge has the length of the neckline, the opening at the neck is the collar's edge, and
 * the topology of hood, turtleneck and raglan is as counted by hand.
 */
#include <math.h>
#include <stdio.h>

#include "muslin/topology.h"
#include "half/half_placement.h"
#include "style/half_shirt.h"

static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};
#define SIZES (int)(sizeof sizes / sizeof sizes[0])

/* collar, where the garment opens, and how many panels of the whole garment are of it */
static const struct {
    int32_t collar, closure, panels;
} list[] = {
    {MUS__COLLAR_MANDARIN, MUS__CLOSURE_FRONT, 1},  {MUS__COLLAR_MANDARIN, MUS__CLOSURE_BACK, 1},
    {MUS__COLLAR_SHIRT, MUS__CLOSURE_FRONT, 2},     {MUS__COLLAR_PETER_PAN, MUS__CLOSURE_FRONT, 1},
    {MUS__COLLAR_PETER_PAN, MUS__CLOSURE_BACK, 2},  {MUS__COLLAR_TURTLENECK, MUS__CLOSURE_NONE, 1},
    {MUS__COLLAR_TURTLENECK, MUS__CLOSURE_BACK, 1}, {MUS__COLLAR_TURTLENECK, MUS__CLOSURE_FRONT, 1},
    {MUS__COLLAR_HOOD, MUS__CLOSURE_NONE, 2},       {MUS__COLLAR_HOOD, MUS__CLOSURE_FRONT, 2},
    {MUS__COLLAR_SHAWL, MUS__CLOSURE_FRONT, 1},     {MUS__COLLAR_SAILOR, MUS__CLOSURE_NONE, 1},
    {MUS__COLLAR_SAILOR, MUS__CLOSURE_BACK, 2},
};
#define COLLARS (int)(sizeof list / sizeof list[0])


/* a half shirt with a sleeve and a collar */
static void shirt_of(mus_context *context, const char *size, int i, int32_t sleeve, double lower, mus__half *half)
{
    mus__style style;
    memset(&style, 0, sizeof style);
    style.option[MUS__AXIS_COLLAR] = list[i].collar;
    style.option[MUS__AXIS_CLOSURE] = list[i].closure;
    style.option[MUS__AXIS_SLEEVE] = sleeve;
    half_shirt(context, size, &style, lower, half);
    mus__board_opening_add(&half->board, "hem");
    mus__sleeve_attach(half);
}


START_TEST(every_collar_is_a_clean_shirt)
{
    static const int32_t sleeves[] = {MUS__SLEEVE_NONE, MUS__SLEEVE_LONG, MUS__SLEEVE_RAGLAN, MUS__SLEEVE_DOLMAN};
    mus_context *context = support_context();
    for (int i = 0; i < COLLARS; i++) {
        for (int k = 0; k < 8; k++) {
            mus__half half;
            mus_pattern *pattern;
            int32_t faults;
            char what[100];
            const char *text = "";
            mus_faults *found;
            shirt_of(context, sizes[_i], i, sleeves[k % 4], k < 4 ? 0.0 : 0.03, &half);
            mus__collar_attach(&half);
            snprintf(what, sizeof what, "%s collar %s closure %d sleeve %d", sizes[_i],
                     mus__style_word(MUS__AXIS_COLLAR, list[i].collar), (int)list[i].closure, (int)sleeves[k % 4]);
            ck_assert_msg(half.board.status == MUS_OK, "%s: %s", what, mus_context_error(context));
            mus__board_double(&half.board);
            mus__board_write(&half.board, &pattern);
            ck_assert_msg(half.board.status == MUS_OK, "%s: %s", what, mus_context_error(context));
            ck_assert_int_eq(mus_pattern_check(pattern, &faults, &found), MUS_OK);
            if (faults > 0) text = mus_faults_text(found, 0);
            ck_assert_msg(faults == 0, "%s: %d faults: %s", what, (int)faults, text);
            mus_faults_destroy(found);

            /* hem, neck, two arms; no handle */
            mus_topology t;
            mus_topology_init(&t, sizeof t);
            ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
            ck_assert_msg(t.euler == -2 && t.loops == 4 && t.genus == 0 && t.components == 1, "%s: %d %d %d %d", what,
                          (int)t.euler, (int)t.loops, (int)t.genus, (int)t.components);
            int32_t collars = 0;
            for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
                const char *label = mus_pattern_panel_label(pattern, p);
                collars += strcmp(label, "collar") == 0 || strcmp(label, "hood") == 0;
            }
            ck_assert_msg(collars == list[i].panels, "%s: %d panels of it", what, (int)collars);
            mus_pattern_destroy(pattern);
            mus__board_free(&half.board);
        }
    }
    support_context_end(context);
}
END_TEST


/* the edge sewn to the neckline is as long as the neckline; the rib of a turtleneck is 0.87 of it */
START_TEST(collars_are_as_long_as_the_neckline)
{
    mus_context *context = support_context();
    for (int i = 0; i < COLLARS; i++) {
        mus__half half;
        shirt_of(context, sizes[_i], i, MUS__SLEEVE_LONG, 0.01, &half);
        int32_t neck[MUS__BOUNDARY_SIDES];
        const int32_t n = mus__half_boundary(&half, "", "neck", neck, MUS__BOUNDARY_SIDES);
        mus__collar_attach(&half);
        ck_assert_msg(half.board.status == MUS_OK, "%s", mus_context_error(context));
        double length = 0.0, ease = 0.0;
        for (int32_t s = 0; s < n; s++) {
            const int32_t seam = mus__board_seam_of(&half.board, neck[s]);
            ck_assert_int_ne(seam, MUS_NONE);
            length += half.board.side[neck[s]].length;
            ease += fabs(half.board.seam[seam].ease);
        }
        const double part = list[i].collar == MUS__COLLAR_TURTLENECK ? 0.13 * length : 0.0;
        ck_assert_msg(fabs(ease - part) < 2e-4, "%s collar %d: eased by %g m, expected %g", sizes[_i],
                      (int)list[i].collar, ease, part);
        mus__board_free(&half.board);
    }
    support_context_end(context);
}
END_TEST


/* Faces, edges and vertices counted by hand, and the cells that ours has beside them. Dolman: shoulder and top of
 * the arm are two edges on each side, + 2. Raglan: the armhole below the pitch and the cut above it, + 4; on each
 * sleeve a dart (+ 2) with a neck edge before and behind it, + 4 in all. Turtleneck: its seam behind divides the
 * back's neck, + 1. The hood's top is of four halves there and of two whole panels here: two panels, four edges and
 * two vertices less */
START_TEST(rows_of_the_reference)
{
    static const struct {
        int32_t sleeve, collar, faces, edges, vertices;
    } row[] = {
        {MUS__SLEEVE_SHORT, MUS__COLLAR_NONE, 4, 16, 10},
        {MUS__SLEEVE_RAGLAN, MUS__COLLAR_NONE, 4, 16 + 4 + 4, 10 + 4 + 4},
        {MUS__SLEEVE_DOLMAN, MUS__COLLAR_NONE, 2, 14 + 2, 10 + 2},
        {MUS__SLEEVE_SHORT, MUS__COLLAR_TURTLENECK, 5, 18 + 1, 11 + 1},
        {MUS__SLEEVE_NONE, MUS__COLLAR_HOOD, 6 - 2, 21 - 4, 13 - 2},
    };
    mus_context *context = support_context();
    mus__style style;
    mus__half half;
    mus_pattern *pattern;
    memset(&style, 0, sizeof style);
    style.option[MUS__AXIS_SLEEVE] = row[_i].sleeve;
    style.option[MUS__AXIS_COLLAR] = row[_i].collar;
    style.option[MUS__AXIS_CLOTH] = MUS__CLOTH_KNIT;
    half_shirt(context, "W40", &style, 0.0, &half);
    mus__sleeve_attach(&half);
    mus__collar_attach(&half);
    mus__board_double(&half.board);
    mus__board_write(&half.board, &pattern);
    ck_assert_msg(half.board.status == MUS_OK, "%s", mus_context_error(context));
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
    ck_assert_int_eq(t.faces, row[_i].faces);
    ck_assert_int_eq(t.edges, row[_i].edges);
    ck_assert_int_eq(t.vertices, row[_i].vertices);
    mus_pattern_destroy(pattern);
    mus__board_free(&half.board);
    support_context_end(context);
}
END_TEST


/* the fronts and the back are drawn over the shoulders below the points of a turned-down collar, not over them */
START_TEST(a_turned_collar_starts_above_the_shoulders)
{
    mus_context *context = support_context();
    mus__half half;
    shirt_of(context, sizes[_i], 2, MUS__SLEEVE_LONG, 0.0, &half);
    mus__collar_attach(&half);
    double leaf[2] = {INFINITY, -INFINITY}, body[2] = {INFINITY, -INFINITY};
    mus__panel_heights(&half.board, mus__board_find_panel(&half.board, "collar_leaf"), leaf);
    mus__panel_heights(&half.board, mus__board_find_panel(&half.board, "front"), body);
    mus__panel_heights(&half.board, mus__board_find_panel(&half.board, "back"), body);
    ck_assert_double_ge(leaf[0], body[1] - 0.7 * CM); /* the control points of a leaf lie up to 0.6 cm lower */
    ck_assert_double_gt(body[1], 0.5);
    mus__board_free(&half.board);
    support_context_end(context);
}
END_TEST


/* a half without a neckline is refused */
START_TEST(no_neckline_no_collar)
{
    mus_context *context = support_context();
    mus__half half;
    shirt_of(context, "W40", 0, MUS__SLEEVE_NONE, 0.0, &half);
    for (int32_t i = 0; i < half.board.nside; i++)
        if (strcmp(half.board.side[i].attr.label, "neck") == 0) mus__board_rename(&half.board, i, "neck", "");
    mus__collar_attach(&half);
    ck_assert_int_eq(half.board.status, MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "neck"));
    mus__board_free(&half.board);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_collar(void)
{
    Suite *suite = suite_create("collar");
    TCase *tcase = tcase_create("collar");
    tcase_add_loop_test(tcase, every_collar_is_a_clean_shirt, 0, SIZES);
    tcase_add_loop_test(tcase, collars_are_as_long_as_the_neckline, 0, SIZES);
    tcase_add_loop_test(tcase, rows_of_the_reference, 0, 5);
    tcase_add_loop_test(tcase, a_turned_collar_starts_above_the_shoulders, 0, SIZES);
    tcase_add_test(tcase, no_neckline_no_collar);
    suite_add_tcase(suite, tcase);
    return suite;
}
