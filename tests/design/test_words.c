/*
 * test_words.c: words and options: every combination counted against the reference, words read and spelled back, and
 * refusals that name what is wrong.
 */
#include <string.h>

#include "design/words.h"
#include "muslin/muslin.h"
#include "support.h"

#define NOT_COUNTED (-1) /* an option that the reference does not count */


START_TEST(words_stand_in_the_order_of_their_numbers)
{
    static const struct {
        int32_t axis, option;
        const char *word;
    } list[] = {
        {MUS__AXIS_GARMENT, MUS__GARMENT_CAPE, "cape"},
        {MUS__AXIS_NECK, MUS__NECK_STRAPLESS, "strapless"},
        {MUS__AXIS_SLEEVE, MUS__SLEEVE_TEE, "tee"},
        {MUS__AXIS_SHAPE, MUS__SHAPE_BOXY, "boxy"},
        {MUS__AXIS_COLLAR, MUS__COLLAR_SAILOR, "sailor"},
        {MUS__AXIS_CLOSURE, MUS__CLOSURE_WRAP, "wrap"},
        {MUS__AXIS_TOP_LENGTH, MUS__TOP_LENGTH_TUNIC, "tunic"},
        {MUS__AXIS_SKIRT, MUS__SKIRT_PLAIN, "plain"},
        {MUS__AXIS_LENGTH, MUS__LENGTH_HI_LOW, "hi_low"},
        {MUS__AXIS_LEG, MUS__LEG_HAREM, "harem"},
        {MUS__AXIS_LEG_LENGTH, MUS__LEG_LENGTH_ANKLE, "ankle"},
        {MUS__AXIS_BAND, MUS__BAND_NONE, "none"},
        {MUS__AXIS_RISE, MUS__RISE_HIGH, "high"},
        {MUS__AXIS_EASE, MUS__EASE_BLOCK, "block"},
        {MUS__AXIS_CLOTH, MUS__CLOTH_KNIT, "knit"},
        {MUS__AXIS_CUFF, MUS__CUFF_RIB, "rib"},
        {MUS__AXIS_YOKE, MUS__YOKE_YOKE, "yoke"},
        {MUS__AXIS_POCKET, MUS__POCKET_KANGAROO, "kangaroo"},
        {MUS__AXIS_HEM, MUS__HEM_RIBBED, "ribbed"},
    };
    ck_assert_int_eq(sizeof list / sizeof *list, MUS__AXIS_COUNT);
    ck_assert_int_eq(mus_design_axis_count(), MUS__AXIS_COUNT);
    for (int32_t a = 0; a < MUS__AXIS_COUNT; a++) {
        ck_assert_int_eq(list[a].axis, a);
        ck_assert_str_eq(mus_design_option_name(a, list[a].option), list[a].word);
        ck_assert_int_eq(mus_design_option_count(a), list[a].option + 1);
        ck_assert_ptr_null(mus_design_option_name(a, list[a].option + 1));
    }
    ck_assert_str_eq(mus_design_option_name(MUS__AXIS_NECK, MUS__NECK_BOAT), "boat");
    ck_assert_str_eq(mus_design_option_name(MUS__AXIS_SKIRT, MUS__SKIRT_GATHERED), "gathered");
    ck_assert_str_eq(mus_design_axis_name(MUS__AXIS_TOP_LENGTH), "top_length");
    ck_assert_ptr_null(mus_design_axis_name(-1));
    ck_assert_ptr_null(mus_design_axis_name(MUS__AXIS_COUNT));
    ck_assert_ptr_null(mus_design_option_name(-1, 0));
    ck_assert_ptr_null(mus_design_option_name(MUS__AXIS_NECK, -1));
    ck_assert_ptr_null(mus_design_option_name(MUS__AXIS_COUNT, 0));
    ck_assert_int_eq(mus_design_option_count(MUS__AXIS_COUNT), 0);
}
END_TEST


/* ---- counts ---- */

static bool good(const mus__style *style)
{
    return mus__style_broken(style, UINT32_MAX) == MUS_NONE;
}


/* tops of the reference: with closures, and how many there are of neck, sleeve, shape and collar alone; fitted ones,
 * whose shape is not boxy and which open, are marked in `fitted` (neck, sleeve, shape, collar) */
