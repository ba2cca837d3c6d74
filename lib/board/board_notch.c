/*
 * board_notch.c: notches on the cutting table: put on one side, put on a seam, and matched over a whole garment.
 *
 * A notch is a place of a seam: the partners are laid notch on notch before they are stitched. So it stands on every
 * side that is sewn there, at places that correspond by relative arc length, with one kind: single in front, double
 * behind, triple for the ends of a closure. A design puts a notch on one side, whichever knows the place;
 * mus__board_match_notches() gives it to the others once the garment is sewn.
 *
 * One notch has no partner: where a long edge is sewn to two edges that end there, as the cap of a sleeve at the
 * shoulder, their joint is the partner. mus__board_notch_joints() puts it on the long edge alone, at the end of one of
 * the two sides that are the edge. So a notch at the end of a side stands for the joint there, and for no place of the
 * seam.
 */
#include <math.h>
#include <string.h>

#include "board/board_notch.h"
#include "board/board_seam.h"

#define NOTCH_GAP 1e-6    /* [m] a notch this far beyond the end of its side is at the end: rounding of drawing */
#define NOTCH_APART 0.012 /* [m] least distance of two notches on an outline; chosen: a triple notch is 8 mm wide, and
                             single ones 4 mm apart look like a double one */
#define NOTCH_SMOOTH 0.9  /* least cosine between two sides of one long edge: 26 degrees; chosen: a cap is round */


int32_t mus__board_notch_add(mus__board *board, int32_t side, double s, int32_t kind)
{
    if (!mus__board_has_side(board, side)) return MUS_NONE;
    const double length = board->side[side].length;
    if (!(s >= -NOTCH_GAP && s <= length + NOTCH_GAP) || kind < MUS_NOTCH_SINGLE || kind > MUS_NOTCH_TRIPLE) {
        mus__board_fail(board, MUS_ERR_ARG, "notch on %s: %g m of %g m, kind %d of 1 to 3", board->side[side].name, s,
                        length, (int)kind);
        return MUS_NONE;
    }
    board->status = mus__reserve(board->context, &board->notch, &board->notch_room, (int64_t)board->nnotch + 1,
                                 sizeof *board->notch);
    if (board->status != MUS_OK) return MUS_NONE;
    board->notch[board->nnotch] = (mus__board_notch){side, kind, fmin(fmax(s, 0.0), length)};
    return board->nnotch++;
}


/* distance [m] along the outline from place s of `side` on to a notch; infinite when the notch lies farther than
 * `most` */
static double notch_ahead(const mus__board *board, int32_t side, double s, const mus__board_notch *notch, double most)
{
    if (notch->side == side && notch->s >= s) return notch->s - s <= most ? notch->s - s : (double)INFINITY;
    double d = board->side[side].length - s;
    for (int32_t at = board->side[side].next; d <= most && at != side; at = board->side[at].next) {
        if (notch->side == at) return d + notch->s <= most ? d + notch->s : (double)INFINITY;
        d += board->side[at].length;
    }
    return (double)INFINITY;
}


/* whether a notch of index `first` or above lies within `most` [m] of place s of `side` along the outline */
static bool notch_near(const mus__board *board, int32_t side, double s, double most, int32_t first)
{
    const mus__board_notch here = {side, MUS_NOTCH_SINGLE, s};
    for (int32_t i = first; i < board->nnotch; i++) {
        const mus__board_notch *notch = &board->notch[i];
        if (notch->side == MUS_NONE || board->side[notch->side].panel != board->side[side].panel) continue;
        if (notch_ahead(board, side, s, notch, most) <= most ||
            notch_ahead(board, notch->side, notch->s, &here, most) <= most)
            return true;
    }
    return false;
}


void mus__board_notch_seam(mus__board *board, int32_t side, double s, int32_t kind, double apart)
{
    if (!mus__board_has_side(board, side)) return;
    mus__board_place place[MUS__SEWN_MOST];
    const double length = board->side[side].length;
    const int32_t n = mus__board_sewn(board, side, s / length, place), first = board->nnotch;
    for (int32_t i = 0; i < n; i++)
        if (apart > 0.0 && notch_near(board, place[i].side, place[i].t * board->side[place[i].side].length, apart, 0))
            return;

    /* two sides that are sewn to each other may share the place: the point of a dart, the fold of a pleat */
    for (int32_t i = 0; i < n; i++) {
        const double at = place[i].t * board->side[place[i].side].length;
        if (i == 0 || !notch_near(board, place[i].side, at, NOTCH_GAP, first))
            mus__board_notch_add(board, place[i].side, i == 0 ? s : at, kind);
    }
}


