/*
 * neckline.c: armhole, shoulder and the ten necklines of a front or back.
 *
 * Each neckline moves the side neck along the shoulder (as much in front as behind, so that shoulders match), lowers
 * the centres, and draws its own front edge; behind it stays one curve. Where nothing opens, the neckline is lowered on
 * until the head passes. A deep neckline of a darted woven top is first tightened: a wedge at its edge is closed about
 * the bust point, and the bust dart opens by its angle. Widths and depths: man page mus_design(3); chosen.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "style/bodice.h"

#define JERSEY_STRETCH 1.15 /* length of a stretched knit neckline over that at rest; chosen: more needs less width */
#define HEAD_STEPS 60

/* figures of a neckline [cm] on an adult; chosen */
typedef struct neckline_row {
    double along, front, back; /* side neck point along the shoulder; centre front and back lower by */
    double wedge;              /* width of the wedge that is closed about the bust point */
} neckline_row;

static const neckline_row neckline_rows[] = {
    {0.0, 0.0, 0.0, 0.0},  /* jewel */
    {3.0, 7.0, 1.5, 0.0},  /* scoop */
    {1.0, 12.0, 0.5, 0.8}, /* v */
    {1.5, 0.0, 0.5, 1.0},  /* deep_v: to 1 cm above the bust level */
    {3.0, 8.0, 3.0, 0.0},  /* square */
    {0.0, -3.5, 1.5, 0.0}, /* boat: along by 0.6 of the shoulder */
    {3.0, 0.0, 2.0, 1.0},  /* sweetheart: 3 cm above the bust level */
    {0.0, 0.0, 0.0, 0.0},  /* keyhole */
    {1.0, 3.0, 0.0, 0.8},  /* halter */
    {0.0, 0.0, 0.0, 1.75}, /* strapless */
};


/* ---- contour ---- */

/* closes a wedge of `width` at the neck about the bust point: the part above the bust dart turns towards the centre,
 * and the bust dart opens by that angle */
static void neckline_contour(mus__bodice_half *front, double width)
{
    if (!(front->theta > 0.0)) return;
    const double middle[2] = {0.5 * front->snp[0], 0.5 * (front->snp[1] + front->centre[1])};
    const double angle = fmin(width / fmax(mus__dist2(middle, front->bust), 0.05), 35.0 * MUS__DEGREE - front->theta);
    if (!(angle > 0.0)) return;
    double *points[] = {front->snp, front->tip, front->pitch, front->under, front->mouth};
    const size_t n = sizeof points / sizeof points[0];
    for (size_t i = 0; i < n; i++) mus__top_turn(points[i], front->bust, angle, points[i]);
    for (int i = 0; i < 4; i++) {
        mus__top_turn(front->arm_high + 2 * i, front->bust, angle, front->arm_high + 2 * i);
        mus__top_turn(front->arm_low + 2 * i, front->bust, angle, front->arm_low + 2 * i);
    }
    front->theta += angle;
    front->slope -= angle;
    mus__bodice_lower_neck(front, 0.0, 0.0);
}


/* ---- front edges, drawn from the centre C to the side neck S ---- */

/* [C, C + 0.33 (S - C) + (0.4, -0.2), C + 0.66 (S - C) + (0.6, -0.2), S] */
static void neckline_v(const double *c, const double *s, double cm, mus__chain *out)
{
    const double dx = s[0] - c[0], dy = s[1] - c[1];
    mus__chain_add_cubic(out, c, c[0] + 0.33 * dx + 0.4 * cm, c[1] + 0.33 * dy - 0.2 * cm, c[0] + 0.66 * dx + 0.6 * cm,
                   c[1] + 0.66 * dy - 0.2 * cm, s);
}


/* the cup: [C, (0.2, C.y + 3), (0.35 bs, Q.y + 0.8), Q] */
static void neckline_cup(const double *c, const double *q, double cm, mus__chain *out)
{
    mus__chain_add_cubic(out, c, 0.2 * cm, fmin(c[1] + 3.0 * cm, q[1]), 0.7 * q[0], q[1] + 0.8 * cm, q);
}


