/*
 * board_mirror.c: mirror images: of a panel, of a half panel in its fold, of the half of a garment.
 *
 * The image of a ring is walked the other way round, so the cloth stays to the left:
 *
 *      ring  f s1 s2 .. sk          image  sk' .. s2 s1' f'
 *      unfolded in f                s1 s2 .. sk sk' .. s2' s1'
 *
 * and a seam between two sides holds between their images in the same direction. Doubling a half garment copies every
 * side but the folds, repeats the seams on the copies, sews centre sides to their images, and makes one side of two
 * that meet on a fold (hem and hem') where what they are sewn to allows it.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/elementary.h"
#include "board/board_cut.h"
#include "board/board_seam.h"
#include "geom/vec.h"

#define DOUBLE_STRAIGHT 1e-6 /* [m] a fold is straight, and a mark lies on it, within this; chosen: above rounding */

#define DOUBLE_BOTH (MUS_SIDE_LEFT | MUS_SIDE_RIGHT)

/* a reflection: the map of the plane, and the image of each side that existed before it */
typedef struct double_mirror {
    double map[6];
    int32_t *image; /* (nside at the start) MUS_NONE without one */
    int32_t nside;
} double_mirror;


/* start the list of images, for the sides on the board now */
static bool double_begin(mus__board *board, double_mirror *mirror)
{
    const double map[6] = {-1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    memcpy(mirror->map, map, sizeof map);
    mirror->nside = board->nside;
    mirror->image = board->status == MUS_OK ? mus__room(board->context, board->nside, sizeof *mirror->image) : NULL;
    if (mirror->image == NULL) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a mirror image");
        return false;
    }
    for (int32_t i = 0; i < mirror->nside; i++) mirror->image[i] = MUS_NONE;
    return true;
}


/* the reflection in a straight side as a map; exact for an upright side. False, and the board fails, when the side is
 * sewn or bent */
static bool double_axis(mus__board *board, int32_t side, double *map)
{
    const mus__board_chain *chain = &board->side[side].chain;
    const double *p = mus__board_start(board, side), *q = mus__board_end(board, side);
    const double x = q[0] - p[0], y = q[1] - p[1], norm = mus__hypot(x, y), u = x / norm, v = y / norm;
    bool straight = norm > 0.0;
    for (int32_t i = 0; i < chain->nxy && straight; i++) {
        const double *r = chain->xy + 2 * (size_t)i;
        straight = fabs((r[0] - p[0]) * v - (r[1] - p[1]) * u) <= DOUBLE_STRAIGHT;
    }
    if (!straight || mus__board_seam_of(board, side) != MUS_NONE) {
        mus__board_fail(board, MUS_ERR_PATTERN, "side %s of panel %s is no fold: it is %s", board->side[side].name,
                        board->panel[board->side[side].panel].name, straight ? "sewn" : "not straight");
        return false;
    }
    const double a = u * u - v * v, b = 2.0 * u * v;
    const double own[6] = {a, b, p[0] - (a * p[0] + b * p[1]), b, -a, p[1] - (b * p[0] - a * p[1])};
    const double upright[6] = {-1.0, 0.0, p[0] + q[0], 0.0, 1.0, 0.0};
    memcpy(map, fabs(u) <= 1e-9 ? upright : own, sizeof own);
    return true;
}


/* the image of one side in `panel`: walked the other way, without neighbours; its notches too */
static int32_t double_side(mus__board *board, double_mirror *mirror, int32_t side, int32_t panel)
{
    const mus__board_chain *from = &board->side[side].chain;
    mus__board_chain chain;
    mus__board_chain_make(board, from->npiece, from->kinds, from->nxy, from->xy, &chain);
    if (chain.xy == NULL) return MUS_NONE;
    mus__board_chain_move(&chain, mirror->map);
    mus__board_chain_reverse(&chain);
    const int32_t made = mus__board_side_new(board, panel, &chain);
    if (made == MUS_NONE) return MUS_NONE;

    const mus__board_side *own = &board->side[side];
    mus__board_side *image = &board->side[made];
    memcpy(image->name, own->name, sizeof image->name);
    image->backward = own->backward;
    image->attr = own->attr;
    image->knot = board->side[own->next].knot;
    image->length = own->length;
    mirror->image[side] = made;
    const int32_t nnotch = board->nnotch;
    for (int32_t i = 0; i < nnotch && board->status == MUS_OK; i++) {
        const mus__board_notch notch = board->notch[i];
        if (notch.side == side) mus__board_notch_add(board, made, board->side[side].length - notch.s, notch.kind);
    }
    return made;
}


