/*
 * readings.c: rows "read/...": tapes, patterns and fabrics read from files, written, and read and written again; and
 * "ports/figures", the output of tests/study/ports/figures.c.
 */
#include "same.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- tapes ---- */

/* the measures of a tape, and those of the file that is written of it */
static void digest_tape(same_run *run, mus_tape *tape)
{
    mus_tape *again = NULL;
    same_text(run, mus_tape_name(tape));
    same_int(run, mus_tape_sex(tape));
    for (int32_t turn = 0; turn < 2; turn++) {
        for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
            same_real(run, mus_tape_value(tape, m));
            same_int(run, mus_tape_source(tape, m));
        }
        if (turn == 0 && !same_status(run, mus_tape_complete(tape))) return;
    }
    same_int(run, mus_tape_warning_count(tape));
    same_must(run, mus_tape_write(tape, "written.tape"), "mus_tape_write");
    same_must(run, mus_tape_read(run->context, "written.tape", NULL, &again), "mus_tape_read");
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) same_real(run, mus_tape_value(again, m));
    mus_tape_destroy(again);
}


static void make_source_tape(same_run *run, const void *what, int32_t index)
{
    (void)index;
    mus_tape *tape = NULL;
    same_must(run, mus_tape_read(run->context, same_source(run, what), NULL, &tape), what);
    digest_tape(run, tape);
}


/* what: the file; a '#' before the row of a table */
static void make_tape(same_run *run, const void *what, int32_t index)
{
    (void)index;
    char file[128];
    mus_tape *tape = NULL;
    snprintf(file, sizeof file, "%s", (const char *)what);
    char *row = strchr(file, '#');
    if (row != NULL) *row++ = '\0';
    if (same_status(run, mus_tape_read(run->context, same_data(run, file), row, &tape))) digest_tape(run, tape);
}


static const char *const tape_files[] = {
    "garmentcode/bodies/mean_all.yaml",
    "garmentcode/bodies/mean_female.yaml",
    "garmentcode/bodies/m_smpl_average_A40.yaml",
    "valentina/measurements/person_01.vit",
    "valentina/measurements/person_03.vit",
    "valentina/measurements/person_05.vit",
    "valentina/measurements/person_07.vit",
    "valentina/measurements/person_09.vit",
    "valentina/measurements/person_11.vit",
    "valentina/measurements/person_13.vit",
    "valentina/measurements/person_15.vit",
    "valentina/measurements/person_17.vit",
    "valentina/measurements/person_19.vit",
    "valentina/measurements/person_21.vit",
    "valentina/measurements/person_23.vit",
    "valentina/measurements/gost_man_440_1640.vit",
    "valentina/measurements/gost_man_500_1760.vit",
    "valentina/measurements/gost_man_560_1880.vit",
    "freesewing/models.csv#cisFemaleAdult30",
    "freesewing/models.csv#cisFemaleAdult36",
    "freesewing/models.csv#cisFemaleAdult44",
    "freesewing/models.csv#cisMaleAdult34",
    "freesewing/models.csv#cisMaleAdult48",
    "freesewing/models.csv#cisMaleGiant150",
    "freesewing/models.csv#cisFemaleDoll30",
    "anthropometry/ansur2_garment_cm.csv#M0000",
};

/* ---- patterns ---- */

/* read; written as muslin JSON; that read and written again; checked */
static void make_pattern(same_run *run, const void *what, int32_t index)
{
    (void)index;
    mus_pattern *pattern = NULL, *again = NULL;
    mus_faults *faults = NULL;
    int32_t count = 0;
    if (!same_status(run, mus_pattern_read(run->context, same_data(run, what), &pattern))) return;
    same_pattern(run, pattern);
    same_must(run, mus_pattern_read(run->context, "pattern.json", &again), "pattern.json");
    same_pattern(run, again);
    same_must(run, mus_pattern_check(pattern, &count, &faults), "mus_pattern_check");
    for (int32_t i = 0; i < count; i++) {
        int32_t kind, panel, edge, seam;
        same_must(run, mus_faults_item(faults, i, &kind, &panel, &edge, &seam), "mus_faults_item");
        const int32_t fault[4] = {kind, panel, edge, seam};
        same_ints(run, fault, 4);
    }
    mus_faults_destroy(faults);
}


