/*
 * test_block_fullness.c: sleeves cut open and spread keep what is sewn: the cap's length below the pitches always, the
 * whole cap of a fan; both underarms are as long as each other; the hem is as long as asked.
 */
#include "block/drafts.h"
#include "block/block_fullness.h"


/* long, medium and short sleeves of the table sizes */
static mus__sleeve block_of(mus_context *context, const char *size, double part)
{
    const mus__measures measures = drafts_measures(context, size);
    const mus__bodice bodice = drafts_bodice(context, size);
    const double *m = measures.v;
    mus__sleeve_def def = {.front = bodice.front.arm_length, .back = bodice.back.arm_length};
    mus__sleeve sleeve;
    def.width = fmin(1.15 * m[MUS_MEASURE_UPPER_ARM], (def.front + def.back) / 1.03);
    def.length = fmax(part * m[MUS_MEASURE_ARM], 0.45 * (def.front + def.back));
    def.hem = 0.8 * def.width;
    ck_assert_msg(mus__sleeve_draft(context, &def, &sleeve) == MUS_OK, "%s", mus_context_error(context));
    return sleeve;
}


/* ends meet all round, from the hem to the front underarm */
static void ck_closed(const mus__sleeve_cut *cut)
{
    const mus__chain *ring[] = {&cut->hem, &cut->under_back, &cut->cap[0], &cut->cap[1],
                                &cut->cap[2], &cut->cap[3], &cut->under_front};
    for (int i = 0; i < 7; i++) {
        const mus__chain *a = ring[i], *b = ring[(i + 1) % 7];
        ck_assert_double_eq_tol(a->xy[2 * a->nxy - 2], b->xy[0], 1e-12);
        ck_assert_double_eq_tol(a->xy[2 * a->nxy - 1], b->xy[1], 1e-12);
    }
}


static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};
#define SIZES (int)(sizeof sizes / sizeof sizes[0])


START_TEST(fan_keeps_the_cap)
{
    mus_context *context = support_context();
    const mus__sleeve block = block_of(context, sizes[_i], 1.0);
    const double front = 0.45 * block.front_length, back = 0.48 * block.back_length;
    const double under = hypot(0.5 * (block.width - block.hem), block.length - block.height);
    for (double more = 1.0; more < 2.6; more += 0.3) {
        mus__sleeve_cut cut;
        mus__sleeve_fan(&block, front, back, more * block.hem, 0.0, &cut);
        ck_closed(&cut);
        ck_assert_double_eq_tol(mus__chain_length(&cut.cap[MUS__CAP_FRONT_LOW]), front, 5e-5);
        ck_assert_double_eq_tol(mus__chain_length(&cut.cap[MUS__CAP_BACK_LOW]), back, 5e-5);
        ck_assert_double_eq_tol(mus__chain_length(&cut.cap[MUS__CAP_FRONT_HIGH]), block.front_length - front, 5e-5);
        ck_assert_double_eq_tol(mus__chain_length(&cut.cap[MUS__CAP_BACK_HIGH]), block.back_length - back, 5e-5);
        ck_assert_double_eq_tol(mus__chain_length(&cut.under_front), under, 1e-6);
        ck_assert_double_eq_tol(mus__chain_length(&cut.under_back), under, 1e-6);
        ck_assert_double_eq_tol(mus__chain_length(&cut.hem), more * block.hem, 0.01 * block.hem);
    }
    support_context_end(context);
}
END_TEST


