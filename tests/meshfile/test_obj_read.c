/* test_obj_read.c: Wavefront OBJ in: its forms of faces, what is passed by, what is refused with file and line. */
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "support.h"

Suite *mus_suite_obj_read(void);


static mus_status obj_of(mus_context *context, const char *text, mus_mesh **out)
{
    char path[512];
    support_scratch("a.obj", path, sizeof path);
    support_spill(path, text, strlen(text));
    return mus_mesh_read_obj(context, path, out);
}


START_TEST(all_forms_of_faces_are_read)
{
    mus_context *context = support_context();
    mus_mesh *mesh;
    ck_assert_int_eq(obj_of(context,
                            "# This file uses centimeters\r\nmtllib a.mtl\no body\n"
                            "v 0 0 0\nv 1.5e0 0 -.25 1.0\n  v\t1 1 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\n"
                            "f 1 2 3 # a remark\nv 0 1 0\r\nv 2 2 2\ng skin\nusemtl a\ns off\n"
                            "f 1/1 2/1 3/1 4/1\nf 1//1 2//1 3//1\nf -1/1/1 -2/1/1 \\\n -3/1/1 1/1/1 2/1/1\nl 1 2\n",
                            &mesh),
                     MUS_OK);
    static const int32_t expect[] = {0, 1, 2, 0, 1, 2, 0, 2, 3, 0, 1, 2, 4, 3, 2, 4, 2, 0, 4, 0, 1};
    ck_assert_int_eq(mus_mesh_vertex_count(mesh), 5);
    ck_assert_int_eq(mus_mesh_triangle_count(mesh), 7);
    ck_assert_mem_eq(mus_mesh_triangles(mesh), expect, sizeof expect);
    const double *x = mus_mesh_vertices(mesh);
    ck_assert_double_eq(x[3], 1.5);
    ck_assert_double_eq(x[5], -0.25);
    ck_assert_double_eq(x[6], 1.0);
    ck_assert_double_eq(x[14], 2.0);
    mus_mesh_destroy(mesh);
    mus_mesh_destroy(NULL);
    ck_assert_int_eq(mus_mesh_vertex_count(NULL), 0);
    ck_assert_ptr_null(mus_mesh_vertices(NULL));
    support_context_end(context);
}
END_TEST


START_TEST(what_is_wrong_has_file_and_line)
{
    static const struct {
        const char *text, *word;
    } bad[] = {
        {"", "no face"},
        {"v 0 0 0\n", "no face"},
        {"v 0 0\nf 1 1 1\n", "a.obj:1: vertex 1: expected three numbers"},
        {"v 0 0 nan\n", "a.obj:1"},
        {"v 0 0 1e999\n", "a.obj:1"},
        {"v 0,5 0 0\n", "a.obj:1"},
        {"v 0 0 0\nf 1 2 3\n", "a.obj:2: a face: there is no vertex 2 yet"},
        {"v 0 0 0\nf 1 1\n", "2 corners"},
        {"v 0 0 0\nf 1 1 0\n", "no vertex 0"},
        {"v 0 0 0\nf 1 1 -2\n", "no vertex -2"},
        {"v 0 0 0\nf 1 1 x\n", "a vertex's number"},
        {"v 0 0 0\nf 1 1 1.5\n", "a vertex's number"},
        {"v 0 0 0\nf 1 1 99999999999999999999\n", "a.obj:2"},
    };
    mus_context *context = support_context();
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        mus_mesh *mesh = (mus_mesh *)context;
        ck_assert_msg(obj_of(context, bad[k].text, &mesh) == MUS_ERR_FORMAT, "%s", bad[k].text);
        ck_assert_ptr_null(mesh);
        ck_assert_msg(strstr(mus_context_error(context), bad[k].word) != NULL, "%s", mus_context_error(context));
    }
    mus_mesh *mesh;
    ck_assert_int_eq(mus_mesh_read_obj(context, "no/such/file.obj", &mesh), MUS_ERR_FILE);
    ck_assert_int_eq(mus_mesh_read_obj(context, NULL, &mesh), MUS_ERR_ARG);
    ck_assert_int_eq(mus_mesh_read_obj(context, "a", NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_mesh_read_obj(NULL, "a", &mesh), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


/* a file of the library's own writer is read back to the digits of a float */
START_TEST(a_written_mesh_is_read_back)
{
    mus_context *context = support_context();
    static const double x[12] = {0, 0, 0, 1, 0, 0.25, 1, 1.0 / 3.0, 0, 0, 1, -0.125};
    static const int32_t faces[6] = {0, 1, 2, 0, 2, 3};
    mus_mesh_view view;
    mus_mesh *mesh;
    char path[512];
    mus_mesh_view_init(&view, sizeof view);
    view.positions = x, view.triangles = faces, view.normals = x, view.vertex_count = 4, view.triangle_count = 2;
    support_scratch("a.obj", path, sizeof path);
    ck_assert_int_eq(mus_mesh_write_obj(context, path, 1, &view), MUS_OK);
    ck_assert_int_eq(mus_mesh_read_obj(context, path, &mesh), MUS_OK);
    ck_assert_mem_eq(mus_mesh_triangles(mesh), faces, sizeof faces);
    for (int i = 0; i < 12; i++) ck_assert_double_eq_tol(mus_mesh_vertices(mesh)[i], x[i], 1e-9);
    mus_mesh_destroy(mesh);
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_of_an_obj_is_a_status)
{
    char path[512], *text = NULL;
    support_scratch("a.obj", path, sizeof path);
    text = calloc(1, 400000);
    for (int k = 0; k < 5000; k++) strcat(text + 20 * (ptrdiff_t)k, "v 0 0 0\nf 1 1 1 1 1\n");
    support_spill(path, text, strlen(text));
    free(text);
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_mesh *mesh;
        support_fail_after(n, false);
        const mus_status status = mus_mesh_read_obj(context, path, &mesh);
        support_fail_never();
        mus_mesh_destroy(mesh);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_obj_read(void)
{
    Suite *suite = suite_create("obj_read");
    TCase *tests = tcase_create("obj_read");
    tcase_add_test(tests, all_forms_of_faces_are_read);
    tcase_add_test(tests, what_is_wrong_has_file_and_line);
    tcase_add_test(tests, a_written_mesh_is_read_back);
    tcase_add_test(tests, each_failing_allocation_of_an_obj_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
