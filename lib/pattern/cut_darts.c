/*
 * cut_darts.c: darts folded shut, so that the cut line runs across their mouths.
 *
 * A dart with the point O and the mouth A B is closed by the turn about O that takes B to A. The cloth between the legs
 * is then folded on the bisector of the dart and lies on the cloth beside one leg, twice. A tailor folds it on paper,
 * cuts along the edge, and unfolds: the mouth gets the shape of the edge that it lies on.
 *
 *        P                     folded onto A's side: the edge from A to Q, where the line from O at half the dart's
 *   B__/   \__A____Q__         angle meets it, is mirrored in O A and gives A P; the turn from A to B takes it, read
 *       \   |   /              backwards, to P B. Both halves meet in P, on the bisector, since the mirror image of Q
 *        \  |  /               and the turned Q are at the same distance and angle from O.
 *         \ | /
 *          \|/                 The edge is read with the darts on it closed. Moving the capped ring out by the
 *           O                  allowances commutes with the mirror and the turn, so the cut line folds onto itself.
 *
 * Source: Aldrich, Metric Pattern Cutting for Women's Wear, 2008 (shaping the ends of darts); Joseph-Armstrong,
 * Patternmaking for Fashion Design, 2010, ch. 4 (dart excess).
 */
#include <math.h>
#include <string.h>

#include "pattern/cut_ring.h"

/* a rigid map of the plane, with or without a mirror: x -> m x + t; m row-major */
typedef struct fold_map {
    double m[4], t[2];
} fold_map;

/* the edge beside a mouth, from the mouth's end to the fold */
typedef struct fold_way {
    mus__cut_ring points;
    bool met; /* the line of the fold was reached */
} fold_way;


static void fold_point(const fold_map *map, const double *p, double *out)
{
    const double x = p[0], y = p[1];
    out[0] = map->m[0] * x + map->m[1] * y + map->t[0];
    out[1] = map->m[2] * x + map->m[3] * y + map->t[1];
}


/* first `inner`, then `outer` */
static fold_map fold_after(const fold_map *outer, const fold_map *inner)
{
    const double *a = outer->m, *b = inner->m;
    fold_map both = {{a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3],
                     a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]}, {0.0, 0.0}};
    fold_point(outer, inner->t, both.t);
    return both;
}


/* the map with matrix m that keeps the point o */
static fold_map fold_about(const double *o, double m0, double m1, double m2, double m3)
{
    return (fold_map){{m0, m1, m2, m3}, {o[0] - m0 * o[0] - m1 * o[1], o[1] - m2 * o[0] - m3 * o[1]}};
}


/* unit vector from a to b */
static void fold_direction(const double *a, const double *b, double *out)
{
    const double x = b[0] - a[0], y = b[1] - a[1], d = sqrt(x * x + y * y);
    out[0] = x / d, out[1] = y / d;
}


/* the turn about the point of a dart that takes one end of its mouth to the other: 0 to 1, or back */
static fold_map mouth_turn(const mus__cut_dart *dart, bool back)
{
    double u[2], v[2];
    fold_direction(dart->point, dart->mouth[back ? 1 : 0], u);
    fold_direction(dart->point, dart->mouth[back ? 0 : 1], v);
    const double c = u[0] * v[0] + u[1] * v[1], s = u[0] * v[1] - u[1] * v[0];
    return fold_about(dart->point, c, -s, s, c);
}


/* the mirror in the line from the point of a dart to an end of its mouth */
static fold_map mouth_mirror(const mus__cut_dart *dart, int32_t end)
{
    double u[2];
    fold_direction(dart->point, dart->mouth[end], u);
    const double c = u[0] * u[0] - u[1] * u[1], s = 2.0 * u[0] * u[1];
    return fold_about(dart->point, c, s, s, -c);
}


/*
 * Walk along the ring away from the mouth at side `mouth`, with the darts on the way closed, until the line of the fold
 * is met. Corner k of the walk has the attributes of the side from it to the next.
 */