static void count_tops(int32_t garment, int32_t *with_closure, int32_t *without, int32_t *fitted, int32_t *empire)
{
    mus__style style = {{0}};
    int32_t *o = style.option;
    o[MUS__AXIS_GARMENT] = garment;
    *with_closure = *without = *fitted = *empire = 0;
    for (o[MUS__AXIS_NECK] = 0; o[MUS__AXIS_NECK] < 10; o[MUS__AXIS_NECK]++)
        for (o[MUS__AXIS_SLEEVE] = 0; o[MUS__AXIS_SLEEVE] < 12; o[MUS__AXIS_SLEEVE]++)
            for (o[MUS__AXIS_SHAPE] = 0; o[MUS__AXIS_SHAPE] < 10; o[MUS__AXIS_SHAPE]++)
                for (o[MUS__AXIS_COLLAR] = 0; o[MUS__AXIS_COLLAR] <= MUS__COLLAR_HOOD; o[MUS__AXIS_COLLAR]++) {
                    int32_t n = 0, opens = 0;
                    for (o[MUS__AXIS_CLOSURE] = 0; o[MUS__AXIS_CLOSURE] < 4; o[MUS__AXIS_CLOSURE]++) {
                        if (!good(&style)) continue;
                        n++;
                        opens += o[MUS__AXIS_CLOSURE] != MUS__CLOSURE_NONE;
                    }
                    *with_closure += n;
                    *without += n > 0;
                    if (opens == 0 || o[MUS__AXIS_SHAPE] == MUS__SHAPE_BOXY) continue;
                    *fitted += 1;
                    *empire += o[MUS__AXIS_SHAPE] == MUS__SHAPE_EMPIRE;
                }
}


/* skirts or trousers: with bands, and of shape and length alone; of what `narrow` bits name */
static void count_lowers(int32_t garment, int32_t shape, int32_t length, int32_t *with_band, int32_t *without,
                         uint32_t narrow, int32_t *narrow_count)
{
    mus__style style = {{0}};
    int32_t *o = style.option;
    o[MUS__AXIS_GARMENT] = garment;
    *with_band = *without = *narrow_count = 0;
    for (o[shape] = 0; mus__style_word(shape, o[shape]) != NULL; o[shape]++)
        for (o[length] = 0; mus__style_word(length, o[length]) != NULL; o[length]++) {
            int32_t n = 0;
            for (o[MUS__AXIS_BAND] = 0; o[MUS__AXIS_BAND] < 4; o[MUS__AXIS_BAND]++) {
                o[MUS__AXIS_CLOSURE] = o[MUS__AXIS_BAND] == MUS__BAND_ELASTIC ? MUS__CLOSURE_NONE : MUS__CLOSURE_BACK;
                n += good(&style);
            }
            *with_band += n;
            *without += n > 0;
            *narrow_count += n > 0 && (narrow >> o[shape] & 1) != 0;
        }
}


/* the counts of an independent script that enumerates the rules */
START_TEST(combinations_are_as_many_as_the_reference_counts)
{
    int32_t closures, tops, fitted, empire, bands, skirts, narrow, leg_bands, legs, none;
    count_tops(MUS__GARMENT_TOP, &closures, &tops, &fitted, &empire);
    ck_assert_int_eq(closures, 4068);
    ck_assert_int_eq(tops, 1617);
    count_lowers(MUS__GARMENT_SKIRT, MUS__AXIS_SKIRT, MUS__AXIS_LENGTH, &bands, &skirts,
                 1u << MUS__SKIRT_PENCIL | 1u << MUS__SKIRT_TRUMPET, &narrow);
    ck_assert_int_eq(bands, 234);
    ck_assert_int_eq(skirts, 70);
    count_lowers(MUS__GARMENT_TROUSERS, MUS__AXIS_LEG, MUS__AXIS_LEG_LENGTH, &leg_bands, &legs, 0, &none);
    ck_assert_int_eq(leg_bands, 95);
    ck_assert_int_eq(legs, 27);
    ck_assert_int_eq(fitted * skirts - empire * narrow, 98896);
    ck_assert_int_eq(fitted * legs, 38583);

    /* a dress and a jumpsuit have the rules of their tops */
    int32_t other[4];
    count_tops(MUS__GARMENT_DRESS, &other[0], &other[1], &other[2], &other[3]);
    ck_assert_int_eq(other[0], 4068);
    ck_assert_int_eq(other[2], fitted);
    count_tops(MUS__GARMENT_JUMPSUIT, &other[0], &other[1], &other[2], &other[3]);
    ck_assert_int_eq(other[2], fitted);
}
END_TEST


