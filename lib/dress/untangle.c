/*
 * untangle.c: cloth that crosses cloth is drawn apart until an exact count finds no crossing.
 *
 * Two sheets that cross have a contour in common. Where an edge of one sheet goes through a triangle of the other at
 * the point I, the contour goes on from I into each triangle F at that edge, along the unit vector R in both planes.
 * Moving the edge by d against the triangle moves I by d - (d.N)/(E.N) E, with N the normal of the triangle and E the
 * unit vector along the edge, and changes the length of the contour by  -d.G,
 *
 *     G = sum over F of  R - (E.R)/(E.N) N,
 *
 * so the edge is moved along G and the triangle against it.
 * Source: Volino, Magnenat-Thalmann, Resolving Surface Collisions through Intersection Contour Minimization, ACM Trans.
 * Graph. 25 (2006).
 *
 * The first rounds are such moves alone: a cloth that was put where a coarser cut lay is full of force, and would run
 * through itself where it may. Crossings that are left then get some steps between the moves, in which triangles that
 * do not cross are kept apart and the body keeps its clearance. Nothing tells which sheet was outside: a shallow
 * crossing goes; one sheet halfway through another stays, and is counted.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "dress/dynamic_relaxation.h"
#include "dress/sew.h"
#include "geom/vec.h"

#define UNTANGLE_ROUNDS 80  /* chosen, as all of these; `make corpus` shows crossings left and seconds */
#define UNTANGLE_PLAIN 50   /* of them without steps */
#define UNTANGLE_STEPS 12   /* in each of the other rounds */
#define UNTANGLE_DRAG 40.0  /* [1/s] */
#define UNTANGLE_SPEED 1.0  /* [m/s] */
#define UNTANGLE_MOVE 0.5   /* of the thickness: the largest move of a node in a round */
#define UNTANGLE_LEAST 0.05 /* of the thickness: nearer pairs are put apart to this distance */
#define UNTANGLE_PARTS 12   /* rounds of that at most */
#define UNTANGLE_STEEP 0.1  /* least |E.N|: bounds the move of an edge that runs along the triangle */
#define UNTANGLE_SAFETY 0.7 /* the step, as a share of the bound of symplectic Euler */

typedef struct untangle {
    const mus_drape *drape;
    double *move;   /* (n x 3) weighted sums of the moves of each node [1] */
    double *weight; /* (n) sums of the weights */
} untangle;


/* the corner of triangle `of` that is not on its edge p q */
static int32_t untangle_third(const mus__self_contact *self, int32_t of, int32_t p, int32_t q)
{
    const int32_t *corner = self->triangle + 3 * (int64_t)of;
    for (int32_t k = 0; k < 3; k++)
        if (corner[k] != p && corner[k] != q) return corner[k];
    return corner[0];
}


/* adds a move of a node with a weight */
static void untangle_give(const untangle *u, int32_t node, double share, const double *move)
{
    for (int32_t d = 0; d < 3; d++) u->move[3 * (int64_t)node + d] += share * move[d];
    u->weight[node] += fabs(share);
}


/* adds the moves of one crossing: edge p q of triangle `of` goes through triangle `met` */
static void untangle_note(void *user, int32_t p, int32_t q, int32_t of, int32_t met)
{
    const untangle *u = user;
    const mus__self_contact *self = u->drape->self;
    const double *x = u->drape->x;
    const int32_t *corner = self->triangle + 3 * (int64_t)met;
    const double *a = x + 3 * (int64_t)corner[0], *b = x + 3 * (int64_t)corner[1], *c = x + 3 * (int64_t)corner[2];
    const double *from = x + 3 * (int64_t)p, *to = x + 3 * (int64_t)q;
    const double *third = x + 3 * (int64_t)untangle_third(self, of, p, q);
    double ab[3], ac[3], way[3], off[3], inward[3], normal[3], own[3], along[3];
    for (int32_t d = 0; d < 3; d++) {
        ab[d] = b[d] - a[d], ac[d] = c[d] - a[d], way[d] = to[d] - from[d];
        off[d] = from[d] - a[d], inward[d] = third[d] - from[d];
    }
    const double length = mus__norm3(way);
    mus__cross3(ab, ac, normal);
    mus__unit3(normal);
    mus__cross3(way, inward, own);
    mus__cross3(normal, own, along);
    if (!(length > 0.0) || !(mus__norm3(along) > 0.0)) return;
    mus__unit3(along);
    mus__unit3(way);

    /* the direction of the contour into `of`, away from the edge */
    const double on_edge = mus__dot3(inward, way);
    for (int32_t d = 0; d < 3; d++) inward[d] -= on_edge * way[d];
    if (mus__dot3(along, inward) < 0.0)
        for (int32_t d = 0; d < 3; d++) along[d] = -along[d];

    const double rise = mus__dot3(way, normal), height = mus__dot3(off, normal);
    const double steep = fabs(rise) > UNTANGLE_STEEP ? rise : rise < 0.0 ? -UNTANGLE_STEEP : UNTANGLE_STEEP;
    const double part = fabs(rise) * length > 0.0 ? fmin(fmax(-height / (rise * length), 0.0), 1.0) : 0.5;
    double move[3], place[3], share[3];
    for (int32_t d = 0; d < 3; d++) {
        move[d] = along[d] - mus__dot3(way, along) / steep * normal[d];
        place[d] = from[d] + part * length * way[d] - a[d];
    }

    /* barycentric coordinates of the crossing point in `met` */
    const double bb = mus__dot3(ab, ab), cc = mus__dot3(ac, ac), bc = mus__dot3(ab, ac), det = bb * cc - bc * bc;
    const double pb = mus__dot3(place, ab), pc = mus__dot3(place, ac);
    share[1] = det > 0.0 ? (cc * pb - bc * pc) / det : 0.0;
    share[2] = det > 0.0 ? (bb * pc - bc * pb) / det : 0.0;
    share[0] = 1.0 - share[1] - share[2];
    untangle_give(u, p, 1.0 - part, move);
    untangle_give(u, q, part, move);
    for (int32_t k = 0; k < 3; k++) untangle_give(u, corner[k], -share[k], move);
}


