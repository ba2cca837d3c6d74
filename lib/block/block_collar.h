/*
 * block_collar.h: blocks of what stands at the neck: stand, leaf, hood.
 *
 * Drawn in metre with the centre back at x = 0, the left half towards x > 0.
 */
#ifndef MUS_BLOCK_COLLAR_H
#define MUS_BLOCK_COLLAR_H

#include "block/chain.h"
#include "block/measures.h"

typedef struct mus__stand_def {
    double length; /* of the bottom edge, centre back to front */
    double height; /* at the centre back; 0.85 of it in front */
    double rise;   /* of the bottom edge at the front: 0 stands away from the neck, 3 cm close to it */
} mus__stand_def;

/* a collar that stands: mandarin, or what a shirt collar's leaf is sewn to */
typedef struct mus__stand {
    double bottom[8], top[8]; /* centre back to front */
    double bottom_length, top_length;
} mus__stand;

mus_status mus__stand_draft(mus_context *context, const mus__stand_def *def, mus__stand *out);

typedef struct mus__leaf_def {
    double length; /* of the inner edge, centre back to front */
    double fall;   /* depth at the centre back */
    double point;  /* depth at the front, to the point */
    double rise;   /* of the inner edge at the front: < 0 bends against the stand */
} mus__leaf_def;

/* the part of a shirt collar that falls over its stand: inner edge above, y = 0 at the centre back */
typedef struct mus__leaf {
    double inner[8], outer[8]; /* centre back to front */
    double inner_length, outer_length;
} mus__leaf;

mus_status mus__leaf_draft(mus_context *context, const mus__leaf_def *def, mus__leaf *out);

typedef struct mus__hood_def {
    double length; /* of the neck edge, front to centre back */
    double head;   /* girth */
} mus__hood_def;

/* a half hood with its face edge on the line x = 0 or so and its back at x = width */
typedef struct mus__hood {
    double neck[8];  /* front to centre back */
    double crown[8]; /* centre back up and forward */
    double top[2];   /* where the crown, going on straight, meets the face edge */
    double width, height;
    double neck_length, crown_length, face_length;
} mus__hood;

mus_status mus__hood_draft(mus_context *context, const mus__hood_def *def, mus__hood *out);

#endif
