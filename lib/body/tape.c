/*
 * tape.c: the measures of one person: names, setting and reading, copying, completion.
 *
 * A tape is a flat array by measure. A value that the caller set is held; completion derives all others anew
 * (tape_derive.c) on a copy, checks the sheet (tape_check.c), and only then replaces the tape, so a failed completion
 * leaves it as it was. Terms are those of ISO 8559-1.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "body/tape_internal.h"

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

/* other words for the same measure, as sheets and other programs call them */
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
    /* digits by hand: printf takes the decimal sign from the locale */
    bool angle = tape_measures[measure].unit == 'r';
    double scaled = angle ? value * (1800.0 / 3.14159265358979323846) : value * 1000.0;
    if (!(scaled > -1e9 && scaled < 1e9)) scaled = 0.0;
    long tenths = lround(scaled);
    snprintf(out, MUS_TAPE_TEXT_BYTES, "%s%ld.%ld %s", tenths < 0 ? "-" : "", labs(tenths) / 10, labs(tenths) % 10,
             angle ? "deg" : "cm");
    return out;
}


mus_status mus_tape_create(mus_context *context, mus_tape **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;

    mus_tape *tape = mus__new(context, 1, sizeof *tape);
    if (tape == NULL) return mus__fail_memory(context, "a tape");
    tape->context = context;
    for (int32_t i = 0; i < MUS_MEASURE_COUNT; i++) tape->value[i] = NAN;
    *out = tape;
    return MUS_OK;
}


mus_status mus_tape_copy(const mus_tape *tape, mus_tape **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (tape == NULL) return MUS_ERR_ARG;

    mus_tape *copy = mus__new(tape->context, 1, sizeof *copy);
    if (copy == NULL) return mus__fail_memory(tape->context, "a copy of a tape");
    *copy = *tape;
    *out = copy;
    return MUS_OK;
}


void mus_tape_destroy(mus_tape *tape)
{
    if (tape != NULL) mus__free(tape->context, tape);
}


mus_context *mus_tape_context(const mus_tape *tape)
{
    return tape != NULL ? tape->context : NULL;
}


mus_status mus_tape_set_sex(mus_tape *tape, int32_t sex)
{
    if (tape == NULL) return MUS_ERR_ARG;
    if (sex < MUS_SEX_UNSET || sex > MUS_SEX_CHILD)
        return mus__fail(tape->context, MUS_ERR_ARG, "sex %d is not one of 0 to 3", (int)sex);
    tape->sex = sex;
    tape->complete = false;
    return MUS_OK;
}


int32_t mus_tape_sex(const mus_tape *tape)
{
    return tape != NULL ? tape->sex : MUS_SEX_UNSET;
}


mus_status mus_tape_set_name(mus_tape *tape, const char *name)
{
    if (tape == NULL) return MUS_ERR_ARG;
    if (name == NULL) return mus__fail(tape->context, MUS_ERR_ARG, "the name of a tape is NULL");
    size_t length = strlen(name);
    if (length >= MUS_TAPE_NAME_BYTES)
        return mus__fail(tape->context, MUS_ERR_ARG, "a tape's name of %zu bytes is longer than 63", length);
    memmove(tape->name, name, length + 1);
    return MUS_OK;
}


const char *mus_tape_name(const mus_tape *tape)
{
    return tape != NULL ? tape->name : "";
}


mus_status mus_tape_set(mus_tape *tape, int32_t measure, double value, int32_t source)
{
    if (tape == NULL) return MUS_ERR_ARG;
    if (measure < 0 || measure >= MUS_MEASURE_COUNT)
        return mus__fail(tape->context, MUS_ERR_ARG, "measure %d is not one of 0 to %d", (int)measure,
                         MUS_MEASURE_COUNT - 1);
    const char *name = tape_measures[measure].name;
    if (isnan(value)) {
        tape->value[measure] = NAN;
        tape->source[measure] = MUS_SOURCE_NONE;
        tape->held[measure] = false;
        tape->complete = false;
        return MUS_OK;
    }
    if (!mus__finite(value)) return mus__fail(tape->context, MUS_ERR_ARG, "%s is infinite", name);
    if (source != MUS_SOURCE_GIVEN && source != MUS_SOURCE_DERIVED)
        return mus__fail(tape->context, MUS_ERR_ARG, "source %d of %s is neither given nor derived", (int)source, name);

    double low, high;
    char text[MUS_TAPE_TEXT_BYTES], from[MUS_TAPE_TEXT_BYTES], to[MUS_TAPE_TEXT_BYTES];
    mus__tape_range(measure, &low, &high);
    if (value < low || value > high)
        return mus__fail(tape->context, MUS_ERR_TAPE, "%s of %s is outside %s to %s", name,
                         mus__tape_text(measure, value, text), mus__tape_text(measure, low, from),
                         mus__tape_text(measure, high, to));
    tape->value[measure] = value;
    tape->source[measure] = source;
    tape->held[measure] = true;
    tape->complete = false;
    return MUS_OK;
}


double mus_tape_value(const mus_tape *tape, int32_t measure)
{
    return tape != NULL && measure >= 0 && measure < MUS_MEASURE_COUNT ? tape->value[measure] : NAN;
}


int32_t mus_tape_source(const mus_tape *tape, int32_t measure)
{
    return tape != NULL && measure >= 0 && measure < MUS_MEASURE_COUNT ? tape->source[measure] : MUS_SOURCE_NONE;
}


mus_status mus_tape_complete(mus_tape *tape)
{
    if (tape == NULL) return MUS_ERR_ARG;

    /* what must be there; a child's girths follow from its stature */
    static const int32_t needed[] = {MUS_MEASURE_STATURE, MUS_MEASURE_BUST, MUS_MEASURE_WAIST, MUS_MEASURE_HIP};
    for (int i = 0; i < (tape->sex == MUS_SEX_CHILD ? 1 : 4); i++)
        if (!tape->held[needed[i]])
            return mus__fail(tape->context, MUS_ERR_TAPE, "%s is missing: it cannot be derived",
                             tape_measures[needed[i]].name);

    /* on a copy, so that a sheet that makes no sense leaves the tape alone */
    mus_tape *work = NULL;
    mus_status status = mus_tape_copy(tape, &work);
    if (status != MUS_OK) return status;
    mus__tape_derive(work);
    status = mus__tape_check(work);
    if (status == MUS_OK) {
        work->complete = true;
        *tape = *work;
    }
    mus_tape_destroy(work);
    return status;
}


int32_t mus_tape_is_complete(const mus_tape *tape)
{
    return tape != NULL && tape->complete;
}


int32_t mus_tape_warning_count(const mus_tape *tape)
{
    return tape != NULL ? tape->warning_count : 0;
}


const char *mus_tape_warning(const mus_tape *tape, int32_t index)
{
    return tape != NULL && index >= 0 && index < tape->warning_count ? tape->warning[index] : NULL;
}
