/* fuzz_files.c: targets that read a file from the bytes. */
#define _POSIX_C_SOURCE 200809L /* mkstemp */
#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "muslin/catalogue.h"
#include "muslin/exchange.h"
#include "muslin/print.h"


void fuzz_pattern(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    mus_pattern *pattern = fuzz_pattern_of(context, bytes, size), *again = NULL;
    if (pattern != NULL) {
        char *text = NULL, *second = NULL;
        size_t length = 0, second_length = 0;
        fuzz_must(mus_pattern_write_bytes(pattern, &text, &length) == MUS_OK, "a pattern that was read is written");
        again = fuzz_pattern_of(context, (const uint8_t *)text, length);
        fuzz_must(again != NULL, "a pattern that was written is read");
        fuzz_must(mus_pattern_write_bytes(again, &second, &second_length) == MUS_OK, "it is written again");
        fuzz_must(length == second_length && memcmp(text, second, length) == 0, "both writings are the same bytes");
        mus_context_alloc(context, text, 0);
        mus_context_alloc(context, second, 0);
        int32_t faults;
        mus_pattern_check(pattern, &faults, NULL);
        size_t bytes_of_form;
        if (mus_pattern_panel_count(pattern) <= 64 && mus_pattern_seam_count(pattern) <= 256)
            mus_pattern_form(pattern, NULL, NULL, 0, &bytes_of_form, NULL);
    }
    mus_pattern_destroy(again);
    mus_pattern_destroy(pattern);
    fuzz_context_end(context);
}


/* the DXF in one size, with the rules or without */
static void read_size(mus_context *context, mus_pattern_dxf *from, const char *size)
{
    mus_pattern *pattern = NULL;
    from->size_name = size;
    const mus_status status = mus_pattern_read_dxf(context, from, &pattern);
    fuzz_must((status == MUS_OK) == (pattern != NULL), "a DXF gives a pattern exactly with MUS_OK");
    fuzz_must(status == MUS_OK || mus_context_error(context)[0] != '\0', "a refusal of a DXF has a sentence");
    if (pattern != NULL) {
        char *text = NULL;
        size_t length = 0;
        int32_t count = 0;
        fuzz_must(mus_pattern_write_bytes(pattern, &text, &length) == MUS_OK, "a DXF that was read is written");
        mus_context_alloc(context, text, 0);
        if (mus_pattern_edge_count(pattern) <= 60)
            fuzz_must(mus_pattern_propose_seams(pattern, NULL, NULL, NULL, 0, &count) == MUS_OK, "seams are proposed");
    }
    mus_pattern_destroy(pattern);
}


void fuzz_dxf(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    size_t end = 4;
    while (end < size && memcmp(bytes + end - 4, "EOF\n", 4) != 0) end++;
    if (end > size) end = size;
    mus_pattern_dxf from;
    mus_pattern_dxf_init(&from, sizeof from);
    from.path = "fuzz.dxf";
    from.text = (const char *)bytes;
    from.text_size = end;
    read_size(context, &from, NULL);
    from.rules_path = "fuzz.rul";
    from.rules = (const char *)bytes + end;
    from.rules_size = size - end;
    read_size(context, &from, "38");
    fuzz_context_end(context);
}


void fuzz_svg(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    mus_pattern *pattern = NULL, *again = NULL;
    if (mus_pattern_read_from(context, (const char *)bytes, size, "fuzz.svg", &pattern) == MUS_OK) {
        char *text = NULL;
        size_t length = 0;
        fuzz_must(mus_pattern_write_svg_bytes(pattern, &text, &length) == MUS_OK, "a drawing that was read is written");
        fuzz_must(mus_pattern_read_from(context, text, length, "again.svg", &again) == MUS_OK,
                  "a drawing that was written is read");
        fuzz_must(mus_pattern_panel_count(again) == mus_pattern_panel_count(pattern) &&
                      mus_pattern_edge_count(again) == mus_pattern_edge_count(pattern) &&
                      mus_pattern_seam_count(again) == mus_pattern_seam_count(pattern),
                  "a drawing comes back with its panels, edges and seams");
        mus_context_alloc(context, text, 0);
    }
    mus_pattern_destroy(again);
    mus_pattern_destroy(pattern);
    fuzz_context_end(context);
}


