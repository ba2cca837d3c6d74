/*
 * test_extreme_bound.c: the step bound of a drape against the true limit, found by power iteration on a stiffness
 * matrix that is written down here and not taken from the library, and by stepping.
 */
#include "bare.h"

Suite *mus_suite_extreme_bound(void);

/* limit over bound on a small free lattice; on the infinite one it is 1 */
#define LATTICE_MOST 1.24

enum { MOST_NODES = 196, MOST_SPRINGS = 2000 };

/* what the matrix is made of: springs k on pairs with rest lengths, stencils b on triples; a node with mass 0 is held
 */
typedef struct spring_net {
    int32_t nodes, springs, bends;
    double place[3 * MOST_NODES], mass[MOST_NODES];
    int32_t spring[2 * MOST_SPRINGS], bend[3 * MOST_SPRINGS];
    double length[MOST_SPRINGS], stiffness[MOST_SPRINGS], dashpot[MOST_SPRINGS], bend_stiffness[MOST_SPRINGS];
} spring_net;


static void net_spring(spring_net *net, int32_t a, int32_t b, double k, double prestretch)
{
    double l2 = 0.0;
    for (int d = 0; d < 3; d++) l2 += pow(net->place[3 * a + d] - net->place[3 * b + d], 2.0);
    const int32_t s = net->springs++;
    net->spring[2 * s] = a, net->spring[2 * s + 1] = b;
    net->length[s] = sqrt(l2) / prestretch, net->stiffness[s] = k, net->dashpot[s] = 0.0;
}


static void net_bend(spring_net *net, int32_t a, int32_t b, int32_t c, double k)
{
    const int32_t s = net->bends++;
    net->bend[3 * s] = a, net->bend[3 * s + 1] = b, net->bend[3 * s + 2] = c;
    net->bend_stiffness[s] = k;
}


/* y = K u: the second derivative of the energy at `place` */
static void net_apply(const spring_net *net, const double *u, double *y)
{
    memset(y, 0, 3 * (size_t)net->nodes * sizeof *y);
    for (int32_t s = 0; s < net->springs; s++) {
        const int32_t a = 3 * net->spring[2 * s], b = 3 * net->spring[2 * s + 1];
        double n[3], l2 = 0.0, along = 0.0;
        for (int d = 0; d < 3; d++) n[d] = net->place[b + d] - net->place[a + d], l2 += n[d] * n[d];
        const double l = sqrt(l2), across = 1.0 - net->length[s] / l;
        for (int d = 0; d < 3; d++) along += n[d] / l * (u[b + d] - u[a + d]);
        for (int d = 0; d < 3; d++) {
            const double f = net->stiffness[s] * (across * (u[b + d] - u[a + d]) + (1.0 - across) * along * n[d] / l);
            y[a + d] -= f, y[b + d] += f;
        }
    }
    for (int32_t s = 0; s < net->bends; s++) {
        const int32_t *i = net->bend + 3 * s;
        for (int d = 0; d < 3; d++) {
            const double e = net->bend_stiffness[s] * (u[3 * i[0] + d] - 2.0 * u[3 * i[1] + d] + u[3 * i[2] + d]);
            y[3 * i[0] + d] += e, y[3 * i[1] + d] -= 2.0 * e, y[3 * i[2] + d] += e;
        }
    }
}


/* the largest eigenvalue of K u = omega^2 M u, from below */
static double net_rate2(const spring_net *net)
{
    static double u[3 * MOST_NODES], y[3 * MOST_NODES];
    uint64_t random = 5;
    double rate2 = 0.0;
    for (int32_t i = 0; i < 3 * net->nodes; i++) u[i] = net->mass[i / 3] > 0.0 ? support_uniform(&random, -1, 1) : 0.0;
    for (int round = 0; round < 1500; round++) {
        net_apply(net, u, y);
        double dot = 0.0, norm = 0.0, size = 0.0;
        for (int32_t i = 0; i < 3 * net->nodes; i++) {
            const double m = net->mass[i / 3];
            dot += u[i] * y[i], norm += m * u[i] * u[i];
            u[i] = m > 0.0 ? y[i] / m : 0.0;
            size += m * u[i] * u[i];
        }
        const double now = dot / norm;
        for (int32_t i = 0; i < 3 * net->nodes; i++) u[i] /= sqrt(size);
        if (round > 50 && fabs(now - rate2) < 1e-9 * now) return now;
        rate2 = now;
    }
    return rate2;
}


