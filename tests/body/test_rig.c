/* test_rig.c: parts of a body and their frames: the rest pose is the body, frames are rotations, blends meet ends. */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"
#include "people.h"

Suite *mus_suite_rig(void);

#define ANGLES MUS_BODY_ANGLES


/* the field of a part of a limb; rings 1 mm apart, so that what differs is the cut and not the table */
static void part_field(mus_context *context, const mus__limb *limb, const mus__part *part, mus__field *field)
{
    double turn[2 * ANGLES];
    mus__stack stack;
    mus__field_turns(ANGLES, turn);
    ck_assert_int_eq(mus__stack_make(context, limb, ANGLES, turn, &stack), MUS_OK);
    ck_assert_int_eq(mus__field_make(context, &stack, part, 0.001, field), MUS_OK);
    mus__stack_free(context, &stack);
}


/* random points near the skin of a limb, brought onto the field of the whole limb, lie on the union of its parts */
static void check_limb(mus_context *context, const mus_body *body, const char *size, int32_t l, uint64_t *seed)
{
    const mus__limb *limb = &body->limb[l];
    const mus__part all = {.end = {limb->contour[0].s, limb->contour[limb->count - 1].s}};
    mus__field whole, field[4];
    int32_t parts = 0;
    part_field(context, limb, &all, &whole);
    for (int32_t p = 0; p < body->rig.parts; p++)
        if (body->rig.part[p].limb == l) part_field(context, limb, &body->rig.part[p], &field[parts++]);
    for (int k = 0; k < 4000; k++) {
        const uint64_t v = support_random(seed) % (uint64_t)limb->vertices;
        double x[3], normal[3] = {0, 0, 0}, here[3], most = -1e30;
        memcpy(x, body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + (ptrdiff_t)v), sizeof x);
        for (int m = 0; m < 3; m++) x[m] += support_uniform(seed, -0.003, 0.003);
        for (int round = 0; round < 4; round++) {
            const double depth = mus__field_depth(&whole, x, normal);
            ck_assert_double_gt(depth, -1.0);
            for (int m = 0; m < 3; m++) x[m] += depth * normal[m];
        }
        for (int32_t p = 0; p < parts; p++) most = fmax(most, mus__field_depth(&field[p], x, here));
        ck_assert_msg(fabs(most) < 3e-4, "%s %s at %.3f %.3f %.3f: %.3f mm", size, limb->name, x[0], x[1], x[2],
                      1e3 * most);
    }
    for (int32_t p = 0; p < parts; p++) mus__field_free(context, &field[p]);
    mus__field_free(context, &whole);
}


