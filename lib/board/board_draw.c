/*
 * board_draw.c: drawing on the cutting table: panels side by side, names, marks and openings; and sides by
 * their place on the outline: the point at an arc length, the run of sides that carry a label.
 */
#include <math.h>
#include <string.h>

#include "base/utf8.h"
#include "board/board_curve.h"
#include "geom/vec.h"

/* [m] largest gap between the end of a side and the start of the next: rounding of the drawing, and no more */
#define BOARD_GAP 1e-6


/* room for one more record; false when the board has failed */
static bool board_room(mus__board *board, void *array, int32_t *room, int32_t count, size_t size)
{
    if (board->status == MUS_OK) board->status = mus__reserve(board->context, array, room, (int64_t)count + 1, size);
    return board->status == MUS_OK;
}


/* copy a name into a record; NULL reads as "" */
static bool board_name(mus__board *board, const char *name, char *out)
{
    const size_t n = name != NULL ? strlen(name) : 0;
    if (n >= MUS__NAME_BYTES) {
        mus__board_fail(board, MUS_ERR_ARG, "the name %.40s... is longer than %d bytes", name, MUS__NAME_BYTES - 1);
        return false;
    }
    if (n > 0 && mus__utf8_span(name) < n) {
        mus__board_fail(board, MUS_ERR_ARG, "a name is not UTF-8 at byte %zu", mus__utf8_span(name));
        return false;
    }
    memset(out, 0, MUS__NAME_BYTES);
    if (n > 0) memcpy(out, name, n);
    return true;
}


int32_t mus__board_panel_add(mus__board *board, const char *name, const char *label)
{
    mus__board_panel panel = {.first = MUS_NONE, .mirror_of = MUS_NONE};
    mus__panel_attributes_init(&panel.attr);
    if (board->status != MUS_OK || !board_name(board, name, panel.name) || !board_name(board, label, panel.attr.label))
        return MUS_NONE;
    if (panel.name[0] == '\0' || mus__board_find_panel(board, panel.name) != MUS_NONE) {
        mus__board_fail(board, MUS_ERR_ARG, "panel %s: %s", panel.name,
                        panel.name[0] == '\0' ? "it needs a name" : "another has this name already");
        return MUS_NONE;
    }
    if (!board_room(board, &board->panel, &board->panel_room, board->npanel, sizeof panel)) return MUS_NONE;
    board->panel[board->npanel] = panel;
    return board->npanel++;
}


int32_t mus__board_side_new(mus__board *board, int32_t panel, mus__board_chain *chain)
{
    mus__board_side side = {.panel = panel, .prev = MUS_NONE, .next = MUS_NONE, .knot = MUS_NONE, .chain = *chain};
    mus__edge_attributes_init(&side.attr);
    *chain = (mus__board_chain){0};
    if (side.chain.xy != NULL && board_room(board, &board->side, &board->side_room, board->nside, sizeof side)) {
        side.length = mus__board_chain_length(&side.chain);
        board->side[board->nside] = side;
        return board->nside++;
    }
    mus__free(board->context, side.chain.xy);
    return MUS_NONE;
}


void mus__board_follow(mus__board *board, int32_t side, int32_t next)
{
    memcpy(board->side[next].chain.xy, mus__board_end(board, side), 2 * sizeof(double));
    board->side[side].next = next;
    board->side[next].prev = side;
}


/* does `next` start where `side` ends? */
static bool board_meets(mus__board *board, int32_t side, int32_t next)
{
    const mus__board_side *a = &board->side[side], *b = &board->side[next];
    const double gap = mus__dist2(mus__board_end(board, side), mus__board_start(board, next));
    if (gap <= BOARD_GAP) return true;
    mus__board_fail(board, MUS_ERR_PATTERN, "panel %s: side %s starts %g m from the end of side %s, at most %g m",
                    board->panel[a->panel].name, b->name, gap, a->name, BOARD_GAP);
    return false;
}


int32_t mus__board_side_add(mus__board *board, int32_t panel, const char *name, const char *label, int32_t npiece,
                            const int32_t *kinds, int32_t nxy, const double *xy)
{
    if (!mus__board_has_panel(board, panel)) return MUS_NONE;
    mus__board_chain chain;
    mus__board_chain_make(board, npiece, kinds, nxy, xy, &chain);
    const int32_t side = mus__board_side_new(board, panel, &chain);
    if (side == MUS_NONE) return MUS_NONE;
    mus__board_rename(board, side, name, label != NULL ? label : "");
    if (!(board->side[side].length > 0.0))
        mus__board_fail(board, MUS_ERR_ARG, "side %s of panel %s: its length is %g m, it must be above 0",
                        board->side[side].name, board->panel[panel].name, board->side[side].length);

    /* the last side of a panel that is being drawn has no next; it is the prev of the first */
    mus__board_panel *own = &board->panel[panel];
    if (own->first == MUS_NONE) {
        own->first = board->side[side].prev = side;
        return side;
    }
    const int32_t first = own->first, last = board->side[first].prev;
    if (board->side[last].next != MUS_NONE)
        mus__board_fail(board, MUS_ERR_ARG, "panel %s is closed: side %s comes too late", own->name,
                        board->side[side].name);
    if (board->status != MUS_OK || !board_meets(board, last, side)) return MUS_NONE;
    mus__board_follow(board, last, side);
    board->side[first].prev = side;
    return side;
}


