/* test_nest.c: polygons on a strip: none share a point, all are within it, the same for any number of threads. */
#include <math.h>
#include <string.h>

#include "nest/nest.h"
#include "support.h"

Suite *mus_suite_nest(void);

#define MOST 40

typedef struct problem {
    int32_t n;
    double xy[MOST][2][24]; /* of each item as drawn and by half a turn */
    mus__nest_way ways[MOST][2];
    mus__nest_item items[MOST];
    mus__nest_def def;
    mus__nest_place places[MOST];
    double length;
    int64_t steps;
    int32_t bad;
} problem;


/* an item of `n` points, and the same by half a turn */
static void add(problem *p, int32_t n, const double *xy)
{
    const int32_t i = p->n++;
    for (int32_t k = 0; k < 2 * n; k++) {
        p->xy[i][0][k] = xy[k];
        p->xy[i][1][k] = -xy[k];
    }
    for (int32_t k = 0; k < 2; k++) {
        p->ways[i][k].n = n;
        p->ways[i][k].xy = p->xy[i][k];
    }
    p->items[i].nway = 2;
    p->items[i].ways = p->ways[i];
}


static void begin(problem *p, double height, int64_t steps)
{
    memset(p, 0, sizeof *p);
    p->def.height = height, p->def.steps = steps;
    p->def.runs = p->def.threads = 1, p->def.seed = 1;
}


/* stars with 4 to 12 points round a centre: simple, mostly not convex */
static void add_stars(problem *p, int32_t count, uint64_t *seed)
{
    for (int32_t i = 0; i < count; i++) {
        double xy[24];
        const int32_t n = 4 + (int32_t)(support_random(seed) % 9);
        const double size = support_uniform(seed, 0.1, 0.4);
        for (int32_t k = 0; k < n; k++) {
            const double r = size * support_uniform(seed, 0.3, 1.0), a = 6.283185307179586 * k / n;
            xy[2 * k] = r * cos(a), xy[2 * k + 1] = r * sin(a);
        }
        add(p, n, xy);
    }
}


static mus_status solve(mus_context *context, problem *p)
{
    return mus__nest_solve(context, p->n, p->items, &p->def, p->places, &p->length, &p->steps, &p->bad);
}


static int32_t outline(const problem *p, int32_t i, double *out)
{
    const mus__nest_way *way = &p->ways[i][p->places[i].way];
    for (int32_t k = 0; k < way->n; k++) {
        out[2 * k] = way->xy[2 * k] + p->places[i].x;
        out[2 * k + 1] = way->xy[2 * k + 1] + p->places[i].y;
    }
    return way->n;
}


/* sides of one cross sides of the other, in long double: near enough to exact to see any overlap that is drawn */
static bool sides_meet(int32_t n, const double *a, int32_t m, const double *b)
{
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < m; j++) {
            const double *p = a + 2 * i, *q = a + 2 * ((i + 1) % n), *r = b + 2 * j, *s = b + 2 * ((j + 1) % m);
            const long double one = ((long double)q[0] - p[0]) * ((long double)r[1] - p[1]) -
                                    ((long double)q[1] - p[1]) * ((long double)r[0] - p[0]);
            const long double two = ((long double)q[0] - p[0]) * ((long double)s[1] - p[1]) -
                                    ((long double)q[1] - p[1]) * ((long double)s[0] - p[0]);
            const long double three = ((long double)s[0] - r[0]) * ((long double)p[1] - r[1]) -
                                      ((long double)s[1] - r[1]) * ((long double)p[0] - r[0]);
            const long double four = ((long double)s[0] - r[0]) * ((long double)q[1] - r[1]) -
                                     ((long double)s[1] - r[1]) * ((long double)q[0] - r[0]);
            if (one * two < 0.0L && three * four < 0.0L) return true;
        }
    return false;
}


/* no two share a point, none leaves the strip */
static void ensure_layout(const problem *p)
{
    double a[24], b[24];
    for (int32_t i = 0; i < p->n; i++) {
        const int32_t n = outline(p, i, a);
        for (int32_t k = 0; k < n; k++) {
            ck_assert(a[2 * k] > -1e-9 && a[2 * k] < p->length + 1e-9);
            ck_assert(a[2 * k + 1] > -1e-9 && a[2 * k + 1] < p->def.height + 1e-9);
        }
        for (int32_t j = 0; j < i; j++) {
            const int32_t m = outline(p, j, b);
            ck_assert_msg(!mus__nest_exact_meets(n, a, m, b), "items %d and %d share a point", i, j);
            ck_assert_msg(!sides_meet(n, a, m, b), "sides of items %d and %d cross", i, j);
        }
    }
}


