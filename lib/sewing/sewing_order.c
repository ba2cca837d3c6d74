/*
 * sewing_order.c: the order of sewing, from the cells of the pattern alone.
 *
 * A line is what one stitching runs along: two seams at neighbouring edges of a panel are one line where the outline
 * runs on between them (it turns by less than half a right angle, or a dart is there) and both lead to other panels;
 * where a seam could go on to two others, the straighter way is taken. A cap is one line along front and back; a band
 * is one line along all panels that it holds. The images of a seam left and right are in one line too.
 *
 * What is sewn so far is a surface, the quotient of all panels by the seams done. Its first Betti number counts its
 * rings; while that of a part is 0, the part lies flat. A seam joins two edges: it changes vertices by -m (m of its two
 * pairs of ends were apart), edges by -1 and parts by -1 or 0, so the Betti number by m - 1 less the parts joined.
 *
 *   1. Darts and pleats first, then patches, then seams, then buttons.
 *   2. A seam that ends within a line is sewn before the line ("shoulder before cap").
 *   3. Of the lines that rule 2 leaves, the one that closes the fewest rings is sewn; then the shortest; then the first
 *      by words. So no ring is closed while some line can be sewn flat.
 *   4. Where four edges meet at a point and two opposite ones are sewn, a line that ends there is followed by the one
 *      opposite. A seam of a panel with itself closes a ring in any case: it is one line with those opposite its ends
 *      ("underarm and side in one go").
 *   5. Where four edges meet at a point and one is sewn, its opposite comes before the two across: the sides of a band
 *      and of its skirt before the band is sewn on, so that no seam runs into a ring that is closed. Where what is
 *      opposite is done up, a seam comes before those across it: a zip whose ends the band holds, the sleeve's before
 *      its cuff. Of two that are left, the longer comes first, and the other goes on from it (rule 4): the side of a
 *      rib with that of its body.
 *
 * Cost: lines x seams, each with the logarithm of the points
 * Source: Hatcher, Algebraic Topology, 2002, section 2.2 (Euler characteristic)
 */
#include <math.h>
#include <string.h>

#include "base/sort.h"
#include "sewing/sewing.h"

/* sets by union-find, the larger ones as roots and without shorter ways, so that the last unions can be undone */
typedef struct order_sets {
    int32_t *link, *size;
    int32_t *joined, njoined; /* roots that were linked, the last ones last */
} order_sets;

/* a place where a line runs straight on: seams that end there come before it */
typedef struct order_pass {
    int32_t point;
    int32_t seam[2];
    double straight; /* see order_straightness() */
    int32_t line;
    int32_t own; /* ends of the line there */
} order_pass;

/* all points that are one when the garment is sewn */
typedef struct order_point {
    int32_t ends;       /* of seams */
    int32_t open;       /* of seams that are not sewn */
    int32_t waits;      /* of seams that are not sewn, of kind MUS__SEWING_SEAM */
    int32_t step, sewn; /* last step that sewed here, and how many ends it sewed */
    int32_t seam, end;  /* that was sewn last */
    int32_t meet[4];    /* the first four ends that meet here: 2 x seam + end */
} order_point;

typedef struct order_job {
    mus__sewing *sewing;
    mus__sewn **seams; /* of `sewing`, by words */
    int32_t npoint, npass;
    order_sets whole;    /* points, when all is sewn */
    order_sets now;      /* points, then panels: what is sewn so far */
    order_point *points; /* (npoint) those at the roots of `whole` are used */
    order_pass *passes;  /* (2 n) */
    bool *tied;          /* (n) by line: rule 2 */
} order_job;


static int32_t order_find(const order_sets *sets, int32_t i)
{
    while (sets->link[i] != i) i = sets->link[i];
    return i;
}


