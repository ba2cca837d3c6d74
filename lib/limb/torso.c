/*
 * torso.c: the contours of torso, neck and head.
 *
 * One vertical stack from the crotch to the crown. Each contour is a superellipse with a girth of the tape (bust,
 * waist, hip ...) or, at the shoulders, with a breadth of the tape. The ratios of depth to breadth, the exponents and
 * the forward offsets of the centres are means of ANSUR II (breadths and depths of 6068 people) and of sections of the
 * mean bodies of GarmentCode. Women and men have their own; an unset sex has the mean. A child's ratios are linear in
 * the stature from 56 to 164 cm.
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

#include "limb/limb.h"
#include "base/elementary.h"
#include "geom/vec.h"

/* shape of a contour: ratio of depth to breadth, exponent, forward offset of the centre in parts of the stature */
typedef struct torso_shape {
    const char *name;
    struct {
        double ratio, n, z;
    } female, male;
    double small, big; /* ratio of a child of 56 and of 164 cm */
} torso_shape;

enum {
    TORSO_CROTCH,
    TORSO_HIP,
    TORSO_HIGH_HIP,
    TORSO_NAVEL,
    TORSO_WAIST,
    TORSO_MIDRIFF,
    TORSO_UNDERBUST,
    TORSO_BUST,
    TORSO_ARMPIT,
    TORSO_ARMHOLE,
    TORSO_SHOULDER,
    TORSO_SLOPE,
    TORSO_NECK,
    TORSO_NAPE,
    TORSO_CHIN,
    TORSO_JAW,
    TORSO_BROW
};

/* ratio and exponent: calipers of ANSUR II and sections of GarmentCode's mean bodies; offsets: the same, smoothed so
 * that the profile of back and front has no steps */
static const torso_shape torso_shapes[] = {
    {"crotch", {1.0, 2.4, -0.0045}, {1.0, 2.4, -0.0045}, 1.0, 1.0},
    {"hip", {0.615, 3.2, -0.0080}, {0.675, 3.2, -0.0080}, 0.78, 0.70},
    {"high_hip", {0.71, 2.5, -0.0040}, {0.72, 2.5, -0.0050}, 0.80, 0.76},
    {"navel", {0.71, 2.6, 0.0010}, {0.715, 2.6, -0.0010}, 0.82, 0.77},
    {"waist", {0.75, 2.4, 0.0040}, {0.75, 2.4, 0.0010}, 0.85, 0.78},
    {"midriff", {0.76, 2.15, 0.0050}, {0.76, 2.3, 0.0000}, 0.84, 0.78},
    {"underbust", {0.757, 2.2, 0.0050}, {0.75, 2.4, 0.0000}, 0.82, 0.78},
    {"bust", {0.735, 2.35, 0.0050}, {0.685, 2.6, 0.0000}, 0.80, 0.80},
    {"high_bust", {0.69, 2.7, 0.0000}, {0.67, 2.7, -0.0040}, 0.72, 0.72},
    {"armhole", {0.53, 2.3, -0.0090}, {0.50, 2.3, -0.0110}, 0.57, 0.57},
    {"shoulder", {0.40, 2.0, -0.0125}, {0.38, 2.0, -0.0140}, 0.42, 0.42},
    {"slope", {0.54, 2.0, -0.0065}, {0.52, 2.0, -0.0090}, 0.60, 0.56},
    {"neck", {0.95, 2.0, -0.0040}, {0.95, 2.0, -0.0035}, 0.95, 0.95},
    {"nape", {1.08, 2.0, 0.0030}, {1.08, 2.0, 0.0020}, 1.08, 1.08},
    {"chin", {1.22, 2.0, 0.0140}, {1.22, 2.0, 0.0120}, 1.22, 1.22},
    {"jaw", {1.30, 2.1, 0.0195}, {1.32, 2.1, 0.0170}, 1.30, 1.30},
    {"brow", {1.29, 2.1, 0.0100}, {1.29, 2.1, 0.0100}, 1.29, 1.29},
};

/* the inputs of one torso */
typedef struct torso_input {
    const mus_tape *tape;
    const mus__skeleton *bone;
    mus__limb *limb;
    int32_t sex;
    double h;     /* stature */
    double grown; /* 0 for a child of 56 cm, 1 from 164 cm on and for adults */
} torso_input;


/* women's or men's number, the mean for an unset sex; children take the women's */
static double torso_mix(const torso_input *in, double female, double male)
{
    return in->sex == MUS_SEX_MALE ? male : in->sex == MUS_SEX_UNSET ? 0.5 * (female + male) : female;
}


static double torso_value(const torso_input *in, int32_t measure)
{
    return mus_tape_value(in->tape, measure);
}


