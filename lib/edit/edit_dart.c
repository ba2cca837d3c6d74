/*
 * edit_dart.c: the edits of darts (muslin/edit.h), each a few calls of the cutting table (board_dart.c).
 *
 * A split into several darts takes the targets of one edge from its far end backwards, so that arc lengths from its
 * start stay true while it is divided. Dart i closes f_i / (1 - f_1 - ... - f_(i-1)) of the angle that is left, where
 * f_i is its fraction of the whole angle.
 */
#include <math.h>
#include <string.h>

#include "board/board_dart.h"
#include "board/board_rigid_part.h"
#include "edit/edit_internal.h"
#include "geom/vec.h"

#define EDIT_SAME 1e-6  /* [m] the points of two darts within this are one; chosen: above rounding */
#define EDIT_TARGETS 64 /* most targets of a split; chosen: bounds the arrays on the stack */
/* fractions whose sum is this near to 1 close the dart whole: rounding of the sum */
#define EDIT_WHOLE 1e-12


mus_status mus_pattern_dart(const mus_pattern *pattern, int32_t leg, double *angle, double *width, double *depth)
{
    double own[3] = {(double)NAN, (double)NAN, (double)NAN}, *out[3] = {angle, width, depth};
    for (int i = 0; i < 3; i++)
        if (out[i] != NULL) *out[i] = own[i];
    if (pattern == NULL) return MUS_ERR_ARG;

    /* measure on a table, which leaves the pattern as it is */
    mus_status status = mus__pattern_known(pattern, "edge", leg, pattern->nedge);
    if (status != MUS_OK) return status;
    mus__board board;
    mus__board_read(&board, pattern);
    int32_t side = 0, place = 0;
    for (int32_t i = 0; i < pattern->npanel && board.status == MUS_OK; i++)
        for (int32_t k = 0; k < pattern->panel[i].noutline; k++, place++)
            if (pattern->panel[i].outline[k] == leg) side = place;
    if (board.status == MUS_OK && mus__board_partner(&board, side) == board.side[side].prev &&
        !(mus__board_dart_angle(&board, side) > 0.0))
        side = board.side[side].prev;
    own[0] = mus__board_dart_angle(&board, side);
    if (board.status == MUS_OK && !(own[0] > 0.0)) {
        char title[2 * MUS__NAME_BYTES];
        mus__pattern_edge_title(pattern, leg, title);
        mus__board_fail(&board, MUS_ERR_ARG, "edge %s: it is no leg of a dart, sewn to the one beside it", title);
    }
    if (board.status == MUS_OK) {
        const int32_t back = board.side[side].next;
        own[1] = mus__dist2(mus__board_start(&board, side), mus__board_end(&board, back));
        own[2] = fmax(board.side[side].length, board.side[back].length);
        for (int i = 0; i < 3; i++)
            if (out[i] != NULL) *out[i] = own[i];
    }
    status = board.status;
    mus__board_free(&board);
    return status;
}


mus_status mus_pattern_add_dart(mus_pattern *pattern, int32_t edge, double s, double width, const double *point,
                                int32_t *leg)
{
    if (leg != NULL) *leg = MUS_NONE;
    if (pattern != NULL && point == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "dart: its point is NULL");
    mus__editing e;
    double at;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t side = mus__edit_place(&e, edge, s, &at);
    const int32_t made = mus__board_dart_add(&e.board, side, at, width, point);
    return mus__edit_end(&e, 1, &made, &leg);
}


mus_status mus_pattern_rotate_dart(mus_pattern *pattern, int32_t leg, int32_t target, double s, int32_t keep,
                                   double fraction, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    mus__editing e;
    double at;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t from = mus__edit_leg(&e, leg), to = mus__edit_place(&e, target, s, &at);
    const int32_t made = mus__board_dart_rotate(&e.board, from, to, at, mus__edit_side(&e, keep), fraction);
    return mus__edit_end(&e, 1, &made, &out);
}


/* one of several targets */
typedef struct edit_target {
    int32_t index, side;
    double at, fraction;
} edit_target;


/* sort: later places of one side first, otherwise in the order given */
static void edit_sort_targets(edit_target *list, int32_t n)
{
    for (int32_t i = 1; i < n; i++) {
        const edit_target own = list[i];
        int32_t j = i;
        for (; j > 0 && list[j - 1].side == own.side && list[j - 1].at < own.at; j--) list[j] = list[j - 1];
        list[j] = own;
    }
}


/* bring the targets of each side together, and sort them */
static void edit_group_targets(edit_target *list, int32_t n)
{
    for (int32_t i = 0; i < n; i++) {
        int32_t end = i + 1;
        for (int32_t j = i + 1; j < n; j++) {
            if (list[j].side != list[i].side) continue;
            const edit_target own = list[j];
            memmove(list + end + 1, list + end, (size_t)(j - end) * sizeof *list);
            list[end++] = own;
        }
        i = end - 1;
    }
    edit_sort_targets(list, n);
}


