/*
 * boundary_loop.c: walks along the boundary loop of the half as sewn so far, over its seams, from panel to panel.
 *
 * A neckline is one half-edge in front and one behind, or many after shaping has cut the panels apart; an armhole
 * likewise. A collar or sleeve is drafted to the whole edge: its length, its points, its shape laid flat. A walk takes
 * the next half-edge of the panel. While that one is sewn, it continues after its partner, that is, it turns about the
 * corner.
 *
 *       neck of back        neck of front
 *      _________________ | _________________         next of the last side of the back: shoulder, sewn;
 *                        |                           its partner: shoulder of the front; next of that: neck
 *             back   shoulder   front
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "half/boundary_loop.h"

/* [m] joints nearer than this are one; below the length of any edge of a draft */
#define BOUNDARY_JOINT 1e-3


static bool boundary_on(const mus__half *half, const char *panels, const char *label, int32_t side)
{
    const mus__board_side *own = &half->board.side[side];
    if (own->panel == MUS_NONE || strcmp(own->attr.label, label) != 0) return false;
    return strncmp(half->board.panel[own->panel].name, panels, strlen(panels)) == 0 &&
           mus__board_partner(&half->board, side) == MUS_NONE;
}


/* the open half-edge after (step > 0) or before an open half-edge on the boundary loop; sewn ones are crossed */
static int32_t boundary_step(const mus__board *board, int32_t side, int step)
{
    int32_t at = side;
    for (int32_t i = 0; i <= board->nside; i++) {
        at = step > 0 ? board->side[at].next : board->side[at].prev;
        const int32_t other = mus__board_partner(board, at);
        if (other == MUS_NONE) return at;
        at = other;
    }
    return side;
}


int32_t mus__half_boundary(const mus__half *half, const char *panels, const char *label, int32_t *sides, int32_t room)
{
    /* a run begins after a half-edge that is no part of it; a ring begins at the first half-edge of a front */
    const mus__board *board = &half->board;
    int32_t first = MUS_NONE, n = 0;
    if (board->status != MUS_OK) return 0;
    for (int32_t i = 0; i < board->nside; i++) {
        if (!boundary_on(half, panels, label, i)) continue;
        const int32_t before = boundary_step(board, i, -1);
        const bool begins = !boundary_on(half, panels, label, before);
        const bool ring = strncmp(board->panel[board->side[i].panel].name, "front", 5) == 0 &&
                          strncmp(board->panel[board->side[before].panel].name, "front", 5) != 0;
        if (begins || (first == MUS_NONE && ring)) first = i;
        if (begins) break;
    }
    for (int32_t at = first; at != MUS_NONE && (n == 0 || at != first) && boundary_on(half, panels, label, at);
         at = boundary_step(board, at, 1)) {
        if (n < room) sides[n] = at;
        n++;
    }
    return n;
}


static double boundary_length(const mus__board *board, int32_t side)
{
    return board->side[side].length;
}


/* crosses the seam of half-edge k: updates turn and shift so that the panel of its partner lies beside, both half-edges
 * with one tangent at the corner */
static void boundary_cross(const mus__board *board, int32_t k, double *turn, double *shift)
{
    const int32_t partner = mus__board_partner(board, k);
    double corner[2], along[2], own[2], back[2];
    mus__board_at(board, k, 0.0, corner, along);
    mus__board_at(board, partner, boundary_length(board, partner), own, back);
    const double c = mus__cos(*turn), s = mus__sin(*turn);
    const double at[2] = {c * corner[0] - s * corner[1] + shift[0], s * corner[0] + c * corner[1] + shift[1]};
    *turn += mus__atan2(along[1], along[0]) - mus__atan2(-back[1], -back[0]);
    shift[0] = at[0] - (mus__cos(*turn) * own[0] - mus__sin(*turn) * own[1]);
    shift[1] = at[1] - (mus__sin(*turn) * own[0] + mus__cos(*turn) * own[1]);
}


