/*
 * test_damaged.c: every reader on damaged files: a good one cut at many bytes, and with bytes changed. Whatever is in
 * the file, the reader ends with a status and a sentence or with an object, and gives all its memory back.
 */
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/topology.h"
#include "support.h"
#include "trade/dxf_texts.h"

#define ROUNDS 300 /* of each kind of damage and reader: below two seconds under the sanitizers */

static const char tape_text[] =
    "# Ada\nname Ada\nsex female\nbust 92 cm\nwaist: 760 mm\nhip 1.0 m # seat\nheight 66 in\n"
    "shoulder_slope 22 deg\narm_angle 0.75 rad\n";
static const char yaml_text[] = "body:\n  height: 171.99\n  head_l: 26.3262\n  bust: 99.8407\n  hips: 103.478\n"
                                "  waist_line: 36.8913 # nape\n  hips_line: 23.4837\n  back_width: \"47\"\n";
static const char vit_text[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<vit><version>0.3.3</version><unit>cm</unit>\n"
    "<personal><gender>female</gender></personal><body-measurements>\n<m name=\"bust_circ\" value=\"92.5\"/>\n"
    "<m name=\"waist_circ\" value=\" 76&#10;\"/><m name=\"@skirt\" value=\"@a+2\"/></body-measurements></vit>\n";
static const char table_text[] = "who,sex,bust_cm,\"waist_mm\",notes\r\nBo,male,100,900,\r\n"
                                 "Ada,female,92.5,760,\"likes \"\"red\"\", not\nblue\"\r\n";
static const char json_text[] =
    "{\"muslin_pattern\": 1, \"unit\": \"m\", \"name\": \"square\",\n\"panels\": [{\"name\": \"front\", \"grain\": [0, "
    "1], "
    "\"cut\": 1,\n\"placement\": {\"origin\": [0, 1, 0], \"rotation\": [1, 0, 0, 0, 1, 0, 0, 0, 1], \"bend\": 0, "
    "\"bend_x\": 0},\n\"outline\": [[0, 1], [1, 1], [2, 1]]}],\n\"points\": [{\"panel\": 0, \"at\": [0, 0]}, "
    "{\"panel\": 0, "
    "\"at\": [1, 0]}, {\"panel\": 0, \"at\": [1, 1]}],\n\"edges\": [{\"start\": 0, \"end\": 1, \"pieces\": [{\"kind\": "
    "\"line\", \"end\": [0.5, 0]}, {\"kind\": \"arc\", \"controls\": [[0.75, 0.1]]}]},\n{\"start\": 1, \"end\": 2, "
    "\"pieces\": [{\"kind\": \"cubic\", \"controls\": [[1.1, 0.2], [1.1, 0.8]]}]},\n{\"start\": 2, \"end\": 0, "
    "\"name\": "
    "\"fold\", \"allowance\": 0.01, \"pieces\": [{\"kind\": \"line\"}]}],\n\"seams\": [{\"a\": 1, \"b\": 2, "
    "\"direction\": \"reversed\", \"ease\": 0, \"tolerance\": 0.001}],\n\"notches\": [{\"edge\": 0, \"kind\": 1, "
    "\"s\": "
    "0.5}],\n\"marks\": [{\"panel\": 0, \"name\": \"dart\", \"points\": [[0.5, 0.5]]}]}\n";
static const char spec_text[] =
    "{\"pattern\": {\"panels\": {\"front\": {\"translation\": [0, 100, 20], \"rotation\": [0, 90, 0], \"label\": "
    "\"body\", "
    "\"vertices\": [[0, 0], [20, 0], [20, 20]],\n\"edges\": [{\"endpoints\": [0, 1], \"curvature\": {\"type\": "
    "\"circle\", \"params\": [12, 0, 1]}}, {\"endpoints\": [1, 2], \"curvature\": {\"type\": \"quadratic\", "
    "\"params\": "
    "[[0.5, 0.1]]}, \"label\": \"left_armhole\"}, {\"endpoints\": [2, 0]}]}},\n\"stitches\": [[{\"panel\": \"front\", "
    "\"edge\": 1}, {\"panel\": \"front\", \"edge\": 2}, \"right_wrong\"]]}, \"properties\": {\"curvature_coords\": "
    "\"relative\", \"units_in_meter\": 100}}\n";

static const char fabric_text[] =
    "{\"muslin_fabric\": 1, \"name\": \"gauze\",\n\"weight_kg_per_m2\": {\"value\": 0.05, \"source\": \"scale\"},\n"
    "\"stretch_warp_N_per_m\": {\"value\": 2e3, \"source\": \"a\"}, \"stretch_weft_N_per_m\": {\"value\": 1000, "
    "\"source\": \"b\"},\n\"shear_N_per_m\": {\"source\": \"c\", \"value\": 20},\n\"bend_warp_N_m\": {\"value\": "
    "1e-6, \"source\": \"d\"}, \"bend_weft_N_m\": {\"value\": 1e-6, \"source\": \"\u00e4\"},\n"
    "\"bend_bias_N_m\": {\"value\": 1e-6, \"source\": \"f\"}, \"damping_ratio\": {\"value\": 0.1, \"source\": "
    "\"assumed\"},\n\"friction_coefficient\": {\"value\": 0.3, \"source\": \"assumed\"},\n\"thickness_m\": "
    "{\"value\": 0.0002, \"source\": \"gauge\"}}\n";

enum { READ_TAPE, READ_PATTERN, READ_FABRIC };

/* file name, good text, row of a table, what it is */
static const struct {
    const char *name;
    const char *text;
    const char *row;
    int what;
} readers[] = {
    {"a.tape", tape_text, NULL, READ_TAPE},     {"a.yaml", yaml_text, NULL, READ_TAPE},
    {"a.vit", vit_text, NULL, READ_TAPE},       {"a.csv", table_text, "Ada", READ_TAPE},
    {"a.json", json_text, NULL, READ_PATTERN},  {"b.json", spec_text, NULL, READ_PATTERN},
    {"a.dxf", dxf_gerber, NULL, READ_PATTERN},
    {"f.json", fabric_text, NULL, READ_FABRIC},
};


/* read `size` bytes as the file of a reader; the status */
static mus_status read_bytes(int reader, const char *bytes, size_t size)
{
    char path[512];
    support_spill(support_scratch(readers[reader].name, path, sizeof path), bytes, size);
    mus_context *context = support_context();
    mus_tape *tape = NULL;
    mus_pattern *pattern = NULL;
    const int what = readers[reader].what;
    mus_fabric fabric, before;
    mus_fabric_init(&fabric, sizeof fabric);
    before = fabric;
    mus_status status = what == READ_FABRIC    ? mus_fabric_load(context, path, &fabric)
                        : what == READ_PATTERN ? mus_pattern_read(context, path, &pattern)
                                               : mus_tape_read(context, path, readers[reader].row, &tape);
    if (what == READ_FABRIC)
        ck_assert_int_eq(status == MUS_OK, memcmp(&fabric, &before, sizeof fabric) != 0);
    else if (status == MUS_OK)
        ck_assert(tape != NULL || pattern != NULL);
    if (status != MUS_OK) {
        ck_assert(tape == NULL && pattern == NULL);
        ck_assert_msg(strstr(mus_context_error(context), readers[reader].name) != NULL, "%d: \"%s\"", (int)status,
                      mus_context_error(context));
        ck_assert(status == MUS_ERR_FORMAT || status == MUS_ERR_TAPE || status == MUS_ERR_UNSUPPORTED ||
                  status == MUS_ERR_PATTERN || (status == MUS_ERR_ARG && readers[reader].row != NULL));
    }

    /* a pattern that was accepted can be used and written */
    if (tape != NULL) (void)mus_tape_complete(tape);
    int32_t faults;
    if (pattern != NULL) ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
    if (pattern != NULL) ck_assert_int_eq(mus_pattern_write(pattern, path), MUS_OK);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    support_context_end(context);
    return status;
}


START_TEST(a_file_cut_short_is_refused_or_read)
{
    const char *text = readers[_i].text;
    size_t size = strlen(text);
    ck_assert_int_eq(read_bytes(_i, text, size), MUS_OK);
    int refused = 0, cuts = 0;
    for (size_t cut = 0; cut < size; cut += 1 + size / ROUNDS, cuts++) refused += read_bytes(_i, text, cut) != MUS_OK;

    /* a line form may be whole when its last lines are gone; a document never is */
    if (readers[_i].what != READ_TAPE || text == vit_text) ck_assert_int_ge(refused, cuts - 1);
    ck_assert_int_ge(refused, 1);
}
END_TEST


START_TEST(changed_bytes_are_refused_or_read)
{
    const char *text = readers[_i].text;
    size_t size = strlen(text);
    uint64_t seed = (uint64_t)_i;
    char *bytes = malloc(size);
    static const char wild[] = "\0\xff,-.e0{}[]\"<>&:#\n 9";
    for (int round = 0; round < ROUNDS; round++) {
        memcpy(bytes, text, size);
        for (uint64_t n = 1 + support_random(&seed) % 3; n > 0; n--) {
            size_t at = support_random(&seed) % size;
            if (support_random(&seed) % 2 == 0)
                bytes[at] = wild[support_random(&seed) % (sizeof wild - 1)];
            else
                bytes[at] = (char)(bytes[at] ^ (1 << support_random(&seed) % 8));
        }
        (void)read_bytes(_i, bytes, size);
    }
    free(bytes);
}
END_TEST


START_TEST(pieces_put_together_at_random_are_refused_or_read)
{
    /* a stretch of the file copied over another place: well formed here and there, and long repeats */
    const char *text = readers[_i].text;
    size_t size = strlen(text);
    uint64_t seed = 77 + (uint64_t)_i;
    char *bytes = malloc(2 * size);
    for (int round = 0; round < ROUNDS; round++) {
        size_t from = support_random(&seed) % size, to = support_random(&seed) % size;
        size_t length = support_random(&seed) % (size - from);
        memcpy(bytes, text, to);
        memcpy(bytes + to, text + from, length);
        memcpy(bytes + to + length, text + to, size - to);
        (void)read_bytes(_i, bytes, size + length);
    }
    free(bytes);
}
END_TEST


START_TEST(deep_nesting_ends_with_a_status)
{
    size_t size = 200000;
    char *bytes = malloc(size);
    for (size_t k = 0; k < 4; k++) {
        memset(bytes, "[{<("[k], size);
        ck_assert_int_ne(read_bytes(_i, bytes, size), MUS_OK);
    }
    free(bytes);
}
END_TEST


START_TEST(real_files_cut_short_are_refused)
{
    char path[512];
    if (support_data("garmentcode/originals/shirt_mean_specification.json", path, sizeof path) == NULL) return;
    size_t size;
    char *bytes = support_slurp(path, &size);
    for (int i = 0; i < 40; i++) ck_assert_int_eq(read_bytes(5, bytes, size * (size_t)i / 40), MUS_ERR_FORMAT);
    free(bytes);
}
END_TEST


Suite *mus_suite_damaged(void);

Suite *mus_suite_damaged(void)
{
    Suite *suite = suite_create("damaged");
    TCase *tests = tcase_create("damaged");
    const int n = sizeof readers / sizeof readers[0];
    tcase_set_timeout(tests, 120);
    tcase_add_loop_test(tests, a_file_cut_short_is_refused_or_read, 0, n);
    tcase_add_loop_test(tests, changed_bytes_are_refused_or_read, 0, n);
    tcase_add_loop_test(tests, pieces_put_together_at_random_are_refused_or_read, 0, n);
    tcase_add_loop_test(tests, deep_nesting_ends_with_a_status, 0, n);
    tcase_add_test(tests, real_files_cut_short_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