static mus_drape *net_drape(mus_context *context, const spring_net *net)
{
    mus_bare bare;
    mus_cloth *cloth;
    int32_t pin[MOST_NODES], pins = 0;
    for (int32_t i = 0; i < net->nodes; i++)
        if (net->mass[i] <= 0.0) pin[pins++] = i;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = net->nodes, bare.springs = net->springs, bare.bends = net->bends, bare.pins = pins;
    bare.place = net->place, bare.mass = net->mass, bare.pin = pin;
    bare.spring = net->spring, bare.length = net->length, bare.stiffness = net->stiffness, bare.dashpot = net->dashpot;
    bare.bend = net->bend, bare.bend_stiffness = net->bend_stiffness;
    ck_assert_msg(mus_cloth_create_bare(context, &bare, &cloth) == MUS_OK, "%s", mus_context_error(context));
    const double weightless[3] = {0.0, 0.0, 0.0};
    return extreme_drape(context, cloth, 64, weightless);
}


/* nodes anywhere in a box, springs of random stiffness between any two, some stretched, some stencils, some held */
static void net_random(spring_net *net, uint64_t *random)
{
    net->nodes = 4 + (int32_t)(support_random(random) % 30), net->springs = net->bends = 0;
    for (int32_t i = 0; i < 3 * net->nodes; i++) net->place[i] = support_uniform(random, -1.0, 1.0);
    for (int32_t i = 0; i < net->nodes; i++)
        net->mass[i] = support_random(random) % 8 == 0 ? 0.0 : pow(10.0, support_uniform(random, -3.0, 1.0));
    net->mass[0] = 1.0;
    for (int32_t s = 0; s < 3 * net->nodes; s++) {
        const int32_t a = (int32_t)(support_random(random) % (uint64_t)net->nodes);
        const int32_t b = (a + 1 + (int32_t)(support_random(random) % (uint64_t)(net->nodes - 1))) % net->nodes;
        net_spring(net, a, b, pow(10.0, support_uniform(random, 0.0, 5.0)),
                   support_random(random) % 2 ? 1.0 : support_uniform(random, 1.0, 2.0));
    }
    const int32_t bends = (int32_t)(support_random(random) % (uint64_t)net->nodes);
    for (int32_t s = 0; s < bends; s++) {
        const int32_t a = (int32_t)(support_random(random) % (uint64_t)(net->nodes - 2));
        net_bend(net, a, a + 1, a + 2, pow(10.0, support_uniform(random, 0.0, 4.0)));
    }
}


/* a flat lattice of side x side nodes: springs along it ks, diagonals kd, stencils kb along it and across */
static void net_grid(spring_net *net, int32_t side, double ks, double kd, double kb)
{
    net->nodes = side * side, net->springs = net->bends = 0;
    for (int32_t i = 0; i < net->nodes; i++) {
        const int32_t r = i / side, c = i % side;
        net->place[3 * i] = 0.01 * c, net->place[3 * i + 1] = 0.01 * r, net->place[3 * i + 2] = 0.0;
        net->mass[i] = 1.5e-5;
    }
    for (int32_t i = 0; i < net->nodes; i++) {
        const int32_t r = i / side, c = i % side;
        if (c + 1 < side) net_spring(net, i, i + 1, ks, 1.0);
        if (r + 1 < side) net_spring(net, i, i + side, ks, 1.0);
        if (kd > 0.0 && c + 1 < side && r + 1 < side) {
            net_spring(net, i, i + side + 1, kd, 1.0);
            net_spring(net, i + 1, i + side, kd, 1.0);
        }
        if (kb > 0.0 && c > 0 && c + 1 < side) net_bend(net, i - 1, i, i + 1, kb);
        if (kb > 0.0 && r > 0 && r + 1 < side) net_bend(net, i - side, i, i + side, kb);
    }
}


