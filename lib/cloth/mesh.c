/*
 * mesh.c: the nodes and triangles of each panel.
 *
 * Border nodes stand at equal arc length along each edge of the pattern, in as many intervals as the spacing asks. Both
 * sides of a seam take the greater of their two numbers of intervals, so partners stand at equal relative arc length,
 * and a gathered side is meshed finer. Inside the panel lattice.c chooses the nodes and the full cells. The strip
 * between border and full cells is triangulated: its polygon is the border, its points are the lattice nodes that full
 * cells do not enclose, and edges between a full cell and the strip are constraints; lines inside the panel
 * (panel_lines.c) add points and constraints. Triangles inside full cells are dropped; each full cell is two
 * triangles, with diagonals in a checkerboard.
 *
 * Masses: a quarter of a full cell to each of its corners (so that every inner node weighs the same), a third of a
 * strip triangle to each of its own; then scaled to the true area of the panel, which chords of a curved edge miss.
 */
#include <math.h>
#include <string.h>

#include "cloth/mesh.h"
#include "geom/polygon.h"
#include "geom/triangulate.h"


/* intervals of an edge by the spacing, `least` of them at least */
static mus_status mesh_interval(mus__mesh *mesh, int32_t panel, int32_t edge, int32_t least)
{
    double count = floor(mus_pattern_edge_length(mesh->pattern, edge) / mesh->cloth->spacing + 0.5);
    if (!(count < mesh->nodes_most))
        return mus__fail(mesh->context, MUS_ERR_LIMIT, "panel '%s': edge %d takes %g nodes, at most %d (nodes_most)",
                         mus_pattern_panel_name(mesh->pattern, panel), (int)edge, count, (int)mesh->nodes_most);
    mesh->edge[edge].count = count > least ? (int32_t)count : least;
    mesh->edge[edge].panel = panel;
    return MUS_OK;
}


/* edges of the rim and lines of a panel; three border nodes at least make a panel. The same edge twice on the rim (a
 * bridge to a hole) is refused by name */
static mus_status mesh_intervals(mus__mesh *mesh, int32_t panel)
{
    const int32_t first = mesh->first_rim[panel], n = mesh->first_rim[panel + 1] - first;
    mus_status status = MUS_OK;
    if (n == 0)
        return mus__fail(mesh->context, MUS_ERR_MESH, "panel '%s': its outline encloses nothing",
                         mus_pattern_panel_name(mesh->pattern, panel));
    for (int32_t i = first; i < first + n && status == MUS_OK; i++) {
        mus__edge_nodes *edge = &mesh->edge[mesh->rim[i]];
        if (edge->panel != MUS_NONE)
            return mus__fail(mesh->context, MUS_ERR_MESH, "panel '%s': its outline runs twice along edge %d; %s",
                             mus_pattern_panel_name(mesh->pattern, panel), (int)mesh->rim[i],
                             "panels with a hole are not meshed");
        edge->direction = mesh->turn[i];
        status = mesh_interval(mesh, panel, mesh->rim[i], n == 1 ? 3 : n == 2 ? 2 : 1);
    }
    for (int32_t i = mesh->first_line[panel]; i < mesh->first_line[panel + 1] && status == MUS_OK; i++)
        status = mesh_interval(mesh, panel, mesh->line[i], 1);
    return status;
}


mus_status mus__mesh_edges(mus__mesh *mesh)
{
    for (int32_t e = 0; e < mus_pattern_edge_count(mesh->pattern); e++)
        mesh->edge[e] = (mus__edge_nodes){.panel = MUS_NONE, .start = MUS_NONE, .inner = MUS_NONE};
    mus_status status = mus__mesh_rims(mesh);
    for (int32_t p = 0; status == MUS_OK && p < mus_pattern_panel_count(mesh->pattern); p++)
        status = mesh_intervals(mesh, p);

    /* both sides of a seam take the greater number; edges that several seams connect take the greatest of all */
    for (bool more = true; more;) {
        more = false;
        for (int32_t s = 0; status == MUS_OK && s < mus_pattern_seam_count(mesh->pattern); s++) {
            mus_seam_def seam;
            mus_seam_def_init(&seam, sizeof seam);
            status = mus_pattern_seam(mesh->pattern, s, &seam);
            if (status != MUS_OK) break;
            mus__edge_nodes *a = &mesh->edge[seam.edge_a], *b = &mesh->edge[seam.edge_b];
            more = more || (a->count != b->count && seam.laid);
            a->count = b->count = a->count > b->count ? a->count : b->count;
        }
    }
    return status;
}


