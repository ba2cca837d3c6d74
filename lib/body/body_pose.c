/*
 * body_pose.c: a posed copy of a body.
 *
 * The copy keeps the limbs as they were made, and with them girths and asked and made measures; its contact fields are
 * those of the rest pose carried by the frames of their parts, its surface is made of the same stacks ring by ring
 * (body_surface.c). A copy of a posed body starts from the rest pose again. The identity in the rest pose to rounding.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"


/* limbs, and the outlines that their contours point into */
static mus_status bpose_limbs(const mus_body *from, mus_body *to)
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


/* a copy of a field, carried from where its limb stands at rest */
static mus_status bpose_field(mus_context *context, const mus__field *from, const mus__limb *limb,
                              const mus__frame *frame, mus__field *to)
{
    const size_t rings = (size_t)from->nring, radii = rings * (size_t)from->nangle;
    *to = *from;
    to->centre = mus__new(context, 2 * (int64_t)rings, sizeof(double));
    to->radius = mus__new(context, (int64_t)radii, sizeof(double));
    to->largest = mus__new(context, (int64_t)rings, sizeof(double));
    if (!to->centre || !to->radius || !to->largest) {
        mus__field_free(context, to);
        return mus__fail_memory(context, "a contact field");
    }
    memcpy(to->centre, from->centre, 2 * rings * sizeof(double));
    memcpy(to->radius, from->radius, radii * sizeof(double));
    memcpy(to->largest, from->largest, rings * sizeof(double));
    mus__frame_point(frame, limb->origin, to->origin);
    mus__frame_turn(frame, limb->axis, to->axis);
    mus__frame_turn(frame, limb->side, to->side);
    mus__frame_turn(frame, limb->front, to->front);
    return MUS_OK;
}


static mus_status bpose_make(const mus_body *from, const mus_pose *pose, mus_body *to)
{
    mus__local local[MUS_JOINT_COUNT];
    mus_status status = mus__rig_locals(to->context, &from->rig, pose, local);
    if (status != MUS_OK) return status;
    status = bpose_limbs(from, to);
    if (status != MUS_OK) return status;

    to->frame = mus__new(to->context, to->rig.parts, sizeof *to->frame);
    to->field = mus__new(to->context, from->nfield, sizeof *to->field);
    double *turn = mus__new(to->context, 2 * (int64_t)to->def.samples, sizeof *turn);
    if (to->frame == NULL || to->field == NULL || turn == NULL) {
        mus__free(to->context, turn);
        return mus__fail_memory(to->context, "a posed body");
    }
    mus__rig_frames(&to->rig, local, to->frame);
    for (int32_t p = 0; p < from->nfield && status == MUS_OK; p++) {
        const mus__limb *limb = &to->limb[to->rig.part[p].limb];
        status = bpose_field(to->context, &from->field[p], limb, &to->frame[p], &to->field[p]);
        if (status == MUS_OK) to->nfield = p + 1;
    }
    mus__body_turns(to->def.samples, turn);
    if (status == MUS_OK) status = mus__body_surface_of(to, turn);
    mus__free(to->context, turn);
    return status == MUS_OK ? mus__body_skin(to) : status;
}


mus_status mus_body_pose(const mus_body *body, const mus_pose *pose, mus_body **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (body == NULL) return MUS_ERR_ARG;
    mus_status status = mus_pose_check(body->context, pose);
    if (status != MUS_OK) return status;
    mus_body *copy = mus__new(body->context, 1, sizeof *copy);
    if (copy == NULL) return mus__fail_memory(body->context, "a posed body");

    /* what is plain data; what is owned is made anew */
    *copy = *body;
    copy->limb = NULL, copy->limb_count = 0;
    copy->outline = NULL, copy->frame = NULL;
    copy->field = NULL, copy->nfield = 0;
    copy->vertices = copy->normals = NULL, copy->triangles = NULL;
    copy->ring = copy->skin = copy->skin_normals = NULL;
    copy->vertex_count = copy->triangle_count = copy->digit_vertices = copy->digit_triangles = 0;
    copy->pose = *pose;
    status = bpose_make(body, pose, copy);
    if (status == MUS_OK)
        *out = copy;
    else
        mus_body_destroy(copy);
    return status;
}


mus_status mus_body_rest_pose(const mus_body *body, mus_pose *pose)
{
    if (body == NULL || pose == NULL) return MUS_ERR_ARG;
    mus_pose_init(pose, sizeof *pose);
    memcpy(pose->angle, body->rig.rest, sizeof pose->angle);
    return MUS_OK;
}


mus_status mus_body_stance(const mus_body *body, mus_pose *pose)
{
    if (body == NULL || pose == NULL) return MUS_ERR_ARG;
    if (body->frame == NULL) return mus_body_rest_pose(body, pose);
    *pose = body->pose;
    return MUS_OK;
}