void mus__board_panel_close(mus__board *board, int32_t panel)
{
    if (!mus__board_has_panel(board, panel)) return;
    const int32_t first = board->panel[panel].first;
    if (first == MUS_NONE) {
        mus__board_fail(board, MUS_ERR_PATTERN, "panel %s has no side", board->panel[panel].name);
        return;
    }
    mus__board_side *last = &board->side[board->side[first].prev];
    if (last->next != MUS_NONE || !board_meets(board, board->side[first].prev, first)) return;
    memcpy(last->chain.xy + 2 * ((size_t)last->chain.nxy - 1), mus__board_start(board, first), 2 * sizeof(double));
    last->next = first;
}


int32_t mus__board_line_add(mus__board *board, int32_t panel, const char *name, const char *label, const double *start,
                            const double *end)
{
    const int32_t kind = MUS_PIECE_LINE;
    const double xy[4] = {start[0], start[1], end[0], end[1]};
    return mus__board_side_add(board, panel, name, label, 1, &kind, 2, xy);
}


void mus__board_rename(mus__board *board, int32_t side, const char *name, const char *label)
{
    if (!mus__board_has_side(board, side)) return;
    if (name != NULL) board_name(board, name, board->side[side].name);
    if (label != NULL) board_name(board, label, board->side[side].attr.label);
}


int32_t mus__board_mark_add(mus__board *board, int32_t panel, const char *name, int32_t n, const double *xy)
{
    mus__board_mark mark = {.panel = panel, .n = n};
    if (!mus__board_has_panel(board, panel) || !board_name(board, name, mark.name)) return MUS_NONE;
    if (n < 1)
        mus__board_fail(board, MUS_ERR_ARG, "mark %s: %d points, it needs 1 or more", mark.name, (int)n);
    else
        board->status = mus__check_near(board->context, n, 2, xy, "mark %s: point", mark.name);
    if (board->status != MUS_OK) return MUS_NONE;
    if (!board_room(board, &board->mark, &board->mark_room, board->nmark, sizeof mark)) return MUS_NONE;
    mark.xy = mus__new(board->context, 2 * (int64_t)n, sizeof *xy);
    if (mark.xy == NULL) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a mark");
        return MUS_NONE;
    }
    memcpy(mark.xy, xy, 2 * (size_t)n * sizeof *xy);
    board->mark[board->nmark] = mark;
    return board->nmark++;
}


void mus__board_opening_add(mus__board *board, const char *label)
{
    mus__opening opening;
    if (board->status != MUS_OK || !board_name(board, label, opening.label)) return;
    if (board_room(board, &board->opening, &board->opening_room, board->nopening, sizeof opening))
        board->opening[board->nopening++] = opening;
}


void mus__board_at(const mus__board *board, int32_t side, double s, double *xy, double *tangent)
{
    if (xy != NULL) xy[0] = xy[1] = 0.0;
    if (tangent != NULL) tangent[0] = tangent[1] = 0.0;
    if (side < 0 || side >= board->nside || board->side[side].chain.xy == NULL) return;
    mus__board_chain_at(&board->side[side].chain, board->side[side].length, s, xy, tangent);
}


/* does a closed dart begin with `side`: are all sides from it to its partner sewn to one another? Returns the side
 * after the dart, along the outline or against it, or MUS_NONE */
static int32_t board_past_dart(const mus__board *board, int32_t side, bool along)
{
    int32_t open = 0, count = 0, at = side;
    const int32_t limit = board->nside;
    /* as with brackets: the first side of a pair opens it, the second closes it */
    do {
        const int32_t partner = mus__board_partner(board, at);
        if (partner == MUS_NONE || board->side[partner].panel != board->side[at].panel) return MUS_NONE;
        bool met = false;
        for (int32_t back = side; back != at; back = along ? board->side[back].next : board->side[back].prev)
            met = met || back == partner;
        open += met ? -1 : 1;
        at = along ? board->side[at].next : board->side[at].prev;
    } while (open > 0 && at != side && ++count < limit);
    return open == 0 && at != side ? at : MUS_NONE;
}


/* the side with the label that follows (precedes) `side`, closed darts skipped; MUS_NONE without one */
static int32_t board_run_next(const mus__board *board, int32_t side, const char *label, bool along)
{
    int32_t at = along ? board->side[side].next : board->side[side].prev;
    while (at != side && at != MUS_NONE) {
        if (strcmp(board->side[at].attr.label, label) == 0) return at;
        at = board_past_dart(board, at, along);
    }
    return MUS_NONE;
}


int32_t mus__board_run(const mus__board *board, int32_t panel, const char *label, int32_t *sides, int32_t room)
{
    if (board->status != MUS_OK || panel < 0 || panel >= board->npanel || board->panel[panel].first == MUS_NONE)
        return 0;
    const int32_t first = board->panel[panel].first;

    /* the first labelled side, then back to where its run begins */
    int32_t begin = first;
    while (strcmp(board->side[begin].attr.label, label) != 0) {
        begin = board->side[begin].next;
        if (begin == first || begin == MUS_NONE) return 0;
    }
    const int32_t met = begin;
    for (int32_t at = begin; (at = board_run_next(board, at, label, false)) != MUS_NONE && at != met;) begin = at;
    if (board_run_next(board, begin, label, false) != MUS_NONE) begin = met;

    int32_t count = 0;
    for (int32_t at = begin; at != MUS_NONE; at = board_run_next(board, at, label, true)) {
        if (count > 0 && at == begin) break;
        if (count < room) sides[count] = at;
        count++;
    }
    return count;
}
