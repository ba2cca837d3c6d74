/*
 * test_round_body.c: where panels start: off the body and off each other, facing outwards.
 *
 * Each panel is sampled along its outline and on a lattice inside, and placed as mus_placement says.
 */
#include <stdlib.h>
#include <string.h>

#include "block/drafts.h"

#define STEP 0.012       /* of the lattice [m] */
#define CLEAR 0.005      /* off the body */
#define APART 0.010      /* panels off each other: more than half the diagonal of a cell of the lattice */
#define OUTLINE 4000
#define SAMPLES 20000

typedef struct placed {
    int32_t n;
    double *flat;  /* (n x 2) in the plane of the panel */
    double *x;     /* (n x 3) */
    double *depth; /* (n) */
} placed;


/* place of a panel's point, written from the words of muslin/pattern.h */
static void placed_at(const mus_placement *place, double x, double y, double *out)
{
    double p[3] = {x, y, 0.0};
    if (place->bend != 0.0) {
        const double u = (x - place->bend_x) / place->bend;
        p[0] = place->bend_x + place->bend * sin(u);
        p[2] = place->bend * (cos(u) - 1.0);
    }
    for (int i = 0; i < 3; i++) {
        out[i] = place->origin[i];
        for (int k = 0; k < 3; k++) out[i] += place->rotation[3 * i + k] * p[k];
    }
}


static int32_t placed_outline(const mus_pattern *pattern, int32_t panel, double *out)
{
    int32_t n, count = 0, total = 0;
    const int32_t *edges, *directions;
    ck_assert_int_eq(mus_pattern_outline(pattern, panel, &n, &edges, &directions), MUS_OK);
    for (int32_t e = 0; e < n; e++) {
        double t[40];
        for (int k = 0; k < 40; k++) t[k] = directions[e] > 0 ? k / 40.0 : 1.0 - k / 40.0;
        count = 40;
        ck_assert_int_le(total + count, OUTLINE);
        ck_assert_int_eq(mus_pattern_edge_at(pattern, edges[e], count, t, out + 2 * total), MUS_OK);
        total += count;
    }
    return total;
}


static bool placed_inside(int32_t n, const double *ring, double x, double y)
{
    bool inside = false;
    for (int32_t i = 0, j = n - 1; i < n; j = i++) {
        const double *a = ring + 2 * i, *b = ring + 2 * j;
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
}


static placed placed_make(const mus_pattern *pattern, int32_t panel)
{
    placed out = {0, malloc(2 * SAMPLES * sizeof(double)), malloc(3 * SAMPLES * sizeof(double)),
                  malloc(SAMPLES * sizeof(double))};
    ck_assert(out.flat != NULL && out.x != NULL && out.depth != NULL);
    const int32_t ring = placed_outline(pattern, panel, out.flat);
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    out.n = ring;
    for (int32_t i = 0; i < ring; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], out.flat[2 * i + k]);
            high[k] = fmax(high[k], out.flat[2 * i + k]);
        }
    for (double y = low[1]; y < high[1]; y += STEP)
        for (double x = low[0]; x < high[0]; x += STEP) {
            if (!placed_inside(ring, out.flat, x, y)) continue;
            ck_assert_int_lt(out.n, SAMPLES);
            out.flat[2 * out.n] = x, out.flat[2 * out.n + 1] = y;
            out.n++;
        }
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    ck_assert_int_eq(mus_pattern_placement(pattern, panel, &place), MUS_OK);
    for (int32_t i = 0; i < out.n; i++) placed_at(&place, out.flat[2 * i], out.flat[2 * i + 1], out.x + 3 * i);
    return out;
}


static void placed_free(placed *p)
{
    free(p->flat);
    free(p->x);
    free(p->depth);
}


static double placed_nearest(const mus_body *body, const double *p)
{
    const double *v = mus_body_vertices(body);
    double least = INFINITY;
    for (int32_t i = 0; i < mus_body_vertex_count(body); i++) {
        const double dx = p[0] - v[3 * i], dy = p[1] - v[3 * i + 1], dz = p[2] - v[3 * i + 2];
        least = fmin(least, dx * dx + dy * dy + dz * dz);
    }
    return sqrt(least);
}


/* largest depth; the sample that has it. Depth is of the first order: beside the flat end of a limb it says little of
 * a point that lies far off, whose distance from the vertices of the surface is then asked instead */
static double placed_depth(placed *p, const mus_body *body, int32_t *worst)
{
    ck_assert_int_eq(mus_body_depth(body, p->n, p->x, p->depth, NULL), MUS_OK);
    *worst = 0;
    for (int32_t i = 1; i < p->n; i++) {
        if (p->depth[i] <= p->depth[*worst]) continue;
        if (p->depth[i] > -CLEAR && p->depth[i] < 0.0 && placed_nearest(body, p->x + 3 * i) > 0.015 + CLEAR) continue;
        *worst = i;
    }
    return p->depth[*worst];
}


