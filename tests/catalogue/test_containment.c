/*
 * test_containment.c: a garment contains its sleeves and hoods, itself, and itself with seams left open; not a
 * sleeve turned over, nor what it has no panels or seams for. Forms cut or changed byte by byte contain nothing or
 * something, and never harm.
 */
#include <stdlib.h>

#include "catalogue/catalogue_internal.h"
#include "topology/garments.h"
#include "topology/gluing.h"


/* does `whole` contain `part`? Through a catalogue of one */
static bool contains(mus_context *context, const mus_pattern *whole, const mus_pattern *part)
{
    char path[1024];
    mus_catalogue *catalogue;
    int32_t n;
    support_scratch("one.db", path, sizeof path);
    ck_assert_int_eq(mus_catalogue_open(context, path, MUS_CATALOGUE_WRITE, &catalogue), MUS_OK);
    ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_OK);
    ck_assert_int_eq(mus_catalogue_add(catalogue, whole, "whole", NULL), MUS_OK);
    ck_assert_int_eq(mus_catalogue_containing(catalogue, part, NULL, 0, &n), MUS_OK);
    mus_catalogue_destroy(catalogue);
    return n == 1;
}


START_TEST(a_shirt_contains_its_sleeve_and_a_hood_is_known)
{
    static const struct {
        const char *garment, *panels, *seams;
        bool inside;
    } rows[] = {
        {"T-shirt", "S: hem underB capB capF underF", "S.underF S.underB", true},
        {"T-shirt", "S: hem underB capB capF underF", "", true},
        {"T-shirt", "S: hem underB capB capF underF", "S.underF S.underB direct", false},
        {"T-shirt", "S: hem underB capB capF underF", "S.underF S.capF", false},
        {"T-shirt", "S: a b c d e f", "", false},
        {"T-shirt", "L: a b c d e; R: a b c d e; T: a b c d e", "", false},
        {"T-shirt", "L: a b c d e; R: a b c d e", "L.b L.e; R.b R.e", true},
        {"raglan tee", "S: hem underB capB capF underF", "S.underF S.underB", false},
        {"sleeveless top + hood", "L: nF nB crown face; R: face crown nB nF", "L.crown R.crown", true},
        {"trousers", "F: waist crotch inseam hem out; B: waist out hem inseam crotch", "F.out B.out; F.inseam B.inseam",
         true},
        {"skirt, 2 panels", "F: waist crotch inseam hem out; B: waist out hem inseam crotch", "F.out B.out", false},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        int32_t g = 0;
        while (strcmp(garments[g].name, rows[i].garment) != 0) g++;
        mus_pattern *whole = gluing_make(context, garments[g].panels, garments[g].seams, i);
        mus_pattern *part = gluing_make(context, rows[i].panels, rows[i].seams, 0);
        ck_assert_msg(contains(context, whole, part) == rows[i].inside, "%s and %s with %s", rows[i].garment,
                      rows[i].panels, rows[i].seams);

        /* a label that the part asks for has to be there */
        ck_assert_int_eq(mus_pattern_set_edge_label(part, 0, "belt"), MUS_OK);
        ck_assert(!contains(context, whole, part));
        mus_pattern_destroy(part);
        mus_pattern_destroy(whole);
    }
    support_context_end(context);
}
END_TEST


START_TEST(garments_contain_themselves_with_fewer_seams_and_not_the_other_way)
{
    mus_context *context = support_context();
    for (int32_t g = 0; g < GARMENTS; g++) {
        mus_pattern *whole = gluing_make(context, garments[g].panels, garments[g].seams, 3);
        const char *last = strrchr(garments[g].seams, ';');
        char seams[2048] = "";
        if (last != NULL) snprintf(seams, sizeof seams, "%.*s", (int)(last - garments[g].seams), garments[g].seams);
        mus_pattern *open = gluing_make(context, garments[g].panels, seams, 0);
        ck_assert(contains(context, whole, whole));
        ck_assert_msg(contains(context, whole, open), "%s", garments[g].name);
        if (garments[g].seams[0] != '\0') ck_assert_msg(!contains(context, open, whole), "%s", garments[g].name);
        mus_pattern_destroy(open);
        mus_pattern_destroy(whole);
    }
    support_context_end(context);
}
END_TEST


START_TEST(damaged_forms_do_no_harm)
{
    mus_context *context = support_context();
    uint64_t state = 31;
    for (int32_t g = 0; g < GARMENTS; g++) {
        mus_pattern *pattern = gluing_make(context, garments[g].panels, garments[g].seams, 0);
        uint8_t *form, hash[16], *other;
        size_t n;
        bool inside;
        ck_assert_int_eq(mus__catalogue_form(context, pattern, &form, &n, hash), MUS_OK);
        for (size_t cut = 0; cut < n; cut++) {
            /* just as long as it is, so that a byte too far is seen */
            other = malloc(cut + 1);
            memcpy(other, form, cut);
            ck_assert_int_eq(mus__part_inside(context, form, n, other, cut, &inside), MUS_OK);
            ck_assert_int_eq(mus__part_inside(context, other, cut, form, n, &inside), MUS_OK);
            free(other);
        }
        for (int32_t k = 0; k < 300; k++) {
            other = malloc(n);
            memcpy(other, form, n);
            for (int32_t i = 0; i < 2; i++) other[support_random(&state) % n] = (uint8_t)support_random(&state);
            ck_assert_int_eq(mus__part_inside(context, form, n, other, n, &inside), MUS_OK);
            free(other);
        }
        mus_context_alloc(context, form, 0);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_containment(void);


Suite *mus_suite_containment(void)
{
    Suite *suite = suite_create("containment");
    TCase *tcase = tcase_create("containment");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, a_shirt_contains_its_sleeve_and_a_hood_is_known);
    tcase_add_test(tcase, garments_contain_themselves_with_fewer_seams_and_not_the_other_way);
    tcase_add_test(tcase, damaged_forms_do_no_harm);
    suite_add_tcase(suite, tcase);
    return suite;
}
