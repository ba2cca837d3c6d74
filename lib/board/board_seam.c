/*
 * board_seam.c: seams on the cutting table: sides sewn, opened, split and merged together with their partners.
 *
 * Along a seam, places correspond by relative arc length: t of one side lies on t (DIRECT) or 1 - t (REVERSED) of the
 * other. A split of one side splits all sides that are sewn to it, directly or through others, as many sheets as meet
 * there; a merge does the reverse. The ease of a seam is divided in proportion.
 */
#include <math.h>
#include <string.h>

#include "board/board_seam.h"

#define SEW_LEAST 1e-6  /* [m] shortest part that a split may leave */
#define SEW_JOINT 0.001 /* [m] joints of two runs within this are one; chosen: below any seam that is sewn */
#define SEW_TOLERANCE 0.0005 /* [m] as the default of mus_seam_def */


int32_t mus__board_seam_add(mus__board *board, int32_t a, int32_t b, int32_t direction, double ease)
{
    if (!mus__board_has_side(board, a) || !mus__board_has_side(board, b)) return MUS_NONE;
    if (a == b || !mus__finite(ease) || (direction != MUS_SEAM_REVERSED && direction != MUS_SEAM_DIRECT)) {
        mus__board_fail(board, MUS_ERR_ARG, "seam of side %s with side %s: direction %d, ease %g m",
                        board->side[a].name, a == b ? "itself" : board->side[b].name, (int)direction, ease);
        return MUS_NONE;
    }
    board->status =
        mus__reserve(board->context, &board->seam, &board->seam_room, (int64_t)board->nseam + 1, sizeof *board->seam);
    if (board->status != MUS_OK) return MUS_NONE;
    board->seam[board->nseam] =
        (mus__board_seam){.a = a, .b = b, .direction = direction, .ease = ease, .tolerance = SEW_TOLERANCE};
    return board->nseam++;
}


void mus__board_seam_like(mus__board *board, int32_t seam, int32_t other)
{
    mus__board_seam *to = &board->seam[seam];
    const mus__board_seam *from = &board->seam[other];
    to->laid = from->laid, to->closure = from->closure, to->open = from->open, to->buttons = from->buttons;
}


void mus__board_seam_drop(mus__board *board, int32_t side)
{
    if (!mus__board_has_side(board, side)) return;
    const int32_t seam = mus__board_seam_of(board, side);
    if (seam != MUS_NONE)
        board->seam[seam].a = board->seam[seam].b = MUS_NONE;
    else
        mus__board_fail(board, MUS_ERR_ARG, "side %s is in no seam", board->side[side].name);
}


/* ---- places that are sewn to one another ---- */

/* index of `side` in the list, or MUS_NONE */
static int32_t sew_listed(const mus__board_place *place, int32_t n, int32_t side)
{
    for (int32_t i = 0; i < n; i++)
        if (place[i].side == side) return i;
    return MUS_NONE;
}


int32_t mus__board_sewn(mus__board *board, int32_t side, double t, mus__board_place *place)
{
    int32_t n = 1;
    place[0] = (mus__board_place){side, t, MUS_NONE, MUS_NONE, MUS_NONE};
    for (int32_t i = 0; i < n; i++) {
        for (int32_t k = 0; k < board->nseam; k++) {
            const mus__board_seam *seam = &board->seam[k];
            if (seam->a != place[i].side && seam->b != place[i].side) continue;
            const int32_t other = seam->a == place[i].side ? seam->b : seam->a;
            const double there = seam->direction == MUS_SEAM_DIRECT ? place[i].t : 1.0 - place[i].t;
            const int32_t known = sew_listed(place, n, other);
            const bool against = known != MUS_NONE && fabs(place[known].t - there) > 1e-9;
            if (against || (known == MUS_NONE && n == MUS__SEWN_MOST)) {
                const char *name = board->side[other].name;
                if (against)
                    mus__board_fail(board, MUS_ERR_PATTERN, "side %s is sewn to itself the other way round", name);
                else
                    mus__board_fail(board, MUS_ERR_LIMIT, "side %s: more than %d sides are sewn to one another", name,
                                    MUS__SEWN_MOST);
                return 0;
            }
            if (known == MUS_NONE) place[n++] = (mus__board_place){other, there, i, k, MUS_NONE};
        }
    }
    return n;
}


