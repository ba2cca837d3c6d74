/* test_rig.c: parts of a body: at rest they are the limb; the frames of rings go over from part to part. */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"
#include "people.h"
#include "pose/pose_frame.h"

Suite *mus_suite_rig(void);

#define ANGLES MUS__FIELD_ANGLES


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
        const mus_body_def def = {.size = sizeof def, .samples = 128, .ring_spacing = 0.01, .plain = 1};
        mus_body *body = people_body(context, sizes[i], &def);
        for (int32_t l = 0; l < body->limb_count; l++) check_limb(context, body, sizes[i], l, &seed);
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


/* along a bent limb the ring's frame goes over from one part to the other without a jump, and is theirs away from the
 * joint */
START_TEST(rings_go_over_from_part_to_part)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M50", NULL);
    const mus__rig *rig = &body->rig;
    mus_pose pose;
    mus__joint_local local[MUS_JOINT_COUNT];
    mus__frame frame[MUS__PARTS_MOST], ring, last;
    ck_assert_int_eq(mus_pose_named(context, "squat", &pose), MUS_OK);
    ck_assert_int_eq(mus__pose_locals(context, rig, &pose, local), MUS_OK);
    mus__pose_frames(rig, local, frame);
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
    tcase_add_test(tests, rings_go_over_from_part_to_part);
    suite_add_tcase(suite, tests);
    return suite;
}
