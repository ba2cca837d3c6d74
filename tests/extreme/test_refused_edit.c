/*
 * test_refused_edit.c: numbers that are not finite at every door of muslin/edit.h: refused with a
 * sentence, and the pattern is as it was, to the bit.
 */
#include <math.h>

#include "block/drafts.h"
#include "pattern/same.h"

Suite *mus_suite_refused_edit(void);

/* one call with `bad` in place number k; MUS_NONE when there is no such place */
typedef struct edit_case {
    mus_pattern *pattern;
    int32_t panel, side, waist, leg, shoulder, cf, seam;
} edit_case;

typedef mus_status (*edit_call)(const edit_case *c, int32_t k, double bad);


static mus_status refuse_add_dart(const edit_case *c, int32_t k, double bad)
{
    const double point[2] = {k == 2 ? bad : 0.05, k == 3 ? bad : 0.2};
    if (k >= 4) return MUS_NONE;
    return mus_pattern_add_dart(c->pattern, c->waist, k == 0 ? bad : 0.03, k == 1 ? bad : 0.01, point, NULL);
}


static mus_status refuse_rotate_dart(const edit_case *c, int32_t k, double bad)
{
    if (k >= 2) return MUS_NONE;
    return mus_pattern_rotate_dart(c->pattern, c->leg, c->shoulder, k == 0 ? bad : 0.05, c->cf, k == 1 ? bad : 0.5,
                                   NULL);
}


static mus_status refuse_split_dart(const edit_case *c, int32_t k, double bad)
{
    const int32_t targets[2] = {c->shoulder, c->shoulder};
    const double s[2] = {k == 0 ? bad : 0.03, k == 1 ? bad : 0.06}, part[2] = {k == 2 ? bad : 0.3, k == 3 ? bad : 0.3};
    return k >= 4 ? MUS_NONE : mus_pattern_split_dart(c->pattern, c->leg, 2, targets, s, part, c->cf, NULL);
}


static mus_status refuse_shorten_dart(const edit_case *c, int32_t k, double bad)
{
    return k >= 1 ? MUS_NONE : mus_pattern_shorten_dart(c->pattern, c->leg, bad);
}


static mus_status refuse_dart_to_seam(const edit_case *c, int32_t k, double bad)
{
    static const int32_t kind = MUS_PIECE_CUBIC;
    const double xy[4] = {k == 1 ? bad : 0.05, k == 2 ? bad : 0.2, k == 3 ? bad : 0.03, k == 4 ? bad : 0.2};
    if (k >= 5) return MUS_NONE;
    return mus_pattern_dart_to_seam(c->pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "new",
                                                               .seam_name = "seam", .edge_a = c->leg,
                                                               .edge_b = c->cf, .s_b = k == 0 ? bad : 0.1,
                                                               .npiece = 1, .kinds = &kind, .nxy = 2, .xy = xy},
                                    NULL, NULL);
}


/* mus_cut_def.s_a, mus_cut_def.s_b, mus_cut_def.xy */
static mus_status refuse_separate(const edit_case *c, int32_t k, double bad)
{
    static const int32_t kind = MUS_PIECE_CUBIC;
    const double xy[4] = {k == 2 ? bad : 0.05, k == 3 ? bad : 0.2, k == 4 ? bad : 0.03, k == 5 ? bad : 0.2};
    if (k >= 6) return MUS_NONE;
    return mus_pattern_separate(c->pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "new",
                                                           .seam_name = "seam", .edge_a = c->cf,
                                                           .s_a = k == 0 ? bad : 0.1, .edge_b = c->side,
                                                           .s_b = k == 1 ? bad : 0.02, .npiece = 1, .kinds = &kind,
                                                           .nxy = 2, .xy = xy}, NULL, NULL);
}


static mus_status refuse_add_facing(const edit_case *c, int32_t k, double bad)
{
    return k >= 1 ? MUS_NONE : mus_pattern_add_facing(c->pattern, c->waist, bad, "facing", NULL);
}


static mus_status refuse_spread(const edit_case *c, int32_t k, double bad)
{
    if (k >= 4) return MUS_NONE;
    return mus_pattern_spread(c->pattern, c->waist, k == 0 ? bad : 0.02, c->shoulder, k == 1 ? bad : 0.05,
                              k == 2 ? bad : 0.01, k == 3 ? bad : 0.01);
}


static mus_status refuse_flare(const edit_case *c, int32_t k, double bad)
{
    return k >= 1 ? MUS_NONE : mus_pattern_flare(c->pattern, c->waist, c->shoulder, 1, bad);
}


static mus_status refuse_pleat(const edit_case *c, int32_t k, double bad)
{
    if (k >= 4) return MUS_NONE;
    return mus_pattern_pleat(c->pattern, c->waist, k == 0 ? bad : 0.02, c->shoulder, k == 1 ? bad : 0.05,
                             k == 2 ? bad : 0.01, k == 3 ? bad : 0.01);
}


