/*
 * block_bodice.c: the bodice block: a front and a back half from neck to waist, darted for women, without darts for
 * men, children and knit tops.
 *
 * Back: neck, shoulder, armhole in two cubics that meet upright at the arm pitch, side, waist. Front the same, raised
 * and opened at the side by the bust dart about the bust point, so that the side seam is as long as the back's when the
 * dart is closed. The front neck depth is solved so that the whole neckline has the neck girth plus ease. A step that
 * cannot be drawn fails with a message that names its measures. Formulas: man page mus_design(3). Method: flat drafting
 * as in Aldrich, Metric Pattern Cutting; armhole by pitch points as in FreeSewing 4 (design brian).
 */
#include <math.h>
#include <string.h>

#include "block/block_bodice.h"
#include "base/elementary.h"
#include "geom/vec.h"

/* [m] distance of the sewn dart points of the front from the bust point; dressmaking practice is 2 to 3 cm */
#define POINT_BACK (2.0 * MUS__CM)


/* p rotated about o by angle a [rad] */
static void bodice_turn(const double *p, const double *o, double a, double *out)
{
    double c = mus__cos(a), s = mus__sin(a), x = p[0] - o[0], y = p[1] - o[1];
    out[0] = o[0] + c * x - s * y;
    out[1] = o[1] + s * x + c * y;
}


/* neck = [C, (h0 N.x, C.y), N - h1 depth (sin slope, cos slope), N],  C = (0, N.y - depth) */
static void bodice_neck(const mus__bodice_half *half, double depth, double *out)
{
    double centre[2] = {0.0, half->snp[1] - depth}, reach = half->hold[1] * depth;
    mus__cubic_set(out, centre, half->hold[0] * half->snp[0], centre[1], half->snp[0] - reach * mus__sin(half->slope),
                   half->snp[1] - reach * mus__cos(half->slope), half->snp);
}


static void bodice_set_neck(mus__bodice_half *half, double depth)
{
    bodice_neck(half, depth, half->neck);
    memcpy(half->centre, half->neck, sizeof half->centre);
    half->neck_length = mus__cubic_length(half->neck);
}


/* high: [T, T - hold L (sin slope, cos slope), P + (0, 0.35 L), P], L = T.y - P.y
 * low:  [P, P - (0, h (P.y - U.y)), U - h (U.x - P.x) (cos theta, sin theta), U] */
static void bodice_arm(mus__bodice_half *half, double hold, double low)
{
    const double *t = half->tip, *p = half->pitch, *u = half->under;
    double l = t[1] - p[1], reach = low * (u[0] - p[0]);
    mus__cubic_set(half->arm_high, t, t[0] - hold * l * mus__sin(half->slope), t[1] - hold * l * mus__cos(half->slope),
                   p[0], p[1] + 0.35 * l, p);
    mus__cubic_set(half->arm_low, p, p[0], p[1] - low * (p[1] - u[1]), u[0] - reach * mus__cos(half->theta),
                   u[1] - reach * mus__sin(half->theta), u);
    half->arm_low_length = mus__cubic_length(half->arm_low);
    half->arm_length = mus__cubic_length(half->arm_high) + half->arm_low_length;
}


static void bodice_dart(mus__bodice_half *half, double x, double width, double top)
{
    double *dart = half->dart[half->ndart++];
    dart[0] = x - 0.5 * width, dart[1] = 0.0;
    dart[2] = x, dart[3] = top;
    dart[4] = x + 0.5 * width, dart[5] = 0.0;
}


/* splits t, the difference of bust and waist in one half, into side shaping and waist dart. No dart is narrower than
 * 8 mm */
static void bodice_shaping(double t, bool darts, mus__bodice *out)
{
    out->side_in = 0.0, out->dart_width = 0.0;
    if (!darts) return;
    out->side_in = t < 0.0 ? t : fmin(0.35 * t, 2.5 * MUS__CM);
    out->dart_width = fmax(0.0, t - out->side_in);
    if (out->dart_width < 0.8 * MUS__CM) out->side_in = t, out->dart_width = 0.0;
}


