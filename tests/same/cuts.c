/*
 * cuts.c: rows "edit/WHAT-GARMENT": each edit of the cutting table made at every edge of a pattern, one at a time, on a
 * copy: its status, and where it went the pattern's JSON; then undone, and made again.
 */
#include "same.h"

#include <string.h>

/* the edge that is half way round the outline of an edge's panel */
static int32_t opposite(const mus_pattern *pattern, int32_t edge)
{
    const int32_t *edges, *directions;
    int32_t n = 0;
    if (mus_pattern_outline(pattern, mus_pattern_edge_panel(pattern, edge), &n, &edges, &directions) != MUS_OK)
        return edge;
    for (int32_t i = 0; i < n; i++)
        if (edges[i] == edge) return edges[(i + n / 2) % n];
    return edge;
}


static double along(const mus_pattern *pattern, int32_t edge, double part)
{
    return part * mus_pattern_edge_length(pattern, edge);
}


/* a place inside the panel, between the middle of an edge and that of the opposite one */
static void inside(const mus_pattern *pattern, int32_t edge, double part, double *out)
{
    const double middle = 0.5;
    double a[2] = {0}, b[2] = {0};
    mus_pattern_edge_at(pattern, edge, 1, &middle, a);
    mus_pattern_edge_at(pattern, opposite(pattern, edge), 1, &middle, b);
    for (int i = 0; i < 2; i++) out[i] = a[i] + part * (b[i] - a[i]);
}


/* ---- the edits, each about an edge ---- */

static mus_status add_dart(mus_pattern *p, int32_t edge)
{
    double point[2];
    inside(p, edge, 0.4, point);
    return mus_pattern_add_dart(p, edge, along(p, edge, 0.5), 0.02, point, NULL);
}


static mus_status rotate_dart(mus_pattern *p, int32_t edge)
{
    int32_t leg = MUS_NONE;
    double point[2];
    inside(p, edge, 0.4, point);
    const int32_t target = opposite(p, edge);
    mus_status status = mus_pattern_add_dart(p, edge, along(p, edge, 0.5), 0.02, point, &leg);
    if (status == MUS_OK)
        status = mus_pattern_rotate_dart(p, leg, target, along(p, target, 0.5), opposite(p, target), 0.6, &leg);
    return status;
}


static mus_status shorten_dart(mus_pattern *p, int32_t edge)
{
    return mus_pattern_shorten_dart(p, edge, 0.02);
}


static mus_status release_dart(mus_pattern *p, int32_t edge)
{
    return mus_pattern_release_dart(p, edge, NULL);
}


static mus_status dart_to_seam(mus_pattern *p, int32_t edge)
{
    const int32_t target = opposite(p, edge);
    return mus_pattern_dart_to_seam(p, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "cut_off",
                                                      .seam_name = "line", .edge_a = edge, .edge_b = target,
                                                      .s_b = along(p, target, 0.45)}, NULL, NULL);
}


static mus_status split_dart(mus_pattern *p, int32_t edge)
{
    const int32_t far = opposite(p, edge), target[2] = {far, far};
    const double s[2] = {along(p, far, 0.3), along(p, far, 0.6)}, fractions[2] = {0.4, 0.3};
    return mus_pattern_split_dart(p, edge, 2, target, s, fractions, edge, NULL);
}


static mus_status separate(mus_pattern *p, int32_t edge)
{
    const int32_t far = opposite(p, edge), curve = MUS_PIECE_QUADRATIC;
    double middle[2];
    inside(p, edge, 0.55, middle);
    return mus_pattern_separate(p, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "cut_off",
                                                  .seam_name = "line", .edge_a = edge, .s_a = along(p, edge, 0.4),
                                                  .edge_b = far, .s_b = along(p, far, 0.6), .npiece = 1,
                                                  .kinds = &curve, .nxy = 1, .xy = middle}, NULL, NULL);
}


static mus_status join_panels(mus_pattern *p, int32_t edge)
{
    return mus_pattern_join_panels(p, mus_pattern_edge_seam(p, edge), NULL);
}


static mus_status mirror(mus_pattern *p, int32_t edge)
{
    return mus_pattern_mirror_panel(p, mus_pattern_edge_panel(p, edge), "image", NULL);
}


static mus_status facing(mus_pattern *p, int32_t edge)
{
    return mus_pattern_add_facing(p, edge, 0.04, "facing", NULL);
}


static mus_status patch(mus_pattern *p, int32_t edge)
{
    double at[2], line[8];
    inside(p, edge, 0.4, at);
    const double corners[8] = {0, 0.05, 0, 0, 0.04, 0, 0.04, 0.05};
    for (int i = 0; i < 8; i++) line[i] = at[i % 2] + corners[i];
    return mus_pattern_add_patch(p, mus_pattern_edge_panel(p, edge), "pocket", 4, line, NULL);
}


static mus_status remove_panel(mus_pattern *p, int32_t edge)
{
    return mus_pattern_remove_panel(p, mus_pattern_edge_panel(p, edge));
}


static mus_status remove_seam(mus_pattern *p, int32_t edge)
{
    return mus_pattern_remove_seam(p, mus_pattern_edge_seam(p, edge));
}


static mus_status spread(mus_pattern *p, int32_t edge)
{
    const int32_t far = opposite(p, edge);
    return mus_pattern_spread(p, edge, along(p, edge, 0.5), far, along(p, far, 0.5), 0.04, 0.01);
}


static mus_status flare(mus_pattern *p, int32_t edge)
{
    return mus_pattern_flare(p, edge, opposite(p, edge), 4, 0.1);
}


