/*
 * body_make.c: the steps that all kinds of body share: options, limbs to surface and radius fields, destruction.
 *
 * Called by body.c for the limbs of a tape, by body_from_limbs.c for limbs of the caller and by body_copy.c for copies.
 */
#include <math.h>

#include "body/body_make.h"
#include "geom/vec.h"

/* rings of the chest are closer by this part: neck and shoulders bend within a few millimetres, and the fillet of an
 * armpit is steep. Measured: what the table's own chords miss falls from 0.8 to 0.2 mm */
#define MAKE_CHEST 0.5

/* arms, legs and feet have half the samples of the torso, but not fewer than this; measured: 64 directions of the
 * diamond angle are chords within 0.1 mm of an arm and 0.2 mm of a thigh */
#define MAKE_THIN 64

/* most limbs added to those of a tape: with its 15 parts they fit MUS__PARTS_MOST */
#define MAKE_ADDED 48


void mus_body_def_init(mus_body_def *def, size_t size)
{
    mus_body_def own = {.samples = 128, .ring_spacing = 0.015};
    mus__def_init(def, size, &own, sizeof own);
}


mus_status mus__body_read_def(mus_context *context, const mus_body_def *def, mus_body_def *own)
{
    mus_body_def_init(own, sizeof *own);
    mus_status status = MUS_OK;
    if (def != NULL) status = mus__def_read(context, own, sizeof *own, sizeof *own, def, "mus_body_def");
    if (status != MUS_OK) return status;
    if (own->samples < 16 || own->samples > MUS__CONTOUR_SAMPLES || own->samples % 4 != 0)
        return mus__fail(context, MUS_ERR_ARG, "samples %d is not a multiple of 4 in 16 to %d", (int)own->samples,
                         MUS__CONTOUR_SAMPLES);
    if (!(own->ring_spacing >= 0.001 && own->ring_spacing <= 0.1))
        return mus__fail(context, MUS_ERR_ARG, "ring_spacing %g m is outside 0.001 to 0.1 m", own->ring_spacing);
    if (own->without < 0 || own->without > MUS_WITHOUT_ALL)
        return mus__fail(context, MUS_ERR_ARG, "without is %d, expected a sum of MUS_WITHOUT_*", (int)own->without);
    if (own->limbs < 0 || own->limbs > MAKE_ADDED || (own->limbs > 0 && own->limb == NULL))
        return mus__fail(context, MUS_ERR_ARG, "%d limbs are added, expected 0 to %d, with mus_body_def.limb",
                         (int)own->limbs, MAKE_ADDED);
    return MUS_OK;
}


/* whether limb l is an arm, a leg or a foot of a tape */
static bool make_is_thin(const mus_body *body, int32_t l)
{
    return body->measured && l > MUS__LIMB_TORSO && l < MUS__LIMB_COUNT;
}


int32_t mus__body_samples(const mus_body *body, int32_t l)
{
    const int32_t n = body->def.samples, half = n / 8 * 4;
    if (!make_is_thin(body, l) || n <= MAKE_THIN) return n;
    return half > MAKE_THIN ? half : MAKE_THIN;
}


int32_t mus__body_angles(const mus_body *body, int32_t l)
{
    const int32_t n = mus__body_samples(body, l), least = make_is_thin(body, l) ? MAKE_THIN : MUS__FIELD_ANGLES;
    return n > least ? n : least;
}


double mus__cubic_step(double t)
{
    t = fmin(fmax(t, 0.0), 1.0);
    return t * t * (3.0 - 2.0 * t);
}


mus_status mus__body_limbs(mus_body *body, int32_t count)
{
    if (body->kept == NULL) body->kept = mus__new(body->context, 1, sizeof *body->kept);
    if (body->kept == NULL) return mus__fail_memory(body->context, "a body");
    body->kept->users++;
    body->limb = mus__new(body->context, count, sizeof *body->limb);
    if (body->limb == NULL) return mus__fail_memory(body->context, "the limbs of a body");
    body->limb_count = count;
    return MUS_OK;
}


/* append the fields of right limb l of a symmetric body, without their radii */
static mus_status make_mirrored(mus_body *body, int32_t l)
{
    mus_status status = MUS_OK;
    const int32_t parts = body->limb[l].cuts + 1;
    body->limb[l].samples = body->limb[l - 1].samples;
    for (int32_t i = 0; i < parts && status == MUS_OK; i++) {
        const int32_t p = body->nfield;
        status = mus__field_like(body->context, &body->limb[l], &body->field[p - parts], &body->field[p]);
        if (status == MUS_OK) body->nfield = p + 1;
    }
    return status;
}


/* append the fields of the parts of limb l; rings about `spacing` [m] apart */
static mus_status make_fields(mus_body *body, int32_t l, double spacing)
{
    mus__stack stack;
    double turn[2 * MUS__FIELD_MOST];
    const int32_t n = mus__body_angles(body, l);
    body->limb[l].samples = mus__body_samples(body, l);
    if (body->limb[l].gone) return MUS_OK;
    if (mus__body_is_even(body) && mus__limb_is_right(l)) return make_mirrored(body, l);
    mus__field_turns(n, turn);
    mus_status status = mus__stack_make(body->context, &body->limb[l], n, turn, &stack);
    if (status != MUS_OK) return status;
    mus__stack_limit(&stack, &body->limb[l]);
    while (status == MUS_OK && body->nfield < body->rig.parts && body->rig.part[body->nfield].limb == l) {
        const int32_t p = body->nfield;
        const mus__part *part = &body->rig.part[p];
        const bool chest = body->measured && l == MUS__LIMB_TORSO && part->joint == MUS_JOINT_LUMBAR;
        status = mus__field_make(body->context, &stack, part, chest ? MAKE_CHEST * spacing : spacing, &body->field[p]);
        if (status == MUS_OK) body->nfield = p + 1;
    }
    mus__stack_free(body->context, &stack);
    return status;
}


mus_status mus__body_fields(mus_body *body, double spacing)
{
    mus__rig_make(body, &body->rig);
    body->field = mus__new(body->context, body->rig.parts, sizeof *body->field);
    if (body->field == NULL) return mus__fail_memory(body->context, "contact fields");

    mus_status status = MUS_OK;
    for (int32_t l = 0; l < body->limb_count && status == MUS_OK; l++) status = make_fields(body, l, spacing);
    return status;
}


void mus__body_release(mus_body *body)
{
    for (int32_t l = 0; l < body->nfield; l++) mus__field_free(body->context, &body->field[l]);
    mus__free(body->context, body->field);
    mus__free(body->context, body->vertices);
    mus__free(body->context, body->normals);
    mus__free(body->context, body->ring);
    mus__free(body->context, body->crease);
    mus__free(body->context, body->triangles);
    body->field = NULL, body->nfield = 0;
    body->vertices = body->normals = body->ring = NULL, body->triangles = NULL;
    body->crease = NULL, body->creases = 0;
    body->vertex_count = body->triangle_count = body->digit_vertices = body->digit_triangles = 0;
}


void mus_body_destroy(mus_body *body)
{
    if (body == NULL) return;
    if (body->kept != NULL && --body->kept->users <= 0) {
        if (body->kept->data != NULL) body->kept->destroy(body->kept->data);
        mus__free(body->context, body->kept);
    }
    mus__body_release(body);
    mus__free(body->context, body->frame);
    mus__free(body->context, body->limb);
    mus__free(body->context, body->outline);
    mus__free(body->context, body);
}
