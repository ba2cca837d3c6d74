/*
 * block_collar.h: the collar blocks: stand, leaf and hood.
 *
 * Drawn in metre with the centre back at x = 0, the left half towards x > 0.
 */
#ifndef MUS_BLOCK_COLLAR_H
#define MUS_BLOCK_COLLAR_H

#include "block/block_curve.h"
#include "block/measures.h"

typedef struct mus__stand_def {
    double length; /* length of the bottom edge from centre back to front */
    double height; /* height at the centre back; the front is 0.85 of it */
    double rise;   /* of the bottom edge at the front: with 0 the stand leans off the neck, with 3 cm it follows it */
} mus__stand_def;

/* a standing collar: a mandarin collar, or the stand of a shirt collar */
typedef struct mus__stand {
    double bottom[8], top[8]; /* centre back to front */
    double top_length;
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
} mus__leaf;

mus_status mus__leaf_draft(mus_context *context, const mus__leaf_def *def, mus__leaf *out);

typedef struct mus__hood_def {
    double length; /* length of the neck edge from front to centre back */
    double head;   /* girth of the head */
} mus__hood_def;

/* half a hood: its face edge near the line x = 0, its back at x = width */
typedef struct mus__hood {
    double neck[8];  /* front to centre back */
    double crown[8]; /* centre back up and forward */
    double top[2];   /* corner of the straight end of the crown and the face edge */
    double width, height;
} mus__hood;

mus_status mus__hood_draft(mus_context *context, const mus__hood_def *def, mus__hood *out);

#endif
