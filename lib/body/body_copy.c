/*
 * body_copy.c: a copy of a body whose parts stand elsewhere.
 *
 * The copy keeps the limbs as they were made, and with them girths and asked and made measures. Its contact fields are
 * those of the rest pose carried by the frames of their parts; its surface is drawn from these fields ring by ring
 * (body_surface.c). A copy of a posed body starts from the rest pose again. Called by lib/pose.
 */
#include <string.h>

#include "body/body_make.h"


/* copy the limbs, and the outlines that their contours point to */
static mus_status copy_limbs(const mus_body *from, mus_body *to)
{
    mus_status status = mus__body_limbs(to, from->limb_count);
    if (status != MUS_OK) return status;
    memcpy(to->limb, from->limb, (size_t)from->limb_count * sizeof *to->limb);

    ptrdiff_t corners = 0;
    for (int32_t l = 0; l < to->limb_count; l++) {
        if (from->limb[l].name == from->limb[l].own_name) to->limb[l].name = to->limb[l].own_name;
        for (int32_t i = 0; i < to->limb[l].count; i++) corners += to->limb[l].contour[i].corners;
    }
    if (corners == 0) return MUS_OK;
    to->outline = mus__new(to->context, 3 * (int64_t)corners, sizeof *to->outline);
    if (to->outline == NULL) return mus__fail_memory(to->context, "the outlines of a body");
    double *next = to->outline;
    for (int32_t l = 0; l < to->limb_count; l++)
        for (int32_t i = 0; i < to->limb[l].count; i++) {
            mus__contour *contour = &to->limb[l].contour[i];
            if (contour->corners == 0) continue;
            memcpy(next, contour->corner, 3 * (size_t)contour->corners * sizeof *next);
            contour->corner = next;
            next += 3 * (ptrdiff_t)contour->corners;
        }
    return MUS_OK;
}


/* copy a field and carry it with its part from the rest pose */
static mus_status copy_field(mus_context *context, const mus__field *from, const mus__limb *limb,
                              const mus__frame *frame, mus__field *to)
{
    const size_t rings = (size_t)from->nring, radii = rings * (size_t)from->nangle;
    *to = *from;
    to->centre = mus__new(context, 2 * (int64_t)rings, sizeof(double));
    to->radius = mus__room(context, (int64_t)radii, sizeof(double));
    to->largest = mus__new(context, (int64_t)rings, sizeof(double));
    if (!to->centre || !to->radius || !to->largest) {
        mus__field_free(context, to);
        return mus__fail_memory(context, "a contact field");
    }
    memcpy(to->centre, from->centre, 2 * rings * sizeof(double));
    memcpy(to->radius, from->radius, radii * sizeof(double));
    memcpy(to->largest, from->largest, rings * sizeof(double));
    mus__part_carry(limb, frame, to);
    return MUS_OK;
}


static mus_status copy_make(const mus_body *from, const mus__frame *frame, mus_body *to)
{
    mus_status status = copy_limbs(from, to);
    if (status != MUS_OK) return status;

    to->frame = mus__new(to->context, to->rig.parts, sizeof *to->frame);
    to->field = mus__new(to->context, from->nfield, sizeof *to->field);
    to->crease = mus__room(to->context, from->creases, sizeof *to->crease);
    if (to->frame == NULL || to->field == NULL || to->crease == NULL)
        return mus__fail_memory(to->context, "a posed body");
    if (from->creases > 0) memcpy(to->crease, from->crease, (size_t)from->creases * sizeof *to->crease);
    to->creases = from->creases;
    memcpy(to->frame, frame, (size_t)to->rig.parts * sizeof *frame);
    for (int32_t p = 0; p < from->nfield && status == MUS_OK; p++) {
        const mus__limb *limb = &to->limb[to->rig.part[p].limb];
        status = copy_field(to->context, &from->field[p], limb, &to->frame[p], &to->field[p]);
        if (status == MUS_OK) to->nfield = p + 1;
    }
    if (status == MUS_OK) status = mus__body_surface(to);
    if (status != MUS_OK) return status;
    if (to->digit_vertices > 0) mus__digit_make(to);
    mus__body_skin(to);
    return MUS_OK;
}


mus_status mus__body_copy(const mus_body *body, const mus__frame *frame, const mus__stance *stance, mus_body **out)
{
    *out = NULL;
    mus_body *copy = mus__new(body->context, 1, sizeof *copy);
    if (copy == NULL) return mus__fail_memory(body->context, "a posed body");

    /* plain data is copied, owned arrays are made anew */
    *copy = *body;
    copy->limb = NULL, copy->limb_count = 0;
    copy->outline = NULL, copy->frame = NULL;
    copy->field = NULL, copy->nfield = 0;
    copy->vertices = copy->normals = NULL, copy->triangles = NULL;
    copy->ring = NULL;
    copy->crease = NULL, copy->creases = 0;
    copy->vertex_count = copy->triangle_count = copy->digit_vertices = copy->digit_triangles = 0;
    copy->stance = *stance;
    const mus_status status = copy_make(body, frame, copy);
    if (status == MUS_OK)
        *out = copy;
    else
        mus_body_destroy(copy);
    return status;
}
