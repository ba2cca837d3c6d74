/*
 * dxf_piece.c: the block of a piece in a DXF file: boundary, turn and curve points, notches, grain, lines inside, drill
 * points, sew line, texts.
 *
 * The boundary is the outer cut line, or the sew line where no side has an allowance. Its vertices are turn points
 * where it bends by more than 30 degrees or an edge ends, and curve points elsewhere. Millimetres, y up, the places of
 * the sheet; a block of another size lies where the sample's piece lies, so that sizes nest.
 */
#include <math.h>
#include <stdio.h>

#include "base/elementary.h"
#include "cutter/dxf.h"

#define TURN_COSINE 0.86602540378443865 /* of 30 degrees (AAMA: a turn point is a corner) */
/* [m] curve points are left out where the boundary stays this close to the chord; chosen: below a plotter's line */
#define CURVE_CHORD 5e-5

typedef struct dxf_block {
    const mus__dxf *dxf;
    mus__sink *bytes;
    const mus_sheet *sheet;
    const mus__piece *piece;
    int32_t index;
    double move[2]; /* [m] from the sheet of this size to that of the sample */
    bool astm;
    bool sewn;      /* the boundary is the sew line */
} dxf_block;


/* ---- entities ---- */

static void dxf_place(const dxf_block *b, int32_t code, const double *p)
{
    for (int32_t k = 0; k < 2; k++) {
        mus__sink_print(b->bytes, "%d\n", (int)(code + 10 * k));
        mus__print_number(b->bytes, p[k] + b->move[k]);
        mus__sink_add(b->bytes, "\n", 1);
    }
}


static void dxf_point(const dxf_block *b, int32_t layer, const double *p)
{
    mus__sink_print(b->bytes, "0\nPOINT\n8\n%d\n", (int)layer);
    dxf_place(b, 10, p);
}


static void dxf_line(const dxf_block *b, int32_t layer, const double *p, const double *q)
{
    mus__sink_print(b->bytes, "0\nLINE\n8\n%d\n", (int)layer);
    dxf_place(b, 10, p);
    dxf_place(b, 11, q);
}


static void dxf_write_text(const dxf_block *b, int32_t layer, const double *p, const char *text)
{
    const double at[2] = {p[0] + b->move[0], p[1] + b->move[1]};
    mus__dxf_label(b->bytes, layer, at, NULL, text);
}


/* n points of the ring xy (of `ring` points) from point `first` on */
static void dxf_polyline(const dxf_block *b, int32_t layer, bool closed, const double *xy, int32_t ring, int32_t first,
                         int32_t n)
{
    mus__sink_print(b->bytes, "0\nPOLYLINE\n8\n%d\n66\n1\n70\n%d\n", (int)layer, closed);
    for (int32_t i = 0; i < n; i++) {
        mus__sink_print(b->bytes, "0\nVERTEX\n8\n%d\n", (int)layer);
        dxf_place(b, 10, xy + 2 * ((first + i) % ring));
    }
    mus__sink_print(b->bytes, "0\nSEQEND\n8\n%d\n", (int)layer);
}


/* ---- boundary ---- */

/* true when the ring bends by more than 30 degrees at point i */
static bool dxf_turns(const double *xy, int32_t n, int32_t i)
{
    const double *a = xy + 2 * ((i + n - 1) % n), *p = xy + 2 * i, *c = xy + 2 * ((i + 1) % n);
    double ux = p[0] - a[0], uy = p[1] - a[1], vx = c[0] - p[0], vy = c[1] - p[1];
    return ux * vx + uy * vy < TURN_COSINE * sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
}


/* distance [m] of p from the line through a and c */
static double dxf_off(const double *a, const double *c, const double *p)
{
    double dx = c[0] - a[0], dy = c[1] - a[1], d = mus__hypot(dx, dy);
    return d > 0.0 ? fabs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / d : mus__hypot(p[0] - a[0], p[1] - a[1]);
}


