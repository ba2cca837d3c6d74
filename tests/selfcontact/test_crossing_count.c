/*
 * test_crossing_count.c: whether cloth goes through cloth, against whole numbers that cannot round and against asking
 * every triangle of every other.
 */
#include <stdlib.h>
#include <string.h>

#include "selfcontact/crossing_count.h"
#include "support.h"

Suite *mus_suite_crossing_count(void);

#define TRIANGLES 160


static int64_t volume(const int64_t *a, const int64_t *b, const int64_t *c, const int64_t *d)
{
    int64_t m[3][3];
    for (int k = 0; k < 3; k++) m[0][k] = a[k] - d[k], m[1][k] = b[k] - d[k], m[2][k] = c[k] - d[k];
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}


/* places p + t (q - p) = a + u (b - a) + v (c - a) by Cramer's rule in whole numbers; off the triangle's plane only */
static int meets(const int64_t (*p)[3])
{
    int64_t det, n[3], u[3], v[3], way[3], from[3], t = 0, share[2];
    for (int k = 0; k < 3; k++) {
        u[k] = p[3][k] - p[2][k], v[k] = p[4][k] - p[2][k], way[k] = p[1][k] - p[0][k], from[k] = p[2][k] - p[0][k];
    }
    for (int k = 0; k < 3; k++) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    det = n[0] * way[0] + n[1] * way[1] + n[2] * way[2];
    for (int k = 0; k < 3; k++) t += n[k] * from[k];
    const int64_t sign = det < 0 ? -1 : 1;
    if (sign * t < 0 || sign * t > sign * det) return 0;
    for (int s = 0; s < 2; s++) {
        /* volume of the other side with the way, and the start */
        const int64_t *side = s ? u : v;
        int64_t sum = 0;
        for (int k = 0; k < 3; k++) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            sum += (side[i] * way[j] - side[j] * way[i]) * from[k];
        }
        share[s] = s ? sum : -sum;
    }
    share[0] *= sign, share[1] *= sign;
    return share[0] >= 0 && share[1] >= 0 && share[0] + share[1] <= sign * det;
}


START_TEST(a_segment_meets_a_triangle_as_in_whole_numbers)
{
    /* few places, so that many touch at corners and along edges */
    uint64_t state = 11;
    int met = 0, missed = 0, flat = 0;
    for (int i = 0; i < 200000; i++) {
        int64_t p[5][3];
        double x[5][3];
        for (int k = 0; k < 15; k++) {
            p[k / 3][k % 3] = (int64_t)(support_random(&state) % 7);
            x[k / 3][k % 3] = (double)p[k / 3][k % 3] / 1024.0;
        }
        const int32_t got = mus__segment_meets_triangle(x[0], x[1], x[2], x[3], x[4]);
        if (volume(p[2], p[3], p[4], p[0]) == volume(p[2], p[3], p[4], p[1])) {
            flat++; /* along the plane, or no triangle */
            continue;
        }
        const int want = meets((const int64_t(*)[3])p);
        ck_assert_int_eq(got, want);
        met += want, missed += !want;
    }
    ck_assert_int_gt(met, 5000);
    ck_assert_int_gt(missed, 50000);
    ck_assert_int_gt(flat, 5000);
}
END_TEST


START_TEST(in_the_plane_a_segment_meets_what_it_covers)
{
    const double a[] = {0, 0, 1}, b[] = {4, 0, 1}, c[] = {0, 4, 1};
    const struct {
        double p[3], q[3];
        int meets;
    } row[] = {
        {{1, 1, 1}, {2, 1, 1}, 1},    {{-1, 1, 1}, {5, 1, 1}, 1},   {{3, 3, 1}, {5, 5, 1}, 0},
        {{2, 2, 1}, {5, 5, 1}, 1},    {{4, 0, 1}, {9, 0, 1}, 1},    {{5, 0, 1}, {9, 0, 1}, 0},
        {{-1, 0, 1}, {0, -1, 1}, 0},  {{0, 0, 1}, {-1, -1, 1}, 1},  {{1, 1, 2}, {2, 1, 2}, 0},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        ck_assert_int_eq(mus__segment_meets_triangle(row[i].p, row[i].q, a, b, c), row[i].meets);
        ck_assert_int_eq(mus__segment_meets_triangle(row[i].q, row[i].p, b, c, a), row[i].meets);
    }
}
END_TEST


/* triangles by chance, some with corners in common, from tiny to as large as the box they are in */
static void soup(uint64_t *state, int32_t *triangle, double *x)
{
    for (int t = 0; t < TRIANGLES; t++) {
        const double size = support_uniform(state, 0.01, t % 8 == 0 ? 1.0 : 0.2);
        double middle[3];
        for (int d = 0; d < 3; d++) middle[d] = support_uniform(state, -0.5, 0.5);
        for (int k = 0; k < 3; k++) {
            const int32_t node = 3 * t + k;
            triangle[node] = t > 0 && k == 0 && t % 3 == 0 ? triangle[node - 3] : node;
            for (int d = 0; d < 3; d++) x[3 * node + d] = middle[d] + size * support_uniform(state, -0.5, 0.5);
        }
    }
}


