/*
 * worn.h: garments over one another on a body of a size.
 *
 *     worn w = worn_body("W40");
 *     worn_put_on(&w, pattern);              as often as there are layers, from inside to outside
 *     w.cloth = scene_cut(w.context, w.pattern, 0.04, 0.0);
 *     worn_place(&w, &def);                  w.drape, not yet sewn
 *     worn_end(&w);
 */
#ifndef MUS_TESTS_WORN_H
#define MUS_TESTS_WORN_H

#include "muslin/muslin.h"
#include "support.h"

typedef struct worn {
    mus_context *context;
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern; /* of all layers */
    int32_t layers;
    mus_cloth *cloth;
    mus_drape *drape;
} worn;


static inline worn worn_body(const char *size)
{
    worn w = {.context = support_context()};
    ck_assert_int_eq(mus_tape_create(w.context, &w.tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(w.tape, size), MUS_OK);
    ck_assert_int_eq(mus_body_create(w.context, w.tape, NULL, &w.body), MUS_OK);
    return w;
}


/* takes the pattern, over all that is worn */
static inline void worn_put_on(worn *w, mus_pattern *one)
{
    if (w->layers == 0) {
        w->pattern = one;
    } else {
        ck_assert_int_eq(mus_pattern_join(w->pattern, one, w->layers), MUS_OK);
        mus_pattern_destroy(one);
    }
    for (int32_t p = 0; p < mus_pattern_panel_count(w->pattern); p++) {
        const int32_t over = mus_pattern_layer(w->pattern, p) + 1;
        w->layers = w->layers > over ? w->layers : over;
    }
}


/* a design by its name, `ease` NULL: its own */
static inline void worn_put_on_design(worn *w, const char *design, const double *ease)
{
    mus_pattern *one;
    mus_draft_def draft;
    mus_draft_def_init(&draft, sizeof draft);
    if (ease != NULL) draft.ease = *ease;
    ck_assert_int_eq(mus_design_draft(w->context, mus_design_find(design), w->tape, &draft, &one), MUS_OK);
    worn_put_on(w, one);
}


/* a design by its words */
static inline void worn_put_on_words(worn *w, const char *words)
{
    mus_pattern *one;
    ck_assert_int_eq(mus_design_draft_words(w->context, words, w->tape, NULL, &one), MUS_OK);
    worn_put_on(w, one);
}


static inline void worn_place(worn *w, const mus_drape_def *def)
{
    ck_assert_int_eq(mus_drape_create(w->context, w->cloth, w->body, def, &w->drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(w->drape), MUS_OK);
}


static inline void worn_end(worn *w)
{
    mus_drape_destroy(w->drape);
    mus_cloth_destroy(w->cloth);
    mus_pattern_destroy(w->pattern);
    mus_body_destroy(w->body);
    mus_tape_destroy(w->tape);
    support_context_end(w->context);
}

#endif
