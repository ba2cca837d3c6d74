/*
 * body_torso.c: the contours of torso, neck and head.
 *
 * One vertical stack from the crotch to the crown. Each contour is a superellipse with the tape's girth where there is
 * one (bust, waist, hip ...), or with a breadth where the tape gives a breadth (shoulders, across back). The ratios of
 * depth to breadth, the exponents and the forward offsets of the centres are means of ANSUR II (breadths and depths of
 * 6068 people) and of the mean bodies of GarmentCode, sliced; women's and men's, the mean for an unset sex; a
 * child's ratios move with the stature from 56 to 164 cm.
 *
 *         ( )      crown, brow, jaw         ellipsoid over the brow
 *          |       nape, neck
 *       .-' '-.    slope, shoulder          breadths
 *       |     |    armhole, armpit, bust, underbust
 *        \   /     waist, navel
 *        /   \     high hip, hip
 *        '._.'     crotch: closes upwards of the crotch height
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"

/* what the contours of one torso are made from */
typedef struct torso_plan {
    const mus_tape *tape;
    const mus__skeleton *bone;
    mus__limb *limb;
    int32_t sex;
    double h;     /* stature */
    double grown; /* 0 for a child of 56 cm, 1 from 164 cm on and for adults */
} torso_plan;


/* women's or men's figure; a child's goes from `small` to the women's */
static double torso_mix(const torso_plan *plan, double female, double male)
{
    return plan->sex == MUS_SEX_MALE ? male : plan->sex == MUS_SEX_UNSET ? 0.5 * (female + male) : female;
}


static double torso_ratio(const torso_plan *plan, double female, double male, double child)
{
    if (plan->sex == MUS_SEX_CHILD) return child;
    double ratio = torso_mix(plan, female, male);
    return fmin(fmax(ratio, 0.35), 1.05);
}


static double torso_value(const torso_plan *plan, int32_t measure)
{
    return mus_tape_value(plan->tape, measure);
}


/* add a contour on top of the others: its half breadth is 1 until it is fitted to `girth` */
static mus__contour *torso_add(const torso_plan *plan, const char *name, double s, double ratio, double n, double z)
{
    mus__contour *contour = &plan->limb->contour[plan->limb->count++];
    memset(contour, 0, sizeof *contour);
    contour->name = name;
    contour->girth = contour->height = MUS_NONE;
    contour->s = s;
    contour->a = 1.0, contour->b = ratio, contour->n = n;
    contour->cb = -z;
    return contour;
}


/* a contour whose girth is `girth`; an estimate of its size now, the exact fit later */
static mus__contour *torso_add_girth(const torso_plan *plan, const char *name, double s, double girth, double ratio,
                                     double n, double z)
{
    mus__contour *contour = torso_add(plan, name, s, ratio, n, z);
    contour->target = girth;
    contour->a = girth / (MUS_PI * (1.0 + ratio) * (1.0 + 0.045 * (n - 2.0)));
    contour->b = ratio * contour->a;
    contour->ring = MUS_NONE;
    return contour;
}


static mus__contour *torso_add_measure(const torso_plan *plan, const char *name, double s, int32_t girth,
                                       int32_t height, double ratio, double n, double z)
{
    mus__contour *contour = torso_add_girth(plan, name, s, torso_value(plan, girth), ratio, n, z);
    contour->girth = girth;
    contour->height = height;
    contour->hard = mus_tape_source(plan->tape, girth) == MUS_SOURCE_GIVEN;
    return contour;
}


static mus__contour *torso_add_breadth(const torso_plan *plan, const char *name, double s, double breadth, double ratio,
                                       double n, double z)
{
    mus__contour *contour = torso_add(plan, name, s, ratio, n, z);
    contour->a = 0.5 * breadth, contour->b = 0.5 * breadth * ratio;
    return contour;
}


