/*
 * tape_csv.c: read one row of a csv table as a tape: FreeSewing's table of models, and a general form.
 *
 * First line: column names; first column: names of the rows. Fields may stand in double quotes (RFC 4180).
 * A first column named "model" marks FreeSewing's table: its own column names, millimetres and degrees, the sex in the
 * name of the row. In any other table a column is a measure with its unit ("bust_cm", "shoulder_slope_deg") or "sex"; a
 * column whose name does not end with a unit is ignored. An empty field, or a 0 in FreeSewing's table, is not measured.
 *
 * FreeSewing has no stature: tape_file.c derives it from the height of the waist. Its `hips` is the high hip and its
 * `seat` the hip. Left out: measures from the high point of the shoulder to the waist (muslin starts at the nape),
 * shoulderToShoulder (across both) and waistToUpperLeg (along the body, where body rise is a height).
 */
#include <stdbool.h>
#include <string.h>

#include "exchange/file_read.h"
#include "exchange/tape_readers.h"

static const struct {
    const char *name;
    int32_t measure;
} model_names[] = {
    {"ankle", MUS_MEASURE_ANKLE},
    {"biceps", MUS_MEASURE_UPPER_ARM},
    {"bustSpan", MUS_MEASURE_BUST_SPAN},
    {"chest", MUS_MEASURE_BUST},
    {"crossSeam", MUS_MEASURE_CROTCH_LENGTH},
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
};

/* a line of the table, split into fields */
struct table_line {
    char **field; /* (count), into the text */
    int32_t count;
    int32_t capacity;
    int64_t line;
};

struct table {
    mus__source *source;
    char *rest; /* text that is not read yet */
    int64_t line;
    struct table_line head;
    struct table_line row;  /* the wanted row */
    struct table_line scan; /* the line that is read now */
    mus__unused *unused;
};


static mus_status table_field(struct table *table, struct table_line *line, char *field)
{
    if (line->count == line->capacity) {
        int32_t grown = line->capacity + line->capacity / 2 + 64;
        char **fields = mus_context_alloc(table->source->context, line->field, (size_t)grown * sizeof *fields);
        if (fields == NULL) return mus__source_fail(table->source, table->line, MUS_ERR_MEMORY, "no memory for a line");
        line->field = fields;
        line->capacity = grown;
    }
    line->field[line->count++] = field;
    return MUS_OK;
}


/* unquote a field in place; returns the text behind it, or NULL when the quotes do not end */
static char *unquote(struct table *table, char *at, char **end)
{
    char *to = at;
    for (at++; *at != '\0'; at++) {
        if (*at == '"' && *++at != '"') {
            *end = to;
            return at;
        }
        if (*at == '\n') table->line++;
        *to++ = *at;
    }
    return NULL;
}


/* split the next line into fields */
static mus_status table_next(struct table *table, struct table_line *line)
{
    line->count = 0;
    line->line = ++table->line;
    char *at = table->rest;
    for (;;) {
        char *field = at, *end;
        if (*at == '"') {
            at = unquote(table, at, &end);
            if (at == NULL || (*at != '\0' && strchr(",\r\n", *at) == NULL))
                return mus__source_fail(table->source, line->line, MUS_ERR_FORMAT,
                                        at == NULL ? "a field whose quotes do not end"
                                                   : "expected a comma behind the quotes of a field");
        } else {
            at += strcspn(at, ",\r\n");
            end = at;
        }
        char stop = *at;
        if (stop == '\r' && at[1] == '\n') at++;
        if (*at != '\0') at++;
        *end = '\0';
        mus_status status = table_field(table, line, field);
        if (status != MUS_OK) return status;
        if (stop != ',') break;
    }
    table->rest = at;
    return MUS_OK;
}


static mus_status table_set(struct table *table, mus_tape *tape, int32_t measure, double value)
{
    if (mus_tape_source(tape, measure) != MUS_SOURCE_NONE)
        return mus__source_fail(table->source, table->head.line, MUS_ERR_FORMAT, "two columns hold the measure %s",
                                mus_measure_name(measure));
    mus_status status = mus_tape_set(tape, measure, value, MUS_SOURCE_GIVEN);
    return status == MUS_OK ? MUS_OK : mus__source_wrap(table->source, table->row.line, status);
}


/* read the number of a field; *set is false when the field is empty */
static mus_status table_number(struct table *table, int32_t column, double *out, bool *set)
{
    const char *text = table->row.field[column];
    *set = text[strspn(text, " \t")] != '\0';
    if (!*set) return MUS_OK;
    const char *wrong = mus__number_read(text, out);
    if (wrong == NULL) return MUS_OK;
    return mus__source_fail(table->source, table->row.line, MUS_ERR_FORMAT, "%.60s: expected a number, \"%.40s\" %s",
                            table->head.field[column], text, wrong);
}


static mus_status read_model(struct table *table, mus_tape *tape)
{
    const char *name = table->row.field[0];
    bool male = strncmp(name, "cisMale", 7) == 0;
    if (!male && strncmp(name, "cisFemale", 9) != 0)
        return mus__source_fail(table->source, table->row.line, MUS_ERR_FORMAT,
                                "expected a model named cisFemale... or cisMale..., got \"%.60s\"", name);
    mus_status status = mus_tape_set_sex(tape, male ? MUS_SEX_MALE : MUS_SEX_FEMALE);

    for (int32_t column = 1; column < table->head.count && status == MUS_OK; column++) {
        size_t i = 0, n = sizeof model_names / sizeof model_names[0];
        while (i < n && strcmp(table->head.field[column], model_names[i].name) != 0) i++;
        if (i == n) {
            mus__unused_add(table->unused, table->head.field[column]);
            continue;
        }
        double value = 0.0;
        bool set;
        status = table_number(table, column, &value, &set);
        if (status != MUS_OK || !set || value == 0.0) continue;
        int32_t measure = model_names[i].measure;
        status =
            table_set(table, tape, measure, mus_measure_unit(measure) == 'm' ? value / 1000.0 : value * MUS__DEGREE);
    }
    return status;
}


