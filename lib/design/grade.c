/*
 * grade.c: one design in several sizes: grade rules between two drafts, rules applied, and the ease of a draft.
 *
 * Each size is drafted anew, which is exact. A grade rule is the displacement of a point of an outline from one draft
 * to the next; factories exchange them. When rules are applied, the ends of an edge move by their rules, and the points
 * between them by the mean of both, weighted by the arc length along the edge.
 *
 * Ease is the girth of the garment at a level less that of the body. The girth is the length of a horizontal cut
 * through all panels that are placed upright; sleeves lie along the arm and are skipped. Darts are open in the pattern,
 * so their intake is not counted.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "board/board_curve.h"
#include "design/draft.h"

#define GRADE_CHORDS 16
#define GRADE_UPRIGHT 0.999  /* cosine between y of a panel and the vertical */
#define GRADE_WINDOW 0.04    /* the fullest level is looked for so far above and below that of the body [m] */
#define GRADE_EDGE 0.002     /* so far off an edge that lies level [m] */
#define GRADE_LEAST 0.2      /* a garment is not narrower than the body by more than this part of it */
#define GRADE_CUTS 64        /* places where a level meets an outline */
#define GRADE_LINE 512       /* points of an edge as chords */


/* ---- rules ---- */

/* rules of the points of one panel: ends of edges that both patterns have by name */
static void grade_panel_rules(const mus_pattern *from, const mus_pattern *to, int32_t panel, double *rules,
                              int32_t *count)
{
    const int32_t twin = mus_pattern_find_panel(to, from->panel[panel].name);
    const mus__panel *p = &from->panel[panel];
    for (int32_t i = 0; i < p->noutline && twin != MUS_NONE; i++) {
        const mus__edge *edge = &from->edge[p->outline[i]];
        const int32_t other = mus_pattern_find_edge(to, twin, edge->name);
        if (other == MUS_NONE) continue;
        const int32_t ends[2][2] = {{edge->start, to->edge[other].start}, {edge->end, to->edge[other].end}};
        for (int32_t e = 0; e < 2; e++) {
            const double *a = from->point[ends[e][0]].xy, *b = to->point[ends[e][1]].xy;
            double *rule = rules + 2 * ends[e][0];
            if (isnan(rule[0])) ++*count;
            rule[0] = b[0] - a[0];
            rule[1] = b[1] - a[1];
        }
    }
}


mus_status mus_design_grade(const mus_pattern *from, const mus_pattern *to, double *rules, int32_t *count)
{
    int32_t n = 0;
    if (count != NULL) *count = 0;
    if (from == NULL) return MUS_ERR_ARG;
    if (to == NULL || rules == NULL)
        return mus__fail(mus_pattern_context(from), MUS_ERR_ARG, "grade: to or rules is NULL");
    for (int32_t i = 0; i < 2 * mus_pattern_point_count(from); i++) rules[i] = NAN;
    for (int32_t p = 0; p < mus_pattern_panel_count(from); p++) grade_panel_rules(from, to, p, rules, &n);
    if (count != NULL) *count = n;
    return MUS_OK;
}


/* a side with its ends moved, and what lies between by a mean of both */
static void grade_move_side(mus__board_side *side, const double *start, const double *end)
{
    double *xy = side->chain.xy, length = 0.0, run = 0.0, last[2];
    const int32_t n = side->chain.nxy;
    for (int32_t i = 1; i < n; i++) length += mus__hypot(xy[2 * i] - xy[2 * i - 2], xy[2 * i + 1] - xy[2 * i - 1]);
    memcpy(last, xy, sizeof last);
    for (int32_t i = 0; i < n; i++) {
        run += mus__hypot(xy[2 * i] - last[0], xy[2 * i + 1] - last[1]);
        memcpy(last, xy + 2 * i, sizeof last);

        /* the ends by their own rule alone, so that neighbours meet to the bit */
        const double t = i == n - 1 ? 1.0 : run / length;
        xy[2 * i] += i == n - 1 ? end[0] : (1.0 - t) * start[0] + t * end[0];
        xy[2 * i + 1] += i == n - 1 ? end[1] : (1.0 - t) * start[1] + t * end[1];
    }
    side->length = mus__board_chain_length(&side->chain);
}


mus_status mus_design_grade_apply(const mus_pattern *pattern, const double *rules, mus_pattern **out)
{
    mus__board board;
    if (out != NULL) *out = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    if (rules == NULL || out == NULL) return mus__fail(context, MUS_ERR_ARG, "grade: rules or out is NULL");
    for (int32_t i = 0; i < mus_pattern_point_count(pattern); i++)
        if (!mus__finite(rules[2 * i]) || !mus__finite(rules[2 * i + 1]))
            return mus__fail(context, MUS_ERR_ARG, "grade: point %d of panel %s has the rule (%g, %g), expected finite",
                             (int)i, pattern->panel[pattern->point[i].panel].name, rules[2 * i], rules[2 * i + 1]);

    mus__board_begin(&board, context, mus_pattern_name(pattern));
    mus__board_read(&board, pattern);
    for (int32_t s = 0; s < board.nside && board.status == MUS_OK; s++) {
        const double old = board.side[s].length;
        const int32_t next = board.side[s].next;
        grade_move_side(&board.side[s], rules + 2 * board.side[s].knot, rules + 2 * board.side[next].knot);
        for (int32_t n = 0; n < board.nnotch; n++)
            if (board.notch[n].side == s) board.notch[n].s *= board.side[s].length / old;
    }
    for (int32_t i = 0; i < board.nseam && board.status == MUS_OK; i++) {
        mus__board_seam *seam = &board.seam[i];
        if (seam->a != MUS_NONE) seam->ease = board.side[seam->b].length - board.side[seam->a].length;
    }
    mus__board_write(&board, out);
    const mus_status status = board.status;
    mus__board_free(&board);
    return status;
}