/* crotch to waist */
static void torso_seat(const torso_plan *plan)
{
    const mus__skeleton *bone = plan->bone;
    double h = plan->h, hip = torso_value(plan, MUS_MEASURE_HIP), waist = torso_value(plan, MUS_MEASURE_WAIST);
    double high = torso_value(plan, MUS_MEASURE_HIGH_HIP), child = 0.78 - 0.08 * plan->grown;

    /* the hull of both thighs; it closes to the crotch, which is where the inside leg ends */
    double room = fmin(0.020 * h, 0.45 * (bone->hip - bone->crotch));
    mus__contour *crotch =
        torso_add_girth(plan, "crotch", bone->crotch + room, 0.985 * hip, torso_ratio(plan, 0.59, 0.66, child), 2.5,
                        torso_mix(plan, -0.008, -0.005) * h);
    crotch->height = MUS_MEASURE_INLEG;
    crotch->bump[1] = 0.004 * h, crotch->bump_angle[1] = 0.44;
    plan->limb->pole[0] = bone->crotch;

    /* buttocks: bumps 25 degrees off the back */
    double ratio = torso_ratio(plan, 0.655 + 0.35 * (hip / h - 0.627), 0.73 + 0.6 * (hip / h - 0.581), child);
    mus__contour *seat = torso_add_measure(plan, "hip", bone->hip, MUS_MEASURE_HIP, MUS_MEASURE_WAIST_TO_HIP, ratio,
                                           torso_mix(plan, 2.4, 2.3), torso_mix(plan, -0.008, -0.006) * h);
    seat->bump[1] = 0.009 * h, seat->bump_angle[1] = 0.44;

    torso_add_measure(plan, "high_hip", bone->high_hip, MUS_MEASURE_HIGH_HIP, MUS_MEASURE_WAIST_TO_HIP,
                      torso_ratio(plan, 0.755, 0.755, 0.80 - 0.04 * plan->grown), 2.06,
                      torso_mix(plan, 0.005, -0.001) * h);
    torso_add_girth(plan, "navel", bone->waist - 0.36 * (bone->waist - bone->high_hip),
                    waist + torso_mix(plan, 0.36, 0.16) * (high - waist),
                    torso_ratio(plan, 0.745, 0.755, 0.84 - 0.07 * plan->grown), 2.1, torso_mix(plan, 0.012, 0.010) * h);
    ratio = torso_mix(plan, 0.77, 0.77) + 0.4 * (waist / h - 0.48);
    torso_add_measure(plan, "waist", bone->waist, MUS_MEASURE_WAIST, MUS_MEASURE_WAIST_HEIGHT,
                      torso_ratio(plan, ratio, ratio, 0.85 - 0.07 * plan->grown), torso_mix(plan, 2.1, 2.15),
                      torso_mix(plan, 0.014, 0.011) * h * plan->grown);
}


/* underbust to armpit; breasts are bumps at the bust span, high enough for bust less high bust */
static void torso_chest(const torso_plan *plan)
{
    const mus__skeleton *bone = plan->bone;
    double h = plan->h, bust = torso_value(plan, MUS_MEASURE_BUST), high = torso_value(plan, MUS_MEASURE_HIGH_BUST);
    double more = 0.9 * (bust / h - 0.57);

    torso_add_measure(plan, "underbust", bone->underbust, MUS_MEASURE_UNDERBUST, MUS_MEASURE_BUST_HEIGHT,
                      torso_ratio(plan, 0.757, 0.75, 0.82 - 0.04 * plan->grown), torso_mix(plan, 2.2, 2.4),
                      torso_mix(plan, 0.005, 0.0) * h);
    mus__contour *chest = torso_add_measure(plan, "bust", bone->bust, MUS_MEASURE_BUST, MUS_MEASURE_BUST_HEIGHT,
                                            torso_ratio(plan, 0.80 + more, 0.70 + more, 0.80),
                                            torso_mix(plan, 2.6, 2.8), torso_mix(plan, 0.008, -0.005) * h);
    double span = torso_value(plan, MUS_MEASURE_BUST_SPAN);
    if (plan->sex != MUS_SEX_MALE && plan->sex != MUS_SEX_CHILD && bust > high) {
        chest->bump[0] = fmin((bust - high) / 2.6, 0.25 * chest->b);
        chest->bump_angle[0] = atan2(0.5 * span, chest->b);
    }
    mus__contour *armpit = torso_add_measure(plan, "high_bust", bone->armpit, MUS_MEASURE_HIGH_BUST,
                                             MUS_MEASURE_SCYE_DEPTH, torso_ratio(plan, 0.69, 0.66, 0.72),
                                             torso_mix(plan, 2.9, 3.0), torso_mix(plan, -0.002, -0.009) * h);
    armpit->hard = false;
}


