/*
 * tape_internal.h: the insides of a tape, shared by the files that derive, check and fill one. A tape is one flat
 * block: copying it is copying the struct.
 */
#ifndef MUS_TAPE_TAPE_INTERNAL_H
#define MUS_TAPE_TAPE_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/tape.h"

#define MUS__TAPE_NAME_BYTES 64
#define MUS__TAPE_WARNINGS 48
#define MUS__TAPE_WARNING_BYTES 224
#define MUS__TAPE_TEXT_BYTES 48

struct mus_tape {
    mus_context *context;
    int32_t sex;
    bool complete;
    char name[MUS__TAPE_NAME_BYTES];
    double value[MUS_MEASURE_COUNT];   /* [m or rad], NaN: unset */
    int32_t source[MUS_MEASURE_COUNT]; /* MUS_SOURCE_* */
    bool held[MUS_MEASURE_COUNT];      /* set by the caller (whatever its source): deriving leaves it alone */
    int32_t warning_count;
    char warning[MUS__TAPE_WARNINGS][MUS__TAPE_WARNING_BYTES];
};

/* range of a measure as mus_tape_set() takes it: half of the plausible low to twice the plausible high */
void mus__tape_range(int32_t measure, double *low, double *high);

/* what stature, bust, waist and hip predict for a measure of this sex [m or rad] (drafting table 1.2), and the
 * standard deviation of that prediction (0: not known). NaN when there is no prediction. */
double mus__tape_predict(const mus_tape *tape, int32_t measure, double *deviation);

/* derive everything that is not held; stature, bust, waist and hip must be set (child: stature) */
void mus__tape_derive(mus_tape *tape);

/* girths of a child from its stature [m] */
double mus__tape_child_girth(double stature, int32_t measure);

/* the consistency checks; fills the warnings. MUS_ERR_TAPE with a sentence that names both measures */
mus_status mus__tape_check(mus_tape *tape);

/* a length as text in cm with one decimal, an angle in degrees; the same in every locale. out: MUS__TAPE_TEXT_BYTES */
const char *mus__tape_text(int32_t measure, double value, char *out);

#endif
