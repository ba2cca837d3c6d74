/*
 * scene_contact.c: makes the contact passes known to a sim: the one place of lib/drape that names them, so that a
 * program whose drapes have neither body nor planes links none of them.
 */
#include "contact/plane_cache.h"
#include "drape/drape_state.h"


void mus__scene_contact(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    const bool single = sim->ops->real == sizeof(float);
    sim->collider = drape->scene.collider;
    sim->contact_pass = single ? mus__contact_pass_f32 : mus__contact_pass_f64;
    sim->plane_cache_pass = single ? mus__plane_cache_pass_f32 : mus__plane_cache_pass_f64;
}


mus_status mus__scene_add_body(mus_drape *drape, const mus_body *body)
{
    mus_status status =
        mus__collider_create(drape->context, body, drape->sim.origin, drape->def.clearance, &drape->scene.collider);
    if (status == MUS_OK) status = mus__scene_body_create(drape, body);
    if (status != MUS_OK) return status;
    mus__scene_contact(drape);
    return MUS_OK;
}
