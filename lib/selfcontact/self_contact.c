/*
 * self_contact.c: memory of self-contact, and what it knows of the mesh: classes, groups, thickness, trees.
 *
 * Corners, edges and triangles are in a tree each, every one of them once, so that a pair is met once. They are in the
 * order of the triangles that have them first, and these along a curve that keeps near what is near in the flat
 * (Morton, A computer oriented geodetic data base, 1966).
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "geom/union_find.h"
#include "selfcontact/self_contact.h"

#define SELF_PAIRS_FIRST 8  /* pairs a node in the memory taken first; it grows when there are more; chosen */
#define SELF_PAIRS_MAX 1024 /* most pairs a node; chosen: only crumpled cloth has more */
#define SELF_FLAT 0.5   /* thickness at a seam over the least height of a triangle: flat cloth does not touch itself */
#define SELF_MARGIN 0.2 /* margin of the list over the mean edge; chosen: more means longer lists, less more lists */
#define SELF_YIELD 0.7  /* of the thickness allowed before: a yield takes no more; see mus__self_contact_yield() */
#define SELF_THINNEST 0.25 /* of the thickness: pairs that yielded are no thinner; likewise */

typedef struct self_edge {
    int32_t low, high, at; /* nodes; 8 times its triangle plus its place there */
} self_edge;


void mus__self_classes(int32_t nodes, int32_t npair, const int32_t *pair, int32_t *class_of)
{
    mus__union_start(nodes, class_of, NULL);
    for (int32_t p = 0; p < npair; p++) mus__union_join(class_of, NULL, pair[2 * p], pair[2 * p + 1], 1);
    for (int32_t i = 0; i < nodes; i++) mus__union_find(class_of, NULL, i);
}


/* groups: classes joined by the triangles too */
static void self_groups(mus__self_contact *self)
{
    const mus__self_mesh *flat = &self->flat;
    memcpy(self->group, self->class_of, (size_t)flat->nodes * sizeof *self->group);
    for (int64_t e = 0; e < 3 * (int64_t)flat->ntriangle; e++) {
        const int64_t next = e % 3 == 2 ? e - 2 : e + 1;
        mus__union_join(self->group, NULL, flat->triangle[e], flat->triangle[next], 1);
    }
    for (int32_t i = 0; i < flat->nodes; i++) mus__union_find(self->group, NULL, i);
}


/* least height of a triangle in the flat; *edge: mean length of its edges [m] */
static double self_height(const double *a, const double *b, const double *c, double *edge)
{
    const double u[2] = {b[0] - a[0], b[1] - a[1]}, v[2] = {c[0] - a[0], c[1] - a[1]};
    const double w[2] = {c[0] - b[0], c[1] - b[1]}, area2 = fabs(u[0] * v[1] - u[1] * v[0]);
    const double ul = sqrt(u[0] * u[0] + u[1] * u[1]), vl = sqrt(v[0] * v[0] + v[1] * v[1]);
    const double wl = sqrt(w[0] * w[0] + w[1] * w[1]), longest = fmax(ul, fmax(vl, wl));
    *edge = (ul + vl + wl) / 3.0;
    return longest > 0.0 ? area2 / longest : 0.0;
}


/* thickness at seams, and how far the list of pairs is to reach */
static void self_thickness(mus__self_contact *self)
{
    const mus__self_mesh *flat = &self->flat;
    double edges = 0.0, edge;
    uint8_t *sewn = self->rank;
    memset(sewn, 0, (size_t)flat->nodes);
    for (int32_t p = 0; p < 2 * flat->npair; p++) sewn[flat->pair[p]] = 1;
    for (int32_t i = 0; i < flat->nodes; i++) self->seam_thick[i] = (float)self->thickness;
    for (int64_t t = 0; t < flat->ntriangle; t++) {
        const int32_t *corner = flat->triangle + 3 * t;
        const double height = self_height(flat->rest + 2 * (int64_t)corner[0], flat->rest + 2 * (int64_t)corner[1],
                                          flat->rest + 2 * (int64_t)corner[2], &edge);
        edges += edge;
        if (!sewn[corner[0]] && !sewn[corner[1]] && !sewn[corner[2]]) continue;
        for (int32_t k = 0; k < 3; k++)
            if (SELF_FLAT * height < (double)self->seam_thick[corner[k]])
                self->seam_thick[corner[k]] = (float)(SELF_FLAT * height);
    }
    const double mean = flat->ntriangle > 0 ? edges / flat->ntriangle : 0.0;
    self->mean_edge = mean;
    self->margin = self->margin_max = fmax(SELF_MARGIN * mean, 0.5 * self->thickness);
}


