/*
 * board_patch_panel.c: a patch laid on a panel: a line drawn into the panel, and a second panel that is sewn to it.
 *
 * The word of the panel leaves the cut line at a corner v, runs over a bridge b to the nearer end of the line, along
 * the line, and back over both:
 *
 *      .. v  b l1 l2 .. lk lk' .. l2' l1' b'  v ..          x' is the side that lies on x, walked the other way
 *
 * Each of them is one edge of the pattern, passed both ways, so nothing is cut; the patch is a third sheet at l. The
 * patch is the polygon of the line and a straight mouth between its ends. Its placement is that of the panel, moved by
 * PATCH_LIFT along the normal of the right side. Of a rolled panel the radius grows by PATCH_LIFT, and the middle of
 * the patch stays before its place on the panel.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "board/board_patch_panel.h"
#include "board/board_rigid_part.h"
#include "board/board_seam.h"
#include "geom/polygon.h"
#include "geom/predicate.h"
#include "geom/vec.h"

#define PATCH_LIFT 0.006 /* [m] distance of a patch from its panel; chosen: above the thickness of any cloth */
#define PATCH_CLEAR 0.002 /* [m] least distance of a line from the outline; chosen: no seam is sewn nearer to another */
#define PATCH_MOST 256   /* most points of a patch's line; chosen: bounds an array on the stack */


/* does segment p q meet segment a b? They share no end */
static bool patch_meets(const double *p, const double *q, const double *a, const double *b)
{
    /* segments on one line may be apart */
    for (int32_t d = 0; d < 2; d++)
        if (fmax(p[d], q[d]) < fmin(a[d], b[d]) || fmax(a[d], b[d]) < fmin(p[d], q[d])) return false;
    const double a1 = mus__orient2d(p, q, a), b1 = mus__orient2d(p, q, b);
    const double p1 = mus__orient2d(a, b, p), q1 = mus__orient2d(a, b, q);
    if ((a1 > 0.0 && b1 > 0.0) || (a1 < 0.0 && b1 < 0.0)) return false;
    return !((p1 > 0.0 && q1 > 0.0) || (p1 < 0.0 && q1 < 0.0));
}


static bool patch_same(const double *p, const double *q)
{
    return p[0] == q[0] && p[1] == q[1];
}


/* does the segment from p, the first point of the line, to corner v meet neither the outline nor the line? */
static bool patch_sees(const mus__board_part *rim, int32_t n, const double *line, const double *v)
{
    for (int32_t i = 0; i < rim->n; i++) {
        const double *a = rim->xy + 2 * (ptrdiff_t)i, *b = rim->xy + 2 * (ptrdiff_t)(i + 1 < rim->n ? i + 1 : 0);
        if (!patch_same(a, v) && !patch_same(b, v) && patch_meets(line, v, a, b)) return false;
    }
    for (int32_t i = 1; i + 1 < n; i++)
        if (patch_meets(line, v, line + 2 * (ptrdiff_t)i, line + 2 * (ptrdiff_t)i + 2)) return false;
    return true;
}


/* the nearest corner (start of a side) that the first point of the line sees, or MUS_NONE */
static int32_t patch_corner(const mus__board *board, int32_t panel, const mus__board_part *rim, int32_t n,
                            const double *line)
{
    const int32_t first = board->panel[panel].first;
    int32_t side = first, best = MUS_NONE;
    double near = INFINITY;
    do {
        const double *v = mus__board_start(board, side), far = mus__dist2(line, v);
        if (far < near && patch_sees(rim, n, line, v)) best = side, near = far;
        side = board->side[side].next;
    } while (side != first);
    return best;
}


static void patch_turn_round(int32_t n, double *line)
{
    for (int32_t i = 0, j = n - 1; i < j; i++, j--)
        for (int32_t d = 0; d < 2; d++) {
            const double swap = line[2 * i + d];
            line[2 * i + d] = line[2 * j + d];
            line[2 * j + d] = swap;
        }
}


/* a straight side of the panel that starts at a knot */
static int32_t patch_side(mus__board *board, int32_t panel, const char *name, const double *p, const double *q,
                          int32_t knot)
{
    const int32_t kind = MUS_PIECE_LINE;
    const double xy[4] = {p[0], p[1], q[0], q[1]};
    mus__board_chain chain;
    mus__board_chain_make(board, 1, &kind, 2, xy, &chain);
    const int32_t side = chain.xy != NULL ? mus__board_side_new(board, panel, &chain) : MUS_NONE;
    if (side == MUS_NONE) return MUS_NONE;
    char own[MUS__NAME_BYTES];
    mus__board_free_name(board, panel, name, own);
    const bool taken = name[0] != '\0' && mus__board_find(board, panel, name) != MUS_NONE;
    mus__board_rename(board, side, taken ? own : name, NULL);
    board->side[side].knot = knot;
    return side;
}


