/*
 * test_svg_read.c: panels drawn by hand in an SVG, patterns written as an SVG and read again, faults with their line.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "support.h"

/* two closed paths in centimetres, one as Inkscape names a layer, one drawn clockwise and moved; a seam by eye */
static const char drawn[] = "<?xml version=\"1.0\"?>\n"
                            "<svg width=\"100cm\" viewBox=\"0 0 100 80\" data-name=\"bag\">\n"
                            "<g class=\"panel\" inkscape:label=\"front\" xmlns:inkscape=\"i\" data-label=\"body\">\n"
                            "<path d=\"M 0,0 h 30 v 40 C 20,45 10,45 0,40 z\"/>\n"
                            "<path class=\"notch\" data-kind=\"2\" d=\"M 30.1,10 l 1,0\"/>\n"
                            "<path class=\"grain\" d=\"M 5,5 L 10,5\"/><text>front</text></g>\n"
                            "<g transform=\"translate(50 0)\"><g transform=\"scale(-1,1) rotate(0)\">\n"
                            "<path id=\"back\" d=\"M0,0 h-30 v40 h30 z\"/></g></g>\n"
                            "<path class=\"seam\" d=\"M 30.2,20 L 50.2,20\"/></svg>\n";


static mus_status read_text(mus_context *context, const char *text, mus_pattern **out)
{
    return mus_pattern_read_from(context, text, strlen(text), "drawn.svg", out);
}


