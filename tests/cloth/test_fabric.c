/*
 * test_fabric.c: named fabrics are in their ranges and say their source; constants of the lattice and of the strip
 * agree with each other and with the modulus they came from.
 */
#include "cut.h"

#include "cloth/fabric.h"


static void near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance, "%.17g, expected %.17g within %g", got, want, tolerance);
}


START_TEST(every_named_fabric_is_found_and_has_a_source)
{
    mus_context *context = support_context();
    const char *asked[] = {"jersey",     "cotton",   "denim",    "wool",    "silk",     "polyester",
                           "broadcloth", "tropical", "shirting", "denim_b", "pc_plain", "satin"};
    ck_assert_int_ge(mus_fabric_count(), 12);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++)
        ck_assert_int_eq(mus_fabric_find(asked[i], &fabric), MUS_OK);

    for (int32_t i = 0; i < mus_fabric_count(); i++) {
        ck_assert_int_eq(mus_fabric_find(mus_fabric_name(i), &fabric), MUS_OK);
        ck_assert_int_eq(mus_fabric_check(context, &fabric), MUS_OK);
        ck_assert_int_gt((int)strlen(mus_fabric_source(i)), 40);
        ck_assert_ptr_nonnull(strstr(mus_fabric_source(i), "assumed"));

        /* each value says its own, and the whole says them all */
        for (int32_t v = 0; v < mus_fabric_value_count(); v++) {
            ck_assert_int_ge((int)strlen(mus_fabric_value_source(i, v)), 7);
            ck_assert_ptr_nonnull(strstr(mus_fabric_source(i), mus_fabric_value_source(i, v)));
        }
        for (int32_t k = 0; k < i; k++) ck_assert_str_ne(mus_fabric_name(k), mus_fabric_name(i));

        /* the sizes of cloth, not of paper or steel */
        ck_assert(fabric.weight >= 0.05 && fabric.weight <= 0.5);
        ck_assert(fabric.shear >= 10.0 && fabric.shear <= 191.0);
        for (int k = 0; k < 3; k++) ck_assert(fabric.bend[k] >= 1e-6 && fabric.bend[k] <= 1.3e-4);
    }
    ck_assert_ptr_null(mus_fabric_name(-1));
    ck_assert_ptr_null(mus_fabric_name(mus_fabric_count()));
    ck_assert_ptr_null(mus_fabric_source(mus_fabric_count()));
    ck_assert_ptr_null(mus_fabric_value_source(0, -1));
    ck_assert_ptr_null(mus_fabric_value_source(0, 12));
    ck_assert_ptr_null(mus_fabric_value_source(mus_fabric_count(), 0));
    support_context_end(context);
}
END_TEST


START_TEST(measured_rows_are_their_conversions)
{
    /* KES-F (Kawabata 1980): 490.33 N/m over EMT; denim A 5.5 %, control cotton 2.29 % */
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_fabric_find("denim", &fabric);
    near(fabric.stretch[0], 490.33 / 0.055, 1.0);
    near(fabric.shear, 122.0, 0.0);
    near(fabric.bend[0], 16.9e-6, 0.0);
    mus_fabric_find("cotton", &fabric);
    near(fabric.stretch[1], 490.33 / 0.0229, 1.0);
    mus_fabric_find("wool", &fabric);
    near(fabric.stretch[0], 490.33 / 0.047, 1.0);
    near(fabric.stretch[1], 490.33 / 0.1275, 1.0);
    mus_fabric_find("stretch_twill", &fabric);
    near(fabric.stretch[0], 490.33 / 0.0173, 1.0);
    near(fabric.stretch[1], 490.33 / 0.1118, 1.0);

    /* J. Textiles 2016, 4614168, table 5, in its own units: EMT, B, G, thickness */
    static const double table[5][4] = {{5.735, 0.144, 1.538, 1.188}, {4.695, 0.227, 3.398, 0.801},
                                       {5.135, 0.147, 1.613, 1.040}, {4.710, 0.207, 1.538, 0.887},
                                       {5.455, 0.148, 1.500, 0.973}};
    for (int k = 0; k < 5; k++) {
        const char name[] = {'d', 'e', 'n', 'i', 'm', '_', (char)('b' + k), '\0'};
        ck_assert_int_eq(mus_fabric_find(name, &fabric), MUS_OK);
        near(fabric.stretch[0], 490.33 / (0.01 * table[k][0]), 1.0);
        near(fabric.bend[0], 9.80665e-5 * table[k][1], 0.05e-6);
        near(fabric.shear, 56.188 * table[k][2], 0.05);
        near(fabric.thickness, 1e-3 * table[k][3], 1e-9);
    }

    /* bending lengths of the fabrics that were fitted to a drape coefficient: 43, 77, 80, 80 % is 1.5 to 2.9 cm */
    static const char *const fitted[] = {"satin", "pc_panama", "pc_twill", "pc_plain"};
    static const double length[] = {0.01535, 0.0278, 0.0286, 0.0288};
    for (int k = 0; k < 4; k++) {
        mus_fabric_find(fitted[k], &fabric);
        near(cbrt(fabric.bend[0] / (fabric.weight * 9.81)), length[k], 2e-4);
    }
}
END_TEST


