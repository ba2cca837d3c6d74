/*
 * contour.c: inside and outside of contours that lie beside and over each other (case C4).
 *
 * Two questions are asked apart. Whether contact answers rightly: the curve that it asks at a height is known in closed
 * form (curve.h), and a point is inside where the winding number of a limb's curve is not 0; half of the points
 * are drawn over the picture, half at 1e-12 to 1e-3 m from a curve, on both sides, and only what is within 1e-12 m of
 * one is left out. And how far that curve is from the outline that was given: it goes through the outline in 128
 * directions, between which a corner is cut. That is the price of a query whose cost knows nothing of corners, and is
 * told in millimetres rather than hidden in a wider band.
 *
 * The scenes: two legs of two lobes each, which are apart; and an armpit, a trunk, an arm and a shoulder above them,
 * whose union is not star-shaped about any point, as limbs that lie over each other. No outline is convex.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "curve.h"
#include "limbs.h"

#define CORNERS 192 /* as of a scan */
#define POINTS 1000000
#define BAND 1e-12
#define MOST_LIMBS 3

/* an outline r = size (1 + wave cos(lobes (t - turned))), stretched; star-shaped as any such, concave by its waves */
typedef struct lobed {
    double centre[2], stretch[2];
    double size, wave, turned;
    int lobes;
} lobed;

typedef struct contours {
    const char *name;
    int limbs;
    lobed limb[MOST_LIMBS];
    double room[4]; /* middle and half sides of the picture */
} contours;

static const contours scenes[2] = {
    {"two legs",
     2,
     {{{-0.11, 0.0}, {1.0, 1.0}, 0.07, 0.357, 2.3, 2}, {{0.11, 0.0}, {1.0, 1.0}, 0.07, 0.357, 1.1, 2}},
     {0.0, 0.0, 0.22, 0.11}},
    {"an armpit",
     3,
     {{{-0.10, -0.02}, {1.0, 2.2}, 0.06, 0.1, 0.4, 5},
      {{0.11, -0.04}, {0.7, 2.4}, 0.05, 0.12, 1.0, 4},
      {{0.0, 0.10}, {2.8, 0.8}, 0.06, 0.18, 0.2, 3}},
     {0.0, 0.0, 0.24, 0.22}}};

typedef struct contour_set {
    double outline[MOST_LIMBS][4 * CORNERS], rows[MOST_LIMBS][12];
    curve seen[MOST_LIMBS];
    mus_limb limb[MOST_LIMBS];
} contour_set;


static void draw_lobes(const lobed *l, double *outline)
{
    for (int i = 0; i < CORNERS; i++) {
        const double turn = 2.0 * PI * i / CORNERS, r = l->size * (1.0 + l->wave * cos(l->lobes * (turn - l->turned)));
        outline[2 * i] = l->stretch[0] * r * cos(turn), outline[2 * i + 1] = l->stretch[1] * r * sin(turn);
    }
    memcpy(outline + 2 * CORNERS, outline, 2 * CORNERS * sizeof(double));
}


/* corners that turn inwards */
static int hollows(const double *outline)
{
    int count = 0;
    for (int i = 0; i < CORNERS; i++) {
        const double *p = outline + 2 * i, *q = p + 2, *r = outline + 2 * ((i + 2) % CORNERS);
        count += (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0]) < -1e-9;
    }
    return count;
}


static void draw_contours(const contours *scene, contour_set *out)
{
    for (int l = 0; l < scene->limbs; l++) {
        const lobed *own = &scene->limb[l];
        draw_lobes(own, out->outline[l]);
        curve_make(CORNERS, out->outline[l], own->centre, &out->seen[l]);
        out->limb[l] = limb_roller(own->centre[0], own->centre[1], 0.1, 0.1, 2.0, out->rows[l]);
        out->limb[l].corners = CORNERS, out->limb[l].outline = out->outline[l];
    }
}


/* a point of the picture, or one beside a curve */
static void draw_point(const contours *scene, const contour_set *set, int64_t k, uint64_t *random, double *p)
{
    p[2] = 0.1;
    if (k % 2 == 0) {
        for (int i = 0; i < 2; i++) p[i] = scene->room[i] + scene->room[2 + i] * (2.0 * limb_random(random) - 1.0);
        return;
    }
    const int l = (int)(limb_random(random) * scene->limbs), arc = (int)(limb_random(random) * CURVE_ARCS);
    const double w = limb_random(random), off = pow(10.0, -12.0 + 9.0 * limb_random(random));
    curve_point(&set->seen[l], arc, w, k % 4 == 1 ? off : -off, p);
}


/* points on the wrong side of the curves */
static mus_status ask_contours(const contours *scene, const contour_set *set, const mus_drape *drape, double *wrong)
{
    uint64_t random = 3;
    mus_status status = MUS_OK;
    *wrong = 0.0;
    for (int64_t k = 0, asked = 0; asked < POINTS && status == MUS_OK; k++) {
        double p[3], depth;
        bool in_band = false;
        int turns = 0;
        draw_point(scene, set, k, &random, p);
        for (int l = 0; l < scene->limbs; l++) turns += curve_winds(&set->seen[l], p, BAND, &in_band);
        if (in_band) continue;
        asked++;
        status = mus_drape_depth(drape, 1, p, &depth, NULL);
        *wrong += (depth > 0.0) != (turns != 0);
    }
    return status;
}


static void side_of_contours(verify *v, const contours *scene)
{
    static const double far[3] = {0.0, 0.0, 5.0}, still[3] = {0.0, 0.0, 0.0};
    contour_set set;
    double wrong = 1.0, apart = 0.0, plain = 0.0;
    char text[100];
    mus_body *body = NULL;
    mus_drape *drape = NULL;
    draw_contours(scene, &set);
    mus_status status = mus_body_create_limbs(v->context, scene->limbs, set.limb, NULL, &body);
    if (status == MUS_OK) status = limb_meet_point(v, body, 0.0, 0.0, far, still, &drape);
    if (status == MUS_OK) status = ask_contours(scene, &set, drape, &wrong);
    for (int l = 0; l < scene->limbs; l++) {
        apart = fmax(apart, curve_apart(&set.seen[l], CORNERS, set.outline[l]));
        plain += hollows(set.outline[l]) == 0;
    }
    snprintf(text, sizeof text, "%s: wrong of 1e6 points, half of them 1e-12 to 1e-3 m off", scene->name);
    limb_row(v, status, "C4", text, 0.0, wrong, 0.0);
    snprintf(text, sizeof text, "%s: what contact asks, off the given outlines [m]", scene->name);
    limb_row(v, status, "C4", text, 0.0, apart, 1e-3);
    snprintf(text, sizeof text, "%s: outlines without a hollow", scene->name);
    limb_row(v, status, "C4", text, 0.0, plain, 0.0);
    mus_drape_destroy(drape);
    mus_body_destroy(body);
}


void verify_contours(verify *v)
{
    side_of_contours(v, &scenes[0]);
    side_of_contours(v, &scenes[1]);

    /* a side that turns back is refused when set */
    contour_set set;
    mus_body *body = NULL;
    draw_contours(&scenes[0], &set);
    memmove(set.outline[0] + 2, set.outline[0] + 20, 2 * sizeof(double));
    const mus_status status = mus_body_create_limbs(v->context, 1, set.limb, NULL, &body);
    verify_add(v, "C4", "an outline that is not star-shaped: 0 when refused", 0.0, status == MUS_ERR_BODY ? 0.0 : 1.0,
               0.0);
    mus_body_destroy(body);
}