static mus_status edit_split_check(mus_pattern *pattern, int32_t n, const int32_t *targets, const double *s,
                                   const double *fractions)
{
    mus_context *context = pattern->context;
    if (n < 1 || n > EDIT_TARGETS || targets == NULL || s == NULL || fractions == NULL)
        return mus__fail(context, MUS_ERR_ARG, "split of a dart: %d targets are outside 1 to %d", (int)n, EDIT_TARGETS);
    double sum = 0.0;
    for (int32_t i = 0; i < n; i++) {
        sum += fractions[i];
        if (!(fractions[i] > 0.0) || !(sum <= 1.0 + EDIT_WHOLE))
            return mus__fail(
                context, MUS_ERR_ARG,
                "split of a dart: fraction %d is %g, all up to it %g; each is above 0, all together 1 at most", (int)i,
                fractions[i], sum);
    }
    return MUS_OK;
}


mus_status mus_pattern_split_dart(mus_pattern *pattern, int32_t leg, int32_t n, const int32_t *targets, const double *s,
                                  const double *fractions, int32_t keep, int32_t *out)
{
    for (int32_t i = 0; out != NULL && i < n; i++) out[i] = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus__editing e;
    edit_target list[EDIT_TARGETS];
    int32_t made[EDIT_TARGETS], *outs[EDIT_TARGETS];
    mus_status status = edit_split_check(pattern, n, targets, s, fractions);
    if (status == MUS_OK) status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;

    const int32_t from = mus__edit_leg(&e, leg), still = mus__edit_side(&e, keep);
    for (int32_t i = 0; i < n; i++) {
        list[i] = (edit_target){.index = i, .fraction = fractions[i]};
        list[i].side = mus__edit_place(&e, targets[i], s[i], &list[i].at);
    }
    edit_group_targets(list, n);
    double left = 1.0;
    for (int32_t i = 0; i < n; i++) {
        const double part = list[i].fraction / left;
        const bool last = i == n - 1 && left - list[i].fraction <= EDIT_WHOLE;
        made[list[i].index] =
            mus__board_dart_rotate(&e.board, from, list[i].side, list[i].at, still, last ? 1.0 : part);
        left -= list[i].fraction;
    }
    for (int32_t i = 0; i < n; i++) outs[i] = out != NULL ? &out[i] : NULL;
    return mus__edit_end(&e, n, made, outs);
}


mus_status mus_pattern_merge_darts(mus_pattern *pattern, int32_t leg, int32_t into, int32_t keep, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const int32_t from = mus__edit_leg(&e, leg), to = mus__edit_leg(&e, into), still = mus__edit_side(&e, keep);
    int32_t made = MUS_NONE;
    if (board->status == MUS_OK) {
        const double gap = mus__dist2(mus__board_end(board, from), mus__board_end(board, to));
        if (!(mus__board_dart_angle(board, to) > 0.0) || !(gap <= EDIT_SAME))
            mus__board_fail(board, MUS_ERR_ARG, "merge of darts: the point of %s is %g m from that of %s, at most %g m",
                            board->side[from].name, gap, board->side[to].name, EDIT_SAME);
    }

    /* the place where the other dart opens, on the side before it */
    if (board->status == MUS_OK) {
        const int32_t before = board->side[to].prev;
        made = mus__board_dart_rotate(board, from, before, board->side[before].length, still, 1.0);
    }
    return mus__edit_end(&e, 1, &made, &out);
}


mus_status mus_pattern_shorten_dart(mus_pattern *pattern, int32_t leg, double back)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board_dart_shorten(&e.board, mus__edit_leg(&e, leg), back);
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_release_dart(mus_pattern *pattern, int32_t leg, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t side = mus__board_dart_release(&e.board, mus__edit_leg(&e, leg));
    return mus__edit_end(&e, 1, &side, &out);
}


mus_status mus_pattern_dart_to_seam(mus_pattern *pattern, const mus_cut_def *def, int32_t *panel, int32_t *seam)
{
    mus__editing e;
    mus_cut_def cut;
    const mus_status status = mus__edit_begin_cut(&e, pattern, def, &cut, panel, seam);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const int32_t from = mus__edit_leg(&e, cut.edge_a);
    int32_t to, again, made = MUS_NONE;
    mus__edit_corners(&e, cut.edge_b, cut.s_b, cut.edge_b, cut.s_b, &to, &again);
    if (board->status == MUS_OK) {
        const double *start = mus__board_end(board, from), *end = mus__board_start(board, to);
        const bool one =
            mus__dist2(start, end) <= EDIT_SAME && mus__board_dart_angle(board, board->side[to].prev) > 0.0;
        const int32_t old = board->side[from].panel;
        mus__board_path path;
        double *all = mus__edit_path(&e, start, end, &cut, &path);
        if (all != NULL && !one) to = mus__board_rim_corner(board, to, all + 2 * (ptrdiff_t)cut.nxy, "cut");
        mus__edit_cut_begin(&e, old);
        if (board->status == MUS_OK)
            made = mus__board_dart_to_seam(board, from, to, one ? NULL : &path, cut.name, cut.seam_name);
        mus__free(board->context, all);
        mus__edit_cut_check(&e, old, made);
    }
    return mus__edit_end_panel(&e, made, panel, from, seam);
}
