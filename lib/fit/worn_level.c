/*
 * worn_level.c: does the garment hang where the pattern puts it? Shoulders, hoods, waists and tops, hems.
 *
 * Everything is counted from the arrangement, in which the panels stand at the heights that they are drawn for, not
 * from the cloth after sewing.
 *
 * Shoulder: a neck opening beside an opening of its own for the arm has cloth between the two, a strap or a shoulder.
 * The loop of the neck passes over that arm's side from front to back where the strap lies. It may pass no farther out
 * than the end of the shoulder, unless the pattern puts it there.
 * Hood: the way up from the crown is closed by cloth, the way forwards is open, and no cloth is before the eyes.
 * Low: an opening for both arms and the head (a waist, a strapless top) stands at the level at which the pattern puts
 * it, or at the first one below where the trunk is as wide as the opening is long. One above the bust stays above it.
 * One that is wider than all of the trunk below, as the waist of trousers that only the crotch holds, stays where it
 * is put.
 * Rolled up: an opening of the legs is above the bust, of a garment that reaches above the waist (the band of a short
 * top may sit at the waist though it is drawn at the hip); of a skirt or trousers it is higher than half of the way
 * from where the pattern puts it to the top.
 */
#include <math.h>
#include <stdio.h>

#include "fit/worn_internal.h"
#include "geom/vec.h"
#include "selfcontact/crossing_count.h"

/* all chosen; the table of garments made wrong on purpose (tests/study/worn) shows which are told when they change */
#define HANG_SHOULDER 0.02 /* [m] past the end of the shoulder: half of a narrow strap */
#define HANG_LOW 0.08      /* [m] below what carries an opening; the slide at which mus_drape_settle() gives up */
#define HANG_ROLLED 0.5    /* of the height of a skirt or trousers */
#define HANG_LOOK 0.5      /* [m] from between the eyes forwards: beyond every hood */
#define HANG_ARMS (1 << MUS_WORN_ARM_LEFT | 1 << MUS_WORN_ARM_RIGHT)
#define HANG_LEGS (1 << MUS_WORN_LEG_LEFT | 1 << MUS_WORN_LEG_RIGHT)


/* mean height of a loop at places x, along the trunk [m] */
static double hang_height(const mus__worn_call *call, int32_t loop, const double *x)
{
    const mus__worn_loop *own = &call->loops.loop[loop];
    double sum = 0.0;
    for (int32_t i = 0; i < own->count; i++)
        sum += mus__dot3(call->axes.up, x + 3 * (ptrdiff_t)call->loops.node[own->first + i]);
    return sum / own->count;
}


/* how far from the middle plane a loop passes over the arm, from front to back or back, at places x [m]: the farthest
 * of its passes on the side of `arm` above the axis of the shoulder; below 0 without any */
static double hang_pass(const mus__worn_call *call, int32_t loop, int32_t arm, const double *x)
{
    const mus__worn_axes *axes = &call->axes;
    const mus__worn_loop *own = &call->loops.loop[loop];
    const double *joint = axes->point[arm][axes->count[arm] > 3 ? 3 : axes->count[arm] - 1];
    const double *chest = axes->point[arm][0], sign = arm == MUS_WORN_ARM_LEFT ? 1.0 : -1.0;
    const double under = fmin(mus__dot3(axes->up, joint), mus__dot3(axes->up, chest));
    double most = -1.0;
    for (int32_t i = 0; i < own->count; i++) {
        const double *a = x + 3 * (ptrdiff_t)call->loops.node[own->first + i];
        const double *b = x + 3 * (ptrdiff_t)call->loops.node[own->first + (i + 1) % own->count];
        const double p = mus__dot3(axes->front, a) - mus__dot3(axes->front, joint);
        const double q = mus__dot3(axes->front, b) - mus__dot3(axes->front, joint);
        if ((p >= 0.0) == (q >= 0.0)) continue;
        const double t = p / (p - q);
        double place[3];
        for (int32_t d = 0; d < 3; d++) place[d] = a[d] + t * (b[d] - a[d]);
        if (mus__dot3(axes->up, place) < under) continue;
        const double out = sign * (mus__dot3(axes->left, place) - mus__dot3(axes->left, chest));
        most = fmax(most, out);
    }
    return most;
}


/* neck openings that pass over the arm beyond the shoulder */
static void hang_shoulders(const mus__worn_call *call, int32_t loop)
{
    const mus__worn_axes *axes = &call->axes;
    const int32_t expect = call->loops.loop[loop].expect;
    double neck;
    const double end = mus__scene_shoulder(call->drape, &neck);
    if ((expect >> MUS_WORN_NECK & 1) == 0 || !(end > 0.0)) return;
    for (int32_t arm = MUS_WORN_ARM_LEFT; arm <= MUS_WORN_ARM_RIGHT; arm++) {
        if (axes->count[arm] == 0 || (expect >> arm & 1)) continue;
        const double now = hang_pass(call, loop, arm, call->x), meant = hang_pass(call, loop, arm, call->placed);
        if (!(now > end + HANG_SHOULDER) || !(meant < end + HANG_SHOULDER)) continue;
        char text[128];
        snprintf(text, sizeof text, "off the %s shoulder by %.0f mm", arm == MUS_WORN_ARM_LEFT ? "left" : "right",
                 1000.0 * (now - end));
        mus__worn_note(call, MUS_WORN_SHOULDER, arm, loop, MUS_NONE, now - end, text);
    }
}