typedef struct self_place {
    uint64_t key;
    int32_t triangle;
} self_place;


static int self_by_place(const void *left, const void *right)
{
    const self_place *a = left, *b = right;
    if (a->key != b->key) return a->key < b->key ? -1 : 1;
    return a->triangle < b->triangle ? -1 : a->triangle > b->triangle;
}


/* sixteen bits of a share of 0..1, a zero before each */
static uint64_t self_spaced(double part)
{
    const uint32_t whole = part > 0.0 ? part < 1.0 ? (uint32_t)(65535.0 * part) : 65535 : 0;
    uint64_t out = 0;
    for (int32_t bit = 0; bit < 16; bit++) out |= (uint64_t)(whole >> bit & 1) << (2 * bit);
    return out;
}


/* orders the triangles by panel, and within it along the curve */
static mus_status self_order(mus__self_contact *self)
{
    const mus__self_mesh *flat = &self->flat;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    self_place *place = mus__new(self->context, flat->ntriangle, sizeof *place);
    if (place == NULL) return mus__fail_memory(self->context, "a cloth's contact with itself");
    for (int64_t i = 0; i < 2 * (int64_t)flat->nodes; i++) {
        low[i % 2] = fmin(low[i % 2], flat->rest[i]);
        high[i % 2] = fmax(high[i % 2], flat->rest[i]);
    }
    const double size = fmax(fmax(high[0] - low[0], high[1] - low[1]), 1e-9);
    for (int32_t t = 0; t < flat->ntriangle; t++) {
        const int32_t *corner = flat->triangle + 3 * (int64_t)t;
        double mean[2] = {0.0, 0.0};
        for (int32_t k = 0; k < 6; k++)
            mean[k % 2] += (flat->rest[2 * (int64_t)corner[k / 2] + k % 2] - low[k % 2]) / 3.0;
        place[t].key =
            (uint64_t)flat->panel[corner[0]] << 32 | self_spaced(mean[0] / size) | self_spaced(mean[1] / size) << 1;
        place[t].triangle = t;
    }
    mus__sort(place, (size_t)flat->ntriangle, sizeof *place, self_by_place);
    for (int32_t t = 0; t < flat->ntriangle; t++) self->order[t] = place[t].triangle;
    mus__free(self->context, place);
    return MUS_OK;
}


/* memory for so many pairs, in place of what there was */
static mus_status self_take_pairs(mus__self_contact *self, int64_t capacity)
{
    const int64_t blocks = capacity / 32 + 1;
    mus__self_pair *pair = mus__new(self->context, capacity, sizeof *pair);
    mus__self_active *active = mus__new(self->context, capacity, sizeof *active);
    int32_t *node = mus__new(self->context, 128 * blocks, sizeof *node);
    float *idle2 = mus__new(self->context, 32 * blocks, sizeof *idle2);
    uint32_t *pressed = mus__new(self->context, blocks, sizeof *pressed);
    const bool taken = pair != NULL && active != NULL && node != NULL && idle2 != NULL && pressed != NULL;
    void *spare[] = {taken ? self->pair : pair, taken ? self->active : active, taken ? self->idle_node : node,
                     taken ? self->idle2 : idle2, taken ? self->pressed : pressed};
    for (size_t i = 0; i < sizeof spare / sizeof spare[0]; i++) mus__free(self->context, spare[i]);
    if (!taken) return mus__fail_memory(self->context, "the pairs of cloth near cloth");
    self->pair = pair, self->active = active, self->idle_node = node, self->idle2 = idle2, self->pressed = pressed;
    self->pair_capacity = (int32_t)capacity;
    return MUS_OK;
}


