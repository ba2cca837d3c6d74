/*
 * tape_doubt.c: given measures that do not fit the others of the same tape, and the slip of the pen that explains one.
 *
 * The logarithms of a person's measures are taken as jointly normal, with the means, deviations and correlations of
 * tape_people.h. For the given measures, with residuals r and P the inverse of their covariance, the prediction of
 * measure i from all the others is x_i - (P r)_i / P_ii, with the standard deviation 1 / sqrt(P_ii) (Sundararajan and
 * Keerthi 2001, Neural Computation 13: leave-one-out of a Gaussian process). The measure whose correction gains most is
 * doubted and left out, until none is. Measures that the table lacks are compared with their lines of tape_derive.c.
 *
 * A child's means are the derived measures of its stature, with the spread of women: the survey has adults alone. Of a
 * tape without a sex the likelier sex is taken.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "tape/tape_internal.h"
#include "tape/tape_people.h"

/* [standard deviations] of a value from its prediction by the others. Chosen on one half of the people of the survey so
 * that less than 1 % of the other half is falsely warned of (`make slips`): lower ones find more slips of 8 to 10 cm */
#define DOUBT_FAR 4.5  /* doubted */
#define DOUBT_SLIP 3.6 /* doubted where a slip explains the value */
#define DOUBT_NEAR 2.0 /* a slip explains the value when its correction is this near */

#define DOUBT_LEAST 3      /* of two measures that disagree none can be told to be the wrong one */
#define DOUBT_PREGNANT 1.4 /* a woman's waist over its prediction that pregnancy explains; chosen: 78 to 109 cm */
#define DOUBT_ROWS MUS__PEOPLE_MEASURES

/* the given measures of a tape that the table has, and their predictions */
typedef struct doubt_model {
    int n;
    int row[DOUBT_ROWS];                    /* rows of the table */
    double x[DOUBT_ROWS];                   /* ln of the value [cm] */
    double r[DOUBT_ROWS];                   /* x less the mean of people */
    double inverse[DOUBT_ROWS][DOUBT_ROWS]; /* P */
    double expected[DOUBT_ROWS];            /* ln of the prediction [cm] */
    double deviation[DOUBT_ROWS];           /* of x from it */
} doubt_model;


/* replace a symmetric positive definite n x n matrix by its inverse: Cholesky, then the inverse of the factor */
static void doubt_invert(double (*a)[DOUBT_ROWS], int n)
{
    double inverse[DOUBT_ROWS][DOUBT_ROWS] = {{0.0}};
    for (int j = 0; j < n; j++) {
        for (int i = j; i < n; i++) {
            for (int k = 0; k < j; k++) a[i][j] -= a[i][k] * a[j][k];
            a[i][j] = i == j ? sqrt(a[j][j]) : a[i][j] / a[j][j];
        }
    }
    for (int j = 0; j < n; j++)
        for (int i = j; i < n; i++) {
            double sum = i == j ? 1.0 : 0.0;
            for (int k = j; k < i; k++) sum -= a[i][k] * inverse[k][j];
            inverse[i][j] = sum / a[i][i];
        }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            a[i][j] = 0.0;
            for (int k = i > j ? i : j; k < n; k++) a[i][j] += inverse[k][i] * inverse[k][j];
        }
}


/* predict each measure of the model from its others by the spread of `people`; returns the squared distance r' P r of
 * the whole from the mean */
static double doubt_predict(doubt_model *model, const struct mus__people *people)
{
    const int n = model->n;
    double distance = 0.0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const int a = model->row[i], b = model->row[j], high = a > b ? a : b, low = a > b ? b : a;
            const double correlation = a == b ? 1000.0 : people->correlation[high * (high - 1) / 2 + low];
            model->inverse[i][j] = 1e-7 * correlation * people->deviation[a] * people->deviation[b];
        }
    doubt_invert(model->inverse, n);
    for (int i = 0; i < n; i++) {
        double sum = 0.0;
        for (int j = 0; j < n; j++) sum += model->inverse[i][j] * model->r[j];
        model->expected[i] = model->x[i] - sum / model->inverse[i][i];
        model->deviation[i] = 1.0 / sqrt(model->inverse[i][i]);
        distance += sum * model->r[i];
    }
    return distance;
}