/* the bound is never above the limit, in 300 scenes of random springs, stretched ones and stencils among them */
START_TEST(the_bound_is_never_above_the_limit)
{
    static spring_net net;
    uint64_t random = 1;
    for (int scene = 0; scene < 300; scene++) {
        mus_context *context = support_context();
        net_random(&net, &random);
        mus_drape *drape = net_drape(context, &net);
        const double ratio = 2.62 / sqrt(net_rate2(&net)) / mus_drape_step_bound(drape);
        ck_assert_msg(ratio > 1.0 - 1e-9, "scene %d: the bound is %g times the limit", scene, 1.0 / ratio);
        mus_drape_destroy(drape);
        support_context_end(context);
    }
}
END_TEST


/* on free lattices the bound is close */
START_TEST(the_bound_of_a_lattice_is_close)
{
    static const double stiff[][3] = {{1000, 0, 0},    {1000, 40, 0},   {1000, 300, 0},
                                      {1000, 1000, 0}, {1000, 40, 100}, {1000, 300, 3000}};
    static spring_net net;
    for (size_t k = 0; k < sizeof stiff / sizeof *stiff; k++)
        for (int32_t side = 4; side <= 14; side += 5) {
            mus_context *context = support_context();
            net_grid(&net, side, stiff[k][0], stiff[k][1], stiff[k][2]);
            mus_drape *drape = net_drape(context, &net);
            const double ratio = 2.62 / sqrt(net_rate2(&net)) / mus_drape_step_bound(drape);
            ck_assert_msg(ratio > 1.0 - 1e-9 && ratio < LATTICE_MOST, "%d nodes, %g %g %g: limit %g times the bound",
                          (int)net.nodes, stiff[k][0], stiff[k][1], stiff[k][2], ratio);
            mus_drape_destroy(drape);
            support_context_end(context);
        }
}
END_TEST


/* and no energy is won in 200 steps at 0.999 of it, in scenes of springs with dashpots from none to far beyond
 * critical, thrown about; 1.01 of it is refused */
START_TEST(a_step_below_the_bound_wins_no_energy)
{
    static spring_net net;
    static double x[3 * MOST_NODES], v[3 * MOST_NODES];
    uint64_t random = 7;
    for (int scene = 0; scene < 100; scene++) {
        mus_context *context = support_context();
        net_random(&net, &random);
        for (int32_t s = 0; s < net.springs; s++)
            if (support_random(&random) % 2) net.dashpot[s] = pow(10.0, support_uniform(&random, -3.0, 4.0));
        mus_drape *drape = net_drape(context, &net);
        for (int32_t i = 0; i < 3 * net.nodes; i++) {
            x[i] = net.place[i] + support_uniform(&random, -0.01, 0.01);
            v[i] = support_uniform(&random, -0.1, 0.1);
        }
        ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
        const double bound = mus_drape_step_bound(drape), before = extreme_report(drape).energy;
        ck_assert_int_eq(mus_drape_step(drape, 1, 1.01 * bound), MUS_ERR_STEP);
        ck_assert_msg(mus_drape_step(drape, 200, 0.999 * bound) == MUS_OK, "scene %d: %s", scene,
                      mus_context_error(context));
        const double after = extreme_report(drape).energy;
        ck_assert_msg(after <= before * (1.0 + 1e-3), "scene %d: from %g to %g J", scene, before, after);
        mus_drape_destroy(drape);
        support_context_end(context);
    }
}
END_TEST


Suite *mus_suite_extreme_bound(void)
{
    Suite *suite = suite_create("extreme_bound");
    TCase *tests = tcase_create("step_bound");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, the_bound_is_never_above_the_limit);
    tcase_add_test(tests, the_bound_of_a_lattice_is_close);
    tcase_add_test(tests, a_step_below_the_bound_wins_no_energy);
    suite_add_tcase(suite, tests);
    return suite;
}
