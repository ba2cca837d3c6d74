/*
 * test_val_read.c: a pattern in Valentina's form, written for this test: what is drawn, what a piece keeps, what is
 * refused. `make trade` reads Valentina's own.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "support.h"

/* a rectangle of 20 by 30 cm, its upper edge an arch, cut along the arch's half by a point on it */
static const char drawing[] =
    "<?xml version='1.0' encoding='UTF-8'?>\n<!-- by hand -->\n<pattern>\n<version>0.8.5</version>\n<unit>cm</unit>\n"
    "<increments><increment name=\"#ease\" formula=\"hip_circ/49\"/></increments>\n"
    "<draw name=\"skirt\">\n<calculation>\n"
    "<point type=\"single\" id=\"1\" name=\"A\" x=\"0\" y=\"0\"/>\n"
    "<point type=\"endLine\" id=\"2\" name=\"B\" basePoint=\"1\" angle=\"0\" length=\"hip_circ/5+#ease-1.6\"/>\n"
    "<point type=\"endLine\" id=\"3\" name=\"C\" basePoint=\"2\" angle=\"270\" length=\"Line_A_B*1.5\"/>\n"
    "<point type=\"pointOfIntersection\" id=\"4\" name=\"D\" firstPoint=\"1\" secondPoint=\"3\"/>\n"
    "<spline type=\"simpleInteractive\" id=\"5\" point1=\"1\" point4=\"2\" angle1=\"90\" angle2=\"90\" length1=\"4\" "
    "length2=\"4\"/>\n"
    "<point type=\"cutSpline\" id=\"6\" name=\"M\" spline=\"5\" length=\"Spl_A_B/2\"/>\n"
    "<line firstPoint=\"6\" secondPoint=\"4\" id=\"9\"/>\n"
    "<operation type=\"moving\" id=\"10\" angle=\"0\" length=\"100\" suffix=\"x\"><source><item idObject=\"1\"/>"
    "<item idObject=\"5\"/></source><destination><item idObject=\"11\"/><item idObject=\"12\"/></destination>"
    "</operation>"
    "\n</calculation>\n<modeling>\n<point type=\"modeling\" id=\"20\" idObject=\"1\"/>\n"
    "<spline type=\"modelingSpline\" id=\"21\" idObject=\"5\"/>\n<point type=\"modeling\" id=\"22\" idObject=\"6\"/>\n"
    "<point type=\"modeling\" id=\"23\" idObject=\"3\"/>\n<point type=\"modeling\" id=\"24\" idObject=\"4\"/>\n"
    "<path type=\"2\" id=\"25\" name=\"pocket\"><nodes><node idObject=\"22\"/><node idObject=\"24\"/></nodes></path>\n"
    "</modeling>\n<details>\n<detail id=\"30\" name=\"Half\" seamAllowance=\"true\" width=\"1.5\" inLayout=\"true\">\n"
    "<data><mcp cutNumber=\"2\" material=\"0\" placement=\"0\"/></data>\n"
    "<grainline visible=\"true\" rotation=\"45*2\" length=\"5\"/>\n<nodes>\n"
    "<node type=\"NodePoint\" idObject=\"20\"/>\n<node type=\"NodeSpline\" reverse=\"0\" idObject=\"21\"/>\n"
    "<node type=\"NodePoint\" idObject=\"22\" after=\"0.5\" passmark=\"true\" passmarkLine=\"two\"/>\n"
    "<node type=\"NodePoint\" idObject=\"23\"/>\n<node type=\"NodePoint\" idObject=\"24\"/>\n</nodes>\n"
    "<iPaths><record path=\"25\"/></iPaths>\n</detail>\n</details>\n</draw>\n</pattern>\n";

static const char measures[] = "<vit><unit>mm</unit><body-measurements><m name=\"hip_circ\" value=\"980\"/>"
                               "<m name=\"@half\" value=\"hip_circ/2\"/></body-measurements></vit>";


