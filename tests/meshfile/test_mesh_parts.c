/*
 * test_mesh_parts.c: a skirt of two panels as a mesh file: panels by name, texture without overlap, seams as lines.
 * `make check-glb` has the files read by other programs.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "meshfile/mesh_file.h"
#include "support.h"

#define WIDE 0.4
#define HIGH 0.6

typedef struct skirt {
    mus_context *context;
    mus_cloth *cloth;
    double *positions;
    mus_mesh_view view;
    mus_mesh_file file;
    const mus_cloth *cloths[1];
    const char *materials[1];
} skirt;


/* two rectangles, sewn at both sides, that stand one behind the other */
static void skirt_open(skirt *s)
{
    mus_pattern *pattern = NULL;
    int32_t edges[2][4];
    memset(s, 0, sizeof *s);
    s->context = support_context();
    ck_assert_int_eq(mus_pattern_create(s->context, "skirt", &pattern), MUS_OK);
    for (int32_t p = 0; p < 2; p++) {
        const double corners[8] = {0, 0, WIDE, 0, WIDE, HIGH, 0, HIGH};
        const int32_t signs[4] = {1, 1, 1, 1};
        int32_t points[4], panel;
        ck_assert_int_eq(mus_pattern_add_panel(pattern, p == 0 ? "front" : "back panel", &panel), MUS_OK);
        for (int32_t i = 0; i < 4; i++)
            ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corners[2 * i], corners[2 * i + 1], &points[i]),
                             MUS_OK);
        for (int32_t i = 0; i < 4; i++) {
            mus_edge_def edge;
            mus_edge_def_init(&edge, sizeof edge);
            edge.start = points[i], edge.end = points[(i + 1) % 4];
            ck_assert_int_eq(mus_pattern_add_edge(pattern, &edge, &edges[p][i]), MUS_OK);
        }
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edges[p], signs), MUS_OK);
    }
    for (int32_t side = 1; side < 4; side += 2) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        seam.edge_a = edges[0][side], seam.edge_b = edges[1][4 - side];
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_OK);
    }
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = 0.05;
    ck_assert_int_eq(mus_cloth_create(s->context, pattern, &def, &s->cloth), MUS_OK);
    mus_pattern_destroy(pattern);

    const int32_t n = mus_cloth_node_count(s->cloth);
    s->positions = malloc(sizeof *s->positions * 3 * (size_t)n);
    for (ptrdiff_t i = 0; i < n; i++) {
        s->positions[3 * i] = mus_cloth_rest(s->cloth)[2 * i];
        s->positions[3 * i + 1] = mus_cloth_rest(s->cloth)[2 * i + 1];
        s->positions[3 * i + 2] = mus_cloth_node_panels(s->cloth)[i];
    }
    mus_mesh_view_init(&s->view, sizeof s->view);
    s->view.name = "skirt";
    s->view.vertex_count = n, s->view.triangle_count = mus_cloth_triangle_count(s->cloth);
    s->view.positions = s->positions, s->view.triangles = mus_cloth_triangles(s->cloth);
    s->view.texcoords = mus_cloth_rest(s->cloth);
    mus_mesh_file_init(&s->file, sizeof s->file);
    s->cloths[0] = s->cloth, s->materials[0] = "jersey";
    s->file.count = 1, s->file.meshes = &s->view, s->file.cloths = s->cloths, s->file.materials = s->materials;
}


static void skirt_close(skirt *s)
{
    free(s->positions);
    mus_cloth_destroy(s->cloth);
    support_context_end(s->context);
}


START_TEST(a_cloth_is_its_panels_its_islands_and_its_seams)
{
    skirt s;
    mus__mesh_set set;
    skirt_open(&s);
    ck_assert_int_eq(mus__mesh_set_make(s.context, &s.file, &set), MUS_OK);
    const mus__mesh_parts *mesh = &set.mesh[0];
    ck_assert_int_eq(mesh->count, 2);
    ck_assert_str_eq(mesh->part[1].name, "back panel");
    ck_assert_int_eq(mesh->part[0].vertices + mesh->part[1].vertices, s.view.vertex_count);

    /* islands: one scale, inside the unit square, boxes apart */
    double box[2][4], scale = 0.0;
    for (int32_t p = 0; p < 2; p++) {
        const mus__mesh_part *part = &mesh->part[p];
        double *b = box[p];
        b[0] = b[1] = INFINITY, b[2] = b[3] = -INFINITY;
        for (ptrdiff_t v = part->first_vertex; v < part->first_vertex + part->vertices; v++)
            for (int k = 0; k < 2; k++) {
                b[k] = fmin(b[k], mesh->islands[2 * v + k]);
                b[2 + k] = fmax(b[2 + k], mesh->islands[2 * v + k]);
            }
        ck_assert(b[0] >= 0.0 && b[1] >= 0.0 && b[2] <= 1.0 && b[3] <= 1.0);
        if (p == 0) scale = (b[2] - b[0]) / WIDE;
        ck_assert_double_eq_tol((b[2] - b[0]) / WIDE, scale, 1e-12);
        ck_assert_double_eq_tol((b[3] - b[1]) / HIGH, scale, 1e-12);
    }
    ck_assert(box[0][2] < box[1][0] || box[1][2] < box[0][0] || box[0][3] < box[1][1] || box[1][3] < box[0][1]);
    ck_assert_double_gt(scale, 0.9); /* two of 0.4 by 0.6 stand on a square of 0.8 */

    /* seams: the lines add up to the two sides */
    double length = 0.0;
    for (int32_t i = 0; i < mesh->nline; i++) {
        const double *a = s.positions + 3 * mesh->lines[2 * i], *b = s.positions + 3 * mesh->lines[2 * i + 1];
        length += hypot(a[0] - b[0], a[1] - b[1]);
    }
    ck_assert_double_eq_tol(length, 2.0 * HIGH, 1e-9);
    mus__mesh_set_free(&set);
    skirt_close(&s);
}
END_TEST


