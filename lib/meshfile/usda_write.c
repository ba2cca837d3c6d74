/*
 * usda_write.c: write meshes as Universal Scene Description in text (.usda): metres, Y up, one Xform over all.
 *
 *     def Xform "muslin" { def Mesh "body" {...}  def Xform "garment" { def Mesh "front" ... def BasisCurves "seams" }
 *                          def Scope "materials" { def Material "front" ... } }
 *
 * Names become identifiers: other bytes become "_", and a name that its parent has already gets a number. Texture
 * coordinates are primvars:st, of a cloth the packed islands, and primvars:st1, the flat panels in metres. A mesh in
 * motion has time samples of its points and normals; the codes are frames of the mean rate of the keys.
 * Source: Pixar, Universal Scene Description, schemas UsdGeom and UsdShade, 2016.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "meshfile/mesh_file.h"

#define USDA_NAME 200 /* [bytes] of an identifier; chosen: above the 128 of a panel's name and its number */


/* make an identifier of a name; `number` stands behind it unless it is 0 */
static void usda_name(const char *name, int32_t number, char *out, size_t bytes)
{
    size_t n = 0;
    if (name == NULL || name[0] == '\0') name = "mesh";
    if (isdigit((unsigned char)name[0])) out[n++] = '_';
    for (; *name != '\0' && n + 16 < bytes; name++)
        out[n++] = (unsigned char)*name < 0x80 && isalnum((unsigned char)*name) ? *name : '_';
    snprintf(out + n, bytes - n, number > 0 ? "_%d" : "%.0d", (int)number);
}


/* the identifier of part `index` of a mesh: one that no part before it has, nor the seams */
static void usda_part(const mus__mesh_parts *mesh, int32_t index, char *out)
{
    char other[USDA_NAME];
    usda_name(mesh->part[index].name, 0, out, USDA_NAME);
    bool taken = strcmp(out, "seams") == 0;
    for (int32_t p = 0; p < index && !taken; p++) {
        usda_name(mesh->part[p].name, 0, other, sizeof other);
        taken = strcmp(out, other) == 0;
    }
    if (taken) usda_name(mesh->part[index].name, index + 1, out, USDA_NAME);
}


/* the identifier of a mesh: one that no mesh before it has, nor the materials */
static void usda_mesh(const mus__mesh_set *set, int32_t index, char *out)
{
    char other[USDA_NAME];
    usda_name(set->mesh[index].view->name, 0, out, USDA_NAME);
    bool taken = strcmp(out, "materials") == 0;
    for (int32_t i = 0; i < index && !taken; i++) {
        usda_name(set->mesh[i].view->name, 0, other, sizeof other);
        taken = strcmp(out, other) == 0;
    }
    if (taken) usda_name(set->mesh[index].view->name, index + 1, out, USDA_NAME);
}


/* n rows of `width` numbers as a list of tuples */
static void put_tuples(mus__sink *sink, int64_t n, int32_t width, const double *values)
{
    mus__sink_print(sink, "[");
    for (int64_t i = 0; i < n; i++) {
        const double *row = values + i * width;
        const char *comma = i > 0 ? ", " : "";
        if (width == 3) mus__sink_print(sink, "%s(%.9g, %.9g, %.9g)", comma, row[0], row[1], row[2]);
        else mus__sink_print(sink, "%s(%.9g, %.9g)", comma, row[0], row[1]);
    }
    mus__sink_print(sink, "]");
}


/* the low and high corner of n points */
static void put_extent(mus__sink *sink, int32_t n, const double *points)
{
    double box[6] = {INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY};
    for (ptrdiff_t i = 0; i < 3 * (ptrdiff_t)n; i++) {
        box[i % 3] = fmin(box[i % 3], points[i]);
        box[3 + i % 3] = fmax(box[3 + i % 3], points[i]);
    }
    put_tuples(sink, 2, 3, box);
}


/* frames a second: the mean rate of the keys */
static double usda_rate(const mus__mesh_set *set)
{
    return set->keys > 1 ? (set->keys - 1) / (set->times[set->keys - 1] - set->times[0]) : 1.0;
}


