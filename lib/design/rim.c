/*
 * rim.c: walks along the open edge of what is sewn so far, over its seams, from panel to panel.
 *
 * A neckline may be one side in front and one behind, or many, when shaping cut the panels apart; armholes alike. What
 * is sewn to them asks for the whole edge: its length, its places, its shape laid flat. A walk takes the next side of
 * the panel; while that is sewn it goes on behind the side's partner, which is turning about the corner.
 *
 *       neck of back        neck of front
 *      _________________ | _________________         next of the last side of the back: shoulder, sewn;
 *                        |                           its partner: shoulder of the front; next of that: neck
 *             back   shoulder   front
 */
#include <math.h>
#include <string.h>

#include "design/parts.h"
#include "geom/vec.h"

/* joints nearer than this are the same [m] */
#define RIM_JOINT 1e-3


static double rim_length(const mus__board *board, int32_t side)
{
    return board->side[side].length;
}


/* over the seam that side `k` is in: the panel of its partner laid so that both sides leave the corner alike */
static void rim_cross(const mus__board *board, int32_t k, double *turn, double *shift)
{
    const int32_t partner = mus__board_partner(board, k);
    double corner[2], along[2], own[2], back[2];
    mus__board_at(board, k, 0.0, corner, along);
    mus__board_at(board, partner, rim_length(board, partner), own, back);
    const double c = cos(*turn), s = sin(*turn);
    const double at[2] = {c * corner[0] - s * corner[1] + shift[0], s * corner[0] + c * corner[1] + shift[1]};
    *turn += atan2(along[1], along[0]) - atan2(-back[1], -back[0]);
    shift[0] = at[0] - (cos(*turn) * own[0] - sin(*turn) * own[1]);
    shift[1] = at[1] - (sin(*turn) * own[0] + cos(*turn) * own[1]);
}


void mus__rim_read(mus__half *half, const char *label, mus__rim *out)
{
    mus__board *board = &half->board;
    memset(out, 0, sizeof *out);
    if (board->status != MUS_OK) return;
    out->n = mus__half_rim(half, "", label, out->side, MUS__RIM_SIDES);
    if (out->n < 1 || out->n >= MUS__RIM_SIDES) {
        mus__board_fail(board, MUS_ERR_DESIGN, "%s: %d sides round it, 1 to %d can be sewn to", label, (int)out->n,
                        MUS__RIM_SIDES - 1);
        return;
    }
    double turn = 0.0, shift[2] = {0.0, 0.0};
    for (int32_t i = 0; i < out->n; i++) {
        /* from the last open side to this one, the panels of the seams on the way laid beside */
        out->over[i] = MUS_NONE;
        int32_t side = i > 0 ? board->side[out->side[i - 1]].next : out->side[0];
        for (int32_t guard = 0; guard < board->nside && side != out->side[i]; guard++) {
            const int32_t partner = mus__board_partner(board, side);
            if (partner == MUS_NONE) break;
            out->over[i] = side;
            rim_cross(board, side, &turn, shift);
            side = board->side[partner].next;
        }
        out->turn[i] = turn, out->shift[i][0] = shift[0], out->shift[i][1] = shift[1];
        out->s[i + 1] = out->s[i] + rim_length(board, out->side[i]);
    }
}


int32_t mus__rim_split(mus__board *board, mus__rim *rim, double s)
{
    if (board->status != MUS_OK) return MUS_NONE;
    for (int32_t i = 0; i <= rim->n; i++)
        if (fabs(rim->s[i] - s) < RIM_JOINT) return i;
    int32_t i = 0;
    while (i + 1 < rim->n && rim->s[i + 1] < s) i++;
    if (rim->n == MUS__RIM_SIDES) {
        mus__board_fail(board, MUS_ERR_LIMIT, "an edge is cut into more than %d sides", (int)MUS__RIM_SIDES);
        return MUS_NONE;
    }
    const int32_t side = mus__board_split(board, rim->side[i], s - rim->s[i], NULL);
    if (board->status != MUS_OK) return MUS_NONE;
    for (int32_t k = rim->n; k > i + 1; k--) {
        rim->side[k] = rim->side[k - 1], rim->over[k] = rim->over[k - 1], rim->turn[k] = rim->turn[k - 1];
        memcpy(rim->shift[k], rim->shift[k - 1], sizeof rim->shift[k]);
    }
    for (int32_t k = rim->n + 1; k > i + 1; k--) rim->s[k] = rim->s[k - 1];
    rim->n++;
    rim->side[i + 1] = side, rim->over[i + 1] = MUS_NONE, rim->turn[i + 1] = rim->turn[i];
    memcpy(rim->shift[i + 1], rim->shift[i], sizeof rim->shift[i]);
    rim->s[i + 1] = s;
    return i + 1;
}


int32_t mus__rim_over(const mus__board *board, const mus__rim *rim, const char *label)
{
    for (int32_t i = 0; i < rim->n; i++)
        if (rim->over[i] != MUS_NONE && strcmp(board->side[rim->over[i]].label, label) == 0) return i;
    return MUS_NONE;
}


int32_t mus__rim_near(const mus__rim *rim, double part, double off)
{
    int32_t best = MUS_NONE;
    for (int32_t i = 1; i < rim->n; i++) {
        const double d = fabs(rim->s[i] / rim->s[rim->n] - part);
        if (d < off) best = i, off = d;
    }
    return best;
}


double mus__rim_notch(const mus__board *board, const mus__rim *rim, int32_t first, int32_t last, int32_t kind)
{
    double s = (double)NAN;
    for (int32_t i = last - 1; i >= first; i--)
        for (int32_t k = board->nnotch - 1; k >= 0; k--)
            if (board->notch[k].side == rim->side[i] && board->notch[k].kind == kind) s = rim->s[i] + board->notch[k].s;
    return s;
}


void mus__rim_at(const mus__board *board, const mus__rim *rim, double s, double *xy, double *tangent)
{
    int32_t i = 0;
    double p[2], t[2];
    while (i + 1 < rim->n && rim->s[i + 1] < s) i++;
    mus__board_at(board, rim->side[i], fmin(fmax(s - rim->s[i], 0.0), rim->s[i + 1] - rim->s[i]), p, t);
    const double c = cos(rim->turn[i]), d = sin(rim->turn[i]);
    xy[0] = c * p[0] - d * p[1] + rim->shift[i][0], xy[1] = d * p[0] + c * p[1] + rim->shift[i][1];
    tangent[0] = c * t[0] - d * t[1], tangent[1] = d * t[0] + c * t[1];
}
