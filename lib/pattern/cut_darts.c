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
 * The cut line of the edge may meet the fold on another side than the edge itself does, where the edge has a corner
 * near Q. So each half is followed to the side whose cut line meets the fold, and the cut line ends there.
 *
 * Source: Aldrich, Metric Pattern Cutting for Women's Wear, 2008 (shaping the ends of darts); Joseph-Armstrong,
 * Patternmaking for Fashion Design, 2010, ch. 4 (dart excess).
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "pattern/cut_ring.h"

/* a rigid map of the plane, with or without a mirror: x -> m x + t; m row-major */
typedef struct fold_map {
    double m[4], t[2];
} fold_map;

/* the edge beside a mouth, from the mouth's end on, with the darts on it closed; point k has the attributes of the side
 * from it to the next */
typedef struct fold_way {
    mus__cut_ring points;
    double ray[2];   /* unit vector from the dart's point along the fold */
    double ahead;    /* 1: a point beyond the fold lies on the left of the ray; -1: on its right */
    double out;      /* 1: the cloth's outside lies on the right of the way; -1: on its left */
    double sewn[2];  /* Q, where the edge meets the fold */
    int32_t side;    /* the side whose cut line meets the fold */
    double cut[2];   /* the place where it does */
    double along;    /* of that place along the side, from its first point [m] */
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


/* the line of the fold: at half the angle of the dart from the leg, away from its mouth */
static void fold_ray(const mus__cut_dart *own, fold_way *way)
{
    const fold_map turn = mouth_turn(own, own->onto_second);
    const double c = sqrt(0.5 * fmax(0.0, 1.0 + turn.m[0])), s = sqrt(0.5 * fmax(0.0, 1.0 - turn.m[0]));
    double u[2];
    way->ahead = turn.m[2] > 0.0 ? -1.0 : 1.0;
    way->out = own->onto_second ? 1.0 : -1.0;
    fold_direction(own->point, own->mouth[own->onto_second ? 1 : 0], u);
    way->ray[0] = c * u[0] - way->ahead * s * u[1], way->ray[1] = way->ahead * s * u[0] + c * u[1];
}


/* walk along the ring away from the mouth at side `mouth`, once round, with the darts on the way closed */
static void fold_walk(const mus__cut_ring *ring, int32_t mouth, const mus__cut_dart *darts, fold_way *way)
{
    const mus__cut_dart *own = &darts[ring->list[mouth].dart];
    const bool second = own->onto_second;
    fold_map map = {{1.0, 0.0, 0.0, 1.0}, {0.0, 0.0}};
    int32_t k = second ? (mouth + 1) % ring->n : mouth;
    for (;;) {
        const int32_t next = second ? (k + 1) % ring->n : (k + ring->n - 1) % ring->n, side = second ? k : next;
        mus__cut_corner at = ring->list[side];
        if (at.dart != MUS_NONE && side != mouth) {
            const fold_map close = mouth_turn(&darts[at.dart], second);
            map = fold_after(&map, &close);
        } else {
            fold_point(&map, ring->list[k].xy, at.xy);
            mus__cut_add(&way->points, &at);
        }
        if (side == mouth || way->points.status != MUS_OK) return;
        k = next;
    }
}


/* how far p lies beyond the fold of a dart with the point o [m] */
static double fold_beyond(const fold_way *way, const double *o, const double *p)
{
    return way->ahead * (way->ray[0] * (p[1] - o[1]) - way->ray[1] * (p[0] - o[0]));
}


/* the point p, moved by `along` in the direction d and by `wide` to the outside */
static void way_moved(const fold_way *way, const double *p, const double *d, double along, double wide, double *out)
{
    out[0] = p[0] + along * d[0] + way->out * wide * d[1];
    out[1] = p[1] + along * d[1] - way->out * wide * d[0];
}


/* where the cut lines of the sides k and k + 1 meet: their crossing, or the end of the first where they do not cross */
static void way_joint(const fold_way *way, int32_t k, double *out)
{
    const mus__cut_corner *p = &way->points.list[k], *q = p + 1;
    double d[2], e[2];
    fold_direction(p->xy, q->xy, d);
    way_moved(way, q->xy, d, 0.0, p->width, out);
    if (k + 2 >= way->points.n || p->given || q->given) return;
    fold_direction(q->xy, q[1].xy, e);
    const double sine = way->out * (d[0] * e[1] - d[1] * e[0]), cosine = d[0] * e[0] + d[1] * e[1];
    if (fabs(sine) < 1e-9) return;
    const double a = (q->width - p->width * cosine) / sine, b = (p->width - q->width * cosine) / sine;
    if (sine > 0.0 ? a < 0.0 || b < 0.0 : -a > mus__dist2(p->xy, q->xy) || -b > mus__dist2(q->xy, q[1].xy)) return;
    way_moved(way, q->xy, d, a, p->width, out);
}


/* find where the edge and its cut line meet the fold; false when one of them does not, before the mouth is reached */
static bool way_meet(const mus__cut_dart *own, fold_way *way)
{
    const mus__cut_corner *list = way->points.list;
    bool sewn = false, cut = false;
    for (int32_t k = 0; k + 1 < way->points.n && !(sewn && cut); k++) {
        const double *p = list[k].xy, *q = list[k + 1].xy;
        const double f = fold_beyond(way, own->point, p), g = fold_beyond(way, own->point, q);
        double d[2], joint[2];
        if (!sewn && g >= 0.0) {
            const double t = f != g ? f / (f - g) : 1.0;
            for (int32_t i = 0; i < 2; i++) way->sewn[i] = p[i] + t * (q[i] - p[i]);
            sewn = true;
        }
        way_joint(way, k, joint);
        if (cut || fold_beyond(way, own->point, joint) < 0.0) continue;
        fold_direction(p, q, d);
        way_moved(way, p, d, 0.0, list[k].width, way->cut);
        const double rate = way->ahead * (way->ray[0] * d[1] - way->ray[1] * d[0]);
        way->along = rate > 0.0 ? -fold_beyond(way, own->point, way->cut) / rate : mus__dist2(p, q);
        way_moved(way, p, d, way->along, list[k].width, way->cut);
        way->side = k, cut = true;
    }
    const double x = way->sewn[0] - own->point[0], y = way->sewn[1] - own->point[1];
    return sewn && cut && way->ray[0] * x + way->ray[1] * y > 0.0;
}


/*
 * Add the end of a cap: `near` takes the way to the half that comes first in the ring, `far` to the other one. Both cut
 * lines end in one point, so it is given there: as the allowance of a point F of the side that it lies on, or, where
 * that lies before the side, beyond the corner V that the cut line turns at.
 */
static void cap_end(const fold_way *way, const fold_map *near, const fold_map *far, mus__cut_ring *out)
{
    const mus__cut_corner *side = &way->points.list[way->side];
    mus__cut_corner given = {.dart = MUS_NONE, .given = true}, last = *side;
    double d[2], f[2], joint[2];
    fold_direction(side->xy, side[1].xy, d);
    if (way->along > MUS__CUT_SAME || way->side == 0) {
        way_moved(way, side->xy, d, fmax(way->along, MUS__CUT_SAME), 0.0, f);
        fold_point(near, f, given.xy);
        fold_point(far, f, last.xy);
        if (mus__dist2(given.xy, last.xy) > MUS__CUT_SAME) mus__cut_add(out, &given);
        mus__cut_add(out, &last);
        return;
    }
    way_joint(way, way->side - 1, joint);
    const bool turns = mus__dist2(joint, way->cut) > MUS__CUT_SAME;
    fold_point(near, joint, given.xy);
    if (turns) mus__cut_add(out, &given);
    fold_point(near, way->cut, given.xy);
    mus__cut_add(out, &given);
    fold_point(far, joint, given.xy);
    if (turns) mus__cut_add(out, &given);
}


/* add the cap of the mouth at side `mouth`, without its second end; a straight line when the fold meets no edge */
static void fold_cap(const mus__cut_ring *in, int32_t mouth, mus__cut_dart *darts, mus__cut_ring *out)
{
    mus__cut_dart *own = &darts[in->list[mouth].dart];
    fold_way way = {.points = {.context = in->context}};
    fold_ray(own, &way);
    fold_walk(in, mouth, darts, &way);
    mus__cut_corner first = in->list[mouth];
    first.dart = MUS_NONE;
    for (int32_t d = 0; d < 2; d++) own->peak[d] = 0.5 * (own->mouth[0][d] + own->mouth[1][d]);
    if (way.points.status != MUS_OK) {
        out->status = way.points.status;
    } else if (!way_meet(own, &way)) {
        mus__cut_add(out, &first);
    } else {
        /* the half beside the cloth that it is folded onto is a mirror image, the other is turned */
        const fold_map mirror = mouth_mirror(own, own->onto_second ? 1 : 0), turn = mouth_turn(own, own->onto_second);
        const fold_map *near = own->onto_second ? &turn : &mirror, *far = own->onto_second ? &mirror : &turn;
        const bool beside = way.along > MUS__CUT_SAME || way.side == 0;
        const int32_t m = way.side;
        fold_point(&mirror, way.sewn, own->peak);
        for (int32_t k = 0; k <= m; k++) {
            mus__cut_corner corner = way.points.list[k];
            fold_point(near, way.points.list[k].xy, corner.xy);
            if (k == 0) memcpy(corner.xy, own->mouth[0], sizeof corner.xy);
            if (k == m && !beside) corner.width = 0.0, corner.given = true;
            mus__cut_add(out, &corner);
        }
        cap_end(&way, near, far, out);
        for (int32_t k = m; k > 0; k--) {
            mus__cut_corner corner = way.points.list[k - 1];
            fold_point(far, way.points.list[k].xy, corner.xy);
            mus__cut_add(out, &corner);
        }
    }
    mus__free(in->context, way.points.list);
}


void mus__cut_fold_darts(const mus__cut_ring *in, mus__cut_dart *darts, mus__cut_ring *out)
{
    for (int32_t i = 0; i < in->n && out->status == MUS_OK; i++) {
        if (in->list[i].dart == MUS_NONE) mus__cut_add(out, &in->list[i]);
        else fold_cap(in, i, darts, out);
    }
}
