/* pose_table.h: the tables of named poses and named movements (pose_table.c, movement_table.c). */
#ifndef MUS_POSE_POSE_TABLE_H
#define MUS_POSE_POSE_TABLE_H

#include "base/base_internal.h"
#include "muslin/pose.h"

#define MUS__MOVE_KEYS 12 /* most keys of a named movement; the walk has 10 */

/* get a named pose; false: the name is unknown */
bool mus__pose_find(const char *name, mus_pose *out);
/* index of a named movement; MUS_NONE for an unknown name and for NULL */
int32_t mus__move_find(const char *name);
/* times (MUS__MOVE_KEYS) [s], poses (MUS__MOVE_KEYS) and period [s] (0: it ends) of named movement `move` for a stature
 * [m]; returns the number of keys */
int32_t mus__move_keys(int32_t move, double stature, double *times, mus_pose *poses, double *period);
/* feet that stand at a key of a named movement */
int32_t mus__move_feet(int32_t move, int32_t key);

#endif
