/*
 * tape_file.c: mus_tape_read and mus_tape_write, and muslin's own text form of a tape: one measure with its unit on
 * each line.
 *
 *     # anything after the number sign is a remark
 *     name   Ada
 *     sex    female
 *     size   W40          fills the tape with a table size; lines below it overrule single measures
 *     bust   92 cm
 *     shoulder slope: 22 deg
 *     height 5 ft 5 1/2 in
 *
 * Units: mm, cm, m, in, ft for lengths; deg, rad for angles. An unknown line is an error that names its number: a
 * measure skipped in silence would be derived from others, and the garment would not fit. See muslin_tape(5).
 */
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exchange/file_read.h"
#include "exchange/tape_readers.h"
#include "file/sink.h"

#define KEY_BYTES 64 /* [bytes] of a key with its zero byte; chosen: far above the longest name of a measure */

/* value [m or rad] = number * up / down: the division makes 92 cm the double nearest to 0.92 */
static const struct {
    const char *name;
    int32_t unit;
    double up;
    double down;
} tape_units[] = {
    {"m", 'm', 1.0, 1.0},         {"cm", 'm', 1.0, 100.0}, {"mm", 'm', 1.0, 1000.0},
    {"in", 'm', 254.0, 10000.0},  {"rad", 'r', 1.0, 1.0},  {"deg", 'r', 3.14159265358979323846, 180.0},
    {"ft", 'm', 3048.0, 10000.0},
};
#define UNIT_INCH 3
#define UNIT_FOOT 6
#define UNIT_COUNT 7

/* other ways to write a unit */
static const struct {
    const char *name;
    int unit;
} tape_unit_names[] = {
    {"inch", UNIT_INCH}, {"inches", UNIT_INCH}, {"\"", UNIT_INCH}, {"″", UNIT_INCH}, {"''", UNIT_INCH},
    {"foot", UNIT_FOOT}, {"feet", UNIT_FOOT},   {"'", UNIT_FOOT},  {"′", UNIT_FOOT},
};

/* state while a tape in text form is read */
struct tape_text {
    mus__source *source;
    mus_tape *tape;
    int64_t line;
    char name[KEY_BYTES];
    int32_t sex;
    bool named, sexed, sized, measured;
    int64_t seen[MUS_MEASURE_COUNT]; /* line that set the measure; 0: none */
};


static char *trim(char *text)
{
    text += strspn(text, " \t\r");
    size_t length = strlen(text);
    while (length > 0 && strchr(" \t\r", text[length - 1]) != NULL) text[--length] = '\0';
    return text;
}


/* normalise a key: "High Bust" and "high-bust" become high_bust */
static void plain_key(const char *text, size_t length, char *key)
{
    size_t n = 0;
    for (size_t i = 0; i < length && n + 1 < KEY_BYTES; i++) {
        unsigned char byte = (unsigned char)text[i];
        bool gap = byte == ' ' || byte == '\t' || byte == '-';
        if (gap && (n == 0 || key[n - 1] == '_')) continue;
        key[n++] = gap ? '_' : (char)tolower(byte);
    }
    while (n > 0 && key[n - 1] == '_') n--;
    key[n] = '\0';
}


/* split a line into key and value: at ":" or "=", else before the first word that starts like a number, else behind
 * the first word; returns the value */
static char *split_key(char *line, char *key)
{
    size_t first = strcspn(line, " \t:=");
    plain_key(line, first, key);
    bool keyword = strcmp(key, "name") == 0 || strcmp(key, "sex") == 0 || strcmp(key, "size") == 0;
    size_t at = keyword ? first : strcspn(line, ":=");
    if (!keyword && line[at] == '\0') {
        for (at = first; line[at] != '\0'; at++)
            if (strchr(" \t", line[at - 1]) != NULL && strchr("+-.0123456789", line[at]) != NULL) break;
        if (line[at] == '\0') at = first;
    }
    plain_key(line, at, key);
    at += strspn(line + at, " \t");
    if (line[at] == ':' || line[at] == '=') at++;
    return trim(line + at);
}


