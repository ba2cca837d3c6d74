/*
 * seam_search.c: the sewing of highest score, by local changes.
 *
 * A change sews two edges, frees an edge, or swaps what a panel and its mirror image are sewn to; each also together
 * with its mirror image. The former mates of two edges that are sewn become free, or are sewn to one another. Or the
 * seam goes on beside the two edges: at the same ratio of lengths, to the end of an opening, or along both outlines,
 * over seams that are there. The search takes for each edge the best change as long as any raises the score; it does so
 * from the pairs of highest score, and from the end of each round of simulated annealing.
 */
#include <math.h>
#include <string.h>

#include "seam/seam_find.h"
#include "base/elementary.h"

#define SEARCH_NEAR 10    /* mates that are tried for each edge; chosen: the right one is among them but in 1 of 300 */
#define SEARCH_SWEEPS 40  /* sweeps over all edges at most; chosen: five are usual */
#define SEARCH_HEAT 4.0   /* score, first temperature; chosen: a seam that one edge prefers by it may be opened */
#define SEARCH_STEPS 1500 /* changes tried for each edge in one annealing; chosen: half a second for 60 edges */
#define SEARCH_GAIN 1e-9  /* a change that raises the score by less is none */
#define WAYS 6 /* alone, joined, continued, to the end, over seams, over seams whose former mates are joined */
#define CHANGES_OF_MATE (2 * WAYS) /* mirrored or not */


static void *search_new(mus_context *context, int64_t count, size_t size)
{
    return mus_context_alloc(context, NULL, (size_t)(count > 0 ? count : 1) * size);
}


mus_status mus__seam_begin(const mus__seam_facts *facts, const double *weights, mus__seam_search *out)
{
    const int32_t n = facts->n, near = n - 1 < SEARCH_NEAR ? n - 1 : SEARCH_NEAR;
    const mus__seam_search none = {.facts = facts, .weights = weights, .nnear = near > 0 ? near : 0};
    *out = none;
    out->pairs = search_new(facts->context, (int64_t)n * n, sizeof *out->pairs);
    out->near = search_new(facts->context, (int64_t)n * SEARCH_NEAR, sizeof *out->near);
    out->mate = search_new(facts->context, 3 * (int64_t)n, sizeof *out->mate);
    out->scratch = search_new(facts->context, MUS__SEAM_SCRATCH(facts), sizeof *out->scratch);
    if (out->pairs == NULL || out->near == NULL || out->mate == NULL || out->scratch == NULL) {
        mus__seam_end(out);
        return mus_context_fail(facts->context, MUS_ERR_MEMORY, "no memory for the search of seams");
    }
    out->trial = out->mate + n;
    out->keep = out->mate + 2 * n;
    for (int32_t a = 0; a < n; a++) {
        int32_t *near_a = out->near + (int64_t)a * SEARCH_NEAR;
        for (int32_t b = 0; b < a; b++) {
            double features[MUS__SEAM_PAIRS], sum = 0.0;
            mus__seam_pair(facts, a, b, features);
            for (int32_t k = 0; k < MUS__SEAM_PAIRS; k++) sum += weights[k] * features[k];
            if (mus__seam_never(facts, a, b)) sum = -HUGE_VAL;
            out->pairs[(int64_t)a * n + b] = out->pairs[(int64_t)b * n + a] = sum;
        }
        double features[MUS__SEAM_FREES], sum = 0.0;
        mus__seam_free_edge(facts, a, features);
        for (int32_t k = 0; k < MUS__SEAM_FREES; k++) sum += weights[MUS__SEAM_PAIRS + k] * features[k];
        out->pairs[(int64_t)a * n + a] = sum;
        for (int32_t k = 0; k < SEARCH_NEAR; k++) near_a[k] = MUS_NONE;
    }
    for (int32_t a = 0; a < n; a++)
        for (int32_t b = 0; b < n; b++) {
            int32_t *near_a = out->near + (int64_t)a * SEARCH_NEAR, at = out->nnear;
            const double *row = out->pairs + (int64_t)a * n;
            if (a == b) continue;
            while (at > 0 && (near_a[at - 1] == MUS_NONE || row[near_a[at - 1]] < row[b])) at--;
            for (int32_t k = out->nnear - 1; k > at; k--) near_a[k] = near_a[k - 1];
            if (at < out->nnear) near_a[at] = b;
        }
    return MUS_OK;
}


void mus__seam_end(mus__seam_search *search)
{
    void *const blocks[] = {search->pairs, search->near, search->mate, search->scratch};
    for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++) mus_context_alloc(search->facts->context, blocks[i], 0);
}


