/*
 * tape_yaml.c: read a GarmentCode body file: one map `body:` of numbers in centimetres and degrees.
 *
 * libyaml reads the file event by event: no document is built, and aliases are refused. GarmentCode measures levels
 * downwards from the crown; muslin's heights follow from them:
 *
 *     level = height - head_l       waist = level - waist_line      bust = level - vert_bust_line
 *     crotch = waist - hips_line - crotch_hip_diff
 *
 * `level` is the height at which the shoulder line is neck_w / 2 from the middle, and not the nape. This was measured
 * on the meshes of GarmentCode's bodies (mean_all 1.456 m of 1.457, mean_female 1.400 of 1.407); the seventh vertebra
 * is 4 cm higher there. The shoulder line continues inwards, rising by shoulder_incl, to the side of the neck base; the
 * nape lies above that by a share of the stature.
 *
 * Ignored, because muslin defines the measure otherwise: back_width and similar ones (half a girth at a level, not the
 * width across the back), bust_line and waist_over_bust_line (from the middle of the shoulder). Source: GarmentCode,
 * assets/bodies and its documentation of body measurements.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <yaml.h>

#include "base/elementary.h"
#include "exchange/file_read.h"
#include "exchange/tape_readers.h"

/* height of the nape above the side of the neck base, over the stature; chosen: sets the nape of a GarmentCode body */
#define BODY_NECK_SIDE 0.0165
/* depth of the armpit over the scye depth, which is measured to a lower tape; chosen: sets the armpit of a
 * GarmentCode body */
#define BODY_SCYE 0.9
/* an arm longer than this part of the stature is one to the fingertips, as of GarmentCode's bodies of SMPL: the tape's
 * own limit of an arm to the wrist */
#define BODY_ARM_MOST 0.43
/* length of the hand over the stature. Source: Drillis and Contini, Body Segment Parameters, 1966 */
#define BODY_HAND 0.108


/* the measures of the file, by their own names */
#define BODY_LIST(X)                                                                                                   \
    X(HEIGHT, "height")                                                                                                \
    X(BUST, "bust")                                                                                                    \
    X(UNDERBUST, "underbust")                                                                                          \
    X(WAIST, "waist")                                                                                                  \
    X(HIPS, "hips")                                                                                                    \
    X(THIGH, "leg_circ")                                                                                               \
    X(WRIST, "wrist")                                                                                                  \
    X(ARM, "arm_length")                                                                                               \
    X(ARM_ANGLE, "arm_pose_angle")                                                                                     \
    X(HEAD, "head_l")                                                                                                  \
    X(WAIST_LINE, "waist_line")                                                                                        \
    X(BUST_LINE, "vert_bust_line")                                                                                     \
    X(HIPS_LINE, "hips_line")                                                                                          \
    X(CROTCH, "crotch_hip_diff")                                                                                       \
    X(BUST_POINTS, "bust_points")                                                                                      \
    X(SHOULDER, "shoulder_w")                                                                                          \
    X(NECK_WIDTH, "neck_w")                                                                                            \
    X(ARMSCYE, "armscye_depth")                                                                                        \
    X(INCLINE, "shoulder_incl")

#define BODY_ENUM(NAME, name) BODY_##NAME,
enum { BODY_LIST(BODY_ENUM) BODY_COUNT };
#undef BODY_ENUM

#define BODY_NAME(NAME, name) name,
static const char *const body_names[BODY_COUNT] = {BODY_LIST(BODY_NAME)};
#undef BODY_NAME

/* state of the reader: in the document, in its top map, or in the map `body` */
struct body_reader {
    mus__source *source;
    mus__unused *unused;
    double value[BODY_COUNT]; /* NaN: not in the file */
    int32_t depth;
    bool wants_value; /* a key was read and its value is next */
    bool in_body;
    bool found;
    char key[64];
};


static mus_status body_number(struct body_reader *reader, const char *text, int64_t line)
{
    int32_t i = 0;
    while (i < BODY_COUNT && strcmp(reader->key, body_names[i]) != 0) i++;
    if (i == BODY_COUNT) {
        mus__unused_add(reader->unused, reader->key);
        return MUS_OK;
    }
    if (reader->value[i] == reader->value[i])
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "%s: given a second time", reader->key);
    const char *wrong = mus__number_read(text, &reader->value[i]);
    if (wrong == NULL) return MUS_OK;
    return mus__source_fail(reader->source, line, MUS_ERR_FORMAT,
                            "%s: expected a number in cm or degrees, \"%.40s\" %s", reader->key, text, wrong);
}


