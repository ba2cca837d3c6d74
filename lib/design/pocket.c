/*
 * pocket.c: where a patch pocket goes.
 *
 * A patch is a third sheet on the garment: three of its sides would each be an edge where three sheets meet, and the
 * cloth round it would have to be cut along them. A pattern whose seams join two sheets each cannot say that, and a
 * pocket changes no opening and no handle (drafting.md section 8). So the pocket is the line on the piece along which
 * it is laid: 13 x 15 cm, below the hip line behind, on the thigh of a skirt's front.
 */
#include <math.h>

#include "design/lower.h"


/* centre (x, y) of the pocket's top, half its width, its height; a back is drawn at x < 0 */
static void pocket_mark(mus__half *half, const char *name, double x, double y)
{
    const int32_t panel = mus__board_find_panel(&half->board, name);
    if (half->board.status != MUS_OK || panel == MUS_NONE) return;
    const double scale = mus__lower_scale(half), w = 6.5 * MUS__CM * scale, h = 15.0 * MUS__CM * scale;
    const double xy[10] = {x - w, y, x - w, y - h, x + w, y - h, x + w, y, x - w, y};
    mus__board_mark_add(&half->board, panel, "pocket", 5, xy);
}


void mus__pocket_attach(mus__half *half)
{
    if (half->style.option[MUS__AXIS_POCKET] != MUS__POCKET_PATCH) return;
    const double *m = half->measures.v, scale = mus__lower_scale(half), hip = m[MUS_MEASURE_HIP];
    const double low = -0.55 * m[MUS_MEASURE_WAIST_TO_HIP];
    switch (half->style.option[MUS__AXIS_GARMENT]) {
    case MUS__GARMENT_TROUSERS:
    case MUS__GARMENT_JUMPSUIT: pocket_mark(half, "leg_back", -0.13 * hip, low); break;
    case MUS__GARMENT_SKIRT:
    case MUS__GARMENT_DRESS: pocket_mark(half, "skirt_front", 0.13 * hip, low); break;
    case MUS__GARMENT_TOP: pocket_mark(half, "front", 0.11 * m[MUS_MEASURE_BUST], 0.26 * scale); break;
    default: break;
    }
}
