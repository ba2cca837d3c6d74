/*
 * body_surface.c: the surface of the limbs: rings, vertices, triangles and normals from the stacks.
 *
 * The surface of a limb is an end point, rings of `samples` vertices, and an end point. There is a ring at every
 * contour, and between contours so many that no sample moves more than ring_spacing from one ring to the next; a cap
 * has a few rings at equal angles of its ellipse. Two rings are joined by quads cut in two, the ends by fans, so that
 * no triangle has more than two vertices on one contour, and those are neighbours (the two conditions of Metaaphanon
 * and Kanongchaiyos 2005, section 3.3). All triangles wind outwards.
 */
#include <math.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"

/* rings of a cap, at equal angles of the quarter of an ellipse; chosen */
#define SURFACE_CAP_RINGS 6


/* number of steps in the interval above contour i, 1 to 200, so that no sample moves more than `spacing` [m] in one */
static int32_t surface_steps(const mus__stack *stack, int32_t i, double spacing)
{
    const mus__contour *p = &stack->limb->contour[i];
    const double *r = stack->radius + (ptrdiff_t)i * stack->n;
    double most = 0.0, rise = p[1].s - p[0].s;
    for (int32_t k = 0; k < stack->n; k++) {
        double move = fabs(r[k + stack->n] - r[k]);
        if (move > most) most = move;
    }
    double steps = ceil(sqrt(rise * rise + most * most) / spacing);
    return steps < 1.0 ? 1 : steps > 200.0 ? 200 : (int32_t)steps;
}


/* s of all rings of a limb into `out`, which may be NULL, and the ring of each contour; returns the number of rings */
static int32_t surface_rings(const mus__stack *stack, mus__limb *limb, double spacing, double *out)
{
    int32_t count = 0, last = limb->count - 1;

    /* the lower cap from its pole upwards, the contours and the rings between them, the upper cap */
    for (int32_t j = 1; j < SURFACE_CAP_RINGS; j++, count++) {
        double middle = stack->cap[0][0], axis = stack->cap[0][1];
        double end = mus__acos((middle - limb->contour[0].s) / axis);
        if (out != NULL) out[count] = middle - axis * mus__cos(end * j / SURFACE_CAP_RINGS);
    }
    for (int32_t i = 0; i < last; i++) {
        int32_t steps = surface_steps(stack, i, limb->contour[i].fine ? 0.5 * spacing : spacing);
        double low = limb->contour[i].s, high = limb->contour[i + 1].s;
        limb->contour[i].ring = count;
        for (int32_t j = 0; j < steps; j++, count++)
            if (out != NULL) out[count] = j == 0 ? low : low + (high - low) * j / steps;
    }
    limb->contour[last].ring = count;
    if (out != NULL) out[count] = limb->contour[last].s;
    count++;
    for (int32_t j = SURFACE_CAP_RINGS - 1; j > 0; j--, count++) {
        double middle = stack->cap[1][0], axis = stack->cap[1][1];
        double end = mus__acos((limb->contour[last].s - middle) / axis);
        if (out != NULL) out[count] = middle + axis * mus__cos(end * j / SURFACE_CAP_RINGS);
    }
    return count;
}


/* the point (3) of a limb at (a, b, s) */
static void surface_point(const mus__limb *limb, double a, double b, double s, double *out)
{
    for (int i = 0; i < 3; i++) out[i] = limb->origin[i] + a * limb->side[i] + b * limb->front[i] + s * limb->axis[i];
}


