/* test_body_surface.c: shells closed and outward, the paper's conditions on contours (3.1) and triangles (3.3),
 * normals. */
#include <stdlib.h>

#include "body/body_internal.h"
#include "geom/polygon.h"
#include "geom/vec.h"
#include "muslin/pose.h"
#include "people.h"


/* one edge of a triangle, packed: from < to, and its direction */
static int compare_edges(const void *x, const void *y)
{
    int64_t a = *(const int64_t *)x, b = *(const int64_t *)y;
    return a < b ? -1 : a > b;
}


/* every edge is used once in each direction; returns the volume inside */
static double check_shell(const mus_body *body, const int32_t *range, const char *who)
{
    const int32_t *triangles = mus_body_triangles(body) + 3 * (ptrdiff_t)range[2];
    const double *x = mus_body_vertices(body);
    int64_t *edge = malloc((size_t)range[3] * 3 * sizeof *edge);
    double volume = 0.0;
    for (int32_t t = 0; t < range[3]; t++) {
        const int32_t *v = triangles + 3 * (ptrdiff_t)t;
        double cross[3];
        mus__cross3(x + 3 * (ptrdiff_t)v[1], x + 3 * (ptrdiff_t)v[2], cross);
        volume += mus__dot3(x + 3 * (ptrdiff_t)v[0], cross) / 6.0;
        for (int k = 0; k < 3; k++) {
            int64_t a = v[k], b = v[(k + 1) % 3], low = a < b ? a : b, high = a < b ? b : a;
            ck_assert(a >= range[0] && a < range[0] + range[1]);
            edge[3 * (ptrdiff_t)t + k] = (low * INT32_MAX + high) * 2 + (a < b);
        }
    }
    qsort(edge, (size_t)range[3] * 3, sizeof *edge, compare_edges);
    for (int32_t i = 0; i < 3 * range[3]; i += 2)
        ck_assert_msg(edge[i] / 2 == edge[i + 1] / 2 && edge[i] % 2 == 0 && edge[i + 1] % 2 == 1, "%s: open edge", who);
    free(edge);
    return volume;
}


