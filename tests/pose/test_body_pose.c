/* test_body_pose.c: posed copies: the rest pose is the body, girths stay, joints go where a chain by hand puts them. */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "body/people.h"
#include "geom/vec.h"
#include "muslin/pose.h"

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


/* in the pose that a body is made in, stout people too */
START_TEST(arms_hang_clear_of_the_sides)
{
    mus_context *context = support_context();
    uint64_t seed = 31;
    for (int i = 0; i < 20; i++) {
        mus_tape *tape = people_size(context, i % 2 == 0 ? "W40" : "M50");
        const double bust = support_uniform(&seed, 0.85, 1.6), waist = support_uniform(&seed, 0.75, 1.0) * bust;
        const struct {
            int32_t measure;
            double value;
        } own[] = {{MUS_MEASURE_STATURE, support_uniform(&seed, 1.48, 2.0)},
                   {MUS_MEASURE_BUST, bust},
                   {MUS_MEASURE_WAIST, waist},
                   {MUS_MEASURE_HIP, fmax(waist, support_uniform(&seed, 0.95, 1.1) * bust)}};
        for (size_t k = 0; k < sizeof own / sizeof *own; k++)
            ck_assert_int_eq(mus_tape_set(tape, own[k].measure, own[k].value, MUS_SOURCE_GIVEN), MUS_OK);
        mus_body *body = NULL;
        mus_pose rest, clear;
        ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
        ck_assert_int_eq(mus_body_rest_pose(body, &rest), MUS_OK);
        clear = rest;
        ck_assert_int_eq(mus_body_clear_arms(body, &clear, 0.03), MUS_OK);
        ck_assert_msg(memcmp(&clear, &rest, sizeof rest) == 0, "bust %.3f, stature %.3f", bust, own[0].value);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


/* a pose within the limits of all joints */
static void random_pose(uint64_t *seed, mus_pose *pose)
{
    mus_pose_init(pose, sizeof *pose);
    for (int i = 0; i < 3; i++) pose->place[i] = support_uniform(seed, -1.0, 1.0);
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        for (int32_t k = 0; k < 3; k++) {
            double low, high;
            ck_assert_int_eq(mus_joint_limits(j, k, &low, &high), MUS_OK);
            pose->angle[j][k] = support_uniform(seed, low, high);
        }
}


/* perimeter of a closed polygon in space */
static double length_round(const double *x, int32_t n)
{
    double sum = 0.0;
    for (int32_t k = 0; k < n; k++) {
        const double *p = x + 3 * (ptrdiff_t)k, *q = x + 3 * (ptrdiff_t)((k + 1) % n);
        const double d[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
        sum += mus__norm3(d);
    }
    return sum;
}


/* every contour is as long as it was made, and its points keep their distances from each other: in every named pose and
 * in random ones */
START_TEST(girths_are_those_of_the_rest_pose)
{
    enum { N = 24 };
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.05};
    mus_body *body = people_body(context, "W40", &def);
    uint64_t seed = 41;
    for (int32_t i = 0; i < mus_pose_count() + 20; i++) {
        mus_pose pose;
        if (i < mus_pose_count())
            ck_assert_int_eq(mus_pose_named(context, mus_pose_name(i), &pose), MUS_OK);
        else
            random_pose(&seed, &pose);
        mus_body *copy = posed(body, &pose);
        for (int32_t l = 0; l < mus_body_limb_count(body); l++)
            for (int32_t c = 0; c < mus_body_contour_count(body, l); c++) {
                double made[3 * N], now[3 * N];
                ck_assert_int_eq(mus_body_contour_points(body, l, c, N, made), MUS_OK);
                ck_assert_int_eq(mus_body_contour_points(copy, l, c, N, now), MUS_OK);
                ck_assert_double_eq_tol(length_round(now, N), length_round(made, N), 1e-12);
                for (int k = 1; k < N; k++) {
                    double d[3], e[3];
                    for (int m = 0; m < 3; m++) d[m] = made[3 * k + m] - made[m], e[m] = now[3 * k + m] - now[m];
                    ck_assert_double_eq_tol(mus__norm3(d), mus__norm3(e), 1e-12);
                }
            }
        for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
            const double made[2] = {mus_body_made(body, m), mus_body_made(copy, m)};
            ck_assert(made[0] == made[1] || (isnan(made[0]) && isnan(made[1])));
        }
        ck_assert_double_eq_tol(mus_body_volume(copy), mus_body_volume(body), 1e-12);
        mus_body_destroy(copy);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* x turned by an angle about axis 0 X, 1 Y, 2 Z: the textbook's, without a matrix or a quaternion */
static void turn_about(int axis, double angle, double *x)
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double c = cos(angle), s = sin(angle), xa = x[a], xb = x[b];
    x[a] = c * xa - s * xb, x[b] = s * xa + c * xb;
}


/* angle about X [rad] of a hip's rotation, whose other two parts are taken off: the half angles' product by hand */
static double hip_twist(const double *angle)
{
    const double c[3] = {cos(0.5 * angle[0]), cos(0.5 * angle[1]), cos(0.5 * angle[2])};
    const double s[3] = {sin(0.5 * angle[0]), sin(0.5 * angle[1]), sin(0.5 * angle[2])};
    return 2.0 * atan((c[0] * s[1] * s[2] - s[0] * c[1] * c[2]) / (c[0] * c[1] * c[2] + s[0] * s[1] * s[2]));
}


/* move a point (3) of the chest, of a pose without lumbar flexion, with the pelvis: it tilts backwards by 0.375 of the
 * hips' mean flexion (of small angles; here the part of the chord), about the axis through the hips */
static void carry_chest(const mus__rig *rig, const mus_pose *pose, double *x)
{
    const double left = hip_twist(pose->angle[MUS_JOINT_HIP_LEFT]);
    const double hips = 0.5 * (left + hip_twist(pose->angle[MUS_JOINT_HIP_RIGHT]));
    double lumbar[3];
    if (hips >= 0.0) return;
    for (int i = 0; i < 3; i++)
        lumbar[i] = rig->pivot[MUS_JOINT_LUMBAR][i] - rig->pivot[MUS_JOINT_ROOT][i], x[i] -= lumbar[i];
    turn_about(0, 2.0 * atan2(0.375 * sin(0.5 * hips), 0.625 + 0.375 * cos(0.5 * hips)), lumbar);
    for (int i = 0; i < 3; i++) x[i] += lumbar[i];
}


/* the arm and the leg as chains by hand: bones hang down from the joint, each turned by rotation, abduction, flexion,
 * then by all joints above it. The wrist and the ankle of the body are there */
START_TEST(wrists_and_ankles_are_where_a_chain_by_hand_ends)
{
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.05};
    mus_body *body = people_body(context, "M50", &def);
    const mus__rig *rig = &body->rig;
    uint64_t seed = 43;
    for (int round = 0; round < 200; round++) {
        mus_pose pose;
        random_pose(&seed, &pose);
        for (int k = 0; k < 3; k++) pose.angle[MUS_JOINT_LUMBAR][k] = pose.angle[MUS_JOINT_WRIST_LEFT][k] = 0.0;
        mus_body *copy = posed(body, &pose);
        for (int32_t right = 0; right < 2; right++) {
            const double side = right ? -1.0 : 1.0;
            const double *root = pose.angle[MUS_JOINT_ROOT], *hip = pose.angle[MUS_JOINT_HIP_LEFT + right];
            const double *knee = pose.angle[MUS_JOINT_KNEE_LEFT + right];
            const double *shoulder = pose.angle[MUS_JOINT_SHOULDER_LEFT + right];
            const double *elbow = pose.angle[MUS_JOINT_ELBOW_LEFT + right];
            double x[3], ankle[3], wrist[3], lift[3] = {0.0, -1.0, 0.0};

            /* leg: ankle about the knee, knee about the hip, hip about the root */
            for (int i = 0; i < 3; i++)
                x[i] = rig->pivot[MUS_JOINT_ANKLE_LEFT + right][i] - rig->pivot[MUS_JOINT_KNEE_LEFT + right][i];
            turn_about(0, knee[0], x);
            for (int i = 0; i < 3; i++)
                x[i] += rig->pivot[MUS_JOINT_KNEE_LEFT + right][i] - rig->pivot[MUS_JOINT_HIP_LEFT + right][i];
            turn_about(1, -side * hip[2], x);
            turn_about(2, side * hip[1], x);
            turn_about(0, -hip[0], x);
            for (int i = 0; i < 3; i++)
                x[i] += rig->pivot[MUS_JOINT_HIP_LEFT + right][i] - rig->pivot[MUS_JOINT_ROOT][i];
            turn_about(1, root[2], x);
            turn_about(2, -root[1], x);
            turn_about(0, root[0], x);
            for (int i = 0; i < 3; i++) x[i] += rig->pivot[MUS_JOINT_ROOT][i] + pose.place[i];
            mus__frame_point(&copy->frame[rig->parts - 2 + right], rig->pivot[MUS_JOINT_ANKLE_LEFT + right], ankle);
            for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(ankle[i], x[i], 1e-12);

            /* arm: straight down as long as the skeleton says; the shoulder goes with the scapula */
            const double length = body->skeleton.arm_length;
            x[0] = x[2] = 0.0, x[1] = body->skeleton.elbow - length;
            turn_about(1, -side * elbow[2], x);
            turn_about(0, -elbow[0], x);
            x[1] -= body->skeleton.elbow;
            turn_about(1, -side * shoulder[2], x);
            turn_about(2, side * shoulder[1], x);
            turn_about(0, -shoulder[0], x);
            turn_about(2, side * shoulder[1], lift);
            turn_about(0, -shoulder[0], lift);
            const double now = fmax(acos(-lift[1]) / DEGREE - 30.0, 0.0) / 140.0;
            const double rest = fmax(acos(-body->skeleton.arm_axis[right][1]) / DEGREE - 30.0, 0.0) / 140.0;
            const double up = 0.02 * body->skeleton.crown * (now - rest);
            const double shift[3] = {-0.5 * side * up, up, 0.0};
            for (int i = 0; i < 3; i++)
                x[i] += rig->pivot[MUS_JOINT_SHOULDER_LEFT + right][i] + shift[i] - rig->pivot[MUS_JOINT_ROOT][i];
            carry_chest(rig, &pose, x);
            turn_about(1, root[2], x);
            turn_about(2, -root[1], x);
            turn_about(0, root[0], x);
            for (int i = 0; i < 3; i++) x[i] += rig->pivot[MUS_JOINT_ROOT][i] + pose.place[i];
            ck_assert_int_eq(mus_body_landmark(copy, MUS_LANDMARK_WRIST_LEFT + right, wrist), MUS_OK);
            for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(wrist[i], x[i], 1e-12);
        }
        mus_body_destroy(copy);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* a seated pelvis tilts backwards under a chest that keeps its direction, and legs stay: of 90 degrees at the hips and
 * none at the lumbar spine 33 (a chord: 33.75 of small parts); where the spine has its share already, it does not */
START_TEST(the_pelvis_tilts_where_hips_flex_more_than_their_share)
{
    static const struct {
        double hip[2], lumbar, tilt, slack;
    } rows[] = {{{90.0, 90.0}, 0.0, -33.75, 0.8}, {{90.0, 90.0}, 10.0, -27.5, 0.8}, {{60.0, 0.0}, 0.0, -11.25, 0.1},
                {{45.0, 45.0}, 40.0, 0.0, 0.0},   {{-20.0, -20.0}, 0.0, 0.0, 0.0},  {{0.0, 0.0}, 30.0, 0.0, 0.0},
                {{0.0, 0.0}, -20.0, 0.0, 0.0}};
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.05};
    mus_body *body = people_body(context, "W40", &def);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        mus_pose pose;
        mus_pose_init(&pose, sizeof pose);
        pose.angle[MUS_JOINT_HIP_LEFT][MUS_POSE_FLEXION] = DEGREE * rows[i].hip[0];
        pose.angle[MUS_JOINT_HIP_RIGHT][MUS_POSE_FLEXION] = DEGREE * rows[i].hip[1];
        pose.angle[MUS_JOINT_LUMBAR][MUS_POSE_FLEXION] = DEGREE * rows[i].lumbar;
        mus_body *copy = posed(body, &pose);
        const double *pelvis = copy->frame[0].turn, *chest = copy->frame[1].turn;
        ck_assert_double_eq_tol(atan2(pelvis[7], pelvis[8]) / DEGREE, rows[i].tilt, rows[i].slack + 1e-12);
        ck_assert_double_eq_tol(atan2(chest[7], chest[8]) / DEGREE, rows[i].lumbar, 1e-12);
        double x[3];
        mus__frame_point(&copy->frame[0], body->rig.pivot[MUS_JOINT_HIP_LEFT], x);
        for (int k = 0; k < 3; k++) ck_assert_double_eq_tol(x[k], body->rig.pivot[MUS_JOINT_HIP_LEFT][k], 1e-12);
        mus_body_destroy(copy);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* the skin goes with the field: points of the shanks' and forearms' rings between the joints have depth 0 in the posed
 * body where they had it in the rest pose */
START_TEST(depth_and_skin_go_together)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    static const char *const names[] = {"sit", "walk", "reach", "bend"};
    for (int i = 0; i < 4; i++) {
        mus_pose pose;
        mus_move *move = NULL;
        if (i == 1) {
            ck_assert_int_eq(mus_move_named(context, names[i], 1.68, &move), MUS_OK);
            ck_assert_int_eq(mus_move_at(move, 0.4, &pose), MUS_OK);
            mus_move_destroy(move);
        } else {
            ck_assert_int_eq(mus_pose_named(context, names[i], &pose), MUS_OK);
        }
        mus_body *copy = posed(body, &pose);
        for (int32_t c = 0; c < 2; c++) {
            static const struct {
                int32_t limb;
                const char *contour;
            } at[] = {{MUS__LIMB_LEG_LEFT, "calf"}, {MUS__LIMB_ARM_RIGHT, "forearm_low"}};
            double x[3 * 32], depth[32];
            int32_t k = 0;
            while (strcmp(mus_body_contour_name(copy, at[c].limb, k), at[c].contour) != 0) k++;
            ck_assert_int_eq(mus_body_contour_points(copy, at[c].limb, k, 32, x), MUS_OK);
            ck_assert_int_eq(mus_body_depth(copy, 32, x, depth, NULL), MUS_OK);
            for (int m = 0; m < 32; m++) ck_assert_double_eq_tol(depth[m], 0.0, 2e-4);
        }
        mus_body_destroy(copy);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(an_angle_beyond_its_limit_is_refused_by_joint_value_and_limit)
{
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.1};
    mus_body *body = people_body(context, "C116", &def), *copy = body;
    const size_t bytes = mus_context_bytes(context);
    mus_pose pose;
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        for (int32_t k = 0; k < 3; k++)
            for (int side = 0; side < 2; side++) {
                double limit[2];
                char value[32];
                ck_assert_int_eq(mus_joint_limits(j, k, &limit[0], &limit[1]), MUS_OK);
                ck_assert_double_le(limit[0], 0.0);
                ck_assert_double_ge(limit[1], 0.0);
                mus_pose_init(&pose, sizeof pose);
                pose.angle[j][k] = limit[side];
                ck_assert_int_eq(mus_pose_check(context, &pose), MUS_OK);
                pose.angle[j][k] += side == 0 ? -1.0 * DEGREE : 1.0 * DEGREE;
                ck_assert_int_eq(mus_body_pose(body, &pose, &copy), MUS_ERR_BODY);
                ck_assert_ptr_null(copy);
                const char *text = mus_context_error(context);
                ck_assert_msg(strstr(text, mus_joint_name(j)) != NULL, "%s", text);
                snprintf(value, sizeof value, "%.4g", pose.angle[j][k] / DEGREE);
                ck_assert_msg(strstr(text, value) != NULL, "%s: no %s", text, value);
                snprintf(value, sizeof value, "%g to %g", round(limit[0] / DEGREE), round(limit[1] / DEGREE));
                ck_assert_msg(strstr(text, value) != NULL, "%s: no %s", text, value);
                ck_assert_int_eq(mus_body_ground(body, &pose), MUS_ERR_BODY);
                ck_assert_int_eq(mus_body_clear_arms(body, &pose, 0.01), MUS_ERR_BODY);
            }
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    double low;
    ck_assert_int_eq(mus_joint_limits(-1, 0, &low, &low), MUS_ERR_ARG);
    ck_assert_int_eq(mus_joint_limits(0, 3, &low, &low), MUS_ERR_ARG);
    ck_assert_ptr_null(mus_joint_name(MUS_JOINT_COUNT));
    pose.size = 3;
    ck_assert_int_eq(mus_body_pose(body, &pose, &copy), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_body_pose(body, NULL, &copy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_pose(NULL, &pose, &copy), MUS_ERR_ARG);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* every named pose stands on the floor with its arms off the body, for the thinnest and the broadest sizes; the arms of
 * the mean size need no lifting but where hands lie on hips. It is the contact fields that stand on it: the skin of a
 * bent knee is within a centimetre of its ball */
START_TEST(named_poses_fit_bodies)
{
    static const char *const sizes[] = {"W34", "W40", "W52", "M50", "M60", "C56", "C116"};
    mus_context *context = support_context();
    ck_assert_int_ge(mus_pose_count(), 12);
    ck_assert_ptr_null(mus_pose_name(-1));
    ck_assert_ptr_null(mus_pose_name(mus_pose_count()));
    for (int i = 0; i < 7; i++) {
        const mus_body_def def = {.size = sizeof def, .samples = 32, .ring_spacing = 0.02, .plain = 1};
        mus_body *body = people_body(context, sizes[i], &def);
        for (int32_t q = 0; q < mus_pose_count(); q++) {
            mus_pose pose, named;
            ck_assert_int_eq(mus_pose_named(context, mus_pose_name(q), &pose), MUS_OK);
            named = pose;
            ck_assert_msg(mus_pose_check(context, &pose) == MUS_OK, "%s: %s", mus_pose_name(q),
                          mus_context_error(context));
            ck_assert_int_eq(mus_body_clear_arms(body, &pose, 0.01), MUS_OK);
            if (i == 1 && strcmp(mus_pose_name(q), "hands_on_hips") != 0)
                ck_assert_int_eq(memcmp(named.angle, pose.angle, sizeof pose.angle), 0);
            ck_assert_int_eq(mus_body_stand(body, mus_pose_feet(mus_pose_name(q)), &pose), MUS_OK);
            mus_body *copy = posed(body, &pose);
            double lowest = 1.0;
            for (int32_t v = 0; v < copy->vertex_count; v++) lowest = fmin(lowest, copy->vertices[3 * v + 1]);
            ck_assert_msg(fabs(lowest) < 0.012, "%s %s: lowest point %.4f m", sizes[i], mus_pose_name(q), lowest);

            /* hands: depth in all limbs but the arm itself */
            for (int32_t p = 0; p < copy->nfield; p++) {
                const int32_t arm = copy->rig.part[p].limb;
                if (copy->rig.part[p].joint != MUS_JOINT_WRIST_LEFT && copy->rig.part[p].joint != MUS_JOINT_WRIST_RIGHT)
                    continue;
                const mus__limb *limb = &copy->limb[arm];
                for (int32_t v = limb->vertices - 10 * 32; v < limb->vertices; v++) {
                    const double *x = copy->vertices + 3 * (ptrdiff_t)(limb->first_vertex + v);
                    double normal[3];
                    for (int32_t o = 0; o < copy->nfield; o++) {
                        if (copy->rig.part[o].limb == arm) continue;
                        const double depth = mus__field_depth(&copy->field[o], x, normal);
                        ck_assert_msg(depth < -0.006, "%s %s: a hand is %.1f mm from part %d", sizes[i],
                                      mus_pose_name(q), -1e3 * depth, (int)o);
                    }
                }
            }
            mus_body_destroy(copy);
        }
        mus_body_destroy(body);
    }
    mus_pose pose;
    ck_assert_int_eq(mus_pose_named(context, "fly", &pose), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "fly"));
    support_context_end(context);
}
END_TEST


/* between the keys too the lowest point is within a part of the stature of the floor, and arms stay clear by a third of
 * what they have at the keys */
START_TEST(movements_fit_bodies)
{
    static const char *const sizes[] = {"W52", "M50", "C56"};
    mus_context *context = support_context();
    for (int i = 0; i < 3; i++) {
        const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.1};
        mus_body *body = people_body(context, sizes[i], &def);
        for (int32_t q = 0; q < mus_move_count(); q++) {
            mus_move *move = NULL, *same = NULL;
            ck_assert_int_eq(mus_body_move(body, mus_move_name(q), 0.012, &move), MUS_OK);
            ck_assert_int_eq(mus_move_named(context, mus_move_name(q), body->skeleton.crown, &same), MUS_OK);
            ck_assert_double_eq(mus_move_duration(move), mus_move_duration(same));
            ck_assert_double_eq(mus_move_period(move), mus_move_period(same));
            for (int k = 0; k <= 37; k++) {
                mus_pose pose, lifted;
                ck_assert_int_eq(mus_move_at(move, mus_move_duration(move) * k / 37.0, &pose), MUS_OK);
                lifted = pose;
                ck_assert_int_eq(mus_body_clear_arms(body, &lifted, 0.004), MUS_OK);
                ck_assert_msg(memcmp(&lifted, &pose, sizeof pose) == 0, "%s %s at %d/37: arms", sizes[i],
                              mus_move_name(q), k);
                ck_assert_int_eq(mus_body_ground(body, &lifted), MUS_OK);
                const double off = (pose.place[1] - lifted.place[1]) / body->skeleton.crown;
                ck_assert_msg(fabs(off) < 0.005, "%s %s at %d/37: %.4f of the stature off the floor", sizes[i],
                              mus_move_name(q), k, off);
            }
            mus_move_destroy(same);
            mus_move_destroy(move);
        }
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_movement_of_a_body_without_memory_leaves_nothing)
{
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.1};
    mus_body *body = people_body(context, "W40", &def);
    const size_t bytes = mus_context_bytes(context);
    mus_move *move = NULL;
    mus_status status = MUS_ERR_MEMORY;
    for (int64_t n = 0; status == MUS_ERR_MEMORY; n++) {
        support_fail_after(n, false);
        status = mus_body_move(body, "sit_down", 0.01, &move);
        support_fail_never();
        ck_assert((status == MUS_OK) == (move != NULL));
        mus_move_destroy(move);
        ck_assert_uint_eq(mus_context_bytes(context), bytes);
        ck_assert(status == MUS_ERR_MEMORY || n >= 10);
    }
    ck_assert_int_eq(status, MUS_OK);
    ck_assert_int_eq(mus_body_move(body, "fly", 0.01, &move), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_move(body, NULL, 0.01, &move), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_move(NULL, "walk", 0.01, &move), MUS_ERR_ARG);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* poses do not add up, and a posed body is made of the same bytes from whatever it is posed from */
START_TEST(a_pose_starts_from_the_rest_pose)
{
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 32, .ring_spacing = 0.05};
    mus_body *body = people_body(context, "M50", &def);
    mus_pose sit, step;
    ck_assert_int_eq(mus_pose_named(context, "sit", &sit), MUS_OK);
    ck_assert_int_eq(mus_pose_named(context, "step", &step), MUS_OK);
    mus_body *one = posed(body, &step), *other = posed(body, &sit), *again = posed(other, &step);
    ck_assert_int_eq(memcmp(one->vertices, again->vertices, 3 * sizeof(double) * (size_t)one->vertex_count), 0);
    ck_assert_int_eq(memcmp(one->normals, again->normals, 3 * sizeof(double) * (size_t)one->vertex_count), 0);
    for (int32_t p = 0; p < one->nfield; p++)
        ck_assert_int_eq(memcmp(one->field[p].origin, again->field[p].origin, sizeof one->field[p].origin), 0);
    mus_body_destroy(again);
    mus_body_destroy(other);
    mus_body_destroy(one);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* limbs that the caller gave move with the root alone; outlines and names are the copy's own */
START_TEST(given_limbs_move_with_the_root)
{
    mus_context *context = support_context();
    static const double tube[] = {0.0, 0, 0, 0.1, 0.1, 2, 0.5, 0, 0, 0.1, 0.1, 2};
    mus_limb limb;
    mus_body *body = NULL;
    mus_limb_init(&limb, sizeof limb);
    limb.name = "pipe";
    limb.contours = 2, limb.contour = tube;
    limb.pole[0] = -0.1, limb.pole[1] = 0.6;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    pose.angle[MUS_JOINT_ROOT][MUS_POSE_FLEXION] = 0.5 * MUS_PI;
    pose.angle[MUS_JOINT_KNEE_LEFT][MUS_POSE_FLEXION] = 1.0;
    pose.place[0] = 1.0;
    mus_body *copy = posed(body, &pose);
    mus_body_destroy(body);
    ck_assert_str_eq(mus_body_limb_name(copy, 0), "pipe");
    const double x[6] = {1.0, 0.1, 0.25, 1.05, 0.0, 0.25};
    double depth[2], normal[6];
    ck_assert_int_eq(mus_body_depth(copy, 2, x, depth, normal), MUS_OK);
    ck_assert_double_eq_tol(depth[0], 0.0, 1e-9);
    ck_assert_double_eq_tol(depth[1], 0.05, 1e-9);
    ck_assert_double_eq_tol(normal[1], 1.0, 1e-9);
    mus_body_destroy(copy);
    support_context_end(context);
}
END_TEST


START_TEST(a_pose_without_memory_leaves_the_body_as_it_was)
{
    mus_context *context = support_context();
    const mus_body_def def = {.size = sizeof def, .samples = 16, .ring_spacing = 0.1};
    mus_body *body = people_body(context, "W40", &def);
    mus_pose pose;
    ck_assert_int_eq(mus_pose_named(context, "sit", &pose), MUS_OK);
    const size_t bytes = mus_context_bytes(context);
    for (int64_t n = 0;; n++) {
        mus_body *copy = NULL;
        support_fail_after(n, false);
        const mus_status status = mus_body_pose(body, &pose, &copy);
        support_fail_never();
        ck_assert((status == MUS_OK) == (copy != NULL));
        mus_body_destroy(copy);
        ck_assert_uint_eq(mus_context_bytes(context), bytes);
        if (status == MUS_OK) {
            ck_assert_int_gt(n, 30);
            break;
        }
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
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
    tcase_add_test(tests, arms_hang_clear_of_the_sides);
    tcase_add_test(tests, girths_are_those_of_the_rest_pose);
    tcase_add_test(tests, wrists_and_ankles_are_where_a_chain_by_hand_ends);
    tcase_add_test(tests, the_pelvis_tilts_where_hips_flex_more_than_their_share);
    tcase_add_test(tests, depth_and_skin_go_together);
    tcase_add_test(tests, an_angle_beyond_its_limit_is_refused_by_joint_value_and_limit);
    tcase_add_test(tests, named_poses_fit_bodies);
    tcase_add_test(tests, movements_fit_bodies);
    tcase_add_test(tests, a_movement_of_a_body_without_memory_leaves_nothing);
    tcase_add_test(tests, a_pose_starts_from_the_rest_pose);
    tcase_add_test(tests, given_limbs_move_with_the_root);
    tcase_add_test(tests, a_pose_without_memory_leaves_the_body_as_it_was);
    suite_add_tcase(suite, tests);
    return suite;
}
