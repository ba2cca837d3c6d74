/*
 * test_worn.c: mus_fit_worn() on garments that are moved off their places by hand: each defect is named with its limb;
 * and the count of triangles through the skin is that of all pairs tried one by one.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drape/drape_state.h"
#include "drape/scenes.h"
#include "drape/worn.h"
#include "fit/worn_check.h"
#include "fit/worn_internal.h"
#include "selfcontact/crossing_count.h"

typedef struct defect {
    const char *name, *design;
    const char *panel;   /* words of the panels that move; NULL: all */
    double scale[3], by[3]; /* x becomes scale x + by */
    int32_t kind, limb;
} defect;

static const defect defects[] = {
    {"as placed", "tshirt", NULL, {1, 1, 1}, {0, 0, 0}, MUS_WORN_YES, MUS_NONE},
    {"skirt as placed", "skirt", NULL, {1, 1, 1}, {0, 0, 0}, MUS_WORN_YES, MUS_NONE},
    {"left arm beside its sleeve", "tshirt", "sleeve_left", {1, 1, 1}, {0, 0, -0.4}, MUS_WORN_OPENING,
     MUS_WORN_ARM_LEFT},
    {"right arm beside its sleeve", "tshirt", "sleeve_right", {1, 1, 1}, {0, 0.4, 0}, MUS_WORN_OPENING,
     MUS_WORN_ARM_RIGHT},
    {"beside the body", "skirt", NULL, {1, 1, 1}, {1.5, 0, 0}, MUS_WORN_OPENING, MUS_WORN_LEG_LEFT},
    {"both legs beside one trouser leg", "straight_trousers", "right", {1, 1, 1}, {0, 0, 0.5}, MUS_WORN_OPENING,
     MUS_WORN_LEG_RIGHT},
    {"front and back exchanged: inside out", "tshirt", NULL, {1, 1, -1}, {0, 0, 0}, MUS_WORN_INSIDE_OUT, MUS_NONE},
    {"slid down", "skirt", NULL, {1, 1, 1}, {0, -0.3, 0}, MUS_WORN_LOW, MUS_NONE},
    {"rolled up", "skirt", NULL, {1, 0.3, 1}, {0, 0.72, 0}, MUS_WORN_ROLLED, MUS_NONE},
    {"legs through the front", "skirt", "skirt_front", {1, 1, 1}, {0, 0, -0.2}, MUS_WORN_THROUGH, MUS_WORN_LEG_LEFT},
    {"drawn wide", "skirt", NULL, {1, 1, 5}, {0, 0, 0}, MUS_WORN_TIGHT, MUS_NONE},
};


