/*
 * test_scan_posed.c: scanned bodies are posed. Joints of the meshes of GarmentCode against those of their tapes, girths
 * in every named pose, our own body scanned in a T-pose and sat down against the body itself sat down, and what a scan
 * that lacks a limb says.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "geom/vec.h"
#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "scan/solids.h"
#include "support.h"

Suite *mus_suite_scan_posed(void);

#define SAMPLES 24


static mus_status posed_scan(mus_context *context, int32_t vertices, const double *x, int32_t triangles,
                             const int32_t *triangle, double *place, mus_body **out)
{
    mus_scan_def def;
    mus_scan_report report;
    mus_scan_def_init(&def, sizeof def);
    mus_scan_report_init(&report, sizeof report);
    def.distances = 0;
    const mus_status status = mus_body_create_scan(context, vertices, x, triangles, triangle, &def, &report, out);
    if (place != NULL) memcpy(place, report.place, sizeof report.place);
    return status;
}


/* false, with a line, without the data */
static bool posed_person(mus_context *context, const char *name, mus_body **out)
{
    char relative[128], path[512];
    mus_mesh *mesh;
    snprintf(relative, sizeof relative, "garmentcode/bodies/%s.obj", name);
    if (support_data(relative, path, sizeof path) == NULL) return false;
    ck_assert_int_eq(mus_mesh_read_obj(context, path, &mesh), MUS_OK);
    ck_assert_msg(posed_scan(context, mus_mesh_vertex_count(mesh), mus_mesh_vertices(mesh),
                             mus_mesh_triangle_count(mesh), mus_mesh_triangles(mesh), NULL, out) == MUS_OK,
                  "%s: %s", name, mus_context_error(context));
    mus_mesh_destroy(mesh);
    return true;
}


static mus_body *posed_as(const mus_body *body, mus_context *context, const char *name)
{
    mus_pose pose;
    mus_body *posed = NULL;
    ck_assert_int_eq(mus_pose_named(context, name, &pose), MUS_OK);
    ck_assert_int_eq(mus_body_clear_arms(body, &pose, 0.01), MUS_OK);
    ck_assert_int_eq(mus_body_ground(body, &pose), MUS_OK);
    ck_assert_msg(mus_body_pose(body, &pose, &posed) == MUS_OK, "%s: %s", name, mus_context_error(context));
    return posed;
}


/* no yaml gives joints; those of the body of its tape are ANSUR's means. Arms are as long to 1 cm. The shoulder of a
 * scan is on the axis of the whole arm, which is bent: lower by 4.7 cm on both than that of the tape's body, whose arms
 * lie within 1 cm of the mesh's */
START_TEST(joints_are_where_the_tape_has_them)
{
    static const char *const names[] = {"mean_all", "mean_female"};
    static const struct {
        int32_t landmark;
        double off;
    } rows[] = {{MUS_LANDMARK_SHOULDER_LEFT, 0.05}, {MUS_LANDMARK_SHOULDER_RIGHT, 0.05},
                {MUS_LANDMARK_WAIST, 0.035},        {MUS_LANDMARK_HIP, 0.035}};
    for (int k = 0; k < 2; k++) {
        mus_context *context = support_context();
        mus_body *scan = NULL, *own = NULL;
        mus_tape *tape = NULL;
        char relative[128], path[512];
        snprintf(relative, sizeof relative, "garmentcode/bodies/%s.yaml", names[k]);
        if (!posed_person(context, names[k], &scan) || support_data(relative, path, sizeof path) == NULL) {
            support_context_end(context);
            return;
        }
        ck_assert_int_eq(mus_tape_read(context, path, NULL, &tape), MUS_OK);
        ck_assert_int_eq(mus_body_create(context, tape, NULL, &own), MUS_OK);
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
            double a[3], b[3];
            ck_assert_int_eq(mus_body_landmark(scan, rows[i].landmark, a), MUS_OK);
            ck_assert_int_eq(mus_body_landmark(own, rows[i].landmark, b), MUS_OK);
            for (int d = 0; d < 3; d++) a[d] -= b[d];
            ck_assert_msg(mus__norm3(a) < rows[i].off, "%s, landmark %d: %g m off", names[k], (int)rows[i].landmark,
                          mus__norm3(a));
        }
        for (int right = 0; right < 2; right++) {
            double length[2];
            for (int which = 0; which < 2; which++) {
                double a[3], b[3];
                const mus_body *of = which ? own : scan;
                ck_assert_int_eq(mus_body_landmark(of, MUS_LANDMARK_SHOULDER_LEFT + right, a), MUS_OK);
                ck_assert_int_eq(mus_body_landmark(of, MUS_LANDMARK_WRIST_LEFT + right, b), MUS_OK);
                for (int d = 0; d < 3; d++) a[d] -= b[d];
                length[which] = mus__norm3(a);
            }
            ck_assert_double_eq_tol(length[0], length[1], 0.01);
        }
        ck_assert_int_eq(mus_body_landmark(scan, MUS_LANDMARK_NAPE, (double[3]){0}), MUS_ERR_ARG);
        mus_body_destroy(scan);
        mus_body_destroy(own);
        mus_tape_destroy(tape);
        support_context_end(context);
    }
}
END_TEST