/* images of the sides from `last` back to `first`, one after the other: the first and last of them in ends (2) */
static void double_ring(mus__board *board, double_mirror *mirror, int32_t last, int32_t first, int32_t panel,
                        int32_t *ends)
{
    ends[0] = ends[1] = MUS_NONE;
    for (int32_t side = last;; side = board->side[side].prev) {
        const int32_t made = double_side(board, mirror, side, panel);
        if (made == MUS_NONE) return;
        if (ends[0] == MUS_NONE)
            ends[0] = made;
        else
            mus__board_follow(board, ends[1], made);
        ends[1] = made;
        if (side == first) return;
    }
}


/* the marks of a panel, mirrored to `to`; on the same panel those that lie on the axis are their own images */
static void double_marks(mus__board *board, const double_mirror *mirror, int32_t panel, int32_t to)
{
    const int32_t nmark = board->nmark;
    for (int32_t i = 0; i < nmark && board->status == MUS_OK; i++) {
        if (board->mark[i].panel != panel) continue;
        char name[MUS__NAME_BYTES];
        memcpy(name, board->mark[i].name, sizeof name);
        const int32_t n = board->mark[i].n;
        const int32_t made = mus__board_mark_add(board, to, name, n, board->mark[i].xy);
        if (made == MUS_NONE) return;
        const mus__board_chain points = {.nxy = n, .xy = board->mark[made].xy};
        mus__board_chain turned = points;
        mus__board_chain_move(&turned, mirror->map);
        double off = 0.0;
        for (int32_t k = 0; k < n; k++)
            off = fmax(off, mus__dist2(points.xy + 2 * (size_t)k, board->mark[i].xy + 2 * (size_t)k));
        if (to == panel && off <= DOUBLE_STRAIGHT) board->mark[made].panel = MUS_NONE;
    }
}


/* repeat the seams of which both sides have an image; with `panel` only those within it */
static void double_seams(mus__board *board, const double_mirror *mirror, int32_t panel)
{
    const int32_t nseam = board->nseam;
    for (int32_t i = 0; i < nseam && board->status == MUS_OK; i++) {
        const mus__board_seam seam = board->seam[i];
        if (seam.a == MUS_NONE || seam.a >= mirror->nside || seam.b >= mirror->nside) continue;
        if (panel != MUS_NONE && (board->side[seam.a].panel != panel || board->side[seam.b].panel != panel)) continue;
        const int32_t a = mirror->image[seam.a], b = mirror->image[seam.b];
        if (a == MUS_NONE || b == MUS_NONE) continue;
        const int32_t made = mus__board_seam_add(board, a, b, seam.direction, seam.ease);
        if (made == MUS_NONE) return;
        board->seam[made].tolerance = seam.tolerance;
        board->seam[made].bridge = seam.bridge;
        mus__board_seam_like(board, made, i);
    }
}


/* X to -X in space: p' = D p in the panel's frame, D = diag(-1, 1, 1), so rotation' = M rotation D, origin' = M origin
 * with M = D; a bend keeps its sign and its line goes to the other side */
static void double_place(const mus_placement *from, mus_placement *to)
{
    static const double sign[9] = {1.0, -1.0, -1.0, -1.0, 1.0, 1.0, -1.0, 1.0, 1.0};
    *to = *from;
    to->origin[0] = -from->origin[0];
    for (int32_t i = 0; i < 9; i++) to->rotation[i] = sign[i] * from->rotation[i] + 0.0;
    to->bend_x = 0.0 - from->bend_x;
}


