/*
 * block_trousers.c: front and back of one trouser leg from the top edge over hip and crotch line to the hem.
 *
 *        centre ___ side        The front is drawn first. The back's fork is lowered until its inseam is as long as the
 *       (hip)  |   \            front's, its side at the waist is lifted until its outseam is as long as the front's,
 *       fork __|    | hip       with the waist at its exact length. So seams match by construction. A leg that is
 *            \      |           cut above the hem is cut at a level of the front and at the same arc lengths of the
 *      knee   |    |            back. Formulas: man page mus_design(3). Method: FreeSewing 4 (titan).
 *       hem   |____|
 *
 * A yoke (Aldrich, Metric Pattern Cutting for Women's Wear, 2008: jeans) is the back above a line from the centre to
 * the outseam, on which its darts end. They are closed, and the yoke's lower edge is drawn as one curve; the darts end
 * as far above the line, or below it, as makes the curve as long as the line. Then the front has no dart: its centre
 * and its side take the waist in.
 */
#include <math.h>
#include <string.h>

#include "block/block_trousers.h"
#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"

#define BACK_TILT 0.19438030913771848 /* tan 11 degrees: of the centre back line */
#define KNEE_PART 0.44                /* knee below the crotch line as a part of the inleg */
#define YOKE_CENTRE (7.0 * MUS__CM)   /* [m] height of a yoke at the centre, as the trade's jeans have; chosen */
#define YOKE_SIDE (4.0 * MUS__CM)     /* [m] and at the side */
#define YOKE_PART 0.45 /* of the height from hip line to top edge that a yoke takes at most; chosen: pockets go below  \
                        */
#define YOKE_LEAST (0.3 * MUS__CM) /* [m] dart that is closed into a yoke at least; chosen: less is lost in sewing */
#define YOKE_FRONT_CENTRE (1.2 * MUS__CM) /* [m] the centre front of jeans comes in at the waist, at most; chosen */

typedef struct leg_problem {
    double fork[2], knee[2], hem[2]; /* inseam: fork (x), knee, hem */
    double side[2], hip[2], out_knee[2], out_hem[2];
    double target;
} leg_problem;


void mus__trousers_widths(mus__trousers_def *def, double knee, double hem)
{
    def->knee[0] = 0.5 * knee - 1.0 * MUS__CM, def->knee[1] = 0.5 * knee + 1.0 * MUS__CM;
    def->hem[0] = 0.5 * hem - 1.0 * MUS__CM, def->hem[1] = 0.5 * hem + 1.0 * MUS__CM;
}


/* inseam [F, (F.x + a (K.x - F.x), F.y - b (F.y - K.y)), (K.x, K.y + .40 (F.y - K.y)), K], then straight to the hem:
 * a, b are .35, .22 in front and .40, .20 behind. For a leg that is no narrower below (culottes) this is a line */
static void leg_inseam(const leg_problem *problem, double fork_y, double a, double b, mus__chain *out)
{
    const double start[2] = {problem->fork[0], fork_y}, *knee = problem->knee, drop = fork_y - knee[1];
    out->npiece = 0;
    mus__chain_add_cubic(out, start, start[0] + a * (knee[0] - start[0]), start[1] - b * drop, knee[0],
                         knee[1] + 0.40 * drop, knee);
    mus__chain_add_line(out, knee, problem->hem);
}


static double leg_inseam_excess(const void *data, double fork_y)
{
    const leg_problem *problem = data;
    mus__chain inseam;
    leg_inseam(problem, fork_y, 0.40, 0.20, &inseam);
    return mus__chain_length(&inseam) - problem->target;
}


/* outseam from (x, y) over the hip (H.x, H.y) to the knee (K.x, K.y) and the hem:
 * [(x, y), (x + .55 (H.x - x), y - .35 (y - H.y)), (H.x, H.y + .4 (y - H.y)), H],
 * [H, (H.x, H.y - .30 (H.y - K.y)), (K.x, K.y + .40 (H.y - K.y)), K] */
