/*
 * try.h: one named design drafted for one tape, and looked at without the library's own check: sewn edges against each
 * other, their notches, legs of darts, outlines that meet themselves. What `make designs` does for all and a test for a
 * sample.
 */
#ifndef MUS_TESTS_DESIGNS_TRY_H
#define MUS_TESTS_DESIGNS_TRY_H

#include <stdbool.h>

#include "muslin/design.h"

#define TRY_TEXT 400

typedef struct design_try {
    mus_status status;
    char text[TRY_TEXT]; /* why not */
    double seconds;      /* CPU time of the draft */
    double seam;         /* most that a seam's lengths differ by beside its ease [m] */
    double dart;         /* most that the legs of a dart differ by [m] */
    int notches;         /* seams whose two edges differ in number, kind or place of their notches, or have two of them
                            within 10 mm */
    int notch;           /* one of those seams */
    int crossings;       /* outlines that meet themselves, as chords, of what is draped and of what is cut only */
    char crossing[64];   /* one of those panels */
    int panels, seams;
} design_try;

/* the groups, as bits of MUS_GROUP_*, that a tape is of */
int try_group(const mus_tape *tape);
/* draft and look; the pattern is handed out when `kept` is not NULL */
void try_draft(mus_context *context, int design, const mus_tape *tape, design_try *out, mus_pattern **kept);
/* the text without its numbers: the same reason for another body has the same key */
void try_reason(const char *text, char *key, int size);

#endif
