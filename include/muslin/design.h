/*
 * muslin/design.h: garments drafted from the tape.
 *
 * A design is a named recipe: blocks (bodice, sleeve, skirt) drafted to the measures, made into a pattern with seams,
 * notches, grain and placement round the body. Formulas: man page mus_design(3).
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

/** Index of a design by name, MUS_NONE if unknown. */
MUS_API int32_t mus_design_find(const char *name);

/** Options of a draft; NaN takes the design's own value. */
typedef struct mus_draft_def {
    size_t size;
    double ease;   /* total ease on the bust (tops) or hip (skirts) [m] */
    double length; /* tops: waist to hem; skirts: waist to hem [m] */
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

#ifdef __cplusplus
}
#endif

#endif
