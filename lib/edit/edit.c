/*
 * edit.c: the beginning and the end of every edit: the pattern is read onto the cutting table, places of its outlines
 * are looked up as sides, and the table is written back as the new contents of the pattern.
 *
 * The room: edit.c; edit_dart.c, edit_panel.c, edit_spread.c, edit_point.c and edit_seam.c hold the calls of
 * muslin/edit.h, each a few calls of lib/board; undo_history.c undoes and redoes.
 *
 * mus__board_read() makes the sides panel by panel, in the order of each word. mus__board_write() writes the remaining
 * panels in their order, each word from its first side. So the side of an edge is the first position that has the edge,
 * and the edge of a side stands in the new word where the side stands in its ring.
 */
#include <string.h>

#include "board/board_rigid_part.h"
#include "board/board_seam.h"
#include "edit/edit_internal.h"

/* [m] an arc length this far beyond the end of its edge is at the end, as for notches */
#define EDIT_END 1e-9
/* [m] a place within this of a corner is the corner; chosen: above rounding */
#define EDIT_CORNER 1e-6


static void edit_free(mus__editing *e)
{
    mus__free(e->pattern->context, e->side);
    mus__board_free(&e->board);
}


mus_status mus__edit_begin(mus__editing *e, mus_pattern *pattern)
{
    *e = (mus__editing){.pattern = pattern};
    if (pattern == NULL) return MUS_ERR_ARG;
    mus__board_read(&e->board, pattern);
    e->side = mus__new(pattern->context, pattern->nedge, sizeof *e->side);
    if (e->side == NULL) mus__board_fail(&e->board, MUS_ERR_MEMORY, "no memory for an edit");
    if (e->board.status != MUS_OK) {
        mus_status status = e->board.status;
        edit_free(e);
        return status;
    }

    int32_t place = 0;
    for (int32_t i = 0; i < pattern->nedge; i++) e->side[i] = MUS_NONE;
    for (int32_t i = 0; i < pattern->npanel; i++) {
        for (int32_t k = 0; k < pattern->panel[i].noutline; k++, place++) {
            int32_t *side = &e->side[pattern->panel[i].outline[k]];
            if (*side == MUS_NONE) *side = place;
        }
    }
    return MUS_OK;
}


int32_t mus__edit_side(mus__editing *e, int32_t edge)
{
    if (e->board.status != MUS_OK) return MUS_NONE;
    e->board.status = mus__pattern_known(e->pattern, "edge", edge, e->pattern->nedge);
    return e->board.status == MUS_OK ? e->side[edge] : MUS_NONE;
}


bool mus__edit_panel(mus__editing *e, int32_t panel)
{
    if (e->board.status == MUS_OK) e->board.status = mus__pattern_known(e->pattern, "panel", panel, e->pattern->npanel);
    return e->board.status == MUS_OK;
}


int32_t mus__edit_place(mus__editing *e, int32_t edge, double s, double *at)
{
    *at = 0.0;
    int32_t index = mus__edit_side(e, edge);
    if (index == MUS_NONE) return MUS_NONE;
    const mus__board_side *side = &e->board.side[index];
    if (!(s >= -EDIT_END && s <= side->length + EDIT_END)) {
        char title[2 * MUS__NAME_BYTES];
        mus__pattern_edge_title(e->pattern, edge, title);
        mus__board_fail(&e->board, MUS_ERR_ARG, "edge %s: %g m along it is outside its %g m", title, s, side->length);
        return MUS_NONE;
    }
    s = s < 0.0 ? 0.0 : s > side->length ? side->length : s;
    *at = side->backward ? side->length - s : s;
    return index;
}


int32_t mus__edit_leg(mus__editing *e, int32_t edge)
{
    int32_t side = mus__edit_side(e, edge);
    if (side == MUS_NONE) return MUS_NONE;
    const mus__board *board = &e->board;
    int32_t partner = mus__board_partner(board, side);
    return partner != MUS_NONE && partner != board->side[side].next && partner == board->side[side].prev ? partner
                                                                                                         : side;
}