/* a drop 9 long and 3 wide below a jewel neck, its edges 3 mm apart above, where a button closes it */
static void neckline_keyhole(const mus__bodice_half *front, double cm, mus__chain *out)
{
    const double y = front->centre[1], foot[2] = {0.0, y - 9.0 * cm}, wide[2] = {1.5 * cm, y - 6.5 * cm};
    const double *neck = front->neck, head[2] = {0.15 * MUS__CM, y};
    mus__chain_add_cubic(out, foot, 0.8 * cm, foot[1], wide[0], y - 8.2 * cm, wide);
    mus__chain_add_cubic(out, wide, wide[0], y - 4.5 * cm, head[0], y - 4.0 * cm, head);
    mus__chain_add_cubic(out, head, neck[2], neck[3], neck[4], neck[5], front->snp);
}


static void neckline_front(const mus__half *half, const mus__top *top, mus__chain *out)
{
    const mus__bodice_half *front = &half->bodice.front;
    const double *s = front->snp, *c = front->centre, cm = top->scale * MUS__CM, slope = front->slope;
    const double q[2] = {front->bust[0], front->bust[1] + 6.5 * cm};
    out->npiece = 0;
    switch (half->style.option[MUS__AXIS_NECK]) {
    case MUS__NECK_SCOOP: {
        const double reach = 0.45 * (s[1] - c[1]);
        mus__chain_add_cubic(out, c, 0.72 * s[0], c[1], s[0] - reach * mus__sin(slope), s[1] - reach * mus__cos(slope),
                             s);
        break;
    }
    case MUS__NECK_V:
    case MUS__NECK_DEEP_V: neckline_v(c, s, cm, out); break;
    case MUS__NECK_SQUARE: {
        const double corner[2] = {s[0] - 0.5 * cm, c[1]};
        mus__chain_add_line(out, c, corner);
        mus__chain_add_line(out, corner, s);
        break;
    }
    case MUS__NECK_BOAT: mus__chain_add_cubic(out, c, 0.5 * s[0], c[1], s[0] - 3.0 * cm, s[1] + 0.2 * cm, s); break;
    case MUS__NECK_SWEETHEART:
        neckline_cup(c, q, cm, out);
        mus__chain_add_line(out, q, s);
        break;
    case MUS__NECK_KEYHOLE: neckline_keyhole(front, cm, out); break;
    default: mus__chain_cubic(out, front->neck); break;
    }
}


/* ---- armhole ---- */

static void neckline_arm(const mus__half *half, mus__top *top, int32_t which)
{
    const bool front = which == MUS__TOP_FRONT;
    const mus__bodice_half *block = front ? &half->bodice.front : &half->bodice.back;
    mus__chain *arm = &top->arm[which], low;
    double closed[2];
    mus__top_under(half, top, front, closed, arm->xy);
    const double under[2] = {arm->xy[0], arm->xy[1]};
    mus__chain_cubic(arm, block->arm_high);
    mus__chain_cubic(&low, block->arm_low);
    mus__chain_append(arm, &low);
    mus__chain_reverse(arm);
    memcpy(arm->xy, under, sizeof under);
    top->shoulder[which] = true;
}


/* ---- the two without a back shoulder ---- */

/* front: from the underarm to the strap, which is 3 cm of the shoulder; behind a straight edge below the underarm */
static void neckline_halter(mus__half *half, mus__top *top)
{
    mus__bodice_half *front = &half->bodice.front, *back = &half->bodice.back;
    const double cm = top->scale * MUS__CM;
    const double width = fmin(3.0 * cm, 0.5 * front->shoulder_length), *s = front->snp;
    double closed[2], u[2];
    front->tip[0] = s[0] + width * mus__cos(front->slope), front->tip[1] = s[1] - width * mus__sin(front->slope);
    const double *t = front->tip;
    mus__top_under(half, top, true, closed, u);
    top->arm[MUS__TOP_FRONT].npiece = 0;
    const double hollow = fmax(u[0] - 5.0 * cm, t[0]);
    mus__chain_add_cubic(&top->arm[MUS__TOP_FRONT], u, hollow, u[1] + 3.0 * cm, t[0], t[1] - 5.0 * cm, t);
    top->shoulder[MUS__TOP_FRONT] = true;
    neckline_front(half, top, &top->neck[MUS__TOP_FRONT]);
    mus__chain_reverse(&top->neck[MUS__TOP_FRONT]);

    /* back: rises 0.5 cm from the centre to the side */
    mus__top_under(half, top, false, closed, u);
    const double c[2] = {0.0, u[1] - 0.5 * cm};
    mus__chain *neck = &top->neck[MUS__TOP_BACK];
    neck->npiece = 0;
    mus__chain_add_cubic(neck, u, 0.66 * u[0], c[1], 0.33 * u[0], c[1], c);
    top->arm[MUS__TOP_BACK].npiece = 0;
    top->neck_label[MUS__TOP_BACK] = "armhole";
    memcpy(back->centre, c, sizeof c);
}