START_TEST(a_fabric_of_the_release_before_is_taken)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    double loop = -1.0;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.size = MUS__FABRIC_FIRST;
    fabric.bend_hysteresis = 123.0; /* beyond the struct of that release */
    ck_assert_int_eq(mus_fabric_find("broadcloth", &fabric), MUS_OK);
    ck_assert_double_eq(fabric.bend_hysteresis, 123.0);
    ck_assert_int_eq((int)fabric.size, (int)MUS__FABRIC_FIRST);
    ck_assert_int_eq(mus_fabric_check(context, &fabric), MUS_OK);
    ck_assert_int_eq(mus_fabric_get(&fabric, mus_fabric_value_count() - 1, &loop), MUS_OK);
    ck_assert_double_eq(loop, 0.0);
    ck_assert_int_eq(mus_fabric_set(context, &fabric, mus_fabric_value_count() - 1, 0.0), MUS_OK);
    ck_assert_int_eq(mus_fabric_set(context, &fabric, mus_fabric_value_count() - 1, 1e-3), MUS_ERR_VERSION);
    ck_assert_double_eq(fabric.bend_hysteresis, 123.0);

    mus_cloth_def def;
    mus_cloth *cloth;
    const double cell[2] = {0.01, 0.01};
    mus_cloth_def_init(&def, sizeof def);
    def.fabric = &fabric;
    ck_assert_int_eq(mus_cloth_create_grid(context, 3, 3, cell, &def, &cloth), MUS_OK);
    ck_assert_double_eq(cloth->bend_slide, 0.0);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


START_TEST(friction_of_bending_stands_for_half_of_the_loop)
{
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    ck_assert_double_eq(mus__fabric_slide(&fabric), 0.0);
    mus_fabric_find("broadcloth", &fabric);
    near(fabric.bend_hysteresis, 9.80665e-3 * 0.124, 1e-6); /* Matsudaira et al. 2015, table 1, gf cm/cm */
    const double before = fabric.bend[0], share = mus__fabric_slide(&fabric);

    /* isotropic: alpha = beta = 2/3 B, and with all sliders slipping r K (alpha + beta) = HB */
    const double ratio = share / (1.0 - share);
    near(fabric.bend[0], before * (1.0 + ratio), 1e-12);
    near(ratio * MUS__SLIDE_CURVATURE * before * 4.0 / 3.0, 0.5 * fabric.bend_hysteresis, 1e-9);
    for (int k = 0; k < 3; k++) fabric.bend[k] = 0.0;
    ck_assert_double_eq(mus__fabric_slide(&fabric), 0.0);
}
END_TEST


