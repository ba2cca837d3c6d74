/*
 * board_dart.c: darts as they lie on the table: read, added, shortened, released to gathers, made part of a seam.
 * board_dart_rotate.c rotates them.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/elementary.h"
#include "board/board_cut.h"
#include "board/board_dart.h"
#include "board/board_rigid_part.h"
#include "board/board_seam.h"
#include "geom/vec.h"

/* cosine of the largest angle, 45 degrees, between two sides beside a closed mouth that become one; chosen */
#define DART_CORNER 0.70710678
/* [rad] legs that cross by less lie on each other; chosen: above rounding */
#define DART_SLIT 1e-9
/* [m] least depth of a dart; chosen: no shorter one is sewn */
#define DART_SHORTEST 5e-3

/* is `leg` sewn to the side that follows it, point to point? */
bool mus__board_dart_is(const mus__board *board, int32_t leg)
{
    int32_t seam = mus__board_seam_of(board, leg), next = board->side[leg].next;
    return seam != MUS_NONE && next != leg && mus__board_partner(board, leg) == next &&
           board->seam[seam].direction == MUS_SEAM_REVERSED;
}


/* angle [rad] from u = a - o to v = b - o in the direction of the word (turn +1 or -1), 0 to 2 pi: a dart may have more
 * than half a turn. An angle above -DART_SLIT reads as 0: a slit whose legs lie on each other */
static double dart_between(const double *a, const double *o, const double *b, double turn)
{
    const double u[2] = {a[0] - o[0], a[1] - o[1]}, v[2] = {b[0] - o[0], b[1] - o[1]};
    const double angle = turn * mus__atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
    return angle >= 0.0 ? angle : angle > -DART_SLIT ? 0.0 : angle + 2.0 * MUS_PI;
}


static double dart_sense(const mus__board *board, int32_t panel)
{
    return mus__board_area(board, panel) < 0.0 ? -1.0 : 1.0;
}


bool mus__board_dart_read(mus__board *board, int32_t leg, mus__dart *dart)
{
    if (!mus__board_has_side(board, leg)) return false;
    const mus__board_side *side = &board->side[leg];
    if (!mus__board_dart_is(board, leg)) {
        mus__board_fail(board, MUS_ERR_ARG,
                        "side %s of panel %s: it is not the leg of a dart: it is not sewn to the next", side->name,
                        board->panel[side->panel].name);
        return false;
    }
    dart->leg = leg, dart->back = side->next, dart->panel = side->panel;
    memcpy(dart->a, mus__board_start(board, leg), sizeof dart->a);
    memcpy(dart->point, mus__board_end(board, leg), sizeof dart->point);
    memcpy(dart->b, mus__board_end(board, dart->back), sizeof dart->b);
    const double turn = dart_sense(board, dart->panel);
    dart->angle = turn * dart_between(dart->a, dart->point, dart->b, turn);
    return true;
}


double mus__board_dart_angle(const mus__board *board, int32_t leg)
{
    if (board->status != MUS_OK || leg < 0 || leg >= board->nside || board->side[leg].panel == MUS_NONE) return 0.0;
    if (!mus__board_dart_is(board, leg)) return 0.0;
    return dart_between(mus__board_start(board, leg), mus__board_end(board, leg),
                        mus__board_end(board, board->side[leg].next), dart_sense(board, board->side[leg].panel));
}


/* ---- legs and mouths ---- */

/* "name_d1" and "name_d2", or the next pair of numbers that is free in the panel; a long name is cut at a whole
 * character */
static void dart_names(const mus__board *board, int32_t panel, const char *name, char (*out)[MUS__NAME_BYTES])
{
    size_t n = strlen(name);
    if (n > MUS__NAME_BYTES - 16) n = MUS__NAME_BYTES - 16;
    while (n > 0 && ((unsigned char)name[n] & 0xC0) == 0x80) n--;
    for (int32_t k = 1;; k += 2) {
        for (int32_t i = 0; i < 2; i++)
            snprintf(out[i], MUS__NAME_BYTES, "%.*s_d%d", (int)n, n > 0 ? name : "", (int)(k + i));
        if (mus__board_find(board, panel, out[0]) == MUS_NONE && mus__board_find(board, panel, out[1]) == MUS_NONE)
            return;
    }
}