START_TEST(shells_of_all_limbs_are_closed_and_outward)
{
    mus_context *context = support_context();
    for (int32_t size = 0; size < mus_tape_size_count(); size++) {
        mus_body *body = people_body(context, mus_tape_size_name(size), NULL);
        int32_t vertices = 0, triangles = 0, range[4];
        for (int32_t l = 0; l < mus_body_limb_count(body); l++) {
            ck_assert_int_eq(mus_body_limb_range(body, l, range), MUS_OK);
            ck_assert_int_eq(range[0], vertices);
            ck_assert_int_eq(range[2], triangles);
            ck_assert_double_gt(check_shell(body, range, mus_body_limb_name(body, l)), 0.0);
            ck_assert_int_eq(range[1] - range[3] * 3 / 2 + range[3], 2); /* V - E + F of a sphere */
            vertices += range[1], triangles += range[3];
        }

        /* twenty fingers and toes, each a shell */
        ck_assert_int_eq(vertices + body->digit_vertices, mus_body_vertex_count(body));
        ck_assert_int_eq(triangles + body->digit_triangles, mus_body_triangle_count(body));
        range[1] = body->digit_vertices / 20, range[3] = body->digit_triangles / 20;
        for (int32_t d = 0; d < 20; d++) {
            range[0] = vertices + d * range[1], range[2] = triangles + d * range[3];
            ck_assert_double_gt(check_shell(body, range, "digit"), 0.0);
            ck_assert_int_eq(range[1] - range[3] * 3 / 2 + range[3], 2);
        }
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


/* paper 3.1: closed (samples are cyclic), no contour crosses itself, all turn the same way, none crosses another of its
 * stack (their planes are parallel and ascend) */
START_TEST(contours_keep_the_conditions_of_the_paper)
{
    mus_context *context = support_context();
    for (int32_t size = 0; size < mus_tape_size_count(); size++) {
        mus_body *body = people_body(context, mus_tape_size_name(size), NULL);
        int32_t n = body->def.samples, work[96], i, j;
        for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
            const mus__limb *limb = &body->limb[l];
            double last = -1e9, xy[2 * 96];
            for (int32_t ring = 0; ring < limb->rings; ring++) {
                const double *x = body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1 + (ptrdiff_t)ring * n);
                double s = mus__dot3(x, limb->axis);
                ck_assert_msg(s > last, "%s ring %d", limb->name, ring);
                last = s;
                for (int32_t k = 0; k < n; k++) {
                    ck_assert_double_eq_tol(mus__dot3(x + 3 * (ptrdiff_t)k, limb->axis), s, 1e-12);
                    xy[2 * k] = mus__dot3(x + 3 * (ptrdiff_t)k, limb->side);
                    xy[2 * k + 1] = mus__dot3(x + 3 * (ptrdiff_t)k, limb->front);
                }
                ck_assert_double_gt(mus__polygon_area(n, xy), 0.0);
                ck_assert_msg(!mus__polygon_crosses(n, xy, &i, &j, work), "%s %s ring %d", mus_tape_size_name(size),
                              limb->name, ring);
            }
        }
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


START_TEST(triangles_take_two_neighbours_of_a_contour_at_most)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    int32_t n = body->def.samples;
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
        const mus__limb *limb = &body->limb[l];
        for (int32_t t = 0; t < limb->triangles; t++) {
            const int32_t *v = body->triangles + 3 * ((ptrdiff_t)limb->first_triangle + t);
            int32_t ring[3], at[3];
            for (int k = 0; k < 3; k++) {
                int32_t i = v[k] - limb->first_vertex;
                ring[k] = i == 0 ? -1 : i == limb->vertices - 1 ? limb->rings : (i - 1) / n;
                at[k] = (i - 1) % n;
            }
            ck_assert(!(ring[0] == ring[1] && ring[1] == ring[2]));
            for (int k = 0; k < 3; k++) {
                int m = (k + 1) % 3, apart = abs(at[k] - at[m]);
                if (ring[k] == ring[m]) ck_assert(apart == 1 || apart == n - 1);
            }
        }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* largest depth of a place in all limbs but one */
static double depth_in_others(const mus_body *body, int32_t own, const double *x)
{
    double most = -1e30, normal[3];
    for (int32_t l = 0; l < body->nfield; l++)
        if (body->rig.part[l].limb != own) most = fmax(most, mus__field_depth(&body->field[l], x, normal));
    return most;
}


/* of triangles that can be seen: what lies within another limb is nobody's. In the narrow wedge of an armpit a fillet
 * turns by more than 60 degrees from one vertex to the next */
START_TEST(normals_are_unit_outward_and_smooth)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M50", NULL);
    const double *normal = mus_body_normals(body), *x = mus_body_vertices(body);
    const int32_t *triangles = mus_body_triangles(body);
    for (int32_t i = 0; i < mus_body_vertex_count(body); i++)
        ck_assert_double_eq_tol(mus__norm3(normal + 3 * (ptrdiff_t)i), 1.0, 1e-12);
    int32_t seen = 0, sharp = 0, own = 0;
    for (int32_t t = 0; t < body->triangle_count; t++) {
        const int32_t *v = triangles + 3 * (ptrdiff_t)t;
        double u[3], w[3], area[3];
        if (own + 1 < MUS__LIMB_COUNT && t >= body->limb[own + 1].first_triangle) own++;
        double deep = -1e30;
        for (int c = 0; c < 3; c++) deep = fmax(deep, depth_in_others(body, own, body->vertices + 3 * (ptrdiff_t)v[c]));
        if (deep > 0.005) continue;
        seen++;
        for (int i = 0; i < 3; i++) {
            u[i] = x[3 * (ptrdiff_t)v[1] + i] - x[3 * (ptrdiff_t)v[0] + i];
            w[i] = x[3 * (ptrdiff_t)v[2] + i] - x[3 * (ptrdiff_t)v[0] + i];
        }
        mus__cross3(u, w, area);
        mus__unit3(area);
        for (int c = 0; c < 3; c++) sharp += mus__dot3(area, normal + 3 * (ptrdiff_t)v[c]) < 0.5;
    }
    ck_assert_int_lt(sharp, seen / 250);
    ck_assert_int_gt(seen, mus_body_triangle_count(body) * 3 / 4);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* rings stand no further apart than asked, measured along the surface */
START_TEST(rings_are_as_close_as_asked)
{
    mus_context *context = support_context();
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.ring_spacing = 0.02;
    mus_body *body = people_body(context, "W40", &def);
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
        const mus__limb *limb = &body->limb[l];
        const double *x = body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1);
        for (int32_t i = 3 * def.samples * limb->contour[0].ring;
             i < 3 * def.samples * limb->contour[limb->count - 1].ring; i += 3) {
            double d[3] = {x[i] - x[i + 3 * def.samples], x[i + 1] - x[i + 1 + 3 * def.samples],
                           x[i + 2] - x[i + 2 + 3 * def.samples]};
            ck_assert_msg(mus__norm3(d) < 1.6 * 0.02, "%s %g", limb->name,
                          mus__norm3(d)); /* a cubic is up to 1.5 steeper */
        }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* whether a point may be moved by the cleft of the seat or by the groin */
static bool is_seat(const mus_body *body, const double *x)
{
    const double tall = body->skeleton.crown;
    if (x[2] > 0.0) return fabs(x[0]) < 0.12 * tall && x[1] > 0.9 * body->skeleton.crotch && x[1] < body->skeleton.hip;
    return fabs(x[0]) < 0.04 * tall && x[1] > body->skeleton.crotch - 0.011 * tall &&
           x[1] < body->skeleton.hip + 0.051 * tall;
}


/* the skin of two limbs at one place has one normal; it is nowhere within the limbs, and off them in creases only. Off
 * the face, hands, feet and the cleft of the seat, whose relief is the picture's alone */
START_TEST(the_skin_is_the_union_of_the_limbs)
{
    static const char *const sizes[] = {"W40", "M50", "C116"};
    mus_context *context = support_context();
    for (int i = 0; i < 3; i++) {
        mus_body *body = people_body(context, sizes[i], NULL);
        const double tall = body->skeleton.crown;
        int32_t off = 0, bare = 0;
        for (int32_t l = 0; l <= MUS__LIMB_LEG_RIGHT; l++) {
            const mus__limb *limb = &body->limb[l];
            for (int32_t v = limb->first_vertex; v < limb->first_vertex + limb->vertices; v++) {
                const double *x = body->vertices + 3 * (ptrdiff_t)v, *y = body->skin + 3 * (ptrdiff_t)v;
                const double way[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]}, far = mus__norm3(way);
                if (x[1] > body->skeleton.nape - 0.001 || x[1] < body->skeleton.ankle) continue;
                if (fabs(x[0]) > 0.2 * tall || is_seat(body, x)) continue;
                bare++;
                if (far == 0.0) continue;
                off++;
                ck_assert_msg(far < 0.0076 * tall, "%s %s vertex %d: %g m", sizes[i], limb->name, (int)v, far);

                /* a vertex outside all other limbs does not move into its own limb */
                if (depth_in_others(body, l, x) < 0.0)
                    ck_assert_double_gt(mus__dot3(way, body->normals + 3 * (ptrdiff_t)v), -5e-4);
            }
        }
        ck_assert_int_gt(off, 500);
        ck_assert_int_lt(off, bare / 4);
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


/* the cleft goes in alone, at the middle of the back; its normals are those of the surface, and a tape over it is the
 * hip's. Where the body sits it is the same, carried along */
START_TEST(the_seat_has_a_cleft)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL), *posed = NULL;
    mus_pose pose;
    ck_assert_int_eq(mus_pose_named(context, "sit", &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(body, &pose, &posed), MUS_OK);
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const int32_t n = body->def.samples, back = n / 4;
    int32_t ring = 0;
    while (body->ring[torso->first_ring + ring] < body->skeleton.hip - 1e-9) ring++;
    const ptrdiff_t at = torso->first_vertex + 1 + (ptrdiff_t)ring * n + back;
    const double *before = body->vertices + 3 * at, *after = body->skin + 3 * at, tall = body->skeleton.crown;
    ck_assert_double_eq_tol(after[2] - before[2], 0.011 * tall, 0.002 * tall);
    ck_assert(after[0] == before[0] && after[1] == before[1]);

    /* the same depth on the seated body */
    double moved = 0.0;
    for (int i = 0; i < 3; i++) {
        const double d = posed->skin[3 * at + i] - posed->vertices[3 * at + i];
        moved += d * d;
    }
    ck_assert_double_eq_tol(sqrt(moved), after[2] - before[2], 1e-6);

    /* across it the surface turns in and out again: normals against differences of places */
    for (int32_t k = -3; k <= 3; k++) {
        const double *p = body->skin + 3 * (at + k - 1), *q = body->skin + 3 * (at + k + 1);
        const double *low = body->skin + 3 * (at + k - n), *high = body->skin + 3 * (at + k + n);
        const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
        const double v[3] = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
        double normal[3];
        mus__cross3(u, v, normal);
        mus__unit3(normal);
        ck_assert_double_gt(mus__dot3(normal, body->skin_normals + 3 * (at + k)), 0.97);
    }
    mus_body_destroy(posed);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* a small child's brow and chin are drawn lower than their contours; crown, neck and the measures stay */
START_TEST(an_infants_head_is_round)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "C68", NULL);
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const int32_t n = body->def.samples;
    for (int32_t i = 0; i < torso->count; i++) {
        const ptrdiff_t first = torso->first_vertex + 1 + (ptrdiff_t)torso->contour[i].ring * n;
        const char *name = torso->contour[i].name;
        const double front = body->vertices[3 * (first + 3 * n / 4) + 1] - body->skin[3 * (first + 3 * n / 4) + 1];
        const double behind = body->vertices[3 * (first + n / 4) + 1] - body->skin[3 * (first + n / 4) + 1];
        if (strcmp(name, "brow") == 0) ck_assert(front > 0.008 && fabs(behind - front) < 1e-9);
        if (strcmp(name, "chin") == 0) ck_assert(front > 0.015 && behind < 1e-6);
        if (strcmp(name, "nape") == 0) ck_assert_double_lt(fabs(front) + fabs(behind), 1e-3);
    }
    const ptrdiff_t crown = 3 * ((ptrdiff_t)torso->first_vertex + torso->vertices - 1) + 1;
    ck_assert_double_eq_tol(body->skin[crown], 0.68, 1e-12);
    ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_HEAD), mus_body_asked(body, MUS_MEASURE_HEAD), 1e-9);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* within 2 mm of a skin vertex of the torso that a fillet moved, no vertex of an arm stands across it */