/* no fan at all: the block itself */
START_TEST(fan_of_nothing_is_the_block)
{
    mus_context *context = support_context();
    const mus__sleeve block = block_of(context, "W40", 1.0);
    mus__sleeve_cut fan, plain;
    mus__sleeve_fan(&block, 0.1, 0.1, block.hem, 0.0, &fan);
    mus__sleeve_plain(&block, 0.1, 0.1, &plain);
    for (int i = 0; i < MUS__CAP_PARTS; i++)
        for (int k = 0; k < 2; k++) ck_assert_double_eq_tol(fan.cap[i].xy[k], plain.cap[i].xy[k], 1e-7);
    for (int k = 0; k < 4; k++) ck_assert_double_eq_tol(fan.under_front.xy[k], plain.under_front.xy[k], 1e-7);
    ck_assert_double_eq_tol(mus__chain_length(&fan.hem), block.hem, 1e-7);
    support_context_end(context);
}
END_TEST


START_TEST(puffs_keep_the_cap_below_the_pitch)
{
    mus_context *context = support_context();
    const mus__sleeve block = block_of(context, sizes[_i], 0.4), long_block = block_of(context, sizes[_i], 1.0);
    for (int kind = 0; kind < 2; kind++) {
        const mus__sleeve *from = kind == 0 ? &block : &long_block;
        const double front = 0.45 * from->front_length, back = 0.48 * from->back_length;
        const double k = from->width / 0.34;
        mus__sleeve_cut cut;
        if (kind == 0)
            mus__sleeve_puff(from, front, back, 0.08 * k, 0.04 * k, 0.015 * k, &cut);
        else
            mus__sleeve_gigot(from, front, back, from->height - 0.58 * from->length, 0.12 * k, 0.10 * k, &cut);
        ck_closed(&cut);
        ck_assert_double_eq_tol(mus__chain_length(&cut.cap[MUS__CAP_FRONT_LOW]), front, 1e-9);
        ck_assert_double_eq_tol(mus__chain_length(&cut.cap[MUS__CAP_BACK_LOW]), back, 1e-9);
        ck_assert_double_eq_tol(mus__chain_length(&cut.under_front), mus__chain_length(&cut.under_back), 1e-9);
        ck_assert_double_eq(cut.crown[0], cut.cap[MUS__CAP_FRONT_HIGH].xy[0]);

        /* gathered 1.3 to 2.5 to one above the pitches */
        const double high = mus__chain_length(&cut.cap[MUS__CAP_FRONT_HIGH]);
        const double ratio = high / (from->front_length - front);
        ck_assert_msg(ratio > 1.25 && ratio < 2.5, "%s: gathers %.2f", sizes[_i], ratio);
    }
    support_context_end(context);
}
END_TEST


START_TEST(cap_alone_is_the_upper_part)
{
    mus_context *context = support_context();
    const mus__sleeve block = block_of(context, sizes[_i], 1.0);
    mus__sleeve_cut cut;
    double front, back;
    mus__sleeve_short_cap(&block, 0.3, &front, &back, &cut);
    const mus__chain *f = &cut.cap[MUS__CAP_FRONT_HIGH], *b = &cut.cap[MUS__CAP_BACK_HIGH];
    ck_assert_double_eq_tol(mus__chain_length(f), block.front_length - front, 1e-9);
    ck_assert_double_eq_tol(mus__chain_length(b), block.back_length - back, 1e-9);
    ck_assert_double_eq_tol(b->xy[1], 0.3 * block.height, 1e-9);
    ck_assert_double_eq_tol(f->xy[2 * f->nxy - 1], 0.3 * block.height, 1e-9);
    ck_assert_double_eq(cut.hem.xy[0], f->xy[2 * f->nxy - 2]);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_block_fullness(void)
{
    Suite *suite = suite_create("block_fullness");
    TCase *tcase = tcase_create("block_fullness");
    tcase_add_loop_test(tcase, fan_keeps_the_cap, 0, SIZES);
    tcase_add_test(tcase, fan_of_nothing_is_the_block);
    tcase_add_loop_test(tcase, puffs_keep_the_cap_below_the_pitch, 0, SIZES);
    tcase_add_loop_test(tcase, cap_alone_is_the_upper_part, 0, SIZES);
    suite_add_tcase(suite, tcase);
    return suite;
}