static mus_status bodice_back(mus_context *context, const mus__measures *measures, double width, mus__bodice *out)
{
    const double *m = measures->v;
    mus__bodice_half *back = &out->back;
    double sh = m[MUS_MEASURE_SHOULDER], bwl = m[MUS_MEASURE_BACK_WAIST], bw = m[MUS_MEASURE_ACROSS_BACK];
    double nw = m[MUS_MEASURE_NECK] / 6.0 + 1.0 * MUS__CM, rise = 0.3 * nw, yu = out->underarm;

    /* neck and shoulder */
    back->slope = m[MUS_MEASURE_SHOULDER_SLOPE] - 2.0 * MUS__DEGREE;
    back->hold[0] = 0.62, back->hold[1] = 0.55;
    back->snp[0] = nw, back->snp[1] = bwl + rise;
    back->tip[0] = nw + sh * mus__cos(back->slope), back->tip[1] = back->snp[1] - sh * mus__sin(back->slope);
    bodice_set_neck(back, rise);

    /* armhole: the pitch half way up, not wider than the across back */
    back->under[0] = width, back->under[1] = yu;
    back->pitch[0] = fmin(fmin(bw / 2.0 + 0.4 * MUS__CM, width - 1.2 * MUS__CM), back->tip[0] - 0.5 * MUS__CM);
    back->pitch[1] = yu + 0.5 * (back->tip[1] - yu);
    if (yu < 1.0 * MUS__CM || back->tip[1] - yu < 3.0 * MUS__CM || back->pitch[0] < 0.5 * nw)
        return mus__fail(context, MUS_ERR_DESIGN,
                         "back armhole: scye_depth %d mm, back_waist %d mm, across_back %d mm leave no room for it",
                         mus__millimetres(m[MUS_MEASURE_SCYE_DEPTH]), mus__millimetres(bwl), mus__millimetres(bw));
    bodice_arm(back, 0.35, 0.62);

    /* side and waist, one dart or two 2 cm apart */
    double d = out->dart_width, centre = bw / 4.0 + 0.5 * MUS__CM, gap = d / 4.0 + 1.0 * MUS__CM;
    back->side[0] = width - out->side_in, back->side[1] = 0.0;
    if (d > 4.0 * MUS__CM) {
        bodice_dart(back, centre - gap, d / 2.0, yu - 2.0 * MUS__CM);
        bodice_dart(back, centre + gap, d / 2.0, yu - 4.5 * MUS__CM);
    } else if (d > 0.0) {
        bodice_dart(back, centre, d, yu - 2.0 * MUS__CM);
    }
    back->shoulder_length = mus__dist2(back->snp, back->tip);
    back->side_length = mus__dist2(back->under, back->side);
    back->waist_length = back->side[0] - d;
    return MUS_OK;
}


typedef struct bodice_neck_problem {
    const mus__bodice_half *half;
    double target;
} bodice_neck_problem;


static double bodice_neck_excess(const void *data, double depth)
{
    const bodice_neck_problem *problem = data;
    double neck[8];
    bodice_neck(problem->half, depth, neck);
    return mus__cubic_length(neck) - problem->target;
}


/* height of the front side neck and the bust point below it, then the angle of the bust dart:
 *   q = sqrt(bd^2 - (bs/2 - nw)^2),  D = tip of the front above the tip of the back less 0.7,  tan theta = D / reach */
