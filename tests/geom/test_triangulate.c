/*
 * test_triangulate.c: constrained Delaunay triangulations against their definition, on random polygons, lattices,
 * slits and straps; polygons that are not simple are refused with a sentence.
 */
#include "support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/polygon.h"
#include "geom/predicate.h"
#include "geom/triangulate.h"
#include "geom/vec.h"

typedef struct edge {
    int32_t a, b, opposite; /* as the triangle runs */
} edge;


static int by_ends(const void *left, const void *right)
{
    const edge *p = left, *q = right;
    return p->a != q->a ? (p->a < q->a ? -1 : 1) : (p->b > q->b) - (p->b < q->b);
}


static const edge *find(const edge *edges, int32_t n, int32_t a, int32_t b)
{
    edge key = {a, b, 0};
    return bsearch(&key, edges, (size_t)n, sizeof key, by_ends);
}


static bool is_side(int32_t nborder, int32_t nside, const int32_t *sides, int32_t a, int32_t b)
{
    for (int32_t s = 0; s < nside; s++)
        if ((sides[2 * s] == a && sides[2 * s + 1] == b) || (sides[2 * s] == b && sides[2 * s + 1] == a)) return true;
    return a < nborder && b < nborder && ((a + 1) % nborder == b || (b + 1) % nborder == a);
}


/*
 * The definition: triangles run counter-clockwise; every edge has its other half but for the border, which has one;
 * sides are edges; across an edge that is no side the circumcircle is empty; areas add up; Euler's count.
 */
