/*
 * test_sewing.c: the order of sewing of all designs, against the homology of the sewn pattern and the habits of a
 * workshop; the text of a garment that is small enough to be written by hand.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "block/drafts.h"
#include "muslin/topology.h"
#include "sewing/sewing.h"


static bool is_part(const mus_pattern *pattern, int32_t panel, const char *label)
{
    return strcmp(mus_pattern_panel_label(pattern, panel), label) == 0;
}


static bool is_edge(const mus_pattern *pattern, int32_t edge, const char *label)
{
    return strcmp(mus_pattern_edge_label(pattern, edge), label) == 0;
}


/* what each step claims adds up to the sewn surface, whose Betti numbers are found by Smith's normal form */
static void check_surface(const mus_pattern *pattern, const mus__sewing *sewing, const char *name)
{
    int32_t rings = 0, joins = 0;
    mus_homology sewn;
    mus_homology_init(&sewn, sizeof sewn);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, &sewn, NULL, 0), MUS_OK);
    for (int32_t i = 0; i < sewing->nstep; i++) {
        rings += sewing->steps[i].rings;
        joins += sewing->steps[i].joins;
        if (i > 0) ck_assert_msg(sewing->steps[i - 1].kind <= sewing->steps[i].kind, "%s: step %d", name, (int)i);
    }
    ck_assert_msg(joins == mus_pattern_panel_count(pattern) - sewn.betti[0], "%s: %d parts joined", name, (int)joins);
    ck_assert_msg(rings == sewn.betti[1] - sewn.betti[2], "%s: %d rings, homology says %d", name, (int)rings,
                  (int)(sewn.betti[1] - sewn.betti[2]));
}


/* a shoulder comes before the cap of the sleeve that crosses it, and a cap before its sleeve is a tube */
static int32_t check_habits(const mus_pattern *pattern, const mus__sewing *sewing, const char *name)
{
    int32_t first_cap = sewing->nstep, last_cap = -1, last_shoulder = -1, first_tube = sewing->nstep;
    for (int32_t i = 0; i < sewing->n; i++) {
        const mus__sewn *seam = &sewing->sewn[i];
        const bool arm[2] = {is_part(pattern, seam->panel[0], "arm"), is_part(pattern, seam->panel[1], "arm")};
        const bool hole = is_edge(pattern, seam->edge[arm[0]], "armhole");
        ck_assert_msg(seam->step >= 0 && seam->step < sewing->nstep, "%s: seam %d is not sewn", name, (int)i);
        if (seam->kind != MUS__SEWING_SEAM) continue;
        if (is_edge(pattern, seam->edge[0], "shoulder") && is_edge(pattern, seam->edge[1], "shoulder"))
            last_shoulder = seam->step > last_shoulder ? seam->step : last_shoulder;
        if (arm[0] != arm[1] && hole) {
            first_cap = seam->step < first_cap ? seam->step : first_cap;
            last_cap = seam->step > last_cap ? seam->step : last_cap;
        }
        if (arm[0] && seam->panel[0] == seam->panel[1]) first_tube = seam->step < first_tube ? seam->step : first_tube;
    }
    ck_assert_msg(last_shoulder < first_cap || last_cap < 0, "%s: a cap before its shoulder", name);
    ck_assert_msg(last_cap < first_tube, "%s: a sleeve is closed before its cap is sewn", name);
    return last_cap >= 0;
}


/* ---- crossings: four ends of seams at one point of the sewn garment ---- */

typedef struct crossing {
    int32_t n;
    const mus__sewn *seam[4];
    int32_t end[4];
} crossing;


static int32_t root_of(const int32_t *link, int32_t i)
{
    while (link[i] != i) i = link[i];
    return i;
}


/* do two ends lie at no common corner of a panel? */
static bool opposite(const crossing *at, int32_t i, int32_t k)
{
    const int32_t *a = at->seam[i]->point[at->end[i]], *b = at->seam[k]->point[at->end[k]];
    return a[0] != b[0] && a[0] != b[1] && a[1] != b[0] && a[1] != b[1];
}


