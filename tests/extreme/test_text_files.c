/*
 * test_text_files.c: every reader of text on what editors, mail and other programs do to a file: line
 * ends of two bytes and a byte order mark change nothing; a line of a megabyte, a missing end, a decimal comma and a
 * count of 1e9 are refused with the place: the line, or the path of the value in JSON.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/exchange.h"
#include "pattern/same.h"

Suite *mus_suite_text_files(void);

#define MEGABYTE 1000000

/* a good file of each reader, and what the tests change in it: a number, the line that it stands in, a count or index
 * ("" where the form has none) with the place that its refusal names; lines end in \n, @ is where long text goes */
static const struct {
    const char *name;
    const char *row;
    const char *text;
    const char *number, *comma;
    int line;
    const char *count, *place;
} files[] = {
    {"a.tape", NULL, "name Ada\n# bust\nbust 92.5 cm@\nwaist: 760 mm\nheight 66 in\n", "92.5", "92,5", 3, "", ""},
    {"a.yaml", NULL, "body:\n  height: 171.5@\n  bust: 99.75\n  waist: 70.5\n", "171.5", "171,5", 2, "", ""},
    {"a.vit", NULL,
     "<?xml version=\"1.0\"?>\n<vit><version>0.3.3</version><unit>cm</unit><body-measurements>\n"
     "<m name=\"bust_circ\" value=\"92.5@\"/>\n<m name=\"waist_circ\" value=\"70.5\"/>\n</body-measurements></vit>\n",
     "92.5", "92,5", 3, "", ""},
    {"a.csv", "Ada", "who,sex,bust_cm,waist_cm\nBo,male,100,90\nAda,female,92.5@,70.5\n", "92.5", "\"92,5\"", 3, "",
     ""},
    {"a.json", NULL,
     "{\"muslin_pattern\": 1, \"unit\": \"m\", \"name\": \"square\",\n\"panels\": [{\"name\": \"front\", \"grain\": "
     "[0, 1], \"cut\": 1,\n\"placement\": {\"origin\": [0, 1, 0], \"rotation\": [1, 0, 0, 0, 1, 0, 0, 0, 1], \"bend\": "
     "0, \"bend_x\": 0},\n\"outline\": [[0, 1], [1, 1], [2, 1]]}],\n\"points\": [{\"panel\": 0, \"at\": [0, 0]},\n"
     "{\"panel\": 0, \"at\": [1.25@, 0]},\n{\"panel\": 0, \"at\": [1, 1]}],\n\"edges\": [{\"start\": 0, \"end\": 1, "
     "\"pieces\": [{\"kind\": \"line\"}]},\n{\"start\": 1, \"end\": 2, \"pieces\": [{\"kind\": \"line\"}]},\n{"
     "\"start\": 2, \"end\": 0, \"pieces\": [{\"kind\": \"line\"}]}],\n\"seams\": [], \"notches\": [], \"marks\": "
     "[]}\n",
     "1.25", "1,25", 0, "\"start\": 1", "edges[1].start"},
    {"b.json", NULL,
     "{\"pattern\": {\"panels\": {\"front\": {\"translation\": [0, 100, 20], \"rotation\": [0, 90, 0],\n\"vertices\": "
     "[[0, 0], [20.5@, 0], [20, 20]],\n\"edges\": [{\"endpoints\": [0, 1]}, {\"endpoints\": [1, 2]},\n{\"endpoints\": "
     "[2, 0]}]}},\n\"stitches\": []},\n\"properties\": {\"curvature_coords\": \"relative\", \"units_in_meter\": "
     "100}}\n",
     "20.5", "20,5", 0, "[2, 0]", "edges[2].endpoints[0]"},
};


/* `text` with each `from` as `to`, or only the first; the caller frees */
static char *changed(const char *text, const char *from, const char *to, bool all)
{
    size_t count = 0;
    for (const char *p = text; (p = strstr(p, from)) != NULL; p += strlen(from)) count++;
    char *out = malloc(strlen(text) + count * strlen(to) + 1), *at = out;
    const char *rest = text;
    for (const char *p; (p = strstr(rest, from)) != NULL && (all || rest == text); rest = p + strlen(from))
        at += sprintf(at, "%.*s%s", (int)(p - rest), rest, to);
    strcpy(at, rest);
    return out;
}


/* reads `text` as file number `i`, into one of the two */
static mus_status read_text(mus_context *context, int i, const char *text, mus_tape **tape, mus_pattern **pattern)
{
    char path[512];
    char *plain = changed(text, "@", "", true);
    support_spill(support_scratch(files[i].name, path, sizeof path), plain, strlen(plain));
    free(plain);
    *tape = NULL, *pattern = NULL;
    return strstr(files[i].name, ".json") != NULL ? mus_pattern_read(context, path, pattern)
                                                  : mus_tape_read(context, path, files[i].row, tape);
}