void mus__board_match_notches(mus__board *board)
{
    if (board->status != MUS_OK || board->nnotch == 0) return;
    mus__board_notch *given = board->notch;
    const int32_t n = board->nnotch;
    board->notch = NULL;
    board->nnotch = board->notch_room = 0;
    for (int32_t kind = MUS_NOTCH_TRIPLE; kind >= MUS_NOTCH_SINGLE; kind--)
        for (int32_t i = 0; i < n; i++)
            if (given[i].side != MUS_NONE && given[i].kind == kind)
                mus__board_notch_seam(board, given[i].side, given[i].s, kind, NOTCH_APART);
    mus__free(board->context, given);
}


/* the side that follows a side on the rim: where a line into the panel and back begins at its end, the one after it */
static int32_t joint_next(const mus__board *board, int32_t side)
{
    const double *end = mus__board_end(board, side);
    int32_t next = board->side[side].next;
    for (int32_t at = board->side[next].next; at != side; at = board->side[at].next) {
        if (memcmp(mus__board_start(board, at), end, 2 * sizeof *end) == 0) next = at;
    }
    return next;
}


/* are two sides that follow each other one long edge: does the outline go on without a corner? */
static bool joint_smooth(const mus__board *board, int32_t side)
{
    double from[2], to[2];
    mus__board_at(board, side, board->side[side].length, NULL, from);
    mus__board_at(board, joint_next(board, side), 0.0, NULL, to);
    const double dot = from[0] * to[0] + from[1] * to[1];
    return dot >= NOTCH_SMOOTH * sqrt((from[0] * from[0] + from[1] * from[1]) * (to[0] * to[0] + to[1] * to[1]));
}


/* the side of another panel that a side is sewn to, once and for good; MUS_NONE without one */
static int32_t joint_partner(const mus__board *board, int32_t side)
{
    const int32_t seam = mus__board_seam_of(board, side), partner = mus__board_partner(board, side);
    if (seam == MUS_NONE || board->seam[seam].laid != 0 || board->seam[seam].closure != MUS_CLOSURE_NONE)
        return MUS_NONE;
    return board->side[partner].panel != board->side[side].panel ? partner : MUS_NONE;
}


/* does a long edge have a joint of two others at the end of `side`? These do not go on as one long edge */
static bool joint_at(const mus__board *board, int32_t side)
{
    const int32_t p = joint_partner(board, side), q = joint_partner(board, joint_next(board, side));
    if (p == MUS_NONE || q == MUS_NONE || !joint_smooth(board, side)) return false;
    const int32_t before = joint_next(board, q) == p ? q : joint_next(board, p) == q ? p : MUS_NONE;
    return before == MUS_NONE || !joint_smooth(board, before);
}


/* do the names of two sides, without the ending of a mirror image, stand in this order? */
static bool joint_in_order(const char *a, const char *b)
{
    char name[2][MUS__NAME_BYTES];
    for (int32_t i = 0; i < 2; i++) {
        memcpy(name[i], i == 0 ? a : b, MUS__NAME_BYTES);
        const size_t n = strlen(name[i]);
        if (n > 2 && strcmp(name[i] + n - 2, "_r") == 0) name[i][n - 2] = '\0';
    }
    return strcmp(name[0], name[1]) < 0;
}


void mus__board_notch_joints(mus__board *board)
{
    const int32_t nside = board->nside;
    for (int32_t i = 0; i < nside && board->status == MUS_OK; i++) {
        const mus__board_side *side = &board->side[i];
        if (side->panel == MUS_NONE || !joint_at(board, i) || notch_near(board, i, side->length, NOTCH_APART, 0))
            continue;
        /* on the side whose name comes first, so that mirror images are alike */
        const int32_t next = joint_next(board, i);
        const bool own = joint_in_order(side->name, board->side[next].name);
        mus__board_notch_add(board, own ? i : next, own ? side->length : 0.0, MUS_NOTCH_SINGLE);
    }
}
