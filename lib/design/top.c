/*
 * top.c: the body of a top, dress or jumpsuit as a half garment: bodice block, neckline, shaping, closure, sewn.
 *
 * The bodice block of the person (darted for women) is drawn down to the hem with the neckline of the style; the bust
 * dart opens at the side and is then moved, split, eased or turned into a seam (shaping.c). Below the waist the side
 * curves to the hip, or runs straight in a boxy top. Front and back sides are congruent when the darts are closed, so
 * side seams match by construction. Formulas: man page mus_design(3); drafting reference 3.1, 3.9, 3.10.
 */
#include <math.h>
#include <string.h>

#include "design/top.h"
#include "geom/curve.h"
#include "geom/vec.h"

/* crotch and shoulder of a jumpsuit are tied: its body is longer, so that one can bend and sit */
#define TORSO_BLOUSE (2.5 * MUS__CM)


bool mus__style_is(const mus__half *half, int32_t axis, int32_t option)
{
    return half->style.option[axis] == option;
}


void mus__top_turn(const double *p, const double *o, double a, double *out)
{
    const double c = cos(a), s = sin(a), x = p[0] - o[0], y = p[1] - o[1];
    out[0] = o[0] + c * x - s * y;
    out[1] = o[1] + s * x + c * y;
}


/* ---- drawing ---- */

void mus__drawing_add(mus__drawing *drawing, const char *name, const char *label, double allowance,
                      const mus__chain *chain)
{
    MUS_ASSERT(drawing->n < MUS__DRAWING_EDGES);
    mus__drawing_edge *edge = &drawing->edge[drawing->n++];
    edge->name = name, edge->label = label;
    edge->allowance = allowance;
    edge->chain = *chain;
}


int32_t mus__drawing_lay(mus__half *half, const mus__drawing *drawing, const char *name)
{
    mus__board *board = &half->board;
    const int32_t panel = mus__board_panel_add(board, name, "body");
    for (int32_t i = 0; i < drawing->n; i++) {
        const mus__drawing_edge *edge = &drawing->edge[drawing->front ? i : drawing->n - 1 - i];
        mus__chain chain = edge->chain;
        if (!drawing->front) mus__chain_mirror(&chain);
        const int32_t side = mus__board_side_add(board, panel, edge->name, edge->label, chain.npiece, chain.kinds,
                                                 chain.nxy, chain.xy);
        if (side != MUS_NONE) board->side[side].allowance = edge->allowance;
    }
    mus__board_panel_close(board, panel);
    return panel;
}


/* ---- blocks ---- */

/* a seam on the shoulder does not go beyond the shoulder point, where the arm turns down: up to 0.15 shorter. A loose
 * top, and one without sleeves, lies on the shoulder: its line 4.6 degrees flatter than the tape's, since the arm is
 * off the body */
static void torso_shoulder(const mus__half *half, bool loose, mus__measures *measures)
{
    double *m = measures->v;
    if (loose) m[MUS_MEASURE_SHOULDER_SLOPE] -= 0.08;
    const double neck = m[MUS_MEASURE_NECK] / 6.0 + 0.85 * MUS__CM, along = cos(m[MUS_MEASURE_SHOULDER_SLOPE]);
    const double reach = (half->skeleton.shoulder_x - neck) / along;
    m[MUS_MEASURE_SHOULDER] = fmax(0.85 * m[MUS_MEASURE_SHOULDER], fmin(m[MUS_MEASURE_SHOULDER], reach));
}


/* y of the lower edge: the waist of a dress or jumpsuit, else by the caller's wish or the word */
static double torso_hem(const mus__half *half, double scale)
{
    const double hip = half->measures.v[MUS_MEASURE_WAIST_TO_HIP];
    if (!mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP)) return 0.0;
    if (!isnan(half->def.length)) return -half->def.length;
    switch (half->style.option[MUS__AXIS_TOP_LENGTH]) {
    case MUS__TOP_LENGTH_CROP: return fmin(4.0 * scale * MUS__CM, 0.25 * half->bodice.underarm);
    case MUS__TOP_LENGTH_WAIST: return 0.0;
    case MUS__TOP_LENGTH_TUNIC: return -(hip + 20.0 * scale * MUS__CM);
    default: return -(hip + 6.0 * scale * MUS__CM);
    }
}