/* ---- splitting ---- */

/* whether each side of the list can be split at its place; the board fails when one part would be too short */
static bool sew_splits(mus__board *board, const mus__board_place *place, int32_t n)
{
    for (int32_t i = 0; i < n; i++) {
        const mus__board_side *side = &board->side[place[i].side];
        const double before = place[i].t * side->length, after = side->length - before;
        if (before > SEW_LEAST && after > SEW_LEAST) continue;
        mus__board_fail(board, MUS_ERR_ARG, "side %s of panel %s: split at %g m of %g m, which leaves under %g m",
                        side->name, board->panel[side->panel].name, before, side->length, SEW_LEAST);
        return false;
    }
    return n > 0;
}


/* does a side still lie on its twin of a bridge, which is split already? */
static bool sew_bridged(const mus__board *board, const mus__board_place *list, const mus__board_place *place)
{
    if (place->from == MUS_NONE || !board->seam[place->seam].bridge) return false;
    const bool reversed = board->seam[place->seam].direction == MUS_SEAM_REVERSED;
    const mus__board_place *from = &list[place->from];
    const double *start = mus__board_start(board, from->side), *end = mus__board_end(board, from->made);
    const double *p = mus__board_start(board, place->side), *q = mus__board_end(board, place->side);
    const double length = board->side[from->side].length + board->side[from->made].length;
    if (reversed) {
        const double *swap = p;
        p = q;
        q = swap;
    }
    return p[0] == start[0] && p[1] == start[1] && q[0] == end[0] && q[1] == end[1] &&
           fabs(length - board->side[place->side].length) <= 1e-12 * length;
}


/* the two parts of a side as chains; the other side of a bridge gets the very points of the first */
static void sew_parts(mus__board *board, const mus__board_place *list, int32_t index, mus__board_chain *before,
                      mus__board_chain *after)
{
    const mus__board_place *place = &list[index];
    const mus__board_side *side = &board->side[place->side];
    *before = *after = (mus__board_chain){0};
    if (!sew_bridged(board, list, place)) {
        mus__board_chain_split(board, &side->chain, side->length, place->t * side->length, before, after);
        return;
    }
    const mus__board_place *from = &list[place->from];
    const bool reversed = board->seam[place->seam].direction == MUS_SEAM_REVERSED;
    const mus__board_chain *a = &board->side[from->side].chain, *b = &board->side[from->made].chain;
    const mus__board_chain *first = reversed ? b : a, *second = reversed ? a : b;
    mus__board_chain_make(board, first->npiece, first->kinds, first->nxy, first->xy, before);
    mus__board_chain_make(board, second->npiece, second->kinds, second->nxy, second->xy, after);
    if (reversed && before->xy != NULL) mus__board_chain_reverse(before);
    if (reversed && after->xy != NULL) mus__board_chain_reverse(after);
}


/* split one side of the list: it keeps its first part */
static void sew_split_one(mus__board *board, mus__board_place *list, int32_t index, const char *name)
{
    mus__board_place *place = &list[index];
    mus__board_chain before, after;
    sew_parts(board, list, index, &before, &after);
    if (before.xy == NULL || after.xy == NULL) {
        mus__free(board->context, before.xy);
        mus__free(board->context, after.xy);
        return;
    }
    const int32_t side = place->side, panel = board->side[side].panel;
    const int32_t made = mus__board_side_new(board, panel, &after);
    if (made == MUS_NONE) {
        mus__free(board->context, before.xy);
        return;
    }

    /* the ring, then the properties that both parts share */
    mus__board_side *a = &board->side[side], *b = &board->side[made];
    mus__free(board->context, a->chain.xy);
    a->chain = before;
    a->length = mus__board_chain_length(&a->chain);
    b->next = a->next;
    b->prev = side;
    board->side[b->next].prev = made;
    a->next = made;
    b->centre = a->centre;
    b->backward = a->backward;
    b->attr = a->attr;
    char own[MUS__NAME_BYTES];
    if (name == NULL) mus__board_free_name(board, panel, a->name, own);
    mus__board_rename(board, made, name != NULL ? name : own, NULL);
    place->made = made;

    /* notches beyond the vertex go along */
    for (int32_t i = 0; i < board->nnotch; i++) {
        mus__board_notch *notch = &board->notch[i];
        if (notch->side != side || notch->s <= a->length) continue;
        notch->side = made;
        notch->s = fmin(notch->s - a->length, b->length);
    }
}