void fuzz_val(const uint8_t *bytes, size_t size)
{
    static const char last[] = "</pattern>\n";
    const size_t length = sizeof last - 1;
    mus_context *context = fuzz_context();
    mus_pattern_val from;
    size_t end = length;
    while (end < size && memcmp(bytes + end - length, last, length) != 0) end++;
    if (end > size) end = size;
    mus_pattern_val_init(&from, sizeof from);
    from.path = "fuzz.val";
    from.text = (const char *)bytes;
    from.text_size = end;
    for (int32_t i = 0; i < 3; i++) {
        mus_pattern *pattern = NULL;
        const mus_status status = mus_pattern_read_val(context, &from, &pattern);
        fuzz_must((status == MUS_OK) == (pattern != NULL), "a drawing gives a pattern exactly with MUS_OK");
        fuzz_must(status == MUS_OK || mus_context_error(context)[0] != '\0', "a refusal of a drawing has a sentence");
        mus_pattern_destroy(pattern);
        from.measures_path = "fuzz.vit";
        from.measures = (const char *)bytes + end;
        from.measures_size = size - end;
        from.size_name = i == 1 ? "520_1700" : NULL; /* of a table */
    }
    fuzz_context_end(context);
}


void fuzz_tape(const uint8_t *bytes, size_t size)
{
    static const char *const forms[] = {"me.tape", "me.csv", "me.yaml", "me.vit"};
    mus_context *context = fuzz_context();
    mus_tape *tape = NULL, *again = NULL;
    const char *form = forms[size > 0 ? bytes[0] % 4 : 0];
    const char *row = size > 0 && bytes[0] / 4 % 2 ? "Bo" : NULL; /* of a table */
    const size_t head = size > 0;
    if (mus_tape_read_from(context, (const char *)bytes + head, size - head, form, row, &tape) == MUS_OK) {
        char *text = NULL;
        size_t length = 0;
        mus_tape_complete(tape);
        fuzz_must(mus_tape_write_bytes(tape, &text, &length) == MUS_OK, "a tape that was read is written");
        fuzz_must(mus_tape_read_from(context, text, length, "me.tape", NULL, &again) == MUS_OK,
                  "a tape that was written is read");
        mus_context_alloc(context, text, 0);
    }
    mus_tape_destroy(again);
    mus_tape_destroy(tape);
    fuzz_context_end(context);
}


void fuzz_fabric(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    if (mus_fabric_load_from(context, (const char *)bytes, size, "fuzz", &fabric) == MUS_OK) {
        char *text = NULL;
        size_t length = 0;
        mus_fabric again;
        mus_fabric_init(&again, sizeof again);
        if (mus_fabric_save_bytes(context, &fabric, "cloth", NULL, &text, &length) == MUS_OK) {
            fuzz_must(mus_fabric_load_from(context, text, length, "fuzz", &again) == MUS_OK, "a saved fabric is read");
            mus_context_alloc(context, text, 0);
        }
    }
    fuzz_context_end(context);
}


void fuzz_scan(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    mus_mesh *mesh = NULL;
    mus_body *body = NULL;
    mus_scan_def def;
    mus_scan_def_init(&def, sizeof def);
    def.spacing = 0.05, def.corners = 16, def.samples = 16, def.ring_spacing = 0.1; /* a person takes 0.1 s, not 5 */
    def.distances = size % 8 == 0;
    if (mus_mesh_read_obj_from(context, (const char *)bytes, size, "fuzz", &mesh) == MUS_OK &&
        mus_mesh_vertex_count(mesh) <= 4096)
        mus_body_create_scan(context, mus_mesh_vertex_count(mesh), mus_mesh_vertices(mesh),
                             mus_mesh_triangle_count(mesh), mus_mesh_triangles(mesh), &def, NULL, &body);
    mus_body_destroy(body);
    mus_mesh_destroy(mesh);
    fuzz_context_end(context);
}


void fuzz_drape(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    mus_pattern *pattern = fuzz_pattern_of(context, bytes, size);
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_drape_def_init(&def, sizeof def);
    cut.spacing = 0.05;
    cut.nodes_most = 1000; /* all of them in one heap take 2 s under the sanitizers */
    def.self_contact = size % 2;
    def.precision = size % 4 < 2 ? 32 : 64;
    if (pattern != NULL && mus_cloth_create(context, pattern, &cut, &cloth) == MUS_OK &&
        mus_drape_create(context, cloth, NULL, &def, &drape) == MUS_OK && mus_drape_place(drape) == MUS_OK &&
        mus_drape_step(drape, 5, 0.9 * mus_drape_step_bound(drape)) == MUS_OK) {
        const double *x = mus_drape_positions(drape);
        for (int32_t i = 0; i < 3 * mus_drape_node_count(drape); i++)
            fuzz_must(isfinite(x[i]), "a node is somewhere after a good step");
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    fuzz_context_end(context);
}


/* does a pattern lie within 50 m of its origin? A sheet of thousands of pages takes seconds under the sanitizers */
static bool print_fits(const mus_pattern *pattern)
{
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        int32_t n = 0;
        const double *xy = NULL;
        mus_pattern_edge_pieces(pattern, i, NULL, NULL, &n, &xy);
        for (int32_t k = 0; k < 2 * n; k++)
            if (!(fabs(xy[k]) <= 50.0)) return false;
    }
    return true;
}


