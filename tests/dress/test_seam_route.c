/*
 * test_seam_route.c: what closes over the shoulders is sewn there: straps at the rim of the shoulders are drawn over
 * them and not under the arms, and to the middle of the shoulders; side seams go under the arms. What is held at the
 * armpits is not drawn over the arms while it is sewn.
 */
#include <math.h>

#include "body/body_internal.h"
#include "drape/drape_state.h"
#include "drape/scenes.h"
#include "drape/worn.h"
#include "dress/sew.h"
#include "geom/vec.h"

Suite *mus_suite_seam_route(void);

#define SPACING 0.03


/* a panel of `count` corners, its lines all forward; edge (count) */
static int32_t lift_panel(mus_pattern *pattern, const char *name, const double (*corner)[2], int32_t count,
                          int32_t *edge)
{
    int32_t panel, point[16], forward[16];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int32_t i = 0; i < count; i++) {
        forward[i] = 1;
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]), MUS_OK);
    }
    for (int32_t i = 0; i < count; i++)
        ck_assert_int_eq(
            mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                          .end = point[(i + 1) % count]}, &edge[i]), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, count, edge, forward), MUS_OK);
    return panel;
}


/* the same panel before and behind, face outward, the origin at a height */
static void lift_both(mus_pattern *pattern, const double (*corner)[2], int32_t count, double height,
                      int32_t edge[2][16])
{
    for (int32_t i = 0; i < 2; i++) {
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        place.origin[1] = height, place.origin[2] = i == 0 ? 0.3 : -0.25;
        if (i == 1) place.rotation[0] = place.rotation[8] = -1.0;
        const int32_t panel = lift_panel(pattern, i == 0 ? "front" : "back", corner, count, edge[i]);
        ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
    }
}


/* a square neck down to the waist, straps 25 mm broad of which the outer edge is at `rim`; origin at the shoulder */
static mus_pattern *strap_top(mus_context *context, double rim, double height)
{
    const double corner[12][2] = {{-0.19, -0.46},     {0.19, -0.46},      {0.23, -0.18},        {rim, -0.12},
                                  {rim, -0.01},       {rim - 0.025, 0.0}, {rim - 0.025, -0.35}, {0.025 - rim, -0.35},
                                  {0.025 - rim, 0.0}, {-rim, -0.01},      {-rim, -0.12},        {-0.23, -0.18}};
    int32_t edge[2][16];
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "straps", &pattern), MUS_OK);
    lift_both(pattern, corner, 12, height, edge);
    scene_sew(pattern, edge[0][1], edge[1][11], 0.0);
    scene_sew(pattern, edge[0][11], edge[1][1], 0.0);
    scene_sew(pattern, edge[0][4], edge[1][8], 0.0);
    scene_sew(pattern, edge[0][8], edge[1][4], 0.0);
    return pattern;
}


/* a body with nothing on; a pattern on it where it starts */
static worn lift_body(void)
{
    worn w = {.context = support_context()};
    w.body = scene_body(w.context);
    return w;
}


static void lift_put_on(worn *w, mus_pattern *pattern, const mus_drape_def *def)
{
    worn_put_on(w, pattern);
    w->cloth = scene_cut(w->context, pattern, SPACING, 0.0);
    worn_place(w, def);
}


/* half the breadth of the shoulders, and their height */
static double lift_rim(const worn *w, double *neck, double *height)
{
    double top[3];
    ck_assert_int_eq(mus_body_landmark(w->body, MUS_LANDMARK_SHOULDER_LEFT, top), MUS_OK);
    *height = top[1];
    *neck = w->body->skeleton.neck_side_x;
    return w->body->skeleton.shoulder_end;
}


static void lift_sew(const worn *w)
{
    ck_assert_msg(mus_drape_sew(w->drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w->context));
}


static void lift_settle(const worn *w)
{
    ck_assert_msg(mus_drape_settle(w->drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w->context));
}


/* Returns the position of a pair of a seam's ends after sewing. */
static const double *lift_pair_at(const worn *w, int32_t pair)
{
    return w->drape->x + 3 * (int64_t)w->drape->rep[w->cloth->pair[2 * pair]];
}


START_TEST(straps_close_over_the_shoulders)
{
    worn w = lift_body();
    mus_drape_def def;
    mus__level_plane armpit;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = _i;

    /* at the rim of the shoulders, as high as they are there */
    double neck, height;
    const double rim = lift_rim(&w, &neck, &height);
    lift_put_on(&w, strap_top(w.context, rim, height + 0.06), &def);
    lift_sew(&w);
    mus__scene_level(w.drape, MUS_HOLD_ARMPIT, 0, &armpit);

    /* seams 2 and 3 are those of the straps: they are sewn on the shoulders, between the neck and a centimetre beyond
     * the rim, where the ball of the arm carries them, and are there at rest */
    for (int32_t settled = 0; settled < 2; settled++) {
        for (int32_t p = 0; p < w.cloth->npair; p++) {
            if (w.cloth->pair_seam[p] < 2) continue;
            const double *x = lift_pair_at(&w, p);
            ck_assert_double_gt(mus__dot3(armpit.up, x), armpit.at + 0.06);
            ck_assert_double_lt(fabs(x[0]), rim + (settled ? 0.04 : 0.01));
            ck_assert_double_gt(fabs(x[0]), neck);
        }
        if (!settled) lift_settle(&w);
    }
    worn_end(&w);
}
END_TEST