/* turn points, and those curve points that keep the curve within CURVE_CHORD; sides is NULL for a cut line */
static void dxf_points(const dxf_block *b, const double *xy, const int32_t *sides, int32_t n)
{
    int32_t last = 0;
    for (int32_t i = 0; i < n; i++) {
        bool turn = dxf_turns(xy, n, i) || (sides != NULL && sides[i] != sides[(i + n - 1) % n]);
        bool far = false;
        for (int32_t k = last + 1; k <= i && !far; k++)
            far = dxf_off(xy + 2 * last, xy + 2 * ((i + 1) % n), xy + 2 * k) > CURVE_CHORD;
        if (!turn && !far) continue;
        dxf_point(b, turn ? 2 : 3, xy + 2 * i);
        last = i;
    }
}


static void dxf_boundary(const dxf_block *b)
{
    const mus__piece *piece = b->piece;
    const mus__loops *cut = &piece->cut;
    const double *xy = b->sewn ? piece->flat : cut->xy;
    const int32_t n = b->sewn ? piece->nflat : cut->start[1];
    dxf_polyline(b, 1, true, xy, n, 0, n);
    if (b->astm) dxf_polyline(b, 84, true, xy, n, 0, n);
    dxf_points(b, xy, b->sewn ? piece->flat_side : NULL, n);
    for (int32_t i = 1; i < cut->nloop && !b->sewn; i++) {
        const int32_t start = cut->start[i], count = cut->start[i + 1] - start;
        dxf_polyline(b, 11, true, cut->xy + 2 * start, count, 0, count);
        if (b->astm) dxf_polyline(b, 86, true, cut->xy + 2 * start, count, 0, count);
    }
}


/* the sew line: a polyline for each edge, from end to end; and the numbers of grade rules */
static void dxf_sew(const dxf_block *b)
{
    const mus__piece *piece = b->piece;
    int32_t point = 0, n = piece->nflat;
    for (int32_t p = 0; p < b->index; p++) point += b->sheet->pieces[p].nside;
    for (int32_t i = 0, end; i < n; i = end) {
        const int32_t side = piece->flat_side[i];
        for (end = i + 1; end < n && piece->flat_side[end] == side;) end++;
        if (!b->sewn) {
            dxf_polyline(b, 14, false, piece->flat, n, i, end - i + 1);
            if (b->astm) dxf_polyline(b, 87, false, piece->flat, n, i, end - i + 1);
        }
        if (b->dxf->rule_of == NULL || b->sheet != b->dxf->sheet) continue;
        char rule[16];
        snprintf(rule, sizeof rule, "# %d", (int)b->dxf->rule_of[point + side] + 1);
        dxf_write_text(b, b->astm ? 1 : 2, piece->flat + 2 * i, rule);
    }
}


/* ---- lines on the piece, from the drawing of the sheet ---- */

/* a slit runs from the boundary inwards: AAMA a line, ASTM a point with depth (30), width (39) and angle (50) */
static void dxf_slit(const dxf_block *b, const double *p, const double *q)
{
    if (!b->astm) {
        dxf_line(b, 4, p, q);
        return;
    }
    dxf_point(b, 4, p);
    double angle = mus__atan2(q[1] - p[1], q[0] - p[0]) * 180.0 / MUS__PRINT_PI;
    mus__sink_print(b->bytes, "30\n");
    mus__print_number(b->bytes, mus__hypot(q[0] - p[0], q[1] - p[1]));
    mus__sink_print(b->bytes, "\n39\n0\n50\n");
    mus__print_number(b->bytes, (angle < 0.0 ? angle + 360.0 : angle) * 1e-3);
    mus__sink_add(b->bytes, "\n", 1);
}


