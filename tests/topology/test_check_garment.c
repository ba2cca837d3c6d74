/*
 * test_check_garment.c: the mistakes of a sewing table named: twisted, mirrored, missing and loose pieces, closed
 * bags; and sound garments have none of them.
 */
#include "muslin/topology.h"
#include "topology/garments.h"
#include "topology/gluing.h"

#define TEE                                                                                                            \
    "F: hem sideL armL shL neck shR armR sideR; B: hem sideR armR shR neck shL armL sideL;"                            \
    "SL: cuff underB capB capF underF; SR: cuff underF capF capB underB"
#define TEE_BODY "F.sideR B.sideR; F.shL B.shL; F.shR B.shR; F.armL SL.capF; B.armL SL.capB; SL.underF SL.underB"
#define TEE_RIGHT "; F.armR SR.capF; B.armR SR.capB; SR.underF SR.underB"
#define TEE_OPENINGS "hem neck cuff cuff"


/* edges are labelled by their names without L, R, F, B and digits at the end; openings declared */
static mus_pattern *garment_made(mus_context *context, const char *panels, const char *seams, const char *openings)
{
    mus_pattern *pattern = gluing_make(context, panels, seams, 0);
    char label[32];
    int used;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        snprintf(label, sizeof label, "%s", mus_pattern_edge_name(pattern, i));
        for (size_t n = strlen(label); n > 1 && strchr("LRFB0123456789", label[n - 1]) != NULL; n--)
            label[n - 1] = '\0';
        ck_assert_int_eq(mus_pattern_set_edge_label(pattern, i, label), MUS_OK);
    }
    for (const char *at = openings; sscanf(at, " %31s%n", label, &used) == 1; at += used)
        ck_assert_int_eq(mus_pattern_add_opening(pattern, label), MUS_OK);
    return pattern;
}


static const struct {
    const char *name, *panels, *seams, *openings;
    int32_t count, kind[3];
    const char *text; /* of the first fault */
} cases[] = {
    {"a T-shirt", TEE, "F.sideL B.sideL; " TEE_BODY TEE_RIGHT, TEE_OPENINGS, 0, {0}, NULL},
    {"a side seam twisted",
     TEE,
     "F.sideL B.sideL direct; " TEE_BODY TEE_RIGHT,
     TEE_OPENINGS,
     1,
     {MUS_FAULT_TWISTED_SEAM},
     "seam 0: F.sideL and B.sideL are sewn with a twist, the garment has no inside and outside"},
    {"a sleeve left off",
     "F: hem sideL armL shL neck shR armR sideR; B: hem sideR armR shR neck shL armL sideL;"
     "SL: cuff underB capB capF underF",
     "F.sideL B.sideL; " TEE_BODY,
     TEE_OPENINGS,
     1,
     {MUS_FAULT_MISSING_PIECE},
     "a piece with the opening cuff is missing: edges F.armR, B.armR, 0.459 m round, are open in its place"},
    {"a sleeve not attached",
     TEE,
     "F.sideL B.sideL; " TEE_BODY "; SR.underF SR.underB",
     TEE_OPENINGS,
     3,
     {MUS_FAULT_LOOSE_PIECE, MUS_FAULT_OPENING, MUS_FAULT_OPENING},
     "panels SR: no seam joins them to the rest of the garment"},
    {"a hem sewn up",
     TEE,
     "F.sideL B.sideL; F.hem B.hem; " TEE_BODY TEE_RIGHT,
     TEE_OPENINGS,
     1,
     {MUS_FAULT_OPENING},
     "opening hem: it is declared, and the sewn garment has none"},
    {"a hood",
     "FL: cf waist side arm sh neck; BR: cb waist side arm sh neck; FR: neck sh arm side waist cf; BL: neck sh arm "
     "side waist cb; HL: nF nB crown face; HR: face crown nB nF",
     "FL.side BL.side; FL.sh BL.sh; FR.side BR.side; FR.sh BR.sh; BL.cb BR.cb; FL.cf FR.cf; HL.crown HR.crown; HL.nF "
     "FL.neck; HL.nB BL.neck; HR.nF FR.neck; HR.nB BR.neck",
     "waist arm arm face",
     0,
     {0},
     NULL},
    {"a hood cut mirrored",
     "FL: cf waist side arm sh neck; BR: cb waist side arm sh neck; FR: neck sh arm side waist cf; BL: neck sh arm "
     "side waist cb; HL: face crown nB nF; HR: nF nB crown face",
     "FL.side BL.side; FL.sh BL.sh; FR.side BR.side; FR.sh BR.sh; BL.cb BR.cb; FL.cf FR.cf; HL.crown HR.crown; HL.nF "
     "FL.neck; HL.nB BL.neck; HR.nF FR.neck; HR.nB BR.neck",
     "waist arm arm face",
     1,
     {MUS_FAULT_MIRRORED},
     "panels HL, HR: cut mirrored or sewn end for end, the garment has a handle that goes when they are turned over"},
    {"inseams sewn front to front",
     "FL: waist crotch inseam hem out; BR: waist crotch inseam hem out; FR: waist out hem inseam crotch; BL: waist out "
     "hem inseam crotch",
     "FL.out BL.out; FR.out BR.out; FL.crotch FR.crotch; BL.crotch BR.crotch; FL.inseam FR.inseam; BL.inseam BR.inseam",
     "waist hem hem",
     1,
     {MUS_FAULT_OPENING},
     "opening hem: it is declared, and the sewn garment has none"},
    {"a cushion",
     "A: a b c d; B: a b c d",
     "A.a B.a; A.b B.d; A.c B.c; A.d B.b",
     "hem",
     2,
     {MUS_FAULT_CLOSED, MUS_FAULT_OPENING},
     "the seams close 1 bag all round: a pocket or piece without a way in"},
};