/* add bridge and line to the ring before `from`: sides[i] (n - 1) runs from point i to the next, on the way out */
static void patch_draw(mus__board *board, int32_t from, int32_t n, const double *line, const char *name, int32_t *sides)
{
    const int32_t panel = board->side[from].panel, before = board->side[from].prev, knot = board->nknot;
    double corner[2];
    memcpy(corner, mus__board_start(board, from), sizeof corner);
    board->nknot += n + 1;
    if (board->side[from].knot == MUS_NONE) board->side[from].knot = knot + n;
    int32_t at = before, out[PATCH_MOST];
    for (int32_t i = -1; i < n - 1; i++) {
        const double *p = i < 0 ? corner : line + 2 * (ptrdiff_t)i, *q = line + 2 * ((ptrdiff_t)i + 1);
        out[i + 1] = patch_side(board, panel, i < 0 ? "" : name, p, q, i < 0 ? board->side[from].knot : knot + i);
        if (out[i + 1] == MUS_NONE) return;
        if (i >= 0) sides[i] = out[i + 1];
        mus__board_follow(board, at, out[i + 1]);
        at = out[i + 1];
    }
    for (int32_t i = n - 2; i >= -1; i--) {
        const double *p = line + 2 * ((ptrdiff_t)i + 1), *q = i < 0 ? corner : line + 2 * (ptrdiff_t)i;
        const int32_t back = patch_side(board, panel, "", p, q, knot + i + 1);
        if (back == MUS_NONE) return;
        const int32_t seam = mus__board_seam_add(board, out[i + 1], back, MUS_SEAM_REVERSED, 0.0);
        if (seam == MUS_NONE) return;
        board->seam[seam].bridge = true;
        memcpy(board->side[back].name, board->side[out[i + 1]].name, MUS__NAME_BYTES);
        mus__board_follow(board, at, back);
        at = back;
    }
    mus__board_follow(board, at, from);
}


/* place the patch along the normal of the right side of its panel (turn -1: of the wrong side) */
static void patch_place(mus__board *board, int32_t panel, int32_t made, double turn, double middle)
{
    const mus_placement *from = &board->panel[panel].attr.placement;
    mus_placement *to = &board->panel[made].attr.placement;
    const double lift = turn * PATCH_LIFT;
    double shift = 0.0;
    *to = *from;
    if (from->bend != 0.0 && fabs(from->bend + lift) > 0.01) {
        to->bend = from->bend + lift;
        to->bend_x = middle - (middle - from->bend_x) * to->bend / from->bend;
        shift = from->bend_x - to->bend_x;
    }
    for (int32_t i = 0; i < 3; i++)
        to->origin[i] += lift * from->rotation[3 * i + 2] + shift * from->rotation[3 * i];
}


/* the panel of the patch: the line, and the mouth back */
static int32_t patch_piece(mus__board *board, int32_t panel, int32_t n, const double *line, const char *name,
                           int32_t *sides)
{
    const int32_t made = mus__board_panel_add(board, name, board->panel[panel].attr.label);
    double low = INFINITY, high = -INFINITY;
    for (int32_t i = 0; i < n && made != MUS_NONE; i++) {
        const bool mouth = i == n - 1;
        const double *p = line + 2 * (ptrdiff_t)i, *q = mouth ? line : p + 2;
        char own[MUS__NAME_BYTES];
        snprintf(own, sizeof own, "sewn_%d", (int)i + 1);
        sides[i] = mus__board_line_add(board, made, mouth ? "mouth" : own, mouth ? "pocket" : "", p, q);
        low = fmin(low, p[0]), high = fmax(high, p[0]);
    }
    if (board->status != MUS_OK) return MUS_NONE;
    mus__board_panel_close(board, made);
    memcpy(board->panel[made].attr.grain, board->panel[panel].attr.grain, sizeof board->panel[made].attr.grain);
    board->panel[made].single = board->panel[panel].single;
    patch_place(board, panel, made, mus__polygon_area(n, line) < 0.0 ? -1.0 : 1.0, 0.5 * (low + high));
    return made;
}


static bool patch_inside(const mus__board_part *rim, const double *p)
{
    return mus__finite(p[0]) && mus__finite(p[1]) && mus__polygon_winding(rim->n, rim->xy, p) != 0 &&
           mus__polygon_distance(rim->n, rim->xy, p) > PATCH_CLEAR;
}


