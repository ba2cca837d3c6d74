/*
 * body_from_limbs.c: a body of limbs whose contours the caller gives, without a tape.
 *
 * Each limb is a stack of superellipses or outlines on a straight axis. Its frame, contours and poles are checked here;
 * body_make.c makes surface and radius fields from them. Such a body has no measures and no landmarks. It is used for
 * forms, dummies, single limbs and scans, and in tests for solids whose volume and depth are known.
 */
#include <math.h>
#include <string.h>

#include "body/body_make.h"
#include "geom/vec.h"

#define GIVEN_LIMBS 64    /* most limbs: MUS__PARTS_MOST */
#define GIVEN_GAP 1e-5    /* least distance of two contours, and of an end contour from its pole [m]; chosen */
#define GIVEN_RINGS 400.0 /* least number of rings of the radius field along a limb; chosen */


void mus_limb_init(mus_limb *limb, size_t size)
{
    mus_limb own = {.name = "limb", .axis = {0.0, 1.0, 0.0}, .side = {1.0, 0.0, 0.0}};
    mus__def_init(limb, size, &own, sizeof own);
}


/* check that a number of limb l is within low to high. Errors: MUS_ERR_ARG */
static mus_status given_number(mus_context *context, int32_t l, const char *what, double value, double low, double high)
{
    if (value >= low && value <= high) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "limb %d: %s is %g, expected %g to %g", (int)l, what, value, low, high);
}


/* read the frame of limb l: unit axis, side made square to it, front = axis x side. Errors: MUS_ERR_ARG */
static mus_status given_frame(mus_context *context, int32_t l, const mus_limb *from, mus__limb *to)
{
    mus_status status = MUS_OK;
    for (int i = 0; i < 3 && status == MUS_OK; i++) {
        status = given_number(context, l, "origin", from->origin[i], -1e3, 1e3);
        if (status == MUS_OK) status = given_number(context, l, "axis", from->axis[i], -1e3, 1e3);
        if (status == MUS_OK) status = given_number(context, l, "side", from->side[i], -1e3, 1e3);
        to->origin[i] = from->origin[i], to->axis[i] = from->axis[i], to->side[i] = from->side[i];
    }
    if (status != MUS_OK) return status;

    mus__unit3(to->axis);
    mus__unit3(to->side);
    double along = mus__dot3(to->side, to->axis);
    for (int i = 0; i < 3; i++) to->side[i] -= along * to->axis[i];
    if (mus__norm3(to->axis) < 0.5 || mus__norm3(to->side) < 1e-3)
        return mus__fail(context, MUS_ERR_ARG, "limb %d: axis or side is zero, or they are parallel", (int)l);
    mus__unit3(to->side);
    mus__cross3(to->axis, to->side, to->front);
    return MUS_OK;
}


/* read the contours and poles of limb l. Errors: MUS_ERR_ARG, MUS_ERR_BODY (they do not ascend) */
static mus_status given_contours(mus_context *context, int32_t l, const mus_limb *from, mus__limb *to)
{
    static const struct {
        const char *what;
        double low, high;
    } row[6] = {{"s of a contour", -100, 100},          {"centre of a contour", -100, 100},
                {"centre of a contour", -100, 100},     {"half breadth of a contour", 1e-4, 100},
                {"half depth of a contour", 1e-4, 100}, {"exponent of a contour", 1, 16}};
    mus_status status = MUS_OK;
    to->count = from->contours;
    for (int32_t i = 0; i < to->count; i++) {
        const double *c = from->contour + 6 * (ptrdiff_t)i;
        for (int k = 0; k < (from->corners != 0 ? 3 : 6) && status == MUS_OK; k++)
            status = given_number(context, l, row[k].what, c[k], row[k].low, row[k].high);
        if (status != MUS_OK) return status;
        if (i > 0 && !(c[0] >= c[-6] + GIVEN_GAP))
            return mus__fail(context, MUS_ERR_BODY, "limb %d: contour %d at s = %g m is not above contour %d at %g m",
                             (int)l, (int)i, c[0], (int)i - 1, c[-6]);
        to->contour[i] = (mus__contour){.name = "contour",
                                        .girth = MUS_NONE,
                                        .height = MUS_NONE,
                                        .hard = true,
                                        .s = c[0],
                                        .ca = c[1],
                                        .cb = c[2],
                                        .a = c[3],
                                        .b = c[4],
                                        .n = c[5]};
    }

    for (int k = 0; k < 2 && status == MUS_OK; k++) status = given_number(context, l, "pole", from->pole[k], -100, 100);
    if (status != MUS_OK) return status;
    const double low = to->contour[0].s - from->pole[0], high = from->pole[1] - to->contour[to->count - 1].s;
    to->pole[0] = from->pole[0], to->pole[1] = from->pole[1];
    if (low >= GIVEN_GAP && high >= GIVEN_GAP) return MUS_OK;
    return mus__fail(context, MUS_ERR_BODY,
                     "limb %d: poles are at s = %g and %g m, expected outside the contours, which are at %g to %g m",
                     (int)l, from->pole[0], from->pole[1], to->contour[0].s, to->contour[to->count - 1].s);
}


