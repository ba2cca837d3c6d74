/*
 * panel_lines.c: the rim of each panel, which is its outline without bridges, and the lines inside a panel to which
 * another edge is sewn: their nodes and wings.
 *
 * A line inside a panel is an edge that the outline passes once in each direction. When an edge is sewn to the line (a
 * patch pocket), the line has a node at each step, which the cloth on both sides shares; after welding three sheets
 * meet there. Bridges and lines without a seam have no nodes: the cloth goes on through them.
 *
 * Nodes of lines are numbered after the border nodes of their panel, in the order of the outline. A line that ends on
 * the rim or on another line shares the node of that point.
 */
#include "cloth/mesh.h"


/* is an edge of the outline on the rim? */
static bool line_on_rim(const mus__mesh *mesh, int32_t panel, int32_t edge)
{
    for (int32_t i = mesh->first_rim[panel]; i < mesh->first_rim[panel + 1]; i++)
        if (mesh->rim[i] == edge) return true;
    return false;
}


/* rim and lines of one panel, behind those of the panels before */
static mus_status line_panel(mus__mesh *mesh, int32_t panel, int32_t room)
{
    int32_t n, kept, at = mesh->first_rim[panel], line = mesh->first_line[panel];
    const int32_t *edges;
    mus_status status = mus_pattern_outline(mesh->pattern, panel, &n, &edges, NULL);
    if (status == MUS_OK)
        status = mus_pattern_rim(mesh->pattern, panel, mesh->rim + at, mesh->turn + at, room - at, &kept);
    if (status != MUS_OK) return status;
    mesh->first_rim[panel + 1] = at + kept;
    for (int32_t i = 0; i < n && kept < n; i++) {
        if (line_on_rim(mesh, panel, edges[i]) || mus_pattern_edge_seam(mesh->pattern, edges[i]) == MUS_NONE) continue;
        int32_t j = mesh->first_line[panel];
        while (j < line && mesh->line[j] != edges[i]) j++;
        if (j == line) mesh->line[line++] = edges[i];
    }
    mesh->first_line[panel + 1] = line;
    return MUS_OK;
}


mus_status mus__mesh_rims(mus__mesh *mesh)
{
    const int32_t panels = mus_pattern_panel_count(mesh->pattern), points = mus_pattern_point_count(mesh->pattern);
    int64_t total = 0;
    for (int32_t p = 0; p < panels; p++) {
        int32_t n;
        const mus_status status = mus_pattern_outline(mesh->pattern, p, &n, NULL, NULL);
        if (status != MUS_OK) return status;
        total += n;
    }
    mesh->first_rim = mus__new(mesh->context, 2 * ((int64_t)panels + 1) + 3 * total + points, sizeof *mesh->first_rim);
    if (mesh->first_rim == NULL) return mus__fail_memory(mesh->context, "the rims of a cloth");
    mesh->first_line = mesh->first_rim + panels + 1;
    mesh->rim = mesh->first_line + panels + 1;
    mesh->turn = mesh->rim + total;
    mesh->line = mesh->turn + total;
    mesh->point = mesh->line + total;
    mus_status status = MUS_OK;
    for (int32_t p = 0; p < panels && status == MUS_OK; p++) status = line_panel(mesh, p, (int32_t)total);
    for (int32_t i = 0; i < points; i++) mesh->point[i] = MUS_NONE;
    return status;
}


/* the node of the panel at a point of the pattern, a new one where there is none yet */
static int32_t line_point(mus__mesh *mesh, int32_t point, int32_t *count)
{
    if (mesh->point[point] == MUS_NONE) mesh->point[point] = (*count)++;
    return mesh->point[point];
}


int64_t mus__mesh_line_room(const mus__mesh *mesh, int32_t panel)
{
    int64_t room = 0;
    for (int32_t i = mesh->first_line[panel]; i < mesh->first_line[panel + 1]; i++)
        room += mesh->edge[mesh->line[i]].count + 1;
    return room;
}


