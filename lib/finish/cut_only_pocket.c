/*
 * cut_only_pocket.c: kangaroo pockets, and the front pockets of trousers: where the front is cut away at the side, the
 * facing of the same cloth that fills the place, and the bag.
 *
 *      centre ------ W ===== S     S is the corner of waist and side; W to B the opening, a line on the leg. The facing
 *             |      |  \    |     reaches under the front, the bag to the hand's depth; both have the waist and the
 *             |      |   `-- B     side of the leg, and are drawn as mirrored pairs.
 *             |   bag        |
 *              `------------'
 *
 * Two of the four bags are cut away along the opening as the front is. Method: FreeSewing 4 (charlie), Aldrich 2008.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "finish/cut_only.h"

#define POCKET_RIM 64           /* most edges of a leg; chosen: twice those of the richest draft */
#define POCKET_CHORDS 12        /* of the opening and of each stretch of waist and side; chosen: 1 cm on paper */
#define POCKET_ACROSS 0.09      /* [m] opening along the waist; chosen, as those below, of the trade's jeans */
#define POCKET_DOWN 0.08        /* [m] and down the side */
#define POCKET_UNDER 0.035      /* [m] the facing lies under the front by, at the waist and at the side */
#define POCKET_DEEP 0.26        /* [m] the bag below the waist: a hand */

#define KANGAROO "kangaroo pocket" /* the mark on the front, and the label of the piece that lies on it */

/* the leg's rim about the corner of waist and side */
typedef struct pocket_leg {
    const mus_pattern *pattern;
    int32_t n, edge[POCKET_RIM], direction[POCKET_RIM];
    int32_t waist; /* rim edge behind the corner, the side is before it */
    mus_status status;
} pocket_leg;


/* the point at s [m] from the corner: along the waist (s > 0) or down the side (s < 0), within one edge of the waist */
static void pocket_at(pocket_leg *leg, double s, double *out)
{
    int32_t i = s >= 0.0 ? leg->waist : (leg->waist + leg->n - 1) % leg->n;
    double length = mus_pattern_edge_length(leg->pattern, leg->edge[i]), rest = fabs(s);
    while (s < 0.0 && rest > length) {
        rest -= length;
        i = (i + leg->n - 1) % leg->n;
        length = mus_pattern_edge_length(leg->pattern, leg->edge[i]);
    }
    double t = fmin(rest / length, 1.0);
    if (s < 0.0) t = 1.0 - t;
    if (leg->direction[i] < 0) t = 1.0 - t;
    if (leg->status == MUS_OK) leg->status = mus_pattern_edge_at(leg->pattern, leg->edge[i], 1, &t, out);
}


static bool pocket_read(const mus__cut_only *job, int32_t panel, pocket_leg *leg)
{
    leg->pattern = job->pattern;
    leg->status = mus_pattern_rim(job->pattern, panel, leg->edge, leg->direction, POCKET_RIM, &leg->n);
    if (leg->status != MUS_OK || leg->n > POCKET_RIM) return false;
    for (leg->waist = 0; leg->waist < leg->n; leg->waist++) {
        const int32_t own = leg->edge[leg->waist], before = leg->edge[(leg->waist + leg->n - 1) % leg->n];
        const char *label = mus_pattern_edge_label(job->pattern, own);
        if (strcmp(mus_pattern_edge_label(job->pattern, before), "side") == 0 &&
            (strcmp(label, "band") == 0 || strcmp(label, "waist") == 0))
            return true;
    }
    return false;
}


/* points of a curve from p down and then out to q, as an opening runs; `corner` is that of waist and side */
static void pocket_curve(const double *p, const double *q, const double *corner, double (*out)[2])
{
    const double bend[2] = {p[0] + 0.9 * (q[0] - corner[0]), p[1] + 0.9 * (q[1] - corner[1])};
    for (int32_t k = 0; k <= POCKET_CHORDS; k++) {
        const double t = (double)k / POCKET_CHORDS, u = 1.0 - t;
        for (int32_t i = 0; i < 2; i++) out[k][i] = u * u * p[i] + 2.0 * u * t * bend[i] + t * t * q[i];
    }
}


/* begin a piece at the corner and go along the waist to `across` */
static void pocket_begin(pocket_leg *leg, double across, mus__cut_shape *shape)
{
    double p[2];
    pocket_at(leg, 0.0, p);
    mus__cut_shape_begin(shape, "bag", p[0], p[1]);
    for (int32_t k = 1; k <= POCKET_CHORDS; k++) {
        pocket_at(leg, across * k / POCKET_CHORDS, p);
        mus__cut_shape_to(shape, p[0], p[1]);
    }
    mus__cut_shape_edge(shape, "waist", "", MUS__SEAM_ALLOWANCE);
}


/* go up the side from `down` to the corner */
static void pocket_end(pocket_leg *leg, double down, mus__cut_shape *shape)
{
    double p[2];
    for (int32_t k = POCKET_CHORDS - 1; k >= 0; k--) {
        pocket_at(leg, -fmax(down * k / POCKET_CHORDS, 1e-9), p);
        if (k > 0) mus__cut_shape_to(shape, p[0], p[1]);
        else mus__cut_shape_to(shape, shape->xy[0][0], shape->xy[0][1]);
    }
    mus__cut_shape_edge(shape, "side", "", MUS__SEAM_ALLOWANCE);
}


