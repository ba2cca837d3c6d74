/*
 * movement_table.c: the keys of the named movements.
 *
 * The walk stays in place, as on a treadmill. A leg follows the normative curves of hip, knee and ankle over the cycle
 * from heel strike; the other leg does the same half a period later. Normative hip angles refer to a pelvis tilted
 * forwards; here it is upright, so 8 degrees are subtracted. At 50 % of the cycle the ankle is flexed by 4 degrees, so
 * that the ball of the foot is on the floor when the other heel strikes: toes do not bend here. The pelvis turns
 * towards the leg behind, drops on the swinging side and shifts to the standing side; the chest turns against the
 * pelvis, and legs and head keep their direction.
 *
 * Every other movement goes from hanging arms through shares of one named pose, and some back again. The root moves
 * down and backwards so that standing feet stay in place, for a mean thigh of 0.225 and a mean shank of 0.234 of the
 * stature.
 *
 * Source: normative gait of Perry and Burnfield, Gait Analysis, 2010, reduced to ten keys.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "pose/pose_table.h"

#define MOVE_DEGREE (MUS_PI / 180.0)
#define MOVE_THIGH 0.225 /* length of the thigh, in parts of the stature: the mean person */
#define MOVE_SHANK 0.234 /* length of the shank, likewise */

#define WALK_KEYS 10
#define WALK_PERIOD 1.1   /* [s] for a stature of 1.7 m; in proportion to the root of the stature, as of a pendulum */
#define WALK_TILT 8.0     /* [degrees] tilt of the pelvis in normative hip angles */
#define WALK_TURN 4.0     /* [degrees] amplitude of the pelvis's rotation */
#define WALK_LIST 4.0     /* [degrees] amplitude of its drop to the swinging side */
#define WALK_SWAY 0.010   /* amplitude of its shift to the standing side, in parts of the stature */
#define WALK_STANCE 5     /* last key of the cycle at which the foot stands: toe off is at 60 % of it */
#define WALK_ARM_OFF 16.0 /* [degrees] abduction of the arms; chosen: clear of the hips */

/* every 10 % of the cycle: flexion of hip and knee, dorsiflexion of the ankle, flexion of shoulder and elbow of the
 * same side [degrees] */
static const double walk_rows[WALK_KEYS][5] = {
    {30, 5, 0, -20, 15},  {26, 17, -4, -18, 17}, {17, 15, 4, -12, 20}, {7, 8, 8, -4, 25},   {-3, 5, 10, 4, 30},
    {-10, 12, 4, 10, 33}, {-4, 38, -16, 8, 30},  {13, 60, -4, 2, 25},  {26, 53, 8, -8, 20}, {32, 23, 4, -16, 16},
};

/* height of the root against standing, in parts of the stature, with which the lower foot is on the floor, over half a
 * cycle: the mean of mus_body_ground() over W34, W40 and M50, to 0.0004. mus_body_move() finds each body's own */
static const double walk_bob[WALK_KEYS / 2] = {-0.0099, -0.0038, -0.0038, -0.0069, -0.0099};

/* a key: time [s], share of the named pose, rotation of the root [degrees], nonzero: left and right exchanged */
typedef struct move_key {
    double time;
    double share, turn;
    int32_t mirror;
} move_key;

