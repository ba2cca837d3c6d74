/*
 * seams.c: the seams of patterns are taken away and found again: `make seams`.
 *
 *     build/bin/seams DATA [--every N] [--rounds N] [--drawings FOLDER] [--mixed] [--swap] [--fit FILE] [--list]
 *
 * The patterns are every N-th named design (default 8), each in one size, and every GarmentCode specification of the
 * folder DATA. They are in two halves: designs by the hash of their family, specifications by their number, so that the
 * variants of a garment are in one half. --fit fits the weights of lib/seam/seam_weights.c to the first half and
 * writes them; without it the weights of the library are judged. Both halves are printed. --swap exchanges the halves:
 * with --fit and --list it lists the errors in the fitted half by weights that never saw it. --rounds is that of the
 * annealing. The specifications of one body are also fitted without their sleeves, collars, upper and lower halves.
 * With --drawings the GarmentCode drawings of a folder are fitted in place of the specifications of DATA, which are
 * then all judged; so is one drawing of five. With --mixed every second design is fitted, whatever its family: the
 * judged ones are then not strangers, but other designs of known families.
 *
 * The fit: at the true sewing, at those that the search found, and at the true one without the seams of a panel, the
 * changes that the search would try are a group, in which one choice is right: the change that makes most seams right,
 * or none. The weights are those of highest likelihood of the right choices (conditional logit) by Newton's method with
 * a ridge; the search is run again with them, and its new errors become groups.
 *
 * Panels of one shape can stand for one another, and one that is the same upside down can be turned: the true sewing is
 * renamed by such exchanges as long as they make more of the found seams right.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "alike.h"
#include "sewn_garments.h"

#define D MUS__SEAM_FEATURES
#define RIDGE 4.0    /* in units of one group; chosen */
#define ROUNDS_FIT 6 /* of search and regression */
#define THIN 4       /* with drawings one garment in so many gives the first rows, all changes of its truth; chosen */
#define FAR 5.0      /* a sewing whose score is so far below that of the right one is left out */
#define BINS 10

#define NAME_OF(name, text) text,
static const char *const pair_names[MUS__SEAM_KIND] = {MUS__SEAM_PAIR(NAME_OF)};
static const char *const free_names[MUS__SEAM_FREE] = {MUS__SEAM_FREE_EDGE(NAME_OF)};
static const char *const whole_names[MUS__SEAM_WHOLES] = {MUS__SEAM_WHOLE(NAME_OF)};

static const char *feature_name(int32_t k)
{
    if (k < MUS__SEAM_KIND) return pair_names[k];
    if (k < MUS__SEAM_PAIRS) return k < MUS__SEAM_ROLE ? "a kind of seam" : "parts of a garment";
    k -= MUS__SEAM_PAIRS;
    if (k < MUS__SEAM_FREE) return free_names[k];
    if (k < MUS__SEAM_FREES) return k < MUS__SEAM_FREE_SIDE ? "a kind of free edge" : "a free edge of a part";
    return whole_names[k - MUS__SEAM_FREES];
}


/* ---- the fit ---- */

static void add_pairs(const garment *g, const int32_t *mate, const int32_t *less, double *x)
{
    double features[MUS__SEAM_PAIRS];
    for (int32_t a = 0; a < g->facts.n; a++)
        for (int32_t sign = 1; sign >= -1; sign -= 2) {
            const int32_t b = sign > 0 ? mate[a] : less[a];
            if (b <= a || mate[a] == less[a]) continue;
            mus__seam_pair(&g->facts, a, b, features);
            for (int32_t k = 0; k < MUS__SEAM_PAIRS; k++) x[k] += sign * features[k];
        }
    for (int32_t a = 0; a < g->facts.n; a++) {
        if ((mate[a] == MUS_NONE) == (less[a] == MUS_NONE)) continue;
        double free_edge[MUS__SEAM_FREES];
        mus__seam_free_edge(&g->facts, a, free_edge);
        for (int32_t k = 0; k < MUS__SEAM_FREES; k++)
            x[MUS__SEAM_PAIRS + k] += mate[a] == MUS_NONE ? free_edge[k] : -free_edge[k];
    }
}