/* values and residuals of the measures of the model, of a child from the measures that its stature derives */
static void doubt_residuals(doubt_model *model, const mus_tape *tape, const struct mus__people *people)
{
    mus_tape table = {.sex = MUS_SEX_CHILD};
    const bool child = tape->sex == MUS_SEX_CHILD;
    if (child) {
        table.held[MUS_MEASURE_STATURE] = true;
        table.value[MUS_MEASURE_STATURE] = tape->value[MUS_MEASURE_STATURE];
        mus__tape_derive(&table);
    }
    for (int i = 0; i < model->n; i++) {
        const int32_t m = mus__people_measure[model->row[i]];
        model->x[i] = mus__ln(100.0 * tape->value[m]);
        model->r[i] = model->x[i] - mus__ln(child ? 100.0 * table.value[m] : people->mean[model->row[i]]);
    }
}


/* take a correction when it is nearer to the prediction than the best so far */
static void doubt_try(mus__doubt *doubt, double likely, const char *cause, double expected, double *nearest)
{
    if (likely <= 0.0 || fabs(mus__ln(100.0 * likely) - expected) >= *nearest) return;
    *nearest = fabs(mus__ln(100.0 * likely) - expected);
    doubt->likely = likely;
    doubt->cause = cause;
}


/* whether a measure is a girth, of which half may have been written; these follow each other in MUS_MEASURE_LIST */
static bool doubt_girth(int32_t m)
{
    return (m >= MUS_MEASURE_BUST && m <= MUS_MEASURE_NECK) || (m >= MUS_MEASURE_UPPER_ARM && m <= MUS_MEASURE_HAND) ||
           (m >= MUS_MEASURE_THIGH && m <= MUS_MEASURE_HEAD);
}


/* find the slip that brings a value nearest to its prediction [ln cm]: two neighbouring digits swapped (of a length in
 * whole millimetres, or of the inches of one in whole eighths), inches taken for cm, half of a girth, a lost hundred.
 * Returns the distance of the correction from the prediction */
static double doubt_slip(mus__doubt *doubt, double value, double expected)
{
    double nearest = INFINITY;
    for (int inch = 0; inch < 2; inch++) {
        const double unit = inch ? 0.0254 : 0.001, parts = (inch ? 8.0 : 1.0) * value / unit;
        const long digits = (long)(value / unit + 1e-6);
        for (long p = 1; fabs(parts - nearbyint(parts)) < 1e-6 && p <= digits; p *= 10) {
            const long change = (digits / p % 10 - digits / p / 10 % 10) * 9 * p;
            if (change == 0) continue;
            doubt_try(doubt, value + unit * (double)change, inch ? "digits of the inches swapped" : "digits swapped",
                      expected, &nearest);
        }
    }
    doubt_try(doubt, 2.54 * value, "inches taken for cm", expected, &nearest);
    if (doubt_girth(doubt->measure)) doubt_try(doubt, 2.0 * value, "half the girth", expected, &nearest);
    doubt_try(doubt, value + 1.0, "the first digit lost", expected, &nearest);
    return nearest;
}


/* doubt a value against its prediction [ln cm]; returns by how much a correction lowers the squared distance, 0 when
 * the value is not doubted */
static double doubt_value(mus__doubt *doubt, double value, double expected, double deviation)
{
    const double off = fabs(mus__ln(100.0 * value) - expected) / deviation;
    *doubt = (mus__doubt){.measure = doubt->measure, .expected = 0.01 * mus__exp(expected)};
    double rest = doubt_slip(doubt, value, expected) / deviation;
    if (rest > DOUBT_NEAR) {
        rest = DOUBT_NEAR;
        doubt->cause = NULL;
    }
    return off > (doubt->cause != NULL ? DOUBT_SLIP : DOUBT_FAR) ? off * off - rest * rest : 0.0;
}