static void dxf_mark(const dxf_block *b, const mus__path *path, const double *xy)
{
    const char *name = b->sheet->marks[path->mark];
    if (path->pen == MUS__PEN_SQUARE) {
        /* the cross of a drill point */
        const double p[2] = {0.5 * (path->box[0] + path->box[2]), 0.5 * (path->box[1] + path->box[3])};
        dxf_point(b, 13, p);
        if (name[0] != '\0') dxf_write_text(b, 13, p, name);
        return;
    }
    dxf_polyline(b, 8, false, xy, path->nop, 0, path->nop);
    if (b->astm) dxf_polyline(b, 85, false, xy, path->nop, 0, path->nop);
    if (name[0] != '\0') dxf_write_text(b, 8, xy, name);
}


static void dxf_lines(const dxf_block *b)
{
    const mus__drawing *drawing = &b->sheet->drawing;
    for (int32_t i = 0; i < drawing->npath; i++) {
        const mus__path *path = &drawing->paths[i];
        const double *xy = drawing->xy + path->at;
        if (path->piece != b->index) continue;
        if (path->layer == MUS__LAYER_NOTCHES)
            for (int32_t k = 0; k + 1 < path->nop; k += 2) dxf_slit(b, xy + 2 * k, xy + 2 * k + 2);
        if (path->layer == MUS__LAYER_GRAIN && path->pen == MUS__PEN_GRAIN) dxf_line(b, 7, xy, xy + 2);
        if (path->layer == MUS__LAYER_MARKS && path->mark != MUS_NONE) dxf_mark(b, path, xy);
    }
}


static void dxf_texts(const dxf_block *b, int32_t size)
{
    const mus__piece *piece = b->piece;
    double at[2];
    char count[32];
    for (int32_t k = 0; k < 2; k++) at[k] = 0.5 * (piece->box[k] + piece->box[2 + k]) + b->move[k];
    mus__dxf_label(b->bytes, 1, at, "Piece Name", b->dxf->names[b->index]);
    mus__dxf_label(b->bytes, 1, at, "Size", mus__dxf_size_name(b->dxf, size));
    if (size > 0) return;
    /* right and left: copies as drawn, copies turned over */
    const int32_t copies = mus__piece_copies(piece), left = piece->mirrored ? copies / 2 : 0;
    snprintf(count, sizeof count, "%d,%d", (int)(copies - left), (int)left);
    mus__dxf_label(b->bytes, 1, at, "Quantity", count);
    for (int32_t i = 1; i < MUS_MATERIAL_COUNT; i++)
        if (piece->copies[i] > 0) {
            snprintf(count, sizeof count, "%s %d", mus_material_name(i), (int)piece->copies[i]);
            mus__dxf_label(b->bytes, 1, at, "Material", count);
        }
    if (b->sheet->labels[b->index][0] != '\0')
        mus__dxf_label(b->bytes, 1, at, "Category", b->sheet->labels[b->index]);
    mus__dxf_label(b->bytes, 15, at, NULL, b->sheet->names[b->index]);
}


void mus__dxf_piece(const mus__dxf *dxf, int32_t piece, int32_t size)
{
    const mus_sheet *sheet = mus__dxf_sheet(dxf, size);
    const mus__piece *own = &sheet->pieces[piece], *sample = &dxf->sheet->pieces[piece];
    double widest = 0.0;
    for (int32_t i = 0; i < own->nside; i++) widest = own->sides[i].width > widest ? own->sides[i].width : widest;
    const double move[2] = {sample->shift[0] - own->shift[0], sample->shift[1] - own->shift[1]};
    const bool bare = widest == 0.0 && own->ndart == 0;
    dxf_block b = {dxf, dxf->bytes, sheet, own, piece, {move[0], move[1]},
                   dxf->def.dialect == MUS_DXF_ASTM, dxf->def.boundary == MUS_DXF_SEW || bare};
    dxf_texts(&b, size);
    dxf_boundary(&b);
    dxf_lines(&b);
    dxf_sew(&b);
}