/* moves the nodes along the mean of their moves, at most UNTANGLE_MOVE */
static void untangle_move(mus_drape *drape, const untangle *u)
{
    const double most = UNTANGLE_MOVE * drape->def.thickness;
    for (int32_t i = 0; i < drape->n; i++) {
        if (!(u->weight[i] > 0.0) || drape->pinned[i]) continue;
        double move[3];
        for (int32_t d = 0; d < 3; d++) move[d] = u->move[3 * (int64_t)i + d] / u->weight[i];
        const double length = mus__norm3(move), scale = most * (length > 1.0 ? 1.0 / length : 1.0);
        for (int32_t d = 0; d < 3; d++) drape->x[3 * (int64_t)i + d] += scale * move[d];
    }
}


/* a batch of steps without gravity: springs and the body act, and triangles that do not cross are kept apart */
static mus_status untangle_ease(mus_drape *drape)
{
    static const mus__relax_rule rule = {.drag = UNTANGLE_DRAG, .speed_limit = UNTANGLE_SPEED, .grip = 1.0};
    memset(drape->v, 0, 3 * (size_t)drape->n * sizeof *drape->v);
    mus__drape_push(drape);
    const double h = mus__relax_step(drape, UNTANGLE_SAFETY, 0.0);
    mus_status status = mus__relax_ready(drape, &rule, h);
    if (status != MUS_OK) return status;
    int32_t steps = UNTANGLE_STEPS;
    status = mus__relax_run(drape, NULL, h, &steps, 0);
    mus__drape_tick(drape, steps, h, 1);
    mus__drape_publish(drape);
    return status;
}


mus_status mus__untangle_part(mus_drape *drape)
{
    const double least = UNTANGLE_LEAST * drape->def.thickness;
    double *was = mus__new(drape->context, 3 * (int64_t)drape->n, sizeof *was);
    mus_status status = was != NULL ? MUS_OK : mus__fail_memory(drape->context, "what untangling takes back");
    for (int32_t k = 0; k < UNTANGLE_PARTS && status == MUS_OK; k++) {
        mus__drape_push(drape);
        drape->self->invalid = 1;
        status = mus__drape_self_ready(drape, drape->sim.rule.slip);
        if (status != MUS_OK) break;
        memcpy(was, drape->x, 3 * (size_t)drape->n * sizeof *was);
        if (mus__self_contact_separate(drape->self, least, drape->pinned, drape->x) == 0) break;
        if (mus__self_contact_mark_crossings(drape->self, drape->x, NULL, NULL) == 0) continue;
        memcpy(drape->x, was, 3 * (size_t)drape->n * sizeof *was);
        break;
    }
    mus__free(drape->context, was);
    return status;
}


/* the rounds; *left gets the number of pairs of triangles that still cross. Errors: MUS_ERR_DIVERGED, MUS_ERR_LIMIT,
 * MUS_ERR_MEMORY */
static mus_status untangle_rounds(mus_drape *drape, int64_t *left)
{
    untangle u = {.drape = drape};
    bool moved = false;
    u.move = mus__new(drape->context, 4 * (int64_t)drape->n, sizeof *u.move);
    if (u.move == NULL) return mus__fail_memory(drape->context, "the moves of untangling");
    u.weight = u.move + 3 * (int64_t)drape->n;
    mus_status status = mus__drape_plane_cache(drape);
    mus__drape_publish(drape);
    for (int32_t k = 0; status == MUS_OK; k++) {
        memset(u.move, 0, 4 * (size_t)drape->n * sizeof *u.move);
        *left = mus__self_contact_mark_crossings(drape->self, drape->x, untangle_note, &u);
        if (*left == 0 || k == UNTANGLE_ROUNDS) break;
        untangle_move(drape, &u);
        moved = true;
        if (k < UNTANGLE_PLAIN) continue;
        status = untangle_ease(drape);
    }

    /* sheets that no longer cross may lie closer than a float state can tell apart, and could not move then */
    if (status == MUS_OK && *left == 0 && moved) status = mus__untangle_part(drape);
    mus__free(drape->context, u.move);
    drape->sim.plane_cache = NULL;
    memset(drape->v, 0, 3 * (size_t)drape->n * sizeof *drape->v);
    mus__drape_push(drape);
    mus__drape_publish(drape);
    return status;
}


mus_status mus__untangle(mus_drape *drape)
{
    int64_t left;
    return drape->self != NULL ? untangle_rounds(drape, &left) : MUS_OK;
}


mus_status mus_drape_untangle(mus_drape *drape, int64_t *left)
{
    if (left != NULL) *left = 0;
    if (drape == NULL) return MUS_ERR_ARG;
    if (left == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: left is NULL");
    if (drape->self == NULL) return mus__fail(drape->context, MUS_ERR_STATE, "drape: untangling needs self_contact");
    mus_status status = mus__scene_require_rest(drape, "untangle");
    if (status != MUS_OK) return status;
    status = untangle_rounds(drape, left);
    mus__drape_publish(drape);
    if (status != MUS_OK || *left == 0) return status;
    return mus__fail(drape->context, MUS_ERR_TANGLED, "drape: %lld pairs of triangles still cross", (long long)*left);
}