static mus_status read_text(mus_context *context, const char *text, const char *tape, mus_pattern **out)
{
    mus_pattern_val from;
    mus_pattern_val_init(&from, sizeof from);
    from.path = "a.val", from.text = text, from.text_size = strlen(text);
    if (tape != NULL) from.measures_path = "a.vit", from.measures = tape, from.measures_size = strlen(tape);
    return mus_pattern_read_val(context, &from, out);
}


START_TEST(a_piece_is_a_panel_with_its_curve_cut_at_the_point)
{
    mus_context *context = support_context();
    mus_pattern *pattern = NULL;
    ck_assert_msg(read_text(context, drawing, measures, &pattern) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_pattern_panel_count(pattern), 1);
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 0), "Half");
    int32_t n = 0, copies = 0;
    const int32_t *edges = NULL, *signs = NULL;
    ck_assert_int_eq(mus_pattern_outline(pattern, 0, &n, &edges, &signs), MUS_OK);
    ck_assert_int_eq(n, 4); /* half the arch, M to C, C to D, D to A; counter-clockwise they are turned round */
    ck_assert_int_eq(signs[0], -1);
    double grain[2], shortest = 1.0, longest = 0.0;
    for (int32_t i = 0; i < n; i++) {
        shortest = fmin(shortest, mus_pattern_edge_length(pattern, edges[i]));
        longest = fmax(longest, mus_pattern_edge_length(pattern, edges[i]));
    }
    ck_assert_double_eq_tol(longest, sqrt(0.1 * 0.1 + 0.33 * 0.33), 1e-4); /* M is 3 cm over the middle of A and B */
    ck_assert_double_gt(shortest, 0.1);
    mus_pattern_grain(pattern, 0, grain);
    ck_assert_double_eq_tol(grain[1], 1.0, 1e-12);
    mus_pattern_cut(pattern, 0, &copies, NULL);
    ck_assert_int_eq(copies, 2);
    ck_assert_int_eq(mus_pattern_notch_count(pattern), 1);
    ck_assert_int_eq(mus_pattern_mark_count(pattern), 1);
    int32_t own = 0;
    for (int32_t i = 0; i < n; i++) own += fabs(mus_pattern_edge_allowance(pattern, edges[i]) - 0.005) < 1e-12;
    ck_assert_int_eq(own, 1);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* the message for the drawing with one text replaced by another */
static void refused(const char *from, const char *to, mus_status wanted, const char *message)
{
    mus_context *context = support_context();
    mus_pattern *pattern = NULL;
    char *text = malloc(sizeof drawing + strlen(to));
    const char *at = strstr(drawing, from);
    ck_assert_ptr_nonnull(at);
    memcpy(text, drawing, (size_t)(at - drawing));
    strcpy(text + (at - drawing), to);
    strcat(text, at + strlen(from));
    ck_assert_int_eq(read_text(context, text, measures, &pattern), wanted);
    ck_assert_msg(strstr(mus_context_error(context), message) != NULL, "%s", mus_context_error(context));
    ck_assert_ptr_null(pattern);
    free(text);
    support_context_end(context);
}


START_TEST(what_is_wrong_is_told_with_line_and_formula)
{
    refused("hip_circ/5", "waist/5", MUS_ERR_FORMAT, "a.val:10: length: in \"waist/5+#ease-1.6\" the part \"waist/5");
    refused("type=\"cutSpline\"", "type=\"cutFog\"", MUS_ERR_UNSUPPORTED, "does not know its type \"cutFog\"");
    refused("basePoint=\"1\"", "basePoint=\"5\"", MUS_ERR_FORMAT, "no point has the id \"5\"");
    refused("id=\"6\"", "id=\"3\"", MUS_ERR_FORMAT, "its id is taken");
    refused("id=\"30\"", "id=\"99999999\"", MUS_ERR_LIMIT, "id 99999999, expected 0 to");
    refused("<unit>cm", "<unit>ell", MUS_ERR_FORMAT, "unit: expected mm, cm or inch");
    refused("inLayout=\"true\"", "inLayout=\"0\"", MUS_ERR_FORMAT, "the pattern has no piece");
    refused("idObject=\"21\"/>", "idObject=\"77\"/>", MUS_ERR_FORMAT, "a node of a piece has no object");
    refused("</draw>", "</drawn>", MUS_ERR_FORMAT, "expected XML");
    refused("<pattern>", "<!DOCTYPE a><pattern>", MUS_ERR_FORMAT, "document type declaration");
}
END_TEST