static int32_t wrong_seams(const garment *g, const int32_t *mate)
{
    return seams_wrong(&g->facts, g->truth, mate);
}


/* a sewing less the one that is to be chosen from the same group: its features that differ */
typedef struct row {
    int32_t first, n;
} row;

typedef struct newton {
    double w[D], gradient[D], hessian[D * D];
    row *rows; /* those of a garment at one time follow one another */
    float *values;
    uint16_t *places;
    int64_t nrow, row_room, nvalue, value_room;
    double *z;     /* (nrow) scores less that of the truth */
    int32_t *groups; /* (ngroup) first row of each group */
    int32_t ngroup;
} newton;


/* the difference of a sewing from the one that is to be chosen, whose whole features are `base`, becomes a row */
static void add_row(newton *fit, const garment *g, const int32_t *mate, const int32_t *chosen, int32_t *scratch,
                    const double *base)
{
    double x[D] = {0};
    add_pairs(g, mate, chosen, x);
    mus__seam_whole(&g->facts, mate, scratch, x + D - MUS__SEAM_WHOLES);
    for (int32_t k = 0; k < MUS__SEAM_WHOLES; k++) x[D - MUS__SEAM_WHOLES + k] -= base[k];
    if (fit->nrow == fit->row_room) {
        fit->row_room = 2 * fit->row_room + 65536;
        fit->rows = realloc(fit->rows, sizeof *fit->rows * (size_t)fit->row_room);
    }
    if (fit->nvalue + D > fit->value_room) {
        fit->value_room = 2 * fit->value_room + 65536;
        fit->values = realloc(fit->values, sizeof *fit->values * (size_t)fit->value_room);
        fit->places = realloc(fit->places, sizeof *fit->places * (size_t)fit->value_room);
    }
    if (fit->rows == NULL || fit->values == NULL || fit->places == NULL) exit(1);
    row *r = &fit->rows[fit->nrow++];
    r->first = (int32_t)fit->nvalue;
    for (int32_t k = 0; k < D; k++)
        if (fabs(x[k]) > 1e-9) {
            fit->values[fit->nvalue] = (float)x[k];
            fit->places[fit->nvalue++] = (uint16_t)k;
        }
    r->n = (int32_t)fit->nvalue - r->first;
}


static double row_score(const newton *fit, const double *w, const row *r)
{
    double z = 0.0;
    for (int32_t i = r->first; i < r->first + r->n; i++) z += w[fit->places[i]] * (double)fit->values[i];
    return z;
}


/* the derivatives of the negative logarithm of a group's likelihood are added */
static void derive(newton *fit, int32_t first, int32_t end, double highest, double sum)
{
    double mean[D] = {0};
    for (int32_t i = first; i < end; i++) {
        const row *r = &fit->rows[i];
        const double p = exp(fit->z[i] - highest) / sum;
        if (p < 1e-6) continue; /* moves no weight by more than the fit's own end */
        for (int32_t a = r->first; a < r->first + r->n; a++) {
            const double pa = p * (double)fit->values[a];
            double *h = fit->hessian + fit->places[a] * D;
            mean[fit->places[a]] += pa;
            for (int32_t b = r->first; b <= a; b++) h[fit->places[b]] += pa * (double)fit->values[b];
        }
    }
    for (int32_t a = 0; a < D; a++) {
        fit->gradient[a] += mean[a];
        for (int32_t b = 0; b <= a; b++) fit->hessian[a * D + b] -= mean[a] * mean[b];
    }
}


/* negative logarithm of the likelihood of the chosen sewings, each within its group; its derivatives on request */
static double likelihood(newton *fit, const double *w, bool with_derivatives)
{
    double loss = 0.0;
    if (with_derivatives) memset(fit->gradient, 0, sizeof fit->gradient);
    if (with_derivatives) memset(fit->hessian, 0, sizeof fit->hessian);
    for (int32_t k = 0; k < D; k++) loss += 0.5 * RIDGE * w[k] * w[k];
    for (int64_t i = 0; i < fit->nrow; i++) fit->z[i] = row_score(fit, w, &fit->rows[i]);
    for (int32_t g = 0; g < fit->ngroup; g++) {
        const int32_t first = fit->groups[g], end = g + 1 < fit->ngroup ? fit->groups[g + 1] : (int32_t)fit->nrow;
        double highest = 0.0, sum;
        for (int32_t i = first; i < end; i++) highest = fmax(highest, fit->z[i]);
        sum = exp(-highest);
        for (int32_t i = first; i < end; i++) sum += exp(fit->z[i] - highest);
        loss += highest + log(sum);
        if (with_derivatives) derive(fit, first, end, highest, sum);
    }
    return loss;
}


