/*
 * cloth_self.c: the memory of a cloth's contact with itself, and what it knows of the mesh.
 *
 * Each node and each edge belongs to one triangle that answers for it, so that a pair of features is met once: by the
 * two triangles of its owners (Curtis, Tamstorf, Manocha, Fast Collision Detection for Deformable Models using
 * Representative-Triangles, 2008).
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/cloth_self.h"

#define SELF_FIRST_PAIRS 8  /* a node; more when there are more */
#define SELF_MOST_PAIRS 1024
#define SELF_FLAT 0.5       /* of the least height of a triangle: flat cloth does not touch itself */
#define SELF_SKIN 0.2       /* of the mean edge */

typedef struct self_edge {
    int32_t low, high, at; /* nodes; 8 times its triangle and its place there */
} self_edge;


static int32_t self_root(int32_t *class_of, int32_t i)
{
    while (class_of[i] != i) {
        class_of[i] = class_of[class_of[i]];
        i = class_of[i];
    }
    return i;
}


void mus__cloth_classes(int32_t nodes, int32_t npair, const int32_t *pair, int32_t *class_of)
{
    for (int32_t i = 0; i < nodes; i++) class_of[i] = i;
    for (int32_t p = 0; p < npair; p++) {
        const int32_t a = self_root(class_of, pair[2 * p]), b = self_root(class_of, pair[2 * p + 1]);
        if (a < b) class_of[b] = a;
        else class_of[a] = b;
    }
    for (int32_t i = 0; i < nodes; i++) class_of[i] = self_root(class_of, i);
}


static void self_put(const mus__cloth_self *self, void *array, int64_t i, double value)
{
    if (self->real == sizeof(float)) ((float *)array)[i] = (float)value;
    else ((double *)array)[i] = value;
}


static double self_number(const mus__cloth_self *self, const void *array, int64_t i)
{
    return self->real == sizeof(float) ? (double)((const float *)array)[i] : ((const double *)array)[i];
}


/* thickness at the nodes, from the heights of triangles in the flat; how far the list of pairs is to reach */
static void self_thickness(mus__cloth_self *self, int32_t ntriangle, const int32_t *triangle, const double *rest)
{
    double edges = 0.0;
    for (int32_t i = 0; i < self->nodes; i++) self_put(self, self->thick, i, self->thickness);
    for (int64_t t = 0; t < ntriangle; t++) {
        const double *a = rest + 2 * (int64_t)triangle[3 * t], *b = rest + 2 * (int64_t)triangle[3 * t + 1];
        const double *c = rest + 2 * (int64_t)triangle[3 * t + 2];
        const double u[2] = {b[0] - a[0], b[1] - a[1]}, v[2] = {c[0] - a[0], c[1] - a[1]};
        const double w[2] = {c[0] - b[0], c[1] - b[1]}, area2 = fabs(u[0] * v[1] - u[1] * v[0]);
        const double uu = u[0] * u[0] + u[1] * u[1], vv = v[0] * v[0] + v[1] * v[1], ww = w[0] * w[0] + w[1] * w[1];
        const double longest = sqrt(fmax(uu, fmax(vv, ww))), height = longest > 0.0 ? area2 / longest : 0.0;
        edges += (sqrt(uu) + sqrt(vv) + sqrt(ww)) / 3.0;
        for (int32_t k = 0; k < 3; k++)
            if (SELF_FLAT * height < self_number(self, self->thick, triangle[3 * t + k]))
                self_put(self, self->thick, triangle[3 * t + k], SELF_FLAT * height);
    }
    self->skin = ntriangle > 0 ? fmax(SELF_SKIN * edges / ntriangle, 0.25 * self->thickness) : self->thickness;
}


mus_status mus__cloth_self_create(mus_context *context, size_t real, int32_t n, int32_t nodes, int32_t ntriangle,
                                  const int32_t *triangle, const double *rest, int32_t npair, const int32_t *pair,
                                  double thickness, double friction, mus__cloth_self **out)
{
    *out = NULL;
    mus__cloth_self *self = mus__new(context, 1, sizeof *self);
    if (self == NULL) return mus__fail_memory(context, "a cloth's contact with itself");
    self->context = context;
    self->real = real;
    self->n = n;
    self->nodes = nodes;
    self->thickness = thickness;
    self->friction = friction;
    self->pair_capacity = (int32_t)fmin(SELF_FIRST_PAIRS * (double)nodes + 256.0, 1e9);
    self->class_of = mus__new(context, nodes, sizeof *self->class_of);
    self->triangle = mus__new(context, 3 * (int64_t)ntriangle, sizeof *self->triangle);
    self->own = mus__new(context, ntriangle, 1);
    self->thick = mus__new(context, n, real);
    self->ball = mus__new(context, 4 * (int64_t)n, real);
    self->home = mus__new(context, 3 * (int64_t)n, real);
    self->force = mus__new(context, 3 * (int64_t)n, real);
    self->level = mus__new(context, nodes, 1);
    self->pair = mus__new(context, self->pair_capacity, sizeof *self->pair);
    self->touch = mus__new(context, self->pair_capacity, sizeof *self->touch);
    mus_status status = mus__cloth_grid_create(context, ntriangle, &self->grid);
    if (status == MUS_OK &&
        (self->class_of == NULL || self->triangle == NULL || self->own == NULL || self->thick == NULL ||
         self->ball == NULL || self->home == NULL || self->force == NULL || self->level == NULL ||
         self->pair == NULL || self->touch == NULL))
        status = mus__fail_memory(context, "a cloth's contact with itself");
    if (status != MUS_OK) {
        mus__cloth_self_destroy(self);
        return status;
    }
    mus__cloth_classes(nodes, npair, pair, self->class_of);
    self_thickness(self, ntriangle, triangle, rest);
    memset(self->level, MUS_SELF_LOOSE, (size_t)nodes);
    mus__cloth_self_weld(self, ntriangle, triangle, NULL);
    *out = self;
    return MUS_OK;
}