/* make two sets one; returns whether they were two */
static bool order_unite(order_sets *sets, int32_t a, int32_t b)
{
    a = order_find(sets, a);
    b = order_find(sets, b);
    if (a == b) return false;
    const int32_t root = sets->size[a] >= sets->size[b] ? a : b, other = root == a ? b : a;
    sets->link[other] = root;
    sets->size[root] += sets->size[other];
    sets->joined[sets->njoined++] = other;
    return true;
}


/* undo unions until `count` are left */
static void order_undo(order_sets *sets, int32_t count)
{
    while (sets->njoined > count) {
        const int32_t root = sets->joined[--sets->njoined];
        sets->size[sets->link[root]] -= sets->size[root];
        sets->link[root] = root;
    }
}


static bool order_sets_make(mus_context *context, int32_t n, order_sets *sets)
{
    sets->link = mus__print_new(context, 3 * (int64_t)n, sizeof *sets->link);
    if (sets->link == NULL) return false;
    sets->size = sets->link + n;
    sets->joined = sets->size + n;
    for (int32_t i = 0; i < n; i++) {
        sets->link[i] = i;
        sets->size[i] = 1;
    }
    return true;
}


/* ---- points ---- */

/* point where end `end` of a seam is when all is sewn */
static order_point *order_at(const order_job *job, const mus__sewn *seam, int32_t end)
{
    return &job->points[order_find(&job->whole, seam->point[end][0])];
}


static void order_count_ends(order_job *job)
{
    for (int32_t i = 0; i < job->npoint; i++) job->points[i].step = MUS_NONE;
    for (int32_t i = 0; i < 2 * job->sewing->n; i++) {
        const mus__sewn *seam = job->seams[i / 2];
        order_point *point = order_at(job, seam, i % 2);
        if (point->ends < 4) point->meet[point->ends] = i;
        point->ends++;
        point->open++;
        point->waits += seam->kind == MUS__SEWING_SEAM;
    }
}


/* ---- lines ---- */

/* seams (by words) that an edge is in, MUS_NONE without one: one that leads to another panel, and a dart. Of several
 * the last by words */
typedef struct order_edge {
    int32_t outward, dart;
} order_edge;


static void order_edges(const order_job *job, order_edge *edges)
{
    for (int32_t i = 0; i < mus_pattern_edge_count(job->sewing->pattern); i++)
        edges[i] = (order_edge){MUS_NONE, MUS_NONE};
    for (int32_t i = 0; i < 2 * job->sewing->n; i++) {
        const mus__sewn *seam = job->seams[i / 2];
        order_edge *edge = &edges[seam->edge[i % 2]];
        if (seam->kind == MUS__SEWING_DART)
            edge->dart = i / 2;
        else if (seam->kind == MUS__SEWING_SEAM && seam->panel[0] != seam->panel[1])
            edge->outward = i / 2;
    }
}


/* the direction in which an outline leaves an edge, or enters it: its secant over a thousandth of the edge */
static void order_tangent(const mus_pattern *pattern, int32_t edge, int32_t direction, bool leaves, double *out)
{
    const double step = 1.0 / 1024;
    const double t[2] = {leaves == (direction > 0) ? 1.0 - step : 0.0, leaves == (direction > 0) ? 1.0 : step};
    double xy[4] = {0.0, 0.0, 0.0, 0.0};
    mus_pattern_edge_at(pattern, edge, 2, t, xy);
    out[0] = direction * (xy[2] - xy[0]);
    out[1] = direction * (xy[3] - xy[1]);
}


/* how straight an outline runs on from its edge i to its edge k: the square of the cosine of its turn, 0 for a turn of
 * half a right angle or more */
static double order_straightness(const mus_pattern *pattern, const int32_t *edges, const int32_t *directions, int32_t i,
                                 int32_t k)
{
    double a[2], b[2];
    order_tangent(pattern, edges[i], directions[i], true, a);
    order_tangent(pattern, edges[k], directions[k], false, b);
    const double dot = a[0] * b[0] + a[1] * b[1];
    const double most = (a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1]);
    return dot > 0.0 && 2.0 * dot * dot > most ? dot * dot / most : 0.0;
}


