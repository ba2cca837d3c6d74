/*
 * collider.c: start here to read lib/contact. A collider made and destroyed; depth of a point, and the surfaces near
 * it.
 *
 * The fields of the parts are those of the body's offset surface (offset_surface.c), which colliders share; a collider
 * has a place for each. A part's box is that of the hull of its axis: the span of the axis widened by the reach of the
 * contours. A node outside every box pays six comparisons a part and nothing else.
 *
 * The files of this folder in the order of use:
 *
 *   collider.[ch]                surfaces: made from a body, depth of a point, surfaces near a point
 *   offset_surface.[ch]          radius fields of the surface that cloth rests on, made once a body and shared
 *   digit_cover.c                those of hands and feet, widened over fingers and toes
 *   hands_feet.[ch]              hands and feet while a garment is put on, and the ends of fingers
 *   collider_motion.c            moves parts and planes; motion of each surface in the last step
 *   contact.h, contact_f32.c, contact_f64.c  the passes that a drape calls after a step, in float and in double:
 *     contact_kernel.h           the exact pass, chunk by chunk: boxes, queries, response
 *     query_batch_kernel.h       many nodes asked of one part at once
 *     response_batch_kernel.h    many nodes that touch one part answered at once
 *     response_kernel.h          one node against all surfaces that it touches
 *     contact_manifold_kernel.h  several contacts of one node solved together
 *     friction_kernel.h          friction (Coulomb)
 *     pinch_kernel.h             a node between surfaces that face each other
 *     sweep_kernel.h             a fast node swept along its path
 *     collider_surfaces_kernel.h          boxes, planes and motions in the pass's precision
 *   plane_cache.h, plane_cache_kernel.h  the cheap pass for slow nodes: each remembers a plane
 * Called by lib/drape alone: its steppers call the passes, its scene moves the surfaces. Cloth against cloth is the
 * room lib/selfcontact.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "contact/contact.h"
#include "contact/offset_surface.h"
#include "geom/vec.h"

#define COLLIDER_FAR 1e30 /* [m] depth of what is out of reach, with a minus; beyond every scene */
/* [m] added to a reach: near a cap the radius is far from a surface that is close; chosen: above the cap's height
 * of every part */
#define COLLIDER_STEEP_MARGIN 0.02


/* parts and memory of a collider whose offset surface is there */
static mus_status make_parts(mus__collider *collider)
{
    mus_context *context = collider->context;
    const mus__offset_surface *surface = collider->surface;
    const int32_t n = collider->nparts = surface->nparts;
    collider->field32 = mus__new(context, n, sizeof *collider->field32);
    collider->field64 = mus__new(context, n, sizeof *collider->field64);
    collider->box = mus__new(context, 6 * (int64_t)n, sizeof *collider->box);
    collider->part = mus__new(context, n, sizeof *collider->part);
    collider->motion = mus__new(context, n, sizeof *collider->motion);
    collider->frame = mus__new(context, n, sizeof *collider->frame);
    if (collider->field32 == NULL || collider->field64 == NULL || collider->box == NULL || collider->part == NULL ||
        collider->motion == NULL || collider->frame == NULL)
        return mus__fail_memory(context, "the parts of a collider");
    memcpy(collider->field32, surface->field32, (size_t)n * sizeof *collider->field32);
    memcpy(collider->field64, surface->field64, (size_t)n * sizeof *collider->field64);
    for (int32_t l = 0; l < n; l++) {
        const mus__offset_part *from = &surface->part[l];
        mus__collider_part *to = &collider->part[l];
        for (int32_t i = 0; i < 3; i++) to->origin[i] = from->origin[i] - collider->origin[i];
        memcpy(to->axis, from->axis, sizeof to->axis);
        memcpy(to->side, from->side, sizeof to->side);
        memcpy(to->front, from->front, sizeof to->front);
        memcpy(to->end, from->end, sizeof to->end);
        to->reach = from->reach;
        to->safe = from->safe;
        collider->safe = fmin(collider->safe, to->safe);
    }
    return MUS_OK;
}


mus_status mus__collider_create(mus_context *context, const mus_body *body, const double *origin, double offset,
                                mus__collider **out)
{
    *out = NULL;
    if (body != NULL && body->nfield > MUS__PARTS_MAX)
        return mus__fail(context, MUS_ERR_LIMIT, "body: %d limbs, at most %d can be collided with", (int)body->nfield,
                         MUS__PARTS_MAX);
    mus__collider *collider = mus__new(context, 1, sizeof *collider);
    if (collider == NULL) return mus__fail_memory(context, "a collider");
    collider->context = context;
    collider->offset = offset;
    collider->safe = COLLIDER_FAR;
    memcpy(collider->origin, origin, sizeof collider->origin);
    mus_status status = MUS_OK;
    if (body != NULL) status = mus__offset_surface_take(context, body, offset, &collider->surface);
    if (body != NULL && status == MUS_OK) status = make_parts(collider);
    if (status != MUS_OK) {
        mus__collider_destroy(collider);
        return status;
    }
    const mus__frame *frame = body != NULL ? body->frame : NULL;
    mus__collider_move(collider, frame, collider->shift, collider->drift, 0.0);
    *out = collider;
    return MUS_OK;
}