static mus_status pleat(mus_pattern *p, int32_t edge)
{
    const int32_t far = opposite(p, edge);
    return mus_pattern_pleat(p, edge, along(p, edge, 0.5), far, along(p, far, 0.5), 0.02, 0.015);
}


static mus_status lay_pleats(mus_pattern *p, int32_t edge)
{
    const double s[2] = {along(p, edge, 0.25), along(p, edge, 0.75)}, depths[2] = {0.01, -0.01};
    return mus_pattern_lay_pleats(p, edge, 2, s, depths);
}


static mus_status lengthen(mus_pattern *p, int32_t edge)
{
    double point[2];
    const double direction[2] = {1.0, 0.1};
    inside(p, edge, 0.5, point);
    return mus_pattern_lengthen(p, mus_pattern_edge_panel(p, edge), point, direction, 0.03);
}


static mus_status move_point(mus_pattern *p, int32_t edge)
{
    int32_t start = 0, end = 0;
    double xy[2] = {0};
    mus_pattern_edge_ends(p, edge, &start, &end);
    mus_pattern_point(p, start, NULL, xy);
    return mus_pattern_move_point(p, start, xy[0] + 0.01, xy[1] - 0.005);
}


static mus_status move_control(mus_pattern *p, int32_t edge)
{
    const int32_t *kinds;
    const double *xy;
    int32_t npiece = 0, nxy = 0;
    const mus_status status = mus_pattern_edge_pieces(p, edge, &npiece, &kinds, &nxy, &xy);
    if (status != MUS_OK || nxy < 3) return MUS_ERR_ARG;
    return mus_pattern_move_control(p, edge, 1, xy[2] + 0.004, xy[3] + 0.003);
}


static mus_status fair(mus_pattern *p, int32_t edge)
{
    return mus_pattern_fair_edge(p, edge, 0.001);
}


static mus_status split_edge(mus_pattern *p, int32_t edge)
{
    return mus_pattern_split_edge(p, edge, along(p, edge, 0.3), NULL, NULL);
}


static mus_status merge_edges(mus_pattern *p, int32_t edge)
{
    return mus_pattern_merge_edges(p, edge, NULL);
}


static mus_status unfold(mus_pattern *p, int32_t edge)
{
    return mus_pattern_unfold(p, edge);
}


static mus_status true_seam(mus_pattern *p, int32_t edge)
{
    return mus_pattern_true_seam(p, mus_pattern_edge_seam(p, edge), edge, edge % 2);
}


static const struct {
    const char *name;
    mus_status (*make)(mus_pattern *pattern, int32_t edge);
} edits[] = {
    {"add_dart", add_dart},         {"rotate_dart", rotate_dart},   {"shorten_dart", shorten_dart},
    {"release_dart", release_dart}, {"dart_to_seam", dart_to_seam}, {"split_dart", split_dart},
    {"separate", separate},         {"join_panels", join_panels},   {"mirror", mirror},
    {"facing", facing},             {"patch", patch},               {"remove_panel", remove_panel},
    {"remove_seam", remove_seam},   {"spread", spread},             {"flare", flare},
    {"pleat", pleat},               {"lay_pleats", lay_pleats},     {"lengthen", lengthen},
    {"move_point", move_point},     {"move_control", move_control}, {"fair", fair},
    {"split_edge", split_edge},     {"merge_edges", merge_edges},   {"unfold", unfold},
    {"true_seam", true_seam},
};


/* ---- rows ---- */

static void digest_walks(same_run *run, const mus_pattern *pattern)
{
    for (int32_t s = 0; s < mus_pattern_seam_count(pattern); s++) {
        mus_seam_walk w;
        mus_seam_walk_init(&w, sizeof w);
        if (!same_status(run, mus_pattern_walk_seam(pattern, s, &w))) continue;
        const double values[] = {w.length_a, w.length_b, w.excess, w.notch_off, w.corner_start, w.corner_end};
        same_reals(run, values, sizeof values / sizeof *values);
        same_int(run, w.notches_a);
        same_int(run, w.notches_b);
    }
}


/* one edit at one edge of a copy, undone and made again */
static void edit_copy(same_run *run, const mus_pattern *pattern, int32_t index, int32_t edge)
{
    mus_pattern *copy = NULL;
    same_must(run, mus_pattern_copy(pattern, &copy), "mus_pattern_copy");
    same_must(run, mus_pattern_keep_history(copy, 4), "mus_pattern_keep_history");
    if (same_status(run, edits[index].make(copy, edge))) {
        same_pattern(run, copy);
        digest_walks(run, copy);
        same_status(run, mus_pattern_undo(copy));
        same_pattern(run, copy);
        same_status(run, mus_pattern_redo(copy));
        same_pattern(run, copy);
    }
    mus_pattern_destroy(copy);
}


static void make_edit(same_run *run, const void *what, int32_t index)
{
    mus_pattern *pattern = same_draft(run, what, same_size(run, "W40"));
    for (int32_t e = 0; e < mus_pattern_edge_count(pattern) && e < 40; e++) edit_copy(run, pattern, index, e);
}


void same_cuts(same_list *list)
{
    static const char *const garments[] = {"tshirt", "bodice", "skirt", "sheath"};
    for (size_t g = 0; g < sizeof garments / sizeof *garments; g++)
        for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
            same_row *row = same_add(list, make_edit, "edit/%s-%s", edits[i].name, garments[g]);
            row->what = garments[g], row->index = (int32_t)i;
        }
}