/* the ends of all straps together at a place of the left shoulder, mirrored on the right */
static mus__straps lift_straps_at(const worn *w, double aside, double height, double front, int32_t *seam)
{
    for (int32_t p = 0; p < w->drape->program.npair; p++) {
        const mus__seam_pair *pair = &w->drape->program.pair[p];
        double *a = w->drape->x + 3 * (int64_t)pair->a, *b = w->drape->x + 3 * (int64_t)pair->b;
        if (pair->way != 2) continue;
        a[0] = b[0] = copysign(aside, pair->lateral);
        a[1] = b[1] = height;
        a[2] = b[2] = front;
    }
    return mus__seam_route_straps(w->drape, seam);
}


START_TEST(a_strap_before_the_arm_is_not_on_the_shoulder)
{
    worn w = lift_body();
    mus__level_plane armpit;
    double neck, height, joint[3];
    int32_t seam = MUS_NONE;
    const double rim = lift_rim(&w, &neck, &height);
    ck_assert_int_eq(mus_body_landmark(w.body, MUS_LANDMARK_SHOULDER_LEFT, joint), MUS_OK);
    lift_put_on(&w, strap_top(w.context, rim, height + 0.06), NULL);
    ck_assert_int_eq(mus__sew_create(w.drape), MUS_OK);
    mus__seam_route_start(w.drape);
    mus__scene_level(w.drape, MUS_HOLD_ARMPIT, 0, &armpit);

    /* on the shoulder, behind it but near the neck; under the arm, and before it, all above the armpits */
    ck_assert_int_eq(lift_straps_at(&w, 0.9 * rim, height + 0.05, joint[2], &seam), MUS__STRAPS_ON);
    ck_assert_int_eq(lift_straps_at(&w, 1.1 * neck, height, joint[2] - 0.06, &seam), MUS__STRAPS_ON);
    ck_assert_int_eq(seam, MUS_NONE);
    ck_assert_int_eq(lift_straps_at(&w, 1.05 * rim, armpit.at + 0.01, joint[2], &seam), MUS__STRAPS_OFF);
    ck_assert_int_ge(seam, 2);
    ck_assert_int_eq(lift_straps_at(&w, 1.05 * rim, armpit.at + 0.01, joint[2] + 0.08, NULL), MUS__STRAPS_OFF);
    worn_end(&w);
}
END_TEST


/* a short seam whose edges point up is a strap's above the shoulders (_i 0), a cuff's below the armpits (1) */
START_TEST(cuffs_are_no_straps)
{
    worn w = lift_body();
    double neck, height;
    const double rim = lift_rim(&w, &neck, &height);
    lift_put_on(&w, strap_top(w.context, rim, height + (_i == 1 ? -0.3 : 0.06)), NULL);
    ck_assert_int_eq(mus__sew_create(w.drape), MUS_OK);
    mus__seam_route_start(w.drape);
    ck_assert_int_eq(mus__seam_route_straps(w.drape, NULL) == MUS__STRAPS_NONE, _i > 0);
    worn_end(&w);
}
END_TEST


START_TEST(what_is_held_at_the_armpits_stays_under_the_arms)
{
    static const double corner[5][2] = {{-0.25, -0.2}, {0.25, -0.2}, {0.26, -0.02}, {0.0, 0.12}, {-0.26, -0.02}};
    worn w = lift_body();
    mus_pattern *pattern;
    mus__level_plane armpit;
    int32_t edge[2][16];
    double bust[3];
    ck_assert_int_eq(mus_body_landmark(w.body, MUS_LANDMARK_BUST, bust), MUS_OK);

    /* a strapless top that begins a hand below where it is held, wider than the shoulders */
    ck_assert_int_eq(mus_pattern_create(w.context, "strapless", &pattern), MUS_OK);
    lift_both(pattern, corner, 5, bust[1] - 0.06, edge);
    scene_sew(pattern, edge[0][1], edge[1][4], 0.0);
    scene_sew(pattern, edge[0][4], edge[1][1], 0.0);
    for (int32_t i = 0; i < 2; i++)
        for (int32_t e = 2; e < 4; e++)
            ck_assert_int_eq(mus_pattern_set_edge_hold(pattern, edge[i][e], MUS_HOLD_ARMPIT, 0.0), MUS_OK);
    lift_put_on(&w, pattern, NULL);
    lift_sew(&w);
    mus__scene_level(w.drape, MUS_HOLD_ARMPIT, 0, &armpit);
    for (int32_t settled = 0; settled < 2; settled++) {
        double low = INFINITY;
        for (int32_t p = 0; p < w.cloth->npair; p++) {
            const double *x = lift_pair_at(&w, p);
            ck_assert_double_lt(mus__dot3(armpit.up, x), armpit.at + 0.03);
            low = fmin(low, mus__dot3(armpit.up, x));
        }
        ck_assert_double_gt(low, armpit.at - 0.35);
        if (!settled) lift_settle(&w);
    }

    /* settled it is held there */
    const mus__program *program = &w.drape->program;
    for (int32_t h = 0; h < program->nattachment; h++) {
        ck_assert_double_eq(program->attachment[h].share, 1.0);
        ck_assert_double_gt(mus__dot3(armpit.up, w.drape->x + 3 * (int64_t)program->attachment[h].node),
                            armpit.at - 0.015);
    }
    worn_end(&w);
}
END_TEST


Suite *mus_suite_seam_route(void)
{
    Suite *suite = suite_create("seam_route");
    TCase *tests = tcase_create("seam_route");
    tcase_set_timeout(tests, 600);
    suite_add_tcase(suite, tests);
    tcase_add_loop_test(tests, cuffs_are_no_straps, 0, 2);
    tcase_add_loop_test(tests, straps_close_over_the_shoulders, 0, 2);
    tcase_add_test(tests, a_strap_before_the_arm_is_not_on_the_shoulder);
    tcase_add_test(tests, what_is_held_at_the_armpits_stays_under_the_arms);
    return suite;
}
