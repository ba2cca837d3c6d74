/*
 * garment_skirt.c: straight skirt with darts, and an A-line skirt without, each a whole front and a whole back.
 *
 * Edges counter-clockwise from the hem: hem, the near side, the waist from side to side with its darts, the far side.
 * The near side of a front is the wearer's left, that of a back the right.
 */
#include <math.h>
#include <string.h>

#include "design/recipe.h"

#define SKIRT_SEAM (1.0 * MUS__CM)
#define SKIRT_HEM (4.0 * MUS__CM)


/* part of the waist edge between two arc lengths from the centre, walked towards the centre */
static void skirt_waist_part(const mus__skirt_half *half, double s0, double s1, mus__chain *out)
{
    double cubic[8];
    mus__cubic_part(half->waist, s0, s1, cubic);
    mus__chain_cubic(out, cubic);
    mus__chain_reverse(out);
}


/* near half of the waist from the side to the innermost dart; the middle part is unfolded by the caller */
static void skirt_waist_near(mus__piece *piece, const mus__skirt_half *half, char side)
{
    char name[] = "w1?", leg[] = "d1?";
    name[2] = leg[2] = side;
    double s = half->waist_length + half->dart_width;
    mus__chain chain;
    for (int32_t d = half->ndart - 1; d >= 0; d--) {
        const double *dart = half->dart[d];
        skirt_waist_part(half, half->dart_s[d][1], s, &chain);
        mus__piece_edge_add(piece, name, "waist", SKIRT_SEAM, &chain);
        name[1]++;
        mus__chain_line(&chain, dart + 4, dart + 2);
        mus__piece_edge_add(piece, leg, NULL, 0.0, &chain);
        leg[1]++;
        mus__chain_line(&chain, dart + 2, dart);
        mus__piece_edge_add(piece, leg, NULL, 0.0, &chain);
        leg[1]++;
        s = half->dart_s[d][0];
    }
}


static void skirt_panel(mus__draft *draft, const mus__skirt *skirt, bool front, mus__piece *piece)
{
    const mus__skirt_half *half = front ? &skirt->front : &skirt->back;
    const char side = front ? 'L' : 'R';
    char name[] = "side?";
    name[4] = side;
    mus__chain chain, low;
    mus__piece_begin(piece, draft);

    /* hem from the far side to the near one; the near side up */
    mus__chain_cubic(&chain, half->hem);
    mus__chain_reverse(&chain);
    mus__chain_unfold(&chain);
    mus__chain_reverse(&chain);
    mus__piece_edge_add(piece, "hem", "hem", SKIRT_HEM, &chain);
    mus__chain_cubic(&chain, half->side_high);
    mus__chain_cubic(&low, half->side_low);
    mus__chain_append(&chain, &low);
    mus__chain_reverse(&chain);
    mus__piece_edge_add(piece, name, NULL, SKIRT_SEAM, &chain);

    /* waist: near half, the middle across the centre, far half; the far side down */
    skirt_waist_near(piece, half, side);
    const int32_t last = piece->n - 1;
    const double inner = half->ndart > 0 ? half->dart_s[0][0] : half->waist_length + half->dart_width;
    skirt_waist_part(half, 0.0, inner, &chain);
    mus__chain_unfold(&chain);
    mus__piece_edge_add(piece, "waist", "waist", SKIRT_SEAM, &chain);
    mus__piece_unfold(piece, 1, last);
    mus__piece_panel(piece, front ? "front" : "back", "body", false);

    /* hip notches from the hem, centre of waist and hem */
    const double hip = half->side_length - half->side_high_length;
    mus__piece_notch(piece, name, hip, front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
    name[4] = front ? 'R' : 'L';
    mus__piece_notch(piece, name, half->side_high_length, front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
    mus__piece_notch(piece, "waist", inner, MUS_NOTCH_SINGLE);
    const double top[2] = {0.0, half->waist[1]}, bottom[2] = {0.0, half->hem[1]};
    mus__piece_mark(piece, front ? "centre front" : "centre back", top, bottom);
    mus__place_hips(piece, front, skirt->front.hem_width + skirt->back.hem_width, draft->skeleton.waist);
}


/* darts: d1 with d2, d3 with d4, on both sides */
static void skirt_sew_darts(const mus__piece *piece)
{
    static const char *const legs[][2] = {{"d1L", "d2L"}, {"d3L", "d4L"}, {"d1R", "d2R"}, {"d3R", "d4R"}};
    for (int i = 0; i < 4; i++)
        if (mus__piece_edge_find(piece, legs[i][0]) != MUS_NONE)
            mus__piece_seam(piece, legs[i][0], piece, legs[i][1], 0.0);
}


static void skirt_make(mus__draft *draft, const mus__skirt_def *def)
{
    mus__skirt skirt;
    mus__piece front, back;
    draft->status = mus__skirt_draft(draft->context, def, &skirt);
    if (draft->status != MUS_OK) return;
    skirt_panel(draft, &skirt, true, &front);
    skirt_panel(draft, &skirt, false, &back);
    skirt_sew_darts(&front);
    skirt_sew_darts(&back);
    mus__piece_seam(&front, "sideL", &back, "sideL", 0.0);
    mus__piece_seam(&front, "sideR", &back, "sideR", 0.0);
}


/* what both skirts share. They hang on the waist by being tighter than the hip: where that is hardly wider, no ease */
static mus__skirt_def skirt_def(const mus__draft *draft)
{
    const double *m = draft->measures.v;
    mus__skirt_def def;
    memset(&def, 0, sizeof def);
    def.waist = m[MUS_MEASURE_WAIST];
    def.hip = m[MUS_MEASURE_HIP];
    def.depth = m[MUS_MEASURE_WAIST_TO_HIP];
    def.waist_ease = fmin(2.0 * MUS__CM, 0.1 * fmax(0.0, def.hip - def.waist));
    def.hip_ease = isnan(draft->def.ease) ? 4.0 * MUS__CM : draft->def.ease;
    def.length = isnan(draft->def.length) ? 0.36 * m[MUS_MEASURE_STATURE] : draft->def.length;
    def.rise = 1.2 * MUS__CM;
    def.darts = true;
    return def;
}


void mus__draft_skirt(mus__draft *draft)
{
    const mus__skirt_def def = skirt_def(draft);
    skirt_make(draft, &def);
}


/* no dart, so little shaping: the top edge is wider than the waist by 0.15 of what the hip is, and rests above the hip,
 * which it must therefore not pass: 0.95 of the hip at most */
void mus__draft_skirt_plain(mus__draft *draft)
{
    mus__skirt_def def = skirt_def(draft);
    def.waist_ease = fmin(0.15 * (def.hip - def.waist), 0.95 * def.hip - def.waist);
    def.flare = 0.10 * def.length;
    def.darts = false;
    skirt_make(draft, &def);
}
