/*
 * board_read_write.c: a pattern onto the cutting table, and from the table a new pattern.
 *
 * Each position in the word of a panel becomes a side in the direction of the word: an edge that is passed against its
 * direction is reversed, and so are its seams and notches. An edge that a word passes twice (the bridge to a hole)
 * becomes two sides and a seam between them that is marked as a bridge; as long as both are the same line of one panel,
 * they are written as one edge again. Corners keep the index of their point (knot), so that an outline that comes back
 * to a point is written with one point there.
 *
 * Writing uses the public calls, which check the pattern. A table that is read and written is the same pattern, with
 * its cells in the order of panels and of their words.
 */
#include <math.h>
#include <string.h>

#include "board/board_curve.h"


/* ---- reading ---- */

/* add one position of a word as a side; first (nedge) gets the first side of each edge */
static void board_read_side(mus__board *board, const mus_pattern *pattern, int32_t edge, int32_t turn, int32_t *first)
{
    const mus__edge *from = &pattern->edge[edge];
    mus__board_chain chain;
    mus__board_chain_make(board, from->npiece, from->kinds, from->nxy, from->xy, &chain);
    if (chain.xy == NULL) return;
    if (turn < 0) mus__board_chain_reverse(&chain);

    /* there is room for all sides; the length is that of the edge */
    const int32_t index = board->nside++;
    mus__board_side *side = &board->side[index];
    *side = (mus__board_side){.panel = from->panel,
                              .prev = index - 1,
                              .next = index + 1,
                              .backward = turn < 0,
                              .knot = turn < 0 ? from->end : from->start,
                              .attr = from->attr,
                              .chain = chain,
                              .length = from->run[from->npiece]};
    memcpy(side->name, from->name, sizeof side->name);
    if (first[edge] == MUS_NONE) {
        first[edge] = index;
        return;
    }
    const bool alike = side->backward == board->side[first[edge]].backward;
    board->seam[board->nseam++] = (mus__board_seam){.a = first[edge],
                                                    .b = index,
                                                    .direction = alike ? MUS_SEAM_DIRECT : MUS_SEAM_REVERSED,
                                                    .tolerance = 0.0005,
                                                    .bridge = true};
}


static void board_read_panel(mus__board *board, const mus_pattern *pattern, int32_t panel, int32_t *first)
{
    const mus__panel *from = &pattern->panel[panel];
    if (from->noutline == 0) {
        mus__board_fail(board, MUS_ERR_PATTERN, "panel %s has no outline", from->name);
        return;
    }
    const int32_t start = board->nside;
    for (int32_t k = 0; k < from->noutline && board->status == MUS_OK; k++)
        board_read_side(board, pattern, from->outline[k], from->outline[from->noutline + k], first);
    if (board->status != MUS_OK) return;
    board->side[start].prev = board->nside - 1;
    board->side[board->nside - 1].next = start;

    mus__board_panel *own = &board->panel[board->npanel++];
    *own = (mus__board_panel){.first = start,
                              .mirror_of = from->mirror_of,
                              .attr = from->attr};
    memcpy(own->name, from->name, sizeof own->name);
}


/* seams, notches, marks and openings */
static void board_read_rest(mus__board *board, const mus_pattern *pattern, const int32_t *first)
{
    for (int32_t i = 0; i < pattern->nseam; i++) {
        const mus_seam_def *from = &pattern->seam[i];
        const int32_t a = first[from->edge_a], b = first[from->edge_b];
        const bool turned = board->side[a].backward != board->side[b].backward;
        const int32_t other = from->direction == MUS_SEAM_DIRECT ? MUS_SEAM_REVERSED : MUS_SEAM_DIRECT;
        board->seam[i] = (mus__board_seam){.a = a,
                                           .b = b,
                                           .direction = turned ? other : from->direction,
                                           .ease = from->ease,
                                           .tolerance = from->tolerance,
                                           .laid = from->laid,
                                           .closure = from->closure,
                                           .open = from->open,
                                           .buttons = from->buttons};
    }
    for (int32_t i = 0; i < pattern->nnotch; i++) {
        const mus__notch *from = &pattern->notch[i];
        const int32_t index = first[from->edge];
        const mus__board_side *side = &board->side[index];
        mus__board_notch_add(board, index, side->backward ? side->length - from->s : from->s, from->kind);
    }
    for (int32_t i = 0; i < pattern->nmark; i++) {
        const mus__mark *from = &pattern->mark[i];
        mus__board_mark_add(board, from->panel, from->name, from->n, from->xy);
    }
    for (int32_t i = 0; i < pattern->nopening; i++) mus__board_opening_add(board, pattern->opening[i].label);
}


