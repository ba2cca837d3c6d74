/*
 * garment_top.c: bodice, T-shirt and sleeveless top from the bodice and sleeve blocks.
 *
 * T-shirt: bodice block without darts, neck lowered until the head passes, sides straight to the hip; front and back
 * whole; sleeve caps as long as the armholes they meet. Edges counter-clockwise from the hem, named by the wearer's
 * side. Formulas: man page mus_design(3).
 */
#include <math.h>
#include <string.h>

#include "design/recipe.h"

#define TOP_SEAM (1.0 * MUS__CM)
#define TOP_NECK_SEAM (0.7 * MUS__CM)
#define TOP_HEM (2.5 * MUS__CM)
#define JERSEY_STRETCH 1.15 /* a jersey neckline stretches so far over the head */


/* the armhole from the underarm up, one edge */
static void top_armhole(const mus__bodice_half *half, mus__chain *out)
{
    mus__chain high;
    mus__chain_cubic(out, half->arm_high);
    mus__chain_cubic(&high, half->arm_low);
    mus__chain_append(out, &high);
    mus__chain_reverse(out);
}


/* the neck from the side neck to the centre */
static void top_neck(const mus__bodice_half *half, mus__chain *out)
{
    mus__chain_cubic(out, half->neck);
    mus__chain_reverse(out);
}


/* ---- T-shirt ---- */

typedef struct top_shirt {
    mus__bodice bodice;
    double widen; /* of the hem against the bust line, a half */
    double hem;   /* y */
    bool sleeves; /* else its armholes are openings */
} top_shirt;


/* neckline: side neck 1.5 cm out, back 1.5 cm and front 2 cm down, then down again until the head passes */
static mus_status top_open_neck(mus_context *context, const mus__measures *measures, mus__bodice *bodice)
{
    const double k = mus__measures_scale(measures), need = measures->v[MUS_MEASURE_HEAD] + 2.0 * MUS__CM;
    mus__bodice_lower_neck(&bodice->front, 1.5 * k * MUS__CM, 2.0 * k * MUS__CM);
    mus__bodice_lower_neck(&bodice->back, 1.5 * k * MUS__CM, 1.5 * k * MUS__CM);
    for (int i = 0; i < 40; i++) {
        const double girth = 2.0 * (bodice->front.neck_length + bodice->back.neck_length);
        if (girth * JERSEY_STRETCH >= need) return MUS_OK;
        const double out = fmin(0.2 * MUS__CM, 0.05 * bodice->front.shoulder_length);
        mus__bodice_lower_neck(&bodice->front, out, 0.3 * MUS__CM);
        mus__bodice_lower_neck(&bodice->back, out, 0.1 * MUS__CM);
    }
    return mus__fail(context, MUS_ERR_DESIGN, "neckline: head %g m does not pass neck %g m, opened as far as it goes",
                     measures->v[MUS_MEASURE_HEAD], measures->v[MUS_MEASURE_NECK]);
}


/* a shirt lies on the shoulder: its line 4.6 degrees flatter than the tape's, since the arm is off the body, and not
 * beyond the shoulder point, where the arm turns down: up to 0.15 shorter */
static void top_shirt_shoulder(const mus__draft *draft, mus__measures *measures)
{
    double *m = measures->v;
    m[MUS_MEASURE_SHOULDER_SLOPE] -= 0.08;
    const double neck = m[MUS_MEASURE_NECK] / 6.0 + 0.85 * MUS__CM, along = cos(m[MUS_MEASURE_SHOULDER_SLOPE]);
    const double reach = (draft->skeleton.shoulder_x - neck) / along;
    m[MUS_MEASURE_SHOULDER] = fmax(0.85 * m[MUS_MEASURE_SHOULDER], fmin(m[MUS_MEASURE_SHOULDER], reach));
}


static void top_shirt_blocks(mus__draft *draft, bool sleeves, top_shirt *shirt)
{
    mus__measures measures = draft->measures;
    const double *m = measures.v, k = mus__measures_scale(&measures);
    mus__bodice_def def;
    top_shirt_shoulder(draft, &measures);
    mus__bodice_def_init(&def, &measures);
    def.bust_ease = isnan(draft->def.ease) ? 8.0 * k * MUS__CM : draft->def.ease;
    def.scye_ease = 1.5 * k * MUS__CM;
    def.balance = 0.4 * MUS__CM;
    def.darts = false;
    shirt->sleeves = sleeves;
    draft->status = mus__bodice_draft(draft->context, &measures, &def, &shirt->bodice);
    if (draft->status != MUS_OK) return;
    draft->status = top_open_neck(draft->context, &measures, &shirt->bodice);
    if (draft->status != MUS_OK) return;

    /* the hem clears the hip by 4 cm and lies 6 cm below it; front and back widen alike, so their sides stay equal */
    const double hip = m[MUS_MEASURE_HIP] + 4.0 * k * MUS__CM, bust = m[MUS_MEASURE_BUST] + def.bust_ease;
    const double length =
        isnan(draft->def.length) ? m[MUS_MEASURE_WAIST_TO_HIP] + 6.0 * k * MUS__CM : draft->def.length;
    const double part = fmin(1.0, length / m[MUS_MEASURE_WAIST_TO_HIP]);
    shirt->hem = -length;
    shirt->widen = part * fmax(0.0, (hip - bust) / 4.0);
}


