/*
 * people.h: tapes of real people for the body's tests: a size, a row of FreeSewing's table of models, a GarmentCode
 * body. The readers here are a few lines for these files alone, so that the body is tested without the exchange.
 */
#ifndef MUS_TESTS_BODY_PEOPLE_H
#define MUS_TESTS_BODY_PEOPLE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/body.h"
#include "support.h"


static inline mus_tape *people_size(mus_context *context, const char *size)
{
    mus_tape *tape = NULL;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, size), MUS_OK);
    return tape;
}


static inline mus_body *people_body(mus_context *context, const char *size, const mus_body_def *def)
{
    mus_tape *tape = people_size(context, size);
    mus_body *body = NULL;
    mus_status status = mus_body_create(context, tape, def, &body);
    ck_assert_msg(status == MUS_OK, "%s: %s", size, mus_context_error(context));
    mus_tape_destroy(tape);
    return body;
}


/* row of freesewing/models.csv (mm, degrees) as a tape, its name in `name` (64); NULL at the end of the table. *status:
 * whether all of its measures are those of a person */
static inline mus_tape *people_model(mus_context *context, const char *table, int row, char *name, mus_status *status)
{
    static const struct {
        const char *column;
        int32_t measure;
    } known[] = {{"ankle", MUS_MEASURE_ANKLE},
                 {"biceps", MUS_MEASURE_UPPER_ARM},
                 {"bustSpan", MUS_MEASURE_BUST_SPAN},
                 {"chest", MUS_MEASURE_BUST},
                 {"head", MUS_MEASURE_HEAD},
                 {"highBust", MUS_MEASURE_HIGH_BUST},
                 {"hips", MUS_MEASURE_HIGH_HIP},
                 {"hpsToBust", MUS_MEASURE_BUST_DEPTH},
                 {"inseam", MUS_MEASURE_INLEG},
                 {"knee", MUS_MEASURE_KNEE},
                 {"neck", MUS_MEASURE_NECK},
                 {"seat", MUS_MEASURE_HIP},
                 {"shoulderSlope", MUS_MEASURE_SHOULDER_SLOPE},
                 {"shoulderToElbow", MUS_MEASURE_ELBOW},
                 {"shoulderToWrist", MUS_MEASURE_ARM},
                 {"underbust", MUS_MEASURE_UNDERBUST},
                 {"upperLeg", MUS_MEASURE_THIGH},
                 {"waist", MUS_MEASURE_WAIST},
                 {"waistToFloor", MUS_MEASURE_WAIST_HEIGHT},
                 {"waistToSeat", MUS_MEASURE_WAIST_TO_HIP},
                 {"wrist", MUS_MEASURE_WRIST},
                 {"crossSeam", MUS_MEASURE_CROTCH_LENGTH}};
    const char *head = table, *line = table;
    for (int i = 0; i <= row; i++) {
        line = strchr(line, '\n');
        if (line == NULL || *++line == '\0') return NULL;
    }
    snprintf(name, 64, "%.*s", (int)strcspn(line, ","), line);
    bool male = strncmp(name, "cisMale", 7) == 0;

    mus_tape *tape = NULL;
    *status = MUS_OK;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_sex(tape, male ? MUS_SEX_MALE : MUS_SEX_FEMALE), MUS_OK);
    while (*head != '\n' && *head != '\r') {
        size_t length = strcspn(head, ",\r\n");
        for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
            if (strlen(known[k].column) != length || strncmp(head, known[k].column, length) != 0) continue;
            double scale = mus_measure_unit(known[k].measure) == 'r' ? 3.14159265358979323846 / 180.0 : 0.001;
            mus_status set = mus_tape_set(tape, known[k].measure, scale * atof(line), MUS_SOURCE_GIVEN);
            if (set != MUS_OK) *status = set;
        }
        head += length + (head[length] == ',');
        line += strcspn(line, ",\r\n");
        line += *line == ',';
    }
    double waist = mus_tape_value(tape, MUS_MEASURE_WAIST_HEIGHT);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_STATURE, waist / (male ? 0.615 : 0.622), MUS_SOURCE_DERIVED),
                     MUS_OK);
    return tape;
}


