/*
 * edit_panel.c: panels separated, joined, mirrored, unfolded, faced, patched and removed (muslin/edit.h).
 *
 * A facing is the strip along an edge, seen from behind: the panel is mirrored and cut along the offset of the edge,
 * and the other part is removed. The offset runs through points at distance w square to the edge, every OFFSET_STEP,
 * joined by cubics with the tangents of the edge. Its ends lie on the edges beside the edge:
 *
 *     q(s) = p(s) + w n(s),    q'(s) = (1 - w k(s)) p'(s),
 *
 * so the strip needs 1 - w k > 0, a radius of curvature above w where the edge bends towards the panel.
 */
#include <math.h>
#include <string.h>

#include "board/board_cut.h"
#include "board/board_patch_panel.h"
#include "board/board_rigid_part.h"
#include "board/board_seam.h"
#include "edit/edit_internal.h"
#include "geom/vec.h"

#define OFFSET_STEP 0.015   /* [m] between points of an offset: on an arc of 5 cm radius the cubics are off by 1e-6 m */
#define OFFSET_MOST 512     /* points of an offset: an edge of 7.7 m */
#define FACING_BEHIND 0.005 /* [m] distance of a facing behind its panel; chosen: clear of the thickness of any cloth */


mus_status mus_pattern_separate(mus_pattern *pattern, const mus_cut_def *def, int32_t *panel, int32_t *seam)
{
    mus__editing e;
    mus_cut_def cut;
    const mus_status status = mus__edit_begin_cut(&e, pattern, def, &cut, panel, seam);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    int32_t from, to, made = MUS_NONE, goes = MUS_NONE;
    mus__edit_corners(&e, cut.edge_a, cut.s_a, cut.edge_b, cut.s_b, &from, &to);
    if (board->status == MUS_OK) {
        const double *start = mus__board_start(board, from), *end = mus__board_start(board, to);
        const int32_t old = board->side[from].panel;
        mus__board_path path;
        double *all = mus__edit_path(&e, start, end, &cut, &path);
        if (all != NULL) from = mus__board_rim_corner(board, from, all + 2, "cut");
        if (all != NULL) to = mus__board_rim_corner(board, to, all + 2 * (ptrdiff_t)cut.nxy, "cut");
        mus__edit_cut_begin(&e, old);
        if (board->status == MUS_OK) made = mus__board_cut(board, from, to, &path, cut.name, cut.seam_name);
        mus__free(board->context, all);
        if (board->status == MUS_OK) goes = board->side[from].prev;
        mus__edit_cut_check(&e, old, made);
    }
    return mus__edit_end_panel(&e, made, panel, goes, seam);
}


/* check a seam of the pattern, which has the same index on the board; MUS_NONE when the board fails */
static int32_t edit_seam(mus__editing *e, int32_t seam)
{
    if (e->board.status == MUS_OK) e->board.status = mus__pattern_known(e->pattern, "seam", seam, e->pattern->nseam);
    return e->board.status == MUS_OK ? seam : MUS_NONE;
}


mus_status mus_pattern_join_panels(mus_pattern *pattern, int32_t seam, int32_t *panel)
{
    if (panel != NULL) *panel = MUS_NONE;
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    int32_t kept = MUS_NONE;
    seam = edit_seam(&e, seam);
    if (seam != MUS_NONE) {
        kept = board->side[board->seam[seam].a].panel;
        mus__board_join(board, board->seam[seam].a);
    }
    return mus__edit_end_panel(&e, kept, panel, MUS_NONE, NULL);
}


mus_status mus_pattern_mirror_panel(mus_pattern *pattern, int32_t panel, const char *name, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t made = mus__edit_panel(&e, panel) ? mus__board_mirror(&e.board, panel, name) : MUS_NONE;
    return mus__edit_end_panel(&e, made, out, MUS_NONE, NULL);
}


mus_status mus_pattern_unfold(mus_pattern *pattern, int32_t fold)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board_unfold(&e.board, mus__edit_side(&e, fold));
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_remove_panel(mus_pattern *pattern, int32_t panel)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    if (mus__edit_panel(&e, panel)) mus__board_remove_panel(&e.board, panel);
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_remove_seam(mus_pattern *pattern, int32_t seam)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    seam = edit_seam(&e, seam);
    if (seam != MUS_NONE) e.board.seam[seam].a = e.board.seam[seam].b = MUS_NONE;
    return mus__edit_end(&e, 0, NULL, NULL);
}


/* ---- facing ---- */

/* the offset of a side by `width` [m] to its left as n cubics, xy (3 n + 1 points); false when the offset folds back */
static bool edit_offset(mus__board *board, int32_t side, double width, int32_t n, const double *first,
                        const double *last, double *xy)
{
    const double length = board->side[side].length;
    double was[2] = {0.0, 0.0}, p[2], t[2], q[2];
    for (int32_t i = 0; i <= n; i++) {
        mus__board_at(board, side, length * i / n, p, t);
        q[0] = p[0] - width * t[1], q[1] = p[1] + width * t[0];
        if (i == 0) memcpy(q, first, sizeof q);
        if (i == n) memcpy(q, last, sizeof q);
        double *out = xy + 6 * (size_t)i;
        memcpy(out, q, sizeof q);

        /* control points of the cubic that ends here, a third of its chord along both tangents */
        if (i > 0) {
            const double chord = mus__dist2(out - 6, out), along = (q[0] - out[-6]) * t[0] + (q[1] - out[-5]) * t[1];
            if (!(along > 0.0)) return false;
            for (int k = 0; k < 2; k++) {
                out[-4 + k] = out[-6 + k] + chord / 3.0 * was[k];
                out[-2 + k] = q[k] - chord / 3.0 * t[k];
            }
        }
        memcpy(was, t, sizeof was);
    }
    return true;
}