/* mid armhole to jaw: breadths at the shoulders, girths at the neck */
static void torso_shoulders(const torso_plan *plan)
{
    const mus__skeleton *bone = plan->bone;
    double h = plan->h, neck = torso_value(plan, MUS_MEASURE_NECK);
    double across = 0.98 * torso_value(plan, MUS_MEASURE_ACROSS_BACK);

    torso_add_breadth(plan, "armhole", 0.5 * (bone->armpit + bone->shoulder), across,
                      torso_ratio(plan, 0.57, 0.57, 0.60), 2.3, torso_mix(plan, -0.012, -0.016) * h);
    mus__contour *shoulder = torso_add_breadth(plan, "shoulder", bone->shoulder, 2.0 * bone->shoulder_x,
                                               torso_ratio(plan, 0.38, 0.40, 0.42), 2.0, bone->shoulder_z);
    shoulder->height = MUS_MEASURE_SHOULDER_SLOPE;
    torso_add_breadth(plan, "slope", bone->shoulder + 0.57 * (bone->neck_side - bone->shoulder),
                      2.0 * (bone->neck_side_x + 0.42 * (bone->shoulder_x - bone->neck_side_x)),
                      torso_ratio(plan, 0.44, 0.44, 0.46), 2.0, torso_mix(plan, -0.012, -0.015) * h);
    torso_add_measure(plan, "neck", bone->neck_side, MUS_MEASURE_NECK, MUS_MEASURE_NECK,
                      torso_ratio(plan, 0.95, 0.95, 0.95), 2.0, torso_mix(plan, -0.004, -0.008) * h);
    mus__contour *nape = torso_add_girth(plan, "nape", bone->nape, torso_mix(plan, 0.89, 0.915) * neck,
                                         torso_mix(plan, 1.20, 1.13), 2.0, torso_mix(plan, 0.008, 0.004) * h);
    nape->height = MUS_MEASURE_NAPE_HEIGHT;
}


/* jaw and brow, and the ellipsoid from the brow to the crown */
static void torso_head(const torso_plan *plan)
{
    const mus__skeleton *bone = plan->bone;
    double h = plan->h, head = torso_value(plan, MUS_MEASURE_HEAD), top = bone->crown - bone->brow;

    torso_add_girth(plan, "jaw", bone->jaw, 0.80 * head, torso_mix(plan, 1.34, 1.38), 2.0,
                    torso_mix(plan, 0.026, 0.021) * h);
    mus__contour *brow =
        torso_add_measure(plan, "brow", bone->brow, MUS_MEASURE_HEAD, MUS_MEASURE_STATURE, 1.29, 2.1, 0.010 * h);
    brow->hard = mus_tape_source(plan->tape, MUS_MEASURE_HEAD) == MUS_SOURCE_GIVEN;

    /* u of the way from brow to crown the ellipsoid has sqrt(1 - u^2) of the brow's girth */
    static const double steps[] = {0.40, 0.68, 0.86};
    static const char *const names[] = {"head_low", "head_mid", "head_top"};
    for (int i = 0; i < 3; i++) {
        double u = steps[i];
        torso_add_girth(plan, names[i], bone->brow + u * top, sqrt(1.0 - u * u) * head, 1.29 + 0.04 * u, 2.1,
                        (0.010 - 0.002 * u) * h);
    }
    plan->limb->pole[1] = bone->crown;
}


void mus__body_torso(const mus_tape *tape, const mus__skeleton *skeleton, mus__limb *limb)
{
    torso_plan plan = {tape, skeleton, limb, mus_tape_sex(tape), skeleton->crown, 1.0};
    if (plan.sex == MUS_SEX_CHILD) plan.grown = fmin(fmax((plan.h - 0.56) / 1.08, 0.0), 1.0);

    memset(limb, 0, sizeof *limb);
    limb->name = "torso";
    limb->side[0] = 1.0, limb->front[2] = -1.0, limb->axis[1] = 1.0;
    torso_seat(&plan);
    torso_chest(&plan);
    torso_shoulders(&plan);
    torso_head(&plan);
}