/* is a seam across a pair sewn between the two of the pair? */
static bool between(const crossing *at, int32_t a, int32_t b, int32_t across)
{
    const int32_t first = at->seam[a]->step, last = at->seam[b]->step, step = at->seam[across]->step;
    return (first < step && step < last) || (last < step && step < first);
}


/* where two lines of stitching cross, both parts of the one come before both of the other: the sides of a band and of a
 * skirt before the band is sewn on, or the band to each panel before the sides. Returns how many cross */
static int32_t check_crossings(const mus_pattern *pattern, const mus__sewing *sewing, const char *name)
{
    const int32_t n = mus_pattern_point_count(pattern);
    int32_t crossed = 0, *link = malloc((size_t)n * sizeof *link);
    crossing *at = calloc((size_t)n, sizeof *at);
    for (int32_t i = 0; i < n; i++) link[i] = i;
    for (int32_t i = 0; i < 2 * sewing->n; i++) {
        const int32_t *pair = sewing->sewn[i / 2].point[i % 2];
        link[root_of(link, pair[0])] = root_of(link, pair[1]);
    }
    for (int32_t i = 0; i < 2 * sewing->n; i++) {
        const mus__sewn *seam = &sewing->sewn[i / 2];
        crossing *own = &at[root_of(link, seam->point[i % 2][0])];
        if (own->n < 4) own->seam[own->n] = seam, own->end[own->n] = i % 2;
        own->n++;
    }
    for (int32_t i = 0; i < n; i++) {
        bool seams = at[i].n == 4;
        for (int32_t k = 0; k < 4 && seams; k++) seams = at[i].seam[k]->kind == MUS__SEWING_SEAM;
        for (int32_t k = 1; k < 4 && seams; k++) {
            const int32_t c = k == 1 ? 2 : 1, d = 6 - k - c;
            if (!opposite(&at[i], 0, k) || !opposite(&at[i], c, d)) continue;
            crossed++;
            ck_assert_msg(!between(&at[i], 0, k, c) && !between(&at[i], 0, k, d) && !between(&at[i], c, d, 0) &&
                              !between(&at[i], c, d, k),
                          "%s: %s and %s are sewn apart", name, at[i].seam[0]->phrase, at[i].seam[k]->phrase);
        }
    }
    free(at);
    free(link);
    return crossed;
}


/* both edges of a seam are cut with one allowance, so that raw edges meet; 10 mm where the sheet sets it */
static void check_allowances(const mus_pattern *pattern, const char *name)
{
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        ck_assert_int_eq(mus_pattern_seam(pattern, i, &def), MUS_OK);
        if (def.laid || def.closure != MUS_CLOSURE_NONE) continue;
        double width[2];
        for (int32_t k = 0; k < 2; k++) {
            const double own = mus_pattern_edge_allowance(pattern, k == 0 ? def.edge_a : def.edge_b);
            width[k] = own >= 0.0 ? own : 0.01;
        }
        ck_assert_msg(width[0] == width[1], "%s: %s has %.1f mm and %.1f mm", name,
                      mus_pattern_edge_name(pattern, def.edge_a), 1e3 * width[0], 1e3 * width[1]);
    }
}


