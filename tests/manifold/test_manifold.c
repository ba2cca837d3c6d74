/*
 * test_manifold.c: the closed surface of bodies, judged on the written OBJ file by programs that read the file alone
 * (study/manifold). More bodies, poses and the default spacing: `make manifold`.
 */
#include <stdio.h>
#include <unistd.h>

#include "body/people.h"
#include "muslin/manifold.h"
#include "muslin/pose.h"
#include "study/manifold/written.h"

#define COARSE 0.01 /* [m] spacing: a tenth of the time of the default */


static mus_manifold_def options(double spacing, int32_t threads)
{
    mus_manifold_def def;
    mus_manifold_def_init(&def, sizeof def);
    def.spacing = spacing, def.threads = threads;
    return def;
}


/* a body's file: closed, one sphere, no crossing, its volume within one part in `share`; girths within 2 mm */
static void holds(mus_context *context, const mus_body *body, bool rest, double share)
{
    const mus_manifold_def def = options(COARSE, 2);
    char path[64];
    written w;
    snprintf(path, sizeof path, "/tmp/muslin-manifold-%d.obj", (int)getpid());
    ck_assert_msg(written_manifold(context, body, &def, path, rest, &w), "%s", mus_context_error(context));
    remove(path);
    ck_assert_int_eq(w.file.open, 0);
    ck_assert_int_eq(w.file.pinched, 0);
    ck_assert_int_eq(w.file.flat, 0);
    ck_assert_int_eq(w.file.crossings, 0);
    ck_assert_int_eq(w.file.pieces, 1);
    ck_assert_int_eq(w.file.euler, 2);
    ck_assert_double_eq_tol(w.file.volume, mus_body_volume(body), mus_body_volume(body) / share);
    ck_assert_msg(fabs(w.girth) < 2e-3, "%s is %.4f m off", w.measure, w.girth);
}


