/*
 * test_mesh_files.c: OBJ and binary glTF: what stands in the file is what was handed in. The .glb is taken apart by
 * hand here; the Khronos validator runs on a real one in `make check-glb`.
 */
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "support.h"

/* a square of two triangles, and a triangle that has positions only */
static const double square[12] = {0, 0, 0, 1, 0, 0.25, 1, 1.5, 0, 0, 1, -0.125};
static const double up[12] = {0, 0, 2, 0, 0, 1, 0, 0, 0, 0.6, 0, 0.8};
static const double places[8] = {0, 0, 1, 0, 1, 1, 0, 0.25};
static const int32_t faces[6] = {0, 1, 2, 0, 2, 3};
static const double third = 1.0 / 3.0;


static void make_views(mus_mesh_view *views)
{
    for (int i = 0; i < 2; i++) {
        mus_mesh_view_init(&views[i], sizeof views[i]);
        views[i].positions = square;
        views[i].triangles = faces;
    }
    views[0].name = "shirt \"front\"";
    views[0].vertex_count = 4;
    views[0].triangle_count = 2;
    views[0].normals = up;
    views[0].texcoords = places;
    views[0].two_sided = 1;
    views[0].colour[0] = third;
    views[1].vertex_count = 3;
    views[1].triangle_count = 1;
}


START_TEST(an_obj_counts_through_its_meshes)
{
    mus_context *context = support_context();
    mus_mesh_view views[2];
    make_views(views);
    char path[512];
    ck_assert_int_eq(mus_mesh_write_obj(context, support_scratch("a.obj", path, sizeof path), 2, views), MUS_OK);
    char *text = support_slurp(path, NULL);
    ck_assert_str_eq(text, "# muslin: metres, Y up\n"
                           "o shirt_\"front\"\n"
                           "v 0 0 0\nv 1 0 0.25\nv 1 1.5 0\nv 0 1 -0.125\n"
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0.25\n"
                           "vn 0 0 2\nvn 0 0 1\nvn 0 0 0\nvn 0.6 0 0.8\n"
                           "f 1/1/1 2/2/2 3/3/3\nf 1/1/1 3/3/3 4/4/4\n"
                           "o mesh_1\n"
                           "v 0 0 0\nv 1 0 0.25\nv 1 1.5 0\n"
                           "f 5 6 7\n");
    free(text);

    /* one array alone */
    views[1].normals = up;
    ck_assert_int_eq(mus_mesh_write_obj(context, path, 1, &views[1]), MUS_OK);
    text = support_slurp(path, NULL);
    ck_assert_ptr_nonnull(strstr(text, "f 1//1 2//2 3//3\n"));
    free(text);
    views[1].normals = NULL;
    views[1].texcoords = places;
    ck_assert_int_eq(mus_mesh_write_obj(context, path, 1, &views[1]), MUS_OK);
    text = support_slurp(path, NULL);
    ck_assert_ptr_nonnull(strstr(text, "f 1/1 2/2 3/3\n"));
    free(text);
    support_context_end(context);
}
END_TEST


static uint32_t u32_at(const char *bytes, size_t at)
{
    const unsigned char *b = (const unsigned char *)bytes + at;
    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}


/* number k of accessor `index`: a float or an index */
static double number_at(const json_t *json, const char *bin, int index, size_t k)
{
    const json_t *accessor = json_array_get(json_object_get(json, "accessors"), (size_t)index);
    json_int_t view_index = json_integer_value(json_object_get(accessor, "bufferView"));
    const json_t *view = json_array_get(json_object_get(json, "bufferViews"), (size_t)view_index);
    size_t offset = (size_t)json_integer_value(json_object_get(view, "byteOffset"));
    ck_assert_uint_eq(offset % 4, 0);
    ck_assert_uint_lt(4 * k, (size_t)json_integer_value(json_object_get(view, "byteLength")));
    uint32_t bits = u32_at(bin, offset + 4 * k);
    float real;
    memcpy(&real, &bits, sizeof real);
    return json_integer_value(json_object_get(accessor, "componentType")) == 5125 ? bits : (double)real;
}


