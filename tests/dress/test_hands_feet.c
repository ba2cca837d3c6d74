/*
 * test_hands_feet.c: what the body is drawn with is what cloth meets: fingers and toes lie in the touched surface,
 * cloth comes off a finger that goes through it, a foot comes into a trouser leg from above, and the triangles of a
 * garment at rest are off the skin as its nodes are. Legs go on through the floor while garments are put on, so that
 * trousers of people of all shapes stay round their ankles.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "body/body_internal.h"
#include "contact/hands_feet.h"
#include "drape/drape_state.h"
#include "drape/worn.h"
#include "dress/dynamic_relaxation.h"

Suite *mus_suite_hands_feet(void);

enum { SIDE = 5, NODES = SIDE * SIDE, ENDS = 12 };

#define CELL 0.02       /* [m] of the sheets */
#define CLEARANCE 0.002 /* [m] the default */


/* a sheet of SIDE x SIDE nodes round `middle` along a and b (3 each), round the body of W40 */
static worn sheet_at(const double *middle, const double *a, const double *b)
{
    const double cell[2] = {CELL, CELL};
    double x[3 * NODES];
    worn w = worn_body("W40");
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    ck_assert_int_eq(mus_cloth_create_grid(w.context, SIDE, SIDE, cell, NULL, &w.cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(w.context, w.cloth, w.body, &def, &w.drape), MUS_OK);
    for (int32_t i = 0; i < NODES; i++)
        for (int32_t d = 0; d < 3; d++)
            x[3 * i + d] = middle[d] + CELL * ((i % SIDE - SIDE / 2) * a[d] + (i / SIDE - SIDE / 2) * b[d]);
    ck_assert_int_eq(mus_drape_set_state(w.drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus__relax_create(w.drape), MUS_OK);
    return w;
}


/* the free ends of the body of W40 */
static void ends_of(double *end)
{
    const double origin[3] = {0.0, 0.0, 0.0};
    worn w = worn_body("W40");
    mus__collider *collider;
    ck_assert_int_eq(mus__collider_create(w.context, w.body, origin, CLEARANCE, &collider), MUS_OK);
    ck_assert_int_eq(mus__collider_ends(collider, ENDS + 1, end), ENDS);
    mus__collider_destroy(collider);
    worn_end(&w);
}


static const char *const sizes[] = {"W34", "W40", "W52", "M50", "M58", "C56", "C116"};


/* no vertex of a finger or toe is as far beyond it as cloth keeps off */
START_TEST(digits_lie_in_what_cloth_touches)
{
    const double origin[3] = {0.0, 0.0, 0.0};
    worn w = worn_body(sizes[_i]);
    mus__collider *collider;
    ck_assert_int_eq(mus__collider_create(w.context, w.body, origin, CLEARANCE, &collider), MUS_OK);
    const double *x = mus_body_vertices(w.body);
    for (int32_t i = 0; i < mus_body_vertex_count(w.body); i++)
        ck_assert_double_ge(mus__collider_body_depth(collider, x + 3 * i, 0.1, NULL), -CLEARANCE);

    /* while a garment is put on feet are away, hands slim, and legs go on through the floor, nine tenths as wide there
     * as at the ankle; then all are as they were, to the last bit */
    const mus__contour *ankle = &w.body->limb[MUS__LIMB_LEG_LEFT].contour[0];
    const double aside = w.body->limb[MUS__LIMB_LEG_LEFT].origin[0] + ankle->ca + 0.85 * ankle->a;
    const double floor[3] = {aside, 0.001, -ankle->cb}, bare = mus__collider_body_depth(collider, floor, 0.1, NULL);
    double before = 0.0, slim = 0.0, after = 0.0, end[6 * ENDS];
    mus__collider_ends(collider, ENDS, end);
    const uint64_t feet = mus__collider_feet(collider);
    ck_assert(feet != 0);
    for (int32_t k = 0; k < ENDS; k++) before += mus__collider_body_depth(collider, end + 6 * k + 3, 0.1, NULL);
    mus__collider_spread(collider, false);
    for (int32_t k = 0; k < ENDS; k++) slim += mus__collider_body_depth(collider, end + 6 * k + 3, 0.1, NULL);
    const double low[3] = {-1.0, 0.0, -1.0}, high[3] = {1.0, 0.01, 1.0};
    ck_assert_uint_eq(mus__collider_parts_near(collider, low, high, 0.0) & feet, 0);
    ck_assert_double_gt(mus__collider_body_depth(collider, floor, 0.1, NULL), 0.0);
    mus__collider_spread(collider, true);
    ck_assert_double_eq(mus__collider_body_depth(collider, floor, 0.1, NULL), bare);
    for (int32_t k = 0; k < ENDS; k++) after += mus__collider_body_depth(collider, end + 6 * k + 3, 0.1, NULL);
    ck_assert_uint_eq(mus__collider_parts_near(collider, low, high, 0.0) & feet, feet);
    ck_assert_double_lt(slim, before);
    ck_assert_double_eq(after, before);
    mus__collider_destroy(collider);
    worn_end(&w);
}
END_TEST


/* a sheet across the middle of each finger, and of each hand */
START_TEST(cloth_comes_off_a_finger)
{
    double ends[6 * ENDS], way[3], a[3], b[3], middle[3];
    ends_of(ends);
    const double *end = ends + 6 * _i;
    for (int32_t d = 0; d < 3; d++) way[d] = end[3 + d] - end[d], middle[d] = 0.5 * (end[d] + end[3 + d]);
    const double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    const double flat = hypot(way[0], way[2]);
    a[0] = -way[2] / flat, a[1] = 0.0, a[2] = way[0] / flat;
    for (int32_t d = 0; d < 3; d++)
        b[d] = (way[(d + 1) % 3] * a[(d + 2) % 3] - way[(d + 2) % 3] * a[(d + 1) % 3]) / length;
    worn w = sheet_at(middle, a, b);
    ck_assert_int_gt(mus__draw_off(w.drape), 0);

    /* nodes beside the axis are beyond the tip, those further off are where they were */
    const double *x = mus_drape_positions(w.drape);
    for (int32_t i = 0; i < NODES; i++) {
        double along = 0.0;
        for (int32_t d = 0; d < 3; d++) along += (x[3 * i + d] - end[d]) * way[d] / length;
        if (i == NODES / 2) ck_assert_double_ge(along, length);
        if (i == 0) ck_assert_double_eq_tol(along, 0.5 * length, 1e-6);
    }
    ck_assert_int_eq(mus__draw_off(w.drape), 0);
    worn_end(&w);
}
END_TEST


/* whether any of the body is over a place that is under 15 cm, or nearer to it than cloth keeps off */
static bool under_a_foot(const worn *w, const double *place)
{
    for (double at[3] = {place[0], place[1], place[2]}; at[1] < 0.15; at[1] += 0.002)
        if (mus__collider_body_depth(w->drape->scene.collider, at, 0.1, NULL) > -CLEARANCE + 1e-4) return true;
    return false;
}


static const double foot_heights[] = {0.04, 0.02}; /* [m] of the middle row: the lower sheet has two under the sole */


/* an upright sheet that goes down through the left foot, and under its sole, is over it then, its rows in their order
 */
START_TEST(a_foot_comes_in_from_above)
{
    static const double across[3] = {1.0, 0.0, 0.0}, up[3] = {0.0, 1.0, 0.0};
    const double middle[3] = {0.09, foot_heights[_i], 0.06};
    worn w = sheet_at(middle, across, up);
    int32_t lifted = 0;
    double before[3 * NODES];
    memcpy(before, mus_drape_positions(w.drape), sizeof before);
    const int32_t found = mus__draw_off(w.drape);
    ck_assert_int_gt(found, SIDE);
    const double *x = mus_drape_positions(w.drape);
    for (int32_t i = 0; i < NODES; i++) {
        ck_assert(!under_a_foot(&w, x + 3 * i));
        ck_assert_double_eq(x[3 * i], before[3 * i]);
        ck_assert_double_ge(x[3 * i + 1], before[3 * i + 1]);
        if (i >= SIDE) ck_assert_double_gt(x[3 * i + 1], x[3 * (i - SIDE) + 1]);
        lifted += x[3 * i + 1] > before[3 * i + 1];
    }
    ck_assert_int_ge(lifted, found);
    worn_end(&w);
}
END_TEST


/* an upright sheet that goes down through the foot and beside it as low as under the floor: all of it is over the floor
 * then, its outer rows in their order, and what hung beside the foot above the floor is where it was */
START_TEST(a_foot_leaves_nothing_below_the_floor)
{
    static const double middle[3] = {0.15, 0.0, 0.06}, across[3] = {1.0, 0.0, 0.0}, up[3] = {0.0, 1.0, 0.0};
    worn w = sheet_at(middle, across, up);
    int32_t stays = 0;
    double before[3 * NODES];
    memcpy(before, mus_drape_positions(w.drape), sizeof before);
    ck_assert_int_gt(mus__draw_off(w.drape), 0);
    const double *x = mus_drape_positions(w.drape);
    for (int32_t i = 0; i < NODES; i++) {
        ck_assert(!under_a_foot(&w, x + 3 * i));
        ck_assert_double_ge(x[3 * i + 1], 0.0);
        if (i > SIDE && i % SIDE == SIDE - 1) ck_assert_double_gt(x[3 * i + 1], x[3 * (i - SIDE) + 1]);
        stays += x[3 * i + 1] == before[3 * i + 1];
    }
    ck_assert_int_gt(stays, 0);
    worn_end(&w);
}
END_TEST


/* between the legs surfaces face each other: they pinch what is nearer to both than the reach, and the side of a leg
 * pinches nothing */
START_TEST(legs_pinch_what_lies_between_them)
{
    const double origin[3] = {0.0, 0.0, 0.0};
    worn w = worn_body("W40");
    mus__collider *collider;
    ck_assert_int_eq(mus__collider_create(w.context, w.body, origin, CLEARANCE, &collider), MUS_OK);
    double middle[3] = {0.0, 0.7, 0.0}, apart = 1.0; /* 70 cm up, where thighs are near */
    for (int32_t k = -100; k <= 100; k++) {          /* where the legs are nearest, there they face each other */
        const double place[3] = {0.0, middle[1], 0.002 * k};
        const double here = -mus__collider_body_depth(collider, place, 0.5, NULL);
        if (here < apart) apart = here, middle[2] = place[2];
    }
    ck_assert_double_gt(apart, 0.0);
    ck_assert(mus__collider_pinches(collider, middle, 1.1 * apart));
    ck_assert(!mus__collider_pinches(collider, middle, 0.9 * apart));
    const double beside[3] = {0.4, middle[1], middle[2]};
    ck_assert(!mus__collider_pinches(collider, beside, 0.4));
    mus__collider_destroy(collider);
    worn_end(&w);
}
END_TEST


typedef struct clear_row {
    const char *design, *size;
} clear_row;

static const clear_row clear_rows[] = {
    {"leggings", "W40"}, {"tshirt", "M50"}, {"palazzo", "W40"}, {"jeans_flare", "C116"}, {"hoodie", "W52"}};


/* garments at rest: 66 places of each triangle are less than a millimetre in the skin, and no node is under the floor
 */
START_TEST(triangles_are_off_the_skin)
{
    enum { PARTS = 10 };
    const clear_row *row = &clear_rows[_i];
    worn w = worn_body(row->size);
    worn_put_on_design(&w, row->design, NULL);
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.02;
    ck_assert_msg(mus_dress(w.context, w.pattern, w.body, &def, NULL, NULL, &w.cloth, &w.drape) == MUS_OK, "%s",
                  mus_context_error(w.context));
    const double *x = mus_drape_positions(w.drape);
    const int32_t *corner = mus_cloth_triangles(w.cloth);
    double deepest = -1.0;
    for (int32_t k = 0; k < mus_cloth_triangle_count(w.cloth); k++) {
        double place[3 * 66];
        int32_t n = 0;
        for (int32_t i = 0; i <= PARTS; i++)
            for (int32_t j = 0; i + j <= PARTS; j++, n++)
                for (int32_t d = 0; d < 3; d++)
                    place[3 * n + d] = (i * x[3 * corner[3 * k] + d] + j * x[3 * corner[3 * k + 1] + d] +
                                        (PARTS - i - j) * x[3 * corner[3 * k + 2] + d]) /
                                       PARTS;
        double depth[66];
        ck_assert_int_eq(mus_body_depth(w.body, n, place, depth, NULL), MUS_OK);
        for (int32_t i = 0; i < n; i++) deepest = fmax(deepest, depth[i]);
    }
    ck_assert_double_le(deepest, 1e-3);
    for (int32_t i = 0; i < mus_drape_node_count(w.drape); i++) ck_assert_double_gt(x[3 * i + 1], 0.0);

    /* feet and fingers are in already: a settle after it leaves the cloth where it lies */
    const int32_t n = 3 * mus_drape_node_count(w.drape);
    double *before = malloc((size_t)n * sizeof *before), farthest = 0.0;
    memcpy(before, x, (size_t)n * sizeof *before);
    ck_assert_int_eq(mus__draw_off(w.drape), 0);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);
    x = mus_drape_positions(w.drape);
    for (int32_t i = 0; i < n; i++) farthest = fmax(farthest, fabs(x[i] - before[i]));
    ck_assert_double_le(farthest, 2e-3);
    free(before);
    worn_end(&w);
}
END_TEST


typedef struct person_row {
    const char *design;
    int32_t sex;
    double measure[4]; /* stature, bust, waist, hip [m] */
} person_row;


/* a design dressed at 20 mm with self-contact on its person is worn, and no triangle goes through the body */
static void dress_person(const person_row *row, int32_t starts)
{
    static const int32_t measure[] = {MUS_MEASURE_STATURE, MUS_MEASURE_BUST, MUS_MEASURE_WAIST, MUS_MEASURE_HIP};
    worn w = {.context = support_context()};
    ck_assert_int_eq(mus_tape_create(w.context, &w.tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_sex(w.tape, row->sex), MUS_OK);
    for (int32_t m = 0; m < 4; m++)
        ck_assert_int_eq(mus_tape_set(w.tape, measure[m], row->measure[m], MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(w.tape), MUS_OK);
    ck_assert_int_eq(mus_body_create(w.context, w.tape, NULL, &w.body), MUS_OK);
    worn_put_on_design(&w, row->design, NULL);
    mus_dress_def def;
    mus_dress_report report;
    mus_worn how;
    mus_dress_def_init(&def, sizeof def);
    mus_dress_report_init(&report, sizeof report);
    mus_worn_init(&how, sizeof how);
    def.spacing = 0.02, def.self_contact = 1;
    ck_assert_msg(mus_dress(w.context, w.pattern, w.body, &def, &report, NULL, &w.cloth, &w.drape) == MUS_OK, "%s",
                  mus_context_error(w.context));
    ck_assert_int_le(report.starts, starts);
    ck_assert_int_eq(mus_fit_worn(w.drape, w.pattern, w.body, &how), MUS_OK);
    ck_assert_msg(how.kind == MUS_WORN_YES, "%s", how.text);
    worn_end(&w);
}


/* a wide leg on a thin ankle, a tapered one on a stout ankle, a band of rib round it, a long leg that lies on the foot
 */
static const person_row ankle_rows[] = {{"pyjama_trousers", MUS_SEX_MALE, {2.00, 0.86, 0.70, 0.86}},
                                        {"jumpsuit_strapless_tapered", MUS_SEX_FEMALE, {1.65, 1.20, 1.30, 1.12}},
                                        {"harem_trousers", MUS_SEX_FEMALE, {1.65, 0.84, 0.72, 1.25}},
                                        {"straight_elastic_full", MUS_SEX_FEMALE, {1.65, 1.20, 1.30, 1.12}}};


/* trousers of people of all shapes: at the first start both legs are in their trouser legs */
START_TEST(trouser_legs_stay_round_the_ankles)
{
    dress_person(&ankle_rows[_i], 1);
}
END_TEST


/* trousers of a tall stout man on a thin woman, without a floor, begin 20 cm under her feet: both legs are in them */
START_TEST(legs_far_too_long_stay_round_the_ankles)
{
    worn w = worn_body("W34");
    mus_tape *large;
    mus_cloth_def cut;
    mus_drape_def def;
    mus_worn how;
    ck_assert_int_eq(mus_tape_create(w.context, &large), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(large, "M58"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(w.context, mus_design_find("straight_trousers"), large, NULL, &w.pattern),
                     MUS_OK);
    mus_tape_destroy(large);
    ck_assert_int_eq(mus_arrange_pattern(w.pattern, w.body), MUS_OK);
    for (int32_t e = 0; e < mus_pattern_edge_count(w.pattern); e++)
        ck_assert_int_eq(mus_pattern_set_edge_hold(w.pattern, e, MUS_HOLD_NONE, 0.0), MUS_OK);
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.02;
    ck_assert_int_eq(mus_cloth_create(w.context, w.pattern, &cut, &w.cloth), MUS_OK);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    worn_place(&w, &def);
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_OK);
    mus_drape_settle(w.drape, NULL, NULL); /* at rest or still on their way down */
    mus_worn_init(&how, sizeof how);
    ck_assert_int_eq(mus_fit_worn(w.drape, w.pattern, w.body, &how), MUS_OK);
    ck_assert_msg(how.kind != MUS_WORN_OPENING, "%s", how.text);
    worn_end(&w);
}
END_TEST


/* cloth in the creases under thin arms, under stout arms, a hem that comes to lie on the feet long after it fell, and
 * cloth that other cloth presses on the body: a facing, a waist, a back */
static const person_row crease_rows[] = {{"knit_scoop_cap", MUS_SEX_FEMALE, {1.88, 0.76, 0.58, 0.82}},
                                         {"top_empire_scoop_sleeveless", MUS_SEX_FEMALE, {1.50, 1.50, 1.50, 1.60}},
                                         {"quarter_skirt_maxi", MUS_SEX_MALE, {2.00, 0.86, 0.70, 0.86}},
                                         {"panel_a_line_square_short", MUS_SEX_CHILD, {1.40, 0.85, 0.85, 0.90}},
                                         {"bootcut_trousers", MUS_SEX_MALE, {1.55, 1.50, 1.65, 1.55}},
                                         {"sheath_scoop_long", MUS_SEX_MALE, {1.80, 1.25, 0.80, 0.95}}};


START_TEST(creases_and_feet_do_not_come_through)
{
    dress_person(&crease_rows[_i], 4);
}
END_TEST


Suite *mus_suite_hands_feet(void)
{
    Suite *suite = suite_create("hands_feet");
    TCase *tests = tcase_create("hands_feet");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, digits_lie_in_what_cloth_touches, 0, sizeof sizes / sizeof sizes[0]);
    tcase_add_loop_test(tests, cloth_comes_off_a_finger, 0, ENDS);
    tcase_add_test(tests, legs_pinch_what_lies_between_them);
    tcase_add_loop_test(tests, a_foot_comes_in_from_above, 0, sizeof foot_heights / sizeof foot_heights[0]);
    tcase_add_test(tests, a_foot_leaves_nothing_below_the_floor);
    tcase_add_loop_test(tests, triangles_are_off_the_skin, 0, sizeof clear_rows / sizeof clear_rows[0]);
    tcase_add_loop_test(tests, trouser_legs_stay_round_the_ankles, 0, sizeof ankle_rows / sizeof ankle_rows[0]);
    if (!SUPPORT_SLOW) tcase_add_test(tests, legs_far_too_long_stay_round_the_ankles);
    tcase_add_loop_test(tests, creases_and_feet_do_not_come_through, 0,
                        SUPPORT_SLOW ? 1 : sizeof crease_rows / sizeof crease_rows[0]);
    suite_add_tcase(suite, tests);
    return suite;
}