/* add the image of a panel as a panel `name` */
static int32_t double_panel(mus__board *board, double_mirror *mirror, int32_t panel, const char *name)
{
    const int32_t first = board->panel[panel].first;
    if (first == MUS_NONE || board->side[first].prev == MUS_NONE ||
        board->side[board->side[first].prev].next == MUS_NONE) {
        mus__board_fail(board, MUS_ERR_PATTERN, "panel %s is not closed", board->panel[panel].name);
        return MUS_NONE;
    }
    const int32_t made = mus__board_panel_add(board, name, board->panel[panel].attr.label);
    int32_t ends[2];
    if (made == MUS_NONE) return MUS_NONE;
    double_ring(board, mirror, board->side[first].prev, first, made, ends);
    if (board->status != MUS_OK) return MUS_NONE;
    mus__board_follow(board, ends[1], ends[0]);
    double_marks(board, mirror, panel, made);

    mus__board_panel *own = &board->panel[panel], *image = &board->panel[made];
    image->first = ends[0];
    image->single = own->single;
    image->attr = own->attr;
    image->attr.grain[0] = 0.0 - own->attr.grain[0];
    if (own->attr.sides != MUS_NONE && (own->attr.sides & DOUBLE_BOTH) != 0) image->attr.sides ^= DOUBLE_BOTH;
    double_place(&own->attr.placement, &image->attr.placement);
    return made;
}


/* panel `twin` is cut as the mirror image of `panel`, unless that is an image itself */
static void double_twins(mus__board *board, int32_t panel, int32_t twin)
{
    if (board->panel[panel].mirror_of != MUS_NONE) return;
    board->panel[twin].mirror_of = panel;
    mus__board_add_cut(board, panel, board->panel[twin].attr.cut, 1);
}


int32_t mus__board_mirror(mus__board *board, int32_t panel, const char *name)
{
    double_mirror mirror;
    if (!mus__board_has_panel(board, panel) || !double_begin(board, &mirror)) return MUS_NONE;
    const int32_t made = double_panel(board, &mirror, panel, name);
    if (made != MUS_NONE) double_seams(board, &mirror, panel);
    if (board->status == MUS_OK) double_twins(board, panel, made);
    mus__free(board->context, mirror.image);
    return board->status == MUS_OK ? made : MUS_NONE;
}


/* ---- unfolding ---- */

/* the name of the image: sideL and sideR, or side and side_r */
static void double_rename(mus__board *board, int32_t side)
{
    char name[MUS__NAME_BYTES + 2];
    const size_t n = strlen(board->side[side].name);
    if (n == 0) return;
    snprintf(name, sizeof name, "%s", board->side[side].name);
    if (name[n - 1] == 'L')
        name[n - 1] = 'R';
    else if (name[n - 1] == 'R')
        name[n - 1] = 'L';
    else
        memcpy(name + n, "_r", sizeof "_r");
    mus__board_rename(board, side, name, NULL);
}


/* unfold a panel in a side, which is removed; seams are left to the caller */
static void double_unfold(mus__board *board, double_mirror *mirror, int32_t fold)
{
    const int32_t panel = board->side[fold].panel, first = board->side[fold].next, last = board->side[fold].prev;
    if (!double_axis(board, fold, mirror->map)) return;
    if (first == MUS_NONE || last == MUS_NONE || first == fold || board->side[last].next != fold) {
        mus__board_fail(board, MUS_ERR_PATTERN, "panel %s is not closed", board->panel[panel].name);
        return;
    }
    mus__board_part_twins(board, panel);
    double_marks(board, mirror, panel, panel);
    int32_t ends[2];
    double_ring(board, mirror, last, first, panel, ends);
    if (board->status != MUS_OK) return;

    /* the ring: ... last, its image, ..., the image of the first, first ... */
    mus__board_follow(board, last, ends[0]);
    mus__board_side *end = &board->side[ends[1]];
    memcpy(end->chain.xy + 2 * ((size_t)end->chain.nxy - 1), mus__board_start(board, first), 2 * sizeof(double));
    end->next = first;
    board->side[first].prev = ends[1];
    if (board->panel[panel].first == fold) board->panel[panel].first = first;
    mus__board_side_remove(board, fold);
    if (board->panel[panel].attr.sides != MUS_NONE) board->panel[panel].attr.sides &= ~DOUBLE_BOTH;
    for (int32_t side = ends[0]; side != first; side = board->side[side].next) double_rename(board, side);
}


/* merge each side with its image where they meet on a fold, if their seams allow it. Names are set first: of two such
 * pairs that are sewn to one another, merging one merges the other */
