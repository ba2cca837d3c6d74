/*
 * tape_check.c: errors and warnings of a derived tape.
 *
 * An error is a pair of measures that no body has; its message also names the measure that tape_doubt.c doubts. A
 * warning is a doubted measure, or a pair that fewer than 0.05 % of the 6068 people of ANSUR II have; it needs at least
 * one given measure. Additions in the rules are in cm.
 */
#include <math.h>
#include <stdio.h>

#include "tape/tape_internal.h"

/* a rule about two measures: x above factor * y + add [cm] breaks it (in the lists of low bounds: x below) */
typedef struct tape_pair {
    int32_t x, y;
    double factor, add;
} tape_pair;

#define TAPE_M(name) MUS_MEASURE_##name

static const tape_pair tape_errors[] = {
    {TAPE_M(HIP), TAPE_M(WAIST), 3.0, 0.0},
    {TAPE_M(WAIST), TAPE_M(HIP), 2.5, 0.0},
    {TAPE_M(BUST), TAPE_M(WAIST), 3.0, 0.0},
    {TAPE_M(NECK), TAPE_M(BUST), 0.9, 0.0},
    {TAPE_M(UNDERBUST), TAPE_M(BUST), 1.0, 0.0},
    {TAPE_M(BUST_SPAN), TAPE_M(BUST), 0.5, 0.0},
    {TAPE_M(SHOULDER), TAPE_M(STATURE), 1.0 / 6, 0.0},
    {TAPE_M(WAIST_HEIGHT), TAPE_M(STATURE), 1.0, 0.0},
    {TAPE_M(WAIST_TO_HIP), TAPE_M(RISE), 1.0, 4.0},
    {TAPE_M(WRIST), TAPE_M(UPPER_ARM), 1.0, 0.0},
    {TAPE_M(ANKLE), TAPE_M(CALF), 1.0, 2.0},
    {TAPE_M(ELBOW), TAPE_M(ARM), 0.70, 0.0},
    {TAPE_M(ARM), TAPE_M(STATURE), 0.43, 0.0}, /* it is to the wrist; to the fingertips it would be 0.46 */
    {TAPE_M(INLEG), TAPE_M(STATURE), 0.56, 0.0},
    {TAPE_M(BUST), TAPE_M(STATURE), 1.3, 0.0},
    {TAPE_M(WAIST), TAPE_M(STATURE), 1.3, 0.0},
    {TAPE_M(HIP), TAPE_M(STATURE), 1.3, 0.0},
    {TAPE_M(NAPE_HEIGHT), TAPE_M(STATURE), 1.0, 0.0},
    {TAPE_M(WAIST_HEIGHT), TAPE_M(NAPE_HEIGHT), 1.0, 0.0},
    {TAPE_M(WAIST_HEIGHT), TAPE_M(BUST_HEIGHT), 1.0, 0.0},
    {TAPE_M(BUST_HEIGHT), TAPE_M(NAPE_HEIGHT), 1.0, 0.0},
};

static const tape_pair tape_low_errors[] = {{TAPE_M(BUST), TAPE_M(STATURE), 0.2, 0.0},
                                            {TAPE_M(WAIST), TAPE_M(STATURE), 0.2, 0.0},
                                            {TAPE_M(HIP), TAPE_M(STATURE), 0.2, 0.0},
                                            {TAPE_M(ELBOW), TAPE_M(ARM), 0.45, 0.0}};

static const tape_pair tape_warnings[] = {
    {TAPE_M(HIGH_BUST), TAPE_M(BUST), 1.0, 3.0},
    {TAPE_M(FRONT_WAIST), TAPE_M(BACK_WAIST), 1.0, 12.0},
    {TAPE_M(BACK_WAIST), TAPE_M(FRONT_WAIST), 1.0, 12.0},
    {TAPE_M(BUST_DEPTH), TAPE_M(FRONT_WAIST), 1.0, -8.0},
    {TAPE_M(BUST), TAPE_M(UNDERBUST), 1.0, 30.0},
    {TAPE_M(KNEE), TAPE_M(THIGH), 1.0, 0.0},
    {TAPE_M(CALF), TAPE_M(KNEE), 1.0, 6.0},
    {TAPE_M(CROTCH_LENGTH), TAPE_M(RISE), 3.2, 0.0},
};