/* ---- reading ---- */

static const struct {
    const char *words, *full;
} readings[] = {
    {"top", "top neck=jewel shape=side_waist closure=back"},
    {"top cloth=knit sleeve=short", "top neck=jewel sleeve=short shape=boxy closure=none cloth=knit"},
    {"  top\tcollar=shirt  sleeve=long ", "top neck=jewel sleeve=long shape=side_waist collar=shirt closure=front"},
    {"top closure=front collar=shawl", "top neck=v shape=side_waist collar=shawl closure=front"},
    {"dress neck=strapless skirt=full", "dress neck=strapless shape=side_waist closure=back skirt=full"},
    {"dress neck=v neck=v", "dress neck=v shape=side_waist closure=back"},
    {"skirt", "skirt closure=back"},
    {"skirt skirt=block band=none", "skirt closure=none skirt=block band=none"},
    {"top ease=block top_length=waist", "top neck=jewel shape=side_waist closure=seams top_length=waist ease=block"},
    {"skirt skirt=gathered band=elastic", "skirt closure=none skirt=gathered band=elastic"},
    {"trousers leg=wide", "trousers closure=front leg=wide"},
    {"jumpsuit leg=wide neck=halter", "jumpsuit neck=halter shape=side_waist closure=back leg=wide"},
    {"cape collar=hood length=midi", "cape neck=jewel collar=hood closure=none length=midi"},
};


START_TEST(words_left_out_are_chosen_and_spelled)
{
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof readings / sizeof *readings; i++) {
        char full[512], again[512];
        ck_assert_msg(mus_design_spell(context, readings[i].words, full, sizeof full) == MUS_OK, "%s: %s",
                      readings[i].words, mus_context_error(context));
        ck_assert_str_eq(full, readings[i].full);
        ck_assert_int_eq(mus_design_spell(context, full, again, sizeof again), MUS_OK);
        ck_assert_str_eq(again, full);
    }
    support_context_end(context);
}
END_TEST


/* any options that go together, spelled, are read as the same options */
START_TEST(spelling_and_reading_are_inverse)
{
    mus_context *context = support_context();
    uint64_t state = 7;
    int32_t met = 0;
    for (int32_t i = 0; i < 40000; i++) {
        mus__style style = {{0}}, again;
        char text[512];
        style.option[0] = (int32_t)(support_random(&state) % 6);
        for (int32_t a = 1; a < MUS__AXIS_COUNT; a++)
            if (mus__style_has(style.option[0], a))
                style.option[a] = (int32_t)(support_random(&state) % (uint64_t)mus_design_option_count(a));
        if (!good(&style)) continue;
        met++;
        mus__style_spell(&style, text, sizeof text);
        ck_assert_int_eq(mus__style_read(context, text, &again), MUS_OK);
        ck_assert_int_eq(memcmp(&style, &again, sizeof style), 0);
    }
    ck_assert_int_gt(met, 1000);
    support_context_end(context);
}
END_TEST


START_TEST(words_are_read_as_they_are_spoken)
{
    static const char *const list[][2] = {
        {"pencil skirt knee", "skirt skirt=pencil"},
        {"pencil skirt midi", "skirt skirt=pencil length=midi"},
        {"v neck dress short sleeve", "dress neck=v sleeve=short"},
        {"jumpsuit sleeve short", "jumpsuit sleeve=short"},
        {"a-line skirt length=mini", "skirt skirt=a_line length=mini"},
        {"peter pan collar top closure=back", "top collar=peter_pan closure=back"},
        {"dress three quarter sleeve half skirt", "dress sleeve=three_quarter skirt=half"},
        {"slim tapered trousers ankle", "trousers leg=tapered leg_length=ankle ease=slim"},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        char spoken[512], full[512];
        ck_assert_msg(mus_design_spell(context, list[i][0], spoken, sizeof spoken) == MUS_OK, "\"%s\": %s", list[i][0],
                      mus_context_error(context));
        ck_assert_int_eq(mus_design_spell(context, list[i][1], full, sizeof full), MUS_OK);
        ck_assert_str_eq(spoken, full);
    }
    support_context_end(context);
}
END_TEST


