/*
 * pattern.c: a pattern as an object: create, copy, destroy, find by name; and helpers that all of lib/pattern shares.
 *
 * The room, in the order of use:
 *   pattern.c              the object, its memory, names
 *   panels_edges_points.c  panels, points, edges, outlines
 *   edge_attributes.c, panel_attributes.c  what is said of an edge and of a panel
 *   seam.c                 seams, closures, declared openings
 *   notches_marks.c        notches and marks
 *   cut_pieces.c           materials that a panel is cut of
 *   join_garments.c        garments over one another as one pattern
 *   edge_measure.c, cut_outline.c, outline_crossing.c  lengths and areas; what is cut; an outline that crosses itself
 *
 * A pattern only grows here: no call removes a cell. lib/edit cuts, joins and removes, by way of the cutting table of
 * lib/board. lib/topology glues the seams and checks the pattern. A pattern has some tens of panels and some hundreds
 * of edges, so finding by name walks the list; panels of a larger pattern are found by a hash table.
 */
#include <stdio.h>
#include <string.h>

#include "base/utf8.h"
#include "pattern/pattern_internal.h"


/* panels from which on they are found by a table; chosen: a walk over fewer is as fast, and no garment has more */
#define NAMED_LEAST 64


mus_status mus__pattern_known(const mus_pattern *pattern, const char *what, int32_t index, int32_t count)
{
    if (index >= 0 && index < count) return MUS_OK;
    return mus__fail(pattern->context, MUS_ERR_ARG, "%s %d is unknown, the pattern has %d", what, (int)index,
                     (int)count);
}


mus_status mus__pattern_take_name(const mus_pattern *pattern, const char *what, const char *name, char *out)
{
    char own[MUS__NAME_BYTES] = {0};
    const size_t n = name != NULL ? strlen(name) : 0;
    if (n > 0 && mus__utf8_span(name) < n)
        return mus__fail(pattern->context, MUS_ERR_ARG, "%s: the name is not UTF-8 at byte %zu", what,
                         mus__utf8_span(name));
    if (n > MUS__NAME_BYTES - 1)
        return mus__fail(pattern->context, MUS_ERR_ARG, "%s: the name %.40s... is longer than %d bytes", what, name,
                         MUS__NAME_BYTES - 1);
    if (n > 0) memcpy(own, name, n); /* by way of a copy, since name may be out */
    memcpy(out, own, sizeof own);
    return MUS_OK;
}


double *mus__edge_block(mus_context *context, int32_t npiece, int32_t nxy)
{
    int64_t doubles = 2 * (int64_t)nxy + npiece + 1;
    return mus__new(context, doubles * (int64_t)sizeof(double) + npiece * (int64_t)sizeof(int32_t), 1);
}


void mus__edge_views(mus__edge *edge)
{
    edge->run = edge->xy + 2 * (size_t)edge->nxy;
    edge->kinds = (int32_t *)(void *)(edge->run + edge->npiece + 1);
}


static void history_clear(mus_pattern **list, int32_t *count)
{
    for (int32_t i = 0; i < *count; i++) mus_pattern_destroy(list[i]);
    *count = 0;
}


void mus__history_forget_undone(mus_pattern *pattern)
{
    if (pattern->history != NULL) history_clear(pattern->history->undone, &pattern->history->nundone);
}


void mus__history_end(mus_pattern *pattern)
{
    mus__history *history = pattern->history;
    if (history == NULL) return;
    history_clear(history->done, &history->ndone);
    history_clear(history->undone, &history->nundone);
    mus__free(pattern->context, history);
    pattern->history = NULL;
}


void mus__pattern_edited(mus_pattern *pattern)
{
    mus__history_forget_undone(pattern);
}


mus_status mus__pattern_give(const mus_pattern *pattern, void *out, const void *own, size_t own_size, const char *name)
{
    size_t size;
    memcpy(&size, out, sizeof size);
    if (size != own_size)
        return mus__fail(pattern->context, MUS_ERR_VERSION,
                         "%s: size %zu, this library knows %zu; use its init function", name, size, own_size);
    memcpy(out, own, own_size);
    memcpy(out, &size, sizeof size);
    return MUS_OK;
}


void mus__pattern_edge_title(const mus_pattern *pattern, int32_t edge, char *out)
{
    const mus__edge *e = &pattern->edge[edge];
    const char *panel = pattern->panel[e->panel].name;
    if (e->name[0] != '\0')
        snprintf(out, 2 * MUS__NAME_BYTES, "%s.%s", panel, e->name);
    else
        snprintf(out, 2 * MUS__NAME_BYTES, "%s.edge_%d", panel, (int)edge);
}