/* add the places where the outline of a panel may run on from seam to seam */
static void order_passes(order_job *job, const order_edge *in, int32_t panel)
{
    int32_t n = 0;
    const int32_t *edges, *directions;
    const mus_pattern *pattern = job->sewing->pattern;
    if (mus_pattern_outline(pattern, panel, &n, &edges, &directions) != MUS_OK) return;
    for (int32_t i = 0; i < n; i++) {
        const int32_t a = in[edges[i]].outward;
        int32_t next = (i + 1) % n, darts = 0, ends[2];
        if (a == MUS_NONE) continue;
        for (; darts < n; darts += 2, next = (next + 2) % n) {
            const int32_t leg = in[edges[next]].dart;
            if (leg == MUS_NONE || in[edges[(next + 1) % n]].dart != leg) break;
        }
        const int32_t b = in[edges[next]].outward;
        if (b == MUS_NONE || a == b || job->npass >= 2 * job->sewing->n) continue;
        /* the two sides of a dart are one line when it is closed */
        const double straight = darts > 0 ? 1.0 : order_straightness(pattern, edges, directions, i, next);
        mus_pattern_edge_ends(pattern, edges[i], &ends[0], &ends[1]);
        if (straight > 0.0)
            job->passes[job->npass++] = (order_pass){
                order_find(&job->whole, ends[directions[i] > 0]), {a < b ? a : b, a < b ? b : a}, straight, 0, 0};
    }
}


static int order_pass_compare(const void *a, const void *b)
{
    const order_pass *p = a, *q = b;
    if (p->straight < q->straight || p->straight > q->straight) return p->straight < q->straight ? 1 : -1;
    for (int32_t k = 0; k < 2; k++)
        if (p->seam[k] != q->seam[k]) return p->seam[k] < q->seam[k] ? -1 : 1;
    return 0;
}


/* the end of seam `seam` at a point that may go on to seam `to`: none has gone on from it, or to that seam; MUS_NONE
 * without one. `gone` (2 n) has where the ends have gone on to */
static int32_t order_open_end(const order_job *job, const int32_t *gone, int32_t seam, int32_t point, int32_t to)
{
    for (int32_t k = 0; k < 2; k++)
        if (order_find(&job->whole, job->seams[seam]->point[k][0]) == point &&
            (gone[2 * seam + k] == MUS_NONE || gone[2 * seam + k] == to))
            return 2 * seam + k;
    return MUS_NONE;
}


/* join seams to lines, the straightest places first: where a seam could go on to two others, as at the end of a
 * princess line, it goes on to one */
static void order_lines(order_job *job, order_sets *lines, int32_t *gone)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < 2 * job->sewing->n; i++) gone[i] = MUS_NONE;
    mus__sort(job->passes, (size_t)job->npass, sizeof *job->passes, order_pass_compare);
    for (int32_t i = 0; i < job->npass; i++) {
        const order_pass *pass = &job->passes[i];
        const int32_t a = order_open_end(job, gone, pass->seam[0], pass->point, pass->seam[1]);
        const int32_t b = order_open_end(job, gone, pass->seam[1], pass->point, pass->seam[0]);
        if (a == MUS_NONE || b == MUS_NONE) continue;
        gone[a] = pass->seam[1];
        gone[b] = pass->seam[0];
        order_unite(lines, pass->seam[0], pass->seam[1]);
        job->passes[kept++] = *pass;
    }
    job->npass = kept;
}


/* do two ends of seams lie opposite each other where four edges meet: at one point, and on no common panel corner? */
static bool order_opposite(const order_job *job, const mus__sewn *s, int32_t i, const mus__sewn *t, int32_t k)
{
    const int32_t *a = s->point[i], *b = t->point[k];
    const int32_t point = order_find(&job->whole, a[0]);
    return point == order_find(&job->whole, b[0]) && job->points[point].ends == 4 && a[0] != b[0] && a[0] != b[1] &&
           a[1] != b[0] && a[1] != b[1];
}