/* the unit at the start of a text, which ends before a digit or a blank, with its length [bytes]; UNIT_COUNT when it is
 * no unit of the measure */
static int read_unit(const char *text, int32_t measure, size_t *length)
{
    int unit = 0;
    *length = strcspn(text, " \t+-.0123456789");
    while (unit < UNIT_COUNT &&
           (strlen(tape_units[unit].name) != *length || strncmp(text, tape_units[unit].name, *length) != 0))
        unit++;
    for (size_t i = 0; i < sizeof tape_unit_names / sizeof *tape_unit_names; i++)
        if (strlen(tape_unit_names[i].name) == *length && strncmp(text, tape_unit_names[i].name, *length) == 0)
            unit = tape_unit_names[i].unit;
    return unit < UNIT_COUNT && tape_units[unit].unit == mus_measure_unit(measure) ? unit : UNIT_COUNT;
}


/* read number and unit, "92 cm" or "5 ft 5 1/2 in" [m or rad]; *end: the text behind them */
static mus_status read_amount(struct tape_text *text, int32_t measure, const char *key, const char *value,
                              double *amount, const char **end)
{
    const char *at = value, *const wanted = mus_measure_unit(measure) == 'm' ? "mm, cm, m, in or ft" : "deg or rad";
    int before = UNIT_COUNT, unit = UNIT_COUNT;
    *amount = 0.0;
    do {
        double x = 0.0;
        size_t digits = 0, length;
        const char *wrong = mus__amount_read(at, &x, &digits);
        if (wrong != NULL)
            return mus__source_fail(text->source, text->line, MUS_ERR_FORMAT, "%s: expected a number, \"%.40s\" %s",
                                    key, at, wrong);
        const char *behind = at + digits + strspn(at + digits, " \t");
        unit = read_unit(behind, measure, &length);
        if (unit == UNIT_COUNT || (before == UNIT_FOOT && unit != UNIT_INCH))
            return mus__source_fail(text->source, text->line, MUS_ERR_FORMAT,
                                    "%s: expected a unit (%s) behind %.*s, got \"%.*s\"", key,
                                    before == UNIT_FOOT ? "in" : wanted, (int)digits, at, (int)length, behind);
        *amount += x * tape_units[unit].up / tape_units[unit].down;
        at = behind + length + strspn(behind + length, " \t");
        if (before == UNIT_FOOT) break;
        before = unit;
    } while (unit == UNIT_FOOT && *at >= '0' && *at <= '9');
    *end = at;
    return MUS_OK;
}


/* read number, unit and, for a derived measure, the word "derived" */
static mus_status read_measure(struct tape_text *text, int32_t measure, const char *key, const char *value)
{
    double amount;
    const char *rest = "";
    mus_status status = read_amount(text, measure, key, value, &amount, &rest);
    if (status != MUS_OK) return status;
    const bool derived = strcmp(rest, "derived") == 0;
    if (*rest != '\0' && !derived)
        return mus__source_fail(text->source, text->line, MUS_ERR_FORMAT, "%s: unexpected \"%.40s\" behind the unit",
                                key, rest);
    status = mus_tape_set(text->tape, measure, amount, derived ? MUS_SOURCE_DERIVED : MUS_SOURCE_GIVEN);
    return status == MUS_OK ? MUS_OK : mus__source_wrap(text->source, text->line, status);
}


static mus_status read_sex(struct tape_text *text, const char *value)
{
    static const struct {
        const char *name;
        int32_t sex;
    } sexes[] = {{"female", MUS_SEX_FEMALE}, {"male", MUS_SEX_MALE}, {"child", MUS_SEX_CHILD}};
    for (size_t i = 0; i < sizeof sexes / sizeof sexes[0]; i++) {
        if (strcmp(value, sexes[i].name) != 0) continue;
        text->sex = sexes[i].sex;
        if (text->sized && mus_tape_sex(text->tape) != text->sex)
            return mus__source_fail(text->source, text->line, MUS_ERR_FORMAT, "sex %s is not that of the size above",
                                    value);
        return MUS_OK;
    }
    return mus__source_fail(text->source, text->line, MUS_ERR_FORMAT, "sex: expected female, male or child, got \"%s\"",
                            value);
}


