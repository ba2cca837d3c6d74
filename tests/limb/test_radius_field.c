/*
 * test_radius_field.c: depth by the contact field against the surface it stands for, against exact solids, and against
 * the winding number of the triangles.
 */
#include "body/body_make.h"
#include "body/people.h"
#include "geom/vec.h"

#define ANGLES 128

static double turn[2 * ANGLES];


/* a limb of circles on a slanting axis, right-handed */
static void circles(mus__limb *limb, int32_t n, const double *s, const double *r)
{
    memset(limb, 0, sizeof *limb);
    limb->name = "limb";
    limb->count = n;
    const double axis[3] = {0.6, 0.0, 0.8}, side[3] = {0.8, 0.0, -0.6}, front[3] = {0.0, 1.0, 0.0};
    memcpy(limb->axis, axis, sizeof axis);
    memcpy(limb->side, side, sizeof side);
    memcpy(limb->front, front, sizeof front);
    for (int32_t i = 0; i < n; i++)
        limb->contour[i] = (mus__contour){
            .name = "ring", .girth = MUS_NONE, .height = MUS_NONE, .s = s[i], .a = r[i], .b = r[i], .n = 2.0};
    limb->pole[0] = s[0] - 0.05, limb->pole[1] = s[n - 1] + 0.05;
}


static void make_field(mus_context *context, const mus__limb *limb, double spacing, mus__field *field)
{
    mus__stack stack;
    mus__field_turns(ANGLES, turn);
    ck_assert_int_eq(mus__stack_make(context, limb, ANGLES, turn, &stack), MUS_OK);
    mus__part whole = {.end = {limb->contour[0].s, limb->contour[limb->count - 1].s}};
    ck_assert_int_eq(mus__field_make(context, &stack, &whole, spacing, field), MUS_OK);
    mus__stack_free(context, &stack);
}


/* depth of x in the union of the parts of a limb */
static double limb_depth(const mus_body *body, int32_t l, const double *x, double *normal)
{
    double most = -2e30, here[3];
    for (int32_t p = 0; p < body->nfield; p++) {
        if (body->rig.part[p].limb != l) continue;
        double depth = mus__field_depth(&body->field[p], x, here);
        if (depth <= most) continue;
        most = depth;
        memcpy(normal, here, sizeof here);
    }
    return most;
}


START_TEST(diamond_turns_go_round_evenly)
{
    mus__field_turns(ANGLES, turn);
    for (int32_t k = 0; k < ANGLES; k++) {
        double c = turn[2 * k], s = turn[2 * k + 1], q = fabs(s) / (fabs(c) + fabs(s));
        ck_assert_double_eq_tol(c * c + s * s, 1.0, 1e-15);
        int32_t quarter = k / (ANGLES / 4);
        double expect = 4.0 * k / ANGLES - quarter;
        ck_assert_double_eq_tol(quarter % 2 == 0 ? q : 1.0 - q, expect, 1e-14);
        ck_assert_double_gt(c * turn[2 * ((k + 1) % ANGLES) + 1] - s * turn[2 * ((k + 1) % ANGLES)], 0.0);
    }
}
END_TEST


START_TEST(a_cone_has_its_exact_depth_and_normal)
{
    mus_context *context = support_context();
    const double s[] = {0.0, 0.4}, r[] = {0.12, 0.08};
    mus__limb limb;
    mus__field field;
    circles(&limb, 2, s, r);
    make_field(context, &limb, 0.005, &field);
    uint64_t seed = 3;
    double slope = -0.1, scale = 1.0 / sqrt(1.0 + slope * slope), worst = 0.0;
    for (int i = 0; i < 20000; i++) {
        double t = support_uniform(&seed, 0.0, 2.0 * MUS_PI), along = support_uniform(&seed, 0.01, 0.39);
        double rho = 0.12 + slope * along + support_uniform(&seed, -0.01, 0.01), p[3], normal[3];
        for (int k = 0; k < 3; k++)
            p[k] = along * limb.axis[k] + rho * (cos(t) * limb.side[k] + sin(t) * limb.front[k]);
        double exact = (0.12 + slope * along - rho) * scale, depth = mus__field_depth(&field, p, normal);
        worst = fmax(worst, fabs(depth - exact));
        double outward[3];
        for (int k = 0; k < 3; k++)
            outward[k] = scale * (cos(t) * limb.side[k] + sin(t) * limb.front[k] - slope * limb.axis[k]);
        ck_assert_double_gt(mus__dot3(normal, outward), 0.999);
        ck_assert_double_eq_tol(mus__norm3(normal), 1.0, 1e-6);
    }
    ck_assert_double_lt(worst, 6e-5);
    mus__field_free(context, &field);
    support_context_end(context);
}
END_TEST