void mus__collider_destroy(mus__collider *collider)
{
    if (collider == NULL) return;
    mus_context *context = collider->context;
    mus__free(context, collider->field32);
    mus__free(context, collider->field64);
    mus__free(context, collider->box);
    mus__free(context, collider->part);
    mus__free(context, collider->motion);
    mus__free(context, collider->frame);
    mus__free(context, collider->plane);
    mus__offset_surface_leave(collider->surface);
    mus__free(context, collider);
}


/* a point of the world in the state's coordinates */
static void to_state(const mus__collider *collider, const double *point, double *p)
{
    for (int32_t i = 0; i < 3; i++) p[i] = point[i] - collider->origin[i];
}


/* depth of a point of the world below plane k; -COLLIDER_FAR beside and far below a disc */
static double plane_depth(const mus__collider *collider, int32_t k, const double *point)
{
    const mus__collider_plane *plane = &collider->plane[k];
    double up = 0.0, across2 = 0.0;
    for (int32_t i = 0; i < 3; i++) up += (point[i] - plane->point[i]) * plane->normal[i];
    for (int32_t i = 0; i < 3; i++) {
        const double across = point[i] - plane->point[i] - up * plane->normal[i];
        across2 += across * across;
    }
    if (plane->reach > 0.0 && (up < -MUS__DISC_THICKNESS || across2 > plane->reach * plane->reach))
        return -COLLIDER_FAR;
    return -up;
}


double mus__collider_parts_depth(const mus__collider *collider, uint64_t parts, const double *point, double margin,
                                 double *normal)
{
    double p[3], deepest = -COLLIDER_FAR;
    to_state(collider, point, p);
    for (; parts != 0; parts &= parts - 1) {
        double n[3];
        int32_t near;
        const int32_t l = mus__lowest_bit(parts);
        const double depth = mus__field_query_f64(&collider->field64[l], p, margin, n, &near) - collider->offset;
        if (near != 1 || depth <= deepest) continue;
        deepest = depth;
        if (normal != NULL) memcpy(normal, n, sizeof n);
    }
    return deepest;
}


double mus__collider_body_depth(const mus__collider *collider, const double *point, double margin, double *normal)
{
    const uint64_t all = collider->nparts < 64 ? ((uint64_t)1 << collider->nparts) - 1 : ~(uint64_t)0;
    return mus__collider_parts_depth(collider, all, point, margin, normal);
}


uint64_t mus__collider_parts_near(const mus__collider *collider, const double *low, const double *high, double margin)
{
    uint64_t near = 0;
    for (int32_t l = 0; l < collider->nparts; l++) {
        const double *box = collider->box + 6 * (ptrdiff_t)l, *o = collider->origin;
        const bool away = low[0] - o[0] > box[3] + margin || high[0] - o[0] < box[0] - margin ||
                          low[1] - o[1] > box[4] + margin || high[1] - o[1] < box[1] - margin ||
                          low[2] - o[2] > box[5] + margin || high[2] - o[2] < box[2] - margin;
        near |= (uint64_t)!away << l;
    }
    return near;
}


double mus__collider_depth(const mus__collider *collider, const double *point, double margin, double *normal)
{
    double deepest = mus__collider_body_depth(collider, point, margin, normal);
    for (int32_t k = 0; k < collider->nplane; k++) {
        const double depth = plane_depth(collider, k, point);
        if (depth <= deepest || depth < -margin) continue;
        deepest = depth;
        if (normal != NULL) memcpy(normal, collider->plane[k].normal, 3 * sizeof *normal);
    }
    return deepest;
}


int32_t mus__collider_touching(const mus__collider *collider, const double *point, double reach, double *normals,
                               double *friction)
{
    double p[3];
    to_state(collider, point, p);
    int32_t count = 0;
    for (int32_t l = 0; l < collider->nparts && count < MUS__TOUCHING_MAX; l++) {
        int32_t near;
        const double depth = mus__field_query_f64(&collider->field64[l], p, reach + COLLIDER_STEEP_MARGIN,
                                                  normals + 3 * (int64_t)count, &near);
        if (near == 1 && depth > collider->offset - reach) friction[count++] = -1.0;
    }
    for (int32_t k = 0; k < collider->nplane && count < MUS__TOUCHING_MAX; k++) {
        const mus__collider_plane *plane = &collider->plane[k];
        if (!(plane_depth(collider, k, point) > -reach)) continue;
        memcpy(normals + 3 * (int64_t)count, plane->normal, 3 * sizeof *normals);
        friction[count++] = plane->friction;
    }
    return count;
}


bool mus__collider_pinches(const mus__collider *collider, const double *point, double reach)
{
    double normal[3 * MUS__TOUCHING_MAX], friction[MUS__TOUCHING_MAX];
    const int32_t count = mus__collider_touching(collider, point, reach, normal, friction);
    for (int32_t i = 0; i < count; i++)
        for (int32_t j = 0; j < i; j++)
            if (mus__dot3(normal + 3 * (ptrdiff_t)i, normal + 3 * (ptrdiff_t)j) < MUS__PINCH_FACING) return true;
    return false;
}