/* add a contour of a shape at height s [m] with half breadth a [m]; `more` is added to its ratio of depth to breadth */
static mus__contour *torso_put(const torso_input *in, int32_t shape, double s, double a, double more)
{
    const torso_shape *row = &torso_shapes[shape];
    mus__contour *contour = &in->limb->contour[in->limb->count++];
    memset(contour, 0, sizeof *contour);
    contour->name = row->name;
    contour->girth = contour->height = contour->ring = MUS_NONE;
    contour->s = s;

    /* chosen: the ratio of a torso stays within 0.35 to 1.05 for every tape; heads are deeper than broad */
    double ratio = torso_mix(in, row->female.ratio, row->male.ratio) + more;
    if (in->sex == MUS_SEX_CHILD) ratio = row->small + in->grown * (row->big - row->small);
    if (shape < TORSO_NECK) ratio = fmin(fmax(ratio, 0.35), 1.05);
    contour->n = torso_mix(in, row->female.n, row->male.n);
    contour->a = a;
    contour->b = ratio * a;
    contour->cb = -torso_mix(in, row->female.z, row->male.z) * in->h;
    return contour;
}


/* the same, to be fitted to a girth [m]; until then its size is an estimate */
static mus__contour *torso_put_girth(const torso_input *in, int32_t shape, double s, double girth, double more)
{
    mus__contour *contour = torso_put(in, shape, s, 1.0, more);
    double a = mus__contour_half_breadth(girth, contour->b, contour->n);
    contour->b *= a;
    contour->a = a;
    contour->target = girth;
    return contour;
}


/* the same with a measure of the tape as its girth and a measure that sets its height */
static mus__contour *torso_put_measure(const torso_input *in, int32_t shape, double s, int32_t girth, int32_t height,
                                       double more)
{
    mus__contour *contour = torso_put_girth(in, shape, s, torso_value(in, girth), more);
    contour->girth = girth;
    contour->height = height;
    contour->hard = mus_tape_source(in->tape, girth) == MUS_SOURCE_GIVEN;
    return contour;
}


/* crotch to waist; the ratio of depth to breadth grows with girth over stature */
static void torso_seat(const torso_input *in)
{
    const mus__skeleton *bone = in->bone;
    double h = in->h, hip = torso_value(in, MUS_MEASURE_HIP), waist = torso_value(in, MUS_MEASURE_WAIST);

    /* below the hip the torso narrows to 0.88, inside the roots of the legs, and closes at the crotch, where the inside
     * leg ends */
    mus__contour *crotch = torso_put(in, TORSO_CROTCH, bone->crotch + 0.30 * (bone->hip - bone->crotch), 1.0, 0.0);
    crotch->height = MUS_MEASURE_INLEG;
    in->limb->pole[0] = bone->crotch;

    /* buttocks: bumps 25 degrees (0.44 rad) to both sides of the back */
    mus__contour *seat = torso_put_measure(in, TORSO_HIP, bone->hip, MUS_MEASURE_HIP, MUS_MEASURE_WAIST_TO_HIP,
                                           torso_mix(in, 0.35 * (hip / h - 0.627), 0.6 * (hip / h - 0.581)));
    seat->bump[1] = torso_mix(in, 0.009, 0.006) * h, seat->bump_angle[1] = 0.44;
    seat->flat = true;
    crotch->a = 0.88 * seat->a;
    crotch->b = 0.88 * seat->b;
    crotch->cb = seat->cb;

    torso_put_measure(in, TORSO_HIGH_HIP, bone->high_hip, MUS_MEASURE_HIGH_HIP, MUS_MEASURE_WAIST_TO_HIP,
                      0.25 * (waist / h - 0.48));
    if (in->sex != MUS_SEX_CHILD)
        torso_put_girth(in, TORSO_NAVEL, bone->waist - torso_mix(in, 0.167, 0.117) * (bone->waist - bone->hip),
                        waist + torso_mix(in, 0.24, 0.12) * (hip - waist), 0.4 * (waist / h - 0.48));
    mus__contour *narrow = torso_put_measure(in, TORSO_WAIST, bone->waist, MUS_MEASURE_WAIST,
                                             MUS_MEASURE_WAIST_HEIGHT, 0.4 * (waist / h - 0.48));
    narrow->flat = true;
}


/* from above the waist to the armpit; breasts are bumps at half the bust span to both sides, whose height follows from
 * bust less high bust */