START_TEST(items_share_no_point_and_lie_within_the_strip)
{
    mus_context *context = support_context();
    uint64_t seed = (uint64_t)_i + 1;
    problem p;
    begin(&p, 1.0, 20000000);
    add_stars(&p, 3 + 7 * _i, &seed);
    ck_assert_int_eq(solve(context, &p), MUS_OK);
    ensure_layout(&p);
    ck_assert(p.steps > 0 && p.bad == MUS_NONE);
    support_context_end(context);
}
END_TEST


/* 12 rectangles of 0.3 x 0.2 on a strip of 0.61: four columns of three; touching is not allowed, so a little more */
START_TEST(rectangles_that_tile_are_laid_nearly_without_loss)
{
    static const double rectangle[8] = {0.0, 0.0, 0.3, 0.0, 0.3, 0.2, 0.0, 0.2};
    mus_context *context = support_context();
    problem p;
    begin(&p, 0.61, 200000000);
    for (int i = 0; i < 12; i++) add(&p, 4, rectangle);
    ck_assert_int_eq(solve(context, &p), MUS_OK);
    ensure_layout(&p);
    ck_assert_msg(p.length > 1.2 * 0.6 / 0.61 && p.length < 1.215, "length %g", p.length);
    support_context_end(context);
}
END_TEST


/* two triangles make a square; only one of them turned does */
START_TEST(items_are_turned_where_that_is_shorter)
{
    static const double triangle[6] = {0.0, 0.0, 1.0, 0.0, 0.0, 1.0};
    mus_context *context = support_context();
    problem p;
    begin(&p, 1.01, 20000000);
    for (int i = 0; i < 2; i++) add(&p, 3, triangle);
    ck_assert_int_eq(solve(context, &p), MUS_OK);
    ensure_layout(&p);
    ck_assert(p.places[0].way != p.places[1].way && p.length < 1.02);
    for (int i = 0; i < 2; i++) p.items[i].nway = 1;
    ck_assert_int_eq(solve(context, &p), MUS_OK);
    ck_assert(p.length > 1.9);
    support_context_end(context);
}
END_TEST


START_TEST(the_result_does_not_depend_on_threads_but_on_the_seed)
{
    mus_context *context = support_context();
    static problem one, other;
    for (int threads = 1; threads <= 4; threads++) {
        uint64_t seed = 5;
        begin(&other, 1.0, 3000000);
        add_stars(&other, 12, &seed);
        other.def.runs = 3, other.def.threads = threads;
        ck_assert_int_eq(solve(context, &other), MUS_OK);
        if (threads == 1) one = other;
        ck_assert(one.length == other.length && one.steps == other.steps);
        ck_assert_int_eq(memcmp(one.places, other.places, sizeof one.places), 0);
    }
    other.def.seed = 2;
    ck_assert_int_eq(solve(context, &other), MUS_OK);
    ck_assert(one.length != other.length);
    /* more runs are never worse */
    const double three = one.length;
    one.def.runs = 1;
    ck_assert_int_eq(solve(context, &one), MUS_OK);
    ck_assert(one.length >= three);
    support_context_end(context);
}
END_TEST


START_TEST(items_on_the_edge_and_on_stripes_lie_there)
{
    mus_context *context = support_context();
    uint64_t seed = 9;
    problem p;
    begin(&p, 1.0, 10000000);
    add_stars(&p, 10, &seed);
    p.def.stripe = 0.13;
    for (int32_t i = 0; i < p.n; i++) {
        p.items[i].edge = i % 3 == 0;
        for (int k = 0; k < 2; k++) p.ways[i][k].stripe = k == 0 ? 0.03 : -0.03;
    }
    ck_assert_int_eq(solve(context, &p), MUS_OK);
    ensure_layout(&p);
    for (int32_t i = 0; i < p.n; i++) {
        double xy[24], low = HUGE_VAL;
        const int32_t n = outline(&p, i, xy);
        for (int32_t k = 0; k < n; k++) low = fmin(low, xy[2 * k + 1]);
        if (i % 3 == 0) ck_assert(fabs(low) < 1e-9);
        const double at = (p.places[i].x + p.ways[i][p.places[i].way].stripe) / 0.13;
        ck_assert_msg(fabs(at - nearbyint(at)) < 1e-6, "item %d is on stripe %g", i, at);
    }
    support_context_end(context);
}
END_TEST


