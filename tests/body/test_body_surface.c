/* test_body_surface.c: shells closed and outward, the paper's conditions on contours (3.1) and triangles (3.3),
 * normals. */
#include <stdlib.h>

#include "body/body_internal.h"
#include "geom/polygon.h"
#include "geom/vec.h"
#include "muslin/pose.h"
#include "people.h"
#include "study/outside/measure.h"


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
        int32_t work[MUS__CONTOUR_SAMPLES], i, j;
        for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
            const mus__limb *limb = &body->limb[l];
            const int32_t n = limb->samples;
            double last = -1e9, xy[2 * MUS__CONTOUR_SAMPLES];
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
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
        const mus__limb *limb = &body->limb[l];
        const int32_t n = limb->samples;
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
        if (deep > 0.0005) continue;
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
        const int32_t n = limb->samples;
        for (int32_t i = 3 * n * limb->contour[0].ring; i < 3 * n * limb->contour[limb->count - 1].ring; i += 3) {
            double d[3] = {x[i] - x[i + 3 * n], x[i + 1] - x[i + 1 + 3 * n], x[i + 2] - x[i + 2 + 3 * n]};
            ck_assert_msg(mus__norm3(d) < 1.6 * 0.02, "%s %g", limb->name,
                          mus__norm3(d)); /* a cubic is up to 1.5 steeper */
        }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* every triangle lies on the surface of the radius fields, at armpit, crotch and groin too: off the hands beyond the
 * knuckles and the feet beyond the ball, where fingers and toes are drawn. In the bottom of an armpit, where two fields
 * meet at an acute angle, a few triangles are up to 2 mm off, and between a child's thighs up to 4 mm within. Points
 * are one a triangle, and triangles are smallest there */
START_TEST(what_is_drawn_is_what_cloth_touches)
{
    static const char *const sizes[] = {"W40", "W52", "M50", "M60", "C56", "C116"};
    mus_context *context = support_context();
    for (int i = 0; i < 6; i++) {
        mus_body *body = people_body(context, sizes[i], NULL);
        outside_gap gap;
        outside_touch(body, 1, &gap);
        ck_assert_int_gt(gap.points, 50000);
        ck_assert_msg(gap.far * 400 <= gap.points, "%s: %d of %d", sizes[i], (int)gap.far, (int)gap.points);
        ck_assert_msg(gap.outside < 0.002 && gap.inside < 0.004, "%s: %g m outside, %g m inside", sizes[i], gap.outside,
                      gap.inside);
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


/* the vertex of the torso at the back of the ring at height y, k samples aside */
static const double *back_vertex(const mus_body *body, double y, int32_t k)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const int32_t n = body->def.samples;
    int32_t ring = 0;
    while (body->ring[torso->first_ring + ring] < y - 1e-9) ring++;
    return body->vertices + 3 * (torso->first_vertex + 1 + (ptrdiff_t)ring * n + n / 4 + k);
}


/* the cleft goes in at the middle of the back, and a tape over it is the hip's. Where the body sits it is the same */
START_TEST(the_seat_has_a_cleft)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL), *posed = NULL;
    mus_pose pose;
    ck_assert_int_eq(mus_pose_named(context, "sit", &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(body, &pose, &posed), MUS_OK);
    const double hip = body->skeleton.hip, tall = body->skeleton.crown;
    double least = 0.0;
    for (int32_t k = 1; k < 16; k++) least = fmin(least, back_vertex(body, hip, k)[2]);
    ck_assert_double_gt(back_vertex(body, hip, 0)[2] - least, 0.009 * tall);
    ck_assert(back_vertex(body, hip, 0)[0] == 0.0);
    ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_HIP), mus_body_asked(body, MUS_MEASURE_HIP), 1e-3);

    double x[3];
    mus__frame_point(&posed->frame[0], back_vertex(body, hip, 0), x);
    for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(back_vertex(posed, hip, 0)[i], x[i], 1e-9);
    mus_body_destroy(posed);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* height of the ring of the head that lies furthest back */
static double deepest(const mus_body *body)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const int32_t n = body->def.samples;
    double most = 0.0, at = 0.0;
    for (int32_t ring = 0; ring < torso->rings; ring++) {
        const double *x = body->vertices + 3 * (torso->first_vertex + 1 + (ptrdiff_t)ring * n + n / 4);
        if (x[1] > body->skeleton.jaw && -x[2] > most) most = -x[2], at = x[1];
    }
    return at;
}


/* a small child's skull is lowered; crown and the measures stay */
START_TEST(an_infants_head_is_round)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "C68", NULL), *grown = people_body(context, "W40", NULL);
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    ck_assert_double_lt(deepest(body), body->skeleton.brow - 0.004);
    ck_assert_double_gt(deepest(grown), grown->skeleton.brow - 0.02);
    const ptrdiff_t crown = 3 * ((ptrdiff_t)torso->first_vertex + torso->vertices - 1) + 1;
    ck_assert_double_eq_tol(body->vertices[crown], 0.68, 1e-12);
    ck_assert_double_eq_tol(mus_body_made(body, MUS_MEASURE_HEAD), mus_body_asked(body, MUS_MEASURE_HEAD), 1e-3);
    mus_body_destroy(grown);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* where the surfaces of torso and arm lie on each other they have one normal */
START_TEST(normals_run_on_from_limb_to_limb)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO], *arm = &body->limb[MUS__LIMB_ARM_LEFT];
    const double *x = body->vertices, *normal = body->normals;
    int32_t met = 0, across = 0;
    for (int32_t i = torso->first_vertex; i < torso->first_vertex + torso->vertices; i++) {
        if (fabs(depth_in_others(body, MUS__LIMB_TORSO, x + 3 * (ptrdiff_t)i)) > 0.001) continue;
        for (int32_t j = arm->first_vertex; j < arm->first_vertex + arm->vertices; j++) {
            const double *p = x + 3 * (ptrdiff_t)i, *q = x + 3 * (ptrdiff_t)j;
            const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
            if (fabs(d[1]) > 0.002 || mus__norm3(d) > 0.002) continue;
            if (fabs(depth_in_others(body, MUS__LIMB_ARM_LEFT, q)) > 0.001) continue;
            met++;
            across += mus__dot3(normal + 3 * (ptrdiff_t)i, normal + 3 * (ptrdiff_t)j) < 0.9;
        }
    }
    ck_assert_int_gt(met, 5);
    ck_assert_msg(across * 5 <= met, "%d of %d", (int)across, (int)met);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* without fingers and toes: the same measures, volume and depths; hands and feet are drawn whole */
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
    ck_assert_int_eq(mus_body_vertex_count(plain) + whole->digit_vertices, mus_body_vertex_count(whole));
    const size_t torso = 3 * sizeof(double) * (size_t)plain->limb[MUS__LIMB_TORSO].vertices;
    ck_assert_mem_eq(mus_body_vertices(plain), whole->vertices, torso);
    ck_assert_mem_eq(mus_body_normals(plain), whole->normals, torso);

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
    tcase_add_test(tests, what_is_drawn_is_what_cloth_touches);
    tcase_add_test(tests, the_seat_has_a_cleft);
    tcase_add_test(tests, an_infants_head_is_round);
    tcase_add_test(tests, normals_run_on_from_limb_to_limb);
    tcase_add_test(tests, a_plain_body_differs_in_its_picture_only);
    suite_add_tcase(suite, tests);
    return suite;
}
