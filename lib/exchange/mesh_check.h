/*
 * mesh_check.h: meshes checked before a byte of a file is written.
 */
#ifndef MUS_EXCHANGE_MESH_CHECK_H
#define MUS_EXCHANGE_MESH_CHECK_H

#include "muslin/exchange.h"

/* check views before a byte is written: sizes, counts, finite numbers, indices */
mus_status mus__mesh_check(mus_context *context, int32_t n, const mus_mesh_view *meshes);
/* keys of meshes in motion, which are checked already as meshes */
#define MUS__MESH_KEYS 4096
mus_status mus__mesh_check_motion(mus_context *context, int32_t n, const mus_mesh_view *meshes, int32_t keys,
                                  const double *times, const mus_mesh_motion *motion);

#endif
