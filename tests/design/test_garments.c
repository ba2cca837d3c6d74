/*
 * test_garments.c: every design in every table size as a pattern: no fault, seams that match, the topology that is
 * meant, openings by name, a neckline that the head passes, a hem where it belongs.
 */
#include <string.h>

#include "block/drafts.h"
#include "muslin/topology.h"

#define SIZES 28
#define SEAM_MATCH (0.05 * CM)


START_TEST(every_size_drafts_without_fault_and_seams_match)
{
    mus_context *context = support_context();
    for (int32_t d = 0; d < FIRST; d++) {
        mus_pattern *pattern = drafts_pattern(context, mus_design_name(d), mus_tape_size_name(_i));
        int32_t faults;
        ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
        ck_assert_int_eq(faults, 0);
        for (int32_t s = 0; s < mus_pattern_seam_count(pattern); s++) {
            mus_seam_def seam;
            mus_seam_def_init(&seam, sizeof seam);
            ck_assert_int_eq(mus_pattern_seam(pattern, s, &seam), MUS_OK);
            const double a = mus_pattern_edge_length(pattern, seam.edge_a);
            const double b = mus_pattern_edge_length(pattern, seam.edge_b);
            ck_assert_msg(fabs(b - a - seam.ease) <= SEAM_MATCH, "%s of %s: %s and %s differ by %.3f cm",
                          mus_design_name(d), mus_tape_size_name(_i), mus_pattern_edge_name(pattern, seam.edge_a),
                          mus_pattern_edge_name(pattern, seam.edge_b), (b - a) / CM);
            ck_assert_int_eq(seam.direction, MUS_SEAM_REVERSED);
        }
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/*
 * V, E, F, Euler, loops of the quotients.
 *
 * T-shirt: front and back of 8 edges, two sleeves of 5: 26 edges, 10 seams: E 16; V 10; chi -2; 4 openings.
 * Sleeveless: without the sleeves' 10 edges and 10 points, their 2 underarm and 4 armhole seams: 16 edges, 4 seams:
 *   E 12. 16 points; each of 4 seams joins 2 pairs: V 8. chi = 8 - 12 + 2 = -2; hem, neck, two armholes.
 * Bodice without darts: 4 halves of 6 edges (centre, waist, side, armhole, shoulder, neck): 24 edges, 8 + 2 - 4 = 6
 *   seams (2 shoulders, 2 sides, 2 centres): E 18. 24 points: neck centres 4 to 2, waists at the centre 4 to 2, at
 *   the side 4 to 2, underarms 4 to 2, shoulder points 4 to 2, side necks 4 to 2: V 12. chi = 12 - 18 + 4 = -2.
 * Each dart whose mouth lies on an open edge adds (V, E, F) = (2, 2, 0): its edge falls in two (+1 E, +1 V: the sewn
 *   mouth) and its legs become one inner edge that ends in its point (+1 E, +1 V). So with waist darts in 4 halves
 *   V 20, E 26. A bust dart lies on the side seam: the seam falls in two (+1 E, +1 V: the mouth, one point with that of
 *   the back), and the legs add 1 and 1: with two of them V 24, E 30. chi -2.
 * Skirt without darts: front and back of 4 edges, 2 seams: E 6, V 4, F 2, chi 0; waist and hem. With n darts in front
 *   and behind together: V 4 + 2 n, E 6 + 2 n, chi 0 still. A half of a table size has n = 0, 1 or 2 darts, so a whole
 *   front or back has 2 n: W40 has 8 (V 20, E 22), W52 and M50 4 (V 12, E 14), C56 none.
 */
static const struct {
    const char *design, *size;
    int32_t v, e, f, euler, loops;
} topologies[] = {
    {"tshirt", "W40", 10, 16, 4, -2, 4},  {"tshirt", "M50", 10, 16, 4, -2, 4},  {"tshirt", "C104", 10, 16, 4, -2, 4},
    {"sleeveless", "W40", 8, 12, 2, -2, 4}, {"sleeveless", "M60", 8, 12, 2, -2, 4},
    {"bodice", "W40", 24, 30, 4, -2, 4},  {"bodice", "W34", 24, 30, 4, -2, 4},  {"bodice", "W52", 24, 30, 4, -2, 4},
    {"bodice", "M50", 12, 18, 4, -2, 4},  {"bodice", "C56", 12, 18, 4, -2, 4},
    {"skirt_plain", "W40", 4, 6, 2, 0, 2}, {"skirt_plain", "M50", 4, 6, 2, 0, 2},
    {"skirt_plain", "C152", 4, 6, 2, 0, 2},
    {"skirt", "W40", 20, 22, 2, 0, 2},    {"skirt", "W34", 20, 22, 2, 0, 2},    {"skirt", "W52", 12, 14, 2, 0, 2},
    {"skirt", "M50", 12, 14, 2, 0, 2},    {"skirt", "C104", 12, 14, 2, 0, 2},   {"skirt", "C56", 4, 6, 2, 0, 2},
};


START_TEST(topology_is_the_one_derived_by_hand)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, topologies[_i].design, topologies[_i].size);
    mus_topology topology;
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    ck_assert_int_eq(topology.vertices, topologies[_i].v);
    ck_assert_int_eq(topology.edges, topologies[_i].e);
    ck_assert_int_eq(topology.faces, topologies[_i].f);
    ck_assert_int_eq(topology.euler, topologies[_i].euler);
    ck_assert_int_eq(topology.loops, topologies[_i].loops);
    ck_assert_int_eq(topology.components, 1);
    ck_assert_int_eq(topology.orientable, 1);
    ck_assert_int_eq(topology.manifold, 1);
    ck_assert_int_eq(topology.genus, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* openings of a pattern whose edges all carry `label`; the longest of their girths */
static int32_t garments_openings(const mus_pattern *pattern, const char *label, double *girth)
{
    mus_topology topology;
    int32_t found = 0;
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    *girth = 0.0;
    for (int32_t loop = 0; loop < topology.loops; loop++) {
        int32_t edges[64], count, same = 0;
        double length;
        ck_assert_int_eq(mus_pattern_loop(pattern, loop, edges, 64, &count, &length), MUS_OK);
        ck_assert_int_le(count, 64);
        for (int32_t i = 0; i < count; i++) same += strcmp(mus_pattern_edge_label(pattern, edges[i]), label) == 0;
        ck_assert_msg(same == 0 || same == count, "an opening is %s in %d of %d edges", label, same, count);
        if (same == 0) continue;
        *girth = fmax(*girth, length);
        found++;
    }
    return found;
}


START_TEST(openings_carry_the_names_of_what_passes)
{
    static const struct {
        const char *design, *label;
        int32_t count;
    } list[] = {
        {"tshirt", "hem", 1},        {"tshirt", "neck", 1},     {"tshirt", "cuff", 2},       {"tshirt", "armhole", 0},
        {"sleeveless", "hem", 1},    {"sleeveless", "neck", 1}, {"sleeveless", "armhole", 2}, {"bodice", "waist", 1},
        {"bodice", "neck", 1},       {"bodice", "armhole", 2},  {"skirt", "waist", 1},       {"skirt", "hem", 1},
        {"skirt_plain", "waist", 1}, {"skirt_plain", "hem", 1},
    };
    mus_context *context = support_context();
    double girth;
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        mus_pattern *pattern = drafts_pattern(context, list[i].design, mus_tape_size_name(_i));
        ck_assert_msg(garments_openings(pattern, list[i].label, &girth) == list[i].count, "%s of %s: %s",
                      list[i].design, mus_tape_size_name(_i), list[i].label);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* jersey stretches to 1.15 of its length; the head and 2 cm must pass the neck, the arm and 2 cm the cuff unstretched,
 * the hips (or the bust, by a top) the hem, and the hips the waist of the skirt that has no dart and no zip */
START_TEST(body_passes_the_openings)
{
    mus_context *context = support_context();
    const char *size = mus_tape_size_name(_i);
    const mus__measures measures = drafts_measures(context, size);
    const double *m = measures.v, k = mus__measures_scale(&measures);
    double girth;
    static const char *const tops[] = {"tshirt", "sleeveless"};
    for (int i = 0; i < 2; i++) {
        mus_pattern *pattern = drafts_pattern(context, tops[i], size);
        garments_openings(pattern, "neck", &girth);
        ck_assert_msg(1.15 * girth >= m[MUS_MEASURE_HEAD] + 2.0 * CM, "%s of %s: neck %.1f cm, head %.1f cm", tops[i],
                      size, girth / CM, m[MUS_MEASURE_HEAD] / CM);
        ck_assert_double_le(girth, fmax(1.5 * m[MUS_MEASURE_NECK], (m[MUS_MEASURE_HEAD] + 2.0 * CM) / 1.15 + 1.5 * CM));
        garments_openings(pattern, "hem", &girth);
        ck_assert_double_ge(girth, m[MUS_MEASURE_HIP] + 2.0 * k * CM);
        if (garments_openings(pattern, "cuff", &girth) > 0)
            ck_assert_double_ge(girth, m[MUS_MEASURE_UPPER_ARM] + 1.5 * k * CM);
        mus_pattern_destroy(pattern);
    }
    mus_pattern *pattern = drafts_pattern(context, "skirt_plain", size);
    garments_openings(pattern, "hem", &girth);
    ck_assert_double_ge(girth, m[MUS_MEASURE_HIP] + 3.0 * CM);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


static double garments_lowest(const mus_pattern *pattern, const char *panel)
{
    double low = INFINITY, xy[2];
    int32_t owner;
    for (int32_t p = 0; p < mus_pattern_point_count(pattern); p++) {
        ck_assert_int_eq(mus_pattern_point(pattern, p, &owner, xy), MUS_OK);
        if (owner == mus_pattern_find_panel(pattern, panel)) low = fmin(low, xy[1]);
    }
    return low;
}


/* a T-shirt ends just below the hip; its sleeve covers half the upper arm, and of a small child what the cap asks
 * for */
START_TEST(shirts_end_below_the_hip)
{
    mus_context *context = support_context();
    const mus__measures measures = drafts_measures(context, mus_tape_size_name(_i));
    const double *m = measures.v;
    mus_pattern *pattern = drafts_pattern(context, "tshirt", mus_tape_size_name(_i));
    const double hip = -m[MUS_MEASURE_WAIST_TO_HIP];
    ck_assert_double_le(garments_lowest(pattern, "front"), hip - 0.5 * CM);
    ck_assert_double_ge(garments_lowest(pattern, "front"), hip - 7.0 * CM);
    ck_assert_double_eq(garments_lowest(pattern, "front"), garments_lowest(pattern, "back"));

    /* crown to hem of the sleeve */
    int32_t start, end, owner;
    double crown[2];
    ck_assert_int_eq(mus_pattern_edge_ends(pattern, drafts_edge(pattern, "sleeve_left", "capF"), &start, &end), MUS_OK);
    ck_assert_int_eq(mus_pattern_point(pattern, start, &owner, crown), MUS_OK);
    const double length = crown[1] - garments_lowest(pattern, "sleeve_left");
    ck_assert_double_ge(length, 0.5 * m[MUS_MEASURE_ELBOW]);
    ck_assert_double_le(length, fmax(0.75 * m[MUS_MEASURE_ELBOW], crown[1] + 2.6 * CM));
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* notches that meet: same distance from the common end on both sides of a seam */
START_TEST(pitch_notches_meet)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "tshirt", mus_tape_size_name(_i));
    int32_t met = 0;
    for (int32_t n = 0; n < mus_pattern_notch_count(pattern); n++) {
        int32_t edge, kind, other_edge, other_kind;
        double s, other_s;
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        ck_assert_int_eq(mus_pattern_notch(pattern, n, &edge, &s, &kind), MUS_OK);
        if (mus_pattern_edge_seam(pattern, edge) == MUS_NONE || drafts_joint(pattern, edge, s)) continue;
        ck_assert_int_eq(mus_pattern_seam(pattern, mus_pattern_edge_seam(pattern, edge), &seam), MUS_OK);
        const int32_t partner = seam.edge_a == edge ? seam.edge_b : seam.edge_a;
        for (int32_t k = 0; k < mus_pattern_notch_count(pattern); k++) {
            ck_assert_int_eq(mus_pattern_notch(pattern, k, &other_edge, &other_s, &other_kind), MUS_OK);
            if (other_edge != partner || drafts_joint(pattern, partner, other_s)) continue;
            ck_assert_int_eq(other_kind, kind);
            ck_assert_double_eq_tol(s + other_s, mus_pattern_edge_length(pattern, edge), 1e-6);
            met++;
        }
    }
    /* pitch notches of both armholes, each seen from both edges; the middle of a side that is long enough */
    const double side = mus_pattern_edge_length(pattern, drafts_edge(pattern, "front", "side"));
    ck_assert_int_eq(met, side > 0.24 ? 12 : 8);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(pairs_are_mirror_images)
{
    static const struct {
        const char *design, *one, *other;
    } list[] = {{"tshirt", "sleeve_left", "sleeve_right"},
                {"bodice", "front_left", "front_right"},
                {"bodice", "back_left", "back_right"}};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        mus_pattern *pattern = drafts_pattern(context, list[i].design, "W42");
        const int32_t one = mus_pattern_find_panel(pattern, list[i].one);
        const int32_t other = mus_pattern_find_panel(pattern, list[i].other);
        int32_t count, mirror, n, m;
        const int32_t *edges;
        ck_assert_int_eq(mus_pattern_cut(pattern, one, &count, &mirror), MUS_OK);
        ck_assert_int_eq(count, 2);
        ck_assert_int_eq(mirror, MUS_NONE);
        ck_assert_int_eq(mus_pattern_cut(pattern, other, &count, &mirror), MUS_OK);
        ck_assert_int_eq(mirror, one);

        /* the edge of the same name, walked the other way at -x */
        ck_assert_int_eq(mus_pattern_outline(pattern, one, &n, &edges, NULL), MUS_OK);
        ck_assert_int_eq(mus_pattern_outline(pattern, other, &m, NULL, NULL), MUS_OK);
        ck_assert_int_eq(m, n);
        for (int32_t e = 0; e < n; e++) {
            const double t[3] = {0.0, 0.3, 1.0}, back[3] = {1.0, 0.7, 0.0};
            double p[6], q[6];
            const int32_t twin = mus_pattern_find_edge(pattern, other, mus_pattern_edge_name(pattern, edges[e]));
            ck_assert_int_ne(twin, MUS_NONE);
            ck_assert_int_eq(mus_pattern_edge_at(pattern, edges[e], 3, t, p), MUS_OK);
            ck_assert_int_eq(mus_pattern_edge_at(pattern, twin, 3, back, q), MUS_OK);
            for (int k = 0; k < 3; k++) {
                ck_assert_double_eq_tol(p[2 * k], -q[2 * k], 1e-9);
                ck_assert_double_eq_tol(p[2 * k + 1], q[2 * k + 1], 1e-9);
            }
        }
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_garments(void)
{
    Suite *suite = suite_create("garments");
    TCase *tcase = tcase_create("garments");
    tcase_add_loop_test(tcase, every_size_drafts_without_fault_and_seams_match, 0, SIZES);
    tcase_add_loop_test(tcase, topology_is_the_one_derived_by_hand, 0, (int)(sizeof topologies / sizeof topologies[0]));
    tcase_add_loop_test(tcase, openings_carry_the_names_of_what_passes, 0, SIZES);
    tcase_add_loop_test(tcase, body_passes_the_openings, 0, SIZES);
    tcase_add_loop_test(tcase, shirts_end_below_the_hip, 0, SIZES);
    tcase_add_loop_test(tcase, pitch_notches_meet, 0, SIZES);
    tcase_add_test(tcase, pairs_are_mirror_images);
    suite_add_tcase(suite, tcase);
    return suite;
}