START_TEST(an_item_wider_than_the_strip_is_told)
{
    mus_context *context = support_context();
    uint64_t seed = 3;
    problem p;
    begin(&p, 1.0, 1000000);
    add_stars(&p, 4, &seed);
    for (int k = 0; k < 24; k++) p.xy[2][0][k] *= 20.0, p.xy[2][1][k] *= 20.0;
    ck_assert_int_eq(solve(context, &p), MUS_ERR_ARG);
    ck_assert_int_eq(p.bad, 2);
    support_context_end(context);
}
END_TEST


static int32_t stop_later(void *user, double done, double length)
{
    ck_assert(done >= 0.0 && done <= 1.0 && length > 0.0);
    return --*(int *)user == 0;
}


START_TEST(a_search_that_is_stopped_gives_the_layout_so_far)
{
    mus_context *context = support_context();
    uint64_t seed = 4;
    int calls = 2;
    problem p;
    begin(&p, 1.0, 1000000000);
    add_stars(&p, 20, &seed);
    p.def.progress = stop_later, p.def.user = &calls, p.def.runs = 2;
    ck_assert_int_eq(solve(context, &p), MUS_OK);
    ck_assert_int_eq(calls, 0);
    ck_assert(p.steps < 100000000);
    ensure_layout(&p);
    support_context_end(context);
}
END_TEST


START_TEST(failing_memory_leaves_nothing_behind)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        uint64_t seed = 6;
        problem p;
        begin(&p, 1.0, 100000);
        add_stars(&p, 5, &seed);
        p.def.runs = 2;
        support_fail_after(n, false);
        const mus_status status = solve(context, &p);
        support_fail_never();
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


/* whether two convex polygons on integers share a point: no side of either has all of the other strictly outside */
static bool convex_meet(int32_t n, const double *a, int32_t m, const double *b)
{
    for (int32_t round = 0; round < 2; round++) {
        for (int32_t i = 0; i < n; i++) {
            const double *p = a + 2 * i, *q = a + 2 * ((i + 1) % n);
            bool outside = true;
            for (int32_t j = 0; j < m; j++)
                outside = outside && (q[0] - p[0]) * (b[2 * j + 1] - p[1]) - (q[1] - p[1]) * (b[2 * j] - p[0]) < 0.0;
            if (outside) return false;
        }
        const double *held = a;
        a = b, b = held;
        const int32_t count = n;
        n = m, m = count;
    }
    return true;
}


/* triangles with small integer corners: they touch, share corners, lie in each other often */
START_TEST(sharing_a_point_is_exact)
{
    uint64_t seed = 7;
    int meet = 0;
    for (int k = 0; k < 20000; k++) {
        double xy[2][6];
        for (int t = 0; t < 2; t++) {
            double turn;
            do {
                for (int i = 0; i < 6; i++) xy[t][i] = (double)(support_random(&seed) % 7);
                turn = (xy[t][2] - xy[t][0]) * (xy[t][5] - xy[t][1]) - (xy[t][3] - xy[t][1]) * (xy[t][4] - xy[t][0]);
            } while (turn <= 0.0);
        }
        const bool expected = convex_meet(3, xy[0], 3, xy[1]);
        ck_assert_int_eq(mus__nest_exact_meets(3, xy[0], 3, xy[1]), expected);
        ck_assert_int_eq(mus__nest_exact_meets(3, xy[1], 3, xy[0]), expected);
        meet += expected;
    }
    ck_assert(meet > 5000 && meet < 19000);
}
END_TEST


Suite *mus_suite_nest(void)
{
    Suite *suite = suite_create("nest");
    TCase *tests = tcase_create("nest");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, items_share_no_point_and_lie_within_the_strip, 0, 5);
    tcase_add_test(tests, rectangles_that_tile_are_laid_nearly_without_loss);
    tcase_add_test(tests, items_are_turned_where_that_is_shorter);
    tcase_add_test(tests, the_result_does_not_depend_on_threads_but_on_the_seed);
    tcase_add_test(tests, items_on_the_edge_and_on_stripes_lie_there);
    tcase_add_test(tests, an_item_wider_than_the_strip_is_told);
    tcase_add_test(tests, a_search_that_is_stopped_gives_the_layout_so_far);
    tcase_add_test(tests, failing_memory_leaves_nothing_behind);
    tcase_add_test(tests, sharing_a_point_is_exact);
    suite_add_tcase(suite, tests);
    return suite;
}