/* the JSON chunk parsed, and where the binary one starts */
static json_t *open_glb(const char *bytes, size_t size, const char **bin)
{
    ck_assert_int_eq(memcmp(bytes, "glTF", 4), 0);
    ck_assert_uint_eq(u32_at(bytes, 4), 2);
    ck_assert_uint_eq(u32_at(bytes, 8), size);
    uint32_t json_size = u32_at(bytes, 12);
    ck_assert_uint_eq(json_size % 4, 0);
    ck_assert_int_eq(memcmp(bytes + 16, "JSON", 4), 0);
    json_t *json = json_loadb(bytes + 20, json_size, JSON_REJECT_DUPLICATES, NULL);
    ck_assert_ptr_nonnull(json);
    size_t at = 20 + json_size;
    ck_assert_int_eq(memcmp(bytes + at + 4, "BIN\0", 4), 0);
    ck_assert_uint_eq(at + 8 + u32_at(bytes, at), size);
    const json_t *buffer = json_array_get(json_object_get(json, "buffers"), 0);
    ck_assert_int_eq(json_integer_value(json_object_get(buffer, "byteLength")), u32_at(bytes, at));
    *bin = bytes + at + 8;
    return json;
}


START_TEST(a_glb_holds_what_was_handed_in)
{
    mus_context *context = support_context();
    mus_mesh_view views[2];
    make_views(views);
    char path[512];
    size_t size;
    const char *bin;
    ck_assert_int_eq(mus_mesh_write_glb(context, support_scratch("a.glb", path, sizeof path), 2, views), MUS_OK);
    char *bytes = support_slurp(path, &size);
    json_t *json = open_glb(bytes, size, &bin);

    int position, normal, texcoord, indices, plain;
    const char *name;
    double red;
    int two_sided;
    ck_assert_int_eq(json_unpack(json, "{s[{s:s}]}", "nodes", "name", &name), 0);
    ck_assert_str_eq(name, "shirt \"front\"");
    ck_assert_int_eq(json_unpack(json, "{s[{s[{s{s:i,s:i,s:i},s:i}]},{s[{s{s:i}}]}]}", "meshes", "primitives",
                                 "attributes", "POSITION", &position, "NORMAL", &normal, "TEXCOORD_0", &texcoord,
                                 "indices", &indices, "primitives", "attributes", "POSITION", &plain),
                     0);
    ck_assert_int_eq(json_unpack(json, "{s[{s:b,s{s[F]}}]}", "materials", "doubleSided", &two_sided,
                                 "pbrMetallicRoughness", "baseColorFactor", &red),
                     0);
    ck_assert_int_eq(two_sided, 1);
    ck_assert_double_eq(red, third);

    /* numbers: normals of unit length, zero one up; v runs down */
    for (size_t i = 0; i < 12; i++) ck_assert_double_eq(number_at(json, bin, position, i), square[i]);
    for (size_t i = 0; i < 9; i++) ck_assert_double_eq(number_at(json, bin, plain, i), square[i]);
    const double unit[12] = {0, 0, 1, 0, 0, 1, 0, 1, 0, 0.6, 0, 0.8};
    for (size_t i = 0; i < 12; i++) ck_assert_double_eq_tol(number_at(json, bin, normal, i), unit[i], 1e-7);
    for (size_t i = 0; i < 4; i++) {
        ck_assert_double_eq(number_at(json, bin, texcoord, 2 * i), places[2 * i]);
        ck_assert_double_eq(number_at(json, bin, texcoord, 2 * i + 1), 1.0 - places[2 * i + 1]);
    }
    for (size_t i = 0; i < 6; i++) ck_assert_double_eq(number_at(json, bin, indices, i), faces[i]);
    double low[3], high[3];
    const json_t *accessor = json_array_get(json_object_get(json, "accessors"), (size_t)position);
    ck_assert_int_eq(json_unpack((json_t *)(uintptr_t)accessor, "{s[FFF],s[FFF]}", "min", &low[0], &low[1], &low[2],
                                 "max", &high[0], &high[1], &high[2]),
                     0);
    ck_assert_double_eq(low[2], -0.125);
    ck_assert_double_eq(high[1], 1.5);
    ck_assert_double_eq(high[2], 0.25);
    json_decref(json);
    free(bytes);
    support_context_end(context);
}
END_TEST


START_TEST(bounds_are_those_of_the_floats)
{
    /* 1/3 and its like are no floats: min and max must be the rounded ones */
    mus_context *context = support_context();
    mus_mesh_view view;
    uint64_t seed = 3;
    double xyz[30];
    char path[512];
    size_t size;
    const char *bin;
    for (int i = 0; i < 30; i++) xyz[i] = support_uniform(&seed, -2, 2);
    mus_mesh_view_init(&view, sizeof view);
    view.positions = xyz;
    view.vertex_count = 10;
    view.triangles = faces;
    view.triangle_count = 2;
    ck_assert_int_eq(mus_mesh_write_glb(context, support_scratch("b.glb", path, sizeof path), 1, &view), MUS_OK);
    char *bytes = support_slurp(path, &size);
    json_t *json = open_glb(bytes, size, &bin);
    const json_t *accessor = json_array_get(json_object_get(json, "accessors"), 0);
    for (size_t k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < 10; i++) {
            low = fmin(low, number_at(json, bin, 0, 3 * i + k));
            high = fmax(high, number_at(json, bin, 0, 3 * i + k));
        }
        ck_assert_double_eq(json_number_value(json_array_get(json_object_get(accessor, "min"), k)), low);
        ck_assert_double_eq(json_number_value(json_array_get(json_object_get(accessor, "max"), k)), high);
    }
    json_decref(json);
    free(bytes);
    support_context_end(context);
}
END_TEST