/* the step of Newton's method (H + ridge)^-1 (g + ridge w), into the gradient, by Cholesky */
static void newton_step(newton *fit)
{
    double *h = fit->hessian, *g = fit->gradient;
    for (int32_t k = 0; k < D; k++) {
        h[k * D + k] += RIDGE;
        g[k] += RIDGE * fit->w[k];
    }
    for (int32_t i = 0; i < D; i++)
        for (int32_t k = 0; k <= i; k++) {
            double sum = h[i * D + k];
            for (int32_t m = 0; m < k; m++) sum -= h[i * D + m] * h[k * D + m];
            h[i * D + k] = i == k ? sqrt(fmax(sum, 1e-9)) : sum / h[k * D + k];
        }
    for (int32_t i = 0; i < D; i++) {
        for (int32_t m = 0; m < i; m++) g[i] -= h[i * D + m] * g[m];
        g[i] /= h[i * D + i];
    }
    for (int32_t i = D - 1; i >= 0; i--) {
        for (int32_t m = i + 1; m < D; m++) g[i] -= h[m * D + i] * g[m];
        g[i] /= h[i * D + i];
    }
}


/* the change of a sewing that makes most seams right, of several the one of highest score; NULL where none does */
static bool best_change(const garment *g, mus__seam_search *search, const int32_t *mate, int32_t *best)
{
    const size_t bytes = sizeof *mate * (size_t)g->facts.n;
    int32_t fewest = wrong_seams(g, mate) - 1;
    double highest = -HUGE_VAL;
    bool any = false;
    mus__seam_change change;
    for (int32_t k = 0; mus__seam_change_list(search, k, &change); k++) {
        memcpy(search->trial, mate, bytes);
        if (!mus__seam_change_apply(&g->facts, &change, search->trial)) continue;
        const int32_t wrong = wrong_seams(g, search->trial);
        if (wrong > fewest) continue;
        const double score = mus__seam_score(search, search->trial);
        if (wrong == fewest && score <= highest) continue;
        fewest = wrong;
        highest = score;
        any = true;
        memcpy(best, search->trial, bytes);
    }
    return any;
}


/* a group: from a sewing, the best change against all that make no seam right, and against no change; from the true
 * one, no change against all; `other` is one more sewing that is not to be chosen, or NULL */
static void add_group(newton *fit, garment *g, mus__seam_search *search, const int32_t *mate, const int32_t *other,
                      bool all)
{
    const size_t bytes = sizeof *mate * (size_t)g->facts.n;
    const int32_t wrong = wrong_seams(g, mate);
    double base[MUS__SEAM_WHOLES];
    mus__seam_change change;
    int32_t *chosen = malloc(bytes + 1);
    memcpy(chosen, mate, bytes);
    if (wrong > 0 && !best_change(g, search, mate, chosen)) {
        free(chosen);
        return;
    }
    fit->groups = realloc(fit->groups, sizeof *fit->groups * (size_t)(fit->ngroup + 1));
    fit->groups[fit->ngroup++] = (int32_t)fit->nrow;
    mus__seam_whole(&g->facts, chosen, search->scratch, base);
    const double least = all ? -HUGE_VAL : mus__seam_score(search, chosen) - FAR;
    if (wrong > 0) add_row(fit, g, mate, chosen, search->scratch, base);
    if (other != NULL) add_row(fit, g, other, chosen, search->scratch, base);
    for (int32_t k = 0; mus__seam_change_list(search, k, &change); k++) {
        memcpy(search->trial, mate, bytes);
        if (!mus__seam_change_apply(&g->facts, &change, search->trial)) continue;
        if (wrong_seams(g, search->trial) < wrong || memcmp(search->trial, mate, bytes) == 0) continue;
        if (least >= mus__seam_score(search, search->trial)) continue;
        add_row(fit, g, search->trial, chosen, search->scratch, base);
    }
    free(chosen);
}