START_TEST(the_written_file_is_one_sphere_with_the_girths_of_the_tape)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M50", NULL);
    holds(context, body, true, 100.0);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(a_posed_body_is_one_sphere_too)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "C116", NULL), *posed = NULL;
    mus_pose pose;
    ck_assert_int_eq(mus_pose_named(context, "squat", &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(body, &pose, &posed), MUS_OK);
    holds(context, posed, false, 25.0); /* the parts overlap where joints bend; the body counts them as at rest */
    mus_body_destroy(posed);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* limbs: a ball of a radius [m] for each centre (x) */
static mus_body *balls(mus_context *context, int32_t n, const double *x, double radius)
{
    mus_body *body = NULL;
    mus_limb limb[4];
    double contour[2][6] = {{0}};
    for (int k = 0; k < 2; k++) {
        contour[k][0] = (k - 0.5) * 0.4 * radius;
        contour[k][3] = contour[k][4] = sqrt(0.96) * radius;
        contour[k][5] = 2.0;
    }
    for (int32_t i = 0; i < n; i++) {
        mus_limb_init(&limb[i], sizeof limb[i]);
        limb[i].contours = 2, limb[i].contour = &contour[0][0];
        limb[i].origin[0] = x[i];
        limb[i].pole[0] = -radius, limb[i].pole[1] = radius;
    }
    ck_assert_int_eq(mus_body_create_limbs(context, n, limb, NULL, &body), MUS_OK);
    return body;
}


START_TEST(vertices_lie_on_the_surface_and_limbs_apart_are_pieces_of_their_own)
{
    mus_context *context = support_context();
    mus_body *body = balls(context, 2, (double[]){-0.08, 0.08}, 0.05);
    const mus_manifold_def def = options(0.006, 1);
    mus_manifold *manifold = NULL;
    ck_assert_int_eq(mus_manifold_create(body, &def, &manifold), MUS_OK);
    ck_assert_int_eq(mus_manifold_piece_count(manifold), 2);
    ck_assert_int_eq(mus_manifold_cut_count(manifold), 0);
    const int32_t n = mus_manifold_vertex_count(manifold);
    double *depth = malloc(sizeof *depth * (size_t)n);
    ck_assert_int_eq(mus_body_depth(body, n, mus_manifold_vertices(manifold), depth, NULL), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        const double *x = mus_manifold_vertices(manifold) + 3 * (ptrdiff_t)i;
        const double *normal = mus_manifold_normals(manifold) + 3 * (ptrdiff_t)i;
        const double out = x[0] < 0.0 ? x[0] + 0.08 : x[0] - 0.08;
        ck_assert_double_lt(fabs(depth[i]), 1e-8);
        ck_assert_double_gt(normal[0] * out + normal[1] * x[1] + normal[2] * x[2], 0.04);
    }
    free(depth);
    mus_manifold_destroy(manifold);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(the_same_bytes_for_any_number_of_threads)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "C56", NULL);
    mus_manifold *made[2];
    for (int k = 0; k < 2; k++) {
        const mus_manifold_def def = options(COARSE, k == 0 ? 1 : 5);
        ck_assert_int_eq(mus_manifold_create(body, &def, &made[k]), MUS_OK);
    }
    const int32_t n = mus_manifold_vertex_count(made[0]), m = mus_manifold_triangle_count(made[0]);
    ck_assert_int_eq(mus_manifold_vertex_count(made[1]), n);
    ck_assert_int_eq(mus_manifold_triangle_count(made[1]), m);
    ck_assert_mem_eq(mus_manifold_vertices(made[0]), mus_manifold_vertices(made[1]), 24 * (size_t)n);
    ck_assert_mem_eq(mus_manifold_normals(made[0]), mus_manifold_normals(made[1]), 24 * (size_t)n);
    ck_assert_mem_eq(mus_manifold_triangles(made[0]), mus_manifold_triangles(made[1]), 12 * (size_t)m);
    for (int k = 0; k < 2; k++) mus_manifold_destroy(made[k]);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(a_failing_allocation_is_a_status_and_nothing_is_leaked)
{
    mus_context *context = support_context();
    mus_body *body = balls(context, 2, (double[]){-0.08, 0.08}, 0.05);
    const mus_manifold_def def = options(0.02, 2);
    mus_status status = MUS_ERR_MEMORY;
    for (int64_t n = 0; status != MUS_OK && n < 200; n++) {
        mus_manifold *manifold = NULL;
        support_fail_after(n, n % 2 == 1);
        status = mus_manifold_create(body, &def, &manifold);
        support_fail_never();
        ck_assert(status == MUS_OK ? manifold != NULL : status == MUS_ERR_MEMORY && manifold == NULL);
        mus_manifold_destroy(manifold);
    }
    ck_assert_int_eq(status, MUS_OK);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(what_cannot_be_made_is_refused_with_a_sentence)
{
    mus_context *context = support_context();
    mus_body *body = balls(context, 1, (double[]){0.0}, 0.005);
    mus_manifold *manifold = NULL;
    mus_manifold_def def = options(0.0005, 1);
    ck_assert_int_eq(mus_manifold_create(body, &def, &manifold), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "spacing 0.0005 m is outside 0.001 to 0.03 m");
    def = options(0.004, 0);
    ck_assert_int_eq(mus_manifold_create(body, &def, &manifold), MUS_ERR_ARG);
    def = options(0.03, 1);
    ck_assert_int_eq(mus_manifold_create(body, &def, &manifold), MUS_ERR_BODY);
    ck_assert_int_eq(mus_manifold_create(NULL, NULL, &manifold), MUS_ERR_ARG);
    ck_assert_ptr_null(manifold);
    ck_assert_int_eq(mus_manifold_create(body, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_manifold_vertex_count(NULL), 0);
    ck_assert_ptr_null(mus_manifold_vertices(NULL));
    mus_manifold_destroy(NULL);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_manifold(void);
Suite *mus_suite_manifold(void)
{
    Suite *suite = suite_create("manifold");
    TCase *tests = tcase_create("manifold");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, the_written_file_is_one_sphere_with_the_girths_of_the_tape);
    tcase_add_test(tests, a_posed_body_is_one_sphere_too);
    tcase_add_test(tests, vertices_lie_on_the_surface_and_limbs_apart_are_pieces_of_their_own);
    tcase_add_test(tests, the_same_bytes_for_any_number_of_threads);
    tcase_add_test(tests, a_failing_allocation_is_a_status_and_nothing_is_leaked);
    tcase_add_test(tests, what_cannot_be_made_is_refused_with_a_sentence);
    suite_add_tcase(suite, tests);
    return suite;
}
