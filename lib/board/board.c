/*
 * board.c: the cutting table as an object: begin, fail, find, forget.
 *
 * The room, in the order of use:
 *   board.c              the table and its records
 *   board_curve.c        the line of a side: a chain of lines, arcs and Beziers
 *   board_draw.c         drawing panels side by side, marks
 *   board_read_write.c   a pattern onto the table, and a new pattern from it
 *   board_seam.c         seams; sides split and merged
 *   board_notch.c        notches, on one side and on all sides of a seam
 *   board_cut.c          panels cut apart, joined, mirrored
 *   board_mirror.c       half garment to whole garment
 *   board_rigid_part.c   parts of a panel that move as rigid pieces
 *   board_inner_line.c   lines inside a panel, and where a cut to their corner goes
 *   board_dart.c         darts: add, shorten, release to gathers, make part of a seam
 *   board_dart_rotate.c  darts rotated about their point
 *   board_spread.c, board_pleat.c, board_smooth.c, board_patch_panel.c  fullness, pleats, smooth lines, patches
 *
 * Callers: lib/edit (a public edit is one or two calls of this room) and the drafting rooms (a design is drawn here).
 *
 * Records stand in growing arrays, so a pointer to one holds only until the next is added: the code of this room goes
 * by index. A table has some tens of panels and some hundreds of sides, so finding walks the list.
 */
#include <stdio.h>
#include <string.h>

#include "board/board.h"


void mus__board_begin(mus__board *board, mus_context *context, const char *name)
{
    *board = (mus__board){.context = context, .status = MUS_OK};
    if (name == NULL) return;
    if (strlen(name) >= sizeof board->name)
        mus__board_fail(board, MUS_ERR_ARG, "pattern: the name %.40s... is longer than %d bytes", name,
                        MUS__NAME_BYTES - 1);
    else
        strcpy(board->name, name);
}


void mus__board_free(mus__board *board)
{
    mus_context *context = board->context;
    if (context == NULL) return;
    for (int32_t i = 0; i < board->nside; i++) mus__free(context, board->side[i].chain.xy);
    for (int32_t i = 0; i < board->nmark; i++) mus__free(context, board->mark[i].xy);
    mus__free(context, board->panel);
    mus__free(context, board->side);
    mus__free(context, board->seam);
    mus__free(context, board->notch);
    mus__free(context, board->mark);
    mus__free(context, board->opening);
    *board = (mus__board){.context = NULL};
}


void mus__board_fail(mus__board *board, mus_status status, const char *format, ...)
{
    if (board->status != MUS_OK) return;
    char text[MUS_ERROR_BYTES];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    board->status = mus__fail(board->context, status, "%s", text);
}


bool mus__board_has_side(mus__board *board, int32_t side)
{
    if (board->status != MUS_OK) return false;
    if (side >= 0 && side < board->nside && board->side[side].panel != MUS_NONE) return true;
    mus__board_fail(board, MUS_ERR_ARG, "side %d is not on the board, which has had %d", (int)side, (int)board->nside);
    return false;
}


bool mus__board_has_panel(mus__board *board, int32_t panel)
{
    if (board->status != MUS_OK) return false;
    if (panel >= 0 && panel < board->npanel && board->panel[panel].name[0] != '\0') return true;
    mus__board_fail(board, MUS_ERR_ARG, "panel %d is not on the board, which has had %d", (int)panel,
                    (int)board->npanel);
    return false;
}


/* ---- finding ---- */

int32_t mus__board_find_panel(const mus__board *board, const char *name)
{
    for (int32_t i = 0; i < board->npanel; i++)
        if (strcmp(board->panel[i].name, name) == 0 && name[0] != '\0') return i;
    return MUS_NONE;
}


int32_t mus__board_find(const mus__board *board, int32_t panel, const char *name)
{
    for (int32_t i = 0; i < board->nside && panel != MUS_NONE; i++)
        if (board->side[i].panel == panel && strcmp(board->side[i].name, name) == 0) return i;
    return MUS_NONE;
}


const double *mus__board_start(const mus__board *board, int32_t side)
{
    static const double nowhere[2] = {0.0, 0.0};
    return side >= 0 && side < board->nside && board->side[side].chain.xy != NULL ? board->side[side].chain.xy
                                                                                  : nowhere;
}


const double *mus__board_end(const mus__board *board, int32_t side)
{
    const double *start = mus__board_start(board, side);
    return side >= 0 && side < board->nside && board->side[side].chain.xy != NULL
               ? start + 2 * ((size_t)board->side[side].chain.nxy - 1)
               : start;
}


int32_t mus__board_seam_of(const mus__board *board, int32_t side)
{
    for (int32_t i = 0; i < board->nseam && side != MUS_NONE; i++)
        if (board->seam[i].a == side || board->seam[i].b == side) return i;
    return MUS_NONE;
}


int32_t mus__board_partner(const mus__board *board, int32_t side)
{
    const int32_t seam = mus__board_seam_of(board, side);
    if (seam == MUS_NONE) return MUS_NONE;
    return board->seam[seam].a == side ? board->seam[seam].b : board->seam[seam].a;
}


/* ---- forgetting ---- */

void mus__board_free_name(const mus__board *board, int32_t panel, const char *name, char *out)
{
    /* "side_2" and "side" lead to "side_3" */
    size_t stem = strlen(name), digits = stem;
    while (digits > 0 && name[digits - 1] >= '0' && name[digits - 1] <= '9') digits--;
    if (digits < stem && digits > 1 && name[digits - 1] == '_') stem = digits - 1;
    memset(out, 0, MUS__NAME_BYTES);
    if (stem == 0) return;
    if (stem > MUS__NAME_BYTES - 12) stem = MUS__NAME_BYTES - 12;
    while (stem > 0 && ((unsigned char)name[stem] & 0xC0) == 0x80) stem--;
    for (int32_t n = 2; n <= board->nside + 2; n++) {
        snprintf(out, MUS__NAME_BYTES, "%.*s_%d", (int)stem, name, (int)n);
        if (mus__board_find(board, panel, out) == MUS_NONE) return;
    }
}


void mus__board_side_remove(mus__board *board, int32_t side)
{
    for (int32_t i = 0; i < board->nseam; i++)
        if (board->seam[i].a == side || board->seam[i].b == side) board->seam[i].a = board->seam[i].b = MUS_NONE;
    for (int32_t i = 0; i < board->nnotch; i++)
        if (board->notch[i].side == side) board->notch[i].side = MUS_NONE;
    mus__board_side *own = &board->side[side];
    mus__free(board->context, own->chain.xy);
    own->chain = (mus__board_chain){0};
    own->panel = own->prev = own->next = MUS_NONE;
}


void mus__board_add_cut(mus__board *board, int32_t panel, const int32_t *cut, int32_t sign)
{
    int32_t *own = board->panel[panel].attr.cut, all = 0;
    for (int32_t i = 0; i < MUS_MATERIAL_COUNT; i++) {
        own[i] = own[i] + sign * cut[i] > 0 ? own[i] + sign * cut[i] : 0;
        all += own[i];
    }
    if (all == 0 && sign < 0) own[MUS_MATERIAL_MAIN] = 1;
}


void mus__board_part_twins(mus__board *board, int32_t panel)
{
    for (int32_t i = 0; i < board->npanel; i++) {
        const int32_t of = board->panel[i].mirror_of;
        if (of == MUS_NONE || (i != panel && of != panel)) continue;
        board->panel[i].mirror_of = MUS_NONE;
        mus__board_add_cut(board, of, board->panel[i].attr.cut, -1);
    }
}
