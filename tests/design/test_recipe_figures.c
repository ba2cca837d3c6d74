/*
 * test_recipe_figures.c: T-shirt, sleeveless top, bodice block and two skirts had recipes of their own before they were
 * words. Their topology, areas and seam lengths are those that the recipes drafted, within 0.1 mm and 0.01 cm2.
 */
#include <stdlib.h>

#include "block/drafts.h"

#define AREAS 4
#define SEAMS 8
#define LENGTH_TOLERANCE 1e-4 /* [m] */
#define AREA_TOLERANCE 1e-6   /* [m2] */

/* printed by the recipes at commit 3694f0f */
static const struct {
    const char *design, *size;
    int32_t topology[5];  /* V, E, F, Euler, loops */
    double area[AREAS];   /* [m2], ascending; 0: none */
    double length[SEAMS]; /* the different lengths of seams [m], ascending; 0: none */
} figures[] = {
    {"tshirt", "W36", {10, 16, 4, -2, 4}, {0.0561792, 0.0561792, 0.2826665, 0.2929550},
     {0.0908399, 0.1024012, 0.2189814, 0.2286670, 0.4703992}},
    {"tshirt", "W40", {10, 16, 4, -2, 4}, {0.0585068, 0.0585068, 0.3023315, 0.3125327},
     {0.0938613, 0.0950673, 0.2356151, 0.2425216, 0.4646676}},
    {"tshirt", "W46", {10, 16, 4, -2, 4}, {0.0623710, 0.0623710, 0.3307960, 0.3414138},
     {0.0816757, 0.1023933, 0.2634161, 0.2715626, 0.4561669}},
    {"tshirt", "M50", {10, 16, 4, -2, 4}, {0.0650596, 0.0650596, 0.3478389, 0.3595015},
     {0.0999576, 0.1205318, 0.2475581, 0.2564359, 0.4902100}},
    {"tshirt", "C116", {10, 16, 4, -2, 4}, {0.0269678, 0.0269678, 0.1231379, 0.1307429},
     {0.0482645, 0.0543864, 0.1717104, 0.1762141, 0.2773062}},
    {"sleeveless", "W36", {8, 12, 2, -2, 4}, {0.2826665, 0.2929550},
     {0.0908399, 0.4703992}},
    {"sleeveless", "W40", {8, 12, 2, -2, 4}, {0.3023315, 0.3125327},
     {0.0938613, 0.4646676}},
    {"sleeveless", "W46", {8, 12, 2, -2, 4}, {0.3307960, 0.3414138},
     {0.1023933, 0.4561669}},
    {"sleeveless", "M50", {8, 12, 2, -2, 4}, {0.3478389, 0.3595015},
     {0.1205318, 0.4902100}},
    {"sleeveless", "C116", {8, 12, 2, -2, 4}, {0.1231379, 0.1307429},
     {0.0482645, 0.2773062}},
    {"bodice", "W36", {24, 30, 4, -2, 4}, {0.0786107, 0.0786107, 0.0809329, 0.0809329},
     {0.0300815, 0.1206000, 0.1270288, 0.1840585, 0.1941117, 0.1942007, 0.3904634, 0.4125600}},
    {"bodice", "W40", {24, 30, 4, -2, 4}, {0.0845684, 0.0845684, 0.0878122, 0.0878122},
     {0.0300859, 0.1238000, 0.1373778, 0.1784697, 0.1803969, 0.1885281, 0.3933578, 0.4149600}},
    {"bodice", "W46", {24, 30, 4, -2, 4}, {0.0930014, 0.0930014, 0.0970141, 0.0970141},
     {0.0300933, 0.1286000, 0.1540213, 0.1598317, 0.1700873, 0.1801546, 0.3977026, 0.4185600}},
    {"bodice", "M50", {12, 18, 4, -2, 4}, {0.1050166, 0.1050166, 0.1094493, 0.1094493},
     {0.1540500, 0.2128100, 0.3813798, 0.4478100}},
    {"bodice", "C116", {12, 18, 4, -2, 4}, {0.0385456, 0.0385456, 0.0401506, 0.0401506},
     {0.0932400, 0.1047500, 0.2245905, 0.2660000}},
    {"skirt", "W36", {20, 22, 2, 0, 2}, {0.2829375, 0.2963591},
     {0.0907200, 0.1008000, 0.1209600, 0.1370880, 0.6198149, 0.6198169}},
    {"skirt", "W40", {20, 22, 2, 0, 2}, {0.3018381, 0.3151656},
     {0.0907200, 0.1008000, 0.1209600, 0.1370880, 0.6194040, 0.6194056}},
    {"skirt", "W46", {16, 18, 2, 0, 2}, {0.3302017, 0.3432613},
     {0.1008000, 0.1209600, 0.1370880, 0.6188432, 0.6188444}},
    {"skirt", "M50", {12, 14, 2, 0, 2}, {0.3276152, 0.3412955},
     {0.1062000, 0.1444320, 0.6502256, 0.6502268}},
    {"skirt", "C116", {12, 14, 2, 0, 2}, {0.1359793, 0.1447528},
     {0.0617000, 0.0839120, 0.4304049, 0.4304088}},
    {"skirt_plain", "W36", {4, 6, 2, 0, 2}, {0.3036397, 0.3157354},
     {0.6206472, 0.6206475}},
    {"skirt_plain", "W40", {4, 6, 2, 0, 2}, {0.3222492, 0.3343393},
     {0.6184778, 0.6184788}},
    {"skirt_plain", "W46", {4, 6, 2, 0, 2}, {0.3501578, 0.3622425},
     {0.6153888, 0.6153900}},
    {"skirt_plain", "M50", {4, 6, 2, 0, 2}, {0.3503525, 0.3631215},
     {0.6443750, 0.6443764}},
    {"skirt_plain", "C116", {4, 6, 2, 0, 2}, {0.1463676, 0.1547716},
     {0.4275029, 0.4275103}},
};

