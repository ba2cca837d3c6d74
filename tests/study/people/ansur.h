/*
 * ansur.h: the people of ANSUR II (anthropometry/ansur2_garment_cm.csv of the test data) as tapes.
 *
 * The one place where the survey's columns become measures. Asked of every person:
 *
 *     stature       stature                head        head_circ
 *     bust          chest_circ             neck        neck_base_circ
 *     waist         waist_circ less 7 cm (women), 1 cm (men): the survey's waist is at the navel
 *     hip           hip_circ               thigh, calf, ankle, wrist   the columns of these names
 *     inleg         crotch_h               upper_arm   biceps_circ less 2 cm: the survey's is flexed
 *     nape_height   cervicale_h
 *
 * The waist's height is 0.622 of the stature (women), 0.615 (men), the mean of clothing tables: the survey has the
 * navel's alone, and its crotch is pressed up, so inside leg and rise do not sum to it. Weight over 1.03 kg/l is the
 * volume. Breadths and depths are not asked: they are what the made body is compared with.
 */
#ifndef MUS_TESTS_PEOPLE_ANSUR_H
#define MUS_TESTS_PEOPLE_ANSUR_H

#include <stdbool.h>

#include "muslin/tape.h"

#define ANSUR_COLUMNS 64
#define ANSUR_DENSITY 1030.0 /* [kg/m3] of a living body, some air in the lungs */

typedef struct ansur {
    char *text; /* the file, cut in fields */
    int rows, columns;
    const char *head[ANSUR_COLUMNS];
    const char **field; /* (rows x columns) */
} ansur;

/* read the table at `path`; false without it */
bool ansur_open(ansur *table, const char *path);
void ansur_close(ansur *table);

const char *ansur_name(const ansur *table, int row);
bool ansur_male(const ansur *table, int row);
/* a column as it stands: cm, kg, years; NaN for a column that is not there */
double ansur_value(const ansur *table, int row, const char *column);
/* [m3] */
double ansur_volume(const ansur *table, int row);
/* a person as a tape; NULL when a measure is refused: the context has the sentence */
mus_tape *ansur_tape(mus_context *context, const ansur *table, int row);

/* the measures that are asked, and whether each is a height */
typedef struct ansur_measure {
    int measure;
    const char *column;
    double off_female, off_male; /* added to the column [cm] */
    bool height;
} ansur_measure;

#define ANSUR_MEASURES 13
extern const ansur_measure ansur_measures[ANSUR_MEASURES];

#endif