static void leg_outseam(const leg_problem *problem, const double *side, mus__chain *out)
{
    const double *hip = problem->hip, *knee = problem->out_knee, high = side[1] - hip[1], low = hip[1] - knee[1];
    out->npiece = 0;
    mus__chain_add_cubic(out, side, side[0] + 0.55 * (hip[0] - side[0]), side[1] - 0.35 * high, hip[0],
                         hip[1] + 0.40 * high, hip);
    mus__chain_add_cubic(out, hip, hip[0], hip[1] - 0.30 * low, knee[0], knee[1] + 0.40 * low, knee);
    mus__chain_add_line(out, knee, problem->out_hem);
}


static double leg_outseam_excess(const void *data, double y)
{
    const leg_problem *problem = data;
    const double side[2] = {problem->side[0], y};
    mus__chain outseam;
    leg_outseam(problem, side, &outseam);
    return mus__chain_length(&outseam) - problem->target;
}


/* splits t into the part of the side, at most `part` of it and `most`, and that of the darts, if they are 0.8 cm wide
 * or more; those of a yoke may be narrower */
static double leg_side_in(const mus__trousers_def *def, double t, double part, double most, mus__trousers_half *half)
{
    half->dart_width = 0.0;
    if (!def->darts || t < (def->yoke ? YOKE_LEAST : 1.5 * MUS__CM)) return t;
    const double side = fmin(part * t, most);
    if (t - side < (def->yoke ? YOKE_LEAST : 0.8 * MUS__CM)) return t;
    half->dart_width = t - side;
    return side;
}


/* the darts of a half: middles of the mouths along the straight waist line from the centre, their length, and the
 * length of the waist with the darts closed */
typedef struct leg_darts {
    const mus__trousers_half *half;
    int32_t n;
    double at[MUS__DARTS], length[MUS__DARTS], net;
} leg_darts;


/* the trued waist whose darts are `width` wide together on the straight line; returns its length with them closed */
static double leg_waist(const leg_darts *darts, double width, mus__waist *waist)
{
    const double *centre = darts->half->centre, *side = darts->half->side, chord = mus__dist2(centre, side);
    const double x = (side[0] - centre[0]) / chord, y = (side[1] - centre[1]) / chord, w = 0.5 * width / darts->n;
    waist->ndart = darts->n;
    for (int i = 0; i < 2; i++) {
        waist->end[0][i] = centre[i], waist->end[1][i] = side[i];
        waist->along[0][i] = waist->along[1][i] = i == 0 ? x : y;
    }
    for (int32_t d = 0; d < darts->n; d++) {
        double *dart = waist->dart[d];
        const double at = darts->at[d];
        dart[0] = centre[0] + x * (at - w), dart[1] = centre[1] + y * (at - w);
        dart[2] = centre[0] + x * at + y * darts->length[d], dart[3] = centre[1] + y * at - x * darts->length[d];
        dart[4] = centre[0] + x * (at + w), dart[5] = centre[1] + y * (at + w);
    }
    return mus__waist_true(waist);
}


static double leg_waist_excess(const void *data, double width)
{
    const leg_darts *darts = data;
    mus__waist waist;
    return leg_waist(darts, width, &waist) - darts->net;
}


/* the trued waist whose darts are as wide as its exact length asks for */
static bool leg_dart_close(const mus__trousers_half *half, const leg_darts *darts, mus__waist *waist)
{
    const double most = half->dart_width, each = most / darts->n, chord = mus__dist2(half->centre, half->side);
    double width;
    if (darts->at[0] - 0.5 * each < 0.0 || darts->at[darts->n - 1] + 0.5 * each > chord) return false;
    for (int32_t d = 0; d < darts->n; d++)
        if (darts->length[d] < each) return false;
    if (!mus__solve(leg_waist_excess, darts, 0.5 * most, most, &width)) return false;
    leg_waist(darts, width, waist);
    return true;
}


/* draws the darts and the waist with its exact length: truing shortens the line, so the darts become narrower than
 * half->dart_width. A dart that would be wider than long, or beyond the waist, is an error */
static bool leg_dart(mus__trousers_half *half, const leg_darts *darts)
{
    mus__waist waist;
    if (!leg_dart_close(half, darts, &waist)) return false;
    half->waist_length = darts->net;
    half->ndart = darts->n;
    memcpy(half->dart, waist.dart, sizeof half->dart);
    memcpy(half->waist, waist.part, sizeof half->waist);
    return true;
}