static mus_status refuse_lay_pleats(const edit_case *c, int32_t k, double bad)
{
    const double s[2] = {k == 0 ? bad : 0.02, k == 1 ? bad : 0.06};
    const double depth[2] = {k == 2 ? bad : 0.01, k == 3 ? bad : 0.01};
    return k >= 4 ? MUS_NONE : mus_pattern_lay_pleats(c->pattern, c->waist, 2, s, depth);
}


static mus_status refuse_add_patch(const edit_case *c, int32_t k, double bad)
{
    double xy[6] = {0.05, 0.1, 0.05, 0.05, 0.1, 0.05};
    if (k >= 6) return MUS_NONE;
    xy[k] = bad;
    return mus_pattern_add_patch(c->pattern, c->panel, "patch", 3, xy, NULL);
}


static mus_status refuse_lengthen(const edit_case *c, int32_t k, double bad)
{
    const double point[2] = {k == 0 ? bad : 0.05, k == 1 ? bad : 0.1},
                 along[2] = {k == 2 ? bad : 1.0, k == 3 ? bad : 0.0};
    return k >= 5 ? MUS_NONE : mus_pattern_lengthen(c->pattern, c->panel, point, along, k == 4 ? bad : 0.01);
}


static mus_status refuse_move_point(const edit_case *c, int32_t k, double bad)
{
    return k >= 2 ? MUS_NONE : mus_pattern_move_point(c->pattern, 1, k == 0 ? bad : 0.1, k == 1 ? bad : 0.1);
}


static mus_status refuse_move_control(const edit_case *c, int32_t k, double bad)
{
    const int32_t neck = mus_pattern_find_edge(c->pattern, c->panel, "neck");
    return k >= 2 ? MUS_NONE : mus_pattern_move_control(c->pattern, neck, 1, k == 0 ? bad : 0.1, k == 1 ? bad : 0.1);
}


static mus_status refuse_redraw_edge(const edit_case *c, int32_t k, double bad)
{
    static const int32_t kind = MUS_PIECE_CUBIC;
    double xy[4] = {0.05, 0.2, 0.03, 0.2};
    if (k >= 4) return MUS_NONE;
    xy[k] = bad;
    return mus_pattern_redraw_edge(c->pattern, c->cf, 1, &kind, 2, xy);
}


static mus_status refuse_split_edge(const edit_case *c, int32_t k, double bad)
{
    return k >= 1 ? MUS_NONE : mus_pattern_split_edge(c->pattern, c->cf, bad, NULL, NULL);
}


static mus_status refuse_notch_seam(const edit_case *c, int32_t k, double bad)
{
    return k >= 1 ? MUS_NONE : mus_pattern_notch_seam(c->pattern, c->cf, bad, MUS_NOTCH_SINGLE);
}


static mus_status refuse_fair_edge(const edit_case *c, int32_t k, double bad)
{
    return k >= 1 ? MUS_NONE : mus_pattern_fair_edge(c->pattern, c->cf, bad);
}


static const edit_call edit_calls[] = {refuse_add_dart,     refuse_rotate_dart, refuse_split_dart, refuse_shorten_dart,
                                       refuse_dart_to_seam, refuse_separate,    refuse_add_facing, refuse_spread,
                                       refuse_flare,        refuse_pleat,       refuse_lengthen,   refuse_move_point,
                                       refuse_move_control, refuse_redraw_edge, refuse_split_edge, refuse_fair_edge,
                                       refuse_lay_pleats,   refuse_add_patch,   refuse_notch_seam};