/* does the segment from p to q cross the outline? */
static bool patch_crosses(const mus__board_part *rim, const double *p, const double *q)
{
    for (int32_t i = 0; i < rim->n; i++)
        if (patch_meets(p, q, rim->xy + 2 * (ptrdiff_t)i, rim->xy + 2 * (ptrdiff_t)(i + 1 < rim->n ? i + 1 : 0)))
            return true;
    return false;
}


bool mus__board_patch_fits(mus__board *board, int32_t panel, int32_t n, const double *xy)
{
    if (!mus__board_has_panel(board, panel)) return false;
    mus__board_part rim = {0};
    mus__board_part_run(board, &rim, board->panel[panel].first, board->side[board->panel[panel].first].prev);
    bool fits = board->status == MUS_OK;
    for (int32_t i = 0; i < n && fits; i++)
        fits = patch_inside(&rim, xy + 2 * (ptrdiff_t)i) &&
               (i == 0 || !patch_crosses(&rim, xy + 2 * (ptrdiff_t)i - 2, xy + 2 * (ptrdiff_t)i));
    mus__board_part_end(board, &rim);
    return fits;
}


/* can a patch be sewn to the line? The board fails when it cannot */
static bool patch_fits(mus__board *board, int32_t panel, const mus__board_part *rim, int32_t n, const double *xy)
{
    const char *name = board->panel[panel].name;
    for (int32_t i = 0; i < n; i++) {
        const double *p = xy + 2 * (ptrdiff_t)i;
        const bool inside = patch_inside(rim, p);
        if (inside && (i == 0 || !patch_crosses(rim, p - 2, p))) continue;
        mus__board_fail(board, MUS_ERR_ARG, "patch on panel %s: point %d (%g, %g) is %s", name, (int)i, p[0], p[1],
                        inside ? "beyond its outline from the one before" : "not 2 mm inside it");
        return false;
    }
    int32_t a, b, *work = mus__room(board->context, n, sizeof *work);
    if (work == NULL) mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a patch");
    else if (mus__polygon_crosses(n, xy, &a, &b, work) || !(fabs(mus__polygon_area(n, xy)) > 1e-4))
        mus__board_fail(board, MUS_ERR_ARG, "patch on panel %s: its line crosses itself, or encloses less than 1 cm2",
                        name);
    mus__free(board->context, work);
    return board->status == MUS_OK;
}


int32_t mus__board_patch(mus__board *board, int32_t panel, int32_t n, const double *xy, const char *name)
{
    if (!mus__board_has_panel(board, panel)) return MUS_NONE;
    if (n < 3 || n > PATCH_MOST - 1) {
        mus__board_fail(board, MUS_ERR_ARG, "patch on panel %s: a line of %d points is outside 3 to %d",
                        board->panel[panel].name, (int)n, PATCH_MOST - 1);
        return MUS_NONE;
    }
    double line[2 * PATCH_MOST];
    int32_t sides[PATCH_MOST], own[PATCH_MOST], made = MUS_NONE;
    char title[2 * MUS__NAME_BYTES];
    mus__board_part rim = {0};
    memcpy(line, xy, 2 * (size_t)n * sizeof *line);
    mus__board_part_run(board, &rim, board->panel[panel].first, board->side[board->panel[panel].first].prev);
    if (board->status != MUS_OK || !patch_fits(board, panel, &rim, n, line)) goto done;

    /* the patch runs round as the panel does; the line is drawn from the end that sees a corner of the panel */
    if (mus__polygon_area(n, line) * mus__board_area(board, panel) < 0.0) patch_turn_round(n, line);
    made = patch_piece(board, panel, n, line, name, own);
    int32_t from = patch_corner(board, panel, &rim, n, line);
    const bool turned = from == MUS_NONE;
    if (turned) {
        patch_turn_round(n, line);
        from = patch_corner(board, panel, &rim, n, line);
    }
    if (from == MUS_NONE)
        mus__board_fail(board, MUS_ERR_ARG, "patch on panel %s: no corner of the panel is seen from an end of its line",
                        board->panel[panel].name);
    if (board->status != MUS_OK) goto done;
    from = mus__board_corner(board, from, line);
    snprintf(title, sizeof title, "%.100s_line", name);
    patch_draw(board, from, n, line, title, sides);
    for (int32_t i = 0; i < n - 1 && board->status == MUS_OK; i++)
        mus__board_seam_add(board, own[i], sides[turned ? n - 2 - i : i], turned ? MUS_SEAM_REVERSED : MUS_SEAM_DIRECT,
                            0.0);
done:
    mus__board_part_end(board, &rim);
    return board->status == MUS_OK ? made : MUS_NONE;
}