START_TEST(the_default_is_jersey_without_friction_of_bending)
{
    mus_fabric fabric, jersey;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_fabric_init(&jersey, sizeof jersey);
    mus_fabric_find("wool", &jersey);
    ck_assert_int_ne(memcmp(&fabric, &jersey, sizeof fabric), 0);
    mus_fabric_find("jersey", &jersey);
    ck_assert_double_eq(fabric.bend_hysteresis, 0.0);
    ck_assert_double_gt(jersey.bend_hysteresis, 0.0);
    jersey.bend_hysteresis = 0.0;
    ck_assert_int_eq(memcmp(&fabric, &jersey, sizeof fabric), 0);
    ck_assert_int_eq(mus_fabric_find("tweed", &fabric), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_find(NULL, &fabric), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_find("wool", NULL), MUS_ERR_ARG);
    fabric.size = 8;
    ck_assert_int_eq(mus_fabric_find("wool", &fabric), MUS_ERR_VERSION);
    mus_fabric_init(NULL, sizeof fabric);
}
END_TEST


START_TEST(values_outside_their_range_are_named)
{
    mus_context *context = support_context();
    mus_fabric good, bad;
    mus_fabric_init(&good, sizeof good);
    double *field[] = {&bad.weight,  &bad.stretch[0], &bad.stretch[1], &bad.shear,
                       &bad.bend[0], &bad.bend[1],    &bad.bend[2],    &bad.damping,
                       &bad.friction, &bad.thickness, &bad.bend_hysteresis, &bad.contraction};
    const char *name[] = {"weight",    "warp stretch", "weft stretch", "shear",    "warp bend",
                          "weft bend", "bias bend",    "damping",      "friction", "thickness",
                          "bend hysteresis", "contraction"};
    const double wrong[] = {-1.0, 1e30, (double)NAN, (double)INFINITY};
    for (int i = 0; i < 12; i++)
        for (int k = 0; k < 4; k++) {
            bad = good;
            *field[i] = wrong[k];
            ck_assert_int_eq(mus_fabric_check(context, &bad), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), name[i]));
        }
    support_context_end(context);
}
END_TEST


