/*
 * cape.c: a cape: front and back halves of three quarters of a circle that hang from the shoulders.
 *
 * The side seam goes straight on along the shoulder line of the bodice block, from the side neck point to the hem; the
 * hem is drawn about the side neck point and meets centre and seam square. The neck of a cape that does not
 * open in front is widened until the head passes.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "closure/closure.h"
#include "style/bodice.h"

#define CAPE_STRETCH_KNIT 1.15 /* the neck of a knit stretches to this many times its length over the head; chosen */
#define CAPE_STEPS 60


/* parts of the stature below the waist: to the knee, short, midi, long */
static double cape_length(const mus__half *half)
{
    static const double part[] = {0.30, 0.10, 0.42, 0.56, 0.30};
    const double *m = half->measures.v;
    const double below = isnan(half->def.length) ? part[half->style.option[MUS__AXIS_LENGTH]] * m[MUS_MEASURE_STATURE]
                                                 : half->def.length;
    return m[MUS_MEASURE_BACK_WAIST] + below;
}


/* opens the neck: a scoop is 2.5 cm along the shoulder and 5 cm down; without a closure then on until the head
 * passes */
static void cape_neck(mus__half *half)
{
    const double k = mus__measures_scale(&half->measures) * MUS__CM;
    const double need = half->measures.v[MUS_MEASURE_HEAD] + 2.0 * MUS__CM;
    const double stretch = mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_KNIT) ? CAPE_STRETCH_KNIT : 1.0;
    mus__bodice_half *front = &half->bodice.front, *back = &half->bodice.back;
    if (mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_SCOOP)) {
        mus__bodice_lower_neck(front, 2.5 * k, 5.0 * k);
        mus__bodice_lower_neck(back, 2.5 * k, 1.5 * k);
    }
    if (!mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_NONE)) return;
    for (int i = 0; i < CAPE_STEPS; i++) {
        if (2.0 * (front->neck_length + back->neck_length) * stretch >= need) return;
        const double out = fmin(0.2 * MUS__CM, 0.05 * front->shoulder_length);
        mus__bodice_lower_neck(front, out, 0.3 * MUS__CM);
        mus__bodice_lower_neck(back, out, 0.1 * MUS__CM);
    }
    mus__board_fail(&half->board, MUS_ERR_DESIGN, "cape: head %d mm does not pass neck %d mm, opened as far as it goes",
                    mus__millimetres(half->measures.v[MUS_MEASURE_HEAD]),
                    mus__millimetres(half->measures.v[MUS_MEASURE_NECK]));
}


/* draws neck, centre, hem and seam of a half in the frame of the block; returns the panel */
static int32_t cape_panel(mus__half *half, bool front, double length)
{
    const mus__bodice_half *block = front ? &half->bodice.front : &half->bodice.back;
    const double *snp = block->snp, *centre = block->centre;
    const double along[2] = {mus__cos(block->slope), -mus__sin(block->slope)};
    const double bottom[2] = {0.0, snp[1] - length};
    const double end[2] = {snp[0] + length * along[0], snp[1] + length * along[1]};
    mus__outline outline;
    mus__chain chain;
    double hem[8];

    /* a quarter turn less the slope about the side neck point, then level to the centre */
    const double reach = 4.0 / 3.0 * mus__tan(0.25 * (0.5 * MUS_PI - block->slope)) * length;
    mus__outline_begin(&outline);
    mus__chain_line(&chain, centre, bottom);
    mus__outline_add(&outline, front ? "cf" : "cb", "centre", 0.0, &chain);
    mus__cubic_set(hem, bottom, snp[0] + reach, bottom[1], end[0] + reach * along[1], end[1] - reach * along[0], end);
    mus__chain_cubic(&chain, hem);
    mus__outline_add(&outline, "hem", "hem", MUS__HEM_ALLOWANCE, &chain);
    mus__chain_line(&chain, end, snp);
    mus__outline_add(&outline, "sh", "shoulder", MUS__SEAM_ALLOWANCE, &chain);
    mus__chain_cubic(&chain, block->neck);
    mus__chain_reverse(&chain);
    mus__outline_add(&outline, "neck", "neck", MUS__TOP_NECK_SEAM, &chain);
    return mus__outline_panel(half, &outline, front ? "front" : "back", "body", !front);
}


void mus__cape_draft(mus__half *half)
{
    mus__bodice_def def;
    mus__board *board = &half->board;
    mus__bodice_def_init(&def, &half->measures);
    def.darts = false;
    const mus_status status = mus__bodice_draft(half->context, &half->measures, &def, &half->bodice);
    if (status != MUS_OK) {
        board->status = status;
        return;
    }
    cape_neck(half);
    const double length = cape_length(half);
    const int32_t front = cape_panel(half, true, length), back = cape_panel(half, false, length);
    if (board->status != MUS_OK) return;
    const int32_t a = mus__board_find(board, front, "sh"), b = mus__board_find(board, back, "sh");
    mus__board_sew(board, 1, &a, 1, &b);
    mus__panel_place_torso(half, front, true, length, half->skeleton.waist);
    mus__panel_place_torso(half, back, false, length, half->skeleton.waist);
    mus__closure_set(half);
}
