/*
 * test_force_reference.c: the passes of the kernels against the plain form, and laws of the forces (cases I11,
 * M9).
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/drape_state.h"
#include "drape/scenes.h"
#include "drape/weld.h"
#include "sim/force_reference.h"

Suite *mus_suite_force_reference(void);

typedef struct forces_scene {
    mus_context *context;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
    int32_t n;
    double *x, *f;
} forces_scene;


/* the strips welded or open, with every node moved at random by up to `shake`; without, equal ones, which have no
 * gathers and lie without strain */
static forces_scene forces_open(int32_t precision, int32_t welded, double shake)
{
    forces_scene s;
    s.context = support_context();
    s.pattern = scene_strips(s.context, shake > 0.0 ? 1.2 : 1.0);
    s.cloth = scene_cut(s.context, s.pattern, 0.01, 0.0);
    s.drape = scene_drape(s.context, s.cloth, precision, 1);
    s.n = mus_drape_node_count(s.drape);
    s.x = malloc(3 * (size_t)s.n * sizeof *s.x);
    s.f = malloc(3 * (size_t)s.n * sizeof *s.f);
    if (welded) mus__weld(s.drape);
    uint64_t random = 11;
    memcpy(s.x, mus_drape_positions(s.drape), 3 * (size_t)s.n * sizeof *s.x);
    for (int32_t i = 0; i < 3 * s.n; i++) s.x[i] += support_uniform(&random, -shake, shake);
    ck_assert_int_eq(mus_drape_set_state(s.drape, s.x, NULL), MUS_OK);
    memcpy(s.x, mus_drape_positions(s.drape), 3 * (size_t)s.n * sizeof *s.x);
    return s;
}


static void forces_close(forces_scene *s)
{
    free(s->x);
    free(s->f);
    mus_drape_destroy(s->drape);
    mus_cloth_destroy(s->cloth);
    mus_pattern_destroy(s->pattern);
    support_context_end(s->context);
}


static double forces_size(const forces_scene *s, const double *f)
{
    double most = 0.0;
    for (int32_t i = 0; i < 3 * s->n; i++) most = fmax(most, fabs(f[i]));
    return most;
}


static void kernel_against_plain(int32_t precision, int32_t welded, double tolerance)
{
    forces_scene s = forces_open(precision, welded, 0.004);
    double *kernel = malloc(3 * (size_t)s.n * sizeof *kernel);
    s.drape->program.npair = 0; /* the seams' pull is no elastic force */
    mus__program_force(&s.drape->program, s.n, s.x, s.f);
    s.drape->program.npair = welded ? 0 : s.cloth->npair;
    s.drape->program.seam_pull = 0.0;
    s.drape->sim.ops->force(&s.drape->sim);
    s.drape->sim.ops->get_force(&s.drape->sim, kernel);
    const double size = forces_size(&s, s.f);
    ck_assert_double_gt(size, 1e-3);
    for (int32_t i = 0; i < 3 * s.n; i++) ck_assert_double_eq_tol(kernel[i], s.f[i], tolerance * size);
    free(kernel);
    forces_close(&s);
}


START_TEST(kernel_in_double_is_the_plain_form)
{
    kernel_against_plain(64, _i, 1e-13);
}
END_TEST


START_TEST(kernel_in_float_is_the_plain_form_to_rounding)
{
    kernel_against_plain(32, _i, 2e-5);
}
END_TEST


/* sum f = 0, sum x cross f = 0 */
START_TEST(forces_and_moments_cancel)
{
    forces_scene s = forces_open(64, _i, 0.02);
    mus__program_force(&s.drape->program, s.n, s.x, s.f);
    double force[3] = {0}, moment[3] = {0}, size = 0.0;
    for (int32_t i = 0; i < s.n; i++) {
        const double *x = s.x + 3 * i, *f = s.f + 3 * i;
        for (int d = 0; d < 3; d++) {
            const int e = (d + 1) % 3, g = (d + 2) % 3;
            force[d] += f[d];
            moment[d] += x[e] * f[g] - x[g] * f[e];
            size += fabs(f[d]);
        }
    }
    for (int d = 0; d < 3; d++) {
        ck_assert_double_le(fabs(force[d]), 1e-13 * size);
        ck_assert_double_le(fabs(moment[d]), 1e-12 * size);
    }
    forces_close(&s);
}
END_TEST


/* f = -dE/dx by central differences */
START_TEST(force_is_the_gradient_of_the_energy)
{
    forces_scene s = forces_open(64, _i, 0.004);
    mus__program_force(&s.drape->program, s.n, s.x, s.f);
    const double h = 1e-6, size = forces_size(&s, s.f);
    for (int32_t i = 0; i < 3 * s.n; i += 41) {
        if (s.drape->rep[i / 3] != i / 3) continue;
        const double keep = s.x[i];
        s.x[i] = keep + h;
        const double more = mus__program_force(&s.drape->program, s.n, s.x, NULL);
        s.x[i] = keep - h;
        const double less = mus__program_force(&s.drape->program, s.n, s.x, NULL);
        s.x[i] = keep;
        ck_assert_double_eq_tol(-(more - less) / (2 * h), s.f[i], 1e-6 * size);
    }
    forces_close(&s);
}
END_TEST