/* the seams of the split sides, each now two */
static void sew_split_seams(mus__board *board, const mus__board_place *list, int32_t n)
{
    const int32_t nseam = board->nseam;
    for (int32_t k = 0; k < nseam && board->status == MUS_OK; k++) {
        mus__board_seam seam = board->seam[k];
        const int32_t i = sew_listed(list, n, seam.a), j = sew_listed(list, n, seam.b);
        if (i == MUS_NONE || j == MUS_NONE) continue;
        const bool direct = seam.direction == MUS_SEAM_DIRECT;
        const double t = list[i].t;
        const int32_t more = mus__board_seam_add(board, list[i].made, direct ? list[j].made : seam.b, seam.direction,
                                                 (1.0 - t) * seam.ease);
        if (more == MUS_NONE) return;
        board->seam[more].tolerance = seam.tolerance;
        board->seam[more].bridge = seam.bridge;
        mus__board_seam_like(board, more, k);
        board->seam[k].buttons = (int32_t)floor(t * seam.buttons + 0.5);
        board->seam[more].buttons = seam.buttons - board->seam[k].buttons;
        board->seam[k].b = direct ? seam.b : list[j].made;
        board->seam[k].ease = t * seam.ease;

        /* both sides of a bridge have the same new corner */
        if (!seam.bridge) continue;
        int32_t *a = &board->side[list[i].made].knot, *b = &board->side[list[j].made].knot;
        if (*a == MUS_NONE) *a = *b != MUS_NONE ? *b : board->nknot++;
        *b = *a;
    }
}


int32_t mus__board_split(mus__board *board, int32_t side, double s, const char *name)
{
    if (!mus__board_has_side(board, side)) return MUS_NONE;
    if (!mus__finite(s)) mus__board_fail(board, MUS_ERR_ARG, "split: an arc length is not finite");
    if (board->side[side].next == MUS_NONE)
        mus__board_fail(board, MUS_ERR_ARG, "side %s: its panel is not closed", board->side[side].name);
    if (board->status != MUS_OK) return MUS_NONE;
    mus__board_place list[MUS__SEWN_MOST];
    const int32_t n = mus__board_sewn(board, side, s / board->side[side].length, list);
    if (!sew_splits(board, list, n)) return MUS_NONE;
    for (int32_t i = 0; i < n && board->status == MUS_OK; i++) sew_split_one(board, list, i, i == 0 ? name : NULL);
    if (board->status == MUS_OK) sew_split_seams(board, list, n);
    return board->status == MUS_OK ? list[0].made : MUS_NONE;
}


/* ---- merging ---- */

/* sides one after the other that become one, and seams of them that do */
typedef struct sew_merge {
    int32_t npair, nseam;
    int32_t pair[MUS__SEWN_MOST][2], seam[MUS__SEWN_MOST][2];
} sew_merge;


static int32_t sew_seam_count(const mus__board *board, int32_t side)
{
    int32_t n = 0;
    for (int32_t i = 0; i < board->nseam; i++) n += board->seam[i].a == side || board->seam[i].b == side;
    return n;
}


/* add a pair to the list; false when one of its sides is in another pair */
static bool sew_pair_add(sew_merge *m, int32_t first, int32_t second)
{
    for (int32_t i = 0; i < m->npair; i++) {
        if (m->pair[i][0] == first && m->pair[i][1] == second) return true;
        for (int32_t k = 0; k < 2; k++)
            if (m->pair[i][k] == first || m->pair[i][k] == second) return false;
    }
    if (m->npair == MUS__SEWN_MOST || first == second) return false;
    m->pair[m->npair][0] = first;
    m->pair[m->npair++][1] = second;
    return true;
}


