/*
 * tally.c: true tapes of the people of ANSUR II, and the same with one pair of digits of a girth swapped, completed.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "slips.h"

#define SLIP_LEAST 0.08 /* [m] smaller slips are not counted */


/* whether `text` starts with the measure's name, or names it as the likely slip of a contradiction */
static bool names(const char *text, int32_t measure)
{
    char word[40];
    snprintf(word, sizeof word, "%s of ", mus_measure_name(measure));
    const char *doubt = strrchr(text, '(');
    return strncmp(doubt != NULL ? doubt + 1 : text, word, strlen(word)) == 0;
}


static mus_tape *tape_of(mus_context *context, const ansur *table, int row, bool few)
{
    mus_tape *tape = ansur_tape(context, table, row);
    for (int32_t m = 0; few && tape != NULL && m < MUS_MEASURE_COUNT; m++)
        if (m > MUS_MEASURE_HIP) mus_tape_set(tape, m, NAN, MUS_SOURCE_GIVEN);
    return tape;
}


/* one slip: 0 not found, 1 named, 2 another measure named, 3 refused by mus_tape_set with its name; counts it as
 * offered when the sentence ends with the true value, that of the tape */
static int slip(mus_context *context, const mus_tape *tape, int32_t measure, double value, long *offered)
{
    mus_tape *copy;
    char end[40];
    snprintf(end, sizeof end, ": %.1f cm?", 100.0 * mus_tape_value(tape, measure));
    if (mus_tape_copy(tape, &copy) != MUS_OK) exit(2);
    int found = 0;
    if (mus_tape_set(copy, measure, value, MUS_SOURCE_GIVEN) != MUS_OK)
        found = 3;
    else if (mus_tape_complete(copy) != MUS_OK)
        found = names(mus_context_error(context), measure) ? 1 : 2;
    if (found == 1) *offered += strstr(mus_context_error(context), end) != NULL;
    for (int32_t i = 0; found != 1 && i < mus_tape_warning_count(copy); i++) {
        found = names(mus_tape_warning(copy, i), measure) ? 1 : 2;
        if (found == 1) *offered += strstr(mus_tape_warning(copy, i), end) != NULL;
    }
    mus_tape_destroy(copy);
    return found;
}


static void slips_of(mus_context *context, const mus_tape *tape, int32_t measure, slips_count *t)
{
    char text[16];
    const double true_value = mus_tape_value(tape, measure);
    const int n = snprintf(text, sizeof text, "%ld", lround(1000.0 * true_value)); /* digits of cm with a tenth */
    for (int i = 0; i + 1 < n; i++) {
        char swapped[16];
        memcpy(swapped, text, sizeof text);
        swapped[i] = text[i + 1];
        swapped[i + 1] = text[i];
        const double value = 0.001 * (double)atol(swapped), off = fabs(value - true_value);
        if (off <= SLIP_LEAST + 1e-9) continue;
        const int found = slip(context, tape, measure, value, &t->offered), named = found == 1 || found == 3;
        const int size = off < 0.0999 ? 0 : off < 0.1999 ? 1 : 2;
        t->slips++;
        t->named += named;
        t->otherwise += found == 2;
        t->refused += found == 3;
        t->by[measure][0]++, t->by[measure][1] += named;
        t->size[size][0]++, t->size[size][1] += named;
    }
}


void slips_tally(mus_context *context, const ansur *table, int half, bool few, slips_count *t)
{
    for (int row = half; row < table->rows; row += 2) {
        mus_tape *tape = tape_of(context, table, row, few);
        if (tape == NULL || mus_tape_complete(tape) != MUS_OK) exit(2);
        t->people++;
        t->falsely += mus_tape_warning_count(tape) > 0;
        for (int i = 0; i < ANSUR_MEASURES; i++)
            if (!ansur_measures[i].height && mus_tape_source(tape, ansur_measures[i].measure) == MUS_SOURCE_GIVEN)
                slips_of(context, tape, ansur_measures[i].measure, t);
        mus_tape_destroy(tape);
    }
}
