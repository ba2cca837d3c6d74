/*
 * test_refused_paper.c: numbers that are not finite at the doors of the sheet and of mesh files:
 * refused with a sentence, and no file is made.
 */
#include <unistd.h>

#include "drape/scenes.h"
#include "muslin/exchange.h"
#include "muslin/print.h"
#include "refused.h"

Suite *mus_suite_refused_paper(void);


static mus_status try_sheet(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_sheet *sheet;
    const mus_status status = mus_sheet_create(context, pattern, def, &sheet);
    ck_assert_int_eq(status == MUS_OK, sheet != NULL);
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    return status;
}


START_TEST(a_sheet_def_that_is_not_finite_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_sheet_def, allowance, 1, false, "allowance"),
        REFUSED(mus_sheet_def, margin, 1, false, "margin"),
        REFUSED(mus_sheet_def, overlap, 1, false, "overlap"),
    };
    mus_sheet_def def;
    mus_sheet_def_init(&def, sizeof def);
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_sheet, NULL);
}
END_TEST


/* mus_mesh_view.positions mus_mesh_view.normals mus_mesh_view.texcoords mus_mesh_view.colour */
START_TEST(a_mesh_that_is_not_finite_makes_no_file)
{
    mus_context *context = support_context();
    double number[28] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1, 1};
    const int32_t corner[3] = {0, 1, 2};
    char path[512];
    support_scratch(_i ? "a.glb" : "a.obj", path, sizeof path);
    for (int32_t value = 0; value < 3; value++)
        for (int32_t k = 0; k < 28; k++) {
            const double was = number[k];
            number[k] = refused_values[value];
            mus_mesh_view view;
            mus_mesh_view_init(&view, sizeof view);
            view.vertex_count = 3, view.triangle_count = 1, view.triangles = corner;
            view.positions = number, view.normals = number + 9, view.texcoords = number + 18;
            memcpy(view.colour, number + 24, sizeof view.colour);
            ck_assert_int_eq(_i ? mus_mesh_write_glb(context, path, 1, &view)
                                : mus_mesh_write_obj(context, path, 1, &view),
                             MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "mesh 0"));
            ck_assert_int_ne(access(path, F_OK), 0);
            number[k] = was;
        }
    support_context_end(context);
}
END_TEST


/* mus_mesh_write_glb_motion, mus_mesh_write_glb_motion_bytes: mus_mesh_motion.positions mus_mesh_motion.normals,
 * times; mus_mesh_write_bytes: mus_mesh_file.times */
START_TEST(a_motion_that_is_not_finite_makes_no_file)
{
    mus_context *context = support_context();
    static const double square[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, up[9] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    double number[38] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 0, 0,
                         1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0.5};
    const int32_t corner[3] = {0, 1, 2};
    char path[512];
    support_scratch("motion.glb", path, sizeof path);
    mus_mesh_view view;
    mus_mesh_motion motion;
    mus_mesh_view_init(&view, sizeof view);
    mus_mesh_motion_init(&motion, sizeof motion);
    view.vertex_count = 3, view.triangle_count = 1, view.triangles = corner;
    view.positions = square, view.normals = up;
    motion.positions = number, motion.normals = number + 18;
    for (int32_t value = 0; value < 3; value++)
        for (int32_t k = 0; k < 38; k++) {
            const double was = number[k];
            number[k] = refused_values[value];
            ck_assert_int_eq(mus_mesh_write_glb_motion(context, path, 1, &view, 2, number + 36, &motion), MUS_ERR_ARG);
            ck_assert_int_ne(access(path, F_OK), 0);
            char *bytes;
            size_t size;
            ck_assert_int_eq(mus_mesh_write_glb_motion_bytes(context, 1, &view, 2, number + 36, &motion, &bytes, &size),
                             MUS_ERR_ARG);
            ck_assert_ptr_null(bytes);
            mus_mesh_file file;
            mus_mesh_file_init(&file, sizeof file);
            file.form = MUS_MESH_USDA, file.count = 1, file.meshes = &view;
            file.keys = 2, file.times = number + 36, file.motion = &motion;
            ck_assert_int_eq(mus_mesh_write_bytes(context, &file, &bytes, &size), MUS_ERR_ARG);
            ck_assert_ptr_null(bytes);
            number[k] = was;
        }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_paper(void)
{
    Suite *suite = suite_create("refused_paper");
    TCase *tests = tcase_create("refused_paper");
    tcase_add_test(tests, a_sheet_def_that_is_not_finite_is_refused_by_name);
    tcase_add_loop_test(tests, a_mesh_that_is_not_finite_makes_no_file, 0, 2);
    tcase_add_test(tests, a_motion_that_is_not_finite_makes_no_file);
    suite_add_tcase(suite, tests);
    return suite;
}