/* the arrays, the grid and the trees, all zeros */
static mus_status self_allocate(mus__self_contact *self)
{
    mus_context *context = self->context;
    const mus__self_mesh *flat = &self->flat;
    const int64_t nodes = flat->nodes, triangles = flat->ntriangle, planes = 3 * (int64_t)self->n;
    const size_t real = self->real;
    const struct {
        void *array;
        int64_t count;
        size_t size;
    } arrays[] = {{&self->class_of, nodes, 4},
                  {&self->group, nodes, 4},
                  {&self->triangle, 3 * triangles, 4},
                  {&self->order, triangles, 4},
                  {&self->own, triangles, 1},
                  {&self->seam_thick, nodes, sizeof(float)},
                  {&self->thick_max, nodes, sizeof(float)},
                  {&self->bound, 4 * (int64_t)self->n, real},
                  {&self->list_home, planes, real},
                  {&self->drift, planes, real},
                  {&self->stale, nodes, 1},
                  {&self->travel2, self->n, real},
                  {&self->active_node, nodes, 1},
                  {&self->at, 8 * (int64_t)self->n, real},
                  {&self->force, planes, real},
                  {&self->before_body, planes, real},
                  {&self->support, planes, real},
                  {&self->rank, nodes, 1},
                  {&self->last_rank, nodes, 1},
                  {&self->crossed, nodes, 1},
                  {&self->pass, nodes, 1}};
    mus_status status = mus__box_grid_create(context, flat->ntriangle, &self->grid);
    if (status == MUS_OK) status = mus__box_tree_create(context, 1, flat->nodes, &self->corners);
    if (status == MUS_OK) status = mus__box_tree_create(context, 2, 3 * flat->ntriangle, &self->edges);
    if (status == MUS_OK) status = mus__box_tree_create(context, 3, flat->ntriangle, &self->faces);
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0] && status == MUS_OK; i++) {
        void *block = mus__new(context, arrays[i].count, arrays[i].size);
        memcpy(arrays[i].array, &block, sizeof block);
        if (block == NULL) status = mus__fail_memory(context, "a cloth's contact with itself");
    }
    return status == MUS_OK ? self_take_pairs(self, self->pair_capacity) : status;
}


mus_status mus__self_contact_create(mus_context *context, size_t real, int32_t n, const mus__self_mesh *flat,
                                    double thickness, double friction, mus__self_contact **out)
{
    *out = NULL;
    mus__self_contact *self = mus__new(context, 1, sizeof *self);
    if (self == NULL) return mus__fail_memory(context, "a cloth's contact with itself");
    self->context = context;
    self->real = real;
    self->n = n;
    self->nodes = flat->nodes;
    self->flat = *flat;
    self->thickness = thickness;
    self->friction = friction;
    self->pair_capacity = (int32_t)fmin(SELF_PAIRS_FIRST * (double)flat->nodes + 256.0, 1e9);
    mus_status status = self_allocate(self);
    if (status == MUS_OK) status = self_order(self);
    if (status != MUS_OK) {
        mus__self_contact_destroy(self);
        return status;
    }
    mus__self_classes(flat->nodes, flat->npair, flat->pair, self->class_of);
    self_groups(self);
    self_thickness(self);
    mus__self_contact_weld(self, NULL, NULL, 0);
    *out = self;
    return MUS_OK;
}