void mus_pattern_destroy(mus_pattern *pattern)
{
    if (pattern == NULL) return;
    mus_context *context = pattern->context;
    mus__history_end(pattern);
    mus_pattern_destroy(pattern->cut_only);
    for (int32_t i = 0; i < pattern->npanel; i++) mus__free(context, pattern->panel[i].outline);
    for (int32_t i = 0; i < pattern->nedge; i++) mus__free(context, pattern->edge[i].xy);
    for (int32_t i = 0; i < pattern->nmark; i++) mus__free(context, pattern->mark[i].xy);
    mus__free(context, pattern->panel);
    mus__free(context, pattern->point);
    mus__free(context, pattern->edge);
    mus__free(context, pattern->seam);
    mus__free(context, pattern->notch);
    mus__free(context, pattern->mark);
    mus__free(context, pattern->opening);
    mus__free(context, pattern->named);
    mus__free(context, pattern);
}


mus_status mus_pattern_create(mus_context *context, const char *name, mus_pattern **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(context, MUS_ERR_ARG, "pattern create: out is NULL");

    mus_pattern *pattern = mus__new(context, 1, sizeof *pattern);
    if (pattern == NULL) return mus__fail_memory(context, "a pattern");
    pattern->context = context;
    mus_status status = mus__pattern_take_name(pattern, "pattern", name, pattern->name);
    if (status != MUS_OK) {
        mus_pattern_destroy(pattern);
        return status;
    }
    *out = pattern;
    return MUS_OK;
}


/* a copy of `count` elements, capacity just that; NULL for none */
static mus_status pattern_copy_array(mus_context *context, const void *from, int32_t count, size_t size, void *slot,
                                     int32_t *room)
{
    if (count == 0) return MUS_OK;
    mus_status status = mus__reserve(context, slot, room, count, size);
    if (status == MUS_OK) memcpy(*(void **)slot, from, (size_t)count * size);
    return status;
}


/* the blocks that panels, edges and marks own; counts grow one by one so that a half-made copy can be destroyed */
static mus_status pattern_copy_blocks(const mus_pattern *from, mus_pattern *to)
{
    for (int32_t i = 0; i < from->npanel; i++) {
        const mus__panel *panel = &from->panel[i];
        int32_t *outline = panel->outline;
        if (outline != NULL) {
            outline = mus__new(to->context, 2 * (int64_t)panel->noutline, sizeof *outline);
            if (outline == NULL) return MUS_ERR_MEMORY;
            memcpy(outline, panel->outline, 2 * (size_t)panel->noutline * sizeof *outline);
        }
        to->panel[to->npanel++].outline = outline;
    }
    for (int32_t i = 0; i < from->nedge; i++) {
        mus__edge *edge = &to->edge[i];
        edge->xy = mus__edge_block(to->context, edge->npiece, edge->nxy);
        if (edge->xy == NULL) return MUS_ERR_MEMORY;
        to->nedge++;
        mus__edge_views(edge);
        memcpy(edge->xy, from->edge[i].xy, 2 * (size_t)edge->nxy * sizeof *edge->xy);
        memcpy(edge->run, from->edge[i].run, ((size_t)edge->npiece + 1) * sizeof *edge->run);
        memcpy(edge->kinds, from->edge[i].kinds, (size_t)edge->npiece * sizeof *edge->kinds);
    }
    for (int32_t i = 0; i < from->nmark; i++) {
        mus__mark *mark = &to->mark[i];
        mark->xy = mus__new(to->context, 2 * (int64_t)mark->n, sizeof *mark->xy);
        if (mark->xy == NULL) return MUS_ERR_MEMORY;
        to->nmark++;
        memcpy(mark->xy, from->mark[i].xy, 2 * (size_t)mark->n * sizeof *mark->xy);
    }
    return MUS_OK;
}


mus_status mus_pattern_copy(const mus_pattern *pattern, mus_pattern **out)
{
    if (out != NULL) *out = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (out == NULL) return mus__fail(context, MUS_ERR_ARG, "pattern copy: out is NULL");

    mus_pattern *copy;
    mus_status status = mus_pattern_create(context, pattern->name, &copy);
    if (status != MUS_OK) return status;

    /* arrays as they are; the counts of those that own blocks stay 0 until each block is there */
    const mus_pattern *p = pattern;
    size_t panel = sizeof *p->panel, point = sizeof *p->point, edge = sizeof *p->edge, seam = sizeof *p->seam;
    if (pattern_copy_array(context, p->panel, p->npanel, panel, &copy->panel, &copy->panel_room) != MUS_OK ||
        pattern_copy_array(context, p->point, p->npoint, point, &copy->point, &copy->point_room) != MUS_OK ||
        pattern_copy_array(context, p->edge, p->nedge, edge, &copy->edge, &copy->edge_room) != MUS_OK ||
        pattern_copy_array(context, p->seam, p->nseam, seam, &copy->seam, &copy->seam_room) != MUS_OK ||
        pattern_copy_array(context, p->notch, p->nnotch, sizeof *p->notch, &copy->notch, &copy->notch_room) != MUS_OK ||
        pattern_copy_array(context, p->mark, p->nmark, sizeof *p->mark, &copy->mark, &copy->mark_room) != MUS_OK ||
        pattern_copy_array(context, p->opening, p->nopening, sizeof *p->opening, &copy->opening, &copy->opening_room) !=
            MUS_OK ||
        pattern_copy_blocks(pattern, copy) != MUS_OK || mus_pattern_set_cut_only(copy, p->cut_only) != MUS_OK) {
        mus_pattern_destroy(copy);
        return mus__fail_memory(context, "the copy of a pattern");
    }
    copy->npoint = p->npoint;
    copy->nseam = p->nseam;
    copy->nnotch = p->nnotch;
    copy->nopening = p->nopening;
    *out = copy;
    return MUS_OK;
}


