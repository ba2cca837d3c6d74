/*
 * edits.h: what the tests of muslin/edit.h share: drafted patterns, cells by name, area, topology, faults, and the
 * bytes of a pattern.
 */
#ifndef MUS_TESTS_EDITS_H
#define MUS_TESTS_EDITS_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "board/darts.h"
#include "pattern/same.h"
#include "muslin/topology.h"


/* a skirt of two panels with a waist dart each, and a band on the front */
static inline mus_pattern *edit_skirt(mus_context *context)
{
    mus_tape *tape = drafts_tape(context, "W40");
    mus_pattern *pattern;
    ck_assert_int_eq(mus_design_draft(context, mus_design_find("skirt"), tape, NULL, &pattern), MUS_OK);
    mus_tape_destroy(tape);
    return pattern;
}


static inline int32_t edit_edge(const mus_pattern *pattern, const char *panel, const char *name)
{
    const int32_t edge = mus_pattern_find_edge(pattern, mus_pattern_find_panel(pattern, panel), name);
    ck_assert_msg(edge != MUS_NONE, "%s has no edge %s", panel, name);
    return edge;
}


static inline double edit_area(const mus_pattern *pattern)
{
    double area = 0.0;
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern); i++) area += mus_pattern_panel_area(pattern, i);
    return area;
}


static inline mus_topology edit_topology(const mus_pattern *pattern)
{
    mus_topology topology;
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    return topology;
}


static inline int32_t edit_faults(mus_pattern *pattern)
{
    int32_t count;
    ck_assert_int_eq(mus_pattern_check(pattern, &count, NULL), MUS_OK);
    return count;
}


#define edit_well(call)                                                                                                \
    ck_assert_msg((call) == MUS_OK, "%s: %s", #call, mus_context_error(mus_pattern_context(pattern)))


/* the bytes of the written file and of the canonical form, hashed */
static inline uint64_t edit_bytes(const mus_pattern *pattern)
{
    char path[512];
    size_t size, count;
    uint64_t hash[2];
    support_scratch("pattern.json", path, sizeof path);
    ck_assert_int_eq(mus_pattern_write(pattern, path), MUS_OK);
    char *text = support_slurp(path, &size);
    uint64_t sum = mus__hash(MUS_HASH_START, text, size);
    free(text);
    ck_assert_int_eq(mus_pattern_form(pattern, NULL, NULL, 0, &count, hash), MUS_OK);
    return mus__hash(sum, hash, sizeof hash);
}

#endif
