/*
 * test_collider_motion.c: contact with parts that move each in its own way: surface velocity, sweeping, cloth that is
 * carried, and what must not matter: threads, a scene in motion, the way there and back.
 */
#include <math.h>
#include <string.h>

#include "body/people.h"
#include "contact/contact_template.h"
#include "drape/drape_state.h"
#include "geom/vec.h"
#include "support.h"

Suite *mus_suite_collider_motion(void);

#define DEGREE (MUS_PI / 180.0)

typedef struct posing {
    mus_context *context;
    mus_body *body;
    mus_cloth *cloth;
    mus_drape_def def;
    mus_drape *drape;
    int32_t nodes;
} posing;


/* a body W40 and `nodes` bare nodes of 1 g, or a body of one sphere of 0.2 m about the origin */
static posing posing_start(int32_t nodes, const double *place, int sphere)
{
    posing p = {.context = support_context(), .nodes = nodes};
    double rows[6 * 32], mass[512];
    mus_bare bare;
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    for (int i = 0; i < 32; i++) {
        const double turn = MUS_PI * (i + 0.5) / 32, r = 0.2 * sin(turn);
        const double row[6] = {-0.2 * cos(turn), 0.0, 0.0, r, r, 2.0};
        memcpy(rows + 6 * i, row, sizeof row);
    }
    limb.contours = 32, limb.contour = rows;
    limb.pole[0] = -0.2, limb.pole[1] = 0.2;
    if (sphere)
        ck_assert_int_eq(mus_body_create_limbs(p.context, 1, &limb, NULL, &p.body), MUS_OK);
    else
        p.body = people_body(p.context, "W40", NULL);
    for (int i = 0; i < nodes; i++) mass[i] = 1e-3;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = nodes, bare.place = place, bare.mass = mass;
    ck_assert_int_eq(mus_cloth_create_bare(p.context, &bare, &p.cloth), MUS_OK);
    mus_drape_def_init(&p.def, sizeof p.def);
    p.def.precision = 64;
    p.def.drag = 0.0;
    p.def.gravity[1] = 0.0;
    return p;
}


static void posing_drape(posing *p)
{
    mus_drape_destroy(p->drape);
    ck_assert_int_eq(mus_drape_create(p->context, p->cloth, p->body, &p->def, &p->drape), MUS_OK);
}


static void posing_end(posing *p)
{
    mus_drape_destroy(p->drape);
    mus_cloth_destroy(p->cloth);
    mus_body_destroy(p->body);
    support_context_end(p->context);
}


static mus_drape_report posing_report(const posing *p)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(p->drape, &report), MUS_OK);
    return report;
}


static void posing_to(posing *p, const mus_pose *pose, double duration)
{
    const mus_status status = mus_drape_pose_body(p->drape, pose, duration);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(p->context));
}


static void posing_steps(posing *p, int32_t steps, double h)
{
    const mus_status status = mus_drape_step(p->drape, steps, h);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(p->context));
}


/* the left arm straight ahead, swung up by `up` from level */
static mus_pose arm_ahead(double up)
{
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    pose.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_FLEXION] = 90.0 * DEGREE + up;
    return pose;
}


/* ---- motion of surfaces ---- */

/* rotation by `angle` about a unit axis, that keeps the point `fixed` */
static mus__frame turned_about(const double *axis, double angle, const double *fixed)
{
    mus__frame frame;
    const double c = cos(angle), s = sin(angle);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        frame.turn[3 * i + i] = c + (1.0 - c) * axis[i] * axis[i];
        frame.turn[3 * i + j] = (1.0 - c) * axis[i] * axis[j] - s * axis[k];
        frame.turn[3 * i + k] = (1.0 - c) * axis[i] * axis[k] + s * axis[j];
    }
    for (int i = 0; i < 3; i++) {
        frame.place[i] = fixed[i];
        for (int d = 0; d < 3; d++) frame.place[i] -= frame.turn[3 * i + d] * fixed[d];
    }
    return frame;
}