START_TEST(every_design_is_sewn_as_a_workshop_sews)
{
    int32_t sleeved = 0, crossed = 0;
    const int32_t step = SUPPORT_SLOW ? 7 : 1;
    mus_context *context = support_context();
    for (int32_t d = 0; d < mus_design_count(); d += step) {
        static const char *const sizes[] = {"W40", "M50", "C116"};
        mus_pattern *pattern = NULL;
        for (int32_t s = 0; s < 3 && pattern == NULL; s++) {
            mus_tape *tape = drafts_tape(context, sizes[s]);
            mus_design_draft(context, d, tape, NULL, &pattern);
            mus_tape_destroy(tape);
        }
        ck_assert_ptr_nonnull(pattern);
        mus__sewing sewing;
        ck_assert_int_eq(mus__sewing_make(context, pattern, &sewing), MUS_OK);
        ck_assert_int_eq(mus__sewing_order(&sewing), MUS_OK);
        check_surface(pattern, &sewing, mus_design_name(d));
        sleeved += check_habits(pattern, &sewing, mus_design_name(d));
        check_allowances(pattern, mus_design_name(d));
        crossed += check_crossings(pattern, &sewing, mus_design_name(d));
        mus__sewing_free(&sewing);
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_ge(sleeved, 300 / step);
    ck_assert_int_ge(crossed, 1000 / step);
    support_context_end(context);
}
END_TEST


/* ---- a skirt of two rectangles, 0.5 m wide, with a zip on the left side and a gathered back ---- */

static int32_t rectangle(mus_pattern *pattern, const char *name, double width, double height)
{
    static const char *const labels[] = {"hem", "side", "waist", "side"};
    static const char *const names[] = {"hem", "side_left", "waist", "side_right"};
    const double corners[4][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    int32_t panel, point[4], edge[4], on[4] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corners[i][0], corners[i][1], &point[i]), MUS_OK);
    for (int32_t i = 0; i < 4; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.name = names[i];
        def.start = point[i];
        def.end = point[(i + 1) % 4];
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edge[i]), MUS_OK);
        ck_assert_int_eq(mus_pattern_set_edge_label(pattern, edge[i], labels[i]), MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edge, on), MUS_OK);
    return edge[0];
}


static mus_pattern *skirt(mus_context *context)
{
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "skirt", &pattern), MUS_OK);
    const int32_t front = rectangle(pattern, "skirt_front", 0.5, 0.6),
                  back = rectangle(pattern, "skirt_back", 0.7, 0.6);
    const int32_t band = rectangle(pattern, "band", 1.0, 0.04);
    const struct {
        int32_t a, b, closure;
        double ease;
    } seams[] = {{front + 1, back + 3, MUS_CLOSURE_ZIP, 0.0},
                 {front + 3, back + 1, MUS_CLOSURE_NONE, 0.0},
                 {front + 2, band, MUS_CLOSURE_NONE, 0.5}};
    for (size_t i = 0; i < sizeof seams / sizeof seams[0]; i++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        def.edge_a = seams[i].a;
        def.edge_b = seams[i].b;
        def.closure = seams[i].closure;
        def.ease = seams[i].ease;
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_add_notch(pattern, front + 3, 0.2, MUS_NOTCH_SINGLE, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_notch(pattern, back + 1, 0.4, MUS_NOTCH_SINGLE, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, front, 0.03), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, back, 0.03), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_elastic(pattern, back + 2, 0.8, 60.0), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, back + 2, 0.025), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_material(pattern, 2, MUS_MATERIAL_MAIN, 2), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_material(pattern, 2, MUS_MATERIAL_INTERFACING, 1), MUS_OK);
    return pattern;
}


static const char *const skirt_text =
    "A skirt\n"
    "\n"
    "Pieces\n"
    "- skirt front: cut 1\n"
    "- skirt back: cut 1\n"
    "- band: cut 2 + 1 interfacing\n"
    "\n"
    "Cloth\n"
    "- main cloth, 1.14 m wide: 1.45 m; 1.40 m wide: 0.80 m\n"
    "- interfacing, 1.14 m wide: 0.10 m; 1.40 m wide: 0.10 m\n"
    "\n"
    "Notions\n"
    "- a zip for an opening of 60.0 cm\n"
    "\n"
    "Sewing, on the lines of short dashes, right sides together unless a step says otherwise\n"
    "Neaten the raw edges and press each seam before another crosses it; sew a knit with a stretch or a zigzag stitch. "
    "Turn the raw edge of a hem that frays under first.\n"
    "1. Fuse the interfacing to: band.\n"
    "2. Sew the layers of band to each other, right sides together, along: side, waist. Turn and press; from here on "
    "they are one, and what is seen in wear lies outside.\n"
    "3. Sew:\n"
    "   - skirt back to skirt front at the side, 60.0 cm, 1 notch\n"
    "4. Sew:\n"
    "   - band (hem) to skirt front (waist), 50.0 cm; gather the band from 100.0 cm: two rows of long stitches "
    "within the allowance, drawn up evenly\n"
    "5. Close:\n"
    "   - set in the zip: skirt back to skirt front at the side, 60.0 cm\n"
    "6. Finish the waist of skirt back, 70.0 cm in all: turn 25 mm to the wrong side and stitch, with a gap; draw the "
    "elastic in, sew its ends together edge to edge and close the gap.\n"
    "7. Finish the hem of skirt back, skirt front, 120.0 cm in all: turn 30 mm to the wrong side and stitch.\n";


