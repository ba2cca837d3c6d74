/*
 * cloth.c: cut a pattern in a fabric; read, share and destroy the cloth. A stranger to this folder starts here.
 *
 * Files in the order of use: fabric_table.c and fabric_value.c (measured fabrics), fabric.c (spring constants of a
 * fabric), lattice.c (nodes and cells inside a panel), mesh.c and panel_lines.c (nodes and triangles of a panel),
 * lattice_springs.c and border_springs.c (its springs), seam_pairs.c (seams), calibrate_bending.c (bending rigidity of
 * a panel), pleat_folds.c, edge_elements.c (gathers, elastics, attachments), coarse_cut.c (coarser cuts).
 * rectangle_cloth.c and spring_network.c make a cloth without a pattern. lib/drape moves the cloth.
 *
 * The pattern is checked first. Each panel is then meshed, and its springs are made while its lattice is in memory.
 * Seams come last, when all panels have nodes.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/elementary.h"
#include "cloth/mesh.h"
#include "muslin/topology.h"

/* [m] range of a spacing; chosen: threads are half a millimetre apart, and a coarser mesh has no sleeve */
#define SPACING_LEAST 0.001
#define SPACING_MOST 0.1
#define FORECAST_ROOM 0.95 /* of nodes_most: a forecast is 3 % too low at most where seams make edges finer */


void mus_cloth_def_init(mus_cloth_def *def, size_t size)
{
    mus_cloth_def own = {.spacing = 0.01,
                         .bending = MUS_BEND_PLATE,
                         .paper_curvature = 30.0,
                         .coarser = 1,
                         .nodes_most = MUS_CLOTH_NODES};
    mus__def_init(def, size, &own, sizeof own);
}


mus_status mus__cloth_def_read(mus_context *context, const mus_cloth_def *def, const mus_fabric *otherwise,
                               mus_cloth_def *own, mus_fabric *fabric)
{
    mus_cloth_def_init(own, sizeof *own);
    mus_status status = mus__def_read(context, own, sizeof *own, sizeof *own, def, "mus_cloth_def");
    mus_fabric_init(fabric, sizeof *fabric);
    if (own->fabric == NULL) own->fabric = otherwise;
    if (status == MUS_OK)
        status = mus__def_read(context, fabric, sizeof *fabric, MUS__FABRIC_FIRST, own->fabric, "mus_fabric");
    if (status == MUS_OK) status = mus_fabric_check(context, fabric);
    if (status != MUS_OK) return status;
    own->fabric = fabric;
    if (own->bending != MUS_BEND_PLATE && own->bending != MUS_BEND_PAPER)
        return mus__fail(context, MUS_ERR_ARG, "bending %d is neither plate (0) nor paper (1)", (int)own->bending);
    if (!(own->paper_curvature >= 0.1 && own->paper_curvature <= 1000.0))
        return mus__fail(context, MUS_ERR_ARG, "paper_curvature %g /m is outside 0.1 to 1000 /m", own->paper_curvature);
    if (own->nodes_most < 1 || own->nodes_most > MUS__CLOTH_NODES_LIMIT)
        return mus__fail(context, MUS_ERR_ARG, "nodes_most is %d, expected 1 to %d", (int)own->nodes_most,
                         MUS__CLOTH_NODES_LIMIT);
    return MUS_OK;
}


mus_cloth *mus__cloth_new(mus_context *context)
{
    mus_cloth *cloth = mus__new(context, 1, sizeof *cloth);
    if (cloth == NULL) return NULL;
    cloth->context = context;
    cloth->references = 1;
    return cloth;
}


/* a faulty pattern is refused with the text of its first fault */
static mus_status cloth_check(mus_context *context, const mus_pattern *pattern)
{
    mus_faults *faults = NULL;
    int32_t count = 0;
    mus_status status = mus_pattern_check(pattern, &count, &faults);
    if (status == MUS_OK && count > 0) {
        status = mus__fail(context, MUS_ERR_PATTERN, "%s", mus_faults_text(faults, 0));
    } else if (status != MUS_OK && context != mus_pattern_context(pattern)) {
        mus__fail(context, status, "%s", mus_context_error(mus_pattern_context(pattern)));
    }
    mus_faults_destroy(faults);
    return status;
}


