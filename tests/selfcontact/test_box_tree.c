/*
 * test_box_tree.c: what moves straight and comes near is found, each pair once, in trees of any size; what has a node
 * in common is not; of what is asked for alone, all pairs.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "selfcontact/box_tree.h"
#include "support.h"

Suite *mus_suite_box_tree(void);

#define NODES 900
#define REACH 0.02f
#define TIMES 5

typedef struct swarm {
    mus_context *context;
    mus__box_tree tree[2];
    float at[2][NODES][3];
    int32_t class_of[NODES];
    uint8_t worn[NODES];
    uint8_t *seen; /* (things x things) */
    int32_t count;
    const mus__box_tree *met;
} swarm;


static float swarm_random(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (float)(*seed >> 8) / 16777216.0f;
}


/* things of `each` nodes that follow each other, `count` of them; a tree of their boxes */
static void swarm_grow(swarm *s, int32_t which, int32_t each, int32_t count)
{
    ck_assert_int_eq(mus__box_tree_create(s->context, each, count, &s->tree[which]), MUS_OK);
    mus__box_tree_clear(&s->tree[which]);
    for (int32_t i = 0; i < count; i++) {
        int32_t node[3] = {0, 0, 0};
        for (int32_t k = 0; k < each; k++) node[k] = (i + k) % NODES;
        mus__box_tree_add(&s->tree[which], node, s->class_of);
    }
}


static void swarm_boxes(swarm *s, mus__box_tree *tree, const uint8_t *worn)
{
    for (int32_t i = 0; i < tree->count; i++)
        for (int32_t time = 0; time < 2; time++)
            for (int32_t d = 0; d < 3; d++) {
                float low = 1e9f, high = -1e9f;
                for (int32_t k = 0; k < tree->each; k++) {
                    const float x = s->at[time][(i + k) % NODES][d];
                    low = x < low ? x : low, high = x > high ? x : high;
                }
                float *box = tree->box + i / 16 * 16 * 12 + i % 16 + (6 * time + d) * 16;
                box[0] = low, box[3 * 16] = high;
            }
    mus__box_tree_fit(tree, worn);
}


static void swarm_met(void *user, int32_t a, int32_t b, uint32_t mask)
{
    swarm *s = user;
    for (int32_t k = 0; k < 16; k++) {
        if (!(mask >> k & 1)) continue;
        uint8_t *seen = &s->seen[a * (int64_t)s->count + 16 * b + k];
        ck_assert_int_eq(*seen, 0);
        *seen = 1;
    }
}


static void swarm_met_back(void *user, int32_t b, int32_t a, uint32_t mask)
{
    for (int32_t k = 0; k < 16; k++)
        if (mask >> k & 1) swarm_met(user, 16 * a + k, b / 16, 1u << b % 16);
}


/* Returns the least distance of the boxes of two things over several times [m]. */
static float swarm_gap(const swarm *s, int32_t a, int32_t aeach, int32_t b, int32_t beach)
{
    float least = 1e9f;
    for (int32_t t = 0; t < TIMES; t++) {
        float gap = -1e9f;
        for (int32_t d = 0; d < 3; d++) {
            float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f};
            for (int32_t k = 0; k < aeach + beach; k++) {
                const int32_t of = k >= aeach, node = (of ? b + k - aeach : a + k) % NODES;
                const float u = (float)t / (TIMES - 1);
                const float x = (1 - u) * s->at[0][node][d] + u * s->at[1][node][d];
                low[of] = fminf(low[of], x), high[of] = fmaxf(high[of], x);
            }
            gap = fmaxf(gap, fmaxf(low[1] - high[0], low[0] - high[1]));
        }
        least = fminf(least, gap);
    }
    return least;
}


static int32_t swarm_joined(const swarm *s, int32_t a, int32_t aeach, int32_t b, int32_t beach)
{
    for (int32_t i = 0; i < aeach; i++)
        for (int32_t j = 0; j < beach; j++)
            if (s->class_of[(a + i) % NODES] == s->class_of[(b + j) % NODES]) return 1;
    return 0;
}


static int32_t swarm_worn(const swarm *s, int32_t a, int32_t each)
{
    for (int32_t i = 0; i < each; i++)
        if (s->worn[(a + i) % NODES]) return 1;
    return 0;
}


