/*
 * test_designs.c: the named designs as a list: names, words, groups, families; no two the same; and a sample of what
 * `make designs` does for all: each design for one table size of each of its groups, and some people.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/muslin.h"
#include "study/designs/try.h"
#include "study/people/ansur.h"
#include "block/drafts.h"
#include "support.h"

#define MOST 2000


START_TEST(there_are_500_designs_in_12_families)
{
    int32_t families = 0;
    for (int32_t d = 0; d < mus_design_count(); d++) {
        bool met = false;
        for (int32_t k = 0; k < d && !met; k++) met = strcmp(mus_design_family(k), mus_design_family(d)) == 0;
        families += !met;
    }
    ck_assert_int_ge(mus_design_count(), 500);
    ck_assert_int_lt(mus_design_count(), MOST);
    ck_assert_int_ge(families, 12);
}
END_TEST


START_TEST(names_are_words_of_letters_and_differ)
{
    for (int32_t d = 0; d < mus_design_count(); d++) {
        const char *name = mus_design_name(d);
        ck_assert_uint_eq(strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_"), strlen(name));
        ck_assert_uint_lt(strlen(name), 64);
        ck_assert_int_eq(mus_design_find(name), d);
        ck_assert_uint_gt(strlen(mus_design_title(d)), 2);
        ck_assert(mus_design_groups(d) > 0 && mus_design_groups(d) < 8);
    }
    ck_assert_ptr_null(mus_design_words(mus_design_count()));
    ck_assert_ptr_null(mus_design_words(-1));
    ck_assert_ptr_null(mus_design_fabric(-1));
    ck_assert_int_eq(mus_design_groups(-1), 0);
}
END_TEST


START_TEST(each_is_meant_for_a_fabric_that_there_is)
{
    for (int32_t d = 0; d < mus_design_count(); d++) {
        mus_fabric fabric;
        mus_fabric_init(&fabric, sizeof fabric);
        ck_assert_msg(mus_fabric_find(mus_design_fabric(d), &fabric) == MUS_OK, "%s", mus_design_fabric(d));
        const bool knit = strstr(mus_design_words(d), "cloth=knit") != NULL;
        ck_assert_int_eq(knit, strcmp(mus_design_fabric(d), "jersey") == 0);
    }
    ck_assert_str_eq(mus_design_fabric(mus_design_find("jeans")), "denim");
    ck_assert_str_eq(mus_design_fabric(mus_design_find("coat")), "wool");
}
END_TEST


/* "sleeveless" is the older name of the loose knit top without sleeves, and stays */
static bool same_by_name(int32_t a, int32_t b)
{
    return strcmp(mus_design_name(a), "sleeveless") == 0 && strcmp(mus_design_name(b), "knit_jewel_sleeveless") == 0;
}


/* words go together, and no two designs are the same words */
START_TEST(words_are_read_and_differ)
{
    static char full[MOST][512];
    mus_context *context = support_context();
    for (int32_t d = 0; d < mus_design_count(); d++) {
        const char *words = mus_design_words(d);
        ck_assert_msg(mus_design_spell(context, words, full[d], sizeof full[d]) == MUS_OK, "%s: %s",
                      mus_design_name(d), mus_context_error(context));
        for (int32_t k = 0; k < d; k++)
            ck_assert_msg(strcmp(full[k], full[d]) != 0 || same_by_name(k, d), "%s is %s", mus_design_name(d),
                          mus_design_name(k));
    }
    support_context_end(context);
}
END_TEST


/* ---- no two the same garment ---- */

#define SIZES 64

typedef struct shape {
    uint64_t form[2];
    int32_t n;
    double size[SIZES]; /* areas of the panels [m2], then lengths of the openings [m], each in order of size */
} shape;


static int by_size(const void *left, const void *right)
{
    const double x = *(const double *)left, y = *(const double *)right;
    return x < y ? -1 : x > y;
}


static shape shape_of(const mus_pattern *pattern)
{
    shape out = {.n = 0};
    mus_topology topology;
    int32_t loops = 0;
    size_t size;
    ck_assert_int_eq(mus_pattern_form(pattern, NULL, NULL, 0, &size, out.form), MUS_OK);
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern) && out.n < SIZES; p++)
        out.size[out.n++] = mus_pattern_panel_area(pattern, p);
    qsort(out.size, (size_t)out.n, sizeof *out.size, by_size);
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    for (; loops < topology.loops && out.n < SIZES; loops++) {
        int32_t edges;
        ck_assert_int_eq(mus_pattern_loop(pattern, loops, NULL, 0, &edges, &out.size[out.n++]), MUS_OK);
    }
    qsort(out.size + out.n - loops, (size_t)loops, sizeof *out.size, by_size);
    return out;
}


