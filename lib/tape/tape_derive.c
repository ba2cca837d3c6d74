/*
 * tape_derive.c: the measures that were not taken, derived from stature, bust, waist and hip.
 *
 * Most are linear in those four: regressions on the public ANSUR II survey (US Army, 2012: 6068 people) and rules of
 * size tables of the clothing trade; the coefficients are in cm, as in their sources. Women, men and children have
 * their own lines; an unset sex takes the mean of women and men. Any two of rise, inside leg and waist height give the
 * third. Where a derived value would contradict a given one, the derived one is changed. Arms hang at 45 degrees, or
 * stand off the side of a stout person so far that cloth passes between.
 */
#include <math.h>

#include "base/elementary.h"
#include "tape/tape_internal.h"

/* constant, and factors of stature, bust, waist, hip [cm] */
typedef struct tape_line {
    double c, h, b, w, s;
} tape_line;

typedef struct tape_rule {
    int32_t measure;
    tape_line female, male, child;
    double female_deviation, male_deviation; /* standard deviation of the residual in ANSUR II [cm]; 0: a trade rule */
} tape_rule;

/* lines such as that of the shoulder, 2.3 + 0.06 H + 0.04 (B - 92), are multiplied out */
static const tape_rule tape_rules[] = {
    {MUS_MEASURE_NECK, {11.3, .072, .14, 0, 0}, {13.5, .037, .213, 0, 0}, {16.2, .111, 0, 0, 0}, 1.4, 1.7},
    {MUS_MEASURE_SHOULDER, {-1.38, .06, .04, 0, 0}, {1.9, .065, .02, 0, 0}, {1.9, .064, 0, 0, 0}, .95, .95},
    {MUS_MEASURE_BACK_WAIST, {-2.76, .247, .03, 0, 0}, {-3, .253, .03, 0, 0}, {0, 0, 0, 0, 0}, 0, 0},
    {MUS_MEASURE_ACROSS_BACK, {15.8, 0, .22, 0, 0}, {15.5, 0, .25, 0, 0}, {1, 0, .395, 0, 0}, 0, 0},
    {MUS_MEASURE_ACROSS_FRONT, {9.4, 0, .27, 0, 0}, {13.3, 0, .25, 0, 0}, {.97, 0, .97 * .395, 0, 0}, 0, 0},
    {MUS_MEASURE_UNDERBUST, {-13, 0, 1, 0, 0}, {-4, 0, 1, 0, 0}, {-2, 0, 1, 0, 0}, 0, 0},
    {MUS_MEASURE_BUST_SPAN, {0, 0, .2, 0, 0}, {0, 0, .19, 0, 0}, {0, 0, .19, 0, 0}, 0, 0},
    {MUS_MEASURE_BUST_DEPTH, {4.2, 0, .25, 0, 0}, {3, 0, .24, 0, 0}, {2, 0, .25, 0, 0}, 0, 0},
    {MUS_MEASURE_SCYE_DEPTH, {10.5, 0, .1, 0, 0}, {11.5, 0, .1, 0, 0}, {1, 0, .225, 0, 0}, 0, 0},
    {MUS_MEASURE_ARM, {0, .353, 0, 0, 0}, {0, .353, 0, 0, 0}, {-4.5, .385, 0, 0, 0}, 1.8, 1.8},
    {MUS_MEASURE_UPPER_ARM, {1.6, 0, .3, 0, 0}, {1.7, 0, .3, 0, 0}, {2, 0, .28, 0, 0}, 2.1, 2.1},
    {MUS_MEASURE_WRIST, {3.6, .048, .022, 0, .023}, {3.6, .042, .035, 0, .028}, {7.2, .053, 0, 0, 0}, .6, .6},
    {MUS_MEASURE_HAND, {6.8, .05, .037, 0, 0}, {6.2, .05, .06, 0, 0}, {5, .082, 0, 0, 0}, .75, .75},
    {MUS_MEASURE_HEAD, {39, .074, 0, 0, .05}, {39.6, .05, 0, 0, .085}, {0, 0, 0, 0, 0}, 1.8, 1.4},
    {MUS_MEASURE_RISE, {8.3, 0, 0, 0, .18}, {7.5, 0, 0, 0, .18}, {9, .1, 0, 0, 0}, 0, 0},
    {MUS_MEASURE_WAIST_HEIGHT, {0, .622, 0, 0, 0}, {0, .615, 0, 0, 0}, {-7.5, .675, 0, 0, 0}, 0, 0},
    {MUS_MEASURE_WAIST_TO_HIP, {0, .12, 0, 0, 0}, {0, .12, 0, 0, 0}, {-1, .115, 0, 0, 0}, 0, 0},
    {MUS_MEASURE_THIGH, {-2, -.04, 0, 0, .69}, {-3, -.06, 0, 0, .745}, {0, 0, 0, 0, .585}, 1.9, 1.9},
    {MUS_MEASURE_KNEE, {4, 0, 0, 0, .33}, {6, 0, 0, 0, .32}, {5.5, 0, 0, 0, .345}, 2, 1.6},
    {MUS_MEASURE_CALF, {4, .03, 0, 0, .28}, {6, 0, 0, 0, .32}, {7, 0, 0, 0, .27}, 1.9, 1.9},
    {MUS_MEASURE_ANKLE, {5, .044, 0, 0, .095}, {4.2, .03, 0, 0, .13}, {9, 0, 0, 0, .13}, 1.2, 1.1},
    {MUS_MEASURE_FOOT, {1.9, .14, 0, 0, 0}, {3, .137, 0, 0, 0}, {1.9, .14, 0, 0, 0}, .9, .9},
};

