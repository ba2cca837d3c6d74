/*
 * nest_shape.c: an outline as the search needs it: measured from the middle of its box, with inscribed circles.
 *
 * The circles (poles of inaccessibility) stand for the area of the shape where the depth of an overlap is measured. The
 * first is the largest circle inside the shape, each further one the largest that is also outside those before it. A
 * centre is looked for on a grid over the box, then by steps that are halved.
 * Source: Gardeyn, Vanden Berghe, Wauters, An open-source heuristic to reboot 2D nesting research, 2025, section 5;
 * Garcia-Castellanos and Lombardo, Poles of inaccessibility, 2007.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/polygon.h"
#include "nest/nest_shape.h"

#define SHAPE_GRID 40     /* columns and rows on which a centre is looked for; chosen */
#define SHAPE_HALVINGS 20 /* of the step from the best point of the grid; chosen: below the rounding of float */
#define SHAPE_COVERED 0.9 /* part of the area after which no more circles than half the most are made; chosen */


/* signed distance of a point to the outline, above 0 inside, and to the circles so far, above 0 outside: the lesser;
 * any number up to least for a point that has no more than that */
static double shape_room(const mus__nest_shape *shape, int32_t npole, double x, double y, double least)
{
    const double p[2] = {x, y};
    double room = HUGE_VAL;
    for (int32_t k = 0; k < npole; k++) {
        const double dx = x - (double)shape->poles.x[k], dy = y - (double)shape->poles.y[k];
        room = fmin(room, sqrt(dx * dx + dy * dy) - (double)shape->poles.r[k]);
    }
    if (room <= least) return room;
    const double side = mus__polygon_distance(shape->n, shape->xy, p);
    if (side <= least) return side;
    return fmin(room, mus__polygon_winding(shape->n, shape->xy, p) == 0 ? -side : side);
}


/* find the centre of the next circle: out (2); returns its radius. rooms (SHAPE_GRID x SHAPE_GRID) holds the room of
 * each point of the grid */
