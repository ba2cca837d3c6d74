/*
 * test_scan_pose.c: our own bodies in a T-pose, as meshes of other programs have it: Z up, in centimetres or
 * millimetres, axis and unit found or stated. The same limbs, girths within 5 mm of the body's own, the mesh within
 * 5 mm of the contours. And a mesh of the test data whose arms are turned up: its girths are those of its A-pose.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/polygon.h"
#include "geom/vec.h"
#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "scan/solids.h"
#include "support.h"

Suite *mus_suite_scan_pose(void);

#define SAMPLES 192


static int32_t limb_of(const mus_body *body, const char *name)
{
    int32_t limb = 0;
    while (strcmp(mus_body_limb_name(body, limb), name) != 0) limb++;
    return limb;
}


/* tape round a contour, and its middle */
static double tape_of(const mus_body *body, int32_t limb, int32_t contour, double *middle)
{
    double x[3 * SAMPLES], xy[2 * SAMPLES], u[3], v[3], normal[3] = {0.0, 0.0, 0.0};
    int32_t work[2 * SAMPLES];
    ck_assert_int_eq(mus_body_contour_points(body, limb, contour, SAMPLES, x), MUS_OK);
    for (int i = 0; i < 3; i++) {
        middle[i] = 0.0;
        for (int k = 0; k < SAMPLES; k++) middle[i] += x[3 * k + i] / SAMPLES;
    }

    /* its plane, from two samples a quarter apart */
    for (int i = 0; i < 3; i++) u[i] = x[i] - middle[i], v[i] = x[3 * (SAMPLES / 4) + i] - middle[i];
    mus__cross3(u, v, normal);
    mus__unit3(normal);
    mus__unit3(u);
    mus__cross3(normal, u, v);
    for (int k = 0; k < SAMPLES; k++) xy[2 * k] = mus__dot3(x + 3 * k, u), xy[2 * k + 1] = mus__dot3(x + 3 * k, v);
    return mus__polygon_tape(SAMPLES, xy, work, work + SAMPLES);
}


/* of the contours of a limb the two beside a place along `axis`, and the tape between them there */
static double tape_at(const mus_body *body, const char *name, int axis, double place)
{
    const int32_t limb = limb_of(body, name);
    double before = NAN, at = NAN, middle[3];
    for (int32_t i = 0; i < mus_body_contour_count(body, limb); i++) {
        const double tape = tape_of(body, limb, i, middle);
        const double part = (place - at) / (middle[axis] - at);
        if (part >= 0.0 && part <= 1.0) return before + part * (tape - before);
        before = tape, at = middle[axis];
    }
    ck_abort_msg("%s has nothing at %g", name, place);
    return NAN;
}


/* axes and unit found or stated; distances, which take the time, where they are found */
static mus_body *scan_t_pose(mus_context *context, const char *size, double unit, bool stated, mus_scan_report *report)
{
    static const double upright[9] = {1, 0, 0, 0, 0, -1, 0, 1, 0}; /* Y up to Z up */
    const double place[3] = {40.0 * unit, 3.0 * unit, -0.5 * unit};
    solid s;
    solid_person(size, "t", &s);
    solid_move(&s, unit, upright, place);
    mus_scan_def def;
    mus_scan_def_init(&def, sizeof def);
    def.distances = !stated;
    if (stated) def.up = MUS_SCAN_Z, def.front = -MUS_SCAN_Y, def.unit = 1.0 / unit;
    mus_body *body = NULL;
    mus_scan_report_init(report, sizeof *report);
    const mus_status status =
        mus_body_create_scan(context, s.vertices, s.x, s.triangles, s.triangle, &def, report, &body);
    ck_assert_msg(status == MUS_OK, "%s: %s", size, mus_context_error(context));
    solid_free(&s);
    return body;
}