mus_status mus__mesh_lines(mus__mesh *mesh, int32_t panel, int32_t *count, double *xy)
{
    const int64_t need = mesh->ninner + mus__mesh_line_room(mesh, panel);
    mus_status status = mus__reserve(mesh->context, &mesh->inner, &mesh->cap_inner, need, sizeof *mesh->inner);
    if (status == MUS_OK)
        status = mus__reserve(mesh->context, &mesh->inner_wing, &mesh->cap_inner_wing, need, 2 * sizeof *mesh->inner);
    for (int32_t i = mesh->first_line[panel]; i < mesh->first_line[panel + 1] && status == MUS_OK; i++) {
        mus__edge_nodes *edge = &mesh->edge[mesh->line[i]];
        int32_t start, end;
        status = mus_pattern_edge_ends(mesh->pattern, mesh->line[i], &start, &end);
        edge->inner = mesh->ninner;
        for (int32_t k = 0; k <= edge->count && status == MUS_OK; k++) {
            const int32_t before = *count;
            const double t = (double)k / edge->count;
            const int32_t node = k == 0             ? line_point(mesh, start, count)
                                 : k == edge->count ? line_point(mesh, end, count)
                                                    : (*count)++;
            if (node == before)
                status = mus_pattern_edge_at(mesh->pattern, mesh->line[i], 1, &t, xy + 2 * (ptrdiff_t)node);
            mesh->inner[mesh->ninner++] = node;
        }
    }
    return status;
}


int32_t mus__mesh_line_sides(const mus__mesh *mesh, int32_t panel, int32_t *side)
{
    int32_t n = 0;
    for (int32_t i = mesh->first_line[panel]; i < mesh->first_line[panel + 1]; i++) {
        const mus__edge_nodes *edge = &mesh->edge[mesh->line[i]];
        for (int32_t k = 0; k < edge->count; k++, n++) {
            if (side == NULL) continue;
            side[2 * (ptrdiff_t)n] = mesh->inner[edge->inner + k];
            side[2 * (ptrdiff_t)n + 1] = mesh->inner[edge->inner + k + 1];
        }
    }
    return n;
}


/* the corners opposite to side k .. k + 1 of a line: in the triangle on its left and on its right */
static void line_wings(mus__mesh *mesh, const mus__panel_mesh *panel, int32_t nstrip, int32_t at)
{
    const int32_t a = mesh->inner[at], b = mesh->inner[at + 1];
    for (int32_t t = panel->first_triangle; t < panel->first_triangle + nstrip; t++) {
        const int32_t *v = mesh->cloth->triangle + 3 * (ptrdiff_t)t;
        for (int k = 0; k < 3; k++) {
            const int32_t from = v[k], to = v[(k + 1) % 3];
            if (from == a && to == b) mesh->inner_wing[2 * (ptrdiff_t)at] = v[(k + 2) % 3];
            if (from == b && to == a) mesh->inner_wing[2 * (ptrdiff_t)at + 1] = v[(k + 2) % 3];
        }
    }
}


void mus__mesh_lines_done(mus__mesh *mesh, int32_t panel, int32_t nstrip)
{
    const mus__panel_mesh *own = &mesh->cloth->panel[panel];
    if (mesh->first_line[panel] == mesh->first_line[panel + 1]) return;
    const int32_t first = mesh->edge[mesh->line[mesh->first_line[panel]]].inner;
    for (int32_t i = first; i < mesh->ninner; i++) mesh->inner[i] += own->first_node + own->lattice_count;
    for (int32_t i = mesh->first_line[panel]; i < mesh->first_line[panel + 1]; i++) {
        const mus__edge_nodes *edge = &mesh->edge[mesh->line[i]];
        for (int32_t k = 0; k < edge->count; k++) line_wings(mesh, own, nstrip, edge->inner + k);
    }
}
