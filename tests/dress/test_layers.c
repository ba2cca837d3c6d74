/*
 * test_layers.c: a skirt over a skirt, joined by the public calls: sewn from inside to outside without a crossing, the
 * outer one outside; sleeves over sleeves; nothing worn is gone through; collars lie on their garments; folds that lie
 * on folds rest; a fit that fails for want of memory gives back what it took.
 */
#include <math.h>
#include <string.h>

#include "muslin/muslin.h"
#include "drape/scenes.h"
#include "drape/worn.h"

Suite *mus_suite_layers(void);

/* cloth that meets cloth, where the panels start */
static void over_place(worn *w, double spacing)
{
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    w->cloth = scene_cut(w->context, w->pattern, spacing, 0.0);
    worn_place(w, &def);
}


/* skirts of a design over one another on W40, coarse, not yet sewn */
static worn over_skirts(const char *design, int32_t layers, double spacing)
{
    worn w = worn_body("W40");
    for (int32_t k = 0; k < layers; k++) worn_put_on_design(&w, design, &(double){0.06 + 0.08 * k});
    over_place(&w, spacing);
    return w;
}


/* a shirt with long sleeves and a coat with such over it, which are closed where an arm and a sleeve are */
static worn over_sleeves(double spacing)
{
    worn w = worn_body("W40");
    worn_put_on_words(&w, "top sleeve=long shape=boxy");
    worn_put_on_words(&w, "top neck=v sleeve=long shape=boxy ease=coat");
    over_place(&w, spacing);
    return w;
}


/* the report of what goes through nothing */
static mus_drape_report over_clear(const worn *w)
{
    int64_t count = -1;
    mus_drape_report report;
    ck_assert_int_eq(mus_drape_crossings(w->drape, 0, NULL, &count), MUS_OK);
    ck_assert_int_eq(count, 0);
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(w->drape, &report), MUS_OK);
    return report;
}


/* the seams under the arms close round sleeves that are worn, and go through nothing (1104 crossings while the shirt
 * was let down first: its sleeves hung out of those that were still open) */
