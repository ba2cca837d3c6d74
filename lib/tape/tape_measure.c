/*
 * tape_measure.c: the table of measures: name, aliases, unit and range of each, and a value as text.
 *
 * The table is MUS_MEASURE_LIST of muslin/tape.h. The terms are those of ISO 8559-1:2017.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tape/tape_internal.h"

typedef struct tape_measure {
    const char *name;
    int32_t unit;
    double low, high;
} tape_measure;

static const tape_measure tape_measures[MUS_MEASURE_COUNT] = {
#define TAPE_MEASURE(NAME, name, unit, low, high) {name, unit, low, high},
    MUS_MEASURE_LIST(TAPE_MEASURE)
#undef TAPE_MEASURE
};

/* other names of measures, as measurement sheets and other programs use them */
static const struct {
    const char *name;
    int32_t measure;
} tape_aliases[] = {
    {"height", MUS_MEASURE_STATURE},
    {"chest", MUS_MEASURE_BUST},
    {"seat", MUS_MEASURE_HIP},
    {"neck_base", MUS_MEASURE_NECK},
    {"shoulder_length", MUS_MEASURE_SHOULDER},
    {"nape_to_waist", MUS_MEASURE_BACK_WAIST},
    {"arm_length", MUS_MEASURE_ARM},
    {"biceps", MUS_MEASURE_UPPER_ARM},
    {"body_rise", MUS_MEASURE_RISE},
    {"inseam", MUS_MEASURE_INLEG},
    {"inside_leg", MUS_MEASURE_INLEG},
    {"bust_point_span", MUS_MEASURE_BUST_SPAN},
    {"foot_length", MUS_MEASURE_FOOT},
    {"crotch_height", MUS_MEASURE_INLEG},
};


int32_t mus_measure_count(void)
{
    return MUS_MEASURE_COUNT;
}


const char *mus_measure_name(int32_t measure)
{
    return measure >= 0 && measure < MUS_MEASURE_COUNT ? tape_measures[measure].name : NULL;
}


int32_t mus_measure_unit(int32_t measure)
{
    return measure >= 0 && measure < MUS_MEASURE_COUNT ? tape_measures[measure].unit : 0;
}


int32_t mus_measure_find(const char *name)
{
    if (name == NULL) return MUS_NONE;
    for (int32_t i = 0; i < MUS_MEASURE_COUNT; i++)
        if (strcmp(name, tape_measures[i].name) == 0) return i;
    for (size_t i = 0; i < sizeof tape_aliases / sizeof *tape_aliases; i++)
        if (strcmp(name, tape_aliases[i].name) == 0) return tape_aliases[i].measure;
    return MUS_NONE;
}


void mus__tape_range(int32_t measure, double *low, double *high)
{
    *low = 0.5 * tape_measures[measure].low;
    *high = 2.0 * tape_measures[measure].high;
}


const char *mus__tape_text(int32_t measure, double value, char *out)
{
    /* whole part and tenth are printed as integers: printf takes the decimal sign from the locale */
    bool angle = tape_measures[measure].unit == 'r';
    double scaled = angle ? value * (1800.0 / 3.14159265358979323846) : value * 1000.0;
    if (!(scaled > -1e9 && scaled < 1e9)) scaled = 0.0;
    long tenths = lround(scaled);
    snprintf(out, MUS__TAPE_TEXT_BYTES, "%s%ld.%ld %s", tenths < 0 ? "-" : "", labs(tenths) / 10, labs(tenths) % 10,
             angle ? "deg" : "cm");
    return out;
}
