/*
 * cut.h: small patterns for the tests of cloth, and what a mesh is measured by.
 */
#ifndef MUS_TESTS_CUT_H
#define MUS_TESTS_CUT_H

#include "support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cloth/cloth_internal.h"

#define CUT(call) ck_assert_msg((call) == MUS_OK, "%s", mus_context_error(mus_pattern_context(pattern)))


/* a panel with straight edges between n points; edges (n) may be NULL */
static inline int32_t cut_panel(mus_pattern *pattern, const char *name, int32_t n, const double *xy, int32_t *edges)
{
    int32_t panel, point[32], edge[32], forward[32];
    CUT(mus_pattern_add_panel(pattern, name, &panel));
    for (int32_t i = 0; i < n; i++) CUT(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &point[i]));
    for (int32_t i = 0; i < n; i++) {
        CUT(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                          .end = point[(i + 1) % n]}, &edge[i]));
        forward[i] = 1;
    }
    CUT(mus_pattern_set_outline(pattern, panel, n, edge, forward));
    if (edges != NULL) memcpy(edges, edge, (size_t)n * sizeof *edges);
    return panel;
}


static inline int32_t cut_rectangle(mus_pattern *pattern, const char *name, double width, double height, int32_t *edges)
{
    const double xy[] = {0, 0, width, 0, width, height, 0, height};
    return cut_panel(pattern, name, 4, xy, edges);
}


/* edge from a to b: a line, or a cubic with its two control points */
static inline int32_t cut_edge(mus_pattern *pattern, int32_t a, int32_t b, const double *control)
{
    int32_t kind = control != NULL ? MUS_PIECE_CUBIC : MUS_PIECE_LINE, edge;
    CUT(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = a, .end = b,
                                                      .npiece = 1, .kinds = &kind, .nxy = control != NULL ? 2 : 0,
                                                      .xy = control}, &edge));
    return edge;
}


static inline int32_t cut_seam(mus_pattern *pattern, int32_t a, int32_t b, int32_t direction)
{
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = a, def.edge_b = b, def.direction = direction;
    def.ease = mus_pattern_edge_length(pattern, b) - mus_pattern_edge_length(pattern, a);
    int32_t seam;
    CUT(mus_pattern_add_seam(pattern, &def, &seam));
    return seam;
}


/* half a skirt with curved sides and waist: edges hem, right, waist, left */
static inline int32_t cut_skirt_panel(mus_pattern *pattern, const char *name, int32_t *edges)
{
    static const double at[4][2] = {{-0.26, 0}, {0.26, 0}, {0.18, 0.6}, {-0.18, 0.6}};
    static const double right[4] = {0.26, 0.25, 0.25, 0.45}, waist[4] = {0.1, 0.585, -0.1, 0.585};
    static const double left[4] = {-0.25, 0.45, -0.26, 0.25};
    int32_t panel, p[4], forward[4] = {1, 1, 1, 1};
    CUT(mus_pattern_add_panel(pattern, name, &panel));
    for (int i = 0; i < 4; i++) CUT(mus_pattern_add_point(pattern, panel, at[i][0], at[i][1], &p[i]));
    edges[0] = cut_edge(pattern, p[0], p[1], NULL);
    edges[1] = cut_edge(pattern, p[1], p[2], right);
    edges[2] = cut_edge(pattern, p[2], p[3], waist);
    edges[3] = cut_edge(pattern, p[3], p[0], left);
    CUT(mus_pattern_set_outline(pattern, panel, 4, edges, forward));
    return panel;
}


/* two skirt panels sewn at both sides */
static inline void cut_skirt(mus_pattern *pattern)
{
    int32_t front[4], back[4];
    cut_skirt_panel(pattern, "front", front);
    cut_skirt_panel(pattern, "back", back);
    cut_seam(pattern, front[1], back[3], MUS_SEAM_REVERSED);
    cut_seam(pattern, front[3], back[1], MUS_SEAM_REVERSED);
}