static mus_status read_size(struct tape_text *text, const char *value)
{
    if (text->measured || text->sexed)
        return mus__source_fail(text->source, text->line, MUS_ERR_FORMAT,
                                "size: expected above the measures and in place of sex, as it sets them all");
    mus_status status = mus_tape_set_size(text->tape, value);
    return status == MUS_OK ? MUS_OK : mus__source_wrap(text->source, text->line, status);
}


/* read a line name, sex or size; *known is false for any other key */
static mus_status read_keyword(struct tape_text *text, const char *key, const char *value, bool *known)
{
    bool *once = strcmp(key, "name") == 0   ? &text->named
                 : strcmp(key, "sex") == 0  ? &text->sexed
                 : strcmp(key, "size") == 0 ? &text->sized
                                            : NULL;
    *known = once != NULL;
    if (once == NULL) return MUS_OK;
    if (*once) return mus__source_fail(text->source, text->line, MUS_ERR_FORMAT, "%s: given a second time", key);

    mus_status status = MUS_OK;
    if (once == &text->sexed) {
        status = read_sex(text, value);
    } else if (once == &text->sized) {
        status = read_size(text, value);
    } else if (strlen(value) >= sizeof text->name) {
        status = mus__source_fail(text->source, text->line, MUS_ERR_FORMAT, "name: %zu bytes, the limit is %d",
                                  strlen(value), KEY_BYTES - 1);
    } else {
        snprintf(text->name, sizeof text->name, "%s", value);
    }
    *once = true;
    return status;
}


static mus_status read_line(struct tape_text *text, char *line)
{
    const mus__source *source = text->source;
    line = trim(line);
    if (*line == '\0' || *line == '#') return MUS_OK;
    if (line[mus__utf8_span(line)] != '\0')
        return mus__source_fail(source, text->line, MUS_ERR_FORMAT, "expected UTF-8 text");

    /* a number sign starts a remark, except in a name */
    char key[KEY_BYTES];
    char *value = split_key(line, key);
    if (strcmp(key, "name") != 0) {
        line[strcspn(line, "#")] = '\0';
        value = split_key(trim(line), key);
    }
    bool keyword;
    mus_status status = read_keyword(text, key, value, &keyword);
    if (keyword) return status;

    int32_t measure = mus_measure_find(key);
    if (measure < 0) {
        const char *nearest = mus__measure_nearest(key);
        if (nearest != NULL)
            return mus__source_fail(source, text->line, MUS_ERR_FORMAT, "unknown measure \"%s\"; did you mean \"%s\"?",
                                    key, nearest);
        return mus__source_fail(source, text->line, MUS_ERR_FORMAT,
                                "unknown measure \"%s\"; expected a line such as \"bust 92 cm\"", key);
    }
    if (text->seen[measure] > 0)
        return mus__source_fail(source, text->line, MUS_ERR_FORMAT, "%s: given in line %lld already",
                                mus_measure_name(measure), (long long)text->seen[measure]);
    text->seen[measure] = text->line;
    text->measured = true;
    return read_measure(text, measure, mus_measure_name(measure), value);
}


static mus_status tape_read_text(mus__source *source, mus_tape *tape)
{
    struct tape_text text = {.source = source, .tape = tape};
    const char *zero = memchr(source->text, '\0', source->size);
    if (zero != NULL)
        return mus__source_fail(source, 0, MUS_ERR_FORMAT, "byte %lld: a zero byte, expected text",
                                (long long)(zero - source->text));

    for (char *line = source->text, *next; line != NULL; line = next) {
        next = strchr(line, '\n');
        if (next != NULL) *next++ = '\0';
        text.line++;
        mus_status status = read_line(&text, line);
        if (status != MUS_OK) return status;
    }

    /* set name and sex last, since a size overwrites them */
    mus_status status = text.sexed ? mus_tape_set_sex(tape, text.sex) : MUS_OK;
    if (status == MUS_OK && text.named) status = mus_tape_set_name(tape, text.name);
    return status == MUS_OK ? MUS_OK : mus__source_wrap(source, 0, status);
}


