/* test_refused_layout.c: numbers that are not finite, or out of range, at the doors of a layout: refused by name. */
#include "muslin/layout.h"
#include "refused.h"

Suite *mus_suite_refused_layout(void);

static const double a_square[8] = {0.0, 0.0, 0.3, 0.0, 0.3, 0.3, 0.0, 0.3};


static mus_status try_layout(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_layout *layout = NULL;
    mus_layout_item item;
    mus_layout_item_init(&item, sizeof item);
    item.n = 4, item.xy = a_square;
    const mus_status status = mus_layout_create_items(context, 1, &item, def, &layout);
    ck_assert_int_eq(status == MUS_OK, layout != NULL);
    mus_layout_destroy(layout);
    return status;
}


START_TEST(a_layout_def_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {REFUSED(mus_layout_def, width, 1, false, "width"),
                                           REFUSED(mus_layout_def, gap, 1, false, "gap"),
                                           REFUSED(mus_layout_def, allowance, 1, false, "allowance"),
                                           REFUSED(mus_layout_def, tolerance, 1, false, "tolerance"),
                                           REFUSED(mus_layout_def, stripe, 1, false, "stripe")};
    mus_layout_def def;
    mus_layout_def_init(&def, sizeof def);
    def.steps = 100000;
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_layout, NULL);
}
END_TEST


START_TEST(a_count_out_of_range_is_refused_by_name)
{
    mus_context *context = support_context();
    for (int k = 0; k < 5; k++) {
        static const char *const words[] = {"runs is 0", "threads is 65", "steps is 1", "material is 5", "size"};
        mus_layout_def def;
        mus_layout_def_init(&def, sizeof def);
        if (k == 0) def.runs = 0;
        if (k == 1) def.threads = 65;
        if (k == 2) def.steps = 1;
        if (k == 3) def.material = MUS_MATERIAL_COUNT;
        if (k == 4) def.size = 3;
        ck_assert_int_eq(try_layout(context, &def, NULL), k == 4 ? MUS_ERR_VERSION : MUS_ERR_ARG);
        ck_assert_msg(strstr(mus_context_error(context), words[k]) != NULL, "%s", mus_context_error(context));
    }
    support_context_end(context);
}
END_TEST


/* mus_layout_item.xy and mus_layout_item.turns, and its counts */
START_TEST(an_item_out_of_range_is_refused_by_its_number)
{
    static const double values[] = {NAN, INFINITY, -INFINITY, 2e7};
    mus_context *context = support_context();
    for (int k = 0; k < 13; k++) {
        mus_layout *layout = NULL;
        mus_layout_item items[2];
        double xy[8], turns[1] = {0.0};
        memcpy(xy, a_square, sizeof xy);
        for (int i = 0; i < 2; i++) {
            mus_layout_item_init(&items[i], sizeof items[i]);
            items[i].n = 4, items[i].xy = a_square;
        }
        mus_layout_item *bad = &items[1];
        bad->xy = xy, bad->turns = turns, bad->turn_count = 1;
        if (k < 4) xy[5] = values[k];
        else if (k < 8) turns[0] = values[k - 4];
        else if (k == 8) bad->n = 2;
        else if (k == 9) bad->count = 0;
        else if (k == 10) bad->turns = NULL;
        else if (k == 11) xy[2] = xy[4] = 0.0;
        else bad->xy = NULL;
        ck_assert_int_eq(mus_layout_create_items(context, 2, items, NULL, &layout), MUS_ERR_ARG);
        ck_assert_msg(strstr(mus_context_error(context), "item 1") != NULL, "%d: %s", k, mus_context_error(context));
        ck_assert_ptr_null(layout);
    }
    support_context_end(context);
}
END_TEST


START_TEST(what_is_missing_is_refused)
{
    mus_context *context = support_context();
    mus_layout *layout = (mus_layout *)(void *)context;
    mus_layout_piece piece;
    mus_layout_item item;
    mus_layout_item_init(&item, sizeof item);
    item.n = 4, item.xy = a_square, item.count = 2001;
    ck_assert_int_eq(mus_layout_create(context, NULL, NULL, &layout), MUS_ERR_ARG);
    ck_assert_ptr_null(layout);
    ck_assert_int_eq(mus_layout_create_items(context, 0, &item, NULL, &layout), MUS_ERR_ARG);
    ck_assert_int_eq(mus_layout_create_items(context, 1, &item, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_layout_create_items(context, 1, &item, NULL, &layout), MUS_ERR_ARG);
    ck_assert_int_eq(mus_layout_piece_get(NULL, 0, &piece), MUS_ERR_ARG);
    ck_assert(mus_layout_length(NULL) == 0.0 && mus_layout_utilisation(NULL) == 0.0 && mus_layout_width(NULL) == 0.0);
    ck_assert(mus_layout_folded(NULL) == 0.0 && mus_layout_steps(NULL) == 0 && mus_layout_piece_count(NULL) == 0);
    ck_assert_ptr_null(mus_layout_context(NULL));
    item.count = 2;
    mus_layout_def def;
    mus_layout_def_init(&def, sizeof def);
    def.steps = 100000;
    ck_assert_int_eq(mus_layout_create_items(context, 1, &item, &def, &layout), MUS_OK);
    mus_layout_piece_init(&piece, sizeof piece);
    ck_assert_int_eq(mus_layout_piece_get(layout, 2, &piece), MUS_ERR_ARG);
    piece.size = 4;
    ck_assert_int_eq(mus_layout_piece_get(layout, 1, &piece), MUS_ERR_VERSION);
    mus_layout_destroy(layout);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_layout(void)
{
    Suite *suite = suite_create("refused_layout");
    TCase *tests = tcase_create("refused_layout");
    tcase_add_test(tests, a_layout_def_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, a_count_out_of_range_is_refused_by_name);
    tcase_add_test(tests, an_item_out_of_range_is_refused_by_its_number);
    tcase_add_test(tests, what_is_missing_is_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