static int share(const int32_t *triangle, const int32_t *class_of, int32_t node, int32_t t)
{
    for (int k = 0; k < 3; k++)
        if (class_of[triangle[3 * t + k]] == class_of[node]) return 1;
    return 0;
}


static int edges_meet(const int32_t *triangle, const int32_t *class_of, const double *x, int32_t s, int32_t t)
{
    int found = 0;
    for (int k = 0; k < 3; k++) {
        const int32_t p = triangle[3 * s + k], q = triangle[3 * s + (k + 1) % 3], *c = triangle + 3 * t;
        if (share(triangle, class_of, p, t) || share(triangle, class_of, q, t)) continue;
        found += mus__segment_meets_triangle(x + 3 * p, x + 3 * q, x + 3 * c[0], x + 3 * c[1], x + 3 * c[2]);
    }
    return found;
}


static void count_calls(void *user, int32_t p, int32_t q, int32_t of, int32_t met)
{
    (void)p, (void)q, (void)of, (void)met;
    ++*(int64_t *)user;
}


START_TEST(crossings_are_those_of_every_triangle_with_every_other)
{
    mus_context *context = support_context();
    mus__box_grid grid;
    ck_assert_int_eq(mus__box_grid_create(context, TRIANGLES, &grid), MUS_OK);
    uint64_t state = 5;
    int64_t all = 0;
    for (int round = 0; round < 40; round++) {
        int32_t triangle[3 * TRIANGLES], class_of[3 * TRIANGLES];
        double x[9 * TRIANGLES];
        soup(&state, triangle, x);
        for (int i = 0; i < 3 * TRIANGLES; i++) class_of[i] = round % 2 && i % 7 == 0 && i > 9 ? i - 9 : i;
        int64_t want = 0, edges = 0, calls = 0;
        for (int s = 0; s < TRIANGLES; s++)
            for (int t = s + 1; t < TRIANGLES; t++) {
                const int found = edges_meet(triangle, class_of, x, s, t) + edges_meet(triangle, class_of, x, t, s);
                want += found > 0;
                edges += found;
            }
        const int64_t got = mus__crossing_count(&grid, TRIANGLES, triangle, class_of, x, count_calls, &calls);
        ck_assert_int_eq(got, want);
        ck_assert_int_eq(calls, edges);
        all += want;
    }
    ck_assert_int_gt(all, 2000);
    mus__box_grid_destroy(context, &grid);
    support_context_end(context);
}
END_TEST


typedef struct met {
    int32_t n, seen[TRIANGLES * TRIANGLES];
} met;


static void mark(void *user, int32_t a, int32_t b)
{
    met *m = user;
    ck_assert_int_lt(a, b);
    m->seen[a * TRIANGLES + b]++;
}


START_TEST(the_grid_finds_every_near_pair_once)
{
    mus_context *context = support_context();
    mus__box_grid grid;
    met *m = calloc(1, sizeof *m);
    ck_assert_int_eq(mus__box_grid_create(context, TRIANGLES, &grid), MUS_OK);
    uint64_t state = 8;
    for (int round = 0; round < 30; round++) {
        const double wide = round % 3 == 0 ? 100.0 : 1.0;
        const float reach = (float)support_uniform(&state, 0.0, 0.1 * wide);
        memset(m->seen, 0, sizeof m->seen);
        for (int i = 0; i < TRIANGLES; i++)
            for (int d = 0; d < 3; d++) {
                const double low = support_uniform(&state, -wide, wide);
                grid.box[6 * i + d] = (float)low;
                grid.box[6 * i + 3 + d] = (float)(low + support_uniform(&state, 0.0, 0.3));
            }
        mus__box_grid_pairs(&grid, TRIANGLES, reach, mark, m);
        for (int a = 0; a < TRIANGLES; a++)
            for (int b = a + 1; b < TRIANGLES; b++) {
                int near = 1;
                for (int d = 0; d < 3; d++)
                    near &= grid.box[6 * b + d] - grid.box[6 * a + 3 + d] <= reach - 1e-5f &&
                            grid.box[6 * a + d] - grid.box[6 * b + 3 + d] <= reach - 1e-5f;
                ck_assert_int_le(m->seen[a * TRIANGLES + b], 1);
                ck_assert_int_ge(m->seen[a * TRIANGLES + b], near);
            }
    }
    mus__box_grid_destroy(context, &grid);
    free(m);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_crossing_count(void)
{
    Suite *suite = suite_create("crossing_count");
    TCase *tests = tcase_create("cloth_crossing");
    tcase_add_test(tests, a_segment_meets_a_triangle_as_in_whole_numbers);
    tcase_add_test(tests, in_the_plane_a_segment_meets_what_it_covers);
    tcase_add_test(tests, crossings_are_those_of_every_triangle_with_every_other);
    tcase_add_test(tests, the_grid_finds_every_near_pair_once);
    suite_add_tcase(suite, tests);
    return suite;
}
