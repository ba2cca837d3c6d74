/*
 * failure_reason.h: reasons as the rooms of arrange and drape write them.
 */
#ifndef MUS_ARRANGE_FAILURE_REASON_H
#define MUS_ARRANGE_FAILURE_REASON_H

#include "base/base_internal.h"
#include "muslin/arrange.h"

/* a reason of a kind with its sentence, without panel, seam, node and place */
void mus__reason_write(mus_reason *out, int32_t kind, const char *text);
/* a start that is tangled; panel and seam may be MUS_NONE */
void mus__reason_start_tangled(mus_reason *out, int32_t panel, int32_t seam, const char *text);
/* copy a reason to the caller's struct. Errors: MUS_ERR_VERSION (a size that is not known) */
mus_status mus__reason_give(mus_context *context, const mus_reason *own, mus_reason *out);

#endif