void mus__board_read(mus__board *board, const mus_pattern *pattern)
{
    mus_context *context = pattern->context;
    mus__board_begin(board, context, pattern->name);
    int64_t nside = 0;
    for (int32_t i = 0; i < pattern->npanel; i++) nside += pattern->panel[i].noutline;

    /* bridges follow the seams of the pattern, whose indices stay */
    int32_t *first = mus__new(context, pattern->nedge, sizeof *first);
    if (first == NULL ||
        mus__reserve(context, &board->panel, &board->panel_room, pattern->npanel, sizeof *board->panel) != MUS_OK ||
        mus__reserve(context, &board->side, &board->side_room, nside, sizeof *board->side) != MUS_OK ||
        mus__reserve(context, &board->seam, &board->seam_room, pattern->nseam + nside, sizeof *board->seam) != MUS_OK)
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a pattern on the table");
    for (int32_t i = 0; i < pattern->nedge && first != NULL; i++) first[i] = MUS_NONE;
    board->nseam = board->status == MUS_OK ? pattern->nseam : 0;
    board->nknot = pattern->npoint;
    for (int32_t i = 0; i < pattern->npanel && board->status == MUS_OK; i++) board_read_panel(board, pattern, i, first);
    for (int32_t i = 0; i < pattern->nedge && board->status == MUS_OK; i++) {
        if (first[i] != MUS_NONE) continue;
        char title[2 * MUS__NAME_BYTES];
        mus__pattern_edge_title(pattern, i, title);
        mus__board_fail(board, MUS_ERR_PATTERN, "edge %s is in no outline", title);
    }
    if (board->status == MUS_OK) board_read_rest(board, pattern, first);
    mus__free(context, first);
}


/* ---- writing ---- */

/* the pattern under construction, and the cell of each record; arrays are parts of one block */
typedef struct board_writer {
    mus__board *board;
    mus_pattern *pattern;
    int32_t *panel; /* (npanel) */
    int32_t *point; /* (nside) where the side starts */
    int32_t *edge;  /* (nside) */
    int32_t *turn;  /* (nside) +1 the edge runs as the side does, -1 against it */
    int32_t *ring;  /* (nside) sides of the panel at hand, as walked */
    int32_t *word;  /* (2 nside) its edges, then their directions */
} board_writer;


/* the point of the corner of ring[k]: that of an earlier side with the same knot and place, otherwise a new point */
static mus_status board_write_point(board_writer *w, int32_t panel, int32_t k)
{
    const mus__board *board = w->board;
    const int32_t side = w->ring[k], knot = board->side[side].knot;
    const double *xy = mus__board_start(board, side);
    for (int32_t j = 0; j < k && knot != MUS_NONE; j++) {
        const double *other = mus__board_start(board, w->ring[j]);
        if (board->side[w->ring[j]].knot != knot || other[0] != xy[0] || other[1] != xy[1]) continue;
        w->point[side] = w->point[w->ring[j]];
        return MUS_OK;
    }
    return mus_pattern_add_point(w->pattern, panel, xy[0], xy[1], &w->point[side]);
}


/* the bridge of ring[k] to *twin, a side that is written already and lies on the same points; MUS_NONE without one. In
 * a mirror image the later side comes first */
static int32_t board_write_bridge(const board_writer *w, int32_t k, int32_t *twin)
{
    const mus__board *board = w->board;
    const mus__board_side *side = &board->side[w->ring[k]];
    for (int32_t i = 0; i < board->nseam; i++) {
        const mus__board_seam *seam = &board->seam[i];
        if (!seam->bridge || (seam->a != w->ring[k] && seam->b != w->ring[k])) continue;
        *twin = seam->a == w->ring[k] ? seam->b : seam->a;
        const bool reversed = seam->direction == MUS_SEAM_REVERSED;
        const mus__board_side *other = &board->side[*twin];
        if (other->panel != side->panel || w->edge[*twin] == MUS_NONE) continue;
        const int32_t start = w->point[*twin], end = w->point[other->next];
        if (mus__board_chain_same(&other->chain, &side->chain, reversed) &&
            w->point[w->ring[k]] == (reversed ? end : start) && w->point[side->next] == (reversed ? start : end))
            return i;
    }
    return MUS_NONE;
}


