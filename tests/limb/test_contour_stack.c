/* test_contour_stack.c: in-between contours: spline identities, overshoot, caps, contours that are too close. */
#include "body/body_make.h"
#include "body/people.h"
#include "geom/polygon.h"
#include "geom/vec.h"

#define N 64

static double turn[2 * N];


static void set_turns(void)
{
    mus__contour_turns(N, turn);
}


/* a limb of circles of radius r at s, poles 1 beyond the ends */
static void circles(mus__limb *limb, int32_t n, const double *s, const double *r)
{
    memset(limb, 0, sizeof *limb);
    limb->name = "limb";
    limb->count = n;
    limb->side[0] = 1.0, limb->front[2] = -1.0, limb->axis[1] = 1.0;
    for (int32_t i = 0; i < n; i++)
        limb->contour[i] = (mus__contour){.name = "ring",
                                          .girth = MUS_NONE,
                                          .height = MUS_NONE,
                                          .s = s[i],
                                          .a = r[i],
                                          .b = r[i],
                                          .n = 2.0,
                                          .hard = true};
    limb->pole[0] = s[0] - 1.0, limb->pole[1] = s[n - 1] + 1.0;
}


/* through (0,0), (1,1), (2,0) the natural spline has S(0.5) = 0.6875 (by hand); radii are 2 more */
START_TEST(radii_follow_the_natural_spline)
{
    set_turns();
    mus_context *context = support_context();
    const double s[] = {0.0, 1.0, 2.0}, r[] = {2.0, 3.0, 2.0};
    double centre[2], radius[N];
    mus__limb limb;
    mus__stack stack;
    circles(&limb, 3, s, r);
    limb.contour[1].ca = 1.0, limb.contour[1].cb = -1.0;
    ck_assert_int_eq(mus__stack_make(context, &limb, N, turn, &stack), MUS_OK);
    mus__stack_limit(&stack, &limb);
    for (int32_t i = 0; i < 3; i++) ck_assert(!limb.limited[i]);
    mus__stack_ring(&stack, 0.5, centre, radius);
    for (int32_t k = 0; k < N; k++) ck_assert_double_eq_tol(radius[k], 2.6875, 1e-14);
    ck_assert_double_eq_tol(centre[0], 0.6875, 1e-14);
    ck_assert_double_eq_tol(centre[1], -0.6875, 1e-14);

    /* exactly the contour at a contour */
    for (int32_t i = 0; i < 3; i++) {
        mus__stack_ring(&stack, s[i], centre, radius);
        for (int32_t k = 0; k < N; k++)
            ck_assert(radius[k] == mus__contour_radius(&limb.contour[i], turn[2 * k], turn[2 * k + 1]));
    }
    mus__stack_free(context, &stack);
    support_context_end(context);
}
END_TEST


START_TEST(a_cone_stays_a_cone)
{
    set_turns();
    mus_context *context = support_context();
    const double s[] = {0.0, 0.3, 1.7, 2.0}, r[] = {1.0, 1.15, 1.85, 2.0};
    double centre[2], radius[N];
    mus__limb limb;
    mus__stack stack;
    circles(&limb, 4, s, r);
    ck_assert_int_eq(mus__stack_make(context, &limb, N, turn, &stack), MUS_OK);
    for (double x = 0.0; x <= 2.0; x += 0.05) {
        mus__stack_ring(&stack, x, centre, radius);
        for (int32_t k = 0; k < N; k++) ck_assert_double_eq_tol(radius[k], 1.0 + 0.5 * x, 1e-13);
    }
    mus__stack_free(context, &stack);
    support_context_end(context);
}
END_TEST


START_TEST(a_jump_does_not_overshoot)
{
    set_turns();
    mus_context *context = support_context();
    const double s[] = {0.0, 1.0, 1.2, 2.2, 3.2}, r[] = {1.0, 1.0, 2.0, 2.0, 2.0};
    double centre[2], radius[N];
    mus__limb limb;
    mus__stack stack;
    circles(&limb, 5, s, r);
    ck_assert_int_eq(mus__stack_make(context, &limb, N, turn, &stack), MUS_OK);
    mus__stack_ring(&stack, 1.5, centre, radius);
    ck_assert_double_gt(radius[0], 2.06); /* the natural spline overshoots */
    mus__stack_limit(&stack, &limb);
    for (double x = 0.0; x <= 3.2; x += 0.01) {
        mus__stack_ring(&stack, x, centre, radius);
        ck_assert(radius[0] > 1.0 * 0.97 && radius[0] < 2.0 * 1.03);
    }
    mus__stack_free(context, &stack);
    support_context_end(context);
}
END_TEST