/* crotch length: constant, and factors of rise and hip [cm], of women, men, children. The lengths that the sections of
 * the body have between waist and crotch (torso.c); of the people of ANSUR II, whose rise is to the navel, the
 * deviation from such a line is 2.3 cm (women) and 2.6 cm (men) */
static const double tape_crotch[3][3] = {{-1.7, 1.764, .236}, {-6.3, 1.839, .278}, {-1.0, 1.721, .247}};
static const double tape_crotch_deviation[2] = {2.3, 2.6}; /* [cm] */

/* half breadth of the trunk at the bust, in parts of its girth: that of the contours of torso.c, 0.177 to 0.179 */
#define TAPE_TRUNK 0.18
/* [m] between arm and side, at least; chosen: two layers of cloth with their clearances on both sides pass, and every
 * size of the tables hangs its arms at 45 degrees (of W52 and C80, which are nearest to it, 27 mm are left) */
#define TAPE_ARM_CLEAR 0.02

#define TAPE_RULE_COUNT ((int)(sizeof tape_rules / sizeof *tape_rules))

/* children: nape to waist and head girth are not linear in the stature, so they are read from the size table [cm] */
#define TAPE_CHILD_ROWS 11 /* statures of that table */
static const double tape_child_stature[TAPE_CHILD_ROWS] = {50, 56, 68, 80, 92, 104, 116, 128, 140, 152, 164};
static const double tape_child_back[TAPE_CHILD_ROWS] = {13.15, 14.5, 17.2, 19.8, 22.2, 24.3,
                                                        26.6,  29.2, 32.2, 35.4, 38.6};
static const double tape_child_head[TAPE_CHILD_ROWS] = {35, 38.5, 43, 46.5, 49, 50.8, 52, 53, 54, 55, 56};


/* a row of the children's table at stature h [cm], linear between the statures; returns [cm] */
static double tape_table(const double *row, double h)
{
    int i = 0;
    while (i + 2 < TAPE_CHILD_ROWS && h > tape_child_stature[i + 1]) i++;
    double t = (h - tape_child_stature[i]) / (tape_child_stature[i + 1] - tape_child_stature[i]);
    return row[i] + t * (row[i + 1] - row[i]);
}


/* a line at the measures v [m]; returns [cm] */
static double tape_line_at(const tape_line *line, const double *v)
{
    return line->c + line->h * 100.0 * v[MUS_MEASURE_STATURE] + line->b * 100.0 * v[MUS_MEASURE_BUST] +
           line->w * 100.0 * v[MUS_MEASURE_WAIST] + line->s * 100.0 * v[MUS_MEASURE_HIP];
}


/* the value for a sex: women's, men's, or the mean of the two for an unset one */
static double tape_mix(int32_t sex, double female, double male)
{
    return sex == MUS_SEX_FEMALE ? female : sex == MUS_SEX_MALE ? male : 0.5 * (female + male);
}