START_TEST(panels_drawn_by_hand_are_read)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    const mus_status status = read_text(context, drawn, &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_str_eq(mus_pattern_name(pattern), "bag");
    ck_assert_int_eq(mus_pattern_panel_count(pattern), 2);
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 0), "front");
    ck_assert_str_eq(mus_pattern_panel_label(pattern, 0), "body");
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 1), "back");
    ck_assert_int_eq(mus_pattern_edge_count(pattern), 8);
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 1), 0.12, 1e-12);
    double grain[2], s;
    int32_t edge, kind;
    ck_assert_int_eq(mus_pattern_grain(pattern, 0, grain), MUS_OK);
    ck_assert_double_eq_tol(grain[0], 1.0, 1e-12);
    ck_assert_int_eq(mus_pattern_notch_count(pattern), 1);
    ck_assert_int_eq(mus_pattern_notch(pattern, 0, &edge, &s, &kind), MUS_OK);
    ck_assert_int_eq(kind, MUS_NOTCH_DOUBLE);
    ck_assert_double_eq_tol(s, 0.1, 1e-9);
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    ck_assert_int_eq(mus_pattern_seam_count(pattern), 1);
    ck_assert_int_eq(mus_pattern_seam(pattern, 0, &seam), MUS_OK);
    ck_assert_int_eq(seam.edge_a, edge);
    ck_assert_int_eq(mus_pattern_edge_panel(pattern, seam.edge_b), 1);
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, seam.edge_b), 0.4, 1e-12);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* edges, seams, notches, marks, cuts and names of a drafted design come back; arcs and curves within 0.01 mm */
START_TEST(a_design_comes_back)
{
    static const char *const names[] = {"shirt", "skirt_circle_full", "dress"};
    mus_context *context = support_context();
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        mus_pattern *pattern, *again;
        char *bytes;
        size_t size;
        const int32_t design = mus_design_find(names[i]);
        if (design == MUS_NONE) continue;
        ck_assert_int_eq(mus_design_draft(context, design, tape, NULL, &pattern), MUS_OK);
        ck_assert_int_eq(mus_pattern_write_svg_bytes(pattern, &bytes, &size), MUS_OK);
        const mus_status status = mus_pattern_read_from(context, bytes, size, "a.svg", &again);
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        ck_assert_int_eq(mus_pattern_edge_count(again), mus_pattern_edge_count(pattern));
        ck_assert_int_eq(mus_pattern_seam_count(again), mus_pattern_seam_count(pattern));
        ck_assert_int_eq(mus_pattern_notch_count(again), mus_pattern_notch_count(pattern));
        ck_assert_int_eq(mus_pattern_mark_count(again), mus_pattern_mark_count(pattern));
        for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
            ck_assert_str_eq(mus_pattern_panel_name(again, p), mus_pattern_panel_name(pattern, p));
            ck_assert_double_eq_tol(mus_pattern_panel_area(again, p), mus_pattern_panel_area(pattern, p), 1e-6);
            ck_assert_double_eq_tol(mus_pattern_panel_perimeter(again, p), mus_pattern_panel_perimeter(pattern, p),
                                    1e-5);
        }
        mus_context_alloc(context, bytes, 0);
        mus_pattern_destroy(again);
        mus_pattern_destroy(pattern);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_name_stands_in_the_middle_of_its_panel)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    char *bytes;
    size_t size;
    ck_assert_int_eq(read_text(context, drawn, &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_write_svg_bytes(pattern, &bytes, &size), MUS_OK);
    /* 30 cm wide, 45 cm high with the controls of its curve; 30 by 40 cm */
    ck_assert_ptr_nonnull(strstr(bytes, "x=\"150.00\" y=\"225.00\">front</text>"));
    ck_assert_ptr_nonnull(strstr(bytes, "x=\"650.00\" y=\"200.00\">back</text>"));
    mus_context_alloc(context, bytes, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_fault_is_told_with_its_line)
{
    static const struct {
        const char *text, *sentence;
        mus_status status;
    } faults[] = {
        {"<svg>\n<path d='M0,0 h9 v9 z m5,5 h9'/></svg>", "drawn.svg:2: path: a second subpath", MUS_ERR_UNSUPPORTED},
        {"<svg>\n\n<path d='M0,0 h9 q z'/></svg>", "drawn.svg:3: path: Q: expected numbers", MUS_ERR_FORMAT},
        {"<svg><path d='M0,0 A 3,4 0 0 0 5,5 z'/></svg>", "an arc of an ellipse", MUS_ERR_UNSUPPORTED},
        {"<svg width='10furlong' viewBox='0 0 1 1'/>", "expected a width in mm", MUS_ERR_FORMAT},
        {"<svg width='1e5cm' viewBox='0 0 1 1'>\n<path d='M0,0 h1 v2 z'/></svg>",
         "drawn.svg:2: path: a point at 1000, -2000 m; expected at most 1000 m from the origin", MUS_ERR_LIMIT},
        {"<svg>\n<g transform='skewX(3)'/></svg>", "drawn.svg:2: transform: expected matrix", MUS_ERR_FORMAT},
        {"<svg>\n<g class='panel' id='a'></g></svg>", "drawn.svg:2: panel a: no outline", MUS_ERR_FORMAT},
        {"<svg>\n<g class='panel' id='a'>\n<path class='edge' d='M0 0h9'/><path class='edge' d='M50 0h9'/></g></svg>",
         "edge 2 does not start where edge 1 ends", MUS_ERR_FORMAT},
        {"<svg><path d='M0 0h90v90z'/>\n<path class='seam' d='M900 0h900'/></svg>",
         "drawn.svg:2: seam: an end is on no edge", MUS_ERR_FORMAT},
        {"<svg><path d='M0 0h90v90z'/>\n<path class='seam' data-a='x' d='M0 0h9'/></svg>", "expected the id of an edge",
         MUS_ERR_FORMAT},
        {"<!DOCTYPE svg [<!ENTITY a 'b'>]>\n<svg/>", "a document type with declarations", MUS_ERR_UNSUPPORTED},
        {"<svg><g>\n</svg>", "drawn.svg:2: expected XML", MUS_ERR_FORMAT},
        {"<svg><text>x</text></svg>", "no panel", MUS_ERR_FORMAT},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        mus_pattern *pattern;
        ck_assert_int_eq(read_text(context, faults[i].text, &pattern), faults[i].status);
        ck_assert_ptr_null(pattern);
        ck_assert_msg(strstr(mus_context_error(context), faults[i].sentence) != NULL, "%s: %s", faults[i].sentence,
                      mus_context_error(context));
    }
    support_context_end(context);
}
END_TEST


START_TEST(no_memory_is_a_status)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern;
        char *bytes = NULL;
        size_t size;
        support_fail_after(n, false);
        mus_status status = read_text(context, drawn, &pattern);
        if (status == MUS_OK) status = mus_pattern_write_svg_bytes(pattern, &bytes, &size);
        support_fail_never();
        mus_context_alloc(context, bytes, 0);
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_svg_read(void);

Suite *mus_suite_svg_read(void)
{
    Suite *suite = suite_create("svg_read");
    TCase *tests = tcase_create("svg_read");
    tcase_add_test(tests, panels_drawn_by_hand_are_read);
    tcase_add_test(tests, a_design_comes_back);
    tcase_add_test(tests, a_name_stands_in_the_middle_of_its_panel);
    tcase_add_test(tests, a_fault_is_told_with_its_line);
    tcase_add_test(tests, no_memory_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