/* a seam of a panel with itself closes a ring whenever it is sewn: what goes on from it straight across two other edges
 * is one line with it */
static void order_tubes(order_job *job, order_sets *lines)
{
    for (int32_t i = 0; i < job->sewing->n; i++) {
        const mus__sewn *tube = job->seams[i];
        if (tube->kind != MUS__SEWING_SEAM || tube->panel[0] != tube->panel[1]) continue;
        for (int32_t k = 0; k < 4 * job->sewing->n; k++)
            if (job->seams[k / 4]->kind == MUS__SEWING_SEAM &&
                order_opposite(job, tube, k / 2 % 2, job->seams[k / 4], k % 2))
                order_unite(lines, i, k / 4);
    }
}


/* set the line of each seam and the next seam of it, from the sets; the first of a line is its name */
static void order_chain(order_job *job, const order_sets *lines, int32_t *last)
{
    const int32_t n = job->sewing->n;
    for (int32_t i = 0; i < n; i++) last[i] = MUS_NONE;
    for (int32_t i = 0; i < n; i++) {
        const int32_t root = order_find(lines, i), before = last[root];
        job->seams[i]->line = before == MUS_NONE ? i : job->seams[before]->line;
        job->seams[i]->next = MUS_NONE;
        if (before != MUS_NONE) job->seams[before]->next = i;
        last[root] = i;
    }
}


static mus_status order_group(order_job *job)
{
    mus_context *context = job->sewing->context;
    const int32_t n = job->sewing->n;
    order_sets lines = {NULL, NULL, NULL, 0};
    int32_t *work = mus__print_new(context, 2 * (int64_t)n, sizeof *work);
    order_edge *edges = mus__print_new(context, mus_pattern_edge_count(job->sewing->pattern), sizeof *edges);
    mus_status status = MUS_OK;
    if (work == NULL || edges == NULL || !order_sets_make(context, n, &lines)) {
        status = mus__print_memory(context, "the order of sewing");
    } else {
        order_edges(job, edges);
        for (int32_t i = 0; i < n; i++) order_unite(&lines, i, job->seams[i]->family);
        for (int32_t i = 0; i < mus_pattern_panel_count(job->sewing->pattern); i++) order_passes(job, edges, i);
        order_lines(job, &lines, work);
        order_tubes(job, &lines);
        order_chain(job, &lines, work);
    }
    mus__print_free(context, lines.link);
    mus__print_free(context, edges);
    mus__print_free(context, work);
    return status;
}


/* ---- the order ---- */

static int order_line_compare(const void *a, const void *b)
{
    const order_pass *p = a, *q = b;
    return (p->line > q->line) - (p->line < q->line);
}


/* count the ends of each line where it runs straight on */
static void order_count_own(order_job *job)
{
    for (int32_t p = 0; p < job->npass; p++) job->passes[p].line = job->seams[job->passes[p].seam[0]]->line;
    mus__sort(job->passes, (size_t)job->npass, sizeof *job->passes, order_line_compare);
    for (int32_t p = 0; p < job->npass;) {
        const int32_t line = job->passes[p].line;
        for (int32_t i = line; i != MUS_NONE; i = job->seams[i]->next)
            for (int32_t end = 0; end < 2; end++) {
                order_point *at = order_at(job, job->seams[i], end);
                at->sewn = at->step == line ? at->sewn + 1 : 1; /* both are free until the first step */
                at->step = line;
            }
        for (; p < job->npass && job->passes[p].line == line; p++) {
            const order_point *at = &job->points[job->passes[p].point];
            job->passes[p].own = at->step == line ? at->sewn : 0;
        }
    }
    for (int32_t i = 0; i < job->npoint; i++) job->points[i].step = MUS_NONE;
}


/* what sewing a line would do */
typedef struct order_choice {
    int32_t line; /* MUS_NONE for none */
    mus__sewing_kind kind;
    bool tied;
    int32_t rings, joins; /* as those of mus__sewing_step */
    double length;        /* [m] */
} order_choice;


