/*
 * mesh_check.h: the check of meshes before a file is written.
 */
#ifndef MUS_MESHFILE_MESH_CHECK_H
#define MUS_MESHFILE_MESH_CHECK_H

#include "muslin/exchange.h"

/* check the sizes, counts, numbers and indices of n meshes */
mus_status mus__mesh_check(mus_context *context, int32_t n, const mus_mesh_view *meshes);
/* most keys of a motion; chosen: each adds 4 bytes for every other key and mesh */
#define MUS__MESH_KEYS 4096
mus_status mus__mesh_check_motion(mus_context *context, int32_t n, const mus_mesh_view *meshes, int32_t keys,
                                  const double *times, const mus_mesh_motion *motion);

#endif
