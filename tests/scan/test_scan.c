/*
 * test_scan.c: solids come back as themselves, our own bodies as themselves whichever way they are turned and whatever
 * their unit; what is damaged is handled or refused with one sentence.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/polygon.h"
#include "geom/vec.h"
#include "muslin/scan.h"
#include "scan/scan_section.h"
#include "scan/solids.h"
#include "support.h"

Suite *mus_suite_scan(void);

static const double as_it_is[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};


static mus_scan_def scan_form(void)
{
    mus_scan_def def;
    mus_scan_def_init(&def, sizeof def);
    def.up = MUS_SCAN_Y;
    def.unit = 1.0;
    return def;
}


static mus_status scan_solid(mus_context *context, const solid *s, const mus_scan_def *def, mus_scan_report *report,
                             mus_body **body)
{
    mus_scan_report_init(report, sizeof *report);
    return mus_body_create_scan(context, s->vertices, s->x, s->triangles, s->triangle, def, report, body);
}


/* a sentence that names what it should */
static void scan_refused(const solid *s, const mus_scan_def *def, mus_status expect, const char *word)
{
    mus_context *context = support_context();
    mus_scan_report report;
    mus_body *body = (mus_body *)context;
    const mus_status status = scan_solid(context, s, def, &report, &body);
    ck_assert_msg(status == expect && strstr(mus_context_error(context), word) != NULL, "%s for %s: %d %s", word,
                  mus_status_name(expect), (int)status, mus_context_error(context));
    ck_assert_ptr_null(body);
    support_context_end(context);
}


/* volume and distance of an ellipsoid: the mesh's own facets vanish as 1/n^2, and so does what is lost */
START_TEST(an_ellipsoid_comes_back_to_second_order)
{
    double before = 0.0;
    for (int32_t n = 24; n <= 192; n *= 2) {
        mus_context *context = support_context();
        mus_scan_def def = scan_form();
        mus_scan_report report;
        mus_body *body;
        solid s;
        solid_ellipsoid(n, 0.20, 0.45, 0.14, &s);
        ck_assert_int_eq(scan_solid(context, &s, &def, &report, &body), MUS_OK);
        ck_assert_int_eq(mus_body_limb_count(body), 1);
        ck_assert_str_eq(mus_body_limb_name(body, 0), "torso");
        const double off = 1.0 - mus_body_volume(body) / (4.0 / 3.0 * MUS_PI * 0.20 * 0.45 * 0.14);
        if (n > 24) ck_assert_msg(off < 0.32 * before, "%d: %g after %g", (int)n, off, before);
        ck_assert_double_gt(off, 0.0);
        ck_assert_double_lt(report.body_to_mesh[MUS_SCAN_TORSO][0], 2e-4);
        ck_assert_double_lt(report.mesh_to_body[MUS_SCAN_TORSO][1], n > 90 ? 5e-4 : 2e-3);

        before = off;
        mus_body_destroy(body);
        solid_free(&s);
        support_context_end(context);
    }
    ck_assert_double_lt(before, 1.5e-3);
}
END_TEST


/* depth, girth and height of a cylinder; the sphere is the ellipsoid of equal axes */
START_TEST(a_cylinder_and_a_sphere_have_their_depths)
{
    mus_context *context = support_context();
    mus_scan_def def = scan_form();
    mus_scan_report report;
    mus_body *body;
    solid s;
    solid_cylinder(256, 0.15, 0.10, 0.80, &s);
    ck_assert_int_eq(scan_solid(context, &s, &def, &report, &body), MUS_OK);
    ck_assert_double_eq_tol(report.stature, 0.80, 1e-12);
    ck_assert_double_eq_tol(mus_body_volume(body), MUS_PI * 0.15 * 0.10 * 0.80, 2e-5);
    /* Ramanujan's perimeter of the ellipse, which is exact here to 1e-7 */
    const double girth = MUS_PI * (3.0 * 0.25 - sqrt((0.45 + 0.10) * (0.15 + 0.30)));
    ck_assert_double_eq_tol(report.girth[MUS_SCAN_WAIST], girth, 1e-4);
    mus_body_destroy(body);
    solid_free(&s);

    solid_ellipsoid(256, 0.3, 0.3, 0.3, &s);
    ck_assert_int_eq(scan_solid(context, &s, &def, &report, &body), MUS_OK);
    uint64_t seed = 3;
    for (int i = 0; i < 1000; i++) {
        double p[3], depth, normal[3], r = support_uniform(&seed, 0.294, 0.306);
        for (int k = 0; k < 3; k++) p[k] = support_uniform(&seed, -1.0, 1.0);
        mus__unit3(p);
        for (int k = 0; k < 3; k++) p[k] = r * p[k] + (k == 1 ? 0.3 : 0.0);
        ck_assert_int_eq(mus_body_depth(body, 1, p, &depth, normal), MUS_OK);
        ck_assert_double_eq_tol(depth, 0.3 - r, 4e-4 + 0.4 * fabs(0.3 - r));
    }
    mus_body_destroy(body);
    solid_free(&s);
    support_context_end(context);
}
END_TEST