/* find the seam of the second side of a pair that continues seam k of the first; false without one */
static bool sew_pair_seam(const mus__board *board, sew_merge *m, int32_t first, int32_t second, int32_t k)
{
    const mus__board_seam *seam = &board->seam[k];
    const bool direct = seam->direction == MUS_SEAM_DIRECT;
    const int32_t p = seam->a == first ? seam->b : seam->a;
    for (int32_t i = 0; i < m->nseam; i++)
        if (m->seam[i][0] == k || m->seam[i][1] == k) return true;
    const int32_t q = direct ? board->side[p].next : board->side[p].prev;
    for (int32_t j = 0; j < board->nseam; j++) {
        const mus__board_seam *other = &board->seam[j];
        const bool joins = (other->a == second && other->b == q) || (other->b == second && other->a == q);
        if (j == k || !joins || other->direction != seam->direction || m->nseam == MUS__SEWN_MOST) continue;
        if (other->laid != seam->laid || other->closure != seam->closure || other->open != seam->open) continue;
        m->seam[m->nseam][0] = k;
        m->seam[m->nseam++][1] = j;
        return sew_pair_add(m, direct ? p : q, direct ? q : p);
    }
    return false;
}


/* collect the pairs and seams that merge together with `side` and the next; false when they cannot */
static bool sew_gather(const mus__board *board, int32_t side, sew_merge *m)
{
    m->npair = m->nseam = 0;
    if (side < 0 || side >= board->nside || board->side[side].panel == MUS_NONE) return false;
    if (board->side[side].next == MUS_NONE || !sew_pair_add(m, side, board->side[side].next)) return false;
    for (int32_t i = 0; i < m->npair; i++) {
        const int32_t first = m->pair[i][0], second = m->pair[i][1];
        if (sew_seam_count(board, first) != sew_seam_count(board, second)) return false;
        for (int32_t k = 0; k < board->nseam; k++)
            if ((board->seam[k].a == first || board->seam[k].b == first) && !sew_pair_seam(board, m, first, second, k))
                return false;
    }
    return true;
}


bool mus__board_mergeable(const mus__board *board, int32_t side)
{
    sew_merge m;
    return board->status == MUS_OK && sew_gather(board, side, &m);
}


/* the side that stays of the pair that `side` is in */
static int32_t sew_stays(const sew_merge *m, int32_t side)
{
    for (int32_t i = 0; i < m->npair; i++)
        if (m->pair[i][0] == side || m->pair[i][1] == side) return m->pair[i][0];
    return side;
}


/* notches of the second side come to the first; two of a kind at the joint are one */
static void sew_merge_notches(mus__board *board, int32_t first, int32_t second)
{
    const double length = board->side[first].length;
    for (int32_t i = 0; i < board->nnotch; i++) {
        mus__board_notch *notch = &board->notch[i];
        if (notch->side != second) continue;
        notch->side = first;
        notch->s += length;
        for (int32_t j = 0; j < board->nnotch; j++) {
            const mus__board_notch *other = &board->notch[j];
            if (j != i && other->side == first && other->kind == notch->kind && fabs(other->s - length) < SEW_LEAST &&
                fabs(notch->s - length) < SEW_LEAST)
                notch->side = MUS_NONE;
        }
    }
}


static void sew_merge_one(mus__board *board, int32_t first, int32_t second)
{
    mus__board_chain chain;
    mus__board_chain_join(board, &board->side[first].chain, &board->side[second].chain, &chain);
    if (chain.xy == NULL) return;
    sew_merge_notches(board, first, second);
    mus__board_side *a = &board->side[first], *b = &board->side[second];
    mus__free(board->context, a->chain.xy);
    a->chain = chain;
    a->length += b->length;
    if (a->centre != b->centre) a->centre = MUS__CENTRE_NONE;
    a->next = b->next;
    board->side[b->next].prev = first;
    if (board->panel[a->panel].first == second) board->panel[a->panel].first = first;
    mus__board_side_remove(board, second);
}