static mus_status bodice_bust(mus_context *context, const mus__measures *measures, double width, bool darts,
                              mus__bodice *out)
{
    const double *m = measures->v;
    mus__bodice_half *front = &out->front;
    double bs2 = m[MUS_MEASURE_BUST_SPAN] / 2.0, bd = m[MUS_MEASURE_BUST_DEPTH], sh = m[MUS_MEASURE_SHOULDER];
    double nw = m[MUS_MEASURE_NECK] / 6.0 + 0.7 * MUS__CM, reach = width - bs2;
    double q2 = bd * bd - (bs2 - nw) * (bs2 - nw);
    if (q2 < 1e-4 || reach < 2.0 * MUS__CM)
        return mus__fail(context, MUS_ERR_DESIGN,
                         "bust point: bust_span %d mm and bust_depth %d mm do not fit bust %d mm",
                         mus__millimetres(2.0 * bs2), mus__millimetres(bd), mus__millimetres(m[MUS_MEASURE_BUST]));
    double q = sqrt(q2);

    /* the angle follows from a measured front waist length; else it is 1 degree for each centimetre of (bust -
     * underbust - 1 cm) */
    double drop = (m[MUS_MEASURE_BUST] - m[MUS_MEASURE_UNDERBUST]) / MUS__CM - 1.0;
    double cup = fmax(0.0, fmin(30.0, drop)) * MUS__DEGREE;
    front->slope = m[MUS_MEASURE_SHOULDER_SLOPE] + 2.0 * MUS__DEGREE;
    front->snp[0] = nw;
    if (!darts) {
        front->snp[1] = out->back.snp[1];
    } else if (measures->front_waist_given) {
        front->snp[1] = m[MUS_MEASURE_FRONT_WAIST] - bd + q;
    } else {
        front->snp[1] = out->back.tip[1] - 0.7 * MUS__CM + reach * mus__tan(cup) + sh * mus__sin(front->slope);
    }
    front->tip[0] = nw + sh * mus__cos(front->slope), front->tip[1] = front->snp[1] - sh * mus__sin(front->slope);
    front->bust[0] = bs2, front->bust[1] = front->snp[1] - q;
    out->front_waist = front->bust[1] + bd;

    if (!darts) return MUS_OK;
    out->dart_drop = fmax(0.0, front->tip[1] - out->back.tip[1] + 0.7 * MUS__CM);
    front->theta = fmin(mus__atan2(out->dart_drop, reach), 30.0 * MUS__DEGREE);
    if (front->theta < 2.0 * MUS__DEGREE) front->theta = 0.0;
    return MUS_OK;
}


/* side seam of the front with the bust dart open: its mouth at the height of the bust point, at least 3 cm below the
 * armhole */
static mus_status bodice_front_side(mus_context *context, const mus__measures *measures, double width, mus__bodice *out)
{
    mus__bodice_half *front = &out->front;
    double yu = out->underarm, closed[2] = {width, yu};
    front->side[0] = width - out->side_in, front->side[1] = 0.0;
    bodice_turn(closed, front->bust, front->theta, front->under);
    front->side_length = mus__dist2(closed, front->side);
    if (!(front->theta > 0.0)) return MUS_OK;

    double y = fmin(front->bust[1], yu - 3.0 * MUS__CM), part = y / yu;
    double lower[2] = {front->side[0] + (width - front->side[0]) * part, y}, upper[2];
    if (y < 1.0 * MUS__CM)
        return mus__fail(context, MUS_ERR_DESIGN, "bust dart: bust_depth %d mm puts the bust point below the waist",
                         mus__millimetres(measures->v[MUS_MEASURE_BUST_DEPTH]));
    bodice_turn(lower, front->bust, front->theta, upper);
    memcpy(front->mouth, upper, sizeof upper);
    memcpy(front->mouth + 2, lower, sizeof lower);

    /* the sewn point lies on the bisector, so that both legs have one length */
    double middle[2] = {0.5 * (upper[0] + lower[0]), 0.5 * (upper[1] + lower[1])};
    double back_off = fmin(POINT_BACK / mus__dist2(middle, front->bust), 0.6);
    for (int i = 0; i < 2; i++) front->apex[i] = front->bust[i] + back_off * (middle[i] - front->bust[i]);
    return MUS_OK;
}


