/*
 * dart.c: a dart added, moved, shortened and undone, as on the cutting table.
 *
 * A panel 30 cm wide and 40 cm high gets a dart of 4 cm in its right side that points at (0.12, 0.25). The dart is
 * rotated into the upper edge: its angle stays, its mouth does not, and the area of the panel stays. Undo takes the
 * pattern back, byte by byte.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/muslin.h"

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "dart: %s: %s\n", mus_status_name(status), mus_context_error(context));
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


static void tell(const char *when, const mus_pattern *pattern, int32_t leg)
{
    double angle, width, depth;
    const double area = 1e4 * mus_pattern_panel_area(pattern, 0);
    if (leg == MUS_NONE) {
        printf("%-9s no dart, area %.1f cm2\n", when, area);
        return;
    }
    must(mus_pattern_dart(pattern, leg, &angle, &width, &depth));
    printf("%-9s angle %.2f degrees, mouth %.1f mm, depth %.1f mm, area %.1f cm2\n", when, angle * 57.29577951308232,
           1e3 * width, 1e3 * depth, area);
}


int main(void)
{
    const double corner[4][2] = {{0, 0}, {0.30, 0}, {0.30, 0.40}, {0, 0.40}}, bust[2] = {0.12, 0.25};
    const char *const name[4] = {"waist", "side", "shoulder", "centre"};
    const int32_t forwards[4] = {1, 1, 1, 1};
    int32_t panel, point[4], edge[4], leg;
    mus_pattern *pattern;

    must(mus_context_create(NULL, &context));
    must(mus_pattern_create(context, "front", &pattern));
    must(mus_pattern_add_panel(pattern, "front", &panel));
    for (int i = 0; i < 4; i++) must(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]));
    for (int i = 0; i < 4; i++) edge[i] = line(pattern, name[i], point[i], point[(i + 1) % 4]);
    must(mus_pattern_set_outline(pattern, panel, 4, edge, forwards));
    must(mus_pattern_keep_history(pattern, 10));
    tell("drawn:", pattern, MUS_NONE);

    must(mus_pattern_add_dart(pattern, edge[1], 0.20, 0.04, bust, &leg));
    tell("added:", pattern, leg);

    /* indices are new after each edit; names stay */
    const int32_t shoulder = mus_pattern_find_edge(pattern, panel, "shoulder");
    const int32_t centre = mus_pattern_find_edge(pattern, panel, "centre");
    must(mus_pattern_rotate_dart(pattern, leg, shoulder, 0.15, centre, 1.0, &leg));
    tell("rotated:", pattern, leg);
    must(mus_pattern_shorten_dart(pattern, leg, 0.02));
    tell("shorter:", pattern, leg);

    /* an edit that cannot be done leaves the pattern as it was, and says why */
    const mus_status status = mus_pattern_shorten_dart(pattern, leg, 5.0);
    printf("refused:  %s\n", mus_status_name(status));

    while (mus_pattern_undo_count(pattern) > 0) must(mus_pattern_undo(pattern));
    tell("undone:", pattern, MUS_NONE);
    printf("edits to redo: %d\n", (int)mus_pattern_redo_count(pattern));

    mus_pattern_destroy(pattern);
    mus_context_destroy(context);
    return 0;
}