START_TEST(parts_at_rest_are_the_limb)
{
    static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C56", "C116"};
    mus_context *context = support_context();
    uint64_t seed = 11;
    for (int i = 0; i < 6; i++) {
        mus_body *body = people_body(context, sizes[i], NULL);
        for (int32_t l = 0; l < body->limb_count; l++) check_limb(context, body, sizes[i], l, &seed);
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


START_TEST(the_rest_pose_is_the_identity)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M50", NULL);
    mus_pose pose;
    mus__local local[MUS_JOINT_COUNT];
    mus__frame frame[MUS_PARTS_MOST];
    ck_assert_int_eq(mus_body_rest_pose(body, &pose), MUS_OK);
    ck_assert_int_eq(mus_pose_check(context, &pose), MUS_OK);
    ck_assert_int_eq(mus__rig_locals(context, mus__body_rig(body), &pose, local), MUS_OK);
    mus__rig_frames(mus__body_rig(body), local, frame);
    for (int32_t p = 0; p < body->rig.parts; p++)
        for (int i = 0; i < 9; i++) {
            ck_assert_double_eq_tol(frame[p].turn[i], i % 4 == 0 ? 1.0 : 0.0, 1e-15);
            ck_assert_double_eq_tol(frame[p].place[i % 3], 0.0, 1e-15);
        }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* turn^T turn = 1 and det = 1 */
static void check_rotation(const mus__frame *frame)
{
    const double *m = frame->turn;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(m[i] * m[k] + m[3 + i] * m[3 + k] + m[6 + i] * m[6 + k], i == k ? 1.0 : 0.0, 1e-14);
    double cross[3];
    mus__cross3(m, m + 3, cross);
    ck_assert_double_eq_tol(mus__dot3(cross, m + 6), 1.0, 1e-14);
}


static void random_locals(mus_context *context, const mus__rig *rig, uint64_t *seed, mus__local *out)
{
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    for (int i = 0; i < 3; i++) pose.place[i] = support_uniform(seed, -1.0, 1.0);
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        for (int32_t k = 0; k < 3; k++) {
            double low, high;
            ck_assert_int_eq(mus_joint_limits(j, k, &low, &high), MUS_OK);
            pose.angle[j][k] = support_uniform(seed, low, high);
        }
    ck_assert_int_eq(mus__rig_locals(context, rig, &pose, out), MUS_OK);
}


/* frames and rings are rotations; two parts meet at their joint; a blend is a rotation too and meets its ends */
START_TEST(frames_are_rotations_that_meet_at_the_joints)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    const mus__rig *rig = mus__body_rig(body);
    uint64_t seed = 31;
    for (int round = 0; round < 300; round++) {
        mus__local a[MUS_JOINT_COUNT], b[MUS_JOINT_COUNT], c[MUS_JOINT_COUNT];
        mus__frame frame[MUS_PARTS_MOST], ring;
        random_locals(context, rig, &seed, a);
        random_locals(context, rig, &seed, b);
        mus__rig_blend(a, b, support_uniform(&seed, 0.0, 1.0), c);
        mus__rig_frames(rig, round % 2 ? a : c, frame);
        for (int32_t p = 0; p < rig->parts; p++) {
            check_rotation(&frame[p]);
            for (int32_t q = 0; q < rig->parts; q++) {
                if (rig->parent[rig->part[p].joint] != rig->part[q].joint) continue;
                if (rig->part[p].limb != rig->part[q].limb) continue;
                double x[3], y[3];
                mus__frame_point(&frame[p], rig->pivot[rig->part[p].joint], x);
                mus__frame_point(&frame[q], rig->pivot[rig->part[p].joint], y);
                for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(x[i], y[i], 1e-14);
            }
        }
        for (int32_t l = 0; l < body->limb_count; l++)
            for (int k = 0; k <= 40; k++) {
                const double low = body->limb[l].pole[0], high = body->limb[l].pole[1];
                mus__rig_ring(rig, frame, l, low + (high - low) * k / 40.0, &ring);
                check_rotation(&ring);
            }

        /* t = 0 and 1 */
        mus__rig_blend(a, b, 0.0, c);
        for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
            for (int i = 0; i < 4; i++) {
                ck_assert_double_eq_tol(c[j].quaternion[i], a[j].quaternion[i], 1e-15);
                ck_assert_double_eq_tol(c[j].shift[i % 3], a[j].shift[i % 3], 1e-15);
            }
        mus__frame end[MUS_PARTS_MOST];
        mus__rig_blend(a, b, 1.0, c);
        mus__rig_frames(rig, c, frame);
        mus__rig_frames(rig, b, end);
        for (int32_t p = 0; p < rig->parts; p++)
            for (int i = 0; i < 9; i++) {
                ck_assert_double_eq_tol(frame[p].turn[i], end[p].turn[i], 1e-14);
                ck_assert_double_eq_tol(frame[p].place[i % 3], end[p].place[i % 3], 1e-14);
            }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* along a bent limb the ring's frame goes over from one part to the other without a jump, and is theirs away from the
 * joint */
START_TEST(rings_go_over_from_part_to_part)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M50", NULL);
    const mus__rig *rig = mus__body_rig(body);
    mus_pose pose;
    mus__local local[MUS_JOINT_COUNT];
    mus__frame frame[MUS_PARTS_MOST], ring, last;
    ck_assert_int_eq(mus_pose_named(context, "squat", &pose), MUS_OK);
    ck_assert_int_eq(mus__rig_locals(context, rig, &pose, local), MUS_OK);
    mus__rig_frames(rig, local, frame);
    for (int32_t p = 0; p < rig->parts; p++) {
        const mus__part *part = &rig->part[p];
        const double middle = 0.5 * (part->end[0] + part->end[1]), step = 1e-4;
        mus__rig_ring(rig, frame, part->limb, middle, &ring);
        for (int i = 0; i < 9; i++) ck_assert_double_eq_tol(ring.turn[i], frame[p].turn[i], 1e-15);
        for (double s = part->end[0]; s < part->end[1]; s += step) {
            mus__rig_ring(rig, frame, part->limb, s, &ring);
            if (s > part->end[0])
                for (int i = 0; i < 9; i++) ck_assert_double_eq_tol(ring.turn[i], last.turn[i], 0.01);
            last = ring;
        }
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_rig(void)
{
    Suite *suite = suite_create("rig");
    TCase *tests = tcase_create("rig");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, parts_at_rest_are_the_limb);
    tcase_add_test(tests, the_rest_pose_is_the_identity);
    tcase_add_test(tests, frames_are_rotations_that_meet_at_the_joints);
    tcase_add_test(tests, rings_go_over_from_part_to_part);
    suite_add_tcase(suite, tests);
    return suite;
}
