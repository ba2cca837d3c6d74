/*
 * collider_motion.c: the place of each surface of a collider, and its motion in the last step.
 *
 * Parts of the body are carried by frames, and all translate with one velocity; planes move with a velocity and turn
 * about their normal. A step of a surface is a rigid motion. Of a plane, with a the angle turned, K the cross product
 * by the normal and p the point after the step, p0 before:
 *
 *   displacement(x) = (sin a K + (1 - cos a) K^2) (x - p0) + p - p0
 *   velocity(x)     = spin K (x - p) + velocity of p
 *
 * Sine and cosine are sums of a few products, the same on every machine.
 */
#include <math.h>
#include <string.h>

#include "contact/contact_template.h"

#define MOTION_TURN_SMALL 0.25 /* [rad] below it the sums of sine and cosine are exact to rounding of a double */


/* box of a part: its axis from end to end, widened by the reach in the contour's plane */
static void part_box(const mus__collider_part *home, const mus__field_f64 *field, double offset, double *box)
{
    for (int32_t i = 0; i < 3; i++) {
        const double start = field->origin[i];
        const double e0 = start + home->end[0] * field->axis[i], e1 = start + home->end[1] * field->axis[i];
        const double across = sqrt(field->side[i] * field->side[i] + field->front[i] * field->front[i]);
        const double wide = across * (home->reach + offset) + offset;
        box[i] = (e0 < e1 ? e0 : e1) - wide;
        box[i + 3] = (e0 < e1 ? e1 : e0) + wide;
    }
}


void mus__collider_place(mus__collider *collider, int32_t l)
{
    const mus__collider_part *home = &collider->part[l];
    mus__field_f64 *wide = &collider->field64[l];
    mus__field_f32 *slim = &collider->field32[l];
    memcpy(wide->origin, home->origin, sizeof wide->origin);
    memcpy(wide->axis, home->axis, sizeof wide->axis);
    memcpy(wide->side, home->side, sizeof wide->side);
    memcpy(wide->front, home->front, sizeof wide->front);
    if (collider->turned) {
        const mus__frame *frame = &collider->frame[l];
        double world[3];
        for (int32_t i = 0; i < 3; i++) world[i] = home->origin[i] + collider->origin[i];
        mus__frame_point(frame, world, world);
        for (int32_t i = 0; i < 3; i++) wide->origin[i] = world[i] - collider->origin[i];
        mus__frame_turn(frame, home->axis, wide->axis);
        mus__frame_turn(frame, home->side, wide->side);
        mus__frame_turn(frame, home->front, wide->front);
    }
    for (int32_t i = 0; i < 3; i++) {
        wide->origin[i] += collider->shift[i];
        slim->origin[i] = (float)wide->origin[i];
        slim->axis[i] = (float)wide->axis[i], slim->side[i] = (float)wide->side[i];
        slim->front[i] = (float)wide->front[i];
    }
    part_box(home, wide, collider->offset, collider->box + 6 * (int64_t)l);
}


/* out = a b^T */
static void turn_between(const double *a, const double *b, double *out)
{
    for (int32_t i = 0; i < 3; i++)
        for (int32_t k = 0; k < 3; k++)
            out[3 * i + k] = a[3 * i] * b[3 * k] + a[3 * i + 1] * b[3 * k + 1] + a[3 * i + 2] * b[3 * k + 2];
}


