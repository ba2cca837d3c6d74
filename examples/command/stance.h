/* stance.h: how the body of a command stands: --pose, or --move and --at. */
#ifndef MUSLIN_STANCE_H
#define MUSLIN_STANCE_H

#include "scene.h"

/* Texts of the options, NULL when not given. */
typedef struct stance {
    const char *pose, *move;
    double at;
} stance;

/* Put a posed copy in place of *body; feet on the floor, arms off the sides. Without pose and move it stays. */
mus_status stance_take(const scene *s, const stance *how, mus_body **body);

#endif