static mus_status read_row_sex(struct table *table, const char *text, mus_tape *tape)
{
    int32_t sex = strcmp(text, "female") == 0 || strcmp(text, "F") == 0 ? MUS_SEX_FEMALE
                  : strcmp(text, "male") == 0 || strcmp(text, "M") == 0 ? MUS_SEX_MALE
                  : strcmp(text, "child") == 0                          ? MUS_SEX_CHILD
                                                                        : MUS_SEX_UNSET;
    if (sex == MUS_SEX_UNSET && *text != '\0')
        return mus__source_fail(table->source, table->row.line, MUS_ERR_FORMAT,
                                "sex: expected female, male or child, got \"%.40s\"", text);
    return mus_tape_set_sex(tape, sex);
}


/* split "waist_height_cm" into measure and unit: value = number / down. False: the name does not end with a unit */
static bool column_unit(const char *column, char *measure, size_t bytes, int32_t *unit, double *down)
{
    static const struct {
        const char *ending;
        int32_t unit;
        double down;
    } endings[] = {{"_cm", 'm', 100.0},
                   {"_mm", 'm', 1000.0},
                   {"_m", 'm', 1.0},
                   {"_in", 'm', 1.0 / 0.0254},
                   {"_deg", 'r', 1.0 / MUS__DEGREE},
                   {"_rad", 'r', 1.0}};
    size_t length = strlen(column);
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        size_t n = strlen(endings[i].ending);
        if (length <= n || length - n >= bytes || strcmp(column + length - n, endings[i].ending) != 0) continue;
        memcpy(measure, column, length - n);
        measure[length - n] = '\0';
        *unit = endings[i].unit;
        *down = endings[i].down;
        return true;
    }
    return false;
}


static mus_status read_measures(struct table *table, mus_tape *tape)
{
    mus_status status = MUS_OK;
    for (int32_t column = 1; column < table->head.count && status == MUS_OK; column++) {
        const char *name = table->head.field[column];
        if (strcmp(name, "sex") == 0) {
            status = read_row_sex(table, table->row.field[column], tape);
            continue;
        }
        char plain[64];
        int32_t unit;
        double down;
        if (!column_unit(name, plain, sizeof plain, &unit, &down)) {
            mus__unused_add(table->unused, name);
            continue;
        }
        int32_t measure = mus_measure_find(plain);
        if (measure < 0 || mus_measure_unit(measure) != unit) {
            const char *nearest = mus__measure_nearest(plain);
            return mus__source_fail(
                table->source, table->head.line, MUS_ERR_FORMAT, "unknown measure \"%s\"%s%s%s in a column", plain,
                nearest != NULL ? ", near \"" : "", nearest != NULL ? nearest : "", nearest != NULL ? "\"" : "");
        }
        double value = 0.0;
        bool set;
        status = table_number(table, column, &value, &set);
        if (status == MUS_OK && set) status = table_set(table, tape, measure, value / down);
    }
    return status;
}


/* find the row by its name, which must occur once */
static mus_status table_find(struct table *table, const char *row)
{
    mus__unused names = {.count = 0};
    int64_t found = 0;
    while (*table->rest != '\0') {
        const struct table_line *line = &table->scan;
        mus_status status = table_next(table, &table->scan);
        if (status != MUS_OK) return status;
        if (line->count == 1 && line->field[0][0] == '\0') continue;
        mus__unused_add(&names, line->field[0]);
        if (strcmp(line->field[0], row) != 0) continue;
        if (line->count != table->head.count)
            return mus__source_fail(table->source, line->line, MUS_ERR_FORMAT, "expected %d fields, got %d",
                                    (int)table->head.count, (int)line->count);
        if (found > 0)
            return mus__source_fail(table->source, line->line, MUS_ERR_FORMAT, "row \"%s\" stands in line %lld already",
                                    row, (long long)found);
        found = line->line;
        const struct table_line other = table->row;
        table->row = table->scan;
        table->scan = other;
    }
    if (found > 0) return MUS_OK;
    return mus__source_fail(table->source, 0, MUS_ERR_ARG, "no row \"%.60s\"; there are %.200s%s", row, names.names,
                            names.listed < names.count ? " and more" : "");
}


mus_status mus__tape_read_table(mus__source *source, const char *row, mus_tape *tape, mus__unused *unused)
{
    struct table table = {.source = source, .unused = unused, .rest = source->text};
    mus_status status = MUS_OK;
    if (memchr(source->text, '\0', source->size) != NULL)
        status = mus__source_fail(source, 0, MUS_ERR_FORMAT, "byte %lld: a zero byte, expected text",
                                  (long long)strlen(source->text));
    if (status == MUS_OK) status = table_next(&table, &table.head);
    if (status == MUS_OK && table.head.count < 2)
        status = mus__source_fail(source, 1, MUS_ERR_FORMAT, "expected a line of column names with commas between");
    if (status == MUS_OK) status = table_find(&table, row);
    if (status == MUS_OK)
        status = strcmp(table.head.field[0], "model") == 0 ? read_model(&table, tape) : read_measures(&table, tape);
    if (status == MUS_OK) {
        status = mus_tape_set_name(tape, row);
        if (status != MUS_OK) status = mus__source_wrap(source, 0, status);
    }
    mus_context_alloc(source->context, table.head.field, 0);
    mus_context_alloc(source->context, table.row.field, 0);
    mus_context_alloc(source->context, table.scan.field, 0);
    return status;
}
