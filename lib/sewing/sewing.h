/*
 * sewing.h: how a pattern is sewn: its seams in words, their order, and the sheet of instructions.
 *
 * Flow of the data: pattern -> seams with kinds and words, sorted by them (sewing_seams.c) -> lines and steps
 * (sewing_order.c) -> text (sewing_text.c, sewing_cloth.c, sewing_finish.c) -> file (lib/file). Sorted by words,
 * nothing here depends on the order in which the pattern has its panels, edges and seams.
 */
#ifndef MUS_SEWING_H
#define MUS_SEWING_H

#include "drawing/drawing.h"
#include "drawing/plain_words.h"

#define MUS__PHRASE (4 * MUS__PLAIN + 32) /* [bytes] both sides of a seam in words */

/* what a step does, in the order of the work */
typedef enum mus__sewing_kind {
    MUS__SEWING_DART,    /* darts, and the layers of pleats */
    MUS__SEWING_PATCH,   /* panels onto lines inside others */
    MUS__SEWING_SEAM,    /* seams, and zips */
    MUS__SEWING_BUTTONS, /* closures with buttons */
    MUS__SEWING_TIES     /* fronts that are tied */
} mus__sewing_kind;

/* a seam; side 0 is the patch, else the side whose words come first */
typedef struct mus__sewn {
    int32_t seam; /* of the pattern */
    mus__sewing_kind kind;
    int32_t edge[2], panel[2]; /* of each side */
    int32_t point[2][2];       /* two pairs of ends, one of each side, that the seam makes one */
    double length[2];          /* [m] */
    double tolerance;          /* difference of the lengths that is none [m] */
    int32_t notches;           /* on both sides */
    int32_t buttons;
    bool zip, laid;
    int32_t family, twins; /* first seam that differs in left and right alone, and how many such seams there are */
    long millimetres;      /* length of the first seam of the family, side 0 */
    int32_t line;          /* first seam of the line that it is stitched in */
    int32_t next;          /* next seam of the line, or MUS_NONE */
    int32_t step;
    char words[2][2][2 * MUS__PLAIN]; /* of each side: panel and edge, without left and right, and with them */
    char phrase[MUS__PHRASE];         /* as it is told, in English */
} mus__sewn;

typedef struct mus__sewing_step {
    mus__sewing_kind kind;
    int32_t rings; /* change of the first Betti number of what is sewn: above 0 the step closes rings */
    int32_t joins; /* by how many the number of loose parts falls */
} mus__sewing_step;

typedef struct mus__sewing {
    mus_context *context;
    const mus_pattern *pattern;
    int32_t n, nstep;
    mus__sewn *sewn;         /* (n) in the order of the pattern */
    mus__sewn **by_words;    /* (n) sorted; family, line and next are indices of it */
    mus__sewing_step *steps; /* (n) the first nstep are used */
    int32_t *passes;         /* (edges) how often an outline passes each edge: twice for a line inside a panel */
    int32_t *notches;        /* (edges) number of notches on each */
} mus__sewing;

/* ---- seams (sewing_seams.c) ---- */

/* read and sort the seams of a pattern; mus__sewing_free() frees them, also after a failure */
mus_status mus__sewing_make(mus_context *context, const mus_pattern *pattern, mus__sewing *out);
void mus__sewing_free(mus__sewing *sewing);
/* write both sides of a seam in words (MUS__PHRASE), in a language; left and right are left out where all of the
 * family are told together */
void mus__sewing_phrase(const mus_pattern *pattern, const mus__sewn *sewn, int32_t language, char *out);

/* ---- order (sewing_order.c) ---- */

/* set line, next and step of all seams, and the steps */
mus_status mus__sewing_order(mus__sewing *sewing);

#endif