START_TEST(the_text_of_a_skirt)
{
    mus_context *context = support_context();
    mus_pattern *pattern = skirt(context);
    char *bytes, path[512];
    size_t size, read;
    ck_assert_int_eq(mus_pattern_write_instructions_bytes(pattern, "A skirt", &bytes, &size), MUS_OK);
    char *text = calloc(size + 1, 1);
    memcpy(text, bytes, size);
    ck_assert_str_eq(text, skirt_text);
    free(text);
    mus_context_alloc(context, bytes, 0);
    ck_assert_int_eq(
        mus_pattern_write_instructions(pattern, "A skirt", support_scratch("skirt.txt", path, sizeof path)), MUS_OK);
    text = support_slurp(path, &read);
    ck_assert_str_eq(text, skirt_text);
    free(text);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* ---- two strips, 10 x 80 cm, below a band that is sewn to both: the seam of the strips is the longer one ---- */

static int32_t polygon(mus_pattern *pattern, const char *name, int32_t n, const double *xy)
{
    int32_t panel, point[8], edge[8], on[8];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int32_t i = 0; i < n; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &point[i]), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.start = point[i];
        def.end = point[(i + 1) % n];
        on[i] = 1;
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edge[i]), MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, n, edge, on), MUS_OK);
    return edge[0];
}