/* sew a line in `now` */
static order_choice order_sew(order_job *job, int32_t line)
{
    order_choice choice = {line, job->seams[line]->kind, job->tied[line], 0, 0, 0.0};
    for (int32_t i = line; i != MUS_NONE; i = job->seams[i]->next) {
        const mus__sewn *seam = job->seams[i];
        int32_t apart = 0;
        for (int32_t k = 0; k < 2; k++) apart += order_unite(&job->now, seam->point[k][0], seam->point[k][1]);
        const int32_t joined = order_unite(&job->now, job->npoint + seam->panel[0], job->npoint + seam->panel[1]);
        choice.rings += apart - 1 - joined;
        choice.joins += joined;
        choice.length += seam->length[0];
    }
    return choice;
}


/* is choice a sewn before choice b? Lines come by words */
static bool order_before(const order_choice *a, const order_choice *b)
{
    const int32_t rings_a = a->rings > 0 ? a->rings : 0, rings_b = b->rings > 0 ? b->rings : 0;
    if (b->line == MUS_NONE) return true;
    if (a->kind != b->kind) return a->kind < b->kind;
    if (a->tied != b->tied) return b->tied;
    if (rings_a != rings_b) return rings_a < rings_b;
    const long shorter = lround(1e3 * a->length) - lround(1e3 * b->length); /* lengths that read alike are alike */
    return shorter != 0 ? shorter < 0 : a->line < b->line;
}


/* rule 4: does line b go on where a line of the step ends, straight across two sewn edges? */
static bool order_goes_on(const order_job *job, int32_t step, int32_t line)
{
    for (int32_t i = line; i != MUS_NONE; i = job->seams[i]->next) {
        for (int32_t end = 0; end < 2; end++) {
            const order_point *at = order_at(job, job->seams[i], end);
            if (at->open == 1 && at->step == step && at->sewn == 1 &&
                order_opposite(job, job->seams[i], end, job->seams[at->seam], at->end))
                return true;
        }
    }
    return false;
}


/* is there a seam that comes first where a seam ends at a crossing (rule 5)? */
static bool order_waits(const order_job *job, const mus__sewn *seam, int32_t end)
{
    const order_point *at = order_at(job, seam, end);
    int32_t n = 0;
    const mus__sewn *across[2], *opposite = NULL;
    if (at->ends != 4) return false;
    for (int32_t k = 0; k < 4; k++) {
        const mus__sewn *other = job->seams[at->meet[k] / 2];
        if (other == seam) continue;
        if (order_opposite(job, seam, end, other, at->meet[k] % 2))
            opposite = other;
        else if (n < 2)
            across[n++] = other;
        else
            return false;
    }
    if (n < 2) return false;
    if (across[0]->step != MUS_NONE && across[1]->step != MUS_NONE)
        return opposite != NULL && opposite->step == MUS_NONE && opposite->kind == MUS__SEWING_SEAM &&
               opposite->line != seam->line && lround(1e3 * opposite->length[0]) > lround(1e3 * seam->length[0]);
    for (int32_t k = 0; k < 2; k++) {
        const mus__sewn *first = across[k], *then = across[1 - k];
        if (first->step == MUS_NONE && first->kind == MUS__SEWING_SEAM && then->kind > MUS__SEWING_SEAM) return true;
        if (first->step != MUS_NONE && then->step == MUS_NONE && then->kind == MUS__SEWING_SEAM) return true;
    }
    return false;
}


