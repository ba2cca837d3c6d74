/*
 * body_make.c: limbs with contours to a body: the second half of making, whoever gave the contours.
 *
 * Stacks between the contours, the surface from the stacks, the contact fields. Called by body.c for the limbs of a
 * tape and by body_given.c for limbs that the caller gives.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"


mus_status mus__body_limbs(mus_body *body, int32_t count)
{
    body->limb = mus__new(body->context, count, sizeof *body->limb);
    if (body->limb == NULL) return mus__fail_memory(body->context, "the limbs of a body");
    body->limb_count = count;
    return MUS_OK;
}


void mus__body_turns(int32_t n, double *turn)
{
    for (int32_t k = 0; k < n; k++) {
        /* cosines and sines of angles below 45 degrees, so that the quarters mirror each other to the last bit */
        int32_t step = k % (n / 4), quarter = k / (n / 4);
        int32_t least = step < n / 4 - step ? step : n / 4 - step;
        double angle = 2.0 * MUS_PI * least / n, more = cos(angle), less = 2 * least == n / 4 ? more : sin(angle);
        double c = least == step ? more : less, s = least == step ? less : more;
        turn[2 * k] = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
        turn[2 * k + 1] = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
    }
}


mus_status mus__body_surface_of(mus_body *body, const double *turn)
{
    mus__stack *stack = mus__new(body->context, body->limb_count, sizeof *stack);
    if (stack == NULL) return mus__fail_memory(body->context, "the stacks of a body");
    mus_status status = MUS_OK;
    for (int32_t l = 0; l < body->limb_count && status == MUS_OK; l++) {
        if (body->limb[l].gone) continue;
        status = mus__stack_make(body->context, &body->limb[l], body->def.samples, turn, &stack[l]);
        if (status == MUS_OK) mus__stack_limit(&stack[l], &body->limb[l]);
    }
    if (status == MUS_OK) status = mus__body_surface(body, stack);
    for (int32_t l = 0; l < body->limb_count; l++) mus__stack_free(body->context, &stack[l]);
    mus__free(body->context, stack);
    return status;
}


/* fields of the parts of limb l, which follow those made so far */
static mus_status make_fields(mus_body *body, int32_t l, const double *turn, double spacing)
{
    mus__stack stack;
    if (body->limb[l].gone) return MUS_OK;
    mus_status status = mus__stack_make(body->context, &body->limb[l], MUS_BODY_ANGLES, turn, &stack);
    if (status != MUS_OK) return status;
    while (status == MUS_OK && body->nfield < body->rig.parts && body->rig.part[body->nfield].limb == l) {
        const int32_t p = body->nfield;
        status = mus__field_make(body->context, &stack, &body->rig.part[p], spacing, &body->field[p]);
        if (status == MUS_OK) body->nfield = p + 1;
    }
    mus__stack_free(body->context, &stack);
    return status;
}


mus_status mus__body_fields(mus_body *body, double spacing)
{
    double turn[2 * MUS_BODY_ANGLES];
    mus__field_turns(MUS_BODY_ANGLES, turn);
    mus__rig_make(body, &body->rig);
    body->field = mus__new(body->context, body->rig.parts, sizeof *body->field);
    if (body->field == NULL) return mus__fail_memory(body->context, "contact fields");

    mus_status status = MUS_OK;
    for (int32_t l = 0; l < body->limb_count && status == MUS_OK; l++) status = make_fields(body, l, turn, spacing);
    return status;
}