static double map_at(const double *map, int d, const double *x)
{
    return map[3 * d] * x[0] + map[3 * d + 1] * x[1] + map[3 * d + 2] * x[2] + map[9 + d];
}


/* v = w x r, and the way of the step is the rigid one, whatever the frames were before and whatever the glide */
START_TEST(a_part_that_turns_has_the_velocity_of_a_rigid_body)
{
    static const double none[3] = {0}, origin[3] = {0.3, -1.0, 0.2};
    posing p = posing_start(1, none, 1);
    mus__collider *collider;
    uint64_t random = 3;
    ck_assert_int_eq(mus__collider_create(p.context, p.body, origin, 0.002, &collider), MUS_OK);
    for (int k = 0; k < 200; k++) {
        double axis[3], fixed[3], x[3], glide[3], shift[3], before[3], length = 0.0;
        for (int d = 0; d < 3; d++) {
            axis[d] = support_uniform(&random, -1, 1), fixed[d] = support_uniform(&random, -1, 1);
            x[d] = support_uniform(&random, -1, 1), glide[d] = support_uniform(&random, -5, 5);
            shift[d] = support_uniform(&random, -1, 1);
            length += axis[d] * axis[d];
        }
        for (int d = 0; d < 3; d++) axis[d] /= sqrt(length);
        const double spin = support_uniform(&random, -20, 20), h = 1e-3, start = support_uniform(&random, -3, 3);
        const mus__frame was = turned_about(axis, start, fixed), now = turned_about(axis, start + spin * h, fixed);
        for (int d = 0; d < 3; d++) before[d] = shift[d] - h * glide[d];
        mus__collider_move(collider, &was, before, none, 0.0);
        mus__collider_move(collider, &now, shift, glide, h);
        ck_assert_int_eq(collider->moving, MUS__TURNED);

        /* the point of the part that is x in its own frame */
        double from[3], to[3];
        mus__frame_point(&was, x, from);
        mus__frame_point(&now, x, to);
        for (int d = 0; d < 3; d++) from[d] += before[d] - origin[d], to[d] += shift[d] - origin[d];
        for (int d = 0; d < 3; d++) {
            const int j = (d + 1) % 3, i = (d + 2) % 3;
            const double rj = to[j] - shift[j] + origin[j] - fixed[j], ri = to[i] - shift[i] + origin[i] - fixed[i];
            const double exact = spin * (axis[j] * ri - axis[i] * rj) + glide[d];
            ck_assert_double_eq_tol(from[d] + map_at(collider->motion->displacement, d, from), to[d], 4e-15);
            ck_assert_double_eq_tol(map_at(collider->motion->velocity, d, to), exact, 1e-8);
        }
    }
    mus__collider_destroy(collider);
    posing_end(&p);
}
END_TEST


/* a node that sticks on top of a sphere goes round with it, to where the pose carries the skin under it */
START_TEST(what_sticks_is_carried_to_where_the_pose_says)
{
    const double lean = 0.2, place[3] = {0.202 * sin(lean), 0.202 * cos(lean), 0.0};
    posing p = posing_start(1, place, 1);
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    pose.angle[MUS_JOINT_ROOT][MUS_POSE_ROTATION] = 1.0;
    p.def.precision = _i % 2 ? 64 : 32;
    p.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    p.def.friction = INFINITY;
    p.def.gravity[1] = -9.81;
    posing_drape(&p);
    posing_steps(&p, 50, 1e-3);
    double start[3];
    memcpy(start, mus_drape_positions(p.drape), sizeof start);
    posing_to(&p, &pose, 0.5);
    posing_steps(&p, 600, 1e-3);
    const double *x = mus_drape_positions(p.drape), tolerance = p.def.precision == 64 ? 1e-9 : 1e-5;
    ck_assert_double_eq_tol(x[0], start[0] * cos(1.0), tolerance);
    ck_assert_double_eq_tol(x[1], start[1], tolerance);
    ck_assert_double_eq_tol(x[2], -start[0] * sin(1.0), tolerance);
    /* Verlet's velocity has half a kick of gravity that the next contact takes */
    const double kick = p.def.integrator == MUS_METHOD_VERLET ? 0.5 * 9.81e-3 : 0.0;
    ck_assert_double_le(posing_report(&p).max_speed, kick + (p.def.precision == 64 ? 1e-9 : 1e-6));
    posing_end(&p);
}
END_TEST


