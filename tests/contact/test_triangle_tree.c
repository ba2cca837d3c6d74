/*
 * test_triangle_tree.c: the tree of boxes that `muslin bench` holds contact against: it is right, and agrees with
 * depths.
 */
#include <math.h>
#include <stdlib.h>

#include "bench/triangle_tree.h"
#include "body/people.h"

Suite *mus_suite_triangle_tree(void);


/* distances to random triangles against the least over all, each sampled finely from above and never below */
START_TEST(the_tree_finds_the_nearest_triangle)
{
    enum { T = 60, FINE = 40 };
    double x[9 * T];
    int32_t triangle[3 * T];
    uint64_t random = 5;
    tree t;
    for (int i = 0; i < 9 * T; i++) x[i] = support_uniform(&random, -1.0, 1.0);
    for (int i = 0; i < 3 * T; i++) triangle[i] = i;
    ck_assert_int_eq(tree_make(x, T, triangle, &t), 1);
    for (int k = 0; k < 50; k++) {
        double p[3], least = INFINITY;
        for (int d = 0; d < 3; d++) p[d] = support_uniform(&random, -1.5, 1.5);
        for (int i = 0; i < T; i++)
            for (int a = 0; a <= FINE; a++)
                for (int b = 0; a + b <= FINE; b++) {
                    double away2 = 0.0;
                    for (int d = 0; d < 3; d++) {
                        const double *c = x + 9 * i + d;
                        const double q = c[0] + a * (c[3] - c[0]) / FINE + b * (c[6] - c[0]) / FINE;
                        away2 += (q - p[d]) * (q - p[d]);
                    }
                    least = fmin(least, sqrt(away2));
                }
        const double found = tree_distance(&t, p);
        ck_assert_double_le(found, least + 1e-12);
        ck_assert_double_ge(found, least - 0.05);
    }
    tree_free(&t);
}
END_TEST


/* a centimetre and less off a body made of 100,000 triangles: the tree's distance is the depth */
START_TEST(depths_are_distances_to_the_surface)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    const int32_t n = mus_body_vertex_count(body);
    const double *x = mus_body_vertices(body), *normal = mus_body_normals(body);
    uint64_t random = 6;
    double off[400];
    int32_t count = 0;
    tree t;
    ck_assert_int_eq(tree_make(x, mus_body_triangle_count(body), mus_body_triangles(body), &t), 1);
    while (count < 400) {
        const ptrdiff_t v = 3 * (ptrdiff_t)support_uniform(&random, 0.0, n);
        const double out = support_uniform(&random, 1e-3, 1e-2);
        const double p[3] = {x[v] + out * normal[v], x[v + 1] + out * normal[v + 1], x[v + 2] + out * normal[v + 2]};
        double depth;
        ck_assert_int_eq(mus_body_depth(body, 1, p, &depth, NULL), MUS_OK);
        if (fabs(depth + out) > 5e-3) continue; /* within another limb, or between two */
        off[count++] = fabs(tree_distance(&t, p) + depth);
    }
    double sum = 0.0;
    for (int i = 0; i < count; i++) sum += off[i] / count;
    ck_assert_double_le(sum, 5e-4);
    tree_free(&t);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_triangle_tree(void)
{
    Suite *suite = suite_create("triangle_tree");
    TCase *tests = tcase_create("tree");
    tcase_add_test(tests, the_tree_finds_the_nearest_triangle);
    tcase_add_test(tests, depths_are_distances_to_the_surface);
    suite_add_tcase(suite, tests);
    return suite;
}