static void double_merge(mus__board *board, const double_mirror *mirror)
{
    for (int32_t pass = 0; pass < 2; pass++) {
        for (int32_t i = 0; i < mirror->nside && board->status == MUS_OK; i++) {
            const int32_t image = mirror->image[i];
            if (image == MUS_NONE || board->side[i].panel == MUS_NONE ||
                board->side[image].panel != board->side[i].panel)
                continue;
            const bool after = board->side[i].next == image, before = board->side[image].next == i;
            if (!after && !before) continue;
            if (pass == 1 && strcmp(board->side[i].name, board->side[image].name) != 0) continue;
            if (!mus__board_mergeable(board, after ? i : image)) continue;
            if (pass == 0)
                memcpy(board->side[image].name, board->side[i].name, sizeof board->side[i].name);
            else
                mus__board_merge(board, after ? i : image);
        }
    }
}


void mus__board_unfold(mus__board *board, int32_t side)
{
    double_mirror mirror;
    if (!mus__board_has_side(board, side) || !double_begin(board, &mirror)) return;
    const int32_t panel = board->side[side].panel;
    double_unfold(board, &mirror, side);
    double_seams(board, &mirror, panel);
    double_merge(board, &mirror);
    mus__free(board->context, mirror.image);
}


/* ---- a whole garment ---- */

/* merge folds that continue over a vertex */
static void double_fold_merge(mus__board *board)
{
    for (int32_t i = 0; i < board->nside && board->status == MUS_OK; i++) {
        while (board->status == MUS_OK && board->side[i].panel != MUS_NONE &&
               board->side[i].centre == MUS__CENTRE_FOLD && board->side[i].next != i &&
               board->side[i].next != MUS_NONE && board->side[board->side[i].next].centre == MUS__CENTRE_FOLD &&
               mus__board_mergeable(board, i))
            mus__board_merge(board, i);
    }
}


/* a fold of a panel, or MUS_NONE */
static int32_t double_fold_of(const mus__board *board, int32_t panel)
{
    for (int32_t i = 0; i < board->nside; i++)
        if (board->side[i].panel == panel && board->side[i].centre == MUS__CENTRE_FOLD) return i;
    return MUS_NONE;
}


/* rename a panel without a fold NAME_left, and add its image NAME_right */
static void double_pair(mus__board *board, double_mirror *mirror, int32_t panel)
{
    char name[2][MUS__NAME_BYTES + 8];
    size_t n = strlen(board->panel[panel].name);
    const char *own = board->panel[panel].name;
    if (n > 5 && strcmp(own + n - 5, "_left") == 0) n -= 5;
    snprintf(name[0], sizeof name[0], "%.*s_left", (int)n, own);
    snprintf(name[1], sizeof name[1], "%.*s_right", (int)n, own);
    const int32_t other = mus__board_find_panel(board, name[0]);
    if (strlen(name[1]) >= MUS__NAME_BYTES || (other != MUS_NONE && other != panel)) {
        mus__board_fail(board, MUS_ERR_ARG, "panel %s: the name %s is too long or another panel's", own, name[0]);
        return;
    }
    const double map[6] = {-1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    memcpy(mirror->map, map, sizeof map);
    const int32_t made = double_panel(board, mirror, panel, name[1]);
    if (made == MUS_NONE) return;
    memset(board->panel[panel].name, 0, MUS__NAME_BYTES);
    memcpy(board->panel[panel].name, name[0], strlen(name[0]));
    double_twins(board, panel, made);
}


void mus__board_double(mus__board *board)
{
    double_mirror mirror;
    double_fold_merge(board);
    if (!double_begin(board, &mirror)) return;
    const int32_t npanel = board->npanel;
    for (int32_t i = 0; i < npanel && board->status == MUS_OK; i++) {
        if (board->panel[i].name[0] == '\0' || board->panel[i].single != 0) continue;
        const int32_t fold = double_fold_of(board, i);
        if (fold != MUS_NONE)
            double_unfold(board, &mirror, fold);
        else
            double_pair(board, &mirror, i);
    }

    /* repeat the seams of the half on the other half; sew centre sides to their images, and a second fold of a panel
     * too */
    double_seams(board, &mirror, MUS_NONE);
    for (int32_t i = 0; i < mirror.nside && board->status == MUS_OK; i++) {
        const int32_t centre = board->side[i].centre, image = mirror.image[i];
        if (image != MUS_NONE && (centre == MUS__CENTRE_SEAM || centre == MUS__CENTRE_FOLD))
            mus__board_seam_add(board, i, image, MUS_SEAM_REVERSED, 0.0);
    }
    double_merge(board, &mirror);
    mus__free(board->context, mirror.image);
}