/* the block of the person: darted for women, but for a loose knit; a boxy one lies loosely on the shoulder */
static void torso_blocks(mus__half *half, mus__top *top)
{
    mus__measures measures = half->measures;
    mus__bodice_def def;
    const double k = mus__measures_scale(&measures);
    const bool boxy = mus__style_is(half, MUS__AXIS_SHAPE, MUS__SHAPE_BOXY);
    const bool bare = mus__style_is(half, MUS__AXIS_SLEEVE, MUS__SLEEVE_NONE);
    mus__bodice_def_init(&def, &measures);
    torso_shoulder(half, boxy || bare, &measures);
    if (mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_JUMPSUIT)) {
        measures.v[MUS_MEASURE_BACK_WAIST] += TORSO_BLOUSE * k;
        measures.v[MUS_MEASURE_FRONT_WAIST] += TORSO_BLOUSE * k;
    }
    def.bust_ease = half->bust_ease;
    def.waist_ease = half->waist_ease;
    if (boxy) {
        def.scye_ease = 1.5 * k * MUS__CM;
        def.balance = 0.4 * MUS__CM;
        def.darts = def.darts && mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_WOVEN);
    } else if (bare) {
        def.scye_ease -= 1.0 * k * MUS__CM;
    }
    if (mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_COAT)) {
        def.scye_ease += 2.0 * k * MUS__CM;
        def.neck_ease += 3.0 * k * MUS__CM;
    }
    if (mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_STRAPLESS)) def.bust_ease = fmin(def.bust_ease, 1.0 * MUS__CM);
    const int32_t shape = half->style.option[MUS__AXIS_SHAPE];
    const bool moves = shape == MUS__SHAPE_WAIST || shape == MUS__SHAPE_SHOULDER_WAIST || shape == MUS__SHAPE_FRENCH ||
                       shape == MUS__SHAPE_NECK_GATHERS || shape == MUS__SHAPE_CF_GATHERS;
    if (moves && !def.darts) {
        mus__board_fail(&half->board, MUS_ERR_DESIGN, "shape=%s moves a bust dart, which is drafted for women alone",
                        mus__style_word(MUS__AXIS_SHAPE, shape));
        return;
    }
    const mus_status status = mus__bodice_draft(half->context, &measures, &def, &half->bodice);
    if (status != MUS_OK) half->board.status = status;

    top->scale = k;
    top->darts = def.darts && !boxy;
    top->hem = torso_hem(half, k);
    half->waist_level = half->skeleton.waist;
}


/* side seam: in at the waist, out to the hip. A block without darts is taken in by as much at the side as a darted one
 * is, a dress or jumpsuit by what the waist asks for, but not steeper than 0.18; what is left is ease of the waist */
static void torso_sides(mus__half *half, mus__top *top)
{
    const mus__bodice *bodice = &half->bodice;
    const double *m = half->measures.v;
    const bool boxy = mus__style_is(half, MUS__AXIS_SHAPE, MUS__SHAPE_BOXY);
    const bool top_alone = mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP);
    const double girth = 2.0 * (bodice->front.side[0] + bodice->back.side[0] + 2.0 * bodice->side_in);
    const double t = (girth - m[MUS_MEASURE_WAIST] - half->waist_ease) / 4.0;

    top->side_in = bodice->side_in;
    if (boxy) {
        top->side_in = 0.0;
    } else if (!top->darts) {
        top->side_in = top_alone ? fmax(0.0, fmin(0.35 * t, 2.5 * MUS__CM)) : fmin(t, 0.18 * bodice->underarm);
    }

    /* hip level; a boxy hem clears the hip, in proportion above it */
    top->hip = -m[MUS_MEASURE_WAIST_TO_HIP];
    const double hip = (m[MUS_MEASURE_HIP] + half->hip_ease - girth) / 4.0;
    top->hip_out = fmax(0.0, hip + top->side_in);
    if (boxy) top->hip_out = fmax(0.0, fmin(1.0, -top->hem / m[MUS_MEASURE_WAIST_TO_HIP])) * fmax(0.0, hip);
}


/* ---- edges ---- */

void mus__top_under(const mus__half *half, const mus__top *top, bool front, double *closed, double *turned)
{
    const mus__bodice *bodice = &half->bodice;
    const mus__bodice_half *block = front ? &bodice->front : &bodice->back;
    const double corner[2] = {block->side[0] + bodice->side_in, bodice->underarm};
    const double waist[2] = {corner[0] - top->side_in, 0.0}, part = top->low / mus__dist2(corner, waist);
    for (int i = 0; i < 2; i++) closed[i] = corner[i] + part * (waist[i] - corner[i]);
    if (front && block->theta > 0.0)
        mus__top_turn(closed, block->bust, block->theta, turned);
    else
        memcpy(turned, closed, 2 * sizeof *turned);
}


