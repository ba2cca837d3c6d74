/* stance.c: the pose of a body by the options --pose, --move and --at. */
#include "stance.h"

#define STANCE_GAP 0.012 /* [m] distance of the arms from the sides; chosen: two layers of cloth fit between */


/* Computes the pose of a movement at a time. */
static mus_status stance_moving(const mus_body *body, const stance *how, mus_pose *pose)
{
    mus_move *move = NULL;
    mus_status status = mus_body_move(body, how->move, STANCE_GAP, &move);
    if (status == MUS_OK) status = mus_move_at(move, how->at, pose);
    mus_move_destroy(move);
    return status;
}


/* Computes a named pose with the feet on the floor and the arms off the sides. */
static mus_status stance_standing(const scene *s, const mus_body *body, const stance *how, mus_pose *pose)
{
    mus_status status = mus_pose_named(s->context, how->pose, pose);
    if (status == MUS_OK) status = mus_body_clear_arms(body, pose, STANCE_GAP);
    return status == MUS_OK ? mus_body_stand(body, mus_pose_feet(how->pose), pose) : status;
}


mus_status stance_take(const scene *s, const stance *how, mus_body **body)
{
    if (how->pose == NULL && how->move == NULL) return MUS_OK;
    mus_pose pose;
    mus_body *posed = NULL;
    mus_status status =
        how->move != NULL ? stance_moving(*body, how, &pose) : stance_standing(s, *body, how, &pose);
    if (status == MUS_OK) status = mus_body_pose(*body, &pose, &posed);
    if (status != MUS_OK) return status;
    mus_body_destroy(*body);
    *body = posed;
    return MUS_OK;
}
