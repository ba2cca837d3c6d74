/*
 * nest_separate.c: move items of a strip of fixed length until none overlap.
 *
 * Guided local search: each item that overlaps is moved, in random order, to a place of less weighted loss. After each
 * round the weights of the pairs that overlap grow, the most for the worst pair, and those of the others decay. So a
 * pair that stays in the way becomes dear, until one of the two goes elsewhere.
 * Source: Gardeyn, Vanden Berghe, Wauters, An open-source heuristic to reboot 2D nesting research, 2025 (sparrow),
 * section 6, whose factors are taken over; Umetani and Murakami, Coordinate descent heuristics for the irregular strip
 * packing problem of rasterized shapes, 2022; Voudouris and Tsang, Guided local search, 1999.
 */
#include <math.h>
#include <string.h>

#include "nest/nest_run.h"

#define SEPARATE_GROW_LEAST 1.2 /* factor of the weight of a pair that overlaps a little */
#define SEPARATE_GROW_MOST 2.0  /* of the worst pair */
#define SEPARATE_DECAY 0.95     /* of a pair that does not overlap */
#define SEPARATE_PROGRESS 0.98  /* a loss below this part of the least is progress */


/* sum of the losses of all pairs, and the largest */
static double separate_loss(const mus__nest_run *run, double *most)
{
    const int32_t n = run->problem->n;
    double sum = 0.0;
    *most = 0.0;
    for (int32_t i = 0; i < n; i++) {
        for (int32_t j = i; j < n; j++) {
            const double loss = run->loss[(int64_t)i * n + j];
            sum += loss;
            *most = fmax(*most, loss);
        }
    }
    return sum;
}


static void separate_weigh(mus__nest_run *run, double most)
{
    const int64_t n = run->problem->n;
    for (int64_t k = 0; k < n * n; k++) {
        const double loss = run->loss[k], weight = run->weight[k];
        run->weight[k] = loss > 0.0
                             ? weight * (SEPARATE_GROW_LEAST + (SEPARATE_GROW_MOST - SEPARATE_GROW_LEAST) * loss / most)
                             : fmax(1.0, weight * SEPARATE_DECAY);
    }
}


/* move each item that overlaps, in random order */
static void separate_round(mus__nest_run *run)
{
    const int32_t n = run->problem->n;
    for (int32_t i = 0; i < n; i++) {
        const int32_t k = mus__nest_below(run, i + 1);
        run->order[i] = run->order[k];
        run->order[k] = i;
    }
    for (int32_t k = 0; k < n; k++) {
        const int32_t i = run->order[k];
        bool overlaps = false;
        for (int32_t j = 0; j < n && !overlaps; j++) overlaps = run->loss[(int64_t)i * n + j] > 0.0;
        if (overlaps) mus__nest_search(run, i);
    }
}


bool mus__nest_separate(mus__nest_run *run, int32_t strikes, int32_t patience)
{
    const int64_t n = run->problem->n;
    double most, loss = separate_loss(run, &most);
    for (int64_t k = 0; k < n * n; k++) run->weight[k] = 1.0;
    mus__nest_keep(run, loss, &run->least);
    for (int32_t strike = 0; strike < strikes && loss > 0.0;) {
        const double before = run->least.loss;
        for (int32_t quiet = 0; quiet < patience && loss > 0.0; quiet++) {
            if (mus__nest_over(run)) return false;
            separate_round(run);
            loss = separate_loss(run, &most);
            if (loss < run->least.loss) {
                if (loss < SEPARATE_PROGRESS * run->least.loss) quiet = -1;
                mus__nest_keep(run, loss, &run->least);
            }
            if (loss > 0.0) separate_weigh(run, most);
        }
        if (!(loss > 0.0)) break;
        strike = run->least.loss < SEPARATE_PROGRESS * before ? 0 : strike + 1;
        mus__nest_restore(run, &run->least);
    }
    return !(loss > 0.0);
}