void mus__boundary_read(mus__half *half, const char *label, mus__boundary *out)
{
    mus__board *board = &half->board;
    memset(out, 0, sizeof *out);
    if (board->status != MUS_OK) return;
    out->n = mus__half_boundary(half, "", label, out->side, MUS__BOUNDARY_SIDES);
    if (out->n < 1 || out->n >= MUS__BOUNDARY_SIDES) {
        mus__board_fail(board, MUS_ERR_DESIGN, "%s: %d sides round it, 1 to %d can be sewn to", label, (int)out->n,
                        MUS__BOUNDARY_SIDES - 1);
        return;
    }
    double turn = 0.0, shift[2] = {0.0, 0.0};
    for (int32_t i = 0; i < out->n; i++) {
        /* lay the panels between the last open half-edge and this one beside one another */
        out->over[i] = MUS_NONE;
        int32_t side = i > 0 ? board->side[out->side[i - 1]].next : out->side[0];
        for (int32_t guard = 0; guard < board->nside && side != out->side[i]; guard++) {
            const int32_t partner = mus__board_partner(board, side);
            if (partner == MUS_NONE) break;
            out->over[i] = side;
            boundary_cross(board, side, &turn, shift);
            side = board->side[partner].next;
        }
        out->turn[i] = turn, out->shift[i][0] = shift[0], out->shift[i][1] = shift[1];
        out->s[i + 1] = out->s[i] + boundary_length(board, out->side[i]);
    }
}


int32_t mus__boundary_split(mus__board *board, mus__boundary *loop, double s)
{
    if (board->status != MUS_OK) return MUS_NONE;
    for (int32_t i = 0; i <= loop->n; i++)
        if (fabs(loop->s[i] - s) < BOUNDARY_JOINT) return i;
    int32_t i = 0;
    while (i + 1 < loop->n && loop->s[i + 1] < s) i++;
    if (loop->n == MUS__BOUNDARY_SIDES) {
        mus__board_fail(board, MUS_ERR_LIMIT, "an edge is cut into more than %d sides", (int)MUS__BOUNDARY_SIDES);
        return MUS_NONE;
    }
    const int32_t side = mus__board_split(board, loop->side[i], s - loop->s[i], NULL);
    if (board->status != MUS_OK) return MUS_NONE;
    for (int32_t k = loop->n; k > i + 1; k--) {
        loop->side[k] = loop->side[k - 1], loop->over[k] = loop->over[k - 1], loop->turn[k] = loop->turn[k - 1];
        memcpy(loop->shift[k], loop->shift[k - 1], sizeof loop->shift[k]);
    }
    for (int32_t k = loop->n + 1; k > i + 1; k--) loop->s[k] = loop->s[k - 1];
    loop->n++;
    loop->side[i + 1] = side, loop->over[i + 1] = MUS_NONE, loop->turn[i + 1] = loop->turn[i];
    memcpy(loop->shift[i + 1], loop->shift[i], sizeof loop->shift[i]);
    loop->s[i + 1] = s;
    return i + 1;
}


int32_t mus__boundary_over(const mus__board *board, const mus__boundary *loop, const char *label)
{
    for (int32_t i = 0; i < loop->n; i++)
        if (loop->over[i] != MUS_NONE && strcmp(board->side[loop->over[i]].attr.label, label) == 0) return i;
    return MUS_NONE;
}


int32_t mus__boundary_near(const mus__boundary *loop, double part, double off)
{
    int32_t best = MUS_NONE;
    for (int32_t i = 1; i < loop->n; i++) {
        const double d = fabs(loop->s[i] / loop->s[loop->n] - part);
        if (d < off) best = i, off = d;
    }
    return best;
}


double mus__boundary_notch(const mus__board *board, const mus__boundary *loop, int32_t first, int32_t last,
                           int32_t kind)
{
    double s = (double)NAN;
    for (int32_t i = last - 1; i >= first; i--)
        for (int32_t k = board->nnotch - 1; k >= 0; k--)
            if (board->notch[k].side == loop->side[i] && board->notch[k].kind == kind)
                s = loop->s[i] + board->notch[k].s;
    return s;
}


void mus__boundary_at(const mus__board *board, const mus__boundary *loop, double s, double *xy, double *tangent)
{
    int32_t i = 0;
    double p[2], t[2];
    while (i + 1 < loop->n && loop->s[i + 1] < s) i++;
    mus__board_at(board, loop->side[i], fmin(fmax(s - loop->s[i], 0.0), loop->s[i + 1] - loop->s[i]), p, t);
    const double c = mus__cos(loop->turn[i]), d = mus__sin(loop->turn[i]);
    xy[0] = c * p[0] - d * p[1] + loop->shift[i][0], xy[1] = d * p[0] + c * p[1] + loop->shift[i][1];
    tangent[0] = c * t[0] - d * t[1], tangent[1] = d * t[0] + c * t[1];
}
