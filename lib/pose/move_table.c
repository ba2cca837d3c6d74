/*
 * move_table.c: the keys of the named movements.
 *
 * The walk stays where it is, as on a belt: its feet go back under the body. One leg has the normative curves of hip,
 * knee and ankle over the cycle from heel strike, the other the same half a period later. Normative hip angles are
 * against a pelvis tilted forwards; ours stands upright, so 8 degrees are taken off. At 50 % the ankle is held up, as
 * our toes do not bend. The pelvis turns towards the leg that is behind, drops on the side that swings and goes to the
 * side that stands; the chest turns against it, and legs and head do not turn with it.
 *
 * The other movements go through shares of a named pose, from hanging arms and back. The root goes down and back so
 * that feet which stand stay where they are, for legs of the mean person: thigh 0.225, shank 0.234 of the stature.
 *
 * Source: normative gait as in Perry and Burnfield, Gait Analysis, 2010 (reduced to ten keys).
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "pose/pose_table.h"

#define MOVE_DEGREE (MUS_PI / 180.0)
#define MOVE_THIGH 0.225 /* in parts of the stature */
#define MOVE_SHANK 0.234

#define WALK_KEYS 10
#define WALK_PERIOD 1.1  /* [s] at 1.7 m; goes with the root of the stature, as a pendulum */
#define WALK_TILT 8.0    /* of the pelvis in normative hip angles [degrees] */
#define WALK_TURN 4.0    /* of the pelvis [degrees] */
#define WALK_LIST 4.0    /* [degrees] */
#define WALK_SWAY 0.010  /* to the side that stands, in parts of the stature */
#define WALK_ARM_OFF 16.0 /* abduction [degrees] */

/* every 10 % of the cycle: hip flexion, knee flexion, ankle dorsiflexion, same-side shoulder and elbow flexion */
static const double walk_rows[WALK_KEYS][5] = {
    {30, 5, 0, -20, 15},  {26, 17, -4, -18, 17}, {17, 15, 4, -12, 20}, {7, 8, 8, -4, 25},   {-3, 5, 10, 4, 30},
    {-10, 12, 12, 10, 33}, {-4, 38, -16, 8, 30},  {13, 60, -4, 2, 25},  {26, 53, 8, -8, 20}, {32, 23, 4, -16, 16},
};

/* the root above standing, in parts of the stature, so that the lower foot is on the floor; half a cycle. The mean of
 * mus_body_ground over W34, W40 and M50 */
static const double walk_bob[WALK_KEYS / 2] = {-0.0099, -0.0038, -0.0038, -0.0069, -0.0099};

/* a key: when, how much of a pose, turned how far [degrees] */
typedef struct move_key {
    double time;
    double share, turn;
    int32_t mirror;
} move_key;

static const struct {
    const char *name, *pose;
    double period; /* 0: it ends */
    int32_t stays; /* feet stay where they are */
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


static void walk_pose(int32_t key, double stature, mus_pose *pose)
{
    /* the left heel strikes at 0: the left side is in front, then stands alone */
    const double phase = 2.0 * MUS_PI * key / WALK_KEYS, turn = -WALK_TURN * cos(phase), list = -WALK_LIST * sin(phase);
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
    pose->place[0] = WALK_SWAY * stature * sin(phase);
    pose->place[1] = walk_bob[key % (WALK_KEYS / 2)] * stature;
}


/* a pose with left and right exchanged */
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


/* where the ankle of a leg is off its place in standing: out (2) up, forwards */
static void move_ankle(const mus_pose *pose, int32_t right, double stature, double *out)
{
    const double *hip = pose->angle[MUS_JOINT_HIP_LEFT + right];
    const double thigh = hip[MUS_POSE_FLEXION] - pose->angle[MUS_JOINT_ROOT][MUS_POSE_FLEXION];
    const double shank = thigh - pose->angle[MUS_JOINT_KNEE_LEFT + right][MUS_POSE_FLEXION];
    const double wide = cos(hip[MUS_POSE_ABDUCTION]);
    out[0] = stature * (MOVE_THIGH + MOVE_SHANK - wide * (MOVE_THIGH * cos(thigh) + MOVE_SHANK * cos(shank)));
    out[1] = stature * wide * (MOVE_THIGH * sin(thigh) + MOVE_SHANK * sin(shank));
}


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

    /* on the foot that is lower */
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