/* a straight side after `side` in the ring, to `end` */
static int32_t dart_line_after(mus__board *board, int32_t side, const char *name, const double *end)
{
    if (board->status != MUS_OK) return MUS_NONE;
    const int32_t kind = MUS_PIECE_LINE, panel = board->side[side].panel, next = board->side[side].next;
    const double *start = mus__board_end(board, side), xy[4] = {start[0], start[1], end[0], end[1]};
    mus__board_chain chain;
    mus__board_chain_make(board, 1, &kind, 2, xy, &chain);
    int32_t line = mus__board_side_new(board, panel, &chain);
    if (board->status != MUS_OK) return MUS_NONE;
    mus__board_rename(board, line, name, "");
    mus__board_follow(board, side, line);
    mus__board_follow(board, line, next);
    return line;
}


/* add the two sewn legs of a dart after side `before`, whose end and whose next side's start are its mouth; `allowance`
 * [m] is that of the legs. Returns the leg from the mouth */
int32_t mus__board_dart_legs(mus__board *board, int32_t before, const double *point, const char *name, double allowance)
{
    if (board->status != MUS_OK) return MUS_NONE;
    char names[2][MUS__NAME_BYTES];
    double mouth[2];
    memcpy(mouth, mus__board_start(board, board->side[before].next), sizeof mouth);
    dart_names(board, board->side[before].panel, name, names);
    int32_t leg = dart_line_after(board, before, names[0], point);
    int32_t back = dart_line_after(board, leg, names[1], mouth);
    mus__board_seam_add(board, leg, back, MUS_SEAM_REVERSED, 0.0);
    if (board->status != MUS_OK) return MUS_NONE;
    board->side[leg].attr.allowance = board->side[back].attr.allowance = allowance;
    return leg;
}


/* length of a name without the number at its end: "side1" and "side_2" are parts of one side */
static size_t dart_stem(const char *name)
{
    size_t n = strlen(name);
    while (n > 0 && name[n - 1] >= '0' && name[n - 1] <= '9') n--;
    while (n > 0 && name[n - 1] == '_') n--;
    return n;
}


/* are `side` and the next parts of one: alike in name and attributes, and without a corner between them? */
static bool dart_were_one(const mus__board *board, int32_t side)
{
    const mus__board_side *a = &board->side[side], *b = &board->side[a->next];
    if (a->next == side || !mus__board_mergeable(board, side) || !mus__edge_attributes_equal(&a->attr, &b->attr))
        return false;
    size_t n = dart_stem(a->name);
    bool alike = n == dart_stem(b->name) && memcmp(a->name, b->name, n) == 0;
    double before[2], after[2];
    mus__board_at(board, side, a->length, NULL, before);
    mus__board_at(board, a->next, 0.0, NULL, after);
    return alike && a->centre == b->centre && before[0] * after[0] + before[1] * after[1] > DART_CORNER;
}


/* merge `before` with the side that follows it after a dart between them has closed, if they were one side */
void mus__board_dart_close(mus__board *board, int32_t before)
{
    if (board->status == MUS_OK && dart_were_one(board, before)) mus__board_merge(board, before);
}


/* remove both legs and link the sides beside the dart. Returns the side before it */
int32_t mus__board_dart_remove(mus__board *board, const mus__dart *dart)
{
    if (board->status != MUS_OK) return MUS_NONE;
    int32_t before = board->side[dart->leg].prev, after = board->side[dart->back].next;
    mus__board_panel *panel = &board->panel[dart->panel];
    if (panel->first == dart->leg || panel->first == dart->back) panel->first = after;
    mus__board_side_remove(board, dart->leg);
    mus__board_side_remove(board, dart->back);
    mus__board_follow(board, before, after);
    return before;
}


/* ---- adding, shortening, releasing ---- */

/* cut `less` [m] off the end (or the start) of a side. Notches on that part move to the new end */
static void dart_trim(mus__board *board, int32_t side, bool end, double less)
{
    if (board->status != MUS_OK || !(less > 0.0)) return;
    mus__board_side *own = &board->side[side];
    double at = end ? own->length - less : less;
    mus__board_chain before, after;
    mus__board_chain_split(board, &own->chain, own->length, at, &before, &after);
    if (board->status != MUS_OK) return;
    mus__free(board->context, own->chain.xy);
    mus__free(board->context, end ? after.xy : before.xy);
    own->chain = end ? before : after;
    own->length = mus__board_chain_length(&own->chain);
    for (int32_t i = 0; i < board->nnotch; i++) {
        mus__board_notch *notch = &board->notch[i];
        if (notch->side == side) notch->s = fmin(fmax(end ? notch->s : notch->s - less, 0.0), own->length);
    }
}


