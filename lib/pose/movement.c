/*
 * movement.c: movements: poses at times (keys), with splines between them.
 *
 * Place and angles are 48 numbers, each on a cubic spline through its keys: natural for a movement that ends, periodic
 * for one that repeats; velocity and acceleration are continuous. A periodic movement is stored with its first key
 * repeated at the end. An angle that a spline carries past the limit of its joint is set to the limit.
 */
#include <math.h>
#include <string.h>

#include "geom/spline.h"
#include "pose/pose_table.h"

#define MOVE_NUMBERS (3 + 3 * MUS_JOINT_COUNT) /* place, then angles */
#define MOVE_KEYS_MOST 10000                   /* most keys of a movement; chosen: bounds the memory */

struct mus_move {
    mus_context *context;
    int32_t keys;   /* stored keys: the given ones, of a periodic movement and the first one again */
    double period;  /* [s], 0: not periodic */
    double *time;   /* (keys) [s] */
    double *value;  /* (MOVE_NUMBERS x keys) place, then angles */
    double *second; /* (MOVE_NUMBERS x keys) second derivatives */
};


/* check the arguments of mus_move_create() */
static mus_status move_check(mus_context *context, int32_t keys, const double *times, const mus_pose *poses,
                             double period)
{
    if (keys < 1 || keys > MOVE_KEYS_MOST || times == NULL || poses == NULL)
        return mus__fail(context, MUS_ERR_ARG, "%d keys of a movement, expected 1 to %d, with times and poses",
                         (int)keys, MOVE_KEYS_MOST);
    if (!(period >= 0.0 && period <= 1e6))
        return mus__fail(context, MUS_ERR_ARG, "the period of a movement is %g s, expected 0 to 1e6", period);
    for (int32_t i = 0; i < keys; i++) {
        if (!(fabs(times[i]) <= 1e6))
            return mus__fail(context, MUS_ERR_ARG, "time %d of a movement is %g s, expected -1e6 to 1e6", (int)i,
                             times[i]);
        if (i > 0 && !(times[i] > times[i - 1]))
            return mus__fail(context, MUS_ERR_ARG, "times of a movement: %g s at key %d is not after %g s", times[i],
                             (int)i, times[i - 1]);
        mus_status status = mus_pose_check(context, &poses[i]);
        if (status != MUS_OK) return status;
    }
    if (period > 0.0 && (keys < 3 || !(period > times[keys - 1] - times[0])))
        return mus__fail(context, MUS_ERR_ARG,
                         "%d keys over %g s in a period of %g s: expected at least 3 keys, over less than the period",
                         (int)keys, times[keys - 1] - times[0], period);
    return MUS_OK;
}


/* second derivatives of number k at its keys. Scratch: work (4 keys) */
static void move_spline(mus_move *move, int32_t k, double *work)
{
    const int32_t n = move->keys;
    const double *y = move->value + (ptrdiff_t)k * n;
    double *m = move->second + (ptrdiff_t)k * n;
    if (move->period > 0.0) {
        mus__spline_periodic(n - 1, move->time, move->time[n - 1] - move->time[n - 2], y, m, work);
        m[n - 1] = m[0];
    } else if (n > 1) {
        mus__spline_natural(n, move->time, y, m, work);
    }
}


/* times, values and second derivatives of a movement */
static void move_fill(mus_move *move, const double *times, const mus_pose *poses, double *work)
{
    const int32_t n = move->keys, given = move->period > 0.0 ? n - 1 : n;
    for (int32_t i = 0; i < n; i++) {
        const mus_pose *pose = &poses[i % given];
        move->time[i] = i < given ? times[i] : times[0] + move->period;
        for (int32_t k = 0; k < MOVE_NUMBERS; k++)
            move->value[(ptrdiff_t)k * n + i] = k < 3 ? pose->place[k] : pose->angle[(k - 3) / 3][(k - 3) % 3];
    }
    for (int32_t k = 0; k < MOVE_NUMBERS; k++) move_spline(move, k, work);
}


mus_status mus_move_create(mus_context *context, int32_t keys, const double *times, const mus_pose *poses,
                           double period, mus_move **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = move_check(context, keys, times, poses, period);
    if (status != MUS_OK) return status;

    mus_move *move = mus__new(context, 1, sizeof *move);
    if (move == NULL) return mus__fail_memory(context, "a movement");
    move->context = context;
    move->period = period;
    move->keys = period > 0.0 ? keys + 1 : keys;
    move->time = mus__new(context, move->keys, sizeof(double));
    move->value = mus__new(context, MOVE_NUMBERS * (int64_t)move->keys, sizeof(double));
    move->second = mus__new(context, MOVE_NUMBERS * (int64_t)move->keys, sizeof(double));
    double *work = mus__new(context, 4 * (int64_t)move->keys, sizeof(double));
    if (!move->time || !move->value || !move->second || !work) {
        mus__free(context, work);
        mus_move_destroy(move);
        return mus__fail_memory(context, "the keys of a movement");
    }
    move_fill(move, times, poses, work);
    mus__free(context, work);
    *out = move;
    return MUS_OK;
}


void mus_move_destroy(mus_move *move)
{
    if (move == NULL) return;
    mus__free(move->context, move->time);
    mus__free(move->context, move->value);
    mus__free(move->context, move->second);
    mus__free(move->context, move);
}


double mus_move_period(const mus_move *move)
{
    return move != NULL ? move->period : NAN;
}


double mus_move_duration(const mus_move *move)
{
    return move != NULL ? move->time[move->keys - 1] - move->time[0] : NAN;
}


mus_status mus_move_at(const mus_move *move, double t, mus_pose *pose)
{
    if (move == NULL) return MUS_ERR_ARG;
    if (!mus__finite(t) || pose == NULL)
        return mus__fail(move->context, MUS_ERR_ARG, "time %g s of a movement is not finite, or the pose is NULL", t);

    /* the time within the period, or clamped to the first and the last key */
    const int32_t n = move->keys;
    const double first = move->time[0], last = move->time[n - 1];
    if (move->period > 0.0) t -= floor((t - first) / move->period) * move->period;
    t = fmin(fmax(t, first), last);

    mus_pose_init(pose, sizeof *pose);
    for (int32_t k = 0; k < MOVE_NUMBERS; k++) {
        const double *y = move->value + (ptrdiff_t)k * n, *m = move->second + (ptrdiff_t)k * n;
        const double value = n > 1 ? mus__spline_at(n, move->time, y, m, t, NULL) : y[0];
        double low, high;
        if (k < 3) {
            pose->place[k] = value;
            continue;
        }
        mus_joint_limits((k - 3) / 3, (k - 3) % 3, &low, &high);
        pose->angle[(k - 3) / 3][(k - 3) % 3] = fmin(fmax(value, low), high);
    }
    return MUS_OK;
}


mus_status mus_move_named(mus_context *context, const char *name, double stature, mus_move **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (!(stature >= 0.2 && stature <= 3.0))
        return mus__fail(context, MUS_ERR_ARG, "stature %g m is outside 0.2 to 3 m", stature);
    int32_t move = mus__move_find(name);
    if (move == MUS_NONE)
        return mus__fail(context, MUS_ERR_ARG, "no movement is called \"%.60s\"", name != NULL ? name : "");
    double times[MUS__MOVE_KEYS], period;
    mus_pose poses[MUS__MOVE_KEYS];
    int32_t keys = mus__move_keys(move, stature, times, poses, &period);
    return mus_move_create(context, keys, times, poses, period, out);
}
