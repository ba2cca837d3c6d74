/*
 * layout.c: pieces on the cloth. A stranger starts here; layout_internal.h tells the flow of the data.
 *
 * Callers: the command, examples, whoever needs the metres of cloth. Nothing else in the library needs it.
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "layout/layout_internal.h"

#define LAYOUT_TURNS_MOST 360     /* angles of an item; chosen: a whole turn by degrees */
#define LAYOUT_POINTS_MOST 100000 /* of an item; chosen: bounds the time of one test of two outlines */


void mus_layout_def_init(mus_layout_def *def, size_t size)
{
    const mus_layout_def own = {.width = 1.4,
                                .gap = 0.002,
                                .allowance = 0.01,
                                .material = MUS_MATERIAL_MAIN,
                                .steps = 1000000000,
                                .runs = 1,
                                .threads = 1,
                                .seed = 1};
    mus__def_init(def, size, &own, sizeof own);
}


void mus_layout_item_init(mus_layout_item *item, size_t size)
{
    const mus_layout_item own = {.count = 1};
    mus__def_init(item, size, &own, sizeof own);
}


void mus_layout_piece_init(mus_layout_piece *piece, size_t size)
{
    const mus_layout_piece own = {.panel = MUS_NONE};
    mus__def_init(piece, size, &own, sizeof own);
}


static mus_status layout_range(mus_context *context, const char *what, double value, double low, double high)
{
    if (value >= low && value <= high) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "mus_layout_def: %s is %g, expected %g to %g", what, value, low, high);
}


static mus_status layout_check(mus_context *context, const mus_layout_def *def)
{
    mus_status status = layout_range(context, "width", def->width, 0.01, 1e5);
    if (status == MUS_OK) status = layout_range(context, "gap", def->gap, 0.0, 0.1);
    if (status == MUS_OK) status = layout_range(context, "allowance", def->allowance, 0.0, 0.1);
    if (status == MUS_OK) status = layout_range(context, "material", def->material, 0, MUS_MATERIAL_COUNT - 1);
    if (status == MUS_OK) status = layout_range(context, "tolerance", def->tolerance, 0.0, 0.2);
    if (status == MUS_OK && def->stripe != 0.0) status = layout_range(context, "stripe", def->stripe, 0.001, 10.0);
    if (status == MUS_OK) status = layout_range(context, "steps", (double)def->steps, 1e5, 1e13);
    if (status == MUS_OK) status = layout_range(context, "runs", def->runs, 1, 64);
    if (status == MUS_OK) status = layout_range(context, "threads", def->threads, 1, 64);
    return status;
}


/* make a layout without pieces, its options checked */
static mus_status layout_make(mus_context *context, const mus_layout_def *def, mus_layout **out)
{
    mus_layout_def own;
    mus_layout_def_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, sizeof own, def, "mus_layout_def");
    if (status == MUS_OK) status = layout_check(context, &own);
    if (status != MUS_OK) return status;
    *out = mus__new(context, 1, sizeof **out);
    if (*out == NULL) return mus__fail_memory(context, "a layout");
    (*out)->context = context;
    (*out)->def = own;
    return MUS_OK;
}


/* compute the cut lines of all parts as they lie */
static mus_status layout_lay(mus_layout *layout)
{
    layout->laid = mus__new(layout->context, layout->npart, sizeof *layout->laid);
    if (layout->laid == NULL) return mus__fail_memory(layout->context, "the pieces of a layout");
    for (int32_t i = 0; i < layout->npart; i++) {
        const mus__layout_part *part = &layout->parts[i];
        const mus__layout_outline *outline = &layout->outlines[part->outline];
        const mus__layout_polygon *cut = part->lie == MUS__LIE_HALF ? &outline->half : &outline->cut;
        const mus_status status = mus__layout_polygon_make(layout->context, cut->n, &layout->laid[i]);
        if (status != MUS_OK) return status;
        for (int32_t p = 0; p < cut->n; p++) {
            const double *from = cut->xy + 2 * p;
            double *to = layout->laid[i].xy + 2 * p;
            to[0] = part->turn[0] * from[0] + part->turn[1] * from[1] + part->shift[0];
            to[1] = part->turn[2] * from[0] + part->turn[3] * from[1] + part->shift[1];
        }
    }
    return MUS_OK;
}