/* an attribute of a part at rest, or its samples: rows of 3 of arrays of `total` vertices; with `box` their corners */
static void put_samples(mus__sink *sink, const mus__mesh_set *set, const char *what, const double *rest,
                        const double *moved, int32_t total, const mus__mesh_part *part, bool box)
{
    const ptrdiff_t first = 3 * (ptrdiff_t)part->first_vertex;
    const bool moves = moved != NULL;
    mus__sink_print(sink, "            %s%s = %s", what, moves ? ".timeSamples" : "", moves ? "{\n" : "");
    for (int32_t k = 0; k < (moves ? set->keys : 1); k++) {
        const double *x = (moves ? moved + 3 * (ptrdiff_t)k * total : rest) + first;
        if (moves) mus__sink_print(sink, "                %.9g: ", set->times[k] * usda_rate(set));
        if (box) put_extent(sink, part->vertices, x);
        else put_tuples(sink, part->vertices, 3, x);
        if (moves) mus__sink_print(sink, ",\n");
    }
    mus__sink_print(sink, moves ? "            }" : "");
}


/* points, their box, and with `lit` normals */
static void put_points(mus__sink *sink, const mus__mesh_set *set, const mus__mesh_parts *mesh,
                       const mus__mesh_part *part, bool lit)
{
    const mus_mesh_view *view = mesh->view;
    const double *moved = mesh->motion != NULL ? mesh->motion->positions : NULL;
    const double *turned = mesh->motion != NULL ? mesh->motion->normals : NULL;
    put_samples(sink, set, "float3[] extent", view->positions, moved, view->vertex_count, part, true);
    mus__sink_print(sink, "\n");
    put_samples(sink, set, "point3f[] points", view->positions, moved, view->vertex_count, part, false);
    mus__sink_print(sink, "\n");
    if (!lit || view->normals == NULL) return;
    mus__sink_print(sink, "            normal3f[] normals (interpolation = \"vertex\")\n");
    put_samples(sink, set, "normal3f[] normals", view->normals, turned, view->vertex_count, part, false);
    mus__sink_print(sink, "\n");
}


static void put_uv(mus__sink *sink, const char *name, const mus__mesh_part *part, const double *uv)
{
    if (uv == NULL) return;
    mus__sink_print(sink, "            texCoord2f[] primvars:%s = ", name);
    put_tuples(sink, part->vertices, 2, uv + 2 * (ptrdiff_t)part->first_vertex);
    mus__sink_print(sink, " (interpolation = \"vertex\")\n");
}


static void put_part(mus__sink *sink, const mus__mesh_set *set, const mus__mesh_parts *mesh, int32_t index,
                     const char *name, const char *material)
{
    const mus__mesh_part *part = &mesh->part[index];
    const mus_mesh_view *view = mesh->view;
    mus__sink_print(sink, "        def Mesh \"%s\" (prepend apiSchemas = [\"MaterialBindingAPI\"])\n        {\n", name);
    mus__sink_print(sink, "            uniform token subdivisionScheme = \"none\"\n");
    mus__sink_print(sink, "            uniform bool doubleSided = %d\n", view->two_sided != 0);
    mus__sink_print(sink, "            rel material:binding = </muslin/materials/%s>\n", material);
    put_points(sink, set, mesh, part, true);
    put_uv(sink, "st", part, mus__mesh_uv(mesh));
    put_uv(sink, "st1", part, mesh->islands != NULL ? view->texcoords : NULL);
    mus__sink_print(sink, "            int[] faceVertexCounts = [");
    for (int32_t i = 0; i < part->triangles; i++) mus__sink_print(sink, i > 0 ? ", 3" : "3");
    mus__sink_print(sink, "]\n            int[] faceVertexIndices = [");
    const size_t first = 3 * (size_t)part->first_triangle;
    for (size_t i = 0; i < 3 * (size_t)part->triangles; i++)
        mus__sink_print(sink, "%s%d", i > 0 ? ", " : "", (int)(view->triangles[first + i] - part->first_vertex));
    mus__sink_print(sink, "]\n        }\n");
}


