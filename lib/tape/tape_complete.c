/*
 * tape_complete.c: a tape completed: every missing measure derived, and the sheet checked.
 *
 * Works on a copy: tape_derive.c fills in what the caller did not set, tape_check.c refuses a sheet that no body can
 * have, and only then the copy replaces the tape. After an error the tape is as it was before the call.
 */
#include "tape/tape_internal.h"


mus_status mus_tape_complete(mus_tape *tape)
{
    if (tape == NULL) return MUS_ERR_ARG;

    /* the measures that cannot be derived; a child's girths follow from its stature */
    static const int32_t needed[] = {MUS_MEASURE_STATURE, MUS_MEASURE_BUST, MUS_MEASURE_WAIST, MUS_MEASURE_HIP};
    for (int i = 0; i < (tape->sex == MUS_SEX_CHILD ? 1 : 4); i++)
        if (!tape->held[needed[i]])
            return mus__fail(tape->context, MUS_ERR_TAPE, "%s is missing: it cannot be derived",
                             mus_measure_name(needed[i]));

    /* on a copy, so that the tape stays as it was when a check fails */
    mus_tape *work = NULL;
    mus_status status = mus_tape_copy(tape, &work);
    if (status != MUS_OK) return status;
    mus__tape_derive(work);
    status = mus__tape_check(work);
    if (status == MUS_OK) {
        work->complete = true;
        *tape = *work;
    }
    mus_tape_destroy(work);
    return status;
}