void mus__self_contact_destroy(mus__self_contact *self)
{
    if (self == NULL) return;
    mus_context *context = self->context;
    mus__box_grid_destroy(context, &self->grid);
    mus__box_tree_destroy(context, &self->corners);
    mus__box_tree_destroy(context, &self->edges);
    mus__box_tree_destroy(context, &self->faces);
    void *blocks[] = {self->class_of,    self->group,     self->triangle,    self->order,     self->own,
                      self->seam_thick,  self->thick_max, self->bound,       self->list_home, self->drift,
                      self->stale,       self->travel2,   self->active_node, self->at,        self->force,
                      self->before_body, self->support,   self->rank,        self->last_rank, self->crossed,
                      self->pass,        self->pair,      self->active,      self->idle_node, self->idle2,
                      self->pressed};
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


/* corners and edges that each triangle has first, in their order; slot (flat.ntriangle): its place in self->triangle,
 * or MUS_NONE */
static void self_own(mus__self_contact *self, const int32_t *slot)
{
    const int32_t all = self->flat.ntriangle;
    memset(self->rank, 0, (size_t)self->nodes);            /* free as a mark: it is worked out anew below */
    self_edge *edge = (self_edge *)(void *)self->grid.box; /* the boxes are free between counts: 48 bytes a triangle */
    int64_t count = 0;
    for (int32_t i = 0; i < all; i++) {
        const int32_t *corner = self->triangle + 3 * (int64_t)slot[self->order[i]];
        self->own[i] = 0;
        for (int32_t k = 0; k < 3 && slot[self->order[i]] >= 0; k++) {
            const int32_t a = corner[k], b = corner[(k + 1) % 3];
            if (!self->rank[a]) self->own[i] |= (uint8_t)(1 << k);
            self->rank[a] = 1;
            edge[count++] = (self_edge){a < b ? a : b, a < b ? b : a, 8 * i + k};
        }
    }
    mus__sort(edge, (size_t)count, sizeof *edge, self_by_edge);
    for (int64_t e = 0; e < count; e++)
        if (e == 0 || edge[e].low != edge[e - 1].low || edge[e].high != edge[e - 1].high)
            self->own[edge[e].at / 8] |= (uint8_t)(8 << edge[e].at % 8);
    memset(self->rank, MUS__RANK_NONE, (size_t)self->nodes);
    memset(self->last_rank, MUS__RANK_NONE, (size_t)self->nodes);
}


void mus__self_contact_weld(mus__self_contact *self, const int32_t *rep, const int32_t *flags, int32_t absent)
{
    const int32_t *triangle = self->flat.triangle;
    int32_t *slot = self->grid.of; /* free between counts */
    self->ntriangle = 0;
    for (int32_t i = 0; i < self->nodes; i++) self->thick_max[i] = (float)self->thickness;
    for (int64_t t = 0; t < self->flat.ntriangle; t++) {
        int32_t *to = self->triangle + 3 * (int64_t)self->ntriangle;
        slot[t] = MUS_NONE;
        if (flags != NULL && (flags[triangle[3 * t]] & absent)) continue;
        for (int32_t k = 0; k < 3; k++) {
            const int32_t node = triangle[3 * t + k];
            to[k] = rep != NULL ? rep[node] : node;
        }
        const int32_t a = self->class_of[to[0]], b = self->class_of[to[1]], c = self->class_of[to[2]];
        if (a != b && b != c && c != a) slot[t] = self->ntriangle++;
    }
    self_own(self, slot);

    /* the trees */
    mus__box_tree_clear(&self->corners);
    mus__box_tree_clear(&self->edges);
    mus__box_tree_clear(&self->faces);
    for (int32_t i = 0; i < self->flat.ntriangle; i++) {
        if (slot[self->order[i]] < 0) continue;
        const int32_t *corner = self->triangle + 3 * (int64_t)slot[self->order[i]];
        mus__box_tree_add(&self->faces, corner, self->class_of);
        for (int32_t k = 0; k < 3; k++) {
            const int32_t edge[2] = {corner[k], corner[(k + 1) % 3]};
            if (self->own[i] >> k & 1) mus__box_tree_add(&self->corners, edge, self->class_of);
            if (self->own[i] >> (3 + k) & 1) mus__box_tree_add(&self->edges, edge, self->class_of);
        }
    }
    mus__box_tree_raise(&self->edges, 0);
    mus__box_tree_raise(&self->faces, 0);
    mus__box_tree_raise(&self->corners, self->faces.tiers);
    if (self->corners.tiers > self->faces.tiers) mus__box_tree_raise(&self->faces, self->corners.tiers);
    self->invalid = 1;
}


/* Pairs yield in steps, and no further than to a quarter: through a tenth of the thickness springs press nodes in one
 * step, and then their bounds hold them there; from all to half at once did the same (both seen) */
int32_t mus__self_contact_yield(mus__self_contact *self, const uint8_t *marked)
{
    const float least = (float)(SELF_THINNEST * self->thickness);
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    int32_t gave = 0;
    for (int32_t i = 0; i < self->nodes; i++) {
        if (!marked[i] || !(self->thick_max[i] > least)) continue;
        self->thick_max[i] = fmaxf((float)SELF_YIELD * self->thick_max[i], least);
        gave = 1;
    }
    for (int32_t k = 0; gave && k < self->pair_capacity; k++) {
        if (k == self->nnode_pair) k = edges;
        if (k == self->pair_capacity) break;
        mus__self_pair *pair = &self->pair[k];
        for (int32_t i = 0; i < 4; i++) pair->thickness = fminf(pair->thickness, self->thick_max[pair->node[i]]);
    }
    for (int32_t k = 0; k < self->nactive; k++) self->active[k].thickness = self->pair[self->active[k].pair].thickness;
    return gave;
}


int32_t mus__self_contact_expires(const mus__self_contact *self, double h)
{
    return !(self->bound_age + h <= self->bound_span);
}


mus_status mus__self_contact_grow(mus__self_contact *self)
{
    const int64_t most = SELF_PAIRS_MAX * (int64_t)self->nodes + 256;
    if (!self->full && 2 * (int64_t)self->pairs_max < self->pair_capacity) return MUS_OK;
    const int64_t capacity = 2 * (int64_t)self->pair_capacity;
    if (!self->full && (capacity > most || capacity > INT32_MAX)) return MUS_OK;
    if (capacity > most || capacity > INT32_MAX)
        return mus__fail(self->context, MUS_ERR_LIMIT,
                         "drape: more than %d pairs of cloth and cloth are nearer than %g mm; the cloth is crumpled",
                         (int)self->pair_capacity, 1e3 * self->thickness);
    const mus_status status = self_take_pairs(self, capacity);
    if (status != MUS_OK) return status;
    self->npair = self->nactive = self->nnode_pair = 0;
    self->full = 0;
    self->invalid = 1;
    return MUS_OK;
}


typedef struct self_tangle {
    mus__self_contact *self;
    mus__crossing_fn fn;
    void *user;
} self_tangle;


static void self_mark(void *user, int32_t p, int32_t q, int32_t of, int32_t met)
{
    const self_tangle *tangle = user;
    mus__self_contact *self = tangle->self;
    for (int32_t k = 0; k < 3; k++) {
        self->crossed[self->triangle[3 * (int64_t)of + k]] = 1;
        self->crossed[self->triangle[3 * (int64_t)met + k]] = 1;
    }
    if (tangle->fn != NULL) tangle->fn(tangle->user, p, q, of, met);
}


int64_t mus__self_contact_mark_crossings(mus__self_contact *self, const double *x, mus__crossing_fn fn, void *user)
{
    self_tangle tangle = {self, fn, user};
    memset(self->crossed, 0, (size_t)self->nodes);
    const int64_t count =
        mus__crossing_count(&self->grid, self->ntriangle, self->triangle, self->class_of, x, self_mark, &tangle);

    /* and their neighbours, to which a crossing may move */
    for (int64_t t = 0; count > 0 && t < 3 * (int64_t)self->ntriangle; t += 3) {
        const int32_t *corner = self->triangle + t;
        if (self->crossed[corner[0]] != 1 && self->crossed[corner[1]] != 1 && self->crossed[corner[2]] != 1) continue;
        for (int32_t k = 0; k < 3; k++)
            if (self->crossed[corner[k]] == 0) self->crossed[corner[k]] = 2;
    }
    self->ncrossed = 0;
    for (int32_t i = 0; i < self->nodes; i++) {
        if (self->pass[i]) self->crossed[i] = 1;
        self->ncrossed += self->crossed[i] != 0;
    }
    self->invalid = 1;
    return count;
}
