/*
 * test_memory.c: what is read from memory is what is read from a file, and what is written into memory is the file.
 */
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "support.h"

static mus_tape *sized(mus_context *context, const char *size)
{
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, size), MUS_OK);
    return tape;
}


START_TEST(a_tape_written_into_memory_is_the_file_and_reads_back)
{
    mus_context *context = support_context();
    mus_tape *tape = sized(context, "W40"), *again;
    char path[512], *bytes;
    size_t size, file_size;
    support_scratch("memory.tape", path, sizeof path);
    ck_assert_int_eq(mus_tape_write(tape, path), MUS_OK);
    ck_assert_int_eq(mus_tape_write_bytes(tape, &bytes, &size), MUS_OK);
    char *file = support_slurp(path, &file_size);
    ck_assert_uint_eq(size, file_size);
    ck_assert_mem_eq(bytes, file, size);
    ck_assert_int_eq(mus_tape_read_from(context, bytes, size, "me.tape", NULL, &again), MUS_OK);
    for (int32_t i = 0; i < mus_measure_count(); i++)
        if (mus_tape_source(tape, i) == MUS_SOURCE_GIVEN)
            ck_assert(mus_tape_value(tape, i) == mus_tape_value(again, i));

    free(file);
    mus_context_alloc(context, bytes, 0);
    mus_tape_destroy(again);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_pattern_goes_through_memory_bit_for_bit)
{
    mus_context *context = support_context();
    mus_tape *tape = sized(context, "W40");
    mus_pattern *pattern, *again;
    char *bytes, *second;
    size_t size, second_size;
    ck_assert_int_eq(mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_write_bytes(pattern, &bytes, &size), MUS_OK);
    ck_assert_int_eq(mus_pattern_read_from(context, bytes, size, "tshirt.json", &again), MUS_OK);
    ck_assert_int_eq(mus_pattern_write_bytes(again, &second, &second_size), MUS_OK);
    ck_assert_uint_eq(size, second_size);
    ck_assert_mem_eq(bytes, second, size);

    mus_context_alloc(context, bytes, 0);
    mus_context_alloc(context, second, 0);
    mus_pattern_destroy(again);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_fabric_goes_through_memory)
{
    mus_context *context = support_context();
    mus_fabric fabric, again;
    char *bytes;
    size_t size;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_fabric_init(&again, sizeof again);
    ck_assert_int_eq(mus_fabric_find("denim", &fabric), MUS_OK);
    ck_assert_int_eq(mus_fabric_save_bytes(context, &fabric, "denim", NULL, &bytes, &size), MUS_OK);
    ck_assert_int_eq(mus_fabric_load_from(context, bytes, size, "denim.json", &again), MUS_OK);
    ck_assert_mem_eq(&fabric, &again, sizeof fabric);
    mus_context_alloc(context, bytes, 0);
    support_context_end(context);
}
END_TEST


START_TEST(a_mesh_goes_through_memory_and_a_glb_says_its_length)
{
    mus_context *context = support_context();
    const double x[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const int32_t triangle[3] = {0, 1, 2};
    mus_mesh_view view;
    mus_mesh_view_init(&view, sizeof view);
    view.name = "t";
    view.vertex_count = 3;
    view.triangle_count = 1;
    view.positions = x;
    view.triangles = triangle;
    char *bytes;
    size_t size;
    mus_mesh *mesh;
    ck_assert_int_eq(mus_mesh_write_obj_bytes(context, 1, &view, &bytes, &size), MUS_OK);
    ck_assert_int_eq(mus_mesh_read_obj_from(context, bytes, size, "t.obj", &mesh), MUS_OK);
    ck_assert_int_eq(mus_mesh_vertex_count(mesh), 3);
    ck_assert_mem_eq(mus_mesh_vertices(mesh), x, sizeof x);
    ck_assert_mem_eq(mus_mesh_triangles(mesh), triangle, sizeof triangle);
    mus_mesh_destroy(mesh);
    mus_context_alloc(context, bytes, 0);

    ck_assert_int_eq(mus_mesh_write_glb_bytes(context, 1, &view, &bytes, &size), MUS_OK);
    uint32_t head[3];
    memcpy(head, bytes, sizeof head);
    ck_assert_uint_eq(head[2], size);
    mus_context_alloc(context, bytes, 0);
    support_context_end(context);
}
END_TEST


START_TEST(what_memory_holds_wrongly_is_said_by_its_name)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_tape *tape;
    char *bytes = "x";
    size_t size;
    ck_assert_int_eq(mus_pattern_read_from(context, "{", 1, "mine.json", &pattern), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "mine.json:1"));
    ck_assert_ptr_null(pattern);
    ck_assert_int_eq(mus_pattern_read_from(context, NULL, 0, "none.json", &pattern), MUS_ERR_FORMAT);
    ck_assert_int_eq(mus_pattern_read_from(context, "{}", 2, NULL, &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_read_from(context, "bust 90 cm", 10, "me.doc", NULL, &tape), MUS_ERR_FORMAT);
    tape = sized(context, "W40");
    ck_assert_int_eq(mus_tape_write_bytes(tape, &bytes, NULL), MUS_ERR_ARG);
    ck_assert_ptr_null(bytes);
    ck_assert_int_eq(mus_tape_write_bytes(tape, NULL, &size), MUS_ERR_ARG);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_memory(void);

Suite *mus_suite_memory(void)
{
    Suite *suite = suite_create("memory");
    TCase *tests = tcase_create("memory");
    tcase_add_test(tests, a_tape_written_into_memory_is_the_file_and_reads_back);
    tcase_add_test(tests, a_pattern_goes_through_memory_bit_for_bit);
    tcase_add_test(tests, a_fabric_goes_through_memory);
    tcase_add_test(tests, a_mesh_goes_through_memory_and_a_glb_says_its_length);
    tcase_add_test(tests, what_memory_holds_wrongly_is_said_by_its_name);
    suite_add_tcase(suite, tests);
    return suite;
}
