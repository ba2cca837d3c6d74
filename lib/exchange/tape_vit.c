/*
 * tape_vit.c: read an individual measurement file of Valentina or Seamly2D (.vit): XML, one <m name value/> a measure.
 *
 * expat reads the file as a stream. Values are numbers in the unit of the file; 0 means not measured. A value may also
 * be a formula over other names. A formula in a measure that muslin knows is an error that names the measure. Names
 * that start with "@" are the user's own and are ignored, as are names for which muslin has no measure, except the
 * letters of the Russian tailoring standards (GOST 17522, the uniform method of garment design), which many such files
 * use: the stature, lengths, and halves of girths and widths whose meaning does not differ between books. A document
 * type declaration is refused, since these files need no entities.
 *
 * Names: reference table of Valentina's known measures by formula name. Where two names fit one measure, the first in
 * the table wins.
 */
#include <expat.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "exchange/file_read.h"
#include "exchange/tape_readers.h"


static const struct {
    const char *name;
    int32_t measure;
} vit_names[] = {
    {"height", MUS_MEASURE_STATURE},
    {"bust_circ", MUS_MEASURE_BUST},
    {"waist_circ", MUS_MEASURE_WAIST},
    {"waist_natural_circ", MUS_MEASURE_WAIST},
    {"hip_circ", MUS_MEASURE_HIP},
    {"lowbust_circ", MUS_MEASURE_UNDERBUST},
    {"highbust_circ", MUS_MEASURE_HIGH_BUST},
    {"highhip_circ", MUS_MEASURE_HIGH_HIP},
    {"neck_circ", MUS_MEASURE_NECK},
    {"shoulder_length", MUS_MEASURE_SHOULDER},
    {"shoulder_slope_neck_side_angle", MUS_MEASURE_SHOULDER_SLOPE},
    {"across_back_b", MUS_MEASURE_ACROSS_BACK},
    {"across_chest_f", MUS_MEASURE_ACROSS_FRONT},
    {"neck_back_to_waist_b", MUS_MEASURE_BACK_WAIST},
    {"neck_side_to_waist_bustpoint_f", MUS_MEASURE_FRONT_WAIST},
    {"neck_side_to_bust_f", MUS_MEASURE_BUST_DEPTH},
    {"bustpoint_to_neck_side", MUS_MEASURE_BUST_DEPTH},
    {"bustpoint_to_bustpoint", MUS_MEASURE_BUST_SPAN},
    {"neck_back_to_highbust_b", MUS_MEASURE_SCYE_DEPTH},
    {"arm_shoulder_tip_to_wrist_bent", MUS_MEASURE_ARM},
    {"arm_shoulder_tip_to_elbow_bent", MUS_MEASURE_ELBOW},
    {"arm_upper_circ", MUS_MEASURE_UPPER_ARM},
    {"arm_wrist_circ", MUS_MEASURE_WRIST},
    {"hand_circ", MUS_MEASURE_HAND},
    {"height_waist_side", MUS_MEASURE_WAIST_HEIGHT},
    {"waist_to_hip_side", MUS_MEASURE_WAIST_TO_HIP},
    {"rise_length_side", MUS_MEASURE_RISE},
    {"rise_length_side_sitting", MUS_MEASURE_RISE},
    {"leg_crotch_to_floor", MUS_MEASURE_INLEG},
    {"crotch_length", MUS_MEASURE_CROTCH_LENGTH},
    {"leg_thigh_upper_circ", MUS_MEASURE_THIGH},
    {"leg_knee_circ", MUS_MEASURE_KNEE},
    {"leg_calf_circ", MUS_MEASURE_CALF},
    {"leg_ankle_circ", MUS_MEASURE_ANKLE},
    {"head_circ", MUS_MEASURE_HEAD},
    {"foot_length", MUS_MEASURE_FOOT},
    {"height_neck_back", MUS_MEASURE_NAPE_HEIGHT},
    {"height_bustpoint", MUS_MEASURE_BUST_HEIGHT},
    {"@Р", MUS_MEASURE_STATURE},
    {"@Шп", MUS_MEASURE_SHOULDER},
    {"@Оп", MUS_MEASURE_UPPER_ARM},
    {"@Сш", MUS_MEASURE_NECK},
    {"@Сг", MUS_MEASURE_BUST},
    {"@Сг3", MUS_MEASURE_BUST},
    {"@СгІІІ", MUS_MEASURE_BUST},
    {"@Ст", MUS_MEASURE_WAIST},
    {"@Сб", MUS_MEASURE_HIP},
    {"@Шс", MUS_MEASURE_ACROSS_BACK},
    {"@Шг", MUS_MEASURE_ACROSS_FRONT},
    {"@Цг", MUS_MEASURE_BUST_SPAN},
};