START_TEST(normals_run_on_from_limb_to_limb)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO], *arm = &body->limb[MUS__LIMB_ARM_LEFT];
    const double *x = body->skin, *normal = body->skin_normals;
    int32_t met = 0, across = 0;
    for (int32_t i = torso->first_vertex; i < torso->first_vertex + torso->vertices; i++) {
        if (memcmp(x + 3 * (ptrdiff_t)i, body->vertices + 3 * (ptrdiff_t)i, 3 * sizeof *x) == 0) continue;
        if (depth_in_others(body, MUS__LIMB_TORSO, body->vertices + 3 * (ptrdiff_t)i) > 0.004) continue;
        for (int32_t j = arm->first_vertex; j < arm->first_vertex + arm->vertices; j++) {
            const double *p = x + 3 * (ptrdiff_t)i, *q = x + 3 * (ptrdiff_t)j;
            const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
            if (mus__norm3(d) > 0.002) continue;
            if (depth_in_others(body, MUS__LIMB_ARM_LEFT, body->vertices + 3 * (ptrdiff_t)j) > 0.004) continue;
            met++;
            across += mus__dot3(normal + 3 * (ptrdiff_t)i, normal + 3 * (ptrdiff_t)j) < 0.9;
        }
    }
    ck_assert_int_gt(met, 5);
    ck_assert_msg(across * 10 <= met, "%d of %d", (int)across, (int)met);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* without the picture's skin: the same measures, volume, depths; the surface is the rings */