/* tape of an upright limb at a height: the cubic through the two contours below it and the two above */
static double scan_tape_at(const mus_body *body, const char *name, double height)
{
    enum { SAMPLES = 192 };
    double x[3 * SAMPLES], xy[2 * SAMPLES], at[4] = {0.0}, tape[4] = {0.0}, sum = 0.0;
    int32_t work[2 * SAMPLES], limb = 0, above = 0;
    while (strcmp(mus_body_limb_name(body, limb), name) != 0) limb++;
    for (int32_t i = 0; i < mus_body_contour_count(body, limb) && above < 2; i++) {
        ck_assert_int_eq(mus_body_contour_points(body, limb, i, SAMPLES, x), MUS_OK);
        for (int32_t k = 0; k < SAMPLES; k++) xy[2 * k] = x[3 * k], xy[2 * k + 1] = x[3 * k + 2];
        memmove(at, at + 1, 3 * sizeof *at);
        memmove(tape, tape + 1, 3 * sizeof *tape);
        at[3] = x[1], tape[3] = mus__polygon_tape(SAMPLES, xy, work, work + SAMPLES);
        above += x[1] >= height;
    }
    for (int i = 0; i < 4; i++) {
        double part = tape[i];
        for (int j = 0; j < 4; j++)
            if (j != i) part *= (height - at[j]) / (at[i] - at[j]);
        sum += part;
    }
    return sum;
}


/* our own body, limbs that are shells which overlap: contours lie on it, its volume and its girths come back */
START_TEST(our_own_body_comes_back)
{
    static const char *const sizes[] = {"W40", "M50", "C116"};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        mus_context *context = support_context();
        mus_scan_report report;
        mus_body *body, *own;
        mus_tape *tape;
        solid s;
        solid_person(sizes[k], NULL, &s);
        mus_scan_def def;
        mus_scan_def_init(&def, sizeof def);
        def.spacing = 0.008;
        ck_assert_int_eq(scan_solid(context, &s, &def, &report, &body), MUS_OK);
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_size(tape, sizes[k]), MUS_OK);
        ck_assert_int_eq(mus_body_create(context, tape, NULL, &own), MUS_OK);
        ck_assert_int_eq(mus_body_limb_count(body), mus_body_limb_count(own));
        for (int32_t l = 0; l < mus_body_limb_count(own); l++)
            ck_assert_str_eq(mus_body_limb_name(body, l), mus_body_limb_name(own, l));

        ck_assert_double_eq(report.unit, 1.0);
        ck_assert_double_eq_tol(report.stature, mus_body_made(own, MUS_MEASURE_STATURE), 1e-5);
        /* the torso ends in a narrow tip between the legs, and the skin is rounded where they meet */
        ck_assert_double_eq_tol(report.crotch, mus_body_made(own, MUS_MEASURE_INLEG), 0.015);
        ck_assert_double_eq_tol(report.arm_angle[0], mus_body_asked(own, MUS_MEASURE_ARM_ANGLE), 0.02);
        /* girths away from where limbs meet, at the heights where they are made; the bust has a crest there, and the
         * waist is the narrowest of rings 15 mm apart, which lie between two of the scan's contours */
        const double inleg = mus_body_asked(own, MUS_MEASURE_INLEG);
        const struct {
            int32_t measure;
            const char *limb;
            double height, most;
        } girths[] = {{MUS_MEASURE_BUST, "torso", mus_body_made(own, MUS_MEASURE_BUST_HEIGHT), 2e-3},
                      {MUS_MEASURE_WAIST, "torso", mus_body_made(own, MUS_MEASURE_WAIST_HEIGHT), 1.5e-3},
                      {MUS_MEASURE_KNEE, "leg_left", 0.60 * inleg, 1e-3},
                      {MUS_MEASURE_CALF, "leg_right", 0.43 * inleg, 1e-3}};
        for (size_t g = 0; g < sizeof girths / sizeof *girths; g++) {
            const double round = scan_tape_at(body, girths[g].limb, girths[g].height);
            ck_assert_msg(fabs(round - mus_body_made(own, girths[g].measure)) < girths[g].most, "%s %s: %g, made %g",
                          sizes[k], mus_measure_name(girths[g].measure), round, mus_body_made(own, girths[g].measure));
        }
        ck_assert_double_eq_tol(mus_body_volume(body) / mus_body_volume(own), 1.0, 1e-2);
        for (int p = 0; p < MUS_SCAN_PART_COUNT; p++) {
            ck_assert_double_lt(report.body_to_mesh[p][0], 1e-4);
            /* faces, fingers and toes are of the picture */
            const bool relief = p == MUS_SCAN_HEAD || p == MUS_SCAN_HANDS || p == MUS_SCAN_FEET;
            ck_assert_double_lt(report.body_to_mesh[p][1], relief ? 1e-2 : 1e-3);
        }
        mus_body_destroy(body);
        mus_body_destroy(own);
        mus_tape_destroy(tape);
        solid_free(&s);
        support_context_end(context);
    }
}
END_TEST