int32_t mus__mesh_edge_node(const mus__mesh *mesh, int32_t edge, int32_t k)
{
    const mus__edge_nodes *nodes = &mesh->edge[edge];
    const mus__panel_mesh *panel = &mesh->cloth->panel[nodes->panel];
    if (nodes->inner != MUS_NONE) return mesh->inner[nodes->inner + k];
    int32_t at = nodes->start + (nodes->direction > 0 ? k : nodes->count - k);
    if (at == panel->first_border + panel->border_count) at = panel->first_border;
    return mesh->cloth->border[at];
}


/* room for the panel's nodes */
static mus_status mesh_reserve_nodes(mus__mesh *mesh, int64_t more, int64_t border)
{
    mus_cloth *cloth = mesh->cloth;
    int64_t need = cloth->nnode + more;
    if (need > mesh->nodes_most)
        return mus__fail(mesh->context, MUS_ERR_LIMIT,
                         "the pattern takes %lld nodes at a spacing of %g m, at most %d (nodes_most)", (long long)need,
                         cloth->spacing, (int)mesh->nodes_most);
    mus_status status = mus__reserve(mesh->context, &cloth->rest, &mesh->cap_rest, need, 2 * sizeof *cloth->rest);
    if (status == MUS_OK)
        status = mus__reserve(mesh->context, &cloth->mass, &mesh->cap_mass, need, sizeof *cloth->mass);
    if (status == MUS_OK)
        status =
            mus__reserve(mesh->context, &cloth->node_panel, &mesh->cap_node_panel, need, sizeof *cloth->node_panel);
    need = cloth->nborder + border;
    if (status == MUS_OK)
        status = mus__reserve(mesh->context, &cloth->border, &mesh->cap_border, need, sizeof *cloth->border);
    if (status == MUS_OK) status = mus__reserve(mesh->context, &mesh->wing, &mesh->cap_wing, need, sizeof *mesh->wing);
    return status;
}


/* border points in the order of the outline, `count` of them, then those of lines, *all together: *xy (the caller
 * frees) */
static mus_status mesh_border(mus__mesh *mesh, int32_t panel, int32_t *count, int32_t *all, double **xy)
{
    int32_t at = 0;
    int64_t total = mus__mesh_line_room(mesh, panel), most = 0;
    const int32_t first = mesh->first_rim[panel], n = mesh->first_rim[panel + 1] - first;
    const int32_t *edges = mesh->rim + first, *directions = mesh->turn + first;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < n; i++) {
        total += mesh->edge[edges[i]].count;
        if (mesh->edge[edges[i]].count > most) most = mesh->edge[edges[i]].count;
    }
    if (total > mesh->nodes_most) return mesh_reserve_nodes(mesh, total, total);

    *xy = mus__new(mesh->context, 2 * total, sizeof **xy);
    double *t = mus__new(mesh->context, most, sizeof *t);
    if (*xy == NULL || t == NULL) status = mus__fail_memory(mesh->context, "border points");
    for (int32_t i = 0; status == MUS_OK && i < n; i++) {
        mus__edge_nodes *edge = &mesh->edge[edges[i]];
        int32_t start, end;
        status = mus_pattern_edge_ends(mesh->pattern, edges[i], &start, &end);
        if (status != MUS_OK) break;
        edge->start = mesh->cloth->nborder + at;
        mesh->point[directions[i] > 0 ? start : end] = at;
        for (int32_t k = 0; k < edge->count; k++)
            t[k] = directions[i] > 0 ? (double)k / edge->count : 1.0 - (double)k / edge->count;
        status = mus_pattern_edge_at(mesh->pattern, edges[i], edge->count, t, *xy + 2 * (ptrdiff_t)at);
        at += edge->count;
    }
    mus__free(mesh->context, t);
    *count = *all = at;
    return status == MUS_OK ? mus__mesh_lines(mesh, panel, all, *xy) : status;
}


