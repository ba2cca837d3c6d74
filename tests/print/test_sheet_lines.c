/*
 * test_sheet_lines.c: the public lines of a sheet are its pieces: cut and sew lines as long as the pattern says,
 * and the bytes in memory are the file.
 */
#include <math.h>
#include <stdlib.h>

#include "muslin/muslin.h"
#include "muslin/print.h"
#include "support.h"


static mus_pattern *draft(mus_context *context, const char *size)
{
    mus_tape *tape;
    mus_pattern *pattern;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, size), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern), MUS_OK);
    mus_tape_destroy(tape);
    return pattern;
}


static mus_sheet *tshirt(mus_context *context, mus_pattern **pattern)
{
    mus_sheet *sheet;
    *pattern = draft(context, "W40");
    ck_assert_int_eq(mus_sheet_create(context, *pattern, NULL, &sheet), MUS_OK);
    /* the panels that are cut and not draped follow those of the pattern */
    ck_assert_int_eq(mus_pattern_join(*pattern, mus_pattern_cut_only(*pattern), 0), MUS_OK);
    return sheet;
}


/* length of a line; a cubic by 64 chords */
static double length_of(const mus_sheet_line *line)
{
    const double *p = line->points, *from = p;
    double length = 0.0;
    for (int32_t i = 0; i < line->op_count; i++) {
        const unsigned char op = line->ops[i];
        if (op == 'l') length += hypot(p[0] - from[0], p[1] - from[1]);
        double x = from[0], y = from[1];
        for (int32_t k = 1; op == 'c' && k <= 64; k++) {
            const double t = k / 64.0, s = 1.0 - t;
            const double b[4] = {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
            const double u = b[0] * from[0] + b[1] * p[0] + b[2] * p[2] + b[3] * p[4];
            const double v = b[0] * from[1] + b[1] * p[1] + b[2] * p[3] + b[3] * p[5];
            length += hypot(u - x, v - y);
            x = u;
            y = v;
        }
        const int32_t n = op == 'z' ? 0 : op == 'c' ? 3 : 1;
        if (n > 0) from = p + 2 * (n - 1);
        p += 2 * n;
    }
    ck_assert_ptr_eq(p, line->points + 2 * line->point_count);
    return length;
}


START_TEST(sew_lines_are_as_long_as_their_edges_and_lie_in_the_piece)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_sheet *sheet = tshirt(context, &pattern);
    int32_t sewn = 0, cut = 0, grain = 0;
    for (int32_t i = 0; i < mus_sheet_line_count(sheet); i++) {
        mus_sheet_line line;
        mus_sheet_piece piece;
        mus_sheet_line_init(&line, sizeof line);
        mus_sheet_piece_init(&piece, sizeof piece);
        ck_assert_int_eq(mus_sheet_line_get(sheet, i, &line), MUS_OK);
        if (line.piece == MUS_NONE) continue; /* test squares and instructions */
        ck_assert_int_eq(mus_sheet_piece_get(sheet, line.piece, &piece), MUS_OK);
        ck_assert_str_eq(piece.name, mus_pattern_panel_name(pattern, piece.panel));
        cut += line.kind == MUS_LINE_CUT;
        grain += line.kind == MUS_LINE_GRAIN && !line.filled;
        for (int32_t k = 0; k < line.point_count && line.kind != MUS_LINE_LABEL; k++) {
            const double *p = line.points + 2 * k;
            ck_assert(p[0] > piece.box[0] - 0.005 && p[0] < piece.box[2] + 0.005);
            ck_assert(p[1] > piece.box[1] - 0.005 && p[1] < piece.box[3] + 0.005);
        }
        if (line.kind != MUS_LINE_SEW) continue;
        sewn++;
        ck_assert_double_eq_tol(length_of(&line), mus_pattern_edge_length(pattern, line.edge), 2e-5);
    }
    for (int32_t i = 0; i < mus_sheet_piece_count(sheet); i++) {
        mus_sheet_piece piece;
        int32_t n;
        mus_sheet_piece_init(&piece, sizeof piece);
        ck_assert_int_eq(mus_sheet_piece_get(sheet, i, &piece), MUS_OK);
        ck_assert_int_eq(mus_pattern_outline(pattern, piece.panel, &n, NULL, NULL), MUS_OK);
        sewn -= n;
    }
    ck_assert_int_eq(sewn, 0);
    ck_assert_int_eq(cut, mus_sheet_piece_count(sheet));
    ck_assert_int_eq(grain, mus_sheet_piece_count(sheet));
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(what_is_not_there_is_refused)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_sheet *sheet = tshirt(context, &pattern);
    mus_sheet_line line;
    mus_sheet_piece piece;
    mus_sheet_line_init(&line, sizeof line);
    mus_sheet_piece_init(&piece, sizeof piece);
    ck_assert_int_eq(mus_sheet_line_get(sheet, -1, &line), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_line_get(sheet, mus_sheet_line_count(sheet), &line), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_piece_get(sheet, mus_sheet_piece_count(sheet), &piece), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_piece_get(sheet, 0, NULL), MUS_ERR_ARG);
    line.size = 8;
    ck_assert_int_eq(mus_sheet_line_get(sheet, 0, &line), MUS_ERR_VERSION);
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(bytes_in_memory_are_those_of_the_file)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_sheet *sheet = tshirt(context, &pattern);
    char path[512], *bytes;
    size_t size, file_size;
    for (int32_t form = 0; form < 2; form++) {
        support_scratch(form == 0 ? "lines.pdf" : "lines.svg", path, sizeof path);
        ck_assert_int_eq(form == 0 ? mus_sheet_write_pdf(sheet, path) : mus_sheet_write_svg(sheet, path), MUS_OK);
        ck_assert_int_eq(form == 0 ? mus_sheet_write_pdf_bytes(sheet, &bytes, &size)
                                   : mus_sheet_write_svg_bytes(sheet, &bytes, &size), MUS_OK);
        char *file = support_slurp(path, &file_size);
        ck_assert_uint_eq(size, file_size);
        ck_assert_mem_eq(bytes, file, size);
        free(file);
        mus_context_alloc(context, bytes, 0);
    }
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* the sew lines of a piece have the same points on both sheets, moved and mirrored as the pieces are */
static void assert_same_lines(const mus_sheet *one, int32_t piece, const mus_sheet *other, int32_t like)
{
    mus_sheet_piece a, b;
    mus_sheet_line p, q;
    mus_sheet_piece_init(&a, sizeof a);
    mus_sheet_piece_init(&b, sizeof b);
    mus_sheet_line_init(&p, sizeof p);
    mus_sheet_line_init(&q, sizeof q);
    ck_assert_int_eq(mus_sheet_piece_get(one, piece, &a), MUS_OK);
    ck_assert_int_eq(mus_sheet_piece_get(other, like, &b), MUS_OK);
    ck_assert_str_eq(a.name, b.name);
    int32_t sewn = 0;
    for (int32_t i = 0; i < mus_sheet_line_count(one); i++) {
        ck_assert_int_eq(mus_sheet_line_get(one, i, &p), MUS_OK);
        if (p.piece != piece || p.kind != MUS_LINE_SEW) continue;
        double best = HUGE_VAL;
        for (int32_t j = 0; j < mus_sheet_line_count(other); j++) {
            ck_assert_int_eq(mus_sheet_line_get(other, j, &q), MUS_OK);
            const bool sew = q.piece == like && q.kind == MUS_LINE_SEW && q.edge == p.edge;
            if (!sew || q.point_count != p.point_count) continue;
            double worst = 0.0;
            const bool round =
                (a.turn[0] * a.turn[3] - a.turn[1] * a.turn[2]) * (b.turn[0] * b.turn[3] - b.turn[1] * b.turn[2]) < 0.0;
            for (int32_t k = 0; k < p.point_count; k++) {
                /* to the panel of one, and from there to the other sheet; the inverse of a turn is its transpose */
                const double *x = p.points + 2 * k, *y = q.points + 2 * (round ? q.point_count - 1 - k : k);
                const double at[2] = {x[0] - a.shift[0], x[1] - a.shift[1]};
                const double u = a.turn[0] * at[0] + a.turn[2] * at[1], v = a.turn[1] * at[0] + a.turn[3] * at[1];
                for (int32_t d = 0; d < 2; d++)
                    worst = fmax(worst, fabs(b.turn[2 * d] * u + b.turn[2 * d + 1] * v + b.shift[d] - y[d]));
            }
            best = fmin(best, worst);
        }
        ck_assert_double_lt(best, 1e-9);
        sewn++;
    }
    ck_assert_int_gt(sewn, 2); /* the half of a strip has three */
}


START_TEST(each_size_of_a_nest_is_that_of_its_own_sheet)
{
    static const char *const names[] = {"W36", "W40", "W44"};
    mus_context *context = support_context();
    const mus_pattern *patterns[3];
    mus_pattern *own[3];
    mus_sheet_def def;
    mus_sheet_def_init(&def, sizeof def);
    def.paper = MUS_PAPER_A0;
    for (int32_t k = 0; k < 3; k++) patterns[k] = own[k] = draft(context, names[k]);
    for (def.fold = 0; def.fold < 2; def.fold++) {
        mus_sheet *nest, *sheet;
        ck_assert_int_eq(mus_sheet_create_sizes(context, 3, patterns, names, &def, &nest), MUS_OK);
        for (int32_t k = 0; k < 3; k++) {
            ck_assert_int_eq(mus_sheet_create(context, patterns[k], &def, &sheet), MUS_OK);
            const int32_t n = mus_sheet_piece_count(sheet);
            ck_assert_int_eq(mus_sheet_piece_count(nest), 3 * n);
            for (int32_t i = 0; i < n; i++) {
                mus_sheet_piece piece;
                mus_sheet_piece_init(&piece, sizeof piece);
                ck_assert_int_eq(mus_sheet_piece_get(nest, 3 * i + k, &piece), MUS_OK);
                ck_assert_int_eq(piece.size_index, k);
                assert_same_lines(nest, 3 * i + k, sheet, i);
            }
            mus_sheet_destroy(sheet);
        }
        ck_assert_int_eq(mus_sheet_write_dxf(nest, NULL, "/nowhere"), MUS_ERR_ARG);
        mus_sheet_destroy(nest);
    }
    ck_assert_int_eq(mus_sheet_create_sizes(context, 0, patterns, names, NULL, &(mus_sheet *){0}), MUS_ERR_ARG);
    for (int32_t k = 0; k < 3; k++) mus_pattern_destroy(own[k]);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_sheet_lines(void);

Suite *mus_suite_sheet_lines(void)
{
    Suite *suite = suite_create("sheet_lines");
    TCase *tests = tcase_create("sheet_lines");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, each_size_of_a_nest_is_that_of_its_own_sheet);
    tcase_add_test(tests, sew_lines_are_as_long_as_their_edges_and_lie_in_the_piece);
    tcase_add_test(tests, what_is_not_there_is_refused);
    tcase_add_test(tests, bytes_in_memory_are_those_of_the_file);
    suite_add_tcase(suite, tests);
    return suite;
}