/* the measure of the model that gains most by a correction, or -1 */
static int doubt_worst(const doubt_model *model, mus__doubt *worst)
{
    int found = -1;
    double most = 0.0;
    for (int i = 0; i < model->n; i++) {
        mus__doubt doubt = {.measure = mus__people_measure[model->row[i]]};
        const double gain = doubt_value(&doubt, 0.01 * mus__exp(model->x[i]), model->expected[i], model->deviation[i]);
        if (gain <= most) continue;
        most = gain;
        *worst = doubt;
        found = i;
    }
    return found;
}


/* the table of the tape's sex; of a tape without one, the table that the given measures are nearer to */
static const struct mus__people *doubt_people(doubt_model *model, const mus_tape *tape)
{
    double distance[2];
    if (tape->sex != MUS_SEX_UNSET) return &mus__people[tape->sex == MUS_SEX_MALE];
    for (int sex = 0; sex < 2; sex++) {
        doubt_residuals(model, tape, &mus__people[sex]);
        distance[sex] = doubt_predict(model, &mus__people[sex]);
    }
    return &mus__people[distance[1] < distance[0]];
}


/* doubts of the measures that the table lacks, against the lines of stature, bust, waist and hip, where doubted ones
 * have their predicted values */
static int32_t doubt_lines(const mus_tape *tape, mus__doubt *doubts, int32_t count)
{
    mus_tape right = *tape;
    for (int32_t i = 0; i < count; i++) right.value[doubts[i].measure] = doubts[i].expected;
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
        double deviation, predicted = mus__tape_predict(&right, m, &deviation);
        bool done = tape->source[m] != MUS_SOURCE_GIVEN || deviation <= 0.0 || predicted <= 0.0;
        for (int i = 0; i < DOUBT_ROWS; i++) done = done || mus__people_measure[i] == m;
        doubts[count].measure = m;
        if (!done &&
            doubt_value(&doubts[count], tape->value[m], mus__ln(100.0 * predicted), deviation / predicted) > 0.0)
            count++;
    }
    return count;
}


/* whether pregnancy explains a woman's waist that no slip explains */
static bool doubt_pregnant(const mus__doubt *doubt, const mus_tape *tape, const struct mus__people *people)
{
    const double ratio = tape->value[doubt->measure] / doubt->expected;
    return doubt->measure == MUS_MEASURE_WAIST && doubt->cause == NULL && people == &mus__people[0] &&
           tape->sex != MUS_SEX_CHILD && ratio > 1.0 && ratio < DOUBT_PREGNANT;
}


/* doubts of the given measures that the table has: the worst is taken out of the model, until none is doubted; then
 * each is looked at again beside those that are left, since a wrong measure moves the predictions of the others */
static int32_t doubt_table(const mus_tape *tape, doubt_model *model, mus__doubt *doubts)
{
    const struct mus__people *people = doubt_people(model, tape);
    int out[DOUBT_ROWS], out_count = 0;
    int32_t count = 0;
    while (model->n >= DOUBT_LEAST) {
        doubt_residuals(model, tape, people);
        doubt_predict(model, people);
        const int worst = doubt_worst(model, &doubts[0]);
        if (worst < 0) break;
        if (!doubt_pregnant(&doubts[0], tape, people)) out[out_count++] = model->row[worst];
        model->n--;
        for (int i = worst; i < model->n; i++) model->row[i] = model->row[i + 1];
    }
    for (int i = 0; i < out_count; i++) {
        const int32_t m = mus__people_measure[out[i]];
        doubt_model again = {.n = model->n + 1};
        memcpy(again.row, model->row, sizeof again.row);
        again.row[model->n] = out[i];
        doubt_residuals(&again, tape, people);
        doubt_predict(&again, people);
        doubts[count].measure = m;
        if (doubt_value(&doubts[count], tape->value[m], again.expected[model->n], again.deviation[model->n]) > 0.0)
            count++;
    }
    return count;
}


int32_t mus__tape_doubts(const mus_tape *tape, mus__doubt *doubts)
{
    doubt_model model = {.n = 0};
    for (int i = 0; i < DOUBT_ROWS; i++)
        if (tape->source[mus__people_measure[i]] == MUS_SOURCE_GIVEN) model.row[model.n++] = i;
    return doubt_lines(tape, doubts, model.n < DOUBT_LEAST ? 0 : doubt_table(tape, &model, doubts));
}