static mus_status body_scalar(struct body_reader *reader, const yaml_event_t *event, int64_t line)
{
    const char *text = (const char *)event->data.scalar.value;
    if (strlen(text) != event->data.scalar.length)
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "a zero byte, expected text");
    if (reader->depth == 0)
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "expected a map \"body:\", got \"%.40s\"", text);
    if (!reader->wants_value) {
        if (strlen(text) >= sizeof reader->key)
            return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "a key of %zu bytes, the limit is %zu",
                                    strlen(text), sizeof reader->key - 1);
        memcpy(reader->key, text, strlen(text) + 1);
        reader->wants_value = true;
        return MUS_OK;
    }
    reader->wants_value = false;
    if (reader->in_body) return body_number(reader, text, line);
    if (strcmp(reader->key, "body") == 0)
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "body: expected a map of measures, got \"%.40s\"",
                                text);
    mus__unused_add(reader->unused, reader->key);
    return MUS_OK;
}


static mus_status body_map(struct body_reader *reader, int64_t line)
{
    bool body = reader->depth == 1 && reader->wants_value && strcmp(reader->key, "body") == 0;
    if (reader->depth > 0 && !body)
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "expected a number, got a map");
    if (body && reader->found)
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "body: given a second time");
    reader->depth++;
    reader->in_body = body;
    reader->found = reader->found || body;
    reader->wants_value = false;
    return MUS_OK;
}


/* handle one event of the file; *done is true at the end */
static mus_status body_event(struct body_reader *reader, const yaml_event_t *event, bool *done)
{
    int64_t line = (int64_t)event->start_mark.line + 1;
    switch (event->type) {
    case YAML_SCALAR_EVENT: return body_scalar(reader, event, line);
    case YAML_MAPPING_START_EVENT: return body_map(reader, line);
    case YAML_MAPPING_END_EVENT:
        reader->depth--;
        reader->in_body = false;
        return MUS_OK;
    case YAML_SEQUENCE_START_EVENT:
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "expected a map of measures, got a list");
    case YAML_ALIAS_EVENT:
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "expected a number, got an alias");
    case YAML_DOCUMENT_END_EVENT:
    case YAML_STREAM_END_EVENT: *done = true; return MUS_OK;
    default: return MUS_OK;
    }
}


static mus_status body_parse(struct body_reader *reader, yaml_parser_t *parser)
{
    mus_status status = MUS_OK;
    bool done = false;
    while (status == MUS_OK && !done) {
        yaml_event_t event;
        if (!yaml_parser_parse(parser, &event)) {
            if (parser->error == YAML_MEMORY_ERROR)
                return mus__source_fail(reader->source, 0, MUS_ERR_MEMORY, "no memory for the yaml reader");
            size_t line = parser->error == YAML_READER_ERROR ? 0 : parser->problem_mark.line + 1;
            return mus__source_fail(reader->source, (int64_t)line, MUS_ERR_FORMAT, "expected yaml: %s (byte %zu)",
                                    parser->problem != NULL ? parser->problem : "not readable",
                                    parser->error == YAML_READER_ERROR ? parser->problem_offset
                                                                       : parser->problem_mark.index);
        }
        status = body_event(reader, &event, &done);
        yaml_event_delete(&event);
    }
    return status;
}


/* set a measure unless an input of its formula is missing (value is NaN) */
static mus_status body_set(struct body_reader *reader, mus_tape *tape, int32_t measure, double value)
{
    if (value != value) return MUS_OK;
    mus_status status = mus_tape_set(tape, measure, value, MUS_SOURCE_GIVEN);
    return status == MUS_OK ? MUS_OK : mus__source_wrap(reader->source, 0, status);
}


/* length of the arm to the wrist [cm] */
static double body_arm(const struct body_reader *reader)
{
    const double arm = reader->value[BODY_ARM], height = reader->value[BODY_HEIGHT];
    if (!(arm > BODY_ARM_MOST * height)) return arm;
    char text[384]; /* the name has at most 200 bytes, as in file_read.h */
    snprintf(text, sizeof text, "%s: arm_length %g of a height of %g is to the fingertips: %.1f is taken, to the wrist",
             reader->source->name, arm, height, arm - BODY_HAND * height);
    mus_context_log(reader->source->context, MUS_LOG_WARNING, text);
    return arm - BODY_HAND * height;
}