/* the side from the hem up to the waist, or where the straight part begins; `under` closed underarm. Fills the chain
 * without its last line and gives the line's start */
static bool torso_side_low(const mus__half *half, const mus__top *top, const double *under, mus__chain *chain,
                         double *start)
{
    const double waist[2] = {under[0] - top->side_in, 0.0};
    if (mus__style_is(half, MUS__AXIS_SHAPE, MUS__SHAPE_BOXY)) {
        start[0] = under[0] + top->hip_out, start[1] = top->hem;
        return false;
    }
    if (top->hem >= 0.0) {
        start[0] = waist[0] + (under[0] - waist[0]) * top->hem / under[1], start[1] = top->hem;
        return false;
    }

    /* waist to hip: [W, W + (0.45 out, 0.30 hip), (out, 0.55 hip), (out, hip)], as far as the hem */
    const double hip[2] = {waist[0] + top->hip_out, top->hip};
    double cubic[8], lower[8], rest[8];
    mus__cubic_set(cubic, waist, waist[0] + 0.45 * top->hip_out, 0.30 * top->hip, hip[0], 0.55 * top->hip, hip);
    if (top->hem <= top->hip - 1e-3) {
        const double end[2] = {hip[0], top->hem};
        mus__chain curve;
        mus__chain_line(chain, end, hip);
        mus__chain_cubic(&curve, cubic);
        mus__chain_reverse(&curve);
        mus__chain_append(chain, &curve);
    } else {
        double lo = 0.0, hi = 1.0;
        for (int i = 0; i < 50; i++) {
            const double t = 0.5 * (lo + hi), u = 1.0 - t;
            const double high = u * (u * cubic[1] + 3.0 * t * cubic[3]) + 3.0 * t * t * cubic[5];
            const double y = u * high + t * t * t * cubic[7];
            if (y > top->hem) lo = t;
            else hi = t;
        }
        mus__curve_split(MUS__CUBIC, cubic, lo, lower, rest);
        mus__chain_cubic(chain, lower);
        mus__chain_reverse(chain);
    }
    memcpy(start, waist, sizeof waist);
    return true;
}


/* side edges from the hem to the underarm; in front with the bust dart open about the bust point. Gives the start of
 * the hem's end and the underarm */
static void torso_side(const mus__half *half, const mus__top *top, bool front, mus__drawing *drawing)
{
    const mus__bodice *bodice = &half->bodice;
    const mus__bodice_half *block = front ? &bodice->front : &bodice->back;
    const double closed[2] = {block->side[0] + bodice->side_in, bodice->underarm};
    double start[2], under[2], turned[2];
    mus__chain chain, line;
    const bool curved = torso_side_low(half, top, closed, &chain, start);
    mus__top_under(half, top, front, under, turned);

    /* without a bust dart one edge */
    if (!front || !(block->theta > 0.0)) {
        mus__chain_line(&line, start, under);
        if (curved) mus__chain_append(&chain, &line);
        mus__drawing_add(drawing, "side", "side", MUS__TOP_SEAM, curved ? &chain : &line);
        return;
    }

    /* the mouth at bust level, 3 cm below the armhole at least */
    const double y = fmax(fmin(block->bust[1], under[1] - 3.0 * top->scale * MUS__CM), start[1] + 0.01);
    const double at = (y - start[1]) / (under[1] - start[1]);
    const double lower[2] = {start[0] + at * (under[0] - start[0]), y};
    double upper[2];
    mus__top_turn(lower, block->bust, block->theta, upper);
    mus__chain_line(&line, start, lower);
    if (curved) mus__chain_append(&chain, &line);
    mus__drawing_add(drawing, "side1", "side", MUS__TOP_SEAM, curved ? &chain : &line);
    const double middle[2] = {0.5 * (lower[0] + upper[0]), 0.5 * (lower[1] + upper[1])};
    const double back = fmin(top->point_back / mus__dist2(middle, block->bust), 0.6);
    double point[2];
    for (int i = 0; i < 2; i++) point[i] = block->bust[i] + back * (middle[i] - block->bust[i]);
    mus__chain_line(&line, lower, point);
    mus__drawing_add(drawing, "bd1", "", 0.0, &line);
    mus__chain_line(&line, point, upper);
    mus__drawing_add(drawing, "bd2", "", 0.0, &line);
    mus__chain_line(&line, upper, turned);
    mus__drawing_add(drawing, "side2", "side", MUS__TOP_SEAM, &line);
}


