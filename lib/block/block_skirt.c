/*
 * block_skirt.c: the straight skirt: front and back halves from the top edge over the hip to the hem, with
 * the difference of waist and hip taken up by the side seam and one or two darts, or by the side seam alone.
 *
 * The waist edge is a cubic that rises to the side; its width is solved so that its length is the waist with the darts
 * open. Front and back differ by half a centimetre either way, with equal side seams by construction. The hem of
 * a flared skirt rises at the side and meets the side seam at a right angle. Formulas: man page mus_design(3). Method:
 * flat drafting as in Aldrich, Metric Pattern Cutting for Women's Wear (straight skirt block).
 */
#include <math.h>
#include <string.h>

#include "block/block_skirt.h"
#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"

typedef struct skirt_waist_problem {
    double rise, tilt, target;
} skirt_waist_problem;


/* [(0, 0), (0.4 x, 0), (x - .33 x cos tilt, rise - .33 x sin tilt), (x, rise)] */
static void skirt_waist(const skirt_waist_problem *problem, double x, double *out)
{
    double centre[2] = {0.0, 0.0}, side[2] = {x, problem->rise}, reach = 0.33 * x;
    mus__cubic_set(out, centre, 0.4 * x, 0.0, x - reach * mus__cos(problem->tilt),
                   problem->rise - reach * mus__sin(problem->tilt), side);
}


static double skirt_waist_excess(const void *data, double x)
{
    const skirt_waist_problem *problem = data;
    double waist[8];
    skirt_waist(problem, x, waist);
    return mus__cubic_length(waist) - problem->target;
}


/* next dart: a mouth of `width` about arc length `middle` of the waist edge, point on the perpendicular of the mouth,
 * legs of `leg`, which must be longer than the mouth is wide */
static mus_status skirt_dart(mus_context *context, mus__skirt_half *half, double middle, double width, double leg)
{
    double *dart = half->dart[half->ndart], *s = half->dart_s[half->ndart];
    s[0] = middle - 0.5 * width, s[1] = middle + 0.5 * width;
    mus__curve_at(MUS__CUBIC, half->waist, mus__curve_param(MUS__CUBIC, half->waist, s[0]), dart);
    mus__curve_at(MUS__CUBIC, half->waist, mus__curve_param(MUS__CUBIC, half->waist, s[1]), dart + 4);

    double x = dart[4] - dart[0], y = dart[5] - dart[1], chord = sqrt(x * x + y * y);
    if (!(leg > chord))
        return mus__fail(context, MUS_ERR_DESIGN,
                         "skirt dart: %d mm wide, more than its length of %d mm (hip, waist, ease)",
                         mus__millimetres(width), mus__millimetres(leg));
    double height = sqrt(leg * leg - 0.25 * chord * chord);
    dart[2] = 0.5 * (dart[0] + dart[4]) + height * y / chord;
    dart[3] = 0.5 * (dart[1] + dart[5]) - height * x / chord;
    half->ndart++;
    return MUS_OK;
}


/* one dart in the middle of the sewn waist, or two at 0.36 and 0.70 of it. When the place of the first dart is given,
 * the second lies half way between it and the side */
static mus_status skirt_darts(mus_context *context, const mus__skirt_def *def, bool front, double net,
                              mus__skirt_half *half)
{
    const double d = half->dart_width;
    const double long_leg = (front ? 0.50 : 0.68) * def->depth, short_leg = (front ? 0.45 : 0.60) * def->depth;
    if (!(d > 0.0)) return MUS_OK;
    const double given = def->dart_at[front ? 0 : 1];
    if (d <= (front ? 3.2 : 2.8) * MUS__CM)
        return skirt_dart(context, half, (given > 0.0 ? given : 0.5 * net) + 0.5 * d, d, long_leg);
    const double first = given > 0.0 ? given : 0.36 * net, second = given > 0.0 ? 0.5 * (given + net) : 0.70 * net;
    mus_status status = skirt_dart(context, half, first + 0.25 * d, 0.5 * d, long_leg);
    if (status == MUS_OK) status = skirt_dart(context, half, second + 0.75 * d, 0.5 * d, short_leg);
    return status;
}


/* splits t, the difference of hip and waist in one half, into the part of the side (returned) and that of the darts.
 * The side takes all of it when the darts would be narrower than 1 cm */
static double skirt_side_in(const mus__skirt_def *def, double t, mus__skirt_half *half)
{
    half->dart_width = 0.0;
    if (!def->darts || t <= 1.5 * MUS__CM) return t;
    double side = fmin(fmax(0.45 * t, t - 8.0 * MUS__CM), 5.0 * MUS__CM);
    if (t - side < 1.0 * MUS__CM) return t;
    half->dart_width = t - side;
    return side;
}


