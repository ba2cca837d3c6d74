/*
 * test_refused_bare.c: numbers that are not finite, and masses that are none, at the doors of cloths without a pattern:
 * refused by name, nothing kept.
 */
#include <stdio.h>

#include "muslin/cloth.h"
#include "refused.h"

Suite *mus_suite_refused_bare(void);

enum { BARE_NODES = 4 };

/* a chain of four nodes, the first held; every number can be spoilt */
typedef struct chain {
    double place[3 * BARE_NODES], mass[BARE_NODES], length[3], stiffness[3], dashpot[3], bend_stiffness[2];
} chain;


static mus_status chain_try(mus_context *context, const chain *c)
{
    static const int32_t spring[] = {0, 1, 1, 2, 2, 3}, bend[] = {0, 1, 2, 1, 2, 3}, pin[] = {0};
    mus_bare bare;
    mus_cloth *cloth;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = BARE_NODES, bare.springs = 3, bare.bends = 2, bare.pins = 1;
    bare.place = c->place, bare.mass = c->mass, bare.length = c->length, bare.stiffness = c->stiffness;
    bare.dashpot = c->dashpot, bare.bend_stiffness = c->bend_stiffness;
    bare.spring = spring, bare.bend = bend, bare.pin = pin;
    const mus_status status = mus_cloth_create_bare(context, &bare, &cloth);
    ck_assert_int_eq(status == MUS_OK, cloth != NULL);
    mus_cloth_destroy(cloth);
    return status;
}


static const chain good = {{0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}, {0, 1, 1, 1}, {1, 1, 1}, {9, 9, 9}, {1, 1, 1}, {2, 2}};


/* mus_bare.place mus_bare.mass mus_bare.length mus_bare.stiffness mus_bare.dashpot mus_bare.bend_stiffness */
START_TEST(bare_nodes_that_are_not_finite_are_refused_by_name)
{
    const struct {
        const char *name;
        size_t offset, count;
    } row[] = {
        {"place", offsetof(chain, place), 3 * BARE_NODES},
        {"mass", offsetof(chain, mass), BARE_NODES},
        {"length", offsetof(chain, length), 3},
        {"stiffness", offsetof(chain, stiffness), 3},
        {"dashpot", offsetof(chain, dashpot), 3},
        {"bend_stiffness", offsetof(chain, bend_stiffness), 2},
    };
    mus_context *context = support_context();
    ck_assert_int_eq(chain_try(context, &good), MUS_OK);
    for (size_t r = 0; r < sizeof row / sizeof *row; r++)
        for (size_t i = 0; i < row[r].count; i++)
            for (int v = 0; v < 3; v++) {
                chain bad = good;
                char want[40];
                memcpy((char *)&bad + row[r].offset + i * sizeof(double), &refused_values[v], sizeof(double));
                snprintf(want, sizeof want, "%s[%d] is", row[r].name, (int)i);
                ck_assert_msg(chain_try(context, &bad) == MUS_ERR_ARG, "%s", want);
                ck_assert_msg(strstr(mus_context_error(context), want) != NULL, "%s", mus_context_error(context));
                ck_assert_uint_eq(mus_context_bytes(context), 0);
            }
    ck_assert_int_eq(chain_try(context, &good), MUS_OK);
    support_context_end(context);
}
END_TEST


/* a node that moves has a mass; from 1e-15 to 1e15 kg, ratio 1e30 in one cloth */
START_TEST(a_node_without_mass_is_refused_unless_held)
{
    mus_context *context = support_context();
    const double none[] = {0.0, -0.0, -1e-3, 1e-310, 1e-16, 1e16};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        chain bad = good;
        bad.mass[2] = none[i];
        ck_assert_int_eq(chain_try(context, &bad), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "mass[2]"));
    }
    chain wide = good;
    wide.mass[0] = 0.0, wide.mass[1] = 1e-15, wide.mass[2] = 1e15;
    ck_assert_int_eq(chain_try(context, &wide), MUS_OK);
    support_context_end(context);
}
END_TEST


static mus_status try_grid(mus_context *context, const void *def, void *user)
{
    const double *cell = user, own[2] = {0.01, 0.01};
    mus_cloth *cloth;
    const mus_status status = mus_cloth_create_grid(context, 3, 4, cell != NULL ? cell : own, def, &cloth);
    ck_assert_int_eq(status == MUS_OK, cloth != NULL);
    mus_cloth_destroy(cloth);
    return status;
}


START_TEST(a_grid_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_cloth_def, paper_curvature, 1, false, "paper_curvature"),
    };
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_grid, NULL);

    /* mus_cloth_create_grid: its cell */
    mus_context *context = support_context();
    for (int v = 0; v < 3; v++)
        for (int k = 0; k < 2; k++) {
            double cell[2] = {0.01, 0.01};
            cell[k] = refused_values[v];
            ck_assert_int_eq(try_grid(context, &def, cell), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "cell"));
        }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_bare(void)
{
    Suite *suite = suite_create("refused_bare");
    TCase *tests = tcase_create("refused_bare");
    tcase_add_test(tests, bare_nodes_that_are_not_finite_are_refused_by_name);
    tcase_add_test(tests, a_node_without_mass_is_refused_unless_held);
    tcase_add_test(tests, a_grid_that_is_not_finite_is_refused_by_name);
    suite_add_tcase(suite, tests);
    return suite;
}