/* input of the strip's triangulation: border points, points of lines, then the lattice nodes that full cells do not
 * enclose */
typedef struct mesh_strip {
    int32_t n, nborder, nline, nside, count; /* nline: with the border */
    double *xy;        /* (n x 2) */
    int32_t *node;     /* (n) node of the panel */
    int32_t *side;     /* (nside x 2) */
    int32_t *triangle; /* (count x 3) */
} mesh_strip;


/* edges between a full cell and the strip, as pairs of points; `of` gives the point of a panel's lattice node */
static void mesh_sides(const mus__lattice *lattice, const int32_t *of, mesh_strip *strip)
{
    const int32_t columns = lattice->columns;
    for (int64_t p = columns; p < (int64_t)columns * lattice->rows; p++) {
        if (lattice->node[p] == MUS_NONE) continue;
        const int64_t step[2] = {1, columns}, beside[2] = {-columns, -1};
        for (int k = 0; k < 2; k++) {
            if (lattice->full[p] == lattice->full[p + beside[k]]) continue;
            int32_t *side = strip->side + 2 * (ptrdiff_t)strip->nside++;
            side[0] = of[lattice->node[p]], side[1] = of[lattice->node[p + step[k]]];
        }
    }
}


static mus_status mesh_collect(mus__mesh *mesh, const mus__lattice *lattice, int32_t panel, const double *border,
                               mesh_strip *strip)
{
    int64_t most = strip->nline + (int64_t)lattice->count, places = (int64_t)lattice->columns * lattice->rows;
    int32_t *of = mus__new(mesh->context, lattice->count, sizeof *of);
    strip->xy = mus__new(mesh->context, 2 * most, sizeof *strip->xy);
    strip->node = mus__new(mesh->context, most, sizeof *strip->node);
    strip->side = mus__new(mesh->context, 4 * (int64_t)lattice->count + 2 * mus__mesh_line_room(mesh, panel),
                           sizeof *strip->side);
    bool room = of != NULL && strip->xy != NULL && strip->node != NULL && strip->side != NULL;
    if (room) {
        memcpy(strip->xy, border, 2 * (size_t)strip->nline * sizeof *border);
        strip->nside = mus__mesh_line_sides(mesh, panel, strip->side);
        for (strip->n = 0; strip->n < strip->nline; strip->n++) strip->node[strip->n] = lattice->count + strip->n;
        for (int64_t p = 0; p < places; p++) {
            if (lattice->node[p] == MUS_NONE || mus__lattice_around(lattice, p) == 4) continue;
            of[lattice->node[p]] = strip->n;
            strip->node[strip->n] = lattice->node[p];
            mus__lattice_point(lattice, (int32_t)(p % lattice->columns), (int32_t)(p / lattice->columns),
                               strip->xy + 2 * (ptrdiff_t)strip->n++);
        }
        mesh_sides(lattice, of, strip);
    }
    mus__free(mesh->context, of);
    return room ? MUS_OK : mus__fail_memory(mesh->context, "the strip of a panel");
}


/* drop the triangles that lie in full cells */
static void mesh_drop(const mus__lattice *lattice, mesh_strip *strip)
{
    int32_t kept = 0;
    for (int32_t t = 0; t < strip->count; t++) {
        const int32_t *v = strip->triangle + 3 * (ptrdiff_t)t;
        double middle[2] = {0.0, 0.0};
        for (int k = 0; k < 6; k++) middle[k % 2] += strip->xy[2 * (ptrdiff_t)v[k / 2] + k % 2] / 3.0;
        if (mus__lattice_covers(lattice, middle)) continue;
        memmove(strip->triangle + 3 * (ptrdiff_t)kept++, v, 3 * sizeof *v);
    }
    strip->count = kept;
}


/* one triangle of the cloth, given counter-clockwise, turned when the outline runs clockwise */
static void mesh_triangle(mus_cloth *cloth, int32_t first, bool clockwise, int32_t a, int32_t b, int32_t c)
{
    int32_t *out = cloth->triangle + 3 * (ptrdiff_t)cloth->ntriangle++;
    out[0] = first + a, out[1] = first + (clockwise ? c : b), out[2] = first + (clockwise ? b : c);
}