START_TEST(caps_close_smoothly_to_the_poles)
{
    set_turns();
    mus_context *context = support_context();
    const double s[] = {0.0, 1.0}, r[] = {1.0, 1.0};
    double centre[2], radius[N];
    mus__limb limb;
    mus__stack stack;
    circles(&limb, 2, s, r);
    ck_assert_int_eq(mus__stack_make(context, &limb, N, turn, &stack), MUS_OK);

    /* the cap of a cylinder whose length is the radius is half a sphere */
    for (double x = 0.0; x <= 1.0; x += 0.1) {
        mus__stack_ring(&stack, 1.0 + x, centre, radius);
        ck_assert_double_eq_tol(radius[5], sqrt(fmax(1.0 - x * x, 0.0)), 1e-7);
        mus__stack_ring(&stack, -x, centre, radius);
        ck_assert_double_eq_tol(radius[5], sqrt(fmax(1.0 - x * x, 0.0)), 1e-7);
    }
    mus__stack_free(context, &stack);

    /* the cap of a cone continues the slope of the cone */
    limb.contour[1].a = limb.contour[1].b = 0.8;
    ck_assert_int_eq(mus__stack_make(context, &limb, N, turn, &stack), MUS_OK);
    mus__stack_ring(&stack, 1.0 + 1e-6, centre, radius);
    ck_assert_double_eq_tol((radius[0] - 0.8) / 1e-6, -0.2, 1e-5);
    mus__stack_ring(&stack, 2.0, centre, radius);
    ck_assert_double_eq_tol(radius[0], 0.0, 1e-7);
    mus__stack_free(context, &stack);
    support_context_end(context);
}
END_TEST


START_TEST(soft_contours_give_way_and_hard_ones_are_named)
{
    mus_context *context = support_context();
    const double s[] = {0.0, 0.50, 0.505, 1.0}, r[] = {1.0, 1.0, 1.0, 1.0};
    mus__limb limb;
    circles(&limb, 4, s, r);
    limb.contour[2].hard = false;
    ck_assert_int_eq(mus__limb_check(context, &limb, 0.01), MUS_OK);
    ck_assert_int_eq(limb.count, 3);
    ck_assert(limb.contour[1].s == 0.50);

    circles(&limb, 4, s, r);
    limb.contour[1].name = "waist", limb.contour[1].height = MUS_MEASURE_WAIST_HEIGHT;
    limb.contour[2].name = "bust", limb.contour[2].height = MUS_MEASURE_BUST_HEIGHT;
    ck_assert_int_eq(mus__limb_check(context, &limb, 0.01), MUS_ERR_BODY);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "waist_height"));
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "bust_height"));
    support_context_end(context);
}
END_TEST


static double ring_girth(const mus_body *body, const mus__limb *limb, int32_t ring)
{
    double xy[2 * 128];
    const int32_t n = limb->samples;
    const double *x = body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1 + (ptrdiff_t)ring * n);
    for (int32_t k = 0; k < n; k++) {
        xy[2 * k] = mus__dot3(x + 3 * (ptrdiff_t)k, limb->side);
        xy[2 * k + 1] = mus__dot3(x + 3 * (ptrdiff_t)k, limb->front);
    }
    return mus__polygon_perimeter(n, xy);
}


/* whether a fillet or a detail changed limb l between two places */
static bool fillet_within(const mus_body *body, int32_t l, double low, double high)
{
    bool within = false;
    for (int32_t p = 0; p < body->nfield; p++) {
        const mus__field *f = &body->field[p];
        if (body->rig.part[p].limb != l) continue;
        within |= f->s0 + f->fine[0] * f->ds < high && f->s0 + f->fine[1] * f->ds > low;
    }
    return within;
}


/* every in-between girth of every limb is within 3 % of the interval of its neighbours */
START_TEST(in_between_girths_keep_to_their_neighbours)
{
    mus_context *context = support_context();
    for (int32_t size = 0; size < mus_tape_size_count(); size++) {
        mus_body *body = people_body(context, mus_tape_size_name(size), NULL);
        ck_assert_int_eq(body->def.samples, 128);
        for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
            const mus__limb *limb = &body->limb[l];
            for (int32_t i = 0; i + 1 < limb->count; i++) {
                int32_t first = limb->contour[i].ring, last = limb->contour[i + 1].ring;
                if (fillet_within(body, l, limb->contour[i].s, limb->contour[i + 1].s)) continue;
                double a = ring_girth(body, limb, first), b = ring_girth(body, limb, last);
                for (int32_t ring = first; ring <= last; ring++) {
                    double g = ring_girth(body, limb, ring);
                    ck_assert_msg(g > 0.969 * fmin(a, b) && g < 1.031 * fmax(a, b), "%s %s above %s: %.4f, %.4f, %.4f",
                                  mus_tape_size_name(size), limb->name, limb->contour[i].name, a, g, b);
                }
            }
        }
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_contour_stack(void);
Suite *mus_suite_contour_stack(void)
{
    Suite *suite = suite_create("contour_stack");
    TCase *tests = tcase_create("contour_stack");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, radii_follow_the_natural_spline);
    tcase_add_test(tests, a_cone_stays_a_cone);
    tcase_add_test(tests, a_jump_does_not_overshoot);
    tcase_add_test(tests, caps_close_smoothly_to_the_poles);
    tcase_add_test(tests, soft_contours_give_way_and_hard_ones_are_named);
    tcase_add_test(tests, in_between_girths_keep_to_their_neighbours);
    suite_add_tcase(suite, tests);
    return suite;
}
