/*
 * sewing_text.h: the sentences of the instructions: what sewing_list.c, sewing_finish.c and sewing_text.c share.
 */
#ifndef MUS_SEWING_TEXT_H
#define MUS_SEWING_TEXT_H

#include "drawing/phrase.h"
#include "sewing/sewing.h"

/* words that one sentence lists */
typedef struct mus__words_list {
    char (*words)[MUS__PLAIN];
    int32_t n;
} mus__words_list;

typedef struct mus__instructions {
    const mus_pattern *pattern;
    const mus_pattern *extra; /* panels that are cut and not draped, or NULL */
    int32_t language;
    mus__sewing sewing;
    char (*finishes)[MUS__PLAIN]; /* (panels of `extra`) words of the edges that each finishes, "" for none */
    bool *free;                   /* (edges) finished for itself: cut, in no seam, and of one layer */
    mus__words_list list;         /* room for a word of each edge, each panel and each panel of `extra` */
    mus__sink sink;
    int32_t number; /* of the last step */
} mus__instructions;

#define MUS__LENGTH 32 /* [bytes] of a length with its zero byte */

/* write a length [m] as centimetres with one decimal, by the language and not by the locale; returns `out` */
const char *mus__tell_length(const mus__instructions *job, double length, char *out);
/* write the English words of a "panel" or an "edge" as they are told; returns `out` (MUS__PLAIN) */
const char *mus__tell_words(const mus__instructions *job, const char *kind, const char *words, char *out);
/* write a step: its number and the row of a key */
void mus__tell_step(mus__instructions *job, const mus__phrase *phrase, const char *key);
/* add the name of a panel to the list */
void mus__list_add(mus__instructions *job, const mus_pattern *pattern, int32_t panel);
/* add the words of an edge of the pattern to the list, once */
void mus__list_add_edge(mus__instructions *job, int32_t edge);
/* the words of the list, of the kind "panel" or "edge", as "a, b, c", which the caller frees by mus__print_free(); a
 * last number is left out, and equal words are told once. The list is empty after it. NULL without memory, which the
 * sink remembers */
char *mus__list_take(mus__instructions *job, const char *kind);
/* write a step of a key with the list in place 0; nothing when the list is empty */
void mus__list_step(mus__instructions *job, mus__phrase *phrase, const char *key);
/* number of copies to cut of a panel or of the one that it is the mirror image of */
int32_t mus__tell_copies(const mus_pattern *pattern, int32_t panel, int32_t material);
/* is a panel printed, and not as the image of another? */
bool mus__tell_printed(const mus_pattern *pattern, int32_t panel);
/* has a panel an image, or is it one? */
bool mus__tell_mirrored(const mus_pattern *pattern, int32_t panel);
/* the panel of those that are not draped that is the second layer of a panel: an under-collar; MUS_NONE without one */
int32_t mus__tell_layer(const mus_pattern *pattern, int32_t panel);
/* is a panel sewn as two layers: cut twice without an image, or four times with one, or lined, or with an
 * under-collar? */
bool mus__tell_double(const mus_pattern *pattern, int32_t panel);
/* length of the longest or the shortest edge of a panel [m] */
double mus__tell_edge(const mus_pattern *pattern, int32_t panel, bool longest);
/* has a panel a mark of that name? */
bool mus__tell_has_mark(const mus_pattern *pattern, int32_t panel, const char *mark);

/* is an edge the free one of a strip that is folded along its line "fold"? */
bool mus__tell_folded(const mus_pattern *pattern, int32_t edge);
/* is a panel a rib that is folded before it is sewn to another that is none? */
bool mus__tell_rib_folds(const mus__instructions *job, int32_t panel, int32_t other);

/* write the metres of cloth of each material (sewing_cloth.c) */
mus_status mus__tell_cloth(mus__instructions *job);
/* set what the panels finish that are cut and not draped */
void mus__finish_find(mus__instructions *job);
/* write the steps of panels that are cut and not draped, and that no edge and no mark asks for: those that come before
 * the seams, or after them */
void mus__tell_parts(mus__instructions *job, bool last);
/* write the step of the panels whose second layer is sewn by the row of a key: "step.layers_first" after the step that
 * joins them to their mirror images (MUS_NONE: those without one), or others after the seams */
void mus__tell_layers(mus__instructions *job, const char *key, int32_t step);
/* write the steps that finish the free edges */
mus_status mus__tell_finish(mus__instructions *job);

#endif
