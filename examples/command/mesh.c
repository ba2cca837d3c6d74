/*
 * mesh.c: makes a body from a mesh, for muslin body and muslin dress; prints its measures and frame as a table or JSON.
 */
#include "mesh.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define DEGREES 57.295779513082

static const char *const part_names[MUS_SCAN_PART_COUNT] = {"torso", "head", "arms", "hands", "legs", "feet"};
static const char *const girth_names[MUS_SCAN_GIRTH_COUNT] = {"bust", "waist", "hip", "thigh", "wrist"};


/* Converts an axis, "y" or "-z", to the library's number. */
static bool axis_read(const char *text, int32_t *out)
{
    static const char *const names[] = {"-z", "-y", "-x", "", "x", "y", "z"};
    if (text == NULL) return true;
    for (int32_t k = 0; k < 7; k++)
        if (k != 3 && strcmp(text, names[k]) == 0) {
            *out = k - 3;
            return true;
        }
    return false;
}


int mesh_body(scene *s, const mesh_source *from, mus_scan_report *report, mus_body **out)
{
    mus_scan_def def;
    mus_mesh *mesh = NULL;
    mus_scan_def_init(&def, sizeof def);
    def.unit = from->unit;
    *out = NULL;
    if (!axis_read(from->up, &def.up))
        return complain(EXIT_INPUT, s->command, "--up %s: expected x, y, z, -x, -y or -z", from->up);
    if (!axis_read(from->front, &def.front))
        return complain(EXIT_INPUT, s->command, "--front %s: expected x, y, z, -x, -y or -z", from->front);
    mus_status status = mus_mesh_read_obj(s->context, from->file, &mesh);
    if (status == MUS_OK)
        status = mus_body_create_scan(s->context, mus_mesh_vertex_count(mesh), mus_mesh_vertices(mesh),
                                      mus_mesh_triangle_count(mesh), mus_mesh_triangles(mesh), &def, report, out);
    mus_mesh_destroy(mesh);
    return status == MUS_OK ? EXIT_DONE : scene_fail(s, status);
}


static void mesh_table(const mus_scan_report *r)
{
    printf("height %.2f cm, one unit of the mesh is %g m, front along %.3g %.3g %.3g\n", 100.0 * r->stature, r->unit,
           r->frame[6], r->frame[7], r->frame[8]);
    if (isfinite(r->crotch)) printf("crotch at %.2f cm", 100.0 * r->crotch);
    for (int i = 0; i < 2; i++)
        if (isfinite(r->armpit[i]))
            printf(", %s armpit at %.2f cm, arm %.1f deg down", i == 0 ? "left" : "right", 100.0 * r->armpit[i],
                   DEGREES * r->arm_angle[i]);
    printf("%s%d contours, %d holes closed, %d hollows filled\n", isfinite(r->crotch) ? "\n" : "", (int)r->contours,
           (int)r->holes, (int)r->filled);
    printf("%-7s %10s %12s\n", "girth", "tape", "at");
    for (int g = 0; g < MUS_SCAN_GIRTH_COUNT; g++)
        if (isfinite(r->girth[g]))
            printf("%-7s %7.2f cm %9.2f cm\n", girth_names[g], 100.0 * r->girth[g], 100.0 * r->girth_height[g]);
    printf("%-7s %29s   %s\n", "[mm]", "mesh to body: median 95% most", "body to mesh: median 95% most");
    for (int p = 0; p < MUS_SCAN_PART_COUNT; p++) {
        const double *to = r->mesh_to_body[p], *back = r->body_to_mesh[p];
        if (isfinite(to[0]))
            printf("%-7s %15.2f %6.2f %6.2f   %15.2f %6.2f %6.2f\n", part_names[p], 1000.0 * to[0], 1000.0 * to[1],
                   1000.0 * to[2], 1000.0 * back[0], 1000.0 * back[1], 1000.0 * back[2]);
    }
}


static void numbers(json *j, const char *key, int n, const double *values)
{
    json_open(j, key, '[');
    for (int i = 0; i < n; i++) json_number(j, NULL, values[i]);
    json_close(j, ']');
}


static void mesh_json(const mus_scan_report *r, json *j)
{
    json_number(j, "unit_m", r->unit);
    json_number(j, "stature_m", r->stature);
    json_number(j, "crotch_m", r->crotch);
    numbers(j, "armpit_m", 2, r->armpit);
    numbers(j, "arm_angle", 2, r->arm_angle);
    numbers(j, "frame", 9, r->frame);
    numbers(j, "place_m", 3, r->place);
    json_int(j, "contours", r->contours);
    json_int(j, "holes", r->holes);
    json_number(j, "widest_hole_m", r->widest_hole);
    json_int(j, "filled", r->filled);
    json_number(j, "deepest_fill_m", r->deepest_fill);
    json_open(j, "girths", '{');
    for (int g = 0; g < MUS_SCAN_GIRTH_COUNT; g++) {
        json_open(j, girth_names[g], '{');
        json_number(j, "tape_m", r->girth[g]);
        json_number(j, "at_m", r->girth_height[g]);
        json_close(j, '}');
    }
    json_close(j, '}');
    json_open(j, "distances_m", '{');
    for (int p = 0; p < MUS_SCAN_PART_COUNT; p++) {
        json_open(j, part_names[p], '{');
        numbers(j, "mesh_to_body", 3, r->mesh_to_body[p]);
        numbers(j, "body_to_mesh", 3, r->body_to_mesh[p]);
        json_close(j, '}');
    }
    json_close(j, '}');
}


static int mesh_tell(const mus_body *body, const mus_scan_report *report, double spent,
                     const surface_files *files, bool as_json)
{
    int code = EXIT_DONE;
    json j = {0};
    if (as_json) {
        json_open(&j, NULL, '{');
        mesh_json(report, &j);
        json_number(&j, "volume_m3", mus_body_volume(body));
        json_number(&j, "seconds", spent);
        json_warnings(&j);
        json_close(&j, '}');
        if (!json_write(&j, "body", "-")) code = EXIT_FAILED;
    } else if (!is_stdout(files->obj) && !is_stdout(files->glb) && !is_stdout(files->png)) {
        mesh_table(report);
        printf("volume %.1f l, %.1f ms\n", 1000.0 * mus_body_volume(body), 1000.0 * spent);
    }
    json_free(&j);
    return code;
}


int mesh_command(const mesh_source *from, const stance *how, const surface_files *files, bool as_json)
{
    scene s;
    mus_body *body = NULL;
    mus_scan_report report;
    mus_scan_report_init(&report, sizeof report);
    int code = scene_open(&s, "body");
    const double start = seconds();
    if (code == EXIT_DONE) code = mesh_body(&s, from, &report, &body);
    const double spent = seconds() - start;
    if (code == EXIT_DONE) {
        const mus_status status = stance_take(&s, how, &body);
        if (status != MUS_OK) code = scene_fail(&s, status);
    }
    if (code == EXIT_DONE) code = surface_write(&s, files, body);
    if (code == EXIT_DONE) code = mesh_tell(body, &report, spent, files, as_json);
    mus_body_destroy(body);
    scene_close(&s);
    return code;
}