static inline double people_yaml(const char *text, const char *key)
{
    char line[64];
    snprintf(line, sizeof line, "\n  %s:", key);
    const char *at = strstr(text, line);
    return at != NULL ? atof(at + strlen(line)) : NAN;
}


/* a GarmentCode body (cm, degrees); heights by its README: nape = height - head_l and so on down */
static inline mus_tape *people_garmentcode(mus_context *context, const char *text, int32_t sex)
{
    double nape = people_yaml(text, "height") - people_yaml(text, "head_l"),
           waist = nape - people_yaml(text, "waist_line");
    double hip = waist - people_yaml(text, "hips_line"), crotch = hip - people_yaml(text, "crotch_hip_diff");
    const double stature = people_yaml(text, "height"), arm = people_yaml(text, "arm_length");
    double slope = people_yaml(text, "shoulder_incl") * (3.14159265358979323846 / 180.0);
    const struct {
        int32_t measure;
        double cm;
    } row[] = {
        {MUS_MEASURE_STATURE, people_yaml(text, "height")},
        {MUS_MEASURE_BUST, people_yaml(text, "bust")},
        {MUS_MEASURE_UNDERBUST, people_yaml(text, "underbust")},
        {MUS_MEASURE_WAIST, people_yaml(text, "waist")},
        {MUS_MEASURE_HIP, people_yaml(text, "hips")},
        {MUS_MEASURE_THIGH, people_yaml(text, "leg_circ")},
        {MUS_MEASURE_WRIST, people_yaml(text, "wrist")},
        {MUS_MEASURE_ARM, arm > 0.43 * stature ? arm - 0.108 * stature : arm}, /* to the fingertips: less the hand */
        {MUS_MEASURE_NAPE_HEIGHT, nape},
        {MUS_MEASURE_WAIST_HEIGHT, waist},
        {MUS_MEASURE_WAIST_TO_HIP, waist - hip},
        {MUS_MEASURE_INLEG, crotch},
        {MUS_MEASURE_BUST_SPAN, people_yaml(text, "bust_points")},
        {MUS_MEASURE_BACK_WAIST, people_yaml(text, "waist_line")},
        {MUS_MEASURE_SHOULDER, 0.5 * (people_yaml(text, "shoulder_w") - people_yaml(text, "neck_w")) / cos(slope)},
        {MUS_MEASURE_BUST_HEIGHT, nape - people_yaml(text, "vert_bust_line")}};
    mus_tape *tape = NULL;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_sex(tape, sex), MUS_OK);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (!isnan(row[i].cm))
            ck_assert_msg(mus_tape_set(tape, row[i].measure, 0.01 * row[i].cm, MUS_SOURCE_GIVEN) == MUS_OK, "%s",
                          mus_context_error(context));
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_SHOULDER_SLOPE, slope, MUS_SOURCE_GIVEN), MUS_OK);
    return tape;
}


/* the girths that a body has on its surface */
static const int32_t people_girths[] = {
    MUS_MEASURE_BUST,     MUS_MEASURE_WAIST, MUS_MEASURE_HIP,       MUS_MEASURE_UNDERBUST, MUS_MEASURE_HIGH_BUST,
    MUS_MEASURE_HIGH_HIP, MUS_MEASURE_NECK,  MUS_MEASURE_UPPER_ARM, MUS_MEASURE_WRIST,     MUS_MEASURE_HAND,
    MUS_MEASURE_THIGH,    MUS_MEASURE_KNEE,  MUS_MEASURE_CALF,      MUS_MEASURE_ANKLE,     MUS_MEASURE_HEAD};
#define PEOPLE_GIRTHS ((int)(sizeof people_girths / sizeof *people_girths))

#endif