/* any file axis up, turned about the vertical, moved, in any unit, mirrored triangles: the same girths */
START_TEST(turned_bodies_come_back_the_same)
{
    static const struct {
        double unit;
        const char *name;
    } units[] = {{1.0, "m"}, {100.0, "cm"}, {1000.0, "mm"}};
    uint64_t seed = 11;
    mus_scan_report first = {0};
    mus_scan_def def;
    mus_scan_def_init(&def, sizeof def);
    def.distances = 0;
    for (int round = 0; round < 10; round++) {
        mus_context *context = support_context();
        mus_scan_report report;
        mus_body *body;
        solid s;
        solid_person("W40", NULL, &s);
        const double angle = round == 0 ? 0.0 : support_uniform(&seed, 0.0, 2.0 * MUS_PI), c = cos(angle),
                     n = sin(angle);
        const double about[9] = {c, 0, n, 0, 1, 0, -n, 0, c}, place[3] = {0.3, -1.0, 2.0};
        static const double tip[4][9] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},
                                         {1, 0, 0, 0, 0, -1, 0, 1, 0},
                                         {0, -1, 0, 1, 0, 0, 0, 0, 1},
                                         {1, 0, 0, 0, -1, 0, 0, 0, -1}};
        const double unit = units[round % 3].unit;
        solid_move(&s, 1.0, about, NULL);
        solid_move(&s, unit, tip[round % 4], round == 0 ? NULL : place);
        for (int32_t t = 0; t < s.triangles && round % 2 == 1; t++) {
            const int32_t swap = s.triangle[3 * t];
            s.triangle[3 * t] = s.triangle[3 * t + 1], s.triangle[3 * t + 1] = swap;
        }
        ck_assert_msg(scan_solid(context, &s, &def, &report, &body) == MUS_OK, "%d: %s", round,
                      mus_context_error(context));
        ck_assert_double_eq_tol(report.unit * unit, 1.0, 1e-12);
        if (round == 0) first = report;
        for (int g = 0; g < MUS_SCAN_GIRTH_COUNT; g++) ck_assert_double_eq_tol(report.girth[g], first.girth[g], 1e-3);
        ck_assert_double_eq_tol(report.crotch, first.crotch, 1e-3);

        /* the report's own way from the mesh to the body */
        double low = INFINITY;
        for (int32_t v = 0; v < s.vertices; v++) {
            const double y = report.unit * mus__dot3(report.frame + 3, s.x + 3 * (ptrdiff_t)v) + report.place[1];
            low = fmin(low, y);
        }
        ck_assert_double_eq_tol(low, 0.0, 1e-9);
        mus_body_destroy(body);
        solid_free(&s);
        support_context_end(context);
    }
}
END_TEST


