/*
 * skirt.c: a skirt drawn cell by cell: points, edges, panels, seams; then sewn on a body and brought to rest.
 *
 * Two panels, front and back, each drawn like this. Side edges are sewn, the waist hangs at the body's waist.
 *
 *         3 --waist-- 2
 *        /             \        x to the right, y up, in metres
 *      0 ------hem------ 1
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/muslin.h"

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "skirt: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


/* a straight edge */
static int32_t line(mus_pattern *pattern, const char *name, int32_t start, int32_t end)
{
    mus_edge_def def;
    int32_t edge;
    mus_edge_def_init(&def, sizeof def);
    def.name = name;
    def.start = start;
    def.end = end;
    must(mus_pattern_add_edge(pattern, &def, &edge));
    return edge;
}


/* one panel; edge (4) gets hem, right side, waist, left side */
static int32_t add_panel(mus_pattern *pattern, const char *name, double waist, double hem, double length, int32_t *edge)
{
    const int32_t forwards[4] = {1, 1, 1, 1};
    int32_t panel, point[4];
    must(mus_pattern_add_panel(pattern, name, &panel));
    must(mus_pattern_add_point(pattern, panel, -hem / 2, 0, &point[0]));
    must(mus_pattern_add_point(pattern, panel, hem / 2, 0, &point[1]));
    must(mus_pattern_add_point(pattern, panel, waist / 2, length, &point[2]));
    must(mus_pattern_add_point(pattern, panel, -waist / 2, length, &point[3]));
    edge[0] = line(pattern, "hem", point[0], point[1]);
    edge[1] = line(pattern, "right", point[1], point[2]);
    edge[2] = line(pattern, "waist", point[2], point[3]);
    edge[3] = line(pattern, "left", point[3], point[0]);
    must(mus_pattern_set_outline(pattern, panel, 4, edge, forwards));
    must(mus_pattern_set_edge_hold(pattern, edge[2], MUS_HOLD_WAIST, 0.0));
    return panel;
}


static void sew(mus_pattern *pattern, int32_t a, int32_t b)
{
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = a;
    def.edge_b = b;
    must(mus_pattern_add_seam(pattern, &def, NULL));
}


int main(void)
{
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_topology topology;
    mus_drape *drape;
    mus_dress_def def;
    int32_t front[4], back[4], n;
    double low = 1e30, high = -1e30;

    must(mus_context_create(NULL, &context));
    must(mus_tape_create(context, &tape));
    must(mus_tape_set_size(tape, "W40"));
    must(mus_body_create(context, tape, NULL, &body));

    /* each panel is half of the waist wide with 4 cm of ease; its right side is sewn to the other's left side */
    const double waist = mus_tape_value(tape, MUS_MEASURE_WAIST) / 2 + 0.02;
    must(mus_pattern_create(context, "own skirt", &pattern));
    add_panel(pattern, "front", waist, waist + 0.35, 0.55, front);
    add_panel(pattern, "back", waist, waist + 0.35, 0.55, back);
    sew(pattern, front[1], back[3]);
    sew(pattern, back[1], front[3]);
    mus_topology_init(&topology, sizeof topology);
    must(mus_pattern_topology(pattern, &topology));
    printf("pieces %d, openings %d, Euler characteristic %d\n", (int)topology.components, (int)topology.loops,
           (int)topology.euler);

    /* the library finds where the panels start, sews and settles */
    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.02;
    must(mus_dress(context, pattern, body, &def, NULL, NULL, NULL, &drape));
    n = mus_drape_node_count(drape);
    for (int32_t i = 0; i < n; i++) {
        const double y = mus_drape_positions(drape)[3 * i + 1];
        low = y < low ? y : low;
        high = y > high ? y : high;
    }
    printf("at rest: from %.2f m to %.2f m above the floor\n", low, high);

    mus_drape_destroy(drape);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return 0;
}
