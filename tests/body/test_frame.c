/* test_frame.c: quaternions and matrices are one rotation; a frame and its opposite motion are the identity. */
#include "body/frame.h"
#include "geom/vec.h"
#include "support.h"

Suite *mus_suite_frame(void);


/* a random unit quaternion with w >= 0 */
static void random_quaternion(uint64_t *seed, double *q)
{
    q[0] = support_uniform(seed, 0.0, 1.0);
    for (int i = 1; i < 4; i++) q[i] = support_uniform(seed, -1.0, 1.0);
    mus__quaternion_normalise(q);
}


START_TEST(a_quaternion_survives_its_matrix)
{
    uint64_t seed = 5;
    for (int k = 0; k < 1000; k++) {
        double q[4], m[9], back[4];
        random_quaternion(&seed, q);
        if (k % 4 == 0) q[0] = 0.0, mus__quaternion_normalise(q); /* half a turn: w is 0 */
        mus__quaternion_matrix(q, m);
        mus__quaternion_of(m, back);
        const double sign = q[0] * back[0] + q[1] * back[1] + q[2] * back[2] + q[3] * back[3] < 0.0 ? -1.0 : 1.0;
        for (int i = 0; i < 4; i++) ck_assert_double_eq_tol(sign * back[i], q[i], 1e-14);
    }
}
END_TEST


START_TEST(products_of_quaternions_are_products_of_matrices)
{
    uint64_t seed = 6;
    for (int k = 0; k < 1000; k++) {
        double p[4], q[4], r[4], mp[9], mq[9], mr[9], product[9];
        random_quaternion(&seed, p);
        random_quaternion(&seed, q);
        mus__quaternion_product(p, q, r);
        mus__quaternion_matrix(p, mp);
        mus__quaternion_matrix(q, mq);
        mus__quaternion_matrix(r, mr);
        mus__matrix_product(mp, mq, product);
        for (int i = 0; i < 9; i++) ck_assert_double_eq_tol(mr[i], product[i], 1e-14);

        /* times its conjugate: no rotation */
        mus__quaternion_conjugate(p, q);
        mus__quaternion_product(p, q, r);
        for (int i = 0; i < 4; i++) ck_assert_double_eq_tol(r[i], i == 0 ? 1.0 : 0.0, 1e-14);
    }
}
END_TEST


START_TEST(a_frame_and_back_is_where_it_began)
{
    uint64_t seed = 7;
    for (int k = 0; k < 1000; k++) {
        double q[4], x[3], y[3];
        mus__frame frame;
        random_quaternion(&seed, q);
        mus__quaternion_matrix(q, frame.turn);
        for (int i = 0; i < 3; i++) {
            frame.place[i] = support_uniform(&seed, -2.0, 2.0);
            x[i] = support_uniform(&seed, -2.0, 2.0);
        }
        mus__frame_point(&frame, x, y);
        mus__frame_back(&frame, y, y);
        for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(y[i], x[i], 1e-14);

        /* a direction keeps its length, and comes back too */
        mus__frame_turn(&frame, x, y);
        ck_assert_double_eq_tol(mus__norm3(y), mus__norm3(x), 1e-14);
        mus__frame_turn_back(&frame, y, y);
        for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(y[i], x[i], 1e-14);
    }
}
END_TEST


Suite *mus_suite_frame(void)
{
    Suite *suite = suite_create("frame");
    TCase *tests = tcase_create("frame");
    tcase_add_test(tests, a_quaternion_survives_its_matrix);
    tcase_add_test(tests, products_of_quaternions_are_products_of_matrices);
    tcase_add_test(tests, a_frame_and_back_is_where_it_began);
    suite_add_tcase(suite, tests);
    return suite;
}
