/* test_refused_scan.c: numbers that are not finite at the doors of scanning: refused by name. */
#include "muslin/scan.h"
#include "refused.h"
#include "scan/solids.h"

Suite *mus_suite_refused_scan(void);


static mus_status try_scan(mus_context *context, const void *def, void *user)
{
    const solid *s = user;
    mus_body *body;
    const mus_status status =
        mus_body_create_scan(context, s->vertices, s->x, s->triangles, s->triangle, def, NULL, &body);
    ck_assert_int_eq(status == MUS_OK, body != NULL);
    mus_body_destroy(body);
    return status;
}


START_TEST(a_scan_def_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_scan_def, unit, 1, false, "unit"),
        REFUSED(mus_scan_def, spacing, 1, false, "spacing"),
        REFUSED(mus_scan_def, gap, 1, false, "gap"),
        REFUSED(mus_scan_def, ring_spacing, 1, false, "ring_spacing"),
    };
    mus_scan_def def;
    solid s;
    solid_ellipsoid(24, 0.2, 0.4, 0.2, &s);
    mus_scan_def_init(&def, sizeof def);
    def.up = MUS_SCAN_Y;
    def.unit = 1.0;
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_scan, &s);

    /* whole numbers out of range */
    mus_context *context = support_context();
    for (int c = 0; c < 6; c++) {
        mus_scan_def bad = def;
        const char *word;
        switch (c) {
        case 0: bad.up = 4, word = "up 4"; break;
        case 1: bad.front = -4, word = "front -4"; break;
        case 2: bad.front = MUS_SCAN_Y, word = "one axis"; break;
        case 3: bad.corners = 15, word = "corners 15"; break;
        case 4: bad.corners = 1025, word = "corners 1025"; break;
        default: bad.samples = 17, word = "samples 17"; break;
        }
        ck_assert_int_eq(try_scan(context, &bad, &s), MUS_ERR_ARG);
        ck_assert_msg(strstr(mus_context_error(context), word) != NULL, "%s", mus_context_error(context));
    }
    def.size = 3;
    ck_assert_int_eq(try_scan(context, &def, &s), MUS_ERR_VERSION);
    mus_body *body;
    mus_scan_report report = {.size = 3};
    ck_assert_int_eq(mus_body_create_scan(context, s.vertices, s.x, s.triangles, s.triangle, NULL, &report, &body),
                     MUS_ERR_VERSION);
    ck_assert_int_eq(mus_body_create_scan(context, 8, NULL, 8, NULL, NULL, NULL, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create_scan(NULL, 8, NULL, 8, NULL, NULL, NULL, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create_scan(context, 8, NULL, 8, NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    support_context_end(context);
    solid_free(&s);
}
END_TEST


/* mus_body_create_scan: each coordinate of a vertex */
START_TEST(a_vertex_that_is_not_finite_is_refused_by_its_number)
{
    mus_context *context = support_context();
    mus_scan_def def;
    solid s;
    mus_scan_def_init(&def, sizeof def);
    def.up = MUS_SCAN_Y;
    def.unit = 1.0;
    solid_ellipsoid(24, 0.2, 0.4, 0.2, &s);
    for (int i = 0; i < 3; i++)
        for (int v = 0; v < 3; v++) {
            const double good = s.x[12 + i];
            s.x[12 + i] = refused_values[v];
            ck_assert_int_eq(try_scan(context, &def, &s), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "vertex 4 "));
            s.x[12 + i] = good;
        }
    solid_free(&s);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_scan(void)
{
    Suite *suite = suite_create("refused_scan");
    TCase *tests = tcase_create("refused_scan");
    tcase_add_test(tests, a_scan_def_that_is_not_finite_is_refused_by_name);
    tcase_add_test(tests, a_vertex_that_is_not_finite_is_refused_by_its_number);
    suite_add_tcase(suite, tests);
    return suite;
}