/* ---- ease ---- */

/* where the level y meets a panel, in order; how many */
static int32_t grade_cuts(const mus_pattern *pattern, int32_t panel, double y, double *cuts)
{
    const mus__panel *p = &pattern->panel[panel];
    int32_t n = 0;
    for (int32_t i = 0; i < p->noutline; i++) {
        double line[2 * GRADE_LINE];
        int32_t points = 0;
        if (mus_pattern_edge_polyline(pattern, p->outline[i], GRADE_CHORDS, line, GRADE_LINE, &points) != MUS_OK ||
            points > GRADE_LINE)
            return 0;
        for (int32_t k = 0; k + 1 < points && n < GRADE_CUTS; k++) {
            const double *a = line + 2 * k, *b = a + 2;
            if ((a[1] > y) == (b[1] > y)) continue;
            const double x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            int32_t at = n++;
            for (; at > 0 && cuts[at - 1] > x; at--) cuts[at] = cuts[at - 1];
            cuts[at] = x;
        }
    }
    return n - n % 2;
}


/* does a panel lie on another, as a patch: is it sewn to a line inside that one, which its outline passes twice? */
static bool grade_patch(const mus_pattern *pattern, int32_t panel)
{
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        mus_seam_def def;
        int32_t n = 0, passes = 0;
        const int32_t *edges = NULL;
        mus_seam_def_init(&def, sizeof def);
        if (mus_pattern_seam(pattern, i, &def) != MUS_OK) continue;
        const bool first = mus_pattern_edge_panel(pattern, def.edge_a) == panel;
        if (!first && mus_pattern_edge_panel(pattern, def.edge_b) != panel) continue;
        const int32_t other = first ? def.edge_b : def.edge_a, under = mus_pattern_edge_panel(pattern, other);
        if (under == panel || mus_pattern_outline(pattern, under, &n, &edges, NULL) != MUS_OK) continue;
        for (int32_t k = 0; k < n; k++) passes += edges[k] == other;
        if (passes > 1) return true;
    }
    return false;
}


/* of the garment at a height above the floor; 0 where it is not */
static double grade_girth(const mus_pattern *pattern, double height)
{
    double girth = 0.0;
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
        const mus_placement *place = &pattern->panel[p].attr.placement;
        double cuts[GRADE_CUTS];
        if (place->rotation[4] < GRADE_UPRIGHT || grade_patch(pattern, p)) continue;
        const int32_t n = grade_cuts(pattern, p, height - place->origin[1], cuts);
        for (int32_t i = 0; i < n; i += 2) girth += cuts[i + 1] - cuts[i];
    }
    return girth;
}


mus_status mus_design_ease(const mus_pattern *pattern, const mus_tape *tape, double *ease)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    if (tape == NULL || ease == NULL) return mus__fail(context, MUS_ERR_ARG, "ease: tape or ease is NULL");
    mus__measures measures;
    mus__skeleton skeleton;
    mus_draft_def def;
    const mus_status status = mus__design_read(context, tape, NULL, &def, &measures, &skeleton);
    if (status != MUS_OK) return status;
    /* the fullest near bust and hip; the waist is an edge of what is sewn there: the narrower side of it */
    const struct {
        double height, girth, window, step;
    } level[MUS_EASE_COUNT] = {
        [MUS_EASE_BUST] = {skeleton.bust, measures.v[MUS_MEASURE_BUST], GRADE_WINDOW, 0.005},
        [MUS_EASE_WAIST] = {skeleton.waist, measures.v[MUS_MEASURE_WAIST], GRADE_EDGE, 2.0 * GRADE_EDGE},
        [MUS_EASE_HIP] = {skeleton.hip, measures.v[MUS_MEASURE_HIP], GRADE_WINDOW, 0.005},
    };
    for (int32_t i = 0; i < MUS_EASE_COUNT; i++) {
        const bool narrow = i == MUS_EASE_WAIST;
        ease[i] = NAN;
        for (double d = -level[i].window; d <= level[i].window + 1e-9; d += level[i].step) {
            const double own = grade_girth(pattern, level[i].height + d) - level[i].girth;
            if (own < -GRADE_LEAST * level[i].girth) continue; /* it is not there */
            if (isnan(ease[i]) || (narrow ? own < ease[i] : own > ease[i])) ease[i] = own;
        }
    }
    return MUS_OK;
}