START_TEST(mistakes_are_named)
{
    mus_context *context = support_context();
    mus_pattern *pattern = garment_made(context, cases[_i].panels, cases[_i].seams, cases[_i].openings);
    int32_t count, kind;
    mus_faults *faults;
    ck_assert_int_eq(mus_pattern_check(pattern, &count, &faults), MUS_OK);
    const char *text = count > 0 ? mus_faults_text(faults, 0) : "";
    ck_assert_msg(count == cases[_i].count, "%s: %d faults: %s", cases[_i].name, (int)count, text);
    for (int32_t i = 0; i < count; i++) {
        ck_assert_int_eq(mus_faults_item(faults, i, &kind, NULL, NULL, NULL), MUS_OK);
        ck_assert_int_eq(kind, cases[_i].kind[i]);
    }
    if (cases[_i].text != NULL) ck_assert_str_eq(text, cases[_i].text);
    mus_faults_destroy(faults);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_pattern_that_declares_nothing_is_not_judged_as_a_garment)
{
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        mus_pattern *pattern = garment_made(context, cases[i].panels, cases[i].seams, "");
        int32_t count;
        ck_assert_int_eq(mus_pattern_check(pattern, &count, NULL), MUS_OK);
        ck_assert_int_eq(count, cases[i].kind[0] == MUS_FAULT_TWISTED_SEAM);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(every_handle_made_by_turning_panels_over_is_traced_to_panels_that_undo_it)
{
    /* one panel of each sound garment of the tables is sewn in turned over; what is named removes the handle */
    int32_t named = 0, handles = 0;
    mus_context *context = support_context();
    for (int32_t g = 0; g < GARMENTS; g++) {
        const garment *row = &garments[g];
        if (row->genus != 0 || row->loops < 1 || strchr(row->panels, '-') != NULL) continue;
        for (int32_t wrong = 0; wrong < row->faces; wrong++) {
            mus_pattern *sound = gluing_make(context, row->panels, row->seams, 0);
            mus_pattern *pattern = gluing_make(context, row->panels, "", 0);
            for (int32_t i = 0; i < mus_pattern_seam_count(sound); i++) {
                mus_seam_def def;
                mus_seam_def_init(&def, sizeof def);
                ck_assert_int_eq(mus_pattern_seam(sound, i, &def), MUS_OK);
                if ((mus_pattern_edge_panel(sound, def.edge_a) == wrong) !=
                    (mus_pattern_edge_panel(sound, def.edge_b) == wrong))
                    def.direction = 1 - def.direction;
                ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
            }
            ck_assert_int_eq(mus_pattern_add_opening(pattern, "none"), MUS_OK);
            mus_topology t;
            mus_topology_init(&t, sizeof t);
            ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
            ck_assert_int_eq(t.orientable, 1);
            int32_t count, kind, panel;
            mus_faults *faults;
            ck_assert_int_eq(mus_pattern_check(pattern, &count, &faults), MUS_OK);
            for (int32_t i = 0; i < count; i++) {
                ck_assert_int_eq(mus_faults_item(faults, i, &kind, &panel, NULL, NULL), MUS_OK);
                handles += kind == MUS_FAULT_MIRRORED;
                named += kind == MUS_FAULT_MIRRORED && panel != MUS_NONE;
                ck_assert(t.genus > 0 || kind != MUS_FAULT_MIRRORED);
            }
            mus_faults_destroy(faults);
            mus_pattern_destroy(sound);
            mus_pattern_destroy(pattern);
        }
    }
    ck_assert_int_gt(handles, 20);
    ck_assert_int_eq(named, handles);
    support_context_end(context);
}
END_TEST


START_TEST(openings_are_kept_listed_and_refused_with_a_sentence)
{
    mus_context *context = support_context();
    mus_pattern *pattern = garment_made(context, "A: hem side neck back", "A.side A.back", "hem neck"), *copy;
    const char *label;
    ck_assert_int_eq(mus_pattern_copy(pattern, &copy), MUS_OK);
    ck_assert_int_eq(mus_pattern_opening_count(copy), 2);
    ck_assert_str_eq(mus_pattern_opening(copy, 1), "neck");
    ck_assert(mus_pattern_opening(copy, 2) == NULL && mus_pattern_opening(copy, -1) == NULL);
    ck_assert(mus_pattern_opening(NULL, 0) == NULL && mus_pattern_opening_count(NULL) == 0);
    ck_assert_int_eq(mus_pattern_loop_label(copy, 1, &label), MUS_OK);
    ck_assert_str_eq(label, "neck");
    ck_assert_int_eq(mus_pattern_loop_label(copy, 2, &label), MUS_ERR_ARG);
    ck_assert_ptr_null(label);
    ck_assert_int_eq(mus_pattern_loop_label(copy, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_loop_label(NULL, 0, &label), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_opening(copy, ""), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "opening: its label is empty");
    ck_assert_int_eq(mus_pattern_add_opening(copy, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_opening(NULL, "hem"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_opening_count(copy), 2);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(failing_allocations_leave_nothing)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = garment_made(context, cases[6].panels, cases[6].seams, "waist");
        int32_t count;
        support_fail_after(n, false);
        mus_status status = mus_pattern_check(pattern, &count, NULL);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_check_garment(void);


Suite *mus_suite_check_garment(void)
{
    Suite *suite = suite_create("check_garment");
    TCase *tcase = tcase_create("garment");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, mistakes_are_named, 0, (int)(sizeof cases / sizeof cases[0]));
    tcase_add_test(tcase, a_pattern_that_declares_nothing_is_not_judged_as_a_garment);
    tcase_add_test(tcase, every_handle_made_by_turning_panels_over_is_traced_to_panels_that_undo_it);
    tcase_add_test(tcase, openings_are_kept_listed_and_refused_with_a_sentence);
    tcase_add_test(tcase, failing_allocations_leave_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