START_TEST(a_line_waits_for_the_seam_that_it_crosses)
{
    static const double strip[] = {0.0, 0.0, 0.1, 0.0, 0.1, 0.8, 0.0, 0.8};
    static const double band[] = {0.0, 0.0, 0.1, 0.0, 0.2, 0.0, 0.2, 0.05, 0.0, 0.05};
    mus_context *context = support_context();
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "strips", &pattern), MUS_OK);
    const int32_t left = polygon(pattern, "a", 4, strip), right = polygon(pattern, "b", 4, strip);
    const int32_t low = polygon(pattern, "band", 5, band);
    const int32_t pairs[3][2] = {{low, left + 2}, {low + 1, right + 2}, {left + 1, right + 3}};
    for (int32_t i = 0; i < 3; i++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        def.edge_a = pairs[i][0];
        def.edge_b = pairs[i][1];
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
    }
    mus__sewing sewing;
    ck_assert_int_eq(mus__sewing_make(context, pattern, &sewing), MUS_OK);
    ck_assert_int_eq(mus__sewing_order(&sewing), MUS_OK);
    ck_assert_int_eq(sewing.nstep, 2);
    ck_assert_int_eq(sewing.sewn[2].step, 0);
    for (int32_t i = 0; i < 2; i++) ck_assert_int_eq(sewing.sewn[i].step, 1); /* the band in one stitching */
    mus__sewing_free(&sewing);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(seams_without_names_are_no_twins)
{
    static const double sheet[] = {0.0, 0.0, 0.5, 0.0, 0.5, 0.6, 0.0, 0.6};
    mus_context *context = support_context();
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "tube", &pattern), MUS_OK);
    const int32_t front = polygon(pattern, "front", 4, sheet), back = polygon(pattern, "back", 4, sheet);
    for (int32_t i = 0; i < 2; i++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        def.edge_a = front + (i == 0 ? 1 : 3);
        def.edge_b = back + (i == 0 ? 3 : 1);
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
    }
    mus__sewing sewing;
    ck_assert_int_eq(mus__sewing_make(context, pattern, &sewing), MUS_OK);
    ck_assert_int_eq(mus__sewing_order(&sewing), MUS_OK);
    ck_assert_int_eq(sewing.nstep, 2); /* the first lies flat, the second closes the tube */
    for (int32_t i = 0; i < 2; i++) {
        ck_assert_int_eq(sewing.sewn[i].twins, 1);
        ck_assert_int_eq(sewing.steps[i].rings, i);
    }
    mus__sewing_free(&sewing);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(an_empty_pattern_has_no_steps)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    char *bytes;
    size_t size;
    ck_assert_int_eq(mus_pattern_create(context, "nothing", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_write_instructions_bytes(pattern, NULL, &bytes, &size), MUS_OK);
    ck_assert_int_eq(memcmp(bytes, "nothing\n", 8), 0);
    mus_context_alloc(context, bytes, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_failure_has_a_status_and_leaves_nothing)
{
    mus_context *context = support_context();
    mus_pattern *pattern = skirt(context);
    char *bytes;
    size_t size;
    ck_assert_int_eq(mus_pattern_write_instructions(NULL, NULL, "/tmp/none"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_write_instructions(pattern, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_write_instructions(pattern, NULL, "/no/such/folder/a.txt"), MUS_ERR_FILE);
    for (int64_t n = 0;; n += SUPPORT_SLOW ? 13 : 1) { /* each lays the pieces on cloth */
        support_fail_after(n, false);
        const mus_status status = mus_pattern_write_instructions_bytes(pattern, NULL, &bytes, &size);
        support_fail_never();
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_ptr_null(bytes);
    }
    mus_context_alloc(context, bytes, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(names_are_words)
{
    static const char *const names[][3] = {{"sleeve_left", "sleeve", "sleeve left"},
                                           {"capF_low", "cap front low", "cap front low"},
                                           {"side_r", "side", "side r"},
                                           {"", "", ""},
                                           {"left", "left", "left"},
                                           {"--", "--", "--"},
                                           {"F", "F", "F"},
                                           {"rightLeg2", "Leg2", "right Leg2"},
                                           {"\xc3\xa4rmel", "\xc3\xa4rmel", "\xc3\xa4rmel"}};
    char out[MUS__PLAIN], longest[4 * MUS__PLAIN];
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        mus__plain_words(names[i][0], true, out);
        ck_assert_str_eq(out, names[i][1]);
        mus__plain_words(names[i][0], false, out);
        ck_assert_str_eq(out, names[i][2]);
    }
    memset(longest, 'a', sizeof longest);
    longest[sizeof longest - 1] = '\0';
    mus__plain_words(longest, true, out);
    ck_assert_uint_eq(strlen(out), MUS__PLAIN - 2); /* cut: room for a space and the zero byte */
    memset(longest, '\xa4', sizeof longest - 1);
    for (size_t i = 0; i + 1 < sizeof longest; i += 2) longest[i] = '\xc3';
    mus__plain_words(longest, true, out);
    ck_assert_uint_eq(strlen(out) % 2, 0); /* letters of two bytes stay whole */
}
END_TEST


Suite *mus_suite_sewing(void);
Suite *mus_suite_sewing(void)
{
    Suite *suite = suite_create("sewing");
    TCase *tcase = tcase_create("sewing");
    tcase_set_timeout(tcase, 60.0);
    tcase_add_test(tcase, every_design_is_sewn_as_a_workshop_sews);
    tcase_add_test(tcase, the_text_of_a_skirt);
    tcase_add_test(tcase, a_line_waits_for_the_seam_that_it_crosses);
    tcase_add_test(tcase, seams_without_names_are_no_twins);
    tcase_add_test(tcase, an_empty_pattern_has_no_steps);
    tcase_add_test(tcase, a_failure_has_a_status_and_leaves_nothing);
    tcase_add_test(tcase, names_are_words);
    suite_add_tcase(suite, tcase);
    return suite;
}