/* vertices (rings n + 2 x 3) of a limb in the rest pose. Scratch: radius (n) */
static void surface_vertices(const mus__stack *stack, const mus__limb *limb, const double *s, double *radius,
                             double *out)
{
    double centre[2];
    int32_t n = stack->n;
    mus__stack_ring(stack, limb->pole[0], centre, radius);
    surface_point(limb, centre[0], centre[1], limb->pole[0], out);
    out += 3;
    for (int32_t j = 0; j < limb->rings; j++) {
        mus__stack_ring(stack, s[j], centre, radius);
        for (int32_t k = 0; k < n; k++, out += 3)
            surface_point(limb, centre[0] + radius[k] * stack->turn[2 * k],
                          centre[1] + radius[k] * stack->turn[2 * k + 1], s[j], out);
    }
    mus__stack_ring(stack, limb->pole[1], centre, radius);
    surface_point(limb, centre[0], centre[1], limb->pole[1], out);
}


/* move the rings and end points of limb l to the body's pose */
static void surface_carry(const mus_body *body, int32_t l, const double *s, double *x)
{
    const mus__limb *limb = &body->limb[l];
    const int32_t n = body->def.samples;
    mus__frame frame;
    mus__rig_ring(&body->rig, body->frame, l, limb->pole[0], &frame);
    mus__frame_point(&frame, x, x);
    x += 3;
    for (int32_t j = 0; j < limb->rings; j++) {
        mus__rig_ring(&body->rig, body->frame, l, s[j], &frame);
        for (int32_t k = 0; k < n; k++, x += 3) mus__frame_point(&frame, x, x);
    }
    mus__rig_ring(&body->rig, body->frame, l, limb->pole[1], &frame);
    mus__frame_point(&frame, x, x);
}


mus_status mus__body_surface(mus_body *body, const mus__stack *stack)
{
    int32_t n = body->def.samples;
    double spacing = body->def.ring_spacing;

    /* sizes first */
    int32_t rings = 0;
    for (int32_t l = 0; l < body->limb_count; l++) {
        mus__limb *limb = &body->limb[l];
        limb->rings = limb->gone ? 0 : surface_rings(&stack[l], limb, spacing, NULL);
        limb->vertices = limb->gone ? 0 : limb->rings * n + 2;
        limb->triangles = 2 * n * limb->rings;
        limb->first_vertex = body->vertex_count;
        limb->first_triangle = body->triangle_count;
        body->vertex_count += limb->vertices;
        body->triangle_count += limb->triangles;
        limb->first_ring = rings;
        rings += limb->rings;
    }

    body->vertices = mus__room(body->context, 3 * (int64_t)body->vertex_count, sizeof(double));
    body->normals = mus__room(body->context, 3 * (int64_t)body->vertex_count, sizeof(double));
    if (!body->def.plain) mus__digit_counts(body, &body->digit_vertices, &body->digit_triangles);
    body->triangles =
        mus__new(body->context, 3 * ((int64_t)body->triangle_count + body->digit_triangles), sizeof(int32_t));
    body->ring = mus__new(body->context, rings, sizeof(double));
    double *work = mus__new(body->context, n, sizeof(double));
    if (!body->vertices || !body->normals || !body->triangles || !body->ring || !work) {
        mus__free(body->context, work);
        return mus__fail_memory(body->context, "the surface of a body");
    }

    for (int32_t l = 0; l < body->limb_count; l++) {
        mus__limb *limb = &body->limb[l];
        if (limb->gone) continue;
        double *s = body->ring + limb->first_ring;
        surface_rings(&stack[l], limb, spacing, s);
        surface_vertices(&stack[l], limb, s, work, body->vertices + 3 * (ptrdiff_t)limb->first_vertex);
        if (body->frame != NULL) surface_carry(body, l, s, body->vertices + 3 * (ptrdiff_t)limb->first_vertex);
        mus__ring_triangles(limb->first_vertex, limb->rings, n,
                               body->triangles + 3 * (ptrdiff_t)limb->first_triangle);
        mus__ring_normals(body->vertices + 3 * (ptrdiff_t)limb->first_vertex, n, limb->rings, 0,
                             body->normals + 3 * (ptrdiff_t)limb->first_vertex);
    }
    mus__free(body->context, work);
    return MUS_OK;
}
