/*
 * shaping.c: where the shaping of a bodice goes: the ten shapes, by moving darts and cutting panels apart.
 *
 * Every shape begins as the block: a front whose bust dart opens at the side, its point on the bust point. The dart is
 * turned about that point to where the word says (waist, shoulder, neck, centre, a line low on the side), let out as
 * gathers or flare, or run on into a seam that cuts the panel (shaping_cut.c, shaping_gather.c). Waist darts that a
 * shape keeps are drawn with the panel. What a shape asks for and a body has not (a bust dart of a flat chest) is left
 * out. At the end points stop short of the bust point, where the cloth rounds itself. Founding paper, section 5
 * (designs by separating and rotating patterns); drafting reference 4.1 to 4.4, 5.2.
 */
#include <math.h>
#include <string.h>

#include "design/top.h"
#include "geom/curve.h"
#include "geom/vec.h"

#define SHAPING_BACK (2.0 * MUS__CM) /* sewn darts end so far from the bust point */

#define SHAPING_BRIDGE 1e-3            /* between the points of two darts that are merged */


static bool shaping_darted(const mus__half *half)
{
    return half->bodice.front.theta > 0.0;
}


void mus__shaping_plan(const mus__half *half, mus__top *top)
{
    /* a waist dart that is merged with the bust dart, or becomes part of a seam, is not drawn */
    const int32_t shape = half->style.option[MUS__AXIS_SHAPE];
    const bool princess = shape == MUS__SHAPE_PRINCESS_SHOULDER || shape == MUS__SHAPE_PRINCESS_ARMHOLE;
    const bool merged = shape == MUS__SHAPE_WAIST && shaping_darted(half);
    const bool cut = shape == MUS__SHAPE_EMPIRE && half->bodice.dart_width > 0.0;
    top->waist_darts[MUS__TOP_FRONT] = top->darts && !princess && !merged && !cut;
    top->waist_darts[MUS__TOP_BACK] = top->darts && !princess;
    top->point_back = shape == MUS__SHAPE_SIDE_WAIST || shape == MUS__SHAPE_EMPIRE ? SHAPING_BACK : 0.0;
    if (shape != MUS__SHAPE_FRENCH || !shaping_darted(half)) return;
    if (top->hem < 0.0)
        top->waist_darts[MUS__TOP_FRONT] = false;
    else
        top->waist_point = SHAPING_BRIDGE;
}


int32_t mus__shaping_side(const mus__half *half, const mus__top *top, int32_t which, const char *name)
{
    const bool alone = mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP);
    return mus__board_find(&half->board, top->panel[which], strcmp(name, "low") == 0 ? alone ? "hem" : "waist" : name);
}


void mus__shaping_work(mus__half *half, mus__top *top)
{
    const int32_t shape = half->style.option[MUS__AXIS_SHAPE];
    (void)top;
    if (shape != MUS__SHAPE_SIDE_WAIST && shape != MUS__SHAPE_BOXY)
        mus__board_fail(&half->board, MUS_ERR_DESIGN, "shape=%s: it has no recipe",
                        mus__style_word(MUS__AXIS_SHAPE, shape));
}