/* points of the leg that follow from the widths: knee and hem about the crease */
static void leg_points(const mus__trousers_def *def, int32_t back, double crotch, mus__trousers_half *half,
                       leg_problem *problem)
{
    const double knee = crotch - KNEE_PART * def->inleg, hem = crotch - def->inleg;
    half->crease = 0.5 * (half->hip - half->fork);
    problem->fork[0] = -half->fork;
    problem->knee[0] = half->crease - 0.5 * def->knee[back], problem->knee[1] = knee;
    problem->hem[0] = half->crease - 0.5 * def->hem[back], problem->hem[1] = hem;
    problem->out_knee[0] = half->crease + 0.5 * def->knee[back], problem->out_knee[1] = knee;
    problem->out_hem[0] = half->crease + 0.5 * def->hem[back], problem->out_hem[1] = hem;
}


/* front: hip (S + e)/4 - 1, centre .6 in at the waist, side .4 up, one dart; none with a yoke, but up to 1.2 in at the
 * centre */
static mus_status leg_front(mus_context *context, const mus__trousers_def *def, mus__trousers *out, double hip)
{
    mus__trousers_half *half = &out->front;
    leg_problem problem;
    half->hip = (hip + def->hip_ease) / 4.0 - 1.0 * MUS__CM;
    leg_points(def, 0, out->crotch, half, &problem);

    /* waist */
    const double net = def->net[0];
    const double high = def->top - out->hip;
    double x0 = 0.6 * MUS__CM * high / (0.0 - out->hip);
    leg_side_in(def, half->hip - x0 - net, 0.5, 3.5 * MUS__CM, half);
    if (def->yoke) {
        x0 = fmax(x0, fmin(0.3 * (half->hip - net), YOKE_FRONT_CENTRE));
        half->dart_width = 0.0;
    }
    half->centre[0] = x0, half->centre[1] = def->top;
    half->centre[2] = 0.0, half->centre[3] = out->hip;
    half->side[0] = x0 + net + half->dart_width, half->side[1] = def->top + 0.4 * MUS__CM;
    const leg_darts darts = {
        half, 1, {0.55 * (net + half->dart_width)}, {fmin(0.5 * high, 9.5 * MUS__CM) + 0.2 * MUS__CM}, net};
    if (!(half->dart_width > 0.0) || !leg_dart(half, &darts)) {
        half->dart_width = 0.0;
        half->side[0] = x0 + net;
        half->waist_length = mus__dist2(half->centre, half->side);
    }

    /* crotch and seams */
    const double hip_line[2] = {0.0, out->hip}, fork[2] = {-half->fork, out->crotch};
    mus__cubic_set(half->crotch, hip_line, 0.0, out->hip - 0.60 * (out->hip - out->crotch),
                   fork[0] + 0.62 * half->fork, out->crotch, fork);
    problem.hip[0] = half->hip, problem.hip[1] = out->hip;
    leg_inseam(&problem, out->crotch, 0.35, 0.22, &half->inseam);
    leg_outseam(&problem, half->side, &half->outseam);
    if (half->side[0] < 1.0 * MUS__CM)
        return mus__fail(context, MUS_ERR_DESIGN, "trousers: waist %d mm leaves no front",
                         mus__millimetres(def->waist));
    return MUS_OK;
}


/* side point of the back: y by the length of the outseam, x by the length of the waist, in turn until both stay */
static mus_status leg_back_side(mus_context *context, leg_problem *problem, mus__trousers_half *half, double width,
                                double top)
{
    const double *centre = half->centre;
    problem->side[0] = centre[0] + width;
    for (int i = 0; i < 40; i++) {
        double y;
        if (!mus__solve(leg_outseam_excess, problem, problem->hip[1] + 1.0 * MUS__CM, top + 12.0 * MUS__CM, &y))
            return mus__fail(context, MUS_ERR_DESIGN, "trousers: no back outseam of %d mm (waist, hip, rise)",
                             mus__millimetres(problem->target));
        const double lift = centre[1] - y, across = width * width - lift * lift;
        const double x = centre[0] + sqrt(fmax(across, 0.01 * width * width));
        const bool stays = fabs(x - problem->side[0]) < 1e-13 && fabs(y - problem->side[1]) < 1e-13;
        problem->side[0] = x, problem->side[1] = y;
        if (stays) break;
    }
    half->side[0] = problem->side[0], half->side[1] = problem->side[1];
    return MUS_OK;
}


