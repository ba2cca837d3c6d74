/*
 * cut_outline.c: the outline of a panel without the lines inside it.
 *
 * An outline may leave the cut line along a bridge, pass a line inside the panel and come back over both. Nothing is
 * cut there: the line has the panel on both sides, two sheets of one edge, and a patch pocket that is sewn to it is the
 * third. The line that is cut on the table is the free reduction of the cyclic word: an edge followed by the same edge
 * back is taken out, until there is none.
 */
#include "pattern/pattern_internal.h"


/* positions of the reduced word in the word of a panel, in order, into kept (noutline). Returns their number; they
 * begin at kept[*first], because edges that cancel over the start of the word are left before it */
static int32_t inner_reduce(const mus__panel *panel, int32_t *kept, int32_t *first)
{
    const int32_t n = panel->noutline, *edge = panel->outline, *turn = panel->outline + n;
    int32_t top = 0, low = 0;
    for (int32_t k = 0; k < n; k++) {
        const bool back = top > 0 && edge[kept[top - 1]] == edge[k] && turn[kept[top - 1]] != turn[k];
        if (back) top--;
        else kept[top++] = k;
    }
    while (top - low >= 2 && edge[kept[low]] == edge[kept[top - 1]] && turn[kept[low]] != turn[kept[top - 1]])
        low++, top--;
    *first = low;
    return top - low;
}


mus_status mus_pattern_rim(const mus_pattern *pattern, int32_t panel, int32_t *edges, int32_t *directions,
                           int32_t capacity, int32_t *count)
{
    if (count != NULL) *count = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    const mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    const mus__panel *own = &pattern->panel[panel];
    if (capacity < 0)
        return mus__fail(context, MUS_ERR_ARG, "rim of panel %s: room for %d edges", own->name, (int)capacity);
    if (own->noutline == 0) return mus__fail(context, MUS_ERR_PATTERN, "panel %s has no outline", own->name);

    int32_t first, *kept = mus__room(context, own->noutline, sizeof *kept);
    if (kept == NULL) return mus__fail_memory(context, "the rim of a panel");
    const int32_t n = inner_reduce(own, kept, &first);
    for (int32_t i = 0; i < n && i < capacity; i++) {
        const int32_t k = kept[first + i];
        if (edges != NULL) edges[i] = own->outline[k];
        if (directions != NULL) directions[i] = own->outline[own->noutline + k];
    }
    mus__free(context, kept);
    if (count != NULL) *count = n;
    return MUS_OK;
}
