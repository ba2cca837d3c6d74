/*
 * laid_on.h: the start of a panel that lies on the worn cloth it is sewn to.
 */
#ifndef MUS_DRESS_LAID_ON_H
#define MUS_DRESS_LAID_ON_H

#include "drape/drape_state.h"

/* [m] distance from a panel, or a seam, within which the body is looked for */
#define MUS__LAYERS_REACH 0.3

/* place the nodes of a panel that lies on another (mus__panel_mesh.lies) in drape->x, `out` [m] off the worn cloth.
 * Errors: MUS_ERR_MEMORY. Cost: pairs times triangles of the cloth, and pairs times nodes of the panel */
mus_status mus__laid_place(mus_drape *drape, int32_t panel, double out);

#endif