static mus_status bodice_front(mus_context *context, const mus__measures *measures, const mus__bodice_def *def,
                               double width, mus__bodice *out)
{
    const double *m = measures->v;
    mus__bodice_half *front = &out->front;
    mus_status status = bodice_bust(context, measures, width, def->darts, out);
    if (status == MUS_OK) status = bodice_front_side(context, measures, width, out);
    if (status != MUS_OK) return status;

    /* neck depth: front neck + back neck = (neck + ease) / 2 */
    front->hold[0] = 0.60, front->hold[1] = 0.50;
    double half_neck = (m[MUS_MEASURE_NECK] + def->neck_ease) / 2.0;
    bodice_neck_problem problem = {front, half_neck - out->back.neck_length};
    if (!mus__solve(bodice_neck_excess, &problem, 0.3 * front->snp[0], 4.0 * front->snp[0], &out->neck_depth))
        return mus__fail(context, MUS_ERR_DESIGN, "front neck: neck %d mm cannot be reached from a back neck of %d mm",
                         mus__millimetres(m[MUS_MEASURE_NECK]), mus__millimetres(2.0 * out->back.neck_length));
    bodice_set_neck(front, out->neck_depth);

    /* armhole */
    const double *u = front->under, *t = front->tip;
    front->pitch[0] =
        fmin(fmin(m[MUS_MEASURE_ACROSS_FRONT] / 2.0 + 0.2 * MUS__CM, u[0] - 1.5 * MUS__CM), t[0] - 0.8 * MUS__CM);
    front->pitch[1] = u[1] + 0.42 * (t[1] - u[1]);
    if (t[1] - u[1] < 3.0 * MUS__CM || front->pitch[0] < 0.5 * front->snp[0])
        return mus__fail(context, MUS_ERR_DESIGN,
                         "front armhole: scye_depth %d mm, across_front %d mm, shoulder %d mm leave no room for it",
                         mus__millimetres(m[MUS_MEASURE_SCYE_DEPTH]), mus__millimetres(m[MUS_MEASURE_ACROSS_FRONT]),
                         mus__millimetres(m[MUS_MEASURE_SHOULDER]));
    bodice_arm(front, 0.40, 0.66);

    /* waist dart below the bust point */
    if (out->dart_width > 0.0) bodice_dart(front, front->bust[0], out->dart_width, front->bust[1] - POINT_BACK);
    front->shoulder_length = mus__dist2(front->snp, front->tip);
    front->waist_length = front->side[0] - out->dart_width;
    return MUS_OK;
}


/* darts must lie between the centre and the side, with their points below the neck */
static mus_status bodice_check_darts(mus_context *context, const mus__measures *measures, const mus__bodice_half *half)
{
    const double *last = half->ndart > 0 ? half->dart[half->ndart - 1] : NULL;
    bool fits = last == NULL || (half->dart[0][0] > 0.5 * MUS__CM && last[4] < half->side[0] - 0.5 * MUS__CM &&
                                 half->dart[0][3] > 2.0 * MUS__CM && last[3] > 2.0 * MUS__CM);
    if (fits && half->waist_length > 2.0 * MUS__CM) return MUS_OK;
    return mus__fail(context, MUS_ERR_DESIGN, "waist dart: bust %d mm and waist %d mm need one that leaves the half",
                     mus__millimetres(measures->v[MUS_MEASURE_BUST]), mus__millimetres(measures->v[MUS_MEASURE_WAIST]));
}


void mus__bodice_def_init(mus__bodice_def *def, const mus__measures *measures)
{
    double k = mus__measures_scale(measures);
    bool woman = measures->sex == MUS_SEX_FEMALE;
    def->bust_ease = (woman ? 6.0 : 12.0) * k * MUS__CM;
    def->waist_ease = 4.0 * k * MUS__CM;
    def->scye_ease = (woman ? 1.0 : 2.0) * k * MUS__CM;
    def->balance = 1.0 * MUS__CM;
    def->neck_ease = 1.0 * MUS__CM;
    def->darts = woman;
}


void mus__bodice_lower_neck(mus__bodice_half *half, double along, double drop)
{
    double centre = half->centre[1] - drop;
    half->snp[0] += along * mus__cos(half->slope);
    half->snp[1] -= along * mus__sin(half->slope);
    half->shoulder_length = mus__dist2(half->snp, half->tip);
    bodice_set_neck(half, fmax(half->snp[1] - centre, 0.5 * MUS__CM));
}


mus_status mus__bodice_draft(mus_context *context, const mus__measures *measures, const mus__bodice_def *def,
                             mus__bodice *out)
{
    const double *m = measures->v;
    memset(out, 0, sizeof *out);

    /* half widths on the bust line: back (B + ease)/4 - balance/2, front + balance/2 */
    double girth = m[MUS_MEASURE_BUST] + def->bust_ease;
    double back = girth / 4.0 - def->balance / 2.0, front = girth / 4.0 + def->balance / 2.0;
    out->underarm = m[MUS_MEASURE_BACK_WAIST] - (m[MUS_MEASURE_SCYE_DEPTH] + def->scye_ease);
    bodice_shaping((girth - m[MUS_MEASURE_WAIST] - def->waist_ease) / 4.0, def->darts, out);

    mus_status status = bodice_back(context, measures, back, out);
    if (status == MUS_OK) status = bodice_front(context, measures, def, front, out);
    if (status == MUS_OK) status = bodice_check_darts(context, measures, &out->back);
    if (status == MUS_OK) status = bodice_check_darts(context, measures, &out->front);
    return status;
}