/* ---- an arm that swings ---- */

/* nodes in the air before an arm that swings at 10 rad/s, in steps in which the hand goes up to 5 cm: none is ever in
 * the body, and those that the arm met are ahead of it */
START_TEST(an_arm_that_swings_passes_through_nothing)
{
    enum { N = 96 };
    double place[3 * N];
    posing p = posing_start(N, (memset(place, 0, sizeof place), place), 0);
    double shoulder[3];
    ck_assert_int_eq(mus_body_landmark(p.body, MUS_LANDMARK_SHOULDER_LEFT, shoulder), MUS_OK);
    for (int i = 0; i < N; i++) {
        place[3 * i] = shoulder[0] + 0.03 * (i % 3 - 1);
        place[3 * i + 1] = shoulder[1] + 0.08 + 0.004 * (i % 8);
        place[3 * i + 2] = shoulder[2] + 0.2 + 0.4 * (i / 3) / (N / 3);
    }
    p.def.precision = _i % 2 ? 64 : 32;
    p.def.friction = _i / 2 % 2 ? INFINITY : 0.0;
    const double h = _i / 4 ? 7e-3 : 1e-3;
    const mus_pose low = arm_ahead(-0.5), high = arm_ahead(0.6);
    posing_drape(&p);
    posing_to(&p, &low, 0.0);
    ck_assert_int_eq(mus_drape_set_state(p.drape, place, NULL), MUS_OK);
    posing_to(&p, &high, 0.11);
    while (mus_drape_time(p.drape) < 0.11) {
        posing_steps(&p, 1, h);
        ck_assert_double_le(posing_report(&p).max_penetration, 0.0);
    }

    /* the posed copy agrees that all are outside; the arm rises by sin 0.6 / 2 m at the far end */
    mus_body *posed;
    double depth[N];
    int lifted = 0;
    ck_assert_int_eq(mus_body_pose(p.body, &high, &posed), MUS_OK);
    ck_assert_int_eq(mus_body_depth(posed, N, mus_drape_positions(p.drape), depth, NULL), MUS_OK);
    for (int i = 0; i < N; i++) {
        const double *x = mus_drape_positions(p.drape) + 3 * i;
        ck_assert_double_le(depth[i], 1e-6);
        lifted += x[1] > place[3 * i + 1] + 0.01;
        /* over the arm, where it does not slide off sideways; a thumb turns those over the hand aside */
        if (i % 3 == 1 && place[3 * i + 2] < shoulder[2] + 0.45)
            ck_assert_double_ge(x[1] - shoulder[1], tan(0.6) * (x[2] - shoulder[2]) - 0.08);
    }
    ck_assert_int_ge(lifted, N / 2);
    mus_body_destroy(posed);
    posing_end(&p);
}
END_TEST