/* put the nodes of a drape where the defect has them, from the places of its panels */
static void make_wrong(const worn *w, const mus_cloth *cloth, mus_drape *drape, const defect *d)
{
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    for (int32_t i = 0; i < n; i++) {
        const char *name = mus_pattern_panel_name(w->pattern, cloth->node_panel[i]);
        if (d->panel != NULL && strstr(name, d->panel) == NULL) continue;
        for (int32_t k = 0; k < 3; k++) x[3 * i + k] = d->scale[k] * x[3 * i + k] + d->by[k];
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    free(x);
}


START_TEST(each_defect_is_named)
{
    const defect *d = &defects[_i];
    mus_cloth_def cut;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_worn out;
    worn w = worn_body("W40");
    worn_put_on_design(&w, d->design, NULL);
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.03;
    ck_assert_int_eq(mus_cloth_create(w.context, w.pattern, &cut, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(w.context, cloth, w.body, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    make_wrong(&w, cloth, drape, d);
    mus_worn_init(&out, sizeof out);
    ck_assert_int_eq(mus_fit_worn(drape, w.pattern, w.body, &out), MUS_OK);
    const int32_t kind = d->kind == MUS_WORN_YES && out.kind == MUS_WORN_THROUGH ? MUS_WORN_YES : out.kind;
    ck_assert_msg(kind == d->kind && (d->limb == MUS_NONE || out.limb == d->limb), "%s: %s, limb %d: %s", d->name,
                  mus_worn_name(out.kind), (int)out.limb, out.text);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    worn_end(&w);
}
END_TEST


/* trousers of a size whose waist is longer than any tape round the trunk under it: lower than they are put they are on
 * their way down, for nothing but the crotch holds them */
START_TEST(a_waist_that_nothing_carries_is_low)
{
    static const double down[] = {-0.05, -0.12}; /* [m] less and more than a waist may slide */
    const defect slid = {NULL, NULL, NULL, {1, 1, 1}, {0, down[_i], 0}, 0, 0};
    mus_tape *large;
    mus_cloth_def cut;
    mus_worn out;
    worn w = worn_body("W34");
    ck_assert_int_eq(mus_tape_create(w.context, &large), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(large, "M58"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(w.context, mus_design_find("straight_trousers"), large, NULL, &w.pattern),
                     MUS_OK);
    ck_assert_int_eq(mus_arrange_pattern(w.pattern, w.body), MUS_OK);
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.03;
    ck_assert_int_eq(mus_cloth_create(w.context, w.pattern, &cut, &w.cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(w.context, w.cloth, w.body, NULL, &w.drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(w.drape), MUS_OK);
    make_wrong(&w, w.cloth, w.drape, &slid);
    mus_worn_init(&out, sizeof out);
    ck_assert_int_eq(mus_fit_worn(w.drape, w.pattern, w.body, &out), MUS_OK);
    ck_assert_msg((out.kind == MUS_WORN_LOW) == (_i == 1), "%s: %s", mus_worn_name(out.kind), out.text);
    mus_tape_destroy(large);
    worn_end(&w);
}
END_TEST


/* crossings counted pair by pair, without a grid */
static int32_t count_all(const mus_cloth *cloth, const double *x, const mus_body *body)
{
    const int32_t *skin = mus_body_triangles(body);
    const double *y = mus_body_vertices(body);
    int32_t count = 0;
    for (int32_t a = 0; a < cloth->ntriangle; a++)
        for (int32_t b = 0; b < mus_body_triangle_count(body); b++) {
            const int32_t *p = cloth->triangle + 3 * a, *q = skin + 3 * b;
            int32_t met = 0;
            for (int32_t k = 0; k < 3 && !met; k++)
                met = mus__segment_meets_triangle(x + 3 * p[k], x + 3 * p[(k + 1) % 3], y + 3 * q[0], y + 3 * q[1],
                                                  y + 3 * q[2]) ||
                      mus__segment_meets_triangle(y + 3 * q[k], y + 3 * q[(k + 1) % 3], x + 3 * p[0], x + 3 * p[1],
                                                  x + 3 * p[2]);
            count += met;
        }
    return count;
}


/* a sheet of random places through a coarse ball */
START_TEST(through_the_body_is_exact)
{
    mus_context *context = support_context();
    double contour[5 * 6];
    for (int i = 0; i < 5; i++) {
        const double s = 0.04 * (i - 2), r = sqrt(0.01 - s * s);
        memcpy(contour + 6 * i, (double[]){s, 0.0, 0.0, r, r, 2.0}, 6 * sizeof *contour);
    }
    mus_limb limb;
    mus_body_def def;
    mus_body *body;
    mus_worn out;
    mus_limb_init(&limb, sizeof limb);
    mus_body_def_init(&def, sizeof def);
    limb.contours = 5, limb.contour = contour, limb.pole[0] = -0.1, limb.pole[1] = 0.1;
    def.samples = 16, def.ring_spacing = 0.03;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, &def, &body), MUS_OK);
    mus_pattern *pattern = scene_square(context, 0.2);
    mus_cloth *cloth = scene_cut(context, pattern, 0.03, 0.0);
    mus_drape *drape;
    ck_assert_int_eq(mus_drape_create(context, cloth, body, NULL, &drape), MUS_OK);
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    uint32_t seed = 7u + (uint32_t)_i;
    for (int32_t i = 0; i < 3 * n; i++) {
        seed = 1664525u * seed + 1013904223u;
        x[i] = 0.3 * ((double)(seed >> 8) / (1 << 24) - 0.5);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    mus_worn_init(&out, sizeof out);
    ck_assert_int_eq(mus_fit_worn(drape, pattern, body, &out), MUS_OK);
    ck_assert_int_eq(out.through, count_all(cloth, mus_drape_positions(drape), body));
    ck_assert_int_gt(out.through, 0);
    ck_assert(out.through_depth > 0.0 && out.through_depth < 0.11 && out.through_area > 0.0);
    ck_assert_int_eq(out.kind, MUS_WORN_THROUGH);
    free(x);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* leggings of a child on a man: the waist is told before anything is sewn; of his own size nothing is */
/* a tie adds a third sheet at a seam and closes no opening: the loops of a dress that wraps are those of the same dress
 * with its fronts untied, edge for edge */
START_TEST(a_tied_front_has_the_openings_of_an_untied_one)
{
    worn w = worn_body("W40");
    mus_cloth_def cut;
    double length[2][3];
    worn_put_on_design(&w, "wrap_dress", NULL);
    for (int32_t open = 0; open < 2; open++) {
        mus__worn_loops loops;
        mus_cloth *cloth;
        ck_assert_int_eq(mus_pattern_open_closures(w.pattern, open, NULL), MUS_OK);
        mus_cloth_def_init(&cut, sizeof cut);
        cut.spacing = 0.02;
        ck_assert_int_eq(mus_cloth_create(w.context, w.pattern, &cut, &cloth), MUS_OK);
        ck_assert_int_eq(mus__worn_loops_make(w.context, cloth, &loops), MUS_OK);
        ck_assert_int_eq(loops.nloop, 3);
        for (int32_t i = 0; i < 3; i++) {
            int32_t k = i;
            for (; k > 0 && length[open][k - 1] > loops.loop[i].length; k--) length[open][k] = length[open][k - 1];
            length[open][k] = loops.loop[i].length;
        }
        mus__worn_loops_free(&loops);
        mus_cloth_destroy(cloth);
    }
    for (int32_t i = 0; i < 3; i++) ck_assert_double_eq_tol(length[0][i], length[1][i], 1e-9);
    ck_assert_double_gt(length[0][2], 4.0); /* neck, both edges and hem in one [m] */
    worn_end(&w);
}
END_TEST


START_TEST(what_is_far_too_tight_is_told_before_it_is_sewn)
{
    static const struct {
        const char *design, *size, *words;
    } rows[] = {{"leggings", "C104", "the trunk is"}, {"leggings", "M50", ""}};
    worn w = worn_body("M50");
    mus_tape *tape;
    mus_worn out;
    ck_assert_int_eq(mus_tape_create(w.context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, rows[_i].size), MUS_OK);
    mus_pattern *pattern;
    ck_assert_int_eq(mus_design_draft(w.context, mus_design_find(rows[_i].design), tape, NULL, &pattern), MUS_OK);
    mus_tape_destroy(tape);
    worn_put_on(&w, pattern);
    w.cloth = scene_cut(w.context, pattern, 0.03, 0.0);
    worn_place(&w, NULL);
    mus_worn_init(&out, sizeof out);
    ck_assert_int_eq(mus__fit_worn(w.drape, pattern, w.body, MUS__WORN_GIRTHS, &out), MUS_OK);
    ck_assert_int_eq(out.kind, rows[_i].words[0] != '\0' ? MUS_WORN_TIGHT : MUS_WORN_YES);
    ck_assert_msg(strstr(out.text, rows[_i].words) != NULL, "%s: %s", rows[_i].design, out.text);
    worn_end(&w);
}
END_TEST


START_TEST(bad_arguments_are_refused)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.2), *other;
    mus_cloth *cloth = scene_cut(context, pattern, 0.05, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 32, 1);
    mus_worn out;
    worn w = worn_body("W40");
    mus_worn_init(&out, sizeof out);
    ck_assert_int_eq(mus_fit_worn(NULL, pattern, w.body, &out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fit_worn(drape, NULL, w.body, &out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fit_worn(drape, pattern, NULL, &out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fit_worn(drape, pattern, w.body, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_create(context, "empty", &other), MUS_OK);
    ck_assert_int_eq(mus_fit_worn(drape, other, w.body, &out), MUS_ERR_ARG);
    out.size = 8;
    ck_assert_int_eq(mus_fit_worn(drape, pattern, w.body, &out), MUS_ERR_VERSION);
    ck_assert_str_eq(mus_worn_name(MUS_WORN_YES), "worn");
    ck_assert(mus_worn_name(MUS_WORN_COUNT) == NULL && mus_worn_name(-1) == NULL);
    worn_end(&w);
    mus_pattern_destroy(other);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_worn(void);


Suite *mus_suite_worn(void)
{
    Suite *suite = suite_create("worn");
    TCase *tests = tcase_create("worn");
    tcase_set_timeout(tests, 60.0);
    tcase_add_test(tests, a_tied_front_has_the_openings_of_an_untied_one);
    tcase_add_loop_test(tests, what_is_far_too_tight_is_told_before_it_is_sewn, 0, 2);
    tcase_add_loop_test(tests, a_waist_that_nothing_carries_is_low, 0, 2);
    tcase_add_loop_test(tests, each_defect_is_named, 0, (int)(sizeof defects / sizeof *defects));
    tcase_add_loop_test(tests, through_the_body_is_exact, 0, 3);
    tcase_add_test(tests, bad_arguments_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