START_TEST(a_t_pose_is_cut_into_the_same_body)
{
    static const struct {
        const char *size;
        double unit;
        bool stated;
    } row[] = {{"M50", 1000.0, false}, {"W40", 100.0, true}};
    for (int k = 0; k < (SUPPORT_SLOW ? 1 : 2); k++) {
        mus_context *context = support_context();
        mus_scan_report report;
        mus_body *body = scan_t_pose(context, row[k].size, row[k].unit, row[k].stated, &report), *own, *rest;
        mus_tape *tape;
        mus_pose pose;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_size(tape, row[k].size), MUS_OK);
        ck_assert_int_eq(mus_body_create(context, tape, NULL, &rest), MUS_OK);
        ck_assert_int_eq(mus_pose_named(context, "t", &pose), MUS_OK);
        ck_assert_int_eq(mus_body_pose(rest, &pose, &own), MUS_OK);

        ck_assert_double_eq_tol(report.unit * row[k].unit, 1.0, 1e-12);
        ck_assert_double_eq_tol(report.stature, mus_body_made(rest, MUS_MEASURE_STATURE), 1e-5);
        ck_assert_int_eq(mus_body_limb_count(body), mus_body_limb_count(own));
        for (int32_t l = 0; l < mus_body_limb_count(own); l++)
            ck_assert_str_eq(mus_body_limb_name(body, l), mus_body_limb_name(own, l));
        const double armpit = mus_body_made(rest, MUS_MEASURE_NAPE_HEIGHT) -
                              0.9 * mus_body_asked(rest, MUS_MEASURE_SCYE_DEPTH);
        for (int i = 0; i < 2; i++) {
            ck_assert_double_eq_tol(report.arm_angle[i], 0.0, 0.02);
            ck_assert_double_eq_tol(report.armpit[i], armpit, 0.04);
        }
        for (int p = 0; p < MUS_SCAN_PART_COUNT && !row[k].stated; p++)
            ck_assert_double_lt(report.mesh_to_body[p][0], 1e-3);

        /* girths where they were made: heights of torso and legs; along X those of the arms */
        double upper[3], wrist[3], elbow[3];
        const int32_t arm = limb_of(own, "arm_left");
        for (int32_t c = 0; c < mus_body_contour_count(own, arm); c++) {
            const char *name = mus_body_contour_name(own, arm, c);
            if (strcmp(name, "upper_arm") == 0) tape_of(own, arm, c, upper);
            if (strcmp(name, "elbow") == 0) tape_of(own, arm, c, elbow);
            if (strcmp(name, "wrist") == 0) tape_of(own, arm, c, wrist);
        }
        ck_assert(upper[0] < elbow[0] && elbow[0] < wrist[0]);
        const double inleg = mus_body_made(rest, MUS_MEASURE_INLEG);
        const double high = mus_body_made(rest, MUS_MEASURE_WAIST_HEIGHT);
        const struct {
            int32_t measure;
            const char *limb;
            int axis;
            double place;
        } girth[] = {{MUS_MEASURE_BUST, "torso", 1, mus_body_made(rest, MUS_MEASURE_BUST_HEIGHT)},
                     {MUS_MEASURE_WAIST, "torso", 1, high},
                     {MUS_MEASURE_HIP, "torso", 1, high - mus_body_made(rest, MUS_MEASURE_WAIST_TO_HIP)},
                     {MUS_MEASURE_KNEE, "leg_left", 1, 0.60 * inleg},
                     {MUS_MEASURE_CALF, "leg_right", 1, 0.43 * inleg},
                     {MUS_MEASURE_UPPER_ARM, "arm_left", 0, upper[0]},
                     {MUS_MEASURE_UPPER_ARM, "arm_right", 0, -upper[0]},
                     {MUS_MEASURE_WRIST, "arm_left", 0, wrist[0]},
                     {MUS_MEASURE_WRIST, "arm_right", 0, -wrist[0]}};
        for (size_t g = 0; g < sizeof girth / sizeof *girth; g++) {
            const double round = tape_at(body, girth[g].limb, girth[g].axis, girth[g].place);
            ck_assert_msg(fabs(round - mus_body_made(rest, girth[g].measure)) < 0.005, "%s %s: %g, made %g",
                          row[k].size, mus_measure_name(girth[g].measure), round,
                          mus_body_made(rest, girth[g].measure));
        }

        /* and where the report finds them */
        static const int32_t found[][2] = {{MUS_SCAN_BUST, MUS_MEASURE_BUST},
                                           {MUS_SCAN_WAIST, MUS_MEASURE_WAIST},
                                           {MUS_SCAN_HIP, MUS_MEASURE_HIP},
                                           {MUS_SCAN_WRIST, MUS_MEASURE_WRIST}};
        for (int g = 0; g < 4; g++)
            ck_assert_msg(fabs(report.girth[found[g][0]] - mus_body_made(rest, found[g][1])) < 0.005,
                          "%s %s found: %g", row[k].size, mus_measure_name(found[g][1]), report.girth[found[g][0]]);
        mus_body_destroy(body);
        mus_body_destroy(own);
        mus_body_destroy(rest);
        mus_tape_destroy(tape);
        support_context_end(context);
    }
}
END_TEST


