/*
 * plain_words.h: names of panels and edges as the words that a sewer reads, on paper and in the instructions.
 */
#ifndef MUS_DRAWING_PLAIN_WORDS_H
#define MUS_DRAWING_PLAIN_WORDS_H

#include <stdbool.h>
#include <stdint.h>

#include "muslin/pattern.h"

#define MUS__PLAIN 128 /* [bytes] of a name in words with its zero byte; longer ones are cut; chosen */

/* write a name as words; without the words left and right, and the r of a mirrored edge, when `sideless` */
void mus__plain_words(const char *name, bool sideless, char *out);
/* write what an edge is called: its label, else its name, without digits; "edge" without both */
void mus__plain_edge_words(const mus_pattern *pattern, int32_t edge, char *out);
/* write what an edge is called by its name alone */
void mus__plain_edge_name(const mus_pattern *pattern, int32_t edge, char *out);
/* write the English words of a "panel" or an "edge" in a language */
void mus__plain_words_in(int32_t language, const char *kind, const char *words, char *out);

#endif
