/*
 * test_bytes.c: a drape holds the bytes that its man page says, to 1 %.
 */
#include "scenes.h"

Suite *mus_suite_bytes(void);


/* bytes that a drape of a square lattice holds */
static double bytes_of(int32_t side, int32_t precision, double damping)
{
    const double cell[2] = {0.01, 0.01};
    mus_context *context = support_context();
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    fabric.damping = damping;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    ck_assert_int_eq(mus_cloth_create_grid(context, side, side, cell, &cut, &cloth), MUS_OK);
    const size_t before = mus_context_bytes(context);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    const double bytes = (double)(mus_context_bytes(context) - before);
    mus_drape_destroy(drape);
    ck_assert_uint_eq(mus_context_bytes(context), before);
    mus_cloth_destroy(cloth);
    support_context_end(context);
    return bytes;
}


START_TEST(bytes_are_those_of_the_formula)
{
    const int32_t sides[] = {100, 173, 400}, precision = _i % 2 ? 64 : 32, dashpots = _i / 2;
    const double r = precision / 8;
    for (int k = 0; k < 3; k++) {
        const double n = (double)sides[k] * sides[k];
        const double formula = n * ((dashpots ? 32 : 29) * r + (dashpots ? 177 : 169)) + 1080.0 * sides[k] + 6500 * r;
        ck_assert_double_eq_tol(bytes_of(sides[k], precision, dashpots ? 0.02 : 0.0) / formula, 1.0, 0.01);
    }
}
END_TEST


Suite *mus_suite_bytes(void)
{
    Suite *suite = suite_create("bytes");
    TCase *tests = tcase_create("bytes");
    tcase_add_loop_test(tests, bytes_are_those_of_the_formula, 0, 4);
    suite_add_tcase(suite, tests);
    return suite;
}
