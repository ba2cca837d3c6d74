/*
 * test_movement.c: movements: through their keys, twice differentiable, symmetric walks, within the limits of joints.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "muslin/pose.h"
#include "support.h"

Suite *mus_suite_movement(void);

#define NUMBERS (3 + 3 * MUS_JOINT_COUNT)


/* place and angles of a pose as one row */
static void row_of(const mus_pose *pose, double *out)
{
    memcpy(out, pose->place, 3 * sizeof(double));
    memcpy(out + 3, pose->angle, 3 * MUS_JOINT_COUNT * sizeof(double));
}


static void row_at(const mus_move *move, double t, double *out)
{
    mus_pose pose;
    ck_assert_int_eq(mus_move_at(move, t, &pose), MUS_OK);
    row_of(&pose, out);
}


static mus_move *named(mus_context *context, const char *name)
{
    mus_move *move = NULL;
    const mus_status status = mus_move_named(context, name, 1.7, &move);
    ck_assert_msg(status == MUS_OK, "%s: %s", name, mus_context_error(context));
    return move;
}


/* small random angles and places at uneven times */
static mus_move *random_move(mus_context *context, uint64_t *seed, int32_t keys, double period, double *times,
                             mus_pose *poses)
{
    mus_move *move = NULL;
    double t = support_uniform(seed, -1.0, 1.0);
    for (int32_t i = 0; i < keys; i++) {
        times[i] = t;
        t += support_uniform(seed, 0.1, 0.4);
        mus_pose_init(&poses[i], sizeof poses[i]);
        for (int k = 0; k < 3; k++) poses[i].place[k] = support_uniform(seed, -1.0, 1.0);
        for (int k = 0; k < 3; k++) poses[i].angle[MUS_JOINT_ROOT][k] = support_uniform(seed, -0.5, 0.5);
    }
    const mus_status status = mus_move_create(context, keys, times, poses, period > 0.0 ? t - times[0] : 0.0, &move);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    return move;
}


START_TEST(a_movement_passes_through_its_keys)
{
    mus_context *context = support_context();
    uint64_t seed = 17;
    double times[9], at[NUMBERS], key[NUMBERS];
    mus_pose poses[9];
    for (int round = 0; round < 40; round++) {
        const int32_t keys = 3 + round % 7;
        mus_move *move = random_move(context, &seed, keys, round % 2, times, poses);
        for (int32_t i = 0; i < keys; i++) {
            row_of(&poses[i], key);
            for (int turn = 0; turn < 2; turn++) {
                row_at(move, times[i] + turn * mus_move_period(move), at);
                for (int k = 0; k < NUMBERS; k++) ck_assert_double_eq_tol(at[k], key[k], 1e-12);
            }
        }
        mus_move_destroy(move);
    }
    support_context_end(context);
}
END_TEST


/* value, velocity and acceleration from the left and from the right of where a period closes, by differences that are
 * exact for a cubic: second differences of three points h apart on one side */
START_TEST(a_period_closes_twice_differentiable)
{
    mus_context *context = support_context();
    uint64_t seed = 23;
    double times[8], side[2][4][NUMBERS];
    mus_pose poses[8];
    for (int round = 0; round < 20; round++) {
        mus_move *move = random_move(context, &seed, 3 + round % 6, 1.0, times, poses);
        const double h = 0.01;
        for (int s = 0; s < 2; s++)
            for (int i = 0; i < 4; i++)
                row_at(move, times[0] + (s == 0 ? -1.0 : 1.0) * i * h, side[s][i]);
        for (int k = 0; k < 6; k++) {
            double slope[2], bend[2];
            for (int s = 0; s < 2; s++) {
                const double y0 = side[s][0][k], y1 = side[s][1][k], y2 = side[s][2][k], y3 = side[s][3][k];
                slope[s] = (-11.0 * y0 + 18.0 * y1 - 9.0 * y2 + 2.0 * y3) / (6.0 * h) * (s == 0 ? -1.0 : 1.0);
                bend[s] = (2.0 * y0 - 5.0 * y1 + 4.0 * y2 - y3) / (h * h);
            }
            ck_assert_double_eq_tol(slope[0], slope[1], 1e-9 * (1.0 + fabs(slope[0])));
            ck_assert_double_eq_tol(bend[0], bend[1], 1e-8 * (1.0 + fabs(bend[0])));
        }
        mus_move_destroy(move);
    }
    support_context_end(context);
}
END_TEST


/* half a period later left and right are exchanged; sideways angles and place of the trunk change their sign */
START_TEST(a_walk_is_symmetric_half_a_period_apart)
{
    mus_context *context = support_context();
    mus_move *move = named(context, "walk");
    const double period = mus_move_period(move);
    for (int i = 0; i < 97; i++) {
        mus_pose a, b;
        ck_assert_int_eq(mus_move_at(move, period * i / 97.0, &a), MUS_OK);
        ck_assert_int_eq(mus_move_at(move, period * (i / 97.0 + 0.5), &b), MUS_OK);
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(a.place[k], k == 0 ? -b.place[k] : b.place[k], 1e-12);
            for (int32_t j = MUS_JOINT_ROOT; j <= MUS_JOINT_NECK; j++)
                ck_assert_double_eq_tol(a.angle[j][k], k == 0 ? b.angle[j][k] : -b.angle[j][k], 1e-12);
            for (int32_t j = MUS_JOINT_SHOULDER_LEFT; j < MUS_JOINT_COUNT; j += 2) {
                ck_assert_double_eq_tol(a.angle[j][k], b.angle[j + 1][k], 1e-12);
                ck_assert_double_eq_tol(a.angle[j + 1][k], b.angle[j][k], 1e-12);
            }
        }
    }
    mus_move_destroy(move);
    support_context_end(context);
}
END_TEST


