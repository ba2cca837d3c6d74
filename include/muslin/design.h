/*
 * muslin/design.h: garments drafted from the tape.
 *
 * A design is a few words, "dress neck=v sleeve=puff": a garment, and one option for each axis of style. An axis may be
 * left out where only it has the option, or stand beside it: "pencil skirt", "short sleeve top". Blocks (bodice,
 * sleeve, skirt, trousers) are drafted to the measures, the words work on them, and they become a pattern with seams,
 * notches, grain and placement round the body. Many designs have names. Axes and formulas: man page mus_design(3).
 */
#ifndef MUSLIN_DESIGN_H
#define MUSLIN_DESIGN_H

#include "muslin/base.h"
#include "muslin/pattern.h"
#include "muslin/tape.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Number of named designs. */
MUS_API int32_t mus_design_count(void);

/** Name of a design ("tshirt"); NULL outside 0..count - 1. Constant, as are the texts below. */
MUS_API const char *mus_design_name(int32_t design);

/** Family of a design ("knit_top"); NULL outside. */
MUS_API const char *mus_design_family(int32_t design);

/** Title of a design ("T-shirt"); NULL outside. */
MUS_API const char *mus_design_title(int32_t design);

/** Words of a design ("top neck=v sleeve=puff"); NULL outside. */
MUS_API const char *mus_design_words(int32_t design);

/** Name of the fabric that a design is meant for ("denim"), one that mus_fabric_find() knows; NULL outside. A drape
 * takes another as well. */
MUS_API const char *mus_design_fabric(int32_t design);

/* Whom a design is for. */
#define MUS_GROUP_WOMEN 1
#define MUS_GROUP_MEN 2
#define MUS_GROUP_CHILDREN 4

/** Groups of a design, bits of MUS_GROUP_*: it can be drafted for every table size of them. 0 outside. */
MUS_API int32_t mus_design_groups(int32_t design);

/** Index of the design with a name; MUS_NONE if there is none. */
MUS_API int32_t mus_design_find(const char *name);

/**
 * Search the named designs by a phrase that a person types: "long sleeve tee", "kids dress", "skirt length=knee".
 *
 * Words are those of titles, names, families, words and groups, and those of shops that mean them (pants, tee, kids).
 * Plurals, endings, words typed together and slips of a letter or two are read. Words that choose no design (colours)
 * and unknown words are passed over. "axis=option" keeps the designs with that option. A design matches that scores at
 * least half of the best; the design whose name is the phrase itself scores 1.
 *
 * Shapes:  designs (room), scores (room, 0 to 1, may be NULL): the best first, those of equal scores in the order of
 *          their numbers; *count: designs that match, which may be more than room
 * Errors:  MUS_ERR_ARG; MUS_ERR_DESIGN ("axis=option" that no design has); MUS_ERR_MEMORY
 * Memory:  frees all that it allocates, about 0.3 MB
 * Cost:    about 2 ms, 1 ms more for each word of the phrase, up to 12 ms more for "axis=option"
 * Source:  Sparck Jones, A statistical interpretation of term specificity, 1972; Robertson and Zaragoza, The
 *          probabilistic relevance framework, 2009
 */
MUS_API mus_status mus_design_search(mus_context *context, const char *phrase, int32_t room, int32_t *designs,
                                     double *scores, int32_t *count);

/** Number of the axes of words. Axis 0 is the garment, whose option stands alone as the first word. */
MUS_API int32_t mus_design_axis_count(void);

/** Name of an axis ("sleeve"); NULL outside. */
MUS_API const char *mus_design_axis_name(int32_t axis);

/** Number of the options of an axis; 0 outside. */
MUS_API int32_t mus_design_option_count(int32_t axis);

/** Name of an option of an axis ("puff"); NULL outside. */
MUS_API const char *mus_design_option_name(int32_t axis, int32_t option);

/**
 * Spell words in full: with the options that are chosen for axes that were left out, in the order of the axes. First
 * options are left out, except those of neck, shape and closure. Words that mean the same give the same text.
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

/** Set the size of a def and every option to NaN. */
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

/** Draft a garment by words; otherwise as mus_design_draft(). MUS_ERR_DESIGN for words that mus_design_spell()
 * refuses. */
MUS_API mus_status mus_design_draft_words(mus_context *context, const char *words, const mus_tape *tape,
                                          const mus_draft_def *def, mus_pattern **out);

/* ---- sizes ---- */

/**
 * Grade rules: the displacement of each point of `from` to its position in `to`, the same design drafted for another
 * size.
 *
 * Points are matched by the names of their panels and of the edges that end in them; a point without a match gets NaN.
 * Shapes:  rules (points of `from` x 2) [m]; *count: number of points with a rule, may be NULL
 * Errors:  MUS_ERR_ARG
 */
MUS_API mus_status mus_design_grade(const mus_pattern *from, const mus_pattern *to, double *rules, int32_t *count);

/**
 * Copy a pattern with each point moved by its rule. Points between the ends of an edge move by the mean of both rules,
 * weighted by arc length; the ease of a seam becomes the difference of the new lengths. Meant for files that carry
 * rules: drafting a size is exact.
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
 * Ease of a garment at bust, waist and hip: its girth less that of the body, by a horizontal cut through the panels
 * that are placed upright round the torso. NaN at a height that it does not reach.
 *
 * Shapes:  ease (MUS_EASE_COUNT) [m]
 * Errors:  MUS_ERR_ARG, MUS_ERR_TAPE
 */
MUS_API mus_status mus_design_ease(const mus_pattern *pattern, const mus_tape *tape, double *ease);

#ifdef __cplusplus
}
#endif

#endif
