/*
 * canonical_form.h: the data of the canonical form: the quotient with the members of each class, labels as numbers,
 * and the arrays of a walk (canonical_form.c tells the method).
 */
#ifndef MUS_TOPOLOGY_CANONICAL_FORM_H
#define MUS_TOPOLOGY_CANONICAL_FORM_H

#include "topology/quotient.h"

/* a place of a walk where panels of equal colour were to choose from */
typedef struct mus__form_choice {
    int32_t options, taken;
    int32_t *word; /* (first_length) the first word below its first option */
    int32_t first_length, room;
} mus__form_choice;

typedef struct mus__form_word {
    const int32_t *value;
    int32_t n;
} mus__form_word;

typedef struct mus__form {
    mus_context *context;
    const mus_pattern *pattern;
    mus__quotient q;
    int32_t way;  /* +1 along the words, -1 against them: the mirror image */
    int64_t most; /* bound of the numbers in the words of all components: 3 a panel and 3 a position */

    /* labels: sorted texts, and the number of each */
    int32_t nlabel;
    const char **label;   /* (nlabel) */
    int32_t *panel_label; /* (npanel) */
    int32_t *edge_label;  /* (nedge) */

    /* classes */
    int32_t *along;        /* (nword) +1 the word runs as the root of the class does */
    int32_t *folded;       /* (nedge) by class: sewn to itself end over end */
    int32_t *member_first; /* (nedge + 1) by class */
    int32_t *member;       /* (nword) positions by class */

    /* colours */
    uint64_t *base, *color, *next_color, *sorted; /* (nword) of the component; of the walk at hand; scratch */

    /* a walk */
    int32_t norder, nmet, nmark, nword, nbest, fixed, nchoice, choice_room, tries;
    int32_t *order, *piece, *entry;            /* (npanel) panels as entered; a copy; where each is entered */
    int32_t *class_number, *class_first, *met; /* (nedge) by class; classes with a number */
    int32_t *word, *best;                      /* (most) */
    mus__form_choice *choice;                  /* (nchoice), those up to `fixed` given */
    int32_t *block;
} mus__form;

/* quotient, labels, classes, and room for walks; free with mus__form_free, after a failure too. Without `labels` all
 * labels are "". Errors: MUS_ERR_PATTERN (a panel without outline), MUS_ERR_MEMORY, MUS_ERR_LIMIT */
mus_status mus__form_make(const mus_pattern *pattern, bool labels, mus__form *out);
void mus__form_free(mus__form *form);

#endif