/* the groups of a garment: about the truth, about the sewing that the search found, about the truth without a panel */
static void add_groups(newton *fit, garment *g, int32_t round)
{
    mus__seam_search search;
    if (mus__seam_begin(&g->facts, fit->w, &search) != MUS_OK) exit(1);
    const bool wrong = round > 0 && wrong_seams(g, g->found) > 0;
    if (round == 0 || wrong) add_group(fit, g, &search, g->truth, wrong ? g->found : NULL, round == 0);
    if (wrong) add_group(fit, g, &search, g->found, NULL, false);
    for (int32_t k = 0; round > 0 && k < 2; k++) {
        const int32_t p = (2 * round + k) % g->facts.npanel;
        memcpy(search.keep, g->truth, sizeof *g->truth * (size_t)g->facts.n);
        for (int32_t a = 0; a < g->facts.n; a++) {
            const int32_t b = search.keep[a];
            if (b == MUS_NONE || (g->facts.edges[a].panel != p && g->facts.edges[b].panel != p)) continue;
            search.keep[a] = search.keep[b] = MUS_NONE;
        }
        if (wrong_seams(g, search.keep) > 0) add_group(fit, g, &search, search.keep, NULL, false);
    }
    mus__seam_end(&search);
    fit->z = realloc(fit->z, sizeof *fit->z * (size_t)(fit->nrow + 1));
    if (fit->z == NULL) exit(1);
}


static void regress(newton *fit, int32_t steps)
{
    double loss = 0.0;
    for (int32_t step = 0; step < steps; step++) {
        double w[D], t = 1.0;
        const double before = loss = likelihood(fit, fit->w, true);
        newton_step(fit);
        for (; t > 1e-4; t *= 0.5) {
            for (int32_t k = 0; k < D; k++) w[k] = fit->w[k] - t * fit->gradient[k];
            loss = likelihood(fit, w, false);
            if (loss < before) break;
        }
        if (loss >= before) break;
        memcpy(fit->w, w, sizeof w);
        if (before - loss < 1e-3 * before) break;
    }
    fprintf(stderr, "%lld rows, loss %.2f\n", (long long)fit->nrow, loss);
}


/* ---- the judgement ---- */

typedef struct tally {
    int32_t garments, whole, seams, right, found, missed_by_search;
    int32_t wrong[4]; /* garments of 1, 2, 3 to 5 and more seams that are missed or wrong */
} tally;

static tally tallies[2][KINDS_OF_GARMENTS]; /* half, kind */
static int32_t bins[2][BINS][2]; /* half, confidence, right */
static double *margins; /* (nmargin x 2) of the fitted half: margin of a seam that was found, 1 where it is right */
static int64_t nmargin;


/* counts a seam that was found by its confidence; of the fitted half, keeps its margin */
static void count_confidence(const garment *g, mus__seam_search *search, int32_t a, const double *confidence)
{
    int32_t other;
    const double margin = mus__seam_margin(search, a, &other);
    const double p = 1.0 / (1.0 + exp(-confidence[0] * margin - confidence[1]));
    const int32_t right = search->mate[a] == g->truth[a], bin = (int32_t)(p * BINS);
    bins[g->judged][bin < BINS ? bin : BINS - 1][right]++;
    if (g->judged) return;
    margins = realloc(margins, (size_t)(nmargin + 1) * 2 * sizeof *margins);
    if (margins == NULL) exit(1);
    margins[2 * nmargin] = margin;
    margins[2 * nmargin + 1] = right;
    nmargin++;
}


/* the logistic regression of right on the margin: factor and constant */
static void fit_confidence(double *c)
{
    c[0] = c[1] = 0.0;
    for (int32_t step = 0; step < 30; step++) {
        double g0 = 0.0, g1 = 0.0, h00 = 1e-6, h01 = 0.0, h11 = 1e-6;
        for (int64_t i = 0; i < nmargin; i++) {
            const double x = margins[2 * i], p = 1.0 / (1.0 + exp(-c[0] * x - c[1]));
            const double r = margins[2 * i + 1] - p, h = p * (1.0 - p);
            g0 += r * x;
            g1 += r;
            h00 += h * x * x;
            h01 += h * x;
            h11 += h;
        }
        const double d = h00 * h11 - h01 * h01;
        c[0] += (h11 * g0 - h01 * g1) / d;
        c[1] += (h00 * g1 - h01 * g0) / d;
    }
}