void mus__cloth_self_destroy(mus__cloth_self *self)
{
    if (self == NULL) return;
    mus_context *context = self->context;
    mus__cloth_grid_destroy(context, &self->grid);
    void *blocks[] = {self->class_of, self->triangle, self->own,   self->thick, self->ball,
                      self->home,     self->force,    self->level, self->pair,  self->touch};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
    mus__free(context, self);
}


static int self_by_edge(const void *left, const void *right)
{
    const self_edge *a = left, *b = right;
    if (a->low != b->low) return a->low < b->low ? -1 : 1;
    if (a->high != b->high) return a->high < b->high ? -1 : 1;
    return a->at < b->at ? -1 : a->at > b->at;
}


void mus__cloth_self_weld(mus__cloth_self *self, int32_t ntriangle, const int32_t *triangle, const int32_t *rep)
{
    self->ntriangle = 0;
    for (int64_t t = 0; t < ntriangle; t++) {
        int32_t *to = self->triangle + 3 * (int64_t)self->ntriangle;
        for (int32_t k = 0; k < 3; k++) {
            const int32_t node = triangle[3 * t + k];
            to[k] = rep != NULL ? rep[node] : node;
        }
        const int32_t a = self->class_of[to[0]], b = self->class_of[to[1]], c = self->class_of[to[2]];
        self->ntriangle += a != b && b != c && c != a;
    }

    /* the first triangle that has it owns a corner; level is free as a mark, for it is worked out anew */
    memset(self->own, 0, (size_t)self->ntriangle);
    memset(self->level, 0, (size_t)self->nodes);
    for (int64_t t = 0; t < self->ntriangle; t++)
        for (int32_t k = 0; k < 3; k++) {
            uint8_t *known = &self->level[self->triangle[3 * t + k]];
            if (!*known) self->own[t] |= (uint8_t)(1 << k);
            *known = 1;
        }
    memset(self->level, MUS_SELF_LOOSE, (size_t)self->nodes);

    /* and the first of each edge; the grid's boxes, of 48 bytes a triangle, hold them meanwhile */
    self_edge *edge = (self_edge *)(void *)self->grid.box;
    int64_t count = 0;
    for (int32_t t = 0; t < self->ntriangle; t++)
        for (int32_t k = 0; k < 3; k++) {
            const int32_t a = self->triangle[3 * (int64_t)t + k], b = self->triangle[3 * (int64_t)t + (k + 1) % 3];
            edge[count++] = (self_edge){a < b ? a : b, a < b ? b : a, 8 * t + k};
        }
    qsort(edge, (size_t)count, sizeof *edge, self_by_edge);
    for (int64_t e = 0; e < count; e++)
        if (e == 0 || edge[e].low != edge[e - 1].low || edge[e].high != edge[e - 1].high)
            self->own[edge[e].at / 8] |= (uint8_t)(8 << edge[e].at % 8);
    self->stale = 1;
}


mus_status mus__cloth_self_grow(mus__cloth_self *self)
{
    const int64_t most = SELF_MOST_PAIRS * (int64_t)self->nodes + 256;
    if (!self->full && 2 * (int64_t)self->most_pairs < self->pair_capacity) return MUS_OK;
    const int64_t capacity = 2 * (int64_t)self->pair_capacity;
    if (!self->full && (capacity > most || capacity > INT32_MAX)) return MUS_OK;
    if (capacity > most || capacity > INT32_MAX)
        return mus__fail(self->context, MUS_ERR_LIMIT,
                         "drape: more than %d pairs of cloth and cloth are nearer than %g mm; the cloth is crumpled",
                         (int)self->pair_capacity, 1e3 * self->thickness);
    mus__cloth_near *pair = mus__new(self->context, capacity, sizeof *pair);
    int32_t *touch = mus__new(self->context, capacity, sizeof *touch);
    if (pair == NULL || touch == NULL) {
        mus__free(self->context, pair);
        mus__free(self->context, touch);
        return mus__fail_memory(self->context, "the pairs of cloth near cloth");
    }
    mus__free(self->context, self->pair);
    mus__free(self->context, self->touch);
    self->pair = pair;
    self->touch = touch;
    self->pair_capacity = (int32_t)capacity;
    self->npair = self->ntouch = self->nnode_pair = 0;
    self->full = 0;
    self->stale = 1;
    return MUS_OK;
}
