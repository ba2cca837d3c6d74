/*
 * ansur.c: the reader of ansur.h. The file is commas and numbers alone: no quotes, one line a person.
 */
#include "ansur.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const ansur_measure ansur_measures[ANSUR_MEASURES] = {
    {MUS_MEASURE_STATURE, "stature", 0.0, 0.0, true},
    {MUS_MEASURE_NAPE_HEIGHT, "cervicale_h", 0.0, 0.0, true},
    {MUS_MEASURE_INLEG, "crotch_h", 0.0, 0.0, true},
    {MUS_MEASURE_BUST, "chest_circ", 0.0, 0.0, false},
    {MUS_MEASURE_WAIST, "waist_circ", -7.0, -1.0, false},
    {MUS_MEASURE_HIP, "hip_circ", 0.0, 0.0, false},
    {MUS_MEASURE_NECK, "neck_base_circ", 0.0, 0.0, false},
    {MUS_MEASURE_HEAD, "head_circ", 0.0, 0.0, false},
    {MUS_MEASURE_UPPER_ARM, "biceps_circ", -2.0, -2.0, false},
    {MUS_MEASURE_WRIST, "wrist_circ", 0.0, 0.0, false},
    {MUS_MEASURE_THIGH, "thigh_circ", 0.0, 0.0, false},
    {MUS_MEASURE_CALF, "calf_circ", 0.0, 0.0, false},
    {MUS_MEASURE_ANKLE, "ankle_circ", 0.0, 0.0, false},
};


/* the whole file with a zero behind it */
static char *read_all(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) return NULL;
    char *text = NULL;
    long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (size > 0 && fseek(file, 0, SEEK_SET) == 0) text = malloc((size_t)size + 1);
    if (text != NULL) text[fread(text, 1, (size_t)size, file)] = '\0';
    fclose(file);
    return text;
}


/* cut one line in place; where the next begins */
static char *cut_line(char *at, const char **field, int most, int *count)
{
    *count = 0;
    for (;;) {
        if (*count < most) field[(*count)++] = at;
        at += strcspn(at, ",\r\n");
        const char stop = *at;
        if (stop != '\0') *at++ = '\0';
        if (stop == '\r' && *at == '\n') at++;
        if (stop != ',') return at;
    }
}


bool ansur_open(ansur *table, const char *path)
{
    *table = (ansur){0};
    table->text = read_all(path);
    if (table->text == NULL) return false;

    int lines = 0;
    for (const char *at = table->text; *at != '\0'; at++) lines += *at == '\n';
    char *rest = cut_line(table->text, table->head, ANSUR_COLUMNS, &table->columns);
    table->field = malloc(sizeof *table->field * (size_t)(lines + 1) * (size_t)table->columns);
    for (int count; table->field != NULL && *rest != '\0'; table->rows++) {
        rest = cut_line(rest, table->field + (size_t)table->rows * (size_t)table->columns, table->columns, &count);
        if (count != table->columns) table->rows--;
    }
    if (table->rows > 0) return true;
    ansur_close(table);
    return false;
}


void ansur_close(ansur *table)
{
    free(table->field);
    free(table->text);
    *table = (ansur){0};
}


static const char *at_column(const ansur *table, int row, const char *column)
{
    for (int c = 0; c < table->columns; c++)
        if (strcmp(table->head[c], column) == 0) return table->field[(size_t)row * (size_t)table->columns + (size_t)c];
    return NULL;
}


const char *ansur_name(const ansur *table, int row)
{
    return at_column(table, row, "id");
}


bool ansur_male(const ansur *table, int row)
{
    const char *sex = at_column(table, row, "sex");
    return sex != NULL && *sex == 'M';
}


double ansur_value(const ansur *table, int row, const char *column)
{
    const char *text = at_column(table, row, column);
    return text != NULL ? atof(text) : NAN;
}


double ansur_volume(const ansur *table, int row)
{
    return ansur_value(table, row, "weight_kg") / ANSUR_DENSITY;
}


mus_tape *ansur_tape(mus_context *context, const ansur *table, int row)
{
    mus_tape *tape = NULL;
    const bool male = ansur_male(table, row);
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_sex(tape, male ? MUS_SEX_MALE : MUS_SEX_FEMALE);
    if (status == MUS_OK) status = mus_tape_set_name(tape, ansur_name(table, row));
    for (int i = 0; i < ANSUR_MEASURES && status == MUS_OK; i++) {
        const ansur_measure *m = &ansur_measures[i];
        const double cm = ansur_value(table, row, m->column) + (male ? m->off_male : m->off_female);
        status = mus_tape_set(tape, m->measure, 0.01 * cm, MUS_SOURCE_GIVEN);
    }
    if (status == MUS_OK)
        status = mus_tape_set(tape, MUS_MEASURE_WAIST_HEIGHT,
                              (male ? 0.615 : 0.622) * mus_tape_value(tape, MUS_MEASURE_STATURE), MUS_SOURCE_DERIVED);
    if (status == MUS_OK) return tape;
    mus_tape_destroy(tape);
    return NULL;
}
