/*
 * test_outline_pack.c: outlines on a strip: inside, apart by the gap, none lost; hollows are used, and ways round.
 */
#include <math.h>

#include "print/outline_pack.h"
#include "support.h"

#define SHAPES 12

static mus_context *context;
static mus__shape shapes[SHAPES];
static mus__strip strip;
static int32_t count;


static void setup(void)
{
    context = support_context();
    count = 0;
}


static void clear(void)
{
    for (int32_t i = 0; i < count; i++) mus__shape_free(context, &shapes[i]);
    mus__strip_free(context, &strip);
    count = 0;
}


static void teardown(void)
{
    clear();
    support_context_end(context);
}


/* a polygon of n points with its low corner anywhere */
static void add(int32_t n, double *xy, double gap)
{
    int32_t start[2] = {0, n};
    double box[4] = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    const mus__loops loops = {1, n, start, xy}, *list[1] = {&loops};
    for (int32_t i = 0; i < 2 * n; i++) {
        box[i % 2] = fmin(box[i % 2], xy[i]);
        box[2 + i % 2] = fmax(box[2 + i % 2], xy[i]);
    }
    ck_assert_int_eq(mus__shape_make(context, 1, list, box, gap, 0.001, &shapes[count++]), MUS_OK);
}


static void add_box(double width, double height, double gap)
{
    double xy[8] = {0.3, 0.1, 0.3 + width, 0.1, 0.3 + width, 0.1 + height, 0.3, 0.1 + height};
    add(4, xy, gap);
}


static double pack(double width, double gap, mus__place *places)
{
    int32_t order[SHAPES];
    for (int32_t i = 0; i < count; i++) order[i] = i;
    ck_assert_int_eq(mus__strip_make(context, count, shapes, width + 1.0, &strip), MUS_OK);
    return mus__strip_pack(&strip, count, shapes, order, width, gap, places);
}


START_TEST(boxes_lie_inside_the_strip_and_apart)
{
    uint64_t seed = 7;
    for (int32_t round = 0; round < 20; round++) {
        mus__place at[SHAPES];
        double size[2 * SHAPES], area = 0.0, gap = support_uniform(&seed, 0.0, 0.02), most = 0.0;
        const int32_t n = 1 + (int32_t)(support_random(&seed) % SHAPES);
        for (int32_t i = 0; i < n; i++) {
            for (int32_t k = 0; k < 2; k++)
                size[2 * i + k] = round % 2 ? 0.1 * (double)(1 + support_random(&seed) % 4)
                                            : support_uniform(&seed, 0.01, 0.4 + 0.2 * k);
            add_box(size[2 * i], size[2 * i + 1], gap);
            shapes[i].turns = shapes[i].flips = round % 3 == 0;
            area += size[2 * i] * size[2 * i + 1];
        }
        const double high = pack(1.0, gap, at);
        ck_assert_double_ge(high, area - 1e-9);
        for (int32_t i = 0; i < n; i++) {
            ck_assert_double_ge(at[i].x, -1e-9);
            ck_assert_double_ge(at[i].y, -1e-9);
            ck_assert_double_le(at[i].x + size[2 * i], 1.0 + 1e-8);
            most = fmax(most, at[i].y + size[2 * i + 1]);
            for (int32_t j = 0; j < i; j++) {
                const double across = fmax(at[i].x - at[j].x - size[2 * j], at[j].x - at[i].x - size[2 * i]);
                const double up = fmax(at[i].y - at[j].y - size[2 * j + 1], at[j].y - at[i].y - size[2 * i + 1]);
                ck_assert_double_ge(fmax(across, up), gap - 1e-8);
            }
        }
        ck_assert_double_eq_tol(most, high, 1e-9);
        clear();
    }
}
END_TEST