/* all pairs of both trees that are asked for are found, and none that has a node of one class, or is not */
static void swarm_check(swarm *s, int32_t one, int32_t two, int32_t some)
{
    const mus__box_tree *a = &s->tree[one], *b = &s->tree[two];
    int64_t found = 0;
    s->count = 16 * ((b->count + 15) / 16);
    s->seen = calloc((size_t)a->count * (size_t)s->count, 1);
    swarm_boxes(s, &s->tree[one], some ? s->worn : NULL);
    if (one != two) swarm_boxes(s, &s->tree[two], some ? s->worn : NULL);
    if (some) mus__box_tree_stale_pairs(a, b, REACH, swarm_met, swarm_met_back, s);
    else mus__box_tree_pairs(a, b, REACH, swarm_met, s);
    for (int32_t i = 0; i < a->count; i++)
        for (int32_t j = one == two ? i + 1 : 0; j < b->count; j++) {
            const int32_t met = s->seen[i * (int64_t)s->count + j] ||
                                (one == two && s->seen[j * (int64_t)s->count + i]);
            const int32_t asked = !some || swarm_worn(s, i, a->each) || swarm_worn(s, j, b->each);
            const int32_t joined = swarm_joined(s, i, a->each, j, b->each);
            found += met;
            if (met) ck_assert_msg(asked && !joined, "%d and %d", (int)i, (int)j);
            else if (asked && !joined) ck_assert_msg(swarm_gap(s, i, a->each, j, b->each) > 0.999f * REACH, "%d and %d",
                                                     (int)i, (int)j);
        }
    ck_assert_int_gt(found, 0);
    free(s->seen);
}


START_TEST(what_comes_near_is_found)
{
    static swarm s;
    static const int32_t count[4][2] = {{5, 3}, {16, 17}, {257, 40}, {NODES, 300}};
    uint32_t seed = 7u + (uint32_t)_i;
    memset(&s, 0, sizeof s);
    s.context = support_context();
    for (int32_t i = 0; i < NODES; i++) {
        const float small = count[_i][0] < 100 ? 0.05f : 0.5f;
        for (int32_t d = 0; d < 3; d++) {
            s.at[0][i][d] = (d == 0 ? 0.001f * (float)(i % 30) : 0.0f) + small * swarm_random(&seed);
            s.at[1][i][d] = s.at[0][i][d] + 0.1f * (swarm_random(&seed) - 0.5f);
        }
        s.class_of[i] = i % 7 == 0 && i > 40 ? i - 40 : i;
        s.worn[i] = i % 50 == 3;
    }
    swarm_grow(&s, 0, 2, count[_i][0]);
    swarm_grow(&s, 1, 1, count[_i][1]);
    mus__box_tree_raise(&s.tree[0], 0);
    mus__box_tree_raise(&s.tree[1], s.tree[0].tiers);
    if (s.tree[1].tiers > s.tree[0].tiers) mus__box_tree_raise(&s.tree[0], s.tree[1].tiers);
    for (int32_t some = 0; some < 2; some++) {
        swarm_check(&s, 0, 0, some);
        swarm_check(&s, 1, 0, some);
    }
    mus__box_tree_destroy(s.context, &s.tree[0]);
    mus__box_tree_destroy(s.context, &s.tree[1]);
    support_context_end(s.context);
}
END_TEST


/* fails where a thing is named that the trees do not have */
static void swarm_known(void *user, int32_t a, int32_t b, uint32_t mask)
{
    swarm *s = user;
    ck_assert(a >= 0 && a < s->tree[1].count && b >= 0 && b <= (s->met->count - 1) / 16);
    for (int32_t k = 0; k < 16; k++)
        if (mask >> k & 1) ck_assert_int_lt(16 * b + k, s->met->count);
    s->count++;
}


/* places that overflow a float make the reach infinite, and then each box is near, also those of empty lanes */
START_TEST(an_infinite_reach_finds_no_thing_that_is_not_there)
{
    static swarm s;
    memset(&s, 0, sizeof s);
    s.context = support_context();
    for (int32_t i = 0; i < NODES; i++) {
        s.class_of[i] = i;
        s.worn[i] = 1;
    }
    swarm_grow(&s, 0, 3, 290);
    swarm_grow(&s, 1, 1, 37);
    mus__box_tree_raise(&s.tree[0], 4);
    mus__box_tree_raise(&s.tree[1], 4);
    s.met = &s.tree[0];
    swarm_boxes(&s, &s.tree[0], NULL);
    swarm_boxes(&s, &s.tree[1], NULL);
    mus__box_tree_pairs(&s.tree[1], &s.tree[0], INFINITY, swarm_known, &s);
    ck_assert_int_gt(s.count, 37 * 18);
    swarm_boxes(&s, &s.tree[0], s.worn);
    swarm_boxes(&s, &s.tree[1], s.worn);
    mus__box_tree_stale_pairs(&s.tree[1], &s.tree[0], INFINITY, swarm_known, swarm_known, &s);
    mus__box_tree_destroy(s.context, &s.tree[0]);
    mus__box_tree_destroy(s.context, &s.tree[1]);
    support_context_end(s.context);
}
END_TEST


Suite *mus_suite_box_tree(void)
{
    Suite *suite = suite_create("box_tree");
    TCase *tests = tcase_create("tree");
    tcase_add_loop_test(tests, what_comes_near_is_found, 0, 4);
    tcase_add_test(tests, an_infinite_reach_finds_no_thing_that_is_not_there);
    suite_add_tcase(suite, tests);
    return suite;
}
