/*
 * sewing.h: how a pattern is sewn: its seams in words, their order, and the sheet of instructions.
 *
 * Flow of the data: pattern -> seams with kinds and words, sorted by them (sewing_seams.c) -> lines and steps
 * (sewing_order.c) -> text (sewing_text.c, sewing_finish.c) -> file (lib/file). Sorted by words, nothing here depends
 * on the order in which the pattern has its panels, edges and seams.
 */
#ifndef MUS_SEWING_H
#define MUS_SEWING_H

#include "print/drawing.h"

#define MUS__WORDS 128 /* [bytes] of a name in words with its zero byte; longer ones are cut; chosen */
#define MUS__PHRASE (4 * MUS__WORDS + 32) /* [bytes] both sides of a seam in words */

/* what a step does, in the order of the work */
typedef enum mus__sewing_kind {
    MUS__SEWING_DART,   /* darts, and the layers of pleats */
    MUS__SEWING_PATCH,  /* panels onto lines inside others */
    MUS__SEWING_SEAM,   /* seams, and zips */
    MUS__SEWING_BUTTONS /* closures with buttons */
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
    char words[2][2][2 * MUS__WORDS]; /* of each side: panel and edge, without left and right, and with them */
    char phrase[MUS__PHRASE];         /* as it is told */
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

/* ---- words (sewing_words.c) ---- */

/* write a name as words; without the words left and right, and the r of a mirrored edge, when `sideless` */
void mus__sewing_words(const char *name, bool sideless, char *out);
/* write what an edge is called: its label, else its name, without digits; "edge" without both */
void mus__sewing_edge_words(const mus_pattern *pattern, int32_t edge, char *out);

/* ---- seams (sewing_seams.c) ---- */

/* read and sort the seams of a pattern; mus__sewing_free() frees them, also after a failure */
mus_status mus__sewing_make(mus_context *context, const mus_pattern *pattern, mus__sewing *out);
void mus__sewing_free(mus__sewing *sewing);

/* ---- order (sewing_order.c) ---- */

/* set line, next and step of all seams, and the steps */
mus_status mus__sewing_order(mus__sewing *sewing);

/* ---- text (sewing_list.c, sewing_finish.c, sewing_text.c) ---- */

/* words that one sentence lists */
typedef struct mus__words_list {
    char (*words)[MUS__WORDS];
    int32_t n;
} mus__words_list;

typedef struct mus__instructions {
    const mus_pattern *pattern;
    const mus_pattern *extra; /* panels that are cut and not draped, or NULL */
    mus__sewing sewing;
    char (*finishes)[MUS__WORDS]; /* (panels of `extra`) words of the edges that each finishes, "" for none */
    bool *free;                   /* (edges) finished for itself: cut, in no seam, and of one layer */
    mus__words_list list;         /* room for a word of each panel and each panel of `extra` */
    mus__sink sink;
    int32_t number; /* of the last step */
} mus__instructions;

/* write a length [m] as centimetres with one decimal, in every locale */
void mus__tell_length(mus__sink *sink, double length);
/* add the name of a panel to the list */
void mus__list_add(mus__instructions *job, const mus_pattern *pattern, int32_t panel);
/* write "a, b, c" and empty the list; a last number is left out, and equal words are told once */
void mus__list_tell(mus__instructions *job);
/* write a step: `head`, the list, `tail`; nothing when the list is empty */
void mus__list_step(mus__instructions *job, const char *head, const char *tail);
/* number of copies to cut of a panel or of the one that it is the mirror image of */
int32_t mus__tell_copies(const mus_pattern *pattern, int32_t panel, int32_t material);
/* is a panel printed, and not as the image of another? */
bool mus__tell_printed(const mus_pattern *pattern, int32_t panel);
/* has a panel an image, or is it one? */
bool mus__tell_mirrored(const mus_pattern *pattern, int32_t panel);
/* is a panel sewn as two layers: cut twice without an image, or four times with one, or lined? */
bool mus__tell_double(const mus_pattern *pattern, int32_t panel);
/* length of the longest edge of a panel [m] */
double mus__tell_longest(const mus_pattern *pattern, int32_t panel);
/* has a panel a mark of that name? */
bool mus__tell_has_mark(const mus_pattern *pattern, int32_t panel, const char *mark);

/* set what the panels finish that are cut and not draped */
void mus__finish_find(mus__instructions *job);
/* write the steps of panels that are cut and not draped, and that no edge and no mark asks for: those that come before
 * the seams, or after them */
void mus__tell_parts(mus__instructions *job, bool last);
/* write the steps that finish the free edges */
mus_status mus__tell_finish(mus__instructions *job);

#endif
