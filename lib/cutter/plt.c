/*
 * plt.c: the sheet as HPGL or HPGL/2 for plotters and cutters.
 *
 * A plotter unit is 0.025 mm. The paper runs along x: x of the plot is y of the sheet, and y of the plot runs from the
 * right edge of the sheet to its left one, so that nothing is mirrored. Curves are chords within 0.01 mm.
 *
 * Order by pen (plotters change pens rarely): pen after pen over all pieces. Order by piece (cutters): of each piece
 * the notches and lines inside first, the cut line last, since a piece that is cut out moves.
 * Source: Hewlett-Packard, HP-GL/2 and HP RTL Reference Guide.
 */
#include <math.h>
#include <string.h>

#include "print/page.h"

#define PLT_UNIT 2.5e-5       /* [m] a plotter unit */
#define PLT_TOLERANCE 1e-5    /* [m] of chords; chosen: below half a plotter unit */

/* pen of each group of lines: cut, sew, notches, grain, marks, label */
static const int plt_pens[MUS__LAYER_COUNT] = {1, 2, 1, 3, 3, 4};

typedef struct plt_plot {
    mus__sink *bytes;
    const mus_sheet *sheet;
    const mus_sheet_plt *def;
    int pen;     /* that is in the holder, 0 for none */
    bool dashed;
} plt_plot;


void mus_sheet_plt_init(mus_sheet_plt *def, size_t size)
{
    if (def == NULL || size < sizeof def->size) return;
    memset(def, 0, size);
    if (size < sizeof *def) return;
    def->size = size;
    def->hpgl2 = 1;
}


static void plt_to(const plt_plot *plot, const char *command, const double *p)
{
    const long x = lround(p[1] / PLT_UNIT), y = lround((plot->sheet->extent[0] - p[0]) / PLT_UNIT);
    mus__sink_print(plot->bytes, "%s%ld,%ld;", command, x, y);
}


/* put the pen of a layer into the holder */
static void plt_pen(plt_plot *plot, mus__layer layer)
{
    const int pen = plot->def->one_pen ? 1 : plt_pens[layer];
    const bool dashed = layer == MUS__LAYER_SEAM;
    if (pen != plot->pen) mus__sink_print(plot->bytes, "\nSP%d;", pen);
    if (dashed != plot->dashed) mus__sink_print(plot->bytes, dashed ? "LT2;" : "LT;");
    plot->pen = pen;
    plot->dashed = dashed;
}


static void plt_path(const plt_plot *plot, const mus__path *path)
{
    const mus__drawing *drawing = &plot->sheet->drawing;
    const double *xy = drawing->xy + path->at, *start = xy;
    for (int32_t i = 0; i < path->nop; i++) {
        const unsigned char op = drawing->ops[path->op + i];
        if (op == 'm') start = xy;
        if (op == 'm' || op == 'l') plt_to(plot, op == 'm' ? "\nPU" : "PD", xy);
        if (op == 'z') plt_to(plot, "PD", start);
        if (op == 'c') {
            const double *p = xy - 2;
            const int32_t n = mus__cubic_chords(p, PLT_TOLERANCE);
            for (int32_t k = 1; k <= n; k++) {
                double at[2];
                mus__cubic_at(p, (double)k / n, at);
                plt_to(plot, "PD", at);
            }
        }
        xy += 2 * (op == 'c' ? 3 : op == 'z' ? 0 : 1);
    }
}


/* draw the paths of a layer, of one piece or of all (MUS_NONE) */
static void plt_layer(plt_plot *plot, mus__layer layer, int32_t piece)
{
    const mus__drawing *drawing = &plot->sheet->drawing;
    for (int32_t i = 0; i < drawing->npath; i++) {
        const mus__path *path = &drawing->paths[i];
        if (path->piece == MUS_NONE || path->nop == 0 || path->layer != layer) continue;
        if (piece != MUS_NONE && path->piece != piece) continue;
        plt_pen(plot, layer);
        plt_path(plot, path);
    }
}


static void plt_document(plt_plot *plot)
{
    static const mus__layer by_pen[] = {MUS__LAYER_LABEL, MUS__LAYER_GRAIN, MUS__LAYER_MARKS, MUS__LAYER_SEAM,
                                        MUS__LAYER_NOTCHES, MUS__LAYER_CUT};
    static const mus__layer by_piece[] = {MUS__LAYER_MARKS, MUS__LAYER_NOTCHES, MUS__LAYER_CUT};
    const mus_sheet *sheet = plot->sheet;
    mus__sink_print(plot->bytes, "IN;");
    if (plot->def->hpgl2)
        mus__sink_print(plot->bytes, "PS%ld,%ld;", lround(ceil(sheet->extent[1] / PLT_UNIT)),
                        lround(ceil(sheet->extent[0] / PLT_UNIT)));
    for (int32_t piece = 0; piece < sheet->npiece && plot->def->by_piece; piece++)
        for (size_t i = 0; i < sizeof by_piece / sizeof by_piece[0]; i++) plt_layer(plot, by_piece[i], piece);
    for (size_t i = 0; i < sizeof by_pen / sizeof by_pen[0] && !plot->def->by_piece; i++)
        plt_layer(plot, by_pen[i], MUS_NONE);
    mus__sink_print(plot->bytes, "\nPU;SP0;%s\n", plot->def->hpgl2 ? "PG;" : "");
}


static mus_status plt_write(const mus_sheet *sheet, const mus_sheet_plt *def, const mus__target *target,
                            const char *what)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(sheet->context, target, what);
    if (status != MUS_OK) return status;
    mus_sheet_plt own;
    mus_sheet_plt_init(&own, sizeof own);
    if (def != NULL && def->size != sizeof own)
        return mus__file_fail(sheet->context, MUS_ERR_VERSION, "mus_sheet_plt: size %zu, this library knows %zu; use "
                              "mus_sheet_plt_init", def->size, sizeof own);
    mus__sink bytes;
    mus__sink_init(&bytes, sheet->context);
    plt_plot plot = {.bytes = &bytes, .sheet = sheet, .def = def != NULL ? def : &own};
    plt_document(&plot);
    status = bytes.status;
    if (status == MUS_OK) status = mus__sink_give(&bytes, target);
    mus__sink_free(&bytes);
    return status;
}


mus_status mus_sheet_write_plt(const mus_sheet *sheet, const mus_sheet_plt *def, const char *path)
{
    return plt_write(sheet, def, &(mus__target){path, NULL, NULL}, "mus_sheet_write_plt");
}


mus_status mus_sheet_write_plt_bytes(const mus_sheet *sheet, const mus_sheet_plt *def, char **bytes, size_t *size)
{
    return plt_write(sheet, def, &(mus__target){NULL, bytes, size}, "mus_sheet_write_plt_bytes");
}