/* whether a fillet or a detail changed a ring of a field, or one beside it */
static bool is_fine(const mus__field *field, int32_t ring)
{
    return ring >= field->fine[0] - 1 && ring <= field->fine[1] + 1;
}


START_TEST(depth_is_continuous_across_rings_and_round_the_angle)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    uint64_t seed = 5;
    for (int32_t l = 0; l < body->nfield; l++) {
        const mus__field *f = &body->field[l];
        for (int i = 0; i < 4000; i++) {
            /* a short step through a ring plane, and through the direction where the angle wraps */
            int32_t ring = 8 + (int32_t)(support_random(&seed) % (uint64_t)(f->nring - 16));
            double at[2] = {f->centre[2 * ring], f->centre[2 * ring + 1]}, normal[3], depth[2];
            double t = i % 2 == 0 ? 0.0 : support_uniform(&seed, 0.0, 6.2), rho = support_uniform(&seed, 0.96, 1.04);
            rho *= f->radius[(ptrdiff_t)ring * f->nangle];
            for (int k = 0; k < 2; k++) {
                double e = (k - 0.5) * 2e-7, s = f->s0 + ring * f->ds + e, angle = t + e, p[3];
                for (int m = 0; m < 3; m++)
                    p[m] = f->origin[m] + s * f->axis[m] + (at[0] + rho * cos(angle)) * f->side[m] +
                           (at[1] + rho * sin(angle)) * f->front[m];
                depth[k] = mus__field_depth(f, p, normal);
            }
            /* the radius is continuous, its slope is not: the first-order distance may step by up to half of itself
             * where the limb is steep to its axis, and by more where a fillet ends */
            const double part = is_fine(f, ring) ? 2.5 : 0.5;
            ck_assert_msg(fabs(depth[1] - depth[0]) < 1e-6 + part * fabs(depth[0]), "limb %d: %g %g", (int)l, depth[0],
                          depth[1]);
            ck_assert((depth[0] > 1e-6) == (depth[1] > 1e-6) || fabs(depth[0]) < 2e-6);
        }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* whether a fillet or a detail changed limb l at s: its normals are then those of the union */
static bool near_fillet(const mus_body *body, int32_t l, double s)
{
    bool near = false;
    for (int32_t p = 0; p < body->nfield; p++) {
        const mus__field *f = &body->field[p];
        if (body->rig.part[p].limb == l) near |= is_fine(f, (int32_t)floor((s - f->s0) / f->ds));
    }
    return near;
}


/* the vertices of the surface a centimetre from the end contours and on lie on the field's surface of their own limb,
 * to 0.6 mm, which two parts differ by at the neck; where a limb is steep to its axis the field's linear blend is
 * coarser along it, so what counts is the distance */
START_TEST(the_surface_has_depth_zero)
{
    static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C56", "C116"};
    mus_context *context = support_context();
    for (int i = 0; i < 6; i++) {
        mus_body_def def;
        mus_body_def_init(&def, sizeof def);
        def.plain = 1; /* hands and feet are drawn whole */
        mus_body *body = people_body(context, sizes[i], &def);
        for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
            const mus__limb *limb = &body->limb[l];
            int32_t n = limb->samples, first = limb->contour[0].ring, last = limb->contour[limb->count - 1].ring;
            for (int32_t v = n * first; v < n * last; v++) {
                const double *x = body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1 + v);
                double s = -mus__dot3(limb->origin, limb->axis) + mus__dot3(x, limb->axis);
                if (s < limb->contour[0].s + 0.01 || s > limb->contour[limb->count - 1].s - 0.01) continue;
                double normal[3] = {0, 0, 0}, depth = limb_depth(body, l, x, normal);
                /* a leg has corners at its wall */
                double most = limb->wall_side != 0.0 && fabs(x[0]) < 0.015 ? 2e-3 : 6e-4;
                ck_assert_msg(fabs(depth) < most, "%s %s vertex %d (ring %d): %.3f mm", sizes[i], limb->name, (int)v,
                              (int)(v / n), 1e3 * depth);
                const double *smooth = body->normals + 3 * ((ptrdiff_t)limb->first_vertex + 1 + v);
                if (v / n > first && v / n < last && limb->wall_side == 0.0 && !near_fillet(body, l, s))
                    ck_assert_msg(mus__dot3(normal, smooth) > 0.9, "%s %s vertex %d: normals %.3f apart", sizes[i],
                                  limb->name, (int)v, mus__dot3(normal, smooth));
            }
        }
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


/* solid angle of the triangles of a limb from p over 4 pi: 1 inside, 0 outside (van Oosterom and Strackee 1983) */
static double winding(const mus_body *body, const mus__limb *limb, const double *p)
{
    double sum = 0.0;
    for (int32_t t = 0; t < limb->triangles; t++) {
        const int32_t *v = body->triangles + 3 * ((ptrdiff_t)limb->first_triangle + t);
        double r[3][3], length[3], cross[3];
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 3; k++) r[c][k] = body->vertices[3 * (ptrdiff_t)v[c] + k] - p[k];
            length[c] = mus__norm3(r[c]);
        }
        mus__cross3(r[1], r[2], cross);
        double below = length[0] * length[1] * length[2] + mus__dot3(r[0], r[1]) * length[2] +
                       mus__dot3(r[1], r[2]) * length[0] + mus__dot3(r[2], r[0]) * length[1];
        sum += 2.0 * atan2(mus__dot3(r[0], cross), below);
    }
    return sum / (4.0 * MUS_PI);
}


