/*
 * drawing.c: a drawing is a list of paths, each with a pen and a group; and the helpers for memory and messages that
 * the folder shares.
 *
 * A drawing remembers its first failure and ignores all calls after it. Code that draws needs no checks, and its caller
 * reads `status` once at the end. Letters are paths too (stroke_font.c), so a writer handles only lines and curves.
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drawing/drawing.h"

/* pens: {width [m], {dash, gap [m]}, grey}. Chosen: no pen but the title's is as wide as that of the cut line */
const mus__pen_style mus__pen_styles[MUS__PEN_COUNT] = {
    [MUS__PEN_CUT] = {0.0005, {0, 0}, 0},           [MUS__PEN_SEAM] = {0.00025, {0.003, 0.0015}, 0},
    [MUS__PEN_NOTCH] = {0.0004, {0, 0}, 0},         [MUS__PEN_GRAIN] = {0.0003, {0, 0}, 0},
    [MUS__PEN_MARK] = {0.00025, {0.010, 0.002}, 0}, [MUS__PEN_TEXT] = {0.0003, {0, 0}, 0},
    [MUS__PEN_TITLE] = {0.0005, {0, 0}, 0},         [MUS__PEN_SQUARE] = {0.00025, {0, 0}, 0},
    [MUS__PEN_DRILL] = {0.0003, {0, 0}, 0},
    [MUS__PEN_FRAME] = {0.00015, {0, 0}, 0.5},      [MUS__PEN_JOIN] = {0.00015, {0.001, 0.001}, 0.5},
    [MUS__PEN_FAINT] = {0.0002, {0, 0}, 0.45},      [MUS__PEN_INK] = {0, {0, 0}, 0},
    [MUS__PEN_GREY] = {0, {0, 0}, 0.82},            [MUS__PEN_SMALL] = {0.0002, {0, 0}, 0},
    [MUS__PEN_LETTER] = {0, {0, 0}, 0},             [MUS__PEN_LETTER_FAINT] = {0, {0, 0}, 0.45},
};


int32_t mus__print_millimetres(char *out, size_t size, double x)
{
    long tenths = lround(x * 1e4);
    return tenths % 10 == 0 ? snprintf(out, size, "%ld", tenths / 10)
                            : snprintf(out, size, "%ld.%ld", tenths / 10, tenths % 10);
}


void mus__print_number(mus__sink *bytes, double x)
{
    int64_t units = llround(x * 1e7), whole = units < 0 ? -(units / 10000) : units / 10000;
    int fraction = (int)(units < 0 ? -(units % 10000) : units % 10000), digits = 4;
    mus__sink_print(bytes, "%s%" PRId64, units < 0 ? "-" : "", whole);
    if (fraction == 0) return;
    for (; fraction % 10 == 0; fraction /= 10) digits--;
    mus__sink_print(bytes, ".%0*d", digits, fraction);
}


mus_status mus__print_memory(mus_context *context, const char *what)
{
    return mus__file_fail(context, MUS_ERR_MEMORY, "no memory for %s", what);
}


void *mus__print_new(mus_context *context, int64_t count, size_t size)
{
    if (count < 0 || size == 0 || (uint64_t)count > SIZE_MAX / 4 / size) return NULL;
    size_t bytes = (size_t)count * size;
    return mus_context_alloc(context, NULL, bytes > 0 ? bytes : 1);
}


void mus__print_free(mus_context *context, void *block)
{
    if (block != NULL) mus_context_alloc(context, block, 0);
}


mus_status mus__print_reserve(mus_context *context, void *array, int32_t *capacity, int64_t need, size_t size)
{
    if (need <= *capacity) return MUS_OK;
    if (need > INT32_MAX / 2) return mus__file_fail(context, MUS_ERR_LIMIT, "a drawing of more than 2^30 parts");

    int64_t grown = (int64_t)*capacity + *capacity / 2 + 64;
    if (grown < need) grown = need;
    void *old;
    memcpy(&old, array, sizeof old);
    void *bigger = mus_context_alloc(context, old, (size_t)grown * size);
    if (bigger == NULL) return mus__print_memory(context, "a drawing");
    memcpy(array, &bigger, sizeof bigger);
    *capacity = (int32_t)grown;
    return MUS_OK;
}


