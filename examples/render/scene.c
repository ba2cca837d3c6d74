/*
 * scene.c: from the caller's meshes to parts in OpenGL.
 *
 * Each mesh is checked (finite numbers, indices in range), given normals if it has none, and copied into one
 * interleaved buffer. The floor is a part too: a disc of rings, dense near the middle, since its shadow is computed
 * at its vertices. It fades out towards its rim.
 */
#include "render_internal.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* more would not fit the index type of a vertex count times 3 */
#define VERTICES_MAX 50000000

/* rings and rays of the floor: 10 mm apart near the feet of an adult, which is finer than its softest shadow */
#define FLOOR_RINGS 88
#define FLOOR_RAYS 144

#define PI 3.14159265358979323846


static int scene_check_array(int32_t mesh, const char *what, int32_t n, int32_t width, const double *a,
                             render_error *error)
{
    for (int64_t i = 0; a && i < (int64_t)n * width; i++)
        if (!(fabs(a[i]) <= 1e6))
            return render_fail(error, "mesh %d: %s of vertex %lld is %g, the limit is 1e6", (int)mesh, what,
                               (long long)(i / width), a[i]);
    return 0;
}


/* lines of seams and stitches, and the panels of the vertices that they need */
static int scene_check_lines(const render_mesh *m, int32_t mesh, render_error *error)
{
    if (!m->texcoords || !m->panels || !m->lines)
        return render_fail(error, "mesh %d: lines need texture coordinates and panels", (int)mesh);
    for (int32_t i = 0; i < m->vertex_count; i++)
        if (m->panels[i] < 0 || m->panels[i] >= m->vertex_count)
            return render_fail(error, "mesh %d: vertex %d is of panel %d, expected 0 to %d", (int)mesh, (int)i,
                               (int)m->panels[i], (int)m->vertex_count - 1);
    for (int32_t i = 0; i < m->line_count; i++) {
        const render_line *line = &m->lines[i];
        if (line->kind < RENDER_LINE_SEAM || line->kind > RENDER_LINE_EDGE || line->count < 2 ||
            !(line->offset >= 0.0 && line->offset <= 1.0))
            return render_fail(error, "mesh %d: line %d of kind %d, %d points, offset %g m", (int)mesh, (int)i,
                               (int)line->kind, (int)line->count, line->offset);
        if (scene_check_array(mesh, "point of a line", line->count, 2, line->points, error)) return -1;
    }
    return 0;
}


static int scene_check_mesh(const render_mesh *m, int32_t mesh, render_error *error)
{
    if (m->kind != RENDER_BODY && m->kind != RENDER_CLOTH && m->kind != RENDER_TRIM)
        return render_fail(error, "mesh %d: kind %d is unknown", (int)mesh, (int)m->kind);
    if (m->vertex_count < 3 || m->vertex_count > VERTICES_MAX || !m->positions)
        return render_fail(error, "mesh %d: %d vertices, expected 3 to %d", (int)mesh, (int)m->vertex_count,
                           VERTICES_MAX);
    if (m->triangle_count < 1 || m->triangle_count > VERTICES_MAX || !m->triangles)
        return render_fail(error, "mesh %d: %d triangles, expected 1 to %d", (int)mesh, (int)m->triangle_count,
                           VERTICES_MAX);
    for (int32_t i = 0; i < 3 * m->triangle_count; i++)
        if (m->triangles[i] < 0 || m->triangles[i] >= m->vertex_count)
            return render_fail(error, "mesh %d: triangle %d names vertex %d of %d", (int)mesh, (int)(i / 3),
                               (int)m->triangles[i], (int)m->vertex_count);
    if (m->print && (!m->texcoords || !m->print->rgba || !(m->print_width >= 1e-4 && m->print_width <= 100.0)))
        return render_fail(error, "mesh %d: a print needs texture coordinates and a width of 0.0001 to 100 m, not %g",
                           (int)mesh, m->print_width);
    if (m->line_count > 0 && scene_check_lines(m, mesh, error)) return -1;
    if (scene_check_array(mesh, "position", m->vertex_count, 3, m->positions, error) ||
        scene_check_array(mesh, "normal", m->vertex_count, 3, m->normals, error) ||
        scene_check_array(mesh, "texture coordinate", m->vertex_count, 2, m->texcoords, error) ||
        scene_check_array(mesh, "colour", m->vertex_count, 3, m->colours, error) ||
        scene_check_array(mesh, "colour", 1, 3, m->colour, error))
        return -1;
    return 0;
}