int32_t mus__board_dart_add(mus__board *board, int32_t side, double s, double width, const double *point)
{
    if (!mus__board_has_side(board, side)) return MUS_NONE;
    const mus__board_side *own = &board->side[side];
    int32_t panel = own->panel;
    mus__board_rim_side(board, side, "dart");
    if (!(width > 0.0) || !(s - 0.5 * width >= MUS__DART_SAME) || !(s + 0.5 * width <= own->length - MUS__DART_SAME)) {
        mus__board_fail(board, MUS_ERR_ARG,
                        "dart on side %s of panel %s: a mouth of %g m about %g m is not within its %g m", own->name,
                        board->panel[panel].name, width, s, own->length);
        return MUS_NONE;
    }
    if (board->status == MUS_OK)
        board->status = mus__check_near(board->context, 1, 2, point, "dart on side %s of panel %s: its point",
                                        own->name, board->panel[panel].name);
    if (board->status != MUS_OK) return MUS_NONE;
    double a[2], b[2];
    mus__board_at(board, side, s - 0.5 * width, a, NULL);
    mus__board_at(board, side, s + 0.5 * width, b, NULL);
    mus__board_part_clear(board, panel, "dart", point, a);
    mus__board_part_clear(board, panel, "dart", point, b);

    /* take the mouth out of the side; its width is subtracted from the ease of the seam */
    mus__board_part_twins(board, panel);
    int32_t after = mus__board_split(board, side, s, NULL);
    dart_trim(board, side, true, 0.5 * width);
    dart_trim(board, after, false, 0.5 * width);
    mus__board_part_ease(board, side, -0.5 * width);
    mus__board_part_ease(board, after, -0.5 * width);

    /* true the legs: move both ends of the mouth to their mean distance from the point */
    double to_a = mus__dist2(a, point), to_b = mus__dist2(b, point), mean = 0.5 * (to_a + to_b);
    for (int i = 0; i < 2 && fabs(to_a - to_b) > 1e-12; i++) {
        a[i] = point[i] + mean / to_a * (a[i] - point[i]);
        b[i] = point[i] + mean / to_b * (b[i] - point[i]);
    }
    mus__board_part_move_end(board, side, true, a);
    mus__board_part_move_end(board, after, false, b);
    return board->status == MUS_OK ? mus__board_dart_legs(board, side, point, board->side[side].name, 0.0) : MUS_NONE;
}


void mus__board_dart_shorten(mus__board *board, int32_t leg, double back)
{
    mus__dart dart;
    if (!mus__board_dart_read(board, leg, &dart)) return;
    double to[2] = {0.5 * (dart.a[0] + dart.b[0]) - dart.point[0], 0.5 * (dart.a[1] + dart.b[1]) - dart.point[1]};
    double depth = mus__hypot(to[0], to[1]), point[2];
    if (!(back <= depth - DART_SHORTEST) || !(fabs(dart.angle) < MUS_PI)) {
        mus__board_fail(board, MUS_ERR_ARG,
                        "dart at %s of panel %s: %g m off its point leave less than %g m of its %g m",
                        board->side[leg].name, board->panel[dart.panel].name, back, DART_SHORTEST, depth);
        return;
    }
    for (int i = 0; i < 2; i++) point[i] = dart.point[i] + back / depth * to[i];
    if (!mus__near(2, point)) {
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: %g m off its point is no place on the table",
                        board->side[leg].name, board->panel[dart.panel].name, back);
        return;
    }
    /* a longer dart may cross the outline */
    if (back < 0.0) mus__board_part_clear(board, dart.panel, "dart", point, dart.a);
    if (back < 0.0) mus__board_part_clear(board, dart.panel, "dart", point, dart.b);
    mus__board_part_twins(board, dart.panel);
    mus__board_part_move_end(board, dart.leg, true, point);
    mus__board_part_move_end(board, dart.back, false, point);
}


