/*
 * placed_cloth.c: faces, middles, normals and crossings of a cloth whose nodes have places.
 */
#include <string.h>

#include "arrange/placed_cloth.h"
#include "selfcontact/self_contact.h"
#include "geom/vec.h"


void mus__placed_facing(const mus__placed_cloth *placed, int32_t panel, double *out)
{
    const mus__panel_mesh *mesh = &placed->cloth->panel[panel];
    double area = 0.0;
    memset(out, 0, 3 * sizeof *out);
    for (int32_t t = mesh->first_triangle; t < mesh->first_triangle + mesh->triangle_count; t++) {
        const int32_t *v = placed->cloth->triangle + 3 * (int64_t)t;
        const double *a = placed->x + 3 * (int64_t)v[0], *b = placed->x + 3 * (int64_t)v[1];
        const double *c = placed->x + 3 * (int64_t)v[2];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, e[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        double normal[3];
        mus__cross3(d, e, normal);
        for (int32_t i = 0; i < 3; i++) out[i] += normal[i];
        area += mus__norm3(normal);
    }
    for (int32_t i = 0; i < 3 && area > 0.0; i++) out[i] /= area;
}


void mus__placed_middle(const mus__placed_cloth *placed, int32_t panel, double *out)
{
    const mus__panel_mesh *mesh = &placed->cloth->panel[panel];
    memset(out, 0, 3 * sizeof *out);
    for (int32_t i = mesh->first_node; i < mesh->first_node + mesh->node_count; i++)
        for (int32_t d = 0; d < 3; d++) out[d] += placed->x[3 * (int64_t)i + d] / mesh->node_count;
}


void mus__placed_normals(const mus__placed_cloth *placed, double *out)
{
    /* area-weighted sum at the representative of each node, then spread to its class */
    const mus_cloth *cloth = placed->cloth;
    const int32_t n = cloth->nnode, *rep = placed->rep;
    memset(out, 0, 3 * (size_t)n * sizeof *out);
    for (int32_t t = 0; t < cloth->ntriangle; t++) {
        const int32_t *i = cloth->triangle + 3 * (int64_t)t;
        const double *a = placed->x + 3 * (int64_t)i[0], *b = placed->x + 3 * (int64_t)i[1];
        const double *c = placed->x + 3 * (int64_t)i[2];
        const double ab[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, ac[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        double normal[3];
        mus__cross3(ab, ac, normal);
        for (int32_t k = 0; k < 3; k++)
            for (int32_t d = 0; d < 3; d++) out[3 * (int64_t)rep[i[k]] + d] += normal[d];
    }
    for (int32_t i = 0; i < n; i++)
        if (rep[i] == i) mus__unit3(out + 3 * (int64_t)i);
    for (int32_t i = 0; i < n; i++)
        if (rep[i] != i) memcpy(out + 3 * (int64_t)i, out + 3 * (int64_t)rep[i], 3 * sizeof *out);
}


/* the pairs of triangles that a count found: the first `most` are kept */
typedef struct crossing_list {
    int32_t *pair, most, last[2];
    int64_t count;
} crossing_list;


/* notes that an edge of triangle `of` goes through triangle `met`; a pair that is found again at once counts once */
static void crossing_note(void *user, int32_t p, int32_t q, int32_t of, int32_t met)
{
    crossing_list *list = user;
    (void)p;
    (void)q;
    const int32_t a = of < met ? of : met, b = of < met ? met : of;
    if (list->count > 0 && list->last[0] == a && list->last[1] == b) return;
    if (list->count < list->most) {
        list->pair[2 * list->count] = a;
        list->pair[2 * list->count + 1] = b;
    }
    list->last[0] = a, list->last[1] = b;
    list->count++;
}


mus_status mus__placed_crossings(const mus__placed_cloth *placed, int32_t most, int32_t *pairs, int64_t *count)
{
    mus_context *context = placed->context;
    const mus_cloth *cloth = placed->cloth;
    mus__box_grid grid;
    *count = 0;
    int32_t *class_of = mus__new(context, cloth->nnode, sizeof *class_of);
    if (class_of == NULL) return mus__fail_memory(context, "a count of crossings");
    const mus_status status = mus__box_grid_create(context, cloth->ntriangle, &grid);
    if (status == MUS_OK) {
        crossing_list list = {pairs, most, {MUS_NONE, MUS_NONE}, 0};
        mus__self_classes(cloth->nnode, cloth->npair, cloth->pair, class_of);
        *count =
            mus__crossing_count(&grid, cloth->ntriangle, cloth->triangle, class_of, placed->x, crossing_note, &list);
        mus__box_grid_destroy(context, &grid);
    }
    mus__free(context, class_of);
    return status;
}
