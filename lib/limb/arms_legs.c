/*
 * arms_legs.c: the contours of arms, legs and feet.
 *
 * An arm has a straight axis from the shoulder joint through the wrist, at the tape's angle below the horizontal; its
 * first contours are a ball inside the shoulder of the torso. A leg has a vertical axis; on the way down the centres of
 * its contours move outwards and backwards. Legs begin inside the torso above the crotch, where a wall separates them.
 * Feet lie along Z on the floor. Girths between the measured ones are fractions of these, taken from the mean bodies of
 * GarmentCode.
 *
 *      ___                 |  |
 *     (   \  ball          |  |  thigh
 *      \   \  upper arm     | |  knee
 *       \   \  elbow        ( |  calf
 *        \   \  wrist        ||  ankle
 *         \__/  hand       (____)  foot
 */
#include <math.h>
#include <string.h>

#include "limb/limb.h"
#include "geom/vec.h"

/* distance that each leg keeps from the middle plane [m]; chosen */
#define LEG_WALL 0.004


/* add a contour at s [m] to be fitted to a girth [m], with a ratio of depth to breadth and an exponent n */
static mus__contour *limb_add(mus__limb *limb, const char *name, double s, double girth, double ratio, double n)
{
    mus__contour *contour = &limb->contour[limb->count++];
    memset(contour, 0, sizeof *contour);
    contour->name = name;
    contour->girth = contour->height = contour->ring = MUS_NONE;
    contour->s = s;
    contour->target = girth;
    contour->a = mus__contour_half_breadth(girth, ratio, n);
    contour->b = ratio * contour->a;
    contour->n = n;
    return contour;
}


/* add a contour that has a girth of the tape */
static mus__contour *limb_add_measure(mus__limb *limb, const mus_tape *tape, const char *name, double s, int32_t girth,
                                      double ratio, double n)
{
    mus__contour *contour = limb_add(limb, name, s, mus_tape_value(tape, girth), ratio, n);
    contour->girth = contour->height = girth;
    contour->hard = true;
    return contour;
}


/* s [m] of a contour that lies at the part u of the mean body's arm, whose elbow is at 0.53 */
static double limb_arm_at(const mus__skeleton *skeleton, double u)
{
    const double beyond = skeleton->arm_length - skeleton->elbow;
    return u < 0.53 ? u / 0.53 * skeleton->elbow : skeleton->elbow + (u - 0.53) / 0.47 * beyond;
}


void mus__limb_arm(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, mus__limb *limb)
{
    double h = skeleton->crown, upper = mus_tape_value(tape, MUS_MEASURE_UPPER_ARM);
    double wrist = mus_tape_value(tape, MUS_MEASURE_WRIST), hand = mus_tape_value(tape, MUS_MEASURE_HAND);
    double length = skeleton->arm_length, ball = 1.10 * upper / (2.0 * MUS_PI), palm = 0.111 * h;

    /* frame: front is -Z made square to the axis (backwards), side = front x axis */
    memset(limb, 0, sizeof *limb);
    limb->name = right ? "arm_right" : "arm_left";
    limb->end[0] = MUS_MEASURE_UPPER_ARM, limb->end[1] = MUS_MEASURE_ARM;
    memcpy(limb->origin, skeleton->joint[right], sizeof limb->origin);
    memcpy(limb->axis, skeleton->arm_axis[right], sizeof limb->axis);
    double along = limb->axis[2];
    for (int i = 0; i < 3; i++) limb->front[i] = (i == 2 ? -1.0 : 0.0) + along * limb->axis[i];
    mus__unit3(limb->front);
    mus__cross3(limb->front, limb->axis, limb->side);

    /* the ball of the shoulder: half a sphere before the joint, 1.10 of the upper arm's girth */
    limb->pole[0] = -ball;
    limb_add(limb, "ball_inner", -0.70 * ball, 0.714 * 1.10 * upper, 1.0, 2.0);
    limb_add(limb, "ball", -0.35 * ball, 0.937 * 1.10 * upper, 1.0, 2.0);
    limb_add(limb, "shoulder", 0.0, 1.10 * upper, 1.0, 2.0);
    limb_add(limb, "deltoid", limb_arm_at(skeleton, 0.13), 1.10 * upper, 1.0, 2.0);

    /* upper arm to wrist; girths between them stay above the wrist's where a given wrist is nearly the upper arm */
    double elbow = fmax(0.84 * upper, 1.02 * wrist);
    double fore = fmax(fmin(0.42 * upper + 0.85 * wrist, 0.90 * upper), 1.02 * wrist);
    limb_add_measure(limb, tape, "upper_arm", limb_arm_at(skeleton, 0.30), MUS_MEASURE_UPPER_ARM, 0.97, 2.0);
    limb_add(limb, "arm", limb_arm_at(skeleton, 0.43), fmax(0.90 * upper, 1.02 * wrist), 0.97, 2.0);
    limb_add(limb, "elbow", skeleton->elbow, elbow, 1.08, 2.0);
    limb_add(limb, "forearm", limb_arm_at(skeleton, 0.62), fore, 1.05, 2.0);
    limb_add(limb, "forearm_low", limb_arm_at(skeleton, 0.78), fmax(0.66 * upper, 1.01 * wrist), 1.05, 2.0);
    limb_add(limb, "above_wrist", limb_arm_at(skeleton, 0.92), fmax(0.54 * upper, wrist), 1.12, 2.0);
    limb_add_measure(limb, tape, "wrist", length, MUS_MEASURE_WRIST, 1.25, 2.1);

    /* the hand as a mitten, its breadth forwards */
    limb_add_measure(limb, tape, "hand", length + 0.40 * palm, MUS_MEASURE_HAND, 2.1, 2.3);
    limb_add(limb, "fingers", length + 0.68 * palm, 0.86 * hand, 2.3, 2.3);
    limb_add(limb, "finger_tips", length + 0.90 * palm, 0.62 * hand, 2.3, 2.2);
    limb->pole[1] = length + palm;
}


