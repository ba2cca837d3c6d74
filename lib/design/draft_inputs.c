/*
 * draft_inputs.c: reads the inputs of a draft: its options, and the measures and skeleton of a tape completed on a
 * copy; and checks its result, the pattern.
 */
#include "design/draft.h"
#include "muslin/topology.h"

#include <math.h>
#include <string.h>


void mus_draft_def_init(mus_draft_def *def, size_t size)
{
    const mus_draft_def own = {size, NAN, NAN, NAN};
    mus__def_init(def, size, &own, sizeof own);
}


/* options that are given must be plausible lengths */
static mus_status draft_check_def(mus_context *context, const mus_draft_def *def)
{
    const struct {
        const char *name;
        double value, low, high;
    } list[] = {{"ease", def->ease, -0.5, 1.0}, {"length", def->length, 0.02, 2.5}, {"sleeve", def->sleeve, 0.02, 1.2}};
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        if (isnan(list[i].value) || (list[i].value >= list[i].low && list[i].value <= list[i].high)) continue;
        return mus__fail(context, MUS_ERR_ARG, "draft: %s is %g m, expected %g to %g", list[i].name, list[i].value,
                         list[i].low, list[i].high);
    }
    return MUS_OK;
}


mus_status mus__design_read(mus_context *context, const mus_tape *tape, const mus_draft_def *def,
                            mus_draft_def *wishes, mus__measures *measures, mus__skeleton *skeleton)
{
    mus_draft_def_init(wishes, sizeof *wishes);
    mus_status status = mus__def_read(context, wishes, sizeof *wishes, sizeof *wishes, def, "mus_draft_def");
    if (status == MUS_OK) status = draft_check_def(context, wishes);
    if (status != MUS_OK) return status;

    mus_tape *copy = NULL;
    status = mus_tape_copy(tape, &copy);
    if (status == MUS_OK && !mus_tape_is_complete(copy)) status = mus_tape_complete(copy);
    if (status == MUS_OK) {
        mus__measures_read(copy, measures);
        mus__skeleton_make(copy, skeleton);
    } else if (mus_tape_context(tape) != context) {
        mus__fail(context, status, "%s", mus_context_error(mus_tape_context(tape)));
    }
    mus_tape_destroy(copy);
    return status;
}


mus_status mus__design_check(mus_context *context, mus_pattern *pattern)
{
    int32_t count;
    mus_faults *faults;
    mus_status status = mus_pattern_check(pattern, &count, &faults);
    if (status == MUS_OK && count > 0)
        status = mus__fail(context, MUS_ERR_DESIGN, "draft of %s: %s", mus_pattern_name(pattern),
                           mus_faults_text(faults, 0));
    mus_faults_destroy(faults);
    return status;
}