static void torso_chest(const torso_input *in)
{
    const mus__skeleton *bone = in->bone;
    double h = in->h, bust = torso_value(in, MUS_MEASURE_BUST), high = torso_value(in, MUS_MEASURE_HIGH_BUST);
    double waist = torso_value(in, MUS_MEASURE_WAIST), under = torso_value(in, MUS_MEASURE_UNDERBUST);

    torso_put_girth(in, TORSO_MIDRIFF, 0.5 * (bone->waist + bone->underbust), 0.60 * waist + 0.40 * under,
                    0.3 * (waist / h - 0.48));
    torso_put_measure(in, TORSO_UNDERBUST, bone->underbust, MUS_MEASURE_UNDERBUST, MUS_MEASURE_BUST_HEIGHT,
                      0.2 * (waist / h - 0.48));
    mus__contour *chest = torso_put_measure(in, TORSO_BUST, bone->bust, MUS_MEASURE_BUST, MUS_MEASURE_BUST_HEIGHT,
                                            torso_mix(in, 0.33, 0.20) * (bust / h - 0.57));
    if (in->sex != MUS_SEX_MALE && in->sex != MUS_SEX_CHILD && bust > high) {
        chest->bump[0] = fmin((bust - high) / 1.8, 0.25 * chest->b);
        chest->bump_angle[0] = mus__atan2(0.5 * torso_value(in, MUS_MEASURE_BUST_SPAN), chest->b);
    }
    torso_put_measure(in, TORSO_ARMPIT, bone->armpit, MUS_MEASURE_HIGH_BUST, MUS_MEASURE_SCYE_DEPTH, 0.0);
}


/* from the middle of the armhole to the nape: breadths at the shoulders, girths at the neck */
static void torso_shoulders(const torso_input *in)
{
    const mus__skeleton *bone = in->bone;
    double neck = torso_value(in, MUS_MEASURE_NECK), across = torso_value(in, MUS_MEASURE_ACROSS_BACK);
    double slope_x = bone->neck_side_x + 0.42 * (bone->shoulder_x - bone->neck_side_x);

    torso_put(in, TORSO_ARMHOLE, 0.5 * (bone->armpit + bone->shoulder), fmax(0.49 * across, 0.90 * bone->shoulder_x),
              0.0);
    mus__contour *shoulder = torso_put(in, TORSO_SHOULDER, bone->shoulder, bone->shoulder_x, 0.0);
    shoulder->height = MUS_MEASURE_SHOULDER_SLOPE;
    torso_put(in, TORSO_SLOPE, bone->shoulder + 0.57 * (bone->neck_side - bone->shoulder), slope_x, 0.0);
    torso_put_measure(in, TORSO_NECK, bone->neck_side, MUS_MEASURE_NECK, MUS_MEASURE_NECK, 0.0);
    mus__contour *nape = torso_put_girth(in, TORSO_NAPE, bone->nape, torso_mix(in, 0.89, 0.915) * neck, 0.0);
    nape->height = MUS_MEASURE_NAPE_HEIGHT;
}


/* chin, jaw and brow, and the ellipsoid from the brow to the crown */
static void torso_head(const torso_input *in)
{
    const mus__skeleton *bone = in->bone;
    double head = torso_value(in, MUS_MEASURE_HEAD), top = bone->crown - bone->brow;

    /* a small child's face below the brow is small: girths of chin and jaw grow with it */
    mus__contour *chin = torso_put_girth(in, TORSO_CHIN, bone->nape + 0.45 * (bone->jaw - bone->nape),
                                         (0.58 + 0.11 * in->grown) * head, 0.0);
    mus__contour *jaw = torso_put_girth(in, TORSO_JAW, bone->jaw, (0.75 + 0.04 * in->grown) * head, 0.0);
    chin->fine = jaw->fine = true;
    torso_put_measure(in, TORSO_BROW, bone->brow, MUS_MEASURE_HEAD, MUS_MEASURE_STATURE, 0.0);

    /* at the part u of the way from brow to crown an ellipsoid has sqrt(1 - u^2) of the brow's girth */
    static const double steps[] = {0.40, 0.68, 0.86};
    static const char *const names[] = {"head_low", "head_mid", "head_top"};
    for (int i = 0; i < 3; i++) {
        double u = steps[i];
        mus__contour *contour =
            torso_put_girth(in, TORSO_BROW, bone->brow + u * top, sqrt(1.0 - u * u) * head, 0.04 * u);
        contour->name = names[i];
        contour->cb *= 1.0 - 0.2 * u;
    }
    in->limb->pole[1] = bone->crown;
}


void mus__limb_torso(const mus_tape *tape, const mus__skeleton *skeleton, mus__limb *limb)
{
    torso_input in = {tape, skeleton, limb, mus_tape_sex(tape), skeleton->crown, 1.0};
    if (in.sex == MUS_SEX_CHILD) in.grown = fmin(fmax((in.h - 0.56) / 1.08, 0.0), 1.0);

    memset(limb, 0, sizeof *limb);
    limb->name = "torso";
    limb->end[0] = MUS_MEASURE_INLEG, limb->end[1] = MUS_MEASURE_STATURE;
    limb->side[0] = 1.0, limb->front[2] = -1.0, limb->axis[1] = 1.0;
    torso_seat(&in);
    torso_chest(&in);
    torso_shoulders(&in);
    torso_head(&in);
}