START_TEST(rigid_motion_makes_no_force)
{
    forces_scene s = forces_open(64, 0, 0.0);
    const double c = cos(0.7), t = sin(0.7);
    for (int32_t i = 0; i < s.n; i++) {
        const double x = s.x[3 * i], y = s.x[3 * i + 1], z = s.x[3 * i + 2];
        s.x[3 * i] = c * x - t * z + 0.3;
        s.x[3 * i + 1] = y - 0.2;
        s.x[3 * i + 2] = t * x + c * z;
    }
    mus__program_force(&s.drape->program, s.n, s.x, s.f);
    ck_assert_double_le(forces_size(&s, s.f), 1e-10);
    ck_assert_double_le(mus__program_strain(&s.drape->program, s.x), 1e-12);
    forces_close(&s);
}
END_TEST


/* the upper strip turned by an angle about the line of its seam and moved away by `shift` (3) from places `flat`: the
 * energy [J] */
static double forces_turned(forces_scene *s, const double *flat, double angle, const double *shift)
{
    for (int32_t i = 0; i < s->n; i++) {
        double *x = s->x + 3 * i;
        memcpy(x, flat + 3 * i, 3 * sizeof *x);
        if (s->cloth->node_panel[i] != 1) continue;
        const double height = x[1] - 1.2;
        x[0] += shift[0];
        x[1] = 1.2 + height * cos(angle) + shift[1];
        x[2] += height * sin(angle) + shift[2];
    }
    return mus__program_force(&s->drape->program, s->n, s->x, s->f);
}


/* both sides of an open seam turn towards one plane, by their directions alone: C (1 - cos t) however far apart they
 * are, with C of the welded seam where the sides are folded by a right angle */
START_TEST(sides_of_an_open_seam_turn_to_one_plane_from_any_distance)
{
    static const double shifts[3][3] = {{0.0, 0.0, 0.0}, {0.0, -0.1, 0.0}, {0.3, 0.2, -0.4}};
    forces_scene s = forces_open(64, 0, 0.0), welded = forces_open(64, 1, 0.0);
    double *flat = malloc(3 * (size_t)s.n * sizeof *flat);
    memcpy(flat, mus_drape_positions(s.drape), 3 * (size_t)s.n * sizeof *flat);
    const double right = forces_turned(&s, flat, acos(0.0), shifts[0]);
    const double fold = forces_turned(&welded, flat, acos(0.0), shifts[1]);
    printf("an open seam at a right angle: %.6g J, welded %.6g J\n", right, fold);
    ck_assert_double_gt(right, 1e-9);
    ck_assert_double_eq_tol(right, fold, 1e-9 * fold);
    for (int k = 0; k < 3; k++)
        for (double t = -3.0; t < 3.1; t += 0.5)
            ck_assert_double_eq_tol(forces_turned(&s, flat, t, shifts[k]), right * (1.0 - cos(t)), 1e-9 * right);
    free(flat);
    forces_close(&welded);
    forces_close(&s);
}
END_TEST


/* the bound is on the stiffness: no mode of the lattice is faster; power iteration reads the fastest */
START_TEST(step_bound_is_below_the_limit_and_close_to_it)
{
    forces_scene s = forces_open(64, 1, 0.0);
    const double bound = mus_drape_step_bound(s.drape);
    double *u = malloc(3 * (size_t)s.n * sizeof *u), *g = malloc(3 * (size_t)s.n * sizeof *g), rate2 = 0.0;
    uint64_t random = 5;
    mus__program_force(&s.drape->program, s.n, s.x, s.f);
    for (int32_t i = 0; i < 3 * s.n; i++) u[i] = support_uniform(&random, -1.0, 1.0);
    for (int k = 0; k < 400; k++) {
        double size = 0.0;
        for (int32_t i = 0; i < 3 * s.n; i++) size += u[i] * u[i];
        size = 1e-7 / sqrt(size / (3 * s.n));
        for (int32_t i = 0; i < 3 * s.n; i++) u[i] = s.x[i] + size * u[i];
        mus__program_force(&s.drape->program, s.n, u, g);
        double dot = 0.0, norm = 0.0;
        for (int32_t i = 0; i < 3 * s.n; i++) {
            const double du = u[i] - s.x[i];
            if (s.drape->mass[i / 3] <= 0.0) {
                u[i] = 0.0;
                continue;
            }
            u[i] = (s.f[i] - g[i]) / s.drape->mass[i / 3];
            dot += du * u[i] * s.drape->mass[i / 3], norm += du * du * s.drape->mass[i / 3];
        }
        rate2 = dot / norm;
    }
    const double limit = 2.8284 / sqrt(rate2);
    ck_assert_double_lt(bound, limit);
    ck_assert_double_gt(bound, 0.5 * limit);
    free(u);
    free(g);
    forces_close(&s);
}
END_TEST


Suite *mus_suite_force_reference(void)
{
    Suite *suite = suite_create("force_reference");
    TCase *tests = tcase_create("force_reference");
    tcase_add_loop_test(tests, kernel_in_double_is_the_plain_form, 0, 2);
    tcase_add_loop_test(tests, kernel_in_float_is_the_plain_form_to_rounding, 0, 2);
    tcase_add_loop_test(tests, forces_and_moments_cancel, 0, 2);
    tcase_add_loop_test(tests, force_is_the_gradient_of_the_energy, 0, 2);
    tcase_add_test(tests, rigid_motion_makes_no_force);
    tcase_add_test(tests, sides_of_an_open_seam_turn_to_one_plane_from_any_distance);
    tcase_add_test(tests, step_bound_is_below_the_limit_and_close_to_it);
    suite_add_tcase(suite, tests);
    return suite;
}