/* write ring[k] as an edge */
static mus_status board_write_edge(board_writer *w, int32_t k)
{
    mus__board *board = w->board;
    const int32_t index = w->ring[k];
    const mus__board_side *side = &board->side[index];
    int32_t start = w->point[index], end = w->point[side->next];
    mus__board_chain turned = {0};
    const mus__board_chain *chain = &side->chain;
    if (side->backward) {
        mus__board_chain_make(board, chain->npiece, chain->kinds, chain->nxy, chain->xy, &turned);
        if (turned.xy == NULL) return board->status;
        mus__board_chain_reverse(&turned);
        chain = &turned;
        const int32_t swap = start;
        start = end;
        end = swap;
    }
    w->turn[index] = side->backward ? -1 : 1;
    mus_status status = mus_pattern_add_edge(w->pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                         .name = side->name, .start = start,
                                                                         .end = end, .npiece = chain->npiece,
                                                                         .kinds = chain->kinds,
                                                                         .nxy = chain->nxy - 2,
                                                                         .xy = chain->nxy > 2 ? chain->xy + 2 : NULL},
                                             &w->edge[index]);
    mus__free(board->context, turned.xy);
    if (status == MUS_OK) status = mus_pattern_set_edge_label(w->pattern, w->edge[index], side->attr.label);
    if (status == MUS_OK) status = mus_pattern_set_edge_allowance(w->pattern, w->edge[index], side->attr.allowance);
    const mus__edge_attributes *stay = &side->attr;
    if (status == MUS_OK && stay->hold != MUS_HOLD_NONE)
        status = mus_pattern_set_edge_hold(w->pattern, w->edge[index], stay->hold, stay->below);
    if (status == MUS_OK && stay->stiffness != 0.0)
        status = mus_pattern_set_edge_elastic(w->pattern, w->edge[index], stay->ratio, stay->stiffness);
    return status;
}


static mus_status board_write_panel(board_writer *w, int32_t index)
{
    mus__board *board = w->board;
    const mus__board_panel *from = &board->panel[index];
    int32_t n = 0, panel;
    for (int32_t side = from->first; n == 0 || side != from->first; side = board->side[side].next) {
        if (side == MUS_NONE) return mus__fail(board->context, MUS_ERR_PATTERN, "panel %s is not closed", from->name);
        w->ring[n++] = side;
    }

    mus_status status = mus_pattern_add_panel(w->pattern, from->name, &panel);
    w->panel[index] = panel;
    for (int32_t k = 0; k < n && status == MUS_OK; k++) status = board_write_point(w, panel, k);
    for (int32_t k = 0; k < n && status == MUS_OK; k++) {
        int32_t twin;
        const int32_t side = w->ring[k], bridge = board_write_bridge(w, k, &twin);
        if (bridge == MUS_NONE) {
            status = board_write_edge(w, k);
        } else {
            w->edge[side] = w->edge[twin];
            w->turn[side] = board->seam[bridge].direction == MUS_SEAM_DIRECT ? w->turn[twin] : -w->turn[twin];
        }
        w->word[k] = w->edge[side];
        w->word[n + k] = w->turn[side];
    }
    if (status == MUS_OK) status = mus_pattern_set_outline(w->pattern, panel, n, w->word, w->word + n);
    if (status == MUS_OK) status = mus_pattern_set_panel_label(w->pattern, panel, from->attr.label);
    if (status == MUS_OK) status = mus_pattern_set_grain(w->pattern, panel, from->attr.grain[0], from->attr.grain[1]);
    if (status == MUS_OK) status = mus_pattern_set_placement(w->pattern, panel, &from->attr.placement);
    if (status == MUS_OK) status = mus_pattern_set_layer(w->pattern, panel, from->attr.layer);
    if (status == MUS_OK && from->attr.sides != MUS_NONE)
        status = mus_pattern_set_panel_sides(w->pattern, panel, from->attr.sides);
    return status;
}