static mus_status mesh_triangles(mus__mesh *mesh, const mus__lattice *lattice, const mesh_strip *strip, bool clockwise,
                                 mus__panel_mesh *panel)
{
    mus_cloth *cloth = mesh->cloth;
    int64_t places = (int64_t)lattice->columns * lattice->rows, cells = 0;
    for (int64_t p = 0; p < places; p++) cells += lattice->full[p];
    int64_t need = cloth->ntriangle + strip->count + 2 * cells;
    mus_status status =
        mus__reserve(mesh->context, &cloth->triangle, &mesh->cap_triangle, need, 3 * sizeof *cloth->triangle);
    if (status != MUS_OK) return status;

    for (int32_t t = 0; t < strip->count; t++) {
        const int32_t *v = strip->triangle + 3 * (ptrdiff_t)t;
        mesh_triangle(cloth, panel->first_node, clockwise, strip->node[v[0]], strip->node[v[1]], strip->node[v[2]]);
    }
    for (int64_t p = 0; p < places; p++) {
        if (!lattice->full[p]) continue;
        const int32_t *at = lattice->node + p;
        int32_t a = at[0], b = at[1], c = at[lattice->columns + 1], d = at[lattice->columns];
        bool rising = (p / lattice->columns + p % lattice->columns) % 2 == 0;
        mesh_triangle(cloth, panel->first_node, clockwise, a, b, rising ? c : d);
        mesh_triangle(cloth, panel->first_node, clockwise, rising ? a : b, c, d);
    }
    panel->triangle_count = cloth->ntriangle - panel->first_triangle;
    return MUS_OK;
}


/* places, masses and border list of the panel's nodes; rows of the lattice */
static mus_status mesh_nodes(mus__mesh *mesh, const mus__lattice *lattice, const double *border, int32_t index)
{
    mus_cloth *cloth = mesh->cloth;
    mus__panel_mesh *panel = &cloth->panel[index];
    int64_t places = (int64_t)lattice->columns * lattice->rows;
    mus_status status = mesh_reserve_nodes(mesh, panel->node_count, panel->border_count);
    for (int64_t p = 0; status == MUS_OK && p < places; p++) {
        if (lattice->node[p] == MUS_NONE) continue;
        int32_t node = panel->first_node + lattice->node[p];
        mus__lattice_point(lattice, (int32_t)(p % lattice->columns), (int32_t)(p / lattice->columns),
                           cloth->rest + 2 * (ptrdiff_t)node);
        if (lattice->node[p - 1] == MUS_NONE) {
            status =
                mus__reserve(mesh->context, &cloth->row, &mesh->cap_row, (int64_t)cloth->nrow + 1, sizeof *cloth->row);
            if (status != MUS_OK) break;
            cloth->row[cloth->nrow++] = (mus__row){node, 0};
        }
        cloth->row[cloth->nrow - 1].count++;
    }
    if (status != MUS_OK) return status;

    memcpy(cloth->rest + 2 * ((ptrdiff_t)panel->first_node + lattice->count), border,
           2 * (size_t)(panel->node_count - lattice->count) * sizeof *border);
    for (int32_t i = 0; i < panel->border_count; i++) {
        mesh->wing[cloth->nborder] = MUS_NONE;
        cloth->border[cloth->nborder++] = panel->first_node + lattice->count + i;
    }
    for (int32_t i = 0; i < panel->node_count; i++) {
        cloth->node_panel[cloth->nnode] = index;
        cloth->mass[cloth->nnode++] = 0.0;
    }
    return MUS_OK;
}