#define FIGURES ((int)(sizeof figures / sizeof figures[0]))


static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}


START_TEST(words_draft_what_the_recipes_drafted)
{
    const char *design = figures[_i].design, *size = figures[_i].size;
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, design, size);
    mus_topology topology;
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    const int32_t got[5] = {topology.vertices, topology.edges, topology.faces, topology.euler, topology.loops};
    for (int k = 0; k < 5; k++) ck_assert_int_eq(got[k], figures[_i].topology[k]);

    double area[AREAS] = {0.0}, length[128];
    const int32_t panels = mus_pattern_panel_count(pattern);
    ck_assert_int_le(panels, AREAS);
    for (int32_t p = 0; p < panels; p++) area[p] = mus_pattern_panel_area(pattern, p);
    qsort(area, (size_t)panels, sizeof *area, by_value);
    for (int32_t p = 0; p < AREAS; p++)
        ck_assert_msg(fabs(area[p] - figures[_i].area[p]) <= AREA_TOLERANCE, "%s of %s: area %.7f m2, was %.7f", design,
                      size, area[p], figures[_i].area[p]);

    /* every seam has a length of the list, and every length of the list a seam */
    int32_t n = 0, met = 0;
    for (int32_t s = 0; s < mus_pattern_seam_count(pattern); s++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        ck_assert_int_eq(mus_pattern_seam(pattern, s, &seam), MUS_OK);
        length[n++] = mus_pattern_edge_length(pattern, seam.edge_a);
        length[n++] = mus_pattern_edge_length(pattern, seam.edge_b);
    }
    qsort(length, (size_t)n, sizeof *length, by_value);
    for (int32_t i = 0; i < n; i++) {
        while (met + 1 < SEAMS && figures[_i].length[met + 1] > 0.0 &&
               length[i] > 0.5 * (figures[_i].length[met] + figures[_i].length[met + 1]))
            met++;
        ck_assert_msg(fabs(length[i] - figures[_i].length[met]) <= LENGTH_TOLERANCE,
                      "%s of %s: a seam of %.7f m, was %.7f", design, size, length[i], figures[_i].length[met]);
    }
    ck_assert(met + 1 == SEAMS || figures[_i].length[met + 1] == 0.0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_recipe_figures(void);
Suite *mus_suite_recipe_figures(void)
{
    Suite *suite = suite_create("recipe_figures");
    TCase *tcase = tcase_create("recipe_figures");
    tcase_add_loop_test(tcase, words_draft_what_the_recipes_drafted, 0, FIGURES);
    suite_add_tcase(suite, tcase);
    return suite;
}