/* a whole front or back; `near` is the wearer's side that the drawing's x > 0 lies on: 'L' of a front, 'R' of a back */
static void top_shirt_panel(mus__draft *draft, const top_shirt *shirt, bool front, mus__piece *piece)
{
    const mus__bodice_half *half = front ? &shirt->bodice.front : &shirt->bodice.back;
    const double hem[2] = {half->under[0] + shirt->widen, shirt->hem}, other[2] = {-hem[0], hem[1]};
    mus__chain chain;
    mus__piece_begin(piece, draft);
    mus__chain_line(&chain, other, hem);
    mus__piece_edge_add(piece, "hem", "hem", TOP_HEM, &chain);
    mus__chain_line(&chain, hem, half->under);
    mus__piece_edge_add(piece, front ? "sideL" : "sideR", NULL, TOP_SEAM, &chain);
    top_armhole(half, &chain);
    mus__piece_edge_add(piece, front ? "armL" : "armR", shirt->sleeves ? NULL : "armhole", TOP_SEAM, &chain);
    mus__chain_line(&chain, half->tip, half->snp);
    mus__piece_edge_add(piece, front ? "shL" : "shR", NULL, TOP_SEAM, &chain);
    top_neck(half, &chain);
    mus__chain_unfold(&chain);
    mus__piece_edge_add(piece, "neck", "neck", TOP_NECK_SEAM, &chain);
    mus__piece_unfold(piece, 1, 3);
    mus__piece_panel(piece, front ? "front" : "back", "body", false);

    /* pitch: single in front, double behind; centre of neck and hem */
    const char *near = front ? "armL" : "armR", *far = front ? "armR" : "armL";
    const int32_t kind = front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE;
    mus__piece_notch(piece, near, half->arm_low_length, kind);
    mus__piece_notch(piece, far, half->arm_length - half->arm_low_length, kind);
    mus__piece_notch(piece, "neck", half->neck_length, MUS_NOTCH_SINGLE);
    mus__piece_notch(piece, "hem", hem[0], MUS_NOTCH_SINGLE);
    const double top[2] = {0.0, half->centre[1]}, bottom[2] = {0.0, shirt->hem};
    mus__piece_mark(piece, front ? "centre front" : "centre back", top, bottom);
    mus__place_torso(piece, front, hem[0], draft->skeleton.waist);
}


/* shoulders and sides of front and back */
static void top_sew_torso(const mus__piece *front, const mus__piece *back)
{
    static const char *const edges[] = {"shL", "shR", "sideL", "sideR"};
    for (int i = 0; i < 4; i++) mus__piece_seam(front, edges[i], back, edges[i], 0.0);
}


/* short sleeve with a flat cap: a quarter of its length high, between 4 and 12 cm wider than the arm */
static void top_sleeve_block(mus__draft *draft, const mus__bodice *bodice, mus__sleeve *sleeve)
{
    const double *m = draft->measures.v, k = mus__measures_scale(&draft->measures);
    mus__sleeve_def def = {.front = bodice->front.arm_length, .back = bodice->back.arm_length};
    const double cap = def.front + def.back, arm = m[MUS_MEASURE_UPPER_ARM];
    def.width = fmax(arm + 4.0 * k * MUS__CM, fmin(arm + 12.0 * k * MUS__CM, mus__sleeve_width(cap, 0.25)));
    def.width = fmin(def.width, cap / 1.03);

    /* 0.36 of the arm long, and 2.5 cm below the cap at least, which a small child's arm asks for */
    def.length = draft->def.sleeve;
    if (isnan(def.length)) {
        def.length = m[MUS_MEASURE_ARM];
        draft->status = mus__sleeve_draft(draft->context, &def, sleeve);
        if (draft->status != MUS_OK) return;
        def.length = fmax(0.36 * m[MUS_MEASURE_ARM], sleeve->height + 2.5 * MUS__CM);
    }

    /* the hem narrows from the biceps towards the hand with the length */
    const double hand = fmax(1.2 * m[MUS_MEASURE_WRIST], m[MUS_MEASURE_HAND] + 1.5 * MUS__CM);
    const double part = fmax(0.15, fmin(1.0, def.length / m[MUS_MEASURE_ARM] - 0.25));
    def.hem = def.width + part * (fmin(hand, def.width) - def.width);
    draft->status = mus__sleeve_draft(draft->context, &def, sleeve);
}