/* the seams as linear curves, each along runs of lines that follow each other */
static void put_seams(mus__sink *sink, const mus__mesh_set *set, const mus__mesh_parts *mesh)
{
    const double *moved = mesh->motion != NULL ? mesh->motion->positions : NULL;
    const size_t n = (size_t)mesh->nline;
    mus__sink_print(sink, "        def BasisCurves \"seams\"\n        {\n            uniform token type = \"linear\"\n"
                    "            float[] widths = [0.001] (interpolation = \"constant\")\n"
                    "            int[] curveVertexCounts = [");
    for (size_t i = 0, run = 2; i < n; i++, run++) {
        const bool last = i + 1 == n || mesh->lines[2 * i + 1] != mesh->lines[2 * i + 2];
        if (last) mus__sink_print(sink, "%zu%s", run, i + 1 == n ? "" : ", ");
        if (last) run = 1;
    }
    mus__sink_print(sink, "]\n            point3f[] points%s = %s", moved != NULL ? ".timeSamples" : "",
                    moved != NULL ? "{\n" : "");
    for (int32_t k = 0; k < (moved != NULL ? set->keys : 1); k++) {
        const double *x = moved != NULL ? moved + 3 * (ptrdiff_t)k * mesh->view->vertex_count : mesh->view->positions;
        if (moved != NULL) mus__sink_print(sink, "                %.9g: ", set->times[k] * usda_rate(set));
        mus__sink_print(sink, "[");
        for (size_t i = 0; i < n; i++)
            for (size_t end = i == 0 || mesh->lines[2 * i - 1] != mesh->lines[2 * i] ? 0 : 1; end < 2; end++) {
                const double *p = x + 3 * (ptrdiff_t)mesh->lines[2 * i + end];
                mus__sink_print(sink, "%s(%.9g, %.9g, %.9g)", i + end > 0 ? ", " : "", p[0], p[1], p[2]);
            }
        mus__sink_print(sink, "]%s", moved != NULL ? ",\n" : "");
    }
    mus__sink_print(sink, "%s\n", moved != NULL ? "            }" : "");
    const mus__mesh_part whole = {NULL, 0, mesh->view->vertex_count, 0, 0};
    put_samples(sink, set, "float3[] extent", mesh->view->positions, moved, mesh->view->vertex_count, &whole, true);
    mus__sink_print(sink, "\n        }\n");
}


/* a material for each part, by the identifier of mesh and part */
static void put_materials(mus__sink *sink, const mus__mesh_set *set)
{
    char mesh[USDA_NAME], part[USDA_NAME], name[256], material[USDA_NAME + 256];
    mus__sink_print(sink, "    def Scope \"materials\"\n    {\n");
    for (int32_t i = 0; i < set->n; i++) {
        const double *colour = set->mesh[i].view->colour;
        usda_mesh(set, i, mesh);
        for (int32_t p = 0; p < set->mesh[i].count; p++) {
            usda_part(&set->mesh[i], p, part);
            snprintf(material, sizeof material, "%s_%s", mesh, part);
            mus__mesh_material(&set->mesh[i], p, name, sizeof name);
            mus__sink_print(sink, "        def Material \"%s\" (displayName = ", material);
            mus__sink_quote(sink, name);
            mus__sink_print(sink, ")\n        {\n            token outputs:surface.connect = "
                            "</muslin/materials/%s/shader.outputs:surface>\n            def Shader \"shader\"\n"
                            "            {\n                uniform token info:id = \"UsdPreviewSurface\"\n"
                            "                color3f inputs:diffuseColor = (%.9g, %.9g, %.9g)\n"
                            "                float inputs:opacity = %.9g\n"
                            "                float inputs:roughness = 0.9\n"
                            "                token outputs:surface\n            }\n        }\n", material, colour[0],
                            colour[1], colour[2], colour[3]);
        }
    }
    mus__sink_print(sink, "    }\n");
}


void mus__usda_put(mus__sink *sink, const mus__mesh_set *set)
{
    char name[USDA_NAME], part[USDA_NAME], material[2 * USDA_NAME];
    mus__sink_print(sink, "#usda 1.0\n(\n    defaultPrim = \"muslin\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n");
    if (set->keys > 0)
        mus__sink_print(sink, "    startTimeCode = %.9g\n    endTimeCode = %.9g\n    timeCodesPerSecond = %.9g\n"
                        "    framesPerSecond = %.9g\n", set->times[0] * usda_rate(set),
                        set->times[set->keys - 1] * usda_rate(set), usda_rate(set), usda_rate(set));
    mus__sink_print(sink, ")\n\ndef Xform \"muslin\" (kind = \"component\")\n{\n");
    for (int32_t i = 0; i < set->n && sink->status == MUS_OK; i++) {
        const mus__mesh_parts *mesh = &set->mesh[i];
        usda_mesh(set, i, name);
        if (mesh->cloth != NULL) mus__sink_print(sink, "    def Xform \"%s\"\n    {\n", name);
        for (int32_t p = 0; p < mesh->count; p++) {
            usda_part(mesh, p, part);
            snprintf(material, sizeof material, "%s_%s", name, part);
            put_part(sink, set, mesh, p, mesh->cloth != NULL ? part : name, material);
        }
        if (mesh->nline > 0) put_seams(sink, set, mesh);
        if (mesh->cloth != NULL) mus__sink_print(sink, "    }\n");
    }
    put_materials(sink, set);
    mus__sink_print(sink, "}\n");
}
