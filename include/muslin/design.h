/*
 * muslin/design.h: garments drafted from the tape.
 *
 * A design is a few words, "dress neck=v sleeve=puff": one option for each axis of style. Blocks (bodice, sleeve,
 * skirt, trousers) are drafted to the measures, the words work on them, and they become a pattern with seams, notches,
 * grain and placement round the body. Many designs have names. Axes and formulas: man page mus_design(3).
 */
#ifndef MUSLIN_DESIGN_H
#define MUSLIN_DESIGN_H

#include "muslin/base.h"
#include "muslin/pattern.h"
#include "muslin/tape.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Number of named designs; name ("tshirt"), family ("top", "skirt") and title ("T-shirt") of one; NULL outside. */
MUS_API int32_t mus_design_count(void);
MUS_API const char *mus_design_name(int32_t design);
MUS_API const char *mus_design_family(int32_t design);
MUS_API const char *mus_design_title(int32_t design);

/** Words of a named design ("top neck=v sleeve=puff"); NULL outside. */
MUS_API const char *mus_design_words(int32_t design);

/* Whom a design is for. */
#define MUS_GROUP_WOMEN 1
#define MUS_GROUP_MEN 2
#define MUS_GROUP_CHILDREN 4

/** The groups of a named design, bits of MUS_GROUP_*: it drafts for every table size of them. 0 outside. */
MUS_API int32_t mus_design_groups(int32_t design);

/** Index of a design by name, MUS_NONE if unknown. */
MUS_API int32_t mus_design_find(const char *name);

/** The axes of words, for a menu: how many, the name of one ("sleeve"), how many options it has, the name of one
 * ("puff"); NULL and 0 outside. Axis 0 is the garment, whose option stands alone as the first word. */
MUS_API int32_t mus_design_axis_count(void);
MUS_API const char *mus_design_axis_name(int32_t axis);
MUS_API int32_t mus_design_option_count(int32_t axis);
MUS_API const char *mus_design_option_name(int32_t axis, int32_t option);

/**
 * Words in full: what was left out and is chosen, in the order of the axes; first options are left out but for neck,
 * shape and closure. Words that mean the same give the same text.
 *
 * Shapes:  text, at most `size` bytes with the end; 512 hold any
 * Errors:  MUS_ERR_ARG; MUS_ERR_DESIGN (unknown word: the options are named; two words that exclude one another: both
 *          are named, and why). text is "" then
 */
MUS_API mus_status mus_design_spell(mus_context *context, const char *words, char *text, size_t size);

/** Options of a draft; NaN takes the design's own value. */
typedef struct mus_draft_def {
    size_t size;
    double ease;   /* total ease on the bust (tops) or hip (skirts, trousers) [m] */
    double length; /* waist to hem [m] */
    double sleeve; /* sleeve length from the shoulder point [m] */
} mus_draft_def;

MUS_API void mus_draft_def_init(mus_draft_def *def, size_t size);

/**
 * Draft a design for a tape.
 *
 * `tape` is completed on a copy when it is not complete. `def` may be NULL.
 * Errors:  MUS_ERR_ARG; MUS_ERR_TAPE; MUS_ERR_DESIGN (infeasible: the message names the step and the measures)
 * Memory:  the pattern is the caller's
 */
MUS_API mus_status mus_design_draft(mus_context *context, int32_t design, const mus_tape *tape,
                                    const mus_draft_def *def, mus_pattern **out);

/** Draft a garment by words; the rest as mus_design_draft(). Errors: MUS_ERR_DESIGN too for what mus_design_spell()
 * refuses. */
MUS_API mus_status mus_design_draft_words(mus_context *context, const char *words, const mus_tape *tape,
                                          const mus_draft_def *def, mus_pattern **out);

/* ---- sizes ---- */

/**
 * Grade rules: how far each point of `from` moves to where `to` has it, the same design drafted for another size.
 *
 * Points are known by the edges of panels of the same name that end in them; one that `to` does not have gets NaN.
 * Shapes:  rules (points of `from` x 2) [m]; *count is how many points have a rule, may be NULL
 * Errors:  MUS_ERR_ARG
 */
MUS_API mus_status mus_design_grade(const mus_pattern *from, const mus_pattern *to, double *rules, int32_t *count);

/**
 * A pattern with each point moved by its rule; what lies between the ends of an edge moves by a mean of both, weighed
 * by the way along the edge; eases become what the lengths then are. For files that carry rules: a size that is drafted
 * is exact.
 *
 * Shapes:  rules (points x 2) [m], all finite
 * Errors:  MUS_ERR_ARG (the panel is named); MUS_ERR_PATTERN; MUS_ERR_MEMORY
 */
MUS_API mus_status mus_design_grade_apply(const mus_pattern *pattern, const double *rules, mus_pattern **out);

#define MUS_EASE_BUST 0
#define MUS_EASE_WAIST 1
#define MUS_EASE_HIP 2
#define MUS_EASE_COUNT 3

/**
 * What the garment is wider than the body all round at bust, waist and hip, by a level cut through the panels that
 * stand round the torso as they are placed. NaN at a level that it does not reach.
 *
 * Shapes:  ease (MUS_EASE_COUNT) [m]
 * Errors:  MUS_ERR_ARG, MUS_ERR_TAPE
 */
MUS_API mus_status mus_design_ease(const mus_pattern *pattern, const mus_tape *tape, double *ease);

#ifdef __cplusplus
}
#endif

#endif