/* the best line to sew next, MUS_NONE for none; with `step` only one that goes on from it and closes no ring */
static order_choice order_best(order_job *job, int32_t step)
{
    const int32_t n = job->sewing->n;
    order_choice best = {.line = MUS_NONE};
    memset(job->tied, 0, (size_t)n * sizeof *job->tied);
    for (int32_t p = 0; p < job->npass; p++) {
        const order_pass *pass = &job->passes[p];
        if (job->points[pass->point].waits > pass->own) job->tied[pass->line] = true;
    }
    for (int32_t i = 0; i < 2 * n; i++) {
        const mus__sewn *seam = job->seams[i / 2];
        if (seam->step == MUS_NONE && order_waits(job, seam, i % 2)) job->tied[seam->line] = true;
    }
    for (int32_t i = 0; i < n; i++) {
        if (job->seams[i]->step != MUS_NONE || job->seams[i]->line != i) continue;
        if (step != MUS_NONE && (job->seams[i]->kind != MUS__SEWING_SEAM || job->tied[i])) continue;
        if (step != MUS_NONE && !order_goes_on(job, step, i)) continue;
        const int32_t before = job->now.njoined;
        const order_choice choice = order_sew(job, i);
        order_undo(&job->now, before);
        if (step != MUS_NONE && choice.rings > 0) continue;
        if (order_before(&choice, &best)) best = choice;
    }
    return best;
}


/* sew a line in step `index` */
static void order_take(order_job *job, int32_t line, int32_t index)
{
    mus__sewing_step *step = &job->sewing->steps[index];
    const order_choice choice = order_sew(job, line);
    step->kind = choice.kind;
    step->rings += choice.rings;
    step->joins += choice.joins;
    for (int32_t i = line; i != MUS_NONE; i = job->seams[i]->next) {
        mus__sewn *seam = job->seams[i];
        seam->step = index;
        for (int32_t end = 0; end < 2; end++) {
            order_point *at = order_at(job, seam, end);
            at->open--;
            at->waits -= seam->kind == MUS__SEWING_SEAM;
            at->sewn = at->step == index ? at->sewn + 1 : 1;
            at->step = index;
            at->seam = i;
            at->end = end;
        }
    }
}


static void order_run(order_job *job)
{
    mus__sewing *out = job->sewing;
    for (int32_t i = 0; i < out->n; i++) job->seams[i]->step = MUS_NONE;
    for (;;) {
        order_choice best = order_best(job, MUS_NONE);
        if (best.line == MUS_NONE) return;
        /* all darts are one step, and all patches, and all buttons */
        if (out->nstep == 0 || best.kind == MUS__SEWING_SEAM || out->steps[out->nstep - 1].kind != best.kind)
            out->nstep++;
        const int32_t index = out->nstep - 1;
        order_take(job, best.line, index);
        while (best.kind == MUS__SEWING_SEAM && (best = order_best(job, index)).line != MUS_NONE)
            order_take(job, best.line, index);
    }
}


mus_status mus__sewing_order(mus__sewing *sewing)
{
    mus_context *context = sewing->context;
    order_job job = {.sewing = sewing, .seams = sewing->by_words, .npoint = mus_pattern_point_count(sewing->pattern)};
    job.points = mus__print_new(context, job.npoint, sizeof *job.points);
    job.passes = mus__print_new(context, 2 * (int64_t)sewing->n, sizeof *job.passes);
    job.tied = mus__print_new(context, sewing->n, sizeof *job.tied);
    mus_status status = MUS_OK;
    if (job.points == NULL || job.passes == NULL || job.tied == NULL ||
        !order_sets_make(context, job.npoint, &job.whole) ||
        !order_sets_make(context, job.npoint + mus_pattern_panel_count(sewing->pattern), &job.now)) {
        status = mus__print_memory(context, "the order of sewing");
    } else {
        for (int32_t i = 0; i < 2 * sewing->n; i++)
            order_unite(&job.whole, job.seams[i / 2]->point[i % 2][0], job.seams[i / 2]->point[i % 2][1]);
        order_count_ends(&job);
        status = order_group(&job);
    }
    if (status == MUS_OK) {
        order_count_own(&job);
        order_run(&job);
    }
    mus__print_free(context, job.now.link);
    mus__print_free(context, job.whole.link);
    mus__print_free(context, job.tied);
    mus__print_free(context, job.passes);
    mus__print_free(context, job.points);
    return status;
}