/* the same form, and every area within 0.5 cm2 and every opening within 1 mm */
static bool shapes_alike(const shape *a, const shape *b, int32_t panels)
{
    if (a->form[0] != b->form[0] || a->form[1] != b->form[1] || a->n != b->n) return false;
    for (int32_t i = 0; i < a->n; i++)
        if (fabs(a->size[i] - b->size[i]) > (i < panels ? 5e-5 : 1e-3)) return false;
    return true;
}


/* a table size of a group */
static const char *size_of(int groups, int which)
{
    static const char *const sizes[3][3] = {{"W40", "W34", "W52"}, {"M50", "M46", "M60"}, {"C116", "C80", "C164"}};
    return sizes[groups & MUS_GROUP_WOMEN ? 0 : groups & MUS_GROUP_MEN ? 1 : 2][which];
}


static mus_tape *tape_of(mus_context *context, const char *size)
{
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, size), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    return tape;
}


/* the notches of a sleeve where it is sewn to a front are single, where it is sewn to a back double; it has both */
static void check_sleeves(const mus_pattern *pattern, const char *name)
{
    const int32_t sleeve = mus_pattern_find_panel(pattern, "sleeve_left");
    int met[4] = {0};
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern) && sleeve != MUS_NONE; i++) {
        int32_t edge, kind;
        double s;
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        ck_assert_int_eq(mus_pattern_notch(pattern, i, &edge, &s, &kind), MUS_OK);
        if (mus_pattern_edge_panel(pattern, edge) != sleeve || drafts_joint(pattern, edge, s)) continue;
        ck_assert_int_eq(mus_pattern_seam(pattern, mus_pattern_edge_seam(pattern, edge), &seam), MUS_OK);
        const int32_t other = seam.edge_a == edge ? seam.edge_b : seam.edge_a;
        const char *panel = mus_pattern_panel_name(pattern, mus_pattern_edge_panel(pattern, other));
        met[kind]++;
        if (strncmp(panel, "front", 5) == 0) ck_assert_msg(kind == MUS_NOTCH_SINGLE, "%s: sleeve and %s", name, panel);
        if (strncmp(panel, "back", 4) == 0) ck_assert_msg(kind == MUS_NOTCH_DOUBLE, "%s: sleeve and %s", name, panel);
    }
    ck_assert_msg(sleeve == MUS_NONE || (met[MUS_NOTCH_SINGLE] > 0 && met[MUS_NOTCH_DOUBLE] > 0),
                  "%s: notches of the sleeve: %d single, %d double", name, met[MUS_NOTCH_SINGLE],
                  met[MUS_NOTCH_DOUBLE]);
}


/* the notch `s` [m] from the end of an edge, of a kind: how many there are */
static int count_notches(const mus_pattern *pattern, int32_t edge, double s, int32_t kind)
{
    int n = 0;
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern); i++) {
        int32_t own, own_kind;
        double at;
        ck_assert_int_eq(mus_pattern_notch(pattern, i, &own, &at, &own_kind), MUS_OK);
        const double length = mus_pattern_edge_length(pattern, edge);
        n += own == edge && own_kind == kind && fabs(length - at - s) < 1e-6;
    }
    return n;
}


/* a panel that is the mirror image of another is printed with it, so it has the mirror image of each of its notches */
static void check_mirrored(const mus_pattern *pattern, const char *name)
{
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern); i++) {
        int32_t edge, kind, copies, mirror;
        double s;
        ck_assert_int_eq(mus_pattern_notch(pattern, i, &edge, &s, &kind), MUS_OK);
        ck_assert_int_eq(mus_pattern_cut(pattern, mus_pattern_edge_panel(pattern, edge), &copies, &mirror), MUS_OK);
        if (mirror == MUS_NONE) continue;
        const char *own = mus_pattern_edge_name(pattern, edge);
        const int32_t twin = mus_pattern_find_edge(pattern, mirror, own);
        ck_assert_int_ne(twin, MUS_NONE);
        ck_assert_msg(count_notches(pattern, twin, s, kind) == 1, "%s: a notch of %s", name, own);
    }
}


/* each design on the middle size of its first group: no two have the same canonical form, areas and openings; notches
 * meet */
