/*
 * drafts.c: rows "designs/NAME": each named design drafted for all table sizes of its groups (in a table of their own);
 * "styles/...": names, axes and options of designs, grade rules and ease.
 */
#include "same.h"

#include <stdio.h>
#include <stdlib.h>

/* ---- every named design ---- */

static int32_t group_of(const mus_tape *tape)
{
    switch (mus_tape_sex(tape)) {
    case MUS_SEX_FEMALE:
        return MUS_GROUP_WOMEN;
    case MUS_SEX_MALE:
        return MUS_GROUP_MEN;
    case MUS_SEX_CHILD:
        return MUS_GROUP_CHILDREN;
    default:
        return 0;
    }
}


static void make_design(same_run *run, const void *what, int32_t design)
{
    (void)what;
    for (int32_t i = 0; i < mus_tape_size_count(); i++) {
        mus_tape *tape = same_size(run, mus_tape_size_name(i));
        mus_pattern *pattern = NULL;
        if ((group_of(tape) & mus_design_groups(design)) != 0) {
            const mus_status status = mus_design_draft(run->context, design, tape, NULL, &pattern);
            if (same_status(run, status)) same_pattern(run, pattern);
        }
        mus_pattern_destroy(pattern);
        mus_tape_destroy(tape);
    }
}


/* ---- names and words ---- */

static void make_names(same_run *run, const void *what, int32_t index)
{
    (void)what, (void)index;
    for (int32_t d = 0; d < mus_design_count(); d++) {
        char text[512];
        same_text(run, mus_design_name(d));
        same_text(run, mus_design_family(d));
        same_text(run, mus_design_title(d));
        same_text(run, mus_design_words(d));
        same_int(run, mus_design_groups(d));
        same_int(run, mus_design_find(mus_design_name(d)));
        if (same_status(run, mus_design_spell(run->context, mus_design_words(d), text, sizeof text)))
            same_text(run, text);
    }
}


static void make_axes(same_run *run, const void *what, int32_t index)
{
    (void)what, (void)index;
    for (int32_t a = 0; a < mus_design_axis_count(); a++) {
        same_text(run, mus_design_axis_name(a));
        for (int32_t o = 0; o < mus_design_option_count(a); o++) same_text(run, mus_design_option_name(a, o));
    }
}


/* each option of an axis on each garment that takes it: drafts that no named design has */
static void make_options(same_run *run, const void *what, int32_t axis)
{
    (void)what;
    mus_tape *tape = same_size(run, "W40");
    for (int32_t g = 0; g < mus_design_option_count(0); g++)
        for (int32_t o = 0; o < mus_design_option_count(axis); o++) {
            char words[256];
            mus_pattern *pattern = NULL;
            snprintf(words, sizeof words, "%s %s=%s", mus_design_option_name(0, g), mus_design_axis_name(axis),
                     mus_design_option_name(axis, o));
            if (same_status(run, mus_design_draft_words(run->context, words, tape, NULL, &pattern)))
                same_pattern(run, pattern);
            mus_pattern_destroy(pattern);
        }
}


/* ---- sizes ---- */

/* a design with another ease, length and sleeve, in steps */
static void make_lengths(same_run *run, const void *what, int32_t index)
{
    (void)index;
    mus_tape *tape = same_size(run, "W40");
    for (int i = 0; i < 9; i++) {
        mus_pattern *pattern = NULL;
        mus_draft_def def;
        mus_draft_def_init(&def, sizeof def);
        const double value = i % 3 == 0 ? 0.05 + 0.01 * i : 0.1 + 0.07 * i;
        if (i % 3 == 0) def.ease = value;
        else if (i % 3 == 1) def.length = value;
        else def.sleeve = value;
        const mus_status status = mus_design_draft(run->context, mus_design_find(what), tape, &def, &pattern);
        if (same_status(run, status)) same_pattern(run, pattern);
        mus_pattern_destroy(pattern);
    }
}


static void make_grade(same_run *run, const void *what, int32_t index)
{
    (void)index;
    static const char *const sizes[] = {"W36", "W40", "W46"};
    mus_pattern *pattern[3];
    for (int i = 0; i < 3; i++) {
        double ease[MUS_EASE_COUNT];
        mus_tape *tape = same_size(run, sizes[i]);
        pattern[i] = same_draft(run, what, tape);
        if (same_status(run, mus_design_ease(pattern[i], tape, ease))) same_reals(run, ease, MUS_EASE_COUNT);
    }
    for (int i = 0; i < 2; i++) {
        const int32_t points = mus_pattern_point_count(pattern[i]);
        double *rules = calloc(2 * (size_t)points + 1, sizeof *rules);
        int32_t count = -1;
        mus_pattern *graded = NULL;
        if (rules == NULL) same_must(run, MUS_ERR_MEMORY, "rules");
        same_status(run, mus_design_grade(pattern[i], pattern[i + 1], rules, &count));
        same_int(run, count);
        same_reals(run, rules, 2 * (int64_t)points);
        if (same_status(run, mus_design_grade_apply(pattern[i], rules, &graded))) same_pattern(run, graded);
        free(rules);
    }
}


void same_drafts(same_list *list)
{
    static const char *const graded[] = {"tshirt", "skirt", "bodice", "sheath", "oxford_shirt", "jeans"};
    for (int32_t d = 0; d < mus_design_count(); d++)
        same_add(list, make_design, "designs/%s", mus_design_name(d))->index = d;
    same_add(list, make_names, "styles/names");
    same_add(list, make_axes, "styles/axes");
    for (int32_t a = 1; a < mus_design_axis_count(); a++)
        same_add(list, make_options, "styles/options-%s", mus_design_axis_name(a))->index = a;
    for (size_t i = 0; i < sizeof graded / sizeof *graded; i++) {
        same_add(list, make_lengths, "styles/lengths-%s", graded[i])->what = graded[i];
        same_add(list, make_grade, "styles/grade-%s", graded[i])->what = graded[i];
    }
}