static void fold_walk(const mus__cut_ring *ring, int32_t mouth, const mus__cut_dart *darts, fold_way *walk)
{
    const mus__cut_dart *own = &darts[ring->list[mouth].dart];
    const bool second = own->onto_second;
    const fold_map turn = mouth_turn(own, second);
    /* half the angle of the dart, away from its mouth: against the turn */
    const double c = sqrt(0.5 * fmax(0.0, 1.0 + turn.m[0])), s = sqrt(0.5 * fmax(0.0, 1.0 - turn.m[0]));
    const double sign = turn.m[2] > 0.0 ? -1.0 : 1.0;
    const double *from = own->mouth[second ? 1 : 0];
    double u[2], fold[2];
    fold_direction(own->point, from, u);
    fold[0] = c * u[0] - sign * s * u[1], fold[1] = sign * s * u[0] + c * u[1];

    fold_map map = {{1.0, 0.0, 0.0, 1.0}, {0.0, 0.0}};
    mus__cut_corner at = {.dart = MUS_NONE};
    memcpy(at.xy, from, sizeof at.xy);
    int32_t k = second ? (mouth + 1) % ring->n : mouth;
    for (int32_t step = 0; step < ring->n && walk->points.status == MUS_OK; step++) {
        const int32_t next = second ? (k + 1) % ring->n : (k + ring->n - 1) % ring->n, side = second ? k : next;
        const mus__cut_corner *passed = &ring->list[side];
        if (side == mouth) return;
        if (passed->dart != MUS_NONE) {
            const fold_map close = mouth_turn(&darts[passed->dart], second);
            map = fold_after(&map, &close);
            k = next;
            continue;
        }
        double q[2];
        fold_point(&map, ring->list[next].xy, q);
        at.width = passed->width, at.hem = passed->hem, at.given = passed->given;
        mus__cut_add(&walk->points, &at);
        const double f = fold[0] * (at.xy[1] - own->point[1]) - fold[1] * (at.xy[0] - own->point[0]);
        const double g = fold[0] * (q[1] - own->point[1]) - fold[1] * (q[0] - own->point[0]);
        walk->met = sign * g >= 0.0;
        const double t = walk->met && f != g ? f / (f - g) : 1.0;
        for (int32_t d = 0; d < 2; d++) at.xy[d] += t * (q[d] - at.xy[d]);
        k = next;
        if (!walk->met) continue;
        mus__cut_add(&walk->points, &at);
        const double ahead = fold[0] * (at.xy[0] - own->point[0]) + fold[1] * (at.xy[1] - own->point[1]);
        walk->met = ahead > 0.0;
        return;
    }
}


/* add the cap of the mouth at side `mouth`, without its second end; a straight line when the fold meets no edge */
static void fold_cap(const mus__cut_ring *in, int32_t mouth, mus__cut_dart *darts, mus__cut_ring *out)
{
    mus__cut_dart *own = &darts[in->list[mouth].dart];
    fold_way walk = {.points = {.context = in->context}};
    fold_walk(in, mouth, darts, &walk);
    const int32_t m = walk.points.n - 1;
    mus__cut_corner first = in->list[mouth];
    first.dart = MUS_NONE;
    for (int32_t d = 0; d < 2; d++) own->peak[d] = 0.5 * (own->mouth[0][d] + own->mouth[1][d]);
    if (walk.points.status != MUS_OK) {
        out->status = walk.points.status;
    } else if (!walk.met || m < 1) {
        mus__cut_add(out, &first);
    } else {
        /* the half beside the cloth that it is folded onto is a mirror image, the other is turned */
        const fold_map mirror = mouth_mirror(own, own->onto_second ? 1 : 0), turn = mouth_turn(own, own->onto_second);
        const mus__cut_corner *list = walk.points.list;
        fold_point(&mirror, list[m].xy, own->peak);
        for (int32_t k = 0; k < 2 * m; k++) {
            const int32_t source = k < m ? k : 2 * m - k;
            mus__cut_corner corner = list[k < m ? k : source - 1];
            fold_point((k < m) != own->onto_second ? &mirror : &turn, list[source].xy, corner.xy);
            if (k == 0) memcpy(corner.xy, own->mouth[0], sizeof corner.xy);
            mus__cut_add(out, &corner);
        }
    }
    mus__free(in->context, walk.points.list);
}


void mus__cut_fold_darts(const mus__cut_ring *in, mus__cut_dart *darts, mus__cut_ring *out)
{
    for (int32_t i = 0; i < in->n && out->status == MUS_OK; i++) {
        if (in->list[i].dart == MUS_NONE) mus__cut_add(out, &in->list[i]);
        else fold_cap(in, i, darts, out);
    }
}