/* a x b */
static void cross(const double *a, const double *b, double *out)
{
    for (int32_t i = 0; i < 3; i++) {
        const int32_t j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}


/*
 * Motion of a part that came from frame `was` to frame `now` in a step of h, while all translated with `drift`. It is a
 * screw: with C and c of x1 = C x0 + c, the turn r = axis times angle is (angle / sin angle) times the skew part of C,
 * and
 *
 *   velocity(x1) = (r x x1 + w) / h + drift,   w = c - r x c / 2 + r x (r x c) / 12
 */
static void motion_of_part(const mus__collider *collider, const mus__frame *was, const mus__frame *now,
                           const double *drift, double h, mus__surface_motion *out)
{
    double turn[9], far[3], round[3], once[3], twice[3];
    turn_between(now->turn, was->turn, turn);
    for (int32_t i = 0; i < 3; i++) {
        const int32_t j = (i + 1) % 3, k = (i + 2) % 3;
        far[i] = now->place[i];
        for (int32_t d = 0; d < 3; d++) far[i] -= turn[3 * i + d] * was->place[d];
        round[i] = 0.5 * (turn[3 * k + j] - turn[3 * j + k]);
    }
    const double s = round[0] * round[0] + round[1] * round[1] + round[2] * round[2];
    const double straight = 1.0 + s / 6.0 * (1.0 + s * 9.0 / 20.0 * (1.0 + s * 25.0 / 42.0 * (1.0 + s * 49.0 / 72.0)));
    for (int32_t i = 0; i < 3; i++) round[i] *= straight;
    cross(round, far, once);
    cross(round, once, twice);
    for (int32_t i = 0; i < 3; i++) {
        const int32_t j = (i + 1) % 3, k = (i + 2) % 3;
        out->displacement[3 * i + i] = turn[3 * i + i] - 1.0, out->velocity[3 * i + i] = 0.0;
        out->displacement[3 * i + j] = turn[3 * i + j], out->velocity[3 * i + j] = -round[k] / h;
        out->displacement[3 * i + k] = turn[3 * i + k], out->velocity[3 * i + k] = round[j] / h;
        out->displacement[9 + i] = far[i] + h * drift[i];
        out->velocity[9 + i] = (far[i] - once[i] / 2.0 + twice[i] / 12.0) / h + drift[i];
    }

    /* as maps of places in the state's coordinates, before and after the step */
    for (int32_t i = 0; i < 3; i++)
        for (int32_t d = 0; d < 3; d++) {
            const double after = collider->origin[d] - collider->shift[d];
            out->displacement[9 + i] += out->displacement[3 * i + d] * (after + h * drift[d]);
            out->velocity[9 + i] += out->velocity[3 * i + d] * after;
        }
}


/* the frame of a part as made */
static const mus__frame at_home = {{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}};


void mus__collider_move(mus__collider *collider, const mus__frame *frame, const double *shift, const double *drift,
                        double h)
{
    const int32_t glides = h > 0.0 && (drift[0] != 0.0 || drift[1] != 0.0 || drift[2] != 0.0);
    memcpy(collider->shift, shift, sizeof collider->shift);
    for (int32_t i = 0; i < 3; i++) collider->drift[i] = glides ? drift[i] : 0.0;
    collider->moving = glides ? MUS__TRANSLATED : MUS__AT_REST;
    for (int32_t l = 0; l < collider->nparts && h > 0.0; l++) {
        const mus__frame *was = collider->turned ? &collider->frame[l] : &at_home;
        const mus__frame *now = frame != NULL ? &frame[l] : &at_home;
        if (memcmp(was, now, sizeof *now) != 0) collider->moving = MUS__TURNED;
    }
    for (int32_t l = 0; l < collider->nparts; l++) {
        const mus__frame was = collider->turned ? collider->frame[l] : at_home;
        collider->frame[l] = frame != NULL ? frame[l] : at_home;
        if (collider->moving == MUS__TURNED)
            motion_of_part(collider, &was, &collider->frame[l], collider->drift, h, &collider->motion[l]);
    }
    collider->turned = frame != NULL;
    for (int32_t l = 0; l < collider->nparts; l++) mus__collider_place(collider, l);
    if (collider->moving != MUS__TRANSLATED || collider->nparts == 0) return;
    memset(collider->motion, 0, sizeof *collider->motion);
    for (int32_t i = 0; i < 3; i++) {
        collider->motion->displacement[9 + i] = h * drift[i];
        collider->motion->velocity[9 + i] = drift[i];
    }
}


/* ---- planes ---- */

mus_status mus__collider_add_plane(mus__collider *collider, const double *point, const double *normal, double friction,
                                   double reach)
{
    mus_context *context = collider->context;
    if (collider->nplane == MUS__PLANES_MAX)
        return mus__fail(context, MUS_ERR_LIMIT, "drape: one plane more than %d", MUS__PLANES_MAX);
    if (collider->plane == NULL) collider->plane = mus__new(context, MUS__PLANES_MAX, sizeof *collider->plane);
    if (collider->plane == NULL) return mus__fail_memory(context, "planes");
    mus__collider_plane *plane = &collider->plane[collider->nplane++];
    memset(plane, 0, sizeof *plane);
    memcpy(plane->point, point, sizeof plane->point);
    memcpy(plane->normal, normal, sizeof plane->normal);
    plane->friction = friction;
    plane->reach = reach;
    collider->safe = fmin(collider->safe, MUS__PLANE_SAFE_TRAVEL);
    return MUS_OK;
}


/* sine: sin a, less: 1 - cos a. The angle is halved until a few products sum it, then doubled back */
static void turn_of(double angle, double *sine, double *less)
{
    int32_t doublings = 0;
    for (; angle > MOTION_TURN_SMALL || angle < -MOTION_TURN_SMALL; doublings++) angle *= 0.5;
    const double a = angle * angle;
    double s = angle * (1 - a / 6 * (1 - a / 20 * (1 - a / 42 * (1 - a / 72 * (1 - a / 110)))));
    double l = a / 2 * (1 - a / 12 * (1 - a / 30 * (1 - a / 56 * (1 - a / 90))));
    for (; doublings > 0; doublings--) {
        const double c = 1.0 - l;
        l = 2.0 * s * s;
        s = 2.0 * s * c;
    }
    *sine = s, *less = l;
}


/* map(x) = (sine K + less K^2) (x - p) + way, K the cross product by unit n */
static void spin_map(double sine, double less, const double *n, const double *p, const double *way, double *map)
{
    for (int32_t i = 0; i < 3; i++) {
        const int32_t j = (i + 1) % 3, k = (i + 2) % 3;
        map[3 * i + i] = less * (n[i] * n[i] - 1.0);
        map[3 * i + j] = less * n[i] * n[j] - sine * n[k];
        map[3 * i + k] = less * n[i] * n[k] + sine * n[j];
    }
    for (int32_t i = 0; i < 3; i++)
        map[9 + i] = way[i] - (map[3 * i] * p[0] + map[3 * i + 1] * p[1] + map[3 * i + 2] * p[2]);
}


void mus__collider_move_plane(mus__collider *collider, int32_t k, const double *point, const double *velocity,
                              double spin, double h)
{
    mus__collider_plane *plane = &collider->plane[k];
    memcpy(plane->point, point, sizeof plane->point);
    plane->moving = h > 0.0 && (velocity[0] != 0.0 || velocity[1] != 0.0 || velocity[2] != 0.0 || spin != 0.0);
    if (!plane->moving) return;
    double sine, less, way[3], now[3], then[3];
    for (int32_t i = 0; i < 3; i++) {
        way[i] = h * velocity[i];
        now[i] = point[i] - collider->origin[i];
        then[i] = now[i] - way[i];
    }
    turn_of(h * spin, &sine, &less);
    spin_map(sine, less, plane->normal, then, way, plane->motion.displacement);
    spin_map(spin, 0.0, plane->normal, now, velocity, plane->motion.velocity);
}


/* largest speed in a box relative to `drift`: the map is affine, so it is at a corner */
static double box_speed_max(const double *map, const double *drift, const double *box)
{
    double most2 = 0.0;
    for (int32_t corner = 0; corner < 8; corner++) {
        const double x[3] = {box[corner & 1 ? 3 : 0], box[corner & 2 ? 4 : 1], box[corner & 4 ? 5 : 2]};
        double speed2 = 0.0;
        for (int32_t i = 0; i < 3; i++) {
            const double own = map[3 * i] * x[0] + map[3 * i + 1] * x[1] + map[3 * i + 2] * x[2] + map[9 + i];
            speed2 += (own - drift[i]) * (own - drift[i]);
        }
        if (speed2 > most2) most2 = speed2;
    }
    return sqrt(most2);
}


void mus__collider_update_speed(mus__collider *collider)
{
    static const double still[12] = {0.0};
    double most = 0.0;
    collider->speed_max = 0.0;
    for (int32_t l = 0; l < collider->nparts; l++) {
        double *own = &collider->part[l].speed_max;
        *own = 0.0;
        if (collider->moving == MUS__TURNED)
            *own = box_speed_max(collider->motion[l].velocity, collider->drift, collider->box + 6 * (int64_t)l);
        collider->speed_max = fmax(collider->speed_max, *own);
    }
    for (int32_t k = 0; k < collider->nplane; k++) {
        const mus__collider_plane *plane = &collider->plane[k];
        double box[6];
        for (int32_t i = 0; i < 6; i++)
            box[i] = plane->point[i % 3] - collider->origin[i % 3] + (i < 3 ? -plane->reach : plane->reach);
        most = fmax(most, box_speed_max(plane->moving ? plane->motion.velocity : still, collider->drift, box));
    }
    collider->plane_speed_max = most;
    collider->speed_max = fmax(collider->speed_max, most);
}
