/* test_offset_surface.c: the offset surface of a body is made once for colliders that live together. */
#include "contact/collider.h"
#include "muslin/muslin.h"
#include "support.h"

Suite *mus_suite_offset_surface(void);


static mus_body *offset_body(mus_context *context)
{
    mus_tape *tape;
    mus_body *body;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    mus_tape_destroy(tape);
    return body;
}


static mus__collider *offset_collider(mus_context *context, const mus_body *body, double x, double offset)
{
    const double origin[3] = {x, 1.0, 0.0};
    mus__collider *collider;
    ck_assert_int_eq(mus__collider_create(context, body, origin, offset, &collider), MUS_OK);
    return collider;
}


/* wherever the origins of their states are; the depths are those of a collider that was made alone */
START_TEST(colliders_of_a_body_share_one_surface)
{
    static const double point[3] = {0.0, 1.2, 0.1};
    double normal[3], alone_normal[3];
    mus_context *context = support_context();
    mus_body *body = offset_body(context);
    mus__collider *alone = offset_collider(context, body, 0.25, 0.002);
    const double depth = mus__collider_depth(alone, point, 0.2, alone_normal);
    mus__collider_destroy(alone);

    mus__collider *one = offset_collider(context, body, 0.0, 0.002);
    const size_t bytes = mus_context_bytes(context);
    mus__collider *two = offset_collider(context, body, 0.25, 0.002);
    ck_assert_ptr_eq(one->surface, two->surface);
    ck_assert_uint_lt(mus_context_bytes(context) - bytes, 100000);
    ck_assert_double_eq(mus__collider_depth(two, point, 0.2, normal), depth);
    ck_assert_mem_eq(normal, alone_normal, sizeof normal);
    mus__collider_destroy(one);
    ck_assert_double_eq(mus__collider_depth(two, point, 0.2, normal), depth);
    mus__collider_destroy(two);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(posed_copies_share_it_and_other_offsets_do_not)
{
    mus_context *context = support_context();
    mus_body *body = offset_body(context), *posed;
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    ck_assert_int_eq(mus_body_pose(body, &pose, &posed), MUS_OK);
    mus__collider *one = offset_collider(context, body, 0.0, 0.002);
    mus__collider *two = offset_collider(context, posed, 0.0, 0.002);
    mus__collider *wide = offset_collider(context, body, 0.0, 0.004);
    ck_assert_ptr_eq(one->surface, two->surface);
    ck_assert_ptr_ne(one->surface, wide->surface);
    mus__collider_destroy(wide);
    mus__collider *again = offset_collider(context, posed, 0.0, 0.002);
    ck_assert_ptr_ne(again->surface, NULL);
    mus__collider_destroy(again);
    mus__collider_destroy(one);
    mus__collider_destroy(two);
    mus_body_destroy(posed);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* bodies may go first; a body of another context is read, not written */
START_TEST(the_last_user_takes_it_away)
{
    mus_context *context = support_context(), *other = support_context();
    mus_body *body = offset_body(context);
    const size_t bytes = mus_context_bytes(context);
    mus__collider *one = offset_collider(context, body, 0.0, 0.002);
    mus__collider *far = offset_collider(other, body, 0.0, 0.002);
    ck_assert_ptr_ne(one->surface, far->surface);
    mus__collider_destroy(one);
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    one = offset_collider(context, body, 0.0, 0.002);
    mus_body_destroy(body);
    mus__collider_destroy(one);
    mus__collider_destroy(far);
    support_context_end(context);
    support_context_end(other);
}
END_TEST


Suite *mus_suite_offset_surface(void)
{
    Suite *suite = suite_create("offset_surface");
    TCase *tests = tcase_create("offset_surface");
    tcase_add_test(tests, colliders_of_a_body_share_one_surface);
    tcase_add_test(tests, posed_copies_share_it_and_other_offsets_do_not);
    tcase_add_test(tests, the_last_user_takes_it_away);
    suite_add_tcase(suite, tests);
    return suite;
}