/* ---- yoke ---- */

/* a yoke under work: its seam on the leg, and its darts, which would end on that seam */
typedef struct leg_yoke_plan {
    const mus__trousers_half *half;
    leg_darts darts;
} leg_yoke_plan;


/* the yoke with its darts open: its seam on the leg is the line from the centre to the outseam */
static void leg_yoke_begin(const leg_problem *problem, double high, mus__trousers_half *half)
{
    mus__trousers_yoke *yoke = &half->yoke;
    const double part = fmin(YOKE_CENTRE, YOKE_PART * high) / mus__dist2(half->centre, half->centre + 2);
    mus__chain outseam;
    leg_outseam(problem, half->side, &outseam);
    mus__chain_cut(&outseam, YOKE_SIDE / YOKE_CENTRE * fmin(YOKE_CENTRE, YOKE_PART * high), &yoke->side);
    yoke->cut = true;
    for (int i = 0; i < 2; i++) {
        yoke->centre[i] = half->centre[i];
        yoke->centre[2 + i] = yoke->top[i] = half->centre[i] + part * (half->centre[2 + i] - half->centre[i]);
        yoke->top[2 + i] = yoke->side.xy[2 * (yoke->side.nxy - 1) + i];
    }
}


/* closes the darts, shortened to `part`, in `yoke`, and draws its seam with the tangents that the line has at both
 * ends, handles of a third of the chord. Returns the length of the seam less that on the leg, NAN where the darts do
 * not close */
static double leg_yoke_close(const leg_yoke_plan *plan, double part, mus__trousers_yoke *yoke)
{
    leg_darts darts = plan->darts;
    mus__waist waist;
    *yoke = plan->half->yoke;
    for (int32_t d = 0; d < darts.n; d++) darts.length[d] *= part;
    if (!leg_dart_close(plan->half, &darts, &waist)) return NAN;
    memcpy(yoke->waist, waist.closed, sizeof yoke->waist);
    mus__chain_move(&yoke->side, waist.close);
    const double *p = yoke->top, *q = yoke->side.xy + 2 * (yoke->side.nxy - 1), *m = waist.close;
    const double length = mus__dist2(yoke->top, yoke->top + 2), reach = mus__dist2(p, q) / 3.0;
    const double x = (p[2] - p[0]) / length, y = (p[3] - p[1]) / length;
    mus__cubic_set(yoke->seam, p, p[0] + reach * x, p[1] + reach * y, q[0] - reach * (m[0] * x + m[1] * y),
                   q[1] - reach * (m[3] * x + m[4] * y), q);
    return mus__cubic_length(yoke->seam) - length;
}


static double leg_yoke_excess(const void *data, double part)
{
    mus__trousers_yoke yoke;
    return leg_yoke_close(data, part, &yoke);
}


/* draws the yoke with two darts closed; false where they do not close */
static bool leg_yoke(const leg_problem *problem, double net, double high, mus__trousers_half *half)
{
    const double d = half->dart_width, chord = mus__dist2(half->centre, half->side);
    leg_yoke_plan plan = {half, {half, 2, {net / 3.0 + 0.25 * d, net / 1.5 + 0.75 * d}, {0.0, 0.0}, net}};
    leg_yoke_begin(problem, high, half);

    /* from the waist, along the dart, to the seam */
    const double *a = half->centre, *p = half->yoke.top;
    const double x = (half->side[0] - a[0]) / chord, y = (half->side[1] - a[1]) / chord;
    const double run = x * (p[2] - p[0]) + y * (p[3] - p[1]), fall = y * (p[2] - p[0]) - x * (p[3] - p[1]);
    for (int32_t i = 0; i < 2; i++)
        plan.darts.length[i] = y * (p[0] - a[0]) - x * (p[1] - a[1]) +
                               fall / run * (plan.darts.at[i] - x * (p[0] - a[0]) - y * (p[1] - a[1]));
    double part;
    if (!mus__solve(leg_yoke_excess, &plan, 0.7, 1.2, &part)) return false;
    mus__trousers_yoke yoke;
    leg_yoke_close(&plan, part, &yoke);
    half->yoke = yoke;
    half->waist_length = net;
    return true;
}


