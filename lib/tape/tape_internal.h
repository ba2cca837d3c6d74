/*
 * tape_internal.h: the struct of a tape, for the files that derive, check and fill one. It holds no pointer to memory
 * of its own, so that assigning the struct copies a tape.
 */
#ifndef MUS_TAPE_TAPE_INTERNAL_H
#define MUS_TAPE_TAPE_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/tape.h"

#define MUS__TAPE_NAME_BYTES 64     /* bytes of a name, the closing 0 included */
#define MUS__TAPE_WARNINGS 48       /* most warnings of a tape; above the number of checks that can fail at once */
#define MUS__TAPE_WARNING_BYTES 224 /* bytes of a warning, the closing 0 included; longer ones are cut */
#define MUS__TAPE_TEXT_BYTES 48     /* bytes of a value as text, the closing 0 included */

struct mus_tape {
    mus_context *context;
    int32_t sex;
    bool complete;
    char name[MUS__TAPE_NAME_BYTES];
    double value[MUS_MEASURE_COUNT];   /* [m or rad], NaN: unset */
    int32_t source[MUS_MEASURE_COUNT]; /* MUS_SOURCE_* */
    bool held[MUS_MEASURE_COUNT];      /* set by the caller, whatever its source: deriving does not change it */
    int32_t warning_count;
    char warning[MUS__TAPE_WARNINGS][MUS__TAPE_WARNING_BYTES];
};

/* range [m or rad] that mus_tape_set() accepts: half of the plausible low to twice the plausible high */
void mus__tape_range(int32_t measure, double *low, double *high);

/* a measure predicted from stature, bust, waist and hip for the tape's sex [m or rad]; NaN for a measure without a
 * prediction. *deviation: standard deviation of the prediction's error in ANSUR II, 0 where it is not known */
double mus__tape_predict(const mus_tape *tape, int32_t measure, double *deviation);

/* derive every measure that is not held; stature, bust, waist and hip must be set, of a child stature alone */
void mus__tape_derive(mus_tape *tape);

/* bust, waist or hip [m] of a child of that stature [m], from the table of sizes */
double mus__tape_child_girth(double stature, int32_t measure);

/* a given measure that does not fit the others */
typedef struct mus__doubt {
    int32_t measure;
    double expected;   /* [m] predicted from the others */
    const char *cause; /* the slip that explains the value ("digits swapped"), or NULL */
    double likely;     /* [m] the value without that slip */
} mus__doubt;

/* write the doubted measures of a derived tape to doubts (MUS_MEASURE_COUNT + 1); returns their number */
int32_t mus__tape_doubts(const mus_tape *tape, mus__doubt *doubts);

/* check a derived tape and write its warnings. Errors: MUS_ERR_TAPE (the message names both measures) */
mus_status mus__tape_check(mus_tape *tape);

/* a length [m] as text in cm, an angle [rad] in degrees, with one decimal and the same in every locale; writes to and
 * returns out (MUS__TAPE_TEXT_BYTES) */
const char *mus__tape_text(int32_t measure, double value, char *out);

#endif
