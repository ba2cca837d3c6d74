/*
 * test_garmentcode.c: GarmentCode specifications: all 139 real ones against figures that another program took of them
 * (facts.csv), and small ones written here against answers by hand.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/topology.h"
#include "support.h"

#define PI 3.14159265358979323846


/* read a text as a specification */
static mus_status read_spec(mus_context *context, const char *text, mus_pattern **out)
{
    char path[512];
    support_spill(support_scratch("square_specification.json", path, sizeof path), text, strlen(text));
    return mus_pattern_read(context, path, out);
}


/* the area that facts.csv holds: each curve as 40 chords of equal parameter */
static double chord_area(const mus_pattern *pattern, int32_t panel)
{
    int32_t n, count;
    const int32_t *edges, *directions;
    double xy[2 * 64], twice = 0.0;
    ck_assert_int_eq(mus_pattern_outline(pattern, panel, &n, &edges, &directions), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        ck_assert_int_eq(directions[i], 1);
        ck_assert_int_eq(mus_pattern_edge_polyline(pattern, edges[i], 40, xy, 64, &count), MUS_OK);
        for (int32_t k = 0; k + 1 < count; k++) twice += xy[2 * k] * xy[2 * k + 3] - xy[2 * k + 2] * xy[2 * k + 1];
    }
    return 0.5 * fabs(twice);
}


/* one line of facts.csv */
struct facts {
    char file[128];
    int panels, edges, stitches, right_wrong;
    double perimeter, area, stitched;
};


static void check_spec(mus_context *context, const struct facts *facts)
{
    char relative[256], path[512];
    bool sampled = facts->file[0] == 'd' && facts->file[1] >= '0' && facts->file[1] <= '9';
    snprintf(relative, sizeof relative, "garmentcode/%s/%s", sampled ? "specs" : "originals", facts->file);
    ck_assert_ptr_nonnull(support_data(relative, path, sizeof path));
    mus_pattern *pattern;
    mus_status status = mus_pattern_read(context, path, &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));

    ck_assert_int_eq(mus_pattern_panel_count(pattern), facts->panels);
    ck_assert_int_eq(mus_pattern_edge_count(pattern), facts->edges);
    ck_assert_int_eq(mus_pattern_seam_count(pattern), facts->stitches);
    ck_assert_int_eq(strncmp(facts->file, mus_pattern_name(pattern), strlen(mus_pattern_name(pattern))), 0);
    ck_assert_ptr_null(strstr(mus_pattern_name(pattern), "_specification"));

    /* in the file's centimetres; the figures there have 3 (area 2) decimals */
    double perimeter = 0.0, area = 0.0, stitched = 0.0;
    int direct = 0;
    for (int32_t i = 0; i < facts->panels; i++) {
        perimeter += 1e2 * mus_pattern_panel_perimeter(pattern, i);
        area += 1e4 * chord_area(pattern, i);
    }
    for (int32_t i = 0; i < facts->stitches; i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        ck_assert_int_eq(mus_pattern_seam(pattern, i, &seam), MUS_OK);
        double a = mus_pattern_edge_length(pattern, seam.edge_a), b = mus_pattern_edge_length(pattern, seam.edge_b);
        ck_assert_double_eq_tol(seam.ease, b - a, 1e-12);
        stitched += 1e2 * (a + b);
        direct += seam.direction == MUS_SEAM_DIRECT;
    }
    ck_assert_int_eq(direct, facts->right_wrong);
    ck_assert_double_eq_tol(perimeter, facts->perimeter, 1e-5 * facts->perimeter);
    ck_assert_double_eq_tol(area, facts->area, 1e-5 * facts->area);
    ck_assert_double_eq_tol(stitched, facts->stitched, 1e-5 * facts->stitched);

    /* none of them leaves the faults that a seam's ease does not excuse */
    int32_t count, kind;
    mus_faults *faults;
    ck_assert_int_eq(mus_pattern_check(pattern, &count, &faults), MUS_OK);
    for (int32_t i = 0; i < count; i++) {
        ck_assert_int_eq(mus_faults_item(faults, i, &kind, NULL, NULL, NULL), MUS_OK);
        ck_assert_msg(kind != MUS_FAULT_OPEN_OUTLINE && kind != MUS_FAULT_SEAM_LENGTH && kind != MUS_FAULT_SEWN_TWICE,
                      "%s: %s", facts->file, mus_faults_text(faults, i));
    }
    mus_faults_destroy(faults);
    mus_pattern_destroy(pattern);
}


