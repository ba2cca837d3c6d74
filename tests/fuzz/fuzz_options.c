/*
 * fuzz_options.c: every option struct but those of the target `defs`, with words of it overwritten, and numbers that
 * stand alone (values of a tape, setters of a pattern, a state). Pointers, and the counts of what they point to, are
 * the caller's word and stay; where a length can be asked that only takes time, it is kept short.
 */
#include "fuzz.h"

#include <math.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/print.h"

#define TRIES 4         /* of an input at most */
#define SPACING_FEW 0.1 /* [m] a garment then has some hundred nodes */

/* what the tries have in common, made when it is needed */
typedef struct room {
    mus_context *context;
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern; /* a skirt */
    mus_cloth *cloth;     /* 5 x 4 nodes */
    mus_drape *drape;
    bool sheet; /* one was made: it takes as long as all else */
} room;


static mus_tape *tape_of(room *r)
{
    if (r->tape == NULL)
        fuzz_must(mus_tape_create(r->context, &r->tape) == MUS_OK && mus_tape_set_size(r->tape, "W40") == MUS_OK,
                  "a tape is made");
    return r->tape;
}


static void body_def(mus_body_def *def)
{
    mus_body_def_init(def, sizeof *def);
    def->samples = 16;
    def->ring_spacing = 0.1;
    def->plain = 1;
}


static mus_body *body_of(room *r)
{
    mus_body_def def;
    body_def(&def);
    if (r->body == NULL) fuzz_must(mus_body_create(r->context, tape_of(r), &def, &r->body) == MUS_OK, "a body is made");
    return r->body;
}


static mus_pattern *pattern_of(room *r)
{
    if (r->pattern == NULL)
        fuzz_must(mus_design_draft(r->context, mus_design_find("skirt"), tape_of(r), NULL, &r->pattern) == MUS_OK,
                  "a skirt is drafted");
    return r->pattern;
}


static mus_drape *drape_of(room *r)
{
    const double cell[2] = {0.05, 0.05};
    if (r->drape == NULL)
        fuzz_must(mus_cloth_create_grid(r->context, 5, 4, cell, NULL, &r->cloth) == MUS_OK &&
                      mus_drape_create(r->context, r->cloth, NULL, NULL, &r->drape) == MUS_OK &&
                      mus_drape_place(r->drape) == MUS_OK,
                  "a cloth is draped");
    return r->drape;
}


/* a few steps; a good one leaves every node somewhere */
static void step(mus_drape *drape)
{
    if (mus_drape_step(drape, 2, 0.5 * mus_drape_step_bound(drape)) != MUS_OK) return;
    for (int32_t i = 0; i < 3 * mus_drape_node_count(drape); i++)
        fuzz_must(isfinite(mus_drape_positions(drape)[i]), "a node is somewhere after a good step");
}


/* few samples and rings, where more were allowed: they take time, and are otherwise alike */
static void body_small(mus_body_def *def)
{
    if (def->samples > 32 && def->samples <= 512) def->samples = 32;
    if (def->ring_spacing >= 0.001 && def->ring_spacing < 0.03) def->ring_spacing = 0.03;
}


static void try_body(room *r, fuzz_input *in)
{
    mus_body_def def;
    mus_body *body = NULL;
    body_def(&def);
    fuzz_spoil(in, &def, 0, sizeof def);
    def.limb = NULL;
    body_small(&def);
    if (mus_body_create(r->context, tape_of(r), &def, &body) == MUS_OK)
        fuzz_must(isfinite(mus_body_volume(body)), "a body has a volume");
    mus_body_destroy(body);
}