/* the side that starts at arc length `at` of a side, which is split there unless a corner is near. A side that was
 * split before, together with a side that it is sewn to, continues in the next side */
static int32_t edit_corner(mus__board *board, int32_t side, double at)
{
    if (board->status != MUS_OK) return MUS_NONE;
    while (at > board->side[side].length + EDIT_CORNER) {
        at -= board->side[side].length;
        side = board->side[side].next;
    }
    if (at <= EDIT_CORNER) return side;
    if (at >= board->side[side].length - EDIT_CORNER) return board->side[side].next;
    return mus__board_split(board, side, at, NULL);
}


void mus__edit_corners(mus__editing *e, int32_t edge_a, double s_a, int32_t edge_b, double s_b, int32_t *a, int32_t *b)
{
    double at_a, at_b;
    int32_t side_a = mus__edit_place(e, edge_a, s_a, &at_a), side_b = mus__edit_place(e, edge_b, s_b, &at_b);
    mus__board *board = &e->board;
    *a = *b = MUS_NONE;
    if (board->status == MUS_OK && board->side[side_a].panel != board->side[side_b].panel)
        mus__board_fail(board, MUS_ERR_ARG, "side %s is of panel %s, side %s of another", board->side[side_a].name,
                        board->panel[board->side[side_a].panel].name, board->side[side_b].name);

    /* of two places on one side split at the later one first: the first part keeps its arc lengths */
    bool late = side_a == side_b && at_b > at_a;
    if (late) *b = edit_corner(board, side_b, at_b);
    *a = edit_corner(board, side_a, at_a);
    if (!late) *b = edit_corner(board, side_b, at_b);
}


double *mus__edit_chain(mus__editing *e, const double *start, const double *end, int32_t npiece, const int32_t *kinds,
                        int32_t nxy, const double *xy)
{
    mus__board *board = &e->board;
    if (board->status != MUS_OK) return NULL;
    if (npiece < 0 || nxy < 0 || (npiece > 0 && kinds == NULL) || (nxy > 0 && xy == NULL) || (npiece == 0 && nxy > 0) ||
        nxy > INT32_MAX / 4) {
        mus__board_fail(board, MUS_ERR_ARG, "chain: %d pieces with %d points between its ends", (int)npiece,
                        xy != NULL ? (int)nxy : 0);
        return NULL;
    }
    double *all = mus__new(board->context, 2 * ((int64_t)nxy + 2), sizeof *all);
    if (all == NULL) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a chain");
        return NULL;
    }
    memcpy(all, start, 2 * sizeof *all);
    if (nxy > 0) memcpy(all + 2, xy, 2 * (size_t)nxy * sizeof *all);
    memcpy(all + 2 * ((size_t)nxy + 1), end, 2 * sizeof *all);
    return all;
}


void mus_cut_def_init(mus_cut_def *def, size_t size)
{
    mus_cut_def own = {.edge_a = MUS_NONE, .edge_b = MUS_NONE};
    mus__def_init(def, size, &own, sizeof own);
}


mus_status mus__edit_begin_cut(mus__editing *e, mus_pattern *pattern, const mus_cut_def *def, mus_cut_def *own,
                               int32_t *panel, int32_t *seam)
{
    if (panel != NULL) *panel = MUS_NONE;
    if (seam != NULL) *seam = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    if (def == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "cut: its def is NULL");
    mus_cut_def_init(own, sizeof *own);
    const mus_status status = mus__def_read(pattern->context, own, sizeof *own, sizeof *own, def, "cut def");
    return status == MUS_OK ? mus__edit_begin(e, pattern) : status;
}


double *mus__edit_path(mus__editing *e, const double *start, const double *end, const mus_cut_def *cut,
                       mus__board_path *path)
{
    static const int32_t line = MUS_PIECE_LINE;
    const bool straight = cut->npiece == 0;
    double *all = mus__edit_chain(e, start, end, cut->npiece, cut->kinds, cut->nxy, cut->xy);
    *path = (mus__board_path){straight ? 1 : cut->npiece, straight ? &line : cut->kinds, cut->nxy + 2, all};
    return all;
}