/* box that is asked for, or round all meshes, and the widest reach from the upright axis through its middle */
static void scene_bounds(render *r, const render_scene *scene)
{
    if (scene->frame != NULL) {
        for (int k = 0; k < 3; k++) {
            r->low[k] = scene->frame[k];
            r->high[k] = scene->frame[k + 3];
            r->focus[k] = r->centre[k] = 0.5 * (r->low[k] + r->high[k]);
        }
        r->radius = fmax(r->high[0] - r->centre[0], r->high[2] - r->centre[2]);
        return;
    }
    for (int k = 0; k < 3; k++) {
        r->low[k] = 1e30;
        r->high[k] = -1e30;
    }
    for (int32_t i = 0; i < scene->mesh_count; i++)
        for (int32_t j = 0; j < 3 * scene->meshes[i].vertex_count; j++) {
            r->low[j % 3] = fmin(r->low[j % 3], scene->meshes[i].positions[j]);
            r->high[j % 3] = fmax(r->high[j % 3], scene->meshes[i].positions[j]);
        }
    for (int k = 0; k < 3; k++) r->focus[k] = r->centre[k] = 0.5 * (r->low[k] + r->high[k]);

    double low[3] = {1e30, 1e30, 1e30}, high[3] = {-1e30, -1e30, -1e30};
    for (int32_t i = 0; i < scene->mesh_count; i++)
        for (int32_t j = 0; j < 3 * scene->meshes[i].vertex_count && scene->meshes[i].kind == RENDER_CLOTH; j++) {
            low[j % 3] = fmin(low[j % 3], scene->meshes[i].positions[j]);
            high[j % 3] = fmax(high[j % 3], scene->meshes[i].positions[j]);
        }
    for (int k = 0; k < 3 && low[0] <= high[0]; k++) r->focus[k] = 0.5 * (low[k] + high[k]);

    r->radius = 0.01;
    for (int32_t i = 0; i < scene->mesh_count; i++)
        for (int32_t j = 0; j < scene->meshes[i].vertex_count; j++) {
            const double *p = scene->meshes[i].positions + 3 * (ptrdiff_t)j;
            r->radius = fmax(r->radius, hypot(p[0] - r->centre[0], p[2] - r->centre[2]));
        }
}


static int part_allocate(render_part *part, int32_t vertex_count, int32_t index_count, render_error *error)
{
    part->vertex_count = vertex_count;
    part->index_count = index_count;
    part->v = calloc((size_t)vertex_count, sizeof *part->v);
    part->triangles = malloc((size_t)index_count * sizeof *part->triangles);
    if (!part->v || !part->triangles) return render_fail(error, "no picture: out of memory for %d vertices",
                                                         (int)vertex_count);
    return 0;
}


/*
 * Whether triangles enclose a volume and wind outwards: their area vectors (b - a) x (c - a) then sum to zero, and the
 * sum of a . n, six times the volume, is positive.
 */
static int part_closed(const render_mesh *m)
{
    double sum[3] = {0, 0, 0}, area = 0, volume = 0;

    for (int32_t i = 0; i < m->triangle_count; i++) {
        const int32_t *t = m->triangles + 3 * (ptrdiff_t)i;
        const double *a = m->positions + 3 * (ptrdiff_t)t[0], *b = m->positions + 3 * (ptrdiff_t)t[1];
        const double *c = m->positions + 3 * (ptrdiff_t)t[2];
        double u[3], v[3], n[3];

        for (int k = 0; k < 3; k++) {
            u[k] = b[k] - a[k];
            v[k] = c[k] - a[k];
        }
        render_cross(n, u, v);
        area += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++) {
            sum[k] += n[k];
            volume += a[k] * n[k];
        }
    }
    area *= 1e-4;
    return m->kind == RENDER_BODY && volume > 0 && sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] < area * area;
}