/* full cells by quarters, strip triangles by thirds, then the whole to weight times the panel's true area */
static void mesh_masses(mus__mesh *mesh, const mus__lattice *lattice, int32_t index, int32_t nstrip)
{
    mus_cloth *cloth = mesh->cloth;
    const mus__panel_mesh *panel = &cloth->panel[index];
    double *mass = cloth->mass + panel->first_node, quarter = 0.25 * lattice->spacing * lattice->spacing, sum = 0.0;
    int64_t places = (int64_t)lattice->columns * lattice->rows;
    for (int64_t p = 0; p < places; p++)
        if (lattice->node[p] != MUS_NONE) mass[lattice->node[p]] = quarter * mus__lattice_around(lattice, p);

    for (int32_t t = panel->first_triangle; t < panel->first_triangle + nstrip; t++) {
        const int32_t *v = cloth->triangle + 3 * (ptrdiff_t)t;
        double corner[6];
        for (int k = 0; k < 6; k++) corner[k] = cloth->rest[2 * (ptrdiff_t)v[k / 2] + k % 2];
        for (int k = 0; k < 3; k++) cloth->mass[v[k]] += fabs(mus__polygon_area(3, corner)) / 3.0;
    }

    for (int32_t i = 0; i < panel->node_count; i++) sum += mass[i];
    double scale = cloth->fabric.weight * mus_pattern_panel_area(mesh->pattern, index) / sum;
    for (int32_t i = 0; i < panel->node_count; i++) mass[i] *= scale;
}


/* lattice, strip and triangles of the panel whose border points are known, and those of its lines, `all` together */
static mus_status mesh_fill(mus__mesh *mesh, int32_t index, int32_t all, const double *border, mus__lattice *lattice,
                            int32_t *nstrip)
{
    mus_cloth *cloth = mesh->cloth;
    mus__panel_mesh *panel = &cloth->panel[index];
    double grain[2];
    mesh_strip strip = {.nborder = panel->border_count, .nline = all};
    int32_t *side = mus__new(mesh->context, 2 * mus__mesh_line_room(mesh, index), sizeof *side);
    mus_status status = side != NULL ? mus_pattern_grain(mesh->pattern, index, grain)
                                     : mus__fail_memory(mesh->context, "the lines of a panel");
    if (status == MUS_OK) {
        const int32_t nside = mus__mesh_line_sides(mesh, index, side);
        status = mus__lattice_build(mesh->context, strip.nborder, border, nside, side, grain, cloth->spacing, lattice);
    }
    mus__free(mesh->context, side);
    if (status == MUS_OK) status = mesh_collect(mesh, lattice, index, border, &strip);
    if (status == MUS_OK)
        status = mus__triangulate(mesh->context, strip.n, strip.xy, strip.nborder, strip.nside, strip.side,
                                        &strip.triangle, &strip.count);
    if (status == MUS_ERR_MESH)
        status =
            mus__fail(mesh->context, MUS_ERR_MESH, "panel '%s' cannot be meshed at a spacing of %g m: %s",
                      mus_pattern_panel_name(mesh->pattern, index), cloth->spacing, mus_context_error(mesh->context));
    if (status != MUS_OK) goto done;

    mesh_drop(lattice, &strip);
    panel->lattice_count = lattice->count;
    panel->node_count = lattice->count + strip.nline;
    *nstrip = strip.count;
    status = mesh_nodes(mesh, lattice, border, index);
    if (status == MUS_OK)
        status = mesh_triangles(mesh, lattice, &strip, mus__polygon_area(strip.nborder, border) < 0.0, panel);
    if (status == MUS_OK) mesh_masses(mesh, lattice, index, strip.count);
    if (status == MUS_OK) mus__mesh_lines_done(mesh, index, strip.count);
done:
    mus__free(mesh->context, strip.xy);
    mus__free(mesh->context, strip.node);
    mus__free(mesh->context, strip.side);
    mus__free(mesh->context, strip.triangle);
    return status;
}


mus_status mus__mesh_panel(mus__mesh *mesh, int32_t panel, mus__lattice *lattice, int32_t *nstrip)
{
    mus_cloth *cloth = mesh->cloth;
    mus__panel_mesh *out = &cloth->panel[panel];
    double *border = NULL;
    int32_t all = 0;
    out->first_node = cloth->nnode, out->first_triangle = cloth->ntriangle, out->first_border = cloth->nborder;
    out->layer = mus_pattern_layer(mesh->pattern, panel);
    out->sides = mus_pattern_panel_sides(mesh->pattern, panel, NULL);
    mus_placement_init(&out->placement, sizeof out->placement);
    mus_status status = mus_pattern_placement(mesh->pattern, panel, &out->placement);
    if (status == MUS_OK) status = mesh_border(mesh, panel, &out->border_count, &all, &border);
    if (status == MUS_OK) status = mesh_fill(mesh, panel, all, border, lattice, nstrip);
    mus__free(mesh->context, border);
    return status;
}
