/*
 * layout_parts.c: what is laid on the cloth: pieces on open cloth, pairs through two layers, halves on the fold.
 */
#include <math.h>

#include "layout/layout_internal.h"


/* whether two layers give two pieces that are alike or a mirrored pair as asked. The lower layer gives the mirror image
 * in a line along the grain: the same for a piece that is symmetric in such a line; for one that is symmetric across
 * the grain it is the piece turned by half a turn, which nap forbids */
static bool parts_pair(const mus_layout *layout, const mus__layout_outline *outline)
{
    return outline->mirrored || outline->symmetric || (outline->across && layout->def.nap == 0);
}


/* whether an outline is as wide as `width` at most, across the cloth */
static bool parts_fit(const mus__layout_outline *outline, double width)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int32_t i = 0; i < outline->cut.n; i++) {
        low = fmin(low, outline->cut.xy[2 * i + 1]);
        high = fmax(high, outline->cut.xy[2 * i + 1]);
    }
    return high - low <= width + MUS__LAYOUT_ROUNDING;
}


static mus_status parts_add(mus_layout *layout, int32_t *room, int32_t count, const mus__layout_part *part)
{
    if (layout->npart + count > MUS__LAYOUT_MOST)
        return mus__fail(layout->context, MUS_ERR_LIMIT, "the layout has more than %d pieces", MUS__LAYOUT_MOST);
    const mus_status status =
        mus__reserve(layout->context, &layout->parts, room, layout->npart + count, sizeof *layout->parts);
    if (status != MUS_OK) return mus__fail_memory(layout->context, "the pieces of a layout");
    for (int32_t k = 0; k < count; k++) layout->parts[layout->npart++] = *part;
    return MUS_OK;
}


/* add `count` pieces of an outline, half of them turned over when it is mirrored, to open cloth */
static mus_status parts_open(mus_layout *layout, int32_t *room, int32_t outline, int32_t count)
{
    const int32_t over = layout->outlines[outline].mirrored ? count / 2 : 0;
    const mus__layout_part plain = {.outline = outline, .lie = MUS__LIE_PLAIN};
    const mus__layout_part mirrored = {.outline = outline, .lie = MUS__LIE_MIRRORED};
    const mus_status status = parts_add(layout, room, count - over, &plain);
    return status == MUS_OK ? parts_add(layout, room, over, &mirrored) : status;
}


mus_status mus__layout_parts(mus_layout *layout, bool doubled, int32_t *singles)
{
    const double width = layout->def.width;
    int32_t room = 0, about = 0;
    mus__free(layout->context, layout->parts);
    layout->parts = NULL;
    layout->npart = 0;
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < layout->noutline && status == MUS_OK; k++) {
        const mus__layout_outline *outline = &layout->outlines[k];
        const mus__layout_part pair = {.outline = k, .lie = MUS__LIE_EITHER, .folded = true};
        const mus__layout_part half = {.outline = k, .lie = MUS__LIE_HALF, .folded = true};
        const mus__layout_part spare = {.outline = k, .lie = MUS__LIE_EITHER, .folded = true, .spare = true};
        const bool fits = parts_fit(outline, 0.5 * width);
        const bool pairs = layout->def.fold != 0 && fits && parts_pair(layout, outline);
        int32_t left = outline->count;
        if (pairs) {
            status = parts_add(layout, &room, left / 2, &pair);
            left %= 2;
        }
        if (status != MUS_OK || left == 0) continue;
        if (layout->def.fold != 0 && outline->symmetric && parts_fit(outline, width)) {
            status = parts_add(layout, &room, left, &half);
        } else if (layout->def.fold != 0 && fits) {
            about += left;
            status = doubled ? parts_add(layout, &room, left, &spare) : parts_open(layout, &room, k, left);
        } else {
            status = parts_open(layout, &room, k, left);
        }
    }
    if (singles != NULL) *singles = about;
    return status;
}