static int part_fill(render_part *part, const render_mesh *m, render_error *error)
{
    double *made = NULL;
    const double *normals = m->normals;

    if (part_allocate(part, m->vertex_count, 3 * m->triangle_count, error)) return -1;
    if (!normals) {
        normals = made = malloc(3 * (size_t)m->vertex_count * sizeof *made);
        if (!made || render_normals(m->vertex_count, m->positions, m->triangle_count, m->triangles, made)) {
            free(made);
            return render_fail(error, "no picture: out of memory for %d normals", (int)m->vertex_count);
        }
    }
    for (int32_t i = 0; i < m->vertex_count; i++) {
        render_vertex *v = &part->v[i];
        for (int k = 0; k < 3; k++) {
            v->position[k] = (float)m->positions[3 * i + k];
            v->normal[k] = (float)normals[3 * i + k];
            v->colour[k] = (float)(m->colours ? m->colours[3 * i + k] : m->colour[k]);
        }
        for (int k = 0; k < 2; k++) v->texcoord[k] = m->texcoords ? (float)m->texcoords[2 * i + k] : 0.0f;
        v->open[0] = v->open[1] = 1.0f;
    }
    memcpy(part->triangles, m->triangles, (size_t)part->index_count * sizeof *part->triangles);
    part->kind = m->kind;
    part->has_texcoords = m->texcoords != NULL;
    part->closed = part_closed(m);
    free(made);
    return 0;
}


/* rings at radii that grow as t^1.5, joined by quads; ring 0 is the middle */
static int part_floor(render_part *part, const render *r, render_error *error)
{
    double reach = r->radius + 0.85 * (r->high[1] - r->low[1]);
    int32_t at = 0;

    if (part_allocate(part, FLOOR_RINGS * FLOOR_RAYS, 6 * (FLOOR_RINGS - 1) * FLOOR_RAYS, error)) return -1;
    part->kind = RENDER_FLOOR;
    for (int32_t i = 0; i < FLOOR_RINGS; i++)
        for (int32_t j = 0; j < FLOOR_RAYS; j++) {
            double t = (double)i / (FLOOR_RINGS - 1), d = reach * t * sqrt(t), angle = 2 * PI * j / FLOOR_RAYS;
            double fade = 1.0 - d / reach;
            render_vertex *v = &part->v[i * FLOOR_RAYS + j];
            v->position[0] = (float)(r->centre[0] + d * sin(angle));
            v->position[1] = (float)r->low[1];
            v->position[2] = (float)(r->centre[2] + d * cos(angle));
            v->normal[1] = 1.0f;
            v->open[0] = 1.0f;
            v->open[1] = (float)(fade * fade * (3.0 - 2.0 * fade));
        }
    for (int32_t i = 0; i + 1 < FLOOR_RINGS; i++)
        for (int32_t j = 0; j < FLOOR_RAYS; j++) {
            int32_t k = (j + 1) % FLOOR_RAYS, a = i * FLOOR_RAYS + j, b = a + FLOOR_RAYS;
            int32_t c = (i + 1) * FLOOR_RAYS + k, d = i * FLOOR_RAYS + k;
            int32_t quad[6] = {a, b, c, a, c, d};
            memcpy(part->triangles + at, quad, sizeof quad);
            at += 6;
        }
    return 0;
}


/* a picture as a repeating texture: the last row is the start of the warp */
static int part_print(render *r, render_part *part, const render_mesh *m, render_error *error)
{
    const render_gl *gl = &r->gl;
    size_t row = 4 * (size_t)m->print->width;
    unsigned char *turned = malloc(row * (size_t)m->print->height);

    if (!turned) return render_fail(error, "no picture: out of memory for a print");
    for (int32_t y = 0; y < m->print->height; y++)
        memcpy(turned + row * (size_t)y, m->print->rgba + row * (size_t)(m->print->height - 1 - y), row);

    gl->GenTextures(1, &part->print);
    gl->BindTexture(GL_TEXTURE_2D, part->print);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, m->print->width, m->print->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   turned);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    gl->GenerateMipmap(GL_TEXTURE_2D);
    free(turned);

    part->repeats[0] = (float)(1.0 / m->print_width);
    part->repeats[1] = (float)((double)m->print->width / (double)m->print->height / m->print_width);
    return 0;
}