double mus__seam_score(mus__seam_search *search, const int32_t *mate)
{
    double whole[MUS__SEAM_WHOLES], sum = 0.0;
    const int32_t n = search->facts->n;
    mus__seam_whole(search->facts, mate, search->scratch, whole);
    for (int32_t k = 0; k < MUS__SEAM_WHOLES; k++)
        sum += search->weights[MUS__SEAM_PAIRS + MUS__SEAM_FREES + k] * whole[k];
    for (int32_t a = 0; a < n; a++)
        if (mate[a] > a || mate[a] == MUS_NONE) sum += search->pairs[(int64_t)a * n + (mate[a] > a ? mate[a] : a)];
    return sum;
}


/* ---- changes ---- */

static void part_from_mate(int32_t *mate, int32_t a)
{
    if (mate[a] != MUS_NONE) mate[mate[a]] = MUS_NONE;
    mate[a] = MUS_NONE;
}


static bool sew_pair(const int32_t *fixed, int32_t a, int32_t b, bool join, int32_t *mate)
{
    if (a == b || mate[a] == b) return false;
    const int32_t c = mate[a], d = mate[b];
    if (fixed[a] != MUS_NONE || fixed[b] != MUS_NONE || (join && (c == MUS_NONE || d == MUS_NONE))) return false;
    part_from_mate(mate, a);
    part_from_mate(mate, b);
    mate[a] = b;
    mate[b] = a;
    if (!join) return true;
    mate[c] = d;
    mate[d] = c;
    return true;
}


/* what panel p is sewn to, and what its mirror image is sewn to, change places */
static bool swap_twin(const mus__seam_facts *facts, int32_t p, int32_t *mate)
{
    const mus__seam_panel *panel = &facts->panels[p];
    bool changed = false;
    for (int32_t a = panel->first; a < panel->first + panel->n; a++) {
        const int32_t b = facts->edges[a].mirror;
        if (b == MUS_NONE || facts->edges[b].panel <= p) return false;
        if (facts->fixed[a] != MUS_NONE || facts->fixed[b] != MUS_NONE) return false;
        const int32_t q = facts->edges[b].panel, c = mate[a], d = mate[b];
        /* seams within the two panels go from image to image of themselves, or stay */
        if (c != MUS_NONE && (facts->edges[c].panel == p || facts->edges[c].panel == q)) continue;
        if (d != MUS_NONE && (facts->edges[d].panel == p || facts->edges[d].panel == q)) continue;
        if (c == MUS_NONE && d == MUS_NONE) continue;
        mate[a] = d;
        mate[b] = c;
        if (d != MUS_NONE) mate[d] = a;
        if (c != MUS_NONE) mate[c] = b;
        changed = true;
    }
    return changed;
}


/* the free edge next to the end (or the start) of sewn edge a, round the vertex; MUS_NONE where the vertex is closed */
static int32_t free_beside(const mus__seam_facts *facts, const int32_t *mate, int32_t a, bool end)
{
    int32_t at = end ? facts->edges[a].next : facts->edges[a].prev;
    for (int32_t i = 0; i < facts->n && mate[at] != MUS_NONE; i++)
        at = end ? facts->edges[mate[at]].next : facts->edges[mate[at]].prev;
    return mate[at] == MUS_NONE ? at : MUS_NONE;
}


/* sews on from the seam of a and b, both ways along the opening, as long as the ratio of the lengths stays the same, or
 * to the end of the opening */
static bool sew_on(const mus__seam_facts *facts, int32_t a, int32_t b, bool to_end, int32_t *mate)
{
    const double ratio = facts->edges[a].log_length - facts->edges[b].log_length;
    bool changed = false;
    for (int32_t way = 0; way < 2; way++)
        for (int32_t x = a, y = b;;) {
            x = free_beside(facts, mate, x, way == 0);
            y = free_beside(facts, mate, y, way != 0);
            if (x == MUS_NONE || y == MUS_NONE || x == y) break;
            const double off = fabs(facts->edges[x].log_length - facts->edges[y].log_length - ratio);
            if ((off > MUS__SEAM_EQUAL_RATIOS && !to_end) || mus__seam_never(facts, x, y)) break;
            mate[x] = y;
            mate[y] = x;
            changed = true;
        }
    return changed;
}


/* sews on from the seam of a and b, both ways along the two outlines, over the seams that are there, as long as the
 * ratio of the lengths stays the same: an insert goes into its slit at once. With `join` the former mates are sewn to
 * one another where both are: the insert that was in the slit goes where the other came from */