void mus__board_merge(mus__board *board, int32_t side)
{
    if (!mus__board_has_side(board, side)) return;
    sew_merge m;
    if (!sew_gather(board, side, &m)) {
        mus__board_fail(board, MUS_ERR_PATTERN, "side %s of panel %s cannot be one with the next: their seams part",
                        board->side[side].name, board->panel[board->side[side].panel].name);
        return;
    }
    for (int32_t i = 0; i < m.nseam; i++) {
        mus__board_seam *seam = &board->seam[m.seam[i][0]], *other = &board->seam[m.seam[i][1]];
        seam->ease += sew_stays(&m, seam->a) == sew_stays(&m, other->a) ? other->ease : -other->ease;
        seam->tolerance = fmax(seam->tolerance, other->tolerance);
        seam->bridge = seam->bridge && other->bridge;
        seam->buttons += other->buttons;
        seam->a = sew_stays(&m, seam->a);
        seam->b = sew_stays(&m, seam->b);
        other->a = other->b = MUS_NONE;
    }
    for (int32_t i = 0; i < m.npair && board->status == MUS_OK; i++) sew_merge_one(board, m.pair[i][0], m.pair[i][1]);
}


/* ---- runs ---- */

/* one of the two runs on its way: the side at hand, how many come after it, and the arc length that is sewn */
typedef struct sew_run {
    const int32_t *sides;
    int32_t step, left, side;
    double sewn, length;
} sew_run;


/* a run of n sides, walked forwards or backwards */
static bool sew_run_begin(mus__board *board, int32_t n, const int32_t *sides, bool backwards, sew_run *run)
{
    if (board->status != MUS_OK) return false;
    if (n < 1) {
        mus__board_fail(board, MUS_ERR_PATTERN, "sew: a run has no side");
        return false;
    }
    *run = (sew_run){backwards ? sides + n - 1 : sides, backwards ? -1 : 1, n - 1, 0, 0.0, 0.0};
    run->side = *run->sides;
    for (int32_t i = 0; i < n; i++) {
        if (!mus__board_has_side(board, sides[i])) return false;
        run->length += board->side[sides[i]].length;
    }
    return true;
}


/* relative arc length where the side at hand ends */
static double sew_run_end(const mus__board *board, const sew_run *run)
{
    return run->left == 0 ? 1.0 : (run->sewn + board->side[run->side].length) / run->length;
}


static void sew_run_next(const mus__board *board, sew_run *run)
{
    run->sewn += board->side[run->side].length;
    run->sides += run->step;
    run->side = run->left > 0 ? *run->sides : MUS_NONE;
    run->left--;
}


/* divide the side at hand at relative arc length t of its run: the part before t */
static int32_t sew_run_split(mus__board *board, sew_run *run, double t)
{
    const double s = t * run->length - run->sewn, length = board->side[run->side].length;
    int32_t part = run->side;
    if (run->step > 0)
        run->side = mus__board_split(board, part, s, NULL);
    else
        part = mus__board_split(board, part, length - s, NULL);
    if (board->status == MUS_OK) run->sewn += board->side[part].length;
    return part;
}


void mus__board_sew(mus__board *board, int32_t na, const int32_t *a, int32_t nb, const int32_t *b)
{
    sew_run x, y;
    if (!sew_run_begin(board, na, a, false, &x) || !sew_run_begin(board, nb, b, true, &y)) return;
    const double scale = fmax(x.length, y.length);
    while (board->status == MUS_OK && x.left >= 0 && y.left >= 0) {
        const double ex = sew_run_end(board, &x), ey = sew_run_end(board, &y);
        const bool both = x.left > 0 && y.left > 0 && fabs(ex - ey) * scale < SEW_JOINT;
        int32_t p = x.side, q = y.side;
        if (both || (x.left == 0 && y.left == 0)) {
            sew_run_next(board, &x);
            sew_run_next(board, &y);
        } else if (ex < ey) {
            q = sew_run_split(board, &y, ex);
            sew_run_next(board, &x);
        } else {
            p = sew_run_split(board, &x, ey);
            sew_run_next(board, &y);
        }
        if (board->status != MUS_OK) return;
        mus__board_seam_add(board, p, q, MUS_SEAM_REVERSED, board->side[q].length - board->side[p].length);
    }
}