START_TEST(no_two_designs_are_the_same_garment)
{
    static shape shapes[MOST];
    static int32_t panels[MOST];
    mus_context *context = support_context();
    for (int32_t d = 0; d < mus_design_count(); d++) {
        design_try one;
        mus_pattern *pattern;
        mus_tape *tape = tape_of(context, size_of(mus_design_groups(d), 0));
        try_draft(context, d, tape, &one, &pattern);
        ck_assert_msg(one.status == MUS_OK, "%s: %s", mus_design_name(d), one.text);
        ck_assert_msg(one.notches == 0, "%s: %d seams whose notches do not meet", mus_design_name(d), one.notches);
        check_sleeves(pattern, mus_design_name(d));
        check_mirrored(pattern, mus_design_name(d));
        shapes[d] = shape_of(pattern);
        panels[d] = one.panels;
        for (int32_t k = 0; k < d; k++)
            ck_assert_msg(!shapes_alike(&shapes[k], &shapes[d], panels[d]) || same_by_name(k, d),
                          "%s is the same garment as %s",
                          mus_design_name(d), mus_design_name(k));
        mus_pattern_destroy(pattern);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


/* ---- a sample of `make designs` ---- */

static void check_draft(mus_context *context, int32_t design, const mus_tape *tape, const char *whom)
{
    design_try one;
    try_draft(context, design, tape, &one, NULL);
    ck_assert_msg(one.status == MUS_OK, "%s of %s: %s", mus_design_name(design), whom, one.text);
    ck_assert_msg(one.seam < 5e-4, "%s of %s: a seam is %g m off", mus_design_name(design), whom, one.seam);
    ck_assert_msg(one.dart < 1e-4, "%s of %s: legs of a dart are %g m off", mus_design_name(design), whom, one.dart);
    ck_assert_msg(one.crossings == 0, "%s of %s: an outline meets itself", mus_design_name(design), whom);
    ck_assert_msg(one.notches == 0, "%s of %s: %d seams whose notches do not meet", mus_design_name(design), whom,
                  one.notches);
}


/* the smallest and the largest size of each group in turn */
START_TEST(each_design_drafts_for_a_size_of_each_group)
{
    mus_context *context = support_context();
    for (int32_t d = 0; d < mus_design_count(); d++)
        for (int bit = MUS_GROUP_WOMEN; bit <= MUS_GROUP_CHILDREN; bit *= 2) {
            if ((mus_design_groups(d) & bit) == 0) continue;
            const char *size = size_of(bit, 1 + (int)(d % 2));
            mus_tape *tape = tape_of(context, size);
            check_draft(context, d, tape, size);
            mus_tape_destroy(tape);
        }
    support_context_end(context);
}
END_TEST


/* some people, each with some designs: under 1 in 100 is refused, and with a reason */
START_TEST(people_are_refused_seldom)
{
    char path[1024];
    ansur table;
    int32_t drafts = 0, refused = 0;
    if (support_data("anthropometry/ansur2_garment_cm.csv", path, sizeof path) == NULL) return;
    ck_assert(ansur_open(&table, path));
    mus_context *context = support_context();
    for (int row = 7; row < table.rows; row += 150) {
        mus_tape *tape = ansur_tape(context, &table, row);
        ck_assert_ptr_nonnull(tape);
        for (int32_t d = row % 11; d < mus_design_count(); d += 11) {
            design_try one;
            if ((mus_design_groups(d) & try_group(tape)) == 0) continue;
            try_draft(context, d, tape, &one, NULL);
            drafts++;
            refused += one.status != MUS_OK;
            if (one.status != MUS_OK) ck_assert_int_eq(one.status, MUS_ERR_DESIGN);
            ck_assert(one.status == MUS_OK || strlen(one.text) > 10);
            ck_assert(one.seam < 5e-4 && one.dart < 1e-4 && one.crossings == 0 && one.notches == 0);
        }
        mus_tape_destroy(tape);
    }
    ck_assert_int_gt(drafts, 100);
    ck_assert_msg(100 * refused < drafts, "%d of %d are refused", refused, drafts);
    support_context_end(context);
    ansur_close(&table);
}
END_TEST


Suite *mus_suite_designs(void);
Suite *mus_suite_designs(void)
{
    Suite *suite = suite_create("designs");
    TCase *list = tcase_create("list"), *drafts = tcase_create("drafts");
    tcase_add_test(list, there_are_500_designs_in_12_families);
    tcase_add_test(list, names_are_words_of_letters_and_differ);
    tcase_add_test(list, words_are_read_and_differ);
    tcase_add_test(list, each_is_meant_for_a_fabric_that_there_is);
    tcase_add_test(drafts, no_two_designs_are_the_same_garment);
    tcase_add_test(drafts, each_design_drafts_for_a_size_of_each_group);
    tcase_add_test(drafts, people_are_refused_seldom);
    tcase_set_timeout(list, 60);
    tcase_set_timeout(drafts, 240);
    suite_add_tcase(suite, list);
    suite_add_tcase(suite, drafts);
    return suite;
}