/* there and back the parts stand as before, to the last bit, and the way there is told */
START_TEST(a_pose_there_and_back_returns)
{
    static const double none[3] = {9.0, 9.0, 9.0};
    posing p = posing_start(1, none, 0);
    const mus_pose low = arm_ahead(-0.5), high = arm_ahead(0.6);
    mus_pose told, rest;
    mus__field_f64 first[MUS__PARTS_MAX];
    posing_drape(&p);
    ck_assert_int_eq(mus_body_rest_pose(p.body, &rest), MUS_OK);
    ck_assert_int_eq(mus_drape_body_pose(p.drape, &told), MUS_OK);
    ck_assert_mem_eq(&told, &rest, sizeof rest);
    posing_to(&p, &low, 0.0);
    const mus__collider *collider = p.drape->scene.collider;
    memcpy(first, collider->field64, (size_t)collider->nparts * sizeof *first);
    posing_to(&p, &high, 0.05);
    posing_steps(&p, 25, 1e-3);
    ck_assert_int_eq(mus_drape_body_pose(p.drape, &told), MUS_OK);
    ck_assert_double_eq_tol(told.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_FLEXION], 90.0 * DEGREE + 0.05, 1e-9);
    ck_assert_int_eq(mus_drape_settle(p.drape, NULL, NULL), MUS_ERR_STATE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(p.context), "pose"));
    posing_steps(&p, 50, 1e-3);
    ck_assert_mem_ne(first, collider->field64, (size_t)collider->nparts * sizeof *first);
    posing_to(&p, &low, 0.05);
    posing_steps(&p, 70, 1e-3);
    ck_assert_mem_eq(first, collider->field64, (size_t)collider->nparts * sizeof *first);
    ck_assert_int_eq(mus_drape_body_pose(p.drape, &told), MUS_OK);
    ck_assert_mem_eq(&told, &low, sizeof low);
    posing_end(&p);
}
END_TEST


/* a drape round a posed copy and a drape whose body was posed have the same fields, and place() goes back to each */
START_TEST(a_posed_copy_and_a_posed_drape_are_the_same)
{
    static const double none[3] = {9.0, 9.0, 9.0};
    posing p = posing_start(1, none, 0);
    const mus_pose high = arm_ahead(0.6);
    mus_body *posed;
    mus_drape *other;
    mus_pose told;
    ck_assert_int_eq(mus_body_pose(p.body, &high, &posed), MUS_OK);
    ck_assert_int_eq(mus_drape_create(p.context, p.cloth, posed, &p.def, &other), MUS_OK);
    ck_assert_int_eq(mus_drape_body_pose(other, &told), MUS_OK);
    ck_assert_mem_eq(&told, &high, sizeof high);
    posing_drape(&p);
    posing_to(&p, &high, 0.0);
    for (int32_t l = 0; l < p.drape->scene.collider->nparts; l++) {
        const mus__field_f64 *a = &p.drape->scene.collider->field64[l], *b = &other->scene.collider->field64[l];
        ck_assert_mem_eq(a->origin, b->origin, sizeof a->origin);
        ck_assert_mem_eq(a->axis, b->axis, sizeof a->axis);
        ck_assert_mem_eq(a->radius, b->radius, sizeof *a->radius * (size_t)(a->nring * a->nangle));
        ck_assert_mem_eq(p.drape->scene.collider->box + 6 * l, other->scene.collider->box + 6 * l, 6 * sizeof(double));
    }
    const mus_pose low = arm_ahead(0.0);
    ck_assert_int_eq(mus_drape_pose_body(other, &low, 0.0), MUS_OK);
    ck_assert_int_eq(mus_drape_place(other), MUS_OK);
    for (int32_t l = 0; l < p.drape->scene.collider->nparts; l++)
        ck_assert_mem_eq(p.drape->scene.collider->field64[l].origin, other->scene.collider->field64[l].origin, 24);
    mus_drape_destroy(other);
    mus_body_destroy(posed);
    posing_end(&p);
}
END_TEST


/* ---- cloth on a moving arm ---- */

enum { SHEET = 11 };