static double placed_gap(const placed *a, const placed *b)
{
    double least = INFINITY;
    for (int32_t i = 0; i < a->n; i++)
        for (int32_t j = 0; j < b->n; j++) {
            const double *p = a->x + 3 * i, *q = b->x + 3 * j;
            const double dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2];
            least = fmin(least, dx * dx + dy * dy + dz * dz);
        }
    return sqrt(least);
}


START_TEST(panels_start_off_the_body_and_off_each_other)
{
    mus_context *context = support_context();
    const char *size = mus_tape_size_name(_i);
    mus_tape *tape = drafts_tape(context, size);
    mus_body *body;
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    mus_tape_destroy(tape);
    for (int32_t d = 0; d < FIRST; d++) {
        mus_pattern *pattern = drafts_pattern(context, mus_design_name(d), size);
        const int32_t panels = mus_pattern_panel_count(pattern);
        placed sample[8];
        ck_assert_int_le(panels, 8);
        for (int32_t p = 0; p < panels; p++) {
            int32_t worst;
            sample[p] = placed_make(pattern, p);
            const double depth = placed_depth(&sample[p], body, &worst);
            const double *at = sample[p].x + 3 * worst, *flat = sample[p].flat + 2 * worst;
            ck_assert_msg(depth <= -CLEAR, "%s of %s: %s, %.1f mm off the body at (%.3f, %.3f), body (%.3f %.3f %.3f)",
                          mus_design_name(d), size, mus_pattern_panel_name(pattern, p), -1000.0 * depth, flat[0],
                          flat[1], at[0], at[1], at[2]);
        }
        for (int32_t p = 0; p < panels; p++)
            for (int32_t q = 0; q < p; q++) {
                /* halves that are sewn at the centre start there together */
                const char *one = mus_pattern_panel_name(pattern, p), *other = mus_pattern_panel_name(pattern, q);
                if (strncmp(one, other, 5) == 0) continue;
                const double gap = placed_gap(&sample[p], &sample[q]);
                ck_assert_msg(gap >= APART, "%s of %s: %s and %s start %.1f mm from each other", mus_design_name(d),
                              size, one, other, 1000.0 * gap);
            }
        for (int32_t p = 0; p < panels; p++) placed_free(&sample[p]);
        mus_pattern_destroy(pattern);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* a step along the placed panel's normal leads away from the body's axis, so right sides are out */
START_TEST(panels_face_outwards)
{
    static const struct {
        const char *panel;
        double normal[3];
    } list[] = {
        {"front", {0, 0, 1}}, {"back", {0, 0, -1}}, {"sleeve_left", {0.5, 0.5, 0}}, {"sleeve_right", {-0.5, 0.5, 0}}};
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "tshirt", "W40");
    for (int i = 0; i < 4; i++) {
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        ck_assert_int_eq(mus_pattern_placement(pattern, mus_pattern_find_panel(pattern, list[i].panel), &place),
                         MUS_OK);
        const double *r = place.rotation;
        ck_assert_double_gt(r[2] * list[i].normal[0] + r[5] * list[i].normal[1] + r[8] * list[i].normal[2], 0.3);

        /* a rotation: columns of length 1, right-handed */
        const double cross[3] = {r[3] * r[7] - r[6] * r[4], r[6] * r[1] - r[0] * r[7], r[0] * r[4] - r[3] * r[1]};
        for (int k = 0; k < 3; k++) ck_assert_double_eq_tol(cross[k], r[3 * k + 2], 1e-12);
        ck_assert_double_gt(place.bend, 0.0);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* fronts of both sleeves look forward: the front cap starts before the back cap */
START_TEST(sleeve_fronts_are_before_their_backs)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "tshirt", "M50");
    static const char *const panels[] = {"sleeve_left", "sleeve_right"};
    for (int i = 0; i < 2; i++) {
        mus_placement place;
        double front[3], back[3], xy[2], t = 0.5;
        mus_placement_init(&place, sizeof place);
        ck_assert_int_eq(mus_pattern_placement(pattern, mus_pattern_find_panel(pattern, panels[i]), &place), MUS_OK);
        ck_assert_int_eq(mus_pattern_edge_at(pattern, drafts_edge(pattern, panels[i], "capF"), 1, &t, xy), MUS_OK);
        placed_at(&place, xy[0], xy[1], front);
        ck_assert_int_eq(mus_pattern_edge_at(pattern, drafts_edge(pattern, panels[i], "capB"), 1, &t, xy), MUS_OK);
        placed_at(&place, xy[0], xy[1], back);
        ck_assert_double_gt(front[2], back[2] + 2.0 * CM);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_round_body(void)
{
    Suite *suite = suite_create("round_body");
    TCase *tcase = tcase_create("round_body");
    tcase_set_timeout(tcase, 60.0);
    tcase_add_loop_test(tcase, panels_start_off_the_body_and_off_each_other, 0, SUPPORT_SLOW ? 4 : 28);
    tcase_add_test(tcase, panels_face_outwards);
    tcase_add_test(tcase, sleeve_fronts_are_before_their_backs);
    suite_add_tcase(suite, tcase);
    return suite;
}