mus_status mus__body_given_limb(mus_context *context, int32_t l, const mus_limb *from, mus__limb *to)
{
    if (from->size != sizeof *from)
        return mus__fail(context, MUS_ERR_VERSION, "limb %d: size unknown; use mus_limb_init", (int)l);
    if (from->contours < 2 || from->contours > MUS__LIMB_CONTOURS || from->contour == NULL)
        return mus__fail(context, MUS_ERR_ARG, "limb %d: %d contours, expected 2 to %d", (int)l, (int)from->contours,
                         MUS__LIMB_CONTOURS);
    if (from->joint < 0 || from->joint >= MUS_JOINT_COUNT)
        return mus__fail(context, MUS_ERR_ARG, "limb %d: joint %d is not one of 0 to %d", (int)l, (int)from->joint,
                         MUS_JOINT_COUNT - 1);
    mus_status status = given_frame(context, l, from, to);
    if (status == MUS_OK) status = given_contours(context, l, from, to);
    if (status != MUS_OK) return status;

    /* a long name is cut */
    const char *name = from->name != NULL ? from->name : "limb";
    for (int i = 0; i + 1 < MUS__LIMB_NAME_BYTES && name[i] != '\0'; i++) to->own_name[i] = name[i];
    to->name = to->own_name;
    to->joint = from->joint;
    to->end[0] = to->end[1] = MUS_NONE;
    return MUS_OK;
}


/* set the bones of a scan, and the number of joints that cut each limb; a scanned form has none */
static void given_bones(mus_body *body, const mus__bones *bones)
{
    static const int32_t cuts[MUS__LIMB_COUNT] = {
        [MUS__LIMB_TORSO] = 2, [MUS__LIMB_ARM_LEFT] = 3, [MUS__LIMB_ARM_RIGHT] = 3,
        [MUS__LIMB_LEG_LEFT] = 2, [MUS__LIMB_LEG_RIGHT] = 2};
    body->scanned = true;
    if (bones->limb[MUS__LIMB_TORSO] == MUS_NONE) return;
    body->jointed = true;
    body->bones = *bones;
    body->skeleton = bones->skeleton;
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++)
        if (bones->limb[l] != MUS_NONE) body->limb[bones->limb[l]].cuts = cuts[l];
}


/* limbs, surface, fields and skin; rings of the fields as close as the shortest limb needs */
static mus_status given_make(mus_body *body, int32_t limbs, const mus_limb *limb, const mus__bones *bones)
{
    mus_status status = mus__body_limbs(body, limbs);
    double spacing = 0.25 * body->def.ring_spacing;
    for (int32_t l = 0; l < limbs && status == MUS_OK; l++) {
        status = mus__body_given_limb(body->context, l, &limb[l], &body->limb[l]);
        spacing = fmin(spacing, (limb[l].pole[1] - limb[l].pole[0]) / GIVEN_RINGS);
        for (int32_t i = 0; body->def.ellipse && i < body->limb[l].count; i++) body->limb[l].contour[i].n = 2.0;
    }
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) body->asked[m] = body->made[m] = NAN;
    if (status == MUS_OK) status = mus__body_outlines(body, 0, limbs, limb);
    if (status != MUS_OK) return status;
    if (bones != NULL) given_bones(body, bones);

    status = mus__body_fields(body, spacing);
    return status == MUS_OK ? mus__body_surface(body) : status;
}


mus_status mus__body_create_jointed(mus_context *context, int32_t limbs, const mus_limb *limb, const mus__bones *bones,
                                    const mus_body_def *def, mus_body **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (limbs < 1 || limbs > GIVEN_LIMBS || limb == NULL)
        return mus__fail(context, MUS_ERR_ARG, "%d limbs of a body, expected 1 to %d", (int)limbs, GIVEN_LIMBS);
    mus_body_def own;
    mus_status status = mus__body_read_def(context, def, &own);
    if (status != MUS_OK) return status;
    if (own.without != 0 || own.limbs != 0 || !mus__posture_none(&own))
        return mus__fail(context, MUS_ERR_ARG, "mus_body_def: without, limbs and posture are for a body of a tape");

    mus_body *body = mus__new(context, 1, sizeof *body);
    if (body == NULL) return mus__fail_memory(context, "a body");
    body->context = context;
    body->def = own;
    status = given_make(body, limbs, limb, bones);
    if (status == MUS_OK)
        *out = body;
    else
        mus_body_destroy(body);
    return status;
}


mus_status mus_body_create_limbs(mus_context *context, int32_t limbs, const mus_limb *limb, const mus_body_def *def,
                                 mus_body **out)
{
    return mus__body_create_jointed(context, limbs, limb, NULL, def, out);
}
