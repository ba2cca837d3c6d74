/*
 * test_arrange_check.c: bad starts are named before anything is sewn, those of designs changed on purpose; good ones
 * are not.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"
#include "muslin/exchange.h"

typedef struct begin {
    mus_context *context;
    mus_body *body;
    mus_pattern *pattern;
} begin;


static begin begin_draft(const char *design)
{
    begin s = {.context = support_context()};
    mus_tape *tape;
    s.body = scene_body(s.context);
    ck_assert_int_eq(mus_tape_create(s.context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_design_draft(s.context, mus_design_find(design), tape, NULL, &s.pattern), MUS_OK);
    mus_tape_destroy(tape);
    return s;
}


static void begin_end(begin *s)
{
    mus_pattern_destroy(s->pattern);
    mus_body_destroy(s->body);
    support_context_end(s->context);
}


/* Returns the reason that a pattern's check gives, else that of its arrangement before sewing. */
static mus_reason begin_reason(const begin *s, double spacing)
{
    mus_reason reason;
    mus_cloth_def cut;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_reason_init(&reason, sizeof reason);
    ck_assert_int_eq(mus_pattern_reason(s->pattern, &reason), MUS_OK);
    if (reason.kind != MUS_REASON_NONE) return reason;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = spacing;
    ck_assert_int_eq(mus_cloth_create(s->context, s->pattern, &cut, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(s->context, cloth, s->body, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    const uint64_t hash = mus_drape_hash(drape);
    ck_assert_int_eq(mus_drape_start(drape, &reason), MUS_OK);
    ck_assert(mus_drape_hash(drape) == hash);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return reason;
}


static mus_placement begin_placement(const begin *s, const char *panel)
{
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    ck_assert_int_eq(mus_pattern_placement(s->pattern, mus_pattern_find_panel(s->pattern, panel), &place), MUS_OK);
    return place;
}


static void begin_put(const begin *s, const char *panel, const mus_placement *place)
{
    ck_assert_int_eq(mus_pattern_set_placement(s->pattern, mus_pattern_find_panel(s->pattern, panel), place), MUS_OK);
}


static const char *const good[] = {"tshirt", "oxford_shirt",    "jeans",  "hoodie",         "gored8_skirt_midi",
                                   "sheath", "wrap_skirt_mini", "poncho", "cape_hood_knee", "boiler_suit"};
enum { GOOD = sizeof good / sizeof *good };

START_TEST(where_designs_start_nothing_is_wrong)
{
    begin s = begin_draft(good[_i]);
    const mus_reason reason = begin_reason(&s, 0.04);
    ck_assert_msg(reason.kind == MUS_REASON_NONE, "%s: %s", good[_i], reason.text);
    begin_end(&s);
}
END_TEST


/* patterns that others drafted, where they start and where a start is found; all of them: make corpus */
static const struct {
    const char *spec, *body;
} specs[] = {{"d11_041_mean_all", "mean_all"},
             {"d11_036_mean_female", "mean_female"},
             {"d11_046_mean_female", "mean_female"},
             {"d11_010_mean_all", "mean_all"},
             {"d11_044_m_smpl_average_A40", "m_smpl_average_A40"},
             {"d11_026_mean_female", "mean_female"}};
enum { SPECS = sizeof specs / sizeof *specs };

START_TEST(where_garmentcode_starts_nothing_is_wrong)
{
    char relative[128], spec[1024], body[1024];
    snprintf(relative, sizeof relative, "garmentcode/specs/%s_specification.json", specs[_i].spec);
    if (support_data(relative, spec, sizeof spec) == NULL) return;
    snprintf(relative, sizeof relative, "garmentcode/bodies/%s.yaml", specs[_i].body);
    if (support_data(relative, body, sizeof body) == NULL) return;
    begin s = {.context = support_context()};
    mus_tape *tape;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    ck_assert_int_eq(mus_tape_read(s.context, body, NULL, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_body_create(s.context, tape, &def, &s.body), MUS_OK);
    ck_assert_int_eq(mus_pattern_read(s.context, spec, &s.pattern), MUS_OK);
    mus_reason reason = begin_reason(&s, 0.05);
    ck_assert_msg(reason.kind == MUS_REASON_NONE, "%s: %s", specs[_i].spec, reason.text);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_OK);
    reason = begin_reason(&s, 0.05);
    ck_assert_msg(reason.kind == MUS_REASON_NONE, "%s, found: %s", specs[_i].spec, reason.text);
    mus_tape_destroy(tape);
    begin_end(&s);
}
END_TEST


/* S6: any one seam of the garment sewn the wrong way round is named, of sleeves as of the rest */
static const char *const sewn[] = {"tshirt", "oxford_shirt", "jeans", "hoodie"};
enum { SEWN = sizeof sewn / sizeof *sewn };

START_TEST(a_seam_sewn_the_wrong_way_is_named)
{
    begin s = begin_draft(sewn[_i]);
    const int32_t n = mus_pattern_seam_count(s.pattern), step = SUPPORT_SLOW ? 5 : 1;
    int32_t by_check = 0;
    mus_pattern *right = s.pattern;
    for (int32_t i = 0; i < n; i += step) {
        mus_seam_def seam;
        int32_t flipped;
        mus_seam_def_init(&seam, sizeof seam);
        ck_assert_int_eq(mus_pattern_copy(right, &s.pattern), MUS_OK);
        ck_assert_int_eq(mus_pattern_seam(s.pattern, i, &seam), MUS_OK);

        /* cut out and sewn in again, the other way round; edges keep their order */
        ck_assert_int_eq(mus_pattern_remove_seam(s.pattern, i), MUS_OK);
        seam.direction = seam.direction == MUS_SEAM_DIRECT ? MUS_SEAM_REVERSED : MUS_SEAM_DIRECT;
        ck_assert_int_eq(mus_pattern_add_seam(s.pattern, &seam, &flipped), MUS_OK);
        const mus_reason reason = begin_reason(&s, 0.05);
        ck_assert_msg(reason.kind == MUS_REASON_TWISTED_SEAM || reason.kind == MUS_REASON_START_TANGLED,
                      "%s: seam %d of %d flipped: kind %d %s", sewn[_i], (int)i, (int)n, (int)reason.kind, reason.text);
        char name[32];
        snprintf(name, sizeof name, "seam %d", (int)flipped);
        ck_assert_msg(reason.seam == flipped && strstr(reason.text, name) != NULL, "%s: seam %d flipped: %s", sewn[_i],
                      (int)i, reason.text);
        by_check += reason.kind == MUS_REASON_TWISTED_SEAM;
        mus_pattern_destroy(s.pattern);
    }
    s.pattern = right;
    ck_assert_int_gt(by_check, 0);
    begin_end(&s);
}
END_TEST


/* two panels that start where the other should */
static const struct {
    const char *design, *a, *b;
    double aside; /* [m] halves have one placement, and their places are this far from each other */
} swaps[] = {{"tshirt", "front", "back", 0.0},
             {"tshirt", "sleeve_left", "sleeve_right", 0.0},
             {"oxford_shirt", "front_left", "front_right", 0.25},
             {"oxford_shirt", "sleeve_left", "sleeve_right", 0.0},
             {"jeans", "leg_front_left", "leg_front_right", 0.3}};
enum { SWAPS = sizeof swaps / sizeof *swaps };

START_TEST(panels_in_each_others_place_are_named)
{
    begin s = begin_draft(swaps[_i].design);
    mus_placement a = begin_placement(&s, swaps[_i].a), b = begin_placement(&s, swaps[_i].b);
    a.origin[0] -= swaps[_i].aside, b.origin[0] += swaps[_i].aside;
    begin_put(&s, swaps[_i].a, swaps[_i].aside > 0.0 ? &a : &b);
    begin_put(&s, swaps[_i].b, swaps[_i].aside > 0.0 ? &b : &a);
    const mus_reason reason = begin_reason(&s, 0.05);
    ck_assert_msg(reason.kind == MUS_REASON_START_TANGLED && strstr(reason.text, swaps[_i].a) != NULL &&
                      strstr(reason.text, swaps[_i].b) != NULL,
                  "%s, %s and %s: %d %s", swaps[_i].design, swaps[_i].a, swaps[_i].b, (int)reason.kind, reason.text);
    ck_assert_int_ne(reason.panel, MUS_NONE);
    begin_end(&s);
}
END_TEST


/* in the body; turned with its right side to the body; across what it is not sewn to */
START_TEST(a_panel_in_a_bad_place_is_named)
{
    static const char *const panels[] = {"front", "sleeve_left", "cuff_left"};
    static const char *const words[] = {"begins inside the body", "turned round", "through each other"};
    begin s = begin_draft(_i == 2 ? "oxford_shirt" : "tshirt");
    mus_placement place = begin_placement(&s, panels[_i]);
    if (_i == 0) {
        place.origin[2] = 0.0;
    } else if (_i == 1) {
        /* half a turn about the arm's crown */
        for (int i = 0; i < 3; i++) place.rotation[3 * i] *= -1.0, place.rotation[3 * i + 1] *= -1.0;
    } else {
        const mus_placement front = begin_placement(&s, "front_left");
        memcpy(place.origin, front.origin, sizeof place.origin);
        place.origin[0] += 0.1, place.origin[1] += 0.1;
    }
    begin_put(&s, panels[_i], &place);
    const mus_reason reason = begin_reason(&s, _i == 2 ? 0.025 : 0.05);
    ck_assert_msg(reason.kind == MUS_REASON_START_TANGLED && strstr(reason.text, panels[_i]) != NULL &&
                      strstr(reason.text, words[_i]) != NULL,
                  "%s: %d %s", panels[_i], (int)reason.kind, reason.text);
    begin_end(&s);
}
END_TEST


/* a tube round a tube: in order nothing is said; outside before and inside behind, or through one another, it is */
START_TEST(layers_in_no_order_are_named)
{
    mus_context *context = support_context();
    mus_body *body = scene_body(context);
    begin s = {context, body, NULL};
    ck_assert_int_eq(mus_pattern_create(context, "two", &s.pattern), MUS_OK);
    static const double z[3][4] = {{0.25, -0.25, 0.29, -0.29}, {0.25, -0.29, 0.29, -0.25}, {0.25, -0.25, 0.25, -0.29}};
    int32_t edge[4][4];
    for (int i = 0; i < 4; i++) {
        char name[32];
        snprintf(name, sizeof name, "%s_%d", i % 2 == 0 ? "front" : "back", i / 2);
        const int32_t panel = scene_rectangle(s.pattern, name, -0.3, -0.4, 0.6, 0.4, edge[i]);
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        place.origin[1] = 1.0, place.origin[2] = z[_i][i];
        if (i % 2 == 1) place.rotation[0] = place.rotation[8] = -1.0;
        if (_i == 2 && i == 2)
            place.rotation[5] = -0.28, place.rotation[7] = 0.28, place.rotation[4] = place.rotation[8] = 0.96;
        ck_assert_int_eq(mus_pattern_set_placement(s.pattern, panel, &place), MUS_OK);
    }
    for (int i = 0; i < 4; i += 2) {
        scene_sew(s.pattern, edge[i][1], edge[i + 1][3], 0.0);
        scene_sew(s.pattern, edge[i][3], edge[i + 1][1], 0.0);
    }
    const mus_reason reason = begin_reason(&s, 0.03);
    static const char *const words[] = {"", "in no order", "through each other"};
    ck_assert_msg(reason.kind == (_i == 0 ? MUS_REASON_NONE : MUS_REASON_START_TANGLED), "%d: %s", _i, reason.text);
    ck_assert_msg(strstr(reason.text, words[_i]) != NULL, "%d: %s", _i, reason.text);

    /* without memory nothing is said either way */
    mus_cloth *cloth = scene_cut(context, s.pattern, 0.05, 0.0);
    mus_drape *drape;
    mus_reason why;
    mus_reason_init(&why, sizeof why);
    ck_assert_int_eq(mus_drape_create(context, cloth, body, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    for (int64_t n = 0;; n++) {
        support_fail_after(n, false);
        const mus_status status = mus_drape_start(drape, &why);
        support_fail_never();
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_lt(n, 100);
    }
    ck_assert_int_eq(mus_drape_start(NULL, &why), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_start(drape, NULL), MUS_ERR_VERSION);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    begin_end(&s);
}
END_TEST


Suite *mus_suite_arrange_check(void);


Suite *mus_suite_arrange_check(void)
{
    Suite *suite = suite_create("arrange_check");
    TCase *tests = tcase_create("arrange_check");
    tcase_set_timeout(tests, 60.0);
    tcase_add_loop_test(tests, where_designs_start_nothing_is_wrong, 0, SUPPORT_SLOW ? 2 : GOOD);
    tcase_add_loop_test(tests, where_garmentcode_starts_nothing_is_wrong, 0, SUPPORT_SLOW ? 1 : SPECS);
    tcase_add_loop_test(tests, a_seam_sewn_the_wrong_way_is_named, 0, SUPPORT_SLOW ? 1 : SEWN);
    tcase_add_loop_test(tests, panels_in_each_others_place_are_named, 0, SUPPORT_SLOW ? 2 : SWAPS);
    tcase_add_loop_test(tests, a_panel_in_a_bad_place_is_named, 0, 3);
    tcase_add_loop_test(tests, layers_in_no_order_are_named, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}
