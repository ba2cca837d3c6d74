/*
 * drafts.h: what the tests of the designs share: tapes and measures of the table sizes, drafts by name, edges by panel
 * and name. Lengths in the tables of golden numbers are centimetres.
 */
#ifndef MUS_TESTS_DRAFTS_H
#define MUS_TESTS_DRAFTS_H

#include <math.h>

#include "block/block_bodice.h"
#include "block/block_skirt.h"
#include "block/block_sleeve.h"
#include "limb/skeleton.h"
#include "muslin/muslin.h"
#include "support.h"

#define CM 0.01
#define FIRST 5 /* the first designs, T-shirt to A-line skirt: every size here; the rest: tests/design/test_designs.c */
#define GOLDEN 0.011 /* cm: the golden numbers are printed to 0.01 */

/* a figure [m or m2] against a golden number in `unit`, within `tolerance` of that unit */
#define CK_GOLDEN(size, what, value, unit, expected, tolerance)                                                 \
    ck_assert_msg(fabs((value) / (unit) - (expected)) <= (tolerance), "%s: %s is %.4f, expected %.4f", (size), \
                  (what), (value) / (unit), (double)(expected))


/* is the notch at s of an edge at an end of it, and the same end of the edge that it is sewn to has none? Then it
 * stands for the joint of two edges that are sewn to a long one */
static inline bool drafts_joint(const mus_pattern *pattern, int32_t edge, double s)
{
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    if (s > 1e-6 && s < mus_pattern_edge_length(pattern, edge) - 1e-6) return false;
    ck_assert_int_eq(mus_pattern_seam(pattern, mus_pattern_edge_seam(pattern, edge), &seam), MUS_OK);
    const int32_t partner = seam.edge_a == edge ? seam.edge_b : seam.edge_a;
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern); i++) {
        int32_t own;
        double at;
        ck_assert_int_eq(mus_pattern_notch(pattern, i, &own, &at, NULL), MUS_OK);
        const bool low = (s > 1e-6) == (seam.direction == MUS_SEAM_REVERSED);
        if (own == partner && fabs(at - (low ? 0.0 : mus_pattern_edge_length(pattern, own))) < 1e-6) return false;
    }
    return true;
}


static inline mus_tape *drafts_tape(mus_context *context, const char *size)
{
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, size), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    return tape;
}


static inline mus__measures drafts_measures(mus_context *context, const char *size)
{
    mus__measures measures;
    mus_tape *tape = drafts_tape(context, size);
    mus__measures_read(tape, &measures);
    mus_tape_destroy(tape);
    return measures;
}


/* the house bodice of a table size */
static inline mus__bodice drafts_bodice(mus_context *context, const char *size)
{
    const mus__measures measures = drafts_measures(context, size);
    mus__bodice_def def;
    mus__bodice bodice;
    mus__bodice_def_init(&def, &measures);
    ck_assert_int_eq(mus__bodice_draft(context, &measures, &def, &bodice), MUS_OK);
    return bodice;
}


static inline mus_pattern *drafts_pattern(mus_context *context, const char *design, const char *size)
{
    mus_pattern *pattern;
    mus_tape *tape = drafts_tape(context, size);
    mus_status status = mus_design_draft(context, mus_design_find(design), tape, NULL, &pattern);
    ck_assert_msg(status == MUS_OK, "%s of %s: %s", design, size, mus_context_error(context));
    mus_tape_destroy(tape);
    return pattern;
}


static inline int32_t drafts_edge(const mus_pattern *pattern, const char *panel, const char *edge)
{
    const int32_t index = mus_pattern_find_edge(pattern, mus_pattern_find_panel(pattern, panel), edge);
    ck_assert_msg(index != MUS_NONE, "no edge %s of panel %s", edge, panel);
    return index;
}


static inline double drafts_length(const mus_pattern *pattern, const char *panel, const char *edge)
{
    return mus_pattern_edge_length(pattern, drafts_edge(pattern, panel, edge));
}

#endif
