/*
 * diagnosis.h: the reason that a run of sew or settle ended as it did (diagnosis.c).
 */
#ifndef MUS_DRESS_DIAGNOSIS_H
#define MUS_DRESS_DIAGNOSIS_H

#include "drape/drape_state.h"

/* note how a run ended; panel, seam and node may be MUS_NONE; text is the sentence */
void mus__diagnosis_set(mus_drape *drape, int32_t kind, int32_t panel, int32_t seam, int32_t node, double value,
                        const char *text);
/* after sew or settle: note what its status says. Returns that status, or MUS_ERR_MEMORY where crossings could not be
 * counted */
mus_status mus__diagnosis_status(mus_drape *drape, mus_status status);

#endif