START_TEST(a_plain_body_differs_in_its_picture_only)
{
    mus_context *context = support_context();
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    mus_body *whole = people_body(context, "M50", NULL), *plain = people_body(context, "M50", &def);
    for (int32_t m = 0; m < mus_measure_count(); m++) {
        const double a = mus_body_made(whole, m), b = mus_body_made(plain, m);
        ck_assert(a == b || (isnan(a) && isnan(b)));
    }
    ck_assert_double_eq(mus_body_volume(plain), mus_body_volume(whole));
    ck_assert_int_lt(mus_body_vertex_count(plain), mus_body_vertex_count(whole));
    ck_assert_int_eq(mus_body_vertex_count(plain), plain->vertex_count);
    ck_assert_mem_eq(mus_body_vertices(plain), whole->vertices, 3 * sizeof(double) * (size_t)plain->vertex_count);
    ck_assert_mem_eq(mus_body_normals(plain), whole->normals, 3 * sizeof(double) * (size_t)plain->vertex_count);

    const int32_t n = plain->vertex_count;
    double *depth = malloc(2 * (size_t)n * sizeof *depth);
    ck_assert_int_eq(mus_body_depth(plain, n, mus_body_vertices(whole), depth, NULL), MUS_OK);
    ck_assert_int_eq(mus_body_depth(whole, n, mus_body_vertices(whole), depth + n, NULL), MUS_OK);
    ck_assert_mem_eq(depth, depth + n, (size_t)n * sizeof *depth);
    free(depth);

    /* a posed copy stays plain */
    mus_pose pose;
    mus_body *posed;
    ck_assert_int_eq(mus_body_rest_pose(plain, &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(plain, &pose, &posed), MUS_OK);
    ck_assert_int_eq(mus_body_vertex_count(posed), mus_body_vertex_count(plain));
    mus_body_destroy(posed);
    mus_body_destroy(plain);
    mus_body_destroy(whole);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_body_surface(void);
Suite *mus_suite_body_surface(void)
{
    Suite *suite = suite_create("body_surface");
    TCase *tests = tcase_create("body_surface");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, shells_of_all_limbs_are_closed_and_outward);
    tcase_add_test(tests, contours_keep_the_conditions_of_the_paper);
    tcase_add_test(tests, triangles_take_two_neighbours_of_a_contour_at_most);
    tcase_add_test(tests, normals_are_unit_outward_and_smooth);
    tcase_add_test(tests, rings_are_as_close_as_asked);
    tcase_add_test(tests, the_skin_is_the_union_of_the_limbs);
    tcase_add_test(tests, the_seat_has_a_cleft);
    tcase_add_test(tests, an_infants_head_is_round);
    tcase_add_test(tests, normals_run_on_from_limb_to_limb);
    tcase_add_test(tests, a_plain_body_differs_in_its_picture_only);
    suite_add_tcase(suite, tests);
    return suite;
}