START_TEST(a_box_goes_into_the_hollow_of_another_piece)
{
    /* a yoke, open to the right: the box fits between its arms */
    double yoke[] = {0, 0, 0.5, 0, 0.5, 0.1, 0.1, 0.1, 0.1, 0.4, 0.5, 0.4, 0.5, 0.5, 0, 0.5};
    mus__place at[SHAPES];
    add(8, yoke, 0.01);
    add_box(0.3, 0.25, 0.01);
    ck_assert_double_eq_tol(pack(0.51, 0.01, at), 0.5, 1e-9);
    ck_assert_double_ge(at[1].y, 0.11 - 1e-9);
    ck_assert_double_le(at[1].y + 0.25, 0.39 + 1e-9);
    ck_assert_double_ge(at[1].x, 0.11 - 1e-9);
}
END_TEST


START_TEST(a_turned_wedge_lies_beside_its_like)
{
    /* wedges 0.3 m wide at one end, 0.1 at the other: two fit on 0.42 m when one is turned, also where it may be
     * mirrored */
    for (int32_t flips = 0; flips < 2; flips++) {
        double wedge[] = {0, 0, 0.3, 0, 0.1, 0.8, 0, 0.8};
        mus__place at[SHAPES];
        add(4, wedge, 0.0);
        add(4, wedge, 0.0);
        shapes[1].turns = true;
        shapes[1].flips = flips != 0;
        ck_assert_double_eq_tol(pack(0.42, 0.0, at), 0.8, 1e-9);
        ck_assert(at[1].flip[0] && at[1].flip[1]);
        ck_assert_double_ge(at[1].x, 0.1 - 1e-9);
        clear();
    }
}
END_TEST


START_TEST(a_shape_wider_than_the_strip_is_refused)
{
    mus__place at[SHAPES];
    add_box(0.2, 0.2, 0.0);
    add_box(1.01, 0.1, 0.0);
    ck_assert_double_lt(pack(1.0, 0.0, at), 0.0);
}
END_TEST


START_TEST(a_shape_lies_where_it_finds_no_room_upright)
{
    /* the box and, as its lying form, the same turned by a quarter */
    mus__place at[SHAPES];
    add_box(0.9, 0.2, 0.0);
    add_box(0.2, 0.9, 0.0);
    shapes[0].lying = &shapes[1];
    const int32_t all = count;
    count = 1;
    ck_assert_double_eq_tol(pack(0.5, 0.0, at), 0.9, 1e-9);
    ck_assert(at[0].quarter);
    count = all;
}
END_TEST


START_TEST(shapes_take_the_pages_that_are_taken)
{
    /* pages of 0.5 m: nearest to the top the last box takes a fourth page, below the second box it takes none anew */
    for (int32_t by_page = 0; by_page < 2; by_page++) {
        int32_t seen[20] = {0};
        mus__pages pages = {.step = {0.5, 0.5}, .columns = 2, .rows = 10, .seen = seen};
        mus__place at[SHAPES];
        add_box(0.9, 0.4, 0.0);
        add_box(0.45, 0.4, 0.0);
        add_box(0.3, 0.15, 0.0);
        int32_t order[SHAPES] = {0, 1, 2}, taken = 0;
        ck_assert_int_eq(mus__strip_make(context, count, shapes, 2.0, &strip), MUS_OK);
        if (by_page) strip.pages = &pages;
        mus__strip_pack(&strip, count, shapes, order, 0.999, 0.0, at);
        ck_assert_double_eq_tol(at[2].y, by_page ? 0.8 : 0.4, 1e-9);
        for (int32_t i = 0; i < 20; i++) taken += seen[i] == -1;
        ck_assert_int_eq(taken, by_page ? 3 : 0);
        clear();
    }
}
END_TEST


Suite *mus_suite_outline_pack(void);
Suite *mus_suite_outline_pack(void)
{
    Suite *suite = suite_create("outline_pack");
    TCase *test = tcase_create("pack");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, boxes_lie_inside_the_strip_and_apart);
    tcase_add_test(test, a_box_goes_into_the_hollow_of_another_piece);
    tcase_add_test(test, a_turned_wedge_lies_beside_its_like);
    tcase_add_test(test, a_shape_wider_than_the_strip_is_refused);
    tcase_add_test(test, a_shape_lies_where_it_finds_no_room_upright);
    tcase_add_test(test, shapes_take_the_pages_that_are_taken);
    suite_add_tcase(suite, test);
    return suite;
}