static void write_weights(const char *path, const double *w, const double *c)
{
    FILE *f = fopen(path, "w");
    int column = 0;
    if (f == NULL) return;
    fprintf(
        f, "/*\n * seam_weights.c: weights of the features of a sewing, and of the confidence. Written by `make seams\n"
           " * SEAMS='--fit lib/seam/seam_weights.c'`; do not edit.\n */\n#include \"seam/seam_find.h\"\n\n"
           "const int16_t mus__seam_weights[MUS__SEAM_FEATURES] = {\n");
    for (int32_t k = 0; k < D; k++) {
        const long weight = lrint(w[k] / MUS__SEAM_WEIGHT_UNIT);
        const bool begins = k == 0 || strcmp(feature_name(k), feature_name(k - 1)) != 0;
        const bool same = k + 1 < D && strcmp(feature_name(k), feature_name(k + 1)) == 0;
        if (begins) column = fprintf(f, "    /* %s */", feature_name(k));
        if (column > 110) column = fprintf(f, "\n   ") - 1;
        column += fprintf(f, " %ld,%s", weight, same ? "" : "\n");
    }
    fprintf(f, "};\n\n/* factor and constant of the margin */\nconst double mus__seam_confidence[2] = {%.6g, %.6g};\n",
            c[0], c[1]);
    fclose(f);
}


static void judge(garment *g, const double *weights, int32_t rounds, bool keep, bool list, const double *confidence)
{
    mus__seam_search search;
    tally *t = &tallies[g->judged][g->kind], none = {0};
    if (g->part) t = &none;
    if (mus__seam_begin(&g->facts, weights, &search) != MUS_OK) exit(1);
    mus__seam_run(&search, rounds);
    seams_match(&g->facts, g->truth, search.mate);
    const int32_t wrong = wrong_seams(g, search.mate);
    t->garments++;
    t->whole += wrong == 0;
    if (wrong > 0) t->wrong[wrong < 3 ? wrong - 1 : wrong < 6 ? 2 : 3]++;
    for (int32_t a = 0; a < g->facts.n; a++) {
        const int32_t b = search.mate[a], c = g->truth[a];
        t->seams += c > a;
        t->found += b > a;
        t->right += b > a && b == c;
        if (confidence != NULL && b > a) count_confidence(g, &search, a, confidence);
        if (list && ((b > a && b != c) || (c > a && b != c))) {
            const mus__seam_edge *e = g->facts.edges;
            const int32_t at[3] = {a, b, c};
            printf("  %s:", g->name);
            for (int32_t k = 0; k < 3; k++) {
                printf(k == 0 ? " " : k == 1 ? "  FOUND " : "  TRUTH ");
                if (at[k] == MUS_NONE)
                    printf("-");
                else
                    printf("%s.%d (%.0f mm, %.2f rad)", mus_pattern_panel_name(g->pattern, e[at[k]].panel),
                           at[k] - g->facts.panels[e[at[k]].panel].first, 1e3 * e[at[k]].length, e[at[k]].turn);
            }
            if (b != MUS_NONE && c != MUS_NONE)
                printf("  pair scores %.1f %.1f", search.pairs[a * g->facts.n + b], search.pairs[a * g->facts.n + c]);
            printf("\n");
        }
    }
    t->missed_by_search += mus__seam_score(&search, g->truth) > search.score + 1e-6;
    if (keep) {
        if (g->found == NULL) g->found = malloc(sizeof(int32_t) * (size_t)(g->facts.n + 1));
        memcpy(g->found, search.mate, sizeof(int32_t) * (size_t)g->facts.n);
    }
    mus__seam_end(&search);
}