START_TEST(no_edit_takes_a_number_that_is_not_finite)
{
    static const double values[3] = {NAN, INFINITY, -INFINITY};
    mus_context *context = support_context();
    edit_case c = {.pattern = drafts_pattern(context, "bodice", "W40")};
    mus_pattern *copy;
    c.panel = mus_pattern_find_panel(c.pattern, "front_left");
    c.side = mus_pattern_find_edge(c.pattern, c.panel, "side1"),
    c.leg = mus_pattern_find_edge(c.pattern, c.panel, "bd1");
    c.shoulder = mus_pattern_find_edge(c.pattern, c.panel, "sh"),
    c.cf = mus_pattern_find_edge(c.pattern, c.panel, "cf");
    c.waist = mus_pattern_find_edge(c.pattern, c.panel, "w1");
    ck_assert(c.side >= 0 && c.leg >= 0 && c.shoulder >= 0 && c.cf >= 0 && c.waist >= 0);
    ck_assert_int_eq(mus_pattern_copy(c.pattern, &copy), MUS_OK);
    int32_t tried = 0;
    for (size_t i = 0; i < sizeof edit_calls / sizeof edit_calls[0]; i++) {
        for (int32_t k = 0; edit_calls[i](&c, k, (double)NAN) != MUS_NONE; k++) {
            for (int32_t v = 0; v < 3; v++, tried++) {
                const mus_status status = edit_calls[i](&c, k, values[v]);
                ck_assert_msg(status == MUS_ERR_ARG, "call %d, place %d, %g: status %d", (int)i, (int)k, values[v],
                              (int)status);
                ck_assert_str_ne(mus_context_error(context), "");
                same_pattern(c.pattern, copy);
            }
        }
    }
    ck_assert_int_eq(tried, 3 * 58);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(c.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(no_edit_takes_what_is_not_there)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "bodice", "W40"), *copy;
    ck_assert_int_eq(mus_pattern_copy(pattern, &copy), MUS_OK);
    const double at[2] = {0.05, 0.2};
    const int32_t far = mus_pattern_edge_count(pattern), bad[2] = {-1, far};
    int32_t out;
    double angle;
    mus_seam_walk walk;
    mus_seam_walk_init(&walk, sizeof walk);
    for (int32_t i = 0; i < 2; i++) {
        const int32_t e = bad[i];
        const int32_t targets[1] = {e};
        const double s[1] = {0.1}, part[1] = {0.5};
        ck_assert_int_eq(mus_pattern_dart(pattern, e, &angle, NULL, NULL), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_add_dart(pattern, e, 0.1, 0.01, at, &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_rotate_dart(pattern, e, 0, 0.1, 0, 1.0, &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_split_dart(pattern, 0, 1, targets, s, part, 0, &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_merge_darts(pattern, 0, e, 0, &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_shorten_dart(pattern, e, 0.01), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_release_dart(pattern, e, &out), MUS_ERR_ARG);
        ck_assert_int_eq(out, MUS_NONE);
        ck_assert_int_eq(mus_pattern_dart_to_seam(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "a",
                                                                          .seam_name = "b", .edge_a = e,
                                                                          .edge_b = 0, .s_b = 0.1}, &out, NULL),
                         MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "a",
                                                                      .seam_name = "b", .edge_a = 0, .s_a = 0.1,
                                                                      .edge_b = e, .s_b = 0.1}, &out, NULL),
                         MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_join_panels(pattern, e, &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_mirror_panel(pattern, e, "a", &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_unfold(pattern, e), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_add_facing(pattern, e, 0.05, "a", &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_remove_panel(pattern, e), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_remove_seam(pattern, e), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_spread(pattern, e, 0.1, 0, 0.1, 0.1, 0.1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_flare(pattern, 0, e, 2, 0.1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_flare(pattern, 0, 1, i == 0 ? 0 : 65, 0.1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_pleat(pattern, e, 0.1, 0, 0.1, 0.1, 0.1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_lengthen(pattern, e, at, at, 0.1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_move_point(pattern, e, 0.1, 0.1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_move_control(pattern, e, 1, 0.1, 0.1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_redraw_edge(pattern, e, 0, NULL, 0, NULL), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_fair_edge(pattern, e, 0.01), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_split_edge(pattern, e, 0.1, NULL, &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_merge_edges(pattern, e, &out), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_walk_seam(pattern, e, &walk), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_true_seam(pattern, e, 0, 1), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_true_seam(pattern, 0, e, 1), MUS_ERR_ARG);
        same_pattern(pattern, copy);
    }
    ck_assert_int_eq(mus_pattern_keep_history(pattern, -1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_keep_history(pattern, 1001), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_redraw_edge(pattern, 0, 2, NULL, 3, at), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_redraw_edge(pattern, 0, -1, NULL, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lengthen(pattern, 0, NULL, at, 0.1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_dart(pattern, 0, 0.1, 0.01, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_walk_seam(pattern, 0, NULL), MUS_ERR_ARG);
    walk.size = 3;
    ck_assert_int_eq(mus_pattern_walk_seam(pattern, 0, &walk), MUS_ERR_VERSION);
    same_pattern(pattern, copy);

    /* and no pattern at all */
    ck_assert_int_eq(mus_pattern_keep_history(NULL, 3), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_undo(NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_redo(NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_undo_count(NULL) + mus_pattern_redo_count(NULL), 0);
    ck_assert_int_eq(mus_pattern_rotate_dart(NULL, 0, 0, 0.1, 0, 1.0, &out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_split_dart(NULL, 0, 0, NULL, NULL, NULL, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_separate(NULL, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "a",
                                                               .seam_name = "b", .edge_a = 0, .s_a = 0.1,
                                                               .edge_b = 0, .s_b = 0.1}, &out, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lengthen(NULL, 0, at, at, 0.1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_walk_seam(NULL, 0, &walk), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_dart(NULL, 0, NULL, NULL, NULL), MUS_ERR_ARG);
    mus_seam_walk_init(NULL, sizeof walk);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_edit(void)
{
    Suite *suite = suite_create("refused_edit");
    TCase *tcase = tcase_create("refused_edit");
    tcase_add_test(tcase, no_edit_takes_a_number_that_is_not_finite);
    tcase_add_test(tcase, no_edit_takes_what_is_not_there);
    suite_add_tcase(suite, tcase);
    return suite;
}
