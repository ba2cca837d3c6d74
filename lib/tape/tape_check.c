/*
 * tape_check.c: errors and warnings of a derived tape.
 *
 * An error is a pair of measures that no body has; a warning is a pair that fewer than 0.05 % of the 6068 people of
 * ANSUR II have. Both name the two measures. A warning needs at least one given measure. A given value more than four
 * standard deviations from its prediction is nearly always a value in inches taken for cm, or half a girth taken for a
 * whole one; the warning says so where that brings the value near its prediction. Additions in the rules are in cm.
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
    {TAPE_M(WAIST), TAPE_M(BUST), 1.2, 0.0},
    {TAPE_M(WAIST), TAPE_M(HIP), 1.2, 0.0},
    {TAPE_M(NECK), TAPE_M(BUST), 0.55, 0.0},
    {TAPE_M(THIGH), TAPE_M(HIP), 0.75, 0.0},
    {TAPE_M(KNEE), TAPE_M(THIGH), 1.0, 0.0},
    {TAPE_M(CALF), TAPE_M(KNEE), 1.0, 6.0},
    {TAPE_M(CROTCH_LENGTH), TAPE_M(RISE), 3.2, 0.0},
};

static const tape_pair tape_low_warnings[] = {
    {TAPE_M(HIP), TAPE_M(WAIST), 0.85, 0.0},
    {TAPE_M(THIGH), TAPE_M(HIP), 0.45, 0.0},
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


/* the likely cause of a small value, "; inches taken for cm: 92.7 cm?" or "; half the girth: ...", where it brings the
 * value within `slack` of the expected one; else "" */
static const char *tape_slip(int32_t measure, double value, double expected, double slack, char *out, size_t bytes)
{
    const double inch = 2.54 * value, twice = 2.0 * value;
    const bool girth = measure != MUS_MEASURE_STATURE;
    const bool half = girth && fabs(twice - expected) < fabs(inch - expected);
    const double likely = half ? twice : inch;
    char text[MUS__TAPE_TEXT_BYTES];
    out[0] = '\0';
    if (fabs(likely - expected) < slack)
        snprintf(out, bytes, "; %s: %s?", half ? "half the girth" : "inches taken for cm",
                 mus__tape_text(measure, likely, text));
    return out;
}


/* expected value [m] of one of stature, bust, waist and hip, from the other three: mean ratios of the adults of ANSUR
 * II and of the size tables */
static double tape_expected(const double *v, int32_t measure)
{
    const double b = v[MUS_MEASURE_BUST], w = v[MUS_MEASURE_WAIST], s = v[MUS_MEASURE_HIP];
    if (measure == MUS_MEASURE_STATURE) return 1.85 * (b + w + s) / 3.0;
    if (measure == MUS_MEASURE_BUST) return 0.5 * (0.94 * s + 1.17 * w);
    if (measure == MUS_MEASURE_WAIST) return 0.5 * (0.85 * b + 0.80 * s);
    return 0.5 * (1.06 * b + 1.25 * w);
}


/* the one of stature, bust, waist and hip that is given in inches or as half a girth, or MUS_NONE: its value is below
 * 0.62 of the expected one, and that cause brings it within 22 %. Writes the cause to `out` */
static int32_t tape_slipped(const mus_tape *tape, char *out, size_t bytes)
{
    static const int32_t base[] = {MUS_MEASURE_STATURE, MUS_MEASURE_BUST, MUS_MEASURE_WAIST, MUS_MEASURE_HIP};
    for (int i = 0; i < TAPE_COUNT(base); i++) {
        const double value = tape->value[base[i]], expected = tape_expected(tape->value, base[i]);
        if (tape->sex == MUS_SEX_CHILD || !tape_given(tape, base[i]) || value > 0.62 * expected) continue;
        if (*tape_slip(base[i], value, expected, 0.22 * expected, out, bytes) != '\0') return base[i];
    }
    out[0] = '\0';
    return MUS_NONE;
}


static void tape_warn(mus_tape *tape, const char *text)
{
    if (tape->warning_count == MUS__TAPE_WARNINGS) return;
    snprintf(tape->warning[tape->warning_count++], MUS__TAPE_WARNING_BYTES, "%s", text);
}


static mus_status tape_check_errors(const mus_tape *tape, const tape_pair *list, int count, bool below)
{
    char text[MUS__TAPE_WARNING_BYTES];
    for (int i = 0; i < count; i++) {
        if (!tape_breaks(tape, &list[i], below)) continue;
        char cause[80];
        const int32_t slipped = tape_slipped(tape, cause, sizeof cause);
        tape_sentence(tape, &list[i], below, text, sizeof text);
        if (slipped != list[i].x && slipped != list[i].y) cause[0] = '\0';
        if (cause[0] == '\0') return mus__fail(tape->context, MUS_ERR_TAPE, "%s", text);
        return mus__fail(tape->context, MUS_ERR_TAPE, "%s (%s%s)", text, mus_measure_name(slipped), cause);
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
static mus_status tape_check_rise(mus_tape *tape)
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
    if (apart > 0.08 + 1e-9) return mus__fail(tape->context, MUS_ERR_TAPE, "%s", text);
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


/* warnings about given values more than four standard deviations from their prediction, with the likely cause where it
 * brings the value within two */
static void tape_check_residuals(mus_tape *tape)
{
    char cause[80];
    const int32_t slipped = tape_slipped(tape, cause, sizeof cause);
    if (slipped != MUS_NONE) {
        char x[MUS__TAPE_TEXT_BYTES], text[MUS__TAPE_WARNING_BYTES];
        snprintf(text, sizeof text, "%s of %s is small for the others of stature, bust, waist and hip%s",
                 mus_measure_name(slipped), mus__tape_text(slipped, tape->value[slipped], x), cause);
        tape_warn(tape, text);
    }
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
        double deviation, predicted = mus__tape_predict(tape, m, &deviation), value = tape->value[m];
        if (!tape_given(tape, m) || deviation <= 0.0 || fabs(value - predicted) <= 4.0 * deviation) continue;
        tape_slip(m, value, predicted, 2.0 * deviation, cause, sizeof cause);
        char x[MUS__TAPE_TEXT_BYTES], y[MUS__TAPE_TEXT_BYTES], text[MUS__TAPE_WARNING_BYTES];
        snprintf(text, sizeof text, "%s of %s is far from the %s that stature and girths predict%s",
                 mus_measure_name(m), mus__tape_text(m, value, x), mus__tape_text(m, predicted, y), cause);
        tape_warn(tape, text);
    }
}


mus_status mus__tape_check(mus_tape *tape)
{
    tape->warning_count = 0;
    mus_status status = tape_check_errors(tape, tape_errors, TAPE_COUNT(tape_errors), false);
    if (status == MUS_OK) status = tape_check_errors(tape, tape_low_errors, TAPE_COUNT(tape_low_errors), true);
    if (status == MUS_OK) status = tape_check_rise(tape);
    if (status != MUS_OK) return status;

    tape_check_warnings(tape, tape_warnings, TAPE_COUNT(tape_warnings), false);
    tape_check_warnings(tape, tape_low_warnings, TAPE_COUNT(tape_low_warnings), true);
    tape_check_sums(tape);
    tape_check_residuals(tape);
    return MUS_OK;
}