#define VIT_NAME_COUNT ((int32_t)(sizeof vit_names / sizeof vit_names[0]))
#define VIT_GOST_HALVES (VIT_NAME_COUNT - 9) /* from this name on the file has half of the measure */

struct vit_reader {
    mus__source *source;
    XML_Parser parser;
    mus_status status;
    mus__unused *unused;
    int32_t depth;
    bool in_personal;
    bool in_measures;
    char *text; /* (32) gets the text of this element, or NULL */
    char unit[32];
    char gender[32];
    double value[VIT_NAME_COUNT]; /* in the unit of the file; NaN: not measured */
    int64_t line[VIT_NAME_COUNT]; /* 0: not in the file */
};


static void vit_fail(struct vit_reader *reader, mus_status status)
{
    reader->status = status;
    XML_StopParser(reader->parser, XML_FALSE);
}


/* whether a text subtracts: "92-1/2" is 91.5 in Valentina, and a half more than 92 where no formula is meant */
static bool vit_subtracts(const char *text)
{
    for (const char *at = text; *at != '\0'; at++)
        if (*at >= '0' && *at <= '9' && at[1] == '-') return true;
    return false;
}


/* read a value: a number, nothing, or a formula */
static mus_status vit_value(struct vit_reader *reader, int32_t i, const char *text, int64_t line)
{
    const char *name = vit_names[i].name;
    if (text == NULL) return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "%s: expected a value", name);
    if (text[strspn(text, " \t\r\n")] == '\0') return MUS_OK;

    double value = 0.0;
    const char *wrong = mus__number_read(text, &value);
    const bool formula = vit_subtracts(text) || text[strspn(text, " \t\r\n+-.,0123456789")] != '\0';
    if (wrong == NULL && !vit_subtracts(text)) {
        if (value != 0.0) reader->value[i] = value;
        return MUS_OK;
    }

    /* a text with letters or operators is a formula */
    if (!formula)
        return mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "%s: expected a number, \"%.40s\" %s", name, text,
                                wrong);
    return mus__source_fail(reader->source, line, MUS_ERR_UNSUPPORTED,
                            "%s: expected a number, \"%.40s\" is a formula; let Valentina put its value there", name,
                            text);
}


static void vit_measure(struct vit_reader *reader, const XML_Char **attributes)
{
    const char *name = NULL, *value = NULL;
    for (; *attributes != NULL; attributes += 2) {
        if (strcmp(attributes[0], "name") == 0) name = attributes[1];
        if (strcmp(attributes[0], "value") == 0) value = attributes[1];
    }
    int64_t line = (int64_t)XML_GetCurrentLineNumber(reader->parser);
    if (name == NULL) {
        vit_fail(reader, mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "<m> without a name"));
        return;
    }

    int32_t i = 0;
    while (i < VIT_NAME_COUNT && strcmp(name, vit_names[i].name) != 0) i++;
    if (i == VIT_NAME_COUNT) {
        if (value != NULL && strspn(value, " 0") < strlen(value)) mus__unused_add(reader->unused, name);
        return;
    }
    mus_status status = MUS_OK;
    if (reader->line[i] > 0)
        status = mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "%s: given in line %lld already", name,
                                  (long long)reader->line[i]);
    else
        status = vit_value(reader, i, value, line);
    reader->line[i] = line;
    if (status != MUS_OK) vit_fail(reader, status);
}


static void XMLCALL vit_start(void *user, const XML_Char *name, const XML_Char **attributes)
{
    struct vit_reader *reader = user;
    reader->depth++;
    reader->text = NULL;
    if (reader->depth == 1 && strcmp(name, "vit") != 0) {
        int64_t line = (int64_t)XML_GetCurrentLineNumber(reader->parser);
        vit_fail(reader, mus__source_fail(reader->source, line, MUS_ERR_FORMAT, "expected <vit>, got <%.40s>", name));
    } else if (reader->depth == 2) {
        reader->in_personal = strcmp(name, "personal") == 0;
        reader->in_measures = strcmp(name, "body-measurements") == 0;
        if (strcmp(name, "unit") == 0) reader->text = reader->unit;
    } else if (reader->depth == 3 && reader->in_measures && strcmp(name, "m") == 0) {
        vit_measure(reader, attributes);
    } else if (reader->depth == 3 && reader->in_personal && strcmp(name, "gender") == 0) {
        reader->text = reader->gender;
    }
}