static bool sew_over(const mus__seam_facts *facts, int32_t a, int32_t b, bool join, int32_t *mate)
{
    const mus__seam_edge *edges = facts->edges;
    const double ratio = edges[a].log_length - edges[b].log_length;
    bool changed = false;
    for (int32_t way = 0; way < 2; way++)
        for (int32_t x = a, y = b;;) {
            x = way == 0 ? edges[x].next : edges[x].prev;
            y = way == 0 ? edges[y].prev : edges[y].next;
            if (x == a || y == b || x == y || x == b || y == a || mate[x] == y) break;
            if (fabs(edges[x].log_length - edges[y].log_length - ratio) > MUS__SEAM_EQUAL_RATIOS) break;
            if (mus__seam_never(facts, x, y)) break;
            const bool both = join && mate[x] != MUS_NONE && mate[y] != MUS_NONE;
            if (!sew_pair(facts->fixed, x, y, both, mate)) break;
            changed = true;
        }
    return changed;
}


/* what lies beside the seam of a and b is sewn as the change tells */
static bool go_on(const mus__seam_facts *facts, const mus__seam_change *change, int32_t a, int32_t b, int32_t *mate)
{
    return change->over ? sew_over(facts, a, b, change->join, mate) : sew_on(facts, a, b, change->to_end, mate);
}


bool mus__seam_change_apply(const mus__seam_facts *facts, const mus__seam_change *change, int32_t *mate)
{
    const int32_t a = change->a, b = change->b;
    if (a == MUS_NONE) return swap_twin(facts, b, mate);
    const int32_t c = facts->edges[a].mirror, d = b != MUS_NONE ? facts->edges[b].mirror : MUS_NONE;
    if (b == MUS_NONE) {
        if (mate[a] == MUS_NONE || facts->fixed[a] != MUS_NONE) return false;
        const int32_t image = facts->edges[mate[a]].mirror;
        part_from_mate(mate, a);
        if (!change->mirrored) return true;
        if (c == MUS_NONE || image == MUS_NONE || mate[c] != image || facts->fixed[c] != MUS_NONE) return false;
        part_from_mate(mate, c);
        return true;
    }
    if (!sew_pair(facts->fixed, a, b, change->join, mate)) return false;
    if (!change->mirrored) return !change->on || go_on(facts, change, a, b, mate);
    if (c == MUS_NONE || d == MUS_NONE || c == b || c == a || d == b) return false;
    if (!sew_pair(facts->fixed, c, d, change->join, mate)) return false;
    if (!change->on) return true;
    const bool one = go_on(facts, change, a, b, mate), other = go_on(facts, change, c, d, mate);
    return one || other;
}


bool mus__seam_change_list(const mus__seam_search *search, int32_t i, mus__seam_change *out)
{
    const mus__seam_facts *facts = search->facts;
    const int32_t each = CHANGES_OF_MATE * search->nnear + 2, a = i / each, k = i % each;
    const mus__seam_change none = {.a = MUS_NONE, .b = MUS_NONE};
    *out = none;
    if (a >= facts->n) {
        out->b = i - facts->n * each;
        return out->b < facts->npanel;
    }
    out->a = a;
    if (k < 2) {
        out->mirrored = k == 1;
    } else {
        out->b = search->near[(int64_t)a * SEARCH_NEAR + (k - 2) / CHANGES_OF_MATE];
        const int32_t way = (k - 2) % CHANGES_OF_MATE;
        out->join = way % WAYS == 1 || way % WAYS == 5;
        out->on = way % WAYS > 1;
        out->to_end = way % WAYS == 3;
        out->over = way % WAYS >= 4;
        out->mirrored = way >= WAYS;
    }
    return true;
}


/* ---- the search ---- */

/* raises the score of `mate` by the best change of each edge in turn, until no change raises it; returns the score */
static double climb(mus__seam_search *search, int32_t *mate)
{
    const mus__seam_facts *facts = search->facts;
    const size_t bytes = sizeof *mate * (size_t)facts->n;
    const int32_t each = CHANGES_OF_MATE * search->nnear + 2, all = facts->n * each + facts->npanel;
    double score = mus__seam_score(search, mate);
    bool moved = true;
    for (int32_t sweep = 0; sweep < SEARCH_SWEEPS && moved; sweep++) {
        moved = false;
        for (int32_t i = 0; i < all;) {
            const int32_t end = i < facts->n * each ? i + each : i + 1;
            int32_t best = MUS_NONE;
            double highest = score + SEARCH_GAIN;
            mus__seam_change change;
            for (; i < end; i++) {
                memcpy(search->trial, mate, bytes);
                if (!mus__seam_change_list(search, i, &change)) continue;
                if (!mus__seam_change_apply(facts, &change, search->trial)) continue;
                const double trial = mus__seam_score(search, search->trial);
                if (trial <= highest) continue;
                highest = trial;
                best = i;
            }
            if (best == MUS_NONE) continue;
            mus__seam_change_list(search, best, &change);
            mus__seam_change_apply(facts, &change, mate);
            score = highest;
            moved = true;
        }
    }
    return score;
}