/* crotch length [m] of row `sex` of its table, from rise and hip */
static double tape_crotch_at(int sex, const double *v)
{
    const double *line = tape_crotch[sex];
    return 0.01 * line[0] + line[1] * v[MUS_MEASURE_RISE] + line[2] * v[MUS_MEASURE_HIP];
}


double mus__tape_predict(const mus_tape *tape, int32_t measure, double *deviation)
{
    *deviation = 0.0;
    bool child = tape->sex == MUS_SEX_CHILD;
    double h = 100.0 * tape->value[MUS_MEASURE_STATURE];
    if (child && measure == MUS_MEASURE_BACK_WAIST) return 0.01 * tape_table(tape_child_back, h);
    if (child && measure == MUS_MEASURE_HEAD) return 0.01 * tape_table(tape_child_head, h);
    if (measure == MUS_MEASURE_SHOULDER_SLOPE) return (child ? 21.0 : 22.0) * (MUS_PI / 180.0);
    if (measure == MUS_MEASURE_ARM_ANGLE) return 45.0 * (MUS_PI / 180.0);
    if (measure == MUS_MEASURE_CROTCH_LENGTH) {
        if (child) return tape_crotch_at(2, tape->value);
        *deviation = 0.01 * tape_mix(tape->sex, tape_crotch_deviation[0], tape_crotch_deviation[1]);
        return tape_mix(tape->sex, tape_crotch_at(0, tape->value), tape_crotch_at(1, tape->value));
    }

    for (int i = 0; i < TAPE_RULE_COUNT; i++) {
        const tape_rule *rule = &tape_rules[i];
        if (rule->measure != measure) continue;
        if (child) return 0.01 * tape_line_at(&rule->child, tape->value);
        *deviation = 0.01 * tape_mix(tape->sex, rule->female_deviation, rule->male_deviation);
        return 0.01 *
               tape_mix(tape->sex, tape_line_at(&rule->female, tape->value), tape_line_at(&rule->male, tape->value));
    }
    return NAN;
}


/* set a measure that is not held to a derived value, clamped to the range of mus_tape_set() */
static void tape_put(mus_tape *tape, int32_t measure, double value)
{
    if (tape->held[measure]) return;
    double low, high;
    mus__tape_range(measure, &low, &high);
    tape->value[measure] = value < low ? low : value > high ? high : value;
    tape->source[measure] = MUS_SOURCE_DERIVED;
}


static void tape_put_predicted(mus_tape *tape, int32_t measure)
{
    double deviation;
    tape_put(tape, measure, mus__tape_predict(tape, measure, &deviation));
}


/* lower a measure that is not held to a bound that given measures set; tape_at_least raises it */
static void tape_at_most(mus_tape *tape, int32_t measure, double bound)
{
    if (!tape->held[measure] && tape->value[measure] > bound) tape_put(tape, measure, bound);
}


static void tape_at_least(mus_tape *tape, int32_t measure, double bound)
{
    if (!tape->held[measure] && tape->value[measure] < bound) tape_put(tape, measure, bound);
}


/* waist height = rise + inside leg: two of them give the third; of one alone, or none, the predicted rise or waist
 * height is used */
static void tape_derive_legs(mus_tape *tape)
{
    double *v = tape->value, deviation;
    const bool *held = tape->held;
    const int32_t r = MUS_MEASURE_RISE, l = MUS_MEASURE_INLEG, w = MUS_MEASURE_WAIST_HEIGHT;
    double stature = v[MUS_MEASURE_STATURE];
    double rise = held[r] ? v[r] : mus__tape_predict(tape, r, &deviation);
    double height = held[w] ? v[w] : mus__tape_predict(tape, w, &deviation);

    /* from the inside leg alone: waist height is inside leg plus predicted rise, within 0.50 to 0.66 of the stature */
    if (!held[w] && held[l]) {
        height = v[l] + rise;
        if (!held[r] && height > 0.66 * stature) height = fmax(0.66 * stature, v[l] + 0.1 * stature);
        if (!held[r] && height < 0.50 * stature) height = 0.50 * stature;
    }
    if (!held[r] && held[l]) rise = height - v[l];
    tape_put(tape, w, height);
    tape_put(tape, r, rise);
    tape_put(tape, l, v[w] - v[r]);
    tape_at_most(tape, l, 0.56 * stature);
    tape_put_predicted(tape, MUS_MEASURE_CROTCH_LENGTH);
}