static void top_sleeve(mus__draft *draft, const mus__sleeve *sleeve, const mus__bodice *bodice, int32_t side,
                       mus__piece *piece)
{
    const double w = 0.5 * sleeve->width, hem = 0.5 * sleeve->hem, low = sleeve->height - sleeve->length;
    const double front[2] = {-w, 0.0}, back[2] = {w, 0.0}, front_hem[2] = {-hem, low}, back_hem[2] = {hem, low};
    mus__chain chain;
    mus__piece_begin(piece, draft);
    mus__chain_line(&chain, front_hem, back_hem);
    mus__piece_edge_add(piece, "hem", "cuff", TOP_HEM, &chain);
    mus__chain_line(&chain, back_hem, back);
    mus__piece_edge_add(piece, "underB", NULL, TOP_SEAM, &chain);
    mus__chain_cubic(&chain, sleeve->cap_back);
    mus__chain_reverse(&chain);
    mus__piece_edge_add(piece, "capB", NULL, TOP_SEAM, &chain);
    mus__chain_cubic(&chain, sleeve->cap_front);
    mus__chain_reverse(&chain);
    mus__piece_edge_add(piece, "capF", NULL, TOP_SEAM, &chain);
    mus__chain_line(&chain, front, front_hem);
    mus__piece_edge_add(piece, "underF", NULL, TOP_SEAM, &chain);
    mus__piece_panel(piece, side == 0 ? "sleeve_left" : "sleeve_right", "arm", side == 1);

    /* pitches at the armholes' own, from the underarm */
    mus__piece_notch(piece, "capF", sleeve->front_length - bodice->front.arm_low_length, MUS_NOTCH_SINGLE);
    mus__piece_notch(piece, "capB", bodice->back.arm_low_length, MUS_NOTCH_DOUBLE);
    mus__piece_mark(piece, "biceps", front, back);
    mus__place_arm(piece, sleeve, side);
}


void mus__draft_tshirt(mus__draft *draft)
{
    top_shirt shirt;
    mus__sleeve sleeve;
    mus__piece front, back, arm[2];
    top_shirt_blocks(draft, true, &shirt);
    if (draft->status == MUS_OK) top_sleeve_block(draft, &shirt.bodice, &sleeve);
    if (draft->status != MUS_OK) return;
    top_shirt_panel(draft, &shirt, true, &front);
    top_shirt_panel(draft, &shirt, false, &back);
    top_sew_torso(&front, &back);
    for (int32_t side = 0; side < 2; side++) {
        const char *armhole = side == 0 ? "armL" : "armR";
        top_sleeve(draft, &sleeve, &shirt.bodice, side, &arm[side]);
        mus__piece_seam(&arm[side], "capF", &front, armhole, 0.0);
        mus__piece_seam(&arm[side], "capB", &back, armhole, 0.0);
        mus__piece_seam(&arm[side], "underF", &arm[side], "underB", 0.0);
    }
    mus__piece_pair(&arm[0], &arm[1]);
}


void mus__draft_sleeveless(mus__draft *draft)
{
    top_shirt shirt;
    mus__piece front, back;
    top_shirt_blocks(draft, false, &shirt);
    if (draft->status != MUS_OK) return;
    top_shirt_panel(draft, &shirt, true, &front);
    top_shirt_panel(draft, &shirt, false, &back);
    top_sew_torso(&front, &back);
}


/* ---- bodice ---- */

/* waist from the centre to the side, with its darts: w1, wd1, wd2, w2, ... */
static void top_waist(mus__piece *piece, const mus__bodice_half *half)
{
    const double centre[2] = {0.0, 0.0};
    const double *at = centre;
    mus__chain chain;
    char name[] = "w1", leg[] = "wd1";
    for (int32_t d = 0; d < half->ndart; d++) {
        const double *dart = half->dart[d];
        mus__chain_line(&chain, at, dart);
        mus__piece_edge_add(piece, name, "waist", TOP_SEAM, &chain);
        mus__chain_line(&chain, dart, dart + 2);
        mus__piece_edge_add(piece, leg, NULL, 0.0, &chain);
        leg[2]++;
        mus__chain_line(&chain, dart + 2, dart + 4);
        mus__piece_edge_add(piece, leg, NULL, 0.0, &chain);
        leg[2]++;
        name[1]++;
        at = dart + 4;
    }
    mus__chain_line(&chain, at, half->side);
    mus__piece_edge_add(piece, name, "waist", TOP_SEAM, &chain);
}