/* as wide as half the dart at the waist, and below the hips 1.5 mm, so that the outline does not touch itself */
void mus__top_dart_leg(const mus__top *top, const double *dart, double turn, mus__chain *out)
{
    const double x = dart[2], wide = 0.5 * (dart[4] - dart[0]), narrow = fmin(1.5e-3, wide), end = 0.8 * top->hip;
    const double point[2] = {x, dart[3]};
    double xy[4][2];
    int32_t n = 0;
    if (top->hem >= 0.0) {
        xy[n][0] = x + turn * wide * (1.0 - top->hem / dart[3]), xy[n++][1] = top->hem;
    } else {
        if (top->hem < end - 0.01) xy[n][0] = x + turn * narrow, xy[n++][1] = top->hem;
        const double low = fmax(end, top->hem), part = low / end;
        xy[n][0] = x + turn * (wide + part * (narrow - wide)), xy[n++][1] = low;
        xy[n][0] = x + turn * wide, xy[n++][1] = 0.0;
    }
    memcpy(xy[n++], point, sizeof point);
    mus__chain_line(out, xy[0], xy[1]);
    for (int32_t i = 1; i + 1 < n; i++) {
        mus__chain line;
        mus__chain_line(&line, xy[i], xy[i + 1]);
        mus__chain_append(out, &line);
    }
}


/* the lower edge from the centre to the side, with the waist darts of the block: w1, wd1, wd2, w2, ... */
static void torso_low(const mus__half *half, const mus__top *top, int32_t which, const double *end,
                      mus__drawing *drawing)
{
    static const char *const edges[] = {"w1", "w2", "w3"}, *const legs[] = {"wd1", "wd2", "wd3", "wd4"};
    const bool alone = mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP);
    const mus__bodice_half *block = which == MUS__TOP_FRONT ? &half->bodice.front : &half->bodice.back;
    const char *label = alone ? "hem" : "waist";
    const double allowance = alone ? MUS__TOP_HEM : MUS__TOP_SEAM;
    const int32_t ndart = top->waist_darts[which] ? block->ndart : 0;
    const mus__chain *neck = &top->neck[which];
    const double highest = neck->xy[2 * (neck->nxy - 1) + 1] - 3.0 * top->scale * MUS__CM;
    double at[2] = {0.0, top->hem};
    mus__chain chain, left, right;
    for (int32_t d = 0; d < ndart; d++) {
        double dart[6];
        memcpy(dart, block->dart[d], sizeof dart);
        if (which == MUS__TOP_FRONT && top->meet) dart[3] = block->bust[1];
        if (which == MUS__TOP_BACK) dart[3] = fmin(dart[3], highest);
        mus__top_dart_leg(top, dart, -1.0, &left);
        mus__top_dart_leg(top, dart, 1.0, &right);
        mus__chain_line(&chain, at, left.xy);
        mus__drawing_add(drawing, edges[d], label, allowance, &chain);
        mus__drawing_add(drawing, legs[2 * d], "", 0.0, &left);
        memcpy(at, right.xy, sizeof at);
        mus__chain_reverse(&right);
        mus__drawing_add(drawing, legs[2 * d + 1], "", 0.0, &right);
    }
    mus__chain_line(&chain, at, end);
    mus__drawing_add(drawing, ndart > 0 ? edges[ndart] : label, label, allowance, &chain);
}


/* darts that were drawn are sewn */
static void torso_sew_darts(mus__half *half, int32_t panel)
{
    static const char *const legs[][2] = {{"wd1", "wd2"}, {"wd3", "wd4"}, {"bd1", "bd2"}};
    for (int i = 0; i < 3; i++) {
        const int32_t a = mus__board_find(&half->board, panel, legs[i][0]);
        const int32_t b = mus__board_find(&half->board, panel, legs[i][1]);
        if (a != MUS_NONE && b != MUS_NONE) mus__board_seam_add(&half->board, a, b, MUS_SEAM_REVERSED, 0.0);
    }
}