START_TEST(all_real_specifications_agree_with_the_figures_taken_of_them)
{
    char path[512];
    if (support_data("garmentcode/facts.csv", path, sizeof path) == NULL) return;
    mus_context *context = support_context();
    char *text = support_slurp(path, NULL);
    int files = 0;
    for (char *line = strchr(text, '\n') + 1; *line != '\0'; line = strchr(line, '\n') + 1) {
        struct facts facts;
        ck_assert_int_eq(sscanf(line, "%127[^,],%d,%d,%d,%d,%lf,%lf,%lf", facts.file, &facts.panels, &facts.edges,
                                &facts.stitches, &facts.right_wrong, &facts.perimeter, &facts.area, &facts.stitched),
                         8);
        check_spec(context, &facts);
        files++;
    }
    ck_assert_int_eq(files, 139);
    free(text);
    support_context_end(context);
}
END_TEST


/* two squares of side 20 units, 10 units a metre: sides of 2 m; one curve is put in by the caller */
#define SPEC(curve, stitches)                                                                                          \
    "{\"pattern\":{\"panels\":{"                                                                                       \
    "\"front\":{\"translation\":[0,10,2],\"rotation\":[0,90,0],\"vertices\":[[0,0],[20,0],[20,20],[0,20]],"            \
    "\"edges\":[{\"endpoints\":[0,1]" curve                                                                            \
    "},{\"endpoints\":[1,2],\"label\":\"left_armhole\"},{\"endpoints\":[2,3]},"                                        \
    "{\"endpoints\":[3,0]}],\"label\":\"body\"},"                                                                      \
    "\"back\":{\"translation\":[1,2,3],\"rotation\":[90,45,0],\"vertices\":[[0,0],[20,0],[20,20],[0,20]],"             \
    "\"edges\":[{\"endpoints\":[0,1]},{\"endpoints\":[1,2]},{\"endpoints\":[2,3]},{\"endpoints\":[3,0]}]}},"           \
    "\"stitches\":[" stitches "]},\"properties\":{\"curvature_coords\":\"relative\",\"units_in_meter\":10}}"
#define SIDE(panel, edge) "{\"panel\":\"" panel "\",\"edge\":" edge "}"
#define STITCH "[" SIDE("front", "1") "," SIDE("back", "3") "]"


START_TEST(units_labels_and_seams_are_those_of_the_file)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_status status = read_spec(
        context, SPEC("", STITCH ",[" SIDE("back", "0") "," SIDE("front", "0") ",\"right_wrong\"]"), &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_str_eq(mus_pattern_name(pattern), "square");
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 0), 4.0, 1e-12);
    ck_assert_str_eq(mus_pattern_panel_label(pattern, 0), "body");
    ck_assert_str_eq(mus_pattern_panel_label(pattern, 1), "");
    ck_assert_str_eq(mus_pattern_edge_label(pattern, 1), "left_armhole");
    ck_assert_str_eq(mus_pattern_edge_label(pattern, 2), "");
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    ck_assert_int_eq(mus_pattern_seam(pattern, 0, &seam), MUS_OK);
    ck_assert_int_eq(seam.edge_a, 1);
    ck_assert_int_eq(seam.edge_b, 4 + 3);
    ck_assert_int_eq(seam.direction, MUS_SEAM_REVERSED);
    ck_assert_int_eq(mus_pattern_seam(pattern, 1, &seam), MUS_OK);
    ck_assert_int_eq(seam.edge_a, 4);
    ck_assert_int_eq(seam.edge_b, 0);
    ck_assert_int_eq(seam.direction, MUS_SEAM_DIRECT);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* names that the format gives to panels, the label of the file, and what is read of both */
static const struct {
    const char *name, *given, *label;
    int32_t sides;
} labels[] = {{"left_ftorso", "body", "body", MUS_SIDE_FRONT | MUS_SIDE_LEFT},
              {"right_btorso", "", "body", MUS_SIDE_BACK | MUS_SIDE_RIGHT},
              {"right_sleeve_f", "", "arm", MUS_SIDE_FRONT | MUS_SIDE_RIGHT},
              {"sl_left_cuff_skirt_b", "arm", "arm", MUS_SIDE_BACK | MUS_SIDE_LEFT},
              {"left_collar_front", "body", "collar", MUS_SIDE_FRONT | MUS_SIDE_LEFT},
              {"right_hood", "body", "hood", MUS_SIDE_RIGHT},
              {"pant_f_r", "leg", "leg", MUS_SIDE_FRONT | MUS_SIDE_RIGHT},
              {"pant_l_cuff_b", "", "leg", MUS_SIDE_BACK | MUS_SIDE_LEFT},
              {"ins_skirt_front_1", "leg", "leg", MUS_SIDE_FRONT},
              {"wb_back", "body", "body", MUS_SIDE_BACK},
              {"skirt_panel_8", "leg", "leg", 0},
              {"slip", "", "", 0}};
