/*
 * tape.c: the tape: the measures of one person, from which bodies and patterns are made.
 *
 * A tape is a flat array indexed by measure. A value that the caller set is held; every other value is derived.
 *
 *     tape_measure.c   the table of measures: names, units, ranges
 *     tape.c           create, copy, set and read (this file)
 *     tape_size.c      the 28 table sizes
 *     tape_derive.c    measures predicted from stature, bust, waist and hip
 *     tape_doubt.c     given measures that do not fit the others; tape_people.h is its table of people
 *     tape_check.c     errors and warnings of a sheet
 *     tape_complete.c  derive and check on a copy
 *
 * Callers: bodies (lib/limb, lib/body) and the drafting blocks read completed tapes through the public functions.
 * lib/limb also uses mus__tape_text() for its messages. The terms are those of ISO 8559-1:2017.
 */
#include <math.h>
#include <string.h>

#include "base/utf8.h"
#include "tape/tape_internal.h"


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
    if (length >= MUS__TAPE_NAME_BYTES)
        return mus__fail(tape->context, MUS_ERR_ARG, "a tape's name of %zu bytes is longer than 63", length);
    if (mus__utf8_span(name) < length)
        return mus__fail(tape->context, MUS_ERR_ARG, "the name of a tape is not UTF-8 at byte %zu",
                         mus__utf8_span(name));
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
    const char *name = mus_measure_name(measure);
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
    char text[MUS__TAPE_TEXT_BYTES], from[MUS__TAPE_TEXT_BYTES], to[MUS__TAPE_TEXT_BYTES];
    mus__tape_range(measure, &low, &high);
    if (value < low || value > high) {
        /* ten times a value of the plausible range, which is 2 low to high / 2: millimetres written as centimetres */
        const bool mm = mus_measure_unit(measure) == 'm' && value >= 20.0 * low && value <= 5.0 * high;
        return mus__fail(tape->context, MUS_ERR_TAPE, "%s of %s is outside %s to %s%s", name,
                         mus__tape_text(measure, value, text), mus__tape_text(measure, low, from),
                         mus__tape_text(measure, high, to), mm ? "; is the unit mm?" : "");
    }
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