static const struct {
    const char *name, *pose;
    double period; /* [s], 0: it ends */
    int32_t stays; /* nonzero: the feet stay in place */
    int32_t keys;
    move_key key[MUS__MOVE_KEYS];
} moves[] = {
    {"walk", NULL, WALK_PERIOD, 0, WALK_KEYS, {{0, 0, 0, 0}}},
    {"arm_raise",
     "arms_raised",
     0,
     1,
     5,
     {{0, 0, 0, 0}, {0.5, 0.2, 0, 0}, {1.0, 0.5, 0, 0}, {1.5, 0.8, 0, 0}, {2.0, 1, 0, 0}}},
    {"sit_down",
     "sit",
     0,
     1,
     5,
     {{0, 0, 0, 0}, {0.4, 0.15, 0, 0}, {0.8, 0.5, 0, 0}, {1.2, 0.85, 0, 0}, {1.6, 1, 0, 0}}},
    {"squat", "squat", 2.4, 1, 4, {{0, 0, 0, 0}, {0.6, 0.5, 0, 0}, {1.2, 1, 0, 0}, {1.8, 0.5, 0, 0}}},
    {"bend", "bend", 3.0, 1, 4, {{0, 0, 0, 0}, {0.75, 0.5, 0, 0}, {1.5, 1, 0, 0}, {2.25, 0.5, 0, 0}}},
    {"twist", "twist", 2.4, 1, 4, {{0, 1, 0, 0}, {0.6, 0, 0, 0}, {1.2, 1, 0, 1}, {1.8, 0, 0, 0}}},
    {"turn",
     "knee_up",
     0,
     0,
     9,
     {{0, 0, 0, 0},
      {0.25, 0.2, 20, 0},
      {0.5, 0, 45, 0},
      {0.75, 0.2, 67.5, 1},
      {1.0, 0, 90, 0},
      {1.25, 0.2, 112.5, 0},
      {1.5, 0, 135, 0},
      {1.75, 0.2, 160, 1},
      {2.0, 0, 180, 0}}},
};

#define MOVE_COUNT ((int32_t)(sizeof moves / sizeof *moves))


int32_t mus_move_count(void)
{
    return MOVE_COUNT;
}


const char *mus_move_name(int32_t move)
{
    return move >= 0 && move < MOVE_COUNT ? moves[move].name : NULL;
}


int32_t mus__move_find(const char *name)
{
    for (int32_t i = 0; i < MOVE_COUNT && name != NULL; i++)
        if (strcmp(moves[i].name, name) == 0) return i;
    return MUS_NONE;
}


/* angles of one leg, and of the arm of its side, in a row of the walk [degrees] */
static void walk_leg(int32_t right, const double *row, double turn, double list, mus_pose *pose)
{
    double(*angle)[3] = pose->angle;
    const double side = right ? -1.0 : 1.0;
    angle[MUS_JOINT_HIP_LEFT + right][MUS_POSE_FLEXION] = row[0] - WALK_TILT;
    angle[MUS_JOINT_HIP_LEFT + right][MUS_POSE_ABDUCTION] = side * list;
    angle[MUS_JOINT_HIP_LEFT + right][MUS_POSE_ROTATION] = side * turn;
    angle[MUS_JOINT_KNEE_LEFT + right][MUS_POSE_FLEXION] = row[1];
    angle[MUS_JOINT_ANKLE_LEFT + right][MUS_POSE_FLEXION] = row[2];
    angle[MUS_JOINT_SHOULDER_LEFT + right][MUS_POSE_FLEXION] = row[3];
    angle[MUS_JOINT_SHOULDER_LEFT + right][MUS_POSE_ABDUCTION] = WALK_ARM_OFF;
    angle[MUS_JOINT_ELBOW_LEFT + right][MUS_POSE_FLEXION] = row[4];
}


/* a key of the walk */
static void walk_pose(int32_t key, double stature, mus_pose *pose)
{
    /* the left heel strikes at phase 0: the left leg is in front, and stands alone after that */
    const double phase = 2.0 * MUS_PI * key / WALK_KEYS, turn = -WALK_TURN * mus__cos(phase),
                 list = -WALK_LIST * mus__sin(phase);
    mus_pose_init(pose, sizeof *pose);
    walk_leg(0, walk_rows[key], turn, list, pose);
    walk_leg(1, walk_rows[(key + WALK_KEYS / 2) % WALK_KEYS], turn, list, pose);
    pose->angle[MUS_JOINT_ROOT][MUS_POSE_ABDUCTION] = list;
    pose->angle[MUS_JOINT_ROOT][MUS_POSE_ROTATION] = turn;
    pose->angle[MUS_JOINT_LUMBAR][MUS_POSE_ABDUCTION] = -list;
    pose->angle[MUS_JOINT_LUMBAR][MUS_POSE_ROTATION] = -2.0 * turn;
    pose->angle[MUS_JOINT_NECK][MUS_POSE_ROTATION] = turn;
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        for (int k = 0; k < 3; k++) pose->angle[j][k] *= MOVE_DEGREE;
    pose->place[0] = WALK_SWAY * stature * mus__sin(phase);
    pose->place[1] = walk_bob[key % (WALK_KEYS / 2)] * stature;
}


