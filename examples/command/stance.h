/* stance.h: the pose of a body by the options --pose, or --move and --at. */
#ifndef MUSLIN_STANCE_H
#define MUSLIN_STANCE_H

#include "scene.h"

/* The options; NULL when not given. */
typedef struct stance {
    const char *pose, *move;
    double at;
} stance;

/* Replaces *body by a posed copy, feet on the floor and arms off the sides. Without --pose and --move it is kept. */
mus_status stance_take(const scene *s, const stance *how, mus_body **body);

#endif
