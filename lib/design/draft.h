/*
 * draft.h: a draft: its inputs read, a style drafted, the pattern checked.
 */
#ifndef MUS_DRAFT_H
#define MUS_DRAFT_H

#include "block/measures.h"
#include "limb/skeleton.h"
#include "half/style_axes.h"
#include "muslin/design.h"

/* Reads the options of the caller (NaN where not given), and the measures and skeleton of a tape, completed on a
 * copy. */
mus_status mus__design_read(mus_context *context, const mus_tape *tape, const mus_draft_def *def,
                            mus_draft_def *wishes, mus__measures *measures, mus__skeleton *skeleton);
/* Checks a drafted pattern; its first fault is returned as MUS_ERR_DESIGN. */
mus_status mus__design_check(mus_context *context, mus_pattern *pattern);

/* design.c: drafts a style for a tape as a pattern called `name`. */
mus_status mus__style_draft(mus_context *context, const char *name, const mus__style *style, const mus_tape *tape,
                            const mus_draft_def *def, mus_pattern **out);

#endif
