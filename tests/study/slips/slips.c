/*
 * slips.c: what a tape's check finds when one pair of digits of a girth is swapped: `make slips`.
 *
 * slips TABLE [--write HEADER]. With --write, every second person of ANSUR II gives the means, deviations and
 * correlations of lib/tape/tape_people.h (`make slips SLIPS='--write lib/tape/tape_people.h'`). Without, the library
 * completes the tape of every person as it is, which should warn of nothing, and once for each pair of neighbouring
 * digits whose swap changes a girth by more than 8 cm, which should name the girth. Printed for the half of the people
 * that the table was made of and for the other half, and for tapes of stature, bust, waist and hip alone. Exit 1 when
 * fewer than 80 % of the slips are named or 1 % of the people are falsely warned of.
 */
#include <stdio.h>
#include <string.h>

#include "slips.h"


static bool print_tally(const char *who, const slips_count *t)
{
    static const char *const sizes[] = {"8 to 10 cm", "10 to 20 cm", "20 cm and more"};
    const double named = (double)t->named / (double)t->slips, falsely = (double)t->falsely / (double)t->people;
    const double slips = 0.01 * (double)t->slips, taken = 0.01 * (double)(t->slips - t->refused);
    printf("%s: %ld people, %ld falsely warned of (%.2f %%)\n", who, t->people, t->falsely, 100 * falsely);
    printf("  %ld slips: %.1f %% named, %.1f %% with another measure named; %.1f %% are refused as out of range\n",
           t->slips, 100 * named, (double)t->otherwise / slips, (double)t->refused / slips);
    printf("  of those not refused: %.1f %% named, %.1f %% with the true value\n",
           (double)(t->named - t->refused) / taken, (double)t->offered / taken);
    for (int i = 0; i < 3; i++)
        printf("  %s: %ld, %.0f %%;", sizes[i], t->size[i][0], 100.0 * (double)t->size[i][1] / (double)t->size[i][0]);
    printf("\n ");
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++)
        if (t->by[m][0] > 0)
            printf(" %s %.0f %%", mus_measure_name(m), 100.0 * (double)t->by[m][1] / (double)t->by[m][0]);
    printf("\n");
    return named >= SLIPS_NAMED_LEAST && falsely < SLIPS_FALSE_MOST;
}


int main(int argc, char **argv)
{
    ansur table;
    mus_context *context;
    if (argc != 2 && !(argc == 4 && strcmp(argv[2], "--write") == 0)) {
        fprintf(stderr, "usage: slips TABLE [--write HEADER]\n");
        return 2;
    }
    if (!ansur_open(&table, argv[1]) || mus_context_create(NULL, &context) != MUS_OK) {
        fprintf(stderr, "slips: %s cannot be read\n", argv[1]);
        return 2;
    }
    bool good = true;
    if (argc == 4) {
        good = slips_write_table(&table, argv[3]);
    } else {
        static const char *const who[2][2] = {{"13 measures, half of the table", "13 measures, the other half"},
                                              {"4 measures, half of the table", "4 measures, the other half"}};
        for (int few = 0; few < 2; few++)
            for (int half = 0; half < 2; half++) {
                slips_count t = {0};
                slips_tally(context, &table, half, few == 1, &t);
                good = print_tally(who[few][half], &t) && good;
            }
    }
    mus_context_destroy(context);
    ansur_close(&table);
    return good ? 0 : 1;
}