static void try_limb(room *r, fuzz_input *in)
{
    struct {
        size_t size;
        double contour[3][6];
    } at = {0, {{0.0, 0.0, 0.0, 0.1, 0.1, 2.0}, {0.3, 0.0, 0.02, 0.12, 0.1, 2.5}, {0.6, 0.0, 0.0, 0.08, 0.09, 2.0}}};
    const double outline[3][3][2] = {{{0.1, 0.0}, {-0.05, 0.1}, {-0.05, -0.1}},
                                     {{0.1, 0.0}, {-0.05, 0.1}, {-0.05, -0.1}},
                                     {{0.1, 0.0}, {-0.05, 0.1}, {-0.05, -0.1}}};
    mus_limb limb;
    mus_body_def def;
    mus_body *body = NULL;
    body_def(&def);
    mus_limb_init(&limb, sizeof limb);
    limb.pole[0] = -0.1, limb.pole[1] = 0.7;
    fuzz_spoil(in, &limb, 0, sizeof limb);
    fuzz_spoil(in, &at, sizeof at.size, sizeof at);
    limb.name = "limb";
    limb.contours = 3, limb.contour = at.contour[0];
    limb.outline = fuzz_take(in, 1) % 2 ? outline[0][0] : NULL;
    if (limb.outline != NULL) limb.corners = 3;
    if (mus_body_create_limbs(r->context, 1, &limb, &def, &body) == MUS_OK)
        fuzz_must(isfinite(mus_body_volume(body)), "a limb has a volume");
    mus_body_destroy(body);
}


static void try_bare(room *r, fuzz_input *in)
{
    struct {
        size_t size;
        double place[12], mass[4], length[3], stiffness[3], dashpot[3], bend[2];
        int32_t spring[6], triple[6], pin[2];
    } at = {0,
            {0, 0, 0, 0.1, 0, 0, 0.2, 0, 0, 0.3, 0, 0},
            {0.01, 0.01, 0.01, 0.01},
            {0.1, 0.1, 0.1},
            {10, 10, 10},
            {0, 0.01, 0},
            {1, 1},
            {0, 1, 1, 2, 2, 3},
            {0, 1, 2, 1, 2, 3},
            {0, 3}};
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    fuzz_spoil(in, &at, sizeof at.size, sizeof at);
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 4, bare.springs = 3, bare.bends = 2, bare.pins = fuzz_below(in, 3);
    bare.place = at.place, bare.mass = at.mass, bare.spring = at.spring, bare.length = at.length;
    bare.stiffness = at.stiffness, bare.dashpot = at.dashpot, bare.bend = at.triple, bare.bend_stiffness = at.bend;
    bare.pin = at.pin;
    if (bare.pins > 2) bare.pins = 2;
    if (mus_cloth_create_bare(r->context, &bare, &cloth) == MUS_OK &&
        mus_drape_create(r->context, cloth, NULL, NULL, &drape) == MUS_OK)
        step(drape);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
}


static void try_draft(room *r, fuzz_input *in)
{
    mus_draft_def def;
    mus_pattern *pattern = NULL;
    int32_t faults;
    mus_draft_def_init(&def, sizeof def);
    fuzz_spoil(in, &def, 0, sizeof def);
    if (mus_design_draft(r->context, fuzz_below(in, mus_design_count()), tape_of(r), &def, &pattern) == MUS_OK)
        mus_pattern_check(pattern, &faults, NULL);
    mus_pattern_destroy(pattern);
}


static void try_plane(room *r, fuzz_input *in)
{
    mus_plane plane;
    int32_t index = MUS_NONE;
    const double velocity[3] = {fuzz_real(in, -1.0, 1.0), fuzz_real(in, -1.0, 1.0), 0.0};
    mus_plane_init(&plane, sizeof plane);
    fuzz_spoil(in, &plane, 0, sizeof plane);
    if (mus_drape_add_plane(drape_of(r), &plane, &index) == MUS_OK)
        mus_drape_move_plane(r->drape, fuzz_take(in, 1) % 8 ? index : 7, velocity, fuzz_real(in, -9.0, 9.0));
    step(r->drape);
}


static int32_t stop(void *user, const mus_progress *progress)
{
    (void)user;
    (void)progress;
    return 1;
}


/* to the first report of its sewing */
static void try_dress(room *r, fuzz_input *in)
{
    mus_dress_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = SPACING_FEW;
    fuzz_spoil(in, &def, 0, sizeof def);
    def.fabric = NULL, def.drape = NULL, def.progress = stop, def.progress_user = NULL;
    if (def.threads > 2 && def.threads <= 64) def.threads = 2;
    if (def.nodes_most > 1000 && def.nodes_most <= 1 << 24) def.nodes_most = 1000;
    mus_dress(r->context, pattern_of(r), body_of(r), &def, NULL, NULL, &cloth, &drape);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
}


