/* pose_table.h: tables of named poses and movements, for move.c. */
#ifndef MUS_POSE_POSE_TABLE_H
#define MUS_POSE_POSE_TABLE_H

#include "base/base_internal.h"
#include "muslin/pose.h"

#define MUS__MOVE_KEYS 12 /* most of a named movement */

/* a named pose; false for an unknown name */
bool mus__pose_find(const char *name, mus_pose *out);
/* number of a named movement, MUS_NONE for an unknown name and for NULL */
int32_t mus__move_find(const char *name);
/* keys, their times and the period (0: none) of named movement `move` for a body of that stature; their number */
int32_t mus__move_keys(int32_t move, double stature, double *times, mus_pose *poses, double *period);

#endif