/* mean width of a half at the hip level, for the larger of hip and 0.98 waist */
static double skirt_hip(const mus__skirt_def *def)
{
    return (fmax(def->hip, 0.98 * def->waist) + def->hip_ease) / 4.0;
}


/* side [(x, r), (x + .45 (hip - x), r - .30 depth), (hip, -.55 depth), (hip, -depth)], below it straight or flared */
static void skirt_side(const mus__skirt_def *def, mus__skirt_half *half)
{
    const double *top = half->waist + 6;
    double hip[2] = {half->hip, -def->depth}, below = def->length - def->depth;
    mus__cubic_set(half->side_high, top, top[0] + 0.45 * (half->hip - top[0]), top[1] - 0.30 * def->depth, half->hip,
                   -0.55 * def->depth, hip);

    /* flare: the last handle gives the angle at the hem; the hem rises by 0.6 of a full cone's rise, front and back
     * alike */
    double mean = skirt_hip(def), tilt = mus__atan2(def->flare, below),
           rise = 0.6 * (mean + def->flare) * mus__tan(0.5 * tilt);
    double hem[2] = {half->hip + def->flare, -def->length + rise};
    mus__cubic_set(half->side_low, hip, half->hip, -def->depth - 0.25 * below,
                   hem[0] - 0.4 * (below - rise) * mus__tan(tilt), hem[1] + 0.4 * (below - rise), hem);

    double centre[2] = {0.0, -def->length}, reach = 0.3 * hem[0];
    mus__cubic_set(half->hem, centre, 0.5 * hem[0], centre[1], hem[0] - reach * mus__cos(tilt),
                   hem[1] - reach * mus__sin(tilt), hem);
    half->hem_width = hem[0];
    half->side_high_length = mus__cubic_length(half->side_high);
    half->side_length = half->side_high_length + mus__cubic_length(half->side_low);
}


static mus_status skirt_half(mus_context *context, const mus__skirt_def *def, bool front, mus__skirt_half *half)
{
    /* the front half is 5 mm and def->shift wider than the mean, the back half narrower, at waist and hip alike:
     * both side seams are then taken in by one amount and have one length */
    double shift = front ? 0.5 * MUS__CM + def->shift : -0.5 * MUS__CM - def->shift;
    double net = (def->waist + def->waist_ease) / 4.0 + shift;
    half->hip = skirt_hip(def) + shift;
    double side = skirt_side_in(def, half->hip - net, half);

    /* waist edge */
    double d = half->dart_width;
    skirt_waist_problem problem = {side > 0.5 * MUS__CM ? def->rise : 0.3 * MUS__CM,
                                   0.6 * mus__atan2(fmax(side, 0.0), def->depth) + 0.02, net + d};
    double x;
    if (!mus__solve(skirt_waist_excess, &problem, 0.5 * net, 1.5 * (net + d) + 1.0 * MUS__CM, &x))
        return mus__fail(context, MUS_ERR_DESIGN, "skirt waist: waist %d mm cannot be drawn with a rise of %d mm",
                         mus__millimetres(def->waist), mus__millimetres(problem.rise));
    skirt_waist(&problem, x, half->waist);
    half->waist_length = mus__cubic_length(half->waist) - d;

    skirt_side(def, half);
    return skirt_darts(context, def, front, net, half);
}


mus_status mus__skirt_draft(mus_context *context, const mus__skirt_def *def, mus__skirt *out)
{
    memset(out, 0, sizeof *out);
    if (def->depth < 1.0 * MUS__CM || def->length < def->depth + 2.0 * MUS__CM)
        return mus__fail(context, MUS_ERR_DESIGN,
                         "skirt: length %d mm does not reach below the hip (waist_to_hip, %d mm down)",
                         mus__millimetres(def->length), mus__millimetres(def->depth));
    if (def->hip + def->hip_ease < 0.1 || def->waist + def->waist_ease < 0.1)
        return mus__fail(context, MUS_ERR_DESIGN, "skirt: ease %d mm on hip %d mm leaves nothing to wear",
                         mus__millimetres(def->hip_ease), mus__millimetres(def->hip));
    mus_status status = skirt_half(context, def, true, &out->front);
    if (status == MUS_OK) status = skirt_half(context, def, false, &out->back);
    if (status == MUS_OK && out->back.hip + def->flare < 2.0 * MUS__CM)
        return mus__fail(context, MUS_ERR_DESIGN, "skirt: flare %d mm leaves no hem", mus__millimetres(def->flare));
    return status;
}