static const char *const pattern_files[] = {
    "garmentcode/specs/d11_000_mean_all_specification.json",
    "garmentcode/specs/d11_006_mean_all_specification.json",
    "garmentcode/specs/d11_009_m_smpl_average_A40_specification.json",
    "garmentcode/specs/d11_019_m_smpl_average_A40_specification.json",
    "garmentcode/specs/d11_033_mean_female_specification.json",
    "garmentcode/specs/d11_039_m_smpl_average_A40_specification.json",
    "garmentcode/specs/d11_043_mean_female_specification.json",
    "garmentcode/originals/dress_pencil_specification.json",
    "garmentcode/originals/shirt_mean_specification.json",
    "freesewing/aaron_cisFemaleAdult36.json",
    "freesewing/bella_cisFemaleAdult36.json",
    "freesewing/brian_cisMaleAdult40.json",
    "freesewing/florence_cisFemaleAdult30.json",
    "freesewing/paco_cisMaleAdult48.json",
    "freesewing/penelope_cisFemaleAdult44.json",
    "freesewing/teagan_cisMaleGiant150.json",
    "freesewing/teagan_cisMaleAdult40.json",
    "freesewing/bella_cisFemaleDoll30.json",
};

/* ---- fabrics ---- */

static void digest_fabric(same_run *run, const mus_fabric *fabric)
{
    for (int32_t v = 0; v < mus_fabric_value_count(); v++) {
        double value = 0.0;
        same_must(run, mus_fabric_get(fabric, v, &value), "mus_fabric_get");
        same_text(run, mus_fabric_value_key(v));
        same_real(run, value);
    }
}


static void make_fabrics(same_run *run, const void *what, int32_t index)
{
    (void)what, (void)index;
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    same_must(run, mus_fabric_load(run->context, same_source(run, "examples/fabrics/denim.json"), &fabric), "denim");
    digest_fabric(run, &fabric);
    for (int32_t f = 0; f < mus_fabric_count(); f++) {
        same_text(run, mus_fabric_name(f));
        same_must(run, mus_fabric_find(mus_fabric_name(f), &fabric), "mus_fabric_find");
        digest_fabric(run, &fabric);
        same_must(run, mus_fabric_save(run->context, &fabric, mus_fabric_name(f), NULL, "fabric.json"), "save");
        same_must(run, mus_fabric_load(run->context, "fabric.json", &fabric), "mus_fabric_load");
        digest_fabric(run, &fabric);
    }
}


/* ---- figures of the ports ---- */

static void make_figures(same_run *run, const void *what, int32_t index)
{
    (void)what, (void)index;
    char line[512];
    snprintf(line, sizeof line, "'%.400s' >figures.txt", run->figures);
    if (system(line) != 0) same_must(run, MUS_ERR_FILE, run->figures);
    same_file(run, "figures.txt");
}


/* a row for a file: its name without folders is that of the row */
static void add_file(same_list *list, const char *file, void (*make)(same_run *, const void *, int32_t))
{
    const char *slash = strrchr(file, '/');
    same_row *row = same_add(list, make, "read/%s", slash + 1);
    row->what = file;
    row->data = true;
}


void same_readings(same_list *list)
{
    static const char *const sources[] = {"examples/tapes/w40.tape", "examples/tapes/m50.tape",
                                          "examples/tapes/child116.tape"};
    for (size_t i = 0; i < sizeof sources / sizeof *sources; i++) {
        add_file(list, sources[i], make_source_tape);
        list->row[list->count - 1].data = false;
    }
    for (size_t i = 0; i < sizeof tape_files / sizeof *tape_files; i++) add_file(list, tape_files[i], make_tape);
    for (size_t i = 0; i < sizeof pattern_files / sizeof *pattern_files; i++)
        add_file(list, pattern_files[i], make_pattern);
    same_add(list, make_fabrics, "read/fabrics");
    same_add(list, make_figures, "ports/figures");
}
