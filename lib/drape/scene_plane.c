/*
 * scene_plane.c: planes beside the body: ground, incline, table, belt, turntable, shaken table.
 *
 * The place of a plane is a product, point0 + velocity (t - t0), as that of the body. Planes share a collider with the
 * body; a drape without a body gets one with its first plane. Coarse drapes borrow it.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_state.h"
#include "geom/vec.h"

#define PLANE_FAR 1e4  /* [m] largest coordinate: the reach of a float state */
#define PLANE_FAST 1e3 /* [m/s], [rad/s] largest velocity and spin */


void mus_plane_init(mus_plane *plane, size_t size)
{
    const mus_plane own = {sizeof own, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, 0.0, -1.0, 0.0};
    mus__def_init(plane, size, &own, sizeof own);
}


/* MUS_ERR_ARG when one of `count` numbers of a plane is not within least..most */
static mus_status plane_numbers(mus_context *context, const char *what, int32_t count, const double *value,
                                double least, double most)
{
    for (int32_t i = 0; i < count; i++)
        if (!(value[i] >= least && value[i] <= most))
            return mus__fail(context, MUS_ERR_ARG, "drape: %s of a plane is %g, expected %g to %g", what, value[i],
                             least, most);
    return MUS_OK;
}


static mus_status check_plane(mus_context *context, mus_plane *plane)
{
    mus_status status = plane_numbers(context, "point", 3, plane->point, -PLANE_FAR, PLANE_FAR);
    if (status == MUS_OK) status = plane_numbers(context, "normal", 3, plane->normal, -PLANE_FAR, PLANE_FAR);
    if (status == MUS_OK) status = plane_numbers(context, "velocity", 3, plane->velocity, -PLANE_FAST, PLANE_FAST);
    if (status == MUS_OK) status = plane_numbers(context, "spin", 1, &plane->spin, -PLANE_FAST, PLANE_FAST);
    if (status == MUS_OK) status = plane_numbers(context, "reach", 1, &plane->reach, 0.0, PLANE_FAR);
    if (status == MUS_OK && plane->friction != INFINITY)
        status = plane_numbers(context, "friction", 1, &plane->friction, -1e6, 1e6);
    if (status == MUS_OK && !(mus__norm3(plane->normal) >= 1e-6))
        status = mus__fail(context, MUS_ERR_ARG, "drape: normal of a plane is %g m long, expected 1e-6 at least",
                           mus__norm3(plane->normal));
    if (status == MUS_OK) mus__unit3(plane->normal);
    return status;
}


/* takes the memory that the first plane needs: the list, a collider, and the plane cache */
static mus_status first_plane(mus_drape *drape)
{
    mus_context *context = drape->context;
    if (drape->scene.plane == NULL) drape->scene.plane = mus__new(context, MUS__PLANES_MAX, sizeof *drape->scene.plane);
    if (drape->scene.plane == NULL) return mus__fail_memory(context, "planes");
    if (drape->scene.collider != NULL) return MUS_OK;
    mus_status status =
        mus__collider_create(context, NULL, drape->sim.origin, drape->def.clearance, &drape->scene.collider);
    if (status == MUS_OK && drape->def.contact_ball > 0.0) status = mus__drape_plane_cache(drape);
    drape->sim.plane_cache = NULL;
    if (status == MUS_OK) return MUS_OK;
    mus__collider_destroy(drape->scene.collider);
    drape->scene.collider = NULL;
    return status;
}


mus_status mus_drape_add_plane(mus_drape *drape, const mus_plane *plane, int32_t *index)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_context *context = drape->context;
    mus_plane own;
    mus_plane_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, sizeof own, plane, "mus_plane");
    if (status == MUS_OK) status = check_plane(context, &own);
    if (status == MUS_OK) status = first_plane(drape);
    if (status != MUS_OK) return status;
    mus__collider *collider = drape->scene.collider;
    status = mus__collider_add_plane(collider, own.point, own.normal, own.friction, own.reach);
    if (status != MUS_OK) {
        /* a collider without a body and planes is destroyed */
        if (collider->nparts + collider->nplane > 0) return status;
        mus__collider_destroy(collider);
        drape->scene.collider = NULL;
        return status;
    }

    const int32_t k = collider->nplane - 1;
    mus__scene_plane *mine = &drape->scene.plane[k];
    mine->added = own;
    memcpy(mine->from, own.point, sizeof mine->from);
    memcpy(mine->velocity, own.velocity, sizeof mine->velocity);
    mine->spin = own.spin;
    mine->time = mus_drape_time(drape);
    drape->scene.moved = 1;
    drape->relax.settled = 0;
    memset(drape->sim.distance_cache, 0, (size_t)drape->n * sizeof *drape->sim.distance_cache);
    for (mus_drape *each = drape; each != NULL; each = each->coarse.drape) {
        each->scene.collider = collider;
        mus__scene_contact(each);
        mus__drape_name_skipped(each);
    }
    if (index != NULL) *index = k;
    return MUS_OK;
}


mus_status mus_drape_move_plane(mus_drape *drape, int32_t index, const double *velocity, double spin)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_context *context = drape->context;
    const int32_t count = drape->scene.collider != NULL ? drape->scene.collider->nplane : 0;
    if (index < 0 || index >= count)
        return mus__fail(context, MUS_ERR_ARG, "drape: plane %d, expected 0 to %d", (int)index, (int)count - 1);
    if (velocity == NULL) return mus__fail(context, MUS_ERR_ARG, "drape: velocity is NULL");
    mus_status status = plane_numbers(context, "velocity", 3, velocity, -PLANE_FAST, PLANE_FAST);
    if (status == MUS_OK) status = plane_numbers(context, "spin", 1, &spin, -PLANE_FAST, PLANE_FAST);
    if (status != MUS_OK) return status;
    mus__scene_plane *plane = &drape->scene.plane[index];
    memcpy(plane->from, drape->scene.collider->plane[index].point, sizeof plane->from);
    memcpy(plane->velocity, velocity, sizeof plane->velocity);
    plane->spin = spin;
    plane->time = mus_drape_time(drape);
    return MUS_OK;
}


/* whether a plane moves */
static int32_t plane_moves(const mus__scene_plane *plane)
{
    const double *v = plane->velocity;
    return v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0 || plane->spin != 0.0;
}


int32_t mus__scene_plane_moves(const mus_drape *drape)
{
    if (drape->scene.plane == NULL || drape->scene.collider == NULL) return 0;
    for (int32_t k = 0; k < drape->scene.collider->nplane; k++)
        if (plane_moves(&drape->scene.plane[k])) return 1;
    return 0;
}


void mus__scene_planes_update(mus_drape *drape, int64_t steps, double h, double came)
{
    for (int32_t k = 0; drape->scene.plane != NULL && k < drape->scene.collider->nplane; k++) {
        const mus__scene_plane *plane = &drape->scene.plane[k];
        const double since = mus__clock_since(drape, plane->time, steps, h);
        double point[3];
        for (int32_t d = 0; d < 3; d++) point[d] = plane->from[d] + plane->velocity[d] * since;
        mus__collider_move_plane(drape->scene.collider, k, point, plane->velocity, plane->spin, came);
    }
}
