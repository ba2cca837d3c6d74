/*
 * obj.c: triangle meshes from Wavefront OBJ files.
 *
 * Read: v, vt, vn, f with any of the forms a, a/b, a//c, a/b/c and negative (backward) indices; polygons become fans;
 * all other lines are skipped. A corner of a face names a place, a texture coordinate and a normal of its own, while
 * a mesh has one list of vertices: equal corners are found by a hash table and become one vertex. Memory is bounded
 * by the size of the file.
 */
#include "parse.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* larger files are refused [bytes] */
#define FILE_MAX (256l << 20)

#define CORNERS_MAX 256

/* a list that grows by doubling; `width` values an entry */
typedef struct obj_list {
    double *a;
    int32_t count;
    int32_t room;
    int32_t width;
} obj_list;

typedef struct obj_reader {
    const char *path;
    int32_t line;
    obj_list v, vt, vn;
    int32_t *corners; /* (corner_count x 3): place, texture coordinate or -1, normal or -1 */
    int32_t corner_count;
    int32_t corner_room;
    render_error *error;
} obj_reader;


static int obj_fail(obj_reader *r, const char *what)
{
    return render_fail(r->error, "%s:%d: %s", r->path, (int)r->line, what);
}


/* the whole file with a zero at the end */
static char *obj_slurp(const char *path, render_error *error)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    long size = 0;

    if (!file || fseek(file, 0, SEEK_END) || (size = ftell(file)) < 0 || fseek(file, 0, SEEK_SET)) {
        render_fail(error, "%s: cannot be read: %s", path, strerror(errno));
    } else if (size > FILE_MAX) {
        render_fail(error, "%s: %ld bytes, at most %ld are taken", path, size, FILE_MAX);
    } else if (!(text = malloc((size_t)size + 1))) {
        render_fail(error, "%s: out of memory for %ld bytes", path, size);
    } else if (fread(text, 1, (size_t)size, file) != (size_t)size) {
        render_fail(error, "%s: cannot be read: %s", path, strerror(errno));
        free(text);
        text = NULL;
    } else {
        text[size] = '\0';
        if (memchr(text, '\0', (size_t)size)) {
            render_fail(error, "%s: not an OBJ file: it holds a zero byte", path);
            free(text);
            text = NULL;
        }
    }
    if (file) fclose(file);
    return text;
}


static const char *obj_blank(const char *at)
{
    while (*at == ' ' || *at == '\t' || *at == '\r') at++;
    return at;
}


static int obj_end(const char *at)
{
    at = obj_blank(at);
    return *at == '\0' || *at == '\n' || *at == '#';
}


/* the numbers of a v, vt or vn line; what stands after them (a weight, a colour) is left */
static int obj_numbers(obj_reader *r, obj_list *list, const char *at)
{
    if (list->count == list->room) {
        int32_t room = list->room ? 2 * list->room : 1024;
        double *a = realloc(list->a, (size_t)room * (size_t)list->width * sizeof *a);
        if (!a) return obj_fail(r, "out of memory");
        list->a = a;
        list->room = room;
    }
    for (int k = 0; k < list->width; k++) {
        double x;
        at = obj_blank(at);
        at = render_number_parse(at, &x);
        if (!at || (*at != ' ' && *at != '\t' && *at != '\r' && *at != '\n' && *at != '\0'))
            return obj_fail(r, list->width == 2 ? "expected two numbers with a decimal point"
                                                : "expected three numbers with a decimal point");
        if (!(x <= 1e6 && x >= -1e6)) return obj_fail(r, "a number is above 1e6");
        list->a[(ptrdiff_t)list->count * list->width + k] = x;
    }
    list->count++;
    return 0;
}


/* one index: from 1, or back from the end; NULL if it is none or out of range */
static const char *obj_index(const char *at, int32_t count, int32_t *out)
{
    int negative = *at == '-';
    int64_t i = 0;

    at += negative;
    if (*at < '0' || *at > '9') return NULL;
    for (; *at >= '0' && *at <= '9'; at++)
        if (i < INT32_MAX) i = 10 * i + (*at - '0');
    i = negative ? count - i : i - 1;
    *out = (int32_t)i;
    return i >= 0 && i < count ? at : NULL;
}


/* a, a/b, a//c or a/b/c */
static const char *obj_corner(const obj_reader *r, const char *at, int32_t *corner)
{
    corner[1] = corner[2] = -1;
    at = obj_index(at, r->v.count, &corner[0]);
    if (at && *at == '/') {
        at++;
        if (*at != '/') at = obj_index(at, r->vt.count, &corner[1]);
        if (at && *at == '/') at = obj_index(at + 1, r->vn.count, &corner[2]);
    }
    return at && (obj_end(at) || *at == ' ' || *at == '\t') ? at : NULL;
}


static int obj_triangle(obj_reader *r, const int32_t *a, const int32_t *b, const int32_t *c)
{
    if (r->corner_count + 3 > r->corner_room) {
        int32_t room = r->corner_room ? 2 * r->corner_room : 3072;
        int32_t *list = realloc(r->corners, 3 * (size_t)room * sizeof *list);
        if (!list) return obj_fail(r, "out of memory");
        r->corners = list;
        r->corner_room = room;
    }
    memcpy(r->corners + 3 * (ptrdiff_t)r->corner_count, a, 3 * sizeof *a);
    memcpy(r->corners + 3 * (ptrdiff_t)r->corner_count + 3, b, 3 * sizeof *b);
    memcpy(r->corners + 3 * (ptrdiff_t)r->corner_count + 6, c, 3 * sizeof *c);
    r->corner_count += 3;
    return 0;
}