/* distance [m] of the leg's middle from the middle plane, at the part u of the way from the crotch to the floor: the
 * line through the joints, at least so far out that the wall cuts at most a tenth of the half breadth a */
static double limb_leg_x(double h, double u, double top, double a)
{
    double knee = 0.058 * h, ankle = 0.063 * h;
    double x = u < 0.40 ? top + (knee - top) * u / 0.40 : knee + (ankle - knee) * (u - 0.40) / 0.43;
    return fmax(x, 0.90 * a + LEG_WALL);
}


/* the root of the leg: it widens from the thigh to its half of the hip, with the buttock of its side, and ends inside
 * the torso, so that the leg leaves the torso along its surface; the wall cuts it at the middle plane */
static void limb_leg_root(const mus__contour *hip, double crotch, double h, double side, mus__limb *limb)
{
    const mus__contour thigh = limb->contour[limb->count - 1];
    const double out = side * thigh.ca + thigh.a;
    const struct {
        const char *name;
        double s, hip, size;
    } row[] = {{"leg_root", crotch + 0.50 * (hip->s - crotch), 0.93, 1.0},
               {"leg_top", hip->s, 1.0, 1.0},
               {"leg_end", hip->s + 0.025 * h, 1.0, 0.97}};
    for (int i = 0; i < 3; i++) {
        const double part = row[i].hip, size = row[i].size;
        mus__contour *contour = limb_add(limb, row[i].name, row[i].s, 1.0, 1.0, 2.0);
        contour->target = 0.0;
        contour->ca = thigh.ca;
        contour->cb = thigh.cb;
        contour->a = thigh.a, contour->b = thigh.b;
        contour->wall = LEG_WALL, contour->wall_side = side;
        const double host[7] = {hip->ca,
                                thigh.cb + part * (hip->cb - thigh.cb),
                                size * (out + part * (hip->a - out)),
                                size * (thigh.b + part * (hip->b - thigh.b)),
                                hip->n,
                                size * part * hip->bump[1],
                                hip->bump_angle[1]};
        memcpy(contour->host, host, sizeof host);
    }

    /* it closes above the hip as a ball, so that a bent hip has a round seat */
    limb->pole[1] = hip->s + fmax(0.06 * h, 0.5 * (thigh.a + thigh.b));
}