void mus__edit_cut_begin(mus__editing *e, int32_t panel)
{
    int32_t a, b;
    if (e->board.status != MUS_OK) return;
    e->area = mus__board_area(&e->board, panel);
    e->board.status = mus__panel_crosses(e->pattern, panel, &e->crossed, &a, &b);
}


void mus__edit_cut_check(mus__editing *e, int32_t panel, int32_t made)
{
    mus__board *board = &e->board;
    if (board->status != MUS_OK) return;

    /* a part that lies outside the panel is wound the other way round */
    if (!(mus__board_area(board, panel) * e->area > 0.0 && mus__board_area(board, made) * e->area > 0.0))
        mus__board_fail(board, MUS_ERR_ARG, "cut of panel %s: the line lies outside it", board->panel[panel].name);
    if (e->crossed) return;
    e->nwatch = 2, e->watch[0] = panel, e->watch[1] = made;
}


/* ---- the end ---- */

/* the index of a panel of the board in the written pattern */
static int32_t edit_panel_of(const mus__board *board, int32_t panel)
{
    int32_t index = 0;
    for (int32_t i = 0; i < panel; i++) index += board->panel[i].name[0] != '\0' ? 1 : 0;
    return index;
}


static int32_t edit_edge_of(const mus__board *board, const mus_pattern *written, int32_t side)
{
    if (side < 0 || board->side[side].panel == MUS_NONE) return MUS_NONE;
    const int32_t panel = board->side[side].panel;
    int32_t k = 0;
    for (int32_t i = board->panel[panel].first; i != side; i = board->side[i].next) k++;
    return written->panel[edit_panel_of(board, panel)].outline[k];
}


/* refuse an edit after which a watched outline crosses itself */
static mus_status edit_watch(const mus__editing *e, const mus_pattern *written)
{
    for (int32_t i = 0; i < e->nwatch; i++) {
        const int32_t panel = edit_panel_of(&e->board, e->watch[i]);
        bool crosses;
        int32_t a, b;
        mus_status status = mus__panel_crosses(written, panel, &crosses, &a, &b);
        if (status != MUS_OK) return status;
        char title[2][2 * MUS__NAME_BYTES];
        if (!crosses) continue;
        mus__pattern_edge_title(written, a, title[0]);
        mus__pattern_edge_title(written, b, title[1]);
        return mus__fail(e->board.context, MUS_ERR_ARG, "panel %s: the line crosses its outline: edges %s and %s",
                         written->panel[panel].name, title[0], title[1]);
    }
    return MUS_OK;
}


/* put the new contents into the pattern and the old ones into its history */
static void edit_take(mus__editing *e, mus_pattern *written)
{
    mus__pattern_swap(e->pattern, written);
    mus__history_done(e->pattern, written);
    edit_free(e);
}


mus_status mus__edit_end(mus__editing *e, int32_t n, const int32_t *sides, int32_t *const *edges)
{
    mus_pattern *written;
    mus__board_write(&e->board, &written);
    mus_status status = written != NULL ? edit_watch(e, written) : e->board.status;
    if (status == MUS_OK) status = mus_pattern_set_cut_only(written, e->pattern->cut_only);
    if (status != MUS_OK) {
        mus_pattern_destroy(written);
        edit_free(e);
        return status;
    }
    for (int32_t i = 0; i < n; i++)
        if (edges[i] != NULL) *edges[i] = edit_edge_of(&e->board, written, sides[i]);
    edit_take(e, written);
    return MUS_OK;
}


mus_status mus__edit_end_panel(mus__editing *e, int32_t made, int32_t *panel, int32_t side, int32_t *seam)
{
    int32_t edge, *out = &edge;
    const int32_t index = e->board.status == MUS_OK && made != MUS_NONE ? edit_panel_of(&e->board, made) : MUS_NONE;
    mus_pattern *pattern = e->pattern;
    const mus_status status = mus__edit_end(e, 1, &side, &out);
    if (status != MUS_OK) return status;
    if (panel != NULL) *panel = index;
    if (seam != NULL) *seam = mus_pattern_edge_seam(pattern, edge);
    return MUS_OK;
}