/* search with single pieces from opened cloth, and, if there are any, through both layers; keep the shorter layout */
static mus_status layout_search(mus_layout *layout)
{
    int32_t singles;
    mus_status status = mus__layout_parts(layout, false, &singles);
    if (status == MUS_OK) status = mus__layout_solve(layout, 0.0, singles > 0 ? 0.5 : 1.0);
    if (status != MUS_OK || singles == 0) return status;
    mus_layout first = *layout;
    layout->parts = NULL;
    status = mus__layout_parts(layout, true, NULL);
    if (status == MUS_OK) status = mus__layout_solve(layout, 0.5, 0.5);
    if (status == MUS_OK && layout->length < first.length) {
        mus__free(layout->context, first.parts);
        return MUS_OK;
    }
    mus__free(layout->context, layout->parts);
    first.steps = layout->steps;
    *layout = first;
    return status;
}


/* search and lay what `layout` was given, unless that failed already; *out gets the layout, or it is destroyed */
static mus_status layout_end(mus_layout *layout, mus_status status, mus_layout **out)
{
    if (status == MUS_OK) status = layout_search(layout);
    if (status == MUS_OK) status = layout_lay(layout);
    if (status == MUS_OK)
        *out = layout;
    else
        mus_layout_destroy(layout);
    return status;
}


mus_status mus_layout_create(mus_context *context, const mus_pattern *pattern, const mus_layout_def *def,
                             mus_layout **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL || pattern == NULL || out == NULL)
        return mus__fail(context, MUS_ERR_ARG, "mus_layout_create: context, pattern or out is NULL");
    mus_layout *layout = NULL;
    mus_status status = layout_make(context, def, &layout);
    if (status != MUS_OK) return status;
    layout->margin = 0.5 * layout->def.gap + MUS__LAYOUT_TOLERANCE;
    status = mus__layout_outlines(layout, pattern);
    return layout_end(layout, status, out);
}


/* copy an item: its outline counter-clockwise, its turns */
static mus_status layout_item(mus_layout *layout, int32_t index, const mus_layout_item *given,
                              mus__layout_outline *outline)
{
    mus_context *context = layout->context;
    mus_layout_item item;
    mus_layout_item_init(&item, sizeof item);
    mus_status status = mus__def_read(context, &item, sizeof item, sizeof item, given, "mus_layout_item");
    if (status != MUS_OK) return status;
    if (item.n < 3 || item.n > LAYOUT_POINTS_MOST || item.xy == NULL || !mus__near(2 * (int64_t)item.n, item.xy))
        return mus__fail(context, MUS_ERR_ARG, "item %d: %d points, expected 3 to %d within 1e7 of the origin",
                         (int)index, (int)item.n, LAYOUT_POINTS_MOST);
    if (item.count < 1 || item.count > MUS__LAYOUT_MOST)
        return mus__fail(context, MUS_ERR_ARG, "item %d: count %d, expected 1 to %d", (int)index, (int)item.count,
                         MUS__LAYOUT_MOST);
    if (item.turn_count < 0 || item.turn_count > LAYOUT_TURNS_MOST || (item.turn_count > 0 && item.turns == NULL) ||
        !mus__near(item.turn_count, item.turns))
        return mus__fail(context, MUS_ERR_ARG, "item %d: %d turns, expected 0 to %d finite angles", (int)index,
                         (int)item.turn_count, LAYOUT_TURNS_MOST);
    const double area = mus__polygon_area(item.n, item.xy);
    if (!(fabs(area) > 0.0)) return mus__fail(context, MUS_ERR_ARG, "item %d has no area", (int)index);
    outline->panel = index;
    outline->turn[0] = outline->turn[3] = 1.0;
    outline->area = fabs(area);
    outline->count = item.count;
    outline->turns = mus__new(context, item.turn_count, sizeof *outline->turns);
    if (outline->turns == NULL) return mus__fail_memory(context, "an item of a layout");
    outline->turn_count = item.turn_count;
    for (int32_t i = 0; i < item.turn_count; i++) outline->turns[i] = item.turns[i];
    status = mus__layout_polygon_make(context, item.n, &outline->cut);
    for (int32_t i = 0; i < item.n && status == MUS_OK; i++)
        memcpy(outline->cut.xy + 2 * i, item.xy + 2 * (area > 0.0 ? i : item.n - 1 - i), 2 * sizeof *item.xy);
    return status == MUS_OK ? mus__layout_outline_grow(layout, outline) : status;
}


