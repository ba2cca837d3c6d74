/*
 * hood_back.h: a hood that would hang over the face is drawn back (hood_back.c).
 */
#ifndef MUS_DRESS_HOOD_BACK_H
#define MUS_DRESS_HOOD_BACK_H

#include "dress/progress.h"
#include "fit/worn_hood.h"

/* draw the face edge of a sewn hood back over the head, and hold it there: *hood, whose nodes are pinned until
 * mus__hood_release(). hood->count is 0 where there is nothing to draw, and where the call fails. Errors: those of
 * mus__relax_run(), MUS_ERR_MEMORY */
mus_status mus__hood_back(mus_drape *drape, const mus_pattern *pattern, const mus_body *body, mus__progress *run,
                          mus__hood_edge *hood);
/* let go of the edge. Errors: MUS_ERR_MEMORY */
mus_status mus__hood_release(mus_drape *drape, mus__hood_edge *hood);

#endif