static void try_cut(room *r, fuzz_input *in)
{
    mus_cut_def def;
    mus_pattern *pattern = NULL;
    int32_t panel, seam;
    const int32_t edges = mus_pattern_edge_count(pattern_of(r));
    fuzz_must(mus_pattern_copy(r->pattern, &pattern) == MUS_OK, "a pattern is copied");
    mus_cut_def_init(&def, sizeof def);
    def.name = "half", def.seam_name = "cut";
    def.edge_a = fuzz_below(in, edges), def.edge_b = fuzz_below(in, edges);
    def.s_a = fuzz_real(in, 0.0, 0.5), def.s_b = fuzz_real(in, 0.0, 0.5);
    fuzz_spoil(in, &def, 0, sizeof def);
    def.name = "half", def.seam_name = "cut", def.kinds = NULL, def.xy = NULL;
    if (fuzz_take(in, 1) % 2)
        mus_pattern_separate(pattern, &def, &panel, &seam);
    else
        mus_pattern_dart_to_seam(pattern, &def, &panel, &seam);
    fuzz_must(mus_pattern_check(pattern, &panel, NULL) == MUS_OK, "a cut pattern can be checked");
    mus_pattern_destroy(pattern);
}


static void try_edge_and_seam(room *r, fuzz_input *in)
{
    const int32_t kinds[2] = {(int32_t)fuzz_take(in, 1) % 6, (int32_t)fuzz_take(in, 1) % 6};
    double xy[10];
    int32_t panel = 0, edge;
    mus_pattern *pattern = NULL;
    mus_edge_def line;
    mus_seam_def sewn;
    for (int32_t i = 0; i < 10; i++) xy[i] = fuzz_real(in, -1.0, 1.0);
    fuzz_must(mus_pattern_create(r->context, "p", &pattern) == MUS_OK &&
                  mus_pattern_add_panel(pattern, "front", &panel) == MUS_OK,
              "a panel is made");
    for (int32_t i = 0; i < 3; i++)
        mus_pattern_add_point(pattern, panel, fuzz_real(in, -1.0, 1.0), fuzz_real(in, -1.0, 1.0), NULL);
    for (int32_t i = 0; i < 3; i++) {
        mus_edge_def_init(&line, sizeof line);
        line.start = i, line.end = (i + 1) % 3;
        fuzz_spoil(in, &line, 0, sizeof line);
        line.name = "edge", line.kinds = NULL, line.xy = NULL;
        if (fuzz_take(in, 1) % 4 == 0) line.npiece = 2, line.nxy = 5, line.kinds = kinds, line.xy = xy;
        if (mus_pattern_add_edge(pattern, &line, &edge) == MUS_OK) mus_pattern_edge_length(pattern, edge);
    }
    mus_pattern_set_outline(pattern, panel, 3, (const int32_t[3]){0, 1, 2}, (const int32_t[3]){1, 1, 1});
    mus_seam_def_init(&sewn, sizeof sewn);
    sewn.edge_a = 1, sewn.edge_b = 2;
    fuzz_spoil(in, &sewn, 0, sizeof sewn);
    mus_pattern_add_seam(pattern, &sewn, NULL);
    mus_pattern_check(pattern, &edge, NULL);
    mus_pattern_destroy(pattern);
}