static mus_status body_measures(struct body_reader *reader, mus_tape *tape)
{
    const double *v = reader->value;
    double level = v[BODY_HEIGHT] - v[BODY_HEAD];
    double waist = level - v[BODY_WAIST_LINE];
    double rise = v[BODY_HIPS_LINE] + v[BODY_CROTCH];

    const struct {
        int32_t measure;
        double value;
    } measures[] = {
        {MUS_MEASURE_STATURE, v[BODY_HEIGHT] / 100.0},
        {MUS_MEASURE_BUST, v[BODY_BUST] / 100.0},
        {MUS_MEASURE_UNDERBUST, v[BODY_UNDERBUST] / 100.0},
        {MUS_MEASURE_WAIST, v[BODY_WAIST] / 100.0},
        {MUS_MEASURE_HIP, v[BODY_HIPS] / 100.0},
        {MUS_MEASURE_THIGH, v[BODY_THIGH] / 100.0},
        {MUS_MEASURE_WRIST, v[BODY_WRIST] / 100.0},
        {MUS_MEASURE_ARM, body_arm(reader) / 100.0},
        {MUS_MEASURE_ARM_ANGLE, v[BODY_ARM_ANGLE] * MUS__DEGREE},
        {MUS_MEASURE_SHOULDER_SLOPE, v[BODY_INCLINE] * MUS__DEGREE},
        {MUS_MEASURE_BUST_SPAN, v[BODY_BUST_POINTS] / 100.0},
        {MUS_MEASURE_NAPE_HEIGHT, (level + BODY_NECK_SIDE * v[BODY_HEIGHT]) / 100.0},
        {MUS_MEASURE_BUST_HEIGHT, (level - v[BODY_BUST_LINE]) / 100.0},
        {MUS_MEASURE_WAIST_HEIGHT, waist / 100.0},
        {MUS_MEASURE_WAIST_TO_HIP, v[BODY_HIPS_LINE] / 100.0},
        {MUS_MEASURE_RISE, rise / 100.0},
        {MUS_MEASURE_INLEG, (waist - rise) / 100.0},
    };
    mus_status status = MUS_OK;
    for (size_t i = 0; i < sizeof measures / sizeof measures[0] && status == MUS_OK; i++)
        status = body_set(reader, tape, measures[i].measure, measures[i].value);
    return status;
}


/*
 * Set shoulder, nape and armpit from `side`, the distance of the side of the neck base from the middle.
 *
 * The shoulder line of the tape runs from the side of the neck base to the shoulder point. The file has the breadth
 * between the shoulder points and the slope, but its neck width is measured on the shoulder muscles. So the side of the
 * neck is computed from the neck girth that completion derives:
 *
 *     side = neck / 2 pi            shoulder = (shoulder_w / 2 - side) / cos(shoulder_incl)
 *     nape = level + (neck_w / 2 - side) tan(shoulder_incl) + 0.0165 height
 *
 * The armpit is armscye_depth below the shoulder point, which is (shoulder_w - neck_w) / 2 tan(shoulder_incl) below the
 * level.
 */
static mus_status body_shoulder_line(struct body_reader *reader, mus_tape *tape, double side)
{
    const double *v = reader->value, slope = mus__tan(v[BODY_INCLINE] * MUS__DEGREE);
    const double point = 0.5 * v[BODY_SHOULDER] / 100.0, width = 0.5 * v[BODY_NECK_WIDTH] / 100.0;
    const double level = (v[BODY_HEIGHT] - v[BODY_HEAD]) / 100.0;
    const double nape = level + (width - side) * slope + BODY_NECK_SIDE * v[BODY_HEIGHT] / 100.0;
    const double armpit = level - (point - width) * slope - v[BODY_ARMSCYE] / 100.0;
    mus_status status = body_set(reader, tape, MUS_MEASURE_SHOULDER, (point - side) * mus__hypot(1.0, slope));
    if (status == MUS_OK) status = body_set(reader, tape, MUS_MEASURE_NAPE_HEIGHT, nape);
    if (status == MUS_OK) status = body_set(reader, tape, MUS_MEASURE_SCYE_DEPTH, (nape - armpit) / BODY_SCYE);
    return status;
}


/* set the measures that need the derived neck girth; an incomplete file has none */
static mus_status body_shoulder(struct body_reader *reader, mus_tape *tape)
{
    mus_tape *whole;
    mus_status status = mus_tape_copy(tape, &whole);
    if (status != MUS_OK) return status;
    status = mus_tape_complete(whole);
    if (status == MUS_OK)
        status = body_shoulder_line(reader, tape, mus_tape_value(whole, MUS_MEASURE_NECK) / (360.0 * MUS__DEGREE));
    else if (status == MUS_ERR_TAPE)
        status = MUS_OK;
    mus_tape_destroy(whole);
    return status;
}


mus_status mus__tape_read_yaml(mus__source *source, mus_tape *tape, mus__unused *unused)
{
    struct body_reader reader = {.source = source, .unused = unused};
    for (int32_t i = 0; i < BODY_COUNT; i++) reader.value[i] = NAN;

    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for the yaml reader");
    yaml_parser_set_input_string(&parser, (const unsigned char *)source->text, source->size);
    mus_status status = body_parse(&reader, &parser);
    yaml_parser_delete(&parser);
    if (status != MUS_OK) return status;

    if (!reader.found) return mus__source_fail(source, 0, MUS_ERR_FORMAT, "expected a map \"body:\", found none");
    status = body_measures(&reader, tape);
    return status == MUS_OK ? body_shoulder(&reader, tape) : status;
}