/* cut the strip along `side` off its panel, from the side before it to the side after it, and remove the other part */
static void edit_strip(mus__editing *e, int32_t side, double width, const char *name)
{
    mus__board *board = &e->board;
    if (board->status != MUS_OK) return;
    const int32_t next = board->side[side].next, before = board->side[side].prev, rest = board->side[side].panel;
    const double turn = mus__board_area(board, rest) < 0.0 ? -1.0 : 1.0;
    int32_t n = (int32_t)ceil(fmin(board->side[side].length / OFFSET_STEP, OFFSET_MOST - 1.0)), kinds[OFFSET_MOST];
    if (n < 1) n = 1;
    double xy[6 * OFFSET_MOST + 2];

    /* the corners where the strip ends, then its inner edge between them */
    const int32_t to = mus__board_split(board, next, width, NULL);
    const int32_t from = mus__board_split(board, before, board->side[before].length - width, NULL);
    if (board->status != MUS_OK) return;
    double first[2], last[2];
    memcpy(first, mus__board_start(board, from), sizeof first);
    memcpy(last, mus__board_start(board, to), sizeof last);
    if (!edit_offset(board, side, turn * width, n, first, last, xy)) {
        mus__board_fail(board, MUS_ERR_ARG, "facing of edge %s: it bends too sharply for a width of %g m",
                        board->side[side].name, width);
        return;
    }
    for (int32_t i = 0; i < n; i++) kinds[i] = MUS_PIECE_CUBIC;
    const int32_t made = mus__board_cut(board, from, to, &(mus__board_path){n, kinds, 3 * n + 1, xy}, name, "inner");
    if (board->status != MUS_OK) return;
    const int32_t inner = board->side[from].prev;
    mus__board_rename(board, inner, NULL, board->side[side].attr.label);
    mus__board_remove_panel(board, rest);
    board->panel[made].attr.cut[MUS_MATERIAL_MAIN] = 1;
}


/* the image of a side in the mirrored panel: its ring is the ring of the original walked backwards from the last
 * side */
static int32_t edit_image(const mus__board *board, int32_t mirror, int32_t side)
{
    if (board->status != MUS_OK) return MUS_NONE;
    int32_t image = board->panel[mirror].first, at = board->side[board->panel[board->side[side].panel].first].prev;
    for (; at != side; at = board->side[at].prev) image = board->side[image].next;
    return image;
}


/* a facing lies behind the panel, seen from its other side: turned about the y of the panel, 5 mm behind it. A point
 * (-x, y) of it comes to where (x, y) of the panel is: with D = diag(-1, 1, -1) rotation' = rotation D, bend' = -bend
 */
static void edit_place_behind(mus__board *board, int32_t panel, int32_t made)
{
    if (board->status != MUS_OK) return;
    mus_placement *to = &board->panel[made].attr.placement;
    *to = board->panel[panel].attr.placement;
    to->bend = 0.0 - to->bend, to->bend_x = 0.0 - to->bend_x;
    for (int32_t i = 0; i < 3; i++) {
        double *row = to->rotation + 3 * (size_t)i;
        to->origin[i] -= FACING_BEHIND * row[2];
        row[0] = 0.0 - row[0], row[2] = 0.0 - row[2];
    }
}


mus_status mus_pattern_add_patch(mus_pattern *pattern, int32_t panel, const char *name, int32_t n, const double *xy,
                                 int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    if (pattern != NULL && xy == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "patch: its line is NULL");
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    int32_t made = MUS_NONE;
    if (mus__edit_panel(&e, panel)) {
        mus__board_part_twins(&e.board, panel);
        made = mus__board_patch(&e.board, panel, n, xy, name != NULL ? name : "");
        if (made != MUS_NONE) mus__board_mark_add(&e.board, panel, name, n, xy);
        e.nwatch = 1, e.watch[0] = panel;
    }
    return mus__edit_end_panel(&e, made, out, MUS_NONE, NULL);
}


mus_status mus_pattern_add_facing(mus_pattern *pattern, int32_t edge, double width, const char *name, int32_t *panel)
{
    if (panel != NULL) *panel = MUS_NONE;
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const int32_t side = mus__edit_side(&e, edge);
    int32_t made = MUS_NONE, image = MUS_NONE;
    if (board->status == MUS_OK) {
        const mus__board_side *own = &board->side[side];
        const double least = fmin(board->side[own->prev].length, board->side[own->next].length);
        const char *title = own->name, *of = board->panel[own->panel].name;
        if (mus__board_seam_of(board, side) != MUS_NONE)
            mus__board_fail(board, MUS_ERR_ARG, "facing of edge %s of panel %s: it is sewn already", title, of);
        else if (!(width > 1e-3 && width < least - 1e-3) || own->prev == own->next)
            mus__board_fail(board, MUS_ERR_ARG,
                            "facing of edge %s of panel %s: a width of %g m is outside 0.001 m to the %g m beside it",
                            title, of, width, least - 1e-3);
    }

    /* the mirror image has a name that no other panel has */
    if (board->status == MUS_OK) {
        char spare[MUS__NAME_BYTES] = "facing ";
        for (size_t i = 7; mus__board_find_panel(board, spare) != MUS_NONE && i + 1 < sizeof spare; i++) spare[i] = '+';
        const int32_t old = board->side[side].panel;
        image = edit_image(board, mus__board_mirror(board, old, spare), side);
        edit_strip(&e, image, width, name);
        mus__board_seam_add(board, side, image, MUS_SEAM_REVERSED, 0.0);
        if (board->status == MUS_OK) made = board->side[image].panel;
        edit_place_behind(board, old, made);
    }
    return mus__edit_end_panel(&e, made, panel, MUS_NONE, NULL);
}
