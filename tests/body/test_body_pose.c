/* test_body_pose.c: posed copies: the rest pose is the body, girths stay, joints go where a chain by hand puts them. */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"
#include "people.h"

Suite *mus_suite_body_pose(void);

#define DEGREE (MUS_PI / 180.0)


static mus_body *posed(const mus_body *body, const mus_pose *pose)
{
    mus_body *out = NULL;
    const mus_status status = mus_body_pose(body, pose, &out);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(body->context));
    return out;
}




START_TEST(the_rest_pose_is_the_body)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    mus_pose rest, stance;
    ck_assert_int_eq(mus_body_rest_pose(body, &rest), MUS_OK);
    mus_body *copy = posed(body, &rest);
    ck_assert_int_eq(copy->vertex_count, body->vertex_count);
    for (int32_t i = 0; i < 3 * body->vertex_count; i++) {
        ck_assert_double_eq_tol(copy->vertices[i], body->vertices[i], 1e-15);
        ck_assert_double_eq_tol(copy->normals[i], body->normals[i], 1e-12);
    }
    ck_assert_int_eq(memcmp(copy->triangles, body->triangles, 3 * sizeof(int32_t) * (size_t)body->triangle_count), 0);
    for (int32_t p = 0; p < body->nfield; p++)
        for (int i = 0; i < 3; i++) {
            ck_assert_double_eq_tol(copy->field[p].origin[i], body->field[p].origin[i], 1e-15);
            ck_assert_double_eq_tol(copy->field[p].axis[i], body->field[p].axis[i], 1e-15);
        }
    ck_assert_int_eq(mus_body_stance(copy, &stance), MUS_OK);
    ck_assert_int_eq(memcmp(&stance, &rest, sizeof rest), 0);
    ck_assert_double_eq_tol(mus_body_volume(copy), mus_body_volume(body), 1e-12);
    mus_body_destroy(copy);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_body_pose(void)
{
    Suite *suite = suite_create("body_pose");
    TCase *tests = tcase_create("body_pose");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, the_rest_pose_is_the_body);
    suite_add_tcase(suite, tests);
    return suite;
}