int32_t mus__board_dart_release(mus__board *board, int32_t leg)
{
    mus__dart dart;
    if (!mus__board_dart_read(board, leg, &dart)) return MUS_NONE;
    double width = mus__dist2(dart.a, dart.b);
    int32_t before = board->side[leg].prev, after = board->side[dart.back].next;
    if (before == dart.back) {
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: it is the whole outline", board->side[leg].name,
                        board->panel[dart.panel].name);
        return MUS_NONE;
    }
    mus__board_part_twins(board, dart.panel);
    if (!(width > MUS__DART_SAME)) {
        mus__board_dart_close(board, mus__board_dart_remove(board, &dart));
        return board->status == MUS_OK ? before : MUS_NONE;
    }

    /* the side before the mouth is extended by a line across it; two notches mark the fullness */
    const int32_t kind = MUS_PIECE_LINE;
    const double xy[4] = {dart.a[0], dart.a[1], dart.b[0], dart.b[1]};
    mus__board_chain line, whole = {0};
    mus__board_chain_make(board, 1, &kind, 2, xy, &line);
    if (board->status == MUS_OK) mus__board_chain_join(board, &board->side[before].chain, &line, &whole);
    mus__free(board->context, line.xy);
    if (board->status != MUS_OK) return MUS_NONE;
    double mouth = board->side[before].length;
    mus__free(board->context, board->side[before].chain.xy);
    board->side[before].chain = whole;
    board->side[before].length = mouth + width;
    mus__board_part_ease(board, before, width);
    mus__board_dart_remove(board, &dart);
    mus__board_notch_add(board, before, mouth, MUS_NOTCH_SINGLE);
    mus__board_notch_add(board, before, mouth + width, MUS_NOTCH_SINGLE);
    if (after != before) mus__board_dart_close(board, before);
    return board->status == MUS_OK ? before : MUS_NONE;
}


/* ---- a dart as part of a seam ---- */

/* make panel `name` of the sides from `from` to just before `to`, which start at one point. Returns it */
static int32_t dart_part(mus__board *board, int32_t from, int32_t to, const char *name)
{
    if (board->status != MUS_OK) return MUS_NONE;
    int32_t old = board->side[from].panel, last = board->side[to].prev, before = board->side[from].prev;
    mus__board_part moving = {0}, still = {0};
    int32_t made = mus__board_panel_add(board, name, board->panel[old].attr.label);
    mus__board_part_run(board, &moving, from, last);
    mus__board_part_run(board, &still, to, before);
    mus__board_part_marks_to(board, old, &moving, &still, made);
    mus__board_part_end(board, &moving);
    mus__board_part_end(board, &still);
    if (board->status != MUS_OK) return MUS_NONE;

    mus__board_panel *a = &board->panel[old], *b = &board->panel[made];
    b->attr = a->attr;
    b->single = a->single;
    for (int32_t side = from;; side = board->side[side].next) {
        board->side[side].panel = made;
        if (side == last) break;
    }
    a->first = to, b->first = from;
    mus__board_follow(board, before, to);
    mus__board_follow(board, last, from);
    return made;
}


/* merge the sides from `side` on that join the two panels into one seam */
static void dart_seam(mus__board *board, int32_t side, const char *name)
{
    while (board->status == MUS_OK && mus__board_mergeable(board, side) && mus__board_partner(board, side) != MUS_NONE)
        mus__board_merge(board, side);
    if (board->status != MUS_OK) return;
    mus__board_rename(board, side, name, NULL);
    mus__board_rename(board, mus__board_partner(board, side), name, NULL);
}


int32_t mus__board_dart_to_seam(mus__board *board, int32_t leg, int32_t to, const mus__board_path *path,
                                const char *name, const char *seam_name)
{
    mus__dart dart;
    if (!mus__board_dart_read(board, leg, &dart) || !mus__board_has_side(board, to)) return MUS_NONE;
    const char *panel = board->panel[dart.panel].name;
    if (board->side[to].panel != dart.panel || to == dart.leg || to == dart.back) {
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: side %s is no place for its seam to end",
                        board->side[leg].name, panel, board->side[to].name);
        return MUS_NONE;
    }
    if (path != NULL) {
        int32_t made = mus__board_cut(board, dart.back, to, path, name, seam_name);
        dart_seam(board, leg, seam_name);
        return board->status == MUS_OK ? made : MUS_NONE;
    }

    /* without a cut the seam continues in a dart with the same point */
    double gap = mus__dist2(dart.point, mus__board_start(board, to));
    if (!(gap <= MUS__DART_SAME)) {
        mus__board_fail(board, MUS_ERR_ARG, "dart at %s of panel %s: its point is %g m from the start of side %s",
                        board->side[leg].name, panel, gap, board->side[to].name);
        return MUS_NONE;
    }
    mus__board_part_twins(board, dart.panel);
    int32_t made = dart_part(board, dart.back, to, name);
    dart_seam(board, leg, seam_name);
    return board->status == MUS_OK ? made : MUS_NONE;
}