START_TEST(each_form_names_the_panels)
{
    skirt s;
    char path[512];
    size_t size = 0;
    skirt_open(&s);
    ck_assert_int_eq(mus_mesh_write(s.context, support_scratch("skirt.obj", path, sizeof path), &s.file), MUS_OK);
    char *text = support_slurp(path, NULL);
    ck_assert_ptr_nonnull(strstr(text, "mtllib skirt.mtl\no skirt\n"));
    ck_assert_ptr_nonnull(strstr(text, "g back_panel\nusemtl jersey.back_panel\n"));
    ck_assert_ptr_nonnull(strstr(text, "g seams\nl "));
    free(text);
    text = support_slurp(support_scratch("skirt.mtl", path, sizeof path), NULL);
    ck_assert_ptr_nonnull(strstr(text, "newmtl jersey.back_panel\n"));
    free(text);

    static const char *const wanted[] = {"g front\n", "\"name\":\"back panel\"", "def Mesh \"back_panel\"",
                                         "comment part 1 back panel\n"};
    for (int32_t form = MUS_MESH_OBJ; form <= MUS_MESH_PLY; form++) {
        s.file.form = form;
        ck_assert_int_eq(mus_mesh_write_bytes(s.context, &s.file, &text, &size), MUS_OK);
        bool found = false;
        for (size_t i = 0; i + strlen(wanted[form]) <= size && !found; i++)
            found = memcmp(text + i, wanted[form], strlen(wanted[form])) == 0;
        ck_assert_msg(found, "form %d lacks %s", (int)form, wanted[form]);
        mus_context_alloc(s.context, text, 0);
    }
    skirt_close(&s);
}
END_TEST


START_TEST(a_point_cache_is_the_positions_of_each_key)
{
    skirt s;
    skirt_open(&s);
    const size_t n = 3 * (size_t)s.view.vertex_count;
    const double times[2] = {0.0, 0.5};
    double *moved = malloc(2 * n * sizeof *moved);
    for (size_t i = 0; i < 2 * n; i++) moved[i] = s.positions[i % n] + (double)(i / n);
    mus_mesh_motion motion;
    mus_mesh_motion_init(&motion, sizeof motion);
    motion.positions = moved;
    s.file.form = MUS_MESH_PC2;
    char *bytes = NULL;
    size_t size = 0;
    ck_assert_int_eq(mus_mesh_write_bytes(s.context, &s.file, &bytes, &size), MUS_ERR_ARG);
    s.file.keys = 2, s.file.times = times, s.file.motion = &motion;
    ck_assert_int_eq(mus_mesh_write_bytes(s.context, &s.file, &bytes, &size), MUS_OK);
    ck_assert_uint_eq(size, 32 + 8 * n);
    ck_assert_int_eq(memcmp(bytes, "POINTCACHE2\0\1\0\0\0", 16), 0);
    ck_assert_int_eq((unsigned char)bytes[28], 2);
    mus_context_alloc(s.context, bytes, 0);

    /* the motion of glTF and USD is that of every part */
    s.file.form = MUS_MESH_USDA;
    ck_assert_int_eq(mus_mesh_write_bytes(s.context, &s.file, &bytes, &size), MUS_OK);
    ck_assert_ptr_nonnull(strstr(bytes, "timeCodesPerSecond = 2\n"));
    int32_t samples = 0;
    for (const char *at = bytes; (at = strstr(at, "points.timeSamples")) != NULL; at++) samples++;
    ck_assert_int_eq(samples, 3);
    mus_context_alloc(s.context, bytes, 0);
    free(moved);
    skirt_close(&s);
}
END_TEST


START_TEST(a_mesh_of_another_cloth_is_refused)
{
    skirt s;
    char *bytes = NULL;
    size_t size = 0;
    skirt_open(&s);
    s.view.triangle_count--;
    ck_assert_int_eq(mus_mesh_write_bytes(s.context, &s.file, &bytes, &size), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(s.context), "its cloth has others"));
    s.view.triangle_count++;
    s.file.form = 5;
    ck_assert_int_eq(mus_mesh_write_bytes(s.context, &s.file, &bytes, &size), MUS_ERR_ARG);
    s.file.size--;
    ck_assert_int_eq(mus_mesh_write_bytes(s.context, &s.file, &bytes, &size), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_mesh_write_bytes(s.context, NULL, &bytes, &size), MUS_ERR_ARG);
    ck_assert_ptr_null(bytes);
    skirt_close(&s);
}
END_TEST


Suite *mus_suite_mesh_parts(void);

Suite *mus_suite_mesh_parts(void)
{
    Suite *suite = suite_create("mesh_parts");
    TCase *tests = tcase_create("mesh_parts");
    tcase_add_test(tests, a_cloth_is_its_panels_its_islands_and_its_seams);
    tcase_add_test(tests, each_form_names_the_panels);
    tcase_add_test(tests, a_point_cache_is_the_positions_of_each_key);
    tcase_add_test(tests, a_mesh_of_another_cloth_is_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