/* the yoke of a back without darts */
static void leg_yoke_plain(const leg_problem *problem, double high, mus__trousers_half *half)
{
    leg_yoke_begin(problem, high, half);
    const double *lines[2] = {half->centre, half->yoke.top}, *ends[2] = {half->side, half->yoke.top + 2};
    double *const out[2] = {half->yoke.waist, half->yoke.seam};
    for (int i = 0; i < 2; i++) {
        const double *a = lines[i], *b = ends[i], x = (b[0] - a[0]) / 3.0, y = (b[1] - a[1]) / 3.0;
        mus__cubic_set(out[i], a, a[0] + x, a[1] + y, b[0] - x, b[1] - y, b);
    }
}


/* back: hip (S + e)/4 + 1, centre line tilted by 11 degrees and S/40 higher, up to two darts */
static mus_status leg_back(mus_context *context, const mus__trousers_def *def, mus__trousers *out, double hip)
{
    mus__trousers_half *half = &out->back;
    leg_problem problem = {.side = {0.0, 0.0}};
    half->hip = (hip + def->hip_ease) / 4.0 + 1.0 * MUS__CM;
    leg_points(def, 1, out->crotch, half, &problem);

    /* inseam as long as the front's: lower the fork */
    double fork_y;
    problem.target = mus__chain_length(&out->front.inseam);
    if (!mus__solve(leg_inseam_excess, &problem, out->crotch - 0.4 * def->inleg, out->crotch + 4.0 * MUS__CM, &fork_y))
        return mus__fail(context, MUS_ERR_DESIGN, "trousers: no back inseam of %d mm (inleg, knee, hem)",
                         mus__millimetres(problem.target));
    leg_inseam(&problem, fork_y, 0.40, 0.20, &half->inseam);
    half->fork_drop = out->crotch - fork_y;

    /* crotch */
    const double hip_line[2] = {0.0, out->hip}, fork[2] = {-half->fork, fork_y};
    half->centre[1] = def->top + hip / 40.0, half->centre[0] = BACK_TILT * (half->centre[1] - out->hip);
    half->centre[2] = 0.0, half->centre[3] = out->hip;
    mus__cubic_set(half->crotch, hip_line, -0.60 * BACK_TILT * (out->hip - out->crotch),
                   out->hip - 0.55 * (out->hip - fork_y), fork[0] + 0.72 * half->fork, fork_y, fork);

    /* waist and outseam as long as the front's */
    const double net = def->net[1];
    leg_side_in(def, half->hip - half->centre[0] - net, 0.35, 3.0 * MUS__CM, half);
    problem.hip[0] = half->hip, problem.hip[1] = out->hip;
    problem.target = mus__chain_length(&out->front.outseam);
    mus_status status = leg_back_side(context, &problem, half, net + half->dart_width, def->top);
    const double d = half->dart_width, high = def->top - out->hip, length = fmin(0.62 * high, 13.0 * MUS__CM);
    const bool one = d <= 3.2 * MUS__CM;
    const leg_darts darts = {half,
                             one ? 1 : 2,
                             {one ? 0.5 * net + 0.5 * d : 0.32 * net + 0.25 * d, 0.64 * net + 0.75 * d},
                             {length, length},
                             net};
    const bool closes =
        status == MUS_OK && d > 0.0 && (def->yoke ? leg_yoke(&problem, net, high, half) : leg_dart(half, &darts));
    if (status == MUS_OK && !closes) {
        if (d > 0.0) status = leg_back_side(context, &problem, half, net, def->top);
        half->dart_width = 0.0;
        half->waist_length = mus__dist2(half->centre, half->side);
        if (def->yoke) leg_yoke_plain(&problem, high, half);
    }
    leg_outseam(&problem, half->side, &half->outseam);
    return status;
}


typedef struct leg_level {
    const mus__chain *chain;
    double y;
} leg_level;


static double leg_level_excess(const void *data, double s)
{
    const leg_level *level = data;
    mus__chain part;
    mus__chain_cut(level->chain, s, &part);
    return part.xy[2 * part.nxy - 1] - level->y;
}