static void torso_draw(mus__half *half, mus__top *top, int32_t which)
{
    const bool front = which == MUS__TOP_FRONT;
    mus__drawing drawing = {.front = front, .n = 0};
    mus__chain chain;

    /* centre down, hem out, side up */
    mus__drawing side = {.front = front, .n = 0};
    torso_side(half, top, front, &side);
    const mus__chain *neck = &top->neck[which], *low = &side.edge[0].chain;
    const double *head = neck->xy + 2 * (neck->nxy - 1), foot[2] = {0.0, top->hem};
    mus__chain_line(&chain, head, foot);
    mus__drawing_add(&drawing, front ? "cf" : "cb", "centre", MUS__TOP_SEAM, &chain);
    torso_low(half, top, which, low->xy, &drawing);
    for (int32_t i = 0; i < side.n; i++) {
        const mus__drawing_edge *edge = &side.edge[i];
        mus__drawing_add(&drawing, edge->name, edge->label, edge->allowance, &edge->chain);
    }

    /* armhole, shoulder, neck */
    if (top->arm[which].npiece > 0)
        mus__drawing_add(&drawing, "arm", "armhole", MUS__TOP_SEAM, &top->arm[which]);
    if (top->shoulder[which]) {
        mus__chain_line(&chain, top->arm[which].xy + 2 * (top->arm[which].nxy - 1), neck->xy);
        mus__drawing_add(&drawing, "sh", "shoulder", MUS__TOP_SEAM, &chain);
    }
    mus__drawing_add(&drawing, "neck", top->rim[which], MUS__TOP_NECK_SEAM, neck);

    top->panel[which] = mus__drawing_lay(half, &drawing, front ? "front" : "back");
    torso_sew_darts(half, top->panel[which]);
    const int32_t arm = mus__board_find(&half->board, top->panel[which], "arm");
    const mus__bodice_half *block = front ? &half->bodice.front : &half->bodice.back;
    const double pitch = front ? block->arm_low_length : block->arm_length - block->arm_low_length;
    if (arm != MUS_NONE && top->shoulder[MUS__TOP_BACK])
        mus__board_notch_add(&half->board, arm, pitch, front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
}


/* sew what the rim of the fronts and of the backs has under one label */
static void torso_sew(mus__half *half, const char *label)
{
    int32_t front[MUS__TOP_RUN], back[MUS__TOP_RUN];
    const int32_t nfront = mus__half_rim(half, "front", label, front, MUS__TOP_RUN);
    const int32_t nback = mus__half_rim(half, "back", label, back, MUS__TOP_RUN);
    if (nfront > 0 && nback > 0) mus__board_sew(&half->board, nfront, front, nback, back);
}


static void torso_place(mus__half *half, const mus__top *top)
{
    const double width = half->bodice.front.under[0] + top->hip_out;
    for (int32_t p = 0; p < half->board.npanel; p++) {
        const mus__board_panel *panel = &half->board.panel[p];
        if (panel->first == MUS_NONE) continue;
        if (strncmp(panel->name, "front", 5) == 0) mus__panel_place_torso(half, p, true, width, half->waist_level);
        if (strncmp(panel->name, "back", 4) == 0) mus__panel_place_torso(half, p, false, width, half->waist_level);
    }
}


/* the ease that the waist line has become: shaping that is left out, or flare, makes it wider */
static void torso_waist(mus__half *half)
{
    int32_t sides[MUS__TOP_RUN];
    const int32_t n = mus__half_rim(half, "", "waist", sides, MUS__TOP_RUN);
    if (half->board.status != MUS_OK || n < 1 || n > MUS__TOP_RUN) return;
    double length = 0.0;
    for (int32_t i = 0; i < n; i++) length += half->board.side[sides[i]].length;
    half->waist_ease = 2.0 * length - half->measures.v[MUS_MEASURE_WAIST];
}


void mus__top_draft(mus__half *half)
{
    mus__top top;
    memset(&top, 0, sizeof top);
    if (half->board.status != MUS_OK) return;
    torso_blocks(half, &top);
    if (half->board.status != MUS_OK) return;
    torso_sides(half, &top);
    mus__neckline_draw(half, &top);
    if (half->board.status != MUS_OK) return;
    mus__shaping_plan(half, &top);
    for (int32_t which = 0; which < 2; which++) torso_draw(half, &top, which);
    mus__shaping_work(half, &top);
    if (mus__style_is(half, MUS__AXIS_YOKE, MUS__YOKE_YOKE)) mus__shaping_yoke(half, &top);
    mus__closure_set(half);
    torso_sew(half, "shoulder");
    torso_sew(half, "side");
    if (!top.shoulder[MUS__TOP_BACK] && top.shoulder[MUS__TOP_FRONT]) mus__neckline_strap(half);
    mus__neckline_hold(half);
    torso_place(half, &top);
    torso_waist(half);

    /* a step that finds no room says so by an argument that is out of range */
    if (half->board.status == MUS_ERR_ARG) half->board.status = MUS_ERR_DESIGN;
}
