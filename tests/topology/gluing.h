/*
 * gluing.h: a pattern from words: "F: hem side neck sideR; B: ..." and seams "F.side B.sideR; ...".
 *
 * Corners stand on a circle, so a panel whose word has no edge twice is a regular polygon of straight edges. An edge
 * that starts where it ends (a word of one edge) is a cubic loop; the second of two edges between the same corners is
 * an arc. With a seed, about half of the edges are stored the other way round (direction -1 in the word, and
 * the seams told so): nothing about the surface may change by that.
 */
#ifndef MUS_TESTS_GLUING_H
#define MUS_TESTS_GLUING_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "muslin/pattern.h"
#include "support.h"

#define GLUING_WORD 64

/* add an edge between two points, bent when it is a loop or one of two */
static inline int32_t gluing_edge(mus_pattern *pattern, const char *name, int32_t a, int32_t b, bool bent)
{
    double p[2], q[2], xy[4];
    int32_t kind = MUS_PIECE_LINE, nxy = 0, edge;
    ck_assert_int_eq(mus_pattern_point(pattern, a, NULL, p), MUS_OK);
    ck_assert_int_eq(mus_pattern_point(pattern, b, NULL, q), MUS_OK);
    if (a == b) {
        kind = MUS_PIECE_CUBIC, nxy = 2;
        xy[0] = p[0] + 0.1, xy[1] = p[1] - 0.1, xy[2] = p[0] + 0.1, xy[3] = p[1] + 0.1;
    } else if (bent) {
        kind = MUS_PIECE_ARC, nxy = 1;
        xy[0] = 0.5 * (p[0] + q[0]) + 0.3 * (q[1] - p[1]), xy[1] = 0.5 * (p[1] + q[1]) - 0.3 * (q[0] - p[0]);
    }
    mus_status status = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = name,
                                                                      .start = a, .end = b, .npiece = 1,
                                                                      .kinds = &kind, .nxy = nxy, .xy = xy}, &edge);
    ck_assert_msg(status == MUS_OK, "edge %s: %d", name, (int)status);
    return edge;
}


/* one panel from its word; corners that a repeated edge joins are one point */
static inline void gluing_panel(mus_pattern *pattern, const char *text, uint64_t *seed)
{
    char panel[64], name[GLUING_WORD][32], token[32];
    int32_t n = 0, used = 0, first[GLUING_WORD], along[GLUING_WORD], corner[GLUING_WORD], point[GLUING_WORD];
    ck_assert_int_eq(sscanf(text, " %63[^:]:%n", panel, &used), 1);
    for (const char *at = text + used; sscanf(at, " %31s%n", token, &used) == 1; at += used, n++) {
        ck_assert_int_lt(n, GLUING_WORD);
        size_t length = strlen(token);
        along[n] = token[length - 1] == '-' ? -1 : 1;
        if (along[n] < 0) token[length - 1] = '\0';
        strcpy(name[n], token);
        for (first[n] = 0; strcmp(name[first[n]], token) != 0;) first[n]++;
    }

    /* corners: relabel until nothing changes */
    for (int32_t i = 0; i < n; i++) corner[i] = i;
    for (bool again = true; again;) {
        again = false;
        for (int32_t k = 0; k < n; k++) {
            int32_t j = first[k], k2 = (k + 1) % n, j2 = (j + 1) % n;
            int32_t pair[2][2] = {{j, along[j] == along[k] ? k : k2}, {j2, along[j] == along[k] ? k2 : k}};
            for (int32_t i = 0; i < 2; i++) {
                int32_t *a = &corner[pair[i][0]], *b = &corner[pair[i][1]];
                again = again || *a != *b;
                *a = *b = *a < *b ? *a : *b;
            }
        }
    }

    int32_t id, edges[GLUING_WORD], directions[GLUING_WORD];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, panel, &id), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        double angle = 6.283185307179586 * i / n;
        if (corner[i] != i) continue;
        ck_assert_int_eq(mus_pattern_add_point(pattern, id, 0.3 * cos(angle), 0.3 * sin(angle), &point[i]), MUS_OK);
    }
    for (int32_t k = 0; k < n; k++) {
        int32_t a = point[corner[k]], b = point[corner[(k + 1) % n]], start;
        if (first[k] == k) {
            bool turned = (along[k] < 0) != (*seed != 0 && support_random(seed) % 2 == 0);
            edges[k] = gluing_edge(pattern, name[k], turned ? b : a, turned ? a : b, n == 2);
        }
        edges[k] = edges[first[k]];
        ck_assert_int_eq(mus_pattern_edge_ends(pattern, edges[k], &start, NULL), MUS_OK);
        directions[k] = start == a ? 1 : -1;
        if (a == b) directions[k] = along[k];
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, id, n, edges, directions), MUS_OK);
}


/* +1 when an edge is stored as its name says (the first time it stands in its word), -1 when turned */
static inline int32_t gluing_turn(const mus_pattern *pattern, int32_t edge, const char *panels)
{
    /* its direction in the word, against the sign that the text gives it there */
    int32_t panel = mus_pattern_edge_panel(pattern, edge), n;
    const int32_t *edges, *directions;
    ck_assert_int_eq(mus_pattern_outline(pattern, panel, &n, &edges, &directions), MUS_OK);
    for (int32_t at = 0; at <= panel; at++) {
        panels += strcspn(panels, ":") + 1;
    }
    char token[32];
    int32_t used;
    for (int32_t k = 0; k < n && sscanf(panels, " %31[^ ;]%n", token, &used) == 1; k++, panels += used) {
        if (edges[k] == edge) return directions[k] * (token[strlen(token) - 1] == '-' ? -1 : 1);
    }
    ck_abort_msg("edge %d is in no word", (int)edge);
    return 0;
}


/* the whole pattern; panels and seams are parted by semicolons */
static inline mus_pattern *gluing_make(mus_context *context, const char *panels, const char *seams, uint64_t seed)
{
    mus_pattern *pattern;
    char part[512], a[2][32], b[2][32], word[32];
    ck_assert_int_eq(mus_pattern_create(context, "garment", &pattern), MUS_OK);
    int used;
    for (const char *at = panels; sscanf(at, "%511[^;]%n", part, &used) == 1; at += used + (at[used] == ';'))
        gluing_panel(pattern, part, &seed);
    for (const char *at = seams; sscanf(at, "%511[^;]%n", part, &used) == 1; at += used + (at[used] == ';')) {
        int got = sscanf(part, " %31[^.].%31s %31[^.].%31s %31s", a[0], a[1], b[0], b[1], word);
        ck_assert_msg(got >= 4, "seam '%s'", part);
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        def.edge_a = mus_pattern_find_edge(pattern, mus_pattern_find_panel(pattern, a[0]), a[1]);
        def.edge_b = mus_pattern_find_edge(pattern, mus_pattern_find_panel(pattern, b[0]), b[1]);
        ck_assert_msg(def.edge_a >= 0 && def.edge_b >= 0, "seam '%s'", part);
        bool turned = gluing_turn(pattern, def.edge_a, panels) != gluing_turn(pattern, def.edge_b, panels);
        def.direction = (got == 5) != turned ? MUS_SEAM_DIRECT : MUS_SEAM_REVERSED;
        def.tolerance = 10.0;
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
    }
    return pattern;
}

#endif