/* setters of a pattern, and the cloth of it placed */
static void try_setters(room *r, fuzz_input *in)
{
    mus_pattern *pattern = NULL;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_placement placement;
    mus_cloth_def cut;
    const int32_t panels = mus_pattern_panel_count(pattern_of(r)), edges = mus_pattern_edge_count(r->pattern);
    const double a = fuzz_real(in, -0.1, 1.2), b = fuzz_real(in, -5.0, 50.0);
    const int32_t edge = fuzz_below(in, edges), panel = fuzz_below(in, panels), n = (int32_t)fuzz_take(in, 4);
    fuzz_must(mus_pattern_copy(r->pattern, &pattern) == MUS_OK, "a pattern is copied");
    mus_placement_init(&placement, sizeof placement);
    fuzz_spoil(in, &placement, 0, sizeof placement);
    mus_pattern_set_placement(pattern, panel, &placement);
    mus_pattern_set_edge_elastic(pattern, edge, a, b);
    mus_pattern_set_edge_allowance(pattern, edge, a);
    mus_pattern_set_edge_hold(pattern, edge, fuzz_below(in, 14), a);
    mus_pattern_add_notch(pattern, edge, a, fuzz_below(in, 3), NULL);
    mus_pattern_set_grain(pattern, panel, a, b);
    mus_pattern_set_cut(pattern, panel, n, fuzz_below(in, panels));
    mus_pattern_set_material(pattern, panel, fuzz_below(in, 6), n % 16);
    mus_pattern_set_layer(pattern, panel, n);
    mus_pattern_set_panel_sides(pattern, panel, n);
    mus_pattern_open_closures(pattern, n % 2, NULL);
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = SPACING_FEW, cut.nodes_most = 1000;
    if (mus_cloth_create(r->context, pattern, &cut, &cloth) == MUS_OK &&
        mus_drape_create(r->context, cloth, NULL, NULL, &drape) == MUS_OK && mus_drape_place(drape) == MUS_OK)
        step(drape);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
}


static void try_mesh(room *r, fuzz_input *in)
{
    static const int32_t triangle[6] = {0, 1, 2, 0, 2, 3};
    struct {
        size_t size;
        double x[12], moved[24], times[2];
        int32_t triangle[6];
    } at = {0, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0}, {0.0, 0.5}, {0}};
    mus_mesh_view view;
    mus_mesh_motion motion;
    mus_mesh_file file;
    char *bytes = NULL;
    size_t size = 0;
    memcpy(at.triangle, triangle, sizeof triangle);
    fuzz_spoil(in, &at, sizeof at.size, sizeof at);
    mus_mesh_view_init(&view, sizeof view);
    mus_mesh_motion_init(&motion, sizeof motion);
    mus_mesh_file_init(&file, sizeof file);
    fuzz_spoil(in, &view, 0, sizeof view);
    fuzz_spoil(in, &file, 0, sizeof file);
    view.name = "mesh", view.vertex_count = 4, view.triangle_count = 2;
    view.positions = at.x, view.triangles = at.triangle, view.normals = NULL, view.texcoords = NULL;
    motion.positions = at.moved;
    file.count = 1, file.meshes = &view, file.cloths = NULL, file.materials = NULL;
    file.keys = (int32_t)fuzz_take(in, 1) % 3, file.times = at.times, file.motion = file.keys > 0 ? &motion : NULL;
    if (mus_mesh_write_bytes(r->context, &file, &bytes, &size) == MUS_OK) mus_context_alloc(r->context, bytes, 0);
}


static void swing(void *user, double t, const double *y, double *dy)
{
    (void)user;
    (void)t;
    dy[0] = y[2], dy[1] = y[3], dy[2] = -y[0], dy[3] = -y[1];
}