/* turn an arm of an A-pose, hanging 45 degrees off a shoulder at (0.105, 0.79) of the height, up to level: more and
 * more of the turn from 0.03 to 0.13 of the height along it; nothing of the trunk below it */
static void arms_up(double *x, double height)
{
    const double c45 = sqrt(0.5), side = x[0] > 0.0 ? 1.0 : -1.0;
    const double at[2] = {x[0] - 0.105 * height * side, x[1] - 0.79 * height};
    const double along = c45 * (side * at[0] - at[1]), across = c45 * (side * at[0] + at[1]);
    double t = fmin(fmax((along / height - 0.03) / 0.10, 0.0), 1.0);
    t = t * t * (3.0 - 2.0 * t) * fmin(fmax((across / height + 0.075) / 0.03, 0.0), 1.0);
    if (side * x[0] < 0.03 * height || t <= 0.0) return;
    const double angle = 0.25 * MUS_PI * t * side, c = cos(angle), s = sin(angle);
    x[0] += c * at[0] - s * at[1] - at[0];
    x[1] += s * at[0] + c * at[1] - at[1];
}


START_TEST(a_scanned_body_with_its_arms_turned_up_keeps_its_girths)
{
    char path[512];
    if (support_data("garmentcode/bodies/mean_all.obj", path, sizeof path) == NULL) return;
    mus_context *context = support_context();
    mus_mesh *mesh;
    mus_scan_report report[2];
    mus_scan_def def;
    mus_scan_def_init(&def, sizeof def);
    def.distances = 0;
    ck_assert_int_eq(mus_mesh_read_obj(context, path, &mesh), MUS_OK);
    const int32_t n = mus_mesh_vertex_count(mesh);
    double *x = malloc(3 * (size_t)n * sizeof *x), high = -INFINITY;
    ck_assert_ptr_nonnull(x);
    memcpy(x, mus_mesh_vertices(mesh), 3 * (size_t)n * sizeof *x);
    for (int32_t v = 0; v < n; v++) high = fmax(high, x[3 * v + 1]);
    for (int pose = 0; pose < 2; pose++) {
        mus_body *body = NULL;
        for (int32_t v = 0; v < n && pose == 1; v++) arms_up(x + 3 * (ptrdiff_t)v, high);
        mus_scan_report_init(&report[pose], sizeof report[pose]);
        const mus_status status = mus_body_create_scan(context, n, x, mus_mesh_triangle_count(mesh),
                                                       mus_mesh_triangles(mesh), &def, &report[pose], &body);
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        mus_body_destroy(body);
    }
    for (int i = 0; i < 2; i++) {
        ck_assert_double_gt(report[0].arm_angle[i], 0.6);
        ck_assert_double_lt(fabs(report[1].arm_angle[i]), 0.15);
        ck_assert_double_eq_tol(report[1].armpit[i], report[0].armpit[i], 0.05);
    }
    for (int g = 0; g < MUS_SCAN_GIRTH_COUNT; g++)
        ck_assert_msg(fabs(report[1].girth[g] - report[0].girth[g]) < 0.005, "girth %d: %g, %g", g, report[0].girth[g],
                      report[1].girth[g]);
    free(x);
    mus_mesh_destroy(mesh);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_scan_pose(void)
{
    Suite *suite = suite_create("scan_pose");
    TCase *tests = tcase_create("scan_pose");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, a_t_pose_is_cut_into_the_same_body);
    tcase_add_test(tests, a_scanned_body_with_its_arms_turned_up_keeps_its_girths);
    suite_add_tcase(suite, tests);
    return suite;
}