void mus__limb_leg(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, const mus__contour *hip,
                   mus__limb *limb)
{
    double h = skeleton->crown, crotch = skeleton->crotch, side = right ? -1.0 : 1.0;
    double thigh = mus_tape_value(tape, MUS_MEASURE_THIGH), knee = mus_tape_value(tape, MUS_MEASURE_KNEE);
    double calf = mus_tape_value(tape, MUS_MEASURE_CALF), ankle = mus_tape_value(tape, MUS_MEASURE_ANKLE);
    double male = mus_tape_sex(tape) == MUS_SEX_MALE ? 1.0 : mus_tape_sex(tape) == MUS_SEX_UNSET ? 0.5 : 0.0;

    memset(limb, 0, sizeof *limb);
    limb->name = right ? "leg_right" : "leg_left";
    limb->end[0] = limb->end[1] = MUS_MEASURE_INLEG;
    limb->side[0] = 1.0, limb->front[2] = -1.0, limb->axis[1] = 1.0;
    limb->wall = LEG_WALL, limb->wall_side = side;

    double deep = mus__contour_thigh_ratio(thigh, hip->a);

    /* the part u from the crotch down, girth, ratio of depth to breadth of women and of men, Z in parts of the stature;
     * girths between thigh and knee taper as on the mean body */
    double taper = thigh - knee;
    const struct {
        const char *name;
        int32_t measure;
        double u, girth, female, male, z;
    } row[] = {
        {"instep", MUS_NONE, 0.94, 1.12 * ankle, 1.45, 1.50, -0.026},
        {"above_instep", MUS_NONE, 0.89, 1.03 * ankle, 1.32, 1.40, -0.028},
        {"ankle", MUS_MEASURE_ANKLE, 0.83, ankle, 1.28, 1.39, -0.029},
        {"calf_low", MUS_NONE, 0.73, 0.5 * ankle + 0.42 * calf, 1.10, 1.14, -0.031},
        {"calf", MUS_MEASURE_CALF, 0.57, calf, 1.00, 1.03, -0.030},
        {"below_knee", MUS_NONE, 0.47, 0.45 * knee + 0.48 * calf, 0.98, 1.08, -0.021},
        {"knee", MUS_MEASURE_KNEE, 0.40, knee, 1.00, 1.09, -0.012},
        {"above_knee", MUS_NONE, 0.31, knee + 0.20 * taper, 1.04, 1.09, -0.007},
        {"thigh_low", MUS_NONE, 0.22, knee + 0.47 * taper, 1.05, 1.10, -0.003},
        {"thigh_mid", MUS_NONE, 0.12, knee + 0.81 * taper, fmax(1.04, deep - 0.05), fmax(1.06, deep - 0.05), -0.002},
        {"thigh", MUS_MEASURE_THIGH, 0.02, thigh, deep, deep, -0.004},
    };
    int rows = (int)(sizeof row / sizeof *row);
    double a0 = mus__contour_half_breadth(thigh, deep, 2.05), top = fmax(0.985 * hip->a - a0, 0.5 * a0);
    for (int i = 0; i < rows; i++) {
        double ratio = row[i].female + male * (row[i].male - row[i].female), s = crotch * (1.0 - row[i].u);
        mus__contour *contour = limb_add(limb, row[i].name, s, row[i].girth, ratio, 2.05);
        contour->girth = contour->height = row[i].measure;
        contour->hard = row[i].measure != MUS_NONE;
        contour->ca = side * limb_leg_x(h, row[i].u, top, contour->a);
        contour->cb = -row[i].z * h;
        contour->wall = limb->wall, contour->wall_side = side;
    }
    limb_leg_root(hip, crotch, h, side, limb);
    limb->pole[0] = fmin(0.035 * crotch, 0.012 * h);
}


void mus__limb_foot(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, const mus__limb *leg,
                    mus__limb *limb)
{
    double h = skeleton->crown, foot = mus_tape_value(tape, MUS_MEASURE_FOOT), side = right ? -1.0 : 1.0;
    double ankle_x = 0.063 * h + 0.002, heel = -0.029 * h - 0.25 * foot;

    /* the heel is behind the end of the leg: a newborn's leg is as deep there as half of its foot */
    heel = fmin(heel, -leg->contour[0].cb - leg->contour[0].b);

    /* frame: b is up, s forwards */
    memset(limb, 0, sizeof *limb);
    limb->name = right ? "foot_right" : "foot_left";
    limb->end[0] = limb->end[1] = MUS_MEASURE_FOOT;
    limb->side[0] = 1.0, limb->front[1] = 1.0, limb->axis[2] = 1.0;

    /* part f of the length from the heel; breadth, height and shift outwards in parts of the length */
    static const struct {
        const char *name;
        double f, breadth, height, out;
    } row[] = {
        {"heel_back", 0.035, 0.165, 0.20, 0.000},  {"heel", 0.11, 0.235, 0.24, 0.000},
        {"ankle_joint", 0.24, 0.255, 0.28, 0.000}, {"instep", 0.40, 0.275, 0.275, 0.004},
        {"waist", 0.54, 0.325, 0.215, 0.012},      {"ball", 0.70, 0.375, 0.155, 0.020},
        {"toes", 0.84, 0.345, 0.115, 0.030},       {"toe_tips", 0.945, 0.245, 0.090, 0.036},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus__contour *contour = limb_add(limb, row[i].name, heel + row[i].f * foot, 1.0, 1.0, 2.5);
        contour->target = 0.0;
        contour->a = 0.5 * row[i].breadth * foot;
        contour->b = 0.5 * row[i].height * foot;
        contour->ca = side * (ankle_x + row[i].out * foot);
        contour->cb = contour->b;
    }
    limb->pole[0] = heel;
    limb->pole[1] = heel + foot;
}
