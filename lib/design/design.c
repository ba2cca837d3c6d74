/*
 * design.c: the list of named designs, and drafting one of them: tape to measures and skeleton, recipe, check.
 *
 * A design is a row: name, family, title, recipe. Adding one is adding a row.
 */
#include <math.h>
#include <string.h>

#include "design/design_internal.h"

static const struct {
    const char *name, *family, *title;
    void (*draft)(mus__draft *draft);
} design_list[] = {
    {"tshirt", "top", "T-shirt", mus__draft_tshirt},
    {"sleeveless", "top", "Sleeveless top", mus__draft_sleeveless},
    {"bodice", "block", "Bodice block", mus__draft_bodice},
    {"skirt", "skirt", "Straight skirt", mus__draft_skirt},
    {"skirt_plain", "skirt", "A-line skirt without darts", mus__draft_skirt_plain},
};

#define DESIGNS ((int32_t)(sizeof design_list / sizeof design_list[0]))


int32_t mus_design_count(void)
{
    return DESIGNS;
}


const char *mus_design_name(int32_t design)
{
    return design >= 0 && design < DESIGNS ? design_list[design].name : NULL;
}


const char *mus_design_family(int32_t design)
{
    return design >= 0 && design < DESIGNS ? design_list[design].family : NULL;
}


const char *mus_design_title(int32_t design)
{
    return design >= 0 && design < DESIGNS ? design_list[design].title : NULL;
}


int32_t mus_design_find(const char *name)
{
    for (int32_t d = 0; name != NULL && d < DESIGNS; d++)
        if (strcmp(design_list[d].name, name) == 0) return d;
    return MUS_NONE;
}


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


/* the first fault of a draft is the recipe's failure */
static void design_check(mus__draft *draft)
{
    int32_t faults;
    const char *text;
    if (draft->status != MUS_OK) return;
    draft->status = mus_pattern_check(draft->pattern, &faults);
    if (draft->status != MUS_OK || faults == 0) return;
    mus_pattern_fault(draft->pattern, 0, NULL, NULL, NULL, NULL, &text);
    draft->status =
        mus__fail(draft->context, MUS_ERR_DESIGN, "draft of %s: %s", mus_pattern_name(draft->pattern), text);
}


mus_status mus_design_draft(mus_context *context, int32_t design, const mus_tape *tape, const mus_draft_def *def,
                            mus_pattern **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (tape == NULL || out == NULL) return mus__fail(context, MUS_ERR_ARG, "draft: tape or out is NULL");
    if (design < 0 || design >= DESIGNS)
        return mus__fail(context, MUS_ERR_ARG, "design %d, expected 0 to %d", (int)design, (int)DESIGNS - 1);

    mus__draft draft;
    memset(&draft, 0, sizeof draft);
    draft.context = context;
    mus_draft_def_init(&draft.def, sizeof draft.def);
    mus_status status = mus__def_read(context, &draft.def, sizeof draft.def, sizeof draft.def, def, "mus_draft_def");
    if (status == MUS_OK) status = design_check_def(context, &draft.def);

    mus_tape *copy = NULL;
    if (status == MUS_OK) status = mus_tape_copy(tape, &copy);
    if (status == MUS_OK && !mus_tape_is_complete(copy)) status = mus_tape_complete(copy);
    if (status != MUS_OK) {
        if (mus_tape_context(tape) != context)
            mus__fail(context, status, "%s", mus_context_error(mus_tape_context(tape)));
        mus_tape_destroy(copy);
        return status;
    }
    mus__measures_read(copy, &draft.measures);
    mus__skeleton_make(copy, &draft.skeleton);
    mus_tape_destroy(copy);

    draft.status = mus_pattern_create(context, design_list[design].name, &draft.pattern);
    if (draft.status == MUS_OK) design_list[design].draft(&draft);
    design_check(&draft);
    if (draft.status != MUS_OK) {
        mus_pattern_destroy(draft.pattern);
        return draft.status;
    }
    *out = draft.pattern;
    return MUS_OK;
}