static int obj_face(obj_reader *r, const char *at)
{
    int32_t corners[3 * CORNERS_MAX];
    int32_t n = 0;

    for (at = obj_blank(at); !obj_end(at); at = obj_blank(at)) {
        if (n == CORNERS_MAX) return obj_fail(r, "a face has more than 256 corners");
        at = obj_corner(r, at, corners + 3 * n);
        if (!at) return obj_fail(r, "a face names a vertex that is not there, or is not of the form v/vt/vn");
        n++;
    }
    if (n < 3) return obj_fail(r, "a face needs three corners");
    for (int32_t i = 1; i + 1 < n; i++)
        if (obj_triangle(r, corners, corners + 3 * i, corners + 3 * i + 3)) return -1;
    return 0;
}


static int obj_lines(obj_reader *r, const char *text)
{
    for (const char *at = text; at; at = strchr(at, '\n')) {
        int rc = 0;

        if (*at == '\n') at++;
        r->line++;
        at = obj_blank(at);
        if (at[0] == 'v' && (at[1] == ' ' || at[1] == '\t')) rc = obj_numbers(r, &r->v, at + 1);
        else if (!strncmp(at, "vt", 2) && (at[2] == ' ' || at[2] == '\t')) rc = obj_numbers(r, &r->vt, at + 2);
        else if (!strncmp(at, "vn", 2) && (at[2] == ' ' || at[2] == '\t')) rc = obj_numbers(r, &r->vn, at + 2);
        else if (at[0] == 'f' && (at[1] == ' ' || at[1] == '\t')) rc = obj_face(r, at + 1);
        if (rc) return rc;
    }
    if (r->corner_count < 3) return render_fail(r->error, "%s: no faces (v and f lines were expected)", r->path);
    return 0;
}


/* vertex number of each corner into out->triangles, first[vertex] its first corner; open addressing */
static int obj_join(const obj_reader *r, render_obj *out, int32_t *first, int32_t *table, size_t slots)
{
    int32_t count = 0;

    memset(table, -1, slots * sizeof *table);
    for (int32_t i = 0; i < r->corner_count; i++) {
        const int32_t *c = r->corners + 3 * (ptrdiff_t)i;
        uint64_t hash = (uint64_t)(uint32_t)c[0] * 0x9e3779b97f4a7c15u ^
                        (uint64_t)(uint32_t)c[1] * 0xc2b2ae3d27d4eb4fu ^
                        (uint64_t)(uint32_t)c[2] * 0x165667b19e3779f9u;
        size_t slot = (size_t)(hash ^ hash >> 29) & (slots - 1);
        while (table[slot] >= 0 && memcmp(r->corners + 3 * (ptrdiff_t)first[table[slot]], c, 3 * sizeof *c))
            slot = (slot + 1) & (slots - 1);
        if (table[slot] < 0) {
            table[slot] = count;
            first[count++] = i;
        }
        out->triangles[i] = table[slot];
    }
    out->vertex_count = count;
    out->triangle_count = r->corner_count / 3;
    return 0;
}


/* column `which` of the corners through a list, NULL unless all corners have it */
static int obj_gather(const obj_reader *r, const obj_list *list, int which, const int32_t *first, int32_t n,
                      double **out)
{
    for (int32_t i = 0; i < n; i++)
        if (r->corners[3 * (ptrdiff_t)first[i] + which] < 0) return 0;
    *out = malloc((size_t)n * (size_t)list->width * sizeof **out);
    if (!*out) return -1;
    for (int32_t i = 0; i < n; i++)
        memcpy(*out + (ptrdiff_t)i * list->width,
               list->a + (ptrdiff_t)r->corners[3 * (ptrdiff_t)first[i] + which] * list->width,
               (size_t)list->width * sizeof **out);
    return 0;
}


static int obj_build(obj_reader *r, render_obj *out)
{
    size_t slots = 1024;
    int32_t *first = malloc((size_t)r->corner_count * sizeof *first), *table = NULL;
    int bad = 1;

    while (slots < 2 * (size_t)r->corner_count) slots *= 2;
    table = malloc(slots * sizeof *table);
    out->triangles = malloc((size_t)r->corner_count * sizeof *out->triangles);
    if (first && table && out->triangles) {
        obj_join(r, out, first, table, slots);
        bad = obj_gather(r, &r->v, 0, first, out->vertex_count, &out->positions) ||
              obj_gather(r, &r->vt, 1, first, out->vertex_count, &out->texcoords) ||
              obj_gather(r, &r->vn, 2, first, out->vertex_count, &out->normals);
    }
    free(first);
    free(table);
    return bad ? render_fail(r->error, "%s: out of memory for %d corners", r->path, (int)r->corner_count) : 0;
}


int render_obj_read(const char *path, render_obj *out, render_error *error)
{
    obj_reader r = {.path = path, .v.width = 3, .vt.width = 2, .vn.width = 3, .error = error};
    char *text = obj_slurp(path, error);
    int bad = 1;

    memset(out, 0, sizeof *out);
    if (text) bad = obj_lines(&r, text) || obj_build(&r, out);
    if (bad) render_obj_free(out);
    free(text);
    free(r.v.a);
    free(r.vt.a);
    free(r.vn.a);
    free(r.corners);
    return bad ? -1 : 0;
}


void render_obj_free(render_obj *obj)
{
    free(obj->positions);
    free(obj->normals);
    free(obj->texcoords);
    free(obj->triangles);
    memset(obj, 0, sizeof *obj);
}