START_TEST(a_unit_that_may_be_two_is_refused_by_both)
{
    solid s;
    solid_person("W40", NULL, &s);
    solid_move(&s, 1.0 / 0.0254, as_it_is, NULL);
    scan_refused(&s, NULL, MUS_ERR_BODY, "1.68 m (inch)");
    mus_context *context = support_context();
    mus_scan_def def;
    mus_scan_def_init(&def, sizeof def);
    def.unit = 0.0254;
    mus_scan_report report;
    mus_body *body;
    ck_assert_int_eq(scan_solid(context, &s, &def, &report, &body), MUS_OK);
    ck_assert_double_eq_tol(report.stature, 1.68, 1e-5);
    mus_body_destroy(body);
    support_context_end(context);
    solid_move(&s, 1e5, as_it_is, NULL);
    scan_refused(&s, NULL, MUS_ERR_BODY, "set unit");
    solid_free(&s);
}
END_TEST


START_TEST(what_is_no_person_has_no_up)
{
    solid s;
    solid_ellipsoid(48, 0.3, 0.3, 0.3, &s);
    scan_refused(&s, NULL, MUS_ERR_BODY, "set up");
    solid_free(&s);
}
END_TEST


START_TEST(damaged_meshes_have_one_sentence)
{
    solid s;
    mus_scan_def def = scan_form();
    solid_ellipsoid(48, 0.20, 0.45, 0.14, &s);
    const double good = s.x[7];
    s.x[7] = NAN;
    scan_refused(&s, &def, MUS_ERR_ARG, "vertex 2 ");
    s.x[7] = good;
    s.triangle[5] = s.vertices;
    scan_refused(&s, &def, MUS_ERR_ARG, "triangle 1 ");
    s.triangle[5] = -1;
    scan_refused(&s, &def, MUS_ERR_ARG, "triangle 1 ");
    solid_free(&s);

    /* a sheet: half of the ellipsoid is missing */
    solid_ellipsoid(48, 0.20, 0.45, 0.14, &s);
    int32_t kept = 0;
    for (int32_t t = 0; t < s.triangles; t++) {
        const int32_t *v = s.triangle + 3 * (ptrdiff_t)t;
        if (s.x[3 * v[0]] > 0.01 || s.x[3 * v[1]] > 0.01 || s.x[3 * v[2]] > 0.01) continue;
        memmove(s.triangle + 3 * (ptrdiff_t)kept++, v, 3 * sizeof *v);
    }
    s.triangles = kept;
    scan_refused(&s, &def, MUS_ERR_BODY, "hole");
    s.triangles = 3;
    scan_refused(&s, &def, MUS_ERR_ARG, "3 triangles");
    solid_free(&s);

    /* all at one place */
    solid_cylinder(16, 0.0, 0.0, 0.0, &s);
    scan_refused(&s, &def, MUS_ERR_BODY, "one place");
    solid_free(&s);
}
END_TEST