enum { LABELS = sizeof labels / sizeof *labels };

START_TEST(names_of_panels_are_read_as_labels_and_sides)
{
    /* the second panel of the text gets that name and label */
    char text[4096];
    const char *plain = SPEC("", ""), *at = strstr(plain, "\"back\":{");
    snprintf(text, sizeof text, "%.*s\"%s\":{\"label\":\"%s\",%s", (int)(at - plain), plain, labels[_i].name,
             labels[_i].given, at + strlen("\"back\":{"));
    mus_context *context = support_context();
    mus_pattern *pattern;
    ck_assert_int_eq(read_spec(context, text, &pattern), MUS_OK);
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 1), labels[_i].name);
    ck_assert_str_eq(mus_pattern_panel_label(pattern, 1), labels[_i].label);
    ck_assert_int_eq(mus_pattern_panel_sides(pattern, 1, NULL), labels[_i].sides);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a lower part whose upper edge is free, or sewn to a top, from either side */
static const struct {
    const char *stitch;
    int32_t level;
} uppers[] = {
    {STITCH, MUS_HOLD_WAIST},
    {"[" SIDE("front", "0") "," SIDE("back", "2") "]", MUS_HOLD_NONE},
    {"[" SIDE("back", "2") "," SIDE("front", "0") "]", MUS_HOLD_NONE},
};