/* a hood whose cloth is before the eyes */
static void hang_over(const mus__worn_call *call, int32_t loop)
{
    const mus_cloth *cloth = call->drape->cloth;
    mus__head head;
    double ahead[3];
    mus__worn_head(call->body, &call->axes, &head);
    for (int32_t d = 0; d < 3; d++) ahead[d] = head.eyes[d] + HANG_LOOK * head.front[d];
    for (int32_t k = 0; k < cloth->ntriangle && head.there; k++) {
        const int32_t *v = cloth->triangle + 3 * (ptrdiff_t)k;
        const double *a = call->x + 3 * (ptrdiff_t)v[0], *b = call->x + 3 * (ptrdiff_t)v[1];
        const double *c = call->x + 3 * (ptrdiff_t)v[2];
        if (!mus__segment_meets_triangle(head.eyes, ahead, a, b, c)) continue;
        mus__worn_note(call, MUS_WORN_HOOD, MUS_WORN_NECK, loop, v[0], 0.0, "the hood hangs over the eyes");
        return;
    }
}


/* hoods: the way up from the crown closed, the way forwards open */
static void hang_hood(const mus__worn_call *call, int32_t loop)
{
    const mus__worn_loop *own = &call->loops.loop[loop];
    int32_t link[MUS_WORN_LIMBS][MUS__WORN_WAYS], common = 0;
    if (!own->over) return;
    mus__worn_link(&call->axes, &call->loops, loop, call->x, link);
    mus__worn_agree(&call->axes, own, own->sign, link, &common);
    if (own->sign * link[MUS_WORN_NECK][0] - common != 0)
        mus__worn_note(call, MUS_WORN_HOOD, MUS_WORN_NECK, loop, MUS_NONE, 0.0, "the hood is not on the head");
    hang_over(call, loop);
}


/* length of a tape round the trunk at a height [m]: between the two contours beside it; 0 below the trunk */
static double hang_girth(const mus__worn_call *call, double height)
{
    double below = -INFINITY, above = INFINITY, low = 0.0, high = 0.0;
    const int32_t torso = 0;
    for (int32_t k = 0; k < mus_body_contour_count(call->body, torso); k++) {
        double centre[3];
        const double girth = mus__worn_contour(call->body, torso, k, centre), at = mus__dot3(call->axes.up, centre);
        if (girth == 0.0) continue;
        if (at <= height && at > below) below = at, low = girth;
        if (at > height && at < above) above = at, high = girth;
    }
    if (!(above < INFINITY) || !(below > -INFINITY)) return low;
    return low + (high - low) * (height - below) / (above - below);
}


/* openings of the trunk that have slid lower than what carries them */
static void hang_low(const mus__worn_call *call, int32_t loop)
{
    const mus__worn_loop *own = &call->loops.loop[loop];
    if ((own->expect & HANG_ARMS) != HANG_ARMS || (own->expect & HANG_LEGS) != 0) return;
    const double meant = hang_height(call, loop, call->placed), now = hang_height(call, loop, call->x);
    /* a top that stands above the bust hangs on it, however wide it is */
    const double bust = mus__dot3(call->axes.up, call->axes.point[MUS_WORN_NECK][0]);
    const double least = meant > bust ? fmax(now, bust) : now;
    double carried = meant;
    while (carried > least && hang_girth(call, carried) < own->length) carried -= 0.01;
    const bool nowhere = meant <= bust && !(carried > least);
    const double level = nowhere ? meant : carried;
    if (!(now < level - HANG_LOW)) return;
    char text[128];
    snprintf(text, sizeof text, "an opening of %.0f mm hangs %.0f mm below where %s", 1000.0 * own->length,
             1000.0 * (level - now), nowhere ? "it is put, and the body carries it nowhere" : "the body carries it");
    mus__worn_note(call, MUS_WORN_LOW, MUS_NONE, loop, MUS_NONE, level - now, text);
}


/* openings of the legs that have come up */
static void hang_rolled(const mus__worn_call *call, int32_t loop)
{
    const mus__worn_loop *own = &call->loops.loop[loop];
    if ((own->expect & HANG_LEGS) == 0 || (own->expect & 1 << MUS_WORN_NECK) != 0) return;
    const double meant = hang_height(call, loop, call->placed), now = hang_height(call, loop, call->x);
    double top = -INFINITY;
    for (int32_t l = 0; l < call->loops.nloop; l++)
        if (call->loops.loop[l].component == own->component && call->loops.loop[l].expect != 0)
            top = fmax(top, hang_height(call, l, call->placed));
    if (!(top > meant)) return;
    const double bust = mus__dot3(call->axes.up, call->axes.point[MUS_WORN_NECK][0]);
    top = fmin(top, mus__dot3(call->axes.up, call->axes.shoulders));
    double waist[3];
    const bool upper = mus_body_landmark(call->body, MUS_LANDMARK_WAIST, waist) == MUS_OK &&
                       top > mus__dot3(call->axes.up, waist) + HANG_LOW;
    if (!(now > (upper ? fmax(meant, bust) : meant + HANG_ROLLED * (top - meant)))) return;
    char text[128];
    snprintf(text, sizeof text, "rolled up by %.0f mm", 1000.0 * (now - meant));
    mus__worn_note(call, MUS_WORN_ROLLED, MUS_NONE, loop, MUS_NONE, now - meant, text);
}


void mus__worn_levels(const mus__worn_call *call)
{
    for (int32_t l = 0; l < call->loops.nloop; l++) hang_shoulders(call, l);
    for (int32_t l = 0; l < call->loops.nloop; l++) hang_hood(call, l);
    for (int32_t l = 0; l < call->loops.nloop; l++) hang_low(call, l);
    for (int32_t l = 0; l < call->loops.nloop; l++) hang_rolled(call, l);
}