/* copy the names of the pattern and its panels, for messages, and the warp direction of each panel, for strains */
static mus_status cloth_names(mus_cloth *cloth, const mus_pattern *pattern)
{
    cloth->names = mus__new(cloth->context, (int64_t)cloth->npanel + 1, MUS__CLOTH_NAME);
    cloth->warp = mus__new(cloth->context, 2 * (int64_t)cloth->npanel, sizeof *cloth->warp);
    if (cloth->names == NULL || cloth->warp == NULL) return mus__fail_memory(cloth->context, "a cloth");
    for (int32_t p = 0; p < cloth->npanel; p++) {
        double *warp = cloth->warp + 2 * (ptrdiff_t)p;
        mus_pattern_grain(pattern, p, warp);
        const double size = mus__hypot(warp[0], warp[1]);
        warp[0] /= size, warp[1] /= size;
    }
    for (int32_t p = -1; p < cloth->npanel; p++) {
        const char *name = p < 0 ? mus_pattern_name(pattern) : mus_pattern_panel_name(pattern, p);
        const size_t length = strlen(name);
        memcpy(cloth->names + (ptrdiff_t)MUS__CLOTH_NAME * (p + 1), name,
               length < MUS__CLOTH_NAME ? length : MUS__CLOTH_NAME - 1);
    }
    return MUS_OK;
}


/* is the panel of a node placed nearer to level than to upright? */
static bool cloth_lies(const mus_cloth *cloth, int32_t node)
{
    const mus_placement *place = &cloth->panel[cloth->node_panel[node]].placement;
    return place->rotation[5] * place->rotation[5] > 0.5; /* the height of the plane's normal */
}


/* on a stiffened cut: panels that are placed lying, as a collar on the shoulders, stay as soft as their fabric, whose
 * weight lays them down. Stiff ones would stand up round the neck */
static void cloth_soften_lying(mus_cloth *cloth, double share)
{
    for (int32_t b = 0; b < cloth->nbend; b++)
        if (cloth_lies(cloth, cloth->bend[b].a)) cloth->bend[b].k *= share;
    for (int32_t h = 0; h < cloth->nhinge; h++)
        if (cloth_lies(cloth, cloth->hinge[h].node[0])) cloth->hinge[h].k *= share;
}


/* mesh all panels, then join them along seams, then adjust the springs */
static mus_status cloth_build(mus__mesh *mesh)
{
    mus_cloth *cloth = mesh->cloth;
    const double cell[2] = {cloth->spacing, cloth->spacing};
    mus__fabric_on_cell(&cloth->fabric, cell, &mesh->constant);
    if (mesh->paper > 0.0) mus__fabric_on_paper(&cloth->fabric, cell, mesh->paper, &mesh->constant);
    mus__fabric_couple(cloth, cell, &mesh->constant);
    mus_status status = mus__mesh_edges(mesh);
    for (int32_t p = 0; status == MUS_OK && p < cloth->npanel; p++) {
        mus__lattice lattice = {0};
        int32_t nstrip = 0;
        status = mus__mesh_panel(mesh, p, &lattice, &nstrip);
        if (status == MUS_OK) status = mus__mesh_runs(mesh, &lattice, cloth->panel[p].first_node);
        if (status == MUS_OK) status = mus__mesh_strip(mesh, &lattice, &cloth->panel[p], nstrip);
        mus__lattice_free(mesh->context, &lattice);
    }
    if (status == MUS_OK) status = mus__mesh_seams(mesh);
    if (status == MUS_OK) status = mus__mesh_calibrate(mesh);
    if (status == MUS_OK && mesh->lying_share < 1.0) cloth_soften_lying(cloth, mesh->lying_share);
    if (status == MUS_OK) status = mus__mesh_facings(mesh);
    if (status == MUS_OK) status = mus__mesh_limit(mesh);
    if (status == MUS_OK) status = mus__mesh_turns(mesh);
    if (status == MUS_OK) status = mus__mesh_held(mesh);
    if (status == MUS_OK) status = mus__mesh_pleats(mesh);
    for (int32_t i = 0; i < cloth->nnode; i++) cloth->mass_total += cloth->mass[i];
    return status;
}


/* the nodes that a pattern takes at a spacing [m], by the theorem of Pick: area / spacing^2 + border nodes / 2 + 1 for
 * each panel, and at least the nodes of the border; edges that a seam makes finer are counted while they are meshed */
static double cloth_forecast(const mus_pattern *pattern, double spacing)
{
    double nodes = mus_pattern_panel_count(pattern), border = 0.0;
    for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++)
        border += fmax(mus_pattern_edge_length(pattern, e) / spacing, 1.0);
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++)
        nodes += mus_pattern_panel_area(pattern, p) / (spacing * spacing);
    return fmax(nodes + 0.5 * border, border);
}


/* MUS_ERR_LIMIT for a pattern that takes more nodes than the def allows, before the memory is taken. The sentence has
 * a spacing that takes few enough, where there is one */