/* small holes are closed and told; doubled and split triangles change nothing */
START_TEST(holes_and_doubles_are_handled)
{
    mus_context *context = support_context();
    mus_scan_report whole, report;
    mus_body *body;
    mus_scan_def def;
    solid s;
    mus_scan_def_init(&def, sizeof def);
    def.distances = 0;
    solid_person("W40", NULL, &s);
    ck_assert_int_eq(scan_solid(context, &s, &def, &whole, &body), MUS_OK);
    mus_body_destroy(body);
    ck_assert_int_eq(whole.holes, 0);

    /* each triangle a second time */
    solid twice = {s.vertices, 2 * s.triangles, s.x, NULL};
    twice.triangle = calloc(6 * (size_t)s.triangles, sizeof *twice.triangle);
    memcpy(twice.triangle, s.triangle, 3 * (size_t)s.triangles * sizeof *s.triangle);
    memcpy(twice.triangle + 3 * (ptrdiff_t)s.triangles, s.triangle, 3 * (size_t)s.triangles * sizeof *s.triangle);
    ck_assert_int_eq(scan_solid(context, &twice, &def, &report, &body), MUS_OK);
    ck_assert_mem_eq(&report, &whole, sizeof report);
    mus_body_destroy(body);
    free(twice.triangle);

    /* soup: no two triangles share a vertex */
    solid soup = {3 * s.triangles, s.triangles, NULL, NULL};
    soup.x = calloc(9 * (size_t)s.triangles, sizeof *soup.x);
    soup.triangle = calloc(3 * (size_t)s.triangles, sizeof *soup.triangle);
    for (int32_t k = 0; k < 3 * s.triangles; k++) {
        soup.triangle[k] = k;
        memcpy(soup.x + 3 * (ptrdiff_t)k, s.x + 3 * (ptrdiff_t)s.triangle[k], 3 * sizeof *s.x);
    }
    ck_assert_int_eq(scan_solid(context, &soup, &def, &report, &body), MUS_OK);
    ck_assert_int_eq(report.vertices, whole.vertices);
    for (int g = 0; g < MUS_SCAN_GIRTH_COUNT; g++) ck_assert_double_eq(report.girth[g], whole.girth[g]);
    mus_body_destroy(body);
    solid_free(&soup);

    /* every 97th triangle is missing */
    int32_t kept = 0;
    for (int32_t t = 0; t < s.triangles; t++)
        if (t % 97 != 0)
            memmove(s.triangle + 3 * (ptrdiff_t)kept++, s.triangle + 3 * (ptrdiff_t)t, 3 * sizeof(int32_t));
    s.triangles = kept;
    ck_assert_msg(scan_solid(context, &s, &def, &report, &body) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_gt(report.holes, 0);
    ck_assert_double_lt(report.widest_hole, 0.06);
    for (int g = 0; g < MUS_SCAN_GIRTH_COUNT; g++) ck_assert_double_eq_tol(report.girth[g], whole.girth[g], 1e-3);
    mus_body_destroy(body);
    solid_free(&s);
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_of_a_scan_is_a_status)
{
    solid s;
    mus_scan_def def = scan_form();
    solid_ellipsoid(24, 0.20, 0.45, 0.14, &s);
    def.spacing = 0.05;
    def.corners = 16, def.samples = 16;
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_scan_report report;
        mus_body *body;
        support_fail_after(n, n % 2 == 1); /* every second time all that follow fail too */
        const mus_status status = scan_solid(context, &s, &def, &report, &body);
        support_fail_never();
        mus_body_destroy(body);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
    solid_free(&s);
}
END_TEST


/* a section is empty after each failure: what asks it for the nearest loop would read an array that is not there */
START_TEST(a_section_that_found_no_memory_is_empty)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, axis[3] = {0.0, 1.0, 0.0}, side[3] = {1.0, 0.0, 0.0};
    solid s;
    solid_ellipsoid(12, 0.20, 0.45, 0.14, &s);
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus__scan_mesh mesh;
        mus__slicer slicer;
        ck_assert_int_eq(mus__scan_weld(context, s.vertices, s.x, s.triangles, s.triangle, &mesh), MUS_OK);
        ck_assert_int_eq(mus__slicer_make(&mesh, origin, axis, side, 0.01, &slicer), MUS_OK);
        support_fail_after(n, true);
        const mus_status status = mus__slice(&slicer, 0.5 * (slicer.low + slicer.high), "a solid");
        support_fail_never();
        if (status != MUS_OK) ck_assert_int_eq(slicer.section.loops + slicer.section.points, 0);
        mus__slicer_free(&slicer);
        mus__scan_mesh_free(&mesh);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
    solid_free(&s);
}
END_TEST


Suite *mus_suite_scan(void)
{
    Suite *suite = suite_create("scan");
    TCase *tests = tcase_create("scan");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, an_ellipsoid_comes_back_to_second_order);
    tcase_add_test(tests, a_cylinder_and_a_sphere_have_their_depths);
    tcase_add_test(tests, our_own_body_comes_back);
    if (!SUPPORT_SLOW) tcase_add_test(tests, turned_bodies_come_back_the_same);
    tcase_add_test(tests, a_unit_that_may_be_two_is_refused_by_both);
    tcase_add_test(tests, what_is_no_person_has_no_up);
    tcase_add_test(tests, damaged_meshes_have_one_sentence);
    tcase_add_test(tests, holes_and_doubles_are_handled);
    tcase_add_test(tests, each_failing_allocation_of_a_scan_is_a_status);
    tcase_add_test(tests, a_section_that_found_no_memory_is_empty);
    suite_add_tcase(suite, tests);
    return suite;
}