/* girths that follow from other girths, and limits that given girths set */
static void tape_derive_girths(mus_tape *tape)
{
    double *v = tape->value;
    double bust = v[MUS_MEASURE_BUST], waist = v[MUS_MEASURE_WAIST], hip = v[MUS_MEASURE_HIP];

    /* the body under the bust is at least 0.97 of a wide waist */
    tape_at_least(tape, MUS_MEASURE_UNDERBUST, fmax(0.78 * bust, fmin(0.97 * waist, bust - 0.04)));
    double under = v[MUS_MEASURE_UNDERBUST];
    double high = bust - 0.35 * (bust - under);
    tape_put(tape, MUS_MEASURE_HIGH_BUST, tape->sex == MUS_SEX_CHILD ? high : tape_mix(tape->sex, high, bust + 0.01));
    tape_put(tape, MUS_MEASURE_HIGH_HIP, waist + 0.72 * (hip - waist));

    /* the knee from a measured thigh or calf: regression on ANSUR II, whose girth above the knee is 6 % more */
    double thigh = v[MUS_MEASURE_THIGH], calf = v[MUS_MEASURE_CALF];
    if (tape->sex != MUS_SEX_CHILD && (tape->held[MUS_MEASURE_THIGH] || tape->held[MUS_MEASURE_CALF]))
        tape_put(tape, MUS_MEASURE_KNEE,
                 tape_mix(tape->sex, 0.014 * hip + 0.253 * thigh + 0.576 * calf - 0.0075,
                          0.099 * hip + 0.188 * thigh + 0.353 * calf + 0.0287));

    /* limbs taper: of two neighbouring girths the derived one follows the given one */
    tape_at_least(tape, MUS_MEASURE_UPPER_ARM, 1.15 * v[MUS_MEASURE_WRIST]);
    tape_at_most(tape, MUS_MEASURE_WRIST, 0.85 * v[MUS_MEASURE_UPPER_ARM]);
    if (tape->held[MUS_MEASURE_WRIST]) tape_at_least(tape, MUS_MEASURE_HAND, 1.02 * v[MUS_MEASURE_WRIST]);
    tape_at_most(tape, MUS_MEASURE_KNEE, 0.90 * v[MUS_MEASURE_THIGH]);
    tape_at_least(tape, MUS_MEASURE_THIGH, 1.05 * v[MUS_MEASURE_KNEE]);
    tape_at_least(tape, MUS_MEASURE_CALF, 1.05 * v[MUS_MEASURE_ANKLE]);
    tape_at_most(tape, MUS_MEASURE_ANKLE, v[MUS_MEASURE_CALF]);
    tape_at_most(tape, MUS_MEASURE_BUST_SPAN, 0.45 * bust);
    tape_at_most(tape, MUS_MEASURE_NECK, 0.60 * bust);
    tape_at_most(tape, MUS_MEASURE_SHOULDER, 0.16 * v[MUS_MEASURE_STATURE]);
}


/* heights of nape, bust and hip: nape = waist + 0.97 nape-to-waist; bust = nape + 1 cm - 0.88 bust depth. The hip lies
 * 0.223 (women) or 0.177 (men) of a measured rise above the crotch (ANSUR II, standard deviations 1.7 and 2.0 cm) */
static void tape_derive_heights(mus_tape *tape)
{
    double *v = tape->value;
    double waist = v[MUS_MEASURE_WAIST_HEIGHT], stature = v[MUS_MEASURE_STATURE];
    if (tape->held[MUS_MEASURE_NAPE_HEIGHT])
        tape_put(tape, MUS_MEASURE_BACK_WAIST, (v[MUS_MEASURE_NAPE_HEIGHT] - waist) / 0.97);
    tape_put(tape, MUS_MEASURE_NAPE_HEIGHT, waist + 0.97 * v[MUS_MEASURE_BACK_WAIST]);
    tape_at_most(tape, MUS_MEASURE_NAPE_HEIGHT, 0.90 * stature);

    double nape = v[MUS_MEASURE_NAPE_HEIGHT];
    tape_put(tape, MUS_MEASURE_BUST_HEIGHT, nape + 0.01 - 0.88 * v[MUS_MEASURE_BUST_DEPTH]);
    const double least = waist + 0.25 * (nape - waist);
    tape_at_least(tape, MUS_MEASURE_BUST_HEIGHT, least);
    if (v[MUS_MEASURE_BUST_HEIGHT] <= least) tape_at_most(tape, MUS_MEASURE_BUST_DEPTH, (nape + 0.01 - least) / 0.88);
    if (tape->sex != MUS_SEX_CHILD && (tape->held[MUS_MEASURE_RISE] || tape->held[MUS_MEASURE_INLEG]))
        tape_put(tape, MUS_MEASURE_WAIST_TO_HIP, tape_mix(tape->sex, 0.777, 0.823) * v[MUS_MEASURE_RISE]);
    tape_at_most(tape, MUS_MEASURE_WAIST_TO_HIP, 0.85 * v[MUS_MEASURE_RISE]);
}