static const tape_pair tape_low_warnings[] = {
    {TAPE_M(CROTCH_LENGTH), TAPE_M(RISE), 1.6, 0.0},
};

#undef TAPE_M

#define TAPE_COUNT(list) ((int)(sizeof(list) / sizeof *(list)))


/* whether a tape breaks a rule, with 1e-9 m for rounding; false when one of the two measures is unset */
static bool tape_breaks(const mus_tape *tape, const tape_pair *pair, bool below)
{
    double x = tape->value[pair->x], bound = pair->factor * tape->value[pair->y] + 0.01 * pair->add;
    return below ? x < bound - 1e-9 : x > bound + 1e-9;
}


/* the message of a broken rule: "underbust of 99.0 cm is too large against bust of 92.0 cm, by 7.0 cm" */
static void tape_sentence(const mus_tape *tape, const tape_pair *pair, bool below, char *out, size_t bytes)
{
    char x[MUS__TAPE_TEXT_BYTES], y[MUS__TAPE_TEXT_BYTES], by[MUS__TAPE_TEXT_BYTES];
    double off = tape->value[pair->x] - (pair->factor * tape->value[pair->y] + 0.01 * pair->add);
    snprintf(out, bytes, "%s of %s is too %s against %s of %s, by %s", mus_measure_name(pair->x),
             mus__tape_text(pair->x, tape->value[pair->x], x), below ? "small" : "large", mus_measure_name(pair->y),
             mus__tape_text(pair->y, tape->value[pair->y], y), mus__tape_text(pair->x, fabs(off), by));
}


static bool tape_given(const mus_tape *tape, int32_t measure)
{
    return tape->source[measure] == MUS_SOURCE_GIVEN;
}


/* "bust of 69.0 cm does not fit the others, which predict 94.7 cm; digits swapped: 96.0 cm?" */
static void tape_doubt_sentence(const mus_tape *tape, const mus__doubt *doubt, char *out, size_t bytes)
{
    char x[MUS__TAPE_TEXT_BYTES], y[MUS__TAPE_TEXT_BYTES], likely[MUS__TAPE_TEXT_BYTES];
    const int n =
        snprintf(out, bytes, "%s of %s does not fit the others, which predict %s", mus_measure_name(doubt->measure),
                 mus__tape_text(doubt->measure, tape->value[doubt->measure], x),
                 mus__tape_text(doubt->measure, doubt->expected, y));
    if (doubt->cause != NULL && n > 0 && (size_t)n < bytes)
        snprintf(out + n, bytes - (size_t)n, "; %s: %s?", doubt->cause,
                 mus__tape_text(doubt->measure, doubt->likely, likely));
}


static void tape_warn(mus_tape *tape, const char *text)
{
    if (tape->warning_count == MUS__TAPE_WARNINGS) return;
    snprintf(tape->warning[tape->warning_count++], MUS__TAPE_WARNING_BYTES, "%s", text);
}


/* MUS_ERR_TAPE with a sentence, and behind it in brackets the first doubted measure, which is the likely cause */
static mus_status tape_fail(const mus_tape *tape, const char *text, const mus__doubt *doubts, int32_t count)
{
    char doubt[MUS__TAPE_WARNING_BYTES];
    if (count == 0) return mus__fail(tape->context, MUS_ERR_TAPE, "%s", text);
    tape_doubt_sentence(tape, &doubts[0], doubt, sizeof doubt);
    return mus__fail(tape->context, MUS_ERR_TAPE, "%s (%s)", text, doubt);
}


static mus_status tape_check_errors(const mus_tape *tape, const mus__doubt *doubts, int32_t doubt_count)
{
    char text[MUS__TAPE_WARNING_BYTES];
    for (int i = 0; i < TAPE_COUNT(tape_errors) + TAPE_COUNT(tape_low_errors); i++) {
        const bool below = i >= TAPE_COUNT(tape_errors);
        const tape_pair *pair = below ? &tape_low_errors[i - TAPE_COUNT(tape_errors)] : &tape_errors[i];
        if (!tape_breaks(tape, pair, below)) continue;
        tape_sentence(tape, pair, below, text, sizeof text);
        return tape_fail(tape, text, doubts, doubt_count);
    }
    return MUS_OK;
}