/* a sheet of 10 cm over the left forearm, which points ahead */
static void lay_sheet(posing *p, double above)
{
    const double cells[2] = {0.01, 0.01};
    const mus_pose level = arm_ahead(0.0);
    double shoulder[3], x[3 * SHEET * SHEET];
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_cloth_destroy(p->cloth);
    ck_assert_int_eq(mus_cloth_create_grid(p->context, SHEET, SHEET, cells, &cut, &p->cloth), MUS_OK);
    p->nodes = SHEET * SHEET;
    p->def.gravity[1] = -9.81;
    posing_drape(p);
    ck_assert_int_eq(mus_body_landmark(p->body, MUS_LANDMARK_SHOULDER_LEFT, shoulder), MUS_OK);
    for (int i = 0; i < p->nodes; i++) {
        x[3 * i] = shoulder[0] + 0.01 * (i % SHEET - 5), x[3 * i + 1] = shoulder[1] + above;
        x[3 * i + 2] = shoulder[2] + 0.42 + 0.01 * (i / SHEET - 5);
    }
    posing_to(p, &level, 0.0);
    ck_assert_int_eq(mus_drape_set_state(p->drape, x, NULL), MUS_OK);
}


/* the middle of the sheet */
static void sheet_middle(const posing *p, double *out)
{
    memset(out, 0, 3 * sizeof *out);
    for (int i = 0; i < 3 * p->nodes; i++) out[i % 3] += mus_drape_positions(p->drape)[i] / p->nodes;
}


/* settled on the posed arm, then carried by it aside by 30 cm and up: it stays on the arm and never in it */
START_TEST(a_sheet_on_a_forearm_is_carried)
{
    static const double none[3] = {9.0, 9.0, 9.0};
    posing p = posing_start(1, none, 0);
    p.def.precision = _i ? 64 : 32;
    p.def.friction = 0.8;
    lay_sheet(&p, 0.06);
    mus_status status = mus_drape_settle(p.drape, NULL, NULL);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(p.context));
    double before[3], after[3];
    sheet_middle(&p, before);
    mus_pose aside = arm_ahead(0.1);
    aside.angle[MUS_JOINT_SHOULDER_LEFT][MUS_POSE_ROTATION] = 0.0;
    aside.place[0] = 0.3, aside.place[1] = 0.1;
    posing_to(&p, &aside, 0.6);
    const double h = 0.8 * mus_drape_step_bound(p.drape), until = mus_drape_time(p.drape) + 1.2;
    while (mus_drape_time(p.drape) < until) {
        posing_steps(&p, 50, h);
        ck_assert_double_le(posing_report(&p).max_penetration, 0.0);
    }
    sheet_middle(&p, after);
    ck_assert_double_eq_tol(after[0] - before[0], 0.3, 0.02);
    ck_assert_double_gt(after[1] - before[1], 0.1);
    status = mus_drape_settle(p.drape, NULL, NULL);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(p.context));
    posing_end(&p);
}
END_TEST


/* all at 7 m/s, arm in movement, is the scene at rest, moved */
START_TEST(a_posing_body_may_glide)
{
    static const double none[3] = {9.0, 9.0, 9.0}, speed[3] = {3.0, -2.0, 6.0};
    double last[3 * SHEET * SHEET], v[3 * SHEET * SHEET];
    const mus_pose up = arm_ahead(0.3);
    for (int moves = 0; moves < 2; moves++) {
        posing p = posing_start(1, none, 0);
        p.def.friction = 0.5;
        lay_sheet(&p, 0.05);
        for (int i = 0; i < 3 * p.nodes; i++) v[i] = moves ? speed[i % 3] : 0.0;
        double x[3 * SHEET * SHEET];
        memcpy(x, mus_drape_positions(p.drape), sizeof x);
        ck_assert_int_eq(mus_drape_set_state(p.drape, x, v), MUS_OK);
        if (moves) ck_assert_int_eq(mus_drape_move_body(p.drape, speed), MUS_OK);
        posing_to(&p, &up, 0.1);
        posing_steps(&p, 1000, 1.5e-4);
        ck_assert_double_gt(posing_report(&p).contact_impulse[1], 0.0);
        for (int i = 0; moves && i < 3 * p.nodes; i++)
            ck_assert_double_eq_tol(mus_drape_positions(p.drape)[i], last[i] + 0.15 * speed[i % 3], 1e-8);
        memcpy(last, mus_drape_positions(p.drape), sizeof last);
        posing_end(&p);
    }
}
END_TEST