/* front: cup from 4 cm above the bust level, over a point above the bust point, down to the underarm */
static void neckline_strapless(mus__half *half, mus__top *top)
{
    const mus__bodice_half *front = &half->bodice.front;
    const double cm = top->scale * MUS__CM, c[2] = {0.0, front->bust[1] + 4.0 * cm};
    double closed[2], u[2];
    mus__top_under(half, top, true, closed, u);
    const double q[2] = {front->bust[0], fmax(front->bust[1] + 7.5 * cm, u[1] + 1.0 * cm)};
    mus__chain *neck = &top->neck[MUS__TOP_FRONT];
    neck->npiece = 0;
    neckline_cup(c, q, cm, neck);
    mus__chain_add_cubic(neck, q, q[0] + 0.35 * (u[0] - q[0]), q[1] - 0.4 * cm, q[0] + 0.7 * (u[0] - q[0]),
                   u[1] + 0.25 * (q[1] - u[1]), u);
    mus__chain_reverse(neck);

    mus__top_under(half, top, false, closed, u);
    const double b[2] = {0.0, u[1] - 1.0 * cm};
    neck = &top->neck[MUS__TOP_BACK];
    neck->npiece = 0;
    mus__chain_add_cubic(neck, u, 0.66 * u[0], b[1], 0.33 * u[0], b[1], b);
    for (int which = 0; which < 2; which++) top->arm[which].npiece = 0;
}


/* ---- all of it ---- */

/* moves side neck points and centres by the row of the style */
static void neckline_move(mus__half *half, const mus__top *top, bool closed)
{
    const int32_t style = half->style.option[MUS__AXIS_NECK];
    const double cm = top->scale * MUS__CM;
    mus__bodice_half *front = &half->bodice.front, *back = &half->bodice.back;
    neckline_row row = neckline_rows[style];
    if (mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_WOVEN)) neckline_contour(front, row.wedge * cm);

    /* a jewel neck that nothing opens begins lower */
    if (closed && (style == MUS__NECK_JEWEL || style == MUS__NECK_KEYHOLE)) {
        row.along = 1.5, row.front = 2.0, row.back = 1.5;
    }
    double along = fmin(row.along * cm, 0.5 * front->shoulder_length), lower = row.front * cm;
    const double bust = fmin(front->bust[1], half->bodice.underarm);
    if (style == MUS__NECK_DEEP_V) lower = front->centre[1] - (bust + 1.0 * cm);
    if (style == MUS__NECK_SWEETHEART) lower = front->centre[1] - (bust + 3.0 * cm);
    if (style == MUS__NECK_BOAT) along = 0.6 * front->shoulder_length;
    if (style == MUS__NECK_V) lower = fmin(lower, front->centre[1] - (bust + 1.0 * cm));
    mus__bodice_lower_neck(front, along, lower);
    mus__bodice_lower_neck(back, along, row.back * cm);

    /* a boat's side neck lies 0.5 lower, its centre 1 cm below that at least */
    if (style != MUS__NECK_BOAT) return;
    const double down = fmax(0.0, 1.0 * cm - (front->snp[1] - front->centre[1]));
    mus__bodice_lower_neck(front, 0.0, down);
}


static void neckline_edges(mus__half *half, mus__top *top)
{
    neckline_front(half, top, &top->neck[MUS__TOP_FRONT]);
    mus__chain_reverse(&top->neck[MUS__TOP_FRONT]);
    mus__chain_cubic(&top->neck[MUS__TOP_BACK], half->bodice.back.neck);
    mus__chain_reverse(&top->neck[MUS__TOP_BACK]);
}


/* lowers the neckline until the head passes */
static void neckline_pass(mus__half *half, mus__top *top)
{
    const double *m = half->measures.v, need = m[MUS_MEASURE_HEAD] + 2.0 * MUS__CM;
    const double stretch = mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_KNIT) ? JERSEY_STRETCH : 1.0;
    mus__bodice_half *front = &half->bodice.front, *back = &half->bodice.back;
    for (int i = 0; i < HEAD_STEPS; i++) {
        const double girth = 2.0 * (mus__chain_length(&top->neck[0]) + mus__chain_length(&top->neck[1]));
        if (girth * stretch >= need) return;
        const bool wide = front->shoulder_length < 0.45 * m[MUS_MEASURE_SHOULDER];
        const double out = wide ? 0.0 : fmin(0.2 * MUS__CM, 0.05 * front->shoulder_length);
        mus__bodice_lower_neck(front, out, 0.3 * MUS__CM);
        mus__bodice_lower_neck(back, out, 0.1 * MUS__CM);
        neckline_edges(half, top);
    }
    mus__board_fail(&half->board, MUS_ERR_DESIGN,
                    "neckline: head %d mm does not pass neck %d mm, opened as far as it goes",
                    mus__millimetres(m[MUS_MEASURE_HEAD]), mus__millimetres(m[MUS_MEASURE_NECK]));
}


