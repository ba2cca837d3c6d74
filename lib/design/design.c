/*
 * design.c: a named design drafted: tape to measures and skeleton, its recipe or its words (design_words.c), check.
 */
#include <math.h>
#include <string.h>

#include "design/design_list.h"
#include "design/style.h"
#include "muslin/topology.h"

/* recipes of the first designs of the list, in order */
static void (*const design_recipe[])(mus__draft *draft) = {
    mus__draft_tshirt, mus__draft_sleeveless, mus__draft_bodice, mus__draft_skirt, mus__draft_skirt_plain,
};

#define DESIGN_RECIPES ((int32_t)(sizeof design_recipe / sizeof design_recipe[0]))


void mus_draft_def_init(mus_draft_def *def, size_t size)
{
    if (def == NULL || size < sizeof def->size) return;
    const mus_draft_def own = {size, NAN, NAN, NAN};
    memset(def, 0, size);
    memcpy(def, &own, size < sizeof own ? size : sizeof own);
}


/* ---- measures ---- */

void mus__measures_read(const mus_tape *tape, mus__measures *out)
{
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) out->v[m] = mus_tape_value(tape, m);
    out->sex = mus_tape_sex(tape);
    out->front_waist_given = mus_tape_source(tape, MUS_MEASURE_FRONT_WAIST) == MUS_SOURCE_GIVEN;
}


double mus__measures_scale(const mus__measures *measures)
{
    return fmin(1.0, measures->v[MUS_MEASURE_BUST] / 0.80);
}


int mus__millimetres(double x)
{
    return (int)lround(1000.0 * fmax(-1e5, fmin(1e5, x)));
}


/* ---- draft ---- */

/* an option that was given must be a length that could be meant */
static mus_status design_check_def(mus_context *context, const mus_draft_def *def)
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


mus_status mus__design_check(mus_context *context, mus_pattern *pattern)
{
    int32_t faults;
    const char *text;
    const mus_status status = mus_pattern_check(pattern, &faults);
    if (status != MUS_OK || faults == 0) return status;
    mus_pattern_fault(pattern, 0, NULL, NULL, NULL, NULL, &text);
    return mus__fail(context, MUS_ERR_DESIGN, "draft of %s: %s", mus_pattern_name(pattern), text);
}


mus_status mus__design_read(mus_context *context, const mus_tape *tape, const mus_draft_def *def,
                            mus_draft_def *wishes, mus__measures *measures, mus__skeleton *skeleton)
{
    mus_draft_def_init(wishes, sizeof *wishes);
    mus_status status = mus__def_read(context, wishes, sizeof *wishes, sizeof *wishes, def, "mus_draft_def");
    if (status == MUS_OK) status = design_check_def(context, wishes);
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


/* a design that has a recipe of its own */
static mus_status design_draft_recipe(mus_context *context, int32_t design, const mus_tape *tape,
                                      const mus_draft_def *def, mus_pattern **out)
{
    mus__draft draft;
    memset(&draft, 0, sizeof draft);
    draft.context = context;
    draft.status = mus__design_read(context, tape, def, &draft.def, &draft.measures, &draft.skeleton);
    if (draft.status == MUS_OK) draft.status = mus_pattern_create(context, mus_design_name(design), &draft.pattern);
    if (draft.status == MUS_OK) design_recipe[design](&draft);
    if (draft.status == MUS_OK) draft.status = mus__design_check(context, draft.pattern);
    if (draft.status == MUS_OK) *out = draft.pattern;
    else mus_pattern_destroy(draft.pattern);
    return draft.status;
}


mus_status mus_design_draft(mus_context *context, int32_t design, const mus_tape *tape, const mus_draft_def *def,
                            mus_pattern **out)
{
    mus__style style;
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (tape == NULL || out == NULL) return mus__fail(context, MUS_ERR_ARG, "draft: tape or out is NULL");
    if (design < 0 || design >= mus_design_count())
        return mus__fail(context, MUS_ERR_ARG, "design %d, expected 0 to %d", (int)design,
                         (int)mus_design_count() - 1);
    if (design < DESIGN_RECIPES) return design_draft_recipe(context, design, tape, def, out);
    const mus_status status = mus__style_read(context, mus_design_words(design), &style);
    if (status != MUS_OK) return status;
    return mus__style_draft(context, mus_design_name(design), &style, tape, def, out);
}