void mus__draw_init(mus__drawing *drawing, mus_context *context)
{
    memset(drawing, 0, sizeof *drawing);
    drawing->context = context;
}


void mus__draw_free(mus__drawing *drawing)
{
    mus__print_free(drawing->context, drawing->paths);
    mus__print_free(drawing->context, drawing->ops);
    mus__print_free(drawing->context, drawing->xy);
    mus__print_free(drawing->context, drawing->texts);
    mus__print_free(drawing->context, drawing->letters);
    mus__draw_init(drawing, drawing->context);
}


void mus__draw_path(mus__drawing *drawing, int32_t piece, mus__layer layer, mus__pen pen)
{
    if (drawing->status != MUS_OK) return;
    drawing->status = mus__print_reserve(drawing->context, &drawing->paths, &drawing->path_room,
                                         (int64_t)drawing->npath + 1, sizeof *drawing->paths);
    if (drawing->status != MUS_OK) return;
    drawing->paths[drawing->npath++] =
        (mus__path){piece, layer, pen, MUS_NONE, MUS_NONE, drawing->nop, 0, drawing->nxy, MUS_NONE, {0, 0, 0, 0}};
}


void mus__draw_edge(mus__drawing *drawing, int32_t edge)
{
    if (drawing->status == MUS_OK) drawing->paths[drawing->npath - 1].edge = edge;
}


void mus__draw_mark(mus__drawing *drawing, int32_t mark)
{
    if (drawing->status == MUS_OK) drawing->paths[drawing->npath - 1].mark = mark;
}


/* add one step with its points to the path that was begun last */
static void draw_step(mus__drawing *drawing, unsigned char op, int32_t npoint, const double *xy)
{
    if (drawing->status != MUS_OK) return;
    mus_status status = mus__print_reserve(drawing->context, &drawing->ops, &drawing->op_room,
                                           (int64_t)drawing->nop + 1, sizeof *drawing->ops);
    if (status == MUS_OK)
        status = mus__print_reserve(drawing->context, &drawing->xy, &drawing->xy_room,
                                    (int64_t)drawing->nxy + 2 * npoint, sizeof *drawing->xy);
    drawing->status = status;
    if (status != MUS_OK) return;

    mus__path *path = &drawing->paths[drawing->npath - 1];
    drawing->ops[drawing->nop++] = op;
    path->nop++;
    for (int32_t i = 0; i < npoint; i++) {
        for (int32_t k = 0; k < 2; k++) {
            double x = xy[2 * i + k];
            bool first = drawing->nxy == path->at + k;
            if (first || x < path->box[k]) path->box[k] = x;
            if (first || x > path->box[2 + k]) path->box[2 + k] = x;
            drawing->xy[drawing->nxy++] = x;
        }
    }
}


void mus__draw_move(mus__drawing *drawing, double x, double y)
{
    draw_step(drawing, 'm', 1, (const double[]){x, y});
}


void mus__draw_line(mus__drawing *drawing, double x, double y)
{
    draw_step(drawing, 'l', 1, (const double[]){x, y});
}


void mus__draw_curve(mus__drawing *drawing, const double *xy)
{
    draw_step(drawing, 'c', 3, xy);
}


void mus__draw_close(mus__drawing *drawing)
{
    draw_step(drawing, 'z', 0, NULL);
}


void mus__draw_rectangle(mus__drawing *drawing, double x, double y, double width, double height)
{
    mus__draw_move(drawing, x, y);
    mus__draw_line(drawing, x + width, y);
    mus__draw_line(drawing, x + width, y + height);
    mus__draw_line(drawing, x, y + height);
    mus__draw_close(drawing);
}