/* attribute numbers are those of the shaders */
static void part_upload(render *r, render_part *part)
{
    static const struct {
        GLint width;
        size_t offset;
    } layout[6] = {{3, offsetof(render_vertex, position)},
                   {3, offsetof(render_vertex, normal)},
                   {2, offsetof(render_vertex, texcoord)},
                   {3, offsetof(render_vertex, colour)},
                   {2, offsetof(render_vertex, open)},
                   {2, offsetof(render_vertex, thread)}};
    const render_gl *gl = &r->gl;

    gl->GenVertexArrays(1, &part->array);
    gl->BindVertexArray(part->array);
    gl->GenBuffers(1, &part->vertices);
    gl->BindBuffer(GL_ARRAY_BUFFER, part->vertices);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)part->vertex_count * sizeof *part->v), part->v,
                   GL_STATIC_DRAW);
    for (GLuint i = 0; i < 6; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, layout[i].width, GL_FLOAT, GL_FALSE, (GLsizei)sizeof(render_vertex),
                                (const void *)(uintptr_t)layout[i].offset);
    }
    gl->GenBuffers(1, &part->indices);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, part->indices);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)((size_t)part->index_count * sizeof *part->triangles),
                   part->triangles, GL_STATIC_DRAW);
    gl->BindVertexArray(0);
}


void render_scene_free(render *r)
{
    const render_gl *gl = &r->gl;

    for (int32_t i = 0; i < r->part_count; i++) {
        render_part *part = &r->parts[i];
        if (part->array) gl->DeleteVertexArrays(1, &part->array);
        if (part->vertices) gl->DeleteBuffers(1, &part->vertices);
        if (part->indices) gl->DeleteBuffers(1, &part->indices);
        if (part->print) gl->DeleteTextures(1, &part->print);
        if (part->thread) gl->DeleteTextures(1, &part->thread);
        free(part->v);
        free(part->triangles);
    }
    free(r->parts);
    r->parts = NULL;
    r->part_count = 0;
}


static int scene_build(render *r, const render_scene *scene, render_error *error)
{
    int32_t count = scene->mesh_count;

    r->parts = calloc((size_t)count + 1, sizeof *r->parts);
    if (!r->parts) return render_fail(error, "no picture: out of memory");
    r->part_count = count + (scene->floor ? 1 : 0);
    for (int32_t i = 0; i < count; i++) {
        if (part_fill(&r->parts[i], &scene->meshes[i], error)) return -1;
        if (scene->meshes[i].print && part_print(r, &r->parts[i], &scene->meshes[i], error)) return -1;
        if (scene->meshes[i].line_count > 0 && render_thread_make(r, &scene->meshes[i], &r->parts[i], error)) return -1;
    }
    if (scene->floor && part_floor(&r->parts[count], r, error)) return -1;

    /* the depth maps of the occlusion are drawn from the parts, and its result goes up with them once more */
    for (int32_t i = 0; i < r->part_count; i++) part_upload(r, &r->parts[i]);
    if (render_occlusion(r, error)) return -1;
    for (int32_t i = 0; i < r->part_count; i++) {
        r->gl.BindBuffer(GL_ARRAY_BUFFER, r->parts[i].vertices);
        r->gl.BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)r->parts[i].vertex_count * sizeof *r->parts[i].v),
                         r->parts[i].v, GL_STATIC_DRAW);
    }
    if (r->gl.GetError() != GL_NO_ERROR) return render_fail(error, "no picture: the driver has no room for the scene");
    return 0;
}


int render_load(render *r, const render_scene *scene, render_error *error)
{
    if (render_egl_enter(r->egl, error)) return -1;
    render_scene_free(r);
    if (scene->mesh_count < 1 || scene->mesh_count > 4096 || !scene->meshes)
        return render_fail(error, "scene: %d meshes, expected 1 to 4096", (int)scene->mesh_count);
    for (int32_t i = 0; i < scene->mesh_count; i++)
        if (scene_check_mesh(&scene->meshes[i], i, error)) return -1;
    scene_bounds(r, scene);
    if (!scene_build(r, scene, error)) return 0;
    render_scene_free(r);
    return -1;
}