START_TEST(a_lower_part_is_held_at_the_waist_or_hangs_from_its_top)
{
    const char *plain = SPEC(",\"label\":\"lower_interface\"", "@"), *mark = strchr(plain, '@');
    char text[4096];
    snprintf(text, sizeof text, "%.*s%s%s", (int)(mark - plain), plain, uppers[_i].stitch, mark + 1);
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t level;
    double below;
    ck_assert_int_eq(read_spec(context, text, &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_hold(pattern, 0, &level, &below), MUS_OK);
    ck_assert_int_eq(level, uppers[_i].level);
    ck_assert_double_eq(below, 0.0);
    ck_assert_str_eq(mus_pattern_edge_label(pattern, 0), "lower_interface");
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* up to the armpits it would be jammed between arm and torso */
START_TEST(a_strapless_top_is_held_a_little_under_the_arms)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t level;
    double below;
    ck_assert_int_eq(read_spec(context, SPEC(",\"label\":\"strapless_top\"", STITCH), &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_hold(pattern, 0, &level, &below), MUS_OK);
    ck_assert_int_eq(level, MUS_HOLD_ARMPIT);
    ck_assert_double_eq_tol(below, 0.03, 1e-12);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* Returns the position of a panel's point in space [m]. */
static void place(const mus_pattern *pattern, int32_t panel, double x, double y, double *out)
{
    mus_placement p;
    mus_placement_init(&p, sizeof p);
    ck_assert_int_eq(mus_pattern_placement(pattern, panel, &p), MUS_OK);
    for (int i = 0; i < 3; i++) out[i] = p.origin[i] + p.rotation[3 * i] * x + p.rotation[3 * i + 1] * y;
}


START_TEST(panels_are_placed_by_intrinsic_xyz_angles)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    double at[3];
    ck_assert_int_eq(read_spec(context, SPEC("", STITCH), &pattern), MUS_OK);

    /* 90 degrees about y: x runs to -z, exactly */
    place(pattern, 0, 2.0, 1.0, at);
    ck_assert_double_eq(at[0], 0.0);
    ck_assert_double_eq(at[1], 2.0);
    ck_assert_double_eq_tol(at[2], 0.2 - 2.0, 1e-15);

    /* Rx(90) Ry(45), by hand: Ry takes x to (c, 0, -s), Rx takes that to (c, s, 0); y goes to z */
    place(pattern, 1, 1.0, 0.0, at);
    ck_assert_double_eq_tol(at[0], 0.1 + sqrt(0.5), 1e-15);
    ck_assert_double_eq_tol(at[1], 0.2 + sqrt(0.5), 1e-15);
    ck_assert_double_eq_tol(at[2], 0.3, 1e-15);
    place(pattern, 1, 0.0, 1.0, at);
    ck_assert_double_eq_tol(at[0], 0.1, 1e-15);
    ck_assert_double_eq_tol(at[1], 0.2, 1e-15);
    ck_assert_double_eq_tol(at[2], 1.3, 1e-15);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* curves on the edge (0,0) to (2,0): kind, length by hand (NaN: not asked), and the point half way */
static const struct {
    const char *json;
    int32_t kind;
    double length;
    double x, y;
} curves[] = {
    {",\"curvature\":{\"type\":\"quadratic\",\"params\":[[0.5,0.4]]}", MUS_PIECE_QUADRATIC, NAN, 1.0, 0.4},
    {",\"curvature\":[0.5,-0.4]", MUS_PIECE_QUADRATIC, NAN, 1.0, -0.4},
    {",\"curvature\":{\"type\":\"cubic\",\"params\":[[0.25,0.4],[0.75,0.4]]}", MUS_PIECE_CUBIC, NAN, 1.0, 0.6},
    {",\"curvature\":{\"type\":\"circle\",\"params\":[10,0,0]}", MUS_PIECE_ARC, PI, 1.0, 1.0},
    {",\"curvature\":{\"type\":\"circle\",\"params\":[10,0,1]}", MUS_PIECE_ARC, PI, 1.0, -1.0},
    {",\"curvature\":{\"type\":\"circle\",\"params\":[9.9999999,1,1]}", MUS_PIECE_ARC, PI, 1.0, -1.0},
    /* r = 2: the chord is r, so the short arc is 60 degrees, the long one 300 */
    {",\"curvature\":{\"type\":\"circle\",\"params\":[20,0,0]}", MUS_PIECE_ARC, 2 * PI / 3, 1.0, 0.2679491924311228},
    {",\"curvature\":{\"type\":\"circle\",\"params\":[20,1,1]}", MUS_PIECE_ARC, 10 * PI / 3, 1.0, -3.7320508075688772},
    /* a flat arc: r = 1e5 m, length - chord = chord^3 / 24 r^2, height = chord^2 / 8 r */
    {",\"curvature\":{\"type\":\"circle\",\"params\":[1e6,0,0]}", MUS_PIECE_ARC, 2.0, 1.0, 5e-6},
};


START_TEST(curves_are_relative_to_their_edge)
{
    /* the text is put together at run time: the curve is one of a table */
    char text[4096];
    const char *plain = SPEC("@", STITCH), *mark = strchr(plain, '@');
    snprintf(text, sizeof text, "%.*s%s%s", (int)(mark - plain), plain, curves[_i].json, mark + 1);
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_status status = read_spec(context, text, &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));

    int32_t npiece, nxy;
    const int32_t *kinds;
    const double *xy;
    double half = 0.5, middle[2];
    ck_assert_int_eq(mus_pattern_edge_pieces(pattern, 0, &npiece, &kinds, &nxy, &xy), MUS_OK);
    ck_assert_int_eq(npiece, 1);
    ck_assert_int_eq(kinds[0], curves[_i].kind);
    ck_assert_int_eq(mus_pattern_edge_at(pattern, 0, 1, &half, middle), MUS_OK);
    ck_assert_double_eq_tol(middle[0], curves[_i].x, 1e-7);
    if (curves[_i].kind == MUS_PIECE_QUADRATIC) ck_assert_double_eq_tol(xy[3], 2 * curves[_i].y, 1e-12);
    ck_assert_double_eq_tol(middle[1], curves[_i].y, 1e-7);
    if (!isnan(curves[_i].length))
        ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, 0), curves[_i].length, 1e-6);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* texts that are refused, and a part of the message */
static const struct {
    const char *from, *to;
    const char *words;
} damages[] = {
    {"\"pattern\"", "\"patern\"", "expected a pattern"},
    {"\"panels\":{", "\"panels\":[],\"x\":{", "at pattern.panels: expected an object, got an array"},
    {"\"translation\":[0,10,2]", "\"translation\":[0,10]", "at pattern.panels.front.translation"},
    {"\"rotation\":[0,90,0]", "\"rotation\":[0,\"90\",0]", "front.rotation[1]: expected a number, got a text"},
    {"\"vertices\":[[0,0]", "\"vertices\":[[0,0,0]", "front.vertices[0]"},
    {"\"vertices\":[[0,0]", "\"vertices\":[[0,NaN]", "_specification.json:1: expected JSON"},
    {"\"vertices\":[[0,0]", "\"vertices\":[[0,1e999]", "_specification.json:1: expected JSON"},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,4]}", "front.edges[0].endpoints[1]: expected an integer in 0 .. 3"},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,1000000000]}", "front.edges[0].endpoints[1]"},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,1.0]}", "expected an integer, got a number"},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,0]}", "front.edges[0]"},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,2]}", "front.edges"},
    {"{\"endpoints\":[0,1]}", "7", "front.edges[0]: expected an object, got an integer"},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,1],\"curvature\":{\"type\":\"spline\",\"params\":[]}}",
     "front.edges[0].curvature.type: expected quadratic, cubic or circle, got \"spline\""},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,1],\"curvature\":{\"type\":\"cubic\",\"params\":[[1,1]]}}",
     "front.edges[0].curvature.params: expected an array of 2 to 2, got 1"},
    {"{\"endpoints\":[0,1]}", "{\"endpoints\":[0,1],\"curvature\":{\"type\":\"circle\",\"params\":[9,0,0]}}",
     "cannot span an edge of 2 m"},
    {"\"panel\":\"front\"", "\"panel\":\"sleeve\"", "at pattern.stitches[0][0].panel: expected the name of a panel"},
    {"\"edge\":3", "\"edge\":4", "at pattern.stitches[0][1].edge: expected an integer in 0 .. 3, got 4"},
    {"\"edge\":3", "\"edge\":-1", "stitches[0][1].edge"},
    {"\"edge\":3}", "\"edge\":3},\"wrong_right\"", "expected \"right_wrong\""},
    {"\"units_in_meter\":10", "\"units_in_meter\":0", "units_in_meter"},
    {"\"units_in_meter\":10", "\"units\":10", "properties.units_in_meter: expected a number, got nothing"},
    {"\"back\":", "\"front\":", "duplicate"},
    {"\"curvature_coords\":\"relative\"", "\"curvature_coords\":\"absolute\"", "curvature_coords"},
};