/* a facing or an elastic would be one more sheet of cloth in the mesh, and changes no shape that the eye sees: such
 * panels stand in a pattern of their own beside the garment's */
mus_status mus_pattern_set_cut_only(mus_pattern *pattern, const mus_pattern *panels)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    if (panels == pattern) return mus__fail(pattern->context, MUS_ERR_ARG, "cut-only panels: the pattern itself");
    mus_pattern *copy = NULL;
    if (panels != NULL) {
        const mus_status status = mus_pattern_copy(panels, &copy);
        if (status != MUS_OK)
            return pattern->context == panels->context ? status : mus__fail_memory(pattern->context, "cut-only panels");
        mus_pattern_destroy(copy->cut_only);
        copy->cut_only = NULL;
    }
    mus_pattern_destroy(pattern->cut_only);
    pattern->cut_only = copy;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


const mus_pattern *mus_pattern_cut_only(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->cut_only : NULL;
}


const char *mus_pattern_name(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->name : "";
}


mus_status mus_pattern_set_name(mus_pattern *pattern, const char *name)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_take_name(pattern, "pattern", name, pattern->name);
    if (status == MUS_OK) mus__pattern_edited(pattern);
    return status;
}


int32_t mus_pattern_panel_count(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->npanel : 0;
}


int32_t mus_pattern_point_count(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->npoint : 0;
}


int32_t mus_pattern_edge_count(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->nedge : 0;
}


int32_t mus_pattern_seam_count(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->nseam : 0;
}


int32_t mus_pattern_notch_count(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->nnotch : 0;
}


int32_t mus_pattern_mark_count(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->nmark : 0;
}


/* slot of the table where the panel of a name stands, or would */
static int32_t pattern_slot(const mus_pattern *pattern, const char *name)
{
    const uint64_t hash = mus__hash(MUS_HASH_START, name, strlen(name));
    int32_t slot = (int32_t)((hash ^ hash >> 32) & (uint64_t)(pattern->named_room - 1));
    while (pattern->named[slot] != MUS_NONE && strcmp(pattern->panel[pattern->named[slot]].name, name) != 0)
        slot = (slot + 1) & (pattern->named_room - 1);
    return slot;
}


mus_status mus__pattern_name_panels(mus_pattern *pattern)
{
    if (pattern->npanel < NAMED_LEAST) return MUS_OK;
    if (2 * (int64_t)pattern->npanel > pattern->named_room) {
        const int64_t room = 4 * (int64_t)pattern->npanel;
        int64_t slots = 1;
        while (slots < room) slots *= 2;
        if (slots > INT32_MAX) return mus__fail(pattern->context, MUS_ERR_LIMIT, "%d panels", (int)pattern->npanel);
        int32_t *named = mus__room(pattern->context, slots, sizeof *named);
        if (named == NULL) return mus__fail_memory(pattern->context, "the names of panels");
        mus__free(pattern->context, pattern->named);
        pattern->named = named, pattern->named_room = (int32_t)slots, pattern->nnamed = 0;
        for (int64_t i = 0; i < slots; i++) named[i] = MUS_NONE;
    }
    for (; pattern->nnamed < pattern->npanel; pattern->nnamed++)
        pattern->named[pattern_slot(pattern, pattern->panel[pattern->nnamed].name)] = pattern->nnamed;
    return MUS_OK;
}


int32_t mus_pattern_find_panel(const mus_pattern *pattern, const char *name)
{
    if (pattern == NULL || name == NULL) return MUS_NONE;
    const int32_t known = pattern->nnamed > 0 ? pattern->named[pattern_slot(pattern, name)] : MUS_NONE;
    if (known != MUS_NONE) return known;
    for (int32_t i = pattern->nnamed; i < pattern->npanel; i++) {
        if (strcmp(pattern->panel[i].name, name) == 0) return i;
    }
    return MUS_NONE;
}


int32_t mus_pattern_find_edge(const mus_pattern *pattern, int32_t panel, const char *name)
{
    if (pattern == NULL || name == NULL || name[0] == '\0') return MUS_NONE;
    for (int32_t i = 0; i < pattern->nedge; i++) {
        if (pattern->edge[i].panel == panel && strcmp(pattern->edge[i].name, name) == 0) return i;
    }
    return MUS_NONE;
}


mus_context *mus_pattern_context(const mus_pattern *pattern)
{
    return pattern != NULL ? pattern->context : NULL;
}
