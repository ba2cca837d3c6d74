/*
 * tape_size.c: the 28 table sizes, as tapes.
 *
 * Women W34 to W52 and men M46 to M60 in the steps of bust (chest), waist and hip of EN 13402-3; children C56 to C164
 * by stature. A size gives stature and the three girths. The other rows of printed size tables are what tape_derive.c
 * derives, to 0.05 cm; tests/tape/test_tape_size.c holds that.
 */
#include <math.h>
#include <string.h>

#include "tape/tape_internal.h"

/* a size: stature and girths [cm] */
typedef struct tape_size {
    const char *name;
    double stature, bust, waist, hip;
} tape_size;

static const tape_size tape_sizes[] = {
    {"W34", 168, 80, 64, 90},      {"W36", 168, 84, 68, 94},      {"W38", 168, 88, 72, 97},
    {"W40", 168, 92, 76, 100},     {"W42", 168, 96, 80, 103},     {"W44", 168, 100, 84, 106},
    {"W46", 168, 104, 88, 109},    {"W48", 168, 110, 94, 114},    {"W50", 168, 116, 100, 119},
    {"W52", 168, 122, 106, 124},   {"M46", 171, 92, 80, 95},      {"M48", 174, 96, 84, 98.5},
    {"M50", 177, 100, 88, 102},    {"M52", 179, 104, 92, 105.5},  {"M54", 181, 108, 97, 109.5},
    {"M56", 183, 112, 102, 113.5}, {"M58", 184, 116, 107, 117.5}, {"M60", 185, 120, 112, 121.5},
    {"C56", 56, 42.5, 42, 42.5},   {"C68", 68, 46.5, 46, 47},     {"C80", 80, 50, 48.5, 51},
    {"C92", 92, 53.5, 51, 55},     {"C104", 104, 56.5, 53, 58.5}, {"C116", 116, 60.5, 55.5, 63.5},
    {"C128", 128, 65, 58, 68.5},   {"C140", 140, 71, 62, 75},     {"C152", 152, 77, 65.5, 82},
    {"C164", 164, 83.5, 69, 89},
};

#define TAPE_SIZE_COUNT ((int32_t)(sizeof tape_sizes / sizeof *tape_sizes))
#define TAPE_CHILD_FIRST 18 /* row of the first child, C56 */


int32_t mus_tape_size_count(void)
{
    return TAPE_SIZE_COUNT;
}


const char *mus_tape_size_name(int32_t index)
{
    return index >= 0 && index < TAPE_SIZE_COUNT ? tape_sizes[index].name : NULL;
}


double mus__tape_child_girth(double stature, int32_t measure)
{
    /* linear between the two rows round this stature, and beyond the ends on the line of the last two rows */
    double h = 100.0 * stature;
    int32_t i = TAPE_CHILD_FIRST;
    while (i + 2 < TAPE_SIZE_COUNT && h > tape_sizes[i + 1].stature) i++;
    const tape_size *p = &tape_sizes[i], *q = p + 1;
    double t = (h - p->stature) / (q->stature - p->stature);
    double a = measure == MUS_MEASURE_BUST ? p->bust : measure == MUS_MEASURE_WAIST ? p->waist : p->hip;
    double b = measure == MUS_MEASURE_BUST ? q->bust : measure == MUS_MEASURE_WAIST ? q->waist : q->hip;
    return 0.01 * (a + t * (b - a));
}


mus_status mus_tape_set_size(mus_tape *tape, const char *size)
{
    if (tape == NULL) return MUS_ERR_ARG;
    int32_t i = 0;
    while (size != NULL && i < TAPE_SIZE_COUNT && strcmp(size, tape_sizes[i].name) != 0) i++;
    if (size == NULL || i == TAPE_SIZE_COUNT)
        return mus__fail(tape->context, MUS_ERR_ARG,
                         "size %.40s is not known; there are W34 W36 W38 W40 W42 W44 W46 W48 W50 W52, "
                         "M46 M48 M50 M52 M54 M56 M58 M60, C56 C68 C80 C92 C104 C116 C128 C140 C152 C164",
                         size != NULL ? size : "(NULL)");

    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) mus_tape_set(tape, m, NAN, MUS_SOURCE_GIVEN);
    const tape_size *row = &tape_sizes[i];
    tape->sex = row->name[0] == 'W' ? MUS_SEX_FEMALE : row->name[0] == 'M' ? MUS_SEX_MALE : MUS_SEX_CHILD;
    tape->warning_count = 0;
    mus_tape_set_name(tape, row->name);
    mus_tape_set(tape, MUS_MEASURE_STATURE, 0.01 * row->stature, MUS_SOURCE_GIVEN);
    mus_tape_set(tape, MUS_MEASURE_BUST, 0.01 * row->bust, MUS_SOURCE_GIVEN);
    mus_tape_set(tape, MUS_MEASURE_WAIST, 0.01 * row->waist, MUS_SOURCE_GIVEN);
    mus_tape_set(tape, MUS_MEASURE_HIP, 0.01 * row->hip, MUS_SOURCE_GIVEN);
    return MUS_OK;
}