/* the way round a contour's samples */
static double round_contour(const mus_body *body, int32_t limb, int32_t contour)
{
    double x[3 * SAMPLES], sum = 0.0;
    ck_assert_int_eq(mus_body_contour_points(body, limb, contour, SAMPLES, x), MUS_OK);
    for (int k = 0; k < SAMPLES; k++) {
        double d[3];
        for (int i = 0; i < 3; i++) d[i] = x[3 * ((k + 1) % SAMPLES) + i] - x[3 * k + i];
        sum += mus__norm3(d);
    }
    return sum;
}


START_TEST(girths_stay_in_every_pose)
{
    mus_context *context = support_context();
    mus_body *body = NULL;
    if (posed_person(context, "m_smpl_average_A40", &body)) {
        for (int32_t p = 0; p < mus_pose_count(); p += SUPPORT_SLOW ? 5 : 1) {
            mus_body *posed = posed_as(body, context, mus_pose_name(p));
            double low = INFINITY;
            for (int32_t l = 0; l < mus_body_limb_count(body); l++)
                for (int32_t i = 0; i < mus_body_contour_count(body, l); i += 7)
                    ck_assert_double_eq_tol(round_contour(posed, l, i), round_contour(body, l, i), 1e-12);
            for (int32_t v = 0; v < mus_body_vertex_count(posed); v++)
                low = fmin(low, mus_body_vertices(posed)[3 * v + 1]);
            ck_assert_msg(fabs(low) < 2e-3, "%s: the lowest point is at %g m", mus_pose_name(p), low);
            mus_body_destroy(posed);
        }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* a scan in its own rest pose is the scan, to rounding */
START_TEST(the_rest_pose_is_the_scan)
{
    mus_context *context = support_context();
    solid s;
    mus_body *body = NULL, *same = NULL;
    mus_pose pose;
    solid_person("W40", "t", &s);
    ck_assert_int_eq(posed_scan(context, s.vertices, s.x, s.triangles, s.triangle, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus_body_rest_pose(body, &pose), MUS_OK);
    ck_assert_double_eq_tol(pose.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_ABDUCTION], 0.5 * MUS_PI, 0.03);
    ck_assert_int_eq(mus_body_pose(body, &pose, &same), MUS_OK);
    for (int32_t k = 0; k < 3 * mus_body_vertex_count(body); k++)
        ck_assert_double_eq_tol(mus_body_vertices(same)[k], mus_body_vertices(body)[k], 1e-12);
    mus_body_destroy(same);
    mus_body_destroy(body);
    solid_free(&s);
    support_context_end(context);
}
END_TEST


static int posed_order(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return p < q ? -1 : p > q;
}


/* the way there differs by where joints were found: those of the arms to 7 mm, hips and knees to 2 cm */
START_TEST(a_scanned_body_sits_as_the_body_itself)
{
    static const char *const poses[] = {"a", "sit", "arms_forward", "step"};
    mus_context *context = support_context();
    solid s;
    mus_tape *tape;
    mus_body *scan = NULL, *own = NULL;
    double place[3];
    solid_person("W40", "t", &s);
    ck_assert_int_eq(posed_scan(context, s.vertices, s.x, s.triangles, s.triangle, place, &scan), MUS_OK);
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &own), MUS_OK);
    for (int k = 0; k < (SUPPORT_SLOW ? 1 : 4); k++) {
        mus_pose pose;
        mus_body *a = NULL, *b = NULL;
        ck_assert_int_eq(mus_pose_named(context, poses[k], &pose), MUS_OK);
        ck_assert_int_eq(mus_body_pose(own, &pose, &a), MUS_OK);
        ck_assert_int_eq(mus_body_pose(scan, &pose, &b), MUS_OK);

        /* of the body's skin what is on its surface */
        const int32_t n = mus_body_vertex_count(a);
        double *depth = calloc((size_t)n, sizeof *depth), *off = calloc((size_t)n, sizeof *off);
        int32_t count = 0;
        ck_assert(depth != NULL && off != NULL);
        ck_assert_int_eq(mus_body_depth(a, n, mus_body_vertices(a), depth, NULL), MUS_OK);
        for (int32_t v = 0; v < n; v += 5) {
            if (depth[v] > 2e-3) continue;
            double x[3];
            for (int i = 0; i < 3; i++) x[i] = mus_body_vertices(a)[3 * v + i] + place[i];
            ck_assert_int_eq(mus_body_depth(b, 1, x, &off[count], NULL), MUS_OK);
            off[count] = fmin(fabs(off[count]), 0.05);
            count++;
        }
        qsort(off, (size_t)count, sizeof *off, posed_order);
        const double most = k == 0 || k == 2 ? 0.002 : 0.01;
        ck_assert_msg(off[count / 2] < most && off[count * 9 / 10] < 0.04, "%s: %g and %g m", poses[k],
                      off[count / 2], off[count * 9 / 10]);
        free(depth);
        free(off);
        mus_body_destroy(a);
        mus_body_destroy(b);
    }
    mus_body_destroy(own);
    mus_body_destroy(scan);
    mus_tape_destroy(tape);
    solid_free(&s);
    support_context_end(context);
}
END_TEST