static void XMLCALL vit_end(void *user, const XML_Char *name)
{
    struct vit_reader *reader = user;
    (void)name;
    reader->depth--;
    reader->text = NULL;
}


static void XMLCALL vit_characters(void *user, const XML_Char *text, int length)
{
    struct vit_reader *reader = user;
    if (reader->text == NULL) return;
    size_t used = strlen(reader->text);
    for (int i = 0; i < length && used + 1 < sizeof reader->unit; i++)
        if (strchr(" \t\r\n", text[i]) == NULL) reader->text[used++] = text[i];
    reader->text[used] = '\0';
}


static void XMLCALL vit_doctype(void *user, const XML_Char *name, const XML_Char *system, const XML_Char *public,
                                int internal)
{
    struct vit_reader *reader = user;
    (void)name, (void)system, (void)public, (void)internal;
    int64_t line = (int64_t)XML_GetCurrentLineNumber(reader->parser);
    vit_fail(reader, mus__source_fail(reader->source, line, MUS_ERR_FORMAT,
                                      "a document type declaration, expected none in a .vit"));
}


static mus_status vit_parse(struct vit_reader *reader)
{
    XML_Parser parser = reader->parser;
    XML_SetUserData(parser, reader);
    XML_SetElementHandler(parser, vit_start, vit_end);
    XML_SetCharacterDataHandler(parser, vit_characters);
    XML_SetStartDoctypeDeclHandler(parser, vit_doctype);

    /* the largest file is far below INT_MAX */
    enum XML_Status parsed = XML_Parse(parser, reader->source->text, (int)reader->source->size, 1);
    if (reader->status != MUS_OK) return reader->status;
    if (parsed == XML_STATUS_OK) return MUS_OK;
    enum XML_Error error = XML_GetErrorCode(parser);
    return mus__source_fail(reader->source, (int64_t)XML_GetCurrentLineNumber(parser),
                            error == XML_ERROR_NO_MEMORY ? MUS_ERR_MEMORY : MUS_ERR_FORMAT,
                            "expected XML: %s (byte %lld)", XML_ErrorString(error),
                            (long long)XML_GetCurrentByteIndex(parser));
}


static mus_status vit_measures(const struct vit_reader *reader, mus_tape *tape)
{
    static const struct {
        const char *name;
        double up, down; /* [m] = number * up / down: the division makes 92 cm the double nearest to 0.92 */
    } units[] = {{"mm", 1.0, 1000.0}, {"cm", 1.0, 100.0}, {"inch", 254.0, 10000.0}};
    size_t u = 0, n = sizeof units / sizeof units[0];
    while (u < n && strcmp(reader->unit, units[u].name) != 0) u++;
    if (u == n)
        return mus__source_fail(reader->source, 0, MUS_ERR_FORMAT, "unit: expected mm, cm or inch, got \"%s\"",
                                reader->unit);

    mus_status status = MUS_OK;
    for (int32_t i = 0; i < VIT_NAME_COUNT && status == MUS_OK; i++) {
        int32_t measure = vit_names[i].measure;
        bool set = mus_tape_source(tape, measure) != MUS_SOURCE_NONE;
        if (reader->value[i] != reader->value[i] || set) continue;
        bool length = mus_measure_unit(measure) == 'm';
        double value = length ? reader->value[i] * units[u].up / units[u].down : reader->value[i] * MUS__DEGREE;
        if (i >= VIT_GOST_HALVES) value *= 2.0;
        status = mus_tape_set(tape, measure, value, MUS_SOURCE_GIVEN);
        if (status != MUS_OK) status = mus__source_wrap(reader->source, reader->line[i], status);
    }
    if (status == MUS_OK && strcmp(reader->gender, "female") == 0) status = mus_tape_set_sex(tape, MUS_SEX_FEMALE);
    if (status == MUS_OK && strcmp(reader->gender, "male") == 0) status = mus_tape_set_sex(tape, MUS_SEX_MALE);
    return status;
}


mus_status mus__tape_read_vit(mus__source *source, mus_tape *tape, mus__unused *unused)
{
    struct vit_reader reader = {.source = source, .unused = unused};
    for (int32_t i = 0; i < VIT_NAME_COUNT; i++) reader.value[i] = NAN;
    reader.parser = XML_ParserCreate(NULL);
    if (reader.parser == NULL) return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for the XML reader");
    mus_status status = vit_parse(&reader);
    XML_ParserFree(reader.parser);
    return status == MUS_OK ? vit_measures(&reader, tape) : status;
}