/* side from the waist up: with a bust dart in front; behind, split where the front's dart lies */
static void top_bodice_side(mus__piece *piece, const mus__bodice *bodice, bool front)
{
    const mus__bodice_half *half = front ? &bodice->front : &bodice->back, *darted = &bodice->front;
    mus__chain chain;
    if (!(darted->theta > 0.0)) {
        mus__chain_line(&chain, half->side, half->under);
        mus__piece_edge_add(piece, "side", NULL, TOP_SEAM, &chain);
        return;
    }
    const double low = hypot(darted->mouth[2] - darted->side[0], darted->mouth[3] - darted->side[1]);
    const double part = low / darted->side_length;
    double upper[2], lower[2];
    for (int i = 0; i < 2; i++) {
        lower[i] = front ? half->mouth[2 + i] : half->side[i] + part * (half->under[i] - half->side[i]);
        upper[i] = front ? half->mouth[i] : lower[i];
    }
    mus__chain_line(&chain, half->side, lower);
    mus__piece_edge_add(piece, "side1", NULL, TOP_SEAM, &chain);
    if (front) {
        mus__chain_line(&chain, lower, half->apex);
        mus__piece_edge_add(piece, "bd1", NULL, 0.0, &chain);
        mus__chain_line(&chain, half->apex, upper);
        mus__piece_edge_add(piece, "bd2", NULL, 0.0, &chain);
    }
    mus__chain_line(&chain, upper, half->under);
    mus__piece_edge_add(piece, "side2", NULL, TOP_SEAM, &chain);
}


/* a half as a panel: the drawing is the left front or the right back */
static void top_bodice_panel(mus__draft *draft, const mus__bodice *bodice, bool front, bool mirror, mus__piece *piece)
{
    static const char *const names[2][2] = {{"back_right", "back_left"}, {"front_left", "front_right"}};
    const mus__bodice_half *half = front ? &bodice->front : &bodice->back;
    const double waist[2] = {0.0, 0.0};
    mus__chain chain;
    mus__piece_begin(piece, draft);
    mus__chain_line(&chain, half->centre, waist);
    mus__piece_edge_add(piece, front ? "cf" : "cb", NULL, TOP_SEAM, &chain);
    top_waist(piece, half);
    top_bodice_side(piece, bodice, front);
    top_armhole(half, &chain);
    mus__piece_edge_add(piece, "arm", "armhole", TOP_SEAM, &chain);
    mus__chain_line(&chain, half->tip, half->snp);
    mus__piece_edge_add(piece, "sh", NULL, TOP_SEAM, &chain);
    top_neck(half, &chain);
    mus__piece_edge_add(piece, "neck", "neck", TOP_NECK_SEAM, &chain);
    mus__piece_panel(piece, names[front][mirror], "body", mirror);
    mus__piece_notch(piece, "arm", half->arm_low_length, front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
    mus__place_torso(piece, front, half->under[0], draft->skeleton.waist);
}


/* darts of one panel */
static void top_sew_darts(const mus__piece *piece)
{
    static const char *const legs[][2] = {{"wd1", "wd2"}, {"wd3", "wd4"}, {"bd1", "bd2"}};
    for (int i = 0; i < 3; i++)
        if (mus__piece_edge_find(piece, legs[i][0]) != MUS_NONE)
            mus__piece_seam(piece, legs[i][0], piece, legs[i][1], 0.0);
}


void mus__draft_bodice(mus__draft *draft)
{
    mus__bodice_def def;
    mus__bodice bodice;
    mus__piece front[2], back[2]; /* left, right */
    mus__bodice_def_init(&def, &draft->measures);
    if (!isnan(draft->def.ease)) def.bust_ease = draft->def.ease;
    draft->status = mus__bodice_draft(draft->context, &draft->measures, &def, &bodice);
    if (draft->status != MUS_OK) return;
    for (int side = 0; side < 2; side++) {
        top_bodice_panel(draft, &bodice, true, side == 1, &front[side]);
        top_bodice_panel(draft, &bodice, false, side == 0, &back[side]);
        top_sew_darts(&front[side]);
        top_sew_darts(&back[side]);
    }
    static const char *const seams[] = {"sh", "side", "side1", "side2"};
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < 4; i++)
            if (mus__piece_edge_find(&front[side], seams[i]) != MUS_NONE)
                mus__piece_seam(&front[side], seams[i], &back[side], seams[i], 0.0);
    mus__piece_seam(&front[0], "cf", &front[1], "cf", 0.0);
    mus__piece_seam(&back[0], "cb", &back[1], "cb", 0.0);
    mus__piece_pair(&front[0], &front[1]);
    mus__piece_pair(&back[1], &back[0]);
}
