/* test_refused_manifold.c: numbers that are not finite at the doors of a manifold: refused by name. */
#include "muslin/manifold.h"
#include "refused.h"

Suite *mus_suite_refused_manifold(void);


static mus_status try_manifold(mus_context *context, const void *def, void *user)
{
    (void)user;
    const double contour[2][6] = {{-0.02, 0.0, 0.0, 0.05, 0.05, 2.0}, {0.02, 0.0, 0.0, 0.05, 0.05, 2.0}};
    mus_body *body = NULL;
    mus_manifold *manifold = NULL;
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    limb.contours = 2, limb.contour = &contour[0][0];
    limb.pole[0] = -0.06, limb.pole[1] = 0.06;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    const mus_status status = mus_manifold_create(body, def, &manifold);
    ck_assert_int_eq(status == MUS_OK, manifold != NULL);
    mus_manifold_destroy(manifold);
    mus_body_destroy(body);
    return status;
}


START_TEST(a_manifold_def_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {REFUSED(mus_manifold_def, spacing, 1, false, "spacing")};
    mus_manifold_def def;
    mus_manifold_def_init(&def, sizeof def);
    def.spacing = 0.02;
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_manifold, NULL);
    mus_context *context = support_context();
    def.threads = 65;
    ck_assert_int_eq(try_manifold(context, &def, NULL), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "threads 65"));
    def.size = 3;
    ck_assert_int_eq(try_manifold(context, &def, NULL), MUS_ERR_VERSION);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_manifold(void)
{
    Suite *suite = suite_create("refused_manifold");
    TCase *tests = tcase_create("refused_manifold");
    tcase_add_test(tests, a_manifold_def_that_is_not_finite_is_refused_by_name);
    suite_add_tcase(suite, tests);
    return suite;
}