static double swing_energy(void *user, double t, const double *y)
{
    (void)user;
    (void)t;
    return 0.5 * (y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
}


static void try_integrate(room *r, fuzz_input *in)
{
    double y[4] = {1.0, fuzz_real(in, -1.0, 1.0), 0.0, fuzz_real(in, -1.0, 1.0)}, work[64];
    int64_t done;
    mus_integrate_def def;
    mus_integrate_def_init(&def, sizeof def);
    def.step = fuzz_real(in, 0.0, 0.5);
    fuzz_spoil(in, &def, 0, sizeof def);
    def.rate = swing, def.energy = swing_energy, def.rate32 = NULL, def.energy32 = NULL, def.user = NULL;
    fuzz_must(mus_integrate_work(def.method, 4) <= 64, "a state of 4 numbers takes little work");
    if (mus_integrate(r->context, &def, 4, y, 20, work, &done) == MUS_OK)
        fuzz_must(done == 20 && isfinite(y[0] + y[1] + y[2] + y[3]), "a good run has all its steps");
}


static void try_manifold(room *r, fuzz_input *in)
{
    mus_manifold_def def;
    mus_manifold *manifold = NULL;
    mus_manifold_def_init(&def, sizeof def);
    def.spacing = 0.03;
    fuzz_spoil(in, &def, 0, sizeof def);
    if (def.spacing >= 0.001 && def.spacing < 0.03) def.spacing = 0.03;
    if (def.threads > 2 && def.threads <= 64) def.threads = 2;
    mus_manifold_create(body_of(r), &def, &manifold);
    mus_manifold_destroy(manifold);
}


static void try_pose(room *r, fuzz_input *in)
{
    mus_pose pose;
    mus_body *body = NULL;
    mus_pose_init(&pose, sizeof pose);
    fuzz_spoil(in, &pose, 0, sizeof pose);
    mus_pose_check(r->context, &pose);
    if (mus_body_pose(body_of(r), &pose, &body) == MUS_OK) {
        mus_body_stand(body, fuzz_below(in, 4), &pose);
        mus_body_clear_arms(body, &pose, fuzz_real(in, 0.0, 0.05));
        fuzz_must(isfinite(mus_body_vertices(body)[0]), "a posed body is somewhere");
    }
    mus_body_destroy(body);
}


static void try_sheet(room *r, fuzz_input *in)
{
    mus_sheet_def def;
    mus_sheet_dxf dxf;
    mus_sheet_plt plt;
    mus_sheet *sheet = NULL;
    char *bytes = NULL;
    size_t size = 0;
    if (r->sheet) return;
    r->sheet = true;
    mus_sheet_def_init(&def, sizeof def);
    mus_sheet_dxf_init(&dxf, sizeof dxf);
    mus_sheet_plt_init(&plt, sizeof plt);
    def.paper = MUS_PAPER_ROLL;
    fuzz_spoil(in, &def, 0, sizeof def);
    fuzz_spoil(in, &dxf, 0, sizeof dxf);
    fuzz_spoil(in, &plt, 0, sizeof plt);
    def.title = def.person = def.language = NULL;
    dxf.size_name = dxf.date = NULL, dxf.sheets = NULL, dxf.size_names = NULL;
    if (mus_sheet_create(r->context, pattern_of(r), &def, &sheet) != MUS_OK) return;
    if (mus_sheet_write_dxf_bytes(sheet, &dxf, &bytes, &size) == MUS_OK) mus_context_alloc(r->context, bytes, 0);
    if (mus_sheet_write_rul_bytes(sheet, &dxf, &bytes, &size) == MUS_OK) mus_context_alloc(r->context, bytes, 0);
    if (mus_sheet_write_plt_bytes(sheet, &plt, &bytes, &size) == MUS_OK) mus_context_alloc(r->context, bytes, 0);
    mus_sheet_destroy(sheet);
}


static void try_scan(room *r, fuzz_input *in)
{
    mus_scan_def def;
    mus_scan_report report;
    mus_body *scanned = NULL;
    const mus_body *body = body_of(r);
    mus_scan_def_init(&def, sizeof def);
    mus_scan_report_init(&report, sizeof report);
    def.spacing = 0.05, def.corners = 16, def.samples = 16, def.ring_spacing = 0.1;
    fuzz_spoil(in, &def, 0, sizeof def);
    if (def.spacing >= 0.002 && def.spacing < 0.03) def.spacing = 0.03;
    if (def.corners > 32 && def.corners <= 1024) def.corners = 32;
    if (def.samples > 32 && def.samples <= 512) def.samples = 32;
    if (def.ring_spacing >= 0.001 && def.ring_spacing < 0.03) def.ring_spacing = 0.03;
    def.distances = 0;
    mus_body_create_scan(r->context, mus_body_vertex_count(body), mus_body_vertices(body),
                         mus_body_triangle_count(body), mus_body_triangles(body), &def, &report, &scanned);
    mus_body_destroy(scanned);
}


static void try_form(room *r, fuzz_input *in)
{
    mus_form_def def;
    size_t count;
    mus_form_def_init(&def, sizeof def);
    fuzz_spoil(in, &def, 0, sizeof def);
    mus_pattern_form(pattern_of(r), &def, NULL, 0, &count, NULL);
}


static void try_tape(room *r, fuzz_input *in)
{
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_body_def def;
    body_def(&def);
    fuzz_must(mus_tape_copy(tape_of(r), &tape) == MUS_OK, "a tape is copied");
    for (uint32_t n = 1 + fuzz_take(in, 1) % 4; n > 0; n--) {
        const int32_t measure = fuzz_below(in, MUS_MEASURE_COUNT);
        const double is = mus_tape_value(tape, measure);
        mus_tape_set(tape, measure, fuzz_real(in, 0.5 * is, 1.5 * is), fuzz_below(in, 3));
    }
    if (mus_tape_complete(tape) == MUS_OK && mus_body_create(r->context, tape, &def, &body) == MUS_OK)
        fuzz_must(isfinite(mus_body_volume(body)), "a body of odd measures has a volume");
    mus_body_destroy(body);
    mus_tape_destroy(tape);
}


static void try_state(room *r, fuzz_input *in)
{
    double x[60], v[60] = {0.0};
    const double gravity[3] = {fuzz_real(in, -1.0, 1.0), fuzz_real(in, -20.0, 20.0), 0.0};
    memcpy(x, mus_drape_positions(drape_of(r)), sizeof x);
    for (int32_t i = 0; i < 2; i++) {
        const uint32_t at = fuzz_take(in, 1) % 60;
        x[at] = fuzz_real(in, -1.0, 1.0);
        v[at] = fuzz_real(in, -1.0, 1.0);
    }
    mus_drape_set_gravity(r->drape, gravity);
    mus_drape_set_state(r->drape, x, v);
    step(r->drape);
}


/* outlines of odd corners, or the pieces of the pattern; few steps, few runs */
static void try_layout(room *r, fuzz_input *in)
{
    double xy[2][10], turns[2];
    mus_layout_item items[2];
    mus_layout_def def;
    mus_layout *layout = NULL;
    mus_layout_def_init(&def, sizeof def);
    def.steps = 100000;
    const bool pieces = fuzz_take(in, 1) % 4 == 0;
    for (int i = 0; i < 2; i++) {
        mus_layout_item_init(&items[i], sizeof items[i]);
        for (int k = 0; k < 10; k++) xy[i][k] = fuzz_real(in, -0.5, 0.5);
        turns[i] = fuzz_real(in, -4.0, 4.0);
        items[i].n = 5, items[i].count = 1 + (int32_t)fuzz_take(in, 1) % 3;
        fuzz_spoil(in, &items[i], 0, sizeof items[i]);
        items[i].xy = xy[i], items[i].turns = turns;
        items[i].n = items[i].n > 5 ? 5 : items[i].n;
        items[i].turn_count = items[i].turn_count > 2 ? 2 : items[i].turn_count;
        items[i].count = items[i].count > 30 && items[i].count <= 2000 ? 30 : items[i].count;
    }
    fuzz_spoil(in, &def, 0, sizeof def);
    def.steps = def.steps > 300000 ? 300000 : def.steps;
    def.runs = def.runs > 2 && def.runs <= 64 ? 2 : def.runs;
    def.progress = NULL, def.user = NULL;
    const int32_t count = items[0].size == sizeof items[0] ? 2 : 1; /* the size is how far the next one is */
    const mus_status status = pieces ? mus_layout_create(r->context, pattern_of(r), &def, &layout)
                                     : mus_layout_create_items(r->context, count, items, &def, &layout);
    if (status == MUS_OK)
        fuzz_must(mus_layout_length(layout) >= 0.0 && isfinite(mus_layout_length(layout)), "a layout has a length");
    else
        fuzz_must(layout == NULL && mus_context_error(r->context)[0] != '\0', "a refusal has a sentence");
    mus_layout_destroy(layout);
}


void fuzz_options(const uint8_t *bytes, size_t size)
{
    static void (*const tries[])(room *, fuzz_input *) = {
        try_body, try_limb,          try_bare,    try_draft, try_plane,     try_dress,
        try_cut,  try_edge_and_seam, try_setters, try_mesh,  try_integrate, try_manifold,
        try_pose, try_sheet,         try_scan,    try_form,  try_tape,      try_state, try_layout};
    room r = {.context = fuzz_context()};
    fuzz_input in = {bytes, size};
    for (int i = 0; i < TRIES && in.left > 0; i++) tries[fuzz_take(&in, 1) % (sizeof tries / sizeof *tries)](&r, &in);
    mus_drape_destroy(r.drape);
    mus_cloth_destroy(r.cloth);
    mus_pattern_destroy(r.pattern);
    mus_body_destroy(r.body);
    mus_tape_destroy(r.tape);
    fuzz_context_end(r.context);
}