static mus_status cloth_limit(mus_context *context, const mus_pattern *pattern, const mus_cloth_def *def)
{
    const double nodes = cloth_forecast(pattern, def->spacing), most = def->nodes_most;
    if (nodes <= most) return MUS_OK;
    double spacing = def->spacing;
    while (spacing <= SPACING_MOST && cloth_forecast(pattern, spacing) > FORECAST_ROOM * most)
        spacing = ceil(1e4 * 1.02 * spacing) / 1e4; /* 2 % and at least a tenth of a millimetre more */
    char advice[64] = "";
    if (spacing <= SPACING_MOST) snprintf(advice, sizeof advice, "; a spacing of %g m takes fewer", spacing);
    return mus__fail(context, MUS_ERR_LIMIT,
                     "the pattern takes about %g nodes at a spacing of %g m, at most %d (nodes_most)%s", nodes,
                     def->spacing, (int)def->nodes_most, advice);
}


/* one cut of a pattern at the spacing and of the fabric of the options, without coarser cuts; `lying_share` goes to
 * the mesh */
static mus_status cloth_cut(mus_context *context, const mus_pattern *pattern, const mus_cloth_def *def,
                            double lying_share, mus_cloth **out)
{
    mus__mesh mesh = {
        .context = context, .pattern = pattern, .nodes_most = def->nodes_most, .lying_share = lying_share};
    if (def->bending == MUS_BEND_PAPER) mesh.paper = def->paper_curvature;
    mus_cloth *cloth = mus__cloth_new(context);
    if (cloth == NULL) return mus__fail_memory(context, "a cloth");
    cloth->fabric = *def->fabric, cloth->spacing = def->spacing;
    if (def->bending == MUS_BEND_PLATE) cloth->bend_slide = mus__fabric_slide(&cloth->fabric);
    cloth->npanel = mus_pattern_panel_count(pattern);
    cloth->panel = mus__new(context, cloth->npanel, sizeof *cloth->panel);
    mesh.cloth = cloth;
    mesh.seam_bend = mus__new(context, 4 * (int64_t)cloth->npanel, sizeof *mesh.seam_bend);
    mesh.edge = mus__new(context, mus_pattern_edge_count(pattern), sizeof *mesh.edge);
    mus_status status = MUS_OK;
    if (cloth->panel == NULL || mesh.edge == NULL || mesh.seam_bend == NULL)
        status = mus__fail_memory(context, "a cloth");
    if (status == MUS_OK) status = cloth_names(cloth, pattern);
    if (status == MUS_OK) status = cloth_build(&mesh);
    mus__free(context, mesh.edge);
    mus__free(context, mesh.wing);
    mus__free(context, mesh.first_rim);
    mus__free(context, mesh.inner);
    mus__free(context, mesh.inner_wing);
    mus__free(context, mesh.seam_bend);
    mus__free(context, mesh.partner);
    if (status == MUS_OK)
        *out = cloth;
    else
        mus_cloth_destroy(cloth);
    return status;
}


/* the coarser cuts of a cloth. A pattern that cannot be meshed so coarsely has none. Errors: MUS_ERR_MEMORY */
static mus_status cloth_coarsen(mus_cloth *cloth, const mus_pattern *pattern, const mus_cloth_def *def)
{
    mus_fabric stiff = *def->fabric;
    mus_cloth_def coarse = *def;
    coarse.fabric = &stiff;
    double lying_share = 1.0;
    mus_status status = MUS_OK;
    while (status == MUS_OK && mus__cloth_coarser(cloth, def, &coarse.spacing)) {
        lying_share *= mus__cloth_stiffen(coarse.spacing, &stiff);
        status = cloth_cut(cloth->context, pattern, &coarse, lying_share, &cloth->coarse);
        cloth = cloth->coarse;
    }
    return status == MUS_ERR_MEMORY ? status : MUS_OK;
}


mus_status mus_cloth_create(mus_context *context, const mus_pattern *pattern, const mus_cloth_def *def, mus_cloth **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (pattern == NULL || out == NULL)
        return mus__fail(context, MUS_ERR_ARG, "cloth: %s is NULL", pattern == NULL ? "pattern" : "out");

    mus_cloth_def own;
    mus_fabric fabric, jersey;
    mus_fabric_init(&jersey, sizeof jersey);
    mus_fabric_find("jersey", &jersey);
    mus_status status = mus__cloth_def_read(context, def, &jersey, &own, &fabric);
    if (status != MUS_OK) return status;
    if (!(own.spacing >= SPACING_LEAST && own.spacing <= SPACING_MOST))
        return mus__fail(context, MUS_ERR_ARG, "spacing %g m is outside %g to %g m", own.spacing, SPACING_LEAST,
                         SPACING_MOST);
    if (mus_pattern_panel_count(pattern) == 0) return mus__fail(context, MUS_ERR_PATTERN, "the pattern has no panel");
    status = cloth_check(context, pattern);
    if (status == MUS_OK) status = cloth_limit(context, pattern, &own);
    if (status != MUS_OK) return status;

    mus_cloth *cloth = NULL;
    status = cloth_cut(context, pattern, &own, 1.0, &cloth);
    if (status == MUS_OK) status = cloth_coarsen(cloth, pattern, &own);
    const double cell[2] = {own.spacing, own.spacing};
    if (status == MUS_OK)
        mus__fabric_note(context, &fabric, cell);
    else
        mus_cloth_destroy(cloth);
    if (status == MUS_OK) *out = cloth;
    return status;
}