static mus_status board_write_seam(board_writer *w, const mus__board_seam *from)
{
    /* a bridge that is written as one edge is no seam */
    const int32_t edge_a = w->edge[from->a], edge_b = w->edge[from->b];
    if (from->bridge && edge_a == edge_b) return MUS_OK;
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = edge_a;
    seam.edge_b = edge_b;
    seam.ease = from->ease;
    seam.tolerance = from->tolerance;
    seam.laid = from->laid, seam.closure = from->closure, seam.open = from->open, seam.buttons = from->buttons;
    seam.direction = from->direction;
    if (w->turn[from->a] != w->turn[from->b])
        seam.direction = from->direction == MUS_SEAM_DIRECT ? MUS_SEAM_REVERSED : MUS_SEAM_DIRECT;
    return mus_pattern_add_seam(w->pattern, &seam, NULL);
}


/* cut, seams, notches, marks and openings */
static mus_status board_write_rest(board_writer *w)
{
    const mus__board *board = w->board;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < board->npanel && status == MUS_OK; i++) {
        const mus__board_panel *from = &board->panel[i];
        const int32_t of = from->mirror_of != MUS_NONE ? w->panel[from->mirror_of] : MUS_NONE;
        if (w->panel[i] == MUS_NONE) continue;
        status = mus_pattern_set_cut(w->pattern, w->panel[i], from->attr.cut[MUS_MATERIAL_MAIN], of);
        for (int32_t k = 1; k < MUS_MATERIAL_COUNT && status == MUS_OK; k++)
            status = mus_pattern_set_material(w->pattern, w->panel[i], k, from->attr.cut[k]);
    }
    for (int32_t i = 0; i < board->nseam && status == MUS_OK; i++)
        if (board->seam[i].a != MUS_NONE) status = board_write_seam(w, &board->seam[i]);
    for (int32_t i = 0; i < board->nnotch && status == MUS_OK; i++) {
        const mus__board_notch *from = &board->notch[i];
        if (from->side == MUS_NONE) continue;
        const int32_t edge = w->edge[from->side];
        const double length = mus_pattern_edge_length(w->pattern, edge);
        const double s = w->turn[from->side] < 0 ? length - from->s : from->s;
        status = mus_pattern_add_notch(w->pattern, edge, fmin(fmax(s, 0.0), length), from->kind, NULL);
    }
    for (int32_t i = 0; i < board->nmark && status == MUS_OK; i++) {
        const mus__board_mark *from = &board->mark[i];
        if (from->panel == MUS_NONE) continue;
        status = mus_pattern_add_mark(w->pattern, w->panel[from->panel], from->name, from->n, from->xy, NULL);
    }
    for (int32_t i = 0; i < board->nopening && status == MUS_OK; i++)
        status = mus_pattern_add_opening(w->pattern, board->opening[i].label);
    return status;
}


void mus__board_write(mus__board *board, mus_pattern **out)
{
    *out = NULL;
    if (board->status != MUS_OK) return;
    board_writer w = {.board = board};
    const int64_t npanel = board->npanel, nside = board->nside;
    int32_t *block = mus__new(board->context, npanel + 6 * nside, sizeof *block);
    if (block == NULL) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for a pattern from the table");
        return;
    }
    w.panel = block;
    w.point = w.panel + npanel;
    w.edge = w.point + nside;
    w.turn = w.edge + nside;
    w.ring = w.turn + nside;
    w.word = w.ring + nside;
    for (int64_t i = 0; i < npanel; i++) w.panel[i] = MUS_NONE;
    for (int64_t i = 0; i < nside; i++) w.edge[i] = MUS_NONE;

    mus_status status = mus_pattern_create(board->context, board->name, &w.pattern);
    for (int32_t i = 0; i < board->npanel && status == MUS_OK; i++)
        if (board->panel[i].name[0] != '\0') status = board_write_panel(&w, i);
    if (status == MUS_OK) status = board_write_rest(&w);
    mus__free(board->context, block);
    board->status = status;
    if (status == MUS_OK)
        *out = w.pattern;
    else
        mus_pattern_destroy(w.pattern);
}