void mus__neckline_draw(mus__half *half, mus__top *top)
{
    const int32_t closure = half->style.option[MUS__AXIS_CLOSURE];
    const bool closed = closure == MUS__CLOSURE_NONE || closure == MUS__CLOSURE_SIDE;
    const bool halter = mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_HALTER);
    const bool strapless = mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_STRAPLESS);
    top->neck_label[0] = top->neck_label[1] = "neck";
    top->low = halter ? 1.5 * top->scale * MUS__CM : strapless ? 1.0 * top->scale * MUS__CM : 0.0;
    if (strapless) {
        if (mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_WOVEN))
            neckline_contour(&half->bodice.front, neckline_rows[MUS__NECK_STRAPLESS].wedge * top->scale * MUS__CM);
        neckline_strapless(half, top);
        return;
    }
    neckline_move(half, top, closed);
    if (halter) {
        neckline_halter(half, top);
        return;
    }
    neckline_edges(half, top);
    if (closed) neckline_pass(half, top);
    for (int32_t which = 0; which < 2; which++) neckline_arm(half, top, which);
}


/* attaches the upper edge of a strapless top, which is boned, at 5 mm below its drawn height. The back of a halter gets
 * an elastic in its upper edge */
void mus__neckline_hold(mus__half *half)
{
    mus__board *board = &half->board;
    int32_t sides[MUS__TOP_RUN];
    const bool halter = mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_HALTER);
    if (!halter && !mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_STRAPLESS)) return;
    const int32_t n = mus__half_boundary(half, halter ? "back" : "", halter ? "armhole" : "neck", sides, MUS__TOP_RUN);
    for (int32_t i = 0; i < n && i < MUS__TOP_RUN; i++) {
        const double *start = mus__board_start(board, sides[i]), *end = mus__board_end(board, sides[i]);
        const double level = half->waist_level + fmin(start[1], end[1]);
        mus__edge_attributes *stay = &board->side[sides[i]].attr;
        stay->hold = MUS_HOLD_ARMPIT;
        stay->below = fmax(0.0, half->skeleton.armpit - level) + 0.005;
        if (halter) stay->ratio = 0.94, stay->stiffness = 60.0;
    }
}


/* the strap round the back of the neck, as long as half the neckline: x = 0 at the centre back, x < 0 to the left */
void mus__neckline_strap(mus__half *half)
{
    mus__board *board = &half->board;
    int32_t shoulder[MUS__TOP_RUN];
    if (mus__half_boundary(half, "front", "shoulder", shoulder, MUS__TOP_RUN) < 1) return;
    const double width = board->side[shoulder[0]].length, length = half->bodice.back.neck_length;
    const double corner[4][2] = {{-length, 0.0}, {0.0, 0.0}, {0.0, width}, {-length, width}};
    static const char *const names[4][2] = {
        {"edge", "armhole"}, {"cb", "centre"}, {"neck", "neck"}, {"sh", "shoulder"}};
    const int32_t panel = mus__board_panel_add(board, "strap", "strap");
    int32_t side[4];
    for (int i = 0; i < 4; i++) {
        side[i] = mus__board_line_add(board, panel, names[i][0], names[i][1], corner[i], corner[(i + 1) % 4]);
        if (side[i] != MUS_NONE) board->side[side[i]].attr.allowance = i == 1 ? 0.0 : MUS__TOP_NECK_SEAM;
    }
    mus__board_panel_close(board, panel);
    if (board->status != MUS_OK) return;
    board->side[side[1]].centre = MUS__CENTRE_FOLD;
    mus__half_cut(half, panel, 2, MUS_MATERIAL_INTERFACING, 0);
    mus__board_seam_add(board, shoulder[0], side[3], MUS_SEAM_REVERSED, 0.0);
    mus__panel_place_ring(half, panel, false, half->measures.v[MUS_MEASURE_NECK], half->skeleton.nape);
}