void fuzz_print(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    mus_pattern *pattern = fuzz_pattern_of(context, bytes, size);
    mus_sheet *sheet = NULL;
    char *told = NULL;
    size_t told_length = 0;
    const char *tag = mus_language_tag((int32_t)(size % (size_t)mus_language_count()));
    if (pattern != NULL &&
        mus_pattern_write_instructions_in_bytes(pattern, tag, NULL, &told, &told_length) == MUS_OK)
        mus_context_alloc(context, told, 0);
    if (pattern != NULL && print_fits(pattern) && mus_sheet_create(context, pattern, NULL, &sheet) == MUS_OK) {
        char *text = NULL;
        size_t length = 0;
        if (mus_sheet_page_count(sheet) <= 16 && mus_sheet_write_pdf_bytes(sheet, &text, &length) == MUS_OK)
            mus_context_alloc(context, text, 0);
        if (mus_sheet_write_svg_bytes(sheet, &text, &length) == MUS_OK) mus_context_alloc(context, text, 0);
        if (mus_sheet_write_dxf_bytes(sheet, NULL, &text, &length) == MUS_OK) mus_context_alloc(context, text, 0);
    }
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    fuzz_context_end(context);
}


/* a square of four edges, one seam joining two of them: a pattern with a form, which the seed good.db holds too */
static mus_pattern *square(mus_context *context)
{
    static const double corner[4][2] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    int32_t edges[4], ahead[4] = {1, 1, 1, 1}, panel;
    mus_pattern *pattern = NULL;
    mus_edge_def edge;
    mus_seam_def seam;
    mus_edge_def_init(&edge, sizeof edge);
    mus_seam_def_init(&seam, sizeof seam);
    bool made = mus_pattern_create(context, "square", &pattern) == MUS_OK &&
                mus_pattern_add_panel(pattern, "front", &panel) == MUS_OK;
    for (int32_t i = 0; i < 4 && made; i++)
        made = mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], NULL) == MUS_OK;
    for (int32_t i = 0; i < 4 && made; i++) {
        edge.start = i, edge.end = (i + 1) % 4;
        made = mus_pattern_add_edge(pattern, &edge, &edges[i]) == MUS_OK;
    }
    seam.edge_a = 1, seam.edge_b = 3;
    fuzz_must(made && mus_pattern_set_outline(pattern, panel, 4, edges, ahead) == MUS_OK &&
                  mus_pattern_add_seam(pattern, &seam, NULL) == MUS_OK,
              "a square is made");
    return pattern;
}


static void search_and_add(mus_catalogue *catalogue, const mus_pattern *pattern)
{
    int32_t ids[8], exact[8], count = 0, id;
    double distances[8], parts[MUS_DISTANCE_COUNT];
    char why[256];
    const char *name;
    mus_catalogue_count(catalogue);
    mus_catalogue_exact(catalogue, pattern, ids, 8, &count);
    mus_catalogue_nearest(catalogue, pattern, 8, ids, distances, exact, &count);
    for (int32_t i = 0; i < count && i < 8; i++) {
        mus_catalogue_name(catalogue, ids[i], &name);
        mus_catalogue_explain(catalogue, pattern, ids[i], parts, why, sizeof why);
    }
    mus_catalogue_containing(catalogue, pattern, ids, 8, &count);
    if (mus_catalogue_add(catalogue, pattern, "square", &id) == MUS_OK && mus_catalogue_begin(catalogue) == MUS_OK) {
        mus_catalogue_add(catalogue, pattern, "again", &id);
        mus_catalogue_rollback(catalogue);
    }
}


void fuzz_catalogue(const uint8_t *bytes, size_t size)
{
    char path[FUZZ_PATH];
    fuzz_path(path);
    const int file = mkstemp(path);
    fuzz_must(file >= 0 && write(file, bytes, size) == (ssize_t)size && close(file) == 0, "a file is written");
    mus_context *context = fuzz_context();
    mus_catalogue *catalogue = NULL;
    mus_pattern *pattern = square(context);
    const mus_status status = mus_catalogue_open(context, path, MUS_CATALOGUE_WRITE, &catalogue);
    fuzz_must(status == MUS_OK || mus_context_error(context)[0] != '\0', "a refusal of a catalogue has a sentence");
    if (status == MUS_OK) search_and_add(catalogue, pattern);
    mus_catalogue_destroy(catalogue);
    mus_pattern_destroy(pattern);
    fuzz_context_end(context);
    unlink(path);
}