/* no joint faster than 15 rad/s and no place faster than 2 m/s: a fault of a table jumps */
START_TEST(named_movements_are_smooth_and_within_limits)
{
    mus_context *context = support_context();
    ck_assert_int_ge(mus_move_count(), 6);
    ck_assert_ptr_null(mus_move_name(-1));
    ck_assert_ptr_null(mus_move_name(mus_move_count()));
    for (int32_t m = 0; m < mus_move_count(); m++) {
        mus_move *move = named(context, mus_move_name(m));
        const double duration = mus_move_duration(move), period = mus_move_period(move);
        ck_assert_double_gt(duration, 0.5);
        ck_assert(period == 0.0 || period == duration);
        double before[NUMBERS], now[NUMBERS];
        row_at(move, 0.0, before);
        for (int i = 1; i <= 1000; i++) {
            mus_pose pose;
            ck_assert_int_eq(mus_move_at(move, duration * i / 1000.0, &pose), MUS_OK);
            ck_assert_msg(mus_pose_check(context, &pose) == MUS_OK, "%s: %s", mus_move_name(m),
                          mus_context_error(context));
            row_of(&pose, now);
            for (int k = 0; k < NUMBERS; k++) {
                const double speed = fabs(now[k] - before[k]) * 1000.0 / duration;
                ck_assert_msg(speed < (k < 3 ? 2.0 : 15.0), "%s number %d at %g: %g", mus_move_name(m), k,
                              duration * i / 1000.0, speed);
            }
            memcpy(before, now, sizeof now);
        }

        /* it holds its ends, or repeats */
        double first[NUMBERS], after[NUMBERS];
        row_at(move, 0.0, first);
        row_at(move, duration + (period > 0.0 ? 0.0 : 5.0), after);
        row_at(move, duration, now);
        for (int k = 0; k < NUMBERS; k++) ck_assert_double_eq_tol(after[k], period > 0.0 ? first[k] : now[k], 1e-12);
        mus_move_destroy(move);
    }
    support_context_end(context);
}
END_TEST


/* arguments that are errors: the message names the fault, and no movement is made */
START_TEST(movements_that_cannot_be_are_refused)
{
    mus_context *context = support_context();
    mus_pose pose[3], out;
    mus_move *move = (mus_move *)&out;
    const double times[] = {0.0, 1.0, 2.0}, same[] = {0.0, 1.0, 1.0};
    for (int i = 0; i < 3; i++) mus_pose_init(&pose[i], sizeof pose[i]);
    ck_assert_int_eq(mus_move_create(context, 0, times, pose, 0.0, &move), MUS_ERR_ARG);
    ck_assert_ptr_null(move);
    ck_assert_int_eq(mus_move_create(context, 3, same, pose, 0.0, &move), MUS_ERR_ARG);
    ck_assert_int_eq(mus_move_create(context, 2, times, pose, 3.0, &move), MUS_ERR_ARG);
    ck_assert_int_eq(mus_move_create(context, 3, times, pose, 2.0, &move), MUS_ERR_ARG);
    ck_assert_int_eq(mus_move_create(context, 3, times, NULL, 0.0, &move), MUS_ERR_ARG);
    pose[1].angle[MUS_JOINT_KNEE_LEFT][MUS_POSE_FLEXION] = 3.0;
    ck_assert_int_eq(mus_move_create(context, 3, times, pose, 0.0, &move), MUS_ERR_BODY);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "knee_left flexion is 171.9 degrees"));
    ck_assert_int_eq(mus_move_named(context, "fly", 1.7, &move), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "fly"));
    ck_assert_int_eq(mus_move_at(NULL, 0.0, &out), MUS_ERR_ARG);
    ck_assert(isnan(mus_move_period(NULL)) && isnan(mus_move_duration(NULL)));
    mus_move_destroy(NULL);

    /* one key stands still */
    pose[0].place[1] = 0.25;
    ck_assert_int_eq(mus_move_create(context, 1, times, pose, 0.0, &move), MUS_OK);
    ck_assert_int_eq(mus_move_at(move, 7.0, &out), MUS_OK);
    ck_assert_double_eq(out.place[1], 0.25);
    mus_move_destroy(move);
    support_context_end(context);
}
END_TEST


START_TEST(a_movement_without_memory_leaves_nothing)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_move *move = NULL;
        support_fail_after(n, false);
        const mus_status status = mus_move_named(context, "walk", 1.7, &move);
        support_fail_never();
        ck_assert((status == MUS_OK) == (move != NULL));
        mus_move_destroy(move);
        support_context_end(context);
        if (status == MUS_OK) {
            ck_assert_int_ge(n, 5);
            break;
        }
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_movement(void)
{
    Suite *suite = suite_create("movement");
    TCase *tests = tcase_create("move");
    tcase_add_test(tests, a_movement_passes_through_its_keys);
    tcase_add_test(tests, a_period_closes_twice_differentiable);
    tcase_add_test(tests, a_walk_is_symmetric_half_a_period_apart);
    tcase_add_test(tests, named_movements_are_smooth_and_within_limits);
    tcase_add_test(tests, movements_that_cannot_be_are_refused);
    tcase_add_test(tests, a_movement_without_memory_leaves_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