START_TEST(a_multisize_table_has_its_sizes)
{
    mus_context *context = support_context();
    const char table[] = "<vst><unit>mm</unit><size base=\"500\"/><height base=\"1760\"/><body-measurements>"
                         "<m name=\"hip_circ\" base=\"940\" size_increase=\"30\" height_increase=\"10\"/>"
                         "</body-measurements></vst>";
    mus_pattern_val from;
    mus_pattern_val_init(&from, sizeof from);
    from.path = "a.val", from.text = drawing, from.text_size = strlen(drawing);
    from.measures_path = "a.vst", from.measures = table, from.measures_size = strlen(table);
    from.size_name = "520_1820"; /* 940 + 30 + 10 */
    mus_pattern *pattern = NULL, *other = NULL;
    ck_assert_msg(mus_pattern_read_val(context, &from, &pattern) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(read_text(context, drawing, measures, &other), MUS_OK);
    for (int32_t e = 0; e < mus_pattern_edge_count(other); e++)
        ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, e), mus_pattern_edge_length(other, e), 1e-9);
    mus_pattern_destroy(pattern);
    mus_pattern_destroy(other);
    from.size_name = "large";
    ck_assert_int_eq(mus_pattern_read_val(context, &from, &pattern), MUS_ERR_ARG);
    from.size--;
    ck_assert_int_eq(mus_pattern_read_val(context, &from, &pattern), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_pattern_read_val(context, NULL, &pattern), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(a_right_angle_is_where_valentina_finds_it)
{
    const char text[] =
        "<pattern><unit>mm</unit><draw name=\"d\"><calculation>"
        "<point type=\"single\" id=\"1\" name=\"A\" x=\"0\" y=\"0\"/>"
        "<point type=\"endLine\" id=\"2\" name=\"B\" basePoint=\"1\" angle=\"0\" length=\"200\"/>"
        "<point type=\"endLine\" id=\"3\" name=\"C\" basePoint=\"1\" angle=\"0\" length=\"50\"/>"
        "<point type=\"endLine\" id=\"4\" name=\"D\" basePoint=\"3\" angle=\"90\" length=\"10\"/>"
        "<point type=\"triangle\" id=\"5\" name=\"T\" axisP1=\"3\" axisP2=\"4\" firstPoint=\"1\" "
        "secondPoint=\"2\"/>"
        "</calculation><modeling><point type=\"modeling\" id=\"6\" idObject=\"1\"/>"
        "<point type=\"modeling\" id=\"7\" idObject=\"2\"/><point type=\"modeling\" id=\"8\" idObject=\"5\"/>"
        "</modeling><details><detail id=\"9\" name=\"p\"><nodes><node type=\"NodePoint\" idObject=\"6\"/>"
        "<node type=\"NodePoint\" idObject=\"7\"/><node type=\"NodePoint\" idObject=\"8\"/></nodes></detail></details>"
        "</draw></pattern>";
    mus_context *context = support_context();
    mus_pattern *pattern = NULL;
    ck_assert_msg(read_text(context, text, NULL, &pattern) == MUS_OK, "%s", mus_context_error(context));
    /* the right angle is 86.60 mm high, 327.3 pixels; cut to whole pixels the sides are 755, 378 and 654 at 328 */
    ck_assert_double_eq_tol(1e6 * mus_pattern_panel_area(pattern, 0), 100.0 * 328.0 * 25.4 / 96.0, 1e-6);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_val_read(void);

Suite *mus_suite_val_read(void)
{
    Suite *suite = suite_create("val_read");
    TCase *tests = tcase_create("val_read");
    tcase_add_test(tests, a_piece_is_a_panel_with_its_curve_cut_at_the_point);
    tcase_add_test(tests, what_is_wrong_is_told_with_line_and_formula);
    tcase_add_test(tests, a_multisize_table_has_its_sizes);
    tcase_add_test(tests, a_right_angle_is_where_valentina_finds_it);
    suite_add_tcase(suite, tests);
    return suite;
}