static double next_random(uint64_t *state)
{
    *state ^= *state << 13; /* Marsaglia, Xorshift RNGs, 2003 */
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return (double)(*state >> 11) * 0x1p-53;
}


/* number of a change in mus__seam_change_list(); mates of high score more often than others */
static int32_t random_change(const mus__seam_search *search, uint64_t *random)
{
    const int32_t each = CHANGES_OF_MATE * search->nnear + 2, all = search->facts->n * each + search->facts->npanel;
    const int32_t i = (int32_t)(next_random(random) * all), k = i % each;
    if (i >= search->facts->n * each || k < 2) return i;
    const double u = next_random(random);
    return i - (k - 2) / CHANGES_OF_MATE * CHANGES_OF_MATE + (int32_t)(u * u * search->nnear) * CHANGES_OF_MATE;
}


/* simulated annealing (Kirkpatrick, Gelatt and Vecchi 1983) from `mate`: the sewing at its end */
static void anneal(mus__seam_search *search, int32_t steps, uint64_t *random, int32_t *mate)
{
    const mus__seam_facts *facts = search->facts;
    const size_t bytes = sizeof *mate * (size_t)facts->n;
    double score = mus__seam_score(search, mate);
    for (int32_t step = 0; step < steps; step++) {
        const double heat = SEARCH_HEAT * (1.0 - (double)step / steps);
        mus__seam_change change;
        memcpy(search->trial, mate, bytes);
        if (!mus__seam_change_list(search, random_change(search, random), &change)) continue;
        if (!mus__seam_change_apply(facts, &change, search->trial)) continue;
        const double trial = mus__seam_score(search, search->trial);
        if (trial < score && next_random(random) > mus__exp((trial - score) / fmax(heat, 1e-9))) continue;
        score = trial;
        memcpy(mate, search->trial, bytes);
    }
}


/* sews the pairs of highest score first, as long as a pair's score is above 0 */
static void sew_greedily(mus__seam_search *search, int32_t *mate)
{
    const int32_t n = search->facts->n;
    for (;;) {
        double highest = 0.0;
        int32_t a = MUS_NONE, b = MUS_NONE;
        for (int32_t i = 0; i < n; i++)
            for (int32_t k = 0; k < search->nnear && mate[i] == MUS_NONE; k++) {
                const int32_t j = search->near[(int64_t)i * SEARCH_NEAR + k];
                if (mate[j] != MUS_NONE) continue;
                const double score = search->pairs[(int64_t)i * n + j];
                if (score > highest) {
                    highest = score;
                    a = i;
                    b = j;
                }
                break;
            }
        if (a == MUS_NONE) return;
        mate[a] = b;
        mate[b] = a;
    }
}


void mus__seam_run(mus__seam_search *search, int32_t rounds)
{
    const mus__seam_facts *facts = search->facts;
    const size_t bytes = sizeof *search->mate * (size_t)facts->n;
    uint64_t random = UINT64_C(0x9E3779B97F4A7C15);
    memcpy(search->mate, facts->fixed, bytes);
    sew_greedily(search, search->mate);
    search->score = climb(search, search->mate);
    for (int32_t round = 0; round < rounds; round++) {
        memcpy(search->keep, facts->fixed, bytes);
        anneal(search, SEARCH_STEPS * facts->n, &random, search->keep);
        const double score = climb(search, search->keep);
        if (score <= search->score + SEARCH_GAIN) continue;
        search->score = score;
        memcpy(search->mate, search->keep, bytes);
    }
}


double mus__seam_margin(mus__seam_search *search, int32_t a, int32_t *other)
{
    const mus__seam_facts *facts = search->facts;
    const size_t bytes = sizeof *search->mate * (size_t)facts->n;
    const int32_t each = CHANGES_OF_MATE * search->nnear + 2, ends[2] = {a, search->mate[a]};
    double highest = -HUGE_VAL;
    *other = MUS_NONE;
    for (int32_t k = 0; k < 2; k++)
        for (int32_t i = ends[k] * each; ends[k] != MUS_NONE && i < (ends[k] + 1) * each; i++) {
            mus__seam_change change;
            memcpy(search->trial, search->mate, bytes);
            mus__seam_change_list(search, i, &change);
            if (!mus__seam_change_apply(facts, &change, search->trial)) continue;
            if (search->trial[a] == search->mate[a]) continue;
            const double score = mus__seam_score(search, search->trial);
            if (score <= highest) continue;
            highest = score;
            *other = search->trial[a];
        }
    return search->score - highest;
}