/* exchange left and right of a pose */
static void move_mirror(mus_pose *pose)
{
    for (int32_t j = MUS_JOINT_ROOT; j <= MUS_JOINT_NECK; j++)
        pose->angle[j][MUS_POSE_ABDUCTION] *= -1.0, pose->angle[j][MUS_POSE_ROTATION] *= -1.0;
    for (int32_t j = MUS_JOINT_SHOULDER_LEFT; j < MUS_JOINT_COUNT; j += 2)
        for (int k = 0; k < 3; k++) {
            const double left = pose->angle[j][k];
            pose->angle[j][k] = pose->angle[j + 1][k], pose->angle[j + 1][k] = left;
        }
}


/* displacement of an ankle against standing: out (2) up, forwards [m] */
static void move_ankle(const mus_pose *pose, int32_t right, double stature, double *out)
{
    const double *hip = pose->angle[MUS_JOINT_HIP_LEFT + right];
    const double thigh = hip[MUS_POSE_FLEXION] - pose->angle[MUS_JOINT_ROOT][MUS_POSE_FLEXION];
    const double shank = thigh - pose->angle[MUS_JOINT_KNEE_LEFT + right][MUS_POSE_FLEXION];
    const double wide = mus__cos(hip[MUS_POSE_ABDUCTION]);
    out[0] = stature * (MOVE_THIGH + MOVE_SHANK - wide * (MOVE_THIGH * mus__cos(thigh) + MOVE_SHANK * mus__cos(shank)));
    out[1] = stature * wide * (MOVE_THIGH * mus__sin(thigh) + MOVE_SHANK * mus__sin(shank));
}


/* a key of a movement through shares of a named pose */
static void move_pose(int32_t move, const move_key *key, double stature, mus_pose *pose)
{
    mus_pose from, to;
    mus__pose_find("arms_down", &from);
    mus__pose_find(moves[move].pose, &to);
    if (key->mirror) move_mirror(&to);
    mus_pose_init(pose, sizeof *pose);
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        for (int k = 0; k < 3; k++)
            pose->angle[j][k] = from.angle[j][k] + key->share * (to.angle[j][k] - from.angle[j][k]);
    pose->angle[MUS_JOINT_ROOT][MUS_POSE_ROTATION] += MOVE_DEGREE * key->turn;

    /* the lower foot stands on the floor */
    double left[2], right[2];
    move_ankle(pose, 0, stature, left);
    move_ankle(pose, 1, stature, right);
    pose->place[1] = -fmin(left[0], right[0]);
    if (moves[move].stays) pose->place[2] = -0.5 * (left[1] + right[1]);
}


int32_t mus__move_keys(int32_t move, double stature, double *times, mus_pose *poses, double *period)
{
    const bool walks = moves[move].pose == NULL;
    const double pace = walks ? sqrt(stature / 1.7) : 1.0;
    *period = pace * moves[move].period;
    for (int32_t i = 0; i < moves[move].keys; i++) {
        times[i] = walks ? *period * i / WALK_KEYS : moves[move].key[i].time;
        if (walks)
            walk_pose(i, stature, &poses[i]);
        else
            move_pose(move, &moves[move].key[i], stature, &poses[i]);
    }
    return moves[move].keys;
}


int32_t mus__move_feet(int32_t move, int32_t key)
{
    const move_key *at = &moves[move].key[key];
    if (moves[move].pose == NULL) {
        const int32_t right = (key + WALK_KEYS / 2) % WALK_KEYS;
        return (key <= WALK_STANCE ? MUS_FOOT_LEFT : 0) | (right <= WALK_STANCE ? MUS_FOOT_RIGHT : 0);
    }
    const int32_t feet = mus_pose_feet(moves[move].pose), both = MUS_FOOT_LEFT | MUS_FOOT_RIGHT;
    if (at->share <= 0.0 || feet == both) return both;
    return at->mirror ? both & ~feet : feet; /* one foot: the other one of the mirrored pose */
}