/* letter of a form, by the ending of the name; 0 for an unknown ending */
static int tape_form(const char *path)
{
    static const struct {
        const char *ending;
        int form;
    } forms[] = {{".tape", 't'}, {".txt", 't'}, {".yaml", 'y'}, {".yml", 'y'}, {".vit", 'v'}, {".csv", 'c'}};
    const char *ending = strrchr(path, '.');
    for (size_t i = 0; ending != NULL && i < sizeof forms / sizeof forms[0]; i++) {
        size_t n = 0;
        while (ending[n] != '\0' && tolower((unsigned char)ending[n]) == forms[i].ending[n]) n++;
        if (ending[n] == '\0' && forms[i].ending[n] == '\0') return forms[i].form;
    }
    return 0;
}


/* derive the stature of a tape without one from the height of the nape or of the waist, where one is given */
static mus_status tape_stature(mus_tape *tape)
{
    /* height over stature, unset sex: women, men. The nape's ratio is the mean of ANSUR II (Gordon and others 2014),
     * with a deviation of 0.7 %; the waist's is that of clothing size tables, with 0.675 stature - 7.5 cm for children
     */
    static const double nape[] = {0.861, 0.857, 0.864}, waist[] = {0.6185, 0.622, 0.615};
    const int32_t sex = mus_tape_sex(tape);
    const bool child = sex == MUS_SEX_CHILD;
    const double high = mus_tape_value(tape, MUS_MEASURE_NAPE_HEIGHT);
    const double low = mus_tape_value(tape, MUS_MEASURE_WAIST_HEIGHT);
    if (mus_tape_source(tape, MUS_MEASURE_STATURE) != MUS_SOURCE_NONE) return MUS_OK;
    const double stature = child ? (low + 0.075) / 0.675 : high == high ? high / nape[sex] : low / waist[sex];
    return stature == stature ? mus_tape_set(tape, MUS_MEASURE_STATURE, stature, MUS_SOURCE_DERIVED) : MUS_OK;
}


static mus_status read_form(mus__source *source, const char *row, int form, mus_tape *tape)
{
    /* a tape without a name of its own gets that of its file */
    static const char *const endings[] = {".tape", ".txt", ".yaml", ".yml", ".vit", NULL};
    char name[KEY_BYTES];
    mus__source_base(source->path, endings, name, sizeof name);

    mus__unused unused = {.count = 0};
    mus_status status;
    if (form == 't')
        status = tape_read_text(source, tape);
    else if (form == 'y')
        status = mus__tape_read_yaml(source, tape, &unused);
    else if (form == 'v')
        status = mus__tape_read_vit(source, tape, &unused);
    else
        status = mus__tape_read_table(source, row, tape, &unused);

    /* a file in a form of another program, none of whose names is known, is not an empty tape */
    bool empty = form != 't';
    for (int32_t m = 0; m < mus_measure_count(); m++) empty = empty && mus_tape_source(tape, m) == MUS_SOURCE_NONE;
    if (status == MUS_OK && empty) return mus__unused_fail(&unused, source);
    if (status == MUS_OK && (form == 'v' || form == 'c')) {
        status = tape_stature(tape);
        if (status != MUS_OK) return mus__source_wrap(source, 0, status);
    }
    if (status == MUS_OK) mus__unused_log(&unused, source);
    if (status == MUS_OK && mus_tape_name(tape)[0] == '\0') status = mus_tape_set_name(tape, name);
    return status;
}


static mus_status tape_load(mus_context *context, const mus__input *input, const char *row, mus_tape **out,
                            const char *what)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__input_check(context, input, out, what);
    if (status != MUS_OK) return status;
    const char *path = input->path;
    const int form = tape_form(path);
    if (form == 0)
        return mus__file_fail(context, MUS_ERR_FORMAT,
                              "%.300s: unknown form of tape; expected .tape, .txt, .yaml, .yml, .vit or .csv", path);
    if ((form == 'c') != (row != NULL))
        return mus__file_fail(
            context, MUS_ERR_ARG,
            form == 'c' ? "%.300s: a table needs the name of a row" : "%.300s: has no rows; only a .csv has", path);
    mus__source source;
    mus_tape *tape = NULL;
    status = mus__source_open(context, input, &source);
    if (status == MUS_OK) status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = read_form(&source, row, form, tape);
    mus__source_close(&source);
    if (status == MUS_OK) *out = tape;
    else mus_tape_destroy(tape);
    return status;
}