/* the angle of the arms: an upper arm of radius r hangs from the shoulder joint, `up` [m] above the bust and `in` [m]
 * within the side of the trunk there, less TAPE_ARM_CLEAR. Its lower side is off that place at the angle d below the
 * horizontal where in sin d - up cos d = -r. The joint is that of skeleton.c, without the breadth of the acromion */
static void tape_derive_arm_angle(mus_tape *tape)
{
    const double *v = tape->value;
    double slope = v[MUS_MEASURE_SHOULDER_SLOPE], shoulder = v[MUS_MEASURE_SHOULDER], deviation;
    const double r = v[MUS_MEASURE_UPPER_ARM] / (2.0 * MUS_PI);
    const double x = v[MUS_MEASURE_NECK] / (2.0 * MUS_PI) + shoulder * mus__cos(slope) - 0.36 * r;
    const double up = v[MUS_MEASURE_NAPE_HEIGHT] - 0.0165 * v[MUS_MEASURE_STATURE] - shoulder * mus__sin(slope) -
                      0.86 * r - v[MUS_MEASURE_BUST_HEIGHT];
    const double in = TAPE_TRUNK * v[MUS_MEASURE_BUST] + TAPE_ARM_CLEAR - x, far = sqrt(in * in + up * up);
    const double most = mus__tape_predict(tape, MUS_MEASURE_ARM_ANGLE, &deviation);
    tape_put(tape, MUS_MEASURE_ARM_ANGLE, fmin(most, mus__atan2(up, in) - mus__asin(fmin(r / far, 1.0))));
}


void mus__tape_derive(mus_tape *tape)
{
    /* unset the values of an earlier derivation */
    for (int32_t i = 0; i < MUS_MEASURE_COUNT; i++) {
        if (tape->held[i]) continue;
        tape->value[i] = NAN;
        tape->source[i] = MUS_SOURCE_NONE;
    }

    /* a child's girths from its stature */
    static const int32_t girths[] = {MUS_MEASURE_BUST, MUS_MEASURE_WAIST, MUS_MEASURE_HIP};
    if (tape->sex == MUS_SEX_CHILD) {
        /* girths that were not measured: the table's, times the mean ratio of the measured ones to the table's */
        const double stature = tape->value[MUS_MEASURE_STATURE];
        double build = 0.0;
        int given = 0;
        for (int i = 0; i < 3; i++)
            if (tape->held[girths[i]])
                build += tape->value[girths[i]] / mus__tape_child_girth(stature, girths[i]), given++;
        build = given > 0 ? build / given : 1.0;
        for (int i = 0; i < 3; i++) tape_put(tape, girths[i], build * mus__tape_child_girth(stature, girths[i]));
    }

    /* measures with a line of their own; rise and waist height depend on each other: tape_derive_legs() */
    for (int i = 0; i < TAPE_RULE_COUNT; i++) {
        int32_t measure = tape_rules[i].measure;
        if (measure != MUS_MEASURE_RISE && measure != MUS_MEASURE_WAIST_HEIGHT) tape_put_predicted(tape, measure);
    }
    tape_put_predicted(tape, MUS_MEASURE_SHOULDER_SLOPE);
    if (tape->sex == MUS_SEX_CHILD)
        tape_put(tape, MUS_MEASURE_ACROSS_FRONT, 0.97 * tape->value[MUS_MEASURE_ACROSS_BACK]);
    tape_put(tape, MUS_MEASURE_ELBOW, 0.58 * tape->value[MUS_MEASURE_ARM]);
    tape_derive_legs(tape);
    tape_derive_girths(tape);
    tape_derive_heights(tape);
    tape_derive_arm_angle(tape);
}