mus_cloth *mus__cloth_retain(const mus_cloth *cloth)
{
    /* counting owners is no change of the cloth; the copy of the pointer says so without a cast */
    mus_cloth *own;
    memcpy(&own, &cloth, sizeof own);
    own->references++;
    return own;
}


void mus_cloth_destroy(mus_cloth *cloth)
{
    if (cloth == NULL || --cloth->references > 0) return;
    void *blocks[] = {cloth->panel,  cloth->rest,       cloth->mass, cloth->node_panel, cloth->triangle,
                      cloth->border, cloth->row,        cloth->run,  cloth->bend,       cloth->spring,
                      cloth->hinge,  cloth->seam_hinge, cloth->pair, cloth->pair_seam,  cloth->pair_length,
                      cloth->place,  cloth->dashpot,    cloth->pin,  cloth->hold,       cloth->names,
                      cloth->warp,   cloth->pleat,      cloth->cell, cloth->seam_turn};
    mus_context *context = cloth->context;
    mus_cloth_destroy(cloth->coarse);
    for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++) mus__free(context, blocks[i]);
    mus__free(context, cloth);
}


int32_t mus_cloth_node_count(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->nnode : 0;
}


int32_t mus_cloth_triangle_count(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->ntriangle : 0;
}


int32_t mus_cloth_panel_count(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->npanel : 0;
}


const char *mus_cloth_name(const mus_cloth *cloth)
{
    return cloth == NULL || cloth->names == NULL ? "" : cloth->names;
}


const char *mus_cloth_panel_name(const mus_cloth *cloth, int32_t panel)
{
    if (cloth == NULL || panel < 0 || panel >= cloth->npanel) return NULL;
    return cloth->names == NULL ? "" : cloth->names + (ptrdiff_t)MUS__CLOTH_NAME * (panel + 1);
}


int32_t mus_cloth_spring_count(const mus_cloth *cloth)
{
    if (cloth == NULL) return 0;
    int32_t sum = cloth->nspring + cloth->nhinge + cloth->nseam_hinge;
    for (int32_t r = 0; r < cloth->nrun; r++) sum += cloth->run[r].count;
    for (int32_t r = 0; r < cloth->nbend; r++) sum += cloth->bend[r].count;
    return sum;
}


int32_t mus_cloth_pair_count(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->npair : 0;
}


double mus_cloth_spacing(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->spacing : 0.0;
}


double mus_cloth_mass(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->mass_total : 0.0;
}


const double *mus_cloth_rest(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->rest : NULL;
}


const int32_t *mus_cloth_node_panels(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->node_panel : NULL;
}


const double *mus_cloth_masses(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->mass : NULL;
}


const int32_t *mus_cloth_triangles(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->triangle : NULL;
}


const int32_t *mus_cloth_pairs(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->pair : NULL;
}


const int32_t *mus_cloth_pair_seams(const mus_cloth *cloth)
{
    return cloth != NULL ? cloth->pair_seam : NULL;
}


static mus_status cloth_known_panel(const mus_cloth *cloth, int32_t panel)
{
    if (cloth == NULL) return MUS_ERR_ARG;
    if (panel >= 0 && panel < cloth->npanel) return MUS_OK;
    return mus__fail(cloth->context, MUS_ERR_ARG, "panel %d is outside 0 to %d", (int)panel, (int)cloth->npanel - 1);
}


mus_status mus_cloth_panel_range(const mus_cloth *cloth, int32_t panel, int32_t *range)
{
    mus_status status = cloth_known_panel(cloth, panel);
    if (status != MUS_OK) return status;
    if (range == NULL) return mus__fail(cloth->context, MUS_ERR_ARG, "range is NULL");
    const mus__panel_mesh *mesh = &cloth->panel[panel];
    range[0] = mesh->first_node, range[1] = mesh->node_count;
    range[2] = mesh->first_triangle, range[3] = mesh->triangle_count;
    return MUS_OK;
}


mus_status mus_cloth_panel_border(const mus_cloth *cloth, int32_t panel, int32_t *n, const int32_t **nodes)
{
    mus_status status = cloth_known_panel(cloth, panel);
    if (status != MUS_OK) return status;
    if (n == NULL || nodes == NULL) return mus__fail(cloth->context, MUS_ERR_ARG, "n or nodes is NULL");
    *n = cloth->panel[panel].border_count;
    *nodes = cloth->border + cloth->panel[panel].first_border;
    return MUS_OK;
}