START_TEST(the_sign_of_depth_is_that_of_the_winding_number)
{
    mus_context *context = support_context();
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = 48, def.ring_spacing = 0.02, def.plain = 1;
    mus_body *body = people_body(context, "W44", &def);
    uint64_t seed = 17;
    int inside = 0, near = 0;
    for (int i = 0; i < 1500; i++) {
        /* half of the points in the box, half close to the surface */
        double p[3] = {support_uniform(&seed, -0.7, 0.7), support_uniform(&seed, 0.0, 1.7),
                       support_uniform(&seed, -0.2, 0.2)};
        if (i % 2 == 0) {
            int32_t v = (int32_t)(support_random(&seed) % (uint64_t)body->vertex_count);
            for (int k = 0; k < 3; k++)
                p[k] = body->vertices[3 * (ptrdiff_t)v + k] + support_uniform(&seed, -0.02, 0.02);
        }
        double depth, normal[3], wound = 0.0;
        ck_assert_int_eq(mus_body_depth(body, 1, p, &depth, normal), MUS_OK);
        for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) wound = fmax(wound, winding(body, &body->limb[l], p));
        inside += wound > 0.5;
        if (fabs(depth) < 0.0015)
            near++; /* the coarse mesh of this test is itself that far off */
        else
            ck_assert_msg((depth > 0.0) == (wound > 0.5), "at %.3f %.3f %.3f: depth %g, winding %g", p[0], p[1], p[2],
                          depth, wound);
    }
    ck_assert_int_gt(inside, 300);
    ck_assert_int_lt(near, 200);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(far_and_beyond_the_ends_is_out_of_reach)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M50", NULL);
    const double points[] = {0.0, 1.80, 0.0, 0.0, 2.5, 0.0, 0.0, -0.1, 0.0,
                             0.9, 1.5,  0.0, 5.0, 5.0, 5.0, 0.0, 1.2,  0.0};
    double depth[6], normal[18];
    ck_assert_int_eq(mus_body_depth(body, 6, points, depth, normal), MUS_OK);
    for (int i = 0; i < 5; i++) {
        ck_assert_double_lt(depth[i], 0.0);
        if (depth[i] <= -1e30) ck_assert(normal[3 * i] == 0.0 && normal[3 * i + 1] == 0.0 && normal[3 * i + 2] == 0.0);
    }
    ck_assert(depth[4] == -1e30);
    ck_assert_double_gt(depth[5], 0.0);
    ck_assert_int_eq(mus_body_depth(body, 6, points, depth, NULL), MUS_OK);
    ck_assert_int_eq(mus_body_depth(body, 0, NULL, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_body_depth(body, 1, NULL, depth, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_depth(body, -1, points, depth, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_depth(NULL, 1, points, depth, NULL), MUS_ERR_ARG);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_radius_field(void);
Suite *mus_suite_radius_field(void)
{
    Suite *suite = suite_create("radius_field");
    TCase *tests = tcase_create("field");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, diamond_turns_go_round_evenly);
    tcase_add_test(tests, a_cone_has_its_exact_depth_and_normal);
    tcase_add_test(tests, depth_is_continuous_across_rings_and_round_the_angle);
    tcase_add_test(tests, the_surface_has_depth_zero);
    tcase_add_test(tests, the_sign_of_depth_is_that_of_the_winding_number);
    tcase_add_test(tests, far_and_beyond_the_ends_is_out_of_reach);
    suite_add_tcase(suite, tests);
    return suite;
}