START_TEST(values_are_read_and_set_one_by_one)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    const double *field[] = {&fabric.weight,  &fabric.stretch[0], &fabric.stretch[1], &fabric.shear,
                             &fabric.bend[0], &fabric.bend[1],    &fabric.bend[2],    &fabric.damping,
                             &fabric.friction, &fabric.thickness,  &fabric.bend_hysteresis, &fabric.contraction};
    ck_assert_int_eq(mus_fabric_value_count(), 12);
    for (int32_t v = 0; v < 12; v++) {
        double got = NAN;
        ck_assert_int_eq(mus_fabric_set(context, &fabric, v, 0.01 + 0.001 * v), MUS_OK);
        ck_assert_double_eq(*field[v], 0.01 + 0.001 * v);
        ck_assert_int_eq(mus_fabric_get(&fabric, v, &got), MUS_OK);
        ck_assert_double_eq(got, *field[v]);
        ck_assert_int_eq(mus_fabric_set(context, &fabric, v, -1.0), MUS_ERR_ARG);
        ck_assert_double_eq(got, *field[v]);
        for (int32_t k = 0; k < v; k++) ck_assert_str_ne(mus_fabric_value_key(k), mus_fabric_value_key(v));
    }
    double got;
    ck_assert_ptr_null(mus_fabric_value_key(-1));
    ck_assert_ptr_null(mus_fabric_value_key(12));
    ck_assert_int_eq(mus_fabric_get(&fabric, 12, &got), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_get(NULL, 0, &got), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_set(context, &fabric, -1, 1.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_set(context, NULL, 0, 1.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_check(context, NULL), MUS_ERR_ARG);
    fabric.size = 3;
    ck_assert_int_eq(mus_fabric_get(&fabric, 0, &got), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_fabric_set(context, &fabric, 0, 1.0), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_fabric_check(context, &fabric), MUS_ERR_VERSION);
    support_context_end(context);
}
END_TEST


START_TEST(half_a_cell_as_a_triangle_has_the_springs_of_half_a_cell)
{
    /* k = C area / length^2 on the legs of the triangle is half of the lattice's, on the long side one diagonal's,
     * which stands for its own half of the two */
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    for (int32_t i = 0; i < mus_fabric_count(); i++) {
        mus_fabric_find(mus_fabric_name(i), &fabric);
        mus__fabric_lattice lattice;
        mus__fabric_on_lattice(&fabric, 0.01, &lattice);
        near(0.5 * mus__fabric_stretch(&fabric, 0.0, 1.0), 0.5 * lattice.k[0], 1e-9 * lattice.k[0]);
        near(0.5 * mus__fabric_stretch(&fabric, 1.0, 0.0), 0.5 * lattice.k[1], 1e-9 * lattice.k[1]);
        near(0.25 * mus__fabric_stretch(&fabric, sqrt(0.5), sqrt(0.5)), lattice.shear, 1e-9 * lattice.shear);

        /* between them no direction is stiffer than the stiffest line */
        for (double angle = 0.0; angle < 3.2; angle += 0.01) {
            double stiff = mus__fabric_stretch(&fabric, cos(angle), sin(angle));
            ck_assert(stiff > 0.0 &&
                      stiff <= fmax(fmax(lattice.k[0], lattice.k[1]), 4.0 * lattice.shear) * (1 + 1e-12));
        }
    }
}
END_TEST


START_TEST(what_a_lattice_cannot_be_is_clamped)
{
    mus__fabric_lattice lattice;
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);

    /* sheared harder than stretched: a tenth of the stretch is left */
    fabric.stretch[0] = 50.0, fabric.shear = 100.0;
    mus__fabric_on_lattice(&fabric, 0.01, &lattice);
    near(lattice.k[0], 5.0, 1e-12);
    ck_assert(mus__fabric_stretch(&fabric, 0.3, 0.9) > 0.0);

    /* beam of weave (bias rigidity): beta = (4 bias - warp - weft) / 3, alpha = B - beta / 2; both at least 0 */
    const double bend[3] = {4e-6, 2e-6, 3e-6}, soft[3] = {4e-6, 2e-6, 1e-6}, hard[3] = {2e-6, 2e-6, 9e-6};
    memcpy(fabric.bend, bend, sizeof bend);
    mus__fabric_on_lattice(&fabric, 0.01, &lattice);
    near(lattice.cross, 2e-6 / 4e-4, 1e-15);
    near(lattice.bend[0], 3e-6 / 1e-4, 1e-15);
    near(lattice.bend[1], 1e-6 / 1e-4, 1e-15);
    memcpy(fabric.bend, soft, sizeof soft);
    mus__fabric_on_lattice(&fabric, 0.01, &lattice);
    near(lattice.cross, 0.0, 0.0);
    near(lattice.bend[0], 4e-6 / 1e-4, 1e-15);
    memcpy(fabric.bend, hard, sizeof hard);
    mus__fabric_on_lattice(&fabric, 0.01, &lattice);
    near(lattice.bend[0], 0.0, 0.0);
    near(mus__fabric_bend(&fabric, sqrt(0.5), sqrt(0.5)), 9e-6, 1e-18);
    near(mus__fabric_bend(&fabric, 1.0, 0.0), 2e-6, 1e-18);
}
END_TEST


Suite *mus_suite_fabric(void);
Suite *mus_suite_fabric(void)
{
    Suite *suite = suite_create("fabric");
    TCase *tests = tcase_create("fabric");
    tcase_add_test(tests, every_named_fabric_is_found_and_has_a_source);
    tcase_add_test(tests, measured_rows_are_their_conversions);
    tcase_add_test(tests, friction_of_bending_stands_for_half_of_the_loop);
    tcase_add_test(tests, the_default_is_jersey_without_friction_of_bending);
    tcase_add_test(tests, values_outside_their_range_are_named);
    tcase_add_test(tests, values_are_read_and_set_one_by_one);
    tcase_add_test(tests, a_fabric_of_the_release_before_is_taken);
    tcase_add_test(tests, half_a_cell_as_a_triangle_has_the_springs_of_half_a_cell);
    tcase_add_test(tests, what_a_lattice_cannot_be_is_clamped);
    suite_add_tcase(suite, tests);
    return suite;
}