START_TEST(sleeves_close_over_sleeves)
{
    worn w = over_sleeves(0.045);
    ck_assert_msg(mus_drape_sew(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    over_clear(&w);
    worn_end(&w);
}
END_TEST


/* the folds of a circle skirt lie on each other: it was in motion after 65,000 steps while nodes that a fold had
 * pressed in passing were made heavy for good, and rests after 10,000 */
START_TEST(folds_that_lie_on_folds_come_to_rest)
{
    worn w = over_skirts("full_skirt_midi", 1, 0.04);
    ck_assert_msg(mus_drape_sew(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    ck_assert_msg(mus_drape_settle(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    const mus_drape_report report = over_clear(&w);
    ck_assert_int_gt(report.self_contacts, 0);
    ck_assert_int_lt(report.steps, 25000);
    worn_end(&w);
}
END_TEST


/* a square before the body, worn; over it one that begins in the same place, one beside it, a roll round the head with
 * its seam behind, and a plate over that with its right side down. No time to sew: they stay at the start */
static mus_drape *over_start(worn *w, int32_t layer)
{
    int32_t edge[4], roll[4];
    ck_assert_int_eq(mus_pattern_create(w->context, "start", &w->pattern), MUS_OK);
    const int32_t worn_one = scene_rectangle(w->pattern, "worn", -0.1, -0.1, 0.2, 0.2, edge);
    const int32_t same = scene_rectangle(w->pattern, "same", -0.08, -0.08, 0.16, 0.16, edge);
    const int32_t beside = scene_rectangle(w->pattern, "beside", -0.1, -0.1, 0.2, 0.2, edge);
    const int32_t round = scene_rectangle(w->pattern, "round", -0.45, 0.0, 0.9, 0.1, roll);
    const int32_t plate = scene_rectangle(w->pattern, "plate", -0.1, -0.1, 0.2, 0.2, edge);
    scene_sew(w->pattern, roll[1], roll[3], 0.0);
    scene_move(w->pattern, worn_one, 0.0, 1.1, 0.3);
    scene_move(w->pattern, same, 0.0, 1.1, 0.3);
    scene_move(w->pattern, beside, 0.5, 1.1, 0.3);
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    place.origin[1] = 1.5, place.origin[2] = 0.18, place.bend = 0.2;
    ck_assert_int_eq(mus_pattern_set_placement(w->pattern, round, &place), MUS_OK);
    const double down[9] = {1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0};
    mus_placement_init(&place, sizeof place);
    place.origin[1] = 1.8;
    memcpy(place.rotation, down, sizeof down);
    ck_assert_int_eq(mus_pattern_set_placement(w->pattern, plate, &place), MUS_OK);
    for (int32_t p = same; p <= plate; p++)
        ck_assert_int_eq(mus_pattern_set_layer(w->pattern, p, layer), MUS_OK);
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    def.sew_seconds = 1e-6;
    w->cloth = scene_cut(w->context, w->pattern, 0.04, 0.0);
    worn_place(w, &def);
    return w->drape;
}


START_TEST(what_is_sewn_over_starts_where_the_pattern_has_it_or_just_outside)
{
    worn plain = worn_body("W40"), w = worn_body("W40");
    const double *as_made = mus_drape_positions(over_start(&plain, 0));
    ck_assert_int_eq(mus_drape_sew(over_start(&w, 2), NULL, NULL), MUS_ERR_SEW);
    const double *x = mus_drape_positions(w.drape);
    const int32_t *panel = mus_cloth_node_panels(w.cloth);
    for (int32_t i = 0; i < mus_drape_node_count(w.drape); i++) {
        const double *a = as_made + 3 * i, *b = x + 3 * i;
        if (panel[i] == 0) continue;
        const double far = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
        ck_assert_double_lt(far, panel[i] == 3 ? 0.02 : 0.005); /* the roll's seam was pulled at, for one check */
        if (panel[i] == 1) ck_assert_double_gt(b[2], a[2] + 0.001);
    }
    worn_end(&plain);
    worn_end(&w);
}
END_TEST


/* two squares before and behind sheets that are worn and held: their short seam stays open and goes through nothing. Of
 * two sheets it was drawn through both while the last pairs could pass all cloth near them; across a single one, 4 mm
 * apart, it was welded through it */
START_TEST(what_is_sewn_over_goes_through_nothing_worn)
{
    worn w = {.context = support_context()};
    int32_t edge[4], seam[2];
    ck_assert_int_eq(mus_pattern_create(w.context, "between", &w.pattern), MUS_OK);
    const double out[] = {0.0, -0.03, 0.06, -0.09};
    const int32_t sheets = 2 - _i;
    for (int32_t p = 2 - sheets; p < 4; p++) {
        const double half = p < 2 ? 0.2 : 0.06;
        const char name[2] = {(char)('a' + p), 0};
        const int32_t panel = scene_rectangle(w.pattern, name, -half, -half, 2.0 * half, 2.0 * half, edge);
        scene_move(w.pattern, panel, 0.003 * p, 0.0, out[p]);
        ck_assert_int_eq(mus_pattern_set_layer(w.pattern, panel, p / 2), MUS_OK);
        seam[p % 2] = edge[0];
    }
    scene_sew(w.pattern, seam[0], seam[1], 0.0);
    over_place(&w, 0.04);
    const int32_t *panel = mus_cloth_node_panels(w.cloth);
    for (int32_t i = 0; i < mus_drape_node_count(w.drape); i++)
        if (panel[i] < sheets) ck_assert_int_eq(mus_drape_pin(w.drape, i, 1), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_ERR_SEW);
    ck_assert_ptr_nonnull(strstr(mus_context_error(w.context), "worn cloth lies between"));

    /* each square may have folded through itself, near the pairs that are open */
    int32_t pairs[2 * 64];
    int64_t count;
    ck_assert_int_eq(mus_drape_crossings(w.drape, 64, pairs, &count), MUS_OK);
    ck_assert_int_le(count, 64);
    for (int64_t i = 0; i < count; i++)
        ck_assert_int_eq(panel[mus_cloth_triangles(w.cloth)[3 * pairs[2 * i]]],
                         panel[mus_cloth_triangles(w.cloth)[3 * pairs[2 * i + 1]]]);
    worn_end(&w);
}
END_TEST


/* a waistcoat's side seams meet over the folds of a shirt under the arms: welded there, in and out of a fold, it was
 * through the shirt at 165 places, 919 when it was let down. What cannot be welded clear is opened again */
START_TEST(what_is_sewn_over_goes_through_no_fold)
{
    worn w = worn_body("W40");
    mus_drape_def def;
    int64_t count = -1;
    worn_put_on_design(&w, "shirt_mandarin_long", NULL);
    const int32_t shirt = mus_pattern_panel_count(w.pattern);
    worn_put_on_design(&w, "waistcoat", NULL);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = def.sew_once = 1;
    w.cloth = scene_cut(w.context, w.pattern, 0.025, 0.0);
    worn_place(&w, &def);
    const mus_status status = mus_drape_sew(w.drape, NULL, NULL);
    const char *text = mus_context_error(w.context);
    ck_assert_msg(status == MUS_OK || strstr(text, "worn cloth lies between") != NULL, "%s", text);
    int32_t pairs[2 * 64];
    ck_assert_int_eq(mus_drape_crossings(w.drape, 64, pairs, &count), MUS_OK);
    ck_assert_int_le(count, 64);
    const int32_t *panel = mus_cloth_node_panels(w.cloth), *corner = mus_cloth_triangles(w.cloth);
    for (int64_t i = 0; i < count; i++)
        ck_assert_int_eq(panel[corner[3 * pairs[2 * i]]] < shirt, panel[corner[3 * pairs[2 * i + 1]]] < shirt);
    worn_end(&w);
}
END_TEST


/* lowest place and the height of the seam at the centre back of a collar [m]: nodes within 2 cm of x = 0 */
static void collar_back(const worn *w, const char *name, double *seam, double *rim)
{
    const double *x = mus_drape_positions(w->drape), *rest = mus_cloth_rest(w->cloth);
    const int32_t *panel = mus_cloth_node_panels(w->cloth);
    double most = 0.0, least = HUGE_VAL;
    for (int32_t i = 0; i < mus_drape_node_count(w->drape); i++) {
        if (strcmp(mus_cloth_panel_name(w->cloth, panel[i]), name) != 0 || fabs(rest[2 * i]) > 0.02) continue;
        if (fabs(rest[2 * i + 1]) < least) least = fabs(rest[2 * i + 1]), *seam = x[3 * i + 1];
        if (fabs(rest[2 * i + 1]) > most) most = fabs(rest[2 * i + 1]), *rim = x[3 * i + 1];
    }
    ck_assert_double_gt(most, 0.03);
}


/* what lies on a garment is put on last, laid on it from the seam: its outer edge is below the neck behind and nothing
 * goes through anything. Sewn with the rest, that of the coat stood out behind and was inside it in front */
START_TEST(a_collar_lies_on_its_garment)
{
    static const struct {
        const char *design, *collar;
    } rows[] = {
        {"coat", "collar"}, {"shirt", "collar_leaf"}, {"blouse_peter_pan_short", "collar"}, {"middy", "collar"}};
    worn w = worn_body("W40");
    worn_put_on_design(&w, rows[_i].design, NULL);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    ck_assert_int_eq(mus_fabric_find(mus_design_fabric(mus_design_find(rows[_i].design)), &fabric), MUS_OK);
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.03, def.fabric = &fabric, def.self_contact = 1;
    ck_assert_msg(mus_dress(w.context, w.pattern, w.body, &def, NULL, NULL, &w.cloth, &w.drape) == MUS_OK, "%s",
                  mus_context_error(w.context));
    over_clear(&w);
    double seam = 0.0, rim = 0.0;
    collar_back(&w, rows[_i].collar, &seam, &rim);
    ck_assert_msg(rim < seam - 0.01, "%s: the outer edge is %.0f mm above the seam", rows[_i].design,
                  1e3 * (rim - seam));
    worn_end(&w);
}
END_TEST


/* a start on worn cloth that finds no memory is a status */
START_TEST(a_collar_that_finds_no_memory_is_not_put_on)
{
    mus_status status = MUS_ERR_MEMORY;
    int32_t failed = 0;
    for (int64_t k = 0; status != MUS_OK && failed < 40; k++) {
        worn w = worn_body("W40");
        worn_put_on_words(&w, "top neck=v collar=shawl closure=front");
        over_place(&w, 0.08);
        support_fail_after(k, false);
        status = mus_drape_sew(w.drape, NULL, NULL);
        support_fail_never();
        failed += status == MUS_ERR_MEMORY;
        if (status != MUS_OK) ck_assert_int_eq(status, MUS_ERR_MEMORY);
        worn_end(&w);
    }
    ck_assert_int_eq(status, MUS_OK);
    ck_assert_int_gt(failed, 2);
}
END_TEST


START_TEST(a_skirt_is_sewn_over_a_skirt)
{
    worn w = over_skirts("skirt_plain", 2, 0.045);
    ck_assert_msg(mus_drape_sew(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    const mus_drape_report report = over_clear(&w);
    ck_assert_int_eq(report.seams_closed, report.seams);

    /* below the hip the outer hem is farther from the middle, on the mean */
    const int32_t n = mus_drape_node_count(w.drape), *panel = mus_cloth_node_panels(w.cloth);
    const int32_t first = mus_cloth_panel_count(w.cloth) / 2;
    const double *x = mus_drape_positions(w.drape);
    double far[2] = {0.0, 0.0};
    int32_t nodes[2] = {0, 0};
    for (int32_t i = 0; i < n; i++) {
        const int32_t outer = panel[i] >= first;
        far[outer] += hypot(x[3 * i], x[3 * i + 2]);
        nodes[outer]++;
    }
    ck_assert_double_gt(far[1] / nodes[1], far[0] / nodes[0] + 0.001);
    worn_end(&w);
}
END_TEST


START_TEST(a_fit_that_finds_no_memory_gives_all_back)
{
    worn w = over_skirts("skirt_plain", 1, 0.06);
    mus_status status = MUS_ERR_MEMORY;
    for (int64_t k = 0; status != MUS_OK; k++) {
        mus_fit *fit;
        const size_t before = support_live_bytes();
        support_fail_after(k, false);
        status = mus_fit_create(w.drape, w.body, &fit);
        support_fail_never();
        if (status != MUS_OK) {
            ck_assert_int_eq(status, MUS_ERR_MEMORY);
            ck_assert_ptr_null(fit);
            ck_assert(support_live_bytes() == before);
        }
        mus_fit_destroy(fit);
    }
    worn_end(&w);
}
END_TEST


Suite *mus_suite_layers(void)
{
    Suite *suite = suite_create("layers");
    TCase *tests = tcase_create("layers");
    tcase_set_timeout(tests, 120);
    if (!SUPPORT_SLOW) tcase_add_test(tests, sleeves_close_over_sleeves);
    tcase_add_test(tests, what_is_sewn_over_starts_where_the_pattern_has_it_or_just_outside);
    tcase_add_loop_test(tests, what_is_sewn_over_goes_through_nothing_worn, 0, SUPPORT_SLOW ? 1 : 2);
    if (!SUPPORT_SLOW) tcase_add_test(tests, what_is_sewn_over_goes_through_no_fold);
    tcase_add_test(tests, a_skirt_is_sewn_over_a_skirt);
    if (!SUPPORT_SLOW) tcase_add_loop_test(tests, a_collar_lies_on_its_garment, 0, 4);
    if (!SUPPORT_SLOW) tcase_add_test(tests, a_collar_that_finds_no_memory_is_not_put_on);
    tcase_add_test(tests, a_fit_that_finds_no_memory_gives_all_back);
    if (!SUPPORT_SLOW) tcase_add_test(tests, folds_that_lie_on_folds_come_to_rest);
    suite_add_tcase(suite, tests);
    return suite;
}