/* arc length at which a seam that runs down passes level y */
static double leg_level_at(const mus__chain *chain, double y)
{
    const leg_level level = {chain, y};
    const double length = mus__chain_length(chain);
    double s;
    return mus__solve(leg_level_excess, &level, 0.05 * length, length, &s) ? s : length;
}


/* end tangent of a chain, unit */
static void leg_tangent(const mus__chain *chain, double *out)
{
    const double *end = chain->xy + 2 * (chain->nxy - 1);
    const double x = end[0] - end[-2], y = end[1] - end[-1], r = sqrt(x * x + y * y);
    out[0] = x / r, out[1] = y / r;
}


/* cut both seams, lay the hem between them square to both, and measure */
static void leg_finish(mus__trousers_half *half, double in, double out, const double *knee)
{
    if (in < mus__chain_length(&half->inseam)) mus__chain_cut(&half->inseam, in, &half->inseam);
    if (out < mus__chain_length(&half->outseam)) mus__chain_cut(&half->outseam, out, &half->outseam);
    const double *a = half->inseam.xy + 2 * (half->inseam.nxy - 1), *b = half->outseam.xy + 2 * (half->outseam.nxy - 1);
    const double reach = 0.3 * mus__hypot(b[0] - a[0], b[1] - a[1]);
    double ta[2], tb[2];
    leg_tangent(&half->inseam, ta);
    leg_tangent(&half->outseam, tb);
    mus__cubic_set(half->hem, a, a[0] - reach * ta[1], a[1] + reach * ta[0], b[0] + reach * tb[1],
                   b[1] - reach * tb[0], b);
    half->inseam_length = mus__chain_length(&half->inseam);
    half->outseam_length = mus__chain_length(&half->outseam);
    half->crotch_length = mus__hypot(half->centre[0] - half->centre[2], half->centre[1] - half->centre[3]) +
                          mus__cubic_length(half->crotch);
    half->knee_in = fmax(0.0, half->inseam_length - knee[0]);
    half->knee_out = fmax(0.0, half->outseam_length - knee[1]);
}


mus_status mus__trousers_draft(mus_context *context, const mus__trousers_def *def, mus__trousers *out)
{
    memset(out, 0, sizeof *out);
    const double hip = fmax(def->hip, 0.97 * def->waist);
    out->crotch = -def->rise;
    out->hip = out->crotch + hip / 20.0 + 3.0 * MUS__CM;
    if (def->top < out->hip + 2.0 * MUS__CM || def->inleg < 5.0 * MUS__CM || def->end <= 0.0)
        return mus__fail(context, MUS_ERR_DESIGN, "trousers: rise %d mm, inleg %d mm: nothing between top and hem",
                         mus__millimetres(def->rise), mus__millimetres(def->inleg));

    /* forks: a twentieth of the hip in front, a tenth and 1 cm behind; wider where the thigh needs it, narrower in a
     * cloth that stretches round it */
    out->front.fork = hip / 20.0;
    out->back.fork = hip / 10.0 + 1.0 * MUS__CM;
    const double clear = 0.5 * (hip + def->hip_ease) + out->front.fork + out->back.fork;
    /* of both together a third is left at least */
    const double least = def->clings ? -2.0 / 3.0 * (out->front.fork + out->back.fork) : 0.0;
    const double lack = fmax(least, def->thigh - clear);
    out->front.fork += 0.3 * lack;
    out->back.fork += 0.7 * lack;
    out->thigh = clear + lack;

    mus_status status = leg_front(context, def, out, hip);
    if (status == MUS_OK) status = leg_back(context, def, out, hip);
    if (status != MUS_OK) return status;

    /* the cut, at a level of the front */
    const double level = out->crotch - fmin(def->end, 1.0) * def->inleg;
    const double knee_y = out->crotch - KNEE_PART * def->inleg;
    const double in = def->end < 1.0 ? leg_level_at(&out->front.inseam, level) : INFINITY;
    const double outer = def->end < 1.0 ? leg_level_at(&out->front.outseam, level) : INFINITY;
    const double knee[2] = {leg_level_at(&out->front.inseam, knee_y), leg_level_at(&out->front.outseam, knee_y)};
    leg_finish(&out->front, in, outer, knee);
    leg_finish(&out->back, in, outer, knee);
    return MUS_OK;
}