START_TEST(refusals_name_the_words)
{
    static const struct {
        const char *words, *text[3];
    } list[] = {
        {"", {"top skirt trousers dress jumpsuit cape"}},
        {"gown", {"gown", "dress"}},
        {"neck=v", {"neck=v", "jumpsuit"}},
        {"top neck", {"neck", "expected"}},
        {"pencil knee", {"pencil", "dress"}},
        {"pencil skirt puff", {"puff", "skirt", "rise"}},
        {"jumpsuit short", {"short", "sleeve=short or leg_length=short"}},
        {"pencil skirt half", {"skirt=pencil", "skirt=half"}},
        {"top neck=", {"neck=", "jewel scoop v"}},
        {"top neck=turtle", {"neck=turtle", "jewel scoop v"}},
        {"skirt sleeve=puff", {"sleeve=puff", "skirt", "rise"}},
        {"top neck=v neck=boat", {"neck=v", "neck=boat"}},
        {"top neck=halter sleeve=puff", {"neck=halter", "sleeve=puff", "shoulder"}},
        {"dress collar=shirt neck=v", {"collar=shirt", "neck=v"}},
        {"top shape=waist closure=none", {"shape=waist", "closure=none", "opening"}},
        {"skirt skirt=pencil length=maxi", {"skirt=pencil", "length=maxi", "walk"}},
        {"trousers leg=flare band=elastic", {"leg=flare", "band=elastic"}},
        {"trousers yoke=yoke closure=back", {"yoke=yoke", "closure=back", "zip"}},
        {"top hem=ribbed cloth=woven", {"hem=ribbed", "cloth=woven"}},
        {"skirt pocket=kangaroo", {"pocket=kangaroo", "garment=skirt"}},
        {"top pocket=kangaroo shape=waist", {"pocket=kangaroo", "shape=waist"}},
        {"top closure=seams", {"closure=seams", "ease=regular", "four pieces"}},
        {"dress skirt=block", {"skirt=block", "garment=dress", "bodice"}},
        {"skirt band=none", {"band=none", "skirt=straight", "hangs"}},
        {"dress shape=empire skirt=pencil", {"shape=empire", "skirt=pencil"}},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        char full[64] = "old";
        ck_assert_int_eq(mus_design_spell(context, list[i].words, full, sizeof full), MUS_ERR_DESIGN);
        ck_assert_str_eq(full, "");
        for (int32_t k = 0; k < 3 && list[i].text[k] != NULL; k++)
            ck_assert_msg(strstr(mus_context_error(context), list[i].text[k]) != NULL, "\"%s\": \"%s\" lacks \"%s\"",
                          list[i].words, mus_context_error(context), list[i].text[k]);
    }
    char text[8];
    ck_assert_int_eq(mus_design_spell(NULL, "top", text, sizeof text), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_spell(context, NULL, text, sizeof text), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_spell(context, "top", NULL, 8), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_spell(context, "top", text, 0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_spell(context, "top", text, sizeof text), MUS_OK);
    ck_assert_str_eq(text, "top nec");
    support_context_end(context);
}
END_TEST


Suite *mus_suite_words(void);
Suite *mus_suite_words(void)
{
    Suite *suite = suite_create("words");
    TCase *words = tcase_create("words");
    tcase_add_test(words, words_stand_in_the_order_of_their_numbers);
    tcase_add_test(words, combinations_are_as_many_as_the_reference_counts);
    tcase_add_test(words, words_left_out_are_chosen_and_spelled);
    tcase_add_test(words, spelling_and_reading_are_inverse);
    tcase_add_test(words, words_are_read_as_they_are_spoken);
    tcase_add_test(words, refusals_name_the_words);
    tcase_set_timeout(words, 60);
    suite_add_tcase(suite, words);
    return suite;
}