static void print_tallies(void)
{
    for (int32_t half = 0; half < 2; half++)
        for (int32_t kind = 0; kind < KINDS_OF_GARMENTS; kind++) {
            static const char *const kinds[KINDS_OF_GARMENTS] = {"specifications", "named designs", "drawings"};
            const tally *t = &tallies[half][kind];
            if (t->garments == 0) continue;
            printf("%-6s %-14s %4d garments, whole %5.1f %%; %5d seams, found %5.1f %%, right of the found %5.1f %%; "
                   "truth scores better in %d; garments of 1, 2, 3 to 5, more errors: %d %d %d %d\n",
                   half ? "judged" : "fitted", kinds[kind], t->garments,
                   100.0 * t->whole / t->garments, t->seams, 100.0 * t->right / fmax(1, t->seams),
                   100.0 * t->right / fmax(1, t->found), t->missed_by_search, t->wrong[0], t->wrong[1], t->wrong[2],
                   t->wrong[3]);
        }
    memset(tallies, 0, sizeof tallies);
}


static void print_confidence(void)
{
    for (int32_t half = 0; half < 2; half++)
        for (int32_t b = 0; b < BINS; b++) {
            const int32_t n = bins[half][b][0] + bins[half][b][1];
            if (n > 0)
                printf("%-6s confidence %.1f to %.1f: %5d seams, %5.1f %% right\n", half ? "judged" : "fitted",
                       (double)b / BINS, (b + 1.0) / BINS, n, 100.0 * bins[half][b][1] / n);
        }
    memset(bins, 0, sizeof bins);
}


static void fit_weights(newton *fit, const garments *all)
{
    /* the first rows need the edges whose lengths are nearest */
    fit->w[MUS__SEAM_RATIO] = -1.0;
    for (int32_t round = 0; round < ROUNDS_FIT; round++) {
        for (int32_t i = 0; i < all->n; i++)
            if (!all->list[i].judged && (round > 0 || !all->drawn || i % THIN == 0))
                add_groups(fit, &all->list[i], round);
        regress(fit, 20);
        for (int32_t i = 0; i < all->n; i++)
            if (!all->list[i].judged) judge(&all->list[i], fit->w, round > 1, true, false, NULL);
        print_tallies();
        fflush(stdout);
    }
}


int main(int argc, char **argv)
{
    int32_t every = 8, rounds = 4;
    const char *out = NULL;
    bool list = false;
    garments all = {0};
    mus_context *context = NULL;
    if (argc < 2 || mus_context_create(NULL, &context) != MUS_OK) return 1;
    for (int i = 2; i < argc; i++) {
        if (strcmp(argv[i], "--every") == 0 && i + 1 < argc)
            every = atoi(argv[++i]);
        else if (strcmp(argv[i], "--rounds") == 0 && i + 1 < argc)
            rounds = atoi(argv[++i]);
        else if (strcmp(argv[i], "--drawings") == 0 && i + 1 < argc)
            garments_add_drawings(&all, context, argv[++i]);
        else if (strcmp(argv[i], "--fit") == 0 && i + 1 < argc)
            out = argv[++i];
        else if (strcmp(argv[i], "--mixed") == 0)
            all.mixed = true;
        else if (strcmp(argv[i], "--swap") == 0)
            all.swap = true;
        else if (strcmp(argv[i], "--list") == 0)
            list = true;
    }
    garments_add_designs(&all, context, every);
    garments_add_specifications(&all, context, argv[1], out != NULL);
    static newton fit;
    double confidence[2] = {mus__seam_confidence[0], mus__seam_confidence[1]};
    for (int32_t k = 0; k < D; k++) fit.w[k] = MUS__SEAM_WEIGHT_UNIT * mus__seam_weights[k];
    if (out != NULL) {
        memset(fit.w, 0, sizeof fit.w);
        fit_weights(&fit, &all);
        for (int32_t i = 0; i < all.n; i++)
            if (!all.list[i].judged && !all.list[i].part) judge(&all.list[i], fit.w, 0, false, false, confidence);
        memset(tallies, 0, sizeof tallies);
        memset(bins, 0, sizeof bins);
        fit_confidence(confidence);
        write_weights(out, fit.w, confidence);
    }
    for (int32_t i = 0; i < all.n; i++)
        if (!all.list[i].part) judge(&all.list[i], fit.w, rounds, false, list, confidence);
    print_tallies();
    print_confidence();
    return 0;
}