static void check_mesh(int32_t n, const double *xy, int32_t nborder, int32_t nside, const int32_t *sides,
                       const int32_t *triangles, int32_t count)
{
    ck_assert_int_eq(count, nborder - 2 + 2 * (n - nborder));
    edge *edges = malloc(3 * (size_t)count * sizeof *edges);
    double area = 0.0;
    for (int32_t t = 0; t < count; t++) {
        const int32_t *v = triangles + 3 * t;
        ck_assert(mus__orient2d(xy + 2 * v[0], xy + 2 * v[1], xy + 2 * v[2]) > 0.0);
        const double corner[6] = {xy[2 * v[0]],     xy[2 * v[0] + 1], xy[2 * v[1]],
                                  xy[2 * v[1] + 1], xy[2 * v[2]],     xy[2 * v[2] + 1]};
        area += mus__polygon_area(3, corner);
        for (int k = 0; k < 3; k++) edges[3 * t + k] = (edge){v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
    }
    double want = fabs(mus__polygon_area(nborder, xy));
    ck_assert_double_le(fabs(area - want), 1e-12 * want);

    qsort(edges, 3 * (size_t)count, sizeof *edges, by_ends);
    for (int32_t i = 0; i < 3 * count; i++) {
        const edge *e = &edges[i], *other = find(edges, 3 * count, e->b, e->a);
        if (i > 0) ck_assert_int_ne(by_ends(e - 1, e), 0);
        bool border = is_side(nborder, 0, NULL, e->a, e->b);
        ck_assert_int_eq(other == NULL, border);
        if (other == NULL || is_side(nborder, nside, sides, e->a, e->b)) continue;
        ck_assert(mus__incircle(xy + 2 * e->a, xy + 2 * e->b, xy + 2 * e->opposite, xy + 2 * other->opposite) <= 0.0);
    }
    for (int32_t s = 0; s < nside; s++) ck_assert(find(edges, 3 * count, sides[2 * s], sides[2 * s + 1]) != NULL);
    free(edges);
}


static void check_triangulates(mus_context *context, int32_t n, const double *xy, int32_t nborder, int32_t nside,
                               const int32_t *sides)
{
    int32_t *triangles, count;
    mus_status status = mus__triangulate(context, n, xy, nborder, nside, sides, &triangles, &count);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    check_mesh(n, xy, nborder, nside, sides, triangles, count);
    mus__free(context, triangles);
}


/* random points inside the polygon, behind the border, at least `clear` away from it */
static int32_t fill(uint64_t *state, double *xy, int32_t nborder, int32_t want, double clear)
{
    int32_t n = nborder;
    for (int32_t tries = 0; n < nborder + want && tries < 100 * want; tries++) {
        double p[2] = {support_uniform(state, -1.5, 1.5), support_uniform(state, -1.5, 1.5)};
        if (mus__polygon_winding(nborder, xy, p) == 0 || mus__polygon_distance(nborder, xy, p) < clear) continue;
        memcpy(xy + 2 * n++, p, sizeof p);
    }
    return n;
}


START_TEST(random_stars_are_covered_once)
{
    mus_context *context = support_context();
    uint64_t state = 1;
    double xy[2000];
    for (int turn = 0; turn < 300; turn++) {
        /* star-shaped, so simple; rough radii make deep notches; both windings */
        int32_t nborder = 3 + (int32_t)(support_random(&state) % 60);
        double way = turn % 2 ? 1.0 : -1.0;
        for (int32_t i = 0; i < nborder; i++) {
            double angle = way * 2.0 * MUS_PI * i / nborder, r = support_uniform(&state, 0.05, 1.4);
            xy[2 * i] = r * cos(angle), xy[2 * i + 1] = r * sin(angle);
        }
        int32_t n = fill(&state, xy, nborder, turn % 7 == 0 ? 0 : 300, 1e-6);
        check_triangulates(context, n, xy, nborder, 0, NULL);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_spiral_is_covered_once)
{
    /* two arms wound three times round each other */
    mus_context *context = support_context();
    uint64_t state = 2;
    double xy[3000];
    int32_t half = 200;
    for (int32_t i = 0; i < half; i++) {
        double angle = 6.0 * MUS_PI * i / half, r = 0.2 + 1.1 * i / half;
        xy[2 * i] = r * cos(angle), xy[2 * i + 1] = r * sin(angle);
        int32_t back = 2 * half - 1 - i;
        xy[2 * back] = (r + 0.1) * cos(angle), xy[2 * back + 1] = (r + 0.1) * sin(angle);
    }
    int32_t n = fill(&state, xy, 2 * half, 800, 1e-4);
    check_triangulates(context, n, xy, 2 * half, 0, NULL);
    support_context_end(context);
}
END_TEST


/* an m x m square of a lattice, border first, turned by an angle and moved */
static int32_t square(double *xy, int32_t m, double a, double angle, double shift)
{
    int32_t n = 0;
    for (int32_t side = 0; side < 4; side++)
        for (int32_t i = 0; i < m; i++, n++) {
            double along = i * a, end = m * a;
            xy[2 * n] = side == 0 ? along : side == 1 ? end : side == 2 ? end - along : 0.0;
            xy[2 * n + 1] = side == 0 ? 0.0 : side == 1 ? along : side == 2 ? end : end - along;
        }
    for (int32_t j = 1; j < m; j++)
        for (int32_t i = 1; i < m; i++, n++) xy[2 * n] = i * a, xy[2 * n + 1] = j * a;
    for (int32_t i = 0; i < n; i++) {
        double x = xy[2 * i], y = xy[2 * i + 1];
        xy[2 * i] = x * cos(angle) - y * sin(angle) + shift, xy[2 * i + 1] = x * sin(angle) + y * cos(angle) - shift;
    }
    return n;
}


START_TEST(lattices_are_covered_once)
{
    mus_context *context = support_context();
    double *xy = malloc(2 * 61 * 61 * 4 * sizeof *xy);
    for (int turn = 0; turn < 12; turn++) {
        int32_t m = turn < 10 ? 1 + 2 * turn : 60;
        int32_t n = square(xy, m, 0.01, turn % 3 == 0 ? 0.0 : 0.3 * turn, turn % 2 ? 0.377 : 0.0);
        check_triangulates(context, n, xy, 4 * m, 0, NULL);
    }
    free(xy);
    support_context_end(context);
}
END_TEST


START_TEST(slits_and_straps_are_covered_once)
{
    mus_context *context = support_context();

    /* a slit 1e-9 wide to the middle of a square, between lattice points; its tip on a lattice line */
    double slit[200] = {0, 0, 1, 0, 1, 1, 0.5 + 1e-9, 1, 0.5, 0.5, 0.5 - 1e-9, 1, 0, 1};
    int32_t n = 7;
    for (int32_t j = 1; j < 8; j++)
        for (int32_t i = 1; i < 8; i++)
            if (i != 4 || j < 4) slit[2 * n] = i / 8.0, slit[2 * n++ + 1] = j / 8.0;
    check_triangulates(context, n, slit, 7, 0, NULL);

    /* a strap 1 mm wide and 1 m long, no point inside, on the bias and along the axis */
    double strap[404];
    for (int turn = 0; turn < 2; turn++) {
        for (int32_t i = 0; i <= 100; i++) {
            double u = 0.01 * i, c = turn ? sqrt(0.5) : 1.0, s = turn ? sqrt(0.5) : 0.0;
            strap[2 * i] = u * c, strap[2 * i + 1] = u * s;
            int32_t back = 201 - i;
            strap[2 * back] = u * c - 0.001 * s, strap[2 * back + 1] = u * s + 0.001 * c;
        }
        check_triangulates(context, 202, strap, 202, 0, NULL);
    }
    support_context_end(context);
}
END_TEST


START_TEST(inner_sides_become_edges)
{
    /* long sides across a random cloud, and the rim of a lattice square without its inside */
    mus_context *context = support_context();
    uint64_t state = 3;
    double xy[2000] = {-1.5, -1.5, 1.5, -1.5, 1.5, 1.5, -1.5, 1.5, -1.2, -1.23, 1.21, 1.2, -1.25, 0.3, 0.2, 1.3};
    for (int32_t n = 8; n < 400; n++)
        for (int k = 0; k < 2; k++) xy[2 * n + k] = support_uniform(&state, -1.4, 1.4);
    const int32_t sides[] = {4, 5, 6, 7, 0, 4, 5, 2};
    check_triangulates(context, 400, xy, 4, 4, sides);
    support_context_end(context);
}
END_TEST


START_TEST(a_large_lattice_is_covered_once)
{
    mus_context *context = support_context();
    int32_t m = 170, *triangles, count;
    double *xy = malloc(2 * 171 * 171 * sizeof *xy);
    int32_t n = square(xy, m, 0.01, 0.0, 0.0);
    ck_assert_int_eq(mus__triangulate(context, n, xy, 4 * m, 0, NULL, &triangles, &count), MUS_OK);
    ck_assert_int_eq(count, 2 * m * m);
    mus__free(context, triangles);
    free(xy);
    support_context_end(context);
}
END_TEST


/* expects MUS_ERR_MESH and a word of its sentence */
static void check_refused(int32_t n, const double *xy, int32_t nborder, const char *word)
{
    mus_context *context = support_context();
    int32_t *triangles, count;
    ck_assert_int_eq(mus__triangulate(context, n, xy, nborder, 0, NULL, &triangles, &count), MUS_ERR_MESH);
    ck_assert_ptr_null(triangles);
    ck_assert_int_eq(count, 0);
    ck_assert_msg(strstr(mus_context_error(context), word) != NULL, "%s", mus_context_error(context));
    support_context_end(context);
}


START_TEST(what_is_no_simple_polygon_is_refused)
{
    const double bow[] = {0, 0, 1, 1, 1, 0, 0, 1}, touch[] = {0, 0, 2, 0, 2, 1, 1, 0, 0, 1};
    const double twice[] = {0, 0, 1, 0, 1, 1, 1, 0, 0, 1}, outside[] = {0, 0, 1, 0, 1, 1, 0, 1, 2, 0.5};
    const double same[] = {0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5, 0.5, 0.5}, on[] = {0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0};
    const double flat[] = {0, 0, 1, 0, 2, 0}, one[] = {3, 3, 3, 3, 3, 3}, bad[] = {0, 0, 1, 0, (double)NAN, 1};
    check_refused(4, bow, 4, "crosses");
    check_refused(5, touch, 5, "lies on side");
    check_refused(5, twice, 5, "the same");
    check_refused(5, outside, 4, "outside");
    check_refused(6, same, 4, "points 4 and 5");
    check_refused(5, on, 4, "point 4 lies on side 0-1");
    check_refused(3, flat, 3, "lies on side");
    check_refused(3, one, 3, "the same");
    check_refused(3, bad, 3, "not finite");
    check_refused(2, flat, 2, "3 to");
    check_refused(3, flat, 4, "3 to");
}
END_TEST


START_TEST(failing_memory_leaves_nothing_behind)
{
    double xy[2 * 13 * 13];
    int32_t n = square(xy, 12, 0.01, 0.2, 0.1);
    for (int64_t turn = 0;; turn++) {
        mus_context *context = support_context();
        int32_t *triangles, count;
        support_fail_after(turn, false);
        mus_status status = mus__triangulate(context, n, xy, 48, 0, NULL, &triangles, &count);
        support_fail_never();
        mus__free(context, triangles);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_triangulate(void);
Suite *mus_suite_triangulate(void)
{
    Suite *suite = suite_create("triangulate");
    TCase *tests = tcase_create("triangulate");
    tcase_set_timeout(tests, 60.0);
    tcase_add_test(tests, random_stars_are_covered_once);
    tcase_add_test(tests, a_spiral_is_covered_once);
    tcase_add_test(tests, lattices_are_covered_once);
    tcase_add_test(tests, slits_and_straps_are_covered_once);
    tcase_add_test(tests, inner_sides_become_edges);
    tcase_add_test(tests, a_large_lattice_is_covered_once);
    tcase_add_test(tests, what_is_no_simple_polygon_is_refused);
    tcase_add_test(tests, failing_memory_leaves_nothing_behind);
    suite_add_tcase(suite, tests);
    return suite;
}