static double shape_centre(const mus__nest_shape *shape, int32_t npole, const double *rooms, double *out)
{
    int32_t top = 0;
    for (int32_t i = 1; i < SHAPE_GRID * SHAPE_GRID; i++)
        if (rooms[i] > rooms[top]) top = i;
    double step[2], best = rooms[top];
    for (int32_t d = 0; d < 2; d++) step[d] = 2.0 * shape->half[d] / SHAPE_GRID;
    out[0] = -shape->half[0] + (top % SHAPE_GRID + 0.5) * step[0];
    out[1] = -shape->half[1] + ((int32_t)(top / SHAPE_GRID) + 0.5) * step[1];
    for (int32_t round = 0; round < SHAPE_HALVINGS; round++) {
        for (int32_t k = 0; k < 8; k++) {
            static const double ways[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
            const double x = out[0] + ways[k][0] * step[0], y = out[1] + ways[k][1] * step[1];
            const double room = shape_room(shape, npole, x, y, best);
            if (room <= best) continue;
            best = room;
            out[0] = x;
            out[1] = y;
        }
        for (int32_t d = 0; d < 2; d++) step[d] *= 0.5;
    }
    return best;
}


/* make the circles of a shape; rooms (SHAPE_GRID x SHAPE_GRID) */
static void shape_poles(mus__nest_shape *shape, double *rooms)
{
    const double area = fabs(mus__polygon_area(shape->n, shape->xy));
    double covered = 0.0;
    int32_t n = 0;
    for (int32_t i = 0; i < SHAPE_GRID * SHAPE_GRID; i++)
        rooms[i] = shape_room(shape, 0, (2.0 * (i % SHAPE_GRID + 0.5) / SHAPE_GRID - 1.0) * shape->half[0],
                              (2.0 * ((int32_t)(i / SHAPE_GRID) + 0.5) / SHAPE_GRID - 1.0) * shape->half[1], -HUGE_VAL);
    while (n < MUS__NEST_POLES && !(n >= MUS__NEST_POLES / 2 && covered > SHAPE_COVERED * area)) {
        double centre[2];
        const double r = shape_centre(shape, n, rooms, centre);
        if (!(r > 0.0)) break;
        shape->poles.x[n] = (float)centre[0];
        shape->poles.y[n] = (float)centre[1];
        shape->poles.r[n++] = (float)r;
        covered += MUS_PI * r * r;
        for (int32_t i = 0; i < SHAPE_GRID * SHAPE_GRID; i++) {
            const double dx = (2.0 * (i % SHAPE_GRID + 0.5) / SHAPE_GRID - 1.0) * shape->half[0] - centre[0];
            const double dy = (2.0 * ((int32_t)(i / SHAPE_GRID) + 0.5) / SHAPE_GRID - 1.0) * shape->half[1] - centre[1];
            rooms[i] = fmin(rooms[i], sqrt(dx * dx + dy * dy) - r);
        }
    }
    shape->poles.n = n;
}


/* set the boxes of the runs of sides */
static void shape_runs(mus__nest_shape *shape)
{
    for (int32_t k = 0; k < mus__nest_runs(shape->n); k++) {
        double *box = shape->runs + 4 * k;
        const int32_t first = k * MUS__NEST_RUN_SIDES;
        for (int32_t d = 0; d < 2; d++) {
            box[d] = box[2 + d] = shape->xy[2 * first + d];
            for (int32_t i = first + 1; i <= first + MUS__NEST_RUN_SIDES && i <= shape->n; i++) {
                const double at = shape->xy[2 * (i < shape->n ? i : 0) + d];
                box[d] = fmin(box[d], at);
                box[2 + d] = fmax(box[2 + d], at);
            }
        }
    }
}


mus_status mus__nest_shape_make(mus_context *context, const mus__nest_way *way, double *xy, double *runs,
                                mus__nest_shape *shape)
{
    const int32_t n = way->n;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (int32_t i = 0; i < 2 * n; i++) {
        low[i % 2] = fmin(low[i % 2], way->xy[i]);
        high[i % 2] = fmax(high[i % 2], way->xy[i]);
    }
    memset(shape, 0, sizeof *shape);
    shape->n = n;
    shape->xy = xy;
    shape->runs = runs;
    shape->given = way->xy;
    for (int32_t d = 0; d < 2; d++) {
        shape->middle[d] = low[d] + 0.5 * (high[d] - low[d]);
        for (int32_t i = 0; i < n; i++) {
            xy[2 * i + d] = way->xy[2 * i + d] - shape->middle[d];
            shape->half[d] = fmax(shape->half[d], fabs(xy[2 * i + d]));
        }
    }
    for (int32_t d = 0; d < 2; d++) {
        shape->low[d] = way->box != NULL ? way->box[d] - shape->middle[d] : -shape->half[d];
        shape->high[d] = way->box != NULL ? way->box[2 + d] - shape->middle[d] : shape->half[d];
    }
    shape_runs(shape);
    shape->stripe = way->stripe - shape->middle[0];
    shape->least = 2.0 * fmin(shape->half[0], shape->half[1]);
    shape->diameter = 2.0 * sqrt(shape->half[0] * shape->half[0] + shape->half[1] * shape->half[1]);

    int32_t *hull = mus__new(context, n, 2 * sizeof *hull);
    double *rooms = mus__new(context, SHAPE_GRID * SHAPE_GRID, sizeof *rooms),
           *ring = mus__new(context, n, 2 * sizeof *ring);
    if (hull != NULL && rooms != NULL && ring != NULL) {
        const int32_t m = mus__polygon_hull(n, xy, hull, hull + n);
        for (int32_t i = 0; i < m; i++) memcpy(ring + 2 * i, xy + 2 * hull[i], 2 * sizeof *ring);
        shape->size = sqrt(fabs(mus__polygon_area(m, ring)));
        shape_poles(shape, rooms);
    }
    const bool made = hull != NULL && rooms != NULL && ring != NULL;
    mus__free(context, hull);
    mus__free(context, rooms);
    mus__free(context, ring);
    return made ? MUS_OK : mus__fail_memory(context, "the shapes of a layout");
}


void mus__nest_placed(const mus__nest_shape *shape, const mus__nest_at *at, mus__nest_place *out)
{
    out->way = at->way;
    out->x = at->x - shape->middle[0];
    out->y = at->y - shape->middle[1];
}


void mus__nest_outline(const mus__nest_shape *shape, const mus__nest_at *at, double *out)
{
    mus__nest_place place;
    mus__nest_placed(shape, at, &place);
    for (int32_t i = 0; i < shape->n; i++) {
        out[2 * i] = shape->given[2 * i] + place.x;
        out[2 * i + 1] = shape->given[2 * i + 1] + place.y;
    }
}
