/*
 * slips.h: what slips.c and the test of the tape's doubts share: the table of people, and the count of slips found.
 */
#ifndef MUS_TESTS_SLIPS_SLIPS_H
#define MUS_TESTS_SLIPS_SLIPS_H

#include "study/people/ansur.h"

#define SLIPS_NAMED_LEAST 0.80 /* share of the slips whose measure a sentence names */
#define SLIPS_FALSE_MOST 0.01  /* share of the people whose true tape has a warning */

typedef struct slips_count {
    long people, falsely;          /* people, and those whose true tape has a warning */
    long slips, named, otherwise;  /* slips, those whose measure is named, those with another measure named */
    long refused;                  /* the named ones that mus_tape_set() refuses */
    long offered;                  /* the named ones whose sentence offers the true value */
    long by[MUS_MEASURE_COUNT][2]; /* slips and named ones of each girth */
    long size[3][2];               /* the same of slips below 10, below 20 and of 20 cm and more */
} slips_count;

/* write lib/tape/tape_people.h from the rows 0, 2, 4 ... to `path`; false when it cannot be written */
bool slips_write_table(const ansur *table, const char *path);

/* count the rows half, half + 2 ...: true tapes, and each pair of neighbouring digits whose swap changes a girth by
 * more than 8 cm; `few`: tapes of stature, bust, waist and hip alone */
void slips_tally(mus_context *context, const ansur *table, int half, bool few, slips_count *count);

#endif