/* a sleeve with a split cap, its underarm sewn: edges hem, back seam, back cap, front cap, front seam */
static inline int32_t cut_sleeve(mus_pattern *pattern, int32_t *edges)
{
    static const double at[5][2] = {{-0.15, 0}, {0.15, 0}, {0.18, 0.12}, {0, 0.26}, {-0.18, 0.12}};
    static const double back[4] = {0.1, 0.12, 0.09, 0.26}, front[4] = {-0.09, 0.26, -0.1, 0.12};
    int32_t panel, p[5], forward[5] = {1, 1, 1, 1, 1};
    CUT(mus_pattern_add_panel(pattern, "sleeve", &panel));
    for (int i = 0; i < 5; i++) CUT(mus_pattern_add_point(pattern, panel, at[i][0], at[i][1], &p[i]));
    edges[0] = cut_edge(pattern, p[0], p[1], NULL);
    edges[1] = cut_edge(pattern, p[1], p[2], NULL);
    edges[2] = cut_edge(pattern, p[2], p[3], back);
    edges[3] = cut_edge(pattern, p[3], p[4], front);
    edges[4] = cut_edge(pattern, p[4], p[0], NULL);
    CUT(mus_pattern_set_outline(pattern, panel, 5, edges, forward));
    cut_seam(pattern, edges[1], edges[4], MUS_SEAM_REVERSED);
    return panel;
}


static inline mus_pattern *cut_begin(mus_context *context)
{
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "test", &pattern), MUS_OK);
    return pattern;
}


static inline mus_cloth *cut_cloth(mus_context *context, const mus_pattern *pattern, double spacing,
                                   const mus_fabric *fabric)
{
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = spacing;
    def.fabric = fabric;
    mus_cloth *cloth;
    mus_status status = mus_cloth_create(context, pattern, &def, &cloth);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    return cloth;
}


/* signed area of triangle t in the plane of its panel */
static inline double cut_area(const mus_cloth *cloth, int32_t t)
{
    const int32_t *v = cloth->triangle + 3 * t;
    const double *a = cloth->rest + 2 * v[0], *b = cloth->rest + 2 * v[1], *c = cloth->rest + 2 * v[2];
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}


/* energy of all springs, and of all bending, with nodes at x (nodes x 3) */
static inline double cut_stretch_energy(const mus_cloth *cloth, const double *x)
{
    double sum = 0.0;
#define ADD(i, j, stiff, length)                                                                                       \
    do {                                                                                                               \
        const double *p = x + 3 * (i), *q = x + 3 * (j);                                                               \
        double d =                                                                                                     \
            sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2])) -      \
            (length);                                                                                                  \
        sum += 0.5 * (stiff)*d * d;                                                                                    \
    } while (0)
    for (int32_t r = 0; r < cloth->nrun; r++)
        for (int32_t i = 0; i < cloth->run[r].count; i++)
            ADD(cloth->run[r].a + i, cloth->run[r].b + i, cloth->run[r].k, cloth->run[r].rest);
    for (int32_t s = 0; s < cloth->nspring; s++)
        ADD(cloth->spring[s].a, cloth->spring[s].b, cloth->spring[s].k, cloth->spring[s].rest);
#undef ADD
    return sum;
}


static inline double cut_hinge_energy(const mus__hinge *hinge, const double *x)
{
    double square = 0.0;
    for (int k = 0; k < 3; k++) {
        double sum = 0.0;
        for (int i = 0; i < 4; i++) sum += hinge->coef[i] * x[3 * hinge->node[i] + k];
        square += sum * sum;
    }
    return 0.5 * hinge->k * square;
}


static inline double cut_stencil_energy(const mus__bend_run *bend, int32_t at, const double *x)
{
    double square = 0.0;
    for (int k = 0; k < 3; k++) {
        double sum = x[3 * (bend->a + at) + k] - 2.0 * x[3 * (bend->b + at) + k] + x[3 * (bend->c + at) + k];
        square += sum * sum;
    }
    return 0.5 * bend->k * square;
}


static inline double cut_bend_energy(const mus_cloth *cloth, const double *x)
{
    double sum = 0.0;
    for (int32_t r = 0; r < cloth->nbend; r++)
        for (int32_t i = 0; i < cloth->bend[r].count; i++) sum += cut_stencil_energy(&cloth->bend[r], i, x);
    for (int32_t h = 0; h < cloth->nhinge; h++) sum += cut_hinge_energy(&cloth->hinge[h], x);
    return sum;
}

#endif