START_TEST(threads_do_not_matter_to_moving_parts)
{
    static const double none[3] = {9.0, 9.0, 9.0};
    uint64_t hash[4];
    for (int k = 0; k < 4; k++) {
        posing p = posing_start(1, none, 0);
        const mus_pose up = arm_ahead(0.8);
        p.def.precision = _i % 2 ? 64 : 32;
        p.def.integrator = _i / 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
        p.def.threads = 1 + k;
        lay_sheet(&p, 0.05);
        posing_to(&p, &up, 0.08);
        posing_steps(&p, 900, 1e-4);
        hash[k] = mus_drape_hash(p.drape);
        ck_assert_double_gt(posing_report(&p).contact_impulse[1], 0.0);
        posing_end(&p);
    }
    for (int k = 1; k < 4; k++) ck_assert_uint_eq(hash[k], hash[0]);
}
END_TEST


/* nodes far from every part are asked of none, in any pose and on the way */
START_TEST(away_from_every_part_nothing_is_asked)
{
    enum { N = 200 };
    double place[3 * N];
    uint64_t random = 8;
    for (int i = 0; i < N; i++) {
        const double turn = support_uniform(&random, 0.0, 6.28), r = support_uniform(&random, 1.1, 2.0);
        place[3 * i] = r * cos(turn), place[3 * i + 1] = support_uniform(&random, 0.0, 1.8),
                  place[3 * i + 2] = r * sin(turn);
    }
    posing p = posing_start(N, place, 0);
    const mus_pose up = arm_ahead(0.8);
    posing_drape(&p);
    posing_to(&p, &up, 0.1);
    posing_steps(&p, 60, 1e-3);
    ck_assert_int_eq((int)posing_report(&p).contact_queries, 0);
    posing_end(&p);
}
END_TEST


START_TEST(each_failing_allocation_of_a_drape_round_a_body_is_a_status)
{
    static const double none[3] = {9.0, 9.0, 9.0};
    posing p = posing_start(1, none, 0);
    const size_t bytes = mus_context_bytes(p.context);
    for (int64_t n = 0;; n++) {
        support_fail_after(n, false);
        const mus_status status = mus_drape_create(p.context, p.cloth, p.body, &p.def, &p.drape);
        support_fail_never();
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_ptr_null(p.drape);
        ck_assert_uint_eq(mus_context_bytes(p.context), bytes);
    }
    /* posing takes no memory */
    const mus_pose up = arm_ahead(0.8);
    support_fail_after(0, false);
    const mus_status status = mus_drape_pose_body(p.drape, &up, 0.1);
    const mus_status stepped = mus_drape_step(p.drape, 10, 1e-3);
    support_fail_never();
    ck_assert_int_eq(status, MUS_OK);
    ck_assert_int_eq(stepped, MUS_OK);
    posing_end(&p);
}
END_TEST


Suite *mus_suite_collider_motion(void)
{
    Suite *suite = suite_create("collider_motion");
    TCase *tests = tcase_create("posing");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, a_part_that_turns_has_the_velocity_of_a_rigid_body);
    tcase_add_loop_test(tests, what_sticks_is_carried_to_where_the_pose_says, 0, SUPPORT_SLOW ? 2 : 4);
    tcase_add_loop_test(tests, an_arm_that_swings_passes_through_nothing, 0, SUPPORT_SLOW ? 2 : 8);
    tcase_add_test(tests, a_pose_there_and_back_returns);
    tcase_add_test(tests, a_posed_copy_and_a_posed_drape_are_the_same);
    tcase_add_loop_test(tests, a_sheet_on_a_forearm_is_carried, 0, 2);
    tcase_add_test(tests, a_posing_body_may_glide);
    tcase_add_loop_test(tests, threads_do_not_matter_to_moving_parts, 0, SUPPORT_SLOW ? 2 : 4);
    tcase_add_test(tests, away_from_every_part_nothing_is_asked);
    tcase_add_test(tests, each_failing_allocation_of_a_drape_round_a_body_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