START_TEST(a_mesh_that_makes_no_sense_is_refused_and_no_file_is_made)
{
    mus_context *context = support_context();
    char path[512];
    support_scratch("bad.obj", path, sizeof path);
    for (int fault = 0; fault < 10; fault++) {
        mus_mesh_view views[2];
        make_views(views);
        double xyz[12];
        int32_t corners[6];
        memcpy(xyz, square, sizeof xyz);
        memcpy(corners, faces, sizeof corners);
        views[1].positions = xyz;
        views[1].triangles = corners;
        if (fault == 0) xyz[7] = NAN;
        if (fault == 1) xyz[8] = -INFINITY;
        if (fault == 2) xyz[8] = 1e39;
        if (fault == 3) corners[2] = 3;
        if (fault == 4) corners[1] = -1;
        if (fault == 5) views[1].vertex_count = 0;
        if (fault == 6) views[1].triangle_count = 0;
        if (fault == 7) views[1].positions = NULL;
        if (fault == 8) views[1].colour[3] = 1.5;
        if (fault == 9) views[1].size = 8;
        mus_status wanted = fault == 9 ? MUS_ERR_VERSION : MUS_ERR_ARG;
        ck_assert_int_eq(mus_mesh_write_obj(context, path, 2, views), wanted);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "mesh 1: "));
        ck_assert_int_eq(mus_mesh_write_glb(context, path, 2, views), wanted);
        ck_assert_ptr_null(support_slurp(path, NULL));
    }
    mus_mesh_view views[2];
    make_views(views);
    ck_assert_int_eq(mus_mesh_write_obj(context, path, 0, views), MUS_ERR_ARG);
    ck_assert_int_eq(mus_mesh_write_glb(context, path, 1, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_mesh_write_glb(context, NULL, 1, views), MUS_ERR_ARG);
    ck_assert_int_eq(mus_mesh_write_glb(NULL, path, 1, views), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


/* the square swings up at key 1 and is back at key 2; the triangle stands still */
static const double swing_times[3] = {0, 0.5, 1.5};


static void make_motion(double *positions, double *normals, mus_mesh_motion *motion)
{
    for (size_t i = 0; i < 36; i++) positions[i] = square[i % 12] + (i / 12 == 1 ? 0.25 * (double)(i % 5) : 0.0);
    for (size_t i = 0; i < 36; i++) normals[i] = i / 12 == 1 ? (i % 3 == 0 ? 3.0 : 0.0) : up[i % 12];
    for (int i = 0; i < 2; i++) mus_mesh_motion_init(&motion[i], sizeof motion[i]);
    motion[0].positions = positions;
    motion[0].normals = normals;
}


START_TEST(a_glb_in_motion_adds_up_to_each_key)
{
    mus_context *context = support_context();
    mus_mesh_view views[2];
    mus_mesh_motion motion[2];
    double positions[36], normals[36];
    make_views(views);
    make_motion(positions, normals, motion);
    char path[512];
    size_t size;
    const char *bin;
    ck_assert_int_eq(mus_mesh_write_glb_motion(context, support_scratch("m.glb", path, sizeof path), 2, views, 3,
                                               swing_times, motion),
                     MUS_OK);
    char *bytes = support_slurp(path, &size);
    json_t *json = open_glb(bytes, size, &bin);

    /* base and target together are the key, in place and in the unit normal */
    int base, normal;
    const json_t *mesh = json_array_get(json_object_get(json, "meshes"), 0);
    const json_t *primitive = json_array_get(json_object_get(mesh, "primitives"), 0);
    ck_assert_int_eq(json_unpack((json_t *)(uintptr_t)primitive, "{s{s:i,s:i}}", "attributes", "POSITION", &base,
                                 "NORMAL", &normal),
                     0);
    const json_t *targets = json_object_get(primitive, "targets");
    ck_assert_uint_eq(json_array_size(targets), 3);
    ck_assert_uint_eq(json_array_size(json_object_get(mesh, "weights")), 3);
    for (size_t k = 0; k < 3; k++) {
        int place, turn;
        json_t *target = json_array_get(targets, k);
        ck_assert_int_eq(json_unpack(target, "{s:i,s:i}", "POSITION", &place, "NORMAL", &turn), 0);
        for (size_t i = 0; i < 12; i++)
            ck_assert_double_eq_tol(number_at(json, bin, base, i) + number_at(json, bin, place, i),
                                    positions[12 * k + i], 1e-6);
        for (size_t i = 0; k == 1 && i < 12; i++)
            ck_assert_double_eq_tol(number_at(json, bin, normal, i) + number_at(json, bin, turn, i),
                                    i % 3 == 0 ? 1.0 : 0.0, 1e-6);
    }

    /* one channel, for the mesh that moves; the weights at each key are one 1 */
    int node, input, output;
    const char *way;
    ck_assert_int_eq(json_unpack(json, "{s[{s[{s:i,s:i}],s[{s:i,s{s:i,s:s}}]}]}", "animations", "samplers", "input",
                                 &input, "output", &output, "channels", "sampler", &base, "target", "node", &node,
                                 "path", &way),
                     0);
    ck_assert_int_eq(node, 0);
    ck_assert_str_eq(way, "weights");
    for (size_t k = 0; k < 3; k++) {
        ck_assert_double_eq(number_at(json, bin, input, k), swing_times[k]);
        for (size_t i = 0; i < 3; i++) ck_assert_double_eq(number_at(json, bin, output, 3 * k + i), i == k);
    }
    ck_assert_ptr_null(json_object_get(
        json_array_get(json_object_get(json_array_get(json_object_get(json, "meshes"), 1), "primitives"), 0),
        "targets"));
    json_decref(json);
    free(bytes);
    support_context_end(context);
}
END_TEST


START_TEST(a_motion_that_makes_no_sense_is_refused_and_no_file_is_made)
{
    mus_context *context = support_context();
    char path[512];
    support_scratch("badmotion.glb", path, sizeof path);
    for (int fault = 0; fault < 9; fault++) {
        mus_mesh_view views[2];
        mus_mesh_motion motion[2];
        double positions[36], normals[36], times[3];
        int32_t keys = 3;
        make_views(views);
        make_motion(positions, normals, motion);
        memcpy(times, swing_times, sizeof times);
        if (fault == 0) positions[35] = NAN;
        if (fault == 1) normals[20] = INFINITY;
        if (fault == 2) times[1] = times[0];
        if (fault == 3) times[0] = -1.0;
        if (fault == 4) times[2] = NAN;
        if (fault == 5) keys = 0;
        if (fault == 6) keys = 4097;
        if (fault == 7) motion[0].size = 8;
        if (fault == 8) motion[1].positions = positions, motion[1].normals = normals;
        ck_assert_int_eq(mus_mesh_write_glb_motion(context, path, 2, views, keys, times, motion),
                         fault == 7 ? MUS_ERR_VERSION : MUS_ERR_ARG);
        ck_assert_str_ne(mus_context_error(context), "");
        ck_assert_ptr_null(support_slurp(path, NULL));
    }
    support_context_end(context);
}
END_TEST


START_TEST(each_allocation_that_fails_is_a_status_and_no_leak)
{
    mus_mesh_view views[2];
    mus_mesh_motion motion[2];
    double positions[36], normals[36];
    make_views(views);
    make_motion(positions, normals, motion);
    char path[512];
    support_scratch("fail.glb", path, sizeof path);
    int64_t failed = 0;
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        support_fail_after(n, false);
        mus_status status = mus_mesh_write_glb(context, path, 2, views);
        if (status == MUS_OK) status = mus_mesh_write_obj(context, path, 2, views);
        if (status == MUS_OK) status = mus_mesh_write_glb_motion(context, path, 2, views, 3, swing_times, motion);
        support_fail_never();
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        failed++;
    }
    ck_assert_int_ge(failed, 5);
}
END_TEST


Suite *mus_suite_mesh_files(void);

Suite *mus_suite_mesh_files(void)
{
    Suite *suite = suite_create("mesh_files");
    TCase *tests = tcase_create("mesh_files");
    tcase_add_test(tests, an_obj_counts_through_its_meshes);
    tcase_add_test(tests, a_glb_holds_what_was_handed_in);
    tcase_add_test(tests, bounds_are_those_of_the_floats);
    tcase_add_test(tests, a_mesh_that_makes_no_sense_is_refused_and_no_file_is_made);
    tcase_add_test(tests, a_glb_in_motion_adds_up_to_each_key);
    tcase_add_test(tests, a_motion_that_makes_no_sense_is_refused_and_no_file_is_made);
    tcase_add_test(tests, each_allocation_that_fails_is_a_status_and_no_leak);
    suite_add_tcase(suite, tests);
    return suite;
}