START_TEST(a_fault_is_named_with_its_place)
{
    char text[4096];
    const char *plain = SPEC("", STITCH), *at = strstr(plain, damages[_i].from);
    ck_assert_ptr_nonnull(at);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - plain), plain, damages[_i].to, at + strlen(damages[_i].from));
    mus_context *context = support_context();
    mus_pattern *pattern = (mus_pattern *)&context;
    mus_status status = read_spec(context, text, &pattern);
    const char *error = mus_context_error(context);
    ck_assert_ptr_null(pattern);
    ck_assert_int_eq(status, strstr(damages[_i].words, "coords") != NULL ? MUS_ERR_UNSUPPORTED : MUS_ERR_FORMAT);
    ck_assert_msg(strstr(error, "square_specification.json") != NULL, "%s", error);
    ck_assert_msg(strstr(error, damages[_i].words) != NULL, "no \"%s\" in: %s", damages[_i].words, error);
    support_context_end(context);
}
END_TEST


START_TEST(each_allocation_that_fails_is_a_status_and_no_leak)
{
    char path[512];
    const char *text = SPEC("", STITCH);
    support_spill(support_scratch("fail.json", path, sizeof path), text, strlen(text));
    int64_t failed = 0;
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = NULL;
        support_fail_after(n, false);
        mus_status status = mus_pattern_read(context, path, &pattern);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        failed++;
    }
    ck_assert_int_ge(failed, 10);
}
END_TEST


Suite *mus_suite_garmentcode(void);

Suite *mus_suite_garmentcode(void)
{
    Suite *suite = suite_create("garmentcode");
    TCase *tests = tcase_create("garmentcode");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, all_real_specifications_agree_with_the_figures_taken_of_them);
    tcase_add_test(tests, units_labels_and_seams_are_those_of_the_file);
    tcase_add_loop_test(tests, names_of_panels_are_read_as_labels_and_sides, 0, LABELS);
    tcase_add_loop_test(tests, a_lower_part_is_held_at_the_waist_or_hangs_from_its_top, 0,
                        (int)(sizeof uppers / sizeof *uppers));
    tcase_add_test(tests, a_strapless_top_is_held_a_little_under_the_arms);
    tcase_add_test(tests, panels_are_placed_by_intrinsic_xyz_angles);
    tcase_add_loop_test(tests, curves_are_relative_to_their_edge, 0, sizeof curves / sizeof curves[0]);
    tcase_add_loop_test(tests, a_fault_is_named_with_its_place, 0, sizeof damages / sizeof damages[0]);
    tcase_add_test(tests, each_allocation_that_fails_is_a_status_and_no_leak);
    suite_add_tcase(suite, tests);
    return suite;
}