mus_status mus_tape_read(mus_context *context, const char *path, const char *row, mus_tape **out)
{
    return tape_load(context, &(mus__input){path, NULL, 0}, row, out, "mus_tape_read");
}


mus_status mus_tape_read_from(mus_context *context, const char *text, size_t size, const char *name, const char *row,
                              mus_tape **out)
{
    return tape_load(context, &(mus__input){name, text != NULL ? text : "", size}, row, out, "mus_tape_read_from");
}


/* write a value in the unit that needs the fewest digits to be read back exactly; cm or deg on equality. A remark has 6
 * digits */
static void write_value(mus__sink *sink, int32_t measure, double value, bool remark)
{
    static const int32_t order[] = {1, 2, 0, 5, 4};
    const int32_t *units = mus_measure_unit(measure) == 'm' ? order : order + 3;
    int32_t n = mus_measure_unit(measure) == 'm' ? 3 : 2;
    char text[40];
    for (int digits = 6; digits <= 17; digits++)
        for (int32_t k = 0; k < n; k++) {
            double up = tape_units[units[k]].up, down = tape_units[units[k]].down;
            snprintf(text, sizeof text, "%.*g", digits, value * down / up);
            if (!remark && strtod(text, NULL) * up / down != value) continue;
            mus__sink_print(sink, "%s %s", text, tape_units[units[k]].name);
            return;
        }
}


/* write a name on one line; control characters become blanks */
static void write_name(mus__sink *sink, const char *name)
{
    mus__sink_print(sink, "name ");
    for (; *name != '\0'; name++) mus__sink_add(sink, (unsigned char)*name < 0x20 ? " " : name, 1);
    mus__sink_print(sink, "\n");
}


static mus_status tape_save(const mus_tape *tape, const mus__target *target, const char *what)
{
    if (tape == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_tape_context(tape);
    mus_status status = mus__target_check(context, target, what);
    if (status != MUS_OK) return status;
    mus__locale locale;
    status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;

    static const char *const sexes[] = {NULL, "female", "male", "child"};
    mus__sink sink;
    mus__sink_init(&sink, context);
    mus__sink_print(&sink, "# muslin tape\n");
    if (mus_tape_name(tape)[0] != '\0') write_name(&sink, mus_tape_name(tape));
    if (mus_tape_sex(tape) != MUS_SEX_UNSET) mus__sink_print(&sink, "sex %s\n", sexes[mus_tape_sex(tape)]);

    /* derived measures are remarks; the four that completion does not derive are lines even when another measure gave
     * them */
    for (int32_t i = 0; i < mus_measure_count(); i++) {
        int32_t from = mus_tape_source(tape, i);
        if (from == MUS_SOURCE_NONE) continue;
        bool derived = from == MUS_SOURCE_DERIVED;
        bool needed =
            i == MUS_MEASURE_STATURE || i == MUS_MEASURE_BUST || i == MUS_MEASURE_WAIST || i == MUS_MEASURE_HIP;
        bool remark = derived && !needed;
        mus__sink_print(&sink, "%s%s ", remark ? "# " : "", mus_measure_name(i));
        write_value(&sink, i, mus_tape_value(tape, i), remark);
        mus__sink_print(&sink, "%s\n", derived ? " derived" : "");
    }
    status = mus__sink_give(&sink, target);
    mus__sink_free(&sink);
    mus__locale_leave(&locale);
    return status;
}


mus_status mus_tape_write(const mus_tape *tape, const char *path)
{
    return tape_save(tape, &(mus__target){path, NULL, NULL}, "mus_tape_write");
}


mus_status mus_tape_write_bytes(const mus_tape *tape, char **bytes, size_t *size)
{
    return tape_save(tape, &(mus__target){NULL, bytes, size}, "mus_tape_write_bytes");
}
