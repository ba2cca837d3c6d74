/*
 * undo_history.c: the states of a pattern before its last edits: undo and redo.
 *
 * An edit makes a new pattern and exchanges the contents, so the old state is there as a whole, and keeping it costs
 * only its bytes (some 100 kB for a dress). Undo exchanges the contents again: every bit is as it was. The last entry
 * of each list is the next one to use; a full list loses its first.
 */
#include <string.h>

#include "edit/edit_internal.h"

#define HISTORY_MOST 1000 /* most edits kept; chosen: 100 MB of a dress */


void mus__pattern_swap(mus_pattern *a, mus_pattern *b)
{
    mus_pattern swap = *a;
    mus__history *history[2] = {a->history, b->history};
    *a = *b;
    *b = swap;
    a->history = history[0];
    b->history = history[1];
}


void mus__history_done(mus_pattern *pattern, mus_pattern *before)
{
    mus__history *history = pattern->history;
    if (history == NULL) {
        mus_pattern_destroy(before);
        return;
    }
    mus__history_forget_undone(pattern);
    if (history->ndone == history->depth) {
        mus_pattern_destroy(history->done[0]);
        history->ndone--;
        memmove(history->done, history->done + 1, (size_t)history->ndone * sizeof *history->done);
    }
    history->done[history->ndone++] = before;
}


mus_status mus_pattern_keep_history(mus_pattern *pattern, int32_t depth)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (depth < 0 || depth > HISTORY_MOST)
        return mus__fail(context, MUS_ERR_ARG, "history: a depth of %d edits is outside 0 to %d", (int)depth,
                         HISTORY_MOST);
    if (depth == (pattern->history != NULL ? pattern->history->depth : 0)) return MUS_OK;
    mus__history *history = NULL;
    if (depth > 0) {
        const size_t lists = 2 * (size_t)depth * sizeof *history->done;
        history = mus__new(context, (int64_t)(sizeof *history + lists), 1);
        if (history == NULL) return mus__fail_memory(context, "the history of a pattern");
        history->depth = depth;
        history->done = (mus_pattern **)(void *)(history + 1);
        history->undone = history->done + depth;
    }
    mus__history_end(pattern);
    pattern->history = history;
    return MUS_OK;
}


/* exchange the pattern with the last entry of one list, and append the old state to the other list */
static mus_status history_step(mus_pattern *pattern, const char *what, mus_pattern **from, int32_t *nfrom,
                               mus_pattern **to, int32_t *nto)
{
    if (*nfrom == 0) return mus__fail(pattern->context, MUS_ERR_ARG, "%s: there are 0 edits to %s", what, what);
    mus_pattern *other = from[--*nfrom];
    mus__pattern_swap(pattern, other);
    to[(*nto)++] = other;
    return MUS_OK;
}


mus_status mus_pattern_undo(mus_pattern *pattern)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus__history none = {0}, *h = pattern->history != NULL ? pattern->history : &none;
    return history_step(pattern, "undo", h->done, &h->ndone, h->undone, &h->nundone);
}


mus_status mus_pattern_redo(mus_pattern *pattern)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus__history none = {0}, *h = pattern->history != NULL ? pattern->history : &none;
    return history_step(pattern, "redo", h->undone, &h->nundone, h->done, &h->ndone);
}


int32_t mus_pattern_undo_count(const mus_pattern *pattern)
{
    return pattern != NULL && pattern->history != NULL ? pattern->history->ndone : 0;
}


int32_t mus_pattern_redo_count(const mus_pattern *pattern)
{
    return pattern != NULL && pattern->history != NULL ? pattern->history->nundone : 0;
}