/* a cloth of a few nodes beside it: it walks, and is asked every frame */
START_TEST(a_scanned_body_walks)
{
    mus_context *context = support_context();
    solid s;
    mus_body *body = NULL;
    mus_move *move = NULL;
    solid_person("M50", "a", &s);
    ck_assert_int_eq(posed_scan(context, s.vertices, s.x, s.triangles, s.triangle, NULL, &body), MUS_OK);
    ck_assert_msg(mus_body_move(body, "walk", 0.01, &move) == MUS_OK, "%s", mus_context_error(context));
    for (int k = 0; k < 4; k++) {
        mus_pose pose;
        mus_body *posed = NULL;
        double low = INFINITY;
        ck_assert_int_eq(mus_move_at(move, k * mus_move_period(move) / 4.0, &pose), MUS_OK);
        ck_assert_int_eq(mus_body_pose(body, &pose, &posed), MUS_OK);
        for (int32_t v = 0; v < mus_body_vertex_count(posed); v++)
            low = fmin(low, mus_body_vertices(posed)[3 * v + 1]);
        ck_assert_double_eq_tol(low, 0.0, 0.005);
        mus_body_destroy(posed);
    }
    mus_move_destroy(move);
    mus_body_destroy(body);
    solid_free(&s);
    support_context_end(context);
}
END_TEST


/* without its left arm it cannot raise it; with that arm's angles at 0 it sits */
START_TEST(what_a_scan_lacks_is_named)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *own = NULL, *scan = NULL, *posed = NULL;
    mus_body_def def;
    mus_pose pose;
    mus_body_def_init(&def, sizeof def);
    def.without = MUS_WITHOUT_ARM_LEFT;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "M50"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, &def, &own), MUS_OK);
    ck_assert_msg(posed_scan(context, mus_body_vertex_count(own), mus_body_vertices(own),
                             mus_body_triangle_count(own), mus_body_triangles(own), NULL, &scan) == MUS_OK,
                  "%s", mus_context_error(context));
    ck_assert_int_eq(mus_body_limb_count(scan), 6);
    ck_assert_int_eq(mus_body_landmark(scan, MUS_LANDMARK_WRIST_LEFT, (double[3]){0}), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pose_named(context, "sit", &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(scan, &pose, &posed), MUS_ERR_BODY);
    ck_assert_ptr_null(posed);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "shoulder_left"));
    ck_assert_int_eq(mus_body_clear_arms(scan, &pose, 0.01), MUS_ERR_BODY);
    for (int j = MUS_JOINT_SHOULDER_LEFT; j <= MUS_JOINT_WRIST_LEFT; j += 2)
        memset(pose.angle[j], 0, sizeof pose.angle[j]);
    ck_assert_msg(mus_body_pose(scan, &pose, &posed) == MUS_OK, "%s", mus_context_error(context));
    mus_body_destroy(posed);
    mus_body_destroy(scan);
    mus_body_destroy(own);
    mus_tape_destroy(tape);

    /* a form has no joints at all, and can be put elsewhere */
    solid s;
    posed = NULL;
    solid_cylinder(64, 0.15, 0.11, 0.7, &s);
    mus_scan_def form;
    mus_scan_def_init(&form, sizeof form);
    form.up = MUS_SCAN_Y, form.front = MUS_SCAN_Z, form.unit = 1.0, form.distances = 0;
    ck_assert_msg(mus_body_create_scan(context, s.vertices, s.x, s.triangles, s.triangle, &form, NULL, &scan) == MUS_OK,
                  "%s", mus_context_error(context));
    ck_assert_int_eq(mus_pose_named(context, "bend", &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(scan, &pose, &posed), MUS_ERR_BODY);
    mus_pose_init(&pose, sizeof pose);
    pose.place[0] = 0.5;
    ck_assert_int_eq(mus_body_pose(scan, &pose, &posed), MUS_OK);
    mus_body_destroy(posed);
    mus_body_destroy(scan);
    solid_free(&s);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_scan_posed(void)
{
    Suite *suite = suite_create("scan_posed");
    TCase *tests = tcase_create("scan_posed");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, joints_are_where_the_tape_has_them);
    if (!SUPPORT_SLOW) tcase_add_test(tests, girths_stay_in_every_pose);
    tcase_add_test(tests, the_rest_pose_is_the_scan);
    tcase_add_test(tests, a_scanned_body_sits_as_the_body_itself);
    tcase_add_test(tests, a_scanned_body_walks);
    tcase_add_test(tests, what_a_scan_lacks_is_named);
    suite_add_tcase(suite, tests);
    return suite;
}