static void tape_check_warnings(mus_tape *tape, const tape_pair *list, int count, bool below)
{
    char text[MUS__TAPE_WARNING_BYTES];
    for (int i = 0; i < count; i++) {
        if (!tape_breaks(tape, &list[i], below)) continue;
        if (!tape_given(tape, list[i].x) && !tape_given(tape, list[i].y)) continue;
        tape_sentence(tape, &list[i], below, text, sizeof text);
        tape_warn(tape, text);
    }
}


/* rise + inside leg should be the waist height: more than 8 cm apart is an error, more than 4 cm a warning */
static mus_status tape_check_rise(mus_tape *tape, const mus__doubt *doubts, int32_t doubt_count)
{
    const double *v = tape->value;
    double apart = fabs(v[MUS_MEASURE_RISE] + v[MUS_MEASURE_INLEG] - v[MUS_MEASURE_WAIST_HEIGHT]);
    if (apart <= 0.04 + 1e-9) return MUS_OK;

    char rise[MUS__TAPE_TEXT_BYTES], inleg[MUS__TAPE_TEXT_BYTES], height[MUS__TAPE_TEXT_BYTES];
    char gap[MUS__TAPE_TEXT_BYTES], text[MUS__TAPE_WARNING_BYTES];
    snprintf(text, sizeof text, "rise of %s and inleg of %s do not sum to waist_height of %s: %s apart",
             mus__tape_text(MUS_MEASURE_RISE, v[MUS_MEASURE_RISE], rise),
             mus__tape_text(MUS_MEASURE_INLEG, v[MUS_MEASURE_INLEG], inleg),
             mus__tape_text(MUS_MEASURE_WAIST_HEIGHT, v[MUS_MEASURE_WAIST_HEIGHT], height),
             mus__tape_text(MUS_MEASURE_RISE, apart, gap));
    if (apart > 0.08 + 1e-9) return tape_fail(tape, text, doubts, doubt_count);
    tape_warn(tape, text);
    return MUS_OK;
}


/* warnings about sums of two measures: across back and front against the bust, back waist and hip drop against the
 * stature */
static void tape_check_sums(mus_tape *tape)
{
    const double *v = tape->value;
    bool across = tape_given(tape, MUS_MEASURE_ACROSS_BACK) || tape_given(tape, MUS_MEASURE_ACROSS_FRONT);
    if (across && v[MUS_MEASURE_ACROSS_BACK] + v[MUS_MEASURE_ACROSS_FRONT] > 0.98 * v[MUS_MEASURE_BUST])
        tape_warn(tape, "across_back and across_front together are nearly the whole bust");
    bool drop = tape_given(tape, MUS_MEASURE_BACK_WAIST) || tape_given(tape, MUS_MEASURE_WAIST_TO_HIP);
    if (drop && v[MUS_MEASURE_BACK_WAIST] + v[MUS_MEASURE_WAIST_TO_HIP] > 0.45 * v[MUS_MEASURE_STATURE])
        tape_warn(tape, "back_waist and waist_to_hip together are more than 0.45 of stature");
}


mus_status mus__tape_check(mus_tape *tape)
{
    mus__doubt doubts[MUS_MEASURE_COUNT + 1];
    const int32_t count = mus__tape_doubts(tape, doubts);
    char text[MUS__TAPE_WARNING_BYTES];
    tape->warning_count = 0;
    mus_status status = tape_check_errors(tape, doubts, count);
    if (status == MUS_OK) status = tape_check_rise(tape, doubts, count);
    if (status != MUS_OK) return status;

    for (int32_t i = 0; i < count; i++) {
        tape_doubt_sentence(tape, &doubts[i], text, sizeof text);
        tape_warn(tape, text);
    }
    tape_check_warnings(tape, tape_warnings, TAPE_COUNT(tape_warnings), false);
    tape_check_warnings(tape, tape_low_warnings, TAPE_COUNT(tape_low_warnings), true);
    tape_check_sums(tape);
    return MUS_OK;
}