mus_status mus_layout_create_items(mus_context *context, int32_t count, const mus_layout_item *items,
                                   const mus_layout_def *def, mus_layout **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL || items == NULL || out == NULL || count < 1)
        return mus__fail(context, MUS_ERR_ARG, "mus_layout_create_items: context, items or out is NULL, or count < 1");
    if (count > MUS__LAYOUT_MOST)
        return mus__fail(context, MUS_ERR_LIMIT, "%d items, at most %d", (int)count, MUS__LAYOUT_MOST);
    mus_layout *layout = NULL;
    mus_status status = layout_make(context, def, &layout);
    if (status != MUS_OK) return status;
    layout->def.fold = 0;
    layout->margin = layout->def.gap > 0.0 ? 0.5 * layout->def.gap + MUS__LAYOUT_TOLERANCE : 0.0;
    layout->outlines = mus__new(context, count, sizeof *layout->outlines);
    if (layout->outlines == NULL) status = mus__fail_memory(context, "the items of a layout");
    for (const mus_layout_item *item = items; layout->noutline < count && status == MUS_OK; layout->noutline++) {
        status = layout_item(layout, layout->noutline, item, &layout->outlines[layout->noutline]);
        /* items of an earlier release are shorter: the next one begins where this one ends */
        if (status == MUS_OK) item = (const mus_layout_item *)(const void *)((const char *)item + item->size);
    }
    return layout_end(layout, status, out);
}


void mus_layout_destroy(mus_layout *layout)
{
    if (layout == NULL) return;
    mus_context *context = layout->context;
    for (int32_t i = 0; i < layout->noutline; i++) mus__layout_outline_free(context, &layout->outlines[i]);
    for (int32_t i = 0; layout->laid != NULL && i < layout->npart; i++)
        mus__layout_polygon_free(context, &layout->laid[i]);
    mus__free(context, layout->outlines);
    mus__free(context, layout->parts);
    mus__free(context, layout->laid);
    mus__free(context, layout);
}


mus_context *mus_layout_context(const mus_layout *layout)
{
    return layout != NULL ? layout->context : NULL;
}


double mus_layout_width(const mus_layout *layout)
{
    return layout != NULL ? layout->def.width : 0.0;
}


double mus_layout_length(const mus_layout *layout)
{
    return layout != NULL ? layout->length : 0.0;
}


double mus_layout_folded(const mus_layout *layout)
{
    return layout != NULL ? layout->folded : 0.0;
}


int64_t mus_layout_steps(const mus_layout *layout)
{
    return layout != NULL ? layout->steps : 0;
}


double mus_layout_utilisation(const mus_layout *layout)
{
    if (layout == NULL || !(layout->length > 0.0)) return 0.0;
    double area = 0.0;
    for (int32_t i = 0; i < layout->noutline; i++) area += layout->outlines[i].count * layout->outlines[i].area;
    return area / (layout->def.width * layout->length);
}


int32_t mus_layout_piece_count(const mus_layout *layout)
{
    return layout != NULL ? layout->npart : 0;
}


mus_status mus_layout_piece_get(const mus_layout *layout, int32_t piece, mus_layout_piece *out)
{
    if (layout == NULL || out == NULL) return MUS_ERR_ARG;
    if (piece < 0 || piece >= layout->npart)
        return mus__fail(layout->context, MUS_ERR_ARG, "piece %d, the layout has %d", (int)piece, (int)layout->npart);
    const mus__layout_part *part = &layout->parts[piece];
    const mus__layout_outline *outline = &layout->outlines[part->outline];
    mus_layout_piece own = {.panel = outline->panel,
                            .name = outline->name,
                            .turned = part->turn[0] < 0.0,
                            .layers = part->lie == MUS__LIE_EITHER ? 2 : 1,
                            .on_fold = part->lie == MUS__LIE_HALF,
                            .spare = part->spare,
                            .n = layout->laid[piece].n,
                            .xy = layout->laid[piece].xy};
    own.mirrored = part->turn[0] * part->turn[3] - part->turn[1] * part->turn[2] < 0.0 && !own.on_fold;
    /* the turn of the part after that of the outline, whose middle was moved to y = 0 */
    for (int32_t r = 0; r < 2; r++) {
        for (int32_t c = 0; c < 2; c++)
            own.turn[2 * r + c] = part->turn[2 * r] * outline->turn[c] + part->turn[2 * r + 1] * outline->turn[2 + c];
        own.shift[r] = part->shift[r] - part->turn[2 * r + 1] * outline->axis;
    }
    const size_t size = out->size;
    if (size < sizeof own)
        return mus__fail(layout->context, MUS_ERR_VERSION, "mus_layout_piece: size %zu, expected %zu", size,
                         sizeof own);
    own.size = size;
    memcpy(out, &own, sizeof own);
    return MUS_OK;
}