/* a changed file says what the good one says, to the bit; takes `text` */
static void reads_the_same(int i, char *text)
{
    mus_context *context = support_context();
    mus_tape *tape[2];
    mus_pattern *pattern[2];
    ck_assert_int_eq(read_text(context, i, files[i].text, &tape[0], &pattern[0]), MUS_OK);
    const mus_status status = read_text(context, i, text, &tape[1], &pattern[1]);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    if (pattern[0] != NULL) same_pattern(pattern[0], pattern[1]);
    for (int32_t m = 0; tape[0] != NULL && m < MUS_MEASURE_COUNT; m++) {
        const double value[2] = {mus_tape_value(tape[0], m), mus_tape_value(tape[1], m)};
        ck_assert(value[0] == value[1] || (value[0] != value[0] && value[1] != value[1]));
    }
    for (int k = 0; k < 2; k++) {
        mus_tape_destroy(tape[k]);
        mus_pattern_destroy(pattern[k]);
    }
    support_context_end(context);
    free(text);
}


/* a changed file is refused as one of a wrong form, and the message holds `place`; takes `text` */
static void is_refused(int i, char *text, const char *place)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_pattern *pattern;
    const mus_status status = read_text(context, i, text, &tape, &pattern);
    ck_assert_msg(status == MUS_ERR_FORMAT || status == MUS_ERR_TAPE || status == MUS_ERR_UNSUPPORTED, "%s: status %d",
                  files[i].name, (int)status);
    ck_assert(tape == NULL && pattern == NULL);
    ck_assert_msg(strstr(mus_context_error(context), place) != NULL, "\"%s\" has no \"%s\"", mus_context_error(context),
                  place);
    support_context_end(context);
    free(text);
}


/* "a.tape:3:", or the name alone where the form counts no lines of values */
static const char *place_of(int i, int line, char *buffer, size_t size)
{
    snprintf(buffer, size, line > 0 ? "%s:%d:" : "%s:", files[i].name, line);
    return buffer;
}


START_TEST(line_ends_of_two_bytes_change_nothing)
{
    reads_the_same(_i, changed(files[_i].text, "\n", "\r\n", true));
}
END_TEST


START_TEST(a_byte_order_mark_changes_nothing)
{
    char *text = malloc(strlen(files[_i].text) + 4);
    sprintf(text, "\xef\xbb\xbf%s", files[_i].text);
    reads_the_same(_i, text);
}
END_TEST


START_TEST(a_decimal_comma_is_read_in_a_tape_and_refused_in_json)
{
    char place[64];
    char *text = changed(files[_i].text, files[_i].number, files[_i].comma, false);
    if (strstr(files[_i].name, ".json") == NULL)
        reads_the_same(_i, text);
    else
        is_refused(_i, text, place_of(_i, files[_i].line, place, sizeof place));
}
END_TEST


/* a number of a million digits, and the same of letters */
START_TEST(a_line_of_a_megabyte_is_refused_with_its_line)
{
    char place[64];
    for (int k = 0; k < 2; k++) {
        char *more = malloc(MEGABYTE + 1);
        memset(more, k ? 'x' : '7', MEGABYTE);
        more[MEGABYTE] = '\0';
        is_refused(_i, changed(files[_i].text, k ? "@" : files[_i].number, more, false),
                   place_of(_i, files[_i].line, place, sizeof place));
        free(more);
    }
}
END_TEST


/* the last number without its last digits and all behind it; a form of lines may be whole without its last lines
 */
START_TEST(a_missing_end_is_refused_with_its_line)
{
    const char *cut = strchr(files[_i].text, '@');
    char place[64], *text = malloc(strlen(files[_i].text) + 1);
    sprintf(text, "%.*s", (int)(cut - files[_i].text), files[_i].text);
    const bool lines = strcmp(files[_i].name, "a.tape") == 0 || strcmp(files[_i].name, "a.yaml") == 0;
    if (lines) text[strlen(text) - strlen(files[_i].number)] = '\0'; /* a measure without its value */
    int line = 1;
    for (const char *p = text; *p != '\0'; p++) line += *p == '\n';
    is_refused(_i, text, place_of(_i, line, place, sizeof place));
}
END_TEST


START_TEST(a_count_of_1e9_is_refused_with_its_place)
{
    if (files[_i].count[0] == '\0') return;
    char huge[64];
    snprintf(huge, sizeof huge, "%s", files[_i].count);
    char *digit = huge + strcspn(huge, "0123456789");
    char rest[64];
    snprintf(rest, sizeof rest, "%s", digit + 1);
    snprintf(digit, sizeof huge - (size_t)(digit - huge), "1000000000%s", rest);
    is_refused(_i, changed(files[_i].text, files[_i].count, huge, false), files[_i].place);
}
END_TEST


Suite *mus_suite_text_files(void)
{
    Suite *suite = suite_create("text_files");
    TCase *tests = tcase_create("text_files");
    const int n = sizeof files / sizeof *files;
    tcase_add_loop_test(tests, line_ends_of_two_bytes_change_nothing, 0, n);
    tcase_add_loop_test(tests, a_byte_order_mark_changes_nothing, 0, n);
    tcase_add_loop_test(tests, a_decimal_comma_is_read_in_a_tape_and_refused_in_json, 0, n);
    tcase_add_loop_test(tests, a_line_of_a_megabyte_is_refused_with_its_line, 0, n);
    tcase_add_loop_test(tests, a_missing_end_is_refused_with_its_line, 0, n);
    tcase_add_loop_test(tests, a_count_of_1e9_is_refused_with_its_place, 0, n);
    suite_add_tcase(suite, tests);
    return suite;
}
