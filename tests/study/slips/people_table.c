/*
 * people_table.c: lib/tape/tape_people.h from every second person of ANSUR II (Gordon and others 2014).
 */
#include <math.h>
#include <stdio.h>

#include "slips.h"

/* [cm] standard deviation that is added to the survey's inside leg: the survey presses the ruler up to the crotch, and
 * its mean is 2.4 (men) to 3.6 cm (women) above that of clothing tables */
#define INLEG_ALLOWANCE 3.0


/* mean and covariance of the logarithms [ln cm] of the people of one sex in the rows 0, 2, 4 ... */
static void fit(const ansur *table, bool male, double *mean, double (*covariance)[ANSUR_MEASURES])
{
    double sum[ANSUR_MEASURES] = {0}, square[ANSUR_MEASURES][ANSUR_MEASURES] = {{0}}, x[ANSUR_MEASURES];
    int n = 0;
    for (int row = 0; row < table->rows; row += 2) {
        if (ansur_male(table, row) != male) continue;
        n++;
        for (int i = 0; i < ANSUR_MEASURES; i++) {
            const ansur_measure *m = &ansur_measures[i];
            x[i] = log(ansur_value(table, row, m->column) + (male ? m->off_male : m->off_female));
            sum[i] += x[i];
            for (int j = 0; j <= i; j++) square[i][j] += x[i] * x[j];
        }
    }
    for (int i = 0; i < ANSUR_MEASURES; i++) mean[i] = sum[i] / n;
    for (int i = 0; i < ANSUR_MEASURES; i++)
        for (int j = 0; j <= i; j++) covariance[i][j] = (square[i][j] - n * mean[i] * mean[j]) / (n - 1);
    for (int i = 0; i < ANSUR_MEASURES; i++)
        if (ansur_measures[i].measure == MUS_MEASURE_INLEG)
            covariance[i][i] += INLEG_ALLOWANCE * INLEG_ALLOWANCE * exp(-2 * mean[i]);
}


/* one member of mus__people */
static void write_sex(FILE *out, const ansur *table, bool male)
{
    double mean[ANSUR_MEASURES], covariance[ANSUR_MEASURES][ANSUR_MEASURES];
    fit(table, male, mean, covariance);
    fprintf(out, "    {{");
    for (int i = 0; i < ANSUR_MEASURES; i++) fprintf(out, "%s%.2f", i ? ", " : "", exp(mean[i]));
    fprintf(out, "},\n     {");
    for (int i = 0; i < ANSUR_MEASURES; i++) fprintf(out, "%s%.2f", i ? ", " : "", 100 * sqrt(covariance[i][i]));
    fprintf(out, "},\n     {");
    for (int i = 1; i < ANSUR_MEASURES; i++) {
        for (int j = 0; j < i; j++)
            fprintf(out, "%s%ld", j ? ", " : "",
                    lround(1000 * covariance[i][j] / sqrt(covariance[i][i] * covariance[j][j])));
        fprintf(out, i + 1 < ANSUR_MEASURES ? ",\n      " : "}}");
    }
}


bool slips_write_table(const ansur *table, const char *path)
{
    FILE *out = fopen(path, "w");
    if (out == NULL) return false;
    fputs("/*\n * tape_people.h: how the measures of people go together. Written by tests/study/slips"
          " from every second\n * person of 3034 of ANSUR II (Gordon and others 2014; US Army, public domain);"
          " tests/study/people/ansur.h has\n * the survey's columns and their offsets."
          " The other half of the people tests the table (`make slips`).\n */\n"
          "#ifndef MUS_TAPE_TAPE_PEOPLE_H\n#define MUS_TAPE_TAPE_PEOPLE_H\n\n#include \"muslin/tape.h\"\n\n",
          out);
    fprintf(out, "#define MUS__PEOPLE_MEASURES %d\n\n", ANSUR_MEASURES);
    fputs("/* the measures of the table */\nstatic const int32_t mus__people_measure[MUS__PEOPLE_MEASURES] = {\n", out);
    for (int i = 0; i < ANSUR_MEASURES; i++) {
        char name[40];
        const char *from = mus_measure_name(ansur_measures[i].measure);
        size_t n = 0;
        for (; from[n] != '\0'; n++) name[n] = from[n] == '_' ? '_' : (char)(from[n] - 'a' + 'A');
        name[n] = '\0';
        fprintf(out, "    MUS_MEASURE_%s,\n", name);
    }
    fputs("};\n\n/* women, men: geometric mean [cm]; standard deviation of the natural logarithm [%];"
          " correlations of the\n * logarithms [1/1000], row i with columns 0 to i - 1 */\n"
          "static const struct mus__people {\n"
          "    double mean[MUS__PEOPLE_MEASURES], deviation[MUS__PEOPLE_MEASURES];\n"
          "    int16_t correlation[MUS__PEOPLE_MEASURES * (MUS__PEOPLE_MEASURES - 1) / 2];\n"
          "} mus__people[2] = {\n",
          out);
    write_sex(out, table, false);
    fputs(",\n", out);
    write_sex(out, table, true);
    fputs(",\n};\n\n#endif\n", out);
    return fclose(out) == 0;
}