void mus__cut_kangaroo(mus__cut_only *job)
{
    static const char *const names[5] = {"top", "opening", "side", "low", "centre"};
    const double *xy = NULL;
    int32_t panel = MUS_NONE;
    for (int32_t i = 0; i < mus_pattern_mark_count(job->pattern) && xy == NULL; i++) {
        const char *name;
        int32_t n;
        const double *own;
        if (mus_pattern_mark(job->pattern, i, &panel, &name, &n, &own) != MUS_OK || n != 5) continue;
        if (strcmp(name, KANGAROO) == 0 && own[2] > own[0]) xy = own;
    }
    if (xy == NULL) return;

    /* counter-clockwise: from the centre below out, up and back; whole on the fold, or a half for each front */
    const bool whole = mus_pattern_find_panel(job->pattern, "front_left") == MUS_NONE;
    mus__cut_shape shape;
    mus__cut_shape_begin(&shape, KANGAROO, whole ? -xy[6] : xy[8], xy[9]);
    for (int32_t i = 3; i >= 0; i--) {
        if (whole && i == 0) continue;
        mus__cut_shape_to(&shape, xy[2 * i], xy[2 * i + 1]);
        mus__cut_shape_edge(&shape, names[i], names[i], i == 1 ? MUS__HEM_ALLOWANCE : MUS__SEAM_ALLOWANCE);
    }
    for (int32_t i = 1; whole && i < 4; i++) {
        static const char *const mirrored[4] = {"", "top", "opening_r", "side_r"};
        mus__cut_shape_to(&shape, -xy[2 * i], xy[2 * i + 1]);
        mus__cut_shape_edge(&shape, mirrored[i], names[i - 1], i == 2 ? MUS__HEM_ALLOWANCE : MUS__SEAM_ALLOWANCE);
    }
    if (whole) {
        mus__cut_shape_add(job, &shape, "kangaroo_pocket", MUS_MATERIAL_MAIN, 1);
        return;
    }
    mus__cut_shape_to(&shape, xy[8], xy[9]);
    mus__cut_shape_edge(&shape, "centre", "", MUS__SEAM_ALLOWANCE);
    mus__cut_shape_pair(job, &shape, "kangaroo_pocket", MUS_MATERIAL_MAIN, 1);
}


void mus__cut_front_pocket(mus__cut_only *job, mus_pattern *pattern)
{
    pocket_leg leg;
    mus__cut_shape shape;
    const int32_t legs[2] = {mus_pattern_find_panel(pattern, "leg_front_left"),
                             mus_pattern_find_panel(pattern, "leg_front_right")};
    if (job->status != MUS_OK || legs[0] == MUS_NONE) return;
    if (!pocket_read(job, legs[0], &leg)) {
        job->status = leg.status;
        return;
    }
    const double k = job->scale, room = mus_pattern_edge_length(pattern, leg.edge[leg.waist]);
    const double under = fmin(POCKET_UNDER * k, 0.3 * room), across = fmin(POCKET_ACROSS * k, 0.95 * room - under);
    const double down = POCKET_DOWN * k, deep = POCKET_DEEP * k;
    double corner[2], w[2], b[2], curve[POCKET_CHORDS + 1][2];

    /* the opening, on both fronts and on the bag */
    pocket_at(&leg, 0.0, corner);
    pocket_at(&leg, across, w);
    pocket_at(&leg, -down, b);
    double line[POCKET_CHORDS + 1][2], mirrored[POCKET_CHORDS + 1][2];
    pocket_curve(w, b, corner, line);
    for (int32_t i = 0; i <= POCKET_CHORDS; i++) mirrored[i][0] = -line[i][0], mirrored[i][1] = line[i][1];

    /* facing */
    pocket_begin(&leg, across + under, &shape);
    pocket_at(&leg, across + under, w);
    pocket_at(&leg, -(down + under), b);
    pocket_curve(w, b, corner, curve);
    for (int32_t i = 1; i <= POCKET_CHORDS; i++) mus__cut_shape_to(&shape, curve[i][0], curve[i][1]);
    mus__cut_shape_edge(&shape, "inner", "", MUS__SEAM_ALLOWANCE);
    pocket_end(&leg, down + under, &shape);
    mus__cut_shape_pair(job, &shape, "pocket_facing", MUS_MATERIAL_MAIN, 1);

    /* bag: straight down, round at the bottom, out to the side */
    const double low = corner[1] - deep;
    pocket_begin(&leg, across + under, &shape);
    pocket_at(&leg, -0.85 * deep, b);
    mus__cut_shape_to(&shape, w[0], low + 0.03 * k);
    for (int32_t i = 1; i <= POCKET_CHORDS; i++) {
        const double t = (double)i / POCKET_CHORDS, u = 1.0 - t;
        mus__cut_shape_to(&shape, u * u * w[0] + 2.0 * u * t * (w[0] + 0.02 * k) + t * t * b[0],
                          u * u * (low + 0.03 * k) + 2.0 * u * t * (low - 0.02 * k) + t * t * b[1]);
    }
    mus__cut_shape_edge(&shape, "inner", "", MUS__SEAM_ALLOWANCE);
    pocket_end(&leg, 0.85 * deep, &shape);
    mus__cut_shape_pair(job, &shape, "pocket_bag", MUS_MATERIAL_LINING, 2);
    if (job->status == MUS_OK) job->status = leg.status;
    for (int32_t i = 0; i < 4 && job->status == MUS_OK; i++) {
        static const char *const bags[2] = {"pocket_bag_left", "pocket_bag_right"};
        const int32_t panel = i < 2 ? legs[i] : mus_pattern_find_panel(job->made, bags[i - 2]);
        if (panel != MUS_NONE)
            job->status = mus_pattern_add_mark(i < 2 ? pattern : job->made, panel, "pocket opening", POCKET_CHORDS + 1,
                                               i % 2 == 0 ? line[0] : mirrored[0], NULL);
    }
}
